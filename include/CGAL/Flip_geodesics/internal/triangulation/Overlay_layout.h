// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_LAYOUT_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_LAYOUT_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Overlay.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The rounded positions of the vertices of an overlay: crossings along their two edges, and the corners of polygons in
 * their input faces.
 *
 * Crossings are measured in the strip of their intrinsic edge, each separately, so that rounding errors may exchange
 * two close ones on one input edge. The overlay has their exact order, to which the positions are made monotone.
 */
template <class Triangulation>
class Overlay_layout
{
public:
  using Overlay = internal::Overlay<Triangulation>;
  using Weights = std::array<double, 3>;
  using Point_2 = std::array<double, 2>;

  /* Measures an overlay in which no edge is dissolved yet. */
  explicit Overlay_layout(const Overlay& overlay)
    : m_overlay(&overlay)
    , m_faces(overlay.input_faces())
  {
    measure_crossings();
    raise_to_order();
    find_intrinsic_faces();
    m_weights.resize(m_faces.size());
    for(Overlay_halfedge h : overlay.halfedges())
      if(!overlay.is_border(h))
        m_weights[h] = measure_corner(h);
  }

  /* Returns the position of a crossing on its input edge, from 0 at the tail of `crossed_halfedge(v)` to 1 at the
   * head. */
  double on_input(Overlay_vertex v) const { return m_crossings[number(v)].on_input; }
  /* Returns the position of a crossing on its intrinsic edge, from 0 at the tail of the first halfedge to 1 at the
   * head. */
  double on_intrinsic(Overlay_vertex v) const { return m_crossings[number(v)].on_intrinsic; }

  /* Returns the first halfedge of that intrinsic edge. */
  Halfedge_index intrinsic_halfedge(Overlay_vertex v) const { return m_crossings[number(v)].intrinsic_halfedge; }

  /* Returns the smallest halfedge of the intrinsic face that contains the polygon of h, or null_index if polygons were
   * merged. */
  Halfedge_index intrinsic_face(Overlay_halfedge h) const
  {
    return m_intrinsic_faces.empty() ? Halfedge_index() : m_intrinsic_faces[h];
  }
  /* Must be called when polygons of different intrinsic faces are merged. */
  void forget_intrinsic_faces() { m_intrinsic_faces.clear(); }

  /* Returns the smallest halfedge of the input face that contains the polygon of h. */
  Input_halfedge_index face(Overlay_halfedge h) const { return m_faces[h]; }
  /* Returns the origin of h in that face: barycentric coordinates for the tails of that halfedge and the next two. */
  const Weights& weights(Overlay_halfedge h) const { return m_weights[h]; }

  /* Accounts for a diagonal that was added to the overlay from the origin of a to that of b. */
  void add_diagonal(Overlay_halfedge a, Overlay_halfedge b)
  {
    m_faces.insert(m_faces.end(), 2, m_faces[a]);
    if(!m_intrinsic_faces.empty())
      m_intrinsic_faces.insert(m_intrinsic_faces.end(), 2, m_intrinsic_faces[a]);
    const Weights from = m_weights[a], to = m_weights[b];
    m_weights.insert(m_weights.end(), {from, to});
  }

  /* Accounts for the joining of h and the edge after it. Must be called beforehand. */
  void join(Overlay_halfedge h) { m_weights[Overlay::twin(h)] = m_weights[Overlay::twin(m_overlay->next(h))]; }

  /* Accounts for an edge that was cut: the new edge replaces t, the twin of h. */
  void add_cut(Overlay_halfedge t)
  {
    m_faces.insert(m_faces.end(), {m_faces[t], null_index});
    if(!m_intrinsic_faces.empty())
      m_intrinsic_faces.insert(m_intrinsic_faces.end(), {m_intrinsic_faces[t], null_index});
    const Weights weights = m_weights[t];
    m_weights.insert(m_weights.end(), {weights, weights});
  }

