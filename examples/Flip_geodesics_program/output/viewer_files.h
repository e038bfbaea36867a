// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_FILES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_FILES_H

#include "bad_input.h"
#include "output/output_file.h"
#include "output/viewer_curves.h"
#include "run/field_curves.h"
#include "scene.h"

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/IO/PLY.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace program {

/// The surface and the curves in one file for a viewer. Curves are in the order of the results, and so have the numbers
/// that they have there; those without points are left out.
class Viewer_file
{
public:
  /// \param format obj, ply, vtp, glb, or polylines for the curves alone
  /// \param tubes the radius of the tubes that curves are, 0 for lines. Not given, it follows from the mesh; curves of
  /// very many points, as trees have, are lines then.
  Viewer_file(const std::string& name, const std::string& format, std::optional<double> tubes)
    : m_format(format)
    , m_file(name)
    , m_materials(format == "obj" && is_plain_name(name) ? name + ".mtl" : "")
    , m_tubes(tubes)
  {
    if(tubes && m_format == "polylines")
      throw Bad_input("--tubes requires --output with a file .obj, .ply, .vtp or .glb");
  }

  /// \param values of the vertices, for ply and vtp
  void write(const Mesh& mesh, const Scene& scene, const std::optional<Distance_map>& values)
  {
    namespace IO = CGAL::Flip_geodesics::IO;
    m_file.write([&](std::ostream& out) {
      if(m_format == "polylines")
        write_polylines(out, scene);
      else
        with_curves(mesh, scene, m_tubes,
                    IO::Colors(m_materials.name().substr(m_materials.name().find_last_of("/\\") + 1)),
                    [&](const auto&... parts) { values ? write_with(out, *values, parts...) : write(out, parts...); });
    });
    m_file.close();
    if(m_materials.is_wanted())
      m_materials.write([](std::ostream& out) { IO::write_MTL(out); });
    m_materials.close();
  }

private:
  // Text cannot hold that points of curves have no value.
  template <class... Parts>
  void write_with(std::ostream& out, const Distance_map& values, const Parts&... parts) const
  {
    namespace IO = CGAL::Flip_geodesics::IO;
    const auto distance = [&values](Mesh::Vertex_index v) { return values.distances[v]; };
    const auto source = [&values](Mesh::Vertex_index v) {
      return std::isfinite(values.distances[v]) ? static_cast<double>(values.nearest[v])
                                                : std::numeric_limits<double>::quiet_NaN();
    };
    const IO::Vertex_values distances("distance", boost::make_function_property_map<Mesh::Vertex_index>(distance));
    const IO::Vertex_values nearest("source", boost::make_function_property_map<Mesh::Vertex_index>(source));
    if(m_format == "ply")
      IO::write_PLY(out, parts..., distances, nearest);
    else if(m_format == "vtp")
      IO::write_VTP(out, parts..., distances, nearest);
    else
      write(out, parts...);
  }

  template <class... Parts>
  void write(std::ostream& out, const Parts&... parts) const
  {
    namespace IO = CGAL::Flip_geodesics::IO;
    const auto as_text = CGAL::parameters::use_binary_mode(false);
    if(m_format == "obj")
      IO::write_OBJ(out, parts...);
    else if(m_format == "ply")
      IO::write_PLY(out, parts..., as_text);
    else if(m_format == "vtp")
      IO::write_VTP(out, parts..., as_text);
    else
      IO::write_GLB(out, parts...);
  }

  // Is it the name of a file beside which there can be another one?
  static bool is_plain_name(const std::string& name) { return !open_file(name) && !is_special_file(name); }

  std::string m_format;
  Output_file m_file, m_materials;
  std::optional<double> m_tubes;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_FILES_H
