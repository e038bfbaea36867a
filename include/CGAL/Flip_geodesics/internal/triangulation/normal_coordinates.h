// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_NORMAL_COORDINATES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_NORMAL_COORDINATES_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * How the input edges pass through one intrinsic triangle, from the numbers of crossings of its three edges alone
 * [GSC21, section 3]. An input edge in the triangle either cuts a corner, from side to side, or emanates from a corner
 * to the opposite side; a side that lies along an input edge has no crossings.
 *
 * Corner 0 lies opposite side 0.
 */
struct Triangle_crossings
{
  Index emanating[3]; // input edges that start at the corner, strictly inside it
  Index cutting[3];   // input edges that cut the corner off

  Triangle_crossings(Index opposite_0, Index opposite_1, Index opposite_2)
  {
    const Index a = (std::max)(opposite_0, 0), b = (std::max)(opposite_1, 0), c = (std::max)(opposite_2, 0);
    // Of the three excesses one is positive at most: from the corner opposite the side that is too long, edges emanate.
    const Index excess_a = a - b - c, excess_b = b - c - a, excess_c = c - a - b;
    emanating[0] = (std::max)(excess_a, 0);
    emanating[1] = (std::max)(excess_b, 0);
    emanating[2] = (std::max)(excess_c, 0);
    cutting[0] = ((std::max)(-excess_a, 0) - emanating[1] - emanating[2]) / 2;
    cutting[1] = ((std::max)(-excess_b, 0) - emanating[2] - emanating[0]) / 2;
    cutting[2] = ((std::max)(-excess_c, 0) - emanating[0] - emanating[1]) / 2;
  }
};

/*
 * What the crossings of five edges of a quad i, l, j, k with diagonal ij say of a flip; -1 marks an edge that lies along
 * an input edge. In closed forms of the numbers that `Triangle_crossings` has.
 */
class Quad_crossings
{
public:
  Quad_crossings(Index ij, Index jk, Index ki, Index il, Index lj)
    : m_k(ij, ki, jk)
    , m_l(ij, il, lj)
    , m_is_along(ij < 0 ? 1 : 0)
  {
  }

  /*
   * The crossings of the other diagonal, kl.
   *
   * Input edges that do not reach ij cross kl once, unless they cut i or j off. Along ij, from i to j, the triangle of
   * k sends first those that cut i, then those that emanate from k, then those that cut j; so does the triangle of l.
   * One that cuts i on one side and j on the other crosses kl; one that emanates from k and ends at l lies along it.
   */
  Index other_diagonal() const
  {
    if((std::max)(m_k.cutting_i, m_l.cutting_i) < (std::min)(m_k.end, m_l.end))
      return -1;
    const Index from_i_to_j = (std::max)(m_k.cutting_i - m_l.end, 0);
    const Index from_j_to_i = (std::max)(m_l.cutting_i - m_k.end, 0);
    return m_k.past + m_l.past + from_i_to_j + from_j_to_i + m_is_along;
  }

private:
  struct Half
  {
    Index cutting_i; // input edges that cut the corner at i off
    Index end;       // they, and those that emanate from the corner opposite ij
    Index past;      // those that do not reach ij and pass between i and j

    // With o opposite ij.
    Half(Index along_ij, Index along_oi, Index along_jo)
    {
      const Index c = (std::max)(along_ij, 0), j = (std::max)(along_oi, 0), i = (std::max)(along_jo, 0);
      const Index cutting_j = clamped(c, i, (c + i - j) >> 1);
      cutting_i = clamped(c, j, (c + j - i) >> 1);
      end = c - cutting_j;
      past = (std::max)((std::max)(i, j) - c, (std::max)((i + j - c) >> 1, 0));
    }

    static Index clamped(Index a, Index b, Index value) { return (std::max)((std::min)((std::min)(a, b), value), 0); }
  };

  Half m_k, m_l;
  Index m_is_along; // 1 if ij lies along an input edge
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_NORMAL_COORDINATES_H
