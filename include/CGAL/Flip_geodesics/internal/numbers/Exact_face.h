// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_EXACT_FACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_EXACT_FACE_H

#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * An input face in exact numbers, up to one positive factor: with the face's halfedges h, hn, hp as complex numbers in
 * any frame, hn / h = (dot_next + i sqrt(doubled_area_squared)) / squared_length, and
 * hp / h = (dot_previous - i sqrt(doubled_area_squared)) / squared_length.
 */
struct Exact_face
{
  Integer squared_length, dot_next, dot_previous, doubled_area_squared;
};

/* Doubles as integers with one common power of two taken out. */
inline void to_integers(const double* numbers, std::size_t size, Integer* result)
{
  constexpr int digits = std::numeric_limits<double>::digits;
  int smallest = (std::numeric_limits<int>::max)(), exponent;
  for(std::size_t i = 0; i < size; ++i)
    if(std::frexp(numbers[i], &exponent) != 0)
      smallest = (std::min)(smallest, exponent);
  for(std::size_t i = 0; i < size; ++i) {
    const double mantissa = std::frexp(numbers[i], &exponent);
    result[i] = static_cast<long long>(std::ldexp(mantissa, digits));
    if(mantissa != 0)
      result[i] <<= static_cast<unsigned long>(exponent - smallest);
  }
}

template <std::size_t N>
std::array<Integer, N> to_integers(const std::array<double, N>& numbers)
{
  std::array<Integer, N> result;
  to_integers(numbers.data(), N, result.data());
  return result;
}

/* Weights of a point as integers without a common factor. */
inline std::array<Integer, 3> integer_weights(const std::array<double, 3>& weights)
{
  std::array<Integer, 3> result = to_integers(weights);
  const Integer common = boost::multiprecision::gcd(boost::multiprecision::gcd(result[0], result[1]), result[2]);
  for(Integer& weight : result)
    weight /= common;
  return result;
}

/* Coordinates of models are often short: then so are the numbers that follow from them. */
inline void take_out_power_of_two(std::array<std::array<Integer, 3>, 3>& vectors)
{
  unsigned power = (std::numeric_limits<unsigned>::max)();
  for(const auto& v : vectors)
    for(const Integer& n : v)
      if(n != 0)
        power = (std::min)(power, lowest_bit(n));
  for(auto& v : vectors)
    for(Integer& n : v)
      if(n != 0)
        n = n < 0 ? Integer(-(Integer(-n) >> power)) : Integer(n >> power);
}

inline Exact_face exact_face_from_points(const std::array<double, 9>& coordinates)
{
  using Vector = std::array<Integer, 3>;
  const std::array<Integer, 9> c = to_integers(coordinates);
  std::array<Vector, 3> e;
  for(int i = 0; i < 3; ++i)
    for(int k = 0; k < 3; ++k)
      e[i][k] = c[3 * ((i + 1) % 3) + k] - c[3 * i + k];
  take_out_power_of_two(e);
  const auto dot = [](const Vector& u, const Vector& v) { return Integer(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]); };
  Exact_face face = {dot(e[0], e[0]), dot(e[0], e[1]), dot(e[0], e[2]), 0};
  face.doubled_area_squared = face.squared_length * dot(e[1], e[1]) - face.dot_next * face.dot_next; // [Lagrange]
  return face;
}

/* Twice the lengths, so that half sums stay whole: |hp|^2 = |h + hn|^2 and |hn|^2 = |h + hp|^2. */
inline Exact_face exact_face_from_lengths(const std::array<double, 3>& lengths)
{
  const std::array<Integer, 3> l = to_integers(lengths);
  const Integer a = 2 * l[0] * l[0], b = 2 * l[1] * l[1], c = 2 * l[2] * l[2];
  Exact_face face = {a, (c - a - b) / 2, (b - a - c) / 2, 0};
  face.doubled_area_squared = a * b - face.dot_next * face.dot_next;
  return face;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_EXACT_FACE_H