  /*
   * Splits the edge of h, between two triangles or on the border, at its midpoint, as the overlay does. \pre the
   * overlay is triangulated, and its vertices have not been split yet
   */
  void split(Overlay& overlay, Overlay_halfedge h)
  {
    CGAL_precondition(m_intrinsic_faces.empty());
    h = is_first_side(h) ? h : Overlay::twin(h);
    const Overlay_halfedge t = Overlay::twin(h);
    std::array<Side, 2> sides;
    for(const Overlay_halfedge side : {h, t})
      if(!overlay.is_border(side))
        sides[is_first_side(side) ? 0 : 1] = {m_faces[side], middle_of(side), m_weights[overlay.previous(side)]};
    add_midpoint(h, sides[overlay.is_border(h) ? 1 : 0]);
    overlay.split(h);
    add_edge(sides[0].face, sides[0].middle, sides[1].face, m_weights[t]);
    m_weights[t] = sides[1].middle;
    for(const Side& side : sides)
      if(side.face != null_index)
        add_edge(side.face, side.middle, side.face, side.apex);
  }

  /* A vertex added by split(), with the first halfedge of the intrinsic edge that contains it and its position there;
   * the halfedge is null if there is none. */
  struct Midpoint
  {
    Surface_point on_input;
    Halfedge_index intrinsic_halfedge;
    double on_intrinsic;
  };

  const Midpoint& midpoint(Overlay_vertex v) const { return m_midpoints[number(v) - m_crossings.size()]; }

  /* The corners of an input face in the plane, with the tail of f at the origin. */
  std::array<Point_2, 3> corners(Input_halfedge_index f) const
  {
    const auto vectors = input_face_geometry(triangulation(), f);
    return {{{0, 0}, {vectors[0].x, vectors[0].y}, {-vectors[2].x, -vectors[2].y}}};
  }

  static Point_2 point(const std::array<Point_2, 3>& corners, const Weights& w)
  {
    return {w[1] * corners[1][0] + w[2] * corners[2][0], w[1] * corners[1][1] + w[2] * corners[2][1]};
  }

private:
  struct Crossing
  {
    double on_input, on_intrinsic;
    Halfedge_index intrinsic_halfedge;
  };

  // The elements on one side of an edge that is split.
  struct Side
  {
    Input_halfedge_index face;
    Weights middle = {{0, 0, 0}}, apex = {{0, 0, 0}};
  };

  const Triangulation& triangulation() const { return m_overlay->triangulation(); }

  Weights middle_of(Overlay_halfedge h) const
  {
    const Weights &p = m_weights[h], &q = m_weights[m_overlay->next(h)];
    return {{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}};
  }

  void add_edge(Input_halfedge_index face, const Weights& from, Input_halfedge_index face_of_twin, const Weights& to)
  {
    m_faces.insert(m_faces.end(), {face, face_of_twin});
    m_weights.insert(m_weights.end(), {from, to});
  }

  void add_midpoint(Overlay_halfedge h, const Side& side)
  {
    const auto& input = triangulation().input();
    const Input_halfedge_index f = side.face, fn = input.next(f), along = m_overlay->input_halfedge(h);
    const Halfedge_index intrinsic = m_overlay->intrinsic_halfedge(h);
    const Overlay_vertex from = m_overlay->origin(h), to = m_overlay->target(h);
    const double first = m_overlay->is_crossing(from) ? on_intrinsic(from) : 0,
                 last = m_overlay->is_crossing(to) ? on_intrinsic(to) : 1;
    m_midpoints.push_back({surface_point({{input.tail(f), input.tail(fn), input.tail(input.next(fn))}}, side.middle,
                                         along == null_index ? f : along),
                           intrinsic, (first + last) / 2});
  }

  std::size_t number(Overlay_vertex v) const
  {
    return static_cast<std::size_t>(v.idx() - triangulation().number_of_vertices());
  }

