// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Curves across many faces with different roots.

#include "test_certify/second_opinion.h"

#include <CGAL/Flip_geodesics/certify_curve.h>

#include <cstdint>

using namespace Flip_geodesics_test;

namespace {

// Two walls, each of n panels and two rows, that meet at a fold which slants against the edges of both: what is between
// it and the first edge of a wall belongs to neither. It unfolds to a plane. The area of each panel has a root of its
// own. The right half is the left one turned by half a turn about the z axis, with the panels of its wall in that
// order, from the fold on, or in the opposite one: their edges are at right angles to what moves them, so the far
// corners stay where they are. The point in the middle lies on the line between opposite corners.
Mesh_soup folding_screen(int n, bool is_reversed, double lift)
{
  const Coordinates edge = {-0.25, 1, 0.125}; // from row to row of the left wall
  const auto wall = [&](bool is_turned_round) {
    std::vector<Coordinates> places(n + 1, Coordinates{0, 0, 0}); // of the middle row, from the fold to the left
    places[1] = {-1 - 0.25 * edge[0], -0.25 * edge[1], 0.5 - 0.25 * edge[2]};
    for(int i = 2; i <= n; ++i) {
      const int k = is_turned_round ? n + 1 - i : i - 1;
      const double dx = -1 - 0.125 * k, dz = (k % 2 == 0 ? 1 : -1) * (0.5 + 0.0625 * k * k);
      places[i] = {places[i - 1][0] + dx, places[i - 1][1] + dx / 4 - dz / 8, places[i - 1][2] + dz};
    }
    return places;
  };
  const std::vector<Coordinates> left = wall(false), right = wall(!is_reversed);
  Mesh_soup soup = mapped(flat_grid(2 * n, 2, Diagonal_rule::RISING), [&](const Coordinates& p) {
    const int i = static_cast<int>(p[0]) - n, row = static_cast<int>(p[1]) - 1;
    if(i == 0)
      return Coordinates{0, static_cast<double>(row), 0};
    const Coordinates& c = i < 0 ? left[-i] : right[i];
    const int sign = i < 0 ? 1 : -1;
    const double along = sign * row;
    return Coordinates{sign * (c[0] + along * edge[0]), sign * (c[1] + along * edge[1]), c[2] + along * edge[2]};
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

BOOST_AUTO_TEST_CASE(zeros_of_several_roots_are_proven)
{
  for(int n : {3, 5}) {
    Certified_setting setting(folding_screen(n, true, 0));
    const FG::Network_certificate certificate = certificate_of_diagonal(setting, n);
    BOOST_TEST((certificate.curves[0].verdict() == FG::Verdict::PROVEN));
    BOOST_TEST(setting.network.halfedges(0_c).size() == 2u);
    BOOST_TEST(certificate.statistics.zeros_by_roots == 2u);
    BOOST_TEST(certificate.statistics.most_roots == std::size_t(n));
    BOOST_TEST(setting.triangulation.decision_statistics().unproven_zeros == 0u);
  }
}

// The work limit is a part of the traits.
BOOST_AUTO_TEST_CASE(zeros_beyond_a_given_limit_of_work_are_probable)
{
  for(std::uint64_t limit : {0u, 100u, 10000u}) {
    const FG::Certified_intrinsic_triangulation_traits<Kernel> traits(limit);
    BOOST_TEST(traits.sign_work_limit() == limit);
    Certified_setting setting(folding_screen(5, true, 0), traits);
    const FG::Network_certificate certificate = certificate_of_diagonal(setting, 5);
    BOOST_TEST((certificate.curves[0].verdict() == FG::Verdict::PROBABLE));
    BOOST_TEST(certificate.statistics.unproven_zeros == 2u);
    BOOST_TEST(certificate.statistics.zeros_by_roots == 0u);
    BOOST_TEST(setting.triangulation.decision_statistics().unproven_zeros > 0u);
  }
}

// A bend that digits show is found without exact arithmetic.
BOOST_AUTO_TEST_CASE(bends_are_found_within_any_limit_of_work)
{
  for(double lift : {0x1p-40, -0x1p-40}) {
    Certified_setting setting(folding_screen(20, true, lift), FG::Certified_intrinsic_triangulation_traits<Kernel>(0));
    const FG::Network_certificate certificate = certificate_of_diagonal(setting, 20);
    BOOST_TEST((certificate.curves[0].verdict() == FG::Verdict::PROVEN));
    BOOST_TEST(setting.network.halfedges(0_c).size() == 1u);
  }
}

// Arithmetic with twenty roots exceeds the work limit.
BOOST_AUTO_TEST_CASE(zeros_without_a_proof_are_probable)
{
  for(bool is_reversed : {true, false}) {
    Certified_setting setting(folding_screen(20, is_reversed, 0));
    BOOST_TEST((certificate_of_diagonal(setting, 20).curves[0].verdict() == FG::Verdict::PROBABLE));
  }
  Certified_setting many(folding_screen(20, false, 0));
  const FG::Network_certificate certificate = certificate_of_diagonal(many, 20);
  BOOST_TEST((certificate.curves[0].verdict() == FG::Verdict::PROBABLE));
  BOOST_TEST(certificate.is_locally_shortest());
  BOOST_TEST(certificate.statistics.unproven_zeros == 2u);

  std::vector<FG::Given_place<Surface>> places;
  for(const auto h : many.network.halfedges(0_c)) {
    const FG::Edge_sequence word = many.triangulation.edge_sequence(h);
    if(places.empty())
      places.emplace_back(Surface::Vertex_index(static_cast<unsigned>(word.tail.idx())));
    for(const auto c : word.crossed)
      places.emplace_back(std::make_pair(many.triangulation.input().halfedge(c), 0.5));
    places.emplace_back(Surface::Vertex_index(static_cast<unsigned>(word.head.idx())));
  }
  const auto given = FG::certify_curve(many.mesh, places);
  BOOST_TEST((given.verdict() == FG::Verdict::PROBABLE));
  BOOST_TEST(given.is_locally_shortest());

  many.add(vertex_path_on_grid(40, {{1, 0}, {2, 0}}), false); // another curve has nothing to do with it
  const FG::Network_certificate both = FG::certify(many.network);
  BOOST_TEST((both.curves[0].verdict() == FG::Verdict::PROBABLE));
  BOOST_TEST((both.curves[1].verdict() == FG::Verdict::PROVEN));
}

// Of several legs, the weakest verdict counts.
BOOST_AUTO_TEST_CASE(legs_are_as_certain_as_the_least_of_them)
{
  Certified_setting setting(folding_screen(20, false, 0));
  auto& t = setting.triangulation;
  const auto at = [&](int i, int j) { return t.location(FG::Vertex_index(grid_vertex(40, i, j))); };
  setting.network.clear();
  const auto verdict = [&](const std::vector<FG::Surface_location>& points) {
    return FG::geodesics_through(t, points).report.curves.front().verdict;
  };
  BOOST_TEST((verdict({at(0, 0), at(40, 2), at(39, 2)}) == FG::Verdict::PROBABLE));
  BOOST_TEST((verdict({at(40, 2), at(39, 2)}) == FG::Verdict::PROVEN));
}

// The line misses the middle point by 1e-90, which 50 digits do not tell. With few roots it has a sign all the same;
// with many it is not said to have been proven.
BOOST_AUTO_TEST_CASE(almost_zeros_have_signs_or_are_probable)
{
  for(bool is_reversed : {true, false})
    for(double lift : {0x1p-300, -0x1p-300}) {
      Certified_setting few(folding_screen(5, is_reversed, lift));
      BOOST_TEST((certificate_of_diagonal(few, 5).curves[0].verdict() == FG::Verdict::PROVEN));
      BOOST_TEST(few.network.halfedges(0_c).size() == 1u);
      Certified_setting many(folding_screen(20, is_reversed, lift));
      many.add(vertex_path_on_grid(40, {{0, 0}, {0, 1}, {40, 1}, {40, 2}}), false);
      many.pull();
      BOOST_TEST((FG::certify(many.network).curves[0].verdict() == FG::Verdict::PROBABLE));
    }
}
