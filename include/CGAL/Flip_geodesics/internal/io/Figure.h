// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_IO_FIGURE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_IO_FIGURE_H

#include <CGAL/Flip_geodesics/IO/appearance.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/math/constants/constants.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <ios>
#include <iterator>
#include <limits>
#include <locale>
#include <memory>
#include <ostream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

// Conversion of a writer's arguments to a figure.

namespace CGAL::Flip_geodesics::internal {

using Figure_point = std::array<double, 3>;
using Figure_triangle = std::array<std::size_t, 3>;
using Texture_corners = std::array<std::array<double, 2>, 3>;

/* Consumes elements one after the other. */
template <class T>
using Sink = std::function<void(const T&)>;

/*
 * A part of the contents of a file: a surface, a curve as a line or a tube, or loose points. Its elements are
 * enumerated in order as often as required, without copies. Corners of triangles are indices of its points.
 */
struct Shape
{
  enum class Kind { TRIANGLES, LINE, POINTS };
  static constexpr std::int64_t no_curve = -1;

  Kind kind = Kind::POINTS;
  std::int64_t curve = no_curve; // its number, if it is a curve
  std::size_t number_of_points = 0, number_of_triangles = 0;
  std::function<void(const Sink<Figure_point>&)> for_each_point;
  std::function<void(const Sink<Figure_triangle>&)> for_each_triangle; // of TRIANGLES only
  std::function<void(const Sink<Texture_corners>&)> for_each_texture;  // the corners' positions in a texture, if any
  std::vector<std::function<void(const Sink<double>&)>> values;        // at its points, by kind; null if absent

  std::string name() const
  {
    if(curve != no_curve)
      return "curve_" + std::to_string(curve);
    return kind == Kind::TRIANGLES ? "surface" : "points";
  }
};

/* A color and its name; the components are linear, from 0 to 1. */
struct Material
{
  const char* name;
  Figure_point color;

  /* Returns the components as sRGB [IEC 61966-2-1], from 0 to 255. */
  std::array<std::uint8_t, 3> bytes() const
  {
    std::array<std::uint8_t, 3> result;
    for(std::size_t i = 0; i < result.size(); ++i) {
      const double x = color[i];
      const double encoded = 12.92 * x <= 0.04045 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
      result[i] = static_cast<std::uint8_t>(std::lround(255 * encoded));
    }
    return result;
  }
};

/* The colors of surfaces, points and curves. */
inline constexpr std::array<Material, 6> materials = {{{"surface", {0.75, 0.76, 0.78}},
                                                       {"points", {0.05, 0.05, 0.05}},
                                                       {"curve_a", {0.72, 0.04, 0.04}},
                                                       {"curve_b", {0.02, 0.2, 0.6}},
                                                       {"curve_c", {0.0, 0.33, 0.1}},
                                                       {"curve_d", {0.55, 0.25, 0.0}}}};

inline const Material& material_of(const Shape& shape)
{
  if(shape.curve == Shape::no_curve)
    return materials[shape.kind == Shape::Kind::TRIANGLES ? 0 : 1];
  return materials[2 + static_cast<std::size_t>(shape.curve) % (materials.size() - 2)];
}

/* A kind of values at points, each of which consists of the same number of components. */
struct Value_kind
{
  std::string name;
  std::size_t components;
};

/* All parts of the contents of a file, and the order of all their points. */
class Figure
{
public:
  /* Parts without points are skipped. */
  void add(Shape shape)
  {
    if(shape.number_of_points == 0)
      return;
    m_number_of_points += shape.number_of_points;
    m_shapes.push_back(std::move(shape));
  }

  const std::vector<Shape>& shapes() const { return m_shapes; }
  std::size_t number_of_points() const { return m_number_of_points; }

  std::size_t number_of_triangles() const
  {
    std::size_t count = 0;
    for(const Shape& shape : m_shapes)
      count += shape.number_of_triangles;
    return count;
  }

  void for_each_point(const Sink<Figure_point>& sink) const
  {
    for(const Shape& shape : m_shapes)
      shape.for_each_point(sink);
  }

