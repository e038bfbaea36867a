// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One path from one vertex to another by three methods: flips, with the search; the continuous Dijkstra method of
// Surface_mesh_shortest_path, which finds a globally shortest path; and the distance by Heat_method_3, which is an
// approximation and gives no path. The methods solve different problems: the two others have the distances to all
// vertices afterwards. Writes a line per pair, with a header:
//
//   mesh,triangles,source,target,flip_s,exact_build_s,exact_query_s,heat_build_s,heat_query_s,flip_length,exact_length,
//   heat_distance
//
// Usage: compare_distance_methods PAIRS MESH...

#include "benchmark_meshes.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#endif

#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Shortest_path = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

// The distance from one vertex to another, with the times to set the method up and to ask it.
struct Measurement
{
  double distance, build_s, query_s;
};

Measurement measure_exact(const Mesh& mesh, Mesh::Vertex_index source, Mesh::Vertex_index target)
{
  Measurement result = {};
  Shortest_path method(mesh);
  result.build_s = seconds([&] {
    method.add_source_point(source);
    method.build_sequence_tree();
  });
  result.query_s = seconds([&] {
    std::vector<Kernel::Point_3> points;
    result.distance = method.shortest_path_points_to_source_points(target, std::back_inserter(points)).first;
  });
  return result;
}

Measurement measure_heat([[maybe_unused]] const Mesh& mesh, [[maybe_unused]] Mesh::Vertex_index source,
                         [[maybe_unused]] Mesh::Vertex_index target)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Measurement result = {none, none, none};
#ifdef CGAL_EIGEN3_ENABLED
  using Method = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh>;
  Mesh copy = mesh;
  const auto distances = copy.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
  std::unique_ptr<Method> method;
  result.build_s = seconds([&] { method = std::make_unique<Method>(copy); });
  result.query_s = seconds([&] {
    method->add_source(source);
    method->estimate_geodesic_distances(distances);
  });
  result.distance = distances[target];
#endif
  return result;
}

void compare(const std::string& name, std::size_t pairs)
{
  const benchmark_meshes::Mesh original = benchmark_meshes::make_mesh(name);
  Mesh mesh;
  CGAL::copy_face_graph(original, mesh);
  std::mt19937 random(1);
  const auto vertex = [&] {
    return Mesh::Vertex_index(static_cast<std::uint32_t>(random() % mesh.number_of_vertices()));
  };
  for(std::size_t i = 0; i < pairs; ++i) {
    const auto source = vertex(), target = vertex();
    double flip_length = 0;
    const double flip_s = seconds([&] {
      std::vector<Kernel::Point_3> points;
      flip_length = FG::geodesic_path(mesh, source, target, std::back_inserter(points)).report.curves.front().length;
    });
    const Measurement exact = measure_exact(mesh, source, target), heat = measure_heat(mesh, source, target);
    std::cout << benchmark_meshes::short_name(name) << ',' << mesh.number_of_faces() << ','
              << static_cast<std::size_t>(source) << ',' << static_cast<std::size_t>(target) << ',' << flip_s << ','
              << exact.build_s << ',' << exact.query_s << ',' << heat.build_s << ',' << heat.query_s << ','
              << flip_length << ',' << exact.distance << ',' << heat.distance << std::endl;
  }
}

} // namespace

int main(int argc, char** argv)
{
  try {
    if(argc < 3)
      throw std::runtime_error("usage: compare_distance_methods PAIRS MESH...");
    std::cout << "mesh,triangles,source,target,flip_s,exact_build_s,exact_query_s,heat_build_s,heat_query_s,"
                 "flip_length,exact_length,heat_distance\n";
    std::cout.precision(9);
    for(int i = 2; i < argc; ++i)
      compare(argv[i], std::stoul(argv[1]));
  } catch(const std::exception& error) {
    std::cerr << "compare_distance_methods: " << error.what() << '\n';
    return 2;
  }
  return std::cout.flush() ? 0 : 1;
}
