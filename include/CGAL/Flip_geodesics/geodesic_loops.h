// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_LOOPS_H
#define CGAL_FLIP_GEODESICS_GEODESIC_LOOPS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Cut_edges.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>
#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics {

namespace internal {

inline void append_report(const Shortening_report& report, Shortening_report& sum)
{
  sum.curves.insert(sum.curves.end(), report.curves.begin(), report.curves.end());
  sum.flips += report.flips;
  sum.flip_outs += report.flip_outs;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes closed geodesics around the handles and holes of a surface, by shortening each loop of a `Loop_basis`
 * separately.
 *
 * The resulting geodesics can cross one another. For a sphere or a disk, the basis is empty.
 *
 * \param mesh a triangle mesh
 * \param out an output iterator that receives one `std::vector` of points for each loop, in the order of the basis. The
 *        form of the points is described at `geodesic_path()`
 * \param np named parameters, as for `geodesic_path()`; the stop predicate is applied to each loop separately. If the
 *        `go_further()` of a visitor returns `false` during the computation of the basis, nothing is written, and the
 *        report has one entry with `Shortening_status::STOPPED_BY_VISITOR`. If it returns `false` later, the remaining
 *        loops are written without being shortened
 * \return the past-the-end output iterator, and a report with one entry per loop
 * \throws Invalid_mesh_error as `Loop_basis` does
 * \throws Degenerate_face_error as `geodesic_path()` does
 * \throws Invalid_coordinate_error as `geodesic_path()` does
 *
 * Complexity: \cgalBigO{n \log n}, plus the time of `shorten()` for each loop.
 *
 * \sa `Loop_basis`
 */
template <class TriangleMesh, class OutputIterator, class... NamedParameters>
Geodesics_result<OutputIterator> geodesic_loop_basis(const TriangleMesh& mesh, OutputIterator out,
                                                     const NamedParameters&... np)
{
  const auto& options = internal::curve_options(np...);
  using Types = internal::Curve_types<TriangleMesh, internal::Joined<NamedParameters...>>;
  using Form = internal::Curve_form<typename Types::Triangulation, OutputIterator, internal::Vector_of>;
  const auto compute = [&](typename Types::Triangulation& triangulation) {
    auto visitor = internal::make_visitor(options);
    internal::Stop_remembering_visitor<std::remove_reference_t<decltype(visitor.get())>> remembering(visitor.get());
    const Loop_basis<typename Types::Triangulation> basis(triangulation, std::vector<Vertex_index>(),
                                                          parameters::visitor(std::ref(remembering)));
    internal::Computed_output<std::vector<Form>> result;
    if(!basis.is_complete())
      result.report = internal::report_of_stopped_search();
    for(Index i = 0; i < basis.number_of_loops(); ++i) {
      {
        typename Types::Network network(triangulation);
        const Curve_index curve = network.add_curve(basis.cycle(i), parameters::is_closed(true));
        internal::append_report(internal::shorten(network, internal::stop_predicate_of(options), remembering),
                                result.report);
        result.values.push_back(internal::curve_forms<Form>(network, mesh, curve));
      }
      triangulation.rollback();
    }
    internal::note_contraction(triangulation, result.report);
    return result;
  };
  return internal::write_computed<Geodesics_result<OutputIterator>>(
      internal::compute_on_surface(internal::Mesh_surfaces(mesh, options), compute), out);
}

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Shortens a network that cuts each component of a surface open into one or several disks. Afterwards, the curves cut
 * each component open into a single disk and are locally shortest between their ends.
 *
 * Disjoint curves can touch at a vertex or overlap along edges after they have been shortened. The curves can then
 * divide a component into several disks. In this case, a chain of edges between two different disks is superfluous,
 * because the disks merge into one if the chain is removed. Superfluous chains are therefore removed, the longest
 * first, together with all resulting dead ends. If only two curves remain at an interior vertex, they are joined into
 * one curve, which is not fixed at this vertex.
 *
 * Removals alternate with calls of `shorten()` until no chain is superfluous. The function terminates, since each
 * removal decreases the total length. If no chain is superfluous after the first call of `shorten()`, the function is
 * equivalent to `shorten()`.
 *
 * \param network a network made by `add_cut_graph()`, or any other network that cuts each component into disks. If
 *        curves are removed, the remaining curves are renumbered
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor as for `shorten()`. If its `go_further()` returns `false`, no further chains are
 *       removed: the network still cuts each component open, but possibly into several disks}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the report of the last run of `shorten()` on the remaining curves, with the numbers of flips and steps of all
 *         runs
 * \throws Degenerate_face_error as `shorten()` does
 * \throws Invalid_coordinate_error as `shorten()` does
 *
 * Complexity: the time of all runs of `shorten()`, plus time linear in the size of the triangulation for each run.
 */
template <class Network, class... NamedParameters>
Shortening_report shorten_cut_graph(Network& network, const NamedParameters&... np)
{
  auto visitor = internal::make_visitor(internal::options_of<internal_np::visitor_t>(np...));
  internal::Stop_remembering_visitor<std::remove_reference_t<decltype(visitor.get())>> remembering(visitor.get());
  std::size_t flips = 0, flip_outs = 0;
  Shortening_report report;
  do {
    report = internal::shorten(network, Never_stop_predicate(), remembering);
    flips += report.flips;
    flip_outs += report.flip_outs;
  } while(!remembering.has_stopped() && internal::Needless_seams<Network>(network).remove());
  report.flips = flips;
  report.flip_outs = flip_outs;
  return report;
}

namespace internal {

/*
 * The shortest edge loop of a certain kind that passes through one of several vertices.
 *
 * Each search excludes the vertices whose loops have been searched before. The class of a path is represented by its
 * word, with all possible cancellations: the loop closed by an edge is contractible if the words of its end points
 * differ by the word of the edge, and only other loops are considered.
 */
template <class Triangulation>
class Shortest_loop_search
{
public:
  Shortest_loop_search(const Triangulation& triangulation, const Generator_words& words, Interruption* interruption)
    : m_words(words)
    , m_search(triangulation, interruption)
    , m_is_left_out(static_cast<std::size_t>(triangulation.input().number_of_vertices()), 0)
  {
  }

