// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXACT_INTRINSIC_TRIANGULATION_TRAITS_H
#define CGAL_FLIP_GEODESICS_EXACT_INTRINSIC_TRIANGULATION_TRAITS_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Multiquadratic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/exact_geometries.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsTraits
 *
 * Evaluates the predicates of intrinsic triangulations with a number type of your choice. The number type determines
 * whether the predicates are exact:
 *
 * | number type | predicates | supported meshes |
 * |---|---|---|
 * | exact with square roots, such as `Exact_predicates_exact_constructions_kernel_with_sqrt::FT` | exact | any mesh |
 * | rational, such as `Gmpq`, `boost::multiprecision::cpp_rational`, `Epeck::FT` | exact | meshes with one radicand |
 * | `Sqrt_extension<NT, ROOT>` | exact | meshes with one radicand |
 * | `Interval_nt<>` | exact, or `Uncertain_conversion_exception` | any mesh |
 * | rounded, such as `boost::multiprecision::cpp_bin_float_100`, `double` | up to `angle_tolerance()` | any mesh |
 *
 * A mesh has one radicand \f$d\f$ if the area of every face is a rational multiple of \f$\sqrt d\f$. The radicand is 1
 * for meshes in a coordinate plane and for axis-aligned boxes, and 3 for regular tetrahedra and octahedra.
 * `common_radicand()` computes the radicand of a mesh. If the number type supports only meshes with one radicand, a
 * radicand other than 1 must be passed to the constructor. With such a number type, accessing a face throws
 * `Inexact_root_error` if the area of the face is not a rational multiple of \f$\sqrt d\f$.
 *
 * With exact numbers, faces store squared lengths and areas. For each input face, only one square root is computed,
 * that of the squared area; flips do not require square roots. With rounded numbers and intervals, faces store vectors
 * instead.
 *
 * The representations of exact numbers grow with the number of flips; Section \ref Flip_geodesicsKernelTimes lists the
 * cost of each number type.
 *
 * \tparam NT a field number type: `double`, `float`, `Interval_nt<>`, a `Sqrt_extension`, a rational or floating-point
 *         number type of Boost.Multiprecision, or any other model of `RealEmbeddable` and `Field` that is a model of
 *         `FieldWithSqrt` or has the functor `Is_square`
 * \tparam K a kernel with `Point_3` and `FT`. If `NT` is exact, coordinates are used exactly, provided that `FT` is
 *         `NT` or has rational values. Coordinates of all other types are rounded to doubles first
 *
 * \cgalModels{IntrinsicTriangulationTraits}
 */
template <class NT, class K = Simple_cartesian<double>>
class Exact_intrinsic_triangulation_traits
{
  using Operations = internal::Number_operations<NT>;
  using Area_unit = internal::Area_unit<NT>;

  static constexpr bool is_exact = internal::has_division<NT>() && internal::is_exact_number<NT>();
  static constexpr bool is_interval = Operations::kind == internal::Number_kind::INTERVAL;
  static constexpr bool is_rounded = Operations::kind == internal::Number_kind::FLOATING;
  static constexpr bool has_radicand =
      Operations::kind == internal::Number_kind::RATIONAL || Operations::kind == internal::Number_kind::EXTENSION;

  using Geometry = std::conditional_t<is_exact, internal::Squared_length_geometry<NT>, internal::Vector_geometry<NT>>;

  // A functor refers to the unit of area of the traits that returned it.
  class Functor_with_unit
  {
  public:
    explicit Functor_with_unit(const Area_unit& unit)
      : m_unit(&unit)
    {
    }

  protected:
    const Area_unit& unit() const { return *m_unit; }

  private:
    const Area_unit* m_unit;
  };

public:
  using FT = NT; ///< the type of squared lengths
  /// `Tag_true` for rounded numbers, whose errors accumulate; `Tag_false` for exact numbers, and for intervals, which
  /// bound their errors.
  using Has_drift = Boolean_tag<is_rounded>;
  using Point_3 = typename K::Point_3; ///< the point type of the mesh
  /// The type of radicands: the second template argument of `NT` if `NT` is a `Sqrt_extension`, and otherwise `NT`.
  using Radicand = typename Area_unit::Radicand;

  using Halfedge_geometry = typename Geometry::Halfedge_geometry; ///< a squared length and an area, or a vector
  using Face_geometry = typename Geometry::Face_geometry; ///< the geometry of a face, in the order of its halfedges
  /// The geometry of the four halfedges that a flip changes.
  using Flipped_geometry = typename Geometry::Flipped_geometry;

