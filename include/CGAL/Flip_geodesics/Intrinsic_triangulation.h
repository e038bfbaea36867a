// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_H
#define CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_H

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Contracted_metric.h>
#include <CGAL/Flip_geodesics/internal/surface/Flat_edges.h>
#include <CGAL/Flip_geodesics/internal/surface/Internals.h>
#include <CGAL/Flip_geodesics/internal/surface/Zero_edge_contractor.h>
#include <CGAL/Flip_geodesics/internal/surface/graph_functions.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_history.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_straightness.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_insertion.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_locator.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Compared_wedges.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A halfedge of a triangulation, held by where the triangulation keeps it: for walks, whose steps each take a look into
 * the table of slots if they are made by index.
 *
 * The functions are those of `Intrinsic_triangulation`, and copy faces of the input as they do.
 */
template <class Store>
class Placed_halfedge
{
  using Record = typename Store::Record;
  using Turn = typename Store::Traits::Turn;

public:
  /* What a halfedge's place is kept in; default constructed it is none. */
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

  /* What clockwise() and counterclockwise() give where the border intervenes. */
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
    prefetch(&store()[store()[in.next()].next()]); // for flips, should it come to that
    return at(in.next());
  }

  void extend_turn(Turn& turn) const { extend_turn_over(turn, store().known(m_slot)); }

  /* Adds the angle at the head in the two faces of the edge; returns from where it leads, clockwise, and to where.
   * \pre both faces exist */
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

  // Adds the corner at the head of a halfedge whose face is known.
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
 * The elements of an intrinsic triangulation: how they are connected, how long they are, and which edges networks hold.
 * This is the base of `Intrinsic_triangulation`, which flips edges and inserts points.
 *
 * Template parameters are those of `Intrinsic_triangulation`.
 */
template <class TriangleMesh, class Traits_, class Metric_>
class Intrinsic_triangulation_elements
{
  static_assert(internal::are_triangulation_traits<Traits_>());

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
#ifdef DOXYGEN_RUNNING
  /// A model of `IntrinsicTriangulationWalker`.
  using Walker = unspecified_type;
#else
  using Walker = internal::Placed_halfedge<internal::Halfedge_store<Input_mesh, Traits, Metric>>;
#endif

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

  /// Checks the invariant with a tolerance of 1e-9.
  bool is_valid() const { return is_valid(internal::default_validity_tolerance); }

