// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_REFRESH_FACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_REFRESH_FACE_H

#include <CGAL/Flip_geodesics/internal/Strip.h>
#include <CGAL/Flip_geodesics/internal/Wedge_angle.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <complex>
#include <limits>
#include <optional>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Lays out the face on the left of h from the input alone: lengths from the strips of its edges, angles from its corners
 * at the ends of h. Nothing if the corners are not between 0 and pi, up to their error and a given one: then flips were
 * wrong.
 */
template <class Triangulation>
std::optional<typename Triangulation::Traits::Face_geometry> fresh_face(const Triangulation& triangulation, Index h,
                                                                        double tolerance)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const Index hn = triangulation.next(h), hp = triangulation.next(hn);
  Wedge_angle at_tail = wedge_angle(triangulation, Triangulation::twin(hp), h);
  Wedge_angle at_head = wedge_angle(triangulation, Triangulation::twin(h), hn);
  for(Wedge_angle* angle : {&at_tail, &at_head}) {
    if(angle->value < -angle->error - tolerance || angle->value > pi + angle->error + tolerance)
      return {};
    angle->value = (std::min)((std::max)(angle->value, 0.0), pi);
  }

  const Strip<Triangulation> first(triangulation, triangulation.crossing_word(h));
  const Strip<Triangulation> second(triangulation, triangulation.crossing_word(hn));
  const Strip<Triangulation> third(triangulation, triangulation.crossing_word(hp));
  const std::complex<double> vn = std::polar(second.length(), pi - at_head.value);
  const std::complex<double> vp = -std::polar(third.length(), at_tail.value);
  const double error = (std::max)({first.relative_error(), second.relative_error() + at_head.error,
                                   third.relative_error() + at_tail.error}) +
                       8 * std::numeric_limits<double>::epsilon();
  return triangulation.traits().construct_face_2_object()(
      {{{first.length(), 0}, {vn.real(), vn.imag()}, {vp.real(), vp.imag()}}}, error);
}

/* Lays out the face on the left of h afresh. Returns false, and changes nothing, if flips were wrong already. */
template <class Triangulation>
bool refresh_face(Triangulation& triangulation, Index h)
{
  const auto geometry = fresh_face(triangulation, h, 0);
  if(geometry)
    triangulation.set_face_geometry(h, *geometry);
  return geometry.has_value();
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_REFRESH_FACE_H
