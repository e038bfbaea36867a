// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_H
#define CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Flip_record.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_elements.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/Contracted_metric.h>
#include <CGAL/Flip_geodesics/internal/surface/Default_traits.h>
#include <CGAL/Flip_geodesics/internal/surface/Flat_edges.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_history.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_straightness.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Flip_log.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Insertion_editor.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_insertion.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_locator.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>
#include <CGAL/Flip_geodesics/internal/triangulation/normal_coordinates.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Compared_wedges.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Remembered_decisions.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

template <class TriangleMesh>
using Default_metric =
    Embedded_metric<TriangleMesh, typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>;

} // namespace internal

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
template <class TriangleMesh, class Traits_ = internal::Default_traits<internal::Default_metric<TriangleMesh>>,
          class Metric_ = internal::Default_metric<TriangleMesh>>
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

  /// What the log keeps of a flip.
  using Flip_record = Flip_geodesics::Flip_record<Halfedge_geometry>;

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

  /// The input face on the left of input halfedge `h` in exact numbers. Like the next three, it is of a type that is not
  /// documented, and kept, since hard decisions come in crowds.
  const internal::Exact_face& exact_input_face(Input_halfedge_index h) const { return m_history.exact_face(*this, h); }
  /// Input halfedge `h` in numbers of about 100 bits.
  const internal::Precise_halfedge& precise_input_halfedge(Input_halfedge_index h) const
  {
    return m_history.input_halfedge(*this, h);
  }
  /// What is known of flat edges; as above.
  internal::Flat_edges& flat_edges() const
  {
    return m_decisions.flat_edges(static_cast<std::size_t>(input().number_of_halfedges() / 2));
  }
  /// The edge of `h` in numbers of about 100 bits, if its ends are input vertices.
  internal::Precise_edge precise_edge(Halfedge_index h) const { return m_history.edge(*this, h); }

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
   *
   * `close_by` is for `refine()`, which knows where the point is: many edges in the input face need not be passed then.
   */
  template <class OnSplit>
  Vertex_index insert(const Surface_location& location, const OnSplit& on_split, Known_piece* close_by = nullptr)
  {
    const Surface_location point = internal::canonical_location(input(), location);
    if(kind(point) == Location_kind::VERTEX)
      return input().tail(point.halfedge);
    const internal::Located_point place = located(point, close_by);
    if(place.vertex != null_index)
      return place.vertex;
    return internal::insert_point(*this, editor(), place, point, on_split);
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
  using Elements::store;

  static Input_mesh make_input(const TriangleMesh& mesh, const Metric& metric, Zero_length_edges zero_length_edges)
  {
    Input_mesh input(mesh);
    if(zero_length_edges == Zero_length_edges::REFUSE)
      return input;
    return input.contracted(internal::Contracted_metric<Metric>{metric, input});
  }

  // Of a wedge that the traits leave open.
  Comparison_result compare_with_straight(Halfedge_index from, Halfedge_index to) const
  {
    const internal::Side_version a = {from, version(edge(from))}, b = {to, version(edge(to))};
    return m_decisions.compare(a, b, [&](Decision_statistics& statistics) {
      return internal::Wedge_comparison<Intrinsic_triangulation>(*this, statistics, true)(from, to);
    });
  }

  internal::Located_point located(const Surface_location& point, Known_piece* close_by) const
  {
    Decision_statistics statistics;
    const internal::Point_locator<Intrinsic_triangulation> locate(*this, statistics);
    const internal::Located_point place = close_by == nullptr ? locate(point) : locate(point, *close_by);
    m_decisions.add(statistics);
    return place;
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTRINSIC_TRIANGULATION_H
