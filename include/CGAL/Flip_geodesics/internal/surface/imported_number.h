// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_IMPORTED_NUMBER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_IMPORTED_NUMBER_H

#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/surface/shared_memory.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {

template <typename ET>
class Lazy_exact_nt;

namespace Flip_geodesics {
namespace internal {

/* Is every number of a type a double? */
template <class NT>
inline constexpr bool is_within_double = std::is_arithmetic<NT>::value&& std::numeric_limits<NT>::radix == 2 &&
                                         std::numeric_limits<NT>::digits <= std::numeric_limits<double>::digits;

/* The double that a number rounds to. */
template <class NT>
double imported_number(const NT& x)
{
  return CGAL::to_double(x);
}

/*
 * The same of a lazy number, whose value is made exact first unless it is known to be a double: otherwise the double
 * would depend on whether somebody else has asked for the exact value before.
 */
template <class ET>
double imported_number(const Lazy_exact_nt<ET>& x)
{
  if(!x.approx().is_point())
    x.exact();
  return CGAL::to_double(x);
}

/* Is a number changed when it is imported as a double? If that is uncertain, as for intervals, it counts as changed. */
template <class NT>
bool is_rounded_number(const NT& x)
{
  if constexpr(is_within_double<NT>)
    return static_cast<void>(x), false;
  else
    return !CGAL::certainly(x == NT(imported_number(x)));
}

/*
 * Whether a metric rounds what it is given to doubles, once that has been found out. A copy of a metric takes what is
 * known along. Several threads may ask at once.
 */
class Known_rounding
{
public:
  Known_rounding() = default;
  Known_rounding(const Known_rounding& other)
    : m_state(load_relaxed(other.m_state))
  {
  }
  Known_rounding& operator=(const Known_rounding& other)
  {
    store_relaxed(m_state, load_relaxed(other.m_state));
    return *this;
  }

  /* What `find()` returns, which is called once by each thread at most. */
  template <class Find>
  bool operator()(const Find& find) const
  {
    State state = load_relaxed(m_state);
    if(state == State::UNKNOWN) {
      state = find() ? State::ROUNDED : State::EXACT;
      store_relaxed(m_state, state);
    }
    return state == State::ROUNDED;
  }

private:
  enum class State : char { UNKNOWN, EXACT, ROUNDED };

  mutable State m_state = State::UNKNOWN;
};

template <class Metric, class Mesh, class = void>
struct Tells_rounding : std::false_type
{
};

template <class Metric, class Mesh>
struct Tells_rounding<Metric, Mesh,
                      std::void_t<decltype(std::declval<const Metric&>().is_rounded(std::declval<const Mesh&>()))>>
  : std::true_type
{
};

/*
 * Does a metric replace numbers of its mesh by the doubles that they round to? Then what is decided exactly from its
 * doubles is not decided of the mesh. A metric that does not tell is defined by its lengths, which must be doubles.
 */
template <class Metric, class Mesh>
bool is_rounded_metric(const Metric& metric, const Mesh& mesh)
{
  using Length = decltype(metric.length(mesh, mesh.outgoing({})));
  if constexpr(!is_within_double<std::decay_t<Length>>)
    return true;
  else if constexpr(Tells_rounding<Metric, Mesh>::value)
    return metric.is_rounded(mesh);
  else
    return false;
}

/*
 * The same of the input of a triangulation, if it tells of one. Linear in the mesh when it is first asked, unless its
 * numbers are doubles.
 */
template <class Triangulation>
bool is_input_rounded(const Triangulation& triangulation)
{
  if constexpr(Has_words<Triangulation>::value)
    return is_rounded_metric(triangulation.metric(), triangulation.input());
  else
    return static_cast<void>(triangulation), false;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_IMPORTED_NUMBER_H
