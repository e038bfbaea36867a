// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_LEG_FAN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_LEG_FAN_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_straightness.h>
#include <CGAL/Flip_geodesics/internal/triangulation/normal_coordinates.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Where the halfedges of a triangulation at a vertex of the input start, told one from the next: in which corner by
 * counting the input edges that start in between, at which angle there by the lengths that the triangulation has.
 */
template <class Triangulation>
class Spoke_places
{
public:
  explicit Spoke_places(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* The place of one of the halfedges around a vertex, and its number: of an edge of the input, if there is one, or
   * else of the one that crosses least. */
  Edge_end known_place(const std::vector<Halfedge_index>& around, std::size_t& number) const
  {
    const auto is_of_input = [this](Halfedge_index h) { return m_triangulation.version(Triangulation::edge(h)) == 0; };
    const auto crosses_less = [this](Halfedge_index g, Halfedge_index h) { return crossings(g) < crossings(h); };
    const auto of_input = std::find_if(around.begin(), around.end(), is_of_input);
    const bool is_known = of_input != around.end();
    const auto nearest = is_known ? of_input : std::min_element(around.begin(), around.end(), crosses_less);
    number = static_cast<std::size_t>(nearest - around.begin());
    return is_known ? Edge_end{*nearest, {as_input(*nearest), 0, 0}, true}
                    : Edge_straightness<Triangulation>(m_triangulation)(*nearest).tail;
  }

  /* From the place of the spoke before to that of h, the next one clockwise, over the input edges that start in
   * between. */
  void turn_clockwise(Halfedge_index h, Edge_end& place) const
  {
    const Halfedge_index opposite = m_triangulation.next(h), before = m_triangulation.next(opposite);
    const Index between = Triangle_crossings(crossings(opposite), crossings(before), crossings(h)).emanating[0];
    for(Index i = place.is_along ? 0 : 1; i <= between && place.direction.reference != null_index; ++i)
      pass_input_edge(place.direction);
    place.halfedge = h;
    place.direction.angle -=
        corner(m_triangulation.length(h), m_triangulation.length(opposite), m_triangulation.length(before));
    place.is_along = crossings(h) < 0;
    place.direction.angle = place.is_along ? 0 : place.direction.angle;
  }

private:
  Index crossings(Halfedge_index h) const { return m_triangulation.crossings(Triangulation::edge(h)); }

  void pass_input_edge(Word_angle& place) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index t = twin_index(place.reference);
    place.reference = input.is_border(t) ? Input_halfedge_index(null_index) : clockwise_of(input, place.reference);
    if(place.reference != null_index)
      place.angle += input_corner(m_triangulation, input.next(input.next(place.reference)));
  }

  // The angle of a face between its first edge and its last one, from their lengths.
  static double corner(double first, double opposite, double last)
  {
    using Double_traits = Intrinsic_triangulation_traits<typename Triangulation::Metric::Kernel>;
    const auto face = Double_traits().construct_face_from_lengths_object()(first, opposite, last);
    return std::atan2(-face[2].y, -face[2].x);
  }

  const Triangulation& m_triangulation;
};

/* An edge of the triangulation that starts at some vertex, and what is known of it. */
struct Fan_leg
{
  Edge_end start; // as the triangulation's lengths say, and measured once it is found
  Vertex_index head;
  Index crossings;  // of input edges
  double length;    // as the triangulation has it
  Edge_end arrival; // at its head, backward
  bool is_found;

  Input_halfedge_index reference() const { return start.direction.reference; }
};

/*
 * Measures edges that start at one vertex from the input, all at once: the faces that they cross are laid out from the
 * vertex on, and what edges have in common is laid out once. Their words are not needed.
 *
 *                      apex
 *                     /    .            the edges that pass a gate are parted by the corner
 *           left ----/------- right     beyond it: those on its left, the one that ends there,
 *               .   . .    .            and those on its right
 *                 .  .  .
 *                   . .
 *                    u
 *
 * An edge is looked for in the direction that the triangulation's lengths say. It is found if after its number of
 * crossings it comes upon its head, as far away as it is long, passes no vertex closely, and the straight line there
 * crosses all of the same edges. Otherwise nothing is said.
 */
