// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_NUMBERED_MESH_H
#define CGAL_FLIP_GEODESICS_NUMBERED_MESH_H

#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * A mesh seen by consecutive numbers: what a triangulation has as its input, and what metrics are asked about. It is a
 * class, and no concept, since a metric and all triangulations with it must mean the same elements by the same numbers.
 *
 * Made from a mesh, which must outlive it; copyable. Vertices have the numbers of their order in `vertices(mesh)`. The
 * two halfedges of the edge with number `e` in `edges(mesh)` have `2e` and `2e+1`. All members are const:
 *
 * | Member | |
 * |---|---|
 * | `Index number_of_vertices()`, `Index number_of_halfedges()` | |
 * | `Vertex_index index(v)`, `Input_halfedge_index index(h)` | of a descriptor; `null_index` if it is none of the mesh's |
 * | `vertex(Vertex_index v)`, `halfedge(Input_halfedge_index h)` | the mesh's own descriptors |
 * | `Input_halfedge_index twin(h)` | the other side of the edge; static |
 * | `Input_halfedge_index next(h)`, `previous(h)` | around the face, or the border |
 * | `Vertex_index tail(h)` | the vertex at which `h` starts |
 * | `bool is_border(h)` | has `h` no face on its left? |
 * | `bool is_triangle(h)` | have the face on the left of `h` three sides? |
 * | `Input_halfedge_index outgoing(v)` | a halfedge that starts at `v`, `null_index` at an isolated vertex |
 * | `bool is_contracted()` | were edges of length zero contracted, see `Zero_length_edges`? |
 * | `const Numbered_mesh& uncontracted()` | the mesh before, or itself |
 *
 * So a number that a result holds leads back to the mesh. Of the `Input_halfedge_index h` of a place or a face,
 * `triangulation.input().halfedge(h)` is the mesh's halfedge, and `face(triangulation.input().halfedge(h), mesh)` its
 * face.
 *
 * Constant time each, but `index()`, which takes logarithmic time unless the mesh is a `Surface_mesh`. Construction is
 * \f$O(n \log n)\f$, but for a `Surface_mesh`, which is numbered already and not copied.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 */
template <class TriangleMesh>
using Numbered_mesh = internal::Indexed_mesh<TriangleMesh>;

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_NUMBERED_MESH_H
