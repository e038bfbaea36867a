// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_EXACT_GEOMETRIES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_EXACT_GEOMETRIES_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/Multiquadratic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Sqrt_extension.h>
// Must precede the numbers of Boost, which it declares to CGAL.
#include <CGAL/boost_mp.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/multiprecision/number.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {

template <typename ET>
class Lazy_exact_nt;

namespace Flip_geodesics::internal {

/* The capabilities of a number type regarding square roots and exactness. */
enum class Number_kind {
  EXACT_WITH_ROOTS, // CORE::Expr
  RATIONAL,         // no roots, but squares are recognized
  EXTENSION,        // Sqrt_extension
  INTERVAL,         // signs may be uncertain
  FLOATING          // rounded, of fixed precision
};

/* The operations on number types known to CGAL. */
template <class NT>
struct Number_operations_of_cgal
{
  static double to_double(const NT& x) { return CGAL::to_double(x); }
  static auto sign(const NT& x) { return CGAL::sign(x); }
  static NT sqrt(const NT& x) { return CGAL::sqrt(x); }
};

/* The operations required of a number type. The first template is for types for which CGAL has traits. */
template <class NT, class Enable = void>
struct Number_operations : Number_operations_of_cgal<NT>
{
  using Structure = Algebraic_structure_traits<NT>;
  static constexpr bool has_roots = !std::is_same<typename Structure::Sqrt, Null_functor>::value;
  static constexpr Number_kind kind =
      !has_roots ? Number_kind::RATIONAL
                 : (Structure::Is_exact::value ? Number_kind::EXACT_WITH_ROOTS : Number_kind::FLOATING);

  static bool is_square(const NT& x, NT& root)
  {
    constexpr bool recognizes_squares = !std::is_same<typename Structure::Is_square, Null_functor>::value;
    static_assert(recognizes_squares, "the number type must provide square roots or recognize squares");
    if constexpr(recognizes_squares)
      return typename Structure::Is_square()(x, root);
    else
      return false;
  }
};

template <class NT>
struct Number_operations<NT, std::enable_if_t<std::is_floating_point<NT>::value>>
{
  static constexpr Number_kind kind = Number_kind::FLOATING;

  static double to_double(NT x) { return static_cast<double>(x); }
  static Sign sign(NT x) { return CGAL::sign(x); }
  static NT sqrt(NT x) { return std::sqrt(x); }
};

template <bool Protected>
struct Number_operations<Interval_nt<Protected>> : Number_operations_of_cgal<Interval_nt<Protected>>
{
  using NT = Interval_nt<Protected>;
  static constexpr Number_kind kind = Number_kind::INTERVAL;

  static NT sqrt(const NT& x) { return CGAL::sqrt(non_negative(x)); }
  static NT non_negative(const NT& x) { return NT((std::max)(x.inf(), 0.0), (std::max)(x.sup(), 0.0)); }
  static double radius(const NT& x) { return (x.sup() - x.inf()) / 2; }
};

template <class Coefficient, class Root, class DifferencesTag, class FilterTag>
struct Number_operations<Sqrt_extension<Coefficient, Root, DifferencesTag, FilterTag>>
  : Number_operations_of_cgal<Sqrt_extension<Coefficient, Root, DifferencesTag, FilterTag>>
{
  static constexpr Number_kind kind = Number_kind::EXTENSION;
};

/* The numbers of Boost: CGAL does not know those that are rounded, nor the squares among those that are not. */
template <class Backend, boost::multiprecision::expression_template_option Expressions>
struct Number_operations<boost::multiprecision::number<Backend, Expressions>>
{
  using NT = boost::multiprecision::number<Backend, Expressions>;
  static constexpr Number_kind kind =
      boost::multiprecision::number_category<NT>::value == boost::multiprecision::number_kind_rational
          ? Number_kind::RATIONAL
          : Number_kind::FLOATING;

  static double to_double(const NT& x) { return x.template convert_to<double>(); }
  static Sign sign(const NT& x) { return CGAL::sign(x.sign()); }
  static NT sqrt(const NT& x) { return boost::multiprecision::sqrt(x); }

