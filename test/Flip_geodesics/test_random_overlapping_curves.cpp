// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The order of random curves that overlap: all permutations on tiny meshes, and networks whose order is known because
// FlipOut kept it.

#define BOOST_TEST_MODULE random_overlapping_curves

#include "overlapping_world.h"

#include <CGAL/Flip_geodesics/internal/network/Bundle_order.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

// ---------------------------------------------------------------- all permutations

namespace {

using namespace CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using CGAL::Flip_geodesics::internal::descriptors;
using Halfedge_list = std::vector<Halfedge_index>;

/// Random curves on a tiny triangulation, which after random flips has loops, double edges and vertices of degree 1.
class Tiny_network
{
public:
  struct Walks
  {
    int most_curves, most_steps;
    int kept_turns; // one in so many of the turns back that a random walk makes
  };

  Tiny_network(const Mesh_soup& soup, const Walks& walks, unsigned seed)
    : m_engine(seed)
    , m_walks(walks)
    , m_world(soup)
  {
    for(int i = 0; i < below(8); ++i) {
      const Halfedge_index h(below(m_world.triangulation.number_of_halfedges()));
      if(m_world.triangulation.is_flippable(h))
        m_world.triangulation.flip(h);
    }
    const int number_of_curves = 1 + below(m_walks.most_curves);
    for(int i = 0; i < number_of_curves; ++i)
      add_walk();
    for(int i = 0; i < below(3); ++i)
      m_world.network.fix_nodes_at(Vertex_index(below(m_world.triangulation.number_of_vertices())));
  }

  Network& network() { return m_world.network; }

  /// The edges with several segments; empty if there are too many orders to try.
  bool has_few_orders() const
  {
    double count = 1;
    for(Edge_index e : descriptors<Edge_index>(m_world.triangulation.number_of_edges()))
      for(std::size_t k = m_world.network.bundle(e).size(); k > 1; --k)
        count *= static_cast<double>(k);
    return count <= 2000;
  }

  bool has_order(Index first = 0)
  {
    if(first == m_world.triangulation.number_of_edges())
      return network().is_valid();
    const Edge_index e(first);
    Segment_list bundle = network().bundle(e);
    std::sort(bundle.begin(), bundle.end());
    do {
      network().set_bundle(e, bundle);
      if(has_order(first + 1))
        return true;
    } while(std::next_permutation(bundle.begin(), bundle.end()));
    return false;
  }

private:
  int below(int bound) { return static_cast<int>(m_engine() % static_cast<unsigned>(bound)); }

  void add_walk()
  {
    const Triangulation& triangulation = m_world.triangulation;
    const int length = 1 + below(m_walks.most_steps);
    Halfedge_list walk = {Halfedge_index(below(triangulation.number_of_halfedges()))};
    while(static_cast<int>(walk.size()) < length) {
      const Halfedge_list outgoing_halfedges =
          CGAL::Flip_geodesics::internal::outgoing_halfedges(triangulation, triangulation.head(walk.back()));
      const Halfedge_index h = outgoing_halfedges[below(static_cast<int>(outgoing_halfedges.size()))];
      const bool is_kept = h != Triangulation::twin(walk.back()) || below(m_walks.kept_turns) == 0;
      if(is_kept)
        walk.push_back(h);
      else if(outgoing_halfedges.size() == 1)
        break;
    }
    const bool can_close = triangulation.head(walk.back()) == triangulation.tail(walk.front());
    network().add_curve(walk, CGAL::parameters::is_closed(can_close && below(3) > 0));
  }

  std::mt19937 m_engine;
  Walks m_walks;
  Overlapping_world m_world;
};

const std::vector<Mesh_soup>& tiny_soups()
{
  static const std::vector<Mesh_soup> soups = {single_triangle(),
                                               tetrahedron(1),
                                               octahedron(1),
                                               cylinder(3, 1, 1, 1),
                                               cylinder(3, 2, 1, 1),
                                               torus(3, 3, 2, 1),
                                               flat_grid(2, 2, Diagonal_rule::ALTERNATING)};
  return soups;
}

} // namespace

BOOST_AUTO_TEST_CASE(brute_force)
{
  int ordered = 0, crossing = 0, ambiguous = 0, skipped = 0;
  for(unsigned seed = 1; seed <= 20000; ++seed) {
    Tiny_network tiny(tiny_soups()[seed % tiny_soups().size()], {3, 6, 3}, seed);
    if(!tiny.has_few_orders()) {
      ++skipped;
      continue;
    }
    const bool has_order = tiny.has_order();
    bool is_ordered = false;
    try {
      order_overlapping_curves(tiny.network());
      is_ordered = true;
      BOOST_TEST(tiny.network().is_valid(), "invalid at seed " << seed);
    } catch(const Crossing_curves_error&) {
      ++crossing;
    } catch(const Ambiguous_order_error&) {
      ++ambiguous;
    }
    ordered += is_ordered ? 1 : 0;
    BOOST_TEST(has_order == is_ordered, "disagreement at seed " << seed);
  }
  BOOST_TEST_MESSAGE("ordered " << ordered << ", crossing " << crossing << ", skipped " << skipped);
  BOOST_TEST(ambiguous == 0);
  BOOST_TEST(ordered > 1000);
  BOOST_TEST(crossing > 1000);
}

