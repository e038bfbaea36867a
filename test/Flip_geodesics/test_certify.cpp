// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE certify

#include "Curve_setting.h"
#include "Referee.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Shortener.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Certified_setting =
    Basic_curve_setting<FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Kernel>>>;
using Settings = boost::mpl::list<Curve_setting, Certified_setting>;

std::vector<Mesh_soup> soups()
{
  return {flat_grid(7, 7, Diagonal_rule::RANDOM),
          jittered_grid(7, 7, Diagonal_rule::RANDOM, 0.2, 1),
          cube(4),
          octahedron(4),
          tetrahedron(4),
          genus_3_plate(1),
          bumpy_sphere(4, 0.3, 2),
          needle_strip(7, 7, 0x1p20)};
}

// Angles of pi up to the rounding of the coordinates: doubles call them straight, which they are not.
std::vector<Mesh_soup> soups_near_ties()
{
  return {torus(12, 9, 3, 1), cylinder(9, 4, 1, 2), cone_disk(6, 3, 2), saddle_disk(6, 3, 8)};
}

// Certifies by the referee.
template <class Network>
class Second_opinion
{
public:
  using Triangulation = typename Network::Triangulation;
  using Shape = Shape_of_points<Surface>;

  Second_opinion(const Network& network, const Surface& mesh)
    : m_network(network)
    , m_referee(network.triangulation(), Shape(mesh))
  {
  }

  bool is_locally_shortest(FG::Curve_index curve)
  {
    bool result = true;
    m_network.for_each_segment(curve, [&](FG::Segment_index s) {
      result = result && m_referee.is_straight(m_network.triangulation().crossing_word(m_network.halfedge(s))) &&
               !is_bent({s, FG::Side::LEFT}) && !is_bent({s, FG::Side::RIGHT});
    });
    return result;
  }

  bool is_bent(const FG::Joint& joint)
  {
    if(m_network.is_head_fixed(joint.incoming))
      return false;
    const auto [a, b] = m_network.ends(joint);
    if(m_network.next_clockwise(a) != b)
      return false;
    return m_network.is_turning_back(joint) || m_referee.compare_wedge(a.halfedge, b.halfedge) < 0;
  }

private:
  const Network& m_network;
  Referee<Triangulation, Shape> m_referee;
};

template <class Setting>
FG::Network_certificate checked_certificate(Setting& setting)
{
  const FG::Network_certificate certificate = FG::certify(setting.network);
  Second_opinion<typename Setting::Network> opinion(setting.network, setting.mesh);
  BOOST_TEST(certificate.curves.size() == std::size_t(setting.network.number_of_curves()));
  for(FG::Curve_index c : FG::internal::descriptors<FG::Curve_index>(setting.network.number_of_curves())) {
    const FG::Curve_certificate& curve = certificate.curves[c.idx()];
    BOOST_TEST(curve.is_locally_shortest() == opinion.is_locally_shortest(c));
    if(curve.verdict == FG::Certificate_verdict::BENT_JOINT) {
      BOOST_TEST(setting.network.curve(curve.segment) == c);
      BOOST_TEST(opinion.is_bent({curve.segment, curve.side}));
    }
  }
  return certificate;
}

template <class Setting>
void add_random_path(Setting& setting, Random_numbers& random)
{
  const int n = setting.triangulation.number_of_vertices();
  const int u = random.below(n);
  setting.add_path(FG::Vertex_index(u), FG::Vertex_index((u + 1 + random.below(n - 1)) % n));
}

