// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_NETWORK_STATE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_NETWORK_STATE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* All that an `Edge_path_network` is, apart from its triangulation, ids of segments included. */
struct Network_state
{
  struct Segment
  {
    Segment_index id;
    Halfedge_index halfedge;
    bool is_head_fixed;
  };

  struct Curve
  {
    bool is_closed;
    double initial_length;
    std::vector<Segment> segments;
  };

  struct Stack
  {
    Edge_index edge;
    std::vector<Segment_index> segments; // from left to right along the edge's first halfedge
  };

  Index end_of_segment_ids = 1;
  std::vector<Curve> curves;
  std::vector<Stack> stacks; // of the edges with several segments
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_NETWORK_STATE_H
