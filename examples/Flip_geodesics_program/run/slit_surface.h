// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SLIT_SURFACE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SLIT_SURFACE_H

#include "input/requests.h"
#include "messages.h"
#include "program_mesh.h"
#include "run/curve_engine.h"

#include <CGAL/Flip_geodesics/Surface_point.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <string>
#include <vector>

// The surface and the metric that obstacles and weights leave.
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

/// Where a point lies on a surface. \throws Bad_input if an obstacle is there
inline CGAL::Flip_geodesics::Surface_location located(const Slit_surface& surface, const Named_point& point)
{
  if(const std::string why = surface.obstruction(point.at); !why.empty())
    throw Bad_input(point.name + ' ' + why);
  return surface.located(point.at);
}

/// \throws Bad_input if weights leave no triangle of a face
template <class Metric>
void check_faces(const Slit_surface& surface, const Metric& metric, const std::string& name)
{
  const Mesh& mesh = surface.mesh();
  const typename Metric::Mesh numbered(mesh);
  for(const Mesh::Face_index f : mesh.faces()) {
    const Input_halfedge_index h = index_of(mesh.halfedge(f)), hn = numbered.next(h), hp = numbered.next(hn);
    if(CGAL::Flip_geodesics::internal::satisfy_triangle_inequality(
           metric.weight(numbered, h), metric.weight(numbered, hn), metric.weight(numbered, hp)))
      continue;
    const auto vertex = [&](Input_halfedge_index side) {
      return std::to_string(surface.vertex_of_mesh(numbered.tail(side)).idx());
    };
    throw Bad_input(name + ": with these weights, the sides of the face with vertices " + vertex(h) + ", " +
                    vertex(hn) + " and " + vertex(hp) +
                    " violate the triangle inequality; use weights that vary less, or --mollify");
  }
}

/// Calls `use(metric)` with the metric of a surface under some conditions. \throws Bad_input
template <class Use>
auto with_metric(const Slit_surface& surface, const Path_conditions& conditions, const Use& use)
{
  namespace FG = CGAL::Flip_geodesics;
  const Mesh& mesh = surface.mesh();
  const Mesh_metric metric(mesh.points());
  if(!conditions.weights)
    return use(mollified_metric(mesh, metric, conditions.mollify));
  const Weights& weights = *conditions.weights;
  const auto weight_of_face = [&](Mesh::Face_index f) { return weights.of_faces[surface.face_of_mesh(f)]; };
  const auto weight_of_edge = [&](Mesh::Edge_index e) { return weights.of_edges[surface.edge_of_mesh(e)]; };
  const FG::Weighted_metric<Mesh_metric> weighted =
      weights.of_edges.empty()
          ? FG::Weighted_metric(mesh, metric, boost::make_function_property_map<Mesh::Face_index>(weight_of_face))
          : FG::Weighted_metric(mesh, metric, boost::make_function_property_map<Mesh::Edge_index>(weight_of_edge));
  if(!conditions.mollify)
    check_faces(surface, weighted, weights.name);
  return use(mollified_metric(mesh, weighted, conditions.mollify));
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SLIT_SURFACE_H
