// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_TRAITS_H
#define CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_TRAITS_H

#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace CGAL::Flip_geodesics {

template <class NT, class K>
class Exact_intrinsic_triangulation_traits;

template <class K, class NT = typename K::FT>
class Intrinsic_triangulation_traits;

namespace internal {

/* Ends the compilation if the header of the traits is not included. */
template <class Traits>
constexpr bool is_header_included()
{
  static_assert(is_defined<Traits>, "to compute in a number type other than double, include "
                                    "CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h first");
  return is_defined<Traits>;
}

/* If the header is missing, traits in double replace the undefined class, so that no other error message follows. */
template <class K, class NT, class Traits = Exact_intrinsic_triangulation_traits<NT, K>>
using Traits_in_number_type =
    std::conditional_t<is_header_included<Traits>(), Traits, Intrinsic_triangulation_traits<K, double>>;

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTraits
 *
 * Computes angles, squared lengths and flips with numbers of type `NT`, by default the number type of the kernel.
 * Predicates are exact if `NT` is exact. The following call computes with the number type of kernel `K`:
 *
 *     const FG::Intrinsic_triangulation_traits<K> traits;
 *     FG::geodesic_path(mesh, source, target, output, CGAL::parameters::geom_traits(traits));
 *
 * For `double`, see `Intrinsic_triangulation_traits<K, double>`. For all other number types, this class has the members
 * and constructors of `Exact_intrinsic_triangulation_traits<NT, K>`, and the header
 * `Exact_intrinsic_triangulation_traits.h` must also be included.
 *
 * \tparam K a kernel with `Point_3` and `FT`
 * \tparam NT a number type as for `Exact_intrinsic_triangulation_traits`
 *
 * \cgalModels{IntrinsicTriangulationTraits}
 */
template <class K, class NT>
class Intrinsic_triangulation_traits
#ifndef DOXYGEN_RUNNING
  : public internal::Traits_in_number_type<K, NT>
#endif
{
  using Base = internal::Traits_in_number_type<K, NT>;

public:
  using Base::Base;
};

/*!
 * \ingroup PkgFlipGeodesicsTraits
 *
 * Provides fast arithmetic with doubles for intrinsic triangulations. For each halfedge, a vector of two doubles is
 * stored, in a frame of the face of the halfedge. A flip takes one complex division and no square root.
 *
 * Predicates have the tolerance `angle_tolerance()`: an angle that is less than \f$\pi\f$ by at most this tolerance
 * counts as straight. This applies to angles at joints, to angles at the ends of edges that might be flipped, and to
 * the sums of two opposite angles in the predicate of locally Delaunay edges. Since the errors of vectors grow with the
 * number of flips, `shorten()` measures the finished curves on the input.
 *
 * Edge lengths must lie between 1e-70 and 1e70.
 *
 * \tparam K a kernel with `Point_3` and `FT`; differences of exact rational coordinates are computed exactly and then
 *         rounded to double, whereas other coordinates are rounded to double first
 *
 * \cgalModels{IntrinsicTriangulationTraits}
 */
template <class K>
class Intrinsic_triangulation_traits<K, double>
#ifndef DOXYGEN_RUNNING
  : public internal::Double_face_traits<K>
#endif
{
  using Base = internal::Double_face_traits<K>;

public:
  using FT = double; ///< the type to which squared lengths are rounded
  /// predicates can be wrong, since the errors of vectors grow with the number of flips
  using Has_drift = Tag_true;
  using Point_3 = typename K::Point_3; ///< the point type of the mesh

#ifdef DOXYGEN_RUNNING
  /// Stores the vector of a halfedge in the frame of its face.
  struct Halfedge_geometry
  {
    double x; ///< a coordinate, in the unit of the mesh
    double y; ///< a coordinate, in the unit of the mesh
  };

  /// The geometry of the three halfedges of a face, in counterclockwise order.
  using Face_geometry = std::array<Halfedge_geometry, 3>;

  /*!
   * Constructs a face from its three points. The three vectors are computed independently of one another, so small
   * angles of needle-shaped faces are accurate.
   */
  class Construct_face_3
  {
  public:
    /// Returns the face with halfedges from `p` to `q`, from `q` to `r`, and from `r` to `p`.
    Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const;
    /// Returns the face whose halfedges have the vectors `e` in space.
    Face_geometry operator()(const std::array<std::array<double, 3>, 3>& e) const;
  };

  /*!
   * Constructs a face from the lengths of its edges.
   * \pre the lengths satisfy the triangle inequality, which `Edge_length_metric` checks
   */
  class Construct_face_from_lengths
  {
  public:
    /// Returns the face whose halfedges have the lengths `a`, `b`, `c`.
    Face_geometry operator()(double a, double b, double c) const;
    /// Returns the face whose halfedges have the exact squared lengths `squares[i] / denominator`. The
    /// coordinates have errors of a few units in the last place. \tparam Integer see `IntrinsicTriangulationTraits`
    template <class Integer>
    Face_geometry operator()(const std::array<Integer, 3>& squares, const Integer& denominator) const;
  };

  /// Constructs a face from the vectors of its halfedges, given as pairs (x, y) in one frame.
  class Construct_face_2
  {
  public:
    /// Returns the face whose halfedges have the vectors `v`. The argument `error` is ignored.
    Face_geometry operator()(const std::array<std::array<double, 2>, 3>& v, double error) const;
  };
#else
  using typename Base::Face_geometry;
  using typename Base::Halfedge_geometry;
#endif

  /// Stores a sum of corner angles as the argument of a complex number of any magnitude. The argument is meaningful
  /// only up to \f$\pi\f$.
  struct Turn
  {
    double x = 1;             ///< the real part; the argument of the complex number is the angle
    double y = 0;             ///< the imaginary part
    bool is_straight = false; ///< whether the angle has reached \f$\pi\f$, up to `angle_tolerance()`
  };

  /// Stores the new geometry of the four halfedges that a flip changes.
  struct Flipped_geometry
  {
    Halfedge_geometry h;  ///< the geometry of halfedge `h`
    Halfedge_geometry t;  ///< the geometry of halfedge `t`
    Halfedge_geometry tn; ///< the geometry of the halfedge after `t` in the old face
    Halfedge_geometry tp; ///< the geometry of the halfedge before `t` in the old face
  };

  /// Returns the largest deviation from \f$\pi\f$ at which an angle still counts as straight: 1e-9 radians.
  static constexpr double angle_tolerance() { return internal::straight_angle_tolerance; }

  /*!
   * Adds to a turn the corner between two consecutive halfedges of a face, `in` and `out`. The argument `opposite` is
   * the third halfedge. The corner is represented by the complex number `conj(out) * -in`.
   */
  class Extend_turn
  {
  public:
    /// Adds the corner at the head of `in` to `turn`.
    void operator()(Turn& turn, const Halfedge_geometry& in, const Halfedge_geometry& out,
                    const Halfedge_geometry& /* opposite */) const
    {
      const double x = -(internal::unfused(out.x * in.x) + internal::unfused(out.y * in.y));
      const double y = (std::max)(internal::unfused(out.y * in.x) - internal::unfused(out.x * in.y), 0.0);
      const double product_x = internal::unfused(turn.x * x) - internal::unfused(turn.y * y);
      const double product_y = internal::unfused(turn.x * y) + internal::unfused(turn.y * x);
      // For two angles below pi, the product lies below the axis if the sum is above pi, and near the negative half of
      // the axis if it is close to pi. At most one branch is used, in the caller, since these conditions cannot be
      // predicted.
      const bool is_near = static_cast<bool>(static_cast<unsigned>(product_x <= 0) &
                                             static_cast<unsigned>(product_y <= -angle_tolerance() * product_x));
      turn.is_straight |= static_cast<bool>(static_cast<unsigned>(product_y < 0) | static_cast<unsigned>(is_near));
      turn.x = product_x;
      turn.y = product_y;
      rescale(turn);
    }

  private:
    static void rescale(Turn& turn)
    {
      const double size = std::abs(turn.x) + std::abs(turn.y);
      if(BOOST_UNLIKELY(size > internal::greatest_unscaled || size < internal::least_unscaled))
        turn = brought_into_range(turn);
    }

    // By value, so that turns stay in registers.
    BOOST_NOINLINE static Turn brought_into_range(Turn turn)
    {
      while(std::abs(turn.x) + std::abs(turn.y) > internal::greatest_unscaled) {
        turn.x *= internal::least_unscaled;
        turn.y *= internal::least_unscaled;
      }
      while(std::abs(turn.x) + std::abs(turn.y) < internal::least_unscaled && (turn.x != 0 || turn.y != 0)) {
        turn.x *= internal::greatest_unscaled;
        turn.y *= internal::greatest_unscaled;
      }
      return turn;
    }
  };

  /// Compares the angle of a turn with \f$\pi\f$. The result is `LARGER` if the angle exceeds \f$\pi\f$ or counts as
  /// straight, and `SMALLER` otherwise.
  class Compare_turn_with_straight
  {
  public:
    /// Returns the result. It is always marked as certain, but can be wrong if vectors have drifted.
    Uncertain<Comparison_result> operator()(const Turn& turn) const { return turn.is_straight ? LARGER : SMALLER; }
  };

  /// Computes a key in [0, 2] by which turns with angles below \f$\pi\f$ are ordered. The key is 0 for the angle zero,
  /// and increases with the angle.
  class Turn_key
  {
  public:
    /// Returns the key, rounded.
    double operator()(const Turn& turn) const { return 1 - turn.x / (std::abs(turn.x) + turn.y); }
  };

  /*!
   * Computes the geometry after the flip of the edge with the halfedges `h` and `t`. The faces are `(h, hn, hp)` and
   * `(t, tn, tp)` before the flip, and `(h, hp, tn)` and `(t, tp, hn)` afterwards.
   *
   *         k                     k
   *       / ^ .                  /|^
   *   hp /     . hn          hp / | . hn
   *     v   h   .              v  |  .
   *    i ------> j     ==>    i  h|t  j        h = l->k in (h, hp, tn),  t = k->l in (t, tp, hn)
   *     .   t   ^              .  |  ^
   *   tn .     / tp          tn . | / tp
   *       v   /                  v|/
   *         l                     l
   *
   * Both new faces have the frame of the old face of `h`, so `hn` and `hp` keep their vectors.
   */
  class Flip
  {
  public:
    /// Returns the new geometry of `h`, `t`, `tn` and `tp`.
    Flipped_geometry operator()(const Halfedge_geometry& h, const Halfedge_geometry& hn, const Halfedge_geometry& hp,
                                const Halfedge_geometry& t, const Halfedge_geometry& tn,
                                const Halfedge_geometry& tp) const
    {
      const double norm = internal::unfused(t.x * t.x) + internal::unfused(t.y * t.y);
      const Halfedge_geometry rotation = {-(internal::unfused(h.x * t.x) + internal::unfused(h.y * t.y)) / norm,
                                          -(internal::unfused(h.y * t.x) - internal::unfused(h.x * t.y)) / norm};
      const Halfedge_geometry moved_tn = product(rotation, tn);
      const Halfedge_geometry moved_tp = product(rotation, tp);
      return {{-(hp.x + moved_tn.x), -(hp.y + moved_tn.y)},
              {-(hn.x + moved_tp.x), -(hn.y + moved_tp.y)},
              moved_tn,
              moved_tp};
    }

  private:
    static Halfedge_geometry product(const Halfedge_geometry& a, const Halfedge_geometry& b)
    {
      return {internal::unfused(a.x * b.x) - internal::unfused(a.y * b.y),
              internal::unfused(a.x * b.y) + internal::unfused(a.y * b.x)};
    }
  };

  /*!
   * Determines whether the sum of the angles opposite to the edge with the halfedges `h` and `t` is at most \f$\pi\f$
   * plus `angle_tolerance()`.
   *
   * If the sum is \f$s\f$ before a flip, it is \f$2 \pi - s\f$ after the flip. Flipping an edge that is not locally
   * Delaunay therefore yields a locally Delaunay edge, and Lawson's algorithm terminates as long as the errors of the
   * angles stay below the tolerance.
   */
  class Is_locally_delaunay
  {
  public:
    /// Returns the result, which is always certain.
    Uncertain<bool> operator()(const Halfedge_geometry& /* h */, const Halfedge_geometry& hn,
                               const Halfedge_geometry& hp, const Halfedge_geometry& /* t */,
                               const Halfedge_geometry& tn, const Halfedge_geometry& tp) const
    {
      const Halfedge_geometry k = corner(hn, hp), l = corner(tn, tp);
      const double x = internal::unfused(k.x * l.x) - internal::unfused(k.y * l.y);
      const double y = internal::unfused(k.x * l.y) + internal::unfused(k.y * l.x);
      const bool is_past_three_halves = k.x < 0 && l.x < 0 && x > 0;
      return !is_past_three_halves && y >= -angle_tolerance() * std::abs(x);
    }

  private:
    // As in Extend_turn; areas are not negative, even with rounding errors.
    static Halfedge_geometry corner(const Halfedge_geometry& in, const Halfedge_geometry& out)
    {
      return {-(internal::unfused(out.x * in.x) + internal::unfused(out.y * in.y)),
              (std::max)(internal::unfused(out.y * in.x) - internal::unfused(out.x * in.y), 0.0)};
    }
  };

  /// Determines whether a vector is so inaccurate that its face must be recomputed. The result is always `false`, since
  /// these traits do not bound errors.
  class Is_inaccurate
  {
  public:
    /// Returns `false`.
    bool operator()(const Halfedge_geometry&) const { return false; }
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
    double operator()(const Halfedge_geometry& h) const
    {
      return std::sqrt(internal::unfused(h.x * h.x) + internal::unfused(h.y * h.y));
    }
  };

#ifdef DOXYGEN_RUNNING
  Construct_face_3 construct_face_3_object() const;                       ///< returns a functor
  Construct_face_from_lengths construct_face_from_lengths_object() const; ///< returns a functor
  Construct_face_2 construct_face_2_object() const;                       ///< returns a functor
#endif
  Extend_turn extend_turn_object() const { return {}; }                               ///< returns a functor
  Compare_turn_with_straight compare_turn_with_straight_object() const { return {}; } ///< returns a functor
  Turn_key turn_key_object() const { return {}; }                                     ///< returns a functor
  Flip flip_object() const { return {}; }                                             ///< returns a functor
  Is_locally_delaunay is_locally_delaunay_object() const { return {}; }               ///< returns a functor
  Is_inaccurate is_inaccurate_object() const { return {}; }                           ///< returns a functor
  Compute_squared_length compute_squared_length_object() const { return {}; }         ///< returns a functor
  Compute_length compute_length_object() const { return {}; }                         ///< returns a functor
};

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_TRAITS_H
