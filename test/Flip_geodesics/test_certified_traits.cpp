// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE certified_traits

#include "Metric_archetype.h"
#include "Referee.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "lawson.h"
#include "random_curves.h"
#include "test_certified_traits/judged_meshes.h"

#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

using namespace judged_test;

BOOST_AUTO_TEST_CASE(the_referee_agrees_where_ties_abound)
{
  const Totals totals = judge_soups(soups_full_of_ties(), 20);
  BOOST_TEST(totals.ties > 1000u);
}

BOOST_AUTO_TEST_CASE(the_referee_agrees_near_ties)
{
  const Totals totals = judge_soups(soups_near_ties(), 20);
  BOOST_TEST(totals.decisions > totals.filtered);
}

BOOST_AUTO_TEST_CASE(the_referee_agrees_on_generic_meshes)
{
  const Totals totals = judge_soups(generic_soups(), 20);
  BOOST_TEST(totals.decisions > 10000u);
}

BOOST_AUTO_TEST_CASE(the_referee_agrees_on_metrics_given_by_lengths)
{
  Totals totals;
  judge_lengths("random lengths", octahedron(4), Random_metric{1}, 20, totals);
  judge_lengths("lengths of few values", octahedron(4), Random_metric{2, 4}, 20, totals);
  judge_lengths(
      "equal lengths", octahedron(4), [](int, int) { return 1.0; }, 20, totals);
  judge_lengths("flat torus", torus(10, 8, 3, 1), Flat_torus_metric{10, 8, 10, 8}, 20, totals);
  judge_lengths("flat torus of irrational sides", torus(10, 8, 3, 1), Flat_torus_metric{10, 8, std::sqrt(2.0), pi}, 20,
                totals);
  BOOST_TEST(totals.ties > 100u);
}

namespace {

// -1, 0 or 1: the angles opposite to an edge, compared with pi by 300 digits.
template <class Triangulation, class Shape>
int compare_opposite_angles(Referee<Triangulation, Shape>& referee, const Triangulation& t, FG::Halfedge_index h)
{
  const FG::Halfedge_index other = t.twin(h);
  const Real_vector k = referee.rotation(t.twin(t.next(h)), t.previous(h)),
                    l = referee.rotation(t.twin(t.next(other)), t.previous(other));
  const int at_k = sign_beside(k.x, boost::multiprecision::sqrt(squared_norm(k))),
            at_l = sign_beside(l.x, boost::multiprecision::sqrt(squared_norm(l)));
  if(at_k == at_l)
    return -at_k;
  const Real_vector sum = k * l;
  return -sign_beside(sum.y, boost::multiprecision::sqrt(squared_norm(sum)));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_referee_agrees_on_what_is_delaunay)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Certified_traits>;
  using Shape = Shape_of_points<Surface>;
  int decisions = 0, ties = 0, disagreements = 0;
  for(const std::vector<Named_soup>& soups : {soups_full_of_ties(), soups_near_ties(), generic_soups()})
    for(const Named_soup& named : soups) {
      const Surface mesh = to_mesh<Surface>(named.soup);
      Triangulation t(mesh);
      Random_numbers random(1);
      for(int round = 0; round < 2; ++round) {
        Referee<Triangulation, Shape> referee(t, Shape(mesh));
        for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(t.number_of_edges())) {
          const FG::Halfedge_index h = FG::internal::first_side(e);
          if(t.is_border(h) || t.is_border(t.twin(h)))
            continue;
          try {
            const int comparison = compare_opposite_angles(referee, t, h);
            disagreements += t.is_locally_delaunay(h) == (comparison <= 0) ? 0 : 1;
            ties += comparison == 0 ? 1 : 0;
            ++decisions;
          } catch(const No_order&) {
          }
        }
        flip_at_random(t, 150 * scale, random);
      }
      BOOST_TEST_CONTEXT(named.name)
      {
        BOOST_TEST(flip_to_delaunay(t, 100000) >= 0);
        BOOST_TEST(are_all_edges_delaunay(t));
      }
    }
  std::cout << decisions << " edges, " << ties << " with cocircular points\n";
  BOOST_TEST(disagreements == 0);
  BOOST_TEST(ties > 1000);
}

// A metric of exact squared lengths, of which no points are used: arithmetic with roots decides.
using Planeless_metric = Metric_with_squares<Point_metric>;

