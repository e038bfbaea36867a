// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE exact_traits_roots

// Number types with square roots, on any mesh: exact, of 100 digits, double, and intervals.

#include "descriptors.h"
#include "number_type_checks.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using Expression = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;
using Long_float = boost::multiprecision::cpp_bin_float_100;
using Interval = CGAL::Interval_nt<>;

namespace {

#ifdef FLIP_GEODESICS_LONG_TESTS
constexpr int scale = 20;
#else
constexpr int scale = 1;
#endif

} // namespace

// ---------------------------------------------------------------- exact

BOOST_AUTO_TEST_CASE(expressions_give_the_same_words_as_certified)
{
  check_same_curves_as_certified(bumpy_sphere(4, 0.3, 1), Exact_traits<Expression>(), 30 * scale);
  check_same_curves_as_certified(tieless_plane(6, 2), Exact_traits<Expression>(), 12 * scale);
  check_same_curves_as_certified(shaken(torus(6, 5, 3, 1), 0.2, 3), Exact_traits<Expression>(), 30 * scale);
}

BOOST_AUTO_TEST_CASE(expressions_decide_ties)
{
  check_grid<Expression>(5);
  check_overlapping_paths<Expression>(6);
  check_right_triangles<Expression>(4);
  check_tetrahedron_loop(Exact_traits<Expression>(), 2);
  check_genus_3_loops<Expression>(1);
}

// The two sides of an edge are expressions of their own; to see that they are equal takes few flips, or long.
BOOST_AUTO_TEST_CASE(expressions_know_that_they_are_equal)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Exact_traits<Expression>>;
  const Surface mesh = to_mesh<Surface>(octahedron(1));
  Triangulation triangulation(mesh);
  Random_numbers random(1);
  BOOST_TEST(flip_at_random(triangulation, 3, random) > 1);
  BOOST_TEST(have_equal_sides(triangulation));
}

// ---------------------------------------------------------------- rounded

BOOST_AUTO_TEST_CASE(rounded_numbers_have_tolerances_of_half_their_digits)
{
  BOOST_TEST(Exact_traits<double>::angle_tolerance() < 2e-9);
  BOOST_TEST(Exact_traits<double>::angle_tolerance() > 1e-10);
  BOOST_TEST(Exact_traits<Long_float>::angle_tolerance() < 1e-50);
  BOOST_TEST(Exact_traits<Long_float>::angle_tolerance() > 1e-55);
  BOOST_TEST(Exact_traits<Expression>::angle_tolerance() == 0);
  BOOST_TEST(Exact_traits<Interval>::angle_tolerance() == 0);
}

BOOST_AUTO_TEST_CASE(hundred_digits_give_the_same_words_as_certified)
{
  const Exact_traits<Long_float> traits;
  check_same_curves_as_certified(bumpy_sphere(6, 0.3, 1), traits, 60 * scale);
  check_same_curves_as_certified(tieless_plane(7, 2), traits, 60 * scale);
  check_same_curves_as_certified(shaken(torus(8, 6, 3, 1), 0.2, 3), traits, 60 * scale);
  check_same_curves_as_certified(shaken(genus_3_plate(2), 0.1, 4), traits, 30 * scale);
}

BOOST_AUTO_TEST_CASE(hundred_digits_see_ties)
{
  Exact_setting<Long_float> grid(flat_grid(9, 9, Diagonal_rule::RANDOM));
  grid.add(vertex_path_on_grid(9, {{0, 0}, {9, 0}, {9, 9}}), false);
  check_proven(grid, std::sqrt(162));
  check_overlapping_paths<Long_float>(8);
  check_tetrahedron_loop(Exact_traits<Long_float>(), 6);
  check_genus_3_loops<Long_float>(2);
}

// Squared lengths and areas would have used up the digits.
BOOST_AUTO_TEST_CASE(hundred_digits_do_not_drift)
{
  Exact_setting<Long_float> setting(bumpy_sphere(40, 0.001, 5));
  setting.add_path(0_v, 1_v);
  BOOST_TEST(setting.pull().is_complete());
  BOOST_TEST(setting.triangulation.log_position() > 300u);
  for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(setting.triangulation.number_of_edges())) {
    const FG::Halfedge_index h = FG::internal::first_side(e);
    const auto squared_length = setting.triangulation.traits().compute_squared_length_object();
    const Long_float a = squared_length(setting.triangulation.geometry(h));
    const Long_float b = squared_length(setting.triangulation.geometry(setting.triangulation.twin(h)));
    BOOST_TEST((abs(a - b) < Long_float("1e-90")));
  }
}

BOOST_AUTO_TEST_CASE(double_gives_the_same_words_as_the_plain_traits)
{
  for(const Mesh_soup& soup : {bumpy_sphere(6, 0.3, 1), shaken(torus(8, 6, 3, 1), 0.2, 3)}) {
    Exact_setting<double> setting(soup);
    Curve_setting reference(soup);
    BOOST_TEST(check_same_curves(setting, reference, 100 * scale, 1) > 100u);
  }
}

