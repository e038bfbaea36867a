// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_NETWORKS_FROM_DATA_H
#define CGAL_FLIP_GEODESICS_NETWORKS_FROM_DATA_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsBuilders
/// Specifies the treatment of junctions, the vertices at which more than two regions meet.
enum class Junctions {
  FIXED, ///< junctions are fixed, and curves end at them
  FREE   ///< junctions can move; each region has its own curves, beside those of its neighbors
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
 * The boundaries of regions with each region on the left, as chains of halfedges that are closed or lead from border to
 * border. `region(h)` is the region of the face on the left of halfedge h.
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

  /*
   * Calls `use(chain, is_closed)` for each boundary: first for those from border to border, then for the closed ones.
   */
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

  // Returns the next halfedge of the boundary, around its head through faces of the region, or null_index at the
  // border.
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

  // Returns whether the boundary starts at the border here.
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
 * Adds curves along the edges between faces of different regions, that is, along the boundaries of a segmentation
 * \cgalCite{SC20,section 6.1}. The border of the mesh is not a boundary of a region, but the boundaries of regions can
 * end at the border.
 *
 * With fixed junctions, curves end at the vertices that are incident to exactly one edge between regions or to more
 * than two such edges, as with `add_marked_edges()`. A curve without such a vertex is closed.
 *
 * With free junctions, each edge between two regions carries two segments, one for each region. The segments of a
 * region have the region on their left; they form closed curves, and paths from border to border. When the network is
 * shortened, the junctions can move. A gap that does not belong to any region can then open between the curves of
 * regions that met at one vertex. The regions still do not overlap, and every curve keeps its isotopy class relative to
 * the other curves.
 *
 * If an exception is thrown, the network remains empty.
 *
 * \param network an empty network in a triangulation whose edges are those of the input
 * \param mesh the mesh of the triangulation
 * \param regions a model of `ReadablePropertyMap` with the faces of the mesh as keys, and values that can be compared
 *        by `!=`
 * \param junctions the treatment of junctions
 * \return the number of curves added
 *
 * Complexity: linear in the size of the mesh.
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
    boundaries.for_each([&](const std::vector<Halfedge_index>& chain, bool is_closed) {
      network.add_curve(chain, parameters::is_closed(is_closed));
    });
    for(Edge_index e : internal::descriptors<Edge_index>(triangulation.number_of_edges()))
    { // each segment on the side of its region
      std::vector<Segment_index> bundle = network.bundle(e);
      if(bundle.size() == 2 && network.halfedge(bundle.front()) != internal::first_side(e)) {
        std::swap(bundle.front(), bundle.back());
        network.set_bundle(e, bundle);
      }
    }
  });
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds curves along the seams of a texture. A seam is an edge whose two faces have different texture coordinates at one
 * or both ends of the edge.
 *
 * Curves end at the vertices that are incident to exactly one seam or to more than two seams. Border edges are not
 * seams.
 *
 * If an exception is thrown, the network remains empty.
 *
 * \param network an empty network in a triangulation whose edges are those of the input
 * \param mesh the mesh of the triangulation
 * \param texture a model of `ReadablePropertyMap` with the halfedges of the mesh as keys, and values that can be
 *        compared by `!=`. The value of a halfedge contains the texture coordinates of the corner of its face at its
 *        target
 * \return the number of curves added
 *
 * Complexity: linear in the size of the mesh.
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
 * Completes a polyline whose consecutive points need not lie in a common face, such as the recorded positions of a pen.
 * Two consecutive points without a common face are connected by a geodesic, and the points at which this geodesic
 * crosses edges are inserted into the polyline.
 *
 * \param triangulation the triangulation, which is unchanged afterwards
 * \param polyline a range of points of the surface, of any type that `surface_location()` accepts
 * \param np the named parameter `is_closed`, a `bool`: whether the polyline is closed; `false` by default
 * \return the completed polyline, which can be passed to `draw_polyline()` and `snap_polyline()`
 * \pre no edge of the triangulation has been flipped
 * \throws Occupied_triangulation_error if a network has curves in the triangulation, and two consecutive points do not
 *         lie in a common face
 * \throws Invalid_curve_error if the polyline has fewer than two points, or fewer than three if it is closed
 * \throws Disconnected_endpoints_error if no edge path connects two consecutive points
 * \throws Invalid_location_error as `draw_polyline()` does
 * \throws Insertion_error as `draw_polyline()` does
 * \throws Degenerate_face_error as `shorten()` does
 * \throws Invalid_coordinate_error as `shorten()` does
 */
