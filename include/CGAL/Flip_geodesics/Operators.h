// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_OPERATORS_H
#define CGAL_FLIP_GEODESICS_OPERATORS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Plane_triangle.h>
#include <CGAL/Flip_geodesics/internal/operators/Matrix_pattern.h>
#include <CGAL/Flip_geodesics/internal/surface/for_each_index.h>
#include <CGAL/Flip_geodesics/intrinsic_faces.h>

#include <CGAL/tags.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsOperators
 *
 * The differential operators of linear finite elements on an intrinsic triangulation, as sparse matrices over `double`.
 * They need nothing but edge lengths, hence no flip changes what they mean; a Delaunay triangulation makes them better.
 *
 * Rows and columns: vertex \f$v\f$ of the triangulation has number \f$v\f$; face \f$f\f$ is the \f$f\f$-th that
 * `intrinsic_faces()` writes, which is `faces()[f]`. A vector in face \f$f\f$ has the coordinates \f$2f\f$ and
 * \f$2f+1\f$, in a frame whose first axis runs along the face's first halfedge, and whose second points to its left.
 *
 * With \f$n\f$ vertices and \f$m\f$ faces, the matrices take \f$O(m)\f$ time and space. They are snapshots: flips of
 * the triangulation do not reach them.
 *
 * The Laplacian of intrinsic triangulations is that of [BS07].
 *
 * \tparam Triangulation a model of `IntrinsicTriangulation`
 * \tparam ConcurrencyTag `CGAL::Sequential_tag`, or `CGAL::Parallel_tag` where TBB is linked; the results are the same
 */
template <class Triangulation, class ConcurrencyTag = CGAL::Sequential_tag>
class Operators
{
public:
  using Matrix = Eigen::SparseMatrix<double>; ///< rows and columns as the class says
  using Vector = Eigen::VectorXd;             ///< a number per vertex or face, or two per face

  /*!
   * Reads the faces of a triangulation, all of them. \f$O(n + m)\f$.
   * \throws Degenerate_face_error if a face has no area as rounded to double, or so little that the cotangents are not
   *         finite; and what touching the faces throws
   */
  explicit Operators(const Triangulation& triangulation)
    : m_number_of_vertices(static_cast<std::size_t>(triangulation.number_of_vertices()))
  {
    intrinsic_faces(triangulation, std::back_inserter(m_faces));
    m_triangles.resize(m_faces.size());
    internal::for_each_index<ConcurrencyTag>(m_faces.size(), [this](std::size_t f) { lay_out(f); });
    m_pattern = internal::Matrix_pattern<ConcurrencyTag>(m_number_of_vertices, m_faces);
  }

  /// The number of vertices, \f$n\f$.
  std::size_t number_of_vertices() const { return m_number_of_vertices; }

  /// The faces by number.
  const std::vector<Intrinsic_face>& faces() const { return m_faces; }

  /// The areas of the faces, \f$m\f$ numbers.
  Vector face_areas() const
  {
    Vector result(m_faces.size());
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      result[static_cast<Eigen::Index>(f)] = m_triangles[f].area;
    return result;
  }

  /*!
   * The weak (integrated) Laplacian, \f$n \times n\f$, symmetric and positive semi-definite: \f$u^T L u\f$ is the
   * Dirichlet energy \f$\int |\nabla u|^2\f$. Its entries are the cotangent weights
   * \f$L_{ij} = -(\cot\alpha_{ij} + \cot\beta_{ij})/2\f$.
   */
  Matrix weak_laplacian() const
  {
    return m_pattern.vertex_matrix(m_faces, [this](std::size_t f, int i, int j) {
      const auto& cotangents = m_triangles[f].cotangents; // [i]: at corner i, opposite to the side from i+1 to i+2
      if(i == j)
        return (cotangents[(i + 1) % 3] + cotangents[(i + 2) % 3]) / 2;
      return -cotangents[3 - i - j] / 2;
    });
  }

  /*!
   * The Laplacian \f$\Delta = -M^{-1} L\f$ with the lumped mass matrix, \f$n \times n\f$: it takes values to values,
   * and is negative semi-definite. Rows of isolated vertices are zero.
   */
  Matrix laplacian() const
  {
    Matrix result = weak_laplacian();
    const Vector areas = vertex_areas();
    for(Eigen::Index column = 0; column < result.outerSize(); ++column)
      for(Matrix::InnerIterator entry(result, column); entry; ++entry)
        entry.valueRef() /= -areas[entry.row()];
    return result;
  }

  /// A third of the area of the faces about each vertex, \f$n\f$ numbers: the diagonal of `lumped_mass()`.
  Vector vertex_areas() const
  {
    Vector result = Vector::Zero(static_cast<Eigen::Index>(m_number_of_vertices));
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      for(Vertex_index v : m_faces[f].vertices)
        result[v.idx()] += m_triangles[f].area / 3;
    return result;
  }

  /// The lumped mass matrix, \f$n \times n\f$, diagonal.
  Matrix lumped_mass() const
  {
    const Vector areas = vertex_areas();
    Matrix result(areas.size(), areas.size());
    result.reserve(Eigen::VectorXi::Constant(areas.size(), 1));
    for(Eigen::Index v = 0; v < areas.size(); ++v)
      result.insert(v, v) = areas[v];
    result.makeCompressed();
    return result;
  }

  /// The consistent mass matrix, \f$n \times n\f$: \f$u^T M w\f$ is \f$\int u\,w\f$ of the piecewise linear functions.
  Matrix consistent_mass() const
  {
    return m_pattern.vertex_matrix(
        m_faces, [this](std::size_t f, int i, int j) { return m_triangles[f].area / (i == j ? 6 : 12); });
  }

  /// The gradient of a piecewise linear function, \f$2m \times n\f$.
  Matrix gradient() const
  {
    return m_pattern.face_matrix([this](std::size_t f, int i) { return m_triangles[f].hat_gradient(i); });
  }

  /*!
   * The weak (integrated) divergence of a vector field that is constant on each face, \f$n \times 2m\f$: entry \f$i\f$
   * of the result is \f$-\int \nabla\varphi_i \cdot X\f$ with the hat function \f$\varphi_i\f$. So
   * \f$-\mathrm{div}\,\nabla = L\f$.
   */
  Matrix divergence() const
  {
    Vector weights(2 * m_faces.size());
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      weights.segment<2>(static_cast<Eigen::Index>(2 * f)).setConstant(-m_triangles[f].area);
    return gradient().transpose() * weights.asDiagonal();
  }

private:
  void lay_out(std::size_t f)
  {
    m_triangles[f] = internal::Plane_triangle(m_faces[f].lengths);
    if(!m_triangles[f].has_finite_cotangents())
      throw Degenerate_face_error("the intrinsic face with vertices " + std::to_string(m_faces[f].vertices[0].idx()) +
                                      ", " + std::to_string(m_faces[f].vertices[1].idx()) + ", " +
                                      std::to_string(m_faces[f].vertices[2].idx()) +
                                      " has no area; flip to a Delaunay triangulation first, or mollify the metric",
                                  {static_cast<std::size_t>(m_faces[f].vertices[0].idx()),
                                   static_cast<std::size_t>(m_faces[f].vertices[1].idx()),
                                   static_cast<std::size_t>(m_faces[f].vertices[2].idx())});
  }

  std::size_t m_number_of_vertices;
  std::vector<Intrinsic_face> m_faces;
  std::vector<internal::Plane_triangle> m_triangles;
  internal::Matrix_pattern<ConcurrencyTag> m_pattern;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_OPERATORS_H
