// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Single cuts, and cuts that meet.

#include "test_subdivide/cuts.h"

#include <CGAL/Flip_geodesics/delaunay.h>

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(a_path_cuts_a_slit)
{
  Curve_setting s(sphere(6));
  s.add_path(0_v, Vertex_index(static_cast<int>(s.mesh.number_of_vertices()) - 1));
  s.pull();
  check_inserted(s);
  const Subdivision slit = cut_open(s);
  BOOST_CHECK_EQUAL(euler_characteristic(slit.mesh()), 1);
  BOOST_CHECK_EQUAL(number_of_borders(slit.mesh()), 1);
}

// With both ends inside, its two sides would share both ends: they get a vertex each in their middles.
BOOST_AUTO_TEST_CASE(a_slit_of_one_edge_opens)
{
  for(const Mesh_soup& soup : {sphere(4), tetrahedron(1), jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 4)}) {
    const Surface plain = to_mesh<Surface>(soup);
    int slits = 0;
    for(FG::Index i = 0; i < static_cast<FG::Index>(plain.number_of_edges()); i += 3) {
      const Halfedge_index first = FG::internal::first_side(Edge_index(i));
      Curve_setting s(soup);
      s.network.add_curve(Halfedge_sequence{first});
      check_inserted(s);
      const Subdivision slit = cut_open(s);
      const auto is_at_border = [&](Vertex_index v) { return plain.is_border(s.triangulation.vertex(v)); };
      if(is_at_border(s.triangulation.tail(first)) || is_at_border(s.triangulation.head(first)))
        continue;
      ++slits;
      BOOST_CHECK_EQUAL(slit.mesh().number_of_vertices(), plain.number_of_vertices() + 2);
      BOOST_CHECK_EQUAL(slit.mesh().number_of_faces(), plain.number_of_faces() + 2);
      BOOST_CHECK_EQUAL(number_of_borders(slit.mesh()), number_of_borders(plain) + 1);
      for(Halfedge_index h : {first, Triangulation::twin(first)}) {
        const auto along = slit.halfedges_along(h);
        BOOST_REQUIRE_EQUAL(along.size(), 2u);
        const FG::Subdivision_vertex middle = slit.vertex_origin(slit.mesh().target(along[0]));
        BOOST_CHECK_EQUAL(middle.intrinsic_vertex, FG::null_index);
        BOOST_CHECK_EQUAL(middle.intrinsic_halfedge, first);
        BOOST_CHECK_EQUAL(middle.intrinsic_t, 0.5);
        BOOST_CHECK_EQUAL(middle.on_input.t, 0.5);
        BOOST_CHECK(!middle.on_input.is_inside_face());
      }
    }
    BOOST_CHECK_GT(slits, 0);
  }
}

// From the vertex of a face's middle to a corner, and between two such vertices.
BOOST_AUTO_TEST_CASE(a_slit_of_one_edge_inside_a_face_opens)
{
  Curve_setting s(flat_grid(5, 5, Diagonal_rule::RISING));
  const Vertex_index corner(grid_vertex(5, 2, 2));
  const Input_halfedge_index h = FG::internal::as_input(s.triangulation.outgoing(corner));
  const Vertex_index x = s.triangulation.insert(FG::Surface_location{h, {{1, 1, 1}}});
  const Vertex_index y = s.triangulation.insert(FG::Surface_location{h, {{1, 1, 4}}});
  for(const Vertex_index to : {y, corner}) {
    Halfedge_index g = s.triangulation.outgoing(x);
    for(int i = 0; i < 10 && s.triangulation.head(g) != to; ++i)
      g = s.triangulation.clockwise(g);
    BOOST_REQUIRE_EQUAL(s.triangulation.head(g), to);
    s.network.add_curve(Halfedge_sequence{g});
    check_inserted(s);
    const Subdivision slit = cut_open(s);
    BOOST_CHECK_EQUAL(number_of_borders(slit.mesh()), 2);
    s.network.clear();
  }
}

