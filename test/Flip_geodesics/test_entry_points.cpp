// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Each public function, and each class by its constructor, on meshes that it was not made for, and with elements that
// the mesh does not have: it throws an exception of the package, or is right, and comes to an end.

#define BOOST_TEST_MODULE entry_points

#include "test_entry_points/entry_points.h"

using namespace Flip_geodesics_test;

// ---------------------------------------------------------------- polygons

BOOST_AUTO_TEST_CASE(triangles_are_no_obstacle)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::ALTERNATING));
  for(const Entry_point& entry : entry_points())
    BOOST_TEST(thrown(entry, mesh, vertex(8), vertex(30)) == "", entry.name);
}

// Also the way from the first vertex to the last, on which a search for a strip of triangles used not to end.
BOOST_AUTO_TEST_CASE(a_mesh_of_quads_is_refused)
{
  const Surface mesh = quad_cube();
  for(const Entry_point& entry : entry_points()) {
    const std::string error = thrown<FG::Invalid_mesh_error>(entry, mesh, vertex(0), vertex(7));
    BOOST_TEST(error.empty() == (entry.reach == Reach::EDGES), entry.name);
    BOOST_TEST((error.empty() || error.find("is not a triangle") != std::string::npos), entry.name << ": " << error);
  }
}

BOOST_AUTO_TEST_CASE(a_polygon_in_the_way_is_refused_or_not_met)
{
  for(const int n : {5, 6, 9}) {
    const Surface mesh = grid_with_polygon(n, 2, n - 2);
    const std::vector<std::pair<int, int>> ends = {
        {0, static_cast<int>(mesh.number_of_vertices()) - 1}, {n / 2, n + 1 + n / 2}, {2 * (n + 1), 3 * (n + 1) - 1}};
    for(const auto& [v, w] : ends)
      for(const Entry_point& entry : entry_points()) {
        const std::string error = thrown<FG::Invalid_mesh_error>(entry, mesh, vertex(v), vertex(w));
        BOOST_TEST((entry.reach != Reach::WHOLE || !error.empty()), entry.name);
        BOOST_TEST((entry.reach != Reach::EDGES || error.empty()), entry.name);
      }
  }
}

BOOST_AUTO_TEST_CASE(a_polygon_elsewhere_is_no_obstacle)
{
  const Surface mesh = grid_with_polygon(16, 12, 14);
  for(const Entry_point& entry : entry_points())
    BOOST_TEST(thrown<FG::Invalid_mesh_error>(entry, mesh, vertex(36), vertex(55)).empty() ==
                   (entry.reach != Reach::WHOLE),
               entry.name);
}

BOOST_AUTO_TEST_CASE(a_face_of_two_sides_is_refused)
{
  Surface mesh = to_mesh<Surface>(octahedron(1));
  add_digon(mesh, mesh.halfedge(Vertex(0)));
  for(const Entry_point& entry : entry_points()) {
    const std::string error = thrown<FG::Invalid_mesh_error>(entry, mesh, vertex(0), vertex(1));
    BOOST_TEST((entry.reach != Reach::WHOLE || !error.empty()), entry.name);
  }
}

