// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_MOVER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_MOVER_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Funnel_chain.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Surface_polyline.h>
#include <CGAL/Flip_geodesics/internal/flip_out/word_turns.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Word_angle.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A step of a way over the surface: from a canonical location on through an input face that it lies in, by one of the
 * face's halfedges. The next step, or the way's end, lies there as well. */
struct Way_step
{
  Surface_location from;
  Input_halfedge_index face;
};

/* A piece of a geodesic, and what is said of it. */
struct Measured_piece
{
  Funnel_piece piece;
  Surface_polyline crossings; // where it crosses edges
  double length = 0;
  Word_angle at_tail, at_head; // only at vertices of the input
  Certificate_verdict verdict = Certificate_verdict::PROVEN;
};

/* A geodesic from place to place. Its words name inserted ends by the vertices that they were for a moment. */
struct Geodesic_leg
{
  std::vector<Measured_piece> pieces;
  Surface_polyline points;
  double length = 0;
  Certificate_verdict verdict = Certificate_verdict::PROVEN;
  bool is_by_flips = false; // did it take flips?
};

/*
 * Moves the ends of geodesics. The path along a geodesic and on along a way is shortened by `Funnel_chain` and proven
 * straight by its words; where that does not succeed, by flips. The triangulation is the input's before and after.
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

  /* The geodesic to a new start or end, at which the way from the old one arrives; of a leg without pieces, which has
   * one point, that along the way. */
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

  /* How comparisons were decided. */
  const Decision_statistics& statistics() const { return m_statistics; }