  /// Stores a sum of corner angles as the argument of a complex number of any magnitude.
  struct Turn
  {
    NT x = NT(1);         ///< the real part; the argument of the complex number is the angle
    NT y = NT(0);         ///< the imaginary part; if `NT` is rational, divided by the square root of the radicand
    bool is_empty = true; ///< whether no corners have been added
    Uncertain<Comparison_result> comparison = SMALLER; ///< the comparison of the angle with \f$\pi\f$
  };

  /// Constructs traits. If `NT` is rational or a `Sqrt_extension`, the mesh must have the radicand 1; otherwise, any
  /// mesh is supported.
  Exact_intrinsic_triangulation_traits() = default;

  /// Constructs traits for meshes with the radicand `d`, a positive number. This constructor is available only if `NT`
  /// is rational or a `Sqrt_extension`.
  explicit Exact_intrinsic_triangulation_traits(const Radicand& d)
    : m_unit(d)
  {
    static_assert(has_radicand, "only a number type without square roots accepts a radicand");
  }

  /// Returns the default work limit. The predicates of these traits are not subject to this limit. Only functions that
  /// compute signs from the input, such as `certify()`, use the limit.
  static std::uint64_t sign_work_limit() { return internal::default_sign_work; }

  /// Returns the largest deviation from \f$\pi\f$, in radians, at which an angle still counts as straight. The result
  /// is 0 for exact numbers and intervals. For rounded numbers, about half of the digits are reserved for rounding
  /// errors: the result is about 1e-9 for `double`, and about 3e-52 for numbers of 100 digits.
  static double angle_tolerance() { return internal::sign_tolerance<NT>(); }

  /// Constructs a face from points. \throws Inexact_root_error if `NT` is rational or a `Sqrt_extension`, and the
  /// area of the face is not a rational multiple of the square root of the radicand
  class Construct_face_3 : Functor_with_unit
  {
    using Vector_3 = typename Geometry::Vector_3;

  public:
    using Functor_with_unit::Functor_with_unit;

    /// Returns the face with halfedges from `p` to `q`, from `q` to `r`, and from `r` to `p`.
    Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
    {
      const Vector_3 u = difference(p, q), v = difference(q, r), w = difference(r, p);
      const NT x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
      return Geometry::face(u, v, w, this->unit().root(NT(NT(4) * NT(x * x + y * y + z * z))));
    }

  private:
    static NT number(const NT& x) { return x; }

    template <class Coordinate>
    static std::enable_if_t<!std::is_same<Coordinate, NT>::value, NT> number(const Coordinate& x)
    {
      if constexpr(internal::is_rational_number<Coordinate> && !std::is_floating_point<NT>::value) {
        const internal::Rational exact = internal::to_rational(x);
        return internal::from_rational<NT>(exact);
      } else {
        return NT(CGAL::to_double(x));
      }
    }

    static Vector_3 difference(const Point_3& p, const Point_3& q)
    {
      return {NT(number(q.x()) - number(p.x())), NT(number(q.y()) - number(p.y())), NT(number(q.z()) - number(p.z()))};
    }
  };

  /// Constructs a face from lengths. \throws Inexact_root_error if `NT` is rational or a `Sqrt_extension`, and the
  /// area of the face is not a rational multiple of the square root of the radicand
  class Construct_face_from_lengths : Functor_with_unit
  {
  public:
    using Functor_with_unit::Functor_with_unit;

    /// Returns the face whose halfedges have the lengths `a`, `b`, `c`.
    Face_geometry operator()(double a, double b, double c) const { return face(NT(a), NT(b), NT(c)); }

    /// Returns the face whose halfedges have the exact squared lengths `squares[i] / denominator`.
    /// \tparam Integer see `IntrinsicTriangulationTraits`
    template <class Integer>
    Face_geometry operator()(const std::array<Integer, 3>& squares, const Integer& denominator) const
    {
      const internal::Squared_lengths lengths = {squares, denominator};
      const NT divisor = internal::converted<NT>(denominator);
      const auto square = [&](std::size_t i) { return NT(internal::converted<NT>(squares[i]) / divisor); };
      const NT area = NT(internal::converted<NT>(lengths.quadrupled_area_squared()) / NT(divisor * divisor));
      return Geometry::face_from_squares(square(0), square(1), square(2), this->unit().root(area));
    }

  private:
    Face_geometry face(const NT& a, const NT& b, const NT& c) const
    {
      const NT square = NT((a + b + c) * (a + b - c)) * NT((b + c - a) * (c + a - b)); // of 4 area
      return Geometry::face_from_squares(NT(a * a), NT(b * b), NT(c * c), this->unit().root(square));
    }
  };

