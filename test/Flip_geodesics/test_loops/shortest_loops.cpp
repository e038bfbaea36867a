// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The shortest loops of edges, compared with those of all edges from all vertices.

#include "test_loops/loop_setting.h"

#include <CGAL/Flip_geodesics/geodesic_loops.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace {

// Of all edges, by the loops of `Loop_basis` at each vertex and by the words of all loops of edges.
double shortest_by_force(const Surface& mesh, FG::Loop_kind kind)
{
  const Triangulation triangulation(mesh);
  const auto& input = triangulation.input();
  const Basis basis(triangulation);
  double best = std::numeric_limits<double>::infinity();
  const auto weight = [&](FG::Input_halfedge_index h) { return triangulation.metric().weight(input, h); };
  for(FG::Index v = 0; v < input.number_of_vertices(); ++v) {
    const FG::internal::Edge_forest forest(input, std::vector<FG::Vertex_index>{FG::Vertex_index(v)}, weight);
    for(FG::Index e = 0; e < triangulation.number_of_edges(); ++e) {
      const FG::Input_halfedge_index h(2 * e), t = input.twin(h);
      const double length = forest.distance(input.tail(h)) + weight(h) + forest.distance(input.tail(t));
      if(!(length < best))
        continue;
      Input_chain loop = Setting::input_chain(forest.path(input, input.tail(h)));
      loop.push_back(h);
      const Input_chain back = Setting::input_chain(forest.path(input, input.tail(t)));
      for(std::size_t i = back.size(); i-- > 0;)
        loop.push_back(input.twin(back[i]));
      const Class c = basis.homology_class(loop);
      if(kind == FG::Loop_kind::NOT_CONTRACTIBLE ? !basis.is_contractible(loop) : c != Class(c.size(), 0))
        best = length;
    }
  }
  return best;
}

} // namespace

BOOST_AUTO_TEST_CASE(shortest_loops)
{
  const auto jittered = [](const Mesh_soup& soup, unsigned seed) {
    Random_numbers random(seed);
    return mapped(soup, [&](const Coordinates& p) {
      return Coordinates{p[0] + random.uniform(-0.2, 0.2), p[1] + random.uniform(-0.2, 0.2),
                         p[2] + random.uniform(-0.2, 0.2)};
    });
  };
  for(const Mesh_soup& soup : {jittered(plate(2), 1), jittered(plate(3), 2), jittered(punctured(plate(2), 2), 3),
                               jittered(torus(6, 5, 3, 1), 4), jittered(punctured(torus(6, 5, 3, 1), 3), 5),
                               jittered(grid_with_hole(5, 5, 2, 3, 2, 3), 6), jittered(cylinder(5, 4, 1, 3), 7)})
  {
    const Setting s(soup);
    for(FG::Loop_kind kind : {FG::Loop_kind::NOT_CONTRACTIBLE, FG::Loop_kind::NOT_BOUNDING}) {
      const Chain loop = FG::shortest_loop(s.triangulation, kind);
      BOOST_TEST_REQUIRE(!loop.empty());
      const double length = shortest_by_force(s.mesh, kind);
      BOOST_TEST(std::abs(s.length(loop) - length) < 1e-12 * length);
      BOOST_TEST(!s.basis.is_contractible(Setting::input_chain(loop)));
      if(kind == FG::Loop_kind::NOT_BOUNDING)
        BOOST_TEST(s.basis.homology_class(Setting::input_chain(loop)) != s.zero());
      // through a vertex: the first loop of a basis there bounds nothing
      const Chain through = FG::shortest_loop(s.triangulation, 7_v, kind);
      BOOST_TEST((s.triangulation.tail(through.front()) == 7_v && s.triangulation.head(through.back()) == 7_v));
      BOOST_TEST(s.length(through) >= s.length(loop) * (1 - 1e-12));
      const Basis at_vertex(s.triangulation, std::vector<FG::Vertex_index>{7_v});
      if(kind == FG::Loop_kind::NOT_BOUNDING)
        BOOST_TEST(std::abs(s.length(through) - at_vertex.length(0)) < 1e-12 * length);
      else
        BOOST_TEST(s.length(through) <= at_vertex.length(0) * (1 + 1e-12));
    }
  }
}

