// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE geodesic_tree

#include "Curve_setting.h"
#include "Double_triangulation.h"
#include "closed_forms.h"
#include "descriptors.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/logarithmic_map.h>
#include <CGAL/Flip_geodesics/make_shortest.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Halfedge_index;
using FG::Index;
using FG::Vertex_index;
using FG::internal::twin_index;
using namespace Flip_geodesics_test;

using Certified_setting = Basic_curve_setting<
    FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>>;

namespace {

constexpr double tolerance = 1e-10;

bool is_close(double a, double b, double scale = 1) { return std::abs(a - b) <= tolerance * scale; }

template <class Setting>
struct Tree_setting : Setting
{
  using Tree = FG::Geodesic_tree<typename Setting::Triangulation>;

  explicit Tree_setting(const Mesh_soup& soup)
    : Setting(soup)
    , tree(this->triangulation)
  {
  }

  Index size() const { return this->triangulation.number_of_vertices(); }
  auto vertices() const { return FG::internal::descriptors<Vertex_index>(size()); }

  Tree tree;
};

using Double_tree_setting = Tree_setting<Curve_setting>;

// What must hold of any tree: the invariant, a locally shortest path to every vertex, and no crossing among them, which
// putting them all into one network shows.
template <class Setting>
void check_tree(Setting& setting, const FG::Geodesic_tree_report& report)
{
  BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
  BOOST_TEST(report.smallest_angle >= FG::Straightness::straight_angle());
  BOOST_TEST(setting.tree.is_valid());
  BOOST_TEST(setting.triangulation.is_valid());
  for(Vertex_index v : setting.vertices()) {
    const std::vector<Halfedge_index> path = setting.tree.path(v);
    if(path.empty())
      continue;
    BOOST_TEST(setting.triangulation.tail(path.front()) == setting.tree.source());
    BOOST_TEST(setting.triangulation.head(path.back()) == v);
    const FG::Curve_index curve = setting.network.add_curve(path, false);
    BOOST_TEST(is_close(setting.network.length(curve), setting.tree.distance(v), setting.tree.distance(v)));
  }
  const auto pulled = setting.pull();
  BOOST_TEST(pulled.flip_outs == 0u);
  BOOST_TEST(pulled.is_complete());
  setting.network.clear();
}

// The angle from the ray of direction 0 to a point of the plane, in [0, 2 pi).
double plane_angle(double x, double y)
{
  const double angle = std::atan2(y, x);
  return angle < 0 ? angle + 2 * pi : angle;
}

// Angles that differ by a full turn are the same.
bool is_same_angle(double a, double b, double total)
{
  const double difference = std::remainder(a - b, total);
  return std::abs(difference) <= 1e-9;
}

// The edge from one vertex to another, before it is flipped.
FG::Input_halfedge_index direction(const Double_tree_setting& setting, Vertex_index from, Vertex_index to)
{
  return FG::internal::as_input(FG::halfedges_through(setting.triangulation, Vertex_sequence{from, to}, false).front());
}

struct Impatient : FG::Default_shortening_visitor
{
  int steps = 0, flips = 0;
  template <class Triangulation>
  void on_flip(const Triangulation&, Halfedge_index)
  {
    ++flips;
  }
  bool go_further() { return ++steps <= 100; }
};

} // namespace

