// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Another mesh type, with points of an exact kernel, and traits of one's own: here they count what the engine computes.
//
//   own_mesh_and_kernel_example [MESH]

#include "polylines_io.h"
#include "torus.h"

#include <CGAL/Flip_geodesics/geodesic_curves.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Polyhedron_3<Kernel>;
using Default_traits = CGAL::Flip_geodesics::Intrinsic_triangulation_traits<Kernel>;

// A model of IntrinsicTriangulationTraits: all arithmetic of the engine goes through such a class.
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
{
  Mesh mesh;
  const bool has_mesh = argc > 1 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : make_torus(mesh) > 0;
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.empty()) {
    std::cerr << "This is not a triangle mesh.\n";
    return EXIT_FAILURE;
  }

  std::size_t count = 0;
  Counting_traits traits;
  traits.count = &count;
  std::vector<Kernel::Point_3> points;
  const auto source = *vertices(mesh).begin();
  const auto target = *std::next(vertices(mesh).begin(), num_vertices(mesh) / 2);
  try {
    CGAL::Flip_geodesics::geodesic_path(mesh, source, target, std::back_inserter(points),
                                        CGAL::parameters::geom_traits(traits));
  } catch(const CGAL::Flip_geodesics::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::cout << "A geodesic of " << points.size() << " points, for which " << count << " flips were computed.\n";
  return write_polylines<Kernel::Point_3>("own_mesh.polylines.txt", {points}) && std::cout.flush() ? EXIT_SUCCESS
                                                                                                   : EXIT_FAILURE;
}
