// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_CURVE_INSERTION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_CURVE_INSERTION_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Nearest_face.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * The constrained Delaunay triangulation of a face, given by nodes and segments between them. Crossing segments get a
 * vertex at the crossing. Coordinates and predicates are exact. Nodes are numbers that the caller assigns.
 */
class Face_arrangement
{
public:
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Point_2 = Kernel::Point_2;
  using Segment = std::array<std::size_t, 2>;
  using Triangle = std::array<std::size_t, 3>;

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /* Adds a node. Returns the node at this point, which is another one if it was added before. */
  std::size_t add_node(std::size_t node, const Point_2& p)
  {
    const Vertex_handle v = m_triangulation.insert(p);
    if(v->info().node == none) {
      v->info().node = node;
      m_vertices[node] = v;
    }
    return v->info().node;
  }

  /* Adds the segment between two different nodes. */
  void add_segment(std::size_t a, std::size_t b)
  {
    m_constraints.push_back(m_triangulation.insert_constraint(m_vertices.at(a), m_vertices.at(b)));
  }

  /* Calls `make_node` for the point of each crossing, which must return a new node. */
  template <class MakeNode>
  void add_crossings(const MakeNode& make_node)
  {
    for(auto v = m_triangulation.finite_vertices_begin(); v != m_triangulation.finite_vertices_end(); ++v)
      if(v->info().node == none)
        v->info().node = make_node(v->point());
  }

  /* Returns the segments, divided at all nodes that they pass, each once and with the smaller node first. */
  std::vector<Segment> segments() const
  {
    std::set<Segment> result;
    for(const Constraint_id& id : m_constraints)
      for(auto v = m_triangulation.vertices_in_constraint_begin(id);;) {
        const std::size_t a = (*v)->info().node;
        if(++v == m_triangulation.vertices_in_constraint_end(id))
          break;
        const std::size_t b = (*v)->info().node;
        result.insert({{(std::min)(a, b), (std::max)(a, b)}});
      }
    return std::vector<Segment>(result.begin(), result.end());
  }

  /* Returns the triangles, counterclockwise. */
  std::vector<Triangle> triangles() const
  {
    std::vector<Triangle> result;
    for(auto f = m_triangulation.finite_faces_begin(); f != m_triangulation.finite_faces_end(); ++f)
      result.push_back({{f->vertex(0)->info().node, f->vertex(1)->info().node, f->vertex(2)->info().node}});
    return result;
  }

private:
  struct Numbered
  {
    std::size_t node = none;
  };
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Numbered, Kernel>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Data_structure = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
  using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data_structure, CGAL::Exact_intersections_tag>;
  using Triangulation = CGAL::Constrained_triangulation_plus_2<Delaunay>;
  using Vertex_handle = Triangulation::Vertex_handle;
  using Constraint_id = Triangulation::Constraint_id;

  Triangulation m_triangulation;
  std::map<std::size_t, Vertex_handle> m_vertices;
  std::vector<Constraint_id> m_constraints;
};

/*
 * Divides faces of a mesh along segments. Points are first collected as nodes: vertices of the mesh, points of edges,
 * and points inside faces. Segments are stored with the faces that contain them. `arrange()` computes the subdivision
 * of each face without changing the mesh. `apply()` changes the mesh; it throws only if memory runs out.
 */
template <class Mesh, class PointMap>
class Curve_insertion
{
  using Graph = boost::graph_traits<Mesh>;
  using Vertex = typename Graph::vertex_descriptor;
  using Halfedge = typename Graph::halfedge_descriptor;
  using Face = typename Graph::face_descriptor;
  using Point = typename boost::property_traits<PointMap>::value_type;
  using Number = typename Kernel_traits<Point>::Kernel::FT;
  using Exact = Face_arrangement::Kernel::FT;
  using Point_2 = Face_arrangement::Point_2;
  using Segment = Face_arrangement::Segment;

public:
  static constexpr std::size_t none = Face_arrangement::none;

  Curve_insertion(Mesh& mesh, const PointMap& points, double snap)
    : m_mesh(mesh)
    , m_points(points)
    , m_snap(snap)
  {
  }

  /* Returns the corners of a face, the sources of its halfedges. Throws unless it is a triangle with finite
   * coordinates. */
  Triangle_places places_of_corners(Face f) const
  {
    Triangle_places result;
    Halfedge h = check_triangle(f);
    for(Place_in_space& p : result) {
      const auto v = source(h, m_mesh);
      p = half_of(get(m_points, v));
      if(!are_finite(p)) {
        const auto all = vertices(m_mesh);
        const auto position =
            static_cast<std::size_t>(std::distance(all.begin(), std::find(all.begin(), all.end(), v)));
        throw_naming<Invalid_coordinate_error>(
            "vertex ", Element{position},
            ", a corner of a face that a curve enters, has a coordinate that is not a "
            "finite number");
      }
      h = next(h, m_mesh);
    }
    return result;
  }