private:
  // The ends of a leg as vertices, until they are taken back.
  class Inserted_ends
  {
  public:
    Inserted_ends(Triangulation& triangulation, const Surface_location& start, const Surface_location& end)
      : m_at_end(triangulation)
    {
      const auto no_curve = [](const auto&) {}; // lies on an edge that is split
      m_start = triangulation.insert(start, no_curve, nullptr);
      m_end = triangulation.insert(end, no_curve, nullptr);
      if(m_start == m_end)
        throw Invalid_curve_error("two points of a curve in a row are in one place");
    }

    Vertex_index start() const { return m_start; }
    Vertex_index end() const { return m_end; }

  private:
    Rollback<Triangulation> m_at_end;
    Vertex_index m_start, m_end;
  };

  static bool is_proven(const Geodesic_leg& leg)
  {
    return leg.verdict == Certificate_verdict::PROVEN || leg.verdict == Certificate_verdict::PROBABLE;
  }

  // ---- by words

  static Funnel_piece reversed(Funnel_piece piece)
  {
    piece.word.reverse();
    std::swap(piece.at_tail, piece.at_head);
    return piece;
  }

  // From the end that stays. Returns whether the path is a chain that no angle says to pull further.
  bool shorten_moved(const Geodesic_leg& leg, bool is_start, const std::vector<Way_step>& way,
                     const Inserted_ends& ends, Geodesic_leg& result)
  {
    const Vertex_index fixed = is_start ? ends.end() : ends.start(), moving = is_start ? ends.start() : ends.end();
    const std::size_t unproven = m_statistics.unproven_zeros;
    Funnel_chain<Triangulation> chain(m_triangulation, m_statistics);
    Crossing_word word; // of the last piece
    word.tail = fixed;
    for(std::size_t i = 0; i < leg.pieces.size(); ++i) {
      const Measured_piece& measured = leg.pieces[is_start ? leg.pieces.size() - 1 - i : i];
      Funnel_piece piece = is_start ? reversed(measured.piece) : measured.piece;
      piece.word.tail = i == 0 ? fixed : piece.word.tail;
      if(i + 1 < leg.pieces.size())
        chain.append(piece);
      else
        word = std::move(piece.word);
    }
    if(!chain.append_shortened(word_along(word, leg.pieces.empty(), way, moving)) || !chain.tighten() ||
       !are_joints_usable(chain.pieces()))
      return false;
    measure(chain.pieces(), is_start, &leg, unproven, result);
    return true;
  }

  // Are there vectors of all faces at the joints?
  bool are_joints_usable(const std::vector<Funnel_piece>& pieces) const
  {
    const auto& input = m_triangulation.input();
    for(std::size_t i = 1; i < pieces.size(); ++i) {
      const Vertex_index v = pieces[i].word.tail;
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

  // The word of a piece and of a way from its head; of the way alone if there is none.
  Crossing_word word_along(const Crossing_word& piece, bool is_way_alone, const std::vector<Way_step>& way,
                           Vertex_index end) const
  {
    Input_halfedge_index face = way.front().face;
    Word_path<Triangulation> path(m_triangulation, piece.tail,
                                  is_way_alone ? anchor(m_triangulation, piece.tail, face)
                                               : first_anchor(m_triangulation, piece));
    if(!is_way_alone) {
      path.cross(piece, false);
      face = piece.along == null_index ? piece.last_face() : face_along(m_triangulation.input(), piece.along);
    }
    for(const Way_step& step : way)
      enter(path, step, face);
    return path.finish(end, anchor(m_triangulation, end, face));
  }

  // Leads a path from one face that a place lies in to another.
  void enter(Word_path<Triangulation>& path, const Way_step& step, Input_halfedge_index& face) const
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

  // On the side that has no border.
  void turn_about(Word_path<Triangulation>& path, Vertex_index v, Input_halfedge_index from,
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

  // ---- what a leg is

  // Takes over the pieces, and what is known of those that `before` had as well; `unproven` zeros were there before these
  // pieces were examined.
  void measure(std::vector<Funnel_piece>&& pieces, bool is_reversed, const Geodesic_leg* before, std::size_t unproven,
               Geodesic_leg& result)
  {
    if(is_reversed)
      std::reverse(pieces.begin(), pieces.end());
    result.pieces.clear();
    result.verdict = Certificate_verdict::PROVEN;
    for(Funnel_piece& piece : pieces) {
      result.pieces.emplace_back();
      result.pieces.back().piece = is_reversed ? reversed(std::move(piece)) : std::move(piece);
    }
    const std::size_t old = before == nullptr ? 0 : before->pieces.size(), n = result.pieces.size();
    std::size_t first = 0, last = 0; // so many at the start and the end stay
    while(first < (std::min)(n, old) && is_same(result.pieces[first], before->pieces[first]))
      take_over(result.pieces[first], before->pieces[first]), ++first;
    while(last < (std::min)(n, old) - first && is_same(result.pieces[n - 1 - last], before->pieces[old - 1 - last]))
      take_over(result.pieces[n - 1 - last], before->pieces[old - 1 - last]), ++last;
    for(std::size_t i = first; i + last < n; ++i)
      measure(result.pieces[i]);
    join(unproven, result);
  }

  // Inserted ends are the same if they stay, and pieces at those that move are not.
  bool is_same(const Measured_piece& a, const Measured_piece& b) const
  {
    const Crossing_word &u = a.piece.word, &v = b.piece.word;
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
    const Crossing_word& word = measured.piece.word;
    const Strip<Triangulation> strip(m_triangulation, word);
    measured.length = strip.length();
    if(!m_triangulation.is_inserted(word.tail))
      measured.at_tail = tail_angle(strip);
    if(!m_triangulation.is_inserted(word.head))
      measured.at_head = head_angle(m_triangulation, strip, word);
    measured.crossings.reserve(word.crossed.size());
    for(std::size_t i = 0; i < word.crossed.size(); ++i) {
      const double at_left = strip.crossing(i);
      measured.crossings.push_back(canonical_location(
          m_triangulation.input(),
          {word.crossed[i], {{(std::max)(1 - at_left, least_weight), (std::max)(at_left, least_weight), 0}}}));
    }
    if(!measured.piece.is_straight)
      measured.verdict = Certificate_verdict::BENT_SEGMENT;
  }

  // Points, length and verdict of a leg whose pieces are measured; the points are its ends before.
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
      leg.points.push_back(m_triangulation.location(piece.piece.word.head));
      const Measured_piece& next = leg.pieces[i + 1];
      if(m_triangulation.is_inserted(next.piece.word.tail)) { // flips do not pull a path over its own end
        leg.verdict = Certificate_verdict::BENT_JOINT;
        continue;
      }
      const Seen_word in = {piece.piece.word, false, piece.at_head}, out = {next.piece.word, true, next.at_tail};
      if(compare_clockwise(m_triangulation, m_statistics, in, out) == SMALLER ||
         compare_clockwise(m_triangulation, m_statistics, out, in) == SMALLER)
        leg.verdict = (std::max)(leg.verdict, Certificate_verdict::BENT_JOINT);
    }
    leg.points.push_back(end);
    if(leg.verdict == Certificate_verdict::PROVEN && m_statistics.unproven_zeros > unproven)
      leg.verdict = Certificate_verdict::PROBABLE;
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
    std::vector<Crossing_word> words;
    const Surface_polyline pulled = m_straightener.straightened_if_possible(path, [&](auto& network) {
      const Shortening_report report = shorten(network);
      network.for_each_segment(Curve_index(0), [&](Segment_index s) {
        words.push_back(m_triangulation.crossing_word(network.halfedge(s)));
      });
      return report;
    });
    if(pulled.empty())
      return false;
    const Inserted_ends ends(m_triangulation, path.front(), path.back());
    Funnel_chain<Triangulation> chain(m_triangulation, m_statistics);
    const std::size_t unproven = m_statistics.unproven_zeros;
    if(words.empty())
      append_inside_face(path, ends, chain);
    for(const Crossing_word& word : words)
      chain.append_straight(word);
    chain.examine();
    measure(chain.pieces(), false, nullptr, unproven, result);
    return true;
  }

  // Of a path in one face.
  void append_inside_face(const Surface_polyline& path, const Inserted_ends& ends,
                          Funnel_chain<Triangulation>& chain) const
  {
    const Input_halfedge_index face = common_face(m_triangulation.input(), path.front(), path.back());
    Word_path<Triangulation> straight(m_triangulation, ends.start(), anchor(m_triangulation, ends.start(), face));
    chain.append_straight(straight.finish(ends.end(), anchor(m_triangulation, ends.end(), face)));
  }

  Triangulation& m_triangulation;
  Path_straightener<Triangulation> m_straightener;
  mutable Decision_statistics m_statistics;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_MOVER_H
