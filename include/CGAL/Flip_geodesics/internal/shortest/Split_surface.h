// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SPLIT_SURFACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SPLIT_SURFACE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Numbered_surface.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_insertion.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* A halfedge of a split surface that is new, or whose links differ from those of the original halfedge. */
struct Split_side
{
  Input_halfedge_index halfedge, next, previous;
  Vertex_index tail;
  bool is_border, is_whole;           // the latter if it is an original edge, not divided
  Input_halfedge_index along;         // the original halfedge of which it is a part; null inside a face
  Input_halfedge_index face;          // a side of the original face that contains it; null on the border
  std::array<double, 3> tail_weights; // of the tail in that face
};

/*
 * A surface of which points have become vertices: the original faces that contain points are split, and all others are
 * unchanged, so searches between vertices are also searches between points.
 *
 * Original elements keep their numbers, but a halfedge of a split edge is the part at one of its ends. The faces are
 * determined exactly, by an insertion of the points into a triangulation.
 */
template <class TriangleMesh>
class Split_surface
{
public:
  using Below = Indexed_mesh<TriangleMesh>;

  /* \param triangulation in which points have been inserted and nothing was flipped. It is only read here, but its
   * input must outlive the surface */
  template <class Triangulation>
  explicit Split_surface(const Triangulation& triangulation)
    : m_below(&triangulation.input())
    , m_number_of_halfedges(triangulation.number_of_halfedges())
    , m_first(number_of_slots, nowhere)
  {
    for(Vertex_index v(m_below->number_of_vertices()); v.idx() < triangulation.number_of_vertices();
        v = Vertex_index(v.idx() + 1))
    {
      m_locations.push_back(triangulation.location(v));
      m_outgoing.push_back(as_input(triangulation.outgoing(v)));
      for(Halfedge_index h : outgoing_halfedges(triangulation, v))
        if(!triangulation.is_border(h))
          add_face(triangulation, h);
    }
    link_border();
  }

  const Below& below() const { return *m_below; }

  Index number_of_vertices() const { return m_below->number_of_vertices() + static_cast<Index>(m_locations.size()); }
  Index number_of_halfedges() const { return m_number_of_halfedges; }
  /* Inserting a vertex adds two faces, or one on the border. */
  Index number_of_faces() const
  {
    const Index border =
        static_cast<Index>(std::count_if(m_locations.begin(), m_locations.end(), [&](const Surface_location& p) {
          return kind(p) == Location_kind::EDGE && m_below->is_border(twin_index(p.halfedge));
        }));
    return m_below->number_of_faces() + 2 * static_cast<Index>(m_locations.size()) - border;
  }

  Input_halfedge_index next(Input_halfedge_index h) const
  {
    const Split_side* const side = find(h);
    return side == nullptr ? m_below->next(h) : side->next;
  }
  Input_halfedge_index previous(Input_halfedge_index h) const
  {
    const Split_side* const side = find(h);
    return side == nullptr ? m_below->previous(h) : side->previous;
  }
  Vertex_index tail(Input_halfedge_index h) const
  {
    const Split_side* const side = find(h);
    return side == nullptr ? m_below->tail(h) : side->tail;
  }
  bool is_border(Input_halfedge_index h) const
  {
    const Split_side* const side = find(h);
    return side == nullptr ? m_below->is_border(h) : side->is_border;
  }
  Input_halfedge_index outgoing(Vertex_index v) const
  {
    if(is_new(v))
      return m_outgoing[new_index(v)];
    const Input_halfedge_index h = m_below->outgoing(v);
    return h == null_index || tail(h) == v ? h : part_at_tail(h, v);
  }

  /* Returns whether a vertex is new. */
  bool is_new(Vertex_index v) const { return v.idx() >= m_below->number_of_vertices(); }
  /* Returns the location of a new vertex on the original surface. */
  const Surface_location& location(Vertex_index v) const { return m_locations[new_index(v)]; }

  /* Returns the record of a halfedge that has changed; null if it is unchanged. */
  const Split_side* find(Input_halfedge_index h) const
  {
    const Index i = position(h);
    return i == nowhere ? nullptr : &m_sides[static_cast<std::size_t>(i)];
  }

  /* Returns the halfedges that have changed: those of each new face in order, and then those on the border. */
  const std::vector<Split_side>& sides() const { return m_sides; }

