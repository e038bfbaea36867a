// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes geodesic curves on a triangle mesh from the command line; see --help.
//
// Exit status: 0 on success, 1 if a curve could not be computed (the others are written), 2 on bad input.

#include "curve_input.h"
#include "curve_runner.h"
#include "data_input.h"
#include "drawn_input.h"
#include "mesh_input.h"
#include "page_file.h"
#include "parallel_runs.h" // uses threads under CGAL_LINKED_WITH_TBB
#include "point_input.h"
#include "progress.h"
#include "result_files.h"
#include "run_summary.h"
#include "viewer_files.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Mollified_metric.h>

#include <CGAL/assertions_behaviour.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace program;

constexpr int success = 0, incomplete = 1, bad_input = 2;

struct Options
{
  std::string mesh;
  std::optional<long long> from, to;
  std::string pairs, edges, loop, network, segmentation, points, bezier, draw;
  bool is_snapped = false;
  std::optional<int> rounds;
  bool has_seams = false, has_free_junctions = false, is_shortest = false;
  std::optional<long long> source;
  std::optional<long long> random;
  long long seed = 1;
  std::string kernel = "double", search = "lookback";
  std::optional<double> stop_length, mollify;
  int threads = 1;
  std::string polylines, stats, viewer, page, map;
  Mesh_result_options meshes;
  bool is_quiet = false;
};

void add_options(CLI::App& app, Options& options)
{
  app.add_option("MESH", options.mesh, "A triangle mesh: OFF, OBJ, PLY, STL")->required();
  app.add_option("--from", options.from, "Source of one geodesic; vertices are counted from 0");
  app.add_option("--to", options.to, "Target of one geodesic");
  app.add_option("--pairs", options.pairs, "File: a geodesic per line `source target`; # starts a comment");
  app.add_option("--random", options.random, "So many geodesics between random vertices of a component");
  app.add_option("--seed", options.seed, "Seed of --random")->capture_default_str();
  app.add_option("--edges", options.edges, "File: a path of edges per line, as vertices, each straightened by itself");
  app.add_option("--loop", options.loop, "File: a closed loop of edges per line, each straightened by itself");
  app.add_option("--network", options.network,
                 "File: curves straightened together: a path per line, `o v v ...` a loop, `! v ...` fixed vertices");
  app.add_option(
      "--points", options.points,
      "File: a geodesic per line, through points anywhere: `v`, `a,b,t` on an edge or `a,b,c,t,u` in a face");
  app.add_option(
      "--bezier", options.bezier,
      "File: a geodesic Bezier curve per line of control points, `s p p ...` a B-spline, `o p p ...` closed");
  app.add_option("--rounds", options.rounds, "How often the pieces of --bezier are halved; 5 if not given");
  app.add_option("--draw", options.draw,
                 "File: a polyline per line, drawn on the mesh and pulled tight: points as above, after `o` closed; or, in "
                 "a file .polylines.txt, points in space");
  app.add_flag("--snap", options.is_snapped, "Move the polylines of --draw to edges first, and do not insert their points");
  app.add_option("--segmentation", options.segmentation,
                 "File: a label per line for each face; the network of the boundaries between labels");
  app.add_flag("--free-junctions", options.has_free_junctions,
               "Where boundaries meet they need not stay: each region of --segmentation has its own closed curves");
  app.add_flag("--seams", options.has_seams, "The network of the texture seams of an OBJ file");
  app.add_option("--source", options.source,
                 "The tree of geodesics from this vertex to all others; a curve per edge of the tree");
  app.add_flag("--shortest", options.is_shortest, "With --source: replace paths that are not globally shortest");
  app.add_option("--kernel", options.kernel, "Arithmetic: double, or certified, which decides and proves exactly")
      ->capture_default_str();
  app.add_option("--mollify", options.mollify,
                 "Lengthen all edges until triangles have this margin of the mean edge length: for degenerate meshes");
  app.add_option("--search", options.search,
                 "Search of the edge paths: lookback (soon pulled tight), astar or dijkstra (shortest)")
      ->capture_default_str();
  app.add_option("--stop-length", options.stop_length,
                 "Stop before a curve, or a network as a whole, is shorter than this share of its initial length");
  app.add_option("--map", options.map,
                 "With --source: write a line per vertex, `vertex,distance,angle,x,y`: its polar coordinates");
  app.add_option("--threads", options.threads, "Compute so many curves at the same time")->capture_default_str();
  app.add_option("--polylines", options.polylines, "Write a line per point, `curve a b t x y z`: (1-t) a + t b");
  app.add_option("--stats", options.stats, "Write a line per curve, comma-separated, with a header");
  app.add_option("--mesh", options.viewer,
                 "Write surface and curves for a viewer: .obj, .ply, .vtp or .glb; or curves as .polylines.txt");
  app.add_option("--page", options.page, "Write a page for a browser: surface, curves, and the flips step by step");
  app.add_flag("--delaunay", options.meshes.is_delaunay, "Flip the other edges to constrained Delaunay");
  app.add_option("--refine", options.meshes.refine, "Insert vertices until no angle is smaller, in degrees");
  app.add_option("--longest-edge", options.meshes.longest_edge, "With --refine: until no edge is longer, too");
  app.add_option("--most-vertices", options.meshes.most_vertices,
                 "With --refine: insert no more than so many; a million if not given");
  app.add_option("--subdivision", options.meshes.subdivision,
                 "Write the common subdivision of mesh and triangulation: .off, .obj, .ply, .stl or .vtp");
  app.add_option("--insert", options.meshes.insertion, "Write the mesh with the curves as edges, as above");
  app.add_option("--cut", options.meshes.cut, "Write the mesh cut open along the curves, as above");
  app.add_flag("--quiet", options.is_quiet, "No table and no progress");
}

