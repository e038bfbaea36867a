// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_PARITY_ELIMINATION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_PARITY_ELIMINATION_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Linear equations modulo 2, brought into echelon form one by one. */
class Parity_elimination
{
public:
  /* The variables, in increasing order, sum up to `parity`. */
  struct Row
  {
    std::vector<Index> variables;
    bool parity;
    Vertex_index vertex; // where the equation comes from
  };

  /* The sparse rows can fill up. Beyond this number of entries written, equations are left out: 0.1 s. */
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

  /* By their first variables. */
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

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_PARITY_ELIMINATION_H
