// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FACE_ARRANGEMENT_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FACE_ARRANGEMENT_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The constrained Delaunay triangulation of a face by nodes and segments between them: segments that cross get a vertex
 * at the crossing. Coordinates are exact, and so is each decision. Nodes are numbers of the caller's.
 */
class Face_arrangement
{
public:
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Point_2 = Kernel::Point_2;
  using Segment = std::array<std::size_t, 2>;
  using Triangle = std::array<std::size_t, 3>;

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /* Adds a node, and returns the node at this point: another one if that was there before. */
  std::size_t add_node(std::size_t node, const Point_2& p)
  {
    const Vertex_handle v = m_triangulation.insert(p);
    if(v->info().node == none) {
      v->info().node = node;
      m_vertices[node] = v;
    }
    return v->info().node;
  }

  /* Adds the segment between two nodes that differ. */
  void add_segment(std::size_t a, std::size_t b)
  {
    m_constraints.push_back(m_triangulation.insert_constraint(m_vertices.at(a), m_vertices.at(b)));
  }

  /* Lets `make_node` return a node for the point of each crossing. */
  template <class MakeNode>
  void add_crossings(const MakeNode& make_node)
  {
    for(auto v = m_triangulation.finite_vertices_begin(); v != m_triangulation.finite_vertices_end(); ++v)
      if(v->info().node == none)
        v->info().node = make_node(v->point());
  }

  /* The segments, divided at all nodes that they pass; each once, with the smaller node first. */
  std::vector<Segment> segments() const
  {
    std::set<Segment> result;
    for(const Constraint_id& id : m_constraints)
      for(auto v = m_triangulation.vertices_in_constraint_begin(id);;) {
        const std::size_t a = (*v)->info().node;
        if(++v == m_triangulation.vertices_in_constraint_end(id))
          break;
        const std::size_t b = (*v)->info().node;
        result.insert({{(std::min)(a, b), (std::max)(a, b)}});
      }
    return std::vector<Segment>(result.begin(), result.end());
  }

  /* The triangles, counterclockwise. */
  std::vector<Triangle> triangles() const
  {
    std::vector<Triangle> result;
    for(auto f = m_triangulation.finite_faces_begin(); f != m_triangulation.finite_faces_end(); ++f)
      result.push_back({{f->vertex(0)->info().node, f->vertex(1)->info().node, f->vertex(2)->info().node}});
    return result;
  }

private:
  struct Numbered
  {
    std::size_t node = none;
  };
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Numbered, Kernel>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Data_structure = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
  using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data_structure, CGAL::Exact_intersections_tag>;
  using Triangulation = CGAL::Constrained_triangulation_plus_2<Delaunay>;
  using Vertex_handle = Triangulation::Vertex_handle;
  using Constraint_id = Triangulation::Constraint_id;

  Triangulation m_triangulation;
  std::map<std::size_t, Vertex_handle> m_vertices;
  std::vector<Constraint_id> m_constraints;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FACE_ARRANGEMENT_H
