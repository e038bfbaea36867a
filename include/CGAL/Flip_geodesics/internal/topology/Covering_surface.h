// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_SURFACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_SURFACE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/Numbered_surface.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>
#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* A lift from which a search continues, with lower bounds for the paths from the source to it, and of those to the
 * target by way of it. */
struct Open_lift
{
  Index lift;
  double distance, total;
};

/*
 * Shortest edge paths from one vertex to another in homotopy classes, in order of length: a search in the universal
 * cover of the surface, whose vertices are the *lifts* of each vertex, that is, the classes of paths from the source to
 * it. They are created when they are reached.
 *
 * Lifts are settled in the order of a lower bound for the edge paths to the target by way of them. The remaining path
 * is not shorter than a shortest one of any class, so the search is directed and never reaches a settled lift on a
 * shorter path.
 *
 * Afterwards the search continues where paths that do not follow edges and are shorter than these may pass. On a rough
 * mesh, edge paths are several times as long, and there are far more classes of edge paths up to that length than
 * required.
 */
template <class Triangulation>
class Covering_search
{
public:
  /* \throws Vertex_out_of_range_error, Disconnected_endpoints_error, Invalid_mesh_error, Invalid_coordinate_error,
   * Interrupted. `run_to_targets()` also throws Degenerate_face_error if it encounters a zero-length edge. */
  Covering_search(const Triangulation& triangulation, Vertex_index source, Vertex_index target,
                  Interruption& interruption)
    : m_triangulation(triangulation)
    , m_interruption(interruption)
    , m_target(target)
    , m_forest(checked_input(triangulation, source, target), std::vector<Vertex_index>(1, target), weight(),
               &interruption)
    , m_words(words(m_forest.component(target)))
  {
    if(m_forest.component(source) != m_forest.component(target))
      throw_disconnected(source, target);
    m_lifts[lift(source, 0)].distance = 0;
    m_queue.push(m_forest.distance(source), Vertex_index(0));
  }

  /* Continues until `number` lifts of the target are settled, there are more than `most_lifts` in total, or it is
   * interrupted. */
  void run_to_targets(std::size_t number, std::size_t most_lifts)
  {
    while(m_targets.size() < number && !m_queue.empty() && number_of_lifts() <= most_lifts &&
          !m_interruption.count_step())
      if(const Index l = m_queue.pop().idx(); !is_settled(l)) // otherwise it has been moved forward
        settle(l);
  }

  /*
   * Continues from unsettled lifts, beginning with those by way of which paths to the target seem shortest, as long as
   * these are not longer than `bound`. At least half as many additional lifts are settled, so that few such calls are
   * necessary; at most as many again, since a larger part may reveal shorter paths and thus a smaller bound.
   *
   * \param to_target lower bound on the length of a path from a vertex to the target
   */
  template <class LowerBound>
  void run_from(const std::vector<Open_lift>& starts, const LowerBound& to_target, double bound, std::size_t most_lifts)
  {
    const std::size_t enough = m_number_of_settled + m_number_of_settled / 2 + 16;
    const std::size_t most = 2 * m_number_of_settled + 64;
    std::unordered_map<Index, double> distance;
    Vertex_queue queue;
    const auto open = [&](const Open_lift& next) {
      const auto [place, is_new] = distance.emplace(next.lift, next.distance);
      if(is_settled(next.lift) || (!is_new && place->second <= next.distance))
        return;
      place->second = next.distance;
      queue.push(next.total, Vertex_index(next.lift));
    };
    for(const Open_lift& start : starts)
      open(start);
    const auto is_to_go_on = [&] {
      return queue.priority() <= bound ? m_number_of_settled < most : m_number_of_settled < enough;
    };
    while(!queue.empty() && is_to_go_on() && number_of_lifts() <= most_lifts && !m_interruption.count_step()) {
      const Index l = queue.pop().idx();
      if(is_settled(l))
        continue;
      settle(l);
      const double here = distance.find(l)->second;
      for_each_neighbor(l, [&](Index to, Input_halfedge_index h) {
        const double there = here + weight()(h);
        open({to, there, there + to_target(vertex(to))});
      });
    }
  }