  /* Returns whether a face at a vertex is split. */
  bool is_beside_split(Vertex_index v) const
  {
    return std::any_of(m_sides.begin(), m_sides.end(),
                       [v](const Split_side& side) { return !side.is_border && side.tail == v; });
  }

  /* Returns the original halfedge along which a halfedge runs; null inside a face. */
  Input_halfedge_index along(Input_halfedge_index h) const
  {
    const Split_side* const side = find(h);
    return side == nullptr ? h : side->along;
  }

  /* Returns a canonical location as one on the original surface; nothing for a point of a new edge. */
  std::optional<Surface_location> location_below(const Surface_location& at) const
  {
    if(kind(at) == Location_kind::VERTEX)
      return vertex_below(tail(at.halfedge));
    const Split_side* const side = find(at.halfedge);
    if(side == nullptr)
      return at;
    if(kind(at) == Location_kind::EDGE && side->along == null_index)
      return {};
    return canonical_location(*m_below, in_face_below(*side, at.weights));
  }

private:
  static constexpr std::size_t number_of_slots = 256; // far more than the faces at two points have halfedges
  static constexpr Index nowhere = -1;

  static std::size_t slot(Input_halfedge_index h) { return static_cast<std::size_t>(h.idx()) % number_of_slots; }
  std::size_t new_index(Vertex_index v) const
  {
    return static_cast<std::size_t>(v.idx() - m_below->number_of_vertices());
  }

  Index position(Input_halfedge_index h) const
  {
    Index i = m_first[slot(h)];
    while(i != nowhere && m_sides[static_cast<std::size_t>(i)].halfedge != h)
      i = m_following[static_cast<std::size_t>(i)];
    return i;
  }

  void add(const Split_side& side)
  {
    Index& first = m_first[slot(side.halfedge)];
    m_following.push_back(first);
    first = static_cast<Index>(m_sides.size());
    m_sides.push_back(side);
  }

  template <class Triangulation>
  void add_face(const Triangulation& triangulation, Halfedge_index h)
  {
    if(find(as_input(h)) != nullptr)
      return;
    const Edge_sequence sequence = triangulation.edge_sequence(h);
    const Input_halfedge_index face = sequence.along == null_index ? sequence.face : sequence.along;
    for(int i = 0; i < 3; ++i, h = triangulation.next(h)) {
      const Vertex_index v = triangulation.tail(h);
      const Input_halfedge_index along = triangulation.edge_sequence(h).along;
      const bool is_whole = triangulation.version(Triangulation::edge(h)) == 0;
      add({as_input(h), as_input(triangulation.next(h)), as_input(triangulation.previous(h)), v, false, is_whole, along,
           face, vertex_weights(triangulation, v, face)});
      const Halfedge_index t = Triangulation::twin(h);
      if(triangulation.is_border(t) && !is_whole)
        m_border.push_back({as_input(t),
                            null_index,
                            null_index,
                            triangulation.tail(t),
                            true,
                            false,
                            twin_index(along),
                            null_index,
                            {{0, 0, 0}}});
    }
  }

  // Links the parts of edges on the border with each other and with the neighbors of the original edges.
  void link_border()
  {
    for(const Split_side& side : m_border)
      add(side);
    for(const Split_side& part : m_border) {
      const Vertex_index tail = part.tail, head = this->tail(twin_index(part.halfedge));
      const Input_halfedge_index before = is_new(tail) ? part.along : m_below->previous(part.along);
      const Input_halfedge_index after = is_new(head) ? part.along : m_below->next(part.along);
      link(part_at_head(before, tail), part.halfedge);
      link(part.halfedge, part_at_tail(after, head));
    }
  }

  void link(Input_halfedge_index h, Input_halfedge_index next)
  {
    changed(h).next = next;
    changed(next).previous = h;
  }

  // Returns the record of a halfedge on the border, after creating one from the original surface if necessary.
  Split_side& changed(Input_halfedge_index h)
  {
    if(position(h) == nowhere)
      add({h, m_below->next(h), m_below->previous(h), m_below->tail(h), true, true, h, null_index, {{0, 0, 0}}});
    return m_sides[static_cast<std::size_t>(position(h))];
  }

  // Returns the part of an original halfedge that starts at a vertex, or ends there.
  Input_halfedge_index part_at_tail(Input_halfedge_index along, Vertex_index v) const
  {
    for(const Split_side& side : m_sides)
      if(side.along == along && side.tail == v)
        return side.halfedge;
    return along;
  }
  Input_halfedge_index part_at_head(Input_halfedge_index along, Vertex_index v) const
  {
    return twin_index(part_at_tail(twin_index(along), v));
  }

