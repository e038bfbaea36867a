// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Curves on split edges, and between inserted points.

#include "test_surface_points/inserted_points.h"

#include <CGAL/Flip_geodesics/certify.h>

#include <boost/math/constants/constants.hpp>

using namespace Flip_geodesics_test;

namespace {

// The smallest angle from directions of segments that are measured once is that of a joint, also beside inserted
// points.
template <class Network>
void check_measured_angles(const Network& network)
{
  FG::Straightness_meter<Network> meter(network);
  for(FG::Curve_index c : descriptors<FG::Curve_index>(network.number_of_curves())) {
    double expected = std::numeric_limits<double>::infinity();
    network.for_each_segment(c, [&](FG::Segment_index s) {
      if(network.next(s) != FG::null_index)
        for(FG::Side side : {FG::Side::LEFT, FG::Side::RIGHT})
          expected = std::min(expected, meter.angle({s, side}));
    });
    const double angle = meter(c).smallest_angle;
    BOOST_TEST((angle == expected || std::abs(angle - expected) < 1e-9));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(curves_on_split_edges_stay_where_they_are)
{
  int moved = 0;
  for(unsigned seed = 1; seed < 300 * scale; ++seed) {
    const Mesh mesh = to_mesh<Mesh>(soups()[seed % soups().size()]);
    Random_numbers random(seed);
    Certified t(mesh);
    flip_at_random(t, 10, random);
    FG::Edge_path_network<Certified> network(t);
    std::vector<FG::Halfedge_index> all;
    for(int i = 0; i < 3; ++i) {
      const bool is_closed = random.below(2) == 0;
      const auto walk = random_walk(t, 12, is_closed, random);
      if(walk.empty())
        continue;
      network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
      all.insert(all.end(), walk.begin(), walk.end());
    }
    if(all.empty() || !order_at_random(network, all, 20, random))
      continue;
    FG::internal::Indexed_by<FG::Curve_index, std::vector<double>> lengths;
    for(FG::Curve_index c : descriptors<FG::Curve_index>(network.number_of_curves()))
      lengths.push_back(network.length(c));
    for(int i = 0; i < 10; ++i) {
      const int segments = network.end_of_segment_ids();
      network.insert(random_location(mesh, random));
      moved += network.end_of_segment_ids() > segments ? 1 : 0;
      BOOST_TEST(network.is_valid());
      BOOST_TEST(t.is_valid());
    }
    for(FG::Curve_index c : descriptors<FG::Curve_index>(network.number_of_curves()))
      BOOST_TEST(std::abs(network.length(c) - lengths[c]) < 1e-12 * lengths[c]);
    check_measured_angles(network);
    const FG::Shortening_report report = FG::shorten(network);
    BOOST_TEST(report.is_complete());
    BOOST_TEST(FG::certify(network).is_locally_shortest());
    BOOST_TEST(network.is_valid());
  }
  BOOST_TEST(moved > 20);
}

namespace {

// With as few edges as possible.
template <class Triangulation>
std::vector<FG::Halfedge_index> some_path(const Triangulation& t, FG::Vertex_index from, FG::Vertex_index to)
{
  FG::internal::Indexed_by<FG::Vertex_index, std::vector<FG::Halfedge_index>> arriving(
      static_cast<std::size_t>(t.number_of_vertices()));
  std::vector<FG::Vertex_index> reached = {from};
  for(std::size_t i = 0; i < reached.size(); ++i)
    for(FG::Halfedge_index h : outgoing_halfedges_at_tail(t, t.outgoing(reached[i])))
      if(t.head(h) != from && arriving[t.head(h)] == FG::null_index) {
        arriving[t.head(h)] = h;
        reached.push_back(t.head(h));
      }
  std::vector<FG::Halfedge_index> result;
  for(FG::Vertex_index v = to; v != from; v = t.tail(result.back()))
    result.push_back(arriving[v]);
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace

// Every extracted point lies where the words and the inserted locations say; the polyline is as long as the curve.
BOOST_AUTO_TEST_CASE(curves_between_inserted_points_are_read_off)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(8, 0.1, 7));
  Random_numbers random(3);
  int crossings = 0;
  for(int i = 0; i < 20; ++i) {
    Certified t(mesh);
    const FG::Vertex_index a = t.insert(random_location(mesh, random)), b = t.insert(random_location(mesh, random));
    if(a == b)
      continue;
    FG::Edge_path_network<Certified> network(t);
    network.add_curve(some_path(t, a, b));
    FG::shorten(network);
    BOOST_TEST(FG::certify(network).is_locally_shortest());
    FG::Curve_extractor<FG::Edge_path_network<Certified>> extractor(network);
    const auto points = extractor.surface_points(0_c);
    BOOST_TEST(points.front().vertex == a);
    BOOST_TEST(points.back().vertex == b);
    double length = 0;
    for(std::size_t k = 0; k + 1 < points.size(); ++k)
      length += std::sqrt(CGAL::squared_distance(extractor.point(points[k]), extractor.point(points[k + 1])));
    BOOST_TEST(std::abs(length - network.length(0_c)) < 1e-12 * length);
    std::vector<std::pair<Mesh::Face_index, std::array<double, 3>>> locations;
    extractor.face_locations(0_c, mesh, std::back_inserter(locations));
    for(std::size_t k = 0; k < points.size(); ++k) {
      Point sum(0, 0, 0);
      auto h = mesh.halfedge(locations[k].first);
      for(double weight : locations[k].second) {
        const Point& p = mesh.point(mesh.source(h));
        sum = Point(sum.x() + weight * p.x(), sum.y() + weight * p.y(), sum.z() + weight * p.z());
        h = mesh.next(h);
      }
      BOOST_TEST(CGAL::squared_distance(sum, extractor.point(points[k])) < 1e-28);
    }
    crossings += static_cast<int>(points.size()) - 2;
  }
  BOOST_TEST(crossings > 100);
}

// A rational number type has the points of input faces exactly; where edges cross the input already, it says so.
BOOST_AUTO_TEST_CASE(points_in_rational_numbers)
{
  using Rational = boost::multiprecision::cpp_rational;
  using Traits = FG::Exact_intrinsic_triangulation_traits<Rational>;
  using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits>;
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  Random_numbers random(1);
  Triangulation t(mesh);
  Certified other(mesh);
  for(int i = 0; i < 20; ++i) {
    const FG::Surface_location location = random_location(mesh, random);
    BOOST_TEST(t.insert(location) == other.insert(location));
  }
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges()))
    BOOST_TEST(std::abs(t.length(h) - other.length(h)) < 1e-12);
  const FG::Vertex_index a = t.insert({0_input_h, {{1, 1, 1}}}), b = t.insert({50_input_h, {{1, 2, 3}}});
  other.insert({0_input_h, {{1, 1, 1}}});
  other.insert({50_input_h, {{1, 2, 3}}});
  FG::Edge_path_network<Triangulation> network(t);
  network.add_curve(some_path(t, a, b));
  FG::Edge_path_network<Certified> other_network(other);
  other_network.add_curve(some_path(other, a, b));
  BOOST_TEST(FG::shorten(network).is_complete());
  BOOST_TEST(FG::shorten(other_network).is_complete());
  BOOST_TEST(FG::certify(network).is_locally_shortest());
  BOOST_TEST(std::abs(network.length(0_c) - other_network.length(0_c)) < 1e-12);

  int refused = 0;
  for(int i = 0; i < 40; ++i) {
    const int edges = t.number_of_edges();
    try {
      network.insert(random_location(mesh, random));
    } catch(const FG::Insertion_error&) {
      BOOST_TEST(t.number_of_edges() == edges);
      ++refused;
    }
    BOOST_TEST(t.is_valid());
  }
  BOOST_TEST(refused > 0);
}

BOOST_AUTO_TEST_CASE(a_curve_is_as_straight_as_its_worst_place)
{
  constexpr double pi = boost::math::constants::pi<double>();
  FG::Straightness straightness;
  BOOST_TEST(straightness.is_locally_shortest());
  straightness.note_bend(1e-9);
  straightness.note_angle(pi - 1e-9);
  BOOST_TEST(straightness.is_locally_shortest());
  FG::Straightness bent = straightness, turned = straightness;
  for(double bend : {1e-3, 1e-9})
    bent.note_bend(bend);
  BOOST_TEST(bent.largest_bend == 1e-3);
  BOOST_TEST(!bent.is_locally_shortest());
  for(double angle : {3.0, 4.0})
    turned.note_angle(angle);
  BOOST_TEST(turned.smallest_angle == 3);
  BOOST_TEST(!turned.is_locally_shortest());
}
