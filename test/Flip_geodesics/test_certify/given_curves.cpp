// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Curves that are given by the places that they pass.

#include "test_certify/second_opinion.h"

#include <CGAL/Flip_geodesics/certify_curve.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

using namespace Flip_geodesics_test;

namespace {

using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;
using Place = FG::Given_place<Surface>;
using Places = std::vector<Place>;
using Certificate = FG::Given_curve_certificate<Surface>;
using Verdict = FG::Verdict;

Vertex vertex(int i) { return Vertex(static_cast<unsigned>(i)); }
Place place(int i) { return vertex(i); }
Place crossing(Halfedge h, double t = 0.5) { return std::make_pair(h, t); }

Certificate certified(const Surface& mesh, const Places& places, bool is_closed = false)
{
  return FG::certify_curve(mesh, places, CGAL::parameters::is_closed(is_closed));
}

// An inserted point by its face, with the bits of its weights.
template <class Triangulation>
Place place_of(const Surface& mesh, const Triangulation& triangulation, FG::Vertex_index v)
{
  if(!triangulation.is_inserted(v))
    return place(v.idx());
  const auto& input = triangulation.input();
  const FG::Surface_location location = triangulation.location(v);
  const auto face = mesh.face(input.halfedge(location.halfedge));
  FG::Input_halfedge_index h = input.index(mesh.halfedge(face));
  std::array<double, 3> weights;
  for(double& weight : weights) {
    const FG::Input_halfedge_index n = input.next(location.halfedge);
    weight = location.weights[h == location.halfedge ? 0 : (h == n ? 1 : 2)];
    h = input.next(h);
  }
  return std::make_pair(face, weights);
}

// The places of a curve of a network; edges by either side.
template <class Setting>
Places places_of(const Setting& setting, FG::Curve_index curve, Random_numbers& random)
{
  Places result;
  for(const auto h : setting.network.halfedges(curve)) {
    const FG::Edge_sequence word = setting.triangulation.edge_sequence(h);
    if(result.empty())
      result.push_back(place_of(setting.mesh, setting.triangulation, word.tail));
    for(const auto c : word.crossed)
      result.push_back(
          crossing(setting.triangulation.input().halfedge(random.below(2) == 0 ? c : FG::internal::twin_index(c))));
    result.push_back(place_of(setting.mesh, setting.triangulation, word.head));
  }
  return result;
}

// Both ways.
template <class Setting>
Certificate checked_places(const Setting& setting, Places places)
{
  const Certificate result = certified(setting.mesh, places);
  std::reverse(places.begin(), places.end());
  const Certificate reversed = certified(setting.mesh, places);
  BOOST_TEST((result.verdict() == reversed.verdict()));
  BOOST_TEST(std::abs(result.bend - reversed.bend) < 1e-9);
  BOOST_TEST_REQUIRE(result.places.size() == reversed.places.size());
  for(std::size_t i = 0; i < result.places.size(); ++i)
    BOOST_TEST(std::abs(result.places[i] - reversed.places[places.size() - 1 - i]) < 1e-9);
  return result;
}

// Vertex 0 in the middle, and six about it at distance 1.
Surface hexagon()
{
  Mesh_soup soup = {{{0, 0, 0}}, {}};
  for(int i = 0; i < 6; ++i) {
    soup.points.push_back({std::cos(i * pi / 3), std::sin(i * pi / 3), 0});
    soup.triangles.push_back({0, i + 1, (i + 1) % 6 + 1});
  }
  return to_mesh<Surface>(soup);
}

Halfedge outgoing_halfedge(const Surface& mesh, int rim) { return mesh.halfedge(vertex(0), vertex(rim)); }

void check_bend(const Certificate& certificate, Verdict verdict, double bend, int v, std::size_t number, FG::Side side)
{
  BOOST_TEST((certificate.verdict() == verdict));
  BOOST_TEST(std::abs(certificate.bend - bend) < 1e-12);
  BOOST_TEST(certificate.vertex == vertex(v));
  BOOST_TEST(certificate.number == number);
  BOOST_TEST((certificate.side == side));
  BOOST_TEST(certificate.places.empty());
}

template <class Error>
void check_refused(const Surface& mesh, const Places& places, const std::vector<std::size_t>& elements,
                   bool is_closed = false)
{
  BOOST_CHECK_EXCEPTION(certified(mesh, places, is_closed), Error,
                        [&](const Error& error) { return error.elements() == elements; });
}

} // namespace

