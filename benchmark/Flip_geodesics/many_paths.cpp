// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Times many paths on one mesh by `geodesic_paths()`: in one thread, in several, and one call of `geodesic_path()`
// after the other, interleaved, by the clock on the wall, so that the machine should have nothing else to do; and in one
// thread without straightening the paths of edges before they are pulled tight (`plain_s`). Writes a line per mesh,
// comma-separated, with a header:
//
//   mesh,triangles,pairs,threads,one_by_one_s,sequential_s,plain_s,parallel_s,speedup,is_same
//
// Each time is the median over the rounds; `is_same` tells whether all but the plain ones gave the same points.
//
// Usage: many_paths [--pairs N] [--seed S] [--rounds R] [--threads T] MESH...

#include "benchmark_meshes.h"

#include <CGAL/Flip_geodesics.h>

#include <CLI/CLI.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;
using Vertex = Mesh::Vertex_index;
using Points = std::vector<Mesh::Point>;

struct Options
{
  std::size_t pairs = 1000, rounds = 5, threads = 2;
  unsigned seed = 1;
  std::vector<std::string> meshes;
};

/// A way to compute all paths, and the times that it took.
template <class Function>
class Timed
{
public:
  explicit Timed(Function function)
    : m_function(function)
  {
  }

  void run()
  {
    const auto start = std::chrono::steady_clock::now();
    paths = m_function();
    m_seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }

  double median()
  {
    const auto middle = m_seconds.begin() + static_cast<std::ptrdiff_t>(m_seconds.size() / 2);
    std::nth_element(m_seconds.begin(), middle, m_seconds.end());
    return *middle;
  }

  std::vector<Points> paths;

private:
  Function m_function;
  std::vector<double> m_seconds;
};

template <class ConcurrencyTag, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Points> all_at_once(const Mesh& mesh, const std::vector<std::pair<Vertex, Vertex>>& pairs,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<FG::Geodesic_path_result<Mesh::Point>> paths;
  FG::geodesic_paths<ConcurrencyTag>(mesh, pairs, std::back_inserter(paths), np);
  std::vector<Points> result;
  for(auto& path : paths)
    result.push_back(std::move(path.points));
  return result;
}

std::vector<Points> one_by_one(const Mesh& mesh, const std::vector<std::pair<Vertex, Vertex>>& pairs)
{
  std::vector<Points> result;
  for(const auto& [source, target] : pairs) {
    result.emplace_back();
    FG::geodesic_path(mesh, source, target, std::back_inserter(result.back()));
  }
  return result;
}

void run(const Options& options, const std::string& name)
{
  const Mesh mesh = benchmark_meshes::make_mesh(name);
  std::mt19937 random(options.seed);
  const auto vertex = [&] { return Vertex(static_cast<std::uint32_t>(random() % mesh.number_of_vertices())); };
  std::vector<std::pair<Vertex, Vertex>> pairs;
  while(pairs.size() < options.pairs) {
    const Vertex source = vertex(), target = vertex();
    if(source != target)
      pairs.emplace_back(source, target);
  }
  Timed single([&] { return one_by_one(mesh, pairs); });
  Timed sequential([&] { return all_at_once<CGAL::Sequential_tag>(mesh, pairs); });
  // A visitor is to see how the path of edges is pulled tight.
  FG::Default_shortening_visitor visitor;
  Timed plain(
      [&] { return all_at_once<CGAL::Sequential_tag>(mesh, pairs, CGAL::parameters::visitor(std::ref(visitor))); });
  Timed parallel([&] { return all_at_once<CGAL::Parallel_if_available_tag>(mesh, pairs); });
  for(std::size_t round = 0; round < options.rounds; ++round) {
    single.run();
    sequential.run();
    plain.run();
    parallel.run();
  }
  const bool is_same = single.paths == sequential.paths && sequential.paths == parallel.paths;
  std::cout << benchmark_meshes::short_name(name) << ',' << mesh.number_of_faces() << ',' << options.pairs << ','
            << options.threads << ',' << single.median() << ',' << sequential.median() << ',' << plain.median() << ','
            << parallel.median() << ',' << sequential.median() / parallel.median() << ',' << is_same << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Many geodesics on one mesh, in one thread and in several"};
  Options options;
  app.add_option("meshes", options.meshes, "Meshes, as files or by name")->required();
  app.add_option("--pairs", options.pairs, "Paths on each mesh")->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the random choices")->capture_default_str();
  app.add_option("--rounds", options.rounds, "Number of rounds; times are medians")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--threads", options.threads, "Maximum number of threads")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, options.threads);
#endif
    std::cout << "mesh,triangles,pairs,threads,one_by_one_s,sequential_s,plain_s,parallel_s,speedup,is_same\n";
    for(const std::string& mesh : options.meshes)
      run(options, mesh);
  } catch(const std::exception& error) {
    std::cerr << "many_paths: " << error.what() << '\n';
    return 1;
  }
  return std::cout.flush() ? 0 : 1;
}
