// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_COMMAND_LINE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_COMMAND_LINE_H

#include "decimal_numbers.h"
#include "file_name.h"
#include "messages.h"
#include "program_options.h"
#include "run/machine.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

/// The numbers that an option takes.
struct Range
{
  double least, most = std::numeric_limits<double>::infinity();
  bool is_least_excluded = false, is_most_excluded = false;

  /// Returns what is wrong with a number, and nothing if it is in range.
  std::string error(double x) const
  {
    if((is_least_excluded ? x > least : x >= least) && (is_most_excluded ? x < most : x <= most))
      return {};
    std::ostringstream out;
    out.precision(std::numeric_limits<float>::max_digits10); // more than the limits have
    out << "is out of range; use " << (is_least_excluded ? "more than " : "at least ") << least;
    if(std::isfinite(most))
      out << " and " << (is_most_excluded ? "less than " : "at most ") << most;
    return out.str();
  }
};

/*!
 * The commands of the program. Options that several commands share are added by one function for all of them.
 */
class Command_line
{
public:
  explicit Command_line(Options& options)
    : m_options(options)
    , m_app("Compute geodesic curves on a triangle mesh", "flip_geodesics")
  {
    m_app.set_version_flag("--version", "flip_geodesics " FLIP_GEODESICS_VERSION, "Print the version and exit");
    m_app.require_subcommand(1);
    m_app.formatter(std::make_shared<Formatter>());
    m_app.get_formatter()->label("SUBCOMMAND", "COMMAND");
    m_app.get_formatter()->column_width(28);
    m_app.footer("\nflip_geodesics COMMAND --help lists the options of a command. Examples:\n"
                 "  flip_geodesics path bunny.off --from 0 --to 1000 -o path.glb -o path.json\n"
                 "  flip_geodesics distance bunny.off --source 0,500 --spacing 0.1 -o isolines.vtp\n"
                 "  flip_geodesics view bunny.off --output bunny.html");
    add_commands_of_triangulations();
    add_commands_of_distances();
    add_commands_of_meshes();
  }

  /// Reads the arguments into the options. \throws CLI::ParseError, Bad_input
  void parse(int argc, const char* const* argv)
  {
    m_app.parse(argc, argv);
    m_options.command = m_app.get_subcommands().front()->get_name();
    m_options.format = format_name(m_options.format);
    m_options.output_format = format_name(m_options.output_format);
    for(const auto& [command, names] : m_required) {
      const auto is_given = [command = command](const std::string& name) { return command->count(name) > 0; };
      if(command->parsed() && std::none_of(names.begin(), names.end(), is_given))
        throw Bad_input("the command " + m_options.command + " requires one of the options " + joined(names, " or "));
    }
  }

  std::string help() const { return m_app.help(); }

  /// Describes what is wrong with the arguments after `parse()` has thrown, with the option that may be meant.
  std::string describe(const CLI::ParseError& error) const
  {
    const std::vector<CLI::App*> given = m_app.get_subcommands();
    const std::vector<std::string> remaining = m_app.remaining(true);
    const auto is_word = [](const std::string& argument) { return !is_like_an_option(argument); };
    const auto word = std::find_if(remaining.begin(), remaining.end(), is_word);
    if(given.empty() && word != remaining.end())
      return "'" + *word + "' is not a command; specify one of these before the mesh: " + names_of_commands();
    if(given.empty())
      return "specify a command: " + names_of_commands() + "; see --help";
    const std::string help = "; see flip_geodesics " + given.front()->get_name() + " --help";
    for(const std::string& argument : remaining)
      if(is_like_an_option(argument))
        return describe_unknown(argument.substr(0, argument.find('=')), *given.front(), help);
    if(word != remaining.end())
      return "'" + *word + "' is unexpected: a command takes one mesh, and every other value must follow its option" +
             help;
    return describe_misuse(error) + help;
  }

private:
  // A line per option, and one empty line between groups.
  struct Formatter : CLI::Formatter
  {
    std::string make_option_opts(const CLI::Option* option) const override
    {
      const std::string type = option->get_type_name();
      return type.empty() ? type : ' ' + type;
    }
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override
    {
      std::string text = CLI::Formatter::make_help(app, name, mode);
      for(std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;)
        text.erase(at, 1);
      return text;
    }
  };

