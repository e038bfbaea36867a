// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MISTAKES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MISTAKES_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <CGAL/Named_function_parameters.h>

#include <iterator>
#include <type_traits>
#include <utility>

// What a compiler is asked before it goes on, so that a mistake that is often made meets a sentence.

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class T, class = void>
struct Is_triangulation_traits : std::false_type
{
};

template <class T>
struct Is_triangulation_traits<T, std::void_t<typename T::Halfedge_geometry, typename T::Turn, typename T::Has_drift>>
  : std::true_type
{
};

/* Does a triangulation tell the words of its edges on an input? */
template <class Triangulation, class = void>
struct Has_words : std::false_type
{
};

template <class Triangulation>
struct Has_words<Triangulation,
                 std::void_t<decltype(std::declval<const Triangulation&>().crossing_word(Halfedge_index()))>>
  : std::true_type
{
};

template <class T>
struct Is_named_parameters : std::false_type
{
};

template <class T, class Tag, class Base>
struct Is_named_parameters<Named_function_parameters<T, Tag, Base>> : std::true_type
{
};

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

/* Has a range elements of a type, or such as become it by themselves? */
template <class Range, class T, class = void>
constexpr bool is_range_of = false;
template <class Range, class T>
constexpr bool is_range_of<Range, T, std::void_t<Range_value<Range>>> =
    std::is_convertible<Range_value<Range>, T>::value;

/* A mesh has faces. */
template <class T, class = void>
struct Has_faces : std::false_type
{
};

template <class T>
struct Has_faces<T, std::void_t<decltype(faces(std::declval<const T&>()))>> : std::true_type
{
};

/* A container with keys, such as `std::map`, is no property map, though it looks like one. */
template <class T, class = void>
constexpr bool is_container_with_keys = false;
template <class T>
constexpr bool is_container_with_keys<T, std::void_t<typename T::mapped_type>> = true;

/* Ends the compilation if what is to be a property map is none for this reason. */
template <class Map>
constexpr bool is_property_map()
{
  static_assert(!is_container_with_keys<Map>,
                "a std::map is no property map: boost::make_assoc_property_map() makes one of it");
  return true;
}

template <class T, class = void>
constexpr bool is_metric = false;
template <class T>
constexpr bool is_metric<T, std::void_t<typename T::Kernel, typename T::Place>> = true;

/* Has a visitor the members that are called for a network while its curves are shortened? */
template <class Visitor, class Network, class = void>
constexpr bool is_visitor = false;
template <class Visitor, class Network>
constexpr bool is_visitor<
    Visitor, Network,
    std::void_t<decltype(static_cast<bool>(std::declval<Visitor&>().go_further())),
                decltype(std::declval<Visitor&>().on_flip(std::declval<typename Network::Triangulation&>(),
                                                          Halfedge_index())),
                decltype(std::declval<Visitor&>().after_flip_out(std::declval<Network&>(), Curve_index()))>> = true;

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MISTAKES_H
