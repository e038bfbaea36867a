// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Shortest paths between random vertices by add_shortest_path(), beside a plain search by Dijkstra's algorithm that stops
// at the target. Writes a line per pair, with a header:
//
//   mesh,triangles,source,target,dijkstra_s,shortest_s,windows,first_length,length,lower_bound,confirmed
//
// and a line per mesh to standard error: the median, the nine tenths' and the largest time of a pair, in units of the
// median time of Dijkstra's algorithm.
//
// Usage: shortest_pairs PAIRS MESH...

#include "benchmark_meshes.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics.h>

#include <algorithm>
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
using Network = FG::Edge_path_network<Triangulation>;
using Search = FG::Shortest_edge_path<Triangulation>;

double quantile(std::vector<double> values, double part)
{
  std::sort(values.begin(), values.end());
  const auto i = static_cast<std::size_t>(part * static_cast<double>(values.size()));
  return values[(std::min)(i, values.size() - 1)];
}

void measure(const std::string& name, std::size_t pairs)
{
  const Mesh mesh = benchmark_meshes::make_mesh(name);
  Triangulation triangulation(mesh);
  Search search(triangulation), plain(triangulation, FG::Search_method::DIJKSTRA);
  std::mt19937 random(1);
  const auto vertex = [&] {
    return FG::Vertex_index(
        static_cast<FG::Index>(random() % static_cast<unsigned>(triangulation.number_of_vertices())));
  };
  std::vector<double> dijkstra, shortest;
  for(std::size_t i = 0; i < pairs; ++i) {
    const FG::Vertex_index source = vertex(), target = vertex();
    if(source == target || plain(source, target).empty())
      continue;
    dijkstra.push_back(seconds([&] { plain(source, target); }));
    Network network(triangulation);
    FG::Shortest_path_report report;
    shortest.push_back(seconds([&] { report = FG::add_shortest_path(network, search, source, target); }));
    network.clear();
    triangulation.rollback();
    std::cout << benchmark_meshes::short_name(name) << ',' << mesh.number_of_faces() << ',' << source.idx() << ','
              << target.idx() << ',' << dijkstra.back() << ',' << shortest.back() << ',' << report.windows << ','
              << report.first_length << ',' << report.length << ',' << report.lower_bound << ','
              << (report.is_confirmed() ? 1 : 0) << '\n';
  }
  if(shortest.empty())
    return;
  const double unit = quantile(dijkstra, 0.5);
  std::cerr << benchmark_meshes::short_name(name) << ": Dijkstra " << unit << " s; " << quantile(shortest, 0.5) / unit
            << ", " << quantile(shortest, 0.9) / unit << ", " << quantile(shortest, 1) / unit << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  try {
    if(argc < 3)
      throw std::runtime_error("usage: shortest_pairs PAIRS MESH...");
    std::cout
        << "mesh,triangles,source,target,dijkstra_s,shortest_s,windows,first_length,length,lower_bound,confirmed\n";
    std::cout.precision(15);
    for(int i = 2; i < argc; ++i)
      measure(argv[i], std::stoul(argv[1]));
  } catch(const std::exception& error) {
    std::cerr << "shortest_pairs: " << error.what() << '\n';
    return 2;
  }
  return std::cout.flush() ? 0 : 1;
}
