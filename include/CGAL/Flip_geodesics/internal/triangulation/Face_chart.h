// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FACE_CHART_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FACE_CHART_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Returns the third corner of a triangle on the left of the segment from p to q, by its distances from q and from p. */
inline std::complex<double> apex_of(const std::complex<double>& p, const std::complex<double>& q, double from_q,
                                    double to_p)
{
  const double length = std::abs(q - p);
  const double x = ((to_p - from_q) * (to_p + from_q) + length * length) / (2 * length);
  const double y = std::sqrt((std::max)((to_p - x) * (to_p + x), 0.0));
  return p + (q - p) / length * std::complex<double>(x, y);
}

/* A surface point in the input face, or on its border, that corresponds to a gap in the edge sequence of an intrinsic
 * halfedge. */
struct Point_at_piece
{
  Surface_location location;
  Halfedge_index halfedge;
  std::size_t gap;
};

/*
 * Maps points of an intrinsic face to surface points of the input: the input face that contains them and the position
 * in it.
 *
 * The face of h = A->B lies in the plane with A at the origin and B on the positive real axis. Side i leads from corner
 * i + 1 to corner i + 2; side 0 is h. The input edges that pass cut the face into parts, each given by the sides of
 * which it has a piece. A part is mapped into its input face by the motion that takes its two most distant vertices
 * there, so that errors are relative to the size of the part.
 */
template <class Triangulation>
class Face_chart
{
public:
  using Complex = std::complex<double>;
  using Weights = std::array<double, 3>;

  Face_chart(const Triangulation& triangulation, Halfedge_index h)
    : m_triangulation(triangulation)
  {
    m_sides[0].halfedge = h;
    m_sides[1].halfedge = triangulation.next(h);
    m_sides[2].halfedge = triangulation.next(m_sides[1].halfedge);
    m_corners[1] = 0;
    m_corners[2] = triangulation.length(h);
    m_corners[0] = apex_of(m_corners[1], m_corners[2], triangulation.length(m_sides[1].halfedge),
                           triangulation.length(m_sides[2].halfedge));
    for(Side& side : m_sides)
      measure(side);
  }

  /* Locates a point of the plane that lies in the face up to rounding errors; returns nothing if this fails. */
  std::optional<Point_at_piece> locate(const Complex& z) const
  {
    const Part part = part_of(z);
    const Vertex* from = &part.vertices.front();
    const Vertex* to = from;
    for(const Vertex& u : part.vertices)
      for(const Vertex& v : part.vertices)
        if(std::abs(u.position - v.position) > std::abs(from->position - to->position)) {
          from = &u;
          to = &v;
        }
    const std::optional<Surface_location> location = moved(*from, *to, z);
    if(!location)
      return {};
    return Point_at_piece{*location, part.halfedge, part.gap};
  }

private:
  struct Side
  {
    Halfedge_index halfedge;
    Edge_sequence sequence;
    std::vector<double> along, on_input; // of each crossing, as computed by the strip
  };

  // A vertex of a part, with its weights in the part's input face.
  struct Vertex
  {
    Complex position;
    Weights weights;
    Input_halfedge_index face;
  };

  // Given by a side and a gap in its edge sequence, in which the part has a piece of that side.
  struct Part
  {
    Halfedge_index halfedge;
    std::size_t gap;
    std::vector<Vertex> vertices;
  };

  void measure(Side& side) const
  {
    side.sequence = m_triangulation.edge_sequence(side.halfedge);
    if(side.sequence.crossed.empty())
      return;
    const Strip<Triangulation> strip(m_triangulation, side.sequence);
    for(std::size_t i = 0; i < strip.portals().size(); ++i) {
      side.along.push_back(strip.crossing_along(i));
      side.on_input.push_back(strip.crossing(i));
    }
  }

  // Point k of side i: the tail, the crossings, the head.
  Complex position(int i, std::size_t k) const
  {
    const Complex tail = m_corners[(i + 1) % 3], head = m_corners[(i + 2) % 3];
    if(k == 0)
      return tail;
    return k > m_sides[i].along.size() ? head : tail + m_sides[i].along[k - 1] * (head - tail);
  }

  Part part_of(const Complex& z) const
  {
    const auto number = [this](int i) { return static_cast<Index>(m_sides[i].along.size()); };
    const Triangle_crossings passing(number(0), number(1), number(2));
    for(int corner = 0; corner < 3; ++corner) {
      const int before = (corner + 1) % 3, after = (corner + 2) % 3;
      for(Index k = 0; k < passing.cutting[corner]; ++k) { // from the corner outwards
        const Complex u = position(after, k + 1), v = position(before, number(before) - k);
        if(cross(v - u, z - u) <= 0)
          continue;
        Part part = part_at(after, k);
        add_piece(before, number(before) - k, part);
        return part;
      }
    }
    for(int i = 0; i < 3; ++i)
      if(passing.emanating[i] > 0)
        return part_of_fan(i, passing, z);
    Part part = part_at(0, passing.cutting[1]);
    for(int i = 1; i < 3; ++i)
      add_piece(i, passing.cutting[(i + 1) % 3], part);
    return part;
  }

  // Finds the part at corner i, from which input edges emanate.
  Part part_of_fan(int i, const Triangle_crossings& passing, const Complex& z) const
  {
    Index gap = passing.cutting[(i + 1) % 3];
    const Index last = gap + passing.emanating[i];
    while(gap < last && cross(position(i, gap + 1) - m_corners[i], z - m_corners[i]) > 0)
      ++gap;
    Part part = part_at(i, gap);
    const Input_halfedge_index face = part.vertices.front().face;
    const Vertex_index corner = m_triangulation.tail(m_sides[(i + 2) % 3].halfedge);
    part.vertices.push_back({m_corners[i], vertex_weights(m_triangulation, corner, face), face});
    return part;
  }

