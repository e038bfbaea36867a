// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes geodesics from one vertex to all others by several threads. The number of steps of each path is limited, and
// a visitor counts the flips of all paths.
//
//   parallel_paths_example MESH [STEPS [THREADS]]
//
// Prints how many paths are geodesics, and how many were not finished within STEPS steps.

#include <CGAL/Flip_geodesics/geodesic_paths.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

// All threads call the same visitor, which is passed by reference; therefore, the counter is atomic.
struct Flip_counter : FG::Default_shortening_visitor
{
  std::atomic<std::size_t> flips{0};

  template <class Triangulation>
  void on_flip(const Triangulation&, FG::Halfedge_index)
  {
    flips.fetch_add(1, std::memory_order_relaxed);
  }
};

std::size_t number(const std::string& text)
{
  std::istringstream in(text);
  std::size_t result = 0;
  if(!(in >> result && in.eof()))
    throw std::invalid_argument(text + " is not a number");
  return result;
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  const FG::Iteration_stop_predicate limit(argc > 2 ? number(argv[2]) : 100);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, argc > 3 ? number(argv[3]) : 2);

  std::vector<std::pair<Vertex, Vertex>> pairs;
  for(const Vertex v : mesh.vertices())
    pairs.emplace_back(*mesh.vertices().begin(), v);
  Flip_counter counter;
  std::vector<FG::Geodesic_path_result<Mesh::Point>> paths;
  FG::geodesic_paths<CGAL::Parallel_tag>(mesh, pairs, std::back_inserter(paths),
                                         CGAL::parameters::stop_predicate(limit),
                                         CGAL::parameters::visitor(std::ref(counter)));

  const auto count = [&](FG::Shortening_status status) {
    return std::count_if(paths.begin(), paths.end(), [&](const auto& p) { return !p.error && p.status() == status; });
  };
  std::cout << count(FG::Shortening_status::LOCALLY_SHORTEST) << " geodesics after " << counter.flips << " flips, and "
            << count(FG::Shortening_status::ITERATION_LIMIT) << " unfinished paths.\n";
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
