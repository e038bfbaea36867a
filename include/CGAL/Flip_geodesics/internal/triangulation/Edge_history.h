// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_HISTORY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_HISTORY_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_sequence_path.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * Values computed for the edges that flips created, by the version of the edge: one more than the position of its flip
 * in the log. The least recently used values are dropped when all of them take too much memory, so that identical calls
 * drop identical values. A value is stored with the number of bytes that it owns in addition to its own size.
 *
 * `std::list` and `std::unordered_map` would be as fast for what they hold. Their nodes, however, would take most of
 * the memory; the same limit would then hold fewer values, and long histories would be derived repeatedly.
 */
template <class Value>
class Version_cache
{
  struct Entry
  {
    Value value;
    std::size_t bytes;
    Index version, newer, older;
  };

public:
  /* Returns the value of a version, or null if there is none. Valid until it is dropped or erased. */
  Value* find(Index version)
  {
    if(slot(version) == null_index)
      return nullptr;
    const Index i = m_slots[position(version)];
    if(i != m_newest) {
      unlink(i);
      link_newest(i);
    }
    return &entry(i).value;
  }

  bool contains(Index version) const { return slot(version) != null_index; }

  /* \pre it has no value */
  Value& insert(Index version, Value&& value, std::size_t bytes)
  {
    if(m_slots.size() <= position(version))
      m_slots.resize(position(version) + 1, null_index);
    const Index i = free_entry();
    entry(i).value = std::move(value);
    entry(i).bytes = bytes;
    entry(i).version = version;
    m_slots[position(version)] = i;
    m_bytes += sizeof(Entry) + bytes;
    link_newest(i);
    return entry(i).value;
  }

  /* Removes the last version and passes its value to `recycle`. \pre no later version has a value */
  template <class Recycle>
  void forget(Index version, const Recycle& recycle)
  {
    if(m_slots.size() <= position(version))
      return;
    if(m_slots.back() != null_index)
      drop(m_slots.back(), recycle);
    m_slots.pop_back();
  }

  /* Drops the least recently used values until all of them take at most `most_bytes`. */
  template <class Recycle>
  void shrink(std::size_t most_bytes, const Recycle& recycle)
  {
    while(m_bytes > most_bytes && m_oldest != null_index)
      drop(m_oldest, recycle);
  }

  std::size_t memory() const { return m_bytes + m_slots.memory(); }

private:
  static std::size_t position(Index version) { return static_cast<std::size_t>(version) - 1; }

  Index slot(Index version) const
  {
    return position(version) < m_slots.size() ? m_slots[position(version)] : null_index;
  }

  Entry& entry(Index i) { return m_entries[static_cast<std::size_t>(i)]; }

  Index free_entry()
  {
    if(m_free == null_index) {
      m_entries.push_back(Entry());
      return static_cast<Index>(m_entries.size()) - 1;
    }
    return std::exchange(m_free, entry(m_free).older);
  }

  template <class Recycle>
  void drop(Index i, const Recycle& recycle)
  {
    unlink(i);
    Entry& dropped = entry(i);
    m_slots[position(dropped.version)] = null_index;
    m_bytes -= sizeof(Entry) + dropped.bytes;
    recycle(std::move(dropped.value));
    dropped.value = Value();
    dropped.older = std::exchange(m_free, i);
  }

  void link_newest(Index i)
  {
    entry(i).newer = null_index;
    entry(i).older = m_newest;
    (m_newest == null_index ? m_oldest : entry(m_newest).newer) = i;
    m_newest = i;
  }

  void unlink(Index i)
  {
    const Entry& e = entry(i);
    (e.newer == null_index ? m_newest : entry(e.newer).older) = e.older;
    (e.older == null_index ? m_oldest : entry(e.older).newer) = e.newer;
  }

  Block_array<Index> m_slots;   // by position in the log: the entry of the version
  Block_array<Entry> m_entries; // whose values do not move
  Index m_newest = null_index, m_oldest = null_index;
  Index m_free = null_index; // the first entry without a value, head of a list
  std::size_t m_bytes = 0;
};

