// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Each public function, and each class by its constructor, on meshes that it was not made for, and with elements that
// the mesh does not have: it throws an exception of the package, or is right, and comes to an end.

#define BOOST_TEST_MODULE entry_points

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using Vertex = Surface::Vertex_index;
using Face = Surface::Face_index;
using Point = Surface::Point;
using Triangulation = Curve_setting::Triangulation;
using Network = Curve_setting::Network;
using Face_location = std::pair<Face, std::array<double, 3>>;

namespace {

// ---------------------------------------------------------------- meshes

Surface polygon_mesh(const std::vector<Coordinates>& points, const std::vector<std::vector<int>>& polygons)
{
  Surface mesh;
  for(const Coordinates& p : points)
    mesh.add_vertex(Point(p[0], p[1], p[2]));
  for(const std::vector<int>& polygon : polygons) {
    std::vector<Vertex> corners;
    for(int v : polygon)
      corners.push_back(Vertex(static_cast<Surface::size_type>(v)));
    BOOST_REQUIRE(mesh.add_face(corners) != Surface::null_face());
  }
  return mesh;
}

Surface quad_cube()
{
  return polygon_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

// A grid of n by n squares from (i, i) to (j, j) of which is one polygon.
Surface grid_with_polygon(int n, int i, int j)
{
  Surface mesh = to_mesh<Surface>(grid_with_hole(n, n, i, j, i, j));
  const auto is_inside = [&](Vertex v) {
    const Point& p = mesh.point(v);
    return p.x() > 0 && p.x() < n && p.y() > 0 && p.y() < n;
  };
  for(const auto h : mesh.halfedges())
    if(mesh.is_border(h) && is_inside(mesh.source(h)) && is_inside(mesh.target(h))) {
      CGAL::Euler::fill_hole(h, mesh);
      return mesh;
    }
  BOOST_FAIL("no hole");
  return mesh;
}

// A face of two sides along a halfedge.
void add_digon(Surface& mesh, Surface::Halfedge_index h)
{
  const auto outside = mesh.add_edge(), inside = mesh.opposite(outside);
  const Face face = mesh.face(h), digon = mesh.add_face();
  mesh.set_target(outside, mesh.target(h));
  mesh.set_target(inside, mesh.source(h));
  mesh.set_next(mesh.prev(h), outside);
  mesh.set_next(outside, mesh.next(h));
  mesh.set_next(h, inside);
  mesh.set_next(inside, h);
  mesh.set_face(outside, face);
  mesh.set_halfedge(face, outside);
  mesh.set_face(h, digon);
  mesh.set_face(inside, digon);
  mesh.set_halfedge(digon, h);
}

// ---------------------------------------------------------------- entry points

enum class Reach {
  EDGES, // reads no face
  LOCAL, // reads faces between two vertices, or about them
  WHOLE  // reads all faces
};

struct Entry_point
{
  std::string name;
  Reach reach;
  std::function<void(const Surface&, Vertex, Vertex)> call; // with two vertices, of which it may need none
};

bool is_vertex(const Surface& mesh, Vertex v) { return static_cast<std::size_t>(v) < mesh.number_of_vertices(); }

// The end of an edge at a vertex; the vertex itself if there is none.
Vertex next_to(const Surface& mesh, Vertex v)
{
  return is_vertex(mesh, v) && mesh.halfedge(v) != Surface::null_halfedge() ? mesh.source(mesh.halfedge(v)) : v;
}

// The middle of a face at a vertex; in no face if there is none.
Face_location beside(const Surface& mesh, Vertex v)
{
  Face_location result = {Surface::null_face(), {{1. / 3, 1. / 3, 1. / 3}}};
  if(is_vertex(mesh, v) && mesh.halfedge(v) != Surface::null_halfedge())
    for(const auto h : CGAL::halfedges_around_target(v, mesh))
      result.first = mesh.is_border(h) ? result.first : mesh.face(h);
  return result;
}

struct Setting
{
  Setting(const Surface& mesh, Vertex from, Vertex to)
    : triangulation(mesh)
    , v(triangulation.index(from))
    , w(triangulation.index(to))
    , mesh(mesh)
    , from(from)
    , to(to)
  {
  }

  std::vector<FG::Surface_location> locations() const
  {
    return {FG::surface_location(triangulation, mesh, beside(mesh, from)),
            FG::surface_location(triangulation, mesh, beside(mesh, to))};
  }

  Triangulation triangulation;
  FG::Vertex_index v, w;
  const Surface& mesh;
  Vertex from, to;
};

void add_path(Network& network, const Setting& s)
{
  FG::Shortest_edge_path<Triangulation> search(s.triangulation);
  network.add_curve(FG::shortest_halfedges_through(search, Vertex_sequence{s.v, s.w}), false);
}

template <class Paths>
void rethrow(const Paths& paths)
{
  for(const auto& path : paths)
    if(path.error)
      std::rethrow_exception(path.error);
}

void compute_many(const Surface& mesh, Vertex v, Vertex w, bool has_landmarks)
{
  const std::vector<std::pair<Vertex, Vertex>> pairs = {{v, w}, {w, v}};
  std::vector<FG::Geodesic_path<Point>> paths;
  if(has_landmarks) {
    const Triangulation triangulation(mesh);
    FG::Shortest_edge_path<Triangulation> search(triangulation, FG::Search_method::LOOK_BACK);
    const FG::Landmark_distances landmarks(search);
    FG::geodesic_paths(mesh, landmarks, pairs, std::back_inserter(paths));
  } else {
    FG::geodesic_paths(mesh, pairs, std::back_inserter(paths));
  }
  rethrow(paths);
}

using Sink = std::vector<Point>;

std::vector<Entry_point> one_call_functions()
{
  return {{"geodesic_path", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex w) {
             Sink out;
             FG::geodesic_path(m, v, w, std::back_inserter(out));
           }},
          {"geodesic_path with a stop predicate", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex w) {
             Sink out;
             FG::geodesic_path(m, v, w, std::back_inserter(out), FG::Iteration_stop_predicate(1000));
           }},
          {"geodesic_path between faces", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex w) {
             Sink out;
             FG::geodesic_path(m, beside(m, v), beside(m, w), std::back_inserter(out));
           }},
          {"geodesic_path_through vertices", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex w) {
             Sink out;
             FG::geodesic_path_through(m, std::vector<Vertex>{v, w}, std::back_inserter(out));
           }},
          {"geodesic_paths", Reach::LOCAL, [](const Surface& m, Vertex v, Vertex w) { compute_many(m, v, w, false); }},
          {"geodesic_paths with landmarks", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex w) { compute_many(m, v, w, true); }},
          {"geodesic_loop", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex) {
             Sink out;
             FG::geodesic_loop(m, std::vector<Vertex>{v, next_to(m, v)}, std::back_inserter(out));
           }},
          {"straighten", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex) {
             std::vector<Sink> out;
             FG::straighten(m, std::vector<std::vector<Vertex>>{{v, next_to(m, v)}}, std::back_inserter(out));
           }},
          {"geodesic_spline", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex w) {
             Sink out;
             FG::geodesic_spline(m, std::vector<Face_location>{beside(m, v), beside(m, w)}, FG::Spline_kind::BEZIER,
                                 std::back_inserter(out));
           }},
          {"shortest_path", Reach::LOCAL, [](const Surface& m, Vertex v, Vertex w) {
             Sink out;
             FG::shortest_path(m, v, w, std::back_inserter(out));
           }}};
}

