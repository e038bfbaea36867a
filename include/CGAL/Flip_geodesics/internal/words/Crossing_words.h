// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_WORDS_CROSSING_WORDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_WORDS_CROSSING_WORDS_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/base/Block_array.h>
#include <CGAL/Flip_geodesics/internal/base/Version_cache.h>
#include <CGAL/Flip_geodesics/internal/words/Word_path.h>
#include <CGAL/Flip_geodesics/internal/words/Word_tracer.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
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
 * that the asked ones descend from are visited: about as many as the curve had segments, not as there were flips.
 *
 * Words can be as long as there are faces. So those of flips are kept in memory proportional to the number of flips,
 * as long as they are asked for, and derived again if need be. What numbers are derived from is kept for each flip, is
 * found without words nearly always, and does not depend on which of them are there.
 */
template <class Triangulation>
class Crossing_words
{
public:
  /* An edge of the input, or one as a flip or split made it, with a direction. */
  struct Edge_version
  {
    Halfedge_index halfedge;
    Index version;
  };

  /*
   * Of the diagonal kl that a flip made: how many input edges lie between the first faces of ki and of kl about k, and
   * between those of li and of lk about l. Negative if vectors are not to be derived along with the word: where it is so
   * short that it is faster to unfold it, or the flip was wrong by rounding.
   */
  struct Spokes
  {
    Index crossings; // of the edge; negative if it has not been asked for
    std::int16_t at_tail, at_head;

    bool are_known() const { return at_tail >= 0; }
  };

  /*
   * The word of halfedge h, from tail to head.
   *
   * An edge whose ends and the points that it passes lie on one input edge has a word only if it is straight, which
   * rounded flips need not see to where points are closer to each other than numbers can tell. Then the number of
   * crossings, which flips keep right whatever they do, is another one.
   */
  Crossing_word operator()(const Triangulation& triangulation, Halfedge_index h)
  {
    const Edge_version asked = {h, triangulation.version(Triangulation::edge(h))};
    if(asked.version == 0)
      return input_word(triangulation, h);
    if(!is_there(asked) && !trace(triangulation, asked))
      resolve(triangulation, asked);
    Crossing_word found = word(triangulation, asked);
    if(found.crossed.size() != static_cast<std::size_t>(number_of_crossings(triangulation, h)))
      fail(triangulation, found);
    return found;
  }

  /* Keeps the word of the edge of h, from the tail of h to its head, that a split of log position `version - 1` made.
   */
  void store(Halfedge_index h, Index version, const Crossing_word& word)
  {
    m_words_of_splits.emplace(key(Triangulation::edge(h), version), is_first_side(h) ? word : word.reversed());
    m_bytes_of_splits += bytes_of_split(word);
  }

  /* Finds out the spokes of an edge, and of those that it descends from, if they are not known yet. Depth first, not by
   * recursion: histories are as deep as curves are long. */
  void resolve(const Triangulation& triangulation, const Edge_version& wanted)
  {
    m_unresolved.assign(1, wanted);
    while(!m_unresolved.empty()) {
      const Edge_version next = m_unresolved.back();
      if(is_resolved(next)) {
        m_unresolved.pop_back();
        continue;
      }
      const Flip_record& flip = triangulation.flip_record(position(next.version));
      const Edge_version ki = {flip.hp, flip.version_hp}, il = {flip.tn, flip.version_tn};
      if(!is_resolved(ki) || !is_resolved(il)) {
        m_unresolved.push_back(ki);
        m_unresolved.push_back(il);
        continue;
      }
      set_spokes(next.version, flip.rotation > 0 && !has_inserted_vertices(triangulation)
                                   ? spokes_of_turn(crossings(ki) + flip.rotation + crossings(il))
                                   : spokes_of_words(triangulation, flip, ki, il));
      m_unresolved.pop_back();
    }
  }

  /* The word of an edge as a flip or split made it; from the log if it is not there. */
  Crossing_word word(const Triangulation& triangulation, const Edge_version& wanted)
  {
    derive(triangulation, wanted);
    Crossing_word input_edge;
    const Directed_word found = directed_word(triangulation, wanted, input_edge);
    return found.is_reversed ? found.word.reversed() : found.word;
  }

  /* \pre a flip made the edge, and it has been resolved */
  const Spokes& spokes(Index version) const { return m_spokes[position(version)]; }

  /* Was it a split that made the edge? */
  bool is_of_split(const Edge_version& wanted) const { return word_of_split(wanted) != nullptr; }

  /* Drops words that have not been asked for long. To be called when none is being used. */
  void shrink(std::size_t number_of_records)
  {
    m_words.shrink(few_bytes + bytes_per_record * number_of_records,
                   [this](Crossing_word&& word) { recycle(std::move(word)); });
  }

