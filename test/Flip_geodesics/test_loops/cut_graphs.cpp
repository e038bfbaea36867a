// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Networks along which surfaces are cut open: what is left are disks, before and after the networks are pulled tight.

#include "test_loops/loop_setting.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/geodesic_loops.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace {

// Cut along the network, each component is a disk: of Euler characteristic 1 and with one border.
void check_disks(const Network& network, const Surface& mesh, std::size_t components)
{
  const auto cut = FG::cut_along_curves(network, mesh);
  const Setting pieces(cut.mesh());
  BOOST_TEST_REQUIRE(pieces.basis.components().size() == components);
  for(const auto& piece : pieces.basis.components()) {
    BOOST_TEST(piece.genus == 0);
    BOOST_TEST(piece.number_of_borders == 1);
    BOOST_TEST(piece.number_of_loops == 0);
  }
  const std::ptrdiff_t euler = std::ptrdiff_t(cut.mesh().number_of_vertices()) -
                               std::ptrdiff_t(cut.mesh().number_of_edges()) +
                               std::ptrdiff_t(cut.mesh().number_of_faces());
  BOOST_TEST(euler == std::ptrdiff_t(components));
}

void check_cut(const Mesh_soup& soup, std::size_t components, const std::vector<FG::Vertex_index>& base_points = {})
{
  Setting s(soup);
  Network network(s.triangulation);
  const FG::Index curves = FG::add_cut_graph(network, base_points);
  BOOST_TEST(curves == network.number_of_curves());
  BOOST_TEST(network.is_valid());
  check_disks(network, s.mesh, components);
  const FG::Shortening_report report = FG::shorten_cut_graph(network);
  BOOST_TEST(report.curves.size() == static_cast<std::size_t>(network.number_of_curves()));
  for(const FG::Curve_report& curve : report.curves)
    BOOST_TEST((curve.status == FG::Shortening_status::LOCALLY_SHORTEST));
  check_disks(network, s.mesh, components);
}

// With its points moved at random, far past one another: curves meet on it that were apart.
Mesh_soup crumpled(const Mesh_soup& soup, unsigned seed)
{
  Random_numbers random(seed);
  return mapped(soup, [&](const Coordinates& p) {
    const double x = random.uniform(-3, 3), y = random.uniform(-3, 3), z = random.uniform(-3, 3);
    return Coordinates{p[0] + x, p[1] + y, p[2] + z};
  });
}

// The bars of a 2 x 2 x 2 lattice: genus 28.
Mesh_soup scaffold()
{
  return voxel_surface(5, 5, 5, [](int i, int j, int k) { return i % 2 + j % 2 + k % 2 <= 1; });
}

// The number of curves that end in a vertex inside the surface where no other does.
int number_of_loose_ends(const Network& network)
{
  std::map<FG::Vertex_index, int> degree;
  const Triangulation& triangulation = network.triangulation();
  for(FG::Halfedge_index h : FG::internal::descriptors<FG::Halfedge_index>(triangulation.number_of_halfedges())) {
    degree[triangulation.tail(h)] += network.is_occupied(h) ? 1 : 0;
    degree[triangulation.tail(h)] += triangulation.is_border(h) ? 2 : 0;
  }
  return static_cast<int>(std::count_if(degree.begin(), degree.end(), [](const auto& d) { return d.second == 1; }));
}

} // namespace

BOOST_AUTO_TEST_CASE(cut_open_to_disks)
{
  check_cut(torus(12, 9, 3, 1), 1);
  check_cut(torus(12, 9, 3, 1), 1, {50_v});
  check_cut(plate(4, 2), 1);
  check_cut(punctured(plate(3, 2), 1), 1);
  check_cut(punctured(plate(3, 2), 6), 1);
  check_cut(punctured(plate(3, 2), 6), 1, {11_v});
  check_cut(grid_with_hole(5, 5, 2, 3, 2, 3), 1);
  check_cut(cylinder(6, 4, 1, 3), 1);
  check_cut(sphere(3), 1);
  check_cut(tetrahedron(), 1);
  check_cut(disjoint_union(disjoint_union(sphere(2), plate(2)), punctured(translated(sphere(2), 5, 9, 0), 3)), 3);
}

