// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEST_PATH_H
#define CGAL_FLIP_GEODESICS_SHORTEST_PATH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Cone_sweep.h>
#include <CGAL/Flip_geodesics/internal/distances/Landmark_rows.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_search.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Segment_insertion.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#include <CGAL/Flip_geodesics/internal/flip_out/located_points.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/shortest/Shortest_tree_repair.h>
#include <CGAL/Flip_geodesics/internal/shortest/Split_surface.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/for_each_index.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsFunctions
/// Reports on the search for a shortest path.
struct Shortest_path_report
{
  Shortening_report shortening; ///< the report on the shortening of the path

  double first_length = 0; ///< the length of the geodesic obtained from the initial edge path
  double length = 0;       ///< the length of the result
  /// A lower bound on the lengths of all paths between the ends, with allowance for rounding errors.
  double lower_bound = 0;
  std::size_t windows = 0;              ///< the number of windows of the search
  Verdict verdict = Verdict::UNDECIDED; ///< the verdict on the claim that no path is shorter
  /// Whether another path is equally short, up to a relative difference of 2^-42, which is about 2e-13. If the path is
  /// confirmed, no such path has been missed.
  bool has_tie = false;

  /// Returns how the shortening of the path ended.
  Shortening_status status() const { return shortening.status(); }

  /// Returns whether the path is confirmed to be shortest; an unconfirmed path can nevertheless be shortest.
  bool is_confirmed() const { return Flip_geodesics::is_confirmed(verdict); }

  /// Returns an upper bound on the difference between the length of the path and that of a shortest path.
  double gap() const { return (std::max)(length - lower_bound, 0.0); }

  /// Returns 1e-10. A path with the verdict `WITHIN_TOLERANCE` is longer than a shortest path by at most this fraction
  /// of its length.
  static constexpr double tolerance() { return internal::confirmed_gap; }

  /// Returns 1e-12. A path with the verdict `WITHIN_ROUNDING` is longer than a shortest path by at most this fraction
  /// of its length.
  static constexpr double rounding_tolerance() { return internal::proven_gap; }
};

/// \ingroup PkgFlipGeodesicsFunctions
/// Contains the result of `shortest_path()`: the end of the output, and a report on the path.
template <class OutputIterator>
struct Shortest_path_result
{
  OutputIterator out;          ///< the past-the-end iterator of the output
  Shortest_path_report report; ///< the report on the path

  double length() const { return report.length; }              ///< returns the length of the path
  Shortening_status status() const { return report.status(); } ///< returns how the shortening ended
  Verdict verdict() const { return report.verdict; } ///< returns the verdict on the claim that no path is shorter
};

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Computes lower bounds on the geodesic distance between any two vertices of a component. The bounds are derived from
 * landmarks: vertices that are far from one another, or that the caller has chosen.
 *
 * A lower-bound propagation from each landmark assigns to each vertex a value close to its distance from the landmark.
 * The difference of the values of two vertices is a lower bound on the distance between them \cgalCite{GH05}. Landmarks
 * are computed once for many shortest paths on one mesh, and confine the searches to the regions that shortest paths
 * can enter. The class `Landmark_distances` serves the same purpose for paths along edges.
 *
 * Like `Shortest_path_report::lower_bound`, the bounds hold for the mesh with its coordinates taken as given, and take
 * rounding errors into account. Each component has its own landmarks, at most `number_of_landmarks()`. The data take
 * `2 * number_of_landmarks()` bytes per vertex, and can be read by several threads concurrently. A propagation takes
 * about 400 bytes per triangle while it runs.
 */
class Geodesic_landmarks
{
public:
  /// The default number of landmarks in each component.
  static constexpr std::size_t default_number = 8;

  /*!
   * Chooses the landmarks and computes the bounds. Each landmark after the first is the vertex of its component that is
   * farthest, along edges, from the previous landmarks.
   *
   * \tparam ConcurrencyTag `CGAL::Sequential_tag`, or `CGAL::Parallel_tag` if TBB is linked. With `Parallel_tag`,
   *         several propagations run concurrently; the results are the same
   *
   * \param triangulation a triangulation of the mesh; it is not stored, and flips made in it do not affect the result
   * \param number the number of landmarks in each component. A component with fewer vertices has fewer landmarks
   * \param tag an object whose type selects sequential or parallel execution
   * \param np an optional sequence of named parameters among those listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{visitor}
   *     \cgalParamDescription{a visitor whose `go_further()` is called at regular intervals, from the calling thread.
   *       If it returns `false`, `is_complete()` returns `false`, the object has no landmarks, and all bounds are zero}
   *     \cgalParamType{a model of `FlipOutVisitor`, of which only `go_further()` is called}
   *     \cgalParamDefault{no visitor}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws Degenerate_face_error if a face has a degenerate edge or violates the triangle inequality
   * \throws Invalid_coordinate_error if a coordinate or an edge length is not finite or out of range
   * \throws Invalid_mesh_error if a face is not a triangle
   *
   * Complexity: \cgalBigO{n \log n} time for each landmark on a mesh with \f$n\f$ vertices, and more on meshes of
   * needles.
   */
  template <class Triangulation, class ConcurrencyTag = Sequential_tag, class... NamedParameters>
  explicit Geodesic_landmarks(const Triangulation& triangulation, std::size_t number = default_number,
                              ConcurrencyTag tag = ConcurrencyTag(), const NamedParameters&... np)
  {
    make(triangulation, tag, internal::options_of<internal_np::visitor_t>(np...),
         [&](const Choice& choice, auto& search) { return choice.far_vertices(search, number); });
  }

