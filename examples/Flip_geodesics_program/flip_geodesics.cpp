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
  if(name == "lookback")
    return Search_method::LOOK_BACK;
  if(name == "astar")
    return Search_method::A_STAR;
  if(name == "dijkstra")
    return Search_method::DIJKSTRA;
  throw Bad_input("--search " + printable(name) + ": not known; use lookback, astar or dijkstra");
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

void check_mesh_results(const Mesh_result_options& options)
{
  if(options.refine && !(*options.refine >= 0 && *options.refine <= 30))
    throw Bad_input("--refine takes the smallest angle, in degrees, between 0 and 30");
  if((options.longest_edge || options.most_vertices) && !options.refine)
    throw Bad_input("--longest-edge and --most-vertices belong to --refine; give an angle, 0 for any");
  if(options.longest_edge && !(*options.longest_edge >= 1e-70))
    throw Bad_input("--longest-edge must be at least 1e-70: no edge is shorter");
  if(options.most_vertices && *options.most_vertices < 0)
    throw Bad_input("--most-vertices must not be negative");
}

void check_other_ways(const Options& options)
{
  constexpr long long most_ways = 1000;
  if(!options.obstacles.empty() && !options.ways)
    throw Bad_input("--avoid belongs to --ways; give how many ways, 1 for the shortest");
  if(!options.ways)
    return;
  if(*options.ways < 1 || *options.ways > most_ways)
    throw Bad_input("--ways " + std::to_string(*options.ways) + ": give 1 to " + std::to_string(most_ways));
  if(!options.has_pairs())
    throw Bad_input("--ways belongs to --from with --to, --pairs and --random; give one of them");
  if(options.mollify || options.kernel || options.stop_length || options.are_zero_edges_refused ||
     options.meshes.is_triangulation_wanted())
    throw Bad_input("--ways gives no curves of one triangulation: --mollify, --refuse-zero-edges, --kernel, "
                    "--stop-length, --delaunay, --refine and --subdivision do not go with it");
}

void check_shortest_paths(const Options& options)
{
  constexpr long long most_landmarks = 1000;
  if(options.is_shortest && options.sources.empty() && !options.has_pairs())
    throw Bad_input("--shortest belongs to --from with --to, --pairs, --random and --source; give one of them");
  if(options.is_shortest && options.ways)
    throw Bad_input("--ways gives shortest paths; leave --shortest out");
  if(options.is_shortest && options.stop_length)
    throw Bad_input("--stop-length does not go with --shortest; leave one of them out");
  if(options.landmarks && (!options.is_shortest || !options.has_pairs()))
    throw Bad_input("--landmarks belongs to --shortest with --from and --to, --pairs or --random; give both");
  if(options.landmarks && (*options.landmarks < 1 || *options.landmarks > most_landmarks))
    throw Bad_input("--landmarks " + std::to_string(*options.landmarks) + ": give 1 to " +
                    std::to_string(most_landmarks));
}

void check_field_options(const Options& options)
{
  if(options.tolerance && !options.is_field_wanted())
    throw Bad_input("--tolerance belongs to --isolines, --spacing and --voronoi; give one of them");
  if(options.tolerance && !(*options.tolerance > 0))
    throw Bad_input("--tolerance must be greater than 0");
  for(const double level : options.isolines)
    if(!(level > 0))
      throw Bad_input("--isolines takes distances greater than 0; " + decimal_text(level) + " is none");
  if(options.spacing && !(*options.spacing > 0))
    throw Bad_input("--spacing must be greater than 0");
  if(options.spacing && !options.isolines.empty())
    throw Bad_input("--spacing and --isolines do not go together; give one of them");
  if(!options.is_field_wanted() && options.sources.size() > 1)
    throw Bad_input("--source takes one vertex for a tree; several go with --isolines, --spacing and --voronoi");
  if(options.is_field_wanted() && (options.is_shortest || !options.results.map.empty() || options.mollify ||
                                   options.kernel || options.meshes.is_triangulation_wanted()))
    throw Bad_input(
        "--isolines, --spacing and --voronoi give no curves of a triangulation: --shortest, --map, --mollify, "
        "--kernel, --delaunay, --refine and --subdivision do not go with them");
}

