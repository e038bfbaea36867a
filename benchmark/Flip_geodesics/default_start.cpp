// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How good the homotopy classes are in which paths start, and what it costs: local geodesics between random vertices, as
// geodesic_path() computes them, from starts that are searched in several ways, beside the lengths of shortest paths by
// add_shortest_path(). Writes a line per pair and search, with a header:
//
//   mesh,triangles,search,source,target,settled,search_s,path_s,length,shortest,excess
//
// `path_s` is the time of the search and of what makes its path a geodesic, in a triangulation that is there already;
// `excess` is by which part the geodesic is longer than the shortest path. The searches take turns, and the second round
// counts. A line per mesh and search goes to standard error: how many pairs in a hundred are more than one per cent
// longer, the largest excess, and the median time of a path, also in units of that of the first search.
//
// Usage: default_start PAIRS SEARCH[,SEARCH]... MESH...   where SEARCH is lookback, astar or dijkstra

#include "benchmark_meshes.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Search = FG::Shortest_edge_path<Triangulation>;

const std::map<std::string, FG::Search_method> search_methods = {{"lookback", FG::Search_method::LOOK_BACK},
                                                                 {"astar", FG::Search_method::A_STAR},
                                                                 {"dijkstra", FG::Search_method::DIJKSTRA}};

struct Contender
{
  std::string name;
  Search search;
  std::vector<double> times, excesses; // of the pairs
};

struct Geodesic
{
  double search_s, path_s, length;
};

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

class Start_benchmark
{
public:
  Start_benchmark(const std::string& name, const std::vector<std::string>& searches)
    : m_name(benchmark_meshes::short_name(name))
    , m_mesh(benchmark_meshes::make_mesh(name))
    , m_triangulation(m_mesh)
    , m_plain(m_triangulation)
  {
    for(const std::string& search : searches)
      m_contenders.push_back(
          {search, Search(m_triangulation, CGAL::parameters::search_method(search_methods.at(search))), {}, {}});
  }

  void run(std::size_t pairs)
  {
    std::mt19937 random(1);
    const auto vertex = [&] {
      return FG::Vertex_index(static_cast<FG::Index>(random() % m_mesh.number_of_vertices()));
    };
    for(std::size_t i = 0; i < pairs;) {
      const FG::Vertex_index source = vertex(), target = vertex();
      if(source != target && compare(source, target))
        ++i;
    }
    for(const Contender& c : m_contenders)
      summarize(c);
  }

private:
  bool compare(FG::Vertex_index source, FG::Vertex_index target)
  {
    double shortest = 0;
    try {
      Network network(m_triangulation);
      shortest = FG::add_shortest_path(network, m_plain, source, target).length;
    } catch(const FG::Disconnected_endpoints_error&) {
      return false;
    }
    m_triangulation.rollback();
    for(int round = 0; round < 2; ++round)
      for(Contender& c : m_contenders) {
        const Geodesic found = geodesic(c.search, source, target);
        if(round == 0)
          continue;
        c.times.push_back(found.path_s);
        c.excesses.push_back(found.length / shortest - 1);
        std::cout << m_name << ',' << m_mesh.number_of_faces() << ',' << c.name << ',' << source.idx() << ','
                  << target.idx() << ',' << c.search.settled_vertices() << ',' << found.search_s << ',' << found.path_s
                  << ',' << found.length << ',' << shortest << ',' << c.excesses.back() << '\n';
      }
    return true;
  }

  Geodesic geodesic(Search& search, FG::Vertex_index source, FG::Vertex_index target)
  {
    Geodesic result{};
    {
      Network network(m_triangulation);
      const double start = processor_seconds();
      const auto path = search(source, target);
      result.search_s = processor_seconds() - start;
      FG::add_straightened_path(network, path);
      const FG::Shortening_report report = FG::shorten(network);
      result.path_s = processor_seconds() - start;
      result.length = report.curves.front().length;
    }
    m_triangulation.rollback();
    return result;
  }

  void summarize(const Contender& c) const
  {
    const auto longer = std::count_if(c.excesses.begin(), c.excesses.end(), [](double e) { return e > 0.01; });
    std::cerr << m_name << ' ' << c.name << ": " << 100.0 * static_cast<double>(longer) / c.excesses.size()
              << " % are longer by more than 1 %, and the longest by "
              << 100 * *std::max_element(c.excesses.begin(), c.excesses.end()) << " %; " << 1e6 * median(c.times)
              << " us, " << median(c.times) / median(m_contenders.front().times) << '\n';
  }

  std::string m_name;
  Mesh m_mesh;
  Triangulation m_triangulation;
  Search m_plain;
  std::vector<Contender> m_contenders;
};

std::vector<std::string> split(const std::string& names)
{
  std::vector<std::string> result;
  std::istringstream in(names);
  for(std::string name; std::getline(in, name, ',');) {
    if(search_methods.count(name) == 0)
      throw std::runtime_error("there is no search " + name);
    result.push_back(name);
  }
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    if(argc < 4 || std::stoul(argv[1]) == 0 || split(argv[2]).empty())
      throw std::runtime_error("usage: default_start PAIRS SEARCH[,SEARCH]... MESH...");
    std::cout << "mesh,triangles,search,source,target,settled,search_s,path_s,length,shortest,excess\n";
    std::cout.precision(9);
    for(int i = 3; i < argc; ++i)
      Start_benchmark(argv[i], split(argv[2])).run(std::stoul(argv[1]));
  } catch(const std::exception& error) {
    std::cerr << "default_start: " << error.what() << '\n';
    return 2;
  }
  return std::cout.flush() ? 0 : 1;
}
