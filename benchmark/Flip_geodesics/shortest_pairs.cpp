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
// With landmarks, each pair is computed without and with them in turn, and the header is:
//
//   mesh,triangles,landmarks,making_s,source,target,dijkstra_s,shortest_s,directed_s,windows,directed_windows,length
//
// The line to standard error has how long the landmarks took to make as well, in the same unit, and both times. A pair is
// named there whose lengths or verdicts differ.
//
// Usage: shortest_pairs [--landmarks NUMBER] PAIRS MESH...

#include "benchmark_meshes.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
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

// Pairs of vertices that paths join, and how long Dijkstra's algorithm takes for each.
class Pairs
{
public:
  Pairs(const Triangulation& triangulation, std::size_t number)
  {
    Search plain(triangulation, CGAL::parameters::search_method(FG::Search_method::DIJKSTRA));
    std::mt19937 random(1);
    const auto vertex = [&] {
      return FG::Vertex_index(
          static_cast<FG::Index>(random() % static_cast<unsigned>(triangulation.number_of_vertices())));
    };
    for(std::size_t i = 0; i < number; ++i) {
      const FG::Vertex_index source = vertex(), target = vertex();
      if(source == target || plain(source, target).empty())
        continue;
      m_times.push_back(seconds([&] { plain(source, target); }));
      m_ends.push_back({source, target});
    }
  }

  std::size_t size() const { return m_ends.size(); }
  FG::Vertex_index source(std::size_t i) const { return m_ends[i].first; }
  FG::Vertex_index target(std::size_t i) const { return m_ends[i].second; }
  double time(std::size_t i) const { return m_times[i]; }
  double unit() const { return quantile(m_times, 0.5); }

private:
  std::vector<std::pair<FG::Vertex_index, FG::Vertex_index>> m_ends;
  std::vector<double> m_times;
};

struct Timed_report
{
  double time = 0;
  FG::Shortest_path_report report;
};

// What `add` finds that is called with an empty network.
template <class Add>
Timed_report timed(Triangulation& triangulation, const Add& add)
{
  Network network(triangulation);
  Timed_report result;
  result.time = seconds([&] { result.report = add(network); });
  network.clear();
  triangulation.rollback();
  return result;
}

std::string quantiles(const std::vector<double>& times, double unit)
{
  std::ostringstream out;
  out << quantile(times, 0.5) / unit << ", " << quantile(times, 0.9) / unit << ", " << quantile(times, 1) / unit;
  return out.str();
}

void measure(const std::string& name, std::size_t number)
{
  const Mesh mesh = benchmark_meshes::make_mesh(name);
  Triangulation triangulation(mesh);
  Search search(triangulation, CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
  const Pairs pairs(triangulation, number);
  std::vector<double> shortest;
  for(std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [time, report] = timed(triangulation, [&](Network& network) {
      return FG::add_shortest_path(network, search, pairs.source(i), pairs.target(i));
    });
    shortest.push_back(time);
    std::cout << benchmark_meshes::short_name(name) << ',' << mesh.number_of_faces() << ',' << pairs.source(i).idx()
              << ',' << pairs.target(i).idx() << ',' << pairs.time(i) << ',' << time << ',' << report.windows << ','
              << report.first_length << ',' << report.length << ',' << report.lower_bound << ','
              << (report.is_confirmed() ? 1 : 0) << '\n';
  }
  if(!shortest.empty())
    std::cerr << benchmark_meshes::short_name(name) << ": Dijkstra " << pairs.unit() << " s; "
              << quantiles(shortest, pairs.unit()) << '\n';
}

void measure_landmarks(const std::string& name, std::size_t number, std::size_t number_of_landmarks)
{
  const Mesh mesh = benchmark_meshes::make_mesh(name);
  Triangulation triangulation(mesh);
  const std::string shown = benchmark_meshes::short_name(name);
  std::optional<FG::Geodesic_landmarks> landmarks;
  const double making = seconds([&] { landmarks.emplace(triangulation, number_of_landmarks); });
  Search search(triangulation, CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
  const Pairs pairs(triangulation, number);
  std::vector<double> shortest, directed;
  for(std::size_t i = 0; i < pairs.size(); ++i) {
    const FG::Vertex_index source = pairs.source(i), target = pairs.target(i);
    const Timed_report without =
        timed(triangulation, [&](Network& network) { return FG::add_shortest_path(network, search, source, target); });
    const Timed_report with = timed(triangulation, [&](Network& network) {
      return FG::add_shortest_path(network, search, source, target, CGAL::parameters::landmarks(*landmarks));
    });
    shortest.push_back(without.time);
    directed.push_back(with.time);
    std::cout << shown << ',' << mesh.number_of_faces() << ',' << number_of_landmarks << ',' << making << ','
              << source.idx() << ',' << target.idx() << ',' << pairs.time(i) << ',' << without.time << ',' << with.time
              << ',' << without.report.windows << ',' << with.report.windows << ',' << with.report.length << '\n';
    if(std::abs(without.report.length - with.report.length) > 1e-10 * without.report.length ||
       without.report.verdict != with.report.verdict)
      std::cerr << shown << ": " << source.idx() << " to " << target.idx() << " differ\n";
  }
  if(!shortest.empty())
    std::cerr << shown << ": Dijkstra " << pairs.unit() << " s; landmarks " << making / pairs.unit() << "; "
              << quantiles(shortest, pairs.unit()) << "; with them " << quantiles(directed, pairs.unit()) << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const bool has_landmarks = !arguments.empty() && arguments[0] == "--landmarks";
    const std::size_t first = has_landmarks ? 2 : 0;
    if(arguments.size() < first + 2)
      throw std::runtime_error("usage: shortest_pairs [--landmarks NUMBER] PAIRS MESH...");
    std::cout << (has_landmarks ? "mesh,triangles,landmarks,making_s,source,target,dijkstra_s,shortest_s,directed_s,"
                                  "windows,directed_windows,length\n"
                                : "mesh,triangles,source,target,dijkstra_s,shortest_s,windows,first_length,length,"
                                  "lower_bound,confirmed\n");
    std::cout.precision(15);
    const std::size_t pairs = std::stoul(arguments[first]);
    for(std::size_t i = first + 1; i < arguments.size(); ++i)
      if(has_landmarks)
        measure_landmarks(arguments[i], pairs, std::stoul(arguments[1]));
      else
        measure(arguments[i], pairs);
  } catch(const std::exception& error) {
    std::cerr << "shortest_pairs: " << error.what() << '\n';
    return 2;
  }
  return std::cout.flush() ? 0 : 1;
}
