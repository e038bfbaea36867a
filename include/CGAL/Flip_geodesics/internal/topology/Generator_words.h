// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_GENERATOR_WORDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_GENERATOR_WORDS_H

#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Cotree.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Generator i is the letter 2i, its inverse 2i + 1. */
using Letter = Index;
inline Letter inverse_letter(Letter letter) { return letter ^ 1; }

/*
 * The edges of the input as words in the generators of a cotree: what a loop spells is its class in the fundamental
 * group. Edges of the forest spell nothing. All else follows from the faces, each of which spells nothing as a whole.
 *
 * One walk around the cotree, counterclockwise in each face, passes each side of the generators once. An edge that the
 * cotree crosses spells what is written of the walk beyond it: so all words are parts of one string.
 *
 *      |   beyond   |
 *      |____________|      the edge from left to right as seen from the face below: g, as a side of that face
 *        g  face        ->  word(g) = letters passed in the part of the cotree beyond g
 *
 * The walk around all faces of a closed component spells the relation of its fundamental group, which has one.
 */
class Generator_words
{
public:
  /* None. */
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
        walk(input, cotree, generator, {twin_index(h), input.next(twin_index(h)), 2, 0}, interruption);
    }
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
      const std::size_t component = static_cast<std::size_t>(forest.component(input.tail(h)));
      if(is_walked[component] != 0)
        continue;
      is_walked[component] = 1;
      const Index begin = static_cast<Index>(m_letters.size());
      walk(input, cotree, generator, {null_index, h, 3, 0}, interruption);
      m_relations[component] = {begin, static_cast<Index>(m_letters.size()), true};
    }
  }

  /* Calls `use(letter)` for each letter of what a halfedge spells. */
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

  /* What the border of a closed component spells when it is cut open, nothing of other components. */
  std::vector<Letter> relation(Index component) const
  {
    const Part& part = m_relations[static_cast<std::size_t>(component)];
    return {m_letters.begin() + part.begin, m_letters.begin() + part.end};
  }

private:
  // A part of the walk, as which the first or the second side of an edge is spelled.
  struct Part
  {
    Index begin = 0, end = 0;
    bool is_first = true;
  };

  // A face on the walk.
  struct Visit
  {
    Input_halfedge_index entry; // the side by which it was entered, if it was
    Input_halfedge_index side;  // the next one to be passed
    int sides_left;
    Index begin; // of what is spelled from here on
  };

  template <class Input_mesh>
  void walk(const Input_mesh& input, const Cotree& cotree, const Indexed_by<Edge_index, std::vector<Index>>& generator,
            Visit first, Interruption* interruption)
  {
    first.begin = static_cast<Index>(m_letters.size());
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
      const Index begin = static_cast<Index>(m_letters.size());
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
      m_parts[edge_of(as_intrinsic(visit.entry))] = {visit.begin, static_cast<Index>(m_letters.size()),
                                                     !is_first_side(visit.entry)};
  }

  std::vector<Letter> m_letters; // of the whole walk
  Indexed_by<Edge_index, std::vector<Part>> m_parts;
  std::vector<Part> m_relations; // by component
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_GENERATOR_WORDS_H
