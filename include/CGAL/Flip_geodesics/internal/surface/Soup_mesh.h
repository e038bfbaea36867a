// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_MESH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_MESH_H

#include <CGAL/Flip_geodesics/internal/surface/Triangle_soup.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class Kernel>
using Soup_mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;

/*
 * A soup as a mesh, for what needs neighbors: vertex v of the soup has index v, triangle t index t.
 *
 * \pre the soup is an oriented manifold
 */
template <class Kernel>
Soup_mesh<Kernel> make_soup_mesh(const Triangle_soup<Kernel>& soup)
{
  std::vector<typename Kernel::Point_3> points;
  points.reserve(soup.origins.size());
  for(std::size_t v = 0; v < soup.origins.size(); ++v)
    points.push_back(soup.point(v));
  Soup_mesh<Kernel> mesh;
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.triangles, mesh);
  return mesh;
}

/* The corners of a face, from the head of its halfedge on. */
template <class Mesh>
std::array<std::size_t, 3> corners(const Mesh& mesh, typename Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {static_cast<std::size_t>(mesh.target(h)), static_cast<std::size_t>(mesh.target(mesh.next(h))),
          static_cast<std::size_t>(mesh.source(h))};
}

/* For each face its component, connected by edges, counted from 0 in the order of their first faces. */
template <class Mesh>
std::vector<std::size_t> face_components(Mesh& mesh)
{
  const auto map = mesh.template add_property_map<typename Mesh::Face_index, std::size_t>("f:component", 0).first;
  Polygon_mesh_processing::connected_components(mesh, map);
  std::vector<std::size_t> result;
  for(const auto f : mesh.faces())
    result.push_back(get(map, f));
  return result;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_MESH_H
