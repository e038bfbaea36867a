// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_EDGE_WINDOWS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_EDGE_WINDOWS_H

#include <CGAL/Flip_geodesics/internal/distances/Window.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Lazy_array.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * For each edge the windows on it that have the shortest ways known to its points, from both sides, ordered by where they
 * begin: the lower envelope of their distances [MMP87]. A shortest path through a point enters one face only, so that
 * windows of both sides compete. A `Window_inserter` puts them there.
 */
class Edge_windows
{
public:
  explicit Edge_windows(std::size_t number_of_edges)
    : m_lists(number_of_edges)
  {
  }

  /* Those of an edge, along it. */
  CGAL::Iterator_range<Window*> on_edge(Index edge)
  {
    const List& l = list(edge);
    return CGAL::make_range(l.first, l.first + l.size);
  }
  CGAL::Iterator_range<const Window*> on_edge(Index edge) const
  {
    const List& l = m_lists[static_cast<std::size_t>(edge)];
    return CGAL::make_range<const Window*>(l.first, l.first + l.size);
  }

private:
  friend class Window_inserter;

  struct List
  {
    Window* first;
    std::uint32_t size;
    std::uint32_t block; // the logarithm of the room, and 1; 0 if there is none
  };

  List& list(Index edge) { return m_lists[static_cast<std::size_t>(edge)]; }

  Lazy_array<List> m_lists;
};

/*
 * Puts windows on edges, as far as they are shorter than others there. Several threads can do so at once, on different
 * edges, each by an inserter of its own, all of which must outlive the windows.
 *
 * Where two windows are equally near up to rounding, both are kept: the rays of one may lead to where the other's do not.
 * Only if their rays are the same, the one that has more of them does. So windows may overlap, and what is taken off one
 * can put it behind another.
 *
 * The windows of an edge lie in a block of memory, of a power of two of them, and blocks that are given back are used
 * again.
 */
class Window_inserter
{
  using List = Edge_windows::List;

public:
  /* How many windows have been put on edges in all; and how many there is room for. */
  std::size_t number_made() const { return m_made; }
  std::size_t capacity() const { return m_capacity; }
  /* Of how many windows there is room in blocks that have been given back. */
  std::size_t spare() const { return m_spare; }
  /* How many windows an edge has had at most. */
  std::size_t most_on_an_edge() const { return m_most_on_an_edge; }
  /* How many windows have been on edges, in all, when others were to be put there: a measure of the work. */
  std::size_t number_passed() const { return m_passed; }

  /* Takes the windows of an edge away. */
  void clear(Edge_windows& windows, Index edge)
  {
    give_back(windows.list(edge));
    windows.list(edge) = List();
  }

  /* Puts a window on an edge, as far as it is not longer than others there. Returns whether that is anywhere. */
  bool insert(Edge_windows& windows, Index edge, const Window& w)
  {
    const auto old = windows.on_edge(edge);
    const auto is_apart = [&](const Window& v) { return v.to <= w.from || v.from >= w.to; };
    const Window *first = old.begin(), *last = old.end();
    while(first != last && first->to <= w.from)
      ++first;
    while(last != first && last[-1].from >= w.to)
      --last;
    m_passed += static_cast<std::size_t>(old.size());
    m_result.clear();
    m_lost.clear();
    for(const Window* v = first; v != last; ++v)
      if(is_apart(*v))
        add_part(*v, v->from, v->to);
      else
        compete(*v, w);
    if(!put(w))
      return false;
    replace(windows.list(edge), static_cast<std::uint32_t>(first - old.begin()),
            static_cast<std::uint32_t>(last - first));
    return true;
  }

private:
  struct Interval
  {
    double from, to;
  };

  // Takes off an old window and a new one what the other is nearer to.
  void compete(const Window& old, const Window& w)
  {
    const double l = (std::max)(w.from, old.from), r = (std::min)(w.to, old.to);
    const double at_l = w.distance(l), at_r = w.distance(r), equal = equal_paths * (std::max)(at_l, at_r);
    const double dl = at_l - old.distance(l), dr = at_r - old.distance(r);
    m_old_lost.clear();
    // The difference is monotone but where a ray of both crosses the edge.
    const double gl = turn(w, old, l), gr = turn(w, old, r);
    const bool is_turning = (gl < 0) != (gr < 0);
    const double b = is_turning ? l + (r - l) * (gl / (gl - gr)) : l;
    if(b > l && b < r) {
      const double d = w.distance(b) - old.distance(b);
      settle(old, w, {l, b}, dl, d, equal);
      settle(old, w, {b, r}, d, dr, equal);
    } else {
      settle(old, w, {l, r}, dl, dr, equal);
    }
    keep(old);
  }

  // The same where the difference is monotone, by how much the new window is longer at both ends.
  void settle(const Window& old, const Window& w, const Interval& at, double dl, double dr, double equal)
  {
    if((std::max)(dl, dr) <= equal && (std::min)(dl, dr) >= -equal) {
      if(std::abs(w.slope(at.from) - old.slope(at.from)) + std::abs(w.slope(at.to) - old.slope(at.to)) < parallel_rays)
        (w.to - w.from > old.to - old.from ? m_old_lost : m_lost).push_back(at);
      return;
    }
    if((std::min)(dl, dr) > equal)
      return m_lost.push_back(at);
    if((std::max)(dl, dr) < -equal)
      return m_old_lost.push_back(at);
    const bool is_crossed = std::abs(dl) > equal && std::abs(dr) > equal;
    const double difference = is_crossed ? 0 : ((std::max)(dl, dr) > equal ? equal : -equal);
    const double b = crossing(w, old, at, dl < dr, difference, equal);
    const double margin = is_crossed ? 2 * equal / std::abs(w.slope(b) - old.slope(b)) : 0;
    const Interval left = {at.from, b - margin}, right = {b + margin, at.to};
    if(left.from < left.to && std::abs(dl) > equal)
      (dl > 0 ? m_lost : m_old_lost).push_back(left);
    if(right.from < right.to && std::abs(dr) > equal)
      (dr > 0 ? m_lost : m_old_lost).push_back(right);
  }

