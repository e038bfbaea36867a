// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes texture coordinates by cutting a surface open and flattening it. The seam is a path through the given
// vertices, or a cut graph if no vertices are given. It is shortened first; a path remains fixed at its ends and
// wherever it passes through the first vertex. The triangulation is then refined, cut open along the seam and flattened
// conformally. The coordinates are carried to the common subdivision of the mesh and the triangulation.
//
//   flattening_example MESH [VERTEX VERTEX...]
//
// Writes flattening.obj, with texture coordinates.

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Conformal_flattening.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;

FG::Index number(const std::string& text)
{
  std::istringstream in(text);
  FG::Index result = 0;
  if(!(in >> result && in.eof()))
    throw std::invalid_argument(text + " is not a number");
  return result;
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || argc == 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) ||
     mesh.is_empty())
    throw std::invalid_argument(
        "specify the file of a triangle mesh, and either no vertices or at least two of a seam");
  if(std::error_code absent; std::filesystem::equivalent(argv[1], "flattening.obj", absent))
    throw std::invalid_argument("the result would replace the mesh; rename the file of the mesh");

  Triangulation triangulation(mesh);
  std::vector<FG::Vertex_index> way;
  for(int i = 2; i < argc; ++i)
    way.emplace_back(number(argv[i]));
  Network network(triangulation);
  if(way.empty()) {
    FG::add_cut_graph(network);
    FG::shorten_cut_graph(network);
  } else {
    FG::Shortest_edge_path<Triangulation> search(triangulation);
    network.add_curve(FG::shortest_halfedges_through(search, way));
    network.fix_nodes_at(way.front());
    FG::order_overlapping_curves(network);
    FG::shorten(network);
  }

  const FG::Conformal_flattening<Triangulation> flattening = FG::refine_and_flatten(network);
  auto subdivision = FG::common_subdivision(triangulation, mesh);
  Mesh& result = subdivision.mesh();
  auto texture_coordinates = result.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv", {}).first;
  flattening.carry_to(subdivision, texture_coordinates);
  std::cout << flattening.iterations() << " steps of Newton's method; angle sums are off by at most "
            << flattening.angle_error() << " radians, positions by at most " << flattening.layout_error()
            << " of the size of the layout.\n";

  std::ofstream out("flattening.obj");
  out.precision(17);
  for(Mesh::Vertex_index v : result.vertices())
    out << "v " << result.point(v) << '\n';
  std::size_t count = 0;
  for(Mesh::Face_index f : result.faces()) {
    std::string corners;
    for(Mesh::Halfedge_index h : result.halfedges_around_face(result.halfedge(f))) {
      out << "vt " << texture_coordinates[h] << '\n';
      corners += ' ' + std::to_string(result.target(h).idx() + 1) + '/' + std::to_string(++count);
    }
    out << 'f' << corners << '\n';
  }
  return out.flush() && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
