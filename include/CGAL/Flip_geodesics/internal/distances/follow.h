// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FOLLOW_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FOLLOW_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Refined_surface.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/make_visitor.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Sides of a piece that a curve crosses may have this length, in tolerances. All of the piece is within the tolerance
 * of its corners then, and its center of all of its sides, since no median is longer than the longest side. */
inline constexpr double side_by_tolerance = 1.5;

/* Can a field be asked about places in the faces of a mesh? Of what is no mesh nothing is said. */
template <class Field, class TriangleMesh, bool IS_MESH = Has_faces<TriangleMesh>::value>
constexpr bool is_distance_field = true;
template <class Field, class TriangleMesh>
constexpr bool is_distance_field<Field, TriangleMesh, true> =
    std::is_invocable<const Field&, typename boost::graph_traits<TriangleMesh>::face_descriptor,
                      const Weights_in_face&>::value;

/* Ends the compilation if a mesh, a field and a tolerance are given in another order. */
template <class TriangleMesh, class Field, class Tolerance>
constexpr bool are_in_order()
{
  static_assert(Has_faces<TriangleMesh>::value,
                "the first argument is no mesh; the order is mesh, field, levels if any, output, tolerance");
  static_assert(is_distance_field<Field, TriangleMesh>,
                "the second argument is no model of GeodesicDistanceField for the mesh");
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

/* The points that are given, or else the mesh's own. */
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

/* Throws Invalid_parameter_error where a tolerance is lost in the roundings of weights. */
template <class TriangleMesh, class NamedParameters, class Field>
auto make_refined_surface(const TriangleMesh& mesh, const Field& field, const NamedParameters& np, double tolerance,
                          Interruption& interruption)
{
  using Surface = Refined_surface<TriangleMesh, Point_map<TriangleMesh, NamedParameters>, Field>;
  Surface surface(mesh, point_map(mesh, np), field, interruption);
  if(tolerance < least_curve_tolerance * surface.longest_side()) {
    std::ostringstream message;
    message << "the tolerance is " << tolerance << ", too small for a mesh with a side of length "
            << surface.longest_side() << ": roundings hide it";
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
  std::vector<Curve> result;
  try {
    throw_if_interrupted_before_part(&interruption);
    trace(result, interruption);
  } catch(const Interrupted&) {
    return out;
  }
  return std::move(result.begin(), result.end(), out);
}

/* Bounds of the field over all of a piece, by its values at the corners. They hold for all corners as well, also where
 * the field has larger slopes than one. */
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
    if(std::isinf(least)) // nothing is known, nothing to be found
      return;
    least = (std::min)(least, from);
    largest = has_end ? infinity : (std::max)(largest, to);
  }
};

/* Where a curve crosses a side. */
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

/* A curve, and where it ended: at a half on the border, in a piece that it does not pass, or where it began. */
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
 * The curve from the crossing of a half on, whose start is inside and whose end is not, as seen from the piece that has
 * the half: what is inside stays on the left.
 *
 *         c
 *        / \          c inside: on over the side from b to c, else over that from c to a
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

/* The half of a side in a piece in which it starts inside and ends outside; null_index if that is on the border. */
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
  using Point = typename decltype(polyline.points)::value_type;
  polyline.is_closed = curve.is_closed;
  for(const Sample& sample : curve.samples) {
    const auto p = surface.place(sample);
    polyline.points.push_back(Point(p[0], p[1], p[2]));
    polyline.locations.push_back(surface.location(sample));
  }
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FOLLOW_H
