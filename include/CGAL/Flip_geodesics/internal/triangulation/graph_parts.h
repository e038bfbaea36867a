// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_GRAPH_PARTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_GRAPH_PARTS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <memory>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The halfedges of a triangulation that are the smallest of their faces, as faces. */
template <class Triangulation>
class Face_iterator
  : public boost::iterator_facade<Face_iterator<Triangulation>, Face_index, std::forward_iterator_tag, Face_index>
{
public:
  Face_iterator() = default;

  Face_iterator(const Triangulation& triangulation, Halfedge_index h)
    : m_triangulation(&triangulation)
    , m_halfedge(h)
  {
    skip_others();
  }

private:
  friend class boost::iterator_core_access;

  Face_index dereference() const { return Face_index(m_halfedge.idx()); }
  bool equal(const Face_iterator& other) const { return m_halfedge == other.m_halfedge; }

  void increment()
  {
    ++m_halfedge;
    skip_others();
  }

  void skip_others()
  {
    while(m_halfedge.idx() < m_triangulation->number_of_halfedges() && !is_first_of_face())
      ++m_halfedge;
  }

  bool is_first_of_face() const
  {
    return !m_triangulation->is_border(m_halfedge) && m_halfedge <= m_triangulation->next(m_halfedge) &&
           m_halfedge <= m_triangulation->previous(m_halfedge);
  }

  const Triangulation* m_triangulation = nullptr;
  Halfedge_index m_halfedge;
};

/* From descriptors to their numbers. */
template <class Key>
struct Descriptor_index_map
{
  using key_type = Key;
  using value_type = Index;
  using reference = Index;
  using category = boost::readable_property_map_tag;

  friend Index get(const Descriptor_index_map&, Key key) { return key.idx(); }
};

/* From the faces of a triangulation as it is to consecutive numbers. */
class Face_index_map
{
public:
  using key_type = Face_index;
  using value_type = Index;
  using reference = Index;
  using category = boost::readable_property_map_tag;

  Face_index_map() = default;

  template <class Triangulation>
  explicit Face_index_map(const Triangulation& triangulation)
    : m_numbers(std::make_shared<Numbers>(static_cast<std::size_t>(triangulation.number_of_halfedges()), null_index))
  {
    Index count = 0;
    for(Face_index f : faces(triangulation))
      (*m_numbers)[f] = count++;
  }

  friend Index get(const Face_index_map& map, Face_index f) { return (*map.m_numbers)[f]; }

private:
  using Numbers = Indexed_by<Face_index, std::vector<Index>>;

  std::shared_ptr<Numbers> m_numbers;
};

/* From edges to their intrinsic lengths. */
template <class Triangulation>
struct Edge_length_map
{
  using key_type = Edge_index;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  const Triangulation* triangulation = nullptr;

  friend double get(const Edge_length_map& map, Edge_index e) { return map.triangulation->length(first_side(e)); }
};

/* From vertices to their points in space. */
template <class Triangulation>
struct Intrinsic_point_map
{
  using key_type = Vertex_index;
  using value_type = typename Triangulation::Metric::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Triangulation* triangulation = nullptr;

  friend value_type get(const Intrinsic_point_map& map, Vertex_index v)
  {
    const Triangulation& t = *map.triangulation;
    if(!t.is_inserted(v))
      return t.metric().point(t.input(), v);
    return point_in_space(t, surface_point(t, t.location(v)));
  }
};

/* What boost::graph_traits says of a triangulation. */
template <class Triangulation>
struct Intrinsic_graph_traits
{
  struct traversal_category : public virtual boost::bidirectional_graph_tag,
                              public virtual boost::vertex_list_graph_tag,
                              public virtual boost::edge_list_graph_tag,
                              public virtual boost::adjacency_graph_tag
  {
  };

  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;

  using vertex_descriptor = Vertex_index;
  using halfedge_descriptor = Halfedge_index;
  using edge_descriptor = Edge_index;
  using face_descriptor = Face_index;

  using vertex_iterator = Descriptor_iterator<Vertex_index>;
  using halfedge_iterator = Descriptor_iterator<Halfedge_index>;
  using edge_iterator = Descriptor_iterator<Edge_index>;
  using face_iterator = Face_iterator<Triangulation>;
  using out_edge_iterator = CGAL::Out_edge_iterator<Triangulation>;
  using in_edge_iterator = CGAL::In_edge_iterator<Triangulation>;
  using adjacency_iterator = CGAL::Vertex_around_target_iterator<Triangulation>;

  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using degree_size_type = std::size_t;

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static edge_descriptor null_edge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_GRAPH_PARTS_H
