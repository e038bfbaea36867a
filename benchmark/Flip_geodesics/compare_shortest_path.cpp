// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Compares geodesics with the shortest paths of CGAL::Surface_mesh_shortest_path between random vertices, and writes a
// row of CSV for each mesh. FlipOut starts twice: from the shortest edge path, whence it reaches a locally shortest
// path that may be longer than the shortest; and from the vertices on either side of the faces that the shortest path
// crosses. In the strip of these faces, the shortest path is what they tighten to; but FlipOut may shorten them to the
// outside first, and then find another path.
//
// Exit status: 0, 1 if a path is shorter than the shortest by more than rounding, 2 on bad usage.

#include "sample_curves.h"

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <exception>
#include <iostream>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Shortest_path = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;
using Triangulation = FG::Intrinsic_triangulation<Mesh, FG::Certified_intrinsic_triangulation_traits<Kernel>>;
using Network = FG::Edge_path_network<Triangulation>;
using Search = FG::Shortest_edge_path<Triangulation>;

constexpr double tolerance = 1e-9; // relative, of lengths that are to be equal
constexpr FG::Curve_index only_curve(0);

struct Options
{
  std::vector<std::string> files;
  int sources = 10, targets = 10;
  unsigned seed = 1;
  double seconds = 300;
};

struct Row
{
  int pairs = 0, uncertified = 0;
  int shorter = 0, equal = 0; // than the shortest path, and to it
  double largest_excess = 0, mean_excess = 0, largest_deficit = 0;
  int strips = 0;                                     // that could be followed
  int from_left = 0, from_right = 0, from_either = 0; // the shortest path itself was reached
  double shortest_path_time = 0, flip_time = 0;
  std::string note;
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// What a path passes: vertices, and the edges that it crosses between them.
struct Station
{
  bool is_vertex;
  FG::Index index;

  bool operator==(const Station& other) const { return is_vertex == other.is_vertex && index == other.index; }
};
using Stations = std::vector<Station>;

struct Station_visitor
{
  void operator()(Mesh::Halfedge_index h, double) { stations.push_back({false, static_cast<FG::Index>(h / 2)}); }
  void operator()(Mesh::Vertex_index v) { stations.push_back({true, static_cast<FG::Index>(v)}); }
  template <class Coordinates>
  void operator()(Mesh::Face_index, const Coordinates&)
  {
  }

  Stations stations; // from the target to the source
};

// The edge path along the vertices on the left of the faces that a path crosses.
class Left_side
{
public:
  explicit Left_side(const Mesh& mesh)
    : m_mesh(mesh)
  {
  }

  std::optional<sample::Chain> operator()(const Stations& stations)
  {
    m_chain.clear();
    for(std::size_t i = 0; i + 1 < stations.size();) {
      std::size_t end = i + 1;
      while(end < stations.size() && !stations[end].is_vertex)
        ++end;
      if(end == stations.size() || !follow(stations, i, end))
        return std::nullopt;
      i = end;
    }
    return m_chain;
  }

private:
  using Halfedge = Mesh::Halfedge_index;

  bool follow(const Stations& stations, std::size_t begin, std::size_t end)
  {
    const Mesh::Vertex_index from(stations[begin].index), to(stations[end].index);
    if(end == begin + 1) {
      const Halfedge h = m_mesh.halfedge(from, to);
      if(h == Mesh::null_halfedge())
        return false;
      add(h);
      return true;
    }
    // The side that is left, from the vertex on the right to that on the left.
    Halfedge crossed = m_mesh.halfedge(Mesh::Edge_index(stations[begin + 1].index));
    if(apex(crossed) != from)
      crossed = m_mesh.opposite(crossed);
    if(apex(crossed) != from)
      return false;
    add(m_mesh.opposite(m_mesh.next(crossed)));
    for(std::size_t i = begin + 2;; ++i) {
      const Halfedge entered = m_mesh.opposite(crossed);
      if(m_mesh.is_border(entered))
        return false;
      const Halfedge right = m_mesh.next(entered), left = m_mesh.prev(entered);
      if(i == end) {
        add(m_mesh.opposite(left));
        return m_mesh.source(left) == to;
      }
      const Mesh::Edge_index edge(stations[i].index);
      if(m_mesh.edge(right) == edge)
        add(m_mesh.opposite(left));
      else if(m_mesh.edge(left) != edge)
        return false;
      crossed = m_mesh.edge(right) == edge ? right : left;
    }
  }

