// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_CROSSING_WORDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_CROSSING_WORDS_H

#include <CGAL/Flip_geodesics/Crossing_word.h>

#include <algorithm>
#include <cstddef>
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
 * touches k or l at the ends. Only the edges that the asked ones descend from are visited, and each once: about as many
 * as the curve had segments, not as there were flips. Words are kept until the flip that made their edge is taken back.
 */
template <class Triangulation>
class Crossing_words
{
public:
  /* The word of halfedge h, from tail to head. */
  Crossing_word operator()(const Triangulation& triangulation, Index h)
  {
    const Index version = triangulation.version(Triangulation::edge(h));
    resolve(triangulation, version);
    return word(h, version);
  }

  /* Forgets the word of the edge that a flip made, since the flip is taken back. */
  void forget(Index version)
  {
    if(!m_words.empty())
      m_words.erase(version);
  }

private:
  using Input_mesh = typename Triangulation::Input_mesh;
  using Flip_record = typename Triangulation::Flip_record;

  // The word of halfedge h of an edge in the version that a flip gave it, or in the input's.
  Crossing_word word(Index h, Index version) const
  {
    if(version == 0)
      return {h, {}};
    const Crossing_word& stored = m_words.at(version);
    return (h & 1) == 0 ? stored : stored.reversed();
  }

  // Depth first over the flips that made the edges, on a stack of our own: histories are as deep as curves are long.
  void resolve(const Triangulation& triangulation, Index wanted)
  {
    std::vector<Index> pending = {wanted};
    while(!pending.empty()) {
      const Index version = pending.back();
      if(is_known(version)) {
        pending.pop_back();
        continue;
      }
      const Flip_record& flip = triangulation.flip_record(static_cast<std::size_t>(version) - 1);
      const bool are_known = is_known(flip.version_hp) && is_known(flip.version_tn);
      if(!are_known) {
        pending.push_back(flip.version_hp);
        pending.push_back(flip.version_tn);
        continue;
      }
      // The flip leaves h = l->k and its twin k->l.
      Crossing_word word_of_kl =
          join(triangulation.input(), word(flip.hp, flip.version_hp), flip.rotation, word(flip.tn, flip.version_tn));
      m_words.emplace(version, (flip.h & 1) == 1 ? std::move(word_of_kl) : word_of_kl.reversed());
      pending.pop_back();
    }
  }

  bool is_known(Index version) const { return version == 0 || m_words.count(version) != 0; }

  static Crossing_word join(const Input_mesh& input, const Crossing_word& ki, Index rotation, const Crossing_word& il)
  {
    Crossing_word kl;
    kl.crossed = ki.crossed;
    Index spoke = first_spoke(input, ki);
    for(Index i = 0; i < rotation; ++i) {
      append_reduced(kl.crossed, spoke);
      spoke = input.next(Triangulation::twin(spoke));
    }
    for(Index letter : il.crossed)
      append_reduced(kl.crossed, letter);
    trim(input, kl, first_corner(input, ki), last_corner(input, il));
    return kl;
  }

  static void append_reduced(std::vector<Index>& crossed, Index letter)
  {
    if(!crossed.empty() && crossed.back() == Triangulation::twin(letter))
      crossed.pop_back();
    else
      crossed.push_back(letter);
  }

  static Index previous(const Input_mesh& input, Index h) { return input.next(input.next(h)); }

  // The first input halfedge at i that a clockwise turn from ik meets, strictly.
  static Index first_spoke(const Input_mesh& input, const Crossing_word& ki)
  {
    return ki.along != null_index ? input.next(ki.along) : previous(input, Triangulation::twin(ki.crossed.back()));
  }

  // The path leaves k in an input face; the halfedge of that face that starts at k. It keeps j, hence the face, on its
  // left if ki runs along an edge.
  static Index first_corner(const Input_mesh& input, const Crossing_word& ki)
  {
    return ki.along != null_index ? ki.along : previous(input, ki.crossed.front());
  }

  // The path reaches l in an input face, the halfedge of that face that starts at l. It keeps j on its left as well.
  static Index last_corner(const Input_mesh& input, const Crossing_word& il)
  {
    return il.along != null_index ? input.next(il.along) : previous(input, Triangulation::twin(il.crossed.back()));
  }

  // The face on the other side of a spoke `side` of the face of `corner`: its corner at the same vertex.
  static Index corner_across(const Input_mesh& input, Index side, Index corner)
  {
    const Index twin = Triangulation::twin(side);
    return side == corner ? input.next(twin) : twin;
  }

  // Drops the letters that touch the end points, moving the corners along; what is left of a bare edge is that edge.
  static void trim(const Input_mesh& input, Crossing_word& kl, Index corner_of_k, Index corner_of_l)
  {
    auto first = kl.crossed.begin(), last = kl.crossed.end();
    for(; first != last && *first != input.next(corner_of_k); ++first)
      corner_of_k = corner_across(input, *first, corner_of_k);
    for(; first != last && Triangulation::twin(*(last - 1)) != input.next(corner_of_l); --last)
      corner_of_l = corner_across(input, Triangulation::twin(*(last - 1)), corner_of_l);
    kl.crossed.erase(last, kl.crossed.end());
    kl.crossed.erase(kl.crossed.begin(), first);
    if(kl.crossed.empty())
      kl.along = input.next(corner_of_k) == corner_of_l ? corner_of_k : Triangulation::twin(corner_of_l);
  }

  std::unordered_map<Index, Crossing_word> m_words;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_CROSSING_WORDS_H
