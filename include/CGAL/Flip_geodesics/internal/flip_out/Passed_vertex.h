// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PASSED_VERTEX_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PASSED_VERTEX_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_comparison.h>

#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <complex>
#include <optional>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Are the angles between two straight words at an input vertex at least pi, exactly? The words are in no triangulation. */
template <class Places>
class Passed_vertex
{
public:
  Passed_vertex(const Places& places, Decision_statistics& statistics)
    : m_places(places)
    , m_statistics(statistics)
  {
  }

  /*
   * What the angle clockwise from one word to another lacks to pi, in radians, rounded. Nothing if it does not, or if
   * the border is in between. Two words in one direction have an angle of zero.
   */
  std::optional<double> missing_angle(const Crossing_word& from, const Crossing_word& to) const
  {
    constexpr double pi = boost::math::constants::pi<double>();
    const Input_halfedge_index last = tail_anchor(m_places, to);
    Wedge_words words = {from, to, 0};
    Input_halfedge_index h = tail_anchor(m_places, from);
    const Order order = h == last ? order_in_one_face(from, to) : Order::COUNTERCLOCKWISE;
    if(order == Order::SAME)
      return pi;
    if(order == Order::COUNTERCLOCKWISE)
      do {
        const Input_halfedge_index t = twin_index(h);
        if(m_places.input().is_border(t))
          return {};
        check_triangle(m_places.input(), t);
        h = m_places.input().next(t);
        ++words.steps;
      } while(h != last);
    if(Wedge_comparison<Places>(m_places, m_statistics)(words) != SMALLER)
      return {};
    return (std::max)(pi - wedge_angle(m_places, words).value, 0.0);
  }

private:
  // Where one direction is from another.
  enum class Order { CLOCKWISE, SAME, COUNTERCLOCKWISE };

  // Where `to` is from `from`, both told from one halfedge. Where the face is a half plane without area, they can be
  // opposite.
  Order order_in_one_face(const Crossing_word& from, const Crossing_word& to) const
  {
    const Unfolding_chains<Places> unfolding(m_places);
    const Sign sine =
        Exact_sign(m_statistics, sign_work_limit(m_places))({unfolding.head(from, false), unfolding.head(to, true)});
    if(sine != ZERO)
      return sine == POSITIVE ? Order::CLOCKWISE : Order::COUNTERCLOCKWISE;
    const std::complex<double> a = Strip<Places>(m_places, from).end(), b = Strip<Places>(m_places, to).end();
    if(std::real(a * std::conj(b)) > 0)
      return Order::SAME;
    return angle_from_reference(a) > angle_from_reference(b) ? Order::CLOCKWISE : Order::COUNTERCLOCKWISE;
  }

  const Places& m_places;
  Decision_statistics& m_statistics;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PASSED_VERTEX_H
