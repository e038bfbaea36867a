// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_HALFEDGE_STORE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_HALFEDGE_STORE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/surface/Slot_table.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>

#include <CGAL/assertions.h>

#include <boost/align/aligned_allocator.hpp>
#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * What the log of an `Intrinsic_triangulation` stores of a flip: enough to undo it, and to derive the crossings of the
 * new edge. If `hp` is `null_index`, no edge was flipped. Then either the face of `h` was recomputed from the input,
 * `tn` is `null_index` as well, and the first three vectors are the old ones; or a point was inserted, `number` is the
 * number of the insertion, `version_hp` the `gap()`, and `tn` is `h` if its face was split and its twin if its edge
 * was.
 */
template <class Halfedge_geometry>
struct Flip_record
{
  Halfedge_index h;         // the flipped halfedge, i->j before and l->k after
  Halfedge_index hp;        // k->i
  Halfedge_index tn;        // i->l
  Index version_hp;         // the version of `hp` at the time
  Index version_tn;         // the version of `tn` at the time
  Index number;             // number of input edges that the new edge crosses; -1 if it lies along one
  Index old_version;        // of the edge, before
  Index old_crossings;      // one more than the number of input edges that the edge crossed before
  Halfedge_geometry old_h;  // what `h` stored before
  Halfedge_geometry old_t;  // what the other side of the edge stored before
  Halfedge_geometry old_tn; // what `tn` stored before
  Halfedge_geometry old_tp; // what the halfedge l->j stored before

  /* Returns whether an edge was flipped. */
  bool is_flip() const { return hp != null_index; }
  /* Returns whether a point was inserted. */
  bool is_insertion() const { return hp == null_index && tn != null_index; }
  /* Returns whether the point was inserted on the edge of `h` rather than into its face. \pre `is_insertion()` */
  bool is_on_edge() const { return tn != h; }
  /* Returns the gap of the edge sequence of `h` whose input face contains the inserted point. \pre `is_insertion()` */
  Index gap() const { return version_hp; }
};

/* Hints to the cache that an address will be read soon. */
inline void prefetch(const void* address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
  asm volatile(""); // prevents g++ from dropping calls of functions that only prefetch, as if they had no effect
#else
  static_cast<void>(address);
#endif
}

/* The position at which a triangulation stores a halfedge, next to its twin. */
enum class Slot : Index { NONE = 0 };

inline Slot twin_slot(Slot s) { return static_cast<Slot>(static_cast<Index>(s) ^ 1); }

/* Returns the slot of h, given that of h or its twin. */
inline Slot side_slot(Slot s, Halfedge_index h)
{
  return static_cast<Slot>((static_cast<Index>(s) & ~1) | (h.idx() & 1));
}

/*
 * The data that a triangulation stores for a halfedge, and half of that for its edge: the first side has the crossings
 * and the version, the second the number of holds and the index of the edge. A new record is a side of an input edge
 * whose face is not known yet. With two doubles of geometry it takes 32 bytes, so an edge fills a cache line.
 */
template <class Halfedge_geometry>
struct Halfedge_record
{
  static constexpr Index border = -1;

  Index encoded_next; // border, or the slot of the next halfedge
  Vertex_index tail;  // null_index until the face is known; for a face of the input, it is written last
  Index of_edge[2];   // crossings + 1 and version; or holds and first halfedge, + 1 if a side is outgoing
  Halfedge_geometry geometry;

  bool is_known() const { return load_acquire(tail) != null_index; }
  bool is_border() const { return encoded_next == border; }
  /* \pre known and not on the border */
  Slot next() const
  {
    CGAL_precondition_msg(encoded_next > 0, "the halfedge must not be on the border");
    return static_cast<Slot>(encoded_next);
  }
  void set_next(Slot s) { encoded_next = static_cast<Index>(s); }
};

