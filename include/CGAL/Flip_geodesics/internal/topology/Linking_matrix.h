// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_LINKING_MATRIX_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_LINKING_MATRIX_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* A point of a face: the weighted mean of its corners; `whole` is the sum of the weights. */
struct Weighted_place
{
  static constexpr int whole = 64;

  static Weighted_place at_vertex(Vertex_index v) { return {{v, v, v}, {whole, 0, 0}}; }

  std::array<Vertex_index, 3> corners;
  std::array<int, 3> weights;
};

/*
 * Exact signs of determinants of vectors between points of a mesh in space: in doubles with an error bound, and in
 * integers after a filter failure.
 */
class Places_in_space
{
public:
  using Coordinates = Place_in_space;
  using Direction = std::array<std::int64_t, 3>; // of numbers below 2^21

  /* `place(v)` must return the finite coordinates of each of `n` vertices. */
  template <class Place>
  Places_in_space(Index n, const Place& place)
  {
    for(Vertex_index v : descriptors<Vertex_index>(n)) {
      m_points.push_back(place(v));
      for(int k = 0; k < 3; ++k) {
        const double x = m_points.back()[k];
        m_near.push_back(x - m_points.front()[k]);
        m_size = (std::max)(m_size, std::abs(m_near.back()));
        if(x != 0)
          m_least_exponent = (std::min)(m_least_exponent, std::ilogb(x));
      }
    }
  }

  /* Returns the rounded vector from the first vertex to a point. */
  Coordinates close_by(const Weighted_place& p) const
  {
    Coordinates result = {0, 0, 0};
    for(int i = 0; i < 3; ++i)
      if(p.weights[i] != 0)
        for(int k = 0; k < 3; ++k)
          result[k] += p.weights[i] * m_near[static_cast<std::size_t>(3 * p.corners[i].idx() + k)];
    for(double& x : result)
      x /= Weighted_place::whole;
    return result;
  }

  /* Returns a bound on the error of `close_by()`. */
  double rounding() const { return weighted_place_error * m_size; }

  /* Returns whether c is on the left of the line from a to b, as seen against a direction. */
  Sign side(const Weighted_place& a, const Weighted_place& b, const Weighted_place& c, const Direction& direction) const
  {
    const Coordinates along = {double(direction[0]), double(direction[1]), double(direction[2])};
    return sign_of_determinant(vector(a, b), vector(a, c), along, [&] {
      const Exact_vector exactly_along = {Integer(direction[0]), Integer(direction[1]), Integer(direction[2])};
      return determinant(exact_vector(a, b), exact_vector(a, c), exactly_along);
    });
  }

  /* Returns the sign of the determinant of ab, cd and ef. */
  Sign orientation(const std::array<Weighted_place, 6>& p) const
  {
    return sign_of_determinant(vector(p[0], p[1]), vector(p[2], p[3]), vector(p[4], p[5]), [&] {
      return determinant(exact_vector(p[0], p[1]), exact_vector(p[2], p[3]), exact_vector(p[4], p[5]));
    });
  }

  /* Returns six times the volume of the tetrahedron of three points and the first vertex, rounded, and a bound on its
   * error. */
  std::array<double, 2> volume(const std::array<Weighted_place, 3>& p) const
  {
    const Coordinates a = close_by(p[0]), b = close_by(p[1]), c = close_by(p[2]);
    return {determinant(a, b, c), error(a, b, c)};
  }

  /* Returns that volume exactly, in a unit common to all. */
  Integer exact_volume(const std::array<Weighted_place, 3>& p) const
  {
    const Weighted_place first = Weighted_place::at_vertex(Vertex_index(0));
    return determinant(exact_vector(first, p[0]), exact_vector(first, p[1]), exact_vector(first, p[2]));
  }

private:
  using Exact_vector = std::array<Integer, 3>;

  template <class Number>
  static Number determinant(const std::array<Number, 3>& u, const std::array<Number, 3>& v,
                            const std::array<Number, 3>& w)
  {
    return dot(u, cross(v, w));
  }

