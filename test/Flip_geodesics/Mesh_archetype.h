// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_MESH_ARCHETYPE_H
#define FLIP_GEODESICS_TEST_MESH_ARCHETYPE_H

#include "mesh_soup.h"

#include <CGAL/Simple_cartesian.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

/*
 * A triangle mesh that is a `FaceListGraph` and a `HalfedgeListGraph` and nothing more: it cannot be changed, it has no
 * indices and no property map, its descriptors are no integers but can only be default constructed, copied and
 * compared. The halfedge of a vertex is no border halfedge, the order of its edges is not that in which other meshes
 * have them.
 */
class Mesh_archetype
{
public:
  using Point = CGAL::Simple_cartesian<double>::Point_3;

  // A descriptor of one kind; the tag keeps vertices, halfedges and faces apart.
  template <int Kind>
  class Descriptor
  {
  public:
    Descriptor() = default;
    bool operator==(const Descriptor& other) const { return m_id == other.m_id; }
    bool operator!=(const Descriptor& other) const { return m_id != other.m_id; }
    bool operator<(const Descriptor& other) const { return m_id < other.m_id; }

  private:
    friend class Mesh_archetype;
    explicit Descriptor(int id)
      : m_id(id)
    {
    }

    int m_id = -1;
  };

  using Vertex = Descriptor<0>;
  using Halfedge = Descriptor<1>;
  using Face = Descriptor<2>;

  // An edge is one of its halfedges, made by `edge()` only.
  class Edge
  {
  public:
    Edge() = default;
    bool operator==(const Edge& other) const { return m_halfedge == other.m_halfedge; }
    bool operator!=(const Edge& other) const { return m_halfedge != other.m_halfedge; }
    bool operator<(const Edge& other) const { return m_halfedge < other.m_halfedge; }

  private:
    friend class Mesh_archetype;
    explicit Edge(Halfedge h)
      : m_halfedge(h)
    {
    }

    Halfedge m_halfedge;
  };

  explicit Mesh_archetype(const Mesh_soup& soup)
    : m_faces(soup.triangles.size())
    , m_halfedge_of_vertex(soup.points.size(), -1)
  {
    for(const Coordinates& p : soup.points)
      m_points.emplace_back(p[0], p[1], p[2]);
    std::map<std::pair<int, int>, int> between;
    for(std::size_t t = soup.triangles.size(); t-- > 0;) // backwards, so that the order of edges is its own
      for(int i = 0; i < 3; ++i) {
        const int v = soup.triangles[t][i], w = soup.triangles[t][(i + 1) % 3];
        if(between.count({w, v}) == 0)
          add_edge(v, w, between);
        m_halfedges[between.at({v, w})].face = static_cast<int>(t);
      }
    for(std::size_t t = 0; t < soup.triangles.size(); ++t)
      for(int i = 0; i < 3; ++i) {
        const Corners& c = soup.triangles[t];
        const int h = between.at({c[i], c[(i + 1) % 3]});
        link(h, between.at({c[(i + 1) % 3], c[(i + 2) % 3]}));
        m_faces[t] = h;
        m_halfedge_of_vertex[c[(i + 1) % 3]] = h;
      }
    link_borders();
  }

  // The operations of the graph concepts, to be called through the free functions below only.
  struct Access;

private:
  struct Halfedge_data
  {
    int target, next = -1, previous = -1, face = -1;
  };

  void add_edge(int v, int w, std::map<std::pair<int, int>, int>& between)
  {
    between[{v, w}] = static_cast<int>(m_halfedges.size());
    m_halfedges.push_back({w});
    between[{w, v}] = static_cast<int>(m_halfedges.size());
    m_halfedges.push_back({v});
  }

  void link(int h, int next)
  {
    m_halfedges[h].next = next;
    m_halfedges[next].previous = h;
  }

  void link_borders()
  {
    for(int h = 0; h < static_cast<int>(m_halfedges.size()); ++h) {
      if(m_halfedges[h].face != -1)
        continue;
      int g = h ^ 1; // turn about the target, through the faces, to the border halfedge that leaves it
      while(m_halfedges[g].face != -1)
        g = m_halfedges[g].previous ^ 1;
      link(h, g);
    }
  }

  std::vector<Point> m_points;
  std::vector<Halfedge_data> m_halfedges; // 2i and 2i+1 are opposite
  std::vector<int> m_faces, m_halfedge_of_vertex;
};

struct Mesh_archetype::Access
{
  using Mesh = Mesh_archetype;

  template <class Item>
  struct Make
  {
    Item operator()(int i) const { return Access::make(i, static_cast<Item*>(nullptr)); }
  };

  template <class Item>
  using Iterator = boost::transform_iterator<Make<Item>, boost::counting_iterator<int>, Item, Item>;
  template <class Item>
  using Range = boost::iterator_range<Iterator<Item>>;

  static Vertex make(int i, Vertex*) { return Vertex(i); }
  static Halfedge make(int i, Halfedge*) { return Halfedge(i); }
  static Edge make(int i, Edge*) { return Edge(Halfedge(2 * i)); }
  static Face make(int i, Face*) { return Face(i); }

  template <class Item>
  static Range<Item> range(std::size_t size)
  {
    using Count = boost::counting_iterator<int>;
    return {Iterator<Item>(Count(0)), Iterator<Item>(Count(static_cast<int>(size)))};
  }

  static Range<Vertex> vertices(const Mesh& m) { return range<Vertex>(m.m_points.size()); }
  static Range<Halfedge> halfedges(const Mesh& m) { return range<Halfedge>(m.m_halfedges.size()); }
  static Range<Edge> edges(const Mesh& m) { return range<Edge>(m.m_halfedges.size() / 2); }
  static Range<Face> faces(const Mesh& m) { return range<Face>(m.m_faces.size()); }