  /// Constructs a face from vectors. \pre `NT` is not exact
  class Construct_face_2
  {
  public:
    /// Returns the face whose halfedges have the vectors `v`, each with a relative error of at most `error`.
    Face_geometry operator()(const std::array<std::array<double, 2>, 3>& v, double error) const
    {
      CGAL_precondition_msg(!is_exact, "the number type must not be exact, since the vectors are rounded");
      if constexpr(is_exact)
        return static_cast<void>(v), static_cast<void>(error), Face_geometry();
      else
        return Geometry::face_from_vectors(v, error);
    }
  };

  /// Constructs the triangle formed by three points of a face.
  class Construct_exact_subface
  {
  public:
    /// Returns the triangle whose vertex `i` is the point of `face` with the weights `weights[i]`.
    Face_geometry operator()(const Face_geometry& face, const std::array<std::array<double, 3>, 3>& weights) const
    {
      return Geometry::subface(face, weights);
    }
  };

  /// `Construct_exact_subface`, or `void` if `NT` is not exact.
  using Construct_subface = std::conditional_t<is_exact, Construct_exact_subface, void>;

  /// Extends a turn as `Intrinsic_triangulation_traits::Extend_turn` does.
  class Extend_turn : Functor_with_unit
  {
  public:
    using Functor_with_unit::Functor_with_unit;

    /// Adds the corner at the head of `in` to `turn`.
    void operator()(Turn& turn, const Halfedge_geometry& in, const Halfedge_geometry& out,
                    const Halfedge_geometry& opposite) const
    {
      if(CGAL::possibly(turn.comparison != SMALLER))
        return; // already at least straight, or permanently undetermined
      append(turn, Geometry::corner(in, out, opposite));
      rescale(turn);
    }

  private:
    void append(Turn& turn, const typename Geometry::Corner& corner) const
    {
      const bool is_half_acute = is_interval && (is_positive(turn.x) || is_positive(corner.x));
      if(turn.is_empty) {
        turn.x = corner.x;
        turn.y = corner.y;
      } else {
        const NT product_x = NT(turn.x * corner.x) - this->unit().product(turn.y, corner.y);
        turn.y = NT(turn.x * corner.y + turn.y * corner.x);
        turn.x = product_x;
      }
      turn.is_empty = false;
      turn.comparison = compared(turn, is_half_acute);
    }

    static bool is_positive(const NT& x) { return CGAL::certainly(Operations::sign(x) == POSITIVE); }

    // The turn was below pi before, and the corner is at most pi, so their sum is below 2 pi, and a sine of zero means
    // 0 or pi. If the sign of the sine is undetermined, but one summand is below pi / 2 and the cosine is positive, the
    // sum is below 3/2 pi, and therefore below pi / 2.
    static Uncertain<Comparison_result> compared(const Turn& turn, bool is_half_acute)
    {
      const Uncertain<Sign> sine = sign_of_sine(turn);
      if(!sine.is_certain())
        return is_half_acute && is_positive(turn.x) ? Uncertain<Comparison_result>(SMALLER)
                                                    : Uncertain<Comparison_result>(SMALLER, LARGER);
      switch(sine.make_certain()) {
      case POSITIVE:
        return SMALLER;
      case ZERO:
        return CGAL::certainly(Operations::sign(turn.x) == POSITIVE) ? SMALLER : EQUAL;
      case NEGATIVE:
        return LARGER;
      }
      return LARGER;
    }

    static Uncertain<Sign> sign_of_sine(const Turn& turn)
    {
      if constexpr(is_rounded) {
        const NT zero = NT(angle_tolerance()) * (Operations::sign(turn.x) == NEGATIVE ? NT(-turn.x) : turn.x);
        if(turn.y <= zero && -turn.y <= zero)
          return ZERO;
      }
      return Operations::sign(turn.y);
    }

    // Other number types have a sufficient range of exponents. A quarter of the greatest exponent of `float` leaves
    // room for a product.
    static void rescale(Turn& turn)
    {
      if constexpr(is_interval || std::is_floating_point<NT>::value) {
        const double greatest = std::is_same<NT, float>::value
                                    ? std::ldexp(1.0, std::numeric_limits<float>::max_exponent / 4)
                                    : internal::greatest_unscaled;
        const double norm = std::abs(Operations::to_double(turn.x)) + std::abs(Operations::to_double(turn.y));
        if((norm > greatest || norm < 1 / greatest) && norm > 0 && norm < std::numeric_limits<double>::infinity()) {
          const NT factor(std::ldexp(1.0, -std::ilogb(norm)));
          turn.x *= factor;
          turn.y *= factor;
        }
      }
    }
  };

