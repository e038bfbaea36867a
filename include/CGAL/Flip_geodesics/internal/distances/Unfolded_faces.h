// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_UNFOLDED_FACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_UNFOLDED_FACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * A double-double number for algorithms written for doubles: it is converted from a double, compared, and infinite
 * whenever a double would be. The second halves of infinite numbers are zero; `Double_double` would make them NaN, and
 * then the first halves as well.
 */
class Precise_number
{
public:
  Precise_number() = default;
  Precise_number(double number)
    : m_value{number, 0}
  {
  }
  explicit Precise_number(const Double_double& value)
    : m_value(value)
  {
  }

  /* Returns the nearest double. */
  double nearest() const { return m_value.high; }

  friend Precise_number operator-(const Precise_number& a) { return Precise_number(-a.m_value); }
  friend Precise_number operator+(const Precise_number& a, const Precise_number& b)
  {
    return finite(a.m_value + b.m_value, a.nearest() + b.nearest());
  }
  friend Precise_number operator-(const Precise_number& a, const Precise_number& b) { return a + -b; }
  friend Precise_number operator*(const Precise_number& a, const Precise_number& b)
  {
    return finite(a.m_value * b.m_value, a.nearest() * b.nearest());
  }
  friend Precise_number operator/(const Precise_number& a, const Precise_number& b)
  {
    const double quotient = a.nearest() / b.nearest();
    return std::isfinite(b.nearest()) ? finite(a.m_value / b.m_value, quotient) : Precise_number(quotient);
  }
  friend Precise_number sqrt(const Precise_number& a) { return finite(sqrt(a.m_value), a.nearest()); }
  friend Precise_number abs(const Precise_number& a) { return a < 0 ? -a : a; }

  friend bool operator<(const Precise_number& a, const Precise_number& b)
  {
    return a.m_value.high < b.m_value.high || (a.m_value.high == b.m_value.high && a.m_value.low < b.m_value.low);
  }
  friend bool operator==(const Precise_number& a, const Precise_number& b)
  {
    return a.m_value.high == b.m_value.high && a.m_value.low == b.m_value.low;
  }
  friend bool operator>(const Precise_number& a, const Precise_number& b) { return b < a; }
  friend bool operator<=(const Precise_number& a, const Precise_number& b) { return a < b || a == b; }
  friend bool operator>=(const Precise_number& a, const Precise_number& b) { return b <= a; }
  friend bool operator!=(const Precise_number& a, const Precise_number& b) { return !(a == b); }

private:
  // Returns a result or, if that is not finite, the result in doubles.
  static Precise_number finite(const Double_double& result, double in_double)
  {
    return std::isfinite(in_double) ? Precise_number(result) : Precise_number(in_double);
  }

  Double_double m_value;
};

using Precise_vector = Complex_number<Precise_number>;

/* The properties of number types required by algorithms for either kind. */
template <class Number>
struct Number_rounding;

template <>
struct Number_rounding<double>
{
  static constexpr double unit = unit_roundoff;
  static double nearest(double number) { return number; }
  static double below(double number) { return number; }
  static double above(double number) { return number; }
};

template <>
struct Number_rounding<Precise_number>
{
  // Bounds the relative errors of sides of faces (`Precise_face_traits`), and also those of 32 operations.
  static constexpr double unit = precise_direction_error;
  static double nearest(const Precise_number& number) { return number.nearest(); }

  /* Returns a double that is not larger. */
  static double below(const Precise_number& number)
  {
    return number.nearest() - 2 * Number_rounding<double>::unit * std::abs(number.nearest());
  }

  /* Returns a double that is not smaller. */
  static double above(const Precise_number& number) { return -below(-number); }
};

/*
 * The shapes of the input faces, for rays that are unfolded from face to face, and the vertices that shortest paths may
 * pass; each is computed on first use.
 *
 * A search passes a small part of a mesh, whose halfedges may be numbered in any order. The sides of the passed faces
 * are therefore renumbered in triples, in the order of their computation; a search stores its data of a halfedge under
 * this number, close to related data.
 *
 * Lengths and directions of sides are stored rather than coordinates of corners, since differences of coordinates would
 * lose the direction of a side that is short compared with the others.
 */
template <class Triangulation>
class Unfolded_faces
{
public:
  using Number = double;
  using Vector = std::complex<double>;

