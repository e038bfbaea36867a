// SPDX-License-Identifier: LGPL-3.0-or-later

#include "messages.h"
#include "run/computations.h"

#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

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

namespace {

bool is_length_in_range(double length)
{
  namespace internal = CGAL::Flip_geodesics::internal;
  return length >= internal::least_length && length <= internal::greatest_length;
}

// Squares of lengths that are out of range may underflow or overflow.
double edge_length(Mesh::Edge_index e, const Mesh& mesh)
{
  const double length = std::sqrt(CGAL::Polygon_mesh_processing::squared_edge_length(e, mesh));
  if(is_length_in_range(length))
    return length;
  const Kernel::Vector_3 v(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  return std::hypot(v.x(), v.y(), v.z());
}

} // namespace

Mesh_info mesh_info(const Mesh& mesh, bool is_repaired, const std::vector<std::string>& defects)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<std::size_t> component(mesh.number_of_faces());
  Mesh_info info;
  info.is_repaired = is_repaired;
  info.defects = defects;
  info.components.resize(PMP::connected_components(
      mesh, boost::make_iterator_property_map(component.begin(), get(boost::face_index, mesh))));
  const auto at = [&](Mesh::Halfedge_index h) -> Component_info& {
    return info.components[component[mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h)]];
  };
  for(const Mesh::Vertex_index v : mesh.vertices())
    mesh.is_isolated(v) ? ++info.isolated_vertices : ++at(mesh.halfedge(v)).vertices;
  std::size_t edges_out_of_range = 0;
  info.shortest_edge = std::numeric_limits<double>::infinity();
  for(const Mesh::Edge_index e : mesh.edges()) {
    ++at(mesh.halfedge(e)).edges;
    const double length = edge_length(e, mesh);
    info.shortest_edge = (std::min)(info.shortest_edge, length);
    info.longest_edge = (std::max)(info.longest_edge, length);
    if(PMP::is_degenerate_edge(e, mesh))
      ++info.degenerate_edges;
    else if(!is_length_in_range(length))
      ++edges_out_of_range;
  }
  if(edges_out_of_range > 0)
    info.defects.push_back(counted(edges_out_of_range, "edge has a length", "edges have lengths") +
                           " outside the range from 1e-70 to 1e70; scale the mesh to compute curves");
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
  out << "defects     "
      << (info.defects.empty() ? "none\n"
          : info.is_repaired   ? "found in the file; the numbers above describe the mesh after the repair:\n"
                               : "found in the file; the numbers above describe the mesh before any repair:\n");
  for(const std::string& line : info.defects)
    out << "  " << line << '\n';
  return out.str();
}

} // namespace program
