// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_PRECISE_WEDGE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_PRECISE_WEDGE_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Precise_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>

#include <CGAL/enum.h>

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

inline std::complex<double> in_double(const Double_double_vector& v) { return {v.x.high, v.y.high}; }

/* The edge of halfedge h, as the triangulation derives and keeps it, or unfolded. */
template <class Triangulation>
Precise_edge precise_edge(const Triangulation& triangulation, Halfedge_index h)
{
  if constexpr(Keeps_precise_numbers<Triangulation>::value)
    return triangulation.precise_edge(h);
  else
    return unfolded_edge(triangulation, triangulation.crossing_word(h));
}

/* The wedge clockwise from one edge of an input vertex to another; all the way round if they are the same. */
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

  /* Not about inserted vertices, nor between edges to them. */
  bool has_bound() const { return m_from.has_bound() && m_to.has_bound(); }

  const Precise_edge& from() const { return m_from; }
  const Precise_edge& to() const { return m_to; }

  /* From doubles, with an error as that of few roundings. */
  Wedge_angle angle() const
  {
    Angle_sum sum;
    double error = 1.6 * (m_from.end_error + m_to.end_error) + 4 * input_corner_error; // of the arc sine as well
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

  /* Adds the wedge to a rotation, and to its relative error. */
  void extend(Double_double_vector& rotation, double& error) const
  {
    rotation = rotation * (m_from.end * conjugate(m_to.end));
    error += m_from.end_error + m_to.end_error + 4 * double_double_vector_error;
    for_each_corner([&](const Precise_halfedge& side) {
      rotation = rotation * -conjugate(side.next);
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

/* A sum of wedges, of 2 pi at most, to be compared with pi. */
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

  /* EQUAL if the errors hide which it is. */
  Comparison_result compare_with_straight() const
  {
    const Comparison_result quick = m_angle.compare_with_straight();
    if(quick != EQUAL || !has_bound())
      return quick;
    // Near pi, the sine tells; errors are relative, as numbers are, to the product of lengths. Of two wedges that is a
    // fourth power, of which no square can be had: it is below the least double where lengths are below 2^-134.
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_PRECISE_WEDGE_H
