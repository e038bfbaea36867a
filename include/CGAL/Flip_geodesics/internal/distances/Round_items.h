// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_ITEMS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_ITEMS_H

#include <CGAL/Flip_geodesics/internal/distances/Face_crossing.h>
#include <CGAL/Flip_geodesics/internal/distances/Round_queue.h>
#include <CGAL/Flip_geodesics/internal/distances/Vertex_openings.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* When a vertex or an edge is due; for edges the tag is that of `Edge_record`, for vertices the bearing. */
using Noted = Round_queue::Entry;

/* Where on the front something is, roughly, from one end of it to the other. Nothing depends on it but who does what. */
struct Bearing
{
  std::uint32_t value;
  std::uint32_t bearing() const { return value; }

  static constexpr std::uint32_t number = 1 << 16;

  static std::uint32_t of(const Noted& e) { return e.tag % number; }

  /* That of the i-th of some all round a source. */
  static int spread(std::ptrdiff_t i, std::ptrdiff_t size)
  {
    return static_cast<int>((2 * i + 1) * static_cast<std::ptrdiff_t>(number) / (2 * size));
  }
};

/* A part of an array. */
template <class T>
struct Array_part
{
  T *first = nullptr, *last = nullptr;
  T* begin() const { return first; }
  T* end() const { return last; }
  std::ptrdiff_t size() const { return last - first; }
};

/* A path along an edge. */
struct Edge_path
{
  Vertex_index head;
  Input_halfedge_index along;
  double distance;
};

/* What goes on from a vertex in a round, and what comes of it. */
struct Starting
{
  bool is_source = false;
  Array_part<Vertex_opening> openings;
  Array_part<Edge_path> paths; // that are shorter than others
  Array_part<Noted> noted;
};

/* What goes on from an edge whose waiting windows are carried on, and what comes of it. */
struct Leaving
{
  double length; // 0 if nothing is to be left
  double passed; // when the front has passed the edge, if that is to be noted
  Array_part<Noted> noted;
  std::array<Face_crossing, 2> crossings;
};

/* What is due in a round, a vertex or an edge. One of the pointers is set once it has been left. */
struct Round_item
{
  Noted due;
  std::uint32_t number; // in the order in which the queues gave them, vertices first
  bool is_vertex;
  bool may_reach; // can it be the shortest way to a vertex?
  Starting* starting;
  Leaving* leaving;
};

/* A round, and a place among what is due in it. */
struct Round_place
{
  std::uint32_t round, place;
};

/* What comes to an edge in a round. */
struct Arrival
{
  /* From the vertex opposite. */
  static Arrival from_vertex(const Round_item& item, Vertex_opening& o)
  {
    return {(std::uint64_t(item.number) << 32) + static_cast<std::uint64_t>(&o - item.starting->openings.first), &item,
            nullptr, &o, false};
  }
  /* From a side of the face that has been crossed, at whose tail the edge is, or at its head. */
  static Arrival from_side(const Round_item& item, const Face_crossing& c, bool is_at_tail)
  {
    return {(std::uint64_t(item.number) << 32) + (is_first_side(c.halfedge) ? 0u : 2u) + (is_at_tail ? 0u : 1u), &item,
            &c, nullptr, is_at_tail};
  }

  std::uint64_t order; // of what arrives in a round
  const Round_item* item;
  const Face_crossing* crossing; // null if it comes from a vertex
  Vertex_opening* opening;
  bool is_left;
};

/* All that comes to an edge, in order: from two vertices and four sides at most, from vertices on the border twice. */
class Arrivals
{
public:
  Arrivals() {} // does not clear them

  const Arrival* begin() const { return m_all.data(); }
  const Arrival* end() const { return m_all.data() + m_number; }

  void add(const Arrival& a)
  {
    CGAL_assertion(m_number < m_all.size());
    std::size_t i = m_number++;
    for(; i > 0 && a.order < m_all[i - 1].order; --i)
      m_all[i] = m_all[i - 1];
    m_all[i] = a;
  }

  /* To the left of where something comes from, or to the right. */
  std::uint32_t bearing() const
  {
    constexpr int turn = 16;
    int sum = 0;
    for(const Arrival& a : *this) {
      const int from = static_cast<int>(Bearing::of(a.item->due));
      if(a.crossing != nullptr)
        sum += from + (a.is_left ? turn : -turn);
      else if(const Starting& s = *a.item->starting; s.is_source)
        sum += Bearing::spread(a.opening - s.openings.first, s.openings.size());
      else
        sum += from;
    }
    const int mean = sum / static_cast<int>(m_number);
    return static_cast<std::uint32_t>((std::min)((std::max)(mean, 0), static_cast<int>(Bearing::number) - 1));
  }

private:
  std::array<Arrival, 8> m_all; // the first of them
  std::size_t m_number = 0;
};

/*
 * All that is due in a round. It has numbers, on which results can depend, and places, in which the members of a team
 * deal with it: each takes a part of the front, much the same as the last time, so that its cache has what belongs to that.
 */
class Round_items
{
public:
  /* Begins a round with at most so many. If it throws, nothing has changed. */
  void clear(std::size_t most)
  {
    m_due.reserve(most);
    m_places.reserve(most);
    m_numbers.reserve(most);
    m_items.resize((std::max)(m_items.size(), most));
    m_due.clear();
  }

  void add(const Noted& e) { m_due.push_back(e); }

  std::size_t size() const { return m_due.size(); }

  /* Deals what has been added to the members of a team, the vertices and then edges. */
  void deal(std::size_t members, std::size_t number_of_vertices)
  {
    const std::size_t n = size();
    m_places.resize(n);
    m_numbers.resize(n);
    if(members == 1)
      std::iota(m_places.begin(), m_places.end(), 0);
    else
      sort_by_bearing();
    for(std::size_t i = 0; i < n; ++i) {
      m_numbers[m_places[i]] = static_cast<std::uint32_t>(i);
      m_items[m_places[i]] = {m_due[i], static_cast<std::uint32_t>(i), i < number_of_vertices, false, nullptr, nullptr};
    }
  }

  /* By place. */
  Round_item& operator[](std::size_t place) { return m_items[place]; }
  const Round_item& operator[](std::size_t place) const { return m_items[place]; }

  /* Their places by their numbers, and the other way round. */
  const std::vector<std::uint32_t>& places() const { return m_places; }
  const std::vector<std::uint32_t>& numbers() const { return m_numbers; }

private:
  // Roughly.
  void sort_by_bearing()
  {
    std::uint32_t least = Bearing::number, most = 0;
    for(const Noted& e : m_due) {
      least = (std::min)(least, Bearing::of(e));
      most = (std::max)(most, Bearing::of(e));
    }
    constexpr std::uint32_t bins = 256;
    std::array<std::uint32_t, bins + 1> first{};
    const auto bin = [&](const Noted& e) { return (Bearing::of(e) - least) * (bins - 1) / (most - least + 1); };
    for(const Noted& e : m_due)
      ++first[bin(e) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    for(std::size_t i = 0; i < m_due.size(); ++i)
      m_places[i] = first[bin(m_due[i])]++;
  }

  std::vector<Noted> m_due;        // by numbers
  std::vector<Round_item> m_items; // by places, and more that are not in use
  std::vector<std::uint32_t> m_places, m_numbers;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_ITEMS_H