  /* Returns the node at a point of a face with weights that are not negative and not all zero. For a point inside the
   * face, the given weights are used, which may be exact. */
  template <class Weights>
  std::size_t add_point(Face f, const std::array<double, 3>& weights, const Weights& given)
  {
    face_record(f);
    const auto zeros = std::count(weights.begin(), weights.end(), 0.0);
    std::array<Halfedge, 3> sides = sides_of(f);
    if(zeros == 0)
      return add_inside(f, {{exact(given[0]), exact(given[1]), exact(given[2])}});
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      if(zeros == 2 && weights[i] != 0)
        return node_of_vertex(source(sides[i], m_mesh));
      if(zeros == 1 && weights[k] == 0)
        return add_on_edge(sides[i], weights[i], weights[j]);
    }
    return none;
  }

  /* Adds a segment between two nodes to the first face with both of them, among the given faces and those around the
   * nodes. Returns whether such a face exists. */
  bool add_segment(std::size_t a, std::size_t b, const std::array<Face, 2>& hints)
  {
    if(root(a) == root(b))
      return true;
    std::vector<Face> candidates(hints.begin(), hints.end());
    append_faces(a, candidates);
    append_faces(b, candidates);
    for(const Face f : candidates)
      if(is_in_closure(a, f) && is_in_closure(b, f)) {
        face_record(f).segments.push_back({{a, b}});
        return true;
      }
    return false;
  }

  /* Appends the faces that contain a node. */
  void append_faces(std::size_t n, std::vector<Face>& result) const
  {
    const Node& node = m_nodes[root(n)];
    const auto append = [&](Halfedge h) {
      if(face(h, m_mesh) != Graph::null_face())
        result.push_back(face(h, m_mesh));
    };
    if(node.kind == Location_kind::FACE)
      return result.push_back(node.face);
    if(node.kind == Location_kind::EDGE) {
      append(node.halfedge);
      return append(opposite(node.halfedge, m_mesh));
    }
    for(const Halfedge h : halfedges_around_target(halfedge(node.vertex, m_mesh), m_mesh))
      append(h);
  }

  /* Merges nodes that are too close to each other, and triangulates the faces. */
  void arrange()
  {
    for(std::size_t round = 0, open = 1; open > 0 && round < most_rounds; ++round) {
      open = 0;
      for(std::size_t i = 0; i < m_faces.size(); ++i)
        if(!m_faces[i].is_arranged && refine(i))
          ++open;
    }
    for(const Edge& e : std::vector<Edge>(m_edges))
      for(const Halfedge h : {e.halfedge, opposite(e.halfedge, m_mesh)})
        if(!e.nodes.empty() && face(h, m_mesh) != Graph::null_face())
          face_record(face(h, m_mesh));
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      if(!m_faces[i].is_arranged)
        arrange_face(i);
  }

  /* Splits the edges and divides the faces of the mesh. */
  template <class IsConstrainedMap, class Visitor>
  void apply(IsConstrainedMap is_constrained, Visitor& visitor)
  {
    for(const Edge& e : m_edges)
      split(e, is_constrained, visitor);
    for(const Face_record& f : m_faces)
      divide(f, is_constrained, visitor);
  }

  std::size_t number_of_new_vertices() const { return m_number_of_new_vertices; }
  std::size_t number_of_divided_faces() const { return m_number_of_divided_faces; }
  std::size_t number_of_new_faces() const { return m_number_of_new_faces; }

