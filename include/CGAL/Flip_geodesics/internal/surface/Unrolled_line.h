// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_UNROLLED_LINE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_UNROLLED_LINE_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/numbers/Root_sum.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A line over walls: faces that bend along parallel edges only, the rulings, as those of an extrusion or a prism. They
 * are unrolled into a plane with the direction of the rulings as one axis. There the line leads up by the difference of
 * two places along that direction, a rational number; and sideways by the distances from ruling to ruling, a sum of
 * roots.
 */
struct Unrolled_line
{
  using Place = std::array<double, 3>;

  std::vector<Place> places; // its start, one on each ruling that it crosses, and its end
  Sign side = ZERO;          // POSITIVE if it leads to the right of the rulings' direction
  Sign height = ZERO;        // POSITIVE if it leads along that direction
};

/* The sign of the sine of the angle clockwise from one line to another, over walls with rulings of some direction. */
class Unrolled_sine
{
  using Place = Unrolled_line::Place;

public:
  /* From one place to another along the rulings' direction. */
  Unrolled_sine(const Place& from, const Place& to)
    : m_from(from)
    , m_to(to)
  {
  }

  /* Uncertain if the default limit of work is met. */
  Uncertain<Sign> operator()(const Unrolled_line& a, const Unrolled_line& b) const
  {
    const Sign first = a.height * b.side, second = CGAL::opposite(b.height * a.side);
    if(first == second || second == ZERO)
      return first;
    if(first == ZERO)
      return second;
    const Bounded left = product(a, b), right = product(b, a);
    const double difference = (left.value - right.value).high;
    if(std::abs(difference) > 2 * (left.error + right.error))
      return difference > 0 ? first : second;
    return exact(a, b);
  }

private:
  // Values that are not negative, and bounds of their errors, up to rounding of the bounds.
  struct Bounded
  {
    Double_double value;
    double error;
  };

  using Precise_vector = std::array<Double_double, 3>;

  // Differences are exact, and a product of two vectors errs by less than 30 double_double_error of their lengths.
  static constexpr double unit = 64 * double_double_error;

  static Precise_vector precise_difference(const Place& p, const Place& q)
  {
    return {exact_sum(q[0], -p[0]), exact_sum(q[1], -p[1]), exact_sum(q[2], -p[2])};
  }

  static Double_double dot(const Precise_vector& u, const Precise_vector& v)
  {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }

  // What the error of a product is relative to; infinite where what underflows may show.
  static double size_of_product(const Precise_vector& u, const Precise_vector& v)
  {
    const auto length = [](const Precise_vector& w) { return std::hypot(w[0].high, w[1].high, w[2].high); };
    const double size = length(u) * length(v);
    return size == 0 || (size > least_unscaled && size < greatest_unscaled) ? size
                                                                            : std::numeric_limits<double>::infinity();
  }

  // How far a line leads up, times how far another one leads sideways.
  Bounded product(const Unrolled_line& up, const Unrolled_line& sideways) const
  {
    const Bounded h = height(up), w = width(sideways);
    const Double_double value = h.value * w.value;
    return {value, h.value.high * w.error + h.error * w.value.high + h.error * w.error + unit * value.high};
  }

  Bounded height(const Unrolled_line& line) const
  {
    const Precise_vector u = precise_difference(m_from, m_to),
                         v = precise_difference(line.places.front(), line.places.back());
    const Double_double value = dot(u, v);
    return {value.high < 0 ? -value : value, unit * size_of_product(u, v)};
  }

  Bounded width(const Unrolled_line& line) const
  {
    const Precise_vector u = precise_difference(m_from, m_to);
    Bounded sum = {{0, 0}, 0};
    for(std::size_t i = 1; i < line.places.size(); ++i) {
      const Precise_vector v = precise_difference(line.places[i - 1], line.places[i]),
                           cross = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      sum.value = sum.value + internal::sqrt(dot(cross, cross));
      sum.error += unit * (size_of_product(u, v) + sum.value.high);
    }
    return sum;
  }

  // ---------------------------------------------------------------- in integers

  using Vector = std::array<Integer, 3>;

  static Vector difference(const Integer* p, const Integer* q) { return {q[0] - p[0], q[1] - p[1], q[2] - p[2]}; }

  Uncertain<Sign> exact(const Unrolled_line& a, const Unrolled_line& b) const
  {
    std::vector<double> coordinates;
    const auto append = [&](const Place& p) { coordinates.insert(coordinates.end(), p.begin(), p.end()); };
    append(m_from);
    append(m_to);
    for(const Unrolled_line* line : {&a, &b})
      for(const Place& p : line->places)
        append(p);
    std::vector<Integer> integers(coordinates.size());
    to_integers(coordinates.data(), coordinates.size(), integers.data());
    const Vector u = shortened(difference(&integers[0], &integers[3]));
    const Integer *of_a = &integers[6], *of_b = of_a + 3 * a.places.size();
    Root_sum sum;
    add_widths(u, of_b, b, height(u, of_a, a), sum);
    add_widths(u, of_a, a, -height(u, of_b, b), sum);
    Work_limit work;
    return sum.sign(work);
  }

  static Vector shortened(Vector v)
  {
    const Integer common = boost::multiprecision::gcd(boost::multiprecision::gcd(v[0], v[1]), v[2]);
    for(Integer& x : v)
      x /= common;
    return v;
  }

  static Integer height(const Vector& u, const Integer* places, const Unrolled_line& line)
  {
    const Vector v = difference(places, places + 3 * (line.places.size() - 1));
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }

  static void add_widths(const Vector& u, const Integer* places, const Unrolled_line& line, const Integer& factor,
                         Root_sum& sum)
  {
    for(std::size_t i = 1; i < line.places.size(); ++i, places += 3) {
      const Vector v = difference(places, places + 3);
      Integer square = 0;
      for(std::size_t k = 0; k < 3; ++k) {
        const Integer c = u[k] * v[(k + 1) % 3] - u[(k + 1) % 3] * v[k];
        square += c * c;
      }
      sum.add(line.side == POSITIVE ? factor : Integer(-factor), square);
    }
  }

  Place m_from, m_to;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_UNROLLED_LINE_H
