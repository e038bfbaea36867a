// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Other ways in a plane with obstacles, against all taut paths between their corners.

#include "world.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

using namespace ways_test;

namespace {

// In a plane with obstacles each class has one taut path, along segments between corners of obstacles: all of them are
// enumerated by length. Obstacles are faces without their corners in common; triangles of corners.
class Taut_paths
{
public:
  Taut_paths(const Point& source, const Point& target, const std::vector<std::array<Point, 3>>& obstacles)
    : m_nodes({source, target})
  {
    for(const auto& corners : obstacles)
      m_nodes.insert(m_nodes.end(), corners.begin(), corners.end());
  }

  // The lengths of the shortest ones.
  std::vector<double> operator()(std::size_t number) const
  {
    std::vector<double> result;
    std::multimap<double, std::vector<std::size_t>> open = {{distance(0, 1), {0}}}; // by the least length
    while(result.size() < number && !open.empty()) {
      const std::vector<std::size_t> path = open.begin()->second;
      const double length = open.begin()->first - distance(path.back(), 1);
      open.erase(open.begin());
      if(path.back() == 1) {
        result.push_back(length);
        continue;
      }
      for(std::size_t next = 1; next < m_nodes.size(); ++next)
        if(next != path.back() && is_visible(path.back(), next) &&
           (path.size() == 1 || is_taut(path[path.size() - 2], path.back(), next)))
        {
          std::vector<std::size_t> longer = path;
          longer.push_back(next);
          open.emplace(length + distance(path.back(), next) + distance(next, 1), longer);
        }
    }
    return result;
  }

private:
  double distance(std::size_t i, std::size_t k) const
  {
    return std::hypot(m_nodes[i].x() - m_nodes[k].x(), m_nodes[i].y() - m_nodes[k].y());
  }

  double turn(std::size_t i, std::size_t k, std::size_t l) const
  {
    const Point &p = m_nodes[i], &q = m_nodes[k], &r = m_nodes[l];
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  }

  bool is_visible(std::size_t a, std::size_t b) const
  {
    for(std::size_t first = 2; first < m_nodes.size(); first += 3)
      for(std::size_t i = 0; i < 3; ++i) {
        const std::size_t c = first + i, d = first + (i + 1) % 3;
        if(turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0 && a != c && a != d && b != c &&
           b != d)
          return false;
      }
    return true;
  }

  // Around the corner, with its triangle in the smaller angle.
  bool is_taut(std::size_t before, std::size_t corner, std::size_t after) const
  {
    const std::size_t first = corner - (corner - 2) % 3;
    const double side = turn(before, corner, after);
    for(std::size_t other = first; other < first + 3; ++other)
      if(other != corner && other != before && other != after &&
         (turn(before, corner, other) * side <= 0 || turn(corner, after, other) * side <= 0))
        return false;
    return side != 0;
  }

  std::vector<Point> m_nodes;
};

} // namespace

BOOST_AUTO_TEST_CASE(all_taut_paths_around_obstacles)
{
  constexpr int n = 9;
  constexpr std::size_t number = 6;
  std::mt19937 random(3);
  for(unsigned seed = 0; seed < 12; ++seed) {
    const Mesh_soup soup = jittered_grid(n, n, Diagonal_rule::RANDOM, 0.24, seed);
    std::set<std::size_t> obstacles;
    std::set<int> corners;
    std::vector<std::array<Point, 3>> triangles;
    while(obstacles.size() < 1 + seed % 3) {
      const std::size_t f = random() % soup.triangles.size();
      std::array<Point, 3> points;
      bool is_free = true;
      for(std::size_t i = 0; i < 3; ++i) {
        const int v = soup.triangles[f][i];
        const auto& p = soup.points[static_cast<std::size_t>(v)];
        points[i] = Point(p[0], p[1], p[2]);
        is_free = is_free && corners.count(v) == 0 && p[0] > 0 && p[0] < n && p[1] > 0 && p[1] < n;
      }
      if(!is_free)
        continue;
      obstacles.insert(f);
      corners.insert(soup.triangles[f].begin(), soup.triangles[f].end());
      triangles.push_back(points);
    }
    const World world(soup, [&](std::size_t f) { return obstacles.count(f) != 0; });
    for(int i = 0; i < 3; ++i) {
      const int source = static_cast<int>(random() % soup.points.size()),
                target = static_cast<int>(random() % soup.points.size());
      if(source == target || corners.count(source) != 0 || corners.count(target) != 0)
        continue;
      const std::vector<double> lengths =
          Taut_paths(world.mesh.point(Vertex(static_cast<unsigned>(source))),
                     world.mesh.point(Vertex(static_cast<unsigned>(target))), triangles)(number + 1);
      std::vector<Curve> curves;
      const auto found = world.paths(source, target, number, curves);
      BOOST_TEST(found.report.is_confirmed());
      BOOST_TEST_REQUIRE(found.number_of_curves() == number);
      for(std::size_t k = 0; k < number; ++k)
        BOOST_TEST(std::abs(found.length(k) - lengths[k]) < 1e-12 * lengths[k]);
      BOOST_TEST(found.report.lower_bound_of_others() < lengths[number] * (1 + 1e-12));
    }
  }
}