// Walks that turn back again and again.
BOOST_AUTO_TEST_CASE(long_walks)
{
  int ordered = 0, crossing = 0;
  for(unsigned seed = 6500; seed < 7000; ++seed) {
    Tiny_network tiny(tiny_soups()[seed % tiny_soups().size()], {1, 30, 1}, seed);
    try {
      order_overlapping_curves(tiny.network());
      BOOST_TEST(tiny.network().is_valid(), "invalid at seed " << seed);
      ++ordered;
    } catch(const Crossing_curves_error&) {
      ++crossing;
    }
  }
  BOOST_TEST(ordered > 200);
  BOOST_TEST(crossing > 200);
}

// No two or three of their equations contradict each other, but a sum of many does; a search alone was given up.
BOOST_AUTO_TEST_CASE(walks_that_cross_by_a_sum_of_equations)
{
  for(unsigned seed : {595u, 2982u}) {
    Tiny_network tiny(tiny_soups()[seed % tiny_soups().size()], {1, 100, 1}, seed);
    BOOST_CHECK_THROW(order_overlapping_curves(tiny.network()), Crossing_curves_error);
  }
}

// What sums of equations say of one unknown or two is known before any order is searched.
BOOST_AUTO_TEST_CASE(no_sum_of_long_equations_is_short)
{
  std::size_t rows = 0;
  for(unsigned seed = 1; seed <= 2000; ++seed) {
    Tiny_network tiny(tiny_soups()[seed % tiny_soups().size()], {1, 60, 1}, seed);
    const CGAL::Flip_geodesics::internal::Bundle_pairs<Network> pairs(tiny.network());
    if(pairs.conflict())
      continue;
    CGAL::Flip_geodesics::internal::Crossing_equations<Network> equations(pairs);
    if(equations.conflict())
      continue;
    CGAL::Flip_geodesics::internal::Parity_elimination elimination;
    for(const auto& equation : equations.long_equations()) {
      const auto sum = equations.sum(equation);
      std::vector<Index> variables(sum.variables.begin(), sum.variables.begin() + sum.size);
      std::sort(variables.begin(), variables.end());
      BOOST_TEST(elimination.add({std::move(variables), sum.parity, equation.vertex}));
    }
    for(const auto& row : elimination.rows())
      BOOST_TEST(row.second.variables.size() > 2u, "seed " << seed);
    rows += elimination.rows().size();
  }
  BOOST_TEST(rows > 1000u);
}

// ---------------------------------------------------------------- networks that FlipOut has pulled together

