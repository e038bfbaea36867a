// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_REFINED_SURFACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_REFINED_SURFACE_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/point_coordinates.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* The source of points that no source reaches. */
inline constexpr std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

using Weights_in_face = std::array<double, 3>; // of the source, the target and the third vertex of the face's halfedge

/* A point in a face, and the value of a distance field there. */
struct Sample
{
  Index face; // counted as in `faces(mesh)`
  Weights_in_face weights;
  double distance;
  std::size_t source;
};

/* Detects whether a field has the optional member of `GeodesicDistanceField`. */
template <class Field, class Face, class = void>
constexpr bool finds_single_sources = false;
template <class Field, class Face>
constexpr bool finds_single_sources<
    Field, Face, std::void_t<decltype(std::declval<const Field&>().has_one_source(std::declval<const Face&>()))>> =
    true;

/* Interpolates; a weight too small for a surface point counts as zero. */
inline Weights_in_face between(const Weights_in_face& a, const Weights_in_face& b, double t)
{
  Weights_in_face result;
  for(std::size_t i = 0; i < 3; ++i) {
    const double weight = (1 - t) * a[i] + t * b[i];
    result[i] = weight < least_weight ? 0 : weight;
  }
  return result;
}

/*
 * A surface whose faces are divided into pieces, triangles that share whole sides, with samples of a distance field at
 * their corners. Pieces are bisected at their longest sides [R97]; a side of two pieces stays one, since both are
 * bisected together.
 *
 * Side i of a piece leads from its corner i to the next. The two directions of side s are its halves 2s and 2s + 1. A
 * half that is not on the border refers to its piece, so a piece may be glued to itself. Points on a side are
 * expressed in the piece of its first half that has one: all points on edges of the mesh are computed once.
 */
template <class TriangleMesh, class VertexPointMap, class Field>
class Refined_surface
{
public:
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using Location = std::pair<Face, Weights_in_face>;
  using Place = Place_in_space;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

  struct Piece
  {
    Index face;
    std::array<Index, 3> corners; // samples
    std::array<Index, 3> halves;
    std::array<Weights_in_face, 3> weights; // of the corners, in `face`
  };

  /* The position of a half: a side of a piece. */
  struct Use
  {
    Index piece = null_index, side = 0;
  };

  /* The interruption must outlive this object. All functions that evaluate the field can throw Interrupted. */
  Refined_surface(const TriangleMesh& mesh, const VertexPointMap& points, const Field& field,
                  Interruption& interruption)
    : m_mesh(mesh)
    , m_points(points)
    , m_field(field)
    , m_interruption(interruption)
  {
    const Numbered_mesh<TriangleMesh> numbered(mesh);
    m_samples.resize(static_cast<std::size_t>(numbered.number_of_vertices()), Sample{null_index, {}, 0, no_source});
    m_uses.resize(static_cast<std::size_t>(numbered.number_of_halfedges()));
    m_lengths.resize(m_uses.size() / 2, 0);
    for(const Face f : faces(mesh))
      add_face(numbered, mesh, f, points);
    for(Sample& sample : m_samples)
      if(sample.face != null_index)
        ask_field(sample);
  }

  Index number_of_faces() const { return static_cast<Index>(m_faces.size()); }
  Index number_of_pieces() const { return static_cast<Index>(m_pieces.size()); }
  Index number_of_halves() const { return static_cast<Index>(m_uses.size()); }
  const Piece& piece(Index p) const { return m_pieces[p]; }
  const Sample& sample(Index s) const { return m_samples[s]; }
  const Sample& corner(const Piece& piece, Index i) const { return m_samples[piece.corners[i % 3]]; }
  const Use& use(Index half) const { return m_uses[half]; }
  bool is_border(Index half) const { return m_uses[half].piece == null_index; }
  double length(Index half) const { return m_lengths[half / 2]; }
  double longest_side() const { return m_lengths.empty() ? 0 : *std::max_element(m_lengths.begin(), m_lengths.end()); }
  static Index twin(Index half) { return half ^ 1; }

  /* Returns the half of a side, not on the border, relative to which points on the side are expressed. */
  Index reference_half(Index half) const { return is_border(half & ~1) ? half | 1 : half & ~1; }

  /* Returns the sample at the start, and below at the end, of a half that is not on the border. */
  Index tail(Index half) const { return m_pieces[m_uses[half].piece].corners[m_uses[half].side]; }
  Index head(Index half) const { return m_pieces[m_uses[half].piece].corners[(m_uses[half].side + 1) % 3]; }

  /* Returns the longest side of a piece, by its half; a total order decides between equal ones. */
  Index longest(const Piece& piece) const
  {
    return *std::max_element(piece.halves.begin(), piece.halves.end(),
                             [this](Index a, Index b) { return is_longer(b, a); });
  }