private:
  // The number of rounds of merging, each of which shortens or removes segments; afterwards close nodes stay.
  static constexpr std::size_t most_rounds = 32;

  struct Node
  {
    Location_kind kind = Location_kind::VERTEX;
    std::size_t same_as = none;                 // the node with which it was merged
    Vertex vertex = Graph::null_vertex();       // of the mesh, once it exists
    Halfedge halfedge = Graph::null_halfedge(); // as returned by `canonical()`, for a node on an edge
    double t = 0;                               // the position on the edge, from 0 at its source to 1
    Face face = Graph::null_face();             // for a node inside a face
    std::array<Exact, 3> weights;               // the position in the face; they sum to one
  };

  struct Edge
  {
    Halfedge halfedge;
    double tolerance;               // of t
    std::vector<std::size_t> nodes; // by t
  };

  struct Face_record
  {
    Face face;
    std::array<Halfedge, 3> sides;
    std::array<Vertex, 3> vertices;               // the sources of the sides
    std::array<std::array<double, 2>, 3> corners; // of the face, laid out in a plane, counterclockwise
    double tolerance;                             // there
    std::vector<Segment> segments;                // between nodes
    std::vector<std::size_t> inner_nodes;
    std::vector<Face_arrangement::Triangle> triangles;
    bool is_arranged = false; // whether segments and triangles correspond to the nodes
  };

  Halfedge check_triangle(Face f) const
  {
    const Halfedge h = halfedge(f, m_mesh);
    if(next(next(next(h, m_mesh), m_mesh), m_mesh) != h || next(h, m_mesh) == h) {
      const Indexed_mesh<Mesh> input(m_mesh);
      throw_no_triangle(input, input.index(h));
    }
    return h;
  }

  std::array<Halfedge, 3> sides_of(Face f) const
  {
    const Halfedge h = halfedge(f, m_mesh);
    return {{h, next(h, m_mesh), next(next(h, m_mesh), m_mesh)}};
  }

  // Returns the smaller halfedge of an edge. The result of `halfedge()` depends on how a Surface_mesh created the edge.
  Halfedge canonical(Halfedge h) const
  {
    const Halfedge t = opposite(h, m_mesh);
    return t < h ? t : h;
  }

  std::size_t root(std::size_t n) const
  {
    while(m_nodes[n].same_as != none)
      n = m_nodes[n].same_as;
    return n;
  }

  std::size_t add_node(const Node& node)
  {
    m_nodes.push_back(node);
    return m_nodes.size() - 1;
  }

  std::size_t node_of_vertex(Vertex v)
  {
    const auto [at, is_new] = m_node_of_vertex.insert({v, m_nodes.size()});
    if(is_new) {
      Node node;
      node.vertex = v;
      add_node(node);
    }
    return at->second;
  }

  std::size_t add_inside(Face f, const std::array<Exact, 3>& weights)
  {
    Node node;
    node.kind = Location_kind::FACE;
    node.face = f;
    const Exact sum = weights[0] + weights[1] + weights[2];
    for(std::size_t i = 0; i < 3; ++i) {
      node.weights[i] = weights[i] / sum;
      CGAL::exact(node.weights[i]); // so that lazy numbers do not refer to their operands
    }
    face_record(f).inner_nodes.push_back(m_nodes.size());
    face_record(f).is_arranged = false;
    return add_node(node);
  }

  template <class Weight>
  static Exact exact(const Weight& x)
  {
    if constexpr(std::is_same<Weight, Exact>::value)
      return x;
    else if constexpr(is_rational_number<Weight>)
      return from_rational<Exact>(to_rational(x));
    else
      return Exact(CGAL::to_double(x));
  }

  // Returns the node of an edge at weights of the source and the target of a halfedge, or one within the tolerance.
  std::size_t add_on_edge(Halfedge h, double at_source, double at_target)
  {
    if(canonical(h) != h) {
      h = opposite(h, m_mesh);
      std::swap(at_source, at_target);
    }
    const double t = at_target / (at_source + at_target);
    Edge& e = edge_record(h);
    if(t <= e.tolerance)
      return node_of_vertex(source(h, m_mesh));
    if(1 - t <= e.tolerance)
      return node_of_vertex(target(h, m_mesh));
    const auto at = std::lower_bound(e.nodes.begin(), e.nodes.end(), t,
                                     [&](std::size_t n, double value) { return m_nodes[n].t < value; });
    if(at != e.nodes.end() && m_nodes[*at].t - t <= e.tolerance)
      return *at;
    if(at != e.nodes.begin() && t - m_nodes[*(at - 1)].t <= e.tolerance)
      return *(at - 1);
    Node node;
    node.kind = Location_kind::EDGE;
    node.halfedge = h;
    node.t = t;
    e.nodes.insert(at, m_nodes.size());
    for(const Halfedge side : {h, opposite(h, m_mesh)})
      if(const auto f = m_record_of_face.find(face(side, m_mesh)); f != m_record_of_face.end())
        m_faces[f->second].is_arranged = false;
    return add_node(node);
  }

  double largest_coordinate(Halfedge h) const
  {
    double result = 0;
    for(const Vertex v : {source(h, m_mesh), target(h, m_mesh)})
      for(const double x : half_of(get(m_points, v)))
        result = (std::max)(result, 2 * std::abs(x));
    return result;
  }

  double length(Halfedge h) const
  {
    const Place_in_space d =
        difference(half_of(get(m_points, target(h, m_mesh))), half_of(get(m_points, source(h, m_mesh))));
    return 2 * std::hypot(d[0], d[1], d[2]);
  }

  // Returns the distance in space up to which points of an edge or face of a given length are merged; 0 if none are.
  double tolerance(double length, double largest_coordinate) const
  {
    return m_snap > 0 ? m_snap * length + insertion_rounding * largest_coordinate : 0;
  }

  Edge& edge_record(Halfedge h)
  {
    const auto [at, is_new] = m_record_of_edge.insert({h, m_edges.size()});
    if(is_new) {
      const double l = length(h), close = tolerance(l, largest_coordinate(h));
      m_edges.push_back({h, close < l ? close / l : (close > 0 ? 1 : 0), {}});
    }
    return m_edges[at->second];
  }

  Face_record& face_record(Face f)
  {
    const auto found = m_record_of_face.find(f);
    if(found != m_record_of_face.end())
      return m_faces[found->second];
    places_of_corners(f);
    Face_record record;
    record.face = f;
    record.sides = sides_of(f);
    for(std::size_t i = 0; i < 3; ++i)
      record.vertices[i] = source(record.sides[i], m_mesh);
    lay_out(record);
    m_record_of_face[f] = m_faces.size();
    m_faces.push_back(record);
    return m_faces.back();
  }

  // The shape affects the quality of the triangles only, not the crossings, so that a degenerate face gets another one.
  void lay_out(Face_record& f) const
  {
    const double a = length(f.sides[0]), b = length(f.sides[1]), c = length(f.sides[2]);
    const double x = ((c - b) * (c + b) + a * a) / (2 * a), y = std::sqrt((c - x) * (c + x));
    const double longest = (std::max)({a, b, c});
    if(std::isfinite(x) && std::isfinite(a) && y > 0) {
      f.corners = {{{{0, 0}}, {{a, 0}}, {{x, y}}}};
      f.tolerance = tolerance(longest, (std::max)(largest_coordinate(f.sides[0]), largest_coordinate(f.sides[1])));
    } else {
      f.corners = {{{{0, 0}}, {{1, 0}}, {{0, 1}}}};
      f.tolerance = m_snap;
    }
  }

  bool is_in_closure(std::size_t n, Face f) const
  {
    const Node& node = m_nodes[root(n)];
    if(node.kind == Location_kind::FACE)
      return node.face == f;
    for(const Halfedge h : sides_of(f))
      if(node.kind == Location_kind::VERTEX ? source(h, m_mesh) == node.vertex : canonical(h) == node.halfedge)
        return true;
    return false;
  }

  // ---- Faces in the plane

  std::array<Exact, 3> weights(const Face_record& f, std::size_t n) const
  {
    const Node& node = m_nodes[n];
    if(node.kind == Location_kind::FACE)
      return node.weights;
    std::array<Exact, 3> result = {{0, 0, 0}};
    for(std::size_t i = 0; i < 3; ++i) {
      if(node.kind == Location_kind::VERTEX && f.vertices[i] == node.vertex)
        result[i] = 1;
      if(node.kind == Location_kind::EDGE && canonical(f.sides[i]) == node.halfedge) {
        const bool is_forward = f.sides[i] == node.halfedge;
        result[(i + 1) % 3] = is_forward ? Exact(node.t) : 1 - Exact(node.t);
        result[i] = 1 - result[(i + 1) % 3];
      }
    }
    return result;
  }

  Point_2 position(const Face_record& f, std::size_t n) const
  {
    const std::array<Exact, 3> w = weights(f, n); // corner 0 is the origin, and corner 1 on the first axis
    return Point_2(w[1] * f.corners[1][0] + w[2] * f.corners[2][0], w[2] * f.corners[2][1]);
  }

  std::array<Exact, 3> weights_at(const Face_record& f, const Point_2& p) const
  {
    std::array<Exact, 3> result;
    result[2] = p.y() / f.corners[2][1];
    result[1] = (p.x() - result[2] * f.corners[2][0]) / f.corners[1][0];
    result[0] = 1 - result[1] - result[2];
    return result;
  }

  std::vector<std::size_t> nodes_of(std::size_t i)
  {
    std::vector<std::size_t> result;
    for(const Vertex v : m_faces[i].vertices)
      result.push_back(node_of_vertex(v));
    for(const Halfedge h : m_faces[i].sides)
      if(const auto e = m_record_of_edge.find(canonical(h)); e != m_record_of_edge.end())
        result.insert(result.end(), m_edges[e->second].nodes.begin(), m_edges[e->second].nodes.end());
    for(const std::size_t n : m_faces[i].inner_nodes)
      if(root(n) == n)
        result.push_back(n);
    return result;
  }

  void arrange_face(std::size_t i)
  {
    Face_arrangement arrangement;
    for(const std::size_t n : nodes_of(i)) {
      const std::size_t other = arrangement.add_node(n, position(m_faces[i], n));
      if(other != n)
        m_nodes[n].same_as = other;
    }
    for(const Segment& s : m_faces[i].segments)
      if(root(s[0]) != root(s[1]))
        arrangement.add_segment(root(s[0]), root(s[1]));
    arrangement.add_crossings([&](const Point_2& p) { return add_inside(m_faces[i].face, weights_at(m_faces[i], p)); });
    m_faces[i].segments = arrangement.segments();
    m_faces[i].triangles = arrangement.triangles();
    m_faces[i].is_arranged = true;
  }

  // ---- Nodes and segments that are too close to each other

  using Place_2 = std::array<double, 2>;

  static double distance(const Place_2& p, const Place_2& q) { return std::hypot(q[0] - p[0], q[1] - p[1]); }

  // Returns the position of the projection of p on a segment, from 0 to 1, and its distance from p.
  static std::pair<double, double> projection(const Place_2& p, const Place_2& from, const Place_2& to)
  {
    const double dx = to[0] - from[0], dy = to[1] - from[1];
    const double t = ((p[0] - from[0]) * dx + (p[1] - from[1]) * dy) / (dx * dx + dy * dy);
    return {t, distance(p, {{from[0] + t * dx, from[1] + t * dy}})};
  }

  // Arranges a face, and then merges nodes that are too close. Returns whether there were any.
  bool refine(std::size_t i)
  {
    arrange_face(i);
    if(!(m_faces[i].tolerance > 0) || m_faces[i].segments.empty())
      return false;
    std::vector<std::size_t> nodes = nodes_of(i);
    std::map<std::size_t, Place_2> places;
    for(const std::size_t n : nodes) {
      const Point_2 p = position(m_faces[i], n);
      places[n] = {{CGAL::to_double(p.x()), CGAL::to_double(p.y())}};
    }
    const bool is_changed = merge_inner_nodes(i, nodes, places) || bend_segments(i, nodes, places);
    if(is_changed)
      m_faces[i].is_arranged = false;
    return is_changed;
  }

  // Merges nodes inside a face with earlier ones, or else moves them to the sides.
  bool merge_inner_nodes(std::size_t i, const std::vector<std::size_t>& nodes,
                         const std::map<std::size_t, Place_2>& places)
  {
    const double close = m_faces[i].tolerance;
    bool is_changed = false;
    for(std::size_t j = 0; j < nodes.size(); ++j) {
      if(m_nodes[nodes[j]].kind != Location_kind::FACE)
        continue;
      const Place_2 p = places.at(nodes[j]);
      const auto other =
          std::find_if(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(j),
                       [&](std::size_t n) { return root(n) == n && distance(places.at(n), p) <= close; });
      std::size_t same = other - nodes.begin() < static_cast<std::ptrdiff_t>(j) ? *other : none;
      for(std::size_t k = 0; same == none && k < 3; ++k) {
        const auto [t, d] = projection(p, m_faces[i].corners[k], m_faces[i].corners[(k + 1) % 3]);
        if(d <= close)
          same = add_on_edge(m_faces[i].sides[k], (std::min)((std::max)(1 - t, 0.0), 1.0),
                             (std::min)((std::max)(t, 0.0), 1.0));
      }
      if(same != none) {
        m_nodes[nodes[j]].same_as = same;
        is_changed = true;
      }
    }
    return is_changed;
  }

  bool are_on_one_side(const Face_record& f, std::size_t a, std::size_t b) const
  {
    const auto is_on = [&](std::size_t n, Halfedge h) {
      const Node& node = m_nodes[n];
      return (node.kind == Location_kind::EDGE && node.halfedge == canonical(h)) ||
             (node.kind == Location_kind::VERTEX &&
              (node.vertex == source(h, m_mesh) || node.vertex == target(h, m_mesh)));
    };
    return std::any_of(f.sides.begin(), f.sides.end(), [&](Halfedge h) { return is_on(a, h) && is_on(b, h); });
  }

  // Leads segments that pass a node too closely through it.
  bool bend_segments(std::size_t i, const std::vector<std::size_t>& nodes, const std::map<std::size_t, Place_2>& places)
  {
    Face_record& f = m_faces[i];
    std::vector<Segment> result;
    bool is_changed = false;
    for(const Segment& s : f.segments) {
      std::vector<std::pair<double, std::size_t>> passed;
      if(!are_on_one_side(f, s[0], s[1]))
        for(const std::size_t n : nodes) {
          const auto [t, d] = projection(places.at(n), places.at(s[0]), places.at(s[1]));
          if(n != s[0] && n != s[1] && t > 0 && t < 1 && d <= f.tolerance)
            passed.push_back({t, n});
        }
      std::sort(passed.begin(), passed.end());
      is_changed = is_changed || !passed.empty();
      std::size_t last = s[0];
      for(const auto& [t, n] : passed) {
        result.push_back({{last, n}});
        last = n;
      }
      result.push_back({{last, s[1]}});
    }
    f.segments = result;
    return is_changed;
  }

  // ---- The mesh

  static Number number(const Exact& x)
  {
    if constexpr(std::is_same<Number, Exact>::value)
      return x;
    else if constexpr(is_exact_field<Number>())
      return from_rational<Number>(to_rational(x));
    else
      return Number(CGAL::to_double(x));
  }

  Vertex add_vertex_at(std::size_t n, const Point& p, Vertex v)
  {
    put(m_points, v, p);
    m_nodes[n].vertex = v;
    ++m_number_of_new_vertices;
    return v;
  }

  // The halfedge of the record keeps its target; the parts before it are new.
  template <class IsConstrainedMap, class Visitor>
  void split(const Edge& e, IsConstrainedMap is_constrained, Visitor& visitor)
  {
    if(e.nodes.empty())
      return;
    const Point a = get(m_points, source(e.halfedge, m_mesh)), b = get(m_points, target(e.halfedge, m_mesh));
    const bool is_marked = get(is_constrained, edge(e.halfedge, m_mesh));
    for(const std::size_t n : e.nodes) {
      const Number t(m_nodes[n].t);
      visitor.before_edge_split(e.halfedge, m_mesh);
      const Halfedge h = CGAL::Euler::split_edge(e.halfedge, m_mesh);
      add_vertex_at(n, m_nodes[n].t <= 0.5 ? a + t * (b - a) : b + (Number(1) - t) * (a - b), target(h, m_mesh));
      put(is_constrained, edge(h, m_mesh), is_marked);
      set_border(h);
      visitor.edge_split(h, m_mesh);
      visitor.after_edge_split();
    }
  }

  // Associates the target of a halfedge with a halfedge on the border, if there is one, as Surface_mesh requires.
  void set_border(Halfedge h)
  {
    for(const Halfedge in : {h, opposite(next(h, m_mesh), m_mesh)})
      if(face(in, m_mesh) == Graph::null_face())
        set_halfedge(target(h, m_mesh), in, m_mesh);
  }

  Point point_inside(const Face_record& f, std::size_t n) const
  {
    const std::array<Exact, 3>& w = m_nodes[n].weights;
    const Point a = get(m_points, f.vertices[0]), b = get(m_points, f.vertices[1]), c = get(m_points, f.vertices[2]);
    return a + number(w[1]) * (b - a) + number(w[2]) * (c - a);
  }

  using Halfedges = std::map<Segment, Halfedge>; // by the nodes at source and target

  // Creates vertices at the nodes inside a face. Returns the sides of the face, which have been split.
  Halfedges make_vertices(const Face_record& f)
  {
    std::map<Vertex, std::size_t> node_of;
    std::set<std::size_t> nodes;
    for(const auto& triangle : f.triangles)
      nodes.insert(triangle.begin(), triangle.end());
    for(const std::size_t n : nodes) {
      if(m_nodes[n].kind == Location_kind::FACE)
        add_vertex_at(n, point_inside(f, n), add_vertex(m_mesh));
      node_of[m_nodes[n].vertex] = n;
    }
    Halfedges result;
    for(const Halfedge h : halfedges_around_face(halfedge(f.face, m_mesh), m_mesh))
      result[{{node_of.at(source(h, m_mesh)), node_of.at(target(h, m_mesh))}}] = h;
    return result;
  }

  template <class IsConstrainedMap>
  Halfedge make_halfedge(std::size_t a, std::size_t b, Halfedges& halfedges, IsConstrainedMap is_constrained)
  {
    const auto found = halfedges.find({{a, b}});
    if(found != halfedges.end())
      return found->second;
    const Halfedge h = halfedge(add_edge(m_mesh), m_mesh), t = opposite(h, m_mesh);
    set_target(h, m_nodes[b].vertex, m_mesh);
    set_target(t, m_nodes[a].vertex, m_mesh);
    put(is_constrained, edge(h, m_mesh), false);
    halfedges[{{b, a}}] = t;
    return halfedges[{{a, b}}] = h;
  }

  // The first triangle keeps the face.
  template <class IsConstrainedMap, class Visitor>
  void divide(const Face_record& f, IsConstrainedMap is_constrained, Visitor& visitor)
  {
    Halfedges halfedges = make_vertices(f);
    if(f.triangles.size() > 1) {
      ++m_number_of_divided_faces;
      visitor.before_subface_creations(f.face, m_mesh);
      for(const auto& triangle : f.triangles)
        make_face(f, triangle, halfedges, is_constrained, visitor);
      visitor.after_subface_creations(m_mesh);
    }
    for(const Segment& s : f.segments) {
      const auto found = halfedges.find(s);
      const Halfedge h = found != halfedges.end() ? found->second : halfedges.at({{s[1], s[0]}});
      put(is_constrained, edge(h, m_mesh), true);
    }
  }

  template <class IsConstrainedMap, class Visitor>
  void make_face(const Face_record& record, const Face_arrangement::Triangle& triangle, Halfedges& halfedges,
                 IsConstrainedMap is_constrained, Visitor& visitor)
  {
    const bool is_first = &triangle == &record.triangles.front();
    if(!is_first)
      visitor.before_subface_created(m_mesh);
    const Face f = is_first ? record.face : add_face(m_mesh);
    std::array<Halfedge, 3> sides;
    for(std::size_t i = 0; i < 3; ++i)
      sides[i] = make_halfedge(triangle[i], triangle[(i + 1) % 3], halfedges, is_constrained);
    for(std::size_t i = 0; i < 3; ++i) {
      set_next(sides[i], sides[(i + 1) % 3], m_mesh);
      set_face(sides[i], f, m_mesh);
      if(m_nodes[triangle[(i + 1) % 3]].kind == Location_kind::FACE)
        set_halfedge(target(sides[i], m_mesh), sides[i], m_mesh);
    }
    set_halfedge(f, sides[0], m_mesh);
    if(is_first)
      return;
    ++m_number_of_new_faces;
    visitor.after_subface_created(f, m_mesh);
  }

  Mesh& m_mesh;
  PointMap m_points;
  double m_snap;
  std::vector<Node> m_nodes;
  std::vector<Edge> m_edges;
  std::vector<Face_record> m_faces;
  std::map<Vertex, std::size_t> m_node_of_vertex;
  std::map<Halfedge, std::size_t> m_record_of_edge;
  std::map<Face, std::size_t> m_record_of_face;
  std::size_t m_number_of_new_vertices = 0, m_number_of_divided_faces = 0, m_number_of_new_faces = 0;
};

