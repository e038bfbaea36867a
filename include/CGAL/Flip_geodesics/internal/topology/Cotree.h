// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COTREE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COTREE_H

#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Sets of indices, which begin as sets of one. */
using Disjoint_sets = boost::disjoint_sets_with_storage<>;

inline bool are_united(Disjoint_sets& sets, Index a, Index b)
{
  return sets.find_set(static_cast<std::size_t>(a)) == sets.find_set(static_cast<std::size_t>(b));
}

/* Unites the sets of two indices; returns whether they were different. */
inline bool unite(Disjoint_sets& sets, Index a, Index b)
{
  if(are_united(sets, a, b))
    return false;
  sets.union_set(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  return true;
}

/* What is done with the borders of the surface. */
enum class Borders {
  CLOSED_BY_ONE_FACE, // all borders of a component belong to one more face, outside: loops are to be told apart
  LEFT_OPEN           // edges of the border are not crossed: the surface is to be cut open
};

/*
 * A spanning tree of the faces of each component, over edges that are not on the paths of a forest: that which leaves
 * the shortest loops [Erickson, Whittlesey 2005]. The loop of an edge is the path to its one end, the edge, and the path
 * back from its other end. The edges that are neither in the forest nor crossed by the cotree are the *generators*, and
 * their loops a shortest basis.
 *
 *         v        w          path - v - w - path back is the loop of edge vw
 *          \_____ /
 *          /     \.
 *         root of the forest
 */
class Cotree
{
public:
  /* None. */
  Cotree() = default;

  /* \throws Interrupted */
  template <class Input_mesh, class Weight>
  Cotree(const Input_mesh& input, const Edge_forest& forest, Borders borders, const Weight& weight,
         Interruption* interruption = nullptr)
    : m_is_crossed(static_cast<std::size_t>(input.number_of_halfedges() / 2), 0)
    , m_face(static_cast<std::size_t>(input.number_of_halfedges()), -1)
  {
    throw_if_interrupted_before_part(interruption);
    number_faces(input, forest);
    std::vector<Loop> loops;
    for(Index e = 0; e < input.number_of_halfedges() / 2; ++e) {
      throw_if_interrupted(interruption);
      const Input_halfedge_index h(2 * e), t = twin_index(h);
      const Vertex_index v = input.tail(h), w = input.tail(t);
      if(!forest.contains(input, h))
        loops.push_back({forest.component(v), forest.distance(v) + forest.distance(w) + weight(h), h});
    }
    throw_if_interrupted_before_part(interruption);
    span(input, borders, std::move(loops), interruption);
  }

  /* An edge whose loop belongs to the basis. */
  struct Loop
  {
    Index component;
    double length;
    Input_halfedge_index halfedge; // the first of the edge

    friend bool operator<(const Loop& a, const Loop& b)
    {
      return std::tie(a.component, a.length, a.halfedge) < std::tie(b.component, b.length, b.halfedge);
    }
  };

  /* The loops of the basis, by component, and the shortest first. */
  const std::vector<Loop>& generators() const { return m_generators; }
  /* Does the cotree cross the edge of a halfedge? */
  bool is_crossed(Input_halfedge_index h) const { return m_is_crossed[static_cast<std::size_t>(h.idx() / 2)] != 0; }

private:
  template <class Input_mesh>
  void number_faces(const Input_mesh& input, const Edge_forest& forest)
  {
    m_number_of_faces = static_cast<Index>(forest.roots().size()); // those outside
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
      if(input.is_border(h))
        m_face[h] = forest.component(input.tail(h));
      else if(m_face[h] < 0)
        m_face[h] = m_face[input.next(h)] = m_face[input.previous(h)] = m_number_of_faces++;
    }
  }

  // The longest loops first: their edges are crossed wherever they can be.
  template <class Input_mesh>
  void span(const Input_mesh& input, Borders borders, std::vector<Loop> loops, Interruption* interruption)
  {
    std::sort(loops.begin(), loops.end());
    Disjoint_sets sets(static_cast<std::size_t>(m_number_of_faces));
    for(std::size_t i = loops.size(); i-- > 0;) {
      throw_if_interrupted(interruption);
      const Input_halfedge_index h = loops[i].halfedge, t = twin_index(h);
      const bool is_closed = borders == Borders::LEFT_OPEN && (input.is_border(h) || input.is_border(t));
      if(!is_closed && unite(sets, m_face[h], m_face[t]))
        m_is_crossed[static_cast<std::size_t>(h.idx() / 2)] = 1;
      else
        m_generators.push_back(loops[i]);
    }
    std::reverse(m_generators.begin(), m_generators.end());
  }

  std::vector<char> m_is_crossed;                              // by edge
  Indexed_by<Input_halfedge_index, std::vector<Index>> m_face; // left of a halfedge
  Index m_number_of_faces = 0;
  std::vector<Loop> m_generators;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COTREE_H