  /*
   * A halfedge, and the angle at its tail in the face on its left. The direction (cosine, sine) is off by at most 18 u:
   * the rounding of two vectors in space turns them by 2 u; a scalar product is off by 3 u of the product of the
   * lengths, and a vector product by 2.5 u of it and 2.5 u of itself. Quotients add 1 u, and lengths 6 u along the
   * direction only. This makes 9 u for the first two directions of a face. The third one is computed from the product
   * of these two vectors and is off by up to 17 u across the direction.
   */
  struct Side
  {
    double length, cosine, sine;
    Input_halfedge_index halfedge;
    Vertex_index tail;
    Index twin = -1; // the number of the twin halfedge, if its face has been computed
  };

  /* A direction from a vertex: an angle from a halfedge that leaves it, in the face on the left. */
  struct Direction
  {
    Input_halfedge_index halfedge;
    double angle;
  };

  explicit Unfolded_faces(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_number(static_cast<std::size_t>(triangulation.number_of_halfedges()))
    , m_shapes(static_cast<std::size_t>(triangulation.number_of_vertices()))
  {
  }

  /* Returns the number of h as a side. \pre h is not on the border
   * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error */
  Index number(Input_halfedge_index h)
  {
    if(m_number[h] == 0)
      lay_out(h);
    return m_number[h] - 1;
  }

  /* Returns the number of h as a side if its face has been computed, otherwise -1; also for the twin halfedge. */
  Index known_number(Input_halfedge_index h) const { return m_number[h] - 1; }
  Index known_twin(Index side) const { return (*this)[side].twin; }

  const Side& operator[](Index side) const { return m_sides[static_cast<std::size_t>(side)]; }
  static Index next(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index previous(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

  /* Returns the largest number plus one. */
  std::size_t size() const { return m_sides.size(); }

  /* Returns the corner opposite to a side that extends from 0 to its length on the real axis. */
  Vector apex(Index side) const
  {
    const Side& s = (*this)[side];
    return (*this)[previous(side)].length * Vector{s.cosine, s.sine};
  }

  double length(Input_halfedge_index h) const { return m_triangulation.metric().length(m_triangulation.input(), h); }

  /* Returns the faces that classify vertices and measure angles, for any type of numbers. */
  Unfolded_faces& in_double() { return *this; }

  /*
   * Returns whether a shortest path may pass the vertex: only on the border and if the angles add up to more than 2 pi,
   * or nearly so.
   */
  bool is_passable(Vertex_index v) { return shape(v) != CONVEX; }

  /* Returns whether the angles nearly add up to 2 pi. */
  bool is_flat(Vertex_index v) { return shape(v) == FLAT; }

  /* Returns the distance from a vertex to the nearest edge opposite to it. */
  double nearest_edge(Vertex_index v)
  {
    const auto& input = m_triangulation.input();
    double nearest = std::numeric_limits<double>::infinity();
    for_each_outgoing_halfedge(input, v, [&](Input_halfedge_index h) {
      if(!input.is_border(h))
        nearest = (std::min)(nearest, apex(next(number(h))).imag());
    });
    return nearest;
  }

  /* Returns the smaller angle between two directions from a vertex, zero if it is less than a tolerance; infinite if
   * they are in different umbrellas. */
  double angle_between(const Direction& a, const Direction& b, double tolerance)
  {
    const auto corner = [this](Input_halfedge_index h) { // of the face on the left
      const Side& side = m_sides[static_cast<std::size_t>(number(h))];
      return std::atan2(side.sine, side.cosine);
    };
    Vertex_fan fan;
    fan.collect_umbrella(m_triangulation.input(), a.halfedge, corner);
    if(!fan.has(b.halfedge))
      return std::numeric_limits<double>::infinity();
    const Vertex_index v = m_triangulation.input().tail(a.halfedge);
    const double angle =
        fan.smaller_wedge(fan.angle_of(a.halfedge, v) + a.angle, fan.angle_of(b.halfedge, v) + b.angle);
    return angle < tolerance ? 0 : angle;
  }

private:
  enum Shape : char { UNKNOWN, CONVEX, FLAT, OTHER };

  Shape shape(Vertex_index v)
  {
    Shape& known = m_shapes[v];
    if(known == UNKNOWN)
      known = compute_shape(v);
    return known;
  }

  void lay_out(Input_halfedge_index h)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index hn = input.next(h), hp = input.next(hn);
    const auto vectors = input_face_geometry(m_triangulation, h);
    const Vector a(vectors[0].x, vectors[0].y), b(vectors[1].x, vectors[1].y), c(vectors[2].x, vectors[2].y);
    const double la = a.real(), lb = std::sqrt(std::norm(b)), lc = std::sqrt(std::norm(c));
    // The angles of degenerate faces count as well, and rays pass such faces.
    const double height = (std::max)(b.imag(), least_face_height * la);
    add({la, -c.real() / lc, height / lc, h, input.tail(h)});
    add({lb, -b.real() / lb, height / lb, hn, input.tail(hn)});
    // The sine of a small angle would be lost in a product of the vectors.
    const double product = b.real() * c.real() + b.imag() * c.imag();
    add({lc, -product / (lb * lc), la * height / (lb * lc), hp, input.tail(hp)});
  }

  void add(const Side& side)
  {
    const Index number = static_cast<Index>(m_sides.size()), twin = known_number(twin_index(side.halfedge));
    m_sides.push_back(side);
    m_sides.back().twin = twin;
    if(twin >= 0)
      m_sides[static_cast<std::size_t>(twin)].twin = number;
    m_number[side.halfedge] = number + 1;
  }

  Shape compute_shape(Vertex_index v)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index first = input.outgoing(v);
    Angle_sum sum;
    Input_halfedge_index h = first;
    do {
      if(input.is_border(h))
        return OTHER;
      const Side& side = m_sides[static_cast<std::size_t>(number(h))];
      sum.add({side.cosine, side.sine});
      h = counterclockwise_of(input, h);
    } while(h != first);
    const double excess = sum.value() - boost::math::constants::two_pi<double>();
    return std::abs(excess) < full_turn_tolerance ? FLAT : (excess < 0 ? CONVEX : OTHER);
  }

  const Triangulation& m_triangulation;
  Indexed_by<Input_halfedge_index, Lazy_array<Index>> m_number; // plus 1, for sides of computed faces
  std::vector<Side> m_sides;
  Indexed_by<Vertex_index, Lazy_array<Shape>> m_shapes;
};

/*
 * The faces of `Unfolded_faces`, with the same numbers, in double-double arithmetic: lengths and directions of sides
 * err by at most `Number_rounding<Precise_number>::unit`. The classification of vertices does not require it.
 */
template <class Triangulation>
class Precise_unfolded_faces
{
  using Faces = Unfolded_faces<Triangulation>;

public:
  using Number = Precise_number;
  using Vector = Precise_vector;

