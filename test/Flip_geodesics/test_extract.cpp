// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is read off a network, the ways to build one, and the mollified metric.

#include "closed_forms.h"
#include "descriptors.h"

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#define BOOST_TEST_MODULE extract
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;

Point point_at(const Mesh& mesh, const Location& location)
{
  double x = 0, y = 0, z = 0;
  Mesh::Halfedge_index h = mesh.halfedge(location.first);
  for(double weight : location.second) {
    const Point& p = mesh.point(mesh.source(h));
    x += weight * p.x();
    y += weight * p.y();
    z += weight * p.z();
    h = mesh.next(h);
  }
  return {x, y, z};
}

double area(const FG::Intrinsic_face& f)
{
  const double a = f.lengths[0], b = f.lengths[1], c = f.lengths[2], s = (a + b + c) / 2;
  return std::sqrt(s * (s - a) * (s - b) * (s - c));
}

} // namespace

BOOST_AUTO_TEST_CASE(points_face_locations_and_crossed_halfedges_agree)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(12, 0.1, 7));
  Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  std::mt19937 random(1);
  int crossings = 0;
  for(int i = 0; i < 50; ++i) {
    const FG::Vertex_index s(static_cast<FG::Index>(random() % mesh.number_of_vertices()));
    const FG::Vertex_index t(static_cast<FG::Index>(random() % mesh.number_of_vertices()));
    if(s == t)
      continue;
    Network network(triangulation);
    network.add_curve(search(s, t));
    const FG::Shortening_report report = FG::shorten(network);
    FG::Curve_extractor<Network> extractor(network);
    const std::vector<FG::Surface_point> on_surface = extractor.surface_points(0_c);
    std::vector<Point> points;
    extractor.points(0_c, std::back_inserter(points));
    std::vector<Location> locations;
    extractor.face_locations(0_c, mesh, std::back_inserter(locations));
    std::vector<Mesh::Halfedge_index> crossed;
    extractor.crossed_halfedges(0_c, std::back_inserter(crossed));

    BOOST_REQUIRE_EQUAL(points.size(), on_surface.size());
    BOOST_REQUIRE_EQUAL(points.size(), locations.size());
    BOOST_CHECK(points.front() == mesh.point(triangulation.vertex(s)));
    BOOST_CHECK(points.back() == mesh.point(triangulation.vertex(t)));
    double length = 0;
    std::size_t next_crossed = 0;
    for(std::size_t k = 0; k < points.size(); ++k) {
      BOOST_CHECK_SMALL(CGAL::squared_distance(points[k], point_at(mesh, locations[k])), 1e-28);
      if(k > 0)
        length += std::sqrt(CGAL::squared_distance(points[k - 1], points[k]));
      if(!on_surface[k].is_vertex()) {
        BOOST_CHECK(on_surface[k].t > 0 && on_surface[k].t <= 0.5);
        BOOST_REQUIRE(next_crossed < crossed.size());
        BOOST_CHECK(triangulation.input().halfedge(on_surface[k].halfedge) == crossed[next_crossed++]);
      }
    }
    BOOST_CHECK_EQUAL(next_crossed, crossed.size());
    BOOST_CHECK_CLOSE_FRACTION(length, report.curves.front().length, 1e-12);
    crossings += static_cast<int>(crossed.size());
    network.clear();
    triangulation.rollback();
  }
  BOOST_CHECK_GT(crossings, 500);
}

BOOST_AUTO_TEST_CASE(edges_of_a_flipped_triangulation_are_as_long_on_the_input_as_they_say)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(10, 0.1, 3));
  Triangulation triangulation(mesh);
  std::mt19937 random(2);
  for(int i = 0; i < 3 * triangulation.number_of_edges(); ++i) {
    const FG::Halfedge_index h(static_cast<FG::Index>(random() % triangulation.number_of_halfedges()));
    if(triangulation.is_flippable(h))
      triangulation.flip(h);
  }
  std::size_t crossings = 0;
  for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(triangulation.number_of_edges())) {
    const FG::Halfedge_index h = FG::internal::first_side(e);
    std::vector<FG::Surface_point> there, back;
    FG::edge_surface_points(triangulation, h, std::back_inserter(there));
    FG::edge_surface_points(triangulation, Triangulation::twin(h), std::back_inserter(back));
    BOOST_REQUIRE_EQUAL(there.size(), back.size());
    BOOST_CHECK_EQUAL(there.front().a, triangulation.tail(h));
    BOOST_CHECK_EQUAL(there.back().a, triangulation.head(h));
    double length = 0;
    for(std::size_t k = 0; k < there.size(); ++k) {
      const Point p = FG::point_in_space(triangulation, there[k]);
      BOOST_CHECK_SMALL(CGAL::squared_distance(p, FG::point_in_space(triangulation, back[back.size() - 1 - k])), 1e-24);
      if(k > 0)
        length += std::sqrt(CGAL::squared_distance(FG::point_in_space(triangulation, there[k - 1]), p));
    }
    BOOST_CHECK_CLOSE_FRACTION(length, triangulation.length(h), 1e-11);
    crossings += there.size() - 2;
  }
  BOOST_CHECK_GT(crossings, 500);
}

