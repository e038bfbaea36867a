// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_STAR_FLIPS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_STAR_FLIPS_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Lawson_flips.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Makes the faces around a new vertex Delaunay. Each flip makes an edge at the vertex, and none of those is flipped
 * again, but for a few ties and what wrong flips left; so there are few, and they are not interrupted.
 */
template <class Triangulation>
class Star_flips
{
public:
  explicit Star_flips(Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_lawson(triangulation, true)
  {
  }

  /* Returns false, and leaves the faces as they were, if flips were wrong. The visitor is told of each flip. */
  template <class Visitor>
  bool flip_around(Vertex_index x, Visitor& visitor)
  {
    const auto before = m_triangulation.log_position();
    m_lawson.clear();
    for_each_edge_in_star(m_triangulation, x, [this](Halfedge_index h) { m_lawson.look_at(Triangulation::edge(h)); });
    m_flipped.clear();
    Recorder<Visitor> recorder = {visitor, m_flipped, x};
    try {
      m_flips += m_lawson.flip((std::numeric_limits<std::size_t>::max)(), recorder);
      if(!recorder.has_lost_its_way() &&
         std::all_of(m_flipped.begin(), m_flipped.end(), [this](Halfedge_index h) { return has_right_word(h); }))
        return true;
    } catch(const Insertion_error&) { // a word does not lead from end to end
    }
    m_triangulation.rollback(before);
    return false;
  }

  /* The halfedges that were flipped around the last vertex. */
  const std::vector<Halfedge_index>& flipped() const { return m_flipped; }

  /* The number of all flips, those taken back included. */
  std::size_t flips() const { return m_flips; }

private:
  // Notes flips, passes them on, and ends them if they are wrong.
  template <class Visitor>
  struct Recorder
  {
    Visitor& visitor;
    std::vector<Halfedge_index>& flipped;
    Vertex_index x;
    int strays = 0;

    bool go_further() const { return !has_lost_its_way(); }
    bool has_lost_its_way() const { return strays > 64; }
    void on_flip(const Triangulation& triangulation, Halfedge_index h)
    {
      strays += triangulation.tail(h) == x || triangulation.head(h) == x ? 0 : 1;
      flipped.push_back(h);
      visitor.on_flip(triangulation, h);
    }
  };

  // Throws or returns false if flips were wrong: the words of flipped edges lead from end to end, inside the surface.
  bool has_right_word(Halfedge_index h) const
  {
    const Crossing_word word = m_triangulation.crossing_word(h);
    const auto is_inside = [&input = m_triangulation.input()](Input_halfedge_index g) {
      return !input.is_border(g) && !input.is_border(twin_index(g));
    };
    return (word.along == null_index || is_inside(word.along)) &&
           std::all_of(word.crossed.begin(), word.crossed.end(), is_inside);
  }

  Triangulation& m_triangulation;
  Lawson_flips<Triangulation> m_lawson;
  std::vector<Halfedge_index> m_flipped;
  std::size_t m_flips = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_STAR_FLIPS_H