template <class Setting>
void take_back(Setting& setting)
{
  setting.network.clear();
  setting.triangulation.rollback();
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(paths_that_were_pulled_tight_are_proven, Setting, Settings)
{
  for(const Mesh_soup& soup : soups()) {
    Setting setting(soup);
    Random_numbers random(1);
    for(int i = 0; i < 20; ++i) {
      add_random_path(setting, random);
      setting.pull();
      BOOST_TEST((checked_certificate(setting).curves[0].verdict == FG::Certificate_verdict::PROVEN));
      take_back(setting);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(loops_and_networks_that_were_pulled_tight_are_proven, Setting, Settings)
{
  int networks = 0, loops = 0;
  for(const Mesh_soup& soup : soups()) {
    Setting setting(soup);
    Random_numbers random(2);
    for(int i = 0; i < 10; ++i) {
      for(int k = 0; k < 3; ++k)
        add_random_path(setting, random);
      try {
        FG::order_overlapping_curves(setting.network);
        setting.pull();
        BOOST_TEST(checked_certificate(setting).is_locally_shortest());
        ++networks;
      } catch(const FG::Crossing_curves_error&) {
      }
      take_back(setting);

      const Halfedge_sequence loop = random_walk(setting.triangulation, 15, true, random);
      if(!loop.empty())
        setting.network.add_curve(loop, true);
      if(!loop.empty() && order_at_random(setting.network, loop, 5, random)) {
        setting.pull();
        BOOST_TEST(checked_certificate(setting).is_locally_shortest());
        ++loops;
      }
      take_back(setting);
    }
  }
  BOOST_TEST(networks > 30);
  BOOST_TEST(loops > 20);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(near_ties_are_told_from_ties, Setting, Settings)
{
  constexpr bool is_exact = !Setting::Triangulation::Traits::Has_drift::value;
  int bent = 0;
  for(const Mesh_soup& soup : soups_near_ties()) {
    Setting setting(soup);
    Random_numbers random(5);
    for(int i = 0; i < 40; ++i) {
      add_random_path(setting, random);
      setting.pull();
      bent += checked_certificate(setting).is_locally_shortest() ? 0 : 1;
      take_back(setting);
    }
  }
  BOOST_TEST(is_exact == (bent == 0));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(paths_as_they_were_found_are_judged_as_the_referee_judges, Setting, Settings)
{
  int bent = 0, straight = 0;
  for(const Mesh_soup& soup : soups()) {
    Setting setting(soup);
    Random_numbers random(3);
    for(int i = 0; i < 20; ++i) {
      add_random_path(setting, random);
      (checked_certificate(setting).is_locally_shortest() ? straight : bent) += 1;
      take_back(setting);
    }
  }
  BOOST_TEST(bent > 50);
  BOOST_TEST(straight > 10);
}

// However little is missing, a curve is proven after the last step and not before it.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_curve_one_step_from_the_end_is_bent, Setting, Settings)
{
  int stopped = 0;
  for(const Mesh_soup& soup : soups()) {
    Setting setting(soup);
    Random_numbers random(4);
    const int n = setting.triangulation.number_of_vertices();
    for(int i = 0; i < 10; ++i) {
      const FG::Vertex_index u(random.below(n)), v((u.idx() + 1 + random.below(n - 1)) % n);
      setting.add_path(u, v);
      const std::size_t steps = setting.pull().flip_outs;
      take_back(setting);
      if(steps == 0)
        continue;
      setting.add_path(u, v);
      setting.pull(FG::Iteration_stop_predicate(steps - 1));
      const FG::Network_certificate certificate = checked_certificate(setting);
      BOOST_TEST((certificate.curves[0].verdict == FG::Certificate_verdict::BENT_JOINT));
      ++stopped;
      take_back(setting);
    }
  }
  BOOST_TEST(stopped > 50);
}

BOOST_AUTO_TEST_CASE(the_bent_joint_is_named)
{
  const int n = 4;
  Certified_setting setting(flat_grid(n, n, Diagonal_rule::RISING));
  setting.add(vertex_path_on_grid(n, {{0, 1}, {2, 1}, {2, 3}}), false);
  const FG::Network_certificate left = FG::certify(setting.network);
  BOOST_TEST((left.curves[0].verdict == FG::Certificate_verdict::BENT_JOINT));
  BOOST_TEST((left.curves[0].side == FG::Side::LEFT));
  const auto head_of = [&](FG::Segment_index s) { return setting.triangulation.head(setting.network.halfedge(s)); };
  BOOST_TEST(head_of(left.curves[0].segment) == FG::Vertex_index(grid_vertex(n, 2, 1)));
  take_back(setting);

  setting.add(vertex_path_on_grid(n, {{0, 3}, {2, 3}, {2, 1}}), false);
  const FG::Network_certificate right = FG::certify(setting.network);
  BOOST_TEST((right.curves[0].side == FG::Side::RIGHT));
  BOOST_TEST(head_of(right.curves[0].segment) == FG::Vertex_index(grid_vertex(n, 2, 3)));
}

BOOST_AUTO_TEST_CASE(each_curve_has_a_verdict_of_its_own)
{
  const int n = 6;
  Certified_setting setting(flat_grid(n, n, Diagonal_rule::RISING));
  setting.add(vertex_path_on_grid(n, {{0, 1}, {6, 1}}), false);
  setting.add(vertex_path_on_grid(n, {{0, 2}, {3, 2}, {3, 5}}), false);
  setting.add(vertex_path_on_grid(n, {{5, 2}, {5, 5}}), false);
  const FG::Network_certificate certificate = FG::certify(setting.network);
  BOOST_TEST((certificate.curves[0].verdict == FG::Certificate_verdict::PROVEN));
  BOOST_TEST((certificate.curves[1].verdict == FG::Certificate_verdict::BENT_JOINT));
  BOOST_TEST((certificate.curves[2].verdict == FG::Certificate_verdict::PROVEN));
  BOOST_TEST(!certificate.is_locally_shortest());
}

// A curve is held back by another that ends inside its wedge: nothing is wrong with it.
BOOST_AUTO_TEST_CASE_TEMPLATE(what_blocks_a_joint_is_not_held_against_the_curve, Setting, Settings)
{
  const int n = 6;
  Setting setting(flat_grid(n, n, Diagonal_rule::FALLING));
  setting.add(vertex_path_on_grid(n, {{1, 3}, {3, 3}, {3, 5}}), false);
  BOOST_TEST(!FG::certify(setting.network).is_locally_shortest());
  setting.add({FG::Vertex_index(grid_vertex(n, 2, 4)), FG::Vertex_index(grid_vertex(n, 3, 3))}, false);
  const FG::Network_certificate certificate = checked_certificate(setting);
  BOOST_TEST((certificate.curves[0].verdict == FG::Certificate_verdict::PROVEN));
  BOOST_TEST((certificate.curves[1].verdict == FG::Certificate_verdict::PROVEN));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(fixed_nodes_may_be_bent, Setting, Settings)
{
  const int n = 6;
  Setting setting(flat_grid(n, n, Diagonal_rule::RISING));
  setting.add(vertex_path_on_grid(n, {{1, 3}, {3, 3}, {3, 5}}), false);
  BOOST_TEST(!FG::certify(setting.network).is_locally_shortest());
  setting.network.fix_nodes_at(FG::Vertex_index(grid_vertex(n, 3, 3)));
  BOOST_TEST(checked_certificate(setting).is_locally_shortest());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_curve_that_turns_back_is_bent, Setting, Settings)
{
  Setting setting(cube(3));
  setting.add({0_v, 1_v, 0_v, 1_v}, false);
  const FG::Network_certificate certificate = checked_certificate(setting);
  BOOST_TEST((certificate.curves[0].verdict == FG::Certificate_verdict::BENT_JOINT));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_contracted_curve_is_proven, Setting, Settings)
{
  Setting setting(thirteen_vertex_cone_disk());
  setting.add(disk_ring(6, 1), true);
  BOOST_TEST(!FG::certify(setting.network).is_locally_shortest());
  setting.pull();
  BOOST_TEST(setting.network.is_contracted(0_c));
  BOOST_TEST((FG::certify(setting.network).curves[0].verdict == FG::Certificate_verdict::PROVEN));
}

// The angles of these loops are pi, exactly: what one unit in the last place less would not allow.
BOOST_AUTO_TEST_CASE_TEMPLATE(angles_of_exactly_pi_are_proven, Setting, Settings)
{
  Setting hexagon(octahedron(6));
  hexagon.add(vertices_on_polyline(octahedron(6),
                                   {{3, -3, 0}, {3, 0, -3}, {0, 3, -3}, {-3, 3, 0}, {-3, 0, 3}, {0, -3, 3}}, true),
              true);
  BOOST_TEST((checked_certificate(hexagon).curves[0].verdict == FG::Certificate_verdict::PROVEN));

  Setting setting(tetrahedron(6));
  setting.add(tetrahedron_loop(6), true);
  const FG::Network_certificate certificate = checked_certificate(setting);
  BOOST_TEST((certificate.curves[0].verdict == FG::Certificate_verdict::PROVEN));
  BOOST_TEST(certificate.statistics.zeros_by_plane + certificate.statistics.zeros_by_roots > 0u);

  Setting plate(genus_3_plate(2));
  for(const Vertex_sequence& loop : genus_3_loops(2)) {
    plate.add(loop, true);
    BOOST_TEST((checked_certificate(plate).curves[0].verdict == FG::Certificate_verdict::PROVEN));
    take_back(plate);
  }
}

// Lowering one vertex of a straight line by the smallest amount there is makes it bent on one side.
BOOST_AUTO_TEST_CASE_TEMPLATE(one_unit_in_the_last_place_is_seen, Setting, Settings)
{
  const int n = 6;
  Mesh_soup soup = flat_grid(n, n, Diagonal_rule::RISING);
  soup.points[grid_vertex(n, 3, 3)][1] = 3 - 0x1p-51;
  Setting setting(soup);
  setting.add(vertex_path_on_grid(n, {{2, 3}, {4, 3}}), false);
  const FG::Network_certificate certificate = checked_certificate(setting);
  BOOST_TEST((certificate.curves[0].verdict == FG::Certificate_verdict::BENT_JOINT));
  BOOST_TEST((certificate.curves[0].side == FG::Side::LEFT));
}

// ---------------------------------------------------------------- many roots

namespace {

// A folding screen over a grid of 2 n columns and 2 rows, the folds at irregular distances: to the left of the middle
// as given, from the middle on, and to the right in the same or in reverse order. It unfolds to a plane. The area of
// each column has a root of its own; the middle point lies on the line between opposite corners.
Mesh_soup folding_screen(int n, bool is_reversed, double lift)
{
  std::vector<double> x(2 * n + 1, 0.0), z(2 * n + 1, 0.0);
  for(int i = 1; i <= n; ++i) {
    const double dx = 1 + 0.125 * i, dz = (i % 2 == 0 ? 1 : -1) * (0.5 + 0.0625 * i * i);
    const int left = is_reversed ? n - i : i - 1; // columns from the left border
    x[left + 1] = dx;
    z[left + 1] = dz;
    x[n + i] = dx;
    z[n + i] = dz;
  }
  for(int i = 1; i <= 2 * n; ++i) {
    x[i] += x[i - 1];
    z[i] += z[i - 1];
  }
  Mesh_soup soup = mapped(flat_grid(2 * n, 2, Diagonal_rule::RISING), [&](const Coordinates& p) {
    const int i = static_cast<int>(p[0]);
    return Coordinates{x[i], p[1] - 1, z[i]};
  });
  soup.points[grid_vertex(2 * n, n, 1)][1] += lift;
  return soup;
}

// Pulls the diagonal tight that passes by the middle point, on its left.
template <class Setting>
FG::Network_certificate certificate_of_diagonal(Setting& setting, int n)
{
  setting.add(vertex_path_on_grid(2 * n, {{0, 0}, {0, 1}, {2 * n, 1}, {2 * n, 2}}), false);
  setting.pull();
  return checked_certificate(setting);
}

} // namespace

BOOST_AUTO_TEST_CASE(zeros_of_many_roots_are_proven)
{
  for(int n : {5, 20, 70}) {
    Certified_setting setting(folding_screen(n, true, 0));
    const FG::Network_certificate certificate = certificate_of_diagonal(setting, n);
    BOOST_TEST((certificate.curves[0].verdict == FG::Certificate_verdict::PROVEN));
    BOOST_TEST(setting.network.halfedges(0_c).size() == 2u);
    BOOST_TEST(certificate.statistics.zeros_by_roots == 2u);
    BOOST_TEST(certificate.statistics.most_roots > (n == 5 ? 3u : 12u));
    BOOST_TEST(setting.triangulation.decision_statistics().unproven_zeros == 0u);
  }
}

// No order of faces closes the roots of such strips early.
BOOST_AUTO_TEST_CASE(zeros_without_a_proof_are_probable)
{
  Certified_setting few(folding_screen(8, false, 0));
  BOOST_TEST((certificate_of_diagonal(few, 8).curves[0].verdict == FG::Certificate_verdict::PROVEN));

  Certified_setting many(folding_screen(20, false, 0));
  const FG::Network_certificate certificate = certificate_of_diagonal(many, 20);
  BOOST_TEST((certificate.curves[0].verdict == FG::Certificate_verdict::PROBABLE));
  BOOST_TEST(certificate.is_locally_shortest());
  BOOST_TEST(certificate.statistics.unproven_zeros == 2u);

  many.add(vertex_path_on_grid(40, {{1, 0}, {2, 0}}), false); // another curve has nothing to do with it
  const FG::Network_certificate both = FG::certify(many.network);
  BOOST_TEST((both.curves[0].verdict == FG::Certificate_verdict::PROBABLE));
  BOOST_TEST((both.curves[1].verdict == FG::Certificate_verdict::PROVEN));
}

// Of several legs, the weakest verdict counts.
BOOST_AUTO_TEST_CASE(legs_are_as_certain_as_the_least_of_them)
{
  Certified_setting setting(folding_screen(20, false, 0));
  auto& t = setting.triangulation;
  const auto at = [&](int i, int j) { return t.location(FG::Vertex_index(grid_vertex(40, i, j))); };
  setting.network.clear();
  BOOST_TEST((FG::geodesics_through(t, {at(0, 0), at(40, 2), at(39, 2)}).certificate.verdict ==
              FG::Certificate_verdict::PROBABLE));
  BOOST_TEST((FG::geodesics_through(t, {at(40, 2), at(39, 2)}).certificate.verdict ==
              FG::Certificate_verdict::PROVEN));
}

// The line misses the middle point by 1e-90: what is not zero has a sign, after as many digits as it takes.
BOOST_AUTO_TEST_CASE(almost_zeros_of_many_roots_have_signs)
{
  for(bool is_reversed : {true, false})
    for(double lift : {0x1p-300, -0x1p-300}) {
      Certified_setting setting(folding_screen(20, is_reversed, lift));
      const FG::Network_certificate certificate = certificate_of_diagonal(setting, 20);
      BOOST_TEST((certificate.curves[0].verdict == FG::Certificate_verdict::PROVEN));
      BOOST_TEST(setting.network.halfedges(0_c).size() == 1u);
      BOOST_TEST(setting.triangulation.decision_statistics().unproven_zeros == 0u);
    }
}

BOOST_AUTO_TEST_CASE(residues_of_roots_multiply_as_roots_do)
{
  const std::vector<FG::internal::Integer> squares = {2, 3, 6, 8, 12, 49, 1001, 7 * 1001};
  const FG::internal::Root_base base(squares);
  for(unsigned bits : {61u, 64u, 150u}) {
    const FG::internal::Integer prime = FG::internal::random_prime(bits);
    BOOST_TEST(boost::multiprecision::msb(prime) + 1 == bits);
    BOOST_TEST(prime % 4 == 3);
    const FG::internal::Residue_ring ring(base, prime);
    const auto root = [&](int d) { return ring.side(0, d, 1, 1).root; };
    const auto difference = [&](const auto& a, const auto& b) { return ring.add(a, ring.negate(b)); };
    for(const FG::internal::Integer& d : squares) {
      const auto r = ring.side(0, d, 1, 1).root;
      BOOST_TEST(ring.is_zero(difference(ring.multiply(r, r), ring.integer(d))));
    }
    BOOST_TEST(ring.is_zero(difference(ring.multiply(root(2), root(3)), root(6))));
    BOOST_TEST(ring.is_zero(difference(ring.multiply(root(8), root(2)), ring.integer(4))));
    BOOST_TEST(ring.is_zero(difference(ring.multiply(root(12), root(8)), ring.multiply(root(6), ring.integer(4)))));
    BOOST_TEST(!ring.is_zero(difference(ring.multiply(root(2), root(3)), root(12))));
    BOOST_TEST(!ring.is_zero(difference(root(2), root(3))));
  }
}

// ---------------------------------------------------------------- faces without area

// A kite with two points on its long diagonal, which is doubled by faces without area. Lines run along crossed edges.
BOOST_AUTO_TEST_CASE_TEMPLATE(segments_along_faces_without_area_are_proven, Setting, Settings)
{
  Setting setting(Mesh_soup{{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, -2, 0}, {2, 2, 0}},
                            {{0, 4, 1}, {0, 1, 3}, {0, 3, 2}, {0, 2, 5}, {2, 3, 5}, {3, 1, 5}}});
  Random_numbers random(1);
  int walks = 0;
  for(int i = 0; i < 300; ++i) {
    const Halfedge_sequence walk = random_walk(setting.triangulation, 8, false, random);
    if(walk.empty())
      continue;
    setting.network.add_curve(walk, false);
    if(setting.network.is_valid()) {
      const auto p = setting.mesh.point(setting.triangulation.vertex(setting.triangulation.tail(walk.front()))),
                 q = setting.mesh.point(setting.triangulation.vertex(setting.triangulation.head(walk.back())));
      setting.pull();
      BOOST_TEST((FG::certify(setting.network).curves[0].verdict == FG::Certificate_verdict::PROVEN));
      BOOST_TEST(std::abs(setting.network.length(0_c) - std::sqrt(CGAL::squared_distance(p, q))) < 1e-12);
      ++walks;
    }
    take_back(setting);
  }
  BOOST_TEST(walks > 40);
}

// Lengths can make a cone of the point on the line, over which the line would become shorter.
BOOST_AUTO_TEST_CASE(a_segment_that_touches_a_cone_is_bent)
{
  using Lengths = std::map<boost::graph_traits<Surface>::edge_descriptor, double>;
  using Metric = FG::Edge_length_metric<Surface, boost::const_associative_property_map<Lengths>>;
  using Triangulation =
      FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Metric::Kernel>, Metric>;
  for(double far_side : {1.4, 1.5}) {
    // 2 is on the line from 0 to 1, and sees 4, on the other side, at less or more than a right angle from both.
    const Surface mesh = to_mesh<Surface>(Mesh_soup{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, 1, 0}},
                                                    {{0, 3, 1}, {0, 1, 2}, {0, 2, 4}, {2, 1, 4}}});
    const Lengths lengths = edge_lengths(mesh, [=](int u, int v) {
      const std::pair<int, int> ends = std::minmax(u, v);
      if(ends == std::pair<int, int>(0, 1))
        return 2.0;
      return ends.first == 2 || ends.second == 2 ? 1.0 : far_side;
    });
    Triangulation triangulation(mesh, Metric(mesh, boost::make_assoc_property_map(lengths)));
    FG::Edge_path_network<Triangulation> network(triangulation);
    network.add_curve(FG::halfedges_through(triangulation, Vertex_sequence{0_v, 1_v}, false), false);
    const auto verdict = FG::certify(network).curves[0].verdict;
    BOOST_TEST((verdict ==
                (far_side < std::sqrt(2.0) ? FG::Certificate_verdict::BENT_SEGMENT : FG::Certificate_verdict::PROVEN)));
  }
}

// The line from 0 to 1 touches 2, an end of the only edge that it crosses, at a right angle to that edge. The angle on
// the other side is pi, or a unit in the last place more or less, or there is the border.
BOOST_AUTO_TEST_CASE(a_vertex_touched_at_the_end_of_a_gate_has_a_full_angle_or_is_told)
{
  using Lengths = std::map<boost::graph_traits<Surface>::edge_descriptor, double>;
  using Metric = FG::Edge_length_metric<Surface, boost::const_associative_property_map<Lengths>>;
  using Triangulation =
      FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Metric::Kernel>, Metric>;
  for(bool has_border : {true, false})
    for(double far_side : {4.5, std::nextafter(5.0, 4.0), 5.0, std::nextafter(5.0, 6.0), 5.5})
      for(bool is_reversed : {false, true}) {
        Mesh_soup soup = {{{-3, 0, 0}, {3, 0, 0}, {0, 0, 0}, {0, -4, 0}}, {{0, 3, 2}, {2, 3, 1}}};
        if(!has_border) {
          soup.points.push_back({0, 4, 0});
          soup.triangles.insert(soup.triangles.end(), {{0, 2, 4}, {2, 1, 4}});
        }
        const Surface mesh = to_mesh<Surface>(soup);
        const Lengths lengths = edge_lengths(mesh, [=](int u, int v) {
          if(u == 2 || v == 2)
            return u + v == 2 || u + v == 3 ? 3.0 : 4.0;
          return (std::max)(u, v) == 4 ? far_side : 5.0;
        });
        Triangulation triangulation(mesh, Metric(mesh, boost::make_assoc_property_map(lengths)));
        const FG::Halfedge_index h = FG::internal::halfedge_between(triangulation, 2_v, 3_v);
        triangulation.flip(h);
        FG::Edge_path_network<Triangulation> network(triangulation);
        network.add_curve(Halfedge_sequence{is_reversed ? Triangulation::twin(h) : h}, false);
        const auto verdict = FG::certify(network).curves[0].verdict;
        BOOST_TEST((verdict == (has_border || far_side >= 5 ? FG::Certificate_verdict::PROVEN
                                                            : FG::Certificate_verdict::BENT_SEGMENT)));
      }
}

// The line from 2 to 1 runs along the edge from 0 to 3, which it crosses between two faces without area, and touches 3,
// whose angle on the other side is less or more than pi.
BOOST_AUTO_TEST_CASE(a_segment_along_an_edge_that_it_crosses)
{
  using Lengths = std::map<boost::graph_traits<Surface>::edge_descriptor, double>;
  using Metric = FG::Edge_length_metric<Surface, boost::const_associative_property_map<Lengths>>;
  using Triangulation =
      FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Metric::Kernel>, Metric>;
  for(double far_side : {3.0, 3.2}) {
    const Surface mesh =
        to_mesh<Surface>(Mesh_soup{{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, -2, 0}, {2, 2, 0}},
                                   {{0, 4, 1}, {0, 1, 3}, {0, 3, 2}, {0, 2, 5}, {2, 3, 5}, {3, 1, 5}}});
    const Lengths lengths = edge_lengths(mesh, [=](int u, int v) {
      const double x[] = {0, 4, 1, 3};
      const std::pair<int, int> ends = std::minmax(u, v);
      if(ends.second < 4)
        return std::abs(x[u] - x[v]);
      if(ends.second == 4 || ends.first == 0)
        return 3.0;
      return ends.first == 1 ? far_side : 2.5;
    });
    Triangulation triangulation(mesh, Metric(mesh, boost::make_assoc_property_map(lengths)));
    const FG::Halfedge_index h = FG::internal::halfedge_between(triangulation, 0_v, 3_v);
    triangulation.flip(h);
    for(FG::Halfedge_index side : {h, Triangulation::twin(h)}) {
      FG::Edge_path_network<Triangulation> network(triangulation);
      network.add_curve(Halfedge_sequence{side}, false);
      BOOST_TEST((FG::certify(network).curves[0].verdict ==
                  (far_side > 3.1 ? FG::Certificate_verdict::PROVEN : FG::Certificate_verdict::BENT_SEGMENT)));
      network.clear();
    }
  }
}

// ---------------------------------------------------------------- faces on one line

namespace {

struct Edge_with_length
{
  int u, v;
  double length;
};

// Faces of which only the lengths of the edges are known.
class Surface_of_lengths
{
  using Lengths = std::map<boost::graph_traits<Surface>::edge_descriptor, double>;
  using Metric = FG::Edge_length_metric<Surface, boost::const_associative_property_map<Lengths>>;
  using Triangulation =
      FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Metric::Kernel>, Metric>;

public:
  Surface_of_lengths(const std::vector<Corners>& triangles, const std::vector<Edge_with_length>& edges)
  {
    int last = 0;
    for(const Corners& t : triangles)
      last = (std::max)({last, t[0], t[1], t[2]});
    m_mesh = to_mesh<Surface>({std::vector<Coordinates>(static_cast<std::size_t>(last) + 1), triangles});
    m_lengths = edge_lengths(m_mesh, [&](int u, int v) {
      for(const Edge_with_length& e : edges)
        if((e.u == u && e.v == v) || (e.u == v && e.v == u))
          return e.length;
      return 1.0;
    });
  }

  FG::Certificate_verdict verdict_on_edge(FG::Vertex_index u, FG::Vertex_index v) const
  {
    Triangulation triangulation = triangulated();
    return verdict(triangulation, FG::internal::halfedge_between(triangulation, u, v));
  }

  // Of what becomes of an edge when it is flipped, whether it could be or not; in both directions.
  FG::Certificate_verdict verdict_on_flipped_edge(FG::Vertex_index u, FG::Vertex_index v) const
  {
    Triangulation triangulation = triangulated();
    const FG::Halfedge_index h = FG::internal::halfedge_between(triangulation, u, v);
    triangulation.flip(h);
    const auto result = verdict(triangulation, h);
    BOOST_TEST((verdict(triangulation, Triangulation::twin(h)) == result));
    return result;
  }

  // Of the part of an edge from a point of it to its end.
  FG::Certificate_verdict verdict_on_part(FG::Vertex_index u, FG::Vertex_index v, double at_tail) const
  {
    Triangulation triangulation = triangulated();
    const FG::Halfedge_index h = FG::internal::halfedge_between(triangulation, u, v);
    const FG::Vertex_index x = triangulation.insert({FG::internal::as_input(h), {{at_tail, 1 - at_tail, 0}}});
    return verdict(triangulation, FG::internal::halfedge_between(triangulation, x, v));
  }

private:
  Triangulation triangulated() const
  {
    return Triangulation(m_mesh, Metric(m_mesh, boost::make_assoc_property_map(m_lengths)));
  }

  static FG::Certificate_verdict verdict(Triangulation& triangulation, FG::Halfedge_index h)
  {
    FG::Edge_path_network<Triangulation> network(triangulation);
    network.add_curve(Halfedge_sequence{h}, false);
    const auto result = FG::certify(network).curves[0].verdict;
    network.clear();
    return result;
  }

  Surface m_mesh;
  Lengths m_lengths;
};

} // namespace

// The faces beside the edge from 0 to 1 lie on its line. A point of them where the angles sum up to less than a full
// one, the tip of a cone, counts where it lies on the edge, and not beyond its ends.
BOOST_AUTO_TEST_CASE(cones_on_the_line_count_between_the_ends)
{
  const auto bent = FG::Certificate_verdict::BENT_SEGMENT, proven = FG::Certificate_verdict::PROVEN;
  const std::vector<Corners> one_face = {{0, 1, 2}, {2, 1, 3}, {0, 2, 3}};
  const auto with_cone_at = [&](double x) {
    const double to_1 = std::abs(4 - x);
    return Surface_of_lengths(one_face, {{0, 1, 4}, {0, 2, x}, {1, 2, to_1}, {2, 3, 1}, {0, 3, x}, {1, 3, to_1}});
  };
  BOOST_TEST((with_cone_at(2).verdict_on_edge(0_v, 1_v) == bent));
  BOOST_TEST((with_cone_at(5).verdict_on_edge(0_v, 1_v) == proven));
  const double close = 0x1p-32;
  const Surface_of_lengths near_the_head(
      one_face, {{0, 1, 4}, {0, 2, 4 - close}, {1, 2, close}, {2, 3, close}, {0, 3, 4 - close}, {1, 3, close}});
  BOOST_TEST((near_the_head.verdict_on_edge(0_v, 1_v) == bent));
  BOOST_TEST((near_the_head.verdict_on_edge(1_v, 0_v) == bent));
  // Seen from a point of the edge, on either side of the tip.
  BOOST_TEST((with_cone_at(2).verdict_on_part(0_v, 1_v, 0.75) == bent));
  BOOST_TEST((with_cone_at(2).verdict_on_part(0_v, 1_v, 0.25) == proven));
  BOOST_TEST((with_cone_at(1).verdict_on_part(0_v, 1_v, 0.5) == proven));
}

// Beyond the head, at 5 and 6, faces turn back to a tip at 3, which is not on the edge: it is reached over 5 only.
BOOST_AUTO_TEST_CASE(faces_on_the_line_are_followed_between_the_ends)
{
  const std::vector<Corners> triangles = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {2, 4, 5}};
  const std::vector<Edge_with_length> edges = {{0, 1, 4}, {1, 2, 1}, {0, 2, 5}, {1, 3, 2}, {2, 3, 1},
                                               {2, 4, 2}, {3, 4, 3}, {4, 5, 1}, {2, 5, 2}, {3, 5, 3}};
  BOOST_TEST((Surface_of_lengths(triangles, edges).verdict_on_edge(0_v, 1_v) == FG::Certificate_verdict::PROVEN));
}

// A fan of many faces about 0, with far ends beyond the head, and then one with a tip on the edge.
BOOST_AUTO_TEST_CASE(many_faces_on_the_line_are_followed_to_the_last)
{
  for(int n : {3, 80}) {
    std::vector<Corners> triangles = {{0, 1, 2}};
    std::vector<Edge_with_length> edges = {{0, 1, 4}, {0, 2, 5}, {1, 2, 1}};
    for(int i = 2; i < n; ++i) {
      triangles.push_back({0, i, i + 1});
      edges.push_back({0, i + 1, i + 4.0});
      edges.push_back({i, i + 1, 1});
    }
    const int tip = n + 1, beside = n + 2;
    triangles.insert(triangles.end(), {{0, n, tip}, {tip, n, beside}, {0, tip, beside}});
    edges.insert(edges.end(), {{0, tip, 2}, {n, tip, n + 1.0}, {tip, beside, 1}, {0, beside, 2}, {n, beside, n + 1.0}});
    const auto verdict = Surface_of_lengths(triangles, edges).verdict_on_edge(0_v, 1_v);
    BOOST_TEST((verdict == FG::Certificate_verdict::BENT_SEGMENT));
  }
}

// Where the face has an area, by a unit in the last place, its tip is not on the edge.
BOOST_AUTO_TEST_CASE(faces_with_little_area_are_told_from_those_without)
{
  const double close = 0x1p-44, rest = 1 - close;
  for(double other : {rest, rest + 0x1p-53}) {
    const Surface_of_lengths surface({{0, 1, 2}, {2, 1, 3}, {0, 2, 3}},
                                     {{0, 1, 1}, {0, 2, close}, {1, 2, other}, {0, 3, 1}});
    BOOST_TEST((surface.verdict_on_edge(0_v, 1_v) ==
                (other > rest ? FG::Certificate_verdict::PROVEN : FG::Certificate_verdict::BENT_SEGMENT)));
  }
}

// From 0 to 1 through the edge from 2 to 3, on one line: straight if that edge lies between, not beyond an end.
BOOST_AUTO_TEST_CASE(edges_crossed_on_the_line_lie_between_the_ends)
{
  const std::vector<Corners> triangles = {{0, 2, 3}, {3, 2, 1}};
  const auto verdict = [&](double from, double to) {
    return Surface_of_lengths(triangles, {{0, 2, std::abs(from)},
                                          {0, 3, std::abs(to)},
                                          {2, 3, to - from},
                                          {1, 2, std::abs(4 - from)},
                                          {1, 3, std::abs(4 - to)}})
        .verdict_on_flipped_edge(2_v, 3_v);
  };
  BOOST_TEST((verdict(1, 3) == FG::Certificate_verdict::PROVEN));
  BOOST_TEST((verdict(-1, 5) == FG::Certificate_verdict::PROVEN));
  BOOST_TEST((verdict(5, 6) == FG::Certificate_verdict::BENT_SEGMENT));
  BOOST_TEST((verdict(-2, -1) == FG::Certificate_verdict::BENT_SEGMENT));
}

// ---------------------------------------------------------------- what is certified when the shortening was long

// What a limit or a visitor has held back is taken up by the next run, on the same curve as well.
BOOST_AUTO_TEST_CASE(wedges_that_were_held_back_are_taken_up_again)
{
  struct Stopped_once : FG::Default_shortening_visitor
  {
    bool go_further() { return std::exchange(has_stopped, true); }
    bool has_stopped = false;
  };
  const int n = 12;
  for(bool has_limit : {true, false}) {
    Certified_setting setting(flat_grid(n, n, Diagonal_rule::RISING));
    // Two bumps: what is done about one says nothing of the other.
    setting.add(
        vertex_path_on_grid(n, {{1, 3}, {2, 3}, {2, 4}, {3, 4}, {3, 3}, {9, 3}, {9, 4}, {10, 4}, {10, 3}, {11, 3}}),
        false);
    FG::Shortener<Certified_setting::Network> shortener(setting.network);
    if(has_limit)
      BOOST_TEST(!shortener.run(FG::Curve_length_ratio_stop_predicate(1)));
    else
      for(int i = 0; i < 20; ++i)
        BOOST_TEST(!shortener.run(FG::Never_stop_predicate(), Stopped_once()));
    BOOST_TEST(!checked_certificate(setting).is_locally_shortest());
    BOOST_TEST(shortener.run());
    BOOST_TEST((checked_certificate(setting).curves[0].verdict == FG::Certificate_verdict::PROVEN));
  }
}

// As long as a curve becomes shorter, it is not given up.
BOOST_AUTO_TEST_CASE(a_curve_of_more_than_ten_thousand_steps_is_straight)
{
  const int n = 170;
  Curve_setting setting(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.1, 1));
  setting.add(vertex_path_on_grid(n, {{1, 1}, {n - 1, 1}, {n - 1, n - 1}}), false);
  const FG::Shortening_report report = setting.pull();
  BOOST_TEST(report.flip_outs > 10000u);
  BOOST_TEST((report.curves[0].status == FG::Shortening_status::LOCALLY_SHORTEST));
  const auto p = setting.mesh.point(Surface::Vertex_index(grid_vertex(n, 1, 1))),
             q = setting.mesh.point(Surface::Vertex_index(grid_vertex(n, n - 1, n - 1)));
  BOOST_TEST(std::abs(report.curves[0].length - std::sqrt(CGAL::squared_distance(p, q))) < 1e-9);
}

BOOST_AUTO_TEST_CASE(names_of_verdicts)
{
  BOOST_TEST(FG::to_string(FG::Certificate_verdict::PROVEN) == std::string("PROVEN"));
  BOOST_TEST(FG::to_string(FG::Certificate_verdict::PROBABLE) == std::string("PROBABLE"));
  BOOST_TEST(FG::to_string(FG::Certificate_verdict::BENT_SEGMENT) == std::string("BENT_SEGMENT"));
  BOOST_TEST(FG::to_string(FG::Certificate_verdict::BENT_JOINT) == std::string("BENT_JOINT"));
}
