// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERPOLATED_DISTANCES_H
#define CGAL_FLIP_GEODESICS_INTERPOLATED_DISTANCES_H

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * A distance field made of distances at vertices, such as `geodesic_distances()` writes, one property map per source:
 * linear in each face for each source, and the least of these.
 *
 * Distances on a surface are not linear in faces, so this is as good as the faces are small, and best far from the
 * sources. In faces with obtuse angles its slope may be larger than one. Then the bounds of `isolines()` need not hold.
 * What a sign at vertices shows is still found, and curves are closed or end on the border.
 *
 * \cgalModels{GeodesicDistanceField}
 *
 * \tparam TriangleMesh a model of `FaceGraph`
 * \tparam VertexDistanceMap a model of `ReadablePropertyMap` with the mesh's vertices as keys and numbers as values
 */
template <class TriangleMesh, class VertexDistanceMap>
class Interpolated_distances
{
public:
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< of the mesh

  /// What is known of a place.
  struct Answer
  {
    double distance = std::numeric_limits<double>::infinity(); ///< from the nearest source
    std::size_t source = 0;                                    ///< its position among the maps
  };

  /// Interpolates between the distances of vertices.
  /// \param mesh must outlive the field
  /// \param distances of the vertices, from each of the sources
  Interpolated_distances(const TriangleMesh& mesh, std::vector<VertexDistanceMap> distances)
    : m_mesh(&mesh)
    , m_distances(std::move(distances))
  {
  }

  /// The distance from the nearest source, and which one it is; of two that are equally near the first.
  Answer operator()(face_descriptor face, const std::array<double, 3>& weights) const
  {
    Answer result;
    for(std::size_t i = 0; i < m_distances.size(); ++i) {
      const double distance = interpolated(m_distances[i], face, weights);
      if(!(result.distance <= distance)) // not a number is passed on
        result = {distance, i};
    }
    return result;
  }

private:
  double interpolated(const VertexDistanceMap& distances, face_descriptor face,
                      const std::array<double, 3>& weights) const
  {
    double sum = 0;
    std::size_t i = 0;
    for(const auto h : halfedges_around_face(halfedge(face, *m_mesh), *m_mesh)) {
      if(weights[i] != 0) // zero times infinity is not a number
        sum += weights[i] * get(distances, source(h, *m_mesh));
      ++i;
    }
    return sum;
  }

  const TriangleMesh* m_mesh;
  std::vector<VertexDistanceMap> m_distances;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERPOLATED_DISTANCES_H
