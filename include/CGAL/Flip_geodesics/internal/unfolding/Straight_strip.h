// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_STRAIGHT_STRIP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_STRAIGHT_STRIP_H

#include <CGAL/Flip_geodesics/internal/numbers/orientation.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * The reason why the line of an edge sequence is not a locally shortest path: an end of the crossed edge with this
 * number is on the wrong side, or a vertex on the line has less than the full angle 2 pi by this rounded amount.
 */
struct Strip_obstacle
{
  Vertex_index vertex = null_index;
  std::size_t portal = 0;
  double missing_angle = 0;
};

/*
 * The vertices at distance zero from the interior of a straight segment, which exist if degenerate faces lie along it.
 * They are found by continuing straight across such faces from each part of an edge that has been reached. The segment
 * passes a touched vertex with an angle of pi on its own side; it is locally shortest there if the angle on the other
 * side is at least pi as well, that is, if the angles at the vertex sum up to at least 2 pi.
 */
template <class Triangulation>
class Touched_vertices
{
public:
  /* For a segment of the given length between two vertices. */
  Touched_vertices(const Triangulation& triangulation, Vertex_index tail, Vertex_index head, double length,
                   Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_faces(triangulation)
    , m_tail(tail)
    , m_head(head)
    , m_length(length)
    , m_statistics(statistics)
  {
  }

  /* Adds an end of a crossed edge that lies on the segment. */
  void add_vertex(Vertex_index v) { m_vertices.push_back(v); }

  /* Adds an input edge on the line of the segment, between two distances from the segment's tail. */
  void add_edge(Input_halfedge_index h, double from, double to)
  {
    add_part({h, from, to}, {{0, m_tail}, {m_length, m_head}});
    for(; m_next < m_parts.size(); ++m_next) {
      const Part part = m_parts[m_next];
      const Edge& e = part.edge;
      add_beyond(e, part.reached);
      add_beyond({twin_index(e.halfedge), e.to, e.from}, part.reached);
    }
  }

  /* Returns whether all vertices are passed straight; otherwise the first violating one is the obstacle. */
  bool are_passed_straight(Strip_obstacle& obstacle) const
  {
    for(Vertex_index v : m_vertices) {
      double excess = 0;
      if(!has_full_angle(v, excess)) {
        obstacle.vertex = v;
        obstacle.missing_angle = (std::max)(-excess, 0.0);
        return false;
      }
    }
    return true;
  }

private:
  struct Edge
  {
    Input_halfedge_index halfedge;
    double from, to;
  };

  // An interval on the line of the segment, between positions of vertices.
  struct Interval
  {
    struct End
    {
      double at;
      Vertex_index vertex;
    };
    End low, high;
  };

  struct Part
  {
    Edge edge;
    Interval reached;
  };

  Interval interval_of(const Edge& e) const
  {
    const auto& input = m_triangulation.input();
    const typename Interval::End tail = {e.from, input.tail(e.halfedge)},
                                 head = {e.to, input.tail(twin_index(e.halfedge))};
    return e.from < e.to ? Interval{tail, head} : Interval{head, tail};
  }

  // Adds the part of an interval that lies on an edge, unless it is only a vertex.
  void add_part(const Edge& e, const Interval& reached)
  {
    const Interval whole = interval_of(e);
    const Interval part = {whole.low.at > reached.low.at ? whole.low : reached.low,
                           whole.high.at < reached.high.at ? whole.high : reached.high};
    if(part.low.vertex != part.high.vertex && part.low.at < part.high.at + tolerance() && !is_known(e, part))
      m_parts.push_back({e, part});
  }

  // Adds the parts of the other sides of the face on the left of an edge that lie across, if that face is degenerate.
  void add_beyond(const Edge& e, const Interval& reached)
  {
    const auto& input = m_triangulation.input();
    if(input.is_border(e.halfedge) || !has_no_area(e.halfedge))
      return;
    const Input_halfedge_index hn = input.next(e.halfedge), hp = input.next(hn);
    const Vertex_index apex = input.tail(hp);
    const Exact_face& face = m_faces(e.halfedge);
    const double share = -static_cast<double>(face.dot_previous) / static_cast<double>(face.squared_length);
    const double at_apex = e.from + share * (e.to - e.from);
    if(at_apex > reached.low.at - tolerance() && at_apex < reached.high.at + tolerance() && apex != m_tail &&
       apex != m_head)
      m_vertices.push_back(apex);
    add_part({twin_index(hn), at_apex, e.to}, reached);
    add_part({twin_index(hp), e.from, at_apex}, reached);
  }

  // In case of doubt two points are regarded as one.
  double tolerance() const { return touched_vertex_tolerance * m_length; }

  bool is_known(const Edge& e, const Interval& part) const
  {
    return std::any_of(m_parts.begin(), m_parts.end(), [&](const Part& known) {
      return are_of_one_edge(known.edge.halfedge, e.halfedge) && known.reached.low.at <= part.low.at + tolerance() &&
             known.reached.high.at >= part.high.at - tolerance();
    });
  }

  bool has_no_area(Input_halfedge_index h) const
  {
    const auto face = input_face_geometry(m_triangulation, h);
    if(face[1].y > flat_layout_error * std::abs(face[1].x))
      return false;
    return m_faces(h).doubled_area_squared == 0;
  }

  // Returns whether the angles at an input vertex sum up to at least 2 pi or it is on the border; sets `excess` to the
  // difference.
  bool has_full_angle(Vertex_index v, double& excess) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index first = input.outgoing(v);
    const Index count = number_of_corners_clockwise(input, first, first);
    if(count < 0)
      return true;
    double sum = 0;
    for_each_corner_clockwise(input, first, count,
                              [&](Input_halfedge_index t) { sum += input_corner(m_triangulation, t); });
    excess = sum - 2 * boost::math::constants::pi<double>();
    if(std::abs(excess) > (count + 4) * input_corner_error)
      return excess > 0;
    const Unfolding_chains<Triangulation> unfolding(m_triangulation);
    return Exact_sign(m_statistics, sign_work_limit(m_triangulation))({unfolding.corners(first, count)}) != NEGATIVE;
  }

