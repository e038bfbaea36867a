// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_UNFOLDED_LEG_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_UNFOLDED_LEG_H

#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A part of a curve that crosses edges, but passes no vertex: its first face, by any halfedge, and what it crosses. */
struct Corridor_leg
{
  Input_halfedge_index face;
  std::vector<Input_halfedge_index> crossed; // in order, each as a side of the face before it

  Input_halfedge_index last_face() const { return crossed.empty() ? face : twin_index(crossed.back()); }
};

/* The same the other way. */
inline Corridor_leg reversed(const Corridor_leg& leg)
{
  Corridor_leg result = {leg.last_face(), {}};
  for(std::size_t i = leg.crossed.size(); i-- > 0;)
    result.crossed.push_back(twin_index(leg.crossed[i]));
  return result;
}

/* The weights of a canonical location in a face that has it, told from its halfedge h on. */
template <class Input_mesh>
std::array<double, 3> weights_told_from(const Input_mesh& input, const Surface_location& place, Input_halfedge_index h)
{
  if(kind(place) != Location_kind::VERTEX)
    return weights_in_face(input, place, h);
  const Vertex_index v = input.tail(place.halfedge);
  const Input_halfedge_index hn = input.next(h);
  return {{input.tail(h) == v ? 1.0 : 0.0, input.tail(h) != v && input.tail(hn) == v ? 1.0 : 0.0,
           input.tail(h) != v && input.tail(hn) != v ? 1.0 : 0.0}};
}

/*
 * The faces of a leg laid out in the plane of the first one, with the leg's start at the origin and the first face's
 * halfedge along the positive real axis. Faces are added as products of the vectors of their gates, as in a `Ray`.
 */
template <class Triangulation>
class Unfolded_leg
{
public:
  using Vector = std::complex<double>;

  /* An end of a gate on the wrong side of the straight line from start to end, the farthest one. */
  struct Violation
  {
    double distance = 0; // from the line
    Vertex_index vertex = null_index;
    std::size_t gate = 0;
  };

  /* \param start, end canonical locations
   * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error */
  Unfolded_leg(const Triangulation& triangulation, const Surface_location& start, const Corridor_leg& leg,
               const Surface_location& end)
    : m_triangulation(triangulation)
    , m_halfedge(leg.face)
  {
    lay_out_first_face(start);
    m_gates.reserve(leg.crossed.size());
    for(Input_halfedge_index h : leg.crossed)
      pass(h);
    find_end(end);
  }

  /* From the start to the end. */
  const Vector& end() const { return m_end; }

  /* The direction, of length 1, of the halfedge by which the last face is told. */
  const Vector& turn() const { return m_turn; }

  Violation violation() const
  {
    Violation worst;
    const double length = std::abs(m_end);
    for(std::size_t i = 0; length > 0 && i < m_gates.size(); ++i) {
      const Gate& gate = m_gates[i];
      note(cross(gate.left, m_end) / length, head(gate.crossed), i, worst);
      note(cross(m_end, gate.right) / length, tail(gate.crossed), i, worst);
    }
    return worst;
  }

private:
  struct Gate
  {
    Vector right, left;
    Input_halfedge_index crossed;
  };

  Vertex_index tail(Input_halfedge_index h) const { return m_triangulation.input().tail(h); }
  Vertex_index head(Input_halfedge_index h) const { return tail(twin_index(h)); }

  static void note(double distance, Vertex_index v, std::size_t gate, Violation& worst)
  {
    if(distance > worst.distance)
      worst = {distance, v, gate};
  }

  // The vectors of the last face, turned so that its halfedge has the direction of a vector.
  void lay_out(const Vector& direction)
  {
    const auto face = input_face_geometry(m_triangulation, m_halfedge);
    m_turn = direction / std::abs(direction);
    for(std::size_t i = 0; i < 3; ++i)
      m_vectors[i] = product(m_turn, Vector(face[i].x, face[i].y));
  }

  void lay_out_first_face(const Surface_location& start)
  {
    lay_out(1);
    const std::array<double, 3> w = weights_told_from(m_triangulation.input(), start, m_halfedge);
    const double sum = w[0] + w[1] + w[2];
    for(std::size_t i = 0; i < 3; ++i) // from the corner's two sides
      m_corners[i] = w[(i + 2) % 3] / sum * m_vectors[(i + 2) % 3] - w[(i + 1) % 3] / sum * m_vectors[i];
  }

  void pass(Input_halfedge_index h)
  {
    const auto& input = m_triangulation.input();
    const std::size_t side = h == m_halfedge ? 0 : (h == input.next(m_halfedge) ? 1 : 2);
    const Vector right = m_corners[side], left = m_corners[(side + 1) % 3], gate = -m_vectors[side];
    m_gates.push_back({right, left, h});
    m_halfedge = twin_index(h);
    lay_out(gate);
    const bool is_near_right = std::norm(m_vectors[1]) < std::norm(m_vectors[2]);
    m_corners = {left, right, is_near_right ? right + m_vectors[1] : left - m_vectors[2]};
  }

  // From the corner with the largest weight.
  void find_end(const Surface_location& end)
  {
    const std::array<double, 3> w = weights_told_from(m_triangulation.input(), end, m_halfedge);
    const double sum = w[0] + w[1] + w[2];
    const auto k = static_cast<std::size_t>((std::max_element)(w.begin(), w.end()) - w.begin());
    m_end = m_corners[k] + w[(k + 1) % 3] / sum * m_vectors[k] - w[(k + 2) % 3] / sum * m_vectors[(k + 2) % 3];
  }

  const Triangulation& m_triangulation;
  Input_halfedge_index m_halfedge; // the last face is told from it
  std::array<Vector, 3> m_vectors = {}, m_corners = {};
  std::vector<Gate> m_gates;
  Vector m_turn = 1, m_end = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_UNFOLDED_LEG_H
