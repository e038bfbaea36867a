// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_REFRESH_FACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_REFRESH_FACE_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Returns the unfolded strip of a halfedge. */
template <class Triangulation>
Strip<Triangulation> strip_of(const Triangulation& triangulation, Halfedge_index h)
{
  return {triangulation, triangulation.edge_sequence(h)};
}

/*
 * Computes the angle clockwise from halfedge a to halfedge b, whose strips are given, around an inserted point inside
 * an input face. Directions are relative to one halfedge of the face; the number of times that they pass it follows
 * from edge to edge, in corners below pi.
 */
template <class Triangulation>
Wedge_rotation wedge_rotation_inside_face(const Triangulation& triangulation, Halfedge_index a, Halfedge_index b,
                                          const Strip<Triangulation>& from, const Strip<Triangulation>& to)
{
  constexpr double pi = boost::math::constants::pi<double>();
  double sum = 0, error = from.relative_error(), direction = std::arg(from.end());
  Halfedge_index h = a;
  do {
    h = triangulation.clockwise(h);
    const double next_direction = std::arg(h == b ? to.end() : strip_of(triangulation, h).end()),
                 corner = direction - next_direction;
    sum += corner < -pi / 2 ? corner + 2 * pi : (corner > 3 * pi / 2 ? corner - 2 * pi : corner);
    error += measured_angle_error;
    direction = next_direction;
  } while(h != b);
  return {{sum, 1.6 * (error + to.relative_error())}, product(from.end(), std::conj(to.end()))};
}

/* Returns the edge sequences of the wedge clockwise from one halfedge of a vertex to another. */
template <class Triangulation>
Wedge_edge_sequences wedge_sequences(const Triangulation& triangulation, Halfedge_index from, Halfedge_index to)
{
  Wedge_edge_sequences result = {triangulation.edge_sequence(from), triangulation.edge_sequence(to), 0};
  result.steps = triangulation.input_edges_in_wedge(from, to) + (result.from.along != null_index ? 1 : 0);
  return result;
}

/* Recomputes the wedge clockwise from halfedge a to halfedge b of one vertex from the input, given their strips. a == b
 * means the full turn. */
template <class Triangulation>
Wedge_rotation wedge_rotation(const Triangulation& triangulation, Halfedge_index a, Halfedge_index b,
                              const Strip<Triangulation>& from, const Strip<Triangulation>& to)
{
  const Vertex_index v = triangulation.tail(a);
  if(vertex_kind(triangulation, v) == Location_kind::FACE)
    return wedge_rotation_inside_face(triangulation, a, b, from, to);
  const Index steps = triangulation.input_edges_in_wedge(a, b) +
                      (triangulation.crossings(Triangulation::edge(a)) < 0 ? 1 : 0); // along an input edge
  return wedge_rotation(triangulation, v, from, to, steps);
}

template <class Triangulation>
Wedge_angle wedge_angle(const Triangulation& triangulation, Halfedge_index a, Halfedge_index b)
{
  return wedge_rotation(triangulation, a, b, strip_of(triangulation, a), strip_of(triangulation, b)).angle;
}

inline std::complex<double> in_double(const Double_double_vector& v) { return {v.x.high, v.y.high}; }

/* Returns the edge of halfedge h as derived and stored by the triangulation, or otherwise unfolded. */
template <class Triangulation>
Precise_edge precise_edge(const Triangulation& triangulation, Halfedge_index h)
{
  if constexpr(Internals<Triangulation>::has_precise_numbers)
    return Internals<Triangulation>::precise_edge(triangulation, h);
  else
    return unfolded_edge(triangulation, triangulation.edge_sequence(h));
}

/* The wedge clockwise from one edge of an input vertex to another; the full turn if they are the same. */
template <class Triangulation>
class Precise_wedge
{
public:
  Precise_wedge(const Triangulation& triangulation, Halfedge_index from, Halfedge_index to)
    : m_triangulation(&triangulation)
    , m_from(precise_edge(triangulation, from))
    , m_to(precise_edge(triangulation, to))
  {
    if(has_bound())
      m_corners = triangulation.input_edges_in_wedge(from, to) + m_from.first_corner;
  }

  /* Returns false for wedges around inserted vertices and between edges to them. */
  bool has_bound() const { return m_from.has_bound() && m_to.has_bound(); }