/*
 * The halfedges of a triangulation and an outgoing halfedge per vertex: those of the input, each face copied when it is
 * first touched, and those that are added. Untouched elements are thus neither read nor written, and elements touched
 * together lie close together, since slots are assigned in that order. Links between halfedges are slots; only access
 * by the index of a halfedge uses the table of slots.
 *
 * Several threads may read simultaneously, which can copy faces. Copies are written while the lock is held, at
 * addresses that no thread reads before it has read a slot, the tail of a halfedge or the halfedge of a vertex, each of
 * which is written last. Memory is reserved beforehand, so that nothing moves. All other members must be called by one
 * thread at a time.
 */
template <class Input_mesh_, class Traits_, class Metric_>
class Halfedge_store
{
public:
  using Input_mesh = Input_mesh_;
  using Traits = Traits_;
  using Metric = Metric_;
  using Halfedge_geometry = typename Traits::Halfedge_geometry;
  using Record = Halfedge_record<Halfedge_geometry>;

  Halfedge_store(const Input_mesh& input, const Metric& metric, const Traits& traits)
    : m_input(input)
    , m_metric(metric)
    , m_traits(traits)
    , m_number_of_vertices(m_input.number_of_vertices())
    , m_number_of_halfedges(m_input.number_of_halfedges())
    , m_slots(static_cast<std::size_t>(m_number_of_halfedges))
    , m_vertex_slots(static_cast<std::size_t>(m_number_of_vertices))
  {
    m_records.reserve(room_for(m_slots)); // so that none moves
    m_records.resize(m_slots.number_of_slots());
    m_outgoing.reserve(room_for(m_vertex_slots));
    m_outgoing.resize(m_vertex_slots.number_of_slots(), Slot::NONE);
  }

  // The numbers of elements in the moved-from object do not matter.
  Halfedge_store(Halfedge_store&&) noexcept = default;
  Halfedge_store& operator=(Halfedge_store&&) noexcept = default;

  const Input_mesh& input() const { return m_input; }
  const Metric& metric() const { return m_metric; }
  const Traits& traits() const { return m_traits; }

  Index number_of_vertices() const { return m_number_of_vertices; }
  Index number_of_edges() const { return m_number_of_halfedges / 2; }

  /* Returns the record of a slot as it is; if the face is known, so are the two other halfedges of the face. */
  Record& operator[](Slot s) { return m_records[static_cast<std::size_t>(s)]; }
  const Record& operator[](Slot s) const { return m_records[static_cast<std::size_t>(s)]; }

  /* Returns the slot of a halfedge. If its edge was never touched, the slot has a record of zeros that must not be
   * written. */
  Slot slot(Halfedge_index h) const { return static_cast<Slot>(m_slots[h.idx()]); }

  /* Returns the halfedge of a slot in use. */
  Halfedge_index halfedge(Slot s) const
  {
    return Halfedge_index((load_relaxed(second_side(s).of_edge[1]) & ~1) | (static_cast<Index>(s) & 1));
  }

  /* Returns the record of a halfedge, or of a slot in use as in each step of a walk, and copies its face first if
   * necessary. */
  Record& known(Halfedge_index h)
  {
    Record& record = (*this)[slot(h)];
    return record.is_known() ? record : imported(h);
  }

  BOOST_FORCEINLINE Record& known(Slot s)
  {
    Record& record = (*this)[s];
    return record.is_known() ? record : imported(halfedge(s));
  }

  /* Returns the slot of a halfedge, after assigning one if it has none. */
  Slot taken(Halfedge_index h)
  {
    const Slot s = slot(h);
    return static_cast<std::size_t>(s) < Halfedge_slots::block_size ? newly_taken(h) : s;
  }

  /* Prefetches the two other sides of the face of a slot, if the face is known. */
  void prefetch_face(Slot s) const
  {
    const Record& record = (*this)[s];
    if(!record.is_known() || record.is_border())
      return;
    const Record& hn = (*this)[record.next()];
    prefetch(&hn);
    prefetch(&(*this)[hn.next()]);
  }

