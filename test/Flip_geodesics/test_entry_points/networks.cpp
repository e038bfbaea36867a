// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One network in a triangulation.

#include "test_entry_points/entry_points.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(a_second_network_is_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Setting s(mesh, vertex(0), vertex(40));
  {
    Network network(s.triangulation);
    BOOST_CHECK_THROW(Network{s.triangulation}, FG::Occupied_triangulation_error); // also while it is empty
    add_path(network, s);
    const auto before = network.halfedges(0_c);
    BOOST_CHECK_THROW(Network{s.triangulation}, FG::Occupied_triangulation_error);
    BOOST_TEST((network.halfedges(0_c) == before));
    BOOST_TEST(network.is_valid());
    BOOST_TEST(FG::shorten(network).is_complete());
  }
  s.triangulation.rollback();
  Network network(s.triangulation);
  add_path(network, s);
  BOOST_TEST(FG::shorten(network).is_complete());
}

// What makes networks of its own, or flips edges without a look at the labels.
BOOST_AUTO_TEST_CASE(what_disturbs_a_network_is_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Setting s(mesh, vertex(0), vertex(40));
  Triangulation& t = s.triangulation;
  Network network(t);
  add_path(network, s);
  FG::shorten(network);
  const auto before = network.halfedges(0_c);
  const auto position = t.log_position();
  FG::Geodesic_tree<Triangulation> tree(t);
  Triangulation other(mesh);
  BOOST_CHECK_THROW(tree.grow(3_v), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::refine(t), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::geodesics_through(t, s.locations()), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::complete_polyline(t, s.locations()), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::Free_geodesic_spline<Triangulation>(t, s.locations(), FG::Spline_kind::BEZIER),
                    FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(Triangulation{std::move(t)}, FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(other = std::move(t), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(t = std::move(other), FG::Occupied_triangulation_error);
  BOOST_TEST((network.halfedges(0_c) == before));
  BOOST_TEST(network.is_valid());
  BOOST_TEST(t.is_valid());
  BOOST_TEST(t.log_position() == position);

  network.clear(); // an empty network stands in the way of others, but of nothing else
  t.rollback();
  BOOST_CHECK_NO_THROW(FG::geodesics_through(t, s.locations()));
  BOOST_CHECK_THROW(Network{t}, FG::Occupied_triangulation_error);
  BOOST_CHECK_NO_THROW(tree.grow(3_v));
  network.add_curve(tree.path(40_v), false);
  BOOST_CHECK_THROW(FG::make_shortest(tree), FG::Occupied_triangulation_error);
}

BOOST_AUTO_TEST_CASE(a_point_on_an_edge_under_a_curve_is_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Triangulation t(mesh);
  Network network(t);
  const FG::Halfedge_index along = t.outgoing(16_v);
  const FG::Input_halfedge_index h = FG::internal::as_input(along);
  network.add_curve(Halfedge_sequence{along}, false);
  const auto position = t.log_position();
  BOOST_CHECK_THROW(t.insert({h, {{1, 1, 0}}}), FG::Occupied_triangulation_error);
  BOOST_TEST(t.log_position() == position);
  BOOST_TEST(network.is_valid());
  BOOST_TEST(t.is_valid());
  BOOST_CHECK_NO_THROW(t.insert({h, {{1, 1, 1}}}));
  BOOST_CHECK_NO_THROW(network.insert({h, {{1, 1, 0}}}));
  BOOST_TEST(network.halfedges(0_c).size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_network_can_outlive_its_triangulation)
{
  const Surface mesh = to_mesh<Surface>(octahedron(2));
  auto triangulation = std::make_unique<Triangulation>(mesh);
  Network network(*triangulation);
  network.add_curve(Halfedge_sequence{0_h}, false);
  triangulation.reset(); // nothing is written there any more
}
