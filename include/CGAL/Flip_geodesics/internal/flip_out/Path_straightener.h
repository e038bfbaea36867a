// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_STRAIGHTENER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_STRAIGHTENER_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Segment_insertion.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/intrinsic_edge_path.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Canonical surface points, any two consecutive ones in a common input face: the points of one or several straight
 * lines. */
using Surface_polyline = std::vector<Surface_location>;

/* Returns whether the polyline is one point twice. */
inline bool is_point(const Surface_polyline& polyline)
{
  return polyline.size() == 2 && polyline[0].halfedge == polyline[1].halfedge &&
         polyline[0].weights == polyline[1].weights;
}

/* Makes a polyline canonical; a closed one ends with its first point again. \throws Invalid_curve_error for too few
 * points, or if two consecutive ones have no common face */
template <class Input_mesh>
std::vector<Surface_location> canonical_polyline(const Input_mesh& input, const std::vector<Surface_location>& polyline,
                                                 bool is_closed)
{
  std::vector<Surface_location> result;
  for(const Surface_location& location : polyline)
    result.push_back(canonical_location(input, location));
  if(result.size() < (is_closed ? 3u : 2u))
    throw Invalid_curve_error("a polyline requires at least two points, and a closed polyline at least three");
  if(is_closed)
    result.push_back(result.front());
  for(std::size_t i = 0; i + 1 < result.size(); ++i)
    if(common_face(input, result[i], result[i + 1]) == null_index)
      throw_naming<Invalid_curve_error>("points ", Element{i}, " and ", Element{i + 1},
                                        " of a polyline do not lie in a common face");
  return result;
}

/* Returns the weights of a canonical surface point, which may be a vertex, in the face of h; they sum to one. */
template <class Input_mesh>
std::array<double, 3> normalized_weights(const Input_mesh& input, const Surface_location& p, Input_halfedge_index h)
{
  if(kind(p) == Location_kind::VERTEX) {
    const Vertex_index v = input.tail(p.halfedge);
    const Input_halfedge_index hn = input.next(h);
    return {
        {input.tail(h) == v ? 1.0 : 0.0, input.tail(hn) == v ? 1.0 : 0.0, input.tail(input.next(hn)) == v ? 1.0 : 0.0}};
  }
  return divided_by_sum(weights_in_face(input, p, h));
}

/* Measures and divides polylines in the metric of a triangulation. */
template <class Triangulation>
class Polyline_measure
{
public:
  explicit Polyline_measure(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  double length(const Surface_polyline& polyline) const
  {
    double sum = 0;
    for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
      sum += distance(polyline[i], polyline[i + 1]);
    return sum;
  }

  /* Returns the two parts before and after the point at a distance from the start. */
  std::pair<Surface_polyline, Surface_polyline> divided(const Surface_polyline& polyline,
                                                        double distance_from_start) const
  {
    std::size_t i = 0;
    double step = 0;
    for(; i + 1 < polyline.size(); ++i) {
      step = distance(polyline[i], polyline[i + 1]);
      if(distance_from_start <= step || i + 2 == polyline.size())
        break;
      distance_from_start -= step;
    }
    Surface_polyline first(polyline.begin(), polyline.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    Surface_polyline second(polyline.begin() + static_cast<std::ptrdiff_t>(i) + 1, polyline.end());
    const Surface_location middle =
        step > 0 ? between(polyline[i], polyline[i + 1], (std::min)((std::max)(distance_from_start / step, 0.0), 1.0))
                 : polyline[i];
    first.push_back(middle);
    second.insert(second.begin(), middle);
    return {first, second};
  }

private:
  double distance(const Surface_location& p, const Surface_location& q) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index h = common_face(input, p, q);
    const auto d = barycentric_difference(normalized_weights(input, p, h), normalized_weights(input, q, h));
    const auto f = input_face_geometry(m_triangulation, h);
    return std::abs(d[1] * std::complex<double>(f[0].x, f[0].y) - d[2] * std::complex<double>(f[2].x, f[2].y));
  }

  Surface_location between(const Surface_location& p, const Surface_location& q, double t) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index h = common_face(input, p, q);
    const auto a = normalized_weights(input, p, h), b = normalized_weights(input, q, h);
    Surface_location result = {h, {{0, 0, 0}}};
    for(int i = 0; i < 3; ++i) {
      const double weight = (1 - t) * a[i] + t * b[i];
      result.weights[i] = weight < zero_weight ? 0 : weight; // points that are there by rounding errors lie on the edge
    }
    return canonical_location(input, result);
  }

