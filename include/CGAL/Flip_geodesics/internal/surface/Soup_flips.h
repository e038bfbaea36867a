// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_FLIPS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_FLIPS_H

#include <CGAL/Flip_geodesics/Repair_report.h>
#include <CGAL/Flip_geodesics/internal/surface/Soup_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Triangle_soup.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Removes triangles whose corners are collinear, which have their middle corner B on their longest edge AC. Where a
 * triangle ACD with area lies beyond that edge, a flip makes two triangles with area of both, and the surface stays as
 * it is:
 *
 *        D                 D
 *      /   \             / | \
 *     A-----C    ->     A--B--C
 *      \-B-/
 *
 * Where ACD is collinear too and AC its longest edge, a flip makes the sum of lengths smaller; if another one is, that
 * is looked at first, which is longer. So there is an end. What no flip can help is dropped: at a border the surface is
 * the same without it; elsewhere it leaves a slit.
 *
 * \pre the soup is an oriented manifold, which it may not be afterwards, and no triangle has two corners in one place
 */
template <class Kernel>
class Soup_flips
{
  using Soup = Triangle_soup<Kernel>;
  using Mesh = Soup_mesh<Kernel>;
  using Halfedge = typename Mesh::Halfedge_index;
  using Face = typename Mesh::Face_index;

public:
  Soup_flips(Soup& soup, Repair_record& record)
    : m_soup(soup)
    , m_record(record)
  {
  }

  /* Was anything changed? */
  bool operator()()
  {
    for(std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      if(m_soup.is_collinear(m_soup.triangles[t]))
        m_stack.emplace_back(static_cast<typename Mesh::size_type>(t));
    if(m_stack.empty())
      return false;
    m_mesh = make_soup_mesh(m_soup);
    m_is_dropped.assign(m_soup.triangles.size(), 0);
    m_flips_left = 100 * m_stack.size();
    while(!m_stack.empty()) {
      const Face f = m_stack.back();
      m_stack.pop_back();
      if(!is_done(f))
        remove(f);
    }
    for(char is_dropped : m_is_dropped)
      m_record.add(Repair::FACES_WITHOUT_AREA_DROPPED, is_dropped != 0 ? 1 : 0);
    m_soup.remove(m_is_dropped);
    return true;
  }

private:
  bool is_done(Face f) const { return m_is_dropped[f] != 0 || !m_soup.is_collinear(m_soup.triangles[f]); }

  void remove(Face f)
  {
    const Halfedge h = longest(f), o = m_mesh.opposite(h);
    if(m_mesh.is_border(o) || m_flips_left == 0)
      return drop(f);
    const Face g = m_mesh.face(o);
    if(m_is_dropped[g] != 0) // as good as a border
      return drop(f);
    if(!is_done(g) && longest(g) != o)
      m_stack.insert(m_stack.end(), {f, g});
    else
      flip_or_drop(f, h, g);
  }

  void drop(Face f) { m_is_dropped[f] = 1; }

  void flip_or_drop(Face f, Halfedge h, Face g)
  {
    const auto b = m_mesh.target(m_mesh.next(h)), d = m_mesh.target(m_mesh.next(m_mesh.opposite(h)));
    if(are_neighbors(b, d) || m_soup.place(b) == m_soup.place(d)) {
      drop(f);
      if(m_soup.is_collinear(m_soup.triangles[g]))
        drop(g);
      return;
    }
    if(!m_soup.is_collinear(m_soup.triangles[g]))
      m_record.add(Repair::FACES_WITHOUT_AREA_FLIPPED);
    Euler::flip_edge(h, m_mesh);
    --m_flips_left;
    m_soup.polygons[f] = m_soup.polygons[g];
    m_soup.is_reversed[f] = m_soup.is_reversed[g];
    for(const Face face : {f, g}) {
      m_soup.triangles[face] = corners(m_mesh, face);
      m_stack.push_back(face);
    }
  }

  // The halfedge of a collinear face opposite to the corner between the others.
  Halfedge longest(Face f) const
  {
    const auto is_ordered = Kernel().collinear_are_ordered_along_line_3_object();
    Halfedge h = m_mesh.halfedge(f);
    for(int i = 0; i < 2; ++i, h = m_mesh.next(h))
      if(is_ordered(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(m_mesh.next(h))),
                    m_mesh.point(m_mesh.target(h))))
        return h;
    return h;
  }

  // Linear in the smaller of the degrees.
  bool are_neighbors(typename Mesh::Vertex_index u, typename Mesh::Vertex_index v) const
  {
    Halfedge g = m_mesh.halfedge(u), h = m_mesh.halfedge(v);
    const Halfedge first_of_u = g, first_of_v = h;
    do {
      if(m_mesh.source(g) == v || m_mesh.source(h) == u)
        return true;
      g = m_mesh.opposite(m_mesh.next(g));
      h = m_mesh.opposite(m_mesh.next(h));
    } while(g != first_of_u && h != first_of_v);
    return false;
  }

  Soup& m_soup;
  Repair_record& m_record;
  Mesh m_mesh;
  std::vector<Face> m_stack;
  std::vector<char> m_is_dropped;
  std::size_t m_flips_left = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_FLIPS_H
