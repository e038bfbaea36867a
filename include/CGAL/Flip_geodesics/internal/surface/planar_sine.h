// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_PLANAR_SINE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_PLANAR_SINE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/Orientation_of_places.h>
#include <CGAL/Flip_geodesics/internal/numbers/Rational_places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/point_coordinates.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A line over walls: faces that bend along parallel edges only, the rulings, as those of an extrusion or a prism. They
 * are unrolled into a plane with the direction of the rulings as one axis. There the line leads up by the difference of
 * two places along that direction, a rational number; and sideways by the distances from ruling to ruling, a sum of
 * roots.
 */
template <class Place>
struct Unrolled_line
{
  std::vector<Place> places; // its start, one on each ruling that it crosses, and its end
  Sign side = ZERO;          // POSITIVE if it leads to the right of the rulings' direction
  Sign height = ZERO;        // POSITIVE if it leads along that direction
};

/* The sign of the sine of the angle clockwise from one line to another, over walls with rulings of some direction. */
template <class Place>
class Unrolled_sine
{
  using Unrolled_line = internal::Unrolled_line<Place>;

public:
  /* From one place to another along the rulings' direction. */
  Unrolled_sine(const Place& from, const Place& to)
    : m_from(from)
    , m_to(to)
  {
  }

  /* Uncertain if the default limit of work is met. */
  Uncertain<Sign> operator()(const Unrolled_line& a, const Unrolled_line& b) const
  {
    const Sign first = a.height * b.side, second = CGAL::opposite(b.height * a.side);
    if(first == second || second == ZERO)
      return first;
    if(first == ZERO)
      return second;
    const Bounded left = product(a, b), right = product(b, a);
    const double difference = (left.value - right.value).high;
    if(std::abs(difference) > 2 * (left.error + right.error))
      return difference > 0 ? first : second;
    return exact(a, b);
  }

private:
  // Values that are not negative, and bounds of their errors, up to rounding of the bounds.
  struct Bounded
  {
    Double_double value;
    double error;
  };

  using Precise_vector = std::array<Double_double, 3>;

  // Differences err by 2^-106 at most, and a product of two vectors by less than 30 double_double_error of their
  // lengths.
  static constexpr double unit = 64 * double_double_error;

  static Double_double dot(const Precise_vector& u, const Precise_vector& v)
  {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }

  // What the error of a product is relative to; infinite where what underflows may show.
  static double size_of_product(const Precise_vector& u, const Precise_vector& v)
  {
    const auto length = [](const Precise_vector& w) { return std::hypot(w[0].high, w[1].high, w[2].high); };
    const double size = length(u) * length(v);
    return size == 0 || (size > least_unscaled && size < greatest_unscaled) ? size
                                                                            : std::numeric_limits<double>::infinity();
  }

  // How far a line leads up, times how far another one leads sideways.
  Bounded product(const Unrolled_line& up, const Unrolled_line& sideways) const
  {
    const Bounded h = height(up), w = width(sideways);
    const Double_double value = h.value * w.value;
    return {value, h.value.high * w.error + h.error * w.value.high + h.error * w.error + unit * value.high};
  }

  Bounded height(const Unrolled_line& line) const
  {
    const Precise_vector u = precise_difference(m_from, m_to),
                         v = precise_difference(line.places.front(), line.places.back());
    const Double_double value = dot(u, v);
    return {value.high < 0 ? -value : value, unit * size_of_product(u, v)};
  }

  Bounded width(const Unrolled_line& line) const
  {
    const Precise_vector u = precise_difference(m_from, m_to);
    Bounded sum = {{0, 0}, 0};
    for(std::size_t i = 1; i < line.places.size(); ++i) {
      const Precise_vector v = precise_difference(line.places[i - 1], line.places[i]),
                           cross = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      sum.value = sum.value + internal::sqrt(dot(cross, cross));
      sum.error += unit * (size_of_product(u, v) + sum.value.high);
    }
    return sum;
  }

  // ---------------------------------------------------------------- in integers

  using Vector = std::array<Integer, 3>;

  static Vector difference(const Integer* p, const Integer* q) { return {q[0] - p[0], q[1] - p[1], q[2] - p[2]}; }

  Uncertain<Sign> exact(const Unrolled_line& a, const Unrolled_line& b) const
  {
    std::vector<Place> places = {m_from, m_to};
    for(const Unrolled_line* line : {&a, &b})
      places.insert(places.end(), line->places.begin(), line->places.end());
    std::vector<Integer> integers(3 * places.size());
    to_integers(places.data(), places.size(), integers.data());
    const Vector u = shortened(difference(&integers[0], &integers[3]));
    const Integer *of_a = &integers[6], *of_b = of_a + 3 * a.places.size();
    Root_sum sum;
    add_widths(u, of_b, b, height(u, of_a, a), sum);
    add_widths(u, of_a, a, -height(u, of_b, b), sum);
    Work_limit work;
    return sum.sign(work);
  }

