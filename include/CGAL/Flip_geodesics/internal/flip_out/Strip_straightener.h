// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_STRIP_STRAIGHTENER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_STRIP_STRAIGHTENER_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Crossing_removal.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Input_faces.h>
#include <CGAL/Flip_geodesics/internal/numbers/Taut_string.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Straightens an edge path on the input mesh, which is only read, in plain doubles: a start for FlipOut, which decides
 * everything afterwards. The result is a chain of straight legs between vertices, that is as long as the path at most.
 *
 * By iterative unfolding [Xin, Wang, Efficiently Determining a Locally Exact Shortest Path on Polyhedral Surfaces,
 * 2007]: the path is pulled taut within a strip of faces, and the strip is led round the other side of the vertices
 * that the string bends about where the angle there is below pi, until there are none.
 *
 * The strip is cut where the string is done, at joints with at least pi on both sides. What crosses an edge keeps the
 * shape of the face beyond, so that the rounds after the first unfold the strip by a complex product a face.
 */
template <class Triangulation>
class Strip_straightener
{
public:
  /* A direction at a vertex: a spoke, turned counterclockwise by less than the corner of its face. */
  struct Direction
  {
    Input_halfedge_index spoke;
    Plane_vector turn; // of length 1
  };

  /* A straight line from vertex to vertex: along an edge, or across those of a range of crossings. */
  struct Leg
  {
    Input_halfedge_index along; // null_index if edges are crossed
    std::size_t first, last;
    Vertex_index tail, head;
    Direction at_tail, at_head; // at the head, backward
    double length;
    bool is_left_open = true, is_right_open = true; // can the angle on that side of the head be below pi?
  };

  explicit Strip_straightener(const Triangulation& triangulation)
    : m_faces(triangulation)
  {
  }

  /* Is there something straighter than the path, which is an edge path? */
  bool operator()(const std::vector<Halfedge_index>& path)
  {
    try {
      return straighten(path);
    } catch(const Degenerate_face_error&) {
    } catch(const Invalid_coordinate_error&) {
    }
    return false;
  }

  const std::vector<Leg>& legs() const { return m_legs; }

  /* The length of the path that was straightened. */
  double path_length() const { return m_path_length; }

  /* The edges that a leg crosses. */
  std::vector<Crossed_edge> crossed(const Leg& leg)
  {
    std::vector<Crossed_edge> result;
    if(leg.first == leg.last)
      return result;
    m_word.assign(m_crossings.begin() + static_cast<std::ptrdiff_t>(leg.first),
                  m_crossings.begin() + static_cast<std::ptrdiff_t>(leg.last));
    unfold();
    result.reserve(m_word.size());
    for(std::size_t i = 0; i < m_word.size(); ++i) {
      const bool is_left_new = m_gates[i].side == LEFT_END;
      const double height = is_left_new ? cross(m_target - m_source, m_gates[i].end - m_source) : 0;
      result.push_back({as_intrinsic(m_word[i].crossed), is_left_new, height});
    }
    return result;
  }

private:
  // An edge that is crossed, as a side of the face that is left, with its tail on the right; and of the face beyond,
  // the side on the right as seen from there, and the third corner where the edge leads from 1 to 0.
  struct Crossing
  {
    Input_halfedge_index crossed, right_side;
    Plane_vector corner;
  };

  // There are about as many rounds as rows of vertices between path and geodesic; FlipOut goes on from where they end.
  static constexpr int most_rounds = 1000;

  bool straighten(const std::vector<Halfedge_index>& path)
  {
    reserve(path.size());
    m_legs.clear();
    m_path_length = 0;
    for(Halfedge_index of_path : path) {
      const Input_halfedge_index h = as_input(of_path);
      if(!m_faces.has_halfedge(h) || (!m_legs.empty() && m_legs.back().head != m_faces.tail(h)))
        return false; // no chain, which whoever adds the path refuses
      m_legs.push_back(edge_leg(h));
      m_path_length += m_legs.back().length;
    }
    m_crossings.clear();
    if(!move_over_joints(&Strip_straightener::side_of_fewer_faces))
      return false;
    for(int round = 1; round < most_rounds && m_has_moved; ++round)
      if(!move_over_joints(&Strip_straightener::side_below_pi))
        return false;
    double length = 0;
    for(const Leg& leg : m_legs)
      length += leg.length;
    return length <= m_path_length;
  }

