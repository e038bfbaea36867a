// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_PLACES_IN_SPACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_PLACES_IN_SPACE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A point of a face: the mean of its corners with weights whose sum is `whole`. */
struct Weighted_place
{
  static constexpr int whole = 64;

  static Weighted_place at_vertex(Vertex_index v) { return {{v, v, v}, {whole, 0, 0}}; }

  std::array<Vertex_index, 3> corners;
  std::array<int, 3> weights;
};

/*
 * Signs of determinants of vectors between places of a mesh in space, exactly: in double with a bound of the error, and
 * with integers where that does not decide.
 */
class Places_in_space
{
public:
  using Coordinates = std::array<double, 3>;
  using Direction = std::array<std::int64_t, 3>; // of numbers below 2^21

  /* `place(v)` gives the coordinates of each of `n` vertices, which are finite. */
  template <class Place>
  Places_in_space(Index n, const Place& place)
  {
    for(Vertex_index v : descriptors<Vertex_index>(n)) {
      m_points.push_back(place(v));
      for(int k = 0; k < 3; ++k) {
        const double x = m_points.back()[k];
        m_near.push_back(x - m_points.front()[k]);
        m_size = (std::max)(m_size, std::abs(m_near.back()));
        if(int exponent = 0; x != 0) {
          std::frexp(x, &exponent);
          m_least_exponent = (std::min)(m_least_exponent, exponent);
        }
      }
    }
  }

  /* From the first vertex to a place, rounded. */
  Coordinates close_by(const Weighted_place& p) const
  {
    Coordinates result = {0, 0, 0};
    for(int i = 0; i < 3; ++i)
      if(p.weights[i] != 0)
        for(int k = 0; k < 3; ++k)
          result[k] += p.weights[i] * m_near[static_cast<std::size_t>(3 * p.corners[i].idx() + k)];
    for(double& x : result)
      x /= Weighted_place::whole;
    return result;
  }

  /* More than what coordinates of `close_by()` are off. */
  double rounding() const { return weighted_place_error * m_size; }

  /* Is c on the left of the line from a to b, as seen against a direction? */
  Sign side(const Weighted_place& a, const Weighted_place& b, const Weighted_place& c, const Direction& direction) const
  {
    const Coordinates along = {double(direction[0]), double(direction[1]), double(direction[2])};
    const Sign sign = sign_of_determinant(vector(a, b), vector(a, c), along);
    if(sign != ZERO)
      return sign;
    return sign_of(determinant(exact_vector(a, b), exact_vector(a, c),
                               Exact_vector{Integer(direction[0]), Integer(direction[1]), Integer(direction[2])}));
  }

  /* The sign of the determinant of ab, cd and ef. */
  Sign orientation(const std::array<Weighted_place, 6>& p) const
  {
    const Sign sign = sign_of_determinant(vector(p[0], p[1]), vector(p[2], p[3]), vector(p[4], p[5]));
    if(sign != ZERO)
      return sign;
    return sign_of(determinant(exact_vector(p[0], p[1]), exact_vector(p[2], p[3]), exact_vector(p[4], p[5])));
  }

  /* Six times the volume of the tetrahedron of three places and the first vertex, rounded, and more than what it is off.
   */
  std::array<double, 2> volume(const std::array<Weighted_place, 3>& p) const
  {
    const Coordinates a = close_by(p[0]), b = close_by(p[1]), c = close_by(p[2]);
    return {determinant(a, b, c), error(a, b, c)};
  }

  /* The same exactly, in a unit that is the same for all. */
  Integer exact_volume(const std::array<Weighted_place, 3>& p) const
  {
    const Weighted_place first = Weighted_place::at_vertex(Vertex_index(0));
    return determinant(exact_vector(first, p[0]), exact_vector(first, p[1]), exact_vector(first, p[2]));
  }

private:
  using Exact_vector = std::array<Integer, 3>;

  static Sign sign_of(const Integer& n) { return n.sign() > 0 ? POSITIVE : (n.sign() < 0 ? NEGATIVE : ZERO); }

  template <class Number>
  static Number determinant(const std::array<Number, 3>& u, const std::array<Number, 3>& v,
                            const std::array<Number, 3>& w)
  {
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  }

  static double largest(const Coordinates& v) { return (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

  // More than what a determinant is off: six products, of entries that are off by twice the rounding.
  double error(const Coordinates& u, const Coordinates& v, const Coordinates& w) const
  {
    const double a = largest(u), b = largest(v), c = largest(w), off = 2.1 * rounding();
    return 6.1 * (off * (a * b + b * c + a * c) + off * off * (a + b + c + off) + three_vectors_error * a * b * c) +
           underflow_of_small_products;
  }

  // ZERO if that cannot be told.
  Sign sign_of_determinant(const Coordinates& u, const Coordinates& v, const Coordinates& w) const
  {
    const double value = determinant(u, v, w);
    return std::abs(value) > error(u, v, w) ? (value > 0 ? POSITIVE : NEGATIVE) : ZERO;
  }

  Coordinates vector(const Weighted_place& a, const Weighted_place& b) const
  {
    const Coordinates p = close_by(a), q = close_by(b);
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }

  Exact_vector exact_vector(const Weighted_place& a, const Weighted_place& b) const
  {
    Exact_vector result = {Integer(0), Integer(0), Integer(0)};
    for(int k = 0; k < 3; ++k) {
      add(b, k, 1, result[k]);
      add(a, k, -1, result[k]);
    }
    return result;
  }

  void add(const Weighted_place& p, int k, int factor, Integer& sum) const
  {
    for(int i = 0; i < 3; ++i)
      if(p.weights[i] != 0)
        sum += Integer(factor * p.weights[i]) * whole_number(m_points[p.corners[i]][k]);
  }

  // A coordinate in the unit of the last place of the least one.
  Integer whole_number(double x) const
  {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    const Integer digits(static_cast<std::int64_t>(std::ldexp(fraction, 53)));
    return x == 0 ? Integer(0) : digits << static_cast<unsigned long>(exponent - m_least_exponent);
  }

  Indexed_by<Vertex_index, std::vector<Coordinates>> m_points;
  std::vector<double> m_near; // three for each vertex, from the first
  double m_size = 0;
  int m_least_exponent = 2000;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_PLACES_IN_SPACE_H
