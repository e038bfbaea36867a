// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_REPAIR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_REPAIR_H

#include <CGAL/Flip_geodesics/Repair_report.h>
#include <CGAL/Flip_geodesics/internal/surface/Soup_flips.h>
#include <CGAL/Flip_geodesics/internal/surface/Soup_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Soup_stitcher.h>
#include <CGAL/Flip_geodesics/internal/surface/Triangle_soup.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Notes which triangles CGAL's orientation turns over, and which edges it finds to have more than two. */
class Orientation_recorder : public Polygon_mesh_processing::Default_orientation_visitor
{
public:
  using Edge = std::pair<std::size_t, std::size_t>;

  Orientation_recorder(std::vector<char>& is_reversed, std::vector<Edge>& edges)
    : m_is_reversed(&is_reversed)
    , m_edges(&edges)
  {
  }

  void polygon_orientation_reversed(std::size_t t) { (*m_is_reversed)[t] ^= 1; }

  void non_manifold_edge(std::size_t u, std::size_t v, std::size_t)
  {
    m_edges->emplace_back((std::min)(u, v), (std::max)(u, v));
  }

private:
  std::vector<char>* m_is_reversed;
  std::vector<Edge>* m_edges;
};

/*
 * Makes an oriented manifold without collinear triangles of a soup. A round drops triangles that occur twice, orients
 * all alike, cuts them apart where they are not a manifold, stitches borders in one place, and flips collinear triangles
 * away or drops them. Rounds repeat until one changes nothing. Hence a repair of the result, which is a round that
 * starts from the same triangles in the same order, changes nothing either.
 *
 * There is a last round: the number of triangles never grows, a flip makes the number of collinear ones smaller or, with
 * the same number, the sum of lengths, and a stitch, which needs no cut, makes borders shorter. What makes a later one of
 * these larger has made an earlier one smaller, and there are finitely many triangles on the vertices of the soup.
 */
template <class Kernel>
class Soup_repair
{
  using Soup = Triangle_soup<Kernel>;
  using Triangle = typename Soup::Triangle;
  using Edge = Orientation_recorder::Edge;

public:
  Soup_repair(Soup& soup, Repair_record& record)
    : m_soup(soup)
    , m_record(record)
  {
  }

  void operator()()
  {
    std::vector<Triangle> before;
    do {
      before = m_soup.triangles;
      apply_round();
      if(m_soup.triangles != before) {
        keep_most_orientations();
        m_soup.sort_by_polygon();
      }
    } while(m_soup.triangles != before);
    record_edges();
  }

private:
  void apply_round()
  {
    if(drop_duplicates() || !m_is_manifold)
      orient();
    m_is_manifold = true;
    if(has_vertices_in_one_place())
      stitch();
    if(Soup_flips<Kernel>(m_soup, m_record)())
      orient();
  }

  struct Place_triangle
  {
    Triangle places; // ascending
    std::size_t t;

    bool operator<(const Place_triangle& other) const
    {
      return places != other.places ? places < other.places : t < other.t;
    }
  };

  static Edge edge(const Triangle& t, int i)
  {
    return {(std::min)(t[i], t[(i + 1) % 3]), (std::max)(t[i], t[(i + 1) % 3])};
  }

  std::vector<Edge> sorted_edges() const
  {
    std::vector<Edge> result;
    for(const Triangle& t : m_soup.triangles)
      for(int i = 0; i < 3; ++i)
        result.push_back(edge(t, i));
    std::sort(result.begin(), result.end());
    return result;
  }

  Triangle sorted_places(std::size_t t) const
  {
    Triangle result;
    std::transform(m_soup.triangles[t].begin(), m_soup.triangles[t].end(), result.begin(),
                   [this](std::size_t v) { return m_soup.place(v); });
    std::sort(result.begin(), result.end());
    return result;
  }