// The live page and the repaired mesh need no curves; what else is written does.
bool are_no_curves_wanted(const Options& options)
{
  const Result_names& names = options.results;
  return (!names.live.empty() || !names.repaired.empty()) && names.polylines.empty() && names.stats.empty() &&
         names.viewer.empty() && names.page.empty() && names.map.empty() && !options.meshes.is_any_wanted();
}

// The options that are given of those that give curves.
std::vector<std::string> options_of_curves(const Options& options)
{
  const std::pair<const char*, bool> all[] = {{options.from ? "--from" : "--to", options.from || options.to},
                                              {"--random", options.random.has_value()},
                                              {"--pairs", !options.pairs.empty()},
                                              {"--edges", !options.edges.empty()},
                                              {"--loop", !options.loop.empty()},
                                              {"--network", !options.network.empty()},
                                              {"--segmentation", !options.segmentation.empty()},
                                              {"--seams", options.has_seams},
                                              {"--source", !options.sources.empty()},
                                              {"--points", !options.points.empty()},
                                              {"--bezier", !options.bezier.empty()},
                                              {"--draw", !options.draw.empty()},
                                              {"--trace", !options.traces.empty()}};
  std::vector<std::string> given;
  for(const auto& [name, is_given] : all)
    if(is_given)
      given.push_back(name);
  return given;
}

