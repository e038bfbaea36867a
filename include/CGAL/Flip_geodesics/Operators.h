// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_OPERATORS_H
#define CGAL_FLIP_GEODESICS_OPERATORS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/operators/Constrained_system.h>
#include <CGAL/Flip_geodesics/internal/surface/for_each_index.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/math/constants/constants.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsOperators
 *
 * Assembles the differential operators of linear finite elements on an intrinsic triangulation as sparse matrices over
 * `double`.
 *
 * The matrices depend only on the edges of the triangulation and their lengths. If the triangulation is Delaunay, the
 * weak Laplacian is that of \cgalCite{BS07}.
 *
 * The rows and columns of the matrices are numbered as follows. The vertex with index \f$v\f$ has the number \f$v\f$.
 * The face with number \f$f\f$ is `faces()[f]`. The two coordinates of a vector in face \f$f\f$ have the numbers
 * \f$2f\f$ and \f$2f+1\f$. The first coordinate axis of this face is the direction of the halfedge
 * `faces()[f].halfedges[0]`; the second axis points to the left of this halfedge.
 *
 * Let \f$n\f$ be the number of vertices and \f$m\f$ the number of faces. Assembling a matrix takes \cgalBigO{n + m}
 * time and space. The object is a snapshot: later flips of the triangulation do not affect it.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulation`
 * \tparam ConcurrencyTag `CGAL::Sequential_tag`, or `CGAL::Parallel_tag` if TBB is linked; both yield the same results
 */
template <class Triangulation, class ConcurrencyTag = CGAL::Sequential_tag>
class Operators
{
public:
  using Matrix = Eigen::SparseMatrix<double>; ///< a sparse matrix
  using Vector = Eigen::VectorXd;             ///< a number per vertex or face, or two per face

  /*!
   * Reads all faces of a triangulation in \cgalBigO{n + m} time.
   * \throws Degenerate_face_error if the area of a face, rounded to double, is zero or so small that the cotangents are
   *        not finite, or if a face that has not been accessed before has a degenerate edge or violates the triangle
   *        inequality
   * \throws Invalid_mesh_error if a face that has not been accessed before is not a triangle
   * \throws Invalid_coordinate_error if a face that has not been accessed before has a coordinate or length that is not
   *        finite or is out of range
   */
  explicit Operators(const Triangulation& triangulation)
    : m_number_of_vertices(static_cast<std::size_t>(triangulation.number_of_vertices()))
  {
    intrinsic_faces(triangulation, std::back_inserter(m_faces));
    m_triangles.resize(m_faces.size());
    internal::for_each_index<ConcurrencyTag>(m_faces.size(), [this](std::size_t f) { lay_out(f); });
    m_pattern = internal::Matrix_pattern<ConcurrencyTag>(m_number_of_vertices, m_faces);
  }

  /// Returns the number of vertices, \f$n\f$.
  std::size_t number_of_vertices() const { return m_number_of_vertices; }

  /// Returns the faces in the order of their numbers, which is that of `intrinsic_faces()`.
  const std::vector<Intrinsic_face>& faces() const { return m_faces; }

  /// Returns the areas of the \f$m\f$ faces.
  Vector face_areas() const
  {
    Vector result(m_faces.size());
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      result[static_cast<Eigen::Index>(f)] = m_triangles[f].area;
    return result;
  }

  /*!
   * Returns the weak (integrated) Laplacian \f$L\f$, a symmetric, positive semi-definite \f$n \times n\f$ matrix. For a
   * piecewise linear function \f$u\f$, \f$u^T L u\f$ is the Dirichlet energy \f$\int |\nabla u|^2\f$. If a single edge
   * connects the vertices \f$i\f$ and \f$j\f$, the entry \f$L_{ij}\f$ is \f$-(\cot\alpha + \cot\beta)/2\f$, where
   * \f$\alpha\f$ and \f$\beta\f$ are the angles opposite to this edge. For a border edge, there is only one such angle
   * and one term.
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
   * Returns the pointwise Laplacian, the \f$n \times n\f$ matrix \f$\Delta = -M^{-1} L\f$. Here, \f$M\f$ is the lumped
   * mass matrix and \f$L\f$ is the weak Laplacian. Rows of isolated vertices are zero.
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

  /// Returns, for each of the \f$n\f$ vertices, a third of the total area of the incident faces. These numbers are the
  /// diagonal of `lumped_mass()`.
  Vector vertex_areas() const
  {
    Vector result = Vector::Zero(static_cast<Eigen::Index>(m_number_of_vertices));
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      for(Vertex_index v : m_faces[f].vertices)
        result[v.idx()] += m_triangles[f].area / 3;
    return result;
  }

  /// Returns the lumped mass matrix, a diagonal \f$n \times n\f$ matrix.
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

  /// Returns the consistent mass matrix, the \f$n \times n\f$ matrix \f$M\f$ with \f$u^T M w = \int u\,w\f$ for all
  /// piecewise linear functions \f$u\f$ and \f$w\f$.
  Matrix consistent_mass() const
  {
    return m_pattern.vertex_matrix(
        m_faces, [this](std::size_t f, int i, int j) { return m_triangles[f].area / (i == j ? 6 : 12); });
  }

  /// Returns the \f$2m \times n\f$ matrix of the gradient of piecewise linear functions.
  Matrix gradient() const
  {
    return m_pattern.face_matrix([this](std::size_t f, int i) { return m_triangles[f].hat_gradient(i); });
  }

  /*!
   * Returns the \f$n \times 2m\f$ matrix of the weak (integrated) divergence of vector fields that are constant on each
   * face. The matrix maps a field \f$X\f$ to the numbers \f$-\int \nabla\varphi_i \cdot X\f$, where \f$\varphi_i\f$ is
   * the hat function of vertex \f$i\f$. The weak Laplacian equals `-divergence() * gradient()`.
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
      internal::throw_naming<Degenerate_face_error>(
          "the intrinsic face with vertices ", m_faces[f].vertices[0], ", ", m_faces[f].vertices[1], ", ",
          m_faces[f].vertices[2], " is degenerate; flip the triangulation to Delaunay first, or mollify the metric");
  }

  std::size_t m_number_of_vertices;
  std::vector<Intrinsic_face> m_faces;
  std::vector<internal::Plane_triangle> m_triangles;
  internal::Matrix_pattern<ConcurrencyTag> m_pattern;
};

/*!
 * \ingroup PkgFlipGeodesicsOperators
 *
 * Defines the directions at the vertices of an intrinsic triangulation: each halfedge has an angle, in radians,
 * measured counterclockwise from the reference direction at its tail.
 *
 * At a vertex in the interior of the surface, the angles of the corners are scaled to a sum of \f$2\pi\f$
 * \cgalCite{KCPS13}, and the reference direction is that of the outgoing halfedge with the smallest index. At a vertex
 * on the border, the angles are not scaled, and the reference direction is that of the outgoing halfedge whose edge
 * lies on the border and which has a face on its left.
 *
 * The object is a snapshot: later flips of the triangulation do not affect it. Construction takes time linear in the
 * size of the triangulation.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulation`
 */
