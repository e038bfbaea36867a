// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_IO_H
#define CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_IO_H

#include "polyline_checker.h"

#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <istream>
#include <iterator>
#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace polyline_checker {

/// What the program says of a curve. Vertices are `null_index` and the length is NaN where it says nothing.
struct Curve_stats
{
  std::string status;
  Index source = null_index, target = null_index;
  double length = std::numeric_limits<double>::quiet_NaN();
};

using Stats = std::map<long, Curve_stats>;

/// The verdict on a curve, together with what the program says of it.
struct Verdict
{
  Curve_report report;
  std::string status;
  long double length_error = std::numeric_limits<long double>::quiet_NaN();
  bool ok = false;
};

// ------------------------------------------------------------------------------------------------------ reading --

/// Reads numbers off a line; anything else is an error of this line.
class Line_reader
{
public:
  Line_reader(const std::string& line, std::size_t line_number)
    : m_next(line.c_str())
    , m_line_number(line_number)
  {
  }

  long read_integer()
  {
    char* end = nullptr;
    const long value = std::strtol(m_next, &end, 10);
    moved_to(end);
    return value;
  }

  Index read_vertex()
  {
    const long value = read_integer();
    // A negative number becomes a vertex that no mesh has.
    return value < 0 || value >= long(null_index) ? null_index - 1 : Index(value);
  }

  double read_number()
  {
    char* end = nullptr;
    const double value = std::strtod(m_next, &end);
    moved_to(end);
    return value;
  }

  void expect_end() const
  {
    for(const char* c = m_next; *c != '\0'; ++c)
      if(*c != ' ' && *c != '\t' && *c != '\r')
        fail();
  }

  void fail() const
  {
    throw Bad_input("line " + std::to_string(m_line_number) +
                    " of the polylines is neither `curve a b t x y z` nor `curve a b c t u x y z`");
  }

private:
  void moved_to(const char* end)
  {
    if(end == m_next)
      fail();
    m_next = end;
  }

  const char* m_next;
  std::size_t m_line_number;
};

inline Polyline_point read_polyline_point(Line_reader& reader, bool is_inside)
{
  Polyline_point point{};
  point.a = reader.read_vertex();
  point.b = reader.read_vertex();
  point.c = is_inside ? reader.read_vertex() : null_index;
  point.t = reader.read_number();
  point.u = is_inside ? reader.read_number() : 0;
  for(double& coordinate : point.position)
    coordinate = reader.read_number();
  reader.expect_end();
  return point;
}

/// Reads lines `curve a b t x y z`, or `curve a b c t u x y z` where curves start, end or bend inside faces or, with c
/// equal to b, on edges; empty lines and lines that begin with # are comments.
/// \throws Bad_input if a line is not like that, or if a curve is in two parts
inline std::vector<Polyline> read_polylines(std::istream& in)
{
  std::vector<Polyline> curves;
  std::set<long> known;
  std::string line;
  for(std::size_t number = 1; std::getline(in, line); ++number) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if(begin == std::string::npos || line[begin] == '#')
      continue;
    Line_reader reader(line, number);
    const long id = reader.read_integer();
    if(curves.empty() || curves.back().id != id) {
      if(!known.insert(id).second)
        throw Bad_input("line " + std::to_string(number) + " of the polylines continues an earlier curve");
      curves.push_back({id, {}});
    }
    std::istringstream fields(line);
    const auto count = std::distance(std::istream_iterator<std::string>(fields), std::istream_iterator<std::string>());
    curves.back().points.push_back(read_polyline_point(reader, count == 9));
  }
  return curves;
}

inline std::vector<std::string> split_at_commas(std::string line)
{
  if(!line.empty() && line.back() == '\r')
    line.pop_back();
  std::vector<std::string> fields;
  std::istringstream stream(line + ",");
  for(std::string field; std::getline(stream, field, ',');)
    fields.push_back(field);
  return fields;
}

