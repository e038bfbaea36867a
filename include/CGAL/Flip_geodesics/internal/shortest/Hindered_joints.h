// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_HINDERED_JOINTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_HINDERED_JOINTS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Shortening_report.h>
#include <CGAL/Flip_geodesics/internal/surface/imported_number.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The joints of paths whose wedges were flipped out in vain: the arc is longer. With exact decisions that happens only
 * where faces without area fold vertices onto one place. An edge between two of them has length zero, no angle is
 * defined at its ends, and so flips stop there. Joints are few, or none.
 */
class Hindered_joints
{
public:
  void clear() { m_joints.clear(); }

  /* The joint between two halfedges that start at the vertex which a path passes, in either order. */
  void add(Halfedge_index a, Halfedge_index c) { m_joints.emplace_back((std::min)(a, c), (std::max)(a, c)); }

  bool has(Halfedge_index a, Halfedge_index c) const
  {
    return std::find(m_joints.begin(), m_joints.end(), Joint((std::min)(a, c), (std::max)(a, c))) != m_joints.end();
  }

  /* The edge of h will be another one. */
  template <class Triangulation>
  void forget(const Triangulation& /* triangulation */, Halfedge_index h)
  {
    const auto is_there = [e = Triangulation::edge(h)](const Joint& joint) {
      return Triangulation::edge(joint.first) == e || Triangulation::edge(joint.second) == e;
    };
    m_joints.erase(std::remove_if(m_joints.begin(), m_joints.end(), is_there), m_joints.end());
  }

  /* Does a path of the tree pass one of them? */
  template <class Tree>
  bool are_in(const Tree& tree) const
  {
    const auto is_onward = [&](Halfedge_index h) { return tree.incoming(tree.triangulation().head(h)) == h; };
    const auto is_passed = [&](Halfedge_index back, Halfedge_index onward) {
      return is_onward(Tree::Triangulation::twin(back)) && is_onward(onward);
    };
    return std::any_of(m_joints.begin(), m_joints.end(), [&](const Joint& joint) {
      return is_passed(joint.first, joint.second) || is_passed(joint.second, joint.first);
    });
  }

private:
  using Joint = std::pair<Halfedge_index, Halfedge_index>;

  std::vector<Joint> m_joints;
};

/* What such joints mean with exact decisions. Rounded coordinates or lengths can deprive faces of their area. */
template <class Triangulation>
Shortening_status status_of_hindered(const Triangulation& triangulation)
{
  return is_input_rounded(triangulation) ? Shortening_status::PRECISION_LIMIT : Shortening_status::FLAT_FACES;
}

/*
 * Can the arc of a wedge be longer on account of vertices in one place? With decisions that err only if it passes such,
 * by edges of a length that is no more than rounding; others are left to those who measure.
 */
template <class Triangulation>
bool can_be_folded(const Triangulation& triangulation, const std::vector<Halfedge_index>& arc, double rounding)
{
  return !Triangulation::Traits::Has_drift::value ||
         std::any_of(arc.begin(), arc.end(), [&](Halfedge_index h) { return triangulation.length(h) <= rounding; });
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_HINDERED_JOINTS_H
