// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_REDUCED_WORDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_REDUCED_WORDS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Words in which no letter stands beside its inverse, by numbers: a tree of words that are others with one letter more. */
class Reduced_words
{
public:
  using Word = std::size_t;
  static constexpr Word empty_word = 0;

  Reduced_words() { clear(); }

  /* Only the empty word is left. */
  void clear()
  {
    m_nodes.assign(1, {-1, empty_word});
    m_children.clear();
  }

  /* A word with one letter more, or less if that cancels. */
  Word appended(Word word, Letter letter)
  {
    if(word != empty_word && m_nodes[word].last == inverse_letter(letter))
      return m_nodes[word].rest;
    const auto [place, is_new] = m_children.emplace(std::make_pair(word, letter), m_nodes.size());
    if(is_new)
      m_nodes.push_back({letter, word});
    return place->second;
  }

  /* The letters of a word and of the inverse of another one. */
  std::vector<Letter> quotient(Word numerator, Word denominator) const
  {
    std::vector<Letter> backwards, result;
    for(Word w = numerator; w != empty_word; w = m_nodes[w].rest)
      backwards.push_back(m_nodes[w].last);
    result.assign(backwards.rbegin(), backwards.rend());
    for(Word w = denominator; w != empty_word; w = m_nodes[w].rest)
      result.push_back(inverse_letter(m_nodes[w].last));
    return result;
  }

private:
  struct Node
  {
    Letter last;
    Word rest;
  };

  std::vector<Node> m_nodes;
  std::map<std::pair<Word, Letter>, Word> m_children;
};

/*
 * What edge paths from one vertex spell in the generators of its component. Two paths to the same vertex are homotopic if
 * the one and the other backwards spell the neutral element.
 *
 * Where the surface has a border, words in which all is cancelled that can be are equal then, and not else. On a closed
 * surface, most words that differ do so in how often they have a generator: sums of numbers drawn for each tell.
 */
class Path_words
{
public:
  using Word = Reduced_words::Word;

  /* For the component that has a relation; an empty one says that its group is free. */
  Path_words(Generator_words words, const std::vector<Letter>& relation)
    : m_words(std::move(words))
    , m_group(relation)
    , m_is_free(relation.empty())
    , m_sums(1, 0)
  {
  }

  /* What a path spells that goes on over a halfedge. */
  Word continued(Word word, Input_halfedge_index h)
  {
    m_words.for_each_letter(h, [&](Letter letter) {
      const std::uint64_t sum = m_sums[word] + drawn_number(letter);
      word = m_reduced_words.appended(word, letter);
      if(word == m_sums.size())
        m_sums.push_back(sum);
    });
    return word;
  }

  /* The same for two paths to the same vertex if they are homotopic, and rarely else. */
  std::uint64_t key(Word word) const { return m_is_free ? static_cast<std::uint64_t>(word) : m_sums[word]; }

  /* Are two paths to the same vertex homotopic? */
  bool are_homotopic(Word a, Word b) const
  {
    return a == b || (!m_is_free && m_sums[a] == m_sums[b] && m_group.is_neutral(m_reduced_words.quotient(a, b)));
  }

private:
  // The same for a generator each time, and its negative for its inverse [Steele et al. 2014, SplitMix].
  static std::uint64_t drawn_number(Letter letter)
  {
    std::uint64_t z = (static_cast<std::uint64_t>(letter / 2) + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return letter % 2 == 0 ? z : 0 - z;
  }

  Generator_words m_words;
  Surface_group m_group;
  bool m_is_free;
  Reduced_words m_reduced_words;
  std::vector<std::uint64_t> m_sums; // by word
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_REDUCED_WORDS_H