  const Triangulation& m_triangulation;
  Exact_input_faces<Triangulation> m_faces;
  Vertex_index m_tail, m_head;
  double m_length;
  Decision_statistics& m_statistics;
  std::vector<Vertex_index> m_vertices;
  std::vector<Part> m_parts;
  std::size_t m_next = 0; // of the parts beyond which nothing has been examined yet
};

/* The ends of an edge sequence's crossed edges that lie on its line. */
struct Line_contacts
{
  struct Edge_end
  {
    std::size_t portal;
    bool is_left;
  };
  std::vector<Edge_end> ends; // each vertex occurs once per edge
  bool have_edge = false;     // whether both ends of an edge are on the line
};

/*
 * Decides exactly whether the straight line from the tail to the head of an edge sequence is a locally shortest path
 * through its strip. The line must pass between the ends of each crossed edge. If degenerate faces lie along it, it may
 * touch vertices with a full angle and run along crossed edges in their interior.
 */
template <class Triangulation>
class Straight_strip
{
  using Strip_in_double = Strip<Triangulation>;
  using Portal = typename Strip_in_double::Portal;
  using Touched = Touched_vertices<Triangulation>;

public:
  Straight_strip(const Triangulation& triangulation, Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_statistics(statistics)
  {
  }

  /* Returns whether the faces of an edge sequence are consecutive, from one that contains the tail to one that contains
   * the head. The test is purely combinatorial. */
  bool is_strip(const Edge_sequence& sequence) const
  {
    if(sequence.along != null_index)
      return is_on_halfedge(m_triangulation, sequence.tail, sequence.along) &&
             is_on_halfedge(m_triangulation, sequence.head, twin_index(sequence.along));
    if(sequence.crossed.empty())
      return sequence.face != null_index && is_in_face(m_triangulation, sequence.tail, sequence.face) &&
             is_in_face(m_triangulation, sequence.head, sequence.face);
    const auto& input = m_triangulation.input();
    for(std::size_t i = 0; i < sequence.crossed.size(); ++i) {
      const Input_halfedge_index entered = twin_index(sequence.crossed[i]);
      if(input.is_border(sequence.crossed[i]) || input.is_border(entered))
        return false;
      const Input_halfedge_index right_side = input.next(entered), left_side = input.next(right_side);
      if(i + 1 < sequence.crossed.size() && sequence.crossed[i + 1] != right_side &&
         sequence.crossed[i + 1] != left_side)
        return false;
    }
    return is_opposite_vertex(m_triangulation, sequence.tail, sequence.crossed.front()) &&
           is_opposite_vertex(m_triangulation, sequence.head, twin_index(sequence.crossed.back()));
  }

  /* Examines the line of an edge sequence whose strip is available in doubles. */
  bool operator()(const Edge_sequence& sequence, const Strip_in_double& strip) const
  {
    return is_inside_face(sequence) || is_straight(sequence, strip, nullptr, nullptr);
  }

  /* Examines the line of an edge sequence, which need not be that of an edge of the triangulation. Determines the
   * obstacle if it is not locally shortest, and the ends of crossed edges on the line, if these are requested. */
  bool operator()(const Edge_sequence& sequence, Strip_obstacle* obstacle = nullptr,
                  Line_contacts* contacts = nullptr) const
  {
    return is_strip(sequence) &&
           (is_inside_face(sequence) ||
            is_straight(sequence, Strip_in_double(m_triangulation, sequence), obstacle, contacts));
  }

private:
  static bool is_inside_face(const Edge_sequence& sequence)
  {
    return sequence.along == null_index && sequence.crossed.empty();
  }

  bool is_straight(const Edge_sequence& sequence, const Strip_in_double& strip, Strip_obstacle* obstacle,
                   Line_contacts* contacts) const
  {
    Touched touched(m_triangulation, sequence.tail, sequence.head, strip.length(), m_statistics);
    Strip_obstacle found;
    bool is_inside_strip = true;
    if(sequence.along != null_index)
      add_edge_along(sequence, touched);
    else
      is_inside_strip = is_inside(sequence, strip, touched, found, contacts);
    const bool result = is_inside_strip && touched.are_passed_straight(found);
    if(obstacle != nullptr)
      *obstacle = found;
    return result;
  }

  /* The sides of the line on which the ends of a portal lie. POSITIVE is the right side. */
  struct Portal_sides
  {
    Sign left, right;
  };

  // The whole input edge, of which the segment can be a part.
  void add_edge_along(const Edge_sequence& sequence, Touched& touched) const
  {
    const double length = m_triangulation.metric().length(m_triangulation.input(), sequence.along);
    const auto w = vertex_weights(m_triangulation, sequence.tail, sequence.along);
    const double from = -length * (w[1] / (w[0] + w[1]));
    touched.add_edge(sequence.along, from, from + length);
  }

  bool is_inside(const Edge_sequence& sequence, const Strip_in_double& strip, Touched& touched,
                 Strip_obstacle& obstacle, Line_contacts* contacts) const
  {
    double passed = 0; // the part of the line that has been followed
    Portal_sides_beyond_doubles precise(*this, sequence, strip);
    Portal_sides before = {ZERO, ZERO};
    for(std::size_t i = 0; i < strip.portals().size(); ++i) {
      const Portal& portal = strip.portals()[i];
      Portal_sides sides = in_double(strip, portal);
      // Consecutive portals share an end, for which the proof is not repeated.
      const bool is_left_shared = i > 0 && !is_right_shared(strip.portals()[i - 1], portal);
      if(sides.left == ZERO)
        sides.left = is_left_shared ? before.left : precise.side(i, true);
      if(sides.right == ZERO)
        sides.right = i > 0 && !is_left_shared ? before.right : precise.side(i, false);
      before = sides;
      const bool is_along = sides.left == ZERO && sides.right == ZERO;
      if(sides.left == NEGATIVE || sides.right == NEGATIVE || (is_along && !runs_along(strip, portal, passed))) {
        obstacle.vertex =
            m_triangulation.input().tail(sides.left == NEGATIVE ? twin_index(portal.crossed) : portal.crossed);
        obstacle.portal = i;
        return false;
      }
      if(contacts != nullptr)
        note_contacts(i, sides, *contacts);
      if(is_along) {
        touched.add_edge(portal.crossed, along(strip, portal.right), along(strip, portal.left));
      } else if(sides.left == ZERO || sides.right == ZERO) {
        touched.add_vertex(
            m_triangulation.input().tail(sides.left == ZERO ? twin_index(portal.crossed) : portal.crossed));
      }
    }
    m_statistics.by_strip += precise.is_exact_needed() ? 0 : 1;
    return true;
  }

  static void note_contacts(std::size_t portal, const Portal_sides& sides, Line_contacts& contacts)
  {
    if(sides.left == ZERO)
      contacts.ends.push_back({portal, true});
    if(sides.right == ZERO)
      contacts.ends.push_back({portal, false});
    contacts.have_edge = contacts.have_edge || (sides.left == ZERO && sides.right == ZERO);
  }

  // Returns whether two consecutive portals start at one vertex; otherwise they end at one.
  bool is_right_shared(const Portal& portal, const Portal& next) const
  {
    return next.crossed == m_triangulation.input().next(twin_index(portal.crossed));
  }

  static double along(const Strip_in_double& strip, const std::complex<double>& p)
  {
    return std::real(std::conj(strip.end()) * p) / strip.length();
  }

  // Advances to the first point of the line inside a portal on it, if there is one.
  static bool runs_along(const Strip_in_double& strip, const Portal& portal, double& passed)
  {
    const double right = along(strip, portal.right), left = along(strip, portal.left);
    const double error = portal.right_error + portal.left_error + 4 * strip.relative_error() * strip.length();
    passed = (std::max)(passed, (std::min)(right, left) + error);
    return passed < (std::max)(right, left) - error && passed <= strip.length() - error;
  }

  static Portal_sides in_double(const Strip_in_double& strip, const Portal& portal)
  {
    if(!(strip.relative_error() < 1))
      return {ZERO, ZERO};
    const std::complex<double> end = strip.end();
    const double left_error = std::abs(end) * (portal.left_error + 2 * strip.relative_error() * std::abs(portal.left));
    const double right_error =
        std::abs(end) * (portal.right_error + 2 * strip.relative_error() * std::abs(portal.right));
    return {sign(std::imag(std::conj(end) * portal.left), left_error),
            sign(-std::imag(std::conj(end) * portal.right), right_error)};
  }

  static Sign sign(double value, double error) { return value > error ? POSITIVE : (value < -error ? NEGATIVE : ZERO); }

  // Computes the side of the line on which an end of a portal lies, by a double-double strip that is unfolded on first
  // use, or else exactly.
  class Portal_sides_beyond_doubles
  {
    using Strip_beyond_doubles = Precise_strip<Triangulation>;

  public:
    Portal_sides_beyond_doubles(const Straight_strip& owner, const Edge_sequence& sequence,
                                const Strip_in_double& strip)
      : m_triangulation(owner.m_triangulation)
      , m_statistics(owner.m_statistics)
      , m_sequence(sequence)
      , m_strip_in_double(strip)
    {
    }

    Sign side(std::size_t portal, bool is_left)
    {
      const Uncertain<Sign> quick = quick_side(portal, is_left);
      const Sign result = quick.is_certain() ? quick.make_certain() : exact_side(portal, is_left);
      return is_left ? result : CGAL::opposite(result);
    }

    bool is_exact_needed() const { return m_is_exact_needed; }

  private:
    Uncertain<Sign> quick_side(std::size_t portal, bool is_left)
    {
      if(m_triangulation.is_inserted(m_sequence.tail) || m_triangulation.is_inserted(m_sequence.head))
        return Uncertain<Sign>::indeterminate();
      if(!m_strip)
        m_strip.emplace(m_triangulation, m_sequence, true);
      const auto& ends = m_strip->portals()[portal];
      return m_strip->side(is_left ? ends.left : ends.right);
    }

    // A vertex on the line, which is an end of consecutive portals.
    struct Touched_end
    {
      Vertex_index vertex;
      std::size_t first, last; // portals
      bool is_left;
      std::complex<double> place;
      double error; // of the position
    };

    // \pre no portal before has the same end
    Sign exact_side(std::size_t portal, bool is_left)
    {
      m_is_exact_needed = true;
      const Touched_end end = touched_end(portal, is_left);
      const Sign result = is_in_line(end) ? ZERO : sign(m_sequence, portal, is_left);
      if(result == ZERO) {
        m_before_last = m_last;
        m_last = end;
      }
      return result;
    }

    Touched_end touched_end(std::size_t portal, bool is_left) const
    {
      const Input_halfedge_index h = m_sequence.crossed[portal];
      const Portal& g = m_strip_in_double.portals()[portal];
      const std::complex<double> place = is_left ? g.left : g.right;
      const double error =
          (is_left ? g.left_error : g.right_error) + 2 * m_strip_in_double.relative_error() * std::abs(place);
      return {m_triangulation.input().tail(is_left ? twin_index(h) : h),
              portal,
              last_portal(portal, is_left),
              is_left,
              place,
              error};
    }

    std::size_t last_portal(std::size_t portal, bool is_left) const
    {
      const std::vector<Input_halfedge_index>& crossed = m_sequence.crossed;
      while(portal + 1 < crossed.size() &&
            (crossed[portal + 1] != m_triangulation.input().next(twin_index(crossed[portal]))) == is_left)
        ++portal;
      return portal;
    }

    // The sign of the sine of the angle from the line to an end of a portal.
    Sign sign(const Edge_sequence& sequence, std::size_t portal, bool is_left) const
    {
      const Unfolding_chains<Triangulation> unfolding(m_triangulation);
      return Exact_sign(m_statistics, sign_work_limit(m_triangulation))(
          {unfolding.portal(sequence, portal, is_left), unfolding.head(sequence, true)});
    }

    // Returns whether a vertex is on the line through the last two vertices found on the line, or through the tail and
    // the only one. The faces between them prove this; they are few compared with the whole strip. Two vertices that
    // can coincide, which degenerate faces allow, do not define a line.
    bool is_in_line(const Touched_end& end) const
    {
      if(!m_last)
        return false;
      const std::size_t first = m_before_last ? m_before_last->last + 1 : 0;
      if(first > m_last->first || m_last->last >= end.first)
        return false;
      const double distance = std::abs(m_last->place - (m_before_last ? m_before_last->place : 0.0));
      if(!(distance > m_last->error + (m_before_last ? m_before_last->error : 0)))
        return false;
      Edge_sequence part;
      part.tail = m_before_last ? m_before_last->vertex : m_sequence.tail;
      part.head = end.vertex;
      const auto begin = m_sequence.crossed.begin();
      part.crossed.assign(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end.first));
      return sign(part, m_last->first - first, m_last->is_left) == ZERO;
    }

    const Triangulation& m_triangulation;
    Decision_statistics& m_statistics;
    const Edge_sequence& m_sequence;
    const Strip_in_double& m_strip_in_double;
    std::optional<Strip_beyond_doubles> m_strip;
    std::optional<Touched_end> m_before_last, m_last; // of the vertices on the line
    bool m_is_exact_needed = false;
  };

  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
};

