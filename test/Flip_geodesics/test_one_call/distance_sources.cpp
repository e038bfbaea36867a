// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Distances from sources of all kinds, the numbers of the nearest ones, and matrices of distances between points.

#include "test_one_call/checked_curves.h"

#include <CGAL/Flip_geodesics/geodesic_distances.h>

#include <variant>

using namespace Flip_geodesics_test;

namespace {

using Triangulation = Curve_setting::Triangulation;
using Field = FG::Geodesic_distance_field<Triangulation>;
using Vertices = std::vector<Vertex>;
using Locations = std::vector<Face_location>;
using Any_source = std::variant<Vertex, Face_location, FG::Surface_location, Point, Vertices, Locations>;
using Rows = std::vector<std::vector<double>>;

const double infinity = std::numeric_limits<double>::infinity();

Face_location inside(int face) { return {Face(static_cast<unsigned>(face)), {{0.2, 0.3, 0.5}}}; }

// A curve over two faces, through the middle of the edge between them.
Locations across(const Surface& mesh, Halfedge h)
{
  const Face f = mesh.face(h), g = mesh.face(mesh.opposite(h));
  std::array<double, 3> weights = {{0, 0, 0}};
  Halfedge side = mesh.halfedge(f);
  for(double& weight : weights) {
    weight = mesh.source(side) == mesh.source(h) || mesh.source(side) == mesh.target(h) ? 0.5 : 0;
    side = mesh.next(side);
  }
  return {{f, {{0.2, 0.2, 0.6}}}, {f, weights}, {g, {{0.3, 0.3, 0.4}}}};
}

struct Compared
{
  explicit Compared(const Surface& mesh)
    : mesh(mesh)
    , triangulation(mesh)
    , field(triangulation, mesh)
  {
  }

  FG::Surface_location at(const Face_location& location) const
  {
    return surface_location(triangulation, mesh, location);
  }

  // The distances and the nearest sources are those of the field.
  template <class Sources>
  void check(const Sources& sources)
  {
    field.compute();
    std::map<Vertex, double> distances;
    std::map<Vertex, int> nearest;
    const auto report =
        FG::geodesic_distances(mesh, sources, boost::make_assoc_property_map(distances),
                               CGAL::parameters::nearest_source_map(boost::make_assoc_property_map(nearest)));
    BOOST_CHECK(report.is_confirmed());
    for(Vertex v : mesh.vertices()) {
      const auto answer = field.answer(triangulation.index(v));
      BOOST_CHECK_EQUAL(distances.at(v), answer.distance);
      BOOST_CHECK_EQUAL(nearest.at(v), static_cast<int>(answer.source));
    }
  }

  const Surface& mesh;
  Triangulation triangulation;
  Field field;
};

} // namespace

BOOST_AUTO_TEST_CASE(sources_of_all_kinds_in_one_call)
{
  const Surface mesh = bumpy_sphere_mesh();
  Compared c(mesh);
  const Halfedge h(40);
  const Locations curve = across(mesh, h);
  const Vertices edge = {mesh.source(Halfedge(100)), mesh.target(Halfedge(100))};
  const Point above = mesh.point(Vertex(30)) + 0.01 * (mesh.point(Vertex(30)) - CGAL::ORIGIN);
  c.field.add_source(c.triangulation.index(Vertex(3)));
  c.field.add_source(c.at(inside(20)));
  c.field.add_source(c.at(inside(70)));
  c.field.add_source(surface_location(c.triangulation, mesh, above));
  std::vector<FG::Surface_location> line, points;
  for(Vertex v : edge)
    line.push_back(surface_location(c.triangulation, mesh, v));
  for(const Face_location& location : curve)
    points.push_back(c.at(location));
  c.field.add_curve(line);
  c.field.add_curve(points);
  c.check(std::vector<Any_source>{Vertex(3), inside(20), c.at(inside(70)), above, edge, curve});
}

