// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_POINT_COORDINATES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_POINT_COORDINATES_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

// Reads the coordinates of points: as doubles, or exactly if the kernel's number type has rational values.

namespace CGAL::Flip_geodesics::internal {

/* Returns the double to which a number rounds. */
template <class NT>
double imported_number(const NT& x)
{
  if constexpr(is_rational_number<NT>)
    return rounded_number(x);
  else
    return CGAL::to_double(x);
}

/* Returns the double to which a lazy number rounds; `CGAL::to_double()` guarantees five digits only, and others depend
 * on whether its exact value is known. */
template <class ET>
double imported_number(const Lazy_exact_nt<ET>& x)
{
  return x.approx().is_point() ? x.approx().inf() : imported_number(x.exact());
}

/* Returns whether a number changes when it is imported as a double. Uncertain cases, as for intervals, count as
 * changed. */
template <class NT>
bool is_rounded_number(const NT& x)
{
  if constexpr(is_within_double<NT>)
    return static_cast<void>(x), false;
  else
    return !CGAL::certainly(x == NT(imported_number(x)));
}

template <class Point>
using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x())>;

/* Whether the coordinates of points are rational numbers that are read exactly and need not be doubles. */
template <class Point>
inline constexpr bool has_rational_coordinates = is_rational_number<Coordinate<Point>>;

/* Detects points with an exact and an approximate value, such as those of kernels of lazy numbers. */
template <class Point, class = void>
constexpr bool is_lazy_point = false;
template <class Point>
constexpr bool is_lazy_point<Point, std::void_t<decltype(std::declval<const Point&>().approx().x().is_point()),
                                                decltype(std::declval<const Point&>().exact().x())>> = true;

/* Returns the exact coordinates of a point. */
template <class Point>
Rational_place rational_place(const Point& p)
{
  if constexpr(is_lazy_point<Point>)
    return rational_place(p.exact());
  else
    return rational_place(to_rational(p.x()), to_rational(p.y()), to_rational(p.z()));
}

/* The coordinates of a point in double-double arithmetic. If the low part of one is zero, it is a double. */
using Precise_place = std::array<Double_double, 3>;

template <class Point>
bool has_double_approximation(const Point& p)
{
  const auto& a = p.approx();
  return a.x().is_point() && a.y().is_point() && a.z().is_point();
}

template <class Point>
Precise_place precise_place(const Point& p)
{
  if constexpr(is_lazy_point<Point>) {
    const auto& a = p.approx();
    if(has_double_approximation(p))
      return {{{a.x().inf(), 0}, {a.y().inf(), 0}, {a.z().inf(), 0}}};
    return precise_place(p.exact());
  } else {
    return {precise_number(p.x()), precise_number(p.y()), precise_number(p.z())};
  }
}

/* Returns the vector from one point to another in double-double arithmetic. Each coordinate has a relative error of
 * little more than 2^-106; for doubles it is exact. */
template <class Point>
std::array<Double_double, 3> precise_vector(const Point& p, const Point& q)
{
  if constexpr(has_rational_coordinates<Point>) {
    const Precise_place from = precise_place(p), to = precise_place(q);
    std::array<Double_double, 3> result;
    for(std::size_t i = 0; i < 3; ++i) {
      if(from[i].low != 0 || to[i].low != 0)
        return precise_difference(rational_place(p), rational_place(q));
      result[i] = exact_sum(to[i].high, -from[i].high);
    }
    return result;
  } else {
    return precise_difference(Place_in_space{imported_number(p.x()), imported_number(p.y()), imported_number(p.z())},
                              Place_in_space{imported_number(q.x()), imported_number(q.y()), imported_number(q.z())});
  }
}

/* Returns the vectors from p to q, to r, and back, each coordinate rounded once. */
template <class Point>
std::array<std::array<double, 3>, 3> rounded_sides(const Point& p, const Point& q, const Point& r)
{
  const auto side = [](const Point& a, const Point& b) {
    const auto [x, y, z] = precise_vector(a, b);
    return std::array<double, 3>{x.high, y.high, z.high};
  };
  return {{side(p, q), side(q, r), side(r, p)}};
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_POINT_COORDINATES_H
