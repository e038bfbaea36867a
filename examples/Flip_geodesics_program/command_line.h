// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_COMMAND_LINE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_COMMAND_LINE_H

#include "decimal_numbers.h"
#include "program_options.h"
#include "run/parallel_runs.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

/*!
 * The options of the program, in the groups of `--help`.
 *
 * Most of them belong to one of three questions: which curves, how they are computed, and what is written.
 */
class Command_line
{
public:
  explicit Command_line(Options& options)
    : m_options(options)
    , m_app("Pulls curves on a triangle mesh tight: geodesics by edge flips", "flip_geodesics")
  {
    m_app.set_version_flag("--version", "flip_geodesics " FLIP_GEODESICS_VERSION, "Print the version and exit");
    m_app.get_formatter()->column_width(28);
    m_app.footer("\nExamples:\n"
                 "  flip_geodesics bunny.off --from 0 --to 1000 --mesh path.glb\n"
                 "  flip_geodesics bunny.off --random 100 --seed 1 --stats paths.csv\n"
                 "  flip_geodesics bunny.off --network curves.txt --page curves.html");
    add_mesh();
    add_curves_from_vertices();
    add_other_ways();
    add_curves_from_files();
    add_curves_from_sources();
    add_arithmetic();
    add_limits();
    add_files_of_curves();
    add_meshes();
    add_messages();
  }

  /// Reads the arguments into the options. \throws CLI::ParseError
  void parse(int argc, const char* const* argv) { m_app.parse(argc, argv); }

  std::string help() const { return m_app.help(); }

  /// What is wrong with the arguments, after `parse()` has thrown: with the option that may have been meant.
  std::string describe(const CLI::ParseError& error) const
  {
    for(const std::string& argument : m_app.remaining())
      if(is_like_an_option(argument)) {
        const std::string unknown = argument.substr(0, argument.find('='));
        const std::string name = unknown[1] == '-' ? unknown : '-' + unknown;
        const std::string meant = unknown.size() > 2 ? nearest_option(name) : ""; // one letter is near many
        return unknown + " is not known; " + (meant.empty() ? "see --help" : "did you mean " + meant + "?");
      }
    if(!m_app.remaining().empty())
      return "'" + m_app.remaining().front() +
             "' is not expected: one mesh, and an option before each other value; "
             "see --help";
    return error.what() + std::string("; see --help");
  }

private:
  // What an option holds that may lack.
  template <class Value>
  struct Held
  {
    using Type = Value;
  };
  template <class Value>
  struct Held<std::optional<Value>>
  {
    using Type = Value;
  };
  template <class Value>
  using Number_of = typename Held<Value>::Type;

  // Decimal, as numbers are in files; CLI11 itself would take them for octal after a zero.
  template <class Number>
  static Number number(const std::string& name, const std::string& text)
  {
    Number result = 0;
    if(const char* const error = parse_number(text, result))
      throw CLI::ValidationError(name, "'" + text + "' " + error);
    return result;
  }

  CLI::Option* add(const char* name, const char* type, std::string& value, const char* description)
  {
    return m_app.add_option(name, value, description)->type_name(type)->group(m_group);
  }
  CLI::Option* add(const char* name, const char* type, std::optional<std::string>& value, const char* description)
  {
    return m_app.add_option(name, value, description)->type_name(type)->group(m_group);
  }
  CLI::Option* add(const char* name, const char* type, std::vector<std::string>& value, const char* description)
  {
    return m_app.add_option(name, value, description)->type_name(type)->group(m_group);
  }

  // A number, or none that is given.
  template <class Value>
  CLI::Option* add(const char* name, const char* type, Value& value, const char* description)
  {
    const auto read = [name, &value](const std::string& text) { value = number<Number_of<Value>>(name, text); };
    CLI::Option* const option =
        m_app.add_option_function<std::string>(name, read, description)->type_name(type)->group(m_group);
    if constexpr(std::is_arithmetic<Value>::value)
      option->default_str(std::to_string(value));
    return option;
  }

  void add(const char* name, bool& value, const char* description)
  {
    m_app.add_flag(name, value, description)->group(m_group);
  }

  // Numbers with commas between, none of which is left out. May be repeated.
  template <class Number>
  void add_list(const char* name, const char* type, std::vector<Number>& numbers, const char* description)
  {
    const auto append = [name, &numbers](const std::vector<std::string>& texts) {
      for(const std::string& text : texts)
        append_numbers(name, text, numbers);
    };
    m_app.add_option_function<std::vector<std::string>>(name, append, description)
        ->type_name(type)
        ->group(m_group)
        ->allow_extra_args(false);
  }

