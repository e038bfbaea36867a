// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SUBDIVIDE_H
#define CGAL_FLIP_GEODESICS_SUBDIVIDE_H

#include <CGAL/Flip_geodesics/Surface_subdivision.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/*
 * Dissolves the pieces of intrinsic edges that no curve runs along, and what crossings and inserted vertices they leave
 * on input edges. The parts of a face are convex then, unless a curve ends or bends at an inserted vertex inside it; in
 * such faces all pieces are kept.
 */
template <class Network>
class Curve_filter
{
  using Triangulation = typename Network::Triangulation;
  using Overlay = internal::Overlay<Triangulation>;
  using Layout = Overlay_layout<Triangulation>;
  using Vector_2 = typename Layout::Point_2;

public:
  Curve_filter(Overlay& overlay, Layout& layout, const Network& network)
    : m_overlay(overlay)
    , m_layout(layout)
    , m_network(network)
  {
  }

  void operator()()
  {
    mark_bends();
    m_layout.forget_intrinsic_faces();
    const auto all = m_overlay.halfedges();
    for(Overlay_halfedge h : all)
      if(is_first_side(h) && !is_kept(h) && m_whole_faces.count(m_layout.face(h)) == 0)
        m_overlay.dissolve(h);
    for(Overlay_halfedge h : all)
      if(m_overlay.is_alive(h) && !m_overlay.is_border(h))
        while(!m_overlay.is_input_vertex(m_overlay.target(h)) && is_passed(h)) {
          m_layout.join(h);
          m_overlay.join(h);
        }
  }

private:
  bool is_kept(Overlay_halfedge h) const { return m_overlay.input_halfedge(h) != null_index || is_on_curve(h); }

  // Does nothing but an input edge without a curve go through the target of h?
  bool is_passed(Overlay_halfedge h) const
  {
    return m_overlay.input_halfedge(h) != null_index && m_overlay.has_two_edges_at_target(h) && !is_on_curve(h) &&
           !is_on_curve(m_overlay.next(h));
  }

  bool is_on_curve(Overlay_halfedge h) const
  {
    const Halfedge_index intrinsic = m_overlay.intrinsic_halfedge(h);
    return intrinsic != null_index && m_network.is_occupied(intrinsic);
  }

  void mark_bends()
  {
    for(Overlay_halfedge h : m_overlay.halfedges()) {
      const Overlay_vertex v = m_overlay.origin(h);
      const bool may_bend = !m_overlay.is_input_vertex(v) && !m_overlay.is_crossing(v) && is_kept(h) &&
                            m_overlay.input_halfedge(h) == null_index;
      if(may_bend && is_reflex_after(h))
        m_whole_faces.insert(m_layout.face(h));
    }
  }

  // From h counterclockwise about its origin, is the next kept piece, or the next input edge, more than pi away?
  bool is_reflex_after(Overlay_halfedge h) const
  {
    const Overlay_halfedge next = [&] {
      Overlay_halfedge g = h;
      do
        g = Overlay::twin(m_overlay.previous(g));
      while(!m_overlay.is_border(g) && !is_kept(g));
      return g;
    }();
    if(m_overlay.input_halfedge(next) != null_index)
      return false;
    if(next == h)
      return true;
    const Vector_2 u = direction(h), v = direction(next);
    const double dot = u[0] * v[0] + u[1] * v[1], cross = u[0] * v[1] - u[1] * v[0];
    return cross < 0 && !(dot < 0 && -cross <= internal::straight_division * -dot);
  }

  Vector_2 direction(Overlay_halfedge h) const
  {
    const auto corners = m_layout.corners(m_layout.face(h));
    const Vector_2 from = Layout::point(corners, m_layout.weights(h));
    const Vector_2 to = Layout::point(corners, m_layout.weights(m_overlay.next(h)));
    return {to[0] - from[0], to[1] - from[1]};
  }

  Overlay& m_overlay;
  Layout& m_layout;
  const Network& m_network;
  std::set<Input_halfedge_index> m_whole_faces;
};

template <class Triangulation>
void cut(Overlay<Triangulation>& overlay, Overlay_layout<Triangulation>& layout, Overlay_halfedge h)
{
  if(overlay.is_border(h) || overlay.is_border(overlay.twin(h)))
    return;
  overlay.cut(h);
  layout.add_cut(overlay.twin(h));
}

/* Edges that are to be cut, with none of both their ends on the border or on another such edge: their two sides would
 * have both ends in common. By first halfedges. */
template <class Triangulation, class Predicate>
std::vector<Overlay_halfedge> slits_of_one_edge(const Overlay<Triangulation>& overlay, const Predicate& is_on_curve)
{
  const auto number_of_vertices = static_cast<std::size_t>(overlay.number_of_vertices());
  Per_overlay_vertex<int> degree(number_of_vertices, 0); // those on the border have more
  std::vector<Overlay_halfedge> candidates, result;
  for(Overlay_halfedge h : overlay.halfedges()) {
    if(!is_first_side(h) || !overlay.is_alive(h))
      continue;
    const bool is_border = overlay.is_border(h) || overlay.is_border(overlay.twin(h));
    const bool is_cut = !is_border && is_on_curve(overlay.intrinsic_halfedge(h));
    for(Overlay_vertex v : {overlay.origin(h), overlay.target(h)})
      degree[v] += is_border ? 2 : (is_cut ? 1 : 0);
    if(is_cut)
      candidates.push_back(h);
  }
  for(Overlay_halfedge h : candidates)
    if(degree[overlay.origin(h)] == 1 && degree[overlay.target(h)] == 1)
      result.push_back(h);
  return result;
}

