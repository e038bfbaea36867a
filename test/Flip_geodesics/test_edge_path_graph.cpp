// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE edge_path_graph

#include "Double_triangulation.h"
#include "Edge_path_graph_archetype.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = Guarded_triangulation<Double_triangulation<Mesh>>;
using Network = FG::Edge_path_network<Triangulation>;
using Archetype = Edge_path_graph_archetype<Network>;

namespace {

// Lengths are sums of rounded numbers: what they may grow by rounding alone, relatively.
constexpr double length_rounding = 4e-14;
// The engine takes an angle that misses pi by 1e-9 as straight; edges made by many flips are a little less accurate.
constexpr double angle_tolerance = 1e-7;

// Checks that each step, and each unit of a loop's steps, shortens.
struct Length_checking_visitor : FG::Default_shortening_visitor
{
  template <class Network>
  void after_flip_out(const Network& network, FG::Curve_index curve)
  {
    const double length = network.length(curve);
    require(length <= lengths[curve] * (1 + length_rounding), "a step has lengthened its curve");
    lengths[curve] = length;
    require(++steps < 100000, "the engine does not end");
  }

  FG::internal::Indexed_by<FG::Curve_index, std::vector<double>> lengths;
  int steps = 0;
};

struct Tally
{
  std::map<std::string, long> counts;
  Operation_counts operations;
  long flips = 0;

