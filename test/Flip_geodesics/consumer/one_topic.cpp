// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Includes one header, which declares only what it has where the compiled library is linked.

#include <CGAL/Flip_geodesics/geodesic_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point_3(0, 0, 0), 1.0);
  std::vector<Point_3> path;
  const auto result = CGAL::Flip_geodesics::geodesic_path(mesh, Mesh::Vertex_index(0), Mesh::Vertex_index(11),
                                                          std::back_inserter(path));
  std::cout << "a geodesic of length " << result.length() << ", " << to_string(result.verdict()) << '\n';
  for(const Point_3& p : path)
    std::cout << p << '\n';

  const std::vector<Mesh::Vertex_index> around_a_face(
      vertices_around_face(mesh.halfedge(Mesh::Face_index(0)), mesh).begin(),
      vertices_around_face(mesh.halfedge(Mesh::Face_index(0)), mesh).end());
  std::vector<Location> loop;
  std::cout << to_string(CGAL::Flip_geodesics::geodesic_loop(mesh, around_a_face, std::back_inserter(loop)).status())
            << '\n';
  std::vector<std::vector<Point_3>> curves;
  CGAL::Flip_geodesics::geodesic_network(mesh, std::vector<std::vector<Mesh::Vertex_index>>(1, around_a_face),
                                         std::back_inserter(curves));
  std::cout << curves.size() << " curve with " << curves.front().size() << " points\n";
  return path.size() >= 2 && loop.empty() && curves.size() == 1 ? 0 : 1;
}
