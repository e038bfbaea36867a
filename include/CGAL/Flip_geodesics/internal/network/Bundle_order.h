// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_BUNDLE_ORDER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_BUNDLE_ORDER_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/network/Segment_store.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>

#include <boost/dynamic_bitset.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * A literal is a two-valued variable or its opposite: 2 * variable, or 2 * variable + 1. Variable 0 is the constant
 * `false`, so the literals 0 and 1 are `false` and `true`.
 */
using Literal = Index;

constexpr Literal false_literal = 0, true_literal = 1;

inline Index variable(Literal a) { return a >> 1; }
inline bool is_opposite(Literal a) { return (a & 1) != 0; }
inline Literal opposite(Literal a) { return a ^ 1; }
inline Literal opposite_if(bool condition, Literal a) { return condition ? opposite(a) : a; }
inline Literal constant(bool value) { return value ? true_literal : false_literal; }

/*
 * Boolean variables of which some are known to be equal and some to be opposite: a disjoint-set forest with a parity at
 * each link. The representative of a class is its smallest variable; for variables of known value it is the constant.
 */
class Parity_classes
{
public:
  explicit Parity_classes(Index number_of_variables)
    : m_parents(static_cast<std::size_t>(number_of_variables))
  {
    for(Index v = 0; v < number_of_variables; ++v)
      m_parents[v] = 2 * v;
  }

  Index number_of_variables() const { return static_cast<Index>(m_parents.size()); }

  /* Returns the literal of the class's representative that equals `a`. */
  Literal representative(Literal a)
  {
    for(Index v = variable(a); variable(m_parents[v]) != v; v = variable(a)) {
      const Literal parent = m_parents[v];
      m_parents[v] = opposite_if(is_opposite(parent), m_parents[variable(parent)]); // path halving
      a = opposite_if(is_opposite(a), m_parents[v]);
    }
    return a;
  }

  /* Makes two literals equal. Returns false and changes nothing if they are known to be opposite. */
  bool unite(Literal a, Literal b)
  {
    a = representative(a);
    b = representative(b);
    if(variable(a) == variable(b))
      return a == b;
    if(variable(a) < variable(b))
      std::swap(a, b);
    m_parents[variable(a)] = opposite_if(is_opposite(a), b);
    return true;
  }

private:
  std::vector<Literal> m_parents;
};

/* Items 0, 1, ... sorted stably into buckets; an item with a negative key is left out. */
class Buckets
{
public:
  using Range = boost::iterator_range<const Index*>;

  Buckets() = default;

  Buckets(Index number_of_buckets, const std::vector<Index>& key_of_item)
    : m_begin(static_cast<std::size_t>(number_of_buckets) + 1)
  {
    for(Index key : key_of_item)
      if(key >= 0)
        ++m_begin[key + 1];
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    m_items.resize(static_cast<std::size_t>(m_begin.back()));
    std::vector<Index> end(m_begin.begin(), m_begin.end() - 1);
    for(std::size_t i = 0; i < key_of_item.size(); ++i)
      if(key_of_item[i] >= 0)
        m_items[end[key_of_item[i]]++] = static_cast<Index>(i);
  }

  Index size() const { return static_cast<Index>(m_begin.size()) - 1; }

  Range operator[](Index bucket) const
  {
    return Range(m_items.data() + m_begin[bucket], m_items.data() + m_begin[bucket + 1]);
  }

private:
  std::vector<Index> m_begin = {0};
  std::vector<Index> m_items;
};

/* Linear equations modulo 2, reduced to echelon form one by one. */
class Parity_elimination
{
public:
  /* The equation that the variables, in increasing order, sum up to `parity`. */
  struct Row
  {
    std::vector<Index> variables;
    bool parity;
    Vertex_index vertex; // the origin of the equation
  };

  /* Elimination can fill the sparse rows. When more entries than this have been written, which takes 0.1 s, further
   * equations are left out. */
  static constexpr std::size_t most_work = 20000000;

  /* Returns false if the equation contradicts the others. */
  bool add(Row row)
  {
    while(!row.variables.empty()) {
      const auto known = m_rows.find(row.variables.front());
      if(known == m_rows.end()) {
        const Index pivot = row.variables.front();
        m_rows.emplace(pivot, std::move(row));
        return true;
      }
      if(m_work > most_work)
        return true;
      add_to(row, known->second);
    }
    return !row.parity;
  }

