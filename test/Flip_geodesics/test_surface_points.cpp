// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points of the surface as vertices: in the input and in flipped triangulations, against an unfolding of its own.

#define BOOST_TEST_MODULE surface_points

#include "test_surface_points/inserted_points.h"

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/subdivide.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cmath>
#include <cstddef>

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(points_in_flipped_triangulations)
{
  Counts counts;
  unsigned seed = 1;
  for(const Mesh_soup& soup : soups())
    for(int flips : {0, 6, 40})
      for(int i = 0; i < scale; ++i) {
        BOOST_TEST_CONTEXT("plain, seed " << seed << ", " << flips << " flips")
        insert_flip_and_roll_back<Plain>(soup, flips, 8, seed, counts);
        BOOST_TEST_CONTEXT("certified, seed " << seed << ", " << flips << " flips")
        insert_flip_and_roll_back<Certified>(soup, flips, 8, seed, counts);
        ++seed;
      }
  std::cout << "splits of faces " << counts.faces << ", of edges " << counts.edges << "; points at vertices "
            << counts.vertices << std::endl;
  BOOST_TEST(counts.faces > 100);
  BOOST_TEST(counts.edges > 50);
  BOOST_TEST(counts.vertices > 10);
}

// The face of an edge to a vertex of degree 1 is glued to itself along it; told from either end.
BOOST_AUTO_TEST_CASE(a_point_on_the_edge_to_a_vertex_of_degree_one)
{
  int splits = 0;
  for(unsigned seed = 1; seed < 40; ++seed) {
    const Mesh mesh = to_mesh<Mesh>(cone_disk(3, 1, 0.3)); // flat enough for its apex to lose all edges but one
    Random_numbers random(seed);
    Certified t(mesh);
    const double whole = area(t);
    for(int i = 0; i < 30; ++i) {
      const FG::Halfedge_index h = t.outgoing(0_v);
      if(t.next(t.twin(h)) == h && t.crossings(t.edge(h)) < 0) {
        const bool is_first = random.below(2) == 0;
        const auto word = t.edge_sequence(is_first ? h : t.twin(h));
        const FG::Vertex_index v = t.insert({word.along, {{1, 2, 0}}});
        BOOST_TEST(v.idx() == static_cast<int>(mesh.number_of_vertices()));
        BOOST_TEST(t.is_valid());
        check_words(mesh, t);
        check_measures(t, whole);
        ++splits;
        break;
      }
      const auto outgoing_halfedges = outgoing_halfedges_at_tail(t, h);
      const FG::Halfedge_index g = outgoing_halfedges[random.below(static_cast<int>(outgoing_halfedges.size()))];
      if(t.is_flippable(g))
        t.flip(g);
    }
  }
  BOOST_TEST(splits > 0);
}

BOOST_AUTO_TEST_CASE(locations_told_in_other_words_are_one_vertex)
{
  const Mesh mesh = to_mesh<Mesh>(octahedron(1));
  Plain t(mesh);
  const FG::Input_halfedge_index h = 0_input_h, hn = t.input().next(h), hp = t.input().next(hn);
  const FG::Vertex_index inside = t.insert({h, {{1, 2, 4}}});
  BOOST_TEST(inside == 6_v);
  BOOST_TEST(t.insert({hn, {{2, 4, 1}}}) == inside);
  BOOST_TEST(t.insert({hp, {{0.5, 0.125, 0.25}}}) == inside);
  BOOST_TEST(t.insert({hp, {{0.125, 0.25, 0.5}}}) == 7_v); // a different point
  const FG::Vertex_index on_edge = t.insert({h, {{1, 3, 0}}});
  BOOST_TEST(on_edge == 8_v);
  BOOST_TEST(t.insert({FG::internal::twin_index(h), {{3, 1, 0}}}) == on_edge);
  BOOST_TEST(t.insert({hn, {{3, 0, 1}}}) == on_edge);
  BOOST_TEST(t.insert({hn, {{0, 7, 0}}}) == t.input().tail(hp));
  BOOST_TEST((kind(t.location(inside)) == FG::Location_kind::FACE));
  BOOST_TEST((kind(t.location(on_edge)) == FG::Location_kind::EDGE));
  BOOST_TEST((kind(t.location(2_v)) == FG::Location_kind::VERTEX));
}

