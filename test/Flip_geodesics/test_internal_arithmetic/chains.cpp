// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Chains of faces, and products of their corners.

#include "test_internal_arithmetic/numbers.h"

using namespace Flip_geodesics_test;

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
    m_first_face = plane.face(tail, right, left);
    m_faces.reserve(number_of_faces);
    steps.push_back({Kind::START, &m_first_face});
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
    result.steps.push_back({Kind::START, &m_first_face});
    return result;
  }

  Vector random_vector() { return {m_random.below(9) - 4, m_random.below(9) - 4}; }

  std::vector<Unfolding_step> steps;
  Vector first, right, left, before_right, before_left, apex;

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
    result.right = combination(m_first_right - first);
    result.left = combination(m_first_left - first);
    result.to_right = combination(m_first_right - m_first_left);
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
using Roots = FI::Multiquadratic_ring;
using Digits = FI::Ball_ring<50>;

std::vector<Integer> squared_roots(const Chains& chains)
{
  std::vector<Integer> result;
  for(const Unfolding_chain& chain : chains)
    for(const Unfolding_step& step : chain.steps)
      result.push_back(step.squared_root());
  return result;
}

// Both kinds of arithmetic, and the stages.
void check_sign(const Chains& chains, int expected)
{
  FI::Work_limit work;
  const Roots roots(squared_roots(chains), work);
  BOOST_TEST((FI::Chain_arithmetic<Roots>(roots).sign_of_sine(chains) == CGAL::Sign(expected)));
  const Digits digits;
  const CGAL::Uncertain<CGAL::Sign> by_digits = FI::Chain_arithmetic<Digits>(digits).sign_of_sine(chains);
  BOOST_TEST(by_digits.is_certain() == (expected != 0));
  BOOST_TEST((expected == 0 || by_digits.make_certain() == expected));
  FG::Decision_statistics statistics;
  BOOST_TEST(FI::Exact_sign(statistics)(chains) == expected);
  BOOST_TEST(statistics.unproven_zeros == 0u);
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

// Strips that pass the same faces from either end.
BOOST_AUTO_TEST_CASE(products_with_their_conjugates_are_real)
{
  std::vector<Exact_face> faces;
  for(int n : {2, 3, 5, 7})
    faces.push_back(Plane{n}.face({0, 0}, {3, 1}, {1, 2}));
  for(std::size_t number = 1; number <= faces.size(); ++number) {
    Unfolding_chain there = FI::chain_to_side(faces.front(), {1, 0, 0}, 1);
    Unfolding_chain back = FI::chain_to_side(faces[number - 1], {1, 0, 0}, 1);
    for(std::size_t i = 1; i < number; ++i) {
      there.steps.push_back({Kind::NEW_LEFT, &faces[i]});
      back.steps.push_back({Kind::NEW_LEFT, &faces[number - 1 - i]});
    }
    there.reads_left = back.reads_left = true;
    Unfolding_chain opposite_there = there, opposite_back = back;
    opposite_there.is_conjugate = opposite_back.is_conjugate = true;
    const Chains chains = {there, back, opposite_there, opposite_back}, half = {there, back, opposite_there};
    FG::Decision_statistics statistics;
    check_sign(chains, 0);
    BOOST_TEST(FI::Exact_sign(statistics)(half) != CGAL::ZERO);
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

// A zero is one only as far as the work limit allows to prove it; what digits tell needs no proof.
BOOST_AUTO_TEST_CASE(signs_beyond_the_limit_of_work_are_counted)
{
  Random_numbers random(9);
  Random_strip a({2}, true, 2, random), b({3}, true, 2, random);
  const Chains zero = {a.chain(true), a.vector(a.to_left()), b.chain(true), b.vector(b.to_left())};
  const Chains positive = {a.chain(true), a.vector(a.to_left()), b.chain(true)};
  for(std::uint64_t limit : {std::uint64_t(0), std::uint64_t(1000), FI::default_sign_work}) {
    FG::Decision_statistics statistics;
    const FI::Exact_sign sign(statistics, limit);
    const bool is_enough = limit == FI::default_sign_work;
    BOOST_TEST(sign(zero) == CGAL::ZERO);
    BOOST_TEST(statistics.unproven_zeros == (is_enough ? 0u : 1u));
    BOOST_TEST(statistics.zeros_by_roots == (is_enough ? 1u : 0u));
    BOOST_TEST(sign(positive) != CGAL::ZERO);
    BOOST_TEST(statistics.by_precision == 1u);
    BOOST_TEST(statistics.unproven_zeros == (is_enough ? 0u : 1u));
  }
}

// With one root exact numbers come first, and then digits.
BOOST_AUTO_TEST_CASE(digits_decide_what_is_beyond_the_limit_of_work)
{
  Random_numbers random(10);
  const Plane plane = {2};
  const Exact_face face = plane.face({0, 0}, {3, 1}, {1, 2});
  Unfolding_chain corner;
  corner.steps.push_back({Kind::CORNER, &face});
  FG::Decision_statistics by_roots, by_digits;
  const CGAL::Sign sign = FI::Exact_sign(by_roots)({corner});
  BOOST_TEST(sign != CGAL::ZERO);
  BOOST_TEST(by_roots.by_roots == 1u);
  BOOST_TEST(FI::Exact_sign(by_digits, 0)({corner}) == sign);
  BOOST_TEST(by_digits.by_precision == 1u);
  BOOST_TEST(by_digits.unproven_zeros == 0u);
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
  FG::Decision_statistics statistics;
  return FI::Exact_sign(statistics)(chains) == CGAL::ZERO && statistics.unproven_zeros == 0;
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
  BOOST_TEST(is_real({{1, 0}}));                                // no area
  BOOST_TEST(is_real({{3, 18}, {1, 2, true}, {2, 50}, {2, 50, true}, {5, 50}, {-1, 2}}));
}
