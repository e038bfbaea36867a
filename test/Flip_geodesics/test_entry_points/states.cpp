// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Objects that are used before they have been computed, or after their computation has been stopped.

#include "test_entry_points/entry_points.h"

using namespace Flip_geodesics_test;

namespace {

using Field = FG::Geodesic_distance_field<Triangulation>;

struct Stopping : FG::Default_shortening_visitor
{
  bool go_further() { return false; }
};

template <class Function>
void check_not_computed(const std::string& what, const Function& function)
{
  const auto is_clear = [](const FG::Invalid_parameter_error& error) {
    return std::string(error.what()).find("before it has been") != std::string::npos;
  };
  BOOST_TEST_CONTEXT(what) { BOOST_CHECK_EXCEPTION(function(), FG::Invalid_parameter_error, is_clear); }
}

} // namespace

BOOST_AUTO_TEST_CASE(a_field_is_computed_before_it_is_used)
{
  const Surface mesh = to_mesh<Surface>(octahedron(3));
  const Triangulation triangulation(mesh);
  Field field(triangulation, mesh);
  const FG::Surface_location inside = {0_input_h, {{1, 1, 1}}};
  field.add_source(0_v);
  std::vector<double> distances(mesh.number_of_vertices());
  std::vector<std::size_t> sources(mesh.number_of_vertices());
  const auto distance_map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  const auto source_map = boost::make_iterator_property_map(sources.begin(), get(boost::vertex_index, mesh));
  std::vector<FG::Isoline<Surface>> isolines;
  std::vector<FG::Voronoi_boundary<Surface>> boundaries;
  Sink points;
  const std::vector<std::pair<std::string, std::function<void()>>> uses = {
      {"distance of a vertex", [&] { field.distance(0_v); }},
      {"distance", [&] { field.distance(inside); }},
      {"answer of a vertex", [&] { field.answer(3_v); }},
      {"answer", [&] { field.answer(inside); }},
      {"operator()",
       [&] {
         field(Face(0), {{1, 1, 1}});
       }},
      {"surface_points", [&] { field.surface_points(inside); }},
      {"path", [&] { field.path(inside, std::back_inserter(points)); }},
      {"gradient", [&] { field.gradient(inside); }},
      {"gradient_in_space", [&] { field.gradient_in_space(inside); }},
      {"isolines", [&] { FG::isolines(mesh, field, std::vector<double>{0.5}, std::back_inserter(isolines), 0.1); }},
      {"voronoi_boundaries", [&] { FG::voronoi_boundaries(mesh, field, std::back_inserter(boundaries), 0.1); }},
      {"put_distances", [&] { FG::put_distances(field, triangulation, mesh, distance_map); }},
      {"put_nearest_sources", [&] { FG::put_nearest_sources(field, triangulation, mesh, source_map); }}};
  for(const auto& [name, use] : uses)
    check_not_computed(name, use);
  BOOST_TEST(field.reach() == 0);
  BOOST_TEST(!field.has_one_source(Face(0)));
  BOOST_TEST((isolines.empty() && boundaries.empty()));
  field.compute();
  for(const auto& [name, use] : uses)
    BOOST_TEST_CONTEXT(name) { BOOST_CHECK_NO_THROW(use()); }
  BOOST_TEST(!isolines.empty());
  BOOST_CHECK_THROW(field.add_source(1_v), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(field.add_curve(std::vector<FG::Surface_location>{inside}), FG::Invalid_parameter_error);
}

BOOST_AUTO_TEST_CASE(a_tree_is_grown_before_it_is_used)
{
  const Surface mesh = to_mesh<Surface>(octahedron(3));
  Triangulation triangulation(mesh);
  FG::Geodesic_tree<Triangulation> tree(triangulation);
  std::vector<double> distances(mesh.number_of_vertices());
  const auto distance_map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  const std::vector<std::pair<std::string, std::function<void()>>> uses = {
      {"make_shortest", [&] { FG::make_shortest(tree); }},
      {"logarithmic_map", [&] { FG::logarithmic_map(tree); }},
      {"put_distances", [&] { FG::put_distances(tree, mesh, distance_map); }},
      {"replace_paths", [&] { tree.replace_paths([](auto&) {}); }}};
  for(const auto& [name, use] : uses)
    check_not_computed(name, use);
  tree.grow(0_v);
  for(const auto& [name, use] : uses)
    BOOST_TEST_CONTEXT(name) { BOOST_CHECK_NO_THROW(use()); }
}

BOOST_AUTO_TEST_CASE(a_spline_is_finished_before_it_is_measured)
{
  const Surface mesh = to_mesh<Surface>(octahedron(3));
  Triangulation triangulation(mesh);
  FG::Geodesic_spline<Triangulation> spline(
      triangulation, std::vector<FG::Surface_location>{{0_input_h, {{1, 1, 1}}}, {6_input_h, {{1, 1, 1}}}},
      FG::Spline_kind::BEZIER);
  check_not_computed("length", [&] { spline.length(); });
  check_not_computed("status", [&] { spline.status(); });
  check_not_computed("verdict", [&] { spline.verdict(); });
  spline.finish();
  BOOST_TEST(spline.length() > 0);
}

BOOST_AUTO_TEST_CASE(a_basis_that_was_stopped_is_not_used)
{
  const Surface mesh = to_mesh<Surface>(octahedron(3));
  const Triangulation triangulation(mesh);
  const FG::Loop_basis<Triangulation> basis(triangulation, Vertex_sequence(), CGAL::parameters::visitor(Stopping()));
  BOOST_TEST(!basis.is_complete());
  BOOST_TEST(basis.number_of_loops() == 0);
  const std::vector<FG::Input_halfedge_index> chain = {0_input_h, 1_input_h};
  BOOST_CHECK_THROW(basis.loop(0), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(basis.cycle(0), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(basis.length(0), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(basis.component(0_v), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(basis.homology_class(chain), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(basis.is_contractible(chain), FG::Invalid_parameter_error);
  BOOST_CHECK_NO_THROW(FG::Loop_basis<Triangulation>(triangulation).homology_class(chain));
}
