// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_ITERATIVE_UNFOLDING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_ITERATIVE_UNFOLDING_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_sequence_path.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Input_faces.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* The face in which an edge sequence ends, given by one of its halfedges. If the sequence runs along an edge, it is the
 * face on the left. */
template <class Input_mesh>
Input_halfedge_index face_along(const Input_mesh& input, Input_halfedge_index along)
{
  return input.is_border(along) ? twin_index(along) : along;
}

/* The halfedge of the first face of an edge sequence relative to which its tail is given there, see `anchor()`. */
template <class Triangulation>
Input_halfedge_index first_anchor(const Triangulation& triangulation, const Edge_sequence_end& tail)
{
  return tail.along == null_index ? tail_anchor(triangulation, tail)
                                  : anchor(triangulation, tail.vertex, face_along(triangulation.input(), tail.along));
}

/* The halfedge of the last face of an edge sequence relative to which its head is given there, see `anchor()`. */
template <class Triangulation>
Input_halfedge_index last_anchor(const Triangulation& triangulation, const Edge_sequence_end& head)
{
  return head.along == null_index
             ? tail_anchor(triangulation, head)
             : anchor(triangulation, head.vertex, face_along(triangulation.input(), twin_index(head.along)));
}

/*
 * Extends a path of edge sequences around a vertex of the input from one face to another, each given by its halfedge
 * that starts at the vertex. Returns false at the border, after which the path must be discarded.
 */
template <class Input_mesh, class Path>
bool turn(const Input_mesh& input, Path& path, Input_halfedge_index from, Input_halfedge_index to, bool is_clockwise)
{
  while(from != to) {
    const Input_halfedge_index crossed_edge = is_clockwise ? from : input.previous(from),
                               entered = twin_index(crossed_edge);
    if(input.is_border(entered))
      return false;
    path.cross(crossed_edge);
    from = is_clockwise ? input.next(entered) : entered;
  }
  return true;
}

/* The side of a joint on which a path is led around it, if any. */
enum class Passed_side { LEFT, RIGHT, NONE };

/*
 * Shortens a path on the input mesh, which is only read, by iterative unfolding [XW07]: the path is shortened within
 * its sleeve of faces, and the sleeve is led around the other side of the vertices at which the path bends, until a
 * rule finds no further vertex to pass.
 *
 * The path is a chain of straight pieces that meet at vertices of the input; its two ends can also be inserted
 * vertices. The sleeve is cut at the joints that stay, so that a round takes time only for the pieces next to passed
 * joints and for copying the others.
 *
 * A rule decides which joints are passed and where the shortest path in a sleeve bends. It has two functions and a
 * constant:
 *
 *     Passed_side side(const Piece& in, const Piece& out, Passed_side before)
 *     const std::vector<Bend>& bends(const Edge_sequence& ends)
 *     static constexpr bool drops_loops
 *
 * The first returns the side on which the joint of two pieces is passed, where `before` is the side of the preceding
 * joint. The second returns the vertices at which the shortest path in `sleeve()` from `ends.tail` to `ends.head`
 * bends; they equal `sleeve().bends()` up to rounding errors. The constant specifies whether a part of the path that
 * contracts to a vertex is dropped; without it, such a path cannot be shortened.
 */
template <class Triangulation>
class Iterative_unfolding
{
public:
  using Bend = typename Sleeve<Triangulation>::Bend;

  /* A straight line from vertex to vertex: along an edge or a part of it, inside a face, or across the edges in its
   * range. Directions are known at vertices of the input only. */
  struct Piece
  {
    Input_halfedge_index along = null_index, face = null_index; // as of a `Edge_sequence`
    std::size_t first = 0, last = 0;
    Vertex_index tail = null_index, head = null_index;
    Corner_direction at_tail, at_head;              // at the head, backward
    Plane_vector vector = 0;                        // in the unfolded sleeve, if edges are crossed
    bool is_left_open = true, is_right_open = true; // whether the angle on that side can be below pi
    bool is_examined = false, is_straight = false;  // whether straightness has been examined, and its result
  };