/* Detects the `Face_location` of a mesh. */
template <class T, class Mesh, class = void>
constexpr bool is_face_location_of = false;
template <class T, class Mesh>
constexpr bool
    is_face_location_of<T, Mesh, std::void_t<decltype(CGAL::to_double(std::declval<const T&>().second[0]))>> =
        std::is_same<std::decay_t<decltype(std::declval<const T&>().first)>,
                     typename boost::graph_traits<Mesh>::face_descriptor>::value;

/* Detects types with a member `location` of that type, such as `Curve_point`. */
template <class T, class Mesh, class = void>
constexpr bool has_face_location = false;
template <class T, class Mesh>
constexpr bool has_face_location<T, Mesh, std::void_t<decltype(std::declval<const T&>().location)>> =
    is_face_location_of<std::decay_t<decltype(std::declval<const T&>().location)>, Mesh>;

/* Detects the other surface points that `surface_location()` accepts, and variants. */
template <class T, class Mesh>
constexpr bool is_point_by_index =
    Is_variant<T>::value || std::is_convertible<const T&, const Surface_location&>::value ||
    std::is_convertible<const T&, const Surface_point&>::value ||
    std::is_convertible<const T&, typename boost::graph_traits<Mesh>::vertex_descriptor>::value;

template <class T, class Mesh>
constexpr bool is_point_of_curve =
    is_face_location_of<T, Mesh> || has_face_location<T, Mesh> || is_point_in_space<T> || is_point_by_index<T, Mesh>;

