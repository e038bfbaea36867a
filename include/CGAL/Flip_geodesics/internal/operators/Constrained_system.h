// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_CONSTRAINED_SYSTEM_H
#define CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_CONSTRAINED_SYSTEM_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/for_each_index.h>

#include <boost/container/small_vector.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * Splits a symmetric system over all vertices into the free ones and those with given values: the free block, whose
 * system is solved, and the block that maps the given values to its right-hand side.
 */
template <class Scalar>
class Constrained_system
{
public:
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  /* \param is_left_out vertices neither free nor given, such as isolated ones */
  Constrained_system(const Matrix& matrix, const std::vector<char>& is_given, const std::vector<char>& is_left_out)
    : m_number(is_given.size(), null_index)
  {
    for(std::size_t v = 0; v < is_given.size(); ++v)
      if(is_given[v] == 0 && is_left_out[v] == 0) {
        m_number[v] = static_cast<Index>(m_free.size());
        m_free.push_back(static_cast<Index>(v));
      }
    std::vector<Eigen::Triplet<Scalar>> inner, outer;
    for(Eigen::Index column = 0; column < matrix.outerSize(); ++column)
      for(typename Matrix::InnerIterator entry(matrix, column); entry; ++entry) {
        const Index row = m_number[entry.row()];
        if(row == null_index)
          continue;
        if(m_number[column] != null_index)
          inner.emplace_back(row, m_number[column], entry.value());
        else if(is_given[column] != 0)
          outer.emplace_back(row, static_cast<int>(column), entry.value());
      }
    const Eigen::Index n = static_cast<Eigen::Index>(m_free.size());
    m_inner.resize(n, n);
    m_inner.setFromTriplets(inner.begin(), inner.end());
    m_outer.resize(n, matrix.cols());
    m_outer.setFromTriplets(outer.begin(), outer.end());
  }

  const Matrix& inner() const { return m_inner; }
  const std::vector<Index>& free_vertices() const { return m_free; }

  /* Returns the right-hand side of the free block. \param values of all vertices, 0 if not given */
  Vector right_hand_side(const Vector& load, const Vector& values) const { return restricted(load) - m_outer * values; }

  Vector restricted(const Vector& all) const
  {
    Vector result(static_cast<Eigen::Index>(m_free.size()));
    for(std::size_t i = 0; i < m_free.size(); ++i)
      result[static_cast<Eigen::Index>(i)] = all[m_free[i]];
    return result;
  }

  void insert(const Vector& solution, Vector& all) const
  {
    for(std::size_t i = 0; i < m_free.size(); ++i)
      all[m_free[i]] = solution[static_cast<Eigen::Index>(i)];
  }

private:
  std::vector<Index> m_number; // of the free vertices
  std::vector<Index> m_free;
  Matrix m_inner, m_outer;
};

/* Returns marks for the listed vertices. \throws Vertex_out_of_range_error */
inline std::vector<char> marked_vertices(std::size_t number_of_vertices, const std::vector<Vertex_index>& vertices)
{
  std::vector<char> result(number_of_vertices, 0);
  for(Vertex_index v : vertices) {
    check_vertex(v, static_cast<Index>(number_of_vertices));
    result[static_cast<std::size_t>(v.idx())] = 1;
  }
  return result;
}

/* Returns for each vertex a representative vertex of its component, itself if it is isolated. */
inline std::vector<Index> components(std::size_t number_of_vertices, const std::vector<Intrinsic_face>& faces)
{
  std::vector<Index> rank(number_of_vertices), parent(number_of_vertices);
  std::iota(parent.begin(), parent.end(), Index(0));
  boost::disjoint_sets<Index*, Index*> sets(rank.data(), parent.data());
  for(const Intrinsic_face& face : faces)
    for(int i : {1, 2})
      sets.union_set(face.vertices[0].idx(), face.vertices[i].idx());
  std::vector<Index> result(number_of_vertices);
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    result[v] = sets.find_set(static_cast<Index>(v));
  return result;
}

inline std::vector<char> isolated_vertices(std::size_t number_of_vertices, const std::vector<Intrinsic_face>& faces)
{
  std::vector<char> result(number_of_vertices, 1);
  for(const Intrinsic_face& face : faces)
    for(Vertex_index v : face.vertices)
      result[static_cast<std::size_t>(v.idx())] = 0;
  return result;
}

/* Throws Singular_problem_error unless a value is given in each component that has faces. */
inline void check_every_component(const std::vector<Index>& component, const std::vector<char>& is_given,
                                  const std::vector<char>& is_isolated)
{
  std::vector<char> has_value(component.size(), 0);
  for(std::size_t v = 0; v < component.size(); ++v)
    if(is_given[v] != 0)
      has_value[component[v]] = 1;
  for(std::size_t v = 0; v < component.size(); ++v)
    if(is_isolated[v] == 0 && has_value[component[v]] == 0)
      throw_naming<Singular_problem_error>("no value is given in the connected component of vertex ", Element{v},
                                           ", so the solution is not unique");
}

/*
 * The positions of the entries of finite element matrices, determined once. Any matrix is then filled column by column,
 * in parallel if desired, with bitwise identical results. Sorting triplets, the usual method, takes most of the
 * assembly time and cannot be parallelized.
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

  /* Returns the n x n matrix that sums entry(f, i, j) over faces f, at the row of corner i and the column of corner
   * j. */
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

  /* Returns the 2m x n matrix with the two numbers entry(f, i) in rows 2f and 2f + 1 and the column of corner i. */
  template <class Entry>
  Matrix face_matrix(const Entry& entry) const
  {
    const std::size_t n = m_first.size() - 1, m = m_corners.size() / 3;
    // A face with one vertex at several corners has one pair of entries in its column.
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

  // The vertex itself and those that share a face with it, in order.
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

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_CONSTRAINED_SYSTEM_H