  static constexpr const char* m_points =
      "A POINT is `v`, a vertex; `a,b,t`, the point (1-t) a + t b of an edge; `a,b,c,t,u`, the point "
      "(1-t-u) a + t b + u c of a face (v, a, b and c are vertices, whole numbers counted from 0); or `x,y,z`, the "
      "point of the mesh nearest to this point in space (x or y must have a decimal point or an exponent)";
  static constexpr Range positive = {0, std::numeric_limits<double>::infinity(), true};
  static constexpr Range not_negative = {0};

  // Decimal, as numbers are in files; CLI11 itself would take them for octal after a zero.
  template <class Number>
  static CLI::Validator number_in(const Range& range)
  {
    const auto check = [range](std::string& text) {
      Number number = 0;
      const char* const error = parse_number(text, number);
      const std::string problem = error != nullptr ? error : range.error(static_cast<double>(number));
      if(!problem.empty())
        return "'" + text + "' " + problem;
      text = std::is_integral<Number>::value ? std::to_string(number) : decimal_text(static_cast<double>(number));
      return problem;
    };
    return {check, ""};
  }

  // Requires one of some names, which the message lists.
  static CLI::Validator one_of(const std::vector<std::string>& names)
  {
    const auto check = [names](const std::string& text) {
      const bool is_known = std::find(names.begin(), names.end(), text) != names.end();
      return is_known ? std::string() : "'" + text + "' is not known; use " + joined(names, " or ");
    };
    return {check, ""};
  }

  // The names with commas between, and `last` before the last one.
  static std::string joined(const std::vector<std::string>& names, const std::string& last)
  {
    std::string text;
    for(std::size_t i = 0; i < names.size(); ++i)
      text += (i == 0 ? "" : i + 1 == names.size() ? last : ", ") + names[i];
    return text;
  }

  template <class Value>
  CLI::Option* add(const char* name, const char* type, Value& value, const std::string& description)
  {
    return m_command->add_option(name, value, description)->type_name(type)->group(m_group);
  }

  template <class Number>
  CLI::Option* add(const char* name, const char* type, Number& value, const Range& range, const char* description)
  {
    return add(name, type, value, description)->transform(number_in<Number>(range));
  }
  template <class Number>
  CLI::Option* add(const char* name, const char* type, std::optional<Number>& value, const Range& range,
                   const char* description)
  {
    return add(name, type, value, description)->transform(number_in<Number>(range));
  }

  CLI::Option* add(const char* name, bool& value, const char* description)
  {
    return m_command->add_flag(name, value, description)->disable_flag_override()->group(m_group);
  }

  // Numbers with commas between, none of which is left out. May be repeated.
  void add_isolines()
  {
    const auto append = [this, number = number_in<double>(positive)](const std::vector<std::string>& texts) {
      for(const std::string& text : texts) {
        if(text.back() == ',')
          throw CLI::ValidationError("--isolines", "'" + text + "' ends with a comma; remove it");
        for(const std::string_view piece : pieces_of(text)) {
          std::string level(piece);
          if(const std::string error = number(level); !error.empty())
            throw CLI::ValidationError("--isolines", error);
          parse_number(level, m_options.isolines.emplace_back());
        }
      }
    };
    m_command
        ->add_option_function<std::vector<std::string>>("--isolines", append, "compute isolines at these distances")
        ->type_name("DISTANCE,...")
        ->group(m_group)
        ->allow_extra_args(false);
  }

  void require_one_of(const std::vector<std::string>& names) { m_required.emplace_back(m_command, names); }

  void exclude(const std::string& name, const std::vector<std::string>& others)
  {
    for(const std::string& other : others)
      m_command->get_option(name)->excludes(m_command->get_option(other));
  }

  // One of them, and no more.
  void require_single(const std::vector<std::string>& names)
  {
    require_one_of(names);
    for(std::size_t i = 0; i < names.size(); ++i)
      exclude(names[i], {names.begin() + static_cast<std::ptrdiff_t>(i) + 1, names.end()});
  }