  Index& crossings_plus_one(Slot s) { return first_side(s).of_edge[0]; }
  Index& version(Slot s) { return first_side(s).of_edge[1]; }
  Index crossings_plus_one(Slot s) const { return first_side(s).of_edge[0]; }
  Index version(Slot s) const { return first_side(s).of_edge[1]; }
  Index crossings(Slot s) const { return crossings_plus_one(s) - 1; }

  /* Returns the number of networks that hold the edge of a slot. */
  Index holds(Slot s) const { return second_side(s).of_edge[0]; }
  std::size_t number_of_holds() const { return m_number_of_holds; }

  void hold(Slot s)
  {
    ++second_side(s).of_edge[0];
    ++m_number_of_holds;
  }

  /* \pre the edge is held */
  void release(Slot s)
  {
    CGAL_precondition_msg(holds(s) > 0, "only a held edge can be released");
    --second_side(s).of_edge[0];
    --m_number_of_holds;
  }

  /* An edge has two consecutive slots; half of the first one is a number of the edge. */
  std::size_t number_of_edge_places() const { return m_slots.number_of_slots() / 2; }

  /* Returns a halfedge that starts at v, or null_index for an isolated vertex. */
  Halfedge_index outgoing(Vertex_index v)
  {
    const Slot s = outgoing_slot(v);
    return s != Slot::NONE ? halfedge(s) : first_outgoing(v);
  }

  void set_outgoing(Vertex_index v, Slot s)
  {
    if(!m_vertex_slots.has_slot(v.idx())) {
      m_outgoing.resize(m_vertex_slots.number_of_slots() + Vertex_slots::block_size, Slot::NONE);
      m_vertex_slots.add(v.idx());
    }
    store_release(m_outgoing[static_cast<std::size_t>(m_vertex_slots[v.idx()])], s);
    if(s != Slot::NONE)
      store_relaxed(second_side(s).of_edge[1], load_relaxed(second_side(s).of_edge[1]) | 1);
  }

  /* If `from` is the outgoing halfedge stored for v, stores `to` instead. */
  void move_outgoing(Vertex_index v, Slot from, Slot to)
  {
    if(outgoing_slot(v) == from)
      set_outgoing(v, to);
  }

  /* Replaces the outgoing halfedges stored for both sides of an edge, which leave their vertices v and w. Usually
   * neither of them is stored. */
  void move_outgoing(Slot s, Slot instead_of_s, Slot instead_of_twin)
  {
    Index& is_kept = second_side(s).of_edge[1];
    if((is_kept & 1) == 0)
      return;
    move_outgoing((*this)[s].tail, s, instead_of_s);
    move_outgoing((*this)[twin_slot(s)].tail, twin_slot(s), instead_of_twin);
    is_kept &= ~1;
  }

  void link_face(Slot a, Slot b, Slot c)
  {
    (*this)[a].set_next(b);
    (*this)[b].set_next(c);
    (*this)[c].set_next(a);
  }

  /* Sets the vectors of the face on the left of h, starting with h. \pre the face is known */
  void set_face_geometry(Halfedge_index h, const Halfedge_geometry& at_h, const Halfedge_geometry& at_hn,
                         const Halfedge_geometry& at_hp)
  {
    Record& first = (*this)[slot(h)];
    Record& second = (*this)[first.next()];
    first.geometry = at_h;
    second.geometry = at_hn;
    (*this)[second.next()].geometry = at_hp;
  }

  /* Changes nothing if it throws; neither does add_edge(). */
  void add_vertex()
  {
    m_vertex_slots.grow(static_cast<std::size_t>(m_number_of_vertices) + 1);
    if(m_outgoing.capacity() < m_vertex_slots.largest_number_of_slots())
      m_outgoing.reserve(room_for(m_vertex_slots));
    ++m_number_of_vertices;
  }

  void remove_last_vertex()
  {
    const Vertex_index v(--m_number_of_vertices);
    if(m_vertex_slots.has_slot(v.idx()))
      set_outgoing(v, Slot::NONE);
  }

