// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POINT_INSERTION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POINT_INSERTION_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_history.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_sequence_path.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* The position of a point of an input face in the intrinsic triangulation. */
struct Located_point
{
  Halfedge_index halfedge =
      null_index;      // of the face that contains the point, or of the edge on which it lies, with the face on the
                       // left
  std::size_t gap = 0; // in the halfedge's edge sequence; its input face, as seen from the intrinsic face, contains the
                       // point
  bool is_on_edge = false;
  Vertex_index vertex = null_index; // the vertex that coincides with the point, if any
};

/*
 * Locates points in an intrinsic triangulation. The intrinsic faces cut an input face into convex pieces, each
 * identified by a gap in the edge sequences of its sides. The search proceeds from piece to piece, through a side
 * beyond which the point lies if there is one, and visits each piece once; it therefore terminates whatever the
 * rounding errors are.
 *
 * The edge sequences determine the pieces, and exact signs the side of an edge on which the point lies. Only with
 * traits whose predicates are inexact can it happen that no piece contains the point; the point is then put on the edge
 * that it misses by the smallest distance.
 */
template <class Triangulation>
class Point_locator
{
  struct Gap
  {
    Halfedge_index halfedge;
    std::size_t gap;

    bool operator<(const Gap& other) const
    {
      return halfedge != other.halfedge ? halfedge < other.halfedge : gap < other.gap;
    }
  };

public:
  Point_locator(const Triangulation& triangulation, Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_side(triangulation, statistics)
  {
  }

  /* \pre the surface point is canonical, and not an input vertex */
  Located_point operator()(const Surface_location& point) const
  {
    std::size_t letters = no_limit;
    return *search(point, *first_piece(point.halfedge, letters), letters);
  }

  /*
   * Locates a point that lies close to a known piece: from a corner of the input face as above, so that the search
   * terminates; but from the known piece if the corner is too far away, beyond points inserted before.
   */
  Located_point operator()(const Surface_location& point, Known_piece& close_by) const
  {
    if(const std::optional<Gap> corner = first_piece(point.halfedge, close_by.letters))
      if(const std::optional<Located_point> found = search(point, *corner, close_by.letters))
        return *found;
    std::size_t letters = no_limit;
    return *search(point, {close_by.halfedge, close_by.gap}, letters);
  }

private:
  static constexpr std::size_t no_limit = (std::numeric_limits<std::size_t>::max)();

  // Subtracts the cost of the edge sequence of h from the budget of a search. Returns false if the budget is exhausted.
  bool spend(Halfedge_index h, std::size_t& letters_left) const
  {
    letters_left -= (std::min)(letters_left, letters(h) + 1);
    return letters_left > 0;
  }

  // Returns nothing if the budget of crossed edges is exhausted.
  std::optional<Located_point> search(const Surface_location& point, const Gap& first, std::size_t& letters_left) const
  {
    std::vector<Gap> pending = {first};
    std::set<Gap> visited;
    Located_point nearest;
    double smallest_miss = std::numeric_limits<double>::infinity();
    while(!pending.empty()) {
      const Gap start = pending.back();
      pending.pop_back();
      if(!visited.insert(start).second)
        continue;
      const std::vector<Gap> sides = sides_of_piece(start);
      visited.insert(sides.begin(), sides.end());
      std::vector<Gap> zeros, beyond;
      for(const Gap& side : sides) {
        if(!spend(side.halfedge, letters_left))
          return {};
        const Sign sign = m_side(m_triangulation.edge_sequence(side.halfedge), side.gap, point);
        if(sign == ZERO)
          zeros.push_back(side);
        else if(sign == NEGATIVE)
          beyond.push_back(side);
      }
      if(beyond.empty())
        return located(start, zeros);
      note_miss(beyond, point, smallest_miss, nearest);
      push_neighbors(sides, beyond, pending);
    }
    return checked_miss(nearest, smallest_miss, point);
  }

  std::size_t letters(Halfedge_index h) const
  {
    return static_cast<std::size_t>(number_of_crossings(m_triangulation, h));
  }

  // A piece at the corner of the input face at the tail of input halfedge c; nothing if the budget is exhausted.
  std::optional<Gap> first_piece(Input_halfedge_index c, std::size_t& letters_left) const
  {
    if(m_triangulation.version(Triangulation::edge(as_intrinsic(c))) == 0)
      return Gap{as_intrinsic(c), 0};
    const auto& input = m_triangulation.input();
    const Halfedge_index start = outgoing_beside(m_triangulation, c);
    Halfedge_index g = start;
    for(Halfedge_index h = m_triangulation.clockwise(g); h != null_index && h != start;
        h = m_triangulation.clockwise(h)) {
      g = h;
      if(!spend(h, letters_left))
        return {};
    }
    if(m_triangulation.clockwise(g) == start)
      g = start;
    for(;; g = m_triangulation.counterclockwise(g)) {
      CGAL_assertion(g != null_index);
      if(!spend(g, letters_left))
        return {};
      Input_halfedge_index direction = tail_anchor(m_triangulation, m_triangulation.edge_sequence(g));
      if(direction == c)
        return Gap{g, 0};
      const Triangle_crossings corner =
          crossings_in_face(m_triangulation, m_triangulation.next(g)); // corner 0 is the tail of g, 1 its head
      for(Index i = 0; i < corner.emanating[0]; ++i) {
        direction = twin_index(input.next(input.next(direction))); // counterclockwise
        if(direction == c)
          return Gap{m_triangulation.next(g), static_cast<std::size_t>(corner.cutting[1] + i + 1)};
      }
    }
  }

  /*
   * The gaps that bound the piece at a gap of h = A->B, from within the face (h, B->O, O->A). Along h come the input
   * edges that cut A off, then those that emanate from O, then those that cut B off.
   */
  std::vector<Gap> sides_of_piece(const Gap& start) const
  {
    const Halfedge_index h = start.halfedge, hn = m_triangulation.next(h), hp = m_triangulation.next(hn);
    const Triangle_crossings c = crossings_in_face(m_triangulation, h); // corners O, A, B
    const std::size_t at_a = c.cutting[1], at_b = c.cutting[2], n = letters(h);
    std::vector<Gap> result = {start};
    const bool is_at_a = start.gap<at_a, is_at_b = start.gap> n - at_b;
    if(is_at_a || (start.gap == at_a && c.emanating[1] == 0 && !is_at_b))
      result.push_back({hp, letters(hp) - start.gap});
    if(is_at_b || (start.gap == n - at_b && c.emanating[2] == 0 && !is_at_a))
      result.push_back({hn, n - start.gap});
    return result;
  }

  Located_point located(const Gap& start, const std::vector<Gap>& zeros) const
  {
    if(zeros.empty())
      return {start.halfedge, start.gap, false, null_index};
    Located_point result = {zeros.front().halfedge, zeros.front().gap, true, null_index};
    if(zeros.size() > 1) {
      const Halfedge_index a = zeros[0].halfedge, b = zeros[1].halfedge;
      result.vertex = m_triangulation.next(a) == b ? m_triangulation.tail(b) : m_triangulation.tail(a);
    }
    return result;
  }

  void note_miss(const std::vector<Gap>& beyond, const Surface_location& point, double& smallest,
                 Located_point& at) const
  {
    double miss = 0;
    Gap worst = beyond.front();
    for(const Gap& side : beyond) {
      const double by = std::abs(m_side.distance(m_triangulation.edge_sequence(side.halfedge), side.gap, point)) /
                        m_triangulation.length(side.halfedge);
      if(by > miss) {
        miss = by;
        worst = side;
      }
    }
    if(miss < smallest) {
      smallest = miss;
      at = {worst.halfedge, worst.gap, true, null_index};
    }
  }

  // The sides beyond which the point lies come last, so that they are popped first.
  void push_neighbors(const std::vector<Gap>& sides, const std::vector<Gap>& beyond, std::vector<Gap>& pending) const
  {
    for(const std::vector<Gap>* list : {&sides, &beyond})
      for(const Gap& side : *list) {
        const Halfedge_index t = Triangulation::twin(side.halfedge);
        if(m_triangulation.crossings(Triangulation::edge(t)) >= 0) // not along an input edge, as on the border
          pending.push_back({t, letters(t) - side.gap});
      }
  }

  Located_point checked_miss(const Located_point& nearest, double miss, const Surface_location& point) const
  {
    if(!(miss < largest_point_miss))
      throw_naming<Insertion_error>("a point in the face of halfedge ", point.halfedge,
                                    " cannot be located in the triangulation, because rounding errors have caused "
                                    "incorrect flips; use the default traits");
    return nearest;
  }

  const Triangulation& m_triangulation;
  Point_side<Triangulation> m_side;
};

/* An inserted point: its position on the input, and the former data of the edge or face that was split. */
template <class Halfedge_geometry>
struct Inserted_point
{
  Surface_location location;
  Index number_of_edges;
  Halfedge_index faces[6]; // h, hn, hp and, if the edge was split and has a second face, t, tn, tp
  Vertex_index head_of_h;
  Halfedge_geometry geometry[6];
};

/*
 * The operations that an insertion applies to a triangulation, which constructs this object from its parts: log the old
 * data and add a vertex, then add edges, link faces and set their vectors. Everything can be rolled back once `begin()`
 * has returned.
 */
template <class Triangulation, class Store>
class Insertion_editor
{
public:
  using Point = Inserted_point<typename Store::Halfedge_geometry>;

