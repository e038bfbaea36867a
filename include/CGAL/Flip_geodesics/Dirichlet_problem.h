// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_DIRICHLET_PROBLEM_H
#define CGAL_FLIP_GEODESICS_DIRICHLET_PROBLEM_H

#include <CGAL/Flip_geodesics/Operators.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/operators/Constrained_system.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsOperators
 *
 * The Poisson problem \f$-\Delta u = \rho\f$ with \f$u\f$ given at some vertices, for instance along geodesics
 * [SC20, section 6.4, Figure 26]; no flow across the rest of the border. Linear finite elements with the cotangent
 * Laplacian. The matrix is factored once (sparse Cholesky), for as many right-hand sides as wanted.
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
   * \param operators of the triangulation; needed only here
   * \param given the vertices where values are given, in any order, each once or more
   * \throws Vertex_out_of_range_error
   * \throws Singular_problem_error if a component with faces has no vertex in `given`; `elements()` is a vertex of it
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
      throw Singular_problem_error("the Laplacian cannot be factored: the triangulation has faces too thin for double; "
                                   "flip it to Delaunay or refine it first");
  }

  /*!
   * Solves the problem for a density and values.
   *
   * \param density \f$\rho\f$, a value per vertex, or empty for 0
   * \param values a number per vertex, read at the given ones
   * \return the solution, a value per vertex; NaN at isolated vertices that are not given
   * \throws Invalid_coordinate_error if a number that is read is not finite
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
        throw Invalid_coordinate_error("the value at vertex " + std::to_string(v) + " is not finite",
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_DIRICHLET_PROBLEM_H
