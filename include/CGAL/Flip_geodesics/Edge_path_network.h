// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EDGE_PATH_NETWORK_H
#define CGAL_FLIP_GEODESICS_EDGE_PATH_NETWORK_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/network/Bundle_order.h>
#include <CGAL/Flip_geodesics/internal/network/Segment_store.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/concepts.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * Represents a network of curves along the edges of an intrinsic triangulation. Curves are open paths or closed loops.
 * They can have fixed nodes, several segments on one edge, and segments that run back and forth.
 *
 * A curve is a chain of *segments*, each on a halfedge. The node between two consecutive segments is a *joint*, which
 * is fixed or free; the end points of an open path are always fixed. The segments on an edge form its bundle
 * (`bundle()`), which is ordered from left to right as seen along the first halfedge of the edge. Around a vertex, the
 * segment ends have a cyclic order: clockwise by incident edge, and on each edge from left to right as seen from the
 * vertex.
 *
 * `is_valid()` checks the following invariant. Curves are chains, and each bundle contains exactly the segments on its
 * edge. Around each vertex, the pairs of segment ends that are connected by free joints form a non-crossing matching.
 * All other segment ends at the vertex, and the border, lie in one region of this matching. Added curves can violate
 * the conditions on the matching; `order_overlapping_curves()` orders the segments such that these conditions hold, if
 * possible.
 *
 * Indices of removed segments are not reused, except after a call of `clear()`.
 *
 * Several networks can have curves in one triangulation. A network holds the edges on which its curves lie, and held
 * edges are not flipped. Therefore, while one network is shortened, the curves of other networks do not move, and a
 * wedge that contains an edge of such a curve is blocked (`Wedge_state::BLOCKED`). Curves of different networks can
 * overlap along edges, but have no order on these edges, so they can cross there. Curves that must not cross must
 * belong to the same network.
 *
 * \attention The network refers to its triangulation, which must not be destroyed while the network has curves. If the
 * triangulation is moved while the network has curves, the network must then be moved to the new triangulation by the
 * constructor from a network and a triangulation. A moved-from network can only be cleared, assigned to or destroyed.
 *
 * \tparam Triangulation_ a model of `IntrinsicTriangulation`. The functions `insert()` and `split_edge()` require a
 *         model of `IntrinsicTriangulationOfMesh`
 *
 * \cgalModels{EdgePathGraph}
 */
template <class Triangulation_>
class Edge_path_network
{
public:
  using Triangulation = Triangulation_;      ///< the type of the triangulation
  using Turn = typename Triangulation::Turn; ///< the type of a rotation around a vertex

  /// Describes the wedge on one side of a joint.
  struct Wedge
  {
    Wedge_state state; ///< what the wedge contains
    Turn turn;         ///< the angle of the wedge; meaningful only if `state` is `FREE`
  };

  /// Constructs an empty network in a triangulation. Complexity: constant.
  explicit Edge_path_network(Triangulation& triangulation)
    : m_triangulation(&triangulation)
    , m_segments(triangulation)
  {
    static_assert(internal::is_intrinsic_triangulation<Triangulation>());
  }

  /// Moves a network. Curves and segments keep their numbers.
  Edge_path_network(Edge_path_network&&) noexcept = default;

  /// Moves a network whose triangulation has been moved to `moved_to`. Curves and segments keep their numbers.
  Edge_path_network(Edge_path_network&& other, Triangulation& moved_to) noexcept
    : Edge_path_network(std::move(other))
  {
    m_triangulation = &moved_to;
    m_segments.set_triangulation(moved_to);
  }

  /// Removes all curves, and then moves `other` into this network, as the move constructor does.
  Edge_path_network& operator=(Edge_path_network&& other) noexcept
  {
    if(this != &other) {
      m_segments.release_edges();
      m_triangulation = other.m_triangulation;
      m_segments = std::move(other.m_segments);
    }
    return *this;
  }

  Edge_path_network(const Edge_path_network&) = delete;
  Edge_path_network& operator=(const Edge_path_network&) = delete;
  /// Removes all curves. \pre if the network has curves, the triangulation has been neither moved nor destroyed
  ~Edge_path_network() { m_segments.release_edges(); }

  /// Returns the triangulation that contains the curves.
  Triangulation& triangulation() const { return *m_triangulation; }

  /// \name Building
  /// @{