BOOST_AUTO_TEST_CASE(geodesics_are_proven_by_the_places_that_they_pass)
{
  std::size_t crossings = 0, vertices = 0;
  for(const Mesh_soup& soup : {jittered_grid(14, 14, Diagonal_rule::RANDOM, 0.24, 5), bumpy_sphere(8, 0.3, 1), cube(6),
                               genus_3_plate(1), needle_strip(7, 7, 0x1p20)})
  {
    Certified_setting setting(soup);
    Random_numbers random(3);
    for(int i = 0; i < 15; ++i) {
      add_random_path(setting, random);
      setting.pull();
      const Places places = places_of(setting, 0_c, random);
      const Certificate certificate = checked_places(setting, places);
      BOOST_TEST((certificate.verdict() == Verdict::PROVEN));
      BOOST_TEST(certificate.bend == 0);
      for(std::size_t k = 1; k + 1 < places.size(); ++k)
        ++(std::holds_alternative<Vertex>(places[k]) ? vertices : crossings);
      take_back(setting);
    }
  }
  BOOST_TEST(crossings > 300u);
  BOOST_TEST(vertices > 20u);
}

// The forms in which curves of this package are written.
template <class Form>
void check_written_curves(const Surface& mesh)
{
  Random_numbers random(5);
  const int n = static_cast<int>(mesh.number_of_vertices());
  std::size_t crossings = 0;
  for(int i = 0; i < 12; ++i) {
    std::vector<Form> curve;
    const auto path =
        FG::geodesic_path(mesh, vertex(random.below(n)), vertex(random.below(n)), std::back_inserter(curve));
    if(path.length() == 0)
      continue;
    const Certificate certificate = FG::certify_curve(mesh, curve);
    BOOST_TEST((certificate.verdict() == Verdict::PROVEN));
    BOOST_TEST(certificate.places.size() == curve.size());
    crossings += curve.size() - 2;
  }
  BOOST_TEST(crossings > 20u);
}

BOOST_AUTO_TEST_CASE(written_curves_are_certified_as_they_are)
{
  using Face_location = std::pair<Surface::Face_index, std::array<double, 3>>;
  for(const Mesh_soup& soup : {jittered_grid(14, 14, Diagonal_rule::RANDOM, 0.24, 5), bumpy_sphere(8, 0.3, 1)}) {
    const Surface mesh = to_mesh<Surface>(soup);
    check_written_curves<Face_location>(mesh);
    check_written_curves<FG::Curve_point<Surface, Surface::Point>>(mesh);
  }
}

// A proof that takes another way comes to the same verdict: of joints anywhere, in faces of a network's triangulation.
BOOST_AUTO_TEST_CASE(curves_that_were_not_pulled_tight_are_judged_as_in_a_network)
{
  int bent = 0, straight = 0;
  for(const Mesh_soup& soup : soups()) {
    Certified_setting setting(soup);
    Random_numbers random(4);
    for(int i = 0; i < 30; ++i) {
      flip_at_random(setting.triangulation, 100, random);
      const Halfedge_sequence walk = random_walk(setting.triangulation, 1 + random.below(3), false, random);
      std::set<FG::Vertex_index> vertices = {setting.triangulation.tail(walk.front())};
      for(const auto h : walk)
        vertices.insert(setting.triangulation.head(h));
      if(vertices.size() == walk.size() + 1) { // no strand is in the way of another
        setting.network.add_curve(walk);
        const auto judged = FG::certify(setting.network).curves[0];
        const Certificate certificate = checked_places(setting, places_of(setting, 0_c, random));
        BOOST_TEST((certificate.verdict() == judged.verdict()));
        ++(judged.is_locally_shortest() ? straight : bent);
      }
      take_back(setting);
    }
  }
  BOOST_TEST(bent > 40);
  BOOST_TEST(straight > 40);
}

BOOST_AUTO_TEST_CASE(ends_are_points_of_faces_and_edges)
{
  std::size_t inside = 0;
  for(const Mesh_soup& soup : {jittered_grid(9, 9, Diagonal_rule::RANDOM, 0.24, 5), bumpy_sphere(5, 0.3, 1), cube(4)}) {
    Certified_setting setting(soup);
    Random_numbers random(6);
    const auto location = [&] {
      FG::Input_halfedge_index h;
      do
        h = FG::Input_halfedge_index(random.below(setting.triangulation.input().number_of_halfedges()));
      while(setting.triangulation.input().is_border(h));
      return FG::Surface_location{
          h, {{random.uniform(0.1, 2), random.uniform(0.1, 2), random.below(3) == 0 ? 0 : random.uniform(0.1, 2)}}};
    };
    for(int i = 0; i < 15; ++i) {
      FG::add_curve_through(setting.network, std::vector<FG::Surface_location>{location(), location()});
      setting.pull();
      const Places places = places_of(setting, 0_c, random);
      BOOST_TEST((checked_places(setting, places).verdict() == Verdict::PROVEN));
      inside += places.size() == 2 ? 1 : 0;
      take_back(setting);
    }
  }
  BOOST_TEST(inside > 0u);
}