// Where rounding puts a crossing at an end of the edge, or beyond a zero's sign.
BOOST_AUTO_TEST_CASE(a_crossing_is_inside_its_edge)
{
  const Mesh mesh = to_mesh<Mesh>(tetrahedron());
  const Triangulation triangulation(mesh);
  const FG::Vertex_index right = triangulation.tail(0_h), left = triangulation.head(0_h);
  for(double from_right : {0.0, -0.0, 5e-324, 1e-99, 0.25, 0.5, 0.75, std::nextafter(1.0, 0.0), 1.0}) {
    const FG::Surface_point p = FG::internal::surface_point_on_edge(triangulation, 0_input_h, from_right);
    BOOST_TEST_CONTEXT("from the right " << from_right)
    {
      BOOST_CHECK_EQUAL(p.a, from_right <= 0.5 ? right : left);
      BOOST_CHECK_EQUAL(p.b, from_right <= 0.5 ? left : right);
      BOOST_CHECK(!p.is_vertex() && !p.is_inside_face());
      BOOST_CHECK(p.t > 0 && p.t <= 0.5 && p.u == 0);
      BOOST_CHECK_SMALL(p.t - (std::min)(from_right, 1 - from_right), 1e-99);
      const FG::Surface_location location = FG::internal::surface_location(triangulation, p);
      BOOST_CHECK(FG::kind(location) == FG::Location_kind::EDGE);
      const FG::Surface_point again = FG::surface_point(triangulation, location);
      BOOST_CHECK(again.a == p.a && again.b == p.b && again.t == p.t);
    }
  }
  const FG::Surface_point inside = FG::surface_point(triangulation, {0_input_h, {{1e-100, 1e100, 1e-100}}});
  BOOST_CHECK(inside.is_inside_face() && inside.t > 0 && inside.u > 0);
  BOOST_CHECK_NO_THROW(FG::internal::check_location(triangulation.input(), {0_input_h, {{inside.u, 1, inside.t}}}));
}

// The diagonal of a square crosses that which was there halfway.
BOOST_AUTO_TEST_CASE(a_point_of_an_edge_is_inside_a_face_unless_the_edge_runs_along_one)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(1, 1, Diagonal_rule::RISING));
  Triangulation triangulation(mesh);
  FG::Halfedge_index diagonal = 0_h;
  while(!triangulation.is_flippable(diagonal))
    ++diagonal;
  const auto kind_at = [&](FG::Halfedge_index h, double t) {
    return FG::kind(FG::location_on_edge(triangulation, h, t));
  };
  for(FG::Halfedge_index h(0); h.idx() < triangulation.number_of_halfedges(); ++h)
    for(double t : {1e-90, 1e-17, 0.5, std::nextafter(1.0, 0.0)})
      BOOST_CHECK(kind_at(h, t) == FG::Location_kind::EDGE);
  triangulation.flip(diagonal);
  for(double t : {1e-90, 1e-17, 0.25, 0.5, std::nextafter(1.0, 0.0)})
    BOOST_CHECK(kind_at(diagonal, t) == FG::Location_kind::FACE);
  const auto subdivision = FG::common_subdivision(triangulation, mesh);
  int crossings = 0;
  for(const auto v : vertices(subdivision.mesh())) {
    const FG::Subdivision_vertex& origin = subdivision.vertex_origin(v);
    if(origin.intrinsic_vertex != FG::null_index)
      continue;
    ++crossings;
    BOOST_CHECK(!origin.on_input.is_vertex() && origin.on_input.t > 0);
    BOOST_CHECK(origin.intrinsic_t > 0 && origin.intrinsic_t < 1);
  }
  BOOST_CHECK_EQUAL(crossings, 1);
}

