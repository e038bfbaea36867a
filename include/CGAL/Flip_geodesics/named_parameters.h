// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_NAMED_PARAMETERS_H
#define CGAL_FLIP_GEODESICS_NAMED_PARAMETERS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {

namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsStop
 *
 * Implements a visitor that does nothing. To write a visitor, derive a class from this one and redefine the members
 * that the visitor needs.
 *
 * \cgalModels{FlipOutVisitor}
 * \cgalModels{RefinementVisitor}
 */
struct Default_shortening_visitor
{
  /// Is called after the edge of halfedge `h` has been flipped. It is not called when the flips of a rejected step are
  /// rolled back.
  template <class Triangulation>
  void on_flip(const Triangulation&, Halfedge_index /* h */)
  {
  }

  /// Is called after a step has shortened a curve.
  template <class Network>
  void after_flip_out(const Network&, Curve_index /* curve */)
  {
  }

  /// Is called after `refine()` has inserted vertex `v` and flipped the edges around it.
  template <class Triangulation>
  void on_insertion(const Triangulation&, Vertex_index /* v */)
  {
  }

  /// Returns `true`, so that the computation continues.
  bool go_further() { return true; }
};

/// \ingroup PkgFlipGeodesicsFunctions
/// Limits the number of windows that a search for shortest paths creates; a window takes about 60 bytes. The limit also
/// applies to the number of rays that the search starts along edges at sources and pseudo-sources. The search is
/// aborted when one of the two numbers exceeds the limit.
class Window_limit
{
public:
  /// Sets the default limit, which is \f$10^6 + 500 n + 2 n^{3/2}\f$ for a mesh with \f$n\f$ vertices. On smooth
  /// meshes, computing the distances from one vertex to all others requires up to about \f$0.7 n^{3/2}\f$ windows.
  Window_limit() = default;

  /// Sets the limit to a given number of windows. A search can exceed this number slightly before it is aborted.
  explicit Window_limit(std::size_t windows)
    : m_windows(windows)
  {
  }

  /// Returns the limit for a mesh with a given number of vertices.
  std::size_t operator()(std::size_t number_of_vertices) const
  {
    const double n = static_cast<double>(number_of_vertices);
    return m_windows.value_or(static_cast<std::size_t>(1000000 + 500 * n + 2 * n * std::sqrt(n)));
  }

private:
  std::optional<std::size_t> m_windows;
};