// A grid of which one direction is that of rulings, over a profile that is the same from both ends.
Mesh_soup extrusion(const Coordinates& ruling, const std::vector<Coordinates>& half)
{
  const int n = static_cast<int>(half.size()) - 1;
  return mapped(flat_grid(2 * n, 6, Diagonal_rule::RANDOM), [&](const Coordinates& p) {
    const int i = static_cast<int>(p[0]);
    const Coordinates& from = half[static_cast<std::size_t>(std::abs(i - n))];
    const double side = i < n ? -1 : 1;
    Coordinates result;
    for(std::size_t k = 0; k < 3; ++k)
      result[k] = side * from[k] + p[1] * ruling[k];
    return result;
  });
}

std::vector<Named_soup> walls()
{
  const std::vector<Coordinates> half = {{0, 0, 0}, {3, 1, 0}, {4, 3, 1}, {7, 4, 3}, {8, 9, 4}},
                                 folded = {{0, 0, 0}, {6, 2, 0}, {3, 1, 0}, {4, 5, 0}, {9, 6, 0}};
  return {{"walls", extrusion({0, 0, 1}, half)},
          {"walls along another axis", extrusion({-2, 0, 0}, half)},
          {"slanted walls", extrusion({1, -2, 5}, half)},
          {"folded walls", extrusion({0, 0, 1}, folded)}};
}

BOOST_AUTO_TEST_CASE(planes_and_walls_are_decided_as_by_roots)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Certified_traits>;
  using Planeless = FG::Intrinsic_triangulation<Surface, Certified_traits, Planeless_metric>;
  std::vector<Named_soup> soups = soups_full_of_ties();
  soups.push_back({"cylinder", cylinder(12, 5, 1, 3)});
  soups.push_back({"thin cylinder", cylinder(31, 4, 0.1, 7)});
  soups.push_back({"far cylinder", translated(cylinder(7, 6, 1, 3), 1e5, 0.1, 0)});
  soups.push_back(
      {"walls beside degenerate faces", extrusion({0, 0, 1}, {{0, 0, 0}, {0, 0, 0.5}, {4, 3, 0}, {4, 3, 0.25}})});
  const std::size_t first_wall = soups.size();
  for(const Named_soup& wall : walls())
    soups.push_back(wall);
  Random_numbers random(12);
  FG::Decision_statistics all;
  for(std::size_t k = 0; k < soups.size(); ++k) {
    const Named_soup& shape = soups[k];
    const Surface mesh = to_mesh<Surface>(shape.soup);
    Triangulation triangulation(mesh);
    Planeless planeless(mesh, Planeless_metric(get(CGAL::vertex_point, mesh)));
    int wrong = 0;
    for(int i = 0; i < 600 * scale; ++i) {
      const FG::Halfedge_index h(random.below(2 * triangulation.number_of_edges()));
      if(triangulation.is_border(h) || triangulation.is_border(triangulation.twin(h)))
        continue;
      wrong += triangulation.is_reflex_at_head(h) == planeless.is_reflex_at_head(h) ? 0 : 1;
      if(triangulation.is_flippable(h)) {
        triangulation.flip(h);
        planeless.flip(h);
      }
    }
    BOOST_TEST(wrong == 0, shape.name);
    BOOST_TEST(planeless.decision_statistics().by_plane == 0u);
    BOOST_TEST(triangulation.decision_statistics().zeros_by_plane > 0u, shape.name);
    BOOST_TEST(triangulation.decision_statistics().zeros_by_roots < planeless.decision_statistics().zeros_by_roots);
    if(k >= first_wall)
      BOOST_TEST(triangulation.decision_statistics().by_roots == 0u, shape.name);
    std::cout << shape.name << ": " << triangulation.decision_statistics().zeros_by_plane << " zeros by plane, "
              << triangulation.decision_statistics().zeros_by_roots << " by roots of "
              << planeless.decision_statistics().zeros_by_roots << '\n';
    all += triangulation.decision_statistics();
  }
  // Only the angles that are exactly straight are zeros.
  BOOST_TEST(all.zeros_by_plane < all.by_plane);
}