/* Detects ranges of these. */
template <class T, class Mesh, class = void>
constexpr bool is_range_of_curve_points = false;
template <class T, class Mesh>
constexpr bool is_range_of_curve_points<T, Mesh, std::void_t<Range_value<T>>> = is_point_of_curve<Range_value<T>, Mesh>;

/* Detects types with such a range as a member `locations`, such as `Isoline`. */
template <class T, class Mesh, class = void>
constexpr bool has_locations = false;
template <class T, class Mesh>
constexpr bool has_locations<T, Mesh, std::void_t<decltype(std::declval<const T&>().locations)>> =
    is_range_of_curve_points<std::decay_t<decltype(std::declval<const T&>().locations)>, Mesh>;

template <class T, class Mesh>
constexpr bool is_insertable_curve = is_range_of_curve_points<T, Mesh> || has_locations<T, Mesh>;

template <class T, class Mesh, class = void>
constexpr bool is_range_of_insertable_curves = false;
template <class T, class Mesh>
constexpr bool is_range_of_insertable_curves<T, Mesh, std::void_t<Range_value<T>>> =
    is_insertable_curve<Range_value<T>, Mesh>;

/* Adds curves to an insertion as nodes and segments between them. */
template <class Mesh, class PointMap>
class Curve_reader
{
  using Graph = boost::graph_traits<Mesh>;
  using Face = typename Graph::face_descriptor;
  using Insertion = Curve_insertion<Mesh, PointMap>;

public:
  Curve_reader(const Mesh& mesh, const PointMap& points, double snap, Insertion& insertion)
    : m_mesh(mesh)
    , m_points(points)
    , m_snap(snap)
    , m_insertion(insertion)
  {
  }

