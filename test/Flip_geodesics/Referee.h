// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_REFEREE_H
#define FLIP_GEODESICS_TEST_REFEREE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/boost_mp.h>
#include <CGAL/number_utils.h>

#include <boost/multiprecision/mpfr.hpp>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

/*
 * Decides what the certified traits decide, by another route: it unfolds input faces in floats of 300 digits, as
 * positions of points, and walks around a vertex from corner to corner. It takes from the library the input mesh and
 * the crossing words, which are integers, and no number.
 */
namespace Flip_geodesics_test {

using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<300, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

struct Real_vector
{
  Real x, y;
};

inline Real_vector operator+(const Real_vector& u, const Real_vector& v) { return {u.x + v.x, u.y + v.y}; }
inline Real_vector operator-(const Real_vector& u, const Real_vector& v) { return {u.x - v.x, u.y - v.y}; }
inline Real_vector operator*(const Real_vector& u, const Real_vector& v)
{
  return {u.x * v.x - u.y * v.y, u.x * v.y + u.y * v.x};
}
inline Real_vector conjugate(const Real_vector& u) { return {u.x, -u.y}; }
inline Real squared_norm(const Real_vector& u) { return u.x * u.x + u.y * u.y; }

/// -1, 0 or 1: the sign of a number that is called zero below 1e-250 times a scale.
inline int sign_beside(const Real& number, const Real& scale)
{
  static const Real least("1e-250");
  if(boost::multiprecision::abs(number) <= least * scale)
    return 0;
  return number > 0 ? 1 : -1;
}

/// The sign of the sine from `u` to `v`, counterclockwise.
inline int turning(const Real_vector& u, const Real_vector& v)
{
  return sign_beside(u.x * v.y - u.y * v.x, boost::multiprecision::sqrt(squared_norm(u) * squared_norm(v)));
}

/// The shape of a face from its points: `next(h) / h` as complex numbers, the face on the upper side of `h`.
template <class Triangle_mesh>
class Shape_of_points
{
public:
  explicit Shape_of_points(const Triangle_mesh& mesh)
    : m_mesh(mesh)
  {
  }

  template <class Halfedge>
  Real_vector operator()(Halfedge h) const
  {
    const auto g = next(h, m_mesh);
    const Vector p = vector_of(source(h, m_mesh)), q = vector_of(target(h, m_mesh)), r = vector_of(target(g, m_mesh));
    const Vector u = difference(p, q), v = difference(q, r);
    const Real x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
    const Real base = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    return {(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / base,
            boost::multiprecision::sqrt(x * x + y * y + z * z) / base};
  }

  template <class Halfedge>
  Real length(Halfedge h) const
  {
    const Vector u = difference(vector_of(source(h, m_mesh)), vector_of(target(h, m_mesh)));
    return boost::multiprecision::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  }

private:
  using Vector = std::array<Real, 3>;

  template <class Vertex>
  Vector vector_of(Vertex v) const
  {
    const auto p = get(CGAL::vertex_point, m_mesh, v);
    return {Real(CGAL::to_double(p.x())), Real(CGAL::to_double(p.y())), Real(CGAL::to_double(p.z()))};
  }

  static Vector difference(const Vector& p, const Vector& q) { return {q[0] - p[0], q[1] - p[1], q[2] - p[2]}; }

  const Triangle_mesh& m_mesh;
};

/// The same from the lengths of edges, in a property map.
template <class Triangle_mesh, class LengthMap>
class Shape_of_lengths
{
public:
  Shape_of_lengths(const Triangle_mesh& mesh, LengthMap lengths)
    : m_mesh(mesh)
    , m_lengths(lengths)
  {
  }

  template <class Halfedge>
  Real_vector operator()(Halfedge h) const
  {
    const Real a = length(h), b = length(next(h, m_mesh)), c = length(next(next(h, m_mesh), m_mesh));
    const Real square = (a + b + c) * (a + b - c) * (b + c - a) * (c + a - b); // Heron
    return {(c * c - a * a - b * b) / (2 * a * a), boost::multiprecision::sqrt(square) / (2 * a * a)};
  }

  template <class Halfedge>
  Real length(Halfedge h) const
  {
    return Real(get(m_lengths, edge(h, m_mesh)));
  }

private:
  const Triangle_mesh& m_mesh;
  LengthMap m_lengths;
};

/// Two intrinsic edges leave a vertex in one direction, in a degenerate face: no angle can be told from their words.
struct No_order : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

template <class Triangulation, class Shape>
class Referee
{
  using Halfedge_index = CGAL::Flip_geodesics::Halfedge_index;
  using Input_halfedge_index = CGAL::Flip_geodesics::Input_halfedge_index;

public:
  using Word = decltype(std::declval<const Triangulation&>().edge_sequence(Halfedge_index()));

  Referee(const Triangulation& triangulation, const Shape& shape)
    : m_triangulation(triangulation)
    , m_shape(shape)
  {
  }

  /*!
   * Compares the angle clockwise from halfedge `from` to halfedge `to` of the triangulation with pi: -1, 0 or 1.
   * `from == to` means all the way round. \pre no border in between \throws No_order
   */
  int compare_wedge(Halfedge_index from, Halfedge_index to)
  {
    Sum sum;
    for(const Real_vector& angle : angles(from, to))
      sum.add(angle);
    return sum.comparison();
  }

