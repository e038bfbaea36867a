// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_SHARP_SECTORS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_SHARP_SECTORS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Face_shape.h>

#include <boost/math/constants/constants.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Tells where the angle about a vertex between constrained edges, or all round, is less than 60 degrees: a *sharp
 * sector*. Flips and insertions do not change that, so sharp sectors are noted at their spokes, and not measured again:
 * a spoke, as long as its version lasts, costs constant time on average, however many there are in the sector. Other
 * sectors are measured only until they have 60 degrees.
 */
template <class Triangulation>
class Sharp_sectors
{
public:
  explicit Sharp_sectors(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* Is the corner at the tail of h, in the face on its left, in a sharp sector? */
  bool operator()(Halfedge_index h)
  {
    m_walked.assign(1, h);
    double sum = angle_at_tail(h);
    bool is_known = is_noted(h);
    for(Halfedge_index g = h; !is_known && !is_constrained(g) && sum < sharp;) {
      g = m_triangulation.clockwise(g);
      if(g == h)
        return note(sum);
      is_known = walk_over(g, sum);
    }
    for(Halfedge_index g = m_triangulation.counterclockwise(h); !is_known && sum < sharp && !is_constrained(g);
        g = m_triangulation.counterclockwise(g))
      is_known = walk_over(g, sum);
    return note(is_known ? 0 : sum);
  }

private:
  static constexpr double sharp = boost::math::constants::pi<double>() / 3;

  // Returns whether the sector is noted there.
  bool walk_over(Halfedge_index g, double& sum)
  {
    m_walked.push_back(g);
    sum += angle_at_tail(g);
    return is_noted(g);
  }

  bool note(double sum)
  {
    if(sum < sharp - sharp_sector_margin)
      for(Halfedge_index g : m_walked) {
        if(m_versions.size() <= static_cast<std::size_t>(g.idx()))
          m_versions.resize(static_cast<std::size_t>(m_triangulation.number_of_halfedges()), null_index);
        m_versions[static_cast<std::size_t>(g.idx())] = m_triangulation.version(Triangulation::edge(g));
      }
    return sum < sharp;
  }

  bool is_noted(Halfedge_index g) const
  {
    return static_cast<std::size_t>(g.idx()) < m_versions.size() &&
           m_versions[static_cast<std::size_t>(g.idx())] == m_triangulation.version(Triangulation::edge(g));
  }

  double angle_at_tail(Halfedge_index h) const { return Face_shape<Triangulation>(m_triangulation, h).angle(0); }

  bool is_constrained(Halfedge_index h) const { return is_constrained_edge(m_triangulation, h); }

  const Triangulation& m_triangulation;
  std::vector<Index> m_versions; // by halfedge: of its edge, when its sector was found sharp
  std::vector<Halfedge_index> m_walked;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_SHARP_SECTORS_H
