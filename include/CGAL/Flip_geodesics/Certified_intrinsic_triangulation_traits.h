// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CERTIFIED_INTRINSIC_TRIANGULATION_TRAITS_H
#define CGAL_FLIP_GEODESICS_CERTIFIED_INTRINSIC_TRIANGULATION_TRAITS_H

#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsTraits
 *
 * Provides exact predicates for intrinsic triangulations: each predicate is the sign of a real number that the input
 * defines. Section \ref Flip_geodesicsCoordinates lists the number types whose values are used exactly. Numbers of
 * other types are rounded to doubles.
 *
 * For each halfedge, a vector of two doubles and a bound on the relative error of this vector are stored. If the bound
 * is too large to determine a sign, the triangulation determines the sign from the input faces, by the methods listed
 * in Section \ref Flip_geodesicsCertified. One of these methods is exact arithmetic with the square roots of the
 * squared areas of the faces.
 *
 * Since this method can take a very long time if many roots are independent, it is subject to a work limit; see
 * `sign_work_limit()`. Unless this limit is reached, all signs are exact. A sign that cannot be determined within the
 * limit is assumed to be zero and counted in `Decision_statistics::unproven_zeros`. A certificate that depends on this
 * assumption has the verdict `PROBABLE` instead of `PROVEN`.
 *
 * \tparam K a kernel with the types `Point_3` and `FT`; numbers of type `FT` must be convertible to double
 *
 * \cgalModels{IntrinsicTriangulationTraits}
 */
template <class K>
class Certified_intrinsic_triangulation_traits
{
  using Plain = Intrinsic_triangulation_traits<K, double>;

  static double norm_bound(double x, double y) { return std::abs(x) + std::abs(y); }

  template <class Vector>
  static double length_of(const Vector& v)
  {
    return std::sqrt(internal::unfused(v.x * v.x) + internal::unfused(v.y * v.y));
  }

public:
  using FT = double;                   ///< the type to which squared lengths are rounded
  using Has_drift = Tag_false;         ///< results of predicates are correct if they are certain
  using Point_3 = typename K::Point_3; ///< the point type of the mesh

  /// Constructs traits with the default work limit, which corresponds to about a tenth of a second per sign.
  Certified_intrinsic_triangulation_traits() = default;

  /// Constructs traits with a given work limit; see `sign_work_limit()`. If the limit is 0, exact arithmetic with the
  /// square roots of the squared areas of faces is not used.
  explicit Certified_intrinsic_triangulation_traits(std::uint64_t sign_work_limit)
    : m_sign_work_limit(sign_work_limit)
  {
  }

  /*!
   * Returns the work limit for computing one sign by exact arithmetic with the square roots of the squared areas of
   * faces. The unit of work is the multiplication of two 64-bit words. Each multiplication of integers counts as at
   * least 32 units. The multiplication of two numbers with \f$r\f$ independent roots takes up to \f$4^r\f$
   * multiplications of integers.
   *
   * The other methods listed in Section \ref Flip_geodesicsCertified do not use this limit. One of them is used if the
   * input faces bend only along parallel edges. It computes the sign of a sum of square roots, always with the default
   * work limit.
   */
  std::uint64_t sign_work_limit() const { return m_sign_work_limit; }

  /// Stores the vector of a halfedge in the frame of its face, and a bound on the relative error of the vector.
  struct Halfedge_geometry
  {
    double x;     ///< a coordinate, in the unit of the mesh
    double y;     ///< a coordinate, in the unit of the mesh
    double error; ///< a bound on the error of the vector, relative to its length
  };

  /// The geometry of the three halfedges of a face, in counterclockwise order.
  using Face_geometry = std::array<Halfedge_geometry, 3>;

  /// Stores a sum of corner angles as the argument of a complex number of any magnitude, and a bound on the error of
  /// this number.
  struct Turn
  {
    double x = 1;                           ///< the real part; the argument of the complex number is the angle
    double y = 0;                           ///< the imaginary part
    double error = 0;                       ///< a bound on the error, relative to \f$|x|+|y|\f$
    Comparison_result comparison = SMALLER; ///< the comparison of the angle with \f$\pi\f$; valid if `is_certain`
    bool is_certain = true;                 ///< whether the bound suffices for the comparison
  };

  /// Stores the new geometry of the four halfedges that a flip changes.
  struct Flipped_geometry
  {
    Halfedge_geometry h;  ///< the geometry of halfedge `h`
    Halfedge_geometry t;  ///< the geometry of halfedge `t`
    Halfedge_geometry tn; ///< the geometry of the halfedge after `t` in the old face
    Halfedge_geometry tp; ///< the geometry of the halfedge before `t` in the old face
  };

  /// Constructs a face from points as `Intrinsic_triangulation_traits::Construct_face_3` does, and stores with each
  /// vector a bound on the rounding error.
  class Construct_face_3
  {
  public:
    /// Returns the face with halfedges from `p` to `q`, from `q` to `r`, and from `r` to `p`.
    Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
    {
      return with_error(typename Plain::Construct_face_3()(p, q, r), internal::face_layout_error);
    }

