// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Edges of a tree are measured from each vertex all at once, and again only where they are others.

#include "descriptors.h"
#include "generated_meshes.h"
#include "trees.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/shortest/geodesic_tree_parts.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

using namespace tree_test;

namespace {

using Triangulation = Double_tree_setting::Triangulation;
using Straightness = FG::internal::Tree_straightness<Double_tree_setting::Tree>;
using Measured_legs = FG::internal::Measured_legs;

// The edges of a tree that leave a vertex, measured.
struct Measured_fan
{
  const Triangulation& triangulation;
  Straightness& straightness;
  const FG::internal::Vertex_directions<Triangulation>& directions;
  const std::vector<Halfedge_index>& around;
  const FG::internal::Edge_end& arrival; // of the path to the vertex
  const std::vector<FG::internal::Fan_leg>& legs;
};

// Grows a tree and goes down it: visit(fan) for each vertex. The number of the tree's edges.
template <class Visit>
Index for_each_fan(const Mesh_soup& soup, const Visit& visit)
{
  Double_tree_setting setting(soup);
  const Triangulation& t = setting.triangulation;
  setting.tree.grow(17_v);
  Measured_legs measured(static_cast<std::size_t>(t.number_of_vertices()));
  Straightness straightness(setting.tree, measured);
  std::vector<std::pair<Vertex_index, FG::internal::Edge_end>> open = {{17_v, {}}};
  while(!open.empty()) {
    const auto [u, arrival] = open.back();
    open.pop_back();
    const FG::internal::Vertex_directions<Triangulation> directions(t, u);
    const std::vector<Halfedge_index> around = FG::internal::outgoing_halfedges(t, u);
    const std::vector<FG::internal::Fan_leg> legs = straightness.legs(around, arrival);
    for(const FG::internal::Fan_leg& leg : legs)
      open.emplace_back(leg.head, leg.arrival);
    visit(Measured_fan{t, straightness, directions, around, arrival, legs});
  }
  return t.number_of_vertices() - 1;
}

} // namespace

// Edges of a tree are measured from each vertex all at once: as by their words, one after the other.
BOOST_AUTO_TEST_CASE(edges_are_measured_all_at_once)
{
  int found = 0, along = 0, all = 0, vertices = 0;
  const auto compare = [&](const Measured_fan& fan) {
    const Triangulation& t = fan.triangulation;
    for(const FG::internal::Fan_leg& leg : fan.legs) {
      BOOST_TEST(leg.head == t.head(leg.start.halfedge));
      ++all;
      if(!leg.is_found)
        continue;
      const FG::internal::Strip<Triangulation> strip(t, t.edge_sequence(leg.start.halfedge));
      BOOST_TEST(strip.bend() == 0);
      const double direction = fan.directions.of_input(leg.reference()) + leg.start.direction.angle;
      BOOST_TEST(is_same_angle(direction, fan.directions(strip), fan.directions.total()));
      const FG::internal::Vertex_directions<Triangulation> at_head(t, leg.head);
      const double back = at_head.of_input(leg.arrival.direction.reference) + leg.arrival.direction.angle;
      BOOST_TEST(is_same_angle(back, at_head(t.twin(leg.start.halfedge)), at_head.total()));
      BOOST_TEST(leg.arrival.is_along == (t.crossings(t.edge(leg.start.halfedge)) < 0));
      ++(leg.arrival.is_along ? along : found);
    }
  };
  for(const Mesh_soup& soup : {bumpy_sphere(8, 0.3, 1), torus(24, 12, 3, 1), genus_3_plate(2), saddle_disk(12, 5, 9),
                               cone_disk(10, 6, 4.5), grid_with_hole(9, 9, 3, 6, 3, 6), random_convex_polyhedron(60, 2),
                               mapped(bumpy_sphere(7, 0.3, 3), [](const Coordinates& p) {
                                 return Coordinates{p[0], p[1], 0.01 * p[2]};
                               })})
  {
    vertices += for_each_fan(soup, compare);
    BOOST_TEST(all == vertices);
  }
  BOOST_TEST(along > 100);
  BOOST_TEST(found + along > 0.98 * all);
}

// Where the angles about a vertex have drifted, by the same for all edges beyond, one word is enough for all of them.
BOOST_AUTO_TEST_CASE(edges_are_measured_all_at_once_where_angles_have_drifted)
{
  constexpr double drift = 3e-8;
  int together = 0, all = 0;
  const auto compare = [&](const Measured_fan& fan) {
    const std::vector<FG::internal::Fan_leg>& legs = fan.legs;
    FG::internal::Edge_end arrival = fan.arrival;
    arrival.direction.angle += drift;
    const std::vector<FG::internal::Fan_leg> drifted = fan.straightness.legs(fan.around, arrival);
    BOOST_REQUIRE(drifted.size() == legs.size());
    for(std::size_t i = 0; i < legs.size(); ++i) {
      if(!legs[i].is_found || legs[i].arrival.is_along)
        continue;
      const auto has_same_place = [&](std::size_t j) {
        return j < legs.size() && j != i && legs[j].reference() == legs[i].reference() && !legs[j].arrival.is_along;
      };
      ++all;
      if(!has_same_place(i + 1) && !has_same_place(i - 1))
        continue;
      BOOST_TEST(drifted[i].is_found);
      BOOST_TEST(std::abs(drifted[i].start.direction.angle - legs[i].start.direction.angle) < 1e-13);
      ++together;
    }
  };
  for(const Mesh_soup& soup : {bumpy_sphere(8, 0.3, 1), torus(24, 12, 3, 1), saddle_disk(12, 5, 9)})
    for_each_fan(soup, compare);
  BOOST_TEST(together > 0.2 * all);
}

