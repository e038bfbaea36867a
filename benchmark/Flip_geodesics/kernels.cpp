// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The kernels under Google Benchmark, for the plain and the certified traits: a flip and its undoing, the test of an
// edge for a reflex corner, the wedge at a joint, the word of a long edge, its strip, the search and the shortening of
// one path. `--kernel NAME --count N` instead runs one kernel N times and nothing else, for an instruction counter.

#include "benchmark_meshes.h"

#include <CGAL/Flip_geodesics.h>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;

/// A path over a bumpy torus, and the triangulation before and after it is pulled tight.
template <class Traits>
class Setting
{
public:
  using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits>;
  using Network = FG::Edge_path_network<Triangulation>;

  Setting()
    : m_mesh(benchmark_meshes::torus(20000))
    , m_triangulation(m_mesh)
    , m_search(m_triangulation, CGAL::parameters::search_method(FG::Search_method::LOOK_BACK))
    , m_target(static_cast<FG::Index>(m_mesh.number_of_vertices() / 2 + 35))
    , m_path(m_search(m_source, m_target))
    , m_untouched(m_triangulation)
    , m_tight_triangulation(m_mesh)
    , m_tight(m_tight_triangulation)
  {
    m_untouched.add_curve(m_path);
    m_tight.add_curve(m_path);
    FG::shorten(m_tight);
    m_tight.for_each_segment(m_curve, [&](FG::Segment_index s) {
      const FG::Halfedge_index h = m_tight.halfedge(s);
      if(m_tight_triangulation.crossings(Triangulation::edge(h)) >
         m_tight_triangulation.crossings(Triangulation::edge(m_longest)))
        m_longest = h;
    });
    for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(1000))
      if(m_tight_triangulation.is_flippable(e.halfedge()) && m_tight.bundle(e).empty())
        m_flippable.push_back(e.halfedge());
  }

  /// The kernels by name. Each returns how many units of work it has done.
  std::map<std::string, std::function<std::size_t()>> kernels()
  {
    return {{"flip_and_undo", [this] { return flip_and_undo(); }},
            {"reflex_test", [this] { return reflex_test(); }},
            {"wedge", [this] { return wedges(); }},
            {"word_and_strip", [this] { return strip(); }},
            {"search", [this] { return m_search(m_source, m_target).size(); }},
            {"shorten_and_undo", [this] { return shorten_and_undo(); }},
            {"certify", [this] { return certify(); }}};
  }

private:
  std::size_t flip_and_undo()
  {
    const auto start = m_tight_triangulation.log_position();
    for(FG::Halfedge_index h : m_flippable) {
      m_tight_triangulation.flip(h);
      m_tight_triangulation.rollback(start);
    }
    return m_flippable.size();
  }

  std::size_t reflex_test()
  {
    for(FG::Halfedge_index h : m_flippable)
      benchmark::DoNotOptimize(m_tight_triangulation.is_reflex_at_head(h));
    return m_flippable.size();
  }

  std::size_t wedges()
  {
    std::size_t count = 0;
    m_untouched.for_each_segment(m_curve, [&](FG::Segment_index s) {
      if(m_untouched.next(s) == FG::null_index)
        return;
      benchmark::DoNotOptimize(m_untouched.wedge({s, FG::Side::LEFT}).state);
      benchmark::DoNotOptimize(m_untouched.wedge({s, FG::Side::RIGHT}).state);
      count += 2;
    });
    return count;
  }

  std::size_t strip()
  {
    const FG::internal::Strip<Triangulation> strip(m_tight_triangulation,
                                                   m_tight_triangulation.edge_sequence(m_longest));
    benchmark::DoNotOptimize(strip.end());
    return strip.portals().size();
  }

  std::size_t shorten_and_undo()
  {
    Triangulation& triangulation = m_triangulation;
    const std::size_t flips = FG::shorten(m_untouched).flips;
    m_untouched.clear();
    triangulation.rollback();
    m_untouched.add_curve(m_path);
    return flips;
  }

  std::size_t certify()
  {
    benchmark::DoNotOptimize(FG::certify(m_tight).is_locally_shortest());
    return m_tight.halfedges(m_curve).size();
  }

  Mesh m_mesh;
  Triangulation m_triangulation;
  FG::Shortest_edge_path<Triangulation> m_search;
  FG::Vertex_index m_source = FG::Vertex_index(0), m_target;
  std::vector<FG::Halfedge_index> m_path;
  Network m_untouched;
  Triangulation m_tight_triangulation;
  Network m_tight;
  FG::Curve_index m_curve = FG::Curve_index(0); // the only one in either network
  FG::Halfedge_index m_longest = FG::Halfedge_index(0);
  std::vector<FG::Halfedge_index> m_flippable;
};

using Kernel = benchmark_meshes::Kernel;
using Plain_setting = Setting<FG::Intrinsic_triangulation_traits<Kernel>>;
using Certified_setting = Setting<FG::Certified_intrinsic_triangulation_traits<Kernel>>;

template <class Setting>
void register_kernels(const std::string& traits, Setting& setting)
{
  for(const auto& [name, kernel] : setting.kernels())
    benchmark::RegisterBenchmark((traits + '/' + name).c_str(), [kernel = kernel](benchmark::State& state) {
      std::size_t units = 0;
      for([[maybe_unused]] auto _ : state)
        units += kernel();
      state.SetItemsProcessed(static_cast<std::int64_t>(units));
    });
}

// One kernel by itself; prints the number of units of work.
int run_alone(const std::string& name, long count)
{
  Plain_setting setting;
  const auto kernels = setting.kernels();
  const auto found = kernels.find(name);
  if(found == kernels.end()) {
    std::cerr << "kernels: " << name << " is not known\n";
    return 2;
  }
  std::size_t units = 0;
  for(long i = 0; i < count; ++i)
    units += found->second();
  std::cout << units << '\n';
  return std::cout.flush() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  if(argc == 5 && std::strcmp(argv[1], "--kernel") == 0 && std::strcmp(argv[3], "--count") == 0)
    return run_alone(argv[2], std::strtol(argv[4], nullptr, 10));
  Plain_setting plain;
  Certified_setting certified;
  register_kernels("plain", plain);
  register_kernels("certified", certified);
  benchmark::Initialize(&argc, argv);
  if(benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
