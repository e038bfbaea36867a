// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_MESH_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_MESH_INPUT_H

#include "input/input_mesh.h"
#include "input/input_text.h"
#include "input/read_obj.h"
#include "input/read_off.h"
#include "input/read_ply.h"
#include "input/read_stl.h"
#include "input/read_ts.h"
#include "program_mesh.h"
#include "run/progress.h"

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/polygon_soup_to_triangle_mesh.h>

#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Reads the mesh of the program, as a soup first, so that an error can name its element and vertices keep the numbers
// that they have in the file.
namespace program {

using Format_reader = Soup (*)(const Input_text&);

/// How meshes are read, by the extensions of their files.
inline const std::map<std::string, Format_reader>& mesh_formats()
{
  static const std::map<std::string, Format_reader> formats = {
      {"off", read_off},
      {"obj", [](const Input_text& input) { return read_obj(input); }},
      {"ply", read_ply},
      {"stl", read_stl},
      {"ts", read_ts}};
  return formats;
}

/// The formats, each after a blank.
inline std::string names_of_mesh_formats()
{
  std::string names;
  for(const auto& [name, reader] : mesh_formats())
    names += (names.empty() ? "" : ", ") + name;
  return names;
}

/// The soup in the text of a mesh. \throws Bad_input
inline Soup read_soup(const Input_text& input)
{
  const auto format = mesh_formats().find(input.format());
  if(format != mesh_formats().end())
    return format->second(input);
  throw Bad_input(input.name() +
                  (input.file() == standard_stream ? ": the format is not specified"
                                                   : ": the extension does not determine the format") +
                  "; use --format with one of " + names_of_mesh_formats());
}

// What has to hold of a soup of polygons so that it is a mesh of triangles, except that it is an oriented manifold.
// \throws Bad_input that names the first element that is wrong, counted from 0
inline void check_soup(const Soup& soup)
{
  if(soup.faces.empty())
    throw Bad_input("the file has no faces; use a triangle mesh");
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    for(int i = 0; i < 3; ++i)
      if(!std::isfinite(soup.points[v][i]))
        throw Bad_input("vertex " + std::to_string(v) + " has a coordinate that is not a finite number; correct it");
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const std::vector<std::size_t>& face = soup.faces[f];
    const std::string name = "face " + std::to_string(f);
    if(face.size() != 3)
      throw Bad_input(name + " has " + counted(face.size(), "vertex", "vertices") +
                      ", but only triangles are accepted; " +
                      (face.size() < 3 ? "remove the face" : "triangulate the mesh"));
    if(face[0] == face[1] || face[1] == face[2] || face[2] == face[0])
      throw Bad_input(name + " has vertex " + std::to_string(face[0] == face[1] ? face[0] : face[2]) +
                      " more than once; remove the face");
  }
}

// Why a mesh is not a manifold at one of its vertices.
inline std::string message_of_vertex(Mesh::Vertex_index v, std::size_t face)
{
  return "vertex " + std::to_string(v) +
         " is not manifold: parts of the surface meet there without a common edge, and " + "face " +
         std::to_string(face) + " belongs to one of them; duplicate the vertex";
}

// Why a mesh, an oriented manifold, cannot have another face with some vertices.
inline std::string message_of_face(const Mesh& mesh, const std::array<Mesh::Vertex_index, 3>& face)
{
  const std::size_t number = mesh.number_of_faces();
  const auto name = [&](Mesh::Halfedge_index h) { return std::to_string(mesh.face(h)); };
  for(std::size_t i = 0; i < 3; ++i) {
    const Mesh::Vertex_index v = face[i], w = face[(i + 1) % 3];
    const Mesh::Halfedge_index h = mesh.halfedge(v, w);
    if(h == Mesh::null_halfedge() || mesh.is_border(h))
      continue;
    if(mesh.target(mesh.next(h)) == face[(i + 2) % 3])
      return "face " + std::to_string(number) + " has the same vertices as face " + name(h) + "; remove one of them";
    const std::string edge = "the edge between vertices " + std::to_string((std::min)(v, w)) + " and " +
                             std::to_string((std::max)(v, w)) + " has ";
    if(mesh.is_border(mesh.opposite(h)))
      return edge + "faces " + name(h) + " and " + std::to_string(number) +
             " of opposite orientation; orient the faces consistently";
    return edge + "more than two faces, among them " + name(h) + ", " + name(mesh.opposite(h)) + " and " +
           std::to_string(number) + ", so the mesh is not a manifold; remove or separate faces";
  }
  const auto is_inside = [&](Mesh::Vertex_index v) { return !mesh.is_isolated(v) && !mesh.is_border(v, true); };
  return message_of_vertex(*std::find_if(face.begin(), face.end() - 1, is_inside), number);
}

