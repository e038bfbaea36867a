// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_TO_MESH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_TO_MESH_H

#include <CGAL/Flip_geodesics/internal/surface/graph_functions.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Overlay.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Builds a MutableFaceGraph from an overlay, link by link, so that nothing has to be searched for, and edges that share
 * both end vertices are no matter. The elements of the mesh are created in the order of the overlay's.
 */
template <class Triangulation, class OutputMesh>
class Overlay_to_mesh
{
  using Overlay = internal::Overlay<Triangulation>;
  using Graph = boost::graph_traits<OutputMesh>;

public:
  using vertex_descriptor = typename Graph::vertex_descriptor;
  using halfedge_descriptor = typename Graph::halfedge_descriptor;
  using face_descriptor = typename Graph::face_descriptor;

  Overlay_to_mesh(const Overlay& overlay, OutputMesh& mesh)
    : m_overlay(overlay)
    , m_mesh(mesh)
    , m_vertices(static_cast<std::size_t>(overlay.number_of_vertices()), Graph::null_vertex())
    , m_halfedges(static_cast<std::size_t>(overlay.number_of_halfedges()), Graph::null_halfedge())
  {
    create_vertices();
    create_edges();
    create_faces();
    link_border();
  }

  /* The mesh's vertex for a vertex of the overlay, the null vertex if it was dissolved. */
  vertex_descriptor vertex(Overlay_vertex v) const { return m_vertices[v]; }
  /* The mesh's halfedge for a halfedge of the overlay, the null halfedge if it was dissolved. */
  halfedge_descriptor halfedge(Overlay_halfedge h) const { return m_halfedges[h]; }

private:
  // All but the crossings and inserted vertices that were dissolved.
  void create_vertices()
  {
    Per_overlay_vertex<char> is_used(m_vertices.size(), 0);
    for(Overlay_halfedge h : m_overlay.halfedges())
      if(m_overlay.is_alive(h))
        is_used[m_overlay.origin(h)] = 1;
    for(Overlay_vertex v : m_overlay.vertices())
      if(is_used[v] != 0 || m_overlay.is_input_vertex(v)) {
        m_vertices[v] = add_vertex(m_mesh);
        set_halfedge(m_vertices[v], Graph::null_halfedge(), m_mesh);
      }
  }

  void create_edges()
  {
    for(Overlay_halfedge h : m_overlay.halfedges()) {
      if(!is_first_side(h) || !m_overlay.is_alive(h))
        continue;
      const Overlay_halfedge t = Overlay::twin(h);
      m_halfedges[h] = graph_halfedge(add_edge(m_mesh), m_mesh);
      m_halfedges[t] = opposite(m_halfedges[h], m_mesh);
      set_target(m_halfedges[h], m_vertices[m_overlay.target(h)], m_mesh);
      set_target(m_halfedges[t], m_vertices[m_overlay.origin(h)], m_mesh);
    }
  }

  void create_faces()
  {
    m_overlay.for_each_polygon([&](Overlay_halfedge h) {
      const face_descriptor f = add_face(m_mesh);
      set_halfedge(f, m_halfedges[h], m_mesh);
      m_overlay.for_each_side(h, [&](Overlay_halfedge side) {
        set_face(m_halfedges[side], f, m_mesh);
        set_next(m_halfedges[side], m_halfedges[m_overlay.next(side)], m_mesh);
        set_halfedge(m_vertices[m_overlay.target(side)], m_halfedges[side], m_mesh);
      });
    });
  }

  // Vertices on the border refer to a halfedge there, as `Surface_mesh` wants it.
  void link_border()
  {
    for(Overlay_halfedge h : m_overlay.halfedges()) {
      if(!m_overlay.is_alive(h) || !m_overlay.is_border(h))
        continue;
      Overlay_halfedge after = Overlay::twin(h); // turns about the target of h
      while(!m_overlay.is_border(after))
        after = Overlay::twin(m_overlay.previous(after));
      set_face(m_halfedges[h], Graph::null_face(), m_mesh);
      set_next(m_halfedges[h], m_halfedges[after], m_mesh);
      set_halfedge(m_vertices[m_overlay.target(h)], m_halfedges[h], m_mesh);
    }
  }

  const Overlay& m_overlay;
  OutputMesh& m_mesh;
  Per_overlay_vertex<vertex_descriptor> m_vertices;
  Per_overlay_halfedge<halfedge_descriptor> m_halfedges;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_TO_MESH_H