  /*!
   * Adds a curve along halfedges of the triangulation. Each new segment becomes the rightmost segment on its edge, as
   * seen along the halfedge of the segment.
   *
   * \param halfedges a range of `Halfedge_index` that forms a chain: each halfedge starts where the previous one ends
   *        and, if the curve is closed, the first one starts where the last one ends
   * \param np the named parameter `is_closed`, a `bool`: whether the curve is a closed loop; `false` by default
   * \return the index of the curve
   * \throws Invalid_curve_error if there are no halfedges, if one of them does not belong to the triangulation, or if
   *         they do not form a chain
   * \throws Invalid_mesh_error if a face at one of the halfedges is not a triangle
   * \throws Degenerate_face_error if such a face has a degenerate edge or violates the triangle inequality
   * \throws Invalid_coordinate_error if such a face has a coordinate or length that is not finite or is out of range
   *
   * Complexity: linear in the number of halfedges.
   */
  template <class HalfedgeRange, class... NamedParameters>
  Curve_index add_curve(const HalfedgeRange& halfedges, const NamedParameters&... np)
  {
    const bool is_closed = internal::is_closed_of(internal::options_of<internal::Closed_parameter>(np...));
    internal::check_chain(*m_triangulation, halfedges, is_closed);
    const Curve_index curve = m_segments.add_curve(halfedges, is_closed);
    reset_initial_length(curve);
    return curve;
  }

  /// Fixes all nodes that curves currently have at vertex `v`: these nodes keep their positions, and other curves
  /// cannot move across them. Complexity: linear in the number of all segments that the network has created so far.
  void fix_nodes_at(Vertex_index v)
  {
    for(Segment_index s(1); s.idx() < m_segments.end_of_ids(); ++s)
      if(is_alive(s) && m_triangulation->head(halfedge(s)) == v)
        set_head_fixed(s, true);
  }

  /// Fixes or frees the node at the head of segment `s`. \pre a node that is freed is not the end of an open path, and
  /// the invariant of the network holds at this node after the call
  void set_head_fixed(Segment_index s, bool is_fixed) { m_segments.set_head_fixed(s, is_fixed); }

  /// Frees all nodes of a curve, except the ends of an open path.
  /// \throws Crossing_curves_error if the invariant of the network would not hold at one of these nodes, for example
  ///         because curves cross there; in this case the network is unchanged
  void free_nodes(Curve_index curve)
  {
    std::vector<Segment_index> freed;
    for_each_segment(curve, [&](Segment_index s) {
      if(is_head_fixed(s) && next(s) != null_index)
        freed.push_back(s);
    });
    for(Segment_index s : freed)
      set_head_fixed(s, false);
    for(Segment_index s : freed) {
      const Halfedge_index h = halfedge(s);
      const Vertex_index v = m_triangulation->head(h);
      if(is_non_crossing_at({Triangulation::twin(h), s}))
        continue;
      for(Segment_index fixed : freed)
        set_head_fixed(fixed, true);
      internal::throw_naming<Crossing_curves_error>("the nodes of a curve cannot be freed, because at vertex ", v,
                                                    ", two curves or two parts of one curve cross, or ends of curves "
                                                    "or fixed nodes lie on both sides of a curve");
    }
  }

  /// Sets the initial length of a curve to its current length.
  void reset_initial_length(Curve_index curve) { set_initial_length(curve, length(curve)); }

  /// Sets the initial length of a curve. This is useful if, for example, the curve was shortened before it was added.
  void set_initial_length(Curve_index curve, double length) { m_segments.set_initial_length(curve, length); }

  /// Reorders the segments on edge `e`; `order` contains them from left to right as seen along the first halfedge of
  /// `e`. \pre `order` is a permutation of `bundle(e)`
  void set_bundle(Edge_index e, const std::vector<Segment_index>& order) { m_segments.set_bundle(e, order); }

  /*!
   * Inserts a point of the surface as a vertex, as `Intrinsic_triangulation::insert()` does. If an edge is split, each
   * segment on this edge becomes two segments with a free joint between them. The order of the segments does not
   * change.
   * \param location the point
   * \return the new vertex, or the existing one at the point
   * \throws Invalid_location_error as `Intrinsic_triangulation::insert()` does
   * \throws Insertion_error as `Intrinsic_triangulation::insert()` does
   * \throws Occupied_triangulation_error if a curve of another network lies on the edge that contains the point
   * \throws Degenerate_face_error as `Intrinsic_triangulation::insert()` does
   * \throws Invalid_coordinate_error as `Intrinsic_triangulation::insert()` does
   */
  Vertex_index insert(const Surface_location& location) { return m_triangulation->insert(location, divide_bundles()); }

