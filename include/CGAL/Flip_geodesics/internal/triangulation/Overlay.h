// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

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
        assign(h, least_in_face(m_triangulation->input(), input_halfedge(h)));
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
      if(least_in_face(*m_triangulation, h) == h)
        link_triangle({h, m_triangulation->next(h), m_triangulation->previous(h)});
    }
  }

  /*
   * Side i leads from corner i+1 to corner i+2, so corner i is where side i+1 ends and side i+2 starts. Along a
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

/*
 * The rounded positions of the vertices of an overlay: crossings along their two edges, and the corners of polygons in
 * their input faces.
 *
 * Crossings are measured in the strip of their intrinsic edge, each separately, so rounding errors may exchange
 * two close ones on one input edge. The overlay has their exact order, to which the positions are made monotone.
 */
template <class Triangulation>
class Overlay_layout
{
public:
  using Overlay = internal::Overlay<Triangulation>;
  using Weights = std::array<double, 3>;
  using Point_2 = std::array<double, 2>;

  /* Measures an overlay in which no edge is dissolved yet. */
  explicit Overlay_layout(const Overlay& overlay)
    : m_overlay(&overlay)
    , m_faces(overlay.input_faces())
  {
    measure_crossings();
    raise_to_order();
    find_intrinsic_faces();
    m_weights.resize(m_faces.size());
    for(Overlay_halfedge h : overlay.halfedges())
      if(!overlay.is_border(h))
        m_weights[h] = measure_corner(h);
  }

  /* Returns the position of a crossing on its input edge, from 0 at the tail of `crossed_halfedge(v)` to 1 at the
   * head. */
  double on_input(Overlay_vertex v) const { return m_crossings[number(v)].on_input; }
  /* Returns the position of a crossing on its intrinsic edge, from 0 at the tail of the first halfedge to 1 at the
   * head. */
  double on_intrinsic(Overlay_vertex v) const { return m_crossings[number(v)].on_intrinsic; }

  /* Returns the first halfedge of that intrinsic edge. */
  Halfedge_index intrinsic_halfedge(Overlay_vertex v) const { return m_crossings[number(v)].intrinsic_halfedge; }

  /* Returns the smallest halfedge of the intrinsic face that contains the polygon of h, or null_index if polygons were
   * merged. */
  Halfedge_index intrinsic_face(Overlay_halfedge h) const
  {
    return m_intrinsic_faces.empty() ? Halfedge_index() : m_intrinsic_faces[h];
  }
  /* Must be called when polygons of different intrinsic faces are merged. */
  void forget_intrinsic_faces() { m_intrinsic_faces.clear(); }

  /* Returns the smallest halfedge of the input face that contains the polygon of h. */
  Input_halfedge_index face(Overlay_halfedge h) const { return m_faces[h]; }
  /* Returns the origin of h in that face: barycentric coordinates for the tails of that halfedge and the next two. */
  const Weights& weights(Overlay_halfedge h) const { return m_weights[h]; }

  /* Accounts for a diagonal that was added to the overlay from the origin of a to that of b. */
  void add_diagonal(Overlay_halfedge a, Overlay_halfedge b)
  {
    m_faces.insert(m_faces.end(), 2, m_faces[a]);
    if(!m_intrinsic_faces.empty())
      m_intrinsic_faces.insert(m_intrinsic_faces.end(), 2, m_intrinsic_faces[a]);
    const Weights from = m_weights[a], to = m_weights[b];
    m_weights.insert(m_weights.end(), {from, to});
  }

  /* Accounts for the joining of h and the edge after it. Must be called beforehand. */
  void join(Overlay_halfedge h) { m_weights[Overlay::twin(h)] = m_weights[Overlay::twin(m_overlay->next(h))]; }

