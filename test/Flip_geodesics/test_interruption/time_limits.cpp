// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Long computations with a limit of no time, which stops them at the first call, and with one that is never reached.

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "test_interruption/stopping.h"

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/isolines.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/shortest_paths_by_class.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <chrono>
#include <iterator>
#include <string>
#include <vector>

namespace {

struct Time_limits
{
  Mesh mesh = to_mesh<Mesh>(bumpy_sphere(32, 0.3, 1));
  Triangulation triangulation{mesh};
  Mesh::Vertex_index source{0}, target{static_cast<Mesh::size_type>(mesh.number_of_vertices() - 1)};
  std::vector<Mesh::Point> points;

  static auto no_time() { return CGAL::parameters::visitor(FG::Time_stop_predicate(std::chrono::seconds(0))); }
  static auto enough() { return CGAL::parameters::visitor(FG::Time_stop_predicate(std::chrono::hours(1000))); }

  // Calls a function with both limits.
  template <class Compute>
  void check(const std::string& name, const Compute& compute)
  {
    BOOST_TEST_CONTEXT(name)
    {
      BOOST_TEST(std::string(compute(no_time())) == "STOPPED_BY_VISITOR");
      BOOST_TEST(std::string(compute(enough())) != "STOPPED_BY_VISITOR");
    }
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(computations_end_when_their_time_is_up, Time_limits)
{
  check("geodesic_path", [&](const auto& np) {
    return FG::to_string(FG::geodesic_path(mesh, source, target, std::back_inserter(points), np).status());
  });
  check("shortest_path", [&](const auto& np) {
    return FG::to_string(FG::shortest_path(mesh, source, target, std::back_inserter(points), np).status());
  });
  check("shortest_paths_by_class", [&](const auto& np) {
    std::vector<std::vector<Mesh::Point>> paths;
    return FG::to_string(FG::shortest_paths_by_class(mesh, source, target, 2, std::back_inserter(paths), np).status());
  });
  check("geodesic_distances", [&](const auto& np) {
    std::vector<double> distances(mesh.number_of_vertices());
    const auto map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
    return FG::to_string(FG::geodesic_distances(mesh, source, map, np).status);
  });
  check("Geodesic_distance_field", [&](const auto& np) {
    FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
    field.add_source(0_v);
    return FG::to_string(field.compute(np).status);
  });
  check("Geodesic_tree", [&](const auto& np) {
    Triangulation flipped(mesh);
    return FG::to_string(FG::Geodesic_tree<Triangulation>(flipped).grow(0_v, np).status);
  });
}

BOOST_FIXTURE_TEST_CASE(computations_without_a_status_have_no_result_when_their_time_is_up, Time_limits)
{
  FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
  field.add_source(0_v);
  field.compute();
  std::vector<FG::Isoline<Mesh>> isolines;
  const std::vector<double> levels = {0.5};
  FG::isolines(mesh, field, levels, std::back_inserter(isolines), 0.1, no_time());
  BOOST_TEST(isolines.empty());
  FG::isolines(mesh, field, levels, std::back_inserter(isolines), 0.1, enough());
  BOOST_TEST(!isolines.empty());
  const std::vector<FG::Vertex_index> none;
  BOOST_TEST(!FG::Loop_basis<Triangulation>(triangulation, none, no_time()).is_complete());
  BOOST_TEST(FG::Loop_basis<Triangulation>(triangulation, none, enough()).is_complete());
  BOOST_TEST(!FG::geodesic_landmarks(mesh, 2, no_time()).is_complete());
  BOOST_TEST(FG::geodesic_landmarks(mesh, 2, enough()).is_complete());
}

// One object limits the time of both.
BOOST_FIXTURE_TEST_CASE(a_time_limit_is_a_predicate_and_a_visitor, Time_limits)
{
  const FG::Time_stop_predicate limit(std::chrono::seconds(0));
  const auto stopped =
      FG::geodesic_path(mesh, source, target, std::back_inserter(points), CGAL::parameters::stop_predicate(limit));
  BOOST_TEST((stopped.status() == FG::Shortening_status::ITERATION_LIMIT));
  const auto interrupted = FG::geodesic_path(mesh, source, target, std::back_inserter(points),
                                             CGAL::parameters::stop_predicate(limit), CGAL::parameters::visitor(limit));
  BOOST_TEST((interrupted.status() == FG::Shortening_status::STOPPED_BY_VISITOR));
}