// Calls a function with the vertices' setting, and with a network in it.
template <class Function>
std::function<void(const Surface&, Vertex, Vertex)> in_setting(const Function& function)
{
  return [function](const Surface& mesh, Vertex v, Vertex w) {
    Setting s(mesh, v, w);
    function(s);
  };
}

template <class Function>
std::function<void(const Surface&, Vertex, Vertex)> in_network(const Function& function)
{
  return [function](const Surface& mesh, Vertex v, Vertex w) {
    Setting s(mesh, v, w);
    Network network(s.triangulation);
    function(s, network);
  };
}

std::vector<Entry_point> building_blocks()
{
  return {{"Shortest_edge_path", Reach::EDGES,
           in_setting([](Setting& s) { FG::Shortest_edge_path<Triangulation>(s.triangulation)(s.v, s.w); })},
          {"Shortest_edge_path::visit_all", Reach::EDGES, in_setting([](Setting& s) {
             FG::Shortest_edge_path<Triangulation>(s.triangulation).visit_all(s.v, [](FG::Vertex_index, double) {});
           })},
          {"halfedges_through", Reach::LOCAL, in_setting([](Setting& s) {
             const Vertex_sequence vertices = {s.v, s.triangulation.index(next_to(s.mesh, s.from))};
             FG::halfedges_through(s.triangulation, vertices, false);
           })},
          {"shortest_intrinsic_edge_path", Reach::LOCAL,
           in_setting([](Setting& s) { FG::shortest_intrinsic_edge_path(s.triangulation, s.v, s.w); })},
          {"shorten", Reach::LOCAL, in_network([](Setting& s, Network& network) {
             add_path(network, s);
             FG::shorten(network);
           })},
          {"add_straightened_path", Reach::LOCAL, in_network([](Setting& s, Network& network) {
             const auto path = FG::Shortest_edge_path<Triangulation>(s.triangulation)(s.v, s.w);
             FG::add_straightened_path(network, path);
           })},
          {"add_shortest_path", Reach::LOCAL, in_network([](Setting& s, Network& network) {
             FG::Shortest_edge_path<Triangulation> search(s.triangulation);
             FG::add_shortest_path(network, search, s.v, s.w);
           })},
          {"add_curve_through", Reach::LOCAL,
           in_network([](Setting& s, Network& network) { FG::add_curve_through(network, s.locations()); })},
          {"geodesics_through", Reach::LOCAL,
           in_setting([](Setting& s) { FG::geodesics_through(s.triangulation, s.locations()); })},
          {"complete_polyline", Reach::LOCAL,
           in_setting([](Setting& s) { FG::complete_polyline(s.triangulation, s.locations()); })},
          {"draw_polyline", Reach::LOCAL, in_network([](Setting& s, Network& network) {
             const FG::Surface_location p = s.locations().front();
             FG::draw_polyline(network, {p, {p.halfedge, {{1, 0, 0}}}});
           })},
          {"snap_polyline", Reach::LOCAL, in_setting([](Setting& s) {
             const FG::Surface_location p = s.locations().front();
             FG::snap_polyline(s.triangulation, {p, {p.halfedge, {{1, 0, 0}}}});
           })},
          {"insert", Reach::LOCAL, in_setting([](Setting& s) { s.triangulation.insert(s.locations().front()); })},
          {"surface_point", Reach::LOCAL,
           in_setting([](Setting& s) { FG::surface_point(s.triangulation, s.locations().front()); })},
          {"Free_geodesic_spline", Reach::LOCAL, in_setting([](Setting& s) {
             FG::Free_geodesic_spline<Triangulation> spline(s.triangulation, s.locations(), FG::Spline_kind::BEZIER);
             spline.refine();
             spline.finish();
           })},
          {"Geodesic_spline", Reach::LOCAL, in_network([](Setting& s, Network& network) {
             FG::Geodesic_spline<Network> spline(network, FG::add_curve_through(network, s.locations()));
             spline.refine();
             spline.finish();
           })},
          {"Geodesic_tree", Reach::LOCAL, in_setting([](Setting& s) {
             FG::Geodesic_tree<Triangulation> tree(s.triangulation);
             tree.grow(s.v, 1.5);
             FG::make_shortest(tree);
             FG::logarithmic_map(tree);
           })},
          {"certify", Reach::LOCAL, in_network([](Setting& s, Network& network) {
             add_path(network, s);
             FG::shorten(network);
             FG::certify(network);
             FG::Straightness_meter<Network> meter(network);
             meter(0_c);
             FG::Curve_extractor<Network> extractor(network);
             extractor.surface_points(0_c);
           })},
          {"edges_near_curves", Reach::LOCAL, in_network([](Setting& s, Network& network) {
             add_path(network, s);
             FG::flip_to_delaunay(s.triangulation, FG::edges_near_curves(network));
           })}};
}

