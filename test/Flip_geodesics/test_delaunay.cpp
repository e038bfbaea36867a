// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Intrinsic Delaunay and constrained Delaunay triangulations: in the plane against CGAL's own, elsewhere by properties.

#include "Curve_setting.h"
#include "descriptors.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/delaunay.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#define BOOST_TEST_MODULE delaunay
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Certified_traits = FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;
using Certified_setting = Basic_curve_setting<FG::Intrinsic_triangulation<Surface, Certified_traits>>;
using Edge_set = std::set<std::pair<int, int>>;

using Kernel_2 = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel_2>;
using Structure =
    CGAL::Triangulation_data_structure_2<Vertex_base, CGAL::Constrained_triangulation_face_base_2<Kernel_2>>;
using Planar_cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel_2, Structure>;

// The constrained Delaunay triangulation of the mesh's points with its border and the given segments.
Edge_set planar_cdt(const Surface& mesh, const Edge_set& segments)
{
  Planar_cdt cdt;
  std::vector<Planar_cdt::Vertex_handle> handles;
  for(auto v : mesh.vertices()) {
    handles.push_back(cdt.insert({mesh.point(v).x(), mesh.point(v).y()}));
    handles.back()->info() = static_cast<int>(v);
  }
  for(const auto& [a, b] : segments)
    cdt.insert_constraint(handles[a], handles[b]);
  for(auto e : mesh.edges())
    if(mesh.is_border(e))
      cdt.insert_constraint(handles[mesh.vertex(e, 0)], handles[mesh.vertex(e, 1)]);
  Edge_set result;
  for(const auto& e : cdt.finite_edges()) {
    const int a = e.first->vertex(Planar_cdt::cw(e.second))->info();
    const int b = e.first->vertex(Planar_cdt::ccw(e.second))->info();
    result.insert(std::minmax(a, b));
  }
  return result;
}

template <class Setting>
Edge_set edges_of(const Setting& s, bool only_curves)
{
  Edge_set result;
  for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(s.triangulation.number_of_edges())) {
    const FG::Halfedge_index h = FG::internal::first_side(e);
    if(!only_curves || s.network.is_occupied(h))
      result.insert(std::minmax(s.triangulation.tail(h).idx(), s.triangulation.head(h).idx()));
  }
  return result;
}

// Geodesics to random vertices from one, which do not cross, in the plane.
template <class Setting>
void add_star(Setting& s, int curves, Random_numbers& random)
{
  const int n = static_cast<int>(s.mesh.number_of_vertices());
  const FG::Vertex_index source(random.below(n));
  for(int i = 0; i < curves; ++i) {
    const FG::Vertex_index target(random.below(n));
    if(target == source)
      continue;
    s.add_path(source, target);
    try {
      FG::order_overlapping_curves(s.network);
    } catch(const FG::Crossing_curves_error&) { // past the end of another one
      s.network.clear();
    }
  }
}

template <class Setting>
void check_planar(const Mesh_soup& soup, Random_numbers& random, int& curves)
{
  Setting s(soup);
  add_star(s, 5, random);
  curves += s.network.number_of_curves();
  s.pull();
  const Edge_set segments = edges_of(s, true);
  const FG::Delaunay_report report = FG::flip_to_delaunay(s.triangulation);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK(FG::is_delaunay(s.triangulation));
  BOOST_CHECK(s.network.is_valid());
  BOOST_CHECK(edges_of(s, true) == segments);
  BOOST_CHECK(edges_of(s, false) == planar_cdt(s.mesh, segments));
}

} // namespace

BOOST_AUTO_TEST_CASE(planar_straight_line_graphs_as_by_the_2d_package)
{
  Random_numbers random(5);
  int curves = 0;
  for(unsigned seed = 1; seed <= 10; ++seed) {
    check_planar<Curve_setting>(jittered_grid(9, 7, Diagonal_rule::RANDOM, 0.2, seed), random, curves);
    check_planar<Certified_setting>(jittered_grid(9, 7, Diagonal_rule::RANDOM, 0.2, seed), random, curves);
  }
  BOOST_CHECK_GT(curves, 40);
}