  /* Adds a range of curves, or a single one. */
  template <class Curves>
  void add_all(const Curves& curves)
  {
    if constexpr(is_insertable_curve<Curves, Mesh>)
      add(curves);
    else
      for(const auto& curve : curves)
        add(curve);
  }

private:
  struct Place
  {
    Face face;
    std::array<double, 3> weights;
  };

  struct Corners
  {
    const Insertion* insertion;
    Triangle_places operator()(Face f) const { return insertion->places_of_corners(f); }
  };
  using Nearest = typename Nearest_face<Mesh, Corners>::Result;

  template <class Curve>
  void add(const Curve& curve)
  {
    if constexpr(has_locations<Curve, Mesh>) {
      add(curve.locations);
    } else {
      m_point = 0;
      m_last_face = Graph::null_face();
      for(const auto& p : curve)
        add_point(p);
      if(m_point == 0)
        throw_naming<Invalid_curve_error>("curve ", Element{m_curve}, " has no points");
      ++m_curve;
    }
  }

  template <class T>
  void add_point(const T& p)
  {
    if constexpr(Is_variant<T>::value)
      std::visit([this](const auto& q) { this->add_place(q, this->place_of(q)); }, p);
    else
      add_place(p, place_of(p));
  }

  template <class T>
  void add_place(const T& p, const Place& place)
  {
    const std::size_t node = m_insertion.add_point(place.face, place.weights, given_weights(p, place));
    if(m_point > 0 && !m_insertion.add_segment(m_last_node, node, {{m_last_face, place.face}}))
      throw Invalid_curve_error(
          name() + " and the previous point do not lie in a common face; add the points where the curve "
                   "crosses edges, for instance by complete_polyline()",
          elements());
    m_last_node = node;
    m_last_face = place.face;
    ++m_point;
  }

