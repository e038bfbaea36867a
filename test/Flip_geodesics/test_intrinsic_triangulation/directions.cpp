// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Directions at vertices, inserted ones too, and strips of faces.

#include "test_intrinsic_triangulation/inserted_vertices.h"

#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/reports.h>

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(directions_at_vertices_are_those_in_the_plane)
{
  const double tolerance = 1e-9;
  Random_numbers random(12);
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(3, 3, Diagonal_rule::RANDOM, 0.2, 1));
  for(int i = 0; i < 5 * scale; ++i) {
    Triangulation t(mesh);
    insert_at_random(t, 8, random);
    flip_at_random(t, 30, random);
    const auto vector = [&](FG::Halfedge_index h) { return place(mesh, t, t.head(h)) - place(mesh, t, t.tail(h)); };
    for(FG::Vertex_index v : descriptors<FG::Vertex_index>(t.number_of_vertices())) {
      const FG::internal::Vertex_directions<Triangulation> directions(t, v);
      const Halfedge_sequence outgoing_halfedges = outgoing_halfedges_at_tail(t, t.outgoing(v));
      const bool is_border = std::any_of(outgoing_halfedges.begin(), outgoing_halfedges.end(),
                                         [&](FG::Halfedge_index h) { return t.is_border(h); });
      BOOST_TEST(directions.has_border() == is_border);
      if(!is_border)
        BOOST_TEST(std::abs(directions.total() - 2 * pi) < tolerance);
      if(t.is_inserted(v) && is_border)
        BOOST_TEST(std::abs(directions.total() - pi) < tolerance);
      for(FG::Halfedge_index g : outgoing_halfedges) {
        BOOST_TEST((directions(g) > -tolerance && directions(g) < directions.total() + tolerance));
        for(FG::Halfedge_index h : outgoing_halfedges) {
          if(g == h)
            continue;
          const double angle = planar_angle(vector(g), vector(h));
          const double found = directions.counterclockwise(directions(g), directions(h));
          const bool is_inner = is_inner_turn(t, g, h);
          BOOST_TEST((is_inner ? std::abs(found - angle) < tolerance : std::isinf(found)));
        }
      }
    }
  }
}

// Clockwise and counterclockwise, by halfedges and by angles, with and without a border.
BOOST_AUTO_TEST_CASE(fans_lead_from_angles_to_directions_and_back)
{
  const double tolerance = 1e-12;
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(3, 3, Diagonal_rule::RANDOM, 0.2, 1));
  const Triangulation t(mesh);
  const auto& input = t.input();
  for(FG::Input_halfedge_index start : descriptors<FG::Input_halfedge_index>(t.number_of_halfedges())) {
    const FG::internal::Vertex_fan fan = FG::internal::umbrella_of(t, start);
    const auto& around = fan.halfedges();
    const auto faces = static_cast<FG::Index>(around.size()) - (fan.has_border() ? 1 : 0);
    BOOST_TEST(fan.has(start));
    BOOST_TEST(fan.has_border() == (FG::internal::border_of_umbrella(input, start) != FG::null_index));
    BOOST_TEST((fan.has_border() || around.front().halfedge == start));
    double sum = 0;
    for(FG::Index i = 0; i < static_cast<FG::Index>(around.size()); ++i) {
      const auto& [h, angle, corner] = around[static_cast<std::size_t>(i)];
      BOOST_TEST((input.tail(h) == input.tail(start)));
      BOOST_TEST(std::abs(angle - sum) < tolerance);
      BOOST_TEST(fan.angle_of(h, input.tail(h)) == angle);
      BOOST_TEST(std::abs(FG::internal::sum_of_input_corners(t, h, i).value() - angle) < tolerance);
      const FG::Index all_round = fan.has_border() ? -1 : faces;
      const auto corners = [&](const auto& from, const auto& to) {
        return FG::internal::number_of_corners_clockwise(input, from, to);
      };
      BOOST_TEST(corners(h, around.front().halfedge) == (i == 0 ? all_round : i));
      BOOST_TEST(corners(around.front().halfedge, h) == (fan.has_border() ? -1 : faces - i));
      sum += corner;
      if(input.is_border(h))
        continue;
      const auto turn = fan.turn_at(angle + corner / 4);
      BOOST_TEST((turn.halfedge == h));
      BOOST_TEST(std::abs(turn.angle - corner / 4) < tolerance);
      BOOST_TEST(turn.corner == corner);
    }
    BOOST_TEST(std::abs(fan.total() - sum) < tolerance);
    BOOST_TEST((fan.turn_at(-tolerance).halfedge == around.front().halfedge));
    const auto last = fan.turn_at(sum + tolerance);
    BOOST_TEST((last.halfedge == around[static_cast<std::size_t>(faces - 1)].halfedge));
    BOOST_TEST(last.angle > last.corner);
    BOOST_CHECK_THROW(fan.angle_of(FG::internal::twin_index(start), input.tail(start)), FG::Invalid_mesh_error);
  }
}

