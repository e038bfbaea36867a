// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_ELEMENTS_H
#define CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_ELEMENTS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Numbered_mesh.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/is_valid_halfedge.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Placed_halfedge.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * The elements of an intrinsic triangulation: how they are connected, how long they are, and which edges networks hold.
 * This is the base of `Intrinsic_triangulation`, which flips edges and inserts points.
 *
 * Template parameters are those of `Intrinsic_triangulation`.
 */
template <class TriangleMesh, class Traits_, class Metric_>
class Intrinsic_triangulation_elements
{
  static_assert(internal::Is_triangulation_traits<Traits_>::value,
                "the traits are no model of IntrinsicTriangulationTraits: of a kernel K, give "
                "Intrinsic_triangulation_traits<K> or Certified_intrinsic_triangulation_traits<K>");

public:
  using Triangle_mesh = TriangleMesh;                           ///< the input, as it was given
  using Traits = Traits_;                                       ///< the template parameter
  using Metric = Metric_;                                       ///< the template parameter
  using Input_mesh = Numbered_mesh<TriangleMesh>;               ///< the input, numbered
  using vertex_descriptor = Vertex_index;                       ///< of the intrinsic triangulation
  using halfedge_descriptor = Halfedge_index;                   ///< of the intrinsic triangulation
  using edge_descriptor = Edge_index;                           ///< of the intrinsic triangulation
  using face_descriptor = Face_index;                           ///< of the intrinsic triangulation
  using FT = typename Traits::FT;                               ///< of squared lengths
  using Halfedge_geometry = typename Traits::Halfedge_geometry; ///< what the traits store of a halfedge
  using Turn = typename Traits::Turn;                           ///< a rotation about a vertex, of the traits
  /// Descriptors of `Triangle_mesh`.
  using Mesh_vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// Descriptors of `Triangle_mesh`.
  using Mesh_halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  /// A model of `IntrinsicTriangulationWalker`.
  using Walker = internal::Placed_halfedge<internal::Halfedge_store<Input_mesh, Traits, Metric>>;

  /// \name The input
  /// @{

  /// The input mesh, numbered by consecutive integers.
  const Input_mesh& input() const { return m_halfedges.input(); }
  /// Where the lengths of the input's edges come from.
  const Metric& metric() const { return m_halfedges.metric(); }
  /// The arithmetic.
  const Traits& traits() const { return m_halfedges.traits(); }

  /// The number of vertices: the input's, and those inserted, which come after them.
  Index number_of_vertices() const { return m_halfedges.number_of_vertices(); }
  /// The number of halfedges, twice the number of edges.
  Index number_of_halfedges() const { return 2 * number_of_edges(); }
  /// The number of edges, the input's and those of inserted points; flips do not change it.
  Index number_of_edges() const { return m_halfedges.number_of_edges(); }

  /// The vertex that a vertex of the input mesh is, `null_index` if it is not one.
  Vertex_index index(Mesh_vertex v) const { return input().index(v); }
  /// The halfedge that a halfedge of the input mesh is as long as its edge is not flipped; none if it is not one.
  Halfedge_index index(Mesh_halfedge h) const { return internal::as_intrinsic(input().index(h)); }

  /// What vertex `v` is in the input mesh. \pre `v` was not inserted
  Mesh_vertex vertex(Vertex_index v) const { return input().vertex(v); }

  /// The input mesh's halfedge with the number of `h`.
  Mesh_halfedge input_halfedge(Halfedge_index h) const { return input().halfedge(internal::as_input(h)); }

  /// @}
  /// \name Connectivity
  /// Constant time. The face on the left of a halfedge is copied from the input at the first touch. Then a face that is
  /// no triangle, degenerate or not finite throws `Invalid_mesh_error`, `Degenerate_face_error` or
  /// `Invalid_coordinate_error`.
  /// @{

  /// The other side of the edge.
  static Halfedge_index twin(Halfedge_index h) { return internal::twin_index(h); }
  /// The edge that `h` is a side of.
  static Edge_index edge(Halfedge_index h) { return internal::edge_of(h); }

  /// The next halfedge around the face. \pre `h` is not on the border
  Halfedge_index next(Halfedge_index h) const { return m_halfedges.halfedge(record(h).next()); }
  /// The previous halfedge around the face. \pre `h` is not on the border
  Halfedge_index previous(Halfedge_index h) const { return m_halfedges.halfedge(m_halfedges[record(h).next()].next()); }
  /// The vertex at which `h` starts.
  Vertex_index tail(Halfedge_index h) const { return record(h).tail; }
  /// The vertex at which `h` ends.
  Vertex_index head(Halfedge_index h) const { return record(twin(h)).tail; }
  /// Has `h` no face on its left?
  bool is_border(Halfedge_index h) const { return record(h).is_border(); }

  /// The next halfedge clockwise about the tail, `null_index` where the border intervenes.
  Halfedge_index clockwise(Halfedge_index h) const
  {
    const Record& at_t = record(twin(h));
    return at_t.is_border() ? null_index : m_halfedges.halfedge(at_t.next());
  }

