// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Curves by their lengths, angles between curves, midpoints and means: where the surface rolls out into the plane, by
// symmetry, and as minima.

#include "surfaces.h"

#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/geodesic_mean.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace tangents_test;

namespace {

using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>;
using Sample = FG::Curve_sample<Mesh, Point>;
using Mesh_vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;

FG::Surface_location located(const Triangulation& t, const Mesh& mesh, const Face_location& at)
{
  return {t.input().index(mesh.halfedge(at.first)), at.second};
}

Point point_at(const Mesh& mesh, const Face_location& at)
{
  const Triangulation t(mesh);
  return in_space(t, located(t, mesh, at));
}

// A cylinder with a slit, rolled out: the grid's columns are its sides.
Mesh rolled(int n)
{
  return to_mesh<Mesh>(mapped(flat_grid(n, n, Diagonal_rule::ALTERNATING), [](const Coordinates& p) {
    return Coordinates{std::cos(0.5 * p[0]), std::sin(0.5 * p[0]), p[1] * 2 * std::sin(0.25)};
  }));
}

double variance(const Mesh& mesh, const Triangulation& t, const FG::Surface_location& at,
                const std::vector<FG::Surface_location>& points)
{
  FG::Geodesic_distance_field<Triangulation> field(t, mesh);
  field.add_source(at);
  field.compute();
  double sum = 0;
  for(const FG::Surface_location& p : points)
    sum += std::pow(field.distance(p), 2) / static_cast<double>(points.size());
  return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(samples_are_equally_far_along_the_curve)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(9, 9, Diagonal_rule::ALTERNATING, 0.2, 4));
  const Face_location source = {Mesh::Face_index(50), {{0.25, 0.5, 0.25}}};
  std::vector<Face_location> way;
  const Vector direction(0.8, 0.6, 0);
  const double length = FG::trace_geodesic(mesh, source, direction, 4.0, std::back_inserter(way)).length();
  std::vector<Sample> samples;
  FG::sample_curve(mesh, way, 11, std::back_inserter(samples));
  BOOST_REQUIRE(samples.size() == 11u);
  for(std::size_t i = 0; i < samples.size(); ++i) {
    const double part = static_cast<double>(i) / 10;
    BOOST_TEST(std::abs(samples[i].length - part * length) < 1e-13);
    BOOST_TEST(distance(samples[i].point, point_at(mesh, source) + part * length * direction) < 1e-13);
    BOOST_TEST(distance(samples[i].point, point_at(mesh, samples[i].location)) < 1e-13);
    BOOST_TEST(std::sqrt((samples[i].tangent - direction).squared_length()) < 1e-12);
    BOOST_TEST((samples[i].normal == Vector(0, 0, 1)));
  }
}

BOOST_AUTO_TEST_CASE(samples_on_edges_name_them_and_points_have_no_tangents)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(3, 3, Diagonal_rule::RISING));
  std::vector<Face_location> way;
  FG::trace_geodesic(mesh, Face_location(Mesh::Face_index(0), {{0.25, 0.5, 0.25}}), Vector(1, 0, 0), 2.0,
                     std::back_inserter(way));
  const double start = point_at(mesh, way.front()).x();
  std::vector<Sample> samples;
  FG::sample_curve(mesh, way, 2, std::back_inserter(samples));
  for(const Sample& sample : samples)
    BOOST_TEST((sample.halfedge == Mesh::null_halfedge()));
  const Face_location on_edge = way[1];
  FG::sample_curve(mesh, std::vector<Face_location>{way[0], on_edge}, 2, std::back_inserter(samples));
  const Halfedge h = samples.back().halfedge;
  BOOST_REQUIRE((h != Mesh::null_halfedge()));
  const Point p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h)), at = samples.back().point;
  BOOST_TEST(at.x() > start);
  BOOST_TEST(std::abs(distance(p, at) + distance(at, q) - distance(p, q)) < 1e-15);

  samples.clear();
  FG::sample_curve(mesh, std::vector<Face_location>{way[0]}, 3, std::back_inserter(samples));
  BOOST_REQUIRE(samples.size() == 3u);
  for(const Sample& sample : samples) {
    BOOST_TEST((sample.tangent == Vector(0, 0, 0)));
    BOOST_TEST((sample.normal == Vector(0, 0, 1)));
    BOOST_TEST((sample.point == point_at(mesh, way[0])));
  }
}

