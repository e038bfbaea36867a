// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SHORTEST_TREE_REPAIR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SHORTEST_TREE_REPAIR_H

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_search.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Segment_insertion.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/shortest/geodesic_tree_parts.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* A path of edges, and the flips of the input that create these edges. */
struct Flipped_start
{
  std::vector<Halfedge_index> flips, path;
};

template <class Triangulation>
Flipped_start flipped_start(const Triangulation& triangulation, const std::vector<Halfedge_index>& path)
{
  Flipped_start result = {{}, path};
  for(std::size_t i = 0; i < triangulation.log_position(); ++i)
    if(triangulation.flip_record(i).is_flip())
      result.flips.push_back(triangulation.flip_record(i).h);
  return result;
}

/* Returns the current path of the only curve of a network. */
template <class Network>
Flipped_start flipped_start_of(const Network& network)
{
  std::vector<Halfedge_index> path;
  network.for_each_segment(Curve_index(0), [&](Segment_index s) { path.push_back(network.halfedge(s)); });
  return flipped_start(network.triangulation(), path);
}

/* Shortens the path to a geodesic, as the only curve of a network. */
template <class Network, class Visitor>
Shortening_report pull_tight(Network& network, const Flipped_start& start, Visitor& visitor)
{
  network.clear();
  network.triangulation().rollback(0);
  for(Halfedge_index h : start.flips)
    network.triangulation().flip(h);
  network.add_curve(start.path);
  return shorten(network, Never_stop_predicate(), visitor);
}

/* Adds the steps of a path that was replaced, and the flips that led to the new path. */
inline void count_before(Shortening_report& shortening, const Shortening_report& before, std::size_t flips)
{
  shortening.curves[0].initial_length = before.curves[0].initial_length;
  shortening.flips += before.flips + flips;
  shortening.flip_outs += before.flip_outs;
}

/* Returns whether a face has one side as long as the two others together, up to rounding errors, while the metric
 * represents all faces by vectors. Trees of geodesics can then be grown in an intrinsic Delaunay triangulation. Linear
 * in the mesh. */
template <class Triangulation>
bool has_flat_face(const Triangulation& triangulation)
{
  const auto& input = triangulation.input();
  const auto length = [&](Input_halfedge_index h) { return triangulation.metric().weight(input, h); };
  bool result = false;
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
    if(input.is_border(h))
      continue;
    if(!is_usable_face(triangulation.metric(), input, h))
      return false;
    const Input_halfedge_index hn = input.next(h);
    result = result || length(h) >= (length(hn) + length(input.next(hn))) * (1 - length_sum_rounding);
  }
  return result;
}

/* Returns the path of a geodesic tree grown in an intrinsic Delaunay triangulation of the input. */
template <class Network>
std::vector<Halfedge_index> path_in_tree(Network& network, Vertex_index from, Vertex_index to)
{
  using Triangulation = typename Network::Triangulation;
  network.clear();
  network.triangulation().rollback(0);
  flip_to_delaunay(network.triangulation());
  Geodesic_tree<Triangulation> tree(network.triangulation());
  tree.grow(from);
  return tree.path(to);
}

/*
 * Initial paths that window propagation misses beside degenerate faces, where straight rays cannot be followed. An
 * intrinsic Delaunay triangulation has no such faces except at coincident vertices, so the path of a tree grown
 * there is usually a shortest one. One tree is grown from either end.
 */
template <class Network>
std::vector<Flipped_start> starts_in_trees(Network& network, Vertex_index source, Vertex_index target)
{
  using Triangulation = typename Network::Triangulation;
  std::vector<Flipped_start> result;
  std::vector<Halfedge_index> path = path_in_tree(network, source, target);
  if(!path.empty())
    result.push_back(flipped_start(network.triangulation(), path));
  path = path_in_tree(network, target, source);
  std::reverse(path.begin(), path.end());
  std::transform(path.begin(), path.end(), path.begin(), [](Halfedge_index h) { return Triangulation::twin(h); });
  if(!path.empty())
    result.push_back(flipped_start(network.triangulation(), path));
  return result;
}