BOOST_AUTO_TEST_CASE(plane)
{
  constexpr int n = 12, m = 9;
  for(const Mesh_soup& soup : {flat_grid(n, m, Diagonal_rule::RISING), flat_grid(n, m, Diagonal_rule::RANDOM),
                               jittered_grid(n, m, Diagonal_rule::RANDOM, 0.24, 3), needle_strip(n, m, 1e-4)})
  {
    const Vertex_index inner(grid_vertex(n, 5, 4)), corner(grid_vertex(n, 0, 0)), on_side(grid_vertex(n, n, 3));
    for(Vertex_index source : {inner, corner, on_side}) {
      Double_tree_setting setting(soup);
      check_tree(setting, setting.tree.grow(source));
      const Coordinates& s = soup.points[source.idx()];
      const FG::Logarithmic_map map = FG::logarithmic_map(setting.tree);
      // Any vertex fixes the rotation; the others must agree.
      const auto plane_angle_of = [&](Vertex_index v) {
        return plane_angle(soup.points[v.idx()][0] - s[0], soup.points[v.idx()][1] - s[1]);
      };
      const Vertex_index other = source == 0_v ? 1_v : 0_v;
      const double turn = plane_angle_of(other) - map.vertices[other].angle;
      for(Vertex_index v : setting.vertices()) {
        if(v == source)
          continue;
        const FG::Polar_coordinates& p = map.vertices[v];
        BOOST_TEST(is_close(p.radius, distance(s, soup.points[v.idx()]), n));
        BOOST_TEST(is_same_angle(p.angle + turn, plane_angle_of(v), 2 * pi));
        BOOST_TEST(p.angle >= 0);
        BOOST_TEST(p.angle <= map.total_angle + tolerance);
      }
      BOOST_TEST(map.vertices[source].radius == 0);
      BOOST_TEST(std::isnan(map.vertices[source].angle));
      BOOST_TEST(map.is_on_border == (source != inner));
      if(!map.is_on_border)
        BOOST_TEST(is_close(map.total_angle, 2 * pi));
    }
  }
}

// Paths to one vertex on either side of a needle have one length but for rounding: none may be waited for for ever.
BOOST_AUTO_TEST_CASE(jittered_needles)
{
  constexpr int n = 40;
  for(double aspect : {1e-4, 1e-6}) {
    const auto squeezed = [aspect](const Coordinates& p) { return Coordinates{p[0], p[1] * aspect, 0}; };
    const Mesh_soup soup = mapped(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.15, 11), squeezed);
    for(Vertex_index source : {0_v, Vertex_index(grid_vertex(n, 20, 20)), Vertex_index(grid_vertex(n, 31, 7))}) {
      Double_tree_setting setting(soup);
      const FG::Geodesic_tree_report report = setting.tree.grow(source);
      BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
      BOOST_TEST(setting.tree.is_valid());
      for(Vertex_index v : setting.vertices())
        BOOST_TEST(is_close(setting.tree.distance(v), distance(soup.points[source.idx()], soup.points[v.idx()]), n));
    }
  }
}

// The zero direction is that of an edge of the caller's choice, and the map in the plane is an isometry there.
BOOST_AUTO_TEST_CASE(plane_coordinates)
{
  constexpr int n = 8;
  const Mesh_soup soup = jittered_grid(n, n, Diagonal_rule::RISING, 0.2, 5);
  Double_tree_setting setting(soup);
  const Vertex_index source(grid_vertex(n, 4, 4)), right(grid_vertex(n, 5, 4));
  const FG::Input_halfedge_index zero = direction(setting, source, right);
  setting.tree.grow(source);
  const FG::Logarithmic_map map = FG::logarithmic_map(setting.tree, zero);
  const Coordinates &s = soup.points[source.idx()], &r = soup.points[right.idx()];
  const double length = distance(s, r), c = (r[0] - s[0]) / length, d = (r[1] - s[1]) / length;
  for(Vertex_index v : setting.vertices()) {
    const double x = soup.points[v.idx()][0] - s[0], y = soup.points[v.idx()][1] - s[1];
    BOOST_TEST(is_close(map.in_plane(v)[0], c * x + d * y, n));
    BOOST_TEST(is_close(map.in_plane(v)[1], c * y - d * x, n));
  }
}

