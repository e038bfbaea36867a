// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Measures resident memory: how much a mesh takes, how much a triangulation over it, how much one far query adds, and
// how much a triangulation takes of which every face has been touched. Writes a line per mesh, with a header:
//
//   mesh,triangles,mesh_bytes,construct_bytes,query_bytes,query_segments,touched_bytes,touched_bytes_per_triangle
//
// Needs /proc. Usage: memory_use MESH...

#include "benchmark_meshes.h"

#include <CGAL/Flip_geodesics.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;

long long resident_bytes()
{
  std::ifstream file("/proc/self/statm");
  long long size = 0, resident = 0;
  if(!(file >> size >> resident))
    throw std::runtime_error("/proc/self/statm cannot be read");
  return resident * sysconf(_SC_PAGESIZE);
}

// Resident memory without what was freed and is kept for reuse, so that what is taken later shows.
long long resident_bytes_in_use()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  return resident_bytes();
}

/// The vertex that is farthest from `source` in space.
Mesh::Vertex_index farthest_vertex(const Mesh& mesh, Mesh::Vertex_index source)
{
  const auto& p = mesh.point(source);
  Mesh::Vertex_index farthest = source;
  double largest = 0;
  for(Mesh::Vertex_index v : mesh.vertices()) {
    const double square = CGAL::squared_distance(p, mesh.point(v));
    if(square > largest) {
      largest = square;
      farthest = v;
    }
  }
  return farthest;
}

// The workspace of queries from a mesh to the end of its life.
struct Workspace
{
  Triangulation triangulation;
  FG::Shortest_edge_path<Triangulation> search;

  explicit Workspace(const Mesh& mesh)
    : triangulation(mesh)
    , search(triangulation, CGAL::parameters::search_method(FG::Search_method::LOOK_BACK))
  {
  }

  std::size_t query(Mesh::Vertex_index source, Mesh::Vertex_index target)
  {
    const std::vector<FG::Halfedge_index> path = search(triangulation.index(source), triangulation.index(target));
    Network network(triangulation);
    FG::add_straightened_path(network, path);
    FG::shorten(network);
    FG::Curve_extractor<Network>(network).surface_points(FG::Curve_index(0));
    return path.size();
  }

  void touch_all()
  {
    for(FG::Halfedge_index h(0); h.idx() < triangulation.number_of_halfedges(); ++h)
      triangulation.is_border(h);
  }
};

void measure(const std::string& name)
{
  const long long before = resident_bytes_in_use();
  const Mesh mesh = benchmark_meshes::make_mesh(name);
  const Mesh::Vertex_index source(0), target = farthest_vertex(mesh, source);
  const long long with_mesh = resident_bytes_in_use();
  auto workspace = std::make_unique<Workspace>(mesh);
  const long long constructed = resident_bytes();
  const std::size_t segments = workspace->query(source, target);
  const long long queried = resident_bytes();
  workspace.reset();
  const long long empty = resident_bytes_in_use();
  workspace = std::make_unique<Workspace>(mesh);
  workspace->touch_all();
  const long long touched = resident_bytes() - empty;
  std::cout << benchmark_meshes::short_name(name) << ',' << mesh.number_of_faces() << ',' << with_mesh - before << ','
            << constructed - with_mesh << ',' << queried - constructed << ',' << segments << ',' << touched << ','
            << static_cast<double>(touched) / mesh.number_of_faces() << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    if(argc < 2)
      throw std::runtime_error("no mesh is given");
    std::cout << "mesh,triangles,mesh_bytes,construct_bytes,query_bytes,query_segments,touched_bytes,"
                 "touched_bytes_per_triangle\n";
    for(int i = 1; i < argc; ++i)
      measure(argv[i]);
  } catch(const std::exception& error) {
    std::cerr << "memory_use: " << error.what() << '\n';
    return 2;
  }
  return std::cout.flush() ? 0 : 1;
}
