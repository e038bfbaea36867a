// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE stop_predicates

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Shortener.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Curve_index;
using FG::Shortening_status;
using FG::Vertex_index;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

namespace {

// Sums of lengths in another order.
constexpr double rounding = 1e-13;

using Setting_ptr = std::unique_ptr<Curve_setting>;

// Random networks: long paths, loops that contract, loops that do not, on a Delta-complex.
template <class Function>
void for_random_networks(int number, unsigned seed, const Function& function)
{
  const std::vector<Mesh_soup> soups = {shaken(torus(6, 5, 3, 1), 0.2, 1), bumpy_sphere(4, 0.3, 2), genus_3_plate(1),
                                        jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 3)};
  Random_numbers random(seed);
  for(const Mesh_soup& soup : soups) {
    Curve_setting setting(soup);
    for(int i = 0; i < number * scale; ++i) {
      flip_at_random(setting.triangulation, random.below(40), random);
      for(int k = 0; k < 6; ++k) {
        const Halfedge_sequence walk = random_walk(setting.triangulation, 12, random.below(2) == 0, random);
        if(walk.empty())
          continue;
        const bool is_closed = setting.triangulation.head(walk.back()) == setting.triangulation.tail(walk.front());
        setting.network.add_curve(walk, is_closed);
        if(!setting.network.is_valid()) {
          setting.network.clear(); // the first few are as good
          continue;
        }
      }
      if(setting.network.number_of_curves() > 0)
        function(setting, random);
      setting.network.clear();
      setting.triangulation.rollback();
    }
  }
}

double total(const FG::Shortening_report& report, double FG::Curve_report::*value)
{
  double sum = 0;
  for(const FG::Curve_report& curve : report.curves)
    sum += curve.*value;
  return sum;
}

void check_consistency(const Curve_setting& setting, const FG::Shortening_report& report)
{
  BOOST_TEST(report.curves.size() == static_cast<std::size_t>(setting.network.number_of_curves()));
  bool is_complete = true;
  for(Curve_index c : descriptors<Curve_index>(setting.network.number_of_curves())) {
    const FG::Curve_report& curve = report.curves[c.idx()];
    BOOST_TEST(curve.initial_length == setting.network.initial_length(c));
    BOOST_TEST(curve.length == setting.network.length(c));
    BOOST_TEST(curve.length <= curve.initial_length * (1 + rounding));
    const bool is_contracted = curve.status == Shortening_status::CONTRACTED;
    BOOST_TEST(is_contracted == setting.network.is_contracted(c));
    BOOST_TEST((!is_contracted || (curve.length == 0 && std::isinf(curve.smallest_angle))));
    BOOST_TEST((curve.status != Shortening_status::LOCALLY_SHORTEST || curve.smallest_angle > pi - 1e-8));
    is_complete = is_complete && (is_contracted || curve.status == Shortening_status::LOCALLY_SHORTEST);
  }
  BOOST_TEST(report.is_complete() == is_complete);
  BOOST_TEST(setting.network.is_valid());
  BOOST_TEST(setting.triangulation.is_valid());
}

int count(const FG::Shortening_report& report, Shortening_status status)
{
  int result = 0;
  for(const FG::Curve_report& curve : report.curves)
    result += curve.status == status ? 1 : 0;
  return result;
}

void print(const char* title, const std::map<std::string, int>& statuses)
{
  std::cout << title << ':';
  for(const auto& [status, number] : statuses)
    std::cout << ' ' << status << ' ' << number;
  std::cout << '\n';
}

} // namespace

BOOST_AUTO_TEST_CASE(nothing_stops)
{
  for_random_networks(300, 1, [](Curve_setting& setting, Random_numbers&) {
    const FG::Shortening_report report = setting.pull();
    check_consistency(setting, report);
    BOOST_TEST(report.is_complete());
    const FG::Shortening_report again = setting.pull(); // there is nothing left to do
    BOOST_TEST(again.flips == 0u);
    BOOST_TEST(again.flip_outs == 0u);
  });
}

