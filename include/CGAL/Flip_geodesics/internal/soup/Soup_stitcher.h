// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SOUP_SOUP_STITCHER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SOUP_SOUP_STITCHER_H

#include <CGAL/Flip_geodesics/internal/soup/Soup_mesh.h>
#include <CGAL/Flip_geodesics/internal/soup/Triangle_soup.h>

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
 * than two edges remain in one place, none is stitched, as there is no telling which belong together.
 *
 * \pre the soup is an oriented manifold, which it may not be afterwards
 */
template <class Kernel>
class Soup_stitcher
{
  using Soup = Triangle_soup<Kernel>;
  using Mesh = Soup_mesh<Kernel>;
  using Halfedge = typename Mesh::Halfedge_index;
  using Pair = std::pair<Halfedge, Halfedge>;

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
    if(pairs.empty() || Polygon_mesh_processing::stitch_borders(m_mesh, pairs) == 0)
      return false;
    read_back();
    return true;
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
  void read_back()
  {
    std::vector<std::size_t> representative(m_soup.origins.size(), Soup::none);
    for(std::size_t t = 0; t < m_soup.triangles.size(); ++t) {
      auto now = corners(m_mesh, typename Mesh::Face_index(static_cast<typename Mesh::size_type>(t)));
      auto& before = m_soup.triangles[t];
      while(m_soup.place(now[0]) != m_soup.place(before[0]))
        std::rotate(now.begin(), now.begin() + 1, now.end());
      for(int i = 0; i < 3; ++i) {
        m_merged.emplace_back(before[i], now[i]);
        representative[now[i]] = (std::min)(representative[now[i]], before[i]);
      }
      before = now;
    }
    for(auto& triangle : m_soup.triangles)
      for(std::size_t& v : triangle)
        v = representative[v];
    for(const auto& before_and_now : m_merged)
      m_soup.merged_into[before_and_now.first] = representative[before_and_now.second];
  }

  Soup& m_soup;
  Mesh m_mesh;
  std::vector<Border_edge> m_edges;
  std::vector<std::pair<std::size_t, std::size_t>> m_merged;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SOUP_SOUP_STITCHER_H