  /*!
   * Checks the invariant of all that has been touched: the links of faces, the closing of their vectors, the equal
   * lengths of an edge's two sides, relative to the longest edge of the face by `tolerance`. Linear in the mesh.
   */
  bool is_valid(double tolerance) const
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

/// \ingroup PkgFlipGeodesicsMetrics
/// The metric of a mesh unless another is given: that of its own points.
template <class TriangleMesh>
using Default_metric =
    Embedded_metric<TriangleMesh, typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>;

#ifdef DOXYGEN_RUNNING
/// \ingroup PkgFlipGeodesicsTraits
/// The traits for a metric unless others are given: `Certified_intrinsic_triangulation_traits` of the metric's kernel,
/// or, for a metric of one's own without `exact_face()`, `Intrinsic_triangulation_traits`.
template <class Metric>
using Default_traits = unspecified_type;
#else
template <class Metric>
using Default_traits = std::conditional_t<internal::Has_exact_faces<Metric>::value,
                                          Certified_intrinsic_triangulation_traits<typename Metric::Kernel>,
                                          Intrinsic_triangulation_traits<typename Metric::Kernel>>;
#endif

/// \ingroup PkgFlipGeodesicsCurves
/// What a triangulation makes of edges of length zero.
enum class Zero_length_edges {
  REFUSE,  ///< a face with such an edge throws `Degenerate_face_error` when it is touched
  CONTRACT ///< vertices that such edges join, or that faces without area fold onto one place, are one vertex, and faces
           ///< with such an edge and folded faces are gone
};

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * An intrinsic triangulation of a triangle mesh: the mesh's vertices, joined by straight edges *in* the surface, that
 * can be flipped without changing the surface [SC20, section 3.1].
 *
 * It is a true \f$\Delta\f$-complex: an edge may be a loop, two edges may share both end vertices, a vertex may have
 * degree 1, a face may be glued to itself. Elements are told apart by their indices, never by their vertices. Vertices
 * keep the indices of `vertices(mesh)`. Edge `e` has the halfedges `2e` and `2e+1`; both ids survive flips, and before
 * the first flip they are the input's. Points of the surface can be inserted as further vertices, with the next
 * indices.
 *
 * Faces of the input are copied when they are first touched. So construction takes constant time over a `Surface_mesh`,
 * and \f$O(n \log n)\f$ over other meshes, whose elements are numbered first. The mesh and its points must outlive the
 * triangulation, unchanged.
 *
 * The invariant: the vectors of a face close, the two sides of an edge have one length, and the crossing numbers of the
 * edges are those of the input edges (`is_valid()`).
 *
 * Several threads can call `const` members at once, if the mesh and its points can be read at once. They copy faces of
 * the input and keep what they derive all the same. Which halfedge `outgoing()` returns can depend on which faces were
 * read before; nothing else does. While one thread calls another member, changes a network in the triangulation or moves
 * a walker's hold, no other thread may use the triangulation.
 *
 * \cgalModels{IntrinsicTriangulationOfMesh}
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, triangulated, oriented and manifold; a
 *         `Surface_mesh` without removed vertices or edges
 * \tparam Traits_ a model of `IntrinsicTriangulationTraits`; by default `Certified_intrinsic_triangulation_traits` of
 *         the points' kernel, whatever kernel that is
 * \tparam Metric_ a model of `IntrinsicMetric`
 */
template <class TriangleMesh, class Traits_ = Default_traits<Default_metric<TriangleMesh>>,
          class Metric_ = Default_metric<TriangleMesh>>
class Intrinsic_triangulation : public Intrinsic_triangulation_elements<TriangleMesh, Traits_, Metric_>
{
  using Elements = Intrinsic_triangulation_elements<TriangleMesh, Traits_, Metric_>;
  using Store = typename Elements::Store;

public:
  using Traits = Traits_;                                       ///< the template parameter
  using Metric = Metric_;                                       ///< the template parameter
  using Input_mesh = typename Elements::Input_mesh;             ///< the input, numbered
  using Halfedge_geometry = typename Traits::Halfedge_geometry; ///< what the traits store of a halfedge
  using Turn = typename Traits::Turn;                           ///< a rotation about a vertex, of the traits
  using Walker = typename Elements::Walker;                     ///< a model of `IntrinsicTriangulationWalker`

#ifdef DOXYGEN_RUNNING
  /// What the log keeps of a flip, see `IntrinsicTriangulationOfMesh::Flip_record`.
  using Flip_record = unspecified_type;
#else
  using Flip_record = internal::Flip_record<Halfedge_geometry>;
#endif

  /// A position in the flip log, to roll back to.
  using Log_position = std::size_t;

  using Elements::edge, Elements::geometry, Elements::holds, Elements::input, Elements::is_border, Elements::next,
      Elements::traits, Elements::twin, Elements::walker;

  /// \name Construction
  /// @{

  /// Over an embedded mesh with the mesh's own points. Complexity: see the class.
  /// \throws Invalid_mesh_error if there are too many elements, or a `Surface_mesh` keeps removed vertices or edges
  explicit Intrinsic_triangulation(const TriangleMesh& mesh, const Traits& traits = Traits())
    : Intrinsic_triangulation(mesh, Metric(get(CGAL::vertex_point, mesh)), traits)
  {
  }

  /// Over a mesh with a metric. Complexity, exceptions: as above.
  Intrinsic_triangulation(const TriangleMesh& mesh, const Metric& metric, const Traits& traits = Traits())
    : Elements(Input_mesh(mesh), metric, traits)
  {
  }

  /*!
   * The same, and says what becomes of edges of length zero.
   *
   * If they are contracted, the input is the surface that is left: vertices in one place have the index of one of them,
   * the others are isolated; the edges that faces of no area lay between are one edge. `index()` tells where the
   * mesh's elements are, `null_index` if nothing is left of a halfedge, and `input_halfedge()` gives one of several.
   * Where sheets of the surface met in a point only, each has a vertex of its own, and no curve leads from one to
   * another. If there is no such edge, nothing differs. Linear in the mesh if edges are to be contracted.
   *
   * \throws Degenerate_face_error if a face has one edge of length zero and two of different lengths
   */
  Intrinsic_triangulation(const TriangleMesh& mesh, const Metric& metric, const Traits& traits,
                          Zero_length_edges zero_length_edges)
    : Elements(make_input(mesh, metric, zero_length_edges), metric, traits)
  {
  }

