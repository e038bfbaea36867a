// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE stop_predicates

#include "test_stop_predicates/random_networks.h"

#include <algorithm>
#include <utility>
#include <vector>

using namespace Flip_geodesics_test;

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
    BOOST_TEST(total(report, &FG::Curve_report::length) >= ratio * total(report, &FG::Curve_report::initial_length));
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
      BOOST_TEST(curve.length >= ratio * curve.initial_length);
      ++statuses[FG::to_string(curve.status)];
    }
  });
  print("length of each curve", statuses);
  BOOST_TEST(statuses["LENGTH_LIMIT"] > 0);
  BOOST_TEST(statuses["CONTRACTED"] == 0);
}

// The limit is a length that a run passes, as it is kept from step to step; the sum over the segments may be less.
BOOST_AUTO_TEST_CASE(limits_that_are_met_but_for_rounding)
{
  for_random_networks(100, 3, [&](Curve_setting& setting, Random_numbers& random) {
    const auto start = setting.triangulation.log_position();
    std::vector<std::pair<Halfedge_sequence, bool>> curves;
    for(const Curve_index c : descriptors<Curve_index>(setting.network.number_of_curves()))
      curves.emplace_back(setting.network.halfedges(c), setting.network.is_closed(c));
    FG::Shortener<Curve_setting::Network> shortener(setting.network);
    shortener.run(FG::Iteration_stop_predicate(static_cast<std::size_t>(1 + random.below(8))));
    std::vector<double> ratios;
    double initial_length = 0;
    for(const Curve_index c : descriptors<Curve_index>(setting.network.number_of_curves())) {
      ratios.push_back(std::clamp(shortener.length(c) / setting.network.initial_length(c), 0.0, 1.0));
      initial_length += setting.network.initial_length(c);
    }
    const double ratio_of_all = std::clamp(shortener.length() / initial_length, 0.0, 1.0);
    const auto again = [&](const auto& stop) {
      setting.network.clear();
      setting.triangulation.rollback(start);
      for(const auto& [walk, is_closed] : curves)
        setting.network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
      return setting.pull(stop);
    };
    for(const double ratio : ratios)
      for(const FG::Curve_report& curve : again(FG::Curve_length_ratio_stop_predicate(ratio)).curves)
        BOOST_TEST(curve.length >= ratio * curve.initial_length);
    const FG::Shortening_report report = again(FG::Length_ratio_stop_predicate(ratio_of_all));
    BOOST_TEST(total(report, &FG::Curve_report::length) >= ratio_of_all * initial_length);
  });
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
    BOOST_TEST(total(report, &FG::Curve_report::length) >= ratio * total(report, &FG::Curve_report::initial_length));
    for(const FG::Curve_report& curve : report.curves)
      ++statuses[FG::to_string(curve.status)];
  });
  print("any of several", statuses);
  BOOST_TEST(statuses["ITERATION_LIMIT"] > 0);
  BOOST_TEST(statuses["LENGTH_LIMIT"] > 0);
}

// Memory may be at its limit; angles and steps have reached it, and lengths are too close to be above for certain.
BOOST_AUTO_TEST_CASE(limits_that_are_met_exactly)
{
  FG::Shortening_step step = {};
  step.initial_length = step.curve_initial_length = 8;
  step.length_after = step.curve_length_after = 4;
  step.angle_key = 1 - std::cos(1.25) / (std::abs(std::cos(1.25)) + std::sin(1.25));
  step.steps = 3;
  step.memory = 1000;
  using FG::Stop_decision;
  BOOST_TEST((FG::Length_ratio_stop_predicate(0.5 - 1e-9)(step) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Length_ratio_stop_predicate(0.5)(step) == Stop_decision::LENGTH_LIMIT));
  BOOST_TEST((FG::Length_ratio_stop_predicate(0)(FG::Shortening_step()) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Curve_length_ratio_stop_predicate(0.5 - 1e-9)(step) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Curve_length_ratio_stop_predicate(0.5)(step) == Stop_decision::CURVE_LENGTH_LIMIT));
  BOOST_TEST((FG::Curve_length_ratio_stop_predicate(0)(FG::Shortening_step()) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Angle_stop_predicate(1.25)(step) == Stop_decision::ANGLE_LIMIT));
  BOOST_TEST((FG::Angle_stop_predicate(1.25 + 1e-12)(step) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Iteration_stop_predicate(3)(step) == Stop_decision::ITERATION_LIMIT));
  BOOST_TEST((FG::Iteration_stop_predicate(4)(step) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Memory_stop_predicate(1000)(step) == Stop_decision::CONTINUE));
  BOOST_TEST((FG::Memory_stop_predicate(999)(step) == Stop_decision::MEMORY_LIMIT));
}
