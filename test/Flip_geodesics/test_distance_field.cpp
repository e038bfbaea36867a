// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE distance_field

#include "test_distance_field/asked_surface.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(distances_of_vertices_are_those_of_the_window_search)
{
  for(const auto& [name, soup] : meshes()) {
    const Asked_surface s(soup);
    for(int v : {0, s.triangulation.number_of_vertices() / 2}) {
      FG::internal::Unfolded_faces<Triangulation> faces(s.triangulation);
      FG::internal::Window_search<Triangulation> search(s.triangulation, faces, Vertex_index(v));
      search.run(infinity);
      for(const auto extent : {FG::Distance_field_extent::EVERYWHERE, FG::Distance_field_extent::VERTICES_ONLY}) {
        Field field(s.triangulation, s.mesh, CGAL::parameters::extent(extent));
        BOOST_TEST(field.add_source(Vertex_index(v)) == 0u);
        const auto report = field.compute();
        BOOST_TEST((report.status == FG::Distance_field_status::COMPLETE));
        BOOST_TEST(!report.has_flat_face);
        BOOST_TEST(report.windows <= search.number_of_windows() + 100);
        for(Vertex_index w : descriptors<Vertex_index>(s.triangulation.number_of_vertices()))
          BOOST_TEST(std::abs(field.distance(w) - search.distance(w)) <= 1e-11 * search.distance(w), name << w);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_paths_and_gradients_anywhere_agree_with_cgal)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Exact_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Method = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Exact_mesh>>;
  std::mt19937 random(7);
  for(const auto& [name, soup] : meshes()) {
    if(name == "flat grid") // there it is CGAL's that are too long
      continue;
    const Asked_surface s(soup);
    const Exact_mesh mesh = to_mesh<Exact_mesh>(soup);
    Method method(mesh);
    Field field(s.triangulation, s.mesh);
    const auto face_location = [&](const Location& p) {
      return FG::face_location(s.triangulation, s.mesh, surface_point(s.triangulation, p));
    };
    for(int i = 0; i < 3; ++i) {
      Location source = s.random_location(random);
      while(kind(source) != FG::Location_kind::FACE) // CGAL's are wrong for sources at vertices told by a face
        source = s.random_location(random);
      const auto [face, weights] = face_location(source);
      method.add_source_point(face, {{weights[0], weights[1], weights[2]}});
      field.add_source(source);
    }
    field.compute();
    int too_long = 0;
    for(int i = 0; i < 1000; ++i) {
      const Location at = s.random_location(random);
      const auto [face, weights] = face_location(at);
      const double expected =
          method.shortest_distance_to_source_points(face, {{weights[0], weights[1], weights[2]}}).first;
      const auto answer = field.answer(at);
      BOOST_TEST(answer.distance <= expected + 1e-9 * (1 + expected), name);
      if(answer.distance < expected - 1e-9 * (1 + expected)) { // where faces lie in one plane, CGAL's can be too long
        check_path(s, field, at, 1 + expected);
        ++too_long;
      }
      const auto in_face = field(face, weights);
      check_close(answer.distance, in_face.distance, 1 + expected, name);
      if(i % 10 == 0)
        check_path(s, field, at, 1 + expected);
      if(i % 10 == 0 && answer.distance > 1e-2)
        check_gradient(s, field, at);
    }
    BOOST_TEST(too_long <= (name == "saddle" ? 30 : 0), name);
  }
}

BOOST_AUTO_TEST_CASE(distances_in_the_plane)
{
  std::mt19937 random(3);
  const Asked_surface s(flat_grid(14, 14, Diagonal_rule::RANDOM));
  for(int round = 0; round < 5; ++round) {
    Field field(s.triangulation, s.mesh);
    std::vector<Point> sources;
    std::vector<double> offsets;
    for(int i = 0; i < 4; ++i) {
      const Location source = s.random_location(random);
      sources.push_back(s.at(source));
      offsets.push_back(0.5 * i);
      field.add_source(source, offsets.back());
    }
    field.compute();
    for(int i = 0; i < 300; ++i) {
      const Location at = s.random_location(random);
      double nearest = infinity;
      for(std::size_t k = 0; k < sources.size(); ++k)
        nearest = (std::min)(nearest, offsets[k] + distance_in_space(s.at(at), sources[k]));
      const auto answer = field.answer(at);
      check_close(answer.distance, nearest, 1 + nearest, "plane");
      check_close(offsets[answer.source] + distance_in_space(s.at(at), sources[answer.source]), nearest, 1 + nearest,
                  "nearest source");
    }
  }
}

// Almost as near to all places as the first source lets it be, the second one is the nearest in a narrow region only:
// on edges across it, in the middle. The same beside a row of edges, whose rays are parallel.
BOOST_AUTO_TEST_CASE(narrow_regions_in_the_plane)
{
  std::mt19937 random(17);
  const Asked_surface s(flat_grid(5, 5, Diagonal_rule::RANDOM));
  std::vector<Location> row;
  for(int i = 0; i <= 5; ++i)
    row.push_back(s.vertex(grid_vertex(5, i, 2)));
  for(int round = 0; round < 60; ++round) {
    const Location first = s.random_location(random), second = s.random_location(random);
    const Point p = s.at(first), q = s.at(second);
    const double offset = (round % 2 == 0 ? 0.97 : 0.995) * distance_in_space(p, q);
    Field field(s.triangulation, s.mesh);
    field.add_source(round % 3 == 0 ? second : first, round % 3 == 0 ? offset : 0);
    field.add_source(round % 3 == 0 ? first : second, round % 3 == 0 ? 0 : offset);
    field.compute();
    for(int i = 0; i < 300; ++i) {
      const Location at = s.random_location(random);
      const double nearest = (std::min)(distance_in_space(s.at(at), p), offset + distance_in_space(s.at(at), q));
      check_close(field.distance(at), nearest, 1, "narrow region");
    }
    const double beside = (round % 2 == 0 ? 0.97 : 0.8) * std::abs(q.y() - 2);
    Field from_row(s.triangulation, s.mesh);
    from_row.add_curve(row);
    from_row.add_source(second, beside);
    from_row.compute();
    for(int i = 0; i < 300; ++i) {
      const Location at = s.random_location(random);
      const double nearest = (std::min)(std::abs(s.at(at).y() - 2), beside + distance_in_space(s.at(at), q));
      check_close(from_row.distance(at), nearest, 1, "narrow region beside a row");
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_on_boxes)
{
  std::mt19937 random(19);
  for(const auto& [a, b, c] : {Coordinates{4, 4, 4}, {1, 2, 5}}) {
    const Asked_surface s(box(a, b, c, 4));
    const auto place = [&](const Location& at) {
      const Point p = s.at(at);
      return Coordinates{p.x(), p.y(), p.z()};
    };
    for(int round = 0; round < 6; ++round) {
      const Location source = round == 0 ? s.vertex(0) : s.random_location(random);
      Field field(s.triangulation, s.mesh);
      field.add_source(source);
      field.compute();
      for(int i = 0; i < 100; ++i) {
        const Location at = s.random_location(random);
        const double expected = box_distance(a, b, c, place(source), place(at));
        BOOST_TEST(std::abs(field.distance(at) - expected) <= 1e-12 * (a + b + c));
        check_path(s, field, at, 1);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_on_a_cylinder)
{
  std::mt19937 random(23);
  constexpr int n = 11, m = 5;
  constexpr double radius = 1, height = 3;
  const Asked_surface s(cylinder(n, m, radius, height));
  const double side = polygon_side(n, radius);
  // Where it is when the side is rolled out, up to turns.
  const auto rolled_out = [&](const Location& at) {
    const auto& input = s.triangulation.input();
    std::array<double, 3> along;
    std::array<FG::Input_halfedge_index, 3> h = {at.halfedge, input.next(at.halfedge), {}};
    h[2] = input.next(h[1]);
    for(std::size_t i = 0; i < 3; ++i)
      along[i] = input.tail(h[i]).idx() % n;
    const bool is_at_seam = std::count(along.begin(), along.end(), n - 1.0) > 0;
    double x = 0, sum = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      x += at.weights[i] * (is_at_seam && along[i] == 0 ? n : along[i]);
      sum += at.weights[i];
    }
    return std::array<double, 2>{side * x / sum, s.at(at).z()};
  };
  for(int round = 0; round < 10; ++round) {
    const Location source = s.random_location(random);
    const auto p = rolled_out(source);
    Field field(s.triangulation, s.mesh);
    field.add_source(source);
    field.compute();
    for(int i = 0; i < 200; ++i) {
      const Location at = s.random_location(random);
      const auto q = rolled_out(at);
      double expected = infinity;
      for(int turns : {-1, 0, 1})
        expected = (std::min)(expected, std::hypot(q[0] - p[0] + turns * n * side, q[1] - p[1]));
      BOOST_TEST(std::abs(field.distance(at) - expected) <= 1e-12);
      check_path(s, field, at, 1);
    }
    if(kind(source) == FG::Location_kind::VERTEX) {
      const Vertex_index u = s.triangulation.input().tail(source.halfedge);
      for(Vertex_index v : descriptors<Vertex_index>(s.triangulation.number_of_vertices()))
        BOOST_TEST(std::abs(field.distance(v) - cylinder_distance(n, m, radius, height, u.idx(), v.idx())) <= 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(fields_in_property_maps)
{
  Asked_surface s(torus(16, 10, 2, 1));
  Field field(s.triangulation, s.mesh);
  field.add_source(3_v);
  field.add_source(80_v, 0.5);
  field.compute();
  auto distances = s.mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", -1).first;
  auto sources = s.mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:source", 7).first;
  put_distances(field, s.triangulation, s.mesh, distances);
  put_nearest_sources(field, s.triangulation, s.mesh, sources);
  for(const auto v : s.mesh.vertices()) {
    BOOST_TEST(distances[v] == field.distance(s.triangulation.index(v)));
    BOOST_TEST(sources[v] < 2u);
  }
  BOOST_TEST(sources[Mesh::Vertex_index(80)] == 1u);
}