  /*!
   * Computes the bounds with given landmarks. These can lie, for instance, around the part of the mesh that contains
   * all required paths.
   *
   * \tparam ConcurrencyTag `CGAL::Sequential_tag`, or `CGAL::Parallel_tag` if TBB is linked. With `Parallel_tag`,
   *         several propagations run concurrently; the results are the same
   *
   * \param triangulation a triangulation of the mesh; it is not stored, and flips made in it do not affect the result
   * \param landmarks a range of `Vertex_index`es in any order; repeated vertices count once. In components without
   *        landmarks, all bounds are zero
   * \param tag an object whose type selects sequential or parallel execution
   * \param np the named parameter `visitor`, as for the constructor with a number of landmarks
   * \throws Vertex_out_of_range_error if a landmark is not a vertex of the mesh
   * \throws Degenerate_face_error if a face has a degenerate edge or violates the triangle inequality
   * \throws Invalid_coordinate_error if a coordinate or an edge length is not finite or out of range
   * \throws Invalid_mesh_error if a face is not a triangle
   *
   * Complexity: \cgalBigO{n \log n} time for each landmark on a mesh with \f$n\f$ vertices, and more on meshes of
   * needles.
   */
  template <class Triangulation, class VertexRange = std::vector<Vertex_index>, class ConcurrencyTag = Sequential_tag,
            class... NamedParameters, std::enable_if_t<!std::is_convertible<VertexRange, std::size_t>::value, int> = 0>
  Geodesic_landmarks(const Triangulation& triangulation, const VertexRange& landmarks,
                     ConcurrencyTag tag = ConcurrencyTag(), const NamedParameters&... np)
  {
    static_assert(
        internal::is_range_of<VertexRange, Vertex_index>,
        "a number of landmarks or a range of vertices is expected here; the order of the arguments is triangulation, "
        "landmarks, concurrency tag");
    const std::vector<Vertex_index> given(std::begin(landmarks), std::end(landmarks));
    make(triangulation, tag, internal::options_of<internal_np::visitor_t>(np...),
         [&](const Choice& choice, const auto&) { return choice.given_vertices(given); });
  }

  /// Returns whether the construction was completed; a visitor can stop it.
  bool is_complete() const { return m_is_complete; }

  /// Returns the largest number of landmarks in a component.
  std::size_t number_of_landmarks() const { return m_rows.number_of_functions(); }

  /// Returns a lower bound on the lengths of all paths between two vertices. The result is meaningless for vertices of
  /// different components. \pre `v` and `w` are vertices of the mesh
  ///
  /// Complexity: linear in the number of landmarks in a component.
  double distance_lower_bound(Vertex_index v, Vertex_index w) const { return m_rows.distance_lower_bound(v, w); }

  /*!
   * Checks whether the landmarks could have been computed for the input of a triangulation.
   *
   * The function compares the numbers of vertices, edges and faces. It also compares one edge of each border and at
   * most `number_of_landmarks()` edges at landmarks: their lengths, and whether they lie on the border. It thus detects
   * additional and missing faces and, in most cases, a different mesh or metric, but it does not detect every vertex
   * that has moved. The bounds hold only for the mesh and the metric for which they were computed.
   *
   * \throws Input_mismatch_error if the input differs
   *
   * Complexity: linear in the numbers of landmarks and of borders.
   */
  template <class Triangulation>
  void check_input(const Triangulation& triangulation) const
  {
    const auto& input = triangulation.input();
    bool is_same = input.number_of_vertices() == m_number_of_vertices &&
                   input.number_of_halfedges() == m_number_of_halfedges && input.number_of_faces() == m_number_of_faces;
    for(std::size_t i = 0; is_same && i < m_edges.size(); ++i)
      is_same = input.is_border(m_edges[i].halfedge) == m_edges[i].is_border &&
                triangulation.metric().length(input, m_edges[i].halfedge) == m_edges[i].length;
    if(!is_same)
      throw Input_mismatch_error("the landmarks were computed for another mesh or another metric");
  }

private:
  friend struct internal::Internals<Geodesic_landmarks>;
  using Choice = internal::Landmark_choice;

  // At a landmark, or on a border.
  struct Edge
  {
    Input_halfedge_index halfedge;
    bool is_border;
    double length;
  };

  static constexpr int free_updates = 400; // many, because needles require them and the propagations run only once
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // `choose(choice, search)` returns sets of landmarks.
  template <class Triangulation, class ConcurrencyTag, class NamedParameters, class Choose>
  void make(const Triangulation& triangulation, ConcurrencyTag, const NamedParameters& np, const Choose& choose)
  {
    auto visitor = internal::make_visitor(np);
    internal::Interruption interruption(visitor.get());
    m_is_complete = internal::result_unless_interrupted(
        [&] { return make<ConcurrencyTag>(triangulation, choose, interruption), true; });
    if(!m_is_complete) {
      m_rows = internal::Landmark_rows();
      m_edges.clear();
    }
  }

  template <class ConcurrencyTag, class Triangulation, class Choose>
  void make(const Triangulation& triangulation, const Choose& choose, internal::Interruption& interruption)
  {
    m_number_of_vertices = triangulation.input().number_of_vertices();
    m_number_of_halfedges = triangulation.input().number_of_halfedges();
    m_number_of_faces = triangulation.input().number_of_faces();
    note_borders(triangulation);
    Shortest_edge_path<Triangulation> search(triangulation, parameters::search_method(Search_method::DIJKSTRA));
    const Choice choice(search, &interruption);
    const std::vector<Choice::Set> sets = choose(choice, search);
    for(std::size_t i = 0; i < sets.size(); ++i)
      note_edge(triangulation, sets[i][i % sets[i].size()]);
    sweep<ConcurrencyTag>(triangulation, choice, sets, interruption);
  }

  // Propagates from each set separately. Since all faces are laid out before, propagations only read them, and their
  // order does not matter.
  template <class ConcurrencyTag, class Triangulation>
  void sweep(const Triangulation& triangulation, const Choice& choice, const std::vector<Choice::Set>& sets,
             internal::Interruption& interruption)
  {
    internal::throw_if_interrupted_before_part(&interruption);
    const double largest = choice.largest_distance();
    m_rows = internal::Landmark_rows(static_cast<std::size_t>(m_number_of_vertices), sets.size(), largest);
    internal::Unfolded_faces<Triangulation> faces(triangulation);
    lay_out(triangulation, choice.order(), faces);
    internal::Shared_interruption shared(interruption);
    internal::for_each_index<ConcurrencyTag>(sets.size(), [&](std::size_t i) {
      internal::Cone_sweep<Triangulation> sweep(triangulation, faces, null_index,
                                                internal::Goal_bound<Triangulation>(triangulation), free_updates);
      internal::Interruption own(shared);
      sweep.run_from(sets[i], largest, &own);
      if(sweep.is_useful())
        keep(i, sweep);
    });
    if(interruption.has_occurred())
      throw internal::Interrupted();
  }