  /* The rows by their first variables. */
  const std::map<Index, Row>& rows() const { return m_rows; }

private:
  void add_to(Row& row, const Row& other)
  {
    std::vector<Index> sum;
    std::set_symmetric_difference(row.variables.begin(), row.variables.end(), other.variables.begin(),
                                  other.variables.end(), std::back_inserter(sum));
    row.variables.swap(sum);
    row.parity = row.parity != other.parity;
    m_work += row.variables.size() + 1;
  }

  std::map<Index, Row> m_rows;
  std::size_t m_work = 0;
};

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
      throw Crossing_curves_error("two curves, or two parts of one curve, cross at vertex " + std::to_string(v.idx()),
                                  elements);
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
 * Equations in one or two variables merge classes, so a whole run of overlapping segments becomes one unknown.
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

  Segment_end mate(const Segment_end& end) const { return joined_end(m_network, end); }

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

/*
 * Assigns values to the classes of `Crossing_equations` such that the long equations hold as well and each bundle has
 * an order, that is, no three segments are cyclically left of each other.
 *
 * Classes that share a bundle or an equation form a subproblem. In each, all defaults are tried together first, which
 * suffices for copies of curves. If they contradict each other, classes are set to their defaults one by one, each
 * followed by its implications; a contradiction reverses the last default that has not been reversed yet. After some
 * retries the search restarts, beginning with the classes that had no value left.
 *
 * The search takes time linear in the number of pairs if the defaults fit. Otherwise each retry takes at most the
 * number of pairs times the size of the largest bundle. Retries require interlocking turns: of 13 000 networks of
 * random walks of up to 30 steps on meshes of 3 to 10 vertices, 36 needed any, and at most 64; of 3000 with up to 100
 * steps, one was aborted.
 */
template <class Network>
class Bundle_order_search
{
  using Triangulation = typename Network::Triangulation;
  using Equation = typename Crossing_equations<Network>::Equation;

public:
  /* The number of segments examined for one subproblem, about 1 s, after which no choice is reversed any more. */
  static constexpr std::size_t default_most_work = 200000000;

  explicit Bundle_order_search(Crossing_equations<Network>& equations, std::size_t most_work = default_most_work)
    : m_equations(equations)
    , m_pairs(equations.pairs())
    , m_triangulation(m_pairs.network().triangulation())
    , m_most_work(most_work)
    , m_value(static_cast<std::size_t>(m_pairs.number_of_variables()), Value::UNKNOWN)
  {
    m_value[variable(false_literal)] = Value::NO;
    flatten_classes();
    find_members();
    find_equations();
  }

  /* Returns the conflict that prevents an order, if there is one. */
  Order_conflict run()
  {
    find_problems();
    if(!have_fitting_defaults()) {
      if(!imply_from_known_pairs())
        return m_conflict;
      find_problems();
      for(Index i = 0; i < m_choices_of.size(); ++i)
        if(!m_choices_of[i].empty() && !has_fitting_defaults(i) && !search(i))
          return m_conflict;
    }
    for(Index i = 0; i < m_pairs.number_of_bundles(); ++i)
      if(!is_ordered(i))
        return {m_triangulation.tail(first_side(m_pairs.edge(i)))};
    return {};
  }

  /* Returns the segments of a bundle from left to right. \pre `run()` has found no conflict */
  std::vector<Segment_index> order(Index bundle) const
  {
    const auto segments = m_pairs.segments(bundle);
    std::vector<Segment_index> result(segments.size());
    for(Index i : segments)
      result[static_cast<std::size_t>(number_on_left(bundle, Segment_index(i)))] = Segment_index(i);
    return result;
  }

private:
  enum class Value : char { NO, YES, UNKNOWN };

  struct Choice
  {
    std::size_t trail_size; // before the choice
    Index choice;
    bool is_second; // whether the default has failed
  };

  /// \name The classes
  /// @{

  void flatten_classes()
  {
    for(Index v = 0; v < m_pairs.number_of_variables(); ++v)
      m_class.push_back(m_equations.classes().representative(2 * v));
  }

  Literal class_of(Literal a) const { return opposite_if(is_opposite(a), m_class[variable(a)]); }

  void find_members()
  {
    std::vector<Index> keys(static_cast<std::size_t>(m_pairs.end_of_pairs()), null_index);
    for(Index v = 1; v < m_pairs.end_of_pairs(); ++v)
      if(is_unknown(2 * v))
        keys[v] = variable(m_class[v]);
    m_members = Buckets(m_pairs.number_of_variables(), keys);
  }

