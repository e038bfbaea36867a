// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_EXACT_DISTANCES_H
#define FLIP_GEODESICS_TEST_EXACT_DISTANCES_H

#include "mesh_soup.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

/*
 * The distances between all vertices of a small polyhedron, by brute force, in numbers of 50 digits: from each vertex,
 * all sequences of faces are unfolded that straight lines from there can pass, and what is seen is a graph, whose
 * shortest paths are those on the surface. A line that passes a vertex counts as one to there and one from there on, so
 * that different paths are different ones in the graph.
 */
class Exact_distances
{
public:
  using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

  explicit Exact_distances(const Mesh_soup& soup)
    : m_soup(soup)
    , m_size(soup.points.size())
    , m_is_passed(soup.triangles.size(), 0)
  {
    for(std::size_t f = 0; f < soup.triangles.size(); ++f)
      for(int i = 0; i < 3; ++i)
        m_face[{soup.triangles[f][i], soup.triangles[f][(i + 1) % 3]}] = f;
    m_segments.resize(m_size * m_size);
    for(m_from = 0; m_from < static_cast<int>(m_size); ++m_from)
      look_around();
    for(std::size_t s = 0; s < m_size; ++s)
      find_shortest(static_cast<int>(s));
  }

  const Number& distance(int s, int t) const { return m_paths.at({s, t}).length; }

  /* How many shortest paths are there? */
  std::size_t number_of_paths(int s, int t) const { return m_paths.at({s, t}).number; }

private:
  struct Vector
  {
    Number x, y;
  };

  struct Paths
  {
    Number length;
    std::size_t number;
  };

  static Number tiny() { return Number(1e-30); }
  static Number cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

  Number squared_length(int u, int v) const
  {
    Number sum = 0;
    for(int i = 0; i < 3; ++i) {
      const Number d = Number(m_soup.points[u][i]) - Number(m_soup.points[v][i]);
      sum += d * d;
    }
    return sum;
  }

  int third(std::size_t f, int u, int v) const
  {
    const auto& t = m_soup.triangles[f];
    return t[0] + t[1] + t[2] - u - v;
  }

  // Where the third corner of a face lies that has u at one place, v at another, and itself on the right of the line.
  Vector unfolded(int u, const Vector& at_u, int v, const Vector& at_v, int w) const
  {
    const Number base = squared_length(u, v), to_u = squared_length(u, w), to_v = squared_length(v, w);
    const Number along = (base + to_u - to_v) / (2 * base);
    const Number square = to_u / base - along * along;
    const Number aside = square > 0 ? Number(sqrt(square)) : Number(0);
    const Vector d = {at_v.x - at_u.x, at_v.y - at_u.y};
    return {at_u.x + along * d.x + aside * d.y, at_u.y + along * d.y - aside * d.x};
  }

  void look_around()
  {
    for(std::size_t f = 0; f < m_soup.triangles.size(); ++f)
      for(int i = 0; i < 3; ++i) {
        const auto& t = m_soup.triangles[f];
        if(t[i] != m_from)
          continue;
        const int right = t[(i + 1) % 3], left = t[(i + 2) % 3];
        const Vector origin = {0, 0}, at_right = {sqrt(squared_length(m_from, right)), 0};
        const Vector at_left = unfolded(right, at_right, m_from, origin, left);
        see(right, at_right.x);
        if(m_face.count({m_from, left}) == 0) // the border
          see(left, sqrt(squared_length(m_from, left)));
        m_is_passed[f] = 1;
        look_through(right, at_right, left, at_left, at_right, at_left);
        m_is_passed[f] = 0;
      }
  }

  void see(int v, const Number& length) { m_segments[m_from * m_size + v].push_back(length); }

  // Through the edge from u, on the right, to v, between two directions.
  void look_through(int u, const Vector& at_u, int v, const Vector& at_v, const Vector& right, const Vector& left)
  {
    const auto found = m_face.find({v, u});
    if(found == m_face.end() || m_is_passed[found->second] != 0 || !(cross(right, left) > tiny()))
      return;
    const std::size_t f = found->second;
    const int w = third(f, u, v);
    const Vector at_w = unfolded(u, at_u, v, at_v, w);
    m_is_passed[f] = 1;
    const Number from_right = cross(right, at_w), to_left = cross(at_w, left);
    if(from_right > tiny() && to_left > tiny())
      see(w, sqrt(at_w.x * at_w.x + at_w.y * at_w.y));
    if(from_right > tiny())
      look_through(u, at_u, w, at_w, right, to_left > tiny() ? at_w : left);
    if(to_left > tiny())
      look_through(w, at_w, v, at_v, from_right > tiny() ? at_w : right, left);
    m_is_passed[f] = 0;
  }

  void find_shortest(int s)
  {
    std::vector<Paths> paths(m_size, {Number(1e100), 0});
    std::vector<char> is_done(m_size, 0);
    paths[s] = {0, 1};
    for(std::size_t n = 0; n < m_size; ++n) {
      std::size_t u = m_size;
      for(std::size_t v = 0; v < m_size; ++v)
        if(is_done[v] == 0 && (u == m_size || paths[v].length < paths[u].length))
          u = v;
      is_done[u] = 1;
      for(std::size_t v = 0; v < m_size; ++v)
        for(const Number& length : m_segments[u * m_size + v])
          add(paths[v], {paths[u].length + length, paths[u].number});
    }
    for(std::size_t v = 0; v < m_size; ++v)
      m_paths[{s, static_cast<int>(v)}] = paths[v];
  }

  static void add(Paths& paths, const Paths& other)
  {
    const Number tolerance = Number(1e-47) * (1 + other.length); // a line beside a vertex by 1e-22 differs by more
    if(other.length < paths.length - tolerance)
      paths = other;
    else if(other.length <= paths.length + tolerance)
      paths.number += other.number;
  }

  Mesh_soup m_soup;
  std::size_t m_size;
  std::map<std::pair<int, int>, std::size_t> m_face; // on the left
  std::vector<char> m_is_passed;
  std::vector<std::vector<Number>> m_segments;
  std::map<std::pair<int, int>, Paths> m_paths;
  int m_from = 0;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_EXACT_DISTANCES_H
