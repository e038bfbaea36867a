// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Loops of surfaces: a basis, each loop pulled tight by itself, all together through their base point, a cut graph pulled
// tight, and the shortest loop that cannot be contracted. Writes a line per mesh, with a header:
//
//   mesh,triangles,loops,basis_s,tight_s,network_s,cut_s,shortest_s,basis_length,tight_length,cut_length,shortest_length
//
// Usage: surface_loops MESH...
//
// A mesh is a file, or `plate:G:N`: a plate with G square holes in a row, each unit of its edges in N parts.

#include "../../test/Flip_geodesics/generated_meshes.h"
#include "benchmark_meshes.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/geodesic_loops.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using benchmark_meshes::Mesh;
using Triangulation = FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<benchmark_meshes::Kernel>>;
using Network = FG::Edge_path_network<Triangulation>;

Mesh make_mesh(const std::string& name)
{
  using namespace Flip_geodesics_test;
  int genus = 0, parts = 0;
  if(std::sscanf(name.c_str(), "plate:%d:%d", &genus, &parts) != 2)
    return benchmark_meshes::make_mesh(name);
  const auto is_filled = [](int i, int j, int) { return j != 1 || i % 2 == 0; };
  return to_mesh<Mesh>(subdivided(scaled(voxel_surface(2 * genus + 1, 3, 1, is_filled), parts), parts));
}

double length(const Network& network)
{
  double sum = 0;
  for(FG::Curve_index c : network.curves())
    sum += network.length(c);
  return sum;
}

// Adds curves to an empty network, pulls them tight, and takes all back; the length that they have then.
template <class AddCurves>
double tight_length(Triangulation& triangulation, const AddCurves& add_curves)
{
  double result = 0;
  {
    Network network(triangulation);
    add_curves(network);
    FG::shorten(network);
    result = length(network);
  }
  triangulation.rollback();
  return result;
}

void measure(const std::string& name)
{
  const Mesh mesh = make_mesh(name);
  Triangulation triangulation(mesh);
  std::optional<FG::Loop_basis<Triangulation>> basis;
  const double basis_time = seconds([&] { basis.emplace(triangulation); });
  double basis_length = 0, tight = 0, cut = 0, shortest = 0;
  for(FG::Index i = 0; i < basis->number_of_loops(); ++i)
    basis_length += basis->length(i);
  const double tight_time = seconds([&] {
    for(FG::Index i = 0; i < basis->number_of_loops(); ++i)
      tight += tight_length(triangulation, [&](Network& network) {
        network.add_curve(basis->cycle(i), CGAL::parameters::is_closed(true));
      });
  });
  const double network_time = seconds([&] {
    tight_length(triangulation, [&](Network& network) {
      for(FG::Index i = 0; i < basis->number_of_loops(); ++i)
        network.add_curve(basis->loop(i));
      FG::order_overlapping_curves(network);
    });
  });
  const double cut_time =
      seconds([&] { cut = tight_length(triangulation, [](Network& network) { FG::add_cut_graph(network); }); });
  const double shortest_time = seconds([&] {
    for(FG::Halfedge_index h : FG::shortest_loop(triangulation))
      shortest += triangulation.length(h);
  });
  std::cout << benchmark_meshes::short_name(name) << ',' << mesh.number_of_faces() << ',' << basis->number_of_loops()
            << ',' << basis_time << ',' << tight_time << ',' << network_time << ',' << cut_time << ',' << shortest_time
            << ',' << basis_length << ',' << tight << ',' << cut << ',' << shortest << '\n';
}

} // namespace

int main(int argc, char** argv)
try {
  if(argc < 2)
    throw std::invalid_argument("usage: surface_loops MESH...");
  std::cout << "mesh,triangles,loops,basis_s,tight_s,network_s,cut_s,shortest_s,basis_length,tight_length,cut_length,"
               "shortest_length\n";
  for(int i = 1; i < argc; ++i)
    measure(argv[i]);
} catch(const std::exception& error) {
  std::cerr << "surface_loops: " << error.what() << '\n';
  return 2;
}
