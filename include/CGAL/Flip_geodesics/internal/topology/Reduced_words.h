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

/* Words without adjacent inverse letters, represented by numbers: a tree in which each word extends another one by a
 * letter. */
class Reduced_words
{
public:
  using Word = std::size_t;
  static constexpr Word empty_word = 0;

  Reduced_words() { clear(); }

  /* Keeps the empty word only. */
  void clear()
  {
    m_nodes.assign(1, {-1, empty_word});
    m_children.clear();
  }

  /* Returns a word extended by one letter, or shortened if that cancels. */
  Word appended(Word word, Letter letter)
  {
    if(word != empty_word && m_nodes[word].last == inverse_letter(letter))
      return m_nodes[word].rest;
    const auto [place, is_new] = m_children.emplace(std::make_pair(word, letter), m_nodes.size());
    if(is_new)
      m_nodes.push_back({letter, word});
    return place->second;
  }

  /* Returns the letters of a word followed by the inverse of another one. */
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
 * The words of edge paths from one vertex in the generators of its component. Two paths to the same vertex are
 * homotopic if one of them and the reverse of the other represent the neutral element.
 *
 * If the surface has a border, this is the case if and only if the reduced words are equal. On a closed surface, most
 * different words differ in the number of occurrences of a generator, which sums of random numbers for the generators
 * detect.
 */
class Path_words
{
public:
  using Word = Reduced_words::Word;

  /* For the component with the given relation, which is empty if its group is free. */
  Path_words(Generator_words words, const std::vector<Letter>& relation)
    : m_words(std::move(words))
    , m_group(relation)
    , m_is_free(relation.empty())
    , m_sums(1, 0)
  {
  }

  /* Returns the word of a path that continues over a halfedge. */
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

  /* Returns a key that is equal for homotopic paths to the same vertex, and rarely for others. */
  std::uint64_t key(Word word) const { return m_is_free ? static_cast<std::uint64_t>(word) : m_sums[word]; }

  /* Returns whether two paths to the same vertex are homotopic. */
  bool are_homotopic(Word a, Word b) const
  {
    return a == b || (!m_is_free && m_sums[a] == m_sums[b] && m_group.is_neutral(m_reduced_words.quotient(a, b)));
  }

private:
  // A constant random number for a generator, and its negative for the inverse [Steele et al. 2014, SplitMix].
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
