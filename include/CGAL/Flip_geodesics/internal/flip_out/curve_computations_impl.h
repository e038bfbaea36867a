// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_COMPUTATIONS_IMPL_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_COMPUTATIONS_IMPL_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>
#include <CGAL/Flip_geodesics/straightened_path.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef CGAL_FLIP_GEODESICS_COMPILED
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#endif

namespace CGAL::Flip_geodesics {
namespace internal {

template <class TriangleMesh>
struct compiled::Definitions
{
};

/* Forwards only the decision whether to continue, for steps that the caller's visitor does not observe. */
struct Interrupting_visitor : Default_shortening_visitor
{
  explicit Interrupting_visitor(Interruption& interruption_)
    : interruption(interruption_)
  {
  }

  bool go_further() { return !interruption.begin_part(); }

  Interruption& interruption;
};

/* Forwards all calls to a visitor in a computation that consists of several shortenings. Once the visitor has stopped
 * one of them, no further step is taken and the visitor is not called again. */
template <class Visitor>
class Stop_remembering_visitor
{
public:
  explicit Stop_remembering_visitor(Visitor& visitor)
    : m_visitor(visitor)
    , m_interruption(visitor)
  {
  }

  template <class Triangulation>
  void on_flip(const Triangulation& triangulation, Halfedge_index h)
  {
    m_visitor.on_flip(triangulation, h);
  }

  template <class Network>
  void after_flip_out(const Network& network, Curve_index curve)
  {
    m_visitor.after_flip_out(network, curve);
  }

  bool go_further() { return !m_interruption.begin_part(); }
  bool has_stopped() const { return m_interruption.has_occurred(); }

private:
  Visitor& m_visitor;
  Interruption m_interruption;
};

/* Returns whether the visitor observes the steps of a shortening, which must then start from the given path. */
template <class Visitor>
constexpr bool observes_steps =
    !std::is_same<Visitor, Default_shortening_visitor>::value && !std::is_same<Visitor, Interrupting_visitor>::value;

/*
 * Adds a path from which a geodesic between its ends is computed to an empty network. The path is first straightened by
 * a funnel initialization unless the steps that shorten it are observed. Returns the number of edges flipped.
 */
template <bool IsObserved, class Network>
std::size_t add_start(Network& network, const std::vector<Halfedge_index>& path)
{
  if constexpr(!IsObserved)
    return add_straightened_path(network, path);
  network.add_curve(path);
  return 0;
}

/* Adds the flips of the funnel initialization to the report. */
inline void count_start(Shortening_report& report, std::size_t flips)
{
  report.flips += flips;
  report.curves.front().flips += flips;
}

/* Computes the edge path from which a geodesic starts; empty if the visitor stops the search. */
template <class Search, class Visitor>
std::vector<Halfedge_index> edge_path_between(Search& search, const std::vector<Vertex_index>& ends, Visitor& visitor)
{
  if constexpr(std::is_same<Visitor, Default_shortening_visitor>::value)
    return shortest_halfedges_through(search, ends);
  else
    return shortest_halfedges_through(search, ends, parameters::visitor(std::ref(visitor)));
}

/* Returns the report of a search that a visitor stopped before there was a path. */
inline Shortening_report report_of_stopped_search()
{
  Shortening_report report;
  report.curves.emplace_back();
  report.curves.back().status = Shortening_status::STOPPED_BY_VISITOR;
  return report;
}

/* Returns the points of a curve of a network in the output's value type; none for a loop contracted to a point. */
template <class Form, class Network, class TriangleMesh>
std::vector<Form> curve_forms(const Network& network, const TriangleMesh& mesh, Curve_index curve)
{
  using Triangulation = typename Network::Triangulation;
  std::vector<Form> result;
  if(network.is_closed(curve) && network.length(curve) == 0)
    return result;
  Curve_extractor<Network> extractor(network);
  if constexpr(std::is_same<Form, typename Curve_forms<Triangulation>::All>::value) {
    extractor.curve_points(curve, mesh, std::back_inserter(result));
  } else {
    const Form_converter<Triangulation, Form> convert(network.triangulation(), mesh);
    for(const Surface_point& p : extractor.surface_points(curve))
      result.push_back(convert(p));
  }
  return result;
}

/* Returns the zero-length path between coincident vertices: its two end points. */
template <class Form, class Triangulation, class TriangleMesh>
Computed_output<Form> path_in_one_place(const Triangulation& triangulation, const TriangleMesh& mesh, Vertex_index v)
{
  check_vertex(v, triangulation.input().number_of_vertices());
  if(triangulation.input().outgoing(v) == null_index) {
    if(triangulation.input().is_contracted())
      throw_no_surface_left(v);
    throw_naming<Vertex_out_of_range_error>("vertex ", v, " is not in any face of the mesh");
  }
  Computed_output<Form> result;
  result.report.curves.push_back(report_of_point(triangulation));
  note_contraction(triangulation, result.report);
  const Form_converter<Triangulation, Form> convert(triangulation, mesh);
  result.values.assign(2, convert(surface_point_at_vertex(triangulation, v)));
  return result;
}

/*
 * Computes a geodesic between two vertices of a mesh in a triangulation of it. The object returned by
 * `search_over(triangulation)` computes the initial edge path. With a visitor or a stop predicate, that edge path
 * itself is shortened, so that they observe every step.
 */
template <class Form, class TriangleMesh, class NamedParameters, class StopPredicate, class SearchOver>
struct Path_computation
{
  using Network = typename Curve_types<TriangleMesh, NamedParameters>::Network;

