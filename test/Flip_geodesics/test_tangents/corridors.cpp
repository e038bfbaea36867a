// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Ways from place to place pulled tight, and the faces that they go through then: segments in the plane, taut strings
// round a hole, and past the tip of a cone on the shorter side.

#include "surfaces.h"

#include <CGAL/Flip_geodesics/internal/tangents/Transport_sleeve.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace tangents_test;

namespace {

using Transport_sleeve = FG::internal::Transport_sleeve<Triangulation>;
using Way = std::vector<FG::Surface_location>;

double cross(const std::complex<double>& a, const std::complex<double>& b)
{
  return a.real() * b.imag() - a.imag() * b.real();
}

// The sides that the segment between two places of a plane mesh crosses, in order, each as a side of the face before.
std::vector<FG::Input_halfedge_index> crossed_sides(const Triangulation& t, const FG::Surface_location& from,
                                                    const FG::Surface_location& to)
{
  const std::complex<double> start = in_plane(t, from), whole = in_plane(t, to) - start;
  std::vector<std::pair<double, FG::Input_halfedge_index>> crossed;
  for(FG::Input_halfedge_index h : FG::internal::descriptors<FG::Input_halfedge_index>(t.input().number_of_halfedges()))
  {
    const auto right = in_plane(t, {h, {{1, 0, 0}}}) - start, left = in_plane(t, {h, {{0, 1, 0}}}) - start;
    const double part = cross(right, left - right) / cross(whole, left - right), near = 1e-9;
    if(cross(right, whole) > near && cross(whole, left) > near && part > near && part < 1 - near)
      crossed.emplace_back(part, h);
  }
  std::sort(crossed.begin(), crossed.end());
  std::vector<FG::Input_halfedge_index> result;
  for(const auto& [part, h] : crossed)
    result.push_back(h);
  return result;
}

class Way_beside_segment
{
public:
  Way_beside_segment(const Triangulation& t, std::mt19937& random)
    : m_triangulation(t)
    , m_random(random)
  {
  }

  // Across the same sides, elsewhere; to and fro over some; by ends of others; and it turns about ends that are
  // vertices.
  Way operator()(const FG::Surface_location& from, const FG::Surface_location& to,
                 const std::vector<FG::Input_halfedge_index>& crossed)
  {
    m_way = {from};
    if(kind(from) == FG::Location_kind::VERTEX)
      turn_about(from, crossed.front(), true);
    for(const FG::Input_halfedge_index h : crossed) {
      const auto choice = m_random() % 6;
      if(choice == 0)
        go_to_vertex(m_random() % 2 == 0 ? h : FG::internal::twin_index(h));
      else
        m_way.push_back(on(h));
      if(choice == 1) {
        m_way.push_back({FG::internal::twin_index(h), {{1, 1, 1}}});
        m_way.push_back(on(h));
        m_way.push_back({h, {{1, 1, 1}}});
        m_way.push_back(on(h));
      }
    }
    if(kind(to) == FG::Location_kind::VERTEX)
      turn_about(to, FG::internal::twin_index(crossed.back()), false);
    m_way.push_back(to);
    return m_way;
  }

private:
  const auto& input() const { return m_triangulation.input(); }
  double number() { return std::uniform_real_distribution<double>(0.05, 1)(m_random); }
  FG::Surface_location on(FG::Input_halfedge_index h) { return {h, {{number(), number(), 0}}}; }

  // To the tail of h; a loop from there is left out.
  void go_to_vertex(FG::Input_halfedge_index h)
  {
    for(std::size_t i = 0; i < m_way.size(); ++i)
      if(kind(m_way[i]) == FG::Location_kind::VERTEX && input().tail(m_way[i].halfedge) == input().tail(h))
        m_way.resize(i);
    m_way.push_back({h, {{1, 0, 0}}});
  }

