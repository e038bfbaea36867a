// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_DISTANCE_FIELD_H
#define CGAL_FLIP_GEODESICS_GEODESIC_DISTANCE_FIELD_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Field_query.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_propagation.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsDistances
/// Specifies where a distance field can be evaluated.
enum class Distance_field_extent {
  EVERYWHERE,   ///< at any location
  VERTICES_ONLY ///< at vertices only, and without paths; requires less memory, because windows are freed after use
};

/// \ingroup PkgFlipGeodesicsDistances
/// States why the computation of a distance field ended.
enum class Distance_field_status {
  COMPLETE,        ///< all distances are known
  RADIUS_REACHED,  ///< the distances up to the radius are known
  TARGETS_REACHED, ///< the distances of the targets are known
  /// the limit on windows was reached, or rays circulate in degenerate faces; the distances up to
  /// `Geodesic_distance_field::reach()` are known
  WINDOW_LIMIT_REACHED,
  /// `go_further()` of the visitor returned `false`; the distances up to `Geodesic_distance_field::reach()` are known
  STOPPED_BY_VISITOR
};

/// \ingroup PkgFlipGeodesicsDistances
/// Returns the name of a status, spelled like the enumerator.
inline const char* to_string(Distance_field_status status)
{
  return internal::name_of(
      status, {"COMPLETE", "RADIUS_REACHED", "TARGETS_REACHED", "WINDOW_LIMIT_REACHED", "STOPPED_BY_VISITOR"});
}

namespace internal {

enum Extent_parameter { extent_parameter };

} // namespace internal
} // namespace Flip_geodesics

namespace parameters {

/*!
 * \ingroup PkgFlipGeodesicsParameters
 * Sets the extent of a distance field, which determines where the field can be evaluated.
 */
inline auto extent(Flip_geodesics::Distance_field_extent extent)
{
  return Named_function_parameters<Flip_geodesics::Distance_field_extent, Flip_geodesics::internal::Extent_parameter>(
      extent);
}

} // namespace parameters

namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsDistances
/// Specifies the limits up to which a distance field is computed.
struct Distance_field_limits
{
  double radius = std::numeric_limits<double>::infinity(); ///< the largest distance that is needed
  std::vector<Surface_location> targets; ///< if not empty, distances are computed up to that of the farthest target
  Window_limit windows;                  ///< the number of windows after which the computation is aborted
};

/// \ingroup PkgFlipGeodesicsDistances
/// Describes the outcome of the computation of a distance field.
struct Distance_field_report
{
  Distance_field_status status = Distance_field_status::COMPLETE; ///< why the computation ended
  std::size_t windows = 0;                                        ///< the total number of windows created
  /// Whether the field has reached a face whose height is at most 1e-10 of its base. Rays can be lost in such a face,
  /// so distances can be too large.
  bool has_flat_face = false;
  /// Whether rounding errors may have changed the distance of a vertex by more than 1e-10 of this distance. Errors grow
  /// with the number of faces that paths cross, and with the number of crossed edges that are long compared with the
  /// distance. The estimate of the errors is conservative; most errors are far smaller than estimated.
  bool has_inaccurate_distance = false;
  /// The verdict on the distances. `WITHIN_TOLERANCE` means that every distance up to
  /// `Geodesic_distance_field::reach()` differs from the exact distance by at most 1e-10 of the distance. The verdict
  /// is `UNDECIDED` if `has_flat_face` or `has_inaccurate_distance` is `true`, or if coordinates or lengths of the mesh
  /// had to be rounded.
  Verdict verdict = Verdict::UNDECIDED;
};

