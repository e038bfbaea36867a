// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FUNNEL_CHAIN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FUNNEL_CHAIN_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Iterative_unfolding.h>
#include <CGAL/Flip_geodesics/internal/numbers/Funnel.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A straight line from vertex to vertex, by its word, and the directions in which it leaves its ends, which are known at
 * vertices of the input only. */
struct Funnel_piece
{
  Crossing_word word;
  Corner_direction at_tail, at_head; // at the head, backward
  bool is_examined = false;          // has its word been asked whether it is straight, exactly?
  bool is_straight = false;          // and is it?
};

/*
 * Shortens a path on the input surface by `Iterative_unfolding`, from the words of the edges that it crosses. Nothing
 * is flipped, and the input is only read. The path is a chain of straight pieces, which meet at vertices of the input;
 * its ends can also be inserted vertices.
 *
 * Strings are pulled in doubles, so that a piece can be bent a little; angles close to pi are compared exactly.
 */
template <class Triangulation>
class Funnel_chain
{
  using Piece = typename Iterative_unfolding<Triangulation>::Piece;
  using Bend = typename Iterative_unfolding<Triangulation>::Bend;

public:
  Funnel_chain(const Triangulation& triangulation, Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_statistics(statistics)
    , m_unfolding(triangulation, Refused_faces::UNUSABLE)
  {
  }

  /* Appends a piece that is straight. */
  void append(const Funnel_piece& given)
  {
    Piece& piece = m_unfolding.append(given.word);
    piece.at_tail = given.at_tail;
    piece.at_head = given.at_head;
    piece.is_examined = given.is_examined;
    piece.is_straight = given.is_straight;
  }

  /* Appends the straight line of a word. */
  void append_straight(const Crossing_word& word) { m_unfolding.append_straight(word); }

  /* Appends the shortest path in the sleeve of a word, that is, in the faces that a path passes. Returns false if the word
   * has no sleeve. */
  bool append_shortened(const Crossing_word& word)
  {
    Exact_rule rule{*this};
    return m_unfolding.append_shortened(word, rule);
  }

  /* Leads the chain round vertices until no angle is below pi, or none is but by rounding, and examines the pieces. A piece
   * that is bent all the same says so. Returns false if that cannot be. */
  bool tighten()
  {
    Exact_rule rule{*this};
    if(!m_unfolding.tighten(rule))
      return false;
    examine();
    return true;
  }

  /* Asks each piece whether it is straight, and changes none. */
  void examine()
  {
    for(Piece& piece : m_unfolding.pieces()) {
      piece.is_straight = piece.is_examined ? piece.is_straight : is_straight(m_unfolding.word(piece));
      piece.is_examined = true;
    }
  }

  std::vector<Funnel_piece> pieces() const
  {
    std::vector<Funnel_piece> result;
    result.reserve(m_unfolding.pieces().size());
    for(const Piece& piece : m_unfolding.pieces())
      result.push_back({m_unfolding.word(piece), piece.at_tail, piece.at_head, piece.is_examined, piece.is_straight});
    return result;
  }

private:
  // Of the vertices that a straight line passes, so many next to either end are kept: the nearest one and a bend can be
  // the two ends of an edge.
  static constexpr std::size_t most_passed = 2;

  // The rule of the unfolding.
  struct Exact_rule
  {
    static constexpr bool drops_loops = true; // what goes on from a bend and comes back

    Funnel_chain& chain;

    Passed_side side(const Piece& in, const Piece& out, Passed_side) const { return chain.side_below_pi(in, out); }
    const std::vector<Bend>& bends(const Crossing_word& ends) const
    {
      chain.find_bends();
      chain.drop_false_bends(ends);
      return chain.m_bends;
    }
  };

  // ---- angles

  // Where the chain turns back on itself, either side is next to nothing. Two pieces along one edge are given in the faces
  // on their left, so that the path from one to the other is over that edge, on the right.
  Passed_side side_below_pi(const Piece& in, const Piece& out) const
  {
    const Corner_direction &back = in.at_head, &on = out.at_tail;
    if(back.outgoing == on.outgoing && magnitude(back.turn - on.turn) <= unfunneled_angle)
      return Passed_side::RIGHT;
    if(compare_clockwise({in, false}, {out, true}) == SMALLER)
      return Passed_side::LEFT;
    return compare_clockwise({out, true}, {in, false}) == SMALLER ? Passed_side::RIGHT : Passed_side::NONE;
  }

  // A piece as seen from its tail or its head.
  struct Seen_piece
  {
    const Piece& piece;
    bool is_from_tail;

    const Corner_direction& direction() const { return is_from_tail ? piece.at_tail : piece.at_head; }
  };

  Crossing_word word(const Seen_piece& seen) const
  {
    Crossing_word result = m_unfolding.word(seen.piece);
    if(!seen.is_from_tail)
      result.reverse();
    return result;
  }

  // How the angle clockwise from one direction to another compares with pi; LARGER at the border. Exact if both
  // directions are right up to `unfunneled_angle`.
  Comparison_result compare_clockwise(const Seen_piece& a, const Seen_piece& b) const
  {
    const Corner_angle angle = m_unfolding.faces().angle(b.direction(), a.direction(), unfunneled_angle);
    if(angle.is_beyond_pi || m_unfolding.faces().have_refused())
      return LARGER;
    const double margin = unfunneled_angle * magnitude(angle.turn), sine = angle.turn.imag();
    if(sine < -margin)
      return LARGER;
    if(!angle.passes_near_pi && (sine > margin || angle.turn.real() > 0))
      return SMALLER;
    return Wedge_comparison<Triangulation>(m_triangulation, m_statistics)(Wedge_words{word(a), word(b), angle.corners});
  }

  // ---- bends

  const Sleeve<Triangulation>& sleeve() const { return m_unfolding.sleeve(); }
  const std::vector<Portal>& portals() const { return sleeve().portals(); }

  // Where the string bends, and vertices that it passes so closely that doubles do not tell on which side.
  void find_bends()
  {
    m_bends.clear();
    const std::vector<Bend>& bends = sleeve().bends();
    const std::size_t end = portals().size();
    for(std::size_t b = 0; b <= bends.size(); ++b) {
      const bool is_last = b == bends.size();
      const std::size_t first = b == 0 ? 0 : bends[b - 1].last + 1, last = is_last ? end : bends[b].first;
      const std::size_t limit = is_last ? end : bends[b].last;
      const Plane_vector from = b == 0 ? sleeve().tail_place() : bends[b - 1].position,
                         to = is_last ? sleeve().head_place() : bends[b].position;
      for(std::size_t i = first; i < last; ++i)
        for(Portal_side side : {RIGHT_END, LEFT_END})
          if(i == first || side == portals()[i].side)
            add_close_vertex({i, i, side, Funnel::end(portals(), i, side)}, from, to, limit);
      if(!is_last)
        m_bends.push_back(bends[b]);
    }
  }

  // An end of a portal that the line from one place to another passes closely. Of vertices of which one is an end of each
  // portal that the other is an end of, one is enough.
  void add_close_vertex(Bend bend, const Plane_vector& from, const Plane_vector& to, std::size_t limit)
  {
    const Plane_vector along = to - from;
    const double base = (std::min)(magnitude(bend.position - from), magnitude(to - bend.position));
    if(!(std::abs(cross(along, bend.position - from)) <= unfunneled_angle * base * magnitude(along)))
      return;
    bend = with_all_portals(bend);
    if((m_bends.empty() || bend.last > m_bends.back().last) && bend.last < limit)
      m_bends.push_back(bend);
  }

  // The same vertex with all portals of which it is an end.
  Bend with_all_portals(Bend bend) const
  {
    while(bend.first > 0 && portals()[bend.first].side != bend.side)
      --bend.first;
    while(bend.last + 1 < portals().size() && portals()[bend.last + 1].side != bend.side)
      ++bend.last;
    return bend;
  }

  // What is known of the part of the string between two bends that follow on one another.
  struct Gap
  {
    bool is_known = false, is_straight = false; // has its word been asked, exactly, and is it?
    bool is_clear = false;                      // are all crossed edges off the line?
    std::vector<Bend> passed;                   // the first vertices on the line and the last ones, `most_passed` each
  };

  // A bend that stays for now, and the part of the string before it.
  struct Kept_bend
  {
    Bend bend;
    Gap before;
  };

  /*
   * Where the string bends by so little that this can be rounding, and the line that leaves the bend out is straight.
   * When a bend is dropped, the one before has another neighbor, and is looked at again.
   *
   * To follow the line across all of what has been dropped, for each bend, would take quadratic time along a row of
   * vertices in line. But two straight parts make one if the line near the bend passes it exactly.
   */
  void drop_false_bends(const Crossing_word& ends)
  {
    m_kept.clear();
    Gap after;
    for(std::size_t i = 0; i < m_bends.size(); ++i) {
      const Bend* const next = i + 1 < m_bends.size() ? &m_bends[i + 1] : nullptr;
      m_kept.push_back({m_bends[i], std::exchange(after, Gap())});
      while(!m_kept.empty() && is_last_false(ends, next, after))
        m_kept.pop_back();
    }
    m_bends.clear();
    for(const Kept_bend& kept : m_kept)
      m_bends.push_back(kept.bend);
  }

  // Is the last kept bend false? Then the part between its neighbors takes the place of the one after it.
  bool is_last_false(const Crossing_word& ends, const Bend* next, Gap& after)
  {
    Kept_bend& kept = m_kept.back();
    const Bend* const previous = m_kept.size() > 1 ? &m_kept[m_kept.size() - 2].bend : nullptr;
    const Plane_vector at = kept.bend.position, from = previous == nullptr ? sleeve().tail_place() : previous->position,
                       to = next == nullptr ? sleeve().head_place() : next->position;
    if(std::abs(cross(at - from, to - at)) > unfunneled_angle * magnitude(at - from) * magnitude(to - at))
      return false;
    examine(ends, previous, &kept.bend, kept.before);
    examine(ends, &kept.bend, next, after);
    Gap joined;
    if(!are_in_line(ends, previous, kept, next, after, joined)) {
      if(part(ends, previous, next).crossed.empty())
        return false;
      examine(ends, previous, next, joined);
      if(!joined.is_straight)
        return false;
    }
    after = std::move(joined);
    return true;
  }

  // Asks the part between two bends whether it is straight, unless it has been asked.
  void examine(const Crossing_word& ends, const Bend* from, const Bend* to, Gap& gap) const
  {
    if(gap.is_known)
      return;
    const Crossing_word line = part(ends, from, to);
    Line_contacts contacts;
    gap.is_known = true;
    gap.is_straight = line.crossed.empty() ? line.tail != line.head : is_straight(line, contacts);
    gap.is_clear = !contacts.have_edge;
    const std::size_t first = from == nullptr ? 0 : from->last + 1;
    for(const Line_contacts::Edge_end& end : contacts.ends)
      append_passed(passed_vertex(first + end.gate, end.is_left ? LEFT_END : RIGHT_END), gap.passed);
  }

  Bend passed_vertex(std::size_t portal, Portal_side side) const
  {
    return with_all_portals({portal, portal, side, Funnel::end(portals(), portal, side)});
  }

  // Only the vertices next to either end matter.
  static void append_passed(const Bend& vertex, std::vector<Bend>& passed)
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
  bool are_in_line(const Crossing_word& ends, const Bend* previous, const Kept_bend& kept, const Bend* next,
                   const Gap& after, Gap& joined) const
  {
    const Gap& before = kept.before;
    if(!before.is_straight || !after.is_straight || !before.is_clear || !after.is_clear)
      return false;
    const auto last = std::find_if(before.passed.rbegin(), before.passed.rend(),
                                   [&](const auto& vertex) { return vertex.last < kept.bend.first; });
    const auto first = std::find_if(after.passed.begin(), after.passed.end(),
                                    [&](const auto& vertex) { return vertex.first > kept.bend.last; });
    const Bend* const from = last == before.passed.rend() ? previous : &*last;
    const Bend* const to = first == after.passed.end() ? next : &*first;
    if(!is_passed_between(ends, from, kept.bend, to))
      return false;
    joined = before;
    append_passed(kept.bend, joined.passed);
    for(const Bend& vertex : after.passed)
      append_passed(vertex, joined.passed);
    return true;
  }

  bool is_passed_between(const Crossing_word& ends, const Bend* from, const Bend& bend, const Bend* to) const
  {
    const Plane_vector in = bend.position - (from == nullptr ? sleeve().tail_place() : from->position),
                       out = (to == nullptr ? sleeve().head_place() : to->position) - bend.position;
    const double least = unfunneled_angle * magnitude(sleeve().head_place() - sleeve().tail_place());
    const Crossing_word line = part(ends, from, to);
    Line_contacts contacts;
    if(!(magnitude(in) > least && magnitude(out) > least) || line.crossed.empty() || !is_straight(line, contacts) ||
       contacts.have_edge)
      return false;
    const std::size_t first = from == nullptr ? 0 : from->last + 1;
    return std::any_of(contacts.ends.begin(), contacts.ends.end(), [&](const Line_contacts::Edge_end& end) {
      const std::size_t portal = first + end.gate;
      return portal >= bend.first && portal <= bend.last && end.is_left == (bend.side == LEFT_END);
    });
  }

  // From one bend to another, or the ends.
  Crossing_word part(const Crossing_word& ends, const Bend* from, const Bend* to) const
  {
    Crossing_word result;
    const std::size_t first = from == nullptr ? 0 : from->last + 1, last = to == nullptr ? portals().size() : to->first;
    result.crossed.reserve((std::max)(first, last) - first);
    for(std::size_t i = first; i < last; ++i)
      result.crossed.push_back(sleeve().edges()[i].crossed);
    result.tail = from == nullptr ? ends.tail : sleeve().vertex(*from);
    result.head = to == nullptr ? ends.head : sleeve().vertex(*to);
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

  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
  Iterative_unfolding<Triangulation> m_unfolding;
  std::vector<Bend> m_bends;
  std::vector<Kept_bend> m_kept;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FUNNEL_CHAIN_H
