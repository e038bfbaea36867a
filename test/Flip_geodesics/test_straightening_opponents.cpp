// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The other ways of straightening that the benchmarks compare with must be right, too.

#define BOOST_TEST_MODULE Straightening_opponents

#include "Double_triangulation.h"
#include "edge_dijkstra.h"
#include "generated_meshes.h"
#include "iterative_relaxation.h"
#include "iterative_unfolding.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;
using Path = opponents::Portal_path<Mesh>;
using Triangulation = Double_triangulation<Mesh>;
using Search = FG::Shortest_edge_path<Triangulation>;

double length(const Mesh& mesh, const Path& path)
{
  double sum = 0;
  auto previous = mesh.point(path.source());
  for(const auto& portal : path.portals) {
    const auto a = mesh.point(mesh.source(portal.crossed)), b = mesh.point(mesh.target(portal.crossed));
    const auto p = a + portal.t * (b - a);
    sum += std::sqrt(CGAL::squared_distance(previous, p));
    previous = p;
  }
  return sum + std::sqrt(CGAL::squared_distance(previous, mesh.point(path.target())));
}

double length(const Triangulation& triangulation, const std::vector<FG::Halfedge_index>& path)
{
  double sum = 0;
  for(FG::Halfedge_index h : path)
    sum += triangulation.length(h);
  return sum;
}

// `tolerance` is that of the lengths of different geodesics between the same vertices.
void compare_on(const Mesh& mesh, int pairs, double tolerance)
{
  Triangulation triangulation(mesh);
  Search astar(triangulation), look_back(triangulation, CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
  Edge_dijkstra<Mesh> dijkstra(mesh);
  opponents::Surface_geometry<Mesh> geometry(mesh);
  std::mt19937 random(1);
  for(int i = 0; i < pairs; ++i) {
    const Vertex source(static_cast<unsigned>(random() % mesh.number_of_vertices()));
    const Vertex target(static_cast<unsigned>(random() % mesh.number_of_vertices()));
    const std::vector<Mesh::Halfedge_index> edges = dijkstra(source, target);
    if(edges.size() < 2)
      continue;
    std::vector<FG::Halfedge_index> start;
    for(Mesh::Halfedge_index h : edges)
      start.push_back(triangulation.index(h));
    const FG::Vertex_index s = triangulation.index(source), t = triangulation.index(target);
    BOOST_TEST(length(triangulation, astar(s, t)) == dijkstra.length(), boost::test_tools::tolerance(1e-12));

    const std::vector<FG::Halfedge_index> straighter = look_back(s, t);
    BOOST_TEST(triangulation.tail(straighter.front()) == s);
    BOOST_TEST(triangulation.head(straighter.back()) == t);
    for(std::size_t j = 1; j < straighter.size(); ++j)
      BOOST_TEST(triangulation.head(straighter[j - 1]) == triangulation.tail(straighter[j]));
    BOOST_TEST((look_back(s, t) == straighter));
    BOOST_TEST(length(triangulation, straighter) > dijkstra.length() * (1 - 1e-12));
    BOOST_TEST(length(triangulation, straighter) < 1.5 * dijkstra.length());

    double shortest = 0;
    {
      FG::Edge_path_network<Triangulation> network(triangulation);
      network.add_curve(start);
      shortest = FG::shorten(network).curves.front().length;
    }
    triangulation.rollback();

    Path unfolded(geometry, edges);
    BOOST_TEST(opponents::Iterative_unfolding<Mesh>()(unfolded) < 1000u);
    BOOST_TEST(length(mesh, unfolded) == shortest, boost::test_tools::tolerance(tolerance));

    Path relaxed(geometry, edges);
    opponents::Iterative_relaxation<Mesh>()(relaxed, 1e-4);
    const double relaxed_length = length(mesh, relaxed);
    BOOST_TEST(relaxed_length < dijkstra.length() * (1 + 1e-12));
    BOOST_TEST(relaxed_length > shortest * (1 - tolerance));
    BOOST_TEST(relaxed_length < shortest * 1.01);
  }
}

} // namespace

// Without curvature there is one geodesic in a class, which all find.
BOOST_AUTO_TEST_CASE(on_a_flat_irregular_grid)
{
  compare_on(to_mesh<Mesh>(jittered_grid(14, 14, Diagonal_rule::RISING, 0.2, 2)), 15, 1e-10);
}

BOOST_AUTO_TEST_CASE(on_a_cylinder) { compare_on(to_mesh<Mesh>(cylinder(24, 12, 1, 2)), 15, 1e-10); }

// With vertices of positive curvature, on either side of which a geodesic can pass, there are several.
BOOST_AUTO_TEST_CASE(on_a_rough_sphere) { compare_on(to_mesh<Mesh>(bumpy_sphere(8, 0.03, 4)), 15, 1e-2); }
