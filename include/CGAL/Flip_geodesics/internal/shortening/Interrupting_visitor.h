// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTENING_INTERRUPTING_VISITOR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTENING_INTERRUPTING_VISITOR_H

#include <CGAL/Flip_geodesics/Shortening_visitor.h>
#include <CGAL/Flip_geodesics/internal/base/Interruption.h>

#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Passes on only whether a computation is to continue: for steps that the caller's visitor is not to observe. */
struct Interrupting_visitor : Default_shortening_visitor
{
  explicit Interrupting_visitor(Interruption& interruption_)
    : interruption(interruption_)
  {
  }

  bool go_further() { return !interruption.begin_part(); }

  Interruption& interruption;
};

/* Is a visitor to see the steps of a shortening, so that it starts from the path that is given? */
template <class Visitor>
constexpr bool observes_steps =
    !std::is_same<Visitor, Default_shortening_visitor>::value && !std::is_same<Visitor, Interrupting_visitor>::value;

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTENING_INTERRUPTING_VISITOR_H
