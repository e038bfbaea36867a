// SPDX-License-Identifier: LGPL-3.0-or-later

#include "run/field_curves.h"

#include "bad_input.h"

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/isolines.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace program {

namespace {

namespace FG = CGAL::Flip_geodesics;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Field = FG::Geodesic_distance_field<Triangulation>;
using Polyline = FG::Located_polyline<Mesh>;

// What is wanted, or else a thousandth of the diagonal of the mesh's box. One of less than a millionth would take more
// time and memory than anyone has.
double usable_tolerance(const Mesh& mesh, double wanted)
{
  const double diagonal = size_of(mesh);
  if(wanted > 0 && wanted < 1e-6 * diagonal) {
    std::ostringstream message;
    message << "--tolerance " << wanted << " is less than a millionth of the size of the mesh; give at least "
            << 1e-6 * diagonal;
    throw Bad_input(message.str());
  }
  return wanted > 0 ? wanted : 0.001 * diagonal;
}

Curve_result curve_result(const Triangulation& triangulation, const Mesh& mesh, const Polyline& polyline,
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
    const FG::Surface_point at =
        FG::surface_point(triangulation, FG::surface_location(triangulation, mesh, polyline.locations[i]));
    result.points.push_back({at, polyline.points[i], at.is_inside_face()});
    if(i > 0)
      result.length += std::sqrt(CGAL::squared_distance(polyline.points[i - 1], polyline.points[i]));
  }
  result.initial_length = result.length;
  return result;
}

// Calls what takes a tolerance, and names the option if that cannot be had; levels are finite.
template <class Function>
void with_tolerance(const Function& function)
{
  try {
    function();
  } catch(const FG::Invalid_parameter_error& error) {
    throw Bad_input(std::string("--tolerance: ") + error.what() + "; give a larger one");
  }
}

double farthest_distance(const Mesh& mesh, const Field& field)
{
  double result = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(const double distance = field.distance(Vertex_index(static_cast<Index>(v))); std::isfinite(distance))
      result = (std::max)(result, distance);
  return result;
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
    message << "--spacing " << request.spacing << " makes more than " << most_levels << " isolines; give at least "
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
        out << "the farthest vertex is " << farthest << " away\n";
      else
        out << "the tolerance of " << tolerance << " does not distinguish it from a point\n";
    }
  return out.str();
}

Distance_map distance_map(const Mesh& mesh, const Field& field)
{
  Distance_map result;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const Field::Answer answer = field.answer(index_of(v));
    result.distances.push_back(answer.distance);
    result.nearest.push_back(answer.source);
  }
  return result;
}

std::vector<std::vector<double>> distances_between(const Mesh& mesh, const std::vector<Named_point>& sources,
                                                   Progress& progress)
{
  std::vector<FG::Surface_location> points;
  for(const Named_point& source : sources)
    points.push_back(source.at);
  progress.enter("computing distances between sources");
  Share_visitor visitor(progress);
  std::vector<std::vector<double>> rows;
  FG::geodesic_distance_matrix(mesh, points, std::back_inserter(rows), CGAL::parameters::visitor(std::ref(visitor)));
  return rows;
}

} // namespace

Field_curves field_curves(const Mesh& mesh, const Field_request& request, Progress& progress)
{
  const double tolerance = usable_tolerance(mesh, request.tolerance);
  const Triangulation triangulation(mesh);
  Field field(triangulation, mesh);
  for(const Named_point& source : request.sources)
    field.add_source(source.at);
  progress.enter("computing distances", "steps");
  // One source alone has no boundary, and no distance is needed to see that.
  const bool has_boundaries = request.is_diagram && request.sources.size() > 1;
  const bool is_field_needed = request.is_map || has_boundaries || !request.levels.empty() || request.spacing > 0;
  Progress_visitor visitor(progress);
  if(is_field_needed &&
     field.compute(CGAL::parameters::visitor(std::ref(visitor))).status != FG::Distance_field_status::COMPLETE)
    throw std::runtime_error("--source: the distances of so large a mesh were given up");

  Field_curves result;
  if(request.is_matrix)
    result.matrix = distances_between(mesh, request.sources, progress);
  if(request.is_map)
    result.map = distance_map(mesh, field);
  progress.enter("following isolines");
  const double farthest = farthest_distance(mesh, field);
  const std::vector<double> levels = wanted_levels(request, farthest);
  std::set<double> found;
  const auto add_isoline = [&](const FG::Isoline<Mesh>& isoline) {
    std::ostringstream name;
    name << "at distance " << isoline.level;
    found.insert(isoline.level);
    result.curves.push_back(curve_result(triangulation, mesh, isoline, name.str(), "ISOLINE"));
  };
  with_tolerance(
      [&] { FG::isolines(mesh, field, levels, boost::make_function_output_iterator(add_isoline), tolerance); });
  result.remarks = missing_levels(levels, found, farthest, tolerance);
  if(request.spacing > 0 && request.spacing >= farthest)
    result.remarks += "no isoline at a multiple of --spacing: the farthest vertex is nearer\n";

  progress.enter("following boundaries");
  const auto add_boundary = [&](const FG::Voronoi_boundary<Mesh>& boundary) {
    const auto name = [&](int side) { return request.sources[boundary.sources[side]].name; };
    result.curves.push_back(
        curve_result(triangulation, mesh, boundary, "between " + name(0) + " and " + name(1), "BOUNDARY"));
  };
  if(request.is_diagram && !has_boundaries)
    result.remarks += "no boundary: there is only one source\n";
  if(has_boundaries)
    with_tolerance(
        [&] { FG::voronoi_boundaries(mesh, field, boost::make_function_output_iterator(add_boundary), tolerance); });
  return result;
}

} // namespace program