/* Returns the last segment of the shortest path found by a search. \pre the path has an edge */
template <class Triangulation, class Search>
Last_leg last_leg(const Triangulation&, const Search& search, Vertex_index v)
{
  return search.last_leg(v);
}

template <class Triangulation, class Faces>
Last_leg last_leg(const Triangulation& triangulation, const Window_search<Triangulation, Faces>& search, Vertex_index v)
{
  const auto leg = search.leg(v);
  const Strip<Triangulation> strip(triangulation, leg.sequence.reversed());
  return {leg.from, strip.reference(), angle_from_reference(strip.end()), strip.length()};
}

/*
 * Replaces the paths of a tree that are not shortest by shortest ones.
 *
 * Shortest paths from one vertex do not cross. Once the longer paths are removed, a shortest path to a nearest vertex
 * among the removed ones therefore crosses no edge of the tree; its last segment is traced backward through the
 * triangulation to the first vertex on it and inserted there by flips.
 *
 * Paths in the tree that are shortest only up to rounding errors can cross such a segment; they are then removed as
 * well, each at most once. A segment that crosses one face several times, as on rough terrain, cannot be inserted by
 * these flips: such segments come last, after the edges beside the tree have been flipped to Delaunay.
 *
 * The search provides the distances of the input vertices and the last segments of their paths.
 */
template <class Tree, class Search = Window_search<typename Tree::Triangulation>>
class Shortest_tree_repair
{
  using Triangulation = typename Tree::Triangulation;
  using Grafts = typename Tree::Grafts;
  using Vector = std::complex<double>;

public:
  /* \param interruption if it occurs, the paths that have not been inserted by then are grown as before */
  Shortest_tree_repair(Tree& tree, const Search& search, double tolerance, Interruption* interruption = nullptr)
    : m_tree(tree)
    , m_triangulation(tree.triangulation())
    , m_search(search)
    , m_tolerance(tolerance)
    , m_interruption(interruption)
  {
  }

  /* Returns the vertices whose paths are longer than shortest ones, or pass such a vertex, in order of distance. */
  std::vector<Vertex_index> longer() const
  {
    std::vector<Vertex_index> order = vertices_by_distance();
    Indexed_by<Vertex_index, std::vector<char>> is_longer(
        static_cast<std::size_t>(m_triangulation.number_of_vertices()), 0);
    std::vector<Vertex_index> result;
    for(Vertex_index v : order) {
      const Halfedge_index h = m_tree.incoming(v);
      const bool has_longer_parent = h != null_index && is_longer[m_triangulation.tail(h)] != 0;
      if(m_tree.distance(v) <= m_search.distance(v) * (1 + m_tolerance) && !has_longer_parent)
        continue;
      is_longer[v] = 1;
      result.push_back(v);
    }
    return result;
  }

  /* Replaces the paths of such vertices. */
  Shortening_status run(const std::vector<Vertex_index>& longer)
  {
    return m_tree.replace_paths([&](Grafts& grafts) { replace(grafts, longer); }).status;
  }

  std::size_t flips() const { return m_flips; }

private:
  void replace(Grafts& grafts, const std::vector<Vertex_index>& longer)
  {
    m_is_taken_off.assign(static_cast<std::size_t>(m_triangulation.number_of_vertices()), 0);
    for(Vertex_index v : longer)
      take_off(grafts, v);
    for(Vertex_index v : inserted_behind_taken_off())
      take_off(grafts, v);
    const std::vector<Vertex_index> failed = insert_last_legs(grafts);
    if(!failed.empty() && !(m_interruption != nullptr && m_interruption->has_occurred()))
    { // a segment that crosses one face several times; faces are compact now
      flip_to_delaunay_beside_tree();
      for(Vertex_index v : failed)
        m_pending.insert({m_search.distance(v), v});
      insert_last_legs(grafts);
    }
  }

