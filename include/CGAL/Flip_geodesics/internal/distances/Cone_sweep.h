// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_SWEEP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_SWEEP_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Edge_cones.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>
#include <CGAL/Flip_geodesics/internal/distances/Landmark_rows.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * One record for each element of a sequence of which few are written. Written records are contiguous, in the order of
 * their first writing, and do not move. All others share one record with its initial value.
 */
template <class Key, class Record>
class Written_records
{
public:
  explicit Written_records(std::size_t number_of_elements)
    : m_slots(number_of_elements)
  {
    m_records.push_back(Record());
  }

  const Record& operator[](Key key) const { return m_records[static_cast<std::size_t>(m_slots[key.idx()])]; }

  /* Returns the element's own record for writing. */
  Record& write(Key key)
  {
    if(!m_slots.has_slot(key.idx())) {
      m_slots.add(key.idx());
      m_records.push_back(Record());
      return m_records.back();
    }
    return m_records[static_cast<std::size_t>(m_slots[key.idx()])];
  }

private:
  Slot_table<1> m_slots;
  Block_array<Record> m_records; // by slots
};

/*
 * Lower-bound propagation: lower bounds of the distances from a vertex, within about 1%, at a small part of the cost of
 * the distances.
 *
 * Each halfedge has a cone, or two side by side: the distance function of an unfolded pseudo-source. No path from the
 * source that leaves the halfedge's face through it, at any point, is shorter than the least of three values: that of
 * the cone at the point, and the distances of the two ends plus the path from there along the edge. Such cones follow
 * from each other. A path that leaves face abc through ab has entered it through bc or ca, or comes from c. No path is
 * therefore shorter than the least value that the cones of those edges and the distance of c allow:
 *
 *               c
 *              / .               paths that enter through ca come straight from the cone's pseudo-source and reach ab
 *       P     /   .     N        up to the end of the line through c; those that enter through bc reach the other end;
 *            /     .             the paths by way of c, and those along ab, are longer, or they are considered
 *           a-------b            separately
 *
 * The cone of ab is fitted to these values, so that it is nowhere above them and meets them at a and b: if it were
 * lower there, cones around a vertex would lower each other indefinitely. If two fronts meet on an edge, it has two
 * cones. The bounds thus hold whatever the fit and whatever the order in which faces are passed; they are good at low
 * cost if faces are passed in the order of distance. A face is passed again when a cone is not low enough any more. The
 * waves of a fast marching method with virtual sources [NK02] are cones of this kind, fitted to be near the distance
 * but not below it.
 *
 * Most halfedges are passed by a front from one face to the other only. Paths that come back across the twin halfedge
 * follow from vertices behind the front and matter little: the cones of the first halfedge are low enough there and are
 * borrowed. They may be much lower than necessary and would then lower others; in that case the twin gets cones fitted
 * to the paths that come back.
 *
 * Since paths by way of all corners count, also of those at which no shortest path turns, the bounds depend on the
 * triangle inequality alone: the pseudo-source of a fitted cone may be where its rays miss the edge that they should
 * reach.
 *
 * The part of an edge reached by a cone is enlarged slightly to allow for rounding errors. A shortest path takes at
 * most one step per face, and the possible error of all steps together is subtracted from the results.
 */
template <class Triangulation>
class Cone_sweep
{
  using Faces = Unfolded_faces<Triangulation>;
  using Vector = typename Faces::Vector;
  using Wave = Cone_wave;
  using Vertex_record = Swept_vertex;
  using Entry = Queued_wave;

public:
  /* \param goal the end of the paths that matter
   * \param free_updates number of exact updates of a cone; more are expensive at needles, but keep the bounds good
   * \param most_updates_per_side on average; more, which six free ones cannot cause, end a useless propagation */
  Cone_sweep(const Triangulation& triangulation, Faces& faces, Vertex_index source,
             const Goal_bound<Triangulation>& goal, int free_updates = 6, std::size_t most_updates_per_side = 26)
    : m_triangulation(triangulation)
    , m_faces(faces)
    , m_source(source)
    , m_goal(goal)
    , m_vertices(static_cast<std::size_t>(triangulation.number_of_vertices()))
    , m_free_updates(free_updates)
    , m_most_updates_per_side(most_updates_per_side)
  {
  }