template <class Triangulation>
auto same_vertices(const Overlay<Triangulation>& overlay)
{
  const auto all = overlay.vertices();
  return Per_overlay_vertex<Overlay_vertex>(all.begin(), all.end());
}

/* The input with the curves as edges, and cut open along them if that is wanted. */
template <class OutputMesh, class Network>
auto subdivide_along_curves(const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh,
                            bool is_cutting)
{
  using Triangulation = typename Network::Triangulation;
  Overlay<Triangulation> overlay(network.triangulation());
  Overlay_layout<Triangulation> layout(overlay);
  Curve_filter<Network>(overlay, layout, network)();
  Polygon_triangulator<Triangulation>(overlay, layout)();
  const auto is_on_curve = [&](Halfedge_index h) { return h != null_index && network.is_occupied(h); };
  for(Overlay_halfedge h : overlay.parallel_edges())
    layout.split(overlay, h);
  Per_overlay_vertex<Overlay_vertex> original;
  if(is_cutting) {
    for(Overlay_halfedge h : slits_of_one_edge(overlay, is_on_curve))
      layout.split(overlay, h);
    const auto all = overlay.halfedges();
    for(Overlay_halfedge h : all)
      if(is_first_side(h) && overlay.is_alive(h) && is_on_curve(overlay.intrinsic_halfedge(h)))
        cut(overlay, layout, h);
    original = overlay.split_vertices();
  } else
    original = same_vertices(overlay);
  return Surface_subdivision<Triangulation, OutputMesh>(overlay, layout, original, mesh, is_on_curve);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * The common subdivision of the input mesh and an intrinsic triangulation: a triangle mesh in which the edges of both
 * are chains of edges, with maps back to both [SSC19, section 3.4.1], [GSC21]. What is linear in the faces of either is
 * linear in the faces of the subdivision. So data can be carried from one to the other without loss.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`, of `mesh`
 * \param mesh the input mesh
 * \return a `Surface_subdivision<Triangulation, OutputMesh>`; `OutputMesh` is the type of `mesh` if none is given first
 * \throws Invalid_mesh_error if the elements of the result are too many for 32-bit indices; and what is thrown when
 *         faces are first touched
 *
 * Complexity: linear in the faces of the mesh and the crossings of the two triangulations.
 */
template <class OutputMesh, class Triangulation>
Surface_subdivision<Triangulation, OutputMesh> common_subdivision(const Triangulation& triangulation,
                                                                  const typename Triangulation::Triangle_mesh& mesh)
{
  internal::Overlay<Triangulation> overlay(triangulation);
  internal::Overlay_layout<Triangulation> layout(overlay);
  internal::Polygon_triangulator<Triangulation>(overlay, layout)();
  return Surface_subdivision<Triangulation, OutputMesh>(overlay, layout, internal::same_vertices(overlay), mesh,
                                                        [](Halfedge_index) { return false; });
}

/// \ingroup PkgFlipGeodesicsSubdivision
/// The same, with an output mesh of the input's type.
template <class Triangulation>
auto common_subdivision(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh)
{
  return common_subdivision<typename Triangulation::Triangle_mesh>(triangulation, mesh);
}

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * The input mesh with the curves of a network as chains of edges: faces that curves cross are split, all others stay.
 * `Surface_subdivision::edge_is_constrained_map()` marks the edges of the curves. Curves that run along one another
 * share edges. Two edges with both ends in common, as only meshes have on which two faces share all vertices, get
 * vertices in their middles.
 *
 * \param network a model of `CurveNetwork`; its curves need not be finished
 * \param mesh the input mesh of its triangulation
 * \return as `common_subdivision()`
 * \throws as `common_subdivision()`
 */
template <class OutputMesh, class Network>
Surface_subdivision<typename Network::Triangulation, OutputMesh> insert_curves(
    const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh)
{
  return internal::subdivide_along_curves<OutputMesh>(network, mesh, false);
}

/// \ingroup PkgFlipGeodesicsSubdivision
/// The same, with an output mesh of the input's type.
template <class Network>
auto insert_curves(const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh)
{
  return insert_curves<typename Network::Triangulation::Triangle_mesh>(network, mesh);
}

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * The input mesh cut open along the curves of a network: as `insert_curves()`, but each edge of a curve is doubled, and
 * vertices are where that separates the faces around them. Both copies are marked as constrained. An open curve inside
 * the surface makes a slit, whose ends are single vertices; a closed one, or one from border to border, two borders. A
 * slit of one edge could not open, since both sides would have both ends in common; it gets a vertex in its middle, once
 * a side.
 *
 * \param network, mesh as for `insert_curves()`
 * \return as `common_subdivision()`
 * \throws as `common_subdivision()`
 */
template <class OutputMesh, class Network>
Surface_subdivision<typename Network::Triangulation, OutputMesh> cut_along_curves(
    const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh)
{
  return internal::subdivide_along_curves<OutputMesh>(network, mesh, true);
}

/// \ingroup PkgFlipGeodesicsSubdivision
/// The same, with an output mesh of the input's type.
template <class Network>
auto cut_along_curves(const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh)
{
  return cut_along_curves<typename Network::Triangulation::Triangle_mesh>(network, mesh);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SUBDIVIDE_H
