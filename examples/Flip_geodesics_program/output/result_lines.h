// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_RESULT_LINES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_RESULT_LINES_H

#include "messages.h"
#include "output/output_file.h"
#include "run/computations.h"
#include "run/curve_engine.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

// Lines for programs, which are written as the curves come, and the table for people.
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

/// The table on standard output: a line per curve if there are few, and the sums.
class Run_summary
{
public:
  void add(std::size_t curve, const Curve_result& result, bool shares_run)
  {
    ++m_counts[result.status];
    if(result.certificate != "none")
      ++m_verdicts[result.certificate];
    if(m_lines.size() < most_lines)
      m_lines.push_back(line(curve, result));
    ++m_number_of_curves;
    m_is_tree |= result.is_of_tree;
    m_are_pulled_tight &= result.is_pulled_tight;
    m_number_on_contracted += result.are_zero_edges_contracted ? 1 : 0;
    if(result.is_error())
      return;
    m_initial_length += result.initial_length;
    m_length += result.length;
    m_search.push_back(result.search_s);
    m_extract.push_back(result.extract_s);
    if(shares_run) // the run is counted with its first curve
      return;
    m_flips.push_back(result.flips);
    m_shorten.push_back(result.shorten_s);
  }

  void print(std::ostream& out) const
  {
    if(m_number_of_curves > 0 && m_number_of_curves <= most_lines) {
      out << (m_are_pulled_tight
                  ? "curve    source    target  segments       initial        length     flips  status   "
                    "            ms  locally shortest  name\n"
                  : "curve   segments        length  status            name\n");
      for(const std::string& line : m_lines)
        out << line;
    }
    print_counts(out << counted(m_number_of_curves, "curve", "curves") << (m_counts.empty() ? "" : ":"), m_counts);
    if(!m_verdicts.empty())
      print_counts(out << "locally shortest:", m_verdicts);
    if(m_number_on_contracted > 0)
      out << counted(m_number_on_contracted, "curve was", "curves were")
          << " computed after degenerate edges had been contracted\n";
    if(m_length > 0 && m_length == m_initial_length && !m_is_tree)
      out << format("length   %.6g\n", m_length);
    else if(m_length > 0 && !m_is_tree)
      out << format("length   %.6g of %.6g before shortening (%.2f %%)\n", m_length, m_initial_length,
                    100 * m_length / m_initial_length);
    if(!m_is_tree)
      print_sums(out, "flips   ", m_flips, readable);
    print_sums(out, "search  ", m_search, readable_time);
    print_sums(out, "shorten ", m_shorten, readable_time);
    print_sums(out, "extract ", m_extract, readable_time);
  }

private:
  static constexpr std::size_t most_lines = 20;

  template <class... Arguments>
  static std::string format(const char* pattern, Arguments... arguments)
  {
    char text[256];
    std::snprintf(text, sizeof text, pattern, arguments...);
    return text;
  }

  static std::string vertex(Vertex_index v) { return v.is_valid() ? std::to_string(v.idx()) : "-"; }

  static std::string line(std::size_t curve, const Curve_result& r)
  {
    if(!r.is_pulled_tight)
      return format("%5zu %10zu %13.6g  %-16s  ", curve, r.initial_segments, r.length, r.status.c_str()) + r.name +
             '\n';
    return format("%5zu %9s %9s %9zu %13.6g %13.6g %9zu  %-16s %8.3f  %-16s  ", curve, vertex(r.source).c_str(),
                  vertex(r.target).c_str(), r.initial_segments, r.initial_length, r.length, r.flips, r.status.c_str(),
                  1e3 * (r.search_s + r.shorten_s + r.extract_s), r.certificate.c_str()) +
           r.name + '\n';
  }

  static void print_counts(std::ostream& out, const std::map<std::string, std::size_t>& counts)
  {
    for(const auto& [name, count] : counts)
      out << ' ' << readable(count) << ' ' << name;
    out << '\n';
  }

  // The sum, and the median where there is more than one. Nothing for what did not take place.
  template <class Number, class Readable>
  static void print_sums(std::ostream& out, const char* name, std::vector<Number> values, const Readable& text)
  {
    const Number sum = std::accumulate(values.begin(), values.end(), Number(0));
    if(sum == 0)
      return;
    out << name << ' ' << text(sum);
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    if(values.size() > 1)
      out << ", median " << text(values[values.size() / 2]);
    out << '\n';
  }

  std::map<std::string, std::size_t> m_counts, m_verdicts;
  std::vector<std::string> m_lines;
  std::size_t m_number_of_curves = 0, m_number_on_contracted = 0;
  double m_initial_length = 0, m_length = 0;
  std::vector<std::size_t> m_flips;
  std::vector<double> m_search, m_shorten, m_extract;
  bool m_is_tree = false; // then the engine prints what matters
  bool m_are_pulled_tight = true;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_RESULT_LINES_H
