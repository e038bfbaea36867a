// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Straightest geodesics: where they come to on surfaces that unfold into the plane, which edges and vertices they meet
// exactly, how they end, and that they invert the logarithmic map.

#define BOOST_TEST_MODULE trace_geodesic

#include "closed_forms.h"
#include "generated_meshes.h"
#include "mesh_soup.h"
#include "test_trace_geodesic/rays.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace rays_test;

BOOST_AUTO_TEST_CASE(in_the_plane_it_is_a_straight_line)
{
  const Surface mesh = to_mesh<Surface>(jittered_grid(12, 12, Diagonal_rule::ALTERNATING, 0.24, 3));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  std::size_t inside = 0, on_border = 0;
  for(int i = 0; i < 300; ++i) {
    const Face_location source = random_location(mesh, random);
    const Point start = point_at(mesh, source);
    const Vector v(number(random), number(random), number(random)); // its height does not count
    const Vector unit = Vector(v.x(), v.y(), 0) / std::hypot(v.x(), v.y());
    const Traced t = trace(mesh, source, v, 5);
    const Point end = start + t.result.length() * unit;
    BOOST_TEST(distance(t.points.front(), start) < 1e-14);
    BOOST_TEST(distance(t.points.back(), end) < 1e-13);
    BOOST_TEST(distance(point_at(mesh, t.result.location), end) < 1e-13);
    BOOST_TEST(std::abs(length_of(t.points) - t.result.length()) < 1e-12);
    BOOST_TEST(t.points.size() == t.result.report.edges + 2);
    BOOST_TEST(t.result.report.vertices == 0u);
    if(t.result.status() == Trace_status::LENGTH) {
      ++inside;
      BOOST_TEST(t.result.length() == 5);
    } else {
      ++on_border;
      BOOST_TEST((t.result.status() == Trace_status::BORDER));
      BOOST_TEST(t.result.length() < 5);
    }
  }
  BOOST_TEST(inside > 50u);
  BOOST_TEST(on_border > 50u);
}