  /// Splits the edge of `h` as `Intrinsic_triangulation::split_edge()` does, and divides the segments on this edge as
  /// `insert()` does. Throws the exceptions that `insert()` throws.
  Vertex_index split_edge(Halfedge_index h, const Surface_location& location, std::size_t gap)
  {
    return m_triangulation->split_edge(h, location, gap, divide_bundles());
  }

  /// Removes all curves. Complexity: linear in the number of all segments that the network has created so far.
  void clear() { m_segments.clear(); }

  /// @}
  /// \name Curves
  /// @{

  /// Returns the number of curves, including those that have contracted to a point. Curves are numbered from 0.
  Index number_of_curves() const { return m_segments.number_of_curves(); }
  /// Returns the indices of all curves as a range with random access.
  auto curves() const { return internal::descriptors<Curve_index>(number_of_curves()); }

  /// Returns one more than the largest segment index assigned since the construction or the last call of `clear()`. The
  /// indices start at 1, so the result is 1 if there have been no segments.
  Index end_of_segment_ids() const { return m_segments.end_of_ids(); }

  /// Returns the first segment of a curve, or `null_index` if the curve has contracted to a point.
  Segment_index first_segment(Curve_index curve) const { return m_segments.first(curve); }
  /// Returns the last segment of a curve, or `null_index` if the curve has contracted to a point.
  Segment_index last_segment(Curve_index curve) const { return m_segments.last(curve); }
  /// Returns whether the curve is a closed loop.
  bool is_closed(Curve_index curve) const { return m_segments.is_closed(curve); }
  /// Returns whether the curve has contracted to a point.
  bool is_contracted(Curve_index curve) const { return first_segment(curve) == null_index; }

  /// Returns the initial length of a curve, to which stop predicates refer: its length when it was added, unless
  /// another initial length has been set.
  double initial_length(Curve_index curve) const { return m_segments.initial_length(curve); }

  /// Returns the length of a curve, that is, the sum of the lengths of its segments.
  double length(Curve_index curve) const
  {
    double sum = 0;
    for_each_segment(curve, [&](Segment_index s) { sum += m_triangulation->length(halfedge(s)); });
    return sum;
  }

  /// Calls `function(s)` for each segment of a curve, in order.
  template <class Function>
  void for_each_segment(Curve_index curve, Function function) const
  {
    m_segments.for_each_segment(curve, function);
  }

  /// Returns the halfedges of a curve, in order.
  std::vector<Halfedge_index> halfedges(Curve_index curve) const
  {
    std::vector<Halfedge_index> result;
    for_each_segment(curve, [&](Segment_index s) { result.push_back(halfedge(s)); });
    return result;
  }

  /// @}
  /// \name Segments
  /// @{

  /// Returns whether `s` is currently a segment of a curve.
  bool is_alive(Segment_index s) const { return m_segments.is_alive(s); }
  /// Returns the halfedge of segment `s`, or `null_index` if the segment no longer exists.
  Halfedge_index halfedge(Segment_index s) const { return m_segments.halfedge(s); }
  /// Returns the curve of segment `s`.
  Curve_index curve(Segment_index s) const { return m_segments.curve(s); }
  /// Returns the next segment of the curve, or `null_index` at the end of a path.
  Segment_index next(Segment_index s) const { return m_segments.next(s); }
  /// Returns the previous segment of the curve, or `null_index` at the start of a path.
  Segment_index previous(Segment_index s) const { return m_segments.previous(s); }
  /// Returns whether the node at the head of segment `s` is fixed. The end of an open path is always fixed.
  bool is_head_fixed(Segment_index s) const { return m_segments.is_head_fixed(s); }

  /// Returns whether any segment of this network lies on the edge of `h`.
  bool is_occupied(Halfedge_index h) const { return m_segments.is_occupied(h); }

  /// Returns the segments on edge `e`, from left to right as seen along halfedge `2e`.
  std::vector<Segment_index> bundle(Edge_index e) const { return m_segments.bundle(e); }

  /// Returns the leftmost or rightmost segment on the edge of `h`, as seen along `h`. \pre `is_occupied(h)`
  Segment_index outermost(Halfedge_index h, Side side) const { return m_segments.outermost(h, side); }

