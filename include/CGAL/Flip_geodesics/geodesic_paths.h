// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_PATHS_H
#define CGAL_FLIP_GEODESICS_GEODESIC_PATHS_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_types.h>
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

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsFunctions
/// Contains the result of `geodesic_paths()` for one path: its points, in the form that `geodesic_path()` writes, and
/// its report.
template <class Point>
struct Geodesic_path_result
{
  /// The points from the source to the target; empty if an exception was thrown, or if the visitor stopped the
  /// computation before.
  std::vector<Point> points;
  Shortening_report report = {std::vector<Curve_report>(1), 0, 0}; ///< the report on the curve, if no exception was
                                                                   ///< thrown
  std::exception_ptr error; ///< the exception that was thrown, or null; `std::rethrow_exception()` throws it again

  double length() const { return report.curves.front().length; }            ///< returns the length of the path
  Shortening_status status() const { return report.curves.front().status; } ///< returns whether the path is a geodesic
  Verdict verdict() const { return report.curves.front().verdict; }         ///< returns whether this is certified
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

  /* Between vertices of the mesh, or points of any kinds. */
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
      search.emplace(triangulation, Search_method::LOOK_BACK);
    else if(!search)
      search.emplace(triangulation, *m_landmarks);
    return *search;
  }

  // The points are located once, on the mesh as it is.
  template <class Source, class Target>
  Result compute_between(const Source& source, const Target& target)
  {
    Located_points given;
    const auto locate = [&](const Triangulation& triangulation) {
      return located_ends(triangulation, m_mesh, source, target, m_np);
    };
    auto path = compute_on_surface(m_memory->surfaces, [&](Triangulation& triangulation) {
      triangulation.rollback(); // the flips of the path before
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

/* The pairs of a batch, as they are computed: ends that are both vertices, or become such by themselves, as vertices. */
template <class TriangleMesh, class Pair>
using Pair_of_ends = std::conditional_t<is_mesh_vertex<TriangleMesh, decltype(std::declval<const Pair&>().first)> &&
                                            is_mesh_vertex<TriangleMesh, decltype(std::declval<const Pair&>().second)>,
                                        std::pair<Vertex_in<TriangleMesh>, Vertex_in<TriangleMesh>>, Pair>;

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
 * Computes many geodesics on one mesh, each as `geodesic_path()` does, but in one triangulation per thread that is made
 * once. The results do not depend on the number of threads, nor on the other pairs.
 *
 * A pair for which something is thrown, such as `Disconnected_endpoints_error`, has that as its result; the others are
 * computed all the same.
 *
 * A visitor's `go_further()` is called before each pair and in the search for its edge path, too. If it returns `false`
 * there, then the pair has no path and the status `Shortening_status::STOPPED_BY_VISITOR`.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the program must be linked to
 *         TBB for the second
 *
 * \param mesh a triangle mesh
 * \param pairs a range of `std::pair`s of a source and a target: vertices, or points of any kinds that `geodesic_path()`
 *        takes, each source of one type and each target of one type
 * \param out receives a `Geodesic_path_result` per pair, in the order of the pairs, of what `geodesic_path()` writes: a
 *        `Geodesic_path_result` of the mesh's points, of `Face_location`s or of `Curve_point`s
 * \param np named parameters as for `geodesic_path()`. A `stop_predicate` is asked from all threads, for each path as
 *        `restarted()` if it can be; a `visitor` is called from all threads, a copy for each path unless it is given by
 *        `std::ref()`. `landmarks`, `Landmark_distances` made for this mesh and its metric, direct the searches, which
 *        pays if there are thousands of pairs: a path may then take another way round a hole or a bump, which is about
 *        as long. If they have more vertices than the mesh, or fewer, each path has an Input_mismatch_error. They have no
 *        effect on paths between points that are not vertices by their type.
 *        `greatest_point_distance` limits how far points in space may be from the surface; a pair with another one has a
 *        `Distant_point_error`, and `Curve_report::point_distances` has the distances
 * \return the end of the output
 *
 * Complexity: that of the searches and of `shorten()`; meshes other than `Surface_mesh` are indexed once per thread,
 * \f$O(n \log n)\f$.
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
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag asks for threads, but the program is not linked to TBB");
  using Tag = Sequential_tag;
#endif
  const auto& options =
      internal::curve_options<internal::Landmarks_parameter, internal::Point_distance_parameter>(np...);
  using Options = internal::Joined<NamedParameters...>;
  using Form = internal::Form_by_name<TriangleMesh, Options, OutputIterator, Geodesic_path_result>;
  using Workspace = internal::Path_workspace<Form, TriangleMesh, Options>;
  const std::vector<internal::Pair_of_ends<TriangleMesh, internal::Range_value<PairRange>>> ends(std::begin(pairs),
                                                                                                 std::end(pairs));
  std::vector<typename Workspace::Result> results(ends.size());
  internal::compute_paths<Workspace>(Tag(), ends, results, [&] { return std::make_unique<Workspace>(mesh, options); });
  return std::move(results.begin(), results.end(), out);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_PATHS_H
