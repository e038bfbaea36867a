// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_METRIC_PLACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_METRIC_PLACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/point_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>

// The positions of the vertices of an `Embedded_metric`: approximate ones with error bounds, and precise ones, which
// are stored.

namespace CGAL::Flip_geodesics::internal {

/* Coordinates of models are often short; the numbers derived from them are then short as well. */
inline void take_out_power_of_two(std::array<std::array<Integer, 3>, 3>& vectors)
{
  unsigned power = (std::numeric_limits<unsigned>::max)();
  for(const auto& v : vectors)
    for(const Integer& n : v)
      if(n != 0)
        power = (std::min)(power, lowest_bit(n));
  for(auto& v : vectors)
    for(Integer& n : v)
      n >>= power; // exact
}

/* Returns the face of three points. */
inline Exact_face exact_face_from_points(const std::array<std::array<Integer, 3>, 3>& p)
{
  std::array<std::array<Integer, 3>, 3> e = {difference(p[1], p[0]), difference(p[2], p[1]), difference(p[0], p[2])};
  take_out_power_of_two(e);
  Exact_face face = {dot(e[0], e[0]), dot(e[0], e[1]), dot(e[0], e[2]), 0};
  face.doubled_area_squared = face.squared_length * dot(e[1], e[1]) - face.dot_next * face.dot_next; // by Lagrange
  return face;
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

/* Returns the vector from p to q, and sets `error` to a bound on the error of each coordinate. */
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
    const bool are_doubles = p[i].low == 0 && q[i].low == 0;
    const double error = are_doubles ? 0 : double_double_error * (std::abs(p[i].high) + std::abs(q[i].high));
    if(!(error <= negligible_rounding * std::abs(result[i])))
      result[i] = precise()[i].high;
  }
  return result;
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
 * reading a double. A query writes few of them, so most of the array takes no memory. A copy starts empty. Several
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

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_METRIC_PLACES_H
