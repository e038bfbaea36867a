// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_LOGARITHMIC_MAP_H
#define CGAL_FLIP_GEODESICS_LOGARITHMIC_MAP_H

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/shortest/Tree_straightness.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Vertex_directions.h>
#include <CGAL/Flip_geodesics/internal/triangulation/spokes.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTree
/// Where a vertex lies as seen from the source of a tree.
struct Polar_coordinates
{
  double radius = std::numeric_limits<double>::infinity(); ///< the length of the path; infinite if there is none
  double angle = std::numeric_limits<double>::quiet_NaN(); ///< in radians; NaN at the source, and without a path
};

/// \ingroup PkgFlipGeodesicsTree
/// The coordinates of all vertices, and what the angles add up to.
struct Logarithmic_map
{
  /// An array whose subscripts are vertices: `vertices[v]`.
  internal::Indexed_by<Vertex_index, std::vector<Polar_coordinates>> vertices;
  double total_angle = 0;    ///< the sum of the angles of the faces about the source, \f$2\pi\f$ where it is flat
  bool is_on_border = false; ///< does the source lie on the border?

  /*!
   * The coordinates of vertex `v` in the plane, with the angles about an inner source stretched evenly to \f$2\pi\f$,
   * as is usual; those about a source on the border stay. The origin for the source, NaN where there is no path.
   */
  std::array<double, 2> in_plane(Vertex_index v) const
  {
    const Polar_coordinates& p = vertices[v];
    if(p.radius == 0)
      return {0, 0};
    const double stretch = is_on_border ? 1 : boost::math::constants::two_pi<double>() / total_angle;
    return {p.radius * std::cos(stretch * p.angle), p.radius * std::sin(stretch * p.angle)};
  }
};

namespace internal {

/*
 * Calls function(v, direction) for the vertices to which the first edges of a tree's paths lead, with directions at the
 * source. They are measured all at once, as far as that is possible; not those in other umbrellas.
 */
template <class Tree, class Directions, class Function>
void measure_first_edges(const Tree& tree, const Directions& directions, const Function& function)
{
  const auto& triangulation = tree.triangulation();
  const Vertex_index source = tree.source();
  if(triangulation.outgoing(source) == null_index)
    return;
  using Straightness = Tree_straightness<Tree>;
  typename Straightness::Measured_legs measured(static_cast<std::size_t>(triangulation.number_of_vertices()));
  const std::vector<Halfedge_index> around = triangulation.is_inserted(source)
                                                 ? spokes(triangulation, source)
                                                 : spokes_beside(triangulation, triangulation.input().outgoing(source));
  Straightness straightness(tree, measured);
  for(const Fan_leg& leg : straightness.legs(around, Edge_end()))
    function(leg.head, leg.is_found ? directions.of_input(leg.reference()) + leg.start.direction.angle
                                    : directions(leg.start.halfedge));
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * The logarithmic map of a tree's source [SC20, section 6.5]: for each vertex the length of its path, and the direction
 * in which the path starts. The directions are angles in the surface, counterclockwise from an input edge, in
 * \f$[0, \mathtt{total\_angle})\f$; measured from the input's coordinates, so that errors do not add up over flips.
 *
 * Where paths pass a vertex with more than \f$2\pi\f$, all vertices in its shadow have the angle of that path. So the
 * map is continuous but for the places that shortest paths reach from two sides, the cut locus. It also tears at paths
 * of the tree that are not shortest, which `make_shortest()` replaces.
 *
 * Linear in the reached vertices and in the crossings of the edges at the source; and \f$O(n)\f$ for the result.
 *
 * \param tree a tree that has been grown
 * \param zero the input halfedge whose direction is 0; it starts at the source. By default that of the input's first
 *        halfedge of the vertex. It is ignored on the border, where the angles start at the border. So it is at an
 *        inserted vertex, where they start at the direction of its `location()`'s halfedge.
 * \throws Invalid_location_error if `zero` is another halfedge
 */
template <class Triangulation>
Logarithmic_map logarithmic_map(const Geodesic_tree<Triangulation>& tree, Input_halfedge_index zero = null_index)
{
  const Triangulation& triangulation = tree.triangulation();
  CGAL_precondition(tree.source() != null_index);
  const bool is_zero_told = zero != null_index && !triangulation.is_inserted(tree.source());
  if(is_zero_told && (!zero.is_valid() || zero.idx() >= triangulation.input().number_of_halfedges() ||
                      triangulation.input().tail(zero) != tree.source()))
    throw Invalid_location_error("the halfedge of angle zero does not start at the source of the tree, vertex " +
                                 std::to_string(tree.source().idx()));
  const internal::Vertex_directions<Triangulation> directions(triangulation, tree.source());
  Logarithmic_map map;
  map.vertices.resize(static_cast<std::size_t>(triangulation.number_of_vertices()));
  map.vertices[tree.source()].radius = 0;
  map.total_angle = directions.total();
  map.is_on_border = directions.has_border();
  const double start = is_zero_told && !map.is_on_border ? directions.of_input(zero) : 0;

  const auto set_angle = [&](Vertex_index v, double direction) {
    const double angle = direction - start;
    map.vertices[v].angle = angle + (!map.is_on_border && angle < 0 ? map.total_angle : 0);
  };
  internal::measure_first_edges(tree, directions, set_angle);

  std::vector<Vertex_index> way; // from a vertex back to one whose angle is known
  for(Vertex_index v : internal::descriptors<Vertex_index>(triangulation.number_of_vertices())) {
    if(!tree.is_reached(v) || v == tree.source())
      continue;
    map.vertices[v].radius = tree.distance(v);
    way.clear();
    for(Vertex_index w = v; w != tree.source() && std::isnan(map.vertices[w].angle);
        w = triangulation.tail(tree.incoming(w)))
      way.push_back(w);
    for(std::size_t i = way.size(); i-- > 0;) {
      const Halfedge_index h = tree.incoming(way[i]);
      if(triangulation.tail(h) == tree.source())
        set_angle(way[i], directions(h));
      else
        map.vertices[way[i]].angle = map.vertices[triangulation.tail(h)].angle;
    }
  }
  return map;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_LOGARITHMIC_MAP_H
