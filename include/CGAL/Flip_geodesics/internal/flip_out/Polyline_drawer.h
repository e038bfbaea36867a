// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_POLYLINE_DRAWER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_POLYLINE_DRAWER_H

#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_in_face.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Segment_insertion.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/locations_in_faces.h>
#include <CGAL/Flip_geodesics/internal/triangulation/spokes.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Point_side.h>
#include <CGAL/Flip_geodesics/network_builders.h>

#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A curve along edges of a triangulation. */
struct Drawn_chain
{
  std::vector<Halfedge_index> halfedges;
  std::vector<std::size_t> nodes; // ascending positions of the halfedges at whose heads the curve is to be fixed
};

/* Adds a curve that is fixed at the nodes of a chain. */
template <class Network>
Curve_index add_chain(Network& network, const Drawn_chain& chain, bool is_closed)
{
  const Curve_index curve = network.add_curve(chain.halfedges, is_closed);
  std::size_t position = 0;
  auto node = chain.nodes.begin();
  network.for_each_segment(curve, [&](Segment_index s) {
    if(node != chain.nodes.end() && position++ == *node) {
      network.set_head_fixed(s, true);
      ++node;
    }
  });
  return curve;
}

/* Sides of lines within one closed input face, exactly: vertices of a triangulation by their weights in the face. */
template <class Triangulation>
class Vertices_in_face
{
  using Weights = std::array<double, 3>;

public:
  Vertices_in_face(const Triangulation& triangulation, Input_halfedge_index face)
    : m_triangulation(triangulation)
    , m_face(face)
  {
  }

  Input_halfedge_index face() const { return m_face; }

  /* The side of the line from p to q on which r lies, POSITIVE on the left. */
  Sign side(Vertex_index p, Vertex_index q, Vertex_index r) const
  {
    return orientation_of_weights(weights(p), weights(q), weights(r));
  }

  /* Does r lie on the ray from p through q? Then they are on one side of a line through p and a corner of the face. */
  bool is_on_ray(Vertex_index p, Vertex_index q, Vertex_index r) const
  {
    if(r == q)
      return true;
    if(side(p, q, r) != ZERO)
      return false;
    for(const Weights& corner : {Weights{{1, 0, 0}}, Weights{{0, 1, 0}}, Weights{{0, 0, 1}}})
      if(const Sign of_q = orientation_of_weights(weights(p), corner, weights(q)); of_q != ZERO)
        return orientation_of_weights(weights(p), corner, weights(r)) == of_q;
    return false; // p and q are in one place
  }

private:
  Weights weights(Vertex_index v) const { return vertex_weights(m_triangulation, v, m_face); }

  const Triangulation& m_triangulation;
  Input_halfedge_index m_face;
};

/*
 * Makes the points of a polyline vertices of a network's triangulation, and its segments edges: exactly those segments,
 * on the same sides of all other points. The edges that a segment crosses are flipped, as in a constrained
 * triangulation of its input face. A segment that passes a vertex consists of several edges.
 *
 * Edges that curves lie on cannot be flipped: then the segment crosses the curve.
 */
