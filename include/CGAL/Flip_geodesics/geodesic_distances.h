// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_DISTANCES_H
#define CGAL_FLIP_GEODESICS_GEODESIC_DISTANCES_H

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/geodesic_curves.h>
#include <CGAL/Flip_geodesics/internal/base/mistakes.h>
#include <CGAL/Flip_geodesics/internal/one_call/Curve_types.h>
#include <CGAL/Flip_geodesics/logarithmic_map.h>
#include <CGAL/Flip_geodesics/make_shortest.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <limits>

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

/*!
 * \ingroup PkgFlipGeodesicsDistances
 *
 * Writes the distances of a field at the vertices of a mesh into a property map; infinity where they are not known.
 *
 * \param field a field that has been computed
 * \param triangulation its triangulation
 * \param mesh its mesh
 * \param distances a model of `WritablePropertyMap` with the mesh's vertices as keys and `double`s as values
 *
 * Complexity: linear in the vertices of the mesh.
 */
template <class Triangulation, class VertexDistanceMap>
void write_distances(const Geodesic_distance_field<Triangulation>& field, const Triangulation& triangulation,
                     const typename Triangulation::Triangle_mesh& mesh, VertexDistanceMap distances)
{
  for(const auto v : vertices(mesh))
    put(distances, v, field.distance(triangulation.input().index(v)));
}

/// \ingroup PkgFlipGeodesicsDistances
/// The same for the numbers of the nearest sources; 0 where none is known.
template <class Triangulation, class VertexSourceMap>
void write_nearest_sources(const Geodesic_distance_field<Triangulation>& field, const Triangulation& triangulation,
                           const typename Triangulation::Triangle_mesh& mesh, VertexSourceMap sources)
{
  for(const auto v : vertices(mesh))
    put(sources, v, field.answer(triangulation.input().index(v)).source);
}

namespace internal {

/* Calls `write(tree)` with the tree of shortest paths from a vertex. */
template <class Triangulation, class Write>
Shortest_tree_report make_shortest_tree(Triangulation& triangulation, Vertex_index source, const Window_limit& limit,
                                        const Write& write)
{
  Geodesic_tree<Triangulation> tree(triangulation);
  tree.grow(source);
  const Shortest_tree_report report = make_shortest(tree, limit);
  write(tree);
  return report;
}

} // namespace internal

namespace internal {

/* Writes the distances of a field from one vertex. Returns false, and writes nothing, if it is given up or unsure. */
template <class Triangulation, class VertexDistanceMap>
bool write_field_distances(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                           Vertex_index source, VertexDistanceMap distances, const Window_limit& limit,
                           Shortest_tree_report& report)
{
  Geodesic_distance_field<Triangulation> field(triangulation, mesh, Distance_field_extent::VERTICES_ONLY);
  field.add_source(source);
  Distance_field_limits limits;
  limits.windows = limit;
  const Distance_field_report computed = field.compute(limits);
  if(computed.status != Distance_field_status::COMPLETE || computed.has_flat_face)
    return false;
  report.windows = computed.windows;
  report.is_confirmed = true;
  const auto n = triangulation.input().number_of_vertices();
  for(Vertex_index v : descriptors<Vertex_index>(n))
    report.vertices += v != source && field.distance(v) < std::numeric_limits<double>::infinity() ? 1 : 0;
  write_distances(field, triangulation, mesh, distances);
  return true;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Computes the distances on the surface from one vertex to all others, by a `Geodesic_distance_field`. Where that is given
 * up, or meets a face so flat that it is unsure, a tree of geodesics is grown (`Geodesic_tree::grow()`), and those
 * that are not shortest are replaced as far as shorter ones are found (`make_shortest()`).
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
 * Complexity: that of `Geodesic_distance_field::compute()`, and where a tree is grown that of `make_shortest()`.
 */
template <class TriangleMesh, class VertexDistanceMap, class NamedParameters = parameters::Default_named_parameters>
Shortest_tree_report geodesic_distances(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                        VertexDistanceMap distances, const Window_limit& limit,
                                        const NamedParameters& np = parameters::default_values())
{
  using Triangulation = typename internal::Curve_types<TriangleMesh, NamedParameters>::Triangulation;
  return internal::compute_on_surface(mesh, np, [&](Triangulation& triangulation) {
    Shortest_tree_report report;
    if(internal::write_field_distances(triangulation, mesh, triangulation.index(source), distances, limit, report))
      return report;
    return internal::make_shortest_tree(triangulation, triangulation.index(source), limit,
                                        [&](const auto& tree) { write_distances(tree, mesh, distances); });
  });
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
  using Triangulation = typename internal::Curve_types<TriangleMesh, NamedParameters>::Triangulation;
  return internal::compute_on_surface(mesh, np, [&](Triangulation& triangulation) {
    return internal::make_shortest_tree(triangulation, triangulation.index(source), limit, [&](const auto& tree) {
      write_polar_coordinates(logarithmic_map(tree), tree, mesh, coordinates);
    });
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
