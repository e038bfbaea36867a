// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_MATRIX_PATTERN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_MATRIX_PATTERN_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/for_each_index.h>
#include <CGAL/Flip_geodesics/intrinsic_faces.h>

#include <boost/container/small_vector.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Where the entries of finite element matrices lie, found once; then any matrix is filled column by column, all columns
 * at the same time if wanted, with the same bits. Sorting triplets, the usual way, takes most of an assembly and cannot
 * be shared out.
 */
template <class ConcurrencyTag>
class Matrix_pattern
{
public:
  using Matrix = Eigen::SparseMatrix<double>;
  using Storage_index = typename Matrix::StorageIndex;

  Matrix_pattern() = default;

  Matrix_pattern(std::size_t number_of_vertices, const std::vector<Intrinsic_face>& faces)
    : m_first(number_of_vertices + 1, 0)
    , m_corners(3 * faces.size())
  {
    for(const Intrinsic_face& face : faces)
      for(Vertex_index v : face.vertices)
        ++m_first[static_cast<std::size_t>(v.idx()) + 1];
    add_up(m_first);
    std::vector<Storage_index> next(m_first.begin(), m_first.end() - 1);
    for(std::size_t f = 0; f < faces.size(); ++f)
      for(int i = 0; i < 3; ++i)
        m_corners[next[faces[f].vertices[i].idx()]++] = static_cast<Storage_index>(3 * f) + i;
    find_neighbors(faces);
  }

  /* The n x n matrix that sums entry(f, i, j) over faces f, at the row of corner i and the column of corner j. */
  template <class Entry>
  Matrix vertex_matrix(const std::vector<Intrinsic_face>& faces, const Entry& entry) const
  {
    const std::size_t n = m_first.size() - 1;
    Matrix result = empty(n, m_first_neighbor);
    std::copy(m_neighbors.begin(), m_neighbors.end(), result.innerIndexPtr());
    for_each_index<ConcurrencyTag>(n, [&](std::size_t column) {
      const Storage_index first = m_first_neighbor[column], last = m_first_neighbor[column + 1];
      const Storage_index* const rows = m_neighbors.data() + first;
      double* const values = result.valuePtr() + first;
      std::fill(values, values + (last - first), 0.0);
      for_each_corner(column, [&](std::size_t f, int j) {
        for(int i = 0; i < 3; ++i)
          values[std::lower_bound(rows, rows + (last - first), faces[f].vertices[i].idx()) - rows] += entry(f, i, j);
      });
    });
    return result;
  }

  /* The 2m x n matrix with the two numbers entry(f, i) in rows 2f and 2f + 1 and the column of corner i. */
  template <class Entry>
  Matrix face_matrix(const Entry& entry) const
  {
    const std::size_t n = m_first.size() - 1, m = m_corners.size() / 3;
    // A face that has one vertex at several corners has one pair of entries in its column.
    std::vector<Storage_index> first(n + 1, 0);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t column) {
      std::size_t last = m;
      for_each_corner(column, [&](std::size_t f, int) {
        first[column + 1] += f != last ? 2 : 0;
        last = f;
      });
    });
    add_up(first);
    Matrix result = empty(2 * m, first);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t column) {
      std::size_t last = m;
      Storage_index position = first[column] - 2;
      for_each_corner(column, [&](std::size_t f, int i) {
        const bool is_new = f != last;
        position += is_new ? 2 : 0;
        const auto numbers = entry(f, i);
        for(int axis = 0; axis < 2; ++axis) {
          result.innerIndexPtr()[position + axis] = static_cast<Storage_index>(2 * f) + axis;
          result.valuePtr()[position + axis] = (is_new ? 0.0 : result.valuePtr()[position + axis]) + numbers[axis];
        }
        last = f;
      });
    });
    return result;
  }

private:
  static void add_up(std::vector<Storage_index>& counts)
  {
    for(std::size_t i = 1; i < counts.size(); ++i)
      counts[i] += counts[i - 1];
  }

  static Matrix empty(std::size_t rows, const std::vector<Storage_index>& first)
  {
    Matrix result(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(first.size()) - 1);
    result.resizeNonZeros(first.back());
    std::copy(first.begin(), first.end(), result.outerIndexPtr());
    return result;
  }

  // By face, then by corner.
  template <class Function>
  void for_each_corner(std::size_t v, const Function& function) const
  {
    for(Storage_index i = m_first[v]; i < m_first[v + 1]; ++i)
      function(static_cast<std::size_t>(m_corners[i] / 3), m_corners[i] % 3);
  }

  using Neighbors = boost::container::small_vector<Storage_index, 64>;

  // The vertex with itself and those that share a face with it, in order.
  Neighbors neighbors(std::size_t v, const std::vector<Intrinsic_face>& faces) const
  {
    Neighbors result;
    for_each_corner(v, [&](std::size_t f, int) {
      for(Vertex_index w : faces[f].vertices)
        result.push_back(w.idx());
    });
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  void find_neighbors(const std::vector<Intrinsic_face>& faces)
  {
    const std::size_t n = m_first.size() - 1;
    m_first_neighbor.assign(n + 1, 0);
    for_each_index<ConcurrencyTag>(
        n, [&](std::size_t v) { m_first_neighbor[v + 1] = static_cast<Storage_index>(neighbors(v, faces).size()); });
    add_up(m_first_neighbor);
    m_neighbors.resize(static_cast<std::size_t>(m_first_neighbor.back()));
    for_each_index<ConcurrencyTag>(n, [&](std::size_t v) {
      const Neighbors list = neighbors(v, faces);
      std::copy(list.begin(), list.end(), m_neighbors.begin() + m_first_neighbor[v]);
    });
  }

  std::vector<Storage_index> m_first, m_corners; // the corners at each vertex, three times the face plus the corner
  std::vector<Storage_index> m_first_neighbor, m_neighbors;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_MATRIX_PATTERN_H
