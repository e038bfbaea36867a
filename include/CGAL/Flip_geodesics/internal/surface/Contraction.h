// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTRACTION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTRACTION_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <map>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/*
 * A mesh with its edges of length zero contracted: what the halfedges of the input have become, and how those that are
 * left hang together. Vertices keep their numbers; those that are merged into another one are isolated.
 */
struct Contraction
{
  /* What becomes of a halfedge that is no more: its ends are one vertex; no face with an area is left beside it; or it
   * leads along two others. */
  static constexpr Input_halfedge_index is_point{-1}, is_hair{-2}, is_fold{-3};

  /* The two halfedges of the input that another one leads along, and how far from its tail they meet. */
  struct Fold
  {
    Input_halfedge_index first, second;
    double share;
  };

  using Halfedges = Indexed_by<Input_halfedge_index, std::vector<Input_halfedge_index>>;

  Indexed_by<Vertex_index, std::vector<Vertex_index>> vertex; // of each vertex of the input, the one that it is now
  Halfedges halfedge;                                         // of each halfedge of the input
  Halfedges input_halfedge; // of each halfedge that is left, one of the input's that it was
  Halfedges next;
  Indexed_by<Input_halfedge_index, std::vector<Vertex_index>> tail;
  Indexed_by<Input_halfedge_index, std::vector<char>> is_border;
  Indexed_by<Vertex_index, std::vector<Input_halfedge_index>> outgoing; // none if isolated
  std::map<Input_halfedge_index, Fold> folds;                           // of halfedges of the input
  bool has_split_point = false; // do sheets of the surface that only met in a point have vertices of their own there?
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTRACTION_H