/// The mesh of a soup, with the same numbers of vertices and faces. \throws Bad_input that names the first element that
/// is wrong
inline Mesh mesh_of_soup(const Soup& soup)
{
  check_soup(soup);
  Mesh mesh;
  mesh.reserve(soup.points.size(), 2 * soup.faces.size(), soup.faces.size());
  for(const Point_3& p : soup.points)
    mesh.add_vertex(p);
  for(const std::vector<std::size_t>& face : soup.faces) {
    std::array<Mesh::Vertex_index, 3> vertices;
    for(std::size_t i = 0; i < 3; ++i)
      vertices[i] = Mesh::Vertex_index(static_cast<Mesh::size_type>(face[i]));
    if(CGAL::Euler::add_face(vertices, mesh) == Mesh::null_face())
      throw Bad_input(message_of_face(mesh, vertices));
  }
  std::vector<Mesh::Halfedge_index> fans;
  CGAL::Polygon_mesh_processing::non_manifold_vertices(mesh, std::back_inserter(fans));
  for(const Mesh::Halfedge_index h : fans)
    throw Bad_input(message_of_vertex(mesh.target(h), mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h)));
  return mesh;
}

/// The mesh in a text, an oriented manifold of triangles. \throws Bad_input with one line that names the file and the
/// element
inline Input_mesh read_mesh(const Input_text& input)
{
  Soup soup = read_soup(input);
  try {
    return Input_mesh(mesh_of_soup(soup), std::move(soup.remarks));
  } catch(const Bad_input& error) {
    throw Bad_input(input.name() + ": " + error.what() + (soup.faces.empty() ? "" : ", or use --repair"));
  }
}

/// Reads whatever a file holds and repairs it, with a tolerance within which points are welded. \throws Bad_input if
/// nothing is left
inline Input_mesh repair_mesh(Input_text input, double weld_tolerance, Progress& progress)
{
  namespace FG = CGAL::Flip_geodesics;
  input.allow_points_not_finite();
  Soup soup = read_soup(input);
  if(soup.faces.empty())
    throw Bad_input(input.name() + ": the file has no faces; use a mesh with faces");
  progress.enter("repairing the mesh", "polygons", soup.faces.size());
  Share_visitor share(progress);
  Mesh mesh;
  try {
    FG::Repair_report report = FG::polygon_soup_to_triangle_mesh(soup.points, soup.faces, mesh,
                                                                 CGAL::parameters::snapping_tolerance(weld_tolerance),
                                                                 CGAL::parameters::visitor(std::ref(share)));
    return Input_mesh(std::move(mesh), std::move(report), std::move(soup.remarks));
  } catch(const FG::Error& error) {
    throw Bad_input(input.name() + ": " + error.what() + "; use another mesh");
  }
}

/// The mesh in a text as it is, or repaired if it has to be or points are welded, with the remarks of a repair.
/// \throws Bad_input
inline Input_mesh inspect_mesh(const Input_text& input, double weld_tolerance, Progress& progress)
{
  Input_mesh repaired = repair_mesh(input, weld_tolerance, progress);
  if(weld_tolerance > 0)
    return repaired;
  try {
    return Input_mesh(read_mesh(input).mesh(), repaired.remarks());
  } catch(const Bad_input&) {
    return repaired;
  }
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_MESH_INPUT_H
