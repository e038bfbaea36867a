// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Straightens the same shortest edge paths by flips, by iterative unfolding and by iterative relaxation, interleaved,
// and has an independent checker say which results are geodesic. Writes a line per path, with a header:
//
//   mesh,triangles,source,target,segments,flips,dijkstra_s,flip_out_s,unfolding_s,relaxation_s,unfolding_rounds,
//   relaxation_sweeps,flip_out_length,unfolding_length,relaxation_length,flip_out_geodesic,unfolding_geodesic,
//   relaxation_geodesic
//
// The last three are 1 if the curve is straight to 1e-4 radians everywhere. Times are medians over three rounds, from
// the edge path to the points of the curve; the relaxation is run once, to its authors' tolerance of 0.005 radians, and
// for the verdict once more, to 1e-5, for as many sweeps as the first time but at least 20000.
//
// With --detour the start is two shortest edge paths one after the other, by way of a third vertex: straight but for
// one place, and far from the geodesic, as in [SC20, Figure 17]. The times are those of both searches together.
//
// Usage: compare_straightening [--detour] PAIRS MESH...

#include "benchmark_meshes.h"
#include "edge_dijkstra.h"
#include "iterative_relaxation.h"
#include "iterative_unfolding.h"
#include "polyline_checker.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Edge_path = std::vector<Mesh::Halfedge_index>;
using Path = opponents::Portal_path<Mesh>;

