// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_LANDMARKS_H
#define CGAL_FLIP_GEODESICS_GEODESIC_LANDMARKS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Cone_sweep.h>
#include <CGAL/Flip_geodesics/internal/distances/Landmark_rows.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/surface/Internals.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/for_each_index.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Computes lower bounds of the distances on a surface between all pairs of vertices, with landmarks, which are vertices
 * far from one another or chosen by the caller.
 *
 * A lower-bound propagation from each landmark assigns values to all vertices that are close to their distances from
 * it. The difference of the values of two vertices is a lower bound of the distance between them [Goldberg, Harrelson,
 * Computing the shortest path: A* search meets graph theory]. Landmarks are computed once for many shortest paths on
 * one mesh, and confine the searches to the regions that shortest paths can pass. `Landmark_distances` do the same for
 * paths along edges.
 *
 * The bounds hold for the mesh with its coordinates taken as given, including rounding errors, like
 * `Shortest_path_report::lower_bound`. Each component has its own landmarks, at most `number_of_landmarks()`. They take
 * two bytes per landmark and vertex, and may be read by several threads concurrently. A propagation takes some 400
 * bytes per triangle while it runs.
 */
class Geodesic_landmarks
{
public:
  /// The default number of landmarks.
  static constexpr std::size_t default_number = 8;

  /*!
   * Chooses the landmarks, each the vertex of its component that is farthest along edges from the previous ones, and
   * computes the bounds.
   *
   * \tparam ConcurrencyTag `CGAL::Sequential_tag`, or `CGAL::Parallel_tag` if TBB is linked, for several concurrent
   *         propagations; the results are the same
   *
   * \param triangulation a triangulation of the mesh, which is not stored; its flips have no effect
   * \param number the number of landmarks in each component; a component with fewer vertices has fewer landmarks
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
   * \throws Degenerate_face_error if the mesh has a degenerate edge
   * \throws Invalid_coordinate_error for any face, as `Intrinsic_triangulation` does when a face is accessed
   * \throws Invalid_mesh_error for any face, as `Intrinsic_triangulation` does when a face is accessed
   *
   * Complexity: \f$O(n \log n)\f$ for each landmark; more on meshes of needles.
   */
  template <class Triangulation, class ConcurrencyTag = Sequential_tag, class... NamedParameters>
  explicit Geodesic_landmarks(const Triangulation& triangulation, std::size_t number = default_number,
                              ConcurrencyTag tag = ConcurrencyTag(), const NamedParameters&... np)
  {
    make(triangulation, tag, internal::options_of<internal_np::visitor_t>(np...),
         [&](const Choice& choice, auto& search) { return choice.far_vertices(search, number); });
  }

  /*!
   * Computes the bounds with given landmarks, for instance around the part of a mesh that contains all paths.
   *
   * \tparam ConcurrencyTag `CGAL::Sequential_tag`, or `CGAL::Parallel_tag` if TBB is linked, for several concurrent
   *         propagations; the results are the same
   *
   * \param triangulation a triangulation of the mesh, which is not stored; its flips have no effect
   * \param landmarks a range of `Vertex_index`es in any order, where repeated ones count once. Components without
   *        landmarks have no bounds
   * \param tag an object whose type selects sequential or parallel execution
   * \param np the named parameter `visitor`, as for the constructor with a number of landmarks
   * \throws Vertex_out_of_range_error if a landmark is not a vertex of the mesh
   * \throws Degenerate_face_error if the mesh has a degenerate edge
   * \throws Invalid_coordinate_error for any face, as `Intrinsic_triangulation` does when a face is accessed
   * \throws Invalid_mesh_error for any face, as `Intrinsic_triangulation` does when a face is accessed
   *
   * Complexity: \f$O(n \log n)\f$ for each landmark; more on meshes of needles.
   */
  template <class Triangulation, class VertexRange = std::vector<Vertex_index>, class ConcurrencyTag = Sequential_tag,
            class... NamedParameters, std::enable_if_t<!std::is_convertible<VertexRange, std::size_t>::value, int> = 0>
  Geodesic_landmarks(const Triangulation& triangulation, const VertexRange& landmarks,
                     ConcurrencyTag tag = ConcurrencyTag(), const NamedParameters&... np)
  {
    static_assert(internal::is_range_of<VertexRange, Vertex_index>,
                  "no number of landmarks where it belongs, nor a range of vertices; the order is triangulation, "
                  "landmarks, concurrency tag");
    const std::vector<Vertex_index> given(std::begin(landmarks), std::end(landmarks));
    make(triangulation, tag, internal::options_of<internal_np::visitor_t>(np...),
         [&](const Choice& choice, const auto&) { return choice.given_vertices(given); });
  }

  /// Returns whether the bounds are known, that is, whether no visitor stopped the construction.
  bool is_complete() const { return m_is_complete; }

  /// Returns the number of landmarks of the component that has the most.
  std::size_t number_of_landmarks() const { return m_rows.number_of_functions(); }

  /// Returns a lower bound of the length of every path between two vertices. Linear in the number of landmarks.
  /// \pre `v` and `w` are vertices of the mesh
  double distance_lower_bound(Vertex_index v, Vertex_index w) const { return m_rows.distance_lower_bound(v, w); }

  /*!
   * Checks whether the landmarks can have been computed for the input of a triangulation.
   *
   * The function compares the numbers of vertices, edges and faces, the borders, and the lengths of an edge of each
   * border and of `number_of_landmarks()` edges at landmarks. It thus detects another mesh, an additional or missing
   * face, and another metric, but not every vertex that has moved. The bounds hold only for the mesh for which they
   * were computed.
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
      throw Input_mismatch_error("the landmarks were made for another mesh, or another metric");
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
    Shortest_edge_path<Triangulation> search(triangulation, Search_method::DIJKSTRA);
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_LANDMARKS_H