BOOST_AUTO_TEST_CASE(ties_are_delaunay_both_ways)
{
  Random_numbers random(7);
  for(const Mesh_soup& soup : {flat_grid(8, 8, Diagonal_rule::RANDOM), cube(4), genus_3_plate(2)}) {
    Certified_setting s(soup);
    BOOST_CHECK(FG::is_delaunay(s.triangulation));
    BOOST_CHECK_EQUAL(FG::flip_to_delaunay(s.triangulation).flips, 0u);
    BOOST_CHECK_GT(flip_at_random(s.triangulation, 500, random), 100);
    BOOST_CHECK(FG::flip_to_delaunay(s.triangulation).is_complete());
    BOOST_CHECK(FG::is_delaunay(s.triangulation));
  }
}

BOOST_AUTO_TEST_CASE(ties_are_ties_in_all_units)
{
  // Two triangles with one circumcircle, on either side of a chord of it.
  const Coordinates a = {16, -63, 0}, b = {16, 63, 0};
  for(int exponent = -230; exponent <= 220; exponent += exponent < -100 || exponent > 100 ? 5 : 29)
    for(double right : {25., 33., 39., 52., 56., 60., 63., 65.})
      for(double left : {-16., -25., -33., -39., -52., -56., -60., -63.}) {
        const Coordinates c = {right, std::sqrt(65 * 65 - right * right), 0};
        const Coordinates d = {left, -std::sqrt(65 * 65 - left * left), 0};
        const Certified_setting s(scaled({{a, b, c, d}, {{{1, 0, 2}}, {{0, 1, 3}}}}, std::ldexp(1, exponent)));
        BOOST_CHECK_MESSAGE(FG::is_delaunay(s.triangulation),
                            "points at " << right << " and " << left << ", in units of 2^" << exponent);
      }
}