BOOST_AUTO_TEST_CASE(total_length)
{
  std::map<std::string, int> statuses;
  for_random_networks(300, 2, [&](Curve_setting& setting, Random_numbers& random) {
    const double ratio = random.uniform(0, 1);
    const FG::Shortening_report report = setting.pull(FG::Length_ratio_stop_predicate(ratio));
    check_consistency(setting, report);
    BOOST_TEST(total(report, &FG::Curve_report::length) >=
               ratio * total(report, &FG::Curve_report::initial_length) * (1 - rounding));
    BOOST_TEST(count(report, Shortening_status::LENGTH_LIMIT) + count(report, Shortening_status::LOCALLY_SHORTEST) +
                   count(report, Shortening_status::CONTRACTED) ==
               setting.network.number_of_curves());
    if(!report.is_complete()) // the step that was refused would have led below
      BOOST_TEST(count(report, Shortening_status::LENGTH_LIMIT) > 0);
    for(const FG::Curve_report& curve : report.curves)
      ++statuses[FG::to_string(curve.status)];
  });
  print("total length", statuses);
  BOOST_TEST(statuses["LENGTH_LIMIT"] > 0);
  BOOST_TEST(statuses["LOCALLY_SHORTEST"] > 0);
}

BOOST_AUTO_TEST_CASE(length_of_each_curve)
{
  std::map<std::string, int> statuses;
  for_random_networks(300, 3, [&](Curve_setting& setting, Random_numbers& random) {
    const double ratio = random.uniform(0, 1);
    const FG::Shortening_report report = setting.pull(FG::Curve_length_ratio_stop_predicate(ratio));
    check_consistency(setting, report);
    for(const FG::Curve_report& curve : report.curves) {
      BOOST_TEST(curve.length >= ratio * curve.initial_length * (1 - rounding));
      ++statuses[FG::to_string(curve.status)];
    }
  });
  print("length of each curve", statuses);
  BOOST_TEST(statuses["LENGTH_LIMIT"] > 0);
  BOOST_TEST(statuses["CONTRACTED"] == 0);
}

BOOST_AUTO_TEST_CASE(angles)
{
  std::map<std::string, int> statuses;
  for_random_networks(300, 4, [&](Curve_setting& setting, Random_numbers& random) {
    const double limit = random.uniform(0.1, pi);
    const FG::Shortening_report report = setting.pull(FG::Angle_stop_predicate(limit));
    check_consistency(setting, report);
    for(const FG::Curve_report& curve : report.curves) {
      BOOST_TEST(curve.smallest_angle >= limit - 1e-8);
      ++statuses[FG::to_string(curve.status)];
    }
  });
  print("angles", statuses);
  BOOST_TEST(statuses["ANGLE_LIMIT"] > 0);
}

BOOST_AUTO_TEST_CASE(iterations)
{
  std::map<std::string, int> statuses;
  for_random_networks(300, 5, [&](Curve_setting& setting, Random_numbers& random) {
    const std::size_t limit = static_cast<std::size_t>(random.below(6));
    const FG::Shortening_report report = setting.pull(FG::Iteration_stop_predicate(limit));
    check_consistency(setting, report);
    BOOST_TEST(report.flip_outs <= limit);
    BOOST_TEST((report.is_complete() || report.flip_outs == limit));
    for(const FG::Curve_report& curve : report.curves)
      ++statuses[FG::to_string(curve.status)];
  });
  print("iterations", statuses);
  BOOST_TEST(statuses["ITERATION_LIMIT"] > 0);
}

// One step at a time is the same as all at once, as long as the queue hands out the same joint.
BOOST_AUTO_TEST_CASE(steps_one_by_one_end_as_well)
{
  for_random_networks(100, 6, [](Curve_setting& setting, Random_numbers&) {
    double length = HUGE_VAL;
    for(int steps = 0;; ++steps) {
      BOOST_REQUIRE(steps < 10000);
      const FG::Shortening_report report = setting.pull(FG::Iteration_stop_predicate(1));
      check_consistency(setting, report);
      BOOST_TEST(total(report, &FG::Curve_report::length) <= length * (1 + rounding));
      length = total(report, &FG::Curve_report::length);
      if(report.is_complete())
        return;
      BOOST_TEST(report.flip_outs == 1u);
    }
  });
}

