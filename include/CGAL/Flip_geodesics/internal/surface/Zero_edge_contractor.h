// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_ZERO_EDGE_CONTRACTOR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_ZERO_EDGE_CONTRACTOR_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

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
 * Two faces without area that share their longest side can have their other vertices in one place, though no edge joins
 * them. These are one point, too. The faces vanish, and what was their longest side leads along the two others.
 *
 *        b
 *      /   \
 *     a --> c       ==>     a --- bd --- c       b and d in one place on ac
 *      \   /
 *        d
 *
 * Around the point the surface is a disk, or a half disk at the border, if the vertices hang together like a tree of
 * triangles; a hole whose border has length zero is closed. Otherwise sheets of the surface meet there in nothing but
 * a point, and each sheet gets a vertex of its own.
 */
template <class Input_mesh>
class Zero_edge_contractor
{
public:
  /* `metric.length(h)` is that of an edge, not a number if it has none; `metric.is_folded(h, t)`, whether the
   * vertices opposite to h and t, two directions of one segment, lie on it in one place. */
  template <class Metric>
  Zero_edge_contractor(const Input_mesh& input, const Metric& metric)
    : m_input(input)
    , m_is_zero(static_cast<std::size_t>(input.number_of_halfedges()))
  {
    const auto length = [&](Input_halfedge_index h) { return metric.length(h); };
    const auto all = descriptors<Vertex_index>(input.number_of_vertices());
    m_result.vertex.assign(all.begin(), all.end());
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
      if(!is_first_side(h))
        continue;
      m_is_zero[h] = m_is_zero[twin_index(h)] = length(h) == 0 ? 1 : 0;
      if(m_is_zero[h] == 0)
        continue;
      m_is_needed = true;
      merge(input.tail(h), input.tail(twin_index(h)));
    }
    if(m_is_needed)
      check_needles(length);
    unfold(metric);
  }

  /* Is there anything to contract? */
  bool is_needed() const { return m_is_needed; }

  Contraction operator()()
  {
    for(Vertex_index v : descriptors<Vertex_index>(m_input.number_of_vertices()))
      m_result.vertex[v] = root(v);
    pair_sides();
    connect_faces();
    number_sheets();
    connect_border();
    return std::move(m_result);
  }

