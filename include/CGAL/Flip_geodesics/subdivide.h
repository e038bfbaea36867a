// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SUBDIVIDE_H
#define CGAL_FLIP_GEODESICS_SUBDIVIDE_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Overlay.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsSubdivision
/// Describes the origin of a vertex of a `Surface_subdivision`.
struct Subdivision_vertex
{
  Surface_point on_input;                     ///< the position of the vertex on the input mesh
  Vertex_index intrinsic_vertex = null_index; ///< the corresponding vertex of the triangulation, or null
  Halfedge_index intrinsic_halfedge =
      null_index; ///< the first halfedge of the intrinsic edge on which a vertex without `intrinsic_vertex` lies
  double intrinsic_t = 0; ///< the position on `intrinsic_halfedge`, strictly between 0 at the tail and 1 at the head
};

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * Represents a triangle mesh that subdivides the input mesh along edges of an intrinsic triangulation. Maps lead from
 * the elements of the subdivision back to the input mesh and to the triangulation. `common_subdivision()`,
 * `insert_curves()` and `cut_along_curves()` return objects of this class.
 *
 * Each face lies in one face of the input. The vertices of the triangulation come first, in the order of their indices.
 * They are followed by the crossings of intrinsic edges with input edges, then by the midpoints of split edges (see
 * `insert_curves()` and `cut_along_curves()`) and, after a cut, by copies of vertices. If possible, `insert_curves()`
 * and `cut_along_curves()` omit crossings and inserted vertices that do not lie on curves.
 *
 * The connectivity is exact, regardless of rounding errors in positions. The mesh is oriented. It is manifold if the
 * input is manifold. Unless the mesh is cut open, it has the components, borders and genus of the input. Since
 * positions are rounded, very thin faces can be geometrically degenerate.
 *
 * Two edges can have the same two end points only in a common subdivision, and only if two faces of the input mesh
 * share all three vertices or two edges of the input mesh share both end points. A mesh with such edges cannot be
 * stored in a file that lists points and faces.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`. The triangulation and the input mesh must outlive
 *         the subdivision, and edges must not be flipped while the subdivision is used
 * \tparam OutputMesh a model of `MutableFaceGraph` with dynamic properties and a vertex point property, for instance
 *         `CGAL::Surface_mesh<Point_3>`
 */
template <class Triangulation, class OutputMesh>
class Surface_subdivision
{
  using Graph = boost::graph_traits<OutputMesh>;
  template <class Tag>
  using Map = typename boost::property_map<OutputMesh, Tag>::type;

public:
  using vertex_descriptor = typename Graph::vertex_descriptor;     ///< the vertex type of `OutputMesh`
  using halfedge_descriptor = typename Graph::halfedge_descriptor; ///< the halfedge type of `OutputMesh`
  using edge_descriptor = typename Graph::edge_descriptor;         ///< the edge type of `OutputMesh`
  using face_descriptor = typename Graph::face_descriptor;         ///< the face type of `OutputMesh`
  /// The face type of the input mesh.
  using Input_face = typename boost::graph_traits<typename Triangulation::Triangle_mesh>::face_descriptor;
  /// A model of `ReadablePropertyMap`, for the parameter `edge_is_constrained_map` of functions of \cgal.
  using Edge_is_constrained_map = Map<CGAL::dynamic_edge_property_t<bool>>;

  /// \name Elements
  /// @{

  /// Returns the mesh.
  const OutputMesh& mesh() const { return m_mesh; }
  /// Returns the mesh, so that it can be moved out or refined further. The maps back to the input and to the
  /// triangulation remain valid for each element of the mesh as long as this element exists.
  OutputMesh& mesh() { return m_mesh; }

  /// Returns the origin of a vertex.
  Subdivision_vertex vertex_origin(vertex_descriptor v) const { return get(m_vertex_origin, v); }

  /// Returns the lowest-numbered halfedge of the input face that contains face `f`. The corresponding halfedge of the
  /// input mesh is `triangulation.input().halfedge(input_face(f))`.
  Input_halfedge_index input_face(face_descriptor f) const { return get(m_faces, f).input; }

  /// Returns the lowest-numbered halfedge of the intrinsic face that contains face `f`, or `null_index` if the
  /// subdivision was constructed by `insert_curves()` or `cut_along_curves()`.
  Halfedge_index intrinsic_face(face_descriptor f) const { return get(m_faces, f).intrinsic; }

  /// Returns the area of a face, measured in the plane of the input face. The area is not negative; it is 0 if rounding
  /// errors of the corners reverse the orientation of the face.
  double area(face_descriptor f) const { return get(m_faces, f).area; }

  /// Returns the barycentric coordinates of the corners of face `f` in the input face that contains it. The corners
  /// are, in this order, the source of `halfedge(f, mesh())`, its target, and the third vertex of `f`. The coordinates
  /// of each corner belong to the tails of `input_face(f)` and of the next two halfedges of the input face.
  const std::array<std::array<double, 3>, 3>& corners(face_descriptor f) const { return get(m_faces, f).corners; }

  /// Returns the input halfedge that contains halfedge `h` and has the same direction as `h`, or `null_index` if `h`
  /// does not lie on an input edge.
  Input_halfedge_index input_halfedge(halfedge_descriptor h) const { return get(m_halfedges, h).input; }

  /// Returns the intrinsic halfedge that contains halfedge `h` and has the same direction as `h`, or `null_index` if
  /// `h` does not lie on an intrinsic edge.
  Halfedge_index intrinsic_halfedge(halfedge_descriptor h) const { return get(m_halfedges, h).intrinsic; }

  /// Returns the halfedges of the mesh along intrinsic halfedge `h`, in the direction of `h`. The result is empty if
  /// the mesh does not contain the edge of `h`. If the mesh is cut open along this edge, the result consists of the
  /// halfedges on the side of the cut that lies on the left of `h`.
  std::vector<halfedge_descriptor> halfedges_along(Halfedge_index h) const
  {
    const std::size_t i = static_cast<std::size_t>(h.idx());
    return {m_along.begin() + m_first_along[i], m_along.begin() + m_first_along[i + 1]};
  }

  /// Returns a map that marks the edges on curves. In a common subdivision, no edges are marked.
  const Edge_is_constrained_map& edge_is_constrained_map() const { return m_is_constrained; }

  /// @}
  /// \name Data Transfer
  /// The maps `in` must be models of `ReadablePropertyMap`, and the maps `out` models of `WritablePropertyMap`. The
  /// keys of a `VertexMap` are vertices of the subdivision, of type `vertex_descriptor`, and those of a `FaceMap` are
  /// faces of the subdivision, of type `face_descriptor`. The keys of an `InputMap` are vertices or faces of the input
  /// mesh. The keys of an `IntrinsicMap` are vertices of the triangulation, of type `Vertex_index`, or faces of the
  /// triangulation. Such a face is represented by its lowest-numbered halfedge, of type `Halfedge_index`.
  ///
  /// The value type of `out` must be constructible from that of `in`. Values that are interpolated or averaged must
  /// support addition, and multiplication by a `double` on the right.
  ///
  /// Functions that average values take \cgalBigO{n \log n} time, where \f$n\f$ is the number of faces of the
  /// subdivision. The other functions take linear time.
  /// @{

  /// Interpolates values of input vertices linearly in the faces of the input. The keys of `in` have the
  /// `vertex_descriptor` type of the input mesh.
  template <class InputMap, class VertexMap>
  void interpolate_from_input(InputMap in, VertexMap out) const
  {
    for(vertex_descriptor v : vertices(m_mesh)) {
      const Surface_point p = vertex_origin(v).on_input;
      const auto a = get(in, m_triangulation->input().vertex(p.a));
      if(p.is_vertex())
        put(out, v, a);
      else if(!p.is_inside_face())
        put(out, v, mixed(a, get(in, m_triangulation->input().vertex(p.b)), p.t));
      else
        put(out, v,
            a * (1 - p.t - p.u) + get(in, m_triangulation->input().vertex(p.b)) * p.t +
                get(in, m_triangulation->input().vertex(p.c)) * p.u);
    }
  }

  /// Interpolates values of intrinsic vertices linearly in the intrinsic faces, which are flat.
  /// \pre the subdivision was constructed by `common_subdivision()`
  template <class IntrinsicMap, class VertexMap>
  void interpolate_from_intrinsic(IntrinsicMap in, VertexMap out) const
  {
    for(vertex_descriptor v : vertices(m_mesh)) {
      const Subdivision_vertex origin = vertex_origin(v);
      if(origin.intrinsic_vertex != null_index)
        put(out, v, get(in, origin.intrinsic_vertex));
      else
        put(out, v,
            mixed(get(in, m_triangulation->tail(origin.intrinsic_halfedge)),
                  get(in, m_triangulation->head(origin.intrinsic_halfedge)), origin.intrinsic_t));
    }
  }

  /// Copies vertex values of the subdivision to those vertices of the triangulation that are vertices of the
  /// subdivision. If a cut has duplicated a vertex, the value of one of its copies is used.
  template <class VertexMap, class IntrinsicMap>
  void restrict_to_intrinsic(VertexMap in, IntrinsicMap out) const
  {
    for(vertex_descriptor v : vertices(m_mesh))
      if(vertex_origin(v).intrinsic_vertex != null_index)
        put(out, vertex_origin(v).intrinsic_vertex, get(in, v));
  }

  /// Assigns the value of each input face to the faces of the subdivision that it contains. The keys of `in` have the
  /// type `Input_face`.
  template <class InputMap, class FaceMap>
  void spread_from_input(InputMap in, FaceMap out) const
  {
    for(face_descriptor f : faces(m_mesh))
      put(out, f, get(in, input_face_descriptor(f)));
  }

  /// Assigns the value of each intrinsic face to the faces of the subdivision that it contains. \pre the subdivision
  /// was constructed by `common_subdivision()`
  template <class IntrinsicMap, class FaceMap>
  void spread_from_intrinsic(IntrinsicMap in, FaceMap out) const
  {
    for(face_descriptor f : faces(m_mesh))
      put(out, f, get(in, intrinsic_face(f)));
  }

  /// Assigns to each face of the input mesh the area-weighted average of the values of the subdivision faces inside it.
  template <class FaceMap, class InputMap>
  void average_to_input(FaceMap in, InputMap out) const
  {
    average(
        in, [this](face_descriptor f) { return input_face(f); },
        [&](Input_halfedge_index h, const auto& value) {
          put(out, internal::graph_face(m_triangulation->input().halfedge(h), *m_input_mesh), value);
        });
  }

  /// Assigns to each intrinsic face the area-weighted average of the values of the subdivision faces inside it.
  /// \pre the subdivision was constructed by `common_subdivision()`
  template <class FaceMap, class IntrinsicMap>
  void average_to_intrinsic(FaceMap in, IntrinsicMap out) const
  {
    average(
        in, [this](face_descriptor f) { return intrinsic_face(f); },
        [&](Halfedge_index h, const auto& value) { put(out, h, value); });
  }

  /// Returns the face of the input mesh that contains face `f`.
  Input_face input_face_descriptor(face_descriptor f) const
  {
    return internal::graph_face(m_triangulation->input().halfedge(input_face(f)), *m_input_mesh);
  }

  /// @}

private:
  friend struct internal::Internals<Surface_subdivision>;

  // Constructs the subdivision from a finished overlay; `original[v]` is the overlay vertex of which vertex v is a
  // copy.
  template <class IsConstrained>
  Surface_subdivision(const internal::Overlay<Triangulation>& overlay,
                      const internal::Overlay_layout<Triangulation>& layout,
                      const internal::Per_overlay_vertex<internal::Overlay_vertex>& original,
                      const typename Triangulation::Triangle_mesh& input_mesh, IsConstrained is_constrained)
    : m_triangulation(&overlay.triangulation())
    , m_input_mesh(&input_mesh)
  {
    const internal::Overlay_to_mesh<Triangulation, OutputMesh> built(overlay, m_mesh);
    make_maps();
    for(internal::Overlay_vertex v : overlay.vertices())
      if(built.vertex(v) != Graph::null_vertex())
        set_vertex(built.vertex(v), overlay, layout, original[v]);
    for(internal::Overlay_halfedge h : overlay.halfedges())
      if(overlay.is_alive(h))
        put(m_halfedges, built.halfedge(h), Lines{overlay.input_halfedge(h), overlay.intrinsic_halfedge(h)});
    for(internal::Overlay_halfedge h : overlay.halfedges())
      if(internal::is_first_side(h) && overlay.is_alive(h))
        put(m_is_constrained, edge(built.halfedge(h), m_mesh), is_constrained(overlay.intrinsic_halfedge(h)));
    overlay.for_each_polygon([&](internal::Overlay_halfedge h) { set_face(overlay, layout, h, built); });
    list_halfedges_along(overlay, built);
  }

  struct Lines
  {
    Input_halfedge_index input;
    Halfedge_index intrinsic;
  };

  struct Face
  {
    Input_halfedge_index input;
    Halfedge_index intrinsic;
    double area = 0;
    std::array<std::array<double, 3>, 3> corners;
  };

  using Overlay = internal::Overlay<Triangulation>;
  using Layout = internal::Overlay_layout<Triangulation>;
  using Built = internal::Overlay_to_mesh<Triangulation, OutputMesh>;

  void make_maps()
  {
    m_vertex_origin = get(CGAL::dynamic_vertex_property_t<Subdivision_vertex>(), m_mesh);
    m_halfedges = get(CGAL::dynamic_halfedge_property_t<Lines>(), m_mesh);
    m_faces = get(CGAL::dynamic_face_property_t<Face>(), m_mesh);
    m_is_constrained = get(CGAL::dynamic_edge_property_t<bool>(), m_mesh);
  }

  // Returns a position on an edge, moved strictly between its ends.
  static double inside_edge(double t)
  {
    return (std::min)((std::max)(internal::least_weight, t), internal::largest_below_one);
  }

  void set_vertex(vertex_descriptor to, const Overlay& overlay, const Layout& layout, internal::Overlay_vertex v)
  {
    Subdivision_vertex origin;
    if(overlay.is_crossing(v)) {
      origin.on_input =
          internal::surface_point_on_edge(*m_triangulation, overlay.crossed_halfedge(v), layout.on_input(v));
      origin.intrinsic_halfedge = layout.intrinsic_halfedge(v);
      origin.intrinsic_t = inside_edge(layout.on_intrinsic(v));
    } else if(overlay.is_midpoint(v)) {
      const typename Layout::Midpoint& midpoint = layout.midpoint(v);
      origin = {midpoint.on_input, null_index, midpoint.intrinsic_halfedge, inside_edge(midpoint.on_intrinsic)};
    } else {
      origin.intrinsic_vertex = Vertex_index(v.idx());
      origin.on_input = internal::surface_point_at_vertex(*m_triangulation, origin.intrinsic_vertex);
    }
    put(m_vertex_origin, to, origin);
    if constexpr(internal::Has_points<typename Triangulation::Metric>::value)
      put(get(CGAL::vertex_point, m_mesh), to, point_in_space(*m_triangulation, origin.on_input));
  }

  void set_face(const Overlay& overlay, const Layout& layout, internal::Overlay_halfedge h, const Built& built)
  {
    Face face;
    face.input = layout.face(h);
    face.intrinsic = layout.intrinsic_face(h);
    const auto corners = layout.corners(face.input);
    std::array<typename Layout::Point_2, 3> p;
    internal::Overlay_halfedge side = h;
    for(int i = 0; i < 3; ++i, side = overlay.next(side)) {
      face.corners[i] = layout.weights(side);
      p[i] = Layout::point(corners, face.corners[i]);
    }
    const double signed_area =
        0.5 * ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]));
    face.area = (std::max)(0.0, signed_area); // closer to the area, which is not negative
    put(m_faces, internal::graph_face(built.halfedge(h), m_mesh), face);
  }

  void list_halfedges_along(const Overlay& overlay, const Built& built)
  {
    for(Halfedge_index h : internal::descriptors<Halfedge_index>(m_triangulation->number_of_halfedges())) {
      m_first_along.push_back(static_cast<std::ptrdiff_t>(m_along.size()));
      for(Index i = 0; i <= overlay.crossings(Triangulation::edge(h)); ++i)
        overlay.for_each_part(h, i, [&](internal::Overlay_halfedge part) {
          if(overlay.is_alive(part) && overlay.intrinsic_halfedge(part) == h)
            m_along.push_back(built.halfedge(part));
        });
    }
    m_first_along.push_back(static_cast<std::ptrdiff_t>(m_along.size()));
  }

  template <class Value>
  static Value mixed(const Value& a, const Value& b, double t)
  {
    return a * (1 - t) + b * t;
  }

  template <class FaceMap, class KeyOf, class Put>
  void average(FaceMap in, KeyOf key_of, Put put_value) const
  {
    using Value = std::decay_t<decltype(get(in, face_descriptor()) * 1.0)>;
    struct Sum
    {
      Value weighted, plain;
      double area;
      int count;
    };
    std::map<decltype(key_of(face_descriptor())), Sum> sums;
    for(face_descriptor f : faces(m_mesh)) {
      const double weight = area(f);
      const Value value = get(in, f) * 1.0;
      const auto [found, is_new] = sums.emplace(key_of(f), Sum{value * weight, value, weight, 1});
      Sum& sum = found->second;
      if(!is_new)
        sum = {sum.weighted + value * weight, sum.plain + value, sum.area + weight, sum.count + 1};
    }
    for(const auto& [key, sum] : sums)
      put_value(key, sum.area > 0 ? sum.weighted * (1 / sum.area) : sum.plain * (1.0 / sum.count));
  }

  const Triangulation* m_triangulation;
  const typename Triangulation::Triangle_mesh* m_input_mesh;
  OutputMesh m_mesh;
  Map<CGAL::dynamic_vertex_property_t<Subdivision_vertex>> m_vertex_origin;
  Map<CGAL::dynamic_halfedge_property_t<Lines>> m_halfedges;
  Map<CGAL::dynamic_face_property_t<Face>> m_faces;
  Edge_is_constrained_map m_is_constrained;
  std::vector<halfedge_descriptor> m_along;
  std::vector<std::ptrdiff_t> m_first_along;
};

namespace internal {

template <class Triangulation, class OutputMesh>
struct Internals<Surface_subdivision<Triangulation, OutputMesh>>
{
  template <class... Parts>
  static Surface_subdivision<Triangulation, OutputMesh> make(const Parts&... parts)
  {
    return Surface_subdivision<Triangulation, OutputMesh>(parts...);
  }
};

} // namespace internal

namespace internal {

/*
 * Removes the pieces of intrinsic edges that do not belong to a curve, and the crossings and inserted vertices on input
 * edges at which no piece remains. The parts of an input face must be convex; all pieces are therefore kept in a face
 * in which a curve ends or bends at an inserted vertex.
 */
template <class Network>
class Curve_filter
{
  using Triangulation = typename Network::Triangulation;
  using Overlay = internal::Overlay<Triangulation>;
  using Layout = Overlay_layout<Triangulation>;
  using Vector_2 = typename Layout::Point_2;

public:
  Curve_filter(Overlay& overlay, Layout& layout, const Network& network)
    : m_overlay(overlay)
    , m_layout(layout)
    , m_network(network)
  {
  }

  void operator()()
  {
    mark_bends();
    m_layout.forget_intrinsic_faces();
    const auto all = m_overlay.halfedges();
    for(Overlay_halfedge h : all)
      if(is_first_side(h) && !is_kept(h) && m_whole_faces.count(m_layout.face(h)) == 0)
        m_overlay.dissolve(h);
    for(Overlay_halfedge h : all)
      if(m_overlay.is_alive(h) && !m_overlay.is_border(h))
        while(!m_overlay.is_input_vertex(m_overlay.target(h)) && is_passed(h)) {
          m_layout.join(h);
          m_overlay.join(h);
        }
  }

private:
  bool is_kept(Overlay_halfedge h) const { return m_overlay.input_halfedge(h) != null_index || is_on_curve(h); }

  // Returns whether only an input edge without a curve passes through the target of h.
  bool is_passed(Overlay_halfedge h) const
  {
    return m_overlay.input_halfedge(h) != null_index && m_overlay.has_two_edges_at_target(h) && !is_on_curve(h) &&
           !is_on_curve(m_overlay.next(h));
  }

  bool is_on_curve(Overlay_halfedge h) const
  {
    const Halfedge_index intrinsic = m_overlay.intrinsic_halfedge(h);
    return intrinsic != null_index && m_network.is_occupied(intrinsic);
  }

  void mark_bends()
  {
    for(Overlay_halfedge h : m_overlay.halfedges()) {
      const Overlay_vertex v = m_overlay.origin(h);
      const bool may_bend = !m_overlay.is_input_vertex(v) && !m_overlay.is_crossing(v) && is_kept(h) &&
                            m_overlay.input_halfedge(h) == null_index;
      if(may_bend && is_reflex_after(h))
        m_whole_faces.insert(m_layout.face(h));
    }
  }

  // Returns whether the angle counterclockwise around the origin of h, from h to the next kept piece or input edge, is
  // more than pi.
  bool is_reflex_after(Overlay_halfedge h) const
  {
    const Overlay_halfedge next = [&] {
      Overlay_halfedge g = h;
      do
        g = Overlay::twin(m_overlay.previous(g));
      while(!m_overlay.is_border(g) && !is_kept(g));
      return g;
    }();
    if(m_overlay.input_halfedge(next) != null_index)
      return false;
    if(next == h)
      return true;
    const Vector_2 u = direction(h), v = direction(next);
    const double dot = u[0] * v[0] + u[1] * v[1], cross = u[0] * v[1] - u[1] * v[0];
    return cross < 0 && !(dot < 0 && -cross <= internal::straight_division * -dot);
  }

  Vector_2 direction(Overlay_halfedge h) const
  {
    const auto corners = m_layout.corners(m_layout.face(h));
    const Vector_2 from = Layout::point(corners, m_layout.weights(h));
    const Vector_2 to = Layout::point(corners, m_layout.weights(m_overlay.next(h)));
    return {to[0] - from[0], to[1] - from[1]};
  }

  Overlay& m_overlay;
  Layout& m_layout;
  const Network& m_network;
  std::set<Input_halfedge_index> m_whole_faces;
};

template <class Triangulation>
void cut(Overlay<Triangulation>& overlay, Overlay_layout<Triangulation>& layout, Overlay_halfedge h)
{
  if(overlay.is_border(h) || overlay.is_border(overlay.twin(h)))
    return;
  overlay.cut(h);
  layout.add_cut(overlay.twin(h));
}

/*
 * Returns the first halfedges of those edges to be cut whose ends lie neither on the border nor on another edge to be
 * cut. The two sides of such a cut would have both end points in common.
 */
template <class Triangulation, class Predicate>
std::vector<Overlay_halfedge> slits_of_one_edge(const Overlay<Triangulation>& overlay, const Predicate& is_on_curve)
{
  const auto number_of_vertices = static_cast<std::size_t>(overlay.number_of_vertices());
  Per_overlay_vertex<int> degree(number_of_vertices, 0); // those on the border have more
  std::vector<Overlay_halfedge> candidates, result;
  for(Overlay_halfedge h : overlay.halfedges()) {
    if(!is_first_side(h) || !overlay.is_alive(h))
      continue;
    const bool is_border = overlay.is_border(h) || overlay.is_border(overlay.twin(h));
    const bool is_cut = !is_border && is_on_curve(overlay.intrinsic_halfedge(h));
    for(Overlay_vertex v : {overlay.origin(h), overlay.target(h)})
      degree[v] += is_border ? 2 : (is_cut ? 1 : 0);
    if(is_cut)
      candidates.push_back(h);
  }
  for(Overlay_halfedge h : candidates)
    if(degree[overlay.origin(h)] == 1 && degree[overlay.target(h)] == 1)
      result.push_back(h);
  return result;
}

template <class Triangulation>
auto same_vertices(const Overlay<Triangulation>& overlay)
{
  const auto all = overlay.vertices();
  return Per_overlay_vertex<Overlay_vertex>(all.begin(), all.end());
}

/* A subdivision with an output mesh of type `OutputMesh`, or of the type of the input if `OutputMesh` is `void`. */
template <class OutputMesh, class Triangulation>
using Subdivision_as =
    Surface_subdivision<Triangulation, std::conditional_t<std::is_void<OutputMesh>::value,
                                                          typename Triangulation::Triangle_mesh, OutputMesh>>;

/* Returns the input mesh with the curves as edges, cut open along the curves if requested. */
template <class OutputMesh, class Network>
auto subdivide_along_curves(const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh,
                            bool is_cutting)
{
  using Triangulation = typename Network::Triangulation;
  Overlay<Triangulation> overlay(network.triangulation());
  Overlay_layout<Triangulation> layout(overlay);
  Curve_filter<Network>(overlay, layout, network)();
  Polygon_triangulator<Triangulation>(overlay, layout)();
  const auto is_on_curve = [&](Halfedge_index h) { return h != null_index && network.is_occupied(h); };
  for(Overlay_halfedge h : overlay.parallel_edges())
    layout.split(overlay, h);
  Per_overlay_vertex<Overlay_vertex> original;
  if(is_cutting) {
    for(Overlay_halfedge h : slits_of_one_edge(overlay, is_on_curve))
      layout.split(overlay, h);
    const auto all = overlay.halfedges();
    for(Overlay_halfedge h : all)
      if(is_first_side(h) && overlay.is_alive(h) && is_on_curve(overlay.intrinsic_halfedge(h)))
        cut(overlay, layout, h);
    original = overlay.split_vertices();
  } else
    original = same_vertices(overlay);
  return Internals<Subdivision_as<OutputMesh, Triangulation>>::make(overlay, layout, original, mesh, is_on_curve);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * Computes the common subdivision of the input mesh and an intrinsic triangulation: a triangle mesh in which each input
 * edge and each intrinsic edge is a chain of edges \cgalCite{SSC19,section 3.4.1}, \cgalCite{GSC21}. The result has
 * maps back to the input mesh and to the triangulation.
 *
 * A function that is linear in each face of the input mesh, or in each face of the intrinsic triangulation, is also
 * linear in each face of the subdivision.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`, constructed from `mesh`
 * \param mesh the input mesh
 * \return a `Surface_subdivision<Triangulation, OutputMesh>`, where `OutputMesh` is the type of `mesh` unless it is
 *         specified as the first template argument
 * \throws Invalid_mesh_error if the result has too many elements for 32-bit indices, or if a face that the
 *         triangulation has not accessed before is not a triangle
 * \throws Degenerate_face_error if such a face has a degenerate edge or violates the triangle inequality
 * \throws Invalid_coordinate_error if such a face has a coordinate or length that is not finite or is out of range
 *
 * Complexity: linear in the number of faces of the mesh plus the number of crossings of intrinsic edges with input
 * edges.
 */