  // Each polygon has a piece of an intrinsic edge among its sides.
  void find_intrinsic_faces()
  {
    m_intrinsic_faces.assign(m_faces.size(), null_index);
    m_overlay->for_each_polygon([&](Overlay_halfedge h) {
      Overlay_halfedge piece = h;
      while(m_overlay->intrinsic_halfedge(piece) == null_index)
        piece = m_overlay->next(piece);
      const Halfedge_index side = m_overlay->intrinsic_halfedge(piece), after = triangulation().next(side);
      const Halfedge_index face = (std::min)({side, after, triangulation().next(after)});
      m_overlay->for_each_side(h, [&](Overlay_halfedge s) { m_intrinsic_faces[s] = face; });
    });
  }

  void measure_crossings()
  {
    for(Edge_index e : descriptors<Edge_index>(triangulation().number_of_edges())) {
      if(m_overlay->crossings(e) == 0)
        continue;
      const Strip<Triangulation> strip(triangulation(), triangulation().edge_sequence(first_side(e)));
      double along = 0;
      for(std::size_t i = 0; i < strip.portals().size(); ++i) {
        along = (std::max)(along, strip.crossing_along(i));
        m_crossings.push_back({strip.crossing(i), along, first_side(e)});
      }
    }
  }

  void raise_to_order()
  {
    for(Overlay_halfedge h : m_overlay->halfedges()) {
      const Input_halfedge_index c = m_overlay->input_halfedge(h);
      if(c == null_index || !is_first_side(c) || m_overlay->is_crossing(m_overlay->origin(h)))
        continue;
      double reached = position_on_side(Vertex_index(m_overlay->origin(h).idx()));
      for(Overlay_halfedge arc = h; m_overlay->is_crossing(m_overlay->target(arc)); arc = m_overlay->next_arc(arc)) {
        const Overlay_vertex v = m_overlay->target(arc);
        const bool is_along = m_overlay->crossed_halfedge(v) == c;
        double& t = m_crossings[number(v)].on_input;
        reached = (std::max)(reached, is_along ? t : 1 - t);
        if(reached > (is_along ? t : 1 - t))
          t = is_along ? reached : 1 - reached;
      }
    }
  }

  // The position of a vertex of the triangulation on the input edge that it starts or divides, from 0 at the tail of
  // the edge's first halfedge. Surface points refer to that halfedge unless it is on the border, where there are no
  // crossings.
  double position_on_side(Vertex_index v) const
  {
    if(!triangulation().is_inserted(v))
      return 0;
    const Surface_location at = triangulation().location(v);
    return at.weights[1] / (at.weights[0] + at.weights[1]);
  }

  // The origin of h lies on a side of the input face, which follows from the edge along which h runs, or is an inserted
  // vertex.
  Weights measure_corner(Overlay_halfedge h) const
  {
    const auto& input = triangulation().input();
    const Overlay_vertex v = m_overlay->origin(h);
    const Input_halfedge_index along = m_overlay->input_halfedge(h);
    if(!m_overlay->is_crossing(v)) {
      const bool is_told_by_crossing = along != null_index || m_overlay->is_crossing(m_overlay->target(h));
      if(triangulation().is_inserted(Vertex_index(v.idx())) || !is_told_by_crossing)
        return normalized(vertex_weights(triangulation(), Vertex_index(v.idx()), m_faces[h]));
      const Input_halfedge_index corner = along != null_index ? along : input.next(input.next(leaving_through(h)));
      return on_side(m_faces[h], corner, 0);
    }
    const Input_halfedge_index crossed = m_overlay->crossed_halfedge(v);
    const double t = on_input(v);
    if(along != null_index)
      return on_side(m_faces[h], along, along == crossed ? t : 1 - t);
    const bool is_entering = is_first_side(m_overlay->intrinsic_halfedge(h)); // the face beyond the crossed edge
    return on_side(m_faces[h], is_entering ? twin_index(crossed) : crossed, is_entering ? 1 - t : t);
  }

