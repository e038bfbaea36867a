// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE intrinsic_triangulation

#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "lawson.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/internal/strips/Strip.h>
#include <CGAL/Flip_geodesics/internal/strips/Vertex_directions.h>
#include <CGAL/Flip_geodesics/internal/strips/Wedge_angle.h>
#include <CGAL/Flip_geodesics/internal/strips/refresh_face.h>
#include <CGAL/Flip_geodesics/internal/words/Crossing_words.h>
#include <CGAL/Flip_geodesics/internal/words/Word_tracer.h>
#include <CGAL/Flip_geodesics/intrinsic_edge_path.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstring>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::internal::descriptors;
using FG::internal::twin_index;
using namespace Flip_geodesics_test;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Edge = boost::graph_traits<Mesh>::edge_descriptor;
using Length_map = boost::associative_property_map<std::map<Edge, double>>;
using Length_metric = FG::Edge_length_metric<Mesh, Length_map>;
using Length_triangulation =
    FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<Length_metric::Kernel>, Length_metric>;

namespace {

std::vector<Mesh_soup> soups()
{
  return {tetrahedron(1),
          shaken(tetrahedron(1), 0.4, 1),
          shaken(octahedron(1), 0.3, 2),
          shaken(torus(4, 3, 2, 1), 0.2, 3),
          cone_disk(5, 1, 2),
          shaken(flat_grid(4, 3, Diagonal_rule::RANDOM), 0.2, 4),
          shaken(grid_with_hole(3, 3, 1, 2, 1, 2), 0.1, 5),
          single_triangle(),
          shaken(genus_3_plate(1), 0.1, 6),
          random_convex_polyhedron(30, 7),
          with_isolated_vertices(disjoint_union(octahedron(1), flat_grid(2, 2, Diagonal_rule::FALLING)), 2, 1)};
}

// ---------------------------------------------------------------- what flips must not change

// All that the triangulation says of its halfedges, as bytes where it is a number.
struct Snapshot
{
  std::vector<int> links;
  std::vector<double> vectors;

  explicit Snapshot(const Triangulation& t)
  {
    for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
      const bool is_border = t.is_border(h);
      for(int i : {is_border ? -1 : t.next(h).idx(), t.tail(h).idx(), t.crossings(t.edge(h)), t.version(t.edge(h))})
        links.push_back(i);
      if(!is_border)
        vectors.insert(vectors.end(), {t.geometry(h).x, t.geometry(h).y});
    }
  }

  bool operator==(const Snapshot& other) const
  {
    return links == other.links && vectors.size() == other.vectors.size() &&
           std::memcmp(vectors.data(), other.vectors.data(), vectors.size() * sizeof(double)) == 0;
  }
};

std::vector<int> connectivity(const Triangulation& t)
{
  std::vector<int> result;
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
    result.push_back(t.is_border(h) ? -1 : t.next(h).idx());
    result.push_back(t.tail(h).idx());
  }
  return result;
}

struct Measures
{
  double area = 0;
  FG::internal::Indexed_by<FG::Vertex_index, std::vector<double>> angle_sums;

  explicit Measures(const Triangulation& t)
    : angle_sums(static_cast<std::size_t>(t.number_of_vertices()), 0.0)
  {
    for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
      if(t.is_border(h))
        continue;
      const auto out = t.geometry(h), in = t.geometry(t.previous(h));
      const double cross = in.x * out.y - in.y * out.x, dot = -(in.x * out.x + in.y * out.y);
      area += cross / 6; // each face is met three times
      angle_sums[t.tail(h)] += std::atan2(cross, dot);
    }
  }
};

// ---------------------------------------------------------------- lengths by another route

using Vector = std::complex<long double>;

// The lengths of the sides of the input face left of h, in long double from the coordinates.
long double input_length(const Mesh& mesh, const Triangulation& t, FG::Input_halfedge_index h)
{
  const Point p = mesh.point(t.vertex(t.input().tail(h))), q = mesh.point(t.vertex(t.input().tail(twin_index(h))));
  const long double x = (long double)q.x() - p.x(), y = (long double)q.y() - p.y(), z = (long double)q.z() - p.z();
  return std::sqrt(x * x + y * y + z * z);
}

