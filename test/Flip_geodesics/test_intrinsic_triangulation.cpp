// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE intrinsic_triangulation

#include "test_intrinsic_triangulation/inserted_vertices.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(flips_keep_area_and_angle_sums)
{
  Random_numbers random(1);
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation t(mesh);
    const Measures before(t);
    for(int i = 0; i < 20 * scale; ++i) {
      flip_at_random(t, 30, random);
      const Measures after(t);
      BOOST_TEST(std::abs(after.area - before.area) < 1e-9 * before.area);
      for(FG::Vertex_index v : descriptors<FG::Vertex_index>(t.number_of_vertices()))
        BOOST_TEST(std::abs(after.angle_sums[v] - before.angle_sums[v]) < 1e-8);
      BOOST_TEST(t.is_valid());
      t.rollback(t.log_position() * 3 / 4);
    }
  }
}

// On both sides of edges, on the border as well.
BOOST_AUTO_TEST_CASE(lengths_and_turns_of_both_sides)
{
  Random_numbers random(7);
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation t(mesh);
    flip_at_random(t, 60, random);
    for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
      if(t.is_border(h)) {
        BOOST_TEST(t.squared_length(h) == t.squared_length(t.twin(h)));
        BOOST_TEST(t.length(h) == t.length(t.twin(h)));
      }
      Triangulation::Turn turn;
      BOOST_TEST(t.extend_turn_clockwise(turn, h) == t.clockwise(h));
    }
    BOOST_TEST(t.is_valid());
    BOOST_TEST(!t.is_valid(-2)); // which no face can satisfy
  }
}

BOOST_AUTO_TEST_CASE(four_flips_are_the_identity)
{
  Random_numbers random(2);
  long tested = 0;
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation t(mesh);
    for(int i = 0; i < 100 * scale; ++i) {
      flip_at_random(t, 2, random);
      const FG::Halfedge_index h(random.below(t.number_of_halfedges()));
      if(!t.is_flippable(h))
        continue;
      const std::vector<int> before = connectivity(t);
      const double length = t.length(h);
      for(int k = 0; k < 4; ++k)
        t.flip(h);
      BOOST_TEST((connectivity(t) == before));
      BOOST_TEST(std::abs(t.length(h) - length) < 1e-12 * length);
      ++tested;
      if(t.log_position() > 200)
        t.rollback();
    }
  }
  BOOST_TEST(tested > 200);
}

BOOST_AUTO_TEST_CASE(rollback_restores_every_bit)
{
  Random_numbers random(3);
  std::size_t flips = 0;
  Oddities odd;
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation t(mesh);
    const Snapshot input(t);
    for(int k = 0; k < 5 * scale; ++k) {
      std::vector<std::pair<Triangulation::Log_position, Snapshot>> places;
      for(int i = 0; i < 10; ++i) {
        places.emplace_back(t.log_position(), Snapshot(t));
        flip_at_random(t, 200, random);
        odd.count(t);
      }
      flips += t.log_position();
      BOOST_TEST(t.is_valid(1e-3));
      for(std::size_t i = places.size(); i-- > 0;) {
        t.rollback(places[i].first);
        BOOST_TEST(t.log_position() == places[i].first);
        BOOST_TEST((Snapshot(t) == places[i].second));
      }
      BOOST_TEST((Snapshot(t) == input));
      for(FG::Vertex_index v : descriptors<FG::Vertex_index>(t.number_of_vertices()))
        BOOST_TEST((t.outgoing(v) == FG::null_index || t.tail(t.outgoing(v)) == v));
    }
  }
  std::cout << flips << " flips rolled back; loops " << odd.loops << ", multiple edges " << odd.multiple_edges
            << ", vertices of degree 1 " << odd.degree_one << ", faces glued to themselves " << odd.self_glued_faces
            << ", border edges " << odd.border_edges << '\n';
  BOOST_TEST(flips > 10000u);
  BOOST_TEST(odd.loops > 0);
  BOOST_TEST(odd.multiple_edges > 0);
  BOOST_TEST(odd.degree_one > 0);
  BOOST_TEST(odd.self_glued_faces > 0);
  BOOST_TEST(odd.border_edges > 0);
}

