// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Finite elements on intrinsic triangulations: identities between the operators, and problems with known solutions,
// each also after random flips, which must not change what the operators mean. Without Eigen there is nothing to test.

#include "Curve_network_archetype.h"
#include "Double_triangulation.h"
#include "Edge_path_graph_archetype.h"
#include "Plain_triangulation.h"
#include "Triangulation_of_mesh_archetype.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "mesh_soup.h"

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Flip_geodesics/Conformal_flattening.h>
#include <CGAL/Flip_geodesics/Direction_field.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Operators.h>
#include <CGAL/Flip_geodesics/delaunay.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#endif

#define BOOST_TEST_MODULE operators
#include <boost/test/unit_test.hpp>

#ifdef CGAL_EIGEN3_ENABLED

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = Double_triangulation<Mesh>;
using Operators = FG::Operators<Triangulation>;
using Vector = Eigen::VectorXd;
using Function = std::function<double(const Point&)>;

void flip_at_random(Triangulation& triangulation, int flips, unsigned seed)
{
  std::mt19937 random(seed);
  for(int i = 0; i < flips; ++i) {
    const FG::Halfedge_index h(
        static_cast<FG::Index>(random() % static_cast<unsigned>(triangulation.number_of_halfedges())));
    if(triangulation.is_flippable(h))
      triangulation.flip(h);
  }
}

Vector sampled(const Mesh& mesh, const Function& f)
{
  Vector result(static_cast<Eigen::Index>(mesh.number_of_vertices()));
  for(Mesh::Vertex_index v : mesh.vertices())
    result[static_cast<Eigen::Index>(v)] = f(mesh.point(v));
  return result;
}

std::vector<FG::Vertex_index> border_vertices(const Mesh& mesh)
{
  std::vector<FG::Vertex_index> result;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(mesh.is_border(v))
      result.emplace_back(static_cast<FG::Index>(v));
  return result;
}

double largest(const Vector& v) { return v.size() == 0 ? 0 : v.lpNorm<Eigen::Infinity>(); }

double total_area(const Mesh& mesh)
{
  double sum = 0;
  for(Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
                &c = mesh.point(mesh.target(mesh.next(h)));
    sum += std::sqrt(CGAL::squared_area(a, b, c));
  }
  return sum;
}

void check_identities(const Mesh& mesh, const Triangulation& triangulation)
{
  const Operators operators(triangulation);
  const Eigen::Index n = static_cast<Eigen::Index>(mesh.number_of_vertices());
  const Operators::Matrix weak = operators.weak_laplacian(), gradient = operators.gradient();
  BOOST_TEST((weak.isCompressed() && weak.outerIndexPtr()[0] == 0));
  const double scale = weak.coeffs().abs().maxCoeff();
  BOOST_TEST(largest(weak * Vector::Ones(n)) < 1e-11 * scale);
  BOOST_TEST(Operators::Matrix(weak - Operators::Matrix(weak.transpose())).norm() < 1e-12 * weak.norm());
  BOOST_TEST(Operators::Matrix(weak + operators.divergence() * gradient).norm() < 1e-10 * weak.norm());

  const double area = total_area(mesh);
  BOOST_TEST(std::abs(operators.face_areas().sum() - area) < 1e-11 * area);
  BOOST_TEST(std::abs(operators.vertex_areas().sum() - area) < 1e-11 * area);
  BOOST_TEST(std::abs(operators.lumped_mass().sum() - area) < 1e-11 * area);
  BOOST_TEST(largest(operators.consistent_mass() * Vector::Ones(n) - operators.vertex_areas()) < 1e-12 * area);

  std::mt19937 random(3);
  Vector u(n);
  for(Eigen::Index i = 0; i < n; ++i)
    u[i] = static_cast<double>(random() % 1000);
  const Vector strong = operators.laplacian() * u,
               integrated = operators.vertex_areas().cwiseProduct(strong) + weak * u;
  BOOST_TEST(largest(integrated) < 1e-10 * largest(weak * u));
  BOOST_TEST(u.dot(weak * u) > 0);
}

// -div grad u = density with u given at the border: the largest error against the solution.
double poisson_error(const Mesh& mesh, const Triangulation& triangulation, const Function& solution,
                     const Function& density)
{
  const FG::Dirichlet_problem<Operators> problem(Operators(triangulation), border_vertices(mesh));
  const Vector expected = sampled(mesh, solution);
  return largest(problem.solve(sampled(mesh, density), expected) - expected);
}

Mesh unit_square(int n) { return to_mesh<Mesh>(scaled(flat_grid(n, n, Diagonal_rule::RISING), 1.0 / n)); }

} // namespace

