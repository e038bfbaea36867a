// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What certified traits prove of each kind of result, by exact rational arithmetic in the plane, where points miss the
// corners of squares by some units in the last place: a row of a table in the manual for each case.

#define BOOST_TEST_MODULE what_is_proven

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/refine.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

using namespace Flip_geodesics_test;

namespace {

namespace FG = CGAL::Flip_geodesics;
using Triangulation =
    FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>;
using Setting = Basic_curve_setting<Triangulation>;
using Rational = boost::multiprecision::cpp_rational;
using Place = std::array<Rational, 2>;

// Squares of side 1, whose corners are moved by up to seven times 2^-48.
Mesh_soup nearly_squares(int n, unsigned seed)
{
  Random_numbers random(seed);
  return mapped(flat_grid(n, n, Diagonal_rule::RANDOM), [&](const Coordinates& p) {
    const auto moved = [&](double x) { return x + 0x1p-48 * (random.below(15) - 7); };
    return Coordinates{moved(p[0]), moved(p[1]), 0};
  });
}

int sign(const Rational& r) { return r.sign(); }

Rational cross(const Place& p, const Place& q, const Place& r)
{
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

// Positive if s lies inside the circle through p, q and r.
int side_of_circle(const Place& p, const Place& q, const Place& r, const Place& s)
{
  const auto square = [&](const Place& t) {
    const Rational x = t[0] - s[0], y = t[1] - s[1];
    return Rational(x * x + y * y);
  };
  return sign(square(p) * cross(s, q, r) + square(q) * cross(s, r, p) + square(r) * cross(s, p, q));
}

class Plane
{
public:
  Plane(const Triangulation& triangulation, const Surface& mesh)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
  {
  }

  // A vertex of the input, or an inserted one, by its weights.
  Place operator()(FG::Vertex_index v) const
  {
    if(v.idx() < m_triangulation.input().number_of_vertices())
      return of_input(v);
    const FG::Surface_location at = m_triangulation.location(v);
    Place result = {0, 0};
    Rational sum = 0;
    FG::Input_halfedge_index h = at.halfedge;
    for(double weight : at.weights) {
      const Place corner = of_input(m_triangulation.input().tail(h));
      for(int i = 0; i < 2; ++i)
        result[i] += Rational(weight) * corner[i];
      sum += Rational(weight);
      h = m_triangulation.input().next(h);
    }
    return {result[0] / sum, result[1] / sum};
  }

  // The signs of twice the area of each face, and for each edge of four times how far its circles are empty.
  template <class Visit>
  void for_each_face(const Visit& visit) const
  {
    std::vector<FG::Intrinsic_face> faces;
    FG::intrinsic_faces(m_triangulation, std::back_inserter(faces));
    for(const FG::Intrinsic_face& face : faces)
      visit(sign(cross((*this)(face.vertices[0]), (*this)(face.vertices[1]), (*this)(face.vertices[2]))));
  }

  template <class Visit>
  void for_each_inner_edge(const Visit& visit) const
  {
    for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(m_triangulation.number_of_edges())) {
      const FG::Halfedge_index h = FG::internal::first_side(e), t = Triangulation::twin(h);
      if(!m_triangulation.is_border(h) && !m_triangulation.is_border(t))
        visit(e, side_of_circle((*this)(m_triangulation.tail(h)), (*this)(m_triangulation.head(h)), opposite(h),
                                opposite(t)));
    }
  }

  // Does the line between the ends of a word pass between those of each crossed edge?
  bool is_line(const FG::Edge_sequence& word) const
  {
    const Place tail = (*this)(word.tail), head = (*this)(word.head);
    for(const FG::Input_halfedge_index h : word.crossed)
      if(sign(cross(tail, head, of_input(m_triangulation.input().tail(h)))) > 0 ||
         sign(cross(tail, head, of_input(m_triangulation.input().tail(FG::internal::twin_index(h))))) < 0)
        return false;
    return true;
  }

private:
  Place of_input(FG::Vertex_index v) const
  {
    const auto& p = m_mesh.point(Surface::Vertex_index(static_cast<unsigned>(v.idx())));
    return {Rational(p.x()), Rational(p.y())};
  }

  Place opposite(FG::Halfedge_index h) const { return (*this)(m_triangulation.tail(m_triangulation.previous(h))); }

  const Triangulation& m_triangulation;
  const Surface& m_mesh;
};

// All curves of the network have a certificate, and their segments are lines of the plane.
void check_curves(const Setting& s)
{
  const Plane plane(s.triangulation, s.mesh);
  const FG::Network_certificate certificate = FG::certify(s.network);
  for(const FG::Curve_certificate& curve : certificate.curves)
    BOOST_TEST((curve.verdict() == FG::Verdict::PROVEN));
  for(FG::Curve_index c : FG::internal::descriptors<FG::Curve_index>(s.network.number_of_curves()))
    for(FG::Halfedge_index h : s.network.halfedges(c))
      BOOST_TEST(plane.is_line(s.triangulation.edge_sequence(h)));
}

void check_delaunay(const Setting& s)
{
  Plane(s.triangulation, s.mesh).for_each_inner_edge([&](FG::Edge_index e, int side) {
    BOOST_TEST((side <= 0 || s.triangulation.holds(e) != 0));
    BOOST_TEST((side <= 0) == s.triangulation.is_locally_delaunay(FG::internal::first_side(e)));
  });
}

FG::Surface_location random_location(const Triangulation& triangulation, Random_numbers& random)
{
  FG::Input_halfedge_index h;
  do
    h = FG::Input_halfedge_index(random.below(triangulation.input().number_of_halfedges()));
  while(triangulation.input().is_border(h));
  return {h, {{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)}}};
}

} // namespace

