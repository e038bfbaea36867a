// SPDX-License-Identifier: LGPL-3.0-or-later

#include "messages.h"
#include "run/computations.h"
#include "run/slit_surface.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/surface_points.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <boost/math/constants/constants.hpp>

#include <sstream>
#include <string>
#include <type_traits>

namespace program {

namespace {

namespace FG = CGAL::Flip_geodesics;
// Where angles start: at the border, or else where those of a tree's polar coordinates do.
template <class Triangulation>
FG::Input_halfedge_index zero_halfedge(const Triangulation& triangulation, const Mesh& mesh, Vertex_index source)
{
  for(const auto h : CGAL::halfedges_around_source(mesh_vertex(source), mesh))
    if(mesh.is_border(mesh.opposite(h)))
      return triangulation.input().index(h);
  return triangulation.input().outgoing(source);
}

template <class Triangulation>
Curve_result traced_curve(const Triangulation& triangulation, const Mesh& mesh,
                          const FG::Geodesic_tracer<Triangulation>& tracer, const Trace_request& request)
{
  Curve_result result;
  std::ostringstream name;
  name << "from " << request.source.name << " at " << request.angle;
  result.name = name.str();
  result.is_pulled_tight = false;
  FG::Input_halfedge_index zero = request.source.at.halfedge;
  if(const FG::Surface_point p = FG::surface_point(triangulation, request.source.at); p.is_vertex()) {
    result.source = p.a;
    zero = zero_halfedge(triangulation, mesh, p.a);
  }
  try {
    std::vector<FG::Surface_point> points;
    const double angle = request.angle + (request.is_reversed ? boost::math::constants::pi<double>() : 0);
    const FG::Trace_report trace =
        tracer.trace(request.source.at, FG::Surface_direction{zero, angle}, request.length, std::back_inserter(points));
    for(const FG::Surface_point& p : points)
      result.points.push_back({p, point_in_space(triangulation, p), p.is_inside_face()});
    result.status = to_string(trace.status);
    result.length = trace.length;
    result.initial_length = trace.length;
    result.initial_segments = result.points.size() - 1;
  } catch(const FG::Error& error) {
    result.points.clear();
    result.error = with_advice_to_repair(error);
  }
  return result;
}

} // namespace

std::vector<Curve_result> traced_curves(const Mesh& mesh, const std::vector<Trace_request>& requests,
                                        const Path_conditions& conditions, Progress& progress)
{
  const Slit_surface surface(mesh, conditions.obstacles);
  std::vector<Curve_result> results;
  with_metric(surface, conditions, [&](const auto& metric) {
    using Metric = std::decay_t<decltype(metric)>;
    using Triangulation = FG::Intrinsic_triangulation<Mesh, FG::Default_traits<Metric>, Metric>;
    const Triangulation triangulation(surface.mesh(), metric);
    const FG::Geodesic_tracer<Triangulation> tracer(triangulation);
    progress.enter("tracing", "curves", requests.size());
    for(Trace_request request : requests) {
      request.source.at = located(surface, request.source);
      results.push_back(traced_curve(triangulation, surface.mesh(), tracer, request));
      surface.put_on_mesh(results.back());
      progress.add_steps(1);
    }
  });
  return results;
}

} // namespace program
