// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Classes and functions over triangulations take vertices, Face_locations, points of curves, points in space and
// variants of these like the locations that they are converted to.

#include "test_surface_points/inserted_points.h"

#include <CGAL/Flip_geodesics/Curve_editor.h>
#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/geodesic_mean.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <cstddef>
#include <exception>
#include <string>
#include <variant>
#include <vector>

using namespace Flip_geodesics_test;

namespace {

using Locations = std::vector<FG::Surface_location>;
using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>;
using Any_point = std::variant<Mesh::Vertex_index, Face_location, FG::Surface_location, Point>;

struct Points
{
  Mesh mesh = to_mesh<Mesh>(bumpy_sphere(4, 0.2, 3));
  Certified triangulation{mesh};
  std::vector<Mesh::Vertex_index> vertices = {Mesh::Vertex_index(1), Mesh::Vertex_index(20), Mesh::Vertex_index(33)};
  std::vector<Face_location> in_faces = {{Mesh::Face_index(3), {{0.25, 0.25, 0.5}}},
                                         {Mesh::Face_index(40), {{0.5, 0.5, 0}}},
                                         {Mesh::Face_index(70), {{0.125, 0.25, 0.625}}}};
  std::vector<Any_point> mixed = {vertices[0], in_faces[1], triangulation.location(5_v), mesh.point(vertices[2])};

  template <class Range>
  Locations located(const Range& points) const
  {
    return FG::internal::located_places(triangulation, points);
  }

  std::vector<FG::Curve_place<Mesh>> of_curve() const
  {
    std::vector<FG::Curve_place<Mesh>> result(in_faces.size());
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i].location = in_faces[i];
    return result;
  }

  // `compute(points)` returns the same for points as for their locations.
  template <class Compute>
  void check(const Compute& compute) const
  {
    BOOST_TEST((compute(vertices) == compute(located(vertices))));
    BOOST_TEST((compute(in_faces) == compute(located(in_faces))));
    BOOST_TEST((compute(of_curve()) == compute(located(in_faces))));
    BOOST_TEST((compute(mixed) == compute(located(mixed))));
  }
};

std::vector<double> numbers(const Locations& locations)
{
  std::vector<double> result;
  for(const FG::Surface_location& at : locations)
    result.insert(result.end(), {double(at.halfedge.idx()), at.weights[0], at.weights[1], at.weights[2]});
  return result;
}