BOOST_AUTO_TEST_CASE(cuts_of_disks_annuli_and_spheres)
{
  for(const auto& [soup, curves] :
      std::vector<std::pair<Mesh_soup, FG::Index>>{{single_triangle(), 0},
                                                   {flat_grid(4, 3, Diagonal_rule::RISING), 0},
                                                   {cylinder(6, 4, 1, 3), 1},
                                                   {sphere(3), 1}})
  {
    Setting s(soup);
    Network network(s.triangulation);
    BOOST_TEST(FG::add_cut_graph(network) == curves);
  }
  Setting s(cylinder(6, 4, 1, 3)); // straight from one border to the other
  Network network(s.triangulation);
  FG::add_cut_graph(network);
  BOOST_TEST(std::abs(network.length(0_c) - 3) < 1e-12);
}

// Curves of a cut graph that come to run along the same edges, or to touch, leave one disk all the same. No edge is cut
// twice then, no cut leads to nowhere, and the network is no longer than what was pulled tight with all curves.
BOOST_AUTO_TEST_CASE(cut_graphs_stay_cut_graphs_when_they_are_pulled_tight)
{
  int in_pieces = 0;
  for(unsigned seed = 0; seed < 120; ++seed) {
    const Mesh_soup surface = seed % 2 == 0 ? scaffold() : plate(static_cast<int>(seed / 2 % 5) + 1);
    const Setting s(crumpled(punctured(surface, static_cast<int>(seed % 3)), seed));
    const auto length = [](const Network& network) {
      double sum = 0;
      for(FG::Halfedge_index h :
          FG::internal::descriptors<FG::Halfedge_index>(2 * network.triangulation().number_of_edges()))
        sum += network.is_occupied(h) ? network.triangulation().length(h) / 2 : 0;
      return sum;
    };
    double plain = 0;
    bool is_in_pieces = false;
    {
      Triangulation triangulation(s.mesh);
      Network network(triangulation);
      FG::add_cut_graph(network);
      FG::shorten(network);
      plain = length(network);
      is_in_pieces = Setting(FG::cut_along_curves(network, s.mesh).mesh()).basis.components().size() > 1;
    }
    Triangulation triangulation(s.mesh);
    Network network(triangulation);
    FG::add_cut_graph(network);
    const FG::Shortening_report report = FG::shorten_cut_graph(network);
    in_pieces += is_in_pieces ? 1 : 0;
    BOOST_TEST(network.is_valid());
    BOOST_TEST(report.is_complete());
    BOOST_TEST(number_of_loose_ends(network) == 0);
    BOOST_TEST(length(network) <= plain * (1 + 1e-12));
    BOOST_TEST((length(network) < plain * (1 - 1e-6)) == is_in_pieces);
    for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(triangulation.number_of_edges()))
      BOOST_TEST((!is_in_pieces || network.bundle(e).size() < 2));
    check_disks(network, s.mesh, 1);
  }
  BOOST_TEST_MESSAGE(in_pieces << " of 120 in pieces");
  BOOST_TEST(in_pieces > 3);
}

// Seams that a caller laid: three from one vertex to another leave three disks, and one of them is enough for a sphere.
BOOST_AUTO_TEST_CASE(needless_seams_of_a_sphere)
{
  Setting s(sphere(4));
  Network network(s.triangulation);
  std::vector<FG::Vertex_index> poles;
  for(FG::Vertex_index v : FG::internal::descriptors<FG::Vertex_index>(s.triangulation.number_of_vertices()))
    if(std::abs(std::abs(s.mesh.point(s.triangulation.input().vertex(v)).z()) - 1) < 1e-12)
      poles.push_back(v);
  BOOST_TEST_REQUIRE(poles.size() == 2u);
  FG::Shortest_edge_path<Triangulation> search(s.triangulation);
  std::vector<FG::Vertex_index> equator;
  for(FG::Vertex_index v : FG::internal::descriptors<FG::Vertex_index>(s.triangulation.number_of_vertices()))
    if(std::abs(s.mesh.point(s.triangulation.input().vertex(v)).z()) < 1e-12)
      equator.push_back(v);
  BOOST_TEST_REQUIRE(equator.size() == 16u);
  for(std::size_t i : {0, 3, 9})
    network.add_curve(
        FG::shortest_halfedges_through(search, std::vector<FG::Vertex_index>{poles[0], equator[i], poles[1]}));
  FG::order_overlapping_curves(network);
  const FG::Shortening_report report = FG::shorten_cut_graph(network);
  BOOST_TEST(network.number_of_curves() == 1);
  BOOST_TEST(report.curves.size() == 1u);
  BOOST_TEST(report.flip_outs > 0u);
  BOOST_TEST(s.triangulation.log_position() > 0u);
  BOOST_TEST(report.flips >= s.triangulation.log_position()); // of all runs
  check_disks(network, s.mesh, 1);
}

