// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Pulls random curves tight on every mesh given, flips the rest of the triangulation to constrained Delaunay, takes the
// common subdivision with the mesh, inserts the curves into the mesh and cuts it open along them, refines, checks what
// comes out by counting and measuring, and writes a row of CSV for each of these. In the rows of `refine`, count is the
// vertices inserted, area_error the smallest angle of faces that are not exempt, and turned the faces that miss the
// bound. Times are processor time.
//
// Exit status: 0 if every check holds; 1 if not; 2 on bad usage.

#include "sample_curves.h"

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct Options
{
  std::vector<std::string> paths;
  std::string kernel = "certified";
  int curves = 4;
  unsigned seed = 1;
  std::size_t most_crossings = 5000000, most_insertions = 20000;
  double angle = 25;
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// The checks of one mesh, written as they are made.
class Rows
{
public:
  explicit Rows(const std::string& file)
    : m_file(file)
  {
  }

  static void write_header() { std::cout << "mesh,task,vertices,faces,count,seconds,area_error,turned,verdict,note\n"; }

  void write(const std::string& task, const Mesh& mesh, std::size_t count, double seconds, double area_error,
             std::size_t turned, const std::string& problem)
  {
    std::cout << m_file << ',' << task << ',' << mesh.number_of_vertices() << ',' << mesh.number_of_faces() << ','
              << count << ',' << seconds << ',' << area_error << ',' << turned << ','
              << (problem.empty() ? "ok" : "WRONG") << ",\"" << problem << "\"" << std::endl;
    m_wrong += problem.empty() ? 0 : 1;
  }

  void refuse(const std::string& why) { std::cout << m_file << ",refused,0,0,0,0,0,0,refused,\"" << why << "\"\n"; }

  int wrong() const { return m_wrong; }

private:
  std::string m_file;
  int m_wrong = 0;
};

int euler_characteristic(const Mesh& mesh)
{
  return static_cast<int>(mesh.number_of_vertices()) - static_cast<int>(mesh.number_of_edges()) +
         static_cast<int>(mesh.number_of_faces());
}

double area(const Mesh& mesh)
{
  double sum = 0;
  for(auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    sum += std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                        mesh.point(mesh.target(mesh.next(h)))));
  }
  return sum;
}

// Does each vertex have one fan of faces?
bool has_manifold_vertices(const Mesh& mesh)
{
  std::size_t reached = 0;
  for(auto v : mesh.vertices())
    if(mesh.halfedge(v) != Mesh::null_halfedge())
      for(auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh)) {
        static_cast<void>(h);
        ++reached;
      }
  return reached == mesh.number_of_halfedges();
}

template <class Traits>
class Task
{
  using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits>;
  using Network = FG::Edge_path_network<Triangulation>;
  using Subdivision = FG::Surface_subdivision<Triangulation, Mesh>;
  template <class T>
  using By_vertex = FG::internal::Indexed_by<FG::Vertex_index, std::vector<T>>;

public:
  Task(const Mesh& mesh, const Options& options, Rows& rows)
    : m_mesh(mesh)
    , m_options(options)
    , m_rows(rows)
    , m_triangulation(mesh)
    , m_network(m_triangulation)
    , m_area(area(mesh))
  {
  }

  void run()
  {
    sample::Source<Triangulation> source(m_triangulation, m_options.seed);
    if(source.is_empty())
      return m_rows.refuse("nothing to join");
    for(int i = 0; i < m_options.curves; ++i) { // those that cross the others are left out
      m_network.add_curve(source.path().chains.front());
      try {
        FG::order_overlapping_curves(m_network);
      } catch(const FG::Error&) {
        m_network.clear();
      }
    }
    FG::shorten(m_network);
    check_subdivision(
        "insert", [&] { return FG::insert_curves(m_network, m_mesh); }, occupied_edges(), 0);
    check_subdivision(
        "cut", [&] { return FG::cut_along_curves(m_network, m_mesh); }, occupied_edges(), change_by_cut());
    flip();
    std::size_t crossings = 0;
    for(FG::Edge_index e : edges(m_triangulation))
      crossings += static_cast<std::size_t>((std::max)(m_triangulation.crossings(e), 0));
    if(crossings <= m_options.most_crossings)
      check_subdivision(
          "subdivide", [&] { return FG::common_subdivision(m_triangulation, m_mesh); }, crossings, 0);
    check_subdivision(
        "insert_icdt", [&] { return FG::insert_curves(m_network, m_mesh); }, occupied_edges(), 0);
    if(m_options.angle > 0) {
      refine();
      check_subdivision(
          "cut_refined", [&] { return FG::cut_along_curves(m_network, m_mesh); }, occupied_edges(), change_by_cut());
    }
  }

private:
  std::size_t occupied_edges() const
  {
    std::size_t count = 0;
    for(FG::Edge_index e : edges(m_triangulation))
      count += m_network.is_occupied(e.halfedge()) ? 1 : 0;
    return count;
  }

