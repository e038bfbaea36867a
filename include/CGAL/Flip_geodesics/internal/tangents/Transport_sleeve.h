// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_TRANSPORT_SLEEVE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_TRANSPORT_SLEEVE_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/tangents/Place_frame.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* A part of a curve that crosses edges but passes no vertex: its first face, given by any halfedge, and the crossed
 * edges. */
struct Sleeve_segment
{
  Input_halfedge_index face;
  std::vector<Input_halfedge_index> crossed; // in order, each as a side of the face before it

  Input_halfedge_index last_face() const { return crossed.empty() ? face : twin_index(crossed.back()); }
};

/* Returns the reverse part. */
inline Sleeve_segment reversed(const Sleeve_segment& leg)
{
  Sleeve_segment result = {leg.last_face(), {}};
  for(std::size_t i = leg.crossed.size(); i-- > 0;)
    result.crossed.push_back(twin_index(leg.crossed[i]));
  return result;
}

/* Returns the weights of a canonical surface point in a face that contains it, relative to the face's halfedge h. */
template <class Input_mesh>
std::array<double, 3> weights_seen_from(const Input_mesh& input, const Surface_location& place, Input_halfedge_index h)
{
  if(kind(place) != Location_kind::VERTEX)
    return weights_in_face(input, place, h);
  const Vertex_index v = input.tail(place.halfedge);
  const Input_halfedge_index hn = input.next(h);
  return {{input.tail(h) == v ? 1.0 : 0.0, input.tail(h) != v && input.tail(hn) == v ? 1.0 : 0.0,
           input.tail(h) != v && input.tail(hn) != v ? 1.0 : 0.0}};
}

/*
 * The faces of a part of a curve, unfolded into the plane of the first one, with the start at the origin and the first
 * face's halfedge along the positive real axis. Faces are added as products of the vectors of their portals, as in a
 * `Ray`.
 */
template <class Triangulation>
class Unfolded_leg
{
public:
  using Vector = std::complex<double>;

  /* The farthest end of a portal on the wrong side of the straight line from start to end. */
  struct Violation
  {
    double distance = 0; // from the line
    Vertex_index vertex = null_index;
    std::size_t portal = 0;
  };

  /* \param start, end canonical surface points
   * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error */
  Unfolded_leg(const Triangulation& triangulation, const Surface_location& start, const Sleeve_segment& leg,
               const Surface_location& end)
    : m_triangulation(triangulation)
    , m_halfedge(leg.face)
  {
    lay_out_first_face(start);
    m_portals.reserve(leg.crossed.size());
    for(Input_halfedge_index h : leg.crossed)
      pass(h);
    find_end(end);
  }

  /* Returns the vector from the start to the end. */
  const Vector& end() const { return m_end; }

  Violation violation() const
  {
    Violation worst;
    const double length = std::abs(m_end);
    const auto note = [&](double distance, Input_halfedge_index h, std::size_t portal) {
      if(distance > worst.distance)
        worst = {distance, m_triangulation.input().tail(h), portal};
    };
    for(std::size_t i = 0; length > 0 && i < m_portals.size(); ++i) {
      const Portal& portal = m_portals[i];
      note(cross(portal.left, m_end) / length, twin_index(portal.crossed), i);
      note(cross(m_end, portal.right) / length, portal.crossed, i);
    }
    return worst;
  }

private:
  struct Portal
  {
    Vector right, left;
    Input_halfedge_index crossed;
  };

  // Computes the vectors of the last face, rotated such that its halfedge has the given direction.
  void lay_out(const Vector& direction)
  {
    const auto face = input_face_geometry(m_triangulation, m_halfedge);
    const Vector turn = direction / std::abs(direction);
    for(std::size_t i = 0; i < 3; ++i)
      m_vectors[i] = product(turn, Vector(face[i].x, face[i].y));
  }

  void lay_out_first_face(const Surface_location& start)
  {
    lay_out(1);
    const std::array<double, 3> w = weights_seen_from(m_triangulation.input(), start, m_halfedge);
    const double sum = w[0] + w[1] + w[2];
    for(std::size_t i = 0; i < 3; ++i) // from the corner's two sides
      m_corners[i] = w[(i + 2) % 3] / sum * m_vectors[(i + 2) % 3] - w[(i + 1) % 3] / sum * m_vectors[i];
  }