  /// The same wedge as a rotation, up to a positive factor.
  Real_vector rotation(Halfedge_index from, Halfedge_index to)
  {
    Real_vector result = {1, 0};
    for(const Real_vector& angle : angles(from, to))
      result = result * angle;
    return result;
  }

  /// Does the straight line from tail to head of a word pass strictly between the ends of each edge that it crosses?
  bool is_straight(const Word& word)
  {
    const Layout strip = layout(word);
    for(const auto& [right, left] : strip.portals)
      if(turning(strip.end, left) <= 0 || turning(right, strip.end) <= 0)
        return false;
    return true;
  }

  /// The length of a word.
  Real length(const Word& word)
  {
    if(word.along.is_valid())
      return length_of(word.along.idx());
    const Layout strip = layout(word);
    return boost::multiprecision::sqrt(squared_norm(strip.end)) * length_of(strip.right_outgoing_halfedge);
  }

private:
  // In the frame in which the spoke on the right, an input halfedge at the tail, is 1; left_spoke bounds the first face
  // on the other side. An edge along an input halfedge is both.
  struct Layout
  {
    bool is_edge;
    int right_outgoing_halfedge, left_outgoing_halfedge;
    Real_vector left, end;
    std::vector<std::pair<Real_vector, Real_vector>> portals; // right and left ends
  };

  // A sum of angles between 0 and pi each, which is followed as far as pi.
  class Sum
  {
  public:
    void add(const Real_vector& angle)
    {
      if(m_comparison > 0)
        return;
      const int sine = sign_beside(angle.y, boost::multiprecision::sqrt(squared_norm(angle)));
      if(sine < 0)
        throw std::logic_error("an angle is not between 0 and pi");
      const bool is_zero = sine == 0 && angle.x > 0;
      if(m_comparison == 0) {
        m_comparison = is_zero ? 0 : 1;
        return;
      }
      m_turn = m_turn * angle;
      const int total = sign_beside(m_turn.y, boost::multiprecision::sqrt(squared_norm(m_turn)));
      if(total < 0)
        m_comparison = 1;
      else if(total == 0 && m_turn.x < 0)
        m_comparison = 0;
    }

    int comparison() const { return m_comparison; }

  private:
    Real_vector m_turn = {1, 0};
    int m_comparison = -1;
  };

  // The wedge in parts of at most pi: up to the first spoke, from spoke to spoke, from the last.
  std::vector<Real_vector> angles(Halfedge_index from, Halfedge_index to)
  {
    const Layout a = layout(m_triangulation.edge_sequence(from)), b = layout(m_triangulation.edge_sequence(to));
    if(!a.is_edge && !b.is_edge && a.right_outgoing_halfedge == b.right_outgoing_halfedge && from != to) {
      const int order = turning(b.end, a.end); // positive: b comes soon after a
      if(order == 0)
        throw No_order("two directions in one corner are equal");
      if(order > 0)
        return {a.end * conjugate(b.end)};
    }
    std::vector<Real_vector> result;
    if(!a.is_edge)
      result.push_back(a.end);
    int outgoing_halfedge = a.right_outgoing_halfedge;
    const bool goes_round = from == to && a.is_edge;
    for(bool is_first = true; outgoing_halfedge != b.left_outgoing_halfedge || (is_first && goes_round);
        is_first = false) {
      const int t = outgoing_halfedge ^ 1;
      const Real_vector r = ratio(t);
      result.push_back({-r.x, r.y});
      outgoing_halfedge = next_of(t);
    }
    if(!b.is_edge)
      result.push_back(b.left * conjugate(b.end));
    return result;
  }

  // Input halfedges are bare numbers in here.
  int next_of(int h) const { return m_triangulation.input().next(Input_halfedge_index(h)).idx(); }
  auto input_halfedge(int h) const { return m_triangulation.input().halfedge(Input_halfedge_index(h)); }
  Real length_of(int h) const { return m_shape.length(input_halfedge(h)); }

  const Real_vector& ratio(int h)
  {
    const auto found = m_ratios.find(h);
    if(found != m_ratios.end())
      return found->second;
    return m_ratios.emplace(h, m_shape(input_halfedge(h))).first->second;
  }

  Layout layout(const Word& word)
  {
    if(word.along.is_valid())
      return {true, word.along.idx(), word.along.idx(), {1, 0}, {1, 0}, {}};
    Layout result;
    const int first = word.crossed.front().idx(), left_side = next_of(first);
    result.is_edge = false;
    result.left_outgoing_halfedge = left_side ^ 1;
    result.right_outgoing_halfedge = next_of(left_side);
    Real_vector right = {1, 0};
    Real_vector left = right + ratio(result.right_outgoing_halfedge);
    result.left = left;
    for(std::size_t i = 0; i < word.crossed.size(); ++i) {
      result.portals.emplace_back(right, left);
      const int entered = word.crossed[i].idx() ^ 1; // from left to right
      result.end = right + (right - left) * ratio(entered);
      if(i + 1 == word.crossed.size())
        return result;
      const int left_through = word.crossed[i + 1].idx();
      const bool is_leaving_right = left_through == next_of(entered);
      if(!is_leaving_right && left_through != next_of(next_of(entered)))
        throw std::logic_error("a word leaves a face through an edge that it does not have");
      (is_leaving_right ? left : right) = result.end;
    }
    return result;
  }

  const Triangulation& m_triangulation;
  Shape m_shape;
  std::unordered_map<int, Real_vector> m_ratios;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_REFEREE_H
