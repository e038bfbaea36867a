// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_PLACE_FRAME_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_PLACE_FRAME_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <CGAL/number_utils.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <complex>
#include <cstddef>

namespace CGAL::Flip_geodesics::internal {

/* Returns the direction, of length 1, of a side of the face of h in the frame in which h is the positive real axis. */
template <class Triangulation>
std::complex<double> direction_of_side(const Triangulation& triangulation, Input_halfedge_index h,
                                       Input_halfedge_index side)
{
  if(side == h)
    return 1;
  const auto face = input_face_geometry(triangulation, h);
  const auto& along = side == triangulation.input().next(h) ? face[1] : face[2];
  const std::complex<double> result(along.x, along.y);
  return result / std::abs(result);
}

/* The plane of a face in space, with the frame of its halfedge h, which lies on the x-axis. The sides are scaled first,
 * so that no product underflows. */
template <class Triangulation>
class Face_plane
{
public:
  Face_plane(const Triangulation& triangulation, Input_halfedge_index h)
  {
    const auto& input = triangulation.input();
    const auto corner = [&](Input_halfedge_index side) {
      const auto p = triangulation.metric().point(input, input.uncontracted_tail(side));
      return Place_in_space{{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
    };
    const Place_in_space p = corner(h);
    m_x = unit(difference(corner(input.next(h)), p));
    m_normal = unit(cross(m_x, unit(difference(corner(input.next(input.next(h))), p))));
    m_y = cross(m_normal, m_x);
  }

  /* Returns the unit normal; zero if the face is degenerate. */
  const Place_in_space& normal() const { return m_normal; }

  /* Returns the projection of a vector in space. */
  std::complex<double> in_plane(const Place_in_space& v) const { return {dot(v, m_x), dot(v, m_y)}; }

  Place_in_space in_space(const std::complex<double>& v) const
  {
    Place_in_space result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = v.real() * m_x[i] + v.imag() * m_y[i];
    return result;
  }

private:
  static Place_in_space unit(Place_in_space v)
  {
    const double length = std::hypot(v[0], v[1], v[2]);
    for(double& x : v)
      x = length > 0 ? x / length : 0;
    return v;
  }

  Place_in_space m_x, m_y, m_normal;
};

/*
 * The directions at a surface point as positions, in radians, counterclockwise over all faces that contain it: the
 * angles of a `Vertex_fan`, which begin at the halfedge of the point unless that is a vertex. At a non-manifold vertex
 * they are those of one umbrella.
 */
template <class Triangulation>
class Place_frame
{
public:
  using Vector = std::complex<double>;

  /* \param place a canonical surface point */
  Place_frame(const Triangulation& triangulation, const Surface_location& place)
    : m_triangulation(triangulation)
    , m_place(place)
  {
    if(is_vertex())
      m_fan = umbrella_of(triangulation, input().outgoing(vertex()));
    else
      m_fan.set_flat(place.halfedge,
                     kind(place) == Location_kind::EDGE && input().is_border(twin_index(place.halfedge)));
  }

  /* In the umbrella of a face that contains the point. */
  Place_frame(const Triangulation& triangulation, const Surface_location& place, Input_halfedge_index face)
    : Place_frame(triangulation, place)
  {
    if(!has(face))
      m_fan = umbrella_of(triangulation, corner(face));
  }

  /* Returns whether it has the directions of a face that contains the point. */
  bool has(Input_halfedge_index face) const { return !is_vertex() || m_fan.has(corner(face)); }

  /* Returns the angle counterclockwise from one position to another; infinite if the border intervenes. */
  double counterclockwise(double from, double to) const { return m_fan.counterclockwise(from, to); }

  bool has_border() const { return m_fan.has_border(); }

  /* Returns whether directions that differ by the total angle are the same. A point of a border edge has the other half
   * of its plane. */
  bool has_whole_turns() const { return !is_vertex() || !has_border(); }

  /* Returns the total angle at the point. */
  double total() const { return m_fan.total(); }

  /* Returns the factor that scales positions such that a full turn is 2 pi; 1 on the border. */
  double stretch() const
  {
    return is_vertex() && !has_border() ? boost::math::constants::two_pi<double>() / total() : 1;
  }

  /* Returns the position of a direction in a face that contains the point, in the frame of the face's halfedge h. */
  double position(Input_halfedge_index h, const Vector& direction) const
  {
    if(is_vertex()) {
      const Input_halfedge_index c = corner(h);
      return m_fan.angle_of(c, vertex()) + std::arg(direction / direction_of_side(m_triangulation, h, c));
    }
    if(least_in_face(input(), h) == least_in_face(input(), m_place.halfedge))
      return std::arg(direction / direction_of_side(m_triangulation, h, m_place.halfedge));
    return std::arg(-direction / direction_of_side(m_triangulation, h, twin_index(m_place.halfedge)));
  }

  /* Returns the direction, of length 1, at a position in the frame of a halfedge h of a face that contains the point.
   * At a vertex, a direction outside of the face is turned out of it by its angle, on the side of the smaller
   * angle. */
  Vector direction(double position, Input_halfedge_index h) const
  {
    if(!is_vertex())
      return std::polar(1.0, position - this->position(h, 1));
    const Input_halfedge_index c = corner(h);
    const double inside = std::arg(-direction_of_side(m_triangulation, c, input().next(input().next(c))));
    double from_corner = angle(position, c);
    if(has_whole_turns() && from_corner > (total() + inside) / 2)
      from_corner -= total();
    return direction_of_side(m_triangulation, h, c) * std::polar(1.0, from_corner);
  }

  /* Returns the position of a side of a face that contains the point, or of a halfedge that starts there.
   * \throws Invalid_parameter_error if it is neither */
  double position(Input_halfedge_index h) const
  {
    check_reference(input(), h);
    if(is_vertex())
      return position_at_vertex(h);
    const bool is_in_face = !input().is_border(h);
    const Input_halfedge_index t = twin_index(m_place.halfedge);
    if(is_in_face && (least_in_face(input(), h) == least_in_face(input(), m_place.halfedge) ||
                      (kind(m_place) == Location_kind::EDGE && !input().is_border(t) &&
                       least_in_face(input(), h) == least_in_face(input(), t))))
      return position(h, 1);
    throw_no_side(h);
  }

  /* Returns the angle counterclockwise to a position from that of a halfedge; nonnegative except at vertices of the
   * border. */
  double angle(double position, Input_halfedge_index from) const
  {
    const double result = position - this->position(from);
    return has_whole_turns() ? reduced(result) : result;
  }

  /* Returns, of the angles of a direction, which differ by full turns, the one returned by `angle()`: at vertices of
   * the border that nearest to the middle of the surface, where other angles lead out of it. */
  double same_direction(double angle, Input_halfedge_index from) const
  {
    if(has_whole_turns())
      return reduced(angle);
    constexpr double turn = boost::math::constants::two_pi<double>();
    return angle + turn * std::round((total() / 2 - position(from) - angle) / turn);
  }

  /* Returns a halfedge to which directions at a surface point can refer: its own, or else that of the frame's point. */
  Input_halfedge_index reference(const Surface_location& location) const
  {
    return input().is_border(location.halfedge) ? m_place.halfedge : location.halfedge;
  }

  /* Returns the halfedge of the face of h that starts at the point. \pre it is a vertex */
  Input_halfedge_index corner(Input_halfedge_index h) const
  {
    const Vertex_index v = vertex();
    for(int i = 0; i < 2 && input().tail(h) != v; ++i)
      h = input().next(h);
    return h;
  }

private:
  const auto& input() const { return m_triangulation.input(); }
  bool is_vertex() const { return kind(m_place) == Location_kind::VERTEX; }
  Vertex_index vertex() const { return input().tail(m_place.halfedge); }

  double reduced(double angle) const
  {
    const double turn = is_vertex() ? total() : boost::math::constants::two_pi<double>();
    const double result = angle - turn * std::floor(angle / turn);
    return result < turn ? result : 0;
  }

  double position_at_vertex(Input_halfedge_index h) const
  {
    const Vertex_index v = vertex();
    if(input().tail(h) == v)
      return m_fan.angle_of(h, v);
    if(input().is_border(h))
      throw_no_side(h);
    const Input_halfedge_index c = corner(h);
    if(input().tail(c) != v)
      throw_no_side(h);
    // Clockwise around the face, like a `Direction_finder`: angles that differ by a full turn are different directions
    // there.
    const double angle = std::arg(direction_of_side(m_triangulation, c, h));
    return m_fan.angle_of(c, v) + angle - (h == input().next(c) ? boost::math::constants::two_pi<double>() : 0);
  }

  const Triangulation& m_triangulation;
  Surface_location m_place;
  Vertex_fan m_fan;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_PLACE_FRAME_H
