// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Has a referee, which computes with 300 digits and shares no code with the library, judge every decision that the
// certified traits take on the meshes given: paths, loops and networks are pulled tight and random edges flipped.
// Writes a row of CSV for each mesh.
//
// Exit status: 0 if the referee agrees with all, 1 if not, 2 on bad usage.

#include "../../test/Flip_geodesics/Referee.h"

#include "../../test/Flip_geodesics/Recording_traits.h"
#include "sample_curves.h"

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Flip_geodesics_test::Decision;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = Flip_geodesics_test::Recording_traits<Kernel>;
using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits>;
using Shape = Flip_geodesics_test::Shape_of_points<Mesh>;

struct Options
{
  std::vector<std::string> paths;
  std::size_t decisions = 10000;
  unsigned seed = 1;
  double seconds = 60;
};

struct Row
{
  std::size_t decisions = 0, filtered = 0, ties = 0, unproven_zeros = 0;
  std::size_t disagreements = 0, bent_edges = 0; // must be zero
  std::size_t unordered = 0;                     // degenerate faces leave the order of edges open
  std::string note;
};

struct Enough
{
};

class Judge
{
public:
  Judge(const Mesh& mesh, const Triangulation& triangulation, const Options& options, Row& row)
    : m_triangulation(triangulation)
    , m_referee(triangulation, Shape(mesh))
    , m_options(options)
    , m_row(row)
    , m_start(std::chrono::steady_clock::now())
  {
  }

  void operator()(const Decision& decision)
  {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - m_start;
    if(m_row.decisions >= m_options.decisions || time.count() > m_options.seconds)
      throw Enough();
    ++m_row.decisions;
    m_row.filtered += decision.is_filtered ? 1 : 0;
    for(FG::Halfedge_index h : {decision.from, decision.to})
      m_row.bent_edges += m_referee.is_straight(m_triangulation.edge_sequence(h)) ? 0 : 1;
    try {
      const int comparison = m_referee.compare_wedge(decision.from, decision.to);
      m_row.ties += comparison == 0 ? 1 : 0;
      m_row.disagreements += comparison == decision.result ? 0 : 1;
    } catch(const Flip_geodesics_test::No_order&) {
      ++m_row.unordered;
    }
  }

private:
  const Triangulation& m_triangulation;
  Flip_geodesics_test::Referee<Triangulation, Shape> m_referee;
  const Options& m_options;
  Row& m_row;
  std::chrono::steady_clock::time_point m_start;
};

void flip_at_random(Triangulation& triangulation, sample::Source<Triangulation>& source)
{
  const int middle = source.below(triangulation.number_of_halfedges());
  for(int i = 0; i < 100; ++i) {
    // Near each other, so that flips build on flips.
    const FG::Halfedge_index h((middle + source.below(60)) % triangulation.number_of_halfedges());
    if(triangulation.is_flippable(h))
      triangulation.flip(h);
  }
}

void work(Triangulation& triangulation, sample::Source<Triangulation>& source)
{
  FG::Edge_path_network<Triangulation> network(triangulation);
  const std::vector<std::function<sample::Curves()>> kinds = {
      [&] { return source.path(); }, [&] { return source.disk_boundary(3 + source.below(60)); },
      [&] { return source.round_trip(); }, [&] { return source.network(4); }};
  for(const auto& make : kinds) {
    if(sample::add(network, make())) {
      FG::shorten(network);
      FG::certify(network);
    }
    network.clear();
    triangulation.rollback();
  }
  flip_at_random(triangulation, source);
  triangulation.rollback();
}

void judge(const std::string& file, const Options& options, Row& row)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    row.note = "not read as an oriented manifold triangle mesh";
    return;
  }
  Flip_geodesics_test::Decision_observer observer;
  Triangulation triangulation(mesh, Traits(observer));
  sample::Source<Triangulation> source(triangulation, options.seed);
  if(source.is_empty())
    return;
  Judge judge(mesh, triangulation, options, row);
  observer.on_decision = std::ref(judge);
  const int most_rounds = 1000, most_errors = 20;
  int errors = 0;
  for(int i = 0; i < most_rounds && errors < most_errors; ++i) {
    try {
      work(triangulation, source);
    } catch(const Enough&) {
      break;
    } catch(const FG::Error& error) {
      ++errors;
      row.note = error.what();
      triangulation.rollback();
    }
  }
  row.unproven_zeros = triangulation.decision_statistics().unproven_zeros;
}

void write(const std::string& name, const Row& row)
{
  std::cout << name << ',' << row.decisions << ',' << row.filtered << ',' << row.ties << ',' << row.unproven_zeros
            << ',' << row.disagreements << ',' << row.bent_edges << ',' << row.unordered << ",\"" << row.note << "\""
            << std::endl;
}

void add(Row& total, const Row& row)
{
  total.decisions += row.decisions;
  total.filtered += row.filtered;
  total.ties += row.ties;
  total.unproven_zeros += row.unproven_zeros;
  total.disagreements += row.disagreements;
  total.bent_edges += row.bent_edges;
  total.unordered += row.unordered;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Compares predicates of the certified traits with a reference implementation"};
  Options options;
  app.add_option("paths", options.paths, "Meshes, and folders of meshes")->required();
  app.add_option("--decisions", options.decisions, "Predicates to check on each mesh")->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the random choices")->capture_default_str();
  app.add_option("--seconds", options.seconds, "Time limit per mesh in seconds")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  Row total;
  std::cout << "mesh,decisions,filtered,ties,unproven_zeros,disagreements,bent_edges,unordered,note\n";
  for(const std::string& file : sample::mesh_files(options.paths)) {
    Row row;
    try {
      judge(file, options, row);
    } catch(const std::exception& error) {
      row.note = error.what();
    }
    write(file, row);
    add(total, row);
  }
  write("total", total);
  return total.disagreements == 0 && total.bent_edges == 0 && std::cout.flush() ? 0 : 1;
}
