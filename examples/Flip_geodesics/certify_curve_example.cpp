// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes the shortest path between points inside two faces of a mesh by another package of CGAL, and proves that this
// path is locally shortest.
//
//   certify_curve_example MESH

#include <CGAL/Flip_geodesics/certify_curve.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <utility>
#include <variant>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Search = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;
using Crossing = std::pair<Mesh::Halfedge_index, double>;

// The points of the path: vertices, points on edges and, as the ends of the path, points in faces.
struct Places
{
  void operator()(Mesh::Vertex_index v) { path.push_back(v); }
  void operator()(Mesh::Halfedge_index h, double place) { path.push_back(Crossing(h, place)); }
  void operator()(Mesh::Face_index f, const std::array<double, 3>& weights) { path.push_back(std::pair(f, weights)); }

  std::vector<FG::Given_place<Mesh>> path;
};

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc != 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || mesh.is_empty() || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "usage: certify_curve_example MESH, a triangle mesh\n";
    return EXIT_FAILURE;
  }
  const std::array<double, 3> weights = {0.5, 0.25, 0.25};
  Search search(mesh);
  search.add_source_point(*mesh.faces().begin(), weights);
  Places places;
  search.shortest_path_sequence_to_source_points(Mesh::Face_index(mesh.number_of_faces() / 2), weights, places);

  //! [Certify]
  const auto certificate = FG::certify_curve(mesh, places.path);
  std::cout << "A path of " << places.path.size() << " points: " << FG::to_string(certificate.verdict());
  //! [Certify]
  if(!certificate.is_locally_shortest()) {
    std::cout << " at vertex " << certificate.vertex << ", with a bend of " << certificate.bend << " radians\n";
    return EXIT_FAILURE;
  }
  double farthest = 0; // the largest rounding error of the points on edges that the other package has computed
  for(std::size_t i = 1; i + 1 < places.path.size(); ++i)
    if(const Crossing* crossing = std::get_if<Crossing>(&places.path[i]))
      farthest = (std::max)(farthest, std::abs(crossing->second - certificate.places[i]));
  std::cout << "; points on edges are off by at most " << farthest << " of an edge length\n";
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