  /* Accounts for an edge that was cut: the new edge replaces t, the twin of h. */
  void add_cut(Overlay_halfedge t)
  {
    m_faces.insert(m_faces.end(), {m_faces[t], null_index});
    if(!m_intrinsic_faces.empty())
      m_intrinsic_faces.insert(m_intrinsic_faces.end(), {m_intrinsic_faces[t], null_index});
    const Weights weights = m_weights[t];
    m_weights.insert(m_weights.end(), {weights, weights});
  }

  /*
   * Splits the edge of h, between two triangles or on the border, at its midpoint, as the overlay does. \pre the
   * overlay is triangulated, and its vertices have not been split yet
   */
  void split(Overlay& overlay, Overlay_halfedge h)
  {
    CGAL_precondition(m_intrinsic_faces.empty());
    h = is_first_side(h) ? h : Overlay::twin(h);
    const Overlay_halfedge t = Overlay::twin(h);
    std::array<Side, 2> sides;
    for(const Overlay_halfedge side : {h, t})
      if(!overlay.is_border(side))
        sides[is_first_side(side) ? 0 : 1] = {m_faces[side], middle_of(side), m_weights[overlay.previous(side)]};
    add_midpoint(h, sides[overlay.is_border(h) ? 1 : 0]);
    overlay.split(h);
    add_edge(sides[0].face, sides[0].middle, sides[1].face, m_weights[t]);
    m_weights[t] = sides[1].middle;
    for(const Side& side : sides)
      if(side.face != null_index)
        add_edge(side.face, side.middle, side.face, side.apex);
  }

  /* A vertex added by split(), with the first halfedge of the intrinsic edge that contains it and its position there;
   * the halfedge is null if there is none. */
  struct Midpoint
  {
    Surface_point on_input;
    Halfedge_index intrinsic_halfedge;
    double on_intrinsic;
  };

  const Midpoint& midpoint(Overlay_vertex v) const { return m_midpoints[number(v) - m_crossings.size()]; }

  /* The corners of an input face in the plane, with the tail of f at the origin. */
  std::array<Point_2, 3> corners(Input_halfedge_index f) const
  {
    const auto vectors = input_face_geometry(triangulation(), f);
    return {{{0, 0}, {vectors[0].x, vectors[0].y}, {-vectors[2].x, -vectors[2].y}}};
  }

  static Point_2 point(const std::array<Point_2, 3>& corners, const Weights& w)
  {
    return {w[1] * corners[1][0] + w[2] * corners[2][0], w[1] * corners[1][1] + w[2] * corners[2][1]};
  }

private:
  struct Crossing
  {
    double on_input, on_intrinsic;
    Halfedge_index intrinsic_halfedge;
  };

  // The elements on one side of an edge that is split.
  struct Side
  {
    Input_halfedge_index face;
    Weights middle = {{0, 0, 0}}, apex = {{0, 0, 0}};
  };

  const Triangulation& triangulation() const { return m_overlay->triangulation(); }

  Weights middle_of(Overlay_halfedge h) const
  {
    const Weights &p = m_weights[h], &q = m_weights[m_overlay->next(h)];
    return {{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}};
  }

  void add_edge(Input_halfedge_index face, const Weights& from, Input_halfedge_index face_of_twin, const Weights& to)
  {
    m_faces.insert(m_faces.end(), {face, face_of_twin});
    m_weights.insert(m_weights.end(), {from, to});
  }

  void add_midpoint(Overlay_halfedge h, const Side& side)
  {
    const auto& input = triangulation().input();
    const Input_halfedge_index f = side.face, fn = input.next(f), along = m_overlay->input_halfedge(h);
    const Halfedge_index intrinsic = m_overlay->intrinsic_halfedge(h);
    const Overlay_vertex from = m_overlay->origin(h), to = m_overlay->target(h);
    const double first = m_overlay->is_crossing(from) ? on_intrinsic(from) : 0,
                 last = m_overlay->is_crossing(to) ? on_intrinsic(to) : 1;
    m_midpoints.push_back({surface_point({{input.tail(f), input.tail(fn), input.tail(input.next(fn))}}, side.middle,
                                         along == null_index ? f : along),
                           intrinsic, (first + last) / 2});
  }

