// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_STOP_PREDICATES_H
#define CGAL_FLIP_GEODESICS_STOP_PREDICATES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsStop
/// Lists the decisions of a stop predicate about the next step.
enum class Stop_decision {
  CONTINUE,           ///< take the step
  CURVE_LENGTH_LIMIT, ///< reject the step and stop shortening its curve, with `Shortening_status::LENGTH_LIMIT`, but
                      ///< continue with the other curves
  LENGTH_LIMIT,       ///< reject the step and end the shortening with `Shortening_status::LENGTH_LIMIT`
  ANGLE_LIMIT,        ///< reject the step and end the shortening with `Shortening_status::ANGLE_LIMIT`
  ITERATION_LIMIT,    ///< reject the step and end the shortening with `Shortening_status::ITERATION_LIMIT`
  MEMORY_LIMIT        ///< reject the step and end the shortening with `Shortening_status::MEMORY_LIMIT`
};

/// \ingroup PkgFlipGeodesicsStop
/// Describes the next step, with the initial lengths and the lengths after the step.
struct Shortening_step
{
  Curve_index curve;           ///< the curve that the step shortens
  double angle_key;            ///< the `Turn_key` of the wedge, in [0, 2]: 1 - c / (|c| + s), where c and s are
                               ///< the cosine and the sine of the angle of the wedge
  std::size_t steps;           ///< the number of steps taken so far in this run
  double curve_initial_length; ///< the initial length of the curve
  double curve_length_after;   ///< the length of the curve if the step is taken
  double initial_length;       ///< the initial length of the network
  double length_after;         ///< the length of the network if the step is taken
  std::size_t memory;          ///< `Intrinsic_triangulation::memory_of_records()` after the step, in bytes
};

/// \ingroup PkgFlipGeodesicsStop
/// Never stops. \cgalModels{FlipOutStopPredicate}
struct Never_stop_predicate
{
  /// Returns `CONTINUE` for every step.
  Stop_decision operator()(const Shortening_step&) const { return Stop_decision::CONTINUE; }
};

namespace internal {

/*
 * Returns whether a length is below `ratio` times the initial length, or exceeds this limit by so little that rounding
 * errors can be the reason. The lengths of a step result from adding the changes of all previous steps, and differ
 * from sums over the segments; the margin covers an error of 2^-53 of the initial length for each of 2^21 additions.
 */
inline bool is_below_limit(double length, double ratio, double initial_length)
{
  constexpr double margin = 1.0 / (std::uint64_t(1) << 32);
  return ratio > 0 && length < (ratio + margin) * initial_length;
}

} // namespace internal

/// \ingroup PkgFlipGeodesicsStop
/// Keeps the total length of the network, summed over its segments, at or above `ratio` times the initial length of the
/// network. To allow for rounding errors, a step is also rejected if the length after the step would exceed this bound
/// by less than 2^-32 of the initial length. If `ratio` is 0, no step is rejected.
/// \cgalModels{FlipOutStopPredicate}
class Length_ratio_stop_predicate
{
public:
  /// Sets the limit.
  /// \param ratio the minimal length, as a fraction of the initial length
  /// \pre 0 <= ratio <= 1
  explicit Length_ratio_stop_predicate(double ratio)
    : m_ratio(ratio)
  {
    CGAL_precondition(0 <= ratio && ratio <= 1);
  }

  /// Returns `LENGTH_LIMIT` if the network would become too short, otherwise `CONTINUE`.
  Stop_decision operator()(const Shortening_step& step) const
  {
    return internal::is_below_limit(step.length_after, m_ratio, step.initial_length) ? Stop_decision::LENGTH_LIMIT
                                                                                     : Stop_decision::CONTINUE;
  }

private:
  double m_ratio;
};

/// \ingroup PkgFlipGeodesicsStop
/// Keeps the length of each curve, summed over its segments, at or above `ratio` times the initial length of the curve,
/// so that even small loops do not contract to points. To allow for rounding errors, a step is also rejected if the
/// length after the step would exceed this bound by less than 2^-32 of the initial length. If `ratio` is 0, no step is
/// rejected.
/// \cgalModels{FlipOutStopPredicate}
class Curve_length_ratio_stop_predicate
{
public:
  /// Sets the limit.
  /// \param ratio the minimal length, as a fraction of the initial length
  /// \pre 0 <= ratio <= 1
  explicit Curve_length_ratio_stop_predicate(double ratio)
    : m_ratio(ratio)
  {
    CGAL_precondition(0 <= ratio && ratio <= 1);
  }

  /// Returns `CURVE_LENGTH_LIMIT` if the curve would become too short, otherwise `CONTINUE`.
  Stop_decision operator()(const Shortening_step& step) const
  {
    return internal::is_below_limit(step.curve_length_after, m_ratio, step.curve_initial_length)
               ? Stop_decision::CURVE_LENGTH_LIMIT
               : Stop_decision::CONTINUE;
  }

private:
  double m_ratio;
};

/// \ingroup PkgFlipGeodesicsStop
/// Stops when the smallest angle that can still be widened is at least a given limit. \cgalModels{FlipOutStopPredicate}
class Angle_stop_predicate
{
public:
  /// Sets the limit.
  /// \param angle the angle at which shortening stops, in radians, in (0, \f$\pi\f$]
  explicit Angle_stop_predicate(double angle)
    : m_key(1 - std::cos(angle) / (std::abs(std::cos(angle)) + std::sin(angle)))
  {
    CGAL_precondition(angle > 0 && angle <= boost::math::constants::pi<double>());
  }