// In a grid of squares, which rising diagonals divide, the line between two points touches a vertex in between, or
// misses it by a unit in the last place of a weight.
BOOST_AUTO_TEST_CASE(ends_are_exactly_where_their_weights_say)
{
  const auto mesh = to_mesh<Surface>(flat_grid(2, 2, Diagonal_rule::RISING)); // (i, j) is vertex i + 3 j
  const auto at = [&](int a, int b, int c, const std::array<double, 3>& w) {
    Halfedge h = mesh.halfedge(vertex(a), vertex(b));
    BOOST_TEST_REQUIRE(mesh.target(mesh.next(h)) == vertex(c));
    std::array<double, 3> weights;
    for(int i = 0; i < 3; ++i, h = mesh.next(h)) {
      Halfedge g = mesh.halfedge(mesh.face(h));
      for(int k = 0; k < 3; ++k, g = mesh.next(g))
        if(mesh.source(g) == mesh.source(h))
          weights[k] = w[i];
    }
    return Place(std::make_pair(mesh.face(h), weights));
  };
  const double ulp = 0x1p-52;
  // From the centroid of (0, 0), (1, 0), (1, 1), turned about (1, 1), to that of (2, 2), (1, 2), (1, 1).
  for(double more : {-ulp, 0.0, ulp}) {
    const Place source = at(0, 1, 4, {1, 1 + more, 1}), target = at(8, 7, 4, {1, 1, 1});
    const Places left = {source, crossing(mesh.halfedge(vertex(0), vertex(4))),
                         crossing(mesh.halfedge(vertex(3), vertex(4))), crossing(mesh.halfedge(vertex(7), vertex(4))),
                         target};
    const Places right = {source, crossing(mesh.halfedge(vertex(1), vertex(4))),
                          crossing(mesh.halfedge(vertex(5), vertex(4))), crossing(mesh.halfedge(vertex(8), vertex(4))),
                          target};
    BOOST_TEST(certified(mesh, left).is_locally_shortest() == (more <= 0));
    BOOST_TEST(certified(mesh, right).is_locally_shortest() == (more >= 0));
  }
}

BOOST_AUTO_TEST_CASE(ends_on_one_edge_and_in_one_face)
{
  const auto mesh = hexagon();
  const Halfedge h = outgoing_halfedge(mesh, 1);
  BOOST_TEST(certified(mesh, {crossing(h, 0.25), crossing(mesh.opposite(h), 0.25)}).is_locally_shortest());
  BOOST_TEST(certified(mesh, {crossing(h, 0.75), place(0)}).is_locally_shortest());
  const Places round_a_corner = {crossing(h, 0.75), place(1), crossing(mesh.halfedge(vertex(1), vertex(2)))};
  BOOST_TEST((certified(mesh, round_a_corner).verdict() == Verdict::BENT_JOINT));
  BOOST_TEST(
      certified(mesh, {crossing(h), crossing(outgoing_halfedge(mesh, 2))}).is_locally_shortest()); // over their face
  BOOST_TEST(certified(mesh, {crossing(h), place(2)}).is_locally_shortest());
  BOOST_TEST(certified(mesh, {place(1), place(2)}).is_locally_shortest());
  BOOST_TEST(
      certified(mesh, {crossing(h, 1), crossing(outgoing_halfedge(mesh, 2), 1)}).is_locally_shortest()); // vertices
  for(std::size_t i = 0; i < 3; ++i) {
    std::array<double, 3> weights = {1, 1, 1};
    const Place center = std::make_pair(mesh.face(h), weights);
    weights[i] = 2;
    BOOST_TEST(certified(mesh, {center, std::make_pair(mesh.face(h), weights)}).is_locally_shortest());
  }
  const auto bent = certified(mesh, {crossing(h), place(0), crossing(outgoing_halfedge(mesh, 2))});
  check_bend(bent, Verdict::BENT_JOINT, 2 * pi / 3, 0, 1, FG::Side::RIGHT);
}

