// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Uses a Polyhedron_3 with points of an exact kernel as the mesh, and a user-defined traits class that counts flips.
//
//   own_mesh_and_kernel_example MESH

#include <CGAL/Flip_geodesics/geodesic_path.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Polyhedron_3<Kernel>;
using Default_traits = FG::Intrinsic_triangulation_traits<Kernel, double>;

// A model of IntrinsicTriangulationTraits. It replaces the functor that computes the geometry of a flip.
struct Counting_traits : Default_traits
{
  struct Flip : Default_traits::Flip
  {
    std::size_t* count;

    template <class... Geometries>
    Flipped_geometry operator()(const Geometries&... geometries) const
    {
      ++*count;
      return Default_traits::Flip::operator()(geometries...);
    }
  };

  Flip flip_object() const
  {
    Flip flip;
    flip.count = count;
    return flip;
  }

  std::size_t* count = nullptr;
};

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.empty())
    throw std::invalid_argument("specify the file of a triangle mesh");

  std::size_t count = 0;
  Counting_traits traits;
  traits.count = &count;
  const auto source = *vertices(mesh).begin();
  const auto target = *std::next(vertices(mesh).begin(), num_vertices(mesh) / 2);
  std::vector<Kernel::Point_3> points;
  const auto result =
      FG::geodesic_path(mesh, source, target, std::back_inserter(points), CGAL::parameters::geom_traits(traits));
  std::cout << "A geodesic of length " << result.length() << " from " << points.front() << " to " << points.back()
            << "; its computation took " << count << " flips.\n";
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
