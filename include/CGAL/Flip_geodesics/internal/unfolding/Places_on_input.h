// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PLACES_ON_INPUT_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PLACES_ON_INPUT_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PLACES_ON_INPUT_H