// A face that is laid out afresh between flips has another frame; flips that are taken back must not mix the two.
BOOST_AUTO_TEST_CASE(rollback_restores_faces_that_were_laid_out_afresh)
{
  const Mesh mesh = to_mesh<Mesh>(shaken(octahedron(2), 0.2, 9));
  Triangulation t(mesh);
  const Snapshot input(t);
  Random_numbers random(11);
  for(int i = 0; i < 200; ++i) {
    flip_at_random(t, 3, random);
    const FG::Halfedge_index h(random.below(t.number_of_halfedges())); // turned by a right angle
    const auto a = t.geometry(h), b = t.geometry(t.next(h)), c = t.geometry(t.previous(h));
    t.set_face_geometry(h, {{{-a.y, a.x}, {-b.y, b.x}, {-c.y, c.x}}});
  }
  BOOST_TEST(t.is_valid());
  t.rollback();
  BOOST_TEST((Snapshot(t) == input));
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
    const auto a = t.geometry(h), b = t.geometry(t.next(h)), c = t.geometry(t.previous(h));
    BOOST_TEST(std::abs(a.x + b.x + c.x) + std::abs(a.y + b.y + c.y) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(the_first_touch_leaves_no_trace)
{
  const Mesh mesh = to_mesh<Mesh>(shaken(torus(5, 4, 3, 1), 0.2, 10));
  const Triangulation forward(mesh), backward(mesh);
  for(FG::Index h = forward.number_of_halfedges(); h-- > 0;)
    backward.is_border(FG::Halfedge_index(h));
  BOOST_TEST((Snapshot(forward) == Snapshot(backward)));
}

BOOST_AUTO_TEST_CASE(lengths_alone_give_the_same_triangulation)
{
  const Mesh mesh = to_mesh<Mesh>(shaken(torus(5, 4, 3, 1), 0.2, 8));
  std::map<Edge, double> lengths;
  for(Edge e : edges(mesh))
    lengths[e] = std::sqrt(CGAL::squared_distance(mesh.point(source(e, mesh)), mesh.point(target(e, mesh))));
  Triangulation embedded(mesh);
  Length_triangulation intrinsic(mesh, Length_metric(mesh, Length_map(lengths)));
  Random_numbers random(6);
  for(int i = 0; i < 500; ++i) {
    const FG::Halfedge_index h(random.below(embedded.number_of_halfedges()));
    BOOST_TEST(embedded.is_flippable(h) == intrinsic.is_flippable(h));
    if(!embedded.is_flippable(h))
      continue;
    embedded.flip(h);
    intrinsic.flip(h);
    BOOST_TEST(embedded.length(h) == intrinsic.length(h), boost::test_tools::tolerance(1e-10));
    BOOST_TEST(embedded.crossings(embedded.edge(h)) == intrinsic.crossings(intrinsic.edge(h)));
  }
  BOOST_TEST(intrinsic.is_valid());
}

namespace {

// The angle between sides a and b of a face, opposite to c, by lengths alone.
double law_of_cosines(double a, double b, double c)
{
  return std::acos((std::max)(-1.0, (std::min)(1.0, (a * a + b * b - c * c) / (2 * a * b))));
}

double opposite_angle(const Triangulation& t, FG::Halfedge_index h)
{
  return law_of_cosines(t.length(t.next(h)), t.length(t.previous(h)), t.length(h));
}

} // namespace

BOOST_AUTO_TEST_CASE(flips_lead_to_a_delaunay_triangulation)
{
  int flips = 0;
  std::vector<Mesh_soup> all = soups();
  all.push_back(jittered_grid(12, 12, Diagonal_rule::RANDOM, 0.24, 1));
  all.push_back(bumpy_sphere(6, 0.3, 1));
  all.push_back(mapped(jittered_grid(12, 12, Diagonal_rule::RANDOM, 0.24, 2), [](const Coordinates& p) {
    return Coordinates{p[0], p[1] / 50, p[2]};
  }));
  for(const Mesh_soup& soup : all) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation t(mesh);
    Random_numbers random(1);
    for(int round = 0; round < 3 * scale; ++round) {
      flip_at_random(t, round * 300, random);
      const int count = flip_to_delaunay(t, 100000);
      BOOST_TEST(count >= 0);
      flips += count;
      BOOST_TEST(are_all_edges_delaunay(t));
      BOOST_TEST(t.is_valid());
      for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges()))
        if(!t.is_border(h) && !t.is_border(t.twin(h)))
          BOOST_TEST(opposite_angle(t, h) + opposite_angle(t, t.twin(h)) < pi + 1e-6);
    }
  }
  std::cout << flips << " flips to Delaunay triangulations\n";
  BOOST_TEST(flips > 1000);
}

