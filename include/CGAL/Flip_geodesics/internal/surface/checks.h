// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECKS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECKS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/surface/point_coordinates.h>

#include <CGAL/enum.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// The faces of a metric. If the metric has exact squared lengths, faces are made of these.

namespace CGAL::Flip_geodesics::internal {

/* Returns whether squares of a length and products of squares are normal doubles, by the range in tolerances.h. */
inline bool is_usable_length(double length) { return length > least_length && length < greatest_length; }

/* Returns whether a length is usable for searches along edges, which pass degenerate edges. */
inline bool is_zero_or_usable_length(double length) { return length == 0 || is_usable_length(length); }

/* Returns whether a > b + c, exactly. */
inline bool is_longer_than_sum(double a, double b, double c)
{
  const Double_double sum = exact_sum(b, c);
  return a > sum.high || (a == sum.high && sum.low < 0);
}

[[noreturn]] inline void throw_unusable_length(double length, Vertex_index v, Vertex_index w)
{
  if(length == 0)
    throw Degenerate_face_error(
        "the edge between vertices " + std::to_string(v.idx()) + " and " + std::to_string(w.idx()) + " has length zero",
        {static_cast<std::size_t>(v.idx()), static_cast<std::size_t>(w.idx())}, Degeneracy_remedy::CONTRACT);
  throw_naming<Invalid_coordinate_error>(
      "the edge between vertices ", v, " and ", w, " has the length ", length,
      ", which is not a number between 1e-70 and 1e70; scale the mesh or correct this length");
}

inline bool satisfy_triangle_inequality(double a, double b, double c)
{
  return !is_longer_than_sum(a, b, c) && !is_longer_than_sum(b, c, a) && !is_longer_than_sum(c, a, b);
}

/* Whether a metric lays out faces from the places of vertices in space. */
template <class Metric>
inline constexpr bool has_places_in_space = std::is_same<typename Metric::Place, std::array<double, 3>>::value ||
                                            std::is_same<typename Metric::Place, Approximate_place>::value;

/* Returns whether a metric makes the vectors of a face, without throwing an exception. */
template <class Metric, class Input_mesh>
bool is_usable_face(const Metric& metric, const Input_mesh& mesh, Input_halfedge_index h)
{
  if constexpr(Internals<Metric>::has_usable_faces) {
    return Internals<Metric>::is_usable_face(metric, mesh, h);
  } else {
    const Input_halfedge_index hn = mesh.next(h), hp = mesh.next(hn);
    const double a = metric.weight(mesh, h), b = metric.weight(mesh, hn), c = metric.weight(mesh, hp);
    return is_usable_length(a) && is_usable_length(b) && is_usable_length(c) &&
           (has_places_in_space<Metric> || satisfy_triangle_inequality(a, b, c));
  }
}

template <class Input_mesh>
[[noreturn]] void throw_triangle_inequality(const Input_mesh& mesh, Input_halfedge_index h)
{
  throw_naming<Degenerate_face_error>("the edge lengths of the face with vertices ", mesh.tail(h), ", ",
                                      mesh.tail(mesh.next(h)), ", ", mesh.tail(mesh.previous(h)),
                                      " violate the triangle inequality");
}

/* Returns the length of an edge for a metric that defines its weight. \throws the exceptions of IntrinsicMetric */
template <class Metric, class Input_mesh>
double length_by_weight(const Metric& metric, const Input_mesh& mesh, Input_halfedge_index h)
{
  const double length = metric.weight(mesh, h);
  if(!is_usable_length(length))
    throw_unusable_length(length, mesh.tail(h), mesh.tail(twin_index(h)));
  return length;
}

/* Returns the lengths of the sides of a face, from `h` on. */
template <class Metric, class Input_mesh>
std::array<double, 3> face_lengths(const Metric& metric, const Input_mesh& mesh, Input_halfedge_index h)
{
  const Input_halfedge_index hn = mesh.next(h), hp = mesh.next(hn);
  return {metric.length(mesh, h), metric.length(mesh, hn), metric.length(mesh, hp)};
}

/* Returns the geometry of the face with these lengths. \throws Degenerate_face_error, Invalid_coordinate_error */
template <class Metric, class Input_mesh, class Traits>
typename Traits::Face_geometry face_geometry_by_lengths(const Metric& metric, const Input_mesh& mesh,
                                                        Input_halfedge_index h, const Traits& traits)
{
  const auto [a, b, c] = face_lengths(metric, mesh, h);
  if(!satisfy_triangle_inequality(a, b, c))
    throw_triangle_inequality(mesh, h);
  return traits.construct_face_from_lengths_object()(a, b, c);
}

class Flat_edges;

/* Detects the optional member of IntrinsicMetric. */
template <class Metric, class = void>
constexpr bool has_squared_lengths = false;
template <class Metric>
constexpr bool
    has_squared_lengths<Metric, std::void_t<decltype(std::declval<const Metric&>().squared_length(
                                    std::declval<const typename Metric::Mesh&>(), Input_halfedge_index()))>> = true;

/* Whether the faces of a metric are known in exact numbers. */
template <class Metric>
inline constexpr bool has_exact_faces = has_squared_lengths<Metric> || Internals<Metric>::has_exact_faces;

/* Returns the exact squared lengths of the sides of a face from h on. */
template <class Metric, class Mesh>
Squared_lengths squared_lengths(const Metric& metric, const Mesh& mesh, Input_halfedge_index h)
{
  using Number = std::decay_t<decltype(metric.squared_length(mesh, h))>;
  static_assert(is_rational_number<Number>,
                "squared_length() of a metric must return an exact rational number, such as cpp_rational or Gmpq");
  const Input_halfedge_index hn = mesh.next(h);
  const Rational_place squares =
      rational_place(to_rational(metric.squared_length(mesh, h)), to_rational(metric.squared_length(mesh, hn)),
                     to_rational(metric.squared_length(mesh, mesh.next(hn))));
  return {squares.numerators, squares.denominator};
}

/* Returns the geometry of the face on the left of h, from rounded lengths if the traits take no exact squared ones. */
template <class Metric, class Mesh, class Traits>
typename Traits::Face_geometry face_geometry_from_squares(const Metric& metric, const Mesh& mesh,
                                                          Input_halfedge_index h, const Traits& traits)
{
  const Input_halfedge_index hn = mesh.next(h);
  const double a = metric.length(mesh, h), b = metric.length(mesh, hn), c = metric.length(mesh, mesh.next(hn));
  const Squared_lengths squares = squared_lengths(metric, mesh, h);
  if(!squares.satisfy_triangle_inequality())
    throw_triangle_inequality(mesh, h);
  const auto construct = traits.construct_face_from_lengths_object();
  if constexpr(std::is_invocable<decltype(construct), const std::array<Integer, 3>&, const Integer&>::value)
    return construct(squares.numerators, squares.denominator);
  else
    return construct(a, b, c);
}

/* Returns the geometry of the face on the left of h. \throws Degenerate_face_error, Invalid_coordinate_error */
template <class Metric, class Mesh, class Traits>
typename Traits::Face_geometry face_geometry(const Metric& metric, const Mesh& mesh, Input_halfedge_index h,
                                             const Traits& traits)
{
  if constexpr(has_squared_lengths<Metric>)
    return face_geometry_from_squares(metric, mesh, h, traits);
  else
    return metric.face_geometry(mesh, h, traits);
}

/* Returns the face on the left of h in exact numbers. */
template <class Metric, class Mesh>
Exact_face exact_face(const Metric& metric, const Mesh& mesh, Input_halfedge_index h)
{
  static_assert(has_exact_faces<Metric>, "the metric has no squared_length(), which exact predicates require");
  if constexpr(has_squared_lengths<Metric>)
    return exact_face_from_squares(squared_lengths(metric, mesh, h).numerators);
  else
    return Internals<Metric>::exact_face(metric, mesh, h);
}

/*
 * Computes the exact sign of the sine of the wedge from the direction of one edge sequence clockwise over `steps` input
 * corners to that of another, if the faces lie unfolded in one plane of space, or bend along parallel edges only.
 * `flat_edges` caches results for edges. Returns false, and no sign, for other faces, or if the metric has no points.
 */
template <class Metric, class Mesh>
bool sine_in_plane(const Metric& metric, const Mesh& mesh, const Edge_sequence& a, const Edge_sequence& b, Index steps,
                   Flat_edges& flat_edges, Sign& sine)
{
  if constexpr(Internals<Metric>::has_exact_faces)
    return Internals<Metric>::sine_in_plane(metric, mesh, a, b, steps, flat_edges, sine);
  else
    return false;
}

/* The message lists the vertices of the face on the left of h, the first of them if there are many. */
template <class Input_mesh>
[[noreturn]] BOOST_NOINLINE void throw_no_triangle(const Input_mesh& input, Input_halfedge_index h)
{
  constexpr std::size_t most_vertices = 8;
  std::string names;
  std::vector<std::size_t> vertices;
  Input_halfedge_index side = h;
  do {
    vertices.push_back(static_cast<std::size_t>(input.tail(side).idx()));
    names += (names.empty() ? "" : ", ") + std::to_string(vertices.back());
    side = input.next(side);
  } while(side != h && vertices.size() < most_vertices);
  throw Invalid_mesh_error("the face with vertices " + names + (side == h ? "" : ", ...") +
                               " is not a triangle; triangulate the mesh",
                           vertices);
}

/*
 * Throws Invalid_mesh_error unless the face on the left of input halfedge h is a triangle. Any code that enters a face
 * of the input through its own links, and not through those of a triangulation, must call this: traversing the corners
 * of another polygon as if there were three need not terminate.
 */
template <class Input_mesh>
void check_triangle(const Input_mesh& input, Input_halfedge_index h)
{
  if(!input.is_triangle(h))
    throw_no_triangle(input, h);
}

/* Throws Invalid_mesh_error unless the edge of a halfedge that has no face on its left has one on its right. */
template <class Input_mesh>
void check_has_face(const Input_mesh& input, Input_halfedge_index h)
{
  const Input_halfedge_index t = twin_index(h);
  if(!input.is_border(t))
    return;
  const Vertex_index v = input.tail(h), w = input.tail(t);
  throw_naming<Invalid_mesh_error>("the edge between vertices ", v, " and ", w, " does not belong to a face");
}

[[noreturn]] inline void throw_disconnected(Vertex_index source, Vertex_index target)
{
  throw_naming<Disconnected_endpoints_error>("vertices ", source, " and ", target,
                                             " lie in different connected components; no path connects them");
}

/* Two points that no path connects are named by vertices of their faces, as they need not be vertices. */
[[noreturn]] inline void throw_disconnected_points(Vertex_index v, Vertex_index w)
{
  throw_naming<Disconnected_endpoints_error>("no path connects a point near vertex ", v, " with a point near vertex ",
                                             w);
}

[[noreturn]] inline void throw_no_face_at(Vertex_index v)
{
  if(!v.is_valid())
    throw_naming<Vertex_out_of_range_error>("a given vertex is not a vertex of the mesh");
  throw_naming<Vertex_out_of_range_error>("a location is at vertex ", v,
                                          ", which does not belong to any face of the mesh");
}

inline bool is_vertex(Vertex_index v, Index number_of_vertices) { return v.is_valid() && v.idx() < number_of_vertices; }

/* Throws Vertex_out_of_range_error unless `v` is less than the number of vertices. The message has the name of an
 * argument that has no index. */
inline void check_vertex(Vertex_index v, Index number_of_vertices, const char* argument = "a given vertex")
{
  if(is_vertex(v, number_of_vertices))
    return;
  if(!v.is_valid())
    throw_naming<Vertex_out_of_range_error>(argument, " is not one of the ", number_of_vertices, " vertices");
  throw_naming<Vertex_out_of_range_error>("vertex ", v, " is not one of the ", number_of_vertices, " vertices");
}

/* Throws Vertex_out_of_range_error unless a vertex of a curve is less than the number of vertices. */
inline void check_vertex(Vertex_index v, Index number_of_vertices, std::size_t position)
{
  if(!is_vertex(v, number_of_vertices))
    throw_naming<Vertex_out_of_range_error>(v.is_valid() ? "vertex " + std::to_string(v.idx()) : "a given vertex",
                                            " at position ", Element{position}, " of a curve is not one of the ",
                                            number_of_vertices, " vertices");
}

/* Lays out faces in doubles: the part of `Intrinsic_triangulation_traits<K, double>` that metrics require. */
template <class K>
struct Double_face_traits
{
  using Point_3 = typename K::Point_3;

