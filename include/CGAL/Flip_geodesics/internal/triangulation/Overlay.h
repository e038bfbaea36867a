// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

struct Overlay_vertex_element
{
  static constexpr const char* letter = "overlay v";
};

struct Overlay_halfedge_element
{
  static constexpr const char* letter = "overlay h";
};

/* The elements of an overlay; they are distinct from those of the input and of the triangulation. */
using Overlay_vertex = Descriptor<Overlay_vertex_element>;
using Overlay_halfedge = Descriptor<Overlay_halfedge_element>;

/* One value per element. */
template <class T>
using Per_overlay_vertex = Indexed_by<Overlay_vertex, std::vector<T>>;
template <class T>
using Per_overlay_halfedge = Indexed_by<Overlay_halfedge, std::vector<T>>;

/*
 * The common subdivision of the input mesh and an intrinsic triangulation: a polygon mesh whose edges are the pieces
 * into which the edges of either are cut by those of the other. It is constructed from integers alone: the number of
 * input edges that pass through an intrinsic triangle, and how they do, follows from the numbers of crossings of its
 * sides [GSC21, section 3]; which edges these are follows from the edge sequences. The order of crossings along input
 * edges is therefore exact, and the result is a manifold, whatever rounding does to positions.
 *
 * Vertices: those of the triangulation, with their indices, then the crossings, edge by edge, each along halfedge 2e.
 * Edge k has the halfedges 2k and 2k+1. First come the pieces of intrinsic edges, edge by edge, then the *arcs*, the
 * pieces of input edges inside intrinsic triangles. Each polygon lies in one input face. Halfedges on the border have
 * no successor.
 *
 * Afterwards edges can be dissolved, doubled (cut open), split and added (diagonals of polygons).
 */
template <class Triangulation>
class Overlay
{
public:
  explicit Overlay(const Triangulation& triangulation)
    : m_triangulation(&triangulation)
  {
    number_crossings();
    make_pieces();
    link_triangles();
    for(Overlay_halfedge h : halfedges())
      if(m_next[h] != null_index)
        m_previous[m_next[h]] = h;
  }

  const Triangulation& triangulation() const { return *m_triangulation; }

  Index number_of_vertices() const { return m_number_of_vertices; }
  Index number_of_halfedges() const { return static_cast<Index>(m_next.size()); }

  /* The current vertices. */
  auto vertices() const { return descriptors<Overlay_vertex>(m_number_of_vertices); }
  auto halfedges() const { return descriptors<Overlay_halfedge>(number_of_halfedges()); }

  static Overlay_halfedge twin(Overlay_halfedge h) { return twin_index(h); }
  Overlay_halfedge next(Overlay_halfedge h) const { return m_next[h]; }
  Overlay_halfedge previous(Overlay_halfedge h) const { return m_previous[h]; }
  Overlay_vertex origin(Overlay_halfedge h) const { return m_origin[h]; }
  Overlay_vertex target(Overlay_halfedge h) const { return m_origin[twin(h)]; }
  bool is_border(Overlay_halfedge h) const { return m_next[h] == null_index; }
  /* Returns false once the edge of h is dissolved. */
  bool is_alive(Overlay_halfedge h) const { return m_origin[h] != null_index; }

  /* Returns the intrinsic halfedge along which h runs, or null_index if there is none. */
  Halfedge_index intrinsic_halfedge(Overlay_halfedge h) const { return oriented(m_intrinsic[edge(h)], h); }
  /* Returns the input halfedge along which h runs, or null_index if there is none. */
  Input_halfedge_index input_halfedge(Overlay_halfedge h) const { return oriented(m_input[edge(h)], h); }

  /* Returns whether v is a crossing, and not a vertex of the triangulation. */
  bool is_crossing(Overlay_vertex v) const
  {
    return v.idx() >= m_triangulation->number_of_vertices() && v.idx() < m_end_of_crossings;
  }

  /* Returns whether v was added by split(). */
  bool is_midpoint(Overlay_vertex v) const { return v.idx() >= m_end_of_crossings; }

  /* Returns whether v is a vertex of the input, and neither a crossing nor inserted. */
  bool is_input_vertex(Overlay_vertex v) const { return v.idx() < m_triangulation->input().number_of_vertices(); }

  /* Returns the number of crossings of intrinsic edge e. */
  Index crossings(Edge_index e) const { return m_first_crossing[e.idx() + 1] - m_first_crossing[e.idx()]; }