  // The search does not cover inserted vertices; returns those whose paths pass a removed vertex.
  std::vector<Vertex_index> inserted_behind_taken_off() const
  {
    std::vector<Vertex_index> result;
    for(Vertex_index v(m_triangulation.input().number_of_vertices()); v.idx() < m_triangulation.number_of_vertices();
        ++v) {
      Vertex_index w = v;
      while(m_tree.incoming(w) != null_index)
        w = m_triangulation.tail(m_tree.incoming(w));
      if(m_tree.is_reached(v) && w != m_tree.source())
        result.push_back(v);
    }
    return result;
  }

  std::vector<Vertex_index> vertices_by_distance() const
  {
    std::vector<Vertex_index> order;
    for(Vertex_index v : descriptors<Vertex_index>(m_triangulation.input().number_of_vertices()))
      if(m_search.distance(v) <= m_tree.max_distance() && m_search.is_reached(v))
        order.push_back(v);
    std::sort(order.begin(), order.end(), [this](Vertex_index v, Vertex_index w) {
      const double a = m_search.distance(v), b = m_search.distance(w);
      return a != b ? a < b : v < w;
    });
    return order;
  }

  void take_off(Grafts& grafts, Vertex_index v)
  {
    grafts.take_off(v);
    m_is_taken_off[v] = 1;
    if(!m_triangulation.is_inserted(v) && m_search.is_reached(v))
      m_pending.insert({m_search.distance(v), v});
  }

  void take_off_subtree(Grafts& grafts, Vertex_index v)
  {
    std::vector<Vertex_index> subtree = {v};
    for(std::size_t i = 0; i < subtree.size(); ++i)
      for(Halfedge_index outgoing_halfedge : outgoing_halfedges(m_triangulation, subtree[i]))
        if(m_tree.incoming(m_triangulation.head(outgoing_halfedge)) == outgoing_halfedge)
          subtree.push_back(m_triangulation.head(outgoing_halfedge));
    for(Vertex_index w : subtree)
      take_off(grafts, w);
  }

  // Inserts the last segments of the pending paths, the nearest first. Returns the vertices for which this failed.
  std::vector<Vertex_index> insert_last_legs(Grafts& grafts)
  {
    std::vector<Vertex_index> failed;
    while(!m_pending.empty() && !is_interrupted_before_part(m_interruption)) {
      const Vertex_index v = m_pending.begin()->second;
      m_pending.erase(m_pending.begin());
      m_in_the_way = null_index;
      if(insert_last_leg(grafts, v))
        continue;
      // A path in the tree that is shortest up to rounding errors but crosses this one is removed, once.
      if(m_in_the_way != null_index && m_is_taken_off[m_in_the_way] == 0) {
        take_off_subtree(grafts, m_in_the_way);
        m_pending.insert({m_search.distance(v), v});
      } else {
        failed.push_back(v);
      }
    }
    return failed;
  }

  // Returns false and leaves v without a path if an edge obstructs it, which only rounding errors can cause.
  bool insert_last_leg(Grafts& grafts, Vertex_index v)
  {
    std::vector<Halfedge_index> chain = traced(v, last_leg(m_triangulation, m_search, v));
    if(chain.empty())
      return false;
    m_flips += straighten_on_the_right(m_triangulation, chain);
    const Halfedge_index h = Triangulation::twin(chain.front());
    const double length = m_tree.distance(m_triangulation.tail(h)) + m_triangulation.length(h);
    if(!(length <= m_search.distance(v) * (1 + m_tolerance))) // infinite without a path to the tail
      return false;
    grafts.hang(v, h);
    return true;
  }

