// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_GEODESIC_TREE_PARTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_GEODESIC_TREE_PARTS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * The labels of vertices in a growing tree: unknown, with an offered path that waits in the queue, or with an accepted
 * path. All labels are cleared in constant time, since each contains the number of the tree that wrote it.
 *
 * Invariant: an offered path has an entry in the queue, with its length, until that entry is removed. Entries of paths
 * that are no longer offered stay in the queue until then.
 */
class Tree_labels
{
public:
  explicit Tree_labels(std::size_t size)
    : m_labels(size)
  {
  }

  /* Clears all labels, for a tree over `size` vertices. */
  void start(std::size_t size)
  {
    if(m_labels.size() < size || m_epoch > (std::numeric_limits<Index>::max)() - 8) { // or no epoch is left
      m_labels = Labels(size);
      m_epoch = 0;
    }
    m_epoch += 4;
    m_queue.clear();
  }

  bool is_unknown(Vertex_index v) const { return state(v) == UNKNOWN; }
  bool is_offered(Vertex_index v) const { return state(v) == OFFERED; }
  bool is_settled(Vertex_index v) const { return state(v) == SETTLED; }

  /* Returns the length of the path; below, its last halfedge. \pre `v` is not unknown */
  double distance(Vertex_index v) const { return m_labels[v].distance; }
  Halfedge_index incoming(Vertex_index v) const { return m_labels[v].incoming; }

  /* Offers a path instead of the previous label. */
  void offer(Vertex_index v, double distance, Halfedge_index h)
  {
    m_labels[v] = {distance, h, m_epoch + OFFERED};
    m_queue.push(distance, v);
  }

  /* Accepts the offered path. */
  void settle(Vertex_index v)
  {
    CGAL_precondition(is_offered(v));
    m_labels[v].stamp = m_epoch + SETTLED;
  }

  /* Accepts another path. */
  void settle(Vertex_index v, double distance, Halfedge_index h) { m_labels[v] = {distance, h, m_epoch + SETTLED}; }

  void forget(Vertex_index v) { m_labels[v].stamp = m_epoch; }

  bool has_offers() const { return !m_queue.empty(); }

  /* Removes the shortest path from the queue, of equally long ones that to the smallest vertex; returns `null_index` if
   * it is no longer offered. \pre `has_offers()` */
  Vertex_index pop()
  {
    const double offered = m_queue.priority();
    const Vertex_index v = m_queue.pop();
    return is_offered(v) && distance(v) == offered ? v : null_index;
  }

private:
  enum State : Index { UNKNOWN = 0, OFFERED = 1, SETTLED = 2 };

  struct Label
  {
    double distance;
    Halfedge_index incoming;
    Index stamp; // the epoch, a multiple of 4, plus the state
  };

  using Labels = Indexed_by<Vertex_index, Lazy_array<Label>>;

  Index state(Vertex_index v) const
  {
    const Index stamp = m_labels[v].stamp - m_epoch;
    return m_epoch == 0 || stamp < 0 ? static_cast<Index>(UNKNOWN) : stamp;
  }

  Labels m_labels;
  Vertex_queue m_queue;
  Index m_epoch = 0;
};

/*
 * The directions at a vertex as angles in radians, counterclockwise from an input halfedge and measured on the input,
 * independently of the results of flips. On the border the angles start at the border. At a non-manifold vertex they
 * are those of one umbrella.
 */
template <class Triangulation>
class Vertex_directions
{
public:
  Vertex_directions(const Triangulation& triangulation, Vertex_index vertex)
    : m_triangulation(triangulation)
    , m_vertex(vertex)
  {
    if(triangulation.is_inserted(vertex))
      start_at(triangulation.location(vertex));
    else if(const Input_halfedge_index start = triangulation.input().outgoing(vertex); start != null_index)
      m_fan = umbrella_of(triangulation, start);
  }

