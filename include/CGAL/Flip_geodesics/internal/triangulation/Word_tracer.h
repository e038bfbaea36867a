// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WORD_TRACER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WORD_TRACER_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/triangulation/normal_coordinates.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Reads the crossing word of an edge off the triangulation as it is, by integers alone [GSC21, section 3 has the idea]:
 * how many input edges cross each edge says where they go in each triangle.
 *
 * Two input edges that an edge crosses one after the other are sides of one input face, so that they meet at a vertex
 * on its left or on its right. On the left they do if they stay next to each other, triangle by triangle, and emanate
 * from one corner in the end; if they part before, they meet on the right. So bundles of neighbors are followed, and
 * split where they part:
 *
 *             m                 from side x, whose face is on its left, a bundle goes on around k or around l,
 *            /|\                or ends at m
 *           / | \
 *          /  |. .\
 *         k ---x---> l
 *
 * This gives the letters one after the other, from the first one on. That is told by the input corner in which the edge
 * starts, which is counted off from an edge that has never been flipped.
 */
template <class Triangulation>
class Word_tracer
{
public:
  explicit Word_tracer(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /*
   * Writes the word of halfedge h. Returns false if no edge at its tail is the input's any more, so that it has to be
   * derived otherwise. Linear in the degree of the tail and in the triangles that bundles pass. \pre no point was
   * inserted
   */
  bool operator()(Halfedge_index h, Crossing_word& word)
  {
    const Input_halfedge_index spoke = spoke_before(h);
    if(spoke == null_index)
      return false;
    word.tail = m_triangulation.tail(h);
    word.head = m_triangulation.head(h);
    word.face = null_index;
    const Index number = crossings(h);
    word.along = number == 0 ? spoke : null_index;
    word.crossed.assign(static_cast<std::size_t>(number), meets_on_right); // where the letters will stand
    if(number == 0)
      return true;
    find_meetings_on_left(h, word.crossed);
    Input_halfedge_index crossed = input().next(spoke);
    for(Input_halfedge_index& letter : word.crossed) {
      const bool is_left_kept = letter == meets_on_left;
      letter = crossed;
      const Input_halfedge_index right_side = input().next(twin_index(crossed));
      crossed = is_left_kept ? input().next(right_side) : right_side;
    }
    return true;
  }

private:
  // Where an input edge meets the next one that is crossed.
  static constexpr Input_halfedge_index meets_on_right{0}, meets_on_left{1};

  // Input edges that cross side `halfedge` one after the other, numbered from its tail, and go on into the face on its
  // left; the first of them is letter `letter` of the word.
  struct Bundle
  {
    Halfedge_index halfedge;
    Index first, letter, size;
  };

  const auto& input() const { return m_triangulation.input(); }

  Index crossings(Halfedge_index h) const { return (std::max)(m_triangulation.crossings(Triangulation::edge(h)), 0); }

  bool is_along(Halfedge_index h) const { return m_triangulation.crossings(Triangulation::edge(h)) < 0; }

  // The input halfedge at the tail of h along which h lies, or else the first one clockwise; null if that is not known.
  Input_halfedge_index spoke_before(Halfedge_index h) const
  {
    Index passed = is_along(h) ? 1 : 0;
    for(Halfedge_index g = h; m_triangulation.version(Triangulation::edge(g)) != 0;) {
      const Halfedge_index t = Triangulation::twin(g), on = m_triangulation.next(t);
      passed += Triangle_crossings(crossings(m_triangulation.next(on)), crossings(t), crossings(on)).emanating[0];
      if(on == h)
        return null_index;
      g = on;
      if(m_triangulation.version(Triangulation::edge(g)) == 0)
        return turned(as_input(g), passed);
      passed += is_along(g) ? 1 : 0;
    }
    return as_input(h);
  }

  // Input halfedge h, turned counterclockwise over a number of input corners.
  Input_halfedge_index turned(Input_halfedge_index h, Index number) const
  {
    for(; number > 0; --number)
      h = twin_index(input().next(input().next(h)));
    return h;
  }

  void find_meetings_on_left(Halfedge_index h, std::vector<Input_halfedge_index>& meetings)
  {
    m_bundles.reserve(16);
    m_bundles.push_back({h, 0, 0, crossings(h)});
    while(!m_bundles.empty()) {
      const Bundle bundle = m_bundles.back();
      m_bundles.pop_back();
      follow(bundle, meetings);
    }
  }

  void follow(const Bundle& bundle, std::vector<Input_halfedge_index>& meetings)
  {
    const Halfedge_index x = bundle.halfedge, to_m = m_triangulation.next(x), to_k = m_triangulation.next(to_m);
    const Index number = crossings(x), number_at_l = crossings(to_m);
    const Triangle_crossings passing(number_at_l, crossings(to_k), number); // corners k, l, m
    const auto clamped = [&](Index i) { return (std::min)((std::max)(i - bundle.first, 0), bundle.size); };
    const Index around_k = clamped(passing.cutting[0]);
    const Index up_to_m = clamped(passing.cutting[0] + passing.emanating[2]);
    for(Index i = around_k; i + 1 < up_to_m; ++i)
      meetings[static_cast<std::size_t>(bundle.letter + i)] = meets_on_left;
    if(around_k > 1)
      m_bundles.push_back({Triangulation::twin(to_k), bundle.first, bundle.letter, around_k});
    if(bundle.size - up_to_m > 1)
      m_bundles.push_back({Triangulation::twin(to_m), bundle.first + up_to_m + number_at_l - number,
                           bundle.letter + up_to_m, bundle.size - up_to_m});
  }

  const Triangulation& m_triangulation;
  std::vector<Bundle> m_bundles; // still to be followed
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WORD_TRACER_H