CGAL::Flip_geodesics::Search_method search_method(const std::string& name)
{
  using CGAL::Flip_geodesics::Search_method;
  if(name == "lookback")
    return Search_method::LOOK_BACK;
  if(name == "astar")
    return Search_method::A_STAR;
  if(name == "dijkstra")
    return Search_method::DIJKSTRA;
  throw Bad_input("--search " + name + ": not known; use lookback, astar or dijkstra");
}

// Each result in a file of its own.
void check_names_of_results(const Options& options)
{
  std::vector<std::string> names;
  for(const std::string& name : {options.polylines, options.stats, options.viewer, options.page, options.map,
                                 options.meshes.subdivision, options.meshes.insertion, options.meshes.cut})
    if(!name.empty())
      names.push_back(name);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if(twice != names.end())
    throw Bad_input(*twice + ": two results cannot go to one file; name another one");
}

void check_options(const Options& options)
{
  const int jobs = (options.from || options.to ? 1 : 0) + (options.random ? 1 : 0) + (options.pairs.empty() ? 0 : 1) +
                   (options.edges.empty() ? 0 : 1) + (options.loop.empty() ? 0 : 1) +
                   (options.network.empty() ? 0 : 1) + (options.segmentation.empty() ? 0 : 1) +
                   (options.has_seams ? 1 : 0) + (options.source ? 1 : 0) + (options.points.empty() ? 0 : 1) +
                   (options.bezier.empty() ? 0 : 1) + (options.draw.empty() ? 0 : 1);
  if(jobs != 1)
    throw Bad_input("give the curves by one of --from with --to, --pairs, --random, --edges, --loop, --network, "
                    "--points, --bezier, --draw, --segmentation, --seams, --source");
  if(!options.source && (options.is_shortest || !options.map.empty()))
    throw Bad_input("--shortest and --map belong to --source; give a source");
  if(options.source && options.stop_length)
    throw Bad_input("--stop-length is of no use with --source; leave one of them out");
  if(options.is_snapped && options.draw.empty())
    throw Bad_input("--snap belongs to --draw; give polylines");
  if(options.has_free_junctions && options.segmentation.empty())
    throw Bad_input("--free-junctions belongs to --segmentation; give a segmentation");
  if(options.from.has_value() != options.to.has_value())
    throw Bad_input("--from and --to belong together; give both");
  constexpr long long most_at_random = 10000000;
  if(options.random && (*options.random < 1 || *options.random > most_at_random))
    throw Bad_input("--random " + std::to_string(*options.random) + ": give 1 to " + std::to_string(most_at_random));
  if(options.seed < 0)
    throw Bad_input("--seed " + std::to_string(options.seed) + ": give 0 or more");
  if(options.kernel != "double" && options.kernel != "certified")
    throw Bad_input("--kernel " + options.kernel + ": not known; use double or certified");
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
  if(options.threads < 1 || options.threads > 1024)
    throw Bad_input("--threads must lie between 1 and 1024");
  if(options.threads > 1 && !has_threads)
    throw Bad_input("--threads " + std::to_string(options.threads) + ": this program was built without threads (TBB)");
  check_mesh_results(options.meshes);
  check_names_of_results(options);
  if(options.threads > 1 && !options.page.empty())
    throw Bad_input("--page shows the steps of the curves one after the other; give --threads 1 with it");
}

