// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_DISTANCES_H
#define CGAL_FLIP_GEODESICS_GEODESIC_DISTANCES_H

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/geodesic_curves.h>
#include <CGAL/Flip_geodesics/internal/base/mistakes.h>
#include <CGAL/Flip_geodesics/internal/one_call/Curve_types.h>
#include <CGAL/Flip_geodesics/logarithmic_map.h>
#include <CGAL/Flip_geodesics/make_shortest.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Writes the lengths of a tree's paths into a property map of the mesh; infinity for vertices without a path.
 *
 * \param tree a tree that has been grown
 * \param mesh its mesh
 * \param distances a model of `WritablePropertyMap` with the mesh's vertices as keys and `double`s as values
 *
 * Complexity: linear in the vertices of the mesh.
 */
template <class Triangulation, class VertexDistanceMap>
void write_distances(const Geodesic_tree<Triangulation>& tree, const typename Triangulation::Triangle_mesh& mesh,
                     VertexDistanceMap distances)
{
  static_assert(internal::is_property_map<VertexDistanceMap>());
  for(const auto v : vertices(mesh))
    put(distances, v, tree.distance(tree.triangulation().input().index(v)));
}

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Writes the polar coordinates of the vertices about a tree's source, as `logarithmic_map()` has them, into a property
 * map of the mesh.
 *
 * \param map what `logarithmic_map(tree)` gives
 * \param tree the tree
 * \param mesh its mesh
 * \param coordinates a model of `WritablePropertyMap` with the mesh's vertices as keys and `Polar_coordinates` as
 * values
 *
 * Complexity: linear in the vertices of the mesh.
 */
template <class Triangulation, class VertexPolarMap>
void write_polar_coordinates(const Logarithmic_map& map, const Geodesic_tree<Triangulation>& tree,
                             const typename Triangulation::Triangle_mesh& mesh, VertexPolarMap coordinates)
{
  static_assert(internal::is_property_map<VertexPolarMap>());
  for(const auto v : vertices(mesh))
    put(coordinates, v, map.vertices[tree.triangulation().input().index(v)]);
}

namespace internal {

/* Calls `write(tree)` with the tree of shortest paths from a vertex of a mesh. */
template <class TriangleMesh, class Vertex, class NamedParameters, class Write>
Shortest_tree_report with_shortest_tree(const TriangleMesh& mesh, Vertex source, const Window_limit& limit,
                                        const NamedParameters& np, const Write& write)
{
  using Triangulation = typename Curve_types<TriangleMesh, NamedParameters>::Triangulation;
  return compute_on_surface(mesh, np, [&](Triangulation& triangulation) {
    Geodesic_tree<Triangulation> tree(triangulation);
    tree.grow(triangulation.index(source));
    const Shortest_tree_report report = make_shortest(tree, limit);
    write(tree);
    return report;
  });
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Computes the distances on the surface from one vertex to all others: a tree of geodesics is grown
 * (`Geodesic_tree::grow()`), and those that are not shortest are replaced (`make_shortest()`).
 *
 * \param mesh a triangle mesh
 * \param source a vertex of the mesh
 * \param distances a model of `WritablePropertyMap` with the mesh's vertices as keys and `double`s as values; receives
 *        infinity for vertices of other components
 * \param limit beyond it the search is given up, and the distances are those of the geodesics of the tree
 * \param np named parameters: `vertex_point_map`, `with_metric()`, `geom_traits`
 * \return how many distances are those of shortest paths, and whether that is sure
 * \throws Vertex_out_of_range_error, Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
 *
 * Complexity: that of `make_shortest()`.
 */
template <class TriangleMesh, class VertexDistanceMap, class NamedParameters = parameters::Default_named_parameters>
Shortest_tree_report geodesic_distances(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                        VertexDistanceMap distances, const Window_limit& limit,
                                        const NamedParameters& np = parameters::default_values())
{
  return internal::with_shortest_tree(mesh, source, limit, np,
                                      [&](const auto& tree) { write_distances(tree, mesh, distances); });
}

/// \ingroup PkgFlipGeodesicsTree
/// The same with the default limit.
template <class TriangleMesh, class VertexDistanceMap, class NamedParameters = parameters::Default_named_parameters>
Shortest_tree_report geodesic_distances(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                        VertexDistanceMap distances,
                                        const NamedParameters& np = parameters::default_values())
{
  return Flip_geodesics::geodesic_distances(mesh, source, distances, Window_limit(), np);
}

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Computes the logarithmic map of a vertex: for all others how long the shortest path is, and in which direction it
 * starts.
 *
 * \param mesh a triangle mesh
 * \param source a vertex of the mesh
 * \param coordinates a model of `WritablePropertyMap` with the mesh's vertices as keys and `Polar_coordinates` as
 *        values
 * \param limit, np as for `geodesic_distances()`
 * \return how many paths are shortest, and whether that is sure
 * \throws as `geodesic_distances()`
 *
 * Complexity: that of `make_shortest()`.
 */
template <class TriangleMesh, class VertexPolarMap, class NamedParameters = parameters::Default_named_parameters>
Shortest_tree_report polar_coordinates(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                       VertexPolarMap coordinates, const Window_limit& limit,
                                       const NamedParameters& np = parameters::default_values())
{
  return internal::with_shortest_tree(mesh, source, limit, np, [&](const auto& tree) {
    write_polar_coordinates(logarithmic_map(tree), tree, mesh, coordinates);
  });
}

/// \ingroup PkgFlipGeodesicsTree
/// The same with the default limit.
template <class TriangleMesh, class VertexPolarMap, class NamedParameters = parameters::Default_named_parameters>
Shortest_tree_report polar_coordinates(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                       VertexPolarMap coordinates,
                                       const NamedParameters& np = parameters::default_values())
{
  return Flip_geodesics::polar_coordinates(mesh, source, coordinates, Window_limit(), np);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_DISTANCES_H