BOOST_AUTO_TEST_CASE(doubles_of_any_size)
{
  for(const double size : {1e-60, 1e60}) {
    Exact_setting<double> setting(scaled(bumpy_sphere(6, 0.3, 1), size));
    BOOST_TEST(setting.pulled_path(0_v, 1_v).length > size);
    Exact_setting<Interval> intervals(scaled(bumpy_sphere(6, 0.3, 1), size));
    BOOST_TEST(intervals.pulled_path(0_v, 1_v).length > size);
  }
}

// ---------------------------------------------------------------- intervals

BOOST_AUTO_TEST_CASE(intervals_give_the_same_words_as_certified)
{
  const Exact_traits<Interval> traits;
  check_same_curves_as_certified(bumpy_sphere(6, 0.3, 1), traits, 60 * scale);
  check_same_curves_as_certified(tieless_plane(7, 2), traits, 60 * scale);
  check_same_curves_as_certified(shaken(torus(8, 6, 3, 1), 0.2, 3), traits, 60 * scale);
}

BOOST_AUTO_TEST_CASE(delaunay_edges_are_told)
{
  check_delaunay(bumpy_sphere(4, 0.3, 1), Exact_traits<Interval>(), 200);
  check_delaunay(bumpy_sphere(4, 0.3, 1), Exact_traits<Long_float>(), 200);
  check_delaunay(octahedron(3), Exact_traits<Long_float>(), 60);
  check_delaunay(octahedron(3), Exact_traits<Expression>(), 40);
}

// A long path goes through, since faces whose intervals have grown are laid out afresh.
BOOST_AUTO_TEST_CASE(intervals_are_narrowed)
{
  const Mesh_soup soup = bumpy_sphere(50, 0.001, 5);
  Exact_setting<Interval> setting(soup);
  Certified_setting reference(soup);
  setting.add_path(0_v, 1_v);
  reference.add_path(0_v, 1_v);
  setting.pull();
  reference.pull();
  BOOST_TEST(setting.network.halfedges(0_c) == reference.network.halfedges(0_c), boost::test_tools::per_element());
  int refreshes = 0;
  for(std::size_t i = 0; i < setting.triangulation.log_position(); ++i)
    refreshes += setting.triangulation.flip_record(i).hp == FG::null_index ? 1 : 0;
  BOOST_TEST(refreshes > 0);
}

namespace {

// Pulls and returns whether that threw; then takes everything back, and a curve without ties still comes out.
bool is_undecided(Exact_setting<Interval>& setting)
{
  bool is_undecided = false;
  try {
    setting.pull();
  } catch(const CGAL::Uncertain_conversion_exception&) {
    is_undecided = true;
  }
  BOOST_TEST(setting.network.is_valid());
  BOOST_TEST(setting.triangulation.is_valid());
  setting.network.clear();
  setting.triangulation.rollback();
  return is_undecided;
}

} // namespace

BOOST_AUTO_TEST_CASE(intervals_throw_on_ties)
{
  const Mesh_soup soup = tetrahedron(4);
  Exact_setting<Interval> setting(soup);
  setting.add(with_detours(soup, tetrahedron_loop(4), true), true);
  BOOST_TEST(is_undecided(setting));
  setting.add(tetrahedron_loop(4), true); // straight already, but nobody can tell
  BOOST_TEST(is_undecided(setting));

  Exact_setting<Interval> cone(cone_disk(6, 2, pi));
  cone.add(disk_arc(6, 1, 0, 2), false);
  BOOST_TEST(!is_undecided(cone));
}

// In integers there are no errors, and so no doubts.
BOOST_AUTO_TEST_CASE(intervals_of_small_integers_see_ties)
{
  Exact_setting<Interval> setting(flat_grid(6, 6, Diagonal_rule::RANDOM));
  setting.add(vertex_path_on_grid(6, {{0, 0}, {6, 0}, {6, 6}}), false);
  check_proven(setting, std::sqrt(72));
}

// A straight angle that is missed by 1e-14 is neither certain nor guessed.
BOOST_AUTO_TEST_CASE(near_ties_are_left_to_those_who_can)
{
  const auto bent = [](double by) {
    return Mesh_soup{{{-1 / 3.0, 0.1, 0.7}, {0, by, 0}, {1 / 3.0, -0.1, -0.7}, {0.1, 1.1, 0.2}, {-0.2, -1.3, 0.1}},
                     {{0, 1, 3}, {1, 2, 3}, {0, 4, 1}, {1, 4, 2}}};
  };
  for(const double by : {1e-9, -1e-9}) {
    Exact_setting<Interval> setting(bent(by));
    setting.add({0_v, 1_v, 2_v}, false);
    BOOST_TEST(!is_undecided(setting));
  }
  for(const double by : {1e-17, 0.0}) {
    Exact_setting<Interval> setting(bent(by));
    setting.add({0_v, 1_v, 2_v}, false);
    BOOST_TEST(is_undecided(setting));
  }
  Exact_setting<Expression> setting(bent(1e-17));
  setting.add({0_v, 1_v, 2_v}, false);
  BOOST_TEST(setting.pull().is_complete());
  BOOST_TEST(FG::certify(setting.network).is_locally_shortest());
}
