// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_SURFACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_SURFACE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A face of a covering, by the halfedge that lies over the first one of the mesh's face. */
struct Covering_face
{
  Input_halfedge_index halfedge;

  friend bool operator==(Covering_face a, Covering_face b) { return a.halfedge == b.halfedge; }
  friend bool operator!=(Covering_face a, Covering_face b) { return !(a == b); }
};

/*
 * A part of the universal covering of a surface: all faces around the lifts that a search has settled. In it all paths
 * between two vertices are homotopic, so that the shortest of them is the shortest of a class on the original surface.
 *
 * The part has an additional border, the *frontier*, beyond which the covering continues. Both ends of its edges are
 * lifts that are not settled. Such a lift has a vertex for each row of faces that contains it.
 *
 * The first side of an edge lies over the first side of the edge below.
 */
template <class TriangleMesh>
class Covering_surface
{
public:
  using Below = Indexed_mesh<TriangleMesh>;

  /* The mesh and its indices must outlive this object. */
  template <class Search>
  Covering_surface(const TriangleMesh& mesh, const Below& below, const Search& search)
    : m_mesh(&mesh)
    , m_below(&below)
    , m_vertex(search.number_of_lifts(), null_index)
  {
    for(Index lift = 0; lift < static_cast<Index>(search.number_of_lifts()); ++lift)
      if(search.is_settled(lift))
        add_faces(search, lift);
    m_edges.clear();
    link_border();
    number_vertices(search);
  }

  const TriangleMesh& mesh() const { return *m_mesh; }
  const Below& below() const { return *m_below; }

  Index number_of_vertices() const { return static_cast<Index>(m_outgoing.size()); }
  Index number_of_halfedges() const { return static_cast<Index>(m_next.size()); }
  /* Takes linear time. */
  Index number_of_faces() const
  {
    const auto borders = std::count(m_is_border.begin(), m_is_border.end(), char(1));
    return (number_of_halfedges() - static_cast<Index>(borders)) / 3;
  }
  Input_halfedge_index next(Input_halfedge_index h) const { return m_next[h]; }
  Input_halfedge_index previous(Input_halfedge_index h) const { return m_previous[h]; }
  Vertex_index tail(Input_halfedge_index h) const { return m_tail[h]; }
  bool is_border(Input_halfedge_index h) const { return m_is_border[h] != 0; }
  Input_halfedge_index outgoing(Vertex_index v) const { return m_outgoing[v]; }

  /* Returns the halfedge below. */
  Input_halfedge_index below(Input_halfedge_index h) const
  {
    return Input_halfedge_index(2 * m_edge_below[static_cast<std::size_t>(h.idx() / 2)] + h.idx() % 2);
  }
  Vertex_index below(Vertex_index v) const { return m_below->tail(below(m_outgoing[v])); }

  /* Returns the lift at which a halfedge starts. */
  Index lift(Input_halfedge_index h) const { return m_tail_lift[h]; }
  /* Returns the vertex of a settled lift. */
  Vertex_index vertex(Index lift) const { return m_vertex[static_cast<std::size_t>(lift)]; }
  /* Returns whether a halfedge has no face here, although the one below has. */
  bool is_frontier(Input_halfedge_index h) const { return is_border(h) && !m_below->is_border(below(h)); }

private:
  template <class Search>
  void add_faces(const Search& search, Index lift)
  {
    std::vector<Input_halfedge_index> outgoing_halfedges;
    const Input_halfedge_index first = m_below->outgoing(search.vertex(lift));
    Input_halfedge_index h = first;
    do {
      outgoing_halfedges.push_back(h);
      h = m_below->next(twin_index(h));
    } while(h != first);
    // The face on the left of an outgoing halfedge lies between it and the previous one.
    const auto is_before = [&](Index l) { return l < lift && search.is_settled(l); };
    for(std::size_t i = 0; i < outgoing_halfedges.size(); ++i) {
      const Index a = search.neighbor(lift, i), b = search.neighbor(lift, (i == 0 ? outgoing_halfedges.size() : i) - 1);
      if(!m_below->is_border(outgoing_halfedges[i]) && !is_before(a) && !is_before(b))
        add_face(outgoing_halfedges[i], lift, a, b);
    }
  }

