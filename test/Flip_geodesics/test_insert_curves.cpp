// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Curves inserted into a mesh in place: geodesics, isolines, drawn polylines. The results are valid meshes of the same
// surface, whose marked edges are the curves.

#define BOOST_TEST_MODULE insert_curves

#include "test_insert_curves/insertions.h"

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/isolines.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <boost/mpl/list.hpp>

#include <initializer_list>
#include <limits>
#include <string>
#include <variant>

using namespace Flip_geodesics_test;

namespace {

using Mesh_types = boost::mpl::list<Mesh, Exact_mesh, Polyhedron>;
using Polyline = Polyline_of<Mesh>;

template <class M>
auto nth_vertex(const M& mesh, std::size_t i)
{
  auto v = vertices(mesh).begin();
  std::advance(v, static_cast<std::ptrdiff_t>(i));
  return *v;
}

template <class M>
Polyline_of<M> geodesic(const M& mesh, std::size_t from, std::size_t to)
{
  Polyline_of<M> result;
  FG::geodesic_path(mesh, nth_vertex(mesh, from), nth_vertex(mesh, to), std::back_inserter(result));
  return result;
}

std::vector<FG::Isoline<Mesh>> isolines_of(const Mesh& mesh, const std::vector<double>& levels)
{
  const FG::Intrinsic_triangulation<Mesh> triangulation(mesh);
  FG::Geodesic_distance_field<FG::Intrinsic_triangulation<Mesh>> field(triangulation, mesh);
  field.add_source(FG::Vertex_index(0));
  field.compute();
  std::vector<FG::Isoline<Mesh>> result;
  FG::isolines(mesh, field, levels, std::back_inserter(result), 1e-3);
  return result;
}

Mesh one_triangle() { return to_mesh<Mesh>(single_triangle()); }

// Expects an exception of one type, and that the mesh is as it was.
template <class Error, class M, class Curves>
void check_refused(M mesh, const Curves& curves, const std::vector<std::size_t>& elements)
{
  const auto before = mesh.number_of_vertices() + mesh.number_of_edges() + mesh.number_of_faces();
  BOOST_CHECK_EXCEPTION(FG::insert_curves(mesh, curves), Error,
                        [&](const Error& error) { return error.elements() == elements; });
  BOOST_TEST(mesh.number_of_vertices() + mesh.number_of_edges() + mesh.number_of_faces() == before);
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(geodesics, M, Mesh_types)
{
  for(const Mesh_soup& soup : meshes_for_insertion()) {
    M mesh = to_mesh<M>(soup);
    const std::size_t n = soup.points.size();
    const std::vector<Polyline_of<M>> curves = {geodesic(mesh, 0, n - 1), geodesic(mesh, n / 3, n / 2)};
    const double length = length_of(curves[0], mesh) + length_of(curves[1], mesh);
    const auto result = inserted(mesh, curves);
    BOOST_TEST(result.marked_length <= length * (1 + 1e-9)); // they may overlap
    BOOST_TEST(result.marked_length >= length * 0.5);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(one_geodesic_has_its_length_and_two_ends, M, Mesh_types)
{
  M mesh = to_mesh<M>(torus(12, 8, 3, 1));
  const Polyline_of<M> path = geodesic(mesh, 0, 44);
  const double length = length_of(path, mesh);
  const auto result = inserted(mesh, path);
  BOOST_TEST(std::abs(result.marked_length - length) <= 1e-9 * length);
  BOOST_TEST(result.marked_ends == 2u);
  BOOST_TEST(result.report.regions == 1u);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(drawn_polylines_cross_each_other_and_themselves, M, Mesh_types)
{
  Random_numbers random(7);
  for(const Mesh_soup& soup : meshes_for_insertion())
    for(std::size_t size : {2, 12, 40}) {
      M mesh = to_mesh<M>(soup);
      std::vector<Polyline_of<M>> curves;
      for(int i = 0; i < 3; ++i)
        curves.push_back(drawn_polyline(mesh, size, random));
      inserted(mesh, curves);
    }
}

BOOST_AUTO_TEST_CASE(flat_surfaces_do_not_intersect_themselves)
{
  Random_numbers random(11);
  for(int round = 0; round < 20; ++round) {
    Mesh mesh = to_mesh<Mesh>(jittered_grid(3, 3, Diagonal_rule::ALTERNATING, 0.2, 3));
    std::vector<Polyline> curves;
    for(int i = 0; i < 4; ++i)
      curves.push_back(drawn_polyline(mesh, 30, random));
    inserted(mesh, curves);
    BOOST_TEST(!CGAL::Polygon_mesh_processing::does_self_intersect(mesh));
    for(const auto f : faces(mesh)) {
      const auto c = corners_of(f, mesh);
      BOOST_TEST((CGAL::cross_product(c[1] - c[0], c[2] - c[0]).z() > 0));
    }
  }
}

BOOST_AUTO_TEST_CASE(isolines_divide_a_sphere)
{
  Mesh mesh = to_mesh<Mesh>(sphere(4));
  const std::vector<FG::Isoline<Mesh>> curves = isolines_of(mesh, {0.5, 1, 2});
  BOOST_TEST_REQUIRE(curves.size() == 3u);
  const auto result = inserted(mesh, curves);
  BOOST_TEST(result.report.regions == 4u);
  BOOST_TEST(result.marked_ends == 0u);
}

BOOST_AUTO_TEST_CASE(isolines_on_surfaces_with_a_border)
{
  for(const Mesh_soup& soup : {grid_with_hole(6, 6, 2, 4, 2, 4), cylinder(7, 3, 1, 2), needle_strip(6, 2, 1000)}) {
    Mesh mesh = to_mesh<Mesh>(soup);
    const auto curves = isolines_of(mesh, {0.3, 0.9, 1.7});
    inserted(mesh, curves);
    for(const auto h : halfedges(mesh)) // as Surface_mesh requires
      if(CGAL::is_border(h, mesh))
        BOOST_TEST(mesh.is_border(target(h, mesh)));
  }
}

// Two segments from corner to the opposite side: one vertex where they cross, and two on the sides.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_crossing_is_one_vertex, M, Mesh_types)
{
  M mesh = to_mesh<M>(single_triangle());
  const auto f = *faces(mesh).begin();
  const std::vector<Polyline_of<M>> curves = {{{f, {{1, 0, 0}}}, {f, {{0, 0.5, 0.5}}}},
                                              {{f, {{0, 1, 0}}}, {f, {{0.5, 0, 0.5}}}}};
  const auto result = inserted(mesh, curves);
  BOOST_TEST(result.report.new_vertices == 3u);
  BOOST_TEST(result.report.new_faces == 4u);
  BOOST_TEST(result.marked_edges == 4u);
  BOOST_TEST(result.report.regions == 4u);
}

// A third segment through the same point: with rounded coordinates of its ends, a vertex closer than rounding.
BOOST_AUTO_TEST_CASE(three_segments_through_a_point_cross_there)
{
  Mesh mesh = one_triangle();
  const auto f = *faces(mesh).begin();
  std::vector<Polyline> curves;
  for(std::size_t i = 0; i < 3; ++i) {
    std::array<double, 3> corner = {{0, 0, 0}}, side = {{0.5, 0.5, 0.5}};
    corner[i] = 1;
    side[i] = 0;
    curves.push_back({{f, corner}, {f, side}});
  }
  const auto result = inserted(mesh, curves);
  BOOST_TEST(result.report.new_vertices == 4u);
  BOOST_TEST(result.report.regions == 6u);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(curves_along_edges_divide_nothing, M, Mesh_types)
{
  M mesh = to_mesh<M>(box(2, 2, 2, 1));
  Polyline_of<M> curve;
  for(const auto h : CGAL::halfedges_around_face(halfedge(*faces(mesh).begin(), mesh), mesh)) {
    static_cast<void>(h);
    std::array<double, 3> weights = {{0, 0, 0}};
    weights[curve.size()] = 1;
    curve.push_back({*faces(mesh).begin(), weights});
  }
  curve.push_back(curve.front());
  const std::vector<Polyline_of<M>> curves = {curve, curve}; // the second overlaps with the first
  const auto result = inserted(mesh, curves);
  BOOST_TEST(result.report.new_vertices == 0u);
  BOOST_TEST(result.report.divided_faces == 0u);
  BOOST_TEST(result.marked_edges == 3u);
  BOOST_TEST(result.report.regions == 2u);
}

// A segment of a side, another one that overlaps with it, and one that ends in the middle of the side.
BOOST_AUTO_TEST_CASE(overlapping_segments_share_edges)
{
  Mesh mesh = one_triangle();
  const auto f = *faces(mesh).begin();
  const std::vector<Polyline> curves = {{{f, {{0.75, 0.25, 0}}}, {f, {{0.25, 0.75, 0}}}},
                                        {{f, {{0.5, 0.5, 0}}}, {f, {{0, 1, 0}}}},
                                        {{f, {{0.4, 0.4, 0.2}}}, {f, {{0.5, 0.5, 0}}}}};
  const Polyline along_side = {{f, {{0.75, 0.25, 0}}}, {f, {{0, 1, 0}}}};
  const double length = length_of(along_side, mesh) + length_of(curves[2], mesh);
  const auto result = inserted(mesh, curves);
  BOOST_TEST(result.report.new_vertices == 4u);
  BOOST_TEST(result.marked_edges == 4u);
  BOOST_TEST(std::abs(result.marked_length - length) <= 1e-12 * length);
}

BOOST_AUTO_TEST_CASE(a_segment_through_a_vertex_inside_a_face)
{
  Mesh mesh = one_triangle();
  const auto f = *faces(mesh).begin();
  const std::vector<Polyline> curves = {{{f, {{0.25, 0.25, 0.5}}}}, {{f, {{0.5, 0.5, 0}}}, {f, {{0, 0, 1}}}}};
  const auto result = inserted(mesh, curves);
  BOOST_TEST(result.report.new_vertices == 2u);
  BOOST_TEST(result.marked_edges == 2u);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(points_in_space, M, Mesh_types)
{
  M mesh = to_mesh<M>(torus(12, 8, 3, 1)), other = mesh;
  std::vector<typename boost::property_traits<typename boost::property_map<M, CGAL::vertex_point_t>::type>::value_type>
      points;
  FG::geodesic_path(mesh, nth_vertex(mesh, 0), nth_vertex(mesh, 44), std::back_inserter(points));
  const auto result = inserted(mesh, points), expected = inserted(other, geodesic(other, 0, 44));
  BOOST_TEST(result.report.new_vertices == expected.report.new_vertices);
  BOOST_TEST(std::abs(result.marked_length - expected.marked_length) <= 1e-9);
}

BOOST_AUTO_TEST_CASE(points_that_are_too_close_are_merged)
{
  Mesh mesh = one_triangle();
  const auto f = *faces(mesh).begin();
  const double e = 1e-14;
  const std::vector<Polyline> curves = {{{f, {{1 - e, e, 0}}}, {f, {{0, 0.5, 0.5}}}}, // begins at a corner
                                        {{f, {{0, 1, 0}}}, {f, {{0.5 + e, 0, 0.5 - e}}}},
                                        {{f, {{0, 1, 0}}}, {f, {{0.5, 0, 0.5}}}}, // ends where the last one does
                                        {{f, {{0.3, 0.3, 0.4}}}, {f, {{0.3, 0.3 + e, 0.4 - e}}}},
                                        {{f, {{0.2, 0.8 - e, e}}}, {f, {{0.1, 0.9, 0}}}}}; // on the side
  const auto result = inserted(mesh, curves);
  BOOST_TEST(result.report.new_vertices == 6u);
}

BOOST_AUTO_TEST_CASE(weights_are_divided_by_their_sum)
{
  constexpr double sum = 1 + 8e-7;
  for(const std::array<double, 3>& weights : {std::array<double, 3>{{0.25, 0.75, 0}}, {{0.25, 0.25, 0.5}}}) {
    Mesh mesh = one_triangle();
    const auto f = *faces(mesh).begin();
    const auto expected = point_of<Mesh>({f, weights}, mesh);
    const Polyline point = {{f, {{sum * weights[0], sum * weights[1], sum * weights[2]}}}};
    FG::insert_curves(mesh, point);
    BOOST_TEST_REQUIRE(mesh.number_of_vertices() == 4u);
    BOOST_TEST(CGAL::squared_distance(mesh.point(Mesh::Vertex_index(3)), expected) < 1e-28);
  }
}

BOOST_AUTO_TEST_CASE(meshes_of_any_scale_are_divided_in_the_same_way)
{
  constexpr double scale = 1024;
  Random_numbers random(19);
  for(int round = 0; round < 10; ++round) {
    Mesh mesh = one_triangle(), large = mesh;
    for(const auto v : vertices(large))
      large.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN);
    const Polyline curve = drawn_polyline(mesh, 6, random);
    FG::insert_curves(mesh, curve);
    FG::insert_curves(large, curve);
    BOOST_TEST_REQUIRE(mesh.number_of_faces() == large.number_of_faces());
    for(const auto f : faces(mesh))
      BOOST_TEST(std::equal(CGAL::vertices_around_face(halfedge(f, mesh), mesh).begin(),
                            CGAL::vertices_around_face(halfedge(f, mesh), mesh).end(),
                            CGAL::vertices_around_face(halfedge(f, large), large).begin()));
  }
}

// Isolines of nearly one level, and geodesics that meet at sharp angles: vertices closer than rounding.
BOOST_AUTO_TEST_CASE(nearly_coincident_curves_leave_good_faces)
{
  Random_numbers random(5);
  for(int round = 0; round < 10; ++round) {
    Mesh mesh = to_mesh<Mesh>(jittered_grid(2, 2, Diagonal_rule::ALTERNATING, 0.2, 3));
    const Polyline curve = drawn_polyline(mesh, 12, random);
    std::vector<Polyline> curves = {curve};
    for(double shift : {1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10}) {
      curves.push_back(curve);
      for(auto& [f, w] : curves.back())
        for(std::size_t i = 0; i < 3; ++i)
          if(w[i] > 0.01 && w[(i + 1) % 3] > 0.01) {
            w[i] += shift;
            w[(i + 1) % 3] -= shift;
          }
    }
    inserted(mesh, curves);
    for(const auto f : faces(mesh)) {
      const auto c = corners_of(f, mesh);
      BOOST_TEST((CGAL::cross_product(c[1] - c[0], c[2] - c[0]).z() > 0));
    }
  }
}

BOOST_AUTO_TEST_CASE(exact_points_lie_on_the_mesh)
{
  Random_numbers random(3);
  Exact_mesh mesh = to_mesh<Exact_mesh>(torus(6, 5, 3, 1)), before = mesh;
  const std::size_t n = mesh.number_of_vertices();
  std::vector<Polyline_of<Exact_mesh>> curves;
  for(int i = 0; i < 4; ++i)
    curves.push_back(drawn_polyline(mesh, 20, random));
  inserted(mesh, curves);
  std::size_t checked = 0;
  for(const auto v : mesh.vertices())
    if(static_cast<std::size_t>(v) >= n) {
      bool is_in_face = false;
      for(const auto f : faces(before)) {
        const auto c = corners_of(f, before);
        is_in_face = is_in_face || Exact::Triangle_3(c[0], c[1], c[2]).has_on(mesh.point(v));
      }
      BOOST_TEST(is_in_face);
      ++checked;
    }
  BOOST_TEST(checked > 50u);
}

BOOST_AUTO_TEST_CASE(properties_and_marks_stay)
{
  Mesh mesh = one_triangle();
  const auto is_marked = mesh.add_property_map<Mesh::Edge_index, bool>("e:marked", false).first;
  const auto h = halfedge(*faces(mesh).begin(), mesh);
  const auto f = *faces(mesh).begin();
  is_marked[edge(h, mesh)] = true;
  const auto color = mesh.add_property_map<Mesh::Vertex_index, int>("v:color", 0).first;
  for(const auto v : mesh.vertices())
    color[v] = 5;
  const Polyline curve = {{f, {{0.5, 0.5, 0}}}, {f, {{0, 0, 1}}}};
  FG::insert_curves(mesh, curve, CGAL::parameters::edge_is_constrained_map(is_marked));
  std::size_t marked = 0, colored = 0;
  for(const auto e : mesh.edges())
    marked += is_marked[e] ? 1 : 0;
  for(const auto v : mesh.vertices())
    colored += color[v] == 5 ? 1 : 0;
  BOOST_TEST(marked == 3u); // both parts of the side, and the curve
  BOOST_TEST(colored == 3u);
}

BOOST_AUTO_TEST_CASE(only_parameters_that_are_given)
{
  Mesh mesh = to_mesh<Mesh>(box(2, 2, 2, 1));
  const auto f = *faces(mesh).begin();
  const Polyline curve = {{f, {{0.5, 0.5, 0}}}, {f, {{0.2, 0.3, 0.5}}}};
  const auto report = FG::insert_curves(mesh, curve);
  BOOST_TEST(report.new_vertices == 2u);
  BOOST_TEST(report.divided_faces == 2u);
  BOOST_TEST(report.regions == 0u);
  BOOST_TEST(FG::insert_curves(mesh, std::vector<Polyline>()).new_vertices == 0u);
}

BOOST_AUTO_TEST_CASE(bad_points_are_refused)
{
  const Mesh mesh = to_mesh<Mesh>(box(2, 2, 2, 1));
  const auto f = *faces(mesh).begin();
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto with = [&](const std::array<double, 3>& weights) {
    return std::vector<Polyline>{{{f, {{1, 0, 0}}}}, {{f, {{1, 0, 0}}}, {f, weights}}};
  };
  check_refused<FG::Invalid_location_error>(mesh, with({{nan, 0.5, 0.5}}), {1, 1});
  check_refused<FG::Invalid_location_error>(mesh, with({{-0.1, 0.6, 0.5}}), {1, 1});
  check_refused<FG::Invalid_location_error>(mesh, with({{0.2, 0.2, 0.2}}), {1, 1});
  check_refused<FG::Invalid_location_error>(mesh, with({{inf, 0, 0}}), {1, 1});
  const std::vector<Polyline> nowhere = {{{Mesh::null_face(), {{1, 0, 0}}}}};
  check_refused<FG::Invalid_location_error>(mesh, nowhere, {0, 0});
  check_refused<FG::Invalid_curve_error>(mesh, std::vector<Polyline>{Polyline()}, {0});
  using Points = std::vector<Inexact::Point_3>;
  check_refused<FG::Invalid_location_error>(mesh, Points{{1, 1, 1}}, {0, 0}); // inside of the box
  check_refused<FG::Invalid_location_error>(mesh, Points{{nan, 0, 0}}, {0, 0});
  Mesh copy = mesh;
  BOOST_CHECK_THROW(FG::insert_curves(copy, with({{1, 0, 0}}), CGAL::parameters::snapping_tolerance(0.5)),
                    FG::Invalid_parameter_error);
}

BOOST_AUTO_TEST_CASE(points_without_a_common_face_are_refused)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const std::vector<Polyline> curves = {
      {{Mesh::Face_index(0), {{0.3, 0.3, 0.4}}}, {Mesh::Face_index(20), {{0.3, 0.3, 0.4}}}}};
  check_refused<FG::Invalid_curve_error>(mesh, curves, {0, 1});
}

BOOST_AUTO_TEST_CASE(bad_meshes_are_refused)
{
  Mesh quads;
  const auto a = quads.add_vertex({0, 0, 0}), b = quads.add_vertex({1, 0, 0}), c = quads.add_vertex({1, 1, 0}),
             d = quads.add_vertex({0, 1, 0}), e = quads.add_vertex({2, 0, 0});
  const auto square = quads.add_face(a, b, c, d), triangle = quads.add_face(b, e, c);
  std::vector<std::size_t> corners;
  for(const auto h : CGAL::halfedges_around_face(halfedge(square, quads), quads))
    corners.push_back(source(h, quads));
  check_refused<FG::Invalid_mesh_error>(quads, Polyline{{square, {{0.5, 0.5, 0}}}}, corners);
  // The side between them is split, so the square would be no polygon of its corners.
  std::array<double, 3> weights = {{0, 0, 0}};
  std::size_t i = 0;
  for(const auto h : CGAL::halfedges_around_face(halfedge(triangle, quads), quads)) {
    if(face(opposite(h, quads), quads) == square)
      weights[i] = weights[(i + 1) % 3] = 0.5;
    ++i;
  }
  check_refused<FG::Invalid_mesh_error>(quads, Polyline{{triangle, weights}}, corners);
  Mesh infinite = one_triangle();
  infinite.point(Mesh::Vertex_index(1)) = Inexact::Point_3(std::numeric_limits<double>::infinity(), 0, 0);
  check_refused<FG::Invalid_coordinate_error>(infinite, Polyline{{Mesh::Face_index(0), {{0.3, 0.3, 0.4}}}}, {1});
}

// ---------------------------------------------------------------- points of all types

// The same curve, in points of other types.
BOOST_AUTO_TEST_CASE_TEMPLATE(points_of_all_types_give_the_same_mesh, M, Mesh_types)
{
  using Vertex = typename boost::graph_traits<M>::vertex_descriptor;
  using Triangulation = FG::Intrinsic_triangulation<M>;
  using Variant = std::variant<Vertex, FG::Surface_location, Location_of<M>, FG::Surface_point>;
  for(const Mesh_soup& soup : meshes_for_insertion()) {
    const auto result_of = [&](const auto& converted) {
      M mesh = to_mesh<M>(soup);
      const Triangulation triangulation(mesh);
      const Polyline_of<M> curve = geodesic(mesh, 0, soup.points.size() - 1);
      std::vector<std::decay_t<decltype(converted(triangulation, mesh, curve[0], curve.size()))>> points;
      for(const auto& p : curve)
        points.push_back(converted(triangulation, mesh, p, points.size()));
      return inserted(mesh, points);
    };
    const auto location = [](const auto& triangulation, const M& mesh, const auto& p, std::size_t) {
      return FG::surface_location(triangulation, mesh, p);
    };
    const auto point = [&](const auto& triangulation, const M& mesh, const auto& p, std::size_t i) {
      return FG::surface_point(triangulation, location(triangulation, mesh, p, i));
    };
    const auto variant = [&](const auto& triangulation, const M& mesh, const auto& p, std::size_t i) -> Variant {
      if(i == 0)
        return nth_vertex(mesh, 0);
      if(i % 3 == 0)
        return p;
      return i % 3 == 1 ? Variant(location(triangulation, mesh, p, i)) : Variant(point(triangulation, mesh, p, i));
    };
    const auto expected = result_of([](const auto&, const M&, const auto& p, std::size_t) { return p; });
    const auto check = [&expected](const auto& result) {
      BOOST_TEST(result.report.new_vertices == expected.report.new_vertices);
      BOOST_TEST(result.report.new_faces == expected.report.new_faces);
      BOOST_TEST(std::abs(result.marked_length - expected.marked_length) <= 1e-12 * expected.marked_length);
    };
    check(result_of(location));
    check(result_of(point));
    check(result_of(variant));
  }
}

BOOST_AUTO_TEST_CASE(a_chain_of_vertices_is_marked)
{
  Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  using Vertex = Mesh::Vertex_index;
  const auto result = inserted(mesh, std::vector<Vertex>{Vertex(6), Vertex(7), Vertex(8)});
  BOOST_TEST(result.report.new_vertices == 0u);
  BOOST_TEST(std::abs(result.marked_length - 2) < 1e-14);
}

BOOST_AUTO_TEST_CASE(completed_polylines_are_inserted)
{
  Mesh mesh = to_mesh<Mesh>(sphere(3));
  FG::Intrinsic_triangulation<Mesh> triangulation(mesh);
  const std::vector<FG::Surface_location> drawn = FG::complete_polyline(
      triangulation, std::vector<FG::Surface_location>{{FG::Input_halfedge_index(0), {{1, 1, 1}}},
                                                       {FG::Input_halfedge_index(60), {{1, 1, 1}}}});
  const auto result = inserted(mesh, drawn);
  BOOST_TEST(result.marked_ends == 2u);
}

BOOST_AUTO_TEST_CASE(points_by_index_that_are_none_are_refused)
{
  Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const auto isolated = mesh.add_vertex(Mesh::Point(9, 9, 9));
  using Location = FG::Surface_location;
  const Location good = {FG::Input_halfedge_index(0), {{1, 0, 0}}};
  const std::vector<std::vector<Location>> curves = {{good}, {good, {FG::Input_halfedge_index(0), {{1, -1, 0}}}}};
  check_refused<FG::Invalid_location_error>(mesh, curves, {1, 1});
  check_refused<FG::Invalid_location_error>(mesh, std::vector<Location>{{FG::Input_halfedge_index(1000), {{1, 0, 0}}}},
                                            {0, 0});
  check_refused<FG::Vertex_out_of_range_error>(mesh, std::vector<Mesh::Vertex_index>{isolated}, {0, 0});
}
