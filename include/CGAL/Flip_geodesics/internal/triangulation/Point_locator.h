// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POINT_LOCATOR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POINT_LOCATOR_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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
    return static_cast<std::size_t>((std::max)(m_triangulation.crossings(Triangulation::edge(h)), 0));
  }

  Triangle_crossings crossings(Halfedge_index h) const
  {
    const Halfedge_index hn = m_triangulation.next(h), hp = m_triangulation.next(hn);
    const auto number = [this](Halfedge_index side) { return m_triangulation.crossings(Triangulation::edge(side)); };
    return {number(h), number(hn), number(hp)};
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
      const Triangle_crossings corner = crossings(m_triangulation.next(g)); // corner 0 is the tail of g, 1 its head
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
    const Triangle_crossings c = crossings(h); // corners O, A, B
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
      throw Insertion_error("a point in the face of halfedge " + std::to_string(point.halfedge.idx()) +
                                " lies in no face of the triangulation, whose flips were wrong by rounding",
                            {static_cast<std::size_t>(point.halfedge.idx())});
    return nearest;
  }

  const Triangulation& m_triangulation;
  Point_side<Triangulation> m_side;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POINT_LOCATOR_H