namespace {

// The angle at the head of h in the two faces of its edge.
double angle_at_head(const Triangulation& t, FG::Halfedge_index h)
{
  const auto corner = [&](FG::Halfedge_index in) {
    const auto a = t.geometry(in), b = t.geometry(t.next(in));
    return std::atan2(a.x * b.y - a.y * b.x, -(a.x * b.x + a.y * b.y));
  };
  return corner(h) + corner(t.previous(t.twin(h)));
}

// Flips an edge whose quad may be reflex by so much.
bool flip_if_nearly_convex(Triangulation& t, FG::Halfedge_index h, double angle)
{
  const FG::Halfedge_index twin = t.twin(h);
  if(t.is_border(h) || t.is_border(twin) || t.next(h) == twin || t.next(twin) == h ||
     angle_at_head(t, h) > pi + angle || angle_at_head(t, twin) > pi + angle)
    return false;
  t.flip(h);
  return true;
}

} // namespace

// Points on one line inside a face, in a direction whose angle is pi or -pi as rounding will have it; and flips that
// are wrong by little, so that edges follow on one another in the wrong order.
BOOST_AUTO_TEST_CASE(angles_about_points_inside_a_face_sum_up_to_a_full_turn)
{
  Random_numbers random(13);
  const Mesh mesh = to_mesh<Mesh>(single_triangle());
  const auto side = mesh.halfedge(*mesh.faces_begin());
  // Angles are told from it.
  const FG::Input_halfedge_index h(static_cast<FG::Index>((std::min)({side, mesh.next(side), mesh.prev(side)})));
  int opposite = 0;
  const auto check = [&](const Triangulation& t) {
    for(FG::Vertex_index v = 3_v; v.idx() < t.number_of_vertices(); ++v)
      for(FG::Halfedge_index g : outgoing_halfedges_at_tail(t, t.outgoing(v))) {
        BOOST_TEST(std::abs(FG::internal::wedge_angle(t, g, g).value - 2 * pi) < 1e-9);
        const FG::internal::Strip<Triangulation> strip(t, t.edge_sequence(g));
        opposite += std::abs(std::arg(strip.end())) > pi - 1e-15 ? 1 : 0;
      }
  };
  for(int i = 0; i < 50 * scale; ++i) {
    Triangulation t(mesh);
    const double row = random.uniform(0.1, 0.6);
    for(int k = 0; k < 5; ++k) {
      const double along = random.uniform(0.01, 0.99) * (1 - row);
      t.insert({h, {{along, 1 - row - along, row * (i % 2 == 0 ? 1 : random.uniform(0.99, 1.01))}}});
      flip_at_random(t, 10, random);
      check(t);
    }
    for(int k = 0; k < 100; ++k) {
      const auto position = t.log_position();
      if(flip_if_nearly_convex(t, FG::Halfedge_index(random.below(t.number_of_halfedges())), 0.3))
        check(t);
      t.rollback(position);
      flip_at_random(t, 1, random);
    }
  }
  BOOST_TEST(opposite > 50);
}

