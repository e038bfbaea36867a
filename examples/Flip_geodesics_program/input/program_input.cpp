// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/program_input.h"

#include "file_name.h"
#include "input/curve_input.h"
#include "input/data_input.h"
#include "input/drawn_input.h"
#include "input/input_text.h"
#include "input/mesh_input.h"
#include "input/obstacle_input.h"
#include "input/point_input.h"

#include <cstddef>
#include <cstdint>

program::Input_mesh program::read_input_mesh(const Options& options, Progress& progress)
{
  if(!options.format.empty() && mesh_formats().count(options.format) == 0)
    throw Bad_input("--format " + printable(options.format) + ": not known as an input format; use one of" +
                    names_of_mesh_formats() + ", or --output-format for a result");
  const Input_text input = read_text(options.mesh, options.format);
  const bool is_info = options.command == "info", is_repair = options.is_repaired || options.command == "repair";
  if(is_info || is_repair)
    progress.enter("repairing the mesh");
  if(is_info)
    return inspect_mesh(input, options.weld);
  Input_mesh mesh = is_repair ? repair_mesh(input, options.weld) : read_mesh(input);
  if(options.has_seams)
    mesh.keep_text(input);
  return mesh;
}

namespace {

std::vector<program::Curve_request> read_ends(const program::Input_mesh& mesh, const std::string& s,
                                              const std::string& t)
{
  program::Point_reader read_point(mesh);
  return {program::path_between(read_point, s, t, "--from, --to", "--from", "--to")};
}

} // namespace

std::vector<program::Network_request> program::read_requests(const Options& options, const Input_mesh& mesh)
{
  if(!options.network.empty())
    return {read_network(mesh, read_text(options.network))};
  if(!options.segmentation.empty())
    return {read_segmentation(mesh, read_text(options.segmentation), options.has_free_junctions)};
  if(options.has_seams)
    return {read_seams(mesh, mesh.text())};
  if(options.command == "log")
    return {{{}, {}, Point_reader(mesh)(options.sources.front(), "--source")}};
  const std::vector<Curve_request> curves =
      options.random
          ? random_pairs(mesh, static_cast<std::size_t>(*options.random), static_cast<std::uint64_t>(options.seed))
      : !options.pairs.empty()  ? read_pairs(mesh, read_text(options.pairs))
      : !options.points.empty() ? read_point_curves(mesh, read_text(options.points), false)
      : !options.bezier.empty() ? read_point_curves(mesh, read_text(options.bezier), true)
      : !options.draw.empty()   ? read_drawn_curves(mesh, read_text(options.draw))
      : !options.edges.empty()  ? read_curves(mesh, read_text(options.edges), false)
      : !options.loop.empty()   ? read_curves(mesh, read_text(options.loop), true)
                                : read_ends(mesh, options.from, options.to);
  std::vector<Network_request> requests;
  for(const Curve_request& curve : curves)
    requests.push_back({{curve}, {}, {}});
  return requests;
}

std::vector<program::Named_point> program::read_sources(const Options& options, const Input_mesh& mesh)
{
  std::vector<Named_point> sources = read_named_points(mesh, options.sources, "--source");
  if(options.sources_file.empty())
    return sources;
  Point_reader read_point(mesh);
  for_each_line(read_text(options.sources_file), [&](Text_scanner& words) {
    for(std::string_view word; !(word = next_point(words)).empty();)
      sources.push_back(read_named_point(read_point, std::string(word), words.place()));
  });
  if(sources.empty())
    throw Bad_input("--sources: the file contains no points; write one per line");
  return sources;
}

std::vector<program::Trace_request> program::read_traces(const Options& options, const Input_mesh& mesh)
{
  Point_reader read_point(mesh);
  std::vector<Trace_request> requests;
  for(const std::string& text : options.traces) {
    const std::string name = "--trace " + printable(text);
    const std::size_t last = text.rfind(','), middle = last == std::string::npos ? 0 : text.rfind(',', last - 1);
    Trace_request request = {};
    if(last == std::string::npos || middle == std::string::npos || middle == 0 ||
       parse_number(text.substr(middle + 1, last - middle - 1), request.angle) != nullptr ||
       parse_number(text.substr(last + 1), request.length) != nullptr)
      throw Bad_input(name + ": specify a point, an angle and a length as POINT,ANGLE,LENGTH");
    if(!(request.length >= 0))
      throw Bad_input(name + ": the length must not be negative");
    request.source = read_named_point(read_point, text.substr(0, middle), "--trace");
    requests.push_back(request);
  }
  return requests;
}

program::Path_conditions program::read_conditions(const Options& options, const Input_mesh& mesh)
{
  Path_conditions conditions = {{}, std::nullopt, options.mollify};
  if(!options.obstacles.empty())
    conditions.obstacles = read_obstacles(mesh, read_text(options.obstacles));
  if(!options.face_weights.empty())
    conditions.weights = read_face_weights(mesh, read_text(options.face_weights));
  if(!options.edge_weights.empty())
    conditions.weights = read_edge_weights(mesh, read_text(options.edge_weights));
  return conditions;
}