  Iterative_unfolding(const Triangulation& triangulation, Refused_faces refused)
    : m_triangulation(triangulation)
    , m_sleeve(triangulation, refused)
  {
  }

  /* Reserves memory for a path of a number of edges. A sleeve that crosses many edges crosses about four per vertex. */
  void reserve(std::size_t edges)
  {
    for(std::vector<Piece>* pieces : {&m_pieces, &m_before})
      pieces->reserve(edges);
    for(std::vector<Sleeve_edge>* crossed : {&m_crossed, &m_crossed_before, &m_sleeve.edges()})
      crossed->reserve(4 * edges);
  }

  const Input_faces<Triangulation>& faces() const { return m_sleeve.faces(); }
  const Sleeve<Triangulation>& sleeve() const { return m_sleeve; }
  std::vector<Piece>& pieces() { return m_pieces; }
  const std::vector<Piece>& pieces() const { return m_pieces; }

  void clear()
  {
    m_pieces.clear();
    m_crossed.clear();
  }

  /* Clears the data of the previous path. */
  void restart()
  {
    clear();
    m_sleeve.faces().forget_refusals();
  }

  /* Returns the edge sequence of a piece. */
  Edge_sequence sequence(const Piece& piece) const
  {
    Edge_sequence result;
    result.along = piece.along;
    result.face = piece.face;
    result.tail = piece.tail;
    result.head = piece.head;
    result.crossed.reserve(piece.last - piece.first);
    for(std::size_t i = piece.first; i < piece.last; ++i)
      result.crossed.push_back(m_crossed[i].crossed);
    return result;
  }

  /* Unfolds the sleeve of a piece. \pre it crosses edges */
  const Sleeve<Triangulation>& unfolded(const Piece& piece)
  {
    m_sleeve.edges().assign(position(m_crossed, piece.first), position(m_crossed, piece.last));
    m_sleeve.unfold(piece.tail, piece.head);
    return m_sleeve;
  }

  /* Appends the straight piece of an edge sequence; the caller sets its directions. */
  Piece& append(const Edge_sequence& sequence)
  {
    Piece piece;
    piece.along = sequence.along;
    piece.face = sequence.face;
    piece.first = m_crossed.size();
    piece.last = piece.first + sequence.crossed.size();
    piece.tail = sequence.tail;
    piece.head = sequence.head;
    m_crossed.insert(m_crossed.end(), sequence.crossed.begin(), sequence.crossed.end());
    m_pieces.push_back(piece);
    return m_pieces.back();
  }

  /* Appends the piece along an edge. */
  void append_edge(Input_halfedge_index h)
  {
    Edge_sequence sequence;
    sequence.along = h;
    sequence.tail = faces().tail(h);
    sequence.head = faces().head(h);
    append_in_face(sequence);
  }

  /* Appends the straight line of an edge sequence. */
  void append_straight(const Edge_sequence& sequence)
  {
    if(sequence.crossed.empty())
      return append_in_face(sequence);
    m_sleeve.edges().assign(sequence.crossed.begin(), sequence.crossed.end());
    m_sleeve.unfold(sequence.tail, sequence.head);
    append_across(0, sequence.crossed.size(), {sequence.tail, m_sleeve.tail_place()},
                  {sequence.head, m_sleeve.head_place()});
  }

  /* Appends the shortest path in the sleeve of an edge sequence. Returns false if rounding errors make a part of it
   * inconsistent or if a face has been refused. */
  template <class Rule>
  bool append_shortened(const Edge_sequence& sequence, Rule& rule)
  {
    m_sleeve.edges().assign(sequence.crossed.begin(), sequence.crossed.end());
    return append_string(sequence, rule);
  }

  /* Leads the path around joints once. Returns false if that is impossible. */
  template <class Rule>
  bool pass_joints_once(Rule& rule)
  {
    return (!choose_sides(rule) || pass_joints(rule)) && !faces().have_refused();
  }

  /* Leads the path around joints until the rule finds none or floating-point arithmetic cannot decide how to continue.
   * Returns false if passing a joint is impossible. */
  template <class Rule>
  bool tighten(Rule& rule)
  {
    for(int round = 0; round < most_rounds && choose_sides(rule); ++round) {
      if(!pass_joints(rule))
        return false;
      if(is_shape_as_before())
        break;
    }
    return !faces().have_refused();
  }

private:
  using Path = Edge_sequence_path<Triangulation, Sleeve_edge>;

