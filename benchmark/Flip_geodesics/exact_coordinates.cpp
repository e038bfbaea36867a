// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The cost of exact coordinates: the same queries over points of a kernel of doubles and over those of
// Exact_predicates_exact_constructions_kernel, interleaved. Writes CSV, a row for each mesh, kind of coordinates and
// function; times are processor time in milliseconds, and all figures medians over the pairs of vertices.
//
//   exact_coordinates [--pairs N] [--alone KIND FUNCTION] MESH...
//
// The coordinates are `doubles`, as read from a file, or `rational`: those rotated by a matrix of rational numbers. Over
// doubles, the same mesh is compared with exact points of the same value, or with the rational points rounded. With
// `--alone`, only the queries of one function over one kind of points are run (`rounded` for doubles), for profilers.

#include "benchmark_meshes.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;

namespace {

using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_mesh = CGAL::Surface_mesh<Exact_kernel::Point_3>;

const std::vector<std::string> functions = {"geodesic_path", "shortest_path", "geodesic_distances"};

// The same point, or rotated by a rational matrix.
Exact_kernel::Point_3 exact_point(const benchmark_meshes::Point& p, bool is_rotated)
{
  const Exact_kernel::FT x = p.x(), y = p.y(), z = p.z();
  if(!is_rotated)
    return {x, y, z};
  return {(x + 2 * y + 2 * z) / 3, (2 * x + y - 2 * z) / 3, (2 * x - 2 * y + z) / 3};
}

// The faces of a mesh over other points, which are evaluated.
Exact_mesh exact_mesh(const Mesh& mesh, bool is_rotated)
{
  Exact_mesh result;
  for(const auto v : mesh.vertices())
    CGAL::exact(result.point(result.add_vertex(exact_point(mesh.point(v), is_rotated))));
  for(const auto f : mesh.faces()) {
    std::vector<Exact_mesh::Vertex_index> corners;
    for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      corners.emplace_back(v.idx());
    result.add_face(corners);
  }
  return result;
}

Mesh rounded_mesh(Mesh mesh, const Exact_mesh& exact)
{
  for(const auto v : exact.vertices()) {
    const auto& p = exact.point(v);
    mesh.point(Mesh::Vertex_index(v.idx())) = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }
  return mesh;
}

using Pair = std::array<std::uint32_t, 2>;

template <class Any_mesh>
double run(const Any_mesh& mesh, const Pair& pair, const std::string& function)
{
  using Vertex = typename Any_mesh::Vertex_index;
  const Vertex source(pair[0]), target(pair[1]);
  std::vector<typename Any_mesh::Point> points;
  if(function == functions[0])
    return FG::geodesic_path(mesh, source, target, std::back_inserter(points)).length();
  if(function == functions[1])
    return FG::shortest_path(mesh, source, target, std::back_inserter(points)).report.length;
  std::vector<double> distances(mesh.number_of_vertices());
  FG::geodesic_distances(mesh, source,
                         boost::make_iterator_property_map(distances.begin(), get(CGAL::vertex_index, mesh)));
  return distances[target.idx()];
}

std::vector<Pair> random_pairs(const Mesh& mesh, std::size_t number)
{
  std::mt19937 random(1);
  std::vector<Pair> result;
  while(result.size() < number) {
    const std::uint32_t n = mesh.number_of_vertices(), s = random() % n, t = random() % n;
    if(s != t)
      result.push_back({s, t});
  }
  return result;
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

void compare(const std::string& name, const std::string& kind, const Mesh& rounded, const Exact_mesh& exact,
             const std::vector<Pair>& pairs)
{
  for(const std::string& function : functions) {
    std::vector<double> rounded_times, exact_times, ratios;
    double difference = 0;
    for(const Pair& pair : pairs) {
      double length = 0, exact_length = 0;
      rounded_times.push_back(seconds([&] { length = run(rounded, pair, function); }));
      exact_times.push_back(seconds([&] { exact_length = run(exact, pair, function); }));
      ratios.push_back(exact_times.back() / rounded_times.back());
      difference = (std::max)(difference, std::abs(exact_length - length) / length);
    }
    std::cout << name << ',' << rounded.number_of_vertices() << ',' << kind << ',' << function << ','
              << median(rounded_times) * 1e3 << ',' << median(exact_times) * 1e3 << ',' << median(ratios) << ','
              << difference << std::endl;
  }
}

void run_alone(const Mesh& mesh, const std::string& kind, const std::string& function, const std::vector<Pair>& pairs)
{
  const Exact_mesh exact = exact_mesh(mesh, kind == "rational");
  double sum = 0;
  for(const Pair& pair : pairs)
    sum += kind == "rounded" ? run(mesh, pair, function) : run(exact, pair, function);
  std::cout << sum << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  std::size_t pairs = 15;
  std::string kind, function;
  int i = 1;
  for(; i < argc && argv[i][0] == '-'; ++i) {
    const std::string option = argv[i];
    if(option == "--pairs" && i + 1 < argc) {
      pairs = static_cast<std::size_t>(std::atoi(argv[++i]));
    } else if(option == "--alone" && i + 2 < argc) {
      kind = argv[++i];
      function = argv[++i];
    } else {
      std::cerr << "usage: exact_coordinates [--pairs N] [--alone rounded|doubles|rational FUNCTION] MESH...\n";
      return 2;
    }
  }
  std::cout.precision(4);
  if(kind.empty())
    std::cout << "mesh,vertices,coordinates,function,rounded_ms,exact_ms,ratio,relative_difference\n";
  for(; i < argc; ++i)
    try {
      const Mesh mesh = benchmark_meshes::make_mesh(argv[i]);
      const std::vector<Pair> chosen = random_pairs(mesh, pairs);
      if(!kind.empty()) {
        run_alone(mesh, kind, function, chosen);
        continue;
      }
      for(const bool is_rotated : {false, true}) {
        const Exact_mesh exact = exact_mesh(mesh, is_rotated);
        compare(benchmark_meshes::short_name(argv[i]), is_rotated ? "rational" : "doubles", rounded_mesh(mesh, exact),
                exact, chosen);
      }
    } catch(const std::exception& error) {
      std::cerr << argv[i] << ": " << error.what() << '\n';
    }
  return std::cout.flush() ? 0 : 1;
}