  template <class Number>
  static void append_numbers(const std::string& name, const std::string& text, std::vector<Number>& numbers)
  {
    const char* next = text.data();
    const char* const end = next + text.size();
    while(true) {
      const char* const comma = std::find(next, end, ',');
      const std::string item(next, comma);
      numbers.emplace_back();
      if(const char* const error = parse_number(item, numbers.back()))
        throw CLI::ValidationError(name, "'" + item + "' in '" + text + "' " + error);
      if(comma == end)
        return;
      next = comma + 1;
    }
  }

  void add_mesh()
  {
    m_app.add_option("MESH", m_options.mesh, "A triangle mesh: OFF, OBJ, PLY, STL, TS; - for standard input")
        ->type_name("FILE")
        ->required();
    m_group = "The mesh";
    add("--format", "NAME", m_options.format, "Format of MESH: off, obj, ply, stl or ts [by the extension]");
    add("--repair", m_options.is_repaired,
        "Make a triangle mesh of any polygons: triangulate, orient, cut apart, stitch, drop; and say what was done");
    add("--weld", "TOLERANCE", m_options.weld,
        "With --repair: merge points at most this far apart, relative to the longest side of the bounding box [0]");
    add("--repaired", "FILE", m_options.results.repaired,
        "With --repair: write the repaired mesh, which the results are about: .off, .obj, .ply, .stl or .vtp");
    add("--mollify", "MARGIN", m_options.mollify,
        "Lengthen all edges until triangles have this margin of the mean edge length: for degenerate meshes");
    add("--refuse-zero-edges", m_options.are_zero_edges_refused,
        "Curves that meet an edge of length zero fail; else such edges are contracted for them");
  }

  void add_curves_from_vertices()
  {
    m_group = "Curves between vertices, which are counted from 0";
    add("--from", "VERTEX", m_options.from, "Source of one geodesic");
    add("--to", "VERTEX", m_options.to, "Target of one geodesic");
    add("--pairs", "FILE", m_options.pairs, "A geodesic per line `source target`; # starts a comment");
    add("--random", "NUMBER", m_options.random, "So many geodesics between random vertices of a component");
    add("--seed", "NUMBER", m_options.seed, "Seed of --random");
    add("--shortest", m_options.is_shortest,
        "With --from, --pairs or --random: the shortest of all paths, and whether that is proven; with --source: "
        "replace paths that are not globally shortest");
    add("--landmarks", "NUMBER", m_options.landmarks,
        "With --shortest: so many landmarks, which are made before and make hundreds of paths faster; 8 are good");
    add("--trace", "VERTEX,ANGLE,LENGTH", m_options.traces,
        "A straightest geodesic from a vertex: its direction, in radians as in --map, and its length; may be repeated")
        ->allow_extra_args(false);
  }

  void add_other_ways()
  {
    m_group = "Other ways between vertices";
    add("--ways", "NUMBER", m_options.ways,
        "With --from, --pairs or --random: the shortest paths of so many homotopy classes, around handles and borders");
    add("--avoid", "FILE", m_options.obstacles,
        "With --ways: what they do not cross; a wall of edges per line, as vertices, or `f n n ...` faces");
  }

  void add_curves_from_files()
  {
    m_group = "Curves from files";
    add("--edges", "FILE", m_options.edges, "A path of edges per line, as vertices, each straightened by itself");
    add("--loop", "FILE", m_options.loop, "A closed loop of edges per line, each straightened by itself");
    add("--network", "FILE", m_options.network,
        "Curves straightened together: a path per line, `o v v ...` a loop, `! v ...` fixed vertices");
    add("--points", "FILE", m_options.points,
        "A geodesic per line, through points anywhere: `v`, `a,b,t` on an edge or `a,b,c,t,u` in a face");
    add("--bezier", "FILE", m_options.bezier,
        "A geodesic Bezier curve per line of control points, `s p p ...` a B-spline, `o p p ...` closed");
    add("--rounds", "NUMBER", m_options.rounds, "How often the pieces of --bezier are halved; 5 if not given");
    add("--draw", "FILE", m_options.draw,
        "A polyline per line, drawn on the mesh and pulled tight: points as above, after `o` closed; or, in a file "
        ".polylines.txt, points in space");
    add("--snap", m_options.is_snapped, "Move the polylines of --draw to edges first, and do not insert their points");
    add("--as-drawn", m_options.is_as_drawn,
        "Keep the polylines of --draw as they are, and do not shorten them; they may cross");
    add("--segmentation", "FILE", m_options.segmentation,
        "A label per line for each face; the network of the boundaries between labels");
    add("--free-junctions", m_options.has_free_junctions,
        "Where boundaries meet they need not stay: each region of --segmentation has its own closed curves");
    add("--seams", m_options.has_seams, "The network of the texture seams of an OBJ file");
  }

