// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_CROSSING_WORDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_CROSSING_WORDS_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/Word_path.h>
#include <CGAL/Flip_geodesics/internal/Word_tracer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The crossing words of an intrinsic triangulation's edges, by combinatorics alone, so that they are exact whatever the
 * numbers do. Those of the edges that are there now are read off the triangulation; where that cannot be, and for edges
 * that flips have replaced, they are derived from the flip log.
 *
 * The diagonal kl that a flip made is the path k, i, l pulled off i through the flipped edge ij. So its word is the
 * free reduction of the word of ki, the input edges that the turn about i crosses, and the word of il, less what
 * touches k or l at the ends. The words of edges at an inserted point are given when it is inserted. Only the edges
 * that the asked ones descend from are visited, and each once: about as many as the curve had segments, not as there
 * were flips. Words are kept until the flip or split that made their edge is taken back; those of flips in slots that
 * the positions in the log name, and whose memory is reused.
 */
template <class Triangulation>
class Crossing_words
{
public:
  /* An edge of the input, or one as a flip or split made it, with a direction. */
  struct Edge_version
  {
    Index halfedge, version;
  };

  /* The word of an edge's first halfedge; and of the diagonal kl that a flip made, how many input edges lie between the
   * first faces of ki and of kl about k, and between those of li and of lk about l; -1 if these are not known, as of a
   * word that was not derived. */
  struct Derived_word
  {
    Crossing_word word;
    Index spokes_at_tail, spokes_at_head;
  };

  /*
   * The word of halfedge h, from tail to head.
   *
   * An edge whose ends and the points that it passes lie on one input edge has a word only if it is straight, which
   * rounded flips need not see to where points are closer to each other than numbers can tell. Then the number of
   * crossings, which flips keep right whatever they do, is another one.
   */
  Crossing_word operator()(const Triangulation& triangulation, Index h)
  {
    const Edge_version wanted = {h, triangulation.version(Triangulation::edge(h))};
    if(wanted.version == 0)
      return input_word(triangulation, h);
    if(is_known(wanted) || !trace(triangulation, wanted))
      resolve(triangulation, wanted);
    const Crossing_word& stored = derived(Triangulation::edge(h), wanted.version).word;
    const Index number = (std::max)(triangulation.crossings(Triangulation::edge(h)), 0);
    if(stored.crossed.size() != static_cast<std::size_t>(number))
      fail(triangulation, stored);
    return (h & 1) == 0 ? stored : stored.reversed();
  }

  /* Keeps the word of the edge of h, from the tail of h to its head, that a split of log position `version - 1` made.
   */
  void store(Index h, Index version, const Crossing_word& word)
  {
    m_words_of_splits.emplace(key(Triangulation::edge(h), version),
                              Derived_word{(h & 1) == 0 ? word : word.reversed(), -1, -1});
  }

  /* Derives a word, and those that it descends from, if they are not known yet. */
  void resolve(const Triangulation& triangulation, const Edge_version& wanted)
  {
    if(is_known(wanted))
      return;
    m_slots.resize(triangulation.log_position(), no_slot);
    m_pending.assign(1, wanted);
    while(!m_pending.empty()) {
      const Edge_version next = m_pending.back();
      if(is_known(next)) {
        m_pending.pop_back();
        continue;
      }
      const Flip_record& flip = triangulation.flip_record(static_cast<std::size_t>(next.version) - 1);
      const Edge_version ki = {flip.hp, flip.version_hp}, il = {flip.tn, flip.version_tn};
      if(!is_known(ki) || !is_known(il)) {
        m_pending.push_back(ki);
        m_pending.push_back(il);
        continue;
      }
      m_slots[static_cast<std::size_t>(next.version) - 1] = derive(triangulation, flip, ki, il);
      m_pending.pop_back();
    }
  }

  /* What is known of an edge. \pre a flip or split made it, and it has been resolved */
  const Derived_word& derived(Index e, Index version) const { return *find(e, version); }

  /* Tells edges and what made them. */
  static std::uint64_t key(Index e, Index version)
  {
    return static_cast<std::uint64_t>(version) << 32 | static_cast<std::uint32_t>(e);
  }

  /* Forgets the word of an edge that a flip or split made, since that is taken back. \pre so is all that came later */
  void forget(Index e, Index version)
  {
    if(m_slots.size() >= static_cast<std::size_t>(version)) {
      if(m_slots.back() != no_slot)
        m_free_slots.push_back(m_slots.back());
      m_slots.pop_back();
    }
    if(!m_words_of_splits.empty())
      m_words_of_splits.erase(key(e, version));
  }

private:
  using Flip_record = typename Triangulation::Flip_record;

  static constexpr Index no_slot = null_index;

  [[noreturn]] static void fail(const Triangulation& triangulation, const Crossing_word& word)
  {
    const Index v = triangulation.is_inserted(word.tail) ? word.tail : word.head;
    const Index h = triangulation.location(v).halfedge;
    throw Insertion_error("points at vertex " + std::to_string(v) + ", in the face of halfedge " + std::to_string(h) +
                              ", are closer together than numbers can tell: the flips around them were wrong",
                          {static_cast<std::size_t>(h)});
  }