  std::size_t number(Overlay_vertex v) const
  {
    return static_cast<std::size_t>(v.idx() - triangulation().number_of_vertices());
  }

  // Each polygon has a piece of an intrinsic edge among its sides.
  void find_intrinsic_faces()
  {
    m_intrinsic_faces.assign(m_faces.size(), null_index);
    m_overlay->for_each_polygon([&](Overlay_halfedge h) {
      Overlay_halfedge piece = h;
      while(m_overlay->intrinsic_halfedge(piece) == null_index)
        piece = m_overlay->next(piece);
      const Halfedge_index face = least_in_face(triangulation(), m_overlay->intrinsic_halfedge(piece));
      m_overlay->for_each_side(h, [&](Overlay_halfedge s) { m_intrinsic_faces[s] = face; });
    });
  }

  void measure_crossings()
  {
    for(Edge_index e : descriptors<Edge_index>(triangulation().number_of_edges())) {
      if(m_overlay->crossings(e) == 0)
        continue;
      const Strip<Triangulation> strip(triangulation(), triangulation().edge_sequence(first_side(e)));
      double along = 0;
      for(std::size_t i = 0; i < strip.portals().size(); ++i) {
        along = (std::max)(along, strip.crossing_along(i));
        m_crossings.push_back({strip.crossing(i), along, first_side(e)});
      }
    }
  }

  void raise_to_order()
  {
    for(Overlay_halfedge h : m_overlay->halfedges()) {
      const Input_halfedge_index c = m_overlay->input_halfedge(h);
      if(c == null_index || !is_first_side(c) || m_overlay->is_crossing(m_overlay->origin(h)))
        continue;
      double reached = position_on_side(Vertex_index(m_overlay->origin(h).idx()));
      for(Overlay_halfedge arc = h; m_overlay->is_crossing(m_overlay->target(arc)); arc = m_overlay->next_arc(arc)) {
        const Overlay_vertex v = m_overlay->target(arc);
        const bool is_along = m_overlay->crossed_halfedge(v) == c;
        double& t = m_crossings[number(v)].on_input;
        reached = (std::max)(reached, is_along ? t : 1 - t);
        if(reached > (is_along ? t : 1 - t))
          t = is_along ? reached : 1 - reached;
      }
    }
  }

  // The position of a vertex of the triangulation on the input edge that it starts or divides, from 0 at the tail of
  // the edge's first halfedge. Surface points refer to that halfedge unless it is on the border, where there are no
  // crossings.
  double position_on_side(Vertex_index v) const
  {
    if(!triangulation().is_inserted(v))
      return 0;
    const Surface_location at = triangulation().location(v);
    return at.weights[1] / (at.weights[0] + at.weights[1]);
  }

  // The origin of h lies on a side of the input face, which follows from the edge along which h runs, or is an inserted
  // vertex.
  Weights measure_corner(Overlay_halfedge h) const
  {
    const auto& input = triangulation().input();
    const Overlay_vertex v = m_overlay->origin(h);
    const Input_halfedge_index along = m_overlay->input_halfedge(h);
    if(!m_overlay->is_crossing(v)) {
      const bool is_told_by_crossing = along != null_index || m_overlay->is_crossing(m_overlay->target(h));
      if(triangulation().is_inserted(Vertex_index(v.idx())) || !is_told_by_crossing)
        return divided_by_sum(vertex_weights(triangulation(), Vertex_index(v.idx()), m_faces[h]));
      const Input_halfedge_index corner = along != null_index ? along : input.next(input.next(leaving_through(h)));
      return weights_on_side(input, m_faces[h], corner, 0);
    }
    const Input_halfedge_index crossed = m_overlay->crossed_halfedge(v);
    const double t = on_input(v);
    if(along != null_index)
      return weights_on_side(input, m_faces[h], along, along == crossed ? t : 1 - t);
    const bool is_entering = is_first_side(m_overlay->intrinsic_halfedge(h)); // the face beyond the crossed edge
    return weights_on_side(input, m_faces[h], is_entering ? twin_index(crossed) : crossed, is_entering ? 1 - t : t);
  }

