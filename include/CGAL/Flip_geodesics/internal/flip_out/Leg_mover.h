// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_MOVER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_MOVER_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Iterative_unfolding.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Input_faces.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* A straight line from vertex to vertex, given by its edge sequence, and its directions at both ends, which are known
 * at vertices of the input only. */
struct Funnel_piece
{
  Edge_sequence sequence;
  Corner_direction at_tail, at_head; // at the head, backward
  bool is_examined = false;          // whether exact straightness has been examined
  bool is_straight = false;          // the result
};

/*
 * Shortens a path on the input surface by `Iterative_unfolding`, starting from the sequences of edges that it crosses.
 * No edge is flipped, and the input is only read. The path is a chain of straight pieces that meet at vertices of the
 * input; its ends can also be inserted vertices.
 *
 * The shortest path in a sleeve is computed in doubles, so a piece can bend slightly; angles close to pi are
 * compared exactly.
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

  /* Appends a straight piece. */
  void append(const Funnel_piece& given)
  {
    Piece& piece = m_unfolding.append(given.sequence);
    piece.at_tail = given.at_tail;
    piece.at_head = given.at_head;
    piece.is_examined = given.is_examined;
    piece.is_straight = given.is_straight;
  }

  /* Appends the straight line of an edge sequence. */
  void append_straight(const Edge_sequence& sequence) { m_unfolding.append_straight(sequence); }

  /* Appends the shortest path in the sleeve of an edge sequence, that is, in the faces that a path passes. Returns
   * false if the sequence has no sleeve. */
  bool append_shortened(const Edge_sequence& sequence)
  {
    Exact_rule rule{*this};
    return m_unfolding.append_shortened(sequence, rule);
  }

  /* Leads the chain around vertices until no angle is below pi except by rounding errors, and examines the pieces. A
   * piece that still bends is marked as not straight. Returns false if passing a vertex is impossible. */
  bool tighten()
  {
    Exact_rule rule{*this};
    if(!m_unfolding.tighten(rule))
      return false;
    examine();
    return true;
  }

  /* Examines whether each piece is straight; changes no piece. */
  void examine()
  {
    for(Piece& piece : m_unfolding.pieces()) {
      piece.is_straight = piece.is_examined ? piece.is_straight : is_straight(m_unfolding.sequence(piece));
      piece.is_examined = true;
    }
  }

  std::vector<Funnel_piece> pieces() const
  {
    std::vector<Funnel_piece> result;
    result.reserve(m_unfolding.pieces().size());
    for(const Piece& piece : m_unfolding.pieces())
      result.push_back(
          {m_unfolding.sequence(piece), piece.at_tail, piece.at_head, piece.is_examined, piece.is_straight});
    return result;
  }