  /* Returns crossing i of intrinsic edge e along halfedge 2e, as a vertex. */
  Overlay_vertex crossing_vertex(Edge_index e, Index i) const
  {
    return Overlay_vertex(m_triangulation->number_of_vertices() + m_first_crossing[e.idx()] + i);
  }

  /* Returns the input halfedge crossed at a crossing by the first halfedge of the intrinsic edge, as a side of the face
   * that it leaves. */
  Input_halfedge_index crossed_halfedge(Overlay_vertex v) const
  {
    return m_crossed_edges[v.idx() - m_triangulation->number_of_vertices()];
  }

  /* Returns piece i of intrinsic halfedge h, out of crossings(edge) + 1. */
  Overlay_halfedge piece(Halfedge_index h, Index i) const
  {
    const Edge_index e = Triangulation::edge(h);
    const Index first = m_first_crossing[e.idx()] + e.idx();
    return Overlay_halfedge(is_first_side(h) ? 2 * (first + i) : 2 * (first + crossings(e) - i) + 1);
  }

  /* Calls function(p) for the parts of piece i of intrinsic halfedge h, in its direction: two if it was split. Each
   * part is on the side of its polygon, even if the edge was cut. */
  template <class Function>
  void for_each_part(Halfedge_index h, Index i, Function function) const
  {
    const Overlay_halfedge p = piece(h, i);
    const auto split = m_second_halves.find(first_of_edge(p));
    if(split == m_second_halves.end())
      return function(with_face(p));
    const Overlay_halfedge second = is_first_side(p) ? split->second : twin(split->second);
    function(with_face(is_first_side(p) ? p : second));
    function(with_face(is_first_side(p) ? second : p));
  }

  /* Returns the continuation of an input edge through a crossing: the arc after arc h. \pre the target of h is a
   * crossing */
  Overlay_halfedge next_arc(Overlay_halfedge h) const { return next(twin(next(h))); }

  /* Calls function(h) for one halfedge of each polygon, the first. */
  template <class Function>
  void for_each_polygon(Function function) const
  {
    Per_overlay_halfedge<char> is_done(m_next.size(), 0);
    for(Overlay_halfedge h : halfedges()) {
      if(is_done[h] != 0 || is_border(h) || !is_alive(h))
        continue;
      for_each_side(h, [&](Overlay_halfedge side) { is_done[side] = 1; });
      function(h);
    }
  }

  /* Calls function(side) for the sides of the polygon on the left of h, from h on. */
  template <class Function>
  void for_each_side(Overlay_halfedge h, Function function) const
  {
    Overlay_halfedge side = h;
    do {
      function(side);
      side = next(side);
    } while(side != h);
  }

  /*
   * Returns for each halfedge the smallest halfedge of the input face that contains its polygon; null_index on the
   * border. If no side of a polygon lies along an input edge, the polygon lies in the same face as its neighbors.
   */
  Per_overlay_halfedge<Input_halfedge_index> input_faces() const
  {
    Per_overlay_halfedge<Input_halfedge_index> face(m_next.size());
    std::vector<Overlay_halfedge> pending;
    const auto assign = [&](Overlay_halfedge h, Input_halfedge_index f) {
      for_each_side(h, [&](Overlay_halfedge side) { face[side] = f; });
      pending.push_back(h);
    };
    for(Overlay_halfedge h : halfedges())
      if(is_alive(h) && !is_border(h) && face[h] == null_index && input_halfedge(h) != null_index)
        assign(h, first_of_input_face(input_halfedge(h)));
    while(!pending.empty()) {
      const Overlay_halfedge h = pending.back();
      pending.pop_back();
      for_each_side(h, [&](Overlay_halfedge side) {
        if(input_halfedge(side) == null_index && face[twin(side)] == null_index)
          assign(twin(side), face[h]);
      });
    }
    return face;
  }

  /* Merges the polygons on the two sides of an edge. */
  void dissolve(Overlay_halfedge h)
  {
    const Overlay_halfedge t = twin(h);
    const Overlay_halfedge before_h = previous(h), after_h = next(h), before_t = previous(t), after_t = next(t);
    link(before_h, after_t);
    link(before_t, after_h);
    m_origin[h] = m_origin[t] = null_index;
  }