  /* Adds an edge whose sides have no face yet, which can move all records. Returns its first slot. */
  Slot add_edge()
  {
    m_slots.grow(static_cast<std::size_t>(m_number_of_halfedges) + 2);
    if(m_records.capacity() < m_slots.largest_number_of_slots())
      m_records.reserve(room_for(m_slots));
    m_number_of_halfedges += 2;
    return taken(Halfedge_index(m_number_of_halfedges - 2));
  }

  void remove_last_edge()
  {
    m_number_of_halfedges -= 2;
    const Slot s = slot(Halfedge_index(m_number_of_halfedges));
    first_side(s) = second_side(s) = Record();
    second_side(s).of_edge[1] = m_number_of_halfedges;
  }

private:
  using Halfedge_slots = Slot_table<8>;
  using Vertex_slots = Slot_table<16>;

  // Leaves room for some additional elements.
  template <class Slots>
  static std::size_t room_for(const Slots& slots)
  {
    return slots.largest_number_of_slots() + slots.largest_number_of_slots() / 8;
  }

  const Record& first_side(Slot s) const { return m_records[static_cast<std::size_t>(s) & ~std::size_t(1)]; }
  const Record& second_side(Slot s) const { return m_records[static_cast<std::size_t>(s) | 1]; }
  Record& first_side(Slot s) { return m_records[static_cast<std::size_t>(s) & ~std::size_t(1)]; }
  Record& second_side(Slot s) { return m_records[static_cast<std::size_t>(s) | 1]; }

  Slot outgoing_slot(Vertex_index v) const
  {
    return load_acquire(m_outgoing[static_cast<std::size_t>(m_vertex_slots[v.idx()])]);
  }

  // Returns the slot of a halfedge that may have none.
  BOOST_NOINLINE Slot newly_taken(Halfedge_index h)
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    take(h);
    return slot(h);
  }

  // Assigns a slot to h, unless it has one. \pre the lock is held
  BOOST_NOINLINE void take(Halfedge_index h)
  {
    if(m_slots.has_slot(h.idx()))
      return;
    constexpr Index block_size = static_cast<Index>(Halfedge_slots::block_size);
    const Index start = static_cast<Index>(m_slots.number_of_slots()), first = h.idx() / block_size * block_size;
    m_records.resize(m_slots.number_of_slots() + Halfedge_slots::block_size);
    for(Index i = 0; i < block_size; i += 2)
      second_side(static_cast<Slot>(start + i)).of_edge[1] = first + i;
    m_slots.add(h.idx());
  }

  // Returns the record of a halfedge whose face may be unknown.
  BOOST_NOINLINE Record& imported(Halfedge_index h)
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    copy_face(h);
    return (*this)[slot(h)];
  }

  // Sets the first outgoing halfedge of a vertex of the input; added vertices have one from the start.
  BOOST_NOINLINE Halfedge_index first_outgoing(Vertex_index v)
  {
    const Halfedge_index h = as_intrinsic(m_input.outgoing(v));
    if(h == null_index)
      return null_index;
    const std::lock_guard<Short_lock> guard(m_lock);
    if(outgoing_slot(v) == Slot::NONE) {
      copy_face(h);
      set_outgoing(v, slot(h));
    }
    return halfedge(outgoing_slot(v));
  }

  // Copies the face of a halfedge, unless it is known. \pre the lock is held
  void copy_face(Halfedge_index wanted)
  {
    if((*this)[slot(wanted)].is_known())
      return;
    const Input_halfedge_index h = as_input(wanted);
    if(m_input.is_border(h)) {
      check_has_face(m_input, h); // the length is stored only on a side with a face
      take(wanted);
      Record& record = (*this)[slot(wanted)];
      record.encoded_next = Record::border;
      store_release(record.tail, m_input.tail(h));
      return;
    }
    check_triangle(m_input, h);
    if(m_input.next(h) == h)
      throw_no_triangle(m_input, h);
    // Starts with the smallest side, so that results are bitwise independent of the side that is touched first.
    const Input_halfedge_index first = least_in_face(m_input, h);
    const Input_halfedge_index sides[3] = {first, m_input.next(first), m_input.next(m_input.next(first))};
    const auto geometry = face_geometry(m_metric, m_input, first, m_traits);
    std::array<Slot, 3> slots;
    for(int i = 0; i < 3; ++i) {
      const Halfedge_index side = as_intrinsic(sides[i]);
      take(side);
      slots[i] = slot(side);
      (*this)[slots[i]].geometry = geometry[i];
    }
    link_face(slots[0], slots[1], slots[2]);
    for(int i = 0; i < 3; ++i) { // tails are written last, when all three sides are otherwise complete
      const Vertex_index v = m_input.tail(sides[i]);
      store_release((*this)[slots[i]].tail, v);
      if(outgoing_slot(v) == Slot::NONE)
        set_outgoing(v, slots[i]);
    }
  }

  Input_mesh m_input;
  Metric m_metric;
  Traits m_traits;
  Index m_number_of_vertices, m_number_of_halfedges;
  std::size_t m_number_of_holds = 0;
  Halfedge_slots m_slots;
  Vertex_slots m_vertex_slots;
  std::vector<Record, boost::alignment::aligned_allocator<Record, 64>> m_records;
  std::vector<Slot> m_outgoing; // NONE if unknown
  Short_lock m_lock;
};

