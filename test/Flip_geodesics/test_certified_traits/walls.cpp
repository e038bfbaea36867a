// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Angles over the crease between two planes, straight or nearly so.

#include "Curve_setting.h"
#include "mesh_soup.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

// How the angle at the origin over a fan of triangles compares with pi, from the last of the points on its rim
// clockwise to the first.
CGAL::Comparison_result compared_with_pi(const std::vector<Coordinates>& rim)
{
  using Triangulation =
      FG::Intrinsic_triangulation<Surface,
                                  FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>;
  Mesh_soup soup = {{{0, 0, 0}}, {}};
  soup.points.insert(soup.points.end(), rim.begin(), rim.end());
  const int last = static_cast<int>(rim.size());
  for(int i = 1; i < last; ++i)
    soup.triangles.push_back({0, i, i + 1});
  const Surface mesh = to_mesh<Surface>(soup);
  const Triangulation triangulation(mesh);
  const auto outgoing_halfedge = [&](int i) {
    for(FG::Index h = 0; h < 2 * triangulation.number_of_edges(); ++h)
      if(triangulation.tail(FG::Halfedge_index(h)) == FG::Vertex_index(0) &&
         triangulation.head(FG::Halfedge_index(h)) == FG::Vertex_index(i))
        return FG::Halfedge_index(h);
    return FG::Halfedge_index();
  };
  FG::Decision_statistics statistics;
  return FG::internal::Wedge_comparison<Triangulation>(triangulation, statistics)(outgoing_halfedge(last),
                                                                                  outgoing_halfedge(1));
}

// Is the edge from the first to the third of four points Delaunay, as seen from both of its sides?
bool is_diagonal_delaunay(const std::vector<Coordinates>& points)
{
  using Triangulation =
      FG::Intrinsic_triangulation<Surface,
                                  FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>;
  const Surface mesh = to_mesh<Surface>({points, {{0, 1, 2}, {0, 2, 3}}});
  const Triangulation triangulation(mesh);
  std::vector<bool> result;
  for(FG::Index h = 0; h < 2 * triangulation.number_of_edges(); ++h)
    if(triangulation.tail(FG::Halfedge_index(h)).idx() % 2 == 0 &&
       triangulation.head(FG::Halfedge_index(h)).idx() % 2 == 0)
      result.push_back(triangulation.is_locally_delaunay(FG::Halfedge_index(h)));
  BOOST_REQUIRE(result.size() == 2u);
  BOOST_TEST(result[0] == result[1]);
  return result[0];
}

} // namespace

BOOST_AUTO_TEST_CASE(a_wall_with_one_right_angle_is_straight_if_the_other_is_right)
{
  const double e = std::ldexp(1.0, -60);
  const Coordinates up = {0, 0, 1};
  BOOST_TEST((compared_with_pi({{1, 0, 0}, up, {0, 1, 0}}) == CGAL::EQUAL));
  BOOST_TEST((compared_with_pi({{1, 0, 0}, up, {0, 1, e}}) == CGAL::SMALLER));
  BOOST_TEST((compared_with_pi({{1, 0, 0}, up, {0, 1, -e}}) == CGAL::LARGER));
  BOOST_TEST((compared_with_pi({{1, 0, e}, up, {0, 1, 0}}) == CGAL::SMALLER));
  BOOST_TEST((compared_with_pi({{1, 0, -e}, up, {0, 1, 0}}) == CGAL::LARGER));
  BOOST_TEST((compared_with_pi({{1, 0, e}, up, {0, 1, -e}}) == CGAL::EQUAL));
}

BOOST_AUTO_TEST_CASE(two_right_angles_in_space_are_not_a_straight_one_over_two_creases)
{
  // One crease is at right angles to both ends; the other is all but in the plane of the first and an end.
  const Coordinates beside = {1, 1, std::ldexp(1.0, -30)};
  BOOST_TEST((compared_with_pi({{1, 0, 0}, beside, {0, 1, 0}, {0, 0, 1}}) == CGAL::LARGER));
  BOOST_TEST((compared_with_pi({{0, 0, 1}, {0, 1, 0}, beside, {1, 0, 0}}) == CGAL::LARGER));
}

// Four points of a circle, at which the angles are all different, and with the last one off it by less than doubles
// tell.
BOOST_AUTO_TEST_CASE(four_points_of_a_circle_are_delaunay)
{
  const auto moved = [](const Coordinates& p, double s) { return Coordinates{p[0] * (1 + s), p[1] * (1 + s), 0}; };
  const std::vector<Coordinates> circle = {{25, 0, 0},   {15, 20, 0},  {7, 24, 0},
                                           {-20, 15, 0}, {-7, -24, 0}, {20, -15, 0}};
  for(std::size_t i = 0; i < circle.size(); ++i)
    for(std::size_t j = 1; j < 4; ++j) {
      const std::size_t n = circle.size();
      const std::vector<Coordinates> points = {circle[i], circle[(i + 1) % n], circle[(i + 1 + j) % n],
                                               circle[(i + 5) % n]};
      if((i + 1 + j) % n == (i + 5) % n)
        continue;
      BOOST_TEST(is_diagonal_delaunay(points));
      std::vector<Coordinates> off = points;
      off.back() = moved(points.back(), std::ldexp(1.0, -50)); // outside
      BOOST_TEST(is_diagonal_delaunay(off));
      off.back() = moved(points.back(), -std::ldexp(1.0, -50)); // inside
      BOOST_TEST(!is_diagonal_delaunay(off));
    }
}
