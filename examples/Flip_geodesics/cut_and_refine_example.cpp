// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Cuts a mesh open along a geodesic. Then refines the triangulation that contains the geodesic as edges, and computes
// the common subdivision of this triangulation and the mesh.
//
//   cut_and_refine_example MESH
//
// Writes cut.vtp and subdivision.vtp.

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");

  Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  Network network(triangulation);
  const FG::Vertex_index source(0), target(triangulation.number_of_vertices() / 2);
  network.add_curve(search(source, target));
  FG::shorten(network);

  //! [Cut]
  const auto cut = FG::cut_along_curves(network, mesh);
  //! [Cut]
  std::size_t on_cut = 0;
  for(const auto e : cut.mesh().edges())
    on_cut += get(cut.edge_is_constrained_map(), e) ? 1 : 0;
  std::cout << "Cut open: " << cut.mesh().number_of_faces() << " faces, " << on_cut << " border edges at the cut.\n";
  FG::IO::write_VTP("cut.vtp", cut.mesh());

  //! [Refine]
  FG::Refinement_options options;
  options.smallest_angle = 25;
  const FG::Refinement_report report = FG::refine(network, options);
  //! [Refine]
  std::cout << "Refined: " << report.insertions + report.splits << " new vertices, smallest angle "
            << report.smallest_angle << " degrees.\n";

  //! [Subdivision]
  const auto subdivision = FG::common_subdivision(triangulation, mesh);
  //! [Subdivision]
  std::cout << "Common subdivision: " << subdivision.mesh().number_of_faces() << " faces.\n";
  FG::IO::write_VTP("subdivision.vtp", subdivision.mesh());
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
