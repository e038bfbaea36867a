// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_POINT_SIDE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_POINT_SIDE_H

#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Returns the exact orientation of three points of an input face, given by nonnegative weights: POSITIVE if they are in
 * counterclockwise order. */
inline Sign orientation_of_weights(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                   const std::array<double, 3>& r)
{
  return orientation({0, 0, 0}, p, q, r);
}

/*
 * Computes the side of an intrinsic edge on which a point lies in an input face that the edge passes: the sign of the
 * exact number that the input and the point's weights define. POSITIVE is the left side.
 *
 * The edge passes the face of gap i of its sequence between crossed edges i - 1 and i; the face at the tail is gap 0.
 */
template <class Triangulation>
class Point_side
{
public:
  Point_side(const Triangulation& triangulation, Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_statistics(statistics)
  {
  }

  Sign operator()(const Edge_sequence& sequence, std::size_t gap, const Surface_location& point) const
  {
    const std::array<double, 3> weights = weights_in_face(m_triangulation.input(), point, face_of_gap(sequence, gap));
    if(sequence.along != null_index)
      return weights[2] > 0 ? POSITIVE : ZERO;
    if(sequence.crossed.empty())
      return orientation_of_weights(vertex_weights(m_triangulation, sequence.tail, sequence.face),
                                    vertex_weights(m_triangulation, sequence.head, sequence.face), weights);
    const Uncertain<Sign> quick = in_double(sequence, gap, weights);
    if(quick.is_certain()) {
      ++m_statistics.by_strip;
      return quick.make_certain();
    }
    return exactly(sequence, gap, weights);
  }

  /* Returns the signed distance of the point to the left of the edge, rounded. */
  double distance(const Edge_sequence& sequence, std::size_t gap, const Surface_location& point) const
  {
    const std::array<double, 3> w = weights_in_face(m_triangulation.input(), point, face_of_gap(sequence, gap));
    if(sequence.crossed.empty())
      return 0; // decided exactly by the weights alone
    const Strip<Triangulation> strip(m_triangulation, sequence);
    const auto corners = strip.face(gap);
    std::complex<double> position = 0;
    for(int i = 0; i < 3; ++i)
      position += w[i] / (w[0] + w[1] + w[2]) * corners[i].position;
    return std::imag(std::conj(strip.end()) * position) / strip.length();
  }

private:
  Uncertain<Sign> in_double(const Edge_sequence& sequence, std::size_t gap, const std::array<double, 3>& w) const
  {
    const Strip<Triangulation> strip(m_triangulation, sequence);
    const auto corners = strip.face(gap);
    const double sum = w[0] + w[1] + w[2];
    std::complex<double> position = 0;
    double error = 0;
    for(int i = 0; i < 3; ++i) {
      position += w[i] / sum * corners[i].position;
      error += w[i] / sum * (corners[i].error + product_sum_error * std::abs(corners[i].position));
    }
    const double sine = std::imag(std::conj(strip.end()) * position);
    const double bound = (strip.length() + strip.end_error()) * error + strip.end_error() * std::abs(position) +
                         product_sum_error * strip.length() * std::abs(position);
    if(!(std::abs(sine) > bound))
      return Uncertain<Sign>::indeterminate();
    return sine > 0 ? POSITIVE : NEGATIVE;
  }

  Sign exactly(const Edge_sequence& sequence, std::size_t gap, const std::array<double, 3>& weights) const
  {
    const Unfolding_chains<Triangulation> unfolding(m_triangulation);
    return Exact_sign(m_statistics, sign_work_limit(m_triangulation))(
        {unfolding.point(sequence, gap, weights), unfolding.head(sequence, true)});
  }

  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_POINT_SIDE_H