std::vector<double> numbers(const std::vector<Locations>& legs)
{
  std::vector<double> result;
  for(const Locations& leg : legs)
    for(const double x : numbers(leg))
      result.push_back(x);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(splines_and_editors_take_any_points)
{
  Points p;
  p.check([&](const auto& points) {
    FG::Geodesic_spline<Certified> spline(p.triangulation, points, FG::Spline_kind::BEZIER);
    spline.refine();
    return numbers(spline.finish());
  });
  p.check([&](const auto& points) {
    FG::Curve_editor<Certified> editor(p.triangulation, points, CGAL::parameters::is_closed(true));
    FG::Curve_editor<Certified> open(p.triangulation, std::vector(points.begin(), points.begin() + 2));
    open.move(0, points[2]);
    return numbers(std::vector<Locations>{editor.leg(0), editor.leg(1), editor.leg(2), open.leg(0)});
  });
  p.check([&](const auto& points) { return numbers(FG::geodesics_through(p.triangulation, points).legs); });
}

BOOST_AUTO_TEST_CASE(fields_maps_and_means_take_any_points)
{
  Points p;
  p.check([&](const auto& points) {
    FG::Geodesic_distance_field<Certified> field(p.triangulation, p.mesh);
    field.add_source(points[0]);
    field.compute();
    std::vector<Point> path;
    field.path(points[1], std::back_inserter(path));
    return std::make_pair(field.distance(points[2]), path);
  });
  p.check([&](const auto& points) {
    const FG::Logarithmic_map<Certified> map(p.triangulation, p.mesh, points[0]);
    return std::make_pair(map(points[1]).radius, map(points[1]).angle);
  });
  p.check([&](const auto& points) {
    const std::vector<double> weights(points.size(), 1);
    return numbers({FG::Geodesic_mean<Certified>(p.triangulation, p.mesh, points, weights).heaviest()});
  });
}

BOOST_AUTO_TEST_CASE(tracers_and_transports_take_any_points)
{
  Points p;
  const FG::Geodesic_tracer<Certified> tracer(p.triangulation);
  p.check([&](const auto& points) {
    const FG::Input_halfedge_index h = p.located(points)[0].halfedge;
    const FG::Trace_report report =
        tracer.trace(points[0], FG::Surface_direction{h, 0.3}, 1, CGAL::Emptyset_iterator());
    return std::make_pair(report.angle, numbers({report.location}));
  });
  // Two points of each face.
  std::vector<Face_location> way = {p.in_faces[0], {p.in_faces[0].first, {{0.5, 0.25, 0.25}}}};
  const Locations same = p.located(way);
  const FG::Parallel_transport<Certified> transport(p.triangulation);
  BOOST_TEST(transport(way, {same[0].halfedge, 1}).angle == transport(same, {same[0].halfedge, 1}).angle);
  const FG::Located_curve<Certified> curve(p.triangulation, way), like(p.triangulation, same);
  BOOST_TEST(curve.length() == like.length());
}

BOOST_AUTO_TEST_CASE(networks_take_any_points)
{
  Points p;
  const auto lengths = [&](const auto& points, const auto& add) {
    Certified triangulation(p.mesh);
    FG::Edge_path_network<Certified> network(triangulation);
    return network.length(add(network, points));
  };
  p.check([&](const auto& points) {
    return lengths(points, [](auto& network, const auto& q) { return FG::add_curve_through(network, q); });
  });
  p.check([&](const auto& points) { return numbers(FG::complete_polyline(p.triangulation, points)); });
  p.check([&](const auto& points) {
    return FG::snap_polyline(p.triangulation, FG::complete_polyline(p.triangulation, points));
  });
  const std::vector<Face_location> way = {p.in_faces[0], {p.in_faces[0].first, {{0.5, 0.25, 0.25}}}};
  const auto draw = [](auto& network, const auto& q) { return FG::draw_polyline(network, q); };
  BOOST_TEST(lengths(way, draw) == lengths(p.located(way), draw));
}

BOOST_AUTO_TEST_CASE(curves_through_points_in_one_place_are_refused_with_the_reason)
{
  Mesh mesh = to_mesh<Mesh>(bumpy_sphere(4, 0.2, 3));
  Certified triangulation(mesh);
  FG::Edge_path_network<Certified> network(triangulation);
  const FG::Surface_location place = triangulation.location(5_v);
  for(std::size_t number : {1, 2, 3}) {
    const std::string reason = number == 1 ? "at least two points" : "all points of a curve coincide";
    for(bool is_closed : {false, true})
      BOOST_CHECK_EXCEPTION(
          FG::add_curve_through(network, Locations(number, place), CGAL::parameters::is_closed(is_closed)),
          FG::Invalid_curve_error,
          [&](const std::exception& e) { return std::string(e.what()).find(reason) != std::string::npos; });
  }
}

BOOST_AUTO_TEST_CASE(points_of_polygons_have_no_common_face)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> corners;
  for(const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(2, 0, 0)})
    corners.push_back(mesh.add_vertex(p));
  mesh.add_face(corners[0], corners[1], corners[2], corners[3]);
  mesh.add_face(corners[1], corners[4], corners[2]);
  const Certified triangulation(mesh);
  const auto are_in_one_face = [&](FG::Vertex_index v, FG::Vertex_index w) {
    return FG::internal::common_face(triangulation.input(), triangulation.location(v), triangulation.location(w)) !=
           FG::null_index;
  };
  for(FG::Vertex_index v : {1_v, 2_v, 3_v})
    BOOST_CHECK_THROW(are_in_one_face(0_v, v), FG::Invalid_mesh_error);
  BOOST_CHECK_THROW(are_in_one_face(4_v, 1_v), FG::Invalid_mesh_error); // 1 is a corner of both
  BOOST_TEST(are_in_one_face(4_v, 4_v));
}
