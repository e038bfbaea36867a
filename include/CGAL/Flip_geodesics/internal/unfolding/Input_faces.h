// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_INPUT_FACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_INPUT_FACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* The ends of a portal, as seen along the path. */
enum Portal_side : std::size_t { LEFT_END, RIGHT_END };

/* An edge crossed by a path, in the plane: its end that is not an end of the previous portal. The first portal has its
 * right end at the origin and stores the left one. */
struct Portal
{
  Plane_vector end;
  Portal_side side;
};

/*
 * The shortest path in a sleeve of unfolded faces, by a funnel that restarts at each bend [LP84]. The portals are the
 * edges that the path crosses between its two ends, neither of which is an end of a portal.
 */
class Funnel
{
public:
  /* A vertex at which the path bends: an end of portals `first` to `last`. */
  struct Bend
  {
    std::size_t first, last;
    Portal_side side;
    Plane_vector position;
  };

  void pull(const std::vector<Portal>& portals, const Plane_vector& source, const Plane_vector& target)
  {
    m_bends.clear();
    Plane_vector apex = source;
    std::size_t start = 0;
    while(find_bend(portals, apex, start, target)) {
      apex = m_bends.back().position;
      start = m_bends.back().last + 1;
    }
  }

  /* Returns an end of portal i. */
  static Plane_vector end(const std::vector<Portal>& portals, std::size_t i, Portal_side side)
  {
    for(; portals[i].side != side; --i)
      if(i == 0)
        return 0;
    return portals[i].end;
  }

  const std::vector<Bend>& bends() const { return m_bends; }

private:
  // The region visible from the apex through the portals so far lies between the directions to `left` and `right`.
  struct View
  {
    Plane_vector left, right;
    std::size_t left_portal, right_portal;
  };

  // Most portals do not change the view, which is computed without a branch on their side, since the sides follow no
  // predictable pattern.
  bool find_bend(const std::vector<Portal>& portals, const Plane_vector& apex, std::size_t start,
                 const Plane_vector& target)
  {
    if(start >= portals.size())
      return false;
    View view = {end(portals, start, LEFT_END) - apex, end(portals, start, RIGHT_END) - apex, start, start};
    for(std::size_t i = start + 1; i < portals.size(); ++i) {
      const double x = portals[i].end.real() - apex.real(), y = portals[i].end.imag() - apex.imag();
      const double to_left = unfused(view.right.real() * y) - unfused(view.right.imag() * x);
      const double to_right = unfused(x * view.left.imag()) - unfused(y * view.left.real());
      const Portal_side side = portals[i].side;
      if(std::array<double, 2>{to_right, to_left}[side] < 0) // by LEFT_END, RIGHT_END
        continue;
      if(side == RIGHT_END) {
        if(to_right < 0)
          return add_bend(portals, view.left_portal, LEFT_END);
        view.right = {x, y};
        view.right_portal = i;
      } else {
        if(to_left < 0)
          return add_bend(portals, view.right_portal, RIGHT_END);
        view.left = {x, y};
        view.left_portal = i;
      }
    }
    if(cross(view.right, target - apex) < 0)
      return add_bend(portals, view.right_portal, RIGHT_END);
    return cross(view.left, target - apex) > 0 && add_bend(portals, view.left_portal, LEFT_END);
  }

  bool add_bend(const std::vector<Portal>& portals, std::size_t portal, Portal_side side)
  {
    std::size_t first = portal, last = portal;
    while(first > 0 && portals[first].side != side)
      --first;
    while(last + 1 < portals.size() && portals[last + 1].side != side)
      ++last;
    m_bends.push_back({first, last, side, end(portals, portal, side)});
    return true;
  }

  std::vector<Bend> m_bends;
};

/* A direction at an input vertex: an outgoing halfedge, turned counterclockwise by less than the corner of its face. */
struct Corner_direction
{
  Input_halfedge_index outgoing = null_index;
  Plane_vector turn = 1; // of length 1
};

/* An angle at an input vertex, computed from corners of faces in plain doubles. */
struct Corner_angle
{
  Plane_vector turn;           // not normalized
  Index corners;               // the number of outgoing halfedges that were passed
  bool is_beyond_pi = false;   // whether it exceeds pi by more than a tolerance; the rest is then not computed
  bool passes_near_pi = false; // whether it is within the tolerance of pi up to one of the halfedges
};

/* The faces that are refused: those of which no corner can be computed, or all that the metric cannot represent by
 * vectors. */
