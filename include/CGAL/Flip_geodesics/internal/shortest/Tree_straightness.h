// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_TREE_STRAIGHTNESS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_TREE_STRAIGHTNESS_H

#include <CGAL/Flip_geodesics/Straightness_meter.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/shortest/Leg_fan.h>
#include <CGAL/Flip_geodesics/internal/shortest/Spoke_places.h>
#include <CGAL/Flip_geodesics/internal/surface/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_directions.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>
#include <CGAL/Flip_geodesics/internal/unfolding/refresh_face.h>
#include <CGAL/Flip_geodesics/network_builders.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The last edge of a path of a tree, and the one before, as they were measured. */
struct Measured_leg
{
  double angle;        // between the two
  Spoke_place arrival; // of the path, backward
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
  using Directions = Vertex_directions<Triangulation>;

public:
  using Measured_legs = Indexed_by<Vertex_index, Lazy_array<Measured_leg>>;

  /* \param measured for each vertex; of an earlier measurement, or nothing */
  Tree_straightness(const Tree& tree, Measured_legs& measured)
    : m_tree(tree)
    , m_triangulation(tree.triangulation())
    , m_measured(measured)
    , m_places(tree.triangulation())
    , m_fan(tree.triangulation())
  {
  }

  /* The smallest angle where paths leave their parents; writes the vertices whose are bent, by parent and index. */
  template <class OutputIterator>
  double operator()(OutputIterator bent)
  {
    double smallest = std::numeric_limits<double>::infinity();
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
  const std::vector<Fan_leg>& legs(const std::vector<Halfedge_index>& around, const Directions& directions,
                                   const Spoke_place& arrival)
  {
    m_legs.clear();
    const bool has_inserted_vertices =
        m_triangulation.number_of_vertices() != m_triangulation.input().number_of_vertices();
    std::size_t first = 0;
    Spoke_place place = has_inserted_vertices ? Spoke_place() : known_place(around, directions, arrival, first);
    for(std::size_t i = 0; i < around.size(); ++i) {
      const Halfedge_index h = around[(first + i) % around.size()];
      if(i > 0)
        m_places.turn_clockwise(h, place);
      if(is_leg(h) && !is_measured(h))
        add_leg(h, place);
    }
    for(std::size_t i = 0; i < m_legs.size();) {
      const auto has_other_place = [first = m_legs[i]](const Fan_leg& other) {
        return other.reference != first.reference || other.is_found;
      };
      const auto end = std::find_if(m_legs.begin() + static_cast<std::ptrdiff_t>(i) + 1, m_legs.end(), has_other_place);
      const auto last = static_cast<std::size_t>(end - m_legs.begin());
      if(m_legs[i].reference != null_index && !m_legs[i].is_found)
        find(i, last);
      i = last;
    }
    return m_legs;
  }

  /* Lays the faces afresh in the bent wedge before v; false if flips were wrong already. */
  bool refresh(Vertex_index v)
  {
    const Halfedge_index h = m_tree.incoming(v);
    const Vertex_index u = m_triangulation.tail(h);
    if(m_tree.incoming(u) == null_index)
      return false;
    const Halfedge_index back = Triangulation::twin(m_tree.incoming(u));
    Halfedge_index first = h;
    while(!m_triangulation.is_border(first) && m_triangulation.counterclockwise(first) != h)
      first = m_triangulation.counterclockwise(first);
    const Directions directions = directions_from(first);
    const bool is_bent_behind =
        directions.counterclockwise(directions(h), directions(back)) < Straightness::straight_angle();
    const Refreshed_wedge refreshed =
        is_bent_behind ? refresh_wedge(m_triangulation, back, h) : refresh_wedge(m_triangulation, h, back);
    return refreshed == Refreshed_wedge::ALL;
  }

private:
  struct Open_vertex
  {
    Vertex_index vertex;
    Spoke_place arrival; // of the path there
  };

  // The smallest angle where paths go on from u; opens the vertices that they lead to.
  double measure(Vertex_index u, const Spoke_place& arrival)
  {
    collect_spokes(m_triangulation, u, m_around);
    m_leg_spokes.clear();
    std::copy_if(m_around.begin(), m_around.end(), std::back_inserter(m_leg_spokes),
                 [this](Halfedge_index h) { return is_leg(h); });
    if(std::all_of(m_leg_spokes.begin(), m_leg_spokes.end(), [this](Halfedge_index h) { return is_measured(h); }))
      return remember();
    const auto is_border = [this](Halfedge_index h) { return m_triangulation.is_border(h); };
    for(auto first = m_around.begin(); first != m_around.end();) {
      const auto last = std::find_if(first + 1, m_around.end(), is_border);
      m_umbrella.assign(first, last);
      measure_umbrella(arrival);
      first = last;
    }
    return remember();
  }

  // Measures the edges with which paths go on from a vertex in one of its umbrellas. A path that comes in another one
  // has the border on both sides.
  void measure_umbrella(const Spoke_place& arrival)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Directions directions = directions_from(m_umbrella.front());
    const Halfedge_index before = m_tree.incoming(m_triangulation.tail(m_umbrella.front()));
    const bool is_here = before != null_index && std::find(m_umbrella.begin(), m_umbrella.end(),
                                                           Triangulation::twin(before)) != m_umbrella.end();
    legs(m_umbrella, directions, is_here ? arrival : Spoke_place());
    const double back = !is_here                          ? 0
                        : arrival.reference != null_index ? directions.of_input(arrival.reference) + arrival.angle
                                                          : directions(Triangulation::twin(before));
    for(Fan_leg& leg : m_legs) {
      const double bend = leg.is_found ? 0 : measure_by_word(leg, directions);
      const double direction = leg.reference == null_index ? leg.angle : directions.of_input(leg.reference) + leg.angle;
      const double angle = is_here ? directions.smaller_wedge(back, direction) : infinity;
      const bool is_bent = angle < Straightness::straight_angle() || bend > Straightness::tolerance();
      m_measured[leg.head] = {angle,           leg.arrival, leg.halfedge, before, version(leg.halfedge),
                              version(before), true,        is_bent};
    }
  }

