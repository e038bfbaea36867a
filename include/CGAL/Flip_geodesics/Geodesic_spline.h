// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_SPLINE_H
#define CGAL_FLIP_GEODESICS_GEODESIC_SPLINE_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Shortening_report.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * A chain of geodesic B&eacute;zier curves on the surface, by de Casteljau's algorithm with geodesics for straight
 * lines [SC20, section 6.2; Morera, Velho, Carvalho, Computing Geodesic Curves on Triangular Meshes, 2008].
 *
 * A curve of a network is the control polygon: its fixed nodes are the control points, and the geodesics between them
 * its *legs*. A piece of the chain is divided at its middle. For that, the middles of its legs become vertices, and the
 * control points between them are freed. So the legs of the next level pull straight, and so on, until one leg is left.
 * Its middle is a point of the curve. All pieces are divided at once. The legs of both halves are then the control
 * polygons of the halves. In the plane the points of the curve are exactly those of the B&eacute;zier curve, up to
 * rounding.
 *
 * Legs are pulled straight from where the control polygon was, not searched anew: the curve stays in the polygon's
 * isotopy class. The triangulation conforms to it at all times.
 *
 * The invariant: the fixed nodes of the curve are the control points of the pieces, in order.
 *
 * \tparam Network an `Edge_path_network`, whose triangulation is a model of `IntrinsicTriangulationOfMesh`
 */
template <class Network>
class Geodesic_spline
{
  using Triangulation = typename Network::Triangulation;

public:
  /*!
   * One B&eacute;zier curve, whose control points are the ends and the fixed nodes of an open curve: the degree is one
   * less than their number. Pulls the legs straight. Where strands cross as they lie along shared edges, as after
   * `add_curve_through()` with legs over one another, they are put in order by `order_overlapping_curves()`.
   *
   * \pre the curve is not closed
   * \throws Crossing_curves_error, Ambiguous_order_error as `order_overlapping_curves()`
   * \throws as `shorten()`
   */
  Geodesic_spline(Network& network, Curve_index curve)
    : m_network(network)
    , m_curve(curve)
  {
    CGAL_precondition(!network.is_closed(curve));
    put_in_order();
    m_legs.assign(number_of_fixed_heads(), {});
    m_legs.back().ends_piece = true;
    pull_straight();
  }

  /*!
   * Makes the curve the control polygon of a uniform cubic B-spline [Farin, Curves and Surfaces for CAGD]. It divides
   * each leg into thirds, and cuts the corners off by lines. The cubic pieces meet at the middles of these. An open
   * spline starts and ends at the ends of the polygon; a closed one passes no control point.
   *
   * \pre a closed curve has at least three fixed nodes
   * \throws as the constructor and `refine()`
   */
  static Geodesic_spline cubic_b_spline(Network& network, Curve_index curve)
  {
    return Geodesic_spline(network, curve, Cubic_tag());
  }

  /*!
   * Divides every piece at its middle, and so doubles their number.
   * \throws Insertion_error if the curve is divided more finely than numbers can tell
   * \throws Crossing_curves_error if a strand crosses the curve at a control point that is freed; the network is valid
   *         then, and the spline of no use any more
   * \throws Invalid_curve_error if a leg has shrunk to a point
   */
  void refine()
  {
    for(Leg& leg : m_legs)
      leg.is_working = true;
    bool is_working = true;
    while(is_working) {
      is_working = divide_working_legs();
      pull_straight();
    }
  }

  /*!
   * Refines until a round changes the length of the control polygon by less than the `tolerance`-th part of it, at most
   * `most_rounds` times. The polygon becomes shorter by about a quarter as much with each round, so that the rest is a
   * third of the last change.
   * \return the number of rounds
   * \throws as `refine()`
   */
  int refine(double tolerance, int most_rounds)
  {
    double length = m_network.length(m_curve);
    for(int round = 1; round <= most_rounds; ++round) {
      refine();
      const double next = m_network.length(m_curve);
      if(std::abs(length - next) <= tolerance * next)
        return round;
      length = next;
    }
    return most_rounds;
  }