  // Of the triangles in one place, the first stays; others go if they have the same vertices, or no neighbors.
  bool drop_duplicates()
  {
    std::vector<Place_triangle> order;
    for(std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      order.push_back({sorted_places(t), t});
    std::sort(order.begin(), order.end());
    std::vector<Edge> edges;
    std::vector<char> is_dropped(m_soup.triangles.size(), 0);
    for(std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
      while(end < order.size() && order[end].places == order[begin].places)
        ++end;
      if(end - begin > 1 && edges.empty())
        edges = sorted_edges();
      for(std::size_t k = begin + 1; k < end; ++k)
        is_dropped[order[k].t] = is_duplicate(order[begin].t, order[k].t, edges) ? 1 : 0;
    }
    const auto count = static_cast<std::size_t>(std::count(is_dropped.begin(), is_dropped.end(), 1));
    m_record.add(Repair::DUPLICATES_DROPPED, count);
    m_soup.remove(is_dropped);
    return count > 0;
  }

  // Two triangles back to back, each the only neighbor of the other, are a closed surface, and no duplicates.
  bool is_duplicate(std::size_t first, std::size_t t, const std::vector<Edge>& edges) const
  {
    const Triangle &a = m_soup.triangles[first], &b = m_soup.triangles[t];
    std::size_t most = 0, least = edges.size();
    for(int i = 0; i < 3; ++i) {
      const auto range = std::equal_range(edges.begin(), edges.end(), edge(b, i));
      most = (std::max)(most, static_cast<std::size_t>(range.second - range.first));
      least = (std::min)(least, static_cast<std::size_t>(range.second - range.first));
    }
    if(most == 1)
      return true;
    if(!std::is_permutation(a.begin(), a.end(), b.begin()))
      return false;
    return most > 2 || is_even(a, b);
  }

  // Is b a rotation of a?
  static bool is_even(const Triangle& a, const Triangle& b)
  {
    const auto at = std::find(b.begin(), b.end(), a[0]);
    return b[static_cast<std::size_t>(at - b.begin() + 1) % 3] == a[1];
  }

  bool has_vertices_in_one_place() const
  {
    std::vector<std::size_t> vertex_at(m_soup.points.size(), Soup::none);
    for(const Triangle& triangle : m_soup.triangles)
      for(std::size_t v : triangle) {
        std::size_t& at = vertex_at[m_soup.place(v)];
        if(at != Soup::none && at != v)
          return true;
        at = v;
      }
    return false;
  }

  // Reverses triangles so that borders in one place have opposite directions and can be stitched. Triangles are passed
  // with the least place first, since CGAL's choice between conflicting neighbors depends on the corner that is first.
  void align_parts()
  {
    std::vector<Triangle> triangles = m_soup.triangles;
    for(Triangle& triangle : triangles) {
      for(std::size_t& v : triangle)
        v = m_soup.place(v);
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    }
    std::vector<std::size_t> vertices(m_soup.points.size(), 0);
    std::vector<char> is_reversed(triangles.size(), 0);
    std::vector<Edge> ignored;
    Polygon_mesh_processing::orient_polygon_soup(vertices, triangles,
                                                 CGAL::parameters::visitor(Orientation_recorder(is_reversed, ignored)));
    for(std::size_t t = 0; t < triangles.size(); ++t)
      if(is_reversed[t] != 0)
        m_soup.reverse(t);
  }

  // The alignment of parts serves the stitch only: if there is none, orientations stay as they were.
  void stitch()
  {
    const std::vector<Triangle> triangles = m_soup.triangles;
    const std::vector<char> is_reversed = m_soup.is_reversed;
    align_parts();
    orient();
    if(Soup_stitcher<Kernel>(m_soup)())
      return;
    m_soup.triangles = triangles;
    m_soup.is_reversed = is_reversed;
  }

  // Orients, and cuts apart. Vertices that this adds are appended to the origins, as copies.
  void orient()
  {
    std::vector<Edge> edges;
    Polygon_mesh_processing::orient_polygon_soup(
        m_soup.origins, m_soup.triangles, CGAL::parameters::visitor(Orientation_recorder(m_soup.is_reversed, edges)));
    for(const Edge& e : edges) {
      const auto ends = std::minmax(m_soup.origins[e.first], m_soup.origins[e.second]);
      m_edges.emplace_back(ends.first, ends.second);
    }
    for(std::size_t v = m_soup.merged_into.size(); v < m_soup.origins.size(); ++v)
      m_soup.merged_into.push_back(v);
  }

  // CGAL orients as the first triangle of a component is; that may turn over all others.
  void keep_most_orientations()
  {
    if(std::count(m_soup.is_reversed.begin(), m_soup.is_reversed.end(), 1) == 0)
      return;
    Soup_mesh<Kernel> mesh = make_soup_mesh(m_soup);
    const std::vector<std::size_t> components = face_components(mesh);
    std::vector<std::size_t> kept(components.size(), 0), reversed(components.size(), 0);
    for(std::size_t t = 0; t < components.size(); ++t)
      ++(m_soup.is_reversed[t] != 0 ? reversed : kept)[components[t]];
    for(std::size_t t = 0; t < components.size(); ++t)
      if(reversed[components[t]] > kept[components[t]])
        m_soup.reverse(t);
  }

  void record_edges()
  {
    std::sort(m_edges.begin(), m_edges.end());
    m_record.add(Repair::EDGES_CUT,
                 static_cast<std::size_t>(std::unique(m_edges.begin(), m_edges.end()) - m_edges.begin()));
    std::vector<std::size_t> reversed;
    for(std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      if(m_soup.is_reversed[t] != 0)
        reversed.push_back(m_soup.polygons[t]);
    std::sort(reversed.begin(), reversed.end());
    m_record.add(Repair::POLYGONS_REVERSED,
                 static_cast<std::size_t>(std::unique(reversed.begin(), reversed.end()) - reversed.begin()));
  }

  Soup& m_soup;
  Repair_record& m_record;
  std::vector<Edge> m_edges; // that were cut, by the points of the input
  bool m_is_manifold = false;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_REPAIR_H
