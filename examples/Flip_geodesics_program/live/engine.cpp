// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The engine of the interactive viewer, compiled to WebAssembly: the parts of the program that read meshes and curves
// and compute, behind functions that take and return bytes. A curve is requested by its kind and a line of the
// program's files, so that the program computes the same curve from the same line. The engine keeps the mesh and
// nothing else: a page that has interrupted it opens the mesh again and continues.

#include "input/mesh_input.h"
#include "input/point_input.h"
#include "messages.h"
#include "output/scene_json.h"
#include "output/viewer_curves.h"
#include "run/computations.h"
#include "run/curve_engine.h"
#include "run/progress.h"
#include "scene.h"

#include <CGAL/Flip_geodesics/curve_samples.h>

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

/// A mesh, and the computations on it.
class Session
{
public:
  Session(const std::string& file, std::string bytes)
    : m_title(printable(file))
    , m_mesh(open(Input_text(file, std::move(bytes)), m_progress))
    , m_metric(mollified_metric(m_mesh, Mesh_metric(m_mesh.mesh().points()), std::nullopt))
    , m_geodesics(make_certified_engine(m_mesh, m_metric, options(false), m_progress))
  {
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  std::string mesh_text() const
  {
    std::ostringstream out;
    out << '{' << json_members("title", m_title, "remarks", m_mesh.remarks()) << ',';
    Scene_json(m_mesh).write_mesh(out);
    out << '}';
    return out.str();
  }

  /// The curves of a request as JSON. \param most_points of the edges whose flips are recorded
  std::string compute(const std::string& kind, const std::string& line, std::size_t most_points)
  {
    Scene scene;
    add_curves(scene, kind, line, most_points);
    std::ostringstream out;
    out << '{' << json_members("remarks", m_remarks) << ',' << m_members;
    Scene_json(m_mesh).write_curves(out, scene);
    out << '}';
    return out.str();
  }

  /// The mesh with the curves of some requests, pairs of a kind and a line, as the program writes them: obj, ply, glb,
  /// or polylines.
  std::string save(const std::string& format, const std::vector<std::pair<std::string, std::string>>& requests)
  {
    Scene scene;
    scene.title = m_title;
    for(const auto& [kind, line] : requests)
      add_curves(scene, kind, line, 0);
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    if(format != "obj" && format != "ply" && format != "glb" && format != "polylines")
      throw Bad_input(printable(format) + ": the format is not known; use obj, ply, glb or polylines");
    if(format == "polylines")
      write_polylines(out, scene);
    else
      with_curves(m_mesh, scene, std::nullopt, CGAL::Flip_geodesics::IO::Colors(),
                  [&](const auto&... parts) { write_view(out, format, parts...); });
    return out.str();
  }

private:
  static Run_options options(bool is_shortest)
  {
    Run_options result;
    result.search = CGAL::Flip_geodesics::Search_method::LOOK_BACK;
    result.is_shortest = is_shortest;
    return result;
  }

  // A mesh that is not an oriented manifold of triangles is repaired.
  static Input_mesh open(const Input_text& input, Progress& progress)
  {
    try {
      return read_mesh(input);
    } catch(const Bad_input&) {
      read_soup(input); // throws if the file cannot be read at all, which a repair does not change
      return repair_mesh(input, 0, progress);
    }
  }

  // Adds what the option `kind` of the program computes from a line, or from fields with bars between.
  void add_curves(Scene& scene, const std::string& kind, const std::string& line, std::size_t most_points)
  {
    m_remarks.clear();
    m_members.clear();
    const std::vector<std::string> fields = fields_of(line);
    const Input_text text("points", fields.front() + '\n');
    if(kind == "distances")
      add_isolines(scene, fields);
    else if(kind == "trace")
      add(scene, {traced(trace(line))}, std::nullopt);
    else if(kind == "direction")
      set_direction(read_point_curves(m_mesh, text, false));
    else if(kind == "ways")
      add_ways(scene, read_pairs(m_mesh, text), static_cast<std::size_t>(number(fields.at(1))));
    else if(kind == "shortest")
      run(scene, {read_pairs(m_mesh, text), {}, {}}, most_points, shortest_paths());
    else if(kind == "draw")
      run(scene, {read_drawn_curves(m_mesh, text), {}, {}}, most_points, *m_geodesics);
    else
      run(scene, {read_point_curves(m_mesh, text, kind == "bezier"), {}, {}}, most_points, *m_geodesics);
  }

  static std::vector<std::string> fields_of(const std::string& line)
  {
    std::vector<std::string> fields(1);
    for(const char c : line)
      if(c == '|')
        fields.emplace_back();
      else
        fields.back() += c;
    return fields;
  }

  static double number(const std::string& text) { return read_numbers(text, "curve").front(); }

  // Fields: the sources, the distance between isolines, and 1 if the tree of geodesics is wanted.
  void add_isolines(Scene& scene, const std::vector<std::string>& fields)
  {
    Field_request field;
    field.sources = read_named_points(m_mesh, {fields.front()}, "sources");
    field.spacing = number(fields.at(1));
    field.is_map = true;
    const Field_curves found = field_curves(m_mesh, field, m_progress);
    m_remarks = {found.remarks};
    const std::vector<double>& distances = found.map->distances;
    m_members = "\"distances\":" + json_base64(std::vector<float>(distances.begin(), distances.end())) + ',';
    add(scene, found.curves, std::nullopt);
    if(fields.at(2) == "1")
      run(scene, {{}, {}, field.sources.front().at}, 0, *m_geodesics);
  }

  // A vertex, an angle and a length.
  Trace_request trace(const std::string& line) const
  {
    const std::size_t comma = line.find(',');
    const std::vector<double> numbers = read_numbers(line.substr(comma + 1), "trace");
    return {read_named_points(m_mesh, {line.substr(0, comma)}, "trace").front(), numbers.at(0), numbers.at(1)};
  }

  Curve_result traced(const Trace_request& request) { return traced_curves(m_mesh, {request}, {}, m_progress).front(); }

  // Sets the result to the angle at which the geodesic from a vertex to a point starts, as a trace takes it.
  void set_direction(const std::vector<Curve_request>& pair)
  {
    const Trace_request zero = {{pair.front().points.front(), "the start"}, 0, size_of(m_mesh) / 1000};
    const double angle = CGAL::Flip_geodesics::angle_between_curves(
        m_mesh.mesh(), locations(traced(zero)), locations(m_geodesics->run({pair, {}, {}}).front()));
    m_members = "\"angle\":" + json_number(angle) + ',';
  }

  std::vector<CGAL::Flip_geodesics::Surface_location> locations(const Curve_result& curve) const
  {
    if(curve.is_error())
      throw Bad_input(curve.error);
    std::vector<CGAL::Flip_geodesics::Surface_location> result;
    for(const program::Curve_point& p : curve.points)
      result.push_back(location_of(m_mesh, p.on_surface));
    return result;
  }

  void add_ways(Scene& scene, const std::vector<Curve_request>& pairs, std::size_t count)
  {
    constexpr double memory_limit = 1e9; // half of the memory that the engine may have
    const Ways ways = other_ways(m_mesh, {pairs, count, {}, memory_limit}, m_progress);
    m_remarks = {ways.others};
    add(scene, ways.curves, std::nullopt);
  }

  // An engine of its own, which is made when the first path is requested.
  Curve_engine& shortest_paths()
  {
    if(!m_shortest_paths)
      m_shortest_paths = make_certified_engine(m_mesh, m_metric, options(true), m_progress);
    return *m_shortest_paths;
  }

  void run(Scene& scene, const Network_request& request, std::size_t most_points, Curve_engine& engine)
  {
    engine.set_most_recorded_points(most_points);
    const std::vector<Curve_result> results = engine.run(request);
    add(scene, results, engine.record());
  }

  // A failure among several results is a remark; if nothing else was found, it is an error.
  void add(Scene& scene, const std::vector<Curve_result>& results, const std::optional<Shortening_record>& record)
  {
    if(!results.empty() && results.front().is_error())
      throw Bad_input(results.front().error);
    for(const Curve_result& r : results) {
      if(r.is_error()) {
        m_remarks.push_back(r.error);
        continue;
      }
      scene.curves.push_back(scene_curve(r, scene.curves.size(), scene.records.size()));
    }
    scene.records.push_back(record.value_or(Shortening_record()));
  }

  std::string m_title;
  Progress m_progress;
  Input_mesh m_mesh;
  Program_metric m_metric;
  std::unique_ptr<Curve_engine> m_geodesics, m_shortest_paths;
  std::string m_members;              // of the result computed last, beside its curves, each with a comma
  std::vector<std::string> m_remarks; // about the curves that were computed last, for the user
};

std::string input, output;
std::unique_ptr<Session> session;

/// Removes the next word from the input, up to a zero byte or the end, and returns it.
std::string next_word()
{
  const std::size_t end = input.find('\0');
  std::string word = input.substr(0, end);
  input.erase(0, end == std::string::npos ? end : end + 1);
  return word;
}

/// Sets the output, and returns whether it is a result and not an error message.
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

/// Returns where to put so many bytes of input.
FLIP_GEODESICS_EXPORT(take_input) char* take_input(std::size_t size)
{
  input.assign(size, '\0');
  return input.data();
}

FLIP_GEODESICS_EXPORT(output_bytes) const char* output_bytes() { return output.data(); }
FLIP_GEODESICS_EXPORT(output_size) std::size_t output_size() { return output.size(); }

/// Opens a mesh. The input is the name of its file and its bytes. If it fails, the previous mesh stays open.
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

/// Computes curves. The input is a kind and a line.
FLIP_GEODESICS_EXPORT(compute_curve) bool compute_curve(std::size_t most_points)
{
  return set_output([&] {
    const std::string kind = next_word();
    return session->compute(kind, next_word(), most_points);
  });
}

/// Saves curves. The input is a format, and a kind and a line for each request.
FLIP_GEODESICS_EXPORT(save_curves) bool save_curves()
{
  return set_output([] {
    const std::string format = next_word();
    std::vector<std::pair<std::string, std::string>> requests;
    while(!input.empty()) {
      std::string kind = next_word();
      requests.emplace_back(std::move(kind), next_word());
    }
    return session->save(format, requests);
  });
}
