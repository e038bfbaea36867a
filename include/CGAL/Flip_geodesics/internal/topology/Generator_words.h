// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_GENERATOR_WORDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_GENERATOR_WORDS_H

#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Pseudorandom numbers, the same in each run [SLF14]. */
inline std::uint64_t scrambled(std::uint64_t n)
{
  n += 0x9e3779b97f4a7c15;
  n = (n ^ (n >> 30)) * 0xbf58476d1ce4e5b9;
  n = (n ^ (n >> 27)) * 0x94d049bb133111eb;
  return n ^ (n >> 31);
}

/* Generator i is the letter 2i, its inverse is 2i + 1. */
using Letter = Index;
inline Letter inverse_letter(Letter letter) { return letter ^ 1; }

/*
 * The words of the input edges in the generators of a cotree: the word of a loop is its class in the fundamental group.
 * Edges of the forest have the empty word. The other words follow from the faces, whose boundary words are trivial.
 *
 * One walk around the cotree, counterclockwise in each face, passes each side of the generators once. The word of an
 * edge that the cotree crosses is the part of the walk beyond it, so that all words are substrings of one string.
 *
 *     |   beyond   |
 *     |____________|      the edge from left to right as seen from the face below: g, as a side of that face
 *       g  face        ->  word(g) = letters passed in the part of the cotree beyond g
 *
 * The walk around all faces of a closed component is the relation of its fundamental group, which has only one.
 */
class Generator_words
{
public:
  /* No words. */
  Generator_words() = default;

  /* \throws Interrupted */
  template <class Input_mesh>
  Generator_words(const Input_mesh& input, const Edge_forest& forest, const Cotree& cotree,
                  Interruption* interruption = nullptr)
    : m_parts(static_cast<std::size_t>(input.number_of_halfedges() / 2))
    , m_relations(forest.roots().size())
  {
    throw_if_interrupted_before_part(interruption);
    Indexed_by<Edge_index, std::vector<Index>> generator(m_parts.size(), -1);
    for(std::size_t i = 0; i < cotree.generators().size(); ++i)
      generator[edge_of(as_intrinsic(cotree.generators()[i].halfedge))] = static_cast<Index>(i);
    std::vector<char> is_walked(forest.roots().size(), 0); // by component
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
      if(!input.is_border(h))
        continue;
      is_walked[static_cast<std::size_t>(forest.component(input.tail(h)))] = 1;
      if(cotree.is_crossed(h))
        walk(input, cotree, generator, {twin_index(h), input.next(twin_index(h)), 2, number_of_letters()},
             interruption);
    }
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
      const std::size_t component = static_cast<std::size_t>(forest.component(input.tail(h)));
      if(is_walked[component] != 0)
        continue;
      is_walked[component] = 1;
      const Index begin = number_of_letters();
      walk(input, cotree, generator, {null_index, h, 3, begin}, interruption);
      m_relations[component] = {begin, number_of_letters(), true};
    }
  }

  /* Calls `use(letter)` for each letter of a halfedge's word. */
  template <class Use>
  void for_each_letter(Input_halfedge_index h, const Use& use) const
  {
    const Part& part = m_parts[edge_of(as_intrinsic(h))];
    if(part.is_first == is_first_side(h))
      for(Index i = part.begin; i < part.end; ++i)
        use(m_letters[static_cast<std::size_t>(i)]);
    else
      for(Index i = part.end; i-- > part.begin;)
        use(inverse_letter(m_letters[static_cast<std::size_t>(i)]));
  }

  /* Returns the boundary word of a closed component that is cut open; empty for other components. */
  std::vector<Letter> relation(Index component) const
  {
    const Part& part = m_relations[static_cast<std::size_t>(component)];
    return {m_letters.begin() + part.begin, m_letters.begin() + part.end};
  }

