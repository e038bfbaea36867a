// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FILES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FILES_H

#include "output/output_file.h"
#include "run/computations.h"
#include "run/curve_engine.h"

#include <cmath>
#include <cstddef>
#include <vector>

// The files with lines for programs: polylines and statistics. They are written as the curves come.
namespace program {

/// Lines `curve a b t x y z`, one per point: (1 - t) a + t b, where an input edge ab is crossed, or at a vertex if a is
/// b. At points where a curve starts, ends or may bend inside a face the line is `curve a b c t u x y z`: (1 - t - u) a
/// + t b + u c, the corners counterclockwise; on an edge as well, with c equal to b and u zero.
inline void write_polyline(Output_file& file, std::size_t curve, const Curve_result& result)
{
  for(const Curve_point& p : result.points) {
    const CGAL::Flip_geodesics::Surface_point& at = p.on_surface;
    file.stream() << curve << ' ' << at.a.idx() << ' ' << at.b.idx() << ' ';
    if(!at.is_vertex() && p.is_stop)
      file.stream() << (at.is_inside_face() ? at.c : at.b).idx() << ' ' << at.t << ' ' << at.u;
    else
      file.stream() << at.t;
    file.stream() << ' ' << p.in_space.x() << ' ' << p.in_space.y() << ' ' << p.in_space.z() << '\n';
  }
  file.check();
}

/*
 * Comma-separated values, one line per curve. Lengths are in the units of the mesh, angles in radians, times in
 * seconds. A curve that could not be computed has the status ERROR, and `nan` where nothing is known; a closed curve
 * has -1 as source and target. The curves of a network share one run: flips, flip_outs and shorten_s are those of the
 * run in each line. The last column is 1 if degenerate edges were contracted.
 */
constexpr const char* header_of_statistics =
    "curve,source,target,initial_segments,initial_length,length,flips,flip_outs,min_angle,status,certificate,search_s,"
    "shorten_s,extract_s,contracted\n";

inline void write_statistics(Output_file& file, std::size_t curve, const Curve_result& r)
{
  file.stream() << curve << ',' << r.source.idx() << ',' << r.target.idx() << ',' << r.initial_segments << ','
                << r.initial_length << ',' << r.length << ',' << r.flips << ',' << r.flip_outs << ','
                << r.smallest_angle << ',' << r.status << ',' << r.certificate << ',' << r.search_s << ','
                << r.shorten_s << ',' << r.extract_s << ',' << (r.are_zero_edges_contracted ? 1 : 0) << '\n';
  file.check();
}

/// Comma-separated values, one line per vertex: its distance from the source of a tree, the angle at which its path
/// starts, in radians, and both as a point of the plane. `inf` and `nan` where no path leads.
inline void write_map(Output_file& file, const CGAL::Flip_geodesics::Vertex_logarithmic_map& map)
{
  file.stream() << "vertex,distance,angle,x,y\n";
  Vertex_index v(0);
  for(const CGAL::Flip_geodesics::Polar_coordinates& p : map) {
    const auto [x, y] = map.in_plane(v);
    file.stream() << v.idx() << ',' << p.radius << ',' << p.angle << ',' << x << ',' << y << '\n';
    ++v;
  }
}

/// The same of the distance from the nearest of several sources and the number of that, which is empty for vertices
/// without a path.
inline void write_map(Output_file& file, const Distance_map& map)
{
  file.stream() << "vertex,distance,source\n";
  for(std::size_t v = 0; v < map.distances.size(); ++v) {
    file.stream() << v << ',' << map.distances[v] << ',';
    if(std::isfinite(map.distances[v]))
      file.stream() << map.nearest[v];
    file.stream() << '\n';
  }
}

/// Comma-separated values, the rows of a matrix.
inline void write_matrix(Output_file& file, const std::vector<std::vector<double>>& rows)
{
  for(const std::vector<double>& row : rows)
    for(const double& x : row)
      file.stream() << x << (&x == &row.back() ? '\n' : ',');
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FILES_H