  // The side of the face through which an intrinsic edge that starts at a corner leaves it.
  Input_halfedge_index leaving_through(Overlay_halfedge h) const
  {
    const Input_halfedge_index crossed = m_overlay->crossed_halfedge(m_overlay->target(h));
    return is_first_side(m_overlay->intrinsic_halfedge(h)) ? crossed : twin_index(crossed);
  }

  const Overlay* m_overlay;
  Per_overlay_halfedge<Input_halfedge_index> m_faces;
  Per_overlay_halfedge<Halfedge_index> m_intrinsic_faces;
  Per_overlay_halfedge<Weights> m_weights;
  std::vector<Crossing> m_crossings;
  std::vector<Midpoint> m_midpoints;
};

/*
 * Triangulates the polygons of an overlay, which are convex up to rounding errors, by diagonals. Dynamic programming
 * finds the triangulation whose worst triangle is best [K80].
 *
 * No diagonal connects two vertices of one straight line, that is, of a run of sides along one edge. Labels decide
 * this, not positions, so that the result has no double edges, whatever the rounding errors are.
 */
template <class Triangulation>
class Polygon_triangulator
{
  using Overlay = internal::Overlay<Triangulation>;
  using Layout = Overlay_layout<Triangulation>;
  using Point_2 = typename Layout::Point_2;

public:
  Polygon_triangulator(Overlay& overlay, Layout& layout)
    : m_overlay(overlay)
    , m_layout(layout)
  {
  }

  /* Triangulates all polygons in time cubic in the number of sides of each, which is rarely more than six. */
  void operator()()
  {
    std::vector<Overlay_halfedge> polygons;
    m_overlay.for_each_polygon([&](Overlay_halfedge h) { polygons.push_back(h); });
    for(Overlay_halfedge h : polygons)
      triangulate(h);
  }

private:
  // Larger polygons are halved first; their many vertices lie on straight lines.
  static constexpr std::size_t largest = 32;

  void triangulate(Overlay_halfedge h)
  {
    std::vector<Overlay_halfedge> sides;
    m_overlay.for_each_side(h, [&](Overlay_halfedge side) { sides.push_back(side); });
    if(sides.size() <= 3)
      return;
    find_runs(sides);
    if(sides.size() > largest && halve(sides))
      return;
    m_points.clear();
    const auto corners = m_layout.corners(m_layout.face(h));
    for(Overlay_halfedge side : sides)
      m_points.push_back(Layout::point(corners, m_layout.weights(side)));
    find_best(sides.size());
    add_diagonals(sides, 0, sides.size() - 1, sides.back());
  }

  bool is_on_one_line(Overlay_halfedge side, Overlay_halfedge other) const
  {
    const Input_halfedge_index input = m_overlay.input_halfedge(side);
    const Halfedge_index intrinsic = m_overlay.intrinsic_halfedge(side);
    return (input != null_index && input == m_overlay.input_halfedge(other)) ||
           (intrinsic != null_index && intrinsic == m_overlay.intrinsic_halfedge(other));
  }

  // Computes for each side the number of consecutive sides on one line, starting with it.
  void find_runs(const std::vector<Overlay_halfedge>& sides)
  {
    const std::size_t n = sides.size();
    m_runs.assign(n, 1);
    for(std::size_t i = 0; i < n; ++i)
      while(m_runs[i] < n && is_on_one_line(sides[i], sides[(i + m_runs[i]) % n]))
        ++m_runs[i];
  }