enum class Refused_faces { WITHOUT_CORNERS, UNUSABLE };

/*
 * Faces of the input mesh, unfolded separately in doubles. Once a face or the length of an edge has been refused, which
 * `have_refused()` returns, results are invalid until `forget_refusals()`.
 */
template <class Triangulation>
class Input_faces
{
public:
  Input_faces(const Triangulation& triangulation, Refused_faces refused)
    : m_triangulation(triangulation)
    , m_refused(refused)
  {
  }

  bool have_refused() const { return m_have_refused; }
  void forget_refusals() { m_have_refused = false; }

  bool has_halfedge(Input_halfedge_index h) const
  {
    return h.is_valid() && h.idx() < m_triangulation.input().number_of_halfedges();
  }
  Input_halfedge_index next(Input_halfedge_index h) const { return m_triangulation.input().next(h); }
  Input_halfedge_index previous(Input_halfedge_index h) const { return m_triangulation.input().previous(h); }
  Vertex_index tail(Input_halfedge_index h) const { return m_triangulation.input().tail(h); }
  Vertex_index head(Input_halfedge_index h) const { return tail(twin_index(h)); }
  Vertex_index apex(Input_halfedge_index h) const { return head(next(h)); }
  bool is_border(Input_halfedge_index h) const { return m_triangulation.input().is_border(h); }
  double length(Input_halfedge_index h) const
  {
    const double length = m_triangulation.metric().weight(m_triangulation.input(), h);
    m_have_refused = m_have_refused || !is_usable_length(length);
    return length;
  }

  /* \pre the face exists on this side; it need not be a triangle */
  Input_halfedge_index clockwise(Input_halfedge_index h) const { return next(twin_index(h)); }
  Input_halfedge_index counterclockwise(Input_halfedge_index h) const { return twin_index(previous(h)); }

  /* Returns the third corner of the face of h, which must be a triangle, if h leads from 0 to 1 in the complex
   * plane. */
  Plane_vector corner(Input_halfedge_index h) const
  {
    check_triangle(m_triangulation.input(), h);
    if(!has_places || m_refused == Refused_faces::UNUSABLE)
      return corner_of_usable_face(h);
    return corner_of_known_face(h);
  }

  /* Returns the angle from one direction counterclockwise to another; it exceeds pi if the border is in between. */
  Corner_angle angle(const Corner_direction& from, const Corner_direction& to, double tolerance) const
  {
    Corner_angle result = {std::conj(from.turn), 0};
    if(from.outgoing != to.outgoing || !(cross(from.turn, to.turn) > 0)) {
      Input_halfedge_index h = from.outgoing;
      do {
        add_corner(h, tolerance, result);
        if(result.is_beyond_pi)
          return result;
        h = counterclockwise(h);
      } while(h != to.outgoing);
    }
    result.turn = product(result.turn, to.turn);
    return result;
  }

private:
  static constexpr bool has_places = has_places_in_space<typename Triangulation::Metric>;

  BOOST_NOINLINE Plane_vector corner_of_usable_face(Input_halfedge_index h) const
  {
    if(is_usable_face(m_triangulation.metric(), m_triangulation.input(), h))
      return corner_of_known_face(h);
    m_have_refused = true;
    return 0;
  }

  Plane_vector corner_of_known_face(Input_halfedge_index h) const
  {
    if constexpr(has_places) {
      return corner(tail(h), head(h), apex(h));
    } else {
      const auto face = known_input_face_geometry(m_triangulation, h);
      return {-face[2].x / face[0].x, -face[2].y / face[0].x};
    }
  }

  void add_corner(Input_halfedge_index h, double tolerance, Corner_angle& angle) const
  {
    angle.is_beyond_pi = is_border(h);
    if(angle.is_beyond_pi)
      return;
    angle.turn = product(angle.turn, corner(h));
    ++angle.corners;
    const double margin = tolerance * magnitude(angle.turn), sine = angle.turn.imag();
    const bool is_obtuse = angle.turn.real() < 0; // the remainder of the first corner can be zero
    angle.is_beyond_pi = sine < -margin && (angle.corners > 1 || is_obtuse);
    angle.passes_near_pi = angle.passes_near_pi || (std::abs(sine) <= margin && is_obtuse);
  }

  using Vector_3 = std::array<double, 3>;

  auto place(Vertex_index v) const { return m_triangulation.metric().place(m_triangulation.input(), v); }