namespace internal {

enum Metric_parameter { metric_parameter };
enum Stop_parameter { stop_parameter };
enum Limit_parameter { limit_parameter };
enum Landmarks_parameter { landmarks_parameter };
enum At_vertices_parameter { at_vertices_parameter };
enum Nearest_source_parameter { nearest_source_parameter };
enum Point_distance_parameter { point_distance_parameter };
enum Closed_parameter { closed_parameter };

template <class NamedParameters, class Tag>
constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Tag>::value;

template <class NamedParameters, class Tag>
using Given = typename internal_np::Get_param<typename NamedParameters::base, Tag>::type;

template <class T, class Tag, class Base, class Others>
auto put_before(const Named_function_parameters<T, Tag, Base>& np, const Others& others)
{
  static_assert(!is_given<Others, Tag> || std::is_same<Tag, internal_np::all_default_t>::value,
                "each named parameter must be passed at most once");
  const auto& first = static_cast<const internal_np::Named_params_impl<T, Tag, Base>&>(np);
  if constexpr(std::is_same<Base, internal_np::No_property>::value) {
    return Named_function_parameters<T, Tag, Others>(first.v, others);
  } else {
    const auto rest = put_before(static_cast<const Base&>(np), others);
    return Named_function_parameters<T, Tag, std::remove_const_t<decltype(rest)>>(first.v, rest);
  }
}

inline parameters::Default_named_parameters joined() { return parameters::default_values(); }

template <class NamedParameters, class... Others>
decltype(auto) joined(const NamedParameters& np, const Others&... others)
{
  static_assert(is_named_parameters<NamedParameters>,
                "an option is not a named parameter: pass it as parameters::stop_predicate(...), "
                "parameters::search_limit(...) or the like, after all other arguments; the function does not take "
                "another argument here");
  if constexpr(!is_named_parameters<NamedParameters>)
    return joined(others...); // avoids another error message
  else if constexpr(sizeof...(Others) == 0)
    return (np);
  else
    return put_before(np, joined(others...));
}

template <class... NamedParameters>
using Joined = std::decay_t<decltype(joined(std::declval<const NamedParameters&>()...))>;

/* Determines whether the names of all named parameters are among the tags. */
template <class NamedParameters, class... Tags>
struct Has_names_of : std::false_type
{
};

template <class... Tags>
struct Has_names_of<internal_np::No_property, Tags...> : std::true_type
{
};

template <class T, class Tag, class Base, class... Tags>
struct Has_names_of<Named_function_parameters<T, Tag, Base>, Tags...>
  : std::bool_constant<(std::is_same<Tag, Tags>::value || ... ||
                        std::is_same<Tag, internal_np::all_default_t>::value) &&
                       Has_names_of<Base, Tags...>::value>
{
};

/* Returns the named parameters that were passed to a function. Their names must be among the tags. */
template <class... Tags, class... NamedParameters>
decltype(auto) options_of(const NamedParameters&... np)
{
  static_assert(Has_names_of<Joined<NamedParameters...>, Tags...>::value,
                "at least one of these named parameters is not accepted by the function, whose reference page lists "
                "the accepted ones");
  return joined(np...);
}

/* Returns the named parameters of a function that also accepts the parameters for lengths and traits. */
template <class... Tags, class... NamedParameters>
decltype(auto) surface_options(const NamedParameters&... np)
{
  return options_of<internal_np::vertex_point_t, Metric_parameter, internal_np::geom_traits_t, Tags...>(np...);
}

/* Returns the named parameters of a function that also shortens curves. */
template <class... Tags, class... NamedParameters>
decltype(auto) curve_options(const NamedParameters&... np)
{
  return surface_options<internal_np::visitor_t, Stop_parameter, Tags...>(np...);
}

template <class Limit, class NamedParameters>
Limit search_limit_of(const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, Limit_parameter>) {
    static_assert(std::is_same<Given<NamedParameters, Limit_parameter>, Limit>::value,
                  "the function does not accept this kind of search_limit()");
    return parameters::get_parameter(np, limit_parameter);
  } else {
    return Limit();
  }
}

template <class NamedParameters>
bool is_closed_of(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, closed_parameter), false);
}

/* Returns the named parameter number_of_iterations, an integer of signed or unsigned type. */
template <class NamedParameters>
std::size_t number_of_iterations(const NamedParameters& np, std::size_t standard)
{
  const auto number =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::number_of_iterations), standard);
  using Number = std::decay_t<decltype(number)>;
  static_assert(std::is_integral<Number>::value, "number_of_iterations() must be an integer");
  if constexpr(std::is_signed<Number>::value)
    if(number < 0)
      throw Invalid_parameter_error("number_of_iterations is " + std::to_string(number) + ", but must not be negative");
  return static_cast<std::size_t>(number);
}

/* Returns the given landmarks, or null. */
template <class Landmarks, class NamedParameters>
const Landmarks* landmarks_of(const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, Landmarks_parameter>) {
    const auto given = parameters::get_parameter(np, landmarks_parameter);
    static_assert(std::is_same<std::remove_const_t<decltype(given)>, std::reference_wrapper<const Landmarks>>::value,
                  "the function does not accept this kind of landmarks()");
    return &given.get();
  } else {
    return nullptr;
  }
}

} // namespace internal
} // namespace Flip_geodesics

