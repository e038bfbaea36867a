// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Meshes of all kinds, and what a triangulation of one is compared by.

#ifndef FLIP_GEODESICS_TEST_INTRINSIC_TRIANGULATION_SNAPSHOTS_H
#define FLIP_GEODESICS_TEST_INTRINSIC_TRIANGULATION_SNAPSHOTS_H

#include "Double_triangulation.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "lawson.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/internal/shortest/geodesic_tree_parts.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_history.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_sequence_path.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
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

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;
using FG::internal::descriptors;
using FG::internal::twin_index;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = Double_triangulation<Mesh>;
using Edge = boost::graph_traits<Mesh>::edge_descriptor;
using Length_map = boost::associative_property_map<std::map<Edge, double>>;
using Length_metric = FG::Edge_length_metric<Mesh, Length_map>;
using Length_triangulation =
    FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<Length_metric::Kernel>, Length_metric>;

inline std::vector<Mesh_soup> soups()
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

inline std::vector<int> connectivity(const Triangulation& t)
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

using Vector = std::complex<long double>;

// The lengths of the sides of the input face left of h, in long double from the coordinates.
inline long double input_length(const Mesh& mesh, const Triangulation& t, FG::Input_halfedge_index h)
{
  const Point p = mesh.point(t.vertex(t.input().tail(h))), q = mesh.point(t.vertex(t.input().tail(twin_index(h))));
  const long double x = (long double)q.x() - p.x(), y = (long double)q.y() - p.y(), z = (long double)q.z() - p.z();
  return std::sqrt(x * x + y * y + z * z);
}

// The third point of the input face on the left of h when h leads from a to b in the plane.
inline Vector apex(const Mesh& mesh, const Triangulation& t, FG::Input_halfedge_index h, Vector a, Vector b)
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

inline Unfolded unfold(const Mesh& mesh, const Triangulation& t, const FG::Edge_sequence& word)
{
  if(word.along != FG::null_index)
    return {input_length(mesh, t, word.along), 0};
  // The first crossed edge, from right to left as the traveller sees it, and the tail on its left side.
  const FG::Input_halfedge_index first = word.crossed.front();
  Vector right = 0, left = input_length(mesh, t, first);
  const Vector tail = apex(mesh, t, first, right, left);
  std::vector<std::pair<Vector, Vector>> portals;
  for(std::size_t i = 0;; ++i) {
    portals.emplace_back(right, left);
    const FG::Input_halfedge_index entered = twin_index(word.crossed[i]); // from left to right
    const Vector next = apex(mesh, t, entered, left, right);
    if(i + 1 == word.crossed.size()) {
      Unfolded result = {std::abs(next - tail), 0};
      const Vector direction = (next - tail) / result.length;
      for(const auto& [r, l] : portals) {
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

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_INTRINSIC_TRIANGULATION_SNAPSHOTS_H