/*
 * The edge sequences of an intrinsic triangulation's edges, that is, the input edges that they cross in order, computed
 * by combinatorics alone and therefore exact whatever rounding does. Those of current edges are traced in the
 * triangulation; if that is impossible, and for edges that flips have replaced, they are derived from the flip log.
 *
 * The diagonal kl created by a flip is the path k, i, l moved off i across the flipped edge ij. Its edge sequence is
 * therefore the free reduction of the edge sequence of ki, the input edges crossed by the turn around i, and the edge
 * sequence of il, minus the crossings that touch k or l at the ends. The edge sequences of edges at an inserted point
 * are given when it is inserted. Only the edges from which the requested ones descend are visited: their number is
 * about that of the segments of the curve, not of the flips.
 *
 * Edge sequences can be as long as the number of faces. Those of flips are therefore kept in memory proportional to the
 * number of flips, as long as they are used, and derived again on demand. The data from which numbers are derived is
 * stored for each flip, is nearly always found without edge sequences, and does not depend on which edge sequences are
 * stored.
 */
template <class Triangulation>
class Edge_sequences
{
public:
  /* An edge of the input, or an edge as created by a flip or split, with a direction. */
  struct Edge_version
  {
    Halfedge_index halfedge;
    Index version;
  };

  /*
   * The turns of the diagonal kl created by a flip: the number of input edges crossed by the turn around i from ik to
   * il, the number of those between the first faces of ki and of kl around k, and the number of those between li and lk
   * around l.
   */
  struct Outgoing_halfedges
  {
    Index at_joint, at_tail, at_head;
    // Whether vectors are derived along with the edge sequence; a very short edge sequence is unfolded faster.
    bool are_many;
  };

  /*
   * Returns the edge sequence of halfedge h, from tail to head.
   *
   * An edge whose ends and whose passed points lie on one input edge has an edge sequence only if it is straight.
   * Rounded flips can violate this if points are too close to each other to be distinguished by numbers. The edge
   * sequence then has another number of crossings than the triangulation, whose numbers stay correct under all flips.
   */
  Edge_sequence operator()(const Triangulation& triangulation, Halfedge_index h)
  {
    const Edge_version asked = {h, triangulation.version(Triangulation::edge(h))};
    if(asked.version == 0)
      return input_sequence(triangulation, h);
    if(!is_there(asked))
      trace(triangulation, asked);
    Edge_sequence found = sequence(triangulation, asked);
    if(found.crossed.size() != static_cast<std::size_t>(number_of_crossings(triangulation, h)))
      fail(triangulation, found);
    return found;
  }

  /*
   * Computes the edge sequence of halfedge h from the triangulation alone, without the stored edge sequences; returns
   * false if that is impossible. Can be called by several threads simultaneously.
   */
  static bool read_off(const Triangulation& triangulation, Halfedge_index h, Edge_sequence& sequence)
  {
    if(triangulation.version(Triangulation::edge(h)) == 0) {
      sequence = input_sequence(triangulation, h);
      return true;
    }
    if(!trace_first_side(triangulation, first_side(edge_of(h)), sequence))
      return false;
    if(!is_first_side(h))
      sequence.reverse();
    return true;
  }

  /* Stores the edge sequence of the edge of h, from tail to head, that a split of log position `version - 1`
   * created. */
  void store(Halfedge_index h, Index version, const Edge_sequence& sequence)
  {
    m_sequences_of_splits.emplace(key(Triangulation::edge(h), version),
                                  is_first_side(h) ? sequence : sequence.reversed());
    m_bytes_of_splits += bytes_of_split(sequence);
  }

  /* Returns the edge sequence of an edge as created by a flip or split; derives it from the log if it is not stored. */
  Edge_sequence sequence(const Triangulation& triangulation, const Edge_version& wanted)
  {
    derive(triangulation, wanted);
    Edge_sequence input_edge;
    const Directed_edge_sequence found = directed_sequence(triangulation, wanted, input_edge);
    return found.is_reversed ? found.sequence.reversed() : found.sequence;
  }