BOOST_AUTO_TEST_CASE(cuts_that_meet_and_cuts_that_do_not)
{
  const int n = 6;
  const auto v = [](int i, int j) { return Vertex_index(grid_vertex(n, i, j)); };
  const std::vector<std::vector<Vertex_sequence>> worlds = {
      {{v(2, 2), v(3, 2)}, {v(2, 4), v(3, 4)}}, // two slits of one edge
      {{v(2, 2), v(3, 2)}, {v(3, 2), v(3, 3)}}, // that share a vertex
      {{v(2, 2), v(3, 2)}, {v(3, 3), v(3, 2)}, {v(4, 2), v(3, 2)}},
      {{v(2, 2), v(3, 2), v(4, 2)}},                              // of two edges
      {{v(2, 2), v(3, 2), v(3, 3), v(2, 3), v(2, 2)}},            // closed
      {{v(2, 2), v(3, 2), v(3, 3), v(2, 2)}, {v(3, 3), v(4, 3)}}, // with a tail
      {{v(0, 2), v(1, 2)}},                                       // from the border
      {{v(0, 2), v(1, 2)}, {v(1, 2), v(1, 1)}},                   // and on
      {{v(0, 2), v(1, 2), v(1, 1), v(1, 0)}},                     // from border to border
      {{v(0, 0), v(1, 1), v(2, 2), v(3, 3), v(4, 4), v(5, 5), v(6, 6)}, {v(0, 3), v(1, 3), v(2, 3), v(3, 3)}},
      {{v(0, 1), v(0, 2), v(0, 3)}},            // along the border
      {{v(0, 1), v(0, 2), v(1, 2)}},            // and off it
      {{v(1, 1), v(0, 0)}},                     // to a corner
      {{v(0, 5), v(1, 5), v(1, 6)}},            // a corner off
      {{v(2, 2), v(3, 2)}, {v(2, 2), v(3, 2)}}, // twice
      {{v(2, 2), v(3, 2)}, {v(3, 2), v(2, 2)}},
      {}};
  for(const std::vector<Vertex_sequence>& world : worlds) {
    Curve_setting s(flat_grid(n, n, Diagonal_rule::RISING));
    for(const Vertex_sequence& curve : world)
      s.add(curve, false);
    check_inserted(s);
    cut_open(s);
  }
  Curve_setting corner(flat_grid(1, 1, Diagonal_rule::RISING)); // an edge inside with both ends on the border
  corner.add({Vertex_index(grid_vertex(1, 0, 0)), Vertex_index(grid_vertex(1, 1, 1))}, false);
  check_inserted(corner);
  BOOST_CHECK_EQUAL(number_of_parts(cut_open(corner).mesh()), 2);
}

// Slits of two edges and those that start on the border open by themselves: they get no vertices in their middles.
BOOST_AUTO_TEST_CASE(slits_that_open_by_themselves)
{
  const int n = 6;
  const auto v = [](int i, int j) { return Vertex_index(grid_vertex(n, i, j)); };
  for(const Vertex_sequence& slit : std::vector<Vertex_sequence>{{v(2, 2), v(3, 2), v(4, 2)},
                                                                 {v(2, 2), v(2, 3), v(2, 4)},
                                                                 {v(2, 2), v(3, 3), v(4, 4)},
                                                                 {v(2, 2), v(3, 2), v(3, 3)},
                                                                 {v(3, 2), v(2, 2), v(2, 3)},
                                                                 {v(2, 2), v(3, 3), v(3, 2)},
                                                                 {v(0, 2), v(1, 2)},
                                                                 {v(6, 2), v(5, 2)},
                                                                 {v(2, 0), v(2, 1)},
                                                                 {v(2, 6), v(2, 5)}})
  {
    Curve_setting s(flat_grid(n, n, Diagonal_rule::RISING));
    s.add(slit, false);
    BOOST_CHECK_EQUAL(cut_open(s).mesh().number_of_vertices(), s.mesh.number_of_vertices() + 1);
  }
}