template <class Triangulation>
class Tangent_spaces
{
public:
  /// Computes the angles of all halfedges and of all corners of faces.
  /// \param triangulation the triangulation
  /// \param faces all faces of the triangulation, as written by `intrinsic_faces()`
  /// \throws Invalid_mesh_error if a vertex is non-manifold, that is, if several umbrellas meet there
  Tangent_spaces(const Triangulation& triangulation, const std::vector<Intrinsic_face>& faces)
    : m_angles(static_cast<std::size_t>(triangulation.number_of_halfedges()), 0)
    , m_corners(m_angles.size(), 0)
    , m_references(static_cast<std::size_t>(triangulation.number_of_vertices()), null_index)
  {
    for(const Intrinsic_face& face : faces) {
      const internal::Plane_triangle triangle(face.lengths);
      for(int i = 0; i < 3; ++i)
        m_corners[face.halfedges[i]] = triangle.angle(i);
    }
    Marks is_laid_out(static_cast<std::size_t>(triangulation.number_of_halfedges()), 0);
    for(Vertex_index v : internal::descriptors<Vertex_index>(triangulation.number_of_vertices()))
      lay_out(triangulation, v, is_laid_out);
    check_umbrellas(triangulation, is_laid_out);
  }

  /// Returns the halfedge in the reference direction of vertex `v`, or `null_index` if `v` is isolated.
  Halfedge_index reference(Vertex_index v) const { return m_references[v]; }

  /// Returns the angle of halfedge `h` at its tail.
  double angle(Halfedge_index h) const { return m_angles[h]; }

  /// Returns the angle of the corner at the tail of `h` in the face on the left of `h`. The angle is scaled like the
  /// angles of the halfedges.
  double corner(Halfedge_index h) const { return m_corners[h]; }

  /// Returns the angle by which parallel transport along `h` changes the angle of a direction. The angle of the
  /// direction at the head of `h` is its angle at the tail plus this value.
  double transport(Halfedge_index h) const
  {
    return m_angles[Triangulation::twin(h)] + boost::math::constants::pi<double>() - m_angles[h];
  }

private:
  using Marks = internal::Indexed_by<Halfedge_index, std::vector<char>>;

  void lay_out(const Triangulation& triangulation, Vertex_index v, Marks& is_laid_out)
  {
    const Halfedge_index some = triangulation.outgoing(v);
    if(some == null_index)
      return;
    Halfedge_index last = some, least = some; // clockwise from `some`, which can be any halfedge of the vertex
    for(Halfedge_index h = triangulation.clockwise(some); h != some && h != null_index; h = triangulation.clockwise(h))
    {
      last = h;
      least = (std::min)(least, h);
    }
    const bool is_border = triangulation.clockwise(last) == null_index;
    const Halfedge_index first = is_border ? last : least;
    m_references[v] = first;

    double sum = 0;
    Halfedge_index h = first;
    do {
      m_angles[h] = sum;
      is_laid_out[h] = 1;
      sum += triangulation.is_border(h) ? 0 : m_corners[h];
      h = triangulation.counterclockwise(h);
    } while(h != first && h != null_index);
    if(is_border)
      return;
    const double scale = boost::math::constants::two_pi<double>() / sum;
    do {
      m_angles[h] *= scale;
      m_corners[h] *= scale;
      h = triangulation.counterclockwise(h);
    } while(h != first);
  }

