// SPDX-License-Identifier: LGPL-3.0-or-later

#include "messages.h"
#include "run/computations.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>

#include <CGAL/boost/graph/helpers.h>

#include <functional>
#include <string>

namespace program {

namespace {

namespace FG = CGAL::Flip_geodesics;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Loops = std::vector<std::vector<FG::Halfedge_index>>;

void append(const Triangulation& triangulation, const Loops& loops, const std::string& kind,
            std::vector<Network_request>& requests)
{
  for(std::size_t i = 0; i < loops.size(); ++i) {
    Curve_request curve;
    curve.name = kind + ' ' + std::to_string(i);
    curve.is_closed = true;
    for(const FG::Halfedge_index h : loops[i])
      curve.vertices.push_back(triangulation.tail(h));
    requests.push_back({{curve}, {}, {}});
  }
}

} // namespace

std::vector<Network_request> surface_loops(const Mesh& mesh, bool are_handles_and_tunnels, Progress& progress)
try {
  const Triangulation triangulation(mesh);
  progress.enter("searching for loops", "steps");
  Progress_visitor visitor(progress);
  std::vector<Network_request> requests;
  if(are_handles_and_tunnels) {
    const FG::Handle_and_tunnel_loops loops =
        FG::handle_and_tunnel_loops(triangulation, CGAL::parameters::visitor(std::ref(visitor)));
    append(triangulation, loops.handles, "handle loop", requests);
    append(triangulation, loops.tunnels, "tunnel loop", requests);
  } else {
    const FG::Loop_basis<Triangulation> basis(triangulation, std::vector<FG::Vertex_index>(),
                                              CGAL::parameters::visitor(std::ref(visitor)));
    Loops cycles;
    for(Index i = 0; i < basis.number_of_loops(); ++i)
      cycles.push_back(basis.cycle(i));
    append(triangulation, cycles, "loop", requests);
  }
  return requests;
} catch(const FG::Error& error) {
  const bool has_no_solid = are_handles_and_tunnels && !CGAL::is_closed(mesh);
  throw Bad_input("the loops cannot be computed: " + with_advice_to_repair(error) +
                  (has_no_solid ? "; omit --handles, or close the surface" : ""));
}

} // namespace program