  const Precise_edge& from() const { return m_from; }
  const Precise_edge& to() const { return m_to; }

  /* Computes the angle in doubles; its error corresponds to a few rounding errors. */
  Wedge_angle angle() const
  {
    Angle_sum sum;
    double error = 1.6 * (m_from.end_error + m_to.end_error) + 4 * input_corner_error; // including the arc sine
    for_each_corner([&](const Precise_halfedge& side) {
      sum.add(-std::conj(in_double(side.next)));
      error += side.error + input_corner_error;
    });
    return {angle_from_reference(in_double(m_from.end)) - angle_from_reference(in_double(m_to.end)) + sum.value(),
            error};
  }

  Wedge_rotation rotation() const
  {
    Double_double_vector rotation = {{1, 0}, {}};
    double error = 0;
    extend(rotation, error);
    return {angle(), in_double(rotation)};
  }

  /* Multiplies a rotation by that of the wedge, and adds to its relative error. */
  void extend(Double_double_vector& rotation, double& error) const
  {
    rotation = rotation * (m_from.end * conj(m_to.end));
    error += m_from.end_error + m_to.end_error + 4 * double_double_vector_error;
    for_each_corner([&](const Precise_halfedge& side) {
      rotation = rotation * -conj(side.next);
      error += side.error + double_double_vector_error;
    });
  }

private:
  template <class Visit>
  void for_each_corner(const Visit& visit) const
  {
    for_each_corner_clockwise(m_triangulation->input(), m_from.tail_reference, m_corners,
                              [&](Input_halfedge_index t) { visit(precise_input_halfedge(*m_triangulation, t)); });
  }

  const Triangulation* m_triangulation;
  Precise_edge m_from, m_to;
  Index m_corners = 0; // input corners between the references
};

/* A sum of wedges of at most 2 pi, to be compared with pi. */
template <class Triangulation>
class Precise_angle_sum
{
public:
  void add(const Precise_wedge<Triangulation>& wedge)
  {
    if(!wedge.has_bound())
      m_angle.error = std::numeric_limits<double>::infinity();
    if(!has_bound())
      return;
    const Wedge_angle angle = wedge.angle();
    m_angle = {m_angle.value + angle.value, m_angle.error + angle.error};
    m_wedges.push_back(wedge);
  }

  bool has_bound() const { return m_angle.error < 1; }

  /* EQUAL if the errors hide the result. */
  Comparison_result compare_with_straight() const
  {
    const Comparison_result quick = m_angle.compare_with_straight();
    if(quick != EQUAL || !has_bound())
      return quick;
    // Near pi, the sign of the sine decides. Errors are relative, like the numbers, to the product of the lengths. For
    // two wedges this product is a fourth power, which must not be squared: that is below the least double if lengths
    // are below 2^-134.
    Double_double_vector rotation = {{1, 0}, {}};
    double error = 0;
    for(const Precise_wedge<Triangulation>& wedge : m_wedges)
      wedge.extend(rotation, error);
    if(!(std::abs(rotation.y.high) > 2 * error * (std::abs(rotation.x.high) + std::abs(rotation.y.high))))
      return EQUAL;
    return rotation.y.high > 0 ? SMALLER : LARGER;
  }

private:
  Wedge_angle m_angle = {0, 0};
  std::vector<Precise_wedge<Triangulation>> m_wedges;
};

/* Measures of the face on the left of h: the lengths of h, next(h), previous(h) with bounds on their relative errors,
 * and the corners at the ends of h. */
struct Face_measures
{
  struct Length
  {
    double value, error;
  };

  std::array<Length, 3> lengths;
  Wedge_rotation at_tail, at_head;
};

/* Returns the direction of a rotation by an angle between 0 and pi, up to rounding errors. */
inline std::complex<double> direction(const std::complex<double>& rotation)
{
  if(rotation.imag() <= 0)
    return rotation.real() < 0 ? -1 : 1;
  return rotation / well_rounded_length(rotation);
}

/*
 * Computes the vectors of a face. Returns nothing if its corners are not between 0 and pi, up to their error and a
 * given tolerance, since flips were then wrong.
 */
