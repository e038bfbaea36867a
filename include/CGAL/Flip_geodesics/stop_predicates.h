// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_STOP_PREDICATES_H
#define CGAL_FLIP_GEODESICS_STOP_PREDICATES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsStop
/// What a stop predicate says of a step that is about to be taken.
enum class Stop_decision {
  CONTINUE,           ///< take it
  CURVE_LENGTH_LIMIT, ///< do not take it, and leave its curve as it is; go on with the others
  LENGTH_LIMIT,       ///< do not take it, and end
  ANGLE_LIMIT,        ///< do not take it, and end
  ITERATION_LIMIT,    ///< do not take it, and end
  MEMORY_LIMIT        ///< do not take it, and end
};

/// \ingroup PkgFlipGeodesicsStop
/// The step that is about to be taken, with the lengths before and after it.
struct Shortening_step
{
  Curve_index curve;           ///< the curve that the step shortens
  double angle_key;            ///< `Turn_key` of the wedge, in [0, 2]: 1 - cos / (|cos| + sin) of its angle
  std::size_t steps;           ///< the number of steps taken so far
  double curve_initial_length; ///< of the curve
  double curve_length_after;   ///< of the curve, if the step is taken
  double initial_length;       ///< of the network
  double length_after;         ///< of the network, if the step is taken
  std::size_t memory;          ///< `Intrinsic_triangulation::memory_of_records()` with the flips of the step, in bytes
};

/// \ingroup PkgFlipGeodesicsStop
/// Never stops. \cgalModels{FlipOutStopPredicate}
struct Never_stop_predicate
{
  /// `CONTINUE`, whatever the step.
  Stop_decision operator()(const Shortening_step&) const { return Stop_decision::CONTINUE; }
};

namespace internal {

/*
 * Returns whether a length is below `ratio` times the initial one, or so close to it that rounding errors could hide
 * this. The lengths of a step are kept by adding up the changes of all steps and differ from sums over the segments;
 * the margin covers an error of 2^-53 of the initial length for each of 2^21 additions.
 */
inline bool is_below_limit(double length, double ratio, double initial_length)
{
  constexpr double margin = 1.0 / (std::uint64_t(1) << 32);
  return ratio > 0 && length < (ratio + margin) * initial_length;
}

} // namespace internal

/// \ingroup PkgFlipGeodesicsStop
/// Keeps the network's total length at `ratio` times its initial length or above, as summed over its segments. A step
/// that would lead closer to the limit than 2^-32 of the initial length is refused, for the sake of rounding errors.
/// \cgalModels{FlipOutStopPredicate}
class Length_ratio_stop_predicate
{
public:
  /// Sets the limit.
  /// \param ratio the least length, as a part of the initial one
  /// \pre 0 <= ratio <= 1
  explicit Length_ratio_stop_predicate(double ratio)
    : m_ratio(ratio)
  {
    CGAL_precondition(0 <= ratio && ratio <= 1);
  }

  /// `LENGTH_LIMIT` if the network would become shorter than allowed, else `CONTINUE`.
  Stop_decision operator()(const Shortening_step& step) const
  {
    return internal::is_below_limit(step.length_after, m_ratio, step.initial_length) ? Stop_decision::LENGTH_LIMIT
                                                                                     : Stop_decision::CONTINUE;
  }

private:
  double m_ratio;
};

/// \ingroup PkgFlipGeodesicsStop
/// Keeps each curve's length at `ratio` times its initial length or above, as summed over its segments, so that small
/// loops survive too. A step that would lead closer to the limit than 2^-32 of the initial length is refused, for the
/// sake of rounding errors.
/// \cgalModels{FlipOutStopPredicate}
class Curve_length_ratio_stop_predicate
{
public:
  /// Sets the limit.
  /// \param ratio the least length, as a part of the initial one
  /// \pre 0 <= ratio <= 1
  explicit Curve_length_ratio_stop_predicate(double ratio)
    : m_ratio(ratio)
  {
    CGAL_precondition(0 <= ratio && ratio <= 1);
  }

  /// `CURVE_LENGTH_LIMIT` if the curve would become shorter than allowed, else `CONTINUE`.
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
/// Stops when the smallest angle that could be widened has reached a limit. \cgalModels{FlipOutStopPredicate}
class Angle_stop_predicate
{
public:
  /// Sets the limit.
  /// \param angle in radians, in (0, \f$\pi\f$]
  explicit Angle_stop_predicate(double angle)
    : m_key(1 - std::cos(angle) / (std::abs(std::cos(angle)) + std::sin(angle)))
  {
    CGAL_precondition(angle > 0);
  }

  /// `ANGLE_LIMIT` if the angle of the wedge, the smallest left, has reached the limit, else `CONTINUE`.
  Stop_decision operator()(const Shortening_step& step) const
  {
    return step.angle_key >= m_key ? Stop_decision::ANGLE_LIMIT : Stop_decision::CONTINUE;
  }

private:
  double m_key;
};

/// \ingroup PkgFlipGeodesicsStop
/// Stops after a number of steps. \cgalModels{FlipOutStopPredicate}
class Iteration_stop_predicate
{
public:
  /// Sets the limit.
  /// \param limit the number of steps that may be taken, as `Shortening_step::steps` counts them
  explicit Iteration_stop_predicate(std::size_t limit)
    : m_limit(limit)
  {
  }