  std::string name() const { return "point " + std::to_string(m_point) + " of curve " + std::to_string(m_curve); }

  std::vector<std::size_t> elements() const { return {m_curve, m_point}; }

  template <class T>
  Place place_of(const T& p)
  {
    if constexpr(is_face_location_of<T, Mesh>)
      return place_at(p.first,
                      {{CGAL::to_double(p.second[0]), CGAL::to_double(p.second[1]), CGAL::to_double(p.second[2])}},
                      m_snap);
    else if constexpr(has_face_location<T, Mesh>)
      return place_of(p.location);
    else if constexpr(is_point_by_index<T, Mesh>)
      return place_by_index(p);
    else
      return place_in_space(half_of(p));
  }

  template <class T>
  Place place_by_index(const T& p)
  {
    if(!m_surface)
      m_surface.emplace(m_mesh, Embedded_metric<Mesh, PointMap>(m_points));
    const auto convert = [&] { return face_location(*m_surface, m_mesh, located_place(*m_surface, p)); };
    const auto [f, weights] = located_by_name(convert, "curve ", Element{m_curve}, ", point ", Element{m_point});
    return place_at(f, weights, m_snap);
  }

  // Returns the weights as given, or those of the place in double.
  template <class T>
  static const auto& given_weights(const T& p, const Place& place)
  {
    if constexpr(is_face_location_of<T, Mesh>)
      return static_cast<void>(place), p.second;
    else if constexpr(has_face_location<T, Mesh>)
      return given_weights(p.location, place);
    else
      return static_cast<void>(p), place.weights;
  }