// Six triangles about vertex 0: the chord over one rim vertex is straight, those round the other side are not.
BOOST_AUTO_TEST_CASE(the_bend_of_a_segment_is_told)
{
  const auto mesh = hexagon();
  const auto chord = certified(mesh, {place(1), crossing(outgoing_halfedge(mesh, 2)), place(3)});
  BOOST_TEST(chord.is_locally_shortest());
  BOOST_TEST(chord.places.size() == 3u);
  BOOST_TEST(std::abs(chord.places[1] - 0.5) < 1e-12); // hexagons have it so
  Places round = {place(1), crossing(mesh.opposite(outgoing_halfedge(mesh, 2))), crossing(outgoing_halfedge(mesh, 3)),
                  crossing(outgoing_halfedge(mesh, 4)), place(5)};
  check_bend(certified(mesh, round), Verdict::BENT_SEGMENT, pi / 3, 0, 1, FG::Side::LEFT);
  Places with_joint = round; // only joints next to segments that are clearly bent are not examined
  with_joint.insert(with_joint.end(), {place(4), place(5)});
  check_bend(certified(mesh, with_joint), Verdict::BENT_JOINT, pi, 4, 5, FG::Side::LEFT);
  with_joint.pop_back();
  check_bend(certified(mesh, with_joint), Verdict::BENT_SEGMENT, pi / 3, 0, 1, FG::Side::LEFT);
  round.back() = crossing(outgoing_halfedge(mesh, 5));
  round.push_back(place(6));
  check_bend(certified(mesh, round), Verdict::BENT_SEGMENT, 2 * pi / 3, 0, 1, FG::Side::LEFT);
  std::reverse(round.begin(), round.end());
  check_bend(certified(mesh, round), Verdict::BENT_SEGMENT, 2 * pi / 3, 0, 1, FG::Side::RIGHT);
  // Of two bends the larger one is told: in a grid, round (2, 2) by a right angle, and round (1, 2) by half of it.
  const auto grid = to_mesh<Surface>(flat_grid(4, 4, Diagonal_rule::RISING)); // (i, j) is vertex i + 5 j
  const auto across = [&](int i, int j) { return crossing(grid.halfedge(vertex(i), vertex(j))); };
  Places winding = {place(7),      across(12, 13), across(12, 18), across(12, 17), across(12, 11),
                    across(11, 6), across(11, 5),  across(11, 10), across(10, 16)};
  check_bend(certified(grid, winding), Verdict::BENT_SEGMENT, pi / 2, 12, 1, FG::Side::LEFT);
  std::reverse(winding.begin(), winding.end());
  check_bend(certified(grid, winding), Verdict::BENT_SEGMENT, pi / 2, 12, 4, FG::Side::RIGHT);
}

BOOST_AUTO_TEST_CASE(the_bend_of_a_joint_is_told)
{
  const auto grid = to_mesh<Surface>(flat_grid(3, 3, Diagonal_rule::RISING)); // (i, j) is vertex i + 4 j
  BOOST_TEST(certified(grid, {place(4), place(5), place(6), place(7)}).is_locally_shortest());
  BOOST_TEST(certified(grid, {place(0), place(1), place(2)}).is_locally_shortest()); // on the border
  check_bend(certified(grid, {place(4), place(5), place(9)}), Verdict::BENT_JOINT, pi / 2, 5, 1, FG::Side::LEFT);
  check_bend(certified(grid, {place(9), place(5), place(4)}), Verdict::BENT_JOINT, pi / 2, 5, 1, FG::Side::RIGHT);
  check_bend(certified(grid, {place(4), place(5), place(4)}), Verdict::BENT_JOINT, pi, 5, 1, FG::Side::LEFT);
  check_bend(certified(grid, {place(2), place(3), place(7)}), Verdict::BENT_JOINT, pi / 2, 3, 1, FG::Side::LEFT);
  check_bend(certified(grid, {place(4), place(5), place(10), place(6)}), Verdict::BENT_JOINT, 3 * pi / 4, 10, 2,
             FG::Side::RIGHT);
  // Both directions in one face, from (0, 0) to (2, 1) and (3, 1).
  const Places first = {place(6), crossing(grid.halfedge(vertex(1), vertex(5))), place(0)};
  const Places second = {place(0), crossing(grid.halfedge(vertex(1), vertex(5))),
                         crossing(grid.halfedge(vertex(1), vertex(6))), crossing(grid.halfedge(vertex(2), vertex(6))),
                         place(7)};
  Places both = first;
  both.insert(both.end(), second.begin() + 1, second.end());
  const double angle = std::atan2(1, 2) - std::atan2(1, 3);
  check_bend(certified(grid, both), Verdict::BENT_JOINT, pi - angle, 0, 2, FG::Side::LEFT);
  std::reverse(both.begin(), both.end());
  check_bend(certified(grid, both), Verdict::BENT_JOINT, pi - angle, 0, 4, FG::Side::RIGHT);
}