/*!
 * \ingroup PkgFlipGeodesicsDistances
 *
 * Computes the distances on a surface from a set of sources, exactly up to rounding errors.
 *
 * Windows of straight rays are propagated from face to face, and each edge keeps the lower envelope of the windows that
 * reach it \cgalCite{MMP87}. Sources are vertices, points anywhere on the surface, and curves. Each source has an
 * offset, by default 0, which is added to all distances from this source. A computed field can be queried, at any
 * location, for the distance, the nearest source, a shortest path to this source, and the gradient of the distance. A
 * field with the extent `VERTICES_ONLY` returns distances and nearest sources of vertices only.
 *
 * \code
 * Geodesic_distance_field<Triangulation> field(triangulation, mesh);
 * field.add_source(triangulation.index(v));
 * field.compute();
 * const double distance = field.distance(location);
 * \endcode
 *
 * Distances are those of the input mesh; flips and insertions do not affect them. Several threads may call `const`
 * members concurrently.
 *
 * \cgalModels{GeodesicDistanceField}
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`
 */
template <class Triangulation>
class Geodesic_distance_field
{
  using Propagation = internal::Window_propagation<Triangulation>;
  using Query = internal::Field_query<Triangulation>;

public:
  using Triangle_mesh = typename Triangulation::Triangle_mesh;                          ///< the type of the mesh
  using face_descriptor = typename boost::graph_traits<Triangle_mesh>::face_descriptor; ///< the face type of the mesh

  /// Contains the result of a query.
  struct Answer
  {
    /// The distance from the nearest source, including the offset of the source.
    double distance = std::numeric_limits<double>::infinity();
    std::size_t source = 0; ///< the number of that source, counted from 0; 0 if the distance is infinite
  };

  /*!
   * Constructs a field without sources.
   * \param triangulation a triangulation of the mesh; both must outlive the field
   * \param mesh the mesh
   * \param np an optional sequence of named parameters among those listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{extent}
   *     \cgalParamDescription{where the field can be evaluated}
   *     \cgalParamType{`Distance_field_extent`}
   *     \cgalParamDefault{`Distance_field_extent::EVERYWHERE`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   */
  template <class... NamedParameters>
  Geodesic_distance_field(const Triangulation& triangulation, const Triangle_mesh& mesh, const NamedParameters&... np)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_extent(parameters::choose_parameter(
          parameters::get_parameter(internal::options_of<internal::Extent_parameter>(np...),
                                    internal::extent_parameter),
          Distance_field_extent::EVERYWHERE))
    , m_propagation(triangulation, m_extent == Distance_field_extent::EVERYWHERE)
  {
  }
  /// Is deleted, since a temporary triangulation would not outlive the field.
  template <class... NamedParameters>
  Geodesic_distance_field(const Triangulation&&, const Triangle_mesh&, const NamedParameters&...) = delete;
  /// Is deleted, since a temporary mesh would not outlive the field.
  template <class... NamedParameters>
  Geodesic_distance_field(const Triangulation&, const Triangle_mesh&&, const NamedParameters&...) = delete;

  /*!
   * Adds a point of the surface as a source and returns the number of the source.
   *
   * \param point a vertex of the input, as a `Vertex_index`, or a point of any type that `surface_location()` accepts
   * \param offset the number that is added to all distances from this source
   * \throws Invalid_parameter_error if the field has been computed, that is, if `reach()` is greater than 0
   * \throws Vertex_out_of_range_error if `point` is a vertex that does not belong to the mesh, or an isolated vertex
   *         that is not given as a `Vertex_index`
   * \throws Invalid_location_error if `point` is not a point of the surface
   * \throws Invalid_coordinate_error if the offset is negative, not finite, or more than about 1e10 times the size of a
   *         face that contains the point. With a larger offset, rounding errors of distances would exceed about 1e-6 of
   *         this size
   * \throws Degenerate_face_error if a face that the function visits is degenerate. For a vertex without offset, no
   *         faces are visited
   * \throws Invalid_mesh_error if a face that the function visits is invalid
   *
   * Complexity: constant time, plus the time of `surface_location()` if `point` is a point in space.
   */
  template <class Point = Surface_location>
  std::size_t add_source(const Point& point, double offset = 0)
  {
    if constexpr(std::is_convertible<const Point&, Vertex_index>::value) {
      const Vertex_index v = point;
      internal::check_vertex(v, m_triangulation.input().number_of_vertices());
      check_addition(offset, m_triangulation.input().outgoing(v));
      m_propagation.add_vertex(v, offset, m_number_of_sources);
    } else {
      const Surface_location at = canonical(point);
      check_addition(offset, at.halfedge);
      add_point(at, offset);
    }
    return m_number_of_sources++;
  }

