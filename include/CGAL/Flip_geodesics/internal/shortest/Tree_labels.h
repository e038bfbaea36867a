// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_TREE_LABELS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_TREE_LABELS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The labels of vertices in a growing tree: unknown, with an offered path that waits in the queue, or with an accepted
 * path. All labels are cleared in constant time, since each contains the number of the tree that wrote it.
 *
 * Invariant: an offered path has an entry in the queue, with its length, until that entry is removed. Entries of paths
 * that are no longer offered stay in the queue until then.
 */
class Tree_labels
{
public:
  explicit Tree_labels(std::size_t size)
    : m_labels(size)
  {
  }

  /* Clears all labels, for a tree over `size` vertices. */
  void start(std::size_t size)
  {
    if(m_labels.size() < size || m_epoch > (std::numeric_limits<Index>::max)() - 8) { // or no epoch is left
      m_labels = Labels(size);
      m_epoch = 0;
    }
    m_epoch += 4;
    m_queue.clear();
  }

  bool is_unknown(Vertex_index v) const { return state(v) == UNKNOWN; }
  bool is_offered(Vertex_index v) const { return state(v) == OFFERED; }
  bool is_settled(Vertex_index v) const { return state(v) == SETTLED; }

  /* Returns the length of the path; below, its last halfedge. \pre `v` is not unknown */
  double distance(Vertex_index v) const { return m_labels[v].distance; }
  Halfedge_index incoming(Vertex_index v) const { return m_labels[v].incoming; }

  /* Offers a path instead of the previous label. */
  void offer(Vertex_index v, double distance, Halfedge_index h)
  {
    m_labels[v] = {distance, h, m_epoch + OFFERED};
    m_queue.push(distance, v);
  }

  /* Accepts the offered path. */
  void settle(Vertex_index v)
  {
    CGAL_precondition(is_offered(v));
    m_labels[v].stamp = m_epoch + SETTLED;
  }

  /* Accepts another path. */
  void settle(Vertex_index v, double distance, Halfedge_index h) { m_labels[v] = {distance, h, m_epoch + SETTLED}; }

  void forget(Vertex_index v) { m_labels[v].stamp = m_epoch; }

  bool has_offers() const { return !m_queue.empty(); }

  /* Removes the shortest path from the queue, of equally long ones that to the smallest vertex; returns `null_index` if
   * it is no longer offered. \pre `has_offers()` */
  Vertex_index pop()
  {
    const double offered = m_queue.priority();
    const Vertex_index v = m_queue.pop();
    return is_offered(v) && distance(v) == offered ? v : null_index;
  }

private:
  enum State : Index { UNKNOWN = 0, OFFERED = 1, SETTLED = 2 };

  struct Label
  {
    double distance;
    Halfedge_index incoming;
    Index stamp; // the epoch, a multiple of 4, plus the state
  };

  using Labels = Indexed_by<Vertex_index, Lazy_array<Label>>;

  Index state(Vertex_index v) const
  {
    const Index stamp = m_labels[v].stamp - m_epoch;
    return m_epoch == 0 || stamp < 0 ? static_cast<Index>(UNKNOWN) : stamp;
  }

  Labels m_labels;
  Vertex_queue m_queue;
  Index m_epoch = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_TREE_LABELS_H
