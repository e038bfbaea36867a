// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Curves above one another, and many that cross.

#include "test_subdivide/cuts.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(stacked_curves_are_cut_once)
{
  const Mesh_soup soup = grid_with_hole(12, 12, 4, 8, 4, 8); // paths round the hole's corner run along one another
  const auto vertex = [&](double x, double y) { return Vertex_index(index_of(soup, {x, y, 0})); };
  Curve_setting s(soup);
  s.add_path_through({vertex(0, 6), vertex(6, 12)});
  s.add_path_through({vertex(0, 6), vertex(6, 12)});
  s.add_path_through({vertex(0, 7), vertex(0, 9)}); // along the border
  s.add_path_through({vertex(5, 2), vertex(8, 2)});
  s.add_path_through({vertex(5, 2), vertex(8, 2)});
  FG::order_overlapping_curves(s.network);
  s.pull();
  std::size_t highest = 0;
  for(Edge_index e : descriptors<Edge_index>(s.triangulation.number_of_edges()))
    highest = (std::max)(highest, s.network.bundle(e).size());
  BOOST_CHECK_EQUAL(highest, 2u);
  check_inserted(s);
  cut_open(s);
}

BOOST_AUTO_TEST_CASE(many_curves_on_meshes_with_ties_and_without)
{
  Random_numbers random(23);
  int networks = 0;
  for(const Mesh_soup& soup : {cube(4), genus_3_plate(2), shaken(torus(14, 9, 3, 1), 0.03, 2), tetrahedron(4),
                               grid_with_hole(9, 9, 3, 5, 3, 6)})
    for(int round = 0; round < 4; ++round) {
      Curve_setting s(soup);
      const Vertex_index source(random.below(static_cast<int>(s.mesh.number_of_vertices())));
      for(int i = 0; i < 8; ++i) {
        const Vertex_index target(random.below(static_cast<int>(s.mesh.number_of_vertices())));
        if(target != source)
          s.add_path(source, target);
      }
      try {
        FG::order_overlapping_curves(s.network);
      } catch(const FG::Crossing_curves_error&) { // one passes the end of another on the wrong side
        continue;
      }
      ++networks;
      s.pull();
      check_inserted(s);
      cut_open(s);
    }
  BOOST_CHECK_GE(networks, 10);
}

BOOST_AUTO_TEST_CASE(curves_between_inserted_points)
{
  Random_numbers random(41);
  std::size_t dropped = 0;
  for(const Mesh_soup& soup :
      {cube(3), shaken(torus(9, 6, 3, 1), 0.05, 3), jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 2)})
    for(int round = 0; round < 6; ++round) {
      Curve_setting s(soup);
      insert_points(s, 12, random);
      const int first = static_cast<int>(s.mesh.number_of_vertices()),
                count = s.triangulation.number_of_vertices() - first;
      // A walk of edges from one inserted point that bends at others; then a straight one.
      s.network.add_curve(random_walk(s.triangulation, 5, false, random));
      check_inserted(s);
      cut_open(s);
      s.network.clear();
      const Vertex_index start(first + random.below(count));
      const auto outgoing_halfedges = outgoing_halfedges_at_tail(s.triangulation, s.triangulation.outgoing(start));
      s.network.add_curve(Halfedge_sequence{outgoing_halfedges.front()});
      s.pull();
      check_inserted(s);
      const Subdivision slit = cut_open(s);
      dropped += static_cast<std::size_t>(s.triangulation.number_of_vertices()) + 1 > slit.mesh().number_of_vertices();
      insert_points(s, 30, random); // curves are split where a point lies on them
      check_inserted(s);
      cut_open(s);
    }
  BOOST_CHECK_GT(dropped, 0u); // inserted points that no curve needs are not in the mesh
}

BOOST_AUTO_TEST_CASE(stacks_of_unfinished_curves_on_delta_complexes)
{
  Random_numbers random(31);
  for(int round = 0; round < 20; ++round) {
    Curve_setting s(shaken(tetrahedron(2), 0.05, 7));
    flip_at_random(s.triangulation, 60, random);
    s.network.add_curve(random_walk(s.triangulation, 6, false, random));
    check_inserted(s);
    cut_open(s);
  }
}