  /*!
   * Adds a curve as a source and returns the number of the source. The curve is straight between consecutive locations;
   * a curve along edges can therefore be given by its vertices. A range with one location represents a point.
   * `Curve_extractor::surface_locations()` returns the locations of a curve of a network.
   *
   * \param locations a range of points of the surface, of any type that `surface_location()` accepts. Consecutive
   *        points must lie in a common face or on its boundary
   * \param offset the number that is added to all distances from this source
   * \throws Invalid_curve_error if the range is empty, or two consecutive locations do not lie in a common face
   * \throws Invalid_parameter_error as `add_source()` does
   * \throws Vertex_out_of_range_error as `add_source()` does
   * \throws Invalid_location_error as `add_source()` does
   * \throws Invalid_coordinate_error as `add_source()` does for the first location
   * \throws Degenerate_face_error as `add_source()` does
   * \throws Invalid_mesh_error as `add_source()` does
   *
   * Complexity: linear in the number of locations plus the sum of the degrees of the vertices among them, plus the time
   * of `surface_location()` for points in space.
   */
  template <class LocationRange>
  std::size_t add_curve(const LocationRange& locations, double offset = 0)
  {
    std::vector<Surface_location> at;
    for(const Surface_location& location : internal::located_places(m_triangulation, locations))
      at.push_back(internal::canonical_location(m_triangulation.input(), location));
    if(at.empty())
      throw Invalid_curve_error("a source curve has no points; pass at least one");
    std::vector<Input_halfedge_index> faces;
    for(std::size_t i = 0; i + 1 < at.size(); ++i) {
      faces.push_back(internal::common_face(m_triangulation.input(), at[i], at[i + 1]));
      if(faces.back() == null_index)
        internal::throw_naming<Invalid_curve_error>("points ", internal::Element{i}, " and ", internal::Element{i + 1},
                                                    " of a source curve do not lie in a common face");
    }
    check_addition(offset, at.front().halfedge);
    for(std::size_t i = 0; i < at.size(); ++i) {
      add_point(at[i], offset);
      if(i > 0)
        add_segment(faces[i - 1], at[i - 1], at[i], offset);
    }
    return m_number_of_sources++;
  }

  /// Returns the number of sources.
  std::size_t number_of_sources() const { return m_number_of_sources; }