// Where the border's halfedges are the first of their edges as well, and from each side.
BOOST_AUTO_TEST_CASE(a_location_has_one_canonical_form)
{
  Mesh mesh = to_mesh<Mesh>(flat_grid(2, 2, Diagonal_rule::RISING));
  for(int removed : {0, 1, 2}) {
    const Plain t(mesh);
    const auto& input = t.input();
    std::size_t first_on_border = 0;
    for(FG::Input_halfedge_index h : descriptors<FG::Input_halfedge_index>(input.number_of_halfedges())) {
      const FG::Surface_location on_edge = FG::internal::canonical_location(input, {h, {{1, 3, 0}}}),
                                 other = FG::internal::canonical_location(input,
                                                                          {FG::internal::twin_index(h), {{3, 1, 0}}});
      BOOST_TEST(on_edge.halfedge == other.halfedge);
      BOOST_TEST((on_edge.weights == other.weights));
      BOOST_TEST(!input.is_border(on_edge.halfedge));
      const double at_tail = on_edge.halfedge == h ? 1 : 3;
      BOOST_TEST((on_edge.weights == std::array<double, 3>{{at_tail, 4 - at_tail, 0}}));
      first_on_border += input.is_border(h) && FG::internal::is_first_side(h) ? 1 : 0;
      const FG::Surface_location vertex = FG::internal::canonical_location(input, {h, {{0, 7, 0}}});
      BOOST_TEST((vertex.weights == std::array<double, 3>{{1, 0, 0}}));
      BOOST_TEST(input.tail(vertex.halfedge) == input.tail(FG::internal::twin_index(h)));
    }
    BOOST_TEST((first_on_border > 0) == (removed > 0));
    CGAL::Euler::remove_face(mesh.halfedge(*mesh.faces().begin()), mesh);
    mesh.collect_garbage();
  }
  Mesh square;
  square.add_face(square.add_vertex(Point(0, 0, 0)), square.add_vertex(Point(1, 0, 0)),
                  square.add_vertex(Point(1, 1, 0)), square.add_vertex(Point(0, 1, 0)));
  const Plain t(square);
  const FG::Input_halfedge_index h = t.input().is_border(0_input_h) ? 1_input_h : 0_input_h;
  BOOST_CHECK_THROW(FG::internal::check_location(t.input(), {h, {{1, 1, 1}}}), FG::Invalid_mesh_error);
  BOOST_CHECK_NO_THROW(FG::internal::check_location(t.input(), {h, {{1, 0, 0}}}));
}

namespace {

// The weights over their sum, from the canonical halfedge on.
std::array<double, 3> relative_weights(const Plain& t, const FG::Surface_location& location)
{
  std::array<double, 3> weights = FG::internal::canonical_location(t.input(), location).weights;
  const double sum = weights[0] + weights[1] + weights[2];
  for(double& weight : weights)
    weight /= sum;
  return weights;
}

void check_same_point(const Plain& t, const FG::Surface_location& p, const FG::Surface_location& q)
{
  const auto& input = t.input();
  const FG::Input_halfedge_index g = FG::internal::canonical_location(input, p).halfedge,
                                 h = FG::internal::canonical_location(input, q).halfedge;
  BOOST_TEST((g == h || (kind(p) == FG::Location_kind::VERTEX && input.tail(g) == input.tail(h))));
  const auto a = relative_weights(t, p), b = relative_weights(t, q);
  for(std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(a[i] - b[i]) < 1e-15);
}

} // namespace

