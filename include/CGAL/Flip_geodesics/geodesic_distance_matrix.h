// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_DISTANCE_MATRIX_H
#define CGAL_FLIP_GEODESICS_GEODESIC_DISTANCE_MATRIX_H

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_types.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/for_each_index.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/make_shortest.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class Visitor, class = void>
struct Has_progress : std::false_type
{
};

template <class Visitor>
struct Has_progress<Visitor, std::void_t<decltype(std::declval<Visitor&>().on_progress(0.5))>> : std::true_type
{
};

/* A visitor of fields that are computed at the same time, which learns from the calling thread how many are finished.
 * */
template <class Visitor>
class Progress_visitor
{
public:
  Progress_visitor(Visitor& visitor, std::size_t number)
    : m_visitor(visitor)
    , m_number(number)
  {
  }

  void finish_one() { ++m_finished; }

  bool go_further()
  {
    if constexpr(Has_progress<Visitor>::value)
      m_visitor.on_progress(static_cast<double>(m_finished) / static_cast<double>(m_number));
    return m_visitor.go_further();
  }

private:
  Visitor& m_visitor;
  std::size_t m_number;
  std::atomic<std::size_t> m_finished{0};
};

/* The rows of a matrix of distances between points, of which each is computed from the diagonal on. */
template <class Triangulation>
class Distance_matrix_rows
{
  using Triangle_mesh = typename Triangulation::Triangle_mesh;
  using Field = Geodesic_distance_field<Triangulation>;

public:
  Distance_matrix_rows(const Triangulation& triangulation, const Triangle_mesh& mesh,
                       std::vector<Surface_location> points, const Window_limit& limit)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_points(std::move(points))
    , m_limit(limit)
    , m_extent(std::all_of(m_points.begin(), m_points.end(), is_vertex) ? Distance_field_extent::VERTICES_ONLY
                                                                        : Distance_field_extent::EVERYWHERE)
  {
  }

  /* Computes all rows, in any order; each field is gone when its row is complete. */
  template <class ConcurrencyTag, class Visitor>
  Computed_values<std::vector<double>> compute(Visitor& visitor) const
  {
    Computed_values<std::vector<double>> result;
    result.values.assign(m_points.size(), std::vector<double>(m_points.size(), 0));
    std::vector<Distance_field_report> reports(m_points.size());
    Progress_visitor<Visitor> progress(visitor, m_points.size());
    Interruption interruption(progress);
    Shared_interruption shared(interruption);
    for_each_index<ConcurrencyTag>(m_points.size(), [&](std::size_t i) {
      if(i + 1 < m_points.size() && shared.go_further())
        reports[i] = compute_row(i, shared, result.values[i]);
      progress.finish_one();
    });
    interruption.begin_part();
    mirror(result.values);
    summarize(reports, interruption, result);
    return result;
  }

private:
  static bool is_vertex(const Surface_location& at) { return kind(at) == Location_kind::VERTEX; }

  Distance_field_report compute_row(std::size_t i, Shared_interruption& shared, std::vector<double>& row) const
  {
    Field field(m_triangulation, m_mesh, m_extent);
    field.add_source(m_points[i]);
    Distance_field_limits limits;
    limits.windows = m_limit;
    const auto next = m_points.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    limits.targets.assign(next, m_points.end());
    const Distance_field_report report = field.compute(limits, shared);
    std::transform(next, m_points.end(), row.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   [&](const Surface_location& at) { return field.distance(at); });
    return report;
  }