  void pass(Input_halfedge_index h)
  {
    const auto& input = m_triangulation.input();
    const std::size_t side = h == m_halfedge ? 0 : (h == input.next(m_halfedge) ? 1 : 2);
    const Vector right = m_corners[side], left = m_corners[(side + 1) % 3], portal = -m_vectors[side];
    m_portals.push_back({right, left, h});
    m_halfedge = twin_index(h);
    lay_out(portal);
    const bool is_near_right = std::norm(m_vectors[1]) < std::norm(m_vectors[2]);
    m_corners = {left, right, is_near_right ? right + m_vectors[1] : left - m_vectors[2]};
  }

  // From the corner with the largest weight.
  void find_end(const Surface_location& end)
  {
    const std::array<double, 3> w = weights_seen_from(m_triangulation.input(), end, m_halfedge);
    const double sum = w[0] + w[1] + w[2];
    const auto k = static_cast<std::size_t>((std::max_element)(w.begin(), w.end()) - w.begin());
    m_end = m_corners[k] + w[(k + 1) % 3] / sum * m_vectors[k] - w[(k + 2) % 3] / sum * m_vectors[(k + 2) % 3];
  }

  const Triangulation& m_triangulation;
  Input_halfedge_index m_halfedge; // the reference of the last face
  std::array<Vector, 3> m_vectors = {}, m_corners = {};
  std::vector<Portal> m_portals;
  Vector m_end = 0;
};

/*
 * The sleeve of faces along a polyline: surface points and, between two consecutive ones, the crossed edges. Vectors
 * are transported along it, and it can be shortened to a geodesic. Consecutive points differ.
 */
template <class Triangulation>
class Transport_sleeve
{
public:
  using Vector = std::complex<double>;

  /* The start of a part. */
  struct Start
  {
    Vector vector;   // from the start to the end, in the frame of the first face
    double position; // of its direction, in the start's `frame()` with the first face
    Vector unit() const { return vector == Vector(0) ? Vector(1) : vector / std::abs(vector); }
  };

  /* \throws Invalid_curve_error if the range is empty, or two consecutive points have no common face
   * \throws Invalid_location_error */
  template <class LocationRange>
  Transport_sleeve(const Triangulation& triangulation, const LocationRange& locations)
    : m_triangulation(triangulation)
  {
    std::size_t position = 0;
    for(const Surface_location& location : locations)
      add(location, position++);
    if(m_places.empty())
      throw Invalid_curve_error("a curve has no points");
  }

  const std::vector<Surface_location>& places() const { return m_places; }
  const std::vector<Sleeve_segment>& legs() const { return m_legs; }

  void reverse()
  {
    std::reverse(m_places.begin(), m_places.end());
    std::reverse(m_legs.begin(), m_legs.end());
    for(Sleeve_segment& leg : m_legs)
      leg = reversed(leg);
  }

  Place_frame<Triangulation> frame(std::size_t place) const { return {m_triangulation, m_places[place]}; }
  /* Returns a frame with the directions of a face that contains the point, also in another umbrella. */
  Place_frame<Triangulation> frame(std::size_t place, Input_halfedge_index face) const
  {
    return {m_triangulation, m_places[place], face};
  }

  Start start(std::size_t leg) const { return start_at(m_places[leg], m_legs[leg], m_places[leg + 1]); }
  Start start_backward(std::size_t leg) const
  {
    return start_at(m_places[leg + 1], reversed(m_legs[leg]), m_places[leg]);
  }

  /*
   * Returns the position at the last point to which a position at the first one is transported. At each point in
   * between, the angle to the curve is preserved; positions at vertices are first scaled to a full turn [PS98].
   * \throws Invalid_mesh_error if the curve leads from one umbrella to another, or its ends are not in the umbrellas of
   * `frame()`
   */
  double transported(double position) const
  {
    constexpr double pi = boost::math::constants::pi<double>();
    for(std::size_t i = 0; i < m_legs.size(); ++i) {
      const auto here = i == 0 ? frame(i) : frame(i, m_legs[i - 1].last_face());
      const auto there = i + 1 == m_legs.size() ? frame(i + 1) : frame(i + 1, m_legs[i].last_face());
      double angle = here.stretch() * (position - here.position(m_legs[i].face, start(i).unit()));
      if(here.has_whole_turns())
        angle = std::remainder(angle, 2 * pi);
      const double back = there.position(m_legs[i].last_face(), start_backward(i).unit());
      position = back + (angle + pi) / there.stretch();
    }
    return position;
  }

