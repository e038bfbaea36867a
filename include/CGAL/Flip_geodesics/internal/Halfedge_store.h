// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_HALFEDGE_STORE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_HALFEDGE_STORE_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/Lazy_array.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A hint to the cache that an address will be read soon. */
inline void prefetch(const void* address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
  asm volatile(""); // without it, g++ takes what only prefetches for a function without effect, and drops its calls
#else
  static_cast<void>(address);
#endif
}

/*
 * What a triangulation keeps of a halfedge, and half of what it keeps of its edge: the first side has the crossings and
 * the version, the second the label. All zeros is a side of an input edge whose face is not known yet. With two doubles
 * of geometry it takes 32 bytes, so that an edge is a cache line.
 */
template <class Halfedge_geometry>
struct Halfedge_record
{
  static constexpr Index untouched = 0, border = -1;

  Index encoded_next; // untouched, border, or one more than the next halfedge
  Index tail;
  Index of_edge[2]; // crossings, one more, and version; or label, and nothing
  Halfedge_geometry geometry;

  bool is_known() const { return encoded_next != untouched; }
  bool is_border() const { return encoded_next == border; }
  /* \pre known and not on the border */
  Index next() const { return encoded_next - 1; }
  /* \pre known; null_index on the border */
  Index next_if_any() const { return (std::max)(encoded_next, 0) - 1; }
  void set_next(Index h) { encoded_next = h + 1; }
};

/*
 * The halfedges of a triangulation, and a halfedge per vertex: those of the input, each face copied when it is first
 * touched, and those that are added. So nothing is read or written of what is not touched.
 */
template <class Input_mesh_, class Traits_, class Metric_>
class Halfedge_store
{
public:
  using Input_mesh = Input_mesh_;
  using Traits = Traits_;
  using Metric = Metric_;
  using Halfedge_geometry = typename Traits::Halfedge_geometry;
  using Record = Halfedge_record<Halfedge_geometry>;

  Halfedge_store(const Input_mesh& input, const Metric& metric, const Traits& traits)
    : m_input(input)
    , m_metric(metric)
    , m_traits(traits)
    , m_records(static_cast<std::size_t>(m_input.number_of_halfedges()))
    , m_outgoing(static_cast<std::size_t>(m_input.number_of_vertices()))
  {
  }

  const Input_mesh& input() const { return m_input; }
  const Metric& metric() const { return m_metric; }
  const Traits& traits() const { return m_traits; }

  Index number_of_vertices() const { return static_cast<Index>(m_outgoing.size()); }
  Index number_of_edges() const { return static_cast<Index>(m_records.size() / 2); }

  /* The record of a halfedge as it is; if its face is known, so are the two others of the face. */
  Record& known(Index h) { return m_records[static_cast<std::size_t>(h)]; }
  const Record& known(Index h) const { return m_records[static_cast<std::size_t>(h)]; }

  /* The record of a halfedge, whose face is copied if need be. */
  Record& operator[](Index h)
  {
    Record& record = known(h);
    if(!record.is_known())
      import_face(h);
    return record;
  }

  /* Calls the two other sides of the face of a halfedge into the cache, if the face is known. */
  void prefetch_face(Index h) const
  {
    if(known(h).encoded_next <= 0)
      return;
    const Record& hn = known(known(h).next());
    prefetch(&hn);
    prefetch(&known(hn.next()));
  }

  Index& crossings_plus_one(Index e) { return known(2 * e).of_edge[0]; }
  Index& version(Index e) { return known(2 * e).of_edge[1]; }
  Index& label(Index e) { return known(2 * e + 1).of_edge[0]; }

  /* A halfedge that starts at v, null_index at an isolated vertex. */
  Index outgoing(Index v)
  {
    if(m_outgoing[v] == 0) {
      const Index h = v < m_input.number_of_vertices() ? m_input.outgoing(v) : null_index;
      if(h == null_index)
        return null_index;
      (*this)[h];
      m_outgoing[v] = h + 1;
    }
    return m_outgoing[v] - 1;
  }

  void set_outgoing(Index v, Index h) { m_outgoing[v] = h + 1; }

  /* If `from` is the halfedge that is kept for v, keeps `to` instead. */
  void move_outgoing(Index v, Index from, Index to)
  {
    if(m_outgoing[v] == from + 1)
      m_outgoing[v] = to + 1;
  }

  void link_face(Index a, Index b, Index c)
  {
    known(a).set_next(b);
    known(b).set_next(c);
    known(c).set_next(a);
  }

  void add_vertex() { m_outgoing.resize(m_outgoing.size() + 1); }

  void remove_last_vertex()
  {
    m_outgoing[m_outgoing.size() - 1] = 0;
    m_outgoing.resize(m_outgoing.size() - 1);
  }

  /* An edge whose sides are in no face yet. */
  void add_edge() { m_records.resize(m_records.size() + 2); }

  void remove_last_edge()
  {
    const std::size_t size = m_records.size() - 2;
    m_records[size] = m_records[size + 1] = Record();
    m_records.resize(size);
  }

private:
  void import_face(Index h)
  {
    if(m_input.is_border(h)) {
      known(h).tail = m_input.tail(h);
      known(h).encoded_next = Record::border;
      return;
    }
    const Index hn = m_input.next(h), hp = m_input.next(hn);
    if(m_input.next(hp) != h)
      throw Invalid_mesh_error("the face at vertex " + std::to_string(m_input.tail(h)) + " is not a triangle",
                               {static_cast<std::size_t>(m_input.tail(h))});
    // From the smallest side on, so that the bits do not depend on which side is touched first.
    const Index first = (std::min)({h, hn, hp});
    const Index sides[3] = {first, m_input.next(first), m_input.next(m_input.next(first))};
    const auto geometry = m_metric.face_geometry(m_input, first, m_traits);
    for(int i = 0; i < 3; ++i) {
      Record& record = known(sides[i]);
      record.tail = m_input.tail(sides[i]);
      record.geometry = geometry[i];
      if(m_outgoing[record.tail] == 0)
        m_outgoing[record.tail] = sides[i] + 1;
    }
    link_face(sides[0], sides[1], sides[2]);
  }

  Input_mesh m_input;
  Metric m_metric;
  Traits m_traits;
  Lazy_array<Record> m_records;
  Lazy_array<Index> m_outgoing; // one more than a halfedge, 0 where none is known
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_HALFEDGE_STORE_H
