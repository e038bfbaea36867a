// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the live page computes with, as WebAssembly: the parts of the program that read meshes and curves and compute,
// behind functions that take and give bytes. Curves are asked for by the lines that files of the program have, so that
// the program computes the same from them.

#include "bad_input.h"
#include "input/drawn_input.h"
#include "input/mesh_input.h"
#include "input/point_input.h"
#include "output/scene_json.h"
#include "output/viewer_curves.h"
#include "run/curve_engine.h"
#include "run/field_curves.h"
#include "run/progress.h"
#include "scene.h"

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/IO/PLY.h>

#include <CGAL/assertions_behaviour.h>

#include <cstddef>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace program;

/// A mesh that was opened, and the curves that were computed last.
class Session
{
public:
  Session(const std::string& file, std::string bytes)
    : m_mesh(open(Input_text(file, std::move(bytes))))
    , m_metric(program_metric(m_mesh, std::nullopt))
    , m_engine(make_certified_engine(m_mesh, m_metric, options(), m_progress))
  {
    m_scene.title = printable(file);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  std::string mesh_text() const
  {
    std::ostringstream out;
    out << "{\"title\":" << json_string(m_scene.title) << ",\"remarks\":[";
    const std::vector<std::string> remarks = m_mesh.remarks();
    for(std::size_t i = 0; i < remarks.size(); ++i)
      out << (i == 0 ? "" : ",") << json_string(remarks[i]);
    out << "],";
    Scene_json(m_mesh).write_mesh(out);
    out << '}';
    return out.str();
  }

  /// \param kind an option of the program that takes curves, without its dashes
  std::string compute(const std::string& kind, const std::string& line, std::size_t most_points)
  {
    Scene scene;
    scene.title = m_scene.title;
    if(kind == "distances")
      run_field(scene, line);
    else
      run(scene, request(kind, line), most_points);
    m_scene = std::move(scene);
    std::ostringstream out;
    out << '{';
    Scene_json(m_mesh).write_curves(out, m_scene);
    out << '}';
    return out.str();
  }

  /// The mesh and the curves that were computed last, as the program writes them: obj, ply, glb, or polylines.
  std::string save(const std::string& format) const
  {
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    if(format == "polylines")
      write_polylines(out, m_scene);
    else
      with_curves(m_mesh, m_scene, std::nullopt, CGAL::Flip_geodesics::IO::Colors(),
                  [&](const auto&... parts) { write(out, format, parts...); });
    return out.str();
  }

private:
  template <class... Parts>
  static void write(std::ostream& out, const std::string& format, const Parts&... parts)
  {
    namespace IO = CGAL::Flip_geodesics::IO;
    if(format == "obj")
      IO::write_OBJ(out, parts...);
    else if(format == "ply")
      IO::write_PLY(out, parts..., CGAL::parameters::use_binary_mode(false));
    else if(format == "glb")
      IO::write_GLB(out, parts...);
    else
      throw Bad_input(printable(format) + ": no format of curves");
  }

  static Run_options options()
  {
    Run_options result;
    result.search = CGAL::Flip_geodesics::Search_method::LOOK_BACK;
    return result;
  }

  // What is no oriented manifold of triangles is repaired.
  static Input_mesh open(const Input_text& input)
  {
    try {
      return read_mesh(input);
    } catch(const Bad_input&) {
      read_soup(input); // what cannot be read at all is no matter of a repair
      return repair_mesh(input);
    }
  }

  Network_request request(const std::string& kind, const std::string& line) const
  {
    const Input_text text("points", line + '\n');
    return {{(kind == "draw" ? read_drawn_curves(m_mesh, text) : read_point_curves(m_mesh, text, kind == "bezier"))
                 .front()},
            {},
            {}};
  }

  // Isolines, and the tree of geodesics: the line has the sources, the distance from one isoline to the next, and 1 if the
  // tree is wanted, with bars between.
  void run_field(Scene& scene, const std::string& line)
  {
    std::istringstream words(line);
    std::string sources, spacing, has_tree;
    std::getline(std::getline(std::getline(words, sources, '|'), spacing, '|'), has_tree);
    Field_request field;
    field.sources = read_named_points(m_mesh, {sources}, "sources");
    field.spacing = read_numbers(spacing, "spacing").front();
    add(scene, field_curves(m_mesh, field, m_progress).curves, std::nullopt);
    if(has_tree == "1")
      run(scene, {{}, {}, field.sources.front().at}, 0);
  }

  void run(Scene& scene, const Network_request& request, std::size_t most_points)
  {
    m_engine->set_most_recorded_points(most_points);
    const std::vector<Curve_result> results = m_engine->run(request);
    if(results.front().is_error())
      throw Bad_input(results.front().error);
    add(scene, results, m_engine->record());
  }

  static void add(Scene& scene, const std::vector<Curve_result>& results,
                  const std::optional<Shortening_record>& record)
  {
    for(const Curve_result& r : results) {
      scene.curves.push_back({scene.curves.size(),
                              r.name,
                              r.status,
                              r.certificate,
                              r.initial_length,
                              r.length,
                              r.flips,
                              r.is_closed,
                              r.is_of_tree,
                              scene.records.size(),
                              {}});
      for(const program::Curve_point& p : r.points)
        scene.curves.back().points.push_back(p.in_space);
    }
    scene.records.push_back(record.value_or(Shortening_record()));
  }

  Input_mesh m_mesh;
  Program_metric m_metric;
  Progress m_progress;
  std::unique_ptr<Curve_engine> m_engine;
  Scene m_scene;
};

std::string input, output;
std::unique_ptr<Session> session;

/// The words before a zero byte each, and the rest.
std::string next_word()
{
  const std::size_t end = input.find('\0');
  std::string word = input.substr(0, end);
  input.erase(0, end == std::string::npos ? end : end + 1);
  return word;
}

/// Sets the output, and says whether there is one or only a line for people that tells what went wrong.
template <class Compute>
bool set_output(const Compute& compute)
{
  try {
    output = compute();
    return true;
  } catch(const std::bad_alloc&) {
    output = "there is not enough memory";
  } catch(const std::exception& error) {
    output = without_controls(error.what());
  }
  return false;
}

} // namespace

#define FLIP_GEODESICS_EXPORT(name) extern "C" __attribute__((export_name(#name)))

/// A place for so many bytes of input.
FLIP_GEODESICS_EXPORT(take_input) char* take_input(std::size_t size)
{
  input.assign(size, '\0');
  return input.data();
}

FLIP_GEODESICS_EXPORT(output_bytes) const char* output_bytes() { return output.data(); }
FLIP_GEODESICS_EXPORT(output_size) std::size_t output_size() { return output.size(); }

/// The input is the name of a mesh's file and its bytes. The mesh before it stays if this one is of no use.
FLIP_GEODESICS_EXPORT(open_mesh) bool open_mesh()
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  return set_output([] {
    const std::string file = next_word();
    auto opened = std::make_unique<Session>(file, std::move(input));
    std::string text = opened->mesh_text();
    session = std::move(opened);
    return text;
  });
}

/// The input is what kind of curve, and a line for it. \param most_points of the edges whose flips are recorded
FLIP_GEODESICS_EXPORT(compute_curve) bool compute_curve(std::size_t most_points)
{
  return set_output([&] {
    const std::string kind = next_word();
    return session->compute(kind, input, most_points);
  });
}

/// The input is a format.
FLIP_GEODESICS_EXPORT(save_curves) bool save_curves()
{
  return set_output([] { return session->save(input); });
}
