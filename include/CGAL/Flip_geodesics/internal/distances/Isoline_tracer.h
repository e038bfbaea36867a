// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ISOLINE_TRACER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ISOLINE_TRACER_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Refined_surface.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/container/flat_map.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

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
  static_assert(
      has_faces<TriangleMesh>,
      "the first argument must be a mesh; the order of the arguments is mesh, field, levels if any, output, tolerance");
  static_assert(is_distance_field<Field, TriangleMesh>,
                "the second argument must be a model of GeodesicDistanceField for the mesh");
  static_assert(
      std::is_convertible<Tolerance, double>::value,
      "a tolerance is expected here; the order of the arguments is mesh, field, levels if any, output, tolerance");
  return true;
}

inline void check_tolerance(double tolerance)
{
  if(tolerance > 0 && std::isfinite(tolerance))
    return;
  throw Invalid_parameter_error("the tolerance is " + written(tolerance) + ", but must be positive and finite");
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
  if(tolerance < least_curve_tolerance * surface.longest_side())
    throw Invalid_parameter_error("the tolerance is " + written(tolerance) +
                                  ", which is less than the rounding errors on a mesh with an edge of length " +
                                  written(surface.longest_side()));
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
  Sample sample;
  bool is_visited = false;
};

/* The crossings of one kind, by their sides. */
using Crossings = boost::container::flat_map<Index, Crossing>;

/* Adds the crossing of the side of a half, the last of all sides so far. */
inline void add_crossing(Crossings& crossings, Index half, const Sample& sample)
{
  crossings.emplace_hint(crossings.end(), half / 2, Crossing{sample});
}

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
    Crossing& crossing = crossings.at(half / 2);
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
  const Index half = surface.reference_half(2 * side);
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
 * the tolerance, so many vertices are needed to find the curve but not to draw it. The remaining segments are
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

/*
 * The isolines of several levels on one refined surface. A corner is inside if its distance is less than the level, so
 * that a distance equal to the level is not a special case. On each side the crossings of larger levels come after
 * those of smaller ones, and isolines therefore do not cross.
 */
template <class Surface>
class Isoline_tracer
{
public:
  /* The levels must be sorted; only the first of equal ones may be traced. */
  Isoline_tracer(Surface& surface, const std::vector<double>& levels, double tolerance)
    : m_surface(surface)
    , m_levels(levels)
    , m_tolerance(tolerance)
    , m_crossings(levels.size())
  {
    const double largest_side = side_by_tolerance * tolerance;
    surface.refine([&](const auto& piece) {
      if(surface.length(surface.longest(piece)) <= largest_side)
        return true;
      const Field_bounds bounds(surface, piece);
      const auto level = std::lower_bound(m_levels.begin(), m_levels.end(), bounds.least);
      return level == m_levels.end() || *level > bounds.largest;
    });
    for(Index half = 0; half < surface.number_of_halves(); half += 2)
      if(!surface.is_border(half) || !surface.is_border(half + 1))
        find_crossings(surface.reference_half(half));
  }

  /* Calls `write(curve)` for the curves of a level; those that end on the border come first. */
  template <class Write>
  void trace(std::size_t level, const Write& write)
  {
    std::vector<Followed_curve> curves = followed(level);
    Curve_thinner<Surface>(m_surface, m_tolerance, radius(level)).thin(curves);
    for(const Followed_curve& curve : curves)
      write(curve);
  }

private:
  // The distance of replaced vertices from their chord is at most this radius. The field on a chord differs from its
  // level by at most as much, so chords of two levels do not meet within half of their difference.
  double radius(std::size_t level) const
  {
    const double at = m_levels[level];
    const auto [first, last] = std::equal_range(m_levels.begin(), m_levels.end(), at);
    double result = m_tolerance;
    if(first != m_levels.begin())
      result = (std::min)(result, (at - first[-1]) / 2);
    return last == m_levels.end() ? result : (std::min)(result, (*last - at) / 2);
  }

  std::vector<Followed_curve> followed(std::size_t level)
  {
    std::vector<Followed_curve> curves;
    Crossings& crossings = m_crossings[level];
    for(auto& [side, crossing] : crossings)
      crossing.is_visited = false; // a level may be traced again
    const auto is_inside = [&](const Sample& sample) { return sample.distance < m_levels[level]; };
    const auto is_end = [](const auto&) { return false; };
    for(bool is_from_border : {true, false})
      for(const auto& [side, crossing] : crossings) {
        const Index half = entering_half(m_surface, side, is_inside);
        if(crossing.is_visited || half == null_index || (is_from_border && !m_surface.is_border(Surface::twin(half))))
          continue;
        Followed_curve curve = follow(m_surface, half, crossings, is_inside, is_end);
        if(curve.samples.size() > 1) // otherwise a point
          curves.push_back(std::move(curve));
      }
    return curves;
  }