BOOST_AUTO_TEST_CASE(crossings_closer_than_rounding_do_no_harm)
{
  // Geodesics through one point of a fine grid's lines, from a mesh that is scaled by 2^-40 across.
  for(double squeeze : {0x1p-20, 0x1p-40}) {
    const int n = 10;
    const Mesh_soup soup = mapped(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 3), [&](const Coordinates& p) {
      return Coordinates{p[0], p[1] * squeeze, 0};
    });
    Curve_setting s(soup);
    for(int i : {1, 4, 9})
      s.add_path(Vertex_index(grid_vertex(n, 0, 0)), Vertex_index(grid_vertex(n, n, i)));
    FG::order_overlapping_curves(s.network);
    s.pull();
    check_inserted(s);
    cut_open(s);
    check_mesh(FG::common_subdivision(s.triangulation, s.mesh));
  }
}

namespace {

// A bundle of edges from bottom to top that are hardly any distance apart, and points on its left and on its right, on
// lines across it that are no further apart. First come the ends of the bundle's edges, then those of the lines.
Mesh_soup bundle_of_edges(int columns, int lines)
{
  constexpr double gap = 1e-15;
  Mesh_soup soup;
  for(int i = 0; i < columns; ++i)
    soup.points.insert(soup.points.end(), {{i * gap, 0, 0}, {(i * 7 % columns == 0 ? i + 0.3 : i + 0.1) * gap, 1, 0}});
  for(int j = 0; j < lines; ++j)
    soup.points.insert(soup.points.end(), {{-1, 0.3 + j * gap, 0}, {1, 0.7 + j * gap, 0}});
  const int last = 2 * columns - 2, top = 2 * (columns + lines - 1);
  for(int i = 0; i < last; i += 2)
    soup.triangles.insert(soup.triangles.end(), {{i, i + 2, i + 1}, {i + 2, i + 3, i + 1}});
  for(int left = 2 * columns; left < top; left += 2)
    soup.triangles.insert(soup.triangles.end(), {{left, 0, left + 2}, {left + 1, left + 3, last}});
  soup.triangles.insert(soup.triangles.end(), {{top, 0, 1}, {last, top + 1, last + 1}});
  return soup;
}

} // namespace

// Rounding exchanges crossings that are so close together; their order is that of the words all the same.
BOOST_AUTO_TEST_CASE(positions_of_crossings_are_in_order)
{
  std::size_t compared = 0;
  for(int columns : {3, 10}) {
    constexpr int lines = 8;
    Curve_setting s(bundle_of_edges(columns, lines));
    for(int left = 2 * columns; left < 2 * (columns + lines); left += 2)
      s.add_path(Vertex_index(left), Vertex_index(left + 1));
    FG::order_overlapping_curves(s.network);
    s.pull();
    const FG::internal::Overlay<Triangulation> overlay(s.triangulation);
    const FG::internal::Overlay_layout<Triangulation> layout(overlay);
    for(Edge_index e : descriptors<Edge_index>(s.triangulation.number_of_edges()))
      for(FG::Index i = 0; i + 1 < overlay.crossings(e); ++i, ++compared)
        BOOST_CHECK_LE(layout.on_intrinsic(overlay.crossing_vertex(e, i)),
                       layout.on_intrinsic(overlay.crossing_vertex(e, i + 1)));
    for(FG::internal::Overlay_halfedge h : overlay.halfedges()) {
      const Input_halfedge_index c = overlay.input_halfedge(h);
      if(c == FG::null_index || !FG::internal::is_first_side(c) || overlay.is_crossing(overlay.origin(h)))
        continue;
      double reached = 0;
      for(FG::internal::Overlay_halfedge arc = h; overlay.is_crossing(overlay.target(arc));
          arc = overlay.next_arc(arc), ++compared)
      {
        const FG::internal::Overlay_vertex v = overlay.target(arc);
        const double t = overlay.crossed_halfedge(v) == c ? layout.on_input(v) : 1 - layout.on_input(v);
        BOOST_CHECK_GE(t, reached - 0x1p-53); // told from either end
        reached = t;
      }
    }
  }
  BOOST_CHECK_GT(compared, 500u);
}