  Plane_vector corner(Vertex_index p, Vertex_index q, Vertex_index r) const
  {
    if constexpr(std::is_same<typename Triangulation::Metric::Place, Vector_3>::value) {
      const Vector_3 at_p = place(p), at_q = place(q), at_r = place(r);
      return corner({at_q[0] - at_p[0], at_q[1] - at_p[1], at_q[2] - at_p[2]},
                    {at_r[0] - at_p[0], at_r[1] - at_p[1], at_r[2] - at_p[2]});
    } else {
      const auto& metric = m_triangulation.metric();
      const auto& input = m_triangulation.input();
      using Of_metric = Internals<typename Triangulation::Metric>;
      return corner(Of_metric::vector(metric, input, p, q), Of_metric::vector(metric, input, p, r));
    }
  }

  static Plane_vector corner(const Vector_3& to_q, const Vector_3& to_r)
  {
    const auto [x, y, z] = to_q;
    const auto [u, v, w] = to_r;
    const double a = unfused(y * w) - unfused(z * v), b = unfused(z * u) - unfused(x * w),
                 c = unfused(x * v) - unfused(y * u);
    const double scale = 1 / (unfused(x * x) + unfused(y * y) + unfused(z * z));
    return {(unfused(x * u) + unfused(y * v) + unfused(z * w)) * scale,
            std::sqrt(unfused(a * a) + unfused(b * b) + unfused(c * c)) * scale};
  }

  const Triangulation& m_triangulation;
  Refused_faces m_refused;
  mutable bool m_have_refused = false;
};

/*
 * An input edge crossed by a path, as a side of the face that is left, with its tail on the right, and the shape of the
 * face beyond it. The shape is computed when a sleeve is first unfolded across the edge, and stored, so that unfolding
 * across the edge again takes one complex product.
 */
struct Sleeve_edge
{
  /* \param h the halfedge; the shape of the face beyond it is not computed yet */
  Sleeve_edge(Input_halfedge_index h)
    : crossed(h)
  {
  }
  explicit operator Input_halfedge_index() const { return crossed; }

  Input_halfedge_index crossed;
  Input_halfedge_index right_side = null_index; // of the face beyond, as seen from the edge; null_index until computed
  Plane_vector corner = 0;                      // the third corner of the face beyond, if the edge leads from 1 to 0
};

/*
 * The sleeve of a path, that is, the input faces that it passes, unfolded into the plane in doubles with the crossed
 * edges as portals; and the shortest path within the sleeve.
 */
template <class Triangulation>
class Sleeve
{
public:
  using Bend = Funnel::Bend;

  Sleeve(const Triangulation& triangulation, Refused_faces refused)
    : m_triangulation(triangulation)
    , m_faces(triangulation, refused)
  {
  }

  Input_faces<Triangulation>& faces() { return m_faces; }
  const Input_faces<Triangulation>& faces() const { return m_faces; }

  /* Returns the crossed edges, in order. After a change, the sleeve must be unfolded again. */
  std::vector<Sleeve_edge>& edges() { return m_edges; }
  const std::vector<Sleeve_edge>& edges() const { return m_edges; }

  /* Unfolds the faces with the right end of the first crossed edge at the origin and the edge on the positive real
   * axis. \pre edges are crossed; tail and head, in the first and the last face, are not ends of the crossed edges */
  void unfold(Vertex_index tail, Vertex_index head)
  {
    for(Sleeve_edge& edge : m_edges)
      if(edge.right_side == null_index)
        lay_out_face_beyond(edge);
    const Input_halfedge_index first = m_edges.front().crossed;
    const double length = m_faces.length(first);
    m_tail_place = length * place_in_face(tail, first, m_triangulation.is_inserted(tail) ? 0 : m_faces.corner(first));
    const Plane_vector place = place_in_face(head, twin_index(m_edges.back().crossed), m_edges.back().corner);
    unfold_portals(length, place);
  }

  /* Computes the shortest path from tail to head within the unfolded sleeve. Returns its bends. */
  const std::vector<Bend>& pull()
  {
    m_funnel.pull(m_portals, m_tail_place, m_head_place);
    return m_funnel.bends();
  }

  /* Returns the crossed edges in the plane, and below the positions of the tail and the head. */
  const std::vector<Portal>& portals() const { return m_portals; }
  const Plane_vector& tail_place() const { return m_tail_place; }
  const Plane_vector& head_place() const { return m_head_place; }

  /* Returns the bends of the last shortest path. */
  const std::vector<Bend>& bends() const { return m_funnel.bends(); }