  /*!
   * Computes the field up to the given limits.
   *
   * The function can be called again with other limits to continue the computation, even after it has been stopped or
   * has thrown an exception; all known distances are kept.
   *
   * \tparam ConcurrencyTag `CGAL::Sequential_tag`, or `CGAL::Parallel_tag` if TBB is linked; the results are the same
   *
   * \param np an optional sequence of named parameters among those listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{search_limit}
   *     \cgalParamDescription{how far the field is computed}
   *     \cgalParamType{`Distance_field_limits`}
   *     \cgalParamDefault{no limits}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{visitor}
   *     \cgalParamDescription{a visitor whose `go_further()` is called at regular intervals from the calling thread. If
   *       it returns `false`, the status is `Distance_field_status::STOPPED_BY_VISITOR`}
   *     \cgalParamType{a model of `FlipOutVisitor`, which is copied unless it is passed by `std::ref()`}
   *     \cgalParamDefault{no visitor}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \return a report on the distances that are known
   *
   * \throws Invalid_coordinate_error if a visited face has an invalid coordinate
   * \throws Degenerate_face_error if a visited face is degenerate
   * \throws Invalid_mesh_error if a visited face is invalid
   * \throws Invalid_location_error if a target is not a point of the surface
   * \throws Invalid_parameter_error if the radius is negative or not a number, or if the extent is `VERTICES_ONLY` and
   *         a target is not a vertex
   *
   * Complexity: linear in the number of windows plus, for each round of the propagation, the number of edges that the
   * wavefront crosses. On smooth meshes, the number of windows per face grows like \f$\sqrt{n}\f$, where \f$n\f$ is the
   * number of faces (\ref Flip_geodesicsFieldTimes). In the worst case, the field has \cgalBigO{n^2} windows in total.
   */
  template <class ConcurrencyTag = Sequential_tag, class... NamedParameters>
  Distance_field_report compute(const NamedParameters&... np)
  {
    const auto& options = internal::options_of<internal::Limit_parameter, internal_np::visitor_t>(np...);
    const auto limits = internal::search_limit_of<Distance_field_limits>(options);
    auto visitor = internal::make_visitor(options);
    if(!(limits.radius >= 0))
      throw Invalid_parameter_error("the radius of a field is " + internal::written(limits.radius) +
                                    ", but must be a number that is not negative");
    for(const Surface_location& target : limits.targets)
      internal::check_location(m_triangulation.input(), target);
    m_is_computed = true;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::size_t between_looks = 200 * limits.targets.size();
    m_parts_by_face = internal::parts_by_face(m_triangulation.input(), m_propagation.parts());
    const std::size_t most = limits.windows(static_cast<std::size_t>(m_triangulation.input().number_of_vertices()));
    internal::Interruption interruption(visitor.get());
    Distance_field_report report;
    for(;;) {
      const double wanted = (std::min)(limits.radius, farthest(limits.targets));
      const double bound = wanted < infinity ? std::nextafter(wanted, infinity) : infinity;
      const std::size_t next_look = m_propagation.number_of_windows() + between_looks;
      m_propagation.template run<ConcurrencyTag>(bound, limits.targets.empty() ? most : (std::min)(most, next_look),
                                                 &interruption);
      m_reach = m_propagation.reach();
      if(m_reach == infinity || m_reach >= bound || m_propagation.is_given_up(most) || interruption.has_occurred()) {
        report.status = status_at(limits, bound, interruption);
        break;
      }
    }
    report.windows = m_propagation.number_of_windows();
    report.has_flat_face = m_propagation.has_flat_face();
    report.has_inaccurate_distance = m_propagation.has_inaccurate_distance();
    report.verdict = internal::verdict_of_distances(!report.has_flat_face && !report.has_inaccurate_distance &&
                                                    !internal::is_input_rounded(m_triangulation));
    return report;
  }

  /// Returns the distance up to which the field has been computed: 0 before `compute()`, and infinity if the field is
  /// complete. Distances greater than this value are returned as infinity.
  double reach() const { return m_reach; }

  /// Returns the distance of a point from its nearest source. The parameter and the exceptions are those of `answer()`.
  ///
  /// Complexity: constant for a `Vertex_index`, and otherwise that of `answer()`.
  template <class Point = Surface_location>
  double distance(const Point& point) const
  {
    if constexpr(std::is_convertible<const Point&, Vertex_index>::value)
      return distance_of_vertex(point);
    else
      return answer(point).distance;
  }

  /*!
   * Returns the distance of a point from its nearest source, and the number of this source.
   *
   * \param point a vertex of the input, as a `Vertex_index`, or a point of any type that `surface_location()` accepts
   * \throws Vertex_out_of_range_error if `point` is a vertex that does not belong to the mesh, or an isolated vertex
   *         that is not given as a `Vertex_index`
   * \throws Invalid_location_error if `point` is not a point of the surface
   * \throws Invalid_parameter_error if the extent is `VERTICES_ONLY` and the point is not a vertex, or if `compute()`
   *         has not been called
   *
   * Complexity: linear in the number of vertices at which the shortest path bends and, if the point is not a vertex, in
   * the number of windows on the sides of the face that contains the point. For a point in space, the time of
   * `surface_location()` is added.
   */
  template <class Point = Surface_location>
  Answer answer(const Point& point) const
  {
    if constexpr(std::is_convertible<const Point&, Vertex_index>::value) {
      const Vertex_index v = point;
      const double distance = distance_of_vertex(v);
      return is_known(distance) ? Answer{distance, m_propagation.source(v.idx())} : Answer();
    } else {
      const Surface_location at = canonical(point);
      if(kind(at) == Location_kind::VERTEX)
        return answer(m_triangulation.input().tail(at.halfedge));
      const auto arrival = arrival_at(at);
      return is_known(arrival.distance) ? Answer{arrival.distance, query().source(arrival)} : Answer();
    }
  }

