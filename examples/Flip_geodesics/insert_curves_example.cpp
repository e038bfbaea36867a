// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Inserts an isoline, and a geodesic that crosses it, into a mesh, and separates the regions that these curves bound.
//
//   insert_curves_example MESH
//
// Writes region_0.vtp, region_1.vtp and so on.

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/insert_curves.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");

  const Mesh::Vertex_index source(0), target(static_cast<Mesh::size_type>(mesh.number_of_vertices() / 2));
  const Triangulation triangulation(mesh);
  FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
  field.add_source(FG::Vertex_index(0));
  field.compute();
  const double level = field.distance(FG::Vertex_index(static_cast<FG::Index>(target))) / 2;
  std::vector<FG::Isoline<Mesh>> isolines;
  FG::isolines(mesh, field, std::vector<double>{level}, std::back_inserter(isolines), level / 1000);
  std::vector<std::vector<Location>> curves(1);
  FG::geodesic_path(mesh, source, target, std::back_inserter(curves.front()));
  for(const FG::Isoline<Mesh>& isoline : isolines)
    curves.push_back(isoline.locations);

  //! [Insert]
  const auto is_marked = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_marked", false).first;
  const auto region = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region", 0).first;
  const FG::Curve_insertion_report report =
      FG::insert_curves(mesh, curves, CGAL::parameters::edge_is_constrained_map(is_marked).face_patch_map(region));
  //! [Insert]
  std::cout << "Inserted: " << report.new_vertices << " vertices, " << report.regions << " regions.\n";

  for(std::size_t i = 0; i < report.regions; ++i) {
    Mesh part;
    CGAL::copy_face_graph(CGAL::Face_filtered_graph<Mesh>(mesh, i, region), part);
    FG::IO::write_VTP("region_" + std::to_string(i) + ".vtp", part);
  }
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