BOOST_AUTO_TEST_CASE(all_forms_of_a_point_convert_to_a_location_and_back)
{
  for(const Mesh_soup& soup : {bumpy_sphere(5, 0.3, 1), flat_grid(3, 3, Diagonal_rule::RISING)}) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    const Plain t(mesh);
    Random_numbers random(6);
    for(int i = 0; i < 200; ++i) {
      const FG::Surface_location location = random_location(mesh, random);
      const auto in_face = FG::face_location(t, mesh, location);
      BOOST_TEST(std::abs(in_face.second[0] + in_face.second[1] + in_face.second[2] - 1) < 1e-15);
      check_same_point(t, FG::surface_location(t, mesh, in_face), location);
      const FG::Surface_point point = FG::surface_point(t, location);
      check_same_point(t, FG::surface_location(t, mesh, point), location);
      FG::Curve_place<Mesh> place;
      place.location = in_face;
      check_same_point(t, FG::surface_location(t, mesh, place), location);
    }
    for(FG::Input_halfedge_index h : descriptors<FG::Input_halfedge_index>(t.input().number_of_halfedges()))
      check_same_point(t,
                       FG::surface_location(t, mesh, FG::face_location(t, mesh, FG::Surface_location{h, {{1, 3, 0}}})),
                       {h, {{1, 3, 0}}}); // the border as well
  }
}

BOOST_AUTO_TEST_CASE(bad_locations_are_refused_and_change_nothing)
{
  const Mesh mesh = to_mesh<Mesh>(single_triangle());
  Plain t(mesh);
  const Snapshot before(t);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  FG::Input_halfedge_index border = 0_input_h;
  while(!t.input().is_border(border))
    ++border;
  const FG::Input_halfedge_index h = FG::internal::twin_index(border);
  for(const FG::Surface_location& bad : std::vector<FG::Surface_location>{{FG::null_index, {{1, 1, 1}}},
                                                                          {6_input_h, {{1, 1, 1}}},
                                                                          {h, {{nan, 1, 1}}},
                                                                          {h, {{1, -1e-17, 1}}},
                                                                          {h, {{1, infinity, 1}}},
                                                                          {h, {{0, 0, 0}}},
                                                                          {h, {{1, 1e-200, 1}}},
                                                                          {border, {{1, 1, 1}}}})
    BOOST_CHECK_THROW(t.insert(bad), FG::Invalid_location_error);
  BOOST_TEST((Snapshot(t) == before));
  BOOST_TEST(t.insert({border, {{1, 1, 0}}}) == 3_v); // on the border edge
}

// Where the corners are, and points between them, in faces along the input's edges and across them.
BOOST_AUTO_TEST_CASE(points_of_faces_and_edges_are_told)
{
  for(bool is_flipped : {false, true}) {
    const Mesh mesh = to_mesh<Mesh>(jittered_grid(4, 4, Diagonal_rule::RANDOM, 0.2, 5));
    Random_numbers random(3);
    Plain t(mesh);
    if(is_flipped)
      flip_at_random(t, 100, random);
    const auto place = [&](const FG::Surface_location& at) {
      std::complex<double> sum = 0;
      double weights = 0;
      FG::Input_halfedge_index h = at.halfedge;
      for(int i = 0; i < 3; ++i, h = t.input().next(h)) {
        const Point& p = mesh.point(t.vertex(t.input().tail(h)));
        sum += at.weights[i] * std::complex<double>(p.x(), p.y());
        weights += at.weights[i];
      }
      return sum / weights;
    };
    for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
      if(t.is_border(h))
        continue;
      const FG::Vertex_index corners[3] = {t.tail(h), t.head(h), t.head(t.next(h))};
      for(const std::array<double, 3>& weights : std::vector<std::array<double, 3>>{
              {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{0.5, 0.5, 0}}, {{0.25, 0.5, 0.25}}, {{0.125, 0.125, 0.75}}})
      {
        const FG::Surface_location at = FG::location_in_face(t, h, weights);
        std::complex<double> expected = 0;
        for(int i = 0; i < 3; ++i)
          expected += weights[i] * place(t.location(corners[i]));
        BOOST_TEST(std::abs(place(at) - expected) < 1e-12);
        for(double weight : at.weights)
          BOOST_TEST((weight == 0 || weight >= 1e-15));
      }
    }
  }
}