  Insertion_editor(const Triangulation& triangulation, Store& halfedges, Flip_log<Store>& log,
                   std::vector<Point>& points, Edge_history<Triangulation>& history)
    : m_triangulation(triangulation)
    , m_halfedges(halfedges)
    , m_log(log)
    , m_points(points)
    , m_history(history)
  {
  }

  /* Logs the old data and adds the vertex. Changes nothing if it throws. */
  Vertex_index begin(const Located_point& place, const Surface_location& location)
  {
    const Triangulation& t = m_triangulation;
    checked_index_bound(2 * (static_cast<std::size_t>(t.number_of_edges()) + 3));
    const auto number = static_cast<std::ptrdiff_t>(m_points.size());
    m_halfedges.add_vertex();
    try {
      m_points.push_back(record(place, location));
      m_log.note_insertion(m_halfedges, place.halfedge, place.is_on_edge, static_cast<Index>(place.gap),
                           static_cast<Index>(number));
    } catch(...) {
      m_points.erase(m_points.begin() + number, m_points.end());
      m_halfedges.remove_last_vertex();
      throw;
    }
    return Vertex_index(t.number_of_vertices() - 1);
  }

  /* Adds an edge whose sides have no face yet; returns the halfedge to which the edge sequence belongs. */
  Halfedge_index add_edge(const Edge_sequence& sequence)
  {
    const Slot s = m_halfedges.add_edge();
    m_halfedges[s].tail = sequence.tail;
    m_halfedges[twin_slot(s)].tail = sequence.head;
    set_sequence(m_halfedges.halfedge(s), sequence);
    return m_halfedges.halfedge(s);
  }