// A segment that is bent by no more than rounding errors does not hide that the curve turns at its end.
BOOST_AUTO_TEST_CASE(joints_next_to_nearly_straight_segments_are_examined)
{
  for(double offset : {1e-12, 1e-3}) {
    const auto mesh = to_mesh<Surface>(Mesh_soup{{{0, 0, 0}, {1, 0.5 + offset, 0}, {2, 1, 0}, {1, 2, 0}, {1, -2, 0}},
                                                 {{0, 1, 3}, {1, 2, 3}, {0, 4, 1}, {4, 2, 1}}});
    const auto past_1 = crossing(mesh.halfedge(vertex(1), vertex(3)));
    const auto alone = certified(mesh, {place(0), past_1, place(2)});
    BOOST_TEST((alone.verdict() == Verdict::BENT_SEGMENT));
    BOOST_TEST(std::abs(alone.bend - 2 * 0.8 * offset) < 2 * offset * offset + 1e-15);
    const auto with_joint = certified(mesh, {place(0), past_1, place(2), place(3)});
    if(offset < 1e-8)
      check_bend(with_joint, Verdict::BENT_JOINT, 3 * pi / 4 - std::atan(0.5), 2, 2, FG::Side::LEFT);
    else
      BOOST_TEST(with_joint.bend == alone.bend);
  }
}

BOOST_AUTO_TEST_CASE(closed_curves_have_a_joint_at_their_start)
{
  const auto ring = to_mesh<Surface>(cylinder(6, 3, 1, 3)); // vertex i + 6 j
  Places around;
  for(int i = 0; i < 6; ++i)
    around.push_back(place(6 + i));
  const bool is_exact = certified(ring, around, true).is_locally_shortest();
  BOOST_TEST((is_exact || certified(ring, around, true).bend < 1e-15)); // by the rounding of coordinates
  const auto mesh = hexagon();
  const auto bent = certified(mesh, {place(0), place(1), place(2)}, true);
  check_bend(bent, Verdict::BENT_JOINT, 2 * pi / 3, 0, 0, FG::Side::LEFT);
  const auto loop = certified(mesh,
                              {place(1), crossing(outgoing_halfedge(mesh, 2)), place(3),
                               crossing(outgoing_halfedge(mesh, 4)), place(5), crossing(outgoing_halfedge(mesh, 6))},
                              true);
  BOOST_TEST((loop.verdict() == Verdict::BENT_JOINT));
  BOOST_TEST(std::abs(loop.bend - 2 * pi / 3) < 1e-12);
}

// Lengths can make a cone of a point on the line.
BOOST_AUTO_TEST_CASE(a_touched_vertex_is_told)
{
  const auto certified_by_lengths = [](const Surface& mesh, const Places& places, const auto& lengths) {
    const FG::Edge_length_metric metric(mesh, boost::make_assoc_property_map(lengths));
    return FG::certify_curve(mesh, places, CGAL::parameters::metric(metric));
  };
  // 2 is on the edge from 0 to 1, and sees 4, on the other side, at less than a right angle from both.
  const auto flat_face = to_mesh<Surface>(Mesh_soup{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, 1, 0}},
                                                    {{0, 3, 1}, {0, 1, 2}, {0, 2, 4}, {2, 1, 4}}});
  const auto lengths = edge_lengths(flat_face, [=](int u, int v) {
    const std::pair<int, int> ends = std::minmax(u, v);
    return ends == std::pair<int, int>(0, 1) ? 2.0 : (ends.first == 2 || ends.second == 2 ? 1.0 : 1.4);
  });
  check_bend(certified_by_lengths(flat_face, {place(0), place(1)}, lengths), Verdict::BENT_SEGMENT,
             pi - 4 * std::asin(0.7), 2, 0, FG::Side::RIGHT);

  // The line from 0 to 1 crosses the edge from 2 to 3 at 2, where it sees 4 so.
  const auto kite = to_mesh<Surface>(Mesh_soup{{{-3, 0, 0}, {3, 0, 0}, {0, 0, 0}, {0, -4, 0}, {0, 4, 0}},
                                               {{0, 3, 2}, {2, 3, 1}, {0, 2, 4}, {2, 1, 4}}});
  const auto kite_lengths = edge_lengths(kite, [=](int u, int v) {
    if(u == 2 || v == 2)
      return u + v == 2 || u + v == 3 ? 3.0 : 4.0;
    return (std::max)(u, v) == 4 ? 4.5 : 5.0;
  });
  const Place at_2 = crossing(kite.halfedge(vertex(3), vertex(2)));
  check_bend(certified_by_lengths(kite, {place(0), at_2, place(1)}, kite_lengths), Verdict::BENT_SEGMENT,
             pi - 2 * std::acos(4.75 / 24), 2, 1, FG::Side::LEFT);
}

