// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEST_PATHS_BY_CLASS_H
#define CGAL_FLIP_GEODESICS_SHORTEST_PATHS_BY_CLASS_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#include <CGAL/Flip_geodesics/internal/flip_out/located_points.h>
#include <CGAL/Flip_geodesics/internal/shortest/Split_surface.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Class_paths.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsFunctions
/// States how a search for paths of different classes ended.
enum class Class_search_status {
  FOUND,             ///< a path has been found for each requested class
  NO_MORE_CLASSES,   ///< fewer classes exist than requested, and a path has been found for each
  COVERING_LIMIT,    ///< the `Covering_limit` was exceeded; paths may be missing, or may not be shortest
  STOPPED_BY_VISITOR ///< `go_further()` of the visitor returned `false`, and no paths are returned
};

/// \ingroup PkgFlipGeodesicsFunctions
/// Returns the name of a status, spelled like the enumerator.
inline const char* to_string(Class_search_status status)
{
  return internal::name_of(status, {"FOUND", "NO_MORE_CLASSES", "COVERING_LIMIT", "STOPPED_BY_VISITOR"});
}

/// \ingroup PkgFlipGeodesicsFunctions
/// Describes a homotopy class of paths between two points of a mesh.
template <class TriangleMesh>
struct Path_class
{
  /// The halfedge type of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// A shortest edge path of the class within the constructed part of the universal cover; a shorter one can exist
  /// outside this part. For the first classes in the order of `edge_length`, up to the requested number, the path is
  /// shortest in the entire cover. If an end is not a vertex, the part of the path inside the face or edge of this end
  /// is not included.
  std::vector<halfedge_descriptor> edge_path;
  double edge_length = 0; ///< the length of `edge_path`
  /// The length of the shortest path found in the class. It is infinite if no path was computed, usually because the
  /// lower bound excludes the class.
  double length = std::numeric_limits<double>::infinity();
  double lower_bound = 0; ///< a lower bound on the lengths of paths of the class, with allowance for rounding errors
};

/// \ingroup PkgFlipGeodesicsFunctions
/// Reports on the shortest paths of different classes.
template <class TriangleMesh>
struct Paths_by_class_report
{
  std::vector<Shortest_path_report> paths;        ///< the reports on the paths, sorted by length; each states whether
                                                  ///< its path is confirmed to be shortest in its class
  std::vector<Path_class<TriangleMesh>> classes;  ///< the classes of the paths, in the same order
  std::vector<Path_class<TriangleMesh>> left_out; ///< further classes that were found, sorted by the smaller of
                                                  ///< `length` and `lower_bound`
  /// A lower bound on the lengths of paths in classes that were not found; infinite if all classes were found.
  double lower_bound = 0;
  Class_search_status status = Class_search_status::FOUND; ///< how the search ended
  std::size_t visited = 0;                                 ///< the number of vertices of the universal cover that
                                                           ///< were visited

  /// Returns a proven lower bound on the lengths of all paths whose classes are not represented in `paths`. The bound
  /// is infinite if every class is represented. If the report is not confirmed, the bound can be less than the length
  /// of the last path.
  double lower_bound_of_others() const
  {
    double least = lower_bound;
    for(const auto& other : left_out)
      least = (std::min)(least, other.lower_bound);
    return least;
  }

  /// Returns the verdict on the claim that each of `paths` is shortest in its class, and that no path of any other
  /// class is shorter than the last of `paths`. The claim is confirmed if each path is confirmed to be shortest in its
  /// class, and `lower_bound_of_others()` is at least the length of the last path, up to
  /// `Shortest_path_report::tolerance()`. The verdict refers to the returned paths, even if fewer were found than
  /// requested. If no path was returned, the claim is not confirmed.
  ///
  /// With a larger `Covering_limit`, a further path may be found but not confirmed. A larger limit can therefore lead
  /// to a weaker verdict, although the paths confirmed with the smaller limit remain the shortest ones.
  Verdict verdict() const
  {
    const double least = lower_bound_of_others();
    for(const Shortest_path_report& path : paths)
      if(!path.is_confirmed() || least < path.length * (1 - Shortest_path_report::tolerance()))
        return Verdict::UNDECIDED;
    return paths.empty() ? Verdict::UNDECIDED : Verdict::WITHIN_TOLERANCE;
  }