template <class Triangulation, class PointRange = std::vector<Surface_location>, class... NamedParameters>
std::vector<Surface_location> complete_polyline(Triangulation& triangulation, const PointRange& polyline,
                                                const NamedParameters&... np)
{
  const bool is_closed = internal::is_closed_of(internal::options_of<internal::Closed_parameter>(np...));
  const auto& input = triangulation.input();
  const std::vector<Surface_location> given = internal::located_places(triangulation, polyline);
  if(given.size() < (is_closed ? 3u : 2u))
    throw Invalid_curve_error("a polyline requires at least two points, and a closed polyline at least three");
  std::vector<Surface_location> result;
  for(std::size_t i = 0; i < given.size(); ++i) {
    const Surface_location p = internal::canonical_location(input, given[i]);
    result.push_back(p);
    if(i + 1 == given.size() && !is_closed)
      break;
    const Surface_location q = internal::canonical_location(input, given[(i + 1) % given.size()]);
    if(internal::common_face(input, p, q) != null_index)
      continue;
    auto between = internal::Path_straightener<Triangulation>(triangulation).shortest(p, q);
    for(Surface_location& crossing : between)
      for(double& weight : crossing.weights)
        weight = weight < internal::zero_weight ? 0 : weight; // a point this close to a vertex is inserted there
    result.insert(result.end(), between.begin() + 1, between.end() - 1);
  }
  return result;
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds a polyline anywhere on the mesh to a network, as a curve that is fixed at all points of the polyline
 * \cgalCite{SC20,Figure 9}.
 *
 * The points become vertices of the triangulation, and the segments of the polyline become edges, so the curve
 * coincides with the polyline. For this purpose, edges are flipped in the input faces that contain the segments. A
 * segment that passes through a vertex becomes several edges.
 *
 * After a call of `Edge_path_network::free_nodes()`, the curve can be shortened.
 *
 * Which edges a segment crosses is decided exactly, from the weights of the points. Several polylines can be added one
 * after another. Polylines can meet at vertices and overlap; `Edge_path_network::free_nodes()` detects whether they
 * cross there. Segments that cross elsewhere cannot be edges of one triangulation and are rejected.
 *
 * \param network the network
 * \param polyline a range of points of any type that `surface_location()` accepts. Any two consecutive points must lie
 *        in a common face of the input. A closed polyline must not repeat the first point. A point that equals the
 *        previous point is skipped
 * \param np the named parameter `is_closed`, a `bool`: whether the polyline is closed; `false` by default
 * \return the index of the curve
 * \pre in the input faces that contain the polyline, no edge of the triangulation crosses an input edge
 * \throws Invalid_curve_error if two consecutive points do not lie in a common face, or if the polyline has too few
 *         points
 * \throws Crossing_curves_error if a segment crosses another segment or a curve of the network between vertices;
 *         `elements()` returns the ends of the crossed edge. In this case, no curve is added, but points may have
 *         become vertices, and edges may have been flipped
 * \throws Invalid_location_error if a location is not a point of the surface
 * \throws Insertion_error as `Edge_path_network::insert()` does
 * \throws Occupied_triangulation_error as `Edge_path_network::insert()` does
 * \throws Degenerate_face_error as `Edge_path_network::insert()` does
 * \throws Invalid_coordinate_error as `Edge_path_network::insert()` does
 */
template <class Network, class PointRange = std::vector<Surface_location>, class... NamedParameters>
Curve_index draw_polyline(Network& network, const PointRange& polyline, const NamedParameters&... np)
{
  const bool is_closed = internal::is_closed_of(internal::options_of<internal::Closed_parameter>(np...));
  const auto& triangulation = network.triangulation();
  const auto points =
      internal::canonical_polyline(triangulation.input(), internal::located_places(triangulation, polyline), is_closed);
  return internal::add_chain(network, internal::Polyline_drawer<Network>(network)(points), is_closed);
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Snaps a polyline to a path of input edges, and returns the vertices of the path. Each point on an edge is moved to
 * the nearer end of the edge, and each end of an open polyline to the vertex with the largest weight. Other points
 * inside faces are ignored. Apart from the moves of the ends, the path is in the homotopy class of the polyline. No
 * vertex is added.
 *
 * \param triangulation the triangulation
 * \param polyline a range of points, as for `draw_polyline()`
 * \param np the named parameter `is_closed`, a `bool`: whether the polyline is closed; `false` by default
 * \return the vertices of the path, which can be passed to `halfedges_through()`. A closed path does not repeat the
 *         first vertex. If the polyline shrinks to a vertex, fewer than two vertices are returned
 * \throws Invalid_curve_error as `draw_polyline()` does
 * \throws Invalid_location_error as `draw_polyline()` does
 */
template <class Triangulation, class PointRange = std::vector<Surface_location>, class... NamedParameters>
std::vector<Vertex_index> snap_polyline(const Triangulation& triangulation, const PointRange& polyline,
                                        const NamedParameters&... np)
{
  const bool is_closed = internal::is_closed_of(internal::options_of<internal::Closed_parameter>(np...));
  const auto& input = triangulation.input();
  const auto points = internal::canonical_polyline(input, internal::located_places(triangulation, polyline), is_closed);
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
      path.pop_back(); // back and forth
    else
      path.push_back(v);
  }
  while(is_closed && path.size() > 1 && path.front() == path.back())
    path.pop_back();
  return path;
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_NETWORKS_FROM_DATA_H