  /* For the umbrella of an input halfedge that starts at the vertex. */
  Vertex_directions(const Triangulation& triangulation, Input_halfedge_index in_umbrella)
    : m_triangulation(triangulation)
    , m_vertex(triangulation.input().tail(in_umbrella))
    , m_fan(umbrella_of(triangulation, in_umbrella))
  {
  }

  /* Returns the sum of the input angles at the vertex. */
  double total() const { return m_fan.total(); }
  bool has_border() const { return m_fan.has_border(); }

  /* Returns whether an input halfedge belongs to the umbrella. */
  bool has(Input_halfedge_index h) const { return m_fan.has(h); }

  /* Returns the angle at which an input halfedge starts at the vertex.
   * \throws Invalid_mesh_error if it belongs to another umbrella */
  double of_input(Input_halfedge_index h) const { return m_fan.angle_of(h, m_vertex); }

  /* Returns the angle of a strip that starts at the vertex. */
  double operator()(const Strip<Triangulation>& strip) const
  {
    if(!m_is_inside_face)
      return of_input(strip.reference()) + angle_from_reference(strip.end());
    const double angle = std::arg(strip.end());
    return angle < 0 ? angle + total() : angle;
  }

  /* Returns the angle of a halfedge of the triangulation that starts at the vertex. */
  double operator()(Halfedge_index h) const
  {
    return (*this)(Strip<Triangulation>(m_triangulation, m_triangulation.edge_sequence(h)));
  }

  /* Returns the angle counterclockwise from one direction to another; infinite if the border intervenes. */
  double counterclockwise(double from, double to) const { return m_fan.counterclockwise(from, to); }

private:
  // An inserted point is flat, with one reference direction inside a face and two along an edge.
  void start_at(const Surface_location& location)
  {
    const Input_halfedge_index h = location.halfedge;
    m_is_inside_face = kind(location) == Location_kind::FACE;
    m_fan.set_flat(h, !m_is_inside_face && m_triangulation.input().is_border(twin_index(h)));
  }

  const Triangulation& m_triangulation;
  Vertex_index m_vertex;
  Vertex_fan m_fan;
  bool m_is_inside_face = false;
};

/*
 * Computes the starts of consecutive halfedges of a triangulation at a vertex of the input: the corner by counting the
 * input edges that start in between, the angle in it by the lengths of the triangulation.
 */
template <class Triangulation>
class Outgoing_halfedge_places
{
public:
  explicit Outgoing_halfedge_places(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* Returns the position of one of the halfedges around a vertex, and its number: that of an input edge if there is
   * one, or else of the edge with the fewest crossings. */
  Edge_end known_place(const std::vector<Halfedge_index>& around, std::size_t& number) const
  {
    const auto is_of_input = [this](Halfedge_index h) { return m_triangulation.version(Triangulation::edge(h)) == 0; };
    const auto crosses_less = [this](Halfedge_index g, Halfedge_index h) { return crossings(g) < crossings(h); };
    const auto of_input = std::find_if(around.begin(), around.end(), is_of_input);
    const bool is_known = of_input != around.end();
    const auto nearest = is_known ? of_input : std::min_element(around.begin(), around.end(), crosses_less);
    number = static_cast<std::size_t>(nearest - around.begin());
    return is_known ? Edge_end{*nearest, {as_input(*nearest), 0, 0}, true}
                    : edge_straightness(m_triangulation)(*nearest).tail;
  }

  /* Advances from the position of the previous halfedge to that of h, the next one clockwise, across the input edges
   * that start in between. */
  void turn_clockwise(Halfedge_index h, Edge_end& place) const
  {
    const Halfedge_index opposite = m_triangulation.next(h), before = m_triangulation.next(opposite);
    const Index between = Triangle_crossings(crossings(opposite), crossings(before), crossings(h)).emanating[0];
    for(Index i = place.is_along ? 0 : 1; i <= between && place.direction.reference != null_index; ++i)
      pass_input_edge(place.direction);
    place.halfedge = h;
    place.direction.angle -=
        corner(m_triangulation.length(h), m_triangulation.length(opposite), m_triangulation.length(before));
    place.is_along = crossings(h) < 0;
    place.direction.angle = place.is_along ? 0 : place.direction.angle;
  }

private:
  Index crossings(Halfedge_index h) const { return m_triangulation.crossings(Triangulation::edge(h)); }

  void pass_input_edge(Edge_sequence_angle& place) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index t = twin_index(place.reference);
    place.reference = input.is_border(t) ? Input_halfedge_index(null_index) : clockwise_of(input, place.reference);
    if(place.reference != null_index)
      place.angle += input_corner(m_triangulation, input.next(input.next(place.reference)));
  }

