// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_CONTRACTION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_CONTRACTION_H

#include <CGAL/Flip_geodesics/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsRef
/// The index of a vertex, an edge or a halfedge; halfedges `2e` and `2e+1` are the two sides of edge `e`.
using Index = std::int32_t;

/// \ingroup PkgFlipGeodesicsRef
/// The index of no element.
constexpr Index null_index = -1;

namespace internal {

/*
 * A mesh with its edges of length zero contracted: what the halfedges of the input have become, and how those that are
 * left hang together. Vertices keep their numbers; those that are merged into another one are isolated.
 */
struct Contraction
{
  /* What becomes of a halfedge that is no more: its ends are one vertex; or no face with an area is left beside it. */
  static constexpr Index is_point = -1, is_hair = -2;

  std::vector<Index> vertex;         // of each vertex of the input, the one that it is now
  std::vector<Index> halfedge;       // of each halfedge of the input
  std::vector<Index> input_halfedge; // of each halfedge that is left, one of the input's that it was
  std::vector<Index> next, tail;
  std::vector<char> is_border;
  std::vector<Index> outgoing;  // of each vertex, null_index if isolated
  bool has_split_point = false; // do sheets of the surface that only met in a point have vertices of their own there?
};

/*
 * Contracts the edges of length zero. The vertices that they join are one point of the surface. A face with one such
 * edge has no area, and its two other sides are one; so a fan of them makes one edge of many. A face of three is a
 * part of the point.
 *
 *        c                    c
 *      / | ^                  ^
 *     /  |  \       ==>       |        ab of length zero, with a needle on either side
 *    a --+--> b               v
 *     \  |  /                 ^
 *      v | /                  |
 *        d                    d
 *
 * Around the point the surface is a disk, or a half disk at the border, if the vertices hang together like a tree of
 * triangles; a hole whose border has length zero is closed. Otherwise sheets of the surface meet there in nothing but
 * a point, and each sheet gets a vertex of its own.
 */
template <class Input_mesh>
class Zero_edge_contractor
{
public:
  /* `length(h)` is that of an edge, not a number if it has none. */
  template <class Length>
  Zero_edge_contractor(const Input_mesh& input, const Length& length)
    : m_input(input)
    , m_is_zero(static_cast<std::size_t>(input.number_of_halfedges()))
  {
    m_result.vertex.resize(static_cast<std::size_t>(input.number_of_vertices()));
    std::iota(m_result.vertex.begin(), m_result.vertex.end(), 0);
    for(Index h = 0; h < input.number_of_halfedges(); h += 2) {
      m_is_zero[h] = m_is_zero[h + 1] = length(h) == 0 ? 1 : 0;
      if(m_is_zero[h] == 0)
        continue;
      m_has_zero_edges = true;
      merge(input.tail(h), input.tail(h + 1));
    }
    if(m_has_zero_edges)
      check_needles(length);
  }

  bool has_zero_edges() const { return m_has_zero_edges; }

  Contraction operator()()
  {
    for(Index v = 0; v < m_input.number_of_vertices(); ++v)
      m_result.vertex[v] = root(v);
    pair_sides();
    connect_faces();
    number_sheets();
    connect_border();
    return std::move(m_result);
  }

private:
  Index root(Index v)
  {
    std::vector<Index>& parent = m_result.vertex;
    while(parent[v] != parent[parent[v]])
      v = parent[v] = parent[parent[v]];
    return parent[v];
  }

  void merge(Index v, Index w)
  {
    v = root(v);
    w = root(w);
    m_result.vertex[(std::max)(v, w)] = (std::min)(v, w);
  }

  Index next(Index h) const { return m_input.next(h); }
  bool is_border(Index h) const { return m_input.is_border(h); }

  /* The next side of the face that is no point; h itself if there is no other. */
  Index next_side(Index h) const
  {
    Index g = next(h);
    while(g != h && m_is_zero[g] != 0)
      g = next(g);
    return g;
  }

  /* Have two sides of a face a length, and no other? \pre that of h has */
  bool is_needle(Index h) const
  {
    if(is_border(h))
      return false;
    const Index g = next_side(h);
    return g != h && next_side(g) == h;
  }

  // The sides of a needle are one, so they must agree.
  template <class Length>
  void check_needles(const Length& length) const
  {
    for(Index h = 0; h < m_input.number_of_halfedges(); ++h) {
      if(m_is_zero[h] == 0 || is_border(h))
        continue;
      const Index g = next_side(h);
      if(g == h)
        continue;
      const Index k = next_side(g);
      if(k == g || (next_side(k) == g && (length(g) < length(k) || length(k) < length(g))))
        throw Degenerate_face_error(
            "a face has an edge of length zero between vertices " + std::to_string(m_input.tail(h)) + " and " +
                std::to_string(m_input.tail(h ^ 1)) + ", and two of different lengths",
            {static_cast<std::size_t>(m_input.tail(h)), static_cast<std::size_t>(m_input.tail(h ^ 1))});
    }
  }

  /* Each side that is left, of a face with an area or on the border, is paired with what lies beyond all needles. */
  void pair_sides()
  {
    m_result.halfedge.resize(m_is_zero.size());
    for(std::size_t h = 0; h < m_is_zero.size(); ++h)
      m_result.halfedge[h] = m_is_zero[h] != 0 ? Contraction::is_point : Contraction::is_hair;
    for(Index h = 0; h < m_input.number_of_halfedges(); ++h)
      if(m_result.halfedge[h] == Contraction::is_hair && !is_needle(h))
        pair_side(h);
  }

