// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FIELD_QUERY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FIELD_QUERY_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_propagation.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Returns the side of the face of h that starts at one of its vertices. */
template <class Input>
Input_halfedge_index side_from(const Input& input, Input_halfedge_index h, Vertex_index v)
{
  while(input.tail(h) != v)
    h = input.next(h);
  return h;
}

/* Returns the roots of parts of sources sorted by the smallest halfedges of their faces. */
template <class Input>
std::vector<std::pair<Input_halfedge_index, Index>> parts_by_face(const Input& input,
                                                                  const std::vector<Source_part>& parts)
{
  std::vector<std::pair<Input_halfedge_index, Index>> result;
  for(std::size_t i = 0; i < parts.size(); ++i)
    result.emplace_back(least_in_face(input, parts[i].halfedge), input.number_of_vertices() + static_cast<Index>(i));
  std::sort(result.begin(), result.end());
  return result;
}

/*
 * Evaluates the windows stored by a propagation at any point: a shortest path to a point of a face comes from a corner,
 * from a part of a source in the face, or through a window on one of its sides.
 */
template <class Triangulation>
class Field_query
{
  using Vector = std::complex<double>;
  using Propagation = Window_propagation<Triangulation>;

public:
  /* The end of a shortest path in a face. */
  struct Arrival
  {
    double distance = std::numeric_limits<double>::infinity();
    Index root = null_index;                   // as in windows
    Input_halfedge_index through = null_index; // the side of entrance into the face; null_index if from the root
    double crossing = 0;                       // the position from the tail of that side
    Window window;                             // in the frame of that side
  };

  /* \param parts_by_face see `parts_by_face()` */
  Field_query(const Triangulation& triangulation, const Propagation& propagation,
              const std::vector<std::pair<Input_halfedge_index, Index>>& parts_by_face)
    : m_triangulation(triangulation)
    , m_propagation(propagation)
    , m_parts_by_face(parts_by_face)
  {
  }

  const Triangulation& triangulation() const { return m_triangulation; }
  const Propagation& propagation() const { return m_propagation; }

  /* \pre h is not on the border; the weights sum to one */
  Arrival operator()(Input_halfedge_index h, const Face_weights& weights) const
  {
    return arrival(h, weights, false, [](Index) { return true; });
  }

  std::size_t source(const Arrival& a) const { return m_propagation.source(a.root); }

  /* Returns whether all possible shortest paths to a point of the face of h come from one source. */
  bool has_one_source(Input_halfedge_index h) const
  {
    Index last = null_index; // root
    std::size_t source = 0;
    bool result = true;
    const auto add = [&](Index root) {
      if(root == last)
        return;
      const std::size_t next = m_propagation.source(root);
      result = result && (last == null_index || next == source);
      last = root;
      source = next;
    };
    for_each_part(h, add);
    for(int i = 0; i < 3 && result; ++i, h = m_triangulation.input().next(h)) {
      const Vertex_index v = m_triangulation.input().tail(h);
      if(m_propagation.is_reached(v))
        add(v.idx());
      for(const Window& w : m_propagation.windows().on_edge(h.idx() / 2))
        if((w.side == 0) == is_first_side(h))
          add(w.root);
    }
    return result;
  }

  /* Returns the point of the same face from which the path comes straight: its entry point, or the source; as weights
   * from h. */
  Face_weights from(const Arrival& a, Input_halfedge_index h, const Face_weights& weights) const
  {
    if(a.through != null_index) {
      const double t = a.crossing / m_propagation.sides().copy(a.through).length;
      return turned({{1 - t, t, 0}}, a.through, h);
    }
    if(m_propagation.is_part(a.root)) {
      const Source_part& p = m_propagation.part(a.root);
      const double t = p.nearest(m_propagation.sides().copy(p.halfedge), turned(weights, h, p.halfedge));
      return turned(p.at(t), p.halfedge, h);
    }
    return turned({{1, 0, 0}}, side_from(m_triangulation.input(), h, Vertex_index(a.root)), h);
  }

