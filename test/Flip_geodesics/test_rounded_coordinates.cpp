// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE rounded_coordinates

#include "test_scale.h"

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Curve_editor.h>
#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/certify_curve.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Decisions refer to coordinates and lengths exactly if they are doubles or rational numbers of an exact type. Nothing
// may be certain of a mesh that has others.

namespace FG = CGAL::Flip_geodesics;
using FG::Shortening_status;
using FG::Verdict;
using FG::Vertex_index;

namespace {

constexpr int cells = 4;

// A flat grid whose cells have given sides.
template <class Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> flat_grid(const typename Kernel::FT& width,
                                                       const typename Kernel::FT& height)
{
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using FT = typename Kernel::FT;
  Mesh mesh;
  std::vector<typename Mesh::Vertex_index> v;
  for(int j = 0; j <= cells; ++j)
    for(int i = 0; i <= cells; ++i)
      v.push_back(mesh.add_vertex({FT(i) * width, FT(j) * height, FT(0)}));
  for(std::size_t j = 0, n = cells + 1; j < cells; ++j)
    for(std::size_t i = 0; i < cells; ++i) {
      mesh.add_face(v[i + j * n], v[i + 1 + j * n], v[i + 1 + (j + 1) * n]);
      mesh.add_face(v[i + j * n], v[i + 1 + (j + 1) * n], v[i + (j + 1) * n]);
    }
  return mesh;
}

// A diagonal across the vertices of the grid, against the diagonals of its faces; and all corners for a path between.
struct Ends
{
  std::size_t source, target;
};

const std::vector<Ends> pairs = {{cells, cells*(cells + 1)},
                                 {0, (cells + 1) * (cells + 1) - 1},
                                 {1, (cells + 1) * (cells + 1) - 2},
                                 {0, cells},
                                 {cells, (cells + 1) * (cells + 1) - 1}};

// Every word of certainty is right, or none is used.
template <class Mesh>
void check_curves(const Mesh& mesh, bool is_certain)
{
  using Vertex = typename Mesh::Vertex_index;
  for(const Ends& ends : pairs) {
    const Vertex s(static_cast<typename Vertex::size_type>(ends.source)),
        t(static_cast<typename Vertex::size_type>(ends.target));
    std::vector<typename Mesh::Point> points;
    const auto path = FG::geodesic_path(mesh, s, t, std::back_inserter(points));
    BOOST_TEST((path.verdict() == Verdict::PROVEN) == is_certain);
    BOOST_TEST((path.verdict() == Verdict::UNDECIDED) == !is_certain);
    BOOST_TEST(path.report.is_complete());
    const auto shortest = FG::shortest_path(mesh, s, t, std::back_inserter(points)).report;
    BOOST_TEST((shortest.verdict == FG::Verdict::WITHIN_ROUNDING) == is_certain);
    BOOST_TEST(shortest.is_confirmed() == is_certain);
    BOOST_TEST(shortest.shortening.is_complete());
  }
}

// The same between points that are made vertices.
template <class Mesh>
void check_points(const Mesh& mesh, bool is_certain)
{
  using Face = typename Mesh::Face_index;
  const auto last = static_cast<typename Mesh::size_type>(mesh.number_of_faces()) - 1;
  const std::array<double, 3> inside = {{0.5, 0.25, 0.25}}, on_side = {{0.5, 0.5, 0}};
  std::vector<typename Mesh::Point> points;
  const auto check = [&](const auto& source, const auto& target) {
    const auto shortest = FG::shortest_path(mesh, source, target, std::back_inserter(points)).report;
    BOOST_TEST((shortest.verdict == Verdict::WITHIN_ROUNDING) == is_certain);
    BOOST_TEST((shortest.verdict == Verdict::UNDECIDED) == !is_certain);
    BOOST_TEST(shortest.shortening.is_complete());
  };
  check(std::pair(Face(0), inside), std::pair(Face(last), inside));
  check(std::pair(Face(0), on_side), *mesh.vertices().begin());
  check(std::pair(Face(0), inside), std::pair(Face(0), on_side));
  check(std::pair(Face(0), inside), std::pair(Face(0), inside));
}

template <class Mesh>
void check_fields(Mesh& mesh, bool is_certain)
{
  using Vertex = typename Mesh::Vertex_index;
  auto distances = mesh.template add_property_map<Vertex, double>("v:distance", 0).first;
  auto coordinates = mesh.template add_property_map<Vertex, FG::Polar_coordinates>("v:polar").first;
  BOOST_TEST(FG::geodesic_distances(mesh, Vertex(7), distances).is_confirmed() == is_certain);
  BOOST_TEST(FG::logarithmic_map(mesh, Vertex(7), coordinates).is_confirmed() == is_certain);
}

// The lower side of the grid, as a curve from elsewhere.
template <class Mesh>
void check_given_curve(const Mesh& mesh, bool is_certain)
{
  using Vertex = typename Mesh::Vertex_index;
  const std::vector<Vertex> side = {Vertex(0), Vertex(1), Vertex(2)};
  BOOST_TEST((FG::certify_curve(mesh, side).verdict() == Verdict::PROVEN) == is_certain);
  const std::vector<Vertex> bent = {Vertex(0), Vertex(1), Vertex(cells + 2)};
  BOOST_TEST((FG::certify_curve(mesh, bent).verdict() == Verdict::UNDECIDED) == !is_certain);
}

template <class Mesh>
void check_edited_curve(const Mesh& mesh, bool is_certain)
{
  using Triangulation = FG::Intrinsic_triangulation<Mesh>;
  Triangulation triangulation(mesh);
  const auto at = [&](FG::Index v) { return triangulation.location(Vertex_index(v)); };
  FG::Curve_editor<Triangulation> editor(triangulation, {at(0), at(8), at(22)});
  for(std::size_t i = 0; i < editor.number_of_legs(); ++i)
    BOOST_TEST((editor.verdict(i) == Verdict::UNDECIDED) == !is_certain);
}

// A mesh type finds out in one place whether its coordinates are doubles, so that one type with others stands for all
// functions, and one function for all types. Each takes seconds to compile.
template <class Kernel>
constexpr bool takes_all_functions =
    Flip_geodesics_test::has_all_cases || std::is_same_v<typename Kernel::FT, CGAL::Gmpq> ||
    std::is_same_v<typename Kernel::FT, double>;

template <class Kernel>
void check_all(const typename Kernel::FT& width, const typename Kernel::FT& height, bool is_certain)
{
  auto mesh = flat_grid<Kernel>(width, height);
  check_given_curve(mesh, is_certain);
  if constexpr(takes_all_functions<Kernel>) {
    check_curves(mesh, is_certain);
    check_points(mesh, is_certain);
    check_fields(mesh, is_certain);
    check_edited_curve(mesh, is_certain);
  }
}

using Rational = CGAL::Gmpq;
using Rational_kernel = CGAL::Simple_cartesian<Rational>;
using Lazy_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Long_kernel = CGAL::Simple_cartesian<long double>;

} // namespace

