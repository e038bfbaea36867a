// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The smoothest direction field: Poincare-Hopf, constant fields in the plane, alignment to curves.

#include "Double_triangulation.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "mesh_soup.h"

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Direction_field.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <complex>
#include <vector>

#endif

#define BOOST_TEST_MODULE direction_field
#include <boost/test/unit_test.hpp>

#ifdef CGAL_EIGEN3_ENABLED

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = Double_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Field = FG::Direction_field<Triangulation>;

int total_index(const Field& field)
{
  int sum = 0;
  for(const Field::Singularity& singularity : field.singularities())
    sum += singularity.index;
  return sum;
}

double difference(const Field& field, FG::Vertex_index v, double angle, int symmetry)
{
  const double turn = symmetry * (field.angle(v) - angle);
  return std::abs(std::arg(std::polar(1.0, turn))) / symmetry;
}

// The direction, in the plane, of a flat mesh's reference at v.
double reference_direction(const Mesh& mesh, const Triangulation& triangulation, const Field& field, FG::Vertex_index v)
{
  const FG::Halfedge_index h = field.tangent_spaces().reference(v);
  const Point p = mesh.point(triangulation.vertex(triangulation.tail(h)));
  const Point q = mesh.point(triangulation.vertex(triangulation.head(h)));
  return std::atan2(q.y() - p.y(), q.x() - p.x());
}

} // namespace

BOOST_AUTO_TEST_CASE(indices_sum_up_to_the_symmetry_times_the_euler_characteristic)
{
  struct Surface
  {
    Mesh_soup soup;
    int euler_characteristic;
  };
  for(const Surface& surface :
      {Surface{bumpy_sphere(8, 0.3, 2), 2}, Surface{sphere(6), 2}, Surface{torus(20, 10, 3, 1), 0},
       Surface{genus_3_plate(2), -4}, Surface{disjoint_union(sphere(4), torus(9, 9, 3, 1)), 2}})
    for(int symmetry : {1, 2, 4, 6}) {
      const Mesh mesh = to_mesh<Mesh>(surface.soup);
      const Triangulation triangulation(mesh);
      Field field(triangulation, symmetry);
      field.compute();
      BOOST_TEST(total_index(field) == symmetry * surface.euler_characteristic);
    }
}

BOOST_AUTO_TEST_CASE(the_smoothest_vector_field_of_a_sphere_has_few_singularities)
{
  const Mesh mesh = to_mesh<Mesh>(sphere(12));
  const Triangulation triangulation(mesh);
  Field field(triangulation, 1);
  field.compute();
  BOOST_TEST(field.singularities().size() == 2u);
}

BOOST_AUTO_TEST_CASE(in_the_plane_one_direction_makes_the_field_constant)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(9, 9, Diagonal_rule::RISING, 0.2, 3));
  const Triangulation triangulation(mesh);
  for(int symmetry : {1, 4}) {
    Field field(triangulation, symmetry);
    const FG::Vertex_index center(grid_vertex(9, 4, 4));
    field.align(center, 0.3 - reference_direction(mesh, triangulation, field, center));
    field.compute();
    BOOST_TEST(field.singularities().empty());
    BOOST_TEST(field.energy() < 1e-20);
    for(FG::Vertex_index v(0); v.idx() < triangulation.number_of_vertices(); ++v)
      BOOST_TEST(difference(field, v, 0.3 - reference_direction(mesh, triangulation, field, v), symmetry) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(the_field_runs_along_the_curves_it_is_aligned_to)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(10, 0.2, 5));
  Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  Network network(triangulation);
  network.add_curve(FG::shortest_halfedges_through(search, Vertex_sequence{0_v, 150_v}));
  FG::shorten(network);
  Field field(triangulation);
  field.align(network);
  field.compute();
  network.for_each_segment(0_c, [&](FG::Segment_index s) {
    const FG::Halfedge_index h = network.halfedge(s), t = Triangulation::twin(h);
    // At a joint the curve's two directions differ by what its angles exceed pi.
    if(network.previous(s) == FG::null_index)
      BOOST_TEST(difference(field, triangulation.tail(h), field.tangent_spaces().angle(h), 4) < 1e-9);
    if(network.next(s) == FG::null_index)
      BOOST_TEST(difference(field, triangulation.head(h), field.tangent_spaces().angle(t), 4) < 1e-9);
  });
  BOOST_TEST(total_index(field) == 8);
  BOOST_TEST(field.energy() > 0);
}

// With one direction at each vertex and not four: that in which the curve is run through, also where it ends.
BOOST_AUTO_TEST_CASE(curves_have_a_direction)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(6, 6, Diagonal_rule::RISING, 0.2, 3));
  Triangulation triangulation(mesh);
  Network network(triangulation);
  network.add_curve(FG::halfedges_through(triangulation, Vertex_sequence{16_v, 17_v, 18_v}));
  Field field(triangulation, 1);
  field.align(network);
  field.compute();
  const FG::Halfedge_index first = network.halfedge(network.first_segment(0_c)),
                           last = network.halfedge(network.last_segment(0_c));
  constexpr double pi = boost::math::constants::pi<double>();
  BOOST_TEST(difference(field, 16_v, field.tangent_spaces().angle(first), 1) < 1e-9);
  BOOST_TEST(difference(field, 18_v, field.tangent_spaces().angle(Triangulation::twin(last)) + pi, 1) < 1e-9);
}

// What cancels out is not asked for.
BOOST_AUTO_TEST_CASE(opposite_directions_cancel_out)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(6, 0.2, 5));
  const Triangulation triangulation(mesh);
  Field expected(triangulation, 1), field(triangulation, 1);
  for(Field* f : {&expected, &field})
    f->align(3_v, 0.7);
  for(int k = 0; k < 3; ++k)
    field.align(60_v, 0.4 + k * boost::math::constants::two_pi<double>() / 3);
  expected.compute();
  field.compute();
  BOOST_TEST((field.values() - expected.values()).norm() < 1e-9 * expected.values().norm());
}

BOOST_AUTO_TEST_CASE(components_without_a_curve_and_bad_vertices_are_refused)
{
  const Mesh mesh = to_mesh<Mesh>(disjoint_union(sphere(2), sphere(2)));
  const Triangulation triangulation(mesh);
  Field field(triangulation);
  const FG::Vertex_index end(triangulation.number_of_vertices());
  BOOST_CHECK_THROW(field.align(end, 0), FG::Vertex_out_of_range_error);
  field.align(0_v, 0);
  BOOST_CHECK_THROW(field.compute(), FG::Singular_problem_error);
}

// Two squares that share one corner: the halfedges of one of them have no angles at it.
BOOST_AUTO_TEST_CASE(non_manifold_vertices_have_no_tangent_space)
{
  const Mesh_soup two_squares = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
                                 {{0, 1, 2}, {0, 2, 3}, {2, 4, 5}, {2, 5, 6}}};
  const Mesh mesh = to_mesh<Mesh>(two_squares);
  const Triangulation triangulation(mesh);
  const auto names_corner = [](const FG::Invalid_mesh_error& error) {
    return error.elements() == std::vector<std::size_t>{2};
  };
  BOOST_CHECK_EXCEPTION(Field{triangulation}, FG::Invalid_mesh_error, names_corner);
}

#else

BOOST_AUTO_TEST_CASE(direction_fields_need_eigen)
{
  BOOST_TEST_MESSAGE("SKIPPED: Eigen is not installed");
  BOOST_TEST(!Flip_geodesics_test::sphere(2).points.empty());
}

#endif // CGAL_EIGEN3_ENABLED