polyline_checker::Mesh checker_mesh(const Mesh& mesh)
{
  std::vector<std::array<double, 3>> points;
  for(Mesh::Vertex_index v : mesh.vertices())
    points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  std::vector<polyline_checker::Mesh::Face> faces;
  for(Mesh::Face_index f : mesh.faces()) {
    polyline_checker::Mesh::Face corners;
    std::size_t i = 0;
    for(Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      corners[i++] = static_cast<polyline_checker::Index>(v);
    faces.push_back(corners);
  }
  return polyline_checker::Mesh(std::move(points), faces);
}

double median(std::array<double, 3> times)
{
  std::sort(times.begin(), times.end());
  return times[1];
}

class Comparison
{
public:
  Comparison(const std::string& name, bool is_detour)
    : m_is_detour(is_detour)
    , m_name(benchmark_meshes::short_name(name))
    , m_mesh(benchmark_meshes::make_mesh(name))
    , m_checker_mesh(checker_mesh(m_mesh))
    , m_geometry(m_mesh)
    , m_dijkstra(m_mesh)
    , m_triangulation(m_mesh)
  {
  }

  void run(std::size_t pairs)
  {
    std::mt19937 random(1);
    const auto vertex = [&] {
      return Mesh::Vertex_index(static_cast<std::uint32_t>(random() % m_mesh.num_vertices()));
    };
    for(std::size_t i = 0, tries = 0; i < pairs && tries < 10 * pairs; ++tries) {
      const auto source = vertex(), target = vertex();
      m_way_point = m_is_detour ? vertex() : target;
      const Edge_path path = start(source, target);
      if(path.size() < 2 || !is_simple(path))
        continue;
      compare(path, source, target);
      ++i;
    }
  }

private:
  using Polyline = polyline_checker::Polyline;

  Edge_path start(Mesh::Vertex_index source, Mesh::Vertex_index target)
  {
    Edge_path path = m_dijkstra(source, m_way_point);
    if(m_is_detour) {
      const Edge_path rest = m_dijkstra(m_way_point, target);
      path.insert(path.end(), rest.begin(), rest.end());
    }
    return path;
  }

  bool is_simple(const Edge_path& path) const
  {
    std::set<Mesh::Vertex_index> passed = {m_mesh.source(path.front())};
    return std::all_of(path.begin(), path.end(), [&](auto h) { return passed.insert(m_mesh.target(h)).second; });
  }

  void compare(const Edge_path& path, Mesh::Vertex_index source, Mesh::Vertex_index target)
  {
    std::array<double, 3> dijkstra, flipping, unfolding;
    Polyline flipped, unfolded;
    std::size_t flips = 0, rounds = 0, sweeps = 0;
    for(std::size_t round = 0; round < 3; ++round) {
      dijkstra[round] = seconds([&] { start(source, target); });
      flipping[round] = seconds([&] { flipped = flip_out(path, flips); });
      unfolding[round] = seconds([&] {
        Path portals(m_geometry, path);
        rounds = opponents::Iterative_unfolding<Mesh>()(portals);
        unfolded = polyline(portals);
      });
    }
    Polyline relaxed;
    const double relaxation = seconds([&] {
      Path portals(m_geometry, path);
      sweeps = opponents::Iterative_relaxation<Mesh>()(portals);
      relaxed = polyline(portals);
    });
    Path portals(m_geometry, path);
    opponents::Iterative_relaxation<Mesh>()(portals, 1e-5, (std::max)(sweeps, std::size_t(20000)));
    const Polyline relaxed_longer = polyline(portals);

    std::cout << m_name << ',' << m_mesh.number_of_faces() << ',' << source << ',' << target << ',' << path.size()
              << ',' << flips << ',' << median(dijkstra) << ',' << median(flipping) << ',' << median(unfolding) << ','
              << relaxation << ',' << rounds << ',' << sweeps << ',' << length(flipped) << ',' << length(unfolded)
              << ',' << length(relaxed) << ',' << is_geodesic(flipped) << ',' << is_geodesic(unfolded) << ','
              << is_geodesic(relaxed_longer) << std::endl;
  }

  Polyline flip_out(const Edge_path& path, std::size_t& flips)
  {
    std::vector<FG::Halfedge_index> halfedges;
    for(Mesh::Halfedge_index h : path)
      halfedges.emplace_back(static_cast<FG::Index>(h));
    Polyline result = {0, {}};
    {
      Network network(m_triangulation);
      const FG::Curve_index curve = network.add_curve(halfedges);
      flips = FG::shorten(network).flips;
      FG::Curve_extractor<Network> extractor(network);
      for(const FG::Surface_point& p : extractor.surface_points(curve)) {
        const auto q = extractor.point(p);
        result.points.push_back({static_cast<polyline_checker::Index>(p.a.idx()),
                                 static_cast<polyline_checker::Index>(p.b.idx()),
                                 p.t,
                                 {q.x(), q.y(), q.z()}});
      }
    }
    m_triangulation.rollback();
    return result;
  }

  Polyline polyline(const Path& path) const
  {
    Polyline result = {0, {vertex_point(path.source())}};
    for(const auto& portal : path.portals) {
      const auto a = m_mesh.source(portal.crossed), b = m_mesh.target(portal.crossed);
      if(portal.is_at_vertex()) {
        const auto point = vertex_point(portal.is_at_tail() ? a : b);
        if(!result.points.back().place().is_vertex() || result.points.back().a != point.a)
          result.points.push_back(point);
        continue;
      }
      const auto p = m_mesh.point(a) + portal.t * (m_mesh.point(b) - m_mesh.point(a));
      result.points.push_back({static_cast<polyline_checker::Index>(a),
                               static_cast<polyline_checker::Index>(b),
                               portal.t,
                               {p.x(), p.y(), p.z()}});
    }
    result.points.push_back(vertex_point(path.target()));
    return result;
  }

  polyline_checker::Polyline_point vertex_point(Mesh::Vertex_index v) const
  {
    const auto& p = m_mesh.point(v);
    const auto index = static_cast<polyline_checker::Index>(v);
    return {index, index, 0, {p.x(), p.y(), p.z()}};
  }

  static double length(const Polyline& curve)
  {
    double sum = 0;
    for(std::size_t i = 1; i < curve.points.size(); ++i) {
      const auto &p = curve.points[i - 1].position, &q = curve.points[i].position;
      sum += std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    }
    return sum;
  }

  int is_geodesic(const Polyline& curve) const
  {
    const polyline_checker::Tolerances tolerances = {1e-4L, 1e-4L, 1e-4L};
    const auto reports =
        polyline_checker::check_curves(m_checker_mesh, {curve}, polyline_checker::Joint_options(), tolerances);
    return polyline_checker::is_geodesic(reports.front(), tolerances) ? 1 : 0;
  }

  bool m_is_detour;
  std::string m_name;
  Mesh m_mesh;
  Mesh::Vertex_index m_way_point; // of a detour, otherwise the target
  polyline_checker::Mesh m_checker_mesh;
  opponents::Surface_geometry<Mesh> m_geometry;
  Edge_dijkstra<Mesh> m_dijkstra;
  Triangulation m_triangulation;
};

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Compares three methods of shortening the same paths"};
  std::size_t pairs = 0;
  std::vector<std::string> meshes;
  bool is_detour = false;
  app.add_option("pairs", pairs, "Pairs of vertices on each mesh")->required();
  app.add_option("meshes", meshes, "Meshes, as files or by name")->required();
  app.add_flag("--detour", is_detour, "Start with paths through a third vertex");
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << "mesh,triangles,source,target,segments,flips,dijkstra_s,flip_out_s,unfolding_s,relaxation_s,"
                 "unfolding_rounds,relaxation_sweeps,flip_out_length,unfolding_length,relaxation_length,"
                 "flip_out_geodesic,unfolding_geodesic,relaxation_geodesic\n";
    std::cout.precision(9);
    for(const std::string& mesh : meshes)
      Comparison(mesh, is_detour).run(pairs);
  } catch(const std::exception& error) {
    std::cerr << "compare_straightening: " << error.what() << '\n';
    return 2;
  }
  return std::cout.flush() ? 0 : 1;
}