  /* Returns the direction away from the source, in the frame of h; zero at the source. */
  Vector direction(const Arrival& a, Input_halfedge_index h, const Face_weights& weights) const
  {
    const Face_side f = m_propagation.sides().copy(h);
    const Vector line = position(f, weights) - position(f, from(a, h, weights));
    if(a.through == null_index || std::abs(line) > near_edge_of_face * f.length)
      return std::abs(line) > zero_weight * (f.length + std::abs(f.x) + f.y) ? line / std::abs(line) : Vector(0);
    // On the edge through which the path comes: the direction of the ray, rotated into the frame of h.
    const Window& w = a.window;
    const Vector ray = w.is_far ? Vector(-w.x, w.y) : Vector(a.crossing - w.x, w.y);
    const Face_weights tail = turned({{1, 0, 0}}, a.through, h), head = turned({{0, 1, 0}}, a.through, h);
    const Vector axis = position(f, head) - position(f, tail);
    return ray / std::abs(ray) * (axis / std::abs(axis));
  }

  /* Writes the points of the path to a vertex that is not a source, excluding that vertex, backward up to the
   * source. */
  template <class OutputIterator>
  OutputIterator path(Vertex_index v, OutputIterator out) const
  {
    const Arrival a = arrival(v);
    return path(a, last_face(v, a), {{1, 0, 0}}, out);
  }

  /*
   * Writes the points of the path to a point of a face, excluding that point, backward up to the source. At each
   * crossed edge, the arrival is evaluated again, so that the path is not lost if it passes a vertex within rounding
   * errors. If another source is equally near, the path continues to that of the arrival. The path can cross an edge
   * any number of times if the edge is not a shortest path; but the distances of its points decrease.
   *
   * \throws Degenerate_face_error if rounding errors lead the path in a circle, or to a point without a known distance
   */
  template <class OutputIterator>
  OutputIterator path(Arrival a, Input_halfedge_index h, Face_weights weights, OutputIterator out) const
  {
    const std::size_t end = a.root == null_index ? 0 : source(a);
    for(Descent descent(m_triangulation.input()); descent.goes_on(a.distance);) {
      if(a.through != null_index) {
        const double t = a.crossing / m_propagation.sides().copy(a.through).length;
        *out++ = surface_point_on_edge(m_triangulation, a.through, t);
        h = twin_index(a.through);
        weights = {{t, 1 - t, 0}};
        a = arrival_on_edge(h, weights, end);
      } else if(m_propagation.is_part(a.root)) {
        *out++ = surface_point_in_face(h, from(a, h, weights));
        break;
      } else {
        const Vertex_index v(a.root);
        *out++ = surface_point_at_vertex(m_triangulation, v);
        if(m_propagation.vertex(v).is_source)
          break;
        a = arrival(v);
        h = last_face(v, a);
        weights = {{1, 0, 0}};
      }
    }
    return out;
  }

  /* Converts the weights of a point of a face from one of its halfedges to another. */
  Face_weights turned(Face_weights weights, Input_halfedge_index from, Input_halfedge_index to) const
  {
    for(; from != to; from = m_triangulation.input().next(from))
      weights = rotated(weights);
    return weights;
  }

private:
  /*
   * Checks that a path approaches its source. Between two distances that differ visibly, it passes only points that are
   * closer together than rounding errors: each edge from both sides, and each vertex at most once. In a circle the
   * least distance is never undercut again.
   */
  class Descent
  {
  public:
    template <class Input_mesh>
    explicit Descent(const Input_mesh& input)
      : m_most(input.number_of_halfedges() + input.number_of_vertices())
    {
    }

    /* Returns true, given the distance of the next point. \throws Degenerate_face_error otherwise, or if it is
     * infinite */
    bool goes_on(double distance)
    {
      m_since_least = distance < m_least ? 0 : m_since_least + 1;
      m_least = (std::min)(m_least, distance);
      if(m_since_least > m_most || !(distance < std::numeric_limits<double>::infinity()))
        throw Degenerate_face_error("the shortest path could not be determined: in nearly degenerate faces, rounding "
                                    "errors make its direction uncertain; repair these faces");
      return true;
    }

  private:
    Index m_most, m_since_least = 0;
    double m_least = std::numeric_limits<double>::infinity();
  };

  // Calls `function(root)` for the parts of sources in the face of h.
  template <class Function>
  void for_each_part(Input_halfedge_index h, const Function& function) const
  {
    const Input_halfedge_index face = least_in_face(m_triangulation.input(), h);
    const auto before = [](const auto& entry, Input_halfedge_index f) { return entry.first < f; };
    auto i = std::lower_bound(m_parts_by_face.begin(), m_parts_by_face.end(), face, before);
    for(; i != m_parts_by_face.end() && i->first == face; ++i)
      function(i->second);
  }

