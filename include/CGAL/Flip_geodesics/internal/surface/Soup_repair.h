// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_REPAIR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_REPAIR_H

#include <CGAL/Flip_geodesics/Repair_report.h>
#include <CGAL/Flip_geodesics/internal/surface/Triangle_soup.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class Kernel>
using Soup_mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;

/*
 * Returns a soup as a mesh, for operations that require neighbors: vertex v of the soup has index v, triangle t index
 * t.
 *
 * \pre the soup is an oriented manifold
 */
template <class Kernel>
Soup_mesh<Kernel> make_soup_mesh(const Triangle_soup<Kernel>& soup)
{
  std::vector<typename Kernel::Point_3> points;
  points.reserve(soup.origins.size());
  for(std::size_t v = 0; v < soup.origins.size(); ++v)
    points.push_back(soup.point(v));
  Soup_mesh<Kernel> mesh;
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.triangles, mesh);
  return mesh;
}

/* Returns the corners of a face, starting with the head of its halfedge. */
template <class Mesh>
std::array<std::size_t, 3> corners(const Mesh& mesh, typename Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {static_cast<std::size_t>(mesh.target(h)), static_cast<std::size_t>(mesh.target(mesh.next(h))),
          static_cast<std::size_t>(mesh.source(h))};
}

/* Returns for each face its edge-connected component, counted from 0 in the order of their first faces. */
template <class Mesh>
std::vector<std::size_t> face_components(Mesh& mesh)
{
  const auto map = mesh.template add_property_map<typename Mesh::Face_index, std::size_t>("f:component", 0).first;
  Polygon_mesh_processing::connected_components(mesh, map);
  std::vector<std::size_t> result;
  for(const auto f : mesh.faces())
    result.push_back(get(map, f));
  return result;
}

/*
 * Stitches coinciding borders of a soup with opposite directions: first pairs of border edges of one component, so that
 * cuts where parts touch are closed again, then those of any two components. If more than two edges coincide, none is
 * stitched, since it is ambiguous which belong together. Pairs stay open if their vertices, once merged, would be the
 * ends of two edges, which would have to be cut again.
 *
 * \pre the soup is an oriented manifold, and it remains one
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
    std::size_t component, low, high; // the latter two are places
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

  /* Returns whether borders were stitched. */
  bool operator()()
  {
    collect_border_edges();
    std::vector<Pair> pairs;
    take_pairs(pairs);
    for(Border_edge& edge : m_edges)
      edge.component = 0;
    take_pairs(pairs);
    std::sort(pairs.begin(), pairs.end()); // an order independent of the numbers of points
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

  // Moves edges to the pairs if there are exactly two with the same key and opposite directions.
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

  // Stitching preserves faces and positions, but neither vertices nor the first corner of a face.
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

  // Marks vertices of the stitched mesh that are the ends of a side of two triangles in the same direction; empty if
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

  // An edge is doubled because a pair at one of its ends was stitched.
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

  // The vertices of a stitched triangle become the least of those from which they were merged.
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
  std::vector<std::size_t> m_now; // for each vertex of the soup its stitched vertex, none if it has no faces
};

/*
 * Removes triangles with collinear corners, which have their middle corner B on their longest edge AC. If a
 * nondegenerate triangle ACD lies beyond that edge, a flip converts both into two nondegenerate triangles, and the
 * surface is unchanged:
 *
 *        D                 D
 *      /   \             / | \
 *     A-----C    ->     A--B--C
 *      \-B-/
 *
 * If ACD is collinear as well and AC is its longest edge, a flip decreases the sum of lengths; if another edge is
 * longest, that longer edge is examined first. The process therefore terminates. A triangle that no flip can remove is
 * dropped: at a border the surface is the same without it; elsewhere this leaves a slit.
 *
 * \pre the soup is an oriented manifold, which it need not be afterwards, and no triangle has two coincident corners
 */
template <class Kernel>
class Soup_flips
{
  using Soup = Triangle_soup<Kernel>;
  using Mesh = Soup_mesh<Kernel>;
  using Halfedge = typename Mesh::Halfedge_index;
  using Face = typename Mesh::Face_index;

public:
  Soup_flips(Soup& soup, Repair_record& record)
    : m_soup(soup)
    , m_record(record)
  {
  }