BOOST_AUTO_TEST_CASE(from_any_triangulation_to_one)
{
  // Without ties the Delaunay triangulation is unique, whatever the flips before; the double and the exact traits
  // agree.
  Random_numbers random(9);
  for(const Mesh_soup& soup :
      {shaken(torus(10, 6, 3, 1), 0.05, 3), bumpy_sphere(6, 0.2, 4), shaken(cone_disk(9, 4, 3), 0.05, 6)})
  {
    Edge_set expected;
    for(int attempts : {0, 30, 300}) {
      Curve_setting s(soup);
      Certified_setting exact(soup);
      flip_at_random(s.triangulation, attempts, random);
      flip_at_random(exact.triangulation, attempts, random);
      BOOST_CHECK(FG::flip_to_delaunay(s.triangulation).is_complete());
      BOOST_CHECK(FG::flip_to_delaunay(exact.triangulation).is_complete());
      if(attempts == 0)
        expected = edges_of(s, false);
      BOOST_CHECK(edges_of(s, false) == expected);
      BOOST_CHECK(edges_of(exact, false) == expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(needles_end)
{
  for(const double aspect : {1e2, 1e6}) {
    Curve_setting s(needle_strip(12, 12, aspect));
    const FG::Delaunay_report report = FG::flip_to_delaunay(s.triangulation);
    BOOST_CHECK(report.is_complete());
    BOOST_CHECK(FG::is_delaunay(s.triangulation));
  }
  // A long thin cylinder, flipped at random: edges wind round it many times.
  const int n = 5, m = 3;
  Curve_setting s(cylinder(n, m, 1e-2, 10));
  Random_numbers random(2);
  flip_at_random(s.triangulation, 2000, random);
  const FG::Delaunay_report report = FG::flip_to_delaunay(s.triangulation);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK_LE(FG::flip_to_delaunay(s.triangulation).flips, 0u);
}

BOOST_AUTO_TEST_CASE(a_limit_is_kept_and_told)
{
  Random_numbers random(3);
  Curve_setting s(shaken(torus(10, 6, 3, 1), 0.05, 3));
  flip_at_random(s.triangulation, 300, random);
  const std::vector<FG::Edge_index> edges = {0_e, 1_e, 2_e, 3_e, 4_e, 5_e, 6_e, 7_e, 8_e, 9_e, 10_e};
  const FG::Delaunay_report report =
      FG::flip_to_delaunay(s.triangulation, edges, CGAL::parameters::number_of_iterations(1));
  BOOST_CHECK_EQUAL(report.flips, 1u);
  BOOST_CHECK(!report.is_complete());
  BOOST_CHECK(!FG::is_delaunay(s.triangulation));
}

// Says no when it was asked so many times.
struct Impatient_visitor : FG::Default_shortening_visitor
{
  explicit Impatient_visitor(int patience_)
    : patience(patience_)
  {
  }

  template <class Triangulation>
  void on_flip(const Triangulation&, FG::Halfedge_index)
  {
    ++flips;
  }
  bool go_further() { return patience-- > 0; }

  int patience;
  std::size_t flips = 0;
};

BOOST_AUTO_TEST_CASE(a_visitor_interrupts)
{
  Random_numbers random(3);
  Curve_setting s(shaken(torus(10, 6, 3, 1), 0.05, 3));
  flip_at_random(s.triangulation, 300, random);
  Impatient_visitor impatient(100), patient(1000000);
  const FG::Delaunay_report first = FG::flip_to_delaunay(
      s.triangulation, CGAL::parameters::number_of_iterations(1000000), CGAL::parameters::visitor(std::ref(impatient)));
  BOOST_CHECK(first.is_stopped);
  BOOST_CHECK(!first.is_complete());
  BOOST_CHECK_EQUAL(impatient.patience, -1);
  BOOST_CHECK_GT(first.flips, 0u);
  BOOST_CHECK_EQUAL(first.flips, impatient.flips);
  const FG::Delaunay_report second = FG::flip_to_delaunay(
      s.triangulation, CGAL::parameters::number_of_iterations(1000000), CGAL::parameters::visitor(std::ref(patient)));
  BOOST_CHECK(!second.is_stopped);
  BOOST_CHECK(second.is_complete());
  BOOST_CHECK_EQUAL(second.flips, patient.flips);
}

BOOST_AUTO_TEST_CASE(near_curves_only)
{
  Curve_setting s(bumpy_sphere(16, 0.1, 7));
  s.add_path(0_v, FG::Vertex_index(static_cast<int>(s.mesh.number_of_vertices()) / 2));
  s.pull();
  const std::vector<FG::Edge_index> near = FG::edges_near_curves(s.network);
  BOOST_CHECK(std::is_sorted(near.begin(), near.end()));
  const std::size_t before = s.triangulation.log_position();
  const FG::Delaunay_report report = FG::flip_to_delaunay(s.triangulation, near);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK_EQUAL(s.triangulation.log_position() - before, report.flips);
  for(std::size_t i = before; i < s.triangulation.log_position(); ++i)
    BOOST_CHECK(std::binary_search(near.begin(), near.end(), FG::Edge_index(s.triangulation.flip_record(i).h)));
  for(FG::Edge_index e : near) {
    const FG::Halfedge_index h = FG::internal::first_side(e);
    BOOST_CHECK(s.network.is_occupied(h) || s.triangulation.is_locally_delaunay(h));
  }
  BOOST_CHECK_LT(near.size(), static_cast<std::size_t>(s.triangulation.number_of_edges()) / 4);
  BOOST_CHECK_GT(FG::edges_near_curves(s.network, 2).size(), near.size());
}

// Of the faces that touch what is reached, ring by ring, on the border as well.
BOOST_AUTO_TEST_CASE(rings_about_curves)
{
  for(const Mesh_soup& soup : {bumpy_sphere(16, 0.1, 7), jittered_grid(9, 9, Diagonal_rule::RISING, 0.2, 3),
                               jittered_grid(9, 9, Diagonal_rule::FALLING, 0.2, 4)})
  {
    Curve_setting s(soup);
    const auto& t = s.triangulation;
    s.add_path(0_v, 9_v); // along the border of a grid
    s.pull();
    std::set<FG::Vertex_index> reached;
    for(FG::Halfedge_index h : s.network.halfedges(FG::Curve_index(0)))
      reached.insert({t.tail(h), t.head(h)});
    for(int rings = 0; rings < 5; ++rings) {
      std::set<FG::Edge_index> edges;
      const std::set<FG::Vertex_index> front = reached;
      for(FG::Halfedge_index h : FG::internal::descriptors<FG::Halfedge_index>(t.number_of_halfedges()))
        if(rings > 0 && front.count(t.tail(h)) == 1 && !t.is_border(h))
          for(FG::Halfedge_index side : {h, t.next(h), t.previous(h)}) {
            edges.insert(FG::Edge_index(side));
            reached.insert(t.tail(side));
          }
      const std::vector<FG::Edge_index> found = FG::edges_near_curves(s.network, rings);
      BOOST_CHECK(std::equal(found.begin(), found.end(), edges.begin(), edges.end()));
    }
  }
}
