// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MAKE_VISITOR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MAKE_VISITOR_H

#include <CGAL/Flip_geodesics/Shortening_visitor.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <functional>
#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class T>
struct Visitor_holder
{
  T visitor;
  T& get() { return visitor; }
};

template <class T>
struct Visitor_holder<std::reference_wrapper<T>>
{
  static_assert(!std::is_const<T>::value, "a visitor that cannot be copied is given as std::ref(visitor)");
  std::reference_wrapper<T> visitor;
  T& get() { return visitor.get(); }
};

/* The visitor of the named parameters: a copy, the caller's own by `std::ref()`, or one that does nothing. */
template <class NamedParameters>
auto make_visitor(const NamedParameters& np)
{
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value) {
    using Visitor = std::decay_t<decltype(parameters::get_parameter(np, internal_np::visitor))>;
    return Visitor_holder<Visitor>{parameters::get_parameter(np, internal_np::visitor)};
  } else {
    return Visitor_holder<Default_shortening_visitor>{};
  }
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_MAKE_VISITOR_H
