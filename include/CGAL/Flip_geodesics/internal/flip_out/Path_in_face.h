// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_IN_FACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_IN_FACE_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Triangulation_edge_policy.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Does an edge of a triangulation lie in the closed input face of a halfedge? */
template <class Triangulation>
bool is_edge_in_face(const Triangulation& triangulation, Halfedge_index h, Input_halfedge_index face)
{
  if(triangulation.crossings(Triangulation::edge(h)) > 0)
    return false;
  const auto& input = triangulation.input();
  const auto is_side = [&](Input_halfedge_index g) {
    return g == face || g == input.next(face) || input.next(g) == face;
  };
  const Crossing_word word = triangulation.crossing_word(h);
  return word.along == null_index ? is_side(word.face) : is_side(word.along) || is_side(twin_index(word.along));
}

/* Shortest paths along those edges of a triangulation that lie in one closed input face. */
template <class Triangulation>
class Path_in_face
{
public:
  explicit Path_in_face(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_search(static_cast<std::size_t>(triangulation.number_of_vertices()))
  {
  }

  /* None if the edges in the face do not join the vertices. */
  std::vector<Halfedge_index> operator()(Input_halfedge_index face, Vertex_index source, Vertex_index target)
  {
    return path_along_edges(m_triangulation, source, target, Policy(m_triangulation, face, target), m_search);
  }

private:
  class Policy : public Triangulation_edge_policy<Triangulation>
  {
    using Base = Triangulation_edge_policy<Triangulation>;

  public:
    Policy(const Triangulation& triangulation, Input_halfedge_index face, Vertex_index target)
      : Base(triangulation, target)
      , m_face(face)
    {
    }

    template <class Function>
    void for_each_halfedge(const typename Base::Origin& origin, const Function& function) const
    {
      Base::for_each_halfedge(origin, [&](Halfedge_index h) {
        if(is_edge_in_face(this->triangulation(), h, m_face))
          function(h);
      });
    }

  private:
    Input_halfedge_index m_face;
  };

  const Triangulation& m_triangulation;
  Triangulation_edge_search m_search;
};

} // namespace internal

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_IN_FACE_H