  // Over some spokes of a vertex, to or from the face of h.
  void turn_about(const FG::Surface_location& vertex, FG::Input_halfedge_index h, bool is_start)
  {
    while(input().tail(h) != input().tail(vertex.halfedge))
      h = input().next(h);
    Way outgoing_halfedges;
    const bool is_clockwise = m_random() % 2 == 0;
    for(unsigned turns = m_random() % 5; turns > 0; --turns) {
      const FG::Input_halfedge_index outgoing_halfedge =
          is_clockwise ? h : FG::internal::twin_index(input().next(input().next(h)));
      if(input().is_border(outgoing_halfedge) || input().is_border(FG::internal::twin_index(outgoing_halfedge)))
        break;
      outgoing_halfedges.push_back(on(outgoing_halfedge));
      h = is_clockwise ? input().next(FG::internal::twin_index(outgoing_halfedge)) : outgoing_halfedge;
    }
    if(is_start)
      std::reverse(outgoing_halfedges.begin(), outgoing_halfedges.end());
    m_way.insert(m_way.end(), outgoing_halfedges.begin(), outgoing_halfedges.end());
  }

  const Triangulation& m_triangulation;
  std::mt19937& m_random;
  Way m_way;
};

} // namespace

BOOST_AUTO_TEST_CASE(in_the_plane_ways_are_pulled_to_segments)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(6, 6, Diagonal_rule::ALTERNATING, 0.2, 4));
  const Triangulation t(mesh);
  std::mt19937 random(7);
  Way_beside_segment way_beside(t, random);
  for(int i = 0; i < 300; ++i) {
    const FG::Surface_location from = random_location(t, i % 3, random), to = random_location(t, i / 3 % 3, random);
    const auto crossed = crossed_sides(t, from, to);
    if(crossed.empty())
      continue;
    Transport_sleeve sleeve(t, way_beside(from, to, crossed));
    sleeve.straighten();
    BOOST_REQUIRE(sleeve.places().size() == 2u);
    const FG::internal::Sleeve_segment& leg = sleeve.legs().front();
    BOOST_TEST((leg.crossed == crossed));
    const std::complex<double> vector = sleeve.start(0).vector * direction_in_plane(t, leg.face);
    BOOST_TEST(std::abs(vector - (in_plane(t, to) - in_plane(t, from))) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(round_a_hole_a_way_is_a_taut_string)
{
  const Mesh mesh = to_mesh<Mesh>(grid_with_hole(6, 6, 2, 3, 2, 4));
  const Triangulation t(mesh);
  for(const int row : {1, 4}) { // below and above
    // Along lines that meet the edges at quarters of their lengths.
    std::vector<std::complex<double>> points;
    const int up = row < 3 ? -1 : 1;
    for(double y = 3.25; y != row + 0.25; y += up) {
      points.push_back({0.25, y});
      points.push_back({0.25, up > 0 ? y + 0.75 : y - 0.25});
    }
    for(int x = 0; x < 5; ++x) {
      points.push_back({x + 0.25, row + 0.25});
      points.push_back({x + 1., row + 0.25});
    }
    for(double y = row + 0.25; y != 3.25; y -= up) {
      points.push_back({5.25, y});
      points.push_back({5.25, up > 0 ? y - 0.25 : y + 0.75});
    }
    points.push_back({5.25, 3.25});
    for(const bool is_reversed : {false, true}) {
      if(is_reversed)
        std::reverse(points.begin(), points.end());
      Way way;
      for(const auto& p : points)
        way.push_back(location_of(t, p));
      Transport_sleeve sleeve(t, way);
      sleeve.straighten();
      const double side = row < 3 ? 2 : 4; // of the hole
      std::vector<std::complex<double>> bends = {points.front(), {2, side}, {3, side}, points.back()};
      if(is_reversed)
        std::swap(bends[1], bends[2]);
      BOOST_REQUIRE(sleeve.places().size() == bends.size());
      for(std::size_t i = 0; i < bends.size(); ++i)
        BOOST_TEST(std::abs(in_plane(t, sleeve.places()[i]) - bends[i]) < 1e-15);
      for(std::size_t i = 0; i + 1 < bends.size(); ++i)
        BOOST_TEST(std::abs(std::abs(sleeve.start(i).vector) - std::abs(bends[i + 1] - bends[i])) < 1e-14);
    }
  }
}

// About the tip there is one large corner, and two small ones, which the shorter way goes through.
BOOST_AUTO_TEST_CASE(two_legs_in_one_corner_can_be_joined_through_all_others)
{
  Mesh mesh = to_mesh<Mesh>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}});
  auto lengths = mesh.add_property_map<Mesh::Edge_index, double>("e:length", 1).first;
  const double large = 1.5, small = 0.3, gap = 1.4;
  const auto edge = [&](unsigned v, unsigned w) {
    return mesh.edge(mesh.halfedge(Mesh::Vertex_index(v), Mesh::Vertex_index(w)));
  };
  lengths[edge(1, 2)] = 2 * std::sin(large / 2);
  lengths[edge(2, 3)] = lengths[edge(3, 1)] = 2 * std::sin(small / 2);
  using Metric = FG::Edge_length_metric<Mesh, decltype(lengths)>;
  const FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<Metric::Kernel>, Metric> t(
      mesh, Metric(mesh, lengths));
  const auto h = t.input().index(mesh.halfedge(Mesh::Vertex_index(0), Mesh::Vertex_index(1)));
  const auto at = [&](double angle) { // half a side away from the tip
    const double w2 = 0.5 * std::sin(angle) / std::sin(large), w1 = 0.5 * std::cos(angle) - w2 * std::cos(large);
    return FG::Surface_location{h, {{1 - w1 - w2, w1, w2}}};
  };
  for(const bool is_reversed : {false, true}) {
    Way way = {at((large - gap) / 2), {h, {{1, 0, 0}}}, at((large + gap) / 2)};
    if(is_reversed)
      std::reverse(way.begin(), way.end());
    FG::internal::Transport_sleeve sleeve(t, way);
    sleeve.straighten();
    BOOST_TEST(sleeve.places().size() == 2u);
    BOOST_TEST(sleeve.legs().front().crossed.size() == 3u);
    BOOST_TEST(std::abs(std::abs(sleeve.start(0).vector) - std::sin((large - gap + 2 * small) / 2)) < 1e-14);
  }
}

