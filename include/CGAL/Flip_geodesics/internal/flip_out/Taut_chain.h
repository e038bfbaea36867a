// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_TAUT_CHAIN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_TAUT_CHAIN_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Input_faces.h>
#include <CGAL/Flip_geodesics/internal/flip_out/word_turns.h>
#include <CGAL/Flip_geodesics/internal/numbers/Taut_string.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Word_path.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_comparison.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A direction at a vertex of the input: a spoke, turned counterclockwise by less than the corner of its face. */
struct Spoke_direction
{
  Input_halfedge_index spoke = null_index;
  Plane_vector turn = 1;
};

/* A straight line from vertex to vertex, by its word, and the directions in which it leaves its ends; these are told
 * only at vertices of the input. */
struct Taut_piece
{
  Crossing_word word;
  Spoke_direction at_tail, at_head; // at the head, backward
  bool is_examined = false;         // has its word been asked whether it is straight, exactly?
  bool is_straight = false;         // and is it?
};

/*
 * Pulls a path on the input surface taut, from the words of the edges that it crosses. Nothing is flipped, and the input
 * only read. The path is a chain of straight pieces, which meet at vertices of the input; its ends can also be inserted
 * vertices.
 *
 * By iterative unfolding [XW07], as `Strip_straightener`, which starts from a path of edges: the path is pulled taut in
 * its strip of faces, and where it bends about a vertex with less than pi on the other side, it is led round there.
 * Strings are pulled in doubles, so that a piece can be bent a little; angles close to pi are compared exactly.
 */
