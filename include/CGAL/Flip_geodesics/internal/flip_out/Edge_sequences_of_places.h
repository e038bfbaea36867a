// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_EDGE_SEQUENCES_OF_PLACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_EDGE_SEQUENCES_OF_PLACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Input_faces.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * The input of a triangulation with surface points as additional vertices: it provides what strips and their predicates
 * require of a triangulation, for edge sequences that belong to no triangulation.
 */
template <class Triangulation>
class Places_on_input
{
public:
  using Triangle_mesh = typename Triangulation::Triangle_mesh;
  using Input_mesh = typename Triangulation::Input_mesh;
  using Metric = typename Triangulation::Metric;
  using Traits = typename Triangulation::Traits;

  /* The triangulation must outlive this object. */
  explicit Places_on_input(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  const Input_mesh& input() const { return m_triangulation.input(); }
  const Metric& metric() const { return m_triangulation.metric(); }
  const Traits& traits() const { return m_triangulation.traits(); }
  bool is_inserted(Vertex_index v) const { return v.idx() >= input().number_of_vertices(); }
  const Surface_location& location(Vertex_index v) const
  {
    return m_places[static_cast<std::size_t>(v.idx() - input().number_of_vertices())];
  }

  /* Returns the vertex at a surface point: a new one, unless it is an input vertex. */
  Vertex_index add(const Surface_location& location)
  {
    const Surface_location place = canonical_location(input(), location);
    if(kind(place) == Location_kind::VERTEX)
      return input().tail(place.halfedge);
    m_places.push_back(place);
    return Vertex_index(input().number_of_vertices() + static_cast<Index>(m_places.size()) - 1);
  }

private:
  friend struct Internals<Places_on_input>;

  const Triangulation& m_triangulation;
  std::vector<Surface_location> m_places;
  mutable Exact_face_cache m_faces;
};

template <class Triangulation>
struct Internals<Places_on_input<Triangulation>>
{
  static constexpr bool has_exact_faces = true;
  static constexpr bool has_precise_numbers = false;

  static const Exact_face& exact_face(const Places_on_input<Triangulation>& places, Input_halfedge_index h)
  {
    return places.m_faces(places, h);
  }
};

/* A segment of a curve given by surface points: its edge sequence, and which points are its crossed edges. */
struct Segment_of_places
{
  Edge_sequence sequence;
  std::size_t start = 0;         // the number of the point at which it starts; crossed edges follow
  std::vector<bool> is_as_given; // false if the sequence has the other side of the edge
};

/* Constructs edge sequences from end points and crossed edges, whose sides may be given arbitrarily, and rejects points
 * that do not form a path. Each point has a number, which error messages contain. */
template <class Triangulation>
class Edge_sequences_of_places
{
  using Places = Places_on_input<Triangulation>;

public:
  explicit Edge_sequences_of_places(const Places& places)
    : m_places(places)
  {
  }

  /* Ends the current segment, if there is one, and starts another. */
  void pass(Vertex_index v, std::size_t number)
  {
    if(m_is_started)
      arrive(v, number);
    m_segment = {};
    m_segment.sequence.tail = v;
    m_segment.start = number;
    m_is_started = true;
  }

  /* Crosses an edge. \pre h is valid */
  void cross(Input_halfedge_index h, std::size_t number)
  {
    const auto& input = m_places.input();
    if(input.is_border(h) || input.is_border(twin_index(h)))
      refuse(number, "lies on a border edge, which a curve cannot cross");
    std::vector<Input_halfedge_index>& crossed = m_segment.sequence.crossed;
    const bool is_as_given = leads_on_through(h);
    h = is_as_given ? h : twin_index(h);
    if(!is_as_given && !leads_on_through(h))
      refuse(number, crossed.empty() ? "lies on an edge that is not opposite to the previous point"
                                     : "lies on an edge that is not a side of the face that the curve has entered");
    for(Input_halfedge_index side : {h, twin_index(h)})
      check_triangle(input, side);
    crossed.push_back(h);
    m_segment.is_as_given.push_back(is_as_given);
  }

  /* Ends the last segment. */
  void arrive(Vertex_index v, std::size_t number)
  {
    Edge_sequence& sequence = m_segment.sequence;
    sequence.head = v;
    if(sequence.crossed.empty())
      find_common_face(number);
    else if(!is_opposite_vertex(m_places, v, twin_index(sequence.crossed.back())))
      refuse(number, "is not opposite to the edge crossed before it");
    m_segments.push_back(m_segment);
  }

  const std::vector<Segment_of_places>& segments() const { return m_segments; }

private:
  [[noreturn]] static void refuse(std::size_t number, const std::string& what)
  {
    throw_naming<Invalid_curve_error>("point ", Element{number}, " of the curve ", what);
  }

  bool leads_on_through(Input_halfedge_index h) const
  {
    const Edge_sequence& sequence = m_segment.sequence;
    if(sequence.crossed.empty())
      return is_opposite_vertex(m_places, sequence.tail, h);
    const Input_halfedge_index entered = twin_index(sequence.crossed.back());
    return h == m_places.input().next(entered) || h == m_places.input().next(m_places.input().next(entered));
  }