  Surface_location vertex_below(Vertex_index v) const
  {
    if(is_new(v))
      return location(v);
    return canonical_location(*m_below, {m_below->outgoing(v), {{1, 0, 0}}});
  }

  Surface_location in_face_below(const Split_side& first, const std::array<double, 3>& weights) const
  {
    Surface_location result = {first.face, {{0, 0, 0}}};
    const Split_side* side = &first;
    for(std::size_t i = 0; i < 3; ++i, side = find(side->next)) {
      const std::array<double, 3> corner = divided_by_sum(side->tail_weights);
      for(std::size_t k = 0; k < 3; ++k)
        result.weights[k] += weights[i] * corner[k];
    }
    for(double& weight : result.weights)
      weight = weight == 0 ? 0 : (std::max)(weight, least_weight);
    return result;
  }

  const Below* m_below;
  Index m_number_of_halfedges;
  std::vector<Surface_location> m_locations;    // of the new vertices
  std::vector<Input_halfedge_index> m_outgoing; // from them
  std::vector<Split_side> m_sides, m_border;
  std::vector<Index> m_first, m_following; // a table of the sides by their halfedges
};

/* The functions of a face graph that curve points require. */
template <class TriangleMesh>
Numbered_face face(Input_halfedge_index h, const Split_surface<TriangleMesh>& surface)
{
  return {least_in_face(surface, h)};
}

/* The elements of a split surface are numbered, so that it is its own indexed mesh. */
template <class TriangleMesh>
class Indexed_mesh<Split_surface<TriangleMesh>> : public Numbered_surface<Split_surface<TriangleMesh>>
{
public:
  using Numbered_surface<Split_surface<TriangleMesh>>::Numbered_surface;
};

} // namespace CGAL::Flip_geodesics::internal

namespace boost {

template <class TriangleMesh>
struct graph_traits<CGAL::Flip_geodesics::internal::Split_surface<TriangleMesh>>
  : CGAL::Flip_geodesics::internal::Numbered_surface_traits
{
};

} // namespace boost

namespace CGAL::Flip_geodesics::internal {

/* The position of a vertex of a split surface, given by the data of the original metric, up to an error. */
template <class Place>
struct Split_place
{
  Place place;
  double error; // bounds the difference of distances from the vertex and from the place; infinite if unknown
};

/*
 * The metric of a split surface, which is exactly that of the original surface: parts of faces are derived from the
 * exact original faces by the exact weights of their corners, and rounded last. A model of IntrinsicMetric.
 *
 * If the original metric has no exact faces, its rounded lengths define them.
 */
template <class TriangleMesh, class Metric>
class Split_metric
{
  using Surface = Split_surface<TriangleMesh>;

public:
  using Mesh = Numbered_mesh<Surface>;
  using Kernel = typename Metric::Kernel;
  using Place = Split_place<typename Metric::Place>;

  /* \throws as the original metric for the faces that are split */
  Split_metric(const Metric& metric, const Surface& surface)
    : m_metric(metric)
    , m_parts(std::make_shared<std::vector<Exact_subface>>())
  {
    const auto& sides = surface.sides();
    for(std::size_t i = 0; i + 2 < sides.size() && !sides[i].is_border; i += 3)
      m_parts->push_back(
          Exact_subface(exact_face_below(surface.below(), sides[i].face),
                        internal::face_geometry(metric, surface.below(), sides[i].face, Precise_face_traits())[0],
                        {{sides[i].tail_weights, sides[i + 1].tail_weights, sides[i + 2].tail_weights}}));
  }

  double length(const Mesh& mesh, Input_halfedge_index h) const { return length_by_weight(*this, mesh, h); }
  double weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    const Split_side* const side = new_edge(mesh, h);
    return side == nullptr ? m_metric.weight(below(mesh), h)
                           : part(mesh, *side).length(place_in_part(mesh, *side)).high;
  }
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const
  {
    return new_edge(mesh, h) == nullptr ? m_metric.weight(below(mesh), h, tail.place, head.place) : weight(mesh, h);
  }

  /* Returns the place of a vertex; for a new one, its point in space if the original metric has places in space, and
   * otherwise the place of a corner of its face. */
  Place place(const Mesh& mesh, Vertex_index v) const
  {
    if(!mesh.surface().is_new(v))
      return {m_metric.place(below(mesh), v), 0};
    const auto [corners, w] = corners_and_shares(mesh, v);
    const auto p = m_metric.place(below(mesh), corners[0]);
    if constexpr(has_places_in_space<Metric>)
      return combined(p, m_metric.place(below(mesh), corners[1]), m_metric.place(below(mesh), corners[2]), w);
    else
      return {p, std::numeric_limits<double>::infinity()};
  }