  /*!
   * Frees the control points that are not on the curve, so that geodesics join those that are. With traits that decide
   * exactly, the result is certified: a point that divides a segment is rounded, and lies on it only by definition, so
   * that a decision about the faces beside it can be wrong by as much.
   * \return the report of the last shortening; `PRECISION_LIMIT` for a curve that was to be exact and is not
   * \throws as `refine()`
   */
  const Shortening_report& finish()
  {
    std::vector<Cut> cuts(m_legs.size());
    for(std::size_t i = 0; i < m_legs.size(); ++i)
      cuts[i].frees_end = !m_legs[i].ends_piece;
    apply(cuts);
    std::vector<Leg> legs;
    for(const Leg& leg : m_legs)
      if(leg.ends_piece)
        legs.push_back(leg);
    m_legs = legs;
    pull_straight();
    check_exactly();
    return m_report;
  }

  /// The number of pieces.
  std::size_t number_of_pieces() const
  {
    std::size_t result = 0;
    for(const Leg& leg : m_legs)
      result += leg.ends_piece ? 1 : 0;
    return result;
  }

  /// The vertices where pieces start and end, which lie on the curve, in order; a closed curve repeats the first.
  std::vector<Vertex_index> vertices_on_curve() const
  {
    std::vector<Vertex_index> result;
    Segment_index s = first_segment();
    result.push_back(m_network.triangulation().tail(m_network.halfedge(s)));
    for(const Leg& leg : m_legs) {
      s = end_of_leg(s);
      if(leg.ends_piece)
        result.push_back(m_network.triangulation().head(m_network.halfedge(s)));
      s = m_network.next(s);
    }
    return result;
  }

  /// The report of the last shortening.
  const Shortening_report& report() const { return m_report; }

private:
  struct Cubic_tag
  {
  };

  struct Leg
  {
    bool is_working = false; // to be divided on this level
    bool ends_piece = false; // does it end at a point of the curve?
  };

  struct Cut
  {
    std::vector<double> places; // as parts of the leg, ascending
    bool frees_end = false;
  };

  void put_in_order()
  {
    if(!m_network.is_valid())
      order_overlapping_curves(m_network);
  }

  Geodesic_spline(Network& network, Curve_index curve, Cubic_tag)
    : m_network(network)
    , m_curve(curve)
  {
    const bool is_closed = network.is_closed(curve);
    const std::size_t n = number_of_fixed_heads();
    CGAL_precondition(!is_closed || n >= 3);
    put_in_order();
    m_legs.assign(n, {});
    if(is_closed)
      m_start = network.triangulation().head(network.halfedge(end_of_leg(network.first_segment(curve))));
    pull_straight();
    const std::vector<Vertex_index> thirds = apply(std::vector<Cut>(n, Cut{{1.0 / 3, 2.0 / 3}, true}));
    m_start = thirds.front();
    const std::size_t corners = is_closed ? n : n - 1;
    m_legs.assign(n + corners + (is_closed ? 0 : 2), {}); // the middle thirds, the corners and the outer thirds
    pull_straight();

    std::vector<Cut> cuts(m_legs.size());
    for(std::size_t i = 0; i < corners; ++i)
      cuts[2 * i + (is_closed ? 1 : 2)].places = {0.5};
    const std::vector<Vertex_index> joints = apply(cuts);
    if(is_closed)
      m_start = joints.front();
    m_legs.assign(3 * n, {});
    for(std::size_t i = 2; i < m_legs.size(); i += 3)
      m_legs[i].ends_piece = true;
    pull_straight();
  }

  // ---------------------------------------------------------------- along the curve

  std::size_t number_of_fixed_heads() const
  {
    std::size_t result = 0;
    m_network.for_each_segment(m_curve, [&](Segment_index s) { result += m_network.is_head_fixed(s) ? 1 : 0; });
    return result;
  }

  // That of the first leg; on a closed curve, it leaves the start.
  Segment_index first_segment() const
  {
    if(!m_network.is_closed(m_curve))
      return m_network.first_segment(m_curve);
    Segment_index result;
    m_network.for_each_segment(m_curve, [&](Segment_index s) {
      const bool is_start =
          m_network.is_head_fixed(s) && m_network.triangulation().head(m_network.halfedge(s)) == m_start;
      result = is_start ? m_network.next(s) : result;
    });
    return result;
  }

  // The last segment of the leg that s is on.
  Segment_index end_of_leg(Segment_index s) const
  {
    while(!m_network.is_head_fixed(s))
      s = m_network.next(s);
    return s;
  }