  void add(Halfedge h) { m_chain.emplace_back(static_cast<FG::Index>(h)); }

  Mesh::Vertex_index apex(Halfedge h) const
  {
    return m_mesh.is_border(h) ? Mesh::null_vertex() : m_mesh.target(m_mesh.next(h));
  }

  const Mesh& m_mesh;
  sample::Chain m_chain;
};

Stations stations_of(const Network& network)
{
  const Triangulation& triangulation = network.triangulation();
  Stations result;
  network.for_each_segment(only_curve, [&](FG::Segment_index s) {
    const FG::Halfedge_index h = network.halfedge(s);
    result.push_back({true, triangulation.tail(h).idx()});
    for(FG::Input_halfedge_index crossed : triangulation.edge_sequence(h).crossed)
      result.push_back({false, crossed.idx() / 2});
    if(!network.next(s).is_valid())
      result.push_back({true, triangulation.head(h).idx()});
  });
  return result;
}

class Comparison
{
public:
  Comparison(const Mesh& mesh, const Options& options, Row& row)
    : m_mesh(mesh)
    , m_options(options)
    , m_row(row)
    , m_triangulation(mesh)
    , m_network(m_triangulation)
    , m_search(m_triangulation)
    , m_random(options.seed)
  {
  }

  void run()
  {
    const double start = processor_seconds();
    for(int i = 0; i < m_options.sources; ++i) {
      if(processor_seconds() - start > m_options.seconds) {
        m_row.note = "time limit";
        return;
      }
      run_source(vertex());
    }
  }

private:
  Mesh::Vertex_index vertex()
  {
    return Mesh::Vertex_index(static_cast<Mesh::size_type>(m_random() % m_mesh.number_of_vertices()));
  }

  void run_source(Mesh::Vertex_index source)
  {
    double start = processor_seconds();
    Shortest_path shortest_path(m_mesh);
    shortest_path.add_source_point(source);
    shortest_path.build_sequence_tree();
    m_row.shortest_path_time += processor_seconds() - start;
    for(int i = 0; i < m_options.targets; ++i) {
      const Mesh::Vertex_index target = vertex();
      if(target == source || shortest_path.shortest_distance_to_source_points(target).first < 0)
        continue;
      start = processor_seconds();
      const double length = pulled(m_search(m_triangulation.index(source), m_triangulation.index(target)));
      m_row.flip_time += processor_seconds() - start;
      compare(length, CGAL::to_double(shortest_path.shortest_distance_to_source_points(target).first));
      start_from_strip(shortest_path, target);
    }
  }

  double pulled(const sample::Chain& chain)
  {
    m_network.clear();
    m_triangulation.rollback();
    m_network.add_curve(chain);
    FG::shorten(m_network);
    m_row.uncertified += FG::certify(m_network).is_locally_shortest() ? 0 : 1;
    return m_network.length(only_curve);
  }

  void compare(double length, double shortest)
  {
    const double excess = length / shortest - 1;
    m_row.mean_excess = (m_row.mean_excess * m_row.pairs + excess) / (m_row.pairs + 1);
    ++m_row.pairs;
    m_row.shorter += excess < -tolerance ? 1 : 0;
    m_row.equal += std::abs(excess) <= tolerance ? 1 : 0;
    m_row.largest_excess = (std::max)(m_row.largest_excess, excess);
    m_row.largest_deficit = (std::max)(m_row.largest_deficit, -excess);
  }

