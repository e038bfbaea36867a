// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SLIT_MESH_H
#define CGAL_FLIP_GEODESICS_SLIT_MESH_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

template <class TriangleMesh>
class Slit_mesh;

namespace internal {

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

#ifndef DOXYGEN_RUNNING
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
#endif

namespace CGAL::Flip_geodesics {

namespace internal {

template <class Halfedge, class TriangleMesh>
auto graph_edge(Halfedge h, const TriangleMesh& mesh)
{
  return edge(h, mesh);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsObstacles
 *
 * Represents a mesh that is slit along some of its edges: a view of the mesh in which the faces on the two sides of
 * these edges are not connected across them. Paths can run along slits but cannot cross them. The view stores lists of
 * its vertices, edges and halfedges, but no copy of the mesh.
 *
 * At each vertex of the mesh, the slits and the border separate the incident faces into sectors, and the vertex has one
 * copy for each sector. If a slit ends inside the surface, its end is therefore a single vertex. Each edge of the mesh
 * along a slit becomes two edges. The faces are those of the mesh.
 *
 * A descriptor of a vertex, a halfedge or an edge stores the corresponding descriptor of the mesh and can be converted
 * to it. A vertex descriptor of the mesh can be converted to the descriptor of the first copy of the vertex.
 *
 * The class is a model of `FaceListGraph` and `HalfedgeListGraph`, with the points of the mesh. A slit mesh can be
 * passed to all functions of this package that do not modify the mesh. Functions that return a mesh then
 * require the type of the result as a template argument, because elements cannot be added to a slit mesh.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 */
template <class TriangleMesh>
class Slit_mesh
{
  using Graph = boost::graph_traits<TriangleMesh>;
  using Mesh_vertex = typename Graph::vertex_descriptor;
  using Mesh_halfedge = typename Graph::halfedge_descriptor;
  using Mesh_edge = typename Graph::edge_descriptor;

public:
  /// Identifies a vertex, that is, one of the copies of a vertex of the mesh.
  struct Vertex
  {
    Mesh_vertex vertex;   ///< the vertex of the mesh
    std::size_t copy = 0; ///< the number of the copy, starting at 0

    /// Constructs a null descriptor.
    Vertex()
      : vertex(Graph::null_vertex())
    {
    }
    /// Constructs the descriptor of a copy of a vertex of the mesh, by default the first copy.
    Vertex(Mesh_vertex vertex, std::size_t copy = 0)
      : vertex(vertex)
      , copy(copy)
    {
    }
    /// Returns the vertex of the mesh.
    operator Mesh_vertex() const { return vertex; }
    /// Returns the key by which vertices are ordered.
    auto key() const { return std::make_tuple(vertex, copy); }
    /// \cond
    friend bool operator==(const Vertex& a, const Vertex& b) { return a.key() == b.key(); }
    friend bool operator!=(const Vertex& a, const Vertex& b) { return !(a == b); }
    friend bool operator<(const Vertex& a, const Vertex& b) { return a.key() < b.key(); }
    /// \endcond
  };

  /// Identifies a halfedge.
  struct Halfedge
  {
    Mesh_halfedge halfedge; ///< the halfedge of the mesh with the same direction
    bool is_outer = false;  ///< whether this is the border halfedge of a slit along `halfedge`

    /// Constructs a null descriptor.
    Halfedge()
      : halfedge(Graph::null_halfedge())
    {
    }
    /// Constructs the descriptor of a halfedge of the mesh, or of the border halfedge of a slit along this halfedge.
    explicit Halfedge(Mesh_halfedge halfedge, bool is_outer = false)
      : halfedge(halfedge)
      , is_outer(is_outer)
    {
    }
    /// Returns the halfedge of the mesh.
    operator Mesh_halfedge() const { return halfedge; }
    /// Returns the key by which halfedges are ordered.
    auto key() const { return std::make_tuple(halfedge, is_outer); }
    /// \cond
    friend bool operator==(const Halfedge& a, const Halfedge& b) { return a.key() == b.key(); }
    friend bool operator!=(const Halfedge& a, const Halfedge& b) { return !(a == b); }
    friend bool operator<(const Halfedge& a, const Halfedge& b) { return a.key() < b.key(); }
    /// \endcond
  };

  /// Identifies an edge; the edges on the two sides of a slit are different.
  struct Edge
  {
    Mesh_edge edge;                                  ///< the edge of the mesh
    Mesh_halfedge halfedge = Graph::null_halfedge(); ///< a halfedge of the edge; at a slit, the halfedge with a face
    bool is_at_slit = false;                         ///< whether this is one of the two edges along a slit
    bool is_outer = false; ///< whether this descriptor was obtained from the border halfedge of an edge at a slit

    /// Returns the edge of the mesh.
    operator Mesh_edge() const { return edge; }
    /// Returns the key by which edges are ordered.
    auto key() const { return std::make_tuple(edge, is_at_slit ? halfedge : Graph::null_halfedge()); }
    /// \cond
    friend bool operator==(const Edge& a, const Edge& b) { return a.key() == b.key(); }
    friend bool operator!=(const Edge& a, const Edge& b) { return !(a == b); }
    friend bool operator<(const Edge& a, const Edge& b) { return a.key() < b.key(); }
    /// \endcond
  };

  /*!
   * Constructs a view of a mesh that is slit along given edges.
   *
   * \param mesh a triangle mesh, which must outlive the slit mesh and must not be changed
   * \param slits a model of `ReadablePropertyMap` with the edges of the mesh as keys and `bool` as value type. Only the
   *        constructor accesses the map; marks of border edges have no effect
   *
   * Complexity: linear in the size of the mesh, plus \cgalBigO{n \log n} time, where \f$n\f$ is the number of edges at
   * slits.
   */
  template <class EdgeIsSlitMap>
  Slit_mesh(const TriangleMesh& mesh, const EdgeIsSlitMap& slits)
    : m_mesh(&mesh)
  {
    for(Mesh_edge e : edges(mesh))
      add_edge(e, get(slits, e));
    for(Mesh_vertex v : vertices(mesh))
      m_vertices.push_back(v);
    for(const Edge& e : m_edges) {
      m_halfedges.emplace_back(e.halfedge);
      m_halfedges.emplace_back(opposite(e.halfedge, *m_mesh), is_slit(e.halfedge));
    }
    number_copies();
  }

  const TriangleMesh& mesh() const { return *m_mesh; } ///< returns the mesh

  /// Returns whether a halfedge of the mesh lies on a slit.
  bool is_slit(Mesh_halfedge h) const { return m_slits.count(h) != 0; }

  /// Returns the number of copies of a vertex of the mesh.
  std::size_t number_of_copies(Mesh_vertex v) const
  {
    const auto found = m_number_of_copies.find(v);
    return found == m_number_of_copies.end() ? 1 : found->second;
  }

  /// Returns the copy of the tail of halfedge `h` that is a corner of the face on the left of `h`.
  /// \pre `h` has a face
  Vertex vertex_in_face(Mesh_halfedge h) const
  {
    const auto found = m_copy.find(h);
    return {source(h, *m_mesh), found == m_copy.end() ? 0 : found->second};
  }

  /// Returns all vertices: the first copy of each vertex of the mesh, followed by all further copies.
  const std::vector<Vertex>& all_vertices() const { return m_vertices; }
  /// Returns all edges in the order of the edges of the mesh; the two edges that replace an edge on a slit are
  /// consecutive.
  const std::vector<Edge>& all_edges() const { return m_edges; }
  /// Returns all halfedges; the two halfedges of an edge are consecutive.
  const std::vector<Halfedge>& all_halfedges() const { return m_halfedges; }

  /// Returns the edge of a halfedge of the mesh; at a slit, this is the edge on the side of the halfedge.
  Edge edge_of(Mesh_halfedge h) const { return make_edge(internal::graph_edge(h, *m_mesh), h, is_slit(h)); }

private:
  void add_edge(Mesh_edge e, bool is_to_be_slit)
  {
    const Mesh_halfedge h = halfedge(e, *m_mesh), t = opposite(h, *m_mesh);
    const bool has_two_faces = face(h, *m_mesh) != Graph::null_face() && face(t, *m_mesh) != Graph::null_face();
    const bool is_at_slit = is_to_be_slit && has_two_faces;
    m_edges.push_back(make_edge(e, h, is_at_slit));
    if(!is_at_slit)
      return;
    m_edges.push_back(make_edge(e, t, true));
    m_slits.insert(h);
    m_slits.insert(t);
  }

  static Edge make_edge(Mesh_edge e, Mesh_halfedge h, bool is_at_slit)
  {
    Edge result;
    result.edge = e;
    result.halfedge = h;
    result.is_at_slit = is_at_slit;
    return result;
  }

  // Numbers the sectors around a vertex clockwise, from the first outgoing halfedge that begins one.
  void number_copies()
  {
    for(const Edge& e : m_edges)
      if(is_slit(e.halfedge) && m_number_of_copies.count(source(e.halfedge, *m_mesh)) == 0)
        number_copies(e.halfedge);
  }

  // Numbers the sectors around the tail of a halfedge on a slit. The sector on the right of a halfedge follows it.
  void number_copies(Mesh_halfedge first)
  {
    const Mesh_vertex v = source(first, *m_mesh);
    std::size_t copy = 0;
    bool is_in_sector = false; // of this copy
    Mesh_halfedge h = first;
    do {
      const Mesh_halfedge t = opposite(h, *m_mesh);
      if(is_in_sector && (is_slit(h) || face(h, *m_mesh) == Graph::null_face())) {
        ++copy;
        is_in_sector = false;
      }
      if(face(t, *m_mesh) != Graph::null_face()) {
        m_copy[next(t, *m_mesh)] = copy;
        is_in_sector = true;
      }
      h = next(t, *m_mesh);
    } while(h != first);
    m_number_of_copies[v] = copy + (is_in_sector ? 1 : 0);
    for(std::size_t i = 1; i < m_number_of_copies[v]; ++i)
      m_vertices.push_back({v, i});
  }

  const TriangleMesh* m_mesh;
  std::vector<Vertex> m_vertices;
  std::vector<Edge> m_edges;
  std::vector<Halfedge> m_halfedges;
  std::set<Mesh_halfedge> m_slits;
  std::map<Mesh_halfedge, std::size_t> m_copy;           // of the tail, in the face on the left
  std::map<Mesh_vertex, std::size_t> m_number_of_copies; // of vertices at slits
};

} // namespace CGAL::Flip_geodesics

#ifndef DOXYGEN_RUNNING

namespace CGAL::Flip_geodesics {

template <class M>
Iterator_range<typename boost::graph_traits<Slit_mesh<M>>::vertex_iterator> vertices(const Slit_mesh<M>& mesh)
{
  return make_range(mesh.all_vertices().begin(), mesh.all_vertices().end());
}

template <class M>
Iterator_range<typename boost::graph_traits<Slit_mesh<M>>::edge_iterator> edges(const Slit_mesh<M>& mesh)
{
  return make_range(mesh.all_edges().begin(), mesh.all_edges().end());
}

template <class M>
Iterator_range<typename boost::graph_traits<Slit_mesh<M>>::halfedge_iterator> halfedges(const Slit_mesh<M>& mesh)
{
  return make_range(mesh.all_halfedges().begin(), mesh.all_halfedges().end());
}

template <class M>
auto faces(const Slit_mesh<M>& mesh)
{
  return faces(mesh.mesh());
}

template <class M>
std::size_t num_vertices(const Slit_mesh<M>& mesh)
{
  return mesh.all_vertices().size();
}

template <class M>
std::size_t num_edges(const Slit_mesh<M>& mesh)
{
  return mesh.all_edges().size();
}

template <class M>
std::size_t num_halfedges(const Slit_mesh<M>& mesh)
{
  return mesh.all_halfedges().size();
}

template <class M>
std::size_t num_faces(const Slit_mesh<M>& mesh)
{
  return static_cast<std::size_t>(num_faces(mesh.mesh()));
}

template <class M>
typename boost::graph_traits<M>::face_descriptor face(typename Slit_mesh<M>::Halfedge h, const Slit_mesh<M>& mesh)
{
  return h.is_outer ? boost::graph_traits<M>::null_face() : face(h.halfedge, mesh.mesh());
}

template <class M>
typename Slit_mesh<M>::Halfedge halfedge(typename boost::graph_traits<M>::face_descriptor f, const Slit_mesh<M>& mesh)
{
  return typename Slit_mesh<M>::Halfedge(halfedge(f, mesh.mesh()));
}

/*
 * Returns the halfedge from which the edge was obtained, as required by the validity check of CGAL, or else the
 * halfedge of the mesh that the edge stores.
 */
template <class M>
typename Slit_mesh<M>::Halfedge halfedge(typename Slit_mesh<M>::Edge e, const Slit_mesh<M>& mesh)
{
  const typename Slit_mesh<M>::Halfedge h(e.halfedge);
  return e.is_outer ? opposite(h, mesh) : h;
}

template <class M>
typename Slit_mesh<M>::Halfedge opposite(typename Slit_mesh<M>::Halfedge h, const Slit_mesh<M>& mesh)
{
  return typename Slit_mesh<M>::Halfedge(opposite(h.halfedge, mesh.mesh()), !h.is_outer && mesh.is_slit(h.halfedge));
}

template <class M>
typename Slit_mesh<M>::Edge edge(typename Slit_mesh<M>::Halfedge h, const Slit_mesh<M>& mesh)
{
  auto result = mesh.edge_of(h.is_outer ? opposite(h.halfedge, mesh.mesh()) : h.halfedge);
  result.is_outer = h.is_outer;
  return result;
}

/* Border halfedges are connected around the faces of the sector between them. */
template <class M>
typename Slit_mesh<M>::Halfedge next(typename Slit_mesh<M>::Halfedge h, const Slit_mesh<M>& mesh)
{
  using Halfedge = typename Slit_mesh<M>::Halfedge;
  const auto is_border = [&](Halfedge g) { return face(g, mesh) == boost::graph_traits<M>::null_face(); };
  if(!is_border(h))
    return Halfedge(next(h.halfedge, mesh.mesh()));
  for(h = opposite(h, mesh); !is_border(h);)
    h = opposite(Halfedge(prev(h.halfedge, mesh.mesh())), mesh);
  return h;
}

template <class M>
typename Slit_mesh<M>::Halfedge prev(typename Slit_mesh<M>::Halfedge h, const Slit_mesh<M>& mesh)
{
  using Halfedge = typename Slit_mesh<M>::Halfedge;
  const auto is_border = [&](Halfedge g) { return face(g, mesh) == boost::graph_traits<M>::null_face(); };
  if(!is_border(h))
    return Halfedge(prev(h.halfedge, mesh.mesh()));
  for(h = opposite(h, mesh); !is_border(h);)
    h = opposite(Halfedge(next(h.halfedge, mesh.mesh())), mesh);
  return h;
}

template <class M>
typename Slit_mesh<M>::Vertex source(typename Slit_mesh<M>::Halfedge h, const Slit_mesh<M>& mesh)
{
  if(face(h, mesh) != boost::graph_traits<M>::null_face())
    return mesh.vertex_in_face(h.halfedge);
  return mesh.vertex_in_face(next(opposite(h.halfedge, mesh.mesh()), mesh.mesh()));
}

template <class M>
typename Slit_mesh<M>::Vertex target(typename Slit_mesh<M>::Halfedge h, const Slit_mesh<M>& mesh)
{
  return source(opposite(h, mesh), mesh);
}

template <class M>
typename Slit_mesh<M>::Vertex source(typename Slit_mesh<M>::Edge e, const Slit_mesh<M>& mesh)
{
  return source(halfedge(e, mesh), mesh);
}

template <class M>
typename Slit_mesh<M>::Vertex target(typename Slit_mesh<M>::Edge e, const Slit_mesh<M>& mesh)
{
  return target(halfedge(e, mesh), mesh);
}

/* Returns a halfedge that ends at a vertex, or a null halfedge if the vertex is isolated. */
template <class M>
typename Slit_mesh<M>::Halfedge halfedge(typename Slit_mesh<M>::Vertex v, const Slit_mesh<M>& mesh)
{
  using Halfedge = typename Slit_mesh<M>::Halfedge;
  const auto first = halfedge(v.vertex, mesh.mesh());
  if(first == boost::graph_traits<M>::null_halfedge())
    return Halfedge();
  auto h = first;
  do {
    for(bool is_outer : {false, true})
      if(const Halfedge here(h, is_outer); (!is_outer || mesh.is_slit(h)) && target(here, mesh) == v)
        return here;
    h = opposite(next(h, mesh.mesh()), mesh.mesh());
  } while(h != first);
  return Halfedge();
}

/* Returns the halfedge from one vertex to another, and whether it exists. */
template <class M>
std::pair<typename Slit_mesh<M>::Halfedge, bool> halfedge(typename Slit_mesh<M>::Vertex u,
                                                          typename Slit_mesh<M>::Vertex v, const Slit_mesh<M>& mesh)
{
  using Halfedge = typename Slit_mesh<M>::Halfedge;
  const Halfedge first = halfedge(v, mesh);
  if(first == Halfedge())
    return {first, false};
  Halfedge h = first;
  do {
    if(source(h, mesh) == u)
      return {h, true};
    h = opposite(next(h, mesh), mesh);
  } while(h != first);
  return {Halfedge(), false};
}

template <class M>
internal::Slit_mesh_points<M> get(boost::vertex_point_t tag, const Slit_mesh<M>& mesh)
{
  return {get(tag, mesh.mesh())};
}

} // namespace CGAL::Flip_geodesics

#endif // DOXYGEN_RUNNING

#endif // CGAL_FLIP_GEODESICS_SLIT_MESH_H