BOOST_AUTO_TEST_CASE(operators_satisfy_their_identities_whatever_is_flipped)
{
  for(const Mesh_soup& soup :
      {bumpy_sphere(8, 0.2, 1), torus(12, 8, 3, 1), jittered_grid(9, 7, Diagonal_rule::RISING, 0.2, 5),
       disjoint_union(cube(2), cone(9, 3, 1, 2))})
  {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation triangulation(mesh);
    check_identities(mesh, triangulation);
    flip_at_random(triangulation, 40, 7);
    BOOST_TEST(triangulation.log_position() > 0);
    check_identities(mesh, triangulation);
  }
}

// At a sharp apex, edges are flipped until one is a loop about it: then a face has a vertex at two of its corners.
BOOST_AUTO_TEST_CASE(faces_that_are_glued_to_themselves)
{
  const Mesh mesh = to_mesh<Mesh>(cone(5, 2, 0.2, 2));
  Triangulation triangulation(mesh);
  for(int round = 0; round < 10; ++round)
    for(FG::Halfedge_index h : FG::internal::descriptors<FG::Halfedge_index>(triangulation.number_of_halfedges()))
      if(triangulation.tail(h) == 0_v && !triangulation.is_border(h) && triangulation.is_flippable(h))
        triangulation.flip(h);
  int loops = 0;
  for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(triangulation.number_of_edges()))
    loops += triangulation.tail(e.halfedge()) == triangulation.head(e.halfedge()) ? 1 : 0;
  BOOST_TEST(loops > 0);
  check_identities(mesh, triangulation);
}

BOOST_AUTO_TEST_CASE(linear_functions_in_the_plane_are_differentiated_exactly)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(8, 8, Diagonal_rule::RISING, 0.2, 2));
  Triangulation triangulation(mesh);
  flip_at_random(triangulation, 60, 1);
  const Operators operators(triangulation);
  const Vector u = sampled(mesh, [](const Point& p) { return 3 * p.x() - 2 * p.y() + 7; });
  const Vector g = operators.gradient() * u;
  for(std::size_t f = 0; f < operators.faces().size(); ++f) {
    const FG::Intrinsic_face& face = operators.faces()[f];
    const Point p = mesh.point(triangulation.vertex(face.vertices[0]));
    const Point q = mesh.point(triangulation.vertex(face.vertices[1]));
    // In a plane an intrinsic edge is straight in space, so that the frame is known.
    const double x = (q.x() - p.x()) / face.lengths[0], y = (q.y() - p.y()) / face.lengths[0];
    const double a = g[static_cast<Eigen::Index>(2 * f)], b = g[static_cast<Eigen::Index>(2 * f + 1)];
    BOOST_TEST(std::hypot(a * x - b * y - 3, a * y + b * x + 2) < 1e-9);
  }
  const Vector weak = operators.weak_laplacian() * u;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(!mesh.is_border(v))
      BOOST_TEST(std::abs(weak[static_cast<Eigen::Index>(v)]) < 1e-9);
}

BOOST_AUTO_TEST_CASE(poisson_problems_in_the_plane_converge_with_the_square_of_the_edge_length)
{
  const Function solution = [](const Point& p) { return std::sin(pi * p.x()) * std::exp(p.y()); };
  const Function density = [&](const Point& p) { return (pi * pi - 1) * solution(p); };
  double previous = 0;
  for(int n : {8, 16, 32}) {
    const Mesh mesh = unit_square(n);
    const double error = poisson_error(mesh, Triangulation(mesh), solution, density);
    if(previous > 0)
      BOOST_TEST(error < previous / 3.5);
    previous = error;
  }
  BOOST_TEST(previous < 2e-3);
}

BOOST_AUTO_TEST_CASE(linear_functions_solve_their_poisson_problem_exactly_on_any_triangulation)
{
  const Mesh mesh = unit_square(12);
  Triangulation triangulation(mesh);
  flip_at_random(triangulation, 200, 4);
  const Function linear = [](const Point& p) { return 2 * p.x() - 5 * p.y() + 1; };
  BOOST_TEST(poisson_error(mesh, triangulation, linear, [](const Point&) { return 0.0; }) < 1e-11);
}

BOOST_AUTO_TEST_CASE(coordinates_are_eigenfunctions_of_the_sphere)
{
  const Mesh mesh = to_mesh<Mesh>(sphere(24));
  const Operators operators{Triangulation(mesh)};
  const Vector z = sampled(mesh, [](const Point& p) { return p.z(); });
  const double eigenvalue = z.dot(operators.weak_laplacian() * z) / z.dot(operators.consistent_mass() * z);
  BOOST_TEST(std::abs(eigenvalue - 2) < 0.01);
}