  /*
   * Computed from numbers of crossings alone: the input edges in the triangle that the flip made of k, i, l are those
   * that start at its corners and those that cut one off. \pre a flip created the edge
   */
  Outgoing_halfedges outgoing_halfedges(const Triangulation& triangulation, Index version) const
  {
    const Flip_record& flip = triangulation.flip_record(position(version));
    const Index kl = (std::max)(flip.number, 0);
    const Triangle_crossings corners(crossings(triangulation, {flip.tn, flip.version_tn}), kl,
                                     crossings(triangulation, {flip.hp, flip.version_hp}));
    return {corners.emanating[1], corners.emanating[0], corners.emanating[2], kl > few_crossings};
  }

  /* Returns whether a split created the edge. */
  bool is_of_split(const Edge_version& wanted) const { return sequence_of_split(wanted) != nullptr; }

  /* Drops the least recently used edge sequences. Must be called while none is in use. */
  void shrink(std::size_t number_of_records)
  {
    m_sequences.shrink(few_bytes + bytes_per_record * number_of_records,
                       [this](Edge_sequence&& sequence) { recycle(std::move(sequence)); });
  }

  /* Returns the memory in bytes. */
  std::size_t memory() const { return m_sequences.memory() + m_bytes_of_splits; }

  /* Removes the edge sequence of an edge that a flip or split created, since that is rolled back. \pre so is everything
   * after it */
  void forget(Edge_index e, Index version)
  {
    m_sequences.forget(version, [this](Edge_sequence&& sequence) { recycle(std::move(sequence)); });
    if(!m_sequences_of_splits.empty())
      forget_split(key(e, version));
  }

private:
  using Flip_record = typename Triangulation::Flip_record;

  // The memory in which edge sequences are kept.
  static constexpr std::size_t few_bytes = 1 << 20, bytes_per_record = 4;
  static constexpr std::size_t most_spare_crossed_edges = 1 << 10;
  // The number of crossings up to which unfolding is faster than deriving vectors.
  static constexpr Index few_crossings = 4;

  [[noreturn]] static void fail(const Triangulation& triangulation, const Edge_sequence& sequence)
  {
    const Vertex_index v = triangulation.is_inserted(sequence.tail) ? sequence.tail : sequence.head;
    const Input_halfedge_index h = triangulation.location(v).halfedge;
    throw Insertion_error("points near vertex " + std::to_string(v.idx()) + ", in the face of halfedge " +
                              std::to_string(h.idx()) +
                              ", are too close together for double precision and have caused incorrect flips",
                          {static_cast<std::size_t>(h.idx())});
  }

  // An edge sequence, and whether it belongs to the opposite direction.
  struct Directed_edge_sequence
  {
    const Edge_sequence& sequence;
    bool is_reversed;

    Edge_sequence_end tail() const { return is_reversed ? head_end(sequence) : tail_end(sequence); }
    Edge_sequence_end head() const { return is_reversed ? tail_end(sequence) : head_end(sequence); }
  };

  static std::size_t position(Index version) { return static_cast<std::size_t>(version) - 1; }

  // Identifies an edge and the split that created it.
  static std::uint64_t key(Edge_index e, Index version)
  {
    return static_cast<std::uint64_t>(version) << 32 | static_cast<std::uint32_t>(e.idx());
  }

  static Edge_sequence input_sequence(const Triangulation& triangulation, Halfedge_index h)
  {
    const Input_halfedge_index along = as_input(h);
    return {along, {}, null_index, triangulation.input().tail(along), triangulation.input().tail(twin_index(along))};
  }

  static bool has_inserted_vertices(const Triangulation& triangulation)
  {
    return triangulation.number_of_vertices() != triangulation.input().number_of_vertices();
  }

  // The number of input edges that it crosses; 0 if it lies along one.
  Index crossings(const Triangulation& triangulation, const Edge_version& e) const
  {
    if(e.version == 0)
      return 0;
    if(const Edge_sequence* of_split = sequence_of_split(e))
      return static_cast<Index>(of_split->crossed.size());
    return (std::max)(triangulation.flip_record(position(e.version)).number, 0);
  }