template <class OutputMesh = void, class Triangulation>
auto common_subdivision(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh)
{
  internal::Overlay<Triangulation> overlay(triangulation);
  internal::Overlay_layout<Triangulation> layout(overlay);
  internal::Polygon_triangulator<Triangulation>(overlay, layout)();
  return internal::Internals<internal::Subdivision_as<OutputMesh, Triangulation>>::make(
      overlay, layout, internal::same_vertices(overlay), mesh, [](Halfedge_index) { return false; });
}

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * Inserts the curves of a network into the input mesh as chains of edges. Only faces through which curves lead, and
 * faces beside split edges, are divided.
 *
 * `Surface_subdivision::edge_is_constrained_map()` marks the edges of the curves. Overlapping parts of curves share
 * edges. Edges that would have the same two end points are split at their midpoints. Such edges occur only if two faces
 * of the mesh share all three vertices, or if two edges of the mesh share both end points.
 *
 * \param network a model of `CurveNetwork`; its curves need not be geodesics
 * \param mesh the input mesh of the triangulation of the network
 * \return a `Surface_subdivision`, as for `common_subdivision()`
 * \throws Invalid_mesh_error as `common_subdivision()` does
 * \throws Degenerate_face_error as `common_subdivision()` does
 * \throws Invalid_coordinate_error as `common_subdivision()` does
 */
