// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_GOAL_BOUND_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_GOAL_BOUND_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Landmark_rows.h>

#include <algorithm>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Lower bounds of the distances to a vertex: that in space, or what landmarks say if it is more. Zero without one. */
template <class Triangulation>
class Goal_bound
{
public:
  explicit Goal_bound(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  Goal_bound(const Triangulation& triangulation, Vertex_index goal, const Landmark_rows* landmarks = nullptr)
    : m_triangulation(triangulation)
    , m_goal(goal)
    , m_place(triangulation.metric().place(triangulation.input(), goal))
    , m_landmarks(landmarks)
  {
  }

  double operator()(Vertex_index v) const
  {
    if(m_goal == null_index)
      return 0;
    const auto& metric = m_triangulation.metric();
    const double in_space = metric.distance_lower_bound(metric.place(m_triangulation.input(), v), m_place);
    return m_landmarks == nullptr ? in_space : (std::max)(in_space, m_landmarks->distance_lower_bound(v, m_goal));
  }

private:
  const Triangulation& m_triangulation;
  Vertex_index m_goal = null_index;
  typename Triangulation::Metric::Place m_place = {};
  const Landmark_rows* m_landmarks = nullptr;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_GOAL_BOUND_H