// The third point of the input face on the left of h when h leads from a to b in the plane.
Vector apex(const Mesh& mesh, const Triangulation& t, FG::Input_halfedge_index h, Vector a, Vector b)
{
  const long double c = input_length(mesh, t, h), l = input_length(mesh, t, t.input().next(h)),
                    r = input_length(mesh, t, t.input().next(t.input().next(h)));
  const long double x = (c * c + r * r - l * l) / (2 * c), y = std::sqrt((std::max)(r * r - x * x, 0.0L));
  return a + (b - a) / std::abs(b - a) * Vector(x, y);
}

struct Unfolded
{
  long double length;
  long double largest_bend; // as the sine of an angle at the nearer end
};

Unfolded unfold(const Mesh& mesh, const Triangulation& t, const FG::Crossing_word& word)
{
  if(word.along != FG::null_index)
    return {input_length(mesh, t, word.along), 0};
  // The first crossed edge, from right to left as the traveller sees it, and the tail on its left side.
  const FG::Input_halfedge_index first = word.crossed.front();
  Vector right = 0, left = input_length(mesh, t, first);
  const Vector tail = apex(mesh, t, first, right, left);
  std::vector<std::pair<Vector, Vector>> gates;
  for(std::size_t i = 0;; ++i) {
    gates.emplace_back(right, left);
    const FG::Input_halfedge_index entered = twin_index(word.crossed[i]); // from left to right
    const Vector next = apex(mesh, t, entered, left, right);
    if(i + 1 == word.crossed.size()) {
      Unfolded result = {std::abs(next - tail), 0};
      const Vector direction = (next - tail) / result.length;
      for(const auto& [r, l] : gates) {
        const Vector pr = (r - tail) / direction, pl = (l - tail) / direction;
        const long double end = result.length;
        result.largest_bend = (std::max)({result.largest_bend, pr.imag() / (std::min)(std::abs(pr), std::abs(pr - end)),
                                          -pl.imag() / (std::min)(std::abs(pl), std::abs(pl - end))});
      }
      return result;
    }
    const FG::Input_halfedge_index crossed = word.crossed[i + 1];
    if(crossed == t.input().next(entered)) // starts at the right end
      left = next;
    else {
      BOOST_REQUIRE_EQUAL(crossed, t.input().next(t.input().next(entered)));
      right = next;
    }
  }
}

// ---------------------------------------------------------------- what occurs in Delta-complexes

struct Oddities
{
  long loops = 0, multiple_edges = 0, degree_one = 0, border_edges = 0, self_glued_faces = 0;

  void count(const Triangulation& t)
  {
    std::set<std::pair<FG::Vertex_index, FG::Vertex_index>> ends;
    for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
      loops += FG::internal::is_first_side(h) && t.tail(h) == t.head(h) ? 1 : 0;
      border_edges += t.is_border(h) ? 1 : 0;
      self_glued_faces += !t.is_border(h) && t.next(h) == t.twin(h) ? 1 : 0;
      degree_one += !t.is_border(t.twin(h)) && t.clockwise(h) == h ? 1 : 0;
      if(FG::internal::is_first_side(h))
        multiple_edges += ends.insert(std::minmax<FG::Vertex_index>(t.tail(h), t.head(h))).second ? 0 : 1;
    }
  }
};

} // namespace

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

// Two ways to a word that share nothing: numbers of crossings as they are now, and the log of the flips.
BOOST_AUTO_TEST_CASE(words_traced_are_words_derived)
{
  Random_numbers random(12);
  long traced = 0, not_traced = 0, longest = 0;
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    for(int k = 0; k < 60 * scale; ++k) {
      Triangulation t(mesh);
      flip_at_random(t, 10 + random.below(90), random);
      FG::internal::Crossing_words<Triangulation> words;
      FG::internal::Word_tracer<Triangulation> tracer(t);
      for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
        const FG::Index version = t.version(t.edge(h));
        FG::Crossing_word word;
        if(!tracer(h, word)) {
          ++not_traced;
          continue;
        }
        FG::Crossing_word expected = {FG::internal::as_input(h), {}, FG::null_index, t.tail(h), t.head(h)};
        if(version != 0) {
          words.resolve(t, {h, version});
          expected = words.word(t, {h, version});
          BOOST_TEST(words.spokes(version).crossings == static_cast<int>(expected.crossed.size()));
        }
        BOOST_TEST((word.along == expected.along && word.crossed == expected.crossed && word.face == expected.face));
        BOOST_TEST((word.tail == expected.tail && word.head == expected.head));
        longest = (std::max)(longest, long(word.crossed.size()));
        ++traced;
      }
    }
  }
  std::cout << traced << " words traced, the longest crosses " << longest << " edges; " << not_traced << " derived\n";
  BOOST_TEST(longest > 12);
  BOOST_TEST(not_traced > 0);
}

