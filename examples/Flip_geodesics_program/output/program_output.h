// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OUTPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OUTPUT_H

#include "input/input_text.h"
#include "live_template.h"
#include "messages.h"
#include "output/json_file.h"
#include "output/mesh_file.h"
#include "output/page_file.h"
#include "output/result_formats.h"
#include "output/result_lines.h"
#include "output/scene_json.h"
#include "page_template.h"
#include "program_mesh.h"
#include "program_options.h"
#include "run/computations.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <list>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace program {

// What the interactive viewer opens: the bytes of a mesh file, with all bits of the points.
inline void write_mesh_object(std::ostream& out, const Mesh& mesh, const std::string& title)
{
  std::ostringstream bytes;
  CGAL::IO::set_binary_mode(bytes);
  CGAL::IO::write_PLY(bytes, mesh);
  out << "{\"name\":" << json_string(title) << ",\"format\":\"ply\",\"mesh\":" << json_base64(bytes.str()) << '}';
}

/// Writes the results to files.
class Outputs
{
public:
  /// Opens the files. \throws Bad_input
  explicit Outputs(const Options& options)
    : m_polylines(options.results.polylines)
    , m_stats(options.results.stats)
    , m_map(options.results.map)
    , m_matrix(options.results.matrix)
    , m_page(options.results.page)
    , m_live(options.results.live)
    , m_subdivision(options.meshes.subdivision, result_format(options, options.meshes.subdivision))
    , m_insertion(options.meshes.insertion, result_format(options, options.meshes.insertion))
    , m_cut(options.meshes.cut, result_format(options, options.meshes.cut))
    , m_json(options.results.json, options.command)
    , m_command(options.command)
    , m_tubes(options.results.tubes)
  {
    if(m_stats.is_wanted())
      m_stats.stream() << header_of_statistics;
    for(const std::string& name : options.results.outputs)
      m_outputs.emplace_back(name, result_format(options, name), has_curves());
    m_scene.title = name_of_input(options.mesh.substr(options.mesh.find_last_of("/\\") + 1));
  }

  /// The number of points of the next run that are recorded for the page.
  std::size_t most_recorded_points() const { return m_page.is_wanted() ? m_most_recorded_points : 0; }

  /// Writes the results of a run, and errors on standard error.
  void write(const std::vector<Curve_result>& run, const std::optional<Shortening_record>& record)
  {
    for(std::size_t i = 0; i < run.size(); ++i, ++m_curve) {
      if(m_polylines.is_wanted())
        write_polyline(m_polylines, m_curve, run[i]);
      if(m_stats.is_wanted())
        write_statistics(m_stats, m_curve, run[i]);
      m_json.write(m_curve, run[i]);
      m_summary.add(m_curve, run[i], i > 0);
      if(!m_outputs.empty() || m_page.is_wanted())
        m_scene.curves.push_back(scene_curve(run[i], m_curve, m_run));
      if(!run[i].error.empty())
        std::cerr << "flip_geodesics: curve " << m_curve << " (" << run[i].name << "): " << run[i].error << '\n';
      m_has_failed = m_has_failed || !run[i].error.empty();
      m_has_curve = m_has_curve || run[i].error.empty() || !run[i].points.empty();
    }
    ++m_run;
    if(!m_page.is_wanted())
      return;
    m_scene.records.push_back(record.value_or(Shortening_record()));
    m_most_recorded_points -= (std::min)(m_most_recorded_points, number_of_points(m_scene.records.back()));
  }

  void write(const CGAL::Flip_geodesics::Vertex_logarithmic_map& map) { write_and_close_map(map); }

  void write(const Result_meshes& meshes)
  {
    write(meshes.subdivision, m_subdivision);
    write(meshes.insertion, m_insertion);
    write(meshes.cut, m_cut);
    for(Mesh_file& file : m_outputs)
      if(meshes.flattened)
        file.write_textured(*meshes.flattened);
  }

  /// Returns lines about meshes whose format cannot store them as they are. \param mesh the one that `close()` writes
  std::vector<std::string> remarks(const Mesh& mesh) const
  {
    std::vector<std::string> lines = m_remarks;
    if(m_command == "repair")
      for(const Mesh_file& file : m_outputs)
        add_remark(mesh, file, lines);
    return lines;
  }

  void write(const Mesh_info& info) { m_json.write(info); }

  /// Writes the distances; the curves come as results.
  void write(const Field_curves& field)
  {
    m_json.write(field);
    write_matrix(m_matrix, field.matrix);
    if(field.map)
      write_and_close_map(*field.map);
    m_values = field.map;
  }

  /// Completes the files. \param remarks lines about the mesh and the results
  void close(const Mesh& mesh, const std::vector<std::string>& remarks)
  {
    m_matrix.close();
    m_stats.close(); // which has lines of curves that failed
    m_json.close(mesh, m_scene.title, remarks);
    if(m_command == "repair")
      for(Mesh_file& file : m_outputs)
        file.write(mesh);
    if(m_has_curve || !m_has_failed) {
      m_polylines.close();
      if(has_curves())
        for(Mesh_file& file : m_outputs)
          file.write(mesh, m_scene, m_tubes, m_values);
      write_page(m_page, page_template, [&](std::ostream& out) { Scene_json(mesh, json_packed).write(out, m_scene); });
    }
    write_page(m_live, live_template, [&](std::ostream& out) { write_mesh_object(out, mesh, m_scene.title); });
  }

  /// Prints the table of the curves.
  void print_summary(std::ostream& out) const { m_summary.print(out); }
  bool has_failed() const { return m_has_failed || Run_files::instance().has_failed(); }

private:
  bool has_curves() const { return m_command != "repair" && m_command != "flatten"; }

  // A file without a map stays as it was.
  template <class Map>
  void write_and_close_map(const Map& map)
  {
    if(m_map.is_wanted())
      write_map(m_map, map);
    m_map.close();
  }

  // What a run that failed does not have leaves the file of an earlier one.
  void write(const std::optional<Mesh>& mesh, Mesh_file& file)
  {
    if(!mesh)
      return;
    file.write(*mesh);
    add_remark(*mesh, file, m_remarks);
  }

  static void add_remark(const Mesh& mesh, const Mesh_file& file, std::vector<std::string>& lines)
  {
    if(const std::string line = file.remark(mesh); !line.empty())
      lines.push_back(line);
  }

  Output_file m_polylines, m_stats, m_map, m_matrix, m_page, m_live;
  std::optional<Distance_map> m_values;
  Mesh_file m_subdivision, m_insertion, m_cut;
  std::list<Mesh_file> m_outputs;
  Json_file m_json;
  std::vector<std::string> m_remarks;
  std::string m_command;
  std::optional<double> m_tubes;
  Scene m_scene;
  std::size_t m_run = 0, m_most_recorded_points = 1000000; // 16 megabytes on the page
  Run_summary m_summary;
  std::size_t m_curve = 0;
  bool m_has_failed = false, m_has_curve = false;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OUTPUT_H
