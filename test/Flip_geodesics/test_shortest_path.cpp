// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE shortest_path

#include "Curve_setting.h"
#include "closed_forms.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "test_scale.h"
#include "test_shortest_path/shortest.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

using namespace shortest_path_test;

BOOST_AUTO_TEST_CASE(closed_forms)
{
  for(Diagonal_rule rule : {Diagonal_rule::RISING, Diagonal_rule::RANDOM}) {
    const Mesh_soup plane = flat_grid(8, 6, rule);
    check_against("grid", plane, [&](int u, int v) { return distance(plane.points[u], plane.points[v]); });
  }
  const Mesh_soup jittered = jittered_grid(8, 8, Diagonal_rule::RANDOM, 0.2, 9);
  check_against("jittered grid", jittered,
                [&](int u, int v) { return distance(jittered.points[u], jittered.points[v]); });
  check_against("cylinder", cylinder(9, 7, 1.25, 8),
                [](int u, int v) { return cylinder_distance(9, 7, 1.25, 8, u, v); });
  const Mesh_soup pyramid = tetrahedron(5);
  check_against("tetrahedron", pyramid,
                [&](int u, int v) { return tetrahedron_distance(5, pyramid.points[u], pyramid.points[v]); });
  const Mesh_soup block = box(5, 4, 3, 1);
  check_against("box", block, [&](int u, int v) { return box_distance(5, 4, 3, block.points[u], block.points[v]); });
  constexpr int k = 8, m = 4;
  constexpr double total = 8;
  check_against("saddle", saddle_disk(k, m, total), [](int u, int v) {
    const auto radius = [](int w) { return w == 0 ? 0 : 1 + (w - 1) / k; };
    const int turn = u == 0 || v == 0 ? 0 : std::abs((u - 1) % k - (v - 1) % k);
    return cone_distance(radius(u), radius(v), (std::min)(turn, k - turn) * total / k);
  });
}

// Without closed forms: the tree from s to t and the path from t to s are found in different ways and must agree.
BOOST_AUTO_TEST_CASE(curved_meshes)
{
  std::size_t longer = 0;
  for(const Mesh_soup& soup : {bumpy_sphere(8, 0.3, 1), torus(20, 10, 3, 1), genus_3_plate(2),
                               random_convex_polyhedron(80, 2), grid_with_hole(9, 9, 3, 6, 3, 6)})
  {
    Setting setting(soup);
    Tree tree(setting.triangulation);
    tree.grow(3_v);
    const FG::Distances_report report = FG::make_shortest(tree);
    BOOST_TEST(report.is_confirmed());
    BOOST_TEST(report.longer == 0u);
    BOOST_TEST(tree.is_valid(tolerance));
    longer += report.longer_before;
    Distances distances;
    for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices()))
      distances.push_back(tree.distance(v));
    setting.triangulation.rollback();
    for(int i = 0; i < setting.triangulation.number_of_vertices(); i += 7) {
      const Vertex_index v(i);
      if(v == 3_v)
        continue;
      const auto path = shortest(setting, v, 3_v);
      BOOST_TEST(path.is_confirmed());
      BOOST_TEST(std::abs(path.length - distances[v]) <= tolerance * path.length);
    }
  }
  BOOST_TEST(longer > 0u); // otherwise nothing was tried
}

// Heights so large that shortest paths cross faces of the triangulation several times, and cross paths of the tree.
static Mesh_soup terrain(unsigned seed)
{
  Random_numbers random(seed);
  return mapped(flat_grid(16, 16, Diagonal_rule::RANDOM), [&](const Coordinates& p) {
    return Coordinates{p[0], p[1], random.uniform(0, 100)};
  });
}