  // Of Euler's characteristic: vertices are multiplied by their degree in the cut, on the border by one more.
  int change_by_cut() const
  {
    int result = 0;
    By_vertex<int> degree(num_vertices(m_triangulation), 0);
    for(FG::Edge_index e : edges(m_triangulation)) {
      const FG::Halfedge_index h = e.halfedge(), t = Triangulation::twin(h);
      if(!m_network.is_occupied(h) || m_triangulation.is_border(h) || m_triangulation.is_border(t))
        continue;
      --result;
      ++degree[m_triangulation.tail(h)];
      ++degree[m_triangulation.head(h)];
    }
    By_vertex<char> is_on_border(degree.size(), 0);
    for(FG::Halfedge_index h : halfedges(m_triangulation))
      if(m_triangulation.is_border(h))
        is_on_border[m_triangulation.tail(h)] = 1;
    for(FG::Vertex_index v : vertices(m_triangulation))
      result += (std::max)(degree[v] - (is_on_border[v] != 0 ? 0 : 1), 0);
    return result;
  }

  void flip()
  {
    const double start = processor_seconds();
    const FG::Delaunay_report report = FG::flip_to_delaunay(m_triangulation);
    const double seconds = processor_seconds() - start;
    const bool is_right = report.is_complete() && FG::is_delaunay(m_triangulation) && m_network.is_valid();
    m_rows.write("delaunay", m_mesh, report.flips, seconds, 0, report.constrained, is_right ? "" : "not Delaunay");
  }

  // The number of faces that miss the bound is told, and is no error: some meshes need more vertices than are allowed.
  void refine()
  {
    FG::Refinement_options bounds;
    bounds.smallest_angle = m_options.angle;
    bounds.maximum_insertions = m_options.most_insertions;
    const double length = length_of_curves(), start = processor_seconds();
    const FG::Refinement_report report = FG::refine(m_network, bounds);
    const double seconds = processor_seconds() - start;
    std::string problem;
    if(!FG::is_delaunay(m_triangulation) || !m_triangulation.is_valid() || !m_network.is_valid())
      problem = "not a valid Delaunay triangulation";
    else if(!(std::abs(length_of_curves() - length) <= 1e-9 * length))
      problem = "a curve has another length";
    m_rows.write("refine", m_mesh, report.insertions + report.splits, seconds, report.smallest_free_angle,
                 report.missed, problem);
  }

  double length_of_curves() const
  {
    double sum = 0;
    for(FG::Curve_index c : m_network.curves())
      sum += m_network.length(c);
    return sum;
  }

  template <class Make>
  void check_subdivision(const std::string& task, const Make& make, std::size_t count, int change)
  {
    const double start = processor_seconds();
    const Subdivision subdivision = make();
    const double seconds = processor_seconds() - start;
    const Mesh& mesh = subdivision.mesh();
    double measured = 0;
    std::size_t turned = 0;
    for(auto f : mesh.faces()) {
      measured += subdivision.area(f);
      turned += subdivision.area(f) < 0 ? 1 : 0;
    }
    const double error =
        m_area > 0 ? (std::max)(std::abs(measured - m_area), std::abs(area(mesh) - m_area)) / m_area : 0;
    std::string problem;
    if(!mesh.is_valid(false) || !CGAL::is_triangle_mesh(mesh))
      problem = "not a valid triangle mesh";
    else if(!has_manifold_vertices(mesh))
      problem = "a vertex with several fans";
    else if(euler_characteristic(mesh) != euler_characteristic(m_mesh) + change)
      problem = "wrong Euler characteristic";
    else if(!(error < 1e-9))
      problem = "wrong area";
    m_rows.write(task, mesh, count, seconds, error, turned, problem);
  }

  const Mesh& m_mesh;
  const Options& m_options;
  Rows& m_rows;
  Triangulation m_triangulation;
  Network m_network;
  double m_area;
};

int run(const std::string& file, const Options& options)
{
  Rows rows(file);
  try {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh))
      rows.refuse("not read as an oriented manifold triangle mesh");
    else if(options.kernel == "double")
      Task<FG::Intrinsic_triangulation_traits<Kernel>>(mesh, options, rows).run();
    else
      Task<FG::Certified_intrinsic_triangulation_traits<Kernel>>(mesh, options, rows).run();
  } catch(const FG::Error& error) {
    rows.refuse(error.what());
  }
  return rows.wrong();
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Delaunay triangulations, subdivisions and cuts of many meshes"};
  Options options;
  app.add_option("paths", options.paths, "Meshes, and folders of meshes")->required();
  app.add_option("--kernel", options.kernel, "certified or double")
      ->check(CLI::IsMember({"double", "certified"}))
      ->capture_default_str();
  app.add_option("--curves", options.curves, "Paths on each mesh; those that cross others are omitted")
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the random choices")->capture_default_str();
  app.add_option("--most-crossings", options.most_crossings, "Largest number of crossings of a common subdivision")
      ->capture_default_str();
  app.add_option("--angle", options.angle, "Refine to this smallest angle; 0 for no refinement")->capture_default_str();
  app.add_option("--most-insertions", options.most_insertions, "Largest number of vertices that refinement inserts")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  int wrong = 0;
  Rows::write_header();
  for(const std::string& file : sample::mesh_files(options.paths))
    wrong += run(file, options);
  std::cerr << wrong << " wrong\n";
  return wrong == 0 && std::cout.flush() ? 0 : 1;
}