BOOST_AUTO_TEST_CASE(a_face_without_area_has_no_normal)
{
  const Mesh mesh = to_mesh<Mesh>({{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 0, 3}}});
  const Face_location from = {Mesh::Face_index(0), {{0.5, 0.25, 0.25}}},
                      to = {Mesh::Face_index(0), {{0.25, 0.5, 0.25}}};
  std::vector<Sample> samples;
  FG::sample_curve(mesh, std::vector<Face_location>{from, to}, 2, std::back_inserter(samples));
  for(const Sample& sample : samples)
    BOOST_TEST((sample.normal == Vector(0, 0, 0)));
}

// At the ends of the line no face has an angle, and there are no directions.
BOOST_AUTO_TEST_CASE(a_mean_on_a_line_says_what_is_missing)
{
  const Mesh mesh =
      to_mesh<Mesh>({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  const std::vector<Mesh_vertex> ends = {Mesh_vertex(0), Mesh_vertex(3)}, inside = {Mesh_vertex(1), Mesh_vertex(2)};
  const auto is_clear = [](const FG::Degenerate_face_error& error) {
    return std::string(error.what()).find("vertex 0 have an angle of 0") != std::string::npos &&
           error.elements()[0] == 0;
  };
  BOOST_CHECK_EXCEPTION(FG::geodesic_mean(mesh, ends), FG::Degenerate_face_error, is_clear);
  BOOST_TEST(std::abs(FG::geodesic_mean(mesh, inside).report.variance - 0.25) < 1e-14);
  BOOST_TEST((FG::geodesic_mean(mesh, std::vector<Mesh_vertex>{ends[0]}).report.status == FG::Mean_status::CONVERGED));
}

// However places are told: a vertex by any face about it, and weights up to rounding.
BOOST_AUTO_TEST_CASE(curves_with_an_angle_start_at_one_place)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(2, 2, Diagonal_rule::RISING));
  const Mesh_vertex middle(grid_vertex(2, 1, 1));
  std::vector<std::vector<Face_location>> rays; // from the middle to the middles of the faces about it
  for(const auto f : mesh.faces()) {
    Face_location tip = {f, {{0, 0, 0}}}, center = {f, {{0.25, 0.25, 0.5}}};
    std::size_t i = 0;
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      tip.second[i++] = mesh.source(h) == middle ? 1 : 0;
    if(tip.second != std::array<double, 3>{0, 0, 0})
      rays.push_back({tip, center});
  }
  BOOST_REQUIRE(rays.size() == 6u);
  const auto direction = [&](const std::vector<Face_location>& ray) {
    const Vector way = point_at(mesh, ray[1]) - mesh.point(middle);
    return std::atan2(way.y(), way.x());
  };
  for(const auto& a : rays)
    for(const auto& b : rays) {
      const double angle = FG::angle_between_curves(mesh, a, b) - (direction(b) - direction(a));
      BOOST_TEST(std::abs(std::remainder(angle, 2 * pi)) < 1e-13);
    }
  const std::array<double, 3> weights = {0.25, 0.25, 0.5};
  const Face_location place = {rays[0][0].first, weights}, same = {place.first, {{0.25 + 1e-10, 0.25 - 1e-10, 0.5}}},
                      elsewhere = {rays[1][0].first, weights}, on_edge = {place.first, {{0.5, 0.5, 0}}},
                      vertex = {place.first, {{0, 1, 0}}};
  BOOST_TEST(std::abs(FG::angle_between_curves(mesh, std::vector<Face_location>{place, vertex},
                                               std::vector<Face_location>{same, vertex})) < 1e-8);
  const Face_location beside = {place.first, {{0.25 + 1e-8, 0.25 - 1e-8, 0.5}}};
  for(const Face_location& other : {elsewhere, on_edge, vertex, beside})
    BOOST_CHECK_THROW(FG::angle_between_curves(mesh, std::vector<Face_location>{place, on_edge},
                                               std::vector<Face_location>{other, {other.first, {{0.25, 0.5, 0.25}}}}),
                      FG::Invalid_curve_error);
  for(const std::vector<Face_location>& ray : rays) // on the edges about the vertex
    for(std::size_t k = 0; k < 3; ++k) {
      Face_location half = ray[0];
      for(std::size_t l = 0; l < 3; ++l)
        half.second[l] = half.second[l] / 2 + (l == k ? 0.5 : 0);
      if(half.second != ray[0].second)
        BOOST_CHECK_THROW(FG::angle_between_curves(mesh, ray, std::vector<Face_location>{half, ray[1]}),
                          FG::Invalid_curve_error);
    }
}

