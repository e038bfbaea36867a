// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TAUT_STRING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TAUT_STRING_H

#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

using Plane_vector = std::complex<double>;

inline double cross(const Plane_vector& u, const Plane_vector& v)
{
  return u.real() * v.imag() - u.imag() * v.real();
}

/* Without the care for infinite numbers that the operator takes. */
inline Plane_vector product(const Plane_vector& u, const Plane_vector& v)
{
  return {u.real() * v.real() - u.imag() * v.imag(), u.real() * v.imag() + u.imag() * v.real()};
}

/* An edge that a path crosses, in the plane, as the traveller sees it. */
struct Unfolded_gate
{
  Plane_vector right, left;
  bool is_right_new; // or else the left end, compared with the gate before
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
    bool is_on_right;
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

  const std::vector<Bend>& bends() const { return m_bends; }

private:
  // What is seen from the apex through the gates so far lies between the directions to `right` and `left`.
  struct Funnel
  {
    std::size_t right_gate, left_gate;
    Plane_vector right, left;
  };

  bool find_bend(const std::vector<Unfolded_gate>& gates, const Plane_vector& apex, std::size_t start,
                 const Plane_vector& target)
  {
    if(start >= gates.size())
      return false;
    Funnel funnel = {start, start, gates[start].right - apex, gates[start].left - apex};
    for(std::size_t i = start + 1; i < gates.size(); ++i) {
      if(gates[i].is_right_new) {
        const Plane_vector right = gates[i].right - apex;
        if(cross(funnel.left, right) > 0)
          return add_bend(gates, funnel.left_gate, false);
        if(cross(funnel.right, right) >= 0) {
          funnel.right = right;
          funnel.right_gate = i;
        }
      } else {
        const Plane_vector left = gates[i].left - apex;
        if(cross(funnel.right, left) < 0)
          return add_bend(gates, funnel.right_gate, true);
        if(cross(funnel.left, left) <= 0) {
          funnel.left = left;
          funnel.left_gate = i;
        }
      }
    }
    if(cross(funnel.right, target - apex) < 0)
      return add_bend(gates, funnel.right_gate, true);
    return cross(funnel.left, target - apex) > 0 && add_bend(gates, funnel.left_gate, false);
  }

  bool add_bend(const std::vector<Unfolded_gate>& gates, std::size_t gate, bool is_on_right)
  {
    std::size_t first = gate, last = gate;
    while(first > 0 && gates[first].is_right_new != is_on_right)
      --first;
    while(last + 1 < gates.size() && gates[last + 1].is_right_new != is_on_right)
      ++last;
    m_bends.push_back({first, last, is_on_right, is_on_right ? gates[gate].right : gates[gate].left});
    return true;
  }

  std::vector<Bend> m_bends;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TAUT_STRING_H
