// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SURFACE_LOCATION_H
#define CGAL_FLIP_GEODESICS_SURFACE_LOCATION_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * A point of the input surface: in the face of `halfedge`, or on its border, at the barycentric `weights` of the tail of
 * `halfedge`, its head, and the third vertex. Only the ratio of the weights counts: the point is exactly
 * \f$(w_0 p_0 + w_1 p_1 + w_2 p_2) / (w_0 + w_1 + w_2)\f$. A weight of exactly zero puts it on the opposite edge, two
 * of them at a vertex.
 *
 * `halfedge` may be on the border if the third weight is zero.
 */
struct Surface_location
{
  Input_halfedge_index halfedge = null_index;  ///< a side of the face, or of the edge, that the point is on
  std::array<double, 3> weights = {{1, 0, 0}}; ///< of tail, head and third vertex; each 0 or in [1e-100, 1e100]
};

/// \ingroup PkgFlipGeodesicsCurves
/// What a location is a point of.
enum class Location_kind { VERTEX, EDGE, FACE };

/// \ingroup PkgFlipGeodesicsCurves
/// The kind of a location, by its weights of zero.
inline Location_kind kind(const Surface_location& location)
{
  const auto zeros = std::count(location.weights.begin(), location.weights.end(), 0.0);
  return zeros == 0 ? Location_kind::FACE : (zeros == 1 ? Location_kind::EDGE : Location_kind::VERTEX);
}

/// \ingroup PkgFlipGeodesicsCurves
/// Where a point to be inserted is nearly: in the piece of an input face at a gap of the word of a halfedge, as seen
/// from that halfedge's face.
struct Known_piece
{
  Halfedge_index halfedge; ///< an intrinsic halfedge
  std::size_t gap;         ///< counted along its word: the piece before crossing `gap`, or the last one
  std::size_t letters; ///< how long words may be looked at to find the point from elsewhere; the search takes from it
};

namespace internal {

/* Is halfedge `h` a side of the face on the left of `f`? */
template <class Input>
bool is_side_of(const Input& input, Input_halfedge_index h, Input_halfedge_index f)
{
  return f == h || input.next(f) == h || input.next(input.next(f)) == h;
}

/* Are two weights a point strictly between the ends? Then the sums and products of weights are normal numbers. */
inline bool is_usable_weight(double weight)
{
  return weight == 0 || (weight >= least_weight && weight <= greatest_weight);
}

template <class Input_mesh>
void check_location(const Input_mesh& input, const Surface_location& location)
{
  const Input_halfedge_index h = location.halfedge;
  if(!h.is_valid() || h.idx() >= input.number_of_halfedges())
    throw Invalid_location_error("a location has a face or halfedge that the mesh does not have");
  for(double weight : location.weights)
    if(!is_usable_weight(weight))
      throw Invalid_location_error("a weight of a location in the face of halfedge " + std::to_string(h.idx()) +
                                       " is negative, too small, too large or not a number",
                                   {static_cast<std::size_t>(h.idx())});
  if(location.weights[0] == 0 && location.weights[1] == 0 && location.weights[2] == 0)
    throw Invalid_location_error("the weights of a location in the face of halfedge " + std::to_string(h.idx()) +
                                     " are all zero",
                                 {static_cast<std::size_t>(h.idx())});
  if(!input.is_border(h) && (location.weights[1] != 0 || location.weights[2] != 0))
    check_triangle(input, h);
  if(input.is_border(h) && location.weights[2] != 0)
    throw Invalid_location_error("a location lies in the face of halfedge " + std::to_string(h.idx()) +
                                     ", which is on the border",
                                 {static_cast<std::size_t>(h.idx())});
}

/* The location with its weights told from halfedge `next(halfedge)` on. */
template <class Input_mesh>
Surface_location rotated(const Input_mesh& input, const Surface_location& location)
{
  return {input.next(location.halfedge), {{location.weights[1], location.weights[2], location.weights[0]}}};
}

/*
 * The same point, told in one way only: a vertex as (1, 0, 0) of a halfedge that starts there; a point of an edge from
 * the edge's first halfedge that is not on the border, with third weight zero; a point in a face from the face's
 * smallest halfedge. Weights keep their bits.
 */
template <class Input_mesh>
Surface_location canonical_location(const Input_mesh& input, Surface_location location)
{
  check_location(input, location);
  const Location_kind what = kind(location);
  if(input.is_border(location.halfedge))
    location = {twin_index(location.halfedge), {{location.weights[1], location.weights[0], 0}}};
  switch(what) {
  case Location_kind::VERTEX:
    while(location.weights[0] == 0)
      location = rotated(input, location);
    location.weights = {{1, 0, 0}};
    return location;
  case Location_kind::EDGE: {
    while(location.weights[2] != 0)
      location = rotated(input, location);
    const Input_halfedge_index t = twin_index(location.halfedge);
    if(!is_first_side(location.halfedge) && !input.is_border(t))
      location = {t, {{location.weights[1], location.weights[0], 0}}};
    return location;
  }
  case Location_kind::FACE: {
    const Input_halfedge_index h = location.halfedge, hn = input.next(h), hp = input.next(hn);
    while(location.halfedge != (std::min)({h, hn, hp}))
      location = rotated(input, location);
    return location;
  }
  }
  return location;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SURFACE_LOCATION_H