/// Reads a place as it is asked for: `v`, `a,b,t` or `a,b,c,t,u`.
inline Place read_place(const std::string& word)
{
  std::vector<double> n;
  for(const std::string& field : split_at_commas(word))
    n.push_back(std::strtod(field.c_str(), nullptr));
  if(n.size() == 1)
    return Place::vertex(Index(n[0]));
  if(n.size() == 3)
    return Place::on_edge(Index(n[0]), Index(n[1]), n[2]);
  if(n.size() != 5)
    throw Bad_input("'" + word + "' is not a point");
  return {Index(n[0]), Index(n[1]), Index(n[2]), n[3], n[4]};
}

/*
 * Reads which points the curves are to pass, and adds that to the curves: a line per curve, the first one for curve 0.
 * Of splines only the ends are given, and they may bend inside all faces and on all edges; after `o` they are closed.
 */
inline void read_way_points(std::istream& in, bool are_splines, std::vector<Polyline>& curves)
{
  std::vector<Polyline> asked;
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    Polyline curve{};
    std::vector<Place> places;
    for(std::string word; words >> word;)
      if(word == "o" || word == "s")
        curve.must_be_closed = word == "o";
      else
        places.push_back(read_place(word));
    if(places.empty())
      continue;
    if(are_splines)
      places = curve.must_be_closed ? std::vector<Place>() : std::vector<Place>{places.front(), places.back()};
    curve.way_points = places;
    curve.may_bend_inside = are_splines;
    asked.push_back(curve);
  }
  for(Polyline& curve : curves) {
    if(curve.id < 0 || std::size_t(curve.id) >= asked.size())
      throw Bad_input("curve " + std::to_string(curve.id) + " was not requested");
    const std::vector<Polyline_point> points = curve.points;
    const long id = curve.id;
    curve = asked[std::size_t(id)];
    curve.id = id;
    curve.points = points;
  }
}

inline Curve_stats parse_stats(std::map<std::string, std::string>& row)
{
  Curve_stats stats;
  const auto vertex = [](const std::string& s) {
    return s.empty() || s[0] == '-' ? null_index : Index(std::strtoul(s.c_str(), nullptr, 10));
  };
  stats.status = row["status"];
  stats.source = vertex(row["source"]);
  stats.target = vertex(row["target"]);
  if(!row["length"].empty())
    stats.length = std::strtod(row["length"].c_str(), nullptr);
  return stats;
}

/// Reads a table with a header; uses the columns `curve`, `status`, `source`, `target` and `length`.
/// \throws Bad_input if there is no such column `curve`, or a line is shorter than the header
inline Stats read_stats(std::istream& in)
{
  Stats stats;
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> header = split_at_commas(line);
  if(std::find(header.begin(), header.end(), "curve") == header.end())
    throw Bad_input("the first line of the statistics has no column `curve`");
  for(std::size_t number = 2; std::getline(in, line); ++number) {
    if(line.empty())
      continue;
    const std::vector<std::string> fields = split_at_commas(line);
    if(fields.size() < header.size())
      throw Bad_input("line " + std::to_string(number) + " of the statistics is too short");
    std::map<std::string, std::string> row;
    for(std::size_t i = 0; i < header.size(); ++i)
      row[header[i]] = fields[i];
    stats[std::strtol(row["curve"].c_str(), nullptr, 10)] = parse_stats(row);
  }
  return stats;
}

// ------------------------------------------------------------------------------------------------------ verdicts --

/// The ends of the curve have to be those that were asked for.
inline void check_ends(const Polyline& curve, const Curve_stats& stats, Curve_report& report)
{
  if(curve.points.empty())
    return;
  if(stats.source != null_index && curve.points.front().a != stats.source)
    report.add_break("the curve does not begin at its source " + std::to_string(stats.source));
  if(stats.target != null_index && curve.points.back().a != stats.target)
    report.add_break("the curve does not end at its target " + std::to_string(stats.target));
}

