// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_TOPOLOGICAL_SIGNATURE_H
#define FLIP_GEODESICS_TEST_TOPOLOGICAL_SIGNATURE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

/*
 * What a network of curves is, apart from geometry: the connectivity of the triangulation, the stacks of its edges and
 * the chains of segments, copied once, so that it can be looked at later, and without some of the curves.
 *
 * Shares no code with the library beyond the accessors it copies from; elements are their bare numbers here.
 */
struct Curve_system
{
  struct Segment
  {
    int halfedge, next, previous, curve;
    bool is_head_fixed;
  };

  std::vector<int> next; // of halfedges, -1 on the border; twin(h) == h ^ 1
  std::vector<int> tail;
  std::vector<std::vector<int>> bundles; // of segments, per edge, from left to right along halfedge 2e
  std::vector<Segment> segments;         // by id; halfedge -1 for those that are gone

  Curve_system() = default;

  template <class Network>
  explicit Curve_system(const Network& network)
  {
    using CGAL::Flip_geodesics::Edge_index;
    using CGAL::Flip_geodesics::Halfedge_index;
    using CGAL::Flip_geodesics::Segment_index;
    const auto& triangulation = network.triangulation();
    for(Halfedge_index h(0); h.idx() < triangulation.number_of_halfedges(); ++h) {
      next.push_back(triangulation.is_border(h) ? -1 : triangulation.next(h).idx());
      tail.push_back(triangulation.tail(h).idx());
    }
    for(int e = 0; e < triangulation.number_of_edges(); ++e) {
      bundles.emplace_back();
      for(Segment_index s : network.bundle(Edge_index(e)))
        bundles.back().push_back(s.idx());
    }
    for(Segment_index s(0); s.idx() < network.end_of_segment_ids(); ++s)
      segments.push_back(s.idx() == 0 || !network.is_alive(s)
                             ? Segment{-1, -1, -1, -1, false}
                             : Segment{network.halfedge(s).idx(), network.next(s).idx(), network.previous(s).idx(),
                                       network.curve(s).idx(), network.is_head_fixed(s)});
  }

  bool is_border(int h) const { return next[h] < 0; }
  int previous(int h) const { return next[next[h]]; }
  int clockwise(int h) const { return is_border(h ^ 1) ? -1 : next[h ^ 1]; }
  int counterclockwise(int h) const { return is_border(h) ? -1 : (previous(h) ^ 1); }

  /// The stack of the edge of `h` from left to right as seen along `h`.
  std::vector<int> bundle_along(int h) const
  {
    std::vector<int> result = bundles[h / 2];
    if(h % 2 == 1)
      std::reverse(result.begin(), result.end());
    return result;
  }

  /// Takes segments out of their stacks; the chains are left as they are.
  template <class Predicate>
  void drop(const Predicate& is_dropped)
  {
    for(std::vector<int>& bundle : bundles)
      bundle.erase(std::remove_if(bundle.begin(), bundle.end(), is_dropped), bundle.end());
  }

  /// Numbers the arcs that fixed nodes cut the curves into: for each segment the first one of its arc.
  std::vector<int> arcs() const
  {
    std::vector<int> result(segments.size(), -1);
    const auto is_end = [&](int s) { return segments[s].next < 0 || segments[s].is_head_fixed; };
    const auto number_from = [&](int first) {
      for(int s = first; result[s] == -1; s = segments[s].next) {
        result[s] = first;
        if(is_end(s))
          return;
      }
    };
    for(int s = 0; s < static_cast<int>(segments.size()); ++s)
      if(segments[s].halfedge >= 0 && (segments[s].previous < 0 || is_end(segments[s].previous)))
        number_from(s);
    for(int s = 0; s < static_cast<int>(segments.size()); ++s)
      if(segments[s].halfedge >= 0 && result[s] == -1) // a loop without fixed nodes
        number_from(s);
    return result;
  }

  /// All stars: the halfedges that start at one vertex, clockwise, from the border if there is one.
  std::vector<std::vector<int>> stars() const
  {
    std::vector<std::vector<int>> result;
    std::vector<bool> is_seen(next.size(), false);
    for(int h = 0; h < static_cast<int>(next.size()); ++h) {
      if(is_seen[h])
        continue;
      int first = h;
      for(int g = counterclockwise(h); g != -1 && g != h; g = counterclockwise(g))
        first = g;
      if(counterclockwise(first) != -1)
        first = h;
      result.emplace_back();
      for(int g = first; g != -1 && !(is_seen[g]); g = clockwise(g)) {
        is_seen[g] = true;
        result.back().push_back(g);
      }
    }
    return result;
  }
};

/*
 * The isotopy class of a network, as far as it shows in the regions between its curves. The surface is thickened:
 * faces, edges as bands that their strands cut into slots, vertices as disks that the joints cut into sectors. A region
 * is a component of what is left. Its signature is its Euler characteristic and the set of what lies on its border:
 * sides of curves, edges of the surface's border, ends of curves.
 *
 * A face counts +1 (with its arcs to slots and sectors and the points where three meet), a slot -1, a sector +1.
 */
