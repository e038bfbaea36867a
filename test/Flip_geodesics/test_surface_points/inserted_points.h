// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points inserted into flipped triangulations, and what must hold after every operation.

#ifndef FLIP_GEODESICS_TEST_SURFACE_POINTS_INSERTED_POINTS_H
#define FLIP_GEODESICS_TEST_SURFACE_POINTS_INSERTED_POINTS_H

#include "Double_triangulation.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Delaunay_refiner.h>
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

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;
using FG::internal::descriptors;
using FG::internal::twin_index;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Plain = Double_triangulation<Mesh>;
using Certified = FG::Intrinsic_triangulation<Mesh, FG::Certified_intrinsic_triangulation_traits<Kernel>>;

inline std::vector<Mesh_soup> soups()
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
inline FG::Surface_location random_location(const Mesh& mesh, Random_numbers& random)
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

  Result operator()(const FG::Edge_sequence& word) const
  {
    const FG::Input_halfedge_index first =
        word.along.is_valid() ? word.along : (word.crossed.empty() ? word.face : word.crossed.front());
    Corners corners = {first, 0, length(first), 0};
    corners.apex = apex(first, corners.tail, corners.head);
    const Vector start = position(word.tail, corners);
    std::vector<std::pair<Vector, Vector>> portals;
    for(FG::Input_halfedge_index crossed : word.crossed) {
      const Vector ends[3] = {corners.tail, corners.head, corners.apex};
      int side = 0;
      while(turned(corners.halfedge, side) != crossed)
        BOOST_REQUIRE(++side < 3);
      portals.emplace_back(ends[side], ends[(side + 1) % 3]);
      corners = {twin_index(crossed), ends[(side + 1) % 3], ends[side], 0};
      corners.apex = apex(twin_index(crossed), corners.tail, corners.head);
    }
    const Vector end = position(word.head, corners), direction = (end - start) / std::abs(end - start);
    Result result = {std::abs(end - start), 0};
    for(const auto& [right, left] : portals)
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

template <class Triangulation>
void check_words(const Mesh& mesh, const Triangulation& t)
{
  const Unfolding<Triangulation> unfold(mesh, t);
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges())) {
    const FG::Edge_sequence word = t.edge_sequence(h), back = t.edge_sequence(t.twin(h)).reversed();
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

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_SURFACE_POINTS_INSERTED_POINTS_H
