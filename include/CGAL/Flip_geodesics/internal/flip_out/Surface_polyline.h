// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_SURFACE_POLYLINE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_SURFACE_POLYLINE_H

#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>
#include <CGAL/Flip_geodesics/internal/surface/locations_in_faces.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Canonical locations, each two in a row in a common input face: the points of a straight line, or of several. */
using Surface_polyline = std::vector<Surface_location>;

/* Is it one location twice? */
inline bool is_point(const Surface_polyline& polyline)
{
  return polyline.size() == 2 && polyline[0].halfedge == polyline[1].halfedge &&
         polyline[0].weights == polyline[1].weights;
}

/* Makes a polyline canonical; a closed one ends with its first point again.
 * \throws Invalid_curve_error for too few points, or two in a row that lie in no common face */
template <class Input_mesh>
std::vector<Surface_location> canonical_polyline(const Input_mesh& input, const std::vector<Surface_location>& polyline,
                                                 bool is_closed)
{
  std::vector<Surface_location> result;
  for(const Surface_location& location : polyline)
    result.push_back(canonical_location(input, location));
  if(result.size() < (is_closed ? 3u : 2u))
    throw Invalid_curve_error("a polyline needs two points, a closed one three");
  if(is_closed)
    result.push_back(result.front());
  for(std::size_t i = 0; i + 1 < result.size(); ++i)
    if(common_face(input, result[i], result[i + 1]) == null_index)
      throw Invalid_curve_error("points " + std::to_string(i) + " and " + std::to_string(i + 1) +
                                    " of a polyline do not lie in a common face",
                                {i, i + 1});
  return result;
}

/* The weights of a canonical location in the face of h, also of a vertex, summing to one. */
template <class Input_mesh>
std::array<double, 3> normalized_weights(const Input_mesh& input, const Surface_location& p, Input_halfedge_index h)
{
  std::array<double, 3> w;
  if(kind(p) == Location_kind::VERTEX) {
    const Vertex_index v = input.tail(p.halfedge);
    const Input_halfedge_index hn = input.next(h);
    return {
        {input.tail(h) == v ? 1.0 : 0.0, input.tail(hn) == v ? 1.0 : 0.0, input.tail(input.next(hn)) == v ? 1.0 : 0.0}};
  }
  w = weights_in_face(input, p, h);
  const double sum = w[0] + w[1] + w[2];
  return {{w[0] / sum, w[1] / sum, w[2] / sum}};
}

/* Measures and divides polylines, by the metric of a triangulation. */
template <class Triangulation>
class Polyline_measure
{
public:
  explicit Polyline_measure(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  double length(const Surface_polyline& polyline) const
  {
    double sum = 0;
    for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
      sum += distance(polyline[i], polyline[i + 1]);
    return sum;
  }

  /* The two parts before and after the point at a distance from the start. */
  std::pair<Surface_polyline, Surface_polyline> divided(const Surface_polyline& polyline,
                                                        double distance_from_start) const
  {
    std::size_t i = 0;
    double step = 0;
    for(; i + 1 < polyline.size(); ++i) {
      step = distance(polyline[i], polyline[i + 1]);
      if(distance_from_start <= step || i + 2 == polyline.size())
        break;
      distance_from_start -= step;
    }
    Surface_polyline first(polyline.begin(), polyline.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    Surface_polyline second(polyline.begin() + static_cast<std::ptrdiff_t>(i) + 1, polyline.end());
    const Surface_location middle =
        step > 0 ? between(polyline[i], polyline[i + 1], (std::min)((std::max)(distance_from_start / step, 0.0), 1.0))
                 : polyline[i];
    first.push_back(middle);
    second.insert(second.begin(), middle);
    return {first, second};
  }

private:
  double distance(const Surface_location& p, const Surface_location& q) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index h = common_face(input, p, q);
    const auto d = barycentric_difference(normalized_weights(input, p, h), normalized_weights(input, q, h));
    const auto f = input_face_geometry(m_triangulation, h);
    return std::abs(d[1] * std::complex<double>(f[0].x, f[0].y) - d[2] * std::complex<double>(f[2].x, f[2].y));
  }

  Surface_location between(const Surface_location& p, const Surface_location& q, double t) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index h = common_face(input, p, q);
    const auto a = normalized_weights(input, p, h), b = normalized_weights(input, q, h);
    Surface_location result = {h, {{0, 0, 0}}};
    for(int i = 0; i < 3; ++i) {
      const double weight = (1 - t) * a[i] + t * b[i];
      result.weights[i] = weight < zero_weight ? 0 : weight; // what lies there by rounding lies on the edge
    }
    return canonical_location(input, result);
  }

  const Triangulation& m_triangulation;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_SURFACE_POLYLINE_H
