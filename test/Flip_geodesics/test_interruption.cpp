// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Long computations are stopped at each call of a visitor in turn. A stopped one has the status that says so, confirms
// nothing, writes nothing, and leaves its object usable.

#define BOOST_TEST_MODULE interruption

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "test_interruption/stopping.h"

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/shortest_paths_by_class.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace {

using Mesh_vertex = FG::Mesh_vertex<Mesh>;
using Field = FG::Geodesic_distance_field<Triangulation>;
using Tree = FG::Geodesic_tree<Triangulation>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A property map that counts what is written.
template <class Value>
struct Counting_map
{
  using key_type = Mesh_vertex;
  using value_type = Value;
  using reference = void;
  using category = boost::writable_property_map_tag;

  std::size_t* number;

  friend void put(const Counting_map& map, const Mesh_vertex&, const Value&) { ++*map.number; }
};

// Rough, so that many paths of a tree are not shortest.
Mesh_soup rough_terrain()
{
  Random_numbers random(1);
  return mapped(flat_grid(8, 8, Diagonal_rule::RANDOM), [&](const Coordinates& p) {
    return Coordinates{p[0], p[1], random.uniform(0, 100)};
  });
}

template <class ConcurrencyTag>
void stop_field(FG::Distance_field_extent extent)
{
  const Setting setting(bumpy_sphere(8, 0.2, 3));
  const std::vector<Vertex_index> all(descriptors<Vertex_index>(setting.triangulation.number_of_vertices()).begin(),
                                      descriptors<Vertex_index>(setting.triangulation.number_of_vertices()).end());
  Field expected(setting.triangulation, setting.mesh, CGAL::parameters::extent(extent));
  expected.add_source(3_v);
  const auto complete = expected.compute();
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    Field field(setting.triangulation, setting.mesh, CGAL::parameters::extent(extent));
    field.add_source(3_v);
    const auto report = field.template compute<ConcurrencyTag>(CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(FG::to_string(report.status) == std::string(is_stopped ? "STOPPED_BY_VISITOR" : "COMPLETE"));
    BOOST_TEST((field.reach() < infinity) == is_stopped);
    for(const Vertex_index v : all)
      BOOST_TEST(field.distance(v) == (expected.distance(v) <= field.reach() ? expected.distance(v) : infinity));
    const auto resumed = field.compute();
    BOOST_TEST((resumed.status == FG::Distance_field_status::COMPLETE));
    BOOST_TEST(resumed.windows == complete.windows);
    for(const Vertex_index v : all)
      BOOST_TEST(field.distance(v) == expected.distance(v));
  });
  BOOST_TEST(calls > 20u);
}

template <class Report>
bool is_stopped_by_visitor(const Report& report)
{
  return report.status == FG::Shortening_status::STOPPED_BY_VISITOR;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_distance_field)
{
  stop_field<CGAL::Sequential_tag>(FG::Distance_field_extent::EVERYWHERE);
  stop_field<CGAL::Sequential_tag>(FG::Distance_field_extent::VERTICES_ONLY);
#ifdef CGAL_LINKED_WITH_TBB
  stop_field<CGAL::Parallel_tag>(FG::Distance_field_extent::EVERYWHERE);
#endif
}

// Limits that are reached are not taken for a stop. What is computed on top may complete the field.
BOOST_AUTO_TEST_CASE(a_distance_field_up_to_targets)
{
  const Setting setting(bumpy_sphere(8, 0.2, 3));
  FG::Distance_field_limits limits;
  limits.targets = {setting.triangulation.location(0_v), setting.triangulation.location(40_v)};
  stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    Field field(setting.triangulation, setting.mesh);
    field.add_source(3_v);
    const auto report = field.compute(CGAL::parameters::search_limit(limits).visitor(std::ref(visitor)));
    BOOST_TEST(FG::to_string(report.status) == std::string(is_stopped ? "STOPPED_BY_VISITOR" : "TARGETS_REACHED"));
    const auto resumed = field.compute(CGAL::parameters::search_limit(limits)).status;
    BOOST_TEST(
        (resumed == FG::Distance_field_status::TARGETS_REACHED || resumed == FG::Distance_field_status::COMPLETE));
  });
}

// The map is the same as far as it is known.
BOOST_AUTO_TEST_CASE(a_logarithm)
{
  using Logarithm = FG::Logarithmic_map<Triangulation>;
  const Setting setting(bumpy_sphere(6, 0.2, 3));
  const FG::Surface_location source = setting.triangulation.location(3_v);
  const Logarithm expected(setting.triangulation, setting.mesh, source);
  stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    const Logarithm logarithm(setting.triangulation, setting.mesh, source,
                              CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(FG::to_string(logarithm.report().status) == std::string(is_stopped ? "STOPPED_BY_VISITOR" : "COMPLETE"));
    for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices())) {
      const bool is_known = expected.distance_field().distance(v) <= logarithm.distance_field().reach();
      BOOST_TEST(logarithm(v).radius == (is_known ? expected(v).radius : infinity));
    }
  });
}