/// A curve said to be LOCALLY_SHORTEST, or of which nothing is said, has to be geodesic. One that was stopped early has
/// straight segments and may bend at vertices; one that failed or is CONTRACTED may have no points at all.
inline bool is_acceptable(const Verdict& verdict, const Tolerances& tolerances)
{
  const Curve_report& report = verdict.report;
  if(verdict.length_error > tolerances.length)
    return false;
  if(verdict.status.empty() || verdict.status == "LOCALLY_SHORTEST")
    return report.points > 0 && is_geodesic(report, tolerances);
  return has_straight_segments(report, tolerances);
}

inline Verdict judge(const Polyline& curve, const Curve_report& report, const Curve_stats& stats,
                     const Tolerances& tolerances)
{
  Verdict verdict;
  verdict.report = report;
  verdict.status = stats.status;
  check_ends(curve, stats, verdict.report);
  if(!std::isnan(stats.length) && !curve.points.empty() && verdict.report.broken == 0)
    verdict.length_error = std::fabs(report.length - stats.length) / (report.length > 0 ? report.length : 1);
  verdict.ok = is_acceptable(verdict, tolerances);
  if(verdict.status == "LOCALLY_SHORTEST" && curve.points.empty())
    verdict.report.add_break("the curve has no points");
  return verdict;
}

/// Puts vertices that lie in one place where the mesh has them: those of points, and those that the statistics name.
inline void merge_vertices(const Mesh& mesh, std::vector<Polyline>& curves, Stats& stats)
{
  for(Polyline& curve : curves) {
    for(Polyline_point& p : curve.points)
      for(Index* v : {&p.a, &p.b, &p.c})
        *v = mesh.merged(*v);
    for(Place& place : curve.way_points)
      for(Index* v : {&place.a, &place.b, &place.c})
        *v = mesh.merged(*v);
  }
  for(auto& [id, said] : stats)
    for(Index* v : {&said.source, &said.target})
      *v = mesh.merged(*v);
}

/// Judges the curves of a file in its order, then those that only the statistics know.
inline std::map<long, Verdict> judge_curves(const Mesh& mesh, const std::vector<Polyline>& curves, const Stats& stats,
                                            const Joint_options& options = Joint_options(),
                                            const Tolerances& tolerances = Tolerances())
{
  std::map<long, Verdict> verdicts;
  const std::vector<Curve_report> reports = check_curves(mesh, curves, options, tolerances);
  for(std::size_t i = 0; i < curves.size(); ++i) {
    const auto known = stats.find(curves[i].id);
    Verdict verdict = judge(curves[i], reports[i], known == stats.end() ? Curve_stats() : known->second, tolerances);
    if(!stats.empty() && known == stats.end()) {
      verdict.report.add_break("the statistics do not contain this curve");
      verdict.ok = false;
    }
    verdicts[curves[i].id] = verdict;
  }
  for(const auto& [id, said] : stats)
    if(verdicts.count(id) == 0)
      verdicts[id] = judge({id, {}}, Curve_report(), said, tolerances);
  return verdicts;
}

// ------------------------------------------------------------------------------------------------------ writing --

/// Writes a table with a row for each curve. Angles are in radians, `inf` where there is none; fields are empty where
/// there is nothing to compare with. `message` says what broke first.
inline void write_verdicts(std::ostream& out, const std::map<long, Verdict>& verdicts)
{
  out << "curve,status,points,segments,broken,strip_bend,point_deviation,raw_bend,min_vertex_angle,bent_vertices,"
         "min_unblocked_angle,length,length_error,ok,message\n";
  for(const auto& [id, verdict] : verdicts) {
    const Curve_report& report = verdict.report;
    out << id << ',' << verdict.status << ',' << report.points << ',' << report.segments << ',' << report.broken
        << std::setprecision(6) << ',' << report.strip_bend << ',' << report.point_deviation << ',' << report.raw_bend
        << std::setprecision(17) << ',' << report.min_vertex_angle << ',' << report.bent_vertices << ','
        << report.min_unblocked_angle << ',' << report.length << ',' << std::setprecision(6);
    if(!std::isnan(verdict.length_error))
      out << verdict.length_error;
    out << ',' << (verdict.ok ? 1 : 0) << ',' << report.first_break << '\n';
  }
}

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_IO_H