  // A command, with the options that all of them have.
  void begin(const char* name, const char* description, const char* examples)
  {
    m_command = m_app.add_subcommand(name, description)->group("Commands");
    m_command->footer(std::string("\nExamples:\n") + examples);
    m_group = "Options";
    add("MESH", "FILE", m_options.mesh, "read an OFF, OBJ, PLY, STL or TS file; - for standard input")
        ->group("Positionals")
        ->required();
    add("--format", "NAME", m_options.format,
        "read MESH in this format: off, obj, ply, stl or ts [determined by the extension]");
    const std::string command = name;
    CLI::Option* const repair = command == "repair" || command == "info"
                                    ? nullptr
                                    : add("--repair", m_options.is_repaired, "repair the mesh first");
    CLI::Option* const weld = add(
        "--weld", "TOLERANCE", m_options.weld, {0, 1, false, true},
        "merge points whose coordinates differ by at most this fraction of the longest side of the bounding box [0]");
    if(repair != nullptr)
      weld->description(weld->get_description() + "; requires --repair")->needs(repair);
    add("--force", m_options.is_replacing_input, "allow a result to replace an input file");
    add("-q,--quiet", m_options.is_quiet, "do not print the summary, remarks or progress");
    add("--json", "FILE", m_options.results.json,
        "write curves, distances, properties of the mesh and remarks as JSON; - for standard output");
    add("--output-format", "NAME", m_options.output_format,
        "determine the format of the result on standard output (-o -) by this file extension, such as obj");
  }

  void add_ends()
  {
    m_group = std::string("Curves (given in one of these ways). ") + m_points;
    CLI::Option* const from = add("--from", "POINT", m_options.from, "start the path at this point; requires --to");
    CLI::Option* const to = add("--to", "POINT", m_options.to, "end the path at this point; requires --from");
    from->needs(to);
    to->needs(from);
  }

  void add_pairs()
  {
    add_ends();
    add("--pairs", "FILE", m_options.pairs, "read the ends of one path per line, `source target`");
    add("--random", "NUMBER", m_options.random, {1, 1e7}, "compute this many paths between random vertices");
    add("--seed", "NUMBER", m_options.seed, not_negative, "set the seed of --random [1]");
  }

  void add_files_of_paths()
  {
    add("--edges", "FILE", m_options.edges, "read one edge path per line, given by its vertices");
    add("--points", "FILE", m_options.points, "read one path per line, given by the points through which it passes");
    add_draw();
    add("--snap", m_options.is_snapped, "replace the polylines of --draw by nearby edge paths before shortening")
        ->needs(m_command->get_option("--draw"));
  }

  CLI::Option* add_draw()
  {
    return add("--draw", "FILE", m_options.draw,
               "read one polyline per line, given by its points (after `o` if it is closed); in a file "
               "NAME.polylines.txt, a line consists of the number of points and their coordinates");
  }

  CLI::Option* add_loop()
  {
    return add("--loop", "FILE", m_options.loop, "read one closed loop of edges per line, given by its vertices");
  }

  void add_network()
  {
    add("--network", "FILE", m_options.network,
        "read one edge path per line, given by its vertices; a line `o v v ...` is a loop, and a line `! v ...` fixes "
        "the curves at these vertices");
  }

  void add_seams() { add("--seams", m_options.has_seams, "use the texture seams of MESH, an OBJ file, as curves"); }

  void add_networks()
  {
    add_network();
    add("--segmentation", "FILE", m_options.segmentation,
        "read one face label per line, and use the boundaries between faces with different labels as curves");
    add("--free-junctions", m_options.has_free_junctions,
        "allow the junctions of the boundaries of --segmentation to move")
        ->needs(m_command->get_option("--segmentation"));
    add_seams();
  }

  void add_splines()
  {
    add("--bezier", "FILE", m_options.bezier,
        "read one Bezier curve per line, given by its control points; a line `s ...` is a B-spline, and a line "
        "`o ...` a closed B-spline");
    add("--rounds", "NUMBER", m_options.rounds, {0, 16}, "halve the pieces of splines this many times [5]")
        ->needs(m_command->get_option("--bezier"));
  }

  void add_arithmetic()
  {
    m_group = "Computation";
    add("--kernel", "NAME", m_options.kernel,
        "evaluate predicates exactly (certified) or in floating point (double) [certified]")
        ->check(one_of({"certified", "double"}));
    add_mollify();
    add("--refuse-zero-edges", m_options.are_zero_edges_refused,
        "report degenerate edges as errors instead of contracting them");
    add_memory_limit();
  }

