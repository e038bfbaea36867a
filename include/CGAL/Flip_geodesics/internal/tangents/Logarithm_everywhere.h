// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_LOGARITHM_EVERYWHERE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_LOGARITHM_EVERYWHERE_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/distances/Source_directions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/tangents/Place_frame.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * Evaluates a `Logarithmic_map` at many points: a path to a point consists of the path to the vertex at which it bends
 * last and a straight segment, so only that segment is new. If windows do not determine it, or a path could be
 * shortened, the logarithmic map itself is evaluated.
 */
template <class Triangulation>
class Logarithm_everywhere
{
  using Vector = std::complex<double>;
  using Frame = Place_frame<Triangulation>;

public:
  /* The polar coordinates of a path at the source, and the direction at its end to which its direction there is
   * transported. */
  struct Arrival
  {
    Polar_coordinates polar;
    double carried; // an angle from the reference halfedge of the point
  };

  /* \param source that of the logarithmic map */
  Logarithm_everywhere(const Triangulation& triangulation, const Logarithmic_map<Triangulation>& logarithm,
                       const Surface_location& source)
    : m_triangulation(triangulation)
    , m_logarithm(logarithm)
    , m_source(triangulation, canonical_location(triangulation.input(), source))
    , m_field(logarithm.distance_field())
    , m_legs(query_of(m_field))
    , m_vertices(static_cast<std::size_t>(triangulation.input().number_of_vertices()))
  {
  }

  /* Returns the coordinates of a vertex of the input. */
  Polar_coordinates operator()(Vertex_index v)
  {
    std::vector<std::pair<Vertex_index, std::optional<Straight_leg>>> open; // each is the root of the previous one
    for(std::optional<Vertex_index> w = v; w && !m_vertices[*w];) {
      open.emplace_back(*w, leg_to(*w));
      const auto& leg = open.back().second;
      w = leg && is_vertex(leg->root) ? std::optional(Vertex_index(leg->root)) : std::nullopt;
    }
    for(; !open.empty(); open.pop_back())
      m_vertices[open.back().first] = end_at(open.back().first, open.back().second);
    return m_vertices[v]->polar;
  }

  /* Returns the arrival at a point inside the face of h. */
  Arrival operator()(Input_halfedge_index h, const Face_weights& weights)
  {
    const Surface_location location = {h, weights};
    const std::optional<Straight_leg> leg = m_legs.leg(h, weights);
    if(const auto on = leg ? continued(*leg) : std::nullopt; on && on->polar.radius < m_field.reach()) {
      const Vector arriving = leg->end * direction_of_side(m_triangulation, h, leg->last);
      return {on->polar, std::arg(arriving) + on->bend};
    }
    const Polar_coordinates p = m_logarithm(location);
    return {p, p.radius > 0 && p.radius < infinity ? m_logarithm.transported(location, p.angle).angle : 0};
  }

private:
  static constexpr double pi = boost::math::constants::pi<double>();
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // A vertex at which paths can bend. Directions are positions in its `Place_frame`.
  struct End
  {
    Polar_coordinates polar;
    double back = std::numeric_limits<double>::quiet_NaN(); // the direction from which the path comes; NaN if unknown
    double carried = 0;                                     // the transported direction of the path at the source
  };

  // A path with an additional segment, and the angle between that and the transported direction of the path at the
  // source.
  struct Continued
  {
    Polar_coordinates polar;
    double bend;
  };

  const auto& input() const { return m_triangulation.input(); }
  bool is_vertex(Index root) const { return root < input().number_of_vertices(); }
  Frame frame(Vertex_index v) const { return {m_triangulation, {input().outgoing(v), {{1, 0, 0}}}}; }

  std::optional<Straight_leg> leg_to(Vertex_index v)
  {
    const bool has_leg = m_field.distance(v) < infinity && m_field.distance(v) > 0;
    return has_leg ? m_legs.leg(v) : std::nullopt;
  }

  End end_at(Vertex_index v, const std::optional<Straight_leg>& leg)
  {
    End result;
    if(m_field.distance(v) == 0)
      result.polar.radius = 0;
    if(result.polar.radius == 0 || !(m_field.distance(v) < infinity))
      return result;
    const Frame here = frame(v);
    if(leg)
      result.back = here.position(leg->last, -leg->end);
    if(const auto on = leg ? continued(*leg) : std::nullopt) {
      result.polar = on->polar;
      result.carried = result.back + (on->bend + pi) / here.stretch();
      return result;
    }
    result.polar = m_logarithm(v);
    const Surface_direction end = m_logarithm.transported(m_triangulation.location(v), result.polar.angle);
    result.carried = here.position(end.halfedge) + end.angle;
    return result;
  }

  // Returns nothing if the path can be shortened at the start of the segment.
  std::optional<Continued> continued(const Straight_leg& leg)
  {
    const double length = std::abs(leg.end);
    if(!is_vertex(leg.root) || (*this)(Vertex_index(leg.root)).radius == 0)
      return Continued{{length, m_source.angle(m_source.position(leg.first, leg.start), m_logarithm.halfedge())}, 0};
    const Vertex_index v(leg.root);
    const End& end = *m_vertices[v];
    const Vertex_fan directions = umbrella_of(m_triangulation, input().outgoing(v));
    const double on = directions.angle_of(leg.first, v) + std::arg(leg.start);
    const double wedge =
        (std::min)(directions.counterclockwise(on, end.back), directions.counterclockwise(end.back, on));
    if(!(wedge >= pi - unfolded_place_error))
      return std::nullopt;
    const double bend = end.carried - on;
    return Continued{{end.polar.radius + length, end.polar.angle},
                     directions.has_border() ? bend : std::remainder(2 * pi / directions.total() * bend, 2 * pi)};
  }

  const Triangulation& m_triangulation;
  const Logarithmic_map<Triangulation>& m_logarithm;
  Frame m_source;
  const Geodesic_distance_field<Triangulation>& m_field;
  Source_directions<Triangulation> m_legs;
  Indexed_by<Vertex_index, std::vector<std::optional<End>>> m_vertices;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_LOGARITHM_EVERYWHERE_H
