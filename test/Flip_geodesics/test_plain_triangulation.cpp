// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Second models of IntrinsicTriangulation and EdgePathGraph, plain and slow, go through all that asks for the concepts,
// and give the same flips as Intrinsic_triangulation and Edge_path_network.

#define BOOST_TEST_MODULE plain_triangulation

#include "Curve_setting.h"
#include "Plain_network.h"
#include "Plain_triangulation.h"
#include "number_type_checks.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/Gmpq.h>

#include <boost/test/unit_test.hpp>

#include <functional>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Traits = Exact_traits<CGAL::Gmpq>;
using Plain = Plain_triangulation<Traits>;
using Fast = FG::Intrinsic_triangulation<Surface, Traits>;

// The edges that were flipped, in order.
struct Flip_list : FG::Default_shortening_visitor
{
  std::vector<FG::Halfedge_index> flips;

  template <class Triangulation>
  void on_flip(const Triangulation&, FG::Halfedge_index h)
  {
    flips.push_back(h);
  }
};

template <class Triangulation>
struct World
{
  explicit World(const Surface& mesh)
    : triangulation(mesh)
    , network(triangulation)
  {
  }

  FG::Shortening_report pull()
  {
    FG::Shortener<FG::Edge_path_network<Triangulation>> shortener(network);
    shortener.run(FG::Iteration_stop_predicate(3), flips);
    shortener.run(FG::Never_stop_predicate(), flips);
    return shortener.report();
  }

  Triangulation triangulation;
  FG::Edge_path_network<Triangulation> network;
  Flip_list flips;
};

bool has_same_faces(const Plain& plain, const Fast& fast)
{
  for(FG::Halfedge_index h : FG::internal::descriptors<FG::Halfedge_index>(fast.number_of_halfedges())) {
    if(plain.tail(h) != fast.tail(h) || plain.is_border(h) != fast.is_border(h) || plain.length(h) != fast.length(h))
      return false;
    if(!fast.is_border(h) && plain.next(h) != fast.next(h))
      return false;
  }
  return true;
}

const std::vector<Mesh_soup>& soups()
{
  static const std::vector<Mesh_soup> result = {tieless_plane(6, 1), jittered_cube(3, 2), genus_3_plate(1),
                                                grid_with_hole(6, 6, 2, 4, 2, 4), cube(3)};
  return result;
}

} // namespace

// Random walks, some beside each other on the same edges; open and closed, pulled in two runs, and taken back.
BOOST_AUTO_TEST_CASE(the_same_flips_come_out)
{
  std::size_t flips = 0, curves = 0;
  for(const Mesh_soup& soup : soups()) {
    const Surface mesh = to_mesh<Surface>(soup);
    World<Plain> plain(mesh);
    World<Fast> fast(mesh);
    Random_numbers random(1);
    for(int i = 0; i < 90; ++i) {
      const bool is_closed = i % 2 == 1;
      for(int c = 0; c <= i % 3; ++c) {
        const Halfedge_sequence walk = random_walk(fast.triangulation, 14, is_closed, random);
        if(walk.empty())
          continue;
        plain.network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
        fast.network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
      }
      BOOST_TEST(plain.network.is_valid() == fast.network.is_valid());
      if(fast.network.is_valid()) {
        const FG::Shortening_report a = plain.pull(), b = fast.pull();
        BOOST_TEST((plain.flips.flips == fast.flips.flips));
        BOOST_TEST(a.flips == b.flips);
        BOOST_TEST(a.is_complete());
        BOOST_TEST(has_same_faces(plain.triangulation, fast.triangulation));
        for(FG::Curve_index c : FG::internal::descriptors<FG::Curve_index>(fast.network.number_of_curves())) {
          BOOST_TEST((a.curves[c.idx()].status == b.curves[c.idx()].status));
          BOOST_TEST(a.curves[c.idx()].length == b.curves[c.idx()].length);
          BOOST_TEST((plain.network.halfedges(c) == fast.network.halfedges(c)));
          ++curves;
        }
        BOOST_TEST(plain.network.is_valid());
        flips += b.flips;
      }
      plain.network.clear();
      fast.network.clear();
      plain.triangulation.rollback(0);
      fast.triangulation.rollback(0);
      plain.flips.flips.clear();
      fast.flips.flips.clear();
    }
    BOOST_TEST(has_same_faces(plain.triangulation, fast.triangulation)); // everything was taken back
  }
  BOOST_TEST(curves > 100u);
  BOOST_TEST(flips > 500u);
}