  void add_mollify()
  {
    add("--mollify", "MARGIN", m_options.mollify, {0, 1, true, true},
        "lengthen all edges by the smallest common amount such that each face satisfies the triangle inequality with a "
        "margin of this fraction of the mean edge length");
  }

  void add_weights()
  {
    add("--face-weights", "FILE", m_options.face_weights,
        "read one weight per line for all faces in order, or lines `face weight` (other faces have the weight 1); the "
        "weights are averaged at the vertices");
    add("--edge-weights", "FILE", m_options.edge_weights,
        "read lines `v w weight`, and multiply the length of the edge between the vertices v and w by the weight");
    exclude("--face-weights", {"--edge-weights"});
    if(m_command->get_option_no_throw("--kernel") != nullptr)
      exclude("--kernel", {"--face-weights", "--edge-weights"}); // certified
  }

  void add_avoid()
  {
    add("--avoid", "FILE", m_options.obstacles,
        "read one obstacle per line: the vertices of a barrier along edges, or faces `f n n ...`; given points must "
        "not lie inside an obstacle or on a barrier");
  }

  void add_memory_limit()
  {
    const std::string of_ways = m_command->get_name() == "shortest"
                                    ? "; with --ways or --avoid, about 1200 plus 0.024 per vertex of the mesh"
                                    : "";
    add("--memory-limit", "MEGABYTES", m_options.memory_limit,
        "end the computation of curves that require more memory than this [3/4 of the memory of the machine" + of_ways +
            "]")
        ->transform(number_in<double>({0, 1e9, true}));
  }

  CLI::Option* add_vertex_limit()
  {
    return add("--vertex-limit", "NUMBER", m_options.meshes.vertex_limit, not_negative,
               "fail if the subdivided mesh would have more vertices than this [5000000]");
  }

  void add_search()
  {
    add("--search", "NAME", m_options.search,
        "search for initial edge paths by the method lookback (an any-angle A*), astar or dijkstra [lookback]")
        ->check(one_of({"lookback", "astar", "dijkstra"}));
  }

  void add_threads()
  {
    if(!has_threads)
      return;
    const std::string of_ways =
        m_command->get_name() == "shortest" ? "; without effect if --ways or --avoid is given" : "";
    add("--threads", "NUMBER", m_options.threads, {1, 1024},
        ("compute this many curves at the same time [1]" + of_ways).c_str());
    CLI::Option* const limit = m_command->get_option("--memory-limit");
    limit->description(limit->get_description() + "; divided equally among the threads");
  }

  void add_stop_length()
  {
    const bool are_joint = m_command->get_name() == "network" || m_command->get_name() == "refine";
    add("--stop-length", "RATIO", m_options.stop_length, {0, 1},
        are_joint ? "stop shortening before the total length falls below this fraction of the initial total length [0]"
                  : "stop shortening a curve before its length falls below this fraction of its initial length [0]");
  }

  void add_files_of_curves()
  {
    m_group = "Results";
    CLI::Option* const output =
        add_outputs("-o,--output,--mesh", "write the surface and the curves (.obj, .ply, .vtp, .glb), the curves alone "
                                          "(.polylines.txt), or the result of --json, --stats or --page (.json, .csv, "
                                          ".html); can be repeated");
    add("--tubes", "RADIUS", m_options.results.tubes, not_negative,
        "draw curves as tubes of this radius, or as lines if it is 0 [1/500 of the diagonal of the bounding box; 0 if "
        "the curves have more than 100000 points]")
        ->needs(output);
    add("--sample", "DISTANCE", m_options.sample, positive,
        "replace the points of each curve by equally spaced points that are at most this far apart");
    add("--page", "FILE", m_options.results.page,
        "write an HTML page that shows the surface, the curves and the flips, if any");
    add("--polylines", "FILE", m_options.results.polylines,
        "write one line per point, not in the format .polylines.txt: `curve a b t x y z` for a vertex or a crossed "
        "edge, or `curve a b c t u x y z` for another point of a face");
    add("--stats", "FILE", m_options.results.stats, "write lengths, statuses and times of the curves as CSV");
    add("--insert", "FILE", m_options.meshes.insertion,
        "write the mesh with the curves as edges (.off, .obj, .ply, .stl, .vtp)");
    add("--cut", "FILE", m_options.meshes.cut,
        "write the mesh cut open along the curves (.off, .obj, .ply, .stl, .vtp)");
    if(m_command->get_option_no_throw("--threads") != nullptr)
      exclude("--threads", {"--page"}); // which shows the steps of the curves one after the other
  }