  /*
   * Shortens the curve to a geodesic, up to rounding errors; it keeps only vertices at which it bends. The curve should
   * be nearly shortest, so that few rounds are necessary. A round can restore what rounding errors made the previous
   * one change; the path is then nearly straight.
   *
   * \throws Degenerate_face_error if it is not
   */
  void straighten()
  {
    join_pieces();
    constexpr int most_rounds = 1000; // several rounds mean that shortest paths differ by rounding errors only
    bool has_changed = true;
    for(int round = 0; round < most_rounds && has_changed; ++round) {
      has_changed = divide_legs();
      has_changed = join_legs() || has_changed;
    }
    for(std::size_t i = 0; i < m_legs.size() && has_changed; ++i)
      if(const auto leg = unfolded(i); leg.violation().distance > straight_in_last_round * std::abs(leg.end()))
        throw Degenerate_face_error("the shortest path could not be determined: in nearly degenerate faces, rounding "
                                    "errors make it uncertain at which vertices it bends; repair these faces");
  }

private:
  const auto& input() const { return m_triangulation.input(); }

  bool has_place(const Surface_location& place, Input_halfedge_index h) const
  {
    const std::vector<Input_halfedge_index> faces = faces_of_location(input(), place);
    return !input().is_border(h) && std::find(faces.begin(), faces.end(), least_in_face(input(), h)) != faces.end();
  }

  // The face between two points: that of the second one's halfedge if curves name the face that they leave, or else any
  // common face.
  Input_halfedge_index face_between(const Surface_location& p, const Surface_location& q,
                                    Input_halfedge_index named) const
  {
    if(kind(q) == Location_kind::EDGE && has_place(p, named) && has_place(q, named))
      return named;
    return common_face(input(), p, q);
  }

  void add(const Surface_location& location, std::size_t position)
  {
    const Surface_location place = canonical_location(input(), location);
    if(!m_places.empty()) {
      const Surface_location& last = m_places.back();
      const bool is_same =
          kind(last) == kind(place) &&
          (kind(place) == Location_kind::VERTEX ? input().tail(last.halfedge) == input().tail(place.halfedge)
                                                : last.halfedge == place.halfedge && last.weights == place.weights);
      if(is_same)
        return;
      const Input_halfedge_index face = face_between(last, place, location.halfedge);
      if(face == null_index)
        throw_naming<Invalid_curve_error>("points ", Element{position - 1}, " and ", Element{position},
                                          " of a curve do not lie in a common face");
      m_legs.push_back({face, {}});
    }
    m_places.push_back(place);
  }

  Start start_at(const Surface_location& place, const Sleeve_segment& leg, const Surface_location& end) const
  {
    Start result = {Unfolded_leg<Triangulation>(m_triangulation, place, leg, end).end(), 0};
    result.position = Place_frame<Triangulation>(m_triangulation, place, leg.face).position(leg.face, result.unit());
    return result;
  }

  // Joins parts at points on edges and in faces, where the curve passes no vertex. Such parts do not cross edges.
  void join_pieces()
  {
    std::vector<Surface_location> places = {m_places.front()};
    std::vector<Sleeve_segment> legs;
    for(std::size_t i = 0; i < m_legs.size(); ++i) {
      if(i == 0 || kind(m_places[i]) == Location_kind::VERTEX) {
        if(i > 0)
          places.push_back(m_places[i]);
        legs.push_back(m_legs[i]);
        continue;
      }
      Sleeve_segment& leg = legs.back();
      if(least_in_face(input(), leg.last_face()) != least_in_face(input(), m_legs[i].face))
        push(leg, location_anchor(input(), m_places[i], leg.last_face()));
    }
    if(!m_legs.empty())
      places.push_back(m_places.back());
    m_places = std::move(places);
    m_legs = std::move(legs);
    for(std::size_t i = 0; i < m_legs.size(); ++i)
      trim(i);
  }

  static void push(Sleeve_segment& leg, Input_halfedge_index h)
  {
    if(!leg.crossed.empty() && leg.crossed.back() == twin_index(h))
      leg.crossed.pop_back();
    else
      leg.crossed.push_back(h);
  }

  bool is_on_edge(const Surface_location& place, Input_halfedge_index h) const
  {
    if(kind(place) == Location_kind::VERTEX)
      return input().tail(h) == input().tail(place.halfedge) ||
             input().tail(twin_index(h)) == input().tail(place.halfedge);
    return kind(place) == Location_kind::EDGE && are_of_one_edge(place.halfedge, h);
  }

