// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Times how long it takes to make `Geodesic_landmarks`: in one thread and in several, interleaved, by the clock on the
// wall, so that the machine should have nothing else to do. Writes a line per mesh, comma-separated, with a header:
//
//   mesh,triangles,landmarks,threads,sequential_s,parallel_s,speedup,is_same
//
// Each time is the median over the rounds; `is_same` tells whether bounds between random vertices are the same.
//
// Usage: making_landmarks [--landmarks N] [--rounds R] [--threads T] MESH...

#include "benchmark_meshes.h"

#include <CGAL/Flip_geodesics.h>

#include <CLI/CLI.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iostream>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;
using Triangulation = FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<benchmark_meshes::Kernel>>;

struct Options
{
  std::size_t landmarks = FG::Geodesic_landmarks::default_number, rounds = 5, threads = 2;
  std::vector<std::string> meshes;
};

double median(std::vector<double> seconds)
{
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

template <class ConcurrencyTag>
double make(const Triangulation& triangulation, std::size_t number, std::optional<FG::Geodesic_landmarks>& landmarks)
{
  const auto start = std::chrono::steady_clock::now();
  landmarks.emplace(triangulation, number, ConcurrencyTag());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void run(const Options& options, const std::string& name)
{
  const Mesh mesh = benchmark_meshes::make_mesh(name);
  const Triangulation triangulation(mesh);
  std::optional<FG::Geodesic_landmarks> one, several;
  std::vector<double> sequential, parallel;
  for(std::size_t round = 0; round < options.rounds; ++round) {
    sequential.push_back(make<CGAL::Sequential_tag>(triangulation, options.landmarks, one));
    parallel.push_back(make<CGAL::Parallel_if_available_tag>(triangulation, options.landmarks, several));
  }
  std::mt19937 random(1);
  const auto vertex = [&] { return FG::Vertex_index(static_cast<FG::Index>(random() % mesh.number_of_vertices())); };
  bool is_same = true;
  for(int i = 0; i < 10000; ++i) {
    const FG::Vertex_index v = vertex(), w = vertex();
    is_same = is_same && one->distance_lower_bound(v, w) == several->distance_lower_bound(v, w);
  }
  std::cout << benchmark_meshes::short_name(name) << ',' << mesh.number_of_faces() << ',' << options.landmarks << ','
            << options.threads << ',' << median(sequential) << ',' << median(parallel) << ','
            << median(sequential) / median(parallel) << ',' << is_same << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Landmarks for shortest paths, computed in one thread and in several"};
  Options options;
  app.add_option("meshes", options.meshes, "Meshes, as files or by name")->required();
  app.add_option("--landmarks", options.landmarks, "Landmarks on each mesh")->capture_default_str();
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
    std::cout << "mesh,triangles,landmarks,threads,sequential_s,parallel_s,speedup,is_same\n";
    for(const std::string& mesh : options.meshes)
      run(options, mesh);
  } catch(const std::exception& error) {
    std::cerr << "making_landmarks: " << error.what() << '\n';
    return 1;
  }
  return std::cout.flush() ? 0 : 1;
}
