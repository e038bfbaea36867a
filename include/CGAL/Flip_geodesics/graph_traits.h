// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GRAPH_TRAITS_H
#define CGAL_FLIP_GEODESICS_GRAPH_TRAITS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Iterates over the smallest halfedges of the faces of a triangulation, as faces. */
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

template <class Key>
struct Descriptor_index_map
{
  using key_type = Key;
  using value_type = Index;
  using reference = Index;
  using category = boost::readable_property_map_tag;

  friend Index get(const Descriptor_index_map&, Key key) { return key.idx(); }
};

/* Maps the current faces of a triangulation to consecutive numbers. */
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

} // namespace CGAL::Flip_geodesics::internal

/*!
 * \file
 * \ingroup PkgFlipGeodesicsGraph
 *
 * Makes `Intrinsic_triangulation` a model of `HalfedgeListGraph` and `FaceListGraph`, so that algorithms of BGL and of
 * \cgal can be applied to triangulations. The header provides `boost::graph_traits`, the functions of the two concepts,
 * and dynamic property maps. It also provides the property maps `vertex_index_t`, `halfedge_index_t`, `edge_index_t`,
 * `face_index_t`, `edge_weight_t` (the intrinsic lengths) and, if the metric has points, `vertex_point_t`.
 *
 * `boost::graph_traits` is specialized for the class `Intrinsic_triangulation` itself, not for other models of
 * `IntrinsicTriangulation` or for derived classes.
 *
 * Complexity: constant for all functions, with the following exceptions. Time linear in the degree of a vertex is
 * required by `next()` and `prev()` of a border halfedge, by the functions that return the degree of a vertex, and by
 * the functions that find an edge or halfedge between two vertices. `num_faces()` and an iteration over `faces()` visit
 * all halfedges. The map of face indices is constructed when it is requested, in time linear in the number of
 * halfedges, and remains valid until the next flip or insertion.
 *
 * A triangulation can contain loops, several edges between two vertices, and faces that are glued to themselves.
 * Algorithms that identify edges by their ends, or that require the neighbors of a vertex to be distinct, cannot be
 * used on such a triangulation.
 *
 * A flip changes the ends of one edge and replaces two faces by two new ones; all other descriptors keep their meaning.
 * An insertion adds elements and changes only the meaning of the descriptors of elements that it splits: a face, or an
 * edge and its incident faces.
 */

namespace boost {

template <class TriangleMesh, class Traits, class Metric>
struct graph_traits<CGAL::Flip_geodesics::Intrinsic_triangulation<TriangleMesh, Traits, Metric>>
#ifndef DOXYGEN_RUNNING
  : CGAL::Flip_geodesics::internal::Intrinsic_graph_traits<
        CGAL::Flip_geodesics::Intrinsic_triangulation<TriangleMesh, Traits, Metric>>
#endif
{
};

template <class TriangleMesh, class Traits, class Metric>
struct graph_traits<const CGAL::Flip_geodesics::Intrinsic_triangulation<TriangleMesh, Traits, Metric>>
  : graph_traits<CGAL::Flip_geodesics::Intrinsic_triangulation<TriangleMesh, Traits, Metric>>
{
};

} // namespace boost

#ifndef DOXYGEN_RUNNING