  static Vector shortened(Vector v)
  {
    const Integer common = boost::multiprecision::gcd(boost::multiprecision::gcd(v[0], v[1]), v[2]);
    for(Integer& x : v)
      x /= common;
    return v;
  }

  static Integer height(const Vector& u, const Integer* places, const Unrolled_line& line)
  {
    const Vector v = difference(places, places + 3 * (line.places.size() - 1));
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }

  static void add_widths(const Vector& u, const Integer* places, const Unrolled_line& line, const Integer& factor,
                         Root_sum& sum)
  {
    for(std::size_t i = 1; i < line.places.size(); ++i, places += 3) {
      const Vector v = difference(places, places + 3);
      Integer square = 0;
      for(std::size_t k = 0; k < 3; ++k) {
        const Integer c = u[k] * v[(k + 1) % 3] - u[(k + 1) % 3] * v[k];
        square += c * c;
      }
      sum.add(line.side == POSITIVE ? factor : Integer(-factor), square);
    }
  }

  Place m_from, m_to;
};

/*
 * The sign of the sine of a wedge whose input faces lie unfolded in one plane of space, by exact predicates of points;
 * or which bend along parallel edges only, so that they are unrolled into a plane. These are the common cases of exact
 * ties: the flat parts of technical models, and their walls.
 *
 * PlaceOf maps an input vertex to three double coordinates or to a `Rational_place`. Edge sequences with an end
 * elsewhere are left to others, since the coordinates of such a point are neither.
 */
template <class Mesh, class PlaceOf>
class Planar_sine
{
  using Place = decltype(std::declval<const PlaceOf&>()(Vertex_index()));
  using Exact_vector =
      std::conditional_t<std::is_same<Place, Rational_place>::value, Rational_vector, internal::Exact_vector>;
  using Halfedges = std::vector<Input_halfedge_index>;

public:
  Planar_sine(const Mesh& mesh, PlaceOf place_of, Flat_edges& flat_edges)
    : m_mesh(mesh)
    , m_place_of(place_of)
    , m_flat_edges(flat_edges)
  {
  }

  /*
   * The wedge leads from the direction of edge sequence a clockwise over `steps` input corners to that of edge sequence
   * b, and is below 2 pi. Returns false, and no sign, if its faces do not lie so.
   */
  bool operator()(const Edge_sequence& a, const Edge_sequence& b, Index steps, Sign& sine) const
  {
    const Vertex_index ends(m_mesh.number_of_vertices());
    if(a.tail >= ends || a.head >= ends || b.head >= ends)
      return false;
    Halfedges bends_of_a, bends_of_b, others;
    Input_halfedge_index bend = null_index;
    if(!add_bends(a, bend, bends_of_a) || !add_bends(b, bend, bends_of_b))
      return false;
    Input_halfedge_index h = reference(a);
    const Input_halfedge_index first_face = a.along != null_index ? twin_index(h) : h;
    for(Index i = 0; i < steps; ++i, h = m_mesh.next(twin_index(h))) {
      const bool is_start = i == 0 && a.along != null_index;
      if(!is_start && !add_bend(h, bend, others))
        return false;
    }
    if(bend == null_index)
      return sine_in_plane(a, b, first_face, sine);
    return sine_over_walls({a, first_face, bends_of_a}, {b, reference(b), bends_of_b}, bend, sine);
  }

private:
  // An edge sequence, a halfedge of its first face, and the edges on its way along which the faces bend.
  struct Line
  {
    const Edge_sequence& sequence;
    Input_halfedge_index first_face;
    const Halfedges& bends;
  };

