// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SOURCE_DIRECTIONS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SOURCE_DIRECTIONS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Field_query.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_propagation.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* The direction in which a path starts, of any length, in the frame of a halfedge that has the first face on its left
 * or is the border edge along which the path starts; if the source is a vertex, the halfedge starts there. */
struct Start_direction
{
  Input_halfedge_index first = null_index;
  std::complex<double> direction;
};

/* The last straight part of a shortest path: from the vertex at which it bends last, or from its source. */
struct Straight_leg
{
  Index root = null_index;    // its start, as in windows: a vertex, or a part of a source
  Input_halfedge_index first; // of the face in which it starts; starts at the vertex, if any
  Input_halfedge_index last;  // of the face in which it ends
  std::complex<double> start; // from start to end, in the frame of `first`
  std::complex<double> end;   // the same in the frame of `last`
};

/*
 * The directions in which shortest paths from one point to vertices start, computed from the data that a propagation
 * stores for each vertex; and the last segments of the paths to vertices and, if the propagation stores all windows, to
 * points in faces. A path that bends starts like the path to the vertex at which it bends last, its root. A straight
 * path is followed back through the faces that the rays of its window have crossed. Only the angle between the frames
 * of its first face and its last one is required:
 *
 *               . source              the frame of side h is rotated relative to that of side g
 *              ' .                    by the angle between the two sides
 *       ------g---'-.--
 *       \         ' .
 *        \       h ' .
 *         \     /   ' target
 *
 * The ray in the middle of the window is followed, which keeps away from vertices. Since rays to many vertices cross
 * the same faces, the angle is stored for part of the edges, with the position of the source in the frame of the edge,
 * and a walk ends where it is known. The cost is at most proportional to the number of windows.
 */
template <class Triangulation>
class Source_directions
{
  using Query = Field_query<Triangulation>;
  using Propagation = Window_propagation<Triangulation>;
  using Vector = std::complex<double>;

public:
  /* \pre the source of the field is one point */
  explicit Source_directions(const Query& query)
    : m_query(query)
    , m_input(query.triangulation().input())
    , m_propagation(query.propagation())
    , m_starts(static_cast<std::size_t>(m_input.number_of_vertices()))
  {
  }

  /* Returns nothing if rounding errors hide the origin of the windows. \pre the vertex is reached, and is not the
   * source */
  std::optional<Start_direction> operator()(Vertex_index v)
  {
    m_bends.clear();
    while(m_starts[v].first == null_index && bends(v)) {
      m_bends.push_back(v);
      v = Vertex_index(m_propagation.vertex(v).root);
    }
    if(m_starts[v].first == null_index)
      m_starts[v] = straight(v);
    for(Vertex_index w : m_bends)
      m_starts[w] = m_starts[v];
    return m_starts[v].first == null_index ? std::nullopt : std::optional(m_starts[v]);
  }

  /* Returns the last segment to a vertex; nothing if its window does not contain the ray to it. \pre it is reached, and
   * is not the source */
  std::optional<Straight_leg> leg(Vertex_index v)
  {
    const Vertex_record& record = m_propagation.vertex(v);
    if(record.along != null_index)
      return leg_along_edge(record);
    if(record.through == null_index) {
      const Start_direction start = inside_face(v, m_propagation.part(record.root));
      return leg_in_face(record.root, start.first, start.direction);
    }
    const Face_side f = side(record.through);
    return leg_through_side(record.through, record.window, {f.x, f.y});
  }

  /* Returns the last segment to a point of the face of h. \pre the propagation stores its windows */
  std::optional<Straight_leg> leg(Input_halfedge_index h, const Face_weights& weights)
  {
    const typename Query::Arrival a = m_query(h, weights);
    if(a.root == null_index)
      return std::nullopt;
    if(a.through != null_index)
      return leg_through_side(a.through, a.window, position(side(a.through), m_query.turned(weights, h, a.through)));
    const Input_halfedge_index first = m_propagation.is_part(a.root) ? m_propagation.part(a.root).halfedge
                                                                     : side_from(m_input, h, Vertex_index(a.root));
    const Face_side f = side(first);
    const Face_weights from = m_query.turned(m_query.from(a, h, weights), h, first);
    return leg_in_face(a.root, first, position(f, m_query.turned(weights, h, first)) - position(f, from));
  }

private:
  // Rays that come from the source through side h. Vectors are in the frame of h, with the source below.
  struct Rays
  {
    Input_halfedge_index h;
    Vector source, ray; // the position of the source, and the direction of one of the rays
    Vector turn;        // converts directions from there to the frame of the requested side
  };

  // The first face, and the rotation that converts directions from the frame of a side to its frame.
  struct First_face
  {
    Input_halfedge_index first;
    Vector turn;
  };

  struct Known_rays
  {
    Vector source;
    First_face face;
  };

  Face_side side(Input_halfedge_index h) const { return m_propagation.sides().copy(h); }

  // Returns whether the path to a vertex bends on its way.
  bool bends(Vertex_index v) const
  {
    const Index root = m_propagation.vertex(v).root;
    return !m_propagation.is_part(root) && !m_propagation.vertex(Vertex_index(root)).is_source;
  }

  static std::optional<Straight_leg> leg_in_face(Index root, Input_halfedge_index h, const Vector& way)
  {
    return std::norm(way) > 0 ? std::optional(Straight_leg{root, h, h, way, way}) : std::nullopt;
  }

  std::optional<Straight_leg> leg_along_edge(const Vertex_record& record) const
  {
    if(!m_input.is_border(record.along))
      return leg_in_face(record.root, record.along, side(record.along).length);
    const Input_halfedge_index first = m_input.next(twin_index(record.along)); // starts at the root
    const Face_side f = side(first);
    return leg_in_face(record.root, first, {f.x, f.y});
  }

