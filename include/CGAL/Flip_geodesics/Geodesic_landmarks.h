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
 * Lower bounds of the distances on a surface between all pairs of vertices. Landmarks are vertices far from one
 * another, or those that a caller gives. A sweep from each landmark gives all vertices values that are about their
 * distances from it. Two vertices are not closer to each other than their values differ [Goldberg, Harrelson, Computing
 * the shortest path: A* search meets graph theory]. Made once for many shortest paths on one mesh, they keep the
 * searches to where shortest paths can run. `Landmark_distances` do that for paths along edges.
 *
 * The bounds hold for the mesh as its numbers say, rounding included, as `Shortest_path_report::lower_bound` does.
 *
 * Each component has its own landmarks, `number_of_landmarks()` of them at most. They take two bytes a landmark and
 * vertex, and may be read by several threads at once. A sweep takes some 400 bytes a triangle while it runs.
 */
class Geodesic_landmarks
{
public:
  /// How many there are unless one says otherwise.
  static constexpr std::size_t default_number = 8;

  /*!
   * Chooses the landmarks, each the vertex of its component that is farthest along edges from those before, and sweeps.
   *
   * Complexity: \f$O(n \log n)\f$ for each landmark, on meshes of needles more.
   *
   * \tparam ConcurrencyTag `CGAL::Sequential_tag`, or `CGAL::Parallel_tag` where TBB is linked, for several sweeps at the
   *         same time; the results are the same
   *
   * \param triangulation a triangulation of the mesh; flips do not matter. It is not kept
   * \param number of landmarks in each component; one with fewer vertices has no more landmarks than those
   * \param tag says by its type whether there are threads
   * \param visitor a model of `FlipOutVisitor`, of which only `go_further()` is called, at regular intervals and from
   *        the calling thread. If it returns `false`, then `is_complete()` returns `false`, there are no landmarks, and
   *        all bounds are zero
   * \throws Degenerate_face_error for an edge of length zero, wherever it is
   * \throws Invalid_coordinate_error, Invalid_mesh_error for any face, as `Intrinsic_triangulation` does where it is
   *         asked
   */
  template <class Triangulation, class ConcurrencyTag = Sequential_tag, class Visitor = Default_shortening_visitor>
  explicit Geodesic_landmarks(const Triangulation& triangulation, std::size_t number = default_number,
                              ConcurrencyTag tag = ConcurrencyTag(), Visitor&& visitor = Visitor())
  {
    make(triangulation, tag, visitor,
         [&](const Choice& choice, auto& search) { return choice.far_vertices(search, number); });
  }

  /*!
   * Sweeps from landmarks that are given, for instance some about the part of a mesh where all paths run.
   *
   * Complexity: as above.
   *
   * \tparam ConcurrencyTag as above
   *
   * \param triangulation a triangulation of the mesh; flips do not matter. It is not kept
   * \param landmarks a range of `Vertex_index`es in any order, each of which counts once. Components without any have no
   *        bounds
   * \param tag says by its type whether there are threads
   * \param visitor a model of `FlipOutVisitor`, which can stop the construction as above
   * \throws Vertex_out_of_range_error
   * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error as above
   */
  template <class Triangulation, class VertexRange = std::vector<Vertex_index>, class ConcurrencyTag = Sequential_tag,
            class Visitor = Default_shortening_visitor,
            std::enable_if_t<!std::is_convertible<VertexRange, std::size_t>::value, int> = 0>
  Geodesic_landmarks(const Triangulation& triangulation, const VertexRange& landmarks,
                     ConcurrencyTag tag = ConcurrencyTag(), Visitor&& visitor = Visitor())
  {
    static_assert(internal::is_range_of<VertexRange, Vertex_index>,
                  "no number of landmarks where it belongs, nor a range of vertices; the order is triangulation, "
                  "landmarks, concurrency tag");
    const std::vector<Vertex_index> given(std::begin(landmarks), std::end(landmarks));
    make(triangulation, tag, visitor, [&](const Choice& choice, const auto&) { return choice.given_vertices(given); });
  }

  /// Returns whether the bounds are known; they are not if a visitor stopped the construction.
  bool is_complete() const { return m_is_complete; }

  /// The number of landmarks of the component that has the most.
  std::size_t number_of_landmarks() const { return m_rows.number_of_functions(); }

  /// No path between two vertices is shorter. Linear in the number of landmarks.
  /// \pre they are vertices of the mesh
  double distance_lower_bound(Vertex_index v, Vertex_index w) const { return m_rows.distance_lower_bound(v, w); }

  /*!
   * Asks whether they can have been made for the input of a triangulation. Compares the numbers of vertices, edges and
   * faces, whether there are the same borders, and the lengths of an edge of each border and of
   * `number_of_landmarks()` edges at landmarks. So it finds another mesh, a face more or less, and another metric, but
   * not each vertex that has moved: bounds hold for the mesh that they were made for.
   *
   * Complexity: linear in the numbers of landmarks and of borders.
   *
   * \throws Input_mismatch_error if they cannot
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

  static constexpr int free_updates = 400; // many, since needles need them, and the sweeps are made once
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // `choose(choice, search)` returns sets of landmarks.
  template <class Triangulation, class ConcurrencyTag, class Visitor, class Choose>
  void make(const Triangulation& triangulation, ConcurrencyTag, Visitor& visitor, const Choose& choose)
  {
    internal::Interruption interruption(visitor);
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

  // From each set by itself. As all faces are laid out before, sweeps only read them, and their order does not matter.
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

  // Those about each vertex in turn, for what is near on the mesh to be near in memory; then any that this has missed.
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

  // All that a sweep says is lower by its error, which does not matter for differences.
  template <class Sweep>
  void keep(std::size_t i, const Sweep& sweep)
  {
    m_rows.set_error(i, sweep.total_error());
    for(Vertex_index v : internal::descriptors<Vertex_index>(m_number_of_vertices))
      if(const double value = sweep.distance_lower_bound(v); value < infinity)
        m_rows.set(v, i, value);
  }

  // At a landmark, unless it is an isolated vertex.
  template <class Triangulation>
  void note_edge(const Triangulation& triangulation, Vertex_index landmark)
  {
    if(const Input_halfedge_index h = triangulation.input().outgoing(landmark); h != null_index)
      note(triangulation, h);
  }

  // An edge of each. If there are as many faces in all, and each of these is on a border, then borders are the same
  // unless one is in another place that has this edge, too.
  template <class Triangulation>
  void note_borders(const Triangulation& triangulation)
  {
    const auto& input = triangulation.input();
    internal::Indexed_by<Input_halfedge_index, std::vector<char>> is_seen(
        static_cast<std::size_t>(m_number_of_halfedges), 0);
    for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(m_number_of_halfedges)) {
      if(!input.is_border(h) || is_seen[h] != 0)
        continue;
      internal::check_has_face(input, h); // what follows an edge without a face may be nothing
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