// The map of a cylinder unrolls it: each vertex comes to lie over one of the places that it has in the unrolled plane.
BOOST_AUTO_TEST_CASE(cylinder_unrolls)
{
  constexpr int n = 9, m = 7;
  constexpr double radius = 1.25, height = 8;
  const double side = polygon_side(n, radius);
  Double_tree_setting setting(cylinder(n, m, radius, height));
  const Vertex_index source(4 + n * 3), right(source.idx() + 1);
  const FG::Input_halfedge_index zero = direction(setting, source, right);
  check_tree(setting, setting.tree.grow(source));
  const FG::Logarithmic_map map = FG::logarithmic_map(setting.tree, zero);
  int minimal = 0;
  for(Vertex_index v : setting.vertices()) {
    const auto [x, y] = map.in_plane(v);
    const double turns = (x / side - (v.idx() % n - source.idx() % n)) / n;
    BOOST_TEST(is_close(turns, std::round(turns)), "vertex " << v.idx());
    BOOST_TEST(is_close(y, height * (v.idx() / n - source.idx() / n) / m, height));
    const double shortest = cylinder_distance(n, m, radius, height, source.idx(), v.idx());
    BOOST_TEST(map.vertices[v].radius >= shortest * (1 - tolerance));
    minimal += is_close(map.vertices[v].radius, shortest, height) ? 1 : 0;
  }
  BOOST_TEST(minimal >= setting.size() * 9 / 10);
}

BOOST_AUTO_TEST_CASE(cone_from_the_apex_and_from_elsewhere)
{
  constexpr int n = 10, m = 6;
  constexpr double total = 4.5;
  Double_tree_setting setting(cone_disk(n, m, total));
  check_tree(setting, setting.tree.grow(0_v));
  const FG::Logarithmic_map from_apex = FG::logarithmic_map(setting.tree);
  BOOST_TEST(is_close(from_apex.total_angle, total));
  const double first = from_apex.vertices[FG::Vertex_index(disk_vertex(n, 1, 0))].angle;
  for(int r = 1; r <= m; ++r)
    for(int i = 0; i < n; ++i) {
      const FG::Polar_coordinates& p = from_apex.vertices[FG::Vertex_index(disk_vertex(n, r, i))];
      BOOST_TEST(is_close(p.radius, r, m));
      BOOST_TEST(is_same_angle(p.angle - first, i * total / n, total));
    }

  setting.triangulation.rollback();
  const Vertex_index source(disk_vertex(n, 4, 0));
  check_tree(setting, setting.tree.grow(source));
  const FG::Logarithmic_map map = FG::logarithmic_map(setting.tree);
  const double to_apex = map.vertices[0_v].angle;
  for(int r = 1; r <= m; ++r)
    for(int i = 1; i < n; ++i) {
      // Beside the apex on one side or the other, a triangle with it and the source.
      const FG::Polar_coordinates& p = map.vertices[FG::Vertex_index(disk_vertex(n, r, i))];
      const bool is_on_left = is_close(p.radius, cone_distance(4, r, i * total / n), m);
      const double around = is_on_left ? i * total / n : (n - i) * total / n;
      BOOST_TEST(is_close(p.radius, cone_distance(4, r, around), m));
      if(around < pi) {
        const double at_source = std::atan2(r * std::sin(around), 4 - r * std::cos(around));
        BOOST_TEST((is_same_angle(p.angle, to_apex + at_source, map.total_angle) ||
                    is_same_angle(p.angle, to_apex - at_source, map.total_angle)));
      }
    }
}

// Behind a saddle all paths pass it, and start in its direction.
BOOST_AUTO_TEST_CASE(shadow_of_a_saddle)
{
  constexpr int k = 12, m = 5;
  constexpr double total = 9;
  Double_tree_setting setting(saddle_disk(k, m, total));
  const Vertex_index source(disk_vertex(k, 3, 0));
  check_tree(setting, setting.tree.grow(source));
  const FG::Logarithmic_map map = FG::logarithmic_map(setting.tree);
  int in_shadow = 0;
  for(int r = 1; r <= m; ++r)
    for(int i = 1; i < k; ++i) {
      const FG::Polar_coordinates& p = map.vertices[FG::Vertex_index(disk_vertex(k, r, i))];
      const double around = (std::min)(i, k - i) * total / k;
      BOOST_TEST(is_close(p.radius, cone_distance(3, r, around), m));
      if(around < pi)
        continue;
      ++in_shadow;
      BOOST_TEST(is_same_angle(p.angle, map.vertices[0_v].angle, map.total_angle));
    }
  BOOST_TEST(in_shadow > 0);
}