std::vector<Entry_point> functions_of_the_whole_mesh()
{
  const auto add_regions = [](Setting& s, Network& network, FG::Junctions junctions) {
    std::vector<int> regions(s.mesh.number_of_faces(), 0);
    if(!regions.empty())
      regions.back() = 1;
    FG::add_region_boundaries(
        network, s.mesh, boost::make_iterator_property_map(regions.begin(), get(boost::face_index, s.mesh)), junctions);
  };
  return {{"flip_to_delaunay", Reach::WHOLE, in_setting([](Setting& s) { FG::flip_to_delaunay(s.triangulation); })},
          {"is_delaunay", Reach::WHOLE, in_setting([](Setting& s) { FG::is_delaunay(s.triangulation); })},
          {"refine", Reach::WHOLE, in_setting([](Setting& s) { FG::refine(s.triangulation); })},
          {"intrinsic_faces", Reach::WHOLE, in_setting([](Setting& s) {
             std::vector<FG::Intrinsic_face> faces;
             FG::intrinsic_faces(s.triangulation, std::back_inserter(faces));
           })},
          {"common_subdivision", Reach::WHOLE,
           in_setting([](Setting& s) { FG::common_subdivision(s.triangulation, s.mesh); })},
          {"insert_curves", Reach::WHOLE,
           in_network([](Setting& s, Network& network) { FG::insert_curves(network, s.mesh); })},
          {"cut_along_curves", Reach::WHOLE,
           in_network([](Setting& s, Network& network) { FG::cut_along_curves(network, s.mesh); })},
          {"add_region_boundaries with fixed junctions", Reach::WHOLE,
           in_network([=](Setting& s, Network& network) { add_regions(s, network, FG::Junctions::FIXED); })},
          {"add_region_boundaries with free junctions", Reach::WHOLE,
           in_network([=](Setting& s, Network& network) { add_regions(s, network, FG::Junctions::FREE); })},
          {"add_seams", Reach::WHOLE, in_network([](Setting& s, Network& network) {
             const std::vector<int> texture(s.mesh.number_of_halfedges(), 0);
             const auto map = boost::make_iterator_property_map(texture.begin(), get(boost::halfedge_index, s.mesh));
             FG::add_seams(network, s.mesh, map);
           })},
          {"add_marked_edges", Reach::EDGES, in_network([](Setting& s, Network& network) {
             FG::add_marked_edges(network, s.mesh, boost::static_property_map<bool, Surface::Edge_index>(false));
           })},
          {"Mollified_metric", Reach::WHOLE, in_setting([](Setting& s) {
             FG::Mollified_metric<Triangulation::Metric>(s.mesh, s.triangulation.metric());
           })},
          {"Landmark_distances", Reach::EDGES, in_setting([](Setting& s) {
             FG::Shortest_edge_path<Triangulation> search(s.triangulation);
             FG::Landmark_distances{search};
           })},
          {"write_network and read_network", Reach::EDGES, in_network([](Setting& s, Network& network) {
             std::stringstream file;
             FG::write_network(file, network);
             FG::read_network(file, network);
             BOOST_TEST(s.triangulation.log_position() == 0u);
           })}};
}