  // Takes memory for a path of a number of edges: its strip crosses about four at each vertex, if it crosses many.
  void reserve(std::size_t edges)
  {
    for(std::vector<Leg>* legs : {&m_legs, &m_before})
      legs->reserve(edges);
    for(std::vector<Crossing>* crossings : {&m_crossings, &m_used, &m_word})
      crossings->reserve(4 * edges);
    m_gates.reserve(4 * edges);
  }

  enum class Way { LEFT, RIGHT, NONE };

  // Leads the strip round each joint on the side that is chosen, and pulls strings between the joints where it is none.
  // Returns false if that cannot be.
  bool move_over_joints(Way (Strip_straightener::*choose)(const Leg&, const Leg&, Way) const)
  {
    m_legs.swap(m_before);
    m_legs.clear();
    m_used.swap(m_crossings);
    m_crossings.clear();
    m_has_moved = false;
    Way way = Way::NONE;
    for(std::size_t first = 0, i = 0; i < m_before.size(); ++i) {
      const Leg& leg = m_before[i];
      const bool is_last = i + 1 == m_before.size();
      const Way next = is_last ? Way::NONE : (this->*choose)(leg, m_before[i + 1], way);
      cross_edges_of(leg);
      if(leg.along != null_index && i > first && next != Way::NONE && next != way)
        cross_edge(way == Way::LEFT ? leg.along : twin_index(leg.along));
      if(next != Way::NONE) {
        pass(leg, m_before[i + 1], next);
      } else {
        if(i == first)
          keep(leg); // as nothing has moved, there is nothing to look at again
        else if(!pull(m_before[first].tail, leg.head, edge_over(m_before[i - 1], leg, way)))
          return false;
        m_word.clear();
        first = i + 1;
      }
      way = next;
    }
    return true;
  }

  // ---- sides of joints

  static constexpr std::size_t blocked = static_cast<std::size_t>(-1);

  Way side_of_fewer_faces(const Leg& in, const Leg& out, Way before) const
  {
    const std::size_t left = number_of_corners(out.along, in.at_head.spoke);
    const std::size_t right = number_of_corners(in.at_head.spoke, out.along);
    if((std::min)(left, right) == blocked)
      return Way::NONE;
    if(left == right)
      return before == Way::NONE ? Way::LEFT : before;
    return left < right ? Way::LEFT : Way::RIGHT;
  }

  // From one spoke counterclockwise to another.
  std::size_t number_of_corners(Input_halfedge_index from, Input_halfedge_index to) const
  {
    std::size_t result = 0;
    do {
      if(m_faces.is_border(from))
        return blocked;
      from = m_faces.counterclockwise(from);
      ++result;
    } while(from != to);
    return result;
  }

  Way side_below_pi(const Leg& in, const Leg& out, Way) const
  {
    if(in.is_left_open && is_below_pi(out.at_tail, in.at_head))
      return Way::LEFT;
    return in.is_right_open && is_below_pi(in.at_head, out.at_tail) ? Way::RIGHT : Way::NONE;
  }

  // Is the angle from one direction counterclockwise to another?
  bool is_below_pi(const Direction& from, const Direction& to) const
  {
    Plane_vector angle = std::conj(from.turn);
    if(!is_in_corner(from, to)) {
      Input_halfedge_index spoke = from.spoke;
      do {
        if(m_faces.is_border(spoke))
          return false;
        angle = product(angle, m_faces.corner(spoke));
        if(spoke != from.spoke && angle.imag() <= 0) // of the first corner, the rest can be nothing
          return false;
        spoke = m_faces.counterclockwise(spoke);
      } while(spoke != to.spoke);
    }
    angle = product(angle, to.turn);
    return angle.imag() > unstraightened_angle * magnitude(angle);
  }

  // Does a turn counterclockwise from one direction to another stay in one corner?
  static bool is_in_corner(const Direction& from, const Direction& to)
  {
    return from.spoke == to.spoke && cross(from.turn, to.turn) > 0;
  }

  // ---- crossings

  // What goes to and fro cancels.
  void cross_edge(Input_halfedge_index h)
  {
    const Input_halfedge_index entered = twin_index(h);
    if(!m_word.empty() && m_word.back().crossed == entered)
      m_word.pop_back();
    else
      m_word.push_back({h, m_faces.next(entered), m_faces.corner(entered)});
  }

  void cross_edges_of(const Leg& leg)
  {
    auto first = m_used.begin() + static_cast<std::ptrdiff_t>(leg.first);
    const auto last = m_used.begin() + static_cast<std::ptrdiff_t>(leg.last);
    for(; first != last && !m_word.empty() && m_word.back().crossed == twin_index(first->crossed); ++first)
      m_word.pop_back();
    m_word.insert(m_word.end(), first, last);
  }