BOOST_AUTO_TEST_CASE(time_that_is_over)
{
  for_random_networks(5, 7, [](Curve_setting& setting, Random_numbers&) {
    const FG::Shortening_report report = setting.pull(FG::Time_stop_predicate(std::chrono::seconds(0)));
    check_consistency(setting, report);
    BOOST_TEST(report.flip_outs == 0u);
    const FG::Shortening_report rest = setting.pull(FG::Time_stop_predicate(std::chrono::hours(1000)));
    BOOST_TEST(rest.is_complete());
  });
}

BOOST_AUTO_TEST_CASE(any_of_several)
{
  using Any = FG::Any_stop_predicate<FG::Length_ratio_stop_predicate, FG::Iteration_stop_predicate>;
  std::map<std::string, int> statuses;
  for_random_networks(300, 8, [&](Curve_setting& setting, Random_numbers& random) {
    const double ratio = random.uniform(0.5, 1);
    const std::size_t limit = static_cast<std::size_t>(random.below(6));
    const Any any(FG::Length_ratio_stop_predicate{ratio}, FG::Iteration_stop_predicate{limit});
    const FG::Shortening_report report = setting.pull(any);
    check_consistency(setting, report);
    BOOST_TEST(report.flip_outs <= limit);
    BOOST_TEST(total(report, &FG::Curve_report::length) >=
               ratio * total(report, &FG::Curve_report::initial_length) * (1 - rounding));
    for(const FG::Curve_report& curve : report.curves)
      ++statuses[FG::to_string(curve.status)];
  });
  print("any of several", statuses);
  BOOST_TEST(statuses["ITERATION_LIMIT"] > 0);
  BOOST_TEST(statuses["LENGTH_LIMIT"] > 0);
}

// ---------------------------------------------------------------- visitors

namespace {

struct Counting_visitor : FG::Default_shortening_visitor
{
  template <class Triangulation>
  void on_flip(const Triangulation& triangulation, FG::Halfedge_index h)
  {
    ++flips;
    BOOST_TEST(triangulation.label(triangulation.edge(h)) == 0);
  }

  template <class Network>
  void after_flip_out(const Network& network, Curve_index curve)
  {
    ++steps;
    BOOST_TEST(network.is_valid());
    BOOST_TEST(curve.idx() < network.number_of_curves());
  }

  bool go_further()
  {
    ++questions;
    return steps < limit;
  }

  std::size_t limit = static_cast<std::size_t>(-1), flips = 0, steps = 0, questions = 0;
};

} // namespace

BOOST_AUTO_TEST_CASE(visitors_see_everything)
{
  for_random_networks(100, 9, [](Curve_setting& setting, Random_numbers&) {
    Counting_visitor visitor;
    const auto start = setting.triangulation.log_position();
    const FG::Shortening_report report = FG::shorten(setting.network, FG::Never_stop_predicate(), visitor);
    BOOST_TEST(visitor.flips == report.flips);
    BOOST_TEST(visitor.flips ==
               std::accumulate(report.curves.begin(), report.curves.end(), std::size_t(0),
                               [](std::size_t sum, const FG::Curve_report& c) { return sum + c.flips; }));
    BOOST_TEST(visitor.steps == report.flip_outs);
    BOOST_TEST(visitor.questions >= report.flip_outs);
    BOOST_TEST(report.flips >= setting.triangulation.log_position() - start);
  });
}

BOOST_AUTO_TEST_CASE(visitors_interrupt)
{
  std::map<std::string, int> statuses;
  for_random_networks(300, 10, [&](Curve_setting& setting, Random_numbers& random) {
    Counting_visitor visitor;
    visitor.limit = static_cast<std::size_t>(random.below(6));
    const FG::Shortening_report report = FG::shorten(setting.network, FG::Never_stop_predicate(), visitor);
    check_consistency(setting, report);
    BOOST_TEST(report.flip_outs <= visitor.limit);
    BOOST_TEST((report.is_complete() || report.flip_outs == visitor.limit));
    for(const FG::Curve_report& curve : report.curves)
      ++statuses[FG::to_string(curve.status)];
  });
  print("interrupted", statuses);
  BOOST_TEST(statuses["STOPPED_BY_VISITOR"] > 0);
}