  void start_from_strip(Shortest_path& shortest_path, Mesh::Vertex_index target)
  {
    Station_visitor visitor;
    const double shortest =
        CGAL::to_double(shortest_path.shortest_path_sequence_to_source_points(target, visitor).first);
    Stations stations = visitor.stations;
    const bool is_left_same = is_reached(stations, shortest);
    std::reverse(stations.begin(), stations.end());
    const bool is_right_same = is_reached(stations, shortest);
    m_row.from_left += is_left_same ? 1 : 0;
    m_row.from_right += is_right_same ? 1 : 0;
    m_row.from_either += is_left_same || is_right_same ? 1 : 0;
    ++m_row.strips;
  }

  // From the left side, the same vertices and edges, or others on which it is as short.
  bool is_reached(const Stations& stations, double shortest)
  {
    const std::optional<sample::Chain> chain = Left_side(m_mesh)(stations);
    if(!chain)
      throw std::runtime_error("a shortest path crosses edges that are not sides of consecutive faces");
    const double length = pulled(*chain);
    const bool is_same = !m_network.is_contracted(only_curve) && stations_of(m_network) == stations;
    return is_same || std::abs(length / shortest - 1) <= 1e-13;
  }

  const Mesh& m_mesh;
  const Options& m_options;
  Row& m_row;
  Triangulation m_triangulation;
  Network m_network;
  Search m_search;
  std::mt19937 m_random;
};

void compare(const std::string& file, const Options& options, Row& row, std::size_t& faces)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    row.note = "not read as an oriented manifold triangle mesh";
    return;
  }
  faces = mesh.number_of_faces();
  Comparison(mesh, options, row).run();
}

void write(const std::string& name, std::size_t faces, const Row& row)
{
  std::cout << name << ',' << faces << ',' << row.pairs << ',' << row.uncertified << ',' << row.shorter << ','
            << row.largest_deficit << ',' << row.equal << ',' << row.mean_excess << ',' << row.largest_excess << ','
            << row.strips << ',' << row.from_left << ',' << row.from_right << ',' << row.from_either << ','
            << row.shortest_path_time << ',' << row.flip_time << ",\"" << row.note << "\"" << std::endl;
}

void add(Row& total, const Row& row)
{
  if(row.pairs > 0)
    total.mean_excess = (total.mean_excess * total.pairs + row.mean_excess * row.pairs) / (total.pairs + row.pairs);
  total.pairs += row.pairs;
  total.uncertified += row.uncertified;
  total.shorter += row.shorter;
  total.equal += row.equal;
  total.largest_deficit = (std::max)(total.largest_deficit, row.largest_deficit);
  total.largest_excess = (std::max)(total.largest_excess, row.largest_excess);
  total.strips += row.strips;
  total.from_left += row.from_left;
  total.from_right += row.from_right;
  total.from_either += row.from_either;
  total.shortest_path_time += row.shortest_path_time;
  total.flip_time += row.flip_time;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Compares geodesics with shortest paths"};
  Options options;
  app.add_option("meshes", options.files, "Meshes, and folders of meshes")->required();
  app.add_option("--sources", options.sources, "Random sources on each mesh")->capture_default_str();
  app.add_option("--targets", options.targets, "Random targets for each source")->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the random choices")->capture_default_str();
  app.add_option("--seconds", options.seconds, "Seconds after which no further source is taken on a mesh")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  Row total;
  std::size_t total_faces = 0;
  std::cout << "mesh,faces,pairs,uncertified,shorter,largest_deficit,equal,mean_excess,largest_excess,strips,from_left,"
               "from_right,from_either,shortest_path_s,flip_s,note\n";
  for(const std::string& file : sample::mesh_files(options.files)) {
    Row row;
    std::size_t faces = 0;
    try {
      compare(file, options, row, faces);
    } catch(const std::exception& error) {
      row.note = error.what();
    }
    write(file, faces, row);
    add(total, row);
    total_faces += faces;
  }
  write("total", total_faces, total);
  return total.shorter == 0 && std::cout.flush() ? 0 : 1;
}
