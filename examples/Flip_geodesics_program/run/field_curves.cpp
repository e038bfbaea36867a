// SPDX-License-Identifier: LGPL-3.0-or-later

#include "messages.h"
#include "run/computations.h"
#include "run/slit_surface.h"

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/isolines.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

namespace {

namespace FG = CGAL::Flip_geodesics;
using Polyline = FG::Located_polyline<Mesh>;
using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;

// A distance field on a mesh, of one type for all metrics.
class Field_on_mesh
{
public:
  struct Answer
  {
    double distance;
    std::size_t source;
  };

  // Distances are multiplied by `scale`, so that none exceeds the distance in the mesh, which isolines require.
  template <class Triangulation>
  Field_on_mesh(const FG::Geodesic_distance_field<Triangulation>& field, const Triangulation& triangulation,
                const Mesh& mesh, double scale)
    : m_scale(scale)
    , m_answer([&field, scale](const Location& at) {
      const auto answer = field(at.first, at.second);
      return Answer{scale * answer.distance, answer.source};
    })
    , m_has_one_source([&field](Mesh::Face_index f) { return field.has_one_source(f); })
    , m_point([&triangulation, &mesh](const Location& at) {
      return FG::surface_point(triangulation, FG::surface_location(triangulation, mesh, at));
    })
  {
  }

  double scale() const { return m_scale; }
  Answer operator()(Mesh::Face_index f, const std::array<double, 3>& weights) const { return m_answer({f, weights}); }
  bool has_one_source(Mesh::Face_index f) const { return m_has_one_source(f); }
  FG::Surface_point point(const Location& at) const { return m_point(at); }

private:
  double m_scale;
  std::function<Answer(const Location&)> m_answer;
  std::function<bool(Mesh::Face_index)> m_has_one_source;
  std::function<FG::Surface_point(const Location&)> m_point;
};

// Counts evaluations of a field, of which about a thousand lie between two calls.
class Evaluation_visitor : public CGAL::Flip_geodesics::Default_shortening_visitor
{
public:
  explicit Evaluation_visitor(Progress& progress)
    : m_progress(progress)
  {
  }

