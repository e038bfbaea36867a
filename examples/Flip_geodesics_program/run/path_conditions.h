// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PATH_CONDITIONS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PATH_CONDITIONS_H

#include "input/requests.h"
#include "messages.h"
#include "program_mesh.h"
#include "run/slit_surface.h"

#include <boost/property_map/function_property_map.hpp>

#include <string>

namespace program {

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
    throw Bad_input(name + ": with these weights, the sides of the face of vertices " + vertex(h) + ", " + vertex(hn) +
                    " and " + vertex(hp) +
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

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PATH_CONDITIONS_H
