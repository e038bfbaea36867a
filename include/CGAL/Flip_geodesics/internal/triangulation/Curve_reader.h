// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_CURVE_READER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_CURVE_READER_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Nearest_face.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Curve_insertion.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/boost/graph/iterator.h>
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
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Is T a `Face_location` of a mesh? */
template <class T, class Mesh, class = void>
constexpr bool is_face_location_of = false;
template <class T, class Mesh>
constexpr bool
    is_face_location_of<T, Mesh, std::void_t<decltype(CGAL::to_double(std::declval<const T&>().second[0]))>> =
        std::is_same<std::decay_t<decltype(std::declval<const T&>().first)>,
                     typename boost::graph_traits<Mesh>::face_descriptor>::value;

/* Has T one, as a `Curve_point` has? */
template <class T, class Mesh, class = void>
constexpr bool has_face_location = false;
template <class T, class Mesh>
constexpr bool has_face_location<T, Mesh, std::void_t<decltype(std::declval<const T&>().location)>> =
    is_face_location_of<std::decay_t<decltype(std::declval<const T&>().location)>, Mesh>;

/* Is T a point in space? */
template <class T, class = void>
constexpr bool is_point_in_space = false;
template <class T>
constexpr bool
    is_point_in_space<T, std::void_t<decltype(std::declval<const T&>().x()), decltype(std::declval<const T&>().y()),
                                     decltype(std::declval<const T&>().z())>> = true;

template <class T, class Mesh>
constexpr bool is_point_of_curve = is_face_location_of<T, Mesh> || has_face_location<T, Mesh> || is_point_in_space<T>;

/* Is T a range of such, or has it one, as an `Isoline` has? */
template <class T, class Mesh, class = void>
constexpr bool is_range_of_curve_points = false;
template <class T, class Mesh>
constexpr bool is_range_of_curve_points<T, Mesh, std::void_t<Range_value<T>>> = is_point_of_curve<Range_value<T>, Mesh>;

template <class T, class Mesh, class = void>
constexpr bool has_locations = false;
template <class T, class Mesh>
constexpr bool has_locations<T, Mesh, std::void_t<decltype(std::declval<const T&>().locations)>> =
    is_range_of_curve_points<std::decay_t<decltype(std::declval<const T&>().locations)>, Mesh>;

template <class T, class Mesh>
constexpr bool is_insertable_curve = is_range_of_curve_points<T, Mesh> || has_locations<T, Mesh>;

template <class T, class Mesh, class = void>
constexpr bool is_range_of_insertable_curves = false;
template <class T, class Mesh>
constexpr bool is_range_of_insertable_curves<T, Mesh, std::void_t<Range_value<T>>> =
    is_insertable_curve<Range_value<T>, Mesh>;

/* Hands curves to an insertion, as nodes and segments between them. */
template <class Mesh, class PointMap>
class Curve_reader
{
  using Graph = boost::graph_traits<Mesh>;
  using Face = typename Graph::face_descriptor;
  using Insertion = Curve_insertion<Mesh, PointMap>;

public:
  Curve_reader(const Mesh& mesh, const PointMap& points, double snap, Insertion& insertion)
    : m_mesh(mesh)
    , m_points(points)
    , m_snap(snap)
    , m_insertion(insertion)
  {
  }

  /* Curves, or one of them. */
  template <class Curves>
  void add_all(const Curves& curves)
  {
    if constexpr(is_insertable_curve<Curves, Mesh>)
      add(curves);
    else
      for(const auto& curve : curves)
        add(curve);
  }

private:
  struct Place
  {
    Face face = Graph::null_face();
    std::array<double, 3> weights = {{0, 0, 0}};
  };

  struct Corners
  {
    const Insertion* insertion;
    Triangle_places operator()(Face f) const { return insertion->places_of_corners(f); }
  };
  using Nearest = typename Nearest_face<Mesh, Corners>::Result;

  template <class Curve>
  void add(const Curve& curve)
  {
    if constexpr(has_locations<Curve, Mesh>) {
      add(curve.locations);
    } else {
      m_point = 0;
      m_last_face = Graph::null_face();
      for(const auto& p : curve)
        add_point(p);
      if(m_point == 0)
        throw Invalid_curve_error("curve " + std::to_string(m_curve) + " has no points", {m_curve});
      ++m_curve;
    }
  }