  /// Returns whether the claim of `verdict()` is confirmed.
  bool is_confirmed() const { return Flip_geodesics::is_confirmed(verdict()); }
};

/// \ingroup PkgFlipGeodesicsFunctions
/// Contains the result of `shortest_paths_by_class()`: the end of the output, and a report on the paths.
template <class TriangleMesh, class OutputIterator>
struct Paths_by_class_result
{
  OutputIterator out;                         ///< the past-the-end iterator of the output
  Paths_by_class_report<TriangleMesh> report; ///< the report on the paths

  std::size_t number_of_curves() const { return report.paths.size(); } ///< returns the number of paths
  /// Returns the length of path `i`.
  double length(std::size_t i) const { return report.paths.at(i).length; }
  /// Returns the status of path `i`.
  Shortening_status status(std::size_t i) const { return report.paths.at(i).status(); }
  /// Returns the verdict on path `i`.
  Verdict verdict(std::size_t i) const { return report.paths.at(i).verdict; }
  Class_search_status status() const { return report.status; } ///< returns how the search ended
  Verdict verdict() const { return report.verdict(); }         ///< returns the verdict on all paths together
};

/// \ingroup PkgFlipGeodesicsFunctions
/// Limits the number of vertices of the universal cover that `shortest_paths_by_class()` visits; each vertex takes
/// about 1200 bytes. The search is aborted when it exceeds this limit \f$v\f$, or when it has created more than
/// \f$10^6 + 200 v\f$ windows to compute shortest paths.
class Covering_limit
{
public:
  /// Sets the default limit, \f$10^6 + 20 n\f$ for a mesh with \f$n\f$ vertices.
  Covering_limit() = default;

  /// Sets an approximate maximum number of vertices.
  explicit Covering_limit(std::size_t vertices)
    : m_vertices(vertices)
  {
  }

  /// Returns the limit for a mesh with a given number of vertices.
  std::size_t operator()(std::size_t number_of_vertices) const
  {
    return m_vertices.value_or(1000000 + 20 * number_of_vertices);
  }

private:
  std::optional<std::size_t> m_vertices;
};

namespace internal {

template <class TriangleMesh, class Form>
using Paths_of_classes = Computed_output<std::vector<Form>, Paths_by_class_report<TriangleMesh>>;

/* Converts points in a cover to the form that an output accepts. */
template <class Form, class Triangulation, class TriangleMesh>
class Covering_form_converter
{
  using Paths = Class_paths<Triangulation>;
  using Forms = Curve_forms<Triangulation>;
  using All = typename Forms::All;

public:
  Covering_form_converter(const Triangulation& triangulation, const TriangleMesh& mesh, const Paths& paths)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_paths(paths)
  {
  }

  Form operator()(const typename Paths::Place& p) const
  {
    if constexpr(std::is_same<Form, All>::value) {
      return everything(p);
    } else if constexpr(std::is_same<Form, typename Forms::Point>::value) {
      return p.point;
    } else {
      using Number = typename Form::second_type::value_type;
      const auto& weights = p.location.second;
      return {face_below(p), {{Number(weights[0]), Number(weights[1]), Number(weights[2])}}};
    }
  }

private:
  auto halfedge_below(Input_halfedge_index h) const { return m_triangulation.input().halfedge(m_paths.below(h)); }

  auto face_below(const typename Paths::Place& p) const
  {
    return graph_face(halfedge_below(p.location.first.halfedge), m_mesh);
  }

  All everything(const typename Paths::Place& p) const
  {
    All result;
    result.location = {face_below(p), p.location.second};
    if(p.halfedge != null_index)
      result.halfedge = halfedge_below(p.halfedge);
    if constexpr(!std::is_void<typename Forms::Point>::value) {
      result.point = p.point;
      result.tangent = p.tangent;
    }
    return result;
  }