BOOST_AUTO_TEST_CASE(rough_terrain)
{
  for(unsigned seed : {1, 2}) {
    Setting setting(terrain(seed));
    Tree tree(setting.triangulation);
    tree.grow(3_v);
    const FG::Distances_report report = FG::make_shortest(tree);
    BOOST_TEST(report.is_confirmed());
    BOOST_TEST(report.longer_before > 200u);
    BOOST_TEST(report.longer == 0u);
    BOOST_TEST(tree.is_valid(tolerance));
    BOOST_TEST(setting.triangulation.is_valid());
    for(Edge_index e : descriptors<Edge_index>(setting.triangulation.number_of_edges()))
      BOOST_TEST(setting.triangulation.holds(e) == 0);
    Distances distances;
    for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices()))
      distances.push_back(tree.distance(v));
    setting.triangulation.rollback();
    for(int i = 0; i < setting.triangulation.number_of_vertices(); i += 7 * stride) {
      const Vertex_index v(i);
      const auto path = shortest(setting, v, 3_v); // of some, legs are in each other's way
      BOOST_TEST(path.is_confirmed());
      BOOST_TEST(std::abs(path.length - distances[v]) <= tolerance * path.length);
    }
  }
}

// Rays that run along edges, one behind the other, tie at the apex of a face. A search that dropped one of them for a
// crossing that was to the left of the other by rounding called paths shortest that were 5 % longer than geodesics.
BOOST_AUTO_TEST_CASE(no_geodesic_is_shorter_than_a_confirmed_path)
{
  for(const Mesh_soup& soup : {cylinder(12, 8, 1, 2), genus_3_plate(2), grid_with_hole(10, 10, 2, 3, 2, 9)}) {
    Setting setting(soup);
    for(Vertex_index source : descriptors<Vertex_index>(12)) {
      Tree tree(setting.triangulation);
      tree.grow(source);
      Distances distances;
      for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices()))
        distances.push_back(tree.distance(v));
      const FG::Distances_report report = FG::make_shortest(tree);
      BOOST_TEST(report.is_confirmed(), "source " << source.idx());
      BOOST_TEST(report.longer == 0u);
      setting.triangulation.rollback();
      for(int i = source.idx() + 5; i < setting.triangulation.number_of_vertices(); i += 20) {
        const Vertex_index v(i);
        const auto path = shortest(setting, source, v);
        BOOST_TEST(path.is_confirmed());
        BOOST_TEST(path.length <= distances[v] * (1 + tolerance), source.idx() << " to " << v.idx());
      }
    }
  }
}

// Vertices that are moved beyond a neighbor leave degenerate faces, which fold: light passes them, and angles of pi.
BOOST_AUTO_TEST_CASE(no_path_over_faces_without_area_is_confirmed_if_there_is_a_shorter_one)
{
  int confirmed = 0;
  for(unsigned seed = 0; seed < 12; ++seed) {
    Random_numbers random(seed);
    Mesh_soup soup = genus_3_plate(1);
    for(int i = 0; i < 3; ++i) {
      const auto& t = soup.triangles[static_cast<std::size_t>(random.below(static_cast<int>(soup.triangles.size())))];
      for(int k = 0; k < 3; ++k)
        soup.points[t[0]][k] = 2 * soup.points[t[1]][k] - soup.points[t[2]][k];
    }
    Setting setting(soup);
    for(Vertex_index source : {0_v, 20_v}) {
      FG::Geodesic_distance_field<Setting::Triangulation> field(setting.triangulation, setting.mesh);
      field.add_source(source);
      try {
        field.compute();
      } catch(const FG::Degenerate_face_error&) { // two vertices in one place
        continue;
      }
      for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices())) {
        if(v == source)
          continue;
        const auto path = shortest(setting, source, v, FG::Window_limit(20000));
        confirmed += path.is_confirmed() ? 1 : 0;
        BOOST_TEST(path.lower_bound <= field.distance(v) * (1 + tolerance), source << " to " << v << ", " << seed);
      }
    }
  }
  BOOST_TEST(confirmed > 500);
}