    /// Returns the face whose halfedges have the vectors `sides` in space.
    Face_geometry operator()(const std::array<std::array<double, 3>, 3>& sides) const
    {
      return with_error(typename Plain::Construct_face_3()(sides), internal::face_layout_error);
    }
  };

  /// Constructs a face from lengths as `Intrinsic_triangulation_traits::Construct_face_from_lengths` does, and stores
  /// with each vector a bound on the rounding error.
  class Construct_face_from_lengths
  {
  public:
    /// Returns the face whose halfedges have the lengths `a`, `b`, `c`.
    Face_geometry operator()(double a, double b, double c) const
    {
      return with_error(typename Plain::Construct_face_from_lengths()(a, b, c), internal::face_layout_error);
    }

    /// Returns the face whose halfedges have the exact squared lengths `squares[i] / denominator`.
    /// \tparam Integer see `IntrinsicTriangulationTraits`
    template <class Integer>
    Face_geometry operator()(const std::array<Integer, 3>& squares, const Integer& denominator) const
    {
      return with_error(typename Plain::Construct_face_from_lengths()(squares, denominator),
                        internal::face_layout_error);
    }
  };

  /// Constructs a face from vectors as `Intrinsic_triangulation_traits::Construct_face_2` does, and stores with each
  /// vector the given error bound.
  class Construct_face_2
  {
  public:
    /// Returns the face whose halfedges have the vectors `v`, each with a relative error of at most `error`.
    Face_geometry operator()(const std::array<std::array<double, 2>, 3>& v, double error) const
    {
      return with_error(typename Plain::Construct_face_2()(v, error), error);
    }
  };

  /// Extends a turn as `Intrinsic_triangulation_traits::Extend_turn` does, and updates the error bound and the
  /// comparison with \f$\pi\f$.
  class Extend_turn
  {
  public:
    /// Adds the corner at the head of `in` to `turn`.
    void operator()(Turn& turn, const Halfedge_geometry& in, const Halfedge_geometry& out,
                    const Halfedge_geometry& /* opposite */) const
    {
      const double x = -(internal::unfused(out.x * in.x) + internal::unfused(out.y * in.y));
      const double y = internal::unfused(out.y * in.x) - internal::unfused(out.x * in.y);
      const double corner_error = in.error + out.error + internal::vector_product_error;
      const bool is_corner_acute = x > corner_error * norm_bound(x, y);
      const bool is_turn_acute = turn.x > turn.error * norm_bound(turn.x, turn.y);
      const double product_x = internal::unfused(turn.x * x) - internal::unfused(turn.y * y);
      const double product_y = internal::unfused(turn.x * y) + internal::unfused(turn.y * x);
      turn.x = product_x;
      turn.y = product_y;
      turn.error += corner_error + internal::vector_product_error;
      decide(turn, is_turn_acute, is_corner_acute);
      rescale(turn);
    }

  private:
    // Since the turn and each corner are below pi, the sum is below 2 pi, and the sign of the sine decides.
    static void decide(Turn& turn, bool is_turn_acute, bool is_corner_acute)
    {
      const double radius = turn.error * norm_bound(turn.x, turn.y);
      turn.is_certain = true;
      if(is_turn_acute && is_corner_acute)
        turn.comparison = SMALLER;
      else if(turn.y > radius)
        turn.comparison = SMALLER;
      else if(turn.y < -radius)
        turn.comparison = LARGER;
      else
        turn.is_certain = false;
    }

    static void rescale(Turn& turn)
    {
      while(norm_bound(turn.x, turn.y) > internal::greatest_unscaled) {
        turn.x *= internal::least_unscaled;
        turn.y *= internal::least_unscaled;
      }
      while(norm_bound(turn.x, turn.y) < internal::least_unscaled && (turn.x != 0 || turn.y != 0)) {
        turn.x *= internal::greatest_unscaled;
        turn.y *= internal::greatest_unscaled;
      }
    }
  };

  /// Compares the angle of a turn with \f$\pi\f$. The result is uncertain if the error bound is too large.
  class Compare_turn_with_straight
  {
  public:
    /// Returns `SMALLER` or `LARGER`, or the range from `SMALLER` to `LARGER` if the result is uncertain.
    Uncertain<Comparison_result> operator()(const Turn& turn) const
    {
      return turn.is_certain ? Uncertain<Comparison_result>(turn.comparison)
                             : Uncertain<Comparison_result>(SMALLER, LARGER);
    }
  };

  /// Computes a key in [0, 2] by which turns with angles below \f$\pi\f$ are ordered. The key is 0 for the angle zero,
  /// and increases with the angle.
  class Turn_key
  {
  public:
    /// Returns the key, rounded.
    double operator()(const Turn& turn) const { return 1 - turn.x / norm_bound(turn.x, turn.y); }
  };