  double length_of_leg(Segment_index s) const
  {
    double result = m_network.triangulation().length(m_network.halfedge(s));
    for(; !m_network.is_head_fixed(s); s = m_network.next(s))
      result += m_network.triangulation().length(m_network.halfedge(m_network.next(s)));
    return result;
  }

  // ---------------------------------------------------------------- dividing

  void pull_straight()
  {
    m_report = shorten(m_network);
    if(m_network.is_contracted(m_curve) || number_of_fixed_heads() != m_legs.size())
      throw Invalid_curve_error("a control polygon has a leg that shrinks to a point");
  }

  void check_exactly()
  {
    for(Curve_report& curve : m_report.curves)
      if(curve.status == Shortening_status::FLAT_FACES ||
         (curve.status == Shortening_status::LOCALLY_SHORTEST && curve.verdict != Certificate_verdict::NOT_CERTIFIED &&
          !is_locally_shortest(curve.verdict)))
        curve.status = Shortening_status::PRECISION_LIMIT;
  }

  // Divides the working legs, and joins halves of neighbours within a piece to the legs of the next level. Are there
  // any?
  bool divide_working_legs()
  {
    std::vector<Cut> cuts(m_legs.size());
    std::vector<Leg> next_legs;
    bool has_joined = false;
    for(std::size_t i = 0; i < m_legs.size(); ++i) {
      const Leg leg = m_legs[i];
      if(!leg.is_working) {
        next_legs.push_back(leg);
        continue;
      }
      const bool joins_previous = i > 0 && cuts[i - 1].frees_end;
      const bool joins_next = !leg.ends_piece && i + 1 < m_legs.size() && m_legs[i + 1].is_working;
      cuts[i] = {{0.5}, joins_next};
      has_joined = has_joined || joins_next;
      if(!joins_previous)
        next_legs.push_back({false, !joins_next}); // a leg alone is the last of its piece: its middle is on the curve
      next_legs.push_back({joins_next, leg.ends_piece});
    }
    apply(cuts);
    m_legs = next_legs;
    return has_joined;
  }

  /*
   * Divides the legs, in order, and frees their ends where asked. Returns the new vertices. A division can divide
   * segments elsewhere on the curve, those on the same edge: so nothing is kept of the curve but where we are.
   */
  std::vector<Vertex_index> apply(const std::vector<Cut>& cuts)
  {
    std::vector<Vertex_index> result;
    Segment_index s = first_segment();
    for(const Cut& cut : cuts) {
      double done = 0;
      const double length = length_of_leg(s);
      for(double place : cut.places) {
        s = m_network.next(divide_leg(s, place * length - done));
        result.push_back(m_network.triangulation().tail(m_network.halfedge(s)));
        done = place * length;
      }
      s = end_of_leg(s);
      if(cut.frees_end)
        free_head(s);
      s = m_network.next(s);
    }
    return result;
  }

  // Divides a leg at a distance from the tail of s; the segment that ends there.
  Segment_index divide_leg(Segment_index s, double distance)
  {
    for(;; s = m_network.next(s)) {
      const double length = m_network.triangulation().length(m_network.halfedge(s));
      constexpr double closest = internal::dividing_vertex;
      const double t = distance / length;
      if(t < 1 + closest || m_network.is_head_fixed(s)) {
        if(t > 1 - closest && !m_network.is_head_fixed(s)) {
          m_network.set_head_fixed(s, true);
          return s;
        }
        const Segment_index half = m_network.divide_segment(s, (std::min)((std::max)(t, closest), 1 - closest));
        m_network.set_head_fixed(half, true);
        return half;
      }
      distance -= length;
    }
  }

  void free_head(Segment_index s)
  {
    if(m_network.next(s) == null_index)
      return;
    m_network.set_head_fixed(s, false);
    const Halfedge_index h = m_network.halfedge(s);
    if(!m_network.is_non_crossing_at({Triangulation::twin(h), s})) {
      m_network.set_head_fixed(s, true);
      throw Crossing_curves_error("a strand crosses the control polygon at vertex " +
                                      std::to_string(m_network.triangulation().head(h).idx()),
                                  {static_cast<std::size_t>(m_network.triangulation().head(h).idx())});
    }
  }

  Network& m_network;
  Curve_index m_curve;
  Vertex_index m_start = null_index; // a control point, on closed curves the first
  std::vector<Leg> m_legs;
  Shortening_report m_report;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_SPLINE_H