BOOST_AUTO_TEST_CASE(samples_go_round_corners)
{
  const Mesh mesh = to_mesh<Mesh>(cube(2)); // of size 2, around it half a unit above its base
  for(const auto f : mesh.faces()) {
    std::vector<Face_location> way;
    const Face_location source = {f, {{0.25, 0.25, 0.5}}};
    const auto h = mesh.halfedge(f);
    const Vector n = CGAL::cross_product(mesh.point(mesh.target(h)) - mesh.point(mesh.source(h)),
                                         mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.target(h)));
    if(n.z() != 0)
      continue;
    FG::trace_geodesic(mesh, source, Vector(n.y(), -n.x(), 0), 8.0, std::back_inserter(way));
    std::vector<Sample> samples;
    FG::sample_curve(mesh, way, 5, std::back_inserter(samples)); // one on each side
    for(std::size_t i = 0; i < 4; ++i) {
      const Vector to_next = samples[i + 1].point - samples[i].point;
      BOOST_TEST(std::abs(samples[i].normal * samples[i + 1].normal) < 1e-14);
      BOOST_TEST(std::abs(samples[i].tangent * samples[i].normal) < 1e-14);
      BOOST_TEST(std::abs(samples[i].normal * n -
                          std::sqrt(n.squared_length()) * std::array<double, 4>{1, 0, -1, 0}[i]) < 1e-13);
      BOOST_TEST(to_next.squared_length() < 4.0);
    }
    BOOST_TEST(distance(samples.front().point, samples.back().point) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(places_and_directions_on_a_curve)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const Triangulation t(mesh);
  const std::vector<FG::Surface_location> corners = {location_of(t, {0.5, 0.25}), location_of(t, {1, 0.25}),
                                                     location_of(t, {1, 1}), location_of(t, {1, 1}),
                                                     location_of(t, {1.75, 1.5})};
  const FG::Located_curve<Triangulation> curve(t, corners);
  BOOST_TEST(curve.locations().size() == 4u);
  const double last = std::hypot(0.75, 0.5);
  BOOST_TEST(std::abs(curve.length() - 1.25 - last) < 1e-15);
  const std::array<std::pair<double, std::complex<double>>, 6> places = {{{0, {0.5, 0.25}},
                                                                          {0.25, {0.75, 0.25}},
                                                                          {0.5, {1, 0.25}},
                                                                          {0.75, {1, 0.5}},
                                                                          {1.25, {1, 1}},
                                                                          {1.25 + last, {1.75, 1.5}}}};
  const std::array<std::complex<double>, 6> directions = {
      {{1, 0}, {1, 0}, {0, 1}, {0, 1}, {0.75 / last, 0.5 / last}, {0.75 / last, 0.5 / last}}};
  for(std::size_t i = 0; i < places.size(); ++i) {
    const FG::Surface_location at = curve.location(places[i].first);
    BOOST_TEST(std::abs(in_plane(t, at) - places[i].second) < 1e-15);
    const FG::Surface_direction d = curve.direction(places[i].first);
    BOOST_TEST((d.halfedge == at.halfedge));
    BOOST_TEST(std::abs(std::polar(1.0, d.angle) * direction_in_plane(t, d.halfedge) - directions[i]) < 1e-15);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(double length : {-0.1, 3.0, nan})
    BOOST_CHECK_THROW(curve.location(length), FG::Invalid_parameter_error);
  const std::vector<FG::Surface_location> one = {corners[0]};
  const FG::Located_curve<Triangulation> point(t, one);
  BOOST_TEST(point.length() == 0);
  BOOST_TEST((in_plane(t, point.location(0)) == std::complex<double>(0.5, 0.25)));
  BOOST_CHECK_THROW(point.direction(0), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(point.piece(0), FG::Invalid_curve_error);
  BOOST_CHECK_THROW((FG::Located_curve<Triangulation>(t, std::vector<FG::Surface_location>())),
                    FG::Invalid_curve_error);
}

BOOST_AUTO_TEST_CASE(angles_between_curves)
{
  const int k = 9;
  const Mesh mesh = to_mesh<Mesh>(cone_disk(k, 2, 4.5));
  const auto ray = [](int i) { return std::vector<Mesh_vertex>{Mesh_vertex(0), Mesh_vertex(disk_vertex(k, 1, i))}; };
  for(int i = 0; i < k; ++i) {
    const double there = FG::angle_between_curves(mesh, ray(0), ray(i)),
                 back = FG::angle_between_curves(mesh, ray(i), ray(0));
    BOOST_TEST(std::abs((i == 0 ? 0 : there + back) - (i == 0 ? 0 : 4.5)) < 1e-13);
    BOOST_TEST(std::abs(there - i * 4.5 / k) < 1e-13);
  }
  // On the border there are no whole turns.
  const std::vector<Mesh_vertex> inward = {Mesh_vertex(disk_vertex(k, 2, 0)), Mesh_vertex(disk_vertex(k, 1, 0))},
                                 along = {Mesh_vertex(disk_vertex(k, 2, 0)), Mesh_vertex(disk_vertex(k, 2, 1))};
  const double angle = (pi - 4.5 / k) / 2; // of a sector
  BOOST_TEST(std::abs(FG::angle_between_curves(mesh, along, inward) - angle) < 1e-13);
  BOOST_TEST(std::abs(FG::angle_between_curves(mesh, inward, along) + angle) < 1e-13);
  BOOST_CHECK_THROW(FG::angle_between_curves(mesh, along, ray(0)), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::angle_between_curves(mesh, along, std::vector<Mesh_vertex>{along.front()}),
                    FG::Invalid_curve_error);
  // Inside a face.
  const Mesh::Face_index f(3);
  const Face_location here = {f, {{0.25, 0.25, 0.5}}};
  const auto to = [&](int i) {
    Face_location there = {f, {{0, 0, 0}}};
    there.second[static_cast<std::size_t>(i)] = 1;
    return std::vector<Face_location>{here, there};
  };
  BOOST_TEST(std::abs(FG::angle_between_curves(mesh, to(0), to(1)) + FG::angle_between_curves(mesh, to(1), to(2)) +
                      FG::angle_between_curves(mesh, to(2), to(0)) - 2 * pi) < 1e-13);
  const std::vector<Face_location> beside = {{f, {{0.25, 0.375, 0.375}}}, here};
  BOOST_CHECK_THROW(FG::angle_between_curves(mesh, to(0), beside), FG::Invalid_curve_error);
}

BOOST_AUTO_TEST_CASE(midpoints_are_as_far_from_both_ends)
{
  for(const Mesh& mesh : {to_mesh<Mesh>(bumpy_sphere(5, 0.2, 5)), to_mesh<Mesh>(saddle_disk(12, 4, 9)), rolled(7)}) {
    const Triangulation t(mesh);
    std::mt19937 random(8);
    for(int i = 0; i < 30; ++i) {
      const Face_location p = {Mesh::Face_index(random() % mesh.number_of_faces()), {{0.5, 0.25, 0.25}}},
                          q = {Mesh::Face_index(random() % mesh.number_of_faces()), {{0.125, 0.25, 0.625}}};
      const FG::Surface_location middle = located(t, mesh, FG::geodesic_midpoint(mesh, p, q));
      FG::Geodesic_distance_field<Triangulation> from_p(t, mesh), from_q(t, mesh);
      from_p.add_source(located(t, mesh, p));
      from_q.add_source(located(t, mesh, q));
      from_p.compute();
      from_q.compute();
      const double whole = from_p.distance(located(t, mesh, q));
      BOOST_TEST(std::abs(from_p.distance(middle) - 0.5 * whole) < 1e-11);
      BOOST_TEST(std::abs(from_q.distance(middle) - 0.5 * whole) < 1e-11);
    }
  }
  const Mesh two =
      to_mesh<Mesh>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}});
  BOOST_CHECK_THROW(FG::geodesic_midpoint(two, Mesh_vertex(0), Mesh_vertex(5)), FG::Disconnected_endpoints_error);
  const Face_location same = FG::geodesic_midpoint(two, Mesh_vertex(0), Mesh_vertex(0));
  BOOST_TEST(distance(point_at(two, same), Point(0, 0, 0)) == 0);
}