  void print(const char* title) const
  {
    std::cout << title << ':';
    for(const auto& [name, count] : counts)
      std::cout << ' ' << name << ' ' << count;
    std::cout << "; flips " << flips << ", moves " << operations.moves << ", cancellations " << operations.cancellations
              << ", perturbations " << operations.perturbations << ", restorations " << operations.restorations
              << ", on stacks " << operations.stacked_moves << ", full stars " << operations.full_stars
              << ", on one edge's two ends " << operations.own_edge_moves << ", contractions "
              << operations.contractions << std::endl;
  }
};

// Shortens the curves through the archetype, which checks every operation, and checks the end by brute force.
template <class Stop_predicate>
void shorten_and_check(Network& network, const Stop_predicate& stop, Tally& tally)
{
  Archetype archetype(network);
  Length_checking_visitor visitor;
  const auto curves = FG::internal::descriptors<FG::Curve_index>(network.number_of_curves());
  for(FG::Curve_index c : curves)
    visitor.lengths.push_back(network.length(c));
  const FG::Shortening_report report =
      FG::shorten(archetype, CGAL::parameters::stop_predicate(stop), CGAL::parameters::visitor(std::ref(visitor)));

  std::set<FG::Curve_index> shortest;
  for(FG::Curve_index c : curves) {
    const FG::Curve_report& curve = report.curves[c.idx()];
    ++tally.counts[FG::to_string(curve.status)];
    require(curve.length <= curve.initial_length * (1 + length_rounding), "a curve is longer than it was");
    require((curve.status == FG::Shortening_status::CONTRACTED) == network.is_contracted(c), "a wrong status");
    if(curve.status == FG::Shortening_status::LOCALLY_SHORTEST)
      shortest.insert(c);
  }
  require(smallest_free_angle(network, shortest) >= pi - angle_tolerance, "a joint was missed");
  tally.operations += archetype.counts();
  tally.flips += static_cast<long>(report.flips);
}

// All at once, or with a stop on the way, where steps and units are taken back.
void shorten_and_check(Network& network, Tally& tally, Random_numbers& random)
{
  if(random.below(3) == 0)
    shorten_and_check(network, FG::Curve_length_ratio_stop_predicate(random.uniform(0.5, 1)), tally);
  if(random.below(6) == 0)
    shorten_and_check(network, FG::Iteration_stop_predicate(static_cast<std::size_t>(random.below(4))), tally);
  shorten_and_check(network, FG::Never_stop_predicate(), tally);
}

struct Case
{
  const char* name;
  Mesh_soup soup;
};

std::vector<Case> cases()
{
  return {{"tetrahedron", tetrahedron(1)},
          {"cube", cube(1)},
          {"exact genus 3", genus_3_plate(1)},
          {"large torus", shaken(torus(6, 5, 2, 1), 0.1, 7)},
          {"shaken tetrahedron", shaken(tetrahedron(1), 0.4, 1)},
          {"octahedron", octahedron(1)},
          {"shaken octahedron", shaken(octahedron(1), 0.3, 2)},
          {"torus", torus(3, 3, 2, 1)},
          {"shaken torus", shaken(torus(4, 3, 2, 1), 0.2, 3)},
          {"cone disk", cone_disk(5, 1, 2)},
          {"shaken disk", shaken(flat_grid(3, 2, Diagonal_rule::RISING), 0.2, 4)},
          {"flat disk", flat_grid(2, 2, Diagonal_rule::ALTERNATING)},
          {"annulus", shaken(grid_with_hole(3, 3, 1, 2, 1, 2), 0.1, 5)},
          {"saddle", saddle_disk(6, 1, 9)},
          {"genus 3", shaken(genus_3_plate(1), 0.1, 6)}};
}

template <class Function>
void for_random_delta_complexes(int number, unsigned seed, const Function& function)
{
  int index = 0;
  for(const Case& c : cases()) {
    const Mesh mesh = to_mesh<Mesh>(c.soup);
    for(int i = 0; i < number; ++i) {
      const unsigned case_seed = seed + 1000003u * static_cast<unsigned>(++index);
      Random_numbers random(case_seed);
      try {
        Triangulation triangulation(mesh);
        flip_at_random(triangulation, random.below(60), random);
        function(triangulation, random);
      } catch(const std::exception& e) {
        BOOST_ERROR(std::string(c.name) + ", seed " + std::to_string(case_seed) + ": " + e.what());
      }
    }
  }
}

// Adds up to `number` random curves; those that cross are left out.
int add_random_curves(Network& network, int number, int steps, int percentage_closed, Random_numbers& random)
{
  std::vector<std::pair<Halfedge_sequence, bool>> accepted;
  const auto rebuild = [&] {
    network.clear();
    for(const auto& [walk, is_closed] : accepted)
      network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
  };
  for(int i = 0; i < number; ++i) {
    const bool is_closed = random.below(100) < percentage_closed;
    Halfedge_sequence walk = random_walk(network.triangulation(), 1 + random.below(steps), is_closed, random);
    if(is_closed && random.below(3) == 0)
      walk = random_loop_edge(network.triangulation(), random);
    if(walk.empty())
      continue;
    accepted.emplace_back(walk, is_closed);
    Halfedge_sequence all;
    for(const auto& a : accepted)
      all.insert(all.end(), a.first.begin(), a.first.end());
    rebuild();
    if(order_at_random(network, all, 12, random))
      continue;
    accepted.pop_back();
    rebuild();
    Halfedge_sequence rest;
    for(const auto& a : accepted)
      rest.insert(rest.end(), a.first.begin(), a.first.end());
    if(!order_at_random(network, rest, 200, random)) {
      accepted.clear();
      rebuild();
    }
  }
  return network.number_of_curves();
}

// A copy of a curve along its right side, however often the curve passes an edge.
void add_parallel_copy(Network& network, FG::Curve_index curve)
{
  std::map<FG::Segment_index, FG::Segment_index> copy_of;
  std::vector<FG::Segment_index> segments;
  network.for_each_segment(curve, [&](FG::Segment_index s) { segments.push_back(s); });
  const Halfedge_sequence halfedges = network.halfedges(curve);
  FG::Segment_index copy(network.end_of_segment_ids());
  network.add_curve(halfedges, CGAL::parameters::is_closed(network.is_closed(curve)));
  for(FG::Segment_index s : segments) {
    copy_of[s] = copy;
    ++copy;
  }
  for(FG::Halfedge_index h : halfedges) {
    const FG::Edge_index e = Triangulation::edge(h);
    std::vector<FG::Segment_index> order;
    for(FG::Segment_index s : network.bundle(e)) {
      const bool is_original = copy_of.count(s) != 0;
      if(!is_original && s >= copy_of.begin()->second)
        continue;
      if(is_original && !FG::internal::is_first_side(network.halfedge(s)))
        order.push_back(copy_of[s]);
      order.push_back(s);
      if(is_original && FG::internal::is_first_side(network.halfedge(s)))
        order.push_back(copy_of[s]);
    }
    network.set_bundle(e, order);
  }
}

// Calls `build(network, random)`, which returns whether there are valid curves, four times per complex, and shortens.
template <class Build>
void run(const char* title, int complexes, unsigned seed, const Build& build)
{
  Tally tally;
  for_random_delta_complexes(complexes * scale / stride_of_many, seed,
                             [&](Triangulation& triangulation, Random_numbers& random) {
                               const auto start = triangulation.log_position();
                               for(int i = 0; i < 4; ++i) {
                                 Network network(triangulation);
                                 if(build(network, random))
                                   shorten_and_check(network, tally, random);
                                 network.clear();
                                 triangulation.rollback(start);
                               }
                             });
  tally.print(title);
  BOOST_TEST(tally.counts["LOCALLY_SHORTEST"] > 0);
}

} // namespace