  const Triangulation& m_triangulation;
  const TriangleMesh& m_mesh;
  const Paths& m_paths;
};

/*
 * Returns whether a halfedge used in the search lies on an edge of the mesh, which is not the case beside points that
 * are vertices of a split surface only.
 */
template <class Input_mesh>
bool is_edge_of_mesh(const Input_mesh&, Input_halfedge_index)
{
  return true;
}

template <class TriangleMesh>
bool is_edge_of_mesh(const Indexed_mesh<Split_surface<TriangleMesh>>& input, Input_halfedge_index h)
{
  const Split_side* const side = input.surface().find(h);
  return side == nullptr || side->is_whole;
}

/*
 * `whole` is the triangulation of the mesh or of the contracted surface in which the paths are searched, or from which
 * that one was split.
 */
template <class TriangleMesh, class Whole, class Triangulation>
Path_class<TriangleMesh> path_class(const Whole& whole, const Triangulation& triangulation,
                                    const Class_paths<Triangulation>& paths, Index lift, double length,
                                    double lower_bound)
{
  Path_class<TriangleMesh> result;
  for(Input_halfedge_index h : paths.search().path(lift))
    if(is_edge_of_mesh(triangulation.input(), h))
      result.edge_path.push_back(whole.input().halfedge(h));
  result.edge_length = paths.search().distance(lift);
  result.length = length;
  result.lower_bound = lower_bound;
  return result;
}

template <class TriangleMesh, class Whole, class Triangulation>
Paths_by_class_report<TriangleMesh> report_of(const Whole& whole, const Triangulation& triangulation,
                                              const Class_paths<Triangulation>& paths, std::size_t number)
{
  Paths_by_class_report<TriangleMesh> report;
  for(const auto& path : paths.paths()) {
    report.paths.push_back(path.report);
    note_contraction(whole, report.paths.back().shortening);
    report.classes.push_back(
        path_class<TriangleMesh>(whole, triangulation, paths, path.lift, path.report.length, path.report.lower_bound));
  }
  for(const auto& other : paths.left_out())
    report.left_out.push_back(
        path_class<TriangleMesh>(whole, triangulation, paths, other.lift, other.length, other.lower_bound));
  report.lower_bound = paths.frontier_bound();
  report.visited = paths.search().number_of_lifts();
  const double longest = report.paths.empty() ? 0 : report.paths.back().length;
  if(paths.is_interrupted())
    report.status = Class_search_status::STOPPED_BY_VISITOR;
  else if(paths.search().is_exhausted())
    report.status = report.paths.size() < number ? Class_search_status::NO_MORE_CLASSES : Class_search_status::FOUND;
  else if(report.paths.size() < number || report.lower_bound < longest)
    report.status = Class_search_status::COVERING_LIMIT;
  return report;
}

/*
 * Computes the paths of a number of classes between two vertices; `convert(paths, places)` converts a path to values.
 */
template <class TriangleMesh, class Form, class Whole, class Triangulation, class Convert>
Paths_of_classes<TriangleMesh, Form> find_paths_by_class(const Whole& whole, const Triangulation& triangulation,
                                                         Class_paths<Triangulation>&& paths, std::size_t number,
                                                         const Covering_limit& limit, const Convert& convert)
{
  paths.run(number, limit(static_cast<std::size_t>(triangulation.number_of_vertices())));
  Paths_of_classes<TriangleMesh, Form> result;
  for(const auto& path : paths.paths())
    result.values.push_back(convert(paths, path.places));
  result.report = report_of<TriangleMesh>(whole, triangulation, paths, number);
  return result;
}

/* Computes the paths between vertices of the triangulation of a mesh. */
template <class Form, class Triangulation, class TriangleMesh>
Paths_of_classes<TriangleMesh, Form> paths_by_class_between(const Triangulation& triangulation,
                                                            const TriangleMesh& mesh, Vertex_index source,
                                                            Vertex_index target, std::size_t number,
                                                            const Covering_limit& limit, Interruption& interruption)
{
  const auto convert = [&](const Class_paths<Triangulation>& paths, const auto& places) {
    const Covering_form_converter<Form, Triangulation, TriangleMesh> converter(triangulation, mesh, paths);
    std::vector<Form> values;
    for(const auto& place : places)
      values.push_back(converter(place));
    return values;
  };
  return find_paths_by_class<TriangleMesh, Form>(
      triangulation, triangulation, Class_paths<Triangulation>(triangulation, mesh, source, target, interruption),
      number, limit, convert);
}

/* Computes the paths between points of the surface, given by canonical locations. */
template <class Form, class Triangulation, class TriangleMesh>
Paths_of_classes<TriangleMesh, Form> paths_by_class_between(Triangulation& triangulation, const TriangleMesh& mesh,
                                                            const std::vector<Surface_location>& ends,
                                                            std::size_t number, const Covering_limit& limit,
                                                            Interruption& interruption)
{
  const Vertex_index at_source = triangulation.input().tail(ends[0].halfedge);
  const Vertex_index at_target = triangulation.input().tail(ends[1].halfedge);
  if(are_vertices(ends))
    return paths_by_class_between<Form>(triangulation, mesh, at_source, at_target, number, limit, interruption);
  Split_triangulation<Triangulation> split(triangulation, ends);
  using Paths = Class_paths<typename Split_triangulation<Triangulation>::Split>;
  const auto convert = [&](const Paths& paths, const auto& places) {
    Surface_polyline path;
    for(const auto& place : places) {
      const Surface_location at = {paths.below(place.location.first.halfedge), place.location.second};
      if(const auto below = split.surface().location_below(canonical_location(split.triangulation().input(), at)))
        path.push_back(*below);
    }
    return polyline_forms<Form>(triangulation, mesh, std::vector<Surface_polyline>(1, path));
  };
  try {
    return find_paths_by_class<TriangleMesh, Form>(
        triangulation, split.triangulation(),
        Paths(split.triangulation(), split.surface(), split.vertex(0), split.vertex(1), interruption), number, limit,
        convert);
  } catch(const Disconnected_endpoints_error&) {
    throw_disconnected_points(at_source, at_target); // one of them is not a vertex of the mesh
  }
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes the shortest homotopically distinct paths on the surface between two points: a shortest path in each of
 * `number` homotopy classes. The classes with the shortest paths are chosen. Any two of the paths together form a
 * closed curve that cannot be contracted to a point.
 *
 * On a sphere or a disk, only one class exists. Obstacles can create further classes: the mesh can be a
 * `CGAL::Face_filtered_graph` without the faces that paths must not enter. The function contracts degenerate edges if
 * they affect the result. If the ends are the same point, the first path consists of this point and has length zero,
 * and the others are the shortest loops at the point, one in each class.
 *
 * \param mesh a triangle mesh in which no two umbrellas meet at a vertex
 * \param source, target points in the same connected component, of any types that `shortest_path()` accepts
 * \param number the number of classes
 * \param out an output iterator that receives one `std::vector` per path, in order of increasing length of the paths.
 *        Each vector contains the points that `geodesic_path()` would write
 * \param np an optional sequence of named parameters among those listed below, `vertex_point_map`, `metric` and
 *        `geom_traits` as for `geodesic_path()`, and `greatest_point_distance` as for `shortest_path()`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{search_limit}
 *     \cgalParamDescription{the limit at which the search is aborted; the report then contains the results obtained up
 *       to this point}
 *     \cgalParamType{`Covering_limit`}
 *     \cgalParamDefault{`Covering_limit()`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor, of which only `go_further()` is called, at regular intervals. Flips are not
 *       reported, since they take place in the universal cover of the mesh}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *     \cgalParamExtra{If `go_further()` returns `false`, no path is written, and the report is unconfirmed and has the
 *       status `Class_search_status::STOPPED_BY_VISITOR`.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the past-the-end output iterator, and a report
 * \pre `number > 0`
 * \throws Invalid_mesh_error if a face is not a triangle, an edge does not belong to a face, or several umbrellas meet
 *         at a vertex
 * \throws Vertex_out_of_range_error as `shortest_path()` does
 * \throws Disconnected_endpoints_error as `shortest_path()` does
 * \throws Degenerate_face_error as `shortest_path()` does
 * \throws Invalid_coordinate_error as `shortest_path()` does
 * \throws Invalid_location_error as `shortest_path()` does
 * \throws Distant_point_error as `shortest_path()` does
 * \throws Insertion_error as `shortest_path()` does
 *
 * Complexity: \cgalBigO{m \log m} time, where \f$m\f$ is the number of vertices of the cover that are visited, plus the
 * time of `shortest_path()` for each path. Sort the shortest edge paths of all classes by length, and let \f$L\f$ be
 * the length of path `number`. A vertex is visited if an edge path of length at most \f$L\f$ leads through it. Further
 * vertices are visited, roughly those through which a path can be shorter than the last result. If the limit is
 * reached, the time is roughly proportional to the limit.
 *
 * The function searches for shortest edge paths in the universal cover of the surface, in which each class of paths has
 * its own end point. A part of the cover is constructed. In this part, shortest paths to these end points are computed
 * as by `shortest_path()`. The lengths of paths that leave the part are bounded from below, and the part is enlarged
 * until these bounds exceed the lengths of the computed paths. If the search is aborted instead, paths can be missing
 * or remain unconfirmed.
 *
 * \sa `shortest_path()`
 */
template <class TriangleMesh, class Source, class Target, class OutputIterator, class... NamedParameters>
Paths_by_class_result<TriangleMesh, OutputIterator> shortest_paths_by_class(const TriangleMesh& mesh,
                                                                            const Source& source, const Target& target,
                                                                            std::size_t number, OutputIterator out,
                                                                            const NamedParameters&... np)
{
  const auto& options =
      internal::surface_options<internal_np::visitor_t, internal::Limit_parameter, internal::Point_distance_parameter>(
          np...);
  CGAL_precondition_msg(number > 0, "the number of homotopy classes must be positive");
  using Types = internal::Curve_types<TriangleMesh, internal::Joined<NamedParameters...>>;
  using Triangulation = typename Types::Triangulation;
  using Form = internal::Curve_form<Triangulation, OutputIterator, internal::Vector_of>;
  const auto limit = internal::search_limit_of<Covering_limit>(options);
  auto visitor = internal::make_visitor(options);
  internal::Interruption interruption(visitor.get());
  internal::Located_points given;
  const auto compute_paths = [&](Triangulation& triangulation) {
    if constexpr(internal::is_mesh_vertex<TriangleMesh, Source> && internal::is_mesh_vertex<TriangleMesh, Target>) {
      using Vertex = Mesh_vertex<TriangleMesh>;
      return internal::paths_by_class_between<Form>(triangulation, mesh, triangulation.index(Vertex(source)),
                                                    triangulation.index(Vertex(target)), number, limit, interruption);
    } else {
      const auto locate = [&](const Triangulation& as_is) {
        return internal::located_ends(as_is, mesh, source, target, options);
      };
      auto result = internal::paths_by_class_between<Form>(
          triangulation, mesh, internal::canonical_points(triangulation, locate, given), number, limit, interruption);
      for(Shortest_path_report& path : result.report.paths)
        path.shortening.curves.front().point_distances = given.distances;
      return result;
    }
  };
  const auto compute = [&](Triangulation& triangulation) {
    internal::Paths_of_classes<TriangleMesh, Form> result;
    if(!internal::result_unless_interrupted([&] { return result = compute_paths(triangulation), true; }))
      result.report.status = Class_search_status::STOPPED_BY_VISITOR;
    return result;
  };
  return internal::write_computed<Paths_by_class_result<TriangleMesh, OutputIterator>>(
      internal::compute_on_surface(internal::Mesh_surfaces(mesh, options), compute), out);
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_SHORTEST_PATHS_BY_CLASS_H
