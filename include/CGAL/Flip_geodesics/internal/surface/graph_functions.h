// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_GRAPH_FUNCTIONS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_GRAPH_FUNCTIONS_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {

template <typename P>
class Surface_mesh;

namespace Flip_geodesics {
namespace internal {

/* The functions of the graph concepts, found by argument-dependent lookup; inside classes, members would hide them. */
template <class Descriptor, class TriangleMesh>
auto graph_halfedge(Descriptor d, const TriangleMesh& mesh)
{
  return halfedge(d, mesh);
}

template <class Descriptor, class TriangleMesh>
auto graph_next(Descriptor h, const TriangleMesh& mesh)
{
  return next(h, mesh);
}

template <class Descriptor, class TriangleMesh>
auto graph_face(Descriptor h, const TriangleMesh& mesh)
{
  return face(h, mesh);
}

/* Returns whether a descriptor is that of a face of the mesh; of most meshes, whether it is not null. */
template <class TriangleMesh>
bool is_face(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh&)
{
  return f != boost::graph_traits<TriangleMesh>::null_face();
}

template <class P>
bool is_face(typename Surface_mesh<P>::Face_index f, const Surface_mesh<P>& mesh)
{
  const std::size_t end = mesh.number_of_faces() + mesh.number_of_removed_faces();
  return static_cast<std::size_t>(f) < end && !mesh.is_removed(f);
}

/* Returns whether the face on the left of h closes and, if the twin's face is known, both sides agree in length and
 * vertices. */
template <class Triangulation>
bool is_valid_halfedge(const Triangulation& triangulation, Halfedge_index h, double tolerance, bool is_twin_known)
{
  const Halfedge_index t = Triangulation::twin(h), hn = triangulation.next(h), hp = triangulation.next(hn);
  if(triangulation.next(hp) != h || (is_twin_known && triangulation.tail(t) != triangulation.tail(hn)))
    return false;
  const double a = triangulation.length(h), b = triangulation.length(hn), c = triangulation.length(hp);
  const double scale = tolerance * (std::max)({a, b, c});
  if(a > b + c + scale)
    return false;
  return !is_twin_known || triangulation.is_border(t) || std::abs(a - triangulation.length(t)) <= scale;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_GRAPH_FUNCTIONS_H
