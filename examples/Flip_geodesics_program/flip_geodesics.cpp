// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes geodesic curves on a triangle mesh from the command line; see --help.
//
// Exit status: 0 on success, 1 if a curve could not be computed or a result not be written (the others are), 2 on bad
// input, 128 and the signal's number if it is interrupted.

#include "advice.h"
#include "bad_input.h"
#include "command_line.h"
#include "decimal_numbers.h"
#include "file_name.h"
#include "input/program_input.h"
#include "output/program_output.h"
#include "output/result_formats.h"
#include "output/run_files.h"
#include "printable.h"
#include "program_options.h"
#include "readable.h"
#include "run/curve_engine.h"
#include "run/field_curves.h"
#include "run/inserted_curves.h"
#include "run/landmarks.h"
#include "run/machine_memory.h"
#include "run/other_ways.h"
#include "run/parallel_runs.h" // uses threads under CGAL_LINKED_WITH_TBB
#include "run/progress.h"
#include "run/traced_curves.h"
#include "run/watcher.h"

#include <CGAL/assertions_behaviour.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace program;

constexpr int success = 0, incomplete = 1, bad_input = 2;

CGAL::Flip_geodesics::Search_method search_method(const std::string& name)
{
  using CGAL::Flip_geodesics::Search_method;
  return name == "lookback" ? Search_method::LOOK_BACK
         : name == "astar"  ? Search_method::A_STAR
                            : Search_method::DIJKSTRA;
}

std::vector<std::string> names_of_inputs(const Options& options)
{
  return {options.mesh,         options.pairs,  options.edges,  options.loop, options.network,
          options.segmentation, options.points, options.bezier, options.draw, options.obstacles};
}

std::vector<std::string> names_of_results(const Options& options)
{
  const Result_names& names = options.results;
  return {names.polylines,
          names.stats,
          names.viewer,
          names.page,
          names.live,
          names.map,
          names.repaired,
          options.meshes.subdivision,
          options.meshes.insertion,
          options.meshes.cut};
}

// Standard input is read once.
void check_names_of_inputs(const Options& options)
{
  std::size_t number = 0;
  for(const std::string& name : names_of_inputs(options))
    if(name == standard_stream && ++number > 1)
      throw Bad_input("standard input can be read once only; name files for all inputs but one");
}

// Each result in a file of its own, and none of them in one that is read.
void check_names_of_results(const Options& options)
{
  std::vector<std::string> results;
  for(const std::string& name : names_of_results(options)) {
    if(name.empty())
      continue;
    for(const std::string& other : results)
      if(is_same_file(name, other))
        throw Bad_input(name_of_result(name) + ": two results cannot go to one file; name another one");
    for(const std::string& input : names_of_inputs(options))
      if(!options.is_replacing_input && !input.empty() && is_same_file(name, input) && is_plain_file(input))
        throw Bad_input(printable(name) + ": a result would replace what is read; name another file, or add --force");
    results.push_back(name);
  }
  if(!options.output_format.empty() && std::none_of(results.begin(), results.end(), is_standard_output))
    throw Bad_input("--output-format is the format of a mesh on standard output; give - as the name of a result");
}

// The table goes where no result goes.
std::ostream& summary_stream(const Options& options)
{
  const std::vector<std::string> results = names_of_results(options);
  return std::any_of(results.begin(), results.end(), is_standard_output) ? std::cerr : std::cout;
}

// What the records of flips may take in each thread, in bytes.
std::size_t most_memory(const Options& options)
{
  constexpr double megabyte = 1e6;
  const double most = options.most_memory ? *options.most_memory * megabyte : 0.75 * memory_of_machine();
  return static_cast<std::size_t>(most / usable_threads(options.threads));
}

