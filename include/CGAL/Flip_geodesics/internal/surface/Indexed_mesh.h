// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INDEXED_MESH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INDEXED_MESH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

template <typename P>
class Surface_mesh;

namespace Flip_geodesics::internal {

/* The functions of the graph concepts, found by argument-dependent lookup; inside classes, members would hide them. */
template <class Descriptor, class TriangleMesh>
auto graph_halfedge(Descriptor d, const TriangleMesh& mesh)
{
  return halfedge(d, mesh);
}

template <class Descriptor, class TriangleMesh>
auto graph_next(Descriptor h, const TriangleMesh& mesh)
{
  return next(h, mesh);
}

template <class Descriptor, class TriangleMesh>
auto graph_face(Descriptor h, const TriangleMesh& mesh)
{
  return face(h, mesh);
}

/* Returns whether a descriptor is that of a face of the mesh; of most meshes, whether it is not null. */
template <class TriangleMesh>
bool is_face(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh&)
{
  return f != boost::graph_traits<TriangleMesh>::null_face();
}

template <class P>
bool is_face(typename Surface_mesh<P>::Face_index f, const Surface_mesh<P>& mesh)
{
  const std::size_t end = mesh.number_of_faces() + mesh.number_of_removed_faces();
  return static_cast<std::size_t>(f) < end && !mesh.is_removed(f);
}

/*
 * The result of contracting the degenerate edges of a mesh: the new halfedges of the old ones, and the new
 * connectivity. Vertices keep their numbers; those merged into another one are isolated.
 */
struct Contraction
{
  /* The states of a removed halfedge: its ends are one vertex; no nondegenerate face remains beside it; or it runs
   * along two others. */
  static constexpr Input_halfedge_index is_point{-1}, is_hair{-2}, is_fold{-3};

  /* The two halfedges of the input along which another one runs, and the distance of their common vertex from its
   * tail. */
  struct Fold
  {
    Input_halfedge_index first, second;
    double share;
  };

  using Halfedges = Indexed_by<Input_halfedge_index, std::vector<Input_halfedge_index>>;

  Indexed_by<Vertex_index, std::vector<Vertex_index>> vertex; // for each vertex of the input, its new vertex
  Halfedges halfedge;                                         // for each halfedge of the input
  Halfedges input_halfedge;                                   // for each new halfedge, one of its input halfedges
  Halfedges next;
  Indexed_by<Input_halfedge_index, std::vector<Vertex_index>> tail;
  Indexed_by<Input_halfedge_index, std::vector<char>> is_border;
  Indexed_by<Vertex_index, std::vector<Input_halfedge_index>> outgoing; // null_index if isolated
  std::map<Input_halfedge_index, Fold> folds;                           // for halfedges of the input
  bool has_split_point = false; // whether umbrellas that met only at a point have separate vertices there
};

/*
 * The state of an indexed mesh before its degenerate edges were contracted, and the relation between the two; none if
 * nothing was contracted.
 */
template <class Indexed_mesh>
struct Uncontracted
{
  Indexed_mesh mesh;
  Contraction contraction;
};

template <class Indexed_mesh>
class Possibly_contracted
{
public:
  /* Returns whether degenerate edges were contracted. */
  bool is_contracted() const { return m_origin != nullptr; }

  /* Returns the other side of the edge. */
  static Input_halfedge_index twin(Input_halfedge_index h) { return twin_index(h); }

  /* Returns whether umbrellas that met at a point have separate vertices. */
  bool has_split_point() const { return is_contracted() && m_origin->contraction.has_split_point; }

  /* Returns the new vertex, and below the new halfedge, of number `i` in the mesh before the contraction. */
  Vertex_index contracted_vertex(Vertex_index v) const
  {
    return is_contracted() && v.is_valid() ? m_origin->contraction.vertex[v] : v;
  }
  Input_halfedge_index contracted_halfedge(Input_halfedge_index h) const
  {
    return is_contracted() && h.is_valid() ? m_origin->contraction.halfedge[h] : h;
  }
  /* Returns the same halfedge, or `null_index` if it was removed. */
  Input_halfedge_index remaining_halfedge(Input_halfedge_index h) const
  {
    const Input_halfedge_index result = contracted_halfedge(h);
    return result.is_valid() ? result : null_index;
  }