BOOST_AUTO_TEST_CASE(where_the_surface_rolls_out_a_mean_is_a_weighted_sum)
{
  const int n = 7;
  const Mesh flat = to_mesh<Mesh>(flat_grid(n, n, Diagonal_rule::ALTERNATING)), bent = rolled(n);
  const Triangulation t(flat);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(0, 1);
  for(int i = 0; i < 10; ++i) {
    std::vector<Face_location> points;
    std::vector<double> weights;
    std::complex<double> mean = 0;
    double sum = 0;
    for(int j = 0; j < 2 + i; ++j) {
      points.push_back({Mesh::Face_index(random() % flat.number_of_faces()), {{0.5, 0.25, 0.25}}});
      weights.push_back(j == 3 ? 0 : number(random));
      mean += weights.back() * in_plane(t, located(t, flat, points.back()));
      sum += weights.back();
    }
    mean /= sum;
    for(const Mesh& mesh : {flat, bent}) {
      const auto result = FG::geodesic_mean(mesh, points, weights);
      BOOST_TEST((result.report.status == FG::Mean_status::CONVERGED));
      BOOST_TEST(result.report.iterations <= 2u);
      // Corresponding faces; the sides of the cells are by one factor longer.
      BOOST_TEST(std::abs(in_plane(t, located(t, flat, result.location)) - mean) < 1e-10);
    }
  }
}