  /// @}
  /// \name Ends and wedges
  /// @{

  /// Returns the two segment ends that meet at a joint. The wedge on the side `joint.side` extends clockwise from the
  /// first end to the second. \pre `next(joint.incoming)` is not `null_index`
  std::pair<Segment_end, Segment_end> ends(const Joint& joint) const
  {
    const Segment_index x = joint.incoming, y = next(x);
    const Segment_end at_x = {Triangulation::twin(halfedge(x)), x}, at_y = {halfedge(y), y};
    return joint.side == Side::LEFT ? std::make_pair(at_x, at_y) : std::make_pair(at_y, at_x);
  }

  /// Returns the next segment end clockwise around the vertex of `end`. If the border, or an edge that only other
  /// networks hold, comes first, the result is a null end. Complexity: linear in the number of edges between the two
  /// ends.
  Segment_end next_clockwise(const Segment_end& end) const
  {
    return next_end(end, Side::RIGHT, [](const Walker& h) { return h.is_held(); });
  }

  /// Returns the next segment end counterclockwise around the vertex of `end`. If the border, or an edge that only
  /// other networks hold, comes first, the result is a null end. Complexity: linear in the number of edges between the
  /// two ends.
  Segment_end next_counterclockwise(const Segment_end& end) const
  {
    return next_end(end, Side::LEFT, [](const Walker& h) { return h.is_held(); });
  }

  /// Returns the next segment end of this network around the vertex of `end`, clockwise if `side` is `Side::RIGHT`, and
  /// counterclockwise if it is `Side::LEFT`. Edges that only other networks hold are skipped. If the border comes
  /// first, the result is a null end. Complexity: linear in the number of edges between the two ends.
  Segment_end next_beyond_others(const Segment_end& end, Side side) const
  {
    return next_end(end, side, [this](const Walker& h) { return h.is_held() && m_segments.leftmost(h) != no_segment; });
  }

  /// Returns the state and the angle of the wedge of a joint. The wedge is not inspected beyond an angle of \f$\pi\f$.
  /// Complexity: linear in the number of inspected edges. \pre `next(joint.incoming)` is not `null_index`
  Wedge wedge(const Joint& joint) const
  {
    const Wedge result = look_into_wedge(joint);
    m_segments.note_straight(joint.incoming, joint.side,
                             result.state == Wedge_state::STRAIGHT || result.state == Wedge_state::BORDER);
    return result;
  }

  /// Returns whether the curve turns back at a joint, with an empty wedge of angle zero on the side `joint.side`.
  /// \pre `next(joint.incoming)` is not `null_index`
  bool is_turning_back(const Joint& joint) const
  {
    const auto [a, b] = ends(joint);
    return a.halfedge == b.halfedge && m_segments.neighbor(a.segment, a.halfedge, Side::RIGHT) == b.segment;
  }

  /// @}
  /// \name Moves
  /// @{

  /*!
   * Moves a joint over its wedge, that is, replaces the two segments of the joint by segments along `arc`.
   *
   * Let \f$x\f$ be the segment of the first end of the joint, and \f$y\f$ the segment of the second end (see `ends()`).
   * The arc leads from the other node of \f$x\f$ to the other node of \f$y\f$, with the wedge on its right. Each new
   * segment becomes the outermost segment on its edge, on the side of the wedge. If the joint turns back, the arc is
   * empty, and the two segments are removed.
   *
   * \param joint the joint
   * \param arc the halfedges of the arc
   * \param affected a list to which the function appends the sides of joints whose wedges must be inspected again
   * \return the first new segment in the direction of the curve, or `null_index` if the arc is empty
   * \pre see `EdgePathGraph::replace_joint()`
   */
  Segment_index replace_joint(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected)
  {
    return internal::Joint_replacement<Edge_path_network>(*this, m_segments)(joint, arc, affected);
  }

  /*!
   * Replaces segment `s`, the only segment of a loop, by two segments on the other two edges of the face on the left of
   * `h` \cgalCite{SC20,Appendix B}. The argument `h` is the halfedge of `s` or its twin.
   * \return the new segment that arrives at the node of the former segment
   * \pre no segments lie on the other two edges of the face
   */
  Segment_index perturb_loop(Segment_index s, Halfedge_index h) { return m_segments.perturb_loop(s, h); }

#ifdef DOXYGEN_RUNNING
  /// Stores the position of a segment among the segments on its edge, for `restore_loop()`.
  using Bundle_place = unspecified_type;
#else
  using Bundle_place = internal::Bundle_place;
#endif

