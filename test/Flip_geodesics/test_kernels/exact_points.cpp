// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Shortest paths between points of faces refer to exact coordinates, if the kernel has such.

#include "test_kernels/exact_coordinates.h"

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/shortest_paths_by_class.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost_mp.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using FG::Verdict;

namespace {

using Lazy_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Boost_kernel = CGAL::Simple_cartesian<boost::multiprecision::cpp_rational>;
using Double_kernel = CGAL::Simple_cartesian<double>;

template <class Mesh>
using Location = std::pair<typename Mesh::Face_index, std::array<double, 3>>;

// The point of a halfedge's face at weights of its tail, its head and the third corner.
template <class Mesh>
Location<Mesh> location(const Mesh& mesh, typename Mesh::Halfedge_index h, std::array<double, 3> weights)
{
  const auto f = mesh.face(h);
  for(auto first = mesh.halfedge(f); first != h; first = mesh.next(first))
    std::rotate(weights.begin(), weights.end() - 1, weights.end());
  return {f, weights};
}

// A path between two points of the edges av and vb, where v is not quite on the line from a to b: it leads along the
// edges, or passes v by on the side of one of two other vertices.
template <class Kernel>
void check_nearly_straight(const typename Kernel::FT& height, CGAL::Sign height_of_vertex)
{
  using FT = typename Kernel::FT;
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  Mesh mesh;
  const auto add = [&](const FT& x, const FT& y) { return mesh.add_vertex(typename Kernel::Point_3(x, y, FT(0))); };
  const auto a = add(-1, 1), v = add(0, height), b = add(1, 1), above = add(0, 2), below = add(0, 0);
  mesh.add_face(a, below, v);
  mesh.add_face(below, b, v);
  mesh.add_face(v, b, above);
  mesh.add_face(a, v, above);
  for(const double t : {0.5, 0.25, 1e-3}) {
    const auto s = location(mesh, mesh.halfedge(a, v), {{1 - t, t, 0}}),
               e = location(mesh, mesh.halfedge(v, b), {{t, 1 - t, 0}});
    std::vector<FG::Curve_point<Mesh, typename Kernel::Point_3>> points;
    const auto path = FG::shortest_path(mesh, s, e, std::back_inserter(points));
    BOOST_TEST((path.verdict() == Verdict::WITHIN_ROUNDING));
    BOOST_TEST(path.length() == 2 * (1 - t), boost::test_tools::tolerance(1e-14));
    BOOST_TEST_REQUIRE(points.size() == 3u);
    const auto crossed = points[1].halfedge;
    if(height_of_vertex == CGAL::ZERO) {
      BOOST_TEST((crossed == Mesh::null_halfedge()));
    } else {
      BOOST_TEST_REQUIRE((crossed != Mesh::null_halfedge()));
      const auto passed = height_of_vertex == CGAL::POSITIVE ? below : above;
      BOOST_TEST((mesh.source(crossed) == passed || mesh.target(crossed) == passed));
    }
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(points_beside_a_bend_that_doubles_do_not_show)
{
  const CGAL::Gmpq little = CGAL::Gmpq(1) / CGAL::Gmpq(1e21);
  check_nearly_straight<Rational_kernel>(1 + little, CGAL::POSITIVE);
  check_nearly_straight<Rational_kernel>(1 - little, CGAL::NEGATIVE);
  check_nearly_straight<Rational_kernel>(1, CGAL::ZERO);
  check_nearly_straight<Lazy_kernel>(1 + Lazy_kernel::FT(1) / Lazy_kernel::FT(1e21), CGAL::POSITIVE);
  check_nearly_straight<Lazy_kernel>(Lazy_kernel::FT(1) / Lazy_kernel::FT(3) * Lazy_kernel::FT(3), CGAL::ZERO);
  check_nearly_straight<Boost_kernel>(Boost_kernel::FT(1 - Boost_kernel::FT(1) / Boost_kernel::FT(1e21)),
                                      CGAL::NEGATIVE);
  check_nearly_straight<Double_kernel>(CGAL::to_double(1 + little), CGAL::ZERO);
}

namespace {

// Points with weights of few bits, on edges and inside.
template <class Random>
std::array<double, 3> random_weights(Random& random)
{
  constexpr unsigned parts = 8;
  const unsigned a = static_cast<unsigned>(random() % parts),
                 b = static_cast<unsigned>(random() % (parts - a)); // so that the third is never 0
  return {{a / 8., b / 8., (parts - a - b) / 8.}};
}

} // namespace

// The lengths and verdicts of rotated boxes are those of the integer box, whatever digits coordinates have.
BOOST_AUTO_TEST_CASE(points_on_rotated_boxes)
{
  const Lattice_surface box = lattice_box({4, 3, 2});
  const auto unrotated =
      mesh_of<Double_kernel>(box, [](const Lattice_point& p) { return Double_kernel::Point_3(p[0], p[1], p[2]); });
  const auto mesh = mesh_of<Lazy_kernel>(box, [&](const Lattice_point& p) {
    return rotated<Lazy_kernel>(p, {{5, 1, 0, 2}});
  });
  using Mesh = std::decay_t<decltype(unrotated)>;
  using Lazy_mesh = std::decay_t<decltype(mesh)>;
  std::mt19937 random(11);
  const auto face = [&] { return static_cast<Mesh::size_type>(random() % unrotated.number_of_faces()); };
  for(int i = 0; i < 60; ++i) {
    const auto f = face(), g = face();
    const std::array<double, 3> v = random_weights(random), w = random_weights(random);
    std::vector<Double_kernel::Point_3> points;
    std::vector<Lazy_kernel::Point_3> lazy_points;
    const auto expected = FG::shortest_path(unrotated, Location<Mesh>(Mesh::Face_index(f), v),
                                            Location<Mesh>(Mesh::Face_index(g), w), std::back_inserter(points));
    const auto found =
        FG::shortest_path(mesh, Location<Lazy_mesh>(Lazy_mesh::Face_index(f), v),
                          Location<Lazy_mesh>(Lazy_mesh::Face_index(g), w), std::back_inserter(lazy_points));
    BOOST_TEST((expected.verdict() == Verdict::WITHIN_ROUNDING));
    BOOST_TEST((found.verdict() == Verdict::WITHIN_ROUNDING));
    BOOST_TEST(std::abs(found.length() - expected.length()) <= 1e-13);
    BOOST_TEST(found.report.lower_bound <= found.length() * (1 + 1e-15));
    if(!found.report.has_tie)
      BOOST_TEST(lazy_points.size() == points.size());
  }
}

// A point in space is located on the mesh, and classes are found between points.
BOOST_AUTO_TEST_CASE(points_in_space_with_exact_coordinates)
{
  const auto mesh = mesh_of<Rational_kernel>(lattice_grid(4), in_odd_cells<Rational_kernel>);
  using FT = Rational_kernel::FT;
  const Rational_kernel::Point_3 above(FT(1) / FT(7), FT(1) / FT(9), FT(3) / FT(11)),
      other(1, FT(1) / FT(2), FT(1) / FT(11));
  std::vector<Rational_kernel::Point_3> points;
  const auto path = FG::shortest_path(mesh, above, other, std::back_inserter(points));
  const double expected = std::hypot(1 - 1 / 7., 1 / 2. - 1 / 9.);
  BOOST_TEST((path.verdict() == Verdict::WITHIN_ROUNDING));
  BOOST_TEST(path.length() == expected, boost::test_tools::tolerance(1e-13));
  const auto& distances = path.report.shortening.curves.front().point_distances;
  BOOST_TEST_REQUIRE(distances.size() == 2u);
  BOOST_TEST(distances[0] == 2 / 11., boost::test_tools::tolerance(1e-13));
  std::vector<std::vector<Rational_kernel::Point_3>> paths;
  const auto classes = FG::shortest_paths_by_class(mesh, above, other, 2, std::back_inserter(paths));
  BOOST_TEST((classes.status() == FG::Class_search_status::NO_MORE_CLASSES));
  BOOST_TEST(classes.report.is_confirmed());
  BOOST_TEST((classes.verdict(0) == Verdict::WITHIN_ROUNDING));
  BOOST_TEST(classes.length(0) == expected, boost::test_tools::tolerance(1e-13));
}

// Weights are rounded once, whether or not their exact values have been computed.
BOOST_AUTO_TEST_CASE(weights_of_lazy_numbers)
{
  using FT = Lazy_kernel::FT;
  const auto mesh = mesh_of<Lazy_kernel>(lattice_grid(4), in_odd_cells<Lazy_kernel>);
  const FG::Intrinsic_triangulation<std::decay_t<decltype(mesh)>> triangulation(mesh);
  for(int i = 1; i < 100; ++i) {
    std::array<FT, 3> weights = {{FT(i) / FT(300), FT(i) / FT(700), FT(1)}};
    weights[2] -= weights[0] + weights[1];
    const auto at = std::make_pair(*mesh.faces().begin(), weights);
    const auto before = FG::surface_location(triangulation, mesh, at);
    for(const FT& weight : weights)
      weight.exact();
    BOOST_TEST((FG::surface_location(triangulation, mesh, at).weights == before.weights));
    BOOST_TEST(before.weights[0] == i / 300.);
  }
}