// The loops of the plate of length 4 n are the shortest. A neck is shorter than them, and divides the surface.
BOOST_AUTO_TEST_CASE(shortest_loops_of_known_length)
{
  const Setting s(genus_3_plate(2));
  BOOST_TEST(std::abs(s.length(FG::shortest_loop(s.triangulation)) - 8) < 1e-12);
  const Setting necked(voxel_surface(9, 4, 2, [](int i, int j, int k) { // two rings, and a bar between them
    const int x = i < 4 ? i : i - 5;
    return i == 4 ? j == 0 && k == 0 : x == 0 || x == 3 || j == 0 || j == 3;
  }));
  BOOST_TEST_REQUIRE(necked.basis.components().size() == 1u);
  BOOST_TEST(necked.basis.components()[0].genus == 2);
  const Chain neck = FG::shortest_loop(necked.triangulation);
  BOOST_TEST(std::abs(necked.length(neck) - 4) < 1e-12);
  BOOST_TEST(necked.basis.homology_class(Setting::input_chain(neck)) == necked.zero());
  BOOST_TEST(necked.length(FG::shortest_loop(necked.triangulation, FG::Loop_kind::NOT_BOUNDING)) == 6);
}

BOOST_AUTO_TEST_CASE(no_shortest_loop_where_there_is_none)
{
  for(const Mesh_soup& soup : {sphere(2), single_triangle(), flat_grid(3, 3, Diagonal_rule::RISING), Mesh_soup{},
                               with_isolated_vertices(tetrahedron(), 1, 0)})
  {
    const Setting s(soup);
    BOOST_TEST(FG::shortest_loop(s.triangulation).empty());
    if(!soup.points.empty())
      BOOST_TEST(FG::shortest_loop(s.triangulation, 0_v).empty());
  }
  const Setting s(single_triangle());
  BOOST_CHECK_THROW(FG::shortest_loop(s.triangulation, 3_v), FG::Vertex_out_of_range_error);
}

// Each component has its own group.
BOOST_AUTO_TEST_CASE(shortest_loops_of_several_components)
{
  const std::vector<Mesh_soup> parts = {cylinder(5, 4, 1, 3), plate(2), torus(6, 5, 3, 1), sphere(2)};
  for(const Mesh_soup& first : parts)
    for(const Mesh_soup& second : parts) {
      const Setting both(disjoint_union(first, second)), one(first), two(second);
      const auto n = static_cast<FG::Index>(first.points.size());
      for(FG::Index v : {0, 3, 7})
        for(FG::Loop_kind kind : {FG::Loop_kind::NOT_CONTRACTIBLE, FG::Loop_kind::NOT_BOUNDING}) {
          const auto length = [kind](const Setting& s, FG::Index at) {
            return s.length(FG::shortest_loop(s.triangulation, FG::Vertex_index(at), kind));
          };
          BOOST_TEST(std::abs(length(both, v) - length(one, v)) < 1e-12);
          BOOST_TEST(std::abs(length(both, n + v) - length(two, v)) < 1e-12);
        }
    }
}

BOOST_AUTO_TEST_CASE(shortest_loops_through_what_is_no_vertex)
{
  const Setting s(torus(5, 4, 3, 1));
  BOOST_CHECK_EXCEPTION(FG::shortest_loop(s.triangulation, FG::null_index), FG::Vertex_out_of_range_error,
                        [](const FG::Vertex_out_of_range_error& error) {
                          return error.elements().empty() && std::string(error.what()).find("a given vertex") == 0;
                        });
  BOOST_CHECK_EXCEPTION(
      FG::shortest_loop(s.triangulation, 20_v), FG::Vertex_out_of_range_error,
      [](const FG::Vertex_out_of_range_error& error) { return error.elements() == std::vector<std::size_t>{20}; });
  const Mesh_soup bow_tie = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  const Surface touching = to_mesh<Surface>(bow_tie);
  BOOST_CHECK_THROW(FG::shortest_loop(Triangulation(touching), 1_v), FG::Invalid_mesh_error);
}
