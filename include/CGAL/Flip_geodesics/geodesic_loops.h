// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_LOOPS_H
#define CGAL_FLIP_GEODESICS_GEODESIC_LOOPS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_types.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Cut_edges.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>
#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>
#include <CGAL/Flip_geodesics/internal/topology/Needless_seams.h>
#include <CGAL/Flip_geodesics/internal/topology/Reduced_words.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* Adds what shortening one curve of a network did to the report of many. */
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
 * Computes closed geodesics around the handles and holes of a surface: pulls each loop of a `Loop_basis` tight, by
 * itself. Two of them may cross. There are none on a sphere and on a disk.
 *
 * \param mesh a triangle mesh
 * \param out receives one `std::vector` per loop, in the order of the basis, of what `geodesic_path()` writes
 * \param np as for `geodesic_path()`; the stop predicate is asked about each loop by itself. If a visitor's
 *        `go_further()` returns `false`, then the remaining loops are not shortened. If that happens before the basis
 *        is known, then nothing is written, and the report has one entry with `Shortening_status::STOPPED_BY_VISITOR`
 * \return the end of the output, and the report, with one entry per loop
 * \throws Invalid_mesh_error, Degenerate_face_error, Invalid_coordinate_error
 *
 * Complexity: \f$O(n \log n)\f$ and that of `shorten()` for each loop.
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
    const Loop_basis<typename Types::Triangulation> basis(triangulation, std::vector<Vertex_index>(), remembering);
    internal::Computed_output<std::vector<Form>> result;
    if(!basis.is_complete())
      result.report = internal::report_of_stopped_search();
    for(Index i = 0; i < basis.number_of_loops(); ++i) {
      {
        typename Types::Network network(triangulation);
        const Curve_index curve = network.add_curve(basis.cycle(i), true);
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
 * Pulls a network tight along which each component of a surface is cut open to a disk, so that this remains: each
 * component is one disk afterwards, and all curves are locally shortest between their ends.
 *
 * Curves that were apart can come to run along the same edges, or to touch in a vertex. Cut along all of them, the
 * component falls into several disks then, and some of the curves are needless: two disks with a chain in common are one
 * disk without it. So chains between different disks are dropped, the longest first, and what leads to nowhere without
 * them. A vertex where only two curves are left is no fixed end any more. The network gets shorter each time, and is
 * pulled tight again until no chain is needless. If all curves are needed from the start, this is `shorten()`.
 *
 * \param network a network made by `add_cut_graph()`, or any other one that cuts each component into disks; where curves
 *        are dropped, its curves are numbered anew
 * \param np named parameters: `visitor`, as for `shorten()`. If its `go_further()` returns `false`, then this ends
 *        without looking for needless chains once more: the network still cuts each component open, but into several
 *        disks perhaps
 * \return the report of the last run of `shorten()`, for the curves that are left, with flips and steps of all runs
 * \throws as `shorten()`
 *
 * Complexity: that of `shorten()`, and linear in the triangulation for each run.
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
 * The shortest loop along edges that passes one of some vertices and is of a certain kind.
 *
 * Each search leaves out the vertices whose loops were searched before. The class of a path is its word, reduced as far
 * as it cancels: the loop of an edge between two ends whose words differ by that of the edge contracts, and only others
 * are looked at.
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

  /* Looks for a shorter loop through v, and through no vertex asked about before, whose word has a property.
   * \throws Interrupted */
  template <class IsWanted>
  void search(Vertex_index v, const IsWanted& is_wanted)
  {
    m_reduced_words.clear();
    Policy<IsWanted> policy(*this, is_wanted);
    m_search.run(v, Reduced_words::empty_word, policy);
    if(policy.closing() != null_index) {
      const auto [out, back] = m_search.legs(policy.closing());
      m_loop = closed_chain(out, back, 0);
    }
    m_is_left_out[v] = 1;
  }

  /* What was found: a chain from the vertex back to it; empty if there is none. */
  const std::vector<Halfedge_index>& loop() const { return m_loop; }

private:
  using Search = Loop_search<Triangulation, Reduced_words::Word>;

  // Keeps the edge that closes the best loop, if it is shorter than those of other vertices.
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
/// Which loops `shortest_loop()` looks for.
enum class Loop_kind {
  NOT_CONTRACTIBLE, ///< those that cannot be contracted to a point
  NOT_BOUNDING      ///< those whose homology class is not zero: on a closed surface, those that do not divide it
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
 * Computes the shortest loop of edges through a vertex that is of a kind, by [EH04]: its halfedges from the vertex back
 * to it; none if there is no such loop, as on a sphere. A part at the vertex may be passed out and back.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`; its input is searched, and lengths are the metric's
 * \param v, kind the vertex, and which loops are searched
 * \param np named parameters: `visitor`, a model of `FlipOutVisitor`, of which only `go_further()` is called, at
 *        regular intervals. If it returns `false`, then the result is empty
 * \throws Vertex_out_of_range_error
 * \throws Invalid_mesh_error, Invalid_coordinate_error as `Loop_basis`
 *
 * Complexity: \f$O(n \log n)\f$ for a fixed genus and number of borders.
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
 * Computes the shortest of all loops of edges that are of a kind; none if there is no such loop. The loop passes a
 * vertex of each network that cuts the surface into disks. So only loops through vertices of a cut graph are searched,
 * each to half of the length of the best one so far.
 *
 * Parameters and errors as above.
 *
 * Complexity: \f$O(n \log n + c\,m \log m)\f$ for a fixed genus and number of borders, with c vertices of the cut graph,
 * and at most m vertices nearer to one of them than half of the length of the loops found on the way.
 */
template <class Triangulation, class... NamedParameters>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation,
                                          Loop_kind kind = Loop_kind::NOT_CONTRACTIBLE, const NamedParameters&... np)
{
  return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...), [&](auto* interruption) {
    return internal::shortest_loop(triangulation, kind, interruption);
  });
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_LOOPS_H