  /* Returns the two halfedges along which a halfedge of the old mesh runs. \pre `contracted_halfedge(h)` is
   * `Contraction::is_fold` */
  const Contraction::Fold& fold(Input_halfedge_index h) const { return m_origin->contraction.folds.at(h); }

  /* Returns the mesh before the contraction. */
  const Indexed_mesh& uncontracted() const
  {
    return is_contracted() ? m_origin->mesh : static_cast<const Indexed_mesh&>(*this);
  }

  /* Returns one of the old halfedges that have become h, and below the vertices at which it starts and ends. */
  Input_halfedge_index uncontracted_halfedge(Input_halfedge_index h) const
  {
    return is_contracted() ? m_origin->contraction.input_halfedge[h] : h;
  }
  Vertex_index uncontracted_tail(Input_halfedge_index h) const { return uncontracted().tail(uncontracted_halfedge(h)); }
  Vertex_index uncontracted_head(Input_halfedge_index h) const
  {
    return uncontracted().tail(twin_index(uncontracted_halfedge(h)));
  }

protected:
  std::shared_ptr<const Uncontracted<Indexed_mesh>> m_origin;
};

/*
 * A FaceListGraph as seen through consecutive integers, with twin(h) == h ^ 1.
 *
 * The general model numbers edges and vertices in the order of `edges(mesh)` and `vertices(mesh)` and copies the
 * connectivity once, in linear time. It requires only `<` of the descriptors, whose order affects no result.
 *
 * `is_triangle()` accepts a face with one side as a triangle, which `Halfedge_store` does not.
 */
template <class TriangleMesh>
class Indexed_mesh : public Possibly_contracted<Indexed_mesh<TriangleMesh>>
{
  using Graph = boost::graph_traits<TriangleMesh>;

public:
  using vertex_descriptor = typename Graph::vertex_descriptor;
  using halfedge_descriptor = typename Graph::halfedge_descriptor;

  explicit Indexed_mesh(const TriangleMesh& mesh)
    : m_mesh(&mesh)
  {
    index_vertices(mesh);
    index_halfedges(mesh);
    copy_connectivity(mesh);
  }

  const TriangleMesh& mesh() const { return *m_mesh; }

  Index number_of_vertices() const { return static_cast<Index>(m_vertices.size()); }
  Index number_of_halfedges() const { return static_cast<Index>(m_next.size()); }
  /* \pre all faces are triangles */
  Index number_of_faces() const { return (number_of_halfedges() - m_number_of_border_halfedges) / 3; }

  vertex_descriptor vertex(Vertex_index v) const { return m_vertices[v]; }
  halfedge_descriptor halfedge(Input_halfedge_index h) const { return m_halfedges[this->uncontracted_halfedge(h)]; }
  Vertex_index index(vertex_descriptor v) const
  {
    return this->contracted_vertex(Vertex_index(find(m_vertex_order, v)));
  }
  Input_halfedge_index index(halfedge_descriptor h) const
  {
    return this->remaining_halfedge(Input_halfedge_index(find(m_halfedge_order, h)));
  }

  Input_halfedge_index next(Input_halfedge_index h) const { return m_next[h]; }
  Input_halfedge_index previous(Input_halfedge_index h) const { return m_previous[h]; }
  bool is_triangle(Input_halfedge_index h) const { return next(next(h)) == previous(h); }
  Vertex_index tail(Input_halfedge_index h) const { return m_tail[h]; }
  bool is_border(Input_halfedge_index h) const { return m_is_border[h] != 0; }
  /// Returns a halfedge that starts at `v`, or `null_index` at an isolated vertex.
  Input_halfedge_index outgoing(Vertex_index v) const { return m_outgoing[v]; }

  /* Replaces the mesh by the result of a contraction. */
  void replace_connectivity(Contraction&& contraction)
  {
    auto origin = std::make_shared<Uncontracted<Indexed_mesh>>(Uncontracted<Indexed_mesh>{*this, {}});
    m_next = contraction.next;
    m_tail = contraction.tail;
    m_outgoing = contraction.outgoing;
    m_is_border = contraction.is_border;
    link_previous();
    origin->contraction = std::move(contraction);
    this->m_origin = std::move(origin);
  }

private:
  template <class Descriptor>
  using Order = std::vector<std::pair<Descriptor, Index>>;

  template <class Descriptor>
  static Order<Descriptor> sorted_order(const std::vector<Descriptor>& descriptors)
  {
    Order<Descriptor> order;
    order.reserve(descriptors.size());
    for(const Descriptor& d : descriptors)
      order.emplace_back(d, static_cast<Index>(order.size()));
    std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return order;
  }