BOOST_AUTO_TEST_CASE(curved_meshes)
{
  for(const Mesh_soup& soup : {sphere(8), bumpy_sphere(8, 0.3, 1), torus(24, 12, 3, 1), genus_3_plate(2), cube(4),
                               tetrahedron(5), random_convex_polyhedron(60, 2), grid_with_hole(9, 9, 3, 6, 3, 6)})
  {
    for(Vertex_index source : {0_v, 7_v, 40_v}) {
      Double_tree_setting setting(soup);
      check_tree(setting, setting.tree.grow(source));
      for(Vertex_index v : setting.vertices())
        BOOST_TEST(setting.tree.is_reached(v));
    }
  }
}

// Edges of a tree are measured from each vertex all at once: as by their words, one after the other.
BOOST_AUTO_TEST_CASE(edges_are_measured_all_at_once)
{
  using Triangulation = Double_tree_setting::Triangulation;
  using Straightness = FG::internal::Tree_straightness<Double_tree_setting::Tree>;
  int found = 0, along = 0, all = 0, vertices = 0;
  for(const Mesh_soup& soup : {bumpy_sphere(8, 0.3, 1), torus(24, 12, 3, 1), genus_3_plate(2), saddle_disk(12, 5, 9),
                               cone_disk(10, 6, 4.5), grid_with_hole(9, 9, 3, 6, 3, 6), random_convex_polyhedron(60, 2),
                               mapped(bumpy_sphere(7, 0.3, 3), [](const Coordinates& p) {
                                 return Coordinates{p[0], p[1], 0.01 * p[2]};
                               })})
  {
    Double_tree_setting setting(soup);
    const Triangulation& t = setting.triangulation;
    setting.tree.grow(17_v);
    Straightness::Measured_legs measured(static_cast<std::size_t>(t.number_of_vertices()));
    Straightness straightness(setting.tree, measured);
    std::vector<std::pair<Vertex_index, FG::internal::Spoke_place>> open = {{17_v, {}}};
    while(!open.empty()) {
      const auto [u, arrival] = open.back();
      open.pop_back();
      const FG::internal::Vertex_directions<Triangulation> directions(t, u);
      const std::vector<FG::internal::Fan_leg> legs =
          straightness.legs(FG::internal::spokes(t, u), directions, arrival);
      for(const FG::internal::Fan_leg& leg : legs) {
        BOOST_TEST(leg.head == t.head(leg.halfedge));
        open.emplace_back(leg.head, leg.arrival);
        ++all;
        if(!leg.is_found)
          continue;
        const FG::internal::Strip<Triangulation> strip(t, t.crossing_word(leg.halfedge));
        BOOST_TEST(strip.bend() == 0);
        const double direction = directions.of_input(leg.reference) + leg.angle;
        BOOST_TEST(is_same_angle(direction, directions(strip), directions.total()));
        const FG::internal::Vertex_directions<Triangulation> at_head(t, leg.head);
        const double back = at_head.of_input(leg.arrival.reference) + leg.arrival.angle;
        BOOST_TEST(is_same_angle(back, at_head(t.twin(leg.halfedge)), at_head.total()));
        BOOST_TEST(leg.arrival.is_along == (t.crossings(t.edge(leg.halfedge)) < 0));
        ++(leg.arrival.is_along ? along : found);
      }
    }
    vertices += t.number_of_vertices() - 1;
    BOOST_TEST(all == vertices);
  }
  BOOST_TEST(along > 100);
  BOOST_TEST(found + along > 0.98 * all);
}