// What becomes of the curves, and a line for people above them.
int run(const Options& options, const Input_mesh& input, const Program_metric& metric, const std::string& title,
        Progress& progress)
{
  const Mesh& mesh = input;
  progress.enter("reading curves");
  const std::vector<Network_request> requests = read_requests(options, input);
  if(requests.size() != 1 && options.meshes.is_any_wanted())
    throw Bad_input("--insert, --cut and the command refine take one curve, or a network of several");
  std::size_t number_of_curves = 0;
  for(const Network_request& request : requests)
    number_of_curves += request.curves.size();
  std::optional<Landmarks> landmarks;
  if(options.landmarks)
    landmarks = make_landmarks(static_cast<std::size_t>(*options.landmarks), options.threads, mesh, metric, progress);
  progress.expect_curves(number_of_curves);
  const Run_options run_options = {search_method(options.search),
                                   options.stop_length,
                                   options.is_shortest || options.command == "shortest",
                                   landmarks ? &landmarks->bounds : nullptr,
                                   options.rounds,
                                   options.is_snapped,
                                   options.are_zero_edges_refused,
                                   options.meshes,
                                   most_memory(options),
                                   !options.results.map.empty()};
  const auto make_engine = [&] {
    return (options.kernel == "double" ? make_double_engine : make_certified_engine)(mesh, metric, run_options,
                                                                                     progress);
  };
  const std::unique_ptr<Curve_engine> engine = make_engine();
  for(const Network_request& request : requests)
    if(!request.tree_source && !request.curves.front().is_pair)
      engine->check(request);

  const std::unique_ptr<Outputs> outputs = make_outputs(options);
  if(!options.is_quiet)
    for(const std::string& remark : input.remarks())
      std::cerr << "flip_geodesics: " << remark << '\n';
  const auto write = [&](const Network_request&, const std::vector<Curve_result>& results) {
    progress.enter("writing");
    outputs->write(results, engine->record());
    if(engine->map())
      outputs->write(*engine->map());
    outputs->write(engine->meshes());
  };
  if(options.threads > 1 && requests.size() > 1) {
    run_in_parallel(requests, usable_threads(options.threads), make_engine, write);
  } else {
    for(const Network_request& request : requests) {
      engine->set_most_recorded_points(outputs->most_recorded_points());
      write(request, engine->run(request));
    }
  }
  progress.enter("writing");
  outputs->close(mesh);
  if(!options.is_quiet) {
    std::ostream& out = summary_stream(options);
    outputs->print_summary(out << title << (landmarks ? landmarks->remark : ""));
    out << engine->tree_results() << engine->mesh_results();
  }
  return outputs->has_failed() ? incomplete : success;
}

// Curves that `compute()` gives at once, of no triangulation.
template <class Compute>
int run_at_once(const Options& options, const Input_mesh& input, const std::string& title, Progress& progress,
                const Compute& compute)
{
  const std::unique_ptr<Outputs> outputs = make_outputs(options);
  if(!options.is_quiet)
    for(const std::string& remark : input.remarks())
      std::cerr << "flip_geodesics: " << remark << '\n';
  const std::vector<Curve_result> results = compute();
  progress.enter("writing");
  for(const Curve_result& result : results)
    outputs->write({result}, std::nullopt);
  outputs->write(meshes_along(input, results, options.meshes, progress));
  outputs->close(input);
  if(!options.is_quiet)
    outputs->print_summary(summary_stream(options) << title);
  return outputs->has_failed() ? incomplete : success;
}

int run_field(const Options& options, const Input_mesh& input, const std::string& title, Progress& progress)
{
  Field_request request = {{}, options.isolines, options.spacing, options.has_voronoi, options.tolerance};
  for(long long source : options.sources)
    request.sources.push_back(input.vertex(source, "--source"));
  std::string remarks;
  const int status = run_at_once(options, input, title, progress, [&] {
    Field_curves found = field_curves(input, request, progress);
    remarks = std::move(found.remarks);
    return std::move(found.curves);
  });
  if(!options.is_quiet)
    summary_stream(options) << remarks;
  return status;
}

Trace_request trace_request(const std::string& text, const Input_mesh& input)
{
  const std::size_t first = text.find(','), second = first == std::string::npos ? first : text.find(',', first + 1);
  long long source = 0;
  Trace_request result = {Vertex_index(), 0, 0};
  if(second == std::string::npos || parse_number(text.substr(0, first), source) != nullptr ||
     parse_number(text.substr(first + 1, second - first - 1), result.angle) != nullptr ||
     parse_number(text.substr(second + 1), result.length) != nullptr)
    throw Bad_input("--trace " + printable(text) + ": give a vertex, an angle and a length as VERTEX,ANGLE,LENGTH");
  if(!(result.length >= 0))
    throw Bad_input("--trace " + printable(text) + ": the length must not be negative");
  result.source = input.vertex(source, "--trace");
  return result;
}