/*
 * The passage of input edges through one intrinsic triangle, computed from the numbers of crossings of its three edges
 * alone [GSC21, section 3]. An input edge in the triangle either cuts a corner, from side to side, or emanates from a
 * corner to the opposite side; a side that lies along an input edge has no crossings.
 *
 * Corner 0 lies opposite side 0.
 */
struct Triangle_crossings
{
  std::array<Index, 3> emanating; // input edges that start at the corner, strictly inside it
  std::array<Index, 3> cutting;   // input edges that cut the corner off

  Triangle_crossings(Index opposite_0, Index opposite_1, Index opposite_2)
  {
    const Index a = (std::max)(opposite_0, 0), b = (std::max)(opposite_1, 0), c = (std::max)(opposite_2, 0);
    // At most one of the three excesses is positive: edges emanate from the corner opposite the side that is too long.
    const Index excess_a = a - b - c, excess_b = b - c - a, excess_c = c - a - b;
    emanating[0] = (std::max)(excess_a, 0);
    emanating[1] = (std::max)(excess_b, 0);
    emanating[2] = (std::max)(excess_c, 0);
    cutting[0] = ((std::max)(-excess_a, 0) - emanating[1] - emanating[2]) / 2;
    cutting[1] = ((std::max)(-excess_b, 0) - emanating[2] - emanating[0]) / 2;
    cutting[2] = ((std::max)(-excess_c, 0) - emanating[0] - emanating[1]) / 2;
  }
};

/* Returns the number of input edges that a halfedge of a triangulation crosses; 0 if it lies along one. */
template <class Triangulation>
Index number_of_crossings(const Triangulation& triangulation, Halfedge_index h)
{
  return (std::max)(triangulation.crossings(Triangulation::edge(h)), 0);
}

/* Returns the passage through the face on the left of h, which is side 0. */
template <class Triangulation>
Triangle_crossings crossings_in_face(const Triangulation& triangulation, Halfedge_index h)
{
  const Halfedge_index hn = triangulation.next(h), hp = triangulation.next(hn);
  return {number_of_crossings(triangulation, h), number_of_crossings(triangulation, hn),
          number_of_crossings(triangulation, hp)};
}

/*
 * The passage of input edges through one of the two triangles of a quad, seen from its diagonal ij: the triangle with
 * the vertex o. The numbers are those of `Triangle_crossings` in closed form, since each flip computes them.
 */
