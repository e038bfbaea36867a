// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/Multiquadratic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Input faces in exact numbers, each computed once and given by a halfedge with the face on its left. */
class Exact_face_cache
{
public:
  template <class Triangulation>
  const Exact_face& operator()(const Triangulation& triangulation, Input_halfedge_index h)
  {
    const auto found = m_faces.find(h);
    if(found != m_faces.end())
      return found->second;
    check_triangle(triangulation.input(), h);
    return m_faces.emplace(h, exact_face(triangulation.metric(), triangulation.input(), h)).first->second;
  }

  std::size_t size() const { return m_faces.size(); }

private:
  std::unordered_map<Input_halfedge_index, Exact_face> m_faces;
};

/* The input's faces in exact numbers: those stored by the triangulation, or others with the lifetime of this object. */
template <class Triangulation>
class Exact_input_faces
{
public:
  explicit Exact_input_faces(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  const Exact_face& operator()(Input_halfedge_index h) const
  {
    if constexpr(Internals<Triangulation>::has_exact_faces)
      return Internals<Triangulation>::exact_face(m_triangulation, h);
    else
      return m_faces(m_triangulation, h);
  }

private:
  const Triangulation& m_triangulation;
  mutable Exact_face_cache m_faces; // empty if the triangulation has its own
};

/*
 * One face of an exact unfolding, as a linear map. With the number q = dot + i root of the face and its squared length
 * L, the ends (right, left) of a portal are mapped to the ends of the next one, all multiplied by L.
 */
struct Unfolding_step
{
  enum class Kind {
    START,     // from 1 to two combinations of the face's sides, and their difference
    NEW_LEFT,  // the apex, right + q / L (right - left), replaces the left end
    NEW_RIGHT, // the apex replaces the right end
    POINT,     // a combination of left end, right end and apex replaces the right end
    CORNER     // right times q
  };

  Kind kind;
  const Exact_face* face;

  const Integer& squared_length() const { return face->squared_length; }
  const Integer& squared_root() const { return face->doubled_area_squared; }
  Integer dot() const { return kind == Kind::CORNER ? Integer(-face->dot_next) : face->dot_next; }
};

/* A linear combination of the three sides of a face, as number + i root_coefficient root; the first side is L. */
struct Side_combination
{
  Integer number = 0, root_coefficient = 0;