// The independent runs: one curve each, or all curves of a network.
std::vector<Network_request> read_requests(const Options& options, const Mesh& mesh)
{
  if(!options.network.empty())
    return {read_network(mesh, options.network)};
  if(!options.segmentation.empty())
    return {read_segmentation(mesh, options.segmentation, options.has_free_junctions)};
  if(options.has_seams)
    return {read_seams(mesh, options.mesh)};
  if(options.source)
    return {tree_request(mesh, *options.source)};
  const std::vector<Curve_request> curves =
      options.random            ? random_pairs(mesh, static_cast<std::size_t>(*options.random), static_cast<std::uint64_t>(options.seed))
      : !options.pairs.empty()  ? read_pairs(mesh, options.pairs)
      : !options.points.empty() ? read_point_curves(mesh, options.points, false)
      : !options.bezier.empty() ? read_point_curves(mesh, options.bezier, true)
      : !options.draw.empty()   ? read_drawn_curves(mesh, options.draw)
      : !options.edges.empty()  ? read_curves(mesh, options.edges, false)
      : !options.loop.empty()   ? read_curves(mesh, options.loop, true)
                                : single_pair(mesh, *options.from, *options.to);
  std::vector<Network_request> requests;
  for(const Curve_request& curve : curves)
    requests.push_back({{curve}, {}, {}});
  return requests;
}

/// Where the results go.
class Outputs
{
public:
  explicit Outputs(const Options& options)
    : m_polylines(options.polylines)
    , m_stats(options.stats)
    , m_viewer(options.viewer)
    , m_page(options.page)
    , m_map(options.map)
    , m_meshes(options.meshes)
  {
    m_scene.title = options.mesh.substr(options.mesh.find_last_of("/\\") + 1);
  }

  /// How many points of the next run are to be recorded for the page.
  std::size_t most_recorded_points() const { return m_page.is_wanted() ? m_most_recorded_points : 0; }

  void write(const std::vector<Curve_result>& run, const std::optional<Shortening_record>& record)
  {
    for(std::size_t i = 0; i < run.size(); ++i, ++m_curve) {
      m_polylines.write(m_curve, run[i]);
      m_stats.write(m_curve, run[i]);
      m_summary.add(m_curve, run[i], i > 0);
      if(m_viewer.is_wanted() || m_page.is_wanted())
        m_scene.curves.push_back(scene_curve(run[i]));
      if(run[i].is_error())
        std::cerr << "flip_geodesics: curve " << m_curve << " (" << run[i].name << "): " << run[i].error << '\n';
      m_has_failed = m_has_failed || run[i].is_error();
    }
    ++m_run;
    if(!m_page.is_wanted())
      return;
    m_scene.records.push_back(record.value_or(Shortening_record()));
    m_most_recorded_points -= (std::min)(m_most_recorded_points, number_of_points(m_scene.records.back()));
  }

  void write(const CGAL::Flip_geodesics::Logarithmic_map& map) { m_map.write(map); }

  Mesh_files& mesh_files() { return m_meshes; }

  void close(const Mesh& mesh)
  {
    m_map.close();
    m_polylines.close();
    m_stats.close();
    m_meshes.close();
    m_viewer.write(mesh, m_scene);
    m_page.write(mesh, m_scene);
  }

  const Run_summary& summary() const { return m_summary; }
  bool has_failed() const { return m_has_failed; }

private:
  Scene_curve scene_curve(const Curve_result& r) const
  {
    Scene_curve curve = {m_curve,
                         r.name,
                         r.status,
                         r.certificate,
                         r.initial_length,
                         r.length,
                         r.flips,
                         r.is_closed,
                         r.is_of_tree,
                         m_run,
                         {}};
    for(const Curve_point& p : r.points)
      curve.points.push_back(p.in_space);
    return curve;
  }