  static bool is_square(const NT& x, NT& root)
  {
    using Integer = typename boost::multiprecision::component_type<NT>::type;
    const Integer above = boost::multiprecision::numerator(x), below = boost::multiprecision::denominator(x);
    const Integer root_above = boost::multiprecision::sqrt(above), root_below = boost::multiprecision::sqrt(below);
    root = NT(root_above, root_below);
    return root_above * root_above == above && root_below * root_below == below;
  }
};

/* Lazy numbers do what the numbers can that evaluate them; their own conversion to double returns five digits. */
template <class ET>
struct Number_operations<Lazy_exact_nt<ET>> : Number_operations_of_cgal<Lazy_exact_nt<ET>>
{
  using NT = Lazy_exact_nt<ET>;
  using Exact = Number_operations<ET>;
  static constexpr Number_kind kind = Exact::kind;

  static double to_double(const NT& x) { return Exact::to_double(x.exact()); }
  static bool is_square(const NT& x, NT& root)
  {
    ET exact_root;
    const bool result = Exact::is_square(x.exact(), exact_root);
    root = NT(exact_root);
    return result;
  }
};

/* Returns whether a number type has division. */
template <class NT>
constexpr bool is_field()
{
  namespace mp = boost::multiprecision;
  if constexpr(mp::is_number<NT>::value)
    return mp::number_category<NT>::value == mp::number_kind_rational ||
           mp::number_category<NT>::value == mp::number_kind_floating_point;
  else
    return std::is_convertible<typename Algebraic_structure_traits<NT>::Algebraic_category, Field_tag>::value;
}

/* Fails to compile if a number type has no division. */
template <class NT>
constexpr bool has_division()
{
  static_assert(is_field<NT>(), "the number type has no division; use a kernel whose number type is a field, such as "
                                "double or Gmpq, or specify the traits Intrinsic_triangulation_traits<K, double>");
  return true;
}

template <class NT>
constexpr bool is_exact_number()
{
  return Number_operations<NT>::kind != Number_kind::INTERVAL && Number_operations<NT>::kind != Number_kind::FLOATING;
}

/*
 * Returns the fraction of a number below which its sign counts as zero. Half of the digits of rounded numbers are for
 * errors: 1e-9 for double, 3e-52 for 100 digits.
 */
template <class NT>
double sign_tolerance()
{
  if(Number_operations<NT>::kind != Number_kind::FLOATING)
    return 0;
  constexpr int digits =
      std::numeric_limits<NT>::is_specialized ? std::numeric_limits<NT>::digits : std::numeric_limits<double>::digits;
  return std::ldexp(1.0, (std::max)(-digits / 2 - 4, least_tolerance_exponent));
}

[[noreturn]] inline void throw_inexact_root()
{
  throw Inexact_root_error("the area of a face is not a rational multiple of the square root of the radicand; "
                           "common_radicand() computes the radicand of a mesh, if it has one");
}

/*
 * The unit of areas and thus of the second coordinates of vectors: 1 if the number type has roots, otherwise sqrt(d).
 * `root(s)` is the root of s in this unit, and `product(a, b)` the product of two second coordinates.
 */
template <class NT, Number_kind Kind = Number_operations<NT>::kind>
class Area_unit
{
public:
  using Radicand = NT;

  NT root(const NT& square) const
  {
    // A negative value is that of a degenerate triangle with rounding errors.
    if constexpr(Number_operations<NT>::kind == Number_kind::FLOATING)
      if(Number_operations<NT>::sign(square) == NEGATIVE)
        return NT(0);
    return Number_operations<NT>::sqrt(square);
  }

  NT product(const NT& a, const NT& b) const { return a * b; }
  double to_double() const { return 1; }
};

template <class NT>
class Area_unit<NT, Number_kind::RATIONAL>
{
  using Operations = Number_operations<NT>;

public:
  using Radicand = NT;

  explicit Area_unit(const NT& radicand = NT(1))
    : m_radicand(radicand)
    , m_is_one(radicand == NT(1))
    , m_value(std::sqrt(Operations::to_double(radicand)))
  {
  }

  NT root(const NT& square) const
  {
    NT result;
    if(!Operations::is_square(square / m_radicand, result))
      throw_inexact_root();
    return result;
  }

