// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_HANDLE_AND_TUNNEL_LOOPS_H
#define CGAL_FLIP_GEODESICS_HANDLE_AND_TUNNEL_LOOPS_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Solid_loops.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <iterator>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsLoops
/// What `handle_and_tunnel_loops()` finds. Each loop is a closed chain of halfedges, for
/// `Edge_path_network::add_curve()` as long as no edge is flipped.
struct Handle_and_tunnel_loops
{
  std::vector<std::vector<Halfedge_index>> handles; ///< loops that bound a surface inside of the solid
  std::vector<std::vector<Halfedge_index>> tunnels; ///< loops that bound a surface outside of it
};

namespace internal {

template <class Triangulation>
Handle_and_tunnel_loops handle_and_tunnel_loops(const Triangulation& triangulation, Interruption* interruption)
{
  static_assert(Has_points<typename Triangulation::Metric>::value,
                "handles and tunnels are those of a surface in space: the metric has no points");
  const Solid_loops<Triangulation> loops(triangulation, interruption);
  return {loops.inside(), loops.outside()};
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * A basis of the closed curves of a surface that bounds a solid, of handle loops and of tunnel loops [DFW13]. A handle
 * loop is the border of a surface inside of the solid, as the meridian of a torus is, and a tunnel loop that of a surface
 * outside of it. Each component of genus g has g loops of either kind, which are treated as if no other component were
 * there. All of them together are a basis of its homology, with integers.
 *
 * Which classes bound inside and outside is decided exactly, by linking numbers of loops that are pushed off the surface
 * and counted in a projection. Of the loops that a tree of shortest paths and an edge close, from a base point and from
 * places near each handle, the shortest are taken that bound, and that belong to a basis together with those taken
 * before. Where they are not enough, as on a tube that is knotted, others are put together of several loops of a
 * `Loop_basis`. These may pass edges more than once, and cross themselves.
 *
 * The places are those that the numbering of the mesh gives. The same mesh, numbered otherwise, can have other loops,
 * some percent shorter or longer.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`, whose metric has points. Its input is read
 * \param np named parameters: `visitor`, a model of `FlipOutVisitor`, of which only `go_further()` is called, at
 *        regular intervals. If it returns `false`, then the result has no loops
 * \pre the surface does not cross or touch itself. Where that is noticed, it is an error
 * \throws Invalid_mesh_error if the mesh is no closed surface of triangles, or is seen to cross itself
 * \throws Degenerate_face_error if faces without area are in the way
 * \throws Invalid_coordinate_error
 *
 * Complexity: \f$O(n \log n)\f$, and the cube of the genus times the size of the numbers. For loops of \f$m\f$ edges, up
 * to \f$m^2\f$ pairs that are near in the projection.
 */
template <class Triangulation, class... NamedParameters>
Handle_and_tunnel_loops handle_and_tunnel_loops(const Triangulation& triangulation, const NamedParameters&... np)
{
  return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...), [&](auto* interruption) {
    return internal::handle_and_tunnel_loops(triangulation, interruption);
  });
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_HANDLE_AND_TUNNEL_LOOPS_H