namespace CGAL {
namespace Flip_geodesics {

// ---------------------------------------------------------------- counting

template <class M, class T, class E>
std::size_t num_vertices(const Intrinsic_triangulation<M, T, E>& t)
{
  return static_cast<std::size_t>(t.number_of_vertices());
}

template <class M, class T, class E>
std::size_t num_halfedges(const Intrinsic_triangulation<M, T, E>& t)
{
  return static_cast<std::size_t>(t.number_of_halfedges());
}

template <class M, class T, class E>
std::size_t num_edges(const Intrinsic_triangulation<M, T, E>& t)
{
  return static_cast<std::size_t>(t.number_of_edges());
}

template <class M, class T, class E>
Iterator_range<internal::Descriptor_iterator<Vertex_index>> vertices(const Intrinsic_triangulation<M, T, E>& t)
{
  return internal::descriptors<Vertex_index>(t.number_of_vertices());
}

template <class M, class T, class E>
Iterator_range<internal::Descriptor_iterator<Halfedge_index>> halfedges(const Intrinsic_triangulation<M, T, E>& t)
{
  return internal::descriptors<Halfedge_index>(t.number_of_halfedges());
}

template <class M, class T, class E>
Iterator_range<internal::Descriptor_iterator<Edge_index>> edges(const Intrinsic_triangulation<M, T, E>& t)
{
  return internal::descriptors<Edge_index>(t.number_of_edges());
}

template <class M, class T, class E>
Iterator_range<internal::Face_iterator<Intrinsic_triangulation<M, T, E>>> faces(
    const Intrinsic_triangulation<M, T, E>& t)
{
  using Iterator = internal::Face_iterator<Intrinsic_triangulation<M, T, E>>;
  return {Iterator(t, Halfedge_index(0)), Iterator(t, Halfedge_index(t.number_of_halfedges()))};
}

template <class M, class T, class E>
std::size_t num_faces(const Intrinsic_triangulation<M, T, E>& t)
{
  const auto all = faces(t);
  return static_cast<std::size_t>(std::distance(all.begin(), all.end()));
}

// ---------------------------------------------------------------- incidence

template <class M, class T, class E>
Vertex_index source(Halfedge_index h, const Intrinsic_triangulation<M, T, E>& t)
{
  return t.tail(h);
}

template <class M, class T, class E>
Vertex_index target(Halfedge_index h, const Intrinsic_triangulation<M, T, E>& t)
{
  return t.head(h);
}

template <class M, class T, class E>
Vertex_index source(Edge_index e, const Intrinsic_triangulation<M, T, E>& t)
{
  return t.tail(e.halfedge());
}

template <class M, class T, class E>
Vertex_index target(Edge_index e, const Intrinsic_triangulation<M, T, E>& t)
{
  return t.head(e.halfedge());
}

template <class M, class T, class E>
Halfedge_index opposite(Halfedge_index h, const Intrinsic_triangulation<M, T, E>&)
{
  return internal::twin_index(h);
}

template <class M, class T, class E>
Halfedge_index next(Halfedge_index h, const Intrinsic_triangulation<M, T, E>& t)
{
  if(!t.is_border(h))
    return t.next(h);
  if(!t.is_inserted(t.head(h))) // the border leads to the next umbrella, if there are several
    return internal::first_outgoing_halfedge(t, t.input().next(t.edge_sequence(h).along));
  Halfedge_index along_border = internal::twin_index(h);
  while(!t.is_border(along_border))
    along_border = t.counterclockwise(along_border);
  return along_border;
}

template <class M, class T, class E>
Halfedge_index prev(Halfedge_index h, const Intrinsic_triangulation<M, T, E>& t)
{
  if(!t.is_border(h))
    return t.previous(h);
  Halfedge_index last = h;
  if(!t.is_inserted(t.tail(h))) // the border comes from the previous umbrella, if there are several
    last = internal::first_outgoing_halfedge(t, internal::previous_umbrella(t.input(), t.edge_sequence(h).along));
  for(Halfedge_index g = last; g != null_index; g = t.clockwise(g))
    last = g;
  return internal::twin_index(last);
}

template <class M, class T, class E>
Face_index face(Halfedge_index h, const Intrinsic_triangulation<M, T, E>& t)
{
  if(t.is_border(h))
    return {};
  return Face_index(internal::least_in_face(t, h).idx());
}

template <class M, class T, class E>
Edge_index edge(Halfedge_index h, const Intrinsic_triangulation<M, T, E>&)
{
  return Edge_index(h);
}

template <class M, class T, class E>
Halfedge_index halfedge(Edge_index e, const Intrinsic_triangulation<M, T, E>&)
{
  return e.halfedge();
}

template <class M, class T, class E>
Halfedge_index halfedge(Face_index f, const Intrinsic_triangulation<M, T, E>&)
{
  return Halfedge_index(f.idx());
}

// Returns a halfedge whose target is `v`, or the null halfedge if `v` is isolated.
template <class M, class T, class E>
Halfedge_index halfedge(Vertex_index v, const Intrinsic_triangulation<M, T, E>& t)
{
  const Halfedge_index h = t.outgoing(v);
  return h == null_index ? h : internal::twin_index(h);
}

// Returns the halfedge with the smallest number among those from `u` to `v`, and whether one exists.
template <class M, class T, class E>
std::pair<Halfedge_index, bool> halfedge(Vertex_index u, Vertex_index v, const Intrinsic_triangulation<M, T, E>& t)
{
  Halfedge_index result;
  for(Edge_index e : CGAL::make_range(out_edges(u, t)))
    if(t.head(e.halfedge()) == v && (result == null_index || e.halfedge() < result))
      result = e.halfedge();
  return {result, result != null_index};
}

// Returns the edge of the halfedge with the smallest number among those from `u` to `v`, and whether one exists.
template <class M, class T, class E>
std::pair<Edge_index, bool> edge(Vertex_index u, Vertex_index v, const Intrinsic_triangulation<M, T, E>& t)
{
  const auto [h, exists] = halfedge(u, v, t);
  return {Edge_index(h), exists};
}

// ---------------------------------------------------------------- around a vertex

template <class M, class T, class E>
Iterator_range<CGAL::Out_edge_iterator<Intrinsic_triangulation<M, T, E>>> out_edges(
    Vertex_index v, const Intrinsic_triangulation<M, T, E>& t)
{
  using Iterator = CGAL::Out_edge_iterator<Intrinsic_triangulation<M, T, E>>;
  const Halfedge_index h = halfedge(v, t);
  return {Iterator(h, t), Iterator(h, t, 1)};
}

template <class M, class T, class E>
Iterator_range<CGAL::In_edge_iterator<Intrinsic_triangulation<M, T, E>>> in_edges(
    Vertex_index v, const Intrinsic_triangulation<M, T, E>& t)
{
  using Iterator = CGAL::In_edge_iterator<Intrinsic_triangulation<M, T, E>>;
  const Halfedge_index h = halfedge(v, t);
  return {Iterator(h, t), Iterator(h, t, 1)};
}

template <class M, class T, class E>
Iterator_range<CGAL::Vertex_around_target_iterator<Intrinsic_triangulation<M, T, E>>> adjacent_vertices(
    Vertex_index v, const Intrinsic_triangulation<M, T, E>& t)
{
  return CGAL::vertices_around_target(halfedge(v, t), t);
}

template <class M, class T, class E>
std::size_t degree(Vertex_index v, const Intrinsic_triangulation<M, T, E>& t)
{
  const auto around = out_edges(v, t);
  return static_cast<std::size_t>(std::distance(around.begin(), around.end()));
}

template <class M, class T, class E>
std::size_t out_degree(Vertex_index v, const Intrinsic_triangulation<M, T, E>& t)
{
  return degree(v, t);
}

template <class M, class T, class E>
std::size_t in_degree(Vertex_index v, const Intrinsic_triangulation<M, T, E>& t)
{
  return degree(v, t);
}

template <class M, class T, class E>
std::size_t degree(Face_index, const Intrinsic_triangulation<M, T, E>&)
{
  return 3;
}

// ---------------------------------------------------------------- properties

template <class M, class T, class E>
internal::Descriptor_index_map<Vertex_index> get(boost::vertex_index_t, const Intrinsic_triangulation<M, T, E>&)
{
  return {};
}

template <class M, class T, class E>
internal::Descriptor_index_map<Halfedge_index> get(boost::halfedge_index_t, const Intrinsic_triangulation<M, T, E>&)
{
  return {};
}

template <class M, class T, class E>
internal::Descriptor_index_map<Edge_index> get(boost::edge_index_t, const Intrinsic_triangulation<M, T, E>&)
{
  return {};
}

// Takes linear time; the map is valid until the next flip or insertion.
template <class M, class T, class E>
internal::Face_index_map get(boost::face_index_t, const Intrinsic_triangulation<M, T, E>& t)
{
  return internal::Face_index_map(t);
}

template <class M, class T, class E>
internal::Edge_length_map<Intrinsic_triangulation<M, T, E>> get(boost::edge_weight_t,
                                                                const Intrinsic_triangulation<M, T, E>& t)
{
  return {&t};
}

template <class M, class T, class E>
internal::Intrinsic_point_map<Intrinsic_triangulation<M, T, E>> get(CGAL::vertex_point_t,
                                                                    const Intrinsic_triangulation<M, T, E>& t)
{
  return {&t};
}

template <class Property, class M, class T, class E, class Key>
auto get(Property property, const Intrinsic_triangulation<M, T, E>& t, const Key& key)
    -> decltype(get(get(property, t), key))
{
  return get(get(property, t), key);
}

} // namespace Flip_geodesics

template <class M, class T, class E>
struct graph_has_property<Flip_geodesics::Intrinsic_triangulation<M, T, E>, boost::vertex_index_t> : CGAL::Tag_true
{
};

template <class M, class T, class E>
struct graph_has_property<Flip_geodesics::Intrinsic_triangulation<M, T, E>, boost::halfedge_index_t> : CGAL::Tag_true
{
};

template <class M, class T, class E>
struct graph_has_property<Flip_geodesics::Intrinsic_triangulation<M, T, E>, boost::edge_index_t> : CGAL::Tag_true
{
};

template <class M, class T, class E>
struct graph_has_property<Flip_geodesics::Intrinsic_triangulation<M, T, E>, boost::face_index_t> : CGAL::Tag_true
{
};

template <class M, class T, class E>
struct graph_has_property<Flip_geodesics::Intrinsic_triangulation<M, T, E>, boost::edge_weight_t> : CGAL::Tag_true
{
};

template <class M, class T, class E>
struct graph_has_property<Flip_geodesics::Intrinsic_triangulation<M, T, E>, CGAL::vertex_point_t>
  : CGAL::Boolean_tag<Flip_geodesics::internal::Has_points<E>::value>
{
};

} // namespace CGAL