  /* Makes the paths shortest ones among settled lifts, even if these were not settled in order. */
  void shorten_paths()
  {
    m_queue.clear();
    for(Index l = 0; l < static_cast<Index>(m_lifts.size()); ++l)
      if(is_settled(l))
        shorten_paths_over(l);
    while(!m_queue.empty())
      shorten_paths_over(m_queue.pop().idx());
  }

  /* Returns whether the whole covering has been searched. */
  bool is_exhausted() const { return m_number_of_settled == m_lifts.size(); }

  std::size_t number_of_lifts() const { return m_lifts.size(); }
  /* Returns the settled lifts of the target, those of `run_to_targets()` first and by distance. The source is lift
   * 0. */
  const std::vector<Index>& targets() const { return m_targets; }

  Vertex_index vertex(Index lift) const { return at(lift).vertex; }
  double distance(Index lift) const { return at(lift).distance; }
  bool is_settled(Index lift) const { return at(lift).neighbors != none; }
  /* Returns the lift to which halfedge `i` leads, counted clockwise from `outgoing()` at a settled lift's vertex. */
  Index neighbor(Index lift, std::size_t i) const { return m_neighbors[at(lift).neighbors + i]; }

  /* Returns the shortest edge path to a lift. */
  std::vector<Input_halfedge_index> path(Index lift) const
  {
    std::vector<Input_halfedge_index> result;
    for(; at(lift).incoming != null_index; lift = at(lift).previous)
      result.push_back(at(lift).incoming);
    std::reverse(result.begin(), result.end());
    return result;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  using Key = std::pair<Vertex_index, std::uint64_t>; // of a word

  struct Lift
  {
    Vertex_index vertex;
    Index older; // the one created before with the same vertex and key, -1 if there is none
    Path_words::Word word;
    double distance = std::numeric_limits<double>::infinity();
    Index previous = -1; // on the shortest path, with the edge from there
    Input_halfedge_index incoming = null_index;
    std::size_t neighbors = none; // the position of the first one, once it is settled
  };

  static const auto& checked_input(const Triangulation& triangulation, Vertex_index source, Vertex_index target)
  {
    const auto& input = triangulation.input();
    check_vertex(source, input.number_of_vertices(), "the source");
    check_vertex(target, input.number_of_vertices(), "the target");
    check_surface(input);
    if(input.outgoing(source) == null_index || input.outgoing(target) == null_index)
      throw_disconnected(source, target);
    return input;
  }

  const auto& input() const { return m_triangulation.input(); }
  Metric_weight<Triangulation> weight() const { return Metric_weight<Triangulation>{m_triangulation}; }
  const Lift& at(Index lift) const { return m_lifts[static_cast<std::size_t>(lift)]; }

  template <class Function>
  void for_each_neighbor(Index l, const Function& function) const
  {
    std::size_t i = 0;
    for_each_outgoing_halfedge(input(), vertex(l), [&](Input_halfedge_index h) { function(neighbor(l, i++), h); });
  }

  void shorten_paths_over(Index l)
  {
    for_each_neighbor(l, [&](Index to, Input_halfedge_index h) {
      Lift& head = m_lifts[static_cast<std::size_t>(to)];
      const double length = distance(l) + weight()(h);
      if(!(length < head.distance))
        return;
      head.distance = length;
      head.previous = l;
      head.incoming = h;
      if(is_settled(to))
        m_queue.push(length, Vertex_index(to));
    });
  }

  Path_words words(Index component) const
  {
    const Cotree cotree(input(), m_forest, Borders::CLOSED_BY_ONE_FACE, weight(), &m_interruption);
    Generator_words words(input(), m_forest, cotree, &m_interruption);
    const std::vector<Letter> relation = words.relation(component);
    return {std::move(words), relation};
  }

  // The lift of a vertex to which a path with the given word leads.
  std::size_t lift(Vertex_index v, Path_words::Word word)
  {
    const auto [place, is_new] = m_newest.emplace(Key{v, m_words.key(word)}, -1);
    for(Index l = place->second; l >= 0; l = at(l).older)
      if(m_words.are_homotopic(word, at(l).word))
        return static_cast<std::size_t>(l);
    m_lifts.push_back({v, place->second, word});
    place->second = checked_index_bound(m_lifts.size()) - 1;
    return m_lifts.size() - 1;
  }

  void settle(Index l)
  {
    ++m_number_of_settled;
    m_lifts[static_cast<std::size_t>(l)].neighbors = m_neighbors.size();
    const Lift from = at(l);
    if(from.vertex == m_target)
      m_targets.push_back(l);
    for_each_outgoing_halfedge(input(), from.vertex, [&](Input_halfedge_index h) {
      const std::size_t to = lift(input().tail(twin_index(h)), m_words.continued(from.word, h));
      m_neighbors.push_back(static_cast<Index>(to));
      // Degenerate edges are not allowed: they would lead to infinitely many classes.
      const double distance = from.distance + m_triangulation.metric().length(input(), h);
      if(distance < m_lifts[to].distance && m_lifts[to].neighbors == none) {
        m_lifts[to].distance = distance;
        m_lifts[to].previous = l;
        m_lifts[to].incoming = h;
        m_queue.push(distance + m_forest.distance(m_lifts[to].vertex), Vertex_index(static_cast<Index>(to)));
      }
    });
  }

  const Triangulation& m_triangulation;
  Interruption& m_interruption;
  Vertex_index m_target;
  Edge_forest m_forest; // from the target
  Path_words m_words;
  std::vector<Lift> m_lifts;
  std::size_t m_number_of_settled = 0;
  boost::unordered_map<Key, Index> m_newest; // the newest lift of a vertex whose word has a given key
  std::vector<Index> m_neighbors;
  std::vector<Index> m_targets;
  Vertex_queue m_queue; // of lifts
};

/*
 * A part of the universal cover of a surface: all faces around the lifts that a search has settled. In it all paths
 * between two vertices are homotopic, so that the shortest of them is the shortest of a class on the original surface.
 *
 * The part has an additional border, the *frontier*, beyond which the covering continues. Both ends of its edges are
 * lifts that are not settled. Such a lift has a vertex for each row of faces that contains it.
 *
 * The first side of an edge lies over the first side of the edge below.
 */
template <class TriangleMesh>
class Covering_surface
{
public:
  using Below = Indexed_mesh<TriangleMesh>;