  // The angle of a face between its first edge and its last one, from their lengths.
  static double corner(double first, double opposite, double last)
  {
    using Traits = Double_face_traits<typename Triangulation::Metric::Kernel>;
    const auto face = Traits().construct_face_from_lengths_object()(first, opposite, last);
    return std::atan2(-face[2].y, -face[2].x);
  }

  const Triangulation& m_triangulation;
};

/* An edge of the triangulation that starts at a common vertex, with its known properties. */
struct Fan_leg
{
  Edge_end start; // from the triangulation's lengths; measured once it is found
  Vertex_index head;
  Index crossings;  // of input edges
  double length;    // in the triangulation
  Edge_end arrival; // at its head, reversed
  bool is_found;

  Input_halfedge_index reference() const { return start.direction.reference; }
};

/*
 * Measures the edges that start at one vertex on the input, all at once: the faces that they cross are unfolded from
 * the vertex outwards, and common faces are unfolded once. The edge sequences are not required.
 *
 *                      apex
 *                     /    .            the edges that pass a portal are separated by the corner
 *           left ----/------- right     beyond it: those on its left, the one that ends there,
 *               .   . .    .            and those on its right
 *                 .  .  .
 *                   . .
 *                    u
 *
 * An edge is searched for in the direction that the triangulation's lengths define. It is found if, after its number of
 * crossings, it reaches its head at the distance of its length, passes no vertex closely, and the straight line to the
 * head crosses exactly the same edges. Otherwise the edge remains undecided.
 */
