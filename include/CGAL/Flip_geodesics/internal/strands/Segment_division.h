// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_SEGMENT_DIVISION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_SEGMENT_DIVISION_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/internal/insertion/Point_insertion.h>
#include <CGAL/Flip_geodesics/internal/strips/Wedge_angle.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Inserts points into the triangulation of a network, and divides the segments on edges that are split. */
template <class Network>
class Segment_division
{
  using Triangulation = typename Network::Triangulation;

public:
  explicit Segment_division(Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
  {
  }

  Vertex_index insert(const Surface_location& location, Known_piece* near)
  {
    const auto on_split = [this](const Edge_halves& halves) {
      move_stack(halves.first, {{halves.first, halves.second}}, null_index);
    };
    return m_triangulation.insert(location, on_split, near);
  }

  Vertex_index split_edge(Halfedge_index h, const Surface_location& location, std::size_t gap)
  {
    return m_triangulation.split_edge(h, location, gap, [this](const Edge_halves& halves) {
      move_stack(halves.first, {{halves.first, halves.second}}, null_index);
    });
  }

  /*
   * Divides segment s and those beside it; returns the first half of s. The point is rounded to a location in one of
   * the input faces that the edge crosses, and lies on the edge by definition from then on.
   *
   * An edge that was divided before and was straightened since can have the old point beside it, off by rounding: it is
   * the apex of a sliver that holds no vertex. There the segments are moved over the sliver, which is flipped away.
   *
   *       x                        x
   *    /     .                  /  |  .
   *   a ----- b      ==>       a   |   b
   *    .     /                  .  |  /
   *       d                        d
   */
  Segment_index divide(Segment_index s, double t)
  {
    for(int i = 0; i < most_slivers; ++i) {
      const Sliver sliver = sliver_beside(m_network.halfedge(s));
      if(sliver.halfedge == null_index)
        break;
      const bool is_along = sliver.halfedge == m_network.halfedge(s);
      const double at = is_along ? sliver.place : 1 - sliver.place; // of its apex, along s
      const Segment_index first = move_to_apex(sliver.halfedge, s);
      if(std::abs(t - at) <= same_place)
        return first;
      s = t < at ? first : m_network.next(first);
      t = t < at ? t / at : (t - at) / (1 - at);
    }
    const Halfedge_index h = m_network.halfedge(s);
    const Crossing_word word = m_triangulation.crossing_word(h);
    Location_finder<Triangulation> finder(m_triangulation);
    finder.look_along(word, t);
    Segment_index half = null_index;
    m_triangulation.split_edge(h, word.along != null_index ? finder.result() : finder.result_inside(), finder.gap(),
                               [&](const Edge_halves& halves) {
                                 half = move_stack(halves.first, {{halves.first, halves.second}}, s);
                               });
    return half;
  }

private:
  // Points that were rounded lie off the lines that they divide. Where such a line is divided again, a vertex this
  // close to it, relative to its length, is taken to be on it.
  static constexpr double same_place = 1e-12;
  static constexpr int most_slivers = 64;

  // A face on the left of a halfedge whose apex is next to the halfedge, that part of the way along it.
  struct Sliver
  {
    Halfedge_index halfedge = null_index;
    double place = 0;
  };

  Sliver sliver_beside(Halfedge_index h) const
  {
    for(Halfedge_index side : {h, Triangulation::twin(h)}) {
      if(m_triangulation.is_border(side))
        continue;
      const Halfedge_index to_apex = Triangulation::twin(m_triangulation.previous(side));
      const double place = m_triangulation.length(to_apex) / m_triangulation.length(side);
      if(place < 1 - same_place && wedge_angle(m_triangulation, to_apex, side).value * place <= same_place)
        return {side, place};
    }
    return {};
  }

  // Moves the segments on the edge of h over the apex on its left.
  Segment_index move_to_apex(Halfedge_index h, Segment_index watched)
  {
    const Segment_index result = move_stack(
        h, {{Triangulation::twin(m_triangulation.previous(h)), Triangulation::twin(m_triangulation.next(h))}}, watched);
    if(m_triangulation.is_flippable(h))
      m_triangulation.flip(h);
    return result;
  }

  // Moves the segments on the edge of h to a chain of two halfedges, from its tail to its head, with no vertex between
  // them, in their order. Returns what the first half of a watched one has become.
  Segment_index move_stack(Halfedge_index h, const std::array<Halfedge_index, 2>& chain, Segment_index watched)
  {
    Segment_index result = null_index;
    std::vector<Segment_index> segments = m_network.stack(Triangulation::edge(h));
    if(!is_first_side(h))
      std::reverse(segments.begin(), segments.end()); // from left to right as seen along h
    for(Segment_index s : segments)
      m_network.m_segments.unlink(s);
    for(Segment_index s : segments) {
      const bool is_along = m_network.halfedge(s) == h;
      const Curve_index curve = m_network.curve(s);
      const Segment_index a = m_network.m_segments.create(curve, is_along ? chain[0] : Triangulation::twin(chain[1]));
      const Segment_index b = m_network.m_segments.create(curve, is_along ? chain[1] : Triangulation::twin(chain[0]));
      m_network.m_segments.link_outermost(a, is_along ? chain[0] : chain[1]);
      m_network.m_segments.link_outermost(b, is_along ? chain[1] : chain[0]);
      replace_in_curve(s, a, b);
      result = s == watched ? a : result;
    }
    return result;
  }

  // Puts a and b into the place of s.
  void replace_in_curve(Segment_index s, Segment_index a, Segment_index b)
  {
    const auto old = m_network.m_segments[s];
    auto& c = m_network.m_curves[old.curve];
    const bool was_whole_loop = old.next == s;
    m_network.m_segments.link(a, b);
    m_network.m_segments.link(was_whole_loop ? b : old.previous, a);
    if(!was_whole_loop && old.previous != null_index)
      m_network.m_segments[old.previous].is_head_straight = {};
    m_network.m_segments.link(b, was_whole_loop ? a : old.next);
    m_network.m_segments[b].is_head_fixed = old.is_head_fixed;
    m_network.m_segments[s].halfedge = null_index;
    c.first = c.first == s ? a : c.first;
    c.last = c.last == s ? b : c.last;
  }

  Network& m_network;
  Triangulation& m_triangulation;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_SEGMENT_DIVISION_H