// As short an edge as that has no usable length.
BOOST_AUTO_TEST_CASE(points_next_to_a_vertex_are_refused)
{
  const Mesh mesh = to_mesh<Mesh>(scaled(single_triangle(), 1e-60));
  Plain t(mesh);
  FG::Input_halfedge_index h = 0_input_h;
  while(t.input().is_border(h))
    ++h;
  const Snapshot before(t);
  for(const std::array<double, 3>& weights :
      std::vector<std::array<double, 3>>{{{1, 1e-20, 1e-20}}, {{1, 1e-20, 0}}, {{1e-20, 1, 1e-20}}})
    BOOST_CHECK_THROW(t.insert({h, weights}), FG::Insertion_error);
  BOOST_TEST((Snapshot(t) == before));
  BOOST_TEST(t.insert({h, {{1, 1e-5, 1e-5}}}) == 3_v);
}

// An edge that passes a vertex that closely has no room for points inside of the faces beside it.
BOOST_AUTO_TEST_CASE(there_is_room_on_an_edge_or_not)
{
  for(double depth : {0.5, 1e-3, 1e-9, 4e-15}) {
    const Mesh mesh =
        to_mesh<Mesh>(Mesh_soup{{{0, 0, 0}, {1, -depth, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 3}, {1, 2, 3}}});
    Certified t(mesh);
    const FG::Halfedge_index h = FG::internal::halfedge_between(t, 1_v, 3_v);
    BOOST_REQUIRE(t.is_flippable(h));
    t.flip(h);
    for(double place : {0.1, 0.5, 0.9}) {
      const auto point = FG::internal::point_on_edge(t, h, place);
      BOOST_TEST(point.has_value() == (depth > 1e-11));
      if(point)
        BOOST_TEST((kind(point->location) == FG::Location_kind::FACE));
    }
  }
}

// By all pairs' shortest paths along the edges inside of the face and on its sides.
BOOST_AUTO_TEST_CASE(paths_in_a_face_are_shortest)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(1, 1, Diagonal_rule::RISING));
  for(unsigned seed = 1; seed <= 20; ++seed) {
    Random_numbers random(seed);
    Plain t(mesh);
    FG::Input_halfedge_index face = 0_input_h;
    while(t.input().is_border(face))
      ++face;
    for(int i = 0; i < 8; ++i)
      t.insert({face, {{random.uniform(0.01, 1), random.uniform(0.01, 1), random.uniform(0.01, 1)}}});
    flip_at_random(t, static_cast<int>(seed % 4) * 5, random);
    const int n = t.number_of_vertices();
    using Row = FG::internal::Indexed_by<FG::Vertex_index, std::vector<double>>;
    FG::internal::Indexed_by<FG::Vertex_index, std::vector<Row>> length(
        n, Row(n, std::numeric_limits<double>::infinity()));
    for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
      const FG::Edge_sequence word = t.edge_sequence(h);
      bool is_inside = false;
      FG::Input_halfedge_index side = face;
      for(int i = 0; i < 3; ++i, side = t.input().next(side))
        is_inside =
            is_inside || word.face == side || word.along == side || word.along == FG::internal::twin_index(side);
      if(is_inside)
        length[t.tail(h)][t.head(h)] = (std::min)(length[t.tail(h)][t.head(h)], t.length(h));
    }
    const auto vertices = descriptors<FG::Vertex_index>(n);
    for(FG::Vertex_index via : vertices)
      for(FG::Vertex_index from : vertices)
        for(FG::Vertex_index to : vertices)
          length[from][to] = (std::min)(length[from][to], length[from][via] + length[via][to]);
    FG::internal::Path_in_face<Plain> path(t);
    for(FG::Vertex_index from : vertices)
      for(FG::Vertex_index to : vertices) {
        if(from == to)
          continue;
        const std::vector<FG::Halfedge_index> way = path(face, from, to);
        double sum = way.empty() ? std::numeric_limits<double>::infinity() : 0;
        for(FG::Halfedge_index h : way)
          sum += t.length(h);
        BOOST_TEST((sum == length[from][to] || std::abs(sum - length[from][to]) < 1e-12));
      }
  }
}