  // Returns the stored edge sequence of an edge; `input_edge` provides the storage for that of an input edge.
  Directed_edge_sequence directed_sequence(const Triangulation& triangulation, const Edge_version& wanted,
                                           Edge_sequence& input_edge)
  {
    const Halfedge_index h = wanted.halfedge;
    if(wanted.version == 0) {
      input_edge = input_sequence(triangulation, h);
      return {input_edge, false};
    }
    const Edge_sequence* of_flip = m_sequences.find(wanted.version);
    return {of_flip != nullptr ? *of_flip : *sequence_of_split(wanted), !is_first_side(h)};
  }

  bool is_there(const Edge_version& wanted) const
  {
    return wanted.version == 0 || m_sequences.contains(wanted.version) || is_of_split(wanted);
  }

  const Edge_sequence* sequence_of_split(const Edge_version& wanted) const
  {
    if(m_sequences_of_splits.empty())
      return nullptr;
    const auto found = m_sequences_of_splits.find(key(Triangulation::edge(wanted.halfedge), wanted.version));
    return found == m_sequences_of_splits.end() ? nullptr : &found->second;
  }

  void forget_split(std::uint64_t key)
  {
    const auto found = m_sequences_of_splits.find(key);
    if(found == m_sequences_of_splits.end())
      return;
    m_bytes_of_splits -= bytes_of_split(found->second);
    m_sequences_of_splits.erase(found);
  }

  static std::size_t bytes_of_crossed_edges(std::size_t number)
  {
    constexpr std::size_t of_allocation = 16;
    return number > 0 ? number * sizeof(Index) + of_allocation : 0;
  }

  static std::size_t bytes_of_split(const Edge_sequence& sequence)
  {
    constexpr std::size_t of_node = 48;
    return sizeof(Edge_sequence) + of_node + bytes_of_crossed_edges(sequence.crossed.size());
  }

  // Traces the edge sequence of an edge in the current triangulation and stores it. Returns false if that is
  // impossible.
  bool trace(const Triangulation& triangulation, const Edge_version& wanted)
  {
    if(has_inserted_vertices(triangulation))
      return false;
    Edge_sequence traced;
    traced.crossed = spare_crossed_edges();
    if(!trace_first_side(triangulation, first_side(edge_of(wanted.halfedge)), traced))
      return false;
    keep(wanted.version, std::move(traced));
    return true;
  }

  // Traces from either end.
  static bool trace_first_side(const Triangulation& triangulation, Halfedge_index h, Edge_sequence& traced)
  {
    if(has_inserted_vertices(triangulation))
      return false;
    Edge_sequence_tracer<Triangulation> tracer(triangulation);
    if(tracer(h, traced))
      return true;
    if(!tracer(Triangulation::twin(h), traced))
      return false;
    traced.reverse();
    return true;
  }

  // Derives the edge sequence of an edge, and depth-first those from which it descends if they are not stored.
  void derive(const Triangulation& triangulation, const Edge_version& wanted)
  {
    m_pending.assign(1, wanted);
    while(!m_pending.empty()) {
      const Edge_version next = m_pending.back();
      if(is_there(next)) {
        m_pending.pop_back();
        continue;
      }
      const Flip_record& flip = triangulation.flip_record(position(next.version));
      const Edge_version ki = {flip.hp, flip.version_hp}, il = {flip.tn, flip.version_tn};
      if(!is_there(ki) || !is_there(il)) {
        m_pending.push_back(ki);
        m_pending.push_back(il);
        continue;
      }
      keep(next.version, join(triangulation, next.version, ki, il));
      m_pending.pop_back();
    }
  }