BOOST_AUTO_TEST_CASE(sources_of_one_kind)
{
  const Surface mesh = torus_mesh();
  for(int kind = 0; kind < 4; ++kind) {
    Compared c(mesh);
    const Locations locations = {inside(5), inside(200)};
    const Point point = mesh.point(Vertex(17));
    if(kind < 2)
      c.field.add_source(c.at(locations[0]));
    if(kind == 0)
      c.check(locations[0]);
    if(kind == 1) {
      c.field.add_source(c.at(locations[1]));
      c.check(locations);
    }
    if(kind == 2) {
      c.field.add_source(c.triangulation.index(Vertex(17)));
      c.check(point);
    }
    if(kind == 3) {
      std::vector<FG::Surface_location> points;
      for(const Face_location& location : across(mesh, Halfedge(60)))
        points.push_back(c.at(location));
      c.field.add_curve(points);
      c.check(std::vector<Locations>{across(mesh, Halfedge(60))});
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_sources_are_refused)
{
  const Surface mesh = torus_mesh();
  const boost::dummy_property_map distances;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(FG::geodesic_distances(mesh, Face_location{Face(0), {{2, -1, 0}}}, distances),
                    FG::Invalid_location_error);
  BOOST_CHECK_THROW(FG::geodesic_distances(mesh, Point(nan, 0, 0), distances), FG::Invalid_location_error);
  BOOST_CHECK_THROW(FG::geodesic_distances(mesh, std::vector<Locations>{{}}, distances), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::geodesic_distances(mesh, std::vector<Locations>{{inside(0), inside(200)}}, distances),
                    FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::geodesic_distances(mesh, std::vector<Any_source>{Surface::null_vertex()}, distances),
                    FG::Vertex_out_of_range_error);
}

// Where two vertices of a mesh coincide, the curve and the point lie on the surface that is left.
BOOST_AUTO_TEST_CASE(sources_on_a_mesh_with_an_edge_of_length_zero)
{
  const Surface mesh = torus_mesh();
  const Halfedge h(90);
  Surface flat = mesh;
  flat.point(flat.source(h)) = flat.point(flat.target(h));
  std::map<Vertex, double> distances;
  const std::vector<Any_source> sources = {inside(5), Vertices{flat.source(h), flat.target(h)}};
  FG::geodesic_distances(flat, sources, boost::make_assoc_property_map(distances));
  BOOST_CHECK_EQUAL(distances.at(flat.source(h)), 0);
  BOOST_CHECK_EQUAL(distances.at(flat.target(h)), 0);
  for(Vertex v : flat.vertices())
    BOOST_CHECK(distances.at(v) < infinity);
  Rows rows;
  FG::geodesic_distance_matrix(flat, Vertices{flat.source(h), flat.target(h), Vertex(0)}, std::back_inserter(rows));
  BOOST_CHECK_EQUAL(rows.at(0).at(1), 0);
  BOOST_CHECK_EQUAL(rows.at(0).at(2), rows.at(1).at(2));
  BOOST_CHECK(rows.at(0).at(2) > 0 && rows.at(0).at(2) < infinity);
}

BOOST_AUTO_TEST_CASE(matrices_of_distances_are_those_of_fields)
{
  const Surface mesh = bumpy_sphere_mesh();
  const Triangulation triangulation(mesh);
  const std::vector<std::variant<Vertex, Face_location, Point>> points = {
      Vertex(3), inside(20), Vertex(60), inside(90), mesh.point(Vertex(8)), Vertex(3)};
  Rows rows, in_parallel;
  const auto report = FG::geodesic_distance_matrix(mesh, points, std::back_inserter(rows));
  BOOST_CHECK(report.is_confirmed());
  BOOST_CHECK_EQUAL(report.vertices, 15u); // pairs
  BOOST_REQUIRE_EQUAL(rows.size(), points.size());
  const auto at = [&](std::size_t i) {
    return std::visit([&](const auto& p) { return surface_location(triangulation, mesh, p); }, points[i]);
  };
  for(std::size_t i = 0; i < points.size(); ++i) {
    Field field(triangulation, mesh);
    field.add_source(at(i));
    field.compute();
    BOOST_REQUIRE_EQUAL(rows[i].size(), points.size());
    for(std::size_t j = 0; j < points.size(); ++j) {
      BOOST_CHECK_SMALL(rows[i][j] - field.distance(at(j)), 1e-12);
      BOOST_CHECK_EQUAL(rows[i][j], rows[j][i]);
      if(i < j)
        BOOST_CHECK_EQUAL(rows[i][j], field.distance(at(j)));
    }
  }
  FG::geodesic_distance_matrix<CGAL::Parallel_if_available_tag>(mesh, points, std::back_inserter(in_parallel));
  BOOST_CHECK(in_parallel == rows);
}

// Fields end at the last point: between points that are close together they make a small part of all windows.
BOOST_AUTO_TEST_CASE(fields_of_a_matrix_end_at_the_last_point)
{
  const Surface mesh = to_mesh<Surface>(torus(60, 40, 2, 1));
  const Triangulation triangulation(mesh);
  Field field(triangulation, mesh, CGAL::parameters::extent(FG::Distance_field_extent::VERTICES_ONLY));
  field.add_source(triangulation.index(Vertex(0)));
  const std::size_t all = field.compute().windows;
  const Halfedge h = mesh.halfedge(Vertex(0));
  Rows rows;
  const auto report = FG::geodesic_distance_matrix(mesh, Vertices{Vertex(0), mesh.source(h), mesh.target(mesh.next(h))},
                                                   std::back_inserter(rows));
  BOOST_CHECK_LT(report.windows, all / 10);
  BOOST_CHECK_GT(report.windows, 0u);
}

BOOST_AUTO_TEST_CASE(matrices_of_few_points_and_of_several_components)
{
  const Mesh_soup one = torus(12, 8, 2, 1);
  const Surface mesh = to_mesh<Surface>(disjoint_union(one, translated(one, 10, 0, 0)));
  Rows rows;
  FG::geodesic_distance_matrix(mesh, Vertices(), std::back_inserter(rows));
  BOOST_CHECK(rows.empty());
  BOOST_CHECK_EQUAL(FG::geodesic_distance_matrix(mesh, Vertices{Vertex(1)}, std::back_inserter(rows)).windows, 0u);
  BOOST_CHECK(rows == Rows{{0}});
  rows.clear();
  const Vertices apart = {Vertex(0), Vertex(static_cast<unsigned>(one.points.size())), Vertex(5)};
  const auto report = FG::geodesic_distance_matrix(mesh, apart, std::back_inserter(rows));
  BOOST_CHECK(report.is_confirmed());
  BOOST_CHECK_EQUAL(report.vertices, 1u);
  BOOST_CHECK_EQUAL(rows.at(0).at(1), infinity);
  BOOST_CHECK_EQUAL(rows.at(1).at(2), infinity);
  BOOST_CHECK(rows.at(2).at(0) < infinity);
  rows.clear();
  const auto limited = FG::geodesic_distance_matrix(mesh, apart, std::back_inserter(rows),
                                                    CGAL::parameters::search_limit(FG::Window_limit(1)));
  BOOST_CHECK(!limited.is_confirmed());
  BOOST_CHECK_THROW(FG::geodesic_distance_matrix(mesh, Vertices{Surface::null_vertex()}, std::back_inserter(rows)),
                    FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(FG::geodesic_distance_matrix(mesh, Locations{{Face(0), {{1, 1, 1}}}}, std::back_inserter(rows)),
                    FG::Invalid_location_error);
}

namespace {

struct Watcher : FG::Default_shortening_visitor
{
  explicit Watcher(double end)
    : end(end)
  {
  }

  void on_progress(double fraction)
  {
    BOOST_CHECK(fraction >= last && fraction <= 1);
    last = fraction;
  }
  bool go_further() const { return last < end; }

  double end, last = 0;
};

} // namespace

BOOST_AUTO_TEST_CASE(visitors_of_a_matrix_learn_its_progress_and_stop_it)
{
  const Surface mesh = torus_mesh();
  const Vertices points = {Vertex(0), Vertex(50), Vertex(100), Vertex(150)};
  Rows rows;
  Watcher patient(2), impatient(0.5);
  BOOST_CHECK(
      FG::geodesic_distance_matrix(mesh, points, std::back_inserter(rows), CGAL::parameters::visitor(std::ref(patient)))
          .is_confirmed());
  BOOST_CHECK_EQUAL(patient.last, 1);
  BOOST_CHECK_EQUAL(rows.size(), 4u);
  rows.clear();
  const auto report = FG::geodesic_distance_matrix(mesh, points, std::back_inserter(rows),
                                                   CGAL::parameters::visitor(std::ref(impatient)));
  BOOST_CHECK(report.status == FG::Shortening_status::STOPPED_BY_VISITOR && !report.is_confirmed());
  BOOST_CHECK(rows.empty());
  BOOST_CHECK_EQUAL(impatient.last, 0.5);
}
