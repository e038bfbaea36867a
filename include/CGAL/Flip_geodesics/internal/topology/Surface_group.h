// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SURFACE_GROUP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SURFACE_GROUP_H

#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The fundamental group of a component: free if there is no relation, and so where the surface has a border.
 *
 * Of a closed surface of genus g, the relation has 4g letters, each generator and each inverse once. The graph of the
 * generators' loops has one vertex, at which all 4g ends meet in one cycle. So no two letters stand side by side in two
 * places of the relation and its inverse: what is common to two places is a single letter, 1/4g of the relation. From
 * genus 2 on that is below 1/6, and Dehn's algorithm decides: whatever spells the neutral element, and is not empty,
 * has inverse letters side by side or more than half of the relation in a row, which the other half can replace
 * [Lyndon, Schupp 1977, Theorem V.4.4]. The group of the torus is that of pairs of integers.
 */
class Surface_group
{
public:
  /* \pre empty, or a relation as above */
  explicit Surface_group(const std::vector<Letter>& relation)
    : m_size(relation.size())
  {
    for(std::size_t i = 0; i < m_size; ++i) {
      const Letter a = relation[i], b = relation[(i + 1) % m_size];
      m_next[a] = b;
      m_previous[b] = a;
    }
  }

  /* Does a word spell the neutral element? Linear in the word and the genus. */
  bool is_neutral(std::vector<Letter> word) const
  {
    if(m_size == 4)
      return is_balanced(word);
    std::vector<Read_letter> read;
    std::reverse(word.begin(), word.end());
    while(!word.empty()) {
      const Letter letter = word.back();
      word.pop_back();
      if(!read.empty() && read.back().letter == inverse_letter(letter)) {
        read.pop_back();
        continue;
      }
      read.push_back(next_letter(read, letter));
      for(bool is_inverse : {false, true})
        if(m_size > 0 && read.back().in_a_row[is_inverse] > m_size / 2) {
          replace_end(read, word, is_inverse);
          break;
        }
    }
    return read.empty();
  }

  /* Does each generator stand in a word as often as its inverse? */
  static bool is_balanced(std::vector<Letter> word)
  {
    std::sort(word.begin(), word.end());
    while(!word.empty()) {
      const Letter inverse = word.back(), letter = inverse & ~1;
      const auto count = [&](Letter l) { return std::count(word.begin(), word.end(), l); };
      if(count(letter) != count(inverse_letter(letter)))
        return false;
      word.erase(std::lower_bound(word.begin(), word.end(), letter), word.end());
    }
    return true;
  }

private:
  // A letter, and how many up to it stand in a row in the relation, and in its inverse.
  struct Read_letter
  {
    Letter letter;
    std::array<std::size_t, 2> in_a_row;
  };

  // The letter that follows in the relation, or in its inverse.
  Letter following(Letter letter, bool is_inverse) const
  {
    return is_inverse ? inverse_letter(m_previous.at(inverse_letter(letter))) : m_next.at(letter);
  }

  Read_letter next_letter(const std::vector<Read_letter>& read, Letter letter) const
  {
    Read_letter result = {letter, {{1, 1}}};
    for(bool is_inverse : {false, true})
      if(m_size > 0 && !read.empty() && following(read.back().letter, is_inverse) == letter)
        result.in_a_row[is_inverse] += read.back().in_a_row[is_inverse];
    return result;
  }

  // Takes a row of more than half of the relation back, and puts the inverse of its other letters to be read.
  void replace_end(std::vector<Read_letter>& read, std::vector<Letter>& unread, bool is_inverse) const
  {
    Letter letter = read.back().letter;
    const std::size_t size = read.back().in_a_row[is_inverse];
    read.resize(read.size() - size);
    for(std::size_t i = size; i < m_size; ++i) {
      letter = following(letter, is_inverse);
      unread.push_back(inverse_letter(letter)); // what was pushed last is read first
    }
  }

  std::size_t m_size;                                    // of the relation
  std::unordered_map<Letter, Letter> m_next, m_previous; // in the relation
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SURFACE_GROUP_H