BOOST_AUTO_TEST_CASE(words_are_exact_and_straight)
{
  Random_numbers random(4);
  long words = 0, longest = 0;
  double worst_length = 0, worst_bend = 0;
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    for(int k = 0; k < 60 * scale; ++k) {
      Triangulation t(mesh);
      flip_at_random(t, 10 + random.below(90), random);
      for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
        const FG::Crossing_word word = t.crossing_word(h), back = t.crossing_word(t.twin(h)).reversed();
        BOOST_TEST((word.crossed == back.crossed && word.along == back.along));
        const int crossings = word.along == FG::null_index ? static_cast<int>(word.crossed.size()) : -1;
        BOOST_TEST(t.crossings(t.edge(h)) == crossings);
        BOOST_TEST((crossings != 0));
        const Unfolded unfolded = unfold(mesh, t, word);
        const FG::internal::Strip<Triangulation> strip(t, word);
        worst_length = (std::max)({worst_length, std::abs(double(t.length(h) / unfolded.length - 1)),
                                   std::abs(double(strip.length() / unfolded.length - 1))});
        worst_bend = (std::max)({worst_bend, strip.bend(), double(unfolded.largest_bend)});
        longest = (std::max)(longest, long(crossings));
        ++words;
      }
    }
  }
  std::cout << words << " words, the longest crosses " << longest << " edges; largest relative error of a length "
            << worst_length << ", largest bend " << worst_bend << '\n';
  BOOST_TEST(longest > 20);
  BOOST_TEST(worst_length < 1e-9);
  BOOST_TEST(worst_bend < 1e-8);
}

