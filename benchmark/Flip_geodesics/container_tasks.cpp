// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The tasks for which compare_containers.py measures containers of the package against those of libraries. Prints a
// number for the result, and the seconds of the processor.
//
//   container_tasks TASK COUNT [VERTICES | MESH]
//
// TASK is edge_path, path, shortest_path, tree or history, which is run COUNT times on a mesh, or on a bumpy torus with
// as many vertices (100 000 by default).

#include "benchmark_meshes.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdint>
#include <exception>
#include <iostream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

namespace {

using Mesh = benchmark_meshes::Mesh;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

double path(const Mesh& mesh, Mesh::Vertex_index s, Mesh::Vertex_index t)
{
  std::vector<Mesh::Point> points;
  return FG::geodesic_path(mesh, s, t, std::back_inserter(points)).length();
}

double shortest_path(const Mesh& mesh, Mesh::Vertex_index s, Mesh::Vertex_index t)
{
  std::vector<Mesh::Point> points;
  return FG::shortest_path(mesh, s, t, std::back_inserter(points)).length();
}

double edge_path(const Mesh& mesh, Mesh::Vertex_index s, Mesh::Vertex_index t)
{
  const Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  return static_cast<double>(search(triangulation.index(s), triangulation.index(t)).size());
}

double tree(const Mesh& mesh, Mesh::Vertex_index s, Mesh::Vertex_index t)
{
  Triangulation triangulation(mesh);
  FG::Geodesic_tree<Triangulation> geodesics(triangulation);
  geodesics.grow(triangulation.index(s));
  return geodesics.distance(triangulation.index(t));
}

/* Flips to a Delaunay triangulation, and reads off what its edges cross, twice. */
double history(const Mesh& mesh, Mesh::Vertex_index, Mesh::Vertex_index)
{
  Triangulation triangulation(mesh);
  FG::flip_to_delaunay(triangulation);
  double sum = 0;
  for(int round = 0; round < 2; ++round)
    for(FG::Index e = 0; e < triangulation.number_of_halfedges() / 2; ++e)
      sum += static_cast<double>(triangulation.edge_sequence(FG::Halfedge_index(2 * e)).crossed.size());
  return sum;
}

using Task = double (*)(const Mesh&, Mesh::Vertex_index, Mesh::Vertex_index);

Task task(const std::string& name)
{
  if(name == "edge_path")
    return edge_path;
  if(name == "path")
    return path;
  if(name == "shortest_path")
    return shortest_path;
  if(name == "tree")
    return tree;
  if(name == "history")
    return history;
  throw std::invalid_argument("there is no task " + name);
}

} // namespace

int main(int argc, char** argv)
try {
  if(argc < 3)
    throw std::invalid_argument("usage: container_tasks TASK COUNT [VERTICES | MESH]");
  const std::string surface = argc < 4 ? "100000" : argv[3];
  Mesh mesh;
  if(surface.find_first_not_of("0123456789") == std::string::npos)
    mesh = benchmark_meshes::torus(std::stoi(surface));
  else if(!CGAL::IO::read_polygon_mesh(surface, mesh))
    throw std::invalid_argument(surface + " is not a triangle mesh");
  const std::string name = argv[1];
  const Task compute = task(name);
  std::mt19937 random(1);
  const auto vertex = [&] { return Mesh::Vertex_index(random() % mesh.number_of_vertices()); };
  double sum = 0;
  const auto compute_all = [&] {
    for(int i = std::stoi(argv[2]); i > 0; --i) {
      const Mesh::Vertex_index s = vertex(), t = vertex();
      sum += s == t ? 0 : compute(mesh, s, t);
    }
  };
  const double time = seconds(compute_all);
  std::cout.precision(17);
  std::cout << sum << ' ' << time << '\n';
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
