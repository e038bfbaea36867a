// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_TRIANGULATION_EDGE_POLICY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_TRIANGULATION_EDGE_POLICY_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/distances/Search_labels.h>
#include <CGAL/Flip_geodesics/internal/triangulation/umbrellas.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A search along edges of a triangulation as it is now. */
using Triangulation_edge_search = Label_setting_search<Search_labels<Halfedge_index>>;

/*
 * The policy of such a search, which ends at a vertex. Unlike searches over the input, it copies the faces that it
 * visits. Derived classes hide the members that differ.
 */
template <class Triangulation>
class Triangulation_edge_policy : public Search_policy
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

  Triangulation_edge_policy(const Triangulation& triangulation, Vertex_index target)
    : m_triangulation(triangulation)
    , m_target(target)
  {
  }

  bool settle(Vertex_index v) const { return v != m_target; }

  template <class Label>
  Origin origin(Vertex_index v, const Label& label) const
  {
    return {v, label.distance};
  }

  /* Counterclockwise to the border if there is one, then clockwise, and then in the other umbrellas. */
  template <class Function>
  void for_each_halfedge(const Origin& origin, const Function& function) const
  {
    const Halfedge_index start = m_triangulation.outgoing(origin.vertex);
    if(start == null_index)
      return;
    Halfedge_index h = start, first = start;
    do {
      function(h);
      first = h;
      h = m_triangulation.counterclockwise(h);
    } while(h != null_index && h != start);
    if(h == start)
      return;
    for(h = m_triangulation.clockwise(start); h != null_index; h = m_triangulation.clockwise(h))
      function(h);
    for_each_spoke_of_other_umbrellas(m_triangulation, first, function);
  }

  Vertex_index head(Halfedge_index h) const { return m_triangulation.head(h); }

  /* \throws Degenerate_face_error, Invalid_coordinate_error */
  Step step(const Origin& origin, Halfedge_index h, Vertex_index) const
  {
    return {origin.distance + m_triangulation.length(h)};
  }

protected:
  const Triangulation& triangulation() const { return m_triangulation; }
  Vertex_index target() const { return m_target; }

private:
  const Triangulation& m_triangulation;
  Vertex_index m_target;
};

/* The halfedges of the shortest path by a policy from a vertex to its target; none if there is no path. */
template <class Triangulation, class Policy>
std::vector<Halfedge_index> path_along_edges(const Triangulation& triangulation, Vertex_index source,
                                             Vertex_index target, const Policy& policy,
                                             Triangulation_edge_search& search)
{
  search.clear();
  search.add_source(source);
  if(search.run(policy))
    return {}; // the target has not been settled
  return search.path<Halfedge_index>(target, [&](Halfedge_index h) { return triangulation.tail(h); });
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_TRIANGULATION_EDGE_POLICY_H