  static double largest(const Coordinates& v) { return (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

  // A bound on the error of a determinant: six products, of entries with errors of twice the rounding. Entries are in
  // fact off by at most 11 rounding errors of the size, instead of 16, and those of two of the vectors are at most
  // twice the size. The difference therefore exceeds the five rounding errors of each product.
  double error(const Coordinates& u, const Coordinates& v, const Coordinates& w) const
  {
    const double a = largest(u), b = largest(v), c = largest(w), off = 2.1 * rounding();
    return 6.1 * (off * (a * b + b * c + a * c) + off * off * (a + b + c + off)) + underflow_of_small_products;
  }

  // The sign of `exact()`, which is called only if the rounded vectors do not decide.
  template <class Exact_determinant>
  Sign sign_of_determinant(const Coordinates& u, const Coordinates& v, const Coordinates& w,
                           const Exact_determinant& exact) const
  {
    const double value = determinant(u, v, w);
    if(std::abs(value) > error(u, v, w))
      return CGAL::sign(value);
    return CGAL::sign(exact().sign());
  }

  Coordinates vector(const Weighted_place& a, const Weighted_place& b) const
  {
    return difference(close_by(b), close_by(a));
  }

  Exact_vector exact_vector(const Weighted_place& a, const Weighted_place& b) const
  {
    Exact_vector result = {Integer(0), Integer(0), Integer(0)};
    for(int k = 0; k < 3; ++k) {
      add(b, k, 1, result[k]);
      add(a, k, -1, result[k]);
    }
    return result;
  }

  void add(const Weighted_place& p, int k, int factor, Integer& sum) const
  {
    for(int i = 0; i < 3; ++i)
      if(p.weights[i] != 0)
        sum += Integer(factor * p.weights[i]) * whole_number(m_points[p.corners[i]][k]);
  }

  // A coordinate in the unit of the last place of the least one.
  Integer whole_number(double x) const
  {
    if(x == 0)
      return Integer(0);
    const int exponent = std::ilogb(x);
    const Integer digits(static_cast<std::int64_t>(std::scalbn(x, 52 - exponent)));
    return digits << static_cast<unsigned long>(exponent - m_least_exponent);
  }

  Indexed_by<Vertex_index, std::vector<Coordinates>> m_points;
  std::vector<double> m_near; // three for each vertex, relative to the first
  double m_size = 0;
  int m_least_exponent = 2000;
};

/* The cotree of a closed surface as a rooted tree of faces in each component. */
template <class Input_mesh>
class Rooted_cotree
{
public:
  Rooted_cotree(const Input_mesh& input, const Cotree& cotree)
    : m_input(input)
    , m_up(static_cast<std::size_t>(input.number_of_halfedges()), null_index)
    , m_depth(static_cast<std::size_t>(input.number_of_halfedges()), null_index)
  {
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges()))
      if(m_depth[face(h)] < 0)
        grow(cotree, face(h));
  }

  /* Returns the smallest halfedge of the face on the left. */
  Input_halfedge_index face(Input_halfedge_index h) const { return least_in_face(m_input, h); }

  /* Calls `pass(side, is_left)` along the path from the face on the left of h to the one on its right: for each side of
   * a face that leads up, to the left or to the right of where the two paths to the root meet. */
  template <class Pass>
  void for_each_side_between(Input_halfedge_index h, const Pass& pass) const
  {
    Input_halfedge_index left = face(h), right = face(twin_index(h));
    while(left != right) {
      const bool is_left = m_depth[left] >= m_depth[right];
      Input_halfedge_index& f = is_left ? left : right;
      pass(m_up[f], is_left);
      f = face(twin_index(m_up[f]));
    }
  }

private:
  void grow(const Cotree& cotree, Input_halfedge_index root)
  {
    m_depth[root] = 0;
    std::vector<Input_halfedge_index> queue(1, root);
    for(std::size_t i = 0; i < queue.size(); ++i) {
      Input_halfedge_index h = queue[i];
      const Index depth = m_depth[h];
      for(int side = 0; side < 3; ++side, h = m_input.next(h)) {
        const Input_halfedge_index f = face(twin_index(h));
        if(!cotree.is_crossed(h) || m_depth[f] >= 0)
          continue;
        m_depth[f] = depth + 1;
        m_up[f] = twin_index(h);
        queue.push_back(f);
      }
    }
  }

  const Input_mesh& m_input;
  Indexed_by<Input_halfedge_index, std::vector<Input_halfedge_index>> m_up; // by face: the side towards the root
  Indexed_by<Input_halfedge_index, std::vector<Index>> m_depth;             // by face
};

