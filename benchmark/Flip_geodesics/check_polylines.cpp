// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Checks the curves that flip_geodesics wrote with --polylines: see polyline_checker.h for what is checked, and how.
// Shares no code with the library. The mesh is read by the same reader as there, so that vertices have the same
// numbers.
//
// Exit status: 0 if all curves are what they should be, 1 if not, 2 on bad input, with one line saying what is wrong.

#include "checker_io.h"
#include "checker_mesh_io.h"
#include "polyline_checker.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <system_error>
#include <vector>

namespace checker = polyline_checker;
using checker::Bad_input;

namespace {

struct Options
{
  std::string mesh, polylines, stats, csv, points, splines;
  std::vector<checker::Index> fixed;
  checker::Joint_options joints;
  checker::Tolerances tolerances;
  bool quiet = false;
};

void add_options(CLI::App& app, Options& options)
{
  app.add_option("mesh", options.mesh, "The mesh: OFF, OBJ, PLY or STL")->required();
  app.add_option("polylines", options.polylines, "Lines `curve a b t x y z` or `curve a b c t u x y z`")->required();
  app.add_option("--stats", options.stats, "The statistics of the program: status, ends and length are compared");
  app.add_option("--csv", options.csv, "Write the table to this file instead of standard output");
  app.add_option("--fixed", options.fixed, "Vertices at which curves may bend");
  app.add_option("--points", options.points,
                 "The file that the program got as --points: curves must pass through its points");
  app.add_option("--splines", options.splines,
                 "The file that the program got as --bezier: curves must have the ends of its splines")
      ->excludes("--points");
  app.add_flag("--fixed-bases", options.joints.bases_are_fixed, "Closed curves may bend where they begin and end");
  app.add_flag("--together", options.joints.curves_block_each_other,
               "The curves were shortened together: each may be blocked by the others, not only by itself");
  app.add_option("--tolerance", options.tolerances.angle, "The largest bend in radians that counts as straight")
      ->capture_default_str();
  app.add_flag("--quiet", options.quiet, "Do not print the summary on standard error");
}

std::ifstream open(const std::string& file)
{
  std::ifstream in(file);
  if(!in)
    throw Bad_input("it cannot be opened");
  return in;
}

// Calls `read` and puts the name of the file in front of what goes wrong.
template <class Read>
auto read_from(const std::string& file, const Read& read)
{
  try {
    return read();
  } catch(const std::exception& error) {
    throw Bad_input(file + ": " + error.what());
  }
}

std::map<long, checker::Verdict> check(Options& options)
{
  const auto mesh = read_from(options.mesh, [&] { return checker::read_mesh(options.mesh); });
  for(checker::Index v : options.fixed)
    options.joints.fixed_vertices.insert(mesh.merged(v));
  auto curves = read_from(options.polylines, [&] {
    std::ifstream in = open(options.polylines);
    return checker::read_polylines(in);
  });
  for(const std::string& asked : {options.points, options.splines})
    if(!asked.empty())
      read_from(asked, [&] {
        std::ifstream in = open(asked);
        checker::read_way_points(in, asked == options.splines, curves);
      });
  checker::Stats stats;
  if(!options.stats.empty())
    stats = read_from(options.stats, [&] {
      std::ifstream in = open(options.stats);
      return checker::read_stats(in);
    });
  checker::merge_vertices(mesh, curves, stats);
  return checker::judge_curves(mesh, curves, stats, options.joints, options.tolerances);
}

void write(const Options& options, const std::map<long, checker::Verdict>& verdicts)
{
  if(options.csv.empty()) {
    checker::write_verdicts(std::cout, verdicts);
    if(!std::cout.flush())
      throw Bad_input("standard output: it cannot be written");
    return;
  }
  for(const std::string& input : {options.mesh, options.polylines, options.stats, options.points, options.splines}) {
    std::error_code failure;
    if(std::filesystem::equivalent(options.csv, input, failure) && std::filesystem::is_regular_file(input))
      throw Bad_input(options.csv + ": it would replace an input file; specify another file");
  }
  std::ofstream out(options.csv);
  checker::write_verdicts(out, verdicts);
  if(!out.flush())
    throw Bad_input(options.csv + ": it cannot be written; choose another path");
}

// One line for all, and one for each of the first wrong curves.
void summarise(const std::map<long, checker::Verdict>& verdicts)
{
  std::size_t wrong = 0;
  long double bend = 0, angle = checker::infinite_angle;
  for(const auto& [id, verdict] : verdicts) {
    const checker::Curve_report& report = verdict.report;
    bend = (std::max)(bend, report.strip_bend);
    angle = (std::min)(angle, report.min_unblocked_angle);
    if(verdict.ok || ++wrong > 10)
      continue;
    std::cerr << "curve " << id
              << " is wrong: " << (report.broken > 0 ? report.first_break : std::string("see its row")) << '\n';
  }
  std::cerr << verdicts.size() << " curves, " << wrong << " wrong; largest bend at a crossing " << bend
            << ", smallest unblocked angle at a vertex pi + " << angle - checker::pi << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  CLI::App app("Checks that polylines on a triangle mesh are geodesic", "check_polylines");
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    const std::map<long, checker::Verdict> verdicts = check(options);
    write(options, verdicts);
    if(!options.quiet)
      summarise(verdicts);
    return std::all_of(verdicts.begin(), verdicts.end(), [](const auto& v) { return v.second.ok; }) ? 0 : 1;
  } catch(const std::exception& error) {
    std::cerr << "check_polylines: " << error.what() << '\n';
    return 2;
  }
}