/* Returns the exact orientation of three points of an input face, given by nonnegative weights: POSITIVE if they are in
 * counterclockwise order. */
inline Sign orientation_of_weights(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                   const std::array<double, 3>& r)
{
  return orientation({0, 0, 0}, p, q, r);
}

/*
 * Computes the side of an intrinsic edge on which a point lies in an input face that the edge passes: the sign of the
 * exact number that the input and the point's weights define. POSITIVE is the left side.
 *
 * The edge passes the face of gap i of its sequence between crossed edges i - 1 and i; the face at the tail is gap 0.
 */
template <class Triangulation>
class Point_side
{
public:
  Point_side(const Triangulation& triangulation, Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_statistics(statistics)
  {
  }

  Sign operator()(const Edge_sequence& sequence, std::size_t gap, const Surface_location& point) const
  {
    const std::array<double, 3> weights = weights_in_face(m_triangulation.input(), point, face_of_gap(sequence, gap));
    if(sequence.along != null_index)
      return weights[2] > 0 ? POSITIVE : ZERO;
    if(sequence.crossed.empty())
      return orientation_of_weights(vertex_weights(m_triangulation, sequence.tail, sequence.face),
                                    vertex_weights(m_triangulation, sequence.head, sequence.face), weights);
    const Uncertain<Sign> quick = in_double(sequence, gap, weights);
    if(quick.is_certain()) {
      ++m_statistics.by_strip;
      return quick.make_certain();
    }
    return exactly(sequence, gap, weights);
  }

  /* Returns the signed distance of the point to the left of the edge, rounded. */
  double distance(const Edge_sequence& sequence, std::size_t gap, const Surface_location& point) const
  {
    const std::array<double, 3> w = weights_in_face(m_triangulation.input(), point, face_of_gap(sequence, gap));
    if(sequence.crossed.empty())
      return 0; // decided exactly by the weights alone
    const Strip<Triangulation> strip(m_triangulation, sequence);
    const auto corners = strip.face(gap);
    std::complex<double> position = 0;
    for(int i = 0; i < 3; ++i)
      position += w[i] / (w[0] + w[1] + w[2]) * corners[i].position;
    return std::imag(std::conj(strip.end()) * position) / strip.length();
  }

private:
  Uncertain<Sign> in_double(const Edge_sequence& sequence, std::size_t gap, const std::array<double, 3>& w) const
  {
    const Strip<Triangulation> strip(m_triangulation, sequence);
    const auto corners = strip.face(gap);
    const double sum = w[0] + w[1] + w[2];
    std::complex<double> position = 0;
    double error = 0;
    for(int i = 0; i < 3; ++i) {
      position += w[i] / sum * corners[i].position;
      error += w[i] / sum * (corners[i].error + product_sum_error * std::abs(corners[i].position));
    }
    const double sine = std::imag(std::conj(strip.end()) * position);
    const double bound = (strip.length() + strip.end_error()) * error + strip.end_error() * std::abs(position) +
                         product_sum_error * strip.length() * std::abs(position);
    if(!(std::abs(sine) > bound))
      return Uncertain<Sign>::indeterminate();
    return sine > 0 ? POSITIVE : NEGATIVE;
  }

  Sign exactly(const Edge_sequence& sequence, std::size_t gap, const std::array<double, 3>& weights) const
  {
    const Unfolding_chains<Triangulation> unfolding(m_triangulation);
    return Exact_sign(m_statistics, sign_work_limit(m_triangulation))(
        {unfolding.point(sequence, gap, weights), unfolding.head(sequence, true)});
  }

  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_STRAIGHT_STRIP_H