  /* The mesh and its indices must outlive this object. */
  template <class Search>
  Covering_surface(const TriangleMesh& mesh, const Below& below, const Search& search)
    : m_mesh(&mesh)
    , m_below(&below)
    , m_vertex(search.number_of_lifts(), null_index)
  {
    for(Index lift = 0; lift < static_cast<Index>(search.number_of_lifts()); ++lift)
      if(search.is_settled(lift))
        add_faces(search, lift);
    m_edges.clear();
    link_border();
    number_vertices(search);
  }

  const TriangleMesh& mesh() const { return *m_mesh; }
  const Below& below() const { return *m_below; }

  Index number_of_vertices() const { return static_cast<Index>(m_outgoing.size()); }
  Index number_of_halfedges() const { return static_cast<Index>(m_next.size()); }
  /* Takes linear time. */
  Index number_of_faces() const
  {
    const auto borders = std::count(m_is_border.begin(), m_is_border.end(), char(1));
    return (number_of_halfedges() - static_cast<Index>(borders)) / 3;
  }
  Input_halfedge_index next(Input_halfedge_index h) const { return m_next[h]; }
  Input_halfedge_index previous(Input_halfedge_index h) const { return m_previous[h]; }
  Vertex_index tail(Input_halfedge_index h) const { return m_tail[h]; }
  bool is_border(Input_halfedge_index h) const { return m_is_border[h] != 0; }
  Input_halfedge_index outgoing(Vertex_index v) const { return m_outgoing[v]; }

  /* Returns the halfedge below. */
  Input_halfedge_index below(Input_halfedge_index h) const
  {
    return Input_halfedge_index(2 * m_edge_below[static_cast<std::size_t>(h.idx() / 2)] + h.idx() % 2);
  }
  Vertex_index below(Vertex_index v) const { return m_below->tail(below(m_outgoing[v])); }

