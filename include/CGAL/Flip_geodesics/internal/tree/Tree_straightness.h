// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TREE_TREE_STRAIGHTNESS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TREE_TREE_STRAIGHTNESS_H

#include <CGAL/Flip_geodesics/Straightness_meter.h>
#include <CGAL/Flip_geodesics/internal/strips/Strip.h>
#include <CGAL/Flip_geodesics/internal/strips/Vertex_directions.h>
#include <CGAL/Flip_geodesics/internal/strips/refresh_face.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Measures the paths of a geodesic tree afresh from the input, as `Straightness_meter` measures the curves of a
 * network.
 */
template <class Tree>
class Tree_straightness
{
  using Triangulation = typename Tree::Triangulation;

public:
  explicit Tree_straightness(const Tree& tree)
    : m_tree(tree)
    , m_triangulation(tree.triangulation())
  {
  }

  /* The smallest angle where paths to the given vertices leave their parents; writes the vertices whose are bent. */
  template <class OutputIterator>
  double operator()(const std::vector<Vertex_index>& vertices, OutputIterator bent) const
  {
    std::vector<std::pair<Vertex_index, Vertex_index>> edges; // parent and child
    for(Vertex_index v : vertices)
      if(m_tree.incoming(v) != null_index)
        edges.emplace_back(m_triangulation.tail(m_tree.incoming(v)), v);
    std::sort(edges.begin(), edges.end());

    double smallest = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < edges.size();) {
      const Vertex_index u = edges[i].first;
      const Vertex_directions<Triangulation> directions(m_triangulation, u);
      const Halfedge_index before = m_tree.incoming(u);
      const double back = before == null_index ? 0 : directions(Triangulation::twin(before));
      for(; i < edges.size() && edges[i].first == u; ++i) {
        const Halfedge_index h = m_tree.incoming(edges[i].second);
        const Strip<Triangulation> strip(m_triangulation, m_triangulation.crossing_word(h));
        const double angle = before == null_index ? std::numeric_limits<double>::infinity()
                                                  : directions.smaller_wedge(back, directions(strip));
        smallest = (std::min)(smallest, angle);
        if(angle < Straightness::straight_angle() || strip.bend() > Straightness::tolerance())
          *bent++ = edges[i].second;
      }
    }
    return smallest;
  }

  /* Lays the faces afresh in the bent wedge before v; false if flips were wrong already. */
  bool refresh(Vertex_index v)
  {
    const Halfedge_index h = m_tree.incoming(v);
    const Vertex_index u = m_triangulation.tail(h);
    if(m_tree.incoming(u) == null_index)
      return false;
    const Halfedge_index back = Triangulation::twin(m_tree.incoming(u));
    const Vertex_directions<Triangulation> directions(m_triangulation, u);
    if(directions.counterclockwise(directions(h), directions(back)) < Straightness::straight_angle())
      return refresh_wedge(back, h);
    return refresh_wedge(h, back);
  }

private:
  // Clockwise from a to c.
  bool refresh_wedge(Halfedge_index a, Halfedge_index c)
  {
    Halfedge_index h = a;
    do {
      const Halfedge_index t = Triangulation::twin(h);
      if(m_triangulation.is_border(t) || !refresh_face(m_triangulation, t))
        return false;
      h = m_triangulation.next(t);
    } while(h != c);
    return true;
  }

  const Tree& m_tree;
  Triangulation& m_triangulation;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TREE_TREE_STRAIGHTNESS_H
