// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes geodesic curves on a triangle mesh from the command line; see --help.
//
// Exit status: 0 on success, 1 if a curve could not be computed or a result not be written (the others are), 2 on bad
// input, 128 and the signal's number if it is interrupted.

#include "command_line.h"
#include "file_name.h"
#include "input/program_input.h"
#include "messages.h"
#include "output/program_output.h"
#include "output/result_formats.h"
#include "output/run_files.h"
#include "program_options.h"
#include "run/computations.h" // flattens by Eigen under CGAL_EIGEN3_ENABLED
#include "run/curve_engine.h"
#include "run/machine.h" // uses threads under CGAL_LINKED_WITH_TBB
#include "run/progress.h"
#include "run/slit_surface.h"
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
#include <type_traits>
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
  return {options.mesh,         options.pairs,        options.edges,       options.loop, options.network,
          options.segmentation, options.points,       options.bezier,      options.draw, options.obstacles,
          options.sources_file, options.face_weights, options.edge_weights};
}

std::vector<std::string> names_of_results(const Options& options)
{
  const Result_names& names = options.results;
  std::vector<std::string> results = names.outputs;
  for(const std::string& name : {names.polylines, names.stats, names.page, names.live, names.map, names.matrix,
                                 names.json, options.meshes.subdivision, options.meshes.insertion, options.meshes.cut})
    results.push_back(name);
  return results;
}

// Standard input is read once.
void check_names_of_inputs(const Options& options)
{
  std::size_t number = 0;
  for(const std::string& name : names_of_inputs(options))
    if(name == standard_stream && ++number > 1)
      throw Bad_input("standard input can be read only once; use files for all inputs but one");
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
        throw Bad_input(name_of_result(name) + ": two results cannot be written to one file; specify another file");
    for(const std::string& input : names_of_inputs(options))
      if(!options.is_replacing_input && !input.empty() && is_same_file(name, input) && is_plain_file(input))
        throw Bad_input(printable(name) +
                        ": a result would replace this input file; specify another file, or add --force");
    results.push_back(name);
  }
  if(!options.output_format.empty() && std::none_of(results.begin(), results.end(), is_standard_output))
    throw Bad_input("--output-format requires a result on standard output; add --output -");
}

// The table goes where no result goes.
std::ostream& summary_stream(const Options& options)
{
  const std::vector<std::string> results = names_of_results(options);
  return std::any_of(results.begin(), results.end(), is_standard_output) ? std::cerr : std::cout;
}

// What the records of flips may take in each thread, in bytes.
std::size_t memory_limit(const Options& options)
{
  constexpr double megabyte = 1e6;
  const double most = options.memory_limit ? *options.memory_limit * megabyte : 0.75 * memory_of_machine();
  return static_cast<std::size_t>(most / usable_threads(options.threads));
}

// What all commands share: the mesh, where the results go, and how far the run has come.
struct Run
{
  const Options& options;
  const Input_mesh& input;
  std::string title; // a line for people
  Progress& progress;
  std::optional<Outputs> outputs = {};

  void open()
  {
    outputs.emplace(options);
    if(options.command != "info") // which has them among the defects
      print_remarks(input.remarks());
  }

  void print_remarks(const std::vector<std::string>& remarks) const
  {
    if(!options.is_quiet)
      for(const std::string& remark : remarks)
        std::cerr << "flip_geodesics: " << remark << '\n';
  }

  // Completes the files, and prints the table of the curves, if any were requested, and lines for people. A defect of
  // the result, unless it is empty, goes to standard error and makes the result incomplete.
  int finish(const std::string& lines, bool has_curves = true, const std::string& defect = "")
  {
    progress.enter("writing");
    std::vector<std::string> remarks = input.remarks();
    std::istringstream in(lines);
    for(std::string line; std::getline(in, line);)
      remarks.push_back(line);
    const std::vector<std::string> remarks_on_files = outputs->remarks(input);
    remarks.insert(remarks.end(), remarks_on_files.begin(), remarks_on_files.end());
    print_remarks(remarks_on_files);
    if(!defect.empty()) {
      remarks.push_back(defect);
      std::cerr << "flip_geodesics: " << name_of_input(options.mesh) << ": " << defect << '\n';
    }
    outputs->close(input, remarks);
    if(!options.is_quiet) {
      std::ostream& out = summary_stream(options);
      out << title;
      if(has_curves)
        outputs->print_summary(out);
      out << lines;
    }
    return outputs->has_failed() || !defect.empty() ? incomplete : success;
  }
};

