// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_VECTOR_GEOMETRY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_VECTOR_GEOMETRY_H

#include <CGAL/Flip_geodesics/internal/numbers/Number_operations.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Area_unit.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Vectors in a frame of the face, as in Intrinsic_triangulation_traits, for numbers that round: errors grow linearly
 * with flips. A frame has the length of an input halfedge as its unit, whose square, the scale, is stored as well, so
 * that faces are laid out with one root, that of the area, and no length.
 */
template <class NT>
class Vector_geometry
{
public:
  using Vector_3 = std::array<NT, 3>;
  using Unit = Area_unit<NT>;

  struct Halfedge_geometry
  {
    NT x, y, scale;
  };

  struct Flipped_geometry
  {
    Halfedge_geometry h, t, tn, tp;
  };

  struct Corner
  {
    NT x, y;
  };

  using Face_geometry = std::array<Halfedge_geometry, 3>;

  static Face_geometry face(const Vector_3& u, const Vector_3& v, const Vector_3& w, const NT& quadrupled_area)
  {
    return laid_out(dot(u, u), dot(u, v), dot(u, w), quadrupled_area);
  }

  static Face_geometry face_from_squares(const NT& a, const NT& b, const NT& c, const NT& quadrupled_area)
  {
    const NT half(0.5);
    return laid_out(a, NT((c - a - b) * half), NT((b - c - a) * half), quadrupled_area);
  }

  /* From vectors with a relative error, which intervals take in. */
  static Face_geometry face_from_vectors(const std::array<std::array<double, 2>, 3>& v, double error)
  {
    Face_geometry result;
    for(int i = 0; i < 3; ++i) {
      const double radius = error * (std::abs(v[i][0]) + std::abs(v[i][1]));
      result[i] = {within(v[i][0], radius), within(v[i][1], radius), NT(1)};
    }
    return result;
  }

  /* The corner at the head of `in` as a complex number. */
  static Corner corner(const Halfedge_geometry& in, const Halfedge_geometry& out, const Halfedge_geometry&)
  {
    return {NT(-(out.x * in.x + out.y * in.y)), non_negative(NT(out.y * in.x - out.x * in.y))};
  }

  /* The rotation from the frame of t's face to that of h's changes the scale as well. */
  static Flipped_geometry flip(const Unit&, const Halfedge_geometry& h, const Halfedge_geometry& hn,
                               const Halfedge_geometry& hp, const Halfedge_geometry& t, const Halfedge_geometry& tn,
                               const Halfedge_geometry& tp)
  {
    const NT norm = -(t.x * t.x + t.y * t.y);
    const Halfedge_geometry rotation = {NT((h.x * t.x + h.y * t.y) / norm), NT((h.y * t.x - h.x * t.y) / norm),
                                        h.scale};
    const Halfedge_geometry moved_tn = product(rotation, tn), moved_tp = product(rotation, tp);
    return {opposite_sum(hp, moved_tn), opposite_sum(hn, moved_tp), moved_tn, moved_tp};
  }

  static NT squared_length(const Halfedge_geometry& h) { return NT((h.x * h.x + h.y * h.y) * h.scale); }

  static bool is_inaccurate(const Halfedge_geometry& h)
  {
    if constexpr(is_interval)
      return !(Operations::radius(h.x) + Operations::radius(h.y) <
               inaccurate_vector * (std::abs(Operations::to_double(h.x)) + std::abs(Operations::to_double(h.y))));
    else
      return static_cast<void>(h), false;
  }

private:
  using Operations = Number_operations<NT>;
  static constexpr bool is_interval = Operations::kind == Number_kind::INTERVAL;

  static Face_geometry laid_out(const NT& square, const NT& dot_next, const NT& dot_previous, const NT& quadrupled_area)
  {
    const NT height = quadrupled_area / NT(square * NT(2));
    return {{{NT(1), NT(0), square},
             {NT(dot_next / square), height, square},
             {NT(dot_previous / square), NT(-height), square}}};
  }

  static NT dot(const Vector_3& u, const Vector_3& v) { return NT(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]); }

  static NT within(double x, double radius)
  {
    if constexpr(is_interval)
      return NT(x) + NT(-radius, radius);
    else
      return static_cast<void>(radius), NT(x);
  }

  // Areas are not negative, whatever rounding makes of them.
  static NT non_negative(const NT& y)
  {
    if constexpr(is_interval)
      return Operations::non_negative(y);
    else
      return Operations::sign(y) == NEGATIVE ? NT(0) : y;
  }

  static Halfedge_geometry product(const Halfedge_geometry& rotation, const Halfedge_geometry& v)
  {
    return {NT(rotation.x * v.x - rotation.y * v.y), NT(rotation.x * v.y + rotation.y * v.x), rotation.scale};
  }

  static Halfedge_geometry opposite_sum(const Halfedge_geometry& a, const Halfedge_geometry& b)
  {
    return {NT(-(a.x + b.x)), NT(-(a.y + b.y)), a.scale};
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_VECTOR_GEOMETRY_H