template <class OutputMesh = void, class Network>
auto insert_curves(const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh)
{
  return internal::subdivide_along_curves<OutputMesh>(network, mesh, false);
}

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * Cuts the input mesh open along the curves of a network. The curves are first inserted as by `insert_curves()`. Then
 * each edge of a curve is doubled unless the edge is on the border, and a vertex is duplicated if the cuts separate the
 * faces around the vertex.
 *
 * Both copies of an edge are marked as constrained. If no curve meets itself or another curve, each open curve inside
 * the surface becomes a slit, whose ends are single vertices. Each closed curve then becomes two borders, and each
 * curve from border to border becomes two chains of border edges. If a slit consists of one edge, its two sides would
 * have both end points in common; each side therefore receives a vertex at its midpoint.
 *
 * \param network, mesh as for `insert_curves()`
 * \return a `Surface_subdivision`, as for `common_subdivision()`
 * \throws Invalid_mesh_error as `common_subdivision()` does
 * \throws Degenerate_face_error as `common_subdivision()` does
 * \throws Invalid_coordinate_error as `common_subdivision()` does
 */
template <class OutputMesh = void, class Network>
auto cut_along_curves(const Network& network, const typename Network::Triangulation::Triangle_mesh& mesh)
{
  return internal::subdivide_along_curves<OutputMesh>(network, mesh, true);
}