  /*
   * Searches for a shorter loop through v, and through no vertex searched before, whose word has a property.
   * \throws Interrupted
   */
  template <class IsWanted>
  void search(Vertex_index v, const IsWanted& is_wanted)
  {
    m_reduced_words.clear();
    Policy<IsWanted> policy(*this, is_wanted);
    m_search.run(v, Reduced_words::empty_word, policy);
    if(policy.closing() != null_index)
      m_loop = m_search.loop(policy.closing()).whole();
    m_is_left_out[v] = 1;
  }

  /* Returns the result: a chain from the vertex back to it, or empty if no loop was found. */
  const std::vector<Halfedge_index>& loop() const { return m_loop; }

private:
  using Search = Loop_search<Triangulation, Reduced_words::Word>;

  // Keeps the edge that closes the best loop if it is shorter than those of other vertices.
  template <class IsWanted>
  class Policy : public Search::template Policy<Policy<IsWanted>>
  {
    using Base = typename Search::template Policy<Policy<IsWanted>>;

  public:
    Policy(Shortest_loop_search& loops, const IsWanted& is_wanted)
      : Base(loops.m_search)
      , m_loops(loops)
      , m_is_wanted(is_wanted)
    {
    }

    Input_halfedge_index closing() const { return m_closing; }

    template <class Queue>
    bool is_finished(Queue& queue) const
    {
      return !(2 * queue.priority() < m_loops.m_length);
    }

    template <class Function>
    void for_each_halfedge(const typename Base::Origin& origin, const Function& function) const
    {
      Base::for_each_halfedge(origin, [&](Input_halfedge_index h) {
        if(m_loops.m_is_left_out[this->head(h)] == 0)
          function(h);
      });
    }

    Reduced_words::Word extended(Reduced_words::Word path, Input_halfedge_index h) const
    {
      m_loops.m_words.for_each_letter(h, [&](Letter letter) { path = m_loops.m_reduced_words.appended(path, letter); });
      return path;
    }

    void meet(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w)
    {
      const double length = this->length_of_loop(origin, h, w);
      if(!(length < m_loops.m_length))
        return;
      const Reduced_words::Word word = this->class_over(origin, h), other = this->class_of_path(w);
      if(word == other || !m_is_wanted(m_loops.m_reduced_words.quotient(word, other)))
        return;
      m_loops.m_length = length;
      m_closing = h;
    }

  private:
    Shortest_loop_search& m_loops;
    const IsWanted& m_is_wanted;
    Input_halfedge_index m_closing = null_index;
  };

