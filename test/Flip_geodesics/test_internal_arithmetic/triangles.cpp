// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Triangles by their lengths, where rounding errors could take their shape away.

#include "test_internal_arithmetic/numbers.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Delaunay_refiner.h>

using namespace Flip_geodesics_test;

namespace {

// One face, h0 h2 h4 in a row, with edges whose other sides have lengths and vertices of their own.
struct Single_face
{
  std::array<double, 6> lengths = {};
  std::array<int, 6> tails = {0, 1, 1, 2, 2, 0};
  int after_last = 0;

  Single_face(double a, double b, double c)
    : lengths{a, a, b, b, c, c}
  {
  }

  static FG::Halfedge_index twin(FG::Halfedge_index h) { return FI::twin_index(h); }
  static FG::Edge_index edge(FG::Halfedge_index h) { return FG::Edge_index(h); }
  FG::Index holds(FG::Edge_index) const { return 0; }
  bool is_border(FG::Halfedge_index) const { return false; }
  FG::Halfedge_index next(FG::Halfedge_index h) const
  {
    return FG::Halfedge_index(h.idx() == 4 ? after_last : h.idx() + 2);
  }
  FG::Vertex_index tail(FG::Halfedge_index h) const
  {
    return FG::Vertex_index(tails[static_cast<std::size_t>(h.idx())]);
  }
  double length(FG::Halfedge_index h) const { return lengths[static_cast<std::size_t>(h.idx())]; }
};

bool is_near(double x, double expected) { return std::abs(x - expected) <= 1e-14 * std::abs(expected); }

} // namespace

// Two sides of length 1 and a short one, in all places.
BOOST_AUTO_TEST_CASE(needles_keep_their_shape)
{
  for(double thin : {1.0, 1e-3, 1e-8, 1e-12, 1e-100})
    for(int place = 0; place < 3; ++place) {
      std::array<double, 3> lengths = {1, 1, 1};
      lengths[static_cast<std::size_t>(place)] = thin;
      const FI::Plane_triangle triangle(lengths);
      const double height = std::sqrt(1 - thin * thin / 4);
      BOOST_TEST(is_near(triangle.area, thin * height / 2));
      BOOST_TEST(triangle.has_finite_cotangents());
      for(int end : {place, (place + 1) % 3}) {
        BOOST_TEST(is_near(triangle.cotangents[static_cast<std::size_t>(end)], thin / 2 / height));
        BOOST_TEST(is_near(triangle.angle(end), std::acos(thin / 2)));
      }
      BOOST_TEST(is_near(triangle.angle((place + 2) % 3), 2 * std::asin(thin / 2)));
      const FI::Face_shape<Single_face> shape(Single_face(lengths[0], lengths[1], lengths[2]), FG::Halfedge_index(0));
      for(int corner = 0; corner < 3; ++corner)
        BOOST_TEST(is_near(shape.angle(corner), triangle.angle(corner)));
      if(thin < 1) {
        BOOST_TEST(shape.smallest_corner() == (place + 2) % 3);
        BOOST_TEST(shape.shortest_side() == FG::Halfedge_index(2 * place));
      }
    }
}

BOOST_AUTO_TEST_CASE(sides_that_are_too_long_make_flat_triangles)
{
  for(double excess : {0x1p-52, 1e-3, 5.0})
    for(int place = 0; place < 3; ++place) {
      std::array<double, 3> lengths = {1, 1, 1};
      lengths[static_cast<std::size_t>(place)] = 2 * (1 + excess);
      const FI::Plane_triangle triangle(lengths);
      BOOST_TEST(triangle.area == 0);
      BOOST_TEST(!triangle.has_finite_cotangents());
      const FI::Face_shape<Single_face> shape(Single_face(lengths[0], lengths[1], lengths[2]), FG::Halfedge_index(0));
      for(int corner = 0; corner < 3; ++corner) {
        const double expected = corner == (place + 2) % 3 ? std::acos(-1.0) : 0;
        BOOST_TEST(triangle.angle(corner) == expected);
        BOOST_TEST(shape.angle(corner) == expected);
      }
    }
}

// The cotangent of one angle alone may be beyond double.
BOOST_AUTO_TEST_CASE(each_cotangent_is_asked_whether_it_is_finite)
{
  for(std::size_t corner = 0; corner < 3; ++corner)
    for(double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
      FI::Plane_triangle triangle({3, 4, 5});
      BOOST_TEST(triangle.has_finite_cotangents());
      triangle.cotangents[corner] = bad;
      BOOST_TEST(!triangle.has_finite_cotangents());
    }
}

BOOST_AUTO_TEST_CASE(faces_that_do_not_close_are_not_valid)
{
  const auto is_valid = [](const Single_face& face, bool is_twin_known, double tolerance = 1e-9) {
    return FI::is_valid_halfedge(face, FG::Halfedge_index(0), tolerance, is_twin_known);
  };
  const Single_face good(3, 4, 5);
  BOOST_TEST((is_valid(good, true) && is_valid(good, false)));
  Single_face open = good; // its links lead elsewhere
  open.after_last = 2;
  BOOST_TEST((!is_valid(open, true) && !is_valid(open, false)));
  Single_face apart = good; // the other side starts at another vertex, or has another length
  apart.tails[1] = 2;
  BOOST_TEST((!is_valid(apart, true) && is_valid(apart, false)));
  Single_face longer = good;
  longer.lengths[1] = 3.001;
  BOOST_TEST((!is_valid(longer, true) && is_valid(longer, false)));
  BOOST_TEST(is_valid(longer, true, 1e-3));
  BOOST_TEST(!is_valid(Single_face(9.1, 4, 5), true));
  BOOST_TEST(is_valid(Single_face(9 + 1e-12, 4, 5), true)); // as far as rounding goes
}
