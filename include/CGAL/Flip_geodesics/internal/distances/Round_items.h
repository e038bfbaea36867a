// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_ITEMS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_ITEMS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Window.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A priority queue from which all entries up to some key are removed at once, in an unspecified but deterministic
 * order. Entries due soon are examined each time, later ones only when no others are left.
 */
class Round_queue
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  struct Entry
  {
    double key;
    Index id;
    std::uint32_t tag; // additional data
  };

  bool empty() const { return m_soon.empty() && m_later.empty(); }

  /* Returns the smallest key; infinity if the queue is empty. */
  double least() const { return m_soon.empty() ? m_least_later : m_least_soon; }

  void push(const Entry& e)
  {
    (e.key < m_horizon ? m_soon : m_later).push_back(e);
    double& least = e.key < m_horizon ? m_least_soon : m_least_later;
    least = (std::min)(least, e.key);
  }

  /* Reserves memory for additional entries. */
  void reserve(std::size_t number)
  {
    for(std::vector<Entry>* entries : {&m_soon, &m_later})
      if(entries->capacity() - entries->size() < number)
        entries->reserve((std::max)(2 * entries->capacity(), entries->size() + number));
  }

  /* Prepares for `take(last)` and returns an upper bound of the number of entries removed by it. Changes nothing if it
   * throws.
   * \param step estimate of the increase of `last` until the next call */
  std::size_t look_ahead(double last, double step)
  {
    constexpr double steps = 16; // between two examinations of later entries
    if(m_least_later <= last || m_soon.empty()) {
      m_soon.reserve(m_soon.size() + m_later.size());
      m_horizon = last + steps * step;
      if(m_least_later <= m_horizon)
        remove(m_later, m_least_later, m_horizon, [this](const Entry& e) {
          m_soon.push_back(e);
          m_least_soon = (std::min)(m_least_soon, e.key);
        });
    }
    return m_soon.size();
  }

  /* Calls `function(entry)` for all entries whose keys are at most `last`, and removes them. The function must not push
   * entries. \pre look_ahead(last) was called since the last push */
  template <class Function>
  void take(double last, const Function& function)
  {
    remove(m_soon, m_least_soon, last, function);
  }

private:
  // Removes the entries whose keys are at most `last` from a list.
  template <class Function>
  static void remove(std::vector<Entry>& entries, double& least, double last, const Function& function)
  {
    least = infinity;
    auto to = entries.begin();
    for(const Entry& e : entries)
      if(e.key <= last) {
        function(e);
      } else {
        least = (std::min)(least, e.key);
        *to++ = e;
      }
    entries.erase(to, entries.end());
  }

  std::vector<Entry> m_soon, m_later; // with keys up to the horizon, and larger ones
  double m_horizon = 0, m_least_soon = infinity, m_least_later = infinity;
};

/* A window that is propagated over a face, in the frame of the side across which it enters. */
struct Crossing_window
{
  Window window;
  double crossing; // where the ray to the vertex opposite crosses the side
};

/* All windows that cross a face from one side together. */
struct Face_crossing
{
  Crossing_window *first, *last;
  Input_halfedge_index halfedge, next, previous; // the side across which they enter, and the sides that follow it
  Vertex_index apex;                             // the vertex opposite
  bool is_shorter;                               // whether the path there is shorter than others
  const Crossing_window* nearest;                // has the shortest path; null if none has one
  double distance;                               // of the vertex by that path

  /* Removes all windows. */
  void clear()
  {
    first = last = nullptr;
    is_shorter = false;
  }

  /* Converts the windows to the frame of the side and finds the nearest one. */
  template <class Sides>
  void begin(Input_halfedge_index h, const Sides& sides)
  {
    const Face_side& f = sides.known(h);
    halfedge = h;
    next = f.next;
    previous = sides.known(next).next;
    apex = sides.known(previous).tail;
    nearest = nullptr;
    distance = std::numeric_limits<double>::infinity();
    for(Crossing_window* i = first; i != last; ++i) {
      Window& w = i->window;
      if(!is_first_side(halfedge))
        w.mirror(f.length);
      const double c = i->crossing = w.crossing(f.x, f.y);
      if(!(c > w.from - beside_window * f.length && c < w.to + beside_window * f.length))
        continue;
      const double through = w.bent_distance(f.x, f.y, c);
      // If the ray misses its window, it reaches the apex only if the bent path is as long as the straight line.
      if(!(c >= w.from && c <= w.to) && through - w.distance(f.x, f.y) > equal_paths * through)
        continue;
      if(through < distance) {
        distance = through;
        nearest = i;
      }
    }
    is_shorter = nearest != nullptr;
  }

  /* Calls `function` for everything that arrives at the side at the tail, in the frame of its twin. */
  template <class Function>
  void arrive_left(const Face_side& f, double length, const Function& function) const
  {
    const double best = nearest == nullptr ? 0 : nearest->crossing, limit = best + beside_window * f.length;
    for(const Crossing_window* i = first; i != last; ++i) {
      const Window& w = i->window;
      const double c = i->crossing;
      if(!(c > w.from) || (is_split(*i) && c > limit))
        continue;
      // The part of a window before the ray to the apex, which crosses at c.
      Window child = turned(w, f.cosine, f.sine, (std::min)(c, w.to), c < w.to + w.error(f.length), length);
      if(!(child.y > 0))
        continue;
      child.mirror(length);
      function(child);
    }
  }

