// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_LANDMARKS_H
#define CGAL_FLIP_GEODESICS_GEODESIC_LANDMARKS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/input/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/windows/Cone_sweep.h>
#include <CGAL/Flip_geodesics/internal/windows/Goal_bound.h>
#include <CGAL/Flip_geodesics/internal/windows/Landmark_rows.h>
#include <CGAL/Flip_geodesics/internal/windows/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Lower bounds of the distances on a surface between all pairs of vertices. Landmarks are vertices far from one
 * another. A sweep from each landmark gives all vertices values that are about their distances from it. Two vertices
 * are not closer to each other than their values differ [Goldberg, Harrelson, Computing the shortest path: A* search
 * meets graph theory]. Made once for many shortest paths on one mesh, they keep the searches to where shortest paths
 * can run. `Landmark_distances` do that for paths along edges.
 *
 * The bounds hold for the mesh as its numbers say, rounding included, as `Shortest_path_report::lower_bound` does.
 *
 * Each component has its own landmarks, `number_of_landmarks()` of them. They take two bytes a landmark and vertex, and
 * may be read by several threads at once.
 */
class Geodesic_landmarks
{
public:
  /// How many there are unless one says otherwise.
  static constexpr std::size_t default_number = 8;

  /*!
   * Chooses the landmarks, each the vertex of its component that is farthest from those before, and sweeps.
   *
   * Complexity: \f$O(n \log n)\f$ for each landmark, on meshes of needles more.
   *
   * \param triangulation a triangulation of the mesh; flips do not matter. It is not kept
   * \param number of landmarks in each component; a larger one than that of the mesh's vertices counts as that
   * \throws Degenerate_face_error for an edge of length zero, wherever it is
   * \throws Invalid_coordinate_error, Invalid_mesh_error for any face, as `Intrinsic_triangulation` does where it is
   *         asked
   */
  template <class Triangulation>
  explicit Geodesic_landmarks(const Triangulation& triangulation, std::size_t number = default_number)
    : m_number_of_vertices(triangulation.input().number_of_vertices())
    , m_number_of_halfedges(triangulation.input().number_of_halfedges())
    , m_number_of_faces(triangulation.input().number_of_faces())
  {
    note_borders(triangulation);
    sweep(triangulation, (std::min)(number, static_cast<std::size_t>(m_number_of_vertices)));
  }

  /// The number of landmarks of a component: as many as have been asked for, but no more than the mesh has vertices. If
  /// a component has fewer vertices, some are landmarks several times.
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

  /// The values, for searches; of a type that is not documented.
  const internal::Landmark_rows& rows() const { return m_rows; }

private:
  // At a landmark, or on a border.
  struct Edge
  {
    Input_halfedge_index halfedge;
    bool is_border;
    double length;
  };

  static constexpr int free_updates = 400; // many, since needles need them, and the sweeps are made once
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // Chooses landmarks in all components at once.
  class Choice
  {
  public:
    explicit Choice(std::size_t number_of_vertices)
      : m_component(number_of_vertices, -1)
      , m_nearest(number_of_vertices, infinity)
    {
    }

    // The vertices that are farthest along edges from the first of each component; returns the largest distance.
    template <class Search>
    double begin(Search& search)
    {
      double radius = 0;
      for(Vertex_index v : internal::descriptors<Vertex_index>(static_cast<Index>(m_component.size()))) {
        if(m_component[v] >= 0)
          continue;
        const Index component = static_cast<Index>(m_farthest.size());
        m_farthest.push_back(v);
        search.visit_all(v, [&](Vertex_index w, double distance) {
          m_component[w] = component;
          m_farthest.back() = w; // they come in the order of distance
          radius = (std::max)(radius, distance);
        });
      }
      return radius;
    }

    // One in each component.
    const std::vector<Vertex_index>& landmarks() const { return m_farthest; }

    // Vertices are so far from the last landmarks.
    template <class Distance>
    void go_on(const Distance& distance)
    {
      std::vector<double> farthest(m_farthest.size(), -1);
      for(Vertex_index v : internal::descriptors<Vertex_index>(static_cast<Index>(m_component.size()))) {
        m_nearest[v] = (std::min)(m_nearest[v], distance(v));
        double& best = farthest[static_cast<std::size_t>(m_component[v])];
        if(m_nearest[v] > best) {
          best = m_nearest[v];
          m_farthest[static_cast<std::size_t>(m_component[v])] = v;
        }
      }
    }

  private:
    internal::Indexed_by<Vertex_index, std::vector<Index>> m_component;
    internal::Indexed_by<Vertex_index, std::vector<double>> m_nearest; // how far the nearest landmark is
    std::vector<Vertex_index> m_farthest;
  };

  template <class Triangulation>
  void sweep(const Triangulation& triangulation, std::size_t number)
  {
    Shortest_edge_path<Triangulation> search(triangulation, Search_method::DIJKSTRA);
    Choice choice(static_cast<std::size_t>(m_number_of_vertices));
    const double largest = 2 * choice.begin(search) * (1 + 0x1p-20); // no two vertices are farther apart along edges
    m_rows = internal::Landmark_rows(static_cast<std::size_t>(m_number_of_vertices), number, largest);
    internal::Unfolded_faces<Triangulation> faces(triangulation);
    for(std::size_t i = 0; i < number; ++i) {
      note_edge(triangulation, choice.landmarks(), i);
      internal::Cone_sweep<Triangulation> sweep(triangulation, faces, null_index,
                                                internal::Goal_bound<Triangulation>(triangulation), free_updates);
      sweep.run_from(choice.landmarks(), largest);
      if(sweep.is_useful())
        keep(i, sweep);
      choice.go_on([&](Vertex_index v) { return sweep.is_useful() ? sweep.distance_lower_bound(v) : infinity; });
    }
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

  // At the landmark of each component in turn, unless it is an isolated vertex.
  template <class Triangulation>
  void note_edge(const Triangulation& triangulation, const std::vector<Vertex_index>& landmarks, std::size_t i)
  {
    if(landmarks.empty())
      return;
    const Input_halfedge_index h = triangulation.input().outgoing(landmarks[i % landmarks.size()]);
    if(h != null_index)
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

  Index m_number_of_vertices, m_number_of_halfedges, m_number_of_faces;
  std::vector<Edge> m_edges;
  internal::Landmark_rows m_rows;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_LANDMARKS_H
