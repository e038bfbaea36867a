// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_H
#define CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_H

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Zero_edge_contractor.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/concepts.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_history.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_insertion.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {
namespace internal {

/* Returns whether the face on the left of h closes and, if the twin's face is known, both sides agree in length and
 * vertices. */
template <class Triangulation>
bool is_valid_halfedge(const Triangulation& triangulation, Halfedge_index h, double tolerance, bool is_twin_known)
{
  const Halfedge_index t = Triangulation::twin(h), hn = triangulation.next(h), hp = triangulation.next(hn);
  if(triangulation.next(hp) != h || (is_twin_known && triangulation.tail(t) != triangulation.tail(hn)))
    return false;
  const double a = triangulation.length(h), b = triangulation.length(hn), c = triangulation.length(hp);
  const double scale = tolerance * (std::max)({a, b, c});
  if(a > b + c + scale)
    return false;
  return !is_twin_known || triangulation.is_border(t) || std::abs(a - triangulation.length(t)) <= scale;
}

/*
 * A halfedge of a triangulation, represented by its position in the storage of the triangulation, so that walks need
 * not look it up in the table of slots. Member functions copy faces of the input when necessary, as those of
 * `Intrinsic_triangulation` do.
 */
template <class Store>
class Placed_halfedge
{
  using Record = typename Store::Record;
  using Turn = typename Store::Traits::Turn;

public:
  using Place = Slot;

  Placed_halfedge(Store& store, Slot slot)
    : m_store(&store)
    , m_slot(slot)
  {
  }

  Place place() const { return m_slot; }

  Halfedge_index index() const { return store().halfedge(m_slot); }
  std::size_t edge_place() const { return static_cast<std::size_t>(m_slot) / 2; }
  bool is_held() const { return store().holds(m_slot) != 0; }
  void hold() const { store().hold(m_slot); }
  void release() const { store().release(m_slot); }

  bool is_none() const { return m_slot == Slot::NONE; }
  bool operator==(const Placed_halfedge& other) const { return m_slot == other.m_slot; }
  bool operator!=(const Placed_halfedge& other) const { return m_slot != other.m_slot; }

  bool is_border() const { return store().known(m_slot).is_border(); }
  Vertex_index tail() const { return store().known(m_slot).tail; }
  Placed_halfedge twin() const { return at(twin_slot(m_slot)); }
  Placed_halfedge next() const { return at(store().known(m_slot).next()); }
  Placed_halfedge previous() const { return at(store()[store().known(m_slot).next()].next()); }

  Placed_halfedge clockwise() const
  {
    const Record& record = store().known(twin_slot(m_slot));
    return at(record.is_border() ? Slot::NONE : record.next());
  }

  Placed_halfedge counterclockwise() const
  {
    const Record& record = store().known(m_slot);
    return at(record.is_border() ? Slot::NONE : twin_slot(store()[record.next()].next()));
  }

  double length() const
  {
    const Record& record = store().known(m_slot);
    return store().traits().compute_length_object()(
        (record.is_border() ? store().known(twin_slot(m_slot)) : record).geometry);
  }

  void prefetch_face() const { store().prefetch_face(m_slot); }

  Placed_halfedge extend_turn_clockwise(Turn& turn) const
  {
    const Record& in = store().known(twin_slot(m_slot));
    if(in.is_border())
      return at(Slot::NONE);
    extend_turn_over(turn, in);
    prefetch(&store()[store()[in.next()].next()]); // for a possible flip
    return at(in.next());
  }

  void extend_turn(Turn& turn) const { extend_turn_over(turn, store().known(m_slot)); }

  /*
   * Adds the angle at the head in the two faces of the edge; returns the halfedges at which this angle begins and ends,
   * clockwise.
   * \pre both faces exist
   */
  std::pair<Placed_halfedge, Placed_halfedge> extend_turn_at_head(Turn& turn) const
  {
    const Record& at_h = store().known(m_slot);
    const Slot tp = store()[store().known(twin_slot(m_slot)).next()].next();
    extend_turn_over(turn, at_h);
    extend_turn_over(turn, store()[tp]);
    return {at(tp).twin(), at(at_h.next())};
  }

private:
  Store& store() const { return *m_store; }
  Placed_halfedge at(Slot slot) const { return Placed_halfedge(*m_store, slot); }

  void extend_turn_over(Turn& turn, const Record& in) const
  {
    const Record& out = store()[in.next()];
    store().traits().extend_turn_object()(turn, in.geometry, out.geometry, store()[out.next()].geometry);
  }

  Store* m_store;
  Slot m_slot;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * Provides the elements of an intrinsic triangulation: their connectivity, their geometry, and the holds on edges,
 * which prevent flips. This is the base class of `Intrinsic_triangulation`, which flips edges and inserts points.
 *
 * The template parameters are those of `Intrinsic_triangulation`.
 */
template <class TriangleMesh, class Traits_, class Metric_>
class Intrinsic_triangulation_elements
{
  static_assert(internal::are_triangulation_traits<Traits_>());
  static_assert(internal::is_intrinsic_metric<Metric_, Traits_, internal::has_squared_lengths<Metric_>>());

public:
  using Triangle_mesh = TriangleMesh;                           ///< the type of the input
  using Traits = Traits_;                                       ///< the type of the traits
  using Metric = Metric_;                                       ///< the type of the metric
  using Input_mesh = Numbered_mesh<TriangleMesh>;               ///< the type of the numbered input
  using vertex_descriptor = Vertex_index;                       ///< the vertex type of the intrinsic triangulation
  using halfedge_descriptor = Halfedge_index;                   ///< the halfedge type of the intrinsic triangulation
  using edge_descriptor = Edge_index;                           ///< the edge type of the intrinsic triangulation
  using face_descriptor = Face_index;                           ///< the face type of the intrinsic triangulation
  using FT = typename Traits::FT;                               ///< the number type of squared lengths
  using Halfedge_geometry = typename Traits::Halfedge_geometry; ///< the data that the traits store for a halfedge
  using Turn = typename Traits::Turn; ///< the type of a rotation around a vertex, defined by the traits
  /// The vertex type of `Triangle_mesh`.
  using Mesh_vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// The halfedge type of `Triangle_mesh`.
  using Mesh_halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
#ifdef DOXYGEN_RUNNING
  /// A model of `IntrinsicTriangulationWalker`.
  using Walker = unspecified_type;
#else
  using Walker = internal::Placed_halfedge<internal::Halfedge_store<Input_mesh, Traits, Metric>>;
#endif

  /// \name The input
  /// @{

  /// Returns a view of the input mesh in which vertices and halfedges are numbered by consecutive integers.
  const Input_mesh& input() const { return m_halfedges.input(); }
  /// Returns the metric, which defines the lengths of the input edges.
  const Metric& metric() const { return m_halfedges.metric(); }
  /// Returns the traits.
  const Traits& traits() const { return m_halfedges.traits(); }

  /// Returns the number of vertices, including inserted ones.
  Index number_of_vertices() const { return m_halfedges.number_of_vertices(); }
  /// Returns the number of halfedges, twice the number of edges.
  Index number_of_halfedges() const { return 2 * number_of_edges(); }
  /// Returns the number of edges, including those created by insertions. Flips do not change this number.
  Index number_of_edges() const { return m_halfedges.number_of_edges(); }

  /// Returns the vertex that corresponds to vertex `v` of the input mesh, or `null_index` if `v` is not a vertex of the
  /// mesh.
  Vertex_index index(Mesh_vertex v) const { return input().index(v); }
  /// Returns the halfedge with the number that `input().index(h)` returns, or `null_index` if `h` is not a halfedge of
  /// the mesh or was removed by the contraction of degenerate edges. The two halfedges correspond as long as the edge
  /// has been neither flipped nor split.
  Halfedge_index index(Mesh_halfedge h) const { return internal::as_intrinsic(input().index(h)); }

  /// Returns the vertex of the input mesh that corresponds to `v`. \pre `v` was not inserted
  Mesh_vertex vertex(Vertex_index v) const { return input().vertex(v); }

  /// Returns the halfedge of the mesh that has the number of `h` in `input()`. \pre `h` was not created by an insertion
  Mesh_halfedge input_halfedge(Halfedge_index h) const { return input().halfedge(internal::as_input(h)); }

  /// @}
  /// \name Connectivity
  /// The functions of this group take constant time. The face on the left of a halfedge is copied from the input when
  /// it is first accessed. This access throws `Invalid_mesh_error` if the face is not a triangle or if the edge of the
  /// halfedge does not belong to a face. It throws `Degenerate_face_error` if an edge of the face has length zero or if
  /// the edge lengths violate the triangle inequality, and `Invalid_coordinate_error` if a coordinate is not finite or
  /// if a length is outside [1e-70, 1e70].
  /// @{

  /// Returns the opposite halfedge of `h`.
  static Halfedge_index twin(Halfedge_index h) { return internal::twin_index(h); }
  /// Returns the edge of `h`.
  static Edge_index edge(Halfedge_index h) { return internal::edge_of(h); }

  /// Returns the next halfedge around the face of `h`. \pre `h` is not on the border
  Halfedge_index next(Halfedge_index h) const { return m_halfedges.halfedge(record(h).next()); }
  /// Returns the previous halfedge around the face of `h`. \pre `h` is not on the border
  Halfedge_index previous(Halfedge_index h) const { return m_halfedges.halfedge(m_halfedges[record(h).next()].next()); }
  /// Returns the vertex at which `h` starts.
  Vertex_index tail(Halfedge_index h) const { return record(h).tail; }
  /// Returns the vertex at which `h` ends.
  Vertex_index head(Halfedge_index h) const { return record(twin(h)).tail; }
  /// Returns whether `h` has no face on its left.
  bool is_border(Halfedge_index h) const { return record(h).is_border(); }

  /// Returns the next halfedge clockwise around the tail of `h`, or `null_index` if the border comes first.
  Halfedge_index clockwise(Halfedge_index h) const
  {
    const Record& at_t = record(twin(h));
    return at_t.is_border() ? null_index : m_halfedges.halfedge(at_t.next());
  }

  /// Returns the next halfedge counterclockwise around the tail of `h`, or `null_index` if the border comes first.
  Halfedge_index counterclockwise(Halfedge_index h) const { return is_border(h) ? null_index : twin(previous(h)); }

  /// Returns a walker positioned at `h`.
  Walker walker(Halfedge_index h) const { return Walker(m_halfedges, m_halfedges.taken(h)); }
  /// Returns a walker positioned at `h`, given the `place()` of a walker at `h` or at the twin of `h`.
  Walker walker(typename Walker::Place place, Halfedge_index h) const
  {
    return Walker(m_halfedges, internal::side_slot(place, h));
  }

  /// Prefetches the face on the left of `h` into the cache of the processor, without any other effect.
  void prefetch_face(Halfedge_index h) const { m_halfedges.prefetch_face(m_halfedges.slot(h)); }

  /// Returns a halfedge that starts at `v`, or `null_index` for an isolated vertex.
  Halfedge_index outgoing(Vertex_index v) const { return m_halfedges.outgoing(v); }

  /// @}
  /// \name Geometry
  /// @{

  /// Returns the data that the traits store for a halfedge, in the coordinate frame of the face of the halfedge. \pre
  /// `h` is not on the border
  const Halfedge_geometry& geometry(Halfedge_index h) const { return record(h).geometry; }

  /// Returns the squared length of the edge of `h`, in the number type of the traits.
  FT squared_length(Halfedge_index h) const
  {
    return traits().compute_squared_length_object()(geometry(is_border(h) ? twin(h) : h));
  }

  /// Returns the length of the edge of `h`, rounded to double.
  double length(Halfedge_index h) const
  {
    return traits().compute_length_object()(geometry(is_border(h) ? twin(h) : h));
  }

  /*!
   * Extends `turn`, a clockwise rotation around the tail of `h`, by the angle at the tail in the face on the right of
   * `h`.
   * \return the next halfedge clockwise, or `null_index` if the border comes first; in that case `turn` is unchanged
   */
  Halfedge_index extend_turn_clockwise(Turn& turn, Halfedge_index h) const
  {
    const Walker next = walker(h).extend_turn_clockwise(turn);
    return next.is_none() ? null_index : next.index();
  }

  /// Extends `turn` by the angle at the head of `h`, from `twin(h)` clockwise to `next(h)`. \pre `h` is not on the
  /// border
  void extend_turn(Turn& turn, Halfedge_index h) const { walker(h).extend_turn(turn); }

  /// @}
  /// \name Held edges
  /// A held edge cannot be flipped. A network places one hold on each edge on which it has segments. The functions of
  /// this group take constant time.
  /// @{

  /// Returns the number of holds on edge `e`, initially 0.
  Index holds(Edge_index e) const { return m_halfedges.holds(m_halfedges.slot(internal::first_side(e))); }
  /// Adds a hold on edge `e`.
  void hold(Edge_index e) { m_halfedges.hold(m_halfedges.taken(internal::first_side(e))); }
  /// Removes a hold on edge `e`. \pre `holds(e) > 0`
  void release(Edge_index e) { m_halfedges.release(m_halfedges.slot(internal::first_side(e))); }
  /// Returns the total number of holds on all edges.
  std::size_t number_of_holds() const { return m_halfedges.number_of_holds(); }

  /// Returns a number that is greater than the values of `Walker::edge_place()` for all walkers. It grows with the
  /// number of edges that have been accessed.
  std::size_t number_of_edge_places() const { return m_halfedges.number_of_edge_places(); }

  /// @}

  /// Returns whether all accessed elements are consistent, as `is_valid(double)` does with a tolerance of 1e-9.
  bool is_valid() const { return is_valid(internal::default_validity_tolerance); }

  /*!
   * Returns whether all accessed elements are consistent. They are consistent if every face has three halfedges, no
   * side of a face is longer than the sum of the other two, and the two halfedges of each edge have the same end points
   * and the same length. Lengths are compared with a tolerance of `tolerance` times the longest side of the face.
   * Complexity: linear in the size of the mesh.
   */
  bool is_valid(double tolerance) const
  {
    for(Halfedge_index h : internal::descriptors<Halfedge_index>(number_of_halfedges()))
      if(m_halfedges[m_halfedges.slot(h)].is_known() && !is_border(h) &&
         !internal::is_valid_halfedge(*this, h, tolerance, m_halfedges[m_halfedges.slot(twin(h))].is_known()))
        return false;
    return true;
  }

#ifndef DOXYGEN_RUNNING
protected:
  using Store = internal::Halfedge_store<Input_mesh, Traits, Metric>;

  Intrinsic_triangulation_elements(const Input_mesh& input, const Metric& metric, const Traits& traits)
    : m_halfedges(input, metric, traits)
  {
  }

  Intrinsic_triangulation_elements(Intrinsic_triangulation_elements&&) noexcept = default;
  Intrinsic_triangulation_elements& operator=(Intrinsic_triangulation_elements&&) noexcept = default;

  Store& store() const { return m_halfedges; }
#endif

private:
  using Record = typename Store::Record;

  // The face is known after this call.
  const Record& record(Halfedge_index h) const { return m_halfedges.known(h); }

  mutable Store m_halfedges;
};

/// \ingroup PkgFlipGeodesicsMetrics
/// The default metric, which is defined by the points of the mesh.
template <class TriangleMesh>
using Default_metric =
    Embedded_metric<TriangleMesh, typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>;

#ifdef DOXYGEN_RUNNING
/// \ingroup PkgFlipGeodesicsTraits
/// The default traits for a metric: `Certified_intrinsic_triangulation_traits` of the kernel of the metric. For a
/// user-defined metric without `squared_length()`, the default is `Intrinsic_triangulation_traits` in double.
template <class Metric>
using Default_traits = unspecified_type;
#else
template <class Metric>
using Default_traits = std::conditional_t<internal::has_exact_faces<Metric>,
                                          Certified_intrinsic_triangulation_traits<typename Metric::Kernel>,
                                          Intrinsic_triangulation_traits<typename Metric::Kernel, double>>;
#endif

/// \ingroup PkgFlipGeodesicsCurves
/// Specifies how a triangulation treats degenerate edges.
enum class Zero_length_edges {
  REFUSE, ///< `Degenerate_face_error` is thrown when a face with a degenerate (zero-length) edge is accessed
  /// the two ends of each degenerate edge are merged into one vertex, and faces with a degenerate edge are removed; if
  /// two degenerate faces share their longest edge and the vertices opposite to this edge coincide, these two vertices
  /// are merged as well, and both faces are removed
  CONTRACT
};

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * Represents an intrinsic triangulation of a triangle mesh. Its edges connect the vertices of the mesh, are straight on
 * the surface, and can be flipped without changing the surface \cgalCite{SC20,section 3.1}.
 *
 * The triangulation is a \f$\Delta\f$-complex: an edge can be a loop, two edges can have the same two end points, a
 * vertex can have degree 1, and a face can be glued to itself. Elements are therefore identified by their indices,
 * never by their vertices. The index of a vertex of the mesh is its position in `vertices(mesh)`, unless degenerate
 * edges have been contracted. Edge `e` has the halfedges `2e` and `2e+1`. Until the first flip or insertion, each edge
 * and each halfedge is that of the input with the same index. A flipped edge keeps its index. Points of the surface can
 * be inserted as further vertices, whose indices follow those of the existing vertices.
 *
 * \attention The mesh and its points must outlive the triangulation and must not be changed.
 *
 * The triangulation satisfies the following invariant. Up to rounding errors, no side of a face is longer than the sum
 * of the other two, and the two halfedges of an edge have the same length. The normal coordinates of the edges (see
 * `crossings()`) are consistent with the input edges. `is_valid()` checks the invariant, except for the normal
 * coordinates.
 *
 * Several threads may call `const` member functions concurrently if the mesh and its points can be read concurrently.
 * These functions copy faces of the input and cache derived data. Statistics, sizes and positions in memory, and the
 * halfedge that `outgoing()` returns can depend on which faces have been accessed before; other results do not. While
 * one thread calls a member function that is not `const`, changes a network in the triangulation, or adds or releases a
 * hold through a walker, no other thread may use the triangulation.
 *
 * \cgalModels{IntrinsicTriangulationOfMesh}
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, triangulated and oriented; several umbrellas
 *         may meet at a vertex. A `Surface_mesh` must not contain removed vertices or edges
 * \tparam Traits_ a model of `IntrinsicTriangulationTraits`; by default `Certified_intrinsic_triangulation_traits` of
 *         the kernel of the points. If `Metric_` is not the default metric, use `Default_traits<Metric_>`
 * \tparam Metric_ a model of `IntrinsicMetric`; by default the metric defined by the points of the mesh
 */
template <class TriangleMesh, class Traits_ = Default_traits<Default_metric<TriangleMesh>>,
          class Metric_ = Default_metric<TriangleMesh>>
class Intrinsic_triangulation : public Intrinsic_triangulation_elements<TriangleMesh, Traits_, Metric_>
{
  using Elements = Intrinsic_triangulation_elements<TriangleMesh, Traits_, Metric_>;
  using Store = typename Elements::Store;

public:
  using Traits = Traits_;                                       ///< the type of the traits
  using Metric = Metric_;                                       ///< the type of the metric
  using Input_mesh = typename Elements::Input_mesh;             ///< the type of the numbered input
  using Halfedge_geometry = typename Traits::Halfedge_geometry; ///< the data that the traits store for a halfedge
  using Turn = typename Traits::Turn;       ///< the type of a rotation around a vertex, defined by the traits
  using Walker = typename Elements::Walker; ///< a model of `IntrinsicTriangulationWalker`

#ifdef DOXYGEN_RUNNING
  /// An entry of the flip log; see `IntrinsicTriangulationOfMesh::Flip_record`.
  using Flip_record = unspecified_type;
#else
  using Flip_record = internal::Flip_record<Halfedge_geometry>;
#endif

  /// A position in the flip log, to which the triangulation can be rolled back.
  using Log_position = std::size_t;

  using Elements::edge, Elements::geometry, Elements::holds, Elements::input, Elements::is_border, Elements::next,
      Elements::traits, Elements::twin, Elements::walker;

  /// \name Construction
  /// @{

  /// Constructs the triangulation of a mesh. The metric is the one that the points of the mesh define. Complexity:
  /// constant for a `Surface_mesh`, and \cgalBigO{n \log n} for other meshes, where \f$n\f$ is the size of the mesh.
  /// \throws Invalid_mesh_error if the mesh has too many elements, contains removed vertices or edges, or has a
  ///         halfedge without a next halfedge
  explicit Intrinsic_triangulation(const TriangleMesh& mesh, const Traits& traits = Traits())
    : Intrinsic_triangulation(mesh, Metric(get(CGAL::vertex_point, mesh)), traits)
  {
  }

  /// Constructs the triangulation of a mesh with a given metric. Complexity: constant for a `Surface_mesh`, and
  /// \cgalBigO{n \log n} for other meshes, where \f$n\f$ is the size of the mesh.
  /// \throws Invalid_mesh_error if the mesh has too many elements, contains removed vertices or edges, or has a
  ///         halfedge without a next halfedge
  /// \throws Input_mismatch_error if the metric detects that it was made for another mesh
  Intrinsic_triangulation(const TriangleMesh& mesh, const Metric& metric, const Traits& traits = Traits())
    : Elements(checked_input(mesh, metric), metric, traits)
  {
  }

  /*!
   * Constructs the triangulation of a mesh with a given metric. The argument `zero_length_edges` specifies how
   * degenerate edges are treated.
   *
   * If `zero_length_edges` is `Zero_length_edges::CONTRACT`, the input of the triangulation is the contracted surface.
   * Of the vertices that are merged at a point, one represents all of them, and the others become isolated unless
   * several umbrellas meet at this point (see below). If a face has exactly one degenerate edge, the other two edges of
   * the face become one edge. For an element of the mesh, `index()` returns the corresponding element of the
   * triangulation; for a halfedge that no longer exists, it returns `null_index`. `input_halfedge()` returns one of the
   * halfedges of the mesh that correspond to its argument. If several umbrellas of the contracted surface meet only at
   * a point, each of them has its own vertex at this point, so the umbrellas are not connected at this point.
   *
   * If the mesh has neither degenerate edges nor pairs of degenerate faces as described at
   * `Zero_length_edges::CONTRACT`, the result is the same as with `Zero_length_edges::REFUSE`.
   *
   * \throws Invalid_mesh_error if the mesh has too many elements, contains removed vertices or edges, or has a
   *         halfedge without a next halfedge
   * \throws Degenerate_face_error if edges are contracted, and either a face has a zero-length edge and two other edges
   *         of different lengths, or the number of umbrellas that meet at a point exceeds the number of vertices at
   *         this point
   * \throws Input_mismatch_error if the metric detects that it was made for another mesh
   *
   * Complexity: constant for a `Surface_mesh`, and \cgalBigO{n \log n} for other meshes, where \f$n\f$ is the size of
   * the mesh. If `zero_length_edges` is `Zero_length_edges::CONTRACT`, construction takes additional time, usually
   * linear in the size of the mesh.
   */
  Intrinsic_triangulation(const TriangleMesh& mesh, const Metric& metric, const Traits& traits,
                          Zero_length_edges zero_length_edges)
    : Elements(make_input(mesh, metric, zero_length_edges), metric, traits)
  {
  }

  /*!
   * Moves a triangulation in constant time. Afterwards, `other` can only be assigned to or destroyed. A network of
   * `other` that has curves must not be destroyed, but must be moved to the new triangulation by the constructor of
   * `Edge_path_network` from a network and a triangulation. All other networks, walkers, trees and shorteners of
   * `other` still refer to `other` and can only be destroyed.
   */
  Intrinsic_triangulation(Intrinsic_triangulation&& other) noexcept = default;
  /// Moves `other` into this triangulation. The consequences for `other` are those described for the move constructor.
  /// \pre no network has curves in this triangulation
  Intrinsic_triangulation& operator=(Intrinsic_triangulation&& other) noexcept = default;

  /// @}
  /// \name Geometry
  /// @{

  /// Replaces the geometry of the face on the left of `h` by a more accurate geometry, whose first halfedge is `h`. The
  /// old geometry is recorded in the flip log.
  void set_face_geometry(Halfedge_index h, const typename Traits::Face_geometry& geometry)
  {
    m_log.lay_out(store(), h, geometry);
  }

  /*!
   * Returns whether `turn`, the angle clockwise around a vertex from halfedge `from` to halfedge `to`, is at least
   * \f$\pi\f$. If `from == to`, `turn` is the total angle at the vertex.
   * \pre `turn` consists of at least one corner; without its last corner, its angle is at most \f$\pi\f$
   */
  bool is_straight(const Turn& turn, Halfedge_index from, Halfedge_index to) const
  {
    const Uncertain<Comparison_result> comparison = traits().compare_turn_with_straight_object()(turn);
    if constexpr(!Traits::Has_drift::value)
      if(!comparison.is_certain())
        return compare_with_straight(from, to) != SMALLER;
    return comparison.make_certain() != SMALLER;
  }

  /// Returns how many filter failures have occurred in predicates of the triangulation since its construction, and how
  /// these failures were resolved.
  Decision_statistics decision_statistics() const { return m_decisions.statistics(); }

  /// Returns whether the two angles at the head of `h`, in the faces on both sides of `h`, sum to at least \f$\pi\f$.
  /// \pre both faces exist
  bool is_reflex_at_head(Halfedge_index h) const { return is_reflex_at_head(walker(h)); }
  /// Returns whether the two angles at the head of the halfedge of walker `h`, in the faces on both sides of this
  /// halfedge, sum to at least \f$\pi\f$. \pre both faces exist
  bool is_reflex_at_head(const Walker& h) const
  {
    Turn turn;
    const auto [from, to] = h.extend_turn_at_head(turn);
    return is_straight(turn, from.index(), to.index());
  }

  /*!
   * Returns whether the edge of `h` is locally Delaunay: it is on the border, or the sum of the two angles opposite to
   * the edge is at most \f$\pi\f$. An edge that is not locally Delaunay can be flipped unless it is held, and is
   * locally Delaunay after the flip.
   *
   * The result is exact if the predicates of the traits are exact. With inexact predicates, an edge also counts as
   * locally Delaunay if the sum exceeds \f$\pi\f$ by less than the tolerance of the traits. Repeatedly flipping edges
   * that are not locally Delaunay, in any order, therefore terminates as long as the drift of the geometry stays below
   * this tolerance.
   */
  bool is_locally_delaunay(Halfedge_index h) const
  {
    const Halfedge_index t = twin(h);
    if(is_border(h) || is_border(t) || next(h) == t || next(t) == h)
      return true; // at a vertex of degree 1, the opposite angles are the base angles of an isosceles face
    const Halfedge_index hn = next(h), hp = next(hn), tn = next(t), tp = next(tn);
    const Uncertain<bool> result = traits().is_locally_delaunay_object()(geometry(h), geometry(hn), geometry(hp),
                                                                         geometry(t), geometry(tn), geometry(tp));
    if constexpr(!Traits::Has_drift::value)
      if(!result.is_certain()) {
        Decision_statistics statistics;
        const Comparison_result comparison =
            internal::Wedge_comparison<Intrinsic_triangulation>(*this, statistics, true)
                .compare_sum({twin(hn), hp}, {twin(tn), tp});
        m_decisions.add(statistics);
        return comparison != LARGER;
      }
    return result.make_certain();
  }

  /// @}
  /// \name Flips
  /// @{

  /// Returns whether the edge of `h` can be flipped \cgalCite{SC20,section 3.1.3}: it is not held, both its ends have a
  /// degree greater than 1, and its two faces exist and form a strictly convex quadrilateral.
  bool is_flippable(Halfedge_index h) const
  {
    const Halfedge_index t = twin(h);
    if(is_border(h) || is_border(t) || next(h) == t || next(t) == h || holds(edge(h)) > 0)
      return false;
    return !is_reflex_at_head(h) && !is_reflex_at_head(t);
  }

  /*!
   * Flips the edge of `h`. Let \f$a\f$ be the third vertex of the face of `twin(h)`, and \f$b\f$ the third vertex of
   * the face of `h`. After the flip, `h` leads from \f$a\f$ to \f$b\f$.
   *
   * A flip takes constant time, unless the traits require that a face be recomputed from the input. If an exception is
   * thrown, such as `std::bad_alloc`, the triangulation is unchanged.
   * \pre `is_flippable(h)`
   */
  void flip(Halfedge_index h) { refresh_inaccurate(m_log.flip(store(), h)); }

  /// Returns the number of entries of the flip log, that is, of flips, insertions and recomputed faces that have not
  /// been rolled back.
  Log_position log_position() const { return m_log.size(); }

  /*!
   * Returns the number of bytes used by the records of changes: the flip log, the inserted points, and cached edge
   * sequences and vectors.
   *
   * With `Certified_intrinsic_triangulation_traits`, each flip takes about 165 bytes and at most 200 bytes, and the
   * records take a few megabytes in addition. Faces of the input are cached if the vectors that the triangulation
   * stores are too inaccurate to determine a sign; each cached face takes about 260 bytes. With
   * `Intrinsic_triangulation_traits` in double, each flip takes about 100 bytes. Memory that number types allocate,
   * such as the digits of rational numbers, is not included.
   *
   * `rollback()` frees the memory of all entries that it undoes, except for a few megabytes that are kept for reuse.
   * Cached faces of the input remain cached.
   *
   * Complexity: constant.
   */
  std::size_t memory_of_records() const
  {
    return m_log.memory() + m_points.size() * sizeof(internal::Inserted_point<Halfedge_geometry>) + m_history.memory();
  }

  /// Undoes flips and insertions in reverse order until the flip log has `position` entries. The connectivity and the
  /// geometry that the triangulation had at this position are restored bitwise. The halfedges that `outgoing()` returns
  /// can differ from the former ones. Complexity: linear in the number of undone entries. \pre no network has a curve
  /// on an edge that the rollback changes, except for curves that are removed before they are used again
  void rollback(Log_position position = 0)
  {
    if(m_log.size() > position)
      m_decisions.forget_flips();
    while(m_log.size() > position) {
      m_history.forget(edge(m_log.back().h), static_cast<Index>(m_log.size()));
      if(m_log.back().is_insertion())
        editor().take_back();
      else
        m_log.take_back(store());
    }
  }

  /// Returns entry `i` of the flip log. \pre `i < log_position()`
  const Flip_record& flip_record(Log_position i) const { return m_log[i]; }

  /// @}
  /// \name Points of the surface as vertices
  /// @{

  /// Returns whether vertex `v` was inserted, that is, is not a vertex of the input.
  bool is_inserted(Vertex_index v) const { return v.idx() >= input().number_of_vertices(); }

  /*!
   * Returns the location of vertex `v` on the input in a canonical form. An input vertex is represented by a halfedge
   * that starts at the vertex, and the weights (1, 0, 0). A point on an edge is represented by the first halfedge of
   * the edge, or by the second one if the first is a border halfedge; the third weight is zero. A point inside a face
   * is represented by the lowest-numbered halfedge of the face.
   * \pre `v` is not isolated
   */
  Surface_location location(Vertex_index v) const
  {
    if(is_inserted(v))
      return m_points[static_cast<std::size_t>(v.idx() - input().number_of_vertices())].location;
    return internal::canonical_location(input(), {input().outgoing(v), {{1, 0, 0}}});
  }

  /*!
   * Inserts a point of the surface as a vertex. The face or edge that contains the point is split.
   *
   * The face or edge that contains the point is determined exactly, and the edge sequences of the new edges are
   * correct, even if the geometry is rounded. If inexact predicates have caused incorrect flips, it is possible that no
   * face contains the point. In this case the point is inserted on the nearest edge, provided that rounding errors can
   * explain the distance of the point from this edge.
   *
   * An insertion can be undone by `rollback()`.
   *
   * \param location any point of the surface
   * \return the new vertex, or the existing one at the point
   * \throws Invalid_location_error if `location` is not a point of the surface
   * \throws Insertion_error if rounding errors have caused incorrect flips around the point, if the point is too close
   *         to a vertex to be distinguished from it, or if the number type of the traits is exact and edges around the
   *         point have been flipped; in each of these cases the triangulation is unchanged
   * \throws Occupied_triangulation_error if a curve lies on the edge that contains the point; in this case the
   *         triangulation is unchanged. Use `Edge_path_network::insert()` to split such an edge
   * \throws Degenerate_face_error if a visited face has a degenerate edge or violates the triangle inequality
   * \throws Invalid_coordinate_error if a visited face has a coordinate or length that is not finite or is out of range
   *
   * Complexity: linear in the total length of the edge sequences of all edges that cross the input face of the point.
   * If the edges at the corners of this input face have been flipped, the function takes additional time linear in the
   * degree of one of these corners. In a part of the triangulation without flips, it takes constant time.
   */
  Vertex_index insert(const Surface_location& location)
  {
    return insert(location, [&](const internal::Edge_halves& halves) {
      if(holds(edge(halves.first)) > 0)
        internal::throw_naming<Occupied_triangulation_error>(
            "a point in the face of halfedge ", location.halfedge,
            " lies on an edge of a curve; use Edge_path_network::insert()");
    });
  }

  /*!
   * Inserts a point of the surface as `insert(location)` does, and calls `on_split` if the insertion splits an edge.
   * This edge can be held; the function itself does not throw `Occupied_triangulation_error`.
   *
   * The argument of `on_split` is an object with two halfedges as members: `first` is the halfedge that was split,
   * which now ends at the new vertex, and `second` leads from the new vertex to the former head of `first`. If
   * `on_split` throws, the insertion is undone.
   */
  template <class OnSplit>
  Vertex_index insert(const Surface_location& location, const OnSplit& on_split)
  {
    return insert_found(location, on_split,
                        [&](const auto& locate, const Surface_location& point) { return locate(point); });
  }

  /*!
   * Splits the edge of `h` at a point that lies on the edge up to rounding errors. Afterwards, the point is regarded as
   * lying exactly on the edge.
   *
   * \param h a halfedge of the edge
   * \param gap the number of edges in `edge_sequence(h)` that `h` crosses before it reaches the input face that
   *        contains the point
   * \param location the point, in this input face. It can lie on an input edge only if the edge of `h` is a part of
   *        this input edge
   * \param on_split a function object, as for `insert()`
   * \return the new vertex
   * \throws Insertion_error as `insert()` does
   * \throws Invalid_location_error as `insert()` does
   * \throws Degenerate_face_error as `insert()` does
   * \throws Invalid_coordinate_error as `insert()` does
   */
  template <class OnSplit>
  Vertex_index split_edge(Halfedge_index h, const Surface_location& location, std::size_t gap, const OnSplit& on_split)
  {
    if(is_border(h))
      h = twin(h); // an input edge, which crosses nothing
    return internal::insert_point(*this, editor(), {h, gap, true, null_index},
                                  internal::canonical_location(input(), location), on_split);
  }

  /*!
   * Splits the face on the left of `h` at a point inside this face.
   *
   * \param h a halfedge of the face
   * \param gap the number of edges in `edge_sequence(h)` that `h` crosses before it reaches the input face that
   *        contains the point
   * \param location the point, in this input face
   * \return the new vertex
   * \throws Insertion_error as `insert()` does
   * \throws Invalid_location_error as `insert()` does
   * \throws Degenerate_face_error as `insert()` does
   * \throws Invalid_coordinate_error as `insert()` does
   */
  Vertex_index split_face(Halfedge_index h, const Surface_location& location, std::size_t gap)
  {
    return internal::insert_point(*this, editor(), {h, gap, false, null_index},
                                  internal::canonical_location(input(), location), [](const auto&) {});
  }

  /// @}
  /// \name Correspondence with the input
  /// @{

  /// Returns the normal coordinate of edge `e` \cgalCite{GSC21}: the number of input edges that the edge crosses, or -1
  /// if the edge is an input edge or a part of an input edge.
  Index crossings(Edge_index e) const { return store().crossings(store().slot(internal::first_side(e))); }

  /*!
   * Returns the sequence of input edges that halfedge `h` crosses, from its tail to its head. The sequence is exact,
   * since it is computed with integers only \cgalCite{GSC21,section 3}.
   *
   * A sequence is computed when it is first requested, and then stored. If the stored sequences take too much memory,
   * the least recently used ones are discarded.
   *
   * Complexity: linear in the length of the sequence if the sequence is stored. Other sequences are computed from the
   * normal coordinates: the crossed input edges are followed through the faces of the triangulation until each of them
   * separates from the next one or meets it at a common vertex. This takes time linear in the number of these faces
   * plus the degree of the tail.
   *
   * If points have been inserted, or if flips have replaced all input edges at both ends of `h`, a sequence that is not
   * stored is derived from the flip log instead. This takes time linear in the total length of the sequences of the
   * edges that flips and insertions have successively replaced to produce this edge, not counting stored sequences.
   *
   * \throws Insertion_error if inserted points near a vertex are too close together to be distinguished
   */
  Edge_sequence edge_sequence(Halfedge_index h) const { return m_history.sequence(*this, h); }

  /// Returns the version of edge `e`. If `e` is an input edge that has not been changed, the version is 0. Otherwise,
  /// it is one more than the position of the last entry of the flip log that changed the edge.
  Index version(Edge_index e) const { return store().version(store().slot(internal::first_side(e))); }

  /*!
   * Returns the number of input edges that start at the common tail of `from` and `to` and lie strictly inside the
   * wedge between these halfedges. The wedge extends clockwise from `from` to `to`; if `from == to`, it extends once
   * around the vertex. Complexity: linear in the number of edges in the wedge. \pre the wedge does not contain the
   * border
   */
  Index input_edges_in_wedge(Halfedge_index from, Halfedge_index to) const
  {
    Index count = 0;
    for(Halfedge_index h = from;;) {
      const Halfedge_index t = twin(h), tn = next(t);
      const internal::Triangle_crossings corner(crossings(edge(next(tn))), crossings(edge(t)), crossings(edge(tn)));
      count += corner.emanating[0];
      h = tn;
      if(h == to)
        return count;
      count += crossings(edge(h)) < 0 ? 1 : 0;
    }
  }

  /// @}

private:
  friend struct internal::Internals<Intrinsic_triangulation>;
  using Elements::store;

  static Input_mesh checked_input(const TriangleMesh& mesh, const Metric& metric)
  {
    Input_mesh input(mesh);
    internal::check_input(metric, input);
    return input;
  }

  static Input_mesh make_input(const TriangleMesh& mesh, const Metric& metric, Zero_length_edges zero_length_edges)
  {
    Input_mesh input = checked_input(mesh, metric);
    if(zero_length_edges == Zero_length_edges::REFUSE)
      return input;
    return internal::contracted(input, internal::Contracted_metric<Metric>{metric, input});
  }

  Comparison_result compare_with_straight(Halfedge_index from, Halfedge_index to) const
  {
    const internal::Side_version a = {from, version(edge(from))}, b = {to, version(edge(to))};
    return m_decisions.compare(a, b, [&](Decision_statistics& statistics) {
      return internal::Wedge_comparison<Intrinsic_triangulation>(*this, statistics, true)(from, to);
    });
  }

  // `search(locator, point)` determines where the point lies.
  template <class OnSplit, class Search>
  Vertex_index insert_found(const Surface_location& location, const OnSplit& on_split, const Search& search)
  {
    const Surface_location point = internal::canonical_location(input(), location);
    if(kind(point) == Location_kind::VERTEX)
      return input().tail(point.halfedge);
    Decision_statistics statistics;
    const internal::Point_locator<Intrinsic_triangulation> locate(*this, statistics);
    const internal::Located_point place = search(locate, point);
    m_decisions.add(statistics);
    if(place.vertex != null_index)
      return place.vertex;
    return internal::insert_point(*this, editor(), place, point, on_split);
  }

  internal::Insertion_editor<Intrinsic_triangulation, Store> editor()
  {
    return {*this, store(), m_log, m_points, m_history};
  }

  // Is called after a flip, which is undone if this fails.
  void refresh_inaccurate(const std::array<internal::Slot, 4>& changed)
  {
    const Log_position before = log_position() - 1;
    try {
      for(internal::Slot s : changed)
        if(traits().is_inaccurate_object()(store()[s].geometry))
          internal::refresh_face(*this, store().halfedge(s));
    } catch(...) {
      rollback(before);
      throw;
    }
  }

  internal::Edge_history<Intrinsic_triangulation> m_history;
  internal::Remembered_decisions m_decisions;
  internal::Flip_log<Store> m_log;
  std::vector<internal::Inserted_point<Halfedge_geometry>> m_points;
};

namespace internal {

/* Results of expensive predicates are cached, because such predicates occur in clusters. */
template <class TriangleMesh, class Traits, class Metric>
struct Internals<Intrinsic_triangulation<TriangleMesh, Traits, Metric>>
{
  using Triangulation = Intrinsic_triangulation<TriangleMesh, Traits, Metric>;

  static constexpr bool has_exact_faces = true;
  static constexpr bool has_precise_numbers = true;

  static const Exact_face& exact_face(const Triangulation& t, Input_halfedge_index h)
  {
    return t.m_history.exact_face(t, h);
  }

  static const Precise_halfedge& precise_halfedge(const Triangulation& t, Input_halfedge_index h)
  {
    return t.m_history.input_halfedge(t, h);
  }

  /* Returns the edge of h in double-double arithmetic if its ends are input vertices. */
  static Precise_edge precise_edge(const Triangulation& t, Halfedge_index h) { return t.m_history.edge(t, h); }

  static Flat_edges& flat_edges(const Triangulation& t)
  {
    return t.m_decisions.flat_edges(static_cast<std::size_t>(t.input().number_of_halfedges() / 2));
  }

  /* Inserts a point close to a known piece, so that the search visits fewer edges in the input face. */
  template <class OnSplit>
  static Vertex_index insert(Triangulation& t, const Surface_location& location, const OnSplit& on_split,
                             Known_piece& close_by)
  {
    return t.insert_found(location, on_split,
                          [&](const auto& locate, const Surface_location& point) { return locate(point, close_by); });
  }
};

} // namespace internal

/// \ingroup PkgFlipGeodesicsExtraction
/// Describes a face of an intrinsic triangulation; halfedge `i` leads from vertex `i` to vertex `(i + 1) % 3`.
struct Intrinsic_face
{
  std::array<Vertex_index, 3> vertices;    ///< the vertices, counterclockwise around the face
  std::array<Halfedge_index, 3> halfedges; ///< the halfedges, counterclockwise around the face
  std::array<double, 3> lengths;           ///< the lengths of the halfedges, in the unit of the mesh, rounded to double
};

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Writes all faces of an intrinsic triangulation. The curves of all networks in the triangulation consist of edges of
 * these faces.
 *
 * Each face starts with its lowest-numbered halfedge, and the faces are ordered by these halfedges.
 *
 * \param triangulation a model of `IntrinsicTriangulation`
 * \param out an output iterator that receives objects of type `Intrinsic_face`
 * \return the past-the-end output iterator
 *
 * Complexity: linear in the size of the triangulation.
 */
template <class Triangulation, class OutputIterator>
OutputIterator intrinsic_faces(const Triangulation& triangulation, OutputIterator out)
{
  for(Halfedge_index h : internal::descriptors<Halfedge_index>(triangulation.number_of_halfedges())) {
    if(triangulation.is_border(h))
      continue;
    const Halfedge_index hn = triangulation.next(h), hp = triangulation.next(hn);
    if(hn < h || hp < h)
      continue;
    *out++ = Intrinsic_face{{triangulation.tail(h), triangulation.tail(hn), triangulation.tail(hp)},
                            {h, hn, hp},
                            {triangulation.length(h), triangulation.length(hn), triangulation.length(hp)}};
  }
  return out;
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_H
