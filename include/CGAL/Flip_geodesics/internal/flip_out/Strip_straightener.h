// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_STRIP_STRAIGHTENER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_STRIP_STRAIGHTENER_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Crossing_removal.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Iterative_unfolding.h>
#include <CGAL/Flip_geodesics/internal/numbers/Funnel.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Straightens an edge path on the input mesh by `Iterative_unfolding`, in plain doubles: an initial path for FlipOut,
 * which decides everything afterwards. The result is a chain of straight legs between vertices and not longer than the
 * path.
 *
 * The path first passes each of its vertices on the side with fewer faces, and then each vertex at which the string
 * bends on a side with an angle below pi, until there is none.
 */
template <class Triangulation>
class Strip_straightener
{
public:
  /* A straight line from vertex to vertex: along an edge, or across others. */
  using Leg = typename Iterative_unfolding<Triangulation>::Piece;

  explicit Strip_straightener(const Triangulation& triangulation)
    : m_unfolding(triangulation, Refused_faces::WITHOUT_CORNERS)
  {
  }

  /* Is there something straighter than the path, which is an edge path? */
  bool operator()(const std::vector<Halfedge_index>& path)
  {
    m_unfolding.reserve(path.size());
    m_unfolding.restart();
    m_path_length = 0;
    for(Halfedge_index of_path : path) {
      const Input_halfedge_index h = as_input(of_path);
      if(!m_unfolding.faces().has_halfedge(h) || (!legs().empty() && legs().back().head != m_unfolding.faces().tail(h)))
        return false; // no chain, which whoever adds the path refuses
      m_unfolding.append_edge(h);
      m_path_length += m_unfolding.faces().length(h);
    }
    Side_of_fewer_faces first_rule{{m_unfolding}};
    Side_below_pi rule{{m_unfolding}};
    return m_unfolding.pass_joints_once(first_rule) && m_unfolding.tighten(rule) && length() <= m_path_length &&
           !m_unfolding.faces().have_refused();
  }

  const std::vector<Leg>& legs() const { return m_unfolding.pieces(); }

  /* The length of the path that was straightened. */
  double path_length() const { return m_path_length; }

  /* The edges that a leg crosses. */
  std::vector<Crossed_edge> crossed(const Leg& leg)
  {
    std::vector<Crossed_edge> result;
    if(leg.first == leg.last)
      return result;
    const Sleeve<Triangulation>& sleeve = m_unfolding.unfolded(leg);
    const Plane_vector line = sleeve.head_place() - sleeve.tail_place();
    result.reserve(sleeve.edges().size());
    for(std::size_t i = 0; i < sleeve.edges().size(); ++i) {
      const Portal& portal = sleeve.portals()[i];
      const bool is_left_new = portal.side == LEFT_END;
      const double height = is_left_new ? cross(line, portal.end - sleeve.tail_place()) : 0;
      result.push_back({as_intrinsic(sleeve.edges()[i].crossed), is_left_new, height});
    }
    return result;
  }

private:
  using Bend = typename Iterative_unfolding<Triangulation>::Bend;

  double length() const
  {
    double result = 0;
    for(const Leg& leg : legs())
      result += leg.along == null_index ? well_rounded_length(leg.vector) : m_unfolding.faces().length(leg.along);
    return result;
  }

  // ---- rules of the unfolding

  struct Rounded_bends
  {
    static constexpr bool drops_loops = false; // a path that passes a vertex twice is left to FlipOut

    const Iterative_unfolding<Triangulation>& unfolding;

    const std::vector<Bend>& bends(const Crossing_word&) const { return unfolding.sleeve().bends(); }
  };

  struct Side_of_fewer_faces : Rounded_bends
  {
    Passed_side side(const Leg& in, const Leg& out, Passed_side before) const
    {
      const std::size_t left = number_of_corners(out.along, in.at_head.outgoing);
      const std::size_t right = number_of_corners(in.at_head.outgoing, out.along);
      if((std::min)(left, right) == blocked)
        return Passed_side::NONE;
      if(left == right)
        return before == Passed_side::NONE ? Passed_side::LEFT : before;
      return left < right ? Passed_side::LEFT : Passed_side::RIGHT;
    }

  private:
    static constexpr std::size_t blocked = static_cast<std::size_t>(-1);

    // From one outgoing halfedge counterclockwise to another.
    std::size_t number_of_corners(Input_halfedge_index from, Input_halfedge_index to) const
    {
      const Input_faces<Triangulation>& faces = this->unfolding.faces();
      std::size_t result = 0;
      do {
        if(faces.is_border(from))
          return blocked;
        from = faces.counterclockwise(from);
        ++result;
      } while(from != to);
      return result;
    }
  };

  struct Side_below_pi : Rounded_bends
  {
    Passed_side side(const Leg& in, const Leg& out, Passed_side) const
    {
      if(in.is_left_open && is_below_pi(out.at_tail, in.at_head))
        return Passed_side::LEFT;
      return in.is_right_open && is_below_pi(in.at_head, out.at_tail) ? Passed_side::RIGHT : Passed_side::NONE;
    }

  private:
    // Is the angle from one direction counterclockwise to another?
    bool is_below_pi(const Corner_direction& from, const Corner_direction& to) const
    {
      const Corner_angle angle = this->unfolding.faces().angle(from, to, unstraightened_angle);
      return !angle.is_beyond_pi && angle.turn.imag() > unstraightened_angle * magnitude(angle.turn);
    }
  };

  Iterative_unfolding<Triangulation> m_unfolding;
  double m_path_length = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_STRIP_STRAIGHTENER_H
