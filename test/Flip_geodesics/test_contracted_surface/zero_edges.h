// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_CONTRACTED_SURFACE_ZERO_EDGES_H
#define FLIP_GEODESICS_TEST_CONTRACTED_SURFACE_ZERO_EDGES_H

#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

// Edges of length zero are made where nothing else changes: so what the lengths should be is known.
namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Traits = FG::Certified_intrinsic_triangulation_traits<Kernel>;
using Metric = FG::Embedded_metric<Mesh, Mesh::Property_map<Vertex, Point>>;
using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits, Metric>;
using Network = FG::Edge_path_network<Triangulation>;

inline const auto exactly = CGAL::parameters::geom_traits(Traits());

inline std::map<int, int> ring(const Mesh_soup& soup, int v)
{
  std::map<int, int> next;
  for(const Corners& t : soup.triangles)
    for(int i = 0; i < 3; ++i)
      if(t[i] == v)
        next[t[(i + 1) % 3]] = t[(i + 2) % 3];
  return next;
}

/*
 * Gives the faces at v from the edge to c counterclockwise to that to d to a new vertex in the same place, with a face
 * without area at either edge.
 */
inline int split_vertex(Mesh_soup& soup, int v, int c, int d)
{
  const int w = static_cast<int>(soup.points.size());
  const std::map<int, int> next = ring(soup, v);
  std::set<int> fan;
  for(int a = c; a != d; a = next.at(a))
    fan.insert(a);
  for(Corners& t : soup.triangles)
    for(int i = 0; i < 3; ++i)
      if(t[i] == v && fan.count(t[(i + 1) % 3]) > 0)
        t[i] = w;
  soup.points.push_back(Coordinates(soup.points[v]));
  soup.triangles.push_back({v, c, w});
  soup.triangles.push_back({w, d, v});
  return w;
}

/* Splits vertices of a closed mesh at random, also those that were split before and along zero-length edges. */
inline Mesh_soup split_at_random(Mesh_soup soup, int count, unsigned seed)
{
  Random_numbers random(seed);
  while(count > 0) {
    const int v = random.below(static_cast<int>(soup.points.size()));
    std::vector<int> outgoing_halfedges;
    for(const auto& outgoing_halfedge : ring(soup, v))
      outgoing_halfedges.push_back(outgoing_halfedge.first);
    const int c = outgoing_halfedges[random.below(static_cast<int>(outgoing_halfedges.size()))];
    const int d = outgoing_halfedges[random.below(static_cast<int>(outgoing_halfedges.size()))];
    if(c == d)
      continue;
    split_vertex(soup, v, c, d);
    --count;
  }
  return soup;
}

/* A cone without its tip, but with a hole of length zero: row 0 is n vertices in one place. */
inline Mesh_soup cone_with_hole(int n, int m, double radius, double height, int from = 0)
{
  Mesh_soup soup;
  for(int r = 0; r <= m; ++r)
    for(int i = 0; i < n; ++i)
      soup.points.push_back(
          {r * radius / m * std::cos(2 * pi * i / n), r * radius / m * std::sin(2 * pi * i / n), -r * height / m});
  for(int r = from; r < m; ++r)
    for(int i = 0; i < n; ++i) {
      const int a = n * r + i, b = n * r + (i + 1) % n;
      soup.triangles.push_back({a, a + n, b});
      soup.triangles.push_back({b, a + n, b + n});
    }
  return soup;
}

inline Vertex vertex(int v) { return Vertex(static_cast<Mesh::size_type>(v)); }

inline double length(const std::vector<Point>& points)
{
  double sum = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    sum += std::sqrt((points[i] - points[i - 1]).squared_length());
  return sum;
}

inline Triangulation contracted(const Mesh& mesh)
{
  return Triangulation(mesh, Metric(mesh.points()), Traits(), FG::Zero_length_edges::CONTRACT);
}

/* A metric for a contractor: lengths by a function, and nothing that lies folded. */
template <class Length>
struct Lengths_alone
{
  Length length;
  bool are_equally_long(FG::Input_halfedge_index g, FG::Input_halfedge_index h) const { return length(g) == length(h); }
  bool is_folded(FG::Input_halfedge_index, FG::Input_halfedge_index) const { return false; }
};
template <class Length>
Lengths_alone(Length) -> Lengths_alone<Length>;

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_CONTRACTED_SURFACE_ZERO_EDGES_H