// The corner from each halfedge of a flipped triangulation to the next, as stored, against 300 digits.
BOOST_AUTO_TEST_CASE(error_bounds_hold)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Certified_traits>;
  using Shape = Shape_of_points<Surface>;
  double largest_share = 0, largest_bound = 0;
  for(const std::vector<Named_soup>& soups : {soups_full_of_ties(), soups_near_ties(), generic_soups()})
    for(const Named_soup& named : soups) {
      Surface mesh = to_mesh<Surface>(named.soup);
      Triangulation triangulation(mesh);
      Random_numbers random(1);
      flip_at_random(triangulation, 2000 * scale, random);
      Referee<Triangulation, Shape> referee(triangulation, Shape(mesh));
      for(FG::Halfedge_index h(0); h.idx() < triangulation.number_of_halfedges(); ++h) {
        if(triangulation.is_border(h))
          continue;
        const FG::Halfedge_index hn = triangulation.next(h);
        const auto in = triangulation.geometry(h), out = triangulation.geometry(hn);
        const Real length =
            referee.length(triangulation.edge_sequence(h)) * referee.length(triangulation.edge_sequence(hn));
        Real_vector exact = referee.rotation(Triangulation::twin(h), hn);
        const Real factor = length / boost::multiprecision::sqrt(squared_norm(exact));
        exact = exact * Real_vector{factor, 0};
        const Real_vector stored = Real_vector{out.x, -Real(out.y)} * Real_vector{-Real(in.x), -Real(in.y)};
        const double error =
            Real(boost::multiprecision::sqrt(squared_norm(stored - exact)) / length).convert_to<double>();
        const double bound = in.error + out.error + in.error * out.error;
        largest_share = (std::max)(largest_share, error / bound);
        largest_bound = (std::max)(largest_bound, bound);
      }
    }
  std::cout << "errors are at most " << largest_share << " of their bounds, which are at most " << largest_bound
            << "\n";
  BOOST_TEST(largest_share < 1);
}

// The lengths of edges and the angles between neighbors, as numbers of 106 bits, against 300 digits.
BOOST_AUTO_TEST_CASE(error_bounds_of_precise_edges_hold)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Certified_traits>;
  using Shape = Shape_of_points<Surface>;
  const auto real = [](const FG::internal::Double_double& a) { return Real(a.high) + Real(a.low); };
  double largest_share = 0, largest_bound = 0;
  int edges = 0, unbounded = 0;
  for(const std::vector<Named_soup>& soups : {soups_full_of_ties(), soups_near_ties(), generic_soups()})
    for(const Named_soup& named : soups) {
      Surface mesh = to_mesh<Surface>(named.soup);
      Triangulation triangulation(mesh);
      Random_numbers random(2);
      flip_at_random(triangulation, 2000 * scale, random);
      Referee<Triangulation, Shape> referee(triangulation, Shape(mesh));
      for(FG::Halfedge_index h(0); h.idx() < triangulation.number_of_halfedges(); ++h) {
        const FG::Halfedge_index next = triangulation.clockwise(h);
        if(next == FG::null_index)
          continue;
        ++edges;
        const FG::internal::Precise_wedge<Triangulation> wedge(triangulation, h, next);
        if(!wedge.has_bound()) {
          ++unbounded;
          continue;
        }
        const FG::Edge_sequence word = triangulation.edge_sequence(h);
        if(!word.crossed.empty()) { // derived from other edges only where that is accurate, else unfolded from an end
          const auto error = [&](const FG::Edge_sequence& way) {
            return FG::internal::Precise_strip<Triangulation>(triangulation, way, false).edge().end_error;
          };
          const double unfolded = (std::max)(error(word), error(word.reversed()));
          BOOST_TEST(wedge.from().end_error <= (std::max)(2 * unfolded, 0x1p-63) + 2 * wedge.from().direction_error);
        }
        const auto& end = wedge.from().end;
        const Real length = boost::multiprecision::sqrt(squared_norm({real(end.x), real(end.y)}));
        const Real exact_length = referee.length(word);
        FG::internal::Double_double_vector turn = {{1, 0}, {}};
        double bound = 0;
        wedge.extend(turn, bound);
        const Real_vector computed = {real(turn.x), real(turn.y)}, exact = referee.rotation(h, next);
        const Real factor = boost::multiprecision::sqrt(squared_norm(computed) / squared_norm(exact));
        const Real_vector error = computed - Real_vector{factor, 0} * exact;
        const Real shares[] = {boost::multiprecision::abs(length - exact_length) / (wedge.from().end_error * length),
                               boost::multiprecision::sqrt(squared_norm(error) / squared_norm(computed)) / bound};
        for(const Real& share : shares)
          largest_share = (std::max)(largest_share, share.convert_to<double>());
        largest_bound = (std::max)(largest_bound, bound);
      }
    }
  std::cout << edges << " edges: errors are at most " << largest_share << " of their bounds, which are at most "
            << largest_bound << "; " << unbounded << " have none\n";
  BOOST_TEST(largest_share < 1);
  BOOST_TEST(largest_bound < 1e-12);
  BOOST_TEST(20 * unbounded < edges);
}

