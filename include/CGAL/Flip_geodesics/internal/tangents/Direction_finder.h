// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_DIRECTION_FINDER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_DIRECTION_FINDER_H

#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>
#include <CGAL/Flip_geodesics/internal/tangents/Ray.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Where a ray starts: a place told from a halfedge of its first face, and a direction in that face. Or a vertex of the
 * border, and an angle from that halfedge out of the surface. */
struct Ray_start
{
  Surface_location place;
  Face_direction direction;
  bool is_outward = false;
  double angle = 0;
};

/* Turns angles and vectors in space into directions in faces. These are rounded; what follows from them is exact. */
template <class Triangulation>
class Direction_finder
{
public:
  explicit Direction_finder(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /*
   * By an angle counterclockwise from a side of a face that has the location; at a vertex over all faces about it.
   *
   * \throws Invalid_parameter_error if it is no such halfedge
   */
  Ray_start by_angle(const Surface_location& location, Input_halfedge_index h, double angle) const
  {
    check_location(input(), location);
    if(!h.is_valid() || h.idx() >= input().number_of_halfedges())
      throw Invalid_parameter_error("a direction is told from a halfedge that the mesh does not have");
    if(!std::isfinite(angle))
      throw Invalid_parameter_error("the angle of a direction is no finite number");
    const Surface_location at = canonical_location(input(), location);
    if(kind(at) == Location_kind::VERTEX)
      return at_vertex_of_face(h, input().tail(at.halfedge), angle);
    if(!is_side_of(h, at.halfedge) && !(kind(at) == Location_kind::EDGE && is_side_of(h, twin_index(at.halfedge))))
      throw Invalid_parameter_error("a direction is told from halfedge " + std::to_string(h.idx()) +
                                    ", which is no side of a face of the location");
    return told_well(at, h, angle);
  }

  /* By a direction in the face of the location's halfedge, which is taken as it is unless it leaves the face at once at
   * a vertex. */
  Ray_start by_direction(const Surface_location& location, const Face_direction& direction) const
  {
    check_location(input(), location);
    if(!std::isfinite(direction[0]) || !std::isfinite(direction[1]) || (direction[0] == 0 && direction[1] == 0))
      throw Invalid_parameter_error("a direction has no length in its face, or is not finite");
    if(input().is_border(location.halfedge))
      throw Invalid_parameter_error("a direction is told in the face of a halfedge on the border");
    Ray_start start = {location, normalized(direction), false, 0};
    if(kind(location) != Location_kind::VERTEX)
      return start;
    while(start.place.weights[0] == 0)
      start = {rotated(input(), start.place),
               normalized({start.direction[1], -start.direction[0] - start.direction[1]}), false, 0};
    if(start.direction[0] >= 0 && start.direction[1] >= 0)
      return start;
    const auto [length, third] = corners(start.place.halfedge);
    return at_vertex(start.place.halfedge, std::arg(start.direction[0] * length + start.direction[1] * third));
  }

  /* On from a vertex, at an angle counterclockwise from a halfedge that starts there. */
  Ray_start at_vertex(Input_halfedge_index h, double angle) const
  {
    const Vertex_fan fan = fan_of(h);
    const double total = fan.total();
    double position = fan.angle_of(h, input().tail(h)) + angle;
    if(!fan.has_border())
      position -= total * std::floor(position / total);
    const double allowed = direction_rounding * total;
    if(!(position >= -allowed && position <= total + allowed))
      return {{fan.halfedges().front().halfedge, {{1, 0, 0}}}, {0, 0}, true, position};
    const Vertex_fan::Turn turn = fan.turn_at(position);
    return {{turn.halfedge, {{1, 0, 0}}}, inside_corner(turn.halfedge, turn.angle, turn.corner), false, 0};
  }

  /* On from a vertex, at an angle from a side of a face that has it. */
  Ray_start at_vertex_of_face(Input_halfedge_index h, Vertex_index v, double angle) const
  {
    if(input().tail(h) == v)
      return at_vertex(h, angle);
    Input_halfedge_index side = h;
    while(input().tail(side) != v) { // the next side is turned by the outer angle between them
      side = input().next(side);
      if(side == h || input().is_border(h))
        throw Invalid_parameter_error("a direction is told from halfedge " + std::to_string(h.idx()) +
                                      ", which is no side of a face of the location");
      angle -= boost::math::constants::pi<double>() - corner(side);
    }
    return at_vertex(side, angle);
  }

  /* The sum of the angles about the tail of a halfedge; infinite on the border. */
  double total_angle(Input_halfedge_index h) const
  {
    const Vertex_fan fan = fan_of(h);
    return fan.has_border() ? std::numeric_limits<double>::infinity() : fan.total();
  }

private:
  const auto& input() const { return m_triangulation.input(); }

  // With the corners as they are in the frames of directions.
  Vertex_fan fan_of(Input_halfedge_index h) const
  {
    Vertex_fan fan;
    fan.collect_umbrella(input(), h, [this](Input_halfedge_index g) { return corner(g); });
    return fan;
  }

  bool is_side_of(Input_halfedge_index h, Input_halfedge_index face) const
  {
    return !input().is_border(face) && internal::is_side_of(input(), h, face);
  }

  // From the tail of h: its head, on the real axis, and the third corner of its face.
  std::pair<double, std::complex<double>> corners(Input_halfedge_index h) const
  {
    const auto face = input_face_geometry(m_triangulation, h);
    return {face[0].x, {-face[2].x, -face[2].y}};
  }

  double corner(Input_halfedge_index h) const { return std::arg(corners(h).second); }

  Face_direction in_face(Input_halfedge_index h, double x, double y) const
  {
    const auto [length, third] = corners(h);
    if(y != 0 && !(third.imag() > 0))
      throw Degenerate_face_error("a direction is told in the face of halfedge " + std::to_string(h.idx()) +
                                      ", which has no area",
                                  {static_cast<std::size_t>(h.idx())});
    const double up = y == 0 ? 0 : y / third.imag();
    return normalized({(x - up * third.real()) / length, up});
  }

  /*
   * An angle from a side, told from another one if that one's corner is far less acute or obtuse: a direction in two
   * sides that are nearly parallel would lose its digits.
   */
  Ray_start told_well(const Surface_location& at, Input_halfedge_index h, double angle) const
  {
    constexpr double far_less = 1.0 / 16;
    Input_halfedge_index best = h, side = h;
    double best_angle = angle, least = far_less * length(h) * length(input().next(input().next(h)));
    double angle_at_edge = angle;
    for(int i = 0; i < 2; ++i) {
      const double before = length(side);
      side = input().next(side);
      angle -= boost::math::constants::pi<double>() - corner(side);
      angle_at_edge = side == at.halfedge ? angle : angle_at_edge;
      if(before * length(side) < least) { // twice the area is this times the sine of the corner
        least = before * length(side);
        best = side;
        best_angle = angle;
      }
    }
    const Face_direction direction = in_face(best, std::cos(best_angle), std::sin(best_angle));
    // An angle along the border is along it, though rounding leads out of the surface, or into it a little.
    const double off = std::abs(std::sin(angle_at_edge));
    if(kind(at) == Location_kind::EDGE && input().is_border(twin_index(at.halfedge)) &&
       off <= (away_from_side(at.halfedge, best, direction) < 0 ? off_border : into_border))
      return {at, {std::copysign(1, std::cos(angle_at_edge)), 0}, false, 0};
    return {{best, weights_in_face(input(), at, best)}, direction, false, 0};
  }

  // How the weight opposite to a side of a face changes in a direction that is told from any side; its sign is exact.
  double away_from_side(Input_halfedge_index side, Input_halfedge_index told_from, const Face_direction& d) const
  {
    if(side == told_from)
      return d[1];
    return input().next(side) == told_from ? d[0] : -d[0] - d[1];
  }

  double length(Input_halfedge_index h) const { return m_triangulation.metric().length(input(), h); }

  // In the corner at the tail of h, whose sides are met by rounding as well.
  Face_direction inside_corner(Input_halfedge_index h, double angle, double whole) const
  {
    if(angle <= 0)
      return {1, 0};
    if(angle >= whole)
      return {0, 1};
    const Face_direction d = in_face(h, std::cos(angle), std::sin(angle));
    return normalized({(std::max)(d[0], 0.0), (std::max)(d[1], 0.0)});
  }

  // Over a power of two, so that the larger number is between 1 and 2, without numbers whose products could underflow.
  static Face_direction normalized(const Face_direction& d)
  {
    const int exponent = std::ilogb((std::max)(std::abs(d[0]), std::abs(d[1])));
    const auto number = [exponent](double x) {
      const double scaled = std::scalbn(x, -exponent);
      return std::abs(scaled) < least_weight ? 0 : scaled;
    };
    return {number(d[0]), number(d[1])};
  }

  const Triangulation& m_triangulation;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_DIRECTION_FINDER_H