/*
 * Determines by linking numbers which loops of a closed surface in space bound something outside of it, and which
 * inside.
 *
 * The loops of the generators run along edges. Each has a dual loop: across the edge of its generator, from right to
 * left, and back by the cotree. It meets the first loop there, once, and no other one. Two loops are therefore disjoint
 * except for that point, and the linking number of the loop of generator i and dual loop j pushed off the surface is
 * the sum of the signs of the crossings in a projection:
 *
 *          t |               edge pq of a loop passes over piece st of a dual loop: +1 if that runs to the left,
 *     p -----|----> q        0 if it passes under it
 *          s |
 *
 * Where the two meet, the dual loop is pushed towards the viewer and therefore contributes nothing. That is outwards
 * where the surface faces the viewer; elsewhere the number of the loop pushed outwards is one less. If N is the matrix
 * of the loops pushed outwards, that of those pushed inwards is N + 1, with the unit matrix 1. A class x bounds inside
 * if and only if x N = 0 [Alexander duality], outside if x (N + 1) = 0, and each class is the sum of one of either
 * kind, so that -N is a projector: N (N + 1) = 0, of rank g. It is not a projector if the surface crosses itself
 * between the loops.
 *
 * The computation is exact: points are means of vertices with integer weights, and integers decide the signs after
 * filter failures. If three relevant points are collinear in the projection, another projection is used.
 */
template <class Triangulation>
class Linking_matrix
{
public:
  using Row = std::vector<std::int64_t>;
  using Rooted = Rooted_cotree<std::decay_t<decltype(std::declval<const Triangulation&>().input())>>;

  /* For the loops `first` to `last` of generators, which are those of one component. \throws Interrupted */
  Linking_matrix(const Triangulation& triangulation, const Edge_forest& forest, const Cotree& cotree,
                 const Rooted& rooted, const Places_in_space& places, std::size_t first, std::size_t last,
                 Interruption* interruption)
    : m_triangulation(triangulation)
    , m_interruption(interruption)
    , m_places(places)
    , m_cotree(cotree)
    , m_rooted(rooted)
    , m_first(first)
    , m_size(last - first)
  {
    collect_edges(forest);
    collect_pieces();
    constexpr std::uint64_t most_projections = 20;
    std::uint64_t seed = 0;
    while(!project(seed))
      if(++seed == most_projections)
        throw_naming<Degenerate_face_error>(
            "degenerate faces prevent the computation of linking numbers of loops through vertex ",
            input().tail(generator(0)));
    check_matrix();
  }

  /* Returns the projector -N: row i contains the part of class i that bounds outside. */
  const std::vector<Row>& rows() const { return m_rows; }

private:
  using Direction = Places_in_space::Direction;

  // The numbers of times that loops pass an element, by the loops' numbers.
  using Passes = std::vector<std::pair<std::size_t, int>>;

  // A piece of a loop or a dual loop, from one point to another.
  struct Piece
  {
    Weighted_place from, to;
    Edge_index edge; // on which it lies, or to which it leads
    Passes passes;
    std::array<double, 2> low = {0, 0}, high = {0, 0}; // its extent in the projection
  };

  const auto& input() const { return m_triangulation.input(); }
  Vertex_index head(Input_halfedge_index h) const { return input().tail(twin_index(h)); }
  Input_halfedge_index generator(std::size_t i) const { return m_cotree.generators()[m_first + i].halfedge; }

  Weighted_place on_edge(Input_halfedge_index h) const
  {
    const Input_halfedge_index g = is_first_side(h) ? h : twin_index(h);
    const int weight = 24 + static_cast<int>(scrambled(static_cast<std::uint64_t>(g.idx())) % 17);
    return {{input().tail(g), head(g), head(g)}, {weight, Weighted_place::whole - weight, 0}};
  }

  std::array<Weighted_place, 3> corners(Input_halfedge_index h) const
  {
    return {Weighted_place::at_vertex(input().tail(h)), Weighted_place::at_vertex(head(h)),
            Weighted_place::at_vertex(head(input().next(h)))};
  }