// A word that comes back to where it starts is all error; no direction follows from it.
BOOST_AUTO_TEST_CASE(strips_without_length_have_no_relative_error)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(4, 4, Diagonal_rule::RANDOM, 0.2, 5));
  const Triangulation t(mesh);
  const auto& input = t.input();
  int closed = 0;
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
    const Halfedge_sequence outgoing_halfedges = outgoing_halfedges_at_tail(t, h);
    const auto is_at_border = [&](FG::Halfedge_index g) { return t.is_border(g) || t.is_border(t.twin(g)); };
    if(std::any_of(outgoing_halfedges.begin(), outgoing_halfedges.end(), is_at_border))
      continue;
    FG::Edge_sequence word; // from the head of h about its tail, counterclockwise, to the head of h
    word.tail = word.head = t.head(h);
    for(FG::Halfedge_index g = t.counterclockwise(h); g != h; g = t.counterclockwise(g)) {
      const FG::Input_halfedge_index crossed = FG::internal::as_input(g);
      word.crossed.push_back(FG::internal::twin_index(crossed));
      BOOST_REQUIRE(input.tail(crossed) == t.tail(h));
    }
    const FG::internal::Strip<Triangulation> strip(t, word);
    BOOST_TEST(strip.length() <= strip.end_error());
    BOOST_TEST(strip.end_error() < 1e-12);
    BOOST_TEST(std::isinf(strip.relative_error()));
    ++closed;
  }
  BOOST_TEST(closed > 20);
}

// A power of two changes neither flips nor relative errors, be the ends of a strip vertices of the input or inserted
// ones.
BOOST_AUTO_TEST_CASE(relative_errors_do_not_depend_on_the_size_of_the_mesh)
{
  std::vector<std::vector<double>> errors;
  for(const double size : {1., 0x1p40, 0x1p-40}) {
    Random_numbers random(17);
    const Mesh mesh =
        to_mesh<Mesh>(mapped(jittered_grid(4, 4, Diagonal_rule::RANDOM, 0.2, 7), [=](const Coordinates& p) {
          return Coordinates{p[0] * size, p[1] * size, p[2] * size};
        }));
    Triangulation t(mesh);
    insert_at_random(t, 8, random);
    flip_at_random(t, 60, random);
    errors.emplace_back();
    for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges()))
      if(const FG::Edge_sequence word = t.edge_sequence(h); !word.crossed.empty())
        errors.back().push_back(FG::internal::Strip<Triangulation>(t, word).relative_error());
  }
  BOOST_TEST(errors[0].size() > 20u);
  BOOST_TEST(errors[1] == errors[0], boost::test_tools::per_element());
  BOOST_TEST(errors[2] == errors[0], boost::test_tools::per_element());
}

// From each halfedge of a vertex the border halfedge of its umbrella is found.
BOOST_AUTO_TEST_CASE(umbrellas_end_at_the_border)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(3, 3, Diagonal_rule::RISING));
  const Triangulation t(mesh);
  const auto& input = t.input();
  std::map<FG::Vertex_index, FG::Input_halfedge_index> borders;
  for(FG::Input_halfedge_index h : descriptors<FG::Input_halfedge_index>(input.number_of_halfedges()))
    if(input.is_border(h))
      borders[input.tail(h)] = h;
  BOOST_TEST(borders.size() == 12u);
  for(FG::Input_halfedge_index h : descriptors<FG::Input_halfedge_index>(input.number_of_halfedges())) {
    const auto border = borders.find(input.tail(h));
    const FG::Input_halfedge_index found = FG::internal::border_of_umbrella(input, h);
    BOOST_TEST((found == (border == borders.end() ? FG::Input_halfedge_index(FG::null_index) : border->second)));
    if(border != borders.end())
      BOOST_TEST((FG::internal::next_umbrella(input, found) == found)); // there is one only
  }
}

// Each split of an edge is recorded, with the words of the edges that end at the point, three at least.
BOOST_AUTO_TEST_CASE(the_memory_of_words_of_split_edges_is_counted)
{
  Random_numbers random(20);
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(4, 4, Diagonal_rule::RANDOM, 0.2, 10));
  Triangulation t(mesh);
  const std::size_t before = t.memory_of_records(), splits = 8;
  for(std::size_t i = 0; i < splits; ++i)
    t.insert({FG::Input_halfedge_index(random.below(t.input().number_of_halfedges())), {{1, random.uniform(1, 3), 0}}});
  const std::size_t log = t.log_position() * sizeof(t.flip_record(0)), points = splits * sizeof(FG::Surface_location);
  BOOST_TEST(t.memory_of_records() >= before + log + points + 3 * splits * sizeof(FG::Edge_sequence));
  t.rollback();
  BOOST_TEST(t.memory_of_records() <= before + log + points);
}

