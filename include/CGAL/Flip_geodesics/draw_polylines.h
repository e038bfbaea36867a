// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_DRAW_POLYLINES_H
#define CGAL_FLIP_GEODESICS_DRAW_POLYLINES_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/network_builders.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* The input faces that a canonical location lies in, each by its smallest halfedge. */
template <class Input_mesh>
std::vector<Index> faces_of_location(const Input_mesh& input, const Surface_location& location)
{
  std::vector<Index> result;
  const auto add = [&](Index h) {
    if(!input.is_border(h))
      result.push_back((std::min)({h, input.next(h), input.next(input.next(h))}));
  };
  if(kind(location) != Location_kind::VERTEX) {
    add(location.halfedge);
    if(kind(location) == Location_kind::EDGE)
      add(twin_index(location.halfedge));
    return result;
  }
  const Index v = input.tail(location.halfedge);
  Index h = input.outgoing(v);
  const Index first = h;
  do {
    add(h);
    h = input.next(twin_index(h)); // along the border, too
  } while(h != first);
  return result;
}

/* An input face that two canonical locations lie in; null_index if there is none. */
template <class Input_mesh>
Index common_face(const Input_mesh& input, const Surface_location& p, const Surface_location& q)
{
  const std::vector<Index> faces = faces_of_location(input, p);
  for(Index f : faces_of_location(input, q))
    if(std::find(faces.begin(), faces.end(), f) != faces.end())
      return f;
  return null_index;
}

/* Shortest paths along those edges of a triangulation that lie in one closed input face. */
template <class Triangulation>
class Path_in_face
{
public:
  Path_in_face(const Triangulation& triangulation, Index face)
    : m_triangulation(triangulation)
    , m_face(face)
  {
  }

  /* None if the edges in the face do not join the vertices. */
  std::vector<Index> operator()(Index source, Index target) const
  {
    std::map<Index, std::pair<double, Index>> labels = {{source, {0, null_index}}}; // length, last halfedge
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    queue.push({0, source});
    while(!queue.empty()) {
      const auto [length, v] = queue.top();
      queue.pop();
      if(v == target)
        break;
      if(length > labels[v].first)
        continue;
      for(Index h : spokes(m_triangulation, v)) {
        if(!is_in_face(h))
          continue;
        const double longer = length + m_triangulation.length(h);
        const auto [label, is_new] = labels.insert({m_triangulation.head(h), {longer, h}});
        if(!is_new && label->second.first <= longer)
          continue;
        label->second = {longer, h};
        queue.push({longer, m_triangulation.head(h)});
      }
    }
    std::vector<Index> path;
    if(labels.count(target) != 0)
      for(Index v = target; v != source; v = m_triangulation.tail(path.back()))
        path.push_back(labels[v].second);
    std::reverse(path.begin(), path.end());
    return path;
  }

private:
  bool is_in_face(Index h) const
  {
    if(m_triangulation.crossings(Triangulation::edge(h)) > 0)
      return false;
    const Crossing_word word = m_triangulation.crossing_word(h);
    return word.along == null_index ? is_of_face(word.face)
                                    : is_of_face(word.along) || is_of_face(Triangulation::twin(word.along));
  }

  bool is_of_face(Index h) const
  {
    const auto& input = m_triangulation.input();
    return h == m_face || h == input.next(m_face) || input.next(h) == m_face;
  }

  const Triangulation& m_triangulation;
  Index m_face;
};

