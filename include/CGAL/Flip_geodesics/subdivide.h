// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SUBDIVIDE_H
#define CGAL_FLIP_GEODESICS_SUBDIVIDE_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Surface_subdivision.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* Dissolves the pieces of intrinsic edges that no curve runs along, and what crossings they leave on input edges. */
template <class Triangulation, class Network>
void keep_curves_only(Overlay<Triangulation>& overlay, Overlay_layout<Triangulation>& layout, const Network& network)
{
  layout.forget_intrinsic_faces();
  for(Index e = 0; e < overlay.triangulation().number_of_edges(); ++e)
    if(!network.is_occupied(2 * e))
      for(Index i = 0; i <= overlay.crossings(e); ++i)
        if(overlay.input_halfedge(overlay.piece(2 * e, i)) == null_index)
          overlay.dissolve(overlay.piece(2 * e, i));
  for(Index h = 0; h < overlay.number_of_halfedges(); ++h)
    if(overlay.is_alive(h) && !overlay.is_border(h))
      while(overlay.is_crossing(overlay.target(h)) && overlay.has_two_edges_at_target(h)) {
        layout.join(h);
        overlay.join(h);
      }
}

template <class Triangulation>
void cut(Overlay<Triangulation>& overlay, Overlay_layout<Triangulation>& layout, Index h)
{
  if(overlay.is_border(h) || overlay.is_border(overlay.twin(h)))
    return;
  overlay.cut(h);
  layout.add_cut(overlay.twin(h));
}

template <class Triangulation>
std::vector<Index> same_vertices(const Overlay<Triangulation>& overlay)
{
  std::vector<Index> result(static_cast<std::size_t>(overlay.number_of_vertices()));
  std::iota(result.begin(), result.end(), 0);
  return result;
}

/* The input with the curves as edges, and cut open along them if that is wanted. */
template <class OutputMesh, class Network>
auto subdivide_along_curves(const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh,
                            bool is_cutting)
{
  using Triangulation = typename Network::Triangulation;
  Overlay<Triangulation> overlay(network.triangulation());
  Overlay_layout<Triangulation> layout(overlay);
  keep_curves_only(overlay, layout, network);
  Polygon_triangulator<Triangulation>(overlay, layout)();
  const auto is_on_curve = [&](Index h) { return h != null_index && network.is_occupied(h); };
  std::vector<Index> original;
  if(is_cutting) {
    const Index end = overlay.number_of_halfedges();
    for(Index h = 0; h < end; h += 2)
      if(overlay.is_alive(h) && is_on_curve(overlay.intrinsic_halfedge(h)))
        cut(overlay, layout, h);
    original = overlay.split_vertices();
  } else
    original = same_vertices(overlay);
  return Surface_subdivision<Triangulation, OutputMesh>(overlay, layout, original, mesh, is_on_curve);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * The common subdivision of the input mesh and an intrinsic triangulation: a triangle mesh in which the edges of both
 * are chains of edges, with maps back to both [SSC19, section 3.4.1], [GSC21]. What is linear in the faces of either is
 * linear in the faces of the subdivision, so that data can be carried from one to the other without loss.
 *
 * \param triangulation an `Intrinsic_triangulation` of `mesh`
 * \param mesh the input mesh
 * \return a `Surface_subdivision<Triangulation, OutputMesh>`; `OutputMesh` is the type of `mesh` if none is given first
 * \throws Invalid_mesh_error if the elements of the result are too many for 32-bit indices; and what is thrown when
 *         faces are first touched
 *
 * Complexity: linear in the faces of the mesh and the crossings of the two triangulations.
 */
template <class OutputMesh, class Triangulation>
Surface_subdivision<Triangulation, OutputMesh> common_subdivision(const Triangulation& triangulation,
                                                                  const typename Triangulation::Triangle_mesh& mesh)
{
  internal::Overlay<Triangulation> overlay(triangulation);
  internal::Overlay_layout<Triangulation> layout(overlay);
  internal::Polygon_triangulator<Triangulation>(overlay, layout)();
  return Surface_subdivision<Triangulation, OutputMesh>(overlay, layout, internal::same_vertices(overlay), mesh,
                                                        [](Index) { return false; });
}

/// \ingroup PkgFlipGeodesicsSubdivision
/// The same, with an output mesh of the input's type.
template <class Triangulation>
auto common_subdivision(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh)
{
  return common_subdivision<typename Triangulation::Triangle_mesh>(triangulation, mesh);
}

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * The input mesh with the curves of a network as chains of edges: faces that curves cross are split, all others stay.
 * `Surface_subdivision::edge_is_constrained_map()` marks the edges of the curves. Curves that run along one another
 * share edges.
 *
 * \param network an `Edge_path_network`, whose curves need not be finished
 * \param mesh the input mesh of its triangulation
 * \return as `common_subdivision()`
 * \throws as `common_subdivision()`
 */
template <class OutputMesh, class Network>
Surface_subdivision<typename Network::Triangulation, OutputMesh> insert_curves(
    const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh)
{
  return internal::subdivide_along_curves<OutputMesh>(network, mesh, false);
}

/// \ingroup PkgFlipGeodesicsSubdivision
/// The same, with an output mesh of the input's type.
template <class Network>
auto insert_curves(const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh)
{
  return insert_curves<typename Network::Triangulation::Triangle_mesh>(network, mesh);
}

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * The input mesh cut open along the curves of a network: as `insert_curves()`, but each edge of a curve is doubled, and
 * vertices are where that separates the faces around them. Both copies are marked as constrained. An open curve inside
 * the surface makes a slit, whose ends are single vertices; a closed one, or one from border to border, two borders.
 *
 * \param network, mesh as for `insert_curves()`
 * \return as `common_subdivision()`
 * \throws as `common_subdivision()`
 */
template <class OutputMesh, class Network>
Surface_subdivision<typename Network::Triangulation, OutputMesh> cut_along_curves(
    const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh)
{
  return internal::subdivide_along_curves<OutputMesh>(network, mesh, true);
}

/// \ingroup PkgFlipGeodesicsSubdivision
/// The same, with an output mesh of the input's type.
template <class Network>
auto cut_along_curves(const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh)
{
  return cut_along_curves<typename Network::Triangulation::Triangle_mesh>(network, mesh);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SUBDIVIDE_H