  // Flips all edges that belong neither to the tree nor to a curve.
  void flip_to_delaunay_beside_tree()
  {
    const auto for_each_edge_of_tree = [this](auto function) {
      for(Vertex_index v : descriptors<Vertex_index>(m_triangulation.number_of_vertices()))
        if(m_tree.incoming(v) != null_index)
          function(Triangulation::edge(m_tree.incoming(v)));
    };
    for_each_edge_of_tree([this](Edge_index e) { m_triangulation.hold(e); });
    try {
      m_flips += flip_to_delaunay(m_triangulation).flips;
    } catch(...) {
      for_each_edge_of_tree([this](Edge_index e) { m_triangulation.release(e); });
      throw;
    }
    for_each_edge_of_tree([this](Edge_index e) { m_triangulation.release(e); });
  }

  /*
   * Follows the last segment from v back through the current triangulation to the first vertex on it. Returns halfedges
   * from v to that vertex along the left side of the faces passed; none if the line is lost among faces or meets an
   * edge of the tree, whose farther end is recorded.
   */
  std::vector<Halfedge_index> traced(Vertex_index v, const Last_leg& leg)
  {
    const Vertex_directions<Triangulation> directions = directions_of(leg, v);
    const double direction = directions.of_input(leg.halfedge) + leg.angle, length = leg.length;
    double offset = 0;
    const Halfedge_index outgoing_halfedge = last_outgoing_halfedge_before(directions, leg, direction, offset);
    if(outgoing_halfedge == null_index)
      return {};
    if(offset <= straight_leg)
      return {outgoing_halfedge};
    if(m_triangulation.is_border(outgoing_halfedge))
      return {};
    // In the frame of the line.
    Face_vectors face = face_along(outgoing_halfedge, std::polar(m_triangulation.length(outgoing_halfedge), -offset));
    Vector right = face[0], left = -face[2], portal = -face[1];
    if(std::abs(std::arg(left)) <= straight_leg)
      return {Triangulation::twin(m_triangulation.previous(outgoing_halfedge))};
    std::vector<Halfedge_index> crossed = {m_triangulation.next(outgoing_halfedge)};
    while(!is_in_tree(crossed.back()) && crossed.size() < most_crossings) {
      const Halfedge_index entered = Triangulation::twin(crossed.back());
      if(m_triangulation.is_border(entered))
        return {};
      face = face_along(entered, portal);
      const Vector apex = std::abs(face[1]) < std::abs(face[2]) ? right + face[1] : left - face[2];
      const Vertex_index w = m_triangulation.tail(m_triangulation.previous(entered));
      const bool is_end = w == leg.from && std::abs(apex - length) <= straight_leg * length;
      if(is_end || is_passed(apex, length))
        return left_side_of_strip(m_triangulation, crossed);
      const bool is_leaving_right = apex.imag() > 0;
      portal = is_leaving_right ? -face[1] : -face[2];
      (is_leaving_right ? left : right) = apex;
      crossed.push_back(is_leaving_right ? m_triangulation.next(entered) : m_triangulation.previous(entered));
    }
    const Halfedge_index h = crossed.back();
    const Vertex_index w = m_triangulation.head(h);
    // Otherwise the line was lost among degenerate faces.
    if(is_in_tree(h))
      m_in_the_way = m_tree.incoming(w) == h ? w : m_triangulation.tail(h);
    return {};
  }

  // At the end of a segment, in the umbrella by which it arrives.
  Vertex_directions<Triangulation> directions_of(const Last_leg& leg, Vertex_index v) const
  {
    Vertex_directions<Triangulation> usual(m_triangulation, v);
    return usual.has(leg.halfedge) ? usual : Vertex_directions<Triangulation>(m_triangulation, leg.halfedge);
  }

  // Returns whether a line along the x-axis from 0 to `length` passes this point, up to negligible angles.
  static bool is_passed(const Vector& p, double length)
  {
    const double x = p.real(), beyond = length - x;
    return x > 0 && beyond > 0 && std::abs(p.imag()) <= straight_leg * (std::min)(x, beyond);
  }