// The requested curves, in files or as those of the surface.
std::vector<Network_request> requests_of(const Run& run)
{
  run.progress.enter("reading curves");
  if(run.options.command != "loops")
    return read_requests(run.options, run.input);
  if(run.options.is_cut_graph)
    return {cut_graph_request()};
  return surface_loops(run.input, run.options.are_handles, run.progress);
}

template <class Metric>
int run_engine(Run& run, const Metric& metric)
{
  const Options& options = run.options;
  const Mesh& mesh = run.input;
  Progress& progress = run.progress;
  if(options.mollify) {
    std::ostringstream line;
    line << metric.added_length() << " was added to the length of every edge\n";
    run.title += line.str();
  }
  const std::vector<Network_request> requests = requests_of(run);
  if(requests.size() != 1 && options.meshes.is_any_wanted())
    throw Bad_input("--insert, --cut and the command `refine` require a single curve, or one network of curves, "
                    "instead of " +
                    counted(requests.size(), "curve", "curves") +
                    "; compute one curve at a time, or all curves as a network");
  std::size_t number_of_curves = 0;
  for(const Network_request& request : requests)
    number_of_curves += request.curves.size();
  std::optional<Landmarks> landmarks;
  if(options.landmarks) {
    landmarks = make_landmarks(static_cast<std::size_t>(*options.landmarks), options.threads, mesh, metric, progress);
    run.title += landmarks->remark;
  }
  progress.expect_curves(number_of_curves);
  const Run_options run_options = {search_method(options.search),
                                   options.stop_length,
                                   options.stop_curve_length,
                                   options.is_shortest || options.command == "shortest",
                                   landmarks ? &landmarks->bounds : nullptr,
                                   options.rounds,
                                   options.is_snapped,
                                   options.are_zero_edges_refused,
                                   options.meshes,
                                   memory_limit(options),
                                   !options.results.map.empty()};
  const auto make_engine = [&] {
    if constexpr(std::is_same<std::decay_t<decltype(metric)>, Weighted_program_metric>::value)
      return make_weighted_engine(mesh, metric, run_options, progress);
    else
      return options.kernel == "double" ? make_double_engine(mesh, metric, run_options, progress)
                                        : make_certified_engine(mesh, metric, run_options, progress);
  };
  const std::unique_ptr<Curve_engine> engine = make_engine();
  for(const Network_request& request : requests)
    if(!request.has_no_given_curves() && !request.curves.front().is_pair)
      engine->check(request);

  run.open();
  Outputs& outputs = *run.outputs;
  const auto write = [&](const Network_request&, std::vector<Curve_result> results) {
    if(options.sample)
      sample_curves(mesh, *options.sample, results);
    progress.enter("writing");
    outputs.write(results, engine->record());
    if(engine->map())
      outputs.write(*engine->map());
    outputs.write(engine->meshes());
  };
  if(options.threads > 1 && requests.size() > 1) {
    run_in_parallel(requests, usable_threads(options.threads), make_engine, write);
  } else {
    for(const Network_request& request : requests) {
      engine->set_most_recorded_points(outputs.most_recorded_points());
      write(request, engine->run(request));
    }
  }
  return run.finish(engine->tree_results() + engine->mesh_results());
}

int run_engine(Run run)
{
  const Slit_surface surface(run.input, Obstacles());
  return with_metric(surface, read_conditions(run.options, run.input),
                     [&](const auto& metric) { return run_engine(run, metric); });
}

// Curves that `compute(lines)` gives at once, of no triangulation, with lines for people.
template <class Compute>
int run_at_once(Run& run, const Compute& compute)
{
  run.open();
  std::string lines;
  std::vector<Curve_result> results = compute(lines);
  run.outputs->write(meshes_along(run.input, results, run.options.meshes, run.progress));
  if(run.options.sample)
    sample_curves(run.input, *run.options.sample, results);
  run.progress.enter("writing");
  for(const Curve_result& result : results)
    run.outputs->write({result}, std::nullopt);
  return run.finish(lines);
}

