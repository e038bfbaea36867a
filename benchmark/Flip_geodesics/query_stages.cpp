// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Times the stages of geodesic queries between random vertices, with Dijkstra's algorithm over the same mesh
// interleaved as the unit of measure. Writes a line per query, comma-separated, with a header:
//
//   mesh,triangles,search,source,target,edge_segments,segments,settled,dijkstra_settled,flips,construct_s,dijkstra_s,
//   search_s,shorten_s,extract_s,certify_s,rollback_s,steps_s,fresh_s,length,status,hash
//
// The paths of a search that looks back are straightened before they are pulled tight, as by geodesic_path(); that is a
// part of `shorten_s`, and its flips of `flips`. Shortest edge paths are pulled tight as they are, for comparison.
// `steps_s` is the part of `shorten_s` in which FlipOut looks at every joint and takes its steps (wedges, flips, queue,
// the path's segments), without straightening and without measuring the result; it is run twice more for that, and the
// second time counts, when all is in the caches.
//
// Each time is the median over the rounds, of processor time. `edge_segments` counts the segments of Dijkstra's path,
// `segments` those of the path that was straightened; `fresh_s` is a whole call of geodesic_path(), which makes and
// destroys a triangulation of its own, whatever the search; `hash` the bits of the extracted curve. `landmarks` looks
// back and is directed by landmarks, which are made before and not counted.
//
// Usage: query_stages [--pairs N] [--seed S] [--rounds R] [--search lookback|landmarks|astar|dijkstra] MESH...

#include "benchmark_meshes.h"
#include "edge_dijkstra.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;
using FG::Halfedge_index;
using FG::Vertex_index;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Search = FG::Shortest_edge_path<Triangulation>;

struct Options
{
  std::size_t pairs = 20, rounds = 5;
  unsigned seed = 1;
  std::string search = "lookback";
  std::vector<std::string> meshes;
};

const std::map<std::string, FG::Search_method> search_methods = {{"lookback", FG::Search_method::LOOK_BACK},
                                                                 {"landmarks", FG::Search_method::LOOK_BACK},
                                                                 {"astar", FG::Search_method::A_STAR},
                                                                 {"dijkstra", FG::Search_method::DIJKSTRA}};

enum Stage { CONSTRUCT, DIJKSTRA, SEARCH, SHORTEN, EXTRACT, CERTIFY, ROLLBACK, STEPS, FRESH, NUMBER_OF_STAGES };

/// The times of one stage over the rounds.
class Times
{
public:
  template <class Function>
  auto measure(const Function& function)
  {
    const double start = processor_seconds();
    auto result = function();
    add(processor_seconds() - start);
    return result;
  }

  void add(double seconds) { m_seconds.push_back(seconds); }

  double median()
  {
    std::nth_element(m_seconds.begin(), m_seconds.begin() + m_seconds.size() / 2, m_seconds.end());
    return m_seconds[m_seconds.size() / 2];
  }

private:
  std::vector<double> m_seconds;
};

std::uint64_t hash_of(const std::vector<FG::Surface_point>& points)
{
  std::uint64_t hash = 14695981039346656037u; // FNV-1a over words
  for(const FG::Surface_point& p : points) {
    std::uint64_t bits;
    std::memcpy(&bits, &p.t, sizeof bits);
    for(std::uint64_t word : {static_cast<std::uint64_t>(p.a.idx()), static_cast<std::uint64_t>(p.b.idx()), bits})
      hash = (hash ^ word) * 1099511628211u;
  }
  return hash;
}

class Stage_benchmark
{
public:
  Stage_benchmark(const Options& options, const std::string& name)
    : m_options(options)
    , m_name(benchmark_meshes::short_name(name))
    , m_mesh(benchmark_meshes::make_mesh(name))
    , m_triangulation(m_mesh)
    , m_search(m_triangulation, CGAL::parameters::search_method(search_methods.at(options.search)))
    , m_dijkstra(m_mesh)
  {
    if(options.search == "landmarks") {
      m_landmarks = std::make_unique<FG::Landmark_distances>(m_search);
      m_search = Search(m_triangulation, CGAL::parameters::landmarks(*m_landmarks));
    }
  }

