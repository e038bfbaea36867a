// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_INPUT_FACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_INPUT_FACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>
#include <CGAL/Flip_geodesics/internal/surface/face_lengths.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>

#include <array>
#include <cmath>
#include <complex>
#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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
  bool is_beyond_pi = false;   // is it above pi, by more than a tolerance? Then the rest is not computed
  bool passes_near_pi = false; // is it within the tolerance of pi up to one of the halfedges?
};

/* The faces that are not laid out: those of which no corner can be computed, or all that no metric makes vectors of. */
enum class Refused_faces { WITHOUT_CORNERS, UNUSABLE };

/*
 * Faces of the input mesh, laid out one by one in plain doubles. Once a face or the length of an edge has been refused,
 * which `have_refused()` returns, results are of no use until `forget_refusals()`.
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

  /* The third corner of the face of h, which has to be a triangle, where h leads from 0 to 1 in the complex plane. */
  Plane_vector corner(Input_halfedge_index h) const
  {
    check_triangle(m_triangulation.input(), h);
    constexpr bool has_places = std::is_same<typename Triangulation::Metric::Place, std::array<double, 3>>::value;
    if((!has_places || m_refused == Refused_faces::UNUSABLE) &&
       !is_usable_face(m_triangulation.metric(), m_triangulation.input(), h))
    {
      m_have_refused = true;
      return 0;
    }
    if constexpr(has_places) {
      return corner(place(tail(h)), place(head(h)), place(apex(h)));
    } else {
      const auto face = known_input_face_geometry(m_triangulation, h);
      return {-face[2].x / face[0].x, -face[2].y / face[0].x};
    }
  }

  /* The angle from one direction counterclockwise to another; it is beyond pi if the border is in between. */
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
  void add_corner(Input_halfedge_index h, double tolerance, Corner_angle& angle) const
  {
    angle.is_beyond_pi = is_border(h);
    if(angle.is_beyond_pi)
      return;
    angle.turn = product(angle.turn, corner(h));
    ++angle.corners;
    const double margin = tolerance * magnitude(angle.turn), sine = angle.turn.imag();
    const bool is_obtuse = angle.turn.real() < 0; // what is left of the first corner can be nothing
    angle.is_beyond_pi = sine < -margin && (angle.corners > 1 || is_obtuse);
    angle.passes_near_pi = angle.passes_near_pi || (std::abs(sine) <= margin && is_obtuse);
  }

  auto place(Vertex_index v) const { return m_triangulation.metric().place(m_triangulation.input(), v); }

  static Plane_vector corner(const std::array<double, 3>& p, const std::array<double, 3>& q,
                             const std::array<double, 3>& r)
  {
    const double x = q[0] - p[0], y = q[1] - p[1], z = q[2] - p[2];
    const double u = r[0] - p[0], v = r[1] - p[1], w = r[2] - p[2];
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_INPUT_FACES_H