  struct Halfedge_geometry
  {
    double x, y;
  };
  using Face_geometry = std::array<Halfedge_geometry, 3>;

  /* Lays out a face given by its three points. Each vector is computed from its own differences and dot products, since
   * closing the triangle instead would lose the small angles of needles. */
  class Construct_face_3
  {
  public:
    Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
    {
      return operator()(rounded_sides(p, q, r));
    }

    /* By the vectors of the halfedges in space. */
    Face_geometry operator()(const std::array<std::array<double, 3>, 3>& e) const
    {
      const double base = std::sqrt(dot(e[0], e[0]));
      const double height = doubled_area(e) / base;
      return {{{base, 0}, {dot(e[0], e[1]) / base, height}, {dot(e[0], e[2]) / base, -height}}};
    }

  private:
    using Vector_3 = std::array<double, 3>;

    static double dot(const Vector_3& u, const Vector_3& v)
    {
      return unfused(u[0] * v[0]) + unfused(u[1] * v[1]) + unfused(u[2] * v[2]);
    }

    // Uses the two shortest edges, which minimizes cancellation.
    static double doubled_area(const std::array<Vector_3, 3>& e)
    {
      const std::array<double, 3> l = {dot(e[0], e[0]), dot(e[1], e[1]), dot(e[2], e[2])};
      const int longest = static_cast<int>((std::max_element)(l.begin(), l.end()) - l.begin());
      const Vector_3& u = e[(longest + 1) % 3];
      const Vector_3& v = e[(longest + 2) % 3];
      const auto entry = [&](int i, int j) { return unfused(u[i] * v[j]) - unfused(u[j] * v[i]); };
      const Vector_3 n = {entry(1, 2), entry(2, 0), entry(0, 1)};
      return std::sqrt(dot(n, n));
    }
  };

