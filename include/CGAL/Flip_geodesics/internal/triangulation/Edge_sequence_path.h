// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_SEQUENCE_PATH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_SEQUENCE_PATH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * A path on the input surface as the sequence of input edges that it crosses, composed of pieces. Shortened without
 * passing a vertex, it has the edge sequence returned by `finish()`: the free reduction, minus the crossed edges that
 * touch the ends. An input vertex touches its incident edges, a point of an edge that edge, a point inside a face none.
 *
 * A crossed edge (`Letter`) is an input halfedge, or a type that is made from one, converts to it and carries more
 * data.
 */
template <class Triangulation, class Letter = Input_halfedge_index>
class Edge_sequence_path
{
public:
  /* Starts a path at a vertex, into the input face of its anchor. The memory of an old sequence can be reused. */
  Edge_sequence_path(const Triangulation& triangulation, Vertex_index start, Input_halfedge_index start_anchor,
                     std::vector<Letter> memory = {})
    : m_triangulation(triangulation)
    , m_start(start)
    , m_start_anchor(start_anchor)
    , m_crossed_edges(std::move(memory))
  {
    m_crossed_edges.clear();
  }

  void cross(Input_halfedge_index crossed_edge)
  {
    if(is_taken_back(crossed_edge))
      m_crossed_edges.pop_back();
    else
      m_crossed_edges.push_back(crossed_edge);
  }

  /* Crosses a range of an edge sequence. Since the range is reduced, edges cancel only where the two sequences meet. */
  void cross(const std::vector<Letter>& crossed_edges, std::size_t first, std::size_t last)
  {
    for(; first < last && is_taken_back(Input_halfedge_index(crossed_edges[first])); ++first)
      m_crossed_edges.pop_back();
    const auto begin = crossed_edges.begin();
    m_crossed_edges.insert(m_crossed_edges.end(), begin + static_cast<std::ptrdiff_t>(first),
                           begin + static_cast<std::ptrdiff_t>((std::max)(first, last)));
  }

  /* Crosses the edges of a sequence, or of its reverse. */
  void cross(const Edge_sequence& sequence, bool is_reversed)
  {
    if(!is_reversed)
      return cross(sequence.crossed, 0, sequence.crossed.size());
    std::size_t last = sequence.crossed.size();
    for(; last > 0 && is_taken_back(twin_index(sequence.crossed[last - 1])); --last)
      m_crossed_edges.pop_back();
    m_crossed_edges.reserve(m_crossed_edges.size() + last);
    for(; last > 0; --last)
      m_crossed_edges.push_back(twin_index(sequence.crossed[last - 1]));
  }

  /* Turns clockwise around vertex v across a number of input edges, beginning with the one in the direction of
   * `outgoing_halfedge`. */
  void turn(Vertex_index v, Input_halfedge_index outgoing_halfedge, Index number)
  {
    for(Index i = 0; i < number; ++i) {
      cross(outgoing_halfedge);
      const Input_halfedge_index t = twin_index(outgoing_halfedge);
      outgoing_halfedge = m_triangulation.is_inserted(v) ? t : m_triangulation.input().next(t);
    }
  }

  /* Returns the edge sequence of the shortened path, which ends at a vertex in the input face of its anchor; leaves the
   * path empty. */
  Edge_sequence finish(Vertex_index end, Input_halfedge_index end_anchor)
  {
    Edge_sequence sequence = trim(end, end_anchor);
    sequence.crossed = take_crossed_edges();
    return sequence;
  }

  /* Drops the crossed edges that touch the ends of a path that ends as for `finish()`. Returns the sequence without its
   * edges. */
  Edge_sequence trim(Vertex_index end, Input_halfedge_index end_anchor)
  {
    Input_halfedge_index first_anchor = m_start_anchor, last_anchor = end_anchor;
    auto first = m_crossed_edges.begin(), last = m_crossed_edges.end();
    for(; first != last && touches(m_start, first_anchor, Input_halfedge_index(*first)); ++first)
      first_anchor = across(m_start, Input_halfedge_index(*first), first_anchor);
    for(; first != last && touches(end, last_anchor, twin_index(Input_halfedge_index(*(last - 1)))); --last)
      last_anchor = across(end, twin_index(Input_halfedge_index(*(last - 1))), last_anchor);
    const auto skipped = first - m_crossed_edges.begin();
    m_crossed_edges.erase(last, m_crossed_edges.end()); // invalidates `first` if no edge remains
    m_crossed_edges.erase(m_crossed_edges.begin(), m_crossed_edges.begin() + skipped);
    Edge_sequence sequence;
    sequence.tail = m_start;
    sequence.head = end;
    if(m_crossed_edges.empty())
      place_in_face(first_anchor, last_anchor, sequence);
    return sequence;
  }