  /* In bytes. */
  std::size_t memory() const { return m_words.memory() + m_spokes.memory() + m_bytes_of_splits; }

  /* Forgets the word of an edge that a flip or split made, since that is taken back. \pre so is all that came later */
  void forget(Edge_index e, Index version)
  {
    m_words.forget(version, [this](Crossing_word&& word) { recycle(std::move(word)); });
    if(m_spokes.size() > position(version))
      m_spokes.pop_back();
    if(!m_words_of_splits.empty())
      forget_split(key(e, version));
  }

private:
  using Flip_record = typename Triangulation::Flip_record;

  // Words are kept in so much memory.
  static constexpr std::size_t few_bytes = 1 << 20, bytes_per_record = 4;
  static constexpr std::size_t most_spare_letters = 1 << 10;
  // How many crossings are unfolded faster than vectors are derived.
  static constexpr Index few_crossings = 4;

  [[noreturn]] static void fail(const Triangulation& triangulation, const Crossing_word& word)
  {
    const Vertex_index v = triangulation.is_inserted(word.tail) ? word.tail : word.head;
    const Input_halfedge_index h = triangulation.location(v).halfedge;
    throw Insertion_error("points at vertex " + std::to_string(v.idx()) + ", in the face of halfedge " +
                              std::to_string(h.idx()) +
                              ", are closer together than numbers can tell: the flips around them were wrong",
                          {static_cast<std::size_t>(h.idx())});
  }

  // A word, and whether it is that of the other direction.
  struct Directed_word
  {
    const Crossing_word& word;
    bool is_reversed;

    Word_end tail() const { return is_reversed ? head_end(word) : tail_end(word); }
    Word_end head() const { return is_reversed ? tail_end(word) : head_end(word); }
  };

  static std::size_t position(Index version) { return static_cast<std::size_t>(version) - 1; }

  // Tells edges and the split that made them.
  static std::uint64_t key(Edge_index e, Index version)
  {
    return static_cast<std::uint64_t>(version) << 32 | static_cast<std::uint32_t>(e.idx());
  }

  static Crossing_word input_word(const Triangulation& triangulation, Halfedge_index h)
  {
    const Input_halfedge_index along = as_input(h);
    return {along, {}, null_index, triangulation.input().tail(along), triangulation.input().tail(twin_index(along))};
  }

  static bool has_inserted_vertices(const Triangulation& triangulation)
  {
    return triangulation.number_of_vertices() != triangulation.input().number_of_vertices();
  }

  static Index number_of_crossings(const Triangulation& triangulation, Halfedge_index h)
  {
    return (std::max)(triangulation.crossings(Triangulation::edge(h)), 0);
  }

  // \pre an edge of the input, or one that a flip made and that is resolved
  Index crossings(const Edge_version& e) const { return e.version == 0 ? 0 : spokes(e.version).crossings; }

  /*
   * The turn about i from ki to il crosses input edges. They end at i, where ki and il cross none; so nothing cancels,
   * and kl leaves k in the face of ki, and l in that of li.
   */
  static Spokes spokes_of_turn(Index crossings)
  {
    const std::int16_t at_ends = crossings > few_crossings ? 0 : -1;
    return {crossings, at_ends, at_ends};
  }

  // The word of an edge that is there; `input_edge` holds that of one of the input.
  Directed_word directed_word(const Triangulation& triangulation, const Edge_version& wanted, Crossing_word& input_edge)
  {
    const Halfedge_index h = wanted.halfedge;
    if(wanted.version == 0) {
      input_edge = input_word(triangulation, h);
      return {input_edge, false};
    }
    const Crossing_word* of_flip = m_words.find(wanted.version);
    return {of_flip != nullptr ? *of_flip : *word_of_split(wanted), !is_first_side(h)};
  }

  bool is_there(const Edge_version& wanted) const
  {
    return wanted.version == 0 || m_words.contains(wanted.version) || is_of_split(wanted);
  }

  // Has it been asked for, or an edge that descends from it?
  bool is_resolved(const Edge_version& wanted) const
  {
    if(wanted.version == 0 || is_of_split(wanted))
      return true;
    return position(wanted.version) < m_spokes.size() && spokes(wanted.version).crossings >= 0;
  }

  void set_spokes(Index version, const Spokes& spokes)
  {
    if(m_spokes.size() <= position(version))
      m_spokes.resize(position(version) + 1, {-1, -1, -1});
    m_spokes[position(version)] = spokes;
  }

  const Crossing_word* word_of_split(const Edge_version& wanted) const
  {
    if(m_words_of_splits.empty())
      return nullptr;
    const auto found = m_words_of_splits.find(key(Triangulation::edge(wanted.halfedge), wanted.version));
    return found == m_words_of_splits.end() ? nullptr : &found->second;
  }

