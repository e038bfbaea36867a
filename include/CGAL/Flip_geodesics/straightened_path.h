// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_STRAIGHTENED_PATH_H
#define CGAL_FLIP_GEODESICS_STRAIGHTENED_PATH_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Segment_insertion.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Strip_straightener.h>
#include <CGAL/Flip_geodesics/internal/triangulation/check_has_no_curves.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

template <class Triangulation>
double length_of(const Triangulation& triangulation, const std::vector<Halfedge_index>& path)
{
  double length = 0;
  for(Halfedge_index h : path)
    length += triangulation.length(h);
  return length;
}

/* Does an open path pass no vertex twice? */
template <class Triangulation>
bool is_simple(const Triangulation& triangulation, const std::vector<Halfedge_index>& path)
{
  std::vector<Vertex_index> vertices = {triangulation.head(path.back())};
  for(Halfedge_index h : path)
    vertices.push_back(triangulation.tail(h));
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end();
}

/* The legs of a straightened path as edges of the triangulation, for which the edges that they cross are flipped; none
 * if two legs are in each other's way, or a face on the way is degenerate. */
template <class Triangulation>
std::vector<Halfedge_index> insert_legs(Triangulation& triangulation, Strip_straightener<Triangulation>& straightener,
                                        std::size_t most_memory, std::size_t& flips)
{
  std::vector<Halfedge_index> path;
  for(const auto& leg : straightener.legs())
    if(!insert_leg(triangulation, leg.along, straightener.crossed(leg), path, flips, most_memory))
      return {};
  return path;
}

/* Empties a network and takes all flips back where it goes out of scope, unless it is dismissed before. */
template <class Network>
class Taken_back_on_failure
{
public:
  explicit Taken_back_on_failure(Network& network)
    : m_network(&network)
  {
  }
  Taken_back_on_failure(const Taken_back_on_failure&) = delete;
  Taken_back_on_failure& operator=(const Taken_back_on_failure&) = delete;
  ~Taken_back_on_failure()
  {
    if(m_network == nullptr)
      return;
    m_network->clear();
    m_network->triangulation().rollback(0);
  }

  void dismiss() { m_network = nullptr; }

private:
  Network* m_network;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds an edge path to an empty network, but straightened beforehand, so that `shorten()` finds little left to do. The
 * path is unfolded with a strip of faces along it, and pulled taut there. The strip is led round the other side of the
 * vertices that the path bends about [XW07]. All this is in double and without any flip. Then the straight legs are
 * inserted by flipping the edges that they cross.
 *
 * It is never longer than the path. The curve may pass vertices on its way, no other topology changes; it is up to
 * `shorten()` to decide what is straight. Where anything is in doubt (faces without area, legs that are in each other's
 * way, rounding), the path itself is added, and nothing is flipped.
 *
 * For paths of which only the ends matter, such as those of `Shortest_edge_path`. With a stop predicate, or a visitor
 * that is to see how the path is pulled tight, `Edge_path_network::add_curve()` does.
 *
 * \param network an empty network in a triangulation that has not been flipped
 * \param path the halfedges of an open path; its length becomes the curve's initial length
 * \param most_memory in bytes, as for `Memory_stop_predicate`: where the records of the flips would take more, the path
 *        itself is added
 * \return the number of flips
 *
 * \throws Degenerate_face_error, Invalid_coordinate_error as `Edge_path_network::add_curve()` for the path; the network
 *         is empty then, and nothing is flipped
 * \throws Occupied_triangulation_error if another network has curves in the triangulation; nothing is changed then
 *
 * Complexity: that of some rounds over the strip, of which there are about as many as rows of vertices between the path
 * and the geodesic. The flips are linear in the edges that the geodesic crosses.
 */
template <class Network>
std::size_t add_straightened_path(Network& network, const std::vector<Halfedge_index>& path,
                                  std::size_t most_memory = (std::numeric_limits<std::size_t>::max)())
{
  using Triangulation = typename Network::Triangulation;
  Triangulation& triangulation = network.triangulation();
  CGAL_precondition(network.number_of_curves() == 0 && triangulation.log_position() == 0);
  internal::check_has_no_curves(triangulation, "a path cannot be straightened");
  internal::Taken_back_on_failure<Network> guard(network);
  internal::Strip_straightener<Triangulation> straightener(triangulation);
  std::size_t flips = 0;
  std::vector<Halfedge_index> straight;
  if(straightener(path))
    straight = internal::insert_legs(triangulation, straightener, most_memory, flips);
  if(straight.empty() || !internal::is_simple(triangulation, straight) ||
     internal::length_of(triangulation, straight) > straightener.path_length())
  {
    triangulation.rollback(0);
    network.add_curve(path, false);
    guard.dismiss();
    return flips;
  }
  network.add_curve(straight, false);
  network.set_initial_length(Curve_index(0), straightener.path_length());
  guard.dismiss();
  return flips;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_STRAIGHTENED_PATH_H