  Polylines_file m_polylines;
  Stats_file m_stats;
  Viewer_file m_viewer;
  Page_file m_page;
  Map_file m_map;
  Mesh_files m_meshes;
  Scene m_scene;
  std::size_t m_run = 0, m_most_recorded_points = 1000000; // 16 megabytes on the page
  Run_summary m_summary;
  std::size_t m_curve = 0;
  bool m_has_failed = false;
};

// `title` is printed above the table.
template <class Traits, class Metric_>
int run(const Options& options, const Mesh& mesh, const Metric_& metric, const std::vector<Network_request>& requests,
        const std::string& title)
{
  std::size_t number_of_curves = 0;
  for(const Network_request& request : requests)
    number_of_curves += request.curves.size();
  const CGAL::Flip_geodesics::Search_method search = search_method(options.search);
  Progress progress(number_of_curves, options.is_quiet);
  const bool is_certifying = options.kernel == "certified";
  using Runner = Curve_runner<Traits, Metric_>;
  const auto make_runner = [&] {
    return std::make_unique<Runner>(
        mesh, metric,
        Run_options{search, is_certifying, options.stop_length, options.is_shortest, options.rounds.value_or(5), options.is_snapped, options.meshes},
        progress);
  };
  const std::unique_ptr<Runner> runner = make_runner();
  for(const Network_request& request : requests)
    if(!request.tree_source && !request.curves.front().is_pair)
      runner->check(request);

  Outputs outputs(options);
  runner->set_mesh_files(&outputs.mesh_files());
  const auto write = [&](const Network_request& request, const std::vector<Curve_result>& results) {
    outputs.write(results, runner->record());
    if(runner->map())
      outputs.write(*runner->map());
    progress.add_curves(request.curves.size());
  };
  if(options.threads > 1 && requests.size() > 1) {
    run_in_parallel(requests, options.threads, make_runner, write);
  } else {
    for(const Network_request& request : requests) {
      runner->set_most_recorded_points(outputs.most_recorded_points());
      write(request, runner->run(request));
    }
  }
  outputs.close(mesh);
  if(!options.is_quiet) {
    outputs.summary().print(std::cout << title);
    std::cout << runner->mesh_results();
  }
  return outputs.has_failed() ? incomplete : success;
}

template <class Metric_>
int run(const Options& options, const Mesh& mesh, const Metric_& metric, const std::string& title)
{
  namespace FG = CGAL::Flip_geodesics;
  const std::vector<Network_request> requests = read_requests(options, mesh);
  if(requests.size() != 1 && options.meshes.is_any_wanted())
    throw Bad_input("--delaunay, --refine, --subdivision, --insert and --cut take one curve, or a network of several");
  if(options.kernel == "certified")
    return run<FG::Certified_intrinsic_triangulation_traits<Kernel>>(options, mesh, metric, requests, title);
  return run<FG::Intrinsic_triangulation_traits<Kernel>>(options, mesh, metric, requests, title);
}

int run(const Options& options)
{
  check_options(options);
  const Stopwatch stopwatch;
  const Mesh mesh = read_mesh(options.mesh);
  std::ostringstream title;
  title << options.mesh << ": " << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces()
        << " triangles, read in " << stopwatch.seconds() << " s\n";
  const Metric metric(mesh.points());
  if(!options.mollify)
    return run(options, mesh, metric, title.str());
  //! [Mollified metric]
  const CGAL::Flip_geodesics::Mollified_metric<Metric> mollified(mesh, metric, *options.mollify);
  title << mollified.added_length() << " added to the length of every edge\n";
  //! [Mollified metric]
  return run(options, mesh, mollified, title.str());
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Pulls curves on a triangle mesh tight: geodesics by edge flips", "flip_geodesics");
  Options options;
  add_options(app, options);
  try {
    if(std::find(argv + 1, argv + argc, std::string()) != argv + argc)
      throw Bad_input("an argument is empty; leave its option out or give it a value");
    app.parse(argc, argv);
    CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
    return run(options);
  } catch(const CLI::CallForHelp&) {
    std::cout << app.help();
    return success;
  } catch(const CLI::ParseError& error) {
    std::cerr << "flip_geodesics: " << error.what() << "; see --help\n";
  } catch(const std::exception& error) {
    std::cerr << "flip_geodesics: " << error.what() << '\n';
  }
  return bad_input;
}
