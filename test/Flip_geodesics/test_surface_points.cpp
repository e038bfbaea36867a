// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points of the surface as vertices: in the input and in flipped triangulations, against an unfolding of its own.

#define BOOST_TEST_MODULE surface_points

#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/delaunay/Face_chart.h>
#include <CGAL/Flip_geodesics/internal/polylines/locations_in_faces.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstring>
#include <iostream>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::internal::descriptors;
using FG::internal::twin_index;
using namespace Flip_geodesics_test;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Plain = FG::Intrinsic_triangulation<Mesh>;
using Certified = FG::Intrinsic_triangulation<Mesh, FG::Certified_intrinsic_triangulation_traits<Kernel>>;

std::vector<Mesh_soup> soups()
{
  return {tetrahedron(1),
          shaken(tetrahedron(1), 0.4, 1),
          octahedron(1),
          shaken(torus(4, 3, 2, 1), 0.2, 3),
          cone_disk(5, 1, 2),
          shaken(flat_grid(4, 3, Diagonal_rule::RANDOM), 0.2, 4),
          flat_grid(3, 3, Diagonal_rule::RISING),
          single_triangle(),
          shaken(genus_3_plate(1), 0.1, 6)};
}

// Small whole weights hit edges, vertices and points that are there already; others are anywhere.
FG::Surface_location random_location(const Mesh& mesh, Random_numbers& random)
{
  const auto faces = static_cast<int>(mesh.number_of_faces());
  const auto h = mesh.halfedge(Mesh::Face_index(static_cast<unsigned>(random.below(faces))));
  FG::Surface_location result{FG::Input_halfedge_index(static_cast<FG::Index>(h)), {{0, 0, 0}}};
  const bool is_special = random.below(2) == 0;
  for(double& weight : result.weights)
    weight = is_special ? random.below(4) : random.uniform(0.01, 1);
  if(result.weights[0] + result.weights[1] + result.weights[2] == 0)
    result.weights[0] = 1;
  return result;
}

// ---------------------------------------------------------------- an unfolding of its own

using Vector = std::complex<long double>;

template <class Triangulation>
class Unfolding
{
public:
  Unfolding(const Mesh& mesh, const Triangulation& triangulation)
    : m_mesh(mesh)
    , m_triangulation(triangulation)
  {
  }

  struct Result
  {
    long double length;
    long double bend; // the distance by which the straight line misses a crossed edge
  };

  Result operator()(const FG::Crossing_word& word) const
  {
    const FG::Input_halfedge_index first =
        word.along.is_valid() ? word.along : (word.crossed.empty() ? word.face : word.crossed.front());
    Corners corners = {first, 0, length(first), 0};
    corners.apex = apex(first, corners.tail, corners.head);
    const Vector start = position(word.tail, corners);
    std::vector<std::pair<Vector, Vector>> gates;
    for(FG::Input_halfedge_index crossed : word.crossed) {
      const Vector ends[3] = {corners.tail, corners.head, corners.apex};
      int side = 0;
      while(turned(corners.halfedge, side) != crossed)
        BOOST_REQUIRE(++side < 3);
      gates.emplace_back(ends[side], ends[(side + 1) % 3]);
      corners = {twin_index(crossed), ends[(side + 1) % 3], ends[side], 0};
      corners.apex = apex(twin_index(crossed), corners.tail, corners.head);
    }
    const Vector end = position(word.head, corners), direction = (end - start) / std::abs(end - start);
    Result result = {std::abs(end - start), 0};
    for(const auto& [right, left] : gates)
      result.bend =
          (std::max)({result.bend, ((right - start) / direction).imag(), -((left - start) / direction).imag()});
    return result;
  }

private:
  struct Corners // of a face, unfolded
  {
    FG::Input_halfedge_index halfedge;
    Vector tail, head, apex;
  };

  static Mesh::Halfedge_index halfedge(FG::Input_halfedge_index h)
  {
    return Mesh::Halfedge_index(static_cast<unsigned>(h.idx()));
  }

  FG::Input_halfedge_index turned(FG::Input_halfedge_index h, int times) const
  {
    for(; times > 0; --times)
      h = FG::Input_halfedge_index(static_cast<FG::Index>(m_mesh.next(halfedge(h))));
    return h;
  }

  Mesh::Vertex_index vertex(FG::Input_halfedge_index h) const { return m_mesh.source(halfedge(h)); }

  long double length(FG::Input_halfedge_index h) const
  {
    const auto v = m_mesh.point(vertex(twin_index(h))) - m_mesh.point(vertex(h));
    const long double x = v.x(), y = v.y(), z = v.z();
    return std::sqrt(x * x + y * y + z * z);
  }