  /// The next halfedge counterclockwise about the tail, `null_index` where the border intervenes.
  Halfedge_index counterclockwise(Halfedge_index h) const { return is_border(h) ? null_index : twin(previous(h)); }

  /// A walker that stands at `h`.
  Walker walker(Halfedge_index h) const { return Walker(m_halfedges, m_halfedges.taken(h)); }
  /// The same, given the place of a walker at either side of the edge.
  Walker walker(typename Walker::Place place, Halfedge_index h) const
  {
    return Walker(m_halfedges, internal::side_slot(place, h));
  }

  /// Announces that the face on the left of `h` will be read soon: a hint to the cache, without any effect.
  void prefetch_face(Halfedge_index h) const { m_halfedges.prefetch_face(m_halfedges.slot(h)); }

  /// A halfedge that starts at `v`, `null_index` at an isolated vertex.
  Halfedge_index outgoing(Vertex_index v) const { return m_halfedges.outgoing(v); }

  /// @}
  /// \name Geometry
  /// @{

  /// What the traits keep of a halfedge, in the frame of its face. \pre `h` is not on the border
  const Halfedge_geometry& geometry(Halfedge_index h) const { return record(h).geometry; }

  /// The squared length of edge `edge(h)`, in the traits' number type.
  FT squared_length(Halfedge_index h) const
  {
    return traits().compute_squared_length_object()(geometry(is_border(h) ? twin(h) : h));
  }

  /// The length of edge `edge(h)`, rounded to double.
  double length(Halfedge_index h) const
  {
    return traits().compute_length_object()(geometry(is_border(h) ? twin(h) : h));
  }

  /*!
   * Adds to a turn about the tail of `h` the corner on the right of `h`, and moves on.
   * \return the next halfedge clockwise, `null_index` where the border intervenes and nothing is added
   */
  Halfedge_index extend_turn_clockwise(Turn& turn, Halfedge_index h) const
  {
    const Walker next = walker(h).extend_turn_clockwise(turn);
    return next.is_none() ? null_index : next.index();
  }

  /// Adds to a turn the corner at the head of `h`, from `next(h)` counterclockwise to `twin(h)`.
  void extend_turn(Turn& turn, Halfedge_index h) const { walker(h).extend_turn(turn); }

  /// @}
  /// \name Held edges
  /// An edge that is held is not flipped. A network holds each edge on which it has a segment once. Constant time.
  /// @{

  /// The number of holds on edge `e`: of networks that have a segment there, 0 at first.
  Index holds(Edge_index e) const { return m_halfedges.holds(m_halfedges.slot(internal::first_side(e))); }
  /// Holds edge `e` once more.
  void hold(Edge_index e) { m_halfedges.hold(m_halfedges.taken(internal::first_side(e))); }
  /// Takes one hold on edge `e` back. \pre `holds(e) > 0`
  void release(Edge_index e) { m_halfedges.release(m_halfedges.slot(internal::first_side(e))); }
  /// The number of holds on all edges; 0 if and only if no network has a segment in the triangulation.
  std::size_t number_of_holds() const { return m_halfedges.number_of_holds(); }

  /// An upper bound of `Walker::edge_place()`. It grows with the number of edges that have been touched.
  std::size_t number_of_edge_places() const { return m_halfedges.number_of_edge_places(); }

  /// @}

  /*!
   * Checks the invariant of all that has been touched: the links of faces, the closing of their vectors, the equal
   * lengths of an edge's two sides, relative to the longest edge of the face by `tolerance`, 1e-9 unless given.
   * Linear in the mesh.
   */
  bool is_valid(double tolerance = internal::default_validity_tolerance) const
  {
    for(Halfedge_index h : internal::descriptors<Halfedge_index>(number_of_halfedges()))
      if(m_halfedges[m_halfedges.slot(h)].is_known() && !is_border(h) &&
         !internal::is_valid_halfedge(*this, h, tolerance, m_halfedges[m_halfedges.slot(twin(h))].is_known()))
        return false;
    return true;
  }

protected:
  using Store = internal::Halfedge_store<Input_mesh, Traits, Metric>; ///< where the elements are kept

  /// The elements of an input that was not touched yet.
  Intrinsic_triangulation_elements(const Input_mesh& input, const Metric& metric, const Traits& traits)
    : m_halfedges(input, metric, traits)
  {
  }

  /// Moves the elements.
  Intrinsic_triangulation_elements(Intrinsic_triangulation_elements&&) noexcept = default;
  /// Moves the elements.
  Intrinsic_triangulation_elements& operator=(Intrinsic_triangulation_elements&&) noexcept = default;

  /// Where the elements are kept, for what changes them: faces of the input are copied when they are first read.
  Store& store() const { return m_halfedges; }

private:
  using Record = typename Store::Record;

  // Of a face that is known from here on.
  const Record& record(Halfedge_index h) const { return m_halfedges.known(h); }

  mutable Store m_halfedges;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_ELEMENTS_H