namespace {

struct Throwing_visitor : FG::Default_shortening_visitor
{
  template <class Triangulation>
  void on_flip(const Triangulation&, FG::Halfedge_index)
  {
    if(limit-- == 0)
      throw 1;
  }

  int limit = 0;
};

} // namespace

// Also in the middle of the unit that shortens a loop of one segment, which lengthens it first.
BOOST_AUTO_TEST_CASE(an_exception_leaves_no_curve_longer)
{
  int thrown = 0;
  const auto throw_at = [&](Curve_setting& setting, int limit) {
    FG::internal::Indexed_by<Curve_index, std::vector<double>> lengths;
    for(Curve_index c : descriptors<Curve_index>(setting.network.number_of_curves()))
      lengths.push_back(setting.network.length(c));
    Throwing_visitor visitor;
    visitor.limit = limit;
    try {
      FG::shorten(setting.network, FG::Never_stop_predicate(), visitor);
    } catch(int) {
      ++thrown;
    }
    BOOST_TEST(setting.network.is_valid());
    BOOST_TEST(setting.triangulation.is_valid());
    for(Curve_index c : descriptors<Curve_index>(setting.network.number_of_curves()))
      BOOST_TEST(setting.network.length(c) <= lengths[c] * (1 + rounding));
  };
  for_random_networks(100, 11, [&](Curve_setting& setting, Random_numbers& random) {
    throw_at(setting, random.below(20));
    BOOST_TEST(FG::shorten(setting.network).is_complete());
  });
  for(const Mesh_soup& soup :
      {shaken(octahedron(1), 0.3, 2), shaken(torus(4, 3, 2, 1), 0.2, 3)}) // loops of one segment
    for(unsigned seed = 0; seed < 400; ++seed) {
      Random_numbers random(seed);
      Curve_setting setting(soup);
      flip_at_random(setting.triangulation, random.below(60), random);
      const Halfedge_sequence loop = random_loop_edge(setting.triangulation, random);
      if(loop.empty())
        continue;
      setting.network.add_curve(loop, true);
      throw_at(setting, random.below(6));
    }
  BOOST_TEST(thrown > 100);
}

// ---------------------------------------------------------------- many runs

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
      network.add_curve(search(Vertex_index(v), Vertex_index(479 - v)), false);
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

// At a limit, lengths and memory may stay, angles, steps and time have reached it.
BOOST_AUTO_TEST_CASE(limits_that_are_met_exactly)
{
  FG::Shortening_step step = {};
  step.initial_length = step.curve_initial_length = 8;
  step.length_after = step.curve_length_after = 4;
  step.angle_key = 1 - std::cos(1.25) / (std::abs(std::cos(1.25)) + std::sin(1.25));
  step.steps = 3;
  step.memory = 1000;
  using FG::Stop_decision;
  BOOST_TEST((FG::Length_ratio_stop_predicate(0.5)(step) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Length_ratio_stop_predicate(0.5 + 1e-15)(step) == Stop_decision::LENGTH_LIMIT));
  BOOST_TEST((FG::Curve_length_ratio_stop_predicate(0.5)(step) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Curve_length_ratio_stop_predicate(0.5 + 1e-15)(step) == Stop_decision::CURVE_LENGTH_LIMIT));
  BOOST_TEST((FG::Angle_stop_predicate(1.25)(step) == Stop_decision::ANGLE_LIMIT));
  BOOST_TEST((FG::Angle_stop_predicate(1.25 + 1e-12)(step) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Iteration_stop_predicate(3)(step) == Stop_decision::ITERATION_LIMIT));
  BOOST_TEST((FG::Iteration_stop_predicate(4)(step) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Memory_stop_predicate(1000)(step) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Memory_stop_predicate(999)(step) == Stop_decision::MEMORY_LIMIT));
}
