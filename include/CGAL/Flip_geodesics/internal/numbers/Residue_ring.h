// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_RESIDUE_RING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_RESIDUE_RING_H

#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/numbers/Root_base.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

inline Integer power(Integer base, Integer exponent, const Integer& modulus)
{
  Integer result = 1;
  for(; exponent != 0; exponent >>= 1) {
    if(exponent % 2 != 0)
      result = result * base % modulus;
    base = base * base % modulus;
  }
  return result;
}

/*
 * The images of numbers in the field of p^2 elements, p a prime with p = 3 mod 4: F_p[j] with j^2 = -1, where each
 * integer has a root. The roots of generators are chosen, and with them those of their products, so that the map is a
 * homomorphism: a number with a residue that is not zero is not zero.
 */
class Residue_ring
{
public:
  struct Number
  {
    Integer a, b; // a + b j
  };

  struct Side
  {
    Number dot, root;
  };

  Residue_ring(const Root_base& base, const Integer& prime)
    : m_base(base)
    , m_prime(prime)
  {
    for(const Integer& g : base.generators())
      m_roots.push_back(root_of_generator(g));
  }

  Number integer(const Integer& n) const { return {reduced(n), 0}; }
  Number add(const Number& x, const Number& y) const { return {reduced(x.a + y.a), reduced(x.b + y.b)}; }
  Number negate(const Number& x) const { return {reduced(-x.a), reduced(-x.b)}; }
  Number rescale(const Number& x, const Integer& factor) const
  {
    return {reduced(x.a * factor), reduced(x.b * factor)};
  }
  Number times_integer(const Number& x, const Integer& n) const { return rescale(x, n); }
  Number multiply(const Number& x, const Number& y) const
  {
    return {reduced(x.a * y.a - x.b * y.b), reduced(x.a * y.b + x.b * y.a)};
  }

  Side side(const Integer& dot, const Integer& squared_root, int sign, const Integer& /* divisor */) const
  {
    const Root_base::Root& root = m_base.root(squared_root);
    Number image = integer(root.factor * sign);
    for(std::size_t i : root.generators)
      image = multiply(image, m_roots[i]);
    return {integer(dot), image};
  }

  Number times_dot(const Number& x, const Side& side) const { return multiply(x, side.dot); }
  Number times_root(const Number& x, const Side& side) const { return multiply(x, side.root); }

  bool is_zero(const Number& x) const { return x.a == 0 && x.b == 0; }

private:
  // With the sign of n.
  Integer reduced(const Integer& n) const { return n % m_prime; }

  // Either g or -g is a square.
  Number root_of_generator(const Integer& g) const
  {
    const Integer n = reduced(g), root = power(n, (m_prime + 1) / 4, m_prime);
    return reduced(root * root) == n ? Number{root, 0} : Number{0, root};
  }

  const Root_base& m_base;
  Integer m_prime;
  std::vector<Number> m_roots;
};

/* A number of the given number of bits, of which the highest is set. */
inline Integer random_number(std::mt19937& random, unsigned bits)
{
  constexpr unsigned word = 32;
  Integer n = 1;
  for(unsigned i = 0; i < bits; i += word)
    n = (n << word) + random();
  return n >> (n.highest_bit() + 1 - bits);
}

/* Is n = 3 mod 4 a prime? By the test of Miller and Rabin, with random bases: +-1 are the powers to (n - 1) / 2. */
inline bool is_prime(const Integer& n, std::mt19937& random)
{
  constexpr std::uint64_t small_primes = 3ull * 5 * 7 * 11 * 13 * 17 * 19 * 23 * 29 * 31 * 37 * 41 * 43 * 47 * 53;
  constexpr int trials = 50;
  if(std::gcd(static_cast<std::uint64_t>(n % small_primes), small_primes) != 1)
    return false;
  const unsigned bits = n.highest_bit() + 64;
  for(int i = 0; i < trials; ++i) {
    const Integer x = power(random_number(random, bits) % n, (n - 1) / 2, n);
    if(x != 1 && x != n - 1)
      return false;
  }
  return true;
}

/* Returns the prime p = 3 mod 4 used for a number of bits, which must exceed six: the first one that a generator with a
 * fixed seed finds, so that results are deterministic. Adversarial input could make a residue modulo this prime vanish. */
inline Integer fixed_prime(unsigned bits)
{
  std::mt19937 random(bits);
  for(;;) {
    Integer n = random_number(random, bits);
    n += 3 - n % 4;
    if(is_prime(n, random))
      return n;
  }
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_RESIDUE_RING_H