  /* Moves the tail of h; the edge sequence is that from the new tail on. */
  void shorten_edge(Halfedge_index h, const Edge_sequence& sequence)
  {
    m_halfedges[m_halfedges.slot(h)].tail = sequence.tail;
    set_sequence(h, sequence);
  }

  void link_face(Halfedge_index a, Halfedge_index b, Halfedge_index c)
  {
    m_halfedges.link_face(m_halfedges.slot(a), m_halfedges.slot(b), m_halfedges.slot(c));
  }

  /* Marks h as a border halfedge. */
  void put_on_border(Halfedge_index h) { m_halfedges[m_halfedges.slot(h)].encoded_next = Store::Record::border; }

  /* Stores h, which starts at the new vertex, as its outgoing halfedge. */
  void set_outgoing(Vertex_index x, Halfedge_index h) { m_halfedges.set_outgoing(x, m_halfedges.slot(h)); }

  /* If `from` is the outgoing halfedge stored for v, stores `to` instead. */
  void move_outgoing(Vertex_index v, Halfedge_index from, Halfedge_index to)
  {
    m_halfedges.move_outgoing(v, m_halfedges.slot(from), m_halfedges.slot(to));
  }

  /* Sets the vectors of the face on the left of h, starting with h. */
  template <class Face_geometry>
  void lay_out(Halfedge_index h, const Face_geometry& geometry)
  {
    m_halfedges.set_face_geometry(h, geometry[0], geometry[1], geometry[2]);
  }