// Lengths of 1, 2 and 3, of which three in many faces make one without area. There the leg that is to be inserted gets
// lost, and the path is left as it was.
BOOST_AUTO_TEST_CASE(a_leg_that_gets_lost_among_faces_without_area_is_in_nothings_way)
{
  using Traits = FG::Certified_intrinsic_triangulation_traits<Length_metric::Kernel>;
  using Length_setting = Basic_curve_setting<FG::Intrinsic_triangulation<Surface, Traits, Length_metric>>;
  const auto corner = [](int i, int j) { return i % 4 * 4 + j % 4; };
  Mesh_soup soup;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 4; ++j) {
      soup.points.push_back({0, 0, 0});
      soup.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      soup.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  const Surface mesh = to_mesh<Surface>(soup);
  std::map<boost::graph_traits<Surface>::edge_descriptor, double> lengths;
  for(char digit : std::string("212312211233312323212132133321132231213322322231")) {
    const auto e = Surface::Edge_index(static_cast<Surface::size_type>(lengths.size()));
    lengths[e] = digit - '0';
  }
  Length_setting setting(soup, Length_metric(mesh, Length_map(lengths)));
  const Vertex_index source = 13_v, target = 10_v;
  FG::Geodesic_distance_field<Length_setting::Triangulation> field(setting.triangulation, setting.mesh);
  field.add_source(source);
  field.compute();
  Length_setting::Search search(setting.triangulation);
  const auto path = FG::add_shortest_path(setting.network, search, source, target);
  BOOST_TEST(setting.triangulation.is_valid());
  BOOST_TEST(setting.network.is_valid());
  BOOST_TEST(path.lower_bound <= field.distance(target) * (1 + tolerance));
  BOOST_TEST((path.length <= field.distance(target) * (1 + tolerance) || !path.is_confirmed()));
}

// Given up, the search still says how much shorter a path could be.
BOOST_AUTO_TEST_CASE(limited_effort)
{
  Setting setting(bumpy_sphere(10, 0.3, 1));
  Random_numbers random(3);
  int unconfirmed = 0;
  for(int i = 0; i < 40; ++i) {
    const Vertex_index s(random.below(360)), t(360 + i);
    const auto exact = shortest(setting, s, t), limited = shortest(setting, s, t, FG::Window_limit(30));
    BOOST_TEST(exact.is_confirmed());
    BOOST_TEST(limited.lower_bound <= exact.length * (1 + tolerance));
    BOOST_TEST(limited.lower_bound > 0);
    BOOST_TEST(limited.length >= exact.length * (1 - tolerance));
    BOOST_TEST(limited.gap() >= limited.length - exact.length - tolerance);
    BOOST_TEST(limited.windows < exact.windows + 30);
    if(limited.is_confirmed())
      BOOST_TEST(std::abs(limited.length - exact.length) <= tolerance * exact.length);
    unconfirmed += limited.is_confirmed() ? 0 : 1;
  }
  BOOST_TEST(unconfirmed > 0);
}

BOOST_AUTO_TEST_CASE(limited_distance)
{
  const Mesh_soup soup = bumpy_sphere(10, 0.3, 1);
  Setting setting(soup);
  Tree whole(setting.triangulation);
  whole.grow(11_v);
  FG::make_shortest(whole);
  Distances distances;
  for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices()))
    distances.push_back(whole.distance(v));
  setting.triangulation.rollback();
  Tree part(setting.triangulation);
  part.grow(11_v, CGAL::parameters::max_distance(0.8));
  const auto report = FG::make_shortest(part);
  BOOST_TEST(report.longer == 0u);
  std::size_t reached = 0;
  for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices())) {
    BOOST_TEST(part.is_reached(v) == (distances[v] <= 0.8));
    if(!part.is_reached(v))
      continue;
    BOOST_TEST(std::abs(part.distance(v) - distances[v]) <= tolerance);
    ++reached;
  }
  BOOST_TEST(report.vertices + 1 == reached);
}

