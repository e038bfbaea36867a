// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Corners and lengths as doubles.

#include "test_internal_arithmetic/numbers.h"

#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/Interval_nt.h>

using namespace Flip_geodesics_test;

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
  return FI::laid_out_face(Plain(),
                           {{{{1, 0}, {second, 0}, {third, 0}}},
                            {{at_tail, error}, std::polar(1.0, at_tail)},
                            {{at_head, error}, std::polar(1.0, at_head)}},
                           0);
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
  for(double at_limit : {-1e-2, pi + 1e-2}) {
    BOOST_TEST(laid_out(at_limit, 1, 1e-2).has_value());
    BOOST_TEST(laid_out(1, at_limit, 1e-2).has_value());
  }
}

BOOST_AUTO_TEST_CASE(corners_below_zero_by_their_error_are_zero)
{
  for(double rounded : {-1e-9, 0.0}) {
    const auto face = FI::laid_out_face(Plain(),
                                        {{{{1, 0}, {0.5, 0}, {0.5, 0}}},
                                         {{rounded, 1e-8}, std::polar(1.0, rounded)},
                                         {{rounded, 1e-8}, std::polar(1.0, rounded)}},
                                        0);
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

// Against the singular values of linear maps, from triangles of all shapes; and never too large.
BOOST_AUTO_TEST_CASE(least_stretch_of_linear_maps)
{
  Random_numbers random(3);
  const auto number = [&] { return (random.below(2001) - 1000) / 1000.; };
  const auto lengths = [](const std::array<std::array<double, 2>, 3>& p) {
    std::array<double, 3> result;
    for(int i = 0; i < 3; ++i)
      result[i] = std::hypot(p[(i + 1) % 3][0] - p[i][0], p[(i + 1) % 3][1] - p[i][1]);
    return result;
  };
  int used = 0;
  for(int i = 0; i < 2000; ++i) {
    const double a = number(), b = number(), c = number(), d = number();
    std::array<std::array<double, 2>, 3> before, after;
    for(int k = 0; k < 3; ++k) {
      before[k] = {number(), number()};
      after[k] = {1e5 * (a * before[k][0] + b * before[k][1]), 1e5 * (c * before[k][0] + d * before[k][1])};
    }
    const double squares = a * a + b * b + c * c + d * d, product = std::abs(a * d - b * c);
    const double larger =
        std::sqrt(0.5 * (squares + std::sqrt((std::max)(squares * squares - 4 * product * product, 0.))));
    const double expected = 1e5 * product / larger;
    const double area = std::abs((before[1][0] - before[0][0]) * (before[2][1] - before[0][1]) -
                                 (before[1][1] - before[0][1]) * (before[2][0] - before[0][0]));
    const double stretch = FG::internal::least_stretch(lengths(before), lengths(after));
    BOOST_TEST(stretch <= expected * (1 + 1e-9));
    if(product < 0.1 || area < 0.1)
      continue;
    ++used;
    BOOST_TEST(stretch >= expected * (1 - 1e-6));
  }
  BOOST_TEST(used > 500);
}

namespace {

// A triangle and a border of three edges, with a length for each halfedge.
struct One_face
{
  FG::Index number_of_halfedges() const { return 6; }
  bool is_border(FG::Input_halfedge_index h) const { return h.idx() >= 3; }
  FG::Input_halfedge_index next(FG::Input_halfedge_index h) const
  {
    return FG::Input_halfedge_index(h.idx() % 3 == 2 ? h.idx() - 2 : h.idx() + 1);
  }
};

struct Scaled_lengths
{
  double weight(const One_face&, FG::Input_halfedge_index h) const { return scale * lengths[h.idx()]; }

  double scale;
  std::array<double, 6> lengths = {{3, 4, 5, 1, 1, 9}};
};

} // namespace

// Edges that follow each other on the border make no triangle.
BOOST_AUTO_TEST_CASE(least_stretch_of_faces_passes_over_the_border)
{
  const double stretch = FG::internal::least_stretch_of_faces(Scaled_lengths{1}, Scaled_lengths{2}, One_face());
  BOOST_TEST(stretch <= 2);
  BOOST_TEST(stretch > 2 - 1e-5);
}

BOOST_AUTO_TEST_CASE(least_stretch_of_what_is_no_triangle)
{
  using FG::internal::least_stretch;
  BOOST_TEST(least_stretch({3, 4, 5}, {6, 8, 10}) <= 2);
  BOOST_TEST(least_stretch({3, 4, 5}, {6, 8, 10}) > 2 - 1e-5); // a root of what is taken off
  BOOST_TEST(least_stretch({3, 4, 5}, {3, 4, 7}) == 0);        // flat
  BOOST_TEST(least_stretch({3, 4, 5}, {3, 4, 9}) == 0);        // none
  BOOST_TEST(least_stretch({3, 4, 5}, {0, 4, 4}) == 0);
  BOOST_TEST(least_stretch({0, 4, 4}, {3, 4, 5}) > 0.5);
  BOOST_TEST(least_stretch({0, 0, 0}, {3, 4, 5}) == std::numeric_limits<double>::infinity());
  BOOST_TEST(least_stretch({-3, 4, 5}, {3, 4, 5}) == 0);
  BOOST_TEST(least_stretch({3, 4, 5}, {3e80, 4e80, 5e80}) == 0); // no usable lengths
  BOOST_TEST(least_stretch({3, 4, 5}, {3, 4, std::numeric_limits<double>::quiet_NaN()}) == 0);
  // A flat one may become one with an area.
  BOOST_TEST(least_stretch({3, 4, 7}, {6, 8, 10}) > 0);
}

// Sides that all become longer by one amount shorten no segment. So a mollified metric has the bounds of the one
// before.
BOOST_AUTO_TEST_CASE(longer_sides_shorten_nothing)
{
  Random_numbers random(7);
  for(int i = 0; i < 2000; ++i) {
    const double a = 1 + random.below(1000), b = 1 + random.below(1000);
    const double c = std::abs(a - b) + (1 + random.below(1000)) * 1e-3 * 2 * (std::min)(a, b);
    const double added = std::ldexp(1., random.below(30) - 15);
    BOOST_TEST(FG::internal::least_stretch({a, b, c}, {a + added, b + added, c + added}) >= 1 - 1e-3);
  }
}

namespace {

using Vector_3 = std::array<double, 3>;

std::array<FI::Precise_halfedge, 3> precise_face(const std::array<Vector_3, 3>& p, std::size_t first)
{
  const auto point = [&](std::size_t i) {
    const Vector_3& q = p[(first + i) % 3];
    return CGAL::Simple_cartesian<double>::Point_3(q[0], q[1], q[2]);
  };
  return FI::Precise_face_traits().construct_face_3_object()(point(0), point(1), point(2));
}

bool are_close(const Double_double& a, const Double_double& b, double scale)
{
  return abs(exact(a) - exact(b)) <= Rational(0x1p-90 * scale);
}

} // namespace

// A part of a face in space, given by weights of its corners with different sums, is the face of its corners.
BOOST_AUTO_TEST_CASE(parts_of_faces_are_the_faces_of_their_corners)
{
  Random_numbers random(9);
  int used = 0;
  for(int round = 0; round < 150 * scale; ++round) {
    std::array<Vector_3, 3> face, weights, part = {};
    for(std::size_t i = 0; i < 3; ++i) {
      for(std::size_t k = 0; k < 3; ++k)
        face[i][k] = std::ldexp(random.below(41) - 20, 30 * (round % 3 - 1));
      const int sum = 8 << i, first = random.below(sum + 1), second = random.below(sum + 1 - first);
      weights[i] = {{1.0 * first, 1.0 * second, 1.0 * (sum - first - second)}};
    }
    const double area = weights[0][0] * (weights[1][1] * weights[2][2] - weights[1][2] * weights[2][1]) +
                        weights[0][1] * (weights[1][2] * weights[2][0] - weights[1][0] * weights[2][2]) +
                        weights[0][2] * (weights[1][0] * weights[2][1] - weights[1][1] * weights[2][0]);
    const FI::Exact_face exact_face = FI::exact_face_from_points(FI::to_integers(face));
    if(area == 0 || exact_face.doubled_area_squared == 0)
      continue;
    ++used;
    if(area < 0)
      std::swap(weights[1], weights[2]);
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t k = 0; k < 3; ++k)
        part[i][k] = (weights[i][0] * face[0][k] + weights[i][1] * face[1][k] + weights[i][2] * face[2][k]) /
                     (weights[i][0] + weights[i][1] + weights[i][2]);
    const FI::Exact_subface subface(exact_face, precise_face(face, 0)[0], weights);
    for(std::size_t i = 0; i < 3; ++i) {
      const std::array<FI::Precise_halfedge, 3> found = subface.precise_face(i), expected = precise_face(part, i);
      for(std::size_t k = 0; k < 3; ++k) {
        BOOST_TEST(are_close(found[k].length, expected[k].length, expected[k].length.high));
        BOOST_TEST(are_close(found[k].next.x, expected[k].next.x, 1));
        BOOST_TEST(are_close(found[k].next.y, expected[k].next.y, 1));
        BOOST_TEST(found[k].error < 0x1p-90);
      }
      const std::array<std::array<double, 2>, 3> sides = subface.vectors(i);
      const double size = expected[0].length.high + expected[1].length.high, close = 1e-15 * size;
      BOOST_TEST(std::abs(sides[0][0] - expected[0].length.high) <= close);
      BOOST_TEST(sides[0][1] == 0);
      BOOST_TEST(std::abs(sides[1][0] - expected[1].length.high * expected[0].next.x.high) <= close);
      BOOST_TEST(std::abs(sides[1][1] - expected[1].length.high * expected[0].next.y.high) <= close);
      BOOST_TEST(std::abs(sides[0][0] + sides[1][0] + sides[2][0]) <= 2 * close);
      BOOST_TEST(std::abs(sides[1][1] + sides[2][1]) <= 2 * close);
      const FI::Exact_face of_part = subface.exact_face(i);
      BOOST_TEST(std::abs(static_cast<double>(of_part.dot_next) / static_cast<double>(of_part.squared_length) -
                          sides[1][0] / sides[0][0]) <= 1e-12 * size / sides[0][0]);
    }
  }
  BOOST_TEST(used > 50);
}

BOOST_AUTO_TEST_CASE(parts_of_faces_below_the_range_of_lengths_have_no_bound)
{
  const std::array<Vector_3, 3> face = {{{{0, 0, 0}}, {{0x1p-190, 0, 0}}, {{0, 0x1p-190, 0}}}};
  for(const double share : {0x1p-5, 0x1p-20}) { // of both sides at corner 0
    const FI::Exact_subface part(FI::exact_face_from_points(FI::to_integers(face)), precise_face(face, 0)[0],
                                 {{{{1, 0, 0}}, {{1 - share, share, 0}}, {{1 - share, 0, share}}}});
    for(const FI::Precise_halfedge& side : part.precise_face(0))
      BOOST_TEST((side.error < 0x1p-90) == (share == 0x1p-5));
  }
}

BOOST_AUTO_TEST_CASE(faces_of_intervals_hold_vectors_with_their_errors)
{
  const std::array<std::array<double, 2>, 3> vectors = {{{{3, 0}}, {{-1, 2}}, {{-2, -2}}}};
  for(const double error : {0.0, 1e-10}) {
    const auto face =
        FG::Exact_intrinsic_triangulation_traits<CGAL::Interval_nt<>>().construct_face_2_object()(vectors, error);
    for(std::size_t i = 0; i < 3; ++i) {
      const double size = std::abs(vectors[i][0]) + std::abs(vectors[i][1]);
      for(const auto& [found, expected] : {std::make_pair(face[i].x, vectors[i][0]), {face[i].y, vectors[i][1]}}) {
        BOOST_TEST((found.inf() <= expected - error * size / 2 && found.sup() >= expected + error * size / 2));
        BOOST_TEST(found.sup() - found.inf() <= 3 * error * size);
      }
      BOOST_TEST((face[i].scale.inf() == 1 && face[i].scale.sup() == 1));
    }
  }
}
