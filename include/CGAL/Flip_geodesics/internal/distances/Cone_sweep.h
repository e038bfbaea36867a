// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_SWEEP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_SWEEP_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Edge_cones.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>
#include <CGAL/Flip_geodesics/internal/distances/Landmark_rows.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/Slot_table.h>

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
 * A record for each element of a sequence, of which few are written: these lie side by side, in the order in which they
 * were first written, and stay in place. All others are one record, which is as it was made.
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

  /* The element's own record, to be changed. */
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
 * Lower bounds of the distances from a vertex, within a per cent or so, for a small part of the price of the distances.
 *
 * Each halfedge has a cone, or two beside each other. No path from the source that leaves the halfedge's face through it,
 * at whatever place, is shorter than the least of three: what the cone says for the place, and the distances of the two
 * ends with the way from there along the edge. Such cones follow from each other. A path that leaves face abc through ab has entered it
 * through bc or ca, or comes from c; so no path is shorter than the least that the cones of those edges and the distance
 * of c allow,
 *
 *               c
 *              / .               what enters through ca comes straight from its cone's point, and lights ab from a
 *       P     /   .     N        to where the line through c ends; what enters through bc lights the other end;
 *            /     .             the paths by way of c, and those along ab, are longer than that, or else they count
 *           a-------b
 *
 * The cone of ab is fitted to these, so that it is nowhere above them, and meets them at a and b: were it below there,
 * cones around a vertex would push each other down for ever. Where two fronts meet on an edge, it has two. So the bounds
 * hold whatever the fit, and whatever the order in which faces are passed; good ones are cheap where faces are passed in
 * the order of the distance. A face is passed again when a cone is not low enough any more. The waves of a fast marching
 * method with virtual sources [NK02] are cones of this kind, fitted to be near the distance and not to be below.
 *
 * Most halfedges are passed by a front from one face to the other only. What comes back over the other halfedge of the
 * edge follows from vertices behind the front, and matters little: there the cones of the first are low enough, and are
 * borrowed. They may be much lower than need be, and would lower others again. Where they would, cones of its own are
 * fitted to what comes back.
 *
 * That the paths by way of all corners count, also of those at which no shortest path turns, makes the bounds a matter of
 * the triangle inequality alone: a fitted cone's point may be where it sends its rays past the edge that they should hit.
 *
 * What is lit is enlarged a little, for rounding. A shortest path takes one step for a face at most, and by what all steps
 * together may be wrong is taken off what is answered.
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
  /* \param goal where the paths go that matter
   * \param free_updates of a cone, that are exact; more of them are dear on needles, and keep the sweep useful there
   * \param most_updates_per_side on average; more of them, which six free ones cannot lead to, end a useless sweep */
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
   * Sweeps over all that paths from the source to the goal pass which are not longer than `bound`. If it is interrupted,
   * then it is not useful.
   * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
   */
  void run(double bound, Interruption* interruption = nullptr)
  {
    run_from(std::array<Vertex_index, 1>{{m_source}}, bound, interruption);
  }

  /* The same from the nearest of several vertices. */
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

  /* Is not all of what was found lost to errors that had to be allowed, for it to come to an end? */
  bool is_useful() const { return m_total_error <= largest_cone_error * m_bound; }

  Vertex_index source() const { return m_source; }
  double bound() const { return m_bound; }

  /* No path from the source to v is shorter, of those that matter. */
  double distance_lower_bound(Vertex_index v) const
  {
    if(!is_useful())
      return in_space(v);
    return m_vertices[v].is_reached ? m_vertices[v].distance - m_total_error : infinity;
  }

  /*
   * No path is shorter that comes as a cone says over the edge of h, between two places on it, into the face on the left
   * of h, and ends at the source.
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
    const double tail = cone(to) - to + in_space(a); // since a cone is not steeper than 1
    const double head = cone(from) - (length - from) + in_space(b);
    return (std::max)({cone.least(from, to), tail, head});
  }

  /* The cones over the edge of h of paths that leave the face on the left of h, too high by `total_error()` at most. None
   * if no such path matters. \pre is_useful() */
  const Edge_cones* cones(Input_halfedge_index h) const
  {
    const Wave* const wave = known_wave(m_faces.known_number(h));
    return wave == nullptr ? nullptr : &wave->cones;
  }
  double total_error() const { return m_total_error; }

  /* What the sweep has cost: how many times a halfedge was looked at. */
  std::size_t number_of_updates() const { return m_updates; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // By which paths come to a side of a face: over the side before it, over the side after it, or by way of the apex.
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

  // Carries the wave of a side into the face on the other side of the edge.
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

  // Does the cone of a side, if there is one, stay as it is whatever comes by an entrance?
  bool is_unmoved(Index side, Entrance entrance) { return known_wave(side) == nullptr || holds(side, entrance); }

  // All edges opposite to a vertex, and the vertices beside it.
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

  // A path to v. It is left a little later, once it has been passed: then there is less that is done twice.
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

  // The wave of a side, if there is one.
  const Wave* known_wave(Index side) const
  {
    const auto i = static_cast<std::size_t>(side);
    return side < 0 || i >= m_waves.size() || !m_waves[i].is_set ? nullptr : &m_waves[i];
  }

  // Does the cone of a side take the distance of the corner opposite to it into account?
  bool has_noticed(Index side, double distance) const
  {
    const Wave* wave = known_wave(side);
    return wave != nullptr && wave->apex_distance <= distance;
  }

  // Makes the cone of a side hold for what enters its face, of which some has changed.
  void update(Index side, Entrance changed)
  {
    if(m_waves.size() < m_faces.size())
      m_waves.resize(m_faces.size(), Wave());
    if(m_waves[static_cast<std::size_t>(side)].is_set ? !holds(side, changed) : !borrow(side))
      fit(side);
  }

  /*
   * Takes the cones of the other halfedge over, if they hold: a front has passed the edge in the other direction, and
   * what comes back behind it matters so little that it is not worth cones of its own.
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

  // Is the cone of a side low enough for what comes by one entrance?
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

  // What comes over the side before or after a side, if anything does.
  const Wave* entering(Index side, Entrance entrance) const
  {
    const Wave* const wave =
        known_wave(m_faces.known_twin(entrance == Entrance::AFTER ? Faces::next(side) : Faces::previous(side)));
    // One that is borrowed has to wait until it is seen to do no harm.
    return wave == nullptr || (wave->is_borrowed && wave->is_waiting) ? nullptr : wave;
  }

  /*
   * Is it easily seen that the cones of a side are low enough for what comes over the side before or after it? Their
   * chords are not above the tangent of what comes in, at the corner that they share.
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
    const double run = start - cone.sigma; // from the cone's point to the corner
    const double slope = corner.sine * cone.y - corner.cosine * (is_mirrored ? edge.length - cone.x : cone.x) - m_error;
    const bool is_split = wave.cones.split < length;
    const double to_split = is_mirrored ? length - wave.cones.split : wave.cones.split;
    return (there - start) * run <= length * slope && (!is_split || (wave.at_split - start) * run <= to_split * slope);
  }

  // Fits the cone of a side to all that enters its face.
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

  // Tells the ends of a side what its cone says for them, and has it carried on, if it is of interest.
  void send(Index side)
  {
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    ++wave.version;
    const double length = m_faces[side].length;
    const Vertex_index tail = m_faces[side].tail, head = m_faces[Faces::next(side)].tail;
    const double from_tail = to_goal(reach(tail, wave.at_tail, length), tail);
    const double from_head = to_goal(reach(head, wave.at_head, length), head);
    // A cone is not steeper than 1.
    wave.is_waiting =
        (std::max)(wave.at_head + from_tail, wave.at_tail + from_head) - length <= m_bound + m_total_error;
    if(wave.is_waiting)
      m_queue.push({wave.key(), side});
  }

  /*
   * By how much a cone may be too high. Cones about a vertex with a small angle, and needles, lower each other again and
   * again; they are allowed more each time, and so come to an end.
   */
  double tolerance(const Wave& wave) const
  {
    const int further = wave.number_of_updates - m_free_updates;
    return further <= 0 ? m_error : std::ldexp(m_error, 2 * further);
  }

  // What comes by all entrances, in the frame of a side, from 0 to its length on the x-axis with its face above.
  Lit_parts lit_parts(Index side) const
  {
    const double length = m_faces[side].length;
    Lit_parts parts;
    const Lit_end before = light_from(parts, side, Entrance::BEFORE), after = light_from(parts, side, Entrance::AFTER);
    // Where one cone lights the edge, the paths by way of the apex are no shorter, if the cone says no more for the apex.
    const double enough = distance_of_apex(side) + m_error;
    add_apex(parts, side, before.apex_value <= enough ? before.place : 0,
             after.apex_value <= enough ? length - after.place : length);
    return parts;
  }

  // Up to where one cone lights an edge from an end on, and what it says for the apex.
  struct Lit_end
  {
    double place = 0, apex_value = infinity;
  };

  // Adds what comes over the side before or after a side.
  Lit_end light_from(Lit_parts& parts, Index number, Entrance entrance) const
  {
    const Index next_number = Faces::next(number), previous_number = Faces::previous(number);
    const bool is_mirrored = entrance == Entrance::AFTER; // seen in a mirror, from the head
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

  // That of the corner opposite to a side; waves tell their ends what they say for them, so that it is not above them.
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
  Block_array<Wave> m_waves; // of sides, that is, of halfedges that have been laid out
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
