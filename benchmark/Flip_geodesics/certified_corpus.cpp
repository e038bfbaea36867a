// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Pulls random paths, loops and networks tight on every mesh given, by the plain and by the certified traits in turn,
// certifies the results of both, and writes a row of CSV for each mesh. Times are processor time.
//
// Exit status: 0 if every curve of the certified traits is certified, or has a status that says why not; 1 if not; 2 on
// bad usage.

#include "sample_curves.h"

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstddef>
#include <ctime>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Clock = std::chrono::steady_clock;

struct Options
{
  std::vector<std::string> paths;
  int pairs = 10, loops = 5, networks = 3;
  unsigned seed = 1;
  double seconds = 60;
};

// Processor time, so that other programs do not disturb.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Deadline_visitor : FG::Default_shortening_visitor
{
  explicit Deadline_visitor(Clock::time_point end)
    : end(end)
  {
  }
  bool go_further() { return Clock::now() < end; }

  Clock::time_point end;
};

// What came out of one kind of traits.
struct Tally
{
  std::map<std::string, int> statuses, verdicts;
  int uncertified = 0; // locally shortest by its status, bent by its certificate
  std::size_t flips = 0, zero_decisions = 0;
  double shorten = 0, certify = 0;
};

template <class Triangulation>
class Contestant
{
public:
  explicit Contestant(const Mesh& mesh)
    : triangulation(mesh)
    , m_network(triangulation)
  {
  }

  void run(const sample::Curves& curves, Clock::time_point deadline, Tally& tally)
  {
    m_network.clear();
    triangulation.rollback();
    if(!sample::add(m_network, curves))
      return;
    Deadline_visitor visitor(deadline);
    double start = processor_seconds();
    const FG::Shortening_report report = FG::shorten(m_network, CGAL::parameters::visitor(std::ref(visitor)));
    tally.shorten += processor_seconds() - start;
    tally.flips += report.flips;
    start = processor_seconds();
    const FG::Network_certificate certificate = FG::certify(m_network);
    tally.certify += processor_seconds() - start;
    for(std::size_t c = 0; c < report.curves.size(); ++c) {
      const FG::Shortening_status status = report.curves[c].status;
      ++tally.statuses[FG::to_string(status)];
      ++tally.verdicts[FG::to_string(certificate.curves[c].verdict())];
      const bool claims = status == FG::Shortening_status::LOCALLY_SHORTEST;
      tally.uncertified += claims && !certificate.curves[c].is_locally_shortest() ? 1 : 0;
    }
  }

  Triangulation triangulation;

private:
  FG::Edge_path_network<Triangulation> m_network;
};

using Plain = FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<Kernel>>;
using Certified = FG::Intrinsic_triangulation<Mesh>;

struct Row
{
  std::size_t vertices = 0, faces = 0;
  int curves = 0, rejected = 0;
  double search = 0;
  Tally plain, certified;
  FG::Decision_statistics decisions;
  std::string note;
};

class Race
{
public:
  Race(const Mesh& mesh, const Options& options, Row& row)
    : m_options(options)
    , m_row(row)
    , m_start(Clock::now())
    , m_deadline(m_start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.seconds)))
    , m_plain(mesh)
    , m_certified(mesh)
    , m_source(m_plain.triangulation, options.seed)
  {
  }

  void run()
  {
    if(m_source.is_empty()) {
      m_row.note = "nothing to join";
      return;
    }
    for(int i = 0; i < m_options.pairs; ++i)
      compete([&] { return m_source.path(); });
    for(int i = 0; i < m_options.loops; ++i)
      compete([&] { return i % 2 == 0 ? m_source.disk_boundary(3 + m_source.below(60)) : m_source.round_trip(); });
    for(int i = 0; i < m_options.networks; ++i)
      compete([&] { return m_source.network(4); });
    m_row.decisions = m_certified.triangulation.decision_statistics();
  }

