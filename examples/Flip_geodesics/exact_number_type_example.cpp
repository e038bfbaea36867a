// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Exact arithmetic in a number type of one's choice: rational numbers, on a mesh whose areas are rational multiples of
// one square root. The squared length of each straight piece comes out exactly.
//
//   exact_number_type_example

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Rational = boost::multiprecision::cpp_rational;
using Traits = FG::Exact_intrinsic_triangulation_traits<Rational, Kernel>;
using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits>;
using Network = FG::Edge_path_network<Triangulation>;

int main()
try {
  Mesh mesh; // a sheet of 12 * 7 unit squares that is folded by a right angle along one of its lines
  const auto folded = [](std::size_t i, std::size_t j) {
    const int x = static_cast<int>(i), y = static_cast<int>(j), fold = 5;
    return Kernel::Point_3((std::min)(x, fold), y, (std::max)(x - fold, 0));
  };
  CGAL::make_grid(12, 7, mesh, folded, true);

  const Rational radicand = FG::common_radicand<Rational>(mesh);
  std::cout << "Areas are counted in units of the root of " << radicand << ".\n";
  Triangulation triangulation(mesh, Traits(radicand));
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  Network network(triangulation);
  const FG::Vertex_index source(0), target(triangulation.number_of_vertices() - 1);
  const FG::Curve_index curve = network.add_curve(search(source, target), false);
  const FG::Shortening_report report = FG::shorten(network);
  for(FG::Halfedge_index h : network.halfedges(curve))
    std::cout << "A straight piece whose squared length is " << triangulation.squared_length(h) << ".\n";
  std::cout << "The certificate says " << to_string(report.curves.front().verdict) << ".\n";
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