  // Adds the face over that on the left of h; its corners, starting with the tail of h, are three lifts.
  void add_face(Input_halfedge_index h, Index lift, Index a, Index b)
  {
    const Input_halfedge_index side = add_side(h, lift, a), side_next = add_side(m_below->next(h), a, b),
                               side_previous = add_side(m_below->previous(h), b, lift);
    link(side, side_next);
    link(side_next, side_previous);
    link(side_previous, side);
    m_is_border[side] = m_is_border[side_next] = m_is_border[side_previous] = 0;
  }

  // Returns the halfedge over h from one lift to another.
  Input_halfedge_index add_side(Input_halfedge_index h, Index from, Index to)
  {
    const std::uint64_t edge = static_cast<std::uint64_t>(h.idx() / 2);
    const std::uint64_t start = static_cast<std::uint64_t>(is_first_side(h) ? from : to);
    const auto [place, is_new] = m_edges.emplace(start << 32 | edge, m_edge_below.size());
    if(is_new) {
      m_edge_below.push_back(h.idx() / 2);
      for(std::size_t i = 0; i < 2; ++i) {
        m_next.push_back(null_index);
        m_previous.push_back(null_index);
        m_is_border.push_back(1);
        m_tail_lift.push_back(is_first_side(h) == (i == 0) ? from : to);
      }
    }
    return Input_halfedge_index(2 * checked_index_bound(place->second) + h.idx() % 2);
  }

  void link(Input_halfedge_index h, Input_halfedge_index next)
  {
    m_next[h] = next;
    m_previous[next] = h;
  }

  // Border halfedges are consecutive around the row of faces at a vertex.
  void link_border()
  {
    checked_index_bound(m_next.size());
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(number_of_halfedges()))
      if(is_border(h)) {
        Input_halfedge_index g = twin_index(h);
        while(!is_border(g))
          g = twin_index(m_previous[g]);
        link(h, g);
      }
  }

  template <class Search>
  void number_vertices(const Search& search)
  {
    m_tail.assign(m_next.size(), null_index);
    for(Input_halfedge_index first : descriptors<Input_halfedge_index>(number_of_halfedges())) {
      if(m_tail[first] != null_index)
        continue;
      const Vertex_index v(number_of_vertices());
      m_outgoing.push_back(first);
      if(search.is_settled(m_tail_lift[first]))
        m_vertex[static_cast<std::size_t>(m_tail_lift[first])] = v;
      Input_halfedge_index h = first;
      do {
        m_tail[h] = v;
        h = m_next[twin_index(h)];
      } while(h != first);
    }
  }

  const TriangleMesh* m_mesh;
  const Below* m_below;
  std::unordered_map<std::uint64_t, std::size_t>
      m_edges; // by the lift at which the first side starts and the halfedge below
  std::vector<Index> m_edge_below;
  Indexed_by<Input_halfedge_index, std::vector<Input_halfedge_index>> m_next, m_previous;
  Indexed_by<Input_halfedge_index, std::vector<char>> m_is_border;
  Indexed_by<Input_halfedge_index, std::vector<Index>> m_tail_lift;
  Indexed_by<Input_halfedge_index, std::vector<Vertex_index>> m_tail;
  Indexed_by<Vertex_index, std::vector<Input_halfedge_index>> m_outgoing;
  std::vector<Vertex_index> m_vertex; // by lift
};

/* The data of the faces of a graph that a curve point requires. */
template <class TriangleMesh>
Covering_face face(Input_halfedge_index h, const Covering_surface<TriangleMesh>& surface)
{
  const auto& below = surface.below();
  const auto f = graph_face(below.halfedge(surface.below(h)), surface.mesh());
  const Input_halfedge_index first = below.index(graph_halfedge(f, surface.mesh()));
  for(int i = 0; i < 2 && surface.below(h) != first; ++i)
    h = surface.next(h);
  return {h};
}

template <class TriangleMesh>
Input_halfedge_index halfedge(Covering_face f, const Covering_surface<TriangleMesh>&)
{
  return f.halfedge;
}

