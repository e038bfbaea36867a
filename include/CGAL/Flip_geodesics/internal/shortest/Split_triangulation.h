// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SPLIT_TRIANGULATION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SPLIT_TRIANGULATION_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Split_surface.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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

  /* The triangulation, which must outlive this, is afterwards as before. \pre it has not been flipped
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

  /* The vertex of a point, by its position among the points. */
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

/* The points of the only curve of a network in a triangulation of a split surface, as locations below. */
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SPLIT_TRIANGULATION_H