BOOST_AUTO_TEST_CASE(rational_coordinates)
{
  check_all<Rational_kernel>(Rational(1, 3), Rational(1, 7), true);
  check_all<Rational_kernel>(Rational(1), Rational(3, 4), true);
}

// Lazy numbers need not have been evaluated before.
BOOST_AUTO_TEST_CASE(lazy_coordinates)
{
  using FT = Lazy_kernel::FT;
  check_all<Lazy_kernel>(FT(1) / FT(3), FT(1) / FT(7), true);
  check_all<Lazy_kernel>(FT(1), FT(3) / FT(4), true);
  check_all<Lazy_kernel>(FT(1) / FT(3) * FT(3), FT(5) / FT(7) * FT(7), true);
}

BOOST_AUTO_TEST_CASE(long_coordinates)
{
  static_assert(std::numeric_limits<double>::digits == 53);
  check_all<Long_kernel>(1, 0.75L, true);
  if(std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits)
    check_all<Long_kernel>(1 + 0x1p-60L, 0.75L, false);
}

BOOST_AUTO_TEST_CASE(coordinates_that_are_doubles)
{
  check_all<CGAL::Simple_cartesian<double>>(1 / 3., 0.75, true);
  check_all<CGAL::Simple_cartesian<float>>(1, 0.75f, true);
}