template <class Triangulation>
class Taut_chain
{
public:
  Taut_chain(const Triangulation& triangulation, Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_statistics(statistics)
    , m_faces(triangulation)
  {
  }

  /* Appends a piece that is straight. */
  void append(const Taut_piece& piece) { m_pieces.push_back(piece); }

  /* Appends the straight line of a word. */
  void append_straight(const Crossing_word& word)
  {
    if(word.crossed.empty()) {
      m_pieces.push_back(measured_inside_face(word));
      return;
    }
    unfold(word);
    m_pieces.push_back(
        piece_across(word.crossed, 0, word.crossed.size(), {word.tail, m_source}, {word.head, m_target}));
  }

  /* Appends the taut string in the strip of a word, that is, in the faces that a path passes. Returns false if the word
   * is no strip. */
  bool append_taut(const Crossing_word& word)
  {
    const std::vector<Input_halfedge_index>& crossed = word.crossed;
    if(crossed.empty()) {
      if(word.tail != word.head) // what goes on from a bend and comes back is gone
        m_pieces.push_back(measured_inside_face(word));
      return true;
    }
    unfold(word);
    m_string.pull(m_gates, m_source, m_target);
    find_bends();
    drop_false_bends(word);
    return append_between_bends(word);
  }

  /* Leads the chain round vertices until no angle is below pi, or none is but by rounding, and examines the pieces. A piece
   * that is bent all the same says so. Returns false if that cannot be. */
  bool tighten()
  {
    for(int round = 0; round < most_rounds; ++round) {
      m_ways.clear();
      for(std::size_t i = 0; i + 1 < m_pieces.size(); ++i)
        m_ways.push_back(way_round(m_pieces[i], m_pieces[i + 1]));
      if(std::count(m_ways.begin(), m_ways.end(), Way::NONE) == static_cast<std::ptrdiff_t>(m_ways.size()))
        break;
      std::vector<Index> shape = shape_of_chain();
      if(!move_over_joints())
        return false;
      if(shape == shape_of_chain()) // doubles do not tell how to go on
        break;
    }
    examine();
    return true;
  }

  /* Asks each piece whether it is straight, and changes none. */
  void examine()
  {
    for(Taut_piece& piece : m_pieces) {
      piece.is_straight = piece.is_examined ? piece.is_straight : is_straight(piece.word);
      piece.is_examined = true;
    }
  }

  std::vector<Taut_piece>& pieces() { return m_pieces; }

private:
  enum class Way { LEFT, RIGHT, NONE };

  // There are about as many rounds as rows of vertices between the path and the geodesic.
  static constexpr int most_rounds = 1000;

  // Of the vertices that a straight line passes, so many next to either end are kept: the nearest one and a bend can be
  // the two ends of an edge.
  static constexpr std::size_t most_passed = 2;

  // ---- angles

  // How the angle on a side of the joint between two pieces compares with pi; LARGER at the border. Exact if both
  // directions are right up to `unfunneled_angle`.
  Comparison_result compare_angle(const Taut_piece& in, const Taut_piece& out, Side side) const
  {
    return side == Side::LEFT ? compare_clockwise({in, false}, {out, true})
                              : compare_clockwise({out, true}, {in, false});
  }

  // A piece as seen from its tail or its head.
  struct Seen_piece
  {
    const Taut_piece& piece;
    bool is_from_tail;

    const Spoke_direction& direction() const { return is_from_tail ? piece.at_tail : piece.at_head; }
    Crossing_word word() const { return is_from_tail ? piece.word : piece.word.reversed(); }
  };

  // Where the chain turns back on itself, either side is next to nothing. Two pieces along one edge are told by the faces
  // on their left, so that the way from one to the other is over that edge, on the right.
  Way way_round(const Taut_piece& in, const Taut_piece& out) const
  {
    const Spoke_direction &back = in.at_head, &on = out.at_tail;
    if(back.spoke == on.spoke && magnitude(back.turn - on.turn) <= unfunneled_angle)
      return Way::RIGHT;
    if(compare_angle(in, out, Side::LEFT) == SMALLER)
      return Way::LEFT;
    return compare_angle(in, out, Side::RIGHT) == SMALLER ? Way::RIGHT : Way::NONE;
  }

  // The angle clockwise from one direction to another, counterclockwise from the second to the first.
  Comparison_result compare_clockwise(const Seen_piece& a, const Seen_piece& b) const
  {
    const Spoke_direction &from = b.direction(), &to = a.direction();
    Plane_vector angle = std::conj(from.turn);
    Index steps = 0;
    bool is_near_straight = false;
    if(from.spoke != to.spoke || !(cross(from.turn, to.turn) > 0)) {
      Input_halfedge_index spoke = from.spoke;
      do {
        if(m_faces.is_border(spoke))
          return LARGER;
        angle = normalized(product(angle, m_faces.corner(spoke)));
        ++steps;
        if(angle.imag() < -unfunneled_angle && (steps > 1 || angle.real() < 0))
          return LARGER;
        is_near_straight = is_near_straight || (std::abs(angle.imag()) <= unfunneled_angle && angle.real() < 0);
        spoke = m_faces.counterclockwise(spoke);
      } while(spoke != to.spoke);
    }
    angle = product(angle, to.turn);
    if(angle.imag() > unfunneled_angle && !is_near_straight)
      return SMALLER;
    if(angle.imag() < -unfunneled_angle)
      return LARGER;
    if(angle.real() > 0 && !is_near_straight)
      return SMALLER;
    return Wedge_comparison<Triangulation>(m_triangulation, m_statistics)(Wedge_words{a.word(), b.word(), steps});
  }

  static Plane_vector normalized(const Plane_vector& v) { return v / magnitude(v); }

  // ---- moves

  // Which vertices the chain passes, and how many edges it crosses in between.
  std::vector<Index> shape_of_chain() const
  {
    std::vector<Index> result;
    for(const Taut_piece& piece : m_pieces) {
      result.push_back(piece.word.head.idx());
      result.push_back(static_cast<Index>(piece.word.crossed.size()));
    }
    return result;
  }

  // Leads the chain round all joints that can be widened, and pulls it taut between the others.
  bool move_over_joints()
  {
    m_before.swap(m_pieces);
    m_pieces.clear();
    for(std::size_t first = 0, last = 0; first < m_before.size(); first = ++last) {
      while(last < m_ways.size() && m_ways[last] != Way::NONE)
        ++last;
      if(first == last)
        m_pieces.push_back(std::move(m_before[first]));
      else if(!append_merged(first, last))
        return false;
    }
    return true;
  }

  bool append_merged(std::size_t first, std::size_t last)
  {
    const Crossing_word &start = m_before[first].word, &end = m_before[last].word;
    Word_path<Triangulation> path(m_triangulation, start.tail, first_anchor(m_triangulation, start), reused_memory());
    path.cross(start, false);
    for(std::size_t i = first; i < last; ++i) {
      const Crossing_word &in = m_before[i].word, &out = m_before[i + 1].word;
      if(!turn(m_triangulation.input(), path, last_anchor(m_triangulation, in), first_anchor(m_triangulation, out),
               m_ways[i] == Way::LEFT))
        return false;
      path.cross(out, false);
    }
    Crossing_word word = path.finish(end.head, last_anchor(m_triangulation, end));
    const bool is_appended = append_taut(word);
    m_memory = std::move(word.crossed);
    return is_appended;
  }

  std::vector<Input_halfedge_index> reused_memory() { return std::move(m_memory); }

  // ---- strings

  // Appends the pieces of a word between bends, or returns false if there is one that leads nowhere.
  bool append_between_bends(const Crossing_word& word)
  {
    const std::vector<Input_halfedge_index>& crossed = word.crossed;
    Vertex_index tail = word.tail;
    Plane_vector from = m_source;
    for(std::size_t b = 0; b <= m_bends.size(); ++b) {
      const bool is_last = b == m_bends.size();
      const std::size_t first = b == 0 ? 0 : m_bends[b - 1].last + 1,
                        last = is_last ? crossed.size() : m_bends[b].first;
      const Vertex_index head = is_last ? word.head : vertex(crossed, m_bends[b]);
      const Plane_vector to = is_last ? m_target : m_bends[b].position;
      if(first >= last && tail == head)
        return false; // no string does so, but for rounding
      if(first < last)
        m_pieces.push_back(piece_across(crossed, first, last, {tail, from}, {head, to}));
      else
        m_pieces.push_back(piece_in_face(tail, head, b == 0 ? crossed.front() : twin_index(crossed[first - 1])));
      tail = head;
      from = to;
    }
    return true;
  }

  // Where a vertex lies in the face of h, where h leads from 0 to 1; one of the input is the corner opposite to h.
  Plane_vector place_in_face(Vertex_index v, Input_halfedge_index h) const
  {
    const Plane_vector corner = m_faces.corner(h);
    if(!m_triangulation.is_inserted(v))
      return corner;
    const auto w = vertex_weights(m_triangulation, v, h);
    return (w[1] + w[2] * corner) / (w[0] + w[1] + w[2]);
  }

  // Lays out the faces along a word, from the right end of the first crossed edge at the origin.
  void unfold(const Crossing_word& word)
  {
    const std::vector<Input_halfedge_index>& crossed = word.crossed;
    const double length = m_faces.length(crossed.front());
    m_source = length * place_in_face(word.tail, crossed.front());
    m_gates.resize(crossed.size());
    m_gates.front() = {length, LEFT_END};
    Plane_vector left = length, across = -length; // from there to the right end
    for(std::size_t i = 0; i + 1 < crossed.size(); ++i) {
      const Input_halfedge_index entered = twin_index(crossed[i]);
      const Plane_vector corner = m_faces.corner(entered), apex = product(across, corner);
      const bool is_right_new = crossed[i + 1] != m_faces.next(entered);
      m_gates[i + 1] = {left + apex, is_right_new ? RIGHT_END : LEFT_END};
      left += is_right_new ? 0 : apex;
      across = is_right_new ? apex : product(across, 1.0 - corner);
    }
    m_target = left + product(across, place_in_face(word.head, twin_index(crossed.back())));
  }

  // Where the string bends, and vertices that it passes so closely that doubles do not tell on which side.
  void find_bends()
  {
    m_bends.clear();
    const auto& taut = m_string.bends();
    for(std::size_t b = 0; b <= taut.size(); ++b) {
      const bool is_last = b == taut.size();
      const std::size_t first = b == 0 ? 0 : taut[b - 1].last + 1, last = is_last ? m_gates.size() : taut[b].first;
      const std::size_t limit = is_last ? m_gates.size() : taut[b].last;
      const Plane_vector from = b == 0 ? m_source : taut[b - 1].position, to = is_last ? m_target : taut[b].position;
      for(std::size_t i = first; i < last; ++i)
        for(Gate_side side : {RIGHT_END, LEFT_END})
          if(i == first || side == m_gates[i].side)
            add_close_vertex({i, i, side, Taut_string::end(m_gates, i, side)}, from, to, limit);
      if(!is_last)
        m_bends.push_back(taut[b]);
    }
  }

  // An end of a gate that the line from one place to another passes closely. Of vertices of which one is an end of each
  // gate that the other is an end of, one is enough.
  void add_close_vertex(Taut_string::Bend bend, const Plane_vector& from, const Plane_vector& to, std::size_t limit)
  {
    const Plane_vector along = to - from;
    const double base = (std::min)(magnitude(bend.position - from), magnitude(to - bend.position));
    if(!(std::abs(cross(along, bend.position - from)) <= unfunneled_angle * base * magnitude(along)))
      return;
    bend = with_all_gates(bend);
    if((m_bends.empty() || bend.last > m_bends.back().last) && bend.last < limit)
      m_bends.push_back(bend);
  }

  // The same vertex with all gates of which it is an end.
  Taut_string::Bend with_all_gates(Taut_string::Bend bend) const
  {
    while(bend.first > 0 && m_gates[bend.first].side != bend.side)
      --bend.first;
    while(bend.last + 1 < m_gates.size() && m_gates[bend.last + 1].side != bend.side)
      ++bend.last;
    return bend;
  }

  // What is known of the part of the string between two bends that follow on one another.
  struct Gap
  {
    bool is_known = false, is_straight = false; // has its word been asked, exactly, and is it?
    bool is_clear = false;                      // are all crossed edges off the line?
    std::vector<Taut_string::Bend> passed;      // the first vertices on the line and the last ones, `most_passed` each
  };

  // A bend that stays for now, and the part of the string before it.
  struct Kept_bend
  {
    Taut_string::Bend bend;
    Gap before;
  };

  /*
   * Where the string bends by so little that this can be rounding, and the line that leaves the bend out is straight.
   * When a bend is dropped, the one before has another neighbor, and is looked at again.
   *
   * To follow the line across all of what has been dropped, for each bend, would take quadratic time along a row of
   * vertices in line. But two straight parts make one if the line near the bend passes it exactly.
   */
  void drop_false_bends(const Crossing_word& word)
  {
    m_kept.clear();
    Gap after;
    for(std::size_t i = 0; i < m_bends.size(); ++i) {
      const Taut_string::Bend* const next = i + 1 < m_bends.size() ? &m_bends[i + 1] : nullptr;
      m_kept.push_back({m_bends[i], std::exchange(after, Gap())});
      while(!m_kept.empty() && is_last_false(word, next, after))
        m_kept.pop_back();
    }
    m_bends.clear();
    for(const Kept_bend& kept : m_kept)
      m_bends.push_back(kept.bend);
  }

  // Is the last kept bend false? Then the part between its neighbors takes the place of the one after it.
  bool is_last_false(const Crossing_word& word, const Taut_string::Bend* next, Gap& after)
  {
    Kept_bend& kept = m_kept.back();
    const Taut_string::Bend* const previous = m_kept.size() > 1 ? &m_kept[m_kept.size() - 2].bend : nullptr;
    const Plane_vector at = kept.bend.position, from = previous == nullptr ? m_source : previous->position,
                       to = next == nullptr ? m_target : next->position;
    if(std::abs(cross(at - from, to - at)) > unfunneled_angle * magnitude(at - from) * magnitude(to - at))
      return false;
    examine(word, previous, &kept.bend, kept.before);
    examine(word, &kept.bend, next, after);
    Gap joined;
    if(!are_in_line(word, previous, kept, next, after, joined)) {
      if(part(word, previous, next).crossed.empty())
        return false;
      examine(word, previous, next, joined);
      if(!joined.is_straight)
        return false;
    }
    after = std::move(joined);
    return true;
  }

  // Asks the part between two bends whether it is straight, unless it has been asked.
  void examine(const Crossing_word& word, const Taut_string::Bend* from, const Taut_string::Bend* to, Gap& gap) const
  {
    if(gap.is_known)
      return;
    const Crossing_word line = part(word, from, to);
    Line_contacts contacts;
    gap.is_known = true;
    gap.is_straight = line.crossed.empty() ? line.tail != line.head : is_straight(line, contacts);
    gap.is_clear = !contacts.have_edge;
    const std::size_t first = from == nullptr ? 0 : from->last + 1;
    for(const Line_contacts::Edge_end& end : contacts.ends)
      append_passed(passed_vertex(first + end.gate, end.is_left ? LEFT_END : RIGHT_END), gap.passed);
  }

  Taut_string::Bend passed_vertex(std::size_t gate, Gate_side side) const
  {
    return with_all_gates({gate, gate, side, Taut_string::end(m_gates, gate, side)});
  }

  // Only the vertices next to either end matter.
  static void append_passed(const Taut_string::Bend& vertex, std::vector<Taut_string::Bend>& passed)
  {
    if(!passed.empty() && passed.back().first == vertex.first && passed.back().side == vertex.side)
      return;
    if(passed.size() == 2 * most_passed)
      passed.erase(passed.begin() + static_cast<std::ptrdiff_t>(most_passed));
    passed.push_back(vertex);
  }

  /*
   * Do the straight parts before and after a bend lie in one line, which passes it? From the last vertex on the line
   * before the bend to the first one behind it, the faces prove it. They do not where these vertices can be in the
   * place of the bend, nor where the line runs along edges.
   */
  bool are_in_line(const Crossing_word& word, const Taut_string::Bend* previous, const Kept_bend& kept,
                   const Taut_string::Bend* next, const Gap& after, Gap& joined) const
  {
    const Gap& before = kept.before;
    if(!before.is_straight || !after.is_straight || !before.is_clear || !after.is_clear)
      return false;
    const auto last = std::find_if(before.passed.rbegin(), before.passed.rend(),
                                   [&](const auto& vertex) { return vertex.last < kept.bend.first; });
    const auto first = std::find_if(after.passed.begin(), after.passed.end(),
                                    [&](const auto& vertex) { return vertex.first > kept.bend.last; });
    const Taut_string::Bend* const from = last == before.passed.rend() ? previous : &*last;
    const Taut_string::Bend* const to = first == after.passed.end() ? next : &*first;
    if(!is_passed_between(word, from, kept.bend, to))
      return false;
    joined = before;
    append_passed(kept.bend, joined.passed);
    for(const Taut_string::Bend& vertex : after.passed)
      append_passed(vertex, joined.passed);
    return true;
  }

  bool is_passed_between(const Crossing_word& word, const Taut_string::Bend* from, const Taut_string::Bend& bend,
                         const Taut_string::Bend* to) const
  {
    const Plane_vector in = bend.position - (from == nullptr ? m_source : from->position),
                       out = (to == nullptr ? m_target : to->position) - bend.position;
    const double least = unfunneled_angle * magnitude(m_target - m_source);
    const Crossing_word line = part(word, from, to);
    Line_contacts contacts;
    if(!(magnitude(in) > least && magnitude(out) > least) || line.crossed.empty() || !is_straight(line, contacts) ||
       contacts.have_edge)
      return false;
    const std::size_t first = from == nullptr ? 0 : from->last + 1;
    return std::any_of(contacts.ends.begin(), contacts.ends.end(), [&](const Line_contacts::Edge_end& end) {
      const std::size_t gate = first + end.gate;
      return gate >= bend.first && gate <= bend.last && end.is_left == (bend.side == LEFT_END);
    });
  }

  // From one bend to another, or the ends.
  Crossing_word part(const Crossing_word& word, const Taut_string::Bend* from, const Taut_string::Bend* to) const
  {
    Crossing_word result;
    const auto begin = word.crossed.begin();
    const std::size_t first = from == nullptr ? 0 : from->last + 1,
                      last = to == nullptr ? word.crossed.size() : to->first;
    if(first < last)
      result.crossed.assign(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
    result.tail = from == nullptr ? word.tail : vertex(word.crossed, *from);
    result.head = to == nullptr ? word.head : vertex(word.crossed, *to);
    return result;
  }

  bool is_straight(const Crossing_word& word) const
  {
    return Straight_strip<Triangulation>(m_triangulation, m_statistics)(word);
  }
  bool is_straight(const Crossing_word& word, Line_contacts& contacts) const
  {
    return Straight_strip<Triangulation>(m_triangulation, m_statistics)(word, contacts);
  }

  Vertex_index vertex(const std::vector<Input_halfedge_index>& crossed, const Taut_string::Bend& bend) const
  {
    const Input_halfedge_index h = crossed[bend.first];
    return bend.side == RIGHT_END ? m_faces.tail(h) : m_faces.head(h);
  }

  struct Placed_vertex
  {
    Vertex_index vertex;
    Plane_vector place;
  };

  // Across a part of the edges that are unfolded.
  Taut_piece piece_across(const std::vector<Input_halfedge_index>& crossed, std::size_t first, std::size_t last,
                          const Placed_vertex& from, const Placed_vertex& to) const
  {
    Taut_piece result;
    result.word.crossed.assign(crossed.begin() + static_cast<std::ptrdiff_t>(first),
                               crossed.begin() + static_cast<std::ptrdiff_t>(last));
    result.word.tail = from.vertex;
    result.word.head = to.vertex;
    const Plane_vector along = to.place - from.place;
    result.at_tail = {m_faces.previous(crossed[first]),
                      turn_between(Taut_string::end(m_gates, first, RIGHT_END) - from.place, along)};
    result.at_head = {m_faces.previous(twin_index(crossed[last - 1])),
                      turn_between(Taut_string::end(m_gates, last - 1, LEFT_END) - to.place, -along)};
    return result;
  }

  // The rotation from one vector counterclockwise to another, which lies there but for rounding.
  static Plane_vector turn_between(const Plane_vector& from, const Plane_vector& to)
  {
    const Plane_vector result = product(std::conj(from), to);
    return result.imag() > 0 ? normalized(result) : 1;
  }

  Taut_piece piece_in_face(Vertex_index tail, Vertex_index head, Input_halfedge_index face) const
  {
    Word_path<Triangulation> path(m_triangulation, tail, anchor(m_triangulation, tail, face));
    return measured_inside_face(path.finish(head, anchor(m_triangulation, head, face)));
  }

  // Of a word that crosses nothing.
  Taut_piece measured_inside_face(const Crossing_word& word) const
  {
    Taut_piece result;
    result.word = word;
    if(word.along != null_index) {
      result.at_tail.spoke = word.along;
      result.at_head.spoke = twin_index(word.along);
      return result;
    }
    result.at_tail = direction_in_face(word.tail, word.head, word.face);
    result.at_head = direction_in_face(word.head, word.tail, word.face);
    return result;
  }

  // From an end to another one that is inserted, in a face.
  Spoke_direction direction_in_face(Vertex_index v, Vertex_index to, Input_halfedge_index face) const
  {
    if(m_triangulation.is_inserted(v))
      return {};
    const Input_halfedge_index spoke = anchor(m_triangulation, v, face);
    const auto w = vertex_weights(m_triangulation, to, spoke);
    return {spoke, turn_between(1, w[1] + w[2] * m_faces.corner(spoke))};
  }

  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
  Input_faces<Triangulation> m_faces;
  std::vector<Taut_piece> m_pieces, m_before;
  std::vector<Way> m_ways;
  std::vector<Unfolded_gate> m_gates;
  std::vector<Input_halfedge_index> m_memory;
  Plane_vector m_source, m_target;
  Taut_string m_string;
  std::vector<Taut_string::Bend> m_bends;
  std::vector<Kept_bend> m_kept;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_TAUT_CHAIN_H