template <class Triangulation>
class Leg_fan
{
  using Vector = std::complex<double>;
  using Face = std::array<Vector, 3>;

public:
  explicit Leg_fan(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_faces(static_cast<std::size_t>(triangulation.input().number_of_halfedges()))
  {
  }

  /* \pre the edges have one reference, along which none of them lies, and are ordered clockwise */
  void operator()(Fan_leg* first, Fan_leg* last)
  {
    m_directions.clear();
    for(Fan_leg* leg = first; leg != last; ++leg)
      m_directions.push_back(std::polar(1.0, leg->start.direction.angle));
    m_legs = first;
    const Input_halfedge_index h = first->reference();
    const Face& face = known_face(h);
    const Vector right(face[0].real(), 0), portal = face[1], left = -face[2];
    m_portals.push_back(
        {m_triangulation.input().next(h), right, left, -portal, right, left, 0, m_directions.size(), 1});
    while(!m_portals.empty()) {
      Portal here = m_portals.back();
      m_portals.pop_back();
      while(is_crossed(here) && !m_triangulation.input().is_border(twin_index(here.crossed)))
        cross_portal(here);
    }
  }

private:
  // An input edge that edges of the fan cross, with the face behind it that is entered next.
  struct Portal
  {
    Input_halfedge_index crossed;
    Vector right, left, across; // its ends, and the vector from left to right
    Vector rightmost, leftmost; // straight lines between these pass all portals up to here
    std::size_t first, last;    // the edges of the fan
    Index crossings;            // the number of crossings, including this one
  };

  // The face on the left of h, in its frame. The edges of many vertices cross it.
  const Face& known_face(Input_halfedge_index h)
  {
    Face& face = m_faces[h];
    if(face[0].real() == 0) {
      const auto vectors = input_face_geometry(m_triangulation, h);
      for(std::size_t i = 0; i < 3; ++i)
        face[i] = Vector(vectors[i].x, vectors[i].y);
    }
    return face;
  }

  // Returns whether one of its edges has that many crossings.
  bool is_crossed(const Portal& portal) const
  {
    for(std::size_t i = portal.first; i < portal.last; ++i)
      if(m_legs[i].crossings >= portal.crossings)
        return true;
    return false;
  }

  // Continues to the next portal; if the edges separate, to the left one, and the right one is stored for later.
  void cross_portal(Portal& here)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index entered = twin_index(here.crossed), to_apex = input.next(entered);
    const Face& vectors = known_face(entered);
    // Products of ratios of the face, as in `Strip`.
    const Vector turn = here.across / vectors[0].real();
    const Vector from_right = product(turn, vectors[1]);
    const Vector to_left = product(turn, vectors[2]);
    const bool is_near_right = std::norm(from_right) < std::norm(to_left);
    const Vector apex = is_near_right ? here.right + from_right : here.left - to_left;
    const double margin = near_leg_angle * std::sqrt(std::norm(apex));
    const std::size_t i = end_of_left(here, apex, margin);
    std::size_t j = i;
    for(; j < here.last && cross(apex, m_directions[j]) >= -margin; ++j)
      end(m_legs[j], here, apex, input.next(to_apex), to_left);
    const bool is_right_of_apex = cross(here.rightmost, apex) > 0, is_left_of_apex = cross(apex, here.leftmost) > 0;
    const auto turn_right = [&](Portal& portal) {
      portal.crossed = to_apex;
      portal.left = apex;
      portal.across = -from_right;
      portal.leftmost = is_left_of_apex ? apex : portal.leftmost;
      portal.first = j;
    };
    ++here.crossings;
    if(i == here.first)
      return turn_right(here);
    if(j < here.last) {
      m_portals.push_back(here);
      turn_right(m_portals.back());
    }
    here.crossed = input.next(to_apex);
    here.right = apex;
    here.across = -to_left;
    here.rightmost = is_right_of_apex ? apex : here.rightmost;
    here.last = i;
  }

  // Skips the edges that pass a portal clearly on the left of the apex behind it.
  std::size_t end_of_left(const Portal& portal, const Vector& apex, double margin) const
  {
    constexpr std::size_t few = 8;
    const auto is_on_left = [&](const Vector& direction) { return cross(apex, direction) > margin; };
    const auto first = m_directions.begin() + static_cast<std::ptrdiff_t>(portal.first);
    const auto last = m_directions.begin() + static_cast<std::ptrdiff_t>(portal.last);
    const auto end = portal.last - portal.first < few ? std::find_if_not(first, last, is_on_left)
                                                      : std::partition_point(first, last, is_on_left);
    return static_cast<std::size_t>(end - m_directions.begin());
  }

  // An edge comes close to the corner opposite to a portal, from which `h` leads to the left.
  void end(Fan_leg& leg, const Portal& portal, const Vector& apex, Input_halfedge_index h, const Vector& along_h) const
  {
    const bool is_straight = cross(portal.rightmost, apex) > 0 && cross(apex, portal.leftmost) > 0;
    leg.is_found = is_straight && leg.crossings == portal.crossings && leg.head == m_triangulation.input().tail(h) &&
                   std::abs(std::sqrt(std::norm(apex)) - leg.length) <= near_leg_length * leg.length;
    if(!leg.is_found)
      return;
    leg.start.direction.angle = angle_from_reference(apex);
    leg.arrival.direction = {h, angle_from_reference(product(-apex, std::conj(along_h))), 0};
  }

  const Triangulation& m_triangulation;
  Indexed_by<Input_halfedge_index, Lazy_array<Face>> m_faces; // those crossed so far
  Fan_leg* m_legs = nullptr;
  std::vector<Vector> m_directions; // of the edges
  std::vector<Portal> m_portals;    // not yet crossed
};