  void run()
  {
    std::mt19937 random(m_options.seed);
    const auto vertex = [&] { return Vertex_index(static_cast<FG::Index>(random() % m_mesh.number_of_vertices())); };
    for(std::size_t i = 0; i < m_options.pairs;) {
      const Vertex_index source = vertex(), target = vertex();
      if(source != target && run(source, target))
        ++i;
    }
  }

private:
  bool run(Vertex_index source, Vertex_index target)
  {
    const Mesh::Vertex_index from = m_triangulation.vertex(source), to = m_triangulation.vertex(target);
    const std::size_t edge_segments = m_dijkstra(from, to).size();
    if(edge_segments == 0)
      return false; // another component
    std::array<Times, NUMBER_OF_STAGES> times;
    std::vector<Halfedge_index> start;
    FG::Shortening_report report;
    std::vector<FG::Surface_point> curve;
    for(std::size_t round = 0; round < m_options.rounds; ++round) {
      times[CONSTRUCT].measure([&] { return Triangulation(m_mesh).number_of_edges(); });
      times[DIJKSTRA].measure([&] { return m_dijkstra(from, to); });
      start = times[SEARCH].measure([&] { return m_search(source, target); });
      {
        Network network(m_triangulation);
        report = times[SHORTEN].measure([&] { return shorten(network, start); });
        curve = times[EXTRACT].measure(
            [&] { return FG::Curve_extractor<Network>(network).surface_points(FG::Curve_index(0)); });
        times[CERTIFY].measure([&] { return FG::certify(network).is_locally_shortest(); });
      }
      times[ROLLBACK].measure([&] {
        m_triangulation.rollback();
        return 0;
      });
      run_steps(start);
      times[STEPS].add(run_steps(start));
      times[FRESH].measure([&] {
        std::vector<Mesh::Point> points;
        FG::geodesic_path(m_mesh, from, to, std::back_inserter(points));
        return points.size();
      });
    }
    std::cout << m_name << ',' << m_mesh.number_of_faces() << ',' << m_options.search << ',' << source.idx() << ','
              << target.idx() << ',' << edge_segments << ',' << start.size() << ',' << m_search.settled_vertices()
              << ',' << m_dijkstra.settled_vertices() << ',' << report.flips;
    for(Times& stage : times)
      std::cout << ',' << stage.median();
    std::cout << ',' << report.curves[0].length << ',' << to_string(report.curves[0].status) << ',' << std::hex
              << hash_of(curve) << std::dec << std::endl;
    return true;
  }

  FG::Shortening_report shorten(Network& network, const std::vector<Halfedge_index>& start) const
  {
    const std::size_t flips = add(network, start);
    FG::Shortening_report report = FG::shorten(network);
    report.flips += flips;
    return report;
  }

  // As geodesic_path() does; shortest edge paths as they are, for comparison. Returns the number of flips.
  std::size_t add(Network& network, const std::vector<Halfedge_index>& start) const
  {
    if(m_options.search != "astar" && m_options.search != "dijkstra")
      return FG::add_straightened_path(network, start);
    network.add_curve(start);
    return 0;
  }

  // How long what shorten() does before it measures takes.
  double run_steps(const std::vector<Halfedge_index>& start)
  {
    double seconds = 0;
    {
      Network network(m_triangulation);
      add(network, start);
      const double begin = processor_seconds();
      take_steps(network);
      seconds = processor_seconds() - begin;
    }
    m_triangulation.rollback();
    return seconds;
  }

  static void take_steps(Network& network)
  {
    const FG::Never_stop_predicate never;
    FG::Default_shortening_visitor nobody;
    FG::internal::Shortening_state<Network> state(network);
    FG::internal::Flip_out<Network, FG::Never_stop_predicate, FG::Default_shortening_visitor> flip_out(network, state,
                                                                                                       never, nobody);
    flip_out.run();
  }

  const Options& m_options;
  std::string m_name;
  Mesh m_mesh;
  Triangulation m_triangulation;
  Search m_search;
  std::unique_ptr<FG::Landmark_distances> m_landmarks;
  Edge_dijkstra<Mesh> m_dijkstra;
};

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"The stages of geodesic queries"};
  Options options;
  std::set<std::string> searches;
  for(const auto& [name, method] : search_methods)
    searches.insert(name);
  app.add_option("meshes", options.meshes, "Meshes, as files or by name")->required();
  app.add_option("--pairs", options.pairs, "Pairs of vertices on each mesh")->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the random choices")->capture_default_str();
  app.add_option("--rounds", options.rounds, "Number of rounds; times are medians")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--search", options.search, "The search for initial paths")
      ->check(CLI::IsMember(searches))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << "mesh,triangles,search,source,target,edge_segments,segments,settled,dijkstra_settled,flips,"
                 "construct_s,dijkstra_s,search_s,shorten_s,extract_s,certify_s,rollback_s,steps_s,fresh_s,length,"
                 "status,hash\n";
    std::cout.precision(9);
    for(const std::string& mesh : options.meshes)
      Stage_benchmark(options, mesh).run();
  } catch(const std::exception& error) {
    std::cerr << "query_stages: " << error.what() << '\n';
    return 2;
  }
  return std::cout.flush() ? 0 : 1;
}
