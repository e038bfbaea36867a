// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FLIP_LOG_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FLIP_LOG_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Flip_record.h>
#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/normal_coordinates.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * What was done to the halfedges of a triangulation since the input, each step with what it overwrote. Flips and faces
 * laid out afresh are done here; of points that are inserted the log knows when it was.
 *
 * The invariant: the records, taken back from the last on, restore the store that they were made of, bit for bit.
 */
template <class Store>
class Flip_log
{
  using Halfedge_record = typename Store::Record;
  using Geometry = typename Store::Halfedge_geometry;

public:
  using Record = Flip_record<Geometry>;

  std::size_t size() const { return m_records.size(); }
  const Record& operator[](std::size_t i) const { return m_records[i]; }
  const Record& back() const { return m_records.back(); }
  /* In bytes. */
  std::size_t memory() const { return m_records.memory(); }

  /*
   * Flips the edge of a halfedge, as `Intrinsic_triangulation::flip()`. Returns the halfedges that have new vectors. If
   * it throws, nothing has changed.
   */
  std::array<Slot, 4> flip(Store& halfedges, Halfedge_index h)
  {
    const Slot s = halfedges.taken(h), t = twin_slot(s);
    Halfedge_record &at_h = halfedges.known(s), &at_t = halfedges.known(t); // from here on both faces are known
    const Slot hn = at_h.next(), tn = at_t.next();
    CGAL_precondition_msg(hn != t && tn != s, "an edge at a vertex of degree 1 cannot be flipped");
    CGAL_precondition_msg(halfedges.holds(s) == 0, "a curve lies on the edge that is flipped");
    Halfedge_record &at_hn = halfedges[hn], &at_tn = halfedges[tn];
    const Slot hp = at_hn.next(), tp = at_tn.next();
    Halfedge_record &at_hp = halfedges[hp], &at_tp = halfedges[tp];

    auto flipped = halfedges.traits().flip_object()(at_h.geometry, at_hn.geometry, at_hp.geometry, at_t.geometry,
                                                    at_tn.geometry, at_tp.geometry);
    const Quad_crossings crossing(halfedges.crossings(s), halfedges.crossings(hn), halfedges.crossings(hp),
                                  halfedges.crossings(tn), halfedges.crossings(tp));
    const Index new_crossings = crossing.other_diagonal();
    m_records.push_back({h, halfedges.halfedge(hp), halfedges.halfedge(tn), halfedges.version(hp),
                         halfedges.version(tn), new_crossings, halfedges.version(s), halfedges.crossings(s) + 1,
                         at_h.geometry, at_t.geometry, at_tn.geometry, at_tp.geometry});

    halfedges.move_outgoing(s, tn, hn);
    halfedges.version(s) = static_cast<Index>(m_records.size());
    halfedges.crossings_plus_one(s) = new_crossings + 1;
    at_h.set_next(hp);
    at_hp.set_next(tn);
    at_tn.set_next(s);
    at_t.set_next(tp);
    at_tp.set_next(hn);
    at_hn.set_next(t);
    at_h.tail = at_tp.tail;
    at_t.tail = at_hp.tail;
    at_h.geometry = std::move(flipped.h);
    at_t.geometry = std::move(flipped.t);
    at_tn.geometry = std::move(flipped.tn);
    at_tp.geometry = std::move(flipped.tp);
    return {{s, t, tn, tp}};
  }

  /* Replaces the vectors of the face on the left of a halfedge, from it on. */
  template <class Face_geometry>
  void lay_out(Store& halfedges, Halfedge_index h, const Face_geometry& geometry)
  {
    const Halfedge_record& at_h = halfedges.known(h);
    const Halfedge_record &at_hn = halfedges[at_h.next()], &at_hp = halfedges[at_hn.next()];
    m_records.push_back(
        {h, null_index, null_index, 0, 0, 0, 0, 0, at_h.geometry, at_hn.geometry, at_hp.geometry, Geometry()});
    halfedges.set_face_geometry(h, geometry[0], geometry[1], geometry[2]);
  }

  /* Notes that the edge of h, or the face on its left, is to be split at a gap, by the insertion of a number. */
  void note_insertion(const Store& halfedges, Halfedge_index h, bool is_on_edge, Index gap, Index number)
  {
    const Slot s = halfedges.slot(h);
    m_records.push_back({h, null_index, is_on_edge ? halfedges.halfedge(twin_slot(s)) : h, gap, 0, number,
                         halfedges.version(s), halfedges.crossings(s) + 1, Geometry(), Geometry(), Geometry(),
                         Geometry()});
  }

  /* Takes the last step back. Of an insertion the halfedges must have been taken back before. */
  void take_back(Store& halfedges)
  {
    const Record& last = m_records.back();
    if(last.is_flip())
      unflip(halfedges, last);
    else if(!last.is_insertion())
      halfedges.set_face_geometry(last.h, last.old_h, last.old_t, last.old_tn);
    m_records.pop_back();
  }

private:
  // h = l->k in (h, hp, tn) and t = k->l in (t, tp, hn) become i->j and j->i again.
  static void unflip(Store& halfedges, const Record& flip)
  {
    const Slot h = halfedges.slot(flip.h), t = twin_slot(h);
    Halfedge_record &at_h = halfedges[h], &at_t = halfedges[t];
    const Slot hp = at_h.next(), tp = at_t.next(), tn = halfedges[hp].next(), hn = halfedges[tp].next();
    Halfedge_record &at_tn = halfedges[tn], &at_tp = halfedges[tp];
    halfedges.move_outgoing(h, tp, hp);
    halfedges.version(h) = flip.old_version;
    halfedges.crossings_plus_one(h) = flip.old_crossings;
    halfedges.link_face(h, hn, hp);
    halfedges.link_face(t, tn, tp);
    at_h.tail = at_tn.tail;
    at_t.tail = halfedges[hn].tail;
    at_h.geometry = flip.old_h;
    at_t.geometry = flip.old_t;
    at_tn.geometry = flip.old_tn;
    at_tp.geometry = flip.old_tp;
  }

  Block_array<Record> m_records;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FLIP_LOG_H