  // Derives the edge sequence of the diagonal created by a flip. \pre the edge sequences of ki and il are stored
  Edge_sequence join(const Triangulation& triangulation, Index version, const Edge_version& ki, const Edge_version& il)
  {
    Edge_sequence input_ki, input_il;
    const Directed_edge_sequence first = directed_sequence(triangulation, ki, input_ki);
    const Directed_edge_sequence second = directed_sequence(triangulation, il, input_il);
    const Edge_sequence_end k = first.tail(), i = first.head(), l = second.head();
    const Index turn = outgoing_halfedges(triangulation, version).at_joint;
    Edge_sequence_path<Triangulation> path(triangulation, k.vertex, tail_anchor(triangulation, k),
                                           spare_crossed_edges());
    path.cross(first.sequence, first.is_reversed);
    path.turn(i.vertex, turn > 0 ? head_anchor(triangulation, i) : null_index, turn);
    path.cross(second.sequence, second.is_reversed);
    Edge_sequence kl = path.finish(l.vertex, head_anchor(triangulation, l));
    if(is_first_side(triangulation.flip_record(position(version)).h)) // the flip leaves h = l->k and its twin k->l
      kl.reverse();
    return kl;
  }

  void keep(Index version, Edge_sequence&& sequence)
  {
    if(m_sequences.contains(version))
      return recycle(std::move(sequence));
    if(sequence.crossed.capacity() > sequence.crossed.size() + sequence.crossed.size() / 4 + 16)
      sequence.crossed.shrink_to_fit();
    const std::size_t bytes = bytes_of_crossed_edges(sequence.crossed.capacity());
    m_sequences.insert(version, std::move(sequence), bytes);
  }

  std::vector<Input_halfedge_index> spare_crossed_edges()
  {
    return m_number_of_spares > 0 ? std::move(m_spares[--m_number_of_spares]) : std::vector<Input_halfedge_index>();
  }

  void recycle(Edge_sequence&& sequence)
  {
    if(m_number_of_spares < m_spares.size() && sequence.crossed.capacity() <= most_spare_crossed_edges)
      m_spares[m_number_of_spares++] = std::move(sequence.crossed);
  }

  Version_cache<Edge_sequence> m_sequences;
  std::unordered_map<std::uint64_t, Edge_sequence> m_sequences_of_splits;
  std::size_t m_bytes_of_splits = 0;
  std::vector<Edge_version> m_pending;
  std::array<std::vector<Input_halfedge_index>, 64> m_spares; // memory for crossed edges
  std::size_t m_number_of_spares = 0;
};

/*
 * The data derived for an intrinsic triangulation's edges from its flip log: edge sequences and, after filter failures,
 * double-double vectors. It also contains the input's faces in double-double and exact arithmetic.
 *
 * Vectors are derived like edge sequences: the diagonal kl created by a flip is the sum of ki and il, the latter
 * rotated at i by the input corners recorded in the log. An edge therefore takes constant time, however many edges it
 * crosses. If too many digits cancel, which requires needle-shaped faces, the edge is unfolded from the input instead.
 * Edges with an end at an inserted vertex have no error bound.
 *
 * Both are kept until they are rolled back or space runs out, in memory proportional to that of the log. Derived again,
 * they are bitwise identical.
 *
 * The const members can be called by several threads simultaneously. Only one of them derives edges at a time; another
 * one that needs an edge sequence meanwhile traces it in the triangulation if possible. The faces of the input have a
 * separate lock, since they are accessed while edges are derived.
 */
template <class Triangulation>
class Edge_history
{
  using Sequences = Edge_sequences<Triangulation>;
  using Edge_version = typename Sequences::Edge_version;
  using Outgoing_halfedges = typename Sequences::Outgoing_halfedges;
  using Flip_record = typename Triangulation::Flip_record;

public:
  /* Returns the edge sequence of halfedge h, from tail to head. */
  Edge_sequence sequence(const Triangulation& triangulation, Halfedge_index h) const
  {
    std::unique_lock<Short_lock> lock(m_lock, std::try_to_lock);
    if(!lock.owns_lock()) {
      Edge_sequence sequence;
      if(Sequences::read_off(triangulation, h, sequence))
        return sequence;
      lock.lock();
    }
    Edge_sequence found = m_sequences(triangulation, h);
    m_sequences.shrink(triangulation.log_position());
    return found;
  }

  /* See Edge_sequences::store(). */
  void store_sequence(Halfedge_index h, Index version, const Edge_sequence& sequence)
  {
    m_sequences.store(h, version, sequence);
  }

