// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_INPUT_MESH_H
#define CGAL_FLIP_GEODESICS_PROGRAM_INPUT_MESH_H

#include "input/input_text.h"
#include "messages.h"
#include "program_mesh.h"

#include <CGAL/Flip_geodesics/Repair_report.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace program {

/*!
 * The mesh of the program, and what its elements are called in the file.
 *
 * A repair leaves vertices the numbers that they have in the file, and appends those that it adds; numbers of results
 * are those of the mesh. Faces are renumbered.
 */
class Input_mesh
{
  using Repair_report = CGAL::Flip_geodesics::Repair_report;

public:
  /// A mesh that is as in the file. \param remarks lines about the file for the user
  explicit Input_mesh(Mesh mesh, std::vector<std::string> remarks = {})
    : m_mesh(std::move(mesh))
    , m_remarks(std::move(remarks))
  {
  }

  /// A mesh that was repaired.
  Input_mesh(Mesh mesh, Repair_report report, std::vector<std::string> remarks)
    : m_mesh(std::move(mesh))
    , m_report(std::move(report))
    , m_remarks(std::move(remarks))
  {
  }

  const Mesh& mesh() const { return m_mesh; }
  operator const Mesh&() const { return m_mesh; }
  bool is_repaired() const { return m_report.has_value(); }

  /*!
   * The vertex that a user names by its number: another one if a repair merged it into that, the first of its parts if
   * it was split. \param name where the user does so, for messages \param alternative what to write instead, for
   * messages \throws Bad_input if there is none
   */
  Vertex_index vertex(long long v, const std::string& name, const std::string& alternative = "") const
  {
    if(v < 0 || v >= static_cast<long long>(m_mesh.number_of_vertices()))
      throw Bad_input(name + ": vertex " + std::to_string(v) + " does not exist; use 0 to " +
                      std::to_string(m_mesh.number_of_vertices() - 1) + alternative);
    const auto point = static_cast<std::size_t>(v);
    if(!m_report || point >= m_report->number_of_points())
      return Vertex_index(static_cast<Index>(v));
    const auto parts = m_report->vertices_of_point(point);
    if(parts.empty())
      throw Bad_input(name + ": vertex " + std::to_string(v) + " has no faces after the repair; choose another one");
    if(parts.size() > 1)
      note_split(parts, name, point);
    return Vertex_index(static_cast<Index>(parts.front()));
  }

  /// The text that the mesh was read from, if somebody needs more of it: a pipe is not read twice.
  const Input_text& text() const { return m_text.value(); }
  void keep_text(const Input_text& text) { m_text = text; }

  /// The number of faces in the file.
  std::size_t number_of_faces_in_file() const
  {
    return m_report ? m_report->number_of_polygons() : m_mesh.number_of_faces();
  }

  /// The face in the file that a face of the mesh comes from.
  std::size_t face_in_file(Mesh::Face_index f) const { return m_report ? m_report->polygon_of_face(f) : f; }

  /// Is a vertex of the mesh, or one merged into it, the vertex with this number in the file?
  bool comes_from(Mesh::Vertex_index v, std::size_t point) const
  {
    const auto number = static_cast<std::size_t>(v);
    if(!m_report)
      return number == point;
    const auto parts = m_report->vertices_of_point(point);
    return std::find(parts.begin(), parts.end(), number) != parts.end();
  }

  /// Lines about the file, what a repair did, which of the vertices that the user named it has split, and how far points
  /// are from the mesh.
  std::vector<std::string> remarks() const
  {
    std::vector<std::string> lines = m_remarks;
    if(m_report)
      for(const std::string& line : m_report->lines())
        lines.push_back("repair: " + line);
    for(const auto& point_and_line : m_splits)
      lines.push_back(point_and_line.second);
    if(m_number_of_projections > 0) {
      std::ostringstream line;
      line << counted(m_number_of_projections, "point is", "points are") << " not on the mesh, but at a distance of "
           << (m_number_of_projections > 1 ? "up to " : "") << m_farthest.first << " (" << m_farthest.second
           << "); the nearest point of the mesh is used" << (m_number_of_projections > 1 ? " for each" : "");
      lines.push_back(line.str());
    }
    return lines;
  }

  /// Remembers that a point was replaced by the nearest point of the mesh, at a distance.
  void note_projection(double distance, const std::string& name) const
  {
    constexpr double rounding = 1e-6; // of the size, as coordinates are often written with six digits
    if(!m_size)
      m_size = size_of(m_mesh);
    if(!(distance > rounding * *m_size))
      return;
    ++m_number_of_projections;
    if(distance > m_farthest.first)
      m_farthest = {distance, name};
  }

private:
  void note_split(const Repair_report::Elements& parts, const std::string& name, std::size_t point) const
  {
    std::string line = name + ": vertex " + std::to_string(point) + " was split by the repair into the vertices";
    for(const std::size_t part : parts)
      line += (part == parts.front() ? " " : ", ") + std::to_string(part);
    m_splits.emplace(point, line + "; " + "vertex " + std::to_string(parts.front()) + " is used");
  }

  Mesh m_mesh;
  std::optional<Repair_report> m_report;
  std::vector<std::string> m_remarks;
  std::optional<Input_text> m_text;
  mutable std::optional<double> m_size; // of the mesh, once it is required
  mutable std::size_t m_number_of_projections = 0;
  mutable std::pair<double, std::string> m_farthest;   // distance, and where the point is
  mutable std::map<std::size_t, std::string> m_splits; // the requested ones, by the vertex in the file
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_INPUT_MESH_H