  Vector apex(FG::Input_halfedge_index h, Vector a, Vector b) const
  {
    const long double c = length(h), l = length(turned(h, 1)), r = length(turned(h, 2));
    const long double x = (c * c + r * r - l * l) / (2 * c), y = std::sqrt((std::max)(r * r - x * x, 0.0L));
    return a + (b - a) / std::abs(b - a) * Vector(x, y);
  }

  // By the vertices of the face alone.
  Vector position(FG::Vertex_index v, const Corners& c) const
  {
    const Vector places[3] = {c.tail, c.head, c.apex};
    const FG::Surface_location at = m_triangulation.location(v);
    Vector sum = 0;
    long double weights = 0;
    for(int i = 0; i < 3; ++i) {
      if(at.weights[i] == 0)
        continue;
      int k = 0;
      while(vertex(turned(c.halfedge, k)) != vertex(turned(at.halfedge, i)))
        BOOST_REQUIRE(++k < 3);
      sum += static_cast<long double>(at.weights[i]) * places[k];
      weights += at.weights[i];
    }
    return sum / weights;
  }

  const Mesh& m_mesh;
  const Triangulation& m_triangulation;
};

// ---------------------------------------------------------------- what must hold after every operation

template <class Triangulation>
void check_words(const Mesh& mesh, const Triangulation& t)
{
  const Unfolding<Triangulation> unfold(mesh, t);
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
    const FG::Crossing_word word = t.crossing_word(h), back = t.crossing_word(t.twin(h)).reversed();
    BOOST_TEST((word.crossed == back.crossed && word.along == back.along && word.face == back.face));
    BOOST_TEST((word.tail == t.tail(h) && word.head == t.head(h)));
    BOOST_TEST(t.crossings(t.edge(h)) == (word.along.is_valid() ? -1 : static_cast<int>(word.crossed.size())));
    const auto unfolded = unfold(word);
    BOOST_TEST(std::abs(unfolded.length - t.length(h)) <= 1e-9 * unfolded.length);
    BOOST_TEST(unfolded.bend <= 1e-9);
  }
}

// The area of the input, and angles of 2 pi at points inside, of pi on the border.
template <class Triangulation>
void check_measures(const Triangulation& t, double area)
{
  FG::internal::Indexed_by<FG::Vertex_index, std::vector<double>> angles(
      static_cast<std::size_t>(t.number_of_vertices()), 0.0);
  FG::internal::Indexed_by<FG::Vertex_index, std::vector<char>> is_on_border(angles.size(), 0);
  double sum = 0;
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
    if(t.is_border(h)) {
      is_on_border[t.tail(h)] = 1;
      continue;
    }
    const auto out = t.geometry(h), in = t.geometry(t.previous(h));
    const double cross = in.x * out.y - in.y * out.x;
    BOOST_TEST(cross >= 0);
    sum += cross / 6;
    angles[t.tail(h)] += std::atan2(cross, -(in.x * out.x + in.y * out.y));
  }
  BOOST_TEST(std::abs(sum - area) < 1e-9 * area);
  for(FG::Vertex_index v : descriptors<FG::Vertex_index>(t.number_of_vertices()))
    if(t.is_inserted(v))
      BOOST_TEST(std::abs(angles[v] - (is_on_border[v] ? pi : 2 * pi)) < 1e-7);
}

template <class Triangulation>
double area(const Triangulation& t)
{
  double sum = 0;
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges()))
    if(!t.is_border(h)) {
      const auto out = t.geometry(h), in = t.geometry(t.previous(h));
      sum += (in.x * out.y - in.y * out.x) / 6;
    }
  return sum;
}

struct Snapshot
{
  std::vector<int> links;
  std::vector<double> vectors;

  template <class Triangulation>
  explicit Snapshot(const Triangulation& t)
  {
    for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
      const bool is_border = t.is_border(h);
      for(int i : {is_border ? -1 : t.next(h).idx(), t.tail(h).idx(), t.crossings(t.edge(h)), t.version(t.edge(h))})
        links.push_back(i);
      if(!is_border)
        vectors.insert(vectors.end(), {t.geometry(h).x, t.geometry(h).y});
    }
    for(FG::Vertex_index v : descriptors<FG::Vertex_index>(t.number_of_vertices()))
      BOOST_TEST((t.outgoing(v).idx() < t.number_of_halfedges() && t.tail(t.outgoing(v)) == v));
  }

  bool operator==(const Snapshot& other) const
  {
    return links == other.links && vectors.size() == other.vectors.size() &&
           std::memcmp(vectors.data(), other.vectors.data(), vectors.size() * sizeof(double)) == 0;
  }
};

