// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_PLANAR_SINE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_PLANAR_SINE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/Multiquadratic.h>
#include <CGAL/Flip_geodesics/internal/numbers/orientation.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * A line over a developable region with parallel rulings: faces that bend along parallel edges only, such as those of
 * an extrusion or a prism. They are unrolled into a plane with the direction of the rulings as one axis. There the line
 * leads up by the difference of two places along that direction, which is a rational number, and sideways by the
 * distances between the rulings, which is a sum of roots.
 */
template <class Place>
struct Unrolled_line
{
  std::vector<Place> places; // its start, one on each ruling that it crosses, and its end
  Sign side = ZERO;          // POSITIVE if it leads to the right of the rulings' direction
  Sign height = ZERO;        // POSITIVE if it leads along that direction
};

/* Adds the distances that an unrolled line leads sideways, times a factor, for rulings in direction u. */
inline void add_widths(const std::array<Integer, 3>& u, const std::array<Integer, 3>* places, std::size_t size,
                       const Integer& factor, Root_sum& sum)
{
  for(std::size_t i = 1; i < size; ++i) {
    const std::array<Integer, 3> normal = cross(u, difference(places[i], places[i - 1]));
    sum.add(factor, dot(normal, normal));
  }
}

/* Returns the sign of the sine of the angle clockwise from one unrolled line to another; it is uncertain if the default
 * work limit is exceeded. The rulings have the direction of the line between two places. */
template <class Place>
Uncertain<Sign> sine_of_unrolled_lines(const std::array<Place, 2>& ruling, const Unrolled_line<Place>& a,
                                       const Unrolled_line<Place>& b)
{
  const Sign first = a.height * b.side, second = CGAL::opposite(b.height * a.side);
  if(first == second || second == ZERO)
    return first;
  if(first == ZERO)
    return second;
  std::vector<Place> places(ruling.begin(), ruling.end());
  for(const Unrolled_line<Place>* line : {&a, &b})
    places.insert(places.end(), line->places.begin(), line->places.end());
  std::vector<std::array<Integer, 3>> integers(places.size());
  to_integers(places.data(), places.size(), integers.data());
  std::array<Integer, 3> u = difference(integers[1], integers[0]);
  const Integer common = boost::multiprecision::gcd(boost::multiprecision::gcd(u[0], u[1]), u[2]);
  for(Integer& x : u)
    x /= common;
  const auto *of_a = &integers[2], *of_b = of_a + a.places.size();
  const Integer height_of_a = dot(u, difference(of_b[-1], of_a[0])),
                height_of_b = dot(u, difference(integers.back(), of_b[0]));
  Root_sum sum;
  add_widths(u, of_b, b.places.size(), b.side == POSITIVE ? height_of_a : Integer(-height_of_a), sum);
  add_widths(u, of_a, a.places.size(), a.side == POSITIVE ? Integer(-height_of_b) : height_of_b, sum);
  Work_limit work;
  return sum.sign(work);
}

/*
 * Computes the sign of the sine of a wedge by exact predicates of points, if its input faces lie unfolded in one plane
 * of space, or bend along parallel edges only, so they can be unrolled into a plane. Most exact ties are of these
 * kinds: they occur in the plane parts and the extruded parts of technical models.
 *
 * PlaceOf maps an input vertex to three double coordinates or to a `Rational_place`. Edge sequences with an end at an
 * inserted vertex are not treated, since its coordinates are neither.
 */
template <class Mesh, class PlaceOf>
class Planar_sine
{
  using Place = decltype(std::declval<const PlaceOf&>()(Vertex_index()));
  using Exact_vector = internal::Exact_vector<Place>;
  using Halfedges = std::vector<Input_halfedge_index>;

public:
  Planar_sine(const Mesh& mesh, PlaceOf place_of, Flat_edges& flat_edges)
    : m_mesh(mesh)
    , m_place_of(place_of)
    , m_flat_edges(flat_edges)
  {
  }

  /*
   * The wedge leads from the direction of edge sequence a clockwise over `steps` input corners to that of edge sequence
   * b, and is below 2 pi. Returns false, and no sign, if its faces are not of these kinds.
   */
  bool operator()(const Edge_sequence& a, const Edge_sequence& b, Index steps, Sign& sine) const
  {
    const Vertex_index ends(m_mesh.number_of_vertices());
    if(a.tail >= ends || a.head >= ends || b.head >= ends)
      return false;
    Halfedges bends_of_a, bends_of_b, others;
    Input_halfedge_index bend = null_index;
    if(!add_bends(a, bend, bends_of_a) || !add_bends(b, bend, bends_of_b))
      return false;
    Input_halfedge_index h = reference(a);
    const Input_halfedge_index first_face = a.along != null_index ? twin_index(h) : h;
    for(Index i = 0; i < steps; ++i, h = m_mesh.next(twin_index(h))) {
      const bool is_start = i == 0 && a.along != null_index;
      if(!is_start && !add_bend(h, bend, others))
        return false;
    }
    if(bend == null_index)
      return sine_in_plane(a, b, first_face, sine);
    return sine_over_walls({a, first_face, bends_of_a}, {b, reference(b), bends_of_b}, bend, sine);
  }

private:
  // An edge sequence, a halfedge of its first face, and the crossed edges along which the faces bend.
  struct Line
  {
    const Edge_sequence& sequence;
    Input_halfedge_index first_face;
    const Halfedges& bends;
  };

