// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_LOCATIONS_IN_FACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_LOCATIONS_IN_FACES_H

#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The input faces that a canonical location lies in, each by its smallest halfedge. */
template <class Input_mesh>
std::vector<Input_halfedge_index> faces_of_location(const Input_mesh& input, const Surface_location& location)
{
  std::vector<Input_halfedge_index> result;
  const auto add = [&](Input_halfedge_index h) {
    if(input.is_border(h))
      return;
    check_triangle(input, h);
    result.push_back((std::min)({h, input.next(h), input.next(input.next(h))}));
  };
  if(kind(location) != Location_kind::VERTEX) {
    add(location.halfedge);
    if(kind(location) == Location_kind::EDGE)
      add(twin_index(location.halfedge));
    return result;
  }
  const Vertex_index v = input.tail(location.halfedge);
  Input_halfedge_index h = input.outgoing(v);
  const Input_halfedge_index first = h;
  do {
    add(h);
    h = input.next(twin_index(h)); // along the border, too
  } while(h != first);
  return result;
}

/* An input face that two canonical locations lie in; null_index if there is none. */
template <class Input_mesh>
Input_halfedge_index common_face(const Input_mesh& input, const Surface_location& p, const Surface_location& q)
{
  const std::vector<Input_halfedge_index> faces = faces_of_location(input, p);
  for(Input_halfedge_index f : faces_of_location(input, q))
    if(std::find(faces.begin(), faces.end(), f) != faces.end())
      return f;
  return null_index;
}

/* The input vertex with the largest weight. */
template <class Input_mesh>
Vertex_index nearest_vertex(const Input_mesh& input, const Surface_location& p)
{
  const auto nearest = (std::max_element)(p.weights.begin(), p.weights.end()) - p.weights.begin();
  const Input_halfedge_index h = p.halfedge, hn = input.next(h);
  return input.tail(nearest == 0 ? h : (nearest == 1 ? hn : input.next(hn)));
}

} // namespace internal

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_LOCATIONS_IN_FACES_H