  // The side of the face through which an intrinsic edge that starts at a corner leaves it.
  Input_halfedge_index leaving_through(Overlay_halfedge h) const
  {
    const Input_halfedge_index crossed = m_overlay->crossed_halfedge(m_overlay->target(h));
    return is_first_side(m_overlay->intrinsic_halfedge(h)) ? crossed : twin_index(crossed);
  }

  static Weights normalized(const Weights& w)
  {
    const double sum = w[0] + w[1] + w[2];
    return {{w[0] / sum, w[1] / sum, w[2] / sum}};
  }

  Weights on_side(Input_halfedge_index f, Input_halfedge_index side, double t) const
  {
    const auto& input = triangulation().input();
    Weights weights = {0, 0, 0};
    for(int i = 0; i < 3; ++i, f = input.next(f))
      if(f == side) {
        weights[i] = 1 - t;
        weights[(i + 1) % 3] = t;
      }
    return weights;
  }

  const Overlay* m_overlay;
  Per_overlay_halfedge<Input_halfedge_index> m_faces;
  Per_overlay_halfedge<Halfedge_index> m_intrinsic_faces;
  Per_overlay_halfedge<Weights> m_weights;
  std::vector<Crossing> m_crossings;
  std::vector<Midpoint> m_midpoints;
};

/*
 * Triangulates the polygons of an overlay, which are convex up to rounding errors, by diagonals. Dynamic programming
 * finds the triangulation whose worst triangle is best [Klincsek, Minimal Triangulations of Polygonal Domains].
 *
 * No diagonal connects two vertices of one straight line, that is, of a run of sides along one edge. Labels decide
 * this, not positions, so that the result has no double edges, whatever the rounding errors are.
 */
template <class Triangulation>
class Polygon_triangulator
{
  using Overlay = internal::Overlay<Triangulation>;
  using Layout = Overlay_layout<Triangulation>;
  using Point_2 = typename Layout::Point_2;

public:
  Polygon_triangulator(Overlay& overlay, Layout& layout)
    : m_overlay(overlay)
    , m_layout(layout)
  {
  }

  /* Triangulates all polygons in time cubic in the number of sides of each, which is rarely more than six. */
  void operator()()
  {
    std::vector<Overlay_halfedge> polygons;
    m_overlay.for_each_polygon([&](Overlay_halfedge h) { polygons.push_back(h); });
    for(Overlay_halfedge h : polygons)
      triangulate(h);
  }

private:
  // Larger polygons are halved first; their many vertices lie on straight lines.
  static constexpr std::size_t largest = 32;

  void triangulate(Overlay_halfedge h)
  {
    std::vector<Overlay_halfedge> sides;
    m_overlay.for_each_side(h, [&](Overlay_halfedge side) { sides.push_back(side); });
    if(sides.size() <= 3)
      return;
    find_runs(sides);
    if(sides.size() > largest && halve(sides))
      return;
    m_points.clear();
    const auto corners = m_layout.corners(m_layout.face(h));
    for(Overlay_halfedge side : sides)
      m_points.push_back(Layout::point(corners, m_layout.weights(side)));
    find_best(sides.size());
    add_diagonals(sides, 0, sides.size() - 1, sides.back());
  }

  bool is_on_one_line(Overlay_halfedge side, Overlay_halfedge other) const
  {
    const Input_halfedge_index input = m_overlay.input_halfedge(side);
    const Halfedge_index intrinsic = m_overlay.intrinsic_halfedge(side);
    return (input != null_index && input == m_overlay.input_halfedge(other)) ||
           (intrinsic != null_index && intrinsic == m_overlay.intrinsic_halfedge(other));
  }

  // Computes for each side the number of consecutive sides on one line, starting with it.
  void find_runs(const std::vector<Overlay_halfedge>& sides)
  {
    const std::size_t n = sides.size();
    m_runs.assign(n, 1);
    for(std::size_t i = 0; i < n; ++i)
      while(m_runs[i] < n && is_on_one_line(sides[i], sides[(i + m_runs[i]) % n]))
        ++m_runs[i];
  }

