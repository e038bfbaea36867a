// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_CORNER_PRODUCT_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_CORNER_PRODUCT_H

#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A product of input corners, each dot + i root; those whose roots are rational multiples of each other are multiplied
 * together first. If each partial product is real or imaginary, then so is the product, whatever the roots are. It is
 * the common case of a proof that an angle is straight: at walls, where a right angle lies beside one that a diagonal
 * divides into corners of congruent faces.
 */
class Corner_product
{
  // number + i root_coefficient root
  struct Factor
  {
    const Integer* square; // of the root
    Integer number, root_coefficient;
  };

public:
  /* Is the product of some chains proven to be real, and not zero? Never, unless they consist of corners. */
  static bool is_real(const std::vector<Unfolding_chain>& chains)
  {
    std::vector<Factor> factors;
    for(const Unfolding_chain& chain : chains)
      for(const Unfolding_step& step : chain.steps) {
        if(step.kind != Unfolding_step::Kind::CORNER || step.squared_root() == 0)
          return false;
        multiply({&step.squared_root(), step.dot(), chain.is_conjugate ? -1 : 1}, factors);
      }
    bool is_imaginary = false;
    for(const Factor& factor : factors) {
      if(factor.number != 0 && factor.root_coefficient != 0)
        return false;
      is_imaginary = is_imaginary != (factor.number == 0);
    }
    return !is_imaginary;
  }

private:
  static void multiply(const Factor& corner, std::vector<Factor>& factors)
  {
    for(Factor& factor : factors)
      if(*factor.square == *corner.square)
        return multiply(corner, factor);
    for(Factor& factor : factors)
      if(const std::optional<Integer> root = exact_root(*factor.square * *corner.square))
        return multiply({factor.square, corner.number * *factor.square, corner.root_coefficient * *root}, factor);
    factors.push_back(corner);
  }

  // Of one root.
  static void multiply(const Factor& corner, Factor& factor)
  {
    const Integer number = factor.number;
    factor.number = number * corner.number - factor.root_coefficient * corner.root_coefficient * *factor.square;
    factor.root_coefficient = number * corner.root_coefficient + factor.root_coefficient * corner.number;
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_CORNER_PRODUCT_H
