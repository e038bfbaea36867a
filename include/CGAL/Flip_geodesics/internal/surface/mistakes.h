// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MISTAKES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MISTAKES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <iterator>
#include <type_traits>
#include <utility>

// Compile-time checks that replace frequent mistakes by a readable message.

namespace CGAL {
namespace Flip_geodesics {

enum class Stop_decision;
struct Shortening_step;

namespace internal {

/* Detects traits, as opposed to kernels, by the type of what a halfedge stores. */
template <class T, class = void>
constexpr bool is_triangulation_traits = false;
template <class T>
constexpr bool is_triangulation_traits<T, std::void_t<typename T::Halfedge_geometry>> = true;

/* Detects kernels. */
template <class T, class = void>
constexpr bool is_kernel = false;
template <class T>
constexpr bool is_kernel<T, std::void_t<typename T::FT, typename T::Point_3, typename T::Vector_3>> =
    !is_triangulation_traits<T>;

/* Returns whether the points of a metric belong to another kernel. A metric without points fits any kernel. */
template <class Kernel, class Metric, class = void>
constexpr bool has_other_points = false;
template <class Kernel, class Metric>
constexpr bool has_other_points<Kernel, Metric, std::void_t<typename Metric::Point_3, typename Kernel::Point_3>> =
    !std::is_void<typename Metric::Point_3>::value &&
    !std::is_same<typename Metric::Point_3, typename Kernel::Point_3>::value;

/* The traits specified by the named parameter geom_traits: for a kernel, the default ones. */
template <class Given, class Metric, class Default>
struct Traits_given
{
  static_assert(is_kernel<Given> || is_triangulation_traits<Given>,
                "geom_traits() takes a kernel or a model of IntrinsicTriangulationTraits");
  static_assert(!is_kernel<Given> || !has_other_points<Given, Metric>,
                "the kernel given as geom_traits() is not that of the mesh's points");
  using type = std::conditional_t<is_triangulation_traits<Given>, Given, Default>;
};

/* Detects triangulations that provide the sequences of input edges crossed by their edges. */
template <class Triangulation, class = void>
constexpr bool has_edge_sequences = false;
template <class Triangulation>
constexpr bool has_edge_sequences<
    Triangulation, std::void_t<decltype(std::declval<const Triangulation&>().edge_sequence(Halfedge_index()))>> = true;

template <class T>
constexpr bool is_named_parameters = false;
template <class T, class Tag, class Base>
constexpr bool is_named_parameters<Named_function_parameters<T, Tag, Base>> = true;

template <class Range>
using Range_value = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

template <class T, class = void>
constexpr bool is_range = false;
template <class T>
constexpr bool is_range<T, std::void_t<Range_value<T>>> = true;

template <class T, class = void>
constexpr bool is_range_of_ranges = false;
template <class T>
constexpr bool is_range_of_ranges<T, std::void_t<Range_value<T>>> = is_range<Range_value<T>>;

/* Detects ranges whose elements are of a type or convert to it implicitly. */
template <class Range, class T, class = void>
constexpr bool is_range_of = false;
template <class Range, class T>
constexpr bool is_range_of<Range, T, std::void_t<Range_value<Range>>> =
    std::is_convertible<Range_value<Range>, T>::value;

/* Detects meshes by their faces. */
template <class T, class = void>
constexpr bool has_faces = false;
template <class T>
constexpr bool has_faces<T, std::void_t<decltype(faces(std::declval<const T&>()))>> = true;

/* Detects containers with keys, such as `std::map`, which resemble property maps. */
template <class T, class = void>
constexpr bool is_container_with_keys = false;
template <class T>
constexpr bool is_container_with_keys<T, std::void_t<typename T::mapped_type>> = true;

/* Ends the compilation if the type is not a property map for this reason. */
template <class Map>
constexpr bool is_property_map()
{
  static_assert(!is_container_with_keys<Map>,
                "a std::map is not a property map: boost::make_assoc_property_map() makes one of it");
  return true;
}

template <class T, class = void>
constexpr bool is_metric = false;
template <class T>
constexpr bool is_metric<T, std::void_t<typename T::Kernel, typename T::Place>> = true;

/* Detects stop predicates, which decide whether a step is taken. */
template <class T>
constexpr bool is_stop_predicate = std::is_invocable_r<Stop_decision, const T&, const Shortening_step&>::value;

/* Detects visitors with all members that are called for a network while its curves are shortened. */
template <class Visitor, class Network, class = void>
constexpr bool is_visitor = false;
template <class Visitor, class Network>
constexpr bool is_visitor<
    Visitor, Network,
    std::void_t<decltype(static_cast<bool>(std::declval<Visitor&>().go_further())),
                decltype(std::declval<Visitor&>().on_flip(std::declval<typename Network::Triangulation&>(),
                                                          Halfedge_index())),
                decltype(std::declval<Visitor&>().after_flip_out(std::declval<Network&>(), Curve_index()))>> = true;

/* Returns the double to which a number rounds. */
template <class NT>
double imported_number(const NT& x)
{
  if constexpr(is_rational_number<NT>)
    return rounded_number(x);
  else
    return CGAL::to_double(x);
}

/* Returns the double to which a lazy number rounds; `CGAL::to_double()` guarantees five digits only, and others depend
 * on whether its exact value is known. */
template <class ET>
double imported_number(const Lazy_exact_nt<ET>& x)
{
  return x.approx().is_point() ? x.approx().inf() : imported_number(x.exact());
}

/* Returns whether a number changes when it is imported as a double. Uncertain cases, as for intervals, count as
 * changed. */
template <class NT>
bool is_rounded_number(const NT& x)
{
  if constexpr(is_within_double<NT>)
    return static_cast<void>(x), false;
  else
    return !CGAL::certainly(x == NT(imported_number(x)));
}

template <class Metric, class Mesh, class = void>
constexpr bool reports_rounding = false;
template <class Metric, class Mesh>
constexpr bool reports_rounding<
    Metric, Mesh, std::void_t<decltype(std::declval<const Metric&>().is_rounded(std::declval<const Mesh&>()))>> = true;

/*
 * Returns whether a metric replaces numbers of its mesh by rounded doubles. Results that are exact for these doubles
 * are then not exact for the mesh. A metric that does not report this is defined by its lengths, which must be doubles.
 */
template <class Metric, class Mesh>
bool is_rounded_metric(const Metric& metric, const Mesh& mesh)
{
  using Length = decltype(metric.length(mesh, mesh.outgoing({})));
  if constexpr(!is_within_double<std::decay_t<Length>>)
    return true;
  else if constexpr(reports_rounding<Metric, Mesh>)
    return metric.is_rounded(mesh);
  else
    return false;
}

/*
 * Returns whether the input of a triangulation is rounded, if it has an input. The first call takes linear time, unless
 * the numbers are doubles.
 */
template <class Triangulation>
bool is_input_rounded(const Triangulation& triangulation)
{
  if constexpr(has_edge_sequences<Triangulation>)
    return is_rounded_metric(triangulation.metric(), triangulation.input());
  else
    return static_cast<void>(triangulation), false;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MISTAKES_H