  // In the umbrella of a halfedge of the triangulation, which lies on the border if the umbrella has one.
  Directions directions_from(Halfedge_index first) const
  {
    const Vertex_index u = m_triangulation.tail(first);
    if(!m_triangulation.is_border(first) || m_triangulation.is_inserted(u))
      return Directions(m_triangulation, u);
    return Directions(m_triangulation, m_triangulation.crossing_word(first).along);
  }

  // The smallest angle where paths go on from a vertex, all of which have been measured; opens their ends.
  double remember()
  {
    double smallest = std::numeric_limits<double>::infinity();
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
  Spoke_place known_place(const std::vector<Halfedge_index>& around, const Directions& directions,
                          const Spoke_place& arrival, std::size_t& number) const
  {
    const Halfedge_index before = m_tree.incoming(m_triangulation.tail(around.front()));
    const bool is_anchored = before != null_index && arrival.reference != null_index && !directions.has_border();
    if(!is_anchored)
      return m_places.known_place(around, number);
    const auto back = std::find(around.begin(), around.end(), Triangulation::twin(before));
    number = static_cast<std::size_t>(back - around.begin());
    return arrival;
  }

  void add_leg(Halfedge_index h, const Spoke_place& place)
  {
    const Index crossings = m_triangulation.crossings(Triangulation::edge(h));
    const Vertex_index head = m_triangulation.head(h);
    Fan_leg leg = {h, head, crossings, m_triangulation.length(h), place.reference, place.angle, Spoke_place(), false};
    if(place.is_along && place.reference != null_index &&
       m_triangulation.input().tail(twin_index(place.reference)) == head) {
      leg.arrival = {twin_index(place.reference), 0, true};
      leg.is_found = true;
    } else if(place.is_along) {
      leg.reference = null_index;
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
      std::for_each(missed, end, [drift](Fan_leg& leg) { leg.angle += drift; });
      m_fan(&*missed, &*missed + (end - missed));
      ++turns;
    }
  }

  // What its angle lacks.
  double drift_of(const Fan_leg& leg) const
  {
    const Strip<Triangulation> strip(m_triangulation, m_triangulation.crossing_word(leg.halfedge));
    return strip.reference() == leg.reference ? angle_from_reference(strip.end()) - leg.angle : 0;
  }

  // Of a leg that is not found; returns by how much it is bent.
  double measure_by_word(Fan_leg& leg, const Directions& directions) const
  {
    const Crossing_word word = m_triangulation.crossing_word(leg.halfedge);
    const Strip<Triangulation> strip(m_triangulation, word);
    leg.reference = null_index;
    leg.angle = directions(strip);
    if(strip.arrival_reference() != null_index)
      leg.arrival = {strip.arrival_reference(), angle_from_reference(strip.arrival()), word.along != null_index};
    return strip.bend();
  }

  const Tree& m_tree;
  Triangulation& m_triangulation;
  Measured_legs& m_measured;
  Spoke_places<Triangulation> m_places;
  Leg_fan<Triangulation> m_fan;
  std::vector<Halfedge_index> m_around, m_leg_spokes; // of the vertex that is measured
  std::vector<Halfedge_index> m_umbrella;             // a part of the former
  std::vector<Fan_leg> m_legs;
  std::vector<Open_vertex> m_open;
  std::vector<std::pair<Vertex_index, Vertex_index>> m_bent; // and their parents
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_TREE_STRAIGHTNESS_H