template <class Network>
class Polyline_drawer
{
  using Triangulation = typename Network::Triangulation;

public:
  explicit Polyline_drawer(Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
  {
  }

  /* Draws a polyline of canonical locations, each two in a row in a common face. Points in one place count once. */
  Drawn_chain operator()(const std::vector<Surface_location>& points)
  {
    std::vector<Vertex_index> vertices;
    for(const Surface_location& point : points)
      vertices.push_back(m_network.insert(point));
    Drawn_chain result;
    for(std::size_t i = 0; i + 1 < points.size(); ++i) {
      if(vertices[i] == vertices[i + 1])
        continue;
      draw_segment({m_triangulation, common_face(m_triangulation.input(), points[i], points[i + 1])}, vertices[i],
                   vertices[i + 1], result.halfedges);
      result.nodes.push_back(result.halfedges.size() - 1);
    }
    return result;
  }

private:
  using Face = Vertices_in_face<Triangulation>;

  void draw_segment(const Face& face, Vertex_index source, Vertex_index target, std::vector<Halfedge_index>& chain)
  {
    for(Vertex_index v = source; v != target; v = m_triangulation.head(chain.back())) {
      const Halfedge_index along = halfedge_along(face, v, target);
      std::vector<Halfedge_index> edges(1, along);
      if(along == null_index) {
        edges = left_side_of_strip(m_triangulation, free_strip(face, v, target));
        straighten_on_the_right(m_triangulation, edges);
      }
      for(Halfedge_index h : edges)
        m_drawn.insert(Triangulation::edge(h));
      chain.insert(chain.end(), edges.begin(), edges.end());
    }
  }

  bool is_in_face(const Face& face, Halfedge_index h) const { return is_edge_in_face(m_triangulation, h, face.face()); }

  // The edge that leads from v straight to the target, or to a vertex on the way; null_index if there is none.
  Halfedge_index halfedge_along(const Face& face, Vertex_index v, Vertex_index target) const
  {
    for(Halfedge_index h : spokes(m_triangulation, v))
      if(is_in_face(face, h) && face.is_on_ray(v, target, m_triangulation.head(h)))
        return h;
    return null_index;
  }

  // What the segment from v to the target crosses up to the next vertex on it, each as a side of the face that is left.
  std::vector<Halfedge_index> free_strip(const Face& face, Vertex_index v, Vertex_index target) const
  {
    std::vector<Halfedge_index> crossed(1, first_crossed(face, v, target));
    for(;;) {
      check_is_free(crossed.back());
      const Halfedge_index entered = Triangulation::twin(crossed.back());
      if(!is_face_in_face(face, entered) ||
         crossed.size() > static_cast<std::size_t>(m_triangulation.number_of_edges()))
        throw_wrong_flips(face.face());
      const Halfedge_index next = m_triangulation.next(entered);
      const Sign side = face.side(v, target, m_triangulation.head(next));
      if(side == ZERO)
        return crossed;
      crossed.push_back(side == POSITIVE ? next : m_triangulation.next(next));
    }
  }

  // The side opposite to v in the face that holds the start of the segment.
  Halfedge_index first_crossed(const Face& face, Vertex_index v, Vertex_index target) const
  {
    for(Halfedge_index h : spokes(m_triangulation, v)) {
      if(!is_face_in_face(face, h))
        continue;
      const Halfedge_index opposite = m_triangulation.next(h);
      const Vertex_index right = m_triangulation.head(h), left = m_triangulation.head(opposite);
      if(face.side(v, target, right) == NEGATIVE && face.side(v, target, left) == POSITIVE &&
         face.side(v, right, left) == POSITIVE) // not the other face of two that share all sides
        return opposite;
    }
    throw_wrong_flips(face.face());
  }

  bool is_face_in_face(const Face& face, Halfedge_index h) const
  {
    if(m_triangulation.is_border(h))
      return false;
    const Halfedge_index hn = m_triangulation.next(h);
    return is_in_face(face, h) && is_in_face(face, hn) && is_in_face(face, m_triangulation.next(hn));
  }

  void check_is_free(Halfedge_index h) const
  {
    if(m_triangulation.holds(Triangulation::edge(h)) == 0 && m_drawn.count(Triangulation::edge(h)) == 0)
      return;
    const Vertex_index v = m_triangulation.tail(h), w = m_triangulation.head(h);
    throw Crossing_curves_error("a segment of a polyline crosses a curve between vertex " + std::to_string(v.idx()) +
                                    " and vertex " + std::to_string(w.idx()),
                                {static_cast<std::size_t>(v.idx()), static_cast<std::size_t>(w.idx())});
  }

  Network& m_network;
  Triangulation& m_triangulation;
  std::set<Edge_index> m_drawn; // by this polyline
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_POLYLINE_DRAWER_H
