// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_VERTEX_FAN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_VERTEX_FAN_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Returns the halfedge that follows h counterclockwise around its tail. \pre h is not on the border */
template <class Input_mesh>
Input_halfedge_index counterclockwise_of(const Input_mesh& input, Input_halfedge_index h)
{
  return twin_index(input.next(input.next(h)));
}

/* Returns the halfedge that follows h clockwise around its tail. If the twin of h is on the border, it starts an
 * umbrella. */
template <class Input_mesh>
Input_halfedge_index clockwise_of(const Input_mesh& input, Input_halfedge_index h)
{
  return input.next(twin_index(h));
}

/* Calls visit(h) for the outgoing halfedges of a vertex, clockwise, and across the border from one umbrella to the
 * next; not at all if the vertex is isolated. */
template <class Input_mesh, class Visit>
void for_each_outgoing_halfedge(const Input_mesh& input, Vertex_index v, const Visit& visit)
{
  const Input_halfedge_index first = input.outgoing(v);
  if(first == null_index)
    return;
  Input_halfedge_index h = first;
  do {
    visit(h);
    h = clockwise_of(input, h);
  } while(h != first);
}

/* Returns the input corner at the head of input halfedge h, as a complex number, in a face that is known. */
template <class Triangulation>
std::complex<double> input_corner_vector(const Triangulation& triangulation, Input_halfedge_index h)
{
  const auto face = known_input_face_geometry(triangulation, h);
  return {-face[1].x, face[1].y}; // the layout puts h on the positive real axis
}

/* Returns the input corner at the head of input halfedge h, in any face, which must be a triangle. */
template <class Triangulation>
double input_corner(const Triangulation& triangulation, Input_halfedge_index h)
{
  check_triangle(triangulation.input(), h);
  return std::arg(input_corner_vector(triangulation, h));
}

/*
 * The outgoing halfedges of a vertex of the input, counterclockwise, with their angles in radians. A direction at the
 * vertex is such an angle. The halfedges are those of one umbrella, starting at its border if it has one; the last one
 * is then on the border itself.
 *
 * The angle of a face at the vertex is the value of a function corner(h) for the outgoing halfedge h of the face, since
 * clients store shapes of faces in different frames.
 */
class Vertex_fan
{
public:
  struct Outgoing_halfedge
  {
    Input_halfedge_index halfedge;
    double angle;  // of the halfedge
    double corner; // of the face on its left; zero on the border
  };

  /* A direction in a face: the angle counterclockwise from an outgoing halfedge, and the whole corner there. */
  struct Turn
  {
    Input_halfedge_index halfedge;
    double angle, corner;
  };

  /* Collects the umbrella of an outgoing halfedge h. The angles start at the border, or at h if there is none. */
  template <class Input_mesh, class Corner>
  void collect_umbrella(const Input_mesh& input, Input_halfedge_index h, const Corner& corner)
  {
    Input_halfedge_index first = h;
    bool is_at_border = false;
    do { // clockwise up to the border, if there is one
      is_at_border = input.is_border(twin_index(first));
      first = is_at_border ? first : clockwise_of(input, first);
    } while(!is_at_border && first != h);
    collect(input, first, 0, corner);
  }

  /* Collects the outgoing halfedges counterclockwise from a given one, which has a given angle, up to the border or all
   * the way around. */
  template <class Input_mesh, class Corner>
  void collect(const Input_mesh& input, Input_halfedge_index first, double angle, const Corner& corner)
  {
    m_halfedges.clear();
    Input_halfedge_index h = first;
    do {
      m_has_border = input.is_border(h);
      m_halfedges.push_back({h, angle, m_has_border ? 0 : corner(h)});
      angle += m_halfedges.back().corner;
      h = m_has_border ? first : counterclockwise_of(input, h);
    } while(h != first);
    m_end = angle;
  }

  /* Represents a point that is not a vertex, on the edge of h or inside its face: directions start at that of h. */
  void set_flat(Input_halfedge_index h, bool is_on_border)
  {
    constexpr double pi = boost::math::constants::pi<double>();
    m_halfedges = {{h, 0, pi}, {twin_index(h), pi, is_on_border ? 0 : pi}};
    m_has_border = is_on_border;
    m_end = is_on_border ? pi : 2 * pi;
  }

