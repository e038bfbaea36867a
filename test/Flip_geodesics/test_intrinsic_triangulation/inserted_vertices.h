// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Vertices inserted in a plane.

#ifndef FLIP_GEODESICS_TEST_INTRINSIC_TRIANGULATION_INSERTED_VERTICES_H
#define FLIP_GEODESICS_TEST_INTRINSIC_TRIANGULATION_INSERTED_VERTICES_H

#include "test_intrinsic_triangulation/snapshots.h"

namespace Flip_geodesics_test {

// Adds points inside faces, on edges and on the border at random.
inline void insert_at_random(Triangulation& t, int number, Random_numbers& random)
{
  for(int i = 0; i < number; ++i) {
    const FG::Input_halfedge_index h(random.below(t.input().number_of_halfedges()));
    const bool is_on_edge = t.input().is_border(h) || random.below(2) == 0;
    t.insert({h, {{random.uniform(0.1, 1), random.uniform(0.1, 1), is_on_edge ? 0 : random.uniform(0.1, 1)}}});
  }
}

// Where a vertex of a triangulation of a flat mesh is.
inline std::complex<double> place(const Mesh& mesh, const Triangulation& t, FG::Vertex_index v)
{
  const FG::Surface_location at = t.location(v);
  std::complex<double> sum = 0;
  double weight = 0;
  FG::Input_halfedge_index h = at.halfedge;
  for(int i = 0; i < 3; ++i, h = t.input().next(h)) {
    const Point p = mesh.point(t.vertex(t.input().tail(h)));
    sum += at.weights[i] * std::complex<double>(p.x(), p.y());
    weight += at.weights[i];
  }
  return sum / weight;
}

// From the first direction counterclockwise to the second, in [0, 2 pi).
inline double planar_angle(const std::complex<double>& from, const std::complex<double>& to)
{
  const double angle = std::arg(to / from);
  return angle < -1e-9 ? angle + 2 * pi : angle;
}

// Does the turn counterclockwise from one spoke to another not meet the border?
inline bool is_inner_turn(const Triangulation& t, FG::Halfedge_index from, FG::Halfedge_index to)
{
  FG::Halfedge_index h = from;
  while(h != to && h != FG::null_index)
    h = t.counterclockwise(h);
  return h == to;
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_INTRINSIC_TRIANGULATION_INSERTED_VERTICES_H
