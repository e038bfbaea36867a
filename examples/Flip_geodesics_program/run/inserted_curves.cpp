// SPDX-License-Identifier: LGPL-3.0-or-later

#include "messages.h"
#include "run/computations.h"
#include "run/slit_surface.h"

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/certify_curve.h>
#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/insert_curves.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

namespace FG = CGAL::Flip_geodesics;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;
using Marks = Mesh::Property_map<Mesh::Edge_index, bool>;

// The polyline of a request as it is, with its length.
Curve_result result_along(const Triangulation& triangulation, const Curve_request& request,
                          std::vector<FG::Surface_location> polyline)
{
  Curve_result result;
  result.name = request.name;
  result.is_closed = request.is_closed;
  result.is_pulled_tight = false;
  if(request.is_closed)
    polyline.push_back(polyline.front());
  result.initial_segments = polyline.size() - 1;
  result.length = 0;
  for(const FG::Surface_location& at : polyline) {
    const FG::Surface_point p = FG::surface_point(triangulation, at);
    result.points.push_back({p, FG::point_in_space(triangulation, p), true});
    if(result.points.size() > 1)
      result.length += std::sqrt(
          CGAL::squared_distance(result.points[result.points.size() - 2].in_space, result.points.back().in_space));
  }
  result.initial_length = result.length;
  return result;
}

Curve_result drawn_curve(Triangulation& triangulation, const Curve_request& request)
{
  Curve_result result = result_along(
      triangulation, request,
      FG::complete_polyline(triangulation, request.points, CGAL::parameters::is_closed(request.is_closed)));
  result.status = "DRAWN";
  return result;
}

Curve_result certified_curve(const Mesh& mesh, const Triangulation& triangulation, const Curve_request& request)
{
  const auto certificate = FG::certify_curve(mesh, request.points, CGAL::parameters::is_closed(request.is_closed));
  Curve_result result = result_along(triangulation, request, request.points);
  result.status = "GIVEN";
  result.certificate = to_string(certificate.verdict());
  // Curves that touch a vertex are written with points that differ from it by rounding errors, on either side.
  constexpr double rounding = 1e-9; // radians
  if(!certificate.is_locally_shortest() && certificate.verdict() != FG::Verdict::UNDECIDED &&
     certificate.bend <= rounding)
  {
    result.certificate = "STRAIGHT_WITHIN_ROUNDING";
  } else if(!certificate.is_locally_shortest()) {
    std::ostringstream why;
    why << "the curve is not locally shortest: " << result.certificate << " at point " << certificate.number
        << ", with a bend of " << certificate.bend << " radians";
    if(certificate.vertex != Mesh::null_vertex())
      why << " at vertex " << certificate.vertex.idx();
    if(request.is_closed && certificate.number == 0)
      why << ", where the closed curve begins and ends";
    result.error = why.str();
  }
  return result;
}

bool has_degenerate_faces(const Mesh& mesh)
{
  return std::any_of(mesh.faces_begin(), mesh.faces_end(), [&](Mesh::Face_index f) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    return CGAL::collinear(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                           mesh.point(mesh.target(mesh.next(h))));
  });
}

// A slit of one edge would have both ends in common on its two sides, and could not open: it gets a vertex in its
// middle.
void divide_single_edges(Mesh& mesh, Marks is_marked)
{
  const auto is_tip = [&](Mesh::Halfedge_index h) {
    int marked = 0;
    for(const Mesh::Halfedge_index other : CGAL::halfedges_around_target(h, mesh))
      marked += is_marked[mesh.edge(other)] || mesh.is_border(mesh.edge(other)) ? 1 : 0;
    return marked == 1;
  };
  std::vector<std::vector<Location>> middles;
  for(const Mesh::Edge_index e : mesh.edges()) {
    const Mesh::Halfedge_index h = mesh.halfedge(e, 0);
    if(!is_marked[e] || mesh.is_border(e) || !is_tip(h) || !is_tip(mesh.opposite(h)))
      continue;
    std::array<double, 3> weights = {{0, 0, 0}};
    std::size_t i = 0;
    for(const Mesh::Halfedge_index side : mesh.halfedges_around_face(mesh.halfedge(mesh.face(h)))) {
      if(side == h)
        weights[i] = weights[(i + 1) % 3] = 0.5;
      ++i;
    }
    middles.push_back({{mesh.face(h), weights}});
  }
  FG::insert_curves(mesh, middles, CGAL::parameters::edge_is_constrained_map(is_marked));
}

Mesh cut_open(const Mesh& mesh, Marks is_marked)
{
  Obstacles obstacles;
  for(const Mesh::Edge_index e : mesh.edges())
    if(is_marked[e])
      obstacles.walls.insert(e);
  return Slit_surface(mesh, obstacles).mesh();
}

