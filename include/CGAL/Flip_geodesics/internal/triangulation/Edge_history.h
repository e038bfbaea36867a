// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_HISTORY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_HISTORY_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>
#include <CGAL/Flip_geodesics/internal/surface/shared_memory.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Crossing_words.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Version_cache.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_input_faces.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Precise_face.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Precise_strip.h>

#include <cstddef>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * What is derived of an intrinsic triangulation's edges from its flip log: crossing words; and, for the decisions that
 * doubles leave open, vectors of about 100 bits. Also the input's faces in the numbers of these and of exact decisions.
 *
 * Vectors are derived as the words are: the diagonal kl that a flip made is ki, turned on at i by the input corners
 * that the log tells, and il. So an edge takes constant time, however many edges it crosses. Where too many digits
 * cancel, which takes needles, the edge is unfolded from the input instead. Edges with an end at an inserted vertex
 * have no bound.
 *
 * Both are kept until they are taken back, or for as long as there is room: in memory proportional to the log's.
 * Derived again, they are the same bit for bit.
 *
 * Members that are const can be called by several threads at once. One of them derives edges at a time; another one that
 * wants a word meanwhile reads it off the triangulation if that is possible. The faces of the input have a lock of their
 * own, since they are looked up while edges are derived.
 */
template <class Triangulation>
class Edge_history
{
  using Words = Crossing_words<Triangulation>;
  using Edge_version = typename Words::Edge_version;
  using Spokes = typename Words::Spokes;
  using Flip_record = typename Triangulation::Flip_record;

public:
  /* The word of halfedge h, from tail to head. */
  Crossing_word word(const Triangulation& triangulation, Halfedge_index h) const
  {
    std::unique_lock<Short_lock> lock(m_lock, std::try_to_lock);
    if(!lock.owns_lock()) {
      Crossing_word word;
      if(Words::read_off(triangulation, h, word))
        return word;
      lock.lock();
    }
    Crossing_word found = m_words(triangulation, h);
    m_words.shrink(triangulation.log_position());
    return found;
  }

  /* As Crossing_words::store(). */
  void store_word(Halfedge_index h, Index version, const Crossing_word& word) { m_words.store(h, version, word); }

  /* The edge of halfedge h, from its tail to its head. */
  Precise_edge edge(const Triangulation& triangulation, Halfedge_index h) const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    const Edge_version wanted = {h, triangulation.version(Triangulation::edge(h))};
    derive(triangulation, wanted);
    const Precise_edge found = known_edge(triangulation, wanted);
    m_words.shrink(triangulation.log_position());
    m_edges.shrink(few_bytes + bytes_per_record * triangulation.log_position(), [](Precise_edge&&) {});
    return found;
  }

  /* The face on the left of input halfedge h, which is kept for good. */
  const Exact_face& exact_face(const Triangulation& triangulation, Input_halfedge_index h) const
  {
    const std::lock_guard<Short_lock> guard(m_lock_of_input);
    return m_exact_faces(triangulation, h);
  }

  /* The input halfedge h, with the direction of the next one, which is kept for good. */
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

  /* Forgets the edge that a flip or split made, since that is taken back. */
  void forget(Edge_index e, Index version)
  {
    m_words.forget(e, version);
    m_edges.forget(version, [](Precise_edge&&) {});
  }

  /* About how many bytes it takes. */
  std::size_t memory() const
  {
    constexpr std::size_t of_node = 32;
    const std::lock_guard<Short_lock> guard(m_lock), guard_of_input(m_lock_of_input);
    return m_words.memory() + m_edges.memory() + m_halfedges.size() * (sizeof(Precise_halfedge) + of_node) +
           m_exact_faces.size() * (sizeof(Exact_face) + of_node);
  }