std::vector<Entry_point> entry_points()
{
  std::vector<Entry_point> result = one_call_functions();
  for(const auto& more : {building_blocks(), functions_of_the_whole_mesh()})
    result.insert(result.end(), more.begin(), more.end());
  return result;
}

// What a call throws: nothing, or the message of an `Expected`; any other exception is an error of this test.
template <class Expected = FG::Error>
std::string thrown(const Entry_point& entry, const Surface& mesh, Vertex v, Vertex w)
{
  BOOST_TEST_CONTEXT(entry.name)
  {
    try {
      entry.call(mesh, v, w);
      return "";
    } catch(const Expected& error) {
      return error.what();
    } catch(const std::exception& error) {
      BOOST_ERROR(error.what());
      return "";
    }
  }
  return "";
}

Vertex vertex(int v) { return Vertex(static_cast<Surface::size_type>(v)); }

} // namespace

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
      const bool can_do_without = !takes_vertices(entry) || (!mesh.is_empty() && entry.name == "Geodesic_tree") ||
                                  (!mesh.is_empty() && entry.name == "Shortest_edge_path::visit_all");
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
    BOOST_CHECK_THROW(FG::Free_geodesic_spline<Triangulation>(t, way, FG::Spline_kind::BEZIER),
                      FG::Invalid_location_error);
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
    BOOST_CHECK_THROW(network.add_curve(chain, false), FG::Invalid_curve_error);
    BOOST_CHECK_THROW(FG::add_straightened_path(network, chain), FG::Invalid_curve_error);
    BOOST_TEST(network.number_of_curves() == 0);
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