  NT product(const NT& a, const NT& b) const { return m_is_one ? NT(a * b) : NT(m_radicand * NT(a * b)); }
  double to_double() const { return m_value; }

private:
  NT m_radicand;
  bool m_is_one;
  double m_value;
};

/* The unit is 1, but roots are found only in the form r sqrt(d) with a coefficient r. */
template <class NT>
class Area_unit<NT, Number_kind::EXTENSION>
{
  using Coefficient = typename NT::NT;

public:
  using Radicand = typename NT::ROOT;

  explicit Area_unit(const Radicand& radicand = Radicand(1))
    : m_radicand(radicand)
  {
  }

  NT root(const NT& square) const
  {
    Coefficient result;
    if(square.is_extended() ||
       !Number_operations<Coefficient>::is_square(square.a0() / Coefficient(m_radicand), result))
      throw_inexact_root();
    return m_radicand == Radicand(1) ? NT(result) : NT(Coefficient(0), result, m_radicand);
  }

  NT product(const NT& a, const NT& b) const { return a * b; }
  double to_double() const { return 1; }

private:
  Radicand m_radicand;
};

/* Returns a positive integer without those square factors that are easily found. */
inline Integer without_squares(Integer n)
{
  constexpr int limit = 1000;
  for(int p = 2; p < limit; ++p)
    while(n % (p * p) == 0)
      n /= p * p;
  for(int factor = 1; factor < limit; ++factor)
    if(n % factor == 0 && exact_root(n / factor))
      return factor;
  return n;
}

/* A corner of a face as a complex number. */
template <class NT>
struct Exact_corner
{
  NT x, y;
};

/* The halfedges that are new or in another face after the flip of the edge of h and t. */
template <class Halfedge_geometry>
struct Flipped_faces
{
  Halfedge_geometry h, t, tn, tp;
};

/*
 * Squared lengths L, and S = 4 area of each face in units of the area unit. Flips stay in the field of the input's
 * numbers, and the numbers of an edge are independent of the flips that led to it. For exact numbers only: rounded
 * values of L and S drift apart, exponentially in the number of flips.
 *
 * The S of a face is copied to its halfedges. A flip does not touch two of them that change their face; S therefore has
 * a generation, and of the copies in a face the one of the latest generation is correct.
 */
template <class NT>
class Squared_length_geometry
{
public:
  using Vector_3 = std::array<NT, 3>;
  using Unit = Area_unit<NT>;

  struct Halfedge_geometry
  {
    NT squared_length, quadrupled_area;
    int generation;
  };

  using Corner = Exact_corner<NT>;
  using Flipped_geometry = Flipped_faces<Halfedge_geometry>;
  using Face_geometry = std::array<Halfedge_geometry, 3>;

  static Face_geometry face(const Vector_3& u, const Vector_3& v, const Vector_3& w, const NT& quadrupled_area)
  {
    return face_from_squares(square(u), square(v), square(w), quadrupled_area);
  }

  static Face_geometry face_from_squares(const NT& a, const NT& b, const NT& c, const NT& quadrupled_area)
  {
    return {{{a, quadrupled_area, 0}, {b, quadrupled_area, 0}, {c, quadrupled_area, 0}}};
  }

  /* Returns the corner at the head of `in` as a complex number, twice the product of the lengths, by the law of
   * cosines. */
  static Corner corner(const Halfedge_geometry& in, const Halfedge_geometry& out, const Halfedge_geometry& opposite)
  {
    return {NT(in.squared_length + out.squared_length - opposite.squared_length), quadrupled_area(in, out, opposite)};
  }