  double distance_lower_bound(const Place& p, const Place& q) const
  {
    return (std::max)(m_metric.distance_lower_bound(p.place, q.place) - (p.error + q.error), 0.0);
  }

  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    const Split_side* const side = mesh.surface().find(h);
    if(side == nullptr)
      return internal::face_geometry(m_metric, below(mesh), h, traits);
    if constexpr(std::is_same<Traits, Precise_face_traits>::value) {
      return part(mesh, *side).precise_face(place_in_part(mesh, *side));
    } else if constexpr(has_exact_subfaces<Traits>) {
      const Split_side *const next = mesh.surface().find(side->next), *const last = mesh.surface().find(side->previous);
      return traits.construct_subface_object()(internal::face_geometry(m_metric, below(mesh), side->face, traits),
                                               {{side->tail_weights, next->tail_weights, last->tail_weights}});
    } else {
      for(const Input_halfedge_index s : {h, side->next, side->previous})
        length(mesh, s);
      return traits.construct_face_2_object()(part(mesh, *side).vectors(place_in_part(mesh, *side)), face_layout_error);
    }
  }

  bool is_rounded(const Mesh& mesh) const { return is_rounded_metric(m_metric, below(mesh)); }

  /* The rounded lengths of a part of a face need not satisfy the triangle inequality. */
  bool is_usable_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    const Split_side* const side = mesh.surface().find(h);
    if(side == nullptr)
      return internal::is_usable_face(m_metric, below(mesh), h);
    return is_usable_length(weight(mesh, h)) && is_usable_length(weight(mesh, side->next)) &&
           is_usable_length(weight(mesh, side->previous));
  }

  Exact_face exact_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    const Split_side* const side = mesh.surface().find(h);
    return side == nullptr ? exact_face_below(below(mesh), h)
                           : part(mesh, *side).exact_face(place_in_part(mesh, *side));
  }

  /* Only for edge sequences between original vertices, and not around a vertex with new edges, which `steps` counts. */
  bool sine_in_plane(const Mesh& mesh, const Edge_sequence& a, const Edge_sequence& b, Index steps,
                     Flat_edges& flat_edges, Sign& sine) const
  {
    const Surface& surface = mesh.surface();
    if(surface.is_beside_split(a.tail))
      return false;
    return internal::sine_in_plane(m_metric, below(mesh), sequence_below(surface, a), sequence_below(surface, b), steps,
                                   flat_edges, sine);
  }