  CLI::Option* add_outputs(const char* name, const std::string& description)
  {
    m_group = "Results";
    return add(name, "FILE", m_options.results.outputs, description)->allow_extra_args(false);
  }

  void add_commands_of_triangulations()
  {
    begin("path", "Shorten paths to geodesics, independently of one another",
          "  flip_geodesics path bunny.off --from 0 --to 1000 -o path.glb -o path.json\n"
          "  flip_geodesics path bunny.off --random 100 --seed 1 --stats paths.csv\n"
          "  flip_geodesics path bunny.off --draw pen.polylines.txt --page paths.html");
    add_pairs();
    add_files_of_paths();
    require_single({"--from", "--pairs", "--random", "--edges", "--points", "--draw"});
    add_arithmetic();
    add_weights();
    add_search();
    add_stop_length();
    add_threads();
    add_files_of_curves();

    begin("loop", "Shorten closed curves to geodesics, independently of one another",
          "  flip_geodesics loop bunny.off --loop loops.txt -o loops.vtp\n"
          "  flip_geodesics loop bunny.off --loop loops.txt --stop-length 0.9 --polylines loops.out\n"
          "  flip_geodesics loop bunny.off --loop loops.txt --page loops.html");
    m_group = "Curves";
    add_loop()->required();
    add_arithmetic();
    add_weights();
    add_stop_length();
    add_threads();
    add_files_of_curves();

    begin("loops", "Compute closed geodesics around the handles and holes of a surface",
          "  flip_geodesics loops torus.off -o loops.vtp\n"
          "  flip_geodesics loops torus.off --handles --stats loops.csv\n"
          "  flip_geodesics loops torus.off --cut-graph --cut disk.off");
    m_group = "Curves [a basis of the homology]";
    add("--handles", m_options.are_handles, "compute handle loops, then tunnel loops, of the enclosed solid");
    add("--cut-graph", m_options.is_cut_graph, "compute curves that cut each component open into a disk");
    exclude("--handles", {"--cut-graph"});
    add_arithmetic();
    add_stop_length();
    exclude("--cut-graph", {"--stop-length"});
    add_threads();
    add_files_of_curves();

    begin("network", "Shorten curves together: a network, the boundaries of regions, or texture seams",
          "  flip_geodesics network bunny.off --network curves.txt --stop-length 0.9 -o curves.ply\n"
          "  flip_geodesics network bunny.off --segmentation labels.seg -o boundaries.ply\n"
          "  flip_geodesics network textured.obj --seams --cut pieces.off");
    m_group = "Curves (given in one of these ways)";
    add_networks();
    require_single({"--network", "--segmentation", "--seams"});
    add_arithmetic();
    add_weights();
    add_stop_length();
    add("--stop-curve-length", "RATIO", m_options.stop_curve_length, {0, 1},
        "stop shortening a curve before its length falls below this fraction of its initial length [0]");
    add_files_of_curves();

    begin("spline", "Compute geodesic Bezier curves and B-splines",
          "  flip_geodesics spline bunny.off --bezier control_points.txt -o curves.obj\n"
          "  flip_geodesics spline bunny.off --bezier control_points.txt --rounds 7 --polylines curves.txt\n"
          "  flip_geodesics spline bunny.off --bezier control_points.txt --page curves.html");
    m_group = "Curves";
    add_splines();
    m_command->get_option("--bezier")->required();
    add_arithmetic();
    add_weights();
    add_search();
    add_threads();
    add_files_of_curves();

    begin("refine", "Flip or refine a triangulation that contains given curves as edges",
          "  flip_geodesics refine bunny.off --from 0 --to 1000 --refine 25 --subdivision refined.off\n"
          "  flip_geodesics refine bunny.off --network curves.txt --delaunay --subdivision common.vtp\n"
          "  flip_geodesics refine bunny.off --loop loop.txt --refine 0 --longest-edge 0.01 --subdivision fine.ply");
    add_ends();
    add_files_of_paths();
    add_loop();
    add_networks();
    add_splines();
    require_single(
        {"--from", "--edges", "--points", "--draw", "--loop", "--network", "--segmentation", "--seams", "--bezier"});
    m_group = "The triangulation";
    add("--delaunay", m_options.meshes.is_delaunay,
        "flip edges to obtain a Delaunay triangulation that is constrained to the curves");
    CLI::Option* const refine =
        add("--refine", "ANGLE", m_options.meshes.refine, {0, 30},
            "insert vertices until no angle is smaller than this (0 to 30 degrees), where possible");
    add("--longest-edge", "LENGTH", m_options.meshes.longest_edge, {1e-70},
        "insert vertices until no edge is longer than this; requires --refine")
        ->needs(refine);
    add("--insertion-limit", "NUMBER", m_options.meshes.insertion_limit, not_negative,
        "insert at most this many vertices [1000000]")
        ->needs(refine);
    CLI::Option* const subdivision = add("--subdivision", "FILE", m_options.meshes.subdivision,
                                         "write the common subdivision of the mesh and the triangulation");
    add_vertex_limit()->needs(subdivision);
    require_one_of({"--delaunay", "--refine", "--subdivision"});
    add_arithmetic();
    add_search();
    add_stop_length();
    exclude("--stop-length", {"--bezier"});
    add_files_of_curves();
  }