  Side_combination() = default;
  Side_combination(const Exact_face& face, const std::array<Integer, 3>& c)
    : number(c[0] * face.squared_length + c[1] * face.dot_next + c[2] * face.dot_previous)
    , root_coefficient(c[1] - c[2])
  {
  }
};

/*
 * A complex number defined by input faces up to a positive factor: starting with 1 as the right end of a portal, all
 * steps are applied; the result is the right end, the left end, or its conjugate.
 */
struct Unfolding_chain
{
  std::vector<Unfolding_step> steps;
  bool is_conjugate = false;
  bool reads_left = false;
  Side_combination right, left, to_right; // of START
  std::array<Integer, 3> weights;         // of POINT: for left end, right end, apex
};

/* Returns corner i of a face relative to the point with given weights, as coefficients of the sides, times the sum of
 * the weights. */
inline std::array<Integer, 3> corner_from_point(const std::array<Integer, 3>& weights, int i)
{
  std::array<Integer, 3> result = {};
  result[(i + 2) % 3] = weights[(i + 2) % 3];
  result[i] = -weights[(i + 1) % 3];
  return result;
}

/* Returns the chain from the point of a face with given weights to the ends of a side. */
inline Unfolding_chain chain_to_side(const Exact_face& face, const std::array<Integer, 3>& weights, int side)
{
  std::array<Integer, 3> to_right = {};
  to_right[side] = -(weights[0] + weights[1] + weights[2]);
  Unfolding_chain result;
  result.right = Side_combination(face, corner_from_point(weights, side));
  result.left = Side_combination(face, corner_from_point(weights, (side + 1) % 3));
  result.to_right = Side_combination(face, to_right);
  result.steps.push_back({Unfolding_step::Kind::START, &face});
  return result;
}

/* Returns the chain to a combination of the sides of a face. */
inline Unfolding_chain chain_in_face(const Exact_face& face, const std::array<Integer, 3>& coefficients)
{
  Unfolding_chain result;
  result.right = Side_combination(face, coefficients);
  result.steps.push_back({Unfolding_step::Kind::START, &face});
  return result;
}

/* Returns the step across crossed edge i to the ends of the next one; behind the last one, the apex is the right end.
 * */
template <class Input_mesh, class Exact_faces>
Unfolding_step step_across(const Input_mesh& input, const Exact_faces& faces,
                           const std::vector<Input_halfedge_index>& crossed, std::size_t i)
{
  const Input_halfedge_index entered = twin_index(crossed[i]);
  const bool is_leaving_right = i + 1 < crossed.size() && crossed[i + 1] == input.next(entered);
  return {is_leaving_right ? Unfolding_step::Kind::NEW_LEFT : Unfolding_step::Kind::NEW_RIGHT, &faces(entered)};
}

/*
 * Evaluates chains in a ring that contains the roots and has complex numbers. A ring may divide by squared lengths or
 * scale by them. A ring with errors bounds them by one radius per complex number: with separate radii for real and
 * imaginary part, a rotation would enlarge them by up to sqrt(2), and all digits would be lost after some hundred
 * faces.
 */
template <class Ring>
class Chain_arithmetic
{
  using Kind = Unfolding_step::Kind;

public:
  using Complex = typename Ring::Complex;

  /*
   * The ends of a portal, and the vector from the left one to the right one, which is a product of corners, never a
   * difference of positions; differences would magnify errors at short portals.
   */
  struct Portal
  {
    Complex right, left, to_right;
  };

  explicit Chain_arithmetic(const Ring& ring)
    : m_ring(ring)
  {
  }

  /* Returns the sign of the imaginary part of a product. */
  Uncertain<Sign> sign_of_sine(const std::vector<Unfolding_chain>& chains) const
  {
    Complex product = m_ring.one();
    bool is_one = true;
    for(const Unfolding_chain& chain : chains) {
      if(chain.steps.empty())
        continue;
      const Complex z = value(chain);
      product = is_one ? z : m_ring.multiply(product, z);
      is_one = false;
    }
    return m_ring.sign_of_sine(product);
  }

  /* Returns the portal before the first step. */
  Portal first_portal() const { return {m_ring.one(), {}, {}}; }

  /* Applies a step of a chain to a portal. */
  void apply(const Unfolding_chain& chain, const Unfolding_step& step, Portal& portal) const
  {
    const Integer& length = step.squared_length();
    if(step.kind == Kind::START) {
      portal = {combined(step, chain.right), combined(step, chain.left), combined(step, chain.to_right)};
      return;
    }
    const auto q = m_ring.side(step.dot(), step.squared_root(), 1, length);
    if(step.kind == Kind::CORNER) {
      portal.right = m_ring.times_side(portal.right, q);
      return;
    }
    const Complex to_apex = m_ring.times_side(portal.to_right, q);
    portal.right = m_ring.rescale(portal.right, length);
    const Complex apex = m_ring.add(portal.right, to_apex);
    if(step.kind == Kind::POINT) {
      portal.right = m_ring.add(m_ring.add(m_ring.times_integer(m_ring.rescale(portal.left, length), chain.weights[0]),
                                           m_ring.times_integer(portal.right, chain.weights[1])),
                                m_ring.times_integer(apex, chain.weights[2]));
    } else if(step.kind == Kind::NEW_RIGHT) {
      const auto p = m_ring.side(step.face->dot_previous, step.squared_root(), -1, length);
      portal.to_right = m_ring.negate(m_ring.times_side(portal.to_right, p));
      portal.left = m_ring.rescale(portal.left, length);
      portal.right = apex;
    } else {
      portal.to_right = m_ring.negate(to_apex);
      portal.left = apex;
    }
  }

