// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_PATHS_H
#define CGAL_FLIP_GEODESICS_GEODESIC_PATHS_H

#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#include <CGAL/Flip_geodesics/internal/flip_out/located_points.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#endif

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsFunctions
/// Contains the result of `geodesic_paths()` for one path: its points, in the form that `geodesic_path()` writes, and
/// its report.
template <class Point>
struct Geodesic_path_result
{
  /// The points from the source to the target; empty if an exception was thrown, or if the visitor stopped the
  /// computation before an edge path was found.
  std::vector<Point> points;
  Shortening_report report = {std::vector<Curve_report>(1), 0, 0}; ///< the report on the curve, if no exception was
                                                                   ///< thrown
  std::exception_ptr error; ///< the exception that was thrown, or null; `std::rethrow_exception()` throws it again

  double length() const { return report.length(); }            ///< returns the length of the path
  Shortening_status status() const { return report.status(); } ///< returns how the shortening ended
  Verdict verdict() const { return report.verdict(); }         ///< returns the verdict on the path
};

namespace internal {

/* Computes one path after the other in one triangulation, whose flips are undone in between. */
template <class Form, class TriangleMesh, class NamedParameters>
class Path_workspace
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  using Triangulation = typename Types::Triangulation;
  using Search = Shortest_edge_path<Triangulation>;
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

public:
  using Result = Geodesic_path_result<Form>;

  Path_workspace(const TriangleMesh& mesh, const NamedParameters& np)
    : m_mesh(mesh)
    , m_landmarks(landmarks_of<Landmark_distances>(np))
    , m_np(np)
  {
  }

  /* Computes a path between vertices of the mesh, or points of any types. */
  template <class Source, class Target>
  Result operator()(const Source& source, const Target& target)
  {
    Result result;
    try {
      if(!is_to_go_on()) {
        result.report.curves.front().status = Shortening_status::STOPPED_BY_VISITOR;
        return result;
      }
      if(!m_memory)
        m_memory.emplace(m_mesh, m_np);
      return compute_between(source, target);
    } catch(...) {
      m_memory.reset(); // its state is unknown after an exception
      result.error = std::current_exception();
      return result;
    }
  }

private:
  // Triangulations, as given and contracted, and searches over them, which are reused for all paths.
  struct Memory
  {
    Memory(const TriangleMesh& mesh, const NamedParameters& np)
      : surfaces(mesh, np)
    {
    }

    Mesh_surfaces<TriangleMesh, NamedParameters> surfaces;
    std::optional<Search> search, contracted_search;
    std::optional<Place_finder<Triangulation>> find; // of points, on the mesh as given
  };

  bool is_to_go_on() const
  {
    auto visitor = make_visitor(m_np);
    return visitor.get().go_further();
  }

  Search& search_over(Triangulation& triangulation)
  {
    triangulation.rollback(); // the flips of the previous path
    std::optional<Search>& search =
        triangulation.input().is_contracted() ? m_memory->contracted_search : m_memory->search;
    if(!search && m_landmarks == nullptr)
      search.emplace(triangulation, parameters::search_method(Search_method::LOOK_BACK));
    else if(!search)
      search.emplace(triangulation, parameters::landmarks(*m_landmarks));
    return *search;
  }

  // The points are located once, on the mesh without contractions.
  template <class Source, class Target>
  Result compute_between(const Source& source, const Target& target)
  {
    Located_points given;
    const auto locate = [&](const Triangulation& triangulation) {
      if(!m_memory->find)
        m_memory->find.emplace(triangulation, m_mesh);
      return located_ends(*m_memory->find, source, target, m_np);
    };
    auto path = compute_on_surface(m_memory->surfaces, [&](Triangulation& triangulation) {
      triangulation.rollback(); // the flips of the previous path
      return path_through_points<Form>(triangulation, m_mesh, locate, given, m_np);
    });
    return {std::move(path.values), std::move(path.report), nullptr};
  }

