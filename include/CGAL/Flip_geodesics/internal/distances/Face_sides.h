// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FACE_SIDES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FACE_SIDES_H

#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A face in the frame of one of its sides, halfedge h: it starts at the origin and runs along the x-axis, the face is
 * above. What a window needs to cross it, in one cache line.
 */
struct Face_side
{
  double length;
  double x, y;         // of the vertex opposite
  double cosine, sine; // of the angle at the tail
  Input_halfedge_index next;
  Vertex_index tail;
};

/* The sides of the faces of the input, computed when a face is first asked for. */
template <class Triangulation>
class Face_sides
{
public:
  explicit Face_sides(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_sides(static_cast<std::size_t>(triangulation.number_of_halfedges()))
  {
  }

  /* \pre h is not on the border. \throws as the metric, Invalid_mesh_error */
  const Face_side& operator()(Input_halfedge_index h)
  {
    if(m_sides[h].length == 0)
      compute(h);
    return m_sides[h];
  }

  /* Prepares for several threads. */
  void share()
  {
    if(m_states.empty())
      m_states = std::vector<std::atomic<State>>(m_sides.size());
  }

  /* Computes the sides of a face that has not been asked for. Is it so flat that rays can be lost in it? After `share()`
   * several threads can do so at once, and one waits while another computes the same face. */
  bool make_known(Input_halfedge_index h)
  {
    if(m_states.empty())
      return m_sides[h].length == 0 && compute(h);
    if(state(h).load(std::memory_order_acquire) == State::KNOWN)
      return false;
    std::atomic<State>& first = state(first_halfedge(h));
    for(State expected = State::UNKNOWN;
        !first.compare_exchange_weak(expected, State::BEING_COMPUTED, std::memory_order_acquire);
        expected = State::UNKNOWN)
      if(expected == State::KNOWN)
        return false;
    return compute_claimed(h);
  }

  /* Computes the sides of a face. Is it so flat that rays can be lost in it? */
  bool compute(Input_halfedge_index h)
  {
    bool is_flat = false;
    h = first_halfedge(h);
    for(const Face_side& side : computed(h)) {
      m_sides[h] = side;
      is_flat = is_flat || !(side.y > flat_face * (side.length + std::abs(side.x)));
      h = side.next;
    }
    return is_flat;
  }

  /* The same of a face that has been asked for. */
  const Face_side& known(Input_halfedge_index h) const { return m_sides[h]; }

  /* Of any face, as a copy. */
  Face_side copy(Input_halfedge_index h) const
  {
    if(m_sides[h].length != 0)
      return m_sides[h];
    const Input_halfedge_index first = first_halfedge(h);
    return computed(first)[h == first ? 0 : (h == m_triangulation.input().next(first) ? 1 : 2)];
  }

private:
  // The same for each halfedge of a face.
  Input_halfedge_index first_halfedge(Input_halfedge_index h) const
  {
    const Input_halfedge_index hn = m_triangulation.input().next(h);
    return (std::min)({h, hn, m_triangulation.input().next(hn)});
  }

  enum class State : unsigned char { UNKNOWN, BEING_COMPUTED, KNOWN };

  std::atomic<State>& state(Input_halfedge_index h) { return m_states[static_cast<std::size_t>(h.idx())]; }

  bool compute_claimed(Input_halfedge_index h)
  {
    const auto& input = m_triangulation.input();
    h = first_halfedge(h);
    try {
      const bool result = compute(h);
      state(input.next(input.next(h))).store(State::KNOWN, std::memory_order_release);
      state(input.next(h)).store(State::KNOWN, std::memory_order_release);
      state(h).store(State::KNOWN, std::memory_order_release);
      return result;
    } catch(...) {
      state(h).store(State::UNKNOWN, std::memory_order_release);
      throw;
    }
  }

  // Those of a face, from h on.
  std::array<Face_side, 3> computed(Input_halfedge_index h) const
  {
    const auto& input = m_triangulation.input();
    const auto v = input_face_geometry(m_triangulation, h);
    const Input_halfedge_index hn = input.next(h), hp = input.next(hn);
    const double length = v[0].x, next = std::hypot(v[1].x, v[1].y), previous = std::hypot(v[2].x, v[2].y);
    // Light passes a face without area, too: from a vertex on its longest side into the face beyond.
    const double height = (std::max)(v[1].y, least_face_height * length), area = length * height;
    // The sum cancels if the side at the tail is short, and the angle there would be wrong.
    const double x = previous < short_side * length ? -v[2].x : length + v[1].x;
    const double xn = -length * v[1].x / next, xp = -(v[1].x * v[2].x + v[1].y * v[2].y) / previous;
    return {{{length, x, height, x / previous, height / previous, hn, input.tail(h)},
             {next, xn, area / next, xn / length, area / (next * length), hp, input.tail(hn)},
             {previous, xp, area / previous, xp / next, area / (previous * next), h, input.tail(hp)}}};
  }

  // Up to this ratio a difference of lengths has errors in the angle of at most eight roundings.
  static constexpr double short_side = 0.125;

  const Triangulation& m_triangulation;
  Indexed_by<Input_halfedge_index, Lazy_array<Face_side>> m_sides;
  std::vector<std::atomic<State>> m_states; // of faces, by each of their halfedges; empty if one thread computes them
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FACE_SIDES_H
