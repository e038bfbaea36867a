// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes a geodesic with respect to a metric that is given by edge lengths instead of points. Here, the z component
// of each edge is multiplied by COST, so that geodesics avoid steps in the direction z.
//
//   edge_length_metric_example MESH [COST]
//
// Writes edge_length_metric.vtp, the geodesic.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Length_map = Mesh::Property_map<Mesh::Edge_index, double>;
using Metric = FG::Edge_length_metric<Mesh, Length_map>;
using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>; // as in Polygon Mesh Processing

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
  const double cost = argc > 2 ? number(argv[2]) : 3;
  if(!(cost > 0))
    throw std::invalid_argument("the cost must be a positive number");
  Length_map lengths = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
  for(const auto e : mesh.edges()) {
    const Kernel::Vector_3 d = mesh.point(mesh.vertex(e, 1)) - mesh.point(mesh.vertex(e, 0));
    lengths[e] = std::hypot(d.x(), d.y(), cost * d.z());
  }

  std::vector<Face_location> locations;
  const Mesh::Vertex_index source(0), target(mesh.number_of_vertices() / 2);
  const auto result = FG::geodesic_path(mesh, source, target, std::back_inserter(locations),
                                        CGAL::parameters::metric(Metric(mesh, lengths)));
  std::cout << "In this metric the geodesic is " << result.length() << " long.\n";
  std::vector<std::vector<Kernel::Point_3>> curves(1);
  for(const Face_location& location : locations)
    curves[0].push_back(CGAL::Polygon_mesh_processing::construct_point(location, mesh));
  FG::IO::write_VTP("edge_length_metric.vtp", curves);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