  /// Returns the distance and the nearest source of a point with given barycentric weights in a face of the mesh. The
  /// weights belong to the source, the target and the third vertex of `halfedge(face, mesh)`; their sum need not be 1.
  /// The exceptions are those of `answer()`.
  Answer operator()(face_descriptor face, const std::array<double, 3>& weights) const
  {
    return answer({m_triangulation.input().index(internal::graph_halfedge(face, m_mesh)), weights});
  }

  /// Returns whether all points of a face that have a finite distance are known to have the same nearest source. The
  /// result is `false` unless the field is complete and has the extent `EVERYWHERE`.
  ///
  /// Complexity: linear in the number of windows on the sides of the face.
  bool has_one_source(face_descriptor face) const
  {
    return m_extent == Distance_field_extent::EVERYWHERE && m_reach == std::numeric_limits<double>::infinity() &&
           query().has_one_source(m_triangulation.input().index(internal::graph_halfedge(face, m_mesh)));
  }

  /*!
   * Returns the `Surface_point`s of a shortest path from a point to its nearest source, including both end points. The
   * result is empty if the distance is infinite.
   *
   * \param point a point of any type that `surface_location()` accepts
   * \throws Invalid_location_error if `point` is not a point of the surface
   * \throws Invalid_parameter_error if the extent is `VERTICES_ONLY`, or if `compute()` has not been called
   *
   * Complexity: linear in the number of edges that the path crosses plus the number of windows on the sides of the
   * faces through which the path leads.
   */
  template <class Point = Surface_location>
  std::vector<Surface_point> surface_points(const Point& point) const
  {
    if(m_extent != Distance_field_extent::EVERYWHERE)
      throw Invalid_parameter_error("a path is queried in a field with the extent VERTICES_ONLY, which does not store "
                                    "the windows along it; construct the field with the extent EVERYWHERE");
    const Surface_location at = canonical(point);
    std::vector<Surface_point> result;
    if(!is_known(distance(at)))
      return result;
    const Vertex_index v = m_triangulation.input().tail(at.halfedge);
    result.push_back(surface_point(m_triangulation, at));
    if(kind(at) != Location_kind::VERTEX)
      query().path(arrival_at(at), at.halfedge, internal::normalized(at.weights), std::back_inserter(result));
    else if(m_propagation.vertex(v).is_source)
      result.push_back(result.front());
    else
      query().path(v, std::back_inserter(result));
    return result;
  }

  /*!
   * Writes a shortest path from a point to its nearest source, as points in space, `Face_location`s or `Curve_point`s
   * in the form described at `geodesic_path()`.
   *
   * \param point a point of any type that `surface_location()` accepts
   * \param out the output iterator
   * \return the past-the-end output iterator
   * \throws Invalid_location_error if `point` is not a point of the surface
   * \throws Invalid_parameter_error if the extent is `VERTICES_ONLY`, or if `compute()` has not been called
   *
   * Complexity: that of `surface_points()`.
   */
  template <class Point = Surface_location, class OutputIterator>
  OutputIterator path(const Point& point, OutputIterator out) const
  {
    using Form = internal::Curve_form<Triangulation, OutputIterator>;
    return internal::write_points<Form>(m_triangulation, m_mesh, surface_points(point), out);
  }

