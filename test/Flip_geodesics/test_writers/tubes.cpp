// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Tubes about curves.

#include "test_writers/writer_setting.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(tubes_are_closed_surfaces_about_their_curves)
{
  const double step = 2 * pi / 8, area_of_ring = 8 * 0.25 * 0.25 * std::sin(step) / 2;
  const Written rod = tube_of({Point(0, 0, 0), Point(0, 0, 0), Point(1, 2, 2), Point(2, 4, 4)}, 0.25, 8);
  BOOST_CHECK_EQUAL(rod.points.size(), 3 * 8 + 2); // the repeated point has no ring
  BOOST_CHECK_EQUAL(euler_characteristic_of_closed(rod), 2);
  BOOST_CHECK_CLOSE(volume(rod), 6 * area_of_ring, 1e-9);

  const Polyline circle = closed_curve(100, [](double t) { return Point(std::cos(t), std::sin(t), 0); });
  const Written ring = tube_of(circle, 0.1, 16);
  BOOST_CHECK_EQUAL(euler_characteristic_of_closed(ring), 0);
  BOOST_CHECK_CLOSE(volume(ring), 2 * pi * 16 * 0.01 * std::sin(2 * pi / 16) / 2, 0.3); // Pappus's theorem
  for(std::size_t i = 0; i < ring.points.size(); ++i) {
    const Point &p = circle[i / 16], q(ring.points[i][0], ring.points[i][1], ring.points[i][2]);
    BOOST_CHECK_CLOSE(std::sqrt(CGAL::squared_distance(p, q)), 0.1, 1e-9);
  }
  BOOST_CHECK(ring.triangle_curves == std::vector<long>(ring.triangles.size(), 0));
}

BOOST_AUTO_TEST_CASE(tubes_of_closed_curves_are_not_twisted)
{
  // A trefoil: what is carried round it comes back turned.
  const Polyline knot = closed_curve(300, [](double t) {
    return Point(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t));
  });
  double longest = 0;
  for(std::size_t i = 1; i < knot.size(); ++i)
    longest = (std::max)(longest, std::sqrt(CGAL::squared_distance(knot[i - 1], knot[i])));
  for(int sides : {3, 7, 24}) {
    const double radius = 0.3, side = 2 * radius * std::sin(pi / sides);
    const Written tube = tube_of(knot, radius, sides);
    BOOST_CHECK_EQUAL(euler_characteristic_of_closed(tube), 0);
    BOOST_CHECK_GT(volume(tube), 0);
    // An edge along the tube is at most half a side beside its way, a diagonal one and a half.
    BOOST_CHECK_LE(longest_edge(tube), 1.5 * longest + 1.51 * side);
  }
}

// The least rotation from one direction in a plane to another leaves the distances from the plane unchanged.
BOOST_AUTO_TEST_CASE(rings_along_a_plane_curve_keep_their_distances_from_the_plane)
{
  const int sides = 7;
  const std::array<Point, 2> axes = {Point(2.0 / 3, 1.0 / 3, 2.0 / 3), Point(-2.0 / 3, 2.0 / 3, 1.0 / 3)};
  const std::array<double, 3> normal = {{-1.0 / 3, -2.0 / 3, 2.0 / 3}};
  Polyline zigzag;
  for(const auto& [x, y] : std::vector<std::pair<double, double>>{{0, 0}, {1, 0}, {1.5, 1}, {0, 3}, {2, 4}, {2, 0}})
    zigzag.emplace_back(x * axes[0].x() + y * axes[1].x(), x * axes[0].y() + y * axes[1].y(),
                        x * axes[0].z() + y * axes[1].z());
  const Written tube = tube_of(zigzag, 0.1, sides);
  BOOST_REQUIRE_EQUAL(tube.points.size(), sides * zigzag.size() + 2);
  const auto height = [&](std::size_t i) {
    return std::inner_product(normal.begin(), normal.end(), tube.points[i].begin(), 0.0);
  };
  for(std::size_t i = sides; i < sides * zigzag.size(); ++i)
    BOOST_CHECK_SMALL(height(i) - height(i % sides), 1e-14);
}

BOOST_AUTO_TEST_CASE(tubes_stand_sharp_bends_and_all_sizes)
{
  const std::vector<Polyline> curves = {
      {Point(0, 0, 0), Point(1, 0, 0), Point(0, 0, 0)}, // straight back
      {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(1, 1, 1), Point(0, 1, 1)},
      {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, // from one tangent to the normal of the last
      {Point(0, 0, 0), Point(0, 0, 1), Point(0, 0, -1), Point(0, 0, 2)},
      {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1e-5, 0), Point(1, -1e-5, 0)}, // tangents turn back, but for a little
      {Point(0, 0, 0), Point(0, 1, 0), Point(1e-17, 0, 0)}};
  for(const Polyline& curve : curves)
    for(double scale : {1e-200, 1.0, 1e200}) {
      Polyline scaled;
      for(const Point& p : curve)
        scaled.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
      const Written tube = tube_of(scaled, 0.01 * scale, 5);
      BOOST_CHECK_EQUAL(tube.points.size(), 5 * curve.size() + 2);
      BOOST_CHECK_EQUAL(euler_characteristic_of_closed(tube), 2);
      for(std::size_t i = 0; i < 5 * curve.size(); ++i) {
        const auto& corner = tube.points[i];
        const Point &p = curve[i / 5], q(corner[0] / scale, corner[1] / scale, corner[2] / scale);
        BOOST_CHECK_CLOSE(std::sqrt(CGAL::squared_distance(p, q)), 0.01, 1e-9);
      }
    }
  // What has no length has no tube.
  const Written point = tube_of({Point(1, 1, 1), Point(1, 1, 1)}, 1, 5);
  BOOST_CHECK(point.triangles.empty() && point.points.size() == 2);
}

BOOST_AUTO_TEST_CASE(tubes_stand_beside_a_surface_in_all_formats)
{
  const Mesh mesh = sample_mesh();
  for(const Format& format : formats()) {
    const Written file = format.read(format.text(mesh, FG::IO::Tubes(0.1, 4), sample_curves()));
    const std::size_t faces = mesh.number_of_faces(), corners = 2 * 4; // of a ring, or a cap with its half of a ring
    BOOST_REQUIRE_EQUAL(file.triangles.size(), faces + 3 * corners + 2 * corners);
    BOOST_CHECK(file.lines.empty());
    BOOST_REQUIRE_EQUAL(file.triangle_curves.size(), file.triangles.size());
    BOOST_CHECK_EQUAL(std::count(file.triangle_curves.begin(), file.triangle_curves.end(), -1), faces);
    BOOST_CHECK_EQUAL(std::count(file.triangle_curves.begin(), file.triangle_curves.end(), 3), 2 * corners);
  }
}

#ifndef CGAL_NO_PRECONDITIONS
BOOST_AUTO_TEST_CASE(tubes_have_a_radius_and_three_sides)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for(double radius : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(FG::IO::Tubes(radius, 4), CGAL::Precondition_exception);
  BOOST_CHECK_THROW(FG::IO::Tubes(1, 2), CGAL::Precondition_exception);
  BOOST_CHECK_NO_THROW(FG::IO::Tubes(1, 3));
}
#endif