int run_other_ways(const Options& options, const Input_mesh& input, const std::string& title, Progress& progress)
{
  constexpr double megabyte = 1e6;
  Ways_request request = {
      {}, static_cast<std::size_t>(options.ways.value_or(1)), read_obstacles(options, input), std::nullopt};
  for(const Network_request& network : read_requests(options, input))
    request.pairs.push_back(network.curves.front());
  if(options.most_memory)
    request.most_memory = *options.most_memory * megabyte;
  std::string others;
  const int status = run_at_once(options, input, title, progress, [&] {
    Ways ways = other_ways(input, request, progress);
    others = ways.others;
    return ways.curves;
  });
  if(!options.is_quiet)
    summary_stream(options) << others;
  return status;
}

int run_traces(const Options& options, const Input_mesh& input, const std::string& title, Progress& progress)
{
  std::vector<Trace_request> requests;
  for(const std::string& text : options.traces)
    requests.push_back(trace_request(text, input));
  return run_at_once(options, input, title, progress, [&] { return traced_curves(input, requests, progress); });
}

int run_drawn(const Options& options, const Input_mesh& input, const std::string& title, Progress& progress)
{
  const std::vector<Network_request> requests = read_requests(options, input);
  return run_at_once(options, input, title, progress, [&] { return drawn_curves(input, requests, progress); });
}

// The live page or the repaired mesh alone, for which no curves are given.
int run_without_curves(const Options& options, const Input_mesh& input, const std::string& title)
{
  const std::unique_ptr<Outputs> outputs = make_outputs(options);
  outputs->close(input);
  if(!options.is_quiet) {
    for(const std::string& remark : input.remarks())
      std::cerr << "flip_geodesics: " << remark << '\n';
    summary_stream(options) << title;
  }
  return outputs->has_failed() ? incomplete : success;
}

// Runs the command.
int run(const Options& options)
{
  check_names_of_inputs(options);
  check_names_of_results(options);
  check_formats_of_results(options);
  Progress progress;
  const Watcher watcher(progress, options.is_quiet);
  progress.enter("reading the mesh");
  const Stopwatch stopwatch;
  const Input_mesh input = read_input_mesh(options);
  const Mesh& mesh = input;
  std::ostringstream title;
  title << name_of_input(options.mesh) << ": " << counted(mesh.number_of_vertices(), "vertex", "vertices") << ", "
        << counted(mesh.number_of_faces(), "triangle", "triangles") << ", read in "
        << readable_time(stopwatch.seconds()) << '\n';
  if(options.command == "trace")
    return run_traces(options, input, title.str(), progress);
  if(options.command == "cut")
    return run_drawn(options, input, title.str(), progress);
  if(options.command == "distance")
    return run_field(options, input, title.str(), progress);
  if(options.command == "repair" || options.command == "view")
    return run_without_curves(options, input, title.str());
  if(options.ways || !options.obstacles.empty())
    return run_other_ways(options, input, title.str(), progress);
  const Program_metric metric = program_metric(mesh, options.mollify);
  if(options.mollify)
    title << metric.added_length() << " added to the length of every edge\n";
  return run(options, input, metric, title.str(), progress);
}

// What is left of standard output goes out.
int flushed(int status)
{
  if(std::cout.flush())
    return status;
  std::cerr << "flip_geodesics: standard output: could not be written to its end; look for space on the disk\n";
  return status == success ? incomplete : status;
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  Command_line command_line(options);
  try {
    if(std::find(argv + 1, argv + argc, std::string()) != argv + argc)
      throw Bad_input("an argument is empty; leave its option out or give it a value");
    command_line.parse(argc, argv);
    CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
    return flushed(run(options));
  } catch(const CLI::CallForHelp&) {
    std::cout << command_line.help();
    return flushed(success);
  } catch(const CLI::CallForVersion& version) {
    std::cout << version.what() << '\n';
    return flushed(success);
  } catch(const CLI::ParseError& error) {
    std::cerr << "flip_geodesics: " << printable(command_line.describe(error), 300) << '\n';
  } catch(const std::exception& error) {
    std::cerr << "flip_geodesics: " << without_controls(with_advice_to_repair(error)) << '\n';
  }
  return bad_input;
}