  /* Joins h and next(h), parts of one input edge between which no other edge ends, into one edge, h. */
  void join(Overlay_halfedge h)
  {
    const Overlay_halfedge g = next(h), t = twin(h), s = twin(g);
    link(h, next(g));
    if(!is_border(t))
      link(previous(s), t);
    m_origin[t] = m_origin[s];
    m_intrinsic[edge(h)] = null_index; // longer than any single intrinsic edge
    m_origin[g] = m_origin[s] = null_index;
  }

  /* Returns whether h and next(h) are the only edges at the target of h. \pre it is not on the border */
  bool has_two_edges_at_target(Overlay_halfedge h) const { return next(twin(next(h))) == twin(h); }

  /* Adds the diagonal from the origin of a to the origin of b, two sides of one polygon; its successor is b. */
  Overlay_halfedge add_diagonal(Overlay_halfedge a, Overlay_halfedge b)
  {
    const Overlay_halfedge d = next_new_halfedge();
    const Overlay_halfedge before_a = previous(a), before_b = previous(b);
    add_edge(m_origin[a], m_origin[b], null_index, null_index);
    link(before_a, d);
    link(d, b);
    link(before_b, twin(d));
    link(twin(d), a);
    return d;
  }

  /*
   * Splits the edge of h, between two triangles or on the border, at a new vertex, which is connected to the opposite
   * corners. The first half of an edge's first halfedge keeps its index. Returns the second half of that halfedge.
   */
  Overlay_halfedge split(Overlay_halfedge h)
  {
    h = first_of_edge(h);
    const Overlay_halfedge t = twin(h), k = next_new_halfedge();
    const Overlay_vertex m(m_number_of_vertices++), v = m_origin[t];
    add_edge(m, v, m_intrinsic[edge(h)], m_input[edge(h)]);
    m_second_halves.emplace(h, k);
    m_origin[t] = m;
    if(!is_border(h)) {
      const Overlay_halfedge hn = next(h);
      link(k, hn);
      link(h, k);
      add_diagonal(k, previous(h));
    }
    if(!is_border(t)) {
      link(previous(t), twin(k));
      link(twin(k), t);
      add_diagonal(t, previous(twin(k)));
    }
    return k;
  }

