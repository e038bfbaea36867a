// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_REDUCED_WORDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_REDUCED_WORDS_H

#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>

#include <cstddef>
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_REDUCED_WORDS_H
