// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_PRIMITIVE_ROWS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_PRIMITIVE_ROWS_H

#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Vectors of integers that are part of a basis of all of them, taken one by one.
 *
 * A unimodular matrix U is kept, such that the k vectors times U have nothing but zeros from column k on. So another one
 * can be taken if what it has there, times U, has no common divisor.
 */
class Primitive_rows
{
public:
  using Row = std::vector<std::int64_t>;

  explicit Primitive_rows(std::size_t n)
    : m_matrix(n, std::vector<Integer>(n, Integer(0)))
  {
    for(std::size_t i = 0; i < n; ++i)
      m_matrix[i][i] = Integer(1);
  }

  std::size_t size() const { return m_size; }

  /* Takes a vector if it is part of a basis together with those that are there. Is it? */
  bool add(const Row& row)
  {
    std::vector<Integer> rest = rest_of(row);
    std::size_t pivot = smallest(rest);
    if(pivot == rest.size())
      return false;
    // Euclid's algorithm for columns of the matrix
    for(bool is_one_left = false; !is_one_left; pivot = smallest(rest)) {
      is_one_left = true;
      for(std::size_t c = 0; c < rest.size(); ++c) {
        if(c == pivot || rest[c].sign() == 0)
          continue;
        const Integer q = rest[c] / rest[pivot];
        rest[c] -= q * rest[pivot];
        for(std::vector<Integer>& r : m_matrix)
          r[m_size + c] -= q * r[m_size + pivot];
        is_one_left = is_one_left && rest[c].sign() == 0;
      }
    }
    if(absolute(rest[pivot]) != Integer(1))
      return false;
    for(std::vector<Integer>& r : m_matrix)
      r[m_size].swap(r[m_size + pivot]);
    ++m_size;
    return true;
  }

  /* Combinations of rows that generate the same as all of them, together with the vectors that are there.
   * \pre those are combinations of the rows, which have a basis that is part of one of all vectors */
  std::vector<Row> completed_by(const std::vector<Row>& rows) const
  {
    std::vector<Pair> pairs;
    for(const Row& row : rows)
      pairs.push_back({rest_of(row), std::vector<Integer>(row.begin(), row.end())});
    std::vector<Row> result;
    for(std::size_t c = 0; c < m_matrix.size() - m_size; ++c) {
      // Euclid's algorithm for rows: one is left with something in this column, and taken.
      auto pivot = smallest(pairs, c);
      if(pivot == pairs.end())
        continue;
      for(bool is_one_left = false; !is_one_left; pivot = smallest(pairs, c)) {
        is_one_left = true;
        for(Pair& pair : pairs)
          if(&pair != &*pivot && pair.rest[c].sign() != 0) {
            subtract(pair.rest[c] / pivot->rest[c], *pivot, pair);
            is_one_left = is_one_left && pair.rest[c].sign() == 0;
          }
      }
      result.emplace_back();
      for(const Integer& x : pivot->row)
        result.back().push_back(static_cast<std::int64_t>(x));
      pairs.erase(pivot);
    }
    return result;
  }

private:
  struct Pair
  {
    std::vector<Integer> rest, row;
  };

  // A row times the columns of the matrix that are not used up.
  std::vector<Integer> rest_of(const Row& row) const
  {
    std::vector<Integer> result(row.size() - m_size, Integer(0));
    for(std::size_t i = 0; i < row.size(); ++i)
      if(row[i] != 0)
        for(std::size_t c = 0; c < result.size(); ++c)
          if(m_matrix[i][m_size + c].sign() != 0)
            result[c] += Integer(row[i]) * m_matrix[i][m_size + c];
    return result;
  }

  static bool is_smaller(const Integer& a, const Integer& b)
  {
    return a.sign() != 0 && (b.sign() == 0 || absolute(a) < absolute(b));
  }

  // The smallest number that is not zero, the end if there is none.
  static std::size_t smallest(const std::vector<Integer>& numbers)
  {
    const auto found = std::min_element(numbers.begin(), numbers.end(), is_smaller);
    return found == numbers.end() || found->sign() == 0 ? numbers.size()
                                                        : static_cast<std::size_t>(found - numbers.begin());
  }

  static std::vector<Pair>::iterator smallest(std::vector<Pair>& pairs, std::size_t column)
  {
    const auto found = std::min_element(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) {
      return is_smaller(a.rest[column], b.rest[column]);
    });
    return found == pairs.end() || found->rest[column].sign() == 0 ? pairs.end() : found;
  }

  static void subtract(const Integer& factor, const Pair& from, Pair& to)
  {
    for(std::size_t c = 0; c < to.rest.size(); ++c)
      to.rest[c] -= factor * from.rest[c];
    for(std::size_t c = 0; c < to.row.size(); ++c)
      to.row[c] -= factor * from.row[c];
  }

  std::vector<std::vector<Integer>> m_matrix;
  std::size_t m_size = 0; // of the vectors that are there
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_PRIMITIVE_ROWS_H
