// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_STITCHER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_STITCHER_H

#include <CGAL/Flip_geodesics/internal/surface/Soup_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Triangle_soup.h>

#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Stitches borders of a soup that lie in the same place in opposite directions: first pairs of border edges of one
 * component, so that what was cut open where parts touch closes again, then those of any two components. Where more
 * than two edges remain in one place, none is stitched, as there is no telling which belong together. Pairs stay open if
 * their vertices, once merged, would be the ends of two edges, which had to be cut again.
 *
 * \pre the soup is an oriented manifold, which it is afterwards, too
 */
template <class Kernel>
class Soup_stitcher
{
  using Soup = Triangle_soup<Kernel>;
  using Mesh = Soup_mesh<Kernel>;
  using Halfedge = typename Mesh::Halfedge_index;
  using Pair = std::pair<Halfedge, Halfedge>;
  using Triangle = typename Soup::Triangle;

  struct Border_edge
  {
    std::size_t component, low, high; // places
    bool is_ascending;
    Halfedge h;

    auto key() const { return std::tie(component, low, high); }
    bool operator<(const Border_edge& other) const
    {
      return std::make_tuple(component, low, high, h) <
             std::make_tuple(other.component, other.low, other.high, other.h);
    }
  };

public:
  explicit Soup_stitcher(Soup& soup)
    : m_soup(soup)
    , m_mesh(make_soup_mesh(soup))
  {
  }

  /* Were borders stitched? */
  bool operator()()
  {
    collect_border_edges();
    std::vector<Pair> pairs;
    take_pairs(pairs);
    for(Border_edge& edge : m_edges)
      edge.component = 0;
    take_pairs(pairs);
    std::sort(pairs.begin(), pairs.end()); // an order that does not depend on the numbers of points
    while(!pairs.empty() && Polygon_mesh_processing::stitch_borders(m_mesh, pairs) > 0) {
      find_stitched();
      const std::vector<char> is_doubled = ends_of_doubled_edges();
      if(is_doubled.empty()) {
        read_back();
        return true;
      }
      m_mesh = make_soup_mesh(m_soup);
      remove_pairs_at(is_doubled, pairs);
    }
    return false;
  }

private:
  void collect_border_edges()
  {
    const std::vector<std::size_t> components = face_components(m_mesh);
    for(const Halfedge h : m_mesh.halfedges()) {
      if(!m_mesh.is_border(h))
        continue;
      const std::size_t p = m_soup.place(m_mesh.source(h)), q = m_soup.place(m_mesh.target(h));
      m_edges.push_back({components[m_mesh.face(m_mesh.opposite(h))], (std::min)(p, q), (std::max)(p, q), p < q, h});
    }
  }

  // Moves edges of which there are two with the same key, of opposite directions, to the pairs.
  void take_pairs(std::vector<Pair>& pairs)
  {
    std::sort(m_edges.begin(), m_edges.end());
    std::vector<Border_edge> rest;
    for(std::size_t begin = 0, end = 0; begin < m_edges.size(); begin = end) {
      while(end < m_edges.size() && m_edges[end].key() == m_edges[begin].key())
        ++end;
      if(end - begin == 2 && m_edges[begin].is_ascending != m_edges[begin + 1].is_ascending)
        pairs.emplace_back(m_edges[begin].h, m_edges[begin + 1].h);
      else
        rest.insert(rest.end(), m_edges.begin() + static_cast<std::ptrdiff_t>(begin),
                    m_edges.begin() + static_cast<std::ptrdiff_t>(end));
    }
    m_edges = std::move(rest);
  }

  // Stitching keeps faces and places, but neither vertices nor where the corners of a face begin.
  void find_stitched()
  {
    m_stitched.clear();
    m_now.assign(m_soup.origins.size(), Soup::none);
    for(std::size_t t = 0; t < m_soup.triangles.size(); ++t) {
      const Triangle& before = m_soup.triangles[t];
      Triangle now = corners(m_mesh, typename Mesh::Face_index(static_cast<typename Mesh::size_type>(t)));
      while(m_soup.place(now[0]) != m_soup.place(before[0]))
        std::rotate(now.begin(), now.begin() + 1, now.end());
      for(int i = 0; i < 3; ++i)
        m_now[before[i]] = now[i];
      m_stitched.push_back(now);
    }
  }

  // Marks vertices of the stitched mesh that are the ends of a side of two triangles, in the same direction; empty if
  // there are none. Two borders from one vertex to another in opposite directions are one edge of the soup.
  std::vector<char> ends_of_doubled_edges() const
  {
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    edges.reserve(3 * m_stitched.size());
    for(const Triangle& t : m_stitched)
      for(int i = 0; i < 3; ++i)
        edges.emplace_back(t[i], t[(i + 1) % 3]);
    std::sort(edges.begin(), edges.end());
    std::vector<char> result;
    for(auto it = edges.begin(); (it = std::adjacent_find(it, edges.end())) != edges.end(); ++it) {
      result.resize(m_soup.origins.size(), 0);
      result[it->first] = result[it->second] = 1;
    }
    return result;
  }

  // An edge is doubled since a pair at one of its ends was stitched.
  void remove_pairs_at(const std::vector<char>& is_doubled, std::vector<Pair>& pairs) const
  {
    const auto is_removed = [&](const Pair& pair) {
      const Halfedge h = pair.first, o = pair.second;
      const auto is_marked = [&](typename Mesh::Vertex_index v) { return is_doubled[m_now[v]] != 0; };
      return is_marked(m_mesh.source(h)) || is_marked(m_mesh.target(h)) || is_marked(m_mesh.source(o)) ||
             is_marked(m_mesh.target(o));
    };
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_removed), pairs.end());
  }

  // The vertices of a stitched triangle become the least of those that they were made of.
  void read_back()
  {
    std::vector<std::size_t> representative(m_soup.origins.size(), Soup::none);
    for(std::size_t v = 0; v < m_now.size(); ++v)
      if(m_now[v] != Soup::none)
        representative[m_now[v]] = (std::min)(representative[m_now[v]], v);
    for(std::size_t t = 0; t < m_stitched.size(); ++t)
      for(int i = 0; i < 3; ++i)
        m_soup.triangles[t][i] = representative[m_stitched[t][i]];
    for(std::size_t v = 0; v < m_now.size(); ++v)
      if(m_now[v] != Soup::none)
        m_soup.merged_into[v] = representative[m_now[v]];
  }

  Soup& m_soup;
  Mesh m_mesh;
  std::vector<Border_edge> m_edges;
  std::vector<Triangle> m_stitched;
  std::vector<std::size_t> m_now; // for each vertex of the soup that of the stitched mesh, none if it has no faces
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_STITCHER_H