  /*
   * Propagates over everything passed by paths from the source to the goal that are not longer than `bound`. The
   * propagation is not useful if it was interrupted.
   * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
   */
  void run(double bound, Interruption* interruption = nullptr)
  {
    run_from(std::array<Vertex_index, 1>{{m_source}}, bound, interruption);
  }

  /* Propagates from the nearest of several vertices. */
  template <class Vertices>
  void run_from(const Vertices& sources, double bound, Interruption* interruption = nullptr)
  {
    m_bound = bound;
    m_error = cone_error * bound;
    m_total_error = 2 * static_cast<double>(m_triangulation.number_of_halfedges()) * m_error;
    for(const Vertex_index v : sources)
      reach(v, 0, 0);
    while(!m_queue.empty() && is_useful()) {
      if(is_interrupted(interruption))
        m_total_error = infinity;
      else
        pass_first();
    }
  }

  /* Returns false if the errors that had to be allowed for termination make the result worthless. */
  bool is_useful() const { return m_total_error <= largest_cone_error * m_bound; }

  Vertex_index source() const { return m_source; }
  double bound() const { return m_bound; }

  /* Returns a lower bound of the lengths of the relevant paths from the source to v. */
  double distance_lower_bound(Vertex_index v) const
  {
    if(!is_useful())
      return in_space(v);
    return m_vertices[v].is_reached ? m_vertices[v].distance - m_total_error : infinity;
  }

  /*
   * Returns a lower bound of the lengths of paths that end at the source and come as a cone predicts across the edge of
   * h, between two points on it, into the face on the left of h.
   */
  double through(Input_halfedge_index h, double length, const Cone& cone, double from, double to) const
  {
    const Vertex_index a = m_triangulation.input().tail(h), b = m_triangulation.input().tail(twin_index(h));
    if(is_useful()) {
      const Wave* wave = known_wave(m_faces.known_number(h));
      const double across = wave == nullptr ? infinity : wave->cones.least_sum(cone, from, to) - m_total_error;
      const double along =
          (std::min)(cone(from) + from + distance_lower_bound(a), cone(to) + (length - to) + distance_lower_bound(b));
      return (std::min)(across, along);
    }
    const double tail = cone(to) - to + in_space(a); // since the slope of a cone is at most 1
    const double head = cone(from) - (length - from) + in_space(b);
    return (std::max)({cone.least(from, to), tail, head});
  }

  /* Returns the cones over the edge of h of paths that leave the face on the left of h; their values are too high by at
   * most `total_error()`. Returns null if no such path matters. \pre is_useful() */
  const Edge_cones* cones(Input_halfedge_index h) const
  {
    const Wave* const wave = known_wave(m_faces.known_number(h));
    return wave == nullptr ? nullptr : &wave->cones;
  }
  double total_error() const { return m_total_error; }

