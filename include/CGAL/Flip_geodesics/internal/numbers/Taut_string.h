// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_TAUT_STRING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_TAUT_STRING_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The length by 106 bits, since std::abs() has other last bits in each library, and so has what is just as long. */
inline double well_rounded_length(const Plane_vector& v)
{
  return sqrt(exact_product(v.real(), v.real()) + exact_product(v.imag(), v.imag())).high;
}

/* The sides of a gate, as the traveller sees it. */
enum Gate_side : std::size_t { LEFT_END, RIGHT_END };

/* An edge that a path crosses, in the plane: its end that is not one of the gate before. The first gate has its right
 * end at the origin, and tells the left one. */
struct Unfolded_gate
{
  Plane_vector end;
  Gate_side side;
};

/*
 * The shortest string through a strip of unfolded faces, by a funnel that starts afresh at each bend [Lee, Preparata,
 * Euclidean Shortest Paths in the Presence of Rectilinear Barriers, 1984]. The strip's gates are those that the string
 * crosses between its two ends, none of which is an end of a gate.
 */
class Taut_string
{
public:
  /* A vertex that the string bends about: an end of gates `first` to `last`. */
  struct Bend
  {
    std::size_t first, last;
    Gate_side side;
    Plane_vector position;
  };

  void pull(const std::vector<Unfolded_gate>& gates, const Plane_vector& source, const Plane_vector& target)
  {
    m_bends.clear();
    Plane_vector apex = source;
    std::size_t start = 0;
    while(find_bend(gates, apex, start, target)) {
      apex = m_bends.back().position;
      start = m_bends.back().last + 1;
    }
  }

  /* An end of gate i. */
  static Plane_vector end(const std::vector<Unfolded_gate>& gates, std::size_t i, Gate_side side)
  {
    for(; gates[i].side != side; --i)
      if(i == 0)
        return 0;
    return gates[i].end;
  }

  const std::vector<Bend>& bends() const { return m_bends; }

private:
  // What is seen from the apex through the gates so far lies between the directions to `left` and `right`.
  struct Funnel
  {
    Plane_vector left, right;
    std::size_t left_gate, right_gate;
  };

  // Most gates leave the funnel as it is, which is told without a branch on their side: it follows no pattern that a
  // processor could guess.
  bool find_bend(const std::vector<Unfolded_gate>& gates, const Plane_vector& apex, std::size_t start,
                 const Plane_vector& target)
  {
    if(start >= gates.size())
      return false;
    Funnel funnel = {end(gates, start, LEFT_END) - apex, end(gates, start, RIGHT_END) - apex, start, start};
    for(std::size_t i = start + 1; i < gates.size(); ++i) {
      const double x = gates[i].end.real() - apex.real(), y = gates[i].end.imag() - apex.imag();
      const double to_left = unfused(funnel.right.real() * y) - unfused(funnel.right.imag() * x);
      const double to_right = unfused(x * funnel.left.imag()) - unfused(y * funnel.left.real());
      const Gate_side side = gates[i].side;
      if(std::array<double, 2>{to_right, to_left}[side] < 0) // by LEFT_END, RIGHT_END
        continue;
      if(side == RIGHT_END) {
        if(to_right < 0)
          return add_bend(gates, funnel.left_gate, LEFT_END);
        funnel.right = {x, y};
        funnel.right_gate = i;
      } else {
        if(to_left < 0)
          return add_bend(gates, funnel.right_gate, RIGHT_END);
        funnel.left = {x, y};
        funnel.left_gate = i;
      }
    }
    if(cross(funnel.right, target - apex) < 0)
      return add_bend(gates, funnel.right_gate, RIGHT_END);
    return cross(funnel.left, target - apex) > 0 && add_bend(gates, funnel.left_gate, LEFT_END);
  }

  bool add_bend(const std::vector<Unfolded_gate>& gates, std::size_t gate, Gate_side side)
  {
    std::size_t first = gate, last = gate;
    while(first > 0 && gates[first].side != side)
      --first;
    while(last + 1 < gates.size() && gates[last + 1].side != side)
      ++last;
    m_bends.push_back({first, last, side, end(gates, gate, side)});
    return true;
  }

  std::vector<Bend> m_bends;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_TAUT_STRING_H
