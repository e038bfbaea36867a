// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_ZERO_EDGE_CONTRACTOR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_ZERO_EDGE_CONTRACTOR_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * Contracts degenerate edges. The vertices that they connect are one point of the surface. A face with one such edge is
 * degenerate, and its two other sides become one, so a fan of such faces merges many edges into one. A face with
 * three such edges is part of the point.
 *
 *        c                    c
 *      / | ^                  ^
 *     /  |  \       ==>       |        ab of length zero, with a needle on either side
 *    a --+--> b               v
 *     \  |  /                 ^
 *      v | /                  |
 *        d                    d
 *
 * Two degenerate faces that share their longest side can have coincident opposite vertices, though no edge connects
 * these. They are one point as well. The faces vanish, and their longest side runs along the two others.
 *
 *        b
 *      /   \
 *     a --> c       ==>     a --- bd --- c       b and d coincide on ac
 *      \   /
 *        d
 *
 * Around the point the surface is a disk, or a half disk at the border, if the vertices are connected like a tree of
 * triangles; a hole whose border has length zero is closed. Otherwise several umbrellas meet only at the point, and
 * each gets a vertex of its own.
 */
template <class Input_mesh, class Metric>
class Zero_edge_contractor
{
public:
  /* `metric.length(h)` must return the length of an edge, NaN if it has none; `metric.are_equally_long(g, h)`, whether
   * two edges have exactly the same length; `metric.is_folded(h, t)`, whether the vertices opposite to h and t, two
   * directions of one segment, coincide on it. */
  Zero_edge_contractor(const Input_mesh& input, const Metric& metric)
    : m_input(input)
    , m_metric(metric)
    , m_is_zero(static_cast<std::size_t>(input.number_of_halfedges()))
  {
    const auto all = descriptors<Vertex_index>(input.number_of_vertices());
    m_result.vertex.assign(all.begin(), all.end());
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
      if(!is_first_side(h))
        continue;
      m_is_zero[h] = m_is_zero[twin_index(h)] = metric.length(h) == 0 ? 1 : 0;
      if(m_is_zero[h] == 0)
        continue;
      m_is_needed = true;
      merge(input.tail(h), input.tail(twin_index(h)));
    }
    if(m_is_needed)
      check_needles();
    unfold();
  }

  /* Returns whether there is anything to contract. */
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

  /* Returns the next side of the face whose length is not zero; h itself if all others have length zero. */
  Input_halfedge_index next_side(Input_halfedge_index h) const
  {
    Input_halfedge_index g = next(h);
    while(g != h && m_is_zero[g] != 0)
      g = next(g);
    return g;
  }

  /* Returns whether the face of h is removed from the surface because it is degenerate. */
  bool is_gone(Input_halfedge_index h) const { return is_needle(h) || m_across.count(h) != 0; }

  /* Returns the side through which a path leaves a removed face that it enters across h. */
  Input_halfedge_index across(Input_halfedge_index h) const
  {
    const auto found = m_across.find(h);
    return found == m_across.end() ? next_side(h) : found->second;
  }

  /* Returns whether exactly two sides of a face have nonzero length. \pre that of h has */
  bool is_needle(Input_halfedge_index h) const
  {
    if(is_border(h))
      return false;
    const Input_halfedge_index g = next_side(h);
    return g != h && next_side(g) == h;
  }

  // The two long sides of a needle become one, so their lengths must agree.
  void check_needles() const
  {
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(m_input.number_of_halfedges())) {
      if(m_is_zero[h] == 0 || is_border(h))
        continue;
      const Input_halfedge_index g = next_side(h);
      if(g == h)
        continue;
      const Input_halfedge_index k = next_side(g);
      if(k == g || (next_side(k) == g && !m_metric.are_equally_long(g, k)))
        throw_naming<Degenerate_face_error>("a face has a zero-length edge between vertices ", m_input.tail(h), " and ",
                                            m_input.tail(twin_index(h)),
                                            ", and two other edges of different lengths; correct the lengths");
    }
  }

  // Repeats until no faces lie folded: faces that vanish let others meet.
  void unfold()
  {
    const std::vector<Input_halfedge_index> sides = longest_sides_of_flat_faces();
    for(bool has_changed = !sides.empty(); has_changed;) {
      has_changed = false;
      for(Input_halfedge_index h : sides)
        has_changed = unfold(h, sides) || has_changed;
    }
  }

  // Of all faces with three nonzero lengths, one of which is the sum of the others up to rounding errors. Sorted.
  std::vector<Input_halfedge_index> longest_sides_of_flat_faces() const
  {
    std::vector<Input_halfedge_index> result;
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(m_input.number_of_halfedges())) {
      const Input_halfedge_index hn = next(h), hp = next(hn);
      if(!is_border(h) && next(hp) == h && m_is_zero[h] + m_is_zero[hn] + m_is_zero[hp] == 0 &&
         std::isfinite(m_metric.length(h)) &&
         m_metric.length(h) >= (m_metric.length(hn) + m_metric.length(hp)) * (1 - length_sum_rounding))
        result.push_back(h);
    }
    return result;
  }

  // Examines the faces on both sides of h, between which all faces are removed, and removes them if they lie folded.
  bool unfold(Input_halfedge_index h, const std::vector<Input_halfedge_index>& sides)
  {
    if(is_gone(h))
      return false;
    const Input_halfedge_index t = far_side(h);
    if(!std::binary_search(sides.begin(), sides.end(), t) || !m_metric.is_folded(h, t))
      return false;
    const Input_halfedge_index hn = next(h), hp = next(hn), tn = next(t), tp = next(tn);
    const double share = m_metric.length(hp) / (m_metric.length(hp) + m_metric.length(hn));
    add_fold(h, {twin_index(hp), twin_index(hn), share}, t, {twin_index(tp), twin_index(tn), 1 - share});
    for(const auto& [from, to] : {std::make_pair(h, t), std::make_pair(hn, tp), std::make_pair(hp, tn)}) {
      m_across[from] = to;
      m_across[to] = from;
    }
    merge(m_input.tail(hp), m_input.tail(tp));
    return m_is_needed = true;
  }

  // For h, t, and the sides of needles in between.
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

  /* Pairs each remaining side, of a nondegenerate face or on the border, with the one beyond the removed faces. */
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
      return; // all faces are degenerate
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

  /* Returns the side beyond h and the removed faces beside it. */
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

  /* The halfedges that start at a vertex form a ring, or a fan between borders. A vertex with more than one of these is
   * a point at which umbrellas meet. */
  void number_sheets()
  {
    const Vertices merged = m_result.vertex; // the smallest of coincident ones
    m_result.outgoing.assign(merged.size(), null_index);
    for(Input_halfedge_index g : descriptors<Input_halfedge_index>(static_cast<Index>(m_result.next.size()))) {
      if(m_result.tail[g] != null_index)
        continue;
      const Vertex_index v = free_vertex(merged, merged[m_input.tail(m_result.input_halfedge[g])]);
      m_result.outgoing[v] = number_sheet(g, v);
    }
    place_vertices(merged);
  }

  // Returns a vertex coincident with v that no umbrella has yet; v comes first.
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
    throw_naming<Degenerate_face_error>(
        "at vertex ", v,
        ", the contraction of degenerate edges yields more umbrellas than there are coincident vertices to represent "
        "them");
  }

  void collect_members(const Vertices& merged)
  {
    for(Vertex_index v : descriptors<Vertex_index>(static_cast<Index>(merged.size())))
      m_members.emplace_back(merged[v], v);
    std::sort(m_members.begin(), m_members.end());
  }

  /* Numbers the ring or fan of g. Returns its last halfedge clockwise at the border, otherwise g. */
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

  /* Assigns the vertices of the input: to the first of their umbrellas, or to their point if they belong to needles
   * only. */
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
      Input_halfedge_index i = twin_index(g); // starting with the head of g
      while(m_result.is_border[i] == 0)
        i = counterclockwise(i);
      m_result.next[g] = i;
    }
  }

  const Input_mesh& m_input;
  const Metric& m_metric;
  Indexed_by<Input_halfedge_index, std::vector<char>> m_is_zero;
  bool m_is_needed = false;
  std::map<Input_halfedge_index, Input_halfedge_index> m_across; // of faces that lie folded
  std::vector<std::pair<Vertex_index, Vertex_index>> m_members;  // of each point, sorted
  Contraction m_result;
};

