// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_NETWORKS_FROM_DATA_H
#define CGAL_FLIP_GEODESICS_NETWORKS_FROM_DATA_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/graph_functions.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsBuilders
/// What becomes of the vertices where more than two regions, or the border, meet.
enum class Junctions {
  FIXED, ///< they stay, and every curve ends there
  FREE   ///< they move: every region has closed curves of its own about it, beside those of its neighbors
};

namespace internal {

/* A set of edges as a property map, by index. */
template <class TriangleMesh, class Triangulation>
struct Marked_edge_map
{
  using key_type = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  const TriangleMesh* mesh;
  const Triangulation* triangulation;
  const Indexed_by<Edge_index, std::vector<char>>* is_marked;

  friend bool get(const Marked_edge_map& map, const key_type& e)
  {
    const Input_halfedge_index h = map.triangulation->input().index(halfedge(e, *map.mesh));
    return (*map.is_marked)[Triangulation::edge(as_intrinsic(h))] != 0;
  }
};

/* Adds the network of the inner edges for which `is_marked(h, t)` holds for their two halfedges. */
template <class Network, class TriangleMesh, class Predicate>
Index add_edges_between_faces(Network& network, const TriangleMesh& mesh, const Predicate& is_marked)
{
  using Triangulation = typename Network::Triangulation;
  const Triangulation& triangulation = network.triangulation();
  const auto& input = triangulation.input();
  internal::Indexed_by<Edge_index, std::vector<char>> marks(static_cast<std::size_t>(triangulation.number_of_edges()),
                                                            0);
  for(Edge_index e : internal::descriptors<Edge_index>(triangulation.number_of_edges())) {
    const Halfedge_index h = first_side(e), t = Triangulation::twin(h);
    const bool is_inner = !triangulation.is_border(h) && !triangulation.is_border(t);
    marks[e] = is_inner && is_marked(input.halfedge(internal::as_input(h)), input.halfedge(internal::as_input(t)));
  }
  return add_marked_edges(network, mesh, Marked_edge_map<TriangleMesh, Triangulation>{&mesh, &triangulation, &marks});
}

/*
 * The boundaries of regions with each region on the left, as chains of halfedges: closed, or from border to border.
 * `region(h)` is the region of the face on the left of halfedge h.
 */
template <class Triangulation, class Region>
class Region_boundaries
{
public:
  Region_boundaries(const Triangulation& triangulation, const Region& region)
    : m_triangulation(triangulation)
    , m_region(region)
    , m_is_used(static_cast<std::size_t>(triangulation.number_of_halfedges()), 0)
  {
  }

  /* Calls `use(chain, is_closed)` for each: first those from border to border, then the closed ones. */
  template <class Function>
  void for_each(const Function& use)
  {
    for(Halfedge_index h : internal::descriptors<Halfedge_index>(m_triangulation.number_of_halfedges()))
      if(is_boundary(h) && is_start(h))
        use(chain_from(h), false);
    for(Halfedge_index h : internal::descriptors<Halfedge_index>(m_triangulation.number_of_halfedges()))
      if(is_boundary(h) && m_is_used[h] == 0)
        use(chain_from(h), true);
  }

private:
  bool is_boundary(Halfedge_index h) const
  {
    const Halfedge_index t = Triangulation::twin(h);
    return !m_triangulation.is_border(h) && !m_triangulation.is_border(t) && m_region(h) != m_region(t);
  }

  // The next halfedge of the boundary, about its head through faces of the region; null_index at the border.
  Halfedge_index next(Halfedge_index h) const
  {
    Halfedge_index g = m_triangulation.next(h);
    while(!is_boundary(g)) {
      if(m_triangulation.is_border(Triangulation::twin(g)))
        return null_index;
      g = m_triangulation.next(Triangulation::twin(g));
    }
    return g;
  }

  // Does the boundary come from the border here?
  bool is_start(Halfedge_index h) const
  {
    Halfedge_index g = Triangulation::twin(m_triangulation.previous(h));
    while(!m_triangulation.is_border(g) && !is_boundary(Triangulation::twin(g)))
      g = Triangulation::twin(m_triangulation.previous(g));
    return m_triangulation.is_border(g);
  }

  std::vector<Halfedge_index> chain_from(Halfedge_index h)
  {
    std::vector<Halfedge_index> chain;
    for(; h != null_index && m_is_used[h] == 0; h = next(h)) {
      m_is_used[h] = 1;
      chain.push_back(h);
    }
    return chain;
  }