  /// Returns the position of segment `s` among the segments on its edge, for `restore_loop()`.
  Bundle_place bundle_place(Segment_index s) const { return m_segments.bundle_place(s); }

  /// Replaces the segments of a closed curve by a single new segment, at the position that the only segment of the
  /// curve had when `bundle_place()` returned `place`. \pre all flips since that call have been rolled back, and no
  /// other curve has changed
  Segment_index restore_loop(Curve_index curve, const Bundle_place& place)
  {
    return m_segments.restore_loop(curve, place);
  }

  /// @}

  /// Returns whether the invariant of the network holds. Complexity: for each segment, linear in the degrees of its two
  /// vertices plus the number of segments at these vertices.
  bool is_valid() const { return internal::Network_validity<Edge_path_network>(*this).is_valid(); }

  /*!
   * Returns whether the invariant holds for the segment ends around the vertex of `end`: the ends that free joints
   * connect form a non-crossing matching, and all other ends and the border lie in one region of this matching.
   */
  bool is_non_crossing_at(const Segment_end& end) const
  {
    return internal::Network_validity<Edge_path_network>(*this).is_non_crossing_at(end);
  }

private:
  friend struct internal::Internals<Edge_path_network>;
  using Walker = typename Triangulation::Walker;

  static constexpr Segment_index no_segment{0};

  auto divide_bundles()
  {
    return [this](const auto& halves) { m_segments.divide_bundle(halves); };
  }

  // Returns the end of the outermost segment on the first edge for which `is_end(h)` holds, or no end if only other
  // networks hold this edge.
  template <class IsEnd>
  Segment_end next_end(const Segment_end& end, Side side, const IsEnd& is_end) const
  {
    const Segment_index inner = m_segments.neighbor(end.segment, end.halfedge, side);
    if(inner != null_index)
      return {end.halfedge, inner};
    Walker h = m_segments.placed(end.segment, end.halfedge);
    do {
      h = side == Side::RIGHT ? h.clockwise() : h.counterclockwise();
      if(h.is_none())
        return {};
    } while(!is_end(h));
    return end_on(h, opposite_side(side));
  }

  // Returns the end of the outermost segment on an edge, on the given side as seen from the node, or no end if only
  // other networks hold the edge.
  Segment_end end_on(const Walker& h, Side side) const
  {
    const Segment_index first = m_segments.leftmost(h);
    return first == no_segment ? Segment_end{} : Segment_end{h.index(), m_segments.outermost(h.index(), first, side)};
  }

  Wedge look_into_wedge(const Joint& joint) const
  {
    if(is_head_fixed(joint.incoming))
      return {Wedge_state::FIXED, {}};
    const auto [a, b] = ends(joint);
    const Segment_index inner = m_segments.neighbor(a.segment, a.halfedge, Side::RIGHT);
    if(inner != null_index)
      return {b.segment == inner && b.halfedge == a.halfedge ? Wedge_state::FREE : Wedge_state::BLOCKED, {}};
    Turn turn;
    Walker h = m_segments.placed(a.segment, a.halfedge);
    do {
      h = h.extend_turn_clockwise(turn);
      if(h.is_none())
        return {Wedge_state::BORDER, {}};
      if(m_triangulation->is_straight(turn, a.halfedge, h.index()))
        return {Wedge_state::STRAIGHT, {}};
    } while(!h.is_held());
    return {b == end_on(h, Side::LEFT) ? Wedge_state::FREE : Wedge_state::BLOCKED, turn};
  }

  Triangulation* m_triangulation;
  internal::Segment_store<Triangulation> m_segments;
};

namespace internal {

template <class Triangulation>
struct Internals<Edge_path_network<Triangulation>>
{
  using Network = Edge_path_network<Triangulation>;

  static auto divide_bundles(Network& network) { return network.divide_bundles(); }

