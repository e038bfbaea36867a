// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The numbers that exact decisions are made of, one class at a time, against numbers that are exact or much longer: the
// decisions themselves come out right with most mistakes in them, since another stage makes up for it.

#define BOOST_TEST_MODULE internal_arithmetic

#include "mesh_soup.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/arithmetic/Double_double.h>
#include <CGAL/Flip_geodesics/internal/exact/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/exact/Orientation_of_places.h>
#include <CGAL/Flip_geodesics/internal/strand_order/Parity_classes.h>
#include <CGAL/Flip_geodesics/internal/strips/Precise_face.h>
#include <CGAL/Flip_geodesics/internal/strips/refresh_face.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
namespace FI = FG::internal;
using namespace Flip_geodesics_test;

namespace {

using FI::Integer;
using Rational = boost::multiprecision::cpp_rational;
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<300>>;

// ---------------------------------------------------------------- numbers of about 106 bits

using FI::Double_double;

Rational exact(const Double_double& a) { return Rational(a.high) + Rational(a.low); }

// The second number is half a unit in the last place of the first or less.
bool is_normal(const Double_double& a) { return a.high + a.low == a.high; }

Double_double random_number(Random_numbers& random, int largest_exponent)
{
  const int exponent = random.below(2 * largest_exponent + 1) - largest_exponent;
  const double high = std::ldexp(random.uniform(0.5, 1) * (random.below(2) == 0 ? 1 : -1), exponent);
  return FI::exact_sum(high, std::ldexp(random.uniform(-1, 1), exponent - 53 - random.below(20)));
}

// As random_number(), or all but the opposite of another one.
Double_double partner(const Double_double& a, Random_numbers& random, int largest_exponent)
{
  if(random.below(3) != 0)
    return random_number(random, largest_exponent);
  const double tiny = std::ldexp(random.uniform(-1, 1), -random.below(60));
  return FI::ordered_sum(-a.high, random.below(2) == 0 ? tiny * a.low : a.low + 0x1p-53 * tiny * a.high);
}

} // namespace

BOOST_AUTO_TEST_CASE(errors_of_pairs_of_doubles_are_bounded)
{
  Random_numbers random(1);
  const Rational bound(FI::double_double_error);
  for(int i = 0; i < 3000 * scale; ++i) {
    const Double_double a = random_number(random, 100), b = partner(a, random, 100);
    const Rational x = exact(a), y = exact(b);
    BOOST_TEST(abs(exact(a + b) - (x + y)) <= bound * (abs(x) + abs(y)));
    BOOST_TEST(abs(exact(a - b) - (x - y)) <= bound * (abs(x) + abs(y)));
    BOOST_TEST(abs(exact(a * b) - x * y) <= bound * abs(x * y));
    if(b.high != 0)
      BOOST_TEST(abs(exact(a / b) * y - x) <= bound * abs(x));
    const Double_double root = FI::sqrt(a.high < 0 ? -a : a);
    BOOST_TEST(abs(exact(root) * exact(root) - abs(x)) <= 2 * bound * abs(x));
    BOOST_TEST((is_normal(a + b) && is_normal(a * b) && is_normal(root)));
  }
}

BOOST_AUTO_TEST_CASE(the_root_of_nothing_is_nothing)
{
  const Double_double root = FI::sqrt(Double_double{0, 0});
  BOOST_TEST(root.high == 0);
  BOOST_TEST(root.low == 0);
}