  void forget_split(std::uint64_t key)
  {
    const auto found = m_words_of_splits.find(key);
    if(found == m_words_of_splits.end())
      return;
    m_bytes_of_splits -= bytes_of_split(found->second);
    m_words_of_splits.erase(found);
  }

  static std::size_t bytes_of_letters(std::size_t number)
  {
    constexpr std::size_t of_allocation = 16;
    return number > 0 ? number * sizeof(Index) + of_allocation : 0;
  }

  static std::size_t bytes_of_split(const Crossing_word& word)
  {
    constexpr std::size_t of_node = 48;
    return sizeof(Crossing_word) + of_node + bytes_of_letters(word.crossed.size());
  }

  // Reads the word of an edge as it is now off the triangulation, from one end or the other. Returns false if it
  // cannot.
  bool trace(const Triangulation& triangulation, const Edge_version& wanted)
  {
    if(has_inserted_vertices(triangulation))
      return false;
    const Halfedge_index h = first_side(edge_of(wanted.halfedge));
    Crossing_word traced;
    traced.crossed = spare_letters();
    Word_tracer<Triangulation> tracer(triangulation);
    if(!tracer(h, traced)) {
      if(!tracer(Triangulation::twin(h), traced))
        return false;
      traced.reverse();
    }
    keep(wanted.version, std::move(traced));
    return true;
  }

  // Derives the word of an edge, and those that it descends from as far as they are not there. Depth first.
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
      keep(next.version, join(triangulation, flip, ki, il).word);
      m_pending.pop_back();
    }
  }

  struct Joined_word
  {
    Crossing_word word; // of the edge's first halfedge
    Spokes spokes;
  };

  // The diagonal that a flip made. \pre the words of ki and il are there
  Joined_word join(const Triangulation& triangulation, const Flip_record& flip, const Edge_version& ki,
                   const Edge_version& il)
  {
    Crossing_word input_ki, input_il;
    const Directed_word first = directed_word(triangulation, ki, input_ki);
    const Directed_word second = directed_word(triangulation, il, input_il);
    const Word_end k = first.tail(), i = first.head(), l = second.head();
    Word_path<Triangulation> path(triangulation, k.vertex, tail_anchor(triangulation, k), spare_letters());
    path.cross(first.word, first.is_reversed);
    path.turn(i.vertex, flip.rotation > 0 ? head_anchor(triangulation, i) : null_index, flip.rotation);
    path.cross(second.word, second.is_reversed);
    Joined_word kl = {path.finish(l.vertex, head_anchor(triangulation, l)), {}};
    if(is_first_side(flip.h)) // it leaves h = l->k and its twin k->l
      kl.word.reverse();
    kl.spokes = {static_cast<Index>(kl.word.crossed.size()), -1, -1};
    constexpr Index most = (std::numeric_limits<std::int16_t>::max)();
    if(path.is_left_turn() && kl.spokes.crossings > few_crossings && path.spokes_at_start() <= most &&
       path.spokes_at_end() <= most)
    {
      kl.spokes.at_tail = static_cast<std::int16_t>(path.spokes_at_start());
      kl.spokes.at_head = static_cast<std::int16_t>(path.spokes_at_end());
    }
    return kl;
  }

  Spokes spokes_of_words(const Triangulation& triangulation, const Flip_record& flip, const Edge_version& ki,
                         const Edge_version& il)
  {
    derive(triangulation, ki);
    derive(triangulation, il);
    Joined_word kl = join(triangulation, flip, ki, il);
    recycle(std::move(kl.word));
    return kl.spokes;
  }

  void keep(Index version, Crossing_word&& word)
  {
    if(m_words.contains(version))
      return recycle(std::move(word));
    if(word.crossed.capacity() > word.crossed.size() + word.crossed.size() / 4 + 16)
      word.crossed.shrink_to_fit();
    const std::size_t bytes = bytes_of_letters(word.crossed.capacity());
    m_words.insert(version, std::move(word), bytes);
  }

  std::vector<Input_halfedge_index> spare_letters()
  {
    return m_number_of_spares > 0 ? std::move(m_spares[--m_number_of_spares]) : std::vector<Input_halfedge_index>();
  }

  void recycle(Crossing_word&& word)
  {
    if(m_number_of_spares < m_spares.size() && word.crossed.capacity() <= most_spare_letters)
      m_spares[m_number_of_spares++] = std::move(word.crossed);
  }

  Version_cache<Crossing_word> m_words;
  Block_array<Spokes> m_spokes;
  std::unordered_map<std::uint64_t, Crossing_word> m_words_of_splits;
  std::size_t m_bytes_of_splits = 0;
  std::vector<Edge_version> m_unresolved, m_pending;
  std::array<std::vector<Input_halfedge_index>, 64> m_spares; // memory for letters
  std::size_t m_number_of_spares = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_WORDS_CROSSING_WORDS_H
