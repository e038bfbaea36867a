// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECK_TRIANGLE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECK_TRIANGLE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>

#include <boost/config.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Names the vertices of the face on the left of h, the first of them if there are many. */
template <class Input_mesh>
[[noreturn]] BOOST_NOINLINE void throw_no_triangle(const Input_mesh& input, Input_halfedge_index h)
{
  constexpr std::size_t most_vertices = 8;
  std::string names;
  std::vector<std::size_t> vertices;
  Input_halfedge_index side = h;
  do {
    vertices.push_back(static_cast<std::size_t>(input.tail(side).idx()));
    names += (names.empty() ? "" : ", ") + std::to_string(vertices.back());
    side = input.next(side);
  } while(side != h && vertices.size() < most_vertices);
  throw Invalid_mesh_error("the face with vertices " + names + (side == h ? "" : ", ...") + " is not a triangle",
                           vertices);
}

/*
 * Throws Invalid_mesh_error unless the face on the left of input halfedge h is a triangle. Whatever enters a face of the
 * input through its own links, and not through those of a triangulation, has to ask: a walk round the corners of
 * another polygon, as if there were three, need not end.
 */
template <class Input_mesh>
void check_triangle(const Input_mesh& input, Input_halfedge_index h)
{
  if(!input.is_triangle(h))
    throw_no_triangle(input, h);
}

/* Throws Invalid_mesh_error unless the edge of a halfedge that has no face on its left has one on its right. */
template <class Input_mesh>
void check_has_face(const Input_mesh& input, Input_halfedge_index h)
{
  const Input_halfedge_index t = twin_index(h);
  if(!input.is_border(t))
    return;
  const Vertex_index v = input.tail(h), w = input.tail(t);
  throw Invalid_mesh_error("the edge between vertices " + std::to_string(v.idx()) + " and " + std::to_string(w.idx()) +
                               " is in no face",
                           {static_cast<std::size_t>(v.idx()), static_cast<std::size_t>(w.idx())});
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECK_TRIANGLE_H
