// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_CURVES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_CURVES_H

#include "program_mesh.h"
#include "scene.h"

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/IO/PLY.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/IO/appearance.h>

#include <boost/range/adaptor/transformed.hpp>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace program {

/// The radius of the curves in files for viewers, or 0 for lines. Viewers draw lines one pixel wide or not at all, so
/// curves are tubes: four pixels wide where the mesh fills a thousand. Curves of very many points, as trees have, are
/// lines, so that files stay small: a tube takes nine times the numbers of a line.
inline double radius_of_tubes(const Mesh& mesh, const Scene& scene)
{
  constexpr std::size_t most_points = 100000;
  std::size_t points = 0;
  for(const Scene_curve& curve : scene.curves)
    points += curve.points.size();
  return points <= most_points ? 0.002 * size_of(mesh) : 0;
}

/// Calls `write` with what the library's writers of files for viewers take: the mesh, the curves, and tubes, if they
/// are wanted, and colors. \param tubes the radius, 0 for lines; not given, it follows from the mesh
template <class Write>
void with_curves(const Mesh& mesh, const Scene& scene, std::optional<double> tubes,
                 const CGAL::Flip_geodesics::IO::Colors& colors, const Write& write)
{
  constexpr int number_of_sides = 8;
  const auto points = [](const Scene_curve& curve) -> const std::vector<Point_3>& { return curve.points; };
  const auto curves = scene.curves | boost::adaptors::transformed(points);
  const double radius = tubes ? *tubes : radius_of_tubes(mesh, scene);
  if(radius > 0)
    write(mesh, curves, colors, CGAL::Flip_geodesics::IO::Tubes(radius, number_of_sides));
  else
    write(mesh, curves, colors);
}

/// Writes what `with_curves()` passes on, in the format obj, ply, vtp or glb; as text where there is a choice.
template <class... Parts>
void write_view(std::ostream& out, const std::string& format, const Parts&... parts)
{
  namespace IO = CGAL::Flip_geodesics::IO;
  const auto as_text = CGAL::parameters::use_binary_mode(false);
  if(format == "obj")
    IO::write_OBJ(out, parts...);
  else if(format == "ply")
    IO::write_PLY(out, parts..., as_text);
  else if(format == "vtp")
    IO::write_VTP(out, parts..., as_text);
  else
    IO::write_GLB(out, parts...);
}

/// The curves alone, as CGAL's demo reads them: a line each, the number of points and the points.
inline void write_polylines(std::ostream& out, const Scene& scene)
{
  for(const Scene_curve& curve : scene.curves) {
    if(curve.points.empty())
      continue;
    out << curve.points.size();
    for(const Point_3& p : curve.points)
      out << ' ' << p.x() << ' ' << p.y() << ' ' << p.z();
    out << '\n';
  }
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_CURVES_H
