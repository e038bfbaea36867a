// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_POINT_COORDINATES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_POINT_COORDINATES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>

// Reads the coordinates of points: as doubles, or exactly if the kernel's number type has rational values.

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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

/* Returns the approximate coordinates of a precise point. */
inline Approximate_place approximate_place(const Precise_place& p)
{
  const auto number = [](const Double_double& x) { return Approximate_number{x.high, 2 * std::abs(x.low)}; };
  return {number(p[0]), number(p[1]), number(p[2])};
}

/* Returns the approximate coordinates of a point over lazy numbers, from its intervals. The point is evaluated first,
 * since its intervals depend on whether it was evaluated. */
template <class Point>
Approximate_place approximate_place(const Point& p)
{
  if(!has_double_approximation(p))
    p.exact();
  const auto& a = p.approx();
  const auto number = [](const auto& x) {
    return x.is_point() ? Approximate_number{x.inf(), 0}
                        : Approximate_number{0.5 * x.inf() + 0.5 * x.sup(), x.sup() - x.inf()};
  };
  return {number(a.x()), number(a.y()), number(a.z())};
}

/* Returns the vector from p to q, and sets `error` to a bound of the error of each coordinate. */
inline std::array<double, 3> approximate_vector(const Approximate_place& p, const Approximate_place& q, double& error)
{
  std::array<double, 3> result;
  error = 0;
  for(std::size_t i = 0; i < 3; ++i) {
    result[i] = q[i].value - p[i].value;
    error = (std::max)(error, p[i].error + q[i].error);
  }
  return result;
}

/* Returns a bound of the error of the difference of two coordinates of precise points. */
inline double difference_error(const Double_double& p, const Double_double& q)
{
  return p.low == 0 && q.low == 0 ? 0 : double_double_error * (std::abs(p.high) + std::abs(q.high));
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

/*
 * Returns the vector from one point to another, each coordinate rounded once, like the difference of two doubles. If
 * the difference of the precise points is too small, `precise()` is used, the precise vector between the exact points.
 */
template <class Precise_vector>
std::array<double, 3> rounded_vector(const Precise_place& p, const Precise_place& q, const Precise_vector& precise)
{
  std::array<double, 3> result;
  for(std::size_t i = 0; i < 3; ++i) {
    result[i] = (q[i] - p[i]).high;
    if(!(difference_error(p[i], q[i]) <= negligible_rounding * std::abs(result[i])))
      result[i] = precise()[i].high;
  }
  return result;
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

/* Returns a vector that bounds the distance of approximate points from below: no difference is overestimated. */
inline std::array<double, 3> least_vector(const Approximate_place& p, const Approximate_place& q)
{
  std::array<double, 3> result;
  for(std::size_t i = 0; i < 3; ++i)
    result[i] = (std::max)(std::abs(q[i].value - p[i].value) - (p[i].error + q[i].error), 0.0);
  return result;
}

/*
 * The precise positions of vertices, computed on first use, since evaluating an exact number takes far longer than
 * reading a double. A query writes few of them, so that most of the array takes no memory. A copy starts empty. Several
 * threads may query at once.
 */
class Precise_places
{
  struct Entry
  {
    Precise_place place;
    char is_known;
  };

  struct Entries
  {
    Lazy_array<Entry> array;
    Index size = 0; // of the array, set after it
    Short_lock lock;
  };

public:
  Precise_places()
    : m_entries(std::make_unique<Entries>())
  {
  }
  Precise_places(const Precise_places&)
    : Precise_places()
  {
  }
  Precise_places(Precise_places&& other) noexcept = default;
  Precise_places& operator=(const Precise_places&) { return *this = Precise_places(); }
  Precise_places& operator=(Precise_places&& other) noexcept = default;

  /* Returns the position of vertex v, one of `size`, which `compute()` returns if it is unknown. */
  template <class Compute>
  Precise_place operator()(Vertex_index v, Index size, const Compute& compute) const
  {
    if(load_acquire(m_entries->size) == 0)
      allocate(size);
    if(v.idx() >= load_relaxed(m_entries->size))
      return compute();
    Entry& entry = m_entries->array[static_cast<std::size_t>(v.idx())];
    if(load_acquire(entry.is_known) == 0)
      keep(entry, compute());
    return entry.place;
  }

private:
  void allocate(Index size) const
  {
    const std::lock_guard<Short_lock> guard(m_entries->lock);
    if(m_entries->size != 0)
      return;
    m_entries->array = Lazy_array<Entry>(static_cast<std::size_t>(size));
    store_release(m_entries->size, size);
  }

  // Another thread may have been faster, with the same result.
  void keep(Entry& entry, const Precise_place& place) const
  {
    const std::lock_guard<Short_lock> guard(m_entries->lock);
    if(entry.is_known != 0)
      return;
    entry.place = place;
    store_release(entry.is_known, char(1));
  }

  std::unique_ptr<Entries> m_entries;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_POINT_COORDINATES_H