BOOST_AUTO_TEST_CASE(what_is_no_curve_is_refused)
{
  const auto mesh = hexagon();
  const Halfedge rim = mesh.halfedge(vertex(2), vertex(3));
  const Place on_2 = crossing(outgoing_halfedge(mesh, 2)), on_3 = crossing(outgoing_halfedge(mesh, 3)),
              on_4 = crossing(outgoing_halfedge(mesh, 4));
  const auto in_face = [&](double a) {
    return Place(std::make_pair(mesh.face(outgoing_halfedge(mesh, 1)), std::array<double, 3>{{a, 1, 1}}));
  };
  using Curve_error = FG::Invalid_curve_error;
  check_refused<Curve_error>(mesh, {place(1), crossing(rim), place(3)}, {1}); // on the border
  check_refused<Curve_error>(mesh, {place(1), on_3, place(3)}, {1});          // not opposite
  check_refused<Curve_error>(mesh, {place(1), crossing(mesh.opposite(rim)), place(3)}, {1});
  check_refused<Curve_error>(mesh, {place(2), on_2, place(3)}, {1}); // an edge of the vertex itself
  check_refused<Curve_error>(mesh, {place(0), on_2, place(3)}, {1});
  for(int i : {5, 6}) // not in one face, but along the border
    check_refused<Curve_error>(mesh, {crossing(mesh.halfedge(vertex(1), vertex(2))), place(i)}, {1});
  check_refused<Curve_error>(mesh, {place(1), on_2, on_4, place(3)}, {2});               // a face is left out
  check_refused<Curve_error>(mesh, {place(1), on_2, crossing({}), place(5)}, {2});       // null
  check_refused<Curve_error>(mesh, {place(1), crossing(Halfedge(1000)), place(3)}, {1}); // none of the mesh's
  check_refused<Curve_error>(mesh, {crossing(Halfedge(1000)), place(3)}, {0});
  check_refused<Curve_error>(mesh, {place(1), on_2, on_3, place(5)}, {3}); // ends elsewhere
  check_refused<Curve_error>(mesh, {place(1), place(4)}, {1});             // no edge
  check_refused<Curve_error>(mesh, {place(2), place(2)}, {1});             // a point
  check_refused<Curve_error>(mesh, {in_face(1), in_face(1)}, {1});
  check_refused<Curve_error>(mesh, {on_2, on_2}, {1});
  check_refused<Curve_error>(mesh, {place(1), in_face(1), place(2)}, {1}); // inside a face in between
  check_refused<Curve_error>(mesh, {place(1)}, {});
  check_refused<Curve_error>(mesh, {}, {}, true);
  check_refused<Curve_error>(mesh, {on_2, place(1)}, {0}, true); // closed, and starts elsewhere
  check_bend(certified(mesh, {place(1), place(0)}, true), Verdict::BENT_JOINT, pi, 1, 0,
             FG::Side::LEFT); // there and back
  check_refused<FG::Vertex_out_of_range_error>(mesh, {place(1), on_2, place(1000)}, {2});
  for(double weight : {-1e-17, std::nan(""), 1e-120})
    BOOST_CHECK_THROW(certified(mesh, {in_face(weight), place(0)}), FG::Invalid_location_error);
  for(double t : {-1e-17, 1.5, std::nan("")})
    BOOST_CHECK_THROW(certified(mesh, {crossing(outgoing_halfedge(mesh, 1), t), place(2)}), FG::Invalid_location_error);
  const Place no_face = std::make_pair(Surface::Face_index(), std::array<double, 3>{{1, 1, 1}});
  BOOST_CHECK_THROW(certified(mesh, {no_face, place(0)}), FG::Invalid_location_error);
}