// Which side of its face a corner is told by does not matter.
BOOST_AUTO_TEST_CASE(means_with_corners_of_the_border)
{
  const Mesh mesh = to_mesh<Mesh>({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
  const Triangulation t(mesh);
  for(const Mesh::Face_index f : mesh.faces())
    for(std::size_t corner = 0; corner < 3; ++corner) {
      Face_location vertex(f, {{0, 0, 0}});
      vertex.second[corner] = 1;
      for(const Mesh::Face_index g : mesh.faces()) {
        const Face_location inside(g, {{0.6, 0.1, 0.3}});
        const auto result =
            FG::geodesic_mean(mesh, std::vector<Face_location>{vertex, inside}, std::vector<double>{2, 1});
        BOOST_TEST((result.report.status == FG::Mean_status::CONVERGED));
        const std::complex<double> mean =
            (2. * in_plane(t, located(t, mesh, vertex)) + in_plane(t, located(t, mesh, inside))) / 3.;
        BOOST_TEST(std::abs(in_plane(t, located(t, mesh, result.location)) - mean) < 1e-10);
      }
    }
}

BOOST_AUTO_TEST_CASE(means_by_symmetry)
{
  const Mesh mesh = to_mesh<Mesh>(octahedron(1)); // the vertices of one face
  std::vector<Mesh_vertex> axes(3);
  for(const Mesh_vertex v : mesh.vertices())
    for(int i = 0; i < 3; ++i)
      if(mesh.point(v)[i] > 1 - 1e-12)
        axes[static_cast<std::size_t>(i)] = v;
  const auto result = FG::geodesic_mean(mesh, axes);
  BOOST_TEST((result.report.status == FG::Mean_status::CONVERGED));
  const Point p = point_at(mesh, result.location);
  BOOST_TEST(std::abs(p.x() - p.y()) < 1e-9);
  BOOST_TEST(std::abs(p.y() - p.z()) < 1e-9);
  BOOST_TEST(p.x() > 0.3);
  // Behind a saddle in three directions: the vertex itself, at which vectors do not cancel out.
  const int k = 12;
  const Mesh saddle = to_mesh<Mesh>(saddle_disk(k, 3, 6 * pi));
  const std::vector<Mesh_vertex> around = {Mesh_vertex(disk_vertex(k, 2, 0)), Mesh_vertex(disk_vertex(k, 2, 4)),
                                           Mesh_vertex(disk_vertex(k, 2, 8))};
  const auto at_saddle = FG::geodesic_mean(saddle, around);
  BOOST_TEST((at_saddle.report.status != FG::Mean_status::ITERATION_LIMIT));
  BOOST_TEST(distance(point_at(saddle, at_saddle.location), saddle.point(Mesh_vertex(0))) < 1e-9);
}

BOOST_AUTO_TEST_CASE(means_are_minima)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(5, 0.2, 5));
  const Triangulation t(mesh);
  std::mt19937 random(4);
  for(int i = 0; i < 6; ++i) {
    std::vector<FG::Surface_location> points;
    const FG::Surface_location center = random_location(t, 2, random);
    for(int j = 0; j < 4; ++j)
      points.push_back(FG::Geodesic_tracer<Triangulation>(t)
                           .trace(center, FG::Surface_direction{center.halfedge, 1.7 * j + i}, 0.4 + 0.1 * j,
                                  CGAL::Emptyset_iterator())
                           .location);
    const FG::Geodesic_mean<Triangulation> mean(t, mesh, points, std::vector<double>(points.size(), 3));
    FG::Surface_location place = mean.heaviest();
    const FG::Mean_report report = mean(place);
    BOOST_TEST((report.status != FG::Mean_status::ITERATION_LIMIT));
    BOOST_TEST(std::abs(report.variance - variance(mesh, t, place, points)) < 1e-12);
    for(double angle : {0.0, 1.5, 3.0, 4.5}) {
      const auto beside =
          FG::Geodesic_tracer<Triangulation>(t)
              .trace(place, FG::Surface_direction{place.halfedge, angle}, 1e-3, CGAL::Emptyset_iterator())
              .location;
      BOOST_TEST(variance(mesh, t, beside, points) > report.variance);
    }
    FG::Surface_location first = mean.heaviest();
    BOOST_TEST((mean(first, CGAL::parameters::search_limit(FG::Mean_limits{1e-11, 0})).status ==
                FG::Mean_status::ITERATION_LIMIT));
    BOOST_TEST((first.halfedge == mean.heaviest().halfedge && first.weights == mean.heaviest().weights));
  }
}

