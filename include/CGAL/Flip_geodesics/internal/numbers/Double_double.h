// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_DOUBLE_DOUBLE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_DOUBLE_DOUBLE_H

#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>

#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Flip_geodesics::internal {

/*
 * Numbers of about 106 bits: the unevaluated sum of two doubles, the second at most half a unit in the last place of
 * the first [D71]. With u = 2^-53, and as long as nothing over- or underflows, the result of each operation errs by
 * at most `double_double_error`, that is 16 u^2,
 *
 *   - of |x| + |y| for a sum: 8 u^2 at most, as both rounded operations are on numbers below 2 u (|x| + |y|), and as,
 *     if so much cancels that the last addition is not ordered, it errs by u of a number of that size;
 *   - of the result for a product, 5 u^2, and for a root, 4 u^2 [JMP17, algorithm 11], [LLMPR23];
 *   - of the result for a quotient, 13 u^2: the remainder of the first quotient is exact; then four rounded operations
 *     on numbers below 3 u, and the divisor's second half is left out once.
 */
struct Double_double
{
  double high = 0, low = 0;
};

/* a + b, exactly: TwoSum [K97]. */
inline Double_double exact_sum(double a, double b)
{
  a = unfused(a);
  b = unfused(b);
  const double sum = a + b, rest = sum - a;
  return {sum, (a - (sum - rest)) + (b - rest)};
}

/* a + b, exactly. \pre |a| >= |b| or a = 0 */
inline Double_double ordered_sum(double a, double b)
{
  a = unfused(a);
  b = unfused(b);
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/* a b, exactly. */
inline Double_double exact_product(double a, double b)
{
  const double product = unfused(a * b);
  return {product, std::fma(a, b, -product)};
}

inline Double_double operator-(const Double_double& a) { return {-a.high, -a.low}; }

inline Double_double operator+(const Double_double& a, const Double_double& b)
{
  const Double_double sum = exact_sum(a.high, b.high);
  return ordered_sum(sum.high, sum.low + (a.low + b.low));
}

inline Double_double operator-(const Double_double& a, const Double_double& b) { return a + -b; }

inline Double_double operator*(const Double_double& a, const Double_double& b)
{
  const Double_double product = exact_product(a.high, b.high);
  return ordered_sum(product.high, product.low + std::fma(a.low, b.high, unfused(a.high * b.low)));
}

inline Double_double operator/(const Double_double& a, const Double_double& b)
{
  const double quotient = a.high / b.high;
  const Double_double product = exact_product(quotient, b.high);
  const double rest = (a.high - product.high) - product.low;
  return ordered_sum(quotient, (rest + (a.low - unfused(quotient * b.low))) / b.high);
}

/* \pre a >= 0 */
inline Double_double sqrt(const Double_double& a)
{
  if(!(a.high > 0))
    return {};
  const double root = std::sqrt(a.high);
  return ordered_sum(root, (std::fma(-root, root, a.high) + a.low) / (2 * root));
}

/*
 * Complex numbers. With this type, the error of each operation, as a vector, is at most `double_double_vector_error`,
 * that is 64 u^2, of |v| + |w| for a sum and of |v| |w| for a product: there each coordinate takes two products and a
 * sum of them, in all 33 u^2 (|v.x w.x| + |v.y w.y|) or the like, which is at most 33 u^2 |v| |w| by the Cauchy-Schwarz
 * inequality.
 */
template <class Number>
struct Complex_number
{
  Number x, y;

  const Number& real() const { return x; }
  const Number& imag() const { return y; }

  friend Complex_number conj(const Complex_number& v) { return {v.x, -v.y}; }
  friend Complex_number operator-(const Complex_number& v) { return {-v.x, -v.y}; }
  friend Complex_number operator+(const Complex_number& v, const Complex_number& w) { return {v.x + w.x, v.y + w.y}; }
  friend Complex_number operator+(const Complex_number& v, const Number& a) { return {v.x + a, v.y}; }
  friend Complex_number operator*(const Number& a, const Complex_number& v) { return {a * v.x, a * v.y}; }
  friend Complex_number operator*(const Complex_number& v, const Complex_number& w)
  {
    return {v.x * w.x - v.y * w.y, v.x * w.y + v.y * w.x};
  }
};

using Double_double_vector = Complex_number<Double_double>;

/* Returns the length as a double. */
inline double length(const Double_double_vector& v)
{
  return std::sqrt(unfused(v.x.high * v.x.high) + unfused(v.y.high * v.y.high));
}

/* A sum of doubles, exactly, as parts that do not overlap, the largest last: Grow-Expansion [S97]. */
template <std::size_t MostTerms>
class Exact_sum
{
public:
  void add(double x)
  {
    std::size_t kept = 0;
    for(std::size_t i = 0; i < m_size; ++i) {
      const Double_double sum = exact_sum(x, m_parts[i]);
      if(sum.low != 0)
        m_parts[kept++] = sum.low;
      x = sum.high;
    }
    if(x != 0)
      m_parts[kept++] = x;
    m_size = kept;
  }

  void add_product(double a, double b)
  {
    const Double_double product = exact_product(a, b);
    add(product.low);
    add(product.high);
  }

  void add_product(double a, double b, double c)
  {
    const Double_double product = exact_product(a, b);
    add_product(product.low, c);
    add_product(product.high, c);
  }

  Sign sign() const { return m_size == 0 ? ZERO : (m_parts[m_size - 1] > 0 ? POSITIVE : NEGATIVE); }

private:
  std::array<double, MostTerms> m_parts;
  std::size_t m_size = 0;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_DOUBLE_DOUBLE_H
