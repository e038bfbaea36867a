// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_IO_FIGURE_OF_PARTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_IO_FIGURE_OF_PARTS_H

#include <CGAL/Flip_geodesics/IO/appearance.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/io/Figure.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
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

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class T>
struct Is_texture : std::false_type
{
};

template <class CornerMap>
struct Is_texture<IO::Texture<CornerMap>> : std::true_type
{
};

template <class T>
struct Is_vertex_values : std::false_type
{
};

template <class VertexMap>
struct Is_vertex_values<IO::Vertex_values<VertexMap>> : std::true_type
{
};

template <class T, class = void>
struct Has_coordinates : std::false_type
{
};

template <class T>
struct Has_coordinates<T, std::void_t<decltype(CGAL::to_double(std::declval<const T&>().x())),
                                      decltype(CGAL::to_double(std::declval<const T&>().z()))>> : std::true_type
{
};

template <class T, class = void>
struct Is_range_of_points : std::false_type
{
};

template <class T>
struct Is_range_of_points<T, std::void_t<Range_value<T>>> : Has_coordinates<Range_value<T>>
{
};

template <class T, class = void>
struct Is_range_of_polylines : std::false_type
{
};

template <class T>
struct Is_range_of_polylines<T, std::void_t<Range_value<T>>>
  : std::conjunction<std::negation<Has_coordinates<Range_value<T>>>, Is_range_of_points<Range_value<T>>>
{
};

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
                  "the mesh has no points of its own: give vertex_point_map()");
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

/* The number of components of a value, and the components: those of an array or a vector, or the value itself. */
template <class Value, class = void>
struct Numbers_of_value
{
  static constexpr std::size_t size = 1;
  static void write(const Value& value, const Sink<double>& sink) { sink(CGAL::to_double(value)); }
};

template <class Number, std::size_t N>
struct Numbers_of_value<std::array<Number, N>>
{
  static constexpr std::size_t size = N;
  static void write(const std::array<Number, N>& value, const Sink<double>& sink)
  {
    for(const Number& x : value)
      sink(CGAL::to_double(x));
  }
};

template <class Value>
struct Numbers_of_value<Value, std::enable_if_t<Has_coordinates<Value>::value>> : Numbers_of_value<Figure_point>
{
  static void write(const Value& value, const Sink<double>& sink)
  {
    Numbers_of_value<Figure_point>::write(figure_point(value), sink);
  }
};

template <class VertexMap>
using Numbers_of_map = Numbers_of_value<typename boost::property_traits<VertexMap>::value_type>;

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
        Numbers_of_map<VertexMap>::write(get(map, v), sink);
    };
}

/* A line of length zero is left unchanged. */
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
    if constexpr(Is_range_of_points<Part>::value)
      m_figure.add(shape_of_points(Shape::Kind::POINTS, [&part]() -> decltype(auto) { return (part); }));
    else if constexpr(Is_range_of_polylines<Part>::value)
      add_curves(part);
    else if constexpr(has_faces<Part>) {
      Shape shape = surface_shape(part, np);
      if constexpr(Is_texture<Texture>::value) {
        add_texture(shape, part, texture);
        m_figure.set_picture(texture.picture);
      }
      (add_values(shape, part, parts), ...);
      m_figure.add(std::move(shape));
    } else
      static_assert(std::is_same<Part, IO::Tubes>::value || std::is_same<Part, IO::Colors>::value ||
                        Is_texture<Part>::value || Is_vertex_values<Part>::value || is_named_parameters<Part>,
                    "what is written is a face graph, a range of points or a range of polylines");
  }

  /* Records parameters that apply to all parts. */
  template <class Part>
  void look_at(const Part& part)
  {
    if constexpr(std::is_same<Part, IO::Tubes>::value)
      m_tubes = &part;
    if constexpr(std::is_same<Part, IO::Colors>::value)
      m_figure.set_colors(part);
    if constexpr(Is_vertex_values<Part>::value)
      m_figure.add_value_kind({part.name, Numbers_of_map<decltype(part.map)>::size});
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
  static_assert(sizeof...(Parts) > count, "what is written is missing: a face graph, points or polylines");
  using Last = std::tuple_element_t<sizeof...(Parts) - 1, std::tuple<Parts...>>;
  static_assert(count == (is_named_parameters<Last> ? 1 : 0), "named parameters come last");
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
  if constexpr(Is_texture<Part>::value)
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
 * locale. */
template <class Write>
void write_plainly(std::ostream& out, int precision, const Write& write)
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
  throw File_write_error("the file could not be written to its end; look for space on the disk");
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
    throw File_write_error(name + ": cannot be written; choose another place");
  write_to(out, writer, format);
  out.close();
  if(!out)
    throw File_write_error(name + ": could not be written to its end; look for space on the disk");
}

/*
 * Writes by a `Writer` constructed from a figure and a format. Its constructor throws if the figure cannot be written,
 * so that no file is touched in that case.
 */
template <class Writer, class Destination, class... Parts>
void write_parts(Destination& destination, const Parts&... parts)
{
  const auto& np = named_parameters_of(parts...);
  Number_format format;
  format.precision =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::stream_precision), format.precision);
  format.is_binary = parameters::choose_parameter(parameters::get_parameter(np, internal_np::use_binary_mode), true);
  const Figure figure = figure_of_parts(np, parts...);
  write_to(destination, Writer(figure, format), format);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_IO_FIGURE_OF_PARTS_H
