// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_MESH_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_MESH_FILE_H

#include "messages.h"
#include "output/output_file.h"
#include "output/viewer_curves.h"
#include "program_mesh.h"
#include "run/computations.h"
#include "scene.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

namespace program {

/// While it lives, nothing that CGAL's writers say reaches standard error.
class Silent_errors
{
public:
  Silent_errors()
    : m_buffer(std::cerr.rdbuf(nullptr))
  {
  }
  Silent_errors(const Silent_errors&) = delete;
  Silent_errors& operator=(const Silent_errors&) = delete;
  ~Silent_errors() { std::cerr.rdbuf(m_buffer); }

private:
  std::streambuf* m_buffer;
};

/// A mesh in one of the formats off, obj, ply, stl and vtp; with texture coordinates in obj and glb; with curves in obj,
/// ply, vtp and glb, or `polylines` for the curves alone.
class Mesh_file
{
public:
  /// With an empty name, nothing is written. \param has_curves whether curves are written
  Mesh_file(const std::string& name, const std::string& format, bool has_curves = false)
    : m_format(format)
    , m_file(name)
    , m_materials(has_curves && format == "obj" && is_plain_name(name) ? name + ".mtl" : "")
  {
  }

  /// Returns a line for the user if the format cannot store the mesh as it is, and else an empty one.
  std::string remark(const Mesh& mesh) const
  {
    const std::size_t merged = m_file.is_wanted() && m_format == "stl" ? number_of_coincident_vertices(mesh) : 0;
    if(merged == 0)
      return "";
    return name_of_result(m_file.name()) + ": " +
           counted(merged, "vertex coincides with another one", "vertices coincide with others") +
           "; readers of STL, which does not store shared vertices, merge them and thereby close cuts; use an .off, "
           ".obj or .ply file";
  }

  void write(const Mesh& mesh)
  {
    const Silent_errors silent; // what goes wrong is seen by the state of the file
    m_file.write([&](std::ostream& out) { write(out, mesh); });
    m_file.close();
  }

  /// Writes a mesh with its texture coordinates.
  void write_textured(Mesh mesh)
  {
    namespace IO = CGAL::Flip_geodesics::IO;
    const IO::Texture texture(texture_of(mesh));
    m_file.write([&](std::ostream& out) {
      m_format == "glb" ? IO::write_GLB(out, mesh, texture) : IO::write_OBJ(out, mesh, texture);
    });
    m_file.close();
  }

  /// Writes a mesh and curves in the order of the results, whose numbers they have; those without points are left out.
  /// \param tubes as in `with_curves()` \param values of the vertices, for ply and vtp
  void write(const Mesh& mesh, const Scene& scene, std::optional<double> tubes,
             const std::optional<Distance_map>& values)
  {
    namespace IO = CGAL::Flip_geodesics::IO;
    m_file.write([&](std::ostream& out) {
      if(m_format == "polylines")
        write_polylines(out, scene);
      else
        with_curves(mesh, scene, tubes,
                    IO::Colors(m_materials.name().substr(m_materials.name().find_last_of("/\\") + 1)),
                    [&](const auto&... parts) {
                      values ? write_with(out, *values, parts...) : write_view(out, m_format, parts...);
                    });
    });
    m_file.close();
    m_materials.write([](std::ostream& out) { IO::write_MTL(out); });
    m_materials.close();
  }

private:
  void write(std::ostream& out, const Mesh& mesh) const
  {
    const auto digits = CGAL::parameters::stream_precision(std::numeric_limits<double>::max_digits10);
    if(m_format == "off")
      CGAL::IO::write_OFF(out, mesh, digits);
    else if(m_format == "obj")
      CGAL::IO::write_OBJ(out, mesh, digits);
    else if(m_format == "ply")
      CGAL::IO::write_PLY(out, mesh, digits);
    else if(m_format == "stl")
      CGAL::IO::write_STL(out, mesh, digits);
    else
      CGAL::Flip_geodesics::IO::write_VTP(out, mesh, CGAL::parameters::use_binary_mode(false));
  }

  // The vertices of faces that would be lost if coincident ones were merged.
  static std::size_t number_of_coincident_vertices(const Mesh& mesh)
  {
    std::vector<Point_3> points;
    for(const Mesh::Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v))
        points.push_back(mesh.point(v));
    std::sort(points.begin(), points.end());
    return static_cast<std::size_t>(points.end() - std::unique(points.begin(), points.end()));
  }

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
      write_view(out, m_format, parts...);
  }

  // Is it the name of a file beside which there can be another one?
  static bool is_plain_name(const std::string& name) { return !open_file(name) && !is_special_file(name); }

  std::string m_format;
  Output_file m_file, m_materials;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_MESH_FILE_H
