// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Calls with a stop predicate what the compiled library has without one, or without the header for points in space.

#include <CGAL/Flip_geodesics/geodesic_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

#ifdef BETWEEN_POINTS
void connect(const Mesh& mesh, const Mesh::Point& from, const Mesh::Point& to, std::vector<Mesh::Point>& path)
{
  CGAL::Flip_geodesics::geodesic_path(mesh, from, to, std::back_inserter(path));
}
#else
void shorten_by_three_steps(const Mesh& mesh, std::vector<Mesh::Point>& path)
{
  CGAL::Flip_geodesics::geodesic_path(
      mesh, Mesh::Vertex_index(0), Mesh::Vertex_index(1), std::back_inserter(path),
      CGAL::parameters::stop_predicate(CGAL::Flip_geodesics::Iteration_stop_predicate(3)));
}
#endif
