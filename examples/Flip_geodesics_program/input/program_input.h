// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_INPUT_H

#include "file_name.h"
#include "input/data_input.h"
#include "input/mesh_input.h"
#include "input/obstacle_input.h"
#include "input/point_input.h"
#include "program_options.h"
#include "run/progress.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// What the files of the command line hold, for those who compute.
namespace program {

/// The mesh, which is an oriented manifold of triangles: as it is in the file, or repaired. \throws Bad_input
inline Input_mesh read_input_mesh(const Options& options, Progress& progress)
{
  if(!options.format.empty() && mesh_formats().count(options.format) == 0)
    throw Bad_input("--format " + printable(options.format) + ": not known as an input format; use one of " +
                    names_of_mesh_formats() + "; for a result, use --output-format");
  const Input_text input = read_text(options.mesh, options.format);
  const bool is_info = options.command == "info", is_repair = options.is_repaired || options.command == "repair";
  if(is_info)
    return inspect_mesh(input, options.weld, progress);
  Input_mesh mesh = is_repair ? repair_mesh(input, options.weld, progress) : read_mesh(input);
  if(options.has_seams)
    mesh.keep_text(input);
  return mesh;
}

inline std::vector<Curve_request> read_ends(const Input_mesh& mesh, const std::string& s, const std::string& t)
{
  Point_reader read_point(mesh);
  return {path_between(read_point, s, t, "--from, --to", "--from", "--to")};
}

/// The independent runs: one curve each, or all curves of a network. \throws Bad_input
inline std::vector<Network_request> read_requests(const Options& options, const Input_mesh& mesh)
{
  if(!options.network.empty())
    return {read_network(mesh, read_text(options.network))};
  if(!options.segmentation.empty())
    return {read_segmentation(mesh, read_text(options.segmentation), options.has_free_junctions)};
  if(options.has_seams)
    return {read_seams(mesh, mesh.text())};
  if(options.command == "log") {
    const std::string& word = options.sources.front();
    const CGAL::Flip_geodesics::Surface_location source = Point_reader(mesh)(word, "--source");
    if(options.is_shortest && kind(source) != CGAL::Flip_geodesics::Location_kind::VERTEX)
      throw Bad_input("--shortest requires a vertex as the source, and " + printable(word) +
                      " is not one; omit --shortest, or use `distance --map` for the shortest distances from any point "
                      "and `shortest --pairs` for the paths");
    return {{{}, {}, source}};
  }
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

/// The points of `--source`. \throws Bad_input
inline std::vector<Named_point> read_sources(const Options& options, const Input_mesh& mesh)
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
    throw Bad_input(name_of_input(options.sources_file) + ": the file contains no points; write one per line");
  return sources;
}

/// The straightest geodesics of `--trace`. \throws Bad_input
inline std::vector<Trace_request> read_traces(const Options& options, const Input_mesh& mesh)
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
    const bool is_vertex = kind(request.source.at) == CGAL::Flip_geodesics::Location_kind::VERTEX;
    request.is_reversed = read_point.is_reversed() && !is_vertex;
    requests.push_back(request);
  }
  return requests;
}

/// Obstacles and weights, as far as there are files of them. \throws Bad_input
inline Path_conditions read_conditions(const Options& options, const Input_mesh& mesh)
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

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_INPUT_H