  static Vertex target(Halfedge h, const Mesh& m) { return Vertex(m.m_halfedges[h.m_id].target); }
  static Halfedge next(Halfedge h, const Mesh& m) { return Halfedge(m.m_halfedges[h.m_id].next); }
  static Halfedge prev(Halfedge h, const Mesh& m) { return Halfedge(m.m_halfedges[h.m_id].previous); }
  static Halfedge opposite(Halfedge h) { return Halfedge(h.m_id ^ 1); }
  static Face face(Halfedge h, const Mesh& m) { return Face(m.m_halfedges[h.m_id].face); }
  static Halfedge halfedge(Face f, const Mesh& m) { return Halfedge(m.m_faces[f.m_id]); }
  static Halfedge halfedge(Vertex v, const Mesh& m) { return Halfedge(m.m_halfedge_of_vertex[v.m_id]); }
  static Halfedge halfedge(Edge e) { return e.m_halfedge; }
  static Edge edge(Halfedge h) { return Edge(Halfedge(h.m_id & ~1)); }
  static const Point& point(Vertex v, const Mesh& m) { return m.m_points[v.m_id]; }
};

// ---------------------------------------------------------------- the graph's free functions, found by their arguments

using Archetype_access = Mesh_archetype::Access;

inline auto vertices(const Mesh_archetype& m) { return Archetype_access::vertices(m); }
inline auto halfedges(const Mesh_archetype& m) { return Archetype_access::halfedges(m); }
inline auto edges(const Mesh_archetype& m) { return Archetype_access::edges(m); }
inline auto faces(const Mesh_archetype& m) { return Archetype_access::faces(m); }
inline std::size_t num_vertices(const Mesh_archetype& m) { return vertices(m).size(); }
inline std::size_t num_halfedges(const Mesh_archetype& m) { return halfedges(m).size(); }
inline std::size_t num_edges(const Mesh_archetype& m) { return edges(m).size(); }
inline std::size_t num_faces(const Mesh_archetype& m) { return faces(m).size(); }

inline Mesh_archetype::Halfedge opposite(Mesh_archetype::Halfedge h, const Mesh_archetype&)
{
  return Archetype_access::opposite(h);
}
inline Mesh_archetype::Halfedge next(Mesh_archetype::Halfedge h, const Mesh_archetype& m)
{
  return Archetype_access::next(h, m);
}
inline Mesh_archetype::Halfedge prev(Mesh_archetype::Halfedge h, const Mesh_archetype& m)
{
  return Archetype_access::prev(h, m);
}
inline Mesh_archetype::Vertex target(Mesh_archetype::Halfedge h, const Mesh_archetype& m)
{
  return Archetype_access::target(h, m);
}
inline Mesh_archetype::Vertex source(Mesh_archetype::Halfedge h, const Mesh_archetype& m)
{
  return Archetype_access::target(Archetype_access::opposite(h), m);
}
inline Mesh_archetype::Face face(Mesh_archetype::Halfedge h, const Mesh_archetype& m)
{
  return Archetype_access::face(h, m);
}
inline Mesh_archetype::Edge edge(Mesh_archetype::Halfedge h, const Mesh_archetype&)
{
  return Archetype_access::edge(h);
}
inline Mesh_archetype::Halfedge halfedge(Mesh_archetype::Edge e, const Mesh_archetype&)
{
  return Archetype_access::halfedge(e);
}
inline Mesh_archetype::Halfedge halfedge(Mesh_archetype::Face f, const Mesh_archetype& m)
{
  return Archetype_access::halfedge(f, m);
}
inline Mesh_archetype::Halfedge halfedge(Mesh_archetype::Vertex v, const Mesh_archetype& m)
{
  return Archetype_access::halfedge(v, m);
}
inline Mesh_archetype::Vertex source(Mesh_archetype::Edge e, const Mesh_archetype& m)
{
  return source(halfedge(e, m), m);
}
inline Mesh_archetype::Vertex target(Mesh_archetype::Edge e, const Mesh_archetype& m)
{
  return target(halfedge(e, m), m);
}

/// The points of a `Mesh_archetype`; the mesh itself has no property.
struct Archetype_point_map
{
  using key_type = Mesh_archetype::Vertex;
  using value_type = Mesh_archetype::Point;
  using reference = value_type; // a temporary, as property maps may have it
  using category = boost::readable_property_map_tag;

  const Mesh_archetype* mesh;

  friend reference get(const Archetype_point_map& map, key_type v) { return Archetype_access::point(v, *map.mesh); }
};

} // namespace Flip_geodesics_test

namespace boost {

template <>
struct graph_traits<Flip_geodesics_test::Mesh_archetype>
{
private:
  using Mesh = Flip_geodesics_test::Mesh_archetype;

  struct Category : bidirectional_graph_tag, vertex_list_graph_tag, edge_list_graph_tag
  {
  };

public:
  using vertex_descriptor = Mesh::Vertex;
  using halfedge_descriptor = Mesh::Halfedge;
  using edge_descriptor = Mesh::Edge;
  using face_descriptor = Mesh::Face;
  using vertex_iterator = Mesh::Access::Iterator<vertex_descriptor>;
  using halfedge_iterator = Mesh::Access::Iterator<halfedge_descriptor>;
  using edge_iterator = Mesh::Access::Iterator<edge_descriptor>;
  using face_iterator = Mesh::Access::Iterator<face_descriptor>;
  using directed_category = undirected_tag;
  using edge_parallel_category = disallow_parallel_edge_tag;
  using traversal_category = Category;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using degree_size_type = std::size_t;

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

} // namespace boost

#endif // FLIP_GEODESICS_TEST_MESH_ARCHETYPE_H