  bool is_diagonal(std::size_t i, std::size_t j) const // i < j
  {
    return m_runs[i] < j - i && m_runs[j] < m_runs.size() - (j - i);
  }

  bool halve(const std::vector<Overlay_halfedge>& sides)
  {
    const std::size_t n = sides.size(), half = n / 2;
    for(std::size_t i = 0; i < n - half; ++i)
      if(is_diagonal(i, i + half)) {
        const Overlay_halfedge d = add_diagonal(sides[i], sides[i + half]);
        triangulate(d);
        triangulate(Overlay::twin(d));
        return true;
      }
    return false;
  }

  // m_best of (i, j) is the quality of the worst triangle of the best triangulation of the vertices i to j.
  void find_best(std::size_t n)
  {
    constexpr double none = -std::numeric_limits<double>::infinity();
    m_best.assign(n * n, none);
    m_apex.assign(n * n, 0);
    for(std::size_t i = 0; i + 1 < n; ++i)
      m_best[i * n + i + 1] = (std::numeric_limits<double>::max)();
    for(std::size_t width = 2; width < n; ++width)
      for(std::size_t i = 0; i + width < n; ++i) {
        const std::size_t j = i + width;
        if(width + 1 < n && !is_diagonal(i, j))
          continue;
        for(std::size_t k = i + 1; k < j; ++k) {
          const double worst = (std::min)({m_best[i * n + k], m_best[k * n + j], quality(i, k, j)});
          if(worst > m_best[i * n + j] || m_apex[i * n + j] == 0) {
            m_best[i * n + j] = worst;
            m_apex[i * n + j] = k;
          }
        }
      }
  }

  // Twice the area over the sum of the squared sides; negative if rounding errors have turned the triangle over.
  double quality(std::size_t i, std::size_t j, std::size_t k) const
  {
    const auto difference = [](const Point_2& p, const Point_2& q) { return Point_2{q[0] - p[0], q[1] - p[1]}; };
    const auto square = [](const Point_2& v) { return v[0] * v[0] + v[1] * v[1]; };
    const Point_2 u = difference(m_points[i], m_points[j]), v = difference(m_points[i], m_points[k]);
    const double sum = square(u) + square(v) + square(difference(m_points[j], m_points[k]));
    return sum > 0 ? (u[0] * v[1] - u[1] * v[0]) / sum : 0;
  }

  // Sides i to j - 1 and `closing`, which leads from vertex j to vertex i, form a polygon of the overlay.
  void add_diagonals(const std::vector<Overlay_halfedge>& sides, std::size_t i, std::size_t j, Overlay_halfedge closing)
  {
    if(j - i < 2)
      return;
    const std::size_t k = m_apex[i * sides.size() + j];
    if(k - i > 1)
      add_diagonals(sides, i, k, Overlay::twin(add_diagonal(sides[i], sides[k])));
    if(j - k > 1)
      add_diagonals(sides, k, j, Overlay::twin(add_diagonal(sides[k], closing)));
  }

  Overlay_halfedge add_diagonal(Overlay_halfedge a, Overlay_halfedge b)
  {
    const Overlay_halfedge d = m_overlay.add_diagonal(a, b);
    m_layout.add_diagonal(a, b);
    return d;
  }

  Overlay& m_overlay;
  Layout& m_layout;
  std::vector<Point_2> m_points;
  std::vector<std::size_t> m_runs, m_apex;
  std::vector<double> m_best;
};

/*
 * Constructs a MutableFaceGraph from an overlay, link by link, so that no searches are needed and edges with common end
 * vertices are supported. The elements of the mesh are created in the order of those of the overlay.
 */