private:
  using Below = Indexed_mesh<TriangleMesh>;
  using Shares = std::array<double, 3>;

  static const Below& below(const Mesh& mesh) { return mesh.surface().below(); }

  Exact_face exact_face_below(const Below& input, Input_halfedge_index h) const
  {
    if constexpr(has_exact_faces<Metric>)
      return internal::exact_face(m_metric, input, h);
    else
      return exact_face_from_lengths(face_lengths(m_metric, input, h));
  }

  // Returns the record of a new edge, the same for both of its sides; null for other edges.
  static const Split_side* new_edge(const Mesh& mesh, Input_halfedge_index h)
  {
    const Split_side* side = mesh.surface().find(h);
    if(side == nullptr || side->is_whole)
      return nullptr;
    const Input_halfedge_index first = is_first_side(h) ? h : twin_index(h);
    return mesh.surface().find(mesh.surface().is_border(first) ? twin_index(first) : first);
  }

  static std::size_t position(const Mesh& mesh, const Split_side& side)
  {
    return static_cast<std::size_t>(&side - mesh.surface().sides().data());
  }
  const Exact_subface& part(const Mesh& mesh, const Split_side& side) const
  {
    return (*m_parts)[position(mesh, side) / 3];
  }
  static std::size_t place_in_part(const Mesh& mesh, const Split_side& side) { return position(mesh, side) % 3; }

  // Returns the corners of the original face that contains a new vertex, beginning with that of the largest weight, and
  // their shares.
  static std::pair<std::array<Vertex_index, 3>, Shares> corners_and_shares(const Mesh& mesh, Vertex_index v)
  {
    Surface_location at = mesh.surface().location(v);
    while(at.weights[0] < (std::max)(at.weights[1], at.weights[2]))
      at = rotated(below(mesh), at);
    const Input_halfedge_index h = at.halfedge, hn = below(mesh).next(h);
    return {{{below(mesh).tail(h), below(mesh).tail(hn), below(mesh).tail(below(mesh).next(hn))}},
            divided_by_sum(at.weights)};
  }

  static double value(double x) { return x; }
  static double value(const Approximate_number& x) { return x.value; }

  static void set_coordinate(double& result, double x, double, double, double) { result = x; }
  // The shares sum to 1 up to rounding errors, which the factor of 2 covers.
  static void set_coordinate(Approximate_number& result, double x, const Approximate_number& p,
                             const Approximate_number& q, const Approximate_number& r)
  {
    result = {x, 2 * (std::max)({p.error, q.error, r.error})};
  }

  static Place combined(const typename Metric::Place& p, const typename Metric::Place& q,
                        const typename Metric::Place& r, const Shares& w)
  {
    Place result = {p, 0};
    for(std::size_t k = 0; k < 3; ++k) {
      const double from = value(p[k]), to_q = value(q[k]) - from, to_r = value(r[k]) - from;
      set_coordinate(result.place[k], from + (w[1] * to_q + w[2] * to_r), p[k], q[k], r[k]);
      result.error += combined_place_error * (std::abs(from) + std::abs(to_q) + std::abs(to_r));
    }
    return result;
  }

  // Returns the edge sequence on the original surface, without the crossings of new edges.
  static Edge_sequence sequence_below(const Surface& surface, Edge_sequence sequence)
  {
    std::vector<Input_halfedge_index> crossed;
    for(const Input_halfedge_index h : sequence.crossed)
      if(const Input_halfedge_index along = surface.along(h); along != null_index)
        crossed.push_back(along);
    sequence.crossed = std::move(crossed);
    return sequence;
  }

  Metric m_metric;
  std::shared_ptr<std::vector<Exact_subface>> m_parts; // of faces, three sides of the surface each
};

template <class TriangleMesh, class Metric>
struct Internals<Split_metric<TriangleMesh, Metric>> : Internals_of_members<Split_metric<TriangleMesh, Metric>>
{
};

/* A triangulation of the surface of another one in which points are vertices from the start, so that searches over its
 * input find paths between them. */
template <class Triangulation>
class Split_triangulation
{
  using Triangle_mesh = typename Triangulation::Triangle_mesh;

public:
  using Surface = Split_surface<Triangle_mesh>;
  using Split = Intrinsic_triangulation<Surface, typename Triangulation::Traits,
                                        Split_metric<Triangle_mesh, typename Triangulation::Metric>>;

  /* The triangulation must outlive this object, and is not changed. \pre it has not been flipped
   * \throws as `Intrinsic_triangulation::insert()` */
  Split_triangulation(Triangulation& triangulation, const std::vector<Surface_location>& points)
    : m_surface(split(triangulation, points))
    , m_triangulation(m_surface, typename Split::Metric(triangulation.metric(), m_surface), triangulation.traits())
  {
  }
  Split_triangulation(const Split_triangulation&) = delete;
  Split_triangulation& operator=(const Split_triangulation&) = delete;

  const Surface& surface() const { return m_surface; }
  Split& triangulation() { return m_triangulation; }

  /* Returns the vertex of point number i. */
  Vertex_index vertex(std::size_t i) const { return m_vertices[i]; }

private:
  Surface split(Triangulation& triangulation, const std::vector<Surface_location>& points)
  {
    const Rollback<Triangulation> at_end(triangulation);
    for(const Surface_location& point : points)
      m_vertices.push_back(triangulation.insert(point));
    return Surface(triangulation);
  }

  std::vector<Vertex_index> m_vertices; // before the surface is made
  Surface m_surface;
  Split m_triangulation;
};

/* Returns the points of the only curve of a network in a triangulation of a split surface, on the original surface. */
template <class Network, class Surface>
Surface_polyline curve_below(const Network& network, const Surface& surface)
{
  const auto& triangulation = network.triangulation();
  Surface_polyline result;
  for(const Surface_point& p : Curve_extractor<Network>(network).surface_points(Curve_index(0))) {
    const Surface_location at = canonical_location(triangulation.input(), surface_location(triangulation, p));
    if(const std::optional<Surface_location> below = surface.location_below(at))
      result.push_back(*below);
  }
  return result;
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SPLIT_SURFACE_H