  // A part must not cross the edges on which its ends lie.
  void trim(std::size_t i)
  {
    Sleeve_segment& leg = m_legs[i];
    std::size_t first = 0;
    while(first < leg.crossed.size() && is_on_edge(m_places[i], leg.crossed[first]))
      leg.face = twin_index(leg.crossed[first++]);
    leg.crossed.erase(leg.crossed.begin(), leg.crossed.begin() + static_cast<std::ptrdiff_t>(first));
    while(!leg.crossed.empty() && is_on_edge(m_places[i + 1], leg.crossed.back()))
      leg.crossed.pop_back();
  }

  Unfolded_leg<Triangulation> unfolded(std::size_t i) const
  {
    return {m_triangulation, m_places[i], m_legs[i], m_places[i + 1]};
  }

  // Divides parts that are not straight at the vertex that is farthest from the straight line.
  bool divide_legs()
  {
    bool has_changed = false;
    for(std::size_t i = 0; i < m_legs.size(); ++i) {
      const Unfolded_leg<Triangulation> leg = unfolded(i);
      const auto violation = leg.violation();
      if(!(violation.distance > straight_in_sleeve * std::abs(leg.end())))
        continue;
      divide(i, violation.vertex, violation.portal);
      has_changed = true;
    }
    return has_changed;
  }

  void divide(std::size_t i, Vertex_index v, std::size_t portal)
  {
    const Sleeve_segment leg = m_legs[i];
    const auto has_vertex = [&](std::size_t g) {
      return input().tail(leg.crossed[g]) == v || input().tail(twin_index(leg.crossed[g])) == v;
    };
    std::size_t last = portal + 1; // the first portal with the vertex is the given one
    while(last < leg.crossed.size() && has_vertex(last))
      ++last;
    const auto at = [&](std::size_t g) { return leg.crossed.begin() + static_cast<std::ptrdiff_t>(g); };
    m_legs[i].crossed.assign(leg.crossed.begin(), at(portal));
    const Sleeve_segment rest = {twin_index(leg.crossed[last - 1]), {at(last), leg.crossed.end()}};
    const auto next = static_cast<std::ptrdiff_t>(i + 1);
    m_legs.insert(m_legs.begin() + next, rest);
    m_places.insert(m_places.begin() + next, canonical_location(input(), {input().outgoing(v), {{1, 0, 0}}}));
  }

  // Leads the curve past vertices on a side on which its angle is less than pi.
  bool join_legs()
  {
    bool has_changed = false;
    for(std::size_t i = 1; i < m_legs.size();) {
      const bool is_joined = join(i);
      has_changed |= is_joined;
      i += is_joined ? 0 : 1;
    }
    return has_changed;
  }

  bool join(std::size_t i)
  {
    const Place_frame<Triangulation> about = frame(i, m_legs[i - 1].last_face());
    if(!about.has(m_legs[i].face)) // the border is on both sides
      return false;
    const Start back = start_backward(i - 1), forward = start(i);
    const double left = about.counterclockwise(forward.position, back.position),
                 right = about.counterclockwise(back.position, forward.position);
    if(!((std::min)(left, right) < boost::math::constants::pi<double>() - straight_in_sleeve))
      return false;
    const bool is_left = left < right;
    const bool is_direct = is_left ? back.position >= forward.position : forward.position >= back.position;
    go_round(i, is_left, is_direct);
    return true;
  }

  // Across the edges around the vertex, on the other side of it; none if both parts are in one corner and this is not a
  // full turn.
  void go_round(std::size_t i, bool is_left, bool is_direct)
  {
    Sleeve_segment& leg = m_legs[i - 1];
    const auto about = frame(i);
    Input_halfedge_index h = about.corner(leg.last_face());
    const Input_halfedge_index last = about.corner(m_legs[i].face);
    while(h != last || !is_direct) {
      const Input_halfedge_index crossed = is_left ? h : input().next(input().next(h));
      push(leg, crossed);
      h = is_left ? input().next(twin_index(crossed)) : twin_index(crossed);
      is_direct = true;
    }
    for(Input_halfedge_index crossed : m_legs[i].crossed)
      push(leg, crossed);
    m_legs.erase(m_legs.begin() + static_cast<std::ptrdiff_t>(i));
    m_places.erase(m_places.begin() + static_cast<std::ptrdiff_t>(i));
    trim(i - 1);
  }

  const Triangulation& m_triangulation;
  std::vector<Surface_location> m_places;
  std::vector<Sleeve_segment> m_legs;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_TRANSPORT_SLEEVE_H
