// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_SEGMENT_INSERTION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_SEGMENT_INSERTION_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Crossing_removal.h>
#include <CGAL/Flip_geodesics/internal/flip_out/flip_out_wedge.h>
#include <CGAL/Flip_geodesics/internal/surface/face_lengths.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The left side of the strip of faces along which the given halfedges are crossed, each as a side of the face that is
 * left: a chain of halfedges from the vertex at which the strip starts to that at which it ends.
 *
 *            __ left __ . __
 *     start /  |  \   /  \   \ end        the chain runs above, what is crossed lies in between
 *           \__|___\./____\__/
 *              right
 */
template <class Triangulation>
std::vector<Halfedge_index> left_side_of_strip(const Triangulation& triangulation,
                                               const std::vector<Halfedge_index>& crossed)
{
  std::vector<Halfedge_index> chain = {Triangulation::twin(triangulation.next(crossed.front()))};
  for(std::size_t i = 0; i < crossed.size(); ++i) {
    const Halfedge_index entered = Triangulation::twin(crossed[i]);
    const bool is_last = i + 1 == crossed.size();
    if(is_last || crossed[i + 1] == triangulation.next(entered))
      chain.push_back(Triangulation::twin(triangulation.previous(entered)));
  }
  return chain;
}

/*
 * Flips edges on the right of a chain until all angles there are at least pi. If the chain is the left side of a strip
 * of different faces that holds the straight segment between its ends, then only edges inside the strip are flipped,
 * and one halfedge, the segment, is left: the polygon between the two has its inner angles at the ends, and the others
 * are at least pi. `flip(h)` is to flip the edge of h. Returns the number of flips.
 */
template <class Triangulation, class Flip>
std::size_t straighten_on_the_right(const Triangulation& triangulation, std::vector<Halfedge_index>& chain,
                                    const Flip& flip)
{
  std::size_t flips = 0;
  std::vector<Halfedge_index> arc;
  for(std::size_t i = 0; i + 1 < chain.size();) {
    const Halfedge_index back = Triangulation::twin(chain[i]), on = chain[i + 1];
    typename Triangulation::Turn turn;
    const auto is_blocked = [](const auto&) { return false; };
    if(on == back ||
       !is_free_wedge(triangulation, triangulation.walker(on), triangulation.walker(back), turn, is_blocked)) {
      ++i;
      continue;
    }
    flip_out_wedge(triangulation, on, back, arc, [&](Halfedge_index h) {
      flip(h);
      ++flips;
    });
    // The arc leads back, from the head of `on` to the tail of chain[i].
    std::vector<Halfedge_index> replacement;
    for(std::size_t j = arc.size(); j-- > 0;)
      replacement.push_back(Triangulation::twin(arc[j]));
    const auto position =
        chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(i), chain.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    chain.insert(position, replacement.begin(), replacement.end());
    i = i == 0 ? 0 : i - 1;
  }
  return flips;
}

template <class Triangulation>
std::size_t straighten_on_the_right(Triangulation& triangulation, std::vector<Halfedge_index>& chain)
{
  return straighten_on_the_right(triangulation, chain, [&](Halfedge_index h) { triangulation.flip(h); });
}

/* Are all three edges of the face on the left of a halfedge the input's, and does the metric make vectors of it? */
template <class Triangulation>
bool is_untouched(const Triangulation& triangulation, Halfedge_index h)
{
  const Halfedge_index hn = triangulation.next(h), hp = triangulation.next(hn);
  return triangulation.version(Triangulation::edge(h)) == 0 && triangulation.version(Triangulation::edge(hn)) == 0 &&
         triangulation.version(Triangulation::edge(hp)) == 0 &&
         is_usable_face(triangulation.metric(), triangulation.input(), as_input(h));
}

/* The edges that a straight word crosses. */
template <class Triangulation>
std::vector<Crossed_edge> crossed_edges(const Triangulation& triangulation, const Crossing_word& word)
{
  const Strip<Triangulation> strip(triangulation, word);
  std::vector<Crossed_edge> result;
  Input_halfedge_index right_side;
  for(const auto& gate : strip.gates()) {
    const double left_height = strip.end().real() * gate.left.imag() - strip.end().imag() * gate.left.real();
    result.push_back({as_intrinsic(gate.crossed), result.empty() || gate.crossed == right_side, left_height});
    right_side = triangulation.input().next(twin_index(gate.crossed));
  }
  return result;
}

/*
 * Appends to a path the straight segment along an input halfedge, or across others as a strip crosses them. Returns
 * whether it could be: it cannot where edges of the strip have been flipped already, where it has a face twice or a
 * degenerate one, or where the triangulation's records would take more memory than given.
 */
template <class Triangulation>
bool insert_leg(Triangulation& triangulation, Input_halfedge_index along, const std::vector<Crossed_edge>& crossed,
                std::vector<Halfedge_index>& path, std::size_t& flips,
                std::size_t most_memory = (std::numeric_limits<std::size_t>::max)())
{
  if(along != null_index) {
    path.push_back(as_intrinsic(along));
    return triangulation.version(Triangulation::edge(path.back())) == 0;
  }
  for(const Crossed_edge& c : crossed)
    if(!is_untouched(triangulation, c.halfedge))
      return false;
  if(!is_untouched(triangulation, Triangulation::twin(crossed.back().halfedge)))
    return false;
  Crossing_removal<Triangulation> removal(triangulation, most_memory);
  const bool is_done = removal(crossed);
  flips += removal.number_of_flips();
  if(!is_done)
    return false;
  const std::vector<Halfedge_index> rest = removal.crossed();
  if(rest.empty()) {
    path.push_back(removal.segment());
    return true;
  }
  std::vector<Halfedge_index> chain = left_side_of_strip(triangulation, rest);
  flips += straighten_on_the_right(triangulation, chain);
  path.insert(path.end(), chain.begin(), chain.end());
  return true;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_SEGMENT_INSERTION_H