// Centers of the faces that an edge passes, on either side of it.
BOOST_AUTO_TEST_CASE(points_lie_beside_edges_as_in_the_plane)
{
  Random_numbers random(18);
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(4, 4, Diagonal_rule::RANDOM, 0.2, 8));
  Triangulation t(mesh);
  insert_at_random(t, 6, random);
  flip_at_random(t, 60, random);
  FG::Decision_statistics statistics;
  const FG::internal::Point_side<Triangulation> side(t, statistics);
  const auto in_plane = [&](FG::Input_halfedge_index h) {
    const Point p = mesh.point(t.vertex(t.input().tail(h)));
    return std::complex<double>(p.x(), p.y());
  };
  std::array<int, 2> points = {{0, 0}}; // on the left, and on the right
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
    const FG::Edge_sequence word = t.edge_sequence(h);
    if(word.crossed.empty())
      continue;
    const std::complex<double> from = place(mesh, t, t.tail(h)), along = place(mesh, t, t.head(h)) - from;
    for(std::size_t gap = 0; gap <= word.crossed.size(); ++gap) {
      const FG::Input_halfedge_index a = FG::internal::face_of_gap(word, gap), b = t.input().next(a),
                                     c = t.input().next(b);
      const FG::Surface_location center = {a, {{1, 2, 5}}};
      const std::complex<double> p = (in_plane(a) + 2. * in_plane(b) + 5. * in_plane(c)) / 8.;
      const double expected = std::imag(std::conj(along) * (p - from)) / std::abs(along);
      BOOST_TEST(std::abs(side.distance(word, gap, center) - expected) < 1e-12);
      if(std::abs(expected) < 1e-9)
        continue;
      BOOST_TEST(side(word, gap, center) == (expected > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE));
      ++points[expected > 0 ? 0 : 1];
    }
  }
  BOOST_TEST(points[0] > 20);
  BOOST_TEST(points[1] > 20);
}

namespace {

using Layout_in_double = FG::internal::Layout_in_double<Triangulation>;
using Precise_layout = FG::internal::Layout_in_double_double<Triangulation>;

std::complex<double> position(const Layout_in_double::Corner& corner) { return corner.position; }
std::complex<double> position(const Precise_layout::Corner& corner)
{
  return {corner.position.x.high, corner.position.y.high};
}

// The face of h, with the tail of h at the origin and h along the real axis.
FG::internal::Face_strip<Layout_in_double> first_face(const Layout_in_double& layout, FG::Input_halfedge_index h,
                                                      double length)
{
  const auto sides = layout.sides(h, length);
  return {layout, h, sides, layout.corners(sides, {{1, 0, 0}})};
}

FG::internal::Face_strip<Precise_layout> first_face(const Precise_layout& layout, FG::Input_halfedge_index h, double)
{
  const auto sides = layout.sides(h, {{{1, 0}, {}}, 0, {}, 0});
  const Precise_layout::Corner tail = {{}, 0}, head = layout.step(tail, sides[0]);
  return {layout, h, sides, {tail, head, layout.step(head, sides[1])}};
}

// Leaves faces over sides that are chosen at random, over the first one only in the first face; then crosses the same
// edges in one go.
template <class Layout>
void check_unfolding(const Mesh& mesh, const Triangulation& t, FG::Input_halfedge_index start, Random_numbers& random)
{
  const double rounding = 1e-14; // of places in the plane
  const auto& input = t.input();
  const std::complex<double> origin = place(mesh, t, input.tail(start)),
                             along = place(mesh, t, input.tail(FG::internal::twin_index(start))) - origin,
                             unit = along / std::abs(along);
  auto faces = first_face(Layout(t), start, t.metric().length(input, start));
  auto again = faces;
  std::vector<FG::Input_halfedge_index> crossed;
  for(std::size_t number = 0; number < 40; ++number) {
    for(int i = 0; i < 3; ++i) {
      const auto& corner = faces.corners()[i];
      const FG::Input_halfedge_index side = faces.side(i);
      const std::complex<double> expected = (place(mesh, t, input.tail(side)) - origin) * std::conj(unit);
      BOOST_TEST(faces.number_of(side) == i);
      BOOST_TEST(std::abs(position(corner) - expected) <= corner.error + rounding);
      BOOST_TEST(corner.error < 1e-10);
    }
    const int side = number == 0 ? random.below(3) : 1 + random.below(2);
    const FG::Input_halfedge_index entered = FG::internal::twin_index(faces.side(side));
    if(input.is_border(entered))
      break;
    crossed.push_back(faces.side(side));
    faces.leave_over(side);
    faces.enter(entered);
    BOOST_TEST((faces.halfedge() == entered));
  }
  if(crossed.empty())
    return;
  again.leave_over(again.number_of(crossed.front()));
  std::size_t portals = 0;
  again.cross(crossed,
              [&](FG::Input_halfedge_index h, const auto&, const auto&) { BOOST_TEST((h == crossed[portals++])); });
  BOOST_TEST(portals == crossed.size());
  BOOST_TEST((again.halfedge() == FG::internal::twin_index(crossed.back())));
  for(int i = 0; i < 3; ++i) {
    BOOST_TEST((position(again.corners()[i]) == position(faces.corners()[i])));
    BOOST_TEST(again.corners()[i].error == faces.corners()[i].error);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(faces_are_unfolded_as_they_lie_in_the_plane)
{
  Random_numbers random(21);
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 11));
  const Triangulation t(mesh);
  for(FG::Input_halfedge_index h : descriptors<FG::Input_halfedge_index>(t.number_of_halfedges()))
    if(!t.input().is_border(h)) {
      check_unfolding<Layout_in_double>(mesh, t, h, random);
      check_unfolding<Precise_layout>(mesh, t, h, random);
    }
}

// A word is that of an edge only if it leads from its tail to its head.
BOOST_AUTO_TEST_CASE(words_of_other_edges_are_no_strips)
{
  Random_numbers random(19);
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(4, 4, Diagonal_rule::RANDOM, 0.2, 9));
  Triangulation t(mesh);
  flip_at_random(t, 60, random);
  const FG::internal::Edge_straightness<Triangulation> straight(t);
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
    const FG::Edge_sequence word = t.edge_sequence(h);
    BOOST_TEST(straight.is_strip(h, word));
    for(FG::Halfedge_index g : outgoing_halfedges_at_tail(t, h)) {
      BOOST_TEST(straight.is_strip(g, word) == (t.head(g) == t.head(h)));
      BOOST_TEST(!straight.is_strip(t.twin(g), word)); // a grid has no loops
    }
  }
}

