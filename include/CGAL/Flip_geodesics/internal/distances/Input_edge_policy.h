// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_INPUT_EDGE_POLICY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_INPUT_EDGE_POLICY_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/metrics.h>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The length of a halfedge of the input in the metric of a triangulation, for a search that only passes by. */
template <class Triangulation>
class Metric_weight
{
public:
  explicit Metric_weight(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  double operator()(Input_halfedge_index h) const
  {
    return m_triangulation.metric().weight(m_triangulation.input(), h);
  }

private:
  const Triangulation& m_triangulation;
};

/*
 * The policy of a search over the whole input mesh, along its edges. Derived classes hide the members that differ.
 *
 * \tparam Weight `weight(h)` is the length of a halfedge, which is refused unless it is zero or usable
 */
template <class Input_mesh, class Weight>
class Input_edge_policy : public Search_policy
{
public:
  struct Origin
  {
    Vertex_index vertex;
    double distance;
  };

  struct Step
  {
    double distance;
  };

  /* \param interruption null if the search cannot be interrupted */
  Input_edge_policy(const Input_mesh& input, const Weight& weight, Interruption* interruption)
    : m_input(input)
    , m_weight(weight)
    , m_interruption(interruption)
  {
  }

  /* \throws Interrupted */
  bool settle(Vertex_index) const
  {
    throw_if_interrupted(m_interruption);
    return true;
  }

  template <class Label>
  Origin origin(Vertex_index v, const Label& label) const
  {
    return {v, label.distance};
  }

  /* Clockwise, and along the border to the next umbrella. */
  template <class Function>
  void for_each_halfedge(const Origin& origin, const Function& function) const
  {
    const Input_halfedge_index first = m_input.outgoing(origin.vertex);
    Input_halfedge_index h = first;
    do {
      function(h);
      h = m_input.next(twin_index(h));
    } while(h != first);
  }

  Vertex_index head(Input_halfedge_index h) const { return m_input.tail(twin_index(h)); }

  Step step(const Origin& origin, Input_halfedge_index h, Vertex_index w) const
  {
    return {origin.distance + length(origin, h, w)};
  }

  /* \throws Invalid_coordinate_error */
  double length(const Origin& origin, Input_halfedge_index h, Vertex_index w) const
  {
    const double result = m_weight(h);
    if(!is_zero_or_usable_length(result))
      throw_unusable_length(result, origin.vertex, w);
    return result;
  }

private:
  const Input_mesh& m_input;
  Weight m_weight;
  Interruption* m_interruption;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_INPUT_EDGE_POLICY_H