  Place place_at(Face f, const std::array<double, 3>& weights, double snap) const
  {
    if(!is_face(f, m_mesh))
      throw Invalid_location_error(name() + " has a face that does not belong to the mesh", elements());
    const auto refuse = [this](const std::string& before, const std::string& after) {
      throw Invalid_location_error(before + name() + after, elements());
    };
    return {f, snapped_weights(weights, snap, refuse)};
  }

  // Returns the nearest point of the surface: in the faces around the previous point if one contains it, or in any
  // face.
  Place place_in_space(const Place_in_space& p)
  {
    if(!are_finite(p))
      throw Invalid_location_error(name() + " has a coordinate that is not a finite number", elements());
    Nearest best;
    if(m_last_face != Graph::null_face())
      for(const auto h : halfedges_around_face(halfedge(m_last_face, m_mesh), m_mesh))
        for(const Face f : faces_around_target(h, m_mesh))
          if(f != Graph::null_face())
            look_at(f, p, best);
    if(best.distance() > nearest_point_snap * diagonal()) {
      if(!m_nearest_face)
        m_nearest_face.emplace(m_mesh, Corners{&m_insertion});
      const Nearest found = (*m_nearest_face)(p);
      if(found.distance() < best.distance())
        best = found;
    }
    if(!(best.distance() <= off_surface_tolerance * diagonal()))
      throw Invalid_location_error(name() + " is not on the surface", elements());
    return place_at(best.face, best.nearest.weights, nearest_point_snap);
  }

  void look_at(Face f, const Place_in_space& p, Nearest& best) const
  {
    const Nearest_weights nearest = nearest_weights(seen_from(p, m_insertion.places_of_corners(f)));
    if(nearest.distance < best.distance())
      best = {f, nearest};
  }

  // Returns the diagonal of the bounding box, halved like all coordinates here.
  double diagonal()
  {
    if(m_diagonal < 0) {
      Bbox_3 box;
      for(const auto v : vertices(m_mesh)) {
        const Place_in_space p = half_of(get(m_points, v));
        box += Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
      }
      m_diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
    }
    return m_diagonal;
  }

  const Mesh& m_mesh;
  PointMap m_points;
  double m_snap;
  Insertion& m_insertion;
  std::optional<Nearest_face<Mesh, Corners>> m_nearest_face;
  std::optional<Metric_surface<Mesh, Embedded_metric<Mesh, PointMap>>> m_surface; // numbers the elements of the mesh
  double m_diagonal = -1;                                                         // negative until it is computed
  std::size_t m_curve = 0, m_point = 0;                                           // the one being read
  std::size_t m_last_node = Insertion::none;
  Face m_last_face = Graph::null_face();
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_CURVE_INSERTION_H
