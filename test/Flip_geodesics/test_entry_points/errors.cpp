// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Errors name the elements of the mesh or of the input to which they refer, in their messages and by their elements.

#include "test_entry_points/entry_points.h"

using namespace Flip_geodesics_test;

namespace {

template <class Error, class Function>
void check_elements(const Function& function, const std::vector<std::size_t>& elements, const std::string& begin)
{
  BOOST_CHECK_EXCEPTION(function(), Error, [&](const Error& error) {
    BOOST_TEST(error.elements() == elements, error.what());
    BOOST_TEST(std::string(error.what()).find(begin) == 0, error.what());
    return true;
  });
}

} // namespace

BOOST_AUTO_TEST_CASE(errors_name_the_position_of_a_point)
{
  Surface mesh = to_mesh<Surface>(octahedron(2));
  const Vertex isolated = mesh.add_vertex(Point(9, 9, 9)), none = Surface::null_vertex();
  const std::size_t i = isolated;
  Triangulation t(mesh);
  Network network(t);
  Sink out;
  const FG::Surface_location good = {0_input_h, {{1, 1, 1}}}, bad = {0_input_h, {{1, -1, 1}}},
                             outside = {FG::null_index, {{1, 0, 0}}};
  const std::vector<FG::Surface_location> curve = {good, good, bad}, elsewhere = {good, outside};
  using Location_error = FG::Invalid_location_error;
  using Vertex_error = FG::Vertex_out_of_range_error;
  check_elements<Location_error>([&] { FG::surface_point(t, bad); }, {0}, "a weight of a location");
  check_elements<Location_error>(
      [&] {
        FG::surface_location(t, mesh, Face_location{Face(3), {{2, 2, 2}}});
      },
      {static_cast<std::size_t>(t.input().index(mesh.halfedge(Face(3))).idx())},
      "a barycentric coordinate of a location in the face of halfedge");
  check_elements<Location_error>([&] { FG::geodesics_through(t, curve); }, {2}, "point 2: a weight of a location");
  check_elements<Location_error>([&] { FG::geodesics_through(t, elsewhere); }, {1}, "point 1: a location has a face");
  check_elements<Location_error>([&] { FG::add_curve_through(network, curve); }, {2}, "point 2: ");
  check_elements<Location_error>([&] { FG::complete_polyline(t, curve); }, {2}, "point 2: ");
  check_elements<Location_error>([&] { FG::geodesic_path_through(mesh, curve, std::back_inserter(out)); }, {2},
                                 "point 2: ");
  check_elements<Location_error>([&] { FG::geodesic_path(mesh, good, bad, std::back_inserter(out)); }, {1},
                                 "point 1: ");
  check_elements<Location_error>([&] { FG::shortest_path(mesh, bad, good, std::back_inserter(out)); }, {0},
                                 "point 0: ");
  check_elements<Vertex_error>([&] { FG::surface_location(t, mesh, isolated); }, {i},
                               "a location is at vertex " + std::to_string(i));
  check_elements<Vertex_error>([&] { FG::surface_location(t, mesh, none); }, {}, "a given vertex is not a vertex of the mesh");
  check_elements<Vertex_error>(
      [&] {
        FG::complete_polyline(t, std::vector<Vertex>{vertex(0), isolated});
      },
      {1}, "point 1: a location is at vertex " + std::to_string(i));
  check_elements<Vertex_error>([&] { FG::shortest_path(mesh, vertex(0), none, std::back_inserter(out)); }, {},
                               "the target is not one of");
  check_elements<Vertex_error>([&] { FG::geodesic_path(mesh, none, vertex(0), std::back_inserter(out)); }, {},
                               "the source is not one of");
  check_elements<Vertex_error>(
      [&] {
        FG::halfedges_through(t, Vertex_sequence{0_v, FG::null_index});
      },
      {1}, "a given vertex at position 1 of a curve");
}