  /* Returns the vertex of a bend. */
  Vertex_index vertex(const Bend& bend) const
  {
    const Input_halfedge_index h = m_edges[bend.first].crossed;
    return bend.side == RIGHT_END ? m_faces.tail(h) : m_faces.head(h);
  }

  /* Returns the direction, at the first of two points, of the line to the second, in the face before portal `first`. */
  Corner_direction direction_at_tail(std::size_t first, const Plane_vector& from, const Plane_vector& to) const
  {
    return {m_faces.previous(m_edges[first].crossed),
            rotation(Funnel::end(m_portals, first, RIGHT_END) - from, to - from)};
  }

  /* Returns the reverse direction at the second point, in the face behind portal `last`. */
  Corner_direction direction_at_head(std::size_t last, const Plane_vector& from, const Plane_vector& to) const
  {
    return {m_faces.previous(twin_index(m_edges[last].crossed)),
            rotation(Funnel::end(m_portals, last, LEFT_END) - to, from - to)};
  }

  /* Returns the direction from a vertex to a point in a common face; no direction if the vertex is inserted. */
  Corner_direction direction_in_face(Vertex_index v, Vertex_index to, Input_halfedge_index face) const
  {
    if(m_triangulation.is_inserted(v))
      return {};
    const Input_halfedge_index outgoing = anchor(m_triangulation, v, face);
    const auto w = vertex_weights(m_triangulation, to, outgoing);
    return {outgoing, rotation(1, w[1] + w[2] * m_faces.corner(outgoing))};
  }

private:
  void lay_out_face_beyond(Sleeve_edge& edge) const
  {
    const Input_halfedge_index entered = twin_index(edge.crossed);
    edge.corner = m_faces.corner(entered);
    edge.right_side = m_faces.next(entered);
  }

  // The position of a vertex in the face of h, if h leads from 0 to 1; an input vertex is at the given third corner.
  Plane_vector place_in_face(Vertex_index v, Input_halfedge_index h, const Plane_vector& corner) const
  {
    if(!m_triangulation.is_inserted(v))
      return corner;
    const auto w = vertex_weights(m_triangulation, v, h);
    return (w[1] + w[2] * m_faces.corner(h)) / (w[0] + w[1] + w[2]);
  }

  // The first crossed edge has the given length, and the head a position in the last face relative to the last edge.
  // Each portal depends on the previous one by one product only, without a branch, since the sides follow no
  // predictable pattern.
  void unfold_portals(double length, const Plane_vector& head_in_last_face)
  {
    static constexpr double is_side[2][2] = {{1, 0}, {0, 1}};
    m_portals.resize(m_edges.size());
    m_portals.front() = {length, LEFT_END};
    double left_x = length, left_y = 0, across_x = -length, across_y = 0; // from there to the right end
    const std::size_t last = m_edges.size() - 1;
    for(std::size_t i = 0; i < last; ++i) {
      const double x = m_edges[i].corner.real(), y = m_edges[i].corner.imag();
      const double apex_x = unfused(across_x * x) - unfused(across_y * y);
      const double apex_y = unfused(across_x * y) + unfused(across_y * x);
      const bool is_right = m_edges[i + 1].crossed != m_edges[i].right_side;
      m_portals[i + 1] = {{left_x + apex_x, left_y + apex_y}, is_right ? RIGHT_END : LEFT_END};
      const double on_right = is_side[is_right][1], on_left = is_side[is_right][0];
      left_x += unfused(on_left * apex_x);
      left_y += unfused(on_left * apex_y);
      const double turn_x = on_left + unfused((on_right - on_left) * x), turn_y = (on_right - on_left) * y;
      const double next_x = unfused(across_x * turn_x) - unfused(across_y * turn_y);
      across_y = unfused(across_x * turn_y) + unfused(across_y * turn_x);
      across_x = next_x;
    }
    m_head_place = Plane_vector(left_x, left_y) + product({across_x, across_y}, head_in_last_face);
  }

  // The rotation from one vector counterclockwise to another, which lies on that side up to rounding errors.
  static Plane_vector rotation(const Plane_vector& from, const Plane_vector& to)
  {
    const Plane_vector result = product(std::conj(from), to);
    return result.imag() > 0 ? result / magnitude(result) : 1;
  }

  const Triangulation& m_triangulation;
  Input_faces<Triangulation> m_faces;
  std::vector<Sleeve_edge> m_edges;
  std::vector<Portal> m_portals;
  Plane_vector m_tail_place, m_head_place;
  Funnel m_funnel;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_INPUT_FACES_H