/* Returns the mesh with its degenerate edges contracted, by a metric as the contractor requires. */
template <class Input_mesh, class Metric>
Input_mesh contracted(const Input_mesh& input, const Metric& metric)
{
  Zero_edge_contractor<Input_mesh, Metric> contractor(input, metric);
  Input_mesh result(input);
  if(contractor.is_needed())
    result.replace_connectivity(contractor());
  return result;
}

/* Returns whether the face is degenerate and the vertex opposite to its first side lies between the ends of that
 * side. */
inline bool is_apex_on_side(const Exact_face& face)
{
  return face.doubled_area_squared == 0 && face.dot_next < 0 && face.dot_previous < 0;
}

/* Returns whether the apexes of two faces coincide on the first side, which is that of the other face reversed. */
inline bool are_apexes_in_one_place(const Exact_face& face, const Exact_face& other)
{
  return is_apex_on_side(face) && is_apex_on_side(other) &&
         face.dot_previous * other.squared_length + other.dot_previous * face.squared_length ==
             -(face.squared_length * other.squared_length);
}

/* The operations that a `Zero_edge_contractor` requires of the metric of a mesh. Without exact faces, none is certainly
 * folded. */
template <class Metric>
struct Contracted_metric
{
  const Metric& metric;
  const typename Metric::Mesh& input;

  double length(Input_halfedge_index h) const { return metric.weight(input, h); }

  /* Points need no exact comparison: two sides that join the same two places have the same rounded length. */
  bool are_equally_long(Input_halfedge_index g, Input_halfedge_index h) const
  {
    if constexpr(has_squared_lengths<Metric>)
      return metric.squared_length(input, g) == metric.squared_length(input, h);
    else
      return !(length(g) < length(h) || length(h) < length(g));
  }

  bool is_folded([[maybe_unused]] Input_halfedge_index h, [[maybe_unused]] Input_halfedge_index t) const
  {
    if constexpr(has_exact_faces<Metric>)
      return are_apexes_in_one_place(exact_face(metric, input, h), exact_face(metric, input, t));
    else
      return false;
  }
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_ZERO_EDGE_CONTRACTOR_H