  template <class T>
  void add_point(const T& p)
  {
    const Place place = place_of(p);
    const std::size_t node = m_insertion.add_point(place.face, place.weights, given_weights(p, place));
    if(m_point > 0 && !m_insertion.add_segment(m_last_node, node, {{m_last_face, place.face}}))
      throw Invalid_curve_error(name() + " and the one before it are in no common face; add the points where the curve "
                                         "crosses edges, for instance by complete_polyline()",
                                elements());
    m_last_node = node;
    m_last_face = place.face;
    ++m_point;
  }

  std::string name() const { return "point " + std::to_string(m_point) + " of curve " + std::to_string(m_curve); }

  std::vector<std::size_t> elements() const { return {m_curve, m_point}; }

  template <class T>
  Place place_of(const T& p)
  {
    if constexpr(is_face_location_of<T, Mesh>)
      return place_at(p.first,
                      {{CGAL::to_double(p.second[0]), CGAL::to_double(p.second[1]), CGAL::to_double(p.second[2])}},
                      m_snap);
    else if constexpr(has_face_location<T, Mesh>)
      return place_of(p.location);
    else
      return place_in_space(half_of(p));
  }

  // Weights as they are given, or those of the place in double.
  template <class T>
  static const auto& given_weights(const T& p, const Place& place)
  {
    if constexpr(is_face_location_of<T, Mesh>)
      return static_cast<void>(place), p.second;
    else if constexpr(has_face_location<T, Mesh>)
      return given_weights(p.location, place);
    else
      return static_cast<void>(p), place.weights;
  }

  Place place_at(Face f, std::array<double, 3> weights, double snap) const
  {
    if(!is_face(f, m_mesh))
      throw Invalid_location_error(name() + " is in no face of the mesh", elements());
    double sum = 0;
    for(double& weight : weights) {
      if(!(weight >= -snap && weight <= 1 + weight_sum_tolerance))
        throw Invalid_location_error("a barycentric coordinate of " + name() + " is " + std::to_string(weight) +
                                         ", not between 0 and 1",
                                     elements());
      sum += weight;
      weight = weight <= snap ? 0 : weight;
    }
    if(!(std::abs(sum - 1) <= weight_sum_tolerance))
      throw Invalid_location_error(
          "the barycentric coordinates of " + name() + " sum to " + std::to_string(sum) + ", not to one", elements());
    Place result;
    result.face = f;
    result.weights = weights;
    return result;
  }

  // The nearest point of the surface: of the faces around the point before, if one of them has it, or of all faces.
  Place place_in_space(const Place_in_space& p)
  {
    if(!are_finite(p))
      throw Invalid_location_error(name() + " has a coordinate that is not a finite number", elements());
    Nearest best;
    if(m_last_face != Graph::null_face())
      for(const auto h : halfedges_around_face(halfedge(m_last_face, m_mesh), m_mesh))
        for(const Face f : faces_around_target(h, m_mesh))
          if(f != Graph::null_face())
            look_at(f, p, best);
    if(best.distance() > nearest_point_snap * diagonal()) {
      if(!m_nearest_face)
        m_nearest_face.emplace(m_mesh, Corners{&m_insertion});
      const Nearest found = (*m_nearest_face)(p);
      if(found.distance() < best.distance())
        best = found;
    }
    if(!(best.distance() <= off_surface_tolerance * diagonal()))
      throw Invalid_location_error(name() + " is not on the surface", elements());
    return place_at(best.face, best.nearest.weights, nearest_point_snap);
  }

  void look_at(Face f, const Place_in_space& p, Nearest& best) const
  {
    const Nearest_weights nearest = nearest_weights(seen_from(p, m_insertion.places_of_corners(f)));
    if(nearest.distance < best.distance())
      best = {f, nearest};
  }

  // Of the bounding box, halved as all coordinates here are.
  double diagonal()
  {
    if(m_diagonal < 0) {
      Bounding_box box;
      for(const auto v : vertices(m_mesh))
        box.add(half_of(get(m_points, v)));
      const Place_in_space d = difference(box.high, box.low);
      m_diagonal = std::hypot(d[0], d[1], d[2]);
    }
    return m_diagonal;
  }

  const Mesh& m_mesh;
  PointMap m_points;
  double m_snap;
  Insertion& m_insertion;
  std::optional<Nearest_face<Mesh, Corners>> m_nearest_face;
  double m_diagonal = -1;               // negative as long as it is not known
  std::size_t m_curve = 0, m_point = 0; // that are read
  std::size_t m_last_node = Insertion::none;
  Face m_last_face = Graph::null_face();
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_CURVE_READER_H
