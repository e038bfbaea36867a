// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a user writes first: one include, one call.

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <vector>

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

int main()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(3, 0, 0), Point_3(0, 4, 0), Point_3(0, 0, 5), mesh);
  const Mesh::Vertex_index source(1);
  const Mesh::Vertex_index target(2);

  std::vector<Point_3> path;
  CGAL::Flip_geodesics::geodesic_path(mesh, source, target, std::back_inserter(path));

  // Any two vertices of a tetrahedron share an edge, and a straight edge is a geodesic.
  const double expected = std::sqrt(CGAL::squared_distance(mesh.point(source), mesh.point(target)));
  double length = 0;
  for(std::size_t i = 1; i < path.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(path[i - 1], path[i]));
  std::cout << "a geodesic of " << path.size() << " points and length " << length << '\n';

  const bool is_right = path.size() >= 2 && path.front() == mesh.point(source) && path.back() == mesh.point(target) &&
                        std::abs(length - expected) <= 1e-12 * expected;
  return is_right ? 0 : 1;
}