BOOST_AUTO_TEST_CASE(problems_without_a_solution_and_bad_input_are_refused)
{
  const Mesh two = to_mesh<Mesh>(with_isolated_vertices(disjoint_union(sphere(2), sphere(2)), 0, 1));
  const Triangulation triangulation(two);
  const Operators operators(triangulation);
  using Problem = FG::Dirichlet_problem<Operators>;
  BOOST_CHECK_THROW(Problem(operators, {0_v}), FG::Singular_problem_error);
  BOOST_CHECK_EXCEPTION(
      Problem(operators, {FG::Vertex_index(triangulation.number_of_vertices() - 2)}), FG::Singular_problem_error,
      [](const std::exception& e) { return std::string(e.what()).find("of vertex 0,") != std::string::npos; });
  BOOST_CHECK_THROW(Problem(operators, {0_v, FG::null_index}), FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(Problem(operators, {0_v, 1000_v}), FG::Vertex_out_of_range_error);

  const FG::Index last = triangulation.number_of_vertices() - 1, other = last - 1;
  const Problem problem(operators, {0_v, FG::Vertex_index(other)});
  Vector values = Vector::Constant(triangulation.number_of_vertices(), 4.0);
  const Vector solution = problem.solve(Vector(), values);
  for(FG::Index v = 0; v < last; ++v)
    BOOST_TEST(std::abs(solution[v] - 4) < 1e-12);
  BOOST_TEST(std::isnan(solution[last]));
  Vector density = Vector::Zero(triangulation.number_of_vertices());
  density[1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(problem.solve(density, values), FG::Invalid_coordinate_error);
  values[other] = std::numeric_limits<double>::infinity();
  BOOST_CHECK_THROW(problem.solve(Vector(), values), FG::Invalid_coordinate_error);

  std::vector<FG::Vertex_index> all; // nothing is left to be solved
  for(FG::Index v = 0; v < triangulation.number_of_vertices(); ++v)
    all.push_back(FG::Vertex_index(v));
  values = Vector::LinSpaced(triangulation.number_of_vertices(), 0, 1);
  BOOST_TEST((Problem(operators, all).solve(Vector(), values) == values));
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(triangulation, std::back_inserter(faces));
  BOOST_TEST(
      (FG::Tangent_spaces<Triangulation>(triangulation, faces).reference(FG::Vertex_index(last)) == FG::null_index));

  Mesh_soup flat = flat_grid(2, 2, Diagonal_rule::RISING);
  flat.points[4] = flat.points[0]; // may be refused by the metric or for its area
  BOOST_CHECK_THROW(Operators{Triangulation(to_mesh<Mesh>(flat))}, FG::Degenerate_face_error);
}

// The halfedge that `outgoing()` returns depends on which face was accessed first.
BOOST_AUTO_TEST_CASE(directions_do_not_depend_on_earlier_queries)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(4, 4, Diagonal_rule::RANDOM, 0.2, 3));
  const Triangulation forward(mesh), backward(mesh);
  for(FG::Index h = backward.number_of_halfedges() - 1; h >= 0; --h)
    backward.is_border(FG::Halfedge_index(h)); // copies the face
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(forward, std::back_inserter(faces));
  const FG::Tangent_spaces<Triangulation> spaces(forward, faces), other_spaces(backward, faces);
  FG::Index differing = 0;
  for(FG::Index v = 0; v < forward.number_of_vertices(); ++v) {
    differing += forward.outgoing(FG::Vertex_index(v)) == backward.outgoing(FG::Vertex_index(v)) ? 0 : 1;
    BOOST_TEST((spaces.reference(FG::Vertex_index(v)) == other_spaces.reference(FG::Vertex_index(v))));
  }
  BOOST_TEST(differing > 0);
  for(FG::Index h = 0; h < forward.number_of_halfedges(); ++h)
    BOOST_TEST(spaces.angle(FG::Halfedge_index(h)) == other_spaces.angle(FG::Halfedge_index(h)));
}

BOOST_AUTO_TEST_CASE(one_value_determines_a_solution_on_a_connected_surface)
{
  const Mesh mesh = to_mesh<Mesh>(single_triangle());
  const Operators operators{Triangulation(mesh)};
  for(FG::Vertex_index given : {0_v, 1_v, 2_v}) {
    Vector values = Vector::Zero(3);
    values[given.idx()] = 7;
    const Vector solution = FG::Dirichlet_problem<Operators>(operators, {given}).solve(Vector(), values);
    BOOST_TEST(largest(solution - Vector::Constant(3, 7)) < 1e-12);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(parallel_assembly_gives_the_same_bits)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(20, 0.2, 1));
  const Triangulation triangulation(mesh);
  const Operators sequential(triangulation);
  const FG::Operators<Triangulation, CGAL::Parallel_tag> parallel(triangulation);
  BOOST_TEST(Operators::Matrix(sequential.weak_laplacian() - parallel.weak_laplacian()).norm() == 0);
  BOOST_TEST(Operators::Matrix(sequential.gradient() - parallel.gradient()).norm() == 0);
}
#endif