  /* Returns the number of a chain. */
  Complex value(const Unfolding_chain& chain) const
  {
    Portal portal = first_portal();
    for(const Unfolding_step& step : chain.steps)
      apply(chain, step, portal);
    const Complex& result = chain.reads_left ? portal.left : portal.right;
    return chain.is_conjugate ? m_ring.conjugate(result) : result;
  }

private:
  Complex combined(const Unfolding_step& step, const Side_combination& c) const
  {
    return m_ring.combination(m_ring.side(c.number, step.squared_root(), 1, step.squared_length()), c.root_coefficient);
  }

  const Ring& m_ring;
};

/* Returns the work limit for one sign in a triangulation: that of its traits, if their signs can remain undecided. */
template <class Triangulation>
std::uint64_t sign_work_limit(const Triangulation& triangulation)
{
  if constexpr(Triangulation::Traits::Has_drift::value)
    return default_sign_work;
  else
    return triangulation.traits().sign_work_limit();
}

/*
 * Computes the sign of the imaginary part of a product of chains of input faces in two kinds of numbers: first with 50
 * digits and an error bound, which decides most nonzero numbers, then exactly, with the square roots in the faces'
 * areas, as far as the work limit allows. An undecided sign is taken for zero and counted.
 *
 * The areas of coplanar faces are rational multiples of each other, so there are at most as many independent roots
 * as planes.
 */
class Exact_sign
{
public:
  explicit Exact_sign(Decision_statistics& statistics, std::uint64_t work_limit = default_sign_work)
    : m_statistics(statistics)
    , m_work_limit(work_limit)
  {
  }

  Sign operator()(const std::vector<Unfolding_chain>& chains) const
  {
    const std::vector<Integer> squares = squared_roots(chains);
    const bool is_one_root = squares.size() <= 1; // then exact numbers take less time
    Uncertain<Sign> sign = is_one_root ? by_roots(squares, chains) : by_digits(chains);
    if(!sign.is_certain())
      sign = is_one_root ? by_digits(chains) : by_roots(squares, chains);
    if(sign.is_certain())
      return sign.make_certain();
    ++m_statistics.unproven_zeros;
    return ZERO;
  }

private:
  static std::vector<Integer> squared_roots(const std::vector<Unfolding_chain>& chains)
  {
    std::vector<Integer> result;
    for(const Unfolding_chain& chain : chains)
      for(const Unfolding_step& step : chain.steps)
        result.push_back(step.squared_root());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  Uncertain<Sign> by_digits(const std::vector<Unfolding_chain>& chains) const
  {
    using Ring = Ball_ring<50>;
    const Ring ring;
    const Uncertain<Sign> sign = Chain_arithmetic<Ring>(ring).sign_of_sine(chains);
    m_statistics.by_precision += sign.is_certain() ? 1 : 0;
    return sign;
  }

  Uncertain<Sign> by_roots(const std::vector<Integer>& squares, const std::vector<Unfolding_chain>& chains) const
  {
    using Ring = Multiquadratic_ring;
    Work_limit work(m_work_limit);
    const Ring ring(squares, work);
    m_statistics.most_roots = (std::max)(m_statistics.most_roots, ring.number_of_roots());
    const Uncertain<Sign> sign = Chain_arithmetic<Ring>(ring).sign_of_sine(chains);
    m_statistics.by_roots += sign.is_certain() ? 1 : 0;
    m_statistics.zeros_by_roots += sign.is_certain() && sign.make_certain() == ZERO ? 1 : 0;
    return sign;
  }

  Decision_statistics& m_statistics;
  std::uint64_t m_work_limit;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H