BOOST_AUTO_TEST_CASE(paths)
{
  run("paths", 150, 1,
      [](Network& network, Random_numbers& random) { return add_random_curves(network, 1, 10, 0, random) > 0; });
}

BOOST_AUTO_TEST_CASE(loops)
{
  run("loops", 300, 2,
      [](Network& network, Random_numbers& random) { return add_random_curves(network, 1, 10, 100, random) > 0; });
}

BOOST_AUTO_TEST_CASE(networks)
{
  run("networks", 60, 3,
      [](Network& network, Random_numbers& random) { return add_random_curves(network, 5, 6, 40, random) > 0; });
}

BOOST_AUTO_TEST_CASE(parallel_copies)
{
  run("parallel copies", 80, 4, [](Network& network, Random_numbers& random) {
    if(add_random_curves(network, 2, 7, 50, random) == 0)
      return false;
    for(int i = 0, curves = network.number_of_curves(); i < 3; ++i)
      add_parallel_copy(network, FG::Curve_index(random.below(curves)));
    BOOST_REQUIRE(network.is_valid());
    return true;
  });
}

BOOST_AUTO_TEST_CASE(stacked_walks)
{
  run("stacked walks", 120, 5, [](Network& network, Random_numbers& random) {
    for(int i = 0; i < 2; ++i) {
      const bool is_closed = random.below(2) == 0;
      const Halfedge_sequence walk = random_walk(network.triangulation(), 14, is_closed, random);
      if(!walk.empty())
        network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
    }
    try {
      FG::order_overlapping_curves(network);
    } catch(const FG::Crossing_curves_error&) {
      return false;
    } catch(const FG::Ambiguous_order_error&) {
      return false;
    }
    return network.number_of_curves() > 0;
  });
}

BOOST_AUTO_TEST_CASE(fixed_nodes)
{
  run("fixed nodes", 100, 6, [](Network& network, Random_numbers& random) {
    add_random_curves(network, 3, 10, 60, random);
    for(int i = 0; i < 2; ++i)
      network.fix_nodes_at(FG::Vertex_index(random.below(network.triangulation().number_of_vertices())));
    return network.number_of_curves() > 0 && network.is_valid(); // fixing an enclosed node is crossing
  });
}

