// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The numbers with which exact predicates compute, one class at a time, against numbers that are exact or much longer:
// the decisions themselves come out right with most mistakes in them, since another stage makes up for it.

#define BOOST_TEST_MODULE internal_arithmetic

#include "test_internal_arithmetic/numbers.h"

#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/orientation.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>

using namespace Flip_geodesics_test;

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

BOOST_AUTO_TEST_CASE(roots_of_integers_are_rounded_down)
{
  for(int n = 0; n < 300; ++n)
    check_root(n);
  BOOST_TEST(!FI::exact_root(-4));
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

BOOST_AUTO_TEST_CASE(integers_are_converted_to_other_numbers_exactly)
{
  Random_numbers random(12);
  BOOST_TEST(FI::converted<Rational>(0) == 0);
  for(int bits = 1; bits < 200; ++bits) {
    const Integer n = random_integer(random, bits);
    BOOST_TEST(FI::converted<Rational>(n) == Rational(n));
    BOOST_TEST(FI::converted<Rational>(Integer(-n)) == -Rational(n));
  }
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

CGAL::Sign found_orientation(const Places<3>& p) { return FI::Orientation_of_places()(p); }

CGAL::Sign found_orientation(const Places<2>& p)
{
  const auto in_space = [](const std::array<double, 2>& q) { return FI::Place_in_space{q[0], q[1], 7}; };
  return FI::orientation_along(2, in_space(p[0]), in_space(p[1]), in_space(p[2]));
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
    const CGAL::Sign found = found_orientation(places);
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

// The determinant of (1 + e, 1, 0), (1, 1 - e, 0), (0, 0, 1) is -e^2, which double-double arithmetic does not resolve.
BOOST_AUTO_TEST_CASE(orientations_beyond_double_double_arithmetic_are_exact)
{
  constexpr double e = 0x1p-52;
  std::array<std::size_t, 3> rows = {0, 1, 2};
  do {
    std::array<std::size_t, 3> columns = {0, 1, 2};
    do {
      Places<3> places = {};
      places[rows[0] + 1][columns[0]] = 1 + e;
      places[rows[0] + 1][columns[1]] = places[rows[1] + 1][columns[0]] = places[rows[2] + 1][columns[2]] = 1;
      places[rows[1] + 1][columns[1]] = 1 - e;
      BOOST_TEST(
          (found_orientation(places) != CGAL::ZERO && found_orientation(places) == expected_orientation(places)));
      places[rows[1] + 1][columns[1]] = 1 / (1 + e); // rounded
      BOOST_TEST(found_orientation(places) == expected_orientation(places));
    } while(std::next_permutation(columns.begin(), columns.end()));
  } while(std::next_permutation(rows.begin(), rows.end()));
}

BOOST_AUTO_TEST_CASE(signs_of_rational_places_are_exact)
{
  Random_numbers random(14);
  std::array<int, 3> count = {};
  for(int i = 0; i < 300 * scale; ++i) {
    std::array<std::array<Rational, 3>, 4> places;
    std::array<FI::Rational_place, 4> found;
    const int size = i % 2 == 0 ? 3 : 100; // many lie in one plane
    for(std::size_t k = 0; k < 4; ++k) {
      std::array<FI::Rational, 3> p;
      for(std::size_t axis = 0; axis < 3; ++axis) {
        p[axis] = {random.below(2 * size + 1) - size, 1 + random.below(6)};
        places[k][axis] = Rational(p[axis].numerator) / Rational(p[axis].denominator);
      }
      found[k] = FI::rational_place(p[0], p[1], p[2]);
    }
    std::array<std::array<Rational, 3>, 3> v;
    for(std::size_t k = 0; k < 3; ++k) {
      const std::array<Double_double, 3> precise = FI::precise_difference(found[0], found[k + 1]);
      for(std::size_t axis = 0; axis < 3; ++axis) {
        v[k][axis] = places[k + 1][axis] - places[0][axis];
        BOOST_TEST(abs(exact(precise[axis]) - v[k][axis]) <= Rational(0x1p-100) * abs(v[k][axis]));
      }
    }
    Rational volume = 0, dot = 0;
    const FI::Exact_vector<FI::Rational_place> a(found[0], found[1]), b(found[0], found[2]);
    for(std::size_t x = 0; x < 3; ++x) {
      const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
      const Rational cross = v[0][y] * v[1][z] - v[0][z] * v[1][y];
      BOOST_TEST(sign_of_cross(a, b, x) == cross.sign());
      volume += v[2][x] * cross;
      dot += v[0][x] * v[1][x];
    }
    BOOST_TEST(sign_of_dot(a, b) == dot.sign());
    BOOST_TEST(FI::orientation(found[0], found[1], found[2], found[3]) == volume.sign());
    ++count[static_cast<std::size_t>(volume.sign() + 1)];
  }
  BOOST_TEST((count[0] > 10 && count[1] > 0 && count[2] > 10));
}

// The right triangle with sides 3, 4 and 5, at half of this size.
BOOST_AUTO_TEST_CASE(squared_lengths_determine_a_face)
{
  const FI::Squared_lengths face = {{9, 16, 25}, 4};
  const std::array<double, 3> lengths = {1.5, 2, 2.5}, dots = {0, -4, -2.25};
  for(std::size_t i = 0; i < 3; ++i) {
    BOOST_TEST(exact(face.length(i)) == Rational(lengths[i]));
    BOOST_TEST(exact(face.dot(i)) == Rational(dots[i]));
  }
  BOOST_TEST(exact(face.doubled_area()) == 3);
  BOOST_TEST(face.satisfy_triangle_inequality());
  BOOST_TEST((FI::Squared_lengths{{1, 4, 9}, 7}).satisfy_triangle_inequality()); // flat
  BOOST_TEST(!(FI::Squared_lengths{{1, 4, 10}, 7}).satisfy_triangle_inequality());
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

BOOST_AUTO_TEST_CASE(products_of_vectors_have_the_signs_of_integers)
{
  using Place = std::array<double, 3>;
  using Integers = std::array<FI::Integer, 3>;
  Random_numbers random(6);
  int right = 0, parallel = 0, wrong = 0;
  for(int i = 0; i < 20000 * scale; ++i) {
    // Perpendicular or parallel up to rounding, and exactly along the axes; sometimes moved by a unit in the last
    // place.
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), far = i % 3 == 0 ? 1e6 : 0;
    Place o = {far, 1 - far, 0.1}, a = {o[0] + x, o[1] + y, 0.1}, b = {o[0] - y, o[1] + x, 0.1};
    if(i % 2 == 0)
      b = {o[0], o[1], random.uniform(-1, 1)};
    if(i % 11 < 3)
      b = {o[0] + 2 * (a[0] - o[0]), o[1] + 2 * (a[1] - o[1]), 0.1};
    if(i % 5 == 0)
      b[static_cast<std::size_t>(random.below(3))] += 0x1p-40;
    if(i % 7 == 0)
      for(Place* p : {&o, &a, &b})
        for(double& c : *p)
          c *= i % 14 == 0 ? 0x1p-200 : 0x1p200;
    const auto n = FI::to_integers<9>({o[0], o[1], o[2], a[0], a[1], a[2], b[0], b[1], b[2]});
    const Integers u = {n[3] - n[0], n[4] - n[1], n[5] - n[2]}, v = {n[6] - n[0], n[7] - n[1], n[8] - n[2]};
    const FI::Exact_vector<Place> to_a(o, a), to_b(o, b);
    const FI::Integer dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    wrong += static_cast<int>(sign_of_dot(to_a, to_b)) == dot.sign() ? 0 : 1;
    right += dot == 0 ? 1 : 0;
    bool is_parallel = true;
    for(std::size_t k = 0; k < 3; ++k) {
      const FI::Integer cross = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
      wrong += static_cast<int>(sign_of_cross(to_a, to_b, k)) == cross.sign() ? 0 : 1;
      is_parallel = is_parallel && cross == 0;
    }
    wrong += are_parallel(to_a, to_b) == is_parallel ? 0 : 1;
    parallel += is_parallel ? 1 : 0;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(right > 3000);
  BOOST_TEST(parallel > 1000);
  BOOST_TEST(right + parallel < 19000 * scale);
  // Of two directions along axes, two coordinates of the cross product are zero.
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t k = 0; k < 3; ++k) {
      Place a = {0, 0, 0}, b = {0, 0, 0};
      a[i] = b[k] = 0.1;
      BOOST_TEST(are_parallel(FI::Exact_vector<Place>({0, 0, 0}, a), FI::Exact_vector<Place>({0, 0, 0}, b)) ==
                 (i == k));
    }
  // Products of doubles underflow, or lose their last bits.
  const Place o = {0, 0, 0};
  for(double size : {0x1p-1060, 0x1p-600, 0x1p-520, 0x1p-460}) {
    const FI::Exact_vector<Place> u(o, {size, 3 * size, 0}), v(o, {5 * size, 15 * size, 0}), w(o, {-3 * size, size, 1});
    BOOST_TEST((are_parallel(u, v) && !are_parallel(u, w) && sign_of_dot(u, w) == CGAL::ZERO));
    BOOST_TEST(sign_of_dot(u, v) == CGAL::POSITIVE);
    BOOST_TEST(sign_of_cross(u, w, 2) == CGAL::POSITIVE);
  }
}

namespace {

CGAL::Sign sign_of(const FI::Root_sum& sum)
{
  FI::Work_limit work;
  return sum.sign(work).make_certain();
}

} // namespace

BOOST_AUTO_TEST_CASE(sums_of_roots_have_the_sign_of_many_digits)
{
  using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>>;
  Random_numbers random(8);
  int zeros = 0, wrong = 0;
  for(int i = 0; i < 300 * scale; ++i) {
    // Each root stands twice in half of the sums, as its multiple by a square, with a factor that takes it away.
    FI::Root_sum sum;
    Real value = 0;
    const auto add = [&](long long factor, long long square) {
      sum.add(factor, square);
      value += factor * sqrt(Real(square));
    };
    const bool is_zero = i % 2 == 0;
    const int roots = 1 + random.below(150);
    for(int k = 0; k < roots; ++k) {
      const long long square = 1 + random.below(1 << 20), factor = 1 + random.below(1000), n = 2 + random.below(3);
      add(factor * n, square);
      add(is_zero || k > 0 ? -factor : (i % 4 == 1 ? 1 : -1) - factor, square * n * n);
    }
    zeros += is_zero ? 1 : 0;
    const CGAL::Sign expected = is_zero ? CGAL::ZERO : (value > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE);
    wrong += sign_of(sum) == expected ? 0 : 1;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(zeros > 100);

  // sqrt(n) - 2 sqrt(n + 1) + sqrt(n + 2), which is 2^-242 of its terms.
  const FI::Integer n = FI::Integer(1) << 120;
  FI::Root_sum nearly;
  nearly.add(1, n);
  nearly.add(1, n + 2);
  nearly.add(-2, n + 1);
  BOOST_TEST((sign_of(nearly) == CGAL::NEGATIVE));
  FI::Work_limit little(1000);
  BOOST_TEST(!nearly.sign(little).is_certain());
  BOOST_TEST(little.is_met());
  BOOST_TEST((sign_of(FI::Root_sum()) == CGAL::ZERO));
  FI::Root_sum nothing;
  nothing.add(5, 0);
  nothing.add(0, 5);
  BOOST_TEST((sign_of(nothing) == CGAL::ZERO));
}
