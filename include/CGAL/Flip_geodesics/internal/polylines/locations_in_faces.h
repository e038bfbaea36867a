// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_POLYLINES_LOCATIONS_IN_FACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_POLYLINES_LOCATIONS_IN_FACES_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/input/check_triangle.h>
#include <CGAL/Flip_geodesics/network_builders.h>

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The input faces that a canonical location lies in, each by its smallest halfedge. */
template <class Input_mesh>
std::vector<Input_halfedge_index> faces_of_location(const Input_mesh& input, const Surface_location& location)
{
  std::vector<Input_halfedge_index> result;
  const auto add = [&](Input_halfedge_index h) {
    if(input.is_border(h))
      return;
    check_triangle(input, h);
    result.push_back((std::min)({h, input.next(h), input.next(input.next(h))}));
  };
  if(kind(location) != Location_kind::VERTEX) {
    add(location.halfedge);
    if(kind(location) == Location_kind::EDGE)
      add(twin_index(location.halfedge));
    return result;
  }
  const Vertex_index v = input.tail(location.halfedge);
  Input_halfedge_index h = input.outgoing(v);
  const Input_halfedge_index first = h;
  do {
    add(h);
    h = input.next(twin_index(h)); // along the border, too
  } while(h != first);
  return result;
}

/* An input face that two canonical locations lie in; null_index if there is none. */
template <class Input_mesh>
Input_halfedge_index common_face(const Input_mesh& input, const Surface_location& p, const Surface_location& q)
{
  const std::vector<Input_halfedge_index> faces = faces_of_location(input, p);
  for(Input_halfedge_index f : faces_of_location(input, q))
    if(std::find(faces.begin(), faces.end(), f) != faces.end())
      return f;
  return null_index;
}

/* Does an edge of a triangulation lie in the closed input face of a halfedge? */
template <class Triangulation>
bool is_edge_in_face(const Triangulation& triangulation, Halfedge_index h, Input_halfedge_index face)
{
  if(triangulation.crossings(Triangulation::edge(h)) > 0)
    return false;
  const auto& input = triangulation.input();
  const auto is_side = [&](Input_halfedge_index g) {
    return g == face || g == input.next(face) || input.next(g) == face;
  };
  const Crossing_word word = triangulation.crossing_word(h);
  return word.along == null_index ? is_side(word.face) : is_side(word.along) || is_side(twin_index(word.along));
}

/* Shortest paths along those edges of a triangulation that lie in one closed input face. */
template <class Triangulation>
class Path_in_face
{
public:
  Path_in_face(const Triangulation& triangulation, Input_halfedge_index face)
    : m_triangulation(triangulation)
    , m_face(face)
  {
  }

  /* None if the edges in the face do not join the vertices. */
  std::vector<Halfedge_index> operator()(Vertex_index source, Vertex_index target) const
  {
    std::map<Vertex_index, std::pair<double, Halfedge_index>> labels = {
        {source, {0, null_index}}}; // length, last halfedge
    using Entry = std::pair<double, Vertex_index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    queue.push({0, source});
    while(!queue.empty()) {
      const auto [length, v] = queue.top();
      queue.pop();
      if(v == target)
        break;
      if(length > labels[v].first)
        continue;
      for(Halfedge_index h : spokes(m_triangulation, v)) {
        if(!is_edge_in_face(m_triangulation, h, m_face))
          continue;
        const double longer = length + m_triangulation.length(h);
        const auto [label, is_new] = labels.insert({m_triangulation.head(h), {longer, h}});
        if(!is_new && label->second.first <= longer)
          continue;
        label->second = {longer, h};
        queue.push({longer, m_triangulation.head(h)});
      }
    }
    std::vector<Halfedge_index> path;
    if(labels.count(target) != 0)
      for(Vertex_index v = target; v != source; v = m_triangulation.tail(path.back()))
        path.push_back(labels[v].second);
    std::reverse(path.begin(), path.end());
    return path;
  }

private:
  const Triangulation& m_triangulation;
  Input_halfedge_index m_face;
};

/* The input vertex with the largest weight. */
template <class Input_mesh>
Vertex_index nearest_vertex(const Input_mesh& input, const Surface_location& p)
{
  const auto nearest = (std::max_element)(p.weights.begin(), p.weights.end()) - p.weights.begin();
  const Input_halfedge_index h = p.halfedge, hn = input.next(h);
  return input.tail(nearest == 0 ? h : (nearest == 1 ? hn : input.next(hn)));
}

/* Where a curve crosses an input edge, or the place of a vertex. */
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const Surface_point& p)
{
  if(p.vertex != null_index)
    return triangulation.location(p.vertex);
  const bool is_forward = triangulation.input().uncontracted_tail(p.halfedge) == p.a;
  return {p.halfedge, {{is_forward ? 1 - p.t : p.t, is_forward ? p.t : 1 - p.t, 0}}};
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_POLYLINES_LOCATIONS_IN_FACES_H