// Between input vertices, and at inserted ones, whose edges have no vectors of about 100 bits.
BOOST_AUTO_TEST_CASE(faces_laid_out_afresh_have_small_errors)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Certified_traits>;
  for(const Named_soup& named : generic_soups()) {
    const Surface mesh = to_mesh<Surface>(named.soup);
    Triangulation triangulation(mesh);
    Random_numbers random(3);
    for(int i = 0; i < 20; ++i) {
      const FG::Input_halfedge_index h(random.below(triangulation.input().number_of_halfedges()));
      if(!triangulation.input().is_border(h))
        triangulation.insert({h, {{1, random.uniform(0.5, 1), i % 3 == 0 ? 0 : random.uniform(0.5, 1)}}});
    }
    flip_at_random(triangulation, 300, random);
    for(FG::Halfedge_index h(0); h.idx() < triangulation.number_of_halfedges(); ++h) {
      if(triangulation.is_border(h))
        continue;
      BOOST_TEST(FG::internal::refresh_face(triangulation, h));
      BOOST_TEST(triangulation.geometry(h).error < 1e-9);
    }
  }
}

// An edge all but opposite to its reference halfedge had the angle -pi instead of pi by rounding.
BOOST_AUTO_TEST_CASE(an_angle_that_rounds_to_minus_pi)
{
  const Mesh_soup soup = {{{-0x1.413f4c900bf68p-58, -0x1.4d063e0c8fcbp-57, 0x1.ac3a387e75268p-59},
                           {0x1.eafab5f2e3df9p-3, -0x1.10c42c319b0a7p-1, 0x1.4751cea1ed3fbp-2},
                           {0x1.eafab5f2e3dfbp-4, -0x1.10c42c319b0a7p-2, 0x1.4751cea1ed3fbp-3},
                           {-0x1.eafab5f2e3df1p-4, 0x1.10c42c319b0a4p-2, -0x1.4751cea1ed3f8p-3},
                           {-0x1.eafab5f2e3df7p-3, 0x1.10c42c319b0a7p-1, -0x1.4751cea1ed3fbp-2},
                           {-0x1.eafab5f2e3dfdp-4, 0x1.10c42c319b0abp-2, -0x1.4751cea1ed4p-3},
                           {0x1.eafab5f2e3df9p-4, -0x1.10c42c319b0a7p-2, 0x1.4751cea1ed3fbp-3},
                           {0x1.eafab5f2e3df8p-2, -0x1.10c42c319b0a7p+0, 0x1.4751cea1ed3fbp-1},
                           {0x1.eafab5f2e3dfbp-3, -0x1.10c42c319b0a7p-1, 0x1.4751cea1ed3fcp-2},
                           {-0x1.eafab5f2e3df2p-3, 0x1.10c42c319b0a4p-1, -0x1.4751cea1ed3f9p-2},
                           {-0x1.eafab5f2e3df8p-2, 0x1.10c42c319b0a7p+0, -0x1.4751cea1ed3fbp-1},
                           {-0x1.eafab5f2e3dffp-3, 0x1.10c42c319b0abp-1, -0x1.4751cea1ed3ffp-2},
                           {0x1.eafab5f2e3dfap-3, -0x1.10c42c319b0a7p-1, 0x1.4751cea1ed3fcp-2}},
                          {{0, 1, 2},
                           {0, 2, 3},
                           {0, 3, 4},
                           {0, 4, 5},
                           {0, 5, 6},
                           {0, 6, 1},
                           {1, 7, 8},
                           {1, 8, 2},
                           {2, 8, 9},
                           {2, 9, 3},
                           {3, 9, 10},
                           {3, 10, 4},
                           {4, 10, 11},
                           {4, 11, 5},
                           {5, 11, 12},
                           {5, 12, 6},
                           {6, 12, 7},
                           {6, 7, 1}}};
  judge_soups({{"all but a segment", soup}}, 40);
}

// These lengths violate the triangle inequality, but the sum of the short ones rounds to the long one.
BOOST_AUTO_TEST_CASE(lengths_that_violate_the_triangle_inequality_by_less_than_rounding)
{
  const auto has_face = [](double a, double b, double c) {
    Surface mesh = to_mesh<Surface>(single_triangle());
    const double lengths[] = {a, b, c};
    Lengths map = edge_lengths(mesh, [&](int u, int v) { return lengths[u + v - 1]; });
    FG::Intrinsic_triangulation<Surface, Certified_traits, Length_metric> triangulation(
        mesh, Length_metric(mesh, Length_map(map)));
    try {
      triangulation.outgoing(0_v);
      return true;
    } catch(const FG::Degenerate_face_error&) {
      return false;
    }
  };
  BOOST_TEST(!has_face(1, 0x1.8p-53, 1 + 0x1p-52));
  BOOST_TEST(!has_face(0x1.8p-53, 1 + 0x1p-52, 1));
  BOOST_TEST(has_face(1, 0x1p-52, 1 + 0x1p-52));
  BOOST_TEST(has_face(1, 0x1.8p-52, 1 + 0x1p-52));
}