/* The last edge of a path of a tree, and the previous one, as they were measured. */
struct Measured_leg
{
  double angle;     // between the two
  Edge_end arrival; // of the path, reversed
  Halfedge_index last, before;
  Index last_version, before_version; // distinguish an edge from one that has been flipped since
  bool is_measured, is_bent;
};

/* One for each vertex. */
using Measured_legs = Indexed_by<Vertex_index, Lazy_array<Measured_leg>>;

/*
 * Measures the paths of a geodesic tree on the input, like `Straightness_meter` for the curves of a network: the edges
 * that continue from each vertex all at once (`Leg_fan`), and those not found in this way by their edge sequences.
 * Results are stored and measured again only if edges have been replaced.
 */
template <class Tree>
class Tree_straightness
{
  using Triangulation = typename Tree::Triangulation;
  using Edges = decltype(edge_straightness(std::declval<const Triangulation&>()));

public:
  /* \param measured the results of an earlier measurement, or empty */
  Tree_straightness(const Tree& tree, Measured_legs& measured)
    : m_tree(tree)
    , m_triangulation(tree.triangulation())
    , m_measured(measured)
    , m_edges(edge_straightness(m_triangulation))
    , m_places(tree.triangulation())
    , m_fan(tree.triangulation())
  {
  }

  /* Returns the smallest angle at which paths leave their parents; writes the vertices whose paths are bent, by parent
   * and index. */
  template <class OutputIterator>
  double operator()(OutputIterator bent)
  {
    double smallest = infinity;
    m_bent.clear();
    m_open = {{m_tree.source(), {}}};
    while(!m_open.empty()) {
      const auto [u, arrival] = m_open.back();
      m_open.pop_back();
      smallest = (std::min)(smallest, measure(u, arrival));
    }
    std::sort(m_bent.begin(), m_bent.end());
    for(const auto& [parent, child] : m_bent)
      *bent++ = child;
    return smallest;
  }

  /*
   * Returns the edges with which paths continue from a vertex, except those whose results are stored, measured as far
   * as this is done all at once.
   *
   * \param around the halfedges that start there, clockwise, from the border if there is one
   * \param arrival the arrival of the path there, if known
   */
  const std::vector<Fan_leg>& legs(const std::vector<Halfedge_index>& around, const Edge_end& arrival)
  {
    m_legs.clear();
    const bool are_places_known = m_triangulation.number_of_vertices() == m_triangulation.input().number_of_vertices();
    std::size_t first = 0;
    Edge_end place = are_places_known ? known_place(around, arrival, first) : Edge_end();
    for(std::size_t i = 0; i < around.size(); ++i) {
      const Halfedge_index h = around[(first + i) % around.size()];
      if(are_places_known && m_triangulation.is_border(h)) // the first one or of another umbrella
        place = {h, {as_input(h), 0, 0}, true};
      else if(i > 0)
        m_places.turn_clockwise(h, place);
      if(is_leg(h) && !is_measured(h))
        add_leg(h, place);
    }
    for(std::size_t i = 0; i < m_legs.size();) {
      const auto has_other_place = [first = m_legs[i]](const Fan_leg& other) {
        return other.reference() != first.reference() || other.is_found;
      };
      const auto end = std::find_if(m_legs.begin() + static_cast<std::ptrdiff_t>(i) + 1, m_legs.end(), has_other_place);
      const auto last = static_cast<std::size_t>(end - m_legs.begin());
      if(m_legs[i].reference() != null_index && !m_legs[i].is_found)
        find(i, last);
      i = last;
    }
    return m_legs;
  }

  /* Recomputes the faces in the bent wedge before v from the input; returns false if flips were already wrong or the
   * border intervenes. */
  bool refresh(Vertex_index v)
  {
    const Halfedge_index h = m_tree.incoming(v);
    const Halfedge_index before = m_tree.incoming(m_triangulation.tail(h));
    if(before == null_index)
      return false;
    Edge_end from = m_edges(Triangulation::twin(before)).tail, to = m_edges(h).tail;
    if(!is_bent_clockwise(from, to))
      std::swap(from, to);
    const bool is_inside = angle_clockwise(from, to) < infinity;
    return Edges::refresh_wedge(m_triangulation, from.halfedge, to.halfedge) &&
           is_inside; // up to the border, if there is one
  }

private:
  struct Open_vertex
  {
    Vertex_index vertex;
    Edge_end arrival; // of the path there
  };

