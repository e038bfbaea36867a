// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SLIT_MESH_TRAITS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SLIT_MESH_TRAITS_H

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

template <class TriangleMesh>
class Slit_mesh;

namespace internal {

/* What `boost::graph_traits` says of a slit mesh. */
template <class TriangleMesh>
struct Slit_mesh_graph_traits
{
  struct traversal_category : public virtual boost::bidirectional_graph_tag,
                              public virtual boost::vertex_list_graph_tag,
                              public virtual boost::edge_list_graph_tag
  {
  };
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;

  using Mesh = Slit_mesh<TriangleMesh>;
  using vertex_descriptor = typename Mesh::Vertex;
  using halfedge_descriptor = typename Mesh::Halfedge;
  using edge_descriptor = typename Mesh::Edge;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using vertex_iterator = typename std::vector<vertex_descriptor>::const_iterator;
  using edge_iterator = typename std::vector<edge_descriptor>::const_iterator;
  using halfedge_iterator = typename std::vector<halfedge_descriptor>::const_iterator;
  using face_iterator = typename boost::graph_traits<TriangleMesh>::face_iterator;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using degree_size_type = std::size_t;

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return boost::graph_traits<TriangleMesh>::null_face(); }
};

/* The points of a slit mesh: those of the mesh. */
template <class TriangleMesh, class Map>
struct Slit_mesh_point_map
{
  using key_type = typename Slit_mesh<TriangleMesh>::Vertex;
  using value_type = typename boost::property_traits<Map>::value_type;
  using reference = typename boost::property_traits<Map>::reference;
  using category = boost::readable_property_map_tag;

  Map points;

  friend reference get(const Slit_mesh_point_map& map, const key_type& v) { return get(map.points, v.vertex); }
};

template <class TriangleMesh>
using Slit_mesh_points =
    Slit_mesh_point_map<TriangleMesh, typename boost::property_map<TriangleMesh, boost::vertex_point_t>::const_type>;

} // namespace internal
} // namespace Flip_geodesics

template <class TriangleMesh>
struct graph_has_property<Flip_geodesics::Slit_mesh<TriangleMesh>, boost::vertex_point_t>
  : graph_has_property<TriangleMesh, boost::vertex_point_t>
{
};

} // namespace CGAL

namespace boost {

template <class TriangleMesh>
struct graph_traits<CGAL::Flip_geodesics::Slit_mesh<TriangleMesh>>
  : CGAL::Flip_geodesics::internal::Slit_mesh_graph_traits<TriangleMesh>
{
};

template <class TriangleMesh>
struct graph_traits<const CGAL::Flip_geodesics::Slit_mesh<TriangleMesh>>
  : graph_traits<CGAL::Flip_geodesics::Slit_mesh<TriangleMesh>>
{
};

template <class TriangleMesh>
struct property_map<CGAL::Flip_geodesics::Slit_mesh<TriangleMesh>, boost::vertex_point_t>
{
  using type = CGAL::Flip_geodesics::internal::Slit_mesh_points<TriangleMesh>;
  using const_type = type;
};

} // namespace boost

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SLIT_MESH_TRAITS_H
