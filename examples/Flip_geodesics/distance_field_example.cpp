// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes exact distances from three sources: a vertex, a point inside a face, and a curve along an edge. Also
// computes shortest paths to the nearest source, isolines, and the boundaries of the Voronoi diagram of the sources.
//
//   distance_field_example MESH
//
// Writes distance_field_paths.vtp, distance_field_isolines.vtp and distance_field_regions.vtp, with the mesh.

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/isolines.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Weights = std::array<double, 3>;

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  const Triangulation triangulation(mesh);
  //! [Sources]
  FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);

  const auto faces = mesh.number_of_faces();
  field.add_source(triangulation.index(Mesh::Vertex_index(0)));
  const auto face = std::make_pair(Mesh::Face_index(faces / 2), Weights{0.2, 0.3, 0.5});
  field.add_source(surface_location(triangulation, mesh, face));
  const auto h = mesh.halfedge(Mesh::Face_index(faces / 4)); // a curve of one edge
  field.add_curve(std::vector<FG::Surface_location>{surface_location(triangulation, mesh, mesh.source(h)),
                                                    surface_location(triangulation, mesh, mesh.target(h))});
  std::cout << field.compute().windows << " windows on " << faces << " faces\n";
  //! [Sources]

  std::vector<std::vector<Point_3>> paths, curves, regions;
  double farthest = 0;
  for(Mesh::Face_index::size_type i = 0; i < faces; i += faces / 20 + 1) {
    const auto middle =
        surface_location(triangulation, mesh, std::make_pair(Mesh::Face_index(i), Weights{0.4, 0.3, 0.3}));
    const double distance = field.distance(middle);
    farthest = (std::max)(farthest, distance < 1e300 ? distance : 0); // the distance is infinite on other components
    paths.emplace_back();
    field.path(middle, std::back_inserter(paths.back()));
  }
  std::vector<FG::Isoline<Mesh>> isolines;
  FG::isolines(mesh, field, std::vector<double>{farthest / 4, farthest / 2}, std::back_inserter(isolines),
               farthest / 200);
  for(const auto& isoline : isolines)
    curves.push_back(isoline.points);
  std::vector<FG::Voronoi_boundary<Mesh>> boundaries;
  FG::voronoi_boundaries(mesh, field, std::back_inserter(boundaries), farthest / 200);
  for(const auto& boundary : boundaries)
    regions.push_back(boundary.points);
  FG::IO::write_VTP("distance_field_paths.vtp", mesh, paths);
  FG::IO::write_VTP("distance_field_isolines.vtp", mesh, curves);
  FG::IO::write_VTP("distance_field_regions.vtp", mesh, regions);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