BOOST_AUTO_TEST_CASE(short_loops_are_cut)
{
  // A loop about the apex of a cone, pulled to one segment, and one that contracts.
  Curve_setting cone(cone_disk(6, 3, 2));
  Vertex_sequence rim = disk_ring(6, 2);
  rim.push_back(rim.front());
  cone.add(rim, false); // fixed at one vertex
  cone.pull();
  check_inserted(cone);
  BOOST_CHECK_EQUAL(number_of_parts(cut_open(cone).mesh()), 2);
  cone.network.clear();
  cone.triangulation.rollback();
  rim.pop_back();
  cone.add(rim, true);
  cone.pull();
  BOOST_CHECK_EQUAL(number_of_parts(cut_open(cone).mesh()), 1);

  // On two triangles back to back, flips make loops that cross one edge only.
  Mesh_soup pillow;
  pillow.points = {{0, 0, 0}, {1, 0, 0}, {0.4, 1, 0}};
  pillow.triangles = {{0, 1, 2}, {0, 2, 1}};
  for(Edge_index e : descriptors<Edge_index>(3)) {
    const Halfedge_index h = FG::internal::first_side(e);
    Curve_setting s(pillow);
    if(!s.triangulation.is_flippable(h))
      continue;
    s.triangulation.flip(h);
    BOOST_CHECK_EQUAL(s.triangulation.tail(h), s.triangulation.head(h));
    s.network.add_curve(Halfedge_sequence{h}, CGAL::parameters::is_closed(true));
    check_inserted(s, 2);
    BOOST_CHECK_EQUAL(number_of_parts(cut_open(s).mesh()), 2);
  }

  // A common subdivision keeps two edges with the same ends there, and is a surface all the same.
  Curve_setting s(pillow);
  s.triangulation.insert({0_input_h, {{0.3, 0.3, 0.4}}});
  FG::flip_to_delaunay(s.triangulation);
  const auto both = FG::common_subdivision(s.triangulation, s.mesh);
  BOOST_CHECK(CGAL::is_valid_polygon_mesh(both.mesh()));
  BOOST_CHECK_EQUAL(euler_characteristic(both.mesh()), 2);
  for(const auto f : faces(both.mesh())) {
    const auto on_input = s.triangulation.input().halfedge(both.input_face(f));
    for(const auto h : halfedges_around_face(halfedge(face(on_input, s.mesh), s.mesh), s.mesh))
      BOOST_CHECK_LE(both.input_face(f), s.triangulation.input().index(h));
  }
}

BOOST_AUTO_TEST_CASE(loops_cut_a_torus_into_a_cylinder_and_a_square)
{
  const int n = 12, m = 8;
  Curve_setting s(shaken(torus(n, m, 3, 1), 0.02, 1));
  Vertex_sequence around, along;
  for(int j = 0; j <= m; ++j)
    around.emplace_back(n * (j % m));
  for(int i = 0; i <= n; ++i)
    along.emplace_back(i % n);
  s.add(around, false);
  s.pull();
  check_inserted(s);
  const Subdivision cylinder = cut_open(s);
  BOOST_CHECK_EQUAL(euler_characteristic(cylinder.mesh()), 0);
  BOOST_CHECK_EQUAL(number_of_borders(cylinder.mesh()), 2);

  s.network.clear();
  s.triangulation.rollback();
  s.add(around, false);
  s.add(along, false);
  s.pull();
  check_inserted(s);
  const Subdivision square = cut_open(s);
  BOOST_CHECK_EQUAL(euler_characteristic(square.mesh()), 1);
  BOOST_CHECK_EQUAL(number_of_borders(square.mesh()), 1);
}

BOOST_AUTO_TEST_CASE(a_path_from_border_to_border_separates)
{
  const int n = 9;
  Curve_setting s(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 9));
  s.add_path(Vertex_index(grid_vertex(n, 0, 2)), Vertex_index(grid_vertex(n, n, 7)));
  s.pull();
  check_inserted(s);
  const Subdivision halves = cut_open(s);
  BOOST_CHECK_EQUAL(euler_characteristic(halves.mesh()), 2);
  BOOST_CHECK_EQUAL(number_of_borders(halves.mesh()), 2);
}