// The last vertex within a limit is found, though the tree's own path to it is longer than that.
BOOST_AUTO_TEST_CASE(vertices_that_a_tree_missed_are_added)
{
  Setting setting(terrain(1));
  const auto vertices = descriptors<Vertex_index>(setting.triangulation.number_of_vertices());
  Tree tree(setting.triangulation);
  tree.grow(3_v);
  Distances before, distances;
  for(Vertex_index v : vertices)
    before.push_back(tree.distance(v));
  FG::make_shortest(tree);
  for(Vertex_index v : vertices)
    distances.push_back(tree.distance(v));
  int missed = 0;
  for(Vertex_index last : vertices) {
    if(missed == 8 || !(before[last] > 1.01 * distances[last]))
      continue;
    setting.triangulation.rollback();
    Tree part(setting.triangulation);
    part.grow(3_v, CGAL::parameters::max_distance(distances[last] * (1 + 1e-9)));
    if(part.is_reached(last))
      continue;
    ++missed;
    const FG::Distances_report report = FG::make_shortest(part);
    BOOST_TEST(part.is_reached(last));
    BOOST_TEST(report.longer == 0u);
    BOOST_TEST((report.largest_excess_before >= 0 && report.largest_excess_before < 100));
  }
  BOOST_TEST(missed == 8);
}

// A degenerate face does not stop the path, but nothing is confirmed that rays could not be followed for. Where no path
// that is short enough can pass it, it does not matter.
BOOST_AUTO_TEST_CASE(degenerate_face_on_the_way)
{
  for(int row : {3, 5}) {
    Mesh_soup soup = flat_grid(6, 6, Diagonal_rule::RISING);
    soup.points[grid_vertex(6, 3, row)] = soup.points[grid_vertex(6, 3, row - 1)];
    soup = mapped(soup, [](const Coordinates& p) { return Coordinates{p[0], p[1], p[1] > 1.5 ? 0.5 : 0}; });
    Setting setting(soup);
    Setting::Search search(setting.triangulation);
    const Vertex_index source(grid_vertex(6, 0, 0)), target(grid_vertex(6, 6, 3));
    const auto report = FG::add_shortest_path(setting.network, search, source, target);
    BOOST_TEST(report.is_confirmed() == (row == 5));
    BOOST_TEST(report.lower_bound <= report.length);
    BOOST_TEST(report.lower_bound > 0);
  }
}

BOOST_AUTO_TEST_CASE(one_call)
{
  const Mesh_soup soup = tetrahedron(5);
  const Surface mesh = to_mesh<Surface>(soup);
  std::vector<Surface::Point> points;
  const auto result =
      FG::shortest_path(mesh, Surface::Vertex_index(7), Surface::Vertex_index(40), std::back_inserter(points));
  BOOST_TEST(result.report.is_confirmed());
  BOOST_TEST(std::abs(result.report.length - tetrahedron_distance(5, soup.points[7], soup.points[40])) <= tolerance);
  double length = 0;
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
    length += std::sqrt(CGAL::to_double(CGAL::squared_distance(points[i], points[i + 1])));
  BOOST_TEST(std::abs(length - result.report.length) <= tolerance);
  points.clear();
  const auto point =
      FG::shortest_path(mesh, Surface::Vertex_index(7), Surface::Vertex_index(7), std::back_inserter(points)).report;
  BOOST_TEST((point.verdict == FG::Verdict::WITHIN_ROUNDING));
  BOOST_TEST((point.status() == FG::Shortening_status::CONTRACTED));
  BOOST_TEST(point.length == 0);
  BOOST_TEST(points.size() == 2u);
  const auto limited =
      FG::shortest_path(mesh, Surface::Vertex_index(7), Surface::Vertex_index(40), std::back_inserter(points),
                        CGAL::parameters::search_limit(FG::Window_limit(1)));
  BOOST_TEST(limited.report.windows <= 60u);
  BOOST_TEST((limited.status() == FG::Shortening_status::LOCALLY_SHORTEST));
  BOOST_TEST((limited.verdict() == limited.report.verdict));
}