  bool sine_in_plane(const Edge_sequence& a, const Edge_sequence& b, Input_halfedge_index face, Sign& sine) const
  {
    const Place node = place_of_tail(reference(a)), end_a = m_place_of(head(a)), end_b = m_place_of(head(b));
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const Sign side = side_of_face(axis, face);
      if(side == ZERO)
        continue;
      sine = side * orientation_along(axis, node, end_b, end_a);
      return true;
    }
    return false;
  }

  bool sine_over_walls(const Line& a, const Line& b, Input_halfedge_index bend, Sign& sine) const
  {
    Unrolled_line<Place> line_a, line_b;
    if(!unroll(a, bend, line_a) || !unroll(b, bend, line_b))
      return false;
    const Uncertain<Sign> result =
        Unrolled_sine<Place>(place_of_tail(bend), place_of_tail(twin_index(bend)))(line_a, line_b);
    sine = result.is_certain() ? result.make_certain() : ZERO;
    return result.is_certain();
  }

  // Returns false if the numbers are too small or too large, or the line turns back.
  bool unroll(const Line& line, Input_halfedge_index bend, Unrolled_line<Place>& result) const
  {
    result.places.push_back(place_of_tail(reference(line.sequence)));
    for(Input_halfedge_index h : line.bends)
      result.places.push_back(place_of_tail(h));
    result.places.push_back(m_place_of(head(line.sequence)));
    const Exact_vector up = vector(bend), way(result.places.front(), result.places.back());
    if(!up.has_exact_products() || !way.has_exact_products())
      return false;
    result.height = sign_of_dot(up, way);
    for(std::size_t i = 1; i < result.places.size(); ++i) {
      const Exact_vector part(result.places[i - 1], result.places[i]);
      if(!part.has_exact_products())
        return false;
      const Sign side = side_of_part(up, part, i == 1 ? line.first_face : twin_index(line.bends[i - 2]));
      if(side != ZERO && side == CGAL::opposite(result.side))
        return false;
      result.side = result.side == ZERO ? side : result.side;
    }
    return true;
  }

  // POSITIVE if a part of a line in the plane of a face leads to the right of a vector in that plane.
  Sign side_of_part(const Exact_vector& up, const Exact_vector& part, Input_halfedge_index face) const
  {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const Sign turn = sign_of_cross(part, up, axis);
      if(turn != ZERO)
        return turn * side_of_face(axis, face);
    }
    return ZERO;
  }

  // Of the input edges that an edge sequence crosses; returns false if they do not all bend along parallel edges.
  bool add_bends(const Edge_sequence& sequence, Input_halfedge_index& bend, Halfedges& bends) const
  {
    for(Input_halfedge_index h : sequence.crossed)
      if(!add_bend(h, bend, bends))
        return false;
    return true;
  }

  bool add_bend(Input_halfedge_index h, Input_halfedge_index& bend, Halfedges& bends) const
  {
    if(is_flat_across(h))
      return true;
    if(bend == null_index ? !is_sharp(h) : !is_parallel(bend, h))
      return false;
    bend = bend == null_index ? h : bend;
    bends.push_back(h);
    return true;
  }

  // Do the faces beside an edge bend by more than rounding? Where they do not, others will, along edges that are not
  // parallel, and to look at them takes longer than to leave it to vectors.
  bool is_sharp(Input_halfedge_index h) const
  {
    const Exact_vector u = vector(h), v(place_of_tail(h), m_place_of(apex(h))),
                       w(place_of_tail(h), m_place_of(apex(twin_index(h))));
    double height = 0, size = 0, folded = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
      const double normal = u[k] * v[l] - u[l] * v[k];
      height += normal * w[i];
      size += std::abs(normal * w[i]);
      folded += normal * (u[k] * w[l] - u[l] * w[k]);
    }
    return folded > 0 || !(std::abs(height) < flat_bend * size);
  }

  bool is_parallel(Input_halfedge_index g, Input_halfedge_index h) const
  {
    const Exact_vector u = vector(g), v = vector(h);
    return u.has_exact_products() && v.has_exact_products() && are_parallel(u, v);
  }

  Exact_vector vector(Input_halfedge_index h) const { return {place_of_tail(h), place_of_tail(twin_index(h))}; }

  Place place_of_tail(Input_halfedge_index h) const { return m_place_of(m_mesh.tail(h)); }

  Input_halfedge_index reference(const Edge_sequence& sequence) const
  {
    return sequence.along != null_index ? sequence.along : m_mesh.next(m_mesh.next(sequence.crossed.front()));
  }

  Vertex_index head(const Edge_sequence& sequence) const
  {
    return sequence.along != null_index ? m_mesh.tail(twin_index(sequence.along))
                                        : apex(twin_index(sequence.crossed.back()));
  }

  Vertex_index apex(Input_halfedge_index h) const { return m_mesh.tail(m_mesh.next(m_mesh.next(h))); }

  Place corner(Input_halfedge_index h, int i) const
  {
    for(; i > 0; --i)
      h = m_mesh.next(h);
    return m_place_of(m_mesh.tail(h));
  }

  bool is_flat(const Edge_sequence& sequence) const
  {
    for(Input_halfedge_index h : sequence.crossed)
      if(!is_flat_across(h))
        return false;
    return true;
  }

  bool is_flat_across(Input_halfedge_index h) const
  {
    return m_flat_edges(h, [&] { return lies_in_one_plane(h); });
  }

  // Do the faces on both sides of an edge, unfolded?
  bool lies_in_one_plane(Input_halfedge_index h) const
  {
    const Place p = m_place_of(m_mesh.tail(h)), q = m_place_of(m_mesh.tail(twin_index(h)));
    const Place r = m_place_of(apex(h)), s = m_place_of(apex(twin_index(h)));
    return orientation(p, q, r, s) == ZERO && is_unfolded(p, q, r, s);
  }

  // Are r and s, which lie in one plane with p and q, on different sides of the line through these two?
  static bool is_unfolded(const Place& p, const Place& q, const Place& r, const Place& s)
  {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const Sign of_r = orientation_along(axis, p, q, r);
      if(of_r != ZERO)
        return orientation_along(axis, p, q, s) == -of_r;
    }
    return false;
  }

  // Which way a face is seen to turn, from where an axis leads to.
  Sign side_of_face(std::size_t axis, Input_halfedge_index h) const
  {
    return orientation_along(axis, corner(h, 0), corner(h, 1), corner(h, 2));
  }

  const Mesh& m_mesh;
  PlaceOf m_place_of;
  Flat_edges& m_flat_edges;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_PLANAR_SINE_H
