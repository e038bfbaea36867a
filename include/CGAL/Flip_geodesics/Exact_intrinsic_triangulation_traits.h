// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXACT_INTRINSIC_TRIANGULATION_TRAITS_H
#define CGAL_FLIP_GEODESICS_EXACT_INTRINSIC_TRIANGULATION_TRAITS_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/Area_unit.h>
#include <CGAL/Flip_geodesics/internal/Number_operations.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsTraits
 *
 * The model of `IntrinsicTriangulationTraits` with the number type swapped in. What decisions are worth is a matter of
 * the number type:
 *
 * | number type | decisions | square roots |
 * |---|---|---|
 * | exact with roots, such as `Exact_predicates_exact_constructions_kernel_with_sqrt::FT` | exact | any mesh |
 * | rational, such as `Gmpq`, `boost::multiprecision::cpp_rational` | exact | meshes with one radicand |
 * | `Sqrt_extension<NT, ROOT>` | exact | meshes with one radicand |
 * | `Interval_nt<>` | exact, or `Uncertain_conversion_exception` | any mesh |
 * | rounded, such as `boost::multiprecision::cpp_bin_float_100`, `double` | up to `angle_tolerance()` | any mesh |
 *
 * A mesh has one radicand \f$d\f$ if the area of each face is a rational multiple of \f$\sqrt d\f$; `common_radicand()`
 * finds it. In the plane and on boxes along the axes it is 1, on regular tetrahedra and octahedra 3. Where a face does
 * not fit, `Inexact_root_error` is thrown when the face is touched.
 *
 * A halfedge stores its vector in a frame of its face that is scaled so that no length is ever needed: the first
 * halfedge \f$h\f$ of an input face is \f$(|h|^2, 0)\f$, the others are \f$(h\cdot v, \pm 2A)\f$, and the square of the
 * scale, \f$1/|h|^2\f$, is stored as well. So one root per input face, that of its squared area \f$A^2\f$, is the only
 * one, and flips need one division and no root [SC20, section 3.1 has lengths instead, and roots in each flip]. Rationals
 * count second coordinates in units of \f$\sqrt d\f$.
 *
 * Numbers that own memory make a triangulation's construction linear in the mesh, and exact ones grow with flips: see
 * the user manual for what each number type costs. To have exact decisions and speed, use
 * `Certified_intrinsic_triangulation_traits`.
 *
 * \tparam NT a field number type: a model of `RealEmbeddable` and `FieldWithSqrt`, or of `Field` with the functor
 *         `Is_square`, `Sqrt_extension`, `Interval_nt<>`, a rational or floating point number of
 *         Boost.Multiprecision, or `double`; doubles convert to it without loss
 * \tparam K a kernel with `Point_3` and `FT`; coordinates are taken as they are if `FT` is `NT`, otherwise as the doubles
 *         they round to
 *
 * \cgalModels{IntrinsicTriangulationTraits}
 */
template <class NT, class K = Simple_cartesian<double>>
class Exact_intrinsic_triangulation_traits
{
  using Operations = internal::Number_operations<NT>;
  using Area_unit = internal::Area_unit<NT>;

  static constexpr bool is_exact = internal::is_exact_number<NT>();
  static constexpr bool is_interval = Operations::kind == internal::Number_kind::INTERVAL;
  static constexpr bool is_rounded = Operations::kind == internal::Number_kind::FLOATING;
  static constexpr bool has_radicand = Operations::kind == internal::Number_kind::RATIONAL ||
                                       Operations::kind == internal::Number_kind::EXTENSION;

public:
  using FT = NT;
  /// Rounded numbers drift, even if 100 digits do so unseen. Intervals know by how much.
  using Has_drift = Boolean_tag<is_rounded>;
  using Point_3 = typename K::Point_3;
  /// The type of radicands: `NT` or, for `Sqrt_extension<NT, ROOT>`, `ROOT`.
  using Radicand = typename Area_unit::Radicand;

  /// The vector of a halfedge in the frame of its face, times an unknown positive factor whose square is `1 / scale`.
  /// The second coordinate is in units of \f$\sqrt d\f$.
  struct Halfedge_geometry
  {
    NT x, y, scale;
  };

  using Face_geometry = std::array<Halfedge_geometry, 3>;

  /// The rotation over a fan of corners, a complex number of any magnitude.
  struct Turn
  {
    NT x = NT(1), y = NT(0);
    bool is_empty = true;
    Uncertain<Comparison_result> comparison = SMALLER;
  };

  struct Flipped_geometry
  {
    Halfedge_geometry h, t, tn, tp;
  };

  /// For any mesh, or with radicand 1 if the number type has no roots.
  Exact_intrinsic_triangulation_traits() = default;