BOOST_AUTO_TEST_CASE(overlapping_curves_are_ordered_alike)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::ALTERNATING));
  World<Plain> plain(mesh);
  World<Fast> fast(mesh);
  for(const Vertex_sequence& path : overlapping_paths(6, 3)) {
    plain.network.add_curve(FG::halfedges_through(plain.triangulation, path));
    fast.network.add_curve(FG::halfedges_through(fast.triangulation, path));
  }
  FG::order_overlapping_curves(plain.network);
  FG::order_overlapping_curves(fast.network);
  for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(fast.triangulation.number_of_edges()))
    BOOST_TEST((plain.network.bundle(e) == fast.network.bundle(e)));
  plain.pull();
  fast.pull();
  BOOST_TEST((plain.flips.flips == fast.flips.flips));
  BOOST_TEST(plain.flips.flips.size() > 5u);
}

BOOST_AUTO_TEST_CASE(the_same_edges_are_delaunay)
{
  for(const Mesh_soup& soup : soups()) {
    const Surface mesh = to_mesh<Surface>(soup);
    World<Plain> plain(mesh);
    World<Fast> fast(mesh);
    const Halfedge_sequence walk = {FG::Halfedge_index(4)};
    plain.network.add_curve(walk);
    fast.network.add_curve(walk);
    BOOST_TEST((FG::edges_near_curves(plain.network) == FG::edges_near_curves(fast.network)));
    FG::flip_to_delaunay(plain.triangulation, CGAL::parameters::number_of_iterations(100000),
                         CGAL::parameters::visitor(std::ref(plain.flips)));
    FG::flip_to_delaunay(fast.triangulation, CGAL::parameters::number_of_iterations(100000),
                         CGAL::parameters::visitor(std::ref(fast.flips)));
    BOOST_TEST((plain.flips.flips == fast.flips.flips));
    BOOST_TEST(FG::is_delaunay(plain.triangulation));
  }
}

BOOST_AUTO_TEST_CASE(several_networks_hold_edges)
{
  const Surface mesh = to_mesh<Surface>(cube(1));
  Plain plain(mesh);
  FG::Edge_path_network<Plain> one(plain), other(plain);
  const std::vector<FG::Halfedge_index> edge = {0_h};
  one.add_curve(edge);
  other.add_curve(edge);
  BOOST_TEST(plain.holds(0_e) == 2);
  one.clear();
  BOOST_TEST(plain.holds(0_e) == 1);
  BOOST_TEST(!plain.is_flippable(0_h));
  BOOST_TEST(other.is_occupied(0_h));
  BOOST_TEST(!one.is_occupied(0_h));
}

// Random walks that share edges and cross none; the second network is in the second triangulation.
BOOST_AUTO_TEST_CASE(a_plain_network_makes_the_same_flips)
{
  std::size_t flips = 0, loops = 0;
  const std::vector<std::pair<Mesh_soup, bool>> inputs = {
      {tieless_plane(6, 1), false}, {grid_with_hole(6, 6, 2, 4, 2, 4), true}, {cube(3), true}};
  for(const auto& [soup, has_ties] : inputs) {
    const Surface mesh = to_mesh<Surface>(soup);
    World<Fast> fast(mesh);
    Plain triangulation(mesh);
    Random_numbers random(3);
    for(int i = 0; i < 150; ++i) {
      for(int c = 0; c <= i % 3; ++c) {
        const bool is_closed = i % 2 == 1;
        const Halfedge_sequence walk = random_walk(fast.triangulation, 12, is_closed, random);
        if(!walk.empty())
          fast.network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
      }
      if(fast.network.is_valid()) {
        Plain_network<Plain> plain(triangulation, fast.network);
        Flip_list list;
        const FG::Shortening_report report = FG::shorten(plain, CGAL::parameters::visitor(std::ref(list)));
        const FG::Shortening_report expected =
            FG::shorten(fast.network, CGAL::parameters::visitor(std::ref(fast.flips)));
        if(!has_ties)
          BOOST_TEST((list.flips == fast.flips.flips));
        for(std::size_t c = 0; c < expected.curves.size(); ++c) {
          BOOST_TEST((report.curves[c].status == expected.curves[c].status));
          if(!has_ties)
            BOOST_TEST(report.curves[c].length == expected.curves[c].length);
          loops += plain.is_closed(FG::Curve_index(static_cast<int>(c))) ? 1 : 0;
        }
        flips += list.flips.size();
        triangulation.rollback(0);
      }
      fast.flips.flips.clear();
      fast.network.clear();
      fast.triangulation.rollback();
    }
  }
  BOOST_TEST(flips > 500u);
  BOOST_TEST(loops > 10u);
}
