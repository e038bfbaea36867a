// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_CHECK_VERTEX_H
#define CGAL_FLIP_GEODESICS_INTERNAL_CHECK_VERTEX_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A descriptor of no vertex of the mesh has the index `null_index`, which is not named. */
[[noreturn]] inline void throw_vertex_out_of_range(Index v, Index number_of_vertices, const std::string& place,
                                                   const std::vector<std::size_t>& elements)
{
  const std::string vertex = v == null_index ? "a given vertex" : "vertex " + std::to_string(v);
  throw Vertex_out_of_range_error(
      vertex + place + " is not one of the " + std::to_string(number_of_vertices) + " vertices", elements);
}

inline bool is_vertex(Index v, Index number_of_vertices) { return v >= 0 && v < number_of_vertices; }

/* Throws Vertex_out_of_range_error unless `v` is one of so many vertices. */
inline void check_vertex(Index v, Index number_of_vertices)
{
  if(!is_vertex(v, number_of_vertices))
    throw_vertex_out_of_range(v, number_of_vertices, "",
                              v < 0 ? std::vector<std::size_t>() : std::vector<std::size_t>(1, v));
}

/* The same for a vertex of a curve. */
inline void check_vertex(Index v, Index number_of_vertices, std::size_t position)
{
  if(!is_vertex(v, number_of_vertices))
    throw_vertex_out_of_range(v, number_of_vertices, " at position " + std::to_string(position) + " of a curve",
                              {position});
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_CHECK_VERTEX_H