  /* Bisects pieces, and others as necessary, until `is_fine(piece)` holds for all. */
  template <class Predicate>
  void refine(const Predicate& is_fine)
  {
    std::vector<Index> queue;
    for(Index p = number_of_pieces(); p-- > 0;)
      queue.push_back(p);
    while(!queue.empty())
      if(is_fine(m_pieces[queue.back()]))
        queue.pop_back();
      else
        bisect(terminal_side(queue.back()), queue);
  }

  /* Evaluates the field at a point; stored samples are evaluated once. */
  Sample sampled(Index face, const Weights_in_face& weights) const
  {
    Sample result = {face, weights, 0, no_source};
    ask_field(result);
    return result;
  }

  /* Evaluates the field at a point on a half that is not on the border. */
  Sample sampled(Index half, double t) const
  {
    const Piece& piece = m_pieces[m_uses[half].piece];
    const Index i = m_uses[half].side;
    return sampled(piece.face, between(piece.weights[i], piece.weights[(i + 1) % 3], t));
  }

  /* Returns whether one source is known to be nearest in all of a face. */
  bool has_one_source(Index face) const
  {
    throw_if_interrupted(&m_interruption);
    if constexpr(finds_single_sources<Field, Face>)
      return m_field.has_one_source(m_faces[face].descriptor);
    else
      return false;
  }

  Location location(const Sample& sample) const { return {m_faces[sample.face].descriptor, sample.weights}; }

  /* In space: rounded if the coordinates are, and otherwise constructed from the exact corners with weights whose sum
   * is one, so that it lies on the mesh. */
  Point point(const Sample& sample) const
  {
    using Number = Coordinate<Point>;
    if constexpr(std::is_arithmetic<Number>::value) {
      const Place p = place(sample);
      return Point(p[0], p[1], p[2]);
    } else {
      const Weights_in_face& w = sample.weights;
      const auto h = graph_halfedge(m_faces[sample.face].descriptor, m_mesh);
      const std::array<Point, 3> p = {get(m_points, source(h, m_mesh)), get(m_points, target(h, m_mesh)),
                                      get(m_points, target(next(h, m_mesh), m_mesh))};
      const auto i = static_cast<std::size_t>(std::max_element(w.begin(), w.end()) - w.begin());
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const Number u(w[j]), v(w[k]);
      const auto mean = [&](const Number& a, const Number& b, const Number& c) {
        return Number(a + u * (b - a) + v * (c - a));
      };
      return Point(mean(p[i].x(), p[j].x(), p[k].x()), mean(p[i].y(), p[j].y(), p[k].y()),
                   mean(p[i].z(), p[j].z(), p[k].z()));
    }
  }

  Place place(const Sample& sample) const
  {
    const std::array<Place, 3>& p = m_faces[sample.face].corners;
    const Weights_in_face& w = sample.weights;
    Place result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = w[0] * p[0][i] + w[1] * p[1][i] + w[2] * p[2][i];
    return result;
  }

  /* Returns the two of the three coordinates with the largest extent in a face. */
  std::array<std::size_t, 2> widest_axes(Index face) const
  {
    const std::array<Place, 3>& p = m_faces[face].corners;
    const auto width = [&](std::size_t axis) {
      const auto ends = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
      return ends.second - ends.first;
    };
    std::array<std::size_t, 3> axes = {{0, 1, 2}};
    std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) { return width(a) > width(b); });
    return {{axes[0], axes[1]}};
  }

  /* Returns the area of all faces. */
  double area() const
  {
    double sum = 0;
    for(const Corners& f : m_faces) {
      sum += norm(cross(difference(f.corners[1], f.corners[0]), difference(f.corners[2], f.corners[0]))) / 2;
    }
    return sum;
  }