  /// `ITERATION_LIMIT` if so many steps were taken, else `CONTINUE`.
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

/* The predicate for a further curve: itself, unless it can start afresh. */
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
/// Stops when a time is over, counted from the predicate's construction; where a function computes several curves, one
/// after the other, counted for each from its start. \cgalModels{FlipOutStopPredicate}
class Time_stop_predicate
{
public:
  /// Sets the limit, and starts to count.
  /// \param limit a time in seconds, or any duration of `std::chrono`; it runs from now on
  explicit Time_stop_predicate(std::chrono::duration<double> limit)
    : m_limit(limit)
    , m_start(std::chrono::steady_clock::now())
  {
  }

  /// `ITERATION_LIMIT` if the time is over, else `CONTINUE`.
  Stop_decision operator()(const Shortening_step&) const
  {
    return std::chrono::steady_clock::now() - m_start >= m_limit ? Stop_decision::ITERATION_LIMIT
                                                                 : Stop_decision::CONTINUE;
  }

  /// The same time, counted from now.
  Time_stop_predicate restarted() const { return Time_stop_predicate(m_limit); }

private:
  std::chrono::duration<double> m_limit;
  std::chrono::steady_clock::time_point m_start;
};

/// \ingroup PkgFlipGeodesicsStop
/// Stops when the records of flips take more memory than a limit. The flips of one step can pass it before they are taken
/// back, and what was derived for them stays. \cgalModels{FlipOutStopPredicate}
class Memory_stop_predicate
{
public:
  /// Sets the limit.
  /// \param limit in bytes
  explicit Memory_stop_predicate(std::size_t limit)
    : m_limit(limit)
  {
  }

  /// `MEMORY_LIMIT` if the records with the flips of the step take more than the limit, else `CONTINUE`.
  Stop_decision operator()(const Shortening_step& step) const
  {
    return step.memory > m_limit ? Stop_decision::MEMORY_LIMIT : Stop_decision::CONTINUE;
  }

private:
  std::size_t m_limit;
};

/// \ingroup PkgFlipGeodesicsStop
/// Stops as soon as one of several predicates does; the first that does decides how. \cgalModels{FlipOutStopPredicate}
template <class... Predicates>
class Any_stop_predicate
{
public:
  /// Takes copies of the predicates, which are asked in this order.
  explicit Any_stop_predicate(Predicates... predicates)
    : m_predicates(predicates...)
  {
  }

  /// The first answer that is not `CONTINUE`, if there is one; predicates after it are not asked.
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

  /// The same predicates, those started afresh that can.
  Any_stop_predicate restarted() const
  {
    return std::apply(
        [](const Predicates&... predicate) { return Any_stop_predicate(internal::restarted(predicate)...); },
        m_predicates);
  }

private:
  std::tuple<Predicates...> m_predicates;
};

/*!
 * \ingroup PkgFlipGeodesicsStop
 *
 * A visitor that does nothing; derive from it and hide what you need.
 *
 * \cgalModels{FlipOutVisitor}
 * \cgalModels{RefinementVisitor}
 */
struct Default_shortening_visitor
{
  /// After the edge of halfedge `h` was flipped. A step that is not taken after all flips back without a call.
  template <class Triangulation>
  void on_flip(const Triangulation&, Halfedge_index /* h */)
  {
  }

  /// After a step: a joint of `curve` has been moved over its wedge.
  template <class Network>
  void after_flip_out(const Network&, Curve_index /* curve */)
  {
  }

  /// After `refine()` has inserted vertex `v`, with the flips around it.
  template <class Triangulation>
  void on_insertion(const Triangulation&, Vertex_index /* v */)
  {
  }

  /// Asked before each step: shall the shortening go on?
  bool go_further() { return true; }
};

/// \ingroup PkgFlipGeodesicsFunctions
/// How many windows a search for shortest paths may make, of some 60 bytes each, and along how many edges rays may start
/// from vertices; beyond either the search is given up.
class Window_limit
{
public:
  /// For \f$n\f$ vertices \f$10^6 + 500 n + 2 n^{3/2}\f$: several times the number for meshes whose faces are not needles. On smooth
  /// ones all distances from a vertex take up to about \f$0.7 n^{3/2}\f$.
  Window_limit() = default;

  /// At most about so many.
  explicit Window_limit(std::size_t windows)
    : m_windows(windows)
  {
  }

  /// The limit for a mesh with a number of vertices.
  std::size_t operator()(std::size_t number_of_vertices) const
  {
    const double n = static_cast<double>(number_of_vertices);
    return m_windows.value_or(static_cast<std::size_t>(1000000 + 500 * n + 2 * n * std::sqrt(n)));
  }

private:
  std::optional<std::size_t> m_windows;
};

namespace internal {

/* The stop predicate that is given, or one that never stops. */
template <class NamedParameters>
decltype(auto) stop_predicate_of(const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, Stop_parameter>)
    return parameters::get_parameter_reference(np, stop_parameter);
  else
    return Never_stop_predicate();
}

} // namespace internal

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_STOP_PREDICATES_H