struct Half_quad_crossings
{
  Index cutting_i; // input edges that cut the corner at i off
  Index end;       // these and those that emanate from o
  Index past;      // those that do not reach ij and pass between i and j

  Half_quad_crossings(Index along_ij, Index along_oi, Index along_jo)
  {
    const Index c = (std::max)(along_ij, 0), j = (std::max)(along_oi, 0), i = (std::max)(along_jo, 0);
    const auto clamped = [](Index a, Index b, Index value) {
      return (std::max)((std::min)((std::min)(a, b), value), 0);
    };
    cutting_i = clamped(c, j, (c + j - i) >> 1);
    end = c - clamped(c, i, (c + i - j) >> 1);
    past = (std::max)((std::max)(i, j) - c, (std::max)((i + j - c) >> 1, 0));
  }
};

/*
 * Returns the number of crossings of the diagonal kl of a quad i, l, j, k, given those of its sides and of the diagonal
 * ij. The number -1 marks an edge that lies along an input edge.
 *
 * Input edges that do not reach ij cross kl once, unless they cut i or j off. Along ij, from i to j, the triangle of k
 * first sends those that cut i, then those that emanate from k, then those that cut j; the triangle of l does the same.
 * One that cuts i on one side and j on the other crosses kl; one that emanates from k and ends at l lies along it.
 */
inline Index crossings_of_other_diagonal(Index ij, Index jk, Index ki, Index il, Index lj)
{
  const Half_quad_crossings k(ij, ki, jk), l(ij, il, lj);
  if((std::max)(k.cutting_i, l.cutting_i) < (std::min)(k.end, l.end))
    return -1;
  const Index from_i_to_j = (std::max)(k.cutting_i - l.end, 0), from_j_to_i = (std::max)(l.cutting_i - k.end, 0);
  return k.past + l.past + from_i_to_j + from_j_to_i + (ij < 0 ? 1 : 0);
}

/*
 * The steps that have changed the halfedges of a triangulation, each with the data that it overwrote. Flips and
 * recomputed faces are performed here; of inserted points, only their position in the log is recorded.
 *
 * Invariant: rolled back from the last one on, the records restore the original store bitwise.
 */
template <class Store>
class Flip_log
{
  using Halfedge_record = typename Store::Record;
  using Geometry = typename Store::Halfedge_geometry;

public:
  using Record = Flip_record<Geometry>;

  std::size_t size() const { return m_records.size(); }
  const Record& operator[](std::size_t i) const { return m_records[i]; }
  const Record& back() const { return m_records.back(); }
  /* Returns the memory in bytes. */
  std::size_t memory() const { return m_records.memory(); }

  /*
   * Flips the edge of a halfedge, see `Intrinsic_triangulation::flip()`. Returns the halfedges that have new vectors.
   * Changes nothing if it throws.
   */
  std::array<Slot, 4> flip(Store& halfedges, Halfedge_index h)
  {
    const Slot s = halfedges.taken(h), t = twin_slot(s);
    Halfedge_record &at_h = halfedges.known(s), &at_t = halfedges.known(t); // now both faces are known
    const Slot hn = at_h.next(), tn = at_t.next();
    CGAL_precondition_msg(hn != t && tn != s, "an edge at a vertex of degree 1 cannot be flipped");
    CGAL_precondition_msg(halfedges.holds(s) == 0, "an edge of a curve cannot be flipped");
    Halfedge_record &at_hn = halfedges[hn], &at_tn = halfedges[tn];
    const Slot hp = at_hn.next(), tp = at_tn.next();
    Halfedge_record &at_hp = halfedges[hp], &at_tp = halfedges[tp];

    auto flipped = halfedges.traits().flip_object()(at_h.geometry, at_hn.geometry, at_hp.geometry, at_t.geometry,
                                                    at_tn.geometry, at_tp.geometry);
    const Index new_crossings =
        crossings_of_other_diagonal(halfedges.crossings(s), halfedges.crossings(hn), halfedges.crossings(hp),
                                    halfedges.crossings(tn), halfedges.crossings(tp));
    m_records.push_back({h, halfedges.halfedge(hp), halfedges.halfedge(tn), halfedges.version(hp),
                         halfedges.version(tn), new_crossings, halfedges.version(s), halfedges.crossings(s) + 1,
                         at_h.geometry, at_t.geometry, at_tn.geometry, at_tp.geometry});

    halfedges.move_outgoing(s, tn, hn);
    halfedges.version(s) = static_cast<Index>(m_records.size());
    halfedges.crossings_plus_one(s) = new_crossings + 1;
    at_h.set_next(hp);
    at_hp.set_next(tn);
    at_tn.set_next(s);
    at_t.set_next(tp);
    at_tp.set_next(hn);
    at_hn.set_next(t);
    at_h.tail = at_tp.tail;
    at_t.tail = at_hp.tail;
    at_h.geometry = std::move(flipped.h);
    at_t.geometry = std::move(flipped.t);
    at_tn.geometry = std::move(flipped.tn);
    at_tp.geometry = std::move(flipped.tp);
    return {{s, t, tn, tp}};
  }