// Also where flips were wrong, and the straight line is not in the strip.
BOOST_AUTO_TEST_CASE(crossings_lie_on_the_edges_that_cross)
{
  Random_numbers random(16);
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(4, 4, Diagonal_rule::RANDOM, 0.2, 6));
  int bent = 0;
  for(int i = 0; i < 20 * scale; ++i) {
    Triangulation t(mesh);
    for(int k = 0; k < 40; ++k)
      flip_if_nearly_convex(t, FG::Halfedge_index(random.below(t.number_of_halfedges())), 2);
    for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
      const FG::internal::Strip<Triangulation> strip(t, t.edge_sequence(h));
      bent += strip.bend() > 0.1 ? 1 : 0;
      for(std::size_t portal = 0; portal < strip.portals().size(); ++portal)
        for(double position : {strip.crossing(portal), strip.crossing_along(portal)})
          BOOST_TEST((position >= 0 && position <= 1));
    }
  }
  BOOST_TEST(bent > 100);
}

// From the side without a face as from the other one.
BOOST_AUTO_TEST_CASE(edges_on_the_border_are_split)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(2, 2, Diagonal_rule::RISING));
  int split = 0;
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(static_cast<int>(mesh.number_of_halfedges()))) {
    Triangulation t(mesh);
    if(!t.is_border(h) && !t.is_border(t.twin(h)))
      continue;
    const std::complex<double> a = place(mesh, t, t.tail(h)), b = place(mesh, t, t.head(h));
    const FG::Surface_location at = {FG::internal::as_input(h), {{0.75, 0.25, 0}}};
    const FG::Vertex_index v = t.split_edge(h, at, 0, [](const auto&) {});
    BOOST_TEST(t.is_inserted(v));
    BOOST_TEST(std::abs(place(mesh, t, v) - (0.75 * a + 0.25 * b)) < 1e-15);
    BOOST_TEST(t.is_valid());
    BOOST_TEST(outgoing_halfedges_at_tail(t, t.outgoing(v)).size() == 3u);
    ++split;
  }
  BOOST_TEST(split == 16);
}