  const std::vector<Outgoing_halfedge>& halfedges() const { return m_halfedges; }
  bool has_border() const { return m_has_border; }

  /* Returns the sum of the corners. */
  double total() const { return m_halfedges.empty() ? 0 : m_end - m_halfedges.front().angle; }

  /* Returns whether h is one of the halfedges. */
  bool has(Input_halfedge_index h) const { return found(h) != m_halfedges.end(); }

  /* Returns the angle of an outgoing halfedge.
   * \throws Invalid_mesh_error if the halfedge is in another umbrella of the vertex */
  double angle_of(Input_halfedge_index h, Vertex_index vertex) const
  {
    const auto place = found(h);
    if(place == m_halfedges.end())
      throw_naming<Invalid_mesh_error>("several umbrellas of faces meet at vertex ", vertex,
                                       ", and the angle between directions in two of them is undefined");
    return place->angle;
  }

  /* Returns the face of a direction, which is given by its angle from the first halfedge. An angle that rounding errors
   * put out of range belongs to the first or last face. \pre there is a face */
  Turn turn_at(double angle) const
  {
    const std::size_t last = m_halfedges.size() - (m_has_border ? 2 : 1);
    std::size_t i = 0;
    for(; i < last && !(angle < m_halfedges[i].corner); ++i)
      angle -= m_halfedges[i].corner;
    return {m_halfedges[i].halfedge, angle, m_halfedges[i].corner};
  }

  /* Returns the smaller of the two angles between two directions; a side that contains the border counts as
   * infinite. */
  double smaller_wedge(double a, double b) const
  {
    const double wedge = a < b ? b - a : a - b;
    return m_has_border ? wedge : (std::min)(wedge, total() - wedge);
  }

  /* Returns the angle counterclockwise from one direction to another; infinite if the border intervenes. */
  double counterclockwise(double from, double to) const
  {
    if(from <= to)
      return to - from;
    return m_has_border ? std::numeric_limits<double>::infinity() : to - from + total();
  }

private:
  std::vector<Outgoing_halfedge>::const_iterator found(Input_halfedge_index h) const
  {
    return std::find_if(m_halfedges.begin(), m_halfedges.end(),
                        [h](const Outgoing_halfedge& o) { return o.halfedge == h; });
  }

  std::vector<Outgoing_halfedge> m_halfedges;
  double m_end = 0; // the angle behind the last corner
  bool m_has_border = false;
};

/* The last segment of a shortest path to a vertex: the vertex from which it comes straight, its length, and its angle
 * counterclockwise of an input halfedge that starts at the vertex. */
struct Last_leg
{
  Vertex_index from;
  Input_halfedge_index halfedge;
  double angle, length;
};

/* Throws Invalid_parameter_error unless h, from which a direction is measured, is a halfedge of the input. */
template <class Input_mesh>
void check_reference(const Input_mesh& input, Input_halfedge_index h)
{
  if(!h.is_valid() || h.idx() >= input.number_of_halfedges())
    throw Invalid_parameter_error("a direction is measured from a halfedge that does not belong to the mesh");
}

[[noreturn]] inline void throw_no_side(Input_halfedge_index h)
{
  throw_naming<Invalid_parameter_error>("a direction is measured from halfedge ", h,
                                        ", which is not a side of a face that contains the location");
}

/* Returns the umbrella of an outgoing halfedge of a vertex of the input, with corners computed from the input.
 * \throws Invalid_mesh_error if a face is not a triangle, and what the metric throws */
template <class Triangulation>
Vertex_fan umbrella_of(const Triangulation& triangulation, Input_halfedge_index h)
{
  const auto& input = triangulation.input();
  Vertex_fan result;
  result.collect_umbrella(
      input, h, [&](Input_halfedge_index g) { return input_corner(triangulation, input.next(input.next(g))); });
  return result;
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_VERTEX_FAN_H