  void add_curves_from_sources()
  {
    m_group = "Curves from sources";
    add_list("--source", "VERTEX", m_options.sources,
             "The tree of geodesics from this vertex to all others; a curve per edge of the tree. With --isolines, "
             "--spacing or --voronoi: vertices `v,v,...`, and no tree");
    add_list("--isolines", "DISTANCE", m_options.isolines,
             "With --source: the curves at these distances, `d,d,...`, from the nearest");
    add("--spacing", "DISTANCE", m_options.spacing,
        "With --source: the curves at all multiples of this distance, in the place of --isolines");
    add("--voronoi", m_options.has_voronoi, "With --source: the curves on which the nearest of them changes");
    add("--tolerance", "LENGTH", m_options.tolerance,
        "How far these curves may lie from the true curves; not given, a thousandth of the size, and no "
        "less than a millionth");
  }

  void add_arithmetic()
  {
    m_group = "How curves are computed";
    add("--kernel", "NAME", m_options.kernel,
        "Arithmetic: certified, which decides and proves exactly, or double; certified if not given");
    add("--search", "NAME", m_options.search,
        "Search of the edge paths: lookback (soon pulled tight), astar or dijkstra (shortest)")
        ->capture_default_str();
    add("--threads", "NUMBER", m_options.threads, "Compute so many curves at the same time")
        ->group(has_threads ? m_group : ""); // not in the help of a program that cannot
  }

  void add_limits()
  {
    m_group = "When to stop";
    add("--stop-length", "RATIO", m_options.stop_length,
        "Stop before a curve, or a network as a whole, is shorter than this share of its initial length");
    add("--most-memory", "MEGABYTES", m_options.most_memory,
        "Stop where the flips of a curve, or a network, take more; not given, three quarters of the machine's memory");
  }

  void add_files_of_curves()
  {
    m_group = "Files of curves";
    add("--mesh", "FILE", m_options.results.viewer,
        "Write surface and curves for a viewer: .obj, .ply, .vtp or .glb; or curves as .polylines.txt");
    add("--tubes", "RADIUS", m_options.results.tubes,
        "With --mesh: how thick curves are, 0 for lines; not given, a five-hundredth of the size of the mesh");
    add("--page", "FILE", m_options.results.page,
        "Write a page for a browser: surface, curves, and the flips step by step");
    add("--live", "FILE", m_options.results.live,
        "Write a page that computes: curves through points that are dragged on this mesh; needs no curves here");
    add("--polylines", "FILE", m_options.results.polylines,
        "Write a line per point, `curve a b t x y z`: (1-t) a + t b");
    add("--stats", "FILE", m_options.results.stats, "Write a line per curve, comma-separated, with a header");
    add("--map", "FILE", m_options.results.map,
        "With --source: write a line per vertex, `vertex,distance,angle,x,y`: its polar coordinates");
    add("--output-format", "NAME", m_options.output_format, "Format of a mesh written to -, standard output");
  }

  void add_meshes()
  {
    m_group = "The triangulation, and meshes from it";
    add("--delaunay", m_options.meshes.is_delaunay, "Flip the other edges to constrained Delaunay");
    add("--refine", "ANGLE", m_options.meshes.refine, "Insert vertices until no angle is smaller, in degrees");
    add("--longest-edge", "LENGTH", m_options.meshes.longest_edge, "With --refine: until no edge is longer, too");
    add("--most-vertices", "NUMBER", m_options.meshes.most_vertices,
        "With --refine: insert no more than so many; a million if not given");
    add("--subdivision", "FILE", m_options.meshes.subdivision,
        "Write the common subdivision of mesh and triangulation: .off, .obj, .ply, .stl or .vtp");
    add("--insert", "FILE", m_options.meshes.insertion, "Write the mesh with the curves as edges, as above");
    add("--cut", "FILE", m_options.meshes.cut, "Write the mesh cut open along the curves, as above");
  }

  void add_messages()
  {
    m_group = "Others";
    add("--force", m_options.is_replacing_input, "Let a result replace the mesh or a file of curves that is read");
    add("--quiet", m_options.is_quiet, "No table and no progress");
  }

  // Letters to insert, to drop or to exchange until one text is the other [Levenshtein 1966].
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

  std::string nearest_option(const std::string& name) const
  {
    std::string nearest;
    std::size_t most = 1 + name.size() / 3; // as many as may be wrong, and one
    for(const CLI::Option* option : m_app.get_options()) {
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
  std::string m_group;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_COMMAND_LINE_H
