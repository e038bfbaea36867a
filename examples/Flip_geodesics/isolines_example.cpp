// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes isolines of the distance from some vertices, and the boundaries of the Voronoi diagram of these vertices.
//
//   isolines_example MESH [SOURCE]...
//
// Writes isolines.vtp and voronoi.vtp, with the mesh.

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/isolines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Polylines = std::vector<std::vector<Point_3>>;

FG::Index number(const std::string& text)
{
  std::istringstream in(text);
  FG::Index result = 0;
  if(!(in >> result && in.eof()))
    throw std::invalid_argument(text + " is not a number");
  return result;
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");

  const Triangulation triangulation(mesh);
  FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
  for(int i = 2; i < argc; ++i)
    field.add_source(FG::Vertex_index(number(argv[i])));
  if(argc < 3)
    field.add_source(FG::Vertex_index(0));
  field.compute();
  double largest = 0;
  for(const auto v : mesh.vertices())
    if(const double distance = field.distance(triangulation.index(v)); distance < 1e300) // infinite on other components
      largest = (std::max)(largest, distance);

  const double tolerance = 0.002 * largest;
  std::vector<double> levels;
  for(int i = 1; i < 10; ++i)
    levels.push_back(0.1 * i * largest);
  std::vector<FG::Isoline<Mesh>> isolines;
  //! [Isolines]
  FG::isolines(mesh, field, levels, std::back_inserter(isolines), tolerance);
  std::vector<FG::Voronoi_boundary<Mesh>> boundaries;
  FG::voronoi_boundaries(mesh, field, std::back_inserter(boundaries), tolerance);
  //! [Isolines]

  Polylines curves, diagram;
  for(const auto& isoline : isolines)
    curves.push_back(isoline.points);
  for(const auto& boundary : boundaries)
    diagram.push_back(boundary.points);
  FG::IO::write_VTP("isolines.vtp", mesh, curves);
  FG::IO::write_VTP("voronoi.vtp", mesh, diagram);
  std::cout << isolines.size() << " isolines and " << boundaries.size() << " boundaries of "
            << field.number_of_sources() << " regions\n";
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
