// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sums of roots, and numbers with a bound of their error.

#include "test_internal_arithmetic/numbers.h"

using namespace Flip_geodesics_test;

namespace {

using Ring = FI::Multiquadratic_ring;

// The classes of squares, and of 2, 3, 6, 105 and 1001 times squares.
const std::vector<Integer> radicands = {0, 1, 2, 3, 4, 6, 8, 9, 12, 18, 36, 49, 50, 72, 98, 105, 1001, 11025, 1 << 20};

std::array<Real, 2> product(const std::array<Real, 2>& a, const std::array<Real, 2>& b)
{
  return {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
}

// The first primes: no root of one is a multiple of another's.
std::vector<Integer> primes(std::size_t number)
{
  std::vector<Integer> result;
  for(int n = 2; result.size() < number; ++n)
    if(std::all_of(result.begin(), result.end(), [n](const Integer& p) { return n % p != 0; }))
      result.push_back(n);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(roots_of_a_class_are_multiples_of_one_root)
{
  for(std::size_t first = 0; first < radicands.size(); ++first) {
    std::vector<Integer> turned = radicands; // the roots of the ring may depend on the order
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    FI::Work_limit work;
    const Ring ring(turned, work);
    BOOST_TEST(ring.number_of_roots() == 5u);
    for(const Integer& d : radicands) {
      const Ring::Complex root = ring.times_side(ring.one(), ring.side(0, d, 1, 1)); // times i
      const Ring::Complex square = ring.multiply(root, root);
      BOOST_TEST(square.re[0] == -d);
      BOOST_TEST(std::count(square.re.begin(), square.re.end(), 0) == (d == 0 ? 32 : 31));
      BOOST_TEST(std::count(square.im.begin(), square.im.end(), 0) == 32);
    }
  }
}

// The root of 6 is not in the class of that of 2 or 3, but in what they generate.
BOOST_AUTO_TEST_CASE(roots_that_are_products_of_others_cancel)
{
  FI::Work_limit work;
  const Ring ring({2, 3, 6}, work);
  BOOST_TEST(ring.number_of_roots() == 3u);
  const auto times = [&](const Ring::Complex& z, int d, int sign) {
    return ring.times_side(z, ring.side(0, d, sign, 1));
  };
  const Ring::Complex two = times(times(ring.one(), 2, 1), 3, 1), one = times(ring.one(), 6, 1); // -sqrt(6), i sqrt(6)
  const Ring::Complex z = ring.add(ring.multiply(two, times(times(ring.one(), 6, 1), 6, 1)), two);
  BOOST_TEST((ring.sign_of_sine({{}, z.im}) == CGAL::ZERO));
  BOOST_TEST((ring.sign_of_sine({{}, ring.add(two, ring.times_integer(two, -1)).re}) == CGAL::ZERO));
  BOOST_TEST((ring.sign_of_sine({{}, one.im}) == CGAL::POSITIVE));
  Ring::Number difference = two.re; // -sqrt(2) sqrt(3) + sqrt(6)
  for(std::size_t i = 0; i < difference.size(); ++i)
    difference[i] += one.im[i];
  BOOST_TEST((ring.sign_of_sine({{}, difference}) == CGAL::ZERO));
}

BOOST_AUTO_TEST_CASE(products_of_sums_of_roots_have_the_sign_of_their_value)
{
  FI::Work_limit work(UINT64_MAX);
  const std::array<int, 3> squares = {2, 3, 5};
  const Ring ring({2, 3, 5}, work);
  Random_numbers random(3);
  const auto number = [&] {
    Ring::Complex a = ring.times_integer(ring.one(), 0);
    for(Ring::Number* part : {&a.re, &a.im})
      for(Integer& c : *part)
        c = random.below(9) - 4;
    return a;
  };
  const auto value = [&](const Ring::Number& a) {
    Real sum = 0;
    for(std::size_t mask = 0; mask < a.size(); ++mask) {
      Real term = real(a[mask]);
      for(std::size_t i = 0; i < 3; ++i)
        if((mask >> i & 1) != 0)
          term *= sqrt(Real(squares[i]));
      sum += term;
    }
    return sum;
  };
  for(int i = 0; i < 300 * scale; ++i) {
    const Ring::Complex a = number(), b = number(), c = ring.multiply(a, b);
    const std::array<Real, 2> expected = product({value(a.re), value(a.im)}, {value(b.re), value(b.im)});
    BOOST_TEST((abs(value(c.re) - expected[0]) < 1e-200 && abs(value(c.im) - expected[1]) < 1e-200));
    BOOST_TEST((ring.sign_of_sine({{}, c.im}) == CGAL::Sign(abs(expected[1]) < 1e-200 ? 0 : expected[1].sign())));
    const Ring::Complex sum = ring.add(a, b), difference = ring.add(ring.conjugate(a), ring.negate(b));
    BOOST_TEST(abs(value(sum.re) - value(a.re) - value(b.re)) < 1e-200);
    BOOST_TEST(abs(value(sum.im) - value(a.im) - value(b.im)) < 1e-200);
    BOOST_TEST(abs(value(difference.re) - value(a.re) + value(b.re)) < 1e-200);
    BOOST_TEST(abs(value(difference.im) + value(a.im) + value(b.im)) < 1e-200);
  }
}

// q sqrt(2) - p for p / q alternately below and above the root, ever nearer: no fixed number of digits will do.
BOOST_AUTO_TEST_CASE(small_differences_of_roots_have_signs)
{
  FI::Work_limit work(UINT64_MAX);
  const Ring ring({2}, work);
  Integer p = 1, q = 1;
  for(int i = 0; i < 500; ++i) {
    BOOST_TEST((ring.sign_of_sine({{}, {-p, q}}) == (i % 2 == 0 ? CGAL::POSITIVE : CGAL::NEGATIVE)));
    BOOST_TEST((ring.sign_of_sine({{}, {p, -q}}) == (i % 2 == 0 ? CGAL::NEGATIVE : CGAL::POSITIVE)));
    const Integer next = p + 2 * q;
    q += p;
    p = next;
  }
}

BOOST_AUTO_TEST_CASE(integers_without_roots_have_signs)
{
  FI::Work_limit work;
  const Ring ring({4, 9}, work);
  BOOST_TEST(ring.number_of_roots() == 0u);
  BOOST_TEST((ring.sign_of_sine({{}, {7}}) == CGAL::POSITIVE));
  BOOST_TEST((ring.sign_of_sine({{}, {0}}) == CGAL::ZERO));
  BOOST_TEST((ring.sign_of_sine({{}, {-7}}) == CGAL::NEGATIVE));
}

// ---------------------------------------------------------------- limits of work

// More roots than a number can have coefficients for.
BOOST_AUTO_TEST_CASE(numbers_with_too_many_roots_have_no_sign)
{
  for(std::size_t r : {12u, 16u, 28u, 29u, 30u, 31u, 32u, 40u, 70u}) {
    FI::Work_limit work;
    const Ring ring(primes(r), work);
    BOOST_TEST(work.is_met());
    BOOST_TEST(ring.number_of_roots() == r);
    const Ring::Complex z = ring.times_side(ring.one(), ring.side(1, 2, 1, 1));
    BOOST_TEST((z.re.empty() && z.im.empty()));
    BOOST_TEST(!ring.sign_of_sine({{}, z.im}).is_certain());
  }
}

// A product of factors 1 + i sqrt(d) grows until the limit is met, and no operation goes on for long beyond it.
BOOST_AUTO_TEST_CASE(the_limit_of_work_is_kept)
{
  std::size_t last = 0;
  for(std::uint64_t limit : {0u, 1u, 1000u, 20000u, 400000u, 8000000u}) {
    FI::Work_limit work(limit);
    const Ring ring({2, 3, 5}, work);
    Ring::Complex z = ring.one();
    std::size_t steps = 0;
    for(; !z.re.empty() && steps < 100000; ++steps)
      z = ring.times_side(z, ring.side(1, steps % 3 == 0 ? 2 : (steps % 3 == 1 ? 3 : 5), 1, 1));
    BOOST_TEST(work.is_met());
    BOOST_TEST(!ring.sign_of_sine({{}, z.im}).is_certain());
    BOOST_TEST(steps * 4 * FI::Work_limit::of_operation <= limit + 1000); // each takes four products at least
    BOOST_TEST((limit < 20000 || steps > last));
    last = steps;
  }
}

// ---------------------------------------------------------------- digits

namespace {

template <class Number>
bool holds(const Number& middle, double radius, const Real& value)
{
  return abs(Real(middle) - value) <= Real(radius);
}

} // namespace

BOOST_AUTO_TEST_CASE(balls_hold_what_they_stand_for)
{
  using Ball = FI::Ball_ring<20>;
  const Ball ring;
  Random_numbers random(4);
  for(int i = 0; i < 500 * scale; ++i) {
    const Integer dot = random.below(201) - 100, square = random.below(1000), divisor = 1 + random.below(90);
    const int sign = random.below(2) == 0 ? 1 : -1;
    const Ball::Side side = ring.side(dot, square, sign, divisor);
    const Real x = real(dot) / real(divisor), y = sign * sqrt(real(square)) / real(divisor);
    const Integer n = random.below(19) - 9;
    const Ball::Complex q = ring.combination(side, n);
    const std::array<Real, 2> value_of_q = {x, y * real(n)};
    BOOST_TEST((holds(q.re, q.radius, value_of_q[0]) && holds(q.im, q.radius, value_of_q[1])));
    Ball::Complex z = q; // errors grow from product to product
    std::array<Real, 2> value = value_of_q;
    for(int k = 0; k < 6; ++k) {
      z = ring.multiply(ring.times_side(ring.conjugate(z), side), q);
      value = product(product({value[0], -value[1]}, {x, y}), value_of_q);
      z = ring.add(z, ring.negate(ring.times_integer(q, k)));
      value = {value[0] - k * value_of_q[0], value[1] - k * value_of_q[1]};
      BOOST_TEST((holds(z.re, z.radius, value[0]) && holds(z.im, z.radius, value[1])));
      const CGAL::Uncertain<CGAL::Sign> found = ring.sign_of_sine(z);
      BOOST_TEST((!found.is_certain() || found.make_certain() == value[1].sign()));
    }
  }
}

// A way around a polygon of many sides, again and again: with errors of real and imaginary part apart, which grow by a
// quarter with each turn, nothing would be known after five hundred.
BOOST_AUTO_TEST_CASE(errors_do_not_grow_with_turns)
{
  const FI::Ball_ring<50> ring;
  auto z = ring.one();
  Real cosine = 1, sine = 0;
  for(int k = 1; k <= 20000; ++k) { // (3 + 4 i) / 5
    z = ring.times_side(z, ring.side(3, 16, 1, 5));
    const Real before = cosine;
    cosine = (3 * before - 4 * sine) / 5;
    sine = (4 * before + 3 * sine) / 5;
    const CGAL::Uncertain<CGAL::Sign> found = ring.sign_of_sine(z);
    BOOST_REQUIRE(found.is_certain());
    BOOST_REQUIRE(found.make_certain() == sine.sign());
  }
}

BOOST_AUTO_TEST_CASE(balls_that_hold_zero_have_no_sign)
{
  const FI::Ball_ring<50> ring;
  for(int middle : {-3, -2, -1, 0, 1, 2, 3}) {
    BOOST_TEST(ring.sign_of_sine({0, middle, 3, 0}).is_certain() == false);
    BOOST_TEST(ring.sign_of_sine({0, middle, 0, 0}).is_certain() == (middle != 0));
  }
  BOOST_TEST((ring.sign_of_sine({0, 4, 3, 0}) == CGAL::POSITIVE));
  BOOST_TEST((ring.sign_of_sine({0, -4, 3, 0}) == CGAL::NEGATIVE));
}