  // No edge is crossed: both ends lie on one edge, or else in one face.
  void find_common_face(std::size_t number)
  {
    Edge_sequence& sequence = m_segment.sequence;
    if(are_same(sequence.tail, sequence.head))
      refuse(number, "is the same as the previous point; omit it");
    for(Input_halfedge_index h : edges_at(sequence.tail))
      if(is_on_halfedge(m_places, sequence.head, twin_index(h)) && leads_along(h)) {
        sequence.along = h;
        return;
      }
    for(Input_halfedge_index h : edges_at(sequence.tail))
      if(!m_places.input().is_border(h) && is_in_face(m_places, sequence.head, h)) {
        check_triangle(m_places.input(), h);
        sequence.face = h;
        return;
      }
    refuse(number, "and the previous point do not lie in a common face, and no edge is crossed between them");
  }

  // Returns a halfedge of each face that contains a point: for a point on an edge both sides, for a vertex its outgoing
  // halfedges.
  std::vector<Input_halfedge_index> edges_at(Vertex_index v) const
  {
    const auto& input = m_places.input();
    if(m_places.is_inserted(v)) {
      const Input_halfedge_index h = m_places.location(v).halfedge;
      return vertex_kind(m_places, v) == Location_kind::FACE ? std::vector<Input_halfedge_index>{h}
                                                             : std::vector<Input_halfedge_index>{h, twin_index(h)};
    }
    std::vector<Input_halfedge_index> result;
    Input_halfedge_index h = input.outgoing(v);
    do {
      result.push_back(h);
      h = input.next(twin_index(h)); // also along the border
    } while(h != result.front());
    return result;
  }

  // Returns whether h leads from the tail to the head, both of which lie on its edge.
  bool leads_along(Input_halfedge_index h) const
  {
    const Edge_sequence& sequence = m_segment.sequence;
    if(m_places.is_inserted(sequence.tail) && vertex_kind(m_places, sequence.tail) == Location_kind::FACE)
      return false;
    if(!m_places.is_inserted(sequence.tail) || !m_places.is_inserted(sequence.head))
      return true;
    const auto a = integer_weights(vertex_weights(m_places, sequence.tail, h));
    const auto b = integer_weights(vertex_weights(m_places, sequence.head, h));
    return a[1] * b[0] < b[1] * a[0];
  }

  // Compares two points inside one face or edge by their exact weights.
  bool are_same(Vertex_index v, Vertex_index w) const
  {
    if(v == w || !m_places.is_inserted(v) || !m_places.is_inserted(w))
      return v == w;
    const Surface_location& p = m_places.location(v);
    const Surface_location& q = m_places.location(w);
    if(p.halfedge != q.halfedge || kind(p) != kind(q))
      return false;
    const auto a = integer_weights(p.weights), b = integer_weights(q.weights);
    return a[0] * b[1] == a[1] * b[0] && a[0] * b[2] == a[2] * b[0];
  }

  const Places& m_places;
  Segment_of_places m_segment;
  bool m_is_started = false;
  std::vector<Segment_of_places> m_segments;
};

/* The turn of a path at an end of a portal, in radians, between 0 and pi. */
struct Portal_turn
{
  std::size_t portal = 0; // the first portal with that end
  Portal_side side = LEFT_END;
  double angle = 0;
};

/* Returns the portals of a strip in the form of a funnel; the right end of the first one becomes the origin. \pre the
 * strip has portals */
template <class Triangulation>
std::vector<Portal> portals_of(const Triangulation& triangulation, const Strip<Triangulation>& strip)
{
  const auto& portals = strip.portals();
  std::vector<Portal> result = {{portals[0].left - portals[0].right, LEFT_END}};
  for(std::size_t i = 1; i < portals.size(); ++i) {
    const bool is_right_kept = portals[i].crossed == triangulation.input().next(twin_index(portals[i - 1].crossed));
    result.push_back({(is_right_kept ? portals[i].left : portals[i].right) - portals[0].right,
                      is_right_kept ? LEFT_END : RIGHT_END});
  }
  return result;
}

/* Returns the largest turn of the shortest path through the portals of a strip, rounded; the angle is 0 if it is
 * straight. */
template <class Triangulation>
Portal_turn largest_turn(const Triangulation& triangulation, const Strip<Triangulation>& strip)
{
  const Plane_vector origin = strip.portals()[0].right, target = strip.end() - origin;
  Funnel funnel;
  funnel.pull(portals_of(triangulation, strip), -origin, target);
  Portal_turn result;
  Plane_vector before = -origin;
  for(std::size_t i = 0; i < funnel.bends().size(); ++i) {
    const Funnel::Bend& bend = funnel.bends()[i];
    const Plane_vector after = i + 1 < funnel.bends().size() ? funnel.bends()[i + 1].position : target;
    const double angle = std::abs(std::arg((after - bend.position) * std::conj(bend.position - before)));
    if(angle > result.angle)
      result = {bend.first, bend.side, angle};
    before = bend.position;
  }
  return result;
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_EDGE_SEQUENCES_OF_PLACES_H
