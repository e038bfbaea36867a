// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_IO_TEXTURE_H
#define CGAL_FLIP_GEODESICS_IO_TEXTURE_H

#include <string>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace IO {

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

} // namespace IO
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_IO_TEXTURE_H