  /* Calls `f(shape, first)` for all shapes of a kind; the first point of the shape is number `first` of all. */
  template <class Function>
  void for_each_shape(Shape::Kind kind, const Function& f) const
  {
    std::size_t first = 0;
    for(const Shape& shape : m_shapes) {
      if(shape.kind == kind)
        f(shape, first);
      first += shape.number_of_points;
    }
  }

  const std::vector<Value_kind>& value_kinds() const { return m_value_kinds; }
  void add_value_kind(const Value_kind& kind) { m_value_kinds.push_back(kind); }

  /* Enumerates the components at all points; NaN if a part has no values of this kind. */
  void for_each_value(std::size_t kind, const Sink<double>& sink) const
  {
    for(const Shape& shape : m_shapes)
      if(kind < shape.values.size() && shape.values[kind])
        shape.values[kind](sink);
      else
        for(std::size_t i = 0; i < m_value_kinds[kind].components * shape.number_of_points; ++i)
          sink(std::numeric_limits<double>::quiet_NaN());
  }

  /* Returns the request for colors; null if there is none. */
  const IO::Colors* colors() const { return m_colors; }
  void set_colors(const IO::Colors& colors) { m_colors = &colors; }

  /* Returns the name of the image file of the texture; empty if there is none. */
  const std::string& picture() const { return m_picture; }
  void set_picture(const std::string& name) { m_picture = name; }

private:
  std::vector<Shape> m_shapes;
  std::vector<Value_kind> m_value_kinds;
  const IO::Colors* m_colors = nullptr;
  std::string m_picture;
  std::size_t m_number_of_points = 0;
};

[[noreturn]] inline void throw_unusable_point(const Shape& shape, std::size_t i, const std::string& reason)
{
  const std::string number = std::to_string(i);
  if(shape.curve == Shape::no_curve)
    throw Invalid_coordinate_error((shape.kind == Shape::Kind::TRIANGLES ? "vertex " : "point ") + number + reason,
                                   {i});
  throw Invalid_coordinate_error(
      (shape.kind == Shape::Kind::TRIANGLES ? "corner " + number + " of the tube around" : "point " + number + " of") +
          " curve " + std::to_string(shape.curve) + reason,
      {static_cast<std::size_t>(shape.curve), i});
}

inline void check_finite(const Shape& shape)
{
  std::size_t i = 0;
  shape.for_each_point([&](const Figure_point& p) {
    if(!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
      throw_unusable_point(shape, i, " has a coordinate that is not a finite number");
    ++i;
  });
}

/* Returns whether a triangle has texture coordinates. */
inline bool is_textured(const Texture_corners& corners)
{
  return std::all_of(corners.begin(), corners.end(),
                     [](const auto& t) { return std::isfinite(t[0]) && std::isfinite(t[1]); });
}

/* Checks that text formats and 64-bit numbers can represent the figure: it must not be empty, and all numbers must be
 * finite. */
inline void check_writable(const Figure& figure)
{
  if(figure.shapes().empty())
    throw File_write_error("there is nothing to write: no vertex, no point, and no curve that has a point");
  std::for_each(figure.shapes().begin(), figure.shapes().end(), check_finite);
}

inline bool is_character_of_name(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/* Checks that all formats can represent the names, that these are distinct, and that numbers in text formats are
 * finite, since their readers stop at others. */
inline void check_values(const Figure& figure, bool is_binary)
{
  const std::vector<Value_kind>& kinds = figure.value_kinds();
  for(std::size_t i = 0; i < kinds.size(); ++i) {
    const std::string& name = kinds[i].name;
    if(name.empty() || !std::all_of(name.begin(), name.end(), is_character_of_name))
      throw Invalid_parameter_error("the name \"" + name +
                                    "\" of values must consist of one or more letters, digits and underscores");
    if(std::any_of(kinds.begin(), kinds.begin() + static_cast<std::ptrdiff_t>(i),
                   [&](const Value_kind& kind) { return kind.name == name; }))
      throw Invalid_parameter_error("two arrays of values have the name \"" + name + '"');
    if(!is_binary)
      figure.for_each_value(i, [&](double x) {
        if(!std::isfinite(x))
          throw File_write_error("the values with the name \"" + name +
                                 "\" include infinite or NaN entries (points of curves and separate points always have "
                                 "NaN) and cannot be written as text; use binary mode");
      });
  }
}

/*
 * A tube of triangles around a polyline. Seen against the direction of the curve, the corners of a ring are numbered
 * counterclockwise:
 *
 *        j ___________ j
 *         |\__        |
 *         |   \__     |        the triangles between a ring and the next one, from outside;
 *         |      \__  |        the curve runs to the right
 *         |_________\_|
 *       j+1            j+1
 *     ring i          ring i+1
 *
 * The first corner of a ring is transported from point to point by the least rotation between consecutive tangents, so
 * that the tube is not twisted. At the end of a closed curve, that corner may have another direction than at the start;
 * the last ring is then joined to the first one shifted by some corners.
 */
class Tube
{
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;
  static constexpr double two_pi = boost::math::constants::two_pi<double>();

public:
  /* A polyline is closed if its last point is its first. */
  Tube(const std::vector<Figure_point>& polyline, const IO::Tubes& tubes)
    : m_radius(tubes.radius())
    , m_sides(static_cast<std::size_t>(tubes.number_of_sides()))
  {
    set_line(polyline);
    if(m_line.size() < 2)
      return;
    set_tangents();
    Vector normal = perpendicular(m_tangents.front());
    const Vector first_normal = normal;
    for(std::size_t i = 0; i < m_line.size(); ++i) {
      if(i > 0)
        normal = carried(normal, m_tangents[i - 1], m_tangents[i]);
      add_ring(i, normal);
      if(i > 0)
        join(m_sides * (i - 1), m_sides * i, 0);
    }
    if(m_is_closed)
      join(m_sides * (m_line.size() - 1), 0, turn_to(first_normal, normal));
    else
      add_caps();
  }

  /* Returns no points if the polyline has length zero. */
  const std::vector<Figure_point>& points() const { return m_points; }
  const std::vector<Figure_triangle>& triangles() const { return m_triangles; }

private:
  // Skips points that equal the previous one.
  void set_line(const std::vector<Figure_point>& polyline)
  {
    std::unique_copy(polyline.begin(), polyline.end(), std::back_inserter(m_line));
    m_is_closed = m_line.size() > 3 && m_line.front() == m_line.back();
    if(m_is_closed)
      m_line.pop_back();
  }

  // Scaled first, since the squares of its coordinates may overflow.
  static Vector unit(const Vector& v)
  {
    const double size = (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
    const Vector scaled(v.x() / size, v.y() / size, v.z() / size);
    return scaled / std::sqrt(scaled.squared_length());
  }

  // From point i of the line to the next one.
  Vector direction(std::size_t i) const
  {
    const Figure_point &p = m_line[i], &q = m_line[(i + 1) % m_line.size()];
    return unit(Vector(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
  }

  void set_tangents()
  {
    const std::size_t last = m_line.size() - 1;
    for(std::size_t i = 0; i <= last; ++i) {
      const Vector next = direction(m_is_closed || i < last ? i : last - 1);
      const Vector before = m_is_closed || i > 0 ? direction(i > 0 ? i - 1 : last) : next;
      const Vector sum = before + next;
      m_tangents.push_back(sum.squared_length() > reversal ? unit(sum) : before); // a reversal has no bisecting plane
    }
  }

  // The axis that is farthest from v, made perpendicular to it.
  static Vector perpendicular(const Vector& v)
  {
    const double x = std::abs(v.x()), y = std::abs(v.y()), z = std::abs(v.z());
    const Vector axis = x <= y && x <= z ? Vector(1, 0, 0) : (y <= z ? Vector(0, 1, 0) : Vector(0, 0, 1));
    return unit(axis - (axis * v) * v);
  }

  // The normal after the least rotation from tangent t to tangent u.
  static Vector carried(const Vector& normal, const Vector& t, const Vector& u)
  {
    const double cosine_plus_one = 1 + t * u;
    if(cosine_plus_one < reversal)
      return normal;
    const Vector turned = normal - (normal * u) / cosine_plus_one * (t + u);
    return unit(turned - (turned * u) * u);
  }

  void add_ring(std::size_t i, const Vector& normal)
  {
    const Vector binormal = cross_product(m_tangents[i], normal);
    for(std::size_t j = 0; j < m_sides; ++j) {
      const Vector arm = m_radius * (std::cos(angle(j)) * normal + std::sin(angle(j)) * binormal);
      m_points.push_back({m_line[i][0] + arm.x(), m_line[i][1] + arm.y(), m_line[i][2] + arm.z()});
    }
  }

  double angle(std::size_t j) const { return two_pi * static_cast<double>(j) / static_cast<double>(m_sides); }

  // The number of corners by which the last normal, transported to the first point, is rotated relative to the first.
  std::size_t turn_to(const Vector& first_normal, const Vector& last_normal) const
  {
    const Vector& tangent = m_tangents.front();
    const Vector normal = carried(last_normal, m_tangents.back(), tangent);
    const double turn = std::atan2(normal * cross_product(tangent, first_normal), normal * first_normal);
    return static_cast<std::size_t>(std::lround((turn + two_pi) / angle(1))) % m_sides;
  }

  // Joins rings given by their first corners; corner j of one meets corner j + turn of the other.
  void join(std::size_t ring, std::size_t next_ring, std::size_t turn)
  {
    for(std::size_t j = 0; j < m_sides; ++j) {
      const std::size_t k = (j + 1) % m_sides;
      const std::size_t a = ring + j, b = ring + k;
      const std::size_t c = next_ring + (j + turn) % m_sides, d = next_ring + (k + turn) % m_sides;
      m_triangles.push_back({a, b, d});
      m_triangles.push_back({a, d, c});
    }
  }

  void add_caps()
  {
    const std::size_t start = m_points.size(), end = start + 1, last_ring = m_points.size() - m_sides;
    m_points.push_back(m_line.front());
    m_points.push_back(m_line.back());
    for(std::size_t j = 0; j < m_sides; ++j) {
      const std::size_t k = (j + 1) % m_sides;
      m_triangles.push_back({start, k, j});
      m_triangles.push_back({end, last_ring + j, last_ring + k});
    }
  }

  double m_radius;
  std::size_t m_sides;
  bool m_is_closed = false;
  std::vector<Figure_point> m_line;
  std::vector<Vector> m_tangents;
  std::vector<Figure_point> m_points;
  std::vector<Figure_triangle> m_triangles;
};

/* Writes the bytes of a number, the lowest first, independently of the machine's byte order. */
template <class Number>
void write_bytes(std::ostream& out, Number x)
{
  static_assert(std::is_integral<Number>::value || std::numeric_limits<Number>::is_iec559,
                "floating-point numbers must conform to IEEE 754");
  using Wide = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  using Bits = std::conditional_t<sizeof(Number) == 1, std::uint8_t, Wide>;
  static_assert(sizeof(Bits) == sizeof(Number), "numbers must have 8, 32 or 64 bits");
  Bits bits;
  std::memcpy(&bits, &x, sizeof bits);
  char bytes[sizeof bits];
  for(std::size_t i = 0; i < sizeof bits; ++i)
    bytes[i] = static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
  out.write(bytes, sizeof bytes);
}

/* Writes numbers as text, each followed by a separator, or as bytes. */
class Number_writer
{
public:
  Number_writer(std::ostream& out, bool is_binary)
    : m_out(&out)
    , m_is_binary(is_binary)
  {
  }

  template <class Number>
  void operator()(Number x, const char* after) const
  {
    if(m_is_binary)
      write_bytes(*m_out, x);
    else
      *m_out << +x << after; // promoted, since a number of one byte is not a character
  }

private:
  std::ostream* m_out;
  bool m_is_binary;
};

template <class T>
constexpr bool is_texture = false;
template <class CornerMap>
constexpr bool is_texture<IO::Texture<CornerMap>> = true;

template <class T>
constexpr bool is_vertex_values = false;
template <class VertexMap>
constexpr bool is_vertex_values<IO::Vertex_values<VertexMap>> = true;

template <class T, class = void>
constexpr bool has_coordinates = false;
template <class T>
constexpr bool has_coordinates<T, std::void_t<decltype(CGAL::to_double(std::declval<const T&>().x())),
                                              decltype(CGAL::to_double(std::declval<const T&>().z()))>> = true;

template <class T, class = void>
constexpr bool is_range_of_points = false;
template <class T>
constexpr bool is_range_of_points<T, std::void_t<Range_value<T>>> = has_coordinates<Range_value<T>>;

template <class T, class = void>
constexpr bool is_range_of_polylines = false;
template <class T>
constexpr bool is_range_of_polylines<T, std::void_t<Range_value<T>>> =
    !has_coordinates<Range_value<T>> && is_range_of_points<Range_value<T>>;

template <class Point>
Figure_point figure_point(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

/* The range is evaluated again whenever the points are requested. */
template <class MakeRange>
Shape shape_of_points(Shape::Kind kind, const MakeRange& range)
{
  Shape shape;
  shape.kind = kind;
  decltype(auto) points = range();
  shape.number_of_points = static_cast<std::size_t>(std::distance(std::begin(points), std::end(points)));
  shape.for_each_point = [range](const Sink<Figure_point>& sink) {
    decltype(auto) points = range();
    for(const auto& p : points)
      sink(figure_point(p));
  };
  return shape;
}

/* Uses the mesh's own point property map only if no map is given. */
template <class FaceGraph, class NamedParameters>
auto given_or_own_points(const FaceGraph& mesh, const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value) {
    static_assert(graph_has_property<FaceGraph, boost::vertex_point_t>::value,
                  "the mesh has no vertex point property: pass vertex_point_map()");
    return get_const_property_map(CGAL::vertex_point, mesh);
  } else {
    return parameters::get_parameter(np, internal_np::vertex_point);
  }
}

/* \throws Invalid_mesh_error if a face is not a triangle, or elements of a `Surface_mesh` have been removed */
template <class FaceGraph, class NamedParameters>
Shape surface_shape(const FaceGraph& mesh, const NamedParameters& np)
{
  const auto numbers = std::make_shared<const Indexed_mesh<FaceGraph>>(mesh);
  Shape shape;
  shape.kind = Shape::Kind::TRIANGLES;
  shape.number_of_points = static_cast<std::size_t>(numbers->number_of_vertices());
  for(const auto& f : faces(mesh)) {
    check_triangle(*numbers, numbers->index(graph_halfedge(f, mesh)));
    ++shape.number_of_triangles;
  }
  shape.for_each_point = [&mesh, points = given_or_own_points(mesh, np)](const Sink<Figure_point>& sink) {
    for(const auto& v : vertices(mesh))
      sink(figure_point(get(points, v)));
  };
  shape.for_each_triangle = [&mesh, numbers](const Sink<Figure_triangle>& sink) {
    for(const auto& f : faces(mesh)) {
      Figure_triangle corners;
      auto h = graph_halfedge(f, mesh);
      for(std::size_t& corner : corners) {
        corner = static_cast<std::size_t>(numbers->index(target(h, mesh)).idx());
        h = graph_next(h, mesh);
      }
      sink(corners);
    }
  };
  return shape;
}

/* Adds the texture coordinates of its faces' corners to a surface. */
template <class FaceGraph, class CornerMap>
void add_texture(Shape& shape, const FaceGraph& mesh, const IO::Texture<CornerMap>& texture)
{
  shape.for_each_texture = [&mesh, map = texture.map](const Sink<Texture_corners>& sink) {
    for(const auto& f : faces(mesh)) {
      Texture_corners corners;
      auto h = graph_halfedge(f, mesh);
      for(auto& corner : corners) {
        const auto t = get(map, h);
        corner = {CGAL::to_double(t[0]), CGAL::to_double(t[1])};
        h = graph_next(h, mesh);
      }
      sink(corners);
    }
  };
}

/* The number of components of a value: those of an array or a vector, or the value itself. */
template <class Value>
constexpr std::size_t number_of_components = has_coordinates<Value> ? 3 : 1;
template <class Number, std::size_t N>
constexpr std::size_t number_of_components<std::array<Number, N>> = N;

template <class Number, std::size_t N>
void write_components(const std::array<Number, N>& value, const Sink<double>& sink)
{
  for(const Number& x : value)
    sink(CGAL::to_double(x));
}

template <class Value>
void write_components(const Value& value, const Sink<double>& sink)
{
  if constexpr(has_coordinates<Value>)
    write_components(figure_point(value), sink);
  else
    sink(CGAL::to_double(value));
}

/* Adds values of one kind to a surface, unless they belong to another mesh. Other parts add nothing. */
template <class FaceGraph, class Part>
void add_values([[maybe_unused]] Shape& shape, [[maybe_unused]] const FaceGraph& mesh, const Part&)
{
}

template <class FaceGraph, class VertexMap>
void add_values(Shape& shape, const FaceGraph& mesh, const IO::Vertex_values<VertexMap>& values)
{
  shape.values.emplace_back();
  if constexpr(std::is_same<typename boost::property_traits<VertexMap>::key_type,
                            typename boost::graph_traits<FaceGraph>::vertex_descriptor>::value)
    shape.values.back() = [&mesh, map = values.map](const Sink<double>& sink) {
      for(const auto& v : vertices(mesh))
        write_components(get(map, v), sink);
    };
}

/* A zero-length line is left unchanged. */
inline Shape tube_shape(const Shape& line, const IO::Tubes& tubes)
{
  check_finite(line);
  std::vector<Figure_point> polyline;
  line.for_each_point([&](const Figure_point& p) { polyline.push_back(p); });
  const auto tube = std::make_shared<const Tube>(polyline, tubes);
  if(tube->triangles().empty())
    return line;
  Shape shape;
  shape.kind = Shape::Kind::TRIANGLES;
  shape.curve = line.curve;
  shape.number_of_points = tube->points().size();
  shape.number_of_triangles = tube->triangles().size();
  shape.for_each_point = [tube](const Sink<Figure_point>& sink) {
    for(const Figure_point& p : tube->points())
      sink(p);
  };
  shape.for_each_triangle = [tube](const Sink<Figure_triangle>& sink) {
    for(const Figure_triangle& t : tube->triangles())
      sink(t);
  };
  return shape;
}

/* Converts the arguments of a writer, one after the other, into shapes. Curves are counted over all ranges of them. */
class Figure_builder
{
public:
  template <class Part, class NamedParameters, class Texture, class... Parts>
  void add(const Part& part, const NamedParameters& np, const Texture& texture, const Parts&... parts)
  {
    if constexpr(is_range_of_points<Part>)
      m_figure.add(shape_of_points(Shape::Kind::POINTS, [&part]() -> decltype(auto) { return (part); }));
    else if constexpr(is_range_of_polylines<Part>)
      add_curves(part);
    else if constexpr(has_faces<Part>) {
      Shape shape = surface_shape(part, np);
      if constexpr(is_texture<Texture>) {
        add_texture(shape, part, texture);
        m_figure.set_picture(texture.picture);
      }
      (add_values(shape, part, parts), ...);
      m_figure.add(std::move(shape));
    } else
      static_assert(std::is_same<Part, IO::Tubes>::value || std::is_same<Part, IO::Colors>::value || is_texture<Part> ||
                        is_vertex_values<Part> || is_named_parameters<Part>,
                    "an argument to be written must be a face graph, a range of points or a range of polylines");
  }

  /* Records parameters that apply to all parts. */
  template <class Part>
  void look_at(const Part& part)
  {
    if constexpr(std::is_same<Part, IO::Tubes>::value)
      m_tubes = &part;
    if constexpr(std::is_same<Part, IO::Colors>::value)
      m_figure.set_colors(part);
    if constexpr(is_vertex_values<Part>)
      m_figure.add_value_kind(
          {part.name, number_of_components<typename boost::property_traits<decltype(part.map)>::value_type>});
  }

  Figure& figure() { return m_figure; }

private:
  // A curve of one point becomes a point.
  template <class Polylines>
  void add_curves(const Polylines& polylines)
  {
    for(auto it = std::begin(polylines); it != std::end(polylines); ++it, ++m_curve) {
      Shape line = shape_of_points(Shape::Kind::LINE, [it]() -> decltype(auto) { return *it; });
      if(line.number_of_points == 1)
        line.kind = Shape::Kind::POINTS;
      line.curve = m_curve;
      m_figure.add(m_tubes == nullptr ? std::move(line) : tube_shape(line, *m_tubes));
    }
  }

  const IO::Tubes* m_tubes = nullptr;
  std::int64_t m_curve = 0;
  Figure m_figure;
};

/* Returns the named parameters, which are the last argument if given. */
template <class... Parts>
decltype(auto) named_parameters_of(const Parts&... parts)
{
  constexpr std::size_t count = (std::size_t(0) + ... + (is_named_parameters<Parts> ? 1 : 0));
  static_assert(sizeof...(Parts) > count, "there is nothing to write: pass a face graph, points or polylines");
  using Last = std::tuple_element_t<sizeof...(Parts) - 1, std::tuple<Parts...>>;
  static_assert(count == (is_named_parameters<Last> ? 1 : 0), "the named parameters must be the last argument");
  if constexpr(count == 0)
    return parameters::default_values();
  else
    return std::get<sizeof...(Parts) - 1>(std::tie(parts...));
}

struct No_texture
{
};

/* Returns the texture among the parts. */
inline No_texture texture_of() { return {}; }

template <class Part, class... Parts>
decltype(auto) texture_of(const Part& part, const Parts&... parts)
{
  if constexpr(is_texture<Part>)
    return (part);
  else
    return texture_of(parts...);
}

template <class NamedParameters, class... Parts>
Figure figure_of_parts(const NamedParameters& np, const Parts&... parts)
{
  Figure_builder builder;
  (builder.look_at(parts), ...);
  const auto& texture = texture_of(parts...);
  (builder.add(parts, np, texture, parts...), ...);
  return std::move(builder.figure());
}

/* The representation of numbers. */
struct Number_format
{
  int precision = std::numeric_limits<double>::max_digits10; // sufficient to restore doubles
  bool is_binary = true;
};

/* Writes by `write(plain)`, where the stream shares the buffer of `out` but has default settings and the classic
 * locale. The message of an exception begins with `start`. */
template <class Write>
void write_plainly(std::ostream& out, int precision, const Write& write, const std::string& start = "the output ")
{
  std::ostream plain(nullptr);
  plain.imbue(std::locale::classic()); // before it has a buffer, whose locale would change as well
  plain.precision(precision);
  plain.rdbuf(out.rdbuf());
  if(out)
    write(plain);
  if(out && plain.flush())
    return;
  out.setstate(std::ios::badbit);
  throw File_write_error(start + "could not be written completely; check the stream or the free space on the disk");
}

template <class Writer>
void write_to(std::ostream& out, const Writer& writer, const Number_format& format)
{
  write_plainly(out, format.precision, [&](std::ostream& plain) { writer.write(plain); });
}

template <class Writer>
void write_to(const std::string& name, const Writer& writer, const Number_format& format)
{
  std::ofstream out(name, std::ios::binary);
  if(!out)
    throw File_write_error(name + ": cannot be written; choose another path");
  const auto write = [&](std::ostream& plain) { writer.write(plain); };
  write_plainly(out, format.precision, write, name + ": ");
  out.close();
  if(!out)
    throw File_write_error(name + ": could not be written completely; check the free space on the disk");
}

/*
 * Writes by a `Writer` constructed from a figure and a format. Its constructor throws if the figure cannot be written,
 * so that no file is touched in that case.
 */
template <class Writer, class Destination, class... Parts>
void write_parts(Destination& destination, const Parts&... parts)
{
  constexpr bool is_destination =
      std::is_convertible<Destination&, std::ostream&>::value || std::is_convertible<Destination&, std::string>::value;
  static_assert(is_destination, "the first argument is neither a stream nor the name of a file");
  const auto& np = named_parameters_of(parts...);
  Number_format format;
  format.precision =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::stream_precision), format.precision);
  format.is_binary = parameters::choose_parameter(parameters::get_parameter(np, internal_np::use_binary_mode), true);
  const Figure figure = figure_of_parts(np, parts...);
  if constexpr(is_destination) // avoids another error message
    write_to(destination, Writer(figure, format), format);
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_IO_FIGURE_H