// The error of a length may exceed a short edge: its ends do not lower each other's distances for ever. Edges on the
// border let rays start without a window.
BOOST_AUTO_TEST_CASE(an_edge_shorter_than_the_error_of_a_length)
{
  const std::size_t edges = 3;
  for(double height : {1e10, 1e15, 1e17, 1e30}) {
    const Surface mesh = to_mesh<Surface>(Mesh_soup{{{-1, 0, 0}, {0, 0, 0}, {0, 0, height}}, {{0, 1, 2}}});
    std::vector<Surface::Point> points;
    const auto result =
        FG::shortest_path(mesh, Surface::Vertex_index(2), Surface::Vertex_index(0), std::back_inserter(points));
    BOOST_TEST(result.report.windows <= edges);
    BOOST_TEST((result.report.verdict == FG::Verdict::WITHIN_ROUNDING));
    BOOST_TEST(std::abs(result.length() - height) <= 1e-12 * height);
  }
}

// Whenever a visitor stops the computation, in the search or before it, nothing wrong is confirmed.
BOOST_AUTO_TEST_CASE(a_visitor_stops_the_search)
{
  const Surface mesh = to_mesh<Surface>(bumpy_sphere(32, 0.2, 3));
  const Surface::Vertex_index source(0), target(static_cast<unsigned>(mesh.number_of_vertices() / 2));
  struct Stopping_visitor : FG::Default_shortening_visitor
  {
    std::size_t calls = 0, most = std::numeric_limits<std::size_t>::max();
    bool go_further() { return ++calls <= most; }
  };
  const auto compute = [&](Stopping_visitor& visitor) {
    std::vector<Surface::Point> points;
    return FG::shortest_path(mesh, source, target, std::back_inserter(points),
                             CGAL::parameters::visitor(std::ref(visitor)))
        .report;
  };
  Stopping_visitor patient;
  const auto complete = compute(patient);
  BOOST_TEST((complete.verdict == FG::Verdict::WITHIN_ROUNDING));
  BOOST_TEST(patient.calls > complete.shortening.flip_outs + 2); // the search has called it, too
  for(std::size_t most = 0; most <= patient.calls; ++most) {
    Stopping_visitor visitor;
    visitor.most = most;
    const auto report = compute(visitor);
    BOOST_TEST(report.is_confirmed() == (most == patient.calls));
    BOOST_TEST(report.lower_bound <= complete.length);
    BOOST_TEST(report.length >= complete.lower_bound);
    BOOST_TEST(visitor.calls == std::min(most + 1, patient.calls));
    if(most < patient.calls)
      BOOST_TEST((report.status() == FG::Shortening_status::STOPPED_BY_VISITOR));
  }
}

// Given up, a tree stays as it was grown, and nothing is claimed.
BOOST_AUTO_TEST_CASE(tree_with_limited_effort)
{
  std::size_t longer = 0;
  for(const Mesh_soup& soup : {bumpy_sphere(8, 0.3, 1), terrain(1), terrain(2)}) {
    Setting setting(soup);
    Tree tree(setting.triangulation);
    const auto grown = tree.grow(0_v);
    const auto position = setting.triangulation.log_position();
    const FG::Distances_report report = FG::make_shortest(tree, CGAL::parameters::search_limit(FG::Window_limit(100)));
    BOOST_TEST(!report.is_confirmed());
    BOOST_TEST(report.flips == 0u);
    BOOST_TEST(report.longer == report.longer_before);
    BOOST_TEST(setting.triangulation.log_position() == position);
    BOOST_TEST(FG::to_string(grown.status) == FG::to_string(report.status));
    longer += report.longer;
  }
  BOOST_TEST(longer > 0u); // would be mended otherwise
}

