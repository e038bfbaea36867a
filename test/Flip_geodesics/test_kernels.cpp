// SPDX-License-Identifier: LGPL-3.0-or-later

// The package comes first, before any kernel: what it includes must not depend on what the user did.
#include <CGAL/Flip_geodesics.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#define BOOST_TEST_MODULE kernels
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <iterator>
#include <type_traits>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

namespace {

template <class Mesh, class Point>
std::vector<Point> path_on_tetrahedron()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1), mesh);
  const auto source = *vertices(mesh).begin(), target = *std::next(vertices(mesh).begin());
  std::vector<Point> points;
  const auto result = FG::geodesic_path(mesh, source, target, std::back_inserter(points));
  BOOST_CHECK(result.report.is_complete());
  BOOST_CHECK(result.verdict() == FG::Verdict::PROVEN);
  BOOST_CHECK_CLOSE_FRACTION(result.report.curves.front().length, std::sqrt(8.0), 1e-15);
  return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(points_of_an_inexact_kernel)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  const std::vector<Point> points = path_on_tetrahedron<CGAL::Surface_mesh<Point>, Point>();
  BOOST_REQUIRE_EQUAL(points.size(), 2u);
  BOOST_CHECK(points.front() == Point(1, 1, 1));
}

BOOST_AUTO_TEST_CASE(points_of_an_exact_kernel)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const std::vector<Kernel::Point_3> points = path_on_tetrahedron<CGAL::Polyhedron_3<Kernel>, Kernel::Point_3>();
  BOOST_REQUIRE_EQUAL(points.size(), 2u);
}

BOOST_AUTO_TEST_CASE(points_of_a_kernel_of_floats)
{
  using Point = CGAL::Simple_cartesian<float>::Point_3;
  BOOST_TEST((path_on_tetrahedron<CGAL::Surface_mesh<Point>, Point>().size() == 2u));
}

// A user-defined metric may lack what exact predicates require.
template <class Metric>
struct Metric_without_exact_faces
{
  using Mesh = typename Metric::Mesh;
  using Kernel = typename Metric::Kernel;
};

BOOST_AUTO_TEST_CASE(decisions_are_exact_where_they_can_be)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Metric = FG::Intrinsic_triangulation<Mesh>::Metric;
  using Lengths = FG::Edge_length_metric<Mesh, Mesh::Property_map<Mesh::Edge_index, double>>;
  using FG::Default_traits;
  using std::is_same_v;
  using Exact = FG::Certified_intrinsic_triangulation_traits<Kernel>;
  static_assert(is_same_v<FG::Intrinsic_triangulation<Mesh>::Traits, Exact>);
  static_assert(is_same_v<Default_traits<FG::Mollified_metric<Metric>>, Exact>);
  static_assert(is_same_v<Default_traits<Lengths>, FG::Certified_intrinsic_triangulation_traits<Lengths::Kernel>>);
  static_assert(
      is_same_v<Default_traits<Metric_without_exact_faces<Metric>>, FG::Intrinsic_triangulation_traits<Kernel>>);
}