/* A covering surface is numbered already, and is its own mesh. */
template <class TriangleMesh>
class Indexed_mesh<Covering_surface<TriangleMesh>> : public Numbered_surface<Covering_surface<TriangleMesh>>
{
public:
  using Numbered_surface<Covering_surface<TriangleMesh>>::Numbered_surface;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

namespace boost {

template <class TriangleMesh>
struct graph_traits<CGAL::Flip_geodesics::internal::Covering_surface<TriangleMesh>>
  : CGAL::Flip_geodesics::internal::Numbered_surface_traits<CGAL::Flip_geodesics::internal::Covering_face>
{
};

} // namespace boost

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The metric of a covering surface, which is that of the surface below. A model of IntrinsicMetric. */
template <class TriangleMesh, class Metric>
class Covering_metric
{
public:
  using Mesh = Numbered_mesh<Covering_surface<TriangleMesh>>;
  using Kernel = typename Metric::Kernel;
  using Point_3 = typename Metric_point<Metric>::type;
  using Place = typename Metric::Place;

  explicit Covering_metric(const Metric& metric)
    : m_metric(metric)
    , m_flat_edges(std::make_shared<Flat_edges>())
  {
  }

  decltype(auto) point(const Mesh& mesh, Vertex_index v) const
  {
    return m_metric.point(below(mesh), mesh.surface().below(v));
  }

  std::array<double, 3> vector(const Mesh& mesh, Vertex_index v, Vertex_index w) const
  {
    return Internals<Metric>::vector(m_metric, below(mesh), mesh.surface().below(v), mesh.surface().below(w));
  }

  double length(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_metric.length(below(mesh), mesh.surface().below(h));
  }
  double weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_metric.weight(below(mesh), mesh.surface().below(h));
  }
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const
  {
    return m_metric.weight(below(mesh), mesh.surface().below(h), tail, head);
  }

  Place place(const Mesh& mesh, Vertex_index v) const { return m_metric.place(below(mesh), mesh.surface().below(v)); }
  double distance_lower_bound(const Place& p, const Place& q) const { return m_metric.distance_lower_bound(p, q); }

  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    return internal::face_geometry(m_metric, below(mesh), mesh.surface().below(h), traits);
  }

  bool is_rounded(const Mesh& mesh) const { return is_rounded_metric(m_metric, below(mesh)); }
  bool is_usable_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    return internal::is_usable_face(m_metric, below(mesh), mesh.surface().below(h));
  }

  Exact_face exact_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    return internal::exact_face(m_metric, below(mesh), mesh.surface().below(h));
  }

  /* The results for flat edges are stored for the edges below. */
  bool sine_in_plane(const Mesh& mesh, const Edge_sequence& a, const Edge_sequence& b, Index steps, Flat_edges&,
                     Sign& sine) const
  {
    if(m_flat_edges->size() == 0)
      *m_flat_edges = Flat_edges(static_cast<std::size_t>(below(mesh).number_of_halfedges() / 2));
    sine = ZERO;
    return internal::sine_in_plane(m_metric, below(mesh), below(mesh, a), below(mesh, b), steps, *m_flat_edges, sine);
  }

private:
  static const Numbered_mesh<TriangleMesh>& below(const Mesh& mesh) { return mesh.surface().below(); }

  static Edge_sequence below(const Mesh& mesh, Edge_sequence word)
  {
    const auto project = [&mesh](auto& element) {
      if(element != null_index)
        element = mesh.surface().below(element);
    };
    project(word.along);
    project(word.face);
    project(word.tail);
    project(word.head);
    for(Input_halfedge_index& h : word.crossed)
      project(h);
    return word;
  }

  Metric m_metric;
  std::shared_ptr<Flat_edges> m_flat_edges;
};

template <class TriangleMesh, class Metric>
struct Internals<Covering_metric<TriangleMesh, Metric>> : Internals_of_members<Covering_metric<TriangleMesh, Metric>>
{
  static constexpr bool has_exact_faces = internal::has_exact_faces<Metric>;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_SURFACE_H