BOOST_AUTO_TEST_CASE(a_tree)
{
  Setting setting(rough_terrain());
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    Tree tree(setting.triangulation);
    BOOST_TEST(is_stopped_by_visitor(tree.grow(0_v, CGAL::parameters::visitor(std::ref(visitor)))) == is_stopped);
    BOOST_TEST((tree.grow(0_v).status == FG::Shortening_status::LOCALLY_SHORTEST));
    BOOST_TEST(tree.is_valid());
    setting.triangulation.rollback();
  });
  BOOST_TEST(calls > 100u);
}

// In the search the tree stays as it is. Afterwards each path is replaced or grown again.
BOOST_AUTO_TEST_CASE(a_tree_that_is_made_shortest)
{
  Setting setting(rough_terrain());
  std::vector<double> lengths;
  std::size_t partly_repaired = 0, longer = 0;
  const auto is_as_long = [&](const Tree& tree) {
    bool result = true;
    for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices()))
      result = result && std::abs(tree.distance(v) - lengths[static_cast<std::size_t>(v.idx())]) < 1e-10;
    return result;
  };
  {
    Tree tree(setting.triangulation);
    tree.grow(0_v);
    const auto report = FG::make_shortest(tree);
    BOOST_TEST(report.is_confirmed());
    BOOST_TEST(report.longer == 0u);
    longer = report.longer_before;
    for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices()))
      lengths.push_back(tree.distance(v));
    setting.triangulation.rollback();
  }
  BOOST_TEST(longer > 1u);
  stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    Tree tree(setting.triangulation);
    tree.grow(0_v);
    const auto report = FG::make_shortest(tree, CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(is_stopped_by_visitor(report) == is_stopped);
    BOOST_TEST(report.is_confirmed() == !is_stopped);
    BOOST_TEST(tree.is_valid());
    partly_repaired += is_stopped && report.longer < longer && report.flips > 0 ? 1 : 0;
    const auto again = FG::make_shortest(tree);
    BOOST_TEST(again.is_confirmed());
    BOOST_TEST(again.longer == 0u);
    BOOST_TEST(is_as_long(tree));
    setting.triangulation.rollback();
  });
  BOOST_TEST(partly_repaired > 0u);
}

// From a field; and from a tree that is grown since the field is given up.
BOOST_AUTO_TEST_CASE(values_at_vertices)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(8, 0.2, 3));
  const Mesh_vertex source = *vertices(mesh).begin();
  const std::vector<Mesh_vertex> sources(vertices(mesh).begin(), std::next(vertices(mesh).begin(), 3));
  for(const FG::Window_limit& limit : {FG::Window_limit(), FG::Window_limit(500)}) {
    const auto check = [&](const auto& compute) {
      const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
        std::size_t number = 0;
        const FG::Distances_report report = compute(&number, CGAL::parameters::visitor(std::ref(visitor)));
        BOOST_TEST(is_stopped_by_visitor(report) == is_stopped);
        BOOST_TEST(number == (is_stopped ? 0 : num_vertices(mesh)));
        BOOST_TEST((!is_stopped || !report.is_confirmed()));
      });
      BOOST_TEST(calls > 5u);
    };
    check([&](std::size_t* number, const auto& np) {
      return FG::geodesic_distances(mesh, source, Counting_map<double>{number}, np,
                                    CGAL::parameters::search_limit(limit));
    });
    check([&](std::size_t* number, const auto& np) {
      return FG::geodesic_distances(mesh, sources, Counting_map<double>{number}, np,
                                    CGAL::parameters::search_limit(limit));
    });
    check([&](std::size_t* number, const auto& np) {
      return FG::logarithmic_map(mesh, source, Counting_map<FG::Polar_coordinates>{number}, np,
                                 CGAL::parameters::search_limit(limit));
    });
  }
}

BOOST_AUTO_TEST_CASE(paths_of_several_classes)
{
  using Curve = std::vector<Mesh::Point>;
  const Mesh mesh = to_mesh<Mesh>(genus_3_plate());
  const Mesh_vertex source(0), target(static_cast<unsigned>(mesh.number_of_vertices() / 2));
  std::vector<Curve> expected;
  const auto complete = FG::shortest_paths_by_class(mesh, source, target, 4, std::back_inserter(expected));
  BOOST_TEST(expected.size() == 4u);
  BOOST_TEST(complete.report.is_confirmed());
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    std::vector<Curve> curves;
    const auto result = FG::shortest_paths_by_class(mesh, source, target, 4, std::back_inserter(curves),
                                                    CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(FG::to_string(result.status()) ==
               std::string(is_stopped ? "STOPPED_BY_VISITOR" : FG::to_string(complete.status())));
    BOOST_TEST(result.report.is_confirmed() == !is_stopped);
    BOOST_TEST((curves == (is_stopped ? std::vector<Curve>() : expected)));
    BOOST_TEST(result.number_of_curves() == curves.size());
    BOOST_TEST(result.report.lower_bound_of_others() == (is_stopped ? 0 : complete.report.lower_bound_of_others()));
  });
  BOOST_TEST(calls > 20u);
}
