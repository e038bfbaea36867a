// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Trees of geodesics over meshes: how many paths are shortest, and what it costs.
//
//   tree_corpus [--kernel certified|double] [--gear TEETH] MESH...
//
// Writes a line per mesh: the tree from its first vertex with a face, before and after make_shortest(). With --gear, a
// gear wheel with so many teeth is generated. Options hold for the meshes after them.
//
// Exit status: 0 if every tree is valid, 1 if not.

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/math/constants/constants.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Clock = std::chrono::steady_clock;

namespace {

double milliseconds_since(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/*
 * A gear wheel with a bore: rings of points from the bore over the upper face, down the teeth, and back over the lower
 * face, as a torus of `8 * teeth` by 48 vertices. Radii of neighboring points differ by the height of a tooth at the
 * flanks, so that faces are uneven, as those of machine parts are.
 */
Mesh gear(int teeth)
{
  constexpr double two_pi = boost::math::constants::two_pi<double>();
  constexpr int across = 16, down = 8, rings = 2 * (across + down);
  const int around = 8 * teeth;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < around; ++i) {
    const double outer = i % 8 < 4 ? 1.2 : 1, angle = two_pi * (i + (i % 8 < 4 ? 0.25 : -0.25) * (i % 2)) / around;
    for(int j = 0; j < rings; ++j) {
      const bool is_upper = j < across, is_outer = !is_upper && j < across + down;
      const bool is_lower = !is_upper && !is_outer && j < 2 * across + down;
      const double t = is_upper   ? double(j) / across
                       : is_outer ? double(j - across) / down
                       : is_lower ? double(j - across - down) / across
                                  : double(j - 2 * across - down) / down;
      const double radius = is_upper   ? 0.4 + t * (outer - 0.4)
                            : is_outer ? outer
                            : is_lower ? outer - t * (outer - 0.4)
                                       : 0.4;
      const double height = is_upper ? 0.2 : is_outer ? 0.2 - 0.4 * t : is_lower ? -0.2 : -0.2 + 0.4 * t;
      v.push_back(mesh.add_vertex(Point_3(radius * std::cos(angle), radius * std::sin(angle), height)));
    }
  }
  for(int i = 0; i < around; ++i)
    for(int j = 0; j < rings; ++j) {
      const auto at = [&](int k, int l) { return v[(k % around) * rings + l % rings]; };
      CGAL::Euler::add_face(std::array<Mesh::Vertex_index, 3>{at(i, j), at(i, j + 1), at(i + 1, j + 1)}, mesh);
      CGAL::Euler::add_face(std::array<Mesh::Vertex_index, 3>{at(i, j), at(i + 1, j + 1), at(i + 1, j)}, mesh);
    }
  return mesh;
}

// Are the trees valid?
template <class Traits>
bool measure(const std::string& name, const Mesh& mesh)
{
  using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits>;
  bool is_valid = true;
  FG::Vertex_index source(0);
  const auto end = static_cast<FG::Index>(mesh.number_of_vertices());
  while(source.idx() < end && mesh.is_isolated(Mesh::Vertex_index(source.idx())))
    ++source;
  std::cout << name << ' ' << mesh.number_of_faces() << std::flush;
  try {
    Triangulation triangulation(mesh);
    FG::Geodesic_tree<Triangulation> tree(triangulation);
    auto start = Clock::now();
    const FG::Geodesic_tree_report grown = tree.grow(source);
    is_valid = tree.is_valid();
    std::cout << ' ' << milliseconds_since(start) << ' ' << grown.flips << ' ' << grown.reopened << ' '
              << FG::to_string(grown.status) << (is_valid ? "" : ",INVALID") << std::flush;
    start = Clock::now();
    const FG::Distances_report report = FG::make_shortest(tree);
    const bool is_valid_then = tree.is_valid(1e-8);
    is_valid = is_valid && is_valid_then;
    const auto share = [&](std::size_t longer) {
      return 100.0 * double(report.vertices - longer) / double(report.vertices);
    };
    std::cout << ' ' << share(report.longer_before) << ' ' << 100 * report.largest_excess_before << ' '
              << share(report.longer) << ' ' << milliseconds_since(start) << ' ' << report.windows << ' '
              << FG::to_string(report.status) << (is_valid_then ? "" : ",INVALID")
              << (report.is_confirmed() ? " confirmed" : " unconfirmed") << std::endl;
  } catch(const std::exception& error) {
    std::cout << " ERROR " << std::string(error.what()).substr(0, 100) << std::endl;
  }
  return is_valid;
}

bool measure(const std::string& name, const Mesh& mesh, bool is_certified)
{
  return is_certified ? measure<FG::Certified_intrinsic_triangulation_traits<Kernel>>(name, mesh)
                      : measure<FG::Intrinsic_triangulation_traits<Kernel>>(name, mesh);
}

} // namespace

int main(int argc, char** argv)
{
  std::cout
      << "mesh triangles grow_ms flips reopened status shortest_% largest_excess_% shortest_then_% repair_ms windows "
         "status_then confirmed\n";
  bool is_certified = true, are_valid = true;
  for(int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    Mesh mesh;
    if(argument == "--kernel" && i + 1 < argc) {
      is_certified = std::string(argv[++i]) == "certified";
    } else if(argument == "--gear" && i + 1 < argc) {
      const int teeth = std::atoi(argv[++i]);
      mesh = gear(teeth);
      are_valid = measure("gear_" + std::to_string(teeth), mesh, is_certified) && are_valid;
    } else if(CGAL::IO::read_polygon_mesh(argument, mesh) && CGAL::is_triangle_mesh(mesh) && !mesh.is_empty()) {
      are_valid = measure(argument.substr(argument.find_last_of('/') + 1), mesh, is_certified) && are_valid;
    } else {
      std::cout << argument << " cannot be read\n";
    }
  }
  return are_valid && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