  void add_commands_of_distances()
  {
    begin("shortest", "Compute globally shortest paths, optionally of several homotopy classes",
          "  flip_geodesics shortest bunny.off --from 0 --to 1000 -o path.glb\n"
          "  flip_geodesics shortest bunny.off --pairs pairs.txt --landmarks 8 --stats paths.csv\n"
          "  flip_geodesics shortest torus.off --from 0 --to 150 --ways 4 --avoid walls.txt -o ways.vtp");
    add_pairs();
    require_single({"--from", "--pairs", "--random"});
    m_group = "Homotopy classes and obstacles";
    add("--ways", "NUMBER", m_options.ways, {1, 1000}, "compute the shortest paths of this many homotopy classes");
    add_avoid();
    add_arithmetic();
    add_weights();
    add_search();
    add_threads();
    add("--landmarks", "NUMBER", m_options.landmarks, {1, 1000},
        "precompute the distances from this many vertices to speed up the search; 8 are recommended for hundreds of "
        "paths");
    for(const char* const name : {"--ways", "--avoid"})
      exclude(name, {"--kernel", "--mollify", "--refuse-zero-edges", "--search", "--landmarks", "--face-weights",
                     "--edge-weights"});
    add_files_of_curves();

    begin("trace", "Trace straightest geodesics from points",
          "  flip_geodesics trace bunny.off --trace 0,1.57,20 -o straight.vtp\n"
          "  flip_geodesics trace bunny.off --trace 0,1.57,20 --trace 0,1,2,0.3,0.3,4.71,20 --polylines straight.txt\n"
          "  flip_geodesics trace bunny.off --trace 0,1.57,20 --cut slit.off");
    m_group = m_points;
    add("--trace", "POINT,ANGLE,LENGTH", m_options.traces,
        "trace a geodesic of this length from a point, at an angle in radians, across at most 1000000 edges and "
        "vertices; can be repeated")
        ->allow_extra_args(false)
        ->required();
    m_group = "Metric and obstacles";
    add_avoid();
    add_mollify();
    add_weights();
    add_files_of_curves();

    begin("distance", "Compute distances, their isolines and Voronoi diagrams",
          "  flip_geodesics distance bunny.off --source 0,500,900 --isolines 0.1,0.2,0.3 -o isolines.vtp\n"
          "  flip_geodesics distance bunny.off --source 0 --spacing 0.1 --polylines isolines.txt\n"
          "  flip_geodesics distance bunny.off --sources points.txt --map distances.csv --values -o distances.vtp");
    m_group = m_points;
    add("--source", "POINT", m_options.sources,
        "measure distances from a point, or from vertices `v,v,...`; can be repeated")
        ->allow_extra_args(false);
    add("--sources", "FILE", m_options.sources_file, "read the sources: points separated by blanks or line breaks");
    require_one_of({"--source", "--sources"});
    add_isolines();
    add("--spacing", "DISTANCE", m_options.spacing, positive, "compute isolines at all multiples of this distance");
    add("--voronoi", m_options.has_voronoi, "compute the boundaries of the Voronoi diagram of the sources");
    add("--tolerance", "LENGTH", m_options.tolerance, positive,
        "limit the distance of isolines and Voronoi boundaries from the true curves [1/1000 of the diagonal of the "
        "bounding box]");
    m_group = "Metric and obstacles";
    add_avoid();
    add_mollify();
    add_weights();
    add_files_of_curves();
    add("--map", "FILE", m_options.results.map, "write one line `vertex,distance,source` per vertex as CSV");
    add("--values", m_options.results.has_values,
        "add the distances and nearest sources of the vertices to .ply and .vtp files, which are then binary, and the "
        "distances to .json files")
        ->needs(m_command->get_option("--output"));
    add("--matrix", "FILE", m_options.results.matrix, "write the distances between the sources as CSV");
    exclude("--isolines", {"--spacing"});
    require_one_of({"--isolines", "--spacing", "--voronoi", "--map", "--values", "--matrix"});

    begin("log", "Compute the tree of geodesics from a point, and the logarithmic map at this point",
          "  flip_geodesics log bunny.off --source 0 --map map.csv\n"
          "  flip_geodesics log bunny.off --source 0 --shortest --map map.csv -o tree.ply\n"
          "  flip_geodesics log bunny.off --source 0 --kernel double --stats tree.csv");
    m_group = m_points;
    add("--source", "POINT", m_options.sources, "grow the tree from this point")->required()->expected(1);
    add("--shortest", m_options.is_shortest,
        "replace paths that are not globally shortest by shortest paths; the source must be a vertex");
    add_arithmetic();
    add_weights();
    add_files_of_curves();
    add("--map", "FILE", m_options.results.map, "write one line `vertex,distance,angle,x,y` per vertex as CSV");
  }