  // Lays out the faces around each vertex in turn, so that faces that are close on the mesh are close in memory, and
  // then any faces that this has missed.
  template <class Triangulation, class Faces>
  void lay_out(const Triangulation& triangulation, const std::vector<Vertex_index>& order, Faces& faces) const
  {
    const auto& input = triangulation.input();
    const auto add = [&](Input_halfedge_index h) {
      if(!input.is_border(h))
        faces.number(h);
    };
    for(Vertex_index v : order) {
      const Input_halfedge_index first = input.outgoing(v);
      Input_halfedge_index h = first;
      if(first != null_index)
        do {
          add(h);
          h = input.next(internal::twin_index(h));
        } while(h != first);
    }
    for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(m_number_of_halfedges))
      add(h);
  }

  // All values of a propagation are too small by its error, which does not affect differences.
  template <class Sweep>
  void keep(std::size_t i, const Sweep& sweep)
  {
    m_rows.set_error(i, sweep.total_error());
    for(Vertex_index v : internal::descriptors<Vertex_index>(m_number_of_vertices))
      if(const double value = sweep.distance_lower_bound(v); value < infinity)
        m_rows.set(v, i, value);
  }

  // Records an edge at a landmark, unless it is an isolated vertex.
  template <class Triangulation>
  void note_edge(const Triangulation& triangulation, Vertex_index landmark)
  {
    if(const Input_halfedge_index h = triangulation.input().outgoing(landmark); h != null_index)
      note(triangulation, h);
  }

  // Records an edge of each border. If the total number of faces is equal and each of these edges is on a border, the
  // borders are the same unless one is in another position that also contains this edge.
  template <class Triangulation>
  void note_borders(const Triangulation& triangulation)
  {
    const auto& input = triangulation.input();
    internal::Indexed_by<Input_halfedge_index, std::vector<char>> is_seen(
        static_cast<std::size_t>(m_number_of_halfedges), 0);
    for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(m_number_of_halfedges)) {
      if(!input.is_border(h) || is_seen[h] != 0)
        continue;
      internal::check_has_face(input, h); // the halfedge after an edge without a face may not exist
      note(triangulation, h);
      for(Input_halfedge_index side = h; is_seen[side] == 0; side = input.next(side))
        is_seen[side] = 1;
    }
  }

  template <class Triangulation>
  void note(const Triangulation& triangulation, Input_halfedge_index h)
  {
    m_edges.push_back({h, triangulation.input().is_border(h), triangulation.metric().length(triangulation.input(), h)});
  }

  Index m_number_of_vertices = 0, m_number_of_halfedges = 0, m_number_of_faces = 0;
  std::vector<Edge> m_edges;
  internal::Landmark_rows m_rows;
  bool m_is_complete = true;
};