// The checker itself: regions whose Euler characteristics are known, and an order that makes a difference.
BOOST_AUTO_TEST_CASE(the_signature_tells_classes_apart)
{
  const auto characteristics = [](const Mesh_soup& soup, const std::vector<Vertex_sequence>& loops) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation triangulation(mesh);
    Network network(triangulation);
    for(const Vertex_sequence& loop : loops)
      network.add_curve(FG::halfedges_through(triangulation, loop, CGAL::parameters::is_closed(true)),
                        CGAL::parameters::is_closed(true));
    std::vector<int> result;
    const Topological_signature signature{Curve_system(network)};
    for(const Topological_signature::Region& region : signature.regions())
      result.push_back(region.euler_characteristic);
    return result;
  };
  using Numbers = std::vector<int>;
  BOOST_TEST((characteristics(octahedron(1), {}) == Numbers{2}));
  BOOST_TEST((characteristics(octahedron(1), {{0_v, 2_v, 1_v, 3_v}}) == Numbers{1, 1}));
  BOOST_TEST((characteristics(octahedron(1), {{0_v, 2_v, 1_v, 3_v}, {0_v, 2_v, 1_v, 3_v}}) == Numbers{0, 1, 1}));
  BOOST_TEST((characteristics(torus(4, 3, 2, 1), {}) == Numbers{0}));
  BOOST_TEST((characteristics(torus(4, 3, 2, 1), {torus_loop(4, 3, 1, 0)}) == Numbers{0}));
  BOOST_TEST((characteristics(torus(4, 3, 2, 1), {torus_loop(4, 3, 1, 0), torus_loop(4, 3, 1, 0)}) == Numbers{0, 0}));
  BOOST_TEST((characteristics(genus_3_plate(1), {genus_3_loops(1)[0]}) == Numbers{-4}));
  BOOST_TEST((characteristics(flat_grid(2, 2, Diagonal_rule::RISING), {{0_v, 1_v, 4_v, 3_v}}) == Numbers{0, 1}));

  const Mesh mesh = to_mesh<Mesh>(octahedron(1));
  Triangulation triangulation(mesh);
  Network network(triangulation);
  for(int c = 0; c < 3; ++c)
    network.add_curve(
        FG::halfedges_through(triangulation, Vertex_sequence{0_v, 2_v, 1_v, 3_v}, CGAL::parameters::is_closed(true)),
        CGAL::parameters::is_closed(true));
  const Topological_signature before{Curve_system(network)};
  BOOST_TEST(!before.has_disk_inside(1));
  BOOST_TEST(before.has_disk_inside(2));
  for(FG::Halfedge_index h : network.halfedges(0_c)) {
    const FG::Edge_index e = Triangulation::edge(h);
    std::vector<FG::Segment_index> order = network.bundle(e);
    std::swap(order[0], order[1]); // in each edge, so that curves change places, or two cross
    network.set_bundle(e, order);
  }
  BOOST_TEST((!network.is_valid() || Topological_signature{Curve_system(network)} != before));
}

// A spur between a free and a fixed node at one vertex: what is left when it has gone is fixed.
BOOST_AUTO_TEST_CASE(a_canceled_spur_keeps_its_fixed_node)
{
  const Mesh_soup soup = {{{0, 0, 0}, {1, -1, 0}, {2, 0, 0}, {1, -0.25, 0}, {1, 2, 0}},
                          {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {3, 2, 4}}};
  const FG::Vertex_index u = 0_v, v = 1_v, b = 2_v, p = 3_v, t = 4_v;
  const Mesh mesh = to_mesh<Mesh>(soup);
  Triangulation triangulation(mesh);
  const auto to = [&](FG::Vertex_index from, FG::Vertex_index to) {
    return FG::internal::halfedge_between(triangulation, from, to);
  };
  Network network(triangulation);
  network.add_curve(Halfedge_sequence{to(u, v), to(v, b), to(b, p), to(p, t)});
  network.fix_nodes_at(p);

  std::vector<FG::Joint> affected;
  network.replace_joint({network.first_segment(0_c), FG::Side::LEFT}, {to(u, p), to(p, b)}, affected);
  const FG::Segment_index spur = network.next(network.first_segment(0_c));
  BOOST_REQUIRE(network.halfedge(spur) == to(p, b));
  BOOST_REQUIRE(network.wedge({spur, FG::Side::LEFT}).state == FG::Wedge_state::FREE);
  network.replace_joint({spur, FG::Side::LEFT}, {}, affected);
  BOOST_TEST((network.halfedges(0_c) == Halfedge_sequence{to(u, p), to(p, t)}));
  BOOST_TEST(network.is_head_fixed(network.first_segment(0_c)));
}
