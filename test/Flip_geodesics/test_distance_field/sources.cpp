// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sources with offsets, inside faces and on edges, and curves as sources.

#include "test_distance_field/asked_surface.h"

#include <CGAL/Flip_geodesics/extract.h>

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(sources_with_offsets_give_the_least_of_single_ones)
{
  std::mt19937 random(5);
  const Asked_surface s(bumpy_sphere(6, 0.3, 4));
  Field all(s.triangulation, s.mesh);
  std::vector<Field> single;
  for(int i = 0; i < 5; ++i) {
    const Location source = s.random_location(random);
    all.add_source(source, 0.1 * i);
    single.emplace_back(s.triangulation, s.mesh);
    single.back().add_source(source, 0.1 * i);
    single.back().compute();
  }
  all.compute();
  for(int i = 0; i < 500; ++i) {
    const Location at = s.random_location(random);
    double least = infinity;
    for(const Field& field : single)
      least = (std::min)(least, field.distance(at));
    const auto answer = all.answer(at);
    check_close(answer.distance, least, 1, "several sources");
    check_close(single[answer.source].distance(at), least, 1, "nearest source");
  }
}

BOOST_AUTO_TEST_CASE(sources_on_edges_and_vertices_are_limits_of_those_in_faces)
{
  std::mt19937 random(13);
  const Asked_surface s(bumpy_sphere(6, 0.3, 8));
  for(int round = 0; round < 20; ++round) {
    Location source = s.random_location(random), near = source;
    source.weights[2] = 0;
    source.weights[1] = round % 2 == 0 ? 0 : source.weights[1];
    for(std::size_t i = 0; i < 3; ++i)
      near.weights[i] = source.weights[i] == 0 ? 1e-9 * source.weights[0] : source.weights[i];
    Field at_source(s.triangulation, s.mesh), beside(s.triangulation, s.mesh);
    at_source.add_source(source);
    at_source.compute();
    beside.add_source(near);
    beside.compute();
    for(int i = 0; i < 200; ++i) {
      const Location at = s.random_location(random);
      BOOST_TEST(std::abs(at_source.distance(at) - beside.distance(at)) < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_from_curves)
{
  std::mt19937 random(11);
  for(const Mesh_soup& soup : {flat_grid(10, 10, Diagonal_rule::RANDOM), bumpy_sphere(6, 0.3, 2), cube(3)}) {
    const Asked_surface s(soup);
    // A polyline through the middles of faces and edges, one along edges, and a segment inside a face.
    const auto& input = s.triangulation.input();
    FG::Input_halfedge_index h = input.outgoing(Vertex_index(s.triangulation.number_of_vertices() / 2));
    std::vector<Location> across, along;
    for(int i = 0; i < 6 && !input.is_border(h); ++i) {
      across.push_back({h, {{1, 1, 1.5}}});
      h = input.next(h);
      across.push_back({h, {{1, 2, 0}}});
      h = FG::internal::twin_index(h);
    }
    if(input.is_border(h))
      across.pop_back();
    h = input.outgoing(0_v);
    along.push_back(s.vertex(0));
    for(int i = 0; i < 3; ++i) {
      along.push_back({h, {{0, 1, 0}}});
      h = input.next(h);
    }
    for(const std::vector<Location>& curve : {across, along}) {
      Field field(s.triangulation, s.mesh), dense(s.triangulation, s.mesh);
      field.add_curve(curve, 0.25);
      constexpr int steps = 200;
      std::vector<Point> points;
      for(const Location& p : curve)
        points.push_back(s.at(p));
      field.compute();
      // Points close to one another on the curve.
      double spacing = 0;
      for(std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const auto f = FG::internal::common_face(input, FG::internal::canonical_location(input, curve[i]),
                                                 FG::internal::canonical_location(input, curve[i + 1]));
        const auto corner = [&](auto e) { return s.triangulation.metric().point(input, input.tail(e)); };
        const Point a = corner(f), b = corner(input.next(f)), c = corner(input.next(input.next(f)));
        const double area = std::sqrt(CGAL::cross_product(b - a, c - a).squared_length());
        for(int k = 0; k <= steps; ++k) {
          const Point p = points[i] + (points[i + 1] - points[i]) * (static_cast<double>(k) / steps);
          const auto part = [&](const Point& u, const Point& v) {
            const double w = std::sqrt(CGAL::cross_product(u - p, v - p).squared_length()) / area;
            return w < 1e-9 ? 0 : w;
          };
          dense.add_source(Location{f, {{part(b, c), part(c, a), part(a, b)}}}, 0.25);
        }
        spacing = (std::max)(spacing, distance_in_space(points[i], points[i + 1]) / steps);
      }
      dense.compute();
      for(int i = 0; i < 300; ++i) {
        const Location at = s.random_location(random);
        const double d = field.distance(at), expected = dense.distance(at);
        BOOST_TEST(d <= expected + 1e-9);
        BOOST_TEST(d >= expected - spacing / 2 - 1e-9);
        // Off the curve the nearest of the dense points is farther by a second order term.
        if(d > 0.25 + 20 * spacing)
          BOOST_TEST(d >= expected - spacing * spacing / (d - 0.25) - 1e-9);
        if(i % 5 == 0) {
          std::vector<Point> path;
          field.path(at, std::back_inserter(path));
          double length = 0;
          for(std::size_t k = 1; k < path.size(); ++k)
            length += distance_in_space(path[k - 1], path[k]);
          check_close(length + 0.25, d, 1 + d, "path to a curve");
          BOOST_TEST(field.distance(at) >= 0.25);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_from_a_line_in_the_plane_are_exact)
{
  // A row of edges across a flat strip, and a geodesic of a network.
  Setting setting(flat_grid(8, 8, Diagonal_rule::RANDOM));
  const auto& mesh = setting.mesh;
  setting.network.add_curve(FG::halfedges_through(setting.triangulation, std::vector<Vertex_index>{36_v, 37_v, 38_v}));
  Field field(setting.triangulation, mesh);
  field.add_curve(FG::Curve_extractor<Setting::Network>(setting.network).surface_locations(FG::Curve_index(0)));
  field.compute();
  const auto& input = setting.triangulation.input();
  const auto at = [&](Vertex_index v) { return setting.triangulation.metric().point(input, v); };
  const Point p = at(36_v), q = at(38_v);
  for(Vertex_index v : descriptors<Vertex_index>(input.number_of_vertices()))
    check_close(field.distance(v),
                std::sqrt(CGAL::squared_distance(at(v), CGAL::Segment_3<CGAL::Simple_cartesian<double>>(p, q))), 1,
                "segment");
  setting.network.clear();
}

// Parallel to its sides, so that the rays of some run along others; from a corner; on a side. With a point whose region
// is narrow.
BOOST_AUTO_TEST_CASE(distances_from_segments_in_faces_are_exact)
{
  using Weights = std::array<double, 3>;
  const std::vector<std::pair<Weights, Weights>> segments = {
      {Weights{2, 1, 1}, Weights{1, 2, 1}}, {Weights{6, 1, 1}, Weights{1, 1, 6}}, {Weights{1, 1, 2}, Weights{1, 2, 1}},
      {Weights{3, 1, 0}, Weights{1, 2, 0}}, {Weights{0, 1, 0}, Weights{1, 0, 1}}, {Weights{5, 3, 2}, Weights{1, 3, 7}},
      {Weights{1, 3, 0}, Weights{0, 3, 1}}};
  std::mt19937 random(23);
  const Asked_surface s(flat_grid(4, 4, Diagonal_rule::RANDOM));
  for(const auto& [first, last] : segments)
    for(FG::Index i = 0; i < s.triangulation.number_of_halfedges(); i += 3) {
      const FG::Input_halfedge_index h(i);
      if(s.triangulation.input().is_border(h))
        continue;
      const std::vector<Location> curve = {{h, first}, {h, last}};
      const CGAL::Segment_3<CGAL::Simple_cartesian<double>> segment(s.at(curve[0]), s.at(curve[1]));
      const Location point = s.random_location(random);
      const double offset = (i % 2 == 0 ? 0.9 : 0.98) * std::sqrt(CGAL::squared_distance(s.at(point), segment));
      Field field(s.triangulation, s.mesh), both(s.triangulation, s.mesh);
      field.add_curve(curve);
      field.compute();
      both.add_source(point, offset);
      both.add_curve(curve);
      both.compute();
      for(int k = 0; k < 100; ++k) {
        const Location at = s.random_location(random);
        const double expected = std::sqrt(CGAL::squared_distance(s.at(at), segment));
        check_close(field.distance(at), expected, 1, "segment");
        check_close(both.distance(at), (std::min)(expected, offset + distance_in_space(s.at(at), s.at(point))), 1,
                    "segment and point");
      }
    }
}

BOOST_AUTO_TEST_CASE(sources_at_special_places)
{
  // An end in the face of a source; the source itself; a vertex given as a location; a source on the border.
  const Asked_surface s(flat_grid(4, 4, Diagonal_rule::RANDOM));
  const auto& input = s.triangulation.input();
  FG::Input_halfedge_index border(0);
  while(!input.is_border(border))
    ++border;
  const FG::Input_halfedge_index inside = FG::internal::twin_index(border);
  for(const Location& source : {Location{inside, {{1, 1, 1}}}, Location{inside, {{1, 2, 0}}},
                                Location{border, {{1, 1, 0}}}, Location{inside, {{0, 0, 1}}}, s.vertex(0)})
  {
    Field field(s.triangulation, s.mesh);
    field.add_source(source);
    field.compute();
    BOOST_TEST(field.distance(source) < 1e-15);
    for(const Location& at : {Location{inside, {{1, 5, 3}}}, Location{inside, {{3, 1, 0}}},
                              Location{border, {{1, 7, 0}}}, Location{inside, {{0, 1, 0}}}, s.vertex(7)})
    {
      check_close(field.distance(at), distance_in_space(s.at(at), s.at(source)), 1, "in one face");
      check_path(s, field, at, 1);
    }
    check_path(s, field, source, 1);
    // The same vertex in every way that it can be told.
    for(FG::Index i = 0; i < input.number_of_halfedges(); ++i)
      if(const FG::Input_halfedge_index h(i); input.tail(h) == 7_v)
        BOOST_TEST(field.distance(Location{h, {{1, 0, 0}}}) == field.distance(7_v));
  }
}

BOOST_AUTO_TEST_CASE(wrong_sources_are_refused)
{
  const Asked_surface s(cube(2));
  Field field(s.triangulation, s.mesh);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto h = s.triangulation.input().outgoing(0_v);
  BOOST_CHECK_THROW(field.add_source(Vertex_index(1000)), FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(field.add_source(FG::null_index), FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(field.add_source(Location{h, {{1, -1, 0}}}), FG::Invalid_location_error);
  BOOST_CHECK_THROW(field.add_source(Location{h, {{nan, 0, 0}}}), FG::Invalid_location_error);
  for(double offset : {nan, infinity, -1.0})
    BOOST_CHECK_THROW(field.add_source(0_v, offset), FG::Invalid_coordinate_error);
  for(double offset : {1e11, 1e300}) { // beside them the mesh is lost in rounding errors, and all ways are equally long
    BOOST_CHECK_THROW(field.add_source(0_v, offset), FG::Invalid_coordinate_error);
    BOOST_CHECK_THROW(field.add_source(Location{h, {{1, 1, 1}}}, offset), FG::Invalid_coordinate_error);
    BOOST_CHECK_THROW(field.add_curve(std::vector<Location>{s.vertex(0)}, offset), FG::Invalid_coordinate_error);
  }
  BOOST_CHECK_THROW(field.add_curve(std::vector<Location>()), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(field.add_curve(std::vector<Location>{s.vertex(0), s.vertex(25)}), FG::Invalid_curve_error);
  BOOST_TEST(field.number_of_sources() == 0u);
  Field late(s.triangulation, s.mesh);
  late.add_source(0_v, 1e9);
  for(double radius : {nan, -1.0, -infinity}) {
    FG::Distance_field_limits limits;
    limits.radius = radius;
    BOOST_CHECK_THROW(late.compute(CGAL::parameters::search_limit(limits)), FG::Invalid_parameter_error);
  }
  BOOST_TEST(late.compute().windows < 1000u);
  BOOST_TEST(std::abs(late.distance(s.vertex(7)) - 1e9) < 10);
  Field at_vertices(s.triangulation, s.mesh, CGAL::parameters::extent(FG::Distance_field_extent::VERTICES_ONLY));
  at_vertices.add_source(0_v);
  at_vertices.compute();
  BOOST_TEST(at_vertices.distance(s.vertex(0)) == 0);
  BOOST_CHECK_THROW(at_vertices.distance(Location{h, {{1, 1, 1}}}), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(at_vertices.surface_points(s.vertex(1)), FG::Invalid_parameter_error);
  // A vertex twice: the smaller offset counts.
  Field twice(s.triangulation, s.mesh);
  for(double offset : {0.75, 0.25, 0.5})
    twice.add_source(0_v, offset);
  twice.compute();
  BOOST_TEST(twice.distance(0_v) == 0.25);
  BOOST_TEST(twice.answer(0_v).source == 1u);
  // Repeated points, and a curve of one.
  field.add_curve(std::vector<Location>{s.vertex(0), s.vertex(0)});
  field.add_curve(std::vector<Location>{Location{h, {{1, 1, 1}}}, Location{h, {{1, 1, 1}}}});
  field.compute();
  BOOST_TEST(field.distance(0_v) == 0);
  BOOST_TEST(field.answer(Location{h, {{1, 1, 1}}}).source == 1u);
}