namespace boost {

template <class M, class T, class E>
struct property_map<CGAL::Flip_geodesics::Intrinsic_triangulation<M, T, E>, vertex_index_t>
{
  using type = CGAL::Flip_geodesics::internal::Descriptor_index_map<CGAL::Flip_geodesics::Vertex_index>;
  using const_type = type;
};

template <class M, class T, class E>
struct property_map<CGAL::Flip_geodesics::Intrinsic_triangulation<M, T, E>, halfedge_index_t>
{
  using type = CGAL::Flip_geodesics::internal::Descriptor_index_map<CGAL::Flip_geodesics::Halfedge_index>;
  using const_type = type;
};

template <class M, class T, class E>
struct property_map<CGAL::Flip_geodesics::Intrinsic_triangulation<M, T, E>, edge_index_t>
{
  using type = CGAL::Flip_geodesics::internal::Descriptor_index_map<CGAL::Flip_geodesics::Edge_index>;
  using const_type = type;
};

template <class M, class T, class E>
struct property_map<CGAL::Flip_geodesics::Intrinsic_triangulation<M, T, E>, face_index_t>
{
  using type = CGAL::Flip_geodesics::internal::Face_index_map;
  using const_type = type;
};

template <class M, class T, class E>
struct property_map<CGAL::Flip_geodesics::Intrinsic_triangulation<M, T, E>, edge_weight_t>
{
  using type = CGAL::Flip_geodesics::internal::Edge_length_map<CGAL::Flip_geodesics::Intrinsic_triangulation<M, T, E>>;
  using const_type = type;
};

template <class M, class T, class E>
struct property_map<CGAL::Flip_geodesics::Intrinsic_triangulation<M, T, E>, CGAL::vertex_point_t>
{
  using type =
      CGAL::Flip_geodesics::internal::Intrinsic_point_map<CGAL::Flip_geodesics::Intrinsic_triangulation<M, T, E>>;
  using const_type = type;
};

} // namespace boost

#endif // DOXYGEN_RUNNING

#endif // CGAL_FLIP_GEODESICS_GRAPH_TRAITS_H
