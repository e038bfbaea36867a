// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_REFRESH_FACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_REFRESH_FACE_H

#include <CGAL/Flip_geodesics/internal/numbers/Funnel.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Precise_wedge.h>
#include <CGAL/Flip_geodesics/internal/triangulation/wedge_between.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <complex>
#include <limits>
#include <optional>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* What is measured of the face on the left of h: the lengths of h, next(h), previous(h), with bounds of their relative
 * errors, and the corners at the ends of h. */
struct Face_measures
{
  struct Length
  {
    double value, error;
  };

  std::array<Length, 3> lengths;
  Wedge_rotation at_tail, at_head;
};

/* The direction of a rotation by an angle between 0 and pi, up to rounding. */
inline std::complex<double> direction(const std::complex<double>& rotation)
{
  if(rotation.imag() <= 0)
    return rotation.real() < 0 ? -1 : 1;
  return rotation / well_rounded_length(rotation);
}

/*
 * Lays out a face. Nothing if its corners are not between 0 and pi, up to their error and a given one: then flips were
 * wrong.
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
  // Between vertices in one place h has no direction, and no corners at its ends; the one opposite is zero.
  const bool is_needle = first.value == 0;
  const std::complex<double> vn =
      is_needle ? second.value : -second.value * std::conj(direction(face.at_head.rotation));
  const std::complex<double> vp = is_needle ? -third.value : -third.value * direction(face.at_tail.rotation);
  const double error =
      (std::max)({first.error, second.error + face.at_head.angle.error, third.error + face.at_tail.angle.error}) +
      product_sum_error;
  return traits.construct_face_2_object()({{{first.value, 0}, {vn.real(), vn.imag()}, {vp.real(), vp.imag()}}}, error);
}

/* Lays out the face on the left of h from the input alone, by strips in double; nothing as above. */
template <class Triangulation>
std::optional<typename Triangulation::Traits::Face_geometry> fresh_face(const Triangulation& triangulation,
                                                                        Halfedge_index h, double tolerance)
{
  const Halfedge_index hn = triangulation.next(h), hp = triangulation.next(hn);
  const auto edge = [&](Halfedge_index side) {
    const Strip<Triangulation> strip(triangulation, triangulation.crossing_word(side));
    return Face_measures::Length{well_rounded_length(strip.end()), strip.relative_error()};
  };
  return laid_out_face(triangulation.traits(),
                       {{{edge(h), edge(hn), edge(hp)}},
                        wedge_rotation(triangulation, Triangulation::twin(hp), h),
                        wedge_rotation(triangulation, Triangulation::twin(h), hn)},
                       tolerance);
}

/* The same from edges as vectors of about 100 bits, where flips are never wrong. Nothing if these have no bound. */
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

/* Lays out the face on the left of h afresh. Returns false, and changes nothing, if flips were wrong already. */
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

/* Lays out the faces afresh clockwise from halfedge a to halfedge b of a vertex, up to the border if it
 * intervenes. Returns false at a face where flips were wrong already. */
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_REFRESH_FACE_H
