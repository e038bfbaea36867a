// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_POLICY_ARCHETYPES_H
#define FLIP_GEODESICS_TEST_POLICY_ARCHETYPES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <cstddef>

namespace Flip_geodesics_test {

/* A model of `FlipOutStopPredicate` that has nothing but what its page asks for: it stops after some steps. */
class Stop_predicate_archetype
{
public:
  explicit Stop_predicate_archetype(std::size_t most_steps)
    : m_most_steps(most_steps)
  {
  }
  Stop_predicate_archetype(const Stop_predicate_archetype&) = delete;
  Stop_predicate_archetype& operator=(const Stop_predicate_archetype&) = delete;

  CGAL::Flip_geodesics::Stop_decision operator()(const CGAL::Flip_geodesics::Shortening_step& step) const
  {
    return CGAL::Flip_geodesics::Iteration_stop_predicate(m_most_steps)(step);
  }

private:
  std::size_t m_most_steps;
};

/* A model of `FlipOutVisitor` that has nothing but what its page asks for: it counts. */
class Visitor_archetype
{
public:
  Visitor_archetype() = default;
  Visitor_archetype(const Visitor_archetype&) = delete;
  Visitor_archetype& operator=(const Visitor_archetype&) = delete;

  bool go_further()
  {
    ++m_questions;
    return true;
  }
  template <class Triangulation>
  void on_flip(const Triangulation&, CGAL::Flip_geodesics::Halfedge_index)
  {
    ++m_flips;
  }
  template <class Network>
  void after_flip_out(const Network&, CGAL::Flip_geodesics::Curve_index)
  {
    ++m_steps;
  }

  long questions() const { return m_questions; }
  long flips() const { return m_flips; }
  long steps() const { return m_steps; }

private:
  long m_questions = 0, m_flips = 0, m_steps = 0;
};

/* The same of `RefinementVisitor`. */
class Refinement_visitor_archetype : public Visitor_archetype
{
public:
  template <class Triangulation>
  void on_insertion(const Triangulation&, CGAL::Flip_geodesics::Vertex_index)
  {
    ++m_insertions;
  }

  long insertions() const { return m_insertions; }

private:
  long m_insertions = 0;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_POLICY_ARCHETYPES_H