  // Crosses the spokes on a side of the joint between two legs.
  void pass(const Leg& in, const Leg& out, Way way)
  {
    const Input_halfedge_index back = in.at_head.spoke, on = out.at_tail.spoke;
    if(way == Way::LEFT) {
      for(Input_halfedge_index s = in.along != null_index ? m_faces.clockwise(back) : back; s != on;
          s = m_faces.clockwise(s))
        cross_edge(s);
      return;
    }
    if(is_in_corner(in.at_head, out.at_tail))
      return;
    Input_halfedge_index s = m_faces.counterclockwise(back);
    for(; s != on; s = m_faces.counterclockwise(s))
      cross_edge(twin_index(s));
    if(out.along == null_index)
      cross_edge(twin_index(s));
  }

  // The edge that cuts off the joint of two edges of a face.
  Input_halfedge_index edge_over(const Leg& in, const Leg& out, Way way) const
  {
    return way == Way::LEFT ? twin_index(m_faces.next(out.at_tail.spoke)) : m_faces.next(in.at_head.spoke);
  }

  // Drops crossings of edges that end where the path does. Returns the edge that is left if all are dropped.
  Input_halfedge_index trim(Vertex_index source, Vertex_index target)
  {
    const auto touches = [&](const Crossing& c, Vertex_index v) {
      return m_faces.tail(c.crossed) == v || m_faces.head(c.crossed) == v;
    };
    std::size_t first = 0, last = m_word.size();
    while(first < last && touches(m_word[first], source))
      ++first;
    if(first == last) {
      const Input_halfedge_index entered = twin_index(m_word.back().crossed);
      return m_faces.head(entered) == source ? m_faces.next(entered) : twin_index(m_faces.previous(entered));
    }
    while(first < last && touches(m_word[last - 1], target))
      --last;
    if(first == last) {
      const Input_halfedge_index h = m_word[last].crossed;
      return m_faces.tail(h) == target ? m_faces.previous(h) : twin_index(m_faces.next(h));
    }
    m_word.resize(last);
    m_word.erase(m_word.begin(), m_word.begin() + static_cast<std::ptrdiff_t>(first));
    return null_index;
  }

  // ---- strings

  // Pulls a string from vertex to vertex across the edges of m_word, or along an edge if there are none. Returns false
  // if these do not lead from one to the other.
  bool pull(Vertex_index source, Vertex_index target, Input_halfedge_index edge)
  {
    m_has_moved = true;
    if(!m_legs.empty())
      m_legs.back().is_left_open = m_legs.back().is_right_open = true;
    if(!m_word.empty())
      edge = trim(source, target);
    if(edge != null_index) {
      m_legs.push_back(edge_leg(edge));
      return m_legs.back().tail == source && m_legs.back().head == target;
    }
    if(m_faces.apex(m_word.front().crossed) != source || m_faces.apex(twin_index(m_word.back().crossed)) != target)
      return false;
    unfold();
    m_string.pull(m_gates, m_source, m_target);
    const auto& bends = m_string.bends();
    Vertex_index tail = source;
    for(std::size_t b = 0; b <= bends.size(); ++b) {
      const std::size_t first = b == 0 ? 0 : bends[b - 1].last + 1;
      const std::size_t last = b == bends.size() ? m_gates.size() : bends[b].first;
      const Vertex_index head = b == bends.size() ? target : vertex(bends[b]);
      if(first < last)
        add_leg(tail, head, first, last, b == 0 ? m_source : bends[b - 1].position,
                b == bends.size() ? m_target : bends[b].position);
      else
        m_legs.push_back(edge_leg(edge_to_bend(b)));
      if(b < bends.size()) // on the side of the strip, the string is taut
        (bends[b].side == RIGHT_END ? m_legs.back().is_left_open : m_legs.back().is_right_open) = false;
      tail = head;
    }
    return true;
  }

