// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Models that have nothing but what the pages of the concepts say go through all that reads: certificates, measuring,
// extraction, subdivision, cutting, saving. The answers are those with the ordinary models, bit for bit.

#define BOOST_TEST_MODULE archetypes

#include "Curve_network_archetype.h"
#include "Curve_setting.h"
#include "Edge_path_graph_archetype.h"
#include "Metric_archetype.h"
#include "Plain_triangulation.h"
#include "Policy_archetypes.h"
#include "Traits_archetype.h"
#include "Triangulation_of_mesh_archetype.h"
#include "number_type_checks.h"
#include "random_curves.h"
#include "test_archetypes/Constructions.h"
#include "test_archetypes/Record.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/refine.h>

#include <CGAL/Gmpq.h>

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

using namespace archetypes_test;

namespace {

using Traits = FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;
using Model = FG::Intrinsic_triangulation<Surface, Traits, Metric_with_squares<FG::Default_metric<Surface>>>;
using Archetype = Triangulation_of_mesh_archetype<
    FG::Intrinsic_triangulation<Surface, Traits, Metric_archetype<typename Model::Metric>>>;

template <class Network>
using Itself = const Network&;

// What all that reads has to say of random curves, some of them not pulled tight, and some of points put in.
template <class Triangulation, template <class> class Window>
std::string reading(const Surface& mesh)
{
  Record record;
  Triangulation triangulation(mesh);
  FG::Edge_path_network<Triangulation> network(triangulation);
  const Window<FG::Edge_path_network<Triangulation>> window(network);
  Random_numbers random(1);
  for(int i = 0; i < 4; ++i) {
    const Halfedge_sequence walk = random_walk(triangulation, 12, i % 2 == 1, random);
    if(!walk.empty())
      network.add_curve(walk, CGAL::parameters::is_closed(i % 2 == 1));
    if(!network.is_valid())
      network.clear();
    record.network(window, mesh);
    if(i % 2 == 0)
      record.report(FG::shorten(network));
    record.network(window, mesh);
  }
  record.classes(FG::Loop_basis<Triangulation>(triangulation), window);
  record.triangulation(triangulation, mesh);
  network.insert({FG::Input_halfedge_index(0), {{1, 1, 1}}});
  record.network(window, mesh);
  record.report(FG::refine(network, {20, 0.8, 200}));
  record.network(window, mesh);
  record.triangulation(triangulation, mesh);
  return record.text();
}

// What asks for no mesh.
template <class Triangulation>
std::string without_mesh(const Surface& mesh)
{
  Record record;
  Triangulation triangulation(mesh);
  FG::Edge_path_network<Triangulation> network(triangulation);
  const Curve_network_archetype<FG::Edge_path_network<Triangulation>> window(network);
  Random_numbers random(2);
  for(int i = 0; i < 6; ++i) {
    const Halfedge_sequence walk = random_walk(triangulation, 12, i % 2 == 1, random);
    if(!walk.empty())
      network.add_curve(walk, CGAL::parameters::is_closed(i % 2 == 1));
    if(!network.is_valid())
      network.clear();
    record.report(FG::shorten(network));
    record.ways(network);
    record.edges(FG::edges_near_curves(window, 1));
  }
  record.faces(triangulation);
  network.clear();
  FG::flip_to_delaunay(triangulation);
  BOOST_TEST(FG::is_delaunay(triangulation));
  FG::Geodesic_tree<Triangulation> tree(triangulation);
  tree.grow(FG::Vertex_index(3));
  BOOST_TEST(tree.is_valid());
  record.tree(tree);
  record.faces(triangulation);
  return record.text();
}

std::vector<Mesh_soup> soups()
{
  return {bumpy_sphere(3, 0.2, 1), jittered_grid(6, 5, Diagonal_rule::RANDOM, 0.2, 2), genus_3_plate(1)};
}

} // namespace

BOOST_AUTO_TEST_CASE(what_is_read_is_the_same)
{
  for(const Mesh_soup& soup : soups()) {
    const Surface mesh = to_mesh<Surface>(soup);
    const std::string expected = reading<Model, Itself>(mesh);
    BOOST_TEST(expected.size() > 10000u);
    BOOST_TEST((reading<Archetype, Curve_network_archetype>(mesh) == expected));
    BOOST_TEST((reading<Model, Edge_path_graph_archetype>(mesh) == expected));
  }
}

BOOST_AUTO_TEST_CASE(what_is_made_is_the_same)
{
  for(const Mesh_soup& soup : soups()) {
    const Surface mesh = to_mesh<Surface>(soup);
    const Constructions<Model> expected(mesh);
    BOOST_TEST(expected.text().size() > 10000u);
    BOOST_TEST(expected.pulled() >= 9);
    BOOST_TEST((Constructions<Archetype>(mesh).text() == expected.text()));
  }
}

BOOST_AUTO_TEST_CASE(no_mesh_is_needed)
{
  using Traits = Exact_traits<CGAL::Gmpq>;
  for(const Mesh_soup& soup : {tieless_plane(6, 1), genus_3_plate(1), cube(3)}) {
    const Surface mesh = to_mesh<Surface>(soup);
    const std::string expected = without_mesh<FG::Intrinsic_triangulation<Surface, Traits>>(mesh);
    BOOST_TEST(expected.size() > 5000u);
    BOOST_TEST((without_mesh<Plain_triangulation<Traits>>(mesh) == expected));
  }
}

// Traits that compute otherwise, with drift: what comes out is as valid, and measured.
BOOST_AUTO_TEST_CASE(least_traits_are_enough)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Traits_archetype>;
  for(const Mesh_soup& soup : soups()) {
    const Surface mesh = to_mesh<Surface>(soup);
    const Constructions<Triangulation> constructions(mesh);
    BOOST_TEST(constructions.pulled() >= 9);
    BOOST_TEST((reading<Triangulation, Itself>(mesh)).size() > 10000u);
  }
}
