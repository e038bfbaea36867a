// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SURFACE_POINTS_H
#define CGAL_FLIP_GEODESICS_SURFACE_POINTS_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Nearest_face.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Flip_geodesics {

template <class TriangleMesh>
struct Curve_place;

namespace internal {

/* Returns the barycentric coordinates of a point, of which those up to `snap` become 0. If they are not between 0 and 1
 * or do not sum to one, calls `refuse(before, after)` with the parts of a message around a name of the point; the
 * function must throw. */
template <class Refuse>
std::array<double, 3> snapped_weights(std::array<double, 3> weights, double snap, const Refuse& refuse)
{
  double sum = 0;
  for(double& weight : weights) {
    if(!(weight >= -snap && weight <= 1 + weight_sum_tolerance))
      refuse("a barycentric coordinate of ", " is " + internal::written(weight) + ", but must be between 0 and 1");
    sum += weight;
    weight = weight <= snap ? 0 : weight;
  }
  if(!(std::abs(sum - 1) <= weight_sum_tolerance))
    refuse("the barycentric coordinates of ", " sum to " + internal::written(sum) + ", not to 1");
  return weights;
}

} // namespace internal

/// \ingroup PkgFlipGeodesicsBuilders
/// Returns the location of vertex `v` of a mesh. \throws Vertex_out_of_range_error if `v` does not belong to the mesh
/// or is isolated
template <class Triangulation>
Surface_location surface_location(
    const Triangulation& triangulation, const typename Triangulation::Triangle_mesh&,
    typename boost::graph_traits<typename Triangulation::Triangle_mesh>::vertex_descriptor v)
{
  const Vertex_index i = triangulation.input().index(v);
  if(i == null_index || triangulation.input().outgoing(i) == null_index)
    internal::throw_no_face_at(i);
  return triangulation.location(i);
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Converts a `CGAL::Polygon_mesh_processing::Face_location`, that is, a face and barycentric coordinates, to a
 * `Surface_location`. The first coordinate belongs to the source of `halfedge(face, mesh)`, the second to the target of
 * this halfedge, and the third to the remaining vertex of the face. The coordinates are rounded to `double`, even if
 * their number type is exact.
 *
 * Coordinates of at most `snap` count as exactly zero. For example, if rounding errors have led to a coordinate
 * of -5.6e-17 instead of zero, the point nevertheless lies on the intended edge or vertex.
 *
 * \param triangulation the triangulation
 * \param mesh the mesh of the triangulation
 * \param location the face and the coordinates
 * \param snap the threshold up to which a barycentric coordinate counts as zero: at least 0 and less than 1/3, by
 *        default 1e-12
 * \throws Invalid_location_error if the face is null or does not belong to the mesh; if a coordinate is less than
 *         `-snap` or NaN; or if the three coordinates do not sum to one within 1e-6
 *
 * Complexity: constant.
 */
template <class Triangulation, class FT>
Surface_location surface_location(
    const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
    const std::pair<typename boost::graph_traits<typename Triangulation::Triangle_mesh>::face_descriptor,
                    std::array<FT, 3>>& location,
    double snap)
{
  if(!internal::is_face(location.first, mesh))
    throw Invalid_location_error("the face of a location does not belong to the mesh");
  const Input_halfedge_index h = triangulation.input().index(internal::graph_halfedge(location.first, mesh));
  const auto refuse = [h](const std::string& before, const std::string& after) {
    internal::throw_naming<Invalid_location_error>(before, "a location in the face of halfedge ", h, after);
  };
  const auto weight = [&](std::size_t i) { return internal::imported_number(location.second[i]); };
  const Surface_location result = {h, internal::snapped_weights({{weight(0), weight(1), weight(2)}}, snap, refuse)};
  internal::check_location(triangulation.input(), result);
  return result;
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Converts a `Face_location` to a `Surface_location`; barycentric coordinates of at most 1e-12 count as zero.
/// \throws Invalid_location_error if the point does not lie on the mesh
template <class Triangulation, class FT>
Surface_location surface_location(
    const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
    const std::pair<typename boost::graph_traits<typename Triangulation::Triangle_mesh>::face_descriptor,
                    std::array<FT, 3>>& location)
{
  return surface_location(triangulation, mesh, location, internal::default_snap);
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Converts a `Surface_point` to a `Surface_location`.
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh&,
                                  const Surface_point& point)
{
  return internal::surface_location(triangulation, point);
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Converts a `Curve_place`, a `Curve_point` or a `Curve_sample` to a `Surface_location`, using its member `location`.
/// \throws Invalid_location_error if the point does not lie on the mesh
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                                  const Curve_place<typename Triangulation::Triangle_mesh>& place)
{
  return surface_location(triangulation, mesh, place.location);
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Returns a `Surface_location` unchanged.
template <class Triangulation>
Surface_location surface_location(const Triangulation&, const typename Triangulation::Triangle_mesh&,
                                  const Surface_location& location)
{
  return location;
}

namespace internal {

/* Returns half the coordinates of a point: differences of such numbers are finite. */
template <class Point>
Place_in_space half_of(const Point& p)
{
  return {{imported_number(p.x()) / 2, imported_number(p.y()) / 2, imported_number(p.z()) / 2}};
}

/* Checks a face of the mesh, and returns its corners with halved coordinates. */
template <class Triangulation>
struct Halved_corners
{
  const Triangulation* triangulation;
  const typename Triangulation::Triangle_mesh* mesh;

  template <class Face>
  Triangle_places operator()(Face f) const
  {
    const auto& input = triangulation->input().uncontracted();
    const Input_halfedge_index h = input.index(graph_halfedge(f, *mesh));
    check_triangle(input, h);
    const Input_halfedge_index hn = input.next(h), hp = input.next(hn);
    const Triangle_places corners = {{corner(h), corner(hn), corner(hp)}};
    check_sides(corners, {{h, hn, hp}});
    return corners;
  }

private:
  // Squares of distances from one side would underflow if another one were longer by more than the range of lengths.
  void check_sides(const Triangle_places& corners, const std::array<Input_halfedge_index, 3>& sides) const
  {
    std::array<double, 3> lengths;
    for(std::size_t i = 0; i < 3; ++i) {
      const Place_in_space d = difference(corners[i], corners[(i + 1) % 3]);
      lengths[i] = (std::max)({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
    }
    const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
    if(*longest / greatest_length * least_length > *shortest && *shortest > 0) {
      const auto& input = triangulation->input().uncontracted();
      const auto i = static_cast<std::size_t>(longest - lengths.begin());
      const Place_in_space d = difference(corners[i], corners[(i + 1) % 3]);
      throw_unusable_length(2 * std::hypot(d[0], d[1], d[2]), input.tail(sides[i]), input.tail(input.next(sides[i])));
    }
  }

  Place_in_space corner(Input_halfedge_index h) const
  {
    const auto& input = triangulation->input().uncontracted();
    const Vertex_index v = input.tail(h);
    const Place_in_space p = half_of(triangulation->metric().point(input, v));
    if(!are_finite(p))
      throw_naming<Invalid_coordinate_error>("vertex ", v, " has a coordinate that is not a finite number");
    return p;
  }
};

template <class Triangulation>
using Nearest_mesh_face = Nearest_face<typename Triangulation::Triangle_mesh, Halved_corners<Triangulation>>;

template <class Triangulation, class Point>
Surface_location nearest_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                                  Nearest_mesh_face<Triangulation>& nearest_face, const Point& point)
{
  const Place_in_space from = half_of(point);
  if(!are_finite(from))
    throw Invalid_location_error("a point in space has a coordinate that is not a finite number");
  const auto found = nearest_face(from);
  if(found.face == boost::graph_traits<typename Triangulation::Triangle_mesh>::null_face())
    throw Invalid_location_error("the mesh has no faces, so no nearest point exists");
  return Flip_geodesics::surface_location(triangulation, mesh, std::make_pair(found.face, found.nearest.weights),
                                          nearest_point_snap);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Returns the location of the point of the mesh that is nearest to a point in space, up to rounding errors. If several
 * points are equally near, one of them is chosen.
 *
 * The location is moved to an edge if one of its barycentric coordinates is at most 1e-9, and to a vertex if two of
 * them are. Functions of this package that take many points use a tree of bounding boxes, and obtain the same
 * locations. If many points must be located one by one, `CGAL::Polygon_mesh_processing::locate_with_AABB_tree()`, which
 * returns `Face_location`s, is faster than this function.
 *
 * \throws Invalid_location_error if the mesh has no face, or a coordinate of the point is not finite
 * \throws Invalid_coordinate_error if a coordinate of the mesh is not finite, or if one side of a face is more than
 *         1e140 times as long as another side of this face
 * \throws Invalid_mesh_error if a face is not a triangle
 *
 * Complexity: linear in the number of faces of the mesh.
 */
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                                  const typename Triangulation::Metric::Point_3& point)
{
  internal::Nearest_mesh_face<Triangulation> nearest_face(mesh, {&triangulation, &mesh});
  return internal::nearest_location(triangulation, mesh, nearest_face, point);
}

namespace internal {

template <class Triangulation, class TriangleMesh, class Place, class = void>
constexpr bool is_place = false;
template <class Triangulation, class TriangleMesh, class Place>
constexpr bool is_place<
    Triangulation, TriangleMesh, Place,
    std::void_t<decltype(surface_location(std::declval<const Triangulation&>(), std::declval<const TriangleMesh&>(),
                                          std::declval<const Place&>()))>> = true;

template <class T>
struct Is_variant : std::false_type
{
};

template <class... Alternatives>
struct Is_variant<std::variant<Alternatives...>> : std::true_type
{
};

/* The type of the points of a metric, or one that nothing is converted to. */
template <class Metric, bool HAS_POINTS = Has_points<Metric>::value>
struct Point_in_space
{
  using type = typename Metric::Point_3;
};
template <class Metric>
struct Point_in_space<Metric, false>
{
  struct type
  {
  };
};

template <class T, class = void>
constexpr bool is_face_location = false;
template <class T>
constexpr bool
    is_face_location<T, std::void_t<decltype(std::declval<T>().first), decltype(std::declval<T>().second[0])>> = true;

/* Returns `locate()`. Errors begin with the name of a point, which contains their elements. */
template <class Locate, class... Name>
auto located_by_name(const Locate& locate, const Name&... name)
{
  try {
    return locate();
  } catch(const Invalid_location_error& error) {
    throw_naming<Invalid_location_error>(name..., ": ", error.what());
  } catch(const Vertex_out_of_range_error& error) {
    throw_naming<Vertex_out_of_range_error>(name..., ": ", error.what());
  }
}

/* Converts surface points of any kinds, and variants of several kinds, to locations, with one `Nearest_face` for all
 * points in space. */
template <class Triangulation>
class Place_finder
{
  using Triangle_mesh = typename Triangulation::Triangle_mesh;
  using Point = typename Point_in_space<typename Triangulation::Metric>::type;

public:
  Place_finder(const Triangulation& triangulation, const Triangle_mesh& mesh)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
  {
  }

  template <class Place>
  Surface_location operator()(const Place& place)
  {
    if constexpr(Is_variant<Place>::value) {
      return std::visit([this](const auto& p) { return (*this)(p); }, place);
    } else if constexpr(is_in_space<Place>) {
      if(!m_nearest_face)
        m_nearest_face.emplace(m_mesh, Halved_corners<Triangulation>{&m_triangulation, &m_mesh});
      return nearest_location(m_triangulation, m_mesh, *m_nearest_face, static_cast<const Point&>(place));
    } else {
      static_assert(
          is_place<Triangulation, Triangle_mesh, Place>,
          "the argument is neither a vertex of the mesh nor a Face_location, a Surface_location or a point in space");
      if constexpr(is_place<Triangulation, Triangle_mesh, Place>)
        return surface_location(m_triangulation, m_mesh, place);
      else
        return {}; // so that no other message follows
    }
  }

  /* Converts the point at a position among several ones, which errors name. */
  template <class Place>
  Surface_location at(std::size_t position, const Place& place, bool is_snapped = true)
  {
    const auto locate = [&] {
      const Surface_location result = is_snapped ? (*this)(place) : unsnapped(place);
      check_location(m_triangulation.input(), result);
      return result;
    };
    return located_by_name(locate, "point ", Element{position});
  }

  /* Converts without moving a Face_location to a nearby edge or vertex, so that curves continue from every end. */
  template <class Place>
  Surface_location unsnapped(const Place& place)
  {
    if constexpr(std::is_convertible<const Place*, const Curve_place<Triangle_mesh>*>::value) {
      return unsnapped(place.location);
    } else {
      Surface_location result = (*this)(place);
      if constexpr(is_face_location<Place>)
        for(std::size_t i = 0; i < 3; ++i) {
          const double weight = CGAL::to_double(place.second[i]);
          result.weights[i] = weight < least_weight ? 0 : weight;
        }
      return result;
    }
  }

  const Triangulation& triangulation() const { return m_triangulation; }

  template <class Place>
  static constexpr bool is_in_space = std::is_convertible<const Place&, const Point&>::value;

private:
  const Triangulation& m_triangulation;
  const Triangle_mesh& m_mesh;
  std::optional<Nearest_mesh_face<Triangulation>> m_nearest_face;
};

/* Converts a surface point of any kind on the mesh of a triangulation; the next function converts a range. */
template <class Triangulation, class Place>
Surface_location located_place(const Triangulation& triangulation, const Place& place)
{
  return Place_finder<Triangulation>(triangulation, triangulation.input().uncontracted().mesh())(place);
}

template <class Triangulation, class PlaceRange>
std::vector<Surface_location> located_places(const Triangulation& triangulation, const PlaceRange& places,
                                             bool are_snapped = true)
{
  static_assert(is_range<PlaceRange>, "a range of points on the surface is expected here");
  std::vector<Surface_location> result;
  if constexpr(is_range<PlaceRange>) {
    Place_finder<Triangulation> find(triangulation, triangulation.input().uncontracted().mesh());
    for(const auto& place : places)
      result.push_back(find.at(result.size(), place, are_snapped));
  }
  return result;
}

/* Converts without snapping. */
template <class Triangulation, class TriangleMesh, class Place>
Surface_location trace_start(const Triangulation& triangulation, const TriangleMesh& mesh, const Place& place)
{
  return Place_finder<Triangulation>(triangulation, mesh).unsnapped(place);
}

} // namespace internal
} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_SURFACE_POINTS_H
