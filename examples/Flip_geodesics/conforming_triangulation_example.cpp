// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Writes a triangulation of the surface in which a geodesic runs along edges, as triples of vertices with edge lengths.
// Finite-element programs can use it to cut the surface, or to impose constraints, along the curve.
//
//   conforming_triangulation_example MESH
//
// Writes conforming_triangulation.txt.

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <vector>

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
  const FG::Curve_index curve = network.add_curve(search(source, target));
  FG::shorten(network);
  //! [Faces]
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(triangulation, std::back_inserter(faces));
  //! [Faces]

  std::ofstream out("conforming_triangulation.txt");
  out.precision(17);
  for(const FG::Intrinsic_face& f : faces)
    out << f.vertices[0].idx() << ' ' << f.vertices[1].idx() << ' ' << f.vertices[2].idx() << ' ' << f.lengths[0] << ' '
        << f.lengths[1] << ' ' << f.lengths[2] << '\n';
  std::cout << faces.size() << " faces; the geodesic runs along " << network.halfedges(curve).size()
            << " of their edges.\n";
  return out.flush() && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