// ---------------------------------------------------------------- one network in a triangulation

BOOST_AUTO_TEST_CASE(a_second_network_is_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Setting s(mesh, vertex(0), vertex(40));
  {
    Network network(s.triangulation);
    BOOST_CHECK_THROW(Network{s.triangulation}, FG::Occupied_triangulation_error); // also while it is empty
    add_path(network, s);
    const auto before = network.halfedges(0_c);
    BOOST_CHECK_THROW(Network{s.triangulation}, FG::Occupied_triangulation_error);
    BOOST_TEST((network.halfedges(0_c) == before));
    BOOST_TEST(network.is_valid());
    BOOST_TEST(FG::shorten(network).is_complete());
  }
  s.triangulation.rollback();
  Network network(s.triangulation);
  add_path(network, s);
  BOOST_TEST(FG::shorten(network).is_complete());
}

// What makes networks of its own, or flips edges without a look at the labels.
BOOST_AUTO_TEST_CASE(what_disturbs_a_network_is_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Setting s(mesh, vertex(0), vertex(40));
  Triangulation& t = s.triangulation;
  Network network(t);
  add_path(network, s);
  FG::shorten(network);
  const auto before = network.halfedges(0_c);
  const auto position = t.log_position();
  FG::Geodesic_tree<Triangulation> tree(t);
  Triangulation other(mesh);
  BOOST_CHECK_THROW(tree.grow(3_v), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::refine(t), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::geodesics_through(t, s.locations()), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::complete_polyline(t, s.locations()), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(FG::Free_geodesic_spline<Triangulation>(t, s.locations(), FG::Spline_kind::BEZIER),
                    FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(Triangulation{std::move(t)}, FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(other = std::move(t), FG::Occupied_triangulation_error);
  BOOST_CHECK_THROW(t = std::move(other), FG::Occupied_triangulation_error);
  BOOST_TEST((network.halfedges(0_c) == before));
  BOOST_TEST(network.is_valid());
  BOOST_TEST(t.is_valid());
  BOOST_TEST(t.log_position() == position);

  network.clear(); // an empty network stands in the way of others, but of nothing else
  t.rollback();
  BOOST_CHECK_NO_THROW(FG::geodesics_through(t, s.locations()));
  BOOST_CHECK_THROW(Network{t}, FG::Occupied_triangulation_error);
  BOOST_CHECK_NO_THROW(tree.grow(3_v));
  network.add_curve(tree.path(40_v), false);
  BOOST_CHECK_THROW(FG::make_shortest(tree), FG::Occupied_triangulation_error);
}

BOOST_AUTO_TEST_CASE(a_point_on_an_edge_under_a_curve_is_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 6, Diagonal_rule::RISING));
  Triangulation t(mesh);
  Network network(t);
  const FG::Halfedge_index along = t.outgoing(16_v);
  const FG::Input_halfedge_index h = FG::internal::as_input(along);
  network.add_curve(Halfedge_sequence{along}, false);
  const auto position = t.log_position();
  BOOST_CHECK_THROW(t.insert({h, {{1, 1, 0}}}), FG::Occupied_triangulation_error);
  BOOST_TEST(t.log_position() == position);
  BOOST_TEST(network.is_valid());
  BOOST_TEST(t.is_valid());
  BOOST_CHECK_NO_THROW(t.insert({h, {{1, 1, 1}}}));
  BOOST_CHECK_NO_THROW(network.insert({h, {{1, 1, 0}}}));
  BOOST_TEST(network.halfedges(0_c).size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_network_can_outlive_its_triangulation)
{
  const Surface mesh = to_mesh<Surface>(octahedron(2));
  auto triangulation = std::make_unique<Triangulation>(mesh);
  Network network(*triangulation);
  network.add_curve(Halfedge_sequence{0_h}, false);
  triangulation.reset(); // nothing is written there any more
}

// ---------------------------------------------------------------- one predicate for several curves

namespace {

// Allows some steps altogether; a restarted one as many again.
struct Budget_stop_predicate
{
  std::size_t budget;
  std::shared_ptr<std::size_t> used = std::make_shared<std::size_t>(0);

  FG::Stop_decision operator()(const FG::Shortening_step&) const
  {
    return (*used)++ < budget ? FG::Stop_decision::CONTINUE : FG::Stop_decision::ITERATION_LIMIT;
  }

  Budget_stop_predicate restarted() const { return {budget}; }
};

} // namespace

BOOST_AUTO_TEST_CASE(each_path_has_its_own_budget)
{
  const Surface mesh = to_mesh<Surface>(shaken(octahedron(6), 0.2, 5));
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for(int v = 0; v < 30; ++v)
    pairs.push_back({vertex(v), vertex(v + 100)});
  const auto statuses = [&](const auto& stop) {
    std::vector<FG::Geodesic_path<Point>> paths;
    FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), stop);
    rethrow(paths);
    std::vector<FG::Shortening_status> result;
    for(const auto& path : paths)
      result.push_back(path.report.status);
    return result;
  };
  const auto complete = statuses(FG::Never_stop_predicate());
  BOOST_TEST((statuses(Budget_stop_predicate{200}) == complete));
  BOOST_TEST((statuses(FG::Any_stop_predicate<Budget_stop_predicate, FG::Iteration_stop_predicate>(
                  Budget_stop_predicate{200}, FG::Iteration_stop_predicate(1000))) == complete));
  BOOST_TEST((statuses(Budget_stop_predicate{1}) != complete));

  // The time is over for a single path, but not for many.
  const FG::Time_stop_predicate stop(std::chrono::seconds(2));
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  BOOST_TEST((stop(FG::Shortening_step()) == FG::Stop_decision::ITERATION_LIMIT));
  BOOST_TEST((stop.restarted()(FG::Shortening_step()) == FG::Stop_decision::CONTINUE));
  BOOST_TEST((statuses(stop) == complete));
  for(FG::Shortening_status status : statuses(FG::Time_stop_predicate(std::chrono::seconds(0))))
    BOOST_TEST((status == FG::Shortening_status::ITERATION_LIMIT));
  for(FG::Shortening_status status : statuses(FG::Time_stop_predicate(std::chrono::duration<double>(1e300))))
    BOOST_TEST((status == FG::Shortening_status::LOCALLY_SHORTEST));
}

BOOST_AUTO_TEST_CASE(each_leg_has_its_own_budget)
{
  const Surface mesh = to_mesh<Surface>(shaken(octahedron(6), 0.2, 5));
  std::vector<Vertex> way;
  for(int v = 0; v < 100; v += 9)
    way.push_back(vertex(v));
  const auto status = [&](std::size_t budget) {
    Sink out;
    return FG::geodesic_path_through(mesh, way, std::back_inserter(out), Budget_stop_predicate{budget})
        .report.curves.front()
        .status;
  };
  BOOST_TEST((status(100) == FG::Shortening_status::LOCALLY_SHORTEST));
  BOOST_TEST((status(0) == FG::Shortening_status::ITERATION_LIMIT));
}
