// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One predicate for several curves.

#include "test_entry_points/entry_points.h"

using namespace Flip_geodesics_test;

namespace {

// Allows some steps altogether; a restarted one as many again.
struct Budget_stop_predicate
{
  std::size_t budget;
  std::shared_ptr<std::size_t> used = std::make_shared<std::size_t>(0);

  FG::Stop_decision operator()(const FG::Shortening_step&) const
  {
    return (*used)++ < budget ? FG::Stop_decision::CONTINUE : FG::Stop_decision::ITERATION_LIMIT;
  }

  Budget_stop_predicate restarted() const { return {budget}; }
};

} // namespace

BOOST_AUTO_TEST_CASE(each_path_has_its_own_budget)
{
  const Surface mesh = to_mesh<Surface>(shaken(octahedron(6), 0.2, 5));
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for(int v = 0; v < 30; ++v)
    pairs.push_back({vertex(v), vertex(v + 100)});
  const auto statuses = [&](const auto& stop) {
    std::vector<FG::Geodesic_path_result<Point>> paths;
    FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), CGAL::parameters::stop_predicate(stop));
    rethrow(paths);
    std::vector<FG::Shortening_status> result;
    for(const auto& path : paths)
      result.push_back(path.status());
    return result;
  };
  const auto complete = statuses(FG::Never_stop_predicate());
  BOOST_TEST((statuses(Budget_stop_predicate{200}) == complete));
  BOOST_TEST((statuses(FG::Any_stop_predicate<Budget_stop_predicate, FG::Iteration_stop_predicate>(
                  Budget_stop_predicate{200}, FG::Iteration_stop_predicate(1000))) == complete));
  BOOST_TEST((statuses(Budget_stop_predicate{1}) != complete));

  // The time is over for a single path, but not for many.
  const FG::Time_stop_predicate stop(std::chrono::seconds(2));
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  BOOST_TEST((stop(FG::Shortening_step()) == FG::Stop_decision::ITERATION_LIMIT));
  BOOST_TEST((stop.restarted()(FG::Shortening_step()) == FG::Stop_decision::CONTINUE));
  BOOST_TEST((statuses(stop) == complete));
  for(FG::Shortening_status status : statuses(FG::Time_stop_predicate(std::chrono::seconds(0))))
    BOOST_TEST((status == FG::Shortening_status::ITERATION_LIMIT));
  for(FG::Shortening_status status : statuses(FG::Time_stop_predicate(std::chrono::duration<double>(1e300))))
    BOOST_TEST((status == FG::Shortening_status::LOCALLY_SHORTEST));
}

BOOST_AUTO_TEST_CASE(each_leg_has_its_own_budget)
{
  const Surface mesh = to_mesh<Surface>(shaken(octahedron(6), 0.2, 5));
  std::vector<Vertex> way;
  for(int v = 0; v < 100; v += 9)
    way.push_back(vertex(v));
  const auto status = [&](std::size_t budget) {
    Sink out;
    return FG::geodesic_path_through(mesh, way, std::back_inserter(out),
                                     CGAL::parameters::stop_predicate(Budget_stop_predicate{budget}))
        .report.curves.front()
        .status;
  };
  BOOST_TEST((status(100) == FG::Shortening_status::LOCALLY_SHORTEST));
  BOOST_TEST((status(0) == FG::Shortening_status::ITERATION_LIMIT));
}