private:
  // Vectors are kept in so much memory. Along a lantern of 60 000 faces, in a megabyte each is derived three times.
  static constexpr std::size_t few_bytes = 3 << 20, bytes_per_record = 12;

  // \pre it is known
  Precise_edge known_edge(const Triangulation& triangulation, const Edge_version& wanted) const
  {
    const Halfedge_index h = wanted.halfedge;
    if(wanted.version == 0)
      return input_edge(triangulation, as_input(h));
    if(m_words.is_of_split(wanted)) // one end is an inserted vertex
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
    return wanted.version == 0 || m_edges.contains(wanted.version) || m_words.is_of_split(wanted);
  }

  // Depth first, as in Crossing_words.
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
      const Spokes spokes = m_words.spokes(triangulation, next.version);
      if(!spokes.are_many) {
        m_edges.insert(next.version, unfolded(triangulation, of_first_side), 0);
      } else {
        const Flip_record& flip = triangulation.flip_record(static_cast<std::size_t>(next.version) - 1);
        const Edge_version ki = {flip.hp, flip.version_hp}, il = {flip.tn, flip.version_tn};
        if(!is_known(ki) || !is_known(il)) {
          m_pending.push_back(ki);
          m_pending.push_back(il);
          continue;
        }
        Precise_edge kl = joined(triangulation, known_edge(triangulation, ki), known_edge(triangulation, il), spokes);
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
    return unfolded_edge(triangulation, m_words.word(triangulation, wanted));
  }

  Precise_edge joined(const Triangulation& triangulation, const Precise_edge& ki, const Precise_edge& il,
                      const Spokes& spokes) const
  {
    if(!ki.has_bound() || !il.has_bound())
      return {};
    const auto& input = triangulation.input();
    Turn turn = {ki.head_direction, ki.direction_error, ki.head_reference};
    turn_clockwise(triangulation, turn, spokes.at_joint + ki.first_corner);
    if(turn.spoke != il.tail_reference)
      return {};
    const Double_double_vector end = ki.end + turn.direction * il.end;
    const double ways = ki.length * ki.end_error + il.length * (turn.error + il.end_error) +
                        2 * (ki.length + il.length) * double_double_vector_error;

    turn = {turn.direction * il.head_direction, turn.error + il.direction_error + double_double_vector_error,
            il.head_reference};
    turn_clockwise(triangulation, turn, spokes.at_head + il.first_corner);

    // The first face is farther counterclockwise about k than that of ki.
    Turn back = {{{1, 0}, {}}, 0, ki.tail_reference};
    for(Index i = 0; i < spokes.at_tail; ++i)
      back.spoke = twin_index(input.next(input.next(back.spoke)));
    const Input_halfedge_index reference = back.spoke;
    turn_clockwise(triangulation, back, spokes.at_tail);

    Precise_edge result = {end * back.direction, turn.direction * back.direction, 0, 0, 0, reference, turn.spoke, 0};
    result.length = internal::length(result.end);
    result.end_error = (ways / result.length + back.error + double_double_vector_error) * (1 + second_order_errors);
    result.direction_error = (turn.error + back.error + double_double_vector_error) * (1 + second_order_errors);
    return result;
  }

  // The direction of a spoke, an input halfedge.
  struct Turn
  {
    Double_double_vector direction;
    double error;
    Input_halfedge_index spoke;
  };

  void turn_clockwise(const Triangulation& triangulation, Turn& turn, Index corners) const
  {
    for(Index i = 0; i < corners; ++i) {
      const Input_halfedge_index t = twin_index(turn.spoke);
      const Precise_halfedge& corner = input_halfedge(triangulation, t);
      turn = {-(turn.direction * corner.next), turn.error + corner.error + double_double_vector_error,
              triangulation.input().next(t)};
    }
  }

  mutable Words m_words;
  mutable Version_cache<Precise_edge> m_edges;
  mutable std::vector<Edge_version> m_pending;
  mutable Short_lock m_lock; // of these
  mutable std::unordered_map<Input_halfedge_index, Precise_halfedge> m_halfedges;
  mutable Exact_face_cache m_exact_faces;
  mutable Short_lock m_lock_of_input; // of these two
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_HISTORY_H