// Up to this margin, each edge is found where it is looked for, without its word.
BOOST_AUTO_TEST_CASE(edges_are_found_within_a_margin_of_their_directions)
{
  constexpr double drift = 0.75 * FG::internal::near_leg_angle;
  int found = 0;
  const auto compare = [&](const Measured_fan& fan) {
    FG::internal::Edge_end arrival = fan.arrival;
    arrival.direction.angle += drift;
    const std::vector<FG::internal::Fan_leg> drifted = fan.straightness.legs(fan.around, arrival);
    BOOST_REQUIRE(drifted.size() == fan.legs.size());
    for(std::size_t i = 0; i < fan.legs.size(); ++i) {
      BOOST_TEST(drifted[i].is_found == fan.legs[i].is_found);
      found += drifted[i].is_found && !drifted[i].arrival.is_along ? 1 : 0;
    }
  };
  for(const Mesh_soup& soup : {bumpy_sphere(8, 0.3, 1), torus(24, 12, 3, 1), saddle_disk(12, 5, 9)})
    for_each_fan(soup, compare);
  BOOST_TEST(found > 100);
}

namespace {

Measured_legs copied(const Measured_legs& measured, std::size_t size)
{
  Measured_legs result(size);
  for(Vertex_index v(0); v.idx() < static_cast<FG::Index>(size); ++v)
    result[v] = measured[v];
  return result;
}

// Is it of the edges that the path to v has now?
bool is_of_these_edges(const FG::internal::Measured_leg& leg, const Double_tree_setting& setting, Vertex_index v)
{
  const auto& t = setting.triangulation;
  const FG::Halfedge_index last = setting.tree.incoming(v), before = setting.tree.incoming(t.tail(last));
  return leg.last == last && leg.before == before && leg.last_version == t.version(t.edge(last)) &&
         leg.before_version == (before == FG::null_index ? 0 : t.version(t.edge(before)));
}

} // namespace

// What has been measured is measured again only where the tree has other edges: as if it were from the beginning.
BOOST_AUTO_TEST_CASE(measurements_are_remembered)
{
  int remembered = 0, replaced = 0;
  for(const Mesh_soup& soup : {bumpy_sphere(10, 0.5, 1), genus_3_plate(2), torus(24, 12, 3, 1)}) {
    Double_tree_setting setting(soup);
    const auto n = static_cast<std::size_t>(setting.triangulation.number_of_vertices());
    setting.tree.grow(17_v);
    Measured_legs measured(n), afresh(n);
    std::vector<Vertex_index> bent;
    Straightness(setting.tree, measured)(std::back_inserter(bent));
    std::vector<FG::Halfedge_index> before;
    for(Vertex_index v : setting.vertices()) {
      before.push_back(setting.tree.incoming(v));
      measured[v].arrival.direction.angle += 1e-13; // so that it can be told from what is measured again
    }
    FG::make_shortest(setting.tree);
    const Measured_legs old = copied(measured, n);
    const double smallest = Straightness(setting.tree, measured)(std::back_inserter(bent));
    BOOST_TEST(std::abs(smallest - Straightness(setting.tree, afresh)(std::back_inserter(bent))) < 1e-12);
    double least = std::numeric_limits<double>::infinity();
    for(Vertex_index v : setting.vertices()) {
      if(v == 17_v)
        continue;
      least = (std::min)(least, afresh[v].angle);
      BOOST_TEST((measured[v].last == setting.tree.incoming(v)));
      BOOST_TEST((measured[v].arrival.direction.angle == old[v].arrival.direction.angle) ==
                 is_of_these_edges(old[v], setting, v));
      BOOST_TEST((measured[v].angle == afresh[v].angle || std::abs(measured[v].angle - afresh[v].angle) < 1e-12));
      remembered += measured[v].arrival.direction.angle != afresh[v].arrival.direction.angle ? 1 : 0;
      replaced += before[static_cast<std::size_t>(v.idx())] != setting.tree.incoming(v) ? 1 : 0;
      // If it were of other edges.
      const auto leg = afresh[v];
      FG::Index& version = v.idx() % 2 == 0 ? afresh[v].last_version : afresh[v].before_version;
      version += v.idx() % 3 == 0 ? 0 : 1;
      afresh[v].before = v.idx() % 3 == 0 ? leg.last : leg.before;
      afresh[v].angle = 7;
      Straightness(setting.tree, afresh)(std::back_inserter(bent));
      BOOST_TEST((afresh[v].angle == leg.angle || std::abs(afresh[v].angle - leg.angle) < 1e-12));
    }
    BOOST_TEST(std::abs(smallest - least) < 1e-12);
    BOOST_TEST(bent.empty());
  }
  BOOST_TEST(remembered > 300);
  BOOST_TEST(replaced > 10);
}