struct Counts
{
  int faces = 0, edges = 0, vertices = 0;
};

template <class Triangulation>
void insert_flip_and_roll_back(const Mesh_soup& soup, int flips, int operations, unsigned seed, Counts& counts)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  Random_numbers random(seed);
  Triangulation t(mesh);
  const double whole = area(t);
  const Snapshot input(t);
  flip_at_random(t, flips, random);
  const Snapshot flipped(t);
  const auto start = t.log_position();
  for(int i = 0; i < operations; ++i) {
    const int vertices = t.number_of_vertices(), edges = t.number_of_edges();
    bool is_split = false;
    const FG::Vertex_index v = t.insert(random_location(mesh, random), [&](const auto&) { is_split = true; });
    BOOST_TEST((v.idx() == vertices || t.number_of_vertices() == vertices));
    BOOST_TEST(t.is_valid());
    counts.vertices += v.idx() == vertices ? 0 : 1;
    counts.edges += is_split ? 1 : 0;
    counts.faces += t.number_of_edges() - edges == 3 && !is_split ? 1 : 0;
    check_words(mesh, t);
    check_measures(t, whole);
    flip_at_random(t, flips / 3, random);
  }
  check_words(mesh, t);
  check_measures(t, whole);
  t.rollback(start);
  BOOST_TEST((Snapshot(t) == flipped));
  t.rollback();
  BOOST_TEST((Snapshot(t) == input));
}

} // namespace

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
        const auto word = t.crossing_word(is_first ? h : t.twin(h));
        const FG::Vertex_index v = t.insert({word.along, {{1, 2, 0}}});
        BOOST_TEST(v.idx() == static_cast<int>(mesh.number_of_vertices()));
        BOOST_TEST(t.is_valid());
        check_words(mesh, t);
        check_measures(t, whole);
        ++splits;
        break;
      }
      const auto spokes = spokes_at_tail(t, h);
      const FG::Halfedge_index g = spokes[random.below(static_cast<int>(spokes.size()))];
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
  BOOST_TEST(t.insert({twin_index(h), {{3, 1, 0}}}) == on_edge);
  BOOST_TEST(t.insert({hn, {{3, 0, 1}}}) == on_edge);
  BOOST_TEST(t.insert({hn, {{0, 7, 0}}}) == t.input().tail(hp));
  BOOST_TEST((kind(t.location(inside)) == FG::Location_kind::FACE));
  BOOST_TEST((kind(t.location(on_edge)) == FG::Location_kind::EDGE));
  BOOST_TEST((kind(t.location(2_v)) == FG::Location_kind::VERTEX));
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
  const FG::Input_halfedge_index h = twin_index(border);
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
      network.add_curve(walk, is_closed);
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
    for(FG::Halfedge_index h : spokes_at_tail(t, t.outgoing(reached[i])))
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
    network.add_curve(some_path(t, a, b), false);
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
  network.add_curve(some_path(t, a, b), false);
  FG::Edge_path_network<Certified> other_network(other);
  other_network.add_curve(some_path(other, a, b), false);
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
      const FG::Crossing_word word = t.crossing_word(h);
      bool is_inside = false;
      FG::Input_halfedge_index side = face;
      for(int i = 0; i < 3; ++i, side = t.input().next(side))
        is_inside = is_inside || word.face == side || word.along == side || word.along == twin_index(side);
      if(is_inside)
        length[t.tail(h)][t.head(h)] = (std::min)(length[t.tail(h)][t.head(h)], t.length(h));
    }
    const auto vertices = descriptors<FG::Vertex_index>(n);
    for(FG::Vertex_index via : vertices)
      for(FG::Vertex_index from : vertices)
        for(FG::Vertex_index to : vertices)
          length[from][to] = (std::min)(length[from][to], length[from][via] + length[via][to]);
    const FG::internal::Path_in_face<Plain> path(t, face);
    for(FG::Vertex_index from : vertices)
      for(FG::Vertex_index to : vertices) {
        if(from == to)
          continue;
        const std::vector<FG::Halfedge_index> way = path(from, to);
        double sum = way.empty() ? std::numeric_limits<double>::infinity() : 0;
        for(FG::Halfedge_index h : way)
          sum += t.length(h);
        BOOST_TEST((sum == length[from][to] || std::abs(sum - length[from][to]) < 1e-12));
      }
  }
}
