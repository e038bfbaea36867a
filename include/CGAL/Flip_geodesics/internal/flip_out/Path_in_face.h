// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_IN_FACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_IN_FACE_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/triangulation/spokes.h>

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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

} // namespace internal

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_IN_FACE_H