  /*!
   * Moves a triangulation, without copying anything of its size. What refers to `other`, such as networks, walkers, trees
   * and shorteners, still does so, and can only be destroyed; networks with curves not even that. An
   * `Edge_path_network` can be moved along, see its constructors. `other` can be assigned to and destroyed.
   */
  Intrinsic_triangulation(Intrinsic_triangulation&& other) noexcept = default;
  /// Moves a triangulation, as the constructor does. \pre no network has curves in the one that is assigned to
  Intrinsic_triangulation& operator=(Intrinsic_triangulation&& other) noexcept = default;

  /// @}
  /// \name Geometry
  /// @{

  /// Replaces the vectors of the face on the left of `h`, from `h` on, by more accurate ones. The log keeps the old
  /// ones.
  void set_face_geometry(Halfedge_index h, const typename Traits::Face_geometry& geometry)
  {
    m_log.lay_out(store(), h, geometry);
  }

  /*!
   * Is the turn, which leads clockwise about a vertex from halfedge `from` to halfedge `to`, at least \f$\pi\f$?
   * \pre the turn has at least one corner, and was below \f$\pi\f$ before the last one; `from == to` means all the way
   * round
   */
  bool is_straight(const Turn& turn, Halfedge_index from, Halfedge_index to) const
  {
    const Uncertain<Comparison_result> comparison = traits().compare_turn_with_straight_object()(turn);
    if constexpr(!Traits::Has_drift::value)
      if(!comparison.is_certain())
        return compare_with_straight(from, to) != SMALLER;
    return comparison.make_certain() != SMALLER;
  }

  /// How the decisions that were left open by the traits were taken, since construction.
  Decision_statistics decision_statistics() const { return m_decisions.statistics(); }

  /// Is the angle at the head of `h`, in the two faces of its edge, at least \f$\pi\f$? \pre both faces exist
  bool is_reflex_at_head(Halfedge_index h) const { return is_reflex_at_head(walker(h)); }
  /// The same, of a halfedge that a walker stands at.
  bool is_reflex_at_head(const Walker& h) const
  {
    Turn turn;
    const auto [from, to] = h.extend_turn_at_head(turn);
    return is_straight(turn, from.index(), to.index());
  }