BOOST_AUTO_TEST_CASE(the_conforming_triangulation_keeps_euler_characteristic_and_area)
{
  const Mesh mesh = to_mesh<Mesh>(genus_3_plate(2));
  Triangulation triangulation(mesh);
  std::vector<FG::Intrinsic_face> before, after;
  FG::intrinsic_faces(triangulation, std::back_inserter(before));
  Network network(triangulation);
  const Mesh_soup soup = genus_3_plate(2);
  const Vertex_sequence loop = with_detours(soup, genus_3_loops(2).front(), true);
  network.add_curve(FG::halfedges_through(triangulation, loop, CGAL::parameters::is_closed(true)),
                    CGAL::parameters::is_closed(true));
  const FG::Shortening_report report = FG::shorten(network);
  BOOST_CHECK_GT(report.flips, 0u);
  FG::intrinsic_faces(triangulation, std::back_inserter(after));

  BOOST_CHECK_EQUAL(after.size(), mesh.number_of_faces());
  double area_before = 0, area_after = 0;
  FG::internal::Indexed_by<FG::Halfedge_index, std::vector<char>> is_side(mesh.number_of_halfedges(), 0);
  for(const FG::Intrinsic_face& f : before)
    area_before += area(f);
  for(const FG::Intrinsic_face& f : after) {
    area_after += area(f);
    for(FG::Halfedge_index h : f.halfedges)
      is_side[h] = 1;
  }
  BOOST_CHECK_CLOSE_FRACTION(area_before, area_after, 1e-10);
  for(FG::Halfedge_index h : network.halfedges(0_c))
    BOOST_CHECK(is_side[h] != 0);
}

BOOST_AUTO_TEST_CASE(marked_edges_become_curves_between_junctions)
{
  const int n = 8;
  Mesh mesh = to_mesh<Mesh>(flat_grid(n, n, Diagonal_rule::RISING));
  auto is_marked = mesh.add_property_map<Mesh::Edge_index, bool>("e:marked", false).first;
  Triangulation triangulation(mesh);
  const auto mark = [&](const Vertex_sequence& path) {
    for(auto h : halfedges_along(mesh, path, false))
      is_marked[mesh.edge(h)] = true;
  };
  mark(vertex_path_on_grid(n, {{{1, 1}, {1, 7}}})); // a T of three paths: the junction is (1, 4)
  mark(vertex_path_on_grid(n, {{{1, 4}, {4, 4}}}));
  mark(vertex_path_on_grid(n, {{{6, 2}, {7, 2}, {7, 3}, {6, 3}, {6, 2}}})); // a loop without a junction
  Network network(triangulation);
  BOOST_CHECK_EQUAL(FG::add_marked_edges(network, mesh, is_marked), 4);
  BOOST_CHECK(network.is_valid());
  int closed = 0, segments = 0;
  for(FG::Curve_index c : network.curves()) {
    closed += network.is_closed(c) ? 1 : 0;
    segments += static_cast<int>(network.halfedges(c).size());
  }
  BOOST_CHECK_EQUAL(closed, 1);
  BOOST_CHECK_EQUAL(segments, 6 + 3 + 4);
}

BOOST_AUTO_TEST_CASE(way_points_are_passed_in_order)
{
  const int n = 10;
  const Mesh mesh = to_mesh<Mesh>(flat_grid(n, n, Diagonal_rule::RISING));
  Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation),
      dijkstra(triangulation, CGAL::parameters::search_method(FG::Search_method::DIJKSTRA));
  const auto vertex = [](int i, int j) { return FG::Vertex_index(grid_vertex(n, i, j)); };
  const Vertex_sequence way_points = {vertex(0, 0), vertex(3, 9), vertex(9, 2)};
  const std::vector<FG::Halfedge_index> path = FG::shortest_halfedges_through(search, way_points);
  std::size_t next = 1;
  for(FG::Halfedge_index h : path)
    next += next < way_points.size() && triangulation.head(h) == way_points[next] ? 1 : 0;
  BOOST_CHECK_EQUAL(next, way_points.size());
  double a_star_length = 0, dijkstra_length = 0;
  for(FG::Halfedge_index h : path)
    a_star_length += triangulation.length(h);
  for(FG::Halfedge_index h : FG::shortest_halfedges_through(dijkstra, way_points))
    dijkstra_length += triangulation.length(h);
  BOOST_CHECK_CLOSE_FRACTION(a_star_length, dijkstra_length, 1e-14);
  BOOST_CHECK_THROW(FG::shortest_halfedges_through(search, Vertex_sequence{1_v, 1_v}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::shortest_halfedges_through(search, Vertex_sequence{1_v}), FG::Invalid_curve_error);
}

