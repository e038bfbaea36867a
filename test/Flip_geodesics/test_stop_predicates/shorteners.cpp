// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Shorteners that run more than once.

#include "test_stop_predicates/random_networks.h"

using namespace Flip_geodesics_test;

namespace {

/// Counts what is looked at.
template <class Triangulation>
class Counting_network : public FG::Edge_path_network<Triangulation>
{
  using Base = FG::Edge_path_network<Triangulation>;

public:
  using Base::Base;

  typename Base::Wedge wedge(const FG::Joint& joint) const
  {
    ++wedges;
    return Base::wedge(joint);
  }

  template <class Function>
  void for_each_segment(Curve_index curve, Function function) const
  {
    ++traversals;
    Base::for_each_segment(curve, function);
  }

  double length(Curve_index curve) const
  {
    ++sums;
    return Base::length(curve);
  }

  mutable std::size_t wedges = 0, traversals = 0, sums = 0;
};

void check_same(const FG::Shortening_report& report, const FG::Shortening_report& expected)
{
  BOOST_TEST(report.flip_outs == expected.flip_outs);
  BOOST_REQUIRE(report.curves.size() == expected.curves.size());
  for(std::size_t c = 0; c < report.curves.size(); ++c) {
    BOOST_TEST((report.curves[c].status == expected.curves[c].status));
    BOOST_TEST(report.curves[c].length == expected.curves[c].length);
    BOOST_TEST(report.curves[c].smallest_angle == expected.curves[c].smallest_angle);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(many_runs_are_one)
{
  std::vector<FG::Shortening_report> at_once;
  for_random_networks(60, 11, [&](Curve_setting& setting, Random_numbers&) { at_once.push_back(setting.pull()); });
  std::size_t network = 0, runs = 0;
  for_random_networks(60, 11, [&](Curve_setting& setting, Random_numbers&) {
    FG::Shortener<Curve_setting::Network> shortener(setting.network);
    for(std::size_t i = 0; !shortener.run(FG::Iteration_stop_predicate(i % 4)); ++i, ++runs) {
      const FG::Shortening_report report = shortener.report();
      check_consistency(setting, report);
      BOOST_TEST(!report.is_complete());
      BOOST_TEST(report.flip_outs == shortener.number_of_steps());
      BOOST_TEST(std::abs(shortener.length() - total(report, &FG::Curve_report::length)) <=
                 rounding * total(report, &FG::Curve_report::initial_length));
    }
    BOOST_TEST(shortener.is_finished());
    check_same(shortener.report(), at_once[network++]);
  });
  BOOST_TEST(network == at_once.size());
  BOOST_TEST(runs > 1000u);
}

BOOST_AUTO_TEST_CASE(limits_are_lowered)
{
  std::size_t limited = 0;
  for_random_networks(100, 12, [&](Curve_setting& setting, Random_numbers&) {
    FG::Shortener<Curve_setting::Network> shortener(setting.network);
    for(double ratio : {0.98, 0.9, 0.7}) {
      shortener.run(FG::Curve_length_ratio_stop_predicate(ratio));
      const FG::Shortening_report report = shortener.report();
      check_consistency(setting, report);
      for(const FG::Curve_report& curve : report.curves)
        BOOST_TEST(curve.length >= ratio * curve.initial_length * (1 - rounding));
      limited += shortener.is_finished() ? 0 : 1;
      BOOST_TEST(shortener.is_finished() == report.is_complete());
    }
    Counting_visitor visitor;
    visitor.limit = 1;
    shortener.run(FG::Never_stop_predicate(), visitor);
    BOOST_TEST(shortener.run());
    BOOST_TEST(shortener.report().is_complete());
    const std::size_t steps = shortener.number_of_steps();
    BOOST_TEST(shortener.run()); // there is nothing left to do
    BOOST_TEST(shortener.number_of_steps() == steps);
    BOOST_TEST(setting.pull().flip_outs == 0u);
  });
  BOOST_TEST(limited > 100u);
}

// A run looks at what its steps touch, once.
BOOST_AUTO_TEST_CASE(runs_look_at_nothing_twice)
{
  const Surface mesh = to_mesh<Surface>(shaken(torus(24, 20, 3, 1), 0.2, 1));
  using Network = Counting_network<Curve_setting::Triangulation>;
  Curve_setting::Triangulation triangulation(mesh);
  Curve_setting::Search search(triangulation);
  std::size_t wedges_at_once = 0;
  for(bool is_at_once : {true, false}) {
    Network network(triangulation);
    for(int v = 0; v < 200; v += 10)
      network.add_curve(search(Vertex_index(v), Vertex_index(479 - v)));
    FG::Shortener<Network> shortener(network);
    const std::size_t looked_at_first = network.wedges, traversals = network.traversals, sums = network.sums;
    while(!shortener.run(FG::Iteration_stop_predicate(is_at_once ? static_cast<std::size_t>(-1) : 1))) {
      BOOST_TEST(network.traversals == traversals);
      BOOST_TEST(network.sums == sums);
    }
    BOOST_TEST(shortener.number_of_steps() > 100u);
    const std::size_t wedges = network.wedges - looked_at_first;
    if(is_at_once)
      wedges_at_once = wedges;
    else
      BOOST_TEST(wedges == wedges_at_once);
    BOOST_TEST(network.wedges < 20 * (shortener.number_of_steps() + looked_at_first));
    BOOST_TEST(shortener.report().is_complete());
    network.clear();
    triangulation.rollback();
  }
}

// What waits in the queue is looked at again: nodes may have been fixed since.
BOOST_AUTO_TEST_CASE(wedges_at_nodes_that_were_fixed_meanwhile_are_not_free)
{
  Curve_setting setting(jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 3));
  auto& network = setting.network;
  setting.add_path(0_v, 48_v);
  FG::internal::Free_wedges<Curve_setting::Network> wedges(network);
  wedges.look_at_curve(0_c);
  BOOST_REQUIRE(wedges.has_next());
  while(wedges.has_next()) {
    const FG::Joint joint = wedges.pop().joint();
    const Vertex_index node = setting.triangulation.head(network.halfedge(joint.incoming));
    BOOST_TEST(wedges.is_still_free(joint));
    network.fix_nodes_at(node);
    BOOST_TEST(!wedges.is_still_free(joint));
    network.set_head_fixed(joint.incoming, false);
  }
}

// Between two runs all nodes are fixed: no step is left to take.
BOOST_AUTO_TEST_CASE(a_stopped_shortener_leaves_nodes_that_were_fixed)
{
  Curve_setting setting(jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 3));
  auto& network = setting.network;
  setting.add_path(0_v, 48_v);
  const std::vector<FG::Halfedge_index> before = network.halfedges(0_c);
  FG::Shortener<Curve_setting::Network> shortener(network);
  BOOST_TEST(!shortener.run(FG::Iteration_stop_predicate(0)));
  for(FG::Halfedge_index h : before)
    network.fix_nodes_at(setting.triangulation.head(h));
  BOOST_TEST(shortener.run());
  BOOST_TEST(shortener.number_of_steps() == 0u);
  BOOST_TEST(network.halfedges(0_c) == before, boost::test_tools::per_element());
  BOOST_TEST(setting.triangulation.log_position() == 0u);
}

// A path visits a vertex before and after a spike. Whichever visit is fixed, the path still passes the vertex.
BOOST_AUTO_TEST_CASE(a_node_stays_fixed_when_a_spike_is_removed)
{
  const int n = 4;
  const auto at = [](int i, int j) { return Vertex_index(grid_vertex(n, i, j)); };
  for(const bool is_first_fixed : {false, true}) {
    Curve_setting setting(flat_grid(n, n, Diagonal_rule::RISING));
    auto& network = setting.network;
    setting.add({at(1, 2), at(2, 2), at(3, 2), at(2, 2), at(2, 1)}, false);
    const FG::Segment_index first = network.first_segment(0_c);
    network.set_head_fixed(is_first_fixed ? first : network.next(network.next(first)), true);
    setting.pull();
    BOOST_TEST(std::abs(network.length(0_c) - 2) < rounding);
    BOOST_TEST(network.halfedges(0_c).size() == 2u);
    BOOST_TEST(network.is_head_fixed(network.first_segment(0_c)));
  }
}

// A loop of one segment is lengthened first, and its length is summed up along the way.
BOOST_AUTO_TEST_CASE(a_shortener_knows_the_length_of_loops_of_one_segment)
{
  int shortened = 0;
  for(const Mesh_soup& soup : {shaken(octahedron(1), 0.3, 2), shaken(torus(4, 3, 2, 1), 0.2, 3)})
    for(unsigned seed = 0; seed < 200; ++seed) {
      Random_numbers random(seed);
      Curve_setting setting(soup);
      flip_at_random(setting.triangulation, random.below(60), random);
      const Halfedge_sequence loop = random_loop_edge(setting.triangulation, random);
      if(loop.empty())
        continue;
      setting.network.add_curve(loop, CGAL::parameters::is_closed(true));
      const double before = setting.network.length(0_c);
      FG::Shortener<Curve_setting::Network> shortener(setting.network);
      shortener.run();
      BOOST_TEST(std::abs(shortener.length(0_c) - setting.network.length(0_c)) < rounding * before);
      shortened += shortener.number_of_steps() > 0 ? 1 : 0;
    }
  BOOST_TEST(shortened > 20);
}

// ---------------------------------------------------------------- small regions

// A limit on the total length lets a speck vanish; a limit on each curve keeps it.
BOOST_AUTO_TEST_CASE(specks_survive_a_limit_per_curve)
{
  const int n = 40;
  Curve_setting setting(cylinder(n, 6, 1, 3));
  const Vertex_sequence ring = cylinder_ring(n, 4);
  const Vertex_sequence speck = {Vertex_index(n * 2), Vertex_index(n * 2 + 1), Vertex_index(n * 3 + 1)}; // a triangle
  for(bool is_per_curve : {false, true}) {
    setting.add(ring, true);
    setting.add(speck, true);
    const FG::Shortening_report report = is_per_curve ? setting.pull(FG::Curve_length_ratio_stop_predicate(0.9))
                                                      : setting.pull(FG::Length_ratio_stop_predicate(0.5));
    BOOST_TEST(setting.network.is_contracted(1_c) == !is_per_curve);
    BOOST_TEST((FG::to_string(report.curves[1].status) == std::string(is_per_curve ? "LENGTH_LIMIT" : "CONTRACTED")));
    setting.network.clear();
    setting.triangulation.rollback();
  }
}

namespace {

// Stops at the first step, and keeps what it is told.
struct Asked_predicate
{
  FG::Stop_decision operator()(const FG::Shortening_step& step) const
  {
    *last = step;
    return FG::Stop_decision::ITERATION_LIMIT;
  }

