// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_BENCHMARK_UNFOLDED_PATH_H
#define FLIP_GEODESICS_BENCHMARK_UNFOLDED_PATH_H

#include <CGAL/boost/graph/iterator.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

/*
 * What the two opponents have in common: a path given by the edges that it crosses, on the mesh as it is. All of it in
 * plain doubles, as the papers have it.
 */
namespace opponents {

constexpr double pi = boost::math::constants::pi<double>();

template <class Mesh>
class Surface_geometry
{
public:
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;

  explicit Surface_geometry(const Mesh& mesh)
    : m_mesh(mesh)
    , m_points(mesh.points())
  {
  }

  const Mesh& mesh() const { return m_mesh; }
  Halfedge twin(Halfedge h) const { return m_mesh.opposite(h); }
  Vertex tail(Halfedge h) const { return m_mesh.source(h); }
  Vertex head(Halfedge h) const { return m_mesh.target(h); }
  Halfedge next(Halfedge h) const { return m_mesh.next(h); }
  Halfedge previous(Halfedge h) const { return m_mesh.prev(h); }
  bool is_border(Halfedge h) const { return m_mesh.is_border(h); }
  Halfedge clockwise(Halfedge h) const { return next(twin(h)); }
  Halfedge counterclockwise(Halfedge h) const { return twin(previous(h)); }

  double length(Halfedge h) const { return std::sqrt(CGAL::squared_distance(m_points[tail(h)], m_points[head(h)])); }

  /// The apex of the face of `h` where `h` is the vector (length, 0): in the upper half plane.
  std::complex<double> apex(Halfedge h) const
  {
    const auto e = m_points[head(h)] - m_points[tail(h)], f = m_points[head(next(h))] - m_points[tail(h)];
    const double l = std::sqrt(e.squared_length());
    return {e * f / l, std::sqrt(CGAL::cross_product(e, f).squared_length()) / l};
  }

  /// The corner of the face of `h` at its tail.
  double corner(Halfedge h) const { return std::arg(apex(h)); }

  /// The sum of angles at the vertex where `h` starts; infinite on the border.
  double total_angle(Halfedge h) const
  {
    double sum = 0;
    Halfedge s = h;
    do {
      if(is_border(s))
        return std::numeric_limits<double>::infinity();
      sum += corner(s);
      s = counterclockwise(s);
    } while(s != h);
    return sum;
  }

private:
  const Mesh& m_mesh;
  typename Mesh::template Property_map<Vertex, typename Mesh::Point> m_points;
};

/// A point of a path on an edge: the halfedge is a side of the face that is left, its tail is on the right; the point
/// is (1 - t) tail + t head.
template <class Halfedge>
struct Portal
{
  Halfedge crossed;
  double t;

  bool is_at_tail() const { return t <= 0; }
  bool is_at_head() const { return t >= 1; }
  bool is_at_vertex() const { return is_at_tail() || is_at_head(); }
};

/// A path from vertex to vertex through gates.
template <class Mesh>
class Portal_path
{
public:
  using Geometry = Surface_geometry<Mesh>;
  using Vertex = typename Geometry::Vertex;
  using Halfedge = typename Geometry::Halfedge;
  using Portals = std::vector<Portal<Halfedge>>;

  /// The gates on the side of the smaller angle at each vertex of an edge path, all points at the path's vertices.
  Portal_path(const Geometry& geometry, const std::vector<Halfedge>& path)
    : m_geometry(geometry)
    , m_source(geometry.tail(path.front()))
    , m_target(geometry.head(path.back()))
  {
    bool was_left = true;
    for(std::size_t i = 0; i + 1 < path.size(); ++i) {
      const bool is_left = angle_left(path[i], path[i + 1]) <= angle_left_of_reverse(path[i], path[i + 1]);
      if(i > 0 && was_left != is_left)
        portals.push_back(was_left ? Portal<Halfedge>{path[i], 1} : Portal<Halfedge>{geometry.twin(path[i]), 0});
      add_outgoing_halfedges(path[i], path[i + 1], is_left);
      was_left = is_left;
    }
    simplify();
  }

