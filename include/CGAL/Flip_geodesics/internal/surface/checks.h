// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECKS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECKS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/metric_faces.h>

#include <boost/config.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The message lists the vertices of the face on the left of h, the first of them if there are many. */
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
 * Throws Invalid_mesh_error unless the face on the left of input halfedge h is a triangle. Any code that enters a face
 * of the input through its own links, and not through those of a triangulation, must call this: traversing the corners
 * of another polygon as if there were three need not terminate.
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

/* A descriptor of no vertex of the mesh has the index `null_index`, which the message omits. */
[[noreturn]] inline void throw_vertex_out_of_range(Vertex_index v, Index number_of_vertices, const std::string& place,
                                                   const std::vector<std::size_t>& elements)
{
  const std::string vertex = v == null_index ? "a given vertex" : "vertex " + std::to_string(v.idx());
  throw Vertex_out_of_range_error(
      vertex + place + " is not one of the " + std::to_string(number_of_vertices) + " vertices", elements);
}

inline bool is_vertex(Vertex_index v, Index number_of_vertices) { return v.is_valid() && v.idx() < number_of_vertices; }

/* Throws Vertex_out_of_range_error unless `v` is less than the number of vertices. */
inline void check_vertex(Vertex_index v, Index number_of_vertices)
{
  if(!is_vertex(v, number_of_vertices))
    throw_vertex_out_of_range(v, number_of_vertices, "",
                              v.is_valid() ? std::vector<std::size_t>(1, static_cast<std::size_t>(v.idx()))
                                           : std::vector<std::size_t>());
}

/* Throws Vertex_out_of_range_error unless a vertex of a curve is less than the number of vertices. */
inline void check_vertex(Vertex_index v, Index number_of_vertices, std::size_t position)
{
  if(!is_vertex(v, number_of_vertices))
    throw_vertex_out_of_range(v, number_of_vertices, " at position " + std::to_string(position) + " of a curve",
                              {position});
}

/* Returns the vectors of the input face on the left of h, starting with h, in the numbers of some traits; the face must
 * be a triangle. */
template <class Triangulation, class Traits>
auto input_face_geometry(const Triangulation& triangulation, Input_halfedge_index h, const Traits& traits)
{
  check_triangle(triangulation.input(), h);
  return face_geometry(triangulation.metric(), triangulation.input(), h, traits);
}

/* Returns the vectors in doubles, with h on the positive real axis, of a face known to be a triangle. */
template <class Triangulation>
auto known_input_face_geometry(const Triangulation& triangulation, Input_halfedge_index h)
{
  using Double_traits = Intrinsic_triangulation_traits<typename Triangulation::Metric::Kernel, double>;
  return face_geometry(triangulation.metric(), triangulation.input(), h, Double_traits());
}

/* Returns the vectors in doubles of any face, which must be a triangle. */
template <class Triangulation>
auto input_face_geometry(const Triangulation& triangulation, Input_halfedge_index h)
{
  check_triangle(triangulation.input(), h);
  return known_input_face_geometry(triangulation, h);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECKS_H