  template <class Descriptor>
  static Index find(const Order<Descriptor>& order, const Descriptor& wanted)
  {
    const auto found = std::lower_bound(order.begin(), order.end(), wanted,
                                        [](const auto& entry, const Descriptor& d) { return entry.first < d; });
    return (found != order.end() && found->first == wanted) ? found->second : Index(null_index);
  }

  void index_vertices(const TriangleMesh& mesh)
  {
    for(vertex_descriptor v : vertices(mesh))
      m_vertices.push_back(v);
    checked_index_bound(m_vertices.size());
    m_vertex_order = sorted_order(m_vertices);
  }

  void index_halfedges(const TriangleMesh& mesh)
  {
    for(const auto& e : edges(mesh)) {
      m_halfedges.push_back(graph_halfedge(e, mesh));
      m_halfedges.push_back(opposite(m_halfedges.back(), mesh));
    }
    checked_index_bound(m_halfedges.size());
    m_halfedge_order = sorted_order(m_halfedges);
  }

  void copy_connectivity(const TriangleMesh& mesh)
  {
    m_outgoing.assign(m_vertices.size(), null_index);
    for(halfedge_descriptor h : m_halfedges) {
      m_next.push_back(index(graph_next(h, mesh)));
      m_tail.push_back(index(source(h, mesh)));
      m_is_border.push_back(graph_face(h, mesh) == Graph::null_face() ? 1 : 0);
      m_outgoing[m_tail.back()] = Input_halfedge_index(static_cast<Index>(m_tail.size()) - 1);
    }
    link_previous();
  }

  void link_previous()
  {
    m_number_of_border_halfedges = static_cast<Index>(std::count(m_is_border.begin(), m_is_border.end(), char(1)));
    m_previous.resize(m_next.size());
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(number_of_halfedges())) {
      if(m_next[h] == null_index)
        throw_no_next(m_tail[h], m_tail[twin_index(h)]);
      m_previous[m_next[h]] = h;
    }
  }

  [[noreturn]] static void throw_no_next(Vertex_index v, Vertex_index w)
  {
    throw_naming<Invalid_mesh_error>("the halfedge from vertex ", v, " to vertex ", w, " has no next halfedge");
  }

  const TriangleMesh* m_mesh;
  Indexed_by<Vertex_index, std::vector<vertex_descriptor>> m_vertices;
  Indexed_by<Input_halfedge_index, std::vector<halfedge_descriptor>> m_halfedges;
  Order<vertex_descriptor> m_vertex_order;
  Order<halfedge_descriptor> m_halfedge_order;
  Indexed_by<Input_halfedge_index, std::vector<Input_halfedge_index>> m_next, m_previous;
  Indexed_by<Input_halfedge_index, std::vector<Vertex_index>> m_tail;
  Indexed_by<Vertex_index, std::vector<Input_halfedge_index>> m_outgoing;
  Indexed_by<Input_halfedge_index, std::vector<char>> m_is_border;
  Index m_number_of_border_halfedges = 0;
};

/*
 * A `Surface_mesh` already has this numbering, so nothing is copied and nothing is read before it is requested. If
 * edges are contracted, a second `Surface_mesh` without points represents the result.
 */
template <class P>
class Indexed_mesh<CGAL::Surface_mesh<P>> : public Possibly_contracted<Indexed_mesh<CGAL::Surface_mesh<P>>>
{
  using Mesh = CGAL::Surface_mesh<P>;
  using Graph = boost::graph_traits<Mesh>;

public:
  using vertex_descriptor = typename Graph::vertex_descriptor;
  using halfedge_descriptor = typename Graph::halfedge_descriptor;

  explicit Indexed_mesh(const Mesh& mesh)
    : m_mesh(&mesh)
    , m_number_of_vertices(checked_index_bound(mesh.number_of_vertices()))
    , m_number_of_halfedges(checked_index_bound(mesh.number_of_halfedges()))
  {
    if(mesh.number_of_removed_vertices() != 0 || mesh.number_of_removed_edges() != 0)
      throw Invalid_mesh_error("the mesh contains removed vertices or edges; call collect_garbage()");
  }

  const Mesh& mesh() const { return *m_mesh; }