BOOST_AUTO_TEST_CASE(cocircular_points_are_delaunay)
{
  for(const Mesh_soup& soup : {flat_grid(8, 8, Diagonal_rule::RANDOM), cube(4), box(3, 5, 7, 4)}) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation t(mesh);
    BOOST_TEST(are_all_edges_delaunay(t));
  }
  // By more than the tolerance outside of the circle, and inside.
  for(double x : {1 + 1e-7, 1 - 1e-7}) {
    const Mesh mesh = to_mesh<Mesh>(Mesh_soup{{{-1, 0, 0}, {0, -1, 0}, {x, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
    Triangulation t(mesh);
    BOOST_TEST(are_all_edges_delaunay(t) == (x < 1));
    BOOST_TEST(flip_to_delaunay(t, 10) == (x < 1 ? 0 : 1));
  }
}

BOOST_AUTO_TEST_CASE(faces_laid_out_afresh_are_as_they_were)
{
  Random_numbers random(14);
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation t(mesh);
    for(int i = 0; i < 10 * scale; ++i) {
      flip_at_random(t, 20, random);
      const FG::Halfedge_index h(random.below(t.number_of_halfedges()));
      if(t.is_border(h))
        continue;
      const std::array<FG::Halfedge_index, 3> sides = {h, t.next(h), t.previous(h)};
      std::array<double, 3> lengths;
      for(int k = 0; k < 3; ++k)
        lengths[k] = t.length(sides[k]);
      BOOST_TEST(FG::internal::refresh_face(t, h));
      for(int k = 0; k < 3; ++k)
        BOOST_TEST(std::abs(t.length(sides[k]) - lengths[k]) < 1e-9 * lengths[k]);
      BOOST_TEST(t.is_valid());
    }
  }
}

BOOST_AUTO_TEST_CASE(edge_paths_are_the_shortest_of_all)
{
  Random_numbers random(15);
  for(const Mesh_soup& soup :
      {jittered_grid(4, 3, Diagonal_rule::RANDOM, 0.2, 2), bumpy_sphere(2, 0.4, 3), grid_with_hole(4, 4, 1, 3, 1, 3)})
  {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation t(mesh);
    insert_at_random(t, 4, random);
    flip_at_random(t, 20, random);
    const int n = t.number_of_vertices();
    for(FG::Vertex_index source : descriptors<FG::Vertex_index>(n)) {
      FG::internal::Indexed_by<FG::Vertex_index, std::vector<double>> distance(static_cast<std::size_t>(n),
                                                                               std::numeric_limits<double>::infinity());
      distance[source] = 0;
      for(int round = 0; round < n; ++round) // Bellman-Ford algorithm
        for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges()))
          distance[t.head(h)] = (std::min)(distance[t.head(h)], distance[t.tail(h)] + t.length(h));
      for(FG::Vertex_index target : descriptors<FG::Vertex_index>(n)) {
        double length = 0;
        FG::Vertex_index v = source;
        for(FG::Halfedge_index h : FG::shortest_intrinsic_edge_path(t, source, target)) {
          BOOST_TEST(t.tail(h) == v);
          v = t.head(h);
          length += t.length(h);
        }
        BOOST_TEST(v == target);
        BOOST_TEST(std::abs(length - distance[target]) < 1e-12 * (1 + length));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(isolated_vertices_have_no_outgoing_halfedges)
{
  const Mesh mesh = to_mesh<Mesh>(with_isolated_vertices(octahedron(1), 2, 1));
  const Triangulation t(mesh);
  BOOST_TEST(t.number_of_vertices() == 9);
  for(FG::Vertex_index v : descriptors<FG::Vertex_index>(9))
    BOOST_TEST((t.outgoing(v) == FG::null_index) == (v < 2_v || v == 8_v));
}

// A face that is removed and leaves all its edges is a hole. Where vertices or edges are removed, indices have gaps.
BOOST_AUTO_TEST_CASE(removed_elements_are_refused)
{
  Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::FALLING));
  const auto inner = std::find_if(mesh.faces().begin(), mesh.faces().end(), [&](Mesh::Face_index f) {
    const auto sides = CGAL::halfedges_around_face(mesh.halfedge(f), mesh);
    return std::none_of(sides.begin(), sides.end(), [&](auto h) { return mesh.is_border(mesh.opposite(h)); });
  });
  CGAL::Euler::remove_face(mesh.halfedge(*inner), mesh);
  BOOST_REQUIRE(mesh.has_garbage());
  Triangulation t(mesh);
  Random_numbers random(7);
  flip_at_random(t, 200, random);
  BOOST_TEST(t.log_position() > 20u);
  BOOST_TEST(t.is_valid());

  const auto at_border = std::find_if(mesh.halfedges().begin(), mesh.halfedges().end(),
                                      [&](auto h) { return mesh.is_border(mesh.opposite(h)); });
  CGAL::Euler::remove_face(*at_border, mesh);
  BOOST_CHECK_THROW(Triangulation{mesh}, FG::Invalid_mesh_error);
  mesh.collect_garbage();
  BOOST_CHECK_NO_THROW(Triangulation{mesh});
}

BOOST_AUTO_TEST_CASE(moving_keeps_everything)
{
  const Mesh mesh = to_mesh<Mesh>(shaken(octahedron(2), 0.2, 9));
  Triangulation t(mesh);
  Random_numbers random(8);
  flip_at_random(t, 300, random);
  const Snapshot before(t);
  Triangulation moved(std::move(t));
  BOOST_TEST((Snapshot(moved) == before));
  Triangulation assigned(mesh);
  assigned = std::move(moved);
  BOOST_TEST((Snapshot(assigned) == before));
  assigned.rollback();
  BOOST_TEST((Snapshot(assigned) == Snapshot(Triangulation(mesh))));
}
