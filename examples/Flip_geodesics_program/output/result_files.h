// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FILES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FILES_H

#include "output/output_file.h"
#include "run/curve_engine.h"
#include "run/field_curves.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// The files with lines for programs: polylines and statistics. They are written as the curves come.
namespace program {

/// Lines `curve a b t x y z`, one per point: (1 - t) a + t b, where an input edge ab is crossed, or at a vertex if a is b.
/// Where a curve starts, ends or may bend inside a face the line is `curve a b c t u x y z`: (1 - t - u) a + t b + u c,
/// the corners counterclockwise; on an edge as well, with c equal to b and u zero.
class Polylines_file
{
public:
  explicit Polylines_file(const std::string& name)
    : m_file(name)
  {
  }

  void write(std::size_t curve, const Curve_result& result)
  {
    if(!m_file.is_wanted())
      return;
    for(const Curve_point& p : result.points) {
      const CGAL::Flip_geodesics::Surface_point& at = p.on_surface;
      m_file.stream() << curve << ' ' << at.a.idx() << ' ' << at.b.idx() << ' ';
      const bool is_inserted = !at.is_vertex() && p.is_stop;
      if(is_inserted)
        m_file.stream() << (at.is_inside_face() ? at.c : at.b).idx() << ' ' << at.t << ' ' << at.u;
      else
        m_file.stream() << at.t;
      m_file.stream() << ' ' << p.in_space.x() << ' ' << p.in_space.y() << ' ' << p.in_space.z() << '\n';
    }
    m_file.check();
  }

  void close() { m_file.close(); }

private:
  Output_file m_file;
};

/*
 * Comma-separated values, one line per curve. Lengths are in the units of the mesh, angles in radians, times in
 * seconds. A curve that could not be computed has the status ERROR, and `nan` where nothing is known; a closed curve
 * has -1 as source and target. The curves of a network share one run: flips, flip_outs and shorten_s are those of the
 * run in each line. The last column is 1 if degenerate edges were contracted.
 */
class Stats_file
{
public:
  explicit Stats_file(const std::string& name)
    : m_file(name)
  {
    if(m_file.is_wanted())
      m_file.stream() << "curve,source,target,initial_segments,initial_length,length,flips,flip_outs,min_angle,status,"
                         "certificate,search_s,shorten_s,extract_s,contracted\n";
  }

  void write(std::size_t curve, const Curve_result& r)
  {
    if(!m_file.is_wanted())
      return;
    m_file.stream() << curve << ',' << r.source.idx() << ',' << r.target.idx() << ',' << r.initial_segments << ','
                    << r.initial_length << ',' << r.length << ',' << r.flips << ',' << r.flip_outs << ','
                    << r.smallest_angle << ',' << r.status << ',' << r.certificate << ',' << r.search_s << ','
                    << r.shorten_s << ',' << r.extract_s << ',' << (r.are_zero_edges_contracted ? 1 : 0) << '\n';
    m_file.check();
  }

  void close() { m_file.close(); }

private:
  Output_file m_file;
};

/// Comma-separated values, one line per vertex: its distance from the source of a tree, the angle at which its path
/// starts, in radians, and both as a point of the plane; or its distance from the nearest of several sources and the
/// number of that. `inf` and `nan` where there is no path.
class Map_file
{
public:
  explicit Map_file(const std::string& name)
    : m_file(name)
  {
  }

  void write(const CGAL::Flip_geodesics::Vertex_logarithmic_map& map)
  {
    if(!m_file.is_wanted())
      return;
    m_has_map = true;
    m_file.stream() << "vertex,distance,angle,x,y\n";
    Vertex_index v(0);
    for(const CGAL::Flip_geodesics::Polar_coordinates& p : map) {
      const auto [x, y] = map.in_plane(v);
      m_file.stream() << v.idx() << ',' << p.radius << ',' << p.angle << ',' << x << ',' << y << '\n';
      ++v;
    }
  }

  void write(const Distance_map& map)
  {
    if(!m_file.is_wanted())
      return;
    m_has_map = true;
    m_file.stream() << "vertex,distance,source\n";
    for(std::size_t v = 0; v < map.distances.size(); ++v)
      m_file.stream() << v << ',' << map.distances[v] << ',' << map.nearest[v] << '\n';
  }

  // Without a map what was there stays.
  void close()
  {
    if(m_has_map)
      m_file.close();
  }

private:
  Output_file m_file;
  bool m_has_map = false;
};

/// Comma-separated values, the rows of a matrix.
class Matrix_file
{
public:
  explicit Matrix_file(const std::string& name)
    : m_file(name)
  {
  }

  void write(const std::vector<std::vector<double>>& rows)
  {
    for(const std::vector<double>& row : rows)
      for(const double& x : row)
        m_file.stream() << x << (&x == &row.back() ? '\n' : ',');
  }

  void close() { m_file.close(); }

private:
  Output_file m_file;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_RESULT_FILES_H
