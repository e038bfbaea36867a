// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Tangent vectors: the logarithmic map of places anywhere, against the plane and as the inverse of tracing; and
// parallel transport, against the angle defects that curves go round.

#define BOOST_TEST_MODULE tangents

#include "test_tangents/surfaces.h"

#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace tangents_test;

namespace {

struct Traced
{
  FG::Trace_report trace;
  std::vector<FG::Surface_location> locations;
};

Traced trace(const Triangulation& t, const FG::Surface_location& from, const FG::Surface_direction& d, double length)
{
  Traced result;
  std::vector<FG::Surface_point> points;
  result.trace = FG::Geodesic_tracer<Triangulation>(t).trace(from, d, length, std::back_inserter(points));
  for(const FG::Surface_point& p : points) {
    result.locations.push_back(p.is_inside_face() || p.is_vertex() ? FG::Surface_location()
                                                                   : FG::internal::surface_location(t, p));
    if(p.is_vertex())
      result.locations.back() = t.location(p.a);
  }
  result.locations.front() = from;
  result.locations.back() = result.trace.location;
  return result;
}

// Does the path bend? Only at a vertex, and only at one with a large angle.
bool passes_vertex(const FG::Logarithmic_map<Triangulation>& logarithm, const FG::Surface_location& target)
{
  const auto points = logarithm.distance_field().surface_points(target);
  return std::any_of(points.begin() + 1, points.end() - 1, [](const auto& p) { return p.is_vertex(); });
}

double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * pi)); }

} // namespace