  const Geometry& geometry() const { return m_geometry; }
  Vertex source() const { return m_source; }
  Vertex target() const { return m_target; }

  /// The halfedge of gate `i` that starts at its right or left vertex.
  Halfedge outgoing_halfedge(std::size_t i, bool is_on_right) const
  {
    return is_on_right ? portals[i].crossed : m_geometry.twin(portals[i].crossed);
  }

  /// The gates that pass the vertex of gates `first` to `last` on its other side, with points at the vertex.
  /// \pre the border is not there
  Portals other_side(std::size_t first, std::size_t last, bool is_on_right) const
  {
    Portals result;
    const Halfedge from = outgoing_halfedge(first, is_on_right), to = outgoing_halfedge(last, is_on_right);
    if(is_on_right) {
      const Halfedge end = m_geometry.clockwise(to);
      for(Halfedge s = m_geometry.counterclockwise(from);; s = m_geometry.counterclockwise(s)) {
        result.push_back({m_geometry.twin(s), 1});
        if(s == end)
          return result;
      }
    }
    const Halfedge end = m_geometry.counterclockwise(to);
    for(Halfedge s = m_geometry.clockwise(from);; s = m_geometry.clockwise(s)) {
      result.push_back({s, 0});
      if(s == end)
        return result;
    }
  }

  void replace(std::size_t first, std::size_t last, const Portals& replacement)
  {
    const auto begin = portals.begin() + static_cast<std::ptrdiff_t>(first);
    const auto after = portals.erase(begin, portals.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    portals.insert(after, replacement.begin(), replacement.end());
  }

  /// Takes out what goes to and fro, and gates at the ends of the path.
  void simplify()
  {
    Portals result;
    for(const Portal<Halfedge>& portal : portals) {
      if(!result.empty() && result.back().crossed == m_geometry.twin(portal.crossed))
        result.pop_back();
      else if(!result.empty() || !touches(portal, m_source))
        result.push_back(portal);
    }
    while(!result.empty() && touches(result.back(), m_target))
      result.pop_back();
    std::size_t start = 0;
    while(start < result.size() && touches(result[start], m_source))
      ++start;
    result.erase(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(start));
    portals = std::move(result);
  }

  Portals portals;

private:
  bool touches(const Portal<Halfedge>& portal, Vertex v) const
  {
    return m_geometry.tail(portal.crossed) == v || m_geometry.head(portal.crossed) == v;
  }

  // The angle between two consecutive halfedges of a path on its left; infinite past the border.
  double angle_left(Halfedge in, Halfedge out) const
  {
    double sum = 0;
    for(Halfedge s = m_geometry.twin(in); s != out; s = m_geometry.clockwise(s)) {
      const Halfedge t = m_geometry.twin(s);
      if(m_geometry.is_border(t))
        return std::numeric_limits<double>::infinity();
      sum += m_geometry.corner(m_geometry.next(t));
    }
    return sum;
  }

  double angle_left_of_reverse(Halfedge in, Halfedge out) const
  {
    return angle_left(m_geometry.twin(out), m_geometry.twin(in));
  }

  void add_outgoing_halfedges(Halfedge in, Halfedge out, bool is_left)
  {
    const Halfedge from = m_geometry.twin(in);
    if(is_left)
      for(Halfedge s = m_geometry.clockwise(from); s != out; s = m_geometry.clockwise(s))
        portals.push_back({s, 0});
    else
      for(Halfedge s = m_geometry.counterclockwise(from); s != out; s = m_geometry.counterclockwise(s))
        portals.push_back({m_geometry.twin(s), 1});
  }

  const Geometry& m_geometry;
  Vertex m_source, m_target;
};

} // namespace opponents

#endif // FLIP_GEODESICS_BENCHMARK_UNFOLDED_PATH_H
