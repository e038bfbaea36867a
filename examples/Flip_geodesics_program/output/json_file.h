// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_JSON_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_JSON_FILE_H

#include "output/json_text.h"
#include "output/output_file.h"
#include "program_mesh.h"
#include "run/computations.h"
#include "run/curve_engine.h"

#include <cstddef>
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
      m_file.stream() << "{\"command\":" << json_string(command) << ",\"curves\":[";
  }

  void write(std::size_t curve, const Curve_result& r)
  {
    if(!m_file.is_wanted())
      return;
    const auto vertex = [](Vertex_index v) { return v.is_valid() ? std::to_string(v.idx()) : "null"; };
    m_file.stream() << (curve == 0 ? "\n" : ",\n") << "{\"curve\":" << curve << ",\"name\":" << json_string(r.name)
                    << ",\"source\":" << vertex(r.source) << ",\"target\":" << vertex(r.target)
                    << ",\"closed\":" << truth(r.is_closed) << ",\"initial_segments\":" << r.initial_segments
                    << ",\"initial_length\":" << json_number(r.initial_length)
                    << ",\"length\":" << json_number(r.length) << ",\"flips\":" << r.flips
                    << ",\"flip_outs\":" << r.flip_outs << ",\"min_angle\":" << json_number(r.smallest_angle)
                    << ",\"status\":" << json_string(r.status) << ",\"certificate\":" << json_string(r.certificate)
                    << ",\"search_s\":" << json_number(r.search_s) << ",\"shorten_s\":" << json_number(r.shorten_s)
                    << ",\"extract_s\":" << json_number(r.extract_s)
                    << ",\"contracted\":" << truth(r.are_zero_edges_contracted)
                    << ",\"error\":" << (r.error.empty() ? "null" : json_string(r.error)) << ",\"points\":[";
    for(const Curve_point& p : r.points)
      m_file.stream() << (&p == &r.points.front() ? "[" : ",[") << json_number(p.in_space.x()) << ','
                      << json_number(p.in_space.y()) << ',' << json_number(p.in_space.z()) << ']';
    m_file.stream() << "]}";
    m_file.check();
  }

  void write(const Mesh_info& info)
  {
    m_info = ",\"info\":{\"components\":[";
    for(const Component_info& c : info.components)
      m_info += (&c == &info.components.front() ? "{\"vertices\":" : ",{\"vertices\":") + std::to_string(c.vertices) +
                ",\"edges\":" + std::to_string(c.edges) + ",\"faces\":" + std::to_string(c.faces) +
                ",\"borders\":" + std::to_string(c.borders) + ",\"genus\":" + std::to_string(c.genus()) + '}';
    m_info += "],\"isolated_vertices\":" + std::to_string(info.isolated_vertices) +
              ",\"degenerate_edges\":" + std::to_string(info.degenerate_edges) +
              ",\"degenerate_faces\":" + std::to_string(info.degenerate_faces) + ",\"area\":" + json_number(info.area) +
              ",\"shortest_edge\":" + json_number(info.shortest_edge) +
              ",\"longest_edge\":" + json_number(info.longest_edge) + ",\"defects\":" + list(info.defects) + '}';
  }

  void write(const Field_curves& field)
  {
    if(field.map)
      m_info += ",\"distances\":" + list(field.map->distances);
    if(field.matrix.empty())
      return;
    m_info += ",\"matrix\":[";
    for(const std::vector<double>& row : field.matrix)
      m_info += (&row == &field.matrix.front() ? "\n" : ",\n") + list(row);
    m_info += ']';
  }

  /// \param remarks lines about the file and the results
  void close(const Mesh& mesh, const std::string& title, const std::vector<std::string>& remarks)
  {
    if(m_file.is_wanted())
      m_file.stream() << "\n]" << m_info << ",\"mesh\":{\"name\":" << json_string(title)
                      << ",\"vertices\":" << mesh.number_of_vertices() << ",\"faces\":" << mesh.number_of_faces()
                      << ",\"size\":" << json_number(size_of(mesh)) << "},\"remarks\":" << list(remarks) << "}\n";
    m_file.close();
  }

private:
  static const char* truth(bool value) { return value ? "true" : "false"; }

  static std::string json(const std::string& text) { return json_string(text); }
  static std::string json(double x) { return json_number(x); }

  template <class Item>
  static std::string list(const std::vector<Item>& items)
  {
    std::string text;
    for(const Item& item : items)
      text += (text.empty() ? "" : ",") + json(item);
    return '[' + text + ']';
  }

  Output_file m_file;
  std::string m_info;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_JSON_FILE_H
