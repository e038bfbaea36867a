// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Smooths the boundaries between regions of a mesh. The curves of a network are shortened together, but a stop
// predicate ends the shortening before they become geodesics. A visitor counts the steps, and stops the computation
// after a million of them.
//
//   network_early_stop_example MESH [LENGTH_RATIO]
//
// Writes the curves to network.vtp.

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
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

double number(const std::string& text)
{
  std::istringstream in(text);
  double result = 0;
  if(!(in >> result && in.eof()))
    throw std::invalid_argument(text + " is not a number");
  return result;
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  const double ratio = argc > 2 ? number(argv[2]) : 0.9;
  if(!(ratio >= 0 && ratio <= 1))
    throw std::invalid_argument("the ratio must be between 0 and 1");
  auto regions = mesh.add_property_map<Mesh::Face_index, int>("f:region", 0).first;
  for(const auto f : mesh.faces()) { // the octant around (0.1, 0.1, 0.1) that contains a corner of the face
    const Kernel::Point_3& p = mesh.point(mesh.target(mesh.halfedge(f)));
    regions[f] = (p.x() > 0.1 ? 1 : 0) + (p.y() > 0.1 ? 2 : 0) + (p.z() > 0.1 ? 4 : 0);
  }

  //! [Early stop]
  Counting_visitor visitor;
  Triangulation triangulation(mesh);
  Network network(triangulation);
  FG::add_region_boundaries(network, mesh, regions);
  FG::shorten(network, CGAL::parameters::stop_predicate(FG::Curve_length_ratio_stop_predicate(ratio)),
              CGAL::parameters::visitor(std::ref(visitor)));
  //! [Early stop]
  std::cout << network.number_of_curves() << " curves after " << visitor.steps << " steps.\n";

  std::vector<std::vector<Kernel::Point_3>> curves;
  FG::Curve_extractor<Network> extractor(network);
  for(FG::Curve_index c : network.curves()) {
    curves.emplace_back();
    extractor.points(c, std::back_inserter(curves.back()));
  }
  FG::IO::write_VTP("network.vtp", curves);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
