// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_TREE_STRAIGHTNESS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_TREE_STRAIGHTNESS_H

#include <CGAL/Flip_geodesics/Straightness_meter.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/shortest/Leg_fan.h>
#include <CGAL/Flip_geodesics/internal/surface/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_straightness.h>
#include <CGAL/Flip_geodesics/internal/triangulation/spokes.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The last edge of a path of a tree, and the one before, as they were measured. */
struct Measured_leg
{
  double angle;     // between the two
  Edge_end arrival; // of the path, backward
  Halfedge_index last, before;
  Index last_version, before_version; // by which an edge is told from one that has been flipped in between
  bool is_measured, is_bent;
};

/*
 * Measures the paths of a geodesic tree afresh from the input, as `Straightness_meter` measures the curves of a
 * network: the edges that go on from each vertex all at once (`Leg_fan`), and those not found so by their words.
 * What has been measured is remembered, and measured again only where edges have been replaced.
 */
template <class Tree>
class Tree_straightness
{
  using Triangulation = typename Tree::Triangulation;

public:
  using Measured_legs = Indexed_by<Vertex_index, Lazy_array<Measured_leg>>;

  /* \param measured for each vertex; of an earlier measurement, or nothing */
  Tree_straightness(const Tree& tree, Measured_legs& measured)
    : m_tree(tree)
    , m_triangulation(tree.triangulation())
    , m_measured(measured)
    , m_edges(tree.triangulation())
    , m_places(tree.triangulation())
    , m_fan(tree.triangulation())
  {
  }

  /* The smallest angle where paths leave their parents; writes the vertices whose are bent, by parent and index. */
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
   * The edges with which paths go on from a vertex, but for those that are remembered, measured as far as that is done
   * all at once.
   *
   * \param around the halfedges that start there, clockwise, from the border if there is one
   * \param arrival how the path comes there, if that is known
   */
  const std::vector<Fan_leg>& legs(const std::vector<Halfedge_index>& around, const Edge_end& arrival)
  {
    m_legs.clear();
    const bool are_places_known = m_triangulation.number_of_vertices() == m_triangulation.input().number_of_vertices();
    std::size_t first = 0;
    Edge_end place = are_places_known ? known_place(around, arrival, first) : Edge_end();
    for(std::size_t i = 0; i < around.size(); ++i) {
      const Halfedge_index h = around[(first + i) % around.size()];
      if(i > 0 && are_places_known && m_triangulation.is_border(h)) // of another umbrella
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

  /* Lays the faces afresh in the bent wedge before v; false if flips were wrong already, or the border intervenes. */
  bool refresh(Vertex_index v)
  {
    const Halfedge_index h = m_tree.incoming(v);
    const Halfedge_index before = m_tree.incoming(m_triangulation.tail(h));
    if(before == null_index)
      return false;
    Edge_end from = m_edges(Triangulation::twin(before)).tail, to = m_edges(h).tail;
    if(!(angle_clockwise(from, to) < Straightness::straight_angle()))
      std::swap(from, to);
    const bool is_inside = angle_clockwise(from, to) < infinity;
    return refresh_wedge(m_triangulation, from.halfedge, to.halfedge) && is_inside; // up to the border, if there is one
  }

private:
  struct Open_vertex
  {
    Vertex_index vertex;
    Edge_end arrival; // of the path there
  };

  // The smallest angle where paths go on from u; opens the vertices that they lead to.
  double measure(Vertex_index u, const Edge_end& arrival)
  {
    collect_spokes(m_triangulation, u, m_around);
    m_leg_spokes.clear();
    std::copy_if(m_around.begin(), m_around.end(), std::back_inserter(m_leg_spokes),
                 [this](Halfedge_index h) { return is_leg(h); });
    if(std::all_of(m_leg_spokes.begin(), m_leg_spokes.end(), [this](Halfedge_index h) { return is_measured(h); }))
      return remember();
    legs(m_around, arrival);
    const Halfedge_index before = m_tree.incoming(u);
    const Vertex_fan umbrella = arrival.direction.reference == null_index ? Vertex_fan() : umbrella_with(arrival, u);
    for(Fan_leg& leg : m_legs) {
      const double bend = leg.is_found ? 0 : measure_by_word(leg);
      const double angle = before == null_index ? infinity : smaller_angle(umbrella, arrival, leg.start);
      const bool is_bent = angle < Straightness::straight_angle() || bend > Straightness::tolerance();
      const Halfedge_index h = leg.start.halfedge;
      m_measured[leg.head] = {angle, leg.arrival, h, before, version(h), version(before), true, is_bent};
    }
    return remember();
  }

  // The input halfedges about a vertex, in the umbrella by which a path arrives.
  Vertex_fan umbrella_with(const Edge_end& arrival, Vertex_index u) const
  {
    Vertex_fan result = umbrella_of(m_triangulation, m_triangulation.input().outgoing(u));
    return result.has(arrival.direction.reference) ? result : umbrella_of(m_triangulation, arrival.direction.reference);
  }

  // The smaller one of the angles between a path and the edge with which it goes on; from angles that are added up once
  // for all edges, if both are told from the input.
  double smaller_angle(const Vertex_fan& umbrella, const Edge_end& arrival, const Edge_end& start) const
  {
    const Word_angle &a = arrival.direction, &b = start.direction;
    if(a.reference == null_index || b.reference == null_index)
      return (std::min)(angle_clockwise(arrival, start), angle_clockwise(start, arrival));
    const Vertex_index u = m_triangulation.tail(start.halfedge);
    return umbrella.has(b.reference) ? umbrella.smaller_wedge(umbrella.angle_of(a.reference, u) + a.angle,
                                                              umbrella.angle_of(b.reference, u) + b.angle)
                                     : infinity;
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

  // The smallest angle where paths go on from a vertex, all of which have been measured; opens their ends.
  double remember()
  {
    double smallest = infinity;
    for(Halfedge_index h : m_leg_spokes) {
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

  // Where one of the spokes of a vertex lies in the input, and which one that is.
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
   * Finds legs that have one reference. Angles have been added up around the vertex. Beyond a needle all of them can be
   * off by more than the fan allows for, and by the same angle: the word of the first that is not found tells by which.
   */
  void find(std::size_t first, std::size_t last)
  {
    constexpr int most_turns = 16; // beyond, each by its word
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

  // What its angle lacks.
  double drift_of(const Fan_leg& leg) const
  {
    const Word_angle measured = m_edges(leg.start.halfedge).tail.direction;
    return measured.reference == leg.reference() ? measured.angle - leg.start.direction.angle : 0;
  }

  // Of a leg that is not found; returns by how much it is bent.
  double measure_by_word(Fan_leg& leg) const
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
  Edge_straightness<Triangulation> m_edges;
  Spoke_places<Triangulation> m_places;
  Leg_fan<Triangulation> m_fan;
  std::vector<Halfedge_index> m_around, m_leg_spokes; // of the vertex that is measured
  std::vector<Fan_leg> m_legs;
  std::vector<Open_vertex> m_open;
  std::vector<std::pair<Vertex_index, Vertex_index>> m_bent; // and their parents
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_TREE_STRAIGHTNESS_H