  const Generator_words& m_words;
  Search m_search;
  Indexed_by<Vertex_index, std::vector<char>> m_is_left_out;
  Reduced_words m_reduced_words;
  std::vector<Halfedge_index> m_loop;
  double m_length = std::numeric_limits<double>::infinity(); // of the best loop
};

} // namespace internal

/// \ingroup PkgFlipGeodesicsLoops
/// Specifies the loops among which `shortest_loop()` searches.
enum class Loop_kind {
  NOT_CONTRACTIBLE, ///< loops that cannot be contracted to a point
  NOT_BOUNDING      ///< loops whose homology class is not zero; on a closed surface, a simple loop is of this kind if
                    ///< it does not separate the surface
};

namespace internal {

/* Searches among the loops through given vertices. \throws Interrupted */
template <class Triangulation>
std::vector<Halfedge_index> shortest_loop_through(const Triangulation& triangulation,
                                                  const std::vector<Vertex_index>& vertices, Loop_kind kind,
                                                  Interruption* interruption)
{
  const auto& input = triangulation.input();
  const auto weight = [&](Input_halfedge_index h) { return triangulation.metric().weight(input, h); };
  check_surface(input);
  const Edge_forest forest(input, std::vector<Vertex_index>(), weight, interruption);
  const Generator_words words(input, forest, Cotree(input, forest, Borders::CLOSED_BY_ONE_FACE, weight, interruption),
                              interruption);
  std::vector<Surface_group> groups;
  for(std::size_t c = 0; c < forest.roots().size(); ++c)
    groups.emplace_back(words.relation(static_cast<Index>(c)));

  Shortest_loop_search<Triangulation> search(triangulation, words, interruption);
  for(Vertex_index v : vertices) {
    if(forest.component(v) < 0)
      continue;
    const Surface_group& group = groups[static_cast<std::size_t>(forest.component(v))];
    search.search(v, [&](const std::vector<Letter>& word) {
      switch(kind) {
      case Loop_kind::NOT_CONTRACTIBLE:
        return !group.is_neutral(word);
      case Loop_kind::NOT_BOUNDING:
        return !Surface_group::is_balanced(word);
      }
      return false;
    });
  }
  return search.loop();
}

/* Searches among the loops through vertices of a cut graph. \throws Interrupted */
template <class Triangulation>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation, Loop_kind kind,
                                          Interruption* interruption)
{
  const auto& input = triangulation.input();
  const Cut_edges<Triangulation> cut(triangulation, std::vector<Vertex_index>(), interruption);
  Indexed_by<Vertex_index, std::vector<char>> is_on_cut(static_cast<std::size_t>(input.number_of_vertices()), 0);
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges()))
    if(cut.marks()[edge_of(as_intrinsic(h))] != 0)
      is_on_cut[input.tail(h)] = 1;
  std::vector<Vertex_index> vertices;
  for(Vertex_index v : descriptors<Vertex_index>(input.number_of_vertices()))
    if(is_on_cut[v] != 0)
      vertices.push_back(v);
  return shortest_loop_through(triangulation, vertices, kind, interruption);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Computes a shortest edge loop of a given kind through a vertex \cgalCite{EH04}.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`; its input is searched, and lengths are those of its
 *        metric
 * \param v the vertex
 * \param kind the kind of the loop
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is called at regular intervals. If it returns `false`, the
 *       result is empty}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the halfedges of the loop, from the vertex back to the vertex. The loop can begin with a path that it
 *         traverses in the opposite direction at its end. The result is empty if no loop of the given kind passes
 *         through the vertex, as on a sphere
 * \throws Vertex_out_of_range_error if `v` is not a vertex of the input
 * \throws Invalid_mesh_error as `Loop_basis` does
 * \throws Invalid_coordinate_error as `Loop_basis` does
 *
 * Complexity: \cgalBigO{n \log n} for a fixed genus and number of borders.
 */
template <class Triangulation, class... NamedParameters>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation, Vertex_index v,
                                          Loop_kind kind = Loop_kind::NOT_CONTRACTIBLE, const NamedParameters&... np)
{
  internal::check_vertex(v, triangulation.input().number_of_vertices());
  return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...), [&](auto* interruption) {
    return internal::shortest_loop_through(triangulation, {v}, kind, interruption);
  });
}

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Computes a shortest edge loop of a given kind on a surface.
 *
 * The parameters and exceptions are those of `shortest_loop()` through a given vertex.
 *
 * \return the halfedges of the loop; empty if no such loop exists
 *
 * Complexity: \cgalBigO{n \log n + c m \log m} for a fixed genus and number of borders. Here, \f$c\f$ is the number of
 * vertices of a cut graph, from each of which one search starts, and \f$m\f$ is the largest number of vertices that a
 * search visits. Once a loop has been found, each search is confined to a radius of half the length of the shortest
 * loop found so far.
 */
template <class Triangulation, class... NamedParameters>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation,
                                          Loop_kind kind = Loop_kind::NOT_CONTRACTIBLE, const NamedParameters&... np)
{
  return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...), [&](auto* interruption) {
    return internal::shortest_loop(triangulation, kind, interruption);
  });
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_GEODESIC_LOOPS_H