  /* Moves the crossed edges out. */
  std::vector<Letter> take_crossed_edges() { return std::move(m_crossed_edges); }

private:
  const auto& input() const { return m_triangulation.input(); }

  // Returns whether crossing an edge cancels the last crossing.
  bool is_taken_back(Input_halfedge_index crossed_edge) const
  {
    return !m_crossed_edges.empty() && Input_halfedge_index(m_crossed_edges.back()) == twin_index(crossed_edge);
  }

  // Returns whether a side of the anchor's face touches the vertex.
  bool touches(Vertex_index v, Input_halfedge_index anchor, Input_halfedge_index side) const
  {
    switch(vertex_kind(m_triangulation, v)) {
    case Location_kind::VERTEX:
      return side != input().next(anchor);
    case Location_kind::EDGE:
      return side == anchor;
    case Location_kind::FACE:
      return false;
    }
    return false;
  }

  // The anchor in the face on the other side of a side that touches the vertex.
  Input_halfedge_index across(Vertex_index v, Input_halfedge_index side, Input_halfedge_index anchor) const
  {
    const Input_halfedge_index t = twin_index(side);
    return !m_triangulation.is_inserted(v) && side == anchor ? input().next(t) : t;
  }

  // A path that crosses nothing runs along an input edge or through the interior of a face.
  void place_in_face(Input_halfedge_index k, Input_halfedge_index l, Edge_sequence& sequence) const
  {
    const Location_kind at_k = vertex_kind(m_triangulation, sequence.tail);
    const Location_kind at_l = vertex_kind(m_triangulation, sequence.head);
    if(at_k == Location_kind::VERTEX && at_l == Location_kind::VERTEX)
      sequence.along = input().next(k) == l ? k : twin_index(l);
    else if(at_k == Location_kind::VERTEX && at_l == Location_kind::EDGE && l != input().next(k))
      sequence.along = l == k ? k : twin_index(l);
    else if(at_k == Location_kind::EDGE && at_l == Location_kind::VERTEX && k != input().next(l))
      sequence.along = k == l ? twin_index(k) : k;
    else if(at_k == Location_kind::EDGE && at_l == Location_kind::EDGE && k == l)
      sequence.along = is_before(sequence.tail, sequence.head, k) ? k : twin_index(k);
    else
      sequence.face = k;
  }

  // Returns whether the first of two points of an input edge is nearer to the tail of halfedge h.
  bool is_before(Vertex_index v, Vertex_index w, Input_halfedge_index h) const
  {
    const auto a = vertex_weights(m_triangulation, v, h), b = vertex_weights(m_triangulation, w, h);
    const auto n = to_integers<4>({{a[0], a[1], b[0], b[1]}});
    return n[1] * n[2] < n[3] * n[0];
  }

  const Triangulation& m_triangulation;
  Vertex_index m_start;
  Input_halfedge_index m_start_anchor;
  std::vector<Letter> m_crossed_edges;
};

/*
 * Traces the edge sequence of an edge in the current triangulation, by integers alone [after GSC21, section 3]: the
 * numbers of input edges that cross each edge determine how these continue in each triangle.
 *
 * Two input edges crossed consecutively by an edge are sides of one input face and therefore meet at a vertex on its
 * left or on its right. They meet on the left if they stay adjacent, triangle by triangle, and finally emanate from one
 * corner; if they part before, they meet on the right. Bundles of adjacent input edges are therefore followed, and
 * split where they part:
 *
 *            m                 from side x, whose face is on its left, a bundle continues around k or around l,
 *           /|\                or ends at m
 *          / | \
 *         /  |. .\
 *        k ---x---> l
 *
 * This determines the crossed edges one after the other, starting with the first one, which follows from the input
 * corner in which the edge starts. That corner is found by counting from an edge that has never been flipped.
 */