  void pair_side(Index h)
  {
    const Index t = far_side(h);
    if(is_border(h) && is_border(t))
      return; // there are needles only
    const Index edge = static_cast<Index>(m_result.input_halfedge.size());
    m_result.input_halfedge.push_back(h);
    m_result.input_halfedge.push_back(t);
    m_result.halfedge[h] = edge;
    m_result.halfedge[t] = edge + 1;
    for(Index s = h ^ 1; s != t; s = next_side(s) ^ 1) {
      m_result.halfedge[s] = edge + 1;
      m_result.halfedge[next_side(s)] = edge;
    }
  }

  /* What lies beyond h and the needles beside it. */
  Index far_side(Index h) const
  {
    Index t = h ^ 1;
    while(is_needle(t))
      t = next_side(t) ^ 1;
    return t;
  }

  void connect_faces()
  {
    const std::size_t n = m_result.input_halfedge.size();
    m_result.next.assign(n, null_index);
    m_result.tail.assign(n, null_index);
    m_result.is_border.assign(n, 0);
    for(std::size_t g = 0; g < n; ++g) {
      const Index h = m_result.input_halfedge[g];
      m_result.is_border[g] = is_border(h) ? 1 : 0;
      if(!is_border(h))
        m_result.next[g] = m_result.halfedge[next_side(h)];
    }
  }

  Index clockwise(Index g) const { return m_result.is_border[g ^ 1] != 0 ? null_index : m_result.next[g ^ 1]; }

  Index counterclockwise(Index g) const
  {
    if(m_result.is_border[g] != 0)
      return null_index;
    Index before = g;
    while(m_result.next[before] != g)
      before = m_result.next[before];
    return before ^ 1;
  }

  /* The halfedges that start in a vertex make a ring, or a fan between borders. A vertex that has more of them than
   * one is a point where sheets meet. */
  void number_sheets()
  {
    const std::vector<Index> merged = m_result.vertex; // the smallest of those in one place
    m_result.outgoing.assign(merged.size(), null_index);
    for(Index g = 0; g < static_cast<Index>(m_result.next.size()); ++g) {
      if(m_result.tail[g] != null_index)
        continue;
      const Index v = free_vertex(merged, merged[m_input.tail(m_result.input_halfedge[g])]);
      m_result.outgoing[v] = number_sheet(g, v);
    }
    place_vertices(merged);
  }

  // A vertex in the place of v that no sheet has yet; v comes first.
  Index free_vertex(const std::vector<Index>& merged, Index v)
  {
    if(m_result.outgoing[v] == null_index)
      return v;
    m_result.has_split_point = true;
    if(m_members.empty())
      collect_members(merged);
    const auto [first, last] = std::equal_range(m_members.begin(), m_members.end(), std::make_pair(v, null_index),
                                                [](const auto& a, const auto& b) { return a.first < b.first; });
    for(auto member = first; member != last; ++member)
      if(m_result.outgoing[member->second] == null_index)
        return member->second;
    throw Degenerate_face_error("more sheets of the surface than vertices meet at vertex " + std::to_string(v),
                                {static_cast<std::size_t>(v)});
  }

  void collect_members(const std::vector<Index>& merged)
  {
    for(Index v = 0; v < static_cast<Index>(merged.size()); ++v)
      m_members.emplace_back(merged[v], v);
    std::sort(m_members.begin(), m_members.end());
  }

  /* Numbers the ring or fan of g. Returns its last halfedge clockwise at the border, else g. */
  Index number_sheet(Index g, Index v)
  {
    Index last = g;
    for(Index i = counterclockwise(g); i != null_index && i != g; i = counterclockwise(i))
      last = i;
    const bool is_ring = counterclockwise(last) == g;
    const Index first = is_ring ? g : last;
    Index i = first;
    do {
      m_result.tail[i] = v;
      last = i;
      i = clockwise(i);
    } while(i != null_index && i != first);
    return is_ring ? g : last;
  }

  /* Where the vertices of the input are: in the first of their sheets; one of needles only, where its place is. */
  void place_vertices(const std::vector<Index>& merged)
  {
    m_result.vertex.assign(merged.size(), null_index);
    for(std::size_t g = 0; g < m_result.tail.size(); ++g) {
      const Index h = m_result.input_halfedge[g];
      Index& v = m_result.vertex[m_input.tail(h)];
      if(v == null_index)
        v = m_result.tail[g];
    }
    for(std::size_t v = 0; v < merged.size(); ++v)
      if(m_result.vertex[v] == null_index)
        m_result.vertex[v] = merged[v];
  }

  void connect_border()
  {
    for(Index g = 0; g < static_cast<Index>(m_result.next.size()); ++g) {
      if(m_result.is_border[g] == 0)
        continue;
      Index i = g ^ 1; // from the head of g on
      while(m_result.is_border[i] == 0)
        i = counterclockwise(i);
      m_result.next[g] = i;
    }
  }

  const Input_mesh& m_input;
  std::vector<char> m_is_zero;
  bool m_has_zero_edges = false;
  std::vector<std::pair<Index, Index>> m_members; // of each place, sorted
  Contraction m_result;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_CONTRACTION_H
