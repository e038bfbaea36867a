// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A partial differential equation with its boundary on a curve: the temperature of a surface that is heated evenly and
// kept at zero along a geodesic path between two vertices, or along the geodesic Bezier curve of more vertices as
// control points. The curve is made of edges of the triangulation, so that the values on it are met exactly; the
// unknowns are the vertices of the mesh.
//
//   poisson_example [MESH VERTEX VERTEX...]
//
// Writes poisson.ply, the mesh with the property `u` at its vertices.

#include "kept_input.h"
#include "torus.h"

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Dirichlet_problem.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <Eigen/Core>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Operators = FG::Operators<Triangulation>;

namespace {

std::vector<FG::Vertex_index> vertices_on(const Network& network, FG::Curve_index curve)
{
  const Triangulation& triangulation = network.triangulation();
  std::vector<FG::Vertex_index> result;
  for(FG::Halfedge_index h : network.halfedges(curve)) {
    result.push_back(triangulation.tail(h));
    result.push_back(triangulation.head(h));
  }
  return result;
}

// Of the control points that the one curve of the network passes.
void draw_bezier_curve(Network& network, FG::Curve_index curve, const std::vector<FG::Vertex_index>& control_points)
{
  constexpr int rounds = 5;
  for(FG::Vertex_index v : control_points)
    network.fix_nodes_at(v);
  FG::order_overlapping_curves(network);
  FG::Geodesic_spline<Network> spline(network, curve);
  for(int round = 0; round < rounds; ++round)
    spline.refine();
}

} // namespace

int main(int argc, char** argv)
{
  Mesh mesh;
  const bool has_mesh = argc > 3 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : argc == 1 && make_torus(mesh) > 0;
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    std::cerr << "This is not a triangle mesh.\n";
    return EXIT_FAILURE;
  }
  if(!is_input_kept(argc, argv, {"poisson.ply"}))
    return EXIT_FAILURE;

  auto temperature = mesh.add_property_map<Mesh::Vertex_index, double>("v:u", 0).first;
  try {
    Triangulation triangulation(mesh);
    std::vector<FG::Vertex_index> vertices;
    for(int i = 2; i < argc; ++i)
      vertices.emplace_back(std::stoi(argv[i]));
    if(argc == 1)
      for(FG::Index v : {0, 1450, 2190, 2420}) // of the torus
        vertices.emplace_back(v);

    FG::Shortest_edge_path<Triangulation> search(triangulation);
    Network network(triangulation);
    const FG::Curve_index curve = network.add_curve(FG::shortest_halfedges_through(search, vertices), false);
    if(vertices.size() == 2)
      FG::shorten(network);
    else
      draw_bezier_curve(network, curve, vertices);
    FG::flip_to_delaunay(triangulation); // all edges but those of the curve

    const FG::Dirichlet_problem<Operators> problem(Operators(triangulation), vertices_on(network, curve));
    const Eigen::VectorXd heat = Eigen::VectorXd::Ones(triangulation.number_of_vertices());
    const Eigen::VectorXd u = problem.solve(heat, Eigen::VectorXd::Zero(triangulation.number_of_vertices()));
    for(Mesh::Vertex_index v : mesh.vertices())
      temperature[v] = u[triangulation.index(v).idx()];
    std::cout << "Kept at 0 at " << network.halfedges(curve).size() + 1 << " vertices on the curve; largest value "
              << u.maxCoeff() << ".\n";
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }

  std::ofstream out("poisson.ply");
  out.precision(17);
  return CGAL::IO::write_PLY(out, mesh) && out.flush() && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
