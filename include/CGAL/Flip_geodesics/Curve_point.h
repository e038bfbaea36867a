// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CURVE_POINT_H
#define CGAL_FLIP_GEODESICS_CURVE_POINT_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

template <class TriangleMesh, class VertexPointMap>
class Embedded_metric;

/// \ingroup PkgFlipGeodesicsExtraction
/// Stores the position of a curve point on the mesh, in terms of descriptors of the mesh.
template <class TriangleMesh>
struct Curve_place
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< the face type of the mesh
  /// The halfedge type of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// A face that contains the point, and the barycentric coordinates of the point, as a
  /// `CGAL::Polygon_mesh_processing::Face_location`. The coordinates belong to the source, the target and the third
  /// vertex of `halfedge(face, mesh)`.
  std::pair<face_descriptor, std::array<double, 3>> location;

  /// If the curve crosses an edge at this point, the halfedge of this edge in the face that the curve leaves. If the
  /// point is an end of the curve or an inserted vertex on an edge, one of the two halfedges of the edge. At a vertex
  /// of the mesh or inside a face, the null halfedge.
  halfedge_descriptor halfedge = boost::graph_traits<TriangleMesh>::null_halfedge();
};

/// \ingroup PkgFlipGeodesicsExtraction
/// Stores a point of a curve with its position on the mesh and in space, and the tangent of the curve.
template <class TriangleMesh, class Point>
struct Curve_point : Curve_place<TriangleMesh>
{
  using Point_3 = Point;                                              ///< the point type
  using Vector_3 = typename Kernel_traits<Point_3>::Kernel::Vector_3; ///< the vector type of the kernel of `Point_3`

  Point_3 point; ///< the position in space
  /// The direction in space in which the curve continues, as a unit vector. At the end of the curve, it is the
  /// direction in which the curve arrives. If the curve is a single point, the vector is zero.
  Vector_3 tangent;
};

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Converts a surface point to a `CGAL::Polygon_mesh_processing::Face_location`: a pair of a face and barycentric
 * coordinates, which belong to the source, the target and the third vertex of `halfedge(face, mesh)`.
 */
template <class Triangulation>
auto face_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                   const Surface_point& p)
{
  const auto& input = triangulation.input();
  Input_halfedge_index h = p.is_vertex() ? input.outgoing(p.a) : p.halfedge;
  if(input.is_border(h)) // at most one of two consecutive outgoing halfedges is on the border
    h = p.is_vertex() ? input.next(internal::twin_index(h)) : internal::twin_index(h);
  const auto f = internal::graph_face(input.halfedge(h), mesh);
  Input_halfedge_index corner = input.index(internal::graph_halfedge(f, mesh));
  std::array<double, 3> weights = {0, 0, 0};
  for(double& weight : weights) {
    const Vertex_index v = p.is_vertex() ? input.tail(corner) : input.uncontracted_tail(corner);
    weight = v == p.a ? 1 - p.t - p.u : (v == p.b ? p.t : (v == p.c ? p.u : 0));
    corner = input.next(corner);
  }
  return std::make_pair(f, weights);
}