template <class Triangulation>
class Leg_fan
{
  using Vector = std::complex<double>;
  using Face = std::array<Vector, 3>;

public:
  explicit Leg_fan(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_faces(static_cast<std::size_t>(triangulation.input().number_of_halfedges()))
  {
  }

  /* \pre the legs have one reference, along which none of them lies; ordered clockwise */
  void operator()(Fan_leg* first, Fan_leg* last)
  {
    m_directions.clear();
    for(Fan_leg* leg = first; leg != last; ++leg)
      m_directions.push_back(std::polar(1.0, leg->start.direction.angle));
    m_legs = first;
    const Input_halfedge_index h = first->reference();
    const Face& face = known_face(h);
    const Vector right(face[0].real(), 0), gate = face[1], left = -face[2];
    m_gates.push_back({m_triangulation.input().next(h), right, left, -gate, right, left, 0, m_directions.size(), 1});
    while(!m_gates.empty()) {
      Gate here = m_gates.back();
      m_gates.pop_back();
      while(is_crossed(here) && !m_triangulation.input().is_border(twin_index(here.crossed)))
        cross_gate(here);
    }
  }

private:
  // An input edge that legs cross, with the face to be entered behind it.
  struct Gate
  {
    Input_halfedge_index crossed;
    Vector right, left, across; // its ends, and the way from left to right
    Vector rightmost, leftmost; // between them straight lines pass all gates up to here
    std::size_t first, last;    // the legs
    Index crossings;            // so many, with this one
  };

  // The face on the left of h, in its frame. Legs of many vertices cross it.
  const Face& known_face(Input_halfedge_index h)
  {
    Face& face = m_faces[h];
    if(face[0].real() == 0) {
      const auto vectors = input_face_geometry(m_triangulation, h);
      for(std::size_t i = 0; i < 3; ++i)
        face[i] = Vector(vectors[i].x, vectors[i].y);
    }
    return face;
  }

  // Does one of its legs cross so many edges?
  bool is_crossed(const Gate& gate) const
  {
    for(std::size_t i = gate.first; i < gate.last; ++i)
      if(m_legs[i].crossings >= gate.crossings)
        return true;
    return false;
  }

  // To the next gate; where legs part, to the left one, and the right one is left for later.
  void cross_gate(Gate& here)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index entered = twin_index(here.crossed), to_apex = input.next(entered);
    const Face& vectors = known_face(entered);
    // Products of ratios of the face, as in `Strip`.
    const Vector turn = here.across / vectors[0].real();
    const Vector from_right = product(turn, vectors[1]);
    const Vector to_left = product(turn, vectors[2]);
    const bool is_near_right = std::norm(from_right) < std::norm(to_left);
    const Vector apex = is_near_right ? here.right + from_right : here.left - to_left;
    const double margin = near_leg_angle * std::sqrt(std::norm(apex));
    const std::size_t i = end_of_left(here, apex, margin);
    std::size_t j = i;
    for(; j < here.last && cross(apex, m_directions[j]) >= -margin; ++j)
      end(m_legs[j], here, apex, input.next(to_apex), to_left);
    const bool is_right_of_apex = cross(here.rightmost, apex) > 0, is_left_of_apex = cross(apex, here.leftmost) > 0;
    const auto turn_right = [&](Gate& gate) {
      gate.crossed = to_apex;
      gate.left = apex;
      gate.across = -from_right;
      gate.leftmost = is_left_of_apex ? apex : gate.leftmost;
      gate.first = j;
    };
    ++here.crossings;
    if(i == here.first)
      return turn_right(here);
    if(j < here.last) {
      m_gates.push_back(here);
      turn_right(m_gates.back());
    }
    here.crossed = input.next(to_apex);
    here.right = apex;
    here.across = -to_left;
    here.rightmost = is_right_of_apex ? apex : here.rightmost;
    here.last = i;
  }

  // Past the legs that pass a gate clearly on the left of the apex behind it.
  std::size_t end_of_left(const Gate& gate, const Vector& apex, double margin) const
  {
    constexpr std::size_t few = 8;
    const auto is_on_left = [&](const Vector& direction) { return cross(apex, direction) > margin; };
    const auto first = m_directions.begin() + static_cast<std::ptrdiff_t>(gate.first);
    const auto last = m_directions.begin() + static_cast<std::ptrdiff_t>(gate.last);
    const auto end = gate.last - gate.first < few ? std::find_if_not(first, last, is_on_left)
                                                  : std::partition_point(first, last, is_on_left);
    return static_cast<std::size_t>(end - m_directions.begin());
  }

  // A leg comes near to the corner opposite to a gate, from which `h` leads to the left.
  void end(Fan_leg& leg, const Gate& gate, const Vector& apex, Input_halfedge_index h, const Vector& along_h) const
  {
    const bool is_straight = cross(gate.rightmost, apex) > 0 && cross(apex, gate.leftmost) > 0;
    leg.is_found = is_straight && leg.crossings == gate.crossings && leg.head == m_triangulation.input().tail(h) &&
                   std::abs(std::sqrt(std::norm(apex)) - leg.length) <= near_leg_length * leg.length;
    if(!leg.is_found)
      return;
    leg.start.direction.angle = angle_from_reference(apex);
    leg.arrival.direction = {h, angle_from_reference(product(-apex, std::conj(along_h))), 0};
  }

  const Triangulation& m_triangulation;
  Indexed_by<Input_halfedge_index, Lazy_array<Face>> m_faces; // as far as they have been crossed
  Fan_leg* m_legs = nullptr;
  std::vector<Vector> m_directions; // of the legs
  std::vector<Gate> m_gates;        // still to be crossed
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_LEG_FAN_H