BOOST_AUTO_TEST_CASE(numbers_of_iterations_are_parameters)
{
  const Surface mesh = to_mesh<Surface>(octahedron(2));
  const std::vector<Vertex> points = {vertex(0), vertex(5), vertex(9)};
  Sink out;
  const auto spline = [&](auto number) {
    FG::geodesic_spline(mesh, points, FG::Spline_kind::BEZIER, std::back_inserter(out),
                        CGAL::parameters::number_of_iterations(number));
  };
  check_elements<FG::Invalid_parameter_error>([&] { spline(-1); }, {}, "number_of_iterations is -1");
  check_elements<FG::Invalid_parameter_error>([&] { spline(31u); }, {}, "number_of_iterations is 31");
  BOOST_TEST(out.empty());
  BOOST_CHECK_NO_THROW(spline(0));
  Triangulation t(mesh);
  check_elements<FG::Invalid_parameter_error>(
      [&] { FG::flip_to_delaunay(t, CGAL::parameters::number_of_iterations(-1)); }, {}, "number_of_iterations is -1");
}

BOOST_AUTO_TEST_CASE(errors_name_their_elements)
{
  const Surface mesh = to_mesh<Surface>(octahedron(2));
  Triangulation t(mesh);
  FG::Geodesic_distance_field<Triangulation> field(t, mesh);
  field.add_source(0_v, 1);
  check_elements<FG::Invalid_coordinate_error>([&] { field.add_source(1_v, -1); }, {1}, "the offset of source 1 is -1");
  check_elements<FG::Invalid_coordinate_error>([&] { field.add_source(1_v, 1e20); }, {1},
                                               "the offset of source 1 is 1e+20");
  FG::Geodesic_distance_field<Triangulation> of_vertices(
      t, mesh, CGAL::parameters::extent(FG::Distance_field_extent::VERTICES_ONLY));
  of_vertices.add_source(0_v);
  of_vertices.compute();
  check_elements<FG::Invalid_parameter_error>(
      [&] {
        of_vertices.distance(FG::Surface_location{0_input_h, {{1, 1, 1}}});
      },
      {0}, "a field with the extent VERTICES_ONLY is queried in the face of halfedge 0");
  FG::Geodesic_tree<Triangulation> tree(t);
  tree.grow(3_v);
  const FG::Input_halfedge_index elsewhere = t.input().outgoing(1_v);
  check_elements<FG::Invalid_location_error>([&] { FG::logarithmic_map(tree, elsewhere); },
                                             {static_cast<std::size_t>(elsewhere.idx())}, "the halfedge of angle zero");
  Network network(t);
  const auto first = t.outgoing(0_v), second = t.next(first);
  network.add_curve(Halfedge_sequence{first, second, t.next(second)});
  network.add_curve(Halfedge_sequence{first, second});
  const FG::Input_halfedge_index occupied = FG::internal::as_input(first);
  check_elements<FG::Occupied_triangulation_error>(
      [&] {
        t.insert(FG::Surface_location{occupied, {{1, 1, 0}}});
      },
      {static_cast<std::size_t>(occupied.idx())}, "a point in the face of halfedge ");
  const FG::Loop_basis<Triangulation> basis(t);
  check_elements<FG::Invalid_curve_error>([&] { basis.homology_class(network, 1_c); }, {1}, "curve 1 does not end");
}

// Two closed umbrellas that share a vertex only.
BOOST_AUTO_TEST_CASE(errors_name_the_vertex_at_which_umbrellas_meet)
{
  Surface mesh;
  std::vector<Vertex> v;
  for(int i = 0; i < 7; ++i)
    v.push_back(mesh.add_vertex(Point(i % 4, i % 3, i)));
  const auto add_tetrahedron = [&](int a, int b, int c, int d) {
    for(const std::array<int, 3>& f : {std::array<int, 3>{{a, b, c}}, {{a, c, d}}, {{a, d, b}}, {{b, d, c}}})
      BOOST_REQUIRE(mesh.add_face(v[static_cast<std::size_t>(f[0])], v[static_cast<std::size_t>(f[1])],
                                  v[static_cast<std::size_t>(f[2])]) != Surface::null_face());
  };
  add_tetrahedron(0, 1, 2, 3);
  const Vertex apex = mesh.add_vertex(Point(9, 9, 9));
  v[0] = apex;
  add_tetrahedron(0, 4, 5, 6);
  for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(apex), mesh))
    mesh.set_target(h, vertex(0));
  mesh.set_halfedge(apex, Surface::null_halfedge());
  const Triangulation triangulation(mesh);
  check_elements<FG::Invalid_mesh_error>([&] { FG::Loop_basis<Triangulation>{triangulation}; }, {0},
                                         "several umbrellas of faces meet at vertex 0");
}
