// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Checks the curves that flip_geodesics wrote with --polylines: see polyline_checker.h for what is checked, and how.
// Shares no code with the library. The mesh is read by the same reader as there, so that vertices have the same
// numbers.
//
// Exit status: 0 if all curves are what they should be, 1 if not, 2 on bad input, with one line saying what is wrong.

#include "checker_io.h"
#include "polyline_checker.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace checker = polyline_checker;
using checker::Bad_input;

namespace {

struct Options
{
  std::string mesh, polylines, stats, csv;
  std::vector<checker::Index> fixed;
  checker::Joint_options joints;
  checker::Tolerances tolerances;
  bool quiet = false;
};

void add_options(CLI::App& app, Options& options)
{
  app.add_option("mesh", options.mesh, "The mesh: OFF, OBJ, PLY or STL")->required();
  app.add_option("polylines", options.polylines, "Lines `curve a b t x y z`")->required();
  app.add_option("--stats", options.stats, "What the program says of the curves: status, ends and length are compared");
  app.add_option("--csv", options.csv, "Write the table here and not to standard output");
  app.add_option("--fixed", options.fixed, "Vertices at which curves may bend");
  app.add_flag("--fixed-bases", options.joints.bases_are_fixed, "Closed curves may bend where they begin and end");
  app.add_flag("--together", options.joints.curves_block_each_other,
               "The curves were shortened together: each may be held up by any other, and not by itself only");
  app.add_option("--tolerance", options.tolerances.angle, "The angle in radians that counts as straight")
      ->capture_default_str();
  app.add_flag("--quiet", options.quiet, "No summary on standard error");
}

// The vertices and faces of an OBJ file, whatever else is in it; `v/t/n` and indices from the end are understood.
checker::Mesh read_obj(const std::string& file)
{
  std::ifstream in(file);
  std::vector<checker::Mesh::Point> points;
  std::vector<checker::Mesh::Face> faces;
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if(keyword == "v") {
      points.emplace_back();
      words >> points.back()[0] >> points.back()[1] >> points.back()[2];
    } else if(keyword == "f") {
      std::vector<checker::Index> corners;
      for(std::string corner; words >> corner;) {
        const long long i = std::stoll(corner);
        corners.push_back(static_cast<checker::Index>(i < 0 ? static_cast<long long>(points.size()) + i : i - 1));
      }
      if(corners.size() != 3)
        throw Bad_input("face " + std::to_string(faces.size()) + " is not a triangle");
      faces.push_back({corners[0], corners[1], corners[2]});
    }
  }
  if(faces.empty())
    throw Bad_input("it cannot be read, or has no faces");
  return checker::Mesh(std::move(points), faces);
}

checker::Mesh read_mesh(const std::string& file)
{
  if(file.size() > 4 && file.compare(file.size() - 4, 4, ".obj") == 0)
    return read_obj(file);
  using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Surface_mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.number_of_faces() == 0)
    throw Bad_input("it cannot be read as an oriented manifold mesh, or has no faces");
  std::vector<checker::Mesh::Point> points;
  for(const auto v : mesh.vertices())
    points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  std::vector<checker::Mesh::Face> faces;
  for(const auto f : mesh.faces()) {
    if(mesh.degree(f) != 3)
      throw Bad_input("face " + std::to_string(std::size_t(f)) + " is not a triangle");
    const auto h = mesh.halfedge(f);
    faces.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
  }
  return checker::Mesh(std::move(points), faces);
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
  options.joints.fixed_vertices.insert(options.fixed.begin(), options.fixed.end());
  const auto mesh = read_from(options.mesh, [&] { return read_mesh(options.mesh); });
  const auto curves = read_from(options.polylines, [&] {
    std::ifstream in = open(options.polylines);
    return checker::read_polylines(in);
  });
  checker::Stats stats;
  if(!options.stats.empty())
    stats = read_from(options.stats, [&] {
      std::ifstream in = open(options.stats);
      return checker::read_stats(in);
    });
  return checker::judge_curves(mesh, curves, stats, options.joints, options.tolerances);
}

void write(const Options& options, const std::map<long, checker::Verdict>& verdicts)
{
  if(options.csv.empty()) {
    checker::write_verdicts(std::cout, verdicts);
    return;
  }
  std::ofstream out(options.csv);
  checker::write_verdicts(out, verdicts);
  if(!out.flush())
    throw Bad_input(options.csv + ": it cannot be written");
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