class Topological_signature
{
public:
  using Mark = std::array<int, 3>; // kind, id, side

  struct Region
  {
    int euler_characteristic;
    std::vector<Mark> marks;

    bool operator<(const Region& other) const
    {
      return std::tie(euler_characteristic, marks) < std::tie(other.euler_characteristic, other.marks);
    }
    bool operator==(const Region& other) const
    {
      return euler_characteristic == other.euler_characteristic && marks == other.marks;
    }
  };

  Topological_signature() = default;

  /// Without the curves in `dropped`. With `has_fixed_nodes` also without the arcs between fixed nodes that bound a
  /// disk with nothing in it, since these may contract at any time, and with no marks for the ends.
  explicit Topological_signature(Curve_system system, const std::set<int>& dropped = {}, bool has_fixed_nodes = false)
  {
    system.drop([&](int s) { return dropped.count(system.segments[s].curve) != 0; });
    const std::vector<int> arcs = system.arcs();
    m_regions = Builder(system, arcs).regions();
    for(auto spur = find_spur(); has_fixed_nodes && spur != m_regions.end(); spur = find_spur()) {
      const int arc = spur->marks.front()[1];
      system.drop([&](int s) { return arcs[s] == arc; });
      m_regions = Builder(system, arcs).regions();
    }
    for(Region& region : m_regions)
      forget_arcs(region, system, has_fixed_nodes);
    std::sort(m_regions.begin(), m_regions.end());
  }

  bool operator==(const Topological_signature& other) const { return m_regions == other.m_regions; }
  bool operator!=(const Topological_signature& other) const { return !(*this == other); }
  const std::vector<Region>& regions() const { return m_regions; }

  /// Is there a disk with nothing but one curve on its border?
  bool has_disk_inside(int curve) const
  {
    return std::any_of(m_regions.begin(), m_regions.end(), [curve](const Region& region) {
      return region.euler_characteristic == 1 && !region.marks.empty() &&
             std::all_of(region.marks.begin(), region.marks.end(), [curve](const Mark& mark) {
               return (mark[0] == segment && mark[1] == curve) || (mark[0] == end && mark[1] / 2 == curve);
             });
    });
  }

private:
  enum { segment, border, end, fixed_node };

  // A disk with one side of one arc on its border, and nodes.
  std::vector<Region>::const_iterator find_spur() const
  {
    return std::find_if(m_regions.begin(), m_regions.end(), [](const Region& region) {
      const std::vector<Mark>& marks = region.marks; // sorted by kind, strands first
      const auto count = [&](int kind) {
        return std::count_if(marks.begin(), marks.end(), [kind](const Mark& m) { return m[0] == kind; });
      };
      return region.euler_characteristic == 1 && count(segment) == 1 && count(border) == 0 &&
             count(fixed_node) + count(end) > 0;
    });
  }

  // From arcs to curves, which keep their names.
  static void forget_arcs(Region& region, const Curve_system& system, bool has_fixed_nodes)
  {
    std::vector<Mark>& marks = region.marks;
    for(Mark& mark : marks)
      if(mark[0] == segment)
        mark[1] = system.segments[mark[1]].curve;
    if(has_fixed_nodes)
      marks.erase(
          std::remove_if(marks.begin(), marks.end(), [](const Mark& m) { return m[0] == end || m[0] == fixed_node; }),
          marks.end());
    std::sort(marks.begin(), marks.end());
    marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  }

  // Glues the cells together.
  struct Builder
  {
    Builder(const Curve_system& system, const std::vector<int>& arcs)
      : system(system)
      , arcs(arcs)
    {
      const int halfedges = static_cast<int>(system.next.size());
      for(int h = 0; h < halfedges; ++h) {
        bundle.push_back(system.bundle_along(h));
        first_place.push_back(static_cast<int>(parent.size()));
        for(std::size_t i = 0; i <= bundle[h].size(); ++i)
          parent.push_back(static_cast<int>(parent.size()));
      }
    }

    // Places are the ends of slots at vertices: place i of spoke h is to the left of its strand i.
    int place(int h, std::size_t i) const { return first_place[h] + static_cast<int>(i); }
    int last_place(int h) const { return place(h, bundle[h].size()); }

    int find(int i)
    {
      while(parent[i] != i)
        i = parent[i] = parent[parent[i]];
      return i;
    }

    void unite(int i, int j) { parent[find(i)] = find(j); }

