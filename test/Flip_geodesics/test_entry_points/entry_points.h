// SPDX-License-Identifier: LGPL-3.0-or-later
//
// All public functions and constructors, and meshes that they were not made for.

#ifndef FLIP_GEODESICS_TEST_ENTRY_POINTS_ENTRY_POINTS_H
#define FLIP_GEODESICS_TEST_ENTRY_POINTS_ENTRY_POINTS_H

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

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;
using Vertex = Surface::Vertex_index;
using Face = Surface::Face_index;
using Point = Surface::Point;
using Triangulation = Curve_setting::Triangulation;
using Network = Curve_setting::Network;
using Face_location = std::pair<Face, std::array<double, 3>>;

inline Surface polygon_mesh(const std::vector<Coordinates>& points, const std::vector<std::vector<int>>& polygons)
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

inline Surface quad_cube()
{
  return polygon_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

// A grid of n by n squares from (i, i) to (j, j) of which is one polygon.
inline Surface grid_with_polygon(int n, int i, int j)
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
inline void add_digon(Surface& mesh, Surface::Halfedge_index h)
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

inline bool is_vertex(const Surface& mesh, Vertex v) { return static_cast<std::size_t>(v) < mesh.number_of_vertices(); }

// The end of an edge at a vertex; the vertex itself if there is none.
inline Vertex next_to(const Surface& mesh, Vertex v)
{
  return is_vertex(mesh, v) && mesh.halfedge(v) != Surface::null_halfedge() ? mesh.source(mesh.halfedge(v)) : v;
}

// The middle of a face at a vertex; in no face if there is none.
inline Face_location beside(const Surface& mesh, Vertex v)
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

inline void add_path(Network& network, const Setting& s)
{
  FG::Shortest_edge_path<Triangulation> search(s.triangulation);
  network.add_curve(FG::shortest_halfedges_through(search, Vertex_sequence{s.v, s.w}));
}

template <class Paths>
void rethrow(const Paths& paths)
{
  for(const auto& path : paths)
    if(path.error)
      std::rethrow_exception(path.error);
}

inline void compute_many(const Surface& mesh, Vertex v, Vertex w, bool has_landmarks)
{
  const std::vector<std::pair<Vertex, Vertex>> pairs = {{v, w}, {w, v}};
  std::vector<FG::Geodesic_path_result<Point>> paths;
  if(has_landmarks) {
    const Triangulation triangulation(mesh);
    FG::Shortest_edge_path<Triangulation> search(triangulation,
                                                 CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
    const FG::Landmark_distances landmarks(search);
    FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), CGAL::parameters::landmarks(landmarks));
  } else {
    FG::geodesic_paths(mesh, pairs, std::back_inserter(paths));
  }
  rethrow(paths);
}

using Sink = std::vector<Point>;

inline std::vector<Entry_point> one_call_functions()
{
  return {{"geodesic_path", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex w) {
             Sink out;
             FG::geodesic_path(m, v, w, std::back_inserter(out));
           }},
          {"geodesic_path with a stop predicate", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex w) {
             Sink out;
             FG::geodesic_path(m, v, w, std::back_inserter(out),
                               CGAL::parameters::stop_predicate(FG::Iteration_stop_predicate(1000)));
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
          {"geodesic_network", Reach::LOCAL,
           [](const Surface& m, Vertex v, Vertex) {
             std::vector<Sink> out;
             FG::geodesic_network(m, std::vector<std::vector<Vertex>>{{v, next_to(m, v)}}, std::back_inserter(out));
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

inline std::vector<Entry_point> building_blocks()
{
  return {{"Shortest_edge_path", Reach::EDGES,
           in_setting([](Setting& s) { FG::Shortest_edge_path<Triangulation>(s.triangulation)(s.v, s.w); })},
          {"Shortest_edge_path::visit_all", Reach::EDGES, in_setting([](Setting& s) {
             FG::Shortest_edge_path<Triangulation>(s.triangulation).visit_all(s.v, [](FG::Vertex_index, double) {});
           })},
          {"Geodesic_landmarks of vertices", Reach::WHOLE, in_setting([](Setting& s) {
             FG::Geodesic_landmarks{s.triangulation, Vertex_sequence{s.v, s.w}};
           })},
          {"halfedges_through", Reach::LOCAL, in_setting([](Setting& s) {
             const Vertex_sequence vertices = {s.v, s.triangulation.index(next_to(s.mesh, s.from))};
             FG::halfedges_through(s.triangulation, vertices);
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
          {"Geodesic_spline", Reach::LOCAL, in_network([](Setting& s, Network& network) {
             FG::Geodesic_spline<Triangulation> spline(s.triangulation, s.locations(), FG::Spline_kind::BEZIER);
             spline.refine();
             FG::add_curve_along(network, spline.finish());
           })},
          {"Geodesic_tree", Reach::LOCAL, in_setting([](Setting& s) {
             FG::Geodesic_tree<Triangulation> tree(s.triangulation);
             tree.grow(s.v, CGAL::parameters::max_distance(1.5));
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

inline std::vector<Entry_point> functions_of_the_whole_mesh()
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
          {"Geodesic_landmarks", Reach::WHOLE, in_setting([](Setting& s) {
             FG::Geodesic_landmarks{s.triangulation, 2};
           })},
          {"write_network and read_network", Reach::EDGES, in_network([](Setting& s, Network& network) {
             std::stringstream file;
             FG::write_network(file, network);
             FG::read_network(file, network);
             BOOST_TEST(s.triangulation.log_position() == 0u);
           })}};
}

inline std::vector<Entry_point> entry_points()
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

inline Vertex vertex(int v) { return Vertex(static_cast<Surface::size_type>(v)); }

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_ENTRY_POINTS_ENTRY_POINTS_H
