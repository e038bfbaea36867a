// SPDX-License-Identifier: LGPL-3.0-or-later

#include "messages.h"
#include "run/computations.h"
#include "run/slit_surface.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/shortest_paths_by_class.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

namespace FG = CGAL::Flip_geodesics;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Path = std::vector<std::pair<Mesh::Face_index, std::array<double, 3>>>;

class Ways_finder
{
public:
  Ways_finder(const Mesh& mesh, const Ways_request& request)
    : m_request(request)
    , m_surface(mesh, request.obstacles)
    , m_triangulation(m_surface.mesh())
  {
  }

  Ways operator()(Progress& progress)
  {
    progress.enter("searching for homotopy classes", "steps");
    progress.expect_curves(m_request.pairs.size());
    for(const Curve_request& pair : m_request.pairs) {
      if(const std::string why = obstruction(pair); why.empty())
        add_ways(pair, progress);
      else
        add_failure(pair, why);
      progress.add_curves(1);
    }
    return std::move(m_ways);
  }

private:
  // What the searches of one pair take for a vertex of the cover, in bytes.
  static constexpr double bytes_per_vertex = 1200;

  // Why a pair has no paths if one of its ends is not on the surface, and else nothing.
  std::string obstruction(const Curve_request& pair) const
  {
    for(const Vertex_index v : pair.vertices)
      if(const std::string why = m_surface.obstruction(v); !why.empty())
        return "vertex " + std::to_string(v.idx()) + ' ' + why;
    for(const FG::Surface_location& at : pair.points)
      if(const std::string why = m_surface.obstruction(at); !why.empty())
        return "an end " + why;
    return {};
  }

  template <class End>
  FG::Paths_by_class_report<Mesh> find(const std::vector<End>& ends, std::vector<Path>& paths, Progress& progress) const
  {
    Progress_visitor visitor(progress);
    const auto at = [&](const End& end) { return place(m_surface.located(end)); };
    return FG::shortest_paths_by_class(m_surface.mesh(), at(ends[0]), at(ends[1]), m_request.number,
                                       std::back_inserter(paths), CGAL::parameters::search_limit(covering_limit()),
                                       CGAL::parameters::visitor(std::ref(visitor)))
        .report;
  }

  static Mesh::Vertex_index place(Vertex_index v) { return mesh_vertex(v); }
  Path::value_type place(const FG::Surface_location& at) const
  {
    return FG::face_location(m_triangulation, m_surface.mesh(), at);
  }

  void add_ways(const Curve_request& pair, Progress& progress)
  {
    const Stopwatch stopwatch;
    const std::size_t first = m_ways.curves.size();
    try {
      std::vector<Path> paths;
      const auto report =
          pair.points.empty() ? find(pair.vertices, paths, progress) : find(pair.points, paths, progress);
      for(std::size_t i = 0; i < paths.size(); ++i)
        m_ways.curves.push_back(way(pair, i, report, paths[i]));
      if(paths.size() < m_request.number && report.status == FG::Class_search_status::COVERING_LIMIT)
        add_failure(pair, "the search reached the memory limit after " + readable(report.visited) +
                              " vertices of the universal cover; increase --memory-limit");
      note_others(pair, report);
    } catch(const FG::Disconnected_endpoints_error& error) {
      add_failure(pair,
                  m_request.obstacles.are_none()
                      ? with_advice_to_repair(error)
                      : "no path connects the two ends: obstacles separate them, or they lie in different components");
    } catch(const FG::Error& error) {
      add_failure(pair, with_advice_to_repair(error));
    }
    m_ways.curves[first].search_s = stopwatch.seconds();
  }

  FG::Covering_limit covering_limit() const
  {
    return m_request.memory_limit
               ? FG::Covering_limit(static_cast<std::size_t>(*m_request.memory_limit / bytes_per_vertex))
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
    for(const auto& at : path) {
      const FG::Surface_point p =
          FG::surface_point(m_triangulation, FG::surface_location(m_triangulation, m_surface.mesh(), at));
      result.points.push_back({p, point_in_space(m_triangulation, p), p.is_inside_face()});
    }
    m_surface.put_on_mesh(result);
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
      line << "no other class exists\n";
    else
      line << "the paths of all other classes are at least " << bound << " long\n";
    m_ways.others += line.str();
  }

  const Ways_request& m_request;
  const Slit_surface m_surface;
  const Triangulation m_triangulation; // of the surface
  Ways m_ways;
  std::size_t m_number_of_notes = 0;
};

} // namespace

Ways other_ways(const Mesh& mesh, const Ways_request& request, Progress& progress)
{
  return Ways_finder(mesh, request)(progress);
}

} // namespace program