private:
  template <class MakeCurves>
  void compete(const MakeCurves& make_curves)
  {
    if(Clock::now() >= m_deadline) {
      m_row.note = "time limit";
      return;
    }
    try {
      const double start = processor_seconds();
      const sample::Curves curves = make_curves();
      m_row.search += processor_seconds() - start;
      if(curves.chains.empty())
        return;
      // Whoever goes first warms the cache for the other.
      m_is_plain_first = !m_is_plain_first;
      if(m_is_plain_first)
        m_plain.run(curves, m_deadline, m_row.plain);
      m_certified.run(curves, m_deadline, m_row.certified);
      if(!m_is_plain_first)
        m_plain.run(curves, m_deadline, m_row.plain);
      m_row.curves += static_cast<int>(curves.chains.size());
    } catch(const FG::Error& error) {
      ++m_row.rejected;
      m_row.note = error.what();
    }
  }

  const Options& m_options;
  Row& m_row;
  Clock::time_point m_start, m_deadline;
  Contestant<Plain> m_plain;
  Contestant<Certified> m_certified;
  sample::Source<Plain> m_source;
  bool m_is_plain_first = false;
};

void race(const std::string& file, const Options& options, Row& row)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    row.note = "not read as an oriented manifold mesh";
    return;
  }
  row.vertices = mesh.number_of_vertices();
  row.faces = mesh.number_of_faces();
  if(!CGAL::is_triangle_mesh(mesh)) {
    row.note = "not triangulated";
    return;
  }
  Race(mesh, options, row).run();
}

const std::vector<std::string> statuses = {"LOCALLY_SHORTEST", "CONTRACTED", "STOPPED_BY_VISITOR", "PRECISION_LIMIT",
                                           "DEGENERATE_FACES"};
const std::vector<std::string> verdicts = {"PROVEN", "PROBABLE", "BENT_SEGMENT", "BENT_JOINT"};

void write_header()
{
  std::cout << "mesh,vertices,faces,curves,rejected,search_s";
  for(const char* who : {"plain", "certified"}) {
    for(const auto* names : {&statuses, &verdicts})
      for(const std::string& name : *names)
        std::cout << ',' << who << '_' << name;
    std::cout << ',' << who << "_uncertified," << who << "_flips," << who << "_shorten_s," << who << "_certify_s";
  }
  std::cout
      << ",by_strip,by_plane,zeros_by_plane,by_precision,unproven_zeros,by_roots,zeros_by_roots,most_roots,note\n";
}

void write(const Tally& tally)
{
  const auto count = [](const std::map<std::string, int>& counts, const std::string& name) {
    const auto found = counts.find(name);
    return found == counts.end() ? 0 : found->second;
  };
  for(const std::string& name : statuses)
    std::cout << ',' << count(tally.statuses, name);
  for(const std::string& name : verdicts)
    std::cout << ',' << count(tally.verdicts, name);
  std::cout << ',' << tally.uncertified << ',' << tally.flips << ',' << tally.shorten << ',' << tally.certify;
}

void write(const std::string& file, const Row& row)
{
  std::cout << file << ',' << row.vertices << ',' << row.faces << ',' << row.curves << ',' << row.rejected << ','
            << row.search;
  write(row.plain);
  write(row.certified);
  const FG::Decision_statistics& d = row.decisions;
  std::cout << ',' << d.by_strip << ',' << d.by_plane << ',' << d.zeros_by_plane << ',' << d.by_precision << ','
            << d.unproven_zeros << ',' << d.by_roots << ',' << d.zeros_by_roots << ',' << d.most_roots << ",\""
            << row.note << "\"" << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Certified curves on many meshes"};
  Options options;
  app.add_option("paths", options.paths, "Meshes, and folders of meshes")->required();
  app.add_option("--pairs", options.pairs, "Paths on each mesh")->capture_default_str();
  app.add_option("--loops", options.loops, "Loops on each mesh")->capture_default_str();
  app.add_option("--networks", options.networks, "Networks of four paths on each mesh")->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the random choices")->capture_default_str();
  app.add_option("--seconds", options.seconds, "Time limit per mesh in seconds")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  int curves = 0, uncertified = 0;
  write_header();
  for(const std::string& file : sample::mesh_files(options.paths)) {
    Row row;
    try {
      race(file, options, row);
    } catch(const std::exception& error) {
      row.note = error.what();
    }
    write(file, row);
    curves += row.curves;
    uncertified += row.certified.uncertified;
  }
  std::cerr << curves << " curves, " << uncertified << " uncertified\n";
  return uncertified == 0 && std::cout.flush() ? 0 : 1;
}