  /* Returns the edge of halfedge h, from tail to head. */
  Precise_edge edge(const Triangulation& triangulation, Halfedge_index h) const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    const Edge_version wanted = {h, triangulation.version(Triangulation::edge(h))};
    derive(triangulation, wanted);
    const Precise_edge found = known_edge(triangulation, wanted);
    m_sequences.shrink(triangulation.log_position());
    m_edges.shrink(few_bytes + bytes_per_record * triangulation.log_position(), [](Precise_edge&&) {});
    return found;
  }

  /* Returns the face on the left of input halfedge h, which is stored permanently. */
  const Exact_face& exact_face(const Triangulation& triangulation, Input_halfedge_index h) const
  {
    const std::lock_guard<Short_lock> guard(m_lock_of_input);
    return m_exact_faces(triangulation, h);
  }

  /* Returns the input halfedge h with the direction of the next one, which is stored permanently. */
  const Precise_halfedge& input_halfedge(const Triangulation& triangulation, Input_halfedge_index h) const
  {
    const std::lock_guard<Short_lock> guard(m_lock_of_input);
    const auto found = m_halfedges.find(h);
    if(found != m_halfedges.end())
      return found->second;
    const auto& input = triangulation.input();
    const auto face = input_face_geometry(triangulation, h, Precise_face_traits());
    const Input_halfedge_index hn = input.next(h), hp = input.next(hn);
    m_halfedges.emplace(hn, face[1]);
    m_halfedges.emplace(hp, face[2]);
    return m_halfedges.emplace(h, face[0]).first->second;
  }

  /* Removes an edge that a flip or split created, since that is rolled back. */
  void forget(Edge_index e, Index version)
  {
    m_sequences.forget(e, version);
    m_edges.forget(version, [](Precise_edge&&) {});
  }

  /* Returns the approximate memory in bytes. */
  std::size_t memory() const
  {
    constexpr std::size_t of_node = 32;
    const std::lock_guard<Short_lock> guard(m_lock), guard_of_input(m_lock_of_input);
    return m_sequences.memory() + m_edges.memory() + m_halfedges.size() * (sizeof(Precise_halfedge) + of_node) +
           m_exact_faces.size() * (sizeof(Exact_face) + of_node);
  }

