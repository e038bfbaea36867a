// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_IO_TUBE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_IO_TUBE_H

#include <CGAL/Flip_geodesics/IO/Tubes.h>
#include <CGAL/Flip_geodesics/internal/io/Figure.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A tube of triangles around a polyline. Seen against the direction of the curve, the corners of a ring are numbered
 * counterclockwise:
 *
 *        j ___________ j
 *         |\__        |
 *         |   \__     |        the triangles between a ring and the next one, from outside;
 *         |      \__  |        the curve runs to the right
 *         |_________\_|
 *       j+1            j+1
 *     ring i          ring i+1
 *
 * The first corner of a ring is carried from point to point by the least turn that takes one tangent to the next, so
 * that a tube is not twisted. Where a closed curve comes back, that first corner may point elsewhere than at the start;
 * the last ring is then joined to the first one some corners further.
 */
class Tube
{
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;
  static constexpr double two_pi = boost::math::constants::two_pi<double>();

public:
  /* A polyline is closed if its last point is its first. */
  Tube(const std::vector<Figure_point>& polyline, const IO::Tubes& tubes)
    : m_radius(tubes.radius())
    , m_sides(static_cast<std::size_t>(tubes.number_of_sides()))
  {
    set_line(polyline);
    if(m_line.size() < 2)
      return;
    set_tangents();
    Vector normal = perpendicular(m_tangents.front());
    const Vector first_normal = normal;
    for(std::size_t i = 0; i < m_line.size(); ++i) {
      if(i > 0)
        normal = carried(normal, m_tangents[i - 1], m_tangents[i]);
      add_ring(i, normal);
      if(i > 0)
        join(m_sides * (i - 1), m_sides * i, 0);
    }
    if(m_is_closed)
      join(m_sides * (m_line.size() - 1), 0, turn_to(first_normal, normal));
    else
      add_caps();
  }

  /* None if the polyline has no length. */
  const std::vector<Figure_point>& points() const { return m_points; }
  const std::vector<Figure_triangle>& triangles() const { return m_triangles; }

private:
  // Points that repeat the one before are left out.
  void set_line(const std::vector<Figure_point>& polyline)
  {
    std::unique_copy(polyline.begin(), polyline.end(), std::back_inserter(m_line));
    m_is_closed = m_line.size() > 3 && m_line.front() == m_line.back();
    if(m_is_closed)
      m_line.pop_back();
  }

  // Scaled first: squares of its coordinates may be beyond double.
  static Vector unit(const Vector& v)
  {
    const double size = (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
    const Vector scaled(v.x() / size, v.y() / size, v.z() / size);
    return scaled / std::sqrt(scaled.squared_length());
  }

  // From point i of the line to the next one.
  Vector direction(std::size_t i) const
  {
    const Figure_point &p = m_line[i], &q = m_line[(i + 1) % m_line.size()];
    return unit(Vector(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
  }

  void set_tangents()
  {
    const std::size_t last = m_line.size() - 1;
    for(std::size_t i = 0; i <= last; ++i) {
      const Vector next = direction(m_is_closed || i < last ? i : last - 1);
      const Vector before = m_is_closed || i > 0 ? direction(i > 0 ? i - 1 : last) : next;
      const Vector sum = before + next;
      m_tangents.push_back(sum.squared_length() > reversal ? unit(sum) : before); // no plane halves a reversal
    }
  }

  // The axis that is farthest from v, made perpendicular to it.
  static Vector perpendicular(const Vector& v)
  {
    const double x = std::abs(v.x()), y = std::abs(v.y()), z = std::abs(v.z());
    const Vector axis = x <= y && x <= z ? Vector(1, 0, 0) : (y <= z ? Vector(0, 1, 0) : Vector(0, 0, 1));
    return unit(axis - (axis * v) * v);
  }

  // The normal after the least turn that takes tangent t to tangent u.
  static Vector carried(const Vector& normal, const Vector& t, const Vector& u)
  {
    const double cosine_plus_one = 1 + t * u;
    if(cosine_plus_one < reversal)
      return normal;
    const Vector turned = normal - (normal * u) / cosine_plus_one * (t + u);
    return unit(turned - (turned * u) * u);
  }

  void add_ring(std::size_t i, const Vector& normal)
  {
    const Vector binormal = cross_product(m_tangents[i], normal);
    for(std::size_t j = 0; j < m_sides; ++j) {
      const Vector arm = m_radius * (std::cos(angle(j)) * normal + std::sin(angle(j)) * binormal);
      m_points.push_back({m_line[i][0] + arm.x(), m_line[i][1] + arm.y(), m_line[i][2] + arm.z()});
    }
  }

  double angle(std::size_t j) const { return two_pi * static_cast<double>(j) / static_cast<double>(m_sides); }

  // By how many corners the last normal, carried on to the first point, is turned against the first.
  std::size_t turn_to(const Vector& first_normal, const Vector& last_normal) const
  {
    const Vector& tangent = m_tangents.front();
    const Vector normal = carried(last_normal, m_tangents.back(), tangent);
    const double turn = std::atan2(normal * cross_product(tangent, first_normal), normal * first_normal);
    return static_cast<std::size_t>(std::lround((turn + two_pi) / angle(1))) % m_sides;
  }

  // Rings by their first corners; corner j of one meets corner j + turn of the other.
  void join(std::size_t ring, std::size_t next_ring, std::size_t turn)
  {
    for(std::size_t j = 0; j < m_sides; ++j) {
      const std::size_t k = (j + 1) % m_sides;
      const std::size_t a = ring + j, b = ring + k;
      const std::size_t c = next_ring + (j + turn) % m_sides, d = next_ring + (k + turn) % m_sides;
      m_triangles.push_back({a, b, d});
      m_triangles.push_back({a, d, c});
    }
  }

  void add_caps()
  {
    const std::size_t start = m_points.size(), end = start + 1, last_ring = m_points.size() - m_sides;
    m_points.push_back(m_line.front());
    m_points.push_back(m_line.back());
    for(std::size_t j = 0; j < m_sides; ++j) {
      const std::size_t k = (j + 1) % m_sides;
      m_triangles.push_back({start, k, j});
      m_triangles.push_back({end, last_ring + j, last_ring + k});
    }
  }

  double m_radius;
  std::size_t m_sides;
  bool m_is_closed = false;
  std::vector<Figure_point> m_line;
  std::vector<Vector> m_tangents;
  std::vector<Figure_point> m_points;
  std::vector<Figure_triangle> m_triangles;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_IO_TUBE_H