  /*!
   * Returns the gradient of the distance at a location: a unit vector in the face of `location.halfedge` that points
   * away from the nearest source.
   *
   * The coordinates refer to a frame of the face in which `location.halfedge` points in the direction of the positive
   * x-axis and the face lies above this axis. The gradient is zero at a source, at every vertex, and at points with
   * infinite distance. If several shortest paths end at the location, the gradient belongs to one of them.
   *
   * \pre `location.halfedge` is not a border halfedge
   * \throws Invalid_location_error if `location` is not a point of the surface
   * \throws Invalid_parameter_error if the extent is `VERTICES_ONLY`, or if `compute()` has not been called
   *
   * Complexity: that of `answer()`.
   */
  std::array<double, 2> gradient(const Surface_location& location) const
  {
    internal::check_location(m_triangulation.input(), location);
    CGAL_precondition(!m_triangulation.input().is_border(location.halfedge));
    const auto arrival = arrival_at(location);
    if(kind(location) == Location_kind::VERTEX || !is_known(arrival.distance))
      return {{0, 0}};
    const auto result = query().direction(arrival, location.halfedge, internal::normalized(location.weights));
    return {{result.real(), result.imag()}};
  }

  /// Returns the gradient of the distance at a location as a vector in space. The type of the vector is that of the
  /// kernel of the points of the mesh. The function is available only if the metric has points. The precondition and
  /// the exceptions are those of `gradient()`.
  auto gradient_in_space(const Surface_location& location) const
  {
    using Vector_3 = typename Triangulation::Metric::Kernel::Vector_3;
    const std::array<double, 2> g = gradient(location);
    const internal::Face_side f = m_propagation.sides().copy(location.halfedge);
    const double to_third = f.y > 0 ? g[1] / f.y : 0, to_head = (g[0] - to_third * f.x) / f.length;
    const auto& input = m_triangulation.input();
    const Input_halfedge_index hn = input.next(location.halfedge);
    const auto corner = [&](Input_halfedge_index h) {
      return m_triangulation.metric().point(input, input.uncontracted_tail(h));
    };
    const auto p = corner(location.halfedge), q = corner(hn), r = corner(input.next(hn));
    const Vector_3 result = (q - p) * to_head + (r - p) * to_third;
    return result;
  }

private:
  friend struct internal::Internals<Geodesic_distance_field>;

  template <class Point>
  Surface_location canonical(const Point& point) const
  {
    return internal::canonical_location(m_triangulation.input(), internal::located_place(m_triangulation, point));
  }

  double distance_of_vertex(Vertex_index v) const
  {
    internal::check_vertex(v, m_triangulation.input().number_of_vertices());
    return is_known(m_propagation.distance(v)) ? m_propagation.distance(v) : std::numeric_limits<double>::infinity();
  }

  Query query() const { return Query(m_triangulation, m_propagation, m_parts_by_face); }

  void check_addition(double offset, Input_halfedge_index h) const
  {
    if(m_reach > 0)
      throw Invalid_parameter_error("a source cannot be added to a distance field that has been computed");
    if(!(std::isfinite(offset) && offset >= 0))
      throw_unusable_offset(offset, ", but must be finite and not negative");
    if(offset == 0 || h == null_index)
      return;
    const bool is_border = m_triangulation.input().is_border(h);
    const internal::Face_side side = m_propagation.sides().copy(is_border ? internal::twin_index(h) : h);
    if(offset > internal::greatest_offset * (side.length + std::abs(side.x) + side.y))
      throw_unusable_offset(
          offset,
          ", which is so large compared with the sides of the face at the source that adding it to distances would "
          "cause large rounding errors");
  }

  [[noreturn]] void throw_unusable_offset(double offset, const char* reason) const
  {
    internal::throw_naming<Invalid_coordinate_error>("the offset of source ", internal::Element{m_number_of_sources},
                                                     " is ", offset, reason);
  }