  std::optional<Straight_leg> leg_through_side(Input_halfedge_index through, const Window& w, const Vector& place)
  {
    const double crossing = w.crossing(place.real(), place.imag()),
                 equal = unfolded_place_error * (std::abs(crossing) + side(through).length);
    if(w.is_far || !(crossing >= w.from - equal && crossing <= w.to + equal))
      return std::nullopt;
    const Vector way = place - Vector(w.x, -w.y);
    const auto face = first_face(through, w, std::abs(way));
    return face ? std::optional(Straight_leg{w.root, face->first, through, product(way, face->turn), way})
                : std::nullopt;
  }

  // For a path that does not bend.
  Start_direction straight(Vertex_index v)
  {
    const Vertex_record& record = m_propagation.vertex(v);
    if(record.along != null_index)
      return {record.along, 1};
    if(record.through == null_index)
      return inside_face(v, m_propagation.part(record.root));
    const Window& w = record.window;
    const Face_side f = side(record.through);
    const Vector way = Vector(f.x, f.y) - Vector(w.x, -w.y);
    const auto face = first_face(record.through, w, std::abs(way));
    return face ? Start_direction{face->first, product(way, face->turn)} : Start_direction();
  }

  Start_direction inside_face(Vertex_index v, const Source_part& source) const
  {
    const Face_weights corner = m_query.turned({{1, 0, 0}}, side_from(m_input, source.halfedge, v), source.halfedge);
    const Face_side f = side(source.halfedge);
    return {source.halfedge, position(f, corner) - position(f, source.ends[0])};
  }

  // Follows the rays of a window, in the frame of side h, back to its root, across at most as many edges as there are
  // windows. The length is that of the whole ray.
  std::optional<First_face> first_face(Input_halfedge_index h, const Window& w, double length)
  {
    const Vector source(w.x, -w.y), middle((w.from + w.to) / 2, 0);
    Rays rays = {h, source, middle - source, 1};
    const double allowed = unfolded_place_error * length;
    std::optional<First_face> result;
    m_passed.clear();
    for(std::size_t i = 0; i < m_propagation.number_of_windows() && !result; ++i) {
      if(m_input.is_border(twin_index(rays.h)))
        return std::nullopt;
      result = cross_backward(rays, w.root, allowed);
      if(!result && !(rays.source.imag() < 0))
        return std::nullopt;
      if(!result && is_kept(rays.h) && !(result = known(rays, allowed)))
        m_passed.push_back(rays);
    }
    if(!result)
      return std::nullopt;
    result->turn = product(rays.turn, result->turn);
    for(const Rays& r : m_passed)
      m_known.insert({{r.h, r.source.real()}, {r.source, {result->first, product(std::conj(r.turn), result->turn)}}});
    return result;
  }

  // Propagates rays backward over the face below to the side by which they enter it; returns that face if they start in
  // it, in which case the rotation of the rays leads to its frame.
  std::optional<First_face> cross_backward(Rays& rays, Index root, double allowed) const
  {
    const Input_halfedge_index t = twin_index(rays.h);
    const Face_side f = side(t);
    const Input_halfedge_index tp = m_input.next(f.next);
    const Vector apex(f.x, f.y);
    rays = {t, f.length - rays.source, -rays.ray, -rays.turn};
    if(const auto place = place_of_root(t, f, root); place && std::abs(*place - rays.source) <= allowed)
      return m_propagation.is_part(root) ? First_face{t, 1}
                                         : First_face{tp, -std::conj(apex) / std::sqrt(std::norm(apex))};
    const bool is_next = cross(apex - rays.source, rays.ray) > 0;
    const Vector start = is_next ? Vector(f.length) : apex, along = is_next ? apex - f.length : -apex;
    const Vector turn = std::conj(along) / std::sqrt(std::norm(along));
    rays = {is_next ? f.next : tp, product(rays.source - start, turn), product(rays.ray, turn),
            product(rays.turn, turn)};
    return std::nullopt;
  }

  // The position in the frame of side t of a face, if the root is in the face and not on that side.
  std::optional<Vector> place_of_root(Input_halfedge_index t, const Face_side& f, Index root) const
  {
    const Input_halfedge_index tp = m_input.next(f.next);
    if(!m_propagation.is_part(root))
      return m_input.tail(tp).idx() == root ? std::optional(Vector(f.x, f.y)) : std::nullopt;
    const Source_part& source = m_propagation.part(root);
    if(source.halfedge != t && source.halfedge != f.next && source.halfedge != tp)
      return std::nullopt;
    return position(f, m_query.turned(source.ends[0], source.halfedge, t));
  }

  // One edge in sixteen, independent of their order.
  static bool is_kept(Input_halfedge_index h)
  {
    return static_cast<std::uint32_t>(h.idx()) * std::uint32_t(2654435769) >> 28 == 0;
  }

  std::optional<First_face> known(const Rays& rays, double allowed) const
  {
    const double x = rays.source.real();
    for(auto i = m_known.lower_bound({rays.h, x - allowed});
        i != m_known.end() && i->first.first == rays.h && i->first.second <= x + allowed; ++i)
      if(std::abs(i->second.source - rays.source) <= allowed)
        return i->second.face;
    return std::nullopt;
  }

  const Query m_query;
  const typename Triangulation::Input_mesh& m_input;
  const Propagation& m_propagation;
  Indexed_by<Vertex_index, std::vector<Start_direction>> m_starts;
  std::vector<Vertex_index> m_bends;                                          // on the way to a vertex
  std::vector<Rays> m_passed;                                                 // where they must be stored
  std::multimap<std::pair<Input_halfedge_index, double>, Known_rays> m_known; // by the first coordinate of the source
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SOURCE_DIRECTIONS_H
