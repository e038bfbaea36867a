// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Texture coordinates by cutting and flattening. Two loops around a torus, fixed where they cross, or paths from a
// vertex of a sphere-like mesh to others, are straightened into smooth seams. The triangulation is refined, cut open
// along them and flattened conformally, and the coordinates are carried to the common subdivision of the mesh and the
// triangulation.
//
//   flattening_example [MESH VERTEX VERTEX...]
//
// Writes flattening.obj, with texture coordinates.

#include "kept_input.h"
#include "torus.h"

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Conformal_flattening.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <Eigen/Core>

#include <array>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Flattening = FG::Conformal_flattening<Triangulation>;
using Search = FG::Shortest_edge_path<Triangulation>;

namespace {

void write(std::ostream& out, const Mesh& mesh,
           const Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>& texture_coordinates)
{
  out.precision(17);
  for(Mesh::Vertex_index v : mesh.vertices())
    out << "v " << mesh.point(v) << '\n';
  std::size_t count = 0;
  for(Mesh::Face_index f : mesh.faces()) {
    std::string corners;
    for(Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      out << "vt " << texture_coordinates[h] << '\n';
      corners += ' ' + std::to_string(mesh.target(h).idx() + 1) + '/' + std::to_string(++count);
    }
    out << 'f' << corners << '\n';
  }
}

} // namespace

int main(int argc, char** argv)
{
  constexpr FG::Index around = 96, along = 48;
  Mesh mesh;
  const bool has_mesh =
      argc > 3 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : argc == 1 && make_torus(mesh, around, along) > 0;
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    std::cerr << "This is not a triangle mesh.\n";
    return EXIT_FAILURE;
  }
  if(!is_input_kept(argc, argv, {"flattening.obj"}))
    return EXIT_FAILURE;

  std::ofstream out("flattening.obj");
  try {
    Triangulation triangulation(mesh);
    Search search(triangulation);
    Network network(triangulation);
    for(int i = 3; i < argc; ++i) {
      const FG::Vertex_index source(std::stoi(argv[2])), target(std::stoi(argv[i]));
      network.add_curve(search(source, target), false);
    }
    if(argc == 1) {
      const FG::Vertex_index crossing(0);
      for(FG::Index step : {along / 3, around / 3 * along}) {
        const std::array<FG::Vertex_index, 3> way = {crossing, FG::Vertex_index(step), FG::Vertex_index(2 * step)};
        network.add_curve(FG::shortest_halfedges_through(search, way, true), true);
      }
      network.fix_nodes_at(crossing);
    }
    FG::order_overlapping_curves(network);
    FG::shorten(network);

    FG::Refinement_options options;
    options.smallest_angle = 20; // degrees
    const FG::Refinement_report refinement = FG::refine(network, options);

    const Flattening flattening(network);
    auto subdivision = FG::common_subdivision(triangulation, mesh);
    auto texture_coordinates =
        subdivision.mesh().add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv", {}).first;
    flattening.carry_to(subdivision, texture_coordinates);
    std::cout << refinement.insertions + refinement.splits << " vertices inserted, smallest angle "
              << refinement.smallest_angle << " degrees; " << flattening.iterations()
              << " steps of Newton's method; angle sums are off by " << flattening.angle_error() << ", positions by "
              << flattening.layout_error() << ".\n";
    write(out, subdivision.mesh(), texture_coordinates);
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return out.flush() && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