private:
  // The part of the walk that is the word of the first or the second side of an edge.
  struct Part
  {
    Index begin = 0, end = 0;
    bool is_first = true;
  };

  // A face on the walk.
  struct Visit
  {
    Input_halfedge_index entry; // the side by which it was entered, if any
    Input_halfedge_index side;  // the next side to be passed
    int sides_left;
    Index begin; // of its part of the walk
  };

  template <class Input_mesh>
  void walk(const Input_mesh& input, const Cotree& cotree, const Indexed_by<Edge_index, std::vector<Index>>& generator,
            const Visit& first, Interruption* interruption)
  {
    std::vector<Visit> visits(1, first);
    while(!visits.empty()) {
      throw_if_interrupted(interruption);
      Visit& visit = visits.back();
      if(visit.sides_left == 0) {
        leave(visit);
        visits.pop_back();
        continue;
      }
      const Input_halfedge_index g = visit.side;
      visit.side = input.next(g);
      --visit.sides_left;
      const Index begin = number_of_letters();
      if(cotree.is_crossed(g))
        visits.push_back({twin_index(g), input.next(twin_index(g)), 2, begin});
      else if(const Index i = generator[edge_of(as_intrinsic(g))]; i >= 0) {
        m_letters.push_back(2 * i + (is_first_side(g) ? 0 : 1));
        m_parts[edge_of(as_intrinsic(g))] = {begin, begin + 1, is_first_side(g)};
      }
    }
  }

  void leave(const Visit& visit)
  {
    if(visit.entry != null_index)
      m_parts[edge_of(as_intrinsic(visit.entry))] = {visit.begin, number_of_letters(), !is_first_side(visit.entry)};
  }

  Index number_of_letters() const { return static_cast<Index>(m_letters.size()); }

  std::vector<Letter> m_letters; // of the whole walk
  Indexed_by<Edge_index, std::vector<Part>> m_parts;
  std::vector<Part> m_relations; // by component
};

/*
 * The fundamental group of a component, which is free if the relation is empty and hence if the surface has a border.
 *
 * On a closed surface of genus g, the relation has 4g letters, each generator and each inverse once. The graph of the
 * generators' loops has one vertex, at which all 4g ends meet in one cycle. No two adjacent letters therefore occur
 * twice in the relation and its inverse: common parts consist of a single letter, 1/4g of the relation. From genus 2 on
 * that is below 1/6, and Dehn's algorithm applies: each nonempty word for the neutral element has adjacent inverse
 * letters or more than half of the relation as a subword, which the other half can replace [LS77, Theorem V.4.4]. The
 * group of the torus is that of pairs of integers.
 */
class Surface_group
{
public:
  /* \pre the relation is empty, or as described above */
  explicit Surface_group(const std::vector<Letter>& relation)
    : m_size(relation.size())
  {
    for(std::size_t i = 0; i < m_size; ++i) {
      const Letter a = relation[i], b = relation[(i + 1) % m_size];
      m_next[a] = b;
      m_previous[b] = a;
    }
  }

  /* Returns whether a word represents the neutral element. Linear in the length of the word and the genus. */
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
        if(!m_next.empty() && read.back().in_a_row[is_inverse] > m_size / 2) {
          replace_end(read, word, is_inverse);
          break;
        }
    }
    return read.empty();
  }

  /* Returns whether each generator occurs in a word as often as its inverse. */
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
  // A letter, and the lengths of the subwords of the relation and of its inverse that end at it.
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
      if(!m_next.empty() && !read.empty() && following(read.back().letter, is_inverse) == letter)
        result.in_a_row[is_inverse] += read.back().in_a_row[is_inverse];
    return result;
  }

  // Removes a subword of more than half of the relation, and puts the inverse of its other letters back to be read.
  void replace_end(std::vector<Read_letter>& read, std::vector<Letter>& unread, bool is_inverse) const
  {
    Letter letter = read.back().letter;
    const std::size_t size = read.back().in_a_row[is_inverse];
    read.resize(read.size() - size);
    for(std::size_t i = size; i < m_size; ++i) {
      letter = following(letter, is_inverse);
      unread.push_back(inverse_letter(letter)); // the last one pushed is read first
    }
  }

  std::size_t m_size;                                    // of the relation
  std::unordered_map<Letter, Letter> m_next, m_previous; // in the relation
};

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
  // A constant random number for a generator, and its negative for the inverse.
  static std::uint64_t drawn_number(Letter letter)
  {
    const std::uint64_t number = scrambled(static_cast<std::uint64_t>(letter / 2));
    return letter % 2 == 0 ? number : 0 - number;
  }

  Generator_words m_words;
  Surface_group m_group;
  bool m_is_free;
  Reduced_words m_reduced_words;
  std::vector<std::uint64_t> m_sums; // by word
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_GENERATOR_WORDS_H
