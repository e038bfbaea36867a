// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_MESH_SOUP_H
#define FLIP_GEODESICS_TEST_MESH_SOUP_H

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

constexpr double pi = 3.14159265358979323846;

using Coordinates = std::array<double, 3>;
using Corners = std::array<int, 3>;

/// Points, and triangles as triples of indices, counterclockwise seen from outside.
struct Mesh_soup
{
  std::vector<Coordinates> points;
  std::vector<Corners> triangles;
};

namespace internal {

// Polyhedron_3 with ids leaves it to the user to number its items; other meshes have no `id()` to set.
template <class Descriptor>
auto set_id(Descriptor descriptor, std::size_t id, int) -> decltype(static_cast<void>(descriptor->id() = id))
{
  descriptor->id() = id;
}

template <class Descriptor>
void set_id(Descriptor, std::size_t, long)
{
}

template <class DescriptorRange>
void set_ids(const DescriptorRange& descriptors)
{
  std::size_t id = 0;
  for(auto descriptor : descriptors)
    set_id(descriptor, id++, 0);
}

} // namespace internal

/// The mesh of a soup. \tparam Mesh a model of `MutableFaceGraph` with the property `CGAL::vertex_point`
/// \throws std::invalid_argument if the soup is no oriented manifold
template <class Mesh>
Mesh to_mesh(const Mesh_soup& soup)
{
  Mesh mesh;
  auto point_map = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<decltype(point_map)>::value_type;
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> created;
  for(const Coordinates& p : soup.points) {
    created.push_back(add_vertex(mesh));
    put(point_map, created.back(), Point(p[0], p[1], p[2]));
  }
  for(const Corners& t : soup.triangles) {
    const std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 3> corners = {created[t[0]], created[t[1]],
                                                                                          created[t[2]]};
    if(CGAL::Euler::add_face(corners, mesh) == boost::graph_traits<Mesh>::null_face())
      throw std::invalid_argument("the soup is no oriented manifold");
  }
  internal::set_ids(vertices(mesh));
  internal::set_ids(halfedges(mesh));
  internal::set_ids(faces(mesh));
  return mesh;
}

/// Numbers from a seed that are the same with every standard library; the distributions of `std` are not.
class Random_numbers
{
public:
  explicit Random_numbers(unsigned seed)
    : m_engine(seed)
  {
  }

  double uniform(double low, double high) { return low + (high - low) * (m_engine() / 4294967296.0); }
  int below(int bound) { return static_cast<int>(m_engine() % static_cast<unsigned>(bound)); }

private:
  std::mt19937 m_engine;
};

// ---------------------------------------------------------------- operations on soups

/// The same mesh with each point `p` moved to `f(p)`.
template <class Function>
Mesh_soup mapped(Mesh_soup soup, const Function& f)
{
  for(Coordinates& p : soup.points)
    p = f(p);
  return soup;
}

inline Mesh_soup translated(const Mesh_soup& soup, double x, double y, double z)
{
  return mapped(soup, [=](const Coordinates& p) { return Coordinates{p[0] + x, p[1] + y, p[2] + z}; });
}

/// Coordinates as multiples of 2^-24: what libraries of mathematics do not agree on is cut off.
inline Mesh_soup with_rounded_coordinates(const Mesh_soup& soup)
{
  return mapped(soup, [](Coordinates p) {
    for(double& x : p)
      x = std::nearbyint(x * (1 << 24)) / (1 << 24);
    return p;
  });
}

inline Mesh_soup scaled(const Mesh_soup& soup, double s)
{
  return mapped(soup, [=](const Coordinates& p) { return Coordinates{p[0] * s, p[1] * s, p[2] * s}; });
}

inline Coordinates normalized(const Coordinates& p)
{
  const double norm = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  return {p[0] / norm, p[1] / norm, p[2] / norm};
}

/// Both meshes side by side; the indices of `second` grow by the number of points of `first`.
inline Mesh_soup disjoint_union(Mesh_soup first, const Mesh_soup& second)
{
  const int shift = static_cast<int>(first.points.size());
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for(const Corners& t : second.triangles)
    first.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return first;
}

/// Isolated vertices, `before` of them with the smallest indices and `after` with the largest.
inline Mesh_soup with_isolated_vertices(const Mesh_soup& soup, int before, int after)
{
  const Coordinates nowhere = {-7, -8, -9};
  Mesh_soup front, back;
  front.points.assign(before, nowhere);
  back.points.assign(after, nowhere);
  return disjoint_union(disjoint_union(front, soup), back);
}

/// Drops the points that no triangle uses, keeping the order of the others.
inline Mesh_soup without_isolated_vertices(const Mesh_soup& soup)
{
  std::vector<int> new_index(soup.points.size(), -1);
  for(const Corners& t : soup.triangles)
    for(int v : t)
      new_index[v] = 0;
  Mesh_soup result;
  for(std::size_t v = 0; v < new_index.size(); ++v) {
    if(new_index[v] == -1)
      continue;
    new_index[v] = static_cast<int>(result.points.size());
    result.points.push_back(soup.points[v]);
  }
  for(const Corners& t : soup.triangles)
    result.triangles.push_back({new_index[t[0]], new_index[t[1]], new_index[t[2]]});
  return result;
}

namespace internal {

// Splits triangles; a new point is known by its weights at the old ones, which neighboring triangles agree on.
class Subdivision
{
public:
  Subdivision(const Mesh_soup& soup, int n)
    : m_n(n)
  {
    for(const Coordinates& p : soup.points) {
      m_indices[{{static_cast<int>(m_soup.points.size()), n}}] = static_cast<int>(m_soup.points.size());
      m_soup.points.push_back(p);
    }
    for(const Corners& t : soup.triangles)
      split(t);
  }

  const Mesh_soup& result() const { return m_soup; }

private:
  void split(const Corners& t)
  {
    for(int i = 0; i < m_n; ++i)
      for(int j = 0; i + j < m_n; ++j) {
        m_soup.triangles.push_back({point(t, i, j), point(t, i + 1, j), point(t, i, j + 1)});
        if(i + j + 1 < m_n)
          m_soup.triangles.push_back({point(t, i + 1, j), point(t, i + 1, j + 1), point(t, i, j + 1)});
      }
  }

  int point(const Corners& t, int i, int j)
  {
    std::map<int, int> weights = {{t[0], m_n - i - j}, {t[1], i}, {t[2], j}};
    std::vector<std::pair<int, int>> key;
    Coordinates sum = {0, 0, 0};
    for(const auto& [vertex, weight] : weights) {
      if(weight == 0)
        continue;
      key.emplace_back(vertex, weight);
      for(int d = 0; d < 3; ++d)
        sum[d] += weight * m_soup.points[vertex][d];
    }
    const auto [position, is_new] = m_indices.emplace(key, static_cast<int>(m_soup.points.size()));
    if(is_new)
      m_soup.points.push_back({sum[0] / m_n, sum[1] / m_n, sum[2] / m_n});
    return position->second;
  }

  int m_n;
  Mesh_soup m_soup;
  std::map<std::vector<std::pair<int, int>>, int> m_indices;
};

} // namespace internal

/// Each triangle split into `n * n` in its plane; the old points keep their indices. Coordinates that are integer
/// multiples of `n` stay integers, so that the parts of a triangle are coplanar exactly.
inline Mesh_soup subdivided(const Mesh_soup& soup, int n)
{
  CGAL_precondition(n >= 1);
  return internal::Subdivision(soup, n).result();
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_MESH_SOUP_H
