// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CONFORMAL_FLATTENING_H
#define CGAL_FLIP_GEODESICS_CONFORMAL_FLATTENING_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/refine.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/math/constants/constants.hpp>
#include <boost/property_map/property_map.hpp>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

namespace internal {

/*
 * The surface of an intrinsic triangulation cut open along some edges; the triangulation is not modified. The corners
 * around a vertex form sectors between cut edges and the border, and each sector is a vertex of the cut surface, a
 * *copy*.
 *
 * `is_cut(h)` returns whether the edge of halfedge h is cut.
 */
template <class Triangulation>
class Cut_surface
{
public:
  template <class Predicate>
  Cut_surface(const Triangulation& triangulation, const std::vector<Intrinsic_face>& faces, const Predicate& is_cut)
    : m_copy_at(static_cast<std::size_t>(triangulation.number_of_halfedges()), null_index)
  {
    for(const Intrinsic_face& face : faces)
      for(Halfedge_index h : face.halfedges)
        if(m_copy_at[h] == null_index)
          add_sector(triangulation, h, is_cut);
    count(triangulation, faces, is_cut);
  }

  Index number_of_copies() const { return static_cast<Index>(m_vertices.size()); }
  Vertex_copy_index copy_at(Halfedge_index h) const { return m_copy_at[h]; }
  Vertex_index vertex(Vertex_copy_index copy) const { return m_vertices[copy]; }
  bool is_on_border(Vertex_copy_index copy) const { return m_is_on_border[copy] != 0; }
  /* Among connected surfaces, only a disk has the Euler characteristic 1. */
  std::ptrdiff_t euler_characteristic() const { return m_euler_characteristic; }

private:
  template <class Predicate>
  void add_sector(const Triangulation& triangulation, Halfedge_index start, const Predicate& is_cut)
  {
    // Clockwise as far as possible, then back.
    Halfedge_index first = start;
    bool is_closed = false;
    while(!is_closed && !is_cut(first)) {
      const Halfedge_index h = triangulation.clockwise(first);
      if(h == null_index)
        break;
      first = h;
      is_closed = first == start;
    }
    const Vertex_copy_index copy(number_of_copies());
    m_vertices.push_back(triangulation.tail(start));
    m_is_on_border.push_back(is_closed ? 0 : 1);
    Halfedge_index h = first;
    do {
      m_copy_at[h] = copy;
      h = triangulation.counterclockwise(h);
    } while(h != first && !triangulation.is_border(h) && !is_cut(h));
  }

  template <class Predicate>
  void count(const Triangulation& triangulation, const std::vector<Intrinsic_face>& faces, const Predicate& is_cut)
  {
    std::ptrdiff_t edges = 0; // a cut or border edge counts once per side
    for(const Intrinsic_face& face : faces)
      for(Halfedge_index h : face.halfedges) {
        const bool is_shared = !triangulation.is_border(Triangulation::twin(h)) && !is_cut(h);
        edges += is_shared && !is_first_side(h) ? 0 : 1;
      }
    m_euler_characteristic =
        static_cast<std::ptrdiff_t>(m_vertices.size()) - edges + static_cast<std::ptrdiff_t>(faces.size());
  }