  Result compute_between(Vertex source, Vertex target)
  {
    const auto search_over = [this](Triangulation& triangulation) -> Search& {
      return this->search_over(triangulation);
    };
    const auto& given = stop_predicate_of(m_np);
    const auto& stop = restarted(given);
    auto path = compute_on_surface(
        m_memory->surfaces,
        Path_computation<Form, TriangleMesh, NamedParameters, decltype(stop)&, decltype(search_over)>{
            m_mesh, source, target, m_np, stop, search_over});
    return {std::move(path.values), std::move(path.report), nullptr};
  }

  const TriangleMesh& m_mesh;
  const Landmark_distances* m_landmarks; // null if no landmarks are given
  const NamedParameters& m_np;
  std::optional<Memory> m_memory;
};

/* The pairs of a batch as they are computed: ends that are both vertices, or convert to vertices, become vertices. */
template <class TriangleMesh, class Pair>
struct Pair_of_ends
{
  using Vertices = std::pair<Mesh_vertex<TriangleMesh>, Mesh_vertex<TriangleMesh>>;
  using type = std::conditional_t<std::is_constructible<Vertices, Pair>::value, Vertices, void>;
};

template <class TriangleMesh, class Source, class Target>
struct Pair_of_ends<TriangleMesh, std::pair<Source, Target>>
{
  using Vertex = Mesh_vertex<TriangleMesh>;
  using type = std::conditional_t<is_mesh_vertex<TriangleMesh, Source> && is_mesh_vertex<TriangleMesh, Target>,
                                  std::pair<Vertex, Vertex>, std::pair<std::decay_t<Source>, std::decay_t<Target>>>;
};

/* The pairs of a range; `void` if its elements are not pairs. */
template <class TriangleMesh, class Range, bool IS_RANGE = is_range<Range>>
struct Pairs_in
{
  using type = void;
};
template <class TriangleMesh, class Range>
struct Pairs_in<TriangleMesh, Range, true> : Pair_of_ends<TriangleMesh, Range_value<Range>>
{
};
template <class TriangleMesh, class Range>
using Pair_of_ends_in = typename Pairs_in<TriangleMesh, Range>::type;

template <class Workspace, class Pairs, class MakeWorkspace>
void compute_paths(Sequential_tag, const Pairs& pairs, std::vector<typename Workspace::Result>& results,
                   const MakeWorkspace& make_workspace)
{
  const std::unique_ptr<Workspace> workspace = make_workspace();
  for(std::size_t i = 0; i < pairs.size(); ++i)
    results[i] = (*workspace)(pairs[i].first, pairs[i].second);
}