// The search knows the vertices of the input only: others keep geodesics, and are no sources.
BOOST_AUTO_TEST_CASE(inserted_vertices)
{
  Setting setting(bumpy_sphere(8, 0.3, 1));
  Random_numbers random(4);
  for(int i = 0; i < 60; ++i)
    setting.triangulation.insert(
        {FG::Input_halfedge_index(random.below(setting.triangulation.input().number_of_halfedges())), {{1, 1, 1}}});
  Tree tree(setting.triangulation);
  tree.grow(0_v);
  const FG::Distances_report report = FG::make_shortest(tree);
  BOOST_TEST(report.longer == 0u);
  BOOST_TEST(report.longer_before > 0u);
  BOOST_TEST(tree.is_valid(tolerance));
  for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices()))
    BOOST_TEST(tree.is_reached(v));
  tree.grow(Vertex_index(setting.triangulation.number_of_vertices() - 1));
  BOOST_CHECK_THROW(FG::make_shortest(tree), FG::Vertex_out_of_range_error);
}

// A face so flat that nobody can tell where rays leave it is passed by all that may be, also one without area.
BOOST_AUTO_TEST_CASE(paths_over_flat_faces_are_confirmed)
{
  double length = 0;
  for(double height : {1e-3, 1e-6, 1e-11, 0.0}) {
    Setting setting(Mesh_soup{{{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}, {1, height, 0}, {0.9, -1, 0}},
                              {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}}});
    const auto report = shortest(setting, 5_v, 2_v);
    BOOST_TEST(report.is_confirmed());
    BOOST_TEST(report.gap() <= 1e-12 * report.length);
    BOOST_TEST((length == 0 || std::abs(report.length - length) <= 2e-3));
    length = report.length;
  }
}

// A mesh that is scaled by a power of two has the same trees.
BOOST_AUTO_TEST_CASE(trees_do_not_depend_on_the_scale)
{
  std::size_t replaced = 0;
  for(const Mesh_soup& soup : {tetrahedron(7), octahedron(8), genus_3_plate(2), bumpy_sphere(7, 0.3, 5)}) {
    Setting setting(soup);
    Tree tree(setting.triangulation);
    tree.grow(11_v);
    replaced += FG::make_shortest(tree).longer_before;
    for(double scale : {0x1p-10, 0x1p10}) {
      Setting other(mapped(soup, [scale](const Coordinates& p) {
        return Coordinates{scale * p[0], scale * p[1], scale * p[2]};
      }));
      Tree scaled(other.triangulation);
      scaled.grow(11_v);
      FG::make_shortest(scaled);
      for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices())) {
        BOOST_TEST((scaled.incoming(v) == tree.incoming(v)));
        BOOST_TEST(scaled.distance(v) == scale * tree.distance(v));
      }
    }
  }
  BOOST_TEST(replaced > 20u);
}

// The last segments of the replaced paths cross few edges, and no other edges are flipped.
BOOST_AUTO_TEST_CASE(replacing_paths_takes_few_flips)
{
  Setting setting(bumpy_sphere(7, 0.3, 5));
  Tree tree(setting.triangulation);
  tree.grow(11_v);
  const FG::Distances_report report = FG::make_shortest(tree);
  BOOST_TEST(report.longer_before > 20u);
  BOOST_TEST(report.longer == 0u);
  BOOST_TEST(report.flips <= 3 * report.longer_before / 2);
}