  bool sine_in_plane(const Edge_sequence& a, const Edge_sequence& b, Input_halfedge_index face, Sign& sine) const
  {
    const Place node = place_of_tail(reference(a)), end_a = m_place_of(head(a)), end_b = m_place_of(head(b));
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const Sign side = side_of_face(axis, face);
      if(side == ZERO)
        continue;
      sine = side * orientation_along(axis, node, end_b, end_a);
      return true;
    }
    return false;
  }

  bool sine_over_walls(const Line& a, const Line& b, Input_halfedge_index bend, Sign& sine) const
  {
    Unrolled_line<Place> line_a, line_b;
    if(!unroll(a, bend, line_a) || !unroll(b, bend, line_b))
      return false;
    const Uncertain<Sign> result =
        sine_of_unrolled_lines<Place>({place_of_tail(bend), place_of_tail(twin_index(bend))}, line_a, line_b);
    sine = result.is_certain() ? result.make_certain() : ZERO;
    return result.is_certain();
  }

  // Returns false if the line turns back.
  bool unroll(const Line& line, Input_halfedge_index bend, Unrolled_line<Place>& result) const
  {
    result.places.push_back(place_of_tail(reference(line.sequence)));
    for(Input_halfedge_index h : line.bends)
      result.places.push_back(place_of_tail(h));
    result.places.push_back(m_place_of(head(line.sequence)));
    const Exact_vector up = vector(bend), way(result.places.front(), result.places.back());
    result.height = sign_of_dot(up, way);
    for(std::size_t i = 1; i < result.places.size(); ++i) {
      const Exact_vector part(result.places[i - 1], result.places[i]);
      const Sign side = side_of_part(up, part, i == 1 ? line.first_face : twin_index(line.bends[i - 2]));
      if(side != ZERO && side == CGAL::opposite(result.side))
        return false;
      result.side = result.side == ZERO ? side : result.side;
    }
    return true;
  }

  // POSITIVE if a part of a line in the plane of a face leads to the right of a vector in that plane.
  Sign side_of_part(const Exact_vector& up, const Exact_vector& part, Input_halfedge_index face) const
  {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const Sign turn = sign_of_cross(part, up, axis);
      if(turn != ZERO)
        return turn * side_of_face(axis, face);
    }
    return ZERO;
  }

  // Of the input edges that an edge sequence crosses; returns false if they do not all bend along parallel edges.
  bool add_bends(const Edge_sequence& sequence, Input_halfedge_index& bend, Halfedges& bends) const
  {
    for(Input_halfedge_index h : sequence.crossed)
      if(!add_bend(h, bend, bends))
        return false;
    return true;
  }

  bool add_bend(Input_halfedge_index h, Input_halfedge_index& bend, Halfedges& bends) const
  {
    if(m_flat_edges(h, [&] { return lies_in_one_plane(h); }))
      return true;
    if(bend == null_index ? !is_sharp(h) : !is_parallel(bend, h))
      return false;
    bend = bend == null_index ? h : bend;
    bends.push_back(h);
    return true;
  }

  // Returns whether the faces beside an edge bend by more than rounding errors. If they do not, the next ones probably
  // bend along edges that are not parallel, and examining them takes longer than computing with vectors.
  bool is_sharp(Input_halfedge_index h) const
  {
    const Exact_vector u = vector(h), v(place_of_tail(h), m_place_of(apex(h))),
                       w(place_of_tail(h), m_place_of(apex(twin_index(h))));
    double height = 0, size = 0, folded = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
      const double normal = u[k] * v[l] - u[l] * v[k];
      height += normal * w[i];
      size += std::abs(normal * w[i]);
      folded += normal * (u[k] * w[l] - u[l] * w[k]);
    }
    return folded > 0 || !(std::abs(height) < flat_bend * size);
  }

  bool is_parallel(Input_halfedge_index g, Input_halfedge_index h) const { return are_parallel(vector(g), vector(h)); }

  Exact_vector vector(Input_halfedge_index h) const { return {place_of_tail(h), place_of_tail(twin_index(h))}; }

  Place place_of_tail(Input_halfedge_index h) const { return m_place_of(m_mesh.tail(h)); }

  Input_halfedge_index reference(const Edge_sequence& sequence) const
  {
    return sequence.along != null_index ? sequence.along : m_mesh.next(m_mesh.next(sequence.crossed.front()));
  }

  Vertex_index head(const Edge_sequence& sequence) const
  {
    return sequence.along != null_index ? m_mesh.tail(twin_index(sequence.along))
                                        : apex(twin_index(sequence.crossed.back()));
  }

  Vertex_index apex(Input_halfedge_index h) const { return m_mesh.tail(m_mesh.next(m_mesh.next(h))); }

  // Returns whether the faces on both sides of an edge lie in one plane and are unfolded.
  bool lies_in_one_plane(Input_halfedge_index h) const
  {
    const Place p = m_place_of(m_mesh.tail(h)), q = m_place_of(m_mesh.tail(twin_index(h)));
    const Place r = m_place_of(apex(h)), s = m_place_of(apex(twin_index(h)));
    return orientation(p, q, r, s) == ZERO && is_unfolded(p, q, r, s);
  }

  // Returns whether r and s lie on different sides of the line through p and q. \pre the four lie in one plane
  static bool is_unfolded(const Place& p, const Place& q, const Place& r, const Place& s)
  {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const Sign of_r = orientation_along(axis, p, q, r);
      if(of_r != ZERO)
        return orientation_along(axis, p, q, s) == -of_r;
    }
    return false;
  }

  // Returns the orientation of the corners of a face as seen along an axis.
  Sign side_of_face(std::size_t axis, Input_halfedge_index h) const
  {
    return orientation_along(axis, place_of_tail(h), place_of_tail(twin_index(h)), m_place_of(apex(h)));
  }

  const Mesh& m_mesh;
  PlaceOf m_place_of;
  Flat_edges& m_flat_edges;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_PLANAR_SINE_H