  // Lays out the faces along m_word, from the right end of the first crossed edge at the origin. From gate to gate
  // there is one product to wait for, and no branch, since sides follow no pattern that a processor could guess.
  void unfold()
  {
    static constexpr double is_side[2][2] = {{1, 0}, {0, 1}};
    const Input_halfedge_index start = m_word.front().crossed;
    const double length = m_faces.length(start);
    m_source = length * m_faces.corner(start);
    m_gates.resize(m_word.size());
    m_gates.front() = {length, LEFT_END};
    double left_x = length, left_y = 0, across_x = -length, across_y = 0; // from there to the right end
    const std::size_t last = m_word.size() - 1;
    for(std::size_t i = 0; i < last; ++i) {
      const double x = m_word[i].corner.real(), y = m_word[i].corner.imag();
      const double apex_x = unfused(across_x * x) - unfused(across_y * y);
      const double apex_y = unfused(across_x * y) + unfused(across_y * x);
      const bool is_right = m_word[i + 1].crossed != m_word[i].right_side;
      m_gates[i + 1] = {{left_x + apex_x, left_y + apex_y}, is_right ? RIGHT_END : LEFT_END};
      const double on_right = is_side[is_right][1], on_left = is_side[is_right][0];
      left_x += unfused(on_left * apex_x);
      left_y += unfused(on_left * apex_y);
      const double turn_x = on_left + unfused((on_right - on_left) * x), turn_y = (on_right - on_left) * y;
      const double next_x = unfused(across_x * turn_x) - unfused(across_y * turn_y);
      across_y = unfused(across_x * turn_y) + unfused(across_y * turn_x);
      across_x = next_x;
    }
    m_target = Plane_vector(left_x, left_y) + product({across_x, across_y}, m_word[last].corner);
  }

  Vertex_index vertex(const Taut_string::Bend& bend) const
  {
    const Input_halfedge_index h = m_word[bend.first].crossed;
    return bend.side == RIGHT_END ? m_faces.tail(h) : m_faces.head(h);
  }

  // The edge to bend b, or to the end, from the bend before or the start, if nothing is crossed in between.
  Input_halfedge_index edge_to_bend(std::size_t b) const
  {
    const auto& bends = m_string.bends();
    if(b == 0) {
      const Input_halfedge_index h = m_word.front().crossed;
      return bends[b].side == RIGHT_END ? m_faces.previous(h) : twin_index(m_faces.next(h));
    }
    const bool is_on_right = bends[b - 1].side == RIGHT_END;
    const Input_halfedge_index h = m_word[bends[b - 1].last].crossed, entered = twin_index(h);
    if(b < bends.size() && bends[b].side != bends[b - 1].side)
      return is_on_right ? h : entered;
    return is_on_right ? m_faces.next(entered) : twin_index(m_faces.previous(entered));
  }

  Leg edge_leg(Input_halfedge_index h) const
  {
    return {h, 0, 0, m_faces.tail(h), m_faces.head(h), {h, 1}, {twin_index(h), 1}, m_faces.length(h)};
  }

  void add_leg(Vertex_index tail, Vertex_index head, std::size_t first, std::size_t last, const Plane_vector& from,
               const Plane_vector& to)
  {
    const Plane_vector along = to - from;
    const Direction at_tail = {m_faces.previous(m_word[first].crossed),
                               turn(Taut_string::end(m_gates, first, RIGHT_END) - from, along)};
    const Direction at_head = {m_faces.previous(twin_index(m_word[last - 1].crossed)),
                               turn(Taut_string::end(m_gates, last - 1, LEFT_END) - to, -along)};
    m_legs.push_back({null_index, m_crossings.size(), m_crossings.size() + last - first, tail, head, at_tail, at_head,
                      well_rounded_length(along)});
    m_crossings.insert(m_crossings.end(), m_word.begin() + static_cast<std::ptrdiff_t>(first),
                       m_word.begin() + static_cast<std::ptrdiff_t>(last));
  }

  // The rotation from one vector counterclockwise to another, which lies there but for rounding.
  static Plane_vector turn(const Plane_vector& from, const Plane_vector& to)
  {
    const Plane_vector result = product(std::conj(from), to);
    return result.imag() > 0 ? result / magnitude(result) : 1;
  }

  void keep(const Leg& leg)
  {
    m_legs.push_back(leg);
    m_legs.back().is_left_open = m_legs.back().is_right_open = false;
    m_legs.back().first = m_crossings.size();
    m_crossings.insert(m_crossings.end(), m_word.begin(), m_word.end());
    m_legs.back().last = m_crossings.size();
  }

  Input_faces<Triangulation> m_faces;
  std::vector<Leg> m_legs, m_before;
  std::vector<Crossing> m_crossings, m_used, m_word; // of the legs, of those before, of the strip that is unfolded
  std::vector<Unfolded_gate> m_gates;
  Plane_vector m_source, m_target;
  Taut_string m_string;
  double m_path_length = 0;
  bool m_has_moved = false; // in the last round
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_STRIP_STRAIGHTENER_H
