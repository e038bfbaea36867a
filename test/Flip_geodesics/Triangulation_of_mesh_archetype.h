// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_TRIANGULATION_OF_MESH_ARCHETYPE_H
#define FLIP_GEODESICS_TEST_TRIANGULATION_OF_MESH_ARCHETYPE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Surface_point.h>

#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <utility>

namespace Flip_geodesics_test {

/*
 * A model of `IntrinsicTriangulationOfMesh` that has nothing but what its page and that of `IntrinsicTriangulation` ask
 * for. It holds another model, to which it forwards.
 */
template <class Model>
class Triangulation_of_mesh_archetype
{
  using Index = CGAL::Flip_geodesics::Index;
  using Vertex_index = CGAL::Flip_geodesics::Vertex_index;
  using Halfedge_index = CGAL::Flip_geodesics::Halfedge_index;
  using Edge_index = CGAL::Flip_geodesics::Edge_index;
  using Location = CGAL::Flip_geodesics::Surface_location;

public:
  using Traits = typename Model::Traits;
  using Turn = typename Traits::Turn;
  using Log_position = typename Model::Log_position;
  using Triangle_mesh = typename Model::Triangle_mesh;
  using Metric = typename Model::Metric;

  class Walker
  {
    using Model_walker = typename Model::Walker;

  public:
    using Place = typename Model_walker::Place;

    Halfedge_index index() const { return m_walker.index(); }
    Place place() const { return m_walker.place(); }
    bool is_none() const { return m_walker.is_none(); }
    bool operator==(const Walker& other) const { return m_walker == other.m_walker; }
    bool operator!=(const Walker& other) const { return m_walker != other.m_walker; }

    Vertex_index tail() const { return m_walker.tail(); }
    Walker twin() const { return Walker(m_walker.twin()); }
    Walker previous() const { return Walker(m_walker.previous()); }
    Walker clockwise() const { return Walker(m_walker.clockwise()); }
    Walker counterclockwise() const { return Walker(m_walker.counterclockwise()); }

    double length() const { return m_walker.length(); }
    void prefetch_face() const { m_walker.prefetch_face(); }
    Walker extend_turn_clockwise(Turn& turn) const { return Walker(m_walker.extend_turn_clockwise(turn)); }

    std::size_t edge_place() const { return m_walker.edge_place(); }
    bool is_held() const { return m_walker.is_held(); }
    void hold() const { m_walker.hold(); }
    void release() const { m_walker.release(); }

  private:
    friend class Triangulation_of_mesh_archetype;
    explicit Walker(const Model_walker& walker)
      : m_walker(walker)
    {
    }

    Model_walker m_walker;
  };

  class Flip_record
  {
  public:
    bool is_flip() const { return m_is_flip; }
    bool is_insertion() const { return m_is_insertion; }
    bool is_on_edge() const { return m_is_on_edge; }
    Index gap() const { return m_gap; }

    Halfedge_index h;
    Index number;

  private:
    friend class Triangulation_of_mesh_archetype;
    explicit Flip_record(const typename Model::Flip_record& record)
      : h(record.h)
      , number(record.number)
      , m_is_flip(record.is_flip())
      , m_is_insertion(record.is_insertion())
      , m_is_on_edge(record.is_on_edge())
      , m_gap(record.gap())
    {
    }

    bool m_is_flip, m_is_insertion, m_is_on_edge;
    Index m_gap;
  };

  explicit Triangulation_of_mesh_archetype(const Triangle_mesh& mesh)
    : m_model(mesh, Metric(get(CGAL::vertex_point, mesh)))
  {
  }

  Index number_of_vertices() const { return m_model.number_of_vertices(); }
  Index number_of_halfedges() const { return m_model.number_of_halfedges(); }
  Index number_of_edges() const { return m_model.number_of_edges(); }

