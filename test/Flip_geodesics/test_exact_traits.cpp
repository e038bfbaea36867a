// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE exact_traits

// Number types without roots, on meshes with one radicand.

#include "descriptors.h"
#include "number_type_checks.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Sqrt_extension.h>

#include <boost/mpl/list.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <string>
#include <type_traits>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using Gmpq = CGAL::Gmpq;
using Rational = boost::multiprecision::cpp_rational;
using Extension = CGAL::Sqrt_extension<Gmpq, Gmpq>;
#ifdef FLIP_GEODESICS_TEST_ALL_CASES
using Number_types = boost::mpl::list<Gmpq, Rational, Extension>;
#else // the second agrees with the first below, and has test_number_types
using Number_types = boost::mpl::list<Gmpq, Extension>;
#endif

namespace {

#ifdef FLIP_GEODESICS_LONG_TESTS
constexpr int scale = 20;
#else
constexpr int scale = 1;
#endif

template <class NT>
Exact_traits<NT> traits_with_radicand(int radicand)
{
  return Exact_traits<NT>(typename Exact_traits<NT>::Radicand(radicand));
}

// The unit of areas is the root itself where the number type has it.
template <class NT>
NT unit_radicand(int radicand)
{
  return std::is_same<NT, Extension>::value ? NT(1) : NT(radicand);
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(same_words_as_certified, NT, Number_types)
{
  check_same_curves_as_certified(tieless_plane(7, 1), Exact_traits<NT>(), 60 * scale);
  check_same_curves_as_certified(oblique(tieless_plane(7, 3)), traits_with_radicand<NT>(3), 60 * scale);
  // Corners have equal angles, and among these rounded keys choose: seldom, and not in these rounds.
  check_same_curves_as_certified(jittered_cube(4, 2), Exact_traits<NT>(), 60);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(ties_in_the_plane, NT, Number_types)
{
  check_grid<NT>(7);
  check_overlapping_paths<NT>(8);
  check_right_triangles<NT>(6);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(ties_in_space, NT, Number_types)
{
  check_genus_3_loops<NT>(2);
  check_tetrahedron_loop(traits_with_radicand<NT>(3), 2);
  check_tetrahedron_loop(traits_with_radicand<NT>(3), 6);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(random_networks_with_ties_are_certified, NT, Number_types)
{
  for(const Mesh_soup& soup : {cube(3), tetrahedron(4), octahedron(3)}) {
    const Surface mesh = to_mesh<Surface>(soup);
    Exact_setting<NT> setting(soup, Exact_traits<NT>(FG::common_radicand<typename Exact_traits<NT>::Radicand>(mesh)));
    Random_numbers random(4);
    int networks = 0;
    for(int i = 0; i < 40 * scale; ++i) {
      for(int c = 0; c <= i % 2; ++c) {
        const Halfedge_sequence walk = random_walk(setting.triangulation, 12, i % 4 < 2, random);
        if(!walk.empty())
          setting.network.add_curve(walk, CGAL::parameters::is_closed(i % 4 < 2));
      }
      if(setting.network.is_valid()) {
        BOOST_TEST(setting.pull().is_complete());
        BOOST_TEST(FG::certify(setting.network).is_locally_shortest());
        ++networks;
      }
      take_back(setting);
    }
    BOOST_TEST(networks >= 10 * scale);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(flips_are_exact, NT, Number_types)
{
  check_flips(tieless_plane(4, 5), Exact_traits<NT>(), NT(1), 200);
  check_flips(jittered_cube(2, 6), Exact_traits<NT>(), NT(1), 200);
  check_flips(tetrahedron(2), traits_with_radicand<NT>(3), unit_radicand<NT>(3), 200);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(delaunay_edges_are_told_exactly, NT, Number_types)
{
  check_delaunay(flat_grid(5, 5, Diagonal_rule::RANDOM), Exact_traits<NT>(), 60);
  check_delaunay(jittered_cube(3, 2), Exact_traits<NT>(), 60);
  check_delaunay(octahedron(3), traits_with_radicand<NT>(3), 60);
}

// The field with the root itself in it, and rationals that count in its unit, are two implementations of one thing:
// they agree step by step, even among equal angles.
BOOST_AUTO_TEST_CASE(number_types_agree)
{
  for(const Mesh_soup& soup : {octahedron(4), tetrahedron(5)}) {
    Exact_setting<Gmpq> gmpq(soup, traits_with_radicand<Gmpq>(3));
    Exact_setting<Extension> extension(soup, traits_with_radicand<Extension>(3));
    BOOST_TEST(check_same_curves(extension, gmpq, 60 * scale, 8) > 60u);
  }
  // Another representative of the radicand, and another conversion to double.
  const Mesh_soup soup = oblique(tieless_plane(6, 9));
  Exact_setting<Gmpq> gmpq(soup, traits_with_radicand<Gmpq>(3));
  Exact_setting<Rational> rational(soup, traits_with_radicand<Rational>(12));
  BOOST_TEST(check_same_curves(rational, gmpq, 60 * scale, 8) > 60u);
}

// ---------------------------------------------------------------- radicands

namespace {

Gmpq radicand_of(const Mesh_soup& soup) { return FG::common_radicand<Gmpq>(to_mesh<Surface>(soup)); }

} // namespace

BOOST_AUTO_TEST_CASE(radicands_are_found)
{
  BOOST_TEST((radicand_of(flat_grid(3, 3, Diagonal_rule::RANDOM)) == Gmpq(1)));
  BOOST_TEST((radicand_of(tieless_plane(3, 1)) == Gmpq(1)));
  BOOST_TEST((radicand_of(genus_3_plate(1)) == Gmpq(1)));
  BOOST_TEST((radicand_of(tetrahedron(3)) == Gmpq(3)));
  BOOST_TEST((radicand_of(scaled(octahedron(2), 0.1)) == Gmpq(3)));
  // Squares of large primes stay in a radicand that is not one.
  const Mesh_soup needle = {{{0, 0, 0}, {1009, 0, 0}, {0, 1, 1009}}, {{0, 1, 2}}};
  BOOST_TEST((radicand_of(needle) == Gmpq(1009 * 1009) * Gmpq(1 + 1009 * 1009)));
  const Mesh_soup flat = {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}};
  BOOST_TEST((radicand_of(flat) == Gmpq(1)));
}

BOOST_AUTO_TEST_CASE(radicands_of_lengths_are_found)
{
  const Surface mesh = to_mesh<Surface>(octahedron(2));
  std::map<boost::graph_traits<Surface>::edge_descriptor, double> lengths;
  for(const auto e : edges(mesh))
    lengths[e] = 0.3; // whatever the double is: equilateral
  BOOST_TEST((FG::common_radicand<Rational>(mesh, Length_metric(mesh, Length_map(lengths))) == Rational(3)));
}

BOOST_AUTO_TEST_CASE(large_radicands_convert)
{
  const FG::internal::Integer n = FG::internal::Integer(12345678901234567890u) * 10000000000 + 1234567890;
  BOOST_TEST((FG::internal::converted<Rational>(n) == Rational("123456789012345678901234567890")));
  BOOST_TEST((FG::internal::converted<Gmpq>(n) == Gmpq("123456789012345678901234567890/1")));
}

BOOST_AUTO_TEST_CASE(meshes_without_a_radicand_are_reported)
{
  BOOST_CHECK_THROW(radicand_of(sphere(2)), FG::Inexact_root_error);
  // A right isosceles triangle and an equilateral one.
  const Mesh_soup soup = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}, {{0, 1, 2}, {1, 3, 2}}};
  try {
    radicand_of(soup);
    BOOST_ERROR("no exception");
  } catch(const FG::Inexact_root_error& error) {
    BOOST_TEST(error.elements().size() == 3u);
    BOOST_TEST(std::string(error.what()).find("not a rational multiple") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(faces_that_do_not_fit_are_reported, NT, Number_types)
{
  Exact_setting<NT> setting(tetrahedron(2));
  BOOST_CHECK_THROW(setting.triangulation.length(0_h), FG::Inexact_root_error);
  Exact_setting<NT> sphere_setting(sphere(2), traits_with_radicand<NT>(3));
  BOOST_CHECK_THROW(sphere_setting.add_path(0_v, 3_v); sphere_setting.pull(), FG::Inexact_root_error);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(bad_faces_are_reported_as_elsewhere, NT, Number_types)
{
  const Mesh_soup soup = {{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}};
  Exact_setting<NT> setting(soup);
  BOOST_CHECK_THROW(setting.triangulation.length(0_h), FG::Degenerate_face_error);
}

// A face of area zero is a face like any other.
BOOST_AUTO_TEST_CASE_TEMPLATE(flat_faces_are_exact, NT, Number_types)
{
  const Mesh_soup soup = {{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}},
                          {{0, 3, 2}, {3, 1, 2}, {0, 1, 3}, {0, 4, 1}}};
  Exact_setting<NT> setting(soup);
  setting.add({2_v, 3_v, 1_v, 4_v}, false);
  BOOST_TEST(setting.pull().is_complete());
  BOOST_TEST(std::abs(setting.network.length(0_c) - 2) < 1e-12);
  BOOST_TEST(FG::certify(setting.network).is_locally_shortest());
}

// ---------------------------------------------------------------- coordinates

// Points of a kernel over the number type itself are not rounded.
BOOST_AUTO_TEST_CASE(coordinates_need_not_be_doubles)
{
  using Kernel = CGAL::Simple_cartesian<Gmpq>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Triangulation = FG::Intrinsic_triangulation<Mesh, FG::Exact_intrinsic_triangulation_traits<Gmpq, Kernel>>;
  Mesh mesh = to_mesh<Mesh>(flat_grid(5, 5, Diagonal_rule::ALTERNATING));
  for(const auto v : vertices(mesh))
    mesh.point(v) = Kernel::Point_3(mesh.point(v).x() / 3, mesh.point(v).y() / 7, 0);
  Triangulation triangulation(mesh);
  FG::Edge_path_network<Triangulation> network(triangulation);
  network.add_curve(FG::halfedges_through(triangulation, vertex_path_on_grid(5, {{0, 0}, {4, 0}, {4, 5}})));
  FG::shorten(network);
  BOOST_TEST(network.halfedges(0_c).size() == 1u);
  BOOST_TEST((triangulation.squared_length(network.halfedges(0_c).front()) == Gmpq(16, 9) + Gmpq(25, 49)));
}

// Turns whose numbers leave the range of double still have an order.
BOOST_AUTO_TEST_CASE_TEMPLATE(keys_of_long_numbers, NT, Number_types)
{
  const Exact_traits<NT> traits;
  const auto key = traits.turn_key_object();
  NT huge(1);
  for(int i = 0; i < 20; ++i)
    huge *= NT(1e60);
  typename Exact_traits<NT>::Turn turn;
  for(const NT& factor : {NT(1), huge, NT(NT(1) / huge)}) {
    double last = -1;
    for(const auto& [x, y] : {std::array<int, 2>{1, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 1}, {-1, 3}, {-2, 1}}) {
      turn.x = NT(x) * factor;
      turn.y = NT(y) * factor;
      const double expected = 1 - x / (std::abs(x) + double(y));
      BOOST_TEST(std::abs(key(turn) - expected) < 1e-14);
      BOOST_TEST(key(turn) > last);
      last = key(turn);
    }
  }
}
