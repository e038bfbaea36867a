// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MISTAKES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MISTAKES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>

// Compile-time checks that report frequent mistakes by a readable message.

namespace CGAL::Flip_geodesics {

enum class Stop_decision;
struct Shortening_step;
struct Surface_location;

namespace internal {

/* Whether a class is defined, not only declared. */
template <class T, class = void>
constexpr bool is_defined = false;
template <class T>
constexpr bool is_defined<T, std::void_t<decltype(sizeof(T))>> = true;

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
                "geom_traits() requires a kernel or a model of IntrinsicTriangulationTraits");
  static_assert(!is_kernel<Given> || !has_other_points<Given, Metric>,
                "the kernel given as geom_traits() must be the kernel of the points of the mesh");
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

/* The types of keys and values of a property map; of other types, none. */
template <class Map, class = void>
struct Map_traits
{
  using key_type = void;
  using value_type = double;
  static constexpr bool is_map = false;
};
template <class Map>
struct Map_traits<Map, std::void_t<typename boost::property_traits<Map>::key_type>> : boost::property_traits<Map>
{
  static constexpr bool is_map = true;
};

/* Fails to compile if the type is not a property map. */
template <class Map>
constexpr bool is_property_map()
{
  static_assert(!is_container_with_keys<Map>,
                "a std::map is not a property map: wrap it with boost::make_assoc_property_map()");
  static_assert(is_container_with_keys<Map> || Map_traits<Map>::is_map,
                "a property map is expected here: wrap a function with boost::make_function_property_map(), or a "
                "std::vector with boost::make_iterator_property_map()");
  return true;
}

/* Whether get() returns a value of a property map for a key; maps without a key type have one for every key. */
template <class Map, class Key, class = void>
constexpr bool is_readable = false;
template <class Map, class Key>
constexpr bool
    is_readable<Map, Key, std::void_t<decltype(get(std::declval<const Map&>(), std::declval<const Key&>()))>> =
        std::is_void<typename Map_traits<Map>::key_type>::value ||
        std::is_convertible<Key, typename Map_traits<Map>::key_type>::value;

/* Detects number types of the standard library, Boost and CGAL. */
template <class T>
constexpr bool is_number = std::numeric_limits<T>::is_specialized ||
                           std::is_convertible<decltype(CGAL::to_double(std::declval<const T&>())), double>::value;

/* Fails to compile if the type is not a property map with numbers for keys of this type, by default for its own ones.
 * */
template <class Map, class Key = typename Map_traits<Map>::key_type>
constexpr bool is_number_map()
{
  if constexpr(!std::is_void<typename Map_traits<Map>::key_type>::value && !is_readable<Map, Key>)
    static_assert(is_readable<Map, Key>, "the property map has keys of another type, or get() does not accept them");
  else
    static_assert(is_number<typename Map_traits<Map>::value_type>, "the values of the property map must be numbers");
  return is_property_map<Map>();
}

template <class T, class = void>
constexpr bool is_metric = false;
template <class T>
constexpr bool is_metric<T, std::void_t<typename T::Kernel, typename T::Place>> = true;

/* Detects stop predicates, which decide whether a step is taken. */
template <class T>
constexpr bool is_stop_predicate = std::is_invocable_r<Stop_decision, const T&, const Shortening_step&>::value;

template <class Metric, class Mesh, class = void>
constexpr bool reports_rounding = false;
template <class Metric, class Mesh>
constexpr bool reports_rounding<
    Metric, Mesh, std::void_t<decltype(std::declval<const Metric&>().is_rounded(std::declval<const Mesh&>()))>> = true;

/* Detects metrics that throw an exception for a mesh other than theirs. */
template <class Metric, class Mesh, class = void>
constexpr bool checks_input = false;
template <class Metric, class Mesh>
constexpr bool checks_input<
    Metric, Mesh, std::void_t<decltype(std::declval<const Metric&>().check_input(std::declval<const Mesh&>()))>> = true;

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

/* Detects points in space. */
template <class T, class = void>
constexpr bool is_point_in_space = false;
template <class T>
constexpr bool
    is_point_in_space<T, std::void_t<decltype(std::declval<const T&>().x()), decltype(std::declval<const T&>().y()),
                                     decltype(std::declval<const T&>().z())>> = true;

struct Known_piece;

/*
 * The members of the library's own classes that it uses beyond their documentation. The header of such a class
 * specializes this template. Other models of a concept provide only what the concept requires, and the library works
 * without the rest.
 */
template <class Model>
struct Internals
{
  static constexpr bool has_exact_faces = false;     // provides exact_face()
  static constexpr bool has_precise_numbers = false; // provides precise_edge(), precise_halfedge() and flat_edges()
  static constexpr bool has_usable_faces = false;    // provides is_usable_face()

  /* Inserts a point as a vertex of a triangulation, without using the known piece close to it. */
  template <class OnSplit>
  static Vertex_index insert(Model& model, const Surface_location& location, const OnSplit& on_split, Known_piece&)
  {
    return model.insert(location, on_split);
  }
};

} // namespace internal
} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MISTAKES_H