  // Returns the smallest angle at which paths continue from u; opens the vertices to which they lead.
  double measure(Vertex_index u, const Edge_end& arrival)
  {
    collect_outgoing_halfedges(m_triangulation, u, m_around);
    m_leg_outgoing_halfedges.clear();
    std::copy_if(m_around.begin(), m_around.end(), std::back_inserter(m_leg_outgoing_halfedges),
                 [this](Halfedge_index h) { return is_leg(h); });
    if(std::all_of(m_leg_outgoing_halfedges.begin(), m_leg_outgoing_halfedges.end(),
                   [this](Halfedge_index h) { return is_measured(h); }))
      return remember();
    legs(m_around, arrival);
    const Halfedge_index before = m_tree.incoming(u);
    const Vertex_fan umbrella = arrival.direction.reference == null_index ? Vertex_fan() : umbrella_with(arrival, u);
    for(Fan_leg& leg : m_legs) {
      const double bend = leg.is_found ? 0 : measure_by_edge_sequence(leg);
      const double angle = before == null_index ? infinity : smaller_angle(umbrella, arrival, leg.start);
      const bool is_bent = angle < Straightness::straight_angle() || bend > Straightness::tolerance();
      const Halfedge_index h = leg.start.halfedge;
      m_measured[leg.head] = {angle, leg.arrival, h, before, version(h), version(before), true, is_bent};
    }
    return remember();
  }

  // The input halfedges around a vertex, in the umbrella by which a path arrives.
  Vertex_fan umbrella_with(const Edge_end& arrival, Vertex_index u) const
  {
    Vertex_fan result = umbrella_of(m_triangulation, m_triangulation.input().outgoing(u));
    return result.has(arrival.direction.reference) ? result : umbrella_of(m_triangulation, arrival.direction.reference);
  }

  // The smaller of the two angles between a path and its continuing edge. If both directions are relative to the input,
  // it is computed from angles that are summed up once for all edges.
  double smaller_angle(const Vertex_fan& umbrella, const Edge_end& arrival, const Edge_end& start) const
  {
    const Edge_sequence_angle &a = arrival.direction, &b = start.direction;
    if(a.reference == null_index || b.reference == null_index)
      return (std::min)(angle_clockwise(arrival, start), angle_clockwise(start, arrival));
    const Vertex_index u = m_triangulation.tail(start.halfedge);
    return umbrella.has(b.reference) ? umbrella.smaller_wedge(umbrella.angle_of(a.reference, u) + a.angle,
                                                              umbrella.angle_of(b.reference, u) + b.angle)
                                     : infinity;
  }

  // Decided by the directions of the edges, also if wrong flips have changed their order around the vertex.
  bool is_bent_clockwise(const Edge_end& from, const Edge_end& to) const
  {
    const Edge_sequence_angle &a = from.direction, &b = to.direction;
    if(a.reference == null_index || b.reference == null_index)
      return angle_clockwise(from, to) < Straightness::straight_angle();
    const Vertex_index u = m_triangulation.tail(from.halfedge);
    const Vertex_fan umbrella = umbrella_with(from, u);
    return umbrella.has(b.reference) &&
           umbrella.counterclockwise(umbrella.angle_of(b.reference, u) + b.angle,
                                     umbrella.angle_of(a.reference, u) + a.angle) < Straightness::straight_angle();
  }

  // Infinite if the border intervenes.
  double angle_clockwise(const Edge_end& from, const Edge_end& to) const
  {
    Halfedge_index h = from.halfedge;
    do {
      h = m_triangulation.clockwise(h);
      if(h == null_index)
        return infinity;
    } while(h != to.halfedge);
    return m_edges.clockwise(from, to).value;
  }

