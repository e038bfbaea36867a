// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The cost of exact predicates: whole queries, from nothing to the points of a path, with certified and with plain
// traits in turn, on meshes that are given or, if none is, on generated ones that are full of ties. Writes CSV, a row
// for each mesh: the times of a query, the median of their ratio over the rounds, and how often each stage has decided.
// A summary goes to the standard error: the ratio in the median, in nine meshes of ten, at most, and the meshes above a
// limit.
//
//   certified_queries [MESHES OR FOLDERS...] [--pairs N] [--rounds N] [--limit RATIO]
//
// Or paths between vertices and between places in faces, loops and networks, as the functions of one call make them: on
// 203 generated meshes of every kind, or on those given. A row says how many curves there are, how many of them are
// proven, and how long the slowest call took.
//
//   certified_queries --every-kind [MESHES OR FOLDERS...]
//
// Exit status: 0, or 1 if a mesh is above the limit or a curve not proven, 2 on bad usage.

#include "../../test/Flip_geodesics/generated_meshes.h"
#include "meshes_of_every_kind.h"
#include "processor_time.h"
#include "sample_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/straightened_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Plain = FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<Kernel>>;
using Certified = FG::Intrinsic_triangulation<Mesh, FG::Certified_intrinsic_triangulation_traits<Kernel>>;
using Ends = std::array<FG::Vertex_index, 2>;

struct Options
{
  std::vector<std::string> paths;
  int pairs = 10, rounds = 5;
  double limit = 5, seconds = 20;
  bool is_every_kind = false;
};

struct Row
{
  std::string mesh;
  std::size_t faces = 0, flips = 0;
  double plain = 0, certified = 0, ratio = 0; // seconds of a query
  FG::Decision_statistics decisions;
};

// All that `geodesic_path()` does.
template <class Triangulation>
void query(const Mesh& mesh, const Ends& ends, std::size_t& flips, FG::Decision_statistics& decisions)
{
  Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation,
                                               CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
  FG::Edge_path_network<Triangulation> network(triangulation);
  flips += FG::add_straightened_path(network, search(ends[0], ends[1]));
  flips += FG::shorten(network).flips;
  std::vector<Kernel::Point_3> points;
  FG::Curve_extractor<FG::Edge_path_network<Triangulation>>(network).points(FG::Curve_index(0),
                                                                            std::back_inserter(points));
  const FG::Decision_statistics& d = triangulation.decision_statistics();
  decisions.by_memory += d.by_memory;
  decisions.by_strip += d.by_strip;
  decisions.by_plane += d.by_plane;
  decisions.by_precision += d.by_precision;
  decisions.by_roots += d.by_roots;
  decisions.zeros_by_plane += d.zeros_by_plane;
  decisions.zeros_by_roots += d.zeros_by_roots;
  decisions.unproven_zeros += d.unproven_zeros;
  decisions.most_roots = (std::max)(decisions.most_roots, d.most_roots);
}

