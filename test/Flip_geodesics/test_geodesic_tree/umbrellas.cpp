// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Trees on surfaces with non-manifold vertices: distances, shortest paths, trees and polar coordinates agree.

#include "trees.h"

#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/graph_traits.h>
#include <CGAL/Flip_geodesics/intrinsic_edge_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

using namespace tree_test;

namespace {

using Certified_tree_setting = Tree_setting<Certified_setting>;

constexpr double infinity = std::numeric_limits<double>::infinity();

Mesh_soup bow_tie() { return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}}; }

// A path of squares that meet in their corners only, from the corner (0, 0) to (n, n).
Mesh_soup squares_that_meet(int n)
{
  Mesh_soup soup;
  soup.points.push_back({0, 0, 0});
  for(int i = 0; i < n; ++i) {
    const double x = i;
    soup.points.insert(soup.points.end(), {{x + 1, x, 0}, {x, x + 1, 0}, {x + 1, x + 1, 0}});
    soup.triangles.insert(soup.triangles.end(), {{3 * i, 3 * i + 1, 3 * i + 2}, {3 * i + 1, 3 * i + 3, 3 * i + 2}});
  }
  return soup;
}

// A rough grid of which faces are missing, so that umbrellas meet in many vertices.
Mesh_soup sheet_with_holes(unsigned seed)
{
  std::mt19937 random(seed);
  const int n = 3 + static_cast<int>(random() % 4);
  Mesh_soup soup = jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, seed);
  for(Coordinates& p : soup.points)
    p[2] = seed % 3 == 0 ? 0 : static_cast<double>(random() % 1000) / 1000;
  const auto is_missing = [&](const Corners&) { return random() % 3 == 0; };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_missing), soup.triangles.end());
  return soup;
}

bool is_non_manifold(const Surface& mesh, Surface::Vertex_index v)
{
  if(mesh.is_isolated(v))
    return false;
  const auto around = mesh.halfedges_around_target(mesh.halfedge(v));
  return std::count_if(around.begin(), around.end(), [&](auto h) { return mesh.is_border(h); }) > 1;
}

bool is_same(double a, double b) { return a == b || is_close(a, b, 1 + a); }

// All distances from a vertex of a surface agree.
void check_distances(const Mesh_soup& soup, Surface::Vertex_index source)
{
  Certified_tree_setting setting(soup);
  const Surface& mesh = setting.mesh;
  std::vector<double> distances(num_vertices(mesh));
  const auto report = FG::geodesic_distances(
      mesh, source, boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh)));
  BOOST_TEST(report.is_confirmed());
  setting.tree.grow(Vertex_index(static_cast<Index>(source)));
  const FG::Distances_report shortest = FG::make_shortest(setting.tree);
  BOOST_TEST(shortest.is_confirmed());
  BOOST_TEST(shortest.longer == 0u);
  BOOST_TEST(setting.tree.is_valid());
  for(const auto v : mesh.vertices()) {
    BOOST_TEST(is_same(distances[v], setting.tree.distance(Vertex_index(static_cast<Index>(v)))));
    if(v == source || distances[v] == infinity)
      continue;
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    BOOST_TEST(is_same(distances[v], FG::shortest_path(mesh, source, v, std::back_inserter(points)).report.length));
  }
  if(is_non_manifold(mesh, source)) // directions there have no angles between them
    return;
  std::vector<FG::Polar_coordinates> polar(num_vertices(mesh)), logarithms;
  FG::logarithmic_map(mesh, source, boost::make_iterator_property_map(polar.begin(), get(boost::vertex_index, mesh)));
  FG::logarithmic_map(mesh, source, mesh.vertices(), std::back_inserter(logarithms));
  for(const auto v : mesh.vertices()) {
    BOOST_TEST(is_same(distances[v], polar[v].radius));
    BOOST_TEST(is_same(distances[v], logarithms[v].radius));
  }
}

} // namespace

BOOST_AUTO_TEST_SUITE(umbrellas)

