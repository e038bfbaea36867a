// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_CONSTRAINED_SYSTEM_H
#define CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_CONSTRAINED_SYSTEM_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/check_vertex.h>
#include <CGAL/Flip_geodesics/intrinsic_faces.h>

#include <boost/pending/disjoint_sets.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Splits a symmetric system over all vertices into the free ones and those whose value is given: the free block, which
 * is to be solved, and the block that carries the given values to its right-hand side.
 */
template <class Scalar>
class Constrained_system
{
public:
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  /* is_left_out: neither free nor given, such as isolated vertices. */
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

  /* The right-hand side of the free block. values: of all vertices, 0 where not given. */
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

/* Marks the listed vertices. Throws Vertex_out_of_range_error. */
inline std::vector<char> marked_vertices(std::size_t number_of_vertices, const std::vector<Vertex_index>& vertices)
{
  std::vector<char> result(number_of_vertices, 0);
  for(Vertex_index v : vertices) {
    check_vertex(v, static_cast<Index>(number_of_vertices));
    result[static_cast<std::size_t>(v.idx())] = 1;
  }
  return result;
}

/* For each vertex a vertex of its component, itself if it is isolated. */
inline std::vector<Index> components(std::size_t number_of_vertices, const std::vector<Intrinsic_face>& faces)
{
  std::vector<Index> rank(number_of_vertices, 0), parent(number_of_vertices);
  boost::disjoint_sets<Index*, Index*> sets(rank.data(), parent.data());
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    sets.make_set(static_cast<Index>(v));
  for(const Intrinsic_face& face : faces)
    for(int i = 0; i < 3; ++i)
      sets.union_set(face.vertices[i].idx(), face.vertices[(i + 1) % 3].idx());
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
      throw Singular_problem_error("nothing is given in the component of vertex " + std::to_string(v), {v});
}

} // namespace internal

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_OPERATORS_CONSTRAINED_SYSTEM_H