  // The part with the piece of side i in a gap of its edge sequence.
  Part part_at(int i, std::size_t gap) const
  {
    Part part = {m_sides[i].halfedge, gap, {}};
    add_piece(i, gap, part);
    return part;
  }

  // Adds the ends of the piece of side i in a gap of its edge sequence.
  void add_piece(int i, std::size_t gap, Part& part) const
  {
    const Edge_sequence& sequence = m_sides[i].sequence;
    const Input_halfedge_index own = face_of_gap(sequence, gap);
    const Input_halfedge_index face = part.vertices.empty() ? own : part.vertices.front().face;
    for(const std::size_t k : {gap, gap + 1}) {
      Weights weights;
      if(k == 0)
        weights = vertex_weights(m_triangulation, sequence.tail, face);
      else if(k > sequence.crossed.size())
        weights = vertex_weights(m_triangulation, sequence.head, face);
      else // left through the crossed edge at the end of the piece, entered at its start
        weights = k > gap ? on_edge(face, sequence.crossed[k - 1], m_sides[i].on_input[k - 1])
                          : on_edge(face, twin_index(sequence.crossed[k - 1]), 1 - m_sides[i].on_input[k - 1]);
      const double sum = weights[0] + weights[1] + weights[2];
      for(double& weight : weights)
        weight /= sum;
      part.vertices.push_back({position(i, k), weights, face});
    }
  }

  Weights on_edge(Input_halfedge_index face, Input_halfedge_index h, double t) const
  {
    const auto& input = m_triangulation.input();
    Weights weights = {{0, 0, 0}};
    for(int i = 0; i < 3; ++i, face = input.next(face))
      if(face == h) {
        weights[i] = 1 - t;
        weights[(i + 1) % 3] = t;
      }
    return weights;
  }

  std::optional<Surface_location> moved(const Vertex& from, const Vertex& to, const Complex& z) const
  {
    if(from.position == to.position)
      return {};
    const auto face = input_face_geometry(m_triangulation, from.face);
    const Complex b(face[0].x, face[0].y), c(-face[2].x, -face[2].y);
    const auto place = [&](const Weights& w) { return w[1] * b + w[2] * c; };
    const Complex motion = (place(to.weights) - place(from.weights)) / (to.position - from.position);
    const Complex p = place(from.weights) + motion * (z - from.position);
    const double area = cross(b, c);
    Surface_location result = {from.face, {{0, cross(p, c) / area, cross(b, p) / area}}};
    result.weights[0] = 1 - result.weights[1] - result.weights[2];
    for(double& weight : result.weights) {
      if(!(std::abs(weight) < 2))
        return {}; // a degenerate face
      weight = weight < zero_layout_weight ? 0 : weight;
    }
    return result;
  }

  const Triangulation& m_triangulation;
  std::array<Side, 3> m_sides;
  std::array<Complex, 3> m_corners;
};

/* A point on an intrinsic edge: its surface point on the input, and the gap of the edge sequence that contains it. */
struct Point_on_edge
{
  Surface_location location;
  std::size_t gap;
};

/*
 * Returns a point at about `t` along halfedge h, from 0 at the tail to 1 at the head. It lies inside an input face if
 * the edge does, and is therefore shifted slightly where the edge crosses an input edge. Returns nothing if the piece
 * is too short.
 */
template <class Triangulation>
std::optional<Point_on_edge> point_on_edge(const Triangulation& triangulation, Halfedge_index h, double t)
{
  constexpr double margin = 0.05; // of the piece in an input face
  const Edge_sequence sequence = triangulation.edge_sequence(h);
  const Input_halfedge_index face = face_of_gap(sequence, 0);
  Point_on_edge result = {{face, {{0, 0, 0}}}, 0};
  if(sequence.crossed.empty()) {
    std::array<double, 3> a = vertex_weights(triangulation, sequence.tail, face);
    std::array<double, 3> b = vertex_weights(triangulation, sequence.head, face);
    const double sum_a = a[0] + a[1] + a[2], sum_b = b[0] + b[1] + b[2];
    for(int i = 0; i < 3; ++i)
      result.location.weights[i] = (1 - t) * a[i] / sum_a + t * b[i] / sum_b;
    return result;
  }
  const Strip<Triangulation> strip(triangulation, sequence);
  double low = 0, best_distance = 2, best_t = t;
  for(std::size_t i = 0; i <= sequence.crossed.size(); ++i) {
    const double high = i < sequence.crossed.size() ? strip.crossing_along(i) : 1, room = margin * (high - low);
    const double nearest = (std::min)((std::max)(t, low + room), high - room);
    if(room > least_point_spacing && std::abs(nearest - t) < best_distance) {
      best_distance = std::abs(nearest - t);
      best_t = nearest;
      result.gap = i;
    }
    low = (std::max)(low, high);
  }
  if(best_distance > 1)
    return {};
  const auto corners = strip.face(result.gap);
  const std::complex<double> p = best_t * strip.end(), b = corners[1].position - corners[0].position,
                             c = corners[2].position - corners[0].position, d = p - corners[0].position;
  const auto cross = [](const std::complex<double>& u, const std::complex<double>& v) {
    return std::imag(std::conj(u) * v);
  };
  const double area = cross(b, c);
  result.location.halfedge = face_of_gap(sequence, result.gap);
  result.location.weights = {{0, cross(d, c) / area, cross(b, d) / area}};
  result.location.weights[0] = 1 - result.location.weights[1] - result.location.weights[2];
  for(double weight : result.location.weights)
    if(!(weight > zero_layout_weight && weight < 1))
      return {};
  return result;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FACE_CHART_H
