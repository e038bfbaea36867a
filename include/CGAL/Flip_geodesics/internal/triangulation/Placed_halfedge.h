// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_PLACED_HALFEDGE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_PLACED_HALFEDGE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A halfedge of a triangulation, held by where the triangulation keeps it: for walks, whose steps each take a look into
 * the table of slots if they are made by index.
 *
 * The functions are those of `Intrinsic_triangulation`, and copy faces of the input as they do.
 */
template <class Store>
class Placed_halfedge
{
  using Record = typename Store::Record;
  using Turn = typename Store::Traits::Turn;

public:
  /* What a halfedge's place is kept in; default constructed it is none. */
  using Place = Slot;

  Placed_halfedge(Store& store, Slot slot)
    : m_store(&store)
    , m_slot(slot)
  {
  }

  Place place() const { return m_slot; }

  Halfedge_index index() const { return store().halfedge(m_slot); }
  std::size_t edge_place() const { return static_cast<std::size_t>(m_slot) / 2; }
  bool is_held() const { return store().holds(m_slot) != 0; }
  void hold() const { store().hold(m_slot); }
  void release() const { store().release(m_slot); }

  /* What clockwise() and counterclockwise() give where the border intervenes. */
  bool is_none() const { return m_slot == Slot::NONE; }
  bool operator==(const Placed_halfedge& other) const { return m_slot == other.m_slot; }
  bool operator!=(const Placed_halfedge& other) const { return m_slot != other.m_slot; }

  bool is_border() const { return store().known(m_slot).is_border(); }
  Vertex_index tail() const { return store().known(m_slot).tail; }
  Placed_halfedge twin() const { return at(twin_slot(m_slot)); }
  Placed_halfedge next() const { return at(store().known(m_slot).next()); }
  Placed_halfedge previous() const { return at(store()[store().known(m_slot).next()].next()); }

  Placed_halfedge clockwise() const
  {
    const Record& record = store().known(twin_slot(m_slot));
    return at(record.is_border() ? Slot::NONE : record.next());
  }

  Placed_halfedge counterclockwise() const
  {
    const Record& record = store().known(m_slot);
    return at(record.is_border() ? Slot::NONE : twin_slot(store()[record.next()].next()));
  }

  double length() const
  {
    const Record& record = store().known(m_slot);
    return store().traits().compute_length_object()(
        (record.is_border() ? store().known(twin_slot(m_slot)) : record).geometry);
  }

  void prefetch_face() const { store().prefetch_face(m_slot); }

  Placed_halfedge extend_turn_clockwise(Turn& turn) const
  {
    const Record& in = store().known(twin_slot(m_slot));
    if(in.is_border())
      return at(Slot::NONE);
    extend_turn_over(turn, in);
    prefetch(&store()[store()[in.next()].next()]); // for flips, should it come to that
    return at(in.next());
  }

  void extend_turn(Turn& turn) const { extend_turn_over(turn, store().known(m_slot)); }

  /* Adds the angle at the head in the two faces of the edge; returns from where it leads, clockwise, and to where.
   * \pre both faces exist */
  std::pair<Placed_halfedge, Placed_halfedge> extend_turn_at_head(Turn& turn) const
  {
    const Record& at_h = store().known(m_slot);
    const Slot tp = store()[store().known(twin_slot(m_slot)).next()].next();
    extend_turn_over(turn, at_h);
    extend_turn_over(turn, store()[tp]);
    return {at(tp).twin(), at(at_h.next())};
  }

private:
  Store& store() const { return *m_store; }
  Placed_halfedge at(Slot slot) const { return Placed_halfedge(*m_store, slot); }

  // Adds the corner at the head of a halfedge whose face is known.
  void extend_turn_over(Turn& turn, const Record& in) const
  {
    const Record& out = store()[in.next()];
    store().traits().extend_turn_object()(turn, in.geometry, out.geometry, store()[out.next()].geometry);
  }

  Store* m_store;
  Slot m_slot;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_PLACED_HALFEDGE_H