private:
  // The memory in which vectors are kept. Along a lantern of 60 000 faces, one megabyte would derive each three times.
  static constexpr std::size_t few_bytes = 3 << 20, bytes_per_record = 12;

  // \pre it is stored
  Precise_edge known_edge(const Triangulation& triangulation, const Edge_version& wanted) const
  {
    const Halfedge_index h = wanted.halfedge;
    if(wanted.version == 0)
      return input_edge(triangulation, as_input(h));
    if(m_sequences.is_of_split(wanted)) // one end is an inserted vertex
      return {};
    const Precise_edge& stored = *m_edges.find(wanted.version);
    return is_first_side(h) ? stored : stored.reversed();
  }

  Precise_edge input_edge(const Triangulation& triangulation, Input_halfedge_index h) const
  {
    const Input_halfedge_index inside = triangulation.input().is_border(h) ? twin_index(h) : h;
    return precise_input_edge(h, input_halfedge(triangulation, inside));
  }

  bool is_known(const Edge_version& wanted) const
  {
    return wanted.version == 0 || m_edges.contains(wanted.version) || m_sequences.is_of_split(wanted);
  }

  // Depth-first, as in Edge_sequences.
  void derive(const Triangulation& triangulation, const Edge_version& wanted) const
  {
    m_pending.assign(1, wanted);
    while(!m_pending.empty()) {
      const Edge_version next = m_pending.back();
      if(is_known(next)) {
        m_pending.pop_back();
        continue;
      }
      const Edge_version of_first_side = {first_side(edge_of(next.halfedge)), next.version};
      const Outgoing_halfedges outgoing_halfedges = m_sequences.outgoing_halfedges(triangulation, next.version);
      if(!outgoing_halfedges.are_many) {
        m_edges.insert(next.version, unfolded(triangulation, of_first_side), 0);
      } else {
        const Flip_record& flip = triangulation.flip_record(static_cast<std::size_t>(next.version) - 1);
        const Edge_version ki = {flip.hp, flip.version_hp}, il = {flip.tn, flip.version_tn};
        if(!is_known(ki) || !is_known(il)) {
          m_pending.push_back(ki);
          m_pending.push_back(il);
          continue;
        }
        Precise_edge kl =
            joined(triangulation, known_edge(triangulation, ki), known_edge(triangulation, il), outgoing_halfedges);
        if(!(kl.end_error < largest_derived_error))
          kl = unfolded(triangulation, of_first_side);
        else if(is_first_side(flip.h)) // the flip leaves h = l->k
          kl = kl.reversed();
        m_edges.insert(next.version, std::move(kl), 0);
      }
      m_pending.pop_back();
    }
  }

  Precise_edge unfolded(const Triangulation& triangulation, const Edge_version& wanted) const
  {
    return unfolded_edge(triangulation, m_sequences.sequence(triangulation, wanted));
  }

  Precise_edge joined(const Triangulation& triangulation, const Precise_edge& ki, const Precise_edge& il,
                      const Outgoing_halfedges& outgoing_halfedges) const
  {
    if(!ki.has_bound() || !il.has_bound())
      return {};
    const auto& input = triangulation.input();
    Turn turn = {ki.head_direction, ki.direction_error, ki.head_reference};
    turn_clockwise(triangulation, turn, outgoing_halfedges.at_joint + ki.first_corner);
    if(turn.outgoing_halfedge != il.tail_reference)
      return {};
    const Double_double_vector end = ki.end + turn.direction * il.end;
    const double ways = ki.length * ki.end_error + il.length * (turn.error + il.end_error) +
                        2 * (ki.length + il.length) * double_double_vector_error;

    turn = {turn.direction * il.head_direction, turn.error + il.direction_error + double_double_vector_error,
            il.head_reference};
    turn_clockwise(triangulation, turn, outgoing_halfedges.at_head + il.first_corner);

    // The first face is farther counterclockwise around k than that of ki.
    Turn back = {{{1, 0}, {}}, 0, ki.tail_reference};
    for(Index i = 0; i < outgoing_halfedges.at_tail; ++i)
      back.outgoing_halfedge = twin_index(input.next(input.next(back.outgoing_halfedge)));
    const Input_halfedge_index reference = back.outgoing_halfedge;
    turn_clockwise(triangulation, back, outgoing_halfedges.at_tail);

    Precise_edge result = {
        end * back.direction, turn.direction * back.direction, 0, 0, 0, reference, turn.outgoing_halfedge, 0};
    result.length = internal::length(result.end);
    result.end_error = (ways / result.length + back.error + double_double_vector_error) * (1 + second_order_errors);
    result.direction_error = (turn.error + back.error + double_double_vector_error) * (1 + second_order_errors);
    return result;
  }

  // The direction of an outgoing input halfedge.
  struct Turn
  {
    Double_double_vector direction;
    double error;
    Input_halfedge_index outgoing_halfedge;
  };

  void turn_clockwise(const Triangulation& triangulation, Turn& turn, Index corners) const
  {
    for(Index i = 0; i < corners; ++i) {
      const Input_halfedge_index t = twin_index(turn.outgoing_halfedge);
      const Precise_halfedge& corner = input_halfedge(triangulation, t);
      turn = {-(turn.direction * corner.next), turn.error + corner.error + double_double_vector_error,
              triangulation.input().next(t)};
    }
  }

  mutable Sequences m_sequences;
  mutable Version_cache<Precise_edge> m_edges;
  mutable std::vector<Edge_version> m_pending;
  mutable Short_lock m_lock; // guards these members
  mutable std::unordered_map<Input_halfedge_index, Precise_halfedge> m_halfedges;
  mutable Exact_face_cache m_exact_faces;
  mutable Short_lock m_lock_of_input; // guards these two
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_HISTORY_H