namespace internal {

/*
 * Finds the input location of a point near an intrinsic edge. The point is given by its vector from the tail of the
 * edge, in the frame of the face strip of the edge. Of the input faces along the edge, the face is chosen in which the
 * smallest weight of the point is largest.
 */
template <class Triangulation>
class Location_finder
{
  using Vector = std::complex<double>;

public:
  explicit Location_finder(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* Considers the faces along an edge; `along` is the vector of the point, divided by the vector of the edge. */
  void look_along(const Edge_sequence& sequence, const Vector& along)
  {
    if(sequence.crossed.empty())
      return look_in_one_face(sequence, along);
    const Strip<Triangulation> strip(m_triangulation, sequence);
    const Vector point = along * strip.end();
    for(std::size_t gap = 0; gap <= sequence.crossed.size(); ++gap) {
      const auto corners = strip.face(gap);
      std::array<double, 3> weights;
      for(int i = 0; i < 3; ++i)
        weights[i] = cross(corners[(i + 1) % 3].position - point, corners[(i + 2) % 3].position - point);
      note(face_of_gap(sequence, gap), weights);
    }
  }

  /* Returns the location in the best face, with weights that are not negative. */
  Surface_location result() const
  {
    Surface_location result = m_best;
    const double sum = result.weights[0] + result.weights[1] + result.weights[2];
    for(double& weight : result.weights)
      weight = weight / sum < zero_weight ? 0 : weight / sum;
    return canonical_location(m_triangulation.input(), result);
  }

  /*
   * Returns the location in the best face, with positive weights; for points on an edge of the face, weights that are
   * exactly zero are kept.
   */
  Surface_location result_inside(bool is_on_edge = false) const
  {
    constexpr double least = 1.0 / (1LL << 50);
    Surface_location result = m_best;
    const double sum = result.weights[0] + result.weights[1] + result.weights[2];
    for(double& weight : result.weights)
      if(!is_on_edge || weight != 0)
        weight = (std::max)(weight / sum, least);
    return result;
  }

private:
  void note(Input_halfedge_index face, const std::array<double, 3>& weights)
  {
    const double sum = weights[0] + weights[1] + weights[2];
    const double smallest = (std::min)({weights[0], weights[1], weights[2]}) / sum;
    if(!(sum > 0) || !(smallest > m_smallest))
      return;
    m_smallest = smallest;
    m_best = {face, weights};
  }

  // Considers the face on the left of an edge along an input edge, or the face that contains the edge.
  void look_in_one_face(const Edge_sequence& sequence, const Vector& along)
  {
    const Input_halfedge_index h = face_of_gap(sequence, 0);
    const auto& input = m_triangulation.input();
    const auto from = vertex_weights(m_triangulation, sequence.tail, input.is_border(h) ? twin_index(h) : h);
    const auto to = vertex_weights(m_triangulation, sequence.head, input.is_border(h) ? twin_index(h) : h);
    const double from_sum = from[0] + from[1] + from[2], to_sum = to[0] + to[1] + to[2];
    std::array<double, 3> weights;
    for(int i = 0; i < 3; ++i)
      weights[i] = (1 - along.real()) * (from[i] / from_sum) + along.real() * (to[i] / to_sum);
    if(along.imag() != 0)
      add_height(sequence, h, along.imag(), weights);
    note(input.is_border(h) ? twin_index(h) : h, weights);
  }

  // Moves weights to the left of the edge by a fraction of its length.
  void add_height(const Edge_sequence& sequence, Input_halfedge_index h, double height,
                  std::array<double, 3>& weights) const
  {
    const auto f = input_face_geometry(m_triangulation, h);
    const Vector u(f[0].x, f[0].y), v(-f[2].x, -f[2].y); // the two sides at the tail of h
    const Vector left = height * Vector(0, 1) * barycentric_vector(sequence, h, u, v);
    const double area = cross(u, v), at_head = cross(left, v) / area, at_apex = cross(u, left) / area;
    weights[0] -= at_head + at_apex;
    weights[1] += at_head;
    weights[2] += at_apex;
  }

  Vector barycentric_vector(const Edge_sequence& sequence, Input_halfedge_index h, const Vector& u,
                            const Vector& v) const
  {
    const auto d = barycentric_difference(vertex_weights(m_triangulation, sequence.tail, h),
                                          vertex_weights(m_triangulation, sequence.head, h));
    return d[1] * u + d[2] * v;
  }

  const Triangulation& m_triangulation;
  Surface_location m_best;
  double m_smallest = -std::numeric_limits<double>::infinity();
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Returns the rounded input location of a point on the intrinsic edge of `h`. The distance of this point from the tail
 * of `h` is `t` times the length of the edge.
 *
 * If the whole intrinsic edge lies along an input edge, the returned location is on this input edge. Otherwise the
 * location is inside a face; the point is moved into the face if necessary.
 *
 * Complexity: linear in the number of crossed input edges.
 * \pre 0 < `t` < 1
 */
template <class Triangulation>
Surface_location location_on_edge(const Triangulation& triangulation, Halfedge_index h, double t)
{
  internal::Location_finder<Triangulation> finder(triangulation);
  const Edge_sequence sequence = triangulation.edge_sequence(h);
  finder.look_along(sequence, t);
  return internal::canonical_location(triangulation.input(), finder.result_inside(sequence.along != null_index));
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Returns the rounded input location of a point in the intrinsic face on the left of `h`. The point is given by
 * barycentric coordinates, which belong, in this order, to the tail of `h`, to the head of `h`, and to the third vertex
 * of the face.
 *
 * Complexity: linear in the number of input edges that the sides cross.
 * \pre `h` is not on the border, and the coordinates are not negative and sum to one
 */
template <class Triangulation>
Surface_location location_in_face(const Triangulation& triangulation, Halfedge_index h,
                                  const std::array<double, 3>& coordinates)
{
  internal::Location_finder<Triangulation> finder(triangulation);
  for(int i = 0; i < 3; ++i, h = triangulation.next(h)) {
    // Uses lengths only, which all traits provide.
    const double a = triangulation.length(h), b = triangulation.length(triangulation.next(h)),
                 c = triangulation.length(triangulation.previous(h));
    const double x = ((a - b) * (a + b) + c * c) / (2 * a), y = std::sqrt((std::max)((c - x) * (c + x), 0.0));
    const std::complex<double> apex(x / a, y / a);
    finder.look_along(triangulation.edge_sequence(h), coordinates[(i + 1) % 3] + coordinates[(i + 2) % 3] * apex);
  }
  return finder.result();
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_SUBDIVIDE_H
