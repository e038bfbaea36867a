// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_CUT_SURFACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_CUT_SURFACE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The surface of an intrinsic triangulation cut open along some edges, without modifying it: the corners around a
 * vertex form sectors between cut edges and the border, and each sector is a vertex of the cut surface, a *copy*.
 *
 * `is_cut(h)` returns whether the edge of halfedge h is cut.
 */
template <class Triangulation>
class Cut_surface
{
public:
  template <class Predicate>
  Cut_surface(const Triangulation& triangulation, const std::vector<Intrinsic_face>& faces, const Predicate& is_cut)
    : m_copy_at(static_cast<std::size_t>(triangulation.number_of_halfedges()), null_index)
  {
    for(const Intrinsic_face& face : faces)
      for(Halfedge_index h : face.halfedges)
        if(m_copy_at[h] == null_index)
          add_sector(triangulation, h, is_cut);
    count(triangulation, faces, is_cut);
  }

  Index number_of_copies() const { return static_cast<Index>(m_vertices.size()); }
  /* Returns the copy to which the corner at the tail of h belongs, in the face on the left of h. */
  Vertex_copy_index copy_at(Halfedge_index h) const { return m_copy_at[h]; }
  Vertex_index vertex(Vertex_copy_index copy) const { return m_vertices[copy]; }
  bool is_on_border(Vertex_copy_index copy) const { return m_is_on_border[copy] != 0; }
  /* Returns the Euler characteristic of the cut surface; among connected surfaces, only a disk has 1. */
  std::ptrdiff_t euler_characteristic() const { return m_euler_characteristic; }

private:
  template <class Predicate>
  void add_sector(const Triangulation& triangulation, Halfedge_index start, const Predicate& is_cut)
  {
    // Clockwise as far as possible, then back.
    Halfedge_index first = start;
    bool is_closed = false;
    while(!is_closed && !is_cut(first)) {
      const Halfedge_index h = triangulation.clockwise(first);
      if(h == null_index)
        break;
      first = h;
      is_closed = first == start;
    }
    const Vertex_copy_index copy(number_of_copies());
    m_vertices.push_back(triangulation.tail(start));
    m_is_on_border.push_back(is_closed ? 0 : 1);
    Halfedge_index h = first;
    do {
      m_copy_at[h] = copy;
      h = triangulation.counterclockwise(h);
    } while(h != first && !triangulation.is_border(h) && !is_cut(h));
  }

  template <class Predicate>
  void count(const Triangulation& triangulation, const std::vector<Intrinsic_face>& faces, const Predicate& is_cut)
  {
    std::ptrdiff_t edges = 0; // a cut or border edge counts once per side
    for(const Intrinsic_face& face : faces)
      for(Halfedge_index h : face.halfedges) {
        const bool is_shared = !triangulation.is_border(Triangulation::twin(h)) && !is_cut(h);
        edges += is_shared && !is_first_side(h) ? 0 : 1;
      }
    m_euler_characteristic =
        static_cast<std::ptrdiff_t>(m_vertices.size()) - edges + static_cast<std::ptrdiff_t>(faces.size());
  }

  Indexed_by<Halfedge_index, std::vector<Vertex_copy_index>> m_copy_at;
  Indexed_by<Vertex_copy_index, std::vector<Vertex_index>> m_vertices;
  Indexed_by<Vertex_copy_index, std::vector<char>> m_is_on_border;
  std::ptrdiff_t m_euler_characteristic = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_CUT_SURFACE_H
