// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_TANGENT_SPACES_H
#define CGAL_FLIP_GEODESICS_TANGENT_SPACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Plane_triangle.h>
#include <CGAL/Flip_geodesics/intrinsic_faces.h>

#include <boost/math/constants/constants.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsOperators
 *
 * Directions at the vertices of an intrinsic triangulation: the angle of each halfedge counterclockwise from the
 * reference direction at its tail, in radians. About a vertex inside the surface the angles are scaled to sum up to
 * \f$2\pi\f$ [KCPS13]. At the border they are left as they are, and the reference is the first halfedge
 * counterclockwise from the border. A snapshot: flips of the triangulation do not reach it. Linear in the mesh.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulation`
 */
template <class Triangulation>
class Tangent_spaces
{
public:
  /// Lays out the tangent plane of each vertex.
  /// \param faces all faces, from `intrinsic_faces()`
  /// \throws Invalid_mesh_error for a non-manifold vertex, at which several umbrellas meet
  Tangent_spaces(const Triangulation& triangulation, const std::vector<Intrinsic_face>& faces)
    : m_angles(static_cast<std::size_t>(triangulation.number_of_halfedges()), 0)
    , m_corners(m_angles.size(), 0)
    , m_references(static_cast<std::size_t>(triangulation.number_of_vertices()), null_index)
  {
    for(const Intrinsic_face& face : faces) {
      const internal::Plane_triangle triangle(face.lengths);
      for(int i = 0; i < 3; ++i)
        m_corners[face.halfedges[i]] = triangle.angle(i);
    }
    Marks is_laid_out(static_cast<std::size_t>(triangulation.number_of_halfedges()), 0);
    for(Vertex_index v : internal::descriptors<Vertex_index>(triangulation.number_of_vertices()))
      lay_out(triangulation, v, is_laid_out);
    check_umbrellas(triangulation, is_laid_out);
  }

  /// The halfedge in the reference direction of vertex `v`, `null_index` if it is isolated.
  Halfedge_index reference(Vertex_index v) const { return m_references[v]; }

  /// The angle of halfedge `h` at its tail.
  double angle(Halfedge_index h) const { return m_angles[h]; }

  /// The corner at the tail of `h` in the face on its left, scaled as the angles are.
  double corner(Halfedge_index h) const { return m_corners[h]; }

  /// By how much a direction turns when it is carried along `h`, from the reference of the tail to that of the head.
  double transport(Halfedge_index h) const
  {
    return m_angles[Triangulation::twin(h)] + boost::math::constants::pi<double>() - m_angles[h];
  }

private:
  using Marks = internal::Indexed_by<Halfedge_index, std::vector<char>>;

  void lay_out(const Triangulation& triangulation, Vertex_index v, Marks& is_laid_out)
  {
    const Halfedge_index some = triangulation.outgoing(v);
    if(some == null_index)
      return;
    Halfedge_index first = some;
    bool is_border = false;
    for(Halfedge_index h = triangulation.clockwise(first); h != some; h = triangulation.clockwise(h)) {
      if(h == null_index) {
        is_border = true;
        break;
      }
      first = h;
    }
    if(!is_border)
      first = some;
    m_references[v] = first;

    double sum = 0;
    Halfedge_index h = first;
    do {
      m_angles[h] = sum;
      is_laid_out[h] = 1;
      sum += triangulation.is_border(h) ? 0 : m_corners[h];
      h = triangulation.counterclockwise(h);
    } while(h != first && h != null_index);
    if(is_border)
      return;
    const double scale = boost::math::constants::two_pi<double>() / sum;
    do {
      m_angles[h] *= scale;
      m_corners[h] *= scale;
      h = triangulation.counterclockwise(h);
    } while(h != first);
  }

  // A vertex is laid out by the umbrella of one of its halfedges.
  static void check_umbrellas(const Triangulation& triangulation, const Marks& is_laid_out)
  {
    for(Halfedge_index h : internal::descriptors<Halfedge_index>(triangulation.number_of_halfedges()))
      if(is_laid_out[h] == 0) {
        const Vertex_index v = triangulation.tail(h);
        throw Invalid_mesh_error("several umbrellas of faces meet at vertex " + std::to_string(v.idx()) +
                                     ", which has no tangent space; duplicate it for each of them",
                                 {static_cast<std::size_t>(v.idx())});
      }
  }

  internal::Indexed_by<Halfedge_index, std::vector<double>> m_angles, m_corners;
  internal::Indexed_by<Vertex_index, std::vector<Halfedge_index>> m_references;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_TANGENT_SPACES_H