  /// Compares the angle of a turn with \f$\pi\f$. \throws Uncertain_conversion_exception if interval arithmetic cannot
  /// decide the comparison
  class Compare_turn_with_straight
  {
  public:
    /// Returns the result, which is certain unless an exception is thrown.
    Uncertain<Comparison_result> operator()(const Turn& turn) const { return turn.comparison.make_certain(); }
  };

  /// Computes a key that increases with the angle of a turn, for angles below \f$\pi\f$. For rational numbers and
  /// `Sqrt_extension`, equal angles have equal keys.
  class Turn_key : Functor_with_unit
  {
  public:
    using Functor_with_unit::Functor_with_unit;

    /// Returns the key, a number in [0, 2], rounded.
    double operator()(const Turn& turn) const
    {
      if(has_radicand)
        return key_by_cotangent(turn);
      const double x = Operations::to_double(turn.x), y = Operations::to_double(turn.y);
      const double norm = std::abs(x) + y;
      return is_exact && !(norm > internal::least_quotient_size && norm < internal::greatest_quotient_size)
                 ? key_by_cotangent(turn)
                 : key(x, y);
    }

  private:
    // The coordinates can exceed the range of double, whereas their quotient depends only on the angle.
    double key_by_cotangent(const Turn& turn) const
    {
      if(CGAL::possibly(Operations::sign(turn.y) == ZERO))
        return CGAL::certainly(Operations::sign(turn.x) == NEGATIVE) ? 2 : 0;
      const double cotangent = Operations::to_double(NT(turn.x / turn.y));
      if(!std::isfinite(cotangent))
        return cotangent > 0 ? 0 : 2;
      return key(cotangent, this->unit().to_double());
    }

    static double key(double x, double y) { return 1 - x / (std::abs(x) + y); }
  };

  /// Flips an edge. This requires no square root.
  class Flip : Functor_with_unit
  {
  public:
    using Functor_with_unit::Functor_with_unit;

    /// Returns the new geometry of `h`, `t`, `tn` and `tp`.
    Flipped_geometry operator()(const Halfedge_geometry& h, const Halfedge_geometry& hn, const Halfedge_geometry& hp,
                                const Halfedge_geometry& t, const Halfedge_geometry& tn,
                                const Halfedge_geometry& tp) const
    {
      return Geometry::flip(this->unit(), h, hn, hp, t, tn, tp);
    }
  };

  /*!
   * Determines whether the sum of the angles opposite to the edge with the halfedges `h` and `t` is at most \f$\pi\f$
   * plus `angle_tolerance()`.
   * \throws Uncertain_conversion_exception if interval arithmetic cannot decide the comparison
   */
  class Is_locally_delaunay : Functor_with_unit
  {
  public:
    using Functor_with_unit::Functor_with_unit;

    /// Returns the result, which is certain unless an exception is thrown.
    Uncertain<bool> operator()(const Halfedge_geometry& h, const Halfedge_geometry& hn, const Halfedge_geometry& hp,
                               const Halfedge_geometry& t, const Halfedge_geometry& tn,
                               const Halfedge_geometry& tp) const
    {
      const auto k = Geometry::corner(hn, hp, h), l = Geometry::corner(tn, tp, t);
      const NT y = NT(k.x * l.y + k.y * l.x);
      if constexpr(is_rounded) {
        const NT x = NT(k.x * l.x) - this->unit().product(k.y, l.y);
        const bool is_past_three_halves = k.x < 0 && l.x < 0 && x > 0;
        return !is_past_three_halves && -y <= NT(angle_tolerance()) * (x < 0 ? NT(-x) : x);
      } else {
        const Uncertain<Sign> at_k = Operations::sign(k.x), at_l = Operations::sign(l.x);
        if(CGAL::certainly((at_k != NEGATIVE) & (at_l != NEGATIVE)))
          return true;
        if(CGAL::certainly((at_k == NEGATIVE) & (at_l == NEGATIVE)))
          return false;
        const Uncertain<Sign> sine = Operations::sign(y);
        return (sine != NEGATIVE).make_certain();
      }
    }
  };

  /// Determines whether the geometry of a halfedge is so inaccurate that its face must be recomputed from the input.
  /// The result can be `true` only if `NT` is an interval type.
  class Is_inaccurate
  {
  public:
    /// Returns whether the face must be recomputed.
    bool operator()(const Halfedge_geometry& h) const
    {
      if constexpr(is_exact)
        return static_cast<void>(h), false;
      else
        return Geometry::is_inaccurate(h);
    }
  };