namespace {

/// A segment, and whether it is followed from its head to its tail.
struct Segment
{
  Segment_index segment;
  bool is_reversed;
};

/// Decides pairs by following both strands until they part, and nothing else: an independent, incomplete rule.
class Walker
{
public:
  explicit Walker(const Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
  {
  }

  /// 1 if s is left of t as seen along s, -1 if right, 0 if where they part does not say.
  int side(Segment_index s, Segment_index t) const
  {
    const bool is_opposite = m_network.halfedge(s) != m_network.halfedge(t);
    const int forward = side_ahead({s, false}, {t, is_opposite});
    const int backward = -side_ahead({s, true}, {t, !is_opposite});
    BOOST_TEST((forward == 0 || backward == 0 || forward == backward));
    return forward != 0 ? forward : backward;
  }

private:
  Halfedge_index halfedge(const Segment& segment) const
  {
    const Halfedge_index h = m_network.halfedge(segment.segment);
    return segment.is_reversed ? Triangulation::twin(h) : h;
  }

  bool advance(Segment& segment) const
  {
    const Segment_index previous = m_network.previous(segment.segment);
    const Segment_index incoming = segment.is_reversed ? previous : segment.segment;
    if(incoming == null_index || m_network.is_head_fixed(incoming))
      return false;
    segment.segment = segment.is_reversed ? previous : m_network.next(segment.segment);
    return true;
  }

  int side_ahead(Segment s, Segment t) const
  {
    for(Index i = 0; i < m_network.end_of_segment_ids(); ++i) {
      const Halfedge_index back = Triangulation::twin(halfedge(s));
      if(!advance(s) || !advance(t) || halfedge(s) == back || halfedge(t) == back)
        return 0;
      if(halfedge(s) != halfedge(t))
        return clockwise_distance(back, halfedge(s)) < clockwise_distance(back, halfedge(t)) ? 1 : -1;
    }
    return 0;
  }

  std::ptrdiff_t clockwise_distance(Halfedge_index from, Halfedge_index to) const
  {
    const Halfedge_list outgoing_halfedges =
        CGAL::Flip_geodesics::internal::outgoing_halfedges(m_triangulation, m_triangulation.tail(from));
    const auto position = [&](Halfedge_index h) {
      return std::find(outgoing_halfedges.begin(), outgoing_halfedges.end(), h) - outgoing_halfedges.begin();
    };
    const auto size = static_cast<std::ptrdiff_t>(outgoing_halfedges.size());
    return (position(to) - position(from) + size) % size;
  }

  const Network& m_network;
  const Triangulation& m_triangulation;
};

/// The number of pairs that `Walker` decides, all as the stacks have them.
int check_decided_pairs(const Network& network)
{
  const Walker walker(network);
  int decided = 0;
  for(Edge_index e : descriptors<Edge_index>(network.triangulation().number_of_edges())) {
    const Segment_list bundle = network.bundle(e);
    for(std::size_t i = 0; i < bundle.size(); ++i)
      for(std::size_t j = i + 1; j < bundle.size(); ++j) {
        const int side = walker.side(bundle[i], bundle[j]);
        const bool is_along = network.halfedge(bundle[i]) == CGAL::Flip_geodesics::internal::first_side(e);
        BOOST_TEST(side != (is_along ? -1 : 1));
        decided += side != 0 ? 1 : 0;
      }
  }
  return decided;
}

struct Saved_curve
{
  Halfedge_list halfedges;
  bool is_closed;
};

/// Clears a network and adds its curves again, so that their order is lost; those that have contracted are left out.
void rebuild(Network& network)
{
  std::vector<Saved_curve> curves;
  for(Curve_index c : descriptors<Curve_index>(network.number_of_curves()))
    if(!network.is_contracted(c))
      curves.push_back({network.halfedges(c), network.is_closed(c)});
  network.clear();
  for(const Saved_curve& curve : curves)
    network.add_curve(curve.halfedges, CGAL::parameters::is_closed(curve.is_closed));
}

/// Random shortest edge paths through two or three vertices, as many out of `candidates` as do not cross.
void add_random_curves(Overlapping_world& world, std::mt19937& engine, int candidates)
{
  const auto n = static_cast<unsigned>(world.triangulation.number_of_vertices());
  Shortest_edge_path<Triangulation> search(world.triangulation);
  std::vector<Saved_curve> accepted;
  for(int i = 0; i < candidates; ++i) {
    const bool is_closed = engine() % 3 == 0;
    const auto vertex = [&] { return Vertex_index(static_cast<Index>(engine() % n)); };
    const Vertex_sequence points = {vertex(), vertex(), vertex()};
    if(points[0] == points[1] || points[1] == points[2] || points[2] == points[0])
      continue;
    accepted.push_back({shortest_halfedges_through(search, points, CGAL::parameters::is_closed(is_closed)), is_closed});
    world.network.clear();
    for(const Saved_curve& curve : accepted)
      world.network.add_curve(curve.halfedges, CGAL::parameters::is_closed(curve.is_closed));
    try {
      order_overlapping_curves(world.network);
    } catch(const Crossing_curves_error&) {
      accepted.pop_back();
    }
  }
  world.network.clear();
  for(const Saved_curve& curve : accepted)
    world.network.add_curve(curve.halfedges, CGAL::parameters::is_closed(curve.is_closed));
}

} // namespace

BOOST_AUTO_TEST_CASE(shortened_networks)
{
  const std::vector<Mesh_soup> soups = {bumpy_sphere(3, 0.3, 1), torus(8, 6, 2, 1), genus_3_plate(1),
                                        jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 1),
                                        grid_with_hole(7, 7, 3, 5, 3, 5)};
  int decided = 0, curves = 0;
  for(unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937 engine(seed);
    Overlapping_world world(soups[seed % soups.size()]);
    add_random_curves(world, engine, 30);
    world.order();
    curves += world.network.number_of_curves();
    for(int round = 0; round < 4; ++round) {
      decided += check_decided_pairs(world.network);
      rebuild(world.network);
      world.order();
      decided += check_decided_pairs(world.network);
      shorten(world.network, CGAL::parameters::stop_predicate(Iteration_stop_predicate(engine() % 20)));
      BOOST_TEST(world.network.is_valid(), "shorten left the network invalid at seed " << seed);
    }
  }
  BOOST_TEST_MESSAGE("curves " << curves << ", decided pairs " << decided);
  BOOST_TEST(curves > 1000);
  BOOST_TEST(decided > 10000);
}

BOOST_AUTO_TEST_CASE(parallel_torus_loops)
{
  for(auto [p, q] : {std::make_pair(1, 0), std::make_pair(2, 1), std::make_pair(3, 2), std::make_pair(-2, 3)}) {
    Overlapping_world world(torus(9, 7, 2, 1));
    const Vertex_sequence loop = torus_loop(9, 7, p, q);
    for(int i = 0; i < 4; ++i) {
      Vertex_sequence copy = loop;
      std::rotate(copy.begin(), copy.begin() + 2 * i, copy.end());
      if(i % 2 == 1)
        std::reverse(copy.begin(), copy.end());
      world.add(copy, true);
    }
    world.order();
    check_decided_pairs(world.network);
    shorten(world.network, CGAL::parameters::stop_predicate(Iteration_stop_predicate(100)));
    BOOST_TEST(world.network.is_valid());
    rebuild(world.network);
    world.order();
  }
}