  /* Returns the edges, by their first halfedges, that share both ends with another edge, together with that other edge.
   * Takes linear time. */
  std::vector<Overlay_halfedge> parallel_edges() const
  {
    Per_overlay_vertex<Overlay_halfedge> first(static_cast<std::size_t>(m_number_of_vertices)); // edge at a smaller end
    Per_overlay_vertex<Overlay_halfedge> seen(first.size());
    std::vector<Overlay_halfedge> after(m_next.size() / 2), result;
    for(Overlay_halfedge h : halfedges())
      if(is_first_side(h) && is_alive(h)) {
        Overlay_halfedge& list = first[(std::min)(origin(h), target(h))];
        after[edge(h)] = list;
        list = h;
      }
    for(Overlay_halfedge list : first) {
      for(Overlay_halfedge h = list; h != null_index; h = after[edge(h)])
        seen[(std::max)(origin(h), target(h))] = null_index;
      for(Overlay_halfedge h = list; h != null_index; h = after[edge(h)]) {
        Overlay_halfedge& other = seen[(std::max)(origin(h), target(h))];
        if(other != null_index)
          result.insert(result.end(), {other, h});
        other = h;
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /* Doubles the edge of h, so that both of its sides lie on the border. The vertices stay; see split_vertices(). \pre
   * neither side lies on the border */
  void cut(Overlay_halfedge h)
  {
    const Overlay_halfedge t = twin(h), doubled = next_new_halfedge();
    add_edge(m_origin[t], m_origin[h], oriented(m_intrinsic[edge(h)], t), oriented(m_input[edge(h)], t));
    link(previous(t), doubled);
    link(doubled, next(t));
    m_next[t] = m_previous[t] = null_index;
    m_doubles.emplace(t, doubled);
  }

  /*
   * Gives each fan of polygons around a vertex its own vertex if cuts have separated them; the first fan keeps the old
   * one. Returns the original of each vertex.
   */
  Per_overlay_vertex<Overlay_vertex> split_vertices()
  {
    const auto all = vertices();
    Per_overlay_vertex<Overlay_vertex> original(all.begin(), all.end());
    Per_overlay_halfedge<char> is_done(m_next.size(), 0);
    Per_overlay_vertex<char> is_taken(original.size(), 0);
    for(Overlay_halfedge h : halfedges()) {
      if(!is_alive(h) || is_border(h) || is_done[h] != 0)
        continue;
      const Overlay_vertex v = m_origin[h];
      if(is_taken[v] != 0)
        original.push_back(v);
      const Overlay_vertex own = is_taken[v] != 0 ? Overlay_vertex(m_number_of_vertices++) : v;
      is_taken[v] = 1;
      take_fan(h, own, is_done);
    }
    return original;
  }

private:
  static std::size_t edge(Overlay_halfedge h) { return static_cast<std::size_t>(h.idx() >> 1); }
  static Overlay_halfedge first_of_edge(Overlay_halfedge h) { return is_first_side(h) ? h : twin(h); }

  // The halfedge that add_edge() will create next.
  Overlay_halfedge next_new_halfedge() const { return Overlay_halfedge(number_of_halfedges()); }

  Overlay_halfedge with_face(Overlay_halfedge h) const
  {
    const auto found = m_doubles.find(h);
    return found == m_doubles.end() ? h : found->second;
  }

  // The side of an edge along which h runs, if its first halfedge runs along `along`.
  template <class Halfedge>
  static Halfedge oriented(Halfedge along, Overlay_halfedge h)
  {
    return along == null_index || is_first_side(h) ? along : twin_index(along);
  }

  Input_halfedge_index first_of_input_face(Input_halfedge_index h) const
  {
    const auto& input = m_triangulation->input();
    const Input_halfedge_index hn = input.next(h);
    return (std::min)({h, hn, input.next(hn)});
  }

  void link(Overlay_halfedge h, Overlay_halfedge g)
  {
    m_next[h] = g;
    m_previous[g] = h;
  }

  void add_edge(Overlay_vertex from, Overlay_vertex to, Halfedge_index intrinsic, Input_halfedge_index input)
  {
    checked_index_bound(m_next.size() + 2);
    m_origin.insert(m_origin.end(), {from, to});
    m_next.insert(m_next.end(), 2, null_index);
    m_previous.insert(m_previous.end(), 2, null_index);
    m_intrinsic.push_back(intrinsic);
    m_input.push_back(input);
  }

  void number_crossings()
  {
    const Index number_of_edges = m_triangulation->number_of_edges();
    m_first_crossing.reserve(static_cast<std::size_t>(number_of_edges) + 1);
    std::int64_t count = 0;
    for(Edge_index e : descriptors<Edge_index>(number_of_edges)) {
      m_first_crossing.push_back(static_cast<Index>(count));
      count += (std::max)(m_triangulation->crossings(e), 0);
      checked_index_bound(2 * (count + number_of_edges));
    }
    m_first_crossing.push_back(static_cast<Index>(count));
    m_number_of_vertices = m_end_of_crossings = checked_index_bound(m_triangulation->number_of_vertices() + count);
  }

  void make_pieces()
  {
    for(Edge_index e : descriptors<Edge_index>(m_triangulation->number_of_edges())) {
      const Halfedge_index h = first_side(e);
      const Edge_sequence sequence = m_triangulation->edge_sequence(h);
      const Index n = crossings(e);
      CGAL_assertion(static_cast<std::size_t>(n) == sequence.crossed.size());
      m_crossed_edges.insert(m_crossed_edges.end(), sequence.crossed.begin(), sequence.crossed.end());
      for(Index i = 0; i <= n; ++i)
        add_edge(i == 0 ? vertex(m_triangulation->tail(h)) : crossing_vertex(e, i - 1),
                 i == n ? vertex(m_triangulation->head(h)) : crossing_vertex(e, i), h, sequence.along);
    }
  }

  void link_triangles()
  {
    for(Halfedge_index h : descriptors<Halfedge_index>(m_triangulation->number_of_halfedges())) {
      if(m_triangulation->is_border(h))
        continue;
      const Halfedge_index hn = m_triangulation->next(h), hp = m_triangulation->next(hn);
      if(h < hn && h < hp)
        link_triangle({h, hn, hp});
    }
  }

  /*
   * Side i leads from corner i+1 to corner i+2, so that corner i is where side i+1 ends and side i+2 starts. Along a
   * side come first the arcs that cut off its first corner, then those that emanate from the opposite one, then those
   * that cut off its second corner.
   */
  void link_triangle(const std::array<Halfedge_index, 3>& side)
  {
    std::array<Index, 3> n;
    for(int i = 0; i < 3; ++i)
      n[i] = m_triangulation->crossings(Triangulation::edge(side[i]));
    const Triangle_crossings passing(n[0], n[1], n[2]);

    std::array<std::vector<Overlay_halfedge>, 3> inward; // the arc that leaves each crossing of each side
    for(int i = 0; i < 3; ++i)
      inward[i].resize(static_cast<std::size_t>((std::max)(n[i], 0)));
    for(int i = 0; i < 3; ++i) {
      const int before = (i + 1) % 3, after = (i + 2) % 3;
      for(Index k = 0; k < passing.cutting[i]; ++k)
        add_arc(side[after], k, inward[after][k], side[before], n[before] - 1 - k, inward[before][n[before] - 1 - k]);
      for(Index k = 0; k < passing.emanating[i]; ++k) {
        const Index j = passing.cutting[before] + k;
        inward[i][j] = next_new_halfedge();
        add_edge(vertex_on(side[i], j), vertex(m_triangulation->tail(side[after])), null_index,
                 crossed_edge_on(side[i], j));
      }
    }
    for(int i = 0; i < 3; ++i) {
      link_along(side[i], inward[i]);
      const int before = (i + 1) % 3, after = (i + 2) % 3;
      Overlay_halfedge arriving = piece(side[before], (std::max)(n[before], 0));
      for(Index k = passing.emanating[i] - 1; k >= 0; --k) {
        const Overlay_halfedge arc = inward[i][passing.cutting[before] + k];
        m_next[arriving] = twin(arc);
        arriving = arc;
      }
      m_next[arriving] = piece(side[after], 0);
    }
  }

  static Overlay_vertex vertex(Vertex_index v) { return Overlay_vertex(v.idx()); }

  // The crossing with number i along halfedge h, as a vertex.
  Overlay_vertex vertex_on(Halfedge_index h, Index i) const
  {
    const Edge_index e = Triangulation::edge(h);
    return crossing_vertex(e, is_first_side(h) ? i : crossings(e) - 1 - i);
  }

  // The crossed input halfedge that leads from there to the left.
  Input_halfedge_index crossed_edge_on(Halfedge_index h, Index i) const
  {
    const Input_halfedge_index crossed_edge = crossed_halfedge(vertex_on(h, i));
    return is_first_side(h) ? crossed_edge : twin_index(crossed_edge);
  }

  void add_arc(Halfedge_index h, Index i, Overlay_halfedge& from_h, Halfedge_index g, Index j, Overlay_halfedge& from_g)
  {
    CGAL_assertion(crossed_edge_on(h, i) == twin_index(crossed_edge_on(g, j)));
    from_h = next_new_halfedge();
    from_g = twin(from_h);
    add_edge(vertex_on(h, i), vertex_on(g, j), null_index, crossed_edge_on(h, i));
  }

  void link_along(Halfedge_index h, const std::vector<Overlay_halfedge>& inward)
  {
    for(std::size_t i = 0; i < inward.size(); ++i) {
      m_next[piece(h, static_cast<Index>(i))] = inward[i];
      m_next[twin(inward[i])] = piece(h, static_cast<Index>(i) + 1);
    }
  }

  // Sets the origin of all halfedges that start in the fan of h: clockwise as far as possible, then counterclockwise.
  void take_fan(Overlay_halfedge h, Overlay_vertex own, Per_overlay_halfedge<char>& is_done)
  {
    Overlay_halfedge g = h;
    do {
      is_done[g] = 1;
      m_origin[g] = own;
      const Overlay_halfedge t = twin(previous(g)); // counterclockwise
      m_origin[t] = own;
      g = t;
    } while(g != h && !is_border(g));
    if(g == h)
      return;
    for(g = twin(h); !is_border(g); g = twin(next(g))) {
      is_done[next(g)] = 1;
      m_origin[next(g)] = own;
    }
  }

  const Triangulation* m_triangulation;
  Index m_number_of_vertices = 0, m_end_of_crossings = 0;
  std::vector<Index> m_first_crossing; // per intrinsic edge, and the end
  std::vector<Input_halfedge_index> m_crossed_edges;
  Per_overlay_halfedge<Overlay_halfedge> m_next, m_previous;
  Per_overlay_halfedge<Overlay_vertex> m_origin;
  std::vector<Halfedge_index> m_intrinsic;   // per edge: along which its first halfedge runs
  std::vector<Input_halfedge_index> m_input; // likewise for the input
  // The second halves of split edges' first halfedges, and the replacements of halfedges that a cut put on the border.
  std::unordered_map<Overlay_halfedge, Overlay_halfedge> m_second_halves, m_doubles;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_H