  /* Rolls the last insertion back. \pre nothing was logged after it */
  void take_back()
  {
    const auto& log = m_log.back();
    const Point& record = m_points.back();
    remove_edges(record.number_of_edges);
    m_halfedges.remove_last_vertex();
    const Slot h = m_halfedges.slot(log.h);
    m_halfedges.version(h) = log.old_version;
    m_halfedges.crossings_plus_one(h) = log.old_crossings;
    m_halfedges[twin_slot(h)].tail = record.head_of_h;
    for(int i = 0; i < 6 && record.faces[i] != null_index; i += 3)
      link_face(record.faces[i], record.faces[i + 1], record.faces[i + 2]);
    for(int i = 0; i < 6 && record.faces[i] != null_index; ++i) {
      const Slot s = m_halfedges.slot(record.faces[i]);
      const Vertex_index v = m_halfedges[s].tail;
      m_halfedges[s].geometry = record.geometry[i];
      if(m_halfedges.outgoing(v).idx() >= m_triangulation.number_of_halfedges()) // of an edge that no longer exists
        m_halfedges.set_outgoing(v, s);
    }
    m_points.pop_back();
    m_log.take_back(m_halfedges);
  }

private:
  Point record(const Located_point& place, const Surface_location& location) const
  {
    const Triangulation& t = m_triangulation;
    const Halfedge_index h = place.halfedge;
    const bool has_two_faces = place.is_on_edge && !t.is_border(Triangulation::twin(h));
    Point result = {location, t.number_of_edges(), {}, t.head(h), {}};
    for(int i = 0; i < 6; ++i) {
      const Halfedge_index start = i < 3 ? h : (has_two_faces ? Triangulation::twin(h) : null_index);
      const Halfedge_index side = start == null_index ? null_index : (i % 3 == 0 ? start : t.next(result.faces[i - 1]));
      result.faces[i] = side;
      if(side != null_index)
        result.geometry[i] = t.geometry(side);
    }
    return result;
  }

  void remove_edges(Index number_left)
  {
    while(m_triangulation.number_of_edges() > number_left) {
      const Edge_index e(m_triangulation.number_of_edges() - 1);
      CGAL_precondition_msg(m_triangulation.holds(e) == 0,
                            "an edge of a curve cannot be removed together with an inserted point");
      m_history.forget(e, m_triangulation.version(e));
      m_halfedges.remove_last_edge();
    }
  }

  void set_sequence(Halfedge_index h, const Edge_sequence& sequence)
  {
    const Index version = static_cast<Index>(m_log.size());
    const Slot s = m_halfedges.slot(h);
    m_halfedges.version(s) = version;
    m_halfedges.crossings_plus_one(s) =
        sequence.along != null_index ? 0 : static_cast<Index>(sequence.crossed.size()) + 1;
    m_history.store_sequence(h, version, sequence);
  }

