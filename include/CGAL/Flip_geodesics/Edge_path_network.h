// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EDGE_PATH_NETWORK_H
#define CGAL_FLIP_GEODESICS_EDGE_PATH_NETWORK_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/network/Segment_store.h>
#include <CGAL/Flip_geodesics/internal/network/Stack_order.h>
#include <CGAL/Flip_geodesics/internal/network/Stack_order_search.h>
#include <CGAL/Flip_geodesics/internal/network/network_parts.h>
#include <CGAL/Flip_geodesics/internal/surface/Internals.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/spokes.h>

#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
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

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The chain of halfedges of the triangulation that passes given vertices, one edge between each two.
 *
 * \param vertices a range of vertex indices; a closed curve does not repeat the first
 * \throws Vertex_out_of_range_error
 * \throws Invalid_curve_error if there are fewer than two vertices, or two in a row share no edge
 *
 * Complexity: linear in the degrees of the vertices.
 */
template <class Triangulation, class VertexRange>
std::vector<Halfedge_index> halfedges_through(const Triangulation& triangulation, const VertexRange& vertices,
                                              bool is_closed)
{
  static_assert(internal::is_range_of<VertexRange, Vertex_index>,
                "the vertices are not a range of vertices of the triangulation, Vertex_index");
  std::vector<Vertex_index> v;
  for(Vertex_index vertex : vertices) {
    internal::check_vertex(vertex, triangulation.number_of_vertices(), v.size());
    v.push_back(vertex);
  }
  if(v.size() < 2)
    throw Invalid_curve_error("a curve needs at least two vertices");
  if(is_closed)
    v.push_back(v.front());
  std::vector<Halfedge_index> result;
  for(std::size_t i = 0; i + 1 < v.size(); ++i) {
    result.push_back(internal::halfedge_between(triangulation, v[i], v[i + 1]));
    if(result.back() == null_index)
      throw Invalid_curve_error("a curve is not connected: no edge joins vertex " + std::to_string(v[i].idx()) +
                                    " and vertex " + std::to_string(v[i + 1].idx()),
                                {static_cast<std::size_t>(v[i].idx()), static_cast<std::size_t>(v[i + 1].idx())});
  }
  return result;
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The chain of input halfedges along shortest edge paths from each way point to the next.
 *
 * \param search a `Shortest_edge_path` over the network's triangulation, whose edges are still the input's
 * \param way_points vertex indices, at least two; those that repeat the one before count once. A closed curve need not
 *        repeat the first
 * \param is_closed says whether the chain leads back to the first way point
 * \param visitor nothing, or a model of `FlipOutVisitor`, of which only `go_further()` is called, by the searches. If
 *        it returns `false`, then no halfedges are returned
 * \throws Invalid_curve_error for fewer than two way points, or if all are one vertex
 * \throws Vertex_out_of_range_error, Disconnected_endpoints_error as `Shortest_edge_path`
 */
template <class Search, class VertexRange, class... Visitor>
std::vector<Halfedge_index> shortest_halfedges_through(Search& search, const VertexRange& way_points,
                                                       bool is_closed = false, Visitor&&... visitor)
{
  std::vector<Vertex_index> v(std::begin(way_points), std::end(way_points));
  if(v.size() < 2)
    throw Invalid_curve_error("a curve needs at least two way points");
  if(is_closed)
    v.push_back(v.front());
  std::vector<Halfedge_index> result;
  for(std::size_t i = 0; i + 1 < v.size(); ++i) {
    const std::vector<Halfedge_index> leg = search(v[i], v[i + 1], visitor...); // also refuses what is no vertex
    if(leg.empty() && v[i] != v[i + 1])                                         // stopped by the visitor
      return {};
    result.insert(result.end(), leg.begin(), leg.end());
  }
  if(result.empty())
    throw Invalid_curve_error("all way points of a curve are vertex " + std::to_string(v.front().idx()) +
                                  "; the curve is a point, and has no edges",
                              {static_cast<std::size_t>(v.front().idx())});
  return result;
}

namespace internal {

/* A set of edges of a triangulation: a sign for each. */
using Edge_marks = Indexed_by<Edge_index, std::vector<char>>;

/* How many edges of a set end at each vertex. */
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

/* Calls `add()`, which adds curves. Returns how many; if it throws, a network that was empty is empty again. */
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

/* Adds the chains of a set of edges between the vertices for which `is_node(v)` holds, and the closed ones. Returns how
 * many. \pre two edges end at each vertex of the set that is no node */
template <class Network, class IsNode>
Index add_chains(Network& network, Edge_marks is_open, const IsNode& is_node)
{
  const auto& triangulation = network.triangulation();
  // The way on from the head of h, null_index at a node.
  const auto next_open = [&](Halfedge_index h) -> Halfedge_index {
    if(is_node(triangulation.head(h)))
      return null_index;
    for(Halfedge_index g : spokes(triangulation, triangulation.head(h)))
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
        network.add_curve(walk(h), false);
    for(Edge_index e : descriptors<Edge_index>(triangulation.number_of_edges()))
      if(is_open[e] != 0)
        network.add_curve(walk(first_side(e)), true);
  });
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds the network formed by the marked edges of the input mesh: a curve for each chain between vertices where other
 * than two marked edges meet, which are its fixed ends. A loop without such a vertex becomes a closed one. Open curves
 * come first. Each begins with the smaller of the halfedges that leave its two ends and lie on it, and they are ordered
 * by these halfedges. Closed curves follow, ordered by their smallest edges. If the function throws, a network that was
 * empty is empty again. Linear in the mesh.
 *
 * \param mesh the triangulation's mesh
 * \param is_marked a model of `ReadablePropertyMap` with the mesh's edges as keys and `bool` as values
 * \return the number of curves added
 * \pre the triangulation's edges are still the input's
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

/* Orders the strands on each edge. Returns what is in the way, if there is anything; then the order is of no use. */
template <class Network>
Order_conflict order_stacks(Network& network)
{
  const Stack_pairs<Network> pairs(network);
  if(pairs.conflict() || pairs.number_of_stacks() == 0)
    return pairs.conflict();
  Crossing_equations<Network> equations(pairs);
  if(equations.conflict())
    return equations.conflict();
  Stack_order_search<Network> search(equations);
  if(const Order_conflict conflict = search.run())
    return conflict;
  for(Index i = 0; i < pairs.number_of_stacks(); ++i)
    network.set_stack(pairs.edge(i), search.order(i));
  return {};
}

/* As `order_overlapping_curves()`, but returns what it throws. */
template <class Network>
Order_conflict order_if_possible(Network& network)
{
  Order_conflict conflict = order_stacks(network);
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
 * Finds the order in which the curves of a network lie side by side on the edges that they share. In it no two cross,
 * nor does one cross itself. To be called after the curves were added: `add_curve()` puts them on an edge in the order
 * in which they come.
 *
 * Two strands that share a run of edges are ordered by where they part, at either end of it. Where a path ends, or has
 * a fixed node, the order is left open. But all such ends at a vertex, and the border, must be on one side of each
 * curve that passes. What is left open at both ends follows from the order of others on the same edges, or else is
 * chosen. The strand that was added first is then on the left, as seen along it. It is seen against it if its curve has
 * turned back an odd number of times before. So copies of a curve that does not turn back lie to its right.
 *
 * The answer depends on the connectivity only, and is exact. If there is an order, it is found. If there is none, the
 * curves cross however they lie. Two do that part on opposite sides at the ends of a run. So does one that goes around
 * an annulus twice before it closes. Only where long paths turn back on each other again and again, and their choices
 * interlock, may the search be given up.
 *
 * If it throws, the curves are unchanged, but the order along the edges may not be.
 *
 * Complexity: for \f$n\f$ segments, \f$O(n \log n)\f$ and the degrees of the vertices they pass. If edges have several,
 * there are \f$p\f$ pairs of segments on one edge besides. They take \f$O(p \log p)\f$ time, half a second per million,
 * and \f$O(p)\f$ memory. Where the choices above do not fit together, it is \f$p\f$ times the most segments on one
 * edge.
 *
 * \param network an `Edge_path_network`
 * \throws Crossing_curves_error with a vertex at which curves cross; where only several vertices together make it
 *         impossible that they do not, with one of these
 * \throws Ambiguous_order_error with the vertices of a shared edge, if the search is given up
 */
template <class Network>
void order_overlapping_curves(Network& network)
{
  if(const internal::Order_conflict conflict = internal::order_if_possible(network))
    conflict.raise();
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_EDGE_PATH_NETWORK_H
