// SPDX-License-Identifier: LGPL-3.0-or-later

#include "run/traced_curves.h"

#include "advice.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <cstddef>
#include <sstream>
#include <string>

namespace program {

namespace {

namespace FG = CGAL::Flip_geodesics;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

// Where angles start: at the border, or else where those of a tree's polar coordinates do.
FG::Input_halfedge_index zero_halfedge(const Triangulation& triangulation, const Mesh& mesh, Vertex_index source)
{
  for(const auto h : CGAL::halfedges_around_source(Mesh::Vertex_index(static_cast<unsigned>(source.idx())), mesh))
    if(mesh.is_border(mesh.opposite(h)))
      return triangulation.input().index(h);
  return triangulation.input().outgoing(source);
}

Curve_result traced_curve(const Triangulation& triangulation, const Mesh& mesh,
                          const FG::Geodesic_tracer<Triangulation>& tracer, const Trace_request& request)
{
  Curve_result result;
  std::ostringstream name;
  name << "from vertex " << request.source.idx() << " at " << request.angle;
  result.name = name.str();
  result.source = request.source;
  result.is_pulled_tight = false;
  try {
    if(triangulation.input().outgoing(request.source) == FG::null_index)
      throw FG::Vertex_out_of_range_error("vertex " + std::to_string(request.source.idx()) + " is in no face");
    const FG::Trace_report trace =
        tracer.trace(triangulation.location(request.source), zero_halfedge(triangulation, mesh, request.source),
                     request.angle, FG::Trace_limits<>{request.length}, [&](const FG::Surface_point& p) {
                       result.points.push_back({p, point_in_space(triangulation, p), p.is_inside_face()});
                     });
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
                                        Progress& progress)
{
  const Triangulation triangulation(mesh);
  const FG::Geodesic_tracer<Triangulation> tracer(triangulation);
  progress.enter("tracing");
  std::vector<Curve_result> results;
  for(const Trace_request& request : requests)
    results.push_back(traced_curve(triangulation, mesh, tracer, request));
  return results;
}

} // namespace program
