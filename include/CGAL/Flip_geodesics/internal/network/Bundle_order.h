// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_BUNDLE_ORDER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_BUNDLE_ORDER_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/network/Parity_classes.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The reason why overlapping segments have no order: their curves cross at v, or the search for an order along the edge
 * from v to w was aborted. */
struct Order_conflict
{
  Vertex_index v = null_index, w = null_index;

  explicit operator bool() const { return v != null_index; }

  /* \pre there is a conflict */
  [[noreturn]] void raise() const
  {
    std::vector<std::size_t> elements = {static_cast<std::size_t>(v.idx())};
    if(w == null_index)
      throw Crossing_curves_error("curves cross at vertex " + std::to_string(v.idx()), elements);
    elements.push_back(static_cast<std::size_t>(w.idx()));
    throw Ambiguous_order_error("no order was found for the curves along the edge from vertex " +
                                    std::to_string(v.idx()) + " to vertex " + std::to_string(w.idx()),
                                elements);
  }
};

/* Returns all halfedges, in both directions, of the edges that curves use; those of each vertex are consecutive. */
template <class Network>
std::vector<Halfedge_index> occupied_halfedges(const Network& network)
{
  const auto& triangulation = network.triangulation();
  std::vector<Halfedge_index> result;
  for(Segment_index s(1); s.idx() < network.end_of_segment_ids(); ++s)
    if(network.is_alive(s))
      result.insert(result.end(), {network.halfedge(s), Network::Triangulation::twin(network.halfedge(s))});
  std::sort(result.begin(), result.end(), [&](Halfedge_index g, Halfedge_index h) {
    return std::make_pair(triangulation.tail(g), g) < std::make_pair(triangulation.tail(h), h);
  });
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/* Calls `function(begin, end)` for each range of halfedges with a common tail. */
template <class Triangulation, class Function>
void for_each_vertex(const Triangulation& triangulation, const std::vector<Halfedge_index>& halfedges,
                     Function function)
{
  for(auto first = halfedges.begin(); first != halfedges.end();) {
    const Vertex_index v = triangulation.tail(*first);
    const auto last =
        std::find_if(first, halfedges.end(), [&](Halfedge_index h) { return triangulation.tail(h) != v; });
    function(first, last);
    first = last;
  }
}

/*
 * The unknowns: for each pair of segments on one edge a variable, namely whether the older segment is left of the
 * younger as seen along the edge's first halfedge. They are followed by one variable for each segment, see
 * `Crossing_equations`.
 */
template <class Network>
class Bundle_pairs
{
  using Triangulation = typename Network::Triangulation;

public:
  using Segment_pair = std::pair<Segment_index, Segment_index>;

  explicit Bundle_pairs(const Network& network)
    : m_network(network)
    , m_bundle_of(static_cast<std::size_t>(network.end_of_segment_ids()), null_index)
    , m_rank(m_bundle_of.size())
    , m_pairs(1, {null_index, null_index})
  {
    for(Halfedge_index h : occupied_halfedges(network))
      if(is_first_side(h))
        add_bundle(Triangulation::edge(h));
    m_bundles = Buckets(static_cast<Index>(m_edges.size()), m_bundle_of);
  }

  const Network& network() const { return m_network; }

  /* An edge with too many segments, if any; it then has no unknowns. */
  const Order_conflict& conflict() const { return m_conflict; }

  /* Edges with more than one segment are numbered; their segments are sorted by age. */
  Index number_of_bundles() const { return static_cast<Index>(m_edges.size()); }
  Edge_index edge(Index bundle) const { return m_edges[bundle]; }
  Buckets::Range segments(Index bundle) const { return m_bundles[bundle]; }
  /* Returns the bundle of a segment, or `null_index` if it is alone on its edge. */
  Index bundle_of(Segment_index s) const { return m_bundle_of[s]; }

  Index number_of_variables() const { return static_cast<Index>(m_pairs.size() + m_bundle_of.size()); }
  Index end_of_pairs() const { return static_cast<Index>(m_pairs.size()); }
  const Segment_pair& segments_of_pair(Index v) const { return m_pairs[v]; }
  Literal segment_literal(Segment_index s) const { return 2 * (end_of_pairs() + s.idx()); }

  /* Returns the literal that s is left of t as seen along the first halfedge of their edge. \pre s and t differ and are
   * on one edge */
  Literal is_left(Segment_index s, Segment_index t) const
  {
    const Index i = (std::min)(m_rank[s], m_rank[t]), j = (std::max)(m_rank[s], m_rank[t]);
    return opposite_if(s > t, 2 * (m_first_pair[m_bundle_of[s]] + j * (j - 1) / 2 + i));
  }

  /* Returns the literal that s is left of t as seen along halfedge h. \pre s and t differ and are on the edge of h */
  Literal is_left(Halfedge_index h, Segment_index s, Segment_index t) const
  {
    return opposite_if(!is_first_side(h), is_left(s, t));
  }

private:
  // Literals, twice the variables, must fit into an Index.
  static constexpr std::size_t most_pairs = std::size_t(1) << 29;

  void add_bundle(Edge_index e)
  {
    std::vector<Segment_index> segments = m_network.bundle(e);
    if(segments.size() < 2)
      return;
    if(m_conflict || m_pairs.size() + segments.size() * (segments.size() - 1) / 2 > most_pairs) {
      const auto& triangulation = m_network.triangulation();
      if(!m_conflict)
        m_conflict = {triangulation.tail(first_side(e)), triangulation.head(first_side(e))};
      return;
    }
    std::sort(segments.begin(), segments.end());
    m_first_pair.push_back(end_of_pairs());
    for(std::size_t j = 0; j < segments.size(); ++j) {
      m_bundle_of[segments[j]] = static_cast<Index>(m_edges.size());
      m_rank[segments[j]] = static_cast<Index>(j);
      for(std::size_t i = 0; i < j; ++i)
        m_pairs.emplace_back(segments[i], segments[j]);
    }
    m_edges.push_back(e);
  }

  const Network& m_network;
  std::vector<Edge_index> m_edges; // by bundle
  std::vector<Index> m_first_pair; // by bundle
  Indexed_by<Segment_index, std::vector<Index>> m_bundle_of, m_rank;
  std::vector<Segment_pair> m_pairs; // by variable
  Buckets m_bundles;
  Order_conflict m_conflict;
};

/* Variables whose sum modulo 2 is `parity`; variables that are known or occur twice have been eliminated. */
struct Parity_sum
{
  std::array<Index, 4> variables{};
  Index size = 0;
  bool parity = false;

  void add(Literal representative)
  {
    const Index v = variable(representative);
    parity = parity != is_opposite(representative);
    if(v == variable(false_literal))
      return;
    const auto end = variables.begin() + size, found = std::find(variables.begin(), end, v);
    if(found == end) {
      variables[size++] = v;
      return;
    }
    std::copy(found + 1, end, found);
    --size;
  }
};

/*
 * The conditions around the vertices under which no curves cross, as linear equations modulo 2.
 *
 * Cut the cyclic order of ends around a vertex open, at the border if there is one. Two joints (a, b) and (c, d)
 *
 *        a   c   b   d             cross if and only if [a<c] + [a<d] + [b<c] + [b<d] is odd,
 *     ---+---+---+---+--->
 *
 * and the end x of a curve is between a and b if and only if [a<x] + [b<x] is odd. The order of two ends is known if
 * they are on different incident edges; otherwise it is one of the variables of `Bundle_pairs`. Two curves that run
 * together from one incident edge to another therefore have the same order before and after, which is an equation in
 * two variables, and curves that part have a known order. If a curve turns back beside another one, the latter lies on
 * opposite sides of its two segments, as seen along the curve. All ends, and the border, must lie on one side of a
 * joint: the variable of the arriving segment specifies whether they lie between a and b.
 *
 * Equations in one or two variables merge classes, so that a whole run of overlapping segments becomes one unknown.
 * Only turns within one incident edge give longer equations: two of them on one edge, or one beside an end.
 */
template <class Network>
class Crossing_equations
{
  using Triangulation = typename Network::Triangulation;

public:
  /* An equation in more than two variables, and its vertex. */
  struct Equation
  {
    std::array<Literal, 4> literals;
    Vertex_index vertex;
  };

  explicit Crossing_equations(const Bundle_pairs<Network>& pairs)
    : m_pairs(pairs)
    , m_network(pairs.network())
    , m_triangulation(m_network.triangulation())
    , m_classes(pairs.number_of_variables())
    , m_position(static_cast<std::size_t>(m_triangulation.number_of_halfedges()))
  {
    for_each_vertex(m_triangulation, occupied_halfedges(m_network),
                    [&](auto first, auto last) { add_vertex(first, last); });
    do {
      substitute();
    } while(!m_conflict && merge_combinations());
  }

  const Bundle_pairs<Network>& pairs() const { return m_pairs; }
  /* The first contradiction found, after which equations are left out. */
  const Order_conflict& conflict() const { return m_conflict; }
  Parity_classes& classes() { return m_classes; }
  const std::vector<Equation>& long_equations() const { return m_long_equations; }

  Parity_sum sum(const Equation& equation)
  {
    Parity_sum result;
    for(Literal a : equation.literals)
      result.add(m_classes.representative(a));
    return result;
  }

private:
  template <class Iterator>
  void add_vertex(Iterator first, Iterator last)
  {
    const auto is_shared = [&](Halfedge_index h) {
      return m_pairs.bundle_of(m_network.outermost(h, Side::LEFT)) != null_index;
    };
    if(m_conflict || std::none_of(first, last, is_shared))
      return;
    m_vertex = m_triangulation.tail(*first);
    number_outgoing_halfedges();
    count_single_ends(first, last);
    for(auto h = first; h != last; ++h) {
      const std::vector<Segment_index> segments = m_network.bundle(Triangulation::edge(*h));
      for(auto s = segments.begin(); s != segments.end(); ++s) {
        add_joint({*h, *s});
        for(auto t = segments.begin(); t != s; ++t)
          add_neighbors({*h, *t}, {*h, *s});
      }
    }
  }

  void number_outgoing_halfedges()
  {
    const std::vector<Halfedge_index> all = outgoing_halfedges(m_triangulation, m_vertex);
    for(std::size_t i = 0; i < all.size(); ++i)
      m_position[all[i]] = static_cast<Index>(i);
    m_has_border = m_triangulation.is_border(all.front());
    m_single_ends_before.assign(all.size() + 1, 0);
  }

  template <class Iterator>
  void count_single_ends(Iterator first, Iterator last)
  {
    for(auto h = first; h != last; ++h)
      for(Segment_index s : m_network.bundle(Triangulation::edge(*h)))
        m_single_ends_before[m_position[*h] + 1] += mate({*h, s}).is_none() ? 1 : 0;
    for(std::size_t i = 1; i < m_single_ends_before.size(); ++i)
      m_single_ends_before[i] += m_single_ends_before[i - 1];
  }

  bool is_head(const Segment_end& end) const { return end.halfedge != m_network.halfedge(end.segment); }

  // The end that a joint connects with this one, unless the node is fixed.
  Segment_end mate(const Segment_end& end) const
  {
    const Segment_index x = is_head(end) ? end.segment : m_network.previous(end.segment);
    if(x == null_index || m_network.is_head_fixed(x))
      return {};
    const auto [at_x, at_y] = m_network.ends({x, Side::LEFT});
    return is_head(end) ? at_y : at_x;
  }

  // Returns, for the joint of two ends, the literal that the single ends of its vertex lie between the two.
  Literal contains_single_ends(const Segment_end& a, const Segment_end& b) const
  {
    return m_pairs.segment_literal(is_head(a) ? a.segment : b.segment);
  }

  Literal is_before(const Segment_end& a, const Segment_end& b) const
  {
    if(a.halfedge == b.halfedge)
      return m_pairs.is_left(a.halfedge, a.segment, b.segment);
    return constant(m_position[a.halfedge] < m_position[b.halfedge]);
  }

  // Adds the equations of a joint and the single ends on incident edges other than its own.
  void add_joint(const Segment_end& a)
  {
    const Segment_end b = mate(a);
    if(b.is_none() || !is_head(a))
      return;
    const Index p = (std::min)(m_position[a.halfedge], m_position[b.halfedge]);
    const Index q = (std::max)(m_position[a.halfedge], m_position[b.halfedge]);
    const auto& before = m_single_ends_before;
    if(p < q && before[q] > before[p + 1])
      add_equation({contains_single_ends(a, b), true_literal});
    if(m_has_border || before[p] > 0 || before.back() > before[q + 1])
      add_equation({contains_single_ends(a, b)});
  }

  // Adds the equation of two ends on one incident edge and the ends connected to them.
  void add_neighbors(const Segment_end& a, const Segment_end& c)
  {
    const Segment_end b = mate(a), d = mate(c);
    if(b == c || (b.is_none() && d.is_none()))
      return;
    if(b.is_none())
      add_joint_beside_single_end(c, d, a);
    else if(d.is_none())
      add_joint_beside_single_end(a, b, c);
    else
      add_joints(a, b, c, d);
  }

  void add_joint_beside_single_end(const Segment_end& a, const Segment_end& b, const Segment_end& x)
  {
    const bool is_repeated = a.halfedge == b.halfedge && !is_head(a);
    if(!is_repeated)
      add_equation({is_before(a, x), is_before(b, x), contains_single_ends(a, b)});
  }

  void add_joints(const Segment_end& a, const Segment_end& b, const Segment_end& c, const Segment_end& d)
  {
    const bool is_one_outgoing_halfedge = a.halfedge == b.halfedge && c.halfedge == d.halfedge;
    const bool is_repeated = is_one_outgoing_halfedge && !(is_head(a) && is_head(c));
    if(!is_repeated)
      add_equation({is_before(a, c), is_before(a, d), is_before(b, c), is_before(b, d)});
  }

  // Requires that the sum of the literals is even; omitted literals are false.
  void add_equation(const std::array<Literal, 4>& literals)
  {
    const Equation equation = {literals, m_vertex};
    if(!merge(equation))
      m_long_equations.push_back(equation);
  }

  // Unites two classes of literals, unless that contradicts what is known.
  void unite(Literal a, Literal b, Vertex_index v)
  {
    if(!m_classes.unite(a, b) && !m_conflict)
      m_conflict.v = v;
  }

  // Merges the classes that are equal by an equation; returns false if it has more than two variables.
  bool merge(const Equation& equation)
  {
    const Parity_sum s = sum(equation);
    if(s.size > 2)
      return false;
    const Literal a = s.size > 0 ? 2 * s.variables[0] : false_literal;
    const Literal b = s.size > 1 ? 2 * s.variables[1] : false_literal;
    unite(a, opposite_if(s.parity, b), equation.vertex);
    return true;
  }

  // Merges the equations that have become short because more classes are known.
  void substitute()
  {
    std::size_t size = 0;
    do {
      size = m_long_equations.size();
      const auto is_merged = [&](const Equation& equation) { return merge(equation); };
      m_long_equations.erase(std::remove_if(m_long_equations.begin(), m_long_equations.end(), is_merged),
                             m_long_equations.end());
    } while(m_long_equations.size() < size);
  }

  // Merges classes by sums of long equations; returns whether any such merge was possible.
  bool merge_combinations()
  {
    Parity_elimination elimination;
    for(const Equation& equation : m_long_equations) {
      const Parity_sum s = sum(equation);
      std::vector<Index> variables(s.variables.begin(), s.variables.begin() + s.size);
      std::sort(variables.begin(), variables.end());
      if(!elimination.add({std::move(variables), s.parity, equation.vertex})) {
        m_conflict.v = equation.vertex;
        return false;
      }
    }
    bool has_merged = false;
    for(const auto& [pivot, row] : elimination.rows()) {
      if(row.variables.size() > 2)
        continue;
      const Literal other = row.variables.size() > 1 ? 2 * row.variables[1] : false_literal;
      has_merged = true;
      unite(2 * pivot, opposite_if(row.parity, other), row.vertex);
    }
    return has_merged && !m_conflict;
  }

  const Bundle_pairs<Network>& m_pairs;
  const Network& m_network;
  const Triangulation& m_triangulation;
  Parity_classes m_classes;
  std::vector<Equation> m_long_equations;
  Order_conflict m_conflict;

  // of the vertex being processed
  Vertex_index m_vertex = null_index;
  bool m_has_border = false;
  Indexed_by<Halfedge_index, Lazy_array<Index>> m_position; // of an incident edge, clockwise from the cut
  std::vector<Index> m_single_ends_before;                  // by position
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_BUNDLE_ORDER_H