  /*!
   * Is the edge of `h` locally Delaunay: on the border, or the two angles opposite to it together at most \f$\pi\f$? An
   * edge that is not can be flipped, and is locally Delaunay afterwards.
   *
   * Exact where the traits are. Otherwise four points count as cocircular up to the traits' tolerance, and Delaunay
   * then. So flipping what is not Delaunay, in any order, ends as long as drift stays below the tolerance.
   */
  bool is_locally_delaunay(Halfedge_index h) const
  {
    const Halfedge_index t = twin(h);
    if(is_border(h) || is_border(t) || next(h) == t || next(t) == h)
      return true; // at a vertex of degree 1, opposite are the base angles of an isosceles face
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

  /// Can the edge of `h` be flipped [SC20, section 3.1.3]: inside, in a convex quad, both ends of degree above 1, and
  /// not held?
  bool is_flippable(Halfedge_index h) const
  {
    const Halfedge_index t = twin(h);
    if(is_border(h) || is_border(t) || next(h) == t || next(t) == h || holds(edge(h)) > 0)
      return false;
    return !is_reflex_at_head(h) && !is_reflex_at_head(t);
  }

  /*!
   * Flips the edge of `h`: `h` leads from the apex of its twin's face to the apex of its own afterwards. Four flips of
   * one halfedge restore the connectivity. Constant time. If anything is thrown, `std::bad_alloc` above all, nothing
   * has changed.
   * \pre `is_flippable(h)`
   */
  void flip(Halfedge_index h) { refresh_inaccurate(m_log.flip(store(), h)); }

  /// The end of the flip log: the number of flips and insertions since the input, and of faces laid out afresh.
  Log_position log_position() const { return m_log.size(); }

  /*!
   * The bytes that the records of what was done take: the flip log, inserted points, and what was derived from the log
   * of crossings and, for exact decisions, of vectors. With `Certified_intrinsic_triangulation_traits` a flip takes
   * about 165 bytes, at most 200, besides some megabytes for all; with doubles about 100. Not counted is what numbers
   * own besides their own size, such as the digits of rationals. What `rollback()` takes back is free again, up to some
   * megabytes kept for reuse. Constant time.
   */
  std::size_t memory_of_records() const
  {
    return m_log.memory() + m_points.size() * sizeof(internal::Inserted_point<Halfedge_geometry>) + m_history.memory();
  }

  /// Takes flips and insertions back, the last first, until the log has `position` entries; bit for bit. Linear in what
  /// is undone. \pre no curve of any network lies on an edge that goes, or all such curves are removed before they are
  /// used
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

  /// Entry `i` of the flip log.
  const Flip_record& flip_record(Log_position i) const { return m_log[i]; }

  /// @}
  /// \name Points of the surface as vertices
  /// @{

  /// Was vertex `v` inserted? The others are the input's.
  bool is_inserted(Vertex_index v) const { return v.idx() >= input().number_of_vertices(); }

  /*!
   * Where vertex `v` is on the input, told in one way only: an input vertex by a halfedge that starts there, with
   * weights (1, 0, 0); a point of an edge by its first halfedge that is not on the border, with third weight zero; a
   * point inside a face by the face's smallest halfedge.
   * \pre `v` is not isolated
   */
  Surface_location location(Vertex_index v) const
  {
    if(is_inserted(v))
      return m_points[static_cast<std::size_t>(v.idx() - input().number_of_vertices())].location;
    return internal::canonical_location(input(), {input().outgoing(v), {{1, 0, 0}}});
  }

  /*!
   * Makes a point of the surface a vertex: splits the face or the edge of this triangulation that holds it. Where the
   * input's faces, the points' weights and the words of the edges meet, everything is exact: the point lies in the face
   * or on the edge that it is put into, and the words of the new edges are right, whatever the numbers do. Only traits
   * whose decisions err can leave no face for a point; then it goes onto the nearest edge, if that is as close as
   * rounding explains.
   *
   * `rollback()` takes the vertex out again.
   *
   * \param location any point of the surface
   * \return the new vertex, or the one that is there already
   * \throws Invalid_location_error
   * \throws Insertion_error if flips were wrong by rounding around the point, the point is closer to a vertex than
   *         numbers can tell, or an exact number type cannot express it; nothing is changed then
   * \throws Occupied_triangulation_error if a curve lies on the edge that the point is on, which
   *         `Edge_path_network::insert()` splits; nothing is changed then
   * \throws Degenerate_face_error, Invalid_coordinate_error
   *
   * Linear in the words of the edges that pass the point's input face, most often those of its face alone.
   */
  Vertex_index insert(const Surface_location& location)
  {
    return insert(location, [this](const internal::Edge_halves& halves) {
      if(holds(edge(halves.first)) > 0)
        throw Occupied_triangulation_error("a curve lies on the edge that a point is to be inserted on");
    });
  }

  /*!
   * As above. Where an edge is split, `on_split` is called with two halfedges: `first`, which is now half as long, and
   * `second`, which leads on from the new vertex to the old head of `first`. If it throws, the insertion is taken back.
   */
  template <class OnSplit>
  Vertex_index insert(const Surface_location& location, const OnSplit& on_split)
  {
    return insert_found(location, on_split,
                        [&](const auto& locate, const Surface_location& point) { return locate(point); });
  }

  /*!
   * Splits the edge of `h` at a point that lies on it up to rounding; it lies on it by definition from then on.
   *
   * \param gap where the point's input face is on the edge's way: the number of letters of `crossing_word(h)` before it
   * \param location a point of that face; not on its border, unless the edge runs along it
   * \param on_split as for `insert()`
   * \throws as `insert()`
   */
  template <class OnSplit>
  Vertex_index split_edge(Halfedge_index h, const Surface_location& location, std::size_t gap, const OnSplit& on_split)
  {
    if(is_border(h))
      h = twin(h); // an input edge: it crosses nothing
    return internal::insert_point(*this, editor(), {h, gap, true, null_index},
                                  internal::canonical_location(input(), location), on_split);
  }

  /*!
   * Splits the face on the left of `h` at a point inside it.
   *
   * \param gap the number of letters of `crossing_word(h)` before the input face that holds the point
   * \param location a point of that input face
   * \throws as `insert()`
   */
  Vertex_index split_face(Halfedge_index h, const Surface_location& location, std::size_t gap)
  {
    return internal::insert_point(*this, editor(), {h, gap, false, null_index},
                                  internal::canonical_location(input(), location), [](const auto&) {});
  }

  /// @}
  /// \name Correspondence with the input
  /// @{

  /// How many input edges the edge crosses; -1 if it lies along an input edge [GSC21].
  Index crossings(Edge_index e) const { return store().crossings(store().slot(internal::first_side(e))); }

  /*!
   * The word of the input edges that halfedge `h` crosses, from tail to head; exact, by integers alone [GSC21, section
   * 3]. Read off the numbers of crossings around the edge when it is first asked for, and kept. Derived from the flip
   * log where points are inserted or no edge at either end is the input's any more: in total about as many words as the
   * edge's history has joints.
   */
  Crossing_word crossing_word(Halfedge_index h) const { return m_history.word(*this, h); }

  /// The version of an edge: 0 for the input's, otherwise one more than the position of its last flip in the log.
  Index version(Edge_index e) const { return store().version(store().slot(internal::first_side(e))); }

  /*!
   * How many input edges start strictly inside the wedge from halfedge `from` clockwise to halfedge `to` of one vertex;
   * `from == to` means all the way round. \pre no border in between. Linear in the wedge's degree.
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

  static Input_mesh make_input(const TriangleMesh& mesh, const Metric& metric, Zero_length_edges zero_length_edges)
  {
    Input_mesh input(mesh);
    if(zero_length_edges == Zero_length_edges::REFUSE)
      return input;
    return internal::contracted(input, internal::Contracted_metric<Metric>{metric, input});
  }

  // Of a wedge that the traits leave open.
  Comparison_result compare_with_straight(Halfedge_index from, Halfedge_index to) const
  {
    const internal::Side_version a = {from, version(edge(from))}, b = {to, version(edge(to))};
    return m_decisions.compare(a, b, [&](Decision_statistics& statistics) {
      return internal::Wedge_comparison<Intrinsic_triangulation>(*this, statistics, true)(from, to);
    });
  }

  // `search(locator, point)` finds where the point is.
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

  // After a flip; if it fails, the flip is taken back.
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

/* What hard decisions compute is kept, since they come in crowds. */
template <class TriangleMesh, class Traits, class Metric>
struct Internals<Intrinsic_triangulation<TriangleMesh, Traits, Metric>>
{
  using Triangulation = Intrinsic_triangulation<TriangleMesh, Traits, Metric>;

  static constexpr bool has_exact_faces = true;
  static constexpr bool has_precise_numbers = true;

  /* The input face on the left of h. */
  static const Exact_face& exact_face(const Triangulation& t, Input_halfedge_index h)
  {
    return t.m_history.exact_face(t, h);
  }

  /* Of about 100 bits. */
  static const Precise_halfedge& precise_halfedge(const Triangulation& t, Input_halfedge_index h)
  {
    return t.m_history.input_halfedge(t, h);
  }

  /* The edge of h in numbers of about 100 bits, if its ends are input vertices. */
  static Precise_edge precise_edge(const Triangulation& t, Halfedge_index h) { return t.m_history.edge(t, h); }

  static Flat_edges& flat_edges(const Triangulation& t)
  {
    return t.m_decisions.flat_edges(static_cast<std::size_t>(t.input().number_of_halfedges() / 2));
  }

  /* Close to a known piece, many edges in the input face need not be passed. */
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
/// A face of the intrinsic triangulation; side `i` leads from vertex `i` to vertex `(i + 1) % 3`.
struct Intrinsic_face
{
  std::array<Vertex_index, 3> vertices;    ///< the tails of the halfedges
  std::array<Halfedge_index, 3> halfedges; ///< counterclockwise around the face
  std::array<double, 3> lengths;           ///< of the halfedges, in the unit of the mesh, rounded to double
};

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Writes all faces of a triangulation, which contains the curves of its network as edges, ordered by their smallest
 * halfedge, which comes first. Copies what was not touched yet: linear in the mesh.
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_H