  static Halfedge_index twin(Halfedge_index h) { return Model::twin(h); }
  static Edge_index edge(Halfedge_index h) { return Model::edge(h); }
  Halfedge_index next(Halfedge_index h) const { return m_model.next(h); }
  Halfedge_index previous(Halfedge_index h) const { return m_model.previous(h); }
  Vertex_index tail(Halfedge_index h) const { return m_model.tail(h); }
  Vertex_index head(Halfedge_index h) const { return m_model.head(h); }
  bool is_border(Halfedge_index h) const { return m_model.is_border(h); }
  Halfedge_index clockwise(Halfedge_index h) const { return m_model.clockwise(h); }
  Halfedge_index counterclockwise(Halfedge_index h) const { return m_model.counterclockwise(h); }
  Halfedge_index outgoing(Vertex_index v) const { return m_model.outgoing(v); }
  void prefetch_face(Halfedge_index h) const { m_model.prefetch_face(h); }

  const Traits& traits() const { return m_model.traits(); }
  double length(Halfedge_index h) const { return m_model.length(h); }
  Halfedge_index extend_turn_clockwise(Turn& turn, Halfedge_index h) const
  {
    return m_model.extend_turn_clockwise(turn, h);
  }
  bool is_straight(const Turn& turn, Halfedge_index from, Halfedge_index to) const
  {
    return m_model.is_straight(turn, from, to);
  }
  bool is_locally_delaunay(Halfedge_index h) const { return m_model.is_locally_delaunay(h); }

  bool is_flippable(Halfedge_index h) const { return m_model.is_flippable(h); }
  void flip(Halfedge_index h) { m_model.flip(h); }
  Log_position log_position() const { return m_model.log_position(); }
  void rollback(Log_position position) { m_model.rollback(position); }
  std::size_t memory_of_records() const { return m_model.memory_of_records(); }

  Index holds(Edge_index e) const { return m_model.holds(e); }
  void hold(Edge_index e) { m_model.hold(e); }
  void release(Edge_index e) { m_model.release(e); }
  std::size_t number_of_holds() const { return m_model.number_of_holds(); }
  std::size_t number_of_edge_places() const { return m_model.number_of_edge_places(); }

  Walker walker(Halfedge_index h) const { return Walker(m_model.walker(h)); }
  Walker walker(typename Walker::Place place, Halfedge_index h) const { return Walker(m_model.walker(place, h)); }
  bool is_reflex_at_head(const Walker& h) const { return m_model.is_reflex_at_head(h.m_walker); }

  // From here on: IntrinsicTriangulationOfMesh.

  const CGAL::Flip_geodesics::Numbered_mesh<Triangle_mesh>& input() const { return m_model.input(); }
  const Metric& metric() const { return m_model.metric(); }

  bool is_inserted(Vertex_index v) const { return m_model.is_inserted(v); }
  Location location(Vertex_index v) const { return m_model.location(v); }
  Index crossings(Edge_index e) const { return m_model.crossings(e); }
  CGAL::Flip_geodesics::Edge_sequence edge_sequence(Halfedge_index h) const { return m_model.edge_sequence(h); }
  Index input_edges_in_wedge(Halfedge_index from, Halfedge_index to) const
  {
    return m_model.input_edges_in_wedge(from, to);
  }

  template <class OnSplit>
  Vertex_index insert(const Location& location, const OnSplit& on_split)
  {
    return m_model.insert(location, on_split);
  }
  template <class OnSplit>
  Vertex_index split_edge(Halfedge_index h, const Location& location, std::size_t gap, const OnSplit& on_split)
  {
    return m_model.split_edge(h, location, gap, on_split);
  }
  Vertex_index split_face(Halfedge_index h, const Location& location, std::size_t gap)
  {
    return m_model.split_face(h, location, gap);
  }
  void set_face_geometry(Halfedge_index h, const typename Traits::Face_geometry& geometry)
  {
    m_model.set_face_geometry(h, geometry);
  }

  Index version(Edge_index e) const { return m_model.version(e); }
  Flip_record flip_record(Log_position i) const { return Flip_record(m_model.flip_record(i)); }

private:
  Model m_model;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_TRIANGULATION_OF_MESH_ARCHETYPE_H
