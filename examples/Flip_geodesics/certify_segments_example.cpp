// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Reads a triangle mesh, computes the shortest path between two of its vertices by another package, and proves that each
// segment of it is straight on the unfolded faces.
//
//   certify_segments_example MESH

#include <CGAL/Flip_geodesics/certify_segment.h>

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
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Search = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

// A new segment begins at each vertex that the path passes.
struct Segments
{
  void operator()(Mesh::Vertex_index v)
  {
    vertices.push_back(v);
    crossed.emplace_back();
    places.emplace_back();
  }

  void operator()(Mesh::Halfedge_index h, double place)
  {
    crossed.back().push_back(h);
    places.back().push_back(place);
  }

  void operator()(Mesh::Face_index, const std::array<double, 3>&) {} // not between vertices

  std::vector<Mesh::Vertex_index> vertices;
  std::vector<std::vector<Mesh::Halfedge_index>> crossed; // from each vertex to the next one
  std::vector<std::vector<double>> places;                // 0 at the source of the halfedge, 1 at its target
};

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc != 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || mesh.is_empty() || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "usage: certify_segments_example MESH, a triangle mesh\n";
    return EXIT_FAILURE;
  }
  Search search(mesh);
  search.add_source_point(*mesh.vertices().begin());
  Segments path;
  search.shortest_path_sequence_to_source_points(Mesh::Vertex_index(mesh.number_of_vertices() / 2), path);

  for(std::size_t i = 0; i + 1 < path.vertices.size(); ++i) {
    const FG::Segment_certificate certificate =
        FG::certify_segment(mesh, path.vertices[i], path.vertices[i + 1], path.crossed[i]);
    double farthest = 0;
    for(std::size_t k = 0; k < certificate.places.size(); ++k)
      farthest = (std::max)(farthest, std::abs(certificate.places[k] - path.places[i][k]));
    std::cout << "segment of " << path.crossed[i].size() << " crossings: " << FG::to_string(certificate.verdict)
              << ", bent by " << certificate.bend << " radians; places differ by " << farthest << " of an edge\n";
    if(!certificate.is_straight())
      return EXIT_FAILURE;
  }
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