  /*
   * |kl|^2 = ((x_k - x_l)^2 + (S_ijk + S_jil)^2 / 4) / L and S_ikl = (x_k S_jil + x_l S_ijk) / L, where h = i->j has
   * the squared length L, k and l are the opposite vertices, and x_k = (k - i).(j - i), x_l = (l - i).(j - i).
   */
  static Flipped_geometry flip(const Unit& unit, const Halfedge_geometry& h, const Halfedge_geometry& hn,
                               const Halfedge_geometry& hp, const Halfedge_geometry& t, const Halfedge_geometry& tn,
                               const Halfedge_geometry& tp)
  {
    const NT half = NT(1) / NT(2);
    const NT& l = h.squared_length;
    const NT area_h = quadrupled_area(h, hn, hp), area_t = quadrupled_area(t, tn, tp), area = area_h + area_t;
    const NT x_k = (l + hp.squared_length - hn.squared_length) * half;
    const NT x_l = (l + tn.squared_length - tp.squared_length) * half;
    const NT along = x_k - x_l, across = area * half;
    const NT diagonal = (NT(along * along) + unit.product(across, across)) / l;
    const NT at_i = (x_k * area_t + x_l * area_h) / l, at_j = area - at_i;
    const int generation =
        1 + (std::max)({h.generation, hn.generation, hp.generation, t.generation, tn.generation, tp.generation});
    return {{diagonal, at_i, generation},
            {diagonal, at_j, generation},
            {tn.squared_length, at_i, generation},
            {tp.squared_length, at_j, generation}};
  }

  /* Returns the triangle of three points, given by weights of the corners of a face, in the order of its halfedges'
   * tails. */
  static Face_geometry subface(const Face_geometry& face, const std::array<std::array<double, 3>, 3>& weights)
  {
    std::array<std::array<NT, 3>, 3> p;
    for(int i = 0; i < 3; ++i) {
      const NT sum = NT(weights[i][0]) + NT(weights[i][1]) + NT(weights[i][2]);
      for(int k = 0; k < 3; ++k)
        p[i][k] = NT(weights[i][k]) / sum;
    }
    const auto square = [&](int from, int to) { // of the length, from barycentric differences
      const NT a = p[to][0] - p[from][0], b = p[to][1] - p[from][1], c = p[to][2] - p[from][2];
      return NT(-(NT(a * b) * face[0].squared_length + NT(b * c) * face[1].squared_length +
                  NT(c * a) * face[2].squared_length));
    };
    const NT determinant = p[0][0] * NT(p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                           p[0][1] * NT(p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                           p[0][2] * NT(p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    return face_from_squares(square(0, 1), square(1, 2), square(2, 0),
                             NT(determinant * quadrupled_area(face[0], face[1], face[2])));
  }

  static NT squared_length(const Halfedge_geometry& h) { return h.squared_length; }

private:
  static NT square(const Vector_3& v) { return NT(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

  static const NT& quadrupled_area(const Halfedge_geometry& a, const Halfedge_geometry& b, const Halfedge_geometry& c)
  {
    const Halfedge_geometry& later = a.generation >= b.generation ? a : b;
    return later.generation >= c.generation ? later.quadrupled_area : c.quadrupled_area;
  }
};

/*
 * Vectors in a frame of the face, as in Intrinsic_triangulation_traits, for rounded numbers: errors grow linearly with
 * the number of flips. The unit of a frame is the length of an input halfedge, whose square, the scale, is stored as
 * well, so computing a face takes one root, that of the area, and no length.
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

  using Corner = Exact_corner<NT>;
  using Flipped_geometry = Flipped_faces<Halfedge_geometry>;
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

  /* Converts vectors with a relative error, which intervals include. */
  static Face_geometry face_from_vectors(const std::array<std::array<double, 2>, 3>& v, double error)
  {
    Face_geometry result;
    for(int i = 0; i < 3; ++i) {
      const double radius = error * (std::abs(v[i][0]) + std::abs(v[i][1]));
      result[i] = {within(v[i][0], radius), within(v[i][1], radius), NT(1)};
    }
    return result;
  }

  /* Returns the corner at the head of `in` as a complex number. */
  static Corner corner(const Halfedge_geometry& in, const Halfedge_geometry& out, const Halfedge_geometry&)
  {
    return {NT(-(out.x * in.x + out.y * in.y)), non_negative(NT(out.y * in.x - out.x * in.y))};
  }

  /* The rotation from the frame of t's face to that of h's face changes the scale as well. */
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

  // Areas are nonnegative, whatever the rounding errors are.
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

} // namespace Flip_geodesics::internal
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_EXACT_GEOMETRIES_H
