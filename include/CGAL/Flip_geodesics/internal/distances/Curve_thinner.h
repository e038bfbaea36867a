// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CURVE_THINNER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CURVE_THINNER_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Refined_surface.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The sides of a piece crossed by a curve may have this length, in units of the tolerance. All of the piece is then
 * within the tolerance of its corners, and its centroid within the tolerance of all points of its sides, since no
 * median is longer than the longest side. */
inline constexpr double side_by_tolerance = 1.5;

/* Detects fields that can be evaluated at points in the faces of a mesh; true if the other argument is not a mesh. */
template <class Field, class TriangleMesh, bool IS_MESH = has_faces<TriangleMesh>>
constexpr bool is_distance_field = true;
template <class Field, class TriangleMesh>
constexpr bool is_distance_field<Field, TriangleMesh, true> =
    std::is_invocable<const Field&, typename boost::graph_traits<TriangleMesh>::face_descriptor,
                      const Weights_in_face&>::value;

/* Reports a wrong order of mesh, field and tolerance at compile time. */
template <class TriangleMesh, class Field, class Tolerance>
constexpr bool are_in_order()
{
  static_assert(has_faces<TriangleMesh>,
                "the first argument is not a mesh; the order is mesh, field, levels if any, output, tolerance");
  static_assert(is_distance_field<Field, TriangleMesh>,
                "the second argument is not a model of GeodesicDistanceField for the mesh");
  static_assert(std::is_convertible<Tolerance, double>::value,
                "no tolerance where it belongs; the order is mesh, field, levels if any, output, tolerance");
  return true;
}

inline void check_tolerance(double tolerance)
{
  if(tolerance > 0 && std::isfinite(tolerance))
    return;
  std::ostringstream number;
  number << tolerance;
  throw Invalid_parameter_error("the tolerance is " + number.str() + ", which is not a positive finite number");
}

/* Returns the given points, or else the mesh's own. */
template <class TriangleMesh, class NamedParameters>
auto point_map(const TriangleMesh& mesh, const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value)
    return get_const_property_map(CGAL::vertex_point, mesh);
  else
    return parameters::get_parameter(np, internal_np::vertex_point);
}

template <class TriangleMesh, class NamedParameters>
using Point_map = decltype(point_map(std::declval<const TriangleMesh&>(), std::declval<const NamedParameters&>()));

template <class TriangleMesh, class NamedParameters>
using Point_of = typename boost::property_traits<Point_map<TriangleMesh, NamedParameters>>::value_type;

/* Throws Invalid_parameter_error if a tolerance is below the rounding errors of weights. */
template <class TriangleMesh, class NamedParameters, class Field>
auto make_refined_surface(const TriangleMesh& mesh, const Field& field, const NamedParameters& np, double tolerance,
                          Interruption& interruption)
{
  using Surface = Refined_surface<TriangleMesh, Point_map<TriangleMesh, NamedParameters>, Field>;
  Surface surface(mesh, point_map(mesh, np), field, interruption);
  if(tolerance < least_curve_tolerance * surface.longest_side()) {
    std::ostringstream message;
    message << "the tolerance is " << tolerance << ", too small for a mesh with a side of length "
            << surface.longest_side() << ": rounding errors exceed it";
    throw Invalid_parameter_error(message.str());
  }
  return surface;
}

/* Writes the curves that `trace(curves, interruption)` appends, unless the visitor of the named parameters stops it. */
template <class Curve, class NamedParameters, class OutputIterator, class Trace>
OutputIterator write_curves(const NamedParameters& np, OutputIterator out, const Trace& trace)
{
  auto visitor = make_visitor(np);
  Interruption interruption(visitor.get());
  std::vector<Curve> curves = result_unless_interrupted([&] {
    std::vector<Curve> result;
    throw_if_interrupted_before_part(&interruption);
    trace(result, interruption);
    return result;
  });
  return std::move(curves.begin(), curves.end(), out);
}

/* Bounds of the field over all of a piece, computed from its values at the corners. They include these values even if
 * the slope of the field exceeds one. */
struct Field_bounds
{
  double least = std::numeric_limits<double>::infinity(), largest = -least;

  template <class Surface>
  Field_bounds(const Surface& surface, const typename Surface::Piece& piece)
  {
    const double infinity = least;
    double from = -infinity, to = infinity; // by the Lipschitz constant
    bool has_end = false;
    for(Index i = 0; i < 3; ++i) {
      const double d = surface.corner(piece, i).distance;
      const double radius = (std::max)(surface.length(piece.halves[i]), surface.length(piece.halves[(i + 2) % 3]));
      if(std::isinf(d)) {
        has_end = true;
        continue;
      }
      from = (std::max)(from, d - radius);
      to = (std::min)(to, d + radius);
      least = (std::min)(least, d);
      largest = (std::max)(largest, d);
    }
    if(std::isinf(least)) // nothing is known and nothing will be found
      return;
    least = (std::min)(least, from);
    largest = has_end ? infinity : (std::max)(largest, to);
  }
};

