// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_BENCHMARK_ITERATIVE_UNFOLDING_H
#define FLIP_GEODESICS_BENCHMARK_ITERATIVE_UNFOLDING_H

#include "unfolded_path.h"

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace opponents {

/*!
 * Straightens an edge path by iterative unfolding [XW07]: the shortest path within the unfolded strip of faces, by a
 * funnel; where it bends about a vertex whose other side has an angle below \f$\pi\f$, the strip is led round that
 * side; until nothing changes.
 */
template <class Mesh>
class Iterative_unfolding
{
  using Path = Portal_path<Mesh>;
  using Point = std::complex<double>;

public:
  /// \return the number of rounds, or `most_rounds` if it did not end
  std::size_t operator()(Path& path, std::size_t most_rounds = 1000)
  {
    for(std::size_t round = 1; round < most_rounds; ++round) {
      if(path.portals.empty())
        return round;
      unfold(path);
      pull_string(path);
      if(!move_over_vertices(path)) {
        place_points(path);
        return round;
      }
    }
    return most_rounds;
  }

private:
  struct Unfolded_portal
  {
    Point right, left;
  };

  // A vertex that the taut string bends about: an end of gate `gate`.
  struct Bend
  {
    std::size_t portal;
    bool is_on_right;
    Point position;
  };

  static constexpr double angle_tolerance = 1e-10;

  static double cross(const Point& u, const Point& v) { return u.real() * v.imag() - u.imag() * v.real(); }

  void unfold(const Path& path)
  {
    const auto& g = path.geometry();
    const auto& portals = path.portals;
    m_portals.clear();
    Point right = 0, left = g.length(portals.front().crossed);
    m_source = g.apex(portals.front().crossed);
    for(std::size_t i = 0;; ++i) {
      m_portals.push_back({right, left});
      const auto entered = g.twin(portals[i].crossed);
      const Point direction = right - left;
      const Point apex = left + direction / std::abs(direction) * g.apex(entered);
      if(i + 1 == portals.size()) {
        m_target = apex;
        return;
      }
      (portals[i + 1].crossed == g.next(entered) ? left : right) = apex;
    }
  }

  // The funnel from the last bend on: its two sides bound what can be seen through the gates so far.
  void pull_string(const Path& path)
  {
    m_bends.clear();
    Point apex = m_source;
    std::size_t start = 0;
    while(true) {
      std::size_t right_portal = start, left_portal = start;
      bool has_bend = false;
      if(start < m_portals.size()) {
        Point right = m_portals[start].right - apex, left = m_portals[start].left - apex;
        for(std::size_t i = start + 1; i <= m_portals.size() && !has_bend; ++i) {
          const bool is_end = i == m_portals.size();
          const Point r = (is_end ? m_target : m_portals[i].right) - apex,
                      l = (is_end ? m_target : m_portals[i].left) - apex;
          if(cross(right, l) < 0) {
            add_bend(right_portal, true);
            has_bend = true;
          } else if(cross(left, r) > 0) {
            add_bend(left_portal, false);
            has_bend = true;
          } else {
            if(cross(right, r) >= 0) {
              right = r;
              right_portal = i;
            }
            if(cross(left, l) <= 0) {
              left = l;
              left_portal = i;
            }
          }
        }
      }
      if(!has_bend)
        return;
      apex = m_bends.back().position;
      start = portal_after_vertex(path, m_bends.back());
    }
  }

  void add_bend(std::size_t portal, bool is_on_right)
  {
    m_bends.push_back({portal, is_on_right, is_on_right ? m_portals[portal].right : m_portals[portal].left});
  }

  auto vertex(const Path& path, const Bend& bend) const
  {
    return path.geometry().tail(path.outgoing_halfedge(bend.portal, bend.is_on_right));
  }

  std::size_t portal_after_vertex(const Path& path, const Bend& bend) const
  {
    std::size_t i = bend.portal;
    while(i < path.portals.size() &&
          path.geometry().tail(path.outgoing_halfedge(i, bend.is_on_right)) == vertex(path, bend))
      ++i;
    return i;
  }

  std::size_t first_portal_at_vertex(const Path& path, const Bend& bend) const
  {
    std::size_t i = bend.portal;
    while(i > 0 && path.geometry().tail(path.outgoing_halfedge(i - 1, bend.is_on_right)) == vertex(path, bend))
      --i;
    return i;
  }

  // From the last bend to the first, so that the gates before stay where they are.
  bool move_over_vertices(Path& path)
  {
    bool has_moved = false;
    for(std::size_t b = m_bends.size(); b-- > 0;) {
      const Bend& bend = m_bends[b];
      const Point in = bend.position - (b == 0 ? m_source : m_bends[b - 1].position);
      const Point out = (b + 1 == m_bends.size() ? m_target : m_bends[b + 1].position) - bend.position;
      const double turn = std::abs(std::arg(out * std::conj(in)));
      const double other =
          path.geometry().total_angle(path.outgoing_halfedge(bend.portal, bend.is_on_right)) - pi - turn;
      if(!(other < pi - angle_tolerance))
        continue;
      const std::size_t first = first_portal_at_vertex(path, bend), last = portal_after_vertex(path, bend) - 1;
      path.replace(first, last, path.other_side(first, last, bend.is_on_right));
      has_moved = true;
    }
    if(has_moved)
      path.simplify();
    return has_moved;
  }

  // Where the taut string crosses the gates.
  void place_points(Path& path) const
  {
    std::size_t b = 0;
    for(std::size_t i = 0; i < path.portals.size(); ++i) {
      while(b < m_bends.size() && i >= portal_after_vertex(path, m_bends[b]))
        ++b;
      auto& portal = path.portals[i];
      if(b < m_bends.size() && i >= first_portal_at_vertex(path, m_bends[b])) {
        portal.t = m_bends[b].is_on_right ? 0 : 1;
        continue;
      }
      const Point from = b == 0 ? m_source : m_bends[b - 1].position;
      const Point to = b == m_bends.size() ? m_target : m_bends[b].position;
      const double right = std::abs(cross(to - from, m_portals[i].right - from));
      const double left = std::abs(cross(to - from, m_portals[i].left - from));
      portal.t = right + left > 0 ? right / (right + left) : 0.5;
    }
  }

  std::vector<Unfolded_portal> m_portals;
  std::vector<Bend> m_bends;
  Point m_source, m_target;
};

} // namespace opponents

#endif // FLIP_GEODESICS_BENCHMARK_ITERATIVE_UNFOLDING_H
