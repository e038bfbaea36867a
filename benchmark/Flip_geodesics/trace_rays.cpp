// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Straightest geodesics from random places in random directions, each over some edges. Writes a line per mesh, with a
// header:
//
//   mesh,triangles,rays,edges,vertices,total_s,ns_per_edge,exact_decisions
//
// Usage: trace_rays RAYS EDGES MESH...

#include "benchmark_meshes.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <cstddef>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;
using Traits = FG::Intrinsic_triangulation_traits<benchmark_meshes::Kernel>;
using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits>;

struct Start
{
  FG::Surface_location location;
  double angle;
};

std::vector<Start> random_starts(const Triangulation& triangulation, std::size_t number)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> weight(0.1, 1), angle(0, 6.28);
  std::vector<Start> result;
  while(result.size() < number) {
    const FG::Input_halfedge_index h(
        static_cast<FG::Index>(random() % static_cast<unsigned>(triangulation.number_of_halfedges())));
    if(!triangulation.input().is_border(h))
      result.push_back({{h, {{weight(random), weight(random), weight(random)}}}, angle(random)});
  }
  return result;
}

void measure(const std::string& name, std::size_t rays, std::size_t edges)
{
  const Mesh mesh = benchmark_meshes::make_mesh(name);
  const Triangulation triangulation(mesh);
  const FG::Geodesic_tracer<Triangulation> tracer(triangulation);
  const std::vector<Start> starts = random_starts(triangulation, rays);
  FG::Trace_report sum;
  const double time = seconds([&] {
    for(const Start& start : starts) {
      const FG::Trace_report trace =
          tracer.trace(start.location, FG::Surface_direction{start.location.halfedge, start.angle}, 1e100,
                       CGAL::Emptyset_iterator(), CGAL::parameters::number_of_iterations(edges));
      sum.edges += trace.edges;
      sum.vertices += trace.vertices;
      sum.statistics.by_precision += trace.statistics.by_precision + trace.statistics.by_roots;
    }
  });
  std::cout << benchmark_meshes::short_name(name) << ',' << mesh.number_of_faces() << ',' << rays << ',' << sum.edges
            << ',' << sum.vertices << ',' << time << ',' << 1e9 * time / static_cast<double>(sum.edges) << ','
            << sum.statistics.by_precision << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  try {
    if(argc < 4)
      throw std::invalid_argument("usage: trace_rays RAYS EDGES MESH...");
    std::cout << "mesh,triangles,rays,edges,vertices,total_s,ns_per_edge,exact_decisions\n";
    for(int i = 3; i < argc; ++i)
      measure(argv[i], std::stoul(argv[1]), std::stoul(argv[2]));
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