  /// Returns `ANGLE_LIMIT` if the angle of the wedge of the step is at least the limit, otherwise `CONTINUE`. Since
  /// steps are taken in the order of their angles, this angle is the smallest one that can be widened.
  Stop_decision operator()(const Shortening_step& step) const
  {
    return step.angle_key >= m_key ? Stop_decision::ANGLE_LIMIT : Stop_decision::CONTINUE;
  }

private:
  double m_key;
};

/// \ingroup PkgFlipGeodesicsStop
/// Stops after a given number of steps. \cgalModels{FlipOutStopPredicate}
class Iteration_stop_predicate
{
public:
  /// Sets the limit.
  /// \param limit the maximal number of steps, as counted by `Shortening_step::steps`
  explicit Iteration_stop_predicate(std::size_t limit)
    : m_limit(limit)
  {
  }

  /// Returns `ITERATION_LIMIT` if the maximal number of steps has been taken, otherwise `CONTINUE`.
  Stop_decision operator()(const Shortening_step& step) const
  {
    return step.steps >= m_limit ? Stop_decision::ITERATION_LIMIT : Stop_decision::CONTINUE;
  }

private:
  std::size_t m_limit;
};

namespace internal {

template <class StopPredicate, class = void>
struct Can_restart : std::false_type
{
};

template <class StopPredicate>
struct Can_restart<StopPredicate, std::void_t<decltype(std::declval<const StopPredicate&>().restarted())>>
  : std::true_type
{
};

/* Returns the predicate for the next path or leg: a restarted one if the class has `restarted()`, otherwise `stop`. */
template <class StopPredicate>
decltype(auto) restarted(const StopPredicate& stop)
{
  if constexpr(Can_restart<StopPredicate>::value)
    return stop.restarted();
  else
    return (stop);
}

} // namespace internal

/// \ingroup PkgFlipGeodesicsStop
/// Stops when a given time has elapsed since the object was constructed. As a stop predicate, the object limits the
/// time that is spent on shortening. The functions `geodesic_paths()`, `geodesics_through()` and
/// `geodesic_path_through()` restart the timer for each path or leg, so the limit applies to each one separately. As a
/// visitor, the object limits the time of any computation that accepts a visitor, for example of a search, a tree or a
/// distance field.
/// \cgalModels{FlipOutStopPredicate} \cgalModels{FlipOutVisitor} \cgalModels{RefinementVisitor}
class Time_stop_predicate : public Default_shortening_visitor
{
public:
  /// Sets the limit and starts the timer.
  /// \param limit a duration, for example of type `std::chrono::seconds`
  explicit Time_stop_predicate(std::chrono::duration<double> limit)
    : m_limit(limit)
    , m_start(std::chrono::steady_clock::now())
  {
  }

  /// Returns `ITERATION_LIMIT` if the time has elapsed, otherwise `CONTINUE`.
  Stop_decision operator()(const Shortening_step&) const
  {
    return go_further() ? Stop_decision::CONTINUE : Stop_decision::ITERATION_LIMIT;
  }

  /// Returns whether time remains.
  bool go_further() const { return std::chrono::steady_clock::now() - m_start < m_limit; }

  /// Returns a predicate with the limit of this object and with a timer that starts at the call.
  Time_stop_predicate restarted() const { return Time_stop_predicate(m_limit); }

private:
  std::chrono::duration<double> m_limit;
  std::chrono::steady_clock::time_point m_start;
};

/// \ingroup PkgFlipGeodesicsStop
/// Stops when the records of the triangulation (`Intrinsic_triangulation::memory_of_records()`) would take more memory
/// than a given limit. The records include faces that earlier queries have cached. Since a step is rolled back only
/// after its flips have been recorded, the memory can temporarily exceed the limit by the records of one step.
/// \cgalModels{FlipOutStopPredicate}
class Memory_stop_predicate
{
public:
  /// Sets the limit.
  /// \param limit the maximal memory, in bytes
  explicit Memory_stop_predicate(std::size_t limit)
    : m_limit(limit)
  {
  }

  /// Returns `MEMORY_LIMIT` if the records after the step take more memory than the limit, otherwise `CONTINUE`.
  Stop_decision operator()(const Shortening_step& step) const
  {
    return step.memory > m_limit ? Stop_decision::MEMORY_LIMIT : Stop_decision::CONTINUE;
  }

private:
  std::size_t m_limit;
};

/// \ingroup PkgFlipGeodesicsStop
/// Combines several predicates: a step is accepted only if all of them accept it.
/// \cgalModels{FlipOutStopPredicate}
template <class... Predicates>
class Any_stop_predicate
{
public:
  /// Copies the predicates, which are evaluated in the given order.
  explicit Any_stop_predicate(Predicates... predicates)
    : m_predicates(predicates...)
  {
  }

  /// Returns the decision of the first predicate that does not return `CONTINUE`; the predicates after it are not
  /// evaluated. If all predicates return `CONTINUE`, the result is `CONTINUE`.
  Stop_decision operator()(const Shortening_step& step) const
  {
    Stop_decision decision = Stop_decision::CONTINUE;
    std::apply(
        [&](const Predicates&... predicate) {
          ((decision = decision == Stop_decision::CONTINUE ? predicate(step) : decision), ...);
        },
        m_predicates);
    return decision;
  }

  /// Returns a copy of the combination in which every predicate that has a member `restarted()` is restarted.
  Any_stop_predicate restarted() const
  {
    return std::apply(
        [](const Predicates&... predicate) { return Any_stop_predicate(internal::restarted(predicate)...); },
        m_predicates);
  }

private:
  std::tuple<Predicates...> m_predicates;
};

namespace internal {

template <class NamedParameters>
decltype(auto) stop_predicate_of(const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, Stop_parameter>)
    return parameters::get_parameter_reference(np, stop_parameter);
  else
    return Never_stop_predicate();
}

} // namespace internal

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_STOP_PREDICATES_H
