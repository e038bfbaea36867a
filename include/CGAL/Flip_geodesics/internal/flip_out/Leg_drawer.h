// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_DRAWER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_DRAWER_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Followed_arcs.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Polyline_drawer.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Segment_insertion.h>
#include <CGAL/Flip_geodesics/internal/triangulation/edges_under_curves.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Releases the edges under the curves of a network, for as long as it lives. The network is not used meanwhile, and the
 * edges are there again at the end. */
template <class Network>
class Released_edges
{
  using Triangulation = typename Network::Triangulation;

public:
  explicit Released_edges(Network& network)
    : m_triangulation(network.triangulation())
    , m_edges(edges_under_curves(network))
  {
    for(Edge_index e : m_edges)
      m_triangulation.release(e);
  }
  Released_edges(const Released_edges&) = delete;
  Released_edges& operator=(const Released_edges&) = delete;
  ~Released_edges()
  {
    for(Edge_index e : m_edges)
      m_triangulation.hold(e);
  }

private:
  Triangulation& m_triangulation;
  std::vector<Edge_index> m_edges;
};

/*
 * Makes geodesics between vertices edges of a triangulation that serves them all. Each is pulled tight by itself, as if
 * there were no other curves, from a path of edges. So it passes the ends of the others on the sides on which a geodesic
 * does, and not as the path does. A geodesic that crosses a curve of the network is left out for its path: whether the
 * curves cross, or can be pulled off each other, is up to `order_overlapping_curves()`.
 */
template <class Network>
class Leg_drawer
{
  using Triangulation = typename Network::Triangulation;
  using Chain = std::vector<Halfedge_index>;

public:
  explicit Leg_drawer(Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
    , m_arcs(m_triangulation)
  {
  }

  /* A chain along the geodesics to which the paths, one after the other, are shortened; its nodes are their ends. */
  Drawn_chain operator()(const std::vector<Chain>& paths)
  {
    std::vector<std::size_t> arcs_before_end;
    for(const Chain& path : paths) {
      for(const Followed_arc& arc : arcs_of_leg(path))
        m_arcs.add(arc);
      arcs_before_end.push_back(m_arcs.size());
    }
    Drawn_chain result;
    std::size_t arc = 0;
    for(std::size_t end : arcs_before_end) {
      if(arc == end) // a path that contracts to a point
        continue;
      for(; arc < end; ++arc)
        draw(arc, result.halfedges);
      result.nodes.push_back(result.halfedges.size() - 1);
    }
    return result;
  }

private:
  std::vector<Followed_arc> arcs_of_leg(const Chain& path)
  {
    const auto before = m_triangulation.log_position();
    Followed_arcs<Triangulation> arcs(m_triangulation);
    {
      const Released_edges<Network> released(m_network);
      const Rollback<Triangulation> at_end(m_triangulation);
      for(Halfedge_index h : shortened(path))
        arcs.add({h, {}});
      arcs.roll_back(before);
    }
    std::vector<Followed_arc> result;
    for(std::size_t i = 0; i < arcs.size() && is_free(arcs[i]); ++i)
      result.push_back(arcs[i]);
    if(result.size() == arcs.size())
      return result;
    result.clear();
    for(Halfedge_index h : path)
      result.push_back({h, {}});
    return result;
  }

  Chain shortened(const Chain& path)
  {
    if(path.empty())
      return {};
    Edge_path_network<Triangulation> network(m_triangulation);
    const Curve_index curve = network.add_curve(path, false);
    order_overlapping_curves(network);
    shorten(network);
    return network.halfedges(curve);
  }

  bool is_free(const Followed_arc& arc) const
  {
    return std::none_of(arc.crossed.begin(), arc.crossed.end(), [this](Halfedge_index h) { return is_occupied(h); });
  }

  bool is_occupied(Halfedge_index h) const
  {
    return m_triangulation.holds(Triangulation::edge(h)) > 0 || m_drawn.count(Triangulation::edge(h)) != 0;
  }

  // Arcs of a geodesic are straight, and the strip that is crossed holds the segment.
  void draw(std::size_t i, Chain& chain)
  {
    const Followed_arc arc = m_arcs[i];
    Chain edges(1, arc.along);
    if(!arc.crossed.empty()) {
      for(Halfedge_index h : arc.crossed)
        check_is_free(h);
      edges = left_side_of_strip(m_triangulation, arc.crossed);
      straighten_on_the_right(m_triangulation, edges, [this](Halfedge_index h) {
        check_is_free(h);
        m_arcs.follow(h, [&] { m_triangulation.flip(h); });
      });
    }
    for(Halfedge_index h : edges)
      m_drawn.insert(Triangulation::edge(h));
    chain.insert(chain.end(), edges.begin(), edges.end());
  }

  void check_is_free(Halfedge_index h) const
  {
    if(!is_occupied(h))
      return;
    const Vertex_index v = m_triangulation.tail(h), w = m_triangulation.head(h);
    throw Crossing_curves_error("a geodesic of a curve through points crosses a curve between vertex " +
                                    std::to_string(v.idx()) + " and vertex " + std::to_string(w.idx()),
                                {static_cast<std::size_t>(v.idx()), static_cast<std::size_t>(w.idx())});
  }

  Network& m_network;
  Triangulation& m_triangulation;
  Followed_arcs<Triangulation> m_arcs;
  std::set<Edge_index> m_drawn; // by this drawer
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_DRAWER_H