  void find_crossings(Index half)
  {
    const Sample &tail = m_surface.sample(m_surface.tail(half)), &head = m_surface.sample(m_surface.head(half));
    const bool is_rising = tail.distance < head.distance;
    const Sample &lower = is_rising ? tail : head, &upper = is_rising ? head : tail;
    auto level = std::upper_bound(m_levels.begin(), m_levels.end(), lower.distance);
    double from = 0;
    Sample last = lower;
    for(; level != m_levels.end() && *level <= upper.distance; ++level) {
      if(last.distance < *level) { // otherwise two levels differ by rounding errors only
        from = root(half, is_rising, *level, from, last, upper);
        last = from == 1 ? upper : m_surface.sampled(half, is_rising ? from : 1 - from);
      }
      add_crossing(m_crossings[static_cast<std::size_t>(level - m_levels.begin())], half, last);
    }
  }

  // The fraction of the path from the lower end to the upper one at which the level is first reached, even if it stays
  // there.
  double root(Index half, bool is_rising, double level, double from, const Sample& last, const Sample& upper) const
  {
    const double length = m_surface.length(half);
    const double precision = root_precision * (std::max)(std::abs(level), length) / length;
    // The level itself belongs to the farther side. The step makes the next evaluation find the other side within the
    // precision; infinity cannot be used in computations.
    const double step = precision * length / 2;
    const auto excess = [&](double distance) {
      return distance < level ? distance - level : (std::min)(distance - level + step, 2 * length + step);
    };
    std::uintmax_t most_steps = 200;
    const auto bracket = boost::math::tools::toms748_solve(
        [&](double s) { return excess(m_surface.sampled(half, is_rising ? s : 1 - s).distance); }, from, 1.0,
        excess(last.distance), excess(upper.distance), [&](double a, double b) { return b - a <= precision; },
        most_steps);
    return bracket.second;
  }

  const Surface& m_surface;
  const std::vector<double>& m_levels;
  double m_tolerance;
  std::vector<Crossings> m_crossings; // by level
};

/*
 * The boundaries of Voronoi regions on a refined surface. A piece whose corners have three sources has a junction.
 *
 * For some fields, faces in which one source is nearest everywhere are known, and these are not divided. Otherwise a
 * field provides the nearest source, but not the distance of the next one, so no bound excludes a boundary in a
 * piece whose corners have one source. Pieces therefore have sides of at most sqrt(tolerance * size), and a boundary
 * that bends no more than a circle of an eighth of the size leaves such a piece by less than the tolerance, through one
 * side and back.
 */
template <class Surface>
class Voronoi_tracer
{
public:
  Voronoi_tracer(Surface& surface, double tolerance)
    : m_surface(surface)
    , m_tolerance(tolerance)
  {
    const double largest_side = side_by_tolerance * tolerance, largest_junction = junction_by_tolerance * tolerance,
                 largest_distance = std::sqrt(tolerance * std::sqrt(surface.area()));
    std::vector<char> has_one_source;
    for(Index face = 0; face < surface.number_of_faces(); ++face)
      has_one_source.push_back(surface.has_one_source(face) ? 1 : 0);
    surface.refine([&](const auto& piece) {
      const double length = surface.length(surface.longest(piece));
      if(length <= largest_side)
        return length <= largest_junction || !is_junction(piece);
      if(is_divided(piece))
        return false;
      if(has_one_source[piece.face] != 0)
        return true;
      const Field_bounds bounds(surface, piece);
      return (length <= largest_distance || std::isinf(bounds.least)) &&
             !(bounds.least <= 0 && 0 <= bounds.largest); // a source may be inside
    });
    find_crossings();
    find_junctions();
  }

  /* Calls `write(curve, {left source, right source}, {first junction, last junction})`. */
  template <class Write>
  void trace(const Write& write)
  {
    follow_boundaries();
    Curve_thinner<Surface>(m_surface, m_tolerance, m_tolerance).thin(m_curves);
    for(std::size_t i = 0; i < m_curves.size(); ++i)
      write(m_curves[i], m_ends[i].sources, m_ends[i].junctions);
  }

private:
  using Piece = typename Surface::Piece;

  void follow_boundaries()
  {
    for(std::size_t j = 0; j < m_junctions.size(); ++j)
      for(Index half : m_surface.piece(m_junctions[j].piece).halves)
        if(!m_crossings.at(half / 2).is_visited)
          trace_from(Surface::twin(half), m_surface.sample(m_surface.head(half)).source,
                     m_surface.sample(m_surface.tail(half)).source, j);
    for(bool is_from_border : {true, false})
      for(const auto& [side, crossing] : m_crossings) {
        const Index half = m_surface.reference_half(2 * side);
        if(!crossing.is_visited && (!is_from_border || m_surface.is_border(Surface::twin(half))))
          trace_from(half, m_surface.sample(m_surface.tail(half)).source, m_surface.sample(m_surface.head(half)).source,
                     no_source);
      }
  }

  // Pieces with three sources have sides of at most this length, in units of the tolerance.
  static constexpr double junction_by_tolerance = 0.01;