  /* Lays out a face given by the lengths of its edges. \pre the triangle inequality holds */
  class Construct_face_from_lengths
  {
  public:
    Face_geometry operator()(double a, double b, double c) const
    {
      const std::array<double, 3> length = {a, b, c};
      const int first = static_cast<int>((std::max_element)(length.begin(), length.end()) - length.begin());
      Face_geometry face = on_longest(length[first], length[(first + 1) % 3], length[(first + 2) % 3]);
      std::rotate(face.begin(), face.begin() + (3 - first) % 3, face.end());
      return turned_to_first(face, a);
    }

    /* By the exact squared lengths `squares[i] / denominator`. Each coordinate is computed exactly and then rounded. */
    template <class Integer>
    Face_geometry operator()(const std::array<Integer, 3>& squares, const Integer& denominator) const
    {
      const Squared_lengths lengths = {squares, denominator};
      const double base = lengths.length(0).high, height = lengths.doubled_area().high / base;
      return {{{base, 0}, {lengths.dot(0).high / base, height}, {lengths.dot(2).high / base, -height}}};
    }

  private:
    // On the longest edge, all three vectors are accurate relative to their own lengths.
    static Face_geometry on_longest(double a, double b, double c)
    {
      const double height = doubled_area(a, b, c) / a;
      return {{{a, 0},
               {(unfused((c - a) * (c + a)) - unfused(b * b)) / (2 * a), height},
               {(unfused((b - a) * (b + a)) - unfused(c * c)) / (2 * a), -height}}};
    }