// Where the angles about a vertex have drifted, by the same for all edges beyond, one word is enough for all of them.
BOOST_AUTO_TEST_CASE(edges_are_measured_all_at_once_where_angles_have_drifted)
{
  using Triangulation = Double_tree_setting::Triangulation;
  using Straightness = FG::internal::Tree_straightness<Double_tree_setting::Tree>;
  constexpr double drift = 3e-8;
  int together = 0, all = 0;
  for(const Mesh_soup& soup : {bumpy_sphere(8, 0.3, 1), torus(24, 12, 3, 1), saddle_disk(12, 5, 9)}) {
    Double_tree_setting setting(soup);
    const Triangulation& t = setting.triangulation;
    setting.tree.grow(17_v);
    Straightness::Measured_legs measured(static_cast<std::size_t>(t.number_of_vertices()));
    Straightness straightness(setting.tree, measured);
    std::vector<std::pair<Vertex_index, FG::internal::Spoke_place>> open = {{17_v, {}}};
    while(!open.empty()) {
      auto [u, arrival] = open.back();
      open.pop_back();
      const FG::internal::Vertex_directions<Triangulation> directions(t, u);
      const std::vector<FG::Halfedge_index> around = FG::internal::spokes(t, u);
      const std::vector<FG::internal::Fan_leg> legs = straightness.legs(around, directions, arrival);
      arrival.angle += drift;
      const std::vector<FG::internal::Fan_leg> drifted = straightness.legs(around, directions, arrival);
      BOOST_REQUIRE(drifted.size() == legs.size());
      for(std::size_t i = 0; i < legs.size(); ++i) {
        open.emplace_back(legs[i].head, legs[i].arrival);
        if(!legs[i].is_found || legs[i].arrival.is_along)
          continue;
        const auto has_same_place = [&](std::size_t j) {
          return j < legs.size() && j != i && legs[j].reference == legs[i].reference && !legs[j].arrival.is_along;
        };
        ++all;
        if(!has_same_place(i + 1) && !has_same_place(i - 1))
          continue;
        BOOST_TEST(drifted[i].is_found);
        BOOST_TEST(std::abs(drifted[i].angle - legs[i].angle) < 1e-13);
        ++together;
      }
    }
  }
  BOOST_TEST(together > 0.2 * all);
}

