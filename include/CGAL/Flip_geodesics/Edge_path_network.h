// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EDGE_PATH_NETWORK_H
#define CGAL_FLIP_GEODESICS_EDGE_PATH_NETWORK_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/network/Segment_store.h>
#include <CGAL/Flip_geodesics/internal/network/network_parts.h>
#include <CGAL/Flip_geodesics/internal/surface/Internals.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * A network of curves along the edges of an intrinsic triangulation: open paths, closed loops, curves with fixed nodes
 * inside, several strands over one edge, strands that run to and fro. Model of `EdgePathGraph`.
 *
 * A curve is a chain of *segments*, each on a halfedge; the node between two segments is a *joint*, which is fixed or
 * not. The ends of an open path are always fixed. Each edge keeps the list of its segments, its *stack*, from left to
 * right as seen along its first halfedge. Around a vertex the ends of segments have a cyclic order: by spoke clockwise,
 * and on a spoke by the stack from left to right as seen from the vertex.
 *
 * The invariant (`is_valid()`): curves are chains, and stacks hold exactly the segments on their edge. Around each
 * vertex the ends joined by joints that are not fixed form a non-crossing matching. All other ends, and the border, are
 * in one of its regions.
 *
 * Segment ids are given once and never again, so that an id in a queue cannot come to mean something else.
 *
 * Several networks can have curves in one triangulation. A network holds the edges under its curves, and an edge that is
 * held is not flipped. Hence curves of other networks are obstacles: they do not move, and where one of their edges is in
 * a wedge, the wedge is `Wedge_state::BLOCKED`. Curves of different networks may overlap along edges; there they have no
 * order, and each of them can leave such an edge to either side. What is to hold between curves, as that they do not
 * cross, requires that they are in one network.
 *
 * The network refers to its triangulation, which must neither be destroyed nor moved while the network has curves. If
 * both are moved, the constructor from a network and a triangulation keeps them together. A network that was moved from
 * can be cleared, assigned to and destroyed.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulation`; to insert points and to divide segments, one of
 *         `IntrinsicTriangulationOfMesh`
 *
 * \cgalModels{EdgePathGraph}
 */
template <class Triangulation_>
class Edge_path_network
{
public:
  using Triangulation = Triangulation_;      ///< the template parameter
  using Turn = typename Triangulation::Turn; ///< a rotation about a vertex, of the triangulation's traits

  /// What can be known of a wedge by looking at it.
  struct Wedge
  {
    Wedge_state state; ///< what stands in it
    Turn turn;         ///< over the corners up to the next strand; to be compared only if `state` is `FREE`
  };

  /// An empty network in a triangulation. Constant time.
  explicit Edge_path_network(Triangulation& triangulation)
    : m_triangulation(&triangulation)
    , m_segments(triangulation)
  {
  }

  /// Moves a network, whose curves and segments keep their numbers.
  Edge_path_network(Edge_path_network&&) noexcept = default;

  /// Moves a network whose triangulation has been moved to `moved_to`. Numbers are kept, as above.
  Edge_path_network(Edge_path_network&& other, Triangulation& moved_to) noexcept
    : Edge_path_network(std::move(other))
  {
    m_triangulation = &moved_to;
    m_segments.set_triangulation(moved_to);
  }

  /// Removes all curves, and moves a network as the constructor does.
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
  /// Removes all curves. \pre if there are any, the triangulation is where it was
  ~Edge_path_network() { m_segments.release_edges(); }

  /// The triangulation that the curves lie in.
  Triangulation& triangulation() const { return *m_triangulation; }

  /// \name Building
  /// @{

  /*!
   * Adds a curve along halfedges of the triangulation, each segment rightmost on its edge as seen along its halfedge.
   *
   * \param halfedges a chain: the head of each is the tail of the next, and the last's of the first if `is_closed`
   * \param is_closed is the curve a loop without ends?
   * \return the curve's index; curves are numbered from 0
   * \throws Invalid_curve_error if the halfedges are no chain
   */
  template <class HalfedgeRange>
  Curve_index add_curve(const HalfedgeRange& halfedges, bool is_closed)
  {
    internal::check_chain(*m_triangulation, halfedges, is_closed);
    const Curve_index curve = m_segments.add_curve(halfedges, is_closed);
    reset_initial_length(curve);
    return curve;
  }

  /// Fixes every node at vertex `v` that a curve passes now: it stays where it is, and strands cannot cross it.
  void fix_nodes_at(Vertex_index v)
  {
    for(Segment_index s(1); s.idx() < m_segments.end_of_ids(); ++s)
      if(is_alive(s) && m_triangulation->head(halfedge(s)) == v)
        set_head_fixed(s, true);
  }

  /// Fixes or frees the node at the head of `s`. \pre if it is freed, the strands there do not cross
  void set_head_fixed(Segment_index s, bool is_fixed) { m_segments.set_head_fixed(s, is_fixed); }

  /// Frees all nodes of a curve, but the ends of an open one.
  /// \throws Crossing_curves_error if strands cross at one of them; nothing is changed then
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
      throw Crossing_curves_error("strands cross at vertex " + std::to_string(v.idx()),
                                  {static_cast<std::size_t>(v.idx())});
    }
  }

  /// Takes the present length of a curve for its initial one, for instance once it is the polyline that was drawn.
  void reset_initial_length(Curve_index curve) { set_initial_length(curve, length(curve)); }

  /// Sets the initial length of a curve that was shorter already when it was added.
  void set_initial_length(Curve_index curve, double length) { m_segments.set_initial_length(curve, length); }

  /// Rearranges the stack of edge `e`. \pre `order` is a permutation of `stack(e)`
  void set_stack(Edge_index e, const std::vector<Segment_index>& order) { m_segments.set_stack(e, order); }

  /*!
   * Makes a point of the surface a vertex of the triangulation, as `Intrinsic_triangulation::insert()`. Segments on an
   * edge that is split become two each, with a joint that is not fixed; their order stays.
   * \return the new vertex, or the one that is there already
   * \throws as `Intrinsic_triangulation::insert()`
   */
  Vertex_index insert(const Surface_location& location)
  {
    return Division(*m_triangulation, m_segments).insert(location);
  }

  /// Splits the edge of `h` with all its segments, as `Intrinsic_triangulation::split_edge()`.
  Vertex_index split_edge(Halfedge_index h, const Surface_location& location, std::size_t gap)
  {
    return Division(*m_triangulation, m_segments).split_edge(h, location, gap);
  }

  /// Removes all curves. Linear in the segments.
  void clear() { m_segments.clear(); }

  /// @}
  /// \name Curves
  /// @{

  /// The number of curves added, those that have contracted included; curves are numbered from 0.
  Index number_of_curves() const { return m_segments.number_of_curves(); }
  /// All curves, a range with random access: `for(Curve_index c : network.curves())`.
  auto curves() const { return internal::descriptors<Curve_index>(number_of_curves()); }

  /// One more than the largest segment id given so far; ids start at 1.
  Index end_of_segment_ids() const { return m_segments.end_of_ids(); }

  /// The first segment of a curve, `null_index` if the curve has shrunk to a point.
  Segment_index first_segment(Curve_index curve) const { return m_segments.first(curve); }
  /// The last segment of a curve, `null_index` if the curve has shrunk to a point.
  Segment_index last_segment(Curve_index curve) const { return m_segments.last(curve); }
  /// Is the curve a loop without ends?
  bool is_closed(Curve_index curve) const { return m_segments.is_closed(curve); }
  /// Has the curve shrunk to a point?
  bool is_contracted(Curve_index curve) const { return first_segment(curve) == null_index; }

  /// The length of a curve when it was added.
  double initial_length(Curve_index curve) const { return m_segments.initial_length(curve); }

  /// The length of a curve, summed over its segments.
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

  /// The halfedges of a curve, in order.
  std::vector<Halfedge_index> halfedges(Curve_index curve) const
  {
    std::vector<Halfedge_index> result;
    for_each_segment(curve, [&](Segment_index s) { result.push_back(halfedge(s)); });
    return result;
  }

  /// @}
  /// \name Segments
  /// @{

  /// Is `s` a segment of a curve now? Ids of segments that were replaced stay dead.
  bool is_alive(Segment_index s) const { return m_segments.is_alive(s); }
  /// The halfedge that segment `s` runs along, `null_index` if it is dead.
  Halfedge_index halfedge(Segment_index s) const { return m_segments.halfedge(s); }
  /// The curve of segment `s`.
  Curve_index curve(Segment_index s) const { return m_segments.curve(s); }
  /// The next segment of the curve, `null_index` at the end of a path.
  Segment_index next(Segment_index s) const { return m_segments.next(s); }
  /// The previous segment of the curve, `null_index` at the start of a path.
  Segment_index previous(Segment_index s) const { return m_segments.previous(s); }
  /// Is the node at the head of `s` fixed? So is the end of a path.
  bool is_head_fixed(Segment_index s) const { return m_segments.is_head_fixed(s); }

  /// Does any segment of this network lie on the edge of `h`?
  bool is_occupied(Halfedge_index h) const { return m_segments.is_occupied(h); }

  /// The segments on edge `e`, from left to right as seen along halfedge `2e`.
  std::vector<Segment_index> stack(Edge_index e) const { return m_segments.stack(e); }

  /// The outermost segment on a side of the edge of `h`, as seen along `h`. \pre `is_occupied(h)`
  Segment_index outermost(Halfedge_index h, Side side) const { return m_segments.outermost(h, side); }

  /// @}
  /// \name Ends and wedges
  /// @{

  /// The two ends at a joint: the wedge on its side lies clockwise from the first to the second.
  std::pair<Strand_end, Strand_end> ends(const Joint& joint) const
  {
    const Segment_index x = joint.incoming, y = next(x);
    const Strand_end at_x = {Triangulation::twin(halfedge(x)), x}, at_y = {halfedge(y), y};
    return joint.side == Side::LEFT ? std::make_pair(at_x, at_y) : std::make_pair(at_y, at_x);
  }

  /// The next end clockwise about the node; none if the border, or an edge that only other networks hold, comes first.
  /// Linear in the incident edges passed.
  Strand_end next_clockwise(const Strand_end& end) const
  {
    return next_end(end, Side::RIGHT, [](const Walker& h) { return h.is_held(); });
  }

  /// The next end counterclockwise about the node; none if the border, or an edge that only other networks hold, comes
  /// first. Linear in the incident edges passed.
  Strand_end next_counterclockwise(const Strand_end& end) const
  {
    return next_end(end, Side::LEFT, [](const Walker& h) { return h.is_held(); });
  }

  /// The next end of this network about the node, clockwise if `side` is `Side::RIGHT`, otherwise counterclockwise,
  /// whatever other networks hold in between; none if the border comes first. Linear in the incident edges passed.
  Strand_end next_beyond_others(const Strand_end& end, Side side) const
  {
    return next_end(end, side, [this](const Walker& h) { return h.is_held() && m_segments.leftmost(h) != no_segment; });
  }

  /// Looks into the wedge of a joint, no further than to \f$\pi\f$.
  Wedge wedge(const Joint& joint) const
  {
    const Wedge result = look_into_wedge(joint);
    m_segments.note_straight(joint.incoming, joint.side,
                             result.state == Wedge_state::STRAIGHT || result.state == Wedge_state::BORDER);
    return result;
  }

  /// Do the two ends of a joint lie on one spoke, next to each other, so that the joint turns back on itself?
  bool is_turning_back(const Joint& joint) const
  {
    const auto [a, b] = ends(joint);
    return a.halfedge == b.halfedge && m_segments.neighbor(a.segment, a.halfedge, Side::RIGHT) == b.segment;
  }

  /// @}
  /// \name Moves
  /// @{

  /*!
   * Moves a joint over its wedge: replaces its two segments by segments along `arc`. The arc leads from the head of the
   * joint's first end to that of its second, with the wedge on its right. The new segments are outermost on that side.
   * An empty arc cancels a joint that turns back.
   *
   * \param affected receives the joints that are new, or newly adjacent: the complete list of those to look at again,
   *        without the sides of which it is known that they are not below \f$\pi\f$
   * \return the first new segment in the direction of the curve, `null_index` if there is none
   * \pre the angles of the arc on its right are at least \f$\pi\f$
   */
  Segment_index replace_joint(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected)
  {
    return internal::Joint_replacement<Edge_path_network>(*this, m_segments)(joint, arc, affected);
  }

  /*!
   * Replaces the one segment of a loop by two [SC20, Appendix B]. They run along the other two edges of the face on the
   * left of `h`, the segment's halfedge or its twin.
   * \return the new segment that arrives at the old node
   */
  Segment_index perturb_loop(Segment_index s, Halfedge_index h) { return m_segments.perturb_loop(s, h); }

#ifdef DOXYGEN_RUNNING
  /// Where a segment lies in its stack: what is needed to put another one into its place.
  using Stack_place = unspecified_type;
#else
  using Stack_place = internal::Stack_place;
#endif

  /// The place of segment `s`, to be kept for `restore_loop()`.
  Stack_place stack_place(Segment_index s) const { return m_segments.stack_place(s); }

  /// Replaces a closed curve by the one segment that it was when `place` was taken. \pre the flips since are undone
  Segment_index restore_loop(Curve_index curve, const Stack_place& place)
  {
    return m_segments.restore_loop(curve, place);
  }

  /// @}

  /// Checks the invariant; linear in the segments and the degrees of the vertices they touch.
  bool is_valid() const { return internal::Network_validity<Edge_path_network>(*this).is_valid(); }

  /*!
   * Do the ends about the vertex of `end` form a non-crossing matching, with all ends of curves, fixed nodes and the
   * border in one region?
   */
  bool is_non_crossing_at(const Strand_end& end) const
  {
    return internal::Network_validity<Edge_path_network>(*this).is_non_crossing_at(end);
  }

private:
  friend struct internal::Internals<Edge_path_network>;
  using Walker = typename Triangulation::Walker;
  using Division = internal::Segment_division<Triangulation>;

  static constexpr Segment_index no_segment{0};

  // The outermost segment on the first edge at which `is_end(h)` holds; none if only other networks hold that edge.
  template <class IsEnd>
  Strand_end next_end(const Strand_end& end, Side side, const IsEnd& is_end) const
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

  // The outermost segment on an edge, on the side given as seen from the node; none if only other networks hold it.
  Strand_end end_on(const Walker& h, Side side) const
  {
    const Segment_index first = m_segments.leftmost(h);
    return first == no_segment ? Strand_end{} : Strand_end{h.index(), m_segments.outermost(h.index(), first, side)};
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

  /* Inserts points with hints where they are, and splits edges, with all segments. */
  static auto splitter(Network& network)
  {
    return typename Network::Division(*network.m_triangulation, network.m_segments);
  }

  /*
   * Takes the state that read_network() has read. Returns false, and leaves the network empty, if its curves are not
   * chains in the triangulation as it is, or its stacks not those of their edges. Whether curves cross is not checked:
   * they may before they are put in order. \pre there are no curves
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
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_EDGE_PATH_NETWORK_H