/// Contains the named parameters of \cgal and of this package.
namespace parameters {

/*!
 * \ingroup PkgFlipGeodesicsParameters
 * Sets a metric, for instance an `Edge_length_metric`, whose lengths replace the distances between the points of the
 * mesh.
 * \param metric a model of `IntrinsicMetric`, which is copied. If the metric detects that it was constructed for
 *        another mesh, the function that receives the parameter throws `Input_mismatch_error`
 */
template <class Metric>
auto metric(const Metric& metric)
{
  static_assert(
      Flip_geodesics::internal::is_metric<Metric>,
      "metric() requires a model of IntrinsicMetric: wrap a property map of lengths in an Edge_length_metric");
  return Named_function_parameters<Metric, Flip_geodesics::internal::Metric_parameter>(metric);
}

/*!
 * \ingroup PkgFlipGeodesicsParameters
 * Sets the condition under which the shortening of a curve ends early.
 * \param predicate a model of `FlipOutStopPredicate`, which is copied unless it is passed by `std::ref()`
 */
template <class StopPredicate>
auto stop_predicate(const StopPredicate& predicate)
{
  static_assert(Flip_geodesics::internal::is_stop_predicate<StopPredicate>,
                "stop_predicate() requires a model of FlipOutStopPredicate");
  return Named_function_parameters<StopPredicate, Flip_geodesics::internal::Stop_parameter>(predicate);
}

/*!
 * \ingroup PkgFlipGeodesicsParameters
 * Sets the limits at which a search ends.
 * \param limit a `Covering_limit` for `shortest_paths_by_class()`, `Distance_field_limits` for
 *        `Geodesic_distance_field` and `Logarithmic_map`, `Mean_limits` for `Geodesic_mean`, and a `Window_limit` for
 *        all other searches
 */
template <class Limit>
auto search_limit(const Limit& limit)
{
  return Named_function_parameters<Limit, Flip_geodesics::internal::Limit_parameter>(limit);
}

/*!
 * \ingroup PkgFlipGeodesicsParameters
 * Sets whether a curve is closed, that is, whether it continues from its last element to the first.
 */
inline auto is_closed(bool is_closed)
{
  return Named_function_parameters<bool, Flip_geodesics::internal::Closed_parameter>(is_closed);
}

/*!
 * \ingroup PkgFlipGeodesicsParameters
 * Sets landmarks that guide searches. Computing landmarks is worthwhile if many searches on one mesh follow.
 * \param landmarks `Landmark_distances` for `geodesic_paths()` and `Shortest_edge_path`, or `Geodesic_landmarks` for
 *        `shortest_path()` and `add_shortest_path()`. The landmarks must have been computed for the mesh and its
 *        metric. They are not copied, and must outlive the call; if they are passed to a constructor, they must also
 *        outlive the constructed object
 */
template <class Landmarks>
auto landmarks(const Landmarks& landmarks)
{
  using Reference = std::reference_wrapper<const Landmarks>;
  return Named_function_parameters<Reference, Flip_geodesics::internal::Landmarks_parameter>(std::cref(landmarks));
}

/*!
 * \ingroup PkgFlipGeodesicsParameters
 * Sets a property map that receives the number of the nearest source for each vertex.
 * \param map a model of `WritablePropertyMap` with the vertices of the mesh as keys and integers as values. The map is
 *        copied
 */
template <class VertexSourceMap>
auto nearest_source_map(const VertexSourceMap& map)
{
  static_assert(Flip_geodesics::internal::is_property_map<VertexSourceMap>());
  return Named_function_parameters<VertexSourceMap, Flip_geodesics::internal::Nearest_source_parameter>(map);
}

/*!
 * \ingroup PkgFlipGeodesicsParameters
 * Sets the greatest distance from the surface at which a point in space is accepted. A point farther away causes a
 * `Distant_point_error`; by default, points are accepted at any distance.
 * \param distance a number in the unit of the coordinates. If the number is negative or NaN, the function that receives
 *        the parameter throws `Invalid_parameter_error`
 */
inline auto greatest_point_distance(double distance)
{
  return Named_function_parameters<double, Flip_geodesics::internal::Point_distance_parameter>(distance);
}

} // namespace parameters
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_NAMED_PARAMETERS_H