namespace internal {

template <>
struct Internals<Geodesic_landmarks>
{
  static const Landmark_rows& rows(const Geodesic_landmarks& landmarks) { return landmarks.m_rows; }
};

/*
 * Calls `run()`, a search over faces. Returns false if it has encountered a degenerate one, so shorter paths than those
 * found may exist. The search lays out faces when they are first needed, from many places in its innermost loops, and
 * its previous results remain valid; an exception ends it there without a test after each face.
 */
template <class Run>
bool meets_no_degenerate_face(const Run& run)
{
  try {
    run();
  } catch(const Degenerate_face_error&) {
    return false;
  }
  return true;
}

template <class Search, class... Interruptions>
bool run_to_the_end(Search& search, double bound, std::size_t most_windows, Interruptions*... interruption)
{
  return meets_no_degenerate_face([&] { search.run(bound, most_windows, interruption...); });
}

/* Runs a search between two vertices, given a bound that is the length of a known path. */
template <class Sweep, class Search>
bool run_between(Sweep& sweep, Search& search, double bound, std::size_t most_windows, Interruption* interruption)
{
  constexpr double tolerance = Shortest_path_report::rounding_tolerance();
  return meets_no_degenerate_face([&] {
    sweep.run(bound * (1 + 2 * tolerance), interruption);
    search.run(bound * (1 + tolerance), most_windows, interruption);
  });
}

/*
 * Returns the path that a search has found as edges, for which the edges that it crosses are flipped; empty if this is
 * impossible.
 */
template <class Triangulation>
std::vector<Halfedge_index> insert_path(Triangulation& triangulation, const Window_search<Triangulation>& search,
                                        Vertex_index source, Vertex_index target, std::size_t& flips)
{
  std::vector<std::vector<Halfedge_index>> legs;
  for(Vertex_index v = target; v != source;) {
    const auto leg = search.leg(v);
    legs.emplace_back();
    const std::vector<Crossed_edge> crossed =
        leg.sequence.along == null_index ? crossed_edges(triangulation, leg.sequence) : std::vector<Crossed_edge>();
    if(!insert_leg(triangulation, leg.sequence.along, crossed, legs.back(), flips))
      return {};
    v = leg.from;
  }
  std::vector<Halfedge_index> path;
  for(std::size_t i = legs.size(); i-- > 0;)
    path.insert(path.end(), legs[i].begin(), legs[i].end());
  return path;
}

/*
 * Inserts the path if its geodesic segments block each other, as on rough terrain: over a tree of geodesics, of which
 * the paths to the vertices that the shortest path passes are replaced.
 */
template <class Triangulation>
std::vector<Halfedge_index> insert_path_in_tree(Triangulation& triangulation,
                                                const Window_search<Triangulation>& search, Vertex_index source,
                                                Vertex_index target, std::size_t& flips)
{
  constexpr double tolerance = Shortest_path_report::tolerance();
  Geodesic_tree<Triangulation> tree(triangulation);
  flips += tree.grow(source, parameters::max_distance(search.distance(target))).flips;
  std::vector<Vertex_index> longer;
  for(Vertex_index v = target; v != source; v = search.leg(v).from)
    if(!tree.is_reached(v) || tree.distance(v) > search.distance(v) * (1 + tolerance))
      longer.push_back(v);
  Shortest_tree_repair<Geodesic_tree<Triangulation>> repair(tree, search, tolerance);
  repair.run(longer);
  flips += repair.flips();
  std::vector<Halfedge_index> path;
  for(Vertex_index v = target; v != source && tree.incoming(v) != null_index; v = triangulation.tail(path.back()))
    path.push_back(tree.incoming(v));
  std::reverse(path.begin(), path.end());
  return !path.empty() && triangulation.tail(path.front()) == source ? path : std::vector<Halfedge_index>();
}

/*
 * Returns the verdict that follows from the gap and the certificate of a path, on a surface that is the unrounded mesh.
 */
inline Verdict verdict_of(const Shortest_path_report& report)
{
  if(!report.shortening.is_complete() || report.gap() > Shortest_path_report::tolerance() * report.length)
    return Verdict::UNDECIDED;
  const bool is_proven = report.shortening.curves.front().verdict == Verdict::PROVEN &&
                         report.gap() <= Shortest_path_report::rounding_tolerance() * report.length;
  return is_proven ? Verdict::WITHIN_ROUNDING : Verdict::WITHIN_TOLERANCE;
}

/* Returns whether a confirmed path is not proven to be shortest only because of its lower bound. */
inline bool lacks_rounding_tolerance(const Shortest_path_report& report)
{
  return verdict_of(report) == Verdict::WITHIN_TOLERANCE && report.shortening.curves.front().verdict == Verdict::PROVEN;
}

/*
 * Raises the lower bound for a path by a second search in double-double arithmetic, if possible. The bound of the first
 * search falls below the length by 16 units of roundoff of the lengths in each face, and by 32 times that error at each
 * flat vertex, so that rays which start there can replace the windows beside it. These allowances keep the number of
 * windows small and cannot be reduced in doubles; with units of 2^-97 they are negligible.
 *
 * The second search is sound by itself, by the argument of `Window_search`, which holds for either kind of numbers: it
 * covers all paths again and takes only the length of the known path from the first search. It ends once no path can be
 * shorter than that by half the tolerance, or when it has taken `most_windows`, and its bound holds in either case.
 */
template <class Triangulation>
void raise_lower_bound(const Triangulation& triangulation, Unfolded_faces<Triangulation>& faces,
                       const Cone_sweep<Triangulation>& sweep, Vertex_index source, std::size_t most_windows,
                       Interruption& interruption, Shortest_path_report& report)
{
  using Precise_faces = Precise_unfolded_faces<Triangulation>;
  Precise_faces precise_faces(triangulation, faces);
  Window_search<Triangulation, Precise_faces> windows(triangulation, precise_faces, source, &sweep);
  const double enough = report.length * (1 - Shortest_path_report::rounding_tolerance() / 2);
  const bool is_sound = run_to_the_end(windows, enough, most_windows, &interruption);
  report.windows += windows.number_of_windows();
  if(is_sound)
    report.lower_bound = (std::max)(
        report.lower_bound, (std::min)({windows.lower_bound(), windows.least_distance(sweep.source()), sweep.bound()}));
}

/* A zero-length path is shortest if its ends are proven to coincide. */
inline Shortest_path_report report_of_no_length(const Shortening_report& shortening)
{
  Shortest_path_report report;
  report.shortening = shortening;
  if(shortening.curves.front().verdict == Verdict::PROVEN)
    report.verdict = Verdict::WITHIN_ROUNDING;
  return report;
}

/* Returns a lower bound on the length of all paths, from the positions of the ends alone. */
template <class Triangulation>
double lower_bound_in_space(const Triangulation& triangulation, Vertex_index source, Vertex_index target)
{
  const auto& metric = triangulation.metric();
  return (1 - internal::space_bound_rounding) *
         metric.distance_lower_bound(metric.place(triangulation.input(), source),
                                     metric.place(triangulation.input(), target));
}

inline bool is_stopped_by_visitor(const Shortest_path_report& report)
{
  return report.status() == Shortening_status::STOPPED_BY_VISITOR;
}

/* Searches for a shorter path than the only one of a network, if degenerate faces obstruct windows. */
template <class Network, class Visitor>
void take_shorter_path(Network& network, Vertex_index source, Vertex_index target, Shortest_path_report& report,
                       Visitor& visitor)
{
  const Flipped_start first = flipped_start_of(network);
  const Flipped_start* best = &first;
  const std::vector<Flipped_start> starts = starts_in_trees(network, source, target);
  for(const Flipped_start& start : starts) {
    const Shortening_report shortening = pull_tight(network, start, visitor);
    const double length = network.length(Curve_index(0));
    if(!shortening.is_complete() || !(length < report.length * (1 - Shortest_path_report::rounding_tolerance())))
      continue;
    best = &start;
    report.length = length;
  }
  const Shortening_report before = report.shortening;
  report.shortening = pull_tight(network, *best, visitor);
  if(best == &first)
    report.shortening = before; // unchanged
  else
    count_before(report.shortening, before, best->flips.size());
}

/*
 * Shortens a path of which only the ends are given, in an empty network, after initial straightening unless the visitor
 * must observe the whole process.
 */
template <class Network, class Visitor>
Shortening_report shorten_from_start(Network& network, const std::vector<Halfedge_index>& path, Visitor& visitor)
{
  const std::size_t flips = add_start<observes_steps<Visitor>>(network, path);
  Shortening_report report = shorten(network, Never_stop_predicate(), visitor);
  count_start(report, flips);
  return report;
}

/* Returns the given landmarks, or null. \throws Input_mismatch_error */
template <class Triangulation, class NamedParameters>
const Geodesic_landmarks* checked_landmarks(const Triangulation& triangulation, const NamedParameters& np)
{
  const auto* const landmarks = landmarks_of<Geodesic_landmarks>(np);
  if(landmarks != nullptr)
    landmarks->check_input(triangulation);
  return landmarks;
}

/*
 * Replaces the path of a network by the shortest one that windows have found, or restores it if that cannot be
 * inserted.
 * \param edge_path from which the path of the network was shortened
 */
template <class Network, class Windows, class Visitor>
void replace_path(Network& network, Windows& windows, Vertex_index source, Vertex_index target,
                  const std::vector<Halfedge_index>& edge_path, Visitor& visitor, Shortest_path_report& report)
{
  auto& triangulation = network.triangulation();
  const Shortening_report before = report.shortening;
  network.clear();
  triangulation.rollback(0);
  std::size_t flips = 0;
  std::vector<Halfedge_index> path = insert_path(triangulation, windows, source, target, flips);
  const auto is_found = [&] {
    double length = 0;
    for(Halfedge_index h : path)
      length += triangulation.length(h);
    return !path.empty() && length <= windows.distance(target) * (1 + Shortest_path_report::tolerance());
  };
  if(!is_found()) {
    triangulation.rollback(0);
    path = insert_path_in_tree(triangulation, windows, source, target, flips);
  }
  if(is_found()) {
    network.add_curve(path);
    report.shortening = internal::shorten(network, Never_stop_predicate(), visitor);
  } else {
    triangulation.rollback(0);
    report.shortening = shorten_from_start(network, edge_path, visitor);
  }
  count_before(report.shortening, before, flips);
  report.length = network.length(Curve_index(0));
}

/* Sets the lower bound to that of the windows and cones, or of a more precise search if that is not within rounding. */
template <class Triangulation>
void set_lower_bound(Triangulation& triangulation, Unfolded_faces<Triangulation>& faces,
                     Cone_sweep<Triangulation>& sweep, Window_search<Triangulation>& windows, Vertex_index source,
                     Vertex_index target, Interruption& interruption, Shortest_path_report& report)
{
  report.lower_bound = (std::max)(report.lower_bound,
                                  (std::min)({windows.lower_bound(), windows.least_distance(target), sweep.bound()}));
  if(lacks_rounding_tolerance(report) && !is_input_rounded(triangulation))
    raise_lower_bound(triangulation, faces, sweep, source, 2 * windows.effort(), interruption, report);
}

/* Sets the verdict; a path that is not confirmed is replaced by a shorter one on meshes with degenerate faces. */
template <class Network, class Visitor>
void set_verdict(Network& network, Vertex_index source, Vertex_index target, Visitor& visitor,
                 Shortest_path_report& report)
{
  auto& triangulation = network.triangulation();
  report.verdict = verdict_of(report);
  if(!report.is_confirmed() && !is_stopped_by_visitor(report) && has_flat_face(triangulation)) {
    take_shorter_path(network, source, target, report, visitor);
    report.verdict = verdict_of(report);
  }
  if(is_input_rounded(triangulation))
    report.verdict = Verdict::UNDECIDED;
}

/*
 * Adds a shortest path to a network, or any path if no path up to a length of `longest` exists. Landmarks, if given,
 * narrow the search; they have been checked, and may lack vertices that points of the surface have become.
 */
template <class Network, class Search, class Visitor>
Shortest_path_report add_shortest_path(Network& network, Search& search, const Geodesic_landmarks* landmarks,
                                       Vertex_index source, Vertex_index target, const Window_limit& limit,
                                       Visitor&& visitor, double longest = std::numeric_limits<double>::infinity())
{
  using Triangulation = typename Network::Triangulation;
  Triangulation& triangulation = network.triangulation();
  CGAL_precondition(network.number_of_curves() == 0 && triangulation.log_position() == 0);
  check_has_no_curves(triangulation, "a shortest path cannot be inserted");
  Taken_back_on_failure<Network> guard(network);
  const std::vector<Vertex_index> ends = {source, target};
  const std::vector<Halfedge_index> edge_path = edge_path_between(search, ends, visitor);
  Shortest_path_report report;
  if(edge_path.empty()) {
    report.shortening = report_of_stopped_search();
    return report;
  }
  report.shortening = shorten_from_start(network, edge_path, visitor);
  report.length = report.first_length = network.length(Curve_index(0));
  report.lower_bound = lower_bound_in_space(triangulation, source, target);
  Interruption interruption(visitor);
  if(is_stopped_by_visitor(report)) {
    guard.dismiss();
    return report;
  }

  Unfolded_faces<Triangulation> faces(triangulation);
  const Landmark_rows* const rows = landmarks == nullptr ? nullptr : &Internals<Geodesic_landmarks>::rows(*landmarks);
  Cone_sweep<Triangulation> sweep(triangulation, faces, target, {triangulation, source, rows});
  Window_search<Triangulation> windows(triangulation, faces, source, &sweep);
  const bool is_sound = run_between(sweep, windows, (std::min)(report.length, longest),
                                    limit(static_cast<std::size_t>(triangulation.number_of_vertices())), &interruption);
  report.windows = windows.number_of_windows();
  if(interruption.has_occurred()) {
    report.shortening.curves.front().status = Shortening_status::STOPPED_BY_VISITOR;
    guard.dismiss();
    return report;
  }
  if(windows.distance(target) < report.length * (1 - Shortest_path_report::rounding_tolerance()))
    replace_path(network, windows, source, target, edge_path, visitor, report);
  if(is_sound && !triangulation.input().has_split_point()) {
    set_lower_bound(triangulation, faces, sweep, windows, source, target, interruption, report);
    if(interruption.has_occurred())
      report.shortening.curves.front().status = Shortening_status::STOPPED_BY_VISITOR;
  }
  set_verdict(network, source, target, visitor, report);
  report.has_tie = is_sound && windows.is_reached(target) && windows.has_tie(target);
  guard.dismiss();
  return report;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds a shortest path between two vertices to an empty network, and computes a lower bound on the lengths of all paths
 * between them.
 *
 * The bound `Shortest_path_report::lower_bound` is computed with outward rounding. Its difference from the length of
 * the path is usually at most 1e-12 of this length. The path is reported as `Verdict::WITHIN_ROUNDING` if it is a
 * `Verdict::PROVEN` geodesic and its length exceeds the bound by at most the fraction
 * `Shortest_path_report::rounding_tolerance()` of the length.
 *
 * If the search encounters a degenerate edge or is aborted, the bound is often too small to confirm the path. If
 * coordinates or lengths of the mesh had to be rounded, the path is never confirmed, since the bound then holds for the
 * rounded mesh.
 *
 * \param network an empty network in a triangulation without flipped edges
 * \param search a `Shortest_edge_path` over the same triangulation; `Search_method::LOOK_BACK` is fastest
 * \param source, target different vertices of the mesh in the same connected component. Inserted vertices are not
 *        accepted, since windows are propagated over the faces of the mesh; `shortest_path()` accepts any points of the
 *        surface
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{search_limit}
 *     \cgalParamDescription{the number of windows after which the search is aborted; `Shortest_path_report::gap()`
 *       returns the gap that remains}
 *     \cgalParamType{`Window_limit`}
 *     \cgalParamDefault{`Window_limit()`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{landmarks}
 *     \cgalParamDescription{landmarks that were computed for the mesh and its metric. They narrow the search, and are
 *       worthwhile if many paths are computed on one mesh}
 *     \cgalParamType{`Geodesic_landmarks`}
 *     \cgalParamDefault{no landmarks}
 *     \cgalParamExtra{The bound remains valid but can differ, in its last digits, from the bound without landmarks. If
 *       several paths are shortest, a different one can be added.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is also called by the searches, at regular intervals}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *     \cgalParamExtra{If `go_further()` returns `false`, the path has the status
 *       `Shortening_status::STOPPED_BY_VISITOR` and is not confirmed. If this happens before an edge path is found, the
 *       network remains empty, and the length is zero.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a report on the path. If a path was found, it is the only curve of the network
 *
 * \throws Invalid_curve_error if the vertices are equal
 * \throws Vertex_out_of_range_error as `geodesic_path()` does
 * \throws Disconnected_endpoints_error as `geodesic_path()` does
 * \throws Degenerate_face_error as `shorten()` does
 * \throws Invalid_coordinate_error as `geodesic_path()` does
 * \throws Invalid_mesh_error as `geodesic_path()` does
 * \throws Input_mismatch_error as `Geodesic_landmarks::check_input()` does
 * \throws Occupied_triangulation_error if another network has curves in the triangulation; nothing changes in this case
 *
 * After any exception other than `Occupied_triangulation_error`, including exceptions of the visitor, the network is
 * empty, and the triangulation has no flipped edges.
 *
 * Complexity: that of `geodesic_path()`, plus \cgalBigO{n \log n + w \log w} time for \f$w\f$ windows. Here, \f$n\f$
 * is the number of vertices for which the lower bounds of the metric on the distances from the source and to the target
 * add up to less than the length of the path. For a metric with points, these bounds are derived from distances in
 * space. In the worst case, the number of windows is \cgalBigO{n^2}.
 *
 * The algorithm starts with a geodesic that is obtained by shortening an edge path. The edge path is first straightened
 * (`add_straightened_path()`), unless a visitor must observe the whole process. A lower-bound propagation from the
 * target provides, for each edge, a lower bound on the remaining length of paths that cross the edge. Windows are then
 * propagated over the mesh as far as a shorter path could reach \cgalCite{MMP87}, \cgalCite{CH90}, \cgalCite{XW09}. If
 * the windows reveal a shorter path, this path replaces the geodesic and is inserted by flipping the edges that it
 * crosses.
 *
 * \sa `shortest_path()`
 */
template <class Network, class Search, class... NamedParameters>
Shortest_path_report add_shortest_path(Network& network, Search& search, Vertex_index source, Vertex_index target,
                                       const NamedParameters&... np)
{
  const auto& options =
      internal::options_of<internal::Limit_parameter, internal::Landmarks_parameter, internal_np::visitor_t>(np...);
  auto visitor = internal::make_visitor(options);
  return internal::add_shortest_path(network, search, internal::checked_landmarks(network.triangulation(), options),
                                     source, target, internal::search_limit_of<Window_limit>(options), visitor.get());
}

namespace internal {

/*
 * Computes a shortest path between two different vertices, and calls `write(network)` if it exists. The surface that
 * can be contracted is that of `whole`, which is the triangulation, or the one from which it was split.
 */
template <class Whole, class Triangulation, class NamedParameters, class Write>
Shortest_path_report find_shortest_path(const Whole& whole, Triangulation& triangulation, Vertex_index source,
                                        Vertex_index target, const NamedParameters& np, const Write& write)
{
  Shortest_edge_path<Triangulation> search(triangulation, parameters::search_method(Search_method::LOOK_BACK));
  Edge_path_network<Triangulation> network(triangulation);
  auto visitor = make_visitor(np);
  Shortest_path_report report = add_shortest_path(network, search, checked_landmarks(whole, np), source, target,
                                                  search_limit_of<Window_limit>(np), visitor.get());
  if(!report.is_confirmed() && !is_stopped_by_visitor(report) && is_contraction_of_use(whole))
    throw Degenerate_face_error(
        "the shortest path possibly passes through vertices that coincide because of degenerate faces; repair the mesh",
        {});
  note_contraction(whole, report.shortening);
  if(network.number_of_curves() != 0) // not stopped by the visitor
    write(network);
  return report;
}

template <class Form, class Triangulation, class TriangleMesh, class NamedParameters>
Computed_output<Form, Shortest_path_report> shortest_path_between(Triangulation& triangulation,
                                                                  const TriangleMesh& mesh, Vertex_index source,
                                                                  Vertex_index target, const NamedParameters& np)
{
  if(source == target) {
    auto point = path_in_one_place<Form>(triangulation, mesh, source);
    return {std::move(point.values), report_of_no_length(point.report)};
  }
  Computed_output<Form, Shortest_path_report> result;
  result.report = find_shortest_path(triangulation, triangulation, source, target, np, [&](const auto& network) {
    result.values = curve_forms<Form>(network, mesh, Curve_index(0));
  });
  return result;
}

/* Implements `shortest_path()` over a mesh; not inline, like `compute_path()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<Form, Shortest_path_report> compute_shortest_path(const TriangleMesh& mesh,
                                                                  Mesh_vertex<TriangleMesh> source,
                                                                  Mesh_vertex<TriangleMesh> target,
                                                                  const NamedParameters& np)
{
  using Triangulation = typename Curve_types<TriangleMesh, NamedParameters>::Triangulation;
  return compute_on_surface(Mesh_surfaces(mesh, np), [&](Triangulation& triangulation) {
    return shortest_path_between<Form>(triangulation, mesh, triangulation.index(source), triangulation.index(target),
                                       np);
  });
}

/* Computes a shortest path between points of the surface of a triangulation, given by canonical locations. */
template <class Form, class Triangulation, class TriangleMesh, class NamedParameters>
Computed_output<Form, Shortest_path_report> shortest_path_between(Triangulation& triangulation,
                                                                  const TriangleMesh& mesh,
                                                                  const std::vector<Surface_location>& ends,
                                                                  const NamedParameters& np)
{
  const auto tail = [&](const Surface_location& end) { return triangulation.input().tail(end.halfedge); };
  if(are_vertices(ends))
    return shortest_path_between<Form>(triangulation, mesh, tail(ends[0]), tail(ends[1]), np);
  Split_triangulation<Triangulation> split(triangulation, ends);
  Computed_output<Form, Shortest_path_report> result;
  Surface_polyline path = {ends[0], ends[0]};
  if(split.vertex(0) == split.vertex(1)) {
    result.report = report_of_no_length({{report_of_point(triangulation)}, 0, 0});
    note_contraction(triangulation, result.report.shortening);
  } else {
    try {
      path.clear();
      result.report = find_shortest_path(triangulation, split.triangulation(), split.vertex(0), split.vertex(1), np,
                                         [&](const auto& network) { path = curve_below(network, split.surface()); });
    } catch(const Disconnected_endpoints_error&) {
      throw_disconnected_points(tail(ends[0]), tail(ends[1])); // one of them is not a vertex of the mesh
    }
  }
  if(!path.empty())
    result.values = polyline_forms<Form>(triangulation, mesh, std::vector<Surface_polyline>(1, path));
  return result;
}

/* Implements `shortest_path()` between the two points that `locate(triangulation)` returns. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<Form, Shortest_path_report> compute_shortest_path_between(
    const TriangleMesh& mesh, const Locate_points<TriangleMesh, NamedParameters>& locate, const NamedParameters& np)
{
  using Triangulation = typename Curve_types<TriangleMesh, NamedParameters>::Triangulation;
  Located_points given;
  return compute_on_surface(Mesh_surfaces(mesh, np), [&](Triangulation& triangulation) {
    auto result = shortest_path_between<Form>(triangulation, mesh, canonical_points(triangulation, locate, given), np);
    result.report.shortening.curves.front().point_distances = given.distances;
    return result;
  });
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a shortest path on the surface between two points, and reports whether it is confirmed to be shortest.
 *
 * The guarantees and the algorithm are those of `add_shortest_path()`. A point that is not a vertex becomes one: the
 * faces that contain it are split in exact arithmetic, in constant time. The bound and the verdict therefore refer to
 * the surface of the mesh, with exact coordinates if its kernel provides them, and to end points whose weights are
 * exactly the given doubles.
 *
 * \param mesh a triangle mesh
 * \param source, target points in the same connected component, of equal or different types: vertices of the mesh,
 *        `CGAL::Polygon_mesh_processing::Face_location`s, `Surface_location`s, `Curve_place`s or `Curve_point`s, or
 *        points in space. `surface_location()` describes how points are snapped, and which point of the mesh represents
 *        a point in space. A location at a vertex gives the same result as the vertex. A path between coincident points
 *        has the verdict `Verdict::WITHIN_ROUNDING`, unless coordinates or lengths of the mesh had to be rounded
 * \param out an output iterator that receives the points of the path, in the form described at `geodesic_path()`
 * \param np an optional sequence of named parameters among those listed below, and `vertex_point_map`, `metric`,
 *        `geom_traits` and `visitor` as for `geodesic_path()`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{search_limit}
 *     \cgalParamDescription{the number of windows after which the search is aborted; `Shortest_path_report::gap()`
 *       returns the gap that remains}
 *     \cgalParamType{`Window_limit`}
 *     \cgalParamDefault{`Window_limit()`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{landmarks}
 *     \cgalParamDescription{landmarks that were computed for this mesh and its metric. They are worthwhile if paths
 *       between many pairs of points are computed}
 *     \cgalParamType{`Geodesic_landmarks`}
 *     \cgalParamDefault{no landmarks}
 *     \cgalParamExtra{The bound remains valid but can differ, in its last digits, from the bound without landmarks. If
 *       several paths are shortest, a different one can be returned.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{greatest_point_distance}
 *     \cgalParamDescription{the greatest distance from the surface at which a point in space is accepted}
 *     \cgalParamType{a non-negative number}
 *     \cgalParamDefault{no limit}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the past-the-end output iterator, and a report, in which `Curve_report::point_distances` contains the
 *         distances of the given points from the surface. It is empty if both ends are given as vertices
 *
 * \throws Vertex_out_of_range_error as `geodesic_path()` does
 * \throws Disconnected_endpoints_error as `geodesic_path()` does
 * \throws Degenerate_face_error as `geodesic_path()` does
 * \throws Invalid_coordinate_error as `geodesic_path()` does
 * \throws Invalid_mesh_error as `geodesic_path()` does
 * \throws Input_mismatch_error as `Geodesic_landmarks::check_input()` does
 * \throws Invalid_location_error if an end is not a point of the surface
 * \throws Distant_point_error if a point in space is too far from the surface
 * \throws Insertion_error if an end is too close to a vertex or to the other end to be distinguished from it
 *
 * Complexity: that of `add_shortest_path()`.
 *
 * \sa `geodesic_path()`
 */
template <class TriangleMesh, class Source, class Target, class OutputIterator, class... NamedParameters>
Shortest_path_result<OutputIterator> shortest_path(const TriangleMesh& mesh, const Source& source, const Target& target,
                                                   OutputIterator out, const NamedParameters&... np)
{
  const auto& options =
      internal::surface_options<internal_np::visitor_t, internal::Limit_parameter, internal::Landmarks_parameter,
                                internal::Point_distance_parameter>(np...);
  using Options = internal::Joined<NamedParameters...>;
  using Form = internal::Form_by_name<TriangleMesh, Options, OutputIterator>;
  if constexpr(internal::is_mesh_vertex<TriangleMesh, Source> && internal::is_mesh_vertex<TriangleMesh, Target>) {
    return internal::write_computed<Shortest_path_result<OutputIterator>>(
        internal::compute_shortest_path<Form>(mesh, Mesh_vertex<TriangleMesh>(source),
                                              Mesh_vertex<TriangleMesh>(target), options),
        out);
  } else {
    const auto locate = [&](const auto& triangulation) {
      return internal::located_ends(triangulation, mesh, source, target, options);
    };
    return internal::write_computed<Shortest_path_result<OutputIterator>>(
        internal::compute_shortest_path_between<Form, TriangleMesh, Options>(mesh, locate, options), out);
  }
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes landmarks, which provide lower bounds on distances and thus speed up repeated calls of `shortest_path()` on
 * one mesh.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, or `Parallel_tag` if TBB is linked. With `Parallel_tag`, several
 *         propagations run concurrently; the results are the same
 *
 * \param mesh a triangle mesh
 * \param number the number of landmarks in each component
 * \param np the named parameters `vertex_point_map`, `metric` and `geom_traits` as for `geodesic_path()`, and
 *        `visitor`. If `go_further()` of the visitor returns `false`, the result is incomplete; see
 *        `Geodesic_landmarks::is_complete()`
 * \throws Degenerate_face_error as `Geodesic_landmarks` does
 * \throws Invalid_coordinate_error as `Geodesic_landmarks` does
 * \throws Invalid_mesh_error as `Geodesic_landmarks` does
 */
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh, class... NamedParameters>
Geodesic_landmarks geodesic_landmarks(const TriangleMesh& mesh, std::size_t number, const NamedParameters&... np)
{
  const auto& options = internal::surface_options<internal_np::visitor_t>(np...);
  auto visitor = internal::make_visitor(options);
  return Geodesic_landmarks(internal::make_triangulation(mesh, options), number, ConcurrencyTag(),
                            parameters::visitor(std::ref(visitor.get())));
}

/// \ingroup PkgFlipGeodesicsFunctions
/// Computes `Geodesic_landmarks::default_number` landmarks in each component. The parameters and exceptions are those
/// of the overload with a number.
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh, class... NamedParameters,
          std::enable_if_t<(internal::is_named_parameters<NamedParameters> && ...), int> = 0>
Geodesic_landmarks geodesic_landmarks(const TriangleMesh& mesh, const NamedParameters&... np)
{
  return Flip_geodesics::geodesic_landmarks<ConcurrencyTag>(mesh, Geodesic_landmarks::default_number, np...);
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes landmarks at given vertices.
 *
 * \param mesh a triangle mesh
 * \param landmarks a range of vertices of the mesh in any order; repeated vertices count once
 * \param np the named parameters `vertex_point_map`, `metric` and `geom_traits` as for `geodesic_path()`, and
 *        `visitor`. If `go_further()` of the visitor returns `false`, the result is incomplete; see
 *        `Geodesic_landmarks::is_complete()`
 * \throws Vertex_out_of_range_error if a landmark is not a vertex of the mesh
 * \throws Degenerate_face_error as `Geodesic_landmarks` does
 * \throws Invalid_coordinate_error as `Geodesic_landmarks` does
 * \throws Invalid_mesh_error as `Geodesic_landmarks` does
 */
template <
    class ConcurrencyTag = Sequential_tag, class TriangleMesh,
    class VertexRange = std::vector<Mesh_vertex<TriangleMesh>>, class... NamedParameters,
    std::enable_if_t<
        !std::is_convertible<VertexRange, std::size_t>::value && !internal::is_named_parameters<VertexRange>, int> = 0>
Geodesic_landmarks geodesic_landmarks(const TriangleMesh& mesh, const VertexRange& landmarks,
                                      const NamedParameters&... np)
{
  static_assert(
      internal::is_range_of<VertexRange, Mesh_vertex<TriangleMesh>>,
      "a number of landmarks or a range of vertices of the mesh is expected here; the order of the arguments is mesh, "
      "landmarks, named parameters");
  const auto& options = internal::surface_options<internal_np::visitor_t>(np...);
  const auto triangulation = internal::make_triangulation(mesh, options);
  std::vector<Vertex_index> indices;
  for(const Mesh_vertex<TriangleMesh> v : landmarks)
    indices.push_back(triangulation.index(v));
  auto visitor = internal::make_visitor(options);
  return Geodesic_landmarks(triangulation, indices, ConcurrencyTag(), parameters::visitor(std::ref(visitor.get())));
}

#ifdef CGAL_FLIP_GEODESICS_COMPILED
namespace internal {

#define CGAL_FLIP_GEODESICS_INSTANCES(Mesh, Form)                                                                      \
  CGAL_FLIP_GEODESICS_SHORTEST_PATH_INSTANCE Computed_output<Form, Shortest_path_report> compute_shortest_path(        \
      const Mesh&, Mesh_vertex<Mesh>, Mesh_vertex<Mesh>, const parameters::Default_named_parameters&);
CGAL_FLIP_GEODESICS_FOR_COMPILED_FORMS(CGAL_FLIP_GEODESICS_INSTANCES)
#undef CGAL_FLIP_GEODESICS_INSTANCES

} // namespace internal
#endif

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_SHORTEST_PATH_H
