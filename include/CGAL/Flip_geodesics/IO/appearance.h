// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_IO_APPEARANCE_H
#define CGAL_FLIP_GEODESICS_IO_APPEARANCE_H

#include <CGAL/assertions.h>

#include <cmath>
#include <string>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace IO {

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Makes the writers draw curves as tubes of triangles, which viewers show as thick as they are, where lines are one
 * pixel wide. To be given to `write_VTP()` and the others among what is to be written; it holds for all curves of the
 * call.
 *
 * A tube is a closed surface, oriented outwards: with a cap at either end, or a ring if the curve's last point is its
 * first. It has a ring of corners about each point of the curve, in the plane that halves the angle there. Where a
 * curve bends by more than its radius allows, the tube passes through itself.
 */
class Tubes
{
public:
  /*!
   * Says how thick the tubes are, and how round.
   *
   * \param radius the distance of the corners from the curve, in the units of the mesh
   * \param number_of_sides how many corners a ring has
   * \pre the radius is positive and finite, and there are three sides or more
   */
  explicit Tubes(double radius, int number_of_sides = 12)
    : m_radius(radius)
    , m_number_of_sides(number_of_sides)
  {
    CGAL_precondition_msg(radius > 0 && std::isfinite(radius), "the radius of a tube is positive and finite");
    CGAL_precondition_msg(number_of_sides >= 3, "a tube has three sides or more");
  }

  /// The distance of the corners from the curve.
  double radius() const { return m_radius; }

  /// How many corners a ring has.
  int number_of_sides() const { return m_number_of_sides; }

private:
  double m_radius;
  int m_number_of_sides;
};

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Among what `write_OBJ()` and `write_GLB()` write: the corners of the mesh's faces have places in a picture. The picture
 * is the unit square, with its first row at the top. A face that has a corner without a place, with a coordinate that is
 * no finite number, has none. The other writers take no notice.
 *
 * \tparam CornerMap a model of `ReadablePropertyMap` with the mesh's halfedges as keys, which stand for the corners at
 *         their targets, and `std::array<double, 2>`, or points with a subscript, as values; see `texture_coordinates()`
 */
template <class CornerMap>
struct Texture
{
  /// Constructs it from the places and the name.
  /// \param map the places of corners
  /// \param picture the name of a file beside the one that is written, PNG or JPEG, for `write_GLB()`; none by default
  explicit Texture(CornerMap map, std::string picture = {})
    : map(std::move(map))
    , picture(std::move(picture))
  {
  }

  CornerMap map;       ///< the places of corners
  std::string picture; ///< the name of a file
};

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Among what `write_VTP()` and `write_PLY()` write: values at the vertices of the mesh, such as distances, the numbers
 * of nearest sources, or directions, by which viewers colour it. The points of curves, and loose points, have no value,
 * which is not a number. The other writers take no notice.
 *
 * \tparam VertexMap a model of `ReadablePropertyMap` with the mesh's vertices as keys, and numbers, points or vectors
 *         with `x()`, `y()` and `z()`, or a `std::array` of numbers as values
 */
template <class VertexMap>
struct Vertex_values
{
  /// Constructs it from the name and the values.
  /// \param name letters, digits and underscores, as the files have it; each name once
  /// \param map the values at vertices
  Vertex_values(std::string name, VertexMap map)
    : name(std::move(name))
    , map(std::move(map))
  {
  }

  std::string name; ///< as the files have it
  VertexMap map;    ///< the values at vertices
};

} // namespace IO
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_IO_APPEARANCE_H