  // A word, and whether it is that of the other direction.
  struct Directed_word
  {
    const Crossing_word& word;
    bool is_reversed;

    Word_end tail() const { return is_reversed ? head_end(word) : tail_end(word); }
    Word_end head() const { return is_reversed ? tail_end(word) : head_end(word); }
  };

  static Crossing_word input_word(const Triangulation& triangulation, Index h)
  {
    return {h, {}, null_index, triangulation.input().tail(h), triangulation.input().tail(Triangulation::twin(h))};
  }

  // The word of an edge in the version that a flip or split gave it; `input_edge` holds that of one of the input.
  Directed_word word(const Triangulation& triangulation, const Edge_version& wanted, Crossing_word& input_edge) const
  {
    const Index h = wanted.halfedge;
    if(wanted.version != 0)
      return {derived(Triangulation::edge(h), wanted.version).word, (h & 1) != 0};
    input_edge = input_word(triangulation, h);
    return {input_edge, false};
  }

  bool is_known(const Edge_version& wanted) const
  {
    return wanted.version == 0 || find(Triangulation::edge(wanted.halfedge), wanted.version) != nullptr;
  }

  // What is known of an edge in the version that a flip or split gave it; null if nothing is.
  const Derived_word* find(Index e, Index version) const
  {
    const std::size_t position = static_cast<std::size_t>(version) - 1;
    if(position < m_slots.size() && m_slots[position] != no_slot)
      return &m_words_of_flips[static_cast<std::size_t>(m_slots[position])];
    if(m_words_of_splits.empty())
      return nullptr;
    const auto found = m_words_of_splits.find(key(e, version));
    return found == m_words_of_splits.end() ? nullptr : &found->second;
  }

  // Reads the word of an edge as it is now off the triangulation, from one end or the other. Returns false if it
  // cannot.
  bool trace(const Triangulation& triangulation, const Edge_version& wanted)
  {
    if(triangulation.number_of_vertices() != triangulation.input().number_of_vertices())
      return false;
    m_slots.resize(triangulation.log_position(), no_slot);
    const Index h = wanted.halfedge & ~1, slot = free_slot();
    Derived_word& traced = m_words_of_flips[static_cast<std::size_t>(slot)];
    traced.spokes_at_tail = traced.spokes_at_head = -1;
    Word_tracer<Triangulation> tracer(triangulation);
    if(!tracer(h, traced.word)) {
      if(!tracer(Triangulation::twin(h), traced.word)) {
        m_free_slots.push_back(slot);
        return false;
      }
      traced.word.reverse();
    }
    m_slots[static_cast<std::size_t>(wanted.version) - 1] = slot;
    return true;
  }

  // Derives the word of the diagonal that a flip made; returns its slot.
  Index derive(const Triangulation& triangulation, const Flip_record& flip, const Edge_version& ki,
               const Edge_version& il)
  {
    const Index slot = free_slot();
    Derived_word& kl = m_words_of_flips[static_cast<std::size_t>(slot)];
    kl = join(triangulation, ki, flip.rotation, il, std::move(kl.word.crossed));
    if((flip.h & 1) == 0) // it leaves h = l->k and its twin k->l
      kl.word.reverse();
    return slot;
  }

  Index free_slot()
  {
    if(m_free_slots.empty()) {
      m_words_of_flips.emplace_back();
      return static_cast<Index>(m_words_of_flips.size()) - 1;
    }
    const Index slot = m_free_slots.back();
    m_free_slots.pop_back();
    return slot;
  }

  Derived_word join(const Triangulation& triangulation, const Edge_version& ki, Index rotation, const Edge_version& il,
                    std::vector<Index> memory) const
  {
    Crossing_word input_ki, input_il;
    const Directed_word first = word(triangulation, ki, input_ki), second = word(triangulation, il, input_il);
    const Word_end k = first.tail(), i = first.head(), l = second.head();
    Word_path<Triangulation> path(triangulation, k.vertex, tail_anchor(triangulation, k), std::move(memory));
    path.cross(first.word, first.is_reversed);
    path.turn(i.vertex, rotation > 0 ? head_anchor(triangulation, i) : null_index, rotation);
    path.cross(second.word, second.is_reversed);
    Crossing_word joined = path.finish(l.vertex, head_anchor(triangulation, l));
    if(!path.is_left_turn()) // the flip was wrong, by rounding
      return {std::move(joined), -1, -1};
    return {std::move(joined), path.spokes_at_start(), path.spokes_at_end()};
  }

  std::vector<Index> m_slots;                // by position in the log: where the word of the flip's edge is
  std::deque<Derived_word> m_words_of_flips; // references to them last
  std::vector<Index> m_free_slots;
  std::unordered_map<std::uint64_t, Derived_word> m_words_of_splits;
  std::vector<Edge_version> m_pending; // depth first, not by recursion: histories are as deep as curves are long
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_CROSSING_WORDS_H
