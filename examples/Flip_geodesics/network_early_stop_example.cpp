// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Smooths the boundaries between regions of a mesh: a network of curves is straightened together, but a stop predicate
// ends it before they are geodesics, and a visitor watches and may interrupt. The network is saved, loaded again, and
// pulled tight to the end.
//
//   network_early_stop_example [MESH [LENGTH_RATIO]]

#include "polylines_io.h"
#include "torus.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/network_io.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;

struct Counting_visitor : FG::Default_shortening_visitor
{
  std::size_t steps = 0;

  template <class AnyNetwork>
  void after_flip_out(const AnyNetwork&, FG::Curve_index)
  {
    ++steps;
  }
  bool go_further() { return steps < 1000000; }
};

// The region of a face, one of eight boxes.
int region(const Mesh& mesh, Mesh::Face_index f)
{
  const Point_3& p = mesh.point(mesh.target(mesh.halfedge(f)));
  return (p.x() > 0.1 ? 1 : 0) + (p.y() > 0.1 ? 2 : 0) + (p.z() > 0.1 ? 4 : 0);
}

bool write_curves(const char* file, const Network& network)
{
  std::vector<std::vector<Point_3>> curves;
  FG::Curve_extractor<Network> extractor(network);
  for(FG::Curve_index c : network.curves()) {
    curves.emplace_back();
    extractor.points(c, std::back_inserter(curves.back()));
  }
  return write_polylines(file, curves);
}

int main(int argc, char** argv)
{
  Mesh mesh;
  const bool has_mesh = argc > 1 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : make_torus(mesh) > 0;
  const double ratio = argc > 2 ? std::strtod(argv[2], nullptr) : 0.9;
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty() || !(ratio >= 0 && ratio <= 1)) {
    std::cerr << "This is not a triangle mesh, or not a ratio between 0 and 1.\n";
    return EXIT_FAILURE;
  }
  auto regions = mesh.add_property_map<Mesh::Face_index, int>("f:region", 0).first;
  for(const auto f : mesh.faces())
    regions[f] = region(mesh, f);

  Counting_visitor visitor;
  try {
    Triangulation triangulation(mesh);
    Network network(triangulation);
    FG::add_region_boundaries(network, mesh, regions);
    FG::shorten(network, FG::Curve_length_ratio_stop_predicate(ratio), visitor);
    std::ofstream out("network.flips");
    FG::write_network(out, network);
    out.close();
    network.clear();
    triangulation.rollback();

    std::ifstream in("network.flips");
    FG::read_network(in, network); // as it was before
    const bool is_written = write_curves("network.polylines.txt", network);
    std::cout << network.number_of_curves() << " curves after " << visitor.steps << " steps.\n";
    FG::shorten(network);
    return is_written && write_curves("finished_network.polylines.txt", network) && std::cout.flush() ? EXIT_SUCCESS
                                                                                                      : EXIT_FAILURE;
  } catch(const FG::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
