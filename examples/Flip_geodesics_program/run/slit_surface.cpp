// SPDX-License-Identifier: LGPL-3.0-or-later

#include "run/slit_surface.h"

#include <CGAL/Flip_geodesics/Slit_mesh.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>

namespace program {

namespace FG = CGAL::Flip_geodesics;

Slit_surface::Slit_surface(const Mesh& mesh, const Obstacles& obstacles)
  : m_mesh(&mesh)
  , m_surface(obstacles.are_none() ? &mesh : &m_slit)
{
  if(is_mesh())
    return;
  const auto is_free = [&](Mesh::Face_index f) { return obstacles.faces.count(f) == 0; };
  const auto is_barrier = [&](Mesh::Edge_index e) {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    return obstacles.walls.count(e) != 0 ||
           (!mesh.is_border(e) && is_free(mesh.face(h)) != is_free(mesh.face(mesh.opposite(h))));
  };
  const FG::Slit_mesh<Mesh> slit(mesh, boost::make_function_property_map<Mesh::Edge_index>(is_barrier));
  std::map<FG::Slit_mesh<Mesh>::Vertex, Mesh::Vertex_index> numbers;
  for(const auto& v : slit.all_vertices()) {
    numbers[v] = m_slit.add_vertex(mesh.point(v.vertex));
    m_vertices.push_back(index_of(v.vertex));
  }
  m_sides.resize(mesh.number_of_halfedges());
  for(const Mesh::Face_index f : mesh.faces()) {
    std::vector<Mesh::Vertex_index> corners;
    for(const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      corners.push_back(numbers.at(slit.vertex_in_face(h)));
    if(is_free(f))
      add_face(f, corners);
  }
  m_copies.resize(mesh.number_of_vertices());
  for(const Mesh::Vertex_index v : m_slit.vertices()) {
    if(m_slit.is_isolated(v))
      continue;
    const Vertex_index of_mesh = m_vertices[static_cast<std::size_t>(v)];
    m_copies[static_cast<std::size_t>(of_mesh.idx())].push_back(index_of(v));
    if(!m_slit.is_border(v)) // directions are measured from the same halfedge
      m_slit.set_halfedge(v, m_sides[static_cast<std::size_t>(mesh.halfedge(mesh_vertex(of_mesh)))]);
  }
}

void Slit_surface::add_face(Mesh::Face_index f, const std::vector<Mesh::Vertex_index>& corners)
{
  const Mesh::Face_index added = m_slit.add_face(corners);
  if(added == Mesh::null_face())
    throw std::runtime_error("the mesh cannot be cut open: one of its vertices is non-manifold; use --repair");
  m_halfedges.resize(m_slit.number_of_halfedges());
  Mesh::Halfedge_index side = m_slit.halfedge(added);
  while(m_slit.source(side) != corners.front())
    side = m_slit.next(side);
  for(const Mesh::Halfedge_index h : m_mesh->halfedges_around_face(m_mesh->halfedge(f))) {
    m_halfedges[static_cast<std::size_t>(side)] = h;
    m_sides[static_cast<std::size_t>(h)] = side;
    side = m_slit.next(side);
  }
}

// All points of the slit mesh that are one point of the mesh.
std::vector<FG::Surface_location> Slit_surface::places(const Surface_location& location) const
{
  const Surface_location at = FG::internal::canonical_location(FG::Numbered_mesh<Mesh>(*m_mesh), location);
  const Mesh::Halfedge_index h = mesh_halfedge(at.halfedge), side = m_sides[static_cast<std::size_t>(h)];
  std::vector<Surface_location> result;
  if(kind(at) == FG::Location_kind::VERTEX) {
    for(const Vertex_index v : copies(index_of(m_mesh->source(h))))
      result.push_back({index_of(m_slit.opposite(m_slit.halfedge(mesh_vertex(v)))), at.weights});
    return result;
  }
  if(side != Mesh::null_halfedge())
    result.push_back({index_of(side), at.weights});
  const Mesh::Halfedge_index other = m_sides[static_cast<std::size_t>(m_mesh->opposite(h))];
  if(kind(at) == FG::Location_kind::EDGE && other != Mesh::null_halfedge() &&
     (side == Mesh::null_halfedge() || m_slit.opposite(side) != other))
    result.push_back({index_of(other), {{at.weights[1], at.weights[0], 0}}});
  return result;
}

std::string Slit_surface::obstruction(std::size_t number_of_places)
{
  return number_of_places == 1   ? ""
         : number_of_places == 0 ? "lies inside an obstacle of --avoid; choose another point"
                                 : "lies on a barrier of --avoid, or where obstacles meet; choose a point next to it";
}

Mesh::Halfedge_index Slit_surface::halfedge_of_mesh(Mesh::Halfedge_index h) const
{
  if(is_mesh())
    return h;
  return m_slit.is_border(h) ? m_mesh->opposite(m_halfedges[static_cast<std::size_t>(m_slit.opposite(h))])
                             : m_halfedges[static_cast<std::size_t>(h)];
}

void Slit_surface::put_on_mesh(Curve_result& curve) const
{
  curve.source = vertex_of_mesh(curve.source);
  curve.target = vertex_of_mesh(curve.target);
  for(Curve_point& point : curve.points) {
    FG::Surface_point& p = point.on_surface;
    for(Vertex_index* const v : {&p.a, &p.b, &p.c, &p.vertex})
      *v = vertex_of_mesh(*v);
    if(p.halfedge.is_valid())
      p.halfedge = index_of(halfedge_of_mesh(mesh_halfedge(p.halfedge)));
  }
}

} // namespace program
