// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_MOLLIFIED_METRIC_H
#define CGAL_FLIP_GEODESICS_MOLLIFIED_METRIC_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>
#include <CGAL/Flip_geodesics/internal/surface/least_stretch.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* The point type of a metric, `void` if it has none. */
template <class Metric, class = void>
struct Metric_point
{
  using type = void;
};

template <class Metric>
struct Metric_point<Metric, std::void_t<typename Metric::Point_3>>
{
  using type = typename Metric::Point_3;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * Another metric with one small length added to every edge [Sharp, Crane, A Laplacian for Nonmanifold Triangle Meshes,
 * section 4.5]. It is so large that each face satisfies the triangle inequality with a margin. It makes meshes with
 * edges of length zero and faces without area usable, at the price of a slightly different surface: an explicit choice.
 *
 * Curves are geodesics of the changed surface. They are still read off on the mesh's own points, if it has any.
 *
 * \tparam Metric `Embedded_metric` or `Edge_length_metric`
 *
 * \cgalModels{IntrinsicMetric}
 */
template <class Metric>
class Mollified_metric : private Metric
{
  using Base = Metric;

public:
  using Mesh = typename Base::Mesh;                            ///< the mesh, numbered
  using Kernel = typename Base::Kernel;                        ///< that of the other metric
  using Point_3 = typename internal::Metric_point<Base>::type; ///< that of the other metric, `void` if it has no points

  /*!
   * Finds the length to add; linear in the mesh.
   *
   * \param mesh the triangle mesh of the metric
   * \param factor the margin of the triangle inequality, relative to the mean edge length; 1e-5 unless given
   * \pre 0 < factor < 1
   * \throws Invalid_coordinate_error if an edge's length is negative or not a finite number
   * \throws Invalid_mesh_error if a face is not a triangle
   */
  template <class TriangleMesh>
  Mollified_metric(const TriangleMesh& mesh, const Metric& metric, double factor = internal::default_mollification)
    : Base(metric)
  {
    CGAL_precondition(0 < factor && factor < 1);
    const Mesh indexed(mesh);
    m_added = needed_length(indexed, factor * mean_length(indexed));
    if constexpr(!std::is_empty<Place>::value)
      m_least_stretch =
          (std::min)(1., internal::least_stretch_of_faces(static_cast<const Base&>(*this), *this, indexed));
  }

  /// The length that was added to every edge; zero if none was needed.
  double added_length() const { return m_added; }

  /// The length of halfedge `h`. \throws Invalid_coordinate_error
  double length(const Mesh& mesh, Input_halfedge_index h) const { return internal::usable_length(*this, mesh, h); }

  /// The length of halfedge `h` whatever it is, for a search that only passes by.
  double weight(const Mesh& mesh, Input_halfedge_index h) const { return Base::weight(mesh, h) + m_added; }

  using typename Base::Place;

  /// The same, where the places of the two ends are at hand.
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const
  {
    return Base::weight(mesh, h, tail, head) + m_added;
  }

  using Base::place;

  /// The other metric's lower bound, and less where lengths are rounded in faces of little area. Lengths that are added
  /// shorten no path: what they add to the squares of the sides are the squares of sides of a triangle.
  double distance_lower_bound(const Place& p, const Place& q) const
  {
    return m_least_stretch * Base::distance_lower_bound(p, q);
  }

  /// The point of vertex `v`. Only over `Embedded_metric`.
  decltype(auto) point(const Mesh& mesh, Vertex_index v) const { return Base::point(mesh, v); }

  /// The vectors of the halfedges `h`, `next(h)`, `previous(h)` of an input face.
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    const auto [a, b, c] = internal::face_lengths(*this, mesh, h);
    return traits.construct_face_from_lengths_object()(a, b, c);
  }

  /// The same face in exact numbers; the lengths are taken as the doubles they are.
  internal::Exact_face exact_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    return internal::exact_face_from_lengths(internal::face_lengths(*this, mesh, h));
  }

  /// False: lengths do not say what lies in one plane.
  bool sine_in_plane(const Mesh&, const Crossing_word&, const Crossing_word&, Index, internal::Flat_edges&, Sign&) const
  {
    return false;
  }

  /// Returns whether the other metric rounds numbers of the mesh to doubles. Then nothing is certified.
  bool is_rounded(const Mesh& mesh) const { return Base::is_rounded(mesh); }

private:
  double checked_weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    const double weight = Base::weight(mesh, h);
    if(!(weight >= 0) || std::isinf(weight))
      internal::throw_unusable_length(weight, mesh.tail(h), mesh.tail(internal::twin_index(h)));
    return weight;
  }

  double mean_length(const Mesh& mesh) const
  {
    double sum = 0;
    for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(mesh.number_of_halfedges()))
      sum += internal::is_first_side(h) ? checked_weight(mesh, h) : 0;
    return mesh.number_of_halfedges() == 0 ? 0 : sum / (mesh.number_of_halfedges() / 2);
  }

  // Adding e to three sides adds e to the margin of each triangle inequality.
  double needed_length(const Mesh& mesh, double margin) const
  {
    double needed = 0;
    for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(mesh.number_of_halfedges())) {
      if(mesh.is_border(h))
        continue;
      internal::check_triangle(mesh, h);
      const Input_halfedge_index hn = mesh.next(h), hp = mesh.next(hn);
      needed = (std::max)(needed, margin + Base::weight(mesh, h) - Base::weight(mesh, hn) - Base::weight(mesh, hp));
    }
    return needed;
  }

  double m_added = 0;
  double m_least_stretch = 1;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_MOLLIFIED_METRIC_H