private:
  struct Corners
  {
    Face descriptor;
    std::array<Place, 3> corners;
  };

  static double norm(const Place& v) { return std::hypot(v[0], v[1], v[2]); }

  void add_face(const Numbered_mesh<TriangleMesh>& numbered, const TriangleMesh& mesh, Face f,
                const VertexPointMap& points)
  {
    const Index number = checked_index_bound(m_faces.size());
    Piece piece = {number, {}, {}, {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}}};
    Corners corners = {f, {}};
    Input_halfedge_index h = numbered.index(graph_halfedge(f, mesh));
    check_triangle(numbered, h);
    for(Index i = 0; i < 3; ++i, h = numbered.next(h)) {
      piece.corners[i] = numbered.tail(h).idx();
      piece.halves[i] = h.idx();
      decltype(auto) p = get(points, numbered.vertex(numbered.tail(h)));
      corners.corners[i] = {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
      Sample& sample = m_samples[piece.corners[i]];
      if(sample.face == null_index)
        sample = {number, piece.weights[i], 0, no_source};
    }
    for(Index i = 0; i < 3; ++i)
      measure(piece.halves[i], difference(corners.corners[(i + 1) % 3], corners.corners[i]), piece);
    m_faces.push_back(corners);
    set_piece(number, piece);
  }

  void measure(Index half, const Place& vector, const Piece& piece)
  {
    const double length = norm(vector);
    if(!std::isfinite(length))
      throw Invalid_coordinate_error(
          "the face with vertices " + std::to_string(piece.corners[0]) + ", " + std::to_string(piece.corners[1]) +
              ", " + std::to_string(piece.corners[2]) + " has a corner with a coordinate that is NaN or too large",
          {static_cast<std::size_t>(piece.corners[0]), static_cast<std::size_t>(piece.corners[1]),
           static_cast<std::size_t>(piece.corners[2])});
    m_lengths[half / 2] = length;
  }

  void ask_field(Sample& sample) const
  {
    throw_if_interrupted(&m_interruption);
    const auto answer = m_field(m_faces[sample.face].descriptor, sample.weights);
    sample.distance = answer.distance;
    if(std::isnan(sample.distance))
      throw Invalid_parameter_error("the distance field returns NaN in face " + std::to_string(sample.face),
                                    {static_cast<std::size_t>(sample.face)});
    sample.source = std::isinf(sample.distance) ? no_source : answer.source;
  }

  // Stores a piece and updates its halves.
  void set_piece(Index p, const Piece& piece)
  {
    if(p == number_of_pieces())
      m_pieces.push_back(piece);
    else
      m_pieces[p] = piece;
    for(Index i = 0; i < 3; ++i)
      m_uses[piece.halves[i]] = {p, i};
  }

  bool is_longer(Index half, Index other) const
  {
    return length(half) != length(other) ? length(half) > length(other) : half / 2 > other / 2;
  }

  // Continues from a piece across longest sides to one that is the longest of both its pieces, or on the border; each
  // is longer than the previous one.
  Index terminal_side(Index p) const
  {
    for(;;) {
      const Index half = longest(m_pieces[p]), other = twin(half);
      if(is_border(other) || longest(m_pieces[m_uses[other].piece]) / 2 == half / 2)
        return half;
      p = m_uses[other].piece;
    }
  }

  /*
   *        c                 Side s from a to b, at k in the piece on its left, becomes s from a to m, and a new one
   *       /|\                from m to b; seen from the other piece it leads from b to a.
   *      / | \
   *     /  |  \
   *    a - m - b
   */
  void bisect(Index half, std::vector<Index>& queue)
  {
    const Index s = half / 2;
    const Index m = static_cast<Index>(m_samples.size());
    m_samples.push_back(sampled(reference_half(half), 0.5));
    const Index rest = add_side(m_lengths[s] / 2);
    m_lengths[s] /= 2;
    bisect_piece(m_uses[2 * s], m, 2 * s, 2 * rest, queue);
    bisect_piece(m_uses[2 * s + 1], m, 2 * rest + 1, 2 * s + 1, queue);
  }

  void bisect_piece(Use at, Index m, Index first, Index second, std::vector<Index>& queue)
  {
    if(at.piece == null_index)
      return;
    const Piece old = m_pieces[at.piece];
    const Index a = at.side, b = (a + 1) % 3, c = (a + 2) % 3;
    const Weights_in_face middle = between(old.weights[a], old.weights[b], 0.5);
    const Index cut = add_side(distance(old.face, middle, old.weights[c]));
    set_piece(at.piece, {old.face,
                         {{old.corners[a], m, old.corners[c]}},
                         {{first, 2 * cut, old.halves[c]}},
                         {{old.weights[a], middle, old.weights[c]}}});
    queue.push_back(number_of_pieces());
    set_piece(queue.back(), {old.face,
                             {{m, old.corners[b], old.corners[c]}},
                             {{second, old.halves[b], 2 * cut + 1}},
                             {{middle, old.weights[b], old.weights[c]}}});
    queue.push_back(at.piece);
  }

  // There are more halves than samples and pieces.
  Index add_side(double length)
  {
    if(m_uses.size() + 2 > static_cast<std::size_t>((std::numeric_limits<Index>::max)()))
      throw Invalid_parameter_error(
          "the tolerance is so small that faces have more parts than 32-bit indices can number");
    m_lengths.push_back(length);
    m_uses.resize(m_uses.size() + 2);
    return number_of_halves() / 2 - 1;
  }

  double distance(Index face, const Weights_in_face& p, const Weights_in_face& q) const
  {
    const std::array<Place, 3>& f = m_faces[face].corners;
    const Place u = difference(f[1], f[0]), v = difference(f[2], f[0]);
    const double s = q[1] - p[1], t = q[2] - p[2];
    return norm({{s * u[0] + t * v[0], s * u[1] + t * v[1], s * u[2] + t * v[2]}});
  }

  const TriangleMesh& m_mesh;
  VertexPointMap m_points;
  const Field& m_field;
  Interruption& m_interruption;
  std::vector<Corners> m_faces;
  std::vector<Sample> m_samples;
  std::vector<Piece> m_pieces;
  std::vector<Use> m_uses;       // by half
  std::vector<double> m_lengths; // by side
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_REFINED_SURFACE_H
