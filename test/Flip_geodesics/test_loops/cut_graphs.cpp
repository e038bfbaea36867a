// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Networks along which surfaces are cut open: what is left are disks, before and after the networks are pulled tight.

#include "test_loops/loop_setting.h"

#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace {

// Cut along the network, each component is a disk: of Euler characteristic 1 and with one border.
void check_disks(const Network& network, const Surface& mesh, std::size_t components)
{
  const auto cut = FG::cut_along_curves(network, mesh);
  const Setting pieces(cut.mesh());
  BOOST_TEST(pieces.basis.components().size() == components);
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
  const FG::Shortening_report report = FG::shorten(network);
  for(const FG::Curve_report& curve : report.curves)
    BOOST_TEST((curve.status == FG::Shortening_status::LOCALLY_SHORTEST));
  check_disks(network, s.mesh, components);
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
  // the shortest way from one border to another, not by way of the first vertex
  Mesh_soup holes = sphere(4);
  holes.triangles.erase(holes.triangles.begin() + 100);
  holes.triangles.erase(holes.triangles.begin() + 40);
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
  Setting s(cylinder(6, 4, 1, 3)); // straight from one border to the other
  Network network(s.triangulation);
  FG::add_cut_graph(network);
  BOOST_TEST(std::abs(network.length(0_c) - 3) < 1e-12);
}
