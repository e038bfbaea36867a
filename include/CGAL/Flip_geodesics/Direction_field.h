// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_DIRECTION_FIELD_H
#define CGAL_FLIP_GEODESICS_DIRECTION_FIELD_H

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Operators.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/operators/Constrained_system.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsOperators
 *
 * Computes the smoothest direction field on an intrinsic triangulation \cgalCite{KCPS13}: a cross field for symmetry 4,
 * a line field for 2, and a vector field for 1.
 *
 * The field is stored as one complex number \f$u_i\f$ per vertex, the `symmetry`-th power of a direction in the tangent
 * space of the vertex (`Tangent_spaces`). The field minimizes the energy \f$\sum_{ij} w_{ij} |u_j - r_{ij} u_i|^2\f$,
 * where \f$w_{ij}\f$ is the cotangent weight of the edge from vertex \f$i\f$ to vertex \f$j\f$, and the complex number
 * \f$r_{ij}\f$ represents the parallel transport of `symmetry`-th powers along this edge. If directions are prescribed,
 * for instance along curves, the minimum is taken over all fields with these directions
 * \cgalCite{SC20,section 6.4 and Figure 26}. If no directions are prescribed, the minimum is taken over all fields
 * whose squared magnitude has the mean 1 in each connected component.
 *
 * Interior edges that are not Delaunay have negative weights, with which the energy can become negative. Flip the
 * triangulation to Delaunay first.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulation`
 */
template <class Triangulation>
class Direction_field
{
  using Complex = std::complex<double>;
  using Matrix = Eigen::SparseMatrix<Complex>;
  using Solver = Eigen::SimplicialLDLT<Matrix>;

public:
  using Vector = Eigen::VectorXcd; ///< a complex number per vertex

  /// Describes a singularity: a face around which the field makes `index / symmetry` full turns.
  struct Singularity
  {
    std::size_t face; ///< the number of the face in `operators().faces()`
    int index;        ///< the index, which is not 0 and can be negative
  };

  /*!
   * Prepares the computation.
   *
   * \param triangulation a triangulation, which must outlive the field and must not be changed
   * \param symmetry the number of directions at a point
   * \pre `symmetry >= 1`
   * \throws Degenerate_face_error as `Operators` does
   * \throws Invalid_mesh_error as `Operators` and `Tangent_spaces` do
   * \throws Invalid_coordinate_error as `Operators` does
   */
  explicit Direction_field(const Triangulation& triangulation, int symmetry = 4)
    : m_triangulation(triangulation)
    , m_symmetry(symmetry)
    , m_operators(triangulation)
    , m_spaces(triangulation, m_operators.faces())
    , m_aligned(Vector::Zero(static_cast<Eigen::Index>(m_operators.number_of_vertices())))
    , m_values(m_aligned)
  {
    CGAL_precondition(symmetry >= 1);
  }

  /// Returns the operators of the discretization. Faces are numbered as in `Operators::faces()`.
  const Operators<Triangulation>& operators() const { return m_operators; }
  /// Returns the tangent spaces, in which the angles of directions are measured.
  const Tangent_spaces<Triangulation>& tangent_spaces() const { return m_spaces; }

  /// \name Alignment
  /// If several directions are prescribed at one vertex, their `symmetry`-th powers are averaged. If the powers cancel
  /// each other out, no direction is prescribed at this vertex.
  /// @{

  /// Prescribes a direction at vertex `v`, as an angle in its tangent space, in radians.
  /// \throws Vertex_out_of_range_error if `v` is not a vertex of the triangulation
  void align(Vertex_index v, double angle)
  {
    internal::check_vertex(v, static_cast<Index>(m_operators.number_of_vertices()));
    m_aligned[v.idx()] += power(angle);
  }

  /// Prescribes the directions of all curves of a network at their ends and at every vertex through which they pass.
  template <class Network>
  void align(const Network& network)
  {
    constexpr double pi = boost::math::constants::pi<double>();
    for(Curve_index c : internal::descriptors<Curve_index>(network.number_of_curves()))
      network.for_each_segment(c, [&](Segment_index s) {
        const Halfedge_index h = network.halfedge(s), t = Triangulation::twin(h);
        align(m_triangulation.tail(h), m_spaces.angle(h));
        align(m_triangulation.tail(t), m_spaces.angle(t) + pi);
      });
  }

  /// @}

  /*!
   * Computes the field by one sparse Cholesky factorization. If no directions are prescribed, the factorization is
   * followed by inverse iteration, until the relative change of the energy is at most 1e-12. This usually takes tens to
   * hundreds of solves; at most 1000 are performed.
   * \throws Singular_problem_error if directions are prescribed, but not in every component that has faces, or if the
   *         matrix cannot be factorized
   */
  void compute()
  {
    const std::size_t n = m_operators.number_of_vertices();
    std::vector<char> is_given(n, 0);
    bool is_aligned = false;
    for(std::size_t v = 0; v < n; ++v)
      if(std::abs(m_aligned[v]) > internal::canceled_directions) { // opposite directions cancel out up to rounding
                                                                   // errors
        is_given[v] = 1;
        is_aligned = true;
      }
    const std::vector<char> is_isolated = internal::isolated_vertices(n, m_operators.faces());
    m_values.setZero();
    if(is_aligned)
      solve_aligned(is_given, is_isolated);
    else
      find_smoothest(is_given, is_isolated);
    m_is_computed = true;
  }

  /// Returns the `symmetry`-th powers of the field at the vertices. Their magnitudes vary; they are 0 at isolated
  /// vertices without prescribed directions.
  /// \throws Invalid_parameter_error if `compute()` has not been called; the functions below also throw this exception
  const Vector& values() const
  {
    if(!m_is_computed)
      throw Invalid_parameter_error("a direction field is queried before it has been computed; call compute() first");
    return m_values;
  }

  /// Returns one of the directions at vertex `v`, as an angle in its tangent space, in radians. The other directions
  /// follow in steps of \f$2\pi\f$ divided by the symmetry.
  double angle(Vertex_index v) const { return std::arg(values()[v.idx()]) / m_symmetry; }

  /*!
   * Returns the singularities of the field. On a closed surface, the sum of their indices is `symmetry` times the Euler
   * characteristic.
   *
   * Complexity: linear in the size of the mesh.
   */
  std::vector<Singularity> singularities() const
  {
    constexpr double pi = boost::math::constants::pi<double>();
    std::vector<Singularity> result;
    const std::vector<Intrinsic_face>& faces = m_operators.faces();
    for(std::size_t f = 0; f < faces.size(); ++f) {
      double turn = -pi * m_symmetry;
      for(Halfedge_index h : faces[f].halfedges)
        turn += rotation(h) + m_symmetry * m_spaces.corner(h);
      const int index = static_cast<int>(std::lround(turn / (2 * pi)));
      if(index != 0)
        result.push_back({f, index});
    }
    return result;
  }

  /// Returns the energy of the field, as defined in the description of the class.
  double energy() const { return std::real(values().dot(connection_laplacian() * m_values)); }

private:
  Complex power(double angle) const { return std::polar(1.0, m_symmetry * angle); }

  Complex carried(Halfedge_index h) const { return power(m_spaces.transport(h)); }

  // Returns the rotation of the field along h relative to parallel transport, between -pi and pi; it has the opposite
  // sign along the twin.
  double rotation(Halfedge_index h) const
  {
    const bool is_first = internal::is_first_side(h);
    const Halfedge_index g = is_first ? h : Triangulation::twin(h);
    const Complex at_tail = values()[m_triangulation.tail(g).idx()], at_head = values()[m_triangulation.head(g).idx()];
    const double angle = std::arg(at_head * std::conj(carried(g) * at_tail));
    return is_first ? angle : -angle;
  }

  Matrix connection_laplacian() const
  {
    std::vector<Eigen::Triplet<Complex>> entries;
    entries.reserve(12 * m_operators.faces().size());
    for(const Intrinsic_face& face : m_operators.faces()) {
      const internal::Plane_triangle triangle(face.lengths);
      for(int i = 0; i < 3; ++i) {
        const double weight = triangle.cotangents[(i + 2) % 3] / 2; // the corner opposite to side i
        const Index tail = face.vertices[i].idx(), head = face.vertices[(i + 1) % 3].idx();
        const Complex r = carried(face.halfedges[i]);
        entries.emplace_back(tail, tail, weight);
        entries.emplace_back(head, head, weight);
        entries.emplace_back(head, tail, -weight * r);
        entries.emplace_back(tail, head, -weight * std::conj(r));
      }
    }
    Matrix result(m_values.size(), m_values.size());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  static void factor(Solver& solver, const Matrix& matrix)
  {
    solver.compute(matrix);
    if(solver.info() != Eigen::Success)
      throw Singular_problem_error(
          "the matrix of the direction field cannot be factorized in double precision; flip the "
          "triangulation to Delaunay or refine it first");
  }

  void solve_aligned(const std::vector<char>& is_given, const std::vector<char>& is_isolated)
  {
    const std::vector<Index> component = internal::components(is_given.size(), m_operators.faces());
    internal::check_every_component(component, is_given, is_isolated);
    for(std::size_t v = 0; v < is_given.size(); ++v)
      if(is_given[v] != 0)
        m_values[v] = m_aligned[v] / std::abs(m_aligned[v]);
    const internal::Constrained_system<Complex> system(connection_laplacian(), is_given, is_isolated);
    if(system.inner().rows() == 0)
      return;
    Solver solver;
    factor(solver, system.inner());
    const Vector load = Vector::Zero(m_values.size());
    system.insert(solver.solve(system.right_hand_side(load, m_values)), m_values);
  }

  // Inverse iteration; the components of the surface are independent, so each is normalized separately.
  void find_smoothest(const std::vector<char>& none, const std::vector<char>& is_isolated)
  {
    constexpr int most_iterations = 1000;
    const internal::Constrained_system<Complex> system(connection_laplacian(), none, is_isolated);
    if(system.inner().rows() == 0)
      return;
    const std::vector<Index> component = internal::components(none.size(), m_operators.faces());
    const Vector mass = system.restricted(m_operators.vertex_areas().template cast<Complex>());
    // Eigenvalues are of the order of 1/area: this shift makes the matrix definite and changes nothing else.
    const double shift = internal::eigenvalue_shift / mass.real().sum();
    Matrix shifted = system.inner();
    for(Eigen::Index i = 0; i < mass.size(); ++i)
      shifted.coeffRef(i, i) += shift * mass[i];
    Solver solver;
    factor(solver, shifted);

    Vector u(mass.size());
    for(Eigen::Index i = 0; i < u.size(); ++i) // arbitrary, and the same everywhere
      u[i] = std::polar(1.0, 2.399963229728653 * static_cast<double>(i));
    double energy = 0;
    for(int iteration = 0; iteration < most_iterations; ++iteration) {
      u = solver.solve(mass.cwiseProduct(u)).eval();
      normalize(u, mass, system.free_vertices(), component);
      const double next = std::real(u.dot(system.inner() * u));
      const bool has_converged =
          iteration > 0 && std::abs(next - energy) <= internal::converged_energy * std::abs(energy);
      energy = next;
      if(has_converged)
        break;
    }
    system.insert(u, m_values);
  }

  static void normalize(Vector& u, const Vector& mass, const std::vector<Index>& vertices,
                        const std::vector<Index>& component)
  {
    std::vector<double> sum(component.size(), 0), area(component.size(), 0);
    for(Eigen::Index i = 0; i < u.size(); ++i) {
      sum[component[vertices[i]]] += std::norm(u[i]) * mass[i].real();
      area[component[vertices[i]]] += mass[i].real();
    }
    for(Eigen::Index i = 0; i < u.size(); ++i)
      u[i] *= std::sqrt(area[component[vertices[i]]] / sum[component[vertices[i]]]);
  }

  const Triangulation& m_triangulation;
  int m_symmetry;
  Operators<Triangulation> m_operators;
  Tangent_spaces<Triangulation> m_spaces;
  Vector m_aligned; // the sum of the prescribed directions
  Vector m_values;
  bool m_is_computed = false;
};

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_DIRECTION_FIELD_H
