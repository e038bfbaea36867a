// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Loops and cut graphs are stopped at each call of a visitor in turn.

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "test_interruption/stopping.h"

#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/geodesic_loops.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

namespace {

using Chain = std::vector<FG::Halfedge_index>;

const std::vector<Vertex_index> no_base_points;

double total_length(const Setting::Network& network)
{
  double sum = 0;
  for(const FG::Curve_index c : descriptors<FG::Curve_index>(network.number_of_curves()))
    sum += network.length(c);
  return sum;
}

// Large enough that searches are stopped inside of them, too.
Mesh_soup pretzel() { return genus_3_plate(5); }

} // namespace

BOOST_AUTO_TEST_CASE(a_loop_basis)
{
  const Setting setting(pretzel());
  const FG::Loop_basis<Triangulation> expected(setting.triangulation);
  BOOST_TEST(expected.is_complete());
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    const FG::Loop_basis<Triangulation> basis(setting.triangulation, no_base_points,
                                              CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(basis.is_complete() == !is_stopped);
    BOOST_TEST(basis.number_of_loops() == (is_stopped ? 0 : 6));
    BOOST_TEST(basis.components().size() == (is_stopped ? 0u : 1u));
    for(FG::Index i = 0; i < basis.number_of_loops(); ++i)
      BOOST_TEST((basis.loop(i) == expected.loop(i)));
  });
  BOOST_TEST(calls > 8u); // its parts are four
}

BOOST_AUTO_TEST_CASE(handle_and_tunnel_loops)
{
  const Setting setting(pretzel());
  const auto expected = FG::handle_and_tunnel_loops(setting.triangulation);
  BOOST_TEST(expected.handles.size() == 3u);
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    const auto loops = FG::handle_and_tunnel_loops(setting.triangulation, CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST((loops.handles == (is_stopped ? std::vector<Chain>() : expected.handles)));
    BOOST_TEST((loops.tunnels == (is_stopped ? std::vector<Chain>() : expected.tunnels)));
  });
  BOOST_TEST(calls > 16u);
}

BOOST_AUTO_TEST_CASE(shortest_loops)
{
  const Setting setting(pretzel());
  constexpr FG::Loop_kind kind = FG::Loop_kind::NOT_BOUNDING;
  const auto check = [&](const Chain& expected, const auto& compute) {
    BOOST_TEST(!expected.empty());
    const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
      BOOST_TEST((compute(visitor) == (is_stopped ? Chain() : expected)));
    });
    BOOST_TEST(calls > 8u);
  };
  check(FG::shortest_loop(setting.triangulation, kind), [&](Stopping_visitor& visitor) {
    return FG::shortest_loop(setting.triangulation, kind, CGAL::parameters::visitor(std::ref(visitor)));
  });
  check(FG::shortest_loop(setting.triangulation, 0_v, kind), [&](Stopping_visitor& visitor) {
    return FG::shortest_loop(setting.triangulation, 0_v, kind, CGAL::parameters::visitor(std::ref(visitor)));
  });
}

BOOST_AUTO_TEST_CASE(a_cut_graph)
{
  Setting setting(pretzel());
  const FG::Index expected = FG::add_cut_graph(setting.network);
  setting.network.clear();
  BOOST_TEST(expected > 0);
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    BOOST_TEST(FG::add_cut_graph(setting.network, no_base_points, CGAL::parameters::visitor(std::ref(visitor))) ==
               (is_stopped ? 0 : expected));
    BOOST_TEST(setting.network.number_of_curves() == (is_stopped ? 0 : expected));
    setting.network.clear();
  });
  BOOST_TEST(calls > 8u);
}

// What is left is a network that is valid and no longer than before, and that can be shortened to the end.
BOOST_AUTO_TEST_CASE(a_cut_graph_that_is_shortened)
{
  Setting setting(genus_3_plate());
  std::size_t steps = 0;
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    FG::add_cut_graph(setting.network);
    const double before = total_length(setting.network);
    const auto report = FG::shorten_cut_graph(setting.network, CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(report.is_complete() == !is_stopped);
    BOOST_TEST(setting.network.is_valid());
    BOOST_TEST(total_length(setting.network) <= before * (1 + 1e-12));
    BOOST_TEST((!is_stopped || report.flip_outs <= steps));
    steps = is_stopped ? steps : report.flip_outs;
    BOOST_TEST(FG::shorten_cut_graph(setting.network).is_complete());
    setting.network.clear();
    setting.triangulation.rollback();
  });
  BOOST_TEST(calls > 1u);
}

// Stopped before the basis is known, nothing is written; later, the loops are as far as they have come.
BOOST_AUTO_TEST_CASE(a_geodesic_loop_basis)
{
  using Curve = std::vector<Mesh::Point>;
  const Mesh mesh = to_mesh<Mesh>(genus_3_plate());
  std::vector<Curve> expected;
  FG::geodesic_loop_basis(mesh, std::back_inserter(expected));
  bool is_stopped_in_basis = false, is_stopped_in_loop = false;
  stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    std::vector<Curve> loops;
    const auto result =
        FG::geodesic_loop_basis(mesh, std::back_inserter(loops), CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(result.report.is_complete() == !is_stopped);
    if(!is_stopped)
      BOOST_TEST((loops == expected));
    BOOST_TEST((loops.empty() || loops.size() == expected.size()));
    is_stopped_in_basis = is_stopped_in_basis || loops.empty();
    is_stopped_in_loop = is_stopped_in_loop || (is_stopped && !loops.empty());
    BOOST_TEST(result.report.curves.size() == (loops.empty() ? 1u : expected.size()));
  });
  BOOST_TEST(is_stopped_in_basis);
  BOOST_TEST(is_stopped_in_loop);
}
