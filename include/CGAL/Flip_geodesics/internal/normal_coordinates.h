// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NORMAL_COORDINATES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NORMAL_COORDINATES_H

#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>

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
    const Index side[3] = {(std::max)(opposite_0, 0), (std::max)(opposite_1, 0), (std::max)(opposite_2, 0)};
    for(int i = 0; i < 3; ++i)
      emanating[i] = (std::max)(side[i] - side[(i + 1) % 3] - side[(i + 2) % 3], 0);
    for(int i = 0; i < 3; ++i) {
      const int a = (i + 1) % 3, b = (i + 2) % 3;
      cutting[i] = ((std::max)(side[a] + side[b] - side[i], 0) - emanating[a] - emanating[b]) / 2;
    }
  }
};

/* The crossings of five edges of a quad i, l, j, k with diagonal ij; -1 marks an edge that lies along an input edge. */
struct Quad_crossings
{
  Index ij, jk, ki, il, lj;

  /*
   * The crossings of the other diagonal, kl.
   *
   * Input edges that do not reach ij cross kl once, unless they cut i or j off. Along ij, from i to j, the triangle of
   * k sends first those that cut i, then those that emanate from k, then those that cut j; so does the triangle of l.
   * One that cuts i on one side and j on the other crosses kl; one that emanates from k and ends at l lies along it.
   */
  Index other_diagonal() const
  {
    const Triangle_crossings k(ij, ki, jk); // corners k, j, i
    const Triangle_crossings l(ij, il, lj); // corners l, j, i
    const Index end_of_k = k.cutting[2] + k.emanating[0], end_of_l = l.cutting[2] + l.emanating[0];
    if((std::max)(k.cutting[2], l.cutting[2]) < (std::min)(end_of_k, end_of_l))
      return -1;
    const Index around_k = k.cutting[0] + k.emanating[1] + k.emanating[2];
    const Index around_l = l.cutting[0] + l.emanating[1] + l.emanating[2];
    const Index from_i_to_j = (std::max)(k.cutting[2] - end_of_l, 0);
    const Index from_j_to_i = (std::max)(l.cutting[2] - end_of_k, 0);
    return around_k + around_l + from_i_to_j + from_j_to_i + (ij < 0 ? 1 : 0);
  }

  /* The input edges that a rotation about i from ik over ij to il crosses. */
  Index rotation_at_i() const
  {
    return Triangle_crossings(ij, ki, jk).emanating[2] + Triangle_crossings(ij, il, lj).emanating[2] + (ij < 0 ? 1 : 0);
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NORMAL_COORDINATES_H
