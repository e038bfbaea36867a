// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INTERRUPTION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INTERRUPTION_H

#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <type_traits>
#include <utility>

namespace CGAL::Flip_geodesics::internal {

/* Calls a visitor at regular intervals to determine whether a search continues. Once interrupted, it remains
 * interrupted. */
class Interruption
{
public:
  /* \param visitor must outlive this object; only `go_further()` is called */
  template <class Visitor>
  explicit Interruption(Visitor& visitor)
    : m_go_further([&visitor] { return static_cast<bool>(visitor.go_further()); })
  {
  }

  bool has_occurred() const { return m_has_occurred; }

  /* Counts a step that is about to be taken; returns whether it must not be taken. */
  bool count_step() { return ++m_steps % interval == 0 ? begin_part() : m_has_occurred; }

  /* Calls the visitor before a part of a computation that takes far longer than a step; returns whether the part must
   * be skipped. */
  bool begin_part()
  {
    m_has_occurred = m_has_occurred || !m_go_further();
    return m_has_occurred;
  }

private:
  // Steps of a search take at most a microsecond on average, whereas a visitor may read a clock.
  static constexpr std::size_t interval = 1024;

  std::function<bool()> m_go_further;
  std::size_t m_steps = 0;
  bool m_has_occurred = false;
};

/*
 * A visitor for the parts of a computation that several threads process simultaneously, each with an `Interruption` of
 * its own. Only the thread that constructed it calls the caller's visitor; the others receive the result.
 */
class Shared_interruption
{
public:
  explicit Shared_interruption(Interruption& interruption)
    : m_interruption(interruption)
    , m_has_occurred(interruption.has_occurred())
  {
  }

  bool go_further()
  {
    if(std::this_thread::get_id() == m_thread && m_interruption.begin_part())
      m_has_occurred = true;
    return !m_has_occurred;
  }

private:
  Interruption& m_interruption;
  std::thread::id m_thread = std::this_thread::get_id();
  std::atomic<bool> m_has_occurred;
};

/* Counts a step of a search that may be uninterruptible. */
inline bool is_interrupted(Interruption* interruption) { return interruption != nullptr && interruption->count_step(); }

/* Counts a step of a search compiled without interruptions, at no cost. */
constexpr bool is_interrupted() { return false; }

/* Begins a part of a computation that may be uninterruptible. */
inline bool is_interrupted_before_part(Interruption* interruption)
{
  return interruption != nullptr && interruption->begin_part();
}

/* Thrown by a computation to end itself if its partial results are useless. The functions between its innermost loops
 * and the public one return trees, searches and bases, which would otherwise have to be accompanied by a status. */
struct Interrupted
{
};

/* Returns the result of `compute()`, or a value-initialized result if it is interrupted. */
template <class Compute>
auto result_unless_interrupted(const Compute& compute) -> decltype(compute())
{
  try {
    return compute();
  } catch(const Interrupted&) {
    return {};
  }
}

/* Counts a step of such a computation. \throws Interrupted */
inline void throw_if_interrupted(Interruption* interruption)
{
  if(is_interrupted(interruption))
    throw Interrupted();
}

/* Begins a part of such a computation. \throws Interrupted */
inline void throw_if_interrupted_before_part(Interruption* interruption)
{
  if(is_interrupted_before_part(interruption))
    throw Interrupted();
}

template <class T>
struct Visitor_holder
{
  T visitor;
  T& get() { return visitor; }
};

template <class T>
struct Visitor_holder<std::reference_wrapper<T>>
{
  static_assert(!std::is_const<T>::value, "a visitor that cannot be copied must be passed as std::ref(visitor)");
  std::reference_wrapper<T> visitor;
  T& get() { return visitor.get(); }
};

/* Returns the visitor of the named parameters: a copy, the caller's own by `std::ref()`, or one that does nothing. */
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

template <class Visitor, class = void>
struct Has_progress : std::false_type
{
};

template <class Visitor>
struct Has_progress<Visitor, std::void_t<decltype(std::declval<Visitor&>().on_progress(0.5))>> : std::true_type
{
};

/* Passes the finished fraction of a computation on to a visitor, if it has a member for it. */
template <class Visitor>
void report_progress(Visitor& visitor, std::size_t finished, std::size_t number)
{
  if constexpr(Has_progress<Visitor>::value)
    visitor.on_progress(static_cast<double>(finished) / static_cast<double>(number));
}

/* Returns the result of `compute(interruption)`, where the interruption is null unless a visitor is given, or a
 * value-initialized result if the visitor stops it. */
template <class NamedParameters, class Compute>
auto result_unless_stopped(const NamedParameters& np, const Compute& compute)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value) {
    return static_cast<void>(np), compute(static_cast<Interruption*>(nullptr));
  } else {
    auto visitor = make_visitor(np);
    Interruption interruption(visitor.get());
    return result_unless_interrupted([&] { return compute(&interruption); });
  }
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INTERRUPTION_H