void check_options(const Options& options)
{
  const std::vector<std::string> jobs = options_of_curves(options);
  if(options.sources.empty() && (!options.results.map.empty() || options.is_field_wanted()))
    throw Bad_input("--map, --isolines, --spacing and --voronoi belong to --source; give a source");
  if(jobs.size() > 1)
    throw Bad_input(jobs[0] + " and " + jobs[1] + " do not go together; give the curves by one of them");
  if(jobs.empty() && !are_no_curves_wanted(options))
    throw Bad_input("give the curves by one of --from with --to, --pairs, --random, --edges, --loop, --network, "
                    "--points, --bezier, --draw, --segmentation, --seams, --source, --trace; or give --live or "
                    "--repaired alone");
  if(!options.is_repaired && !options.results.repaired.empty())
    throw Bad_input("--repaired belongs to --repair; give both");
  if(!options.is_repaired && options.weld)
    throw Bad_input("--weld belongs to --repair; give both");
  if(options.weld && !(*options.weld >= 0 && *options.weld < 1))
    throw Bad_input(
        "--weld: the tolerance is not at least 0 and below 1; give a part of the bounding box, such as 1e-9");
  check_field_options(options);
  check_other_ways(options);
  check_shortest_paths(options);
  if(!options.traces.empty() &&
     (options.mollify || options.kernel || options.stop_length || options.meshes.is_triangulation_wanted()))
    throw Bad_input("--trace gives no curves of a triangulation: --mollify, --kernel, --stop-length, "
                    "--delaunay, --refine and --subdivision do not go with it");
  if(!options.sources.empty() && options.stop_length)
    throw Bad_input("--stop-length is of no use with --source; leave one of them out");
  if(options.is_snapped && options.draw.empty())
    throw Bad_input("--snap belongs to --draw; give polylines");
  if(options.is_as_drawn && options.draw.empty())
    throw Bad_input("--as-drawn belongs to --draw; give polylines");
  if(options.is_as_drawn && (options.is_snapped || options.mollify || options.kernel || options.stop_length ||
                             options.meshes.is_triangulation_wanted()))
    throw Bad_input("--as-drawn gives no curves of a triangulation: --snap, --mollify, --kernel, --stop-length, "
                    "--delaunay, --refine and --subdivision do not go with it");
  if(options.has_free_junctions && options.segmentation.empty())
    throw Bad_input("--free-junctions belongs to --segmentation; give a segmentation");
  if(options.from.has_value() != options.to.has_value())
    throw Bad_input("--from and --to belong together; give both");
  constexpr long long most_at_random = 10000000;
  if(options.random && (*options.random < 1 || *options.random > most_at_random))
    throw Bad_input("--random " + std::to_string(*options.random) + ": give 1 to " + std::to_string(most_at_random));
  if(options.seed < 0)
    throw Bad_input("--seed " + std::to_string(options.seed) + ": give 0 or more");
  if(options.kernel && options.kernel != "double" && options.kernel != "certified")
    throw Bad_input("--kernel " + printable(*options.kernel) + ": not known; use certified or double");
  if(options.mollify && !(*options.mollify > 0 && *options.mollify < 1))
    throw Bad_input("--mollify must lie between 0 and 1");
  if(options.rounds && (*options.rounds < 0 || *options.rounds > 16))
    throw Bad_input("--rounds " + std::to_string(*options.rounds) + ": give 0 to 16");
  if(options.rounds && options.bezier.empty())
    throw Bad_input("--rounds belongs to --bezier; give control points");
  if(!options.bezier.empty() && options.stop_length)
    throw Bad_input("--stop-length does not go with --bezier; leave it out");
  search_method(options.search);
  if(options.stop_length && !(*options.stop_length >= 0 && *options.stop_length <= 1))
    throw Bad_input("--stop-length must lie between 0 and 1");
  if(options.most_memory && !(*options.most_memory > 0 && *options.most_memory <= 1e9))
    throw Bad_input("--most-memory must be above 0 and at most 1e9, in megabytes");
  if(options.threads < 1 || options.threads > 1024)
    throw Bad_input("--threads must lie between 1 and 1024");
  if(options.threads > 1 && !has_threads)
    throw Bad_input("--threads " + std::to_string(options.threads) + ": this program was built without threads (TBB)");
  check_mesh_results(options.meshes);
  check_names_of_inputs(options);
  check_names_of_results(options);
  check_formats_of_results(options);
  if(options.threads > 1 && !options.results.page.empty())
    throw Bad_input("--page shows the steps of the curves one after the other; give --threads 1 with it");
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
    throw Bad_input("--delaunay, --refine, --subdivision, --insert and --cut take one curve, or a network of several");
  std::size_t number_of_curves = 0;
  for(const Network_request& request : requests)
    number_of_curves += request.curves.size();
  const std::optional<Landmarks> landmarks = make_landmarks(options, mesh, metric, progress);
  progress.expect_curves(number_of_curves);
  const Run_options run_options = {search_method(options.search),
                                   options.stop_length,
                                   options.is_shortest,
                                   landmarks ? &landmarks->bounds : nullptr,
                                   options.rounds.value_or(5),
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
  Field_request request = {
      {}, options.isolines, options.spacing.value_or(0), options.has_voronoi, options.tolerance.value_or(0)};
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
  Ways_request request = {{}, static_cast<std::size_t>(*options.ways), read_obstacles(options, input), std::nullopt};
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

int run(const Options& options)
{
  check_options(options);
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
  const Program_metric metric(mesh, options.mollify);
  if(options.mollify)
    title << metric.added_length() << " added to the length of every edge\n";
  if(!options.traces.empty())
    return run_traces(options, input, title.str(), progress);
  if(options.is_as_drawn)
    return run_drawn(options, input, title.str(), progress);
  if(options.ways)
    return run_other_ways(options, input, title.str(), progress);
  if(options_of_curves(options).empty())
    return run_without_curves(options, input, title.str());
  return options.is_field_wanted() ? run_field(options, input, title.str(), progress)
                                   : run(options, input, metric, title.str(), progress);
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