  // Only one umbrella of each vertex has been laid out.
  static void check_umbrellas(const Triangulation& triangulation, const Marks& is_laid_out)
  {
    for(Halfedge_index h : internal::descriptors<Halfedge_index>(triangulation.number_of_halfedges()))
      if(is_laid_out[h] == 0) {
        const Vertex_index v = triangulation.tail(h);
        internal::throw_naming<Invalid_mesh_error>(
            "several umbrellas of faces meet at vertex ", v,
            ", which has no tangent space; duplicate the vertex for each umbrella");
      }
  }

  internal::Indexed_by<Halfedge_index, std::vector<double>> m_angles, m_corners;
  internal::Indexed_by<Vertex_index, std::vector<Halfedge_index>> m_references;
};

/*!
 * \ingroup PkgFlipGeodesicsOperators
 *
 * Solves the Poisson problem \f$-\Delta u = \rho\f$, where \f$u\f$ is given at some vertices, for instance along
 * geodesics \cgalCite{SC20,section 6.4 and Figure 26}. At border points at which \f$u\f$ is not given, the derivative
 * of \f$u\f$ across the border is zero.
 *
 * The problem is discretized by linear finite elements with the cotangent Laplacian. The constructor factorizes the
 * matrix (sparse Cholesky), and `solve()` can then be called any number of times.
 *
 * \tparam Operators_ an instance of `Operators`
 */
template <class Operators_>
class Dirichlet_problem
{
public:
  using Vector = Eigen::VectorXd; ///< a number per vertex

  /*!
   * Factorizes the matrix of the problem.
   *
   * \param operators the operators of the triangulation, which are used only during construction
   * \param given the vertices at which values are given, in any order and possibly repeated
   * \throws Vertex_out_of_range_error if an index does not belong to a vertex
   * \throws Singular_problem_error if a component with faces has no vertex in `given`, or if the matrix cannot be
   *         factorized. In the first case, `elements()` returns a vertex of the component
   */
  Dirichlet_problem(const Operators_& operators, const std::vector<Vertex_index>& given)
    : m_is_given(internal::marked_vertices(operators.number_of_vertices(), given))
    , m_is_isolated(internal::isolated_vertices(operators.number_of_vertices(), operators.faces()))
    , m_mass(operators.consistent_mass())
    , m_system(operators.weak_laplacian(), m_is_given, m_is_isolated)
  {
    internal::check_every_component(internal::components(m_is_given.size(), operators.faces()), m_is_given,
                                    m_is_isolated);
    if(m_system.inner().rows() > 0)
      m_factors.compute(m_system.inner());
    if(m_system.inner().rows() > 0 && m_factors.info() != Eigen::Success)
      throw Singular_problem_error(
          "the Laplacian cannot be factorized: faces of the triangulation are too thin for double "
          "precision; flip it to Delaunay or refine it first");
  }

  /*!
   * Solves the problem for a density and given values.
   *
   * \param density the density \f$\rho\f$, with one value per vertex, or an empty vector for zero density
   * \param values one number per vertex, of which only those at the given vertices are read
   * \return the solution, with one value per vertex; the value is NaN at isolated vertices that are not given
   * \throws Invalid_coordinate_error if a density or a given value is not finite
   */
  Vector solve(const Vector& density, const Vector& values) const
  {
    const Eigen::Index n = static_cast<Eigen::Index>(m_is_given.size());
    CGAL_precondition((density.size() == 0 || density.size() == n) && values.size() == n);
    Vector result = Vector::Constant(n, std::numeric_limits<double>::quiet_NaN());
    Vector fixed = Vector::Zero(n);
    for(Eigen::Index v = 0; v < n; ++v) {
      if(m_is_given[v] != 0)
        result[v] = fixed[v] = values[v];
      if(!std::isfinite(fixed[v]) || (density.size() != 0 && !std::isfinite(density[v])))
        throw Invalid_coordinate_error("the given value or the density at vertex " + std::to_string(v) +
                                           " is not finite",
                                       {static_cast<std::size_t>(v)});
    }
    if(m_system.inner().rows() == 0)
      return result;
    const Vector load = density.size() == 0 ? Vector(Vector::Zero(n)) : Vector(m_mass * density);
    m_system.insert(m_factors.solve(m_system.right_hand_side(load, fixed)), result);
    return result;
  }

private:
  std::vector<char> m_is_given, m_is_isolated;
  typename Operators_::Matrix m_mass;
  internal::Constrained_system<double> m_system;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factors;
};

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_OPERATORS_H