  /* Calls `function` for everything that arrives at the side at the head, by mirror images. */
  template <class Function>
  void arrive_right(const Face_side& f, const Face_side& fn, const Function& function) const
  {
    const double best = nearest == nullptr ? 0 : nearest->crossing, limit = best - beside_window * f.length;
    for(const Crossing_window* i = first; i != last; ++i) {
      const double c = i->crossing;
      if(!(c < i->window.to) || (is_split(*i) && c < limit))
        continue;
      Window w = i->window;
      w.mirror(f.length);
      Window child = turned(w, fn.cosine, fn.sine, (std::min)(f.length - c, w.to),
                            f.length - c < w.to + w.error(f.length), fn.length);
      if(child.y > 0)
        function(child);
    }
  }

private:
  // Returns whether the ray to the apex divides the window. If its path is not the best to the apex, the window is
  // useless beyond the ray of the best one [CH90].
  static bool is_split(const Crossing_window& i) { return i.crossing > i.window.from && i.crossing < i.window.to; }

  // The part of a window up to `to` in the frame of a side that starts at the same vertex, rotated upwards by an angle.
  static Window turned(const Window& w, double cosine, double sine, double to, bool is_to_end, double length)
  {
    Window result = w;
    result.x = w.x * cosine - w.y * sine;
    result.y = w.y * cosine + w.x * sine;
    const double weight = w.weight();
    const auto hit = [&](double b) {
      const double fall = result.y - weight * b * sine;
      return fall > 0 ? (std::min)((std::max)(b * w.y / fall, 0.0), length) : length;
    };
    result.from = hit(w.from);
    result.to = is_to_end ? length : hit(to);
    return result;
  }
};

/* The time at which a vertex or an edge is due; for edges the tag is that of `Edge_record`, for vertices the
 * bearing. */
using Noted = Round_queue::Entry;

/* The approximate position on the front, from one end to the other. It affects only the distribution of work. */
struct Bearing
{
  std::uint32_t value;
  std::uint32_t bearing() const { return value; }

  static constexpr std::uint32_t number = 1 << 16;

  static std::uint32_t of(const Noted& e) { return e.tag % number; }

  /* Returns the bearing of the i-th of several items all around a source. */
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

/* The paths and windows that start from a vertex in a round, and their results. */
struct Starting
{
  bool is_source = false;
  Array_part<Vertex_opening> openings;
  Array_part<Edge_path> paths; // those shorter than others
  Array_part<Noted> noted;
};

/* The windows that leave an edge on which they were waiting, and their results. */
struct Leaving
{
  double length; // 0 if the edge is not left
  double passed; // the time at which the front has passed the edge, if it must be noted
  Array_part<Noted> noted;
  std::array<Face_crossing, 2> crossings;
};

/* A vertex or an edge that is due in a round. One of the pointers is set once it has been left. */
struct Round_item
{
  Noted due;
  std::uint32_t number; // in the order of the queues, vertices first
  bool is_vertex;
  bool may_reach; // whether it can be the shortest path to a vertex
  Starting* starting;
  Leaving* leaving;
};

/* A round, and a position among its items. */
struct Round_place
{
  std::uint32_t round, place;
};

/* Something that arrives at an edge in a round. */
struct Arrival
{
  /* Returns what arrives from the vertex opposite. */
  static Arrival from_vertex(const Round_item& item, Vertex_opening& o)
  {
    return {(std::uint64_t(item.number) << 32) + static_cast<std::uint64_t>(&o - item.starting->openings.first), &item,
            nullptr, &o, false};
  }
  /* Returns what arrives from a side of the face that has been crossed, at whose tail or head the edge is. */
  static Arrival from_side(const Round_item& item, const Face_crossing& c, bool is_at_tail)
  {
    return {(std::uint64_t(item.number) << 32) + (is_first_side(c.halfedge) ? 0u : 2u) + (is_at_tail ? 0u : 1u), &item,
            &c, nullptr, is_at_tail};
  }

  std::uint64_t order; // among the arrivals of a round
  const Round_item* item;
  const Face_crossing* crossing; // null if it comes from a vertex
  Vertex_opening* opening;
  bool is_left;
};

/* All arrivals at an edge, in order: from at most two vertices and four sides, from vertices on the border twice. */
class Arrivals
{
public:
  Arrivals() {} // leaves the elements uninitialized

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

  /* To the left of the origin, or to the right. */
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
 * All items of a round. Results can depend on their numbers, but not on their positions, in which the members of a team
 * process them: each member gets much the same part of the front as in the previous round, whose data is in its cache.
 */
class Round_items
{
public:
  /* Begins a round with at most `most` items. Changes nothing if it throws. */
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

  /* Distributes the added items among the members of a team, first the vertices and then the edges. */
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

  /* By position. */
  Round_item& operator[](std::size_t place) { return m_items[place]; }
  const Round_item& operator[](std::size_t place) const { return m_items[place]; }

  /* The positions by their numbers; below, the inverse. */
  const std::vector<std::uint32_t>& places() const { return m_places; }
  const std::vector<std::uint32_t>& numbers() const { return m_numbers; }

private:
  // Sorts approximately.
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

  std::vector<Noted> m_due;        // by number
  std::vector<Round_item> m_items; // by position, with additional unused ones
  std::vector<std::uint32_t> m_places, m_numbers;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_ITEMS_H