  /// For meshes with the radicand `d`, a positive number. Only for number types without roots.
  explicit Exact_intrinsic_triangulation_traits(const Radicand& d)
    : m_unit(d)
  {
    static_assert(has_radicand, "the number type has roots, and needs no radicand");
  }

  /// An angle, in radians, by which a straight angle may be missed and still count as straight. Zero unless `NT` rounds;
  /// then half of its digits are left for errors: about 1e-9 for `double` and 1e-51 for 100 digits.
  static double angle_tolerance() { return internal::sign_tolerance<NT>(); }

  /// \throws Inexact_root_error
  class Construct_face_3
  {
    using Vector_3 = std::array<NT, 3>;

  public:
    explicit Construct_face_3(const Area_unit& unit)
      : m_unit(&unit)
    {
    }

    Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
    {
      const Vector_3 u = difference(p, q), v = difference(q, r), w = difference(r, p);
      const Vector_3 normal = {NT(u[1] * v[2] - u[2] * v[1]), NT(u[2] * v[0] - u[0] * v[2]),
                               NT(u[0] * v[1] - u[1] * v[0])};
      return laid_out(dot(u, u), dot(u, v), dot(u, w), m_unit->root(dot(normal, normal)));
    }

  private:
    static NT number(const NT& x) { return x; }

    template <class Coordinate>
    static std::enable_if_t<!std::is_same<Coordinate, NT>::value, NT> number(const Coordinate& x)
    {
      return NT(CGAL::to_double(x));
    }

    static Vector_3 difference(const Point_3& p, const Point_3& q)
    {
      return {NT(number(q.x()) - number(p.x())), NT(number(q.y()) - number(p.y())), NT(number(q.z()) - number(p.z()))};
    }

    static NT dot(const Vector_3& u, const Vector_3& v) { return NT(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]); }