// More than a quarter of a sphere away from both points, the vectors to them get longer at first on the way to the
// mean.
BOOST_AUTO_TEST_CASE(means_on_the_other_side_of_a_sphere)
{
  const Mesh mesh = to_mesh<Mesh>(sphere(8));
  const Triangulation t(mesh);
  const auto near = [&](const Point& p) {
    const auto is_nearer = [&](Mesh_vertex v, Mesh_vertex w) {
      return distance(mesh.point(v), p) < distance(mesh.point(w), p);
    };
    return t.location(t.index(*std::min_element(mesh.vertices().begin(), mesh.vertices().end(), is_nearer)));
  };
  const double y = std::sqrt(0.75);
  const FG::Geodesic_mean<Triangulation> mean(t, mesh, {near(Point(-0.5, y, 0)), near(Point(-0.5, -y, 0))}, {1, 1});
  for(const double z : {0.1, 0.3}) {
    FG::Surface_location place = near(Point(1, 0, z));
    BOOST_TEST((mean(place).status == FG::Mean_status::CONVERGED));
    BOOST_TEST(in_space(t, place).x() < -0.99);
  }
}

// From behind the saddle whole steps are too long, and in front of it they are right.
BOOST_AUTO_TEST_CASE(steps_get_longer_again_past_a_saddle)
{
  const int k = 12;
  const Mesh mesh = to_mesh<Mesh>(saddle_disk(k, 6, 4 * pi));
  const Triangulation t(mesh);
  std::vector<FG::Surface_location> points; // in a plane part of the disk
  for(int i : {0, 1, 2})
    for(int ring : {3, 4})
      points.push_back(t.location(FG::Vertex_index(disk_vertex(k, ring, i))));
  const FG::Geodesic_mean<Triangulation> mean(t, mesh, points, std::vector<double>(points.size(), 1));
  for(int i : {5, 6, 7, 8}) {
    FG::Surface_location place = t.location(FG::Vertex_index(disk_vertex(k, 2, i)));
    const FG::Mean_report report = mean(place);
    BOOST_TEST((report.status == FG::Mean_status::CONVERGED));
    BOOST_TEST(report.iterations < 10u);
  }
}

BOOST_AUTO_TEST_CASE(without_a_tolerance_the_search_ends_where_rounding_begins)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(3, 0.3, 5));
  const Triangulation t(mesh);
  std::mt19937 random(4);
  for(int i = 0; i < 4; ++i) {
    std::vector<FG::Surface_location> points;
    for(int j = 0; j < 3; ++j)
      points.push_back(random_location(t, 2, random));
    const FG::Geodesic_mean<Triangulation> mean(t, mesh, points, {1, 2, 3});
    FG::Surface_location place = mean.heaviest();
    BOOST_TEST((mean(place, CGAL::parameters::search_limit(FG::Mean_limits{0, 2000})).status !=
                FG::Mean_status::ITERATION_LIMIT));
  }
}