  // Returns the smallest angle at which paths continue from a vertex whose edges are all measured; opens their ends.
  double remember()
  {
    double smallest = infinity;
    for(Halfedge_index h : m_leg_outgoing_halfedges) {
      const Vertex_index v = m_triangulation.head(h);
      const Measured_leg& leg = m_measured[v];
      smallest = (std::min)(smallest, leg.angle);
      if(leg.is_bent)
        m_bent.emplace_back(m_triangulation.tail(h), v);
      m_open.push_back({v, leg.arrival});
    }
    return smallest;
  }

  Index version(Halfedge_index h) const
  {
    return h == null_index ? 0 : m_triangulation.version(Triangulation::edge(h));
  }

  bool is_measured(Halfedge_index h) const
  {
    const Measured_leg& leg = m_measured[m_triangulation.head(h)];
    const Halfedge_index before = m_tree.incoming(m_triangulation.tail(h));
    return leg.is_measured && leg.last == h && leg.before == before && leg.last_version == version(h) &&
           leg.before_version == version(before);
  }

  bool is_leg(Halfedge_index h) const { return m_tree.incoming(m_triangulation.head(h)) == h; }

  // The position of one of the halfedges of a vertex on the input, and the number of that halfedge.
  Edge_end known_place(const std::vector<Halfedge_index>& around, const Edge_end& arrival, std::size_t& number) const
  {
    if(arrival.direction.reference == null_index || m_triangulation.is_border(around.front()))
      return m_places.known_place(around, number);
    number = static_cast<std::size_t>(std::find(around.begin(), around.end(), arrival.halfedge) - around.begin());
    return arrival;
  }

  void add_leg(Halfedge_index h, const Edge_end& place)
  {
    const Vertex_index head = m_triangulation.head(h);
    const Halfedge_index t = Triangulation::twin(h);
    const Input_halfedge_index reference = place.direction.reference;
    Fan_leg leg = {{h, place.direction, place.is_along},
                   head,
                   m_triangulation.crossings(Triangulation::edge(h)),
                   m_triangulation.length(h),
                   {t, {}, false},
                   false};
    if(place.is_along && reference != null_index && m_triangulation.input().tail(twin_index(reference)) == head) {
      leg.arrival = {t, {twin_index(reference), 0, 0}, true};
      leg.is_found = true;
    } else if(place.is_along) {
      leg.start.direction.reference = null_index;
    }
    m_legs.push_back(leg);
  }

  /*
   * Finds edges with a common reference. Angles have been summed up around the vertex. Beyond a needle-shaped face, all
   * of them can deviate by more than the fan allows, but by the same angle, which the edge sequence of the first edge
   * that is not found determines.
   */
  void find(std::size_t first, std::size_t last)
  {
    constexpr int most_turns = 16; // then each by its edge sequence
    const auto begin = m_legs.begin();
    const auto is_found = [](const Fan_leg& leg) { return leg.is_found; };
    m_fan(&m_legs[first], &m_legs[first] + (last - first));
    for(int turns = 0; turns < most_turns; ++first) {
      const auto end_of_range = begin + static_cast<std::ptrdiff_t>(last);
      const auto missed = std::find_if_not(begin + static_cast<std::ptrdiff_t>(first), end_of_range, is_found);
      const auto end = std::find_if(missed, end_of_range, is_found);
      if(missed == end_of_range)
        return;
      first = static_cast<std::size_t>(missed - begin);
      const double drift = end - missed > 1 ? drift_of(*missed) : 0;
      if(!(std::abs(drift) > near_leg_angle / 2))
        continue;
      std::for_each(missed, end, [drift](Fan_leg& leg) { leg.start.direction.angle += drift; });
      m_fan(&*missed, &*missed + (end - missed));
      ++turns;
    }
  }