  const Triangulation& m_triangulation;
  const Region& m_region;
  Indexed_by<Halfedge_index, std::vector<char>> m_is_used;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds the edges between faces of different regions as a network: the boundaries of a segmentation [SC20, section 6.1].
 * The border of the mesh is no boundary of a region, but boundaries can end there.
 *
 * With fixed junctions, there is one curve between each two vertices where other than two such edges meet. Where there
 * is no such vertex, it is closed, as by `add_marked_edges()`. With free junctions, each edge carries two strands, one
 * for each region, that region on the left: closed curves, and paths from border to border. Then junctions move.
 * Between the curves of three regions that have met at one vertex, a gap opens, which belongs to none of them. Regions
 * still do not overlap, and every curve keeps its isotopy class among the others.
 *
 * If it throws, or `regions` does, the network is empty again. Linear in the mesh.
 *
 * \param network an empty network in a triangulation whose edges are the input's
 * \param mesh the triangulation's mesh
 * \param regions a model of `ReadablePropertyMap` with the mesh's faces as keys, and values to be compared by `!=`
 * \return the number of curves added
 */
template <class Network, class TriangleMesh, class FaceRegionMap>
Index add_region_boundaries(Network& network, const TriangleMesh& mesh, FaceRegionMap regions,
                            Junctions junctions = Junctions::FIXED)
{
  static_assert(internal::is_property_map<FaceRegionMap>());
  using Triangulation = typename Network::Triangulation;
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  if(junctions == Junctions::FIXED)
    return internal::add_edges_between_faces(network, mesh, [&](Halfedge h, Halfedge t) {
      return get(regions, internal::graph_face(h, mesh)) != get(regions, internal::graph_face(t, mesh));
    });

  const Triangulation& triangulation = network.triangulation();
  const auto region = [&](Halfedge_index h) {
    return get(regions, internal::graph_face(triangulation.input().halfedge(internal::as_input(h)), mesh));
  };
  internal::Region_boundaries<Triangulation, decltype(region)> boundaries(triangulation, region);
  return internal::add_all_or_none(network, [&] {
    boundaries.for_each(
        [&](const std::vector<Halfedge_index>& chain, bool is_closed) { network.add_curve(chain, is_closed); });
    for(Edge_index e : internal::descriptors<Edge_index>(triangulation.number_of_edges()))
    { // each strand on the side of its region
      std::vector<Segment_index> stack = network.stack(e);
      if(stack.size() == 2 && network.halfedge(stack.front()) != internal::first_side(e)) {
        std::swap(stack.front(), stack.back());
        network.set_stack(e, stack);
      }
    }
  });
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds the seams of a texture as a network: the edges at whose ends the two faces have different texture coordinates,
 * at one end or both. Curves end where other than two seams meet, and so do those that end inside the surface or on its
 * border, which is no seam. If it throws, or `texture` does, the network is empty again. Linear in the mesh.
 *
 * \param network an empty network in a triangulation whose edges are the input's
 * \param mesh the triangulation's mesh
 * \param texture a model of `ReadablePropertyMap` with the mesh's halfedges as keys, and as values the texture
 *        coordinates of a halfedge's face at its target, to be compared by `!=`
 * \return the number of curves added
 */
template <class Network, class TriangleMesh, class HalfedgeTextureMap>
Index add_seams(Network& network, const TriangleMesh& mesh, HalfedgeTextureMap texture)
{
  static_assert(internal::is_property_map<HalfedgeTextureMap>());
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  return internal::add_edges_between_faces(network, mesh, [&](Halfedge h, Halfedge t) {
    const auto at_source = [&](Halfedge g) {
      const Halfedge second = internal::graph_next(g, mesh);
      return get(texture, internal::graph_next(second, mesh));
    };
    return get(texture, h) != at_source(t) || get(texture, t) != at_source(h);
  });
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Completes a polyline of which points in a row need not lie in a common face, such as positions of a pen: where they
 * do not, a geodesic between them is put in, as the points where it crosses edges.
 *
 * \return the polyline, for `draw_polyline()` and `snap_polyline()`
 * \pre no edge of the triangulation has been flipped; it is the same afterwards
 * \throws Occupied_triangulation_error if there are curves in it, and a geodesic is needed
 * \throws Invalid_curve_error if there are fewer than two points, or three of a closed polyline
 * \throws Disconnected_endpoints_error, and as `draw_polyline()`, `shorten()`
 */
template <class Triangulation>
std::vector<Surface_location> complete_polyline(Triangulation& triangulation,
                                                const std::vector<Surface_location>& polyline, bool is_closed = false)
{
  const auto& input = triangulation.input();
  if(polyline.size() < (is_closed ? 3u : 2u))
    throw Invalid_curve_error("a polyline needs two points, a closed one three");
  std::vector<Surface_location> result;
  for(std::size_t i = 0; i < polyline.size(); ++i) {
    const Surface_location p = internal::canonical_location(input, polyline[i]);
    result.push_back(p);
    if(i + 1 == polyline.size() && !is_closed)
      break;
    const Surface_location q = internal::canonical_location(input, polyline[(i + 1) % polyline.size()]);
    if(internal::common_face(input, p, q) != null_index)
      continue;
    auto between = internal::Path_straightener<Triangulation>(triangulation).shortest(p, q);
    for(Surface_location& crossing : between)
      for(double& weight : crossing.weights)
        weight = weight < internal::zero_weight ? 0 : weight; // as close to a vertex as that, it is inserted there
    result.insert(result.end(), between.begin() + 1, between.end() - 1);
  }
  return result;
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Draws a polyline that runs anywhere on the mesh into a network, by making its points vertices [SC20, Figure 9]: a
 * curve whose nodes are fixed at all its points. Its segments become edges of the triangulation, for which edges in
 * their input faces are flipped; a segment that passes a vertex consists of several edges. So the curve is the polyline
 * itself. `Edge_path_network::free_nodes()` allows it to be shortened.
 *
 * Which edges a segment crosses is decided exactly, by the weights of the points. Polylines may be drawn one after
 * another. They may meet at vertices and overlap; `order_overlapping_curves()` then detects whether they cross there.
 * Segments that cross elsewhere cannot be edges of one triangulation, and are refused.
 *
 * \param polyline the points; each two in a row lie in a common face or on a common edge of the input. A closed polyline
 *        does not repeat the first. Points that repeat the one before are skipped.
 * \return the curve's index
 * \pre no edge of the triangulation in these faces crosses an input edge
 * \throws Invalid_curve_error if two points in a row are in no common face, or there are too few
 * \throws Crossing_curves_error if a segment crosses another one, or a curve of the network, between vertices;
 *         `elements()` are the ends of the edge that is crossed. No curve is added then, but points of the polyline may
 *         have become vertices
 * \throws Invalid_location_error, and as `Edge_path_network::insert()`
 */
template <class Network>
Curve_index draw_polyline(Network& network, const std::vector<Surface_location>& polyline, bool is_closed = false)
{
  const auto points = internal::canonical_polyline(network.triangulation().input(), polyline, is_closed);
  return internal::add_chain(network, internal::Polyline_drawer<Network>(network)(points), is_closed);
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The vertices of a path of input edges in the isotopy class of a polyline: each point on an edge moves to its nearer
 * end, and so do the ends of an open polyline. No vertex is added, and the path ends at vertices of the mesh.
 *
 * \param polyline as for `draw_polyline()`
 * \return the vertices of the path, for `halfedges_through()`; fewer than two if the polyline shrinks to a vertex. A
 *         closed path does not repeat the first.
 * \throws Invalid_curve_error, Invalid_location_error as `draw_polyline()`
 */
template <class Triangulation>
std::vector<Vertex_index> snap_polyline(const Triangulation& triangulation,
                                        const std::vector<Surface_location>& polyline, bool is_closed = false)
{
  const auto& input = triangulation.input();
  const auto points = internal::canonical_polyline(input, polyline, is_closed);
  std::vector<Vertex_index> path;
  for(std::size_t i = 0; i + (is_closed ? 1 : 0) < points.size(); ++i) {
    const Surface_location& p = points[i];
    const bool is_end = !is_closed && (i == 0 || i + 1 == points.size());
    if(kind(p) == Location_kind::FACE && !is_end)
      continue; // the path crosses the face from one of its vertices to another
    const Vertex_index v = internal::nearest_vertex(input, p);
    if(!path.empty() && path.back() == v)
      continue;
    if(path.size() > 1 && path[path.size() - 2] == v)
      path.pop_back(); // to and fro
    else
      path.push_back(v);
  }
  while(is_closed && path.size() > 1 && path.front() == path.back())
    path.pop_back();
  return path;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_NETWORKS_FROM_DATA_H