  void add_point(const Surface_location& at, double offset)
  {
    const auto& input = m_triangulation.input();
    if(kind(at) == Location_kind::VERTEX)
      return m_propagation.add_vertex(input.tail(at.halfedge), offset, m_number_of_sources);
    for(Input_halfedge_index face : internal::faces_of_location(input, at)) {
      const internal::Face_weights w = weights_in(face, at);
      m_propagation.add_part({face, {{w, w}}, offset, m_number_of_sources});
    }
  }

  void add_segment(Input_halfedge_index face, const Surface_location& p, const Surface_location& q, double offset)
  {
    const internal::Face_weights first = weights_in(face, p), last = weights_in(face, q);
    if(first != last)
      m_propagation.add_part({face, {{first, last}}, offset, m_number_of_sources});
  }

  // Returns the weights of a location in a face that contains it, beginning at halfedge `face`.
  internal::Face_weights weights_in(Input_halfedge_index face, Surface_location at) const
  {
    const auto& input = m_triangulation.input();
    const auto is_side = [&](Input_halfedge_index h) {
      return h == face || input.next(h) == face || input.next(face) == h;
    };
    if(kind(at) == Location_kind::VERTEX)
      for(Input_halfedge_index h : {face, input.next(face), input.next(input.next(face))})
        at.halfedge = input.tail(h) == input.tail(at.halfedge) ? h : at.halfedge;
    else if(!is_side(at.halfedge)) // on the edge, from the other side
      at = {internal::twin_index(at.halfedge), {{at.weights[1], at.weights[0], 0}}};
    return query().turned(internal::normalized(at.weights), at.halfedge, face);
  }

  double farthest(const std::vector<Surface_location>& targets) const
  {
    double result = targets.empty() ? std::numeric_limits<double>::infinity() : 0;
    for(const Surface_location& target : targets) {
      const Surface_location at = internal::canonical_location(m_triangulation.input(), target);
      const bool is_vertex = kind(at) == Location_kind::VERTEX;
      result = (std::max)(result, is_vertex ? m_propagation.distance(m_triangulation.input().tail(at.halfedge))
                                            : arrival_at(at).distance);
    }
    return result;
  }

  Distance_field_status status_at(const Distance_field_limits& limits, double bound,
                                  const internal::Interruption& interruption) const
  {
    if(m_reach == std::numeric_limits<double>::infinity())
      return Distance_field_status::COMPLETE;
    if(m_reach < bound)
      return interruption.has_occurred() ? Distance_field_status::STOPPED_BY_VISITOR
                                         : Distance_field_status::WINDOW_LIMIT_REACHED;
    return bound > limits.radius ? Distance_field_status::RADIUS_REACHED : Distance_field_status::TARGETS_REACHED;
  }

  bool is_known(double distance) const
  {
    if(!m_is_computed)
      throw Invalid_parameter_error("a distance field is queried before it has been computed; call compute() first");
    return distance <= m_reach && std::isfinite(distance);
  }

  typename Query::Arrival arrival_at(const Surface_location& at) const
  {
    if(m_extent != Distance_field_extent::EVERYWHERE)
      internal::throw_naming<Invalid_parameter_error>(
          "a field with the extent VERTICES_ONLY is queried in the face of halfedge ", at.halfedge,
          ", at a point that is not a vertex; construct the field with the extent EVERYWHERE");
    return query()(at.halfedge, internal::normalized(at.weights));
  }

  const Triangulation& m_triangulation;
  const Triangle_mesh& m_mesh;
  Distance_field_extent m_extent;
  Propagation m_propagation;
  std::vector<std::pair<Input_halfedge_index, Index>> m_parts_by_face;
  std::size_t m_number_of_sources = 0;
  double m_reach = 0;
  bool m_is_computed = false;
};

namespace internal {

template <class Triangulation>
struct Internals<Geodesic_distance_field<Triangulation>>
{
  static auto query(const Geodesic_distance_field<Triangulation>& field) { return field.query(); }
};

template <class Field>
auto query_of(const Field& field)
{
  return Internals<Field>::query(field);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_DISTANCE_FIELD_H