BOOST_AUTO_TEST_CASE(distances_through_non_manifold_vertices_agree)
{
  for(int v = 0; v < 5; ++v)
    check_distances(bow_tie(), Surface::Vertex_index(static_cast<unsigned>(v)));
  check_distances(squares_that_meet(4), Surface::Vertex_index(0));
  int sheets = 0;
  for(unsigned seed = 0; seed < 24; ++seed) {
    const Mesh_soup soup = sheet_with_holes(seed);
    const auto mesh = to_mesh<Surface>(soup);
    const auto source = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                                      [&](auto v) { return !mesh.is_isolated(v) && !is_non_manifold(mesh, v); });
    check_distances(soup, source);
    sheets +=
        std::any_of(mesh.vertices().begin(), mesh.vertices().end(), [&](auto v) { return is_non_manifold(mesh, v); })
            ? 1
            : 0;
  }
  BOOST_TEST(sheets > 12);
}

// In doubles, paths are measured in the umbrella in which they go on, whichever is the first one of the vertex.
BOOST_AUTO_TEST_CASE(paths_in_doubles_are_measured_in_each_umbrella)
{
  int passed = 0;
  for(unsigned seed = 0; seed < 12; ++seed) {
    Double_tree_setting setting(sheet_with_holes(seed));
    const Surface& mesh = setting.mesh;
    const auto source = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                                      [&](auto v) { return !mesh.is_isolated(v) && !is_non_manifold(mesh, v); });
    std::vector<double> distances(num_vertices(mesh));
    FG::geodesic_distances(mesh, source,
                           boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh)));
    setting.tree.grow(Vertex_index(static_cast<Index>(source)));
    BOOST_TEST(FG::make_shortest(setting.tree).is_confirmed());
    for(const auto v : mesh.vertices()) {
      const Vertex_index w(static_cast<Index>(v));
      BOOST_TEST(is_same(distances[v], setting.tree.distance(w)));
      const Halfedge_index last = setting.tree.incoming(w);
      if(last != FG::null_index)
        passed +=
            is_non_manifold(mesh, Surface::Vertex_index(static_cast<unsigned>(setting.triangulation.tail(last).idx())))
                ? 1
                : 0;
    }
  }
  BOOST_TEST(passed > 10);
}

// Each halfedge is one of the vertex at which it starts, also beside points that are inserted on the border.
BOOST_AUTO_TEST_CASE(outgoing_halfedges_are_those_of_all_umbrellas)
{
  for(unsigned seed = 0; seed < 12; ++seed) {
    Curve_setting setting(sheet_with_holes(seed));
    auto& t = setting.triangulation;
    for(FG::Input_halfedge_index h :
        FG::internal::descriptors<FG::Input_halfedge_index>(t.input().number_of_halfedges()))
      if(!t.input().is_border(h) && t.input().is_border(FG::internal::twin_index(h)) && h.idx() % 3 == 0)
        t.insert({h, {{1, 2, 0}}});
    std::vector<int> degree(static_cast<std::size_t>(t.number_of_vertices()), 0);
    for(Halfedge_index h : FG::internal::descriptors<Halfedge_index>(t.number_of_halfedges()))
      ++degree[static_cast<std::size_t>(t.tail(h).idx())];
    for(Vertex_index v : FG::internal::descriptors<Vertex_index>(t.number_of_vertices())) {
      std::vector<Halfedge_index> around = FG::internal::outgoing_halfedges(t, v);
      BOOST_TEST(static_cast<int>(around.size()) == degree[static_cast<std::size_t>(v.idx())]);
      std::sort(around.begin(), around.end());
      BOOST_TEST((std::adjacent_find(around.begin(), around.end()) == around.end()));
      for(Halfedge_index h : around)
        BOOST_TEST(t.tail(h) == v);
      BOOST_TEST(out_degree(v, t) == around.size()); // as a graph
    }
    for(Halfedge_index h : FG::internal::descriptors<Halfedge_index>(t.number_of_halfedges()))
      BOOST_TEST((prev(next(h, t), t) == h && target(h, t) == source(next(h, t), t)));
  }
}

// Edge paths, too: from one triangle of the bow tie to the other.
BOOST_AUTO_TEST_CASE(edge_paths_pass_non_manifold_vertices)
{
  Curve_setting setting(bow_tie());
  const auto path = FG::shortest_intrinsic_edge_path(setting.triangulation, 1_v, 3_v);
  BOOST_TEST(path.size() == 2u);
  BOOST_TEST(FG::halfedges_through(setting.triangulation, std::vector<Vertex_index>{2_v, 0_v, 4_v}).size() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