  static void mirror(std::vector<std::vector<double>>& rows)
  {
    for(std::size_t i = 0; i < rows.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        rows[i][j] = rows[j][i];
  }

  static bool is_confirmed(const Distance_field_report& report)
  {
    return (report.status == Distance_field_status::COMPLETE ||
            report.status == Distance_field_status::TARGETS_REACHED) &&
           !report.has_flat_face && !report.has_inaccurate_distance;
  }

  static void summarize(const std::vector<Distance_field_report>& reports, const Interruption& interruption,
                        Computed_values<std::vector<double>>& result)
  {
    for(const Distance_field_report& report : reports)
      result.report.windows += report.windows;
    for(std::size_t i = 0; i < result.values.size(); ++i)
      result.report.vertices += static_cast<std::size_t>(
          std::count_if(result.values[i].begin() + static_cast<std::ptrdiff_t>(i) + 1, result.values[i].end(),
                        [](double distance) { return std::isfinite(distance); }));
    result.report.verdict = verdict_of_distances(!interruption.has_occurred() &&
                                                 std::all_of(reports.begin(), reports.end(), is_confirmed));
    if(interruption.has_occurred())
      result.report.status = Shortening_status::STOPPED_BY_VISITOR;
  }

  const Triangulation& m_triangulation;
  const Triangle_mesh& m_mesh;
  std::vector<Surface_location> m_points;
  Window_limit m_limit;
  Distance_field_extent m_extent;
};

/* A vertex, a place of another kind, or a variant of such, as a place of the mesh. */
template <class Triangulation, class TriangleMesh, class Point>
Surface_location matrix_point(const Triangulation& triangulation, const TriangleMesh& mesh, const Point& point)
{
  if constexpr(Is_variant<Point>::value)
    return std::visit([&](const auto& p) { return located_place(triangulation, mesh, p); }, point);
  else
    return located_place(triangulation, mesh, point);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsDistances
 *
 * Computes the distances on the surface between all pairs of some points: the rows of a symmetric matrix whose diagonal
 * is zero.
 *
 * The entries in row \f$i\f$ and column \f$j\f$ and in row \f$j\f$ and column \f$i\f$ are both, for \f$i < j\f$, the
 * distance of point \f$j\f$ in the `Geodesic_distance_field` of point \f$i\f$, which is exact up to rounding. Each
 * field is computed until all points after its source are reached, and is released when its row is complete. So the
 * memory is that of one field per thread, and of the matrix. The result does not depend on the number of threads.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the program must be linked to
 *         TBB for the second
 *
 * \param mesh a triangle mesh
 * \param points a range of vertices of the mesh, of `CGAL::Polygon_mesh_processing::Face_location`s, of
 *        `Surface_location`s, of points in space, or of `std::variant`s of several of these; see `surface_location()`
 *        for how points are snapped, and which point of the mesh is taken for one in space
 * \param rows an output iterator, which receives a `std::vector<double>` for each point, in the order of the points;
 *        infinity for points in different components, and for those that a field has not reached when it is given up
 * \param np named parameters: `search_limit`, a `Window_limit` for each field; `vertex_point_map`, `metric`,
 *        `geom_traits`, `visitor`, as for `geodesic_distances()`. The visitor's `go_further()` is called at regular
 *        intervals from the calling thread. If it returns `false`, then no row is written, and the report has the
 *        status `Shortening_status::STOPPED_BY_VISITOR` and is not confirmed. Before each of these calls a member
 *        `on_progress()`, if the visitor has one, is called with the fraction of the rows that are complete, a `double`
 *        from 0 to 1
 * \return the number of pairs whose distance is finite, as `vertices`, the number of windows of all fields, and whether
 *         all distances are confirmed
 * \throws Vertex_out_of_range_error, Invalid_location_error if a point is none of the mesh
 * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error as `Geodesic_distance_field::compute()`
 *
 * Complexity: for \f$k\f$ points that of \f$k - 1\f$ calls of `Geodesic_distance_field::compute()` that end at the
 * farthest point; \f$O(k^2)\f$ memory for the matrix. A point in space takes linear time.
 *
 * \sa `geodesic_distances()`
 */
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh, class PointRange, class OutputIterator,
          class... NamedParameters>
Distances_report geodesic_distance_matrix(const TriangleMesh& mesh, const PointRange& points, OutputIterator rows,
                                          const NamedParameters&... np)
{
  using Options = internal::Joined<NamedParameters...>;
  using Triangulation = typename internal::Curve_types<TriangleMesh, Options>::Triangulation;
  static_assert(internal::is_range<PointRange>,
                "no range of points where it belongs; the order is mesh, points, output, named parameters");
  const auto& options = internal::surface_options<internal_np::visitor_t, internal::Limit_parameter>(np...);
  const auto limit = internal::search_limit_of<Window_limit>(options);
  auto visitor = internal::make_visitor(options);
  const auto locate = [&](const Triangulation& triangulation) {
    std::vector<internal::Distance_source> result;
    for(const auto& point : points)
      result.push_back({false, {}, {internal::matrix_point(triangulation, mesh, point)}});
    return result;
  };
  std::vector<internal::Distance_source> given;
  const auto compute = [&](Triangulation& triangulation) {
    std::vector<Surface_location> locations;
    for(const internal::Distance_source& source : internal::sources_on_surface(triangulation, locate, given))
      locations.push_back(source.locations.front());
    const internal::Distance_matrix_rows<Triangulation> matrix(triangulation, mesh, std::move(locations), limit);
    return internal::confirmed_of_mesh(triangulation, matrix.template compute<ConcurrencyTag>(visitor.get()));
  };
  auto computed = internal::compute_on_surface(internal::Mesh_surfaces(mesh, options), compute);
  if(!internal::is_stopped_by_visitor(computed.report))
    std::move(computed.values.begin(), computed.values.end(), rows);
  return computed.report;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_DISTANCE_MATRIX_H
