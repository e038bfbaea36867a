// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_MESH_H
#define CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_MESH_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace polyline_checker {

using Index = std::uint32_t;
constexpr Index null_index = (std::numeric_limits<Index>::max)();

/// Input that cannot be checked at all, as opposed to a curve that is checked and found wrong.
class Bad_input : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*
 * An oriented manifold triangle mesh, given as triples of vertices.
 *
 * Corner 3f + i is the i-th corner of face f. The same number names the halfedge that leaves this corner along the
 * border of f, counterclockwise, with f on its left:
 *
 *            previous(c)
 *              /   \              c: the corner at vertex(c), and the halfedge vertex(c) -> vertex(next(c))
 *             /  f  \             twin(c): the halfedge next(c) -> c of the neighbor, null_index on the border
 *            c --->  next(c)
 *
 * The ends of an edge without length are one vertex, the one with the smaller number. A face with one such edge is a
 * line, and its neighbors at the two other edges are neighbors of each other; so no face with such an edge is left.
 */
class Mesh
{
public:
  using Point = std::array<double, 3>;
  using Face = std::array<Index, 3>;

  /// \throws Bad_input naming the first vertex or face that is wrong
  Mesh(std::vector<Point> points, const std::vector<Face>& faces)
    : m_points(std::move(points))
  {
    check_points();
    for(std::size_t f = 0; f < faces.size(); ++f)
      add_face(faces[f], f);
    sort_halfedges();
    find_twins();
    merge_vertices();
  }

  std::size_t number_of_vertices() const { return m_points.size(); }
  std::size_t number_of_faces() const { return m_vertices.size() / 3; }

  const Point& point(Index v) const { return m_points[v]; }
  Index vertex(Index c) const { return m_vertices[c]; }
  Index twin(Index c) const { return m_twins[c]; }
  static Index next(Index c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static Index previous(Index c) { return c % 3 == 0 ? c + 2 : c - 1; }

  /// The halfedge from `a` to `b`, `null_index` if there is none.
  Index halfedge(Index a, Index b) const
  {
    const std::pair<std::uint64_t, Index> wanted(key(a, b), 0);
    const auto found = std::lower_bound(m_halfedges.begin(), m_halfedges.end(), wanted);
    return found != m_halfedges.end() && found->first == wanted.first ? found->second : null_index;
  }

  /// The halfedge from `a` to `b` of the face with the corners a, b, c counterclockwise, `null_index` if there is none.
  Index halfedge_of_face(Index a, Index b, Index c) const
  {
    const Index h = halfedge(a, b);
    return h != null_index && vertex(previous(h)) == c ? h : null_index;
  }

  /// The vertex in whose place v is: where edges have no length, their ends are one.
  Index merged(Index v) const { return v < m_merged.size() ? m_merged[v] : v; }

  bool is_edge(Index a, Index b) const { return halfedge(a, b) != null_index || halfedge(b, a) != null_index; }

  /// The next corner counterclockwise about the vertex of `c`, `null_index` past the border.
  Index next_around_vertex(Index c) const { return twin(previous(c)); }

private:
  static std::uint64_t key(Index a, Index b) { return (std::uint64_t(a) << 32) | b; }

  void check_points() const
  {
    for(std::size_t v = 0; v < m_points.size(); ++v)
      for(double coordinate : m_points[v])
        if(!std::isfinite(coordinate))
          throw Bad_input("vertex " + std::to_string(v) + " has a coordinate that is not finite");
  }

  void add_face(const Face& face, std::size_t f)
  {
    for(Index v : face)
      if(v >= m_points.size())
        throw Bad_input("face " + std::to_string(f) + " has a vertex that does not exist");
    if(face[0] == face[1] || face[1] == face[2] || face[2] == face[0])
      throw Bad_input("face " + std::to_string(f) + " repeats a vertex");
    m_vertices.insert(m_vertices.end(), face.begin(), face.end());
  }

  void sort_halfedges()
  {
    m_halfedges.reserve(m_vertices.size());
    for(Index c = 0; c < m_vertices.size(); ++c)
      m_halfedges.emplace_back(key(vertex(c), vertex(next(c))), c);
    std::sort(m_halfedges.begin(), m_halfedges.end());
    for(std::size_t i = 1; i < m_halfedges.size(); ++i)
      if(m_halfedges[i - 1].first == m_halfedges[i].first)
        throw Bad_input("face " + std::to_string(m_halfedges[i].second / 3) + " has an edge that is not manifold");
  }

  void find_twins()
  {
    m_twins.resize(m_vertices.size());
    for(Index c = 0; c < m_vertices.size(); ++c)
      m_twins[c] = halfedge(vertex(next(c)), vertex(c));
  }

  bool has_no_length(Index c) const { return m_points[m_vertices[c]] == m_points[m_vertices[next(c)]]; }

  bool is_flat(Index c) const { return has_no_length(c) || has_no_length(next(c)) || has_no_length(previous(c)); }

  void merge_vertices()
  {
    std::vector<Index> flat, faces;
    for(Index c = 0; c < m_vertices.size(); ++c)
      (is_flat(c) ? flat : faces).push_back(c);
    if(flat.empty())
      return;
    find_places(flat);
    std::vector<Index> twins(m_twins.size(), null_index);
    for(Index c : faces)
      twins[c] = twin_beyond_lines(c);
    m_twins.swap(twins);
    for(Index& v : m_vertices)
      v = m_merged[v];
    m_halfedges.clear();
    for(Index c : faces)
      m_halfedges.emplace_back(key(vertex(c), vertex(next(c))), c);
    std::sort(m_halfedges.begin(), m_halfedges.end());
  }

  void find_places(const std::vector<Index>& flat)
  {
    m_merged.resize(m_points.size());
    std::iota(m_merged.begin(), m_merged.end(), Index(0));
    for(Index c : flat)
      if(has_no_length(c)) {
        const Index a = place(vertex(c)), b = place(vertex(next(c)));
        m_merged[(std::max)(a, b)] = (std::min)(a, b);
      }
    for(Index v = 0; v < m_merged.size(); ++v)
      m_merged[v] = place(v);
  }

  Index place(Index v)
  {
    while(m_merged[v] != v)
      v = m_merged[v] = m_merged[m_merged[v]];
    return v;
  }

  Index twin_beyond_lines(Index c) const
  {
    Index t = twin(c);
    while(t != null_index && is_flat(t))
      t = twin(has_no_length(next(t)) ? previous(t) : next(t));
    return t;
  }

  std::vector<Point> m_points;
  std::vector<Index> m_merged;   // empty if each vertex has a place of its own
  std::vector<Index> m_vertices; // of each corner
  std::vector<Index> m_twins;
  std::vector<std::pair<std::uint64_t, Index>> m_halfedges; // end vertices and halfedge, sorted
};

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_MESH_H