template <class Triangulation, class OutputMesh>
class Overlay_to_mesh
{
  using Overlay = internal::Overlay<Triangulation>;
  using Graph = boost::graph_traits<OutputMesh>;

public:
  using vertex_descriptor = typename Graph::vertex_descriptor;
  using halfedge_descriptor = typename Graph::halfedge_descriptor;
  using face_descriptor = typename Graph::face_descriptor;

  Overlay_to_mesh(const Overlay& overlay, OutputMesh& mesh)
    : m_overlay(overlay)
    , m_mesh(mesh)
    , m_vertices(static_cast<std::size_t>(overlay.number_of_vertices()), Graph::null_vertex())
    , m_halfedges(static_cast<std::size_t>(overlay.number_of_halfedges()), Graph::null_halfedge())
  {
    create_vertices();
    create_edges();
    create_faces();
    link_border();
  }

  /* Returns the mesh's vertex for a vertex of the overlay, or the null vertex if it was dissolved. */
  vertex_descriptor vertex(Overlay_vertex v) const { return m_vertices[v]; }
  /* Returns the mesh's halfedge for a halfedge of the overlay, or the null halfedge if it was dissolved. */
  halfedge_descriptor halfedge(Overlay_halfedge h) const { return m_halfedges[h]; }

private:
  // Creates all but the crossings and inserted vertices that were dissolved.
  void create_vertices()
  {
    Per_overlay_vertex<char> is_used(m_vertices.size(), 0);
    for(Overlay_halfedge h : m_overlay.halfedges())
      if(m_overlay.is_alive(h))
        is_used[m_overlay.origin(h)] = 1;
    for(Overlay_vertex v : m_overlay.vertices())
      if(is_used[v] != 0 || m_overlay.is_input_vertex(v)) {
        m_vertices[v] = add_vertex(m_mesh);
        set_halfedge(m_vertices[v], Graph::null_halfedge(), m_mesh);
      }
  }

  void create_edges()
  {
    for(Overlay_halfedge h : m_overlay.halfedges()) {
      if(!is_first_side(h) || !m_overlay.is_alive(h))
        continue;
      const Overlay_halfedge t = Overlay::twin(h);
      m_halfedges[h] = graph_halfedge(add_edge(m_mesh), m_mesh);
      m_halfedges[t] = opposite(m_halfedges[h], m_mesh);
      set_target(m_halfedges[h], m_vertices[m_overlay.target(h)], m_mesh);
      set_target(m_halfedges[t], m_vertices[m_overlay.origin(h)], m_mesh);
    }
  }

  void create_faces()
  {
    m_overlay.for_each_polygon([&](Overlay_halfedge h) {
      const face_descriptor f = add_face(m_mesh);
      set_halfedge(f, m_halfedges[h], m_mesh);
      m_overlay.for_each_side(h, [&](Overlay_halfedge side) {
        set_face(m_halfedges[side], f, m_mesh);
        set_next(m_halfedges[side], m_halfedges[m_overlay.next(side)], m_mesh);
        set_halfedge(m_vertices[m_overlay.target(side)], m_halfedges[side], m_mesh);
      });
    });
  }

  // Vertices on the border refer to a halfedge there, as `Surface_mesh` requires.
  void link_border()
  {
    for(Overlay_halfedge h : m_overlay.halfedges()) {
      if(!m_overlay.is_alive(h) || !m_overlay.is_border(h))
        continue;
      Overlay_halfedge after = Overlay::twin(h); // turns around the target of h
      while(!m_overlay.is_border(after))
        after = Overlay::twin(m_overlay.previous(after));
      set_face(m_halfedges[h], Graph::null_face(), m_mesh);
      set_next(m_halfedges[h], m_halfedges[after], m_mesh);
      set_halfedge(m_vertices[m_overlay.target(h)], m_halfedges[h], m_mesh);
    }
  }

  const Overlay& m_overlay;
  OutputMesh& m_mesh;
  Per_overlay_vertex<vertex_descriptor> m_vertices;
  Per_overlay_halfedge<halfedge_descriptor> m_halfedges;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_LAYOUT_H
