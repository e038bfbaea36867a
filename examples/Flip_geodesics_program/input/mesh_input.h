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
#include "input/soup_checks.h"
#include "program_mesh.h"

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/polygon_soup_to_triangle_mesh.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <map>
#include <string>
#include <utility>

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
    names += ' ' + name;
  return names;
}

/// The soup in the text of a mesh. \throws Bad_input
inline Soup read_soup(const Input_text& input)
{
  const auto format = mesh_formats().find(input.format());
  if(format != mesh_formats().end())
    return format->second(input);
  throw Bad_input(input.name() + ": the extension does not determine the format; use --format with one of" +
                  names_of_mesh_formats());
}

/// The mesh in a text, an oriented manifold of triangles. \throws Bad_input with one line that names the file and the
/// element
inline Input_mesh read_mesh(const Input_text& input)
{
  Soup soup = read_soup(input);
  try {
    check_soup(soup);
  } catch(const Bad_input& error) {
    throw Bad_input(input.name() + ": " + error.what() + (soup.faces.empty() ? "" : ", or use --repair"));
  }
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  if(mesh.number_of_faces() != soup.faces.size())
    throw Bad_input(input.name() + ": the faces do not form an oriented manifold; use --repair");
  return Input_mesh(std::move(mesh), std::move(soup.remarks));
}

/// Reads whatever a file holds and repairs it, with a tolerance within which points are welded. \throws Bad_input if
/// nothing is left
inline Input_mesh repair_mesh(Input_text input, double weld_tolerance = 0)
{
  namespace FG = CGAL::Flip_geodesics;
  input.allow_points_not_finite();
  Soup soup = read_soup(input);
  if(soup.faces.empty())
    throw Bad_input(input.name() + ": the file has no faces; use a mesh with faces");
  Mesh mesh;
  try {
    FG::Repair_report report = FG::polygon_soup_to_triangle_mesh(soup.points, soup.faces, mesh,
                                                                 CGAL::parameters::snapping_tolerance(weld_tolerance));
    return Input_mesh(std::move(mesh), std::move(report), std::move(soup.remarks));
  } catch(const FG::Error& error) {
    throw Bad_input(input.name() + ": " + error.what() + "; use another mesh");
  }
}

/// The mesh in a text as it is, or repaired if it has to be, with the remarks of a repair. \throws Bad_input
inline Input_mesh inspect_mesh(const Input_text& input, double weld_tolerance)
{
  Input_mesh repaired = repair_mesh(input, weld_tolerance);
  try {
    return Input_mesh(read_mesh(input).mesh(), repaired.remarks());
  } catch(const Bad_input&) {
    return repaired;
  }
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_MESH_INPUT_H
