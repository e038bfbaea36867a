// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_STRAIGHTENED_PATH_H
#define CGAL_FLIP_GEODESICS_STRAIGHTENED_PATH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Iterative_unfolding.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Segment_insertion.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Flip_geodesics {
namespace internal {

/*
 * Straightens an edge path on the input mesh by `Iterative_unfolding`, in plain doubles: an initial path for FlipOut,
 * which determines afterwards what is straight. The result is a chain of geodesic segments between vertices that is not
 * longer than the path.
 *
 * The path is first led around each of its vertices on the side with fewer faces, and then around each vertex at which
 * the funnel bends, on a side with an angle below pi, until no such vertex remains.
 */
template <class Triangulation>
class Strip_straightener
{
public:
  /* A straight line from vertex to vertex: along an edge, or across others. */
  using Leg = typename Iterative_unfolding<Triangulation>::Piece;

  explicit Strip_straightener(const Triangulation& triangulation)
    : m_unfolding(triangulation, Refused_faces::WITHOUT_CORNERS)
  {
  }

  /* Straightens an edge path. Returns whether the result differs from the path. */
  bool operator()(const std::vector<Halfedge_index>& path)
  {
    m_unfolding.reserve(path.size());
    m_unfolding.restart();
    m_path_length = 0;
    for(Halfedge_index of_path : path) {
      const Input_halfedge_index h = as_input(of_path);
      if(!m_unfolding.faces().has_halfedge(h) || (!legs().empty() && legs().back().head != m_unfolding.faces().tail(h)))
        return false; // not a chain, which is rejected when the path is added
      m_unfolding.append_edge(h);
      m_path_length += m_unfolding.faces().length(h);
    }
    Side_of_fewer_faces first_rule{{m_unfolding}};
    Side_below_pi rule{{m_unfolding}};
    return m_unfolding.pass_joints_once(first_rule) && m_unfolding.tighten(rule) && length() <= m_path_length &&
           !m_unfolding.faces().have_refused();
  }

  const std::vector<Leg>& legs() const { return m_unfolding.pieces(); }

  /* Returns the length of the path that was straightened. */
  double path_length() const { return m_path_length; }

  std::vector<Crossed_edge> crossed(const Leg& leg)
  {
    std::vector<Crossed_edge> result;
    if(leg.first == leg.last)
      return result;
    const Sleeve<Triangulation>& sleeve = m_unfolding.unfolded(leg);
    const Plane_vector line = sleeve.head_place() - sleeve.tail_place();
    result.reserve(sleeve.edges().size());
    for(std::size_t i = 0; i < sleeve.edges().size(); ++i) {
      const Portal& portal = sleeve.portals()[i];
      const bool is_left_new = portal.side == LEFT_END;
      const double height = is_left_new ? cross(line, portal.end - sleeve.tail_place()) : 0;
      result.push_back({as_intrinsic(sleeve.edges()[i].crossed), is_left_new, height});
    }
    return result;
  }

private:
  using Bend = typename Iterative_unfolding<Triangulation>::Bend;

  double length() const
  {
    double result = 0;
    for(const Leg& leg : legs())
      result += leg.along == null_index ? well_rounded_length(leg.vector) : m_unfolding.faces().length(leg.along);
    return result;
  }

  // ---- rules of the unfolding

  struct Rounded_bends
  {
    static constexpr bool drops_loops = false; // a path that passes through a vertex twice is left to FlipOut

    const Iterative_unfolding<Triangulation>& unfolding;

    const std::vector<Bend>& bends(const Edge_sequence&) const { return unfolding.sleeve().bends(); }
  };

  struct Side_of_fewer_faces : Rounded_bends
  {
    Passed_side side(const Leg& in, const Leg& out, Passed_side before) const
    {
      const std::size_t left = number_of_corners(out.along, in.at_head.outgoing);
      const std::size_t right = number_of_corners(in.at_head.outgoing, out.along);
      if((std::min)(left, right) == blocked)
        return Passed_side::NONE;
      if(left == right)
        return before == Passed_side::NONE ? Passed_side::LEFT : before;
      return left < right ? Passed_side::LEFT : Passed_side::RIGHT;
    }

  private:
    static constexpr std::size_t blocked = static_cast<std::size_t>(-1);

