// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Networks in a triangulation.

#include "test_entry_points/entry_points.h"

using namespace Flip_geodesics_test;

namespace {

template <class T>
constexpr bool moves_without_exceptions =
    std::is_nothrow_move_constructible_v<T>&& std::is_nothrow_move_assignable_v<T>;

static_assert(moves_without_exceptions<Triangulation> && moves_without_exceptions<Network>);
static_assert(std::is_nothrow_constructible_v<Network, Network&&, Triangulation&>);

// What holds between a triangulation and all networks that have curves there.
void check_holds(const Triangulation& t, const std::vector<const Network*>& networks)
{
  std::size_t all = 0;
  for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(t.number_of_edges())) {
    const auto holders = std::count_if(networks.begin(), networks.end(), [e](const Network* network) {
      return network->is_occupied(FG::internal::first_side(e));
    });
    BOOST_REQUIRE(t.holds(e) == holders);
    all += static_cast<std::size_t>(holders);
  }
  BOOST_TEST(t.number_of_holds() == all);
  for(const Network* network : networks)
    BOOST_TEST(network->is_valid());
}

Halfedge_sequence edge_path(const Triangulation& t, const std::vector<FG::Vertex_index>& vertices)
{
  FG::Shortest_edge_path<Triangulation> search(t);
  return FG::shortest_halfedges_through(search, vertices);
}

// Along the vertices (i, 0), ..., (i, n) of a grid.
Halfedge_sequence column(const Triangulation& t, int i, int n)
{
  std::vector<FG::Vertex_index> path;
  for(int j = 0; j <= n; ++j)
    path.push_back(FG::Vertex_index(j * (n + 1) + i));
  return edge_path(t, path);
}

} // namespace

BOOST_AUTO_TEST_CASE(networks_one_after_the_other)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Setting s(mesh, vertex(0), vertex(40));
  Halfedge_sequence first;
  for(int i = 0; i < 2; ++i) {
    Network network(s.triangulation);
    add_path(network, s);
    BOOST_TEST(FG::shorten(network).is_complete());
    check_holds(s.triangulation, {&network});
    if(i == 0)
      first = network.halfedges(0_c);
    BOOST_TEST((network.halfedges(0_c) == first));
    network.clear();
    check_holds(s.triangulation, {&network});
    s.triangulation.rollback();
  }
  BOOST_TEST(s.triangulation.number_of_holds() == 0u);
}

// Networks that take turns shorten their curves until none can go on because of the others.
BOOST_AUTO_TEST_CASE(networks_side_by_side)
{
  constexpr int most_rounds = 50;
  const Surface mesh = to_mesh<Surface>(bumpy_sphere(8, 0.2, 1));
  Triangulation t(mesh);
  FG::Shortest_edge_path<Triangulation> search(t);
  const FG::Index n = t.number_of_vertices();
  std::vector<Network> networks;
  for(int i = 0; i < 6; ++i)
    networks.emplace_back(t).add_curve(search(FG::Vertex_index((31 * i + 1) % n), FG::Vertex_index((57 * i + 40) % n)));
  std::vector<const Network*> all;
  for(const Network& network : networks)
    all.push_back(&network);
  check_holds(t, all);
  std::size_t flips = 1, flips_of_all = 0;
  for(int round = 0; flips > 0; ++round) {
    BOOST_REQUIRE(round < most_rounds);
    flips = 0;
    for(Network& network : networks) {
      flips += FG::shorten(network).flips;
      check_holds(t, all);
      BOOST_TEST(t.is_valid());
    }
    flips_of_all += flips;
  }
  BOOST_TEST(flips_of_all > 0u);
  for(const Network& network : networks)
    BOOST_TEST(network.length(0_c) <= network.initial_length(0_c));
}

// A column of a grid is straight, and stands between a curve and its geodesic as long as its network has it.
BOOST_AUTO_TEST_CASE(a_curve_of_another_network_is_an_obstacle)
{
  const int n = 8;
  const Surface mesh = to_mesh<Surface>(flat_grid(n, n, Diagonal_rule::RISING));
  Triangulation t(mesh);
  Network obstacle(t), network(t);
  obstacle.add_curve(column(t, 4, n));
  const auto at = [&](int i, int j) { return FG::Vertex_index(j * (n + 1) + i); };
  // Around the column over the grid's side, where the column ends.
  std::vector<FG::Vertex_index> around;
  for(int j = 1; j <= n; ++j)
    around.push_back(at(3, j));
  around.push_back(at(4, n));
  for(int j = n; j >= 1; --j)
    around.push_back(at(5, j));
  network.add_curve(edge_path(t, around));
  const auto before = obstacle.halfedges(0_c);
  BOOST_TEST(FG::shorten(obstacle).curves[0].flips == 0u);
  const FG::Shortening_report blocked = FG::shorten(network);
  BOOST_TEST(blocked.is_complete());
  BOOST_TEST((obstacle.halfedges(0_c) == before));
  check_holds(t, {&obstacle, &network});
  BOOST_TEST(network.length(0_c) == 2 * std::hypot(1, n - 1), boost::test_tools::tolerance(1e-12));
  for(FG::Halfedge_index h : before) {
    BOOST_TEST(!t.is_flippable(h));
    BOOST_TEST(network.is_occupied(h) == false);
  }
  obstacle.clear();
  BOOST_TEST(FG::shorten(network).is_complete());
  BOOST_TEST(network.length(0_c) == 2., boost::test_tools::tolerance(1e-12));
  check_holds(t, {&obstacle, &network});
}