// Near one end of an edge that is a million times as long as the way, to the digits of the way.
BOOST_AUTO_TEST_CASE(a_short_way_over_a_long_edge_keeps_its_digits)
{
  const double s = 0x1p-20;
  const Mesh mesh =
      to_mesh<Mesh>({{{-s, 0, 0}, {s / 3, -s, 0}, {s, s / 7, 0}, {1. / 3, 1, 0}}, {{0, 1, 3}, {1, 2, 3}}});
  const Triangulation t(mesh);
  const auto at = [&](unsigned v) { return t.location(t.index(Mesh::Vertex_index(v))); };
  const auto h = t.input().index(mesh.halfedge(Mesh::Vertex_index(1), Mesh::Vertex_index(3)));
  for(const bool is_reversed : {false, true}) {
    Way way = {at(0), {h, {{1, s, 0}}}, at(2)};
    if(is_reversed)
      std::reverse(way.begin(), way.end());
    Transport_sleeve sleeve(t, way);
    sleeve.straighten();
    BOOST_REQUIRE(sleeve.places().size() == 2u);
    const std::complex<double> whole = in_plane(t, way.back()) - in_plane(t, way.front());
    const auto vector = sleeve.start(0).vector * direction_in_plane(t, sleeve.legs().front().face);
    BOOST_TEST(std::abs(vector - whole) < 1e-14 * std::abs(whole));
  }
}

BOOST_AUTO_TEST_CASE(places_without_a_common_face_are_named)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const Triangulation t(mesh);
  const auto at = [&](int i, int j) { return t.location(FG::Vertex_index(grid_vertex(4, i, j))); };
  const auto is_named = [](const FG::Invalid_curve_error& error) {
    return error.elements() == std::vector<std::size_t>{1, 2} &&
           std::string(error.what()).find("points 1 and 2 ") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(Transport_sleeve(t, Way{at(0, 0), at(1, 0), at(3, 3)}), FG::Invalid_curve_error, is_named);
}