  struct Junction
  {
    Index piece;
    Sample sample;
  };

  struct Ends
  {
    std::array<std::size_t, 2> sources, junctions; // left and right; first and last
  };

  bool is_divided(const Piece& piece) const
  {
    const std::size_t source = m_surface.corner(piece, 0).source;
    return m_surface.corner(piece, 1).source != source || m_surface.corner(piece, 2).source != source;
  }

  bool is_junction(const Piece& piece) const
  {
    const std::size_t a = m_surface.corner(piece, 0).source, b = m_surface.corner(piece, 1).source,
                      c = m_surface.corner(piece, 2).source;
    return a != b && b != c && c != a;
  }

  void find_crossings()
  {
    for(Index half = 0; half < m_surface.number_of_halves(); half += 2) {
      if(m_surface.is_border(half) && m_surface.is_border(half + 1))
        continue;
      const Index h = m_surface.reference_half(half);
      const Sample &tail = m_surface.sample(m_surface.tail(h)), &head = m_surface.sample(m_surface.head(h));
      if(tail.source != head.source)
        add_crossing(m_crossings, half, change(h, tail, head));
    }
  }

  // The nearest known point on one side of a change of sources, and the rate at which the distance changes from there.
  struct Approach
  {
    double t, distance, slope;

    void come_to(double other, double d)
    {
      slope = (d - distance) / (other - t);
      t = other;
      distance = d;
    }
    double at(double other) const { return distance + slope * (other - t); }
  };

  // The position at which two linearly extrapolated distances are equal; NaN if a rate is unknown.
  static double guess(const Approach& from, const Approach& to)
  {
    return from.t + (to.at(from.t) - from.distance) / (from.slope - to.slope);
  }

  // The point at which the source at the tail of a half ceases to be the nearest. Two guesses slightly before and
  // beyond the position of apparently equal distances enclose it if they are good; otherwise the midpoint halves the
  // interval.
  Sample change(Index half, const Sample& tail, const Sample& head) const
  {
    const double unknown = std::numeric_limits<double>::quiet_NaN(), length = m_surface.length(half),
                 scale = (std::max)(length, (std::min)(tail.distance, head.distance));
    const double precision = root_precision * scale / length;
    Approach from = {0, tail.distance, unknown}, to = {1, head.distance, unknown};
    const auto ask = [&](double t) {
      if(!(from.t < t && t < to.t))
        return;
      const Sample sample = m_surface.sampled(half, t);
      (sample.source == tail.source ? from : to).come_to(t, sample.distance);
    };
    for(double last = 0.5; length > 0 && to.t - from.t > precision;) {
      const double width = to.t - from.t, t = guess(from, to),
                   margin = (std::max)(precision / 4, (std::min)(width / 8, std::abs(t - last)));
      ask(t - margin);
      ask(t + margin);
      if(!(to.t - from.t <= width / 2))
        ask(from.t + (to.t - from.t) / 2);
      last = t;
    }
    return from.t == 0 ? tail : (to.t == 1 ? head : m_surface.sampled(half, to.t));
  }

  Sample center(const Piece& piece) const
  {
    const std::array<Weights_in_face, 3>& w = piece.weights;
    return m_surface.sampled(piece.face, between(between(w[0], w[1], 0.5), w[2], 1.0 / 3));
  }

  void find_junctions()
  {
    for(Index p = 0; p < m_surface.number_of_pieces(); ++p)
      if(is_junction(m_surface.piece(p))) {
        m_junction_of_piece[p] = m_junctions.size();
        m_junctions.push_back({p, center(m_surface.piece(p))});
      }
  }

  void trace_from(Index half, std::size_t left, std::size_t right, std::size_t first_junction)
  {
    const auto is_inside = [&](const Sample& sample) { return sample.source == left; };
    const auto is_end = [&](const Piece& piece) { return is_junction(piece); };
    Followed_curve curve = follow(m_surface, half, m_crossings, is_inside, is_end);
    std::size_t last_junction = no_source;
    if(first_junction != no_source) {
      const Junction& junction = m_junctions[first_junction];
      curve.samples.insert(curve.samples.begin(), junction.sample);
      curve.faces.insert(curve.faces.begin(), m_surface.piece(junction.piece).face);
    }
    if(curve.last_piece != null_index) {
      last_junction = m_junction_of_piece.at(curve.last_piece);
      curve.samples.push_back(m_junctions[last_junction].sample);
      curve.faces.push_back(m_surface.piece(curve.last_piece).face);
    }
    if(curve.samples.size() < 2) // a point
      return;
    m_curves.push_back(std::move(curve));
    m_ends.push_back({{{left, right}}, {{first_junction, last_junction}}});
  }

  const Surface& m_surface;
  double m_tolerance;
  Crossings m_crossings;
  std::vector<Junction> m_junctions;
  std::unordered_map<Index, std::size_t> m_junction_of_piece;
  std::vector<Followed_curve> m_curves;
  std::vector<Ends> m_ends; // of the curves
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ISOLINE_TRACER_H