namespace {

// The direction of the second of two sides with lengths a and b, in a triangle with the third length c.
std::array<Real, 2> direction_of_next(double a, double b, double c)
{
  const Rational x(a), y(b), z(c), dot = (z * z - x * x - y * y) / 2, square = x * x * y * y - dot * dot;
  const Real scale = Real(a) * Real(b);
  return {Real(Real(dot) / scale), Real(sqrt(Real(square)) / scale)};
}

void check_precise_face(const std::array<double, 3>& l)
{
  const auto face = FI::Precise_face_traits().construct_face_from_lengths_object()(l[0], l[1], l[2]);
  for(int i = 0; i < 3; ++i) {
    const std::array<Real, 2> expected = direction_of_next(l[i], l[(i + 1) % 3], l[(i + 2) % 3]);
    const Real x = Real(exact(face[i].next.x)) - expected[0], y = Real(exact(face[i].next.y)) - expected[1];
    BOOST_TEST(face[i].error < 0x1p-90);
    BOOST_TEST(x * x + y * y <= Real(face[i].error) * face[i].error);
    BOOST_TEST(exact(face[i].length) == Rational(l[i]));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(directions_in_faces_given_by_lengths_are_as_near_as_their_bounds)
{
  Random_numbers random(2);
  for(int i = 0; i < 200 * scale; ++i) { // from equilateral triangles to needles and caps
    const double a = random.uniform(1, 2), thin = std::ldexp(1, -random.below(80));
    std::array<double, 3> l = {a, a * random.uniform(0, 1), 0};
    l[1] = random.below(2) == 0 ? a : thin * l[1];
    const double smallest = std::abs(l[0] - l[1]), largest = l[0] + l[1];
    l[2] = smallest + (largest - smallest) * (random.below(2) == 0 ? thin : random.uniform(0, 1));
    if(FI::is_longer_than_sum(l[0], l[1], l[2]) || FI::is_longer_than_sum(l[1], l[2], l[0]) ||
       FI::is_longer_than_sum(l[2], l[0], l[1]))
      continue;
    for(int k = 0; k < 3; ++k, std::rotate(l.begin(), l.begin() + 1, l.end())) {
      check_precise_face(l);
      check_precise_face({l[2], l[1], l[0]});
    }
  }
}

BOOST_AUTO_TEST_CASE(faces_near_the_ends_of_the_range_have_no_bound)
{
  const auto error = [](double length) {
    return FI::Precise_face_traits().construct_face_from_lengths_object()(length, 1.5 * length, length)[0].error;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  BOOST_TEST(error(0x1p-201) == infinity);
  BOOST_TEST(error(0x1p200) == infinity);
  BOOST_TEST(error(0x1p-199) < 0x1p-90);
  BOOST_TEST(error(0x1p199) < 0x1p-90);
}

// ---------------------------------------------------------------- integers

namespace {

Integer random_integer(Random_numbers& random, int bits)
{
  Integer result = 1;
  for(int i = 1; i < bits; ++i)
    result = 2 * result + random.below(2);
  return result;
}

void check_root(const Integer& n)
{
  const Integer root = FI::rounded_root(n);
  BOOST_TEST((root * root <= n && n < (root + 1) * (root + 1)));
  const bool is_square = root * root == n;
  BOOST_TEST(FI::is_perfect_square(n) == is_square);
  BOOST_TEST((!is_square || *FI::exact_root(n) == root));
}

} // namespace

BOOST_AUTO_TEST_CASE(roots_of_integers_are_rounded_down)
{
  for(int n = 0; n < 300; ++n)
    check_root(n);
  BOOST_TEST(FI::is_perfect_square(-4) == false);
  Random_numbers random(11);
  for(int bits = 1; bits < 600; bits += 1 + bits / 8) {
    const Integer power = Integer(1) << bits, root = random_integer(random, bits);
    for(int off = -1; off <= 1; ++off) {
      check_root(power + off);
      check_root(power * power + off);
      check_root(root * root + off);
    }
    check_root(root);
  }
}

BOOST_AUTO_TEST_CASE(greatest_common_divisors_are_those_of_boost)
{
  Random_numbers random(12);
  const auto check = [](const Integer& x, const Integer& y) {
    BOOST_TEST(FI::greatest_common_divisor(x, y) == boost::multiprecision::gcd(x, y));
  };
  Integer fibonacci = 1, next = 2; // every quotient is 1
  for(int i = 0; i < 300; ++i) {
    check(fibonacci, next);
    fibonacci.swap(next);
    next += fibonacci;
  }
  for(int i = 0; i < 300 * scale; ++i) {
    const Integer common = random_integer(random, 1 + random.below(200));
    const Integer x = random_integer(random, 1 + random.below(200)), y = random_integer(random, 1 + random.below(200));
    check(x * common, y * common);
    check(common, x * common);
    check(common, common * (y << 70) + 1);
  }
  check(0, 0);
  check(0, 5);
  check(0, Integer(1) << 100);
  check(Integer(1) << 200, Integer(1) << 61);
  check((Integer(1) << 124) - 1, (Integer(1) << 62) - 1);
}

// ---------------------------------------------------------------- orientations

namespace {

template <std::size_t N>
using Places = std::array<std::array<double, N>, N + 1>;

template <std::size_t N>
int expected_orientation(const Places<N>& places)
{
  std::array<std::array<Rational, 3>, 3> v = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for(std::size_t i = 0; i < N; ++i)
    for(std::size_t k = 0; k < N; ++k)
      v[i][k] = Rational(places[i + 1][k]) - Rational(places[0][k]);
  Rational result = 0;
  for(std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    result += v[0][i] * (v[1][j] * v[2][k] - v[1][k] * v[2][j]);
  }
  return result.sign();
}

// Places on a small grid, where many lie in one plane; and the same with the last bits changed, or of another size.
template <std::size_t N>
void check_orientations(Random_numbers& random, const std::array<double, N>& scales)
{
  std::array<int, 3> count = {};
  for(int i = 0; i < 600 * scale; ++i) {
    Places<N> places;
    const double unit = i % 3 == 0 ? 1 : 0.1, change = i % 2 == 0 ? 0 : 0x1p-53;
    for(auto& place : places)
      for(std::size_t k = 0; k < N; ++k)
        place[k] = (random.below(5) - 2) * unit * scales[k] * (1 + change * random.below(3));
    const CGAL::Sign found = FI::Orientation_of_places<N>()(places);
    BOOST_TEST(found == expected_orientation<N>(places));
    ++count[static_cast<std::size_t>(found + 1)];
  }
  BOOST_TEST((count[0] > 10 && count[1] > 10 && count[2] > 10));
}

} // namespace

BOOST_AUTO_TEST_CASE(orientations_are_exact)
{
  Random_numbers random(13);
  for(double size : {1.0, 1e-90, 1e-160, 1e160}) {
    check_orientations<2>(random, {size, size});
    check_orientations<2>(random, {size, 1});
    check_orientations<3>(random, {size, size, size});
    check_orientations<3>(random, {1, size, 3});
  }
  for(double size : {0x1p-400, 0x1p400}) { // few digits, and products beyond double
    check_orientations<2>(random, {size, size});
    check_orientations<3>(random, {size, size, size});
  }
  check_orientations<2>(random, {1e300, 1e-310});
  check_orientations<3>(random, {1e300, 1e-160, 1e-162}); // a product of the last two has a few digits
  check_orientations<3>(random, {1e-160, 1e-162, 1e300});
}

// ---------------------------------------------------------------- roots

namespace {

const std::vector<Integer> radicands = {0, 1, 2, 3, 4, 6, 8, 9, 12, 18, 36, 49, 50, 72, 98, 105, 1001, 11025, 1 << 20};

} // namespace

BOOST_AUTO_TEST_CASE(roots_are_products_of_roots_of_coprime_numbers)
{
  for(std::size_t first = 0; first < radicands.size(); ++first) {
    std::vector<Integer> turned = radicands; // the base depends on the order
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    const FI::Root_base base(turned);
    const std::vector<Integer>& g = base.generators();
    for(std::size_t i = 0; i < g.size(); ++i) {
      BOOST_TEST((g[i] > 1 && sqrt(g[i]) * sqrt(g[i]) != g[i]));
      for(std::size_t k = 0; k < i; ++k)
        BOOST_TEST(gcd(g[i], g[k]) == 1);
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
      Real term(a[mask]);
      for(std::size_t i = 0; i < 3; ++i)
        if((mask >> i & 1) != 0)
          term *= sqrt(Real(base.generators()[i]));
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

// ---------------------------------------------------------------- fixed-point numbers

namespace {

using Fixed = FI::Fixed_point_ring;

constexpr int fixed_bits = 12;

bool holds(const Fixed::Number& a, const Real& value)
{
  return abs(Real(a.middle) - ldexp(value, fixed_bits)) <= Real(a.radius);
}

} // namespace

BOOST_AUTO_TEST_CASE(fixed_point_numbers_hold_what_they_stand_for)
{
  const Fixed ring(fixed_bits);
  Random_numbers random(4);
  for(int i = 0; i < 500 * scale; ++i) {
    const Integer dot = random.below(201) - 100, square = random.below(1000), divisor = 1 + random.below(90);
    const int sign = random.below(2) == 0 ? 1 : -1;
    const Fixed::Side side = ring.side(dot, square, sign, divisor);
    const Real x = Real(dot) / Real(divisor), y = sign * sqrt(Real(square)) / Real(divisor);
    BOOST_TEST((holds(side.dot, x) && holds(side.root, y)));
    Fixed::Number a = side.dot; // errors grow from product to product
    Real value = x;
    for(int k = 0; k < 6; ++k) {
      a = ring.add(ring.multiply(a, side.root), ring.negate(ring.times_integer(side.dot, k)));
      value = value * y - x * k;
      BOOST_TEST(holds(a, value));
      const CGAL::Uncertain<CGAL::Sign> found = ring.sign(a);
      BOOST_TEST((!found.is_certain() || found.make_certain() == value.sign()));
    }
  }
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

// ---------------------------------------------------------------- chains of faces

namespace {

using FI::Exact_face;
using FI::Unfolding_chain;
using FI::Unfolding_step;
using Kind = Unfolding_step::Kind;

// Points of a plane with whole coordinates, the second in units of sqrt(n): areas are multiples of that root.
struct Plane
{
  struct Vector
  {
    int x, y;

    Vector operator-(const Vector& v) const { return {x - v.x, y - v.y}; }
    Vector operator+(const Vector& v) const { return {x + v.x, y + v.y}; }
    Vector operator*(int s) const { return {s * x, s * y}; }
  };

  int n;

  int dot(const Vector& v, const Vector& w) const { return v.x * w.x + n * v.y * w.y; }
  static int det(const Vector& v, const Vector& w) { return v.x * w.y - v.y * w.x; }

  Exact_face face(const Vector& p, const Vector& q, const Vector& r) const
  {
    const Vector h = q - p, hn = r - q, hp = p - r;
    return {dot(h, h), dot(h, hn), dot(h, hp), n * det(h, hn) * det(h, hn)};
  }
};

using Vector = Plane::Vector;

/*
 * Faces that are passed one after the other, beginning at a point of the first; each is (left, right, apex). The point
 * need not be a corner of it, nor inside.
 */
class Random_strip
{
public:
  Random_strip(const Plane& plane, bool starts_at_corner, std::size_t number_of_faces, Random_numbers& random)
    : m_plane(plane)
    , m_random(random)
  {
    const Vector tail = {0, 0};
    do {
      right = random_vector();
      left = random_vector();
    } while(Plane::det(right - tail, left - tail) <= 0);
    first = starts_at_corner ? tail : random_vector();
    origin = tail;
    m_first_face = plane.face(tail, right, left);
    m_faces.reserve(number_of_faces);
    if(starts_at_corner)
      steps.push_back({Kind::START, &m_first_face});
    else
      steps.push_back({Kind::START_INSIDE, &m_first_face});
    m_first_sides = {right - tail, left - right};
    m_first_right = right;
    m_first_left = left;
    for(std::size_t i = 0; i < number_of_faces; ++i)
      pass_face();
  }

  Random_strip(const Random_strip&) = delete;
  Random_strip& operator=(const Random_strip&) = delete;

  // The end of the last gate, or a point of the last face, as seen from the start.
  Unfolding_chain chain(bool reads_left) const
  {
    Unfolding_chain result = start();
    result.reads_left = reads_left;
    return result;
  }

  Unfolding_chain chain_to_point(const std::array<int, 3>& weights) const
  {
    Unfolding_chain result = start();
    result.steps.back().kind = Kind::POINT;
    result.weights = {weights[0], weights[1], weights[2]};
    return result;
  }

  // The vector from the start, positive multiples of which the chains are.
  Vector to_right() const { return right - first; }
  Vector to_left() const { return left - first; }
  Vector to_point(const std::array<int, 3>& w) const
  {
    return (before_left - first) * w[0] + (before_right - first) * w[1] + (apex - first) * w[2];
  }

  // A vector as a combination of sides of the first face, turned back.
  Unfolding_chain vector(const Vector& v) const
  {
    Unfolding_chain result;
    result.is_conjugate = true;
    result.right = combination(v);
    result.steps.push_back({Kind::START_INSIDE, &m_first_face});
    return result;
  }

  Vector random_vector() { return {m_random.below(9) - 4, m_random.below(9) - 4}; }

  std::vector<Unfolding_step> steps;
  Vector first, origin, right, left, before_right, before_left, apex;

private:
  FI::Side_combination combination(const Vector& v) const
  {
    const Vector& h = m_first_sides[0];
    const Vector& hn = m_first_sides[1];
    return FI::Side_combination(m_first_face, {Plane::det(v, hn), Plane::det(h, v), 0});
  }

  Unfolding_chain start() const
  {
    Unfolding_chain result;
    result.steps = steps;
    if(first.x != origin.x || first.y != origin.y || steps.front().kind == Kind::START_INSIDE) {
      result.right = combination(m_first_right - first);
      result.left = combination(m_first_left - first);
      result.to_right = combination(m_first_right - m_first_left);
    }
    return result;
  }

  void pass_face()
  {
    before_right = right;
    before_left = left;
    do
      apex = right + random_vector();
    while(Plane::det(right - left, apex - left) <= 0);
    m_faces.push_back(m_plane.face(left, right, apex));
    const bool is_new_left = m_random.below(2) == 0;
    steps.push_back({is_new_left ? Kind::NEW_LEFT : Kind::NEW_RIGHT, &m_faces.back()});
    (is_new_left ? left : right) = apex;
  }

  Plane m_plane;
  Random_numbers& m_random;
  Exact_face m_first_face;
  std::array<Vector, 2> m_first_sides;
  Vector m_first_right, m_first_left;
  std::vector<Exact_face> m_faces;
};

using Chains = std::vector<Unfolding_chain>;

std::vector<Integer> squared_roots(const Chains& chains)
{
  std::vector<Integer> result;
  for(const Unfolding_chain& chain : chains)
    for(const Unfolding_step& step : chain.steps)
      result.push_back(step.squared_root());
  return result;
}

// All kinds of arithmetic at once; a sign where it is zero takes a proof.
void check_sign(const Chains& chains, int expected)
{
  const FI::Root_base base(squared_roots(chains));
  const FI::Multiquadratic_ring roots(base);
  BOOST_TEST(roots.sign(FI::Chain_arithmetic<FI::Multiquadratic_ring>(roots).sine(chains)) == expected);
  BOOST_TEST(FI::Vanishing_proof(chains, base)() == (expected == 0));
  const FI::Residue_ring residues(base, FI::random_prime(80));
  BOOST_TEST(residues.is_zero(FI::Chain_arithmetic<FI::Residue_ring>(residues).sine(chains)) == (expected == 0));
  const Fixed fixed(400);
  const CGAL::Uncertain<CGAL::Sign> by_digits = fixed.sign(FI::Chain_arithmetic<Fixed>(fixed).sine(chains));
  BOOST_TEST(by_digits.is_certain() == (expected != 0));
  BOOST_TEST((expected == 0 || by_digits.make_certain() == expected));
  FG::Decision_statistics statistics;
  BOOST_TEST(FI::Exact_sign(statistics)(chains) == expected);
}

int sign_of(int n) { return n > 0 ? 1 : (n < 0 ? -1 : 0); }

} // namespace

BOOST_AUTO_TEST_CASE(ends_of_strips_are_where_they_are_in_the_plane)
{
  Random_numbers random(5);
  for(int i = 0; i < 150 * scale; ++i) {
    const Plane plane = {1 + i % 3};
    Random_strip strip(plane, i % 2 == 0, 1 + static_cast<std::size_t>(i % 5), random);
    const std::array<int, 3> weights = {random.below(4), random.below(4), 1 + random.below(4)};
    const std::array<std::pair<Unfolding_chain, Vector>, 3> ends = {
        {{strip.chain(false), strip.to_right()},
         {strip.chain(true), strip.to_left()},
         {strip.chain_to_point(weights), strip.to_point(weights)}}};
    for(const auto& [chain, end] : ends) {
      if(end.x == 0 && end.y == 0)
        continue;
      check_sign({chain, strip.vector(end)}, 0);
      const Vector other = strip.random_vector();
      const int side = sign_of(Plane::det(other, end));
      if(side != 0)
        check_sign({chain, strip.vector(other)}, side);
    }
  }
}

// In planes with different roots, whose strips are beside the point of one another.
BOOST_AUTO_TEST_CASE(strips_with_many_roots_cancel_only_if_each_does)
{
  Random_numbers random(6);
  for(int i = 0; i < 10 * scale; ++i) {
    Random_strip a({2}, true, 2, random), b({3}, false, 2, random), c({5}, true, 1, random), d({7}, false, 1, random);
    Chains chains;
    const auto add = [&](const Random_strip& strip, const Vector& v) {
      chains.push_back(strip.chain(false));
      chains.push_back(strip.vector(v));
    };
    for(Random_strip* strip : {&b, &c, &d})
      add(*strip, strip->to_right());
    if(std::any_of(chains.begin(), chains.end(), [](const Unfolding_chain& chain) {
         return chain.is_conjugate && chain.right.number == 0 && chain.right.root_coefficient == 0;
       }))
      continue;
    const Vector end = a.to_right(), other = a.random_vector();
    if(end.x == 0 && end.y == 0)
      continue;
    add(a, end);
    check_sign(chains, 0);
    const int side = sign_of(Plane::det(other, end));
    if(side == 0)
      continue;
    chains.pop_back();
    chains.push_back(a.vector(other));
    check_sign(chains, side);
  }
}

// Strips that pass the same faces from either end: all roots are open at a time.
BOOST_AUTO_TEST_CASE(products_with_four_open_roots_are_proven)
{
  std::vector<Exact_face> faces;
  for(int n : {2, 3, 5, 7})
    faces.push_back(Plane{n}.face({0, 0}, {3, 1}, {1, 2}));
  for(std::size_t number = 1; number <= faces.size(); ++number) {
    Unfolding_chain there, back;
    for(std::size_t i = 0; i < number; ++i) {
      there.steps.push_back({i == 0 ? Kind::START : Kind::NEW_LEFT, &faces[i]});
      back.steps.push_back({i == 0 ? Kind::START : Kind::NEW_LEFT, &faces[number - 1 - i]});
    }
    there.reads_left = back.reads_left = true;
    Unfolding_chain opposite_there = there, opposite_back = back;
    opposite_there.is_conjugate = opposite_back.is_conjugate = true;
    const Chains chains = {there, back, opposite_there, opposite_back}, half = {there, back, opposite_there};
    BOOST_TEST(FI::Vanishing_proof(chains, FI::Root_base(squared_roots(chains)))());
    BOOST_TEST(!FI::Vanishing_proof(half, FI::Root_base(squared_roots(half)))());
  }
}

BOOST_AUTO_TEST_CASE(the_largest_number_of_roots_is_kept)
{
  Random_numbers random(7);
  FG::Decision_statistics statistics;
  const FI::Exact_sign sign(statistics);
  Random_strip a({2}, true, 2, random), b({3}, true, 2, random);
  const Chains one = {a.chain(true), a.vector(a.to_left())};
  BOOST_TEST(sign(one) == CGAL::ZERO);
  BOOST_TEST(statistics.most_roots == 1u);
  BOOST_TEST(sign({one[0], one[1], b.chain(true), b.vector(b.to_left())}) == CGAL::ZERO);
  BOOST_TEST(statistics.most_roots == 2u);
  BOOST_TEST(sign(one) == CGAL::ZERO);
  BOOST_TEST(statistics.most_roots == 2u);
  BOOST_TEST(statistics.zeros_by_roots == 3u);
}

// ---------------------------------------------------------------- corners

namespace {

// The corner dot + i sqrt(square), or its conjugate.
struct Corner
{
  int dot, square;
  bool is_conjugate = false;
};

bool is_real(const std::vector<Corner>& corners)
{
  std::vector<Exact_face> faces;
  faces.reserve(corners.size());
  Chains chains;
  for(const Corner& corner : corners) {
    faces.push_back({1, -corner.dot, 0, corner.square});
    chains.emplace_back();
    chains.back().is_conjugate = corner.is_conjugate;
    chains.back().steps.push_back({Kind::CORNER, &faces.back()});
  }
  return FI::Corner_product::is_real(chains);
}

} // namespace

BOOST_AUTO_TEST_CASE(products_of_corners_that_are_real_are_found)
{
  BOOST_TEST(!is_real({{0, 4}}));                               // one right angle
  BOOST_TEST(is_real({{0, 4}, {0, 4}}));                        // two
  BOOST_TEST(is_real({{0, 2}, {0, 3}}));                        // whatever the roots are
  BOOST_TEST(!is_real({{0, 2}, {0, 3}, {0, 5}}));               // three
  BOOST_TEST(is_real({{1, 3}, {1, 3}, {1, 3}}));                // of pi / 3
  BOOST_TEST(!is_real({{1, 3}, {1, 3}}));                       // two of them
  BOOST_TEST(is_real({{1, 1}, {1, 1}, {0, 7}}));                // pi / 4 twice, and a right angle
  BOOST_TEST(!is_real({{1, 1}, {0, 7}}));                       // once
  BOOST_TEST(is_real({{1, 2}, {1, 2, true}}));                  // there and back
  BOOST_TEST(!is_real({{1, 2}, {1, 2}}));                       // there and on
  BOOST_TEST(is_real({{1, 2}, {2, 8, true}, {3, 5}, {-3, 5}})); // roots that are multiples of each other
  BOOST_TEST(!is_real({{1, 2}, {2, 8}}));                       // the same, not back
  BOOST_TEST(!is_real({{1, 2}, {1, 3, true}}));                 // roots that are not
  BOOST_TEST(!is_real({{1, 0}}));                               // no area: left to others
  BOOST_TEST(is_real({{3, 18}, {1, 2, true}, {2, 50}, {2, 50, true}, {5, 50}, {-1, 2}}));
}

// ---------------------------------------------------------------- classes of literals

BOOST_AUTO_TEST_CASE(literals_are_not_equal_to_their_opposites)
{
  FI::Parity_classes classes(3);
  BOOST_TEST(classes.unite(2, 2));
  BOOST_TEST(!classes.unite(2, 3));
  BOOST_TEST(classes.unite(2, 5));
  BOOST_TEST(!classes.unite(3, 5));
  BOOST_TEST(!classes.unite(4, 2));
  BOOST_TEST(classes.unite(4, 3));
  BOOST_TEST(!classes.unite(0, 1));
  BOOST_TEST(classes.representative(4) == 3);
}

// Against the values of all variables that are possible.
BOOST_AUTO_TEST_CASE(literals_are_united_unless_they_are_opposite)
{
  constexpr int variables = 7, assignments = 1 << variables;
  Random_numbers random(8);
  for(int i = 0; i < 100 * scale; ++i) {
    FI::Parity_classes classes(variables);
    std::vector<bool> is_possible(assignments);
    for(int v = 0; v < assignments; v += 2) // variable 0 is false
      is_possible[v] = true;
    const auto value = [](int assignment, int literal) { return (assignment >> (literal / 2) & 1) != literal % 2; };
    const auto are_equal_in_all = [&](int a, int b) {
      for(int v = 0; v < assignments; ++v)
        if(is_possible[v] && value(v, a) != value(v, b))
          return false;
      return true;
    };
    for(int k = 0; k < 12; ++k) {
      const int a = random.below(2 * variables), b = random.below(2 * variables);
      BOOST_TEST(classes.unite(a, b) == !are_equal_in_all(a, b ^ 1));
      if(!are_equal_in_all(a, b ^ 1))
        for(int v = 0; v < assignments; ++v)
          is_possible[v] = is_possible[v] && value(v, a) == value(v, b);
    }
    for(int a = 0; a < 2 * variables; ++a) {
      const int r = classes.representative(a);
      BOOST_TEST(are_equal_in_all(a, r));
      for(int b = 0; b < r / 2 * 2; ++b) // it is the smallest
        BOOST_TEST(!are_equal_in_all(a, b));
    }
  }
}

// ---------------------------------------------------------------- doubles

namespace {

using Plain = FG::Intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;
using Certified = FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;

// The halfedges before and after a corner of an angle, with the given lengths.
template <class Halfedge_geometry>
std::array<Halfedge_geometry, 2> sides_of_corner(double angle, double in, double out)
{
  Halfedge_geometry a = {}, b = {};
  a.x = -in;
  b.x = out * std::cos(angle);
  b.y = -out * std::sin(angle); // on the left
  return {a, b};
}

template <class Traits>
typename Traits::Turn turn_over(const std::vector<double>& angles, double length)
{
  typename Traits::Turn turn;
  for(double angle : angles) {
    const auto sides = sides_of_corner<typename Traits::Halfedge_geometry>(angle, length, length);
    Traits().extend_turn_object()(turn, sides[0], sides[1], sides[0]);
  }
  return turn;
}

} // namespace

BOOST_AUTO_TEST_CASE(turns_over_large_and_small_faces_neither_overflow_nor_vanish)
{
  for(double length : {1e-69, 1.0, 1e69})
    for(int corners : {10, 100}) {
      const Plain traits;
      const auto compare = traits.compare_turn_with_straight_object();
      const auto below = turn_over<Plain>(std::vector<double>(corners, 0.99 * pi / corners), length);
      const auto above = turn_over<Plain>(std::vector<double>(corners, 1.01 * pi / corners), length);
      BOOST_TEST((compare(below) == CGAL::SMALLER));
      BOOST_TEST((compare(above) == CGAL::LARGER));
      const auto half = turn_over<Plain>(std::vector<double>(corners, 0.5 * pi / corners), length);
      BOOST_TEST(std::abs(traits.turn_key_object()(half) - 1) < 1e-12);
    }
}

// A face without area, seen through rounding: its corner is not below zero.
BOOST_AUTO_TEST_CASE(corners_of_faces_without_area_do_not_turn_back)
{
  const auto sides = sides_of_corner<Plain::Halfedge_geometry>(-1e-17, 1, 1);
  Plain::Turn turn;
  for(int i = 0; i < 3; ++i)
    Plain().extend_turn_object()(turn, sides[0], sides[1], sides[0]);
  BOOST_TEST((Plain().compare_turn_with_straight_object()(turn) == CGAL::SMALLER));
}

BOOST_AUTO_TEST_CASE(edges_opposite_to_wide_angles_are_not_delaunay)
{
  for(double first : {0.3, 0.9, 1.7, 2.5, pi})
    for(double second : {0.2, 1.1, 1.6, 2.9, pi}) {
      const auto k = sides_of_corner<Plain::Halfedge_geometry>(first, 2, 1);
      const auto l = sides_of_corner<Plain::Halfedge_geometry>(second, 1, 3);
      const auto is_delaunay = Plain().is_locally_delaunay_object()(k[0], k[0], k[1], l[0], l[0], l[1]);
      BOOST_TEST(is_delaunay.is_certain());
      BOOST_TEST((is_delaunay.make_certain() == (first + second < pi)));
    }
}

BOOST_AUTO_TEST_CASE(layouts_of_needles_are_accurate_relative_to_each_side)
{
  Random_numbers random(9);
  for(int i = 0; i < 500 * scale; ++i) {
    const double a = random.uniform(1, 2), thin = std::ldexp(1, -random.below(50));
    std::array<double, 3> l = {a, a - thin * random.uniform(0, 0.9), thin * random.uniform(1, 2)};
    if(random.below(2) == 0)
      std::swap(l[1], l[2]);
    std::rotate(l.begin(), l.begin() + i % 3, l.end());
    if(FI::is_longer_than_sum(l[0], l[1], l[2]) || FI::is_longer_than_sum(l[1], l[2], l[0]) ||
       FI::is_longer_than_sum(l[2], l[0], l[1]))
      continue;
    const auto face = Plain().construct_face_from_lengths_object()(l[0], l[1], l[2]);
    const std::array<Real, 2> next = direction_of_next(l[0], l[1], l[2]);
    const Real x = Real(face[1].x) / l[1] - next[0], y = Real(face[1].y) / l[1] - next[1];
    BOOST_TEST(sqrt(x * x + y * y) < 16 * std::numeric_limits<double>::epsilon());
  }
}

BOOST_AUTO_TEST_CASE(a_face_with_a_side_longer_than_the_others_by_rounding_has_no_area)
{
  const double longer = 1 + 2 * std::numeric_limits<double>::epsilon();
  for(const std::array<double, 3>& l : {std::array<double, 3>{longer, 0.5, 0.5}, {0.5, longer, 0.5}, {1, 0.25, 0.75}})
    for(const auto& side : Plain().construct_face_from_lengths_object()(l[0], l[1], l[2]))
      BOOST_TEST(side.y == 0);
}

// Two corners that are acute but for their errors make less than a straight angle, but for theirs.
BOOST_AUTO_TEST_CASE(corners_within_their_error_of_right_angles_are_not_taken_for_acute)
{
  const double angle = pi / 2 - 1e-3;
  for(double error : {1e-6, 1e-2}) {
    auto sides = sides_of_corner<Certified::Halfedge_geometry>(angle, 1, 1);
    sides[0].error = error;
    Certified::Turn turn;
    Certified().extend_turn_object()(turn, sides[1], sides[0], sides[0]); // an error in the turn
    const auto turn_before = turn_over<Certified>({1e-3}, 1);
    turn = turn_before;
    Certified().extend_turn_object()(turn, sides[0], sides[1], sides[0]);
    BOOST_TEST(Certified().compare_turn_with_straight_object()(turn).is_certain());
    turn = turn_over<Certified>({angle}, 1);
    Certified().extend_turn_object()(turn, sides[0], sides[1], sides[0]);
    const auto comparison = Certified().compare_turn_with_straight_object()(turn);
    BOOST_TEST(comparison.is_certain() == (error < 1e-3));
    BOOST_TEST(comparison.inf() == CGAL::SMALLER);
  }
}

namespace {

// A triangle with a side of length 1 and corners at its ends, each with an error.
std::optional<Plain::Face_geometry> laid_out(double at_tail, double at_head, double error)
{
  const double sum = at_tail + at_head, second = std::abs(std::sin(at_tail) / std::sin(sum)),
               third = std::abs(std::sin(at_head) / std::sin(sum));
  return FI::laid_out_face(Plain(), {{{{1, 0}, {second, 0}, {third, 0}}}, {at_tail, error}, {at_head, error}}, 0);
}

} // namespace

BOOST_AUTO_TEST_CASE(faces_with_corners_below_zero_or_above_pi_are_refused)
{
  BOOST_TEST(laid_out(1, 1.2, 0).has_value());
  for(double wrong : {-1e-3, pi + 1e-3}) {
    BOOST_TEST(!laid_out(wrong, 1, 1e-6).has_value());
    BOOST_TEST(!laid_out(1, wrong, 1e-6).has_value());
    BOOST_TEST(laid_out(wrong, 1, 1e-2).has_value());
    BOOST_TEST(laid_out(1, wrong, 1e-2).has_value());
  }
}

BOOST_AUTO_TEST_CASE(corners_below_zero_by_their_error_are_zero)
{
  for(double rounded : {-1e-9, 0.0}) {
    const auto face = FI::laid_out_face(Plain(), {{{{1, 0}, {0.5, 0}, {0.5, 0}}}, {rounded, 1e-8}, {rounded, 1e-8}}, 0);
    BOOST_TEST((*face)[2].y == 0);
    BOOST_TEST((*face)[2].x == -0.5);
    BOOST_TEST(std::abs((*face)[1].y) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(lengths_have_a_range)
{
  BOOST_TEST(!FI::is_usable_length(0));
  BOOST_TEST(!FI::is_usable_length(0.9e-70));
  BOOST_TEST(FI::is_usable_length(1.1e-70));
  BOOST_TEST(FI::is_usable_length(0.9e70));
  BOOST_TEST(!FI::is_usable_length(1.1e70));
  BOOST_TEST(!FI::is_usable_length(std::numeric_limits<double>::quiet_NaN()));
}