    static Face_geometry turned_to_first(const Face_geometry& face, double length)
    {
      const double x = face[0].x / length, y = -face[0].y / length;
      const auto turned = [x, y](const Halfedge_geometry& v) {
        return Halfedge_geometry{unfused(v.x * x) - unfused(v.y * y), unfused(v.x * y) + unfused(v.y * x)};
      };
      return {{{length, 0}, turned(face[1]), turned(face[2])}};
    }

    // Heron's formula in the order that is accurate for needles [K14]; a negative product results from rounding errors
    // in a degenerate triangle.
    static double doubled_area(double a, double b, double c)
    {
      std::array<double, 3> l = {a, b, c};
      std::sort(l.begin(), l.end(), std::greater<double>());
      const double product =
          (l[0] + (l[1] + l[2])) * (l[2] - (l[0] - l[1])) * (l[2] + (l[0] - l[1])) * (l[0] + (l[1] - l[2]));
      return product > 0 ? std::sqrt(product) / 2 : 0;
    }
  };

  /* Lays out a face given by the vectors of its halfedges in one frame. */
  class Construct_face_2
  {
  public:
    Face_geometry operator()(const std::array<std::array<double, 2>, 3>& v, double /* error */) const
    {
      return {{{v[0][0], v[0][1]}, {v[1][0], v[1][1]}, {v[2][0], v[2][1]}}};
    }
  };

  Construct_face_3 construct_face_3_object() const { return {}; }
  Construct_face_from_lengths construct_face_from_lengths_object() const { return {}; }
  Construct_face_2 construct_face_2_object() const { return {}; }
};

/* Returns the vectors of the input face on the left of h, starting with h, in the numbers of some traits; the face must
 * be a triangle. */
template <class Triangulation, class Traits>
auto input_face_geometry(const Triangulation& triangulation, Input_halfedge_index h, const Traits& traits)
{
  check_triangle(triangulation.input(), h);
  return face_geometry(triangulation.metric(), triangulation.input(), h, traits);
}

/* Returns the vectors in doubles, with h on the positive real axis, of a face known to be a triangle. */
template <class Triangulation>
auto known_input_face_geometry(const Triangulation& triangulation, Input_halfedge_index h)
{
  using Traits = Double_face_traits<typename Triangulation::Metric::Kernel>;
  return face_geometry(triangulation.metric(), triangulation.input(), h, Traits());
}

/* Returns the vectors in doubles of any face, which must be a triangle. */
template <class Triangulation>
auto input_face_geometry(const Triangulation& triangulation, Input_halfedge_index h)
{
  check_triangle(triangulation.input(), h);
  return known_input_face_geometry(triangulation, h);
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECKS_H