namespace {

using Measured_legs = FG::internal::Tree_straightness<Double_tree_setting::Tree>::Measured_legs;

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
  using Straightness = FG::internal::Tree_straightness<Double_tree_setting::Tree>;
  int remembered = 0, replaced = 0;
  for(const Mesh_soup& soup : {bumpy_sphere(10, 0.5, 1), genus_3_plate(2), torus(24, 12, 3, 1)}) {
    Double_tree_setting setting(soup);
    const auto n = static_cast<std::size_t>(setting.triangulation.number_of_vertices());
    setting.tree.grow(17_v);
    Straightness::Measured_legs measured(n), afresh(n);
    std::vector<Vertex_index> bent;
    Straightness(setting.tree, measured)(std::back_inserter(bent));
    std::vector<FG::Halfedge_index> before;
    for(Vertex_index v : setting.vertices()) {
      before.push_back(setting.tree.incoming(v));
      measured[v].arrival.angle += 1e-13; // so that it can be told from what is measured again
    }
    FG::make_shortest(setting.tree);
    const Straightness::Measured_legs old = copied(measured, n);
    const double smallest = Straightness(setting.tree, measured)(std::back_inserter(bent));
    BOOST_TEST(std::abs(smallest - Straightness(setting.tree, afresh)(std::back_inserter(bent))) < 1e-12);
    double least = std::numeric_limits<double>::infinity();
    for(Vertex_index v : setting.vertices()) {
      if(v == 17_v)
        continue;
      least = (std::min)(least, afresh[v].angle);
      BOOST_TEST((measured[v].last == setting.tree.incoming(v)));
      BOOST_TEST((measured[v].arrival.angle == old[v].arrival.angle) == is_of_these_edges(old[v], setting, v));
      BOOST_TEST((measured[v].angle == afresh[v].angle || std::abs(measured[v].angle - afresh[v].angle) < 1e-12));
      remembered += measured[v].arrival.angle != afresh[v].arrival.angle ? 1 : 0;
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

// Decided exactly, ties and all.
BOOST_AUTO_TEST_CASE(certified)
{
  for(const Mesh_soup& soup : {cube(3), tetrahedron(4), flat_grid(6, 6, Diagonal_rule::RANDOM)}) {
    Tree_setting<Certified_setting> setting(soup);
    const FG::Geodesic_tree_report report = setting.tree.grow(5_v);
    check_tree(setting, report);
    BOOST_TEST(std::isinf(report.smallest_angle));
  }
}

BOOST_AUTO_TEST_CASE(on_tetrahedron_never_too_short)
{
  constexpr int n = 6;
  const Mesh_soup soup = tetrahedron(n);
  Double_tree_setting setting(soup);
  setting.tree.grow(10_v);
  int minimal = 0;
  for(Vertex_index v : setting.vertices()) {
    const double shortest = tetrahedron_distance(n, soup.points[10], soup.points[v.idx()]);
    BOOST_TEST(setting.tree.distance(v) >= shortest - tolerance * n);
    minimal += is_close(setting.tree.distance(v), shortest, n) ? 1 : 0;
  }
  BOOST_TEST(minimal >= setting.size() * 8 / 10);
}

BOOST_AUTO_TEST_CASE(within_a_distance)
{
  const Mesh_soup soup = jittered_grid(40, 40, Diagonal_rule::RANDOM, 0.2, 2);
  Double_tree_setting setting(soup);
  const Vertex_index source(grid_vertex(40, 20, 20));
  const FG::Geodesic_tree_report report = setting.tree.grow(source, 5);
  check_tree(setting, report);
  for(Vertex_index v : setting.vertices())
    BOOST_TEST(setting.tree.is_reached(v) == (distance(soup.points[v.idx()], soup.points[source.idx()]) <= 5));
  BOOST_TEST(report.flips < 1000u); // of about 4800 edges; nothing far away is touched
}

BOOST_AUTO_TEST_CASE(at_the_distance_exactly)
{
  Double_tree_setting setting(flat_grid(6, 6, Diagonal_rule::RISING));
  setting.tree.grow(Vertex_index(grid_vertex(6, 3, 3)), 2);
  for(int v : {grid_vertex(6, 1, 3), grid_vertex(6, 5, 3), grid_vertex(6, 3, 1), grid_vertex(6, 3, 5)})
    BOOST_TEST(setting.tree.is_reached(Vertex_index(v)));
}

BOOST_AUTO_TEST_CASE(other_components_are_not_reached)
{
  Double_tree_setting setting(with_isolated_vertices(disjoint_union(sphere(3), sphere(3)), 1, 1));
  check_tree(setting, setting.tree.grow(5_v));
  const FG::Logarithmic_map map = FG::logarithmic_map(setting.tree);
  const Vertex_index last(setting.size() - 1), other(setting.size() / 2 + 5);
  for(Vertex_index v : {0_v, last, other}) {
    BOOST_TEST(!setting.tree.is_reached(v));
    BOOST_TEST(setting.tree.path(v).empty());
    BOOST_TEST(std::isinf(map.vertices[v].radius));
    BOOST_TEST(std::isnan(map.vertices[v].angle));
  }
  // From an isolated vertex there is nowhere to go.
  setting.triangulation.rollback();
  setting.tree.grow(0_v);
  BOOST_TEST(setting.tree.is_reached(0_v));
  BOOST_TEST(!setting.tree.is_reached(5_v));
  BOOST_TEST(std::isinf(FG::logarithmic_map(setting.tree).vertices[5_v].radius));
}

// A tree grown anew, in a flipped triangulation or in one rolled back, is a tree; rolled back it is the same.
BOOST_AUTO_TEST_CASE(grown_again)
{
  Double_tree_setting setting(bumpy_sphere(6, 0.2, 4));
  setting.tree.grow(3_v);
  std::vector<double> distances;
  for(Vertex_index v : setting.vertices())
    distances.push_back(setting.tree.distance(v));
  const std::vector<Halfedge_index> flips = setting.flips();
  check_tree(setting, setting.tree.grow(17_v));
  setting.triangulation.rollback();
  check_tree(setting, setting.tree.grow(3_v));
  for(Vertex_index v : setting.vertices())
    BOOST_TEST(setting.tree.distance(v) == distances[v.idx()]);
  BOOST_TEST(setting.flips() == flips);
}

BOOST_AUTO_TEST_CASE(bad_sources_and_degenerate_faces)
{
  Double_tree_setting setting(sphere(3));
  BOOST_CHECK_THROW(setting.tree.grow(FG::null_index), FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(setting.tree.grow(Vertex_index(setting.size())), FG::Vertex_out_of_range_error);

  Mesh_soup soup = flat_grid(4, 4, Diagonal_rule::RISING);
  soup.points[grid_vertex(4, 2, 2)] = soup.points[grid_vertex(4, 2, 3)];
  Double_tree_setting degenerate(soup);
  BOOST_CHECK_THROW(degenerate.tree.grow(0_v), FG::Degenerate_face_error);
  BOOST_TEST(degenerate.triangulation.is_valid());
  soup.points[grid_vertex(4, 2, 2)][0] = std::numeric_limits<double>::quiet_NaN();
  Double_tree_setting invalid(soup);
  BOOST_CHECK_THROW(invalid.tree.grow(0_v), FG::Invalid_coordinate_error);
}

BOOST_AUTO_TEST_CASE(interrupted)
{
  Double_tree_setting setting(bumpy_sphere(8, 0.2, 4));
  Impatient visitor;
  const auto report = setting.tree.grow(0_v, std::numeric_limits<double>::infinity(), visitor);
  BOOST_TEST(FG::to_string(report.status) == "STOPPED_BY_VISITOR");
  BOOST_TEST(static_cast<std::size_t>(visitor.flips) == report.flips);
  BOOST_TEST(visitor.steps == 101);
  BOOST_TEST(setting.tree.is_valid());
  BOOST_TEST(report.smallest_angle >= FG::Straightness::straight_angle());
}

// Needles so thin that rounded lengths do not tell which of two paths is shorter: exchanging them for one another must
// come to an end.
BOOST_AUTO_TEST_CASE(needles_end)
{
  for(double aspect : {1e4, 1e6, 1e8})
    for(const Mesh_soup& flat :
        {flat_grid(20, 20, Diagonal_rule::RANDOM), jittered_grid(20, 20, Diagonal_rule::RANDOM, 0.2, 1)})
    {
      const Mesh_soup soup = mapped(flat, [=](const Coordinates& p) { return Coordinates{aspect * p[0], p[1], 0}; });
      Double_tree_setting setting(soup);
      setting.tree.grow(0_v);
      for(Vertex_index v : setting.vertices()) {
        BOOST_TEST(setting.tree.is_reached(v));
        BOOST_TEST(setting.tree.distance(v) >= distance(soup.points[0], soup.points[v.idx()]) * (1 - tolerance));
      }
      BOOST_TEST(setting.tree.is_valid());
    }
}

// Flips behind a tree's back: it is not valid where a path is no longer there, or not as long as it says.
BOOST_AUTO_TEST_CASE(trees_whose_edges_were_flipped_are_not_valid)
{
  Double_tree_setting setting(bumpy_sphere(3, 0.2, 1));
  auto& t = setting.triangulation;
  const auto& tree = setting.tree;
  setting.tree.grow(0_v);
  const auto start = t.log_position();
  Random_numbers random(1);
  int of_other_lengths = 0;
  for(int i = 0; i < 1000; ++i) {
    const Vertex_index v(1 + random.below(setting.size() - 1));
    const Halfedge_index last = tree.incoming(v);
    const auto flip = [&](Halfedge_index h) {
      const bool is_in_tree = tree.incoming(t.head(h)) == h || tree.incoming(t.tail(h)) == t.twin(h);
      if(t.is_flippable(h) && (!is_in_tree || t.edge(h) == t.edge(last)))
        t.flip(h);
    };
    for(int k = 0; k < 8; ++k) { // four turn it once around, between other vertices if its quad has changed
      flip(last);
      const bool is_there = t.head(last) == v;
      const bool is_right = is_close(tree.distance(t.tail(last)) + t.length(last), tree.distance(v));
      BOOST_TEST(((is_there && is_right) || !tree.is_valid()));
      of_other_lengths += is_there && !is_right ? 1 : 0;
      for(int j = 0; j < 6; ++j)
        if(const Halfedge_index h = j % 2 == 0 ? last : t.twin(last); random.below(2) == 0)
          flip(random.below(2) == 0 ? t.next(h) : t.previous(h));
    }
    t.rollback(start);
    BOOST_TEST(tree.is_valid());
  }
  BOOST_TEST(of_other_lengths > 0);
}

// Inserted vertices are sources and ends of paths like others; in the plane the map shows every point in its place.
BOOST_AUTO_TEST_CASE(inserted_vertices)
{
  constexpr int n = 8;
  const Mesh_soup soup = jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 5);
  const Surface mesh = to_mesh<Surface>(soup);
  const Double_triangulation<Surface> plain(mesh);
  FG::Input_halfedge_index inner = 70_input_h, border = 0_input_h;
  while(plain.input().is_border(inner) || plain.input().is_border(twin_index(inner)))
    ++inner;
  while(!plain.input().is_border(twin_index(border)))
    ++border;
  const std::array<double, 3> inside = {{0.5, 0.3, 0.2}}, on_edge = {{0.6, 0.4, 0}};
  const std::vector<FG::Surface_location> sources = {{inner, inside}, {inner, on_edge}, {border, on_edge}};
  for(const FG::Surface_location& location : sources) {
    Double_tree_setting setting(soup);
    Random_numbers random(2);
    setting.tree.grow(0_v); // before there were more vertices
    const Vertex_index source = setting.triangulation.insert(location);
    for(int i = 0; i < 20; ++i) {
      const FG::Input_halfedge_index h(random.below(setting.triangulation.input().number_of_halfedges()));
      if(!setting.triangulation.input().is_border(h))
        setting.triangulation.insert({h, {{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)}}});
    }
    const auto place = [&](Vertex_index v) {
      Coordinates p = {0, 0, 0};
      const FG::Surface_location l = setting.triangulation.location(v);
      FG::Input_halfedge_index h = l.halfedge;
      for(int i = 0; i < 3; ++i, h = setting.triangulation.input().next(h))
        for(int k = 0; k < 3 && l.weights[i] > 0; ++k)
          p[k] += l.weights[i] / (l.weights[0] + l.weights[1] + l.weights[2]) *
                  soup.points[setting.triangulation.input().tail(h).idx()][k];
      return p;
    };
    auto& tree = setting.tree;
    BOOST_TEST(FG::to_string(tree.grow(source).status) == "LOCALLY_SHORTEST");
    BOOST_TEST(tree.is_valid());
    const FG::Logarithmic_map map = FG::logarithmic_map(tree);
    const Coordinates s = place(source), other = place(3_v);
    BOOST_TEST(map.is_on_border == (location.halfedge == border));
    const double turn = plane_angle(other[0] - s[0], other[1] - s[1]) - map.vertices[3_v].angle;
    for(Vertex_index v : setting.vertices()) {
      if(v == source)
        continue;
      const Coordinates p = place(v);
      BOOST_TEST(is_close(map.vertices[v].radius, distance(s, p), n));
      BOOST_TEST(is_same_angle(map.vertices[v].angle + turn, plane_angle(p[0] - s[0], p[1] - s[1]), 2 * pi));
    }
  }
}