  Weighted_place in_face(Input_halfedge_index h) const
  {
    const Input_halfedge_index f = m_rooted.face(h);
    const std::uint64_t random = scrambled(static_cast<std::uint64_t>(f.idx()));
    const int a = 12 + static_cast<int>(random % 17), b = 12 + static_cast<int>(random / 32 % 17);
    return {{input().tail(f), head(f), head(input().next(f))}, {a, b, Weighted_place::whole - a - b}};
  }

  void collect_edges(const Edge_forest& forest)
  {
    std::map<Edge_index, Passes> passes;
    for(std::size_t i = 0; i < m_size; ++i)
      for(Halfedge_index h : forest.loop(input(), generator(i)).cycle())
        passes[edge_of(h)].emplace_back(i, is_first_side(h) ? 1 : -1);
    for(const auto& [e, of_loops] : passes) {
      const Input_halfedge_index h = as_input(first_side(e));
      m_edges.push_back({Weighted_place::at_vertex(input().tail(h)), Weighted_place::at_vertex(head(h)), e, of_loops});
    }
  }

  // Dual loops consist of halves of edges of the dual graph: from a point in a face to one on a side of it.
  void collect_pieces()
  {
    std::map<Input_halfedge_index, Passes> passes;
    const auto pass = [&](std::size_t i, Input_halfedge_index side, int sign) {
      passes[side].emplace_back(i, sign);
      passes[twin_index(side)].emplace_back(i, -sign);
    };
    for(std::size_t i = 0; i < m_size; ++i) {
      pass(i, generator(i), -1);
      m_rooted.for_each_side_between(generator(i),
                                     [&](Input_halfedge_index side, bool is_left) { pass(i, side, is_left ? 1 : -1); });
    }
    for(const auto& [side, of_loops] : passes)
      m_pieces.push_back({in_face(side), on_edge(side), edge_of(as_intrinsic(side)), of_loops});
  }

  // Counts crossings in a projection; returns false if it is not generic.
  bool project(std::uint64_t seed)
  {
    Direction direction = {};
    std::uint64_t number = 3 * seed;
    for(std::int64_t& slope : direction)
      slope = (1 << 15) + static_cast<std::int64_t>(scrambled(number++) % (1 << 20));
    m_rows.assign(m_size, Row(m_size, 0));
    m_is_generic = true;
    for(std::size_t i = 0; i < m_size && m_is_generic; ++i)
      m_rows[i][i] = is_pushed_outwards(generator(i), direction) ? 0 : 1;
    count_crossings(direction);
    return m_is_generic;
  }

  Sign side(const Weighted_place& a, const Weighted_place& b, const Weighted_place& c, const Direction& direction)
  {
    const Sign result = m_places.side(a, b, c, direction);
    m_is_generic = m_is_generic && result != ZERO;
    return result;
  }

  // Returns whether a dual loop that crosses an edge is pushed outwards if it is pushed towards the viewer. Seen from
  // the outside, faces are counterclockwise. If one face is turned away, it lies in front of or behind the other one:
  //
  //        viewer                       viewer        The loop lies in the faces and is pushed past the edge o when it
  //       ____o   ridge: inwards,     ____            is moved from between them to the other side. On a ridge that is
  //          /    as into the wedge       \           outwards, so that towards the viewer is inwards. In a valley it
  //         /                          ____o valley   is the reverse.
  bool is_pushed_outwards(Input_halfedge_index h, const Direction& direction)
  {
    const auto left = corners(h), right = corners(twin_index(h));
    const Sign of_left = side(left[0], left[1], left[2], direction);
    const Sign of_right = side(right[0], right[1], right[2], direction);
    if(of_left == of_right || !m_is_generic)
      return of_left == POSITIVE;
    const Sign fold = m_places.orientation({right[0], right[1], right[0], right[2], right[0], left[2]});
    if(fold == ZERO)
      throw_crossing(h);
    return fold == POSITIVE;
  }

  [[noreturn]] void throw_crossing(Input_halfedge_index h) const
  {
    const Vertex_index v = input().tail(h), w = head(h);
    throw_naming<Invalid_mesh_error>("the surface touches or intersects itself at the edge between vertices ", v,
                                     " and ", w);
  }