  const Triangulation& m_triangulation;
  Store& m_halfedges;
  Flip_log<Store>& m_log;
  std::vector<Point>& m_points;
  Edge_history<Triangulation>& m_history;
};

/* Detects traits that can represent a part of an input face in their own numbers. */
template <class Traits, class = void>
constexpr bool has_exact_subfaces = false;
template <class Traits>
constexpr bool has_exact_subfaces<Traits, std::void_t<typename Traits::Construct_subface>> =
    !std::is_void<typename Traits::Construct_subface>::value;

/* The two halves of a split edge: its old halfedge, which is shorter now, and the one that continues it. */
struct Edge_halves
{
  Halfedge_index first = null_index, second = null_index;
};

/*
 * Inserts a new vertex x at a located point: into a face, with three new edges, or onto an edge, with one new edge for
 * its other half and one into each of its faces.
 *
 *         o                    o
 *        /|.                  /|.            The edge sequences of the new edges derive from the side's: the input
 *       / | .                / | .           face of the point is a gap of it, so that the crossings before the gap
 *      /  |  .              /  |  .          lead back to a and those after it on to b, and a turn around b within
 *     /  _x_  .            a---x---b         the face continues to the edge sequence of bo.
 *    / /     . .            .  |  /
 *   a-----------b            . | /
 *                              p
 *
 * The triangulation's log already contains the record of the split, so that everything can be rolled back after an
 * exception.
 */
template <class Triangulation, class Editor>
class Point_insertion
{
  using Traits = typename Triangulation::Traits;

  // A halfedge of the old triangulation and the gap of its edge sequence whose input face contains the point.
  struct Place
  {
    Halfedge_index h;
    std::size_t gap;
    Edge_sequence sequence;

    Place reversed() const { return {Triangulation::twin(h), sequence.crossed.size() - gap, sequence.reversed()}; }
  };

public:
  Point_insertion(const Triangulation& triangulation, Editor& editor, const Located_point& located, Vertex_index x)
    : m_triangulation(triangulation)
    , m_editor(editor)
    , m_place{located.halfedge, located.gap, triangulation.edge_sequence(located.halfedge)}
    , m_x(x)
  {
  }

  /* Splits the face on the left of the halfedge. */
  void split_face()
  {
    const Halfedge_index h = m_place.h, hn = next(h), hp = next(hn);
    const Edge_sequence to_a = sequence_to_tail(m_place), to_b = sequence_to_head(m_place),
                        to_o = sequence_to_apex(m_place);
    const Halfedge_index a = m_editor.add_edge(to_a), b = m_editor.add_edge(to_b), o = m_editor.add_edge(to_o);
    m_editor.link_face(h, twin(b), a);
    m_editor.link_face(hn, twin(o), b);
    m_editor.link_face(hp, twin(a), o);
    m_editor.set_outgoing(m_x, a);
    lay_out_faces({h, hn, hp});
  }

  /* Splits the edge of the halfedge. \pre its tail has not degree 1 within the face */
  Edge_halves split_edge()
  {
    const Halfedge_index h = m_place.h, t = twin(h);
    if(m_triangulation.is_border(t))
      return split_border_edge();
    return next(h) == t ? split_edge_to_degree_one() : split_inner_edge();
  }

private:
  static Halfedge_index twin(Halfedge_index h) { return Triangulation::twin(h); }
  Halfedge_index next(Halfedge_index h) const { return m_triangulation.next(h); }

  // ---------------------------------------------------------------- edge sequences

  // A path that starts at x in the input face of the gap.
  Edge_sequence_path<Triangulation> path_from(const Place& place) const
  {
    const Input_halfedge_index face = face_of_gap(place.sequence, place.gap);
    return {m_triangulation, m_x, anchor(m_triangulation, m_x, face)};
  }

  Edge_sequence sequence_to_head(const Place& place) const
  {
    Edge_sequence_path<Triangulation> path = path_from(place);
    path.cross(place.sequence.crossed, place.gap, place.sequence.crossed.size());
    return path.finish(place.sequence.head, head_anchor(m_triangulation, place.sequence));
  }