namespace internal {

template <class Triangulation, class TriangleMesh>
auto face_location_of(const Triangulation& triangulation, const TriangleMesh& mesh, Surface_location location)
{
  const auto& input = triangulation.input();
  if(input.is_border(location.halfedge))
    location = {twin_index(location.halfedge), {{location.weights[1], location.weights[0], 0}}};
  const auto f = graph_face(input.halfedge(location.halfedge), mesh);
  const Input_halfedge_index first = input.index(graph_halfedge(f, mesh));
  while(location.halfedge != first)
    location = rotated(input, location);
  return std::make_pair(f, location.weights);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Converts a location to a `CGAL::Polygon_mesh_processing::Face_location`. The barycentric coordinates are the weights
 * of the location. If the sum of the weights differs from one by more than 1e-6, the weights are divided by this sum.
 * \throws Invalid_location_error if the location is not a point of the surface
 */
template <class Triangulation>
auto face_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                   const Surface_location& location)
{
  internal::check_location(triangulation.input(), location);
  auto result = internal::face_location_of(triangulation, mesh, location);
  const double sum = result.second[0] + result.second[1] + result.second[2];
  if(!(std::abs(sum - 1) <= internal::weight_sum_tolerance))
    for(double& weight : result.second)
      weight /= sum;
  return result;
}

namespace internal {

template <class T, class = void>
constexpr bool is_iterator = false;
template <class T>
constexpr bool is_iterator<T, std::void_t<decltype(*std::declval<T&>())>> = true;

/* Whether `*out = T` compiles. */
template <class Output, class T, class = void>
constexpr bool takes = false;
template <class Output, class T>
constexpr bool takes<Output, T, std::void_t<decltype(*std::declval<Output&>())>> =
    std::is_assignable<decltype(*std::declval<Output&>()), T>::value;

template <class Metric, bool HAS_POINTS>
struct Points_if
{
  using Point = void;
};
template <class Metric>
struct Points_if<Metric, true>
{
  using Point = typename Metric::Point_3;
};

template <class Metric>
struct Points_of_metric : Points_if<Metric, Has_points<Metric>::value>
{
  using Number = typename Metric::Kernel::FT;
};
/* The metric need not be a complete type. */
template <class Mesh, class VertexPointMap>
struct Points_of_metric<Embedded_metric<Mesh, VertexPointMap>>
{
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Number = typename Kernel_traits<Point>::Kernel::FT;
};

/* The forms in which the points of a curve can be written: points in space, locations in faces, or all data. */
template <class Mesh, class Metric>
struct Curve_forms_of
{
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;
  using Point = typename Points_of_metric<Metric>::Point;
  using Location = std::pair<Face, std::array<double, 3>>;
  using Exact_location = std::pair<Face, std::array<typename Points_of_metric<Metric>::Number, 3>>;
  using All = std::conditional_t<std::is_void<Point>::value, Curve_place<Mesh>, Curve_point<Mesh, Point>>;
};

template <class Triangulation>
using Curve_forms = Curve_forms_of<typename Triangulation::Triangle_mesh, typename Triangulation::Metric>;

template <class T>
using Itself = T;
template <class T>
using Vector_of = std::vector<T>;

/* The first of the forms, or container of it, that an output accepts; `void` if it accepts none. */
template <class Output, template <class> class Container, class... Forms>
struct First_form
{
  using type = void;
};

template <class Output, template <class> class Container, class... Forms>
struct First_form<Output, Container, void, Forms...> : First_form<Output, Container, Forms...>
{
};

template <class Output, template <class> class Container, class Form, class... Forms>
struct First_form<Output, Container, Form, Forms...>
{
  using type =
      std::conditional_t<takes<Output, Container<Form>>, Form, typename First_form<Output, Container, Forms...>::type>;
};

template <class Forms, class Output, template <class> class Container>
struct Curve_form_of
{
  using First = typename First_form<Output, Container, typename Forms::Point, typename Forms::Location,
                                    typename Forms::Exact_location, typename Forms::All>::type;
  static_assert(is_iterator<Output>, "an output iterator is expected here; the order of the arguments is mesh, ends or "
                                     "curves, output, named parameters");
  static_assert(!is_iterator<Output> || !std::is_void<First>::value,
                "the output accepts neither points in space (a metric of edge lengths has none) nor Face_locations nor "
                "Curve_points");
  using type = std::conditional_t<std::is_void<First>::value, typename Forms::All, First>; // avoids a second error
                                                                                           // message
};

template <class Triangulation, class Output, template <class> class Container = Itself>
using Curve_form = typename Curve_form_of<Curve_forms<Triangulation>, Output, Container>::type;

template <class Mesh, class Point>
void set_tangent(Curve_point<Mesh, Point>& p, const std::array<double, 3>& direction)
{
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  if(length > 0)
    p.tangent = typename Curve_point<Mesh, Point>::Vector_3(direction[0] / length, direction[1] / length,
                                                            direction[2] / length);
}

template <class Mesh, class Point>
void set_tangent(Curve_point<Mesh, Point>& p, const Point& from, const Point& to)
{
  set_tangent(p, std::array<double, 3>{{CGAL::to_double(to.x()) - CGAL::to_double(from.x()),
                                        CGAL::to_double(to.y()) - CGAL::to_double(from.y()),
                                        CGAL::to_double(to.z()) - CGAL::to_double(from.z())}});
}

template <class Triangulation, class Form>
class Form_converter
{
  using Mesh = typename Triangulation::Triangle_mesh;
  using Forms = Curve_forms<Triangulation>;

public:
  Form_converter(const Triangulation& triangulation, const Mesh& mesh)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
  {
  }

  /* Does not set the tangent. */
  Form operator()(const Surface_point& p) const
  {
    if constexpr(std::is_same<Form, typename Forms::Point>::value) {
      return point_in_space(m_triangulation, p);
    } else if constexpr(std::is_same<Form, typename Forms::All>::value) {
      Form result;
      result.location = face_location(m_triangulation, m_mesh, p);
      if(!p.is_vertex() && !p.is_inside_face())
        result.halfedge = m_triangulation.input().halfedge(p.halfedge);
      if constexpr(!std::is_void<typename Forms::Point>::value) {
        result.point = point_in_space(m_triangulation, p);
        result.tangent = typename Form::Vector_3(0, 0, 0);
      }
      return result;
    } else {
      using Number = typename Form::second_type::value_type;
      const auto [face, weights] = face_location(m_triangulation, m_mesh, p);
      return {face, {{Number(weights[0]), Number(weights[1]), Number(weights[2])}}};
    }
  }

private:
  const Triangulation& m_triangulation;
  const Mesh& m_mesh;
};

/* Writes the points of a curve in the form that the output accepts, with directions from each point to the next. */
template <class Form, class Triangulation, class OutputIterator>
OutputIterator write_points(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                            const std::vector<Surface_point>& points, OutputIterator out)
{
  std::vector<Form> forms;
  const Form_converter<Triangulation, Form> convert(triangulation, mesh);
  for(const Surface_point& p : points)
    forms.push_back(convert(p));
  if constexpr(std::is_same<Form, typename Curve_forms<Triangulation>::All>::value &&
               Has_points<typename Triangulation::Metric>::value)
    for(std::size_t i = 0; i + 1 < forms.size(); ++i) {
      set_tangent(forms[i], forms[i].point, forms[i + 1].point);
      set_tangent(forms[i + 1], forms[i].point, forms[i + 1].point);
    }
  return std::move(forms.begin(), forms.end(), out);
}

} // namespace internal
} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_CURVE_POINT_H