BOOST_AUTO_TEST_CASE(curves_that_were_pulled_tight)
{
  Setting s(nearly_squares(9, 1));
  Random_numbers random(1);
  for(int i = 0; i < 40; ++i) {
    const int from = random.below(99);
    s.add_path(FG::Vertex_index(from), FG::Vertex_index(from + 1 + random.below(99 - from)));
    BOOST_TEST(s.pull().is_complete());
    check_curves(s);
    s.network.clear();
    s.triangulation.rollback();
  }
}

BOOST_AUTO_TEST_CASE(paths_of_a_tree)
{
  for(const Mesh_soup& soup : {nearly_squares(9, 2), flat_grid(9, 9, Diagonal_rule::RANDOM)}) {
    Setting s(soup);
    FG::Geodesic_tree<Triangulation> tree(s.triangulation);
    BOOST_TEST((tree.grow(44_v).status == FG::Shortening_status::LOCALLY_SHORTEST));
    for(FG::Vertex_index v : FG::internal::descriptors<FG::Vertex_index>(100))
      if(v != 44_v) {
        s.network.add_curve(tree.path(v));
        check_curves(s);
        s.network.clear();
      }
  }
}

BOOST_AUTO_TEST_CASE(delaunay_triangulations)
{
  int flips = 0, ties = 0;
  for(const Mesh_soup& soup : {nearly_squares(9, 3), nearly_squares(9, 4), flat_grid(9, 9, Diagonal_rule::RANDOM)}) {
    Setting s(soup);
    s.add_path(0_v, 47_v);
    s.pull();
    const FG::Delaunay_report report = FG::flip_to_delaunay(s.triangulation);
    BOOST_TEST(report.is_complete());
    check_delaunay(s);
    flips += static_cast<int>(report.flips);
    Plane(s.triangulation, s.mesh).for_each_inner_edge([&](FG::Edge_index, int side) { ties += side == 0 ? 1 : 0; });
  }
  BOOST_TEST(flips > 60);
  BOOST_TEST(ties > 0);
}