BOOST_AUTO_TEST_CASE(the_error_names_the_face)
{
  try {
    Sink out;
    FG::geodesic_path(quad_cube(), vertex(0), vertex(7), std::back_inserter(out));
    BOOST_ERROR("no exception");
  } catch(const FG::Invalid_mesh_error& error) {
    BOOST_TEST(error.elements().size() == 4u);
    for(std::size_t v : error.elements())
      BOOST_TEST(std::string(error.what()).find(std::to_string(v)) != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(removed_vertices_are_refused)
{
  Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::ALTERNATING));
  mesh.remove_vertex(mesh.add_vertex(Point(0, 0, 0)));
  for(const Entry_point& entry : entry_points())
    BOOST_TEST(!thrown<FG::Invalid_mesh_error>(entry, mesh, vertex(8), vertex(30)).empty(), entry.name);
  mesh.collect_garbage();
  for(const Entry_point& entry : entry_points())
    BOOST_TEST(thrown(entry, mesh, vertex(8), vertex(30)) == "", entry.name);
}

// An edge that nothing but two borders pass.
BOOST_AUTO_TEST_CASE(an_edge_in_no_face_is_refused)
{
  Surface mesh;
  const Vertex v = mesh.add_vertex(Point(0, 0, 0)), w = mesh.add_vertex(Point(1, 0, 0));
  const auto h = mesh.add_edge(v, w), t = mesh.opposite(h);
  for(const auto& [side, other] : {std::make_pair(h, t), std::make_pair(t, h)}) {
    mesh.set_next(side, other);
    mesh.set_halfedge(mesh.target(side), side);
  }
  for(const Entry_point& entry : entry_points())
    if(entry.reach == Reach::LOCAL)
      BOOST_TEST(!thrown(entry, mesh, v, w).empty(), entry.name);
}

// ---------------------------------------------------------------- elements that the mesh does not have

namespace {

// Does a call refuse vertices, without naming numbers that mean none?
void check_refusal(const Entry_point& entry, const Surface& mesh, Vertex v, Vertex w)
{
  const std::string error = thrown(entry, mesh, v, w);
  BOOST_TEST(!error.empty(), entry.name);
  for(const char* none : {"-1", "4294967295", "2147483647"})
    BOOST_TEST(error.find(none) == std::string::npos, entry.name << ": " << error);
}

bool takes_vertices(const Entry_point& entry)
{
  for(const Entry_point& other : functions_of_the_whole_mesh())
    if(entry.name == other.name)
      return false;
  return true;
}

} // namespace

BOOST_AUTO_TEST_CASE(vertices_that_the_mesh_does_not_have_are_refused)
{
  const std::vector<Surface> meshes = {Surface(), polygon_mesh({{0, 0, 0}, {1, 0, 0}}, {}),
                                       to_mesh<Surface>(flat_grid(3, 3, Diagonal_rule::RISING))};
  for(const Surface& mesh : meshes) {
    const Vertex after(static_cast<Surface::size_type>(mesh.number_of_vertices()));
    for(const Entry_point& entry : entry_points())
      if(takes_vertices(entry)) {
        check_refusal(entry, mesh, Surface::null_vertex(), Surface::null_vertex());
        check_refusal(entry, mesh, after, after);
        check_refusal(entry, mesh, Surface::null_vertex(), after);
        check_refusal(entry, mesh, Vertex(1000000000), vertex(0));
      }
  }
}

BOOST_AUTO_TEST_CASE(meshes_without_faces_are_no_obstacle)
{
  const std::vector<Surface> meshes = {Surface(), polygon_mesh({{0, 0, 0}, {1, 0, 0}}, {})};
  for(const Surface& mesh : meshes)
    for(const Entry_point& entry : entry_points()) {
      const std::string error = thrown(entry, mesh, vertex(0), vertex(1));
      const bool needs_vertices_alone = entry.name == "Geodesic_tree" ||
                                        entry.name == "Geodesic_landmarks of vertices" ||
                                        entry.name == "Shortest_edge_path::visit_all";
      const bool can_do_without = !takes_vertices(entry) || (!mesh.is_empty() && needs_vertices_alone);
      BOOST_TEST(error.empty() == can_do_without, entry.name << ": " << error);
    }
}

BOOST_AUTO_TEST_CASE(locations_that_are_no_points_are_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(3, 3, Diagonal_rule::RISING));
  const Triangulation triangulation(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Face face(0), after(static_cast<Surface::size_type>(mesh.number_of_faces()));
  const std::vector<Face_location> in_faces = {
      {Surface::null_face(), {{1, 0, 0}}}, {after, {{1, 0, 0}}},      {Face(1000000000), {{1, 0, 0}}},
      {face, {{nan, 0.5, 0.5}}},           {face, {{-0.5, 1, 0.5}}},  {face, {{0, 0, 0}}},
      {face, {{infinity, 0, 0}}},          {face, {{0.5, 0.5, 0.5}}}, {face, {{0, 0, nan}}}};
  for(const Face_location& p : in_faces)
    BOOST_CHECK_THROW(FG::surface_location(triangulation, mesh, p), FG::Invalid_location_error);

  const FG::Input_halfedge_index border = [&] {
    FG::Halfedge_index h = 0_h;
    while(!triangulation.is_border(h))
      ++h;
    return FG::internal::as_input(h);
  }();
  const FG::Input_halfedge_index end(triangulation.number_of_halfedges());
  const FG::Input_halfedge_index negative(-7), largest((std::numeric_limits<int>::max)());
  const std::vector<FG::Surface_location> locations = {{FG::null_index, {{1, 0, 0}}},   {end, {{1, 0, 0}}},
                                                       {negative, {{1, 1, 1}}},         {0_input_h, {{0, 0, 0}}},
                                                       {0_input_h, {{nan, 1, 1}}},      {0_input_h, {{1, -1, 1}}},
                                                       {0_input_h, {{infinity, 1, 1}}}, {0_input_h, {{1e-300, 1, 1}}},
                                                       {border, {{1, 1, 1}}},           {largest, {{1, 1, 1}}}};
  for(const FG::Surface_location& p : locations) {
    Triangulation t(mesh);
    Sink out;
    const std::vector<FG::Surface_location> way = {{0_input_h, {{1, 1, 1}}}, p};
    BOOST_CHECK_THROW(t.insert(p), FG::Invalid_location_error);
    BOOST_CHECK_THROW(FG::surface_point(t, p), FG::Invalid_location_error);
    BOOST_CHECK_THROW(FG::geodesics_through(t, way), FG::Invalid_location_error);
    BOOST_CHECK_THROW(FG::complete_polyline(t, way), FG::Invalid_location_error);
    BOOST_CHECK_THROW(FG::snap_polyline(t, way), FG::Invalid_location_error);
    BOOST_CHECK_THROW(FG::Geodesic_spline<Triangulation>(t, way, FG::Spline_kind::BEZIER), FG::Invalid_location_error);
    BOOST_CHECK_THROW(FG::geodesic_path_through(mesh, way, std::back_inserter(out)), FG::Invalid_location_error);
    Network network(t);
    BOOST_CHECK_THROW(FG::add_curve_through(network, way), FG::Invalid_location_error);
    BOOST_CHECK_THROW(FG::draw_polyline(network, way), FG::Invalid_location_error);
  }
}

BOOST_AUTO_TEST_CASE(chains_that_are_none_are_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(4, 4, Diagonal_rule::RISING));
  Triangulation triangulation(mesh);
  const int size = triangulation.number_of_halfedges();
  const FG::Halfedge_index end(size), beyond(size + 5);
  using Chain = Halfedge_sequence;
  for(const Chain& chain :
      {Chain{}, Chain{FG::null_index}, Chain{end}, Chain{0_h, 7_h}, Chain{0_h, beyond}, Chain{12_h, 0_h, 31_h}})
  {
    Network network(triangulation);
    BOOST_CHECK_THROW(network.add_curve(chain), FG::Invalid_curve_error);
    BOOST_CHECK_THROW(FG::add_straightened_path(network, chain), FG::Invalid_curve_error);
    BOOST_TEST(network.number_of_curves() == 0);
  }
  // The error names the first halfedge that does not go on from the one before.
  const FG::Halfedge_index onward = triangulation.next(0_h);
  for(const Chain& chain : {Chain{onward, onward}, Chain{0_h, onward, onward}, Chain{0_h, onward, end, end}}) {
    Network network(triangulation);
    const auto is_named = [&](const FG::Invalid_curve_error& error) {
      return error.elements() == std::vector<std::size_t>{chain.size() == 4 ? 2 : chain.size() - 1};
    };
    BOOST_CHECK_EXCEPTION(network.add_curve(chain), FG::Invalid_curve_error, is_named);
  }
}

BOOST_AUTO_TEST_CASE(a_direction_zero_elsewhere_is_refused)
{
  const Surface mesh = to_mesh<Surface>(octahedron(2));
  Triangulation triangulation(mesh);
  FG::Geodesic_tree<Triangulation> tree(triangulation);
  tree.grow(0_v);
  const FG::Input_halfedge_index negative(-2), end(triangulation.number_of_halfedges());
  for(FG::Input_halfedge_index h : {negative, end, triangulation.input().outgoing(1_v)})
    BOOST_CHECK_THROW(FG::logarithmic_map(tree, h), FG::Invalid_location_error);
  BOOST_CHECK_NO_THROW(FG::logarithmic_map(tree, triangulation.input().outgoing(0_v)));
}