    const Area_unit* m_unit;
  };

  /// Lengths are taken as the doubles they are. \throws Inexact_root_error
  class Construct_face_from_lengths
  {
  public:
    explicit Construct_face_from_lengths(const Area_unit& unit)
      : m_unit(&unit)
    {
    }

    Face_geometry operator()(double length_a, double length_b, double length_c) const
    {
      const NT a(length_a), b(length_b), c(length_c);
      const NT aa = a * a, bb = b * b, cc = c * c, half = NT(1) / NT(2);
      const NT dot_next = (cc - aa - bb) * half, dot_previous = (bb - aa - cc) * half;
      // [Heron], the square of twice the area.
      const NT square = (a + b + c) * (a + b - c) * (b + c - a) * (c + a - b) * half * half;
      return laid_out(aa, dot_next, dot_previous, m_unit->root(square));
    }

  private:
    const Area_unit* m_unit;
  };

  /// Called by the library for rounded numbers and intervals only. \pre `NT` is not exact
  class Construct_face_2
  {
  public:
    Face_geometry operator()(const std::array<std::array<double, 2>, 3>& v, double error) const
    {
      CGAL_precondition_msg(!is_exact, "exact vectors cannot be laid out afresh from rounded ones");
      Face_geometry result;
      for(int i = 0; i < 3; ++i) {
        const double radius = error * (std::abs(v[i][0]) + std::abs(v[i][1]));
        result[i] = {within(v[i][0], radius), within(v[i][1], radius), NT(1)};
      }
      return result;
    }

  private:
    static NT within(double x, double radius)
    {
      if constexpr(is_interval)
        return NT(x) + NT(-radius, radius);
      else
        return static_cast<void>(radius), NT(x);
    }
  };

  /// As `Intrinsic_triangulation_traits::Extend_turn`.
  class Extend_turn
  {
  public:
    explicit Extend_turn(const Area_unit& unit)
      : m_unit(&unit)
    {
    }

    void operator()(Turn& turn, const Halfedge_geometry& in, const Halfedge_geometry& out,
                    const Halfedge_geometry& /* opposite */) const
    {
      if(CGAL::possibly(turn.comparison != SMALLER))
        return; // straight or more already, or unknown for good
      const NT x = -(NT(out.x * in.x) + m_unit->product(out.y, in.y));
      const NT y = non_negative(NT(out.y * in.x - out.x * in.y));
      const bool is_half_acute = is_interval && (is_positive(turn.x) || is_positive(x));
      if(turn.is_empty) {
        turn.x = x;
        turn.y = y;
      } else {
        const NT product_x = NT(turn.x * x) - m_unit->product(turn.y, y);
        turn.y = NT(turn.x * y + turn.y * x);
        turn.x = product_x;
      }
      turn.is_empty = false;
      turn.comparison = compared(turn, is_half_acute);
      rescale(turn);
    }

  private:
    // Areas are not negative, whatever rounding makes of them. Exact numbers need not be asked.
    static NT non_negative(const NT& y)
    {
      if constexpr(is_interval)
        return Operations::non_negative(y);
      else if constexpr(is_rounded)
        return Operations::sign(y) == NEGATIVE ? NT(0) : y;
      else
        return y;
    }

    static bool is_positive(const NT& x) { return CGAL::certainly(Operations::sign(x) == POSITIVE); }

    // The turn was below pi before, and the corner is at most pi: their sum is below 2 pi, and zero means what it says.
    // Where the sign of the sine is open, one summand below pi / 2 and a cosine above 0 leave the first quadrant only.
    static Uncertain<Comparison_result> compared(const Turn& turn, bool is_half_acute)
    {
      const Uncertain<Sign> sine = sign_of_sine(turn);
      if(!sine.is_certain())
        return is_half_acute && is_positive(turn.x) ? Uncertain<Comparison_result>(SMALLER)
                                                    : Uncertain<Comparison_result>(SMALLER, LARGER);
      switch(sine.make_certain()) {
      case POSITIVE: return SMALLER;
      case ZERO: return CGAL::certainly(Operations::sign(turn.x) == POSITIVE) ? SMALLER : EQUAL;
      case NEGATIVE: return LARGER;
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

    // The other number types have exponents enough.
    static void rescale(Turn& turn)
    {
      if constexpr(is_interval || std::is_floating_point<NT>::value) {
        const double norm = std::abs(Operations::to_double(turn.x)) + std::abs(Operations::to_double(turn.y));
        if((norm > 0x1p200 || norm < 0x1p-200) && norm > 0 && norm < std::numeric_limits<double>::infinity()) {
          const NT factor(std::ldexp(1.0, -std::ilogb(norm)));
          turn.x *= factor;
          turn.y *= factor;
        }
      }
    }

    const Area_unit* m_unit;
  };

  /// \throws Uncertain_conversion_exception if intervals leave the sign open
  class Compare_turn_with_straight
  {
  public:
    Uncertain<Comparison_result> operator()(const Turn& turn) const { return turn.comparison.make_certain(); }
  };

  class Turn_key
  {
  public:
    explicit Turn_key(const Area_unit& unit)
      : m_unit(&unit)
    {
    }

    double operator()(const Turn& turn) const
    {
      const double x = Operations::to_double(turn.x), y = m_unit->to_double() * Operations::to_double(turn.y);
      const double norm = std::abs(x) + std::abs(y);
      if(norm > 0x1p-900 && norm < 0x1p900)
        return key(x, y);
      // Numbers too long for double: the squares of cosine and sine are not.
      const NT xx = turn.x * turn.x, yy = m_unit->product(turn.y, turn.y), sum = xx + yy;
      const double cosine = std::sqrt(Operations::to_double(NT(xx / sum)));
      const bool is_obtuse = CGAL::certainly(Operations::sign(turn.x) == NEGATIVE);
      return key(is_obtuse ? -cosine : cosine, std::sqrt(Operations::to_double(NT(yy / sum))));
    }

  private:
    static double key(double x, double y) { return 1 - x / (std::abs(x) + y); }

    const Area_unit* m_unit;
  };

  /// As `Intrinsic_triangulation_traits::Flip`; the rotation between two frames changes the scale as well.
  class Flip
  {
  public:
    explicit Flip(const Area_unit& unit)
      : m_unit(&unit)
    {
    }

    Flipped_geometry operator()(const Halfedge_geometry& h, const Halfedge_geometry& hn, const Halfedge_geometry& hp,
                                const Halfedge_geometry& t, const Halfedge_geometry& tn,
                                const Halfedge_geometry& tp) const
    {
      const NT norm = -(NT(t.x * t.x) + m_unit->product(t.y, t.y));
      const Halfedge_geometry rotation = {NT((NT(h.x * t.x) + m_unit->product(h.y, t.y)) / norm),
                                          NT(NT(h.y * t.x - h.x * t.y) / norm), h.scale};
      const Halfedge_geometry moved_tn = product(rotation, tn), moved_tp = product(rotation, tp);
      return {opposite_sum(hp, moved_tn), opposite_sum(hn, moved_tp), moved_tn, moved_tp};
    }

  private:
    Halfedge_geometry product(const Halfedge_geometry& rotation, const Halfedge_geometry& v) const
    {
      return {NT(NT(rotation.x * v.x) - m_unit->product(rotation.y, v.y)), NT(rotation.x * v.y + rotation.y * v.x),
              rotation.scale};
    }

    static Halfedge_geometry opposite_sum(const Halfedge_geometry& a, const Halfedge_geometry& b)
    {
      return {NT(-(a.x + b.x)), NT(-(a.y + b.y)), a.scale};
    }

    const Area_unit* m_unit;
  };

  /// Only intervals grow.
  class Is_inaccurate
  {
  public:
    bool operator()(const Halfedge_geometry& h) const
    {
      if constexpr(is_interval)
        return !(Operations::radius(h.x) + Operations::radius(h.y) <
                 0x1p-14 * (std::abs(Operations::to_double(h.x)) + std::abs(Operations::to_double(h.y))));
      else
        return static_cast<void>(h), false;
    }
  };

  class Compute_squared_length
  {
  public:
    explicit Compute_squared_length(const Area_unit& unit)
      : m_unit(&unit)
    {
    }

    FT operator()(const Halfedge_geometry& h) const
    {
      return NT((NT(h.x * h.x) + m_unit->product(h.y, h.y)) * h.scale);
    }

  private:
    const Area_unit* m_unit;
  };

  class Compute_length
  {
  public:
    explicit Compute_length(const Area_unit& unit)
      : m_squared_length(unit)
    {
    }

    double operator()(const Halfedge_geometry& h) const
    {
      return std::sqrt(Operations::to_double(m_squared_length(h)));
    }

  private:
    Compute_squared_length m_squared_length;
  };

  Construct_face_3 construct_face_3_object() const { return Construct_face_3(m_unit); }
  Construct_face_from_lengths construct_face_from_lengths_object() const { return Construct_face_from_lengths(m_unit); }
  Construct_face_2 construct_face_2_object() const { return {}; }
  Extend_turn extend_turn_object() const { return Extend_turn(m_unit); }
  Compare_turn_with_straight compare_turn_with_straight_object() const { return {}; }
  Turn_key turn_key_object() const { return Turn_key(m_unit); }
  Flip flip_object() const { return Flip(m_unit); }
  Is_inaccurate is_inaccurate_object() const { return {}; }
  Compute_squared_length compute_squared_length_object() const { return Compute_squared_length(m_unit); }
  Compute_length compute_length_object() const { return Compute_length(m_unit); }

private:
  // Rounded numbers are scaled to the size of the face at once: products of squared lengths would leave their range.
  static Face_geometry laid_out(const NT& square, const NT& dot_next, const NT& dot_previous, const NT& doubled_area)
  {
    if constexpr(is_exact) {
      const NT scale = NT(1) / square;
      return {{{square, NT(0), scale}, {dot_next, doubled_area, scale}, {dot_previous, NT(-doubled_area), scale}}};
    } else {
      const NT height = doubled_area / square;
      return {{{NT(1), NT(0), square},
               {NT(dot_next / square), height, square},
               {NT(dot_previous / square), NT(-height), square}}};
    }
  }

  Area_unit m_unit;
};

/*!
 * \ingroup PkgFlipGeodesicsTraits
 *
 * The number \f$d\f$ for which the area of every face of a mesh is a rational multiple of \f$\sqrt d\f$, for
 * `Exact_intrinsic_triangulation_traits` over a number type without roots. Squares of primes below 1000 are taken out of
 * it.
 *
 * Reads the whole mesh; linear but for the arithmetic, on integers of some hundred bits.
 *
 * \tparam Radicand a number type that integers given as doubles convert to
 * \param metric `Embedded_metric` or `Edge_length_metric`
 * \throws Inexact_root_error if there is no such number; `elements()` are the vertices of a face that does not fit the
 *         first one
 */
template <class Radicand, class TriangleMesh, class Metric>
Radicand common_radicand(const TriangleMesh& mesh, const Metric& metric)
{
  const typename Metric::Mesh input(mesh);
  internal::Integer radicand = 0;
  for(Index h = 0; h < input.number_of_halfedges(); ++h) {
    if(input.is_border(h))
      continue;
    const internal::Integer square = metric.exact_face(input, h).doubled_area_squared;
    if(square == 0)
      continue;
    if(radicand == 0)
      radicand = internal::without_squares(square);
    if(!internal::is_perfect_square(square * radicand)) {
      const Index a = input.tail(h), b = input.tail(input.next(h)), c = input.tail(input.next(input.next(h)));
      throw Inexact_root_error("the area of the face with vertices " + std::to_string(a) + ", " + std::to_string(b) +
                                   ", " + std::to_string(c) + " is not a rational multiple of that of the first face",
                               {static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
    }
  }
  return radicand == 0 ? Radicand(1) : internal::converted<Radicand>(radicand);
}

/// \ingroup PkgFlipGeodesicsTraits
/// The same for a mesh embedded in space by its own points.
template <class Radicand, class TriangleMesh>
Radicand common_radicand(const TriangleMesh& mesh)
{
  using Point_map = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type;
  return common_radicand<Radicand>(mesh,
                                   Embedded_metric<TriangleMesh, Point_map>(get(CGAL::vertex_point, mesh)));
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_EXACT_INTRINSIC_TRIANGULATION_TRAITS_H