BOOST_AUTO_TEST_CASE(in_the_plane_the_logarithm_is_the_difference)
{
  for(const Mesh& mesh : {to_mesh<Mesh>(flat_grid(9, 9, Diagonal_rule::ALTERNATING)),
                          to_mesh<Mesh>(jittered_grid(9, 9, Diagonal_rule::ALTERNATING, 0.2, 4))})
  {
    const Triangulation t(mesh);
    std::mt19937 random(3);
    for(int i = 0; i < 12; ++i) {
      const FG::Surface_location source = random_location(t, i % 3, random);
      const FG::Logarithmic_map<Triangulation> logarithm(t, mesh, source);
      const std::complex<double> start = in_plane(t, source), zero = direction_in_plane(t, logarithm.halfedge());
      for(int j = 0; j < 60; ++j) {
        const FG::Surface_location target = random_location(t, j % 3, random);
        const std::complex<double> way = in_plane(t, target) - start;
        const FG::Polar_coordinates p = logarithm(target);
        if(way == 0.0)
          continue;
        BOOST_TEST(std::abs(std::polar(p.radius, p.angle) * zero - way) < 1e-12);
        BOOST_TEST((logarithm.is_on_border() || (p.angle >= 0 && p.angle < logarithm.total_angle())));
        const double turn = angle_between(logarithm.transported(target, 0.25).angle + arg_in_plane(t, target),
                                          0.25 + arg_in_plane(t, source));
        BOOST_TEST(turn < 1e-12);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(ways_that_miss_a_vertex_by_little_keep_their_digits)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(9, 9, Diagonal_rule::RISING));
  const Triangulation t(mesh);
  const FG::Surface_location source = location_of(t, {2.5, 2.25});
  const FG::Logarithmic_map<Triangulation> logarithm(t, mesh, source);
  const std::complex<double> zero = direction_in_plane(t, logarithm.halfedge());
  for(double miss : {1e-6, 3e-7, 1e-7, -1e-7, 1e-8, -3e-9, 1e-9, 1e-10, -1e-11, 1e-13})
    for(const std::complex<double>& vertex : {std::complex<double>(4, 3), {4, 4}, {3, 4}, {1, 1}, {5, 3}, {3, 6}}) {
      const std::complex<double> to_vertex = vertex - in_plane(t, source);
      const std::complex<double> way = 1.4 * to_vertex * std::polar(1.0, miss);
      const FG::Surface_location target = location_of(t, in_plane(t, source) + way);
      const FG::Polar_coordinates p = logarithm(target);
      BOOST_TEST(std::abs(std::polar(p.radius, p.angle) * zero - (in_plane(t, target) - in_plane(t, source))) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(tracing_is_the_inverse_of_the_logarithm)
{
  struct Case
  {
    Mesh mesh;
    bool is_without_bends;
  };
  for(const Case& c :
      {Case{to_mesh<Mesh>(cone_disk(9, 5, 4.5)), true}, Case{to_mesh<Mesh>(cone(7, 4, 2, 3)), true},
       Case{to_mesh<Mesh>(cylinder(10, 6, 2, 5)), true}, Case{to_mesh<Mesh>(random_convex_polyhedron(60, 3)), true},
       Case{to_mesh<Mesh>(saddle_disk(12, 5, 9)), false}, Case{to_mesh<Mesh>(bumpy_sphere(6, 0.2, 5)), false}})
  {
    const Triangulation t(c.mesh);
    std::mt19937 random(9);
    std::size_t straight = 0, all = 0;
    for(int i = 0; i < 9; ++i) {
      const FG::Surface_location source = random_location(t, i % 3, random);
      const FG::Logarithmic_map<Triangulation> logarithm(t, c.mesh, source);
      for(int j = 0; j < 40; ++j) {
        const FG::Surface_location target = random_location(t, j % 3, random);
        const FG::Polar_coordinates p = logarithm(target);
        if(p.radius == 0)
          continue;
        ++all;
        BOOST_TEST(std::abs(p.radius - logarithm.distance_field().distance(target)) < 1e-11 * p.radius);
        const bool is_along_border =
            is_on_border(t, source) && is_on_border(t, target); // tracing ends at vertices there
        if((!c.is_without_bends || is_along_border) && passes_vertex(logarithm, target))
          continue;
        ++straight;
        const Traced there = trace(t, source, {logarithm.halfedge(), p.angle}, p.radius);
        BOOST_TEST(distance(in_space(t, there.trace.location), in_space(t, target)) < 1e-11);
        const double end = logarithm.transported(target, p.angle).angle; // the tangent stays tangent
        const FG::Surface_direction back = {logarithm.transported(target, 0).halfedge, end + turn_back(t, target)};
        const Traced again = trace(t, target, back, p.radius);
        BOOST_TEST(distance(in_space(t, again.trace.location), in_space(t, source)) < 1e-11);
      }
    }
    BOOST_TEST(straight > all / (c.is_without_bends ? 2 : 8));
  }
}

// From each side that a vertex or a place on the border can be told by, and from inside.
BOOST_AUTO_TEST_CASE(the_plane_of_a_place_and_its_polar_coordinates_are_inverse)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(3, 3, Diagonal_rule::ALTERNATING));
  const Triangulation t(mesh);
  for(const std::array<double, 3>& weights :
      {std::array<double, 3>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.25, 0.25, 0.5}})
    for(const Mesh::Face_index f : mesh.faces()) {
      const FG::Logarithmic_map<Triangulation> logarithm(
          t, mesh, FG::Surface_location{t.input().index(mesh.halfedge(f)), weights});
      for(const Mesh::Vertex_index v : mesh.vertices()) {
        const FG::Polar_coordinates p = logarithm(t.index(v));
        if(p.radius == 0)
          continue;
        const FG::Polar_coordinates again = logarithm.from_plane(logarithm.in_plane(p));
        BOOST_TEST(std::abs(again.radius - p.radius) < 1e-12);
        BOOST_TEST(std::abs(std::remainder(again.angle - p.angle, logarithm.is_on_border() ? 100 : 2 * pi)) < 1e-12);
      }
    }
}

// About a vertex with half or twice the angle of the plane, directions are stretched to that of the plane.
BOOST_AUTO_TEST_CASE(angles_about_a_vertex_are_stretched_to_a_whole_turn)
{
  const int k = 8;
  for(const Mesh& mesh : {to_mesh<Mesh>(cone_disk(k, 2, pi)), to_mesh<Mesh>(saddle_disk(k, 2, 4 * pi))}) {
    const Triangulation t(mesh);
    const FG::Logarithmic_map<Triangulation> logarithm(t, mesh, t.location(FG::Vertex_index(0)));
    for(int j = 0; j < k; ++j) {
      const FG::Polar_coordinates p = logarithm(FG::Vertex_index(disk_vertex(k, 1, j)));
      const auto a = logarithm.in_plane(p),
                 opposite = logarithm.in_plane(logarithm(FG::Vertex_index(disk_vertex(k, 1, (j + k / 2) % k))));
      BOOST_TEST(std::hypot(a[0] + opposite[0], a[1] + opposite[1]) < 1e-12);
      BOOST_TEST(std::abs(std::remainder(logarithm.from_plane(a).angle - p.angle, logarithm.total_angle())) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(behind_a_saddle_everything_has_the_direction_of_the_saddle)
{
  const int k = 16;
  const Mesh mesh = to_mesh<Mesh>(saddle_disk(k, 4, 4 * pi));
  const Triangulation t(mesh);
  const FG::Vertex_index source = t.index(Mesh::Vertex_index(disk_vertex(k, 3, 0)));
  const FG::Logarithmic_map<Triangulation> logarithm(t, mesh, t.location(source));
  const double straight = logarithm(t.index(Mesh::Vertex_index(0))).angle;
  const double ring = logarithm(t.index(Mesh::Vertex_index(0))).radius;
  for(int i = 5; i <= k - 5; ++i) { // sectors of pi / 4
    const FG::Polar_coordinates p = logarithm(t.index(Mesh::Vertex_index(disk_vertex(k, 3, i))));
    BOOST_TEST(std::abs(p.angle - straight) < 1e-14);
    BOOST_TEST(std::abs(p.radius - 2 * ring) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(along_straightest_geodesics_the_tangent_is_carried_to_the_tangent)
{
  for(const Mesh& mesh : {to_mesh<Mesh>(bumpy_sphere(5, 0.2, 5)), to_mesh<Mesh>(saddle_disk(12, 3, 9)),
                          to_mesh<Mesh>(flat_grid(6, 6, Diagonal_rule::RISING))})
  {
    const Triangulation t(mesh);
    const FG::Parallel_transport<Triangulation> transport(t);
    std::mt19937 random(5);
    for(int i = 0; i < 60; ++i) {
      const FG::Surface_location source = random_location(t, i % 3, random);
      if(is_on_border(t, source))
        continue;
      // Every second one runs along edges and through vertices.
      const FG::Surface_direction direction = {source.halfedge, i % 2 == 0 ? 0 : 0.1 * i};
      const Traced way = trace(t, source, direction, 1.5);
      if(way.trace.status != FG::Trace_status::LENGTH)
        continue;
      const FG::Surface_direction end = transport(way.locations, direction, way.trace.halfedge);
      BOOST_TEST(angle_between(end.angle, way.trace.angle) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(round_a_loop_vectors_turn_by_the_defects_inside)
{
  for(const Mesh& mesh : {to_mesh<Mesh>(bumpy_sphere(5, 0.3, 2)), to_mesh<Mesh>(torus(9, 7, 2, 1)),
                          to_mesh<Mesh>(random_convex_polyhedron(40, 2)), to_mesh<Mesh>(cone_disk(8, 3, 4.0))})
  {
    const Triangulation t(mesh);
    const FG::Parallel_transport<Triangulation> transport(t);
    std::size_t loops = 0;
    for(const auto v : mesh.vertices()) {
      if(mesh.is_border(v))
        continue;
      // Through the middles of the edges about v, and the same closer to it and by points inside faces.
      for(double t_on_edge : {0.5, 0.01}) {
        std::vector<FG::Surface_location> loop;
        for(const auto h : CGAL::halfedges_around_target(v, mesh)) // clockwise
          loop.push_back({t.input().index(h), {{t_on_edge, 1 - t_on_edge, 0}}});
        loop.push_back(loop.front());
        std::reverse(loop.begin(), loop.end());
        const FG::Surface_direction start = {loop.front().halfedge, 0.3};
        const FG::Surface_direction end = transport(loop, start, start.halfedge);
        BOOST_TEST(angle_between(end.angle - start.angle, 2 * pi - angle_sum(t, t.index(v))) < 1e-12);
        ++loops;
      }
    }
    BOOST_TEST(loops > 30u);
  }
}

BOOST_AUTO_TEST_CASE(round_many_vertices_it_is_the_sum_of_their_defects)
{
  const int k = 10; // the second ring of a bumpy cone, by the middles of the edges between the rings
  const Mesh mesh = to_mesh<Mesh>(mapped(cone(k, 4, 2, 3), [](const Coordinates& p) {
    return Coordinates{p[0], p[1], p[2] + 0.2 * std::sin(5 * p[0] + 3 * p[1])};
  }));
  const Triangulation t(mesh);
  std::vector<FG::Surface_location> loop;
  const auto start = mesh.halfedge(Mesh::Vertex_index(disk_vertex(k, 2, 0)), Mesh::Vertex_index(disk_vertex(k, 3, 0)));
  BOOST_REQUIRE(start.is_valid());
  const auto is_inner = [&](Mesh::Vertex_index v) { return static_cast<int>(v) <= 2 * k; };
  auto h = start; // from inside to outside; the face on its left is next
  do {
    loop.push_back({t.input().index(h), {{0.5, 0.5, 0}}});
    const auto third = mesh.target(mesh.next(h));
    h = is_inner(third) ? mesh.opposite(mesh.next(h)) : mesh.opposite(mesh.next(mesh.next(h)));
    h = is_inner(mesh.source(h)) ? h : mesh.opposite(h);
  } while(h != start);
  loop.push_back(loop.front());
  double defects = 0;
  for(const auto v : mesh.vertices())
    defects += is_inner(v) ? 2 * pi - angle_sum(t, t.index(v)) : 0;
  const FG::Surface_direction end =
      FG::Parallel_transport<Triangulation>(t)(loop, {loop.front().halfedge, 1}, loop.front().halfedge);
  BOOST_TEST(angle_between(end.angle - 1, defects) < 1e-12);
}

// About an apex of a cone, of which the lengths are known, and at the border.
BOOST_AUTO_TEST_CASE(one_call_tells_the_angle_about_its_source)
{
  std::vector<FG::Polar_coordinates> coordinates;
  const Mesh grid = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING)), box = to_mesh<Mesh>(cube(2));
  const auto at = [&](const Mesh& mesh, int vertex) {
    return FG::logarithmic_map(mesh, Mesh::Vertex_index(static_cast<unsigned>(vertex)), mesh.vertices(),
                               std::back_inserter(coordinates));
  };
  BOOST_TEST(at(grid, grid_vertex(4, 0, 0)).is_on_border());
  BOOST_TEST(std::abs(at(grid, grid_vertex(4, 0, 0)).total_angle() - pi / 2) < 1e-14);
  BOOST_TEST(std::abs(at(grid, grid_vertex(4, 2, 0)).total_angle() - pi) < 1e-14);
  BOOST_TEST(!at(grid, grid_vertex(4, 2, 2)).is_on_border());
  std::size_t corners = 0;
  for(const auto v : box.vertices())
    corners += std::abs(at(box, static_cast<int>(v)).total_angle() - 1.5 * pi) < 1e-14 ? 1 : 0;
  BOOST_TEST(corners == 8u);
}

// Up to rounding errors.
BOOST_AUTO_TEST_CASE(one_call_does_the_same)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(4, 0.2, 5));
  const Triangulation t(mesh);
  using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>;
  const Face_location source = {Mesh::Face_index(5), {{0.25, 0.5, 0.25}}};
  const FG::Surface_location same = {t.input().index(mesh.halfedge(source.first)), source.second};
  const FG::Logarithmic_map<Triangulation> logarithm(t, mesh, same);
  std::vector<FG::Polar_coordinates> coordinates;
  const auto result = FG::logarithmic_map(mesh, source, mesh.vertices(), std::back_inserter(coordinates));
  BOOST_TEST((result.halfedge() == mesh.halfedge(source.first)));
  BOOST_TEST(result.total_angle() == 2 * pi);
  BOOST_TEST(!result.is_on_border());
  BOOST_TEST((result.report.status == FG::Distance_field_status::COMPLETE));
  BOOST_REQUIRE(coordinates.size() == mesh.number_of_vertices());
  for(const auto v : mesh.vertices()) {
    const FG::Polar_coordinates& p = coordinates[v];
    const FG::Polar_coordinates q = logarithm(t.index(v)); // by the faces along the path, not by windows
    BOOST_TEST(std::abs(p.radius - q.radius) < 1e-14);
    BOOST_TEST(std::abs(p.angle - q.angle) < 1e-13);
    std::vector<Face_location> way;
    const std::pair direction(result.halfedge(), 0.1 * static_cast<double>(v.idx()));
    const auto trace = FG::trace_geodesic(mesh, source, direction, 0.75, std::back_inserter(way));
    const auto end = FG::parallel_transport(mesh, way, direction);
    BOOST_TEST((mesh.face(end.first) == trace.location.first));
    const auto on = FG::trace_geodesic(mesh, trace.location, end, 0.25, std::back_inserter(way));
    const auto whole = FG::trace_geodesic(mesh, source, direction, 1.0, std::back_inserter(way));
    const auto place = [&](const Face_location& at) {
      return in_space(t, {t.input().index(mesh.halfedge(at.first)), at.second});
    };
    BOOST_TEST(distance(place(on.location), place(whole.location)) < 1e-9);
  }
  const std::vector<Face_location> far = {source, {Mesh::Face_index(80), source.second}};
  BOOST_CHECK_THROW(FG::parallel_transport(mesh, far, {mesh.halfedge(source.first), 0}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::logarithmic_map(mesh, Mesh::Vertex_index(9999), mesh.vertices(), coordinates.begin()),
                    FG::Vertex_out_of_range_error);
  const std::vector<Mesh::Vertex_index> targets = {Mesh::Vertex_index(1), Mesh::Vertex_index(9999)};
  std::vector<FG::Polar_coordinates> written; // the first target is right, and is not written either
  BOOST_CHECK_THROW(FG::logarithmic_map(mesh, Mesh::Vertex_index(0), targets, std::back_inserter(written)),
                    FG::Vertex_out_of_range_error);
  BOOST_TEST(written.empty());
}

BOOST_AUTO_TEST_CASE(mistakes_are_refused)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const Triangulation t(mesh);
  const FG::Parallel_transport<Triangulation> transport(t);
  const FG::Surface_location here = location_of(t, {0.5, 0.25}), there = location_of(t, {3.5, 3.25});
  const FG::Surface_direction direction = {here.halfedge, 0};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Locations = std::vector<FG::Surface_location>;
  BOOST_CHECK_THROW(transport(Locations{}, direction), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(transport(Locations{here, there}, direction), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(transport(Locations{here}, {there.halfedge, 0}), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(transport(Locations{here}, {FG::null_index, 0}), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(transport(Locations{here}, {here.halfedge, nan}), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(transport(Locations{here}, direction, there.halfedge), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(transport(Locations{{here.halfedge, {{-1, 1, 1}}}}, direction), FG::Invalid_location_error);
  BOOST_CHECK_THROW((FG::Logarithmic_map<Triangulation>(t, mesh, {here.halfedge, {{nan, 1, 1}}})),
                    FG::Invalid_location_error);
  const FG::Logarithmic_map<Triangulation> logarithm(t, mesh, here);
  BOOST_CHECK_THROW(logarithm({FG::null_index, {{1, 0, 0}}}), FG::Invalid_location_error);
  BOOST_CHECK_THROW(logarithm(FG::Vertex_index(1000)), FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(logarithm.transported(there, nan), FG::Invalid_parameter_error);
  BOOST_TEST(logarithm(here).radius == 0);
  BOOST_TEST(std::isnan(logarithm(here).angle));
  FG::Distance_field_limits limits;
  limits.radius = 1;
  const FG::Logarithmic_map<Triangulation> near(t, mesh, here, CGAL::parameters::search_limit(limits));
  BOOST_TEST(std::isinf(near(there).radius));
  BOOST_TEST(std::isnan(near.transported(there, 0).angle));
}