private:
  using Vertices = Indexed_by<Vertex_index, std::vector<Vertex_index>>;

  Vertex_index root(Vertex_index v)
  {
    auto& parent = m_result.vertex;
    while(parent[v] != parent[parent[v]])
      v = parent[v] = parent[parent[v]];
    return parent[v];
  }

  void merge(Vertex_index v, Vertex_index w)
  {
    v = root(v);
    w = root(w);
    m_result.vertex[(std::max)(v, w)] = (std::min)(v, w);
  }

  Input_halfedge_index next(Input_halfedge_index h) const { return m_input.next(h); }
  bool is_border(Input_halfedge_index h) const { return m_input.is_border(h); }

  /* The next side of the face that is no point; h itself if there is no other. */
  Input_halfedge_index next_side(Input_halfedge_index h) const
  {
    Input_halfedge_index g = next(h);
    while(g != h && m_is_zero[g] != 0)
      g = next(g);
    return g;
  }

  /* Is the face of h left out of the surface, as it has no area? */
  bool is_gone(Input_halfedge_index h) const { return is_needle(h) || m_across.count(h) != 0; }

  /* The side by which one leaves a face that is left out, where one enters it by h. */
  Input_halfedge_index across(Input_halfedge_index h) const
  {
    const auto found = m_across.find(h);
    return found == m_across.end() ? next_side(h) : found->second;
  }

  /* Have two sides of a face a length, and no other? \pre that of h has */
  bool is_needle(Input_halfedge_index h) const
  {
    if(is_border(h))
      return false;
    const Input_halfedge_index g = next_side(h);
    return g != h && next_side(g) == h;
  }

  // The sides of a needle are one, so they must agree.
  template <class Length>
  void check_needles(const Length& length) const
  {
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(m_input.number_of_halfedges())) {
      if(m_is_zero[h] == 0 || is_border(h))
        continue;
      const Input_halfedge_index g = next_side(h);
      if(g == h)
        continue;
      const Input_halfedge_index k = next_side(g);
      if(k == g || (next_side(k) == g && (length(g) < length(k) || length(k) < length(g))))
        throw Degenerate_face_error(
            "a face has an edge of length zero between vertices " + std::to_string(m_input.tail(h).idx()) + " and " +
                std::to_string(m_input.tail(twin_index(h)).idx()) + ", and two of different lengths",
            {static_cast<std::size_t>(m_input.tail(h).idx()),
             static_cast<std::size_t>(m_input.tail(twin_index(h)).idx())});
    }
  }

  // Until no faces lie folded: those that vanish let others meet.
  template <class Metric>
  void unfold(const Metric& metric)
  {
    const std::vector<Input_halfedge_index> sides = longest_sides_of_flat_faces(metric);
    for(bool has_changed = !sides.empty(); has_changed;) {
      has_changed = false;
      for(Input_halfedge_index h : sides)
        has_changed = unfold(h, sides, metric) || has_changed;
    }
  }

  // Of all faces with three lengths of which one is the sum of the others, but for roundings. Sorted.
  template <class Metric>
  std::vector<Input_halfedge_index> longest_sides_of_flat_faces(const Metric& metric) const
  {
    std::vector<Input_halfedge_index> result;
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(m_input.number_of_halfedges())) {
      const Input_halfedge_index hn = next(h), hp = next(hn);
      if(!is_border(h) && next(hp) == h && m_is_zero[h] + m_is_zero[hn] + m_is_zero[hp] == 0 &&
         std::isfinite(metric.length(h)) &&
         metric.length(h) >= (metric.length(hn) + metric.length(hp)) * (1 - length_sum_rounding))
        result.push_back(h);
    }
    return result;
  }

  // The faces on both sides of h, if they lie folded; what is between them is gone.
  template <class Metric>
  bool unfold(Input_halfedge_index h, const std::vector<Input_halfedge_index>& sides, const Metric& metric)
  {
    if(is_gone(h))
      return false;
    const Input_halfedge_index t = far_side(h);
    if(!std::binary_search(sides.begin(), sides.end(), t) || !metric.is_folded(h, t))
      return false;
    const Input_halfedge_index hn = next(h), hp = next(hn), tn = next(t), tp = next(tn);
    const double share = metric.length(hp) / (metric.length(hp) + metric.length(hn));
    add_fold(h, {twin_index(hp), twin_index(hn), share}, t, {twin_index(tp), twin_index(tn), 1 - share});
    for(const auto& [from, to] : {std::make_pair(h, t), std::make_pair(hn, tp), std::make_pair(hp, tn)}) {
      m_across[from] = to;
      m_across[to] = from;
    }
    merge(m_input.tail(hp), m_input.tail(tp));
    return m_is_needed = true;
  }

  // For h, t, and the sides of needles between.
  void add_fold(Input_halfedge_index h, const Contraction::Fold& of_h, Input_halfedge_index t,
                const Contraction::Fold& of_t)
  {
    for(Input_halfedge_index s = twin_index(h); s != t; s = twin_index(across(s))) {
      m_result.folds[s] = of_t;
      m_result.folds[across(s)] = of_h;
    }
    m_result.folds[h] = of_h;
    m_result.folds[t] = of_t;
  }

  /* Each side that is left, of a face with an area or on the border, is paired with what lies beyond those gone. */
  void pair_sides()
  {
    m_result.halfedge.resize(m_is_zero.size());
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(m_input.number_of_halfedges()))
      m_result.halfedge[h] = m_is_zero[h] != 0 ? Contraction::is_point : Contraction::is_hair;
    for(const auto& fold : m_result.folds)
      m_result.halfedge[fold.first] = Contraction::is_fold;
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(m_input.number_of_halfedges()))
      if(m_result.halfedge[h] == Contraction::is_hair && !is_gone(h))
        pair_side(h);
  }

  void pair_side(Input_halfedge_index h)
  {
    const Input_halfedge_index t = far_side(h);
    if(is_border(h) && is_border(t))
      return; // there are no faces with an area
    const Input_halfedge_index first(static_cast<Index>(m_result.input_halfedge.size()));
    m_result.input_halfedge.push_back(h);
    m_result.input_halfedge.push_back(t);
    m_result.halfedge[h] = first;
    m_result.halfedge[t] = twin_index(first);
    for(Input_halfedge_index s = twin_index(h); s != t; s = twin_index(across(s))) {
      m_result.halfedge[s] = twin_index(first);
      m_result.halfedge[across(s)] = first;
    }
  }

  /* What lies beyond h and the faces beside it that are gone. */
  Input_halfedge_index far_side(Input_halfedge_index h) const
  {
    Input_halfedge_index t = twin_index(h);
    while(is_gone(t))
      t = twin_index(across(t));
    return t;
  }

  void connect_faces()
  {
    const std::size_t n = m_result.input_halfedge.size();
    m_result.next.assign(n, null_index);
    m_result.tail.assign(n, null_index);
    m_result.is_border.assign(n, 0);
    for(Input_halfedge_index g : descriptors<Input_halfedge_index>(static_cast<Index>(n))) {
      const Input_halfedge_index h = m_result.input_halfedge[g];
      m_result.is_border[g] = is_border(h) ? 1 : 0;
      if(!is_border(h))
        m_result.next[g] = m_result.halfedge[next_side(h)];
    }
  }

  Input_halfedge_index clockwise(Input_halfedge_index g) const
  {
    return m_result.is_border[twin_index(g)] != 0 ? null_index : m_result.next[twin_index(g)];
  }

  Input_halfedge_index counterclockwise(Input_halfedge_index g) const
  {
    if(m_result.is_border[g] != 0)
      return null_index;
    Input_halfedge_index before = g;
    while(m_result.next[before] != g)
      before = m_result.next[before];
    return twin_index(before);
  }

  /* The halfedges that start in a vertex make a ring, or a fan between borders. A vertex that has more of them than
   * one is a point where sheets meet. */
  void number_sheets()
  {
    const Vertices merged = m_result.vertex; // the smallest of those in one place
    m_result.outgoing.assign(merged.size(), null_index);
    for(Input_halfedge_index g : descriptors<Input_halfedge_index>(static_cast<Index>(m_result.next.size()))) {
      if(m_result.tail[g] != null_index)
        continue;
      const Vertex_index v = free_vertex(merged, merged[m_input.tail(m_result.input_halfedge[g])]);
      m_result.outgoing[v] = number_sheet(g, v);
    }
    place_vertices(merged);
  }

  // A vertex in the place of v that no sheet has yet; v comes first.
  Vertex_index free_vertex(const Vertices& merged, Vertex_index v)
  {
    if(m_result.outgoing[v] == null_index)
      return v;
    m_result.has_split_point = true;
    if(m_members.empty())
      collect_members(merged);
    const auto [first, last] = std::equal_range(m_members.begin(), m_members.end(), std::make_pair(v, Vertex_index()),
                                                [](const auto& a, const auto& b) { return a.first < b.first; });
    for(auto member = first; member != last; ++member)
      if(m_result.outgoing[member->second] == null_index)
        return member->second;
    throw Degenerate_face_error("more sheets of the surface than vertices meet at vertex " + std::to_string(v.idx()),
                                {static_cast<std::size_t>(v.idx())});
  }

  void collect_members(const Vertices& merged)
  {
    for(Vertex_index v : descriptors<Vertex_index>(static_cast<Index>(merged.size())))
      m_members.emplace_back(merged[v], v);
    std::sort(m_members.begin(), m_members.end());
  }

  /* Numbers the ring or fan of g. Returns its last halfedge clockwise at the border, else g. */
  Input_halfedge_index number_sheet(Input_halfedge_index g, Vertex_index v)
  {
    Input_halfedge_index last = g;
    for(Input_halfedge_index i = counterclockwise(g); i != null_index && i != g; i = counterclockwise(i))
      last = i;
    const bool is_ring = counterclockwise(last) == g;
    const Input_halfedge_index first = is_ring ? g : last;
    Input_halfedge_index i = first;
    do {
      m_result.tail[i] = v;
      last = i;
      i = clockwise(i);
    } while(i != null_index && i != first);
    return is_ring ? g : last;
  }

  /* Where the vertices of the input are: in the first of their sheets; one of needles only, where its place is. */
  void place_vertices(const Vertices& merged)
  {
    m_result.vertex.assign(merged.size(), null_index);
    for(Input_halfedge_index g : descriptors<Input_halfedge_index>(static_cast<Index>(m_result.tail.size()))) {
      const Input_halfedge_index h = m_result.input_halfedge[g];
      Vertex_index& v = m_result.vertex[m_input.tail(h)];
      if(v == null_index)
        v = m_result.tail[g];
    }
    for(Vertex_index v : descriptors<Vertex_index>(static_cast<Index>(merged.size())))
      if(m_result.vertex[v] == null_index)
        m_result.vertex[v] = merged[v];
  }

  void connect_border()
  {
    for(Input_halfedge_index g : descriptors<Input_halfedge_index>(static_cast<Index>(m_result.next.size()))) {
      if(m_result.is_border[g] == 0)
        continue;
      Input_halfedge_index i = twin_index(g); // from the head of g on
      while(m_result.is_border[i] == 0)
        i = counterclockwise(i);
      m_result.next[g] = i;
    }
  }

  const Input_mesh& m_input;
  Indexed_by<Input_halfedge_index, std::vector<char>> m_is_zero;
  bool m_is_needed = false;
  std::map<Input_halfedge_index, Input_halfedge_index> m_across; // of faces that lie folded
  std::vector<std::pair<Vertex_index, Vertex_index>> m_members;  // of each place, sorted
  Contraction m_result;
};

/* The same mesh with its edges of length zero contracted, by a metric as the contractor asks for. */
template <class Input_mesh, class Metric>
Input_mesh contracted(const Input_mesh& input, const Metric& metric)
{
  Zero_edge_contractor<Input_mesh> contractor(input, metric);
  Input_mesh result(input);
  if(contractor.is_needed())
    result.replace_connectivity(contractor());
  return result;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_ZERO_EDGE_CONTRACTOR_H