    // Counts the corners from one outgoing halfedge counterclockwise to another.
    std::size_t number_of_corners(Input_halfedge_index from, Input_halfedge_index to) const
    {
      const Input_faces<Triangulation>& faces = this->unfolding.faces();
      std::size_t result = 0;
      do {
        if(faces.is_border(from))
          return blocked;
        from = faces.counterclockwise(from);
        ++result;
      } while(from != to);
      return result;
    }
  };

  struct Side_below_pi : Rounded_bends
  {
    Passed_side side(const Leg& in, const Leg& out, Passed_side) const
    {
      if(in.is_left_open && is_below_pi(out.at_tail, in.at_head))
        return Passed_side::LEFT;
      return in.is_right_open && is_below_pi(in.at_head, out.at_tail) ? Passed_side::RIGHT : Passed_side::NONE;
    }

  private:
    // Returns whether the angle from one direction counterclockwise to another is below pi.
    bool is_below_pi(const Corner_direction& from, const Corner_direction& to) const
    {
      const Corner_angle angle = this->unfolding.faces().angle(from, to, unstraightened_angle);
      return !angle.is_beyond_pi && angle.turn.imag() > unstraightened_angle * magnitude(angle.turn);
    }
  };

  Iterative_unfolding<Triangulation> m_unfolding;
  double m_path_length = 0;
};

template <class Triangulation>
double length_of(const Triangulation& triangulation, const std::vector<Halfedge_index>& path)
{
  double length = 0;
  for(Halfedge_index h : path)
    length += triangulation.length(h);
  return length;
}

/* Returns whether an open path passes through no vertex twice. */
template <class Triangulation>
bool is_simple(const Triangulation& triangulation, const std::vector<Halfedge_index>& path)
{
  std::vector<Vertex_index> vertices = {triangulation.head(path.back())};
  for(Halfedge_index h : path)
    vertices.push_back(triangulation.tail(h));
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end();
}

/*
 * Returns the segments of a straightened path as edges of the triangulation, for which the edges that they cross are
 * flipped. The result is empty if two segments block each other.
 */
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

/* Empties a network and undoes all flips at the end of its scope, unless it has been dismissed. */
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
 * Straightens an edge path and adds the result to an empty network, so that `shorten()` needs few flips.
 *
 * The resulting curve is never longer than the path. It can pass through vertices between its ends, but stays in the
 * homotopy class of the path. A subsequent call of `shorten()` determines which segments and joints of the curve are
 * straight. The function is intended for paths that are fixed only at their ends, such as those of
 * `Shortest_edge_path`. If a stop predicate or a visitor has to observe the whole process, use
 * `Edge_path_network::add_curve()` instead.
 *
 * The face strip along the path is unfolded, the path is shortened within the strip by a funnel algorithm, and the
 * strip is moved to the other side of the vertices at which the path bends \cgalCite{XW07}. These steps are repeated;
 * they are computed in doubles and without flips. Finally, the resulting geodesic segments are inserted by flipping the
 * edges that they cross.
 *
 * If the result cannot be used, for example because of degenerate faces, segments that block each other, or rounding
 * errors, all flips are undone, and the path itself is added.
 *
 * \param network an empty network in a triangulation that has not been flipped
 * \param path the halfedges of an open path, whose length becomes the initial length of the curve
 * \param most_memory a limit in bytes, as for `Memory_stop_predicate`. If the records of the flips would exceed the
 *        limit, the path itself is added
 * \return the number of flips, including those that were undone
 *
 * \throws Invalid_curve_error as `Edge_path_network::add_curve()` does
 * \throws Degenerate_face_error if a face at the path has a degenerate edge or violates the triangle inequality; in
 *         this case the network is empty, and nothing is flipped
 * \throws Invalid_coordinate_error if a face at the path has an invalid coordinate or length; in this case the network
 *         is empty, and nothing is flipped
 * \throws Occupied_triangulation_error if another network has curves in the triangulation; in this case nothing changes
 *
 * Complexity: each repetition takes time linear in the number of faces of the strip. Roughly one repetition is required
 * for each row of vertices between the path and the geodesic. The number of flips is usually less than 1.4 times the
 * number of edges that the geodesic crosses, and quadratic in this number in the worst case.
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
    network.add_curve(path);
    guard.dismiss();
    return flips;
  }
  network.add_curve(straight);
  network.set_initial_length(Curve_index(0), straightener.path_length());
  guard.dismiss();
  return flips;
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_STRAIGHTENED_PATH_H
