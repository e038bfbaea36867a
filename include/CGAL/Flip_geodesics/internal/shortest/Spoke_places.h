// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SPOKE_PLACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SPOKE_PLACES_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/triangulation/normal_coordinates.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Where a halfedge starts among those of the input: counterclockwise of one, in the face on its left, or along it. */
struct Spoke_place
{
  Input_halfedge_index reference = null_index;
  double angle = 0;
  bool is_along = false;
};

/*
 * Where the halfedges of a triangulation at a vertex of the input start, told one from the next: in which corner by
 * counting the input edges that start in between, at which angle there by the lengths that the triangulation has.
 */
template <class Triangulation>
class Spoke_places
{
public:
  explicit Spoke_places(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* The place of one of the halfedges around a vertex, and its number: of an edge of the input, if there is one, or
   * else of the one that crosses least. */
  Spoke_place known_place(const std::vector<Halfedge_index>& around, std::size_t& number) const
  {
    const auto is_of_input = [this](Halfedge_index h) { return m_triangulation.version(Triangulation::edge(h)) == 0; };
    const auto crosses_less = [this](Halfedge_index g, Halfedge_index h) { return crossings(g) < crossings(h); };
    const auto of_input = std::find_if(around.begin(), around.end(), is_of_input);
    const bool is_known = of_input != around.end();
    const auto nearest = is_known ? of_input : std::min_element(around.begin(), around.end(), crosses_less);
    number = static_cast<std::size_t>(nearest - around.begin());
    if(is_known)
      return {as_input(*nearest), 0, true};
    const Crossing_word word = m_triangulation.crossing_word(*nearest);
    const Strip<Triangulation> strip(m_triangulation, word);
    return {strip.reference(), angle_from_reference(strip.end()), word.along != null_index};
  }

  /* From the place of the spoke before to that of h, the next one clockwise, over the input edges that start in
   * between. */
  void turn_clockwise(Halfedge_index h, Spoke_place& place) const
  {
    const Halfedge_index opposite = m_triangulation.next(h), before = m_triangulation.next(opposite);
    const Index between = Triangle_crossings(crossings(opposite), crossings(before), crossings(h)).emanating[0];
    for(Index i = place.is_along ? 0 : 1; i <= between && place.reference != null_index; ++i)
      pass_input_edge(place);
    place.angle -= corner(m_triangulation.length(h), m_triangulation.length(opposite), m_triangulation.length(before));
    place.is_along = crossings(h) < 0;
    place.angle = place.is_along ? 0 : place.angle;
  }

private:
  Index crossings(Halfedge_index h) const { return m_triangulation.crossings(Triangulation::edge(h)); }

  void pass_input_edge(Spoke_place& place) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index t = twin_index(place.reference);
    place.reference = input.is_border(t) ? Input_halfedge_index(null_index) : clockwise_of(input, place.reference);
    if(place.reference != null_index)
      place.angle += input_corner(m_triangulation, input.next(input.next(place.reference)));
  }

  // The angle of a face between its first edge and its last one, from their lengths.
  static double corner(double first, double opposite, double last)
  {
    using Double_traits = Intrinsic_triangulation_traits<typename Triangulation::Metric::Kernel>;
    const auto face = Double_traits().construct_face_from_lengths_object()(first, opposite, last);
    return std::atan2(-face[2].y, -face[2].x);
  }

  const Triangulation& m_triangulation;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_SPOKE_PLACES_H