template <class Triangulation>
class Edge_sequence_tracer
{
public:
  explicit Edge_sequence_tracer(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /*
   * Computes the edge sequence of halfedge h. Returns false if no edge at its tail is the input's any more, so the
   * sequence must be derived otherwise. Linear in the degree of the tail and in the number of triangles that bundles
   * pass. \pre no point was inserted
   */
  bool operator()(Halfedge_index h, Edge_sequence& sequence)
  {
    const Input_halfedge_index outgoing_halfedge = outgoing_halfedge_before(h);
    if(outgoing_halfedge == null_index)
      return false;
    sequence.tail = m_triangulation.tail(h);
    sequence.head = m_triangulation.head(h);
    sequence.face = null_index;
    const Index number = crossings(h);
    sequence.along = number == 0 ? outgoing_halfedge : null_index;
    sequence.crossed.assign(static_cast<std::size_t>(number), meets_on_right); // placeholders for the crossed edges
    if(number == 0)
      return true;
    find_meetings_on_left(h, sequence.crossed);
    Input_halfedge_index crossed = input().next(outgoing_halfedge);
    for(Input_halfedge_index& crossed_edge : sequence.crossed) {
      const bool is_left_kept = crossed_edge == meets_on_left;
      crossed_edge = crossed;
      const Input_halfedge_index right_side = input().next(twin_index(crossed));
      crossed = is_left_kept ? input().next(right_side) : right_side;
    }
    return true;
  }

private:
  // The side on which an input edge meets the next one that is crossed.
  static constexpr Input_halfedge_index meets_on_right{0}, meets_on_left{1};

  // Input edges that cross side `halfedge` consecutively, numbered from its tail, and continue into the face on its
  // left; the first of them is crossed edge number `letter` of the sequence.
  struct Bundle
  {
    Halfedge_index halfedge;
    Index first, crossed_edge, size;
  };

  const auto& input() const { return m_triangulation.input(); }

  Index crossings(Halfedge_index h) const { return number_of_crossings(m_triangulation, h); }

  bool is_along(Halfedge_index h) const { return m_triangulation.crossings(Triangulation::edge(h)) < 0; }

  // The input halfedge at the tail of h along which h lies, or else the first one clockwise; null_index if unknown.
  Input_halfedge_index outgoing_halfedge_before(Halfedge_index h) const
  {
    Index passed = is_along(h) ? 1 : 0;
    for(Halfedge_index g = h; m_triangulation.version(Triangulation::edge(g)) != 0;) {
      const Halfedge_index t = Triangulation::twin(g), on = m_triangulation.next(t);
      passed += Triangle_crossings(crossings(m_triangulation.next(on)), crossings(t), crossings(on)).emanating[0];
      if(on == h)
        return null_index;
      g = on;
      if(m_triangulation.version(Triangulation::edge(g)) == 0)
        return turned(as_input(g), passed);
      passed += is_along(g) ? 1 : 0;
    }
    return as_input(h);
  }

  // Returns input halfedge h turned counterclockwise over a number of input corners.
  Input_halfedge_index turned(Input_halfedge_index h, Index number) const
  {
    for(; number > 0; --number)
      h = twin_index(input().next(input().next(h)));
    return h;
  }

  void find_meetings_on_left(Halfedge_index h, std::vector<Input_halfedge_index>& meetings)
  {
    m_bundles.reserve(16);
    m_bundles.push_back({h, 0, 0, crossings(h)});
    while(!m_bundles.empty()) {
      const Bundle bundle = m_bundles.back();
      m_bundles.pop_back();
      follow(bundle, meetings);
    }
  }

  void follow(const Bundle& bundle, std::vector<Input_halfedge_index>& meetings)
  {
    const Halfedge_index x = bundle.halfedge, to_m = m_triangulation.next(x), to_k = m_triangulation.next(to_m);
    const Index number = crossings(x), number_at_l = crossings(to_m);
    const Triangle_crossings passing(number_at_l, crossings(to_k), number); // corners k, l, m
    const auto clamped = [&](Index i) { return (std::min)((std::max)(i - bundle.first, 0), bundle.size); };
    const Index around_k = clamped(passing.cutting[0]);
    const Index up_to_m = clamped(passing.cutting[0] + passing.emanating[2]);
    for(Index i = around_k; i + 1 < up_to_m; ++i)
      meetings[static_cast<std::size_t>(bundle.crossed_edge + i)] = meets_on_left;
    if(around_k > 1)
      m_bundles.push_back({Triangulation::twin(to_k), bundle.first, bundle.crossed_edge, around_k});
    if(bundle.size - up_to_m > 1)
      m_bundles.push_back({Triangulation::twin(to_m), bundle.first + up_to_m + number_at_l - number,
                           bundle.crossed_edge + up_to_m, bundle.size - up_to_m});
  }

  const Triangulation& m_triangulation;
  std::vector<Bundle> m_bundles; // still to be followed
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_SEQUENCE_PATH_H
