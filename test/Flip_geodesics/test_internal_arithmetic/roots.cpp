// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sums of roots, and the fixed-point numbers that tell their signs.

#include "test_internal_arithmetic/numbers.h"

using namespace Flip_geodesics_test;

namespace {

const std::vector<Integer> radicands = {0, 1, 2, 3, 4, 6, 8, 9, 12, 18, 36, 49, 50, 72, 98, 105, 1001, 11025, 1 << 20};

std::array<Real, 2> product(const std::array<Real, 2>& a, const std::array<Real, 2>& b)
{
  return {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
}

} // namespace

BOOST_AUTO_TEST_CASE(roots_are_products_of_roots_of_coprime_numbers)
{
  for(std::size_t first = 0; first < radicands.size(); ++first) {
    std::vector<Integer> turned = radicands; // the base depends on the order
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    const FI::Root_base base(turned);
    const std::vector<Integer>& g = base.generators();
    for(std::size_t i = 0; i < g.size(); ++i) {
      BOOST_TEST((g[i] > 1 && !FI::is_perfect_square(g[i])));
      for(std::size_t k = 0; k < i; ++k)
        BOOST_TEST(FI::greatest_common_divisor(g[i], g[k]) == 1);
    }
    for(const Integer& d : radicands) {
      const FI::Root_base::Root& root = base.root(d);
      BOOST_TEST(root.factor * root.factor * base.product(root.generators) == d);
    }
  }
}

BOOST_AUTO_TEST_CASE(products_of_sums_of_roots_have_the_sign_of_their_value)
{
  const FI::Root_base base({2, 3, 5});
  const FI::Multiquadratic_ring ring(base);
  Random_numbers random(3);
  const auto number = [&] {
    FI::Multiquadratic_ring::Number a(8);
    for(Integer& c : a)
      c = random.below(9) - 4;
    return a;
  };
  const auto value = [&](const FI::Multiquadratic_ring::Number& a) {
    Real sum = 0;
    for(std::size_t mask = 0; mask < a.size(); ++mask) {
      Real term = real(a[mask]);
      for(std::size_t i = 0; i < 3; ++i)
        if((mask >> i & 1) != 0)
          term *= sqrt(real(base.generators()[i]));
      sum += term;
    }
    return sum;
  };
  for(int i = 0; i < 300 * scale; ++i) {
    const auto a = number(), b = number(), product = ring.multiply(a, b);
    const Real expected = value(a) * value(b);
    BOOST_TEST(abs(value(product) - expected) < 1e-200);
    BOOST_TEST(ring.sign(product) == (abs(expected) < 1e-200 ? 0 : expected.sign()));
  }
}

// q sqrt(2) - p for p / q alternately below and above the root, ever nearer: no fixed number of digits will do.
BOOST_AUTO_TEST_CASE(small_differences_of_roots_have_signs)
{
  const FI::Root_base base({2});
  const FI::Multiquadratic_ring ring(base);
  Integer p = 1, q = 1;
  for(int i = 0; i < 500; ++i) {
    BOOST_TEST(ring.sign({-p, q}) == (i % 2 == 0 ? CGAL::POSITIVE : CGAL::NEGATIVE));
    BOOST_TEST(ring.sign({p, -q}) == (i % 2 == 0 ? CGAL::NEGATIVE : CGAL::POSITIVE));
    const Integer next = p + 2 * q;
    q += p;
    p = next;
  }
}

BOOST_AUTO_TEST_CASE(integers_without_roots_have_signs)
{
  const FI::Root_base base({4, 9});
  const FI::Multiquadratic_ring ring(base);
  BOOST_TEST(ring.sign(ring.integer(7)) == CGAL::POSITIVE);
  BOOST_TEST(ring.sign(ring.integer(0)) == CGAL::ZERO);
  BOOST_TEST(ring.sign(ring.integer(-7)) == CGAL::NEGATIVE);
}

BOOST_AUTO_TEST_CASE(fixed_point_numbers_hold_what_they_stand_for)
{
  const Fixed ring(fixed_bits);
  Random_numbers random(4);
  for(int i = 0; i < 500 * scale; ++i) {
    const Integer dot = random.below(201) - 100, square = random.below(1000), divisor = 1 + random.below(90);
    const int sign = random.below(2) == 0 ? 1 : -1;
    const Fixed::Side side = ring.side(dot, square, sign, divisor);
    const Real x = real(dot) / real(divisor), y = sign * sqrt(real(square)) / real(divisor);
    const Integer radius = Fixed::side_radius;
    BOOST_TEST((holds({side.dot, radius}, x) && holds({side.root, radius}, y)));
    const Real size = ldexp(sqrt(x * x + y * y), fixed_bits);
    BOOST_TEST((size - 4 < real(side.size) && real(side.size) < size * (1 + Real(1e-12)) + 8));
    const Integer n = random.below(19) - 9;
    const Fixed::Complex q = ring.combination(side, n);
    const std::array<Real, 2> value_of_q = {x, y * real(n)};
    Fixed::Complex z = q; // errors grow from product to product
    std::array<Real, 2> value = value_of_q;
    for(int k = 0; k < 6; ++k) {
      z = ring.multiply(ring.times_side(ring.conjugate(z), side), q);
      value = product(product({value[0], -value[1]}, {x, y}), value_of_q);
      z = ring.add(z, ring.negate(ring.times_integer(q, k)));
      value = {value[0] - k * value_of_q[0], value[1] - k * value_of_q[1]};
      BOOST_TEST((holds({z.re, z.radius}, value[0]) && holds({z.im, z.radius}, value[1])));
      const CGAL::Uncertain<CGAL::Sign> found = ring.sign(ring.imaginary_part(z));
      BOOST_TEST((!found.is_certain() || found.make_certain() == value[1].sign()));
    }
  }
}

// A way around a polygon of many sides, again and again: with errors of real and imaginary part apart, which grow by a
// quarter with each turn, nothing would be known after five hundred.
template <class Ring>
void check_many_turns(const Ring& ring)
{
  auto z = ring.one();
  Real cosine = 1, sine = 0;
  for(int k = 1; k <= 20000; ++k) { // (3 + 4 i) / 5
    z = ring.times_side(z, ring.side(3, 16, 1, 5));
    const Real before = cosine;
    cosine = (3 * before - 4 * sine) / 5;
    sine = (4 * before + 3 * sine) / 5;
    const CGAL::Uncertain<CGAL::Sign> found = ring.sign(ring.imaginary_part(z));
    BOOST_REQUIRE(found.is_certain());
    BOOST_REQUIRE(found.make_certain() == sine.sign());
  }
}

BOOST_AUTO_TEST_CASE(errors_do_not_grow_with_turns)
{
  check_many_turns(FI::Ball_ring<50>());
  check_many_turns(Fixed(160));
}

BOOST_AUTO_TEST_CASE(fixed_point_numbers_within_their_error_have_no_sign)
{
  const Fixed ring(fixed_bits);
  for(int middle : {-3, -2, -1, 0, 1, 2, 3}) {
    BOOST_TEST(ring.sign({middle, 3}).is_certain() == false);
    BOOST_TEST(ring.sign({middle, 0}).is_certain() == (middle != 0));
  }
  BOOST_TEST((ring.sign({4, 3}) == CGAL::POSITIVE));
  BOOST_TEST((ring.sign({-4, 3}) == CGAL::NEGATIVE));
}
