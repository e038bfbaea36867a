// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes texture coordinates that place an image on a mesh like a decal, centered at the middle of a face.
//
//   decal_example MESH FACE SIZE [IMAGE]
//
// SIZE is the side length of the image on the surface. Writes decal.obj, and decal.glb for browsers and Blender, which
// display the PNG or JPEG file IMAGE if it lies in the same folder as decal.glb.

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/texture_coordinates.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace FG = CGAL::Flip_geodesics;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Texture_map = Mesh::Property_map<Mesh::Halfedge_index, std::array<double, 2>>;

template <class Number>
Number number(const std::string& text)
{
  std::istringstream in(text);
  Number result = 0;
  if(!(in >> result && in.eof()))
    throw std::invalid_argument(text + " is not a number");
  return result;
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 4 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh, a face, and the side length of the image");
  const Mesh::Face_index face(number<Mesh::size_type>(argv[2]));
  if(face >= mesh.number_of_faces())
    throw std::invalid_argument("the mesh has no such face");

  // Texture coordinates of a corner are stored at the halfedge that ends at it. The image is oriented so that its
  // direction to the right is that of the halfedge of the face.
  const Texture_map corners = mesh.add_property_map<Mesh::Halfedge_index, std::array<double, 2>>("h:texture").first;
  const std::pair middle(face, std::array<double, 3>{1.0 / 3, 1.0 / 3, 1.0 / 3});
  const std::pair right(mesh.halfedge(face), 0.0);
  //! [Decal]
  const FG::Texture_report report = FG::texture_coordinates(mesh, middle, right, number<double>(argv[3]), corners);
  //! [Decal]
  std::cout << report.faces << " faces have texture coordinates; " << report.torn
            << " of them are laid out separately\n";

  FG::IO::write_OBJ("decal.obj", mesh, FG::IO::Texture<Texture_map>(corners));
  FG::IO::write_GLB("decal.glb", mesh, FG::IO::Texture<Texture_map>(corners, argc > 4 ? argv[4] : ""));
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