  bool is_diagonal(std::size_t i, std::size_t j) const // i < j
  {
    return m_runs[i] < j - i && m_runs[j] < m_runs.size() - (j - i);
  }

  bool halve(const std::vector<Overlay_halfedge>& sides)
  {
    const std::size_t n = sides.size(), half = n / 2;
    for(std::size_t i = 0; i < n - half; ++i)
      if(is_diagonal(i, i + half)) {
        const Overlay_halfedge d = add_diagonal(sides[i], sides[i + half]);
        triangulate(d);
        triangulate(Overlay::twin(d));
        return true;
      }
    return false;
  }

  // m_best of (i, j) is the quality of the worst triangle of the best triangulation of the vertices i to j.
  void find_best(std::size_t n)
  {
    constexpr double none = -std::numeric_limits<double>::infinity();
    m_best.assign(n * n, none);
    m_apex.assign(n * n, 0);
    for(std::size_t i = 0; i + 1 < n; ++i)
      m_best[i * n + i + 1] = (std::numeric_limits<double>::max)();
    for(std::size_t width = 2; width < n; ++width)
      for(std::size_t i = 0; i + width < n; ++i) {
        const std::size_t j = i + width;
        if(width + 1 < n && !is_diagonal(i, j))
          continue;
        for(std::size_t k = i + 1; k < j; ++k) {
          const double worst = (std::min)({m_best[i * n + k], m_best[k * n + j], quality(i, k, j)});
          if(worst > m_best[i * n + j] || m_apex[i * n + j] == 0) {
            m_best[i * n + j] = worst;
            m_apex[i * n + j] = k;
          }
        }
      }
  }

  // Twice the area over the sum of the squared sides; negative if rounding errors have turned the triangle over.
  double quality(std::size_t i, std::size_t j, std::size_t k) const
  {
    const auto difference = [](const Point_2& p, const Point_2& q) { return Point_2{q[0] - p[0], q[1] - p[1]}; };
    const auto square = [](const Point_2& v) { return v[0] * v[0] + v[1] * v[1]; };
    const Point_2 u = difference(m_points[i], m_points[j]), v = difference(m_points[i], m_points[k]);
    const double sum = square(u) + square(v) + square(difference(m_points[j], m_points[k]));
    return sum > 0 ? (u[0] * v[1] - u[1] * v[0]) / sum : 0;
  }

  // Sides i to j - 1 and `closing`, which leads from vertex j to vertex i, form a polygon of the overlay.
  void add_diagonals(const std::vector<Overlay_halfedge>& sides, std::size_t i, std::size_t j, Overlay_halfedge closing)
  {
    if(j - i < 2)
      return;
    const std::size_t k = m_apex[i * sides.size() + j];
    if(k - i > 1)
      add_diagonals(sides, i, k, Overlay::twin(add_diagonal(sides[i], sides[k])));
    if(j - k > 1)
      add_diagonals(sides, k, j, Overlay::twin(add_diagonal(sides[k], closing)));
  }

  Overlay_halfedge add_diagonal(Overlay_halfedge a, Overlay_halfedge b)
  {
    const Overlay_halfedge d = m_overlay.add_diagonal(a, b);
    m_layout.add_diagonal(a, b);
    return d;
  }

  Overlay& m_overlay;
  Layout& m_layout;
  std::vector<Point_2> m_points;
  std::vector<std::size_t> m_runs, m_apex;
  std::vector<double> m_best;
};

/*
 * Constructs a MutableFaceGraph from an overlay, link by link, so that no searches are needed and edges with common end
 * vertices are supported. The elements of the mesh are created in the order of those of the overlay.
 */
template <class Triangulation, class OutputMesh>
class Overlay_to_mesh
{
  using Overlay = internal::Overlay<Triangulation>;
  using Graph = boost::graph_traits<OutputMesh>;

public:
  using vertex_descriptor = typename Graph::vertex_descriptor;
  using halfedge_descriptor = typename Graph::halfedge_descriptor;
  using face_descriptor = typename Graph::face_descriptor;