BOOST_AUTO_TEST_CASE(refined_triangulations)
{
  Setting s(nearly_squares(5, 6));
  s.add_path(0_v, 34_v);
  s.pull();
  FG::Refinement_options options;
  options.longest_edge = 0.7;
  const FG::Refinement_report report = FG::refine(s.network, options);
  BOOST_TEST(report.is_complete());
  BOOST_TEST(report.insertions + report.splits > 20u);
  check_delaunay(s);
}

// Points on edges of the triangulation or next to them, by a unit in the last place of a weight.
BOOST_AUTO_TEST_CASE(inserted_points)
{
  int on_edges = 0, in_faces = 0;
  for(double more : {-0x1p-52, 0.0, 0x1p-52}) {
    Setting s(flat_grid(4, 4, Diagonal_rule::RISING));
    const Plane plane(s.triangulation, s.mesh);
    // The other diagonal of each square, and its middle, which is that of a rising one of the input.
    for(int j = 0; j < 4; ++j)
      for(int i = 0; i < 4; ++i) {
        const FG::Halfedge_index h = FG::internal::halfedge_between(s.triangulation, FG::Vertex_index(i + 5 * j),
                                                                    FG::Vertex_index(i + 5 * j + 6));
        const FG::Input_halfedge_index rising = FG::internal::as_input(h);
        s.triangulation.flip(h);
        const FG::Vertex_index v = s.triangulation.insert({rising, {{1 + more, 1, 0}}});
        BOOST_TEST((plane(v)[0] + plane(v)[1] < i + j + 1) == (more > 0));
        ++(outgoing_halfedges_at_tail(s.triangulation, s.triangulation.outgoing(v)).size() == 4 ? on_edges : in_faces);
      }
    plane.for_each_face([](int sign) { BOOST_TEST(sign > 0); });
  }
  BOOST_TEST(on_edges == 16);
  BOOST_TEST(in_faces == 32);

  Setting s(nearly_squares(5, 7));
  Random_numbers random(7);
  for(int i = 0; i < 60; ++i) {
    FG::Surface_location at = random_location(s.triangulation, random);
    at.weights[1] = at.weights[0];
    at.weights[2] = i % 2 == 0 ? 0x1p-52 : at.weights[2];
    s.triangulation.insert(at);
    FG::flip_to_delaunay(s.triangulation);
  }
  Plane(s.triangulation, s.mesh).for_each_face([](int sign) { BOOST_TEST(sign > 0); });
  check_delaunay(s);
}

BOOST_AUTO_TEST_CASE(drawn_polylines_and_splines)
{
  Random_numbers random(8);
  Setting s(nearly_squares(7, 8));
  for(int i = 0; i < 5; ++i) {
    std::vector<FG::Surface_location> points;
    for(FG::Vertex_index v : {9_v, 12_v, 36_v, 53_v}) // in a row, so that nothing crosses itself
      points.push_back(s.triangulation.location(v));
    FG::Geodesic_spline<Triangulation> spline(s.triangulation, points, FG::Spline_kind::BEZIER);
    for(int round = 0; round < 3; ++round)
      spline.refine();
    FG::add_curve_along(s.network, spline.finish());
    FG::order_overlapping_curves(s.network);
    FG::shorten(s.network);
    check_curves(s);
    s.network.clear();
    s.triangulation.rollback();

    const FG::Surface_location from = random_location(s.triangulation, random);
    const FG::Input_halfedge_index h = s.triangulation.input().next(from.halfedge), t = FG::internal::twin_index(h);
    const FG::Surface_location on_edge = {h, {{random.uniform(0.1, 1), 1, 0}}};
    std::vector<FG::Surface_location> polyline = {from, on_edge};
    if(!s.triangulation.input().is_border(t))
      polyline.push_back({t, {{random.uniform(0.1, 1), 1, 1}}});
    const FG::Curve_index drawn = FG::draw_polyline(s.network, polyline);
    BOOST_TEST(FG::shorten(s.network).is_complete());
    check_curves(s);
    s.network.free_nodes(drawn);
    BOOST_TEST(FG::shorten(s.network).is_complete());
    check_curves(s);
    s.network.clear();
    s.triangulation.rollback();
  }
}