// Corners of weight zero are left out.
FG::Surface_point point_in_face(const std::array<Vertex_index, 3>& corners, const std::array<double, 3>& weights)
{
  std::vector<std::size_t> used;
  for(std::size_t i = 0; i < 3; ++i)
    if(weights[i] != 0)
      used.push_back(i);
  FG::Surface_point p = {corners[used[0]], corners[used[0]], 0, FG::null_index};
  if(used.size() > 1) {
    p.b = corners[used[1]];
    p.t = weights[used[1]];
  }
  if(used.size() > 2) {
    p.c = corners[used[2]];
    p.u = weights[used[2]];
  }
  return p;
}

} // namespace

std::vector<Curve_result> drawn_curves(const Mesh& mesh, const std::vector<Network_request>& requests,
                                       Progress& progress)
{
  Triangulation triangulation(mesh);
  progress.enter("drawing");
  std::vector<Curve_result> results;
  for(const Network_request& request : requests)
    for(const Curve_request& curve : request.curves) {
      try {
        results.push_back(drawn_curve(triangulation, curve));
      } catch(const FG::Error& error) {
        throw Bad_input(curve.name + ": " + with_advice_to_repair(error));
      }
    }
  return results;
}

std::vector<Curve_result> certified_curves(const Mesh& mesh, const std::vector<Network_request>& requests,
                                           Progress& progress)
{
  const Triangulation triangulation(mesh);
  progress.enter("certifying", "curves", requests.size());
  std::vector<Curve_result> results;
  for(const Network_request& request : requests) {
    const Curve_request& curve = request.curves.front();
    try {
      results.push_back(certified_curve(mesh, triangulation, curve));
    } catch(const FG::Error& error) {
      results.emplace_back();
      results.back().name = curve.name;
      results.back().is_pulled_tight = false;
      results.back().error = with_advice_to_repair(error);
      const bool is_invalid = dynamic_cast<const FG::Invalid_curve_error*>(&error) != nullptr;
      if(is_invalid && has_degenerate_faces(mesh))
        results.back().error += "; points do not determine which sides of degenerate faces are crossed, so repair the "
                                "mesh, and compute the curves on the repaired mesh";
    }
    progress.add_steps(1);
  }
  return results;
}

Result_meshes meshes_along(const Mesh& mesh, const std::vector<Curve_result>& curves,
                           const Mesh_result_options& options, Progress& progress)
{
  Result_meshes result;
  if(options.insertion.empty() && options.cut.empty())
    return result;
  progress.enter("inserting the curves into the mesh");
  const Triangulation triangulation(mesh);
  std::vector<std::vector<Location>> locations;
  for(const Curve_result& curve : curves) {
    if(curve.points.empty())
      continue; // it could not be computed
    locations.emplace_back();
    for(const Curve_point& p : curve.points)
      locations.back().push_back(FG::face_location(triangulation, mesh, p.on_surface));
  }
  Mesh inserted = mesh;
  const Marks is_marked = inserted.add_property_map<Mesh::Edge_index, bool>("e:is_on_curve", false).first;
  try {
    FG::insert_curves(inserted, locations, CGAL::parameters::edge_is_constrained_map(is_marked));
  } catch(const FG::Invalid_curve_error&) { // consecutive points share no face; it changes between coincident vertices
    throw Bad_input("--insert and --cut: a curve passes through degenerate edges; use --repair or omit these options");
  }
  if(!options.insertion.empty())
    result.insertion = inserted;
  if(!options.cut.empty()) {
    divide_single_edges(inserted, is_marked);
    result.cut = cut_open(inserted, is_marked);
  }
  return result;
}

void sample_curves(const Mesh& mesh, double distance, std::vector<Curve_result>& curves)
{
  constexpr double most_samples = 1e7, rounding = 1e-12;
  for(Curve_result& curve : curves) {
    if(curve.points.empty())
      continue;
    double length = 0; // in space, whatever the metric of the curve
    for(std::size_t i = 1; i < curve.points.size(); ++i)
      length += std::sqrt(CGAL::squared_distance(curve.points[i - 1].in_space, curve.points[i].in_space));
    const double pieces = std::ceil((1 - rounding) * length / distance);
    if(!(pieces < most_samples))
      throw Bad_input("--sample: curve " + curve.name +
                      " would have more than 10 million points; use a larger distance");
    std::vector<FG::Surface_location> locations;
    for(const Curve_point& p : curve.points)
      locations.push_back(location_of(mesh, p.on_surface));
    curve.points.clear();
    const auto add = [&](const FG::Curve_sample<Mesh, Point_3>& sample) {
      const Mesh::Halfedge_index h = mesh.halfedge(sample.location.first);
      const std::array<Vertex_index, 3> corners = {
          {index_of(mesh.source(h)), index_of(mesh.target(h)), index_of(mesh.target(mesh.next(h)))}};
      curve.points.push_back({point_in_face(corners, sample.location.second), sample.point, true});
    };
    try {
      FG::sample_curve(mesh, locations, 1 + static_cast<std::size_t>((std::max)(1.0, pieces)),
                       boost::make_function_output_iterator(add));
    } catch(const FG::Invalid_curve_error&) { // it changes between coincident vertices
      throw Bad_input("--sample: curve " + curve.name +
                      " passes through degenerate edges; use --repair or omit --sample");
    }
  }
}

} // namespace program