  void add_commands_of_meshes()
  {
    begin("cut", "Cut a mesh along drawn polylines, which are allowed to cross",
          "  flip_geodesics cut bunny.off --draw pen.polylines.txt --cut pieces.off\n"
          "  flip_geodesics cut bunny.off --draw pen.txt --insert lines.ply\n"
          "  flip_geodesics cut bunny.off --draw pen.txt -o lines.glb --stats lines.csv");
    m_group = "Curves";
    add_draw()->required();
    add_files_of_curves();

    begin("certify", "Check whether given curves are locally shortest",
          "  flip_geodesics certify bunny.off --draw curves.polylines.txt\n"
          "  flip_geodesics certify bunny.off --draw edges.txt --stats verdicts.csv\n"
          "  flip_geodesics certify bunny.off --draw curves.polylines.txt --quiet --json -");
    m_group = "Curves, with a point on each edge that they cross and at each vertex through which they pass";
    add_draw()->required();
    add_files_of_curves();

    begin("repair", "Convert arbitrary polygons to an oriented manifold triangle mesh",
          "  flip_geodesics repair polygons.obj --output mesh.off\n"
          "  flip_geodesics repair scan.stl --weld 1e-9 --output scan.ply\n"
          "  flip_geodesics repair - --format off --output - --output-format off");
    add_outputs("-o,--output", "write the mesh (.off, .obj, .ply, .stl, .vtp); can be repeated")->required();

    begin("flatten", "Cut a connected surface open and flatten it conformally to texture coordinates",
          "  flip_geodesics flatten bunny.off --output flat.obj\n"
          "  flip_geodesics flatten bunny.off --network seams.txt --output flat.glb\n"
          "  flip_geodesics flatten textured.obj --seams --output flat.obj");
    m_group = "Curves that are shortened, and along which the mesh is then cut [a cut graph]";
    add_network();
    add_seams();
    exclude("--network", {"--seams"});
    m_group = "The flattened mesh";
    add_vertex_limit();
    add_outputs("-o,--output", "write the mesh with texture coordinates (.obj, .glb); can be repeated")->required();

    begin("info", "Print components, borders, genus, size and defects of a mesh",
          "  flip_geodesics info bunny.off\n"
          "  flip_geodesics info scan.stl --weld 1e-9\n"
          "  flip_geodesics info bunny.off --quiet --json -");

    begin("view", "Write an HTML page in which curves can be drawn and edited on the mesh",
          "  flip_geodesics view bunny.off --output bunny.html\n"
          "  flip_geodesics view polygons.obj --repair --output polygons.html\n"
          "  flip_geodesics view - --format stl --output scan.html");
    m_group = "Results";
    add("-o,--output", "FILE", m_options.results.live, "write the page to this .html file")->required();
  }

