// SPDX-License-Identifier: LGPL-3.0-or-later

#include "run/other_ways.h"

#include "advice.h"
#include "readable.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Slit_mesh.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/shortest_paths_by_class.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

namespace FG = CGAL::Flip_geodesics;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Free_mesh = CGAL::Face_filtered_graph<Mesh>;
using Slit_mesh = FG::Slit_mesh<Free_mesh>;
using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;
using Path = std::vector<Location>;

class Ways_finder
{
public:
  Ways_finder(const Mesh& mesh, const Ways_request& request)
    : m_mesh(mesh)
    , m_request(request)
    , m_triangulation(mesh)
  {
  }

  Ways operator()(Progress& progress)
  {
    progress.enter("searching for ways", "pairs", m_request.pairs.size());
    if(m_request.obstacles.are_none())
      for(const Curve_request& pair : m_request.pairs)
        add_ways(m_mesh, pair, progress);
    else
      add_ways_around_obstacles(progress);
    return std::move(m_ways);
  }

private:
  // What the searches of one pair take for a vertex of the covering, in bytes.
  static constexpr double bytes_per_vertex = 1200;

  void add_ways_around_obstacles(Progress& progress)
  {
    const Obstacles& obstacles = m_request.obstacles;
    std::vector<Mesh::Face_index> free_faces;
    for(const auto f : m_mesh.faces())
      if(obstacles.faces.count(f) == 0)
        free_faces.push_back(f);
    const Free_mesh free_mesh(m_mesh, free_faces);
    const auto is_wall = [&](Mesh::Edge_index e) { return obstacles.walls.count(e) != 0; };
    const Slit_mesh slit(free_mesh, boost::make_function_property_map<Mesh::Edge_index>(is_wall));
    for(const Curve_request& pair : m_request.pairs)
      if(const std::string why = obstructed_end(free_mesh, slit, pair); why.empty())
        add_ways(slit, pair, progress);
      else
        add_failure(pair, why);
  }

  // Returns why a pair has no paths if one of its ends lies in an obstacle, and else nothing.
  std::string obstructed_end(const Free_mesh& free_mesh, const Slit_mesh& slit, const Curve_request& pair) const
  {
    for(const Vertex_index v : pair.vertices) {
      const std::string vertex = "vertex " + std::to_string(v.idx());
      if(!free_mesh.is_in_cc(mesh_vertex(v)))
        return vertex + " lies inside of an obstacle of --avoid; choose another one";
      if(slit.number_of_copies(mesh_vertex(v)) > 1)
        return vertex + " lies on a wall of --avoid, on both of its sides; choose one beside it";
    }
    for(const FG::Surface_location& at : pair.points)
      if(!free_mesh.is_in_cc(face_location(at).first))
        return "an end lies in an obstacle of --avoid, or on its boundary; choose another one";
    return {};
  }

  Location face_location(const FG::Surface_location& at) const
  {
    return FG::face_location(m_triangulation, m_mesh, FG::surface_point(m_triangulation, at));
  }

  template <class View, class Paths>
  auto find(const View& view, const Curve_request& pair, Paths& paths) const
  {
    const auto between = [&](const auto& s, const auto& t) {
      return FG::shortest_paths_by_class(view, s, t, m_request.number, std::back_inserter(paths),
                                         CGAL::parameters::search_limit(covering_limit()));
    };
    return pair.points.empty() ? between(mesh_vertex(pair.vertices[0]), mesh_vertex(pair.vertices[1]))
                               : between(face_location(pair.points[0]), face_location(pair.points[1]));
  }

  template <class View>
  void add_ways(const View& view, const Curve_request& pair, Progress& progress)
  {
    const Stopwatch stopwatch;
    const std::size_t first = m_ways.curves.size();
    try {
      std::vector<Path> paths;
      const auto found = find(view, pair, paths);
      for(std::size_t i = 0; i < paths.size(); ++i)
        m_ways.curves.push_back(way(pair, i, found.report, paths[i]));
      if(paths.size() < m_request.number && found.status() == FG::Class_search_status::COVERING_LIMIT)
        add_failure(pair, "the search was given up at " + readable(found.report.visited) +
                              " vertices of the covering; want fewer ways, or give --most-memory");
      note_others(pair, found.report);
    } catch(const FG::Error& error) {
      add_failure(pair, with_advice_to_repair(error));
    }
    m_ways.curves[first].search_s = stopwatch.seconds();
    progress.add_steps(1);
  }

  FG::Covering_limit covering_limit() const
  {
    return m_request.most_memory
               ? FG::Covering_limit(static_cast<std::size_t>(*m_request.most_memory / bytes_per_vertex))
               : FG::Covering_limit();
  }

  Curve_result result_of(const Curve_request& pair) const
  {
    Curve_result result;
    result.name = pair.name;
    if(pair.points.empty()) {
      result.source = pair.vertices[0];
      result.target = pair.vertices[1];
    }
    return result;
  }

  template <class Report>
  Curve_result way(const Curve_request& pair, std::size_t i, const Report& report, const Path& path) const
  {
    const FG::Curve_report& curve = report.paths[i].shortening.curves.front();
    Curve_result result = result_of(pair);
    result.name += ", way " + std::to_string(i);
    result.initial_segments = report.classes[i].edge_path.size();
    result.initial_length = report.classes[i].edge_length;
    result.length = report.paths[i].length;
    result.flips = curve.flips;
    result.smallest_angle = curve.smallest_angle;
    result.status = to_string(report.paths[i].verdict);
    result.certificate = to_string(curve.verdict);
    result.are_zero_edges_contracted = curve.are_zero_edges_contracted;
    for(const auto& place : path) {
      const FG::Surface_point p =
          FG::surface_point(m_triangulation, FG::surface_location(m_triangulation, m_mesh, place));
      result.points.push_back({p, point_in_space(m_triangulation, p), p.is_inside_face()});
    }
    return result;
  }

  void add_failure(const Curve_request& pair, const std::string& why)
  {
    m_ways.curves.push_back(result_of(pair));
    m_ways.curves.back().error = why.substr(0, why.find('\n'));
  }

  // For the first pairs, as a table has lines.
  template <class Report>
  void note_others(const Curve_request& pair, const Report& report)
  {
    constexpr std::size_t most_lines = 20;
    if(++m_number_of_notes > most_lines)
      return;
    std::ostringstream line;
    line << "ways     " << report.paths.size();
    if(pair.points.empty())
      line << " from " << pair.vertices[0].idx() << " to " << pair.vertices[1].idx();
    else
      line << " of " << pair.name;
    line << (report.is_confirmed() ? ", confirmed; " : ", not confirmed; ");
    const double bound = report.lower_bound_of_others();
    if(std::isinf(bound))
      line << "no other exists\n";
    else
      line << "any other is at least " << bound << " long\n";
    m_ways.others += line.str();
  }

  const Mesh& m_mesh;
  const Ways_request& m_request;
  const Triangulation m_triangulation; // in which places are given
  Ways m_ways;
  std::size_t m_number_of_notes = 0;
};

} // namespace

Ways other_ways(const Mesh& mesh, const Ways_request& request, Progress& progress)
{
  return Ways_finder(mesh, request)(progress);
}

} // namespace program
