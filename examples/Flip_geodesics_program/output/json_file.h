// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_JSON_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_JSON_FILE_H

#include "output/json_text.h"
#include "output/output_file.h"
#include "program_mesh.h"
#include "run/computations.h"
#include "run/curve_engine.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace program {

/*!
 * Writes the results of any command as one JSON object, whose members the manual describes. Numbers that are not finite
 * are null.
 */
class Json_file
{
public:
  /// With an empty name, nothing is written.
  Json_file(const std::string& name, const std::string& command)
    : m_file(name)
  {
    if(m_file.is_wanted())
      m_file.stream() << '{' << json_members("command", command) << ",\"curves\":[";
  }

  void write(std::size_t curve, const Curve_result& r)
  {
    if(!m_file.is_wanted())
      return;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const auto vertex = [](Vertex_index v) { return v.is_valid() ? static_cast<double>(v.idx()) : none; };
    m_file.stream() << (curve == 0 ? "\n{" : ",\n{")
                    << json_members("curve", curve, "name", r.name, "source", vertex(r.source), "target",
                                    vertex(r.target), "closed", r.is_closed, "initial_segments", r.initial_segments,
                                    "initial_length", r.initial_length, "length", r.length, "flips", r.flips,
                                    "flip_outs", r.flip_outs, "min_angle", r.smallest_angle, "status", r.status,
                                    "certificate", r.certificate, "search_s", r.search_s, "shorten_s", r.shorten_s,
                                    "extract_s", r.extract_s, "contracted", r.are_zero_edges_contracted)
                    << ",\"error\":" << (r.error.empty() ? "null" : json(r.error)) << ",\"points\":[";
    for(const Curve_point& p : r.points)
      m_file.stream() << (&p == &r.points.front() ? "" : ",")
                      << json(std::vector<double>{p.in_space.x(), p.in_space.y(), p.in_space.z()});
    m_file.stream() << "]}";
    m_file.check();
  }

  void write(const Mesh_info& info)
  {
    m_info = ",\"info\":{\"components\":[";
    for(const Component_info& c : info.components)
      m_info += (&c == &info.components.front() ? "{" : ",{") +
                json_members("vertices", c.vertices, "edges", c.edges, "faces", c.faces, "borders", c.borders, "genus",
                             c.genus()) +
                '}';
    m_info +=
        "]," +
        json_members("isolated_vertices", info.isolated_vertices, "degenerate_edges", info.degenerate_edges,
                     "degenerate_faces", info.degenerate_faces, "area", info.area, "shortest_edge", info.shortest_edge,
                     "longest_edge", info.longest_edge, "repaired", info.is_repaired, "defects", info.defects) +
        '}';
  }

  void write(const Field_curves& field)
  {
    if(field.map)
      m_info += ',' + json_members("distances", field.map->distances);
    if(!field.matrix.empty())
      m_info += ",\"matrix\":" + json(field.matrix, "\n");
  }

  /// \param remarks lines about the file and the results
  void close(const Mesh& mesh, const std::string& title, const std::vector<std::string>& remarks)
  {
    if(m_file.is_wanted())
      m_file.stream() << "\n]" << m_info << ",\"mesh\":{"
                      << json_members("name", title, "vertices", std::size_t(mesh.number_of_vertices()), "faces",
                                      std::size_t(mesh.number_of_faces()), "size", size_of(mesh))
                      << "}," << json_members("remarks", remarks) << "}\n";
    m_file.close();
  }

private:
  Output_file m_file;
  std::string m_info;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_JSON_FILE_H