// Whatever part of its length a path may be longer than a shortest one: where it is too long, so are all paths that go
// on from it, even if they are not by their own length.
BOOST_AUTO_TEST_CASE(paths_that_go_on_from_one_too_long_are_replaced_with_it)
{
  Setting setting(bumpy_sphere(7, 0.3, 5));
  const auto& t = setting.triangulation;
  Tree tree(setting.triangulation);
  tree.grow(0_v);
  FG::internal::Unfolded_faces<Setting::Triangulation> faces(t);
  FG::internal::Window_search<Setting::Triangulation> search(t, faces, 0_v);
  search.run(std::numeric_limits<double>::infinity());
  int followers = 0;
  for(Vertex_index v = 1_v; v.idx() < t.number_of_vertices(); ++v) {
    const double excess = tree.distance(v) / search.distance(v) - 1;
    if(excess < 1e-6)
      continue;
    FG::internal::Shortest_tree_repair<Tree> repair(tree, search, 0.999 * excess);
    FG::internal::Indexed_by<Vertex_index, std::vector<char>> is_longer(
        static_cast<std::size_t>(t.number_of_vertices()), 0);
    for(Vertex_index w : repair.longer())
      is_longer[w] = 1;
    BOOST_TEST(is_longer[v] != 0);
    for(Vertex_index w = 1_v; w.idx() < t.number_of_vertices(); ++w) {
      const bool has_longer_parent = is_longer[t.tail(tree.incoming(w))] != 0;
      BOOST_TEST((!has_longer_parent || is_longer[w] != 0));
      followers += has_longer_parent && tree.distance(w) / search.distance(w) - 1 < 0.999 * excess ? 1 : 0;
    }
  }
  BOOST_TEST(followers > 0);
}

// A distance field says of each shortest path how it arrives, as the search does that keeps all windows: from which
// vertex, how far that is, and at which angle.
BOOST_AUTO_TEST_CASE(a_field_and_a_search_say_the_same_of_last_legs)
{
  using Triangulation = Setting::Triangulation;
  int straight = 0, along = 0;
  for(const Mesh_soup& soup : {bumpy_sphere(8, 0.3, 1), saddle_disk(12, 5, 9), grid_with_hole(9, 9, 3, 6, 3, 6)}) {
    Setting setting(soup);
    const Triangulation& t = setting.triangulation;
    FG::internal::Unfolded_faces<Triangulation> faces(t);
    FG::internal::Window_search<Triangulation> search(t, faces, 17_v);
    search.run(std::numeric_limits<double>::infinity());
    FG::internal::Window_propagation<Triangulation> field(t, false);
    field.add_vertex(17_v, 0, 0);
    field.run(std::numeric_limits<double>::infinity(), 1000000);
    for(Vertex_index v : descriptors<Vertex_index>(t.number_of_vertices())) {
      if(v == 17_v)
        continue;
      const FG::internal::Last_leg leg = FG::internal::last_leg(t, field, v), other = last_leg(t, search, v);
      BOOST_TEST(std::abs(field.distance(leg.from) + leg.length - field.distance(v)) <= tolerance * leg.length);
      if(leg.from != other.from || search.leg(v).sequence.crossed.empty() != (leg.angle == 0))
        continue; // two paths of one length
      const FG::internal::Vertex_directions<Triangulation> directions(t, v);
      const double difference = directions.of_input(leg.halfedge) + leg.angle - directions.of_input(other.halfedge);
      const double turn = std::remainder(difference - other.angle, directions.total());
      BOOST_TEST(std::abs(turn) <= 1e-9, "vertex " << v.idx());
      BOOST_TEST(std::abs(leg.length - other.length) <= tolerance * leg.length);
      ++(leg.angle == 0 ? along : straight);
    }
  }
  BOOST_TEST(straight > 200);
  BOOST_TEST(along > 20);
}

// A path as short as the bound says, up to rounding.
BOOST_AUTO_TEST_CASE(a_gap_is_not_negative)
{
  FG::Shortest_path_report report;
  report.length = 1;
  report.lower_bound = 1 + 1e-15;
  BOOST_TEST(report.gap() == 0);
  report.lower_bound = 0.75;
  BOOST_TEST(report.gap() == 0.25);
}