  /// Flips an edge as `Intrinsic_triangulation_traits::Flip` does, and updates the error bounds.
  class Flip
  {
  public:
    /// Returns the new geometry of `h`, `t`, `tn` and `tp`.
    Flipped_geometry operator()(const Halfedge_geometry& h, const Halfedge_geometry& hn, const Halfedge_geometry& hp,
                                const Halfedge_geometry& t, const Halfedge_geometry& tn,
                                const Halfedge_geometry& tp) const
    {
      const auto flipped = typename Plain::Flip()(plain(h), plain(hn), plain(hp), plain(t), plain(tn), plain(tp));
      const double turned = h.error + t.error + internal::rotation_error;
      const Halfedge_geometry new_tn = {flipped.tn.x, flipped.tn.y, tn.error + turned};
      const Halfedge_geometry new_tp = {flipped.tp.x, flipped.tp.y, tp.error + turned};
      return {difference(flipped.h, hp, new_tn), difference(flipped.t, hn, new_tp), new_tn, new_tp};
    }

  private:
    static typename Plain::Halfedge_geometry plain(const Halfedge_geometry& h) { return {h.x, h.y}; }

    static Halfedge_geometry difference(const typename Plain::Halfedge_geometry& sum, const Halfedge_geometry& a,
                                        const Halfedge_geometry& b)
    {
      const double error = internal::unfused(a.error * length_of(a)) + internal::unfused(b.error * length_of(b));
      const double length = length_of(sum);
      return {sum.x, sum.y,
              error < length ? error / (length - error) + internal::vector_product_error
                             : std::numeric_limits<double>::infinity()};
    }
  };

  /// Determines whether the sum of the angles opposite to the edge with the halfedges `h` and `t` is at most \f$\pi\f$.
  class Is_locally_delaunay
  {
  public:
    /// Returns the result, which is uncertain if the error bounds are too large.
    Uncertain<bool> operator()(const Halfedge_geometry& /* h */, const Halfedge_geometry& hn,
                               const Halfedge_geometry& hp, const Halfedge_geometry& /* t */,
                               const Halfedge_geometry& tn, const Halfedge_geometry& tp) const
    {
      const Halfedge_geometry k = corner(hn, hp), l = corner(tn, tp);
      const double radius_k = k.error * norm_bound(k.x, k.y), radius_l = l.error * norm_bound(l.x, l.y);
      if(k.x > radius_k && l.x > radius_l)
        return true;
      if(k.x < -radius_k && l.x < -radius_l)
        return false;
      const double x = internal::unfused(k.x * l.x) - internal::unfused(k.y * l.y);
      const double y = internal::unfused(k.x * l.y) + internal::unfused(k.y * l.x);
      const double radius = (k.error + l.error + internal::vector_product_error) * norm_bound(x, y);
      if(std::abs(y) > radius)
        return y > 0;
      return Uncertain<bool>::indeterminate();
    }

  private:
    static Halfedge_geometry corner(const Halfedge_geometry& in, const Halfedge_geometry& out)
    {
      return {-(internal::unfused(out.x * in.x) + internal::unfused(out.y * in.y)),
              internal::unfused(out.y * in.x) - internal::unfused(out.x * in.y),
              in.error + out.error + internal::vector_product_error};
    }
  };

  /// Determines whether the error bound of the vector of a halfedge is so large that the face of the halfedge must be
  /// recomputed from the input.
  class Is_inaccurate
  {
  public:
    /// Returns whether the relative error bound is at least \f$2^{-14}\f$.
    bool operator()(const Halfedge_geometry& h) const { return !(h.error < internal::inaccurate_vector); }
  };

  /// Computes the squared length of a halfedge.
  class Compute_squared_length
  {
  public:
    /// Returns the squared length, rounded to double.
    FT operator()(const Halfedge_geometry& h) const
    {
      return internal::unfused(h.x * h.x) + internal::unfused(h.y * h.y);
    }
  };

  /// Computes the length of a halfedge.
  class Compute_length
  {
  public:
    /// Returns the length, rounded to double.
    double operator()(const Halfedge_geometry& h) const { return length_of(h); }
  };

  Construct_face_3 construct_face_3_object() const { return {}; }                       ///< returns a functor
  Construct_face_from_lengths construct_face_from_lengths_object() const { return {}; } ///< returns a functor
  Construct_face_2 construct_face_2_object() const { return {}; }                       ///< returns a functor
  Extend_turn extend_turn_object() const { return {}; }                                 ///< returns a functor
  Compare_turn_with_straight compare_turn_with_straight_object() const { return {}; }   ///< returns a functor
  Turn_key turn_key_object() const { return {}; }                                       ///< returns a functor
  Flip flip_object() const { return {}; }                                               ///< returns a functor
  Is_locally_delaunay is_locally_delaunay_object() const { return {}; }                 ///< returns a functor
  Is_inaccurate is_inaccurate_object() const { return {}; }                             ///< returns a functor
  Compute_squared_length compute_squared_length_object() const { return {}; }           ///< returns a functor
  Compute_length compute_length_object() const { return {}; }                           ///< returns a functor

private:
  std::uint64_t m_sign_work_limit = internal::default_sign_work;

  static Face_geometry with_error(const typename Plain::Face_geometry& face, double error)
  {
    Face_geometry result;
    for(int i = 0; i < 3; ++i)
      result[i] = {face[i].x, face[i].y, error};
    return result;
  }
};

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_CERTIFIED_INTRINSIC_TRIANGULATION_TRAITS_H
