// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_CROSSING_WORDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_CROSSING_WORDS_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/Word_path.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The crossing words of an intrinsic triangulation's edges, derived from its flip log by combinatorics alone, so that
 * they are exact whatever the numbers do.
 *
 * The diagonal kl that a flip made is the path k, i, l pulled off i through the flipped edge ij. So its word is the
 * free reduction of the word of ki, the input edges that the turn about i crosses, and the word of il, less what
 * touches k or l at the ends. The words of edges at an inserted point are given when it is inserted. Only the edges that
 * the asked ones descend from are visited, and each once: about as many as the curve had segments, not as there were
 * flips. Words are kept until the flip or split that made their edge is taken back.
 */
template <class Triangulation>
class Crossing_words
{
public:
  /* The word of halfedge h, from tail to head. */
  Crossing_word operator()(const Triangulation& triangulation, Index h)
  {
    const Edge_version wanted = {h, triangulation.version(Triangulation::edge(h))};
    resolve(triangulation, wanted);
    return word(triangulation, wanted);
  }

  /* Keeps the word of the edge of h, from the tail of h to its head, that a split of log position `version - 1` made. */
  void store(Index h, Index version, const Crossing_word& word)
  {
    m_words.emplace(key(Triangulation::edge(h), version), (h & 1) == 0 ? word : word.reversed());
  }

  /* Forgets the word of an edge that a flip or split made, since that is taken back. */
  void forget(Index e, Index version)
  {
    if(!m_words.empty())
      m_words.erase(key(e, version));
  }

private:
  using Flip_record = typename Triangulation::Flip_record;

  struct Edge_version
  {
    Index halfedge, version;
  };

  // The word of halfedge h of an edge in the version that a flip or split gave it, or in the input's.
  Crossing_word word(const Triangulation& triangulation, const Edge_version& wanted) const
  {
    const Index h = wanted.halfedge;
    if(wanted.version == 0)
      return {h, {}, null_index, triangulation.input().tail(h), triangulation.input().tail(Triangulation::twin(h))};
    const Crossing_word& stored = m_words.at(key(Triangulation::edge(h), wanted.version));
    return (h & 1) == 0 ? stored : stored.reversed();
  }

  // Depth first over the flips that made the edges, on a stack of our own: histories are as deep as curves are long.
  void resolve(const Triangulation& triangulation, const Edge_version& wanted)
  {
    std::vector<Edge_version> pending = {wanted};
    while(!pending.empty()) {
      const Edge_version next = pending.back();
      if(is_known(next)) {
        pending.pop_back();
        continue;
      }
      const Flip_record& flip = triangulation.flip_record(static_cast<std::size_t>(next.version) - 1);
      const Edge_version ki = {flip.hp, flip.version_hp}, il = {flip.tn, flip.version_tn};
      if(!is_known(ki) || !is_known(il)) {
        pending.push_back(ki);
        pending.push_back(il);
        continue;
      }
      // The flip leaves h = l->k and its twin k->l.
      store(Triangulation::twin(flip.h), next.version,
            join(triangulation, word(triangulation, ki), flip.rotation, word(triangulation, il)));
      pending.pop_back();
    }
  }

  bool is_known(const Edge_version& wanted) const
  {
    return wanted.version == 0 || m_words.count(key(Triangulation::edge(wanted.halfedge), wanted.version)) != 0;
  }

  static Crossing_word join(const Triangulation& triangulation, const Crossing_word& ki, Index rotation,
                            const Crossing_word& il)
  {
    Word_path<Triangulation> path(triangulation, ki.tail, tail_anchor(triangulation, ki));
    path.cross(ki.crossed, 0, ki.crossed.size());
    path.turn(ki.head, rotation > 0 ? head_anchor(triangulation, ki) : null_index, rotation);
    path.cross(il.crossed, 0, il.crossed.size());
    return path.finish(il.head, head_anchor(triangulation, il));
  }

  // An edge of the input, or one and the flip or split that made it.
  static std::uint64_t key(Index e, Index version)
  {
    return static_cast<std::uint64_t>(version) << 32 | static_cast<std::uint32_t>(e);
  }

  std::unordered_map<std::uint64_t, Crossing_word> m_words;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_CROSSING_WORDS_H