  // Zero where the rays of both are parallel.
  static double turn(const Window& v, const Window& w, double b)
  {
    return (b * v.weight() - v.x) * w.y - (b * w.weight() - w.x) * v.y;
  }

  // Where the new window is longer by `difference`, which is between those at the ends, within half of `equal`.
  static double crossing(const Window& w, const Window& old, Interval at, bool is_rising, double difference,
                         double equal)
  {
    const double accuracy = equal / 2;
    double b = (at.from + at.to) / 2;
    for(int i = 0; b > at.from && b < at.to; ++i) {
      const double d = w.distance(b) - old.distance(b) - difference;
      if(std::abs(d) <= accuracy)
        break;
      ((d < 0) == is_rising ? at.from : at.to) = b;
      b -= d / (w.slope(b) - old.slope(b));
      if(!(b > at.from && b < at.to) || i % 8 == 7) // the interval has to shrink
        b = (at.from + at.to) / 2;
    }
    return b;
  }

  // Calls `function(from, to)` for the parts of a window that are not lost.
  template <class Function>
  static void for_each_part(const Window& w, std::vector<Interval>& lost, const Function& function)
  {
    if(lost.size() > 1)
      std::sort(lost.begin(), lost.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
    double from = w.from;
    for(const Interval& gap : lost) {
      if(from < gap.from)
        function(from, gap.from);
      from = (std::max)(from, gap.to);
    }
    if(from < w.to)
      function(from, w.to);
  }

  // Puts a part of a window in its place in the result, behind those that begin where it does.
  void add_part(const Window& w, double from, double to)
  {
    auto at = m_result.end();
    while(at != m_result.begin() && from < at[-1].from)
      --at;
    at = m_result.insert(at, w);
    at->from = from;
    at->to = to;
  }

  // Puts what is left of an old window there.
  void keep(const Window& old)
  {
    for_each_part(old, m_old_lost, [&](double from, double to) { add_part(old, from, to); });
  }

  // Puts what is left of the new one there; false if there is nothing.
  bool put(const Window& w)
  {
    const std::size_t made = m_made;
    for_each_part(w, m_lost, [&](double from, double to) {
      add_part(w, from, to);
      ++m_made;
    });
    return m_made != made;
  }

  // Replaces some windows of a list by those of the result.
  void replace(List& l, std::uint32_t first, std::uint32_t number)
  {
    const std::uint32_t added = static_cast<std::uint32_t>(m_result.size()), rest = l.size - first - number;
    const std::uint32_t size = first + added + rest;
    if(l.block == 0 || size > room(l.block)) {
      List larger = take(size);
      std::copy_n(l.first, first, larger.first);
      std::copy_n(l.first + first + number, rest, larger.first + first + added);
      give_back(l);
      l = larger;
    } else if(added != number) {
      Window *const from = l.first + first + number, *const to = l.first + first + added;
      if(added < number)
        std::copy(from, from + rest, to);
      else
        std::copy_backward(from, from + rest, to + rest);
    }
    std::copy(m_result.begin(), m_result.end(), l.first + first);
    l.size = size;
    m_most_on_an_edge = (std::max)(m_most_on_an_edge, static_cast<std::size_t>(size));
  }

  static constexpr std::uint32_t room(std::uint32_t block) { return 1u << (block - 1); }

  List take(std::uint32_t size)
  {
    std::uint32_t block = 3;
    while(room(block) < size)
      ++block;
    std::vector<Window*>& unused = m_unused[block];
    if(unused.empty())
      return {take_new(room(block)), size, block};
    Window* const first = unused.back();
    unused.pop_back();
    m_spare -= room(block);
    return {first, size, block};
  }

  // Memory that has not been used; a little more is asked for at once than an eighth of all that there is.
  Window* take_new(std::size_t size)
  {
    constexpr std::size_t least = 1024;
    if(m_left < size) {
      const std::size_t room = (std::max)({size, least, m_capacity / 8});
      std::unique_ptr<Window[]> chunk(new Window[room]);
      m_chunks.push_back(std::move(chunk));
      m_next = m_chunks.back().get();
      m_left = room;
    }
    Window* const result = m_next;
    m_next += size;
    m_left -= size;
    m_capacity += size;
    return result;
  }

  void give_back(const List& l)
  {
    if(l.block == 0)
      return;
    m_unused[l.block].push_back(l.first);
    m_spare += room(l.block);
  }

  std::vector<std::unique_ptr<Window[]>> m_chunks;
  Window* m_next = nullptr;                      // unused in the last chunk
  std::size_t m_left = 0;                        // how many windows there are behind it
  std::array<std::vector<Window*>, 32> m_unused; // blocks, by the logarithm of their room
  std::size_t m_made = 0, m_capacity = 0, m_spare = 0, m_most_on_an_edge = 0, m_passed = 0;
  // Of the insertion that is going on:
  std::vector<Window> m_result;
  std::vector<Interval> m_lost, m_old_lost; // parts of the new window, and of an old one
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_EDGE_WINDOWS_H