// The shortest way from one border to another, not by way of the first vertex.
BOOST_AUTO_TEST_CASE(an_annulus_is_cut_along_the_shortest_way_between_its_borders)
{
  const auto is_near = [](const Coordinates& p, const Coordinates& q) {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 0.25;
  };
  // Holes a quarter of a sphere away from the first vertex, and an eighth from each other; and others.
  for(const auto& [first, second] : std::vector<std::pair<Coordinates, Coordinates>>{
          {{0, 1, 0}, {0, 0.7, 0.7}}, {{0, 0, 1}, {0, 0.7, 0.7}}, {{0, 1, 0}, {0, 0, 1}}, {{-0.7, 0.7, 0}, {0, 1, 0}}})
  {
    Mesh_soup holes = sphere(6);
    for(const Coordinates& hole : {first, second}) {
      const auto is_hole = [&, h = hole](const Corners& c) {
        Coordinates center = {0, 0, 0};
        for(int v : c)
          for(std::size_t k = 0; k < 3; ++k)
            center[k] += holes.points[static_cast<std::size_t>(v)][k] / 3;
        return is_near(center, h);
      };
      holes.triangles.erase(std::find_if(holes.triangles.begin(), holes.triangles.end(), is_hole));
    }
    Setting t(holes);
    std::vector<Chain> borders;
    FG::border_loops(t.triangulation, std::back_inserter(borders));
    BOOST_TEST_REQUIRE(borders.size() == 2u);
    double shortest = std::numeric_limits<double>::infinity();
    for(FG::Halfedge_index h : borders[0]) {
      BOOST_TEST(t.triangulation.tail(h) != 0_v);
      const FG::internal::Edge_forest forest(
          t.triangulation.input(), std::vector<FG::Vertex_index>{t.triangulation.tail(h)},
          [&](FG::Input_halfedge_index g) { return t.triangulation.metric().weight(t.triangulation.input(), g); });
      for(FG::Halfedge_index g : borders[1])
        shortest = std::min(shortest, forest.distance(t.triangulation.tail(g)));
    }
    Network across(t.triangulation);
    BOOST_TEST(FG::add_cut_graph(across) == 1);
    BOOST_TEST(std::abs(across.length(0_c) - shortest) < 1e-12);
  }
}

// Seams of a sphere like those of a tetrahedron, from the north pole and about it, and a slit to the south pole. The
// longer ones about it are needless, and two of the others as well then, but the slit stays.
BOOST_AUTO_TEST_CASE(seams_that_lead_to_nowhere_are_needless)
{
  const Mesh_soup soup = sphere(4);
  Setting s(soup);
  const auto vertex = [&](double x, double y, double z) {
    std::size_t best = 0;
    for(std::size_t v = 0; v < soup.points.size(); ++v) {
      const auto far = [&](std::size_t i) {
        return std::hypot(soup.points[i][0] - x, soup.points[i][1] - y, soup.points[i][2] - z);
      };
      best = far(v) < far(best) ? v : best;
    }
    return FG::Vertex_index(static_cast<FG::Index>(best));
  };
  const FG::Vertex_index north = vertex(0, 0, 1), south = vertex(0, 0, -1), a = vertex(1, 0, 0),
                         b = vertex(-0.5, 0.87, 0), c = vertex(-0.5, -0.87, 0);
  Network network(s.triangulation);
  FG::Shortest_edge_path<Triangulation> search(s.triangulation);
  for(const auto& [v, w] : std::vector<std::pair<FG::Vertex_index, FG::Vertex_index>>{
          {north, a}, {north, b}, {north, c}, {a, b}, {b, c}, {c, a}, {a, south}})
    network.add_curve(search(v, w));
  FG::order_overlapping_curves(network);
  FG::shorten_cut_graph(network);
  BOOST_TEST(network.number_of_curves() == 1);
  check_disks(network, s.mesh, 1);
  const FG::Vertex_index first = s.triangulation.tail(network.halfedge(network.first_segment(0_c))),
                         last = s.triangulation.head(network.halfedge(network.last_segment(0_c)));
  BOOST_TEST((first == south || last == south));
}
