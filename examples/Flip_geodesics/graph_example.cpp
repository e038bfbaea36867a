// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes the areas of the regions into which the three geodesics between three vertices divide a surface. The
// triangulation contains the geodesics as edges and is a model of FaceListGraph, so that a function of Polygon Mesh
// Processing can compute the regions.
//
//   graph_example MESH [VERTEX VERTEX VERTEX]

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/graph_traits.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;

// Computes the area of a face by Heron's formula, in the order of operations given by Kahan.
double area(const Triangulation& triangulation, FG::Face_index f)
{
  std::vector<double> sides;
  for(FG::Halfedge_index h : halfedges_around_face(halfedge(f, triangulation), triangulation))
    sides.push_back(get(boost::edge_weight, triangulation, edge(h, triangulation)));
  std::sort(sides.begin(), sides.end());
  const double c = sides[0], b = sides[1], a = sides[2];
  return std::sqrt(std::max(0.0, (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c)))) / 4;
}

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
  const auto n = static_cast<FG::Index>(mesh.number_of_vertices());
  std::array<FG::Vertex_index, 3> corners = {FG::Vertex_index(0), FG::Vertex_index(n / 12), FG::Vertex_index(n / 23)};
  for(int i = 0; i < 3 && argc > 4; ++i)
    corners[i] = FG::Vertex_index(number(argv[2 + i]));

  Triangulation triangulation(mesh);
  Network network(triangulation);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  for(int i = 0; i < 3; ++i)
    network.add_curve(search(corners[i], corners[(i + 1) % 3]));
  FG::order_overlapping_curves(network);
  FG::shorten(network);

  const auto is_on_geodesic = boost::make_function_property_map<FG::Edge_index>(
      [&](FG::Edge_index e) { return network.is_occupied(e.halfedge()); });
  auto region = get(CGAL::dynamic_face_property_t<std::size_t>(), triangulation);
  std::vector<double> areas(CGAL::Polygon_mesh_processing::connected_components(
      triangulation, region, CGAL::parameters::edge_is_constrained_map(is_on_geodesic)));
  for(FG::Face_index f : faces(triangulation))
    areas[get(region, f)] += area(triangulation, f);
  for(std::size_t i = 0; i < areas.size(); ++i)
    std::cout << "region " << i << " has the area " << areas[i] << '\n';
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