  bool go_further()
  {
    m_progress.add_steps(1000);
    return true;
  }

private:
  Progress& m_progress;
};

// What is wanted, or else a thousandth of the diagonal of the mesh's box. One of less than a millionth would take more
// time and memory than anyone has.
double usable_tolerance(const Mesh& mesh, double wanted)
{
  const double diagonal = size_of(mesh);
  if(wanted > 0 && wanted < 1e-6 * diagonal) {
    std::ostringstream message;
    message << "--tolerance " << wanted
            << " is less than a millionth of the diagonal of the bounding box; use at least " << 1.001e-6 * diagonal;
    throw Bad_input(message.str());
  }
  return wanted > 0 ? wanted : 0.001 * diagonal;
}

Curve_result curve_result(const Field_on_mesh& field, const Slit_surface& surface, const Polyline& polyline,
                          const std::string& name, const std::string& status)
{
  Curve_result result;
  result.name = name;
  result.status = status;
  result.is_pulled_tight = false;
  result.is_closed = polyline.is_closed;
  result.initial_segments = polyline.points.size() - 1;
  result.length = 0;
  for(std::size_t i = 0; i < polyline.points.size(); ++i) {
    const FG::Surface_point at = field.point(polyline.locations[i]);
    result.points.push_back({at, polyline.points[i], at.is_inside_face()});
    if(i > 0)
      result.length += std::sqrt(CGAL::squared_distance(polyline.points[i - 1], polyline.points[i]));
  }
  result.initial_length = result.length;
  surface.put_on_mesh(result);
  return result;
}

// Calls what takes a tolerance, and names the option if that cannot be had; levels are finite.
template <class Function>
void with_tolerance(const Function& function)
{
  try {
    function();
  } catch(const FG::Invalid_parameter_error& error) {
    throw Bad_input(std::string("--tolerance: ") + error.what() + "; use a larger tolerance");
  }
}

std::vector<double> wanted_levels(const Field_request& request, double farthest)
{
  constexpr double most_levels = 10000;
  std::vector<double> result = request.levels;
  if(!(request.spacing > 0))
    return result;
  const double number = std::ceil(farthest / request.spacing) - 1;
  if(number > most_levels) {
    std::ostringstream message;
    message << "--spacing " << request.spacing << " results in more than " << most_levels << " isolines; use at least "
            << 1.001 * farthest / most_levels;
    throw Bad_input(message.str());
  }
  for(double i = 1; i <= number; ++i)
    result.push_back(i * request.spacing);
  return result;
}

// Why there is no isoline at some levels.
std::string missing_levels(const std::vector<double>& levels, const std::set<double>& found, double farthest,
                           double tolerance)
{
  std::ostringstream out;
  for(const double level : levels)
    if(found.count(level) == 0) {
      out << "no isoline at distance " << level << ": ";
      if(level >= farthest)
        out << "the distance of the farthest vertex is " << farthest << "; use a smaller distance\n";
      else
        out << "regions in which distances differ from it by at most the tolerance " << tolerance
            << " can be missed; use a smaller --tolerance\n";
    }
  return out.str();
}

// The distances of the vertices of a mesh; of those on walls, from the nearer side.
template <class Field>
Distance_map distance_map(const Slit_surface& surface, std::size_t number_of_vertices, const Field& field)
{
  Distance_map result = {std::vector<double>(number_of_vertices, std::numeric_limits<double>::infinity()),
                         std::vector<std::size_t>(number_of_vertices, 0)};
  for(const Mesh::Vertex_index v : surface.mesh().vertices()) {
    const auto answer = field.answer(index_of(v));
    const auto at = static_cast<std::size_t>(surface.vertex_of_mesh(index_of(v)).idx());
    if(answer.distance < result.distances[at]) {
      result.distances[at] = answer.distance;
      result.nearest[at] = answer.source;
    }
  }
  return result;
}

template <class Metric>
std::vector<std::vector<double>> distances_between(const Mesh& mesh, const Metric& metric,
                                                   const std::vector<FG::Surface_location>& points, Progress& progress,
                                                   bool& are_confirmed)
{
  progress.enter("computing distances between sources", "sources", points.size());
  Share_visitor visitor(progress);
  std::vector<std::vector<double>> rows;
  const FG::Distances_report report =
      FG::geodesic_distance_matrix(mesh, points, std::back_inserter(rows), CGAL::parameters::metric(metric),
                                   CGAL::parameters::visitor(std::ref(visitor)));
  are_confirmed = are_confirmed && report.is_confirmed();
  return rows;
}

std::string describe_distances(const Field_request& request, bool are_confirmed)
{
  constexpr std::size_t most_names = 4;
  std::string names;
  for(std::size_t i = 0; i < (std::min)(request.sources.size(), most_names); ++i)
    names += (i == 0 ? ": " : ", ") + request.sources[i].name;
  return "sources  " + readable(request.sources.size()) + names + (request.sources.size() > most_names ? ", ..." : "") +
         "; distances " +
         (are_confirmed ? "confirmed\n"
                        : "not confirmed: rounding errors can exceed 1e-10 of a distance, or faces are almost "
                          "degenerate\n");
}

// The least factor of the length of a segment in the mesh to its length in a metric; 1 if both are the same.
template <class Metric>
double scale_of(const Mesh& mesh, const Metric& metric, const Path_conditions& conditions)
{
  if(!conditions.weights && !conditions.mollify)
    return 1;
  const double scale =
      FG::internal::least_stretch_of_faces(metric, Mesh_metric(mesh.points()), FG::Numbered_mesh<Mesh>(mesh));
  if(scale == 0)
    throw Bad_input("with weights or --mollify, isolines and Voronoi boundaries require faces that are not degenerate; "
                    "use --repair or remesh the surface");
  return scale;
}

void add_isolines(const Slit_surface& surface, const Field_on_mesh& field, const Field_request& request,
                  double tolerance, double farthest, Progress& progress, Field_curves& result)
{
  progress.enter("tracing isolines", "evaluations");
  Evaluation_visitor visitor(progress);
  const std::vector<double> levels = wanted_levels(request, farthest);
  std::vector<double> scaled_levels;
  std::map<double, double> level_of;
  for(const double level : levels) {
    scaled_levels.push_back(field.scale() * level);
    level_of[scaled_levels.back()] = level;
  }
  std::set<double> found;
  const auto add_isoline = [&](const FG::Isoline<Mesh>& isoline) {
    std::ostringstream name;
    name << "at distance " << level_of.at(isoline.level);
    found.insert(level_of.at(isoline.level));
    result.curves.push_back(curve_result(field, surface, isoline, name.str(), "ISOLINE"));
  };
  with_tolerance([&] {
    FG::isolines(surface.mesh(), field, scaled_levels, boost::make_function_output_iterator(add_isoline), tolerance,
                 CGAL::parameters::visitor(std::ref(visitor)));
  });
  result.remarks = missing_levels(levels, found, farthest, tolerance);
  if(request.spacing > 0 && request.spacing >= farthest) {
    std::ostringstream out;
    out << "no isoline at a multiple of --spacing was computed, since --spacing is not less than the distance of the "
        << "farthest vertex, " << farthest << "; use a smaller --spacing, or --isolines\n";
    result.remarks += out.str();
  }
}

// The boundary of two sources is undefined if rounding errors exceed their distance. Sources at one point count as one.
template <class Triangulation>
void check_that_sources_are_apart(const Triangulation& triangulation, const Mesh& mesh,
                                  const std::vector<FG::Surface_location>& sources, const Field_request& request,
                                  Progress& progress)
{
  const double rounding = 1e-12 * size_of(mesh);
  const auto distance = [&](std::size_t p, std::size_t q) {
    bool is_confirmed = true; // does not matter here
    return distances_between(mesh, triangulation.metric(), {sources[p], sources[q]}, progress, is_confirmed)[0][1];
  };
  const auto is_rounding = [&](double d) { return 0 < d && d <= rounding; };
  std::vector<std::pair<Point_3, std::size_t>> points;
  for(const FG::Surface_location& source : sources)
    points.emplace_back(FG::point_in_space(triangulation, FG::surface_point(triangulation, source)), points.size());
  std::sort(points.begin(), points.end());
  for(auto p = points.begin(); p != points.end(); ++p)
    for(auto q = p + 1; q != points.end() && q->first.x() - p->first.x() <= rounding; ++q)
      if(!are_in_one_place(triangulation.input(), sources[p->second], sources[q->second]) &&
         CGAL::squared_distance(p->first, q->first) <= rounding * rounding &&
         is_rounding(distance(p->second, q->second)))
        throw Bad_input("--voronoi: the distance between " + request.sources[p->second].name + " and " +
                        request.sources[q->second].name + " is below the rounding errors; omit one of these sources");
}

void add_boundaries(const Slit_surface& surface, const Field_on_mesh& field, const Field_request& request,
                    double tolerance, Progress& progress, Field_curves& result)
{
  progress.enter("tracing boundaries", "evaluations");
  Evaluation_visitor visitor(progress);
  const auto add_boundary = [&](const FG::Voronoi_boundary<Mesh>& boundary) {
    const auto name = [&](int side) { return request.sources[boundary.sources[side]].name; };
    result.curves.push_back(
        curve_result(field, surface, boundary, "between " + name(0) + " and " + name(1), "BOUNDARY"));
  };
  with_tolerance([&] {
    FG::voronoi_boundaries(surface.mesh(), field, boost::make_function_output_iterator(add_boundary), tolerance,
                           CGAL::parameters::visitor(std::ref(visitor)));
  });
}

template <class Metric>
Field_curves curves_in_metric(const Slit_surface& surface, const Metric& metric, const Field_request& request,
                              std::size_t number_of_vertices, Progress& progress)
{
  using Triangulation = FG::Intrinsic_triangulation<Mesh, FG::Default_traits<Metric>, Metric>;
  const Mesh& mesh = surface.mesh();
  const double tolerance = usable_tolerance(mesh, request.tolerance);
  const Triangulation triangulation(mesh, metric);
  FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
  std::vector<FG::Surface_location> sources;
  for(const Named_point& source : request.sources)
    sources.push_back(located(surface, source));
  for(const FG::Surface_location& source : sources)
    field.add_source(source);
  progress.enter("computing distances", "steps");
  // One source alone has no boundary, and no distance is needed to see that.
  const bool has_boundaries = request.is_diagram && sources.size() > 1;
  if(has_boundaries)
    check_that_sources_are_apart(triangulation, mesh, sources, request, progress);
  const bool has_isolines = !request.levels.empty() || request.spacing > 0;
  Progress_visitor visitor(progress);
  const bool is_computed = request.is_map || has_boundaries || has_isolines;
  bool are_confirmed = true;
  if(is_computed) {
    const FG::Distance_field_report report = field.compute(CGAL::parameters::visitor(std::ref(visitor)));
    if(report.status != FG::Distance_field_status::COMPLETE)
      throw std::runtime_error("the distances cannot be computed: the mesh is too large or has degenerate faces; "
                               "simplify it, or use --repair");
    are_confirmed = FG::is_confirmed(report.verdict);
  }

  Field_curves result;
  if(request.is_matrix)
    result.matrix = distances_between(mesh, metric, sources, progress, are_confirmed);
  if(is_computed || request.is_matrix)
    result.remarks = describe_distances(request, are_confirmed);
  const Distance_map map = is_computed ? distance_map(surface, number_of_vertices, field) : Distance_map();
  if(request.is_map)
    result.map = map;
  if(has_isolines || has_boundaries) {
    const Field_on_mesh on_mesh(field, triangulation, mesh, scale_of(mesh, metric, request.conditions));
    double farthest = 0;
    for(const double distance : map.distances)
      farthest = std::isfinite(distance) ? (std::max)(farthest, distance) : farthest;
    if(has_isolines)
      add_isolines(surface, on_mesh, request, tolerance, farthest, progress, result);
    if(has_boundaries)
      add_boundaries(surface, on_mesh, request, tolerance, progress, result);
  }
  const auto is_boundary = [](const Curve_result& curve) { return curve.status == "BOUNDARY"; };
  if(request.is_diagram && std::none_of(result.curves.begin(), result.curves.end(), is_boundary))
    result.remarks += has_boundaries ? "no boundary: in each component, all points have the same nearest source\n"
                                     : "no boundary: there is only one source\n";
  return result;
}

} // namespace

Field_curves field_curves(const Mesh& mesh, const Field_request& request, Progress& progress)
{
  const Slit_surface surface(mesh, request.conditions.obstacles);
  return with_metric(surface, request.conditions, [&](const auto& metric) {
    return curves_in_metric(surface, metric, request, mesh.number_of_vertices(), progress);
  });
}

} // namespace program