template <class Traits>
std::optional<typename Traits::Face_geometry> laid_out_face(const Traits& traits, const Face_measures& face,
                                                            double tolerance)
{
  constexpr double pi = boost::math::constants::pi<double>();
  for(const Wedge_angle& angle : {face.at_tail.angle, face.at_head.angle})
    if(angle.value < -angle.error - tolerance || angle.value > pi + angle.error + tolerance)
      return {};
  const auto& [first, second, third] = face.lengths;
  // If the ends of h coincide, h has no direction and no corners at its ends; the opposite corner is zero.
  const bool is_needle = first.value == 0;
  const std::complex<double> vn =
      is_needle ? second.value : -second.value * std::conj(direction(face.at_head.rotation));
  const std::complex<double> vp = is_needle ? -third.value : -third.value * direction(face.at_tail.rotation);
  const double error =
      (std::max)({first.error, second.error + face.at_head.angle.error, third.error + face.at_tail.angle.error}) +
      product_sum_error;
  return traits.construct_face_2_object()({{{first.value, 0}, {vn.real(), vn.imag()}, {vp.real(), vp.imag()}}}, error);
}

/* Recomputes the vectors of the face on the left of h from the input, by strips in doubles. Returns nothing if flips
 * were wrong. */
template <class Triangulation>
std::optional<typename Triangulation::Traits::Face_geometry> fresh_face(const Triangulation& triangulation,
                                                                        Halfedge_index h, double tolerance)
{
  const Halfedge_index hn = triangulation.next(h), hp = triangulation.next(hn);
  const Halfedge_index t = Triangulation::twin(h), tp = Triangulation::twin(hp);
  const auto first = strip_of(triangulation, h), second = strip_of(triangulation, hn),
             third = strip_of(triangulation, hp);
  const auto edge = [](const Strip<Triangulation>& strip) {
    return Face_measures::Length{well_rounded_length(strip.end()), strip.relative_error()};
  };
  return laid_out_face(triangulation.traits(),
                       {{{edge(first), edge(second), edge(third)}},
                        wedge_rotation(triangulation, tp, h, strip_of(triangulation, tp), first),
                        wedge_rotation(triangulation, t, hn, strip_of(triangulation, t), second)},
                       tolerance);
}

/* Recomputes the vectors of the face on the left of h from double-double vectors of its edges, for which flips are
 * never wrong. Returns nothing if an edge has no error bound. */
template <class Triangulation>
std::optional<typename Triangulation::Traits::Face_geometry> precise_face(const Triangulation& triangulation,
                                                                          Halfedge_index h)
{
  const Halfedge_index hn = triangulation.next(h), hp = triangulation.next(hn);
  const Precise_wedge<Triangulation> at_tail(triangulation, Triangulation::twin(hp), h);
  const Precise_wedge<Triangulation> at_head(triangulation, Triangulation::twin(h), hn);
  const auto edge = [](const Precise_edge& e) { return Face_measures::Length{e.length, e.end_error}; };
  const Face_measures face = {
      {{edge(at_tail.to()), edge(at_head.to()), edge(at_tail.from())}}, at_tail.rotation(), at_head.rotation()};
  if(!(face.at_tail.angle.error + face.at_head.angle.error < 1)) // infinite if an edge has no bound
    return {};
  return laid_out_face(triangulation.traits(), face, 0);
}

/* Recomputes the face on the left of h from the input. Returns false and changes nothing if flips were already
 * wrong. */
template <class Triangulation>
bool refresh_face(Triangulation& triangulation, Halfedge_index h)
{
  std::optional<typename Triangulation::Traits::Face_geometry> geometry;
  if constexpr(!Triangulation::Traits::Has_drift::value)
    geometry = precise_face(triangulation, h);
  if(!geometry)
    geometry = fresh_face(triangulation, h, 0);
  if(geometry)
    triangulation.set_face_geometry(h, *geometry);
  return geometry.has_value();
}

/* Recomputes the faces clockwise from halfedge a to halfedge b of a vertex, or up to the border if it intervenes.
 * Returns false at a face in which flips were already wrong. */
template <class Triangulation>
bool refresh_wedge(Triangulation& triangulation, Halfedge_index a, Halfedge_index b)
{
  Halfedge_index h = a;
  do {
    const Halfedge_index t = Triangulation::twin(h);
    if(triangulation.is_border(t))
      return true;
    if(!refresh_face(triangulation, t))
      return false;
    h = triangulation.next(t);
  } while(h != b);
  return true;
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_REFRESH_FACE_H