  Edge_sequence sequence_to_tail(const Place& place) const
  {
    Edge_sequence_path<Triangulation> path = path_from(place);
    for(std::size_t i = place.gap; i-- > 0;)
      path.cross(twin_index(place.sequence.crossed[i]));
    return path.finish(place.sequence.tail, tail_anchor(m_triangulation, place.sequence));
  }

  // From x to the apex of the face on the left, over the head.
  Edge_sequence sequence_to_apex(const Place& place) const
  {
    const Halfedge_index hn = next(place.h);
    const Edge_sequence sequence = m_triangulation.edge_sequence(hn);
    Edge_sequence_path<Triangulation> path = path_over_head(place);
    path.cross(sequence.crossed, 0, sequence.crossed.size());
    return path.finish(sequence.head, head_anchor(m_triangulation, sequence));
  }

  // From x along the edge to its head, and around the head through the face on the left.
  Edge_sequence_path<Triangulation> path_over_head(const Place& place) const
  {
    const Index turns = crossings_in_face(m_triangulation, place.h).emanating[2];
    Edge_sequence_path<Triangulation> path = path_from(place);
    path.cross(place.sequence.crossed, place.gap, place.sequence.crossed.size());
    path.turn(place.sequence.head, head_anchor(m_triangulation, place.sequence), turns);
    return path;
  }

  // ---------------------------------------------------------------- connectivity

  // The edges that a split of edge h = a->b adds: from x to b, to the apex o and, if given, along a third sequence. The
  // halfedge h keeps its index and leads from a to x.
  struct Added_edges
  {
    Halfedge_index xb, xo, third;
  };

  Added_edges add_edges(const Edge_sequence* third = nullptr)
  {
    const Halfedge_index t = twin(m_place.h);
    const Vertex_index b = m_triangulation.tail(t);
    const Edge_sequence to_a = sequence_to_tail(m_place), to_b = sequence_to_head(m_place),
                        to_o = sequence_to_apex(m_place);
    const Halfedge_index xb = m_editor.add_edge(to_b), xo = m_editor.add_edge(to_o);
    const Added_edges result = {xb, xo, third == nullptr ? null_index : m_editor.add_edge(*third)};
    m_editor.shorten_edge(t, to_a);
    m_editor.move_outgoing(b, t, twin(xb));
    m_editor.set_outgoing(m_x, xb);
    return result;
  }

  Edge_halves split_border_edge()
  {
    const Halfedge_index h = m_place.h, hn = next(h), hp = next(hn);
    const auto [xb, xo, none] = add_edges();
    m_editor.put_on_border(twin(xb));
    m_editor.link_face(h, xo, hp);
    m_editor.link_face(xb, hn, twin(xo));
    lay_out_faces({h, xb});
    return {h, xb};
  }

  Edge_halves split_inner_edge()
  {
    const Halfedge_index h = m_place.h, t = twin(h), hn = next(h), hp = next(hn), tn = next(t), tp = next(tn);
    const Edge_sequence to_p = sequence_to_apex(m_place.reversed());
    const auto [xb, xo, xp] = add_edges(&to_p);
    m_editor.link_face(h, xo, hp);
    m_editor.link_face(xb, hn, twin(xo));
    m_editor.link_face(t, tn, twin(xp));
    m_editor.link_face(twin(xb), xp, tp);
    lay_out_faces({h, xb, t, twin(xb)});
    return {h, xb};
  }

