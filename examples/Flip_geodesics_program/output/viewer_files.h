// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_FILES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_FILES_H

#include "file_name.h"
#include "output/output_file.h"
#include "scene.h"

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/IO/PLY.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>

#include <boost/range/adaptor/transformed.hpp>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

namespace program {

/// The surface and the curves in one file for a viewer. Curves are in the order of the results, and so have the numbers
/// that they have there; those without points are left out.
class Viewer_file
{
public:
  /// The format follows from the extension, see `write()`. An empty name means that nothing is to be written.
  explicit Viewer_file(const std::string& name)
    : m_format(check_format(name))
    , m_file(name)
  {
  }

  bool is_wanted() const { return m_file.is_wanted(); }

  void write(const Mesh& mesh, const Scene& scene)
  {
    if(!is_wanted())
      return;
    const auto points = [](const Scene_curve& curve) -> const std::vector<Point_3>& { return curve.points; };
    m_file.write([&](std::ostream& out) { write(out, mesh, scene.curves | boost::adaptors::transformed(points)); });
    m_file.close();
  }

private:
  static std::string check_format(const std::string& name)
  {
    const std::string polylines = ".polylines.txt";
    if(name.size() > polylines.size() && name.compare(name.size() - polylines.size(), polylines.size(), polylines) == 0)
      return "polylines";
    const std::vector<std::string> known = {"obj", "ply", "vtp", "glb"};
    if(!name.empty() && std::find(known.begin(), known.end(), extension(name)) == known.end())
      throw Bad_input(printable(name) + ": the extension of --mesh tells the format; use .obj, .ply, .vtp, .glb or "
                                        ".polylines.txt");
    return extension(name);
  }

  template <class Polylines>
  void write(std::ostream& out, const Mesh& mesh, const Polylines& curves) const
  {
    namespace IO = CGAL::Flip_geodesics::IO;
    const auto as_text = CGAL::parameters::use_binary_mode(false);
    if(m_format == "obj")
      IO::write_OBJ(out, mesh, curves);
    else if(m_format == "ply")
      IO::write_PLY(out, mesh, curves, as_text);
    else if(m_format == "vtp")
      IO::write_VTP(out, mesh, curves, as_text);
    else if(m_format == "glb")
      IO::write_GLB(out, mesh, curves);
    else
      write_polylines(out, curves);
  }

  // The polylines alone, as CGAL's demo reads them: a line each, the number of points and the points.
  template <class Polylines>
  static void write_polylines(std::ostream& out, const Polylines& curves)
  {
    for(const std::vector<Point_3>& points : curves) {
      if(points.empty())
        continue;
      out << points.size();
      for(const Point_3& p : points)
        out << ' ' << p.x() << ' ' << p.y() << ' ' << p.z();
      out << '\n';
    }
  }

  std::string m_format;
  Output_file m_file;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_FILES_H
