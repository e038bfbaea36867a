// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Visitors watch, interrupt and throw.

#include "test_stop_predicates/random_networks.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(visitors_see_everything)
{
  for_random_networks(100, 9, [](Curve_setting& setting, Random_numbers&) {
    Counting_visitor visitor;
    const auto start = setting.triangulation.log_position();
    const FG::Shortening_report report = FG::shorten(setting.network, CGAL::parameters::visitor(std::ref(visitor)));
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
    const FG::Shortening_report report = FG::shorten(setting.network, CGAL::parameters::visitor(std::ref(visitor)));
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
      FG::shorten(setting.network, CGAL::parameters::visitor(std::ref(visitor)));
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
      setting.network.add_curve(loop, CGAL::parameters::is_closed(true));
      throw_at(setting, random.below(6));
    }
  BOOST_TEST(thrown > 100);
}
