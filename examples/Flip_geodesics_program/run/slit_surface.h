// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SLIT_SURFACE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SLIT_SURFACE_H

#include "input/requests.h"
#include "program_mesh.h"
#include "run/curve_engine.h"

#include <CGAL/Flip_geodesics/Surface_point.h>

#include <cstddef>
#include <string>
#include <vector>

namespace program {

/*!
 * What obstacles leave of a mesh: a mesh of its own, without their faces, and cut open along barriers and where faces are
 * missing. Without obstacles it is the mesh itself, which must outlive the object.
 */
class Slit_surface
{
  using Surface_location = CGAL::Flip_geodesics::Surface_location;

public:
  Slit_surface(const Mesh& mesh, const Obstacles& obstacles);
  Slit_surface(const Slit_surface&) = delete;
  Slit_surface& operator=(const Slit_surface&) = delete;

  const Mesh& mesh() const { return *m_surface; }

  /// Why a point of the mesh is not one of this surface, without its name; empty if it is.
  std::string obstruction(const Surface_location& at) const { return obstruction(is_mesh() ? 1 : places(at).size()); }
  std::string obstruction(Vertex_index v) const { return obstruction(is_mesh() ? 1 : copies(v).size()); }

  /// The point of this surface that is a point of the mesh. \pre nothing obstructs it
  Surface_location located(const Surface_location& at) const { return is_mesh() ? at : places(at).front(); }
  Vertex_index located(Vertex_index v) const { return is_mesh() ? v : copies(v).front(); }

  /// The elements of the mesh that are elements of this surface.
  Vertex_index vertex_of_mesh(Vertex_index v) const
  {
    return is_mesh() || !v.is_valid() ? v : m_vertices[static_cast<std::size_t>(v.idx())];
  }
  Mesh::Halfedge_index halfedge_of_mesh(Mesh::Halfedge_index h) const;
  Mesh::Face_index face_of_mesh(Mesh::Face_index f) const { return m_mesh->face(halfedge_of_mesh(mesh().halfedge(f))); }

  Mesh::Edge_index edge_of_mesh(Mesh::Edge_index e) const { return m_mesh->edge(halfedge_of_mesh(mesh().halfedge(e))); }

  /// Lets a curve on this surface be one on the mesh.
  void put_on_mesh(Curve_result& curve) const;

private:
  bool is_mesh() const { return m_surface != &m_slit; }
  const std::vector<Vertex_index>& copies(Vertex_index v) const { return m_copies[static_cast<std::size_t>(v.idx())]; }
  static std::string obstruction(std::size_t number_of_places);
  std::vector<Surface_location> places(const Surface_location& at) const;
  void add_face(Mesh::Face_index f, const std::vector<Mesh::Vertex_index>& corners);

  const Mesh* m_mesh;
  const Mesh* m_surface;
  Mesh m_slit;
  std::vector<Vertex_index> m_vertices;                   // of the mesh, by vertices of the slit mesh
  std::vector<std::vector<Vertex_index>> m_copies;        // with faces, by vertices of the mesh
  std::vector<Mesh::Halfedge_index> m_halfedges, m_sides; // of faces: of the mesh, and of the slit mesh
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SLIT_SURFACE_H
