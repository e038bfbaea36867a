// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/Multiquadratic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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
  std::array<Integer, 3> result = {0, 0, 0};
  result[(i + 2) % 3] = weights[(i + 2) % 3];
  result[i] = -weights[(i + 1) % 3];
  return result;
}

/* Returns the chain from the point of a face with given weights to the ends of a side. */
inline Unfolding_chain chain_to_side(const Exact_face& face, const std::array<Integer, 3>& weights, int side)
{
  std::array<Integer, 3> to_right = {0, 0, 0};
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

/* Returns the step across crossed edge i to the ends of the next one; behind the last one, the apex is the right end. */
template <class Input_mesh, class Exact_faces>
Unfolding_step step_across(const Input_mesh& input, const Exact_faces& faces,
                           const std::vector<Input_halfedge_index>& crossed, std::size_t i)
{
  const Input_halfedge_index entered = twin_index(crossed[i]);
  const bool is_leaving_right = i + 1 < crossed.size() && crossed[i + 1] == input.next(entered);
  return {is_leaving_right ? Unfolding_step::Kind::NEW_LEFT : Unfolding_step::Kind::NEW_RIGHT, &faces(entered)};
}

/* Constructs chains for edge sequences and for fans of input corners. */
template <class Triangulation>
class Unfolding_chains
{
  using Kind = Unfolding_step::Kind;
  using Weights = std::array<Integer, 3>;

public:
  explicit Unfolding_chains(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_faces(triangulation)
  {
  }

  /* Returns the head of an edge sequence relative to its tail. */
  Unfolding_chain head(const Edge_sequence& sequence, bool is_conjugate) const
  {
    Unfolding_chain result;
    if(sequence.along == null_index && sequence.crossed.empty())
      result = inside_face(sequence);
    else if(sequence.along == null_index && m_triangulation.is_inserted(sequence.head))
      result = point_in_face(sequence, sequence.crossed.size(), weights(sequence.head, sequence.last_face()));
    else
      result = portal(sequence, sequence.crossed.size(), false);
    result.is_conjugate = is_conjugate;
    return result;
  }

  /* Returns an end of the crossed edge with the given number; after the last one, the apex of the last face. */
  Unfolding_chain portal(const Edge_sequence& sequence, std::size_t number, bool is_left) const
  {
    Unfolding_chain result;
    if(sequence.along == null_index)
      result = start(sequence);
    for(std::size_t i = 0; i < number && sequence.along == null_index; ++i)
      result.steps.push_back(step_across(m_triangulation.input(), m_faces, sequence.crossed, i));
    result.reads_left = is_left;
    return result;
  }

  /*
   * Returns a point of the face between portals gap - 1 and gap, by weights relative to the halfedge across which the
   * face is left, or entered if it is the last.
   */
  Unfolding_chain point(const Edge_sequence& sequence, std::size_t gap, const std::array<double, 3>& w) const
  {
    const Weights n = integer_weights(w);
    if(gap == sequence.crossed.size())
      return point_in_face(sequence, gap, n);
    const Input_halfedge_index reference = sequence.crossed[gap];
    if(gap > 0)
      return point_in_face(sequence, gap, turned(n, reference, twin_index(sequence.crossed[gap - 1])));
    const Input_halfedge_index h = tail_anchor(m_triangulation, sequence);
    const Weights v = turned(n, reference, h), from = weights(sequence.tail, h);
    Weights sum = {0, 0, 0};
    for(int i = 0; i < 3; ++i) {
      const Weights corner = corner_from_point(from, i);
      for(int k = 0; k < 3; ++k)
        sum[k] += v[i] * corner[k];
    }
    return chain_in_face(face(h), sum);
  }

  /* Returns the rotation over `count` input corners clockwise from input halfedge h. */
  Unfolding_chain corners(Input_halfedge_index h, Index count) const
  {
    Unfolding_chain result;
    for_each_corner_clockwise(m_triangulation.input(), h, count, [&](Input_halfedge_index t) {
      result.steps.push_back({Kind::CORNER, &face(t)}); // from next(t) to -t: -conj(q) up to a positive factor
    });
    return result;
  }

private:
  const Exact_face& face(Input_halfedge_index h) const { return m_faces(h); }

  Weights weights(Vertex_index v, Input_halfedge_index h) const
  {
    return integer_weights(vertex_weights(m_triangulation, v, h));
  }

  // Converts weights of a face's corners from one reference halfedge to another.
  Weights turned(const Weights& w, Input_halfedge_index from, Input_halfedge_index to) const
  {
    const int shift = side_number(m_triangulation.input(), from, to);
    return {w[shift], w[(shift + 1) % 3], w[(shift + 2) % 3]};
  }

  Unfolding_chain start(const Edge_sequence& sequence) const
  {
    const Input_halfedge_index h = tail_anchor(m_triangulation, sequence), first = sequence.crossed.front();
    const Weights w = m_triangulation.is_inserted(sequence.tail) ? weights(sequence.tail, h) : Weights{1, 0, 0};
    return chain_to_side(face(h), w, side_number(m_triangulation.input(), h, first));
  }

  // The vector between two points of one face.
  Unfolding_chain inside_face(const Edge_sequence& sequence) const
  {
    const Input_halfedge_index h = tail_anchor(m_triangulation, sequence);
    const Weights from = weights(sequence.tail, h), to = weights(sequence.head, h);
    const Integer from_sum = from[0] + from[1] + from[2], to_sum = to[0] + to[1] + to[2];
    return chain_in_face(face(h), {Integer(to[1] * from_sum - from[1] * to_sum), Integer(0),
                                   Integer(from[2] * to_sum - to[2] * from_sum)});
  }

  // By weights relative to the halfedge across which the face is entered.
  Unfolding_chain point_in_face(const Edge_sequence& sequence, std::size_t gap, const Weights& w) const
  {
    Unfolding_chain result = portal(sequence, gap, false);
    result.steps.back().kind = Kind::POINT;
    result.weights = w;
    return result;
  }

  const Triangulation& m_triangulation;
  Exact_input_faces<Triangulation> m_faces;
};

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
 * The areas of coplanar faces are rational multiples of each other, so that there are at most as many independent roots
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

/* A side of an edge, as it is between two flips of the edge. */
struct Side_version
{
  Halfedge_index halfedge;
  Index version; // 0 for an edge of the input
};

/*
 * Results of expensive comparisons of wedges with pi. A straight angle prevents flips and is therefore compared again
 * whenever the flips around it are attempted: a hundred times at an extruded developable region. The angle between two
 * edges is constant as long as both exist. Versions are reused after flips were rolled back; only wedges between edges
 * of the input are known from then on.
 */
class Compared_wedges
{
  using Wedge = std::array<Index, 4>;
  using Results = std::unordered_map<Wedge, Comparison_result, boost::hash<Wedge>>;

public:
  /* Returns the result for the wedge clockwise from one edge to another, or null if it is unknown. */
  const Comparison_result* find(const Side_version& from, const Side_version& to) const
  {
    const Results& results = is_of_input(from, to) ? m_of_input : m_of_flips;
    const auto found = results.find(wedge(from, to));
    return found == results.end() ? nullptr : &found->second;
  }

  void insert(const Side_version& from, const Side_version& to, Comparison_result result)
  {
    Results& results = is_of_input(from, to) ? m_of_input : m_of_flips;
    if(results.size() == most_results)
      results.clear();
    results.insert_or_assign(wedge(from, to), result);
  }

  /* Must be called after flips were rolled back. */
  void forget_flips()
  {
    if(!m_of_flips.empty()) // since clearing takes time even then
      m_of_flips.clear();
  }

private:
  static constexpr std::size_t most_results = std::size_t(1) << 13; // some 500 kB

  static bool is_of_input(const Side_version& from, const Side_version& to)
  {
    return from.version == 0 && to.version == 0;
  }

  static Wedge wedge(const Side_version& from, const Side_version& to)
  {
    return {from.halfedge.idx(), from.version, to.halfedge.idx(), to.version};
  }

  Results m_of_input, m_of_flips;
};

/*
 * The results that a triangulation keeps of predicates after filter failures. The const members can be called by
 * several threads simultaneously.
 */
class Remembered_decisions
{
public:
  Decision_statistics statistics() const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    return m_statistics;
  }

  void add(const Decision_statistics& statistics) const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    m_statistics += statistics;
  }

  /*
   * Returns the comparison of the wedge clockwise from one edge to another with pi, computed by `compare(statistics)`
   * if unknown. No lock is held during that computation.
   */
  template <class Compare>
  Comparison_result compare(const Side_version& from, const Side_version& to, const Compare& compare) const
  {
    {
      const std::lock_guard<Short_lock> guard(m_lock);
      if(const Comparison_result* known = m_compared_wedges.find(from, to)) {
        ++m_statistics.by_memory;
        return *known;
      }
    }
    Decision_statistics statistics;
    const Comparison_result result = compare(statistics);
    const std::lock_guard<Short_lock> guard(m_lock);
    m_compared_wedges.insert(from, to, result);
    m_statistics += statistics;
    return result;
  }

  /* Returns the results for flat edges of an input. */
  Flat_edges& flat_edges(std::size_t number_of_input_edges) const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    if(m_flat_edges.size() == 0)
      m_flat_edges = Flat_edges(number_of_input_edges);
    return m_flat_edges;
  }

  /* Must be called after flips were rolled back. */
  void forget_flips() { m_compared_wedges.forget_flips(); }

private:
  mutable Compared_wedges m_compared_wedges;
  mutable Flat_edges m_flat_edges;
  mutable Decision_statistics m_statistics;
  mutable Short_lock m_lock;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H