  // The number of rounds is about the number of rows of vertices between the path and the geodesic.
  static constexpr int most_rounds = 1000;

  static auto position(const std::vector<Sleeve_edge>& crossed, std::size_t i)
  {
    return crossed.begin() + static_cast<std::ptrdiff_t>(i);
  }

  // ---- joints

  // Returns whether any joint must be passed.
  template <class Rule>
  bool choose_sides(Rule& rule)
  {
    m_sides.clear();
    bool result = false;
    Passed_side side = Passed_side::NONE;
    for(std::size_t i = 0; i + 1 < m_pieces.size(); ++i) {
      side = rule.side(m_pieces[i], m_pieces[i + 1], side);
      m_sides.push_back(side);
      result = result || side != Passed_side::NONE;
    }
    return result;
  }

  // Leads the path around all joints for which a side is chosen, and shortens it between the others.
  template <class Rule>
  bool pass_joints(Rule& rule)
  {
    m_pieces.swap(m_before);
    m_crossed.swap(m_crossed_before);
    clear();
    for(std::size_t first = 0, last = 0; first < m_before.size(); first = ++last) {
      while(last < m_sides.size() && m_sides[last] != Passed_side::NONE)
        ++last;
      if(first == last)
        keep(m_before[first]);
      else if(!append_merged(first, last, rule))
        return false;
    }
    return true;
  }

  // Since nothing has moved, the joints need not be examined again unless the next piece changes.
  void keep(Piece piece)
  {
    piece.is_left_open = piece.is_right_open = false;
    const std::size_t first = m_crossed.size();
    m_crossed.insert(m_crossed.end(), position(m_crossed_before, piece.first), position(m_crossed_before, piece.last));
    piece.first = first;
    piece.last = m_crossed.size();
    m_pieces.push_back(piece);
  }

  // Appends the path along the previous pieces `first` to `last`, led around the joints in between.
  template <class Rule>
  bool append_merged(std::size_t first, std::size_t last, Rule& rule)
  {
    if(!m_pieces.empty())
      m_pieces.back().is_left_open = m_pieces.back().is_right_open = true;
    Path path(m_triangulation, m_before[first].tail, first_anchor(m_triangulation, tail_end_before(first)),
              std::move(m_sleeve.edges()));
    cross_edges_before(first, path);
    for(std::size_t i = first; i < last; ++i) {
      if(!turn(m_triangulation.input(), path, last_anchor(m_triangulation, head_end_before(i)),
               first_anchor(m_triangulation, tail_end_before(i + 1)), m_sides[i] == Passed_side::LEFT))
        return false;
      cross_edges_before(i + 1, path);
    }
    const Edge_sequence ends = path.trim(m_before[last].head, last_anchor(m_triangulation, head_end_before(last)));
    m_sleeve.edges() = path.take_crossed_edges();
    return append_string(ends, rule);
  }

  void cross_edges_before(std::size_t i, Path& path) const
  {
    path.cross(m_crossed_before, m_before[i].first, m_before[i].last);
  }

  Edge_sequence_end tail_end_before(std::size_t i) const
  {
    const Piece& piece = m_before[i];
    if(piece.first == piece.last)
      return {piece.along, null_index, piece.face, piece.tail};
    const Input_halfedge_index h = m_crossed_before[piece.first].crossed;
    return {null_index, h, h, piece.tail};
  }

  Edge_sequence_end head_end_before(std::size_t i) const
  {
    const Piece& piece = m_before[i];
    if(piece.first == piece.last)
      return {piece.along == null_index ? null_index : twin_index(piece.along), null_index, piece.face, piece.head};
    const Input_halfedge_index h = twin_index(m_crossed_before[piece.last - 1].crossed);
    return {null_index, h, h, piece.head};
  }

  // Returns whether the path passes the same vertices as before and crosses as many edges between them.
  bool is_shape_as_before() const
  {
    return std::equal(
        m_pieces.begin(), m_pieces.end(), m_before.begin(), m_before.end(),
        [](const Piece& a, const Piece& b) { return a.head == b.head && a.last - a.first == b.last - b.first; });
  }