/* A crossing of a curve with a side. */
struct Crossing
{
  Index side;
  Sample sample;
  bool is_visited;
};

/* The crossings of one kind, in the order of their sides. */
class Crossings
{
public:
  void push_back(Index side, const Sample& sample) { m_crossings.push_back({side, sample, false}); }

  Crossing& operator[](Index side)
  {
    return *std::lower_bound(m_crossings.begin(), m_crossings.end(), side,
                             [](const Crossing& c, Index s) { return c.side < s; });
  }

  void forget_visits()
  {
    for(Crossing& crossing : m_crossings)
      crossing.is_visited = false;
  }

  auto begin() const { return m_crossings.begin(); }
  auto end() const { return m_crossings.end(); }

private:
  std::vector<Crossing> m_crossings;
};

/* A curve and the place where it ended: at a half on the border, in a piece that it does not pass, or at its start. */
struct Followed_curve
{
  std::vector<Sample> samples;
  std::vector<Index> faces; // those of its segments
  Index last_piece = null_index;
  bool is_closed = false;
};

/* Appends a segment through a face, or the first sample. */
inline void append(Followed_curve& curve, const Sample& sample, Index face)
{
  std::vector<Sample>& samples = curve.samples;
  if(!samples.empty() && samples.back().face == sample.face && samples.back().weights == sample.weights)
    return;
  if(!samples.empty())
    curve.faces.push_back(face);
  samples.push_back(sample);
}

/*
 * Follows the curve from its crossing of a half whose start is inside and whose end is not, as seen from the piece that
 * contains the half; the inside stays on the left.
 *
 *         c
 *        / \          c inside: continue across the side from b to c, otherwise across that from c to a
 *       /   \
 *      a --> b
 *     inside
 */
template <class Surface, class IsInside, class IsEnd>
Followed_curve follow(const Surface& surface, Index half, Crossings& crossings, const IsInside& is_inside,
                      const IsEnd& is_end)
{
  Followed_curve result;
  Index face = null_index; // of the last piece
  for(;;) {
    Crossing& crossing = crossings[half / 2];
    if(crossing.is_visited) {
      result.is_closed = true;
      append(result, Sample(result.samples.front()), face);
      return result;
    }
    crossing.is_visited = true;
    append(result, crossing.sample, face);
    if(surface.is_border(half))
      return result;
    const auto& use = surface.use(half);
    const auto& piece = surface.piece(use.piece);
    face = piece.face;
    if(is_end(piece)) {
      result.last_piece = use.piece;
      return result;
    }
    const bool is_c_inside = is_inside(surface.corner(piece, use.side + 2));
    half = Surface::twin(piece.halves[(use.side + (is_c_inside ? 1 : 2)) % 3]);
  }
}

/* Returns the half of a side in a piece in which it starts inside and ends outside; null_index if that is on the
 * border. */
template <class Surface, class IsInside>
Index entering_half(const Surface& surface, Index side, const IsInside& is_inside)
{
  const Index half = surface.telling_half(2 * side);
  const Index entering = is_inside(surface.sample(surface.tail(half))) ? half : Surface::twin(half);
  return surface.is_border(entering) ? Index(null_index) : entering;
}

template <class Polyline, class Surface>
void write_samples(const Surface& surface, const Followed_curve& curve, Polyline& polyline)
{
  polyline.is_closed = curve.is_closed;
  for(const Sample& sample : curve.samples) {
    polyline.points.push_back(surface.point(sample));
    polyline.locations.push_back(surface.location(sample));
  }
}

/*
 * Omits vertices of curves whose vertices are on the true curve. The pieces of a refined surface are about as large as
 * the tolerance, so that many vertices are needed to find the curve but not to draw it. The remaining segments are
 * chords inside faces of the mesh. The distance of a chord from an arc of length h and radius r is about h^2 / 8r, so
 * that the number of vertices grows like the inverse square root of the tolerance.
 *
 * Every point between a chord and the vertices that it replaces is within the radius of one of these vertices: the
 * chord and a segment in front of it are the long sides of a trapezoid, whose points are at most half the length of the
 * segment along the chord, and the larger height of its ends across, from the nearer end. A function with slopes of at
 * most one therefore differs there from its value on the curve by at most the radius, and a part of the surface that
 * changes sides is within the radius of the curve.
 *
 *            . . v .               v, w  vertices of the curve
 *         .  |       . w           i, j  ends of the chord
 *       .    |         |  .
 *      i ------------------- j
 *
 * Two chords that cross have vertices within twice the tolerance of one another. Vertices are therefore kept, together
 * with their segments, if curves come that close to one another, or if the curve returns or bends sharply. Therefore
 * chords of the same curves do not cross.
 */