private:
  // The number of vertices kept near either end of those that a straight line passes: the nearest one and a bend can be
  // the two ends of an edge.
  static constexpr std::size_t most_passed = 2;

  // The rule of the unfolding.
  struct Exact_rule
  {
    static constexpr bool drops_loops = true; // drops a detour that leaves a bend and returns to it

    Funnel_chain& chain;

    Passed_side side(const Piece& in, const Piece& out, Passed_side) const { return chain.side_below_pi(in, out); }
    const std::vector<Bend>& bends(const Edge_sequence& ends) const
    {
      chain.find_bends();
      chain.drop_false_bends(ends);
      return chain.m_bends;
    }
  };

  // ---- angles

  // If the chain turns back on itself, the angle on either side is almost zero. Two pieces along one edge are given in
  // the faces on their left; the path from one to the other therefore leads across that edge, on the right.
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

  Edge_sequence sequence(const Seen_piece& seen) const
  {
    Edge_sequence result = m_unfolding.sequence(seen.piece);
    if(!seen.is_from_tail)
      result.reverse();
    return result;
  }

  // Compares the clockwise angle between two directions with pi; LARGER at the border. Exact if the error of both
  // directions is at most `unfunneled_angle`.
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
    return Wedge_comparison<Triangulation>(m_triangulation,
                                           m_statistics)(Wedge_edge_sequences{sequence(a), sequence(b), angle.corners});
  }

  // ---- bends

  const Sleeve<Triangulation>& sleeve() const { return m_unfolding.sleeve(); }
  const std::vector<Portal>& portals() const { return sleeve().portals(); }

  // Finds the bends of the shortest path and the vertices that it passes too closely for floating-point arithmetic to
  // decide the side.
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

  // An end of a portal that the line between two points passes closely. If every portal that ends at one vertex also
  // ends at another, one of the two suffices.
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

  // Returns the same vertex with all portals of which it is an end.
  Bend with_all_portals(Bend bend) const
  {
    while(bend.first > 0 && portals()[bend.first].side != bend.side)
      --bend.first;
    while(bend.last + 1 < portals().size() && portals()[bend.last + 1].side != bend.side)
      ++bend.last;
    return bend;
  }

  // The known properties of the path between two consecutive bends.
  struct Gap
  {
    bool is_known = false, is_straight = false; // whether exact straightness has been examined, and its result
    bool is_clear = false;                      // whether no crossed edge touches the line
    std::vector<Bend> passed;                   // the first and the last vertices on the line, `most_passed` each
  };

  // A bend that stays for now and the part of the path before it.
  struct Kept_bend
  {
    Bend bend;
    Gap before;
  };

  /*
   * Drops the bends that are small enough to be rounding errors and can be left out of a straight line. After a bend is
   * dropped, the previous one has another neighbor and is examined again.
   *
   * Following the line across everything dropped so far, for each bend, would take quadratic time along a row of
   * collinear vertices. Instead, two straight parts are joined if the line near the bend passes it exactly.
   */
  void drop_false_bends(const Edge_sequence& ends)
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

  // Returns whether the last kept bend is false. If so, the part between its neighbors replaces the part after it.
  bool is_last_false(const Edge_sequence& ends, const Bend* next, Gap& after)
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

  // Examines whether the part between two bends is straight, unless that is known.
  void examine(const Edge_sequence& ends, const Bend* from, const Bend* to, Gap& gap) const
  {
    if(gap.is_known)
      return;
    const Edge_sequence line = part(ends, from, to);
    Line_contacts contacts;
    gap.is_known = true;
    gap.is_straight = line.crossed.empty() ? line.tail != line.head : is_straight(line, contacts);
    gap.is_clear = !contacts.have_edge;
    const std::size_t first = from == nullptr ? 0 : from->last + 1;
    for(const Line_contacts::Edge_end& end : contacts.ends)
      append_passed(passed_vertex(first + end.portal, end.is_left ? LEFT_END : RIGHT_END), gap.passed);
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
   * Returns whether the straight parts before and after a bend are collinear along a line that passes the bend. The
   * faces from the last vertex on the line before the bend to the first one behind it prove this, unless these vertices
   * can coincide with the bend or the line runs along edges.
   */
  bool are_in_line(const Edge_sequence& ends, const Bend* previous, const Kept_bend& kept, const Bend* next,
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

  bool is_passed_between(const Edge_sequence& ends, const Bend* from, const Bend& bend, const Bend* to) const
  {
    const Plane_vector in = bend.position - (from == nullptr ? sleeve().tail_place() : from->position),
                       out = (to == nullptr ? sleeve().head_place() : to->position) - bend.position;
    const double least = unfunneled_angle * magnitude(sleeve().head_place() - sleeve().tail_place());
    const Edge_sequence line = part(ends, from, to);
    Line_contacts contacts;
    if(!(magnitude(in) > least && magnitude(out) > least) || line.crossed.empty() || !is_straight(line, contacts) ||
       contacts.have_edge)
      return false;
    const std::size_t first = from == nullptr ? 0 : from->last + 1;
    return std::any_of(contacts.ends.begin(), contacts.ends.end(), [&](const Line_contacts::Edge_end& end) {
      const std::size_t portal = first + end.portal;
      return portal >= bend.first && portal <= bend.last && end.is_left == (bend.side == LEFT_END);
    });
  }

  // The part from one bend to another, or to the ends.
  Edge_sequence part(const Edge_sequence& ends, const Bend* from, const Bend* to) const
  {
    Edge_sequence result;
    const std::size_t first = from == nullptr ? 0 : from->last + 1, last = to == nullptr ? portals().size() : to->first;
    result.crossed.reserve((std::max)(first, last) - first);
    for(std::size_t i = first; i < last; ++i)
      result.crossed.push_back(sleeve().edges()[i].crossed);
    result.tail = from == nullptr ? ends.tail : sleeve().vertex(*from);
    result.head = to == nullptr ? ends.head : sleeve().vertex(*to);
    return result;
  }

  bool is_straight(const Edge_sequence& sequence) const
  {
    return Straight_strip<Triangulation>(m_triangulation, m_statistics)(sequence);
  }
  bool is_straight(const Edge_sequence& sequence, Line_contacts& contacts) const
  {
    return Straight_strip<Triangulation>(m_triangulation, m_statistics)(sequence, nullptr, &contacts);
  }

  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
  Iterative_unfolding<Triangulation> m_unfolding;
  std::vector<Bend> m_bends;
  std::vector<Kept_bend> m_kept;
};

/* A step of a path over the surface: from a canonical surface point through an input face that contains it, given by
 * one of the face's halfedges. The next step, or the end of the path, lies in the same face. */
struct Way_step
{
  Surface_location from;
  Input_halfedge_index face;
};

/* A piece of a geodesic with its measured properties. */
struct Measured_piece
{
  Funnel_piece piece;
  Surface_polyline crossings; // where it crosses edges
  double length = 0;
  Edge_sequence_angle at_tail, at_head; // only at vertices of the input
  Verdict verdict = Verdict::PROVEN;
};

/* A geodesic between two surface points. Its edge sequences refer to inserted ends by the vertices that existed
 * temporarily. */
struct Geodesic_leg
{
  std::vector<Measured_piece> pieces;
  Surface_polyline points;
  double length = 0;
  Verdict verdict = Verdict::PROVEN;
  bool is_by_flips = false; // whether it was found by flips
};

/*
 * Moves the ends of geodesics. The path along a geodesic and its continuation is shortened by `Funnel_chain` and proven
 * straight from its edge sequences; if that fails, it is shortened by flips. The triangulation is that of the input
 * before and after.
 */
template <class Triangulation>
class Leg_mover
{
public:
  explicit Leg_mover(Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_straightener(triangulation)
  {
  }

  /* Returns the geodesic to a new start or end, at which the path from the old one arrives. For a geodesic without
   * pieces, which is a single point, returns the geodesic along that path. */
  Geodesic_leg moved(const Geodesic_leg& leg, bool is_start, const std::vector<Way_step>& way,
                     const Surface_location& to)
  {
    Geodesic_leg result;
    result.points = {is_start ? to : leg.points.front(), is_start ? leg.points.back() : to};
    bool is_shortened = false;
    {
      const Inserted_ends ends(m_triangulation, result.points.front(), result.points.back());
      is_shortened = shorten_moved(leg, is_start, way, ends, result);
    }
    if(is_shortened && is_proven(result))
      return result;
    Geodesic_leg by_flips;
    const bool is_pulled = pull_by_flips(is_shortened ? result.points : path_along(leg, is_start, way, to), by_flips);
    if(!is_pulled && !is_shortened) // flips cannot shorten paths that cross themselves
      m_straightener.throw_conflict();
    return is_shortened && !(is_pulled && is_proven(by_flips)) ? result : by_flips;
  }

  /* The statistics of exact comparisons. */
  const Decision_statistics& statistics() const { return m_statistics; }

private:
  // The ends of a geodesic as vertices, until they are rolled back.
  class Inserted_ends
  {
  public:
    Inserted_ends(Triangulation& triangulation, const Surface_location& start, const Surface_location& end)
      : m_at_end(triangulation)
    {
      const auto no_curve = [](const auto&) {}; // lies on an edge that is split
      m_start = triangulation.insert(start, no_curve);
      m_end = triangulation.insert(end, no_curve);
      if(m_start == m_end)
        throw Invalid_curve_error("two consecutive points of a curve coincide; omit one of them");
    }

    Vertex_index start() const { return m_start; }
    Vertex_index end() const { return m_end; }

  private:
    Rollback<Triangulation> m_at_end;
    Vertex_index m_start, m_end;
  };

  static bool is_proven(const Geodesic_leg& leg)
  {
    return leg.verdict == Verdict::PROVEN || leg.verdict == Verdict::PROBABLE;
  }

  // ---- by edge sequences

  static Funnel_piece reversed(Funnel_piece piece)
  {
    piece.sequence.reverse();
    std::swap(piece.at_tail, piece.at_head);
    return piece;
  }

  // Shortens from the end that stays. Returns whether the path is a chain without any angle that requires further
  // shortening.
  bool shorten_moved(const Geodesic_leg& leg, bool is_start, const std::vector<Way_step>& way,
                     const Inserted_ends& ends, Geodesic_leg& result)
  {
    const Vertex_index fixed = is_start ? ends.end() : ends.start(), moving = is_start ? ends.start() : ends.end();
    const std::size_t unproven = m_statistics.unproven_zeros;
    Funnel_chain<Triangulation> chain(m_triangulation, m_statistics);
    Edge_sequence sequence; // of the last piece
    sequence.tail = fixed;
    for(std::size_t i = 0; i < leg.pieces.size(); ++i) {
      const Measured_piece& measured = leg.pieces[is_start ? leg.pieces.size() - 1 - i : i];
      Funnel_piece piece = is_start ? reversed(measured.piece) : measured.piece;
      piece.sequence.tail = i == 0 ? fixed : piece.sequence.tail;
      if(i + 1 < leg.pieces.size())
        chain.append(piece);
      else
        sequence = std::move(piece.sequence);
    }
    if(!chain.append_shortened(sequence_along(sequence, leg.pieces.empty(), way, moving)) || !chain.tighten() ||
       !are_joints_usable(chain.pieces()))
      return false;
    measure(chain.pieces(), is_start, &leg, unproven, result);
    return true;
  }

  // Returns whether all faces at the joints have vectors.
  bool are_joints_usable(const std::vector<Funnel_piece>& pieces) const
  {
    const auto& input = m_triangulation.input();
    for(std::size_t i = 1; i < pieces.size(); ++i) {
      const Vertex_index v = pieces[i].sequence.tail;
      if(m_triangulation.is_inserted(v))
        continue;
      Input_halfedge_index h = input.outgoing(v);
      do {
        if(!input.is_border(h) && !is_usable_face(m_triangulation.metric(), input, h))
          return false;
        h = input.next(twin_index(h));
      } while(h != input.outgoing(v));
    }
    return true;
  }

  // The edge sequence of a piece and of a path from its head, or of the path alone if no piece is given.
  Edge_sequence sequence_along(const Edge_sequence& piece, bool is_way_alone, const std::vector<Way_step>& way,
                               Vertex_index end) const
  {
    Input_halfedge_index face = way.front().face;
    Edge_sequence_path<Triangulation> path(m_triangulation, piece.tail,
                                           is_way_alone ? anchor(m_triangulation, piece.tail, face)
                                                        : first_anchor(m_triangulation, tail_end(piece)));
    if(!is_way_alone) {
      path.cross(piece, false);
      face = piece.along == null_index ? piece.last_face() : face_along(m_triangulation.input(), piece.along);
    }
    for(const Way_step& step : way)
      enter(path, step, face);
    return path.finish(end, anchor(m_triangulation, end, face));
  }

  // Leads a path from one of the faces that contain a point to another.
  void enter(Edge_sequence_path<Triangulation>& path, const Way_step& step, Input_halfedge_index& face) const
  {
    const auto& input = m_triangulation.input();
    if(!is_side_of(input, face, step.face)) {
      if(kind(step.from) == Location_kind::EDGE)
        path.cross(location_anchor(input, step.from, face));
      else
        turn_about(path, input.tail(step.from.halfedge), face, step.face);
    }
    face = step.face;
  }

  struct Letters
  {
    std::vector<Input_halfedge_index> letters;
    void cross(Input_halfedge_index h) { letters.push_back(h); }
  };

  // Turns on the side without a border.
  void turn_about(Edge_sequence_path<Triangulation>& path, Vertex_index v, Input_halfedge_index from,
                  Input_halfedge_index to) const
  {
    const Input_halfedge_index a = anchor(m_triangulation, v, from), b = anchor(m_triangulation, v, to);
    Letters turned;
    if(!turn(m_triangulation.input(), turned, a, b, true)) {
      turned.letters.clear();
      turn(m_triangulation.input(), turned, a, b, false);
    }
    for(Input_halfedge_index h : turned.letters)
      path.cross(h);
  }

  // ---- measuring

  // Takes over the pieces, together with the results for those that `before` contains as well; `unproven` is the number
  // of unproven zeros before these pieces were examined.
  void measure(std::vector<Funnel_piece>&& pieces, bool is_reversed, const Geodesic_leg* before, std::size_t unproven,
               Geodesic_leg& result)
  {
    if(is_reversed)
      std::reverse(pieces.begin(), pieces.end());
    result.pieces.clear();
    result.verdict = Verdict::PROVEN;
    for(Funnel_piece& piece : pieces) {
      result.pieces.emplace_back();
      result.pieces.back().piece = is_reversed ? reversed(std::move(piece)) : std::move(piece);
    }
    const std::size_t old = before == nullptr ? 0 : before->pieces.size(), n = result.pieces.size();
    std::size_t first = 0, last = 0; // the number of pieces that stay at the start and the end
    while(first < (std::min)(n, old) && is_same(result.pieces[first], before->pieces[first]))
      take_over(result.pieces[first], before->pieces[first]), ++first;
    while(last < (std::min)(n, old) - first && is_same(result.pieces[n - 1 - last], before->pieces[old - 1 - last]))
      take_over(result.pieces[n - 1 - last], before->pieces[old - 1 - last]), ++last;
    for(std::size_t i = first; i + last < n; ++i)
      measure(result.pieces[i]);
    join(unproven, result);
  }

  // Pieces that end at an inserted vertex count as different, since that vertex may have moved.
  bool is_same(const Measured_piece& a, const Measured_piece& b) const
  {
    const Edge_sequence &u = a.piece.sequence, &v = b.piece.sequence;
    const auto is_end_same = [&](Vertex_index s, Vertex_index t) { return s == t && !m_triangulation.is_inserted(s); };
    return is_end_same(u.tail, v.tail) && is_end_same(u.head, v.head) && u.along == v.along && u.crossed == v.crossed;
  }

  static void take_over(Measured_piece& piece, const Measured_piece& before)
  {
    piece.crossings = before.crossings;
    piece.length = before.length;
    piece.at_tail = before.at_tail;
    piece.at_head = before.at_head;
    piece.verdict = before.verdict;
  }

  void measure(Measured_piece& measured)
  {
    const Edge_sequence& sequence = measured.piece.sequence;
    const Strip<Triangulation> strip(m_triangulation, sequence);
    measured.length = strip.length();
    if(!m_triangulation.is_inserted(sequence.tail))
      measured.at_tail = tail_angle(strip);
    if(!m_triangulation.is_inserted(sequence.head))
      measured.at_head = head_angle(m_triangulation, strip, sequence);
    measured.crossings.reserve(sequence.crossed.size());
    for(std::size_t i = 0; i < sequence.crossed.size(); ++i) {
      const double at_left = strip.crossing(i);
      measured.crossings.push_back(canonical_location(
          m_triangulation.input(),
          {sequence.crossed[i], {{(std::max)(1 - at_left, least_weight), (std::max)(at_left, least_weight), 0}}}));
    }
    if(!measured.piece.is_straight)
      measured.verdict = Verdict::BENT_SEGMENT;
  }

  // Sets points, length and verdict of a geodesic whose pieces are measured; its points are initially its two ends.
  void join(std::size_t unproven, Geodesic_leg& leg)
  {
    const Surface_location end = leg.points.back();
    leg.points.resize(1);
    for(std::size_t i = 0; i < leg.pieces.size(); ++i) {
      const Measured_piece& piece = leg.pieces[i];
      leg.length += piece.length;
      leg.verdict = (std::max)(leg.verdict, piece.verdict);
      leg.points.insert(leg.points.end(), piece.crossings.begin(), piece.crossings.end());
      if(i + 1 == leg.pieces.size())
        break;
      leg.points.push_back(m_triangulation.location(piece.piece.sequence.head));
      const Measured_piece& next = leg.pieces[i + 1];
      if(m_triangulation.is_inserted(next.piece.sequence.tail)) { // flips cannot shorten a path across its own end
        leg.verdict = Verdict::BENT_JOINT;
        continue;
      }
      const Seen_edge_sequence in = {piece.piece.sequence, false, piece.at_head},
                               out = {next.piece.sequence, true, next.at_tail};
      if(compare_clockwise(m_triangulation, m_statistics, in, out) == SMALLER ||
         compare_clockwise(m_triangulation, m_statistics, out, in) == SMALLER)
        leg.verdict = (std::max)(leg.verdict, Verdict::BENT_JOINT);
    }
    leg.points.push_back(end);
    if(leg.verdict == Verdict::PROVEN && m_statistics.unproven_zeros > unproven)
      leg.verdict = Verdict::PROBABLE;
  }

  // ---- by flips

  Surface_polyline path_along(const Geodesic_leg& leg, bool is_start, const std::vector<Way_step>& way,
                              const Surface_location& to) const
  {
    Surface_polyline path = leg.points;
    if(is_start)
      std::reverse(path.begin(), path.end());
    for(std::size_t i = 1; i < way.size(); ++i)
      path.push_back(way[i].from);
    path.push_back(to);
    if(is_start)
      std::reverse(path.begin(), path.end());
    return path;
  }

  // Returns false if the path crosses itself.
  bool pull_by_flips(const Surface_polyline& path, Geodesic_leg& result)
  {
    result.points = {path.front(), path.back()};
    result.is_by_flips = true;
    std::vector<Edge_sequence> sequences;
    const Surface_polyline pulled = m_straightener.straightened_if_possible(path, [&](auto& network) {
      const Shortening_report report = shorten(network);
      network.for_each_segment(Curve_index(0), [&](Segment_index s) {
        sequences.push_back(m_triangulation.edge_sequence(network.halfedge(s)));
      });
      return report;
    });
    if(pulled.empty())
      return false;
    const Inserted_ends ends(m_triangulation, path.front(), path.back());
    Funnel_chain<Triangulation> chain(m_triangulation, m_statistics);
    const std::size_t unproven = m_statistics.unproven_zeros;
    if(sequences.empty())
      append_inside_face(path, ends, chain);
    for(const Edge_sequence& sequence : sequences)
      chain.append_straight(sequence);
    chain.examine();
    measure(chain.pieces(), false, nullptr, unproven, result);
    return true;
  }

  // Of a path in one face.
  void append_inside_face(const Surface_polyline& path, const Inserted_ends& ends,
                          Funnel_chain<Triangulation>& chain) const
  {
    const Input_halfedge_index face = common_face(m_triangulation.input(), path.front(), path.back());
    Edge_sequence_path<Triangulation> straight(m_triangulation, ends.start(),
                                               anchor(m_triangulation, ends.start(), face));
    chain.append_straight(straight.finish(ends.end(), anchor(m_triangulation, ends.end(), face)));
  }

  Triangulation& m_triangulation;
  Path_straightener<Triangulation> m_straightener;
  mutable Decision_statistics m_statistics;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_MOVER_H
