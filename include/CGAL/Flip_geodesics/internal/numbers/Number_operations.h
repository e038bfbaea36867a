// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_NUMBER_OPERATIONS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_NUMBER_OPERATIONS_H

#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Sqrt_extension.h>
#include <CGAL/Uncertain.h>
// Must precede the numbers of Boost, which it declares to CGAL.
#include <CGAL/boost_mp.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/multiprecision/number.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {

template <typename ET>
class Lazy_exact_nt;

namespace Flip_geodesics {
namespace internal {

/* The capabilities of a number type regarding square roots and exactness. */
enum class Number_kind {
  EXACT_WITH_ROOTS, // CORE::Expr
  RATIONAL,         // no roots, but squares are recognized
  EXTENSION,        // Sqrt_extension
  INTERVAL,         // signs may be uncertain
  FLOATING          // rounded, of fixed precision
};

/* What is needed of a number type. The first template serves the types for which CGAL has traits. */
template <class NT, class Enable = void>
struct Number_operations
{
  using Structure = Algebraic_structure_traits<NT>;
  static constexpr bool has_roots = !std::is_same<typename Structure::Sqrt, Null_functor>::value;
  static constexpr Number_kind kind =
      !has_roots ? Number_kind::RATIONAL
                 : (Structure::Is_exact::value ? Number_kind::EXACT_WITH_ROOTS : Number_kind::FLOATING);

  static double to_double(const NT& x) { return CGAL::to_double(x); }
  static Sign sign(const NT& x) { return CGAL::sign(x); }
  static NT sqrt(const NT& x) { return CGAL::sqrt(x); }
  static bool is_square(const NT& x, NT& root)
  {
    constexpr bool recognizes_squares = !std::is_same<typename Structure::Is_square, Null_functor>::value;
    static_assert(recognizes_squares, "the number type must have square roots, or recognize squares");
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
struct Number_operations<Interval_nt<Protected>>
{
  using NT = Interval_nt<Protected>;
  static constexpr Number_kind kind = Number_kind::INTERVAL;

  static double to_double(const NT& x) { return CGAL::to_double(x); }
  static Uncertain<Sign> sign(const NT& x) { return CGAL::sign(x); }
  static NT sqrt(const NT& x) { return CGAL::sqrt(non_negative(x)); }
  static NT non_negative(const NT& x) { return NT((std::max)(x.inf(), 0.0), (std::max)(x.sup(), 0.0)); }
  static double radius(const NT& x) { return (x.sup() - x.inf()) / 2; }
};

template <class Coefficient, class Root, class DifferencesTag, class FilterTag>
struct Number_operations<Sqrt_extension<Coefficient, Root, DifferencesTag, FilterTag>>
{
  using NT = Sqrt_extension<Coefficient, Root, DifferencesTag, FilterTag>;
  static constexpr Number_kind kind = Number_kind::EXTENSION;

  static double to_double(const NT& x) { return CGAL::to_double(x); }
  static Sign sign(const NT& x) { return CGAL::sign(x); }
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
struct Number_operations<Lazy_exact_nt<ET>>
{
  using NT = Lazy_exact_nt<ET>;
  using Exact = Number_operations<ET>;
  static constexpr Number_kind kind = Exact::kind;

  static double to_double(const NT& x) { return Exact::to_double(x.exact()); }
  static Sign sign(const NT& x) { return CGAL::sign(x); }
  static NT sqrt(const NT& x) { return CGAL::sqrt(x); }
  static bool is_square(const NT& x, NT& root)
  {
    ET exact_root;
    const bool result = Exact::is_square(x.exact(), exact_root);
    root = NT(exact_root);
    return result;
  }
};

/* Has a number type division? */
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

/* Ends the compilation if a number type has no division. */
template <class NT>
constexpr bool has_division()
{
  static_assert(is_field<NT>(),
                "the number type is not a field: take a kernel over one with division, such as double or "
                "Gmpq, or Intrinsic_triangulation_traits<K, double>");
  return true;
}

template <class NT>
constexpr bool is_exact_number()
{
  return Number_operations<NT>::kind != Number_kind::INTERVAL && Number_operations<NT>::kind != Number_kind::FLOATING;
}

/*
 * By what fraction of a number its sign is taken for zero. Rounded numbers use up half of their digits for errors: 1e-9
 * for double, 1e-51 for 100 digits.
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_NUMBER_OPERATIONS_H
