// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_PARITY_CLASSES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_PARITY_CLASSES_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A literal is a two-valued variable or its opposite: 2 * variable, or 2 * variable + 1. Variable 0 is the constant
 * `false`, so that the literals 0 and 1 are `false` and `true`.
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
  struct Range
  {
    const Index* first;
    const Index* last;

    const Index* begin() const { return first; }
    const Index* end() const { return last; }
    Index size() const { return static_cast<Index>(last - first); }
  };

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
    return {m_items.data() + m_begin[bucket], m_items.data() + m_begin[bucket + 1]};
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_PARITY_CLASSES_H