  /* Replaces the vectors of the face on the left of a halfedge, starting with that halfedge. */
  template <class Face_geometry>
  void lay_out(Store& halfedges, Halfedge_index h, const Face_geometry& geometry)
  {
    const Halfedge_record& at_h = halfedges.known(h);
    const Halfedge_record &at_hn = halfedges[at_h.next()], &at_hp = halfedges[at_hn.next()];
    m_records.push_back(
        {h, null_index, null_index, 0, 0, 0, 0, 0, at_h.geometry, at_hn.geometry, at_hp.geometry, Geometry()});
    halfedges.set_face_geometry(h, geometry[0], geometry[1], geometry[2]);
  }

  /* Records that the edge of h, or the face on its left, will be split at a gap by the insertion with a number. */
  void note_insertion(const Store& halfedges, Halfedge_index h, bool is_on_edge, Index gap, Index number)
  {
    const Slot s = halfedges.slot(h);
    m_records.push_back({h, null_index, is_on_edge ? halfedges.halfedge(twin_slot(s)) : h, gap, 0, number,
                         halfedges.version(s), halfedges.crossings(s) + 1, Geometry(), Geometry(), Geometry(),
                         Geometry()});
  }

  /* Rolls the last step back. If it is an insertion, its halfedges must have been restored before. */
  void take_back(Store& halfedges)
  {
    const Record& last = m_records.back();
    if(last.is_flip())
      unflip(halfedges, last);
    else if(!last.is_insertion())
      halfedges.set_face_geometry(last.h, last.old_h, last.old_t, last.old_tn);
    m_records.pop_back();
  }

private:
  // h = l->k in (h, hp, tn) and t = k->l in (t, tp, hn) become i->j and j->i again.
  static void unflip(Store& halfedges, const Record& flip)
  {
    const Slot h = halfedges.slot(flip.h), t = twin_slot(h);
    Halfedge_record &at_h = halfedges[h], &at_t = halfedges[t];
    const Slot hp = at_h.next(), tp = at_t.next(), tn = halfedges[hp].next(), hn = halfedges[tp].next();
    Halfedge_record &at_tn = halfedges[tn], &at_tp = halfedges[tp];
    halfedges.move_outgoing(h, tp, hp);
    halfedges.version(h) = flip.old_version;
    halfedges.crossings_plus_one(h) = flip.old_crossings;
    halfedges.link_face(h, hn, hp);
    halfedges.link_face(t, tn, tp);
    at_h.tail = at_tn.tail;
    at_t.tail = halfedges[hn].tail;
    at_h.geometry = flip.old_h;
    at_t.geometry = flip.old_t;
    at_tn.geometry = flip.old_tn;
    at_tp.geometry = flip.old_tp;
  }

  Block_array<Record> m_records;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_HALFEDGE_STORE_H