#ifdef CGAL_LINKED_WITH_TBB
template <class Workspace, class Pairs, class MakeWorkspace>
void compute_paths(Parallel_tag, const Pairs& pairs, std::vector<typename Workspace::Result>& results,
                   const MakeWorkspace& make_workspace)
{
  tbb::enumerable_thread_specific<std::unique_ptr<Workspace>> workspaces(make_workspace);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pairs.size()),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      Workspace& workspace = *workspaces.local();
                      for(std::size_t i = range.begin(); i != range.end(); ++i)
                        results[i] = workspace(pairs[i].first, pairs[i].second);
                    });
}
#endif

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes many geodesics on one mesh, each as `geodesic_path()` does, with a single triangulation per thread.
 *
 * The result of a pair depends neither on the number of threads nor on the other pairs. If an exception such as
 * `Disconnected_endpoints_error` is thrown for a pair, it is stored in the result of the pair, and the other paths are
 * still computed.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the program must be linked to
 *         TBB for `Parallel_tag`
 *
 * \param mesh a triangle mesh
 * \param pairs a range of `std::pair`s of a source and a target. Sources and targets are vertices, or points of any
 *        type that `geodesic_path()` accepts. If the types differ from pair to pair, the sources and targets are
 *        `std::variant`s of these types
 * \param out an output iterator that receives one `Geodesic_path_result` per pair, in the order of the pairs. The
 *        points of the results are points in space, `Face_location`s or `Curve_point`s, as for `geodesic_path()`
 * \param np an optional sequence of named parameters among those listed below, and `vertex_point_map`, `metric` and
 *        `geom_traits` as for `geodesic_path()`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{stop_predicate}
 *     \cgalParamDescription{a predicate that ends the shortening of a path early. It is called from all threads; if it
 *       has a member `restarted()`, the result of that member is used for each path}
 *     \cgalParamType{a model of `FlipOutStopPredicate`}
 *     \cgalParamDefault{`Never_stop_predicate`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor that is called from all threads. Its `go_further()` is also called before a pair
 *       is processed, and during the search for the edge path of the pair. If one of these calls returns `false`, the
 *       result of the pair has no points, and its status is `Shortening_status::STOPPED_BY_VISITOR`}
 *     \cgalParamType{a model of `FlipOutVisitor`, which is copied for each path unless it is passed by `std::ref()`}
 *     \cgalParamDefault{no visitor}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{landmarks}
 *     \cgalParamDescription{landmarks computed for this mesh and its metric, which accelerate the searches and are
 *       worthwhile for thousands of pairs. With landmarks, a path can lie on another side of a hole or a bump than
 *       without landmarks, but the lengths of the two paths are similar. If the landmarks were computed for a mesh with
 *       a different number of vertices, the result of each pair contains an `Input_mismatch_error`. Landmarks have no
 *       effect unless `pairs` is a range of pairs of vertices}
 *     \cgalParamType{`Landmark_distances`}
 *     \cgalParamDefault{no landmarks}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{greatest_point_distance}
 *     \cgalParamDescription{the greatest distance from the surface at which a point in space is accepted. The result of
 *       a pair with a point farther away contains a `Distant_point_error`; `Curve_report::point_distances` contains the
 *       distances}
 *     \cgalParamType{a non-negative number}
 *     \cgalParamDefault{no limit}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the past-the-end output iterator
 *
 * Complexity: the time of the searches and of `shorten()` for all pairs. A mesh other than a `Surface_mesh` is indexed
 * once per thread, in \cgalBigO{n \log n} time for \f$n\f$ faces. If points in space are given, locating them takes
 * \cgalBigO{n \log n} time once per thread, plus \cgalBigO{\log n} time for each point close to the surface. If an
 * exception is thrown for a pair, the thread repeats these preparations before its next pair.
 */
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh, class PairRange, class OutputIterator,
          class... NamedParameters>
OutputIterator geodesic_paths(const TriangleMesh& mesh, const PairRange& pairs, OutputIterator out,
                              const NamedParameters&... np)
{
#ifdef CGAL_LINKED_WITH_TBB
  using Tag =
      std::conditional_t<std::is_convertible<ConcurrencyTag, Parallel_tag>::value, Parallel_tag, Sequential_tag>;
#else
  static_assert(
      !std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
      "Parallel_tag requires TBB: link the target CGAL::TBB_support, or define CGAL_LINKED_WITH_TBB and link tbb");
  using Tag = Sequential_tag;
#endif
  const auto& options =
      internal::curve_options<internal::Landmarks_parameter, internal::Point_distance_parameter>(np...);
  using Options = internal::Joined<NamedParameters...>;
  using Form = internal::Form_by_name<TriangleMesh, Options, OutputIterator, Geodesic_path_result>;
  using Workspace = internal::Path_workspace<Form, TriangleMesh, Options>;
  using Pair = internal::Pair_of_ends_in<TriangleMesh, PairRange>;
  static_assert(!std::is_void<Pair>::value, "a range of std::pairs of end points is expected here; the order of the "
                                            "arguments is mesh, pairs, output, named parameters");
  if constexpr(std::is_void<Pair>::value) {
    return out; // so that no other message follows
  } else {
    const std::vector<Pair> ends(std::begin(pairs), std::end(pairs));
    std::vector<typename Workspace::Result> results(ends.size());
    internal::compute_paths<Workspace>(Tag(), ends, results,
                                       [&] { return std::make_unique<Workspace>(mesh, options); });
    return std::move(results.begin(), results.end(), out);
  }
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_GEODESIC_PATHS_H