BOOST_AUTO_TEST_CASE(input_edges_are_counted_around_vertices)
{
  Random_numbers random(5);
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation t(mesh);
    for(int k = 0; k < 60 * scale; ++k) {
      t.rollback();
      flip_at_random(t, 60, random);
      for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
        const std::vector<FG::Halfedge_index> spokes = spokes_at_tail(t, h);
        const bool has_border = std::any_of(spokes.begin(), spokes.end(),
                                            [&](FG::Halfedge_index g) { return t.clockwise(g) == FG::null_index; });
        if(has_border)
          continue;
        const int along = t.crossings(t.edge(h)) < 0 ? 1 : 0;
        BOOST_TEST(t.input_edges_in_wedge(h, h) + along == static_cast<int>(mesh.degree(t.vertex(t.tail(h)))));
      }
    }
  }
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
      BOOST_TEST(is_delaunay(t));
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
    BOOST_TEST(is_delaunay(t));
  }
  // By more than the tolerance outside of the circle, and inside.
  for(double x : {1 + 1e-7, 1 - 1e-7}) {
    const Mesh mesh = to_mesh<Mesh>(Mesh_soup{{{-1, 0, 0}, {0, -1, 0}, {x, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
    Triangulation t(mesh);
    BOOST_TEST(is_delaunay(t) == (x < 1));
    BOOST_TEST(flip_to_delaunay(t, 10) == (x < 1 ? 0 : 1));
  }
}

namespace {

// Adds points inside faces, on edges and on the border at random.
void insert_at_random(Triangulation& t, int number, Random_numbers& random)
{
  for(int i = 0; i < number; ++i) {
    const FG::Input_halfedge_index h(random.below(t.input().number_of_halfedges()));
    const bool is_on_edge = t.input().is_border(h) || random.below(2) == 0;
    t.insert({h, {{random.uniform(0.1, 1), random.uniform(0.1, 1), is_on_edge ? 0 : random.uniform(0.1, 1)}}});
  }
}

// Where a vertex of a triangulation of a flat mesh is.
std::complex<double> place(const Mesh& mesh, const Triangulation& t, FG::Vertex_index v)
{
  const FG::Surface_location at = t.location(v);
  std::complex<double> sum = 0;
  double weight = 0;
  FG::Input_halfedge_index h = at.halfedge;
  for(int i = 0; i < 3; ++i, h = t.input().next(h)) {
    const Point p = mesh.point(t.vertex(t.input().tail(h)));
    sum += at.weights[i] * std::complex<double>(p.x(), p.y());
    weight += at.weights[i];
  }
  return sum / weight;
}

// From the first direction counterclockwise to the second, in [0, 2 pi).
double planar_angle(const std::complex<double>& from, const std::complex<double>& to)
{
  const double angle = std::arg(to / from);
  return angle < -1e-9 ? angle + 2 * pi : angle;
}

// Does the turn counterclockwise from one spoke to another not meet the border?
bool is_inner_turn(const Triangulation& t, FG::Halfedge_index from, FG::Halfedge_index to)
{
  FG::Halfedge_index h = from;
  while(h != to && h != FG::null_index)
    h = t.counterclockwise(h);
  return h == to;
}

} // namespace

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
      const Halfedge_sequence spokes = spokes_at_tail(t, t.outgoing(v));
      const bool is_border =
          std::any_of(spokes.begin(), spokes.end(), [&](FG::Halfedge_index h) { return t.is_border(h); });
      BOOST_TEST(directions.has_border() == is_border);
      if(!is_border)
        BOOST_TEST(std::abs(directions.total() - 2 * pi) < tolerance);
      if(t.is_inserted(v) && is_border)
        BOOST_TEST(std::abs(directions.total() - pi) < tolerance);
      for(FG::Halfedge_index g : spokes) {
        BOOST_TEST((directions(g) > -tolerance && directions(g) < directions.total() + tolerance));
        for(FG::Halfedge_index h : spokes) {
          if(g == h)
            continue;
          const double angle = planar_angle(vector(g), vector(h)), back = 2 * pi - angle;
          const double found = directions.counterclockwise(directions(g), directions(h));
          const double smaller = directions.smaller_wedge(directions(g), directions(h));
          const bool is_inner = is_inner_turn(t, g, h);
          BOOST_TEST((is_inner ? std::abs(found - angle) < tolerance : std::isinf(found)));
          const double expected = !is_border ? (std::min)(angle, back) : (is_inner ? angle : back);
          BOOST_TEST(std::abs(smaller - expected) < tolerance);
        }
      }
    }
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
      for(FG::Halfedge_index g : spokes_at_tail(t, t.outgoing(v))) {
        BOOST_TEST(std::abs(FG::internal::wedge_angle(t, g, g).value - 2 * pi) < 1e-9);
        const FG::internal::Strip<Triangulation> strip(t, t.crossing_word(g));
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
    const Halfedge_sequence spokes = spokes_at_tail(t, h);
    const auto is_at_border = [&](FG::Halfedge_index g) { return t.is_border(g) || t.is_border(t.twin(g)); };
    if(std::any_of(spokes.begin(), spokes.end(), is_at_border))
      continue;
    FG::Crossing_word word; // from the head of h about its tail, counterclockwise, to the head of h
    word.tail = word.head = t.head(h);
    for(FG::Halfedge_index g = t.counterclockwise(h); g != h; g = t.counterclockwise(g)) {
      const FG::Input_halfedge_index crossed = FG::internal::as_input(g);
      word.crossed.push_back(twin_index(crossed));
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
      const FG::internal::Strip<Triangulation> strip(t, t.crossing_word(h));
      bent += strip.bend() > 0.1 ? 1 : 0;
      for(std::size_t gate = 0; gate < strip.gates().size(); ++gate)
        for(double position : {strip.crossing(gate), strip.crossing_along(gate)})
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
    BOOST_TEST(spokes_at_tail(t, t.outgoing(v)).size() == 3u);
    ++split;
  }
  BOOST_TEST(split == 16);
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
      for(int round = 0; round < n; ++round) // [Bellman, Ford]
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

BOOST_AUTO_TEST_CASE(isolated_vertices_have_no_spokes)
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