  const TriangleMesh& mesh;
  Mesh_vertex<TriangleMesh> source, target;
  const NamedParameters& np;
  StopPredicate stop;
  const SearchOver& search_over;

  Computed_output<Form> operator()(typename Network::Triangulation& triangulation) const
  {
    auto&& search = search_over(triangulation);
    const std::vector<Vertex_index> ends = {triangulation.index(source), triangulation.index(target)};
    if(ends[0] == ends[1])
      return path_in_one_place<Form>(triangulation, mesh, ends[0]);
    auto visitor = make_visitor(np);
    const std::vector<Halfedge_index> path = edge_path_between(search, ends, visitor.get());
    if(path.empty())
      return {{}, report_of_stopped_search()};
    constexpr bool is_observed = observes_steps<std::decay_t<decltype(visitor.get())>> ||
                                 !std::is_same<std::decay_t<StopPredicate>, Never_stop_predicate>::value;
    Network network(triangulation);
    const std::size_t flips = add_start<is_observed>(network, path);
    Shortener<Network> shortener(network);
    shortener.run(stop, visitor.get());
    Shortening_report report = shortener.report();
    count_start(report, flips);
    note_contraction(triangulation, report);
    return {curve_forms<Form>(network, mesh, Curve_index(0)), std::move(report)};
  }
};

/* Adds a curve for each range of vertices of the mesh, closed if its last vertex is its first or if all curves are
 * loops. Returns whether each curve exists: none results from vertices that all coincide. */
template <class Network, class Vertex>
std::vector<bool> add_vertex_curves(Network& network, const std::vector<std::vector<Vertex>>& curves, bool are_loops)
{
  std::vector<bool> result;
  for(const std::vector<Vertex>& curve : curves) {
    std::vector<Vertex_index> vertices;
    for(const Vertex& v : curve)
      vertices.push_back(network.triangulation().input().uncontracted().index(v));
    const bool repeats_first = vertices.size() > (are_loops ? 1 : 2) && vertices.front() == vertices.back();
    if(repeats_first)
      vertices.pop_back();
    const bool is_closed = are_loops || repeats_first;
    const std::vector<Halfedge_index> halfedges = halfedges_on_surface(network.triangulation(), vertices, is_closed);
    if(!halfedges.empty())
      network.add_curve(halfedges, parameters::is_closed(is_closed));
    result.push_back(!halfedges.empty());
  }
  return result;
}

/* Shortens curves that are given by their vertices. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<std::vector<Form>> compute_curves(const TriangleMesh& mesh,
                                                  const std::vector<Vertices_of<TriangleMesh>>& curves, bool are_loops,
                                                  const NamedParameters& np)
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  return compute_on_surface(Mesh_surfaces(mesh, np), [&](typename Types::Triangulation& triangulation) {
    typename Types::Network network(triangulation);
    const std::vector<bool> has_length = add_vertex_curves(network, curves, are_loops);
    order_overlapping_curves(network);
    auto visitor = make_visitor(np);
    Computed_output<std::vector<Form>> result;
    result.report = shorten(network, stop_predicate_of(np), visitor.get());
    auto& reports = result.report.curves;
    for(std::size_t i = 0, c = 0; i < has_length.size(); ++i) {
      result.values.emplace_back();
      if(has_length[i])
        result.values.back() = curve_forms<Form>(network, mesh, Curve_index(static_cast<Index>(c++)));
      else
        reports.insert(reports.begin() + static_cast<std::ptrdiff_t>(i), report_of_point(triangulation));
    }
    note_contraction(triangulation, result.report);
    return result;
  });
}

/* Computes the result of `geodesic_path()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<Form> compute_path(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                   Mesh_vertex<TriangleMesh> target, const NamedParameters& np)
{
  using Search = Shortest_edge_path<typename Curve_types<TriangleMesh, NamedParameters>::Triangulation>;
  const auto search_over = [](const auto& triangulation) {
    return Search(triangulation, parameters::search_method(Search_method::LOOK_BACK));
  };
  return compute_on_surface(
      Mesh_surfaces(mesh, np),
      Path_computation<Form, TriangleMesh, NamedParameters, decltype(stop_predicate_of(np)), decltype(search_over)>{
          mesh, source, target, np, stop_predicate_of(np), search_over});
}

/* Computes the result of `geodesic_loop()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<Form> compute_loop(const TriangleMesh& mesh, const Vertices_of<TriangleMesh>& vertices,
                                   const NamedParameters& np)
{
  auto computed = compute_curves<Form>(mesh, {vertices}, true, np);
  return {std::move(computed.values.front()), std::move(computed.report)};
}

/* Computes the result of `geodesic_network()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<std::vector<Form>> compute_network(const TriangleMesh& mesh,
                                                   const std::vector<Vertices_of<TriangleMesh>>& curves,
                                                   const NamedParameters& np)
{
  return compute_curves<Form>(mesh, curves, false, np);
}

} // namespace internal

#ifdef CGAL_FLIP_GEODESICS_COMPILED

/*
 * The instances in the compiled library: those of the free functions' computations with default options. A header of
 * such functions declares them. All other instances are compiled where they are used, as without the library.
 */

/* Expands to `INSTANCES(mesh)` for each mesh. */
#define CGAL_FLIP_GEODESICS_FOR_COMPILED_MESHES(INSTANCES)                                                             \
  INSTANCES(compiled::Cartesian_mesh)                                                                                  \
  INSTANCES(compiled::Filtered_mesh)

/* Expands to `INSTANCES(mesh, form)` for each mesh and each value type of an output. */
#define CGAL_FLIP_GEODESICS_FOR_COMPILED_FORMS(INSTANCES)                                                              \
  INSTANCES(compiled::Cartesian_mesh, compiled::Point<compiled::Cartesian_mesh>)                                       \
  INSTANCES(compiled::Cartesian_mesh, compiled::Location<compiled::Cartesian_mesh>)                                    \
  INSTANCES(compiled::Cartesian_mesh, compiled::All<compiled::Cartesian_mesh>)                                         \
  INSTANCES(compiled::Filtered_mesh, compiled::Point<compiled::Filtered_mesh>)                                         \
  INSTANCES(compiled::Filtered_mesh, compiled::Location<compiled::Filtered_mesh>)                                      \
  INSTANCES(compiled::Filtered_mesh, compiled::All<compiled::Filtered_mesh>)

/* A source file of the library defines one of these macros as `template`; the instances of the other headers are
 * declared. */
#ifndef CGAL_FLIP_GEODESICS_CURVES_INSTANCE
#define CGAL_FLIP_GEODESICS_CURVES_INSTANCE extern template
#endif
#ifndef CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_INSTANCE
#define CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_INSTANCE extern template
#endif
#ifndef CGAL_FLIP_GEODESICS_SHORTEST_PATH_INSTANCE
#define CGAL_FLIP_GEODESICS_SHORTEST_PATH_INSTANCE extern template
#endif
#ifndef CGAL_FLIP_GEODESICS_DISTANCES_INSTANCE
#define CGAL_FLIP_GEODESICS_DISTANCES_INSTANCE extern template
#endif

namespace internal {
namespace compiled {

using Cartesian_mesh = Surface_mesh<Simple_cartesian<double>::Point_3>;
using Filtered_mesh = Surface_mesh<Exact_predicates_inexact_constructions_kernel::Point_3>;

/* The value type of an output. */
template <class Mesh>
using Point = typename Mesh::Point;
template <class Mesh>
using Location = std::pair<typename boost::graph_traits<Mesh>::face_descriptor, std::array<double, 3>>;
template <class Mesh>
using All = Curve_point<Mesh, typename Mesh::Point>;

} // namespace compiled

#define CGAL_FLIP_GEODESICS_INSTANCES(Mesh, Form)                                                                      \
  CGAL_FLIP_GEODESICS_CURVES_INSTANCE Computed_output<Form> compute_path(                                              \
      const Mesh&, Mesh_vertex<Mesh>, Mesh_vertex<Mesh>, const parameters::Default_named_parameters&);                 \
  CGAL_FLIP_GEODESICS_CURVES_INSTANCE Computed_output<Form> compute_loop(const Mesh&, const Vertices_of<Mesh>&,        \
                                                                         const parameters::Default_named_parameters&); \
  CGAL_FLIP_GEODESICS_CURVES_INSTANCE Computed_output<std::vector<Form>> compute_network(                              \
      const Mesh&, const std::vector<Vertices_of<Mesh>>&, const parameters::Default_named_parameters&);
CGAL_FLIP_GEODESICS_FOR_COMPILED_FORMS(CGAL_FLIP_GEODESICS_INSTANCES)
#undef CGAL_FLIP_GEODESICS_INSTANCES

} // namespace internal
#endif

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_COMPUTATIONS_IMPL_H
