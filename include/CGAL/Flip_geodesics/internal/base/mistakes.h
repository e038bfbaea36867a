// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_BASE_MISTAKES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_BASE_MISTAKES_H

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

/* Has a range elements of a type, or such as become it by themselves? */
template <class Range, class T>
constexpr bool is_range_of = std::is_convertible<Range_value<Range>, T>::value;

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_BASE_MISTAKES_H
