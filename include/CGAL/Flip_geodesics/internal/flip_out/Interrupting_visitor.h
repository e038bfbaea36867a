// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_INTERRUPTING_VISITOR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_INTERRUPTING_VISITOR_H

#include <CGAL/Flip_geodesics/Shortening_visitor.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>

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

/* Passes all on to a visitor, in a computation that consists of several shortenings: none of them takes a step once the
 * visitor has stopped one, and it is not asked again. */
template <class Visitor>
class Stop_remembering_visitor
{
public:
  explicit Stop_remembering_visitor(Visitor& visitor)
    : m_visitor(visitor)
    , m_interruption(visitor)
  {
  }

  template <class Triangulation>
  void on_flip(const Triangulation& triangulation, Halfedge_index h)
  {
    m_visitor.on_flip(triangulation, h);
  }

  template <class Network>
  void after_flip_out(const Network& network, Curve_index curve)
  {
    m_visitor.after_flip_out(network, curve);
  }

  bool go_further() { return !m_interruption.begin_part(); }
  bool has_stopped() const { return m_interruption.has_occurred(); }

private:
  Visitor& m_visitor;
  Interruption m_interruption;
};

/* Is a visitor to see the steps of a shortening, so that it starts from the path that is given? */
template <class Visitor>
constexpr bool observes_steps =
    !std::is_same<Visitor, Default_shortening_visitor>::value && !std::is_same<Visitor, Interrupting_visitor>::value;

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_INTERRUPTING_VISITOR_H
