// SPDX-License-Identifier: LGPL-3.0-or-later

#include "output/program_output.h"

#include "input/input_text.h"
#include "live_template.h"
#include "output/json_file.h"
#include "output/mesh_file.h"
#include "output/packed_array.h"
#include "output/page_file.h"
#include "output/result_files.h"
#include "output/result_formats.h"
#include "output/run_summary.h"
#include "output/scene_json.h"
#include "output/viewer_files.h"
#include "page_template.h"
#include "printable.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <iostream>
#include <list>
#include <sstream>

namespace program {

namespace {

// What the interactive viewer opens: the bytes of a mesh file, with all bits of the points.
void write_mesh_object(std::ostream& out, const Mesh& mesh, const std::string& title)
{
  std::ostringstream bytes;
  CGAL::IO::set_binary_mode(bytes);
  CGAL::IO::write_PLY(bytes, mesh);
  out << "{\"name\":" << json_string(title) << ",\"format\":\"ply\",\"mesh\":" << json_base64(bytes.str()) << '}';
}

class Output_files : public Outputs
{
public:
  explicit Output_files(const Options& options)
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
    , m_is_repair(options.command == "repair")
  {
    if(m_stats.is_wanted())
      m_stats.stream() << header_of_statistics;
    const bool has_curves = !m_is_repair && options.command != "flatten";
    for(const std::string& name : options.results.outputs) {
      const std::string format = result_format(options, name);
      if(has_curves)
        m_viewers.emplace_back(name, format, options.results.tubes);
      else
        m_meshes.emplace_back(name, format);
    }
    m_scene.title = name_of_input(options.mesh.substr(options.mesh.find_last_of("/\\") + 1));
  }

  std::size_t most_recorded_points() const override { return m_page.is_wanted() ? m_most_recorded_points : 0; }

  void write(const std::vector<Curve_result>& run, const std::optional<Shortening_record>& record) override
  {
    for(std::size_t i = 0; i < run.size(); ++i, ++m_curve) {
      if(m_polylines.is_wanted())
        write_polyline(m_polylines, m_curve, run[i]);
      if(m_stats.is_wanted())
        write_statistics(m_stats, m_curve, run[i]);
      m_json.write(m_curve, run[i]);
      m_summary.add(m_curve, run[i], i > 0);
      if(!m_viewers.empty() || m_page.is_wanted())
        m_scene.curves.push_back(scene_curve(run[i]));
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

  void write(const CGAL::Flip_geodesics::Vertex_logarithmic_map& map) override { write_and_close_map(map); }

  void write(const Result_meshes& meshes) override
  {
    write(meshes.subdivision, m_subdivision);
    write(meshes.insertion, m_insertion);
    write(meshes.cut, m_cut);
    for(Mesh_file& file : m_meshes)
      if(meshes.flattened) {
        file.write_textured(*meshes.flattened);
        file.close();
      }
  }

  void write(const Mesh_info& info) override { m_json.write(info); }

  void write(const Field_curves& field) override
  {
    m_json.write(field);
    write_matrix(m_matrix, field.matrix);
    if(field.map)
      write_and_close_map(*field.map);
    m_values = field.map;
  }

  void close(const Mesh& mesh, const std::vector<std::string>& remarks) override
  {
    m_matrix.close();
    m_stats.close(); // which has lines of curves that failed
    m_json.close(mesh, m_scene.title, remarks);
    if(m_is_repair)
      for(Mesh_file& file : m_meshes)
        write(mesh, file);
    if(m_has_curve || !m_has_failed) {
      m_polylines.close();
      for(Viewer_file& file : m_viewers)
        file.write(mesh, m_scene, m_values);
      m_page.write(page_template, [&](std::ostream& out) { Scene_json(mesh, json_packed).write(out, m_scene); });
    }
    m_live.write(live_template, [&](std::ostream& out) { write_mesh_object(out, mesh, m_scene.title); });
  }

  void print_summary(std::ostream& out) const override { m_summary.print(out); }
  bool has_failed() const override { return m_has_failed || Run_files::instance().has_failed(); }

private:
  // A file without a map stays as it was.
  template <class Map>
  void write_and_close_map(const Map& map)
  {
    if(m_map.is_wanted())
      write_map(m_map, map);
    m_map.close();
  }

  // What a run that failed does not have leaves the file of an earlier one.
  static void write(const std::optional<Mesh>& mesh, Mesh_file& file)
  {
    if(!mesh)
      return;
    file.write(*mesh);
    file.close();
  }

  Scene_curve scene_curve(const Curve_result& r) const
  {
    Scene_curve curve = {m_curve,          r.name,   r.status, r.certificate,
                         r.initial_length, r.length, r.flips,  r.is_closed,
                         r.is_of_tree,     m_run,    {}};
    for(const Curve_point& p : r.points)
      curve.points.push_back(p.in_space);
    return curve;
  }

  Output_file m_polylines, m_stats, m_map, m_matrix;
  std::list<Viewer_file> m_viewers;
  Page_file m_page, m_live;
  std::optional<Distance_map> m_values;
  Mesh_file m_subdivision, m_insertion, m_cut;
  std::list<Mesh_file> m_meshes; // of repair and flatten
  Json_file m_json;
  bool m_is_repair;
  Scene m_scene;
  std::size_t m_run = 0, m_most_recorded_points = 1000000; // 16 megabytes on the page
  Run_summary m_summary;
  std::size_t m_curve = 0;
  bool m_has_failed = false, m_has_curve = false;
};

} // namespace

std::unique_ptr<Outputs> make_outputs(const Options& options) { return std::make_unique<Output_files>(options); }

} // namespace program