  /* Returns the cost of the propagation: the number of times that a halfedge was examined. */
  std::size_t number_of_updates() const { return m_updates; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // The way in which paths come to a side of a face: across the previous side, across the next side, or by way of the
  // apex.
  enum class Entrance : char { BEFORE, AFTER, APEX };

  double in_space(Vertex_index v) const
  {
    const auto& metric = m_triangulation.metric();
    const auto& input = m_triangulation.input();
    return metric.distance_lower_bound(metric.place(input, v), metric.place(input, m_source));
  }

  void pass_first()
  {
    const Entry entry = m_queue.top();
    m_queue.pop();
    if(entry.id < 0)
      leave_vertex(Vertex_index(-1 - entry.id));
    else if(Wave& wave = m_waves[static_cast<std::size_t>(entry.id)]; wave.is_waiting && wave.key() == entry.key) {
      wave.is_waiting = false;
      enter_face(entry.id);
    }
  }

  // Propagates the wave of a side into the face on the other side of the edge.
  void enter_face(Index left_side)
  {
    Index side = m_faces.known_twin(left_side);
    if(side < 0) {
      const Input_halfedge_index h = twin_index(m_faces[left_side].halfedge);
      if(m_triangulation.input().is_border(h))
        return;
      side = m_faces.number(h);
    }
    const Index next = Faces::next(side), previous = Faces::previous(side);
    if(known_wave(left_side)->is_borrowed &&
       !(is_unmoved(next, Entrance::BEFORE) && is_unmoved(previous, Entrance::AFTER)))
      return fit(left_side);
    update(next, Entrance::BEFORE);
    update(previous, Entrance::AFTER);
  }

  // Returns whether the cone of a side, if there is one, is unaffected by everything that comes by an entrance.
  bool is_unmoved(Index side, Entrance entrance) { return known_wave(side) == nullptr || holds(side, entrance); }

  // Propagates to all edges opposite to a vertex and to its neighbors.
  void leave_vertex(Vertex_index v)
  {
    Vertex_record& record = m_vertices.write(v);
    if(!record.is_waiting)
      return;
    record.is_waiting = false;
    const auto& input = m_triangulation.input();
    const Input_halfedge_index first = input.outgoing(v);
    if(first == null_index)
      return;
    const double distance = record.distance;
    Input_halfedge_index h = first;
    do {
      const Input_halfedge_index t = twin_index(h);
      const bool is_border = input.is_border(h);
      const Index side = m_faces.number(is_border ? t : h);
      reach(input.tail(t), distance + m_faces[side].length, m_faces[side].length);
      if(!is_border && !has_noticed(Faces::next(side), distance))
        update(Faces::next(side), Entrance::APEX);
      h = input.next(t);
    } while(h != first);
  }

  double to_goal(Vertex_record& record, Vertex_index v)
  {
    if(!record.has_bound) {
      record.to_goal = m_goal(v);
      record.has_bound = true;
    }
    return record.to_goal;
  }

  // Records a path to v. The vertex is left slightly later, once it has been passed, so that less work is done twice.
  Vertex_record& reach(Vertex_index v, double distance, double delay)
  {
    Vertex_record& record = m_vertices.write(v);
    if(record.is_reached && record.distance <= distance)
      return record;
    record.distance = distance;
    record.is_reached = true;
    if(distance + to_goal(record, v) > m_bound + m_total_error)
      return record;
    record.is_waiting = true;
    m_queue.push({ordered_bits((std::max)(distance + delay, 0.0)), -1 - v.idx()});
    return record;
  }

  // Returns the wave of a side, if there is one.
  const Wave* known_wave(Index side) const
  {
    const auto i = static_cast<std::size_t>(side);
    return side < 0 || i >= m_waves.size() || !m_waves[i].is_set ? nullptr : &m_waves[i];
  }

  // Returns whether the cone of a side takes the distance of the corner opposite to it into account.
  bool has_noticed(Index side, double distance) const
  {
    const Wave* wave = known_wave(side);
    return wave != nullptr && wave->apex_distance <= distance;
  }

  // Updates the cone of a side so that it is valid for everything that enters its face, part of which has changed.
  void update(Index side, Entrance changed)
  {
    if(m_waves.size() < m_faces.size())
      m_waves.resize(m_faces.size(), Wave());
    if(m_waves[static_cast<std::size_t>(side)].is_set ? !holds(side, changed) : !borrow(side))
      fit(side);
  }

  /*
   * Takes over the cones of the twin halfedge if they are valid: a front has passed the edge in the other direction,
   * and the paths that come back behind it matter too little for cones of their own.
   */
  bool borrow(Index side)
  {
    const Wave* const lender = known_wave(m_faces.known_twin(side));
    if(lender == nullptr || lender->is_borrowed)
      return false;
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    wave.cones = lender->cones.mirrored(m_faces[side].length);
    wave.at_tail = lender->at_head;
    wave.at_split = lender->at_split;
    wave.at_head = lender->at_tail;
    wave.seen = {0, 0};
    wave.is_set = true;
    if(holds(side, Entrance::BEFORE) && holds(side, Entrance::AFTER) && holds(side, Entrance::APEX)) {
      wave.is_borrowed = true;
      send(side);
    } else
      wave.is_set = false;
    return wave.is_set;
  }

  // Returns whether the cone of a side is low enough for everything that comes by one entrance.
  bool holds(Index side, Entrance entrance)
  {
    return entrance == Entrance::APEX ? holds_for_apex(side) : holds_for_side(side, entrance);
  }

  bool holds_for_apex(Index side)
  {
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    wave.apex_distance = distance_of_apex(side);
    if((std::max)({wave.at_tail, wave.at_split, wave.at_head}) <= wave.apex_distance + m_faces.apex(side).imag())
      return true;
    const double length = m_faces[side].length;
    Lit_parts parts;
    add_apex(parts, side, 0, length);
    return wave.cones.are_below(parts, length, tolerance(wave));
  }

  bool holds_for_side(Index side, Entrance entrance)
  {
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    const Wave* const other = entering(side, entrance);
    std::int32_t& seen = wave.seen[entrance == Entrance::AFTER ? 1 : 0];
    if(other == nullptr || seen == other->version)
      return true;
    if(!clearly_holds(side, *other, entrance)) {
      Lit_parts parts;
      light_from(parts, side, entrance);
      if(!wave.cones.are_below(parts, m_faces[side].length, tolerance(wave)))
        return false;
    }
    seen = other->version;
    return true;
  }

  // The wave that comes across the side before or after a side, if any.
  const Wave* entering(Index side, Entrance entrance) const
  {
    const Wave* const wave =
        known_wave(m_faces.known_twin(entrance == Entrance::AFTER ? Faces::next(side) : Faces::previous(side)));
    // A borrowed wave must wait until it is known to be harmless.
    return wave == nullptr || (wave->is_borrowed && wave->is_waiting) ? nullptr : wave;
  }

  /*
   * A quick sufficient test that the cones of a side are low enough for everything that comes across the side before or
   * after it: their chords are not above the tangent of the incoming cone at the common corner.
   */
  bool clearly_holds(Index side, const Wave& other, Entrance entrance) const
  {
    const bool is_mirrored = entrance == Entrance::AFTER;
    const auto& edge = m_faces[is_mirrored ? Faces::next(side) : Faces::previous(side)];
    if(other.cones.split < edge.length)
      return false;
    const Wave& wave = *known_wave(side);
    const double length = m_faces[side].length;
    const double here = is_mirrored ? wave.at_head : wave.at_tail, there = is_mirrored ? wave.at_tail : wave.at_head;
    const double start = is_mirrored ? other.at_head : other.at_tail;
    if(here > start + m_error)
      return false;
    const Cone& cone = other.cones.first;
    const auto& corner = m_faces[is_mirrored ? Faces::next(side) : side];
    const double run = start - cone.sigma; // from the pseudo-source to the corner
    const double slope = corner.sine * cone.y - corner.cosine * (is_mirrored ? edge.length - cone.x : cone.x) - m_error;
    const bool is_split = wave.cones.split < length;
    const double to_split = is_mirrored ? length - wave.cones.split : wave.cones.split;
    return (there - start) * run <= length * slope && (!is_split || (wave.at_split - start) * run <= to_split * slope);
  }

  // Fits the cone of a side to everything that enters its face.
  void fit(Index side)
  {
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    const Lit_parts parts = lit_parts(side);
    wave.apex_distance = distance_of_apex(side);
    if(parts.size == 0) {
      wave.is_set = wave.is_set && !wave.is_borrowed; // nothing enters its face yet
      return;
    }
    const double length = m_faces[side].length;
    ++m_updates;
    ++wave.number_of_updates;
    if(wave.number_of_updates > m_free_updates)
      m_total_error += tolerance(wave);
    if(m_updates > m_most_updates_per_side * m_faces.size()) // not useful any more
      m_total_error = infinity;
    wave.cones = fitted_cones(parts, length, m_error);
    wave.is_set = true;
    wave.is_borrowed = false;
    wave.at_tail = wave.cones.first(0);
    wave.at_head = wave.cones.last(length)(length);
    wave.at_split = wave.cones.split < length ? wave.cones.first(wave.cones.split) : wave.at_tail;
    for(const Entrance entrance : {Entrance::BEFORE, Entrance::AFTER}) {
      const Wave* const other = entering(side, entrance);
      wave.seen[entrance == Entrance::AFTER ? 1 : 0] = other == nullptr ? 0 : other->version;
    }
    send(side);
  }

  // Passes the values of a side's cone to its ends, and queues the cone for propagation if it matters.
  void send(Index side)
  {
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    ++wave.version;
    const double length = m_faces[side].length;
    const Vertex_index tail = m_faces[side].tail, head = m_faces[Faces::next(side)].tail;
    const double from_tail = to_goal(reach(tail, wave.at_tail, length), tail);
    const double from_head = to_goal(reach(head, wave.at_head, length), head);
    // The slope of a cone is at most 1.
    wave.is_waiting =
        (std::max)(wave.at_head + from_tail, wave.at_tail + from_head) - length <= m_bound + m_total_error;
    if(wave.is_waiting)
      m_queue.push({wave.key(), side});
  }

  /*
   * The amount by which a cone may be too high. Cones around a vertex with a small angle, and at needle-shaped faces,
   * lower each other repeatedly; each time the tolerance grows, so that they terminate.
   */
  double tolerance(const Wave& wave) const
  {
    const int further = wave.number_of_updates - m_free_updates;
    return further <= 0 ? m_error : std::ldexp(m_error, 2 * further);
  }

  // Everything that comes by all entrances, in the frame of a side that extends from 0 to its length on the x-axis with
  // its face above.
  Lit_parts lit_parts(Index side) const
  {
    const double length = m_faces[side].length;
    Lit_parts parts;
    const Lit_end before = light_from(parts, side, Entrance::BEFORE), after = light_from(parts, side, Entrance::AFTER);
    // If one cone reaches the edge, the paths by way of the apex are not shorter if the cone's value at the apex is not
    // larger.
    const double enough = distance_of_apex(side) + m_error;
    add_apex(parts, side, before.apex_value <= enough ? before.place : 0,
             after.apex_value <= enough ? length - after.place : length);
    return parts;
  }

  // The extent to which one cone reaches an edge from an end on, and its value at the apex.
  struct Lit_end
  {
    double place = 0, apex_value = infinity;
  };

  // Adds everything that comes across the side before or after a side.
  Lit_end light_from(Lit_parts& parts, Index number, Entrance entrance) const
  {
    const Index next_number = Faces::next(number), previous_number = Faces::previous(number);
    const bool is_mirrored = entrance == Entrance::AFTER; // mirrored, as seen from the head
    const auto &close_by = m_faces[is_mirrored ? next_number : number], &side = m_faces[number];
    const double length = m_faces[is_mirrored ? next_number : previous_number].length;
    const Wave* const wave = entering(number, entrance);
    if(wave == nullptr)
      return {};
    const Edge_cones cones = is_mirrored ? wave->cones.mirrored(length) : wave->cones;
    Lit_end end;
    end.apex_value = cones.last(length)(length);
    const Light_through_side light(cones, length, Vector(close_by.cosine, close_by.sine), m_error);
    end.place = light.add_to(parts, side.length, is_mirrored);
    return end;
  }

  // The distance of the corner opposite to a side; waves pass their values to their ends, so that it is not above
  // these.
  double distance_of_apex(Index side) const
  {
    const Vertex_record& record = m_vertices[m_faces[Faces::previous(side)].tail];
    return record.is_reached ? record.distance : infinity;
  }

  // Adds the paths by way of the apex to a part of a side.
  void add_apex(Lit_parts& parts, Index side, double from, double to) const
  {
    const double distance = distance_of_apex(side);
    if(!(distance < infinity))
      return;
    const Vector apex = m_faces.apex(side);
    parts.add({apex.real(), std::abs(apex.imag()), distance}, from, to);
  }

  const Triangulation& m_triangulation;
  Faces& m_faces;
  Vertex_index m_source;
  Goal_bound<Triangulation> m_goal;
  Block_array<Wave> m_waves; // of sides, that is, of halfedges whose faces have been computed
  Written_records<Vertex_index, Vertex_record> m_vertices;
  int m_free_updates;
  std::size_t m_most_updates_per_side;
  Heap_of_four<Entry> m_queue;
  double m_bound = infinity, m_error = 0, m_total_error = 0;
  std::size_t m_updates = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_SWEEP_H
