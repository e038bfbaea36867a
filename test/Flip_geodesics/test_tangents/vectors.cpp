// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Vectors in space carried along curves: those of a plane do not change, others follow straightest geodesics.

#include "surfaces.h"

#include <CGAL/Flip_geodesics/tangent_vectors.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

using namespace tangents_test;

namespace {

using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>;

Vector normal_of(const Mesh& mesh, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  const auto p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h)), r = mesh.point(mesh.target(mesh.next(h)));
  const Vector n = CGAL::cross_product(q - p, r - p);
  return n / std::sqrt(n.squared_length());
}

double size(const Vector& v) { return std::sqrt(v.squared_length()); }

} // namespace

BOOST_AUTO_TEST_CASE(vectors_follow_straightest_geodesics)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(5, 0.2, 5));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for(int i = 0; i < 60; ++i) {
    const Mesh::Face_index face(static_cast<unsigned>(random() % mesh.number_of_faces()));
    const Face_location source = {face, {{0.25, 0.5, 0.25}}};
    const Vector given(coordinate(random), coordinate(random), coordinate(random)),
        normal = normal_of(mesh, source.first), projected = given - (given * normal) * normal;
    std::vector<Face_location> way;
    const auto trace = FG::trace_geodesic(mesh, source, given, 1, std::back_inserter(way));
    BOOST_REQUIRE(trace.location.first == way.back().first);
    const Vector end = FG::parallel_transport(mesh, way, given);
    BOOST_TEST(std::abs(size(end) - size(projected)) < 1e-13);
    BOOST_TEST(std::abs(end * normal_of(mesh, way.back().first)) < 1e-13);
    std::vector<Face_location> by_vector, by_angle;
    FG::trace_geodesic(mesh, trace.location, end, 0.2, std::back_inserter(by_vector));
    FG::trace_geodesic(mesh, trace.location, trace.direction, 0.2, std::back_inserter(by_angle));
    BOOST_REQUIRE(by_vector.size() == by_angle.size());
    for(std::size_t k = 0; k < by_vector.size(); ++k)
      for(std::size_t w = 0; w < 3; ++w)
        BOOST_TEST(std::abs(by_vector[k].second[w] - by_angle[k].second[w]) < 1e-9);
    std::reverse(way.begin(), way.end());
    BOOST_TEST(size(FG::parallel_transport(mesh, way, end) - projected) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(vectors_in_a_plane_do_not_change)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(5, 5, Diagonal_rule::RISING));
  for(const auto h : mesh.halfedges()) { // from vertex to vertex along an edge, in any faces around these
    if(mesh.is_border(mesh.source(h)) || mesh.is_border(mesh.target(h)))
      continue;
    for(const auto f : CGAL::halfedges_around_target(mesh.opposite(h), mesh))
      for(const auto g : CGAL::halfedges_around_target(h, mesh)) {
        const auto at_target = [&](Mesh::Halfedge_index side) {
          Face_location result(mesh.face(side), {{0, 0, 0}});
          auto corner = mesh.halfedge(mesh.face(side));
          for(double& weight : result.second) {
            weight = mesh.source(corner) == mesh.target(side);
            corner = mesh.next(corner);
          }
          return result;
        };
        const std::vector<Face_location> way = {at_target(f), at_target(g)};
        for(const Vector& v : {Vector(1, 0.5, 0), Vector(-2, 0.1, 0), Vector(0.3, -1, 0)})
          BOOST_TEST(size(FG::parallel_transport(mesh, way, v + Vector(0, 0, 3)) - v) < 1e-13);
      }
  }
}

BOOST_AUTO_TEST_CASE(vectors_are_folded_over_edges)
{
  const Mesh mesh = to_mesh<Mesh>(cube(2));
  for(const auto h : mesh.halfedges()) {
    const auto f = mesh.face(h), g = mesh.face(mesh.opposite(h));
    const Vector n = normal_of(mesh, f), m = normal_of(mesh, g);
    if(std::abs(n * m) > 0.5)
      continue; // in one side of the cube
    const std::vector<Face_location> way = {{f, {{1. / 3, 1. / 3, 1. / 3}}}, {g, {{1. / 3, 1. / 3, 1. / 3}}}};
    std::vector<Face_location> crossed = {way[0], way[0], way[1]};
    auto side = mesh.halfedge(f);
    for(std::size_t i = 0; i < 3; ++i, side = mesh.next(side))
      crossed[1].second[i] = mesh.source(side) == mesh.source(h) || mesh.source(side) == mesh.target(h) ? 0.5 : 0;
    BOOST_TEST(size(FG::parallel_transport(mesh, crossed, m) + n) < 1e-14); // outward becomes inward
    const Vector along = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    BOOST_TEST(size(FG::parallel_transport(mesh, crossed, along) - along) < 1e-14);
    BOOST_CHECK_THROW(FG::parallel_transport(mesh, way, along), FG::Invalid_curve_error);
    BOOST_CHECK_THROW(FG::parallel_transport(mesh, crossed, along / 0.0), FG::Invalid_parameter_error);
  }
}

// Two planes have a vertex in common and nothing else; a curve through it stays in the plane in which it arrives.
BOOST_AUTO_TEST_CASE(vectors_pass_a_vertex_of_two_umbrellas)
{
  const Mesh mesh = to_mesh<Mesh>(
      {{{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 1}, {0, -1, 1}, {0, -1, -1}, {0, 1, -1}},
       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 5, 6}, {0, 6, 7}, {0, 7, 8}}});
  const auto in_face = [&](std::size_t i, double weight_of_center) {
    const auto f = *std::next(mesh.faces().begin(), static_cast<std::ptrdiff_t>(i));
    Face_location result(f, {{0, 0, 0}});
    auto corner = mesh.halfedge(f);
    for(double& weight : result.second) {
      weight = mesh.source(corner) == Mesh::Vertex_index(0) ? weight_of_center : 0.5 * (1 - weight_of_center);
      corner = mesh.next(corner);
    }
    return result;
  };
  for(const std::size_t plane : {std::size_t(0), std::size_t(3)})
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j) {
        const std::size_t f = plane + i, g = plane + j;
        const std::vector<Face_location> way = {in_face(f, 0.4), in_face(f, 1), in_face(g, 0.7)};
        const Vector v = plane == 0 ? Vector(0.3, -0.8, 0) : Vector(0, 0.3, -0.8);
        BOOST_TEST(size(FG::parallel_transport(mesh, way, v) - v) < 1e-14);
      }
}
