// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_PLACE_H
#define CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_PLACE_H

#include "checker_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace polyline_checker {

/*
 * A place of the surface where a segment may start or end: the vertex a, if a == b; the point (1 - t) a + t b of an
 * edge, if c == b; else (1 - t - u) a + t b + u c, in the face with the corners a, b, c counterclockwise.
 */
struct Place
{
  Index a = null_index, b = null_index, c = null_index;
  double t = 0, u = 0;

  static Place vertex(Index v) { return {v, v, v, 0, 0}; }
  static Place on_edge(Index a, Index b, double t) { return {a, b, b, t, 0}; }

  bool is_vertex() const { return a == b; }
  bool is_on_edge() const { return a != b && b == c; }
  bool is_in_face() const { return a != b && b != c; }

  friend bool operator<(const Place& p, const Place& q)
  {
    return std::tie(p.a, p.b, p.c, p.t, p.u) < std::tie(q.a, q.b, q.c, q.t, q.u);
  }
  friend bool operator==(const Place& p, const Place& q) { return !(p < q) && !(q < p); }
};

/// The barycentric coordinate of a place that belongs to vertex v.
template <class NT>
NT weight(const Place& place, Index v)
{
  if(v == place.a)
    return place.is_vertex() ? NT(1) : NT(1) - NT(place.t) - NT(place.u);
  if(v == place.b)
    return NT(place.t);
  return v == place.c ? NT(place.u) : NT(0);
}

/// Do they have the same coordinates, up to the rounding of who has written them?
inline bool is_same_place(const Place& p, const Place& q)
{
  for(Index v : {p.a, p.b, p.c, q.a, q.b, q.c})
    if(!(std::fabs(weight<long double>(p, v) - weight<long double>(q, v)) <= 1e-15L))
      return false;
  return true;
}

/// What is wrong with a place, nothing if it is right.
inline std::string place_error(const Mesh& mesh, const Place& place)
{
  for(Index v : {place.a, place.b, place.c})
    if(v >= mesh.number_of_vertices())
      return "there is no such vertex";
  if(place.is_on_edge() && !mesh.is_edge(place.a, place.b))
    return "there is no edge from " + std::to_string(place.a) + " to " + std::to_string(place.b);
  if(place.is_in_face() && mesh.halfedge_of_face(place.a, place.b, place.c) == null_index)
    return "there is no face with these corners in this order";
  const bool is_inside =
      place.is_vertex() ? place.t == 0 && place.u == 0
                        : place.t > 0 && (place.is_in_face() ? place.u > 0 : place.u == 0) && place.t + place.u < 1;
  return is_inside ? std::string() : "t and u are not coordinates of a point inside";
}

/// Does a place lie in the closed face of halfedge h?
inline bool lies_in_face(const Mesh& mesh, Index h, const Place& place)
{
  const auto has = [&](Index v) {
    return mesh.vertex(h) == v || mesh.vertex(Mesh::next(h)) == v || mesh.vertex(Mesh::previous(h)) == v;
  };
  if(place.is_in_face())
    return mesh.halfedge_of_face(place.a, place.b, place.c) / 3 == h / 3;
  return has(place.a) && has(place.b);
}

/// Does it lie there, and not on the edge of h?
inline bool lies_beyond(const Mesh& mesh, Index h, const Place& place)
{
  const Index apex = mesh.vertex(Mesh::previous(h));
  return lies_in_face(mesh, h, place) && (apex == place.a || apex == place.b || apex == place.c);
}

/// A halfedge of a face, or along an edge, that both places lie in; `null_index` if there is none.
inline Index common_halfedge(const Mesh& mesh, const Place& p, const Place& q)
{
  std::vector<Index> vertices = {p.a, p.b, p.c, q.a, q.b, q.c};
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  if(vertices.size() < 2 || vertices.size() > 3)
    return null_index;
  for(const Index h : {mesh.halfedge(vertices[0], vertices[1]), mesh.halfedge(vertices[1], vertices[0])})
    if(h != null_index && lies_in_face(mesh, h, p) && lies_in_face(mesh, h, q))
      return h;
  return null_index;
}

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_PLACE_H