BOOST_AUTO_TEST_CASE(a_mollified_metric_makes_edges_of_length_zero_usable)
{
  Mesh_soup soup = flat_grid(6, 6, Diagonal_rule::RISING);
  soup.points[grid_vertex(6, 3, 3)] = soup.points[grid_vertex(6, 3, 2)];
  const Mesh mesh = to_mesh<Mesh>(soup);
  using Embedded = Triangulation::Metric;
  using Mollified = FG::Mollified_metric<Embedded>;
  using Mollified_triangulation = FG::Intrinsic_triangulation<Mesh, Triangulation::Traits, Mollified>;
  const Embedded embedded(mesh.points());
  const Vertex_sequence over = vertex_path_on_grid(6, {{3, 1}, {3, 3}});

  Triangulation plain(mesh, embedded);
  BOOST_CHECK_THROW(FG::halfedges_through(plain, over), FG::Degenerate_face_error);

  const Triangulation contracted(mesh, embedded, Triangulation::Traits(), FG::Zero_length_edges::CONTRACT);
  Vertex_sequence merged;
  for(FG::Vertex_index v : over)
    merged.push_back(contracted.index(plain.vertex(v)));
  BOOST_TEST((merged[1] == merged[2]));
  const std::vector<FG::Halfedge_index> chain = FG::halfedges_through(contracted, merged);
  BOOST_TEST_REQUIRE(chain.size() == 1u);
  BOOST_TEST((contracted.tail(chain[0]) == merged[0] && contracted.head(chain[0]) == merged[1]));
  BOOST_CHECK_THROW(FG::halfedges_through(contracted, Vertex_sequence{merged[1], merged[2]}), FG::Invalid_curve_error);

  const Mollified metric(mesh, embedded, 1e-4);
  BOOST_CHECK_GT(metric.added_length(), 0);
  Mollified_triangulation triangulation(mesh, metric);
  const auto& input = triangulation.input();
  for(FG::Index i = 0; i < input.number_of_halfedges(); ++i) { // the same where places are at hand
    const FG::Input_halfedge_index h(i);
    const auto tail = metric.place(input, input.tail(h)), head = metric.place(input, input.tail(input.twin(h)));
    BOOST_CHECK_CLOSE_FRACTION(metric.weight(input, h, tail, head), metric.weight(input, h), 1e-14);
  }
  FG::Edge_path_network<Mollified_triangulation> network(triangulation);
  network.add_curve(FG::halfedges_through(triangulation, over));
  BOOST_CHECK(FG::shorten(network).is_complete());
  BOOST_CHECK(FG::certify(network).is_locally_shortest());
  const Mesh regular = to_mesh<Mesh>(flat_grid(6, 6, Diagonal_rule::RISING));
  BOOST_CHECK_EQUAL(Mollified(regular, Embedded(regular.points()), 1e-4).added_length(), 0); // nothing to mend
}

BOOST_AUTO_TEST_CASE(a_mollified_metric_without_added_length_is_the_other_metric)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(4, 0.2, 1));
  const Triangulation::Metric embedded(mesh.points());
  const auto path = [&](const auto& metric) {
    std::vector<Point> points;
    const auto result = FG::geodesic_path(mesh, Mesh::Vertex_index(0), Mesh::Vertex_index(50),
                                          std::back_inserter(points), CGAL::parameters::metric(metric));
    BOOST_CHECK((result.verdict() == FG::Verdict::PROVEN));
    return points;
  };
  using Mollified = FG::Mollified_metric<Triangulation::Metric>;
  const std::vector<Point> expected = path(embedded);
  BOOST_CHECK(expected.size() > 3);
  BOOST_CHECK(path(Mollified(embedded)) == expected);
  BOOST_CHECK(path(Mollified(mesh, embedded, 1e-6)) == expected);
  BOOST_CHECK(path(Mollified(mesh, embedded, 0.5)) != expected);
}

// The length that is added makes up for what the worst face lacks.
BOOST_AUTO_TEST_CASE(mollified_lengths)
{
  using Lengths = Mesh::Property_map<Mesh::Edge_index, double>;
  using Metric = FG::Edge_length_metric<Mesh, Lengths>;
  Mesh mesh = to_mesh<Mesh>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const Lengths lengths = mesh.add_property_map<Mesh::Edge_index, double>("e:length", 1).first;
  const auto added = [&] { return FG::Mollified_metric<Metric>(mesh, Metric(mesh, lengths), 1e-3).added_length(); };
  BOOST_CHECK_EQUAL(added(), 0);
  for(std::size_t longest : {0, 1, 2})
    for(double excess : {0.0, 3.0}) {
      const std::array<double, 3> sides = {3 + excess, 1, 2};
      std::size_t i = longest;
      for(Mesh::Edge_index e : mesh.edges())
        lengths[e] = sides[i++ % 3];
      BOOST_CHECK_CLOSE_FRACTION(added(), excess + 1e-3 * (6 + excess) / 3, 1e-12);
    }
  const double infinity = std::numeric_limits<double>::infinity();
  for(double bad : {-1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    lengths[*mesh.edges().begin()] = bad;
    BOOST_CHECK_THROW(added(), FG::Invalid_coordinate_error);
  }
  Mesh square;
  const auto corner = [&](double x, double y) { return square.add_vertex({x, y, 0}); };
  square.add_face(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
  using Embedded = Triangulation::Metric;
  BOOST_CHECK_THROW(FG::Mollified_metric<Embedded>(square, Embedded(square.points())), FG::Invalid_mesh_error);
}