BOOST_AUTO_TEST_CASE(directions_in_needles_are_accurate)
{
  // Columns of cells that are by turns narrow and wide.
  const Surface mesh = to_mesh<Surface>(mapped(flat_grid(12, 8, Diagonal_rule::RISING), [](const Coordinates& p) {
    const double pair = std::floor(p[0] / 2);
    return Coordinates{pair + (p[0] > 2 * pair ? 1e-8 : 0), p[1], 0};
  }));
  std::mt19937 random(7);
  for(int i = 0; i < 200; ++i) {
    const Face_location source = random_location(mesh, random);
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(source.first))) {
      const Vector along = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
      const double length = std::sqrt(along.squared_length()), angle = 1e-3 + 0.7 * i;
      const Vector direction = (std::cos(angle) * along + std::sin(angle) * Vector(-along.y(), along.x(), 0)) / length;
      const Traced t = trace(mesh, source, std::make_pair(h, angle), 3);
      BOOST_TEST(distance(t.points.back(), t.points.front() + t.result.length() * direction) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(edges_can_be_grazed)
{
  const Surface mesh = to_mesh<Surface>({{{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {1, -3, 0}}, {{0, 1, 2}, {0, 3, 1}}});
  for(double height : {0.0, 1e-14, 1e-9, 1e-5})
    for(double slope : {1e-4, 1e-7, 1e-10, 1e-14, 1e-16})
      for(const Face f : mesh.faces())
        for(double sign : {-1.0, 1.0}) {
          Face_location source = {f, {0, 0, 0}};
          Halfedge corner = mesh.halfedge(f);
          for(double& weight : source.second) {
            const Vertex v = mesh.source(corner);
            weight = v == Vertex(0) ? 0.75 * (1 - height / 3) : (v == Vertex(1) ? 0.25 * (1 - height / 3) : height / 3);
            corner = mesh.next(corner);
          }
          const Traced t = trace(mesh, source, Vector(1, sign * slope, 0), 1);
          const Vector unit = Vector(1, sign * slope, 0) / std::hypot(1, slope);
          BOOST_TEST(distance(t.points.back(), t.points.front() + unit) < 1e-14);
          const Traced part = trace(mesh, source, Vector(1, sign * slope, 0), 0.25);
          const Traced rest = trace(mesh, part.result.location, part.result.direction, 0.75);
          BOOST_TEST(distance(rest.points.back(), t.points.back()) < 1e-14);
        }
}

BOOST_AUTO_TEST_CASE(it_can_be_traced_on_from_beside_a_vertex)
{
  const Surface mesh =
      to_mesh<Surface>({{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}});
  const Halfedge h = mesh.halfedge(Vertex(0), Vertex(1)); // of the face in the plane z = 0
  Face_location source = {mesh.face(h), {0, 0, 0}};
  Halfedge corner = mesh.halfedge(source.first);
  for(double& weight : source.second) {
    weight = mesh.source(corner) == Vertex(0) ? 0.75 : (mesh.source(corner) == Vertex(1) ? 0.25 : 0);
    corner = mesh.next(corner);
  }
  for(double beside : {1e-9, 1e-11, 1e-12, 1e-14}) {
    const Vector way(-2, beside, 0); // to the edge that leads from the corner along the y-axis
    const Traced whole = trace(mesh, source, way, 4);
    const Traced part = trace(mesh, source, way, 4, CGAL::parameters::number_of_iterations(0));
    BOOST_TEST((part.result.status() == Trace_status::CROSSING_LIMIT));
    const Traced rest = trace(mesh, part.result.location, part.result.direction, 4 - part.result.length());
    BOOST_TEST(distance(whole.points.back(), Point(0, 2 * beside, 2)) < 1e-14 + beside);
    BOOST_TEST(distance(rest.points.back(), whole.points.back()) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(it_runs_along_edges)
{
  const Surface mesh = grid_mesh();
  const Traced t = trace_from_middle(mesh, Vector(-1, 0, 0), 3.5);
  BOOST_TEST(t.result.report.vertices == 3u);
  BOOST_TEST(t.result.report.edges == 0u);
  BOOST_TEST(distance(t.points.back(), Point(2.5, 6, 0)) < 1e-14);
  // From a point of an edge, along it and across it.
  const Halfedge h = mesh.halfedge(Vertex(grid_vertex(12, 6, 6)), Vertex(grid_vertex(12, 7, 6)));
  const Traced along = trace(mesh, Point(6.25, 6, 0), std::make_pair(h, 0.0), 1.0);
  BOOST_TEST(along.result.report.vertices == 1u);
  BOOST_TEST(distance(along.points.back(), Point(7.25, 6, 0)) < 1e-14);
  for(double angle : {0.5 * pi, -0.5 * pi}) {
    const Traced across = trace(mesh, Point(6.25, 6, 0), std::make_pair(h, angle), 0.1);
    BOOST_TEST(across.points.size() == (angle > 0 ? 2u : across.result.report.edges + 1));
    BOOST_TEST(distance(across.points.back(), Point(6.25, 6 + (angle > 0 ? 0.1 : -0.1), 0)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(the_band_of_a_cube_is_closed)
{
  const Surface mesh = to_mesh<Surface>(cube(4)); // of size 4
  std::size_t bands = 0;
  for(const Face f : mesh.faces()) {
    const Face_location source = {f, {0.3, 0.25, 0.45}};
    const Point start = point_at(mesh, source);
    for(const Vector& v : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)}) {
      const Halfedge h = mesh.halfedge(f);
      const Vector normal = CGAL::cross_product(mesh.point(mesh.target(h)) - mesh.point(mesh.source(h)),
                                                mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.target(h)));
      if(normal * v != 0)
        continue;
      const Traced t = trace(mesh, source, v, 16.0);
      BOOST_TEST(distance(t.points.back(), start) < 1e-13);
      BOOST_TEST(t.result.report.vertices == 0u);
      ++bands;
    }
  }
  BOOST_TEST(bands == 2 * mesh.number_of_faces());
}

BOOST_AUTO_TEST_CASE(at_the_apex_of_a_cone_both_angles_are_equal)
{
  for(int n : {4, 6, 10, 20}) {
    const Surface mesh = to_mesh<Surface>(n == 20 ? saddle_disk(20, 3, 3 * pi) : cone(n, 3, 1, n));
    const Halfedge h = mesh.halfedge(Vertex(disk_vertex(n, 1, 0)), Vertex(0)); // up to the apex
    const double ring = distance(mesh.point(Vertex(0)), mesh.point(Vertex(disk_vertex(n, 1, 0))));
    const Traced t = trace(mesh, Vertex(disk_vertex(n, 1, 0)), std::make_pair(h, 0.0), 2 * ring);
    BOOST_TEST(t.result.report.vertices == 1u);
    BOOST_TEST(distance(t.points.back(), mesh.point(Vertex(disk_vertex(n, 1, n / 2)))) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(the_logarithmic_map_is_its_inverse)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface>;
  for(const Surface& mesh : {to_mesh<Surface>(bumpy_sphere(6, 0.2, 5)),
                             to_mesh<Surface>(jittered_grid(10, 10, Diagonal_rule::ALTERNATING, 0.2, 4))})
  {
    const Vertex source(mesh.number_of_vertices() / 2);
    Triangulation triangulation(mesh);
    FG::Geodesic_tree<Triangulation> tree(triangulation);
    tree.grow(triangulation.index(source));
    FG::make_shortest(tree);
    const FG::Vertex_logarithmic_map map = FG::logarithmic_map(tree);
    const Halfedge zero = triangulation.input().halfedge(triangulation.input().outgoing(triangulation.index(source)));
    std::size_t direct = 0;
    for(const Vertex v : mesh.vertices()) {
      const FG::Vertex_index index = triangulation.index(v);
      if(v == source || triangulation.tail(tree.incoming(index)) != tree.source())
        continue; // in the shadow of another vertex
      const FG::Polar_coordinates& p = map[index];
      const Traced t = trace(mesh, source, std::make_pair(zero, p.angle), p.radius);
      BOOST_TEST(distance(t.points.back(), mesh.point(v)) < 1e-11);
      ++direct;
    }
    BOOST_TEST(direct > mesh.number_of_vertices() / 4);
  }
}

BOOST_AUTO_TEST_CASE(it_can_be_traced_on_and_back)
{
  const Surface mesh = to_mesh<Surface>(torus(24, 14, 2, 1));
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-7, 7);
  for(int i = 0; i < 200; ++i) {
    const Face_location source = random_location(mesh, random);
    const std::pair<Halfedge, double> direction = {mesh.next(mesh.halfedge(source.first)), angle(random)};
    const Traced whole = trace(mesh, source, direction, 6), half = trace(mesh, source, direction, 2.5);
    const Traced rest = trace(mesh, half.result.location, half.result.direction, 3.5);
    BOOST_TEST(distance(rest.points.back(), whole.points.back()) < 1e-11);
    const auto [h, on] = whole.result.direction;
    const Traced back = trace(mesh, whole.result.location, std::make_pair(h, on + pi), 6);
    BOOST_TEST(distance(back.points.back(), whole.points.front()) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(all_forms_are_in_step)
{
  const Surface mesh = to_mesh<Surface>(torus(24, 14, 2, 1));
  const Face_location source = {Face(7), {0.25, 0.5, 0.25}};
  const std::pair<Halfedge, double> direction = {mesh.halfedge(Face(7)), 1.0};
  const Traced t = trace(mesh, source, direction, 6);
  std::vector<Face_location> locations;
  std::vector<Curve_point> all;
  FG::trace_geodesic(mesh, source, direction, 6, std::back_inserter(locations));
  FG::trace_geodesic(mesh, source, direction, 6, std::back_inserter(all));
  BOOST_REQUIRE(locations.size() == t.points.size());
  BOOST_REQUIRE(all.size() == t.points.size());
  for(std::size_t i = 0; i < all.size(); ++i) {
    BOOST_TEST(distance(point_at(mesh, locations[i]), t.points[i]) < 1e-14);
    BOOST_TEST((all[i].location == locations[i]));
    BOOST_TEST((all[i].point == t.points[i]));
    BOOST_TEST(std::abs(all[i].tangent.squared_length() - 1) < 1e-14);
    const std::size_t j = i + 1 < all.size() ? i : i - 1;
    const Vector step = t.points[j + 1] - t.points[j];
    BOOST_TEST(std::abs(all[i].tangent * step - std::sqrt(step.squared_length())) < 1e-14);
  }
}

// Only the direction of a vector counts.
BOOST_AUTO_TEST_CASE(vectors_can_be_long_and_short)
{
  const Face_location source = {Face(7), {0.25, 0.5, 0.25}};
  for(int exponent : {-200, 0, 200}) {
    const double size = std::scalbn(1.0, exponent);
    const Surface mesh = to_mesh<Surface>(scaled(torus(24, 14, 2, 1), size));
    const Traced t = trace(mesh, source, Vector(0.3, -0.7, 0.4), 6 * size);
    for(int other : {-1000, -600, 600, 1000}) {
      const Vector v(std::scalbn(0.3, other), std::scalbn(-0.7, other), std::scalbn(0.4, other));
      BOOST_TEST((trace(mesh, source, v, 6 * size).points == t.points));
    }
  }
}

// A needle whose area is lost if products are rounded: from its center, away from a corner.
BOOST_AUTO_TEST_CASE(vectors_in_needles_are_accurate)
{
  const double n = 0x1p27;
  const Surface mesh = to_mesh<Surface>({{{0, 0, 0}, {n + 1, n, 0}, {n + 2, n + 1, 0}}, {{0, 1, 2}}});
  const Face_location center = {Face(0), {1. / 3, 1. / 3, 1. / 3}};
  const Vector median(n + 1.5, n + 0.5, 0);
  const Traced t = trace(mesh, center, median, n);
  BOOST_TEST((t.result.status() == Trace_status::BORDER));
  BOOST_TEST(std::abs(t.result.length() - std::sqrt(median.squared_length()) / 3) < 1e-9 * n);
}

// A weight of next to nothing is none: then the place is a vertex, with all faces about it.
BOOST_AUTO_TEST_CASE(weights_of_next_to_nothing)
{
  const Surface mesh = grid_mesh();
  Face_location source = at_vertex(mesh, Vertex(grid_vertex(12, 6, 6)));
  for(double& weight : source.second)
    weight = (std::max)(weight, 1e-200);
  const Halfedge h = mesh.halfedge(Vertex(grid_vertex(12, 6, 6)), Vertex(grid_vertex(12, 7, 6)));
  for(int k = 0; k < 8; ++k) {
    const double angle = k * pi / 4 + 0.1;
    const Traced t = trace(mesh, source, std::make_pair(h, angle), 2);
    BOOST_TEST(distance(t.points.back(), Point(6 + 2 * std::cos(angle), 6 + 2 * std::sin(angle), 0)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(constrained_edges_and_limits_end_it)
{
  Surface mesh = grid_mesh();
  auto is_constrained = mesh.add_property_map<Surface::Edge_index, bool>("e:wall", false).first;
  for(int j = 0; j < 12; ++j)
    is_constrained[mesh.edge(mesh.halfedge(Vertex(grid_vertex(12, 9, j)), Vertex(grid_vertex(12, 9, j + 1))))] = true;
  const auto np = CGAL::parameters::edge_is_constrained_map(is_constrained);
  const Face_location middle = at_vertex(mesh, Vertex(grid_vertex(12, 6, 6)));
  const Traced wall = trace(mesh, middle, Vector(3, 0.5, 0), 100, np);
  BOOST_TEST((wall.result.status() == Trace_status::CONSTRAINED_EDGE));
  BOOST_TEST(distance(wall.points.back(), Point(9, 6.5, 0)) < 1e-14);
  const Traced corner = trace(mesh, middle, Vector(1, 0, 0), 100, np);
  BOOST_TEST((corner.result.status() == Trace_status::CONSTRAINED_EDGE));
  BOOST_TEST(distance(corner.points.back(), Point(9, 6, 0)) < 1e-14);
  const Traced few = trace(mesh, middle, Vector(3, 0.5, 0), 100, CGAL::parameters::number_of_iterations(2));
  BOOST_TEST((few.result.status() == Trace_status::CROSSING_LIMIT));
  BOOST_TEST(few.result.report.edges + few.result.report.vertices == 2u);
  const Traced before = trace(mesh, middle, Vector(3, 0.5, 0), 100, np.number_of_iterations(2));
  BOOST_TEST((before.result.status() == Trace_status::CROSSING_LIMIT));
  BOOST_TEST(before.result.report.edges + before.result.report.vertices == 2u);
  const Traced first = trace(mesh, middle, Vector(1, 0, 0), 100, CGAL::parameters::at_vertices(At_vertices::STOP), np);
  BOOST_TEST((first.result.status() == Trace_status::VERTEX));
  BOOST_TEST(distance(first.points.back(), Point(7, 6, 0)) < 1e-14);
  const auto negative = CGAL::parameters::number_of_iterations(-1);
  BOOST_CHECK_THROW(trace(mesh, middle, Vector(3, 0.5, 0), 100, negative), FG::Invalid_parameter_error);
  const Traced rim = trace(mesh, middle, Vector(0, -1, 0), 100);
  BOOST_TEST((rim.result.status() == Trace_status::BORDER));
  BOOST_TEST(std::abs(rim.result.length() - 6) < 1e-14);
  const Traced none = trace(mesh, middle, Vector(0, -1, 0), 0);
  BOOST_TEST((none.result.status() == Trace_status::LENGTH));
  BOOST_TEST(none.result.length() == 0);
  BOOST_TEST(distance(none.points.back(), Point(6, 6, 0)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(out_of_the_surface_it_ends_at_once)
{
  const Surface mesh = grid_mesh();
  const Vertex corner(grid_vertex(12, 0, 0));
  const Halfedge rim = mesh.halfedge(corner, Vertex(grid_vertex(12, 1, 0)));
  for(double angle : {2.0, -0.5}) {
    const Traced t = trace(mesh, corner, std::make_pair(rim, angle), 1);
    BOOST_TEST((t.result.status() == Trace_status::BORDER));
    BOOST_TEST(t.result.length() == 0);
    BOOST_TEST(distance(t.points.back(), Point(0, 0, 0)) == 0);
    // Its direction is still the one that was given.
    const auto [h, on] = t.result.direction;
    const Vector along = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    BOOST_TEST(std::abs(std::remainder(std::atan2(along.y(), along.x()) + on - angle, 2 * pi)) < 1e-14);
  }
  // On from the end of one that has run into a vertex of the border.
  const Traced rim_met = trace_from_middle(mesh, Vector(0, -1, 0), 100);
  BOOST_TEST((rim_met.result.status() == Trace_status::BORDER));
  const Traced on = trace(mesh, rim_met.result.location, rim_met.result.direction, 1);
  BOOST_TEST((on.result.status() == Trace_status::BORDER));
  BOOST_TEST(on.result.length() == 0);
  BOOST_TEST(distance(on.points.back(), Point(6, 0, 0)) < 1e-14);
}

// Along the border from a place on an edge of it, told from any side of the face: rounding must not lead out.
// In a needle as well, where angles are converted to directions at a corner that is less acute.
BOOST_AUTO_TEST_CASE(along_the_border_it_stays_on_the_border)
{
  const std::vector<Mesh_soup> triangles = {{{{0, 0, 0}, {1.3, 0.2, 0.1}, {0.1, 1.7, 0.4}}, {{0, 1, 2}}},
                                            {{{0, 0, 0}, {10, 1, 0}, {10, 1.3, 0}}, {{0, 1, 2}}}};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> weight(0.1, 0.9);
  for(int i = 0; i < 1200; ++i) {
    const Surface mesh = to_mesh<Surface>(triangles[static_cast<std::size_t>(i / 600)]);
    const FG::Intrinsic_triangulation<Surface> triangulation(mesh);
    const FG::Geodesic_tracer<FG::Intrinsic_triangulation<Surface>> tracer(triangulation);
    Halfedge edge = mesh.halfedge(Face(0));
    for(int side = 0; side < i / 2 % 3; ++side)
      edge = mesh.next(edge);
    const Halfedge told_from = i % 2 == 0 ? edge : mesh.next(edge);
    const double place = weight(random);
    const FG::Surface_location at = {triangulation.input().index(edge), {{1 - place, place, 0}}};
    // Angles inside of the face, from `told_from` on to the edge.
    const Point p = mesh.point(mesh.source(edge)), q = mesh.point(mesh.target(edge)),
                r = mesh.point(mesh.target(mesh.next(edge)));
    const double corner = std::acos((p - q) * (r - q) / (distance(p, q) * distance(r, q)));
    const double to_edge = (told_from == edge ? 0 : corner - pi) + 2 * pi * (i % 3) + (i % 5 < 2 ? pi : 0);
    const double length = 0.05 * distance(p, q);
    const FG::Trace_report t = tracer.trace(at, FG::Surface_direction{triangulation.input().index(told_from), to_edge},
                                            length, CGAL::Emptyset_iterator());
    BOOST_TEST((t.status == Trace_status::LENGTH));
    BOOST_TEST(std::abs(t.length - length) < 1e-14);
    const FG::Trace_report on =
        tracer.trace(t.location, FG::Surface_direction{t.halfedge, t.angle}, length, CGAL::Emptyset_iterator());
    BOOST_TEST((on.status == Trace_status::LENGTH));
    // What does not run along it does leave the surface.
    for(double outward : {1e-9, -1e-9}) {
      const FG::Trace_report none =
          tracer.trace(at, FG::Surface_direction{triangulation.input().index(told_from), to_edge + outward}, length,
                       CGAL::Emptyset_iterator());
      const bool leads_out = (i % 5 < 2) == (outward > 0);
      BOOST_TEST((none.status == (leads_out ? Trace_status::BORDER : Trace_status::LENGTH)));
    }
  }
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused)
{
  const Surface mesh = grid_mesh();
  const Vertex middle(grid_vertex(12, 6, 6)), corner(grid_vertex(12, 0, 0));
  const Face_location source = at_vertex(mesh, middle);
  const Halfedge h = mesh.halfedge(middle, Vertex(grid_vertex(12, 7, 6)));
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for(double length : {-1.0, nan, infinity})
    BOOST_CHECK_THROW(trace(mesh, source, Vector(1, 0, 0), length), FG::Invalid_parameter_error);
  for(const Vector& v : {Vector(0, 0, 0), Vector(0, 0, 1), Vector(nan, 0, 0), Vector(infinity, 1, 0)})
    BOOST_CHECK_THROW(trace(mesh, source, v, 1), FG::Invalid_parameter_error);
  for(double angle : {nan, infinity})
    BOOST_CHECK_THROW(trace(mesh, middle, std::make_pair(h, angle), 1), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(trace(mesh, corner, std::make_pair(h, 0.0), 1), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(trace(mesh, Face_location{Face(0), {0.2, 0.3, 0.5}}, std::make_pair(h, 0.0), 1),
                    FG::Invalid_parameter_error);
  for(const Halfedge none : {Surface::null_halfedge(), Halfedge(mesh.number_of_halfedges())})
    BOOST_CHECK_THROW(trace(mesh, source, std::make_pair(none, 0.0), 1), FG::Invalid_parameter_error);
  const Halfedge rim = mesh.halfedge(corner, Vertex(grid_vertex(12, 1, 0)));
  BOOST_CHECK_THROW(trace(mesh, Vertex(100000), std::make_pair(h, 0.0), 1), FG::Vertex_out_of_range_error);
  // A vector says nothing of a degenerate face, or with a corner that is no point.
  const Surface flat = to_mesh<Surface>({{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}});
  const Surface no_point = to_mesh<Surface>({{{0, 0, 0}, {2, 0, 0}, {1, nan, 0}}, {{0, 1, 2}}});
  const Face_location inside = {Face(0), {0.25, 0.25, 0.5}};
  BOOST_CHECK_THROW(trace(flat, inside, Vector(1, 0, 0), 1), FG::Degenerate_face_error);
  BOOST_CHECK_THROW(trace(flat, inside, std::make_pair(flat.halfedge(Face(0)), 1.0), 1), FG::Degenerate_face_error);
  BOOST_CHECK_THROW(trace(no_point, inside, Vector(1, 0, 0), 1), FG::Invalid_coordinate_error);
  // Along the border, to both sides.
  BOOST_TEST(distance(trace(mesh, corner, std::make_pair(rim, 0.0), 1).points.back(), Point(1, 0, 0)) < 1e-14);
  BOOST_TEST(distance(trace(mesh, corner, std::make_pair(rim, 0.5 * pi), 1).points.back(), Point(0, 1, 0)) < 1e-14);
}