  /* A halfedge, and the angle at its tail in the face on its left. */
  struct Side
  {
    Number length, cosine, sine;
    Input_halfedge_index halfedge;
    Vertex_index tail;
    bool is_known = false;
  };

  Precise_unfolded_faces(const Triangulation& triangulation, Faces& faces)
    : m_triangulation(triangulation)
    , m_faces(faces)
  {
  }

  /* Returns the number of h as a side. \pre h is not on the border
   * \throws Degenerate_face_error also for a face whose numbers have no bound; otherwise as `Unfolded_faces` */
  Index number(Input_halfedge_index h)
  {
    const Index side = m_faces.number(h);
    if(m_sides.size() < m_faces.size())
      m_sides.resize(m_faces.size(), Side());
    if(!(*this)[side].is_known)
      for(const Index s : {next(side), previous(side), side})
        lay_out(s);
    return side;
  }

  /* \pre its face has been computed, which `number()` does */
  const Side& operator[](Index side) const { return m_sides[static_cast<std::size_t>(side)]; }
  static Index next(Index side) { return Faces::next(side); }
  static Index previous(Index side) { return Faces::previous(side); }
  std::size_t size() const { return m_sides.size(); }

  Vector apex(Index side) const
  {
    const Side& s = (*this)[side];
    return (*this)[previous(side)].length * Vector{s.cosine, s.sine};
  }

  Number length(Input_halfedge_index h)
  {
    return (*this)[number(m_triangulation.input().is_border(h) ? twin_index(h) : h)].length;
  }

  Faces& in_double() { return m_faces; }

private:
  // The direction of the next halfedge is rotated by the outer angle at the head; the inner one is that at the next
  // tail.
  void lay_out(Index number)
  {
    const auto& before = m_faces[previous(number)];
    const auto& here = m_faces[number];
    const Precise_halfedge side = precise_input_halfedge(m_triangulation, here.halfedge);
    const Precise_halfedge turn = precise_input_halfedge(m_triangulation, before.halfedge);
    if(!(side.error <= Number_rounding<Number>::unit && turn.error <= Number_rounding<Number>::unit))
      throw Degenerate_face_error("a face has a side that is so long or so short that its rounding error cannot be "
                                  "bounded; scale or repair the mesh",
                                  {});
    m_sides[static_cast<std::size_t>(number)] = {
        Number(side.length), -Number(turn.next.x), Number(turn.next.y), here.halfedge, here.tail, true};
  }

  const Triangulation& m_triangulation;
  Faces& m_faces;
  Block_array<Side> m_sides;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_UNFOLDED_FACES_H