  const Triangulation& m_triangulation;
};

/* Returns whether an edge of a triangulation lies in the closed input face of a halfedge. */
template <class Triangulation>
bool is_edge_in_face(const Triangulation& triangulation, Halfedge_index h, Input_halfedge_index face)
{
  if(triangulation.crossings(Triangulation::edge(h)) > 0)
    return false;
  const auto is_side = [&](Input_halfedge_index g) { return is_side_of(triangulation.input(), g, face); };
  const Edge_sequence sequence = triangulation.edge_sequence(h);
  return sequence.along == null_index ? is_side(sequence.face)
                                      : is_side(sequence.along) || is_side(twin_index(sequence.along));
}

/* Computes shortest paths along those edges of a triangulation that lie in one closed input face. */
template <class Triangulation>
class Path_in_face
{
public:
  explicit Path_in_face(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_search(static_cast<std::size_t>(triangulation.number_of_vertices()))
  {
  }

  /* Returns an empty path if the edges in the face do not connect the vertices. */
  std::vector<Halfedge_index> operator()(Input_halfedge_index face, Vertex_index source, Vertex_index target)
  {
    return path_along_edges(m_triangulation, source, target, Policy(m_triangulation, face, target), m_search);
  }

private:
  class Policy : public Triangulation_edge_policy<Triangulation>
  {
    using Base = Triangulation_edge_policy<Triangulation>;

  public:
    Policy(const Triangulation& triangulation, Input_halfedge_index face, Vertex_index target)
      : Base(triangulation, target)
      , m_face(face)
    {
    }

    template <class Function>
    void for_each_halfedge(const typename Base::Origin& origin, const Function& function) const
    {
      Base::for_each_halfedge(origin, [&](Halfedge_index h) {
        if(is_edge_in_face(this->triangulation(), h, m_face))
          function(h);
      });
    }

  private:
    Input_halfedge_index m_face;
  };

  const Triangulation& m_triangulation;
  Triangulation_edge_search m_search;
};

/* A curve along edges of a triangulation. */
struct Drawn_chain
{
  std::vector<Halfedge_index> halfedges;
  std::vector<std::size_t> nodes; // ascending positions of the halfedges at whose heads the curve is fixed
};

/* Adds a curve that is fixed at the nodes of a chain. */
template <class Network>
Curve_index add_chain(Network& network, const Drawn_chain& chain, bool is_closed)
{
  const Curve_index curve = network.add_curve(chain.halfedges, parameters::is_closed(is_closed));
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

/* Computes exact sides of lines within one closed input face, from the weights of a triangulation's vertices in the
 * face. */
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

  /* Returns the side of the line from p to q on which r lies, POSITIVE on the left. */
  Sign side(Vertex_index p, Vertex_index q, Vertex_index r) const
  {
    return orientation_of_weights(weights(p), weights(q), weights(r));
  }

  /* Returns whether r lies on the ray from p through q: on the same line, and with q on one side of a line through p
   * and a corner of the face. */
  bool is_on_ray(Vertex_index p, Vertex_index q, Vertex_index r) const
  {
    if(r == q)
      return true;
    if(side(p, q, r) != ZERO)
      return false;
    for(const Weights& corner : {Weights{{1, 0, 0}}, Weights{{0, 1, 0}}, Weights{{0, 0, 1}}})
      if(const Sign of_q = orientation_of_weights(weights(p), corner, weights(q)); of_q != ZERO)
        return orientation_of_weights(weights(p), corner, weights(r)) == of_q;
    return false; // p and q coincide
  }

private:
  Weights weights(Vertex_index v) const { return vertex_weights(m_triangulation, v, m_face); }

  const Triangulation& m_triangulation;
  Input_halfedge_index m_face;
};

/*
 * Makes the points of a polyline vertices of a network's triangulation, and its segments edges: exactly these segments,
 * on the same sides of all other points. The edges that a segment crosses are flipped, as in a constrained
 * triangulation of its input face. A segment that passes a vertex consists of several edges.
 *
 * Edges under curves cannot be flipped; in that case the segment crosses the curve.
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

  /* Draws a polyline of canonical surface points, any two consecutive ones in a common face. Coincident points count
   * once. */
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

