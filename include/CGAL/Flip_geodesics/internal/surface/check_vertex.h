// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECK_VERTEX_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECK_VERTEX_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A descriptor of no vertex of the mesh has the index `null_index`, which is not named. */
[[noreturn]] inline void throw_vertex_out_of_range(Vertex_index v, Index number_of_vertices, const std::string& place,
                                                   const std::vector<std::size_t>& elements)
{
  const std::string vertex = v == null_index ? "a given vertex" : "vertex " + std::to_string(v.idx());
  throw Vertex_out_of_range_error(
      vertex + place + " is not one of the " + std::to_string(number_of_vertices) + " vertices", elements);
}

inline bool is_vertex(Vertex_index v, Index number_of_vertices) { return v.is_valid() && v.idx() < number_of_vertices; }

/* Throws Vertex_out_of_range_error unless `v` is one of so many vertices. */
inline void check_vertex(Vertex_index v, Index number_of_vertices)
{
  if(!is_vertex(v, number_of_vertices))
    throw_vertex_out_of_range(v, number_of_vertices, "",
                              v.is_valid() ? std::vector<std::size_t>(1, static_cast<std::size_t>(v.idx()))
                                           : std::vector<std::size_t>());
}

/* The same for a vertex of a curve. */
inline void check_vertex(Vertex_index v, Index number_of_vertices, std::size_t position)
{
  if(!is_vertex(v, number_of_vertices))
    throw_vertex_out_of_range(v, number_of_vertices, " at position " + std::to_string(position) + " of a curve",
                              {position});
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECK_VERTEX_H