  Indexed_by<Halfedge_index, std::vector<Vertex_copy_index>> m_copy_at;
  Indexed_by<Vertex_copy_index, std::vector<Vertex_index>> m_vertices;
  Indexed_by<Vertex_copy_index, std::vector<char>> m_is_on_border;
  std::ptrdiff_t m_euler_characteristic = 0;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsOperators
 *
 * Computes the discretely conformal flattening \cgalCite{SSP08} of a surface that is cut open along the curves of a
 * network \cgalCite{SC20,section 6.1 and Figure 22}.
 *
 * Each vertex \f$i\f$ of the cut surface is assigned a scale factor \f$e^{u_i}\f$. The length \f$l_{ij}\f$ of the edge
 * between vertices \f$i\f$ and \f$j\f$ is replaced by \f$e^{(u_i+u_j)/2}\,l_{ij}\f$. The factors are chosen so that the
 * faces with these scaled lengths fit together in the plane.
 *
 * At the border of the cut surface, \f$u_i = 0\f$. Border edges therefore keep their lengths, and the two sides of a
 * cut have the same length. The sum of the angles at a border vertex, such as a cone point at which a cut ends, is not
 * prescribed.
 *
 * The values \f$u_i\f$ minimize a convex function, whose Hessian matrix is the cotangent Laplacian of the scaled faces.
 * The minimum is found by Newton's method; usually, a few sparse factorizations suffice. Faces that violate the
 * triangle inequality during the iteration are treated as degenerate \cgalCite{SSP08}. If such a face remains at the
 * minimum, the problem has no solution for this triangulation, and the constructor throws an exception.
 * `refine_and_flatten()` instead splits edges of such faces to obtain a triangulation for which a solution exists.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulation`
 */
template <class Triangulation>
class Conformal_flattening
{
public:
  using Point = std::array<double, 2>; ///< the position in the plane, in the unit of the lengths

  /// Cuts and flattens the surface with a tolerance of 1e-10 radians for angle sums. The exceptions are those of the
  /// constructor with a tolerance.
  template <class Network>
  explicit Conformal_flattening(const Network& network)
    : Conformal_flattening(network, internal::default_angle_sum_tolerance)
  {
  }

  /*!
   * Cuts and flattens the surface.
   * \param network a model of `CurveNetwork` in a triangulation of a connected surface. The surface is cut along the
   *        current curves of the network. The triangulation must outlive the flattening
   * \param tolerance the largest accepted deviation of the angle sum at an interior vertex from \f$2\pi\f$, in radians
   * \throws Flattening_error if the cut surface is not a disk, if a face remains degenerate, or if the tolerance is
   *         exceeded
   * \throws Degenerate_face_error if a face of the triangulation is degenerate in double precision, or as `Operators`
   *         does
   * \throws Invalid_mesh_error as `Operators` does
   * \throws Invalid_coordinate_error as `Operators` does
   */
  template <class Network>
  Conformal_flattening(const Network& network, double tolerance)
    : Conformal_flattening(network, Unscaled())
  {
    check_faces();
    minimize(tolerance);
    if(const std::vector<Halfedge_index> sides = overlong_sides(m_log_scales); !sides.empty())
      throw Flattening_error("scaling by the conformal factors violates the triangle inequality in " +
                                 std::to_string(sides.size()) + " of the faces; use refine_and_flatten()",
                             {static_cast<std::size_t>(m_triangulation->tail(sides.front()).idx())});
    check_angles(tolerance);
    lay_out(network);
  }

  /// Returns the number of vertices of the cut surface, which are copies of the vertices of the triangulation. A vertex
  /// of the triangulation through which the cut passes has several copies.
  Index number_of_copies() const { return m_surface.number_of_copies(); }
  /// Returns the vertex of the triangulation to which a copy belongs.
  Vertex_index vertex(Vertex_copy_index copy) const { return m_surface.vertex(copy); }
  /// Returns the copy to which a corner belongs: the corner at the tail of halfedge `h` in the face on the left of `h`.
  /// \pre `h` is not on the border
  Vertex_copy_index copy_at(Halfedge_index h) const
  {
    CGAL_precondition_msg(!m_triangulation->is_border(h), "a border halfedge has no face on its left");
    return m_surface.copy_at(h);
  }
  /// Returns the position of a copy in the plane.
  const Point& point(Vertex_copy_index copy) const { return m_points[copy]; }
  /// Returns the logarithm \f$u_i\f$ of the scale factor of a copy.
  double log_scale(Vertex_copy_index copy) const { return m_log_scales[copy]; }

  /*!
   * Transfers the flattening to a common subdivision, by linear interpolation within the intrinsic faces. The result
   * can be used as texture coordinates of the subdivided mesh.
   * \param subdivision the result of `common_subdivision()` for the triangulation in the state in which it was
   *        flattened
   * \param out a model of `WritablePropertyMap` with the halfedges of the subdivided mesh as keys, and values that can
   *        be constructed from two `double`s. For each halfedge of a face, the map receives the position that the
   *        target of the halfedge has as a corner of this face
   * \pre no edge of the triangulation connects a vertex to itself; this holds after `refine_and_flatten()`
   */
  template <class Subdivision, class HalfedgeMap>
  void carry_to(const Subdivision& subdivision, HalfedgeMap out) const
  {
    using Value = typename boost::property_traits<HalfedgeMap>::value_type;
    for(const auto f : faces(subdivision.mesh()))
      for(const auto h : CGAL::halfedges_around_face(halfedge(f, subdivision.mesh()), subdivision.mesh())) {
        const Point p =
            point_in_face(subdivision.intrinsic_face(f), subdivision.vertex_origin(target(h, subdivision.mesh())));
        put(out, h, Value(p[0], p[1]));
      }
  }

  /// Returns the largest deviation of the angle sum at an interior vertex from \f$2\pi\f$, in radians.
  double angle_error() const { return m_angle_error; }
  /// Returns the layout error. When the faces are laid out, the position of a copy can be computed in several faces, of
  /// which the first determines its `point()`. The error is the largest distance between the `point()` of a copy and
  /// another position computed for this copy, divided by the largest distance of a copy from the origin.
  double layout_error() const { return m_layout_error; }
  /// Returns the number of Newton steps.
  int iterations() const { return m_iterations; }

private:
  friend struct internal::Internals<Conformal_flattening>;

  using Vector = Eigen::VectorXd;
  using Values = internal::Indexed_by<Vertex_copy_index, std::vector<double>>;
  using Matrix = Eigen::SparseMatrix<double>;

  struct Unscaled
  {
  };

  template <class Network>
  Conformal_flattening(const Network& network, Unscaled)
    : m_triangulation(&network.triangulation())
    , m_faces(all_faces(network.triangulation()))
    , m_surface(network.triangulation(), m_faces, [&network](Halfedge_index h) { return network.is_occupied(h); })
    , m_log_scales(static_cast<std::size_t>(m_surface.number_of_copies()), 0.0)
  {
    check_disk(network);
    number_free_copies();
  }

  static std::vector<Intrinsic_face> all_faces(const Triangulation& triangulation)
  {
    std::vector<Intrinsic_face> result;
    intrinsic_faces(triangulation, std::back_inserter(result));
    return result;
  }

  template <class Network>
  void check_disk(const Network& network) const
  {
    if(m_faces.empty())
      throw Flattening_error("the surface has no faces");
    std::vector<char> is_reached(m_faces.size(), 0);
    const std::size_t reached = spread(network, 0, is_reached, [](std::size_t, int, std::size_t) {});
    if(reached != m_faces.size())
      throw Flattening_error("the cut surface is not connected: only " + std::to_string(reached) + " of " +
                             std::to_string(m_faces.size()) +
                             " faces are connected to the first face; flatten each component separately");
    if(m_surface.euler_characteristic() != 1)
      throw Flattening_error("the cut surface is not a disk, since its Euler characteristic is " +
                             std::to_string(m_surface.euler_characteristic()) +
                             " instead of 1; cut the surface along a cut graph");
  }

  void check_faces() const
  {
    for(const Intrinsic_face& face : m_faces)
      if(!internal::Plane_triangle(face.lengths).has_finite_cotangents())
        internal::throw_naming<Degenerate_face_error>(
            "an intrinsic face at vertex ", face.vertices[0], ", with sides of length ", face.lengths[0], ", ",
            face.lengths[1], " and ", face.lengths[2], ", is degenerate in double precision; remesh the surface there");
  }

  // Traverses faces breadth first, not across cuts, and calls visit(face, side, next face). Returns the number of faces
  // reached.
  template <class Network, class Visit>
  std::size_t spread(const Network& network, std::size_t start, std::vector<char>& is_reached, const Visit& visit) const
  {
    const Triangulation& triangulation = network.triangulation();
    internal::Indexed_by<Halfedge_index, std::vector<std::size_t>> face_of(
        static_cast<std::size_t>(triangulation.number_of_halfedges()), m_faces.size());
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      for(Halfedge_index h : m_faces[f].halfedges)
        face_of[h] = f;
    std::queue<std::size_t> queue;
    queue.push(start);
    is_reached[start] = 1;
    std::size_t count = 0;
    for(; !queue.empty(); queue.pop(), ++count) {
      const std::size_t f = queue.front();
      for(int i = 0; i < 3; ++i) {
        const Halfedge_index h = m_faces[f].halfedges[i];
        const std::size_t next = face_of[Triangulation::twin(h)];
        if(next == m_faces.size() || network.is_occupied(h) || is_reached[next] != 0)
          continue;
        is_reached[next] = 1;
        visit(f, i, next);
        queue.push(next);
      }
    }
    return count;
  }

  void number_free_copies()
  {
    m_free.assign(m_log_scales.size(), null_index);
    for(Vertex_copy_index copy : internal::descriptors<Vertex_copy_index>(number_of_copies()))
      if(!m_surface.is_on_border(copy))
        m_free[copy] = m_number_of_free++;
  }

  Vertex_copy_index copy(const Intrinsic_face& face, int corner) const
  {
    return m_surface.copy_at(face.halfedges[corner]);
  }

  internal::Plane_triangle scaled(const Intrinsic_face& face, const Values& u) const
  {
    std::array<double, 3> lengths;
    // A common factor does not change angles, and prevents large scales from overflowing.
    const double largest = (std::max)({u[copy(face, 0)], u[copy(face, 1)], u[copy(face, 2)]});
    for(int i = 0; i < 3; ++i)
      lengths[i] = face.lengths[i] * std::exp((u[copy(face, i)] - largest + u[copy(face, (i + 1) % 3)] - largest) / 2);
    return internal::Plane_triangle(lengths);
  }

  // Returns 2 pi minus the angles around each free copy: the gradient of the convex function.
  Vector defects(const Values& u) const
  {
    Vector result = Vector::Constant(m_number_of_free, boost::math::constants::two_pi<double>());
    for(const Intrinsic_face& face : m_faces) {
      const internal::Plane_triangle triangle = scaled(face, u);
      for(int i = 0; i < 3; ++i)
        if(m_free[copy(face, i)] != null_index)
          result[m_free[copy(face, i)]] -= triangle.angle(i);
    }
    return result;
  }

  Matrix hessian(const Values& u) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12 * m_faces.size());
    for(const Intrinsic_face& face : m_faces) {
      const internal::Plane_triangle triangle = scaled(face, u);
      if(!triangle.has_finite_cotangents())
        continue; // its angles do not change
      for(int i = 0; i < 3; ++i) {
        const double weight = triangle.cotangents[(i + 2) % 3] / 2;
        const Index a = m_free[copy(face, i)], b = m_free[copy(face, (i + 1) % 3)];
        if(a != null_index)
          entries.emplace_back(a, a, weight);
        if(b != null_index)
          entries.emplace_back(b, b, weight);
        if(a != null_index && b != null_index) {
          entries.emplace_back(a, b, -weight);
          entries.emplace_back(b, a, -weight);
        }
      }
    }
    Matrix result(m_number_of_free, m_number_of_free);
    result.setFromTriplets(entries.begin(), entries.end());
    for(Index i = 0; i < m_number_of_free; ++i) // keeps rows of degenerate faces only regular
      result.coeffRef(i, i) += internal::hessian_regularization;
    return result;
  }

  Values first_estimate() const
  {
    Vector step;
    const bool is_found = m_number_of_free > 0 && newton_step(m_log_scales, defects(m_log_scales), step);
    return is_found ? moved(step, 1) : m_log_scales;
  }

  bool newton_step(const Values& u, const Vector& gradient, Vector& step) const
  {
    Eigen::SimplicialLDLT<Matrix> solver(hessian(u));
    if(solver.info() != Eigen::Success)
      return false;
    step = solver.solve(-gradient);
    return step.allFinite();
  }

  Values moved(const Vector& step, double t) const
  {
    Values u = m_log_scales;
    for(Vertex_copy_index copy : internal::descriptors<Vertex_copy_index>(number_of_copies()))
      if(m_free[copy] != null_index)
        u[copy] += t * step[m_free[copy]];
    return u;
  }

  void minimize(double tolerance)
  {
    constexpr int most_iterations = 200;
    if(m_number_of_free == 0)
      return;
    Vector gradient = defects(m_log_scales), step;
    while(m_iterations < most_iterations && gradient.lpNorm<Eigen::Infinity>() > tolerance &&
          newton_step(m_log_scales, gradient, step) && move_along(step, gradient))
      ++m_iterations;
    m_angle_error = gradient.lpNorm<Eigen::Infinity>();
  }

  // Returns the longest side of each face in which the scaled lengths violate the triangle inequality.
  std::vector<Halfedge_index> overlong_sides(const Values& u) const
  {
    std::vector<Halfedge_index> result;
    for(const Intrinsic_face& face : m_faces)
      if(const internal::Plane_triangle triangle = scaled(face, u); !(triangle.area > 0)) {
        const auto longest = std::max_element(triangle.lengths.begin(), triangle.lengths.end());
        result.push_back(face.halfedges[static_cast<std::size_t>(longest - triangle.lengths.begin())]);
      }
    return result;
  }

  void check_angles(double tolerance) const
  {
    if(!(m_angle_error <= tolerance))
      throw Flattening_error("the angle sums still differ from 2 pi by up to " + internal::written(m_angle_error) +
                             ", which exceeds the tolerance " + internal::written(tolerance) + "; remesh the surface");
  }

  // Halves the step until the convex function decreases along all of it, that is, until the slope at its end is not
  // positive, or much smaller than before. Returns false if the step has become zero.
  bool move_along(const Vector& step, Vector& gradient)
  {
    const double slope = gradient.dot(step);
    if(!(slope < 0))
      return false;
    for(double t = 1; t > internal::least_line_search_step; t /= 2) {
      Values u = moved(step, t);
      Vector next = defects(u);
      if(next.dot(step) <= -0.9 * slope) {
        m_log_scales = std::move(u);
        gradient = std::move(next);
        return true;
      }
    }
    return false;
  }

  // Directions are passed from face to face as angles, whose errors add up; differences of positions would magnify
  // errors at short sides.
  template <class Network>
  void lay_out(const Network& network)
  {
    constexpr double pi = boost::math::constants::pi<double>();
    m_points.assign(m_log_scales.size(), {0, 0});
    internal::Indexed_by<Vertex_copy_index, std::vector<char>> is_placed(m_log_scales.size(), 0);
    std::vector<double> direction(m_faces.size(), 0); // of side 0
    double error = 0;
    const auto put = [&](std::size_t f, int corner, const Point& p) {
      const Vertex_copy_index c = copy(m_faces[f], corner);
      if(is_placed[c] == 0)
        m_points[c] = p;
      else
        error = (std::max)(error, std::hypot(p[0] - m_points[c][0], p[1] - m_points[c][1]));
      is_placed[c] = 1;
    };

    const std::size_t start = largest_face();
    const internal::Plane_triangle first = scaled_face(start);
    put(start, 0, {0, 0});
    put(start, 1, {first.lengths[0], 0});
    put(start, 2, first.apex());
    std::vector<char> is_reached(m_faces.size(), 0);
    spread(network, start, is_reached, [&](std::size_t f, int side, std::size_t next) {
      const Halfedge_index h = Triangulation::twin(m_faces[f].halfedges[side]);
      int i = 0;
      while(m_faces[next].halfedges[i] != h)
        ++i;
      const internal::Plane_triangle face = scaled_face(next);
      direction[next] = side_direction(scaled_face(f), direction[f], side) + pi - side_direction(face, 0, i);
      const int head = (i + 1) % 3;
      const double along = side_direction(face, direction[next], head);
      const Point& from = m_points[copy(m_faces[next], head)];
      put(next, (i + 2) % 3,
          {from[0] + face.lengths[head] * std::cos(along), from[1] + face.lengths[head] * std::sin(along)});
    });
    double size = 0;
    for(const Point& p : m_points)
      size = (std::max)(size, std::hypot(p[0], p[1]));
    m_layout_error = error / size;
  }

  static double side_direction(const internal::Plane_triangle& face, double of_side_0, int side)
  {
    constexpr double pi = boost::math::constants::pi<double>();
    double result = of_side_0;
    for(int corner = 1; corner <= side; ++corner)
      result += pi - face.angle(corner);
    return result;
  }

  std::size_t largest_face() const
  {
    std::size_t largest = 0;
    for(std::size_t f = 1; f < m_faces.size(); ++f)
      if(scaled_face(f).area > scaled_face(largest).area)
        largest = f;
    return largest;
  }

  internal::Plane_triangle scaled_face(std::size_t f) const
  {
    const Intrinsic_face& face = m_faces[f];
    std::array<double, 3> lengths;
    for(int i = 0; i < 3; ++i)
      lengths[i] =
          face.lengths[i] * std::exp((m_log_scales[copy(face, i)] + m_log_scales[copy(face, (i + 1) % 3)]) / 2);
    return internal::Plane_triangle(lengths);
  }

  template <class Origin>
  Point point_in_face(Halfedge_index face, const Origin& origin) const
  {
    Halfedge_index h = face;
    for(int i = 0; i < 3; ++i, h = m_triangulation->next(h)) {
      const Point &a = m_points[copy_at(h)], &b = m_points[copy_at(m_triangulation->next(h))];
      if(origin.intrinsic_vertex != null_index && origin.intrinsic_vertex == m_triangulation->tail(h))
        return a;
      if(origin.intrinsic_vertex != null_index ||
         Triangulation::edge(origin.intrinsic_halfedge) != Triangulation::edge(h))
        continue;
      const double t = origin.intrinsic_halfedge == h ? origin.intrinsic_t : 1 - origin.intrinsic_t;
      return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1]};
    }
    CGAL_error_msg("the subdivision does not belong to the triangulation in the state that was flattened");
  }

  const Triangulation* m_triangulation;
  std::vector<Intrinsic_face> m_faces;
  internal::Cut_surface<Triangulation> m_surface;
  Values m_log_scales;
  internal::Indexed_by<Vertex_copy_index, std::vector<Index>> m_free; // the number among those not on the border
  internal::Indexed_by<Vertex_copy_index, std::vector<Point>> m_points;
  Index m_number_of_free = 0;
  double m_angle_error = 0, m_layout_error = 0;
  int m_iterations = 0;
};

namespace internal {

template <class Triangulation>
struct Internals<Conformal_flattening<Triangulation>>
{
  using Flattening = Conformal_flattening<Triangulation>;

  /*
   * Flattens a surface. Returns the sides to be split, and no result, if scaled lengths violate the triangle inequality
   * in some faces, or edges connect a vertex to itself.
   *
   * The logarithms of the conformal factors of smooth surfaces solve a linear equation, and the first step of Newton's
   * method solves its discretization. If the faces are small enough for this solution, the method converges fast.
   * \throws Flattening_error as `refine_and_flatten()` does
   */
  template <class Network>
  static std::vector<Halfedge_index> flatten(const Network& network, std::optional<Flattening>& result)
  {
    Flattening flattening(network, typename Flattening::Unscaled());
    flattening.check_faces();
    const auto estimate = flattening.first_estimate();
    check_scales(flattening, estimate);
    std::vector<Halfedge_index> sides = flattening.overlong_sides(estimate);
    for(const Intrinsic_face& face : flattening.m_faces)
      for(int i = 0; i < 3; ++i)
        if(face.vertices[i] == face.vertices[(i + 1) % 3])
          sides.push_back(face.halfedges[i]); // `carry_to()` could not distinguish the ends
    if(!sides.empty())
      return sides;
    flattening.minimize(default_angle_sum_tolerance);
    sides = flattening.overlong_sides(flattening.m_log_scales);
    if(!sides.empty())
      return sides;
    flattening.check_angles(default_angle_sum_tolerance);
    flattening.lay_out(network);
    result.emplace(std::move(flattening));
    return {};
  }

  template <class Network>
  static void check_disk(const Network& network)
  {
    Flattening(network, typename Flattening::Unscaled());
  }

  /* Returns a vertex of the input inside the cut surface, among the corners of the faces of some sides, if there is
   * one. */
  template <class Network>
  static std::vector<std::size_t> input_vertex_near(const Network& network, const std::vector<Halfedge_index>& sides)
  {
    const auto& triangulation = network.triangulation();
    for(Halfedge_index h : sides)
      for(int i = 0; i < 3; ++i, h = triangulation.next(h))
        if(const Vertex_index v = triangulation.tail(h); !triangulation.is_inserted(v) && is_inside(network, h))
          return {static_cast<std::size_t>(v.idx())};
    return {};
  }

private:
  /* Returns whether no edge at the tail of a halfedge is cut or on the border. */
  template <class Network>
  static bool is_inside(const Network& network, Halfedge_index h)
  {
    Halfedge_index g = h;
    do {
      if(network.is_occupied(g))
        return false;
      g = network.triangulation().clockwise(g);
    } while(g != null_index && g != h);
    return g == h;
  }

  template <class Values>
  static void check_scales(const Flattening& flattening, const Values& log_scales)
  {
    Vertex_copy_index extreme = null_index;
    for(Vertex_copy_index copy : descriptors<Vertex_copy_index>(flattening.number_of_copies()))
      if(!flattening.m_triangulation->is_inserted(flattening.vertex(copy)) &&
         std::abs(log_scales[copy]) > (extreme == null_index ? largest_log_scale : std::abs(log_scales[extreme])))
        extreme = copy;
    if(extreme == null_index)
      return;
    const auto v = static_cast<std::size_t>(flattening.vertex(extreme).idx());
    throw Flattening_error("the conformal factors are out of range: lengths at vertex " + std::to_string(v) +
                               " would be multiplied by about 1e" +
                               std::to_string(std::lround(log_scales[extreme] / std::log(10))) +
                               "; extend the cut to this vertex",
                           {v});
  }
};

/*
 * Replaces a halfedge of a chain by the two other sides of a face beside it if the opposite vertex is so close to the
 * halfedge that this face is degenerate in double precision. This is done for all halfedges of the chain. Returns
 * whether a halfedge was replaced.
 */
template <class Network>
bool replace_near_sides(const Network& network, std::vector<Halfedge_index>& chain)
{
  const auto& triangulation = network.triangulation();
  using Triangulation = typename Network::Triangulation;
  const auto is_near = [&](Halfedge_index h) {
    if(triangulation.is_border(h))
      return false;
    const Halfedge_index hn = triangulation.next(h);
    const double length = triangulation.length(h);
    const Plane_triangle face({length, triangulation.length(hn), triangulation.length(triangulation.next(hn))});
    return face.lengths[1] < length && face.lengths[2] < length &&
           2 * face.area < passed_vertex_height * length * length;
  };
  const std::size_t size = chain.size();
  for(std::size_t i = 0; i < chain.size();) {
    const Halfedge_index h = chain[i], t = Triangulation::twin(h);
    if(is_near(h)) {
      chain[i] = Triangulation::twin(triangulation.next(triangulation.next(h)));
      chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(i) + 1, Triangulation::twin(triangulation.next(h)));
    } else if(is_near(t)) {
      chain[i] = triangulation.next(t);
      chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(i) + 1, triangulation.next(triangulation.next(t)));
    } else {
      ++i;
    }
  }
  return chain.size() != size;
}

/* Splits an edge near its midpoint. Returns whether double precision permits it. */
template <class Network>
bool split_in_half(Network& network, Halfedge_index h)
{
  const auto& triangulation = network.triangulation();
  try {
    const auto point = point_on_edge(triangulation, triangulation.is_border(h) ? twin_index(h) : h, 0.5);
    if(point)
      network.split_edge(triangulation.is_border(h) ? twin_index(h) : h, point->location, point->gap);
    return point.has_value();
  } catch(const Insertion_error&) {
    return false;
  }
}

/*
 * Moves curves onto vertices beside them that are so close that the faces between the curves and these vertices are
 * degenerate in double precision. Returns whether a curve was moved.
 */
template <class Network>
bool move_to_near_vertices(Network& network)
{
  struct Chain
  {
    std::vector<Halfedge_index> halfedges;
    bool is_closed;
  };
  std::vector<Chain> chains;
  bool is_changed = false;
  for(Curve_index c : network.curves()) {
    chains.push_back({network.halfedges(c), network.is_closed(c)});
    is_changed = replace_near_sides(network, chains.back().halfedges) || is_changed;
  }
  if(!is_changed)
    return false;
  network.clear();
  for(const Chain& chain : chains)
    network.add_curve(chain.halfedges, parameters::is_closed(chain.is_closed));
  return true;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsOperators
 *
 * Refines a triangulation, cuts its surface open along the curves of a network, and flattens the cut surface.
 *
 * First, the triangulation is flipped to Delaunay. Then `refine()` is called with the default quality bounds; the
 * maximal number of insertions is 10 000 plus ten times the number of vertices of the triangulation. Edges that connect
 * a vertex to itself are split. As long as the scaled lengths violate the triangle inequality in some faces, the
 * longest sides of these faces are split near their midpoints.
 *
 * Before the surface is cut, each curve is moved onto all vertices whose distances from an edge of the curve are less
 * than about \f$10^{-7}\f$ times the length of this edge. If a curve is moved, all curves lose their fixed nodes and
 * the order of their overlapping segments.
 *
 * \param network an `Edge_path_network` of the curves along which the surface is cut, in an `Intrinsic_triangulation`
 *        of a connected surface. The triangulation must outlive the returned object
 * \param np the named parameter `visitor` of `refine()`, whose members are called during the flips and the refinement
 * \return the flattening, with a tolerance of 1e-10 radians for angle sums
 * \throws Flattening_error if the cut surface is not a disk; if splitting edges does not lead to a solution; if the
 *         tolerance is exceeded; or if the scale factor of an input vertex is estimated to be less than about
 *         \f$10^{-9}\f$ or greater than about \f$10^9\f$, so that coordinates in the plane would be too inaccurate. If
 *         the cut surface is a disk, `elements()` returns a vertex to which the cut should be extended, if one is known
 * \throws Degenerate_face_error if a face is degenerate in double precision, or as `refine()` does
 * \throws Occupied_triangulation_error as `refine()` does
 * \throws Invalid_mesh_error as `refine()` does
 * \throws Invalid_coordinate_error as `refine()` does
 */
template <class Network, class... NamedParameters>
Conformal_flattening<typename Network::Triangulation> refine_and_flatten(Network& network, const NamedParameters&... np)
{
  using Triangulation = typename Network::Triangulation;
  using Internals = internal::Internals<Conformal_flattening<Triangulation>>;
  constexpr int most_rounds = 40;
  const Triangulation& triangulation = network.triangulation();
  do
    flip_to_delaunay(network.triangulation(), np...);
  while(internal::move_to_near_vertices(network));
  Internals::check_disk(network); // rather than after the refinement, which can take long
  Refinement_options bounds;
  bounds.maximum_insertions = 10000 + 10 * static_cast<std::size_t>(triangulation.number_of_vertices());
  do
    refine(network, bounds, np...);
  while(internal::move_to_near_vertices(network)); // inserted ones
  const Index most_vertices = 2 * triangulation.number_of_vertices() + 1000;
  std::optional<Conformal_flattening<Triangulation>> result;
  for(int round = 0;; ++round) {
    std::vector<Halfedge_index> sides = Internals::flatten(network, result);
    if(result)
      return std::move(*result);
    const std::vector<std::size_t> tip = Internals::input_vertex_near(network, sides);
    for(Halfedge_index& h : sides)
      h = internal::first_side(Triangulation::edge(h));
    std::sort(sides.begin(), sides.end());
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    bool is_changed = false;
    for(Halfedge_index h : sides)
      is_changed = internal::split_in_half(network, h) || is_changed;
    if(!is_changed || round == most_rounds || triangulation.number_of_vertices() > most_vertices)
      throw Flattening_error(
          "scaling by the conformal factors violates the triangle inequality even after faces have been split; " +
              (tip.empty() ? std::string("cut the surface along other curves")
                           : "extend the cut to vertex " + std::to_string(tip.front())),
          tip);
  }
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_CONFORMAL_FLATTENING_H