  // Letters to insert, to drop or to exchange until one text is the other (Levenshtein distance).
  static std::size_t distance(const std::string& a, const std::string& b)
  {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for(std::size_t i = 0; i < a.size(); ++i) {
      std::size_t diagonal = std::exchange(row[0], i + 1);
      for(std::size_t j = 0; j < b.size(); ++j) {
        const std::size_t exchanged = diagonal + (a[i] != b[j] ? 1 : 0);
        diagonal = row[j + 1];
        row[j + 1] = std::min({exchanged, diagonal + 1, row[j] + 1});
      }
    }
    return row.back();
  }

  // Neither a name nor a negative number.
  static bool is_like_an_option(const std::string& argument)
  {
    return argument.size() > 1 && argument[0] == '-' && argument.find_first_of("0123456789.") != 1;
  }

  std::string names_of_commands() const
  {
    std::string names;
    for(const CLI::App* command : m_app.get_subcommands({}))
      names += (names.empty() ? "" : ", ") + command->get_name();
    return names;
  }

  // Describes known options that are used in a wrong way.
  static std::string describe_misuse(const CLI::ParseError& error)
  {
    const std::string text = error.what();
    const std::string too_often = ": At Most 1 required but received ";
    if(const std::size_t at = text.find(too_often); at != std::string::npos)
      return text.substr(0, at) + " is given " + text.substr(at + too_often.size()) + " times; give it once";
    if(const std::size_t at = text.find(": 1 required "); at != std::string::npos)
      return text.substr(0, at) + " requires a value; specify one";
    const std::string excludes = " excludes ";
    if(const std::size_t at = text.find(excludes); at != std::string::npos)
      return text.substr(0, at) + " and " + text.substr(at + excludes.size()) + " cannot be combined; use one of them";
    if(const std::size_t at = text.find(" was given a disallowed flag override"); at != std::string::npos)
      return (at == 1 ? "-" : "--") + text.substr(0, at) + " does not take a value";
    if(text.rfind("--longest-edge requires", 0) == 0)
      return text + "; use --refine 0 for no bound on angles";
    return text;
  }

  std::string describe_unknown(const std::string& unknown, const CLI::App& given, const std::string& help) const
  {
    const std::string name = unknown[1] == '-' ? unknown : '-' + unknown;
    std::vector<std::string> others;
    for(const CLI::App* command : m_app.get_subcommands({}))
      if(command->get_option_no_throw(name) != nullptr)
        others.push_back(command->get_name());
    if(!others.empty())
      return name + " is not an option of " + given.get_name() + ", but of " + joined(others, " and ") + help;
    const std::string meant = unknown.size() > 2 ? nearest_option(name, given) : ""; // one letter is near many
    return unknown + " is not known" + (meant.empty() ? help : "; did you mean " + meant + "?");
  }

  static std::string nearest_option(const std::string& name, const CLI::App& command)
  {
    std::string nearest;
    std::size_t most = 1 + name.size() / 3; // as many as may be wrong, and one
    for(const CLI::Option* option : command.get_options()) {
      const std::string known = option->get_name();
      const bool is_begun = name.size() > 3 && known.rfind(name, 0) == 0;
      const std::size_t wrong = is_begun ? 0 : distance(name, known);
      if(wrong < most) {
        most = wrong;
        nearest = known;
      }
    }
    return nearest;
  }

  Options& m_options;
  CLI::App m_app;
  CLI::App* m_command = nullptr; // that options are added to
  std::string m_group;
  std::vector<std::pair<const CLI::App*, std::vector<std::string>>> m_required; // one of some options at least
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_COMMAND_LINE_H