  // Four items for each equation, one per literal.
  void find_equations()
  {
    std::vector<Index> keys;
    for(const Equation& equation : m_equations.long_equations())
      for(Literal a : equation.literals)
        keys.push_back(is_unknown(a) ? variable(class_of(a)) : null_index);
    m_equation_items = Buckets(m_pairs.number_of_variables(), keys);
  }

  bool is_unknown(Literal a) const { return m_value[variable(class_of(a))] == Value::UNKNOWN; }

  bool is_true(Literal a) const
  {
    const Literal c = class_of(a);
    return m_value[variable(c)] == (is_opposite(c) ? Value::NO : Value::YES);
  }

  bool is_left(Segment_index s, Segment_index t) const { return is_true(m_pairs.is_left(s, t)); }

  /// @}
  /// \name Implications
  /// @{

  // Returns false if the opposite is known.
  bool assign(Literal a)
  {
    if(!is_unknown(a))
      return is_true(a);
    const Literal c = class_of(a);
    m_value[variable(c)] = is_opposite(c) ? Value::NO : Value::YES;
    m_trail.push_back(variable(c));
    return true;
  }

  void undo(std::size_t trail_size)
  {
    for(; m_trail.size() > trail_size; m_trail.pop_back())
      m_value[m_trail.back()] = Value::UNKNOWN;
    m_propagated = trail_size;
  }

  bool imply_from_known_pairs()
  {
    for(Index i = 0; i < m_pairs.number_of_bundles(); ++i)
      if(!imply_in_bundle(i))
        return false;
    return propagate(true);
  }

  // Orders s and t if some u is known to lie between them; bit sets examine many such u at a time.
  bool imply_in_bundle(Index bundle)
  {
    const auto segments = m_pairs.segments(bundle);
    const auto segment = [&](std::size_t i) { return Segment_index(segments.begin()[i]); };
    const std::size_t size = segments.size();
    std::vector<boost::dynamic_bitset<>> on_right(size, boost::dynamic_bitset<>(size)), on_left = on_right;
    for(std::size_t i = 0; i < size; ++i)
      for(std::size_t j = 0; j < size; ++j)
        if(i != j && is_left(segment(i), segment(j))) {
          on_right[i].set(j);
          on_left[j].set(i);
        }
    for(std::size_t i = 0; i < size; ++i)
      for(std::size_t j = 0; j < size; ++j)
        if(i != j && !is_left(segment(i), segment(j)) && on_right[i].intersects(on_left[j]) &&
           !assign(m_pairs.is_left(segment(i), segment(j))))
          return fail_at_bundle(segment(i));
    return true;
  }

  // Returns false if the values contradict each other. The orders of the bundles can be ignored.
  bool propagate(bool uses_orders)
  {
    for(; m_propagated < m_trail.size(); ++m_propagated) {
      const Index c = m_trail[m_propagated];
      for(Index item : m_equation_items[c])
        if(!imply_from_equation(m_equations.long_equations()[item / 4]))
          return false;
      if(uses_orders)
        for(Index v : m_members[c])
          if(!imply_from_order(v))
            return false;
    }
    return true;
  }

  bool imply_from_equation(const Equation& equation)
  {
    Parity_sum sum;
    for(Literal a : equation.literals)
      sum.add(is_unknown(a) ? class_of(a) : constant(is_true(a)));
    const bool is_possible = sum.size > 1 ||
                             (sum.size == 1 && assign(opposite_if(!sum.parity, 2 * sum.variables[0]))) ||
                             (sum.size == 0 && !sum.parity);
    if(!is_possible)
      m_conflict.v = equation.vertex;
    return is_possible;
  }

  bool imply_from_order(Index pair)
  {
    auto [s, t] = m_pairs.segments_of_pair(pair);
    const auto segments = m_pairs.segments(m_pairs.bundle_of(s));
    m_work += segments.size();
    if(!is_left(s, t))
      std::swap(s, t);
    for(Index i : segments) {
      const Segment_index u(i);
      if(u == s || u == t)
        continue;
      if((is_left(u, s) && !assign(m_pairs.is_left(u, t))) || (is_left(t, u) && !assign(m_pairs.is_left(s, u))))
        return fail_at_bundle(s);
    }
    return true;
  }