template <class Surface>
class Curve_thinner
{
  using Place = typename Surface::Place;

public:
  /* No point on a segment is farther than the tolerance from the nearer end, and no point that a chord replaces is
   * farther than the radius, which must not be larger, from a vertex. */
  Curve_thinner(const Surface& surface, double tolerance, double radius)
    : m_surface(surface)
    , m_tolerance(tolerance)
    , m_radius(radius)
  {
  }

  /* The curves must include all those that must not cross one another. */
  void thin(std::vector<Followed_curve>& curves)
  {
    if(!(m_radius > 0))
      return;
    m_curves.clear();
    for(const Followed_curve& curve : curves)
      measure(curve);
    find_crowds();
    for(std::size_t c = 0; c < curves.size(); ++c)
      thin(curves[c], m_curves[c]);
  }

private:
  // Some vertices, the markers, represent those behind them up to this distance along the curve, in units of the
  // tolerance.
  static constexpr double stride = 0.5;
  // The markers of crossing chords are this close, in units of the tolerance: one on either curve, plus a stride.
  static constexpr double crowd = 2 + 2 * stride;
  // A curve bends sharply if the path along it is longer than the straight line by this factor, as for an arc of more
  // than 130 degrees or two straight lines with an angle of less than 106 degrees.
  static constexpr double bend = 1.25;
  // Closed curves that are shorter, in units of the tolerance, are kept. A longer one that is within the tolerance of a
  // line has crowded markers halfway on both sides, whose distance is at most two tolerances and a stride.
  static constexpr double least_closed = 12;

  struct Measured_curve
  {
    std::vector<Place> places;
    std::vector<double> paths;        // the lengths along the curve to each vertex
    std::vector<std::size_t> markers; // the vertices that represent others
    std::vector<char> is_kept;        // for markers only
    bool is_closed;
  };

  // A vertex in one of its faces, by coordinates there; rows are as wide as a crowd.
  struct Marker
  {
    Index face;
    double row, along;
    std::size_t curve, vertex;

    bool operator<(const Marker& other) const
    {
      return std::tie(face, row, along, curve, vertex) <
             std::tie(other.face, other.row, other.along, other.curve, other.vertex);
    }
  };

  void measure(const Followed_curve& curve)
  {
    const std::size_t n = curve.samples.size();
    m_curves.push_back({{}, {}, {}, std::vector<char>(n, 0), curve.is_closed});
    Measured_curve& m = m_curves.back();
    for(std::size_t i = 0; i < n && n > 1; ++i) {
      m.places.push_back(m_surface.place(curve.samples[i]));
      m.paths.push_back(i == 0 ? 0 : m.paths.back() + distance(m.places[i - 1], m.places[i]));
      const Index before = curve.faces[i == 0 ? 0 : i - 1], behind = curve.faces[(std::min)(i, n - 2)];
      const bool is_end = i == 0 || i + 1 == n, does_end = std::isinf(curve.samples[i].distance); // the field does
      const bool is_marker =
          is_end || does_end || before != behind || m.paths[i] - m.paths[m.markers.back()] > stride * m_tolerance;
      m.markers.push_back(is_marker ? i : m.markers.back());
      m.is_kept[i] = does_end ? 1 : 0;
      if(is_marker)
        add_marker(before, i);
      if(before != behind)
        add_marker(behind, i);
    }
    if(m.is_closed && m.paths.back() <= least_closed * m_tolerance)
      m.is_kept.assign(n, 1);
  }

  // Uses two of the three coordinates, so that distances do not increase.
  void add_marker(Index face, std::size_t vertex)
  {
    const std::array<std::size_t, 2> axes = m_surface.widest_axes(face);
    const Place& p = m_curves.back().places[vertex];
    m_markers.push_back(
        {face, std::floor(p[axes[1]] / (crowd * m_tolerance)), p[axes[0]], m_curves.size() - 1, vertex});
  }

  // Marks vertices that are close to others, in their own rows and the next ones.
  void find_crowds()
  {
    std::sort(m_markers.begin(), m_markers.end());
    for(auto i = m_markers.begin(); i != m_markers.end(); ++i) {
      compare(*i, i + 1, i->row);
      const Marker first = {i->face, i->row + 1, i->along - crowd * m_tolerance, 0, 0};
      compare(*i, std::lower_bound(i, m_markers.end(), first), first.row);
    }
    m_markers.clear();
  }