  Index number_of_vertices() const { return m_number_of_vertices; }
  Index number_of_halfedges() const { return m_number_of_halfedges; }
  Index number_of_faces() const { return static_cast<Index>(m_mesh->number_of_faces()); }

  vertex_descriptor vertex(Vertex_index v) const { return vertex_descriptor(static_cast<std::uint32_t>(v.idx())); }
  halfedge_descriptor halfedge(Input_halfedge_index h) const { return own_halfedge(this->uncontracted_halfedge(h)); }
  Vertex_index index(vertex_descriptor v) const
  {
    return this->contracted_vertex(Vertex_index(to_index(v, m_number_of_vertices)));
  }
  Input_halfedge_index index(halfedge_descriptor h) const
  {
    return this->remaining_halfedge(Input_halfedge_index(to_index(h, this->uncontracted().number_of_halfedges())));
  }

  Input_halfedge_index next(Input_halfedge_index h) const { return of_own(m_mesh->next(own_halfedge(h))); }
  Input_halfedge_index previous(Input_halfedge_index h) const { return of_own(m_mesh->prev(own_halfedge(h))); }
  bool is_triangle(Input_halfedge_index h) const { return next(next(h)) == previous(h); }
  Vertex_index tail(Input_halfedge_index h) const
  {
    return Vertex_index(static_cast<Index>(m_mesh->target(own_halfedge(twin_index(h)))));
  }
  bool is_border(Input_halfedge_index h) const { return m_mesh->is_border(own_halfedge(h)); }
  Input_halfedge_index outgoing(Vertex_index v) const
  {
    const halfedge_descriptor h = m_mesh->halfedge(vertex(v));
    return h == Graph::null_halfedge() ? null_index : twin_index(of_own(h));
  }

  /* Replaces the mesh by the result of a contraction. */
  void replace_connectivity(Contraction&& contraction)
  {
    auto left = std::make_shared<Mesh>();
    for(Index v = 0; v < m_number_of_vertices; ++v)
      left->add_vertex();
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(static_cast<Index>(contraction.next.size()))) {
      if(is_first_side(h))
        left->add_edge(); // whose ends can be one vertex
      left->set_target(own_halfedge(h), vertex(contraction.tail[twin_index(h)]));
    }
    connect(*left, contraction);
    m_number_of_halfedges = static_cast<Index>(contraction.next.size());
    this->m_origin = std::make_shared<Uncontracted<Indexed_mesh>>(
        Uncontracted<Indexed_mesh>{Indexed_mesh(*m_mesh), std::move(contraction)});
    m_contracted_mesh = left;
    m_mesh = left.get();
  }

private:
  static halfedge_descriptor own_halfedge(Input_halfedge_index h)
  {
    return halfedge_descriptor(static_cast<std::uint32_t>(h.idx()));
  }
  static Input_halfedge_index of_own(halfedge_descriptor h) { return Input_halfedge_index(static_cast<Index>(h)); }

  template <class Descriptor>
  static Index to_index(Descriptor d, Index bound)
  {
    const std::size_t i = static_cast<std::size_t>(d);
    return i < static_cast<std::size_t>(bound) ? static_cast<Index>(i) : Index(null_index);
  }

  static void connect(Mesh& mesh, const Contraction& contraction)
  {
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(static_cast<Index>(contraction.next.size()))) {
      mesh.set_next(own_halfedge(h), own_halfedge(contraction.next[h]));
      if(contraction.is_border[h] != 0 || mesh.face(own_halfedge(h)) != Graph::null_face())
        continue;
      const auto f = mesh.add_face();
      mesh.set_halfedge(f, own_halfedge(h));
      Input_halfedge_index side = h;
      do {
        mesh.set_face(own_halfedge(side), f);
        side = contraction.next[side];
      } while(side != h);
    }
    for(Vertex_index v : descriptors<Vertex_index>(static_cast<Index>(contraction.outgoing.size())))
      if(contraction.outgoing[v] != null_index)
        mesh.set_halfedge(vertex_descriptor(static_cast<std::uint32_t>(v.idx())),
                          own_halfedge(twin_index(contraction.outgoing[v])));
  }

  const Mesh* m_mesh;
  Index m_number_of_vertices, m_number_of_halfedges;
  std::shared_ptr<const Mesh> m_contracted_mesh; // to which `m_mesh` then refers
};

} // namespace Flip_geodesics::internal
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INDEXED_MESH_H
