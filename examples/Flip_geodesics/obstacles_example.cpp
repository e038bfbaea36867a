// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes shortest paths that pass around obstacles. The vertices near the middle of the shortest path between two
// vertices become an obstacle: first the faces around them, which are excluded, and then the edges between them, which
// paths must not cross.
//
//   obstacles_example MESH [SOURCE TARGET]
//
// Writes obstacles.vtp, the three paths.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/Slit_mesh.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/squared_distance_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh::size_type number(const std::string& text)
{
  std::istringstream in(text);
  Mesh::size_type result = 0;
  if(!(in >> result && in.eof()))
    throw std::invalid_argument(text + " is not a number");
  return result;
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  const Mesh::Vertex_index source(argc > 3 ? number(argv[2]) : 0);
  const Mesh::Vertex_index target(argc > 3 ? number(argv[3]) : mesh.number_of_vertices() / 2);

  std::vector<std::vector<Kernel::Point_3>> paths(3);
  const double length = FG::shortest_path(mesh, source, target, std::back_inserter(paths[0])).length();
  std::cout << "Without obstacles: " << length << '\n';
  if(paths[0].empty())
    throw std::invalid_argument("no path connects the two vertices");

  const auto is_near = [&, middle = paths[0][paths[0].size() / 2]](Mesh::Vertex_index v) {
    return v != source && v != target && CGAL::squared_distance(mesh.point(v), middle) < length * length / 64;
  };

  //! [Faces]
  std::vector<Mesh::Face_index> free_faces;
  for(Mesh::Face_index f : mesh.faces()) {
    const auto corners = CGAL::vertices_around_face(mesh.halfedge(f), mesh);
    if(std::none_of(corners.begin(), corners.end(), is_near))
      free_faces.push_back(f);
  }
  const CGAL::Face_filtered_graph<Mesh> free_mesh(mesh, free_faces);
  const auto around_faces = FG::shortest_path(free_mesh, source, target, std::back_inserter(paths[1]));
  //! [Faces]
  std::cout << "Around " << mesh.number_of_faces() - free_faces.size() << " faces: " << around_faces.length() << ", "
            << to_string(around_faces.verdict()) << '\n';

  //! [Edges]
  using Slit = FG::Slit_mesh<Mesh>;
  auto is_barrier = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_barrier", false).first;
  for(Mesh::Edge_index e : mesh.edges())
    is_barrier[e] = is_near(mesh.vertex(e, 0)) && is_near(mesh.vertex(e, 1));
  const Slit slit(mesh, is_barrier);
  const auto around_edges = FG::shortest_path(slit, source, target, std::back_inserter(paths[2]));

  std::map<Slit::Vertex, double> distances;
  FG::geodesic_distances(slit, Slit::Vertex(source), boost::make_assoc_property_map(distances));
  //! [Edges]
  std::cout << "Around barriers: " << around_edges.length() << ", " << to_string(around_edges.verdict())
            << "; by the distances of all vertices: " << distances[Slit::Vertex(target)] << '\n';
  FG::IO::write_VTP("obstacles.vtp", paths);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