int run_field(Run run)
{
  const Options& options = run.options;
  const Field_request request = {read_sources(options, run.input),
                                 options.isolines,
                                 options.spacing,
                                 options.has_voronoi,
                                 options.results.has_values || !options.results.map.empty(),
                                 !options.results.matrix.empty(),
                                 options.tolerance,
                                 read_conditions(options, run.input)};
  return run_at_once(run, [&](std::string& lines) {
    Field_curves found = field_curves(run.input, request, run.progress);
    run.outputs->write(found);
    lines = std::move(found.remarks);
    return std::move(found.curves);
  });
}

int run_other_ways(Run run)
{
  constexpr double megabyte = 1e6;
  const Options& options = run.options;
  Ways_request request = {{},
                          static_cast<std::size_t>(options.ways.value_or(1)),
                          read_conditions(options, run.input).obstacles,
                          std::nullopt};
  for(const Network_request& network : requests_of(run))
    request.pairs.push_back(network.curves.front());
  if(options.memory_limit)
    request.memory_limit = *options.memory_limit * megabyte;
  return run_at_once(run, [&](std::string& lines) {
    Ways ways = other_ways(run.input, request, run.progress);
    lines = ways.others;
    return ways.curves;
  });
}

int run_traces(Run run)
{
  const std::vector<Trace_request> requests = read_traces(run.options, run.input);
  const Path_conditions conditions = read_conditions(run.options, run.input);
  return run_at_once(run, [&](std::string&) { return traced_curves(run.input, requests, conditions, run.progress); });
}

int run_drawn(Run run)
{
  const std::vector<Network_request> requests = requests_of(run);
  const auto compute = run.options.command == "cut" ? drawn_curves : certified_curves;
  return run_at_once(run, [&](std::string&) { return compute(run.input, requests, run.progress); });
}

// The commands that compute no curves.
int run_without_curves(Run run)
{
  const std::string& command = run.options.command;
  std::string lines, defect;
  std::optional<Mesh_info> info;
  if(command == "info") {
    info = mesh_info(run.input, run.input.is_repaired(), run.input.remarks());
    lines = describe(*info, run.input);
  }
  Result_meshes meshes;
  if(command == "flatten") {
    const bool is_cut_given = !run.options.network.empty() || run.options.has_seams;
    Flattened_mesh flattened =
        flattened_mesh(run.input, name_of_input(run.options.mesh),
                       is_cut_given ? requests_of(run).front() : cut_graph_request(), run.options.meshes, run.progress);
    meshes.flattened = std::move(flattened.mesh);
    lines = flattened.report;
    defect = flattened.defect;
  }
  run.open();
  if(info)
    run.outputs->write(*info);
  run.outputs->write(meshes);
  return run.finish(lines, false, defect);
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
  const Input_mesh input = read_input_mesh(options, progress);
  const Mesh& mesh = input;
  std::ostringstream title;
  title << name_of_input(options.mesh) << ": " << counted(mesh.number_of_vertices(), "vertex", "vertices") << ", "
        << counted(mesh.number_of_faces(), "triangle", "triangles") << ", read in "
        << readable_time(stopwatch.seconds()) << '\n';
  const std::string& name = options.command;
  if(name == "trace")
    return run_traces({options, input, title.str(), progress});
  if(name == "cut" || name == "certify")
    return run_drawn({options, input, title.str(), progress});
  if(name == "distance")
    return run_field({options, input, title.str(), progress});
  if(name == "repair" || name == "view" || name == "info" || name == "flatten")
    return run_without_curves({options, input, title.str(), progress});
  if(options.ways || !options.obstacles.empty())
    return run_other_ways({options, input, title.str(), progress});
  return run_engine({options, input, title.str(), progress});
}

// What is left of standard output goes out.
int flushed(int status)
{
  if(std::cout.flush())
    return status;
  std::cerr << "flip_geodesics: standard output: " << reason_of_failed_write() << '\n';
  return status == success ? incomplete : status;
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  Command_line command_line(options);
  try {
    if(std::find(argv + 1, argv + argc, std::string()) != argv + argc)
      throw Bad_input("an argument is empty; omit its option or specify a value");
    command_line.parse(argc, argv);
    sort_outputs(options);
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