  bool fail_at_bundle(Segment_index s)
  {
    m_conflict.v = m_triangulation.tail(first_side(m_pairs.edge(m_pairs.bundle_of(s))));
    return false;
  }

  Index number_on_left(Index bundle, Segment_index s) const
  {
    Index count = 0;
    for(Index t : m_pairs.segments(bundle))
      count += t != s.idx() && is_left(Segment_index(t), s) ? 1 : 0;
    return count;
  }

  // No three segments are cyclically left of each other if and only if the numbers of segments to the left all differ.
  bool is_ordered(Index bundle) const
  {
    const auto segments = m_pairs.segments(bundle);
    std::vector<char> is_taken(segments.size(), 0);
    for(Index s : segments) {
      char& place = is_taken[static_cast<std::size_t>(number_on_left(bundle, Segment_index(s)))];
      if(place != 0)
        return false;
      place = 1;
    }
    return true;
  }

  /// @}
  /// \name The subproblems
  /// @{

  // Subproblems are numbered by their representatives.
  void find_problems()
  {
    Parity_classes problems(m_pairs.number_of_variables());
    const auto join = [&](Index& first, Literal a) {
      if(!is_unknown(a))
        return;
      const Index c = variable(class_of(a));
      first = first == null_index ? c : first;
      problems.unite(2 * first, 2 * c);
    };
    std::vector<Index> bundle_class(static_cast<std::size_t>(m_pairs.number_of_bundles()), null_index);
    for(Index v = 1; v < m_pairs.end_of_pairs(); ++v)
      join(bundle_class[m_pairs.bundle_of(m_pairs.segments_of_pair(v).first)], 2 * v);
    for(const Equation& equation : m_equations.long_equations()) {
      Index first = null_index;
      for(Literal a : equation.literals)
        join(first, a);
    }
    const auto problem_of = [&](Index c) { return c == null_index ? c : variable(problems.representative(2 * c)); };
    std::transform(bundle_class.begin(), bundle_class.end(), bundle_class.begin(), problem_of);
    m_bundles_of = Buckets(m_pairs.number_of_variables(), bundle_class);
    find_choices(problem_of);
  }

  // The unknown classes, ordered by the oldest segments involved, with their defaults: the older segment is on the left
  // as seen along it, or on the right if its curve has turned back an odd number of times. Among segments that nothing
  // else orders, the oldest is then outermost, and a curve that turns back lies beside itself, on one side of all
  // younger ones.
  template <class ProblemOf>
  void find_choices(const ProblemOf& problem_of)
  {
    std::vector<char> is_known(static_cast<std::size_t>(m_pairs.number_of_variables()), 0);
    std::vector<Index> problem;
    m_choices.clear();
    const std::vector<Halfedge_index> headings = initial_headings();
    for(Segment_index s(1); s.idx() < m_pairs.network().end_of_segment_ids(); ++s) {
      if(m_pairs.bundle_of(s) == null_index)
        continue;
      const auto segments = m_pairs.segments(m_pairs.bundle_of(s));
      for(auto t = std::upper_bound(segments.begin(), segments.end(), s.idx()); t != segments.end(); ++t) {
        const Literal a = class_of(m_pairs.is_left(headings[static_cast<std::size_t>(s.idx())], s, Segment_index(*t)));
        if(!is_unknown(a) || is_known[variable(a)] != 0)
          continue;
        is_known[variable(a)] = 1;
        m_choices.push_back(a);
        problem.push_back(problem_of(variable(a)));
      }
    }
    m_choices_of = Buckets(m_pairs.number_of_variables(), problem);
  }

  // The halfedge of each segment, or its twin if the curve has turned back an odd number of times before.
  std::vector<Halfedge_index> initial_headings() const
  {
    const Network& network = m_pairs.network();
    std::vector<Halfedge_index> result(static_cast<std::size_t>(network.end_of_segment_ids()));
    for(Curve_index c : descriptors<Curve_index>(network.number_of_curves())) {
      Halfedge_index last; // the initial heading of the previous segment
      network.for_each_segment(c, [&](Segment_index s) {
        const Halfedge_index h = network.halfedge(s);
        const Segment_index p = network.previous(s);
        const bool has_turned = last != null_index && h == Triangulation::twin(network.halfedge(p));
        const bool is_turned = last != null_index && (last != network.halfedge(p)) != has_turned;
        last = result[s.idx()] = is_turned ? Triangulation::twin(h) : h;
      });
    }
    return result;
  }