  // The edge from v straight to the target, or to a vertex on the segment; null_index if it does not exist.
  Halfedge_index halfedge_along(const Face& face, Vertex_index v, Vertex_index target) const
  {
    for(Halfedge_index h : outgoing_halfedges(m_triangulation, v))
      if(is_in_face(face, h) && face.is_on_ray(v, target, m_triangulation.head(h)))
        return h;
    return null_index;
  }

  // The edges crossed by the segment from v to the target up to the next vertex on it, each as a side of the face that
  // is left.
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

  // The side opposite to v in the face that contains the start of the segment.
  Halfedge_index first_crossed(const Face& face, Vertex_index v, Vertex_index target) const
  {
    for(Halfedge_index h : outgoing_halfedges(m_triangulation, v)) {
      if(!is_face_in_face(face, h))
        continue;
      const Halfedge_index opposite = m_triangulation.next(h);
      const Vertex_index right = m_triangulation.head(h), left = m_triangulation.head(opposite);
      if(face.side(v, target, right) == NEGATIVE && face.side(v, target, left) == POSITIVE &&
         face.side(v, right, left) == POSITIVE) // not the other face of two with all sides in common
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
    throw_naming<Crossing_curves_error>(
        "a segment of a polyline crosses the polyline itself or another curve at the edge between vertices ", v,
        " and ", w);
  }

  Network& m_network;
  Triangulation& m_triangulation;
  std::set<Edge_index> m_drawn; // by this polyline
};

/* Rolls changes of a triangulation back at the end of its scope, also after an exception. */
template <class Triangulation>
class Rollback
{
public:
  explicit Rollback(Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_before(triangulation.log_position())
  {
  }
  Rollback(const Rollback&) = delete;
  Rollback& operator=(const Rollback&) = delete;
  ~Rollback() { m_triangulation.rollback(m_before); }

private:
  Triangulation& m_triangulation;
  typename Triangulation::Log_position m_before;
};

/*
 * Shortens one path at a time to a geodesic, between arbitrary points, and returns it as a polyline; the triangulation
 * is that of the input before and after. Paths therefore do not obstruct each other, and may cross.
 */
template <class Triangulation>
class Path_straightener
{
  using Network = Edge_path_network<Triangulation>;

public:
  explicit Path_straightener(Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* Computes a geodesic from a shortest edge path, which `tighten(network)` shortens; the result is the point twice if
   * both ends coincide. */
  template <class Tighten>
  Surface_polyline shortest(const Surface_location& p, const Surface_location& q, const Tighten& tighten)
  {
    const auto find_path = [&](Network&, Vertex_index v, Vertex_index w) {
      std::vector<Halfedge_index> path = intrinsic_edge_path(m_triangulation, v, w);
      if(path.empty() && v != w) // v and w are not vertices of the mesh
        throw_disconnected_points(m_triangulation.input().tail(p.halfedge), m_triangulation.input().tail(q.halfedge));
      return path;
    };
    return checked(pull(p, q, find_path, tighten));
  }

  Surface_polyline shortest(const Surface_location& p, const Surface_location& q)
  {
    return shortest(p, q, [](Network& network) { return shorten(network); });
  }

  /* Computes the geodesic with the polyline's ends in its class, which `tighten(network)` shortens unless all of it
   * lies in one face; empty if the polyline, snapped to edges, crosses itself. */
  template <class Tighten>
  Surface_polyline straightened_if_possible(const Surface_polyline& path, const Tighten& tighten)
  {
    if(is_in_one_face(path))
      return {path.front(), path.back()};
    const auto snap = [&](Network&, Vertex_index v, Vertex_index w) { return snapped(path, v, w); };
    return pull(path.front(), path.back(), snap, tighten);
  }

  /* Computes that geodesic by as many flips as necessary. Vertices at the ends can lie between a path and the edges to
   * which it is snapped; if the snapped path therefore crosses itself, the path itself is drawn instead. */
  Surface_polyline straightened(const Surface_polyline& path)
  {
    const auto tighten = [](Network& network) { return shorten(network); };
    const Surface_polyline result = straightened_if_possible(path, tighten);
    if(!result.empty())
      return result;
    const auto draw = [&](Network& network, Vertex_index, Vertex_index) {
      return Polyline_drawer<Network>(network)(path).halfedges;
    };
    return checked(pull(path.front(), path.back(), draw, tighten));
  }

  /* Throws the reason why the last path crosses itself. */
  [[noreturn]] void throw_conflict() const { m_conflict.raise(); }

  /* The path along edges from vertex v, the polyline's start, to w, its end: points on edges are moved to the nearer
   * end. */
  std::vector<Halfedge_index> snapped(const Surface_polyline& path, Vertex_index v, Vertex_index w) const
  {
    const auto& input = m_triangulation.input();
    Path_in_face<Triangulation> path_in_face(m_triangulation);
    std::vector<Halfedge_index> result;
    std::size_t last = 0; // the point that the path has reached
    Vertex_index at = v;
    for(std::size_t i = 1; i < path.size(); ++i) {
      const bool is_end = i + 1 == path.size();
      if(kind(path[i]) == Location_kind::FACE && !is_end)
        continue; // its neighbors lie in the same face
      const Input_halfedge_index face = common_face(input, path[last], path[last + 1]);
      const Vertex_index next = is_end ? w : nearest_vertex(input, path[i]);
      for(Halfedge_index h : path_in_face(face, at, next))
        if(!result.empty() && h == Triangulation::twin(result.back()))
          result.pop_back();
        else
          result.push_back(h);
      at = next;
      last = i;
    }
    return result;
  }

  /* Returns the joint report of all paths, as if they were one curve. */
  const Shortening_report& report() const { return m_report; }
  void clear_report() { m_report.curves.assign(1, report_of_nothing()); }

private:
  const Surface_polyline& checked(const Surface_polyline& path) const
  {
    if(path.empty())
      throw_conflict();
    return path;
  }

  // Returns nothing if the path crosses itself.
  template <class MakePath, class Tighten>
  Surface_polyline pull(const Surface_location& p, const Surface_location& q, const MakePath& make_path,
                        const Tighten& tighten)
  {
    check_has_no_curves(m_triangulation, "a geodesic between points cannot be found");
    const Rollback<Triangulation> at_end(m_triangulation);
    Network network(m_triangulation);
    const Vertex_index v = network.insert(p), w = network.insert(q);
    const std::vector<Halfedge_index> path = make_path(network, v, w);
    if(path.empty())
      return {canonical_location(m_triangulation.input(), p),
              canonical_location(m_triangulation.input(), v == w ? p : q)};
    network.add_curve(path);
    m_conflict = order_if_possible(network);
    if(m_conflict)
      return {};
    note(tighten(network));
    Surface_polyline result;
    for(const Surface_point& point : Curve_extractor<Network>(network).surface_points(Curve_index(0)))
      result.push_back(canonical_location(m_triangulation.input(), surface_location(m_triangulation, point)));
    if(result.empty()) // contracted to its ends
      result = {p, q};
    return result;
  }

  void note(const Shortening_report& report)
  {
    Curve_report& all = m_report.curves.front();
    const Curve_report& one = report.curves.front();
    all.initial_length += one.initial_length;
    all.length += one.length;
    m_report.flips += report.flips;
    m_report.flip_outs += report.flip_outs;
    all.smallest_angle = (std::min)(all.smallest_angle, one.smallest_angle);
    if(one.status != Shortening_status::LOCALLY_SHORTEST && one.status != Shortening_status::CONTRACTED)
      all.status = one.status;
    all.verdict = (std::max)(all.verdict, one.verdict);
  }

  // Segments within a face are straight.
  Curve_report report_of_nothing() const
  {
    Curve_report report;
    report.verdict = Triangulation::Traits::Has_drift::value || is_input_rounded(m_triangulation) ? Verdict::UNDECIDED
                                                                                                  : Verdict::PROVEN;
    return report;
  }

  bool is_in_one_face(const Surface_polyline& path) const
  {
    std::vector<Input_halfedge_index> faces = faces_of_location(m_triangulation.input(), path.front());
    for(const Surface_location& p : path) {
      const std::vector<Input_halfedge_index> here = faces_of_location(m_triangulation.input(), p);
      faces.erase(
          std::remove_if(faces.begin(), faces.end(),
                         [&](Input_halfedge_index f) { return std::find(here.begin(), here.end(), f) == here.end(); }),
          faces.end());
    }
    return !faces.empty();
  }

  Triangulation& m_triangulation;
  Shortening_report m_report = {{report_of_nothing()}, 0, 0};
  Order_conflict m_conflict; // of the last path that was shortened
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_PATH_STRAIGHTENER_H
