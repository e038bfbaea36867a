// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a triangulation that has geodesics as edges saves [SC20, section 6.6, Figure 29]. Paths from one vertex are
// pulled tight; then, with an angle bound,
//
//   flipped    the intrinsic triangulation of the mesh that contains them is refined
//   sliced     the mesh is cut along them into smaller faces, with a vertex wherever they cross an edge, and the
//              intrinsic triangulation of that is refined
//
// A row of CSV for each: vertices and smallest angle of the constrained Delaunay triangulation and refined, the time to
// solve a Poisson problem that is zero on the paths, and, on the square that is made without a mesh, the largest error
// of a known solution.
//
//   compare_slicing [--paths N] [--angle DEGREES] [MESH...]

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Operators.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <CLI/CLI.hpp>
#include <Eigen/Core>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Operators = FG::Operators<Triangulation>;

constexpr double pi = 3.14159265358979323846;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double smallest_angle(const Triangulation& triangulation)
{
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(triangulation, std::back_inserter(faces));
  double result = pi;
  for(const FG::Intrinsic_face& face : faces)
    for(int i = 0; i < 3; ++i)
      result = std::min(result, FG::internal::Plane_triangle(face.lengths).angle(i));
  return result * 180 / pi;
}

// The unit square, shaken: vertices (i, j) / n.
Mesh shaken_square(int n)
{
  std::mt19937 random(1);
  Mesh mesh;
  const auto shake = [&](int i) {
    return i == 0 || i == n ? 0.0 : 0.35 * (static_cast<double>(random()) / 4294967295.0 - 0.5);
  };
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      mesh.add_vertex(Kernel::Point_3((i + shake(i)) / n, (j + shake(j)) / n, 0));
  const auto vertex = [n](int i, int j) { return Mesh::Vertex_index(static_cast<unsigned>(i + j * (n + 1))); };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

double solution(const Kernel::Point_3& p) { return std::sin(3 * p.x()) * std::exp(2 * p.y()); }
double density(const Kernel::Point_3& p) { return 5 * solution(p); } // less its Laplacian

// The point in space of a vertex, which may be inserted.
Kernel::Point_3 point(const Triangulation& triangulation, FG::Vertex_index v)
{
  const FG::Surface_location location = triangulation.location(v);
  FG::Input_halfedge_index h = location.halfedge;
  double sum = 0, x = 0, y = 0, z = 0;
  for(double weight : location.weights) {
    const Kernel::Point_3 p = triangulation.metric().point(triangulation.input(), triangulation.input().tail(h));
    x += weight * p.x();
    y += weight * p.y();
    z += weight * p.z();
    sum += weight;
    h = triangulation.input().next(h);
  }
  return {x / sum, y / sum, z / sum};
}

std::vector<FG::Vertex_index> given_vertices(const Network& network, bool has_border)
{
  const Triangulation& triangulation = network.triangulation();
  std::vector<FG::Vertex_index> result;
  for(FG::Halfedge_index h : halfedges(triangulation))
    if(network.is_occupied(h) || (has_border && triangulation.is_border(h)))
      result.push_back(triangulation.tail(h));
  return result;
}

void report(const std::string& mesh, const std::string& way, Network& network, double angle, bool is_square)
{
  Triangulation& triangulation = network.triangulation();
  const FG::Index vertices = triangulation.number_of_vertices();
  FG::flip_to_delaunay(triangulation);
  const double before = smallest_angle(triangulation);
  FG::Refinement_options options;
  options.smallest_angle = angle;
  const double start = seconds();
  const FG::Refinement_report refinement = FG::refine(network, options);
  const double refined = seconds();
  const Operators operators(triangulation);
  const FG::Dirichlet_problem<Operators> problem(operators, given_vertices(network, is_square));
  const Eigen::Index n = triangulation.number_of_vertices();
  Eigen::VectorXd load = Eigen::VectorXd::Ones(n), values = Eigen::VectorXd::Zero(n);
  if(is_square)
    for(FG::Vertex_index v : FG::vertices(triangulation)) {
      load[v.idx()] = density(point(triangulation, v));
      values[v.idx()] = solution(point(triangulation, v));
    }
  const Eigen::VectorXd u = problem.solve(load, values);
  const double solved = seconds();
  std::cout << mesh << ',' << way << ',' << vertices << ',' << before << ',' << n << ',' << refinement.smallest_angle
            << ',' << refinement.smallest_free_angle << ',' << refinement.missed << ',' << 1e3 * (refined - start)
            << ',' << 1e3 * (solved - refined) << ',';
  if(is_square)
    std::cout << (u - values).lpNorm<Eigen::Infinity>();
  std::cout << '\n';
}

void compare(const std::string& name, const Mesh& mesh, int paths, double angle, bool is_square)
{
  Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  Network network(triangulation);
  std::mt19937 random(1);
  const unsigned n = static_cast<unsigned>(mesh.number_of_vertices());
  const FG::Vertex_index source(static_cast<FG::Index>(random() % n));
  for(int i = 0; i < paths; ++i) {
    const FG::Vertex_index target(static_cast<FG::Index>(random() % n));
    if(target != source)
      network.add_curve(search(source, target));
  }
  FG::order_overlapping_curves(network);
  FG::shorten(network);

  const auto sliced = FG::insert_curves(network, mesh);
  report(name, "flipped", network, angle, is_square);
  Triangulation sliced_triangulation(sliced.mesh());
  Network sliced_network(sliced_triangulation);
  FG::add_marked_edges(sliced_network, sliced.mesh(), sliced.edge_is_constrained_map());
  report(name, "sliced", sliced_network, angle, is_square);
}

} // namespace

int main(int argc, char** argv)
{
  int paths = 6;
  double angle = 25;
  std::vector<std::string> files;
  CLI::App app("Compares triangulations that contain geodesics with meshes sliced along them.");
  app.add_option("--paths", paths, "paths on each mesh")->check(CLI::PositiveNumber);
  app.add_option("--angle", angle, "the angle bound in degrees")->check(CLI::Range(0, 30));
  app.add_option("meshes", files, "triangle meshes; without any, shaken squares");
  CLI11_PARSE(app, argc, argv);

  std::cout << "mesh,way,vertices,smallest_angle,refined_vertices,refined_smallest_angle,refined_smallest_free_angle,"
               "missed,refine_ms,solve_ms,largest_error\n";
  int failures = 0;
  if(files.empty())
    for(int n : {20, 40, 80, 160})
      compare("square:" + std::to_string(n), shaken_square(n), paths, angle, true);
  for(const std::string& file : files)
    try {
      Mesh mesh;
      if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
        throw FG::Invalid_mesh_error("not a triangle mesh");
      compare(file, mesh, paths, angle, false);
    } catch(const std::exception& error) {
      std::cerr << file << ": " << error.what() << '\n';
      ++failures;
    }
  return failures == 0 && std::cout.flush() ? 0 : 1;
}