  FG::Shortening_step* last;
};

} // namespace

// Lengths start at what a network is, ratios at what it was; a curve without a step to take is done whenever it ends.
BOOST_AUTO_TEST_CASE(a_shortener_starts_where_another_one_has_ended)
{
  const int n = 8;
  Curve_setting setting(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 1));
  setting.add({Vertex_index(grid_vertex(n, 0, 0)), Vertex_index(grid_vertex(n, 1, 0))}, false); // of one segment
  setting.add_path(Vertex_index(grid_vertex(n, 0, 1)), Vertex_index(grid_vertex(n, n, n)));
  setting.pull(FG::Iteration_stop_predicate(2));
  const auto& network = setting.network;
  BOOST_REQUIRE_LT(network.length(1_c), network.initial_length(1_c) * (1 - 1e-6));
  FG::Shortener<Curve_setting::Network> shortener(setting.network);
  BOOST_TEST(std::abs(shortener.length(1_c) - network.length(1_c)) < rounding * network.length(1_c));
  FG::Shortening_step asked = {};
  BOOST_TEST(!shortener.run(Asked_predicate{&asked}));
  const double initial = network.initial_length(0_c) + network.initial_length(1_c);
  BOOST_TEST(std::abs(asked.initial_length - initial) < rounding * initial);
  BOOST_TEST(asked.curve_initial_length == network.initial_length(1_c));
  const FG::Shortening_report report = shortener.report();
  BOOST_TEST((report.curves[0].status == Shortening_status::LOCALLY_SHORTEST));
  BOOST_TEST((report.curves[1].status == Shortening_status::ITERATION_LIMIT));
}