  bool is_in_tree(Halfedge_index h) const
  {
    return m_tree.incoming(m_triangulation.head(h)) == h ||
           m_tree.incoming(m_triangulation.tail(h)) == Triangulation::twin(h);
  }

  /*
   * Returns the halfedge at the end of a segment in whose direction, or counterclockwise of which, a direction lies,
   * and the angle between the two. The triangulation's lengths nearly always determine it; otherwise the input decides.
   */
  Halfedge_index last_outgoing_halfedge_before(const Vertex_directions<Triangulation>& directions, const Last_leg& leg,
                                               double direction, double& offset) const
  {
    const std::vector<Halfedge_index> around = outgoing_halfedges_beside(m_triangulation, leg.halfedge);
    const std::vector<double> angles = estimated_directions(around, directions);
    std::size_t best = around.size();
    for(std::size_t i = 0; i < around.size(); ++i) {
      const double angle = behind(angles[i], direction, directions, outgoing_halfedge_drift);
      if(best == around.size() || angle < offset) {
        best = i;
        offset = angle;
      }
    }
    for(int tries = 0; best < around.size() && tries < 2; ++tries) {
      offset = behind(directions(around[best]), direction, directions, outgoing_halfedge_drift);
      if(offset >= -straight_leg)
        return offset < infinity ? around[best] : null_index;
      best = best + 1 == around.size() && !directions.has_border() ? 0 : best + 1; // clockwise
    }
    return null_index;
  }

  // The angle by which one direction follows another counterclockwise; slightly negative if it is just before it.
  static double behind(double first, double second, const Vertex_directions<Triangulation>& directions, double little)
  {
    const double angle = second - first;
    if(directions.has_border())
      return angle < -little ? infinity : angle;
    const double turned = angle < -little ? angle + directions.total() : angle;
    return turned > directions.total() - little ? turned - directions.total() : turned;
  }

  // The directions of the outgoing halfedges of a vertex: one is measured, the others follow from the angles that the
  // triangulation has between them.
  std::vector<double> estimated_directions(const std::vector<Halfedge_index>& around,
                                           const Vertex_directions<Triangulation>& directions) const
  {
    std::vector<double> result(around.size());
    std::size_t first = 0;
    const Outgoing_halfedge_places<Triangulation> places(m_triangulation);
    const bool has_inserted_vertices =
        m_triangulation.number_of_vertices() != m_triangulation.input().number_of_vertices();
    Edge_end place = has_inserted_vertices || around.empty() ? Edge_end() : places.known_place(around, first);
    for(std::size_t i = 0; i < around.size(); ++i) {
      const std::size_t k = (first + i) % around.size();
      if(i > 0)
        places.turn_clockwise(around[k], place);
      const Edge_sequence_angle& p = place.direction;
      result[k] = p.reference == null_index ? directions(around[k]) : directions.of_input(p.reference) + p.angle;
    }
    return result;
  }

  // Returns the vectors of h, next(h), previous(h) in the triangulation, rotated so that h lies along the given vector.
  Face_vectors face_along(Halfedge_index h, const Vector& along) const
  {
    using Traits = Double_face_traits<typename Triangulation::Metric::Kernel>;
    const Halfedge_index hn = m_triangulation.next(h), hp = m_triangulation.next(hn);
    const auto face = Traits().construct_face_from_lengths_object()(
        m_triangulation.length(h), m_triangulation.length(hn), m_triangulation.length(hp));
    return turned_along(face, along);
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t most_crossings = 1000000;

  Tree& m_tree;
  Triangulation& m_triangulation;
  const Search& m_search;
  double m_tolerance;
  Interruption* m_interruption; // null if it cannot be interrupted
  std::size_t m_flips = 0;
  Indexed_by<Vertex_index, std::vector<char>> m_is_taken_off;
  std::set<std::pair<double, Vertex_index>> m_pending; // vertices without a path, by their distances from the source
  Vertex_index m_in_the_way = null_index;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SHORTEST_TREE_REPAIR_H