  void cover(Piece& piece, const Direction& direction) const
  {
    const Places_in_space::Coordinates a = m_places.close_by(piece.from), b = m_places.close_by(piece.to);
    for(int k = 0; k < 2; ++k) {
      const double scale = static_cast<double>(direction[2]), slope = static_cast<double>(direction[k]);
      const double x = a[k] * scale - a[2] * slope, y = b[k] * scale - b[2] * slope;
      const double off = 4 * (scale + slope) * m_places.rounding();
      piece.low[k] = (std::min)(x, y) - off;
      piece.high[k] = (std::max)(x, y) + off;
    }
  }

  // Examines the pieces from left to right for each edge, within its extent.
  void count_crossings(const Direction& direction)
  {
    double widest = 0;
    for(Piece& piece : m_pieces) {
      cover(piece, direction);
      widest = (std::max)(widest, piece.high[0] - piece.low[0]);
    }
    std::sort(m_pieces.begin(), m_pieces.end(), [](const Piece& a, const Piece& b) {
      return std::make_pair(a.low[0], a.edge) < std::make_pair(b.low[0], b.edge);
    });
    for(Piece& edge : m_edges) {
      throw_if_interrupted(m_interruption);
      cover(edge, direction);
      auto piece = std::lower_bound(m_pieces.begin(), m_pieces.end(), edge.low[0] - widest,
                                    [](const Piece& p, double x) { return p.low[0] < x; });
      for(; m_is_generic && piece != m_pieces.end() && piece->low[0] <= edge.high[0]; ++piece)
        if(piece->high[0] >= edge.low[0] && piece->low[1] <= edge.high[1] && piece->high[1] >= edge.low[1] &&
           piece->edge != edge.edge)
          count(edge, *piece, direction);
    }
  }

  // A point of a dual loop that is collinear with an edge counts as left of it: it is not on the edge, but beyond one
  // of its ends.
  void count(const Piece& edge, const Piece& piece, const Direction& direction)
  {
    const Weighted_place &p = edge.from, &q = edge.to, &s = piece.from, &t = piece.to;
    const bool is_from_left = m_places.side(p, q, s, direction) != NEGATIVE;
    const bool is_to_left = m_places.side(p, q, t, direction) != NEGATIVE;
    if(is_from_left == is_to_left || side(s, t, p, direction) == side(s, t, q, direction) || !m_is_generic)
      return;
    const Sign crossing = is_to_left ? POSITIVE : NEGATIVE;
    const Sign height = m_places.orientation({p, s, p, q, s, t});
    if(height == ZERO)
      throw_crossing(as_input(first_side(edge.edge)));
    if(height == crossing)
      return; // the edge passes under the piece
    for(const auto& [i, of_edge] : edge.passes)
      for(const auto& [j, of_piece] : piece.passes)
        m_rows[i][j] -= crossing * of_edge * of_piece;
  }

  // The trace of a projector is its rank. The square is checked modulo 2^64, with a pseudorandom vector.
  void check_matrix() const
  {
    std::vector<std::uint64_t> vector, once;
    std::uint64_t trace = 0;
    for(std::size_t i = 0; i < m_size; ++i) {
      vector.push_back(scrambled(i));
      trace += static_cast<std::uint64_t>(m_rows[i][i]);
    }
    once = times(vector);
    if(2 * trace != m_size || times(once) != once)
      throw_naming<Invalid_mesh_error>(
          "the surface intersects itself and does not bound a solid: loops of the component of vertex ",
          input().tail(generator(0)), " have inconsistent linking numbers");
  }

  std::vector<std::uint64_t> times(const std::vector<std::uint64_t>& vector) const
  {
    std::vector<std::uint64_t> result(m_size, 0);
    for(std::size_t i = 0; i < m_size; ++i)
      for(std::size_t j = 0; j < m_size; ++j)
        result[i] += static_cast<std::uint64_t>(m_rows[i][j]) * vector[j];
    return result;
  }

  const Triangulation& m_triangulation;
  Interruption* m_interruption; // null if it cannot be interrupted
  const Places_in_space& m_places;
  const Cotree& m_cotree;
  const Rooted& m_rooted;
  std::size_t m_first, m_size;
  std::vector<Piece> m_edges, m_pieces; // of the loops, and of the dual loops
  std::vector<Row> m_rows;
  bool m_is_generic = true; // no points of the projection are collinear
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_LINKING_MATRIX_H