  // Assigns the defaults to the subproblems in which they fit; returns whether these are all subproblems.
  bool have_fitting_defaults()
  {
    bool do_all_fit = true;
    for(Index i = 0; i < m_choices_of.size(); ++i)
      if(!m_choices_of[i].empty())
        do_all_fit = has_fitting_defaults(i) && do_all_fit;
    return do_all_fit;
  }

  bool has_fitting_defaults(Index problem)
  {
    const std::size_t trail_size = m_trail.size();
    for(Index i : m_choices_of[problem])
      assign(m_choices[i]);
    const auto bundles = m_bundles_of[problem];
    if(propagate(false) && std::all_of(bundles.begin(), bundles.end(), [&](Index i) { return is_ordered(i); }))
      return true;
    undo(trail_size);
    return false;
  }

  bool search(Index problem)
  {
    make_queue(problem);
    m_work = 0;
    constexpr std::size_t first_most = 20;
    std::size_t retries_left = first_most;
    for(std::size_t most = first_most;; retries_left = most += most / 2) { // restart with the current queue
      const Search_outcome outcome = search_queue(retries_left);
      if(outcome != Search_outcome::OUT_OF_RETRIES)
        return outcome == Search_outcome::FOUND;
    }
  }

  // The choices in most equations come first, since the others seldom matter.
  void make_queue(Index problem)
  {
    const auto choices = m_choices_of[problem];
    const auto number_of_items = [&](Index i) { return m_equation_items[variable(m_choices[i])].size(); };
    m_queue.assign(choices.begin(), choices.end());
    std::stable_sort(m_queue.begin(), m_queue.end(),
                     [&](Index i, Index j) { return number_of_items(i) > number_of_items(j); });
  }

  enum class Search_outcome { FOUND, CONFLICT, OUT_OF_RETRIES };

  // When no retries are left, all choices are reversed.
  Search_outcome search_queue(std::size_t retries_left)
  {
    m_made.clear();
    for(std::size_t i = 0; i < m_queue.size();) {
      if(!is_unknown(m_choices[m_queue[i]])) {
        ++i;
        continue;
      }
      m_made.push_back({m_trail.size(), m_queue[i], false});
      assign(m_choices[m_queue[i]]);
      for(; !propagate(true); i = 0) {
        if(!retry())
          return Search_outcome::CONFLICT;
        if(--retries_left == 0) {
          undo(m_made.front().trail_size);
          return Search_outcome::OUT_OF_RETRIES;
        }
      }
    }
    return Search_outcome::FOUND;
  }

  // Reverses choices until one has another value left, and assigns it. Those without another value come first from now
  // on, so that the search soon detects whether they still have none. Returns false if no choice is left or the work
  // limit is reached.
  bool retry()
  {
    for(; !m_made.empty() && m_made.back().is_second; m_made.pop_back()) {
      const auto failed = std::find(m_queue.begin(), m_queue.end(), m_made.back().choice);
      std::rotate(m_queue.begin(), failed, failed + 1);
    }
    if(m_made.empty())
      return false;
    Choice& last = m_made.back();
    undo(last.trail_size);
    if(m_work > m_most_work) {
      const Index pair = *m_members[variable(m_choices[last.choice])].begin();
      const Halfedge_index h = m_pairs.network().halfedge(m_pairs.segments_of_pair(pair).first);
      m_conflict = {m_triangulation.tail(h), m_triangulation.head(h)};
      return false;
    }
    last.is_second = true;
    assign(opposite(m_choices[last.choice]));
    return true;
  }

  /// @}

  Crossing_equations<Network>& m_equations;
  const Bundle_pairs<Network>& m_pairs;
  const Triangulation& m_triangulation;
  const std::size_t m_most_work;

  std::vector<Literal> m_class; // by variable
  Buckets m_members;            // the pairs of an unknown class
  Buckets m_equation_items;     // its positions in long equations, four per equation

  std::vector<Value> m_value;   // of a class
  std::vector<Index> m_trail;   // the classes that have been assigned values, in order
  std::size_t m_propagated = 0; // the number of those whose implications have been drawn
  Order_conflict m_conflict;    // the last one; other choices may avoid it

  std::vector<Literal> m_choices;
  Buckets m_choices_of, m_bundles_of; // by subproblem
  std::vector<Index> m_queue;         // the choices of a subproblem
  std::vector<Choice> m_made;
  std::size_t m_work = 0;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_BUNDLE_ORDER_H