  // ---- shortest paths in sleeves

  struct Placed_vertex
  {
    Vertex_index vertex;
    Plane_vector place;
  };

  // Across the edges of the sleeve, or as specified by `ends` if there are none.
  template <class Rule>
  bool append_string(const Edge_sequence& ends, Rule& rule)
  {
    if(m_sleeve.edges().empty()) {
      if(ends.tail == ends.head)
        return Rule::drops_loops;
      append_in_face(ends);
      return true;
    }
    m_sleeve.unfold(ends.tail, ends.head);
    m_sleeve.pull();
    return !faces().have_refused() && append_between_bends(ends, rule.bends(ends));
  }

  bool append_between_bends(const Edge_sequence& ends, const std::vector<Bend>& bends)
  {
    Placed_vertex from = {ends.tail, m_sleeve.tail_place()};
    std::size_t first = 0;
    for(std::size_t b = 0; b <= bends.size(); ++b) {
      const bool is_last = b == bends.size();
      const std::size_t last = is_last ? m_sleeve.edges().size() : bends[b].first;
      const Placed_vertex to = is_last ? Placed_vertex{ends.head, m_sleeve.head_place()}
                                       : Placed_vertex{m_sleeve.vertex(bends[b]), bends[b].position};
      if(first >= last && from.vertex == to.vertex)
        return false; // only rounding errors lead here
      if(first < last)
        append_across(first, last, from, to);
      else
        append_in_face(from.vertex, to.vertex, face_before(first));
      if(is_last)
        break;
      // On the side of the sleeve, the angle is at least pi.
      (bends[b].side == RIGHT_END ? m_pieces.back().is_left_open : m_pieces.back().is_right_open) = false;
      from = to;
      first = bends[b].last + 1;
    }
    return true;
  }

  // Appends the line across edges `first` to `last` - 1 of the sleeve.
  void append_across(std::size_t first, std::size_t last, const Placed_vertex& from, const Placed_vertex& to)
  {
    Piece piece;
    piece.first = m_crossed.size();
    m_crossed.insert(m_crossed.end(), position(m_sleeve.edges(), first), position(m_sleeve.edges(), last));
    piece.last = m_crossed.size();
    piece.tail = from.vertex;
    piece.head = to.vertex;
    piece.at_tail = m_sleeve.direction_at_tail(first, from.place, to.place);
    piece.at_head = m_sleeve.direction_at_head(last - 1, from.place, to.place);
    piece.vector = to.place - from.place;
    m_pieces.push_back(piece);
  }

  // The face of the sleeve before edge i.
  Input_halfedge_index face_before(std::size_t i) const
  {
    return i == 0 ? m_sleeve.edges().front().crossed : twin_index(m_sleeve.edges()[i - 1].crossed);
  }

  void append_in_face(Vertex_index tail, Vertex_index head, Input_halfedge_index face)
  {
    Path path(m_triangulation, tail, anchor(m_triangulation, tail, face));
    append_in_face(path.trim(head, anchor(m_triangulation, head, face)));
  }

  // Appends the straight line of an edge sequence that crosses nothing.
  void append_in_face(const Edge_sequence& sequence)
  {
    Piece& piece = append(sequence);
    if(sequence.along != null_index) {
      piece.at_tail.outgoing = sequence.along;
      piece.at_head.outgoing = twin_index(sequence.along);
    } else {
      piece.at_tail = m_sleeve.direction_in_face(sequence.tail, sequence.head, sequence.face);
      piece.at_head = m_sleeve.direction_in_face(sequence.head, sequence.tail, sequence.face);
    }
  }

  const Triangulation& m_triangulation;
  Sleeve<Triangulation> m_sleeve;
  std::vector<Piece> m_pieces, m_before;                // of this round and of the previous one
  std::vector<Sleeve_edge> m_crossed, m_crossed_before; // the edges that the pieces cross
  std::vector<Passed_side> m_sides;                     // of the joints
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_ITERATIVE_UNFOLDING_H