  Overlay_to_mesh(const Overlay& overlay, OutputMesh& mesh)
    : m_overlay(overlay)
    , m_mesh(mesh)
    , m_vertices(static_cast<std::size_t>(overlay.number_of_vertices()), Graph::null_vertex())
    , m_halfedges(static_cast<std::size_t>(overlay.number_of_halfedges()), Graph::null_halfedge())
  {
    create_vertices();
    create_edges();
    create_faces();
    link_border();
  }

  /* Returns the mesh's vertex for a vertex of the overlay, or the null vertex if it was dissolved. */
  vertex_descriptor vertex(Overlay_vertex v) const { return m_vertices[v]; }
  /* Returns the mesh's halfedge for a halfedge of the overlay, or the null halfedge if it was dissolved. */
  halfedge_descriptor halfedge(Overlay_halfedge h) const { return m_halfedges[h]; }

private:
  // Creates all but the crossings and inserted vertices that were dissolved.
  void create_vertices()
  {
    Per_overlay_vertex<char> is_used(m_vertices.size(), 0);
    for(Overlay_halfedge h : m_overlay.halfedges())
      if(m_overlay.is_alive(h))
        is_used[m_overlay.origin(h)] = 1;
    for(Overlay_vertex v : m_overlay.vertices())
      if(is_used[v] != 0 || m_overlay.is_input_vertex(v)) {
        m_vertices[v] = add_vertex(m_mesh);
        set_halfedge(m_vertices[v], Graph::null_halfedge(), m_mesh);
      }
  }

  void create_edges()
  {
    for(Overlay_halfedge h : m_overlay.halfedges()) {
      if(!is_first_side(h) || !m_overlay.is_alive(h))
        continue;
      const Overlay_halfedge t = Overlay::twin(h);
      m_halfedges[h] = graph_halfedge(add_edge(m_mesh), m_mesh);
      m_halfedges[t] = opposite(m_halfedges[h], m_mesh);
      set_target(m_halfedges[h], m_vertices[m_overlay.target(h)], m_mesh);
      set_target(m_halfedges[t], m_vertices[m_overlay.origin(h)], m_mesh);
    }
  }

  void create_faces()
  {
    m_overlay.for_each_polygon([&](Overlay_halfedge h) {
      const face_descriptor f = add_face(m_mesh);
      set_halfedge(f, m_halfedges[h], m_mesh);
      m_overlay.for_each_side(h, [&](Overlay_halfedge side) {
        set_face(m_halfedges[side], f, m_mesh);
        set_next(m_halfedges[side], m_halfedges[m_overlay.next(side)], m_mesh);
        set_halfedge(m_vertices[m_overlay.target(side)], m_halfedges[side], m_mesh);
      });
    });
  }

  // Vertices on the border refer to a halfedge there, as `Surface_mesh` requires.
  void link_border()
  {
    for(Overlay_halfedge h : m_overlay.halfedges()) {
      if(!m_overlay.is_alive(h) || !m_overlay.is_border(h))
        continue;
      Overlay_halfedge after = Overlay::twin(h); // turns around the target of h
      while(!m_overlay.is_border(after))
        after = Overlay::twin(m_overlay.previous(after));
      set_face(m_halfedges[h], Graph::null_face(), m_mesh);
      set_next(m_halfedges[h], m_halfedges[after], m_mesh);
      set_halfedge(m_vertices[m_overlay.target(h)], m_halfedges[h], m_mesh);
    }
  }

  const Overlay& m_overlay;
  OutputMesh& m_mesh;
  Per_overlay_vertex<vertex_descriptor> m_vertices;
  Per_overlay_halfedge<halfedge_descriptor> m_halfedges;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_H
