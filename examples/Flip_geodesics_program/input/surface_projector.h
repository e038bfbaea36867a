// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SURFACE_PROJECTOR_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SURFACE_PROJECTOR_H

#include "input/input_mesh.h"
#include "messages.h"
#include "program_mesh.h"

#include <CGAL/Flip_geodesics/Surface_point.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/squared_distance_3.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace program {

/// Finds the nearest points of a mesh among its non-degenerate faces, which have all edges except those between two
/// degenerate faces. Barycentric coordinates below 1e-12 count as zero.
class Surface_projector
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= 1060000000
  using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
  using Tree = CGAL::AABB_tree<Traits>;

public:
  /// \throws Bad_input if no face has an area
  explicit Surface_projector(const Input_mesh& mesh)
    : m_input_mesh(mesh)
    , m_mesh(mesh)
  {
    std::vector<Mesh::Face_index> faces;
    std::copy_if(m_mesh.faces().begin(), m_mesh.faces().end(), std::back_inserter(faces),
                 [&](Mesh::Face_index f) { return has_area(f); });
    if(faces.empty())
      throw Bad_input("all faces of the mesh are degenerate, so points cannot be projected onto it; correct the mesh");
    m_tree.insert(faces.begin(), faces.end(), m_mesh);
    m_tree.build();
  }

  /// \param name where the point is, for a remark if it is not on the mesh
  CGAL::Flip_geodesics::Surface_location operator()(const Point_3& p, const std::string& name) const
  {
    const auto location = CGAL::Polygon_mesh_processing::locate_with_AABB_tree(p, m_tree, m_mesh);
    m_input_mesh.note_projection(
        std::sqrt(CGAL::squared_distance(p, CGAL::Polygon_mesh_processing::construct_point(location, m_mesh))), name);
    CGAL::Flip_geodesics::Surface_location result;
    result.halfedge = index_of(m_mesh.halfedge(location.first));
    for(std::size_t i = 0; i < 3; ++i)
      result.weights[i] = location.second[i] < 1e-12 ? 0 : location.second[i];
    return result;
  }

private:
  // Does what CGAL divides by for barycentric coordinates have an inverse?
  bool has_area(Mesh::Face_index f) const
  {
    const Mesh::Halfedge_index h = m_mesh.halfedge(f);
    const Point_3 &p = m_mesh.point(m_mesh.source(h)), &q = m_mesh.point(m_mesh.target(h));
    const Kernel::Vector_3 u = q - p, v = m_mesh.point(m_mesh.target(m_mesh.next(h))) - p;
    const double square = (u * u) * (v * v) - (u * v) * (u * v);
    return square != 0 && std::isfinite(1 / square);
  }

  const Input_mesh& m_input_mesh;
  const Mesh& m_mesh;
  Tree m_tree;
};

// CGAL's projection takes coordinates to the fifth power, and cannot do with infinity.
constexpr double largest_coordinate_to_project = 1e60;

inline void check_coordinates_to_project(const Mesh& mesh, const std::string& name)
{
  for(const auto v : mesh.vertices())
    for(int i = 0; i < 3; ++i)
      if(std::abs(mesh.point(v)[i]) > largest_coordinate_to_project)
        throw Bad_input(name + ": vertex " + std::to_string(v) +
                        " of the mesh has a coordinate beyond 1e60, so points cannot be projected onto it; scale the "
                        "mesh and the points");
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SURFACE_PROJECTOR_H