// One coordinate far from a curve suffices, so that verdicts do not depend on what was touched before.
BOOST_AUTO_TEST_CASE(a_single_rounded_coordinate)
{
  auto mesh = flat_grid<Long_kernel>(1, 1);
  std::vector<Long_kernel::Point_3> points;
  const auto path = [&] {
    return FG::geodesic_path(mesh, *mesh.vertices().begin(), *std::next(mesh.vertices().begin(), 2),
                             std::back_inserter(points));
  };
  BOOST_TEST((path().verdict() == Verdict::PROVEN));
  mesh.point(*std::next(mesh.vertices().begin(), (cells + 1) * (cells + 1) - 1)) = {cells, cells, 1 + 0x1p-60L};
  if(std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits)
    BOOST_TEST((path().verdict() == Verdict::UNDECIDED));
}

// Flips over the same number type and certificates refer to the same coordinates.
BOOST_AUTO_TEST_CASE(no_faces_are_called_flat_that_are_not)
{
  using Mesh = CGAL::Surface_mesh<Rational_kernel::Point_3>;
  using Traits = FG::Exact_intrinsic_triangulation_traits<Rational, Rational_kernel>;
  using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits>;
  for(const Rational& height : {Rational(1, 7), Rational(1, 4)}) {
    const Mesh mesh = flat_grid<Rational_kernel>(Rational(1, 3), height);
    for(const Ends& ends : pairs) {
      Triangulation triangulation(mesh, Traits());
      FG::Edge_path_network<Triangulation> network(triangulation);
      FG::Shortest_edge_path<Triangulation> search(triangulation);
      network.add_curve(
          search(Vertex_index(static_cast<FG::Index>(ends.source)), Vertex_index(static_cast<FG::Index>(ends.target))));
      const FG::Curve_report report = FG::shorten(network).curves.front();
      BOOST_TEST(FG::to_string(report.status) == std::string("LOCALLY_SHORTEST"));
      BOOST_TEST((report.verdict == Verdict::PROVEN));
      BOOST_TEST((FG::certify(network).curves.front().verdict() == Verdict::PROVEN));
    }
  }
}

namespace {

template <class Number>
Verdict verdict_over_lengths(const Number& length)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Mesh mesh = flat_grid<CGAL::Simple_cartesian<double>>(1, 1);
  auto lengths = mesh.add_property_map<Mesh::Edge_index, Number>("e:length", length).first; // equilateral triangles
  using Metric = FG::Edge_length_metric<Mesh, typename Mesh::template Property_map<Mesh::Edge_index, Number>>;
  using Traits = FG::Certified_intrinsic_triangulation_traits<typename Metric::Kernel>;
  using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits, Metric>;
  Triangulation triangulation(mesh, Metric(mesh, lengths));
  FG::Edge_path_network<Triangulation> network(triangulation);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  network.add_curve(search(Vertex_index(0), Vertex_index(9)));
  return FG::shorten(network).curves.front().verdict;
}

} // namespace

BOOST_AUTO_TEST_CASE(lengths_that_are_not_doubles)
{
  BOOST_TEST((verdict_over_lengths<double>(1 / 3.) == Verdict::PROVEN));
  BOOST_TEST((verdict_over_lengths<Rational>(Rational(3, 4)) == Verdict::PROVEN));
  BOOST_TEST((verdict_over_lengths<Rational>(Rational(1, 3)) == Verdict::PROVEN));
  if(std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits)
    BOOST_TEST((verdict_over_lengths<long double>(1 + 0x1p-60L) == Verdict::UNDECIDED));
}