  /// Computes the squared length of a halfedge.
  class Compute_squared_length
  {
  public:
    /// Returns the squared length, which is exact if `NT` is exact.
    FT operator()(const Halfedge_geometry& h) const { return Geometry::squared_length(h); }
  };

  /// Computes the length of a halfedge.
  class Compute_length
  {
  public:
    /// Returns the length, rounded to double.
    double operator()(const Halfedge_geometry& h) const
    {
      return std::sqrt(Operations::to_double(Geometry::squared_length(h)));
    }
  };

  Construct_face_3 construct_face_3_object() const { return Construct_face_3(m_unit); } ///< returns a functor
  /// Returns a functor.
  Construct_face_from_lengths construct_face_from_lengths_object() const { return Construct_face_from_lengths(m_unit); }
  Construct_face_2 construct_face_2_object() const { return {}; }                     ///< returns a functor
  Construct_subface construct_subface_object() const { return Construct_subface(); }  ///< returns a functor
  Extend_turn extend_turn_object() const { return Extend_turn(m_unit); }              ///< returns a functor
  Compare_turn_with_straight compare_turn_with_straight_object() const { return {}; } ///< returns a functor
  Turn_key turn_key_object() const { return Turn_key(m_unit); }                       ///< returns a functor
  Flip flip_object() const { return Flip(m_unit); }                                   ///< returns a functor
  /// Returns a functor.
  Is_locally_delaunay is_locally_delaunay_object() const { return Is_locally_delaunay(m_unit); }
  Is_inaccurate is_inaccurate_object() const { return {}; }                   ///< returns a functor
  Compute_squared_length compute_squared_length_object() const { return {}; } ///< returns a functor
  Compute_length compute_length_object() const { return {}; }                 ///< returns a functor

private:
  Area_unit m_unit;
};

/*!
 * \ingroup PkgFlipGeodesicsTraits
 *
 * Computes a number \f$d\f$ such that the area of every face of a mesh is a rational multiple of \f$\sqrt d\f$. If
 * \f$d\f$ is not 1, and the number type of `Exact_intrinsic_triangulation_traits` is rational or a `Sqrt_extension`,
 * \f$d\f$ must be passed to the constructor of the traits. The result is an integer that is not divisible by the square
 * of a prime below 1000. If all faces are degenerate, the result is 1.
 *
 * \tparam Radicand the type of the result, a number type that can represent integers, such as
 *         `Exact_intrinsic_triangulation_traits::Radicand`
 * \param mesh a triangle mesh
 * \param metric an `Embedded_metric` or `Edge_length_metric`
 * \throws Inexact_root_error if no such number exists; `elements()` then returns the vertices of a face whose area is
 *         not a rational multiple of the area of the first nondegenerate face
 *
 * Complexity: linear in the number of faces. The integers in the computation typically have a few hundred bits.
 */
template <class Radicand, class TriangleMesh, class Metric>
Radicand common_radicand(const TriangleMesh& mesh, const Metric& metric)
{
  const typename Metric::Mesh input(mesh);
  internal::Integer radicand = 0;
  for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
    if(input.is_border(h))
      continue;
    const internal::Integer square = internal::exact_face(metric, input, h).doubled_area_squared;
    if(square == 0)
      continue;
    if(radicand == 0)
      radicand = internal::without_squares(square);
    if(!internal::exact_root(square * radicand)) {
      const Index a = input.tail(h).idx(), b = input.tail(input.next(h)).idx(), c = input.tail(input.previous(h)).idx();
      throw Inexact_root_error("the area of the face with vertices " + std::to_string(a) + ", " + std::to_string(b) +
                                   ", " + std::to_string(c) +
                                   " is not a rational multiple of that of the first nondegenerate face; use a number "
                                   "type with square roots",
                               {static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
    }
  }
  return radicand == 0 ? Radicand(1) : internal::converted<Radicand>(radicand);
}

/// \ingroup PkgFlipGeodesicsTraits
/// Computes a number \f$d\f$ such that the area of every face of a mesh is a rational multiple of \f$\sqrt d\f$. The
/// areas are computed from the points of the mesh. The result, the exceptions and the complexity are those of
/// `common_radicand()` with an `Embedded_metric`.
template <class Radicand, class TriangleMesh>
Radicand common_radicand(const TriangleMesh& mesh)
{
  using Point_map = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type;
  return common_radicand<Radicand>(mesh, Embedded_metric<TriangleMesh, Point_map>(get(CGAL::vertex_point, mesh)));
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_EXACT_INTRINSIC_TRIANGULATION_TRAITS_H