  /*
   * Sets the state that read_network() has read. Returns false and leaves the network empty if its curves are not
   * chains in the current triangulation, or its bundles do not match the edges. Curves may cross before they are put in
   * order, so crossings are not checked. \pre the network has no curves
   */
  static bool restore(Network& network, const Network_state& state)
  {
    CGAL_precondition(network.number_of_curves() == 0);
    const bool is_restored = network.m_segments.restore(state);
    if(!is_restored)
      network.clear();
    return is_restored;
  }
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Returns the chain of halfedges through given vertices. An edge of the triangulation must connect each vertex with the
 * next one; if several edges connect them, the function chooses the shortest one.
 *
 * \param triangulation a model of `IntrinsicTriangulation`
 * \param vertices a range of vertices, as `Vertex_index`; a vertex that equals the previous one is skipped. For a
 *        closed chain, the first vertex need not be repeated at the end
 * \param np the named parameter `is_closed`, a `bool`: whether the chain leads back to the first vertex; `false` by
 *        default
 * \throws Vertex_out_of_range_error if an index does not belong to a vertex
 * \throws Invalid_curve_error if the range has fewer than two vertices, contains only one vertex several times, or
 *         contains two consecutive vertices that no edge connects
 *
 * Complexity: linear in the sum of the degrees of the vertices.
 */
template <class Triangulation, class VertexRange, class... NamedParameters>
std::vector<Halfedge_index> halfedges_through(const Triangulation& triangulation, const VertexRange& vertices,
                                              const NamedParameters&... np)
{
  static_assert(internal::is_range_of<VertexRange, Vertex_index>,
                "the second argument must be a range of vertices of the triangulation (Vertex_index)");
  std::vector<Vertex_index> v;
  for(Vertex_index vertex : vertices) {
    internal::check_vertex(vertex, triangulation.number_of_vertices(), v.size());
    v.push_back(vertex);
  }
  if(v.size() < 2)
    throw Invalid_curve_error("a curve requires at least two vertices");
  if(internal::is_closed_of(internal::options_of<internal::Closed_parameter>(np...)))
    v.push_back(v.front());
  std::vector<Halfedge_index> result;
  for(std::size_t i = 0; i + 1 < v.size(); ++i) {
    if(v[i] == v[i + 1]) // for instance, because a degenerate edge was contracted
      continue;
    result.push_back(internal::halfedge_between(triangulation, v[i], v[i + 1]));
    if(result.back() == null_index)
      internal::throw_naming<Invalid_curve_error>("a curve is not connected: no edge connects vertex ", v[i],
                                                  " and vertex ", v[i + 1]);
  }
  if(result.empty())
    internal::throw_naming<Invalid_curve_error>("all vertices of a curve are the same vertex, ", v.front(),
                                                "; the curve would be a single point");
  return result;
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Returns a chain of halfedges that leads along edge paths from each waypoint to the next. The object `search` computes
 * each of these paths.
 *
 * \param search a `Shortest_edge_path` on a triangulation whose edges are still those of the input
 * \param way_points at least two vertices, as `Vertex_index`; a vertex that equals the previous one is skipped. For a
 *        closed chain, the first vertex need not be repeated at the end
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{is_closed}
 *     \cgalParamDescription{whether the chain leads back to the first waypoint}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is called during the searches. If this call returns `false`,
 *       no halfedges are returned}
 *     \cgalParamType{a model of `FlipOutVisitor`, which is copied unless it is passed by `std::ref()`}
 *     \cgalParamDefault{no visitor}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Invalid_curve_error if the range has fewer than two waypoints, or if all waypoints are the same vertex
 * \throws Vertex_out_of_range_error if an index does not belong to a vertex
 * \throws Disconnected_endpoints_error if there are two consecutive waypoints that no edge path connects
 * \throws Invalid_coordinate_error as `Shortest_edge_path` does
 *
 * Complexity: that of one search of `Shortest_edge_path` for each pair of consecutive waypoints.
 */
template <class Search, class VertexRange, class... NamedParameters>
std::vector<Halfedge_index> shortest_halfedges_through(Search& search, const VertexRange& way_points,
                                                       const NamedParameters&... np)
{
  const auto& options = internal::options_of<internal::Closed_parameter, internal_np::visitor_t>(np...);
  auto visitor = internal::make_visitor(options);
  const auto path = [&](Vertex_index source, Vertex_index target) {
    if constexpr(internal::is_given<std::decay_t<decltype(options)>, internal_np::visitor_t>)
      return search(source, target, parameters::visitor(std::ref(visitor.get())));
    else
      return search(source, target);
  };
  std::vector<Vertex_index> v(std::begin(way_points), std::end(way_points));
  if(v.size() < 2)
    throw Invalid_curve_error("a curve requires at least two waypoints");
  if(internal::is_closed_of(options))
    v.push_back(v.front());
  std::vector<Halfedge_index> result;
  for(std::size_t i = 0; i + 1 < v.size(); ++i) {
    const std::vector<Halfedge_index> leg = path(v[i], v[i + 1]); // throws for invalid vertices, too
    if(leg.empty() && v[i] != v[i + 1])                           // stopped by the visitor
      return {};
    result.insert(result.end(), leg.begin(), leg.end());
  }
  if(result.empty())
    internal::throw_naming<Invalid_curve_error>("all waypoints of a curve are the same vertex, ", v.front(),
                                                "; the curve would be a single point");
  return result;
}

namespace internal {

using Edge_marks = Indexed_by<Edge_index, std::vector<char>>;

template <class Triangulation>
Indexed_by<Vertex_index, std::vector<Index>> degrees(const Triangulation& triangulation, const Edge_marks& is_marked)
{
  Indexed_by<Vertex_index, std::vector<Index>> result(static_cast<std::size_t>(triangulation.number_of_vertices()), 0);
  for(Edge_index e : descriptors<Edge_index>(triangulation.number_of_edges()))
    if(is_marked[e] != 0) {
      ++result[triangulation.tail(first_side(e))];
      ++result[triangulation.head(first_side(e))];
    }
  return result;
}

/* Calls `add()`, which adds curves, and returns their number. If it throws, a network that was empty is empty again. */
template <class Network, class Add>
Index add_all_or_none(Network& network, const Add& add)
{
  const Index before = network.number_of_curves();
  try {
    add();
  } catch(...) {
    if(before == 0)
      network.clear();
    throw;
  }
  return network.number_of_curves() - before;
}

/*
 * Adds the chains of a set of edges between vertices for which `is_node(v)` holds, and the closed ones. Returns their
 * number. \pre every vertex of the set that is not a node has two edges of the set
 */
template <class Network, class IsNode>
Index add_chains(Network& network, Edge_marks is_open, const IsNode& is_node)
{
  const auto& triangulation = network.triangulation();
  const auto next_open = [&](Halfedge_index h) -> Halfedge_index {
    if(is_node(triangulation.head(h)))
      return null_index;
    for(Halfedge_index g : outgoing_halfedges(triangulation, triangulation.head(h)))
      if(is_open[Network::Triangulation::edge(g)] != 0)
        return g;
    return null_index;
  };
  const auto walk = [&](Halfedge_index h) {
    std::vector<Halfedge_index> chain;
    for(; h != null_index; h = next_open(h)) {
      is_open[Network::Triangulation::edge(h)] = 0;
      chain.push_back(h);
    }
    return chain;
  };

  return add_all_or_none(network, [&] {
    for(Halfedge_index h : descriptors<Halfedge_index>(triangulation.number_of_halfedges()))
      if(is_open[Network::Triangulation::edge(h)] != 0 && is_node(triangulation.tail(h)))
        network.add_curve(walk(h));
    for(Edge_index e : descriptors<Edge_index>(triangulation.number_of_edges()))
      if(is_open[e] != 0)
        network.add_curve(walk(first_side(e)), parameters::is_closed(true));
  });
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds the marked edges of the input mesh to a network as curves.
 *
 * Curves end at the vertices that are incident to exactly one marked edge or to more than two marked edges. Each chain
 * of marked edges between such vertices becomes an open curve, and each loop without such a vertex becomes a closed
 * curve. Of the two possible directions of an open curve, the function chooses the one whose first halfedge has the
 * smaller index. Open curves are added first, ordered by their first halfedges; closed curves follow, ordered by their
 * lowest-numbered edges. If the function throws an exception, a network that was empty before the call is empty
 * afterwards.
 *
 * \param network the network
 * \param mesh the mesh of the triangulation
 * \param is_marked a model of `ReadablePropertyMap` with the edges of the mesh as keys and `bool` as values
 * \return the number of curves added
 * \pre the edges of the triangulation are still those of the input
 *
 * Complexity: linear in the size of the mesh.
 */
template <class Network, class TriangleMesh, class EdgeIsMarkedMap>
Index add_marked_edges(Network& network, const TriangleMesh& mesh, EdgeIsMarkedMap is_marked)
{
  static_assert(internal::is_property_map<EdgeIsMarkedMap>());
  const auto& triangulation = network.triangulation();
  internal::Edge_marks marks(static_cast<std::size_t>(triangulation.number_of_edges()), 0);
  for(Edge_index e : internal::descriptors<Edge_index>(triangulation.number_of_edges())) {
    const auto h = triangulation.input().halfedge(internal::as_input(internal::first_side(e)));
    marks[e] = get(is_marked, edge(h, mesh)) ? 1 : 0;
  }
  const auto degree = internal::degrees(triangulation, marks);
  return internal::add_chains(network, std::move(marks), [&](Vertex_index v) { return degree[v] != 2; });
}

namespace internal {

/* Orders the segments on each edge, or returns the conflict that prevents this. */
template <class Network>
Order_conflict order_bundles(Network& network)
{
  const Bundle_pairs<Network> pairs(network);
  if(pairs.conflict() || pairs.number_of_bundles() == 0)
    return pairs.conflict();
  Crossing_equations<Network> equations(pairs);
  if(equations.conflict())
    return equations.conflict();
  Bundle_order_search<Network> search(equations);
  if(const Order_conflict conflict = search.run())
    return conflict;
  for(Index i = 0; i < pairs.number_of_bundles(); ++i)
    network.set_bundle(pairs.edge(i), search.order(i));
  return {};
}

/* Orders curves as `order_overlapping_curves()` does, but returns the conflict instead of throwing. */
template <class Network>
Order_conflict order_if_possible(Network& network)
{
  Order_conflict conflict = order_bundles(network);
  if(conflict)
    return conflict;
  const auto& triangulation = network.triangulation();
  for_each_vertex(triangulation, occupied_halfedges(network), [&](auto first, auto) {
    if(!conflict && !network.is_non_crossing_at({*first, network.outermost(*first, Side::LEFT)}))
      conflict.v = triangulation.tail(*first);
  });
  return conflict;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Reorders the overlapping segments on the edges of a network such that no two curves cross and no curve crosses
 * itself.
 *
 * \attention Call this function after all curves have been added, because `add_curve()` merely arranges the segments on
 * an edge in the order in which they are added.
 *
 * The function does not use lengths or angles, and is exact: if an order without crossings exists, the function finds
 * such an order, unless the search is aborted (see `Ambiguous_order_error` below). No such order exists, for example,
 * if one curve joins another from the left, runs along it, and leaves it on the right, or if a curve goes around an
 * annulus twice before it closes.
 *
 * Two curves that share a chain of edges are ordered by the sides on which they part at the two ends of the chain. An
 * end of the chain at which a path ends or a node is fixed does not determine an order. However, the following
 * condition must hold at each vertex: the border and all segment ends at fixed nodes lie on the same side of every
 * curve that passes through the vertex at a free node. The ends of paths are fixed nodes.
 *
 * If neither end of the chain determines the order, the orders of other segments on the same edges can determine it. If
 * they do not, the function chooses the order: the segment that was added first lies on the left, as seen in its
 * direction. However, it lies on the right if its curve has turned back an odd number of times before this segment.
 * Copies of a curve that does not turn back therefore lie to the right of the curve if they are added after it.
 *
 * If an exception is thrown, the curves are unchanged, but the order of their segments can have changed.
 *
 * \param network an `Edge_path_network`
 * \throws Crossing_curves_error if every order of the segments contains a crossing or violates the condition above on
 *         fixed nodes and the border. `elements()` returns a vertex at which this happens, or one of several vertices
 *         that together make an order impossible
 * \throws Ambiguous_order_error if the search is aborted, for example because long paths turn back on each other
 *         repeatedly. `elements()` returns the two vertices of an edge that the curves share
 *
 * Complexity: \cgalBigO{n \log n + d + p \log p} time, where \f$n\f$ is the number of segments, \f$d\f$ is the sum of
 * the degrees of their vertices, and \f$p\f$ is the number of pairs of segments that lie on the same edge. A million
 * pairs take some tenths of a second, and the pairs require \cgalBigO{p} memory. If the choices described above
 * contradict one another, revising them takes additional time proportional to \f$p\f$ times the maximal number of
 * segments on one edge.
 */
template <class Network>
void order_overlapping_curves(Network& network)
{
  if(const internal::Order_conflict conflict = internal::order_if_possible(network))
    conflict.raise();
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_EDGE_PATH_NETWORK_H