  /*
   * The face of h = a->b is glued to itself along h and its twin, so that b has degree 1. Creates both halves of the
   * edge, a loop from x around b, and an edge from x, on the side of h, to the face's corner after the twin.
   */
  Edge_halves split_edge_to_degree_one()
  {
    const Halfedge_index h = m_place.h, t = twin(h), hp = next(t);
    const Place from_twin = m_place.reversed();
    Edge_sequence_path<Triangulation> loop = path_over_head(m_place);
    loop.cross(from_twin.sequence.crossed, 0, from_twin.gap);
    const Input_halfedge_index face = face_of_gap(from_twin.sequence, from_twin.gap);
    const Edge_sequence around_b = loop.finish(m_x, anchor(m_triangulation, m_x, face));
    const auto [xb, xo, xx] = add_edges(&around_b);
    m_editor.link_face(h, xo, hp);
    m_editor.link_face(xb, twin(xb), twin(xx));
    m_editor.link_face(xx, t, twin(xo));
    lay_out_faces({h, xb, xx});
    return {h, xb};
  }

  // ---------------------------------------------------------------- geometry

  void lay_out_faces(std::initializer_list<Halfedge_index> halfedges)
  {
    for(Halfedge_index h : halfedges)
      lay_out(h);
  }

  void lay_out(Halfedge_index h)
  {
    const Halfedge_index hn = next(h), hp = next(hn);
    m_editor.lay_out(h, geometry_of_new_face({h, hn, hp}));
    for(Halfedge_index side : {h, hn, hp})
      if(!is_usable_length(m_triangulation.length(side)))
        fail("it is too close to a vertex");
  }

  typename Traits::Face_geometry geometry_of_new_face(const std::array<Halfedge_index, 3>& sides)
  {
    if constexpr(has_exact_subfaces<Traits>) {
      return part_of_input_face(sides);
    } else {
      const auto geometry = fresh_face(m_triangulation, sides[0], Traits::Has_drift::value ? largest_angle_drift : 0);
      if(!geometry)
        fail("rounding errors have caused incorrect flips in the triangulation");
      return *geometry;
    }
  }

  typename Traits::Face_geometry part_of_input_face(const std::array<Halfedge_index, 3>& sides)
  {
    for(Halfedge_index h : sides)
      if(m_triangulation.crossings(Triangulation::edge(h)) > 0)
        fail("with an exact number type, points must be inserted before edges around them are flipped");
    const Input_halfedge_index face = face_of_gap(m_triangulation.edge_sequence(sides[0]), 0);
    std::array<std::array<double, 3>, 3> weights;
    for(int i = 0; i < 3; ++i)
      weights[i] = vertex_weights(m_triangulation, m_triangulation.tail(sides[i]), face);
    const Traits& traits = m_triangulation.traits();
    return traits.construct_subface_object()(input_face_geometry(m_triangulation, face, traits), weights);
  }

  [[noreturn]] void fail(const std::string& reason) const
  {
    const Input_halfedge_index h = m_triangulation.location(m_x).halfedge;
    throw_naming<Insertion_error>("a point in the face of halfedge ", h, " cannot be inserted: ", reason);
  }

  const Triangulation& m_triangulation;
  Editor& m_editor;
  Place m_place;
  Vertex_index m_x;
};

/* Makes a located point a vertex of a triangulation, given an editor for it. If an edge is split, `on_split` receives
 * its halves; it must change nothing if it throws. If anything throws, nothing has changed. */
template <class Triangulation, class Editor, class OnSplit>
Vertex_index insert_point(Triangulation& triangulation, Editor editor, Located_point place,
                          const Surface_location& location, const OnSplit& on_split)
{
  const Halfedge_index t = Triangulation::twin(place.halfedge);
  const bool is_head_of_degree_one =
      place.is_on_edge && !triangulation.is_border(t) && triangulation.next(t) == place.halfedge;
  if(is_head_of_degree_one) // rather than the tail
    place = {t, number_of_crossings(triangulation, t) - place.gap, true, null_index};
  const std::size_t start = triangulation.log_position();
  const Vertex_index x = editor.begin(place, location);
  try {
    Point_insertion<Triangulation, Editor> insertion(triangulation, editor, place, x);
    if(place.is_on_edge)
      on_split(insertion.split_edge());
    else
      insertion.split_face();
  } catch(...) {
    triangulation.rollback(start);
    throw;
  }
  return x;
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POINT_INSERTION_H