  /* Returns the lift at which a halfedge starts. */
  Index lift(Input_halfedge_index h) const { return m_tail_lift[h]; }
  /* Returns the vertex of a settled lift. */
  Vertex_index vertex(Index lift) const { return m_vertex[static_cast<std::size_t>(lift)]; }
  /* Returns whether a halfedge has no face here, although the one below has. */
  bool is_frontier(Input_halfedge_index h) const { return is_border(h) && !m_below->is_border(below(h)); }

private:
  template <class Search>
  void add_faces(const Search& search, Index lift)
  {
    std::vector<Input_halfedge_index> outgoing_halfedges;
    for_each_outgoing_halfedge(*m_below, search.vertex(lift),
                               [&](Input_halfedge_index h) { outgoing_halfedges.push_back(h); });
    // The face on the left of an outgoing halfedge lies between it and the previous one.
    const auto is_before = [&](Index l) { return l < lift && search.is_settled(l); };
    for(std::size_t i = 0; i < outgoing_halfedges.size(); ++i) {
      const Index a = search.neighbor(lift, i), b = search.neighbor(lift, (i == 0 ? outgoing_halfedges.size() : i) - 1);
      if(!m_below->is_border(outgoing_halfedges[i]) && !is_before(a) && !is_before(b))
        add_face(outgoing_halfedges[i], lift, a, b);
    }
  }

  // Adds the face over that on the left of h; its corners, starting with the tail of h, are three lifts.
  void add_face(Input_halfedge_index h, Index lift, Index a, Index b)
  {
    const Input_halfedge_index side = add_side(h, lift, a), side_next = add_side(m_below->next(h), a, b),
                               side_previous = add_side(m_below->previous(h), b, lift);
    link(side, side_next);
    link(side_next, side_previous);
    link(side_previous, side);
    m_is_border[side] = m_is_border[side_next] = m_is_border[side_previous] = 0;
  }

  // Returns the halfedge over h from one lift to another.
  Input_halfedge_index add_side(Input_halfedge_index h, Index from, Index to)
  {
    const std::uint64_t edge = static_cast<std::uint64_t>(h.idx() / 2);
    const std::uint64_t start = static_cast<std::uint64_t>(is_first_side(h) ? from : to);
    const auto [place, is_new] = m_edges.emplace(start << 32 | edge, m_edge_below.size());
    if(is_new) {
      m_edge_below.push_back(h.idx() / 2);
      for(std::size_t i = 0; i < 2; ++i) {
        m_next.push_back(null_index);
        m_previous.push_back(null_index);
        m_is_border.push_back(1);
        m_tail_lift.push_back(is_first_side(h) == (i == 0) ? from : to);
      }
    }
    return Input_halfedge_index(2 * checked_index_bound(place->second) + h.idx() % 2);
  }

  void link(Input_halfedge_index h, Input_halfedge_index next)
  {
    m_next[h] = next;
    m_previous[next] = h;
  }

  // Border halfedges are consecutive around the row of faces at a vertex.
  void link_border()
  {
    checked_index_bound(m_next.size());
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(number_of_halfedges()))
      if(is_border(h)) {
        Input_halfedge_index g = twin_index(h);
        while(!is_border(g))
          g = twin_index(m_previous[g]);
        link(h, g);
      }
  }

  template <class Search>
  void number_vertices(const Search& search)
  {
    m_tail.assign(m_next.size(), null_index);
    for(Input_halfedge_index first : descriptors<Input_halfedge_index>(number_of_halfedges())) {
      if(m_tail[first] != null_index)
        continue;
      const Vertex_index v(number_of_vertices());
      m_outgoing.push_back(first);
      if(search.is_settled(m_tail_lift[first]))
        m_vertex[static_cast<std::size_t>(m_tail_lift[first])] = v;
      for_each_outgoing_halfedge(*this, v, [&](Input_halfedge_index h) { m_tail[h] = v; });
    }
  }

  const TriangleMesh* m_mesh;
  const Below* m_below;
  std::unordered_map<std::uint64_t, std::size_t>
      m_edges; // by the lift at which the first side starts and the halfedge below
  std::vector<Index> m_edge_below;
  Indexed_by<Input_halfedge_index, std::vector<Input_halfedge_index>> m_next, m_previous;
  Indexed_by<Input_halfedge_index, std::vector<char>> m_is_border;
  Indexed_by<Input_halfedge_index, std::vector<Index>> m_tail_lift;
  Indexed_by<Input_halfedge_index, std::vector<Vertex_index>> m_tail;
  Indexed_by<Vertex_index, std::vector<Input_halfedge_index>> m_outgoing;
  std::vector<Vertex_index> m_vertex; // by lift
};