    std::vector<Region> regions()
    {
      const int places = static_cast<int>(parent.size());
      for(const std::vector<int>& star : system.stars())
        cut_vertex(star);
      std::vector<int> sectors;
      for(int i = 0; i < places; ++i)
        if(find(i) == i)
          sectors.push_back(i);
      std::vector<int> slots, faces;
      glue(slots, faces);

      std::vector<Region> all(places, {0, {}});
      for(int i : sectors)
        all[find(i)].euler_characteristic += 1;
      for(int i : slots)
        all[find(i)].euler_characteristic -= 1;
      for(int i : faces)
        all[find(i)].euler_characteristic += 1;
      for(const auto& [where, mark] : marks)
        all[find(where)].marks.push_back(mark);
      std::vector<Region> result;
      for(int i = 0; i < places; ++i) {
        if(find(i) != i)
          continue;
        std::vector<Mark>& m = all[i].marks;
        std::sort(m.begin(), m.end());
        m.erase(std::unique(m.begin(), m.end()), m.end());
        result.push_back(all[i]);
      }
      return result;
    }

    struct End
    {
      int halfedge, segment, before, after; // the places on its left and on its right as seen from the vertex
    };

    // The segment and halfedge that a joint connects an end with; -1 where the curve ends or the node is fixed.
    std::pair<int, int> mate(const End& e) const
    {
      const Curve_system::Segment& s = system.segments[e.segment];
      if(e.halfedge == s.halfedge) {
        if(s.previous < 0 || system.segments[s.previous].is_head_fixed)
          return {-1, -1};
        return {s.previous, system.segments[s.previous].halfedge ^ 1};
      }
      if(s.next < 0 || s.is_head_fixed)
        return {-1, -1};
      return {s.next, system.segments[s.next].halfedge};
    }

    void cut_vertex(const std::vector<int>& star)
    {
      std::vector<End> ends;
      for(std::size_t i = 0; i < star.size(); ++i) {
        const int h = star[i];
        for(std::size_t k = 0; k < bundle[h].size(); ++k)
          ends.push_back({h, bundle[h][k], place(h, k), place(h, k + 1)});
        const int g = system.clockwise(h);
        if(g != -1)
          unite(last_place(h), place(g, 0));
      }
      std::vector<End> single;
      for(const End& e : ends) {
        const auto [segment, halfedge] = mate(e);
        if(segment < 0) {
          single.push_back(e);
          mark_end(e);
          continue;
        }
        const auto m = std::find_if(ends.begin(), ends.end(), [s = segment, h = halfedge](const End& other) {
          return other.segment == s && other.halfedge == h;
        });
        unite(e.after, m->before);
        unite(e.before, m->after);
      }
      if(system.clockwise(star.back()) == -1) // the border parts the region of the single ends as they do
        single.push_back({-1, -1, last_place(star.back()), place(star.front(), 0)});
      for(std::size_t i = 0; i < single.size(); ++i)
        unite(single[i].after, single[(i + 1) % single.size()].before);
    }

    void mark_end(const End& e)
    {
      const Curve_system::Segment& s = system.segments[e.segment];
      const bool is_start = e.halfedge == s.halfedge;
      const bool is_end_of_curve = is_start ? s.previous < 0 : s.next < 0;
      const int kind = is_end_of_curve ? end : fixed_node;
      const int id = is_end_of_curve ? 2 * s.curve + (is_start ? 0 : 1) : system.tail[e.halfedge];
      marks.push_back({e.before, {kind, id, is_end_of_curve ? 0 : 2}});
      marks.push_back({e.after, {kind, id, is_end_of_curve ? 1 : 2}});
    }

    void glue(std::vector<int>& slots, std::vector<int>& faces)
    {
      for(int h = 0; h < static_cast<int>(system.next.size()); ++h) {
        const std::size_t k = bundle[h].size();
        if(h % 2 == 0)
          for(std::size_t i = 0; i <= k; ++i) {
            slots.push_back(place(h, i));
            unite(place(h, i), place(h ^ 1, k - i));
            if(i > 0)
              mark_segment(place(h, i), bundle[h][i - 1], h, false);
            if(i < k)
              mark_segment(place(h, i), bundle[h][i], h, true);
          }
        if(system.is_border(h)) {
          marks.push_back({place(h, 0), {border, h / 2, 0}});
          continue;
        }
        const int hn = system.next[h];
        unite(place(h, 0), place(hn, 0)); // the face lies to the left of both
        if(h < hn && h < system.next[hn])
          faces.push_back(place(h, 0));
      }
    }

    void mark_segment(int where, int s, int h, bool is_left_of_h)
    {
      const bool is_left = is_left_of_h == (system.segments[s].halfedge == h);
      marks.push_back({where, {segment, arcs[s], is_left ? 0 : 1}});
    }

    const Curve_system& system;
    const std::vector<int>& arcs;
    std::vector<std::vector<int>> bundle; // per halfedge, from left to right
    std::vector<int> first_place, parent;
    std::vector<std::pair<int, Mark>> marks;
  };

  std::vector<Region> m_regions;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_TOPOLOGICAL_SIGNATURE_H
