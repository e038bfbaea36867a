// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FIELD_STATE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FIELD_STATE_H

#include <CGAL/Flip_geodesics/internal/distances/Edge_windows.h>
#include <CGAL/Flip_geodesics/internal/distances/Face_sides.h>
#include <CGAL/Flip_geodesics/internal/distances/Round_items.h>
#include <CGAL/Flip_geodesics/internal/distances/Vertex_openings.h>
#include <CGAL/Flip_geodesics/internal/surface/Lazy_array.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* What is known of an edge while windows are propagated. */
struct Edge_record
{
  double due;        // the least distance of the windows that are waiting
  Round_place left;  // when it was left
  std::uint32_t tag; // of the last note: the bearing, and how many were made before
  bool is_waiting;   // are there windows that wait?
  bool is_noted;     // is it in the queue for when the front has passed it?
};

/* What is known of the vertices and edges of the input, while windows are propagated and afterwards. */
template <class Triangulation>
struct Field_state
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  explicit Field_state(const Triangulation& t)
    : triangulation(t)
    , sides(t)
    , windows(number_of_edges(t))
    , edges(number_of_edges(t))
    , left(static_cast<std::size_t>(t.input().number_of_vertices()))
    , vertices(static_cast<std::size_t>(t.input().number_of_vertices()))
  {
  }

  static std::size_t number_of_edges(const Triangulation& t)
  {
    return static_cast<std::size_t>(t.input().number_of_halfedges()) / 2;
  }
  static Index edge_of(Input_halfedge_index h) { return h.idx() / 2; }
  Edge_record& edge(Index e) { return edges[static_cast<std::size_t>(e)]; }

  bool is_reached(Vertex_index v) const { return vertices[v].is_reached; }
  double distance(Vertex_index v) const { return is_reached(v) ? vertices[v].distance : infinity; }
  bool is_shorter(Vertex_index v, double d) const { return !is_reached(v) || d < vertices[v].distance; }

  /* Notes when an edge is due. \param place has a member `bearing()` */
  template <class Place>
  void note_waiting(Index e, double due, const Place& place, Array_part<Noted>& noted)
  {
    Edge_record& record = edge(e);
    if(due == infinity || (record.is_waiting && record.due <= due))
      return;
    record.is_waiting = true;
    record.due = due;
    record.tag = record.tag / Bearing::number * Bearing::number + Bearing::number + place.bearing();
    *noted.last++ = {due, e, record.tag};
  }

  const Triangulation& triangulation;
  Face_sides<Triangulation> sides;
  Edge_windows windows;
  Lazy_array<Edge_record> edges;
  Indexed_by<Vertex_index, Lazy_array<Round_place>> left; // when paths started there
  Indexed_by<Vertex_index, Lazy_array<Vertex_record>> vertices;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FIELD_STATE_H
