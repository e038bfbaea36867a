// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_IO_APPEARANCE_H
#define CGAL_FLIP_GEODESICS_IO_APPEARANCE_H

#include <CGAL/assertions.h>

#include <cmath>
#include <string>
#include <utility>

namespace CGAL::Flip_geodesics::IO {

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Requests that writers draw curves as triangulated tubes. Viewers show tubes with their true thickness, whereas they
 * show lines one pixel wide. An object of this class is passed to `write_VTP()` and other writers along with the data,
 * and affects all curves of the call.
 *
 * A tube is a closed surface, oriented outwards. It has a cap at each end, or is a torus if the last point of the curve
 * equals the first. Around each point of the curve, the tube has a ring of corners in the plane that bisects the
 * angle of the curve at this point. If a curve bends too sharply for the radius, the tube intersects itself.
 */
class Tubes
{
public:
  /*!
   * Sets the thickness and the number of sides of tubes.
   *
   * \param radius the distance of the corners from the curve, in the unit of the mesh
   * \param number_of_sides the number of corners of a ring
   * \pre the radius is positive and finite, and `number_of_sides` is at least 3
   */
  explicit Tubes(double radius, int number_of_sides = 12)
    : m_radius(radius)
    , m_number_of_sides(number_of_sides)
  {
    CGAL_precondition_msg(radius > 0 && std::isfinite(radius), "the radius of a tube must be positive and finite");
    CGAL_precondition_msg(number_of_sides >= 3, "a tube must have at least three sides");
  }

  /// Returns the distance of the corners from the curve.
  double radius() const { return m_radius; }

  /// Returns the number of corners of a ring.
  int number_of_sides() const { return m_number_of_sides; }

private:
  double m_radius;
  int m_number_of_sides;
};

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Requests that `write_PLY()`, `write_OBJ()` and `write_VTP()` write the colors that `write_GLB()` always writes. An
 * object of this class is passed along with the data. The surface is light gray, points are black, and the curves are
 * colored red, blue, green and brown in turn.
 *
 * - In PLY, vertices and edges have the properties `red`, `green` and `blue`.
 * - In VTP, cells have an array `color` of three bytes.
 * - In OBJ, objects refer to the materials of a library, which `write_MTL()` writes.
 */
class Colors
{
public:
  /// Sets the name of the material library.
  /// \param material_library the name of a file in the directory of the OBJ file; if the name is empty, OBJ files have
  ///        no colors
  explicit Colors(std::string material_library = {})
    : m_material_library(std::move(material_library))
  {
  }

  /// Returns the name of the material library.
  const std::string& material_library() const { return m_material_library; }

private:
  std::string m_material_library;
};

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Passes the texture coordinates of the corners of faces to `write_OBJ()` and `write_GLB()`. An object of this class is
 * passed along with the data.
 *
 * The image covers the unit square, with its first row at the top. A face has no texture if a texture coordinate at one
 * of its corners is not finite. Other writers ignore textures.
 *
 * \tparam CornerMap a model of `ReadablePropertyMap` with the halfedges of the mesh as keys, which represent the
 *         corners at their targets, and `std::array<double, 2>` or points with a subscript operator as values; see
 *         `texture_coordinates()`
 */
template <class CornerMap>
struct Texture
{
  /// Constructs a texture from coordinates and an image.
  /// \param map the coordinates of corners
  /// \param picture the name of a PNG or JPEG file in the directory of the output, for `write_GLB()`; none by default
  explicit Texture(CornerMap map, std::string picture = {})
    : map(std::move(map))
    , picture(std::move(picture))
  {
  }

  CornerMap map;       ///< the coordinates of corners
  std::string picture; ///< the name of the image file
};

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Passes values at the vertices of the mesh, such as distances, indices of nearest sources, or directions, to
 * `write_VTP()` and `write_PLY()`. An object of this class is passed along with the data. Viewers can color the mesh by
 * the values.
 *
 * The value at points of curves and at separate points is NaN. Other writers ignore the values.
 *
 * \tparam VertexMap a model of `ReadablePropertyMap` with the vertices of the mesh as keys, and numbers, points or
 *         vectors with `x()`, `y()` and `z()`, or a `std::array` of numbers as values
 */
template <class VertexMap>
struct Vertex_values
{
  /// Constructs the values from a name and a map.
  /// \param name the name of the values in the file: a unique name that consists of letters, digits and underscores
  /// \param map the values at vertices
  Vertex_values(std::string name, VertexMap map)
    : name(std::move(name))
    , map(std::move(map))
  {
  }

  std::string name; ///< the name of the values in the file
  VertexMap map;    ///< the values at vertices
};

} // namespace CGAL::Flip_geodesics::IO

#endif // CGAL_FLIP_GEODESICS_IO_APPEARANCE_H
