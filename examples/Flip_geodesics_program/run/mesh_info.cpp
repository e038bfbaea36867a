// SPDX-License-Identifier: LGPL-3.0-or-later

#include "run/mesh_info.h"

#include "readable.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace program {

Mesh_info mesh_info(const Mesh& mesh, const std::vector<std::string>& defects)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<std::size_t> component(mesh.number_of_faces());
  Mesh_info info;
  info.defects = defects;
  info.components.resize(PMP::connected_components(
      mesh, boost::make_iterator_property_map(component.begin(), get(boost::face_index, mesh))));
  const auto at = [&](Mesh::Halfedge_index h) -> Component_info& {
    return info.components[component[mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h)]];
  };
  for(const Mesh::Vertex_index v : mesh.vertices())
    mesh.is_isolated(v) ? ++info.isolated_vertices : ++at(mesh.halfedge(v)).vertices;
  info.shortest_edge = std::numeric_limits<double>::infinity();
  for(const Mesh::Edge_index e : mesh.edges()) {
    ++at(mesh.halfedge(e)).edges;
    const double length = std::sqrt(PMP::squared_edge_length(e, mesh));
    info.shortest_edge = (std::min)(info.shortest_edge, length);
    info.longest_edge = (std::max)(info.longest_edge, length);
    info.degenerate_edges += PMP::is_degenerate_edge(e, mesh) ? 1 : 0;
  }
  for(const Mesh::Face_index f : mesh.faces()) {
    ++info.components[component[f]].faces;
    info.degenerate_faces += PMP::is_degenerate_triangle_face(f, mesh) ? 1 : 0;
  }
  std::vector<Mesh::Halfedge_index> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  for(const Mesh::Halfedge_index h : borders)
    ++at(h).borders;
  info.area = PMP::area(mesh);
  return info;
}

std::string describe(const Mesh_info& info, const Mesh& mesh)
{
  constexpr std::size_t most_lines = 20;
  std::ostringstream out;
  out << "size        " << size_of(mesh) << ", the diagonal of the bounding box; area " << info.area << "\nedges       "
      << readable(mesh.number_of_edges()) << ", of length " << info.shortest_edge << " to " << info.longest_edge << "; "
      << counted(info.degenerate_edges, "degenerate edge", "degenerate edges") << ", "
      << counted(info.degenerate_faces, "degenerate face", "degenerate faces") << ", "
      << counted(info.isolated_vertices, "isolated vertex", "isolated vertices") << "\ncomponents  "
      << readable(info.components.size()) << '\n';
  for(std::size_t i = 0; i < (std::min)(most_lines, info.components.size()); ++i) {
    const Component_info& c = info.components[i];
    out << "  " << i << ": " << counted(c.vertices, "vertex", "vertices") << ", "
        << counted(c.faces, "triangle", "triangles") << ", genus " << c.genus() << ", "
        << counted(c.borders, "border", "borders") << '\n';
  }
  out << "defects     " << (info.defects.empty() ? "none\n" : "and what --repair does:\n");
  for(const std::string& line : info.defects)
    out << "  " << line << '\n';
  return out.str();
}

} // namespace program