  /* Returns whether anything was changed. */
  bool operator()()
  {
    for(std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      if(m_soup.is_collinear(m_soup.triangles[t]))
        m_stack.emplace_back(static_cast<typename Mesh::size_type>(t));
    if(m_stack.empty())
      return false;
    m_mesh = make_soup_mesh(m_soup);
    m_is_dropped.assign(m_soup.triangles.size(), 0);
    m_flips_left = 100 * m_stack.size();
    while(!m_stack.empty()) {
      const Face f = m_stack.back();
      m_stack.pop_back();
      if(!is_done(f))
        remove(f);
    }
    for(char is_dropped : m_is_dropped)
      m_record.add(Repair::DEGENERATE_FACES_DROPPED, is_dropped != 0 ? 1 : 0);
    m_soup.remove(m_is_dropped);
    return true;
  }

private:
  bool is_done(Face f) const { return m_is_dropped[f] != 0 || !m_soup.is_collinear(m_soup.triangles[f]); }

  void remove(Face f)
  {
    const Halfedge h = longest(f), o = m_mesh.opposite(h);
    if(m_mesh.is_border(o) || m_flips_left == 0)
      return drop(f);
    const Face g = m_mesh.face(o);
    if(m_is_dropped[g] != 0) // equivalent to a border
      return drop(f);
    if(!is_done(g) && longest(g) != o)
      m_stack.insert(m_stack.end(), {f, g});
    else
      flip_or_drop(f, h, g);
  }

  void drop(Face f) { m_is_dropped[f] = 1; }

  void flip_or_drop(Face f, Halfedge h, Face g)
  {
    const auto b = m_mesh.target(m_mesh.next(h)), d = m_mesh.target(m_mesh.next(m_mesh.opposite(h)));
    if(are_neighbors(b, d) || m_soup.place(b) == m_soup.place(d)) {
      drop(f);
      if(m_soup.is_collinear(m_soup.triangles[g]))
        drop(g);
      return;
    }
    if(!m_soup.is_collinear(m_soup.triangles[g]))
      m_record.add(Repair::DEGENERATE_FACES_FLIPPED);
    Euler::flip_edge(h, m_mesh);
    --m_flips_left;
    m_soup.polygons[f] = m_soup.polygons[g];
    m_soup.is_reversed[f] = m_soup.is_reversed[g];
    for(const Face face : {f, g}) {
      m_soup.triangles[face] = corners(m_mesh, face);
      m_stack.push_back(face);
    }
  }

  // The halfedge of a collinear face opposite to the middle corner.
  Halfedge longest(Face f) const
  {
    const auto is_ordered = Kernel().collinear_are_ordered_along_line_3_object();
    Halfedge h = m_mesh.halfedge(f);
    for(int i = 0; i < 2; ++i, h = m_mesh.next(h))
      if(is_ordered(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(m_mesh.next(h))),
                    m_mesh.point(m_mesh.target(h))))
        return h;
    return h;
  }

  // Linear in the smaller of the degrees.
  bool are_neighbors(typename Mesh::Vertex_index u, typename Mesh::Vertex_index v) const
  {
    Halfedge g = m_mesh.halfedge(u), h = m_mesh.halfedge(v);
    const Halfedge first_of_u = g, first_of_v = h;
    do {
      if(m_mesh.source(g) == v || m_mesh.source(h) == u)
        return true;
      g = m_mesh.opposite(m_mesh.next(g));
      h = m_mesh.opposite(m_mesh.next(h));
    } while(g != first_of_u && h != first_of_v);
    return false;
  }

  Soup& m_soup;
  Repair_record& m_record;
  Mesh m_mesh;
  std::vector<Face> m_stack;
  std::vector<char> m_is_dropped;
  std::size_t m_flips_left = 0;
};

/* Records which triangles CGAL's orientation reverses, and which edges it finds to have more than two triangles. */
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
 * Converts a soup into an oriented manifold without collinear triangles. A round drops duplicate triangles, orients all
 * consistently, cuts them apart where they are not a manifold, stitches coinciding borders, and flips or drops
 * collinear triangles. Rounds repeat until one changes nothing. A repair of the result, which is a round that starts
 * from the same triangles in the same order, therefore changes nothing either.
 *
 * The process terminates: the number of triangles never grows, a flip decreases the number of collinear ones or, with
 * the same number, the sum of lengths, and a stitch, which requires no cut, shortens borders. A step that increases one
 * of the later quantities has decreased an earlier one, and there are finitely many triangles on the vertices of the
 * soup.
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

  // Of coinciding triangles, the first is kept; others are dropped if they have the same vertices, or no neighbors.
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

  // Two triangles back to back, each the only neighbor of the other, are a closed surface and not duplicates.
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

  // Returns whether b is a rotation of a.
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

  // Reverses triangles such that coinciding borders have opposite directions and can be stitched. Triangles are passed
  // with the least place first, since CGAL's choice between conflicting neighbors depends on the first corner.
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

  // The alignment of parts serves only the stitching: if nothing is stitched, the original orientations are kept.
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

  // Orients and cuts apart. Vertices added by this are appended to the origins, as copies.
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

  // CGAL orients a component like its first triangle, which may reverse all others.
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
  std::vector<Edge> m_edges; // edges that were cut, by the points of the input
  bool m_is_manifold = false;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_REPAIR_H