template <class Triangulation>
double round_of_queries(const Mesh& mesh, const std::vector<Ends>& pairs, std::size_t& flips,
                        FG::Decision_statistics& decisions)
{
  flips = 0;
  decisions = {};
  return seconds([&] {
           for(const Ends& ends : pairs)
             query<Triangulation>(mesh, ends, flips, decisions);
         }) /
         static_cast<double>(pairs.size());
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

Row measured(const std::string& name, const Mesh& mesh, const Options& options)
{
  Row row;
  row.mesh = name;
  row.faces = mesh.number_of_faces();
  const Plain triangulation(mesh);
  sample::Source<Plain> source(triangulation, 1);
  std::vector<Ends> pairs;
  for(int i = 0; i < options.pairs; ++i)
    pairs.push_back(source.connected_pair());
  std::vector<double> plain, certified, ratios;
  std::size_t plain_flips;
  FG::Decision_statistics none;
  const double start = processor_seconds();
  // The first round warms the caches.
  for(int i = 0; i <= options.rounds && (i < 2 || processor_seconds() < start + options.seconds); ++i) {
    const double a = round_of_queries<Plain>(mesh, pairs, plain_flips, none);
    const double b = round_of_queries<Certified>(mesh, pairs, row.flips, row.decisions);
    if(i == 0)
      continue;
    plain.push_back(a);
    certified.push_back(b);
    ratios.push_back(b / a);
  }
  row.plain = median(plain);
  row.certified = median(certified);
  row.ratio = median(ratios);
  return row;
}

std::vector<std::pair<std::string, Mesh_soup>> generated_meshes()
{
  const auto turned = [](const Coordinates& p) {
    return Coordinates{0.36 * p[0] + 0.48 * p[1] - 0.8 * p[2], -0.8 * p[0] + 0.6 * p[1],
                       0.48 * p[0] + 0.64 * p[1] + 0.6 * p[2]};
  };
  return {{"grid", flat_grid(64, 64, Diagonal_rule::RANDOM)},
          {"cube", cube(32)},
          {"turned cube", mapped(cube(32), turned)},
          {"cube of thirds", scaled(cube(32), 1.0 / 3)},
          {"plate with holes", genus_3_plate(8)},
          {"octahedron", octahedron(48)},
          {"prism of 7 sides", cylinder(7, 200, 1, 50)},
          {"prism of 64 sides", cylinder(64, 64, 1, 16)},
          {"cone", cone(64, 32, 1, 1)},
          {"high cone", cone(64, 32, 1, 1e6)},
          {"stretched grid", needle_strip(60, 60, 0x1p26)},
          {"lantern", lantern(32, 64)},
          {"high lantern", lantern(6, 2000)}};
}

// ---------------------------------------------------------------- meshes of every kind

// All kinds of curves on one mesh, each by a call of its own.
class Proven_curves
{
public:
  Proven_curves(const std::string& name, const Mesh& mesh)
    : m_name(name)
    , m_mesh(mesh)
    , m_triangulation(mesh)
    , m_random(static_cast<unsigned>(mesh.number_of_faces()))
  {
  }

  /* Returns whether all are proven. */
  bool run()
  {
    for(int i = 0; i < 6; ++i)
      path();
    for(int i = 0; i < 2; ++i) {
      path_between_places();
      loop();
    }
    network();
    std::cout << m_name << ',' << m_mesh.number_of_faces() << ',' << m_curves << ',' << m_proven << ',' << m_contracted
              << ',' << 1e3 * m_slowest << std::endl;
    return m_proven == m_curves;
  }

private:
  using Vertex = Mesh::Vertex_index;
  using Points = std::vector<Kernel::Point_3>;

  int below(std::size_t n) { return m_random.below(static_cast<int>(n)); }
  Vertex vertex() { return Vertex(static_cast<Mesh::size_type>(below(m_mesh.number_of_vertices()))); }

  Vertex other_vertex(Vertex v)
  {
    Vertex result = vertex();
    while(result == v)
      result = vertex();
    return result;
  }

  void path()
  {
    const Vertex v = vertex(), w = other_vertex(v);
    call("path", [&] {
      Points points;
      return FG::geodesic_path(m_mesh, v, w, std::back_inserter(points)).report;
    });
  }

  FG::Surface_location place()
  {
    FG::Input_halfedge_index h;
    do
      h = FG::Input_halfedge_index(below(m_mesh.number_of_halfedges()));
    while(m_triangulation.input().is_border(h));
    return {h, {{m_random.uniform(0.1, 1), m_random.uniform(0.1, 1), m_random.uniform(0.1, 1)}}};
  }

  void path_between_places()
  {
    const std::vector<FG::Surface_location> places = {place(), place()};
    call("path between places", [&] {
      Points points;
      return FG::geodesic_path_through(m_mesh, places, std::back_inserter(points)).report;
    });
  }

  // Around a vertex.
  void loop()
  {
    for(int i = 0; i < 100; ++i) {
      std::vector<Vertex> ring;
      bool is_closed = true;
      for(Mesh::Halfedge_index h : CGAL::halfedges_around_target(vertex(), m_mesh)) {
        is_closed = is_closed && !m_mesh.is_border(h) && !m_mesh.is_border(m_mesh.opposite(h));
        ring.push_back(m_mesh.source(h));
      }
      if(is_closed)
        return call("loop", [&] {
          Points points;
          return FG::geodesic_loop(m_mesh, ring, std::back_inserter(points)).report;
        });
    }
  }

  // Of shortest paths along edges from one vertex, which do not cross.
  void network()
  {
    const Vertex source = vertex();
    const std::vector<Vertex> targets = {other_vertex(source), other_vertex(source), other_vertex(source)};
    call("network", [&] {
      FG::Shortest_edge_path<Certified> search(m_triangulation,
                                               CGAL::parameters::search_method(FG::Search_method::DIJKSTRA));
      std::vector<std::vector<Vertex>> curves;
      for(Vertex target : targets) {
        curves.emplace_back(1, source);
        for(FG::Halfedge_index h : search(m_triangulation.index(source), m_triangulation.index(target)))
          curves.back().push_back(m_mesh.target(Mesh::Halfedge_index(static_cast<Mesh::size_type>(h.idx()))));
      }
      std::vector<Points> points;
      return FG::geodesic_network(m_mesh, curves, std::back_inserter(points)).report;
    });
  }

  template <class Function>
  void call(const char* what, const Function& function)
  {
    FG::Shortening_report report;
    const double time = seconds([&] {
      try {
        report = function();
      } catch(const FG::Disconnected_endpoints_error&) { // there is no curve
      } catch(const FG::Error& error) {
        std::cerr << m_name << ", " << what << ": " << error.what() << '\n';
        ++m_curves;
      }
    });
    m_slowest = (std::max)(m_slowest, time);
    for(const FG::Curve_report& curve : report.curves) {
      const bool is_proven = curve.verdict == FG::Verdict::PROVEN && report.is_complete();
      ++m_curves;
      m_proven += is_proven ? 1 : 0;
      m_contracted += curve.are_zero_edges_contracted ? 1 : 0;
      if(!is_proven)
        std::cerr << m_name << ", " << what << ": " << FG::to_string(curve.status) << ", "
                  << FG::to_string(curve.verdict) << '\n';
    }
  }

  std::string m_name;
  const Mesh& m_mesh;
  Certified m_triangulation;
  Random_numbers m_random;
  int m_curves = 0, m_proven = 0, m_contracted = 0;
  double m_slowest = 0;
};

// Calls a function with the name of each mesh and the mesh; files that are none are named.
template <class Function>
void for_each_file(const std::vector<std::string>& paths, const Function& function)
{
  for(const std::string& file : sample::mesh_files(paths)) {
    Mesh mesh;
    if(CGAL::IO::read_polygon_mesh(file, mesh) && !mesh.is_empty() && CGAL::is_triangle_mesh(mesh))
      function(file.substr(file.find_last_of('/') + 1), mesh);
    else
      std::cerr << file << ": is not a triangle mesh\n";
  }
}

bool are_all_proven(const std::vector<std::string>& paths)
{
  bool result = true;
  std::cout << "mesh,faces,curves,proven,contracted,slowest_ms\n";
  const auto run = [&](const std::string& name, const Mesh& mesh) {
    try {
      result = Proven_curves(name, mesh).run() && result;
    } catch(const std::exception& error) {
      std::cerr << name << ": " << error.what() << '\n';
      result = false;
    }
  };
  if(paths.empty())
    for(const auto& [name, make] : meshes_of_every_kind::meshes())
      run(name, to_mesh<Mesh>(make()));
  for_each_file(paths, run);
  return result;
}

// ---------------------------------------------------------------- rows

void write_header()
{
  std::cout << "mesh,faces,plain_ms,certified_ms,ratio,flips,by_memory,by_strip,by_plane,zeros_by_plane,by_roots,"
               "zeros_by_roots,by_precision,unproven_zeros,most_roots\n";
}

void write(const Row& row)
{
  const FG::Decision_statistics& d = row.decisions;
  std::cout << row.mesh << ',' << row.faces << ',' << 1e3 * row.plain << ',' << 1e3 * row.certified << ',' << row.ratio
            << ',' << row.flips << ',' << d.by_memory << ',' << d.by_strip << ',' << d.by_plane << ','
            << d.zeros_by_plane << ',' << d.by_roots << ',' << d.zeros_by_roots << ',' << d.by_precision << ','
            << d.unproven_zeros << ',' << d.most_roots << std::endl;
}

bool summarize(std::vector<Row> rows, double limit)
{
  if(rows.empty())
    return true;
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.ratio < b.ratio; });
  std::cerr << rows.size() << " meshes; certified over plain: median " << rows[rows.size() / 2].ratio
            << ", 90th percentile " << rows[rows.size() * 9 / 10].ratio << ", maximum " << rows.back().ratio << '\n';
  for(const Row& row : rows)
    if(row.ratio > limit)
      std::cerr << "above " << limit << ": " << row.mesh << ", " << row.ratio << '\n';
  return rows.back().ratio <= limit;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Measures the cost of exact predicates"};
  Options options;
  app.add_option("paths", options.paths, "Meshes, and folders of meshes; generated ones if none is given");
  app.add_option("--pairs", options.pairs, "Paths on each mesh")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--rounds", options.rounds, "Number of rounds")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--limit", options.limit, "Name the meshes with a larger ratio")->capture_default_str();
  app.add_option("--seconds", options.seconds, "Seconds for each mesh, after the first two rounds")
      ->capture_default_str();
  app.add_flag("--every-kind", options.is_every_kind,
               "Compute all kinds of curves, on meshes of every kind if none is given");
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  if(options.is_every_kind)
    return are_all_proven(options.paths) && std::cout.flush() ? 0 : 1;
  std::vector<Row> rows;
  write_header();
  const auto measure = [&](const std::string& name, const Mesh& mesh) {
    try {
      rows.push_back(measured(name, mesh, options));
      write(rows.back());
    } catch(const std::exception& error) {
      std::cerr << name << ": " << error.what() << '\n';
    }
  };
  if(options.paths.empty())
    for(const auto& [name, soup] : generated_meshes())
      measure(name, to_mesh<Mesh>(soup));
  for_each_file(options.paths, measure);
  return summarize(rows, options.limit) && std::cout.flush() ? 0 : 1;
}
