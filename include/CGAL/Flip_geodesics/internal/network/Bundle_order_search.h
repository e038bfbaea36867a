// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_BUNDLE_ORDER_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_BUNDLE_ORDER_SEARCH_H

#include <CGAL/Flip_geodesics/internal/network/Bundle_order.h>
#include <CGAL/Flip_geodesics/internal/network/Parity_classes.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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
        if(m_choices_of[i].size() > 0 && !has_fitting_defaults(i) && !search(i))
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
    std::vector<Segment_index> result(static_cast<std::size_t>(segments.size()));
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

  // Orders s and t if some u is known to lie between them; examines 64 such u at a time.
  bool imply_in_bundle(Index bundle)
  {
    const auto segments = m_pairs.segments(bundle);
    const Bit_matrix right = bits_of([&](Segment_index s, Segment_index t) { return is_left(s, t); }, segments);
    const Bit_matrix left = bits_of([&](Segment_index s, Segment_index t) { return is_left(t, s); }, segments);
    for(Index i = 0; i < segments.size(); ++i)
      for(Index j = 0; j < segments.size(); ++j) {
        const Segment_index s(segments.first[i]), t(segments.first[j]);
        if(s != t && !is_left(s, t) && have_common_bit(right[i], left[j]) && !assign(m_pairs.is_left(s, t)))
          return fail_at_bundle(s);
      }
    return true;
  }

  using Bit_matrix = std::vector<std::vector<std::uint64_t>>;

  template <class Relation>
  static Bit_matrix bits_of(const Relation& relation, const Buckets::Range& segments)
  {
    const auto size = static_cast<std::size_t>(segments.size());
    Bit_matrix result(size, std::vector<std::uint64_t>((size + 63) / 64, 0));
    for(std::size_t i = 0; i < size; ++i)
      for(std::size_t j = 0; j < size; ++j)
        if(i != j && relation(Segment_index(segments.first[i]), Segment_index(segments.first[j])))
          result[i][j / 64] |= std::uint64_t(1) << (j % 64);
    return result;
  }

  static bool have_common_bit(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b)
  {
    for(std::size_t i = 0; i < a.size(); ++i)
      if((a[i] & b[i]) != 0)
        return true;
    return false;
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
    m_work += static_cast<std::size_t>(segments.size());
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
    std::vector<char> is_taken(static_cast<std::size_t>(segments.size()), 0);
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
      if(m_choices_of[i].size() > 0)
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_BUNDLE_ORDER_SEARCH_H