// Curves of two networks along one edge have no order there: each leaves it by itself.
BOOST_AUTO_TEST_CASE(curves_of_two_networks_overlap)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Setting s(mesh, vertex(0), vertex(40));
  Network one(s.triangulation), other(s.triangulation);
  add_path(one, s);
  add_path(other, s);
  check_holds(s.triangulation, {&one, &other});
  for(Network* network : {&one, &other, &one}) {
    FG::shorten(*network);
    check_holds(s.triangulation, {&one, &other});
  }
  BOOST_TEST(one.length(0_c) == other.length(0_c));
  one.clear();
  check_holds(s.triangulation, {&one, &other});
}

BOOST_AUTO_TEST_CASE(points_on_curves_of_another_network_are_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Setting s(mesh, vertex(0), vertex(40));
  Triangulation& t = s.triangulation;
  Network one(t), other(t);
  const FG::Halfedge_index along = t.outgoing(16_v);
  const FG::Surface_location middle = {FG::internal::as_input(along), {{1, 1, 0}}};
  one.add_curve(Halfedge_sequence{along});
  other.add_curve(Halfedge_sequence{along});
  const auto position = t.log_position();
  BOOST_CHECK_THROW(one.insert(middle), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(one.split_edge(along, middle, 0), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::refine(one), FG::Occupied_triangulation_error);
  Network empty(t);
  BOOST_CHECK_THROW(empty.insert(middle), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::add_straightened_path(empty, column(t, 2, 6)), FG::Occupied_triangulation_error);
  std::stringstream saved;
  FG::write_network(saved, one);
  BOOST_CHECK_THROW(FG::read_network(saved, empty), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::draw_polyline(empty, {{FG::internal::as_input(along), {{3, 3, 1}}},
                                              {FG::internal::as_input(t.twin(along)), {{3, 3, 1}}}}),
                    FG::Error);
  BOOST_TEST(t.log_position() == position);
  check_holds(t, {&one, &other, &empty});
  other.clear();
  BOOST_CHECK_NO_THROW(one.insert(middle));
  BOOST_TEST(one.halfedges(0_c).size() == 2u);
  check_holds(t, {&one, &other, &empty});
}

// As in a class that has both.
BOOST_AUTO_TEST_CASE(a_triangulation_and_its_network_are_moved)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Setting s(mesh, vertex(0), vertex(40));
  Network network(s.triangulation);
  add_path(network, s);
  const auto halfedges = network.halfedges(0_c);
  Triangulation t(std::move(s.triangulation));
  Network moved(std::move(network), t);
  BOOST_TEST(&moved.triangulation() == &t);
  BOOST_TEST((moved.halfedges(0_c) == halfedges));
  check_holds(t, {&moved});
  BOOST_TEST(FG::shorten(moved).is_complete());
  check_holds(t, {&moved});

  Triangulation other(mesh);
  {
    Network assigned(other);
    assigned.add_curve(column(other, 2, 6));
    assigned = std::move(moved);
    BOOST_TEST(other.number_of_holds() == 0u);
    check_holds(t, {&assigned});
    moved.clear();
    moved.add_curve(column(t, 0, 6));
    check_holds(t, {&assigned, &moved});
    moved.clear();
  }
  BOOST_TEST(t.number_of_holds() == 0u);
  other = std::move(t);
  Network last(other);
  last.add_curve(column(other, 0, 6));
  check_holds(other, {&last});
}

// What may have to flip any edge.
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
  BOOST_CHECK_THROW(tree.grow(3_v), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::refine(t), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::geodesics_through(t, s.locations()), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::complete_polyline(t, s.locations()), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::Geodesic_spline<Triangulation>(t, s.locations(), FG::Spline_kind::BEZIER),
                    FG::Occupied_triangulation_error);
  BOOST_TEST((network.halfedges(0_c) == before));
  BOOST_TEST(network.is_valid());
  BOOST_TEST(t.is_valid());
  BOOST_TEST(t.log_position() == position);

  network.clear(); // an empty network is in the way of nothing
  t.rollback();
  BOOST_CHECK_NO_THROW(FG::geodesics_through(t, s.locations()));
  BOOST_CHECK_NO_THROW(tree.grow(3_v));
  network.add_curve(tree.path(40_v));
  BOOST_CHECK_THROW(FG::make_shortest(tree), FG::Occupied_triangulation_error);
}

BOOST_AUTO_TEST_CASE(a_point_on_an_edge_under_a_curve_is_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Triangulation t(mesh);
  Network network(t);
  const FG::Halfedge_index along = t.outgoing(16_v);
  const FG::Input_halfedge_index h = FG::internal::as_input(along);
  network.add_curve(Halfedge_sequence{along});
  const auto position = t.log_position();
  BOOST_CHECK_THROW(t.insert({h, {{1, 1, 0}}}), FG::Occupied_triangulation_error);
  BOOST_TEST(t.log_position() == position);
  BOOST_TEST(network.is_valid());
  BOOST_TEST(t.is_valid());
  BOOST_CHECK_NO_THROW(t.insert({h, {{1, 1, 1}}}));
  BOOST_CHECK_NO_THROW(network.insert({h, {{1, 1, 0}}}));
  BOOST_TEST(network.halfedges(0_c).size() == 2u);
}

BOOST_AUTO_TEST_CASE(an_empty_network_can_outlive_its_triangulation)
{
  const Surface mesh = to_mesh<Surface>(octahedron(2));
  auto triangulation = std::make_unique<Triangulation>(mesh);
  Network network(*triangulation);
  network.add_curve(Halfedge_sequence{0_h});
  network.clear();
  triangulation.reset(); // nothing is written there any more
}