  // The error of its angle.
  double drift_of(const Fan_leg& leg) const
  {
    const Edge_sequence_angle measured = m_edges(leg.start.halfedge).tail.direction;
    return measured.reference == leg.reference() ? measured.angle - leg.start.direction.angle : 0;
  }

  // Measures an edge that was not found; returns the angle by which it bends.
  double measure_by_edge_sequence(Fan_leg& leg) const
  {
    const Measured_edge edge = m_edges(leg.start.halfedge);
    leg.start = edge.tail;
    leg.arrival = edge.head;
    return edge.bend;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  const Tree& m_tree;
  Triangulation& m_triangulation;
  Measured_legs& m_measured;
  Edges m_edges;
  Outgoing_halfedge_places<Triangulation> m_places;
  Leg_fan<Triangulation> m_fan;
  std::vector<Halfedge_index> m_around, m_leg_outgoing_halfedges; // of the vertex being measured
  std::vector<Fan_leg> m_legs;
  std::vector<Open_vertex> m_open;
  std::vector<std::pair<Vertex_index, Vertex_index>> m_bent; // and their parents
};

/*
 * The joints of paths whose wedges were flipped out without success because the arc is longer. With exact predicates
 * this happens only if degenerate faces fold vertices onto one point. An edge between two of them has length zero and
 * its angles are undefined, so flips stop there. Such joints are rare.
 */
class Hindered_joints
{
public:
  void clear() { m_joints.clear(); }

  /* Adds the joint between two halfedges that start at the vertex passed by a path, in either order. */
  void add(Halfedge_index a, Halfedge_index c) { m_joints.emplace_back((std::min)(a, c), (std::max)(a, c)); }

  bool has(Halfedge_index a, Halfedge_index c) const
  {
    return std::find(m_joints.begin(), m_joints.end(), Joint((std::min)(a, c), (std::max)(a, c))) != m_joints.end();
  }

  /* Must be called before the edge of h is flipped. */
  template <class Triangulation>
  void forget(const Triangulation& /* triangulation */, Halfedge_index h)
  {
    const auto is_there = [e = Triangulation::edge(h)](const Joint& joint) {
      return Triangulation::edge(joint.first) == e || Triangulation::edge(joint.second) == e;
    };
    m_joints.erase(std::remove_if(m_joints.begin(), m_joints.end(), is_there), m_joints.end());
  }

  /* Returns whether a path of the tree passes one of these joints. */
  template <class Tree>
  bool are_in(const Tree& tree) const
  {
    const auto is_onward = [&](Halfedge_index h) { return tree.incoming(tree.triangulation().head(h)) == h; };
    const auto is_passed = [&](Halfedge_index back, Halfedge_index onward) {
      return is_onward(Tree::Triangulation::twin(back)) && is_onward(onward);
    };
    return std::any_of(m_joints.begin(), m_joints.end(), [&](const Joint& joint) {
      return is_passed(joint.first, joint.second) || is_passed(joint.second, joint.first);
    });
  }

private:
  using Joint = std::pair<Halfedge_index, Halfedge_index>;

  std::vector<Joint> m_joints;
};

/* Returns the status that such joints imply with exact predicates. Rounding coordinates or lengths can make faces
 * degenerate. */
template <class Triangulation>
Shortening_status status_of_hindered(const Triangulation& triangulation)
{
  return is_input_rounded(triangulation) ? Shortening_status::PRECISION_LIMIT : Shortening_status::DEGENERATE_FACES;
}

/*
 * Returns whether the arc of a wedge can be longer because of coincident vertices. With inexact predicates, this
 * requires that the arc passes coincident vertices, by edges no longer than rounding errors; other cases are left to
 * measurement.
 */
template <class Triangulation>
bool can_be_folded(const Triangulation& triangulation, const std::vector<Halfedge_index>& arc, double rounding)
{
  return !Triangulation::Traits::Has_drift::value ||
         std::any_of(arc.begin(), arc.end(), [&](Halfedge_index h) { return triangulation.length(h) <= rounding; });
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_GEODESIC_TREE_PARTS_H