  template <class IsWanted>
  void come_from_parts(Input_halfedge_index h, const Face_weights& weights, const IsWanted& is_wanted,
                       Arrival& best) const
  {
    for_each_part(h, [&](Index root) {
      const Source_part& p = m_propagation.part(root);
      const double d = p.distance(m_propagation.sides().copy(p.halfedge), turned(weights, h, p.halfedge));
      if(d < best.distance && is_wanted(root))
        best = {d, root, null_index, 0, Window()};
    });
  }

  template <class IsWanted>
  void come_from_corner(const Face_side& f, const Face_weights& weights, const IsWanted& is_wanted, Arrival& best) const
  {
    const double d = m_propagation.distance(f.tail) + std::abs(position(f, weights));
    if(d < best.distance && is_wanted(f.tail.idx()))
      best = {d, f.tail.idx(), null_index, 0, Window()};
  }

  template <class IsWanted>
  void come_through(Input_halfedge_index h, const Face_side& f, const Face_weights& weights, const IsWanted& is_wanted,
                    Arrival& best) const
  {
    const Vector p = position(f, weights);
    for(Window w : m_propagation.windows().on_edge(h.idx() / 2)) {
      if((w.side == 0) != is_first_side(h))
        continue;
      if(!is_first_side(h))
        w.mirror(f.length);
      const double crossing = w.crossing(p.real(), p.imag());
      const double d = w.bent_distance(p.real(), p.imag(), crossing);
      if(d < best.distance && is_wanted(w.root))
        best = {d, w.root, h, (std::min)((std::max)(crossing, w.from), w.to), w};
    }
  }

  Surface_point surface_point_in_face(Input_halfedge_index h, Face_weights weights) const
  {
    for(double& weight : weights)
      weight = weight < zero_weight ? 0 : weight;
    return surface_point(m_triangulation, Surface_location{h, weights});
  }

  // The arrival of the shortest path at a point of an edge from beyond side h: that from the wanted source, if no other
  // path is shorter.
  Arrival arrival_on_edge(Input_halfedge_index h, const Face_weights& weights, std::size_t wanted) const
  {
    const Arrival result = arrival(h, weights, true, [](Index) { return true; });
    if(result.root == null_index || source(result) == wanted)
      return result;
    const Arrival other = arrival(h, weights, true, [&](Index root) { return m_propagation.source(root) == wanted; });
    return other.distance <= result.distance * (1 + length_sum_rounding) ? other : result;
  }

  // The arrival of the shortest path at a point from one of the wanted roots. A path to a point on side h may come from
  // beyond that side; otherwise corners on the way are preferred.
  template <class IsWanted>
  Arrival arrival(Input_halfedge_index h, Face_weights weights, bool is_from_behind, const IsWanted& is_wanted) const
  {
    Arrival best, corner;
    come_from_parts(h, weights, is_wanted, best);
    for(int i = 0; i < 3; ++i) {
      const Face_side f = m_propagation.sides().copy(h);
      come_from_corner(f, weights, is_wanted, corner);
      if(i > 0 || !is_from_behind)
        come_through(h, f, weights, is_wanted, best);
      h = f.next;
      weights = rotated(weights);
    }
    return corner.distance <= best.distance * (is_from_behind ? 1 + equal_query_paths : 1) ? corner : best;
  }

  // The arrival of the shortest path at a vertex; `through` is null_index if it comes along an edge.
  Arrival arrival(Vertex_index v) const
  {
    const auto& record = m_propagation.vertex(v);
    Arrival result = {record.distance, record.root, record.through, 0, record.window};
    if(record.through != null_index) {
      const Face_side f = m_propagation.sides().copy(record.through);
      result.crossing = (std::min)((std::max)(record.window.crossing(f.x, f.y), 0.0), f.length);
    }
    return result;
  }

  // The halfedge that starts at a vertex in the last face of the path to it, if the path crosses no edge; otherwise
  // any.
  Input_halfedge_index last_face(Vertex_index v, const Arrival& a) const
  {
    const auto& input = m_triangulation.input();
    if(!m_propagation.is_part(a.root) || a.through != null_index)
      return input.outgoing(v);
    return side_from(input, m_propagation.part(a.root).halfedge, v);
  }

  const Triangulation& m_triangulation;
  const Propagation& m_propagation;
  const std::vector<std::pair<Input_halfedge_index, Index>>& m_parts_by_face;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FIELD_QUERY_H