  void compare(const Marker& a, typename std::vector<Marker>::const_iterator b, double row)
  {
    const double last = a.along + crowd * m_tolerance;
    for(; b != m_markers.end() && b->face == a.face && b->row == row && b->along <= last; ++b)
      if(is_crowd(a, *b))
        m_curves[a.curve].is_kept[a.vertex] = m_curves[b->curve].is_kept[b->vertex] = 1;
  }

  bool is_crowd(const Marker& a, const Marker& b) const
  {
    const Measured_curve &m = m_curves[a.curve], &n = m_curves[b.curve];
    const double straight = distance(m.places[a.vertex], n.places[b.vertex]);
    if(!(straight <= crowd * m_tolerance))
      return false;
    const double path = std::abs(m.paths[a.vertex] - n.paths[b.vertex]);
    return a.curve != b.curve || (m.is_closed ? (std::min)(path, m.paths.back() - path) : path) > bend * straight;
  }

  // ---- chords

  void thin(Followed_curve& curve, const Measured_curve& m) const
  {
    const Followed_curve old = std::move(curve);
    curve = {{old.samples.front()}, {}, old.last_piece, old.is_closed};
    for(std::size_t i = 0, end = 0; i + 1 < old.samples.size();) {
      end = i == end ? end_of_run(old, m, i) : end;
      curve.faces.push_back(old.faces[i]);
      i = end_of_chord(old, m, i, end);
      curve.samples.push_back(old.samples[i]);
    }
  }

  static bool is_kept(const Measured_curve& m, std::size_t i) { return m.is_kept[m.markers[i]] != 0; }

  // The end of the run of segments in one face without kept ends that starts with segment i, which is included in any
  // case.
  static std::size_t end_of_run(const Followed_curve& curve, const Measured_curve& m, std::size_t i)
  {
    std::size_t end = i + 1;
    if(!is_kept(m, i) && !is_kept(m, end))
      while(end < curve.faces.size() && curve.faces[end] == curve.faces[i] && !is_kept(m, end + 1))
        ++end;
    return end;
  }

  // The end of the longest chord found from a vertex: the step is doubled while there is a chord, and then halved.
  std::size_t end_of_chord(const Followed_curve& curve, const Measured_curve& m, std::size_t i, std::size_t end) const
  {
    std::size_t result = i + 1;
    bool is_growing = true;
    for(std::size_t step = 1; step > 0; step = is_growing ? 2 * step : step / 2)
      if(step <= end - result && is_chord(curve, m, i, result + step))
        result += step;
      else
        is_growing = false;
    return result;
  }

  bool is_chord(const Followed_curve& curve, const Measured_curve& m, std::size_t i, std::size_t j) const
  {
    if(is_pressed_on_edge(curve.samples, i, j))
      return false;
    const double length = distance(m.places[i], m.places[j]);
    if(!(length > 0))
      return false;
    double along = 0, height = 0;
    for(std::size_t k = i; k < j; ++k) {
      const std::array<double, 2> next = coordinates(m.places[k + 1], m.places[i], m.places[j], length);
      if(!(next[0] >= along && std::hypot((m.paths[k + 1] - m.paths[k]) / 2, (std::max)(height, next[1])) <= m_radius))
        return false;
      along = next[0];
      height = next[1];
    }
    return true;
  }

  // Returns whether a chord would run along an edge of the mesh, where chords from the other side may run, although the
  // replaced vertices do not. Points on an edge are expressed in one face.
  static bool is_pressed_on_edge(const std::vector<Sample>& samples, std::size_t i, std::size_t j)
  {
    const auto is_on_edge = [&](std::size_t k, std::size_t l, int corner) {
      return samples[k].face == samples[l].face && samples[k].weights[corner] == 0 && samples[l].weights[corner] == 0;
    };
    for(int corner = 0; corner < 3; ++corner)
      if(is_on_edge(i, j, corner))
        for(std::size_t k = i + 1; k < j; ++k)
          if(!is_on_edge(i, k, corner))
            return true;
    return false;
  }

  // The position of a point along the line from p to q, and its distance from the line.
  static std::array<double, 2> coordinates(const Place& place, const Place& p, const Place& q, double length)
  {
    double along = 0, square = 0;
    for(std::size_t d = 0; d < 3; ++d)
      along += (place[d] - p[d]) * ((q[d] - p[d]) / length);
    for(std::size_t d = 0; d < 3; ++d) {
      const double across = place[d] - p[d] - along * ((q[d] - p[d]) / length);
      square += across * across;
    }
    return {{along, std::sqrt(square)}};
  }

  static double distance(const Place& p, const Place& q) { return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]); }

  const Surface& m_surface;
  double m_tolerance, m_radius;
  std::vector<Measured_curve> m_curves;
  std::vector<Marker> m_markers;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CURVE_THINNER_H