/* The data of the faces of a graph that a curve point requires. */
template <class TriangleMesh>
Numbered_face face(Input_halfedge_index h, const Covering_surface<TriangleMesh>& surface)
{
  const auto& below = surface.below();
  const auto f = graph_face(below.halfedge(surface.below(h)), surface.mesh());
  const Input_halfedge_index first = below.index(graph_halfedge(f, surface.mesh()));
  while(surface.below(h) != first)
    h = surface.next(h);
  return {h};
}

/* A covering surface is numbered already, and is its own mesh. */
template <class TriangleMesh>
class Indexed_mesh<Covering_surface<TriangleMesh>> : public Numbered_surface<Covering_surface<TriangleMesh>>
{
public:
  using Numbered_surface<Covering_surface<TriangleMesh>>::Numbered_surface;
};

} // namespace CGAL::Flip_geodesics::internal

namespace boost {

template <class TriangleMesh>
struct graph_traits<CGAL::Flip_geodesics::internal::Covering_surface<TriangleMesh>>
  : CGAL::Flip_geodesics::internal::Numbered_surface_traits
{
};

} // namespace boost

namespace CGAL::Flip_geodesics::internal {

/* The metric of a covering surface, which is that of the surface below. A model of IntrinsicMetric. */
template <class TriangleMesh, class Metric>
class Covering_metric
{
public:
  using Mesh = Numbered_mesh<Covering_surface<TriangleMesh>>;
  using Kernel = typename Metric::Kernel;
  using Point_3 = typename Metric_point<Metric>::type;
  using Place = typename Metric::Place;

  explicit Covering_metric(const Metric& metric)
    : m_metric(metric)
    , m_flat_edges(std::make_shared<Flat_edges>())
  {
  }

  decltype(auto) point(const Mesh& mesh, Vertex_index v) const
  {
    return m_metric.point(below(mesh), mesh.surface().below(v));
  }

  std::array<double, 3> vector(const Mesh& mesh, Vertex_index v, Vertex_index w) const
  {
    return Internals<Metric>::vector(m_metric, below(mesh), mesh.surface().below(v), mesh.surface().below(w));
  }

  double length(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_metric.length(below(mesh), mesh.surface().below(h));
  }
  double weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_metric.weight(below(mesh), mesh.surface().below(h));
  }
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const
  {
    return m_metric.weight(below(mesh), mesh.surface().below(h), tail, head);
  }

  Place place(const Mesh& mesh, Vertex_index v) const { return m_metric.place(below(mesh), mesh.surface().below(v)); }
  double distance_lower_bound(const Place& p, const Place& q) const { return m_metric.distance_lower_bound(p, q); }

  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    return internal::face_geometry(m_metric, below(mesh), mesh.surface().below(h), traits);
  }

  bool is_rounded(const Mesh& mesh) const { return is_rounded_metric(m_metric, below(mesh)); }
  bool is_usable_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    return internal::is_usable_face(m_metric, below(mesh), mesh.surface().below(h));
  }

  Exact_face exact_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    return internal::exact_face(m_metric, below(mesh), mesh.surface().below(h));
  }

  /* The results for flat edges are stored for the edges below. */
  bool sine_in_plane(const Mesh& mesh, const Edge_sequence& a, const Edge_sequence& b, Index steps, Flat_edges&,
                     Sign& sine) const
  {
    if(m_flat_edges->size() == 0)
      *m_flat_edges = Flat_edges(static_cast<std::size_t>(below(mesh).number_of_halfedges() / 2));
    return internal::sine_in_plane(m_metric, below(mesh), below(mesh, a), below(mesh, b), steps, *m_flat_edges, sine);
  }

private:
  static const Numbered_mesh<TriangleMesh>& below(const Mesh& mesh) { return mesh.surface().below(); }

  static Edge_sequence below(const Mesh& mesh, Edge_sequence word)
  {
    const auto project = [&mesh](auto& element) {
      if(element != null_index)
        element = mesh.surface().below(element);
    };
    project(word.along);
    project(word.face);
    project(word.tail);
    project(word.head);
    for(Input_halfedge_index& h : word.crossed)
      project(h);
    return word;
  }

  Metric m_metric;
  std::shared_ptr<Flat_edges> m_flat_edges;
};

template <class TriangleMesh, class Metric>
struct Internals<Covering_metric<TriangleMesh, Metric>> : Internals_of_members<Covering_metric<TriangleMesh, Metric>>
{
  static constexpr bool has_exact_faces = internal::has_exact_faces<Metric>;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_SURFACE_H