namespace {

// What all solvers say of a bent square with a cut of two edges from its border, but for where angles start, which is
// the model's choice.
template <class Archetype, template <class> class Window>
std::vector<double> solutions(const Mesh& mesh)
{
  Archetype triangulation(mesh);
  FG::Edge_path_network<Archetype> network(triangulation);
  network.add_curve(FG::halfedges_through(triangulation, std::vector<FG::Vertex_index>{3_v, 10_v, 17_v}));
  for(int round = 0; round < 20; ++round)
    for(FG::Halfedge_index g : FG::internal::descriptors<FG::Halfedge_index>(triangulation.number_of_halfedges()))
      if(triangulation.holds(Archetype::edge(g)) == 0 && !triangulation.is_locally_delaunay(g) &&
         triangulation.is_flippable(g))
        triangulation.flip(g);
  BOOST_TEST(triangulation.log_position() >= 3u);
  const Window<FG::Edge_path_network<Archetype>> window(network);

  const FG::Operators<Archetype> operators(triangulation);
  const auto n = static_cast<Eigen::Index>(operators.number_of_vertices());
  const FG::Dirichlet_problem<FG::Operators<Archetype>> problem(operators, {3_v, 7_v});
  const Vector solution = problem.solve(Vector(), Vector::LinSpaced(n, 0, 1));
  std::vector<double> result(solution.data(), solution.data() + n);
  FG::Direction_field<Archetype> field(triangulation, 4);
  field.align(window);
  field.compute();
  const FG::Conformal_flattening<Archetype> flattening(window);
  for(FG::Halfedge_index g : FG::internal::descriptors<FG::Halfedge_index>(triangulation.number_of_halfedges())) {
    result.push_back(std::cos(4 * (field.angle(triangulation.tail(g)) - field.tangent_spaces().angle(g))));
    if(!triangulation.is_border(g))
      result.push_back(flattening.log_scale(flattening.copy_at(g)));
  }
  return result;
}

// The scale factors of a cone, by a model of `IntrinsicTriangulationOfMesh`.
template <class Model>
std::vector<double> scales_of_cone()
{
  const Mesh mesh = to_mesh<Mesh>(cone(3, 2, 1, 4));
  Model triangulation(mesh);
  FG::Edge_path_network<Model> network(triangulation);
  const FG::Conformal_flattening<Model> flattening = FG::refine_and_flatten(network);
  std::vector<double> result;
  for(FG::Index copy = 0; copy < flattening.number_of_copies(); ++copy)
    result.push_back(flattening.log_scale(FG::Vertex_copy_index(copy)));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(refinement_for_a_flattening_needs_no_more_than_the_concept)
{
  BOOST_TEST(scales_of_cone<Triangulation_of_mesh_archetype<Triangulation>>() == scales_of_cone<Triangulation>());
}

// Models that have nothing but what the pages of the concepts say.
BOOST_AUTO_TEST_CASE(no_mesh_is_needed)
{
  const Mesh mesh = to_mesh<Mesh>(mapped(jittered_grid(6, 5, Diagonal_rule::RANDOM, 0.2, 2), [](const Coordinates& p) {
    return Coordinates{p[0], p[1], 0.4 * std::sin(1.3 * p[0] + p[1])};
  }));
  const std::vector<double> expected = solutions<Triangulation, Edge_path_graph_archetype>(mesh);
  const std::vector<double> plain =
      solutions<Plain_triangulation<Triangulation::Traits>, Curve_network_archetype>(mesh);
  BOOST_REQUIRE_EQUAL(plain.size(), expected.size());
  for(std::size_t i = 0; i < plain.size(); ++i)
    BOOST_TEST(std::abs(plain[i] - expected[i]) < 1e-8);
}

// Its lengths say that the triangle has no area, though its points do not.
BOOST_AUTO_TEST_CASE(faces_without_area_are_refused)
{
  const Mesh mesh =
      to_mesh<Mesh>(Mesh_soup{{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-20, 0}, {0.5, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}});
  const Triangulation triangulation(mesh);
  BOOST_CHECK_THROW(Operators{triangulation}, FG::Degenerate_face_error);
}

#else

BOOST_AUTO_TEST_CASE(operators_need_eigen)
{
  BOOST_TEST_MESSAGE("SKIPPED: Eigen is not installed");
  BOOST_TEST(!Flip_geodesics_test::sphere(2).points.empty());
}

#endif // CGAL_EIGEN3_ENABLED