// The search starts at the point with the largest weight.
BOOST_AUTO_TEST_CASE(without_a_step_the_mean_is_the_heaviest_point)
{
  const Mesh mesh = to_mesh<Mesh>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const std::vector<Mesh_vertex> points = {Mesh_vertex(0), Mesh_vertex(1), Mesh_vertex(2)};
  for(std::size_t heaviest : {0, 1, 2}) {
    std::vector<double> weights = {1, 1, 1};
    weights[heaviest] = 2;
    const auto result = FG::geodesic_mean(mesh, points, weights, CGAL::parameters::number_of_iterations(0));
    auto h = mesh.halfedge(result.location.first);
    for(double weight : result.location.second) {
      BOOST_TEST(weight == (mesh.source(h) == points[heaviest] ? 1 : 0));
      h = mesh.next(h);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_has_no_mean_is_refused)
{
  const Mesh mesh =
      to_mesh<Mesh>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}});
  const std::vector<Mesh_vertex> none, one = {Mesh_vertex(0)}, two = {Mesh_vertex(0), Mesh_vertex(1)},
                                       apart = {Mesh_vertex(0), Mesh_vertex(5)};
  using Weights = std::vector<double>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(FG::geodesic_mean(mesh, none), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(FG::geodesic_mean(mesh, two, CGAL::parameters::number_of_iterations(-1)),
                    FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(FG::geodesic_mean(mesh, two, Weights{1}), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(FG::geodesic_mean(mesh, two, Weights{1, -1}), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(FG::geodesic_mean(mesh, two, Weights{1, nan}), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(FG::geodesic_mean(mesh, two, Weights{0, 0}), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(FG::geodesic_mean(mesh, apart), FG::Disconnected_endpoints_error);
  const auto alone = FG::geodesic_mean(mesh, one);
  BOOST_TEST((alone.report.status == FG::Mean_status::CONVERGED));
  BOOST_TEST(alone.report.variance == 0);
  const auto at_heavy = FG::geodesic_mean(mesh, apart, Weights{1, 0}); // what has no weight need not be reached
  BOOST_TEST(distance(point_at(mesh, at_heavy.location), Point(0, 0, 0)) == 0);
  std::vector<Sample> samples;
  BOOST_CHECK_THROW(FG::sample_curve(mesh, two, 1, std::back_inserter(samples)), FG::Invalid_parameter_error);
  const Triangulation t(mesh);
  const FG::Geodesic_mean<Triangulation> mean(t, mesh, {t.location(FG::Vertex_index(0))}, {1});
  FG::Surface_location start = mean.heaviest();
  BOOST_CHECK_THROW(mean(start, CGAL::parameters::search_limit(FG::Mean_limits{nan, 1})), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(mean(start, CGAL::parameters::search_limit(FG::Mean_limits{-1, 1})), FG::Invalid_parameter_error);
}

// Two triangles have a vertex in common and nothing else. Paths pass it and have midpoints, but directions in different
// triangles have no angle.
BOOST_AUTO_TEST_CASE(sheets_that_meet_in_a_vertex_have_no_directions_in_common)
{
  const Mesh mesh = to_mesh<Mesh>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}});
  const auto is_told = [](const FG::Error& error) { return error.elements() == std::vector<std::size_t>{0}; };
  const Mesh_vertex v(0), a(1), b(3);
  std::map<Mesh_vertex, double> distances;
  FG::geodesic_distances(mesh, a, boost::make_assoc_property_map(distances));
  BOOST_TEST(distances[b] == 2);
  for(const Mesh_vertex end : {a, b}) {
    const Point middle = CGAL::midpoint(mesh.point(v), mesh.point(end));
    BOOST_TEST(distance(point_at(mesh, FG::geodesic_midpoint(mesh, v, end)), middle) < 1e-15);
  }
  const std::vector<Mesh_vertex> to_a = {v, a}, to_b = {v, b};
  BOOST_CHECK_EXCEPTION(FG::angle_between_curves(mesh, to_a, to_b), FG::Invalid_mesh_error, is_told);
  std::map<Mesh_vertex, FG::Polar_coordinates> polar;
  BOOST_CHECK_EXCEPTION(FG::logarithmic_map(mesh, v, boost::make_assoc_property_map(polar)), FG::Invalid_mesh_error,
                        is_told);
}