template <class Input_mesh>
std::vector<Surface_location> canonical_polyline(const Input_mesh& input, const std::vector<Surface_location>& polyline,
                                                 bool is_closed)
{
  std::vector<Surface_location> result;
  for(const Surface_location& location : polyline)
    result.push_back(canonical_location(input, location));
  if(result.size() < (is_closed ? 3u : 2u))
    throw Invalid_curve_error("a polyline needs two points, a closed one three");
  if(is_closed)
    result.push_back(result.front());
  for(std::size_t i = 0; i + 1 < result.size(); ++i)
    if(common_face(input, result[i], result[i + 1]) == null_index)
      throw Invalid_curve_error("points " + std::to_string(i) + " and " + std::to_string(i + 1) +
                                    " of a polyline do not lie in a common face",
                                {i, i + 1});
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Draws a polyline that runs anywhere on the mesh into a network, by making its points vertices [SC20, Figure 9]: a curve
 * whose nodes are fixed at all its points. `shorten()` then makes it the very polyline, since each segment is the only
 * geodesic in its face; `Edge_path_network::free_nodes()` lets it be pulled tight.
 *
 * The segments start out as paths of edges in their input faces. So polylines may be drawn one after another; those that
 * cross themselves or others are told from the rest by `order_overlapping_curves()`.
 *
 * \param polyline the points; each two in a row lie in a common face or on a common edge of the input. A closed polyline
 *        does not repeat the first. Points that repeat the one before are skipped.
 * \return the curve's index
 * \pre no edge of the triangulation in these faces crosses an input edge
 * \throws Invalid_curve_error if two points in a row are in no common face, or there are too few
 * \throws Invalid_location_error, and as `Edge_path_network::insert()`
 */
template <class Network>
Index draw_polyline(Network& network, const std::vector<Surface_location>& polyline, bool is_closed = false)
{
  auto& triangulation = network.triangulation();
  const auto points = internal::canonical_polyline(triangulation.input(), polyline, is_closed);
  std::vector<Index> vertices;
  for(const Surface_location& point : points)
    vertices.push_back(network.insert(point));
  std::vector<Index> chain, nodes;
  for(std::size_t i = 0; i + 1 < points.size(); ++i) {
    if(vertices[i] == vertices[i + 1])
      continue;
    const Index face = internal::common_face(triangulation.input(), points[i], points[i + 1]);
    const auto leg =
        internal::Path_in_face<typename Network::Triangulation>(triangulation, face)(vertices[i], vertices[i + 1]);
    CGAL_precondition_msg(!leg.empty(), "the triangulation's edges cross those of the input");
    chain.insert(chain.end(), leg.begin(), leg.end());
    nodes.push_back(static_cast<Index>(chain.size()) - 1);
  }
  const Index curve = network.add_curve(chain, is_closed);
  Index position = 0;
  std::size_t next = 0;
  network.for_each_segment(curve, [&](Index s) {
    if(next < nodes.size() && position == nodes[next]) {
      network.set_head_fixed(s, true);
      ++next;
    }
    ++position;
  });
  return curve;
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The vertices of a path of input edges in the isotopy class of a polyline: each point on an edge moves to its nearer
 * end, and so do the ends of an open polyline. No vertex is added, and the path ends at vertices of the mesh.
 *
 * \param polyline as for `draw_polyline()`
 * \return the vertices of the path, for `halfedges_through()`; fewer than two if the polyline shrinks to a vertex. A
 *         closed path does not repeat the first.
 * \throws Invalid_curve_error, Invalid_location_error as `draw_polyline()`
 */
template <class Triangulation>
std::vector<Index> snap_polyline(const Triangulation& triangulation, const std::vector<Surface_location>& polyline,
                                 bool is_closed = false)
{
  const auto& input = triangulation.input();
  const auto points = internal::canonical_polyline(input, polyline, is_closed);
  std::vector<Index> path;
  for(std::size_t i = 0; i + (is_closed ? 1 : 0) < points.size(); ++i) {
    const Surface_location& p = points[i];
    const bool is_end = !is_closed && (i == 0 || i + 1 == points.size());
    if(kind(p) == Location_kind::FACE && !is_end)
      continue; // the path crosses the face from one of its vertices to another
    const auto nearest = (std::max_element)(p.weights.begin(), p.weights.end()) - p.weights.begin();
    const Index h = nearest == 0 ? p.halfedge
                                 : (nearest == 1 ? input.next(p.halfedge) : input.next(input.next(p.halfedge)));
    const Index v = input.tail(h);
    if(!path.empty() && path.back() == v)
      continue;
    if(path.size() > 1 && path[path.size() - 2] == v)
      path.pop_back(); // to and fro
    else
      path.push_back(v);
  }
  while(is_closed && path.size() > 1 && path.front() == path.back())
    path.pop_back();
  return path;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_DRAW_POLYLINES_H
