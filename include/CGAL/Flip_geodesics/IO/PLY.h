// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_IO_PLY_H
#define CGAL_FLIP_GEODESICS_IO_PLY_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/io/Figure.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Flip_geodesics {
namespace internal {

class Ply_writer
{
public:
  Ply_writer(const Figure& figure, const Number_format& format)
    : m_figure(figure)
    , m_is_binary(format.is_binary)
    , m_has_tubes(std::any_of(figure.shapes().begin(), figure.shapes().end(), is_tube))
  {
    constexpr std::size_t most = (std::numeric_limits<std::int32_t>::max)();
    if(figure.number_of_points() > most || figure.shapes().size() > most)
      throw File_write_error("a PLY file can number at most " + std::to_string(most) +
                             " points and as many curves and other parts, but " +
                             std::to_string(figure.number_of_points()) + " points and " +
                             std::to_string(figure.shapes().size()) + " curves and other parts were given");
    check_writable(figure);
    check_values(figure, m_is_binary);
    for(const Value_kind& kind : figure.value_kinds())
      if(is_taken(kind.name))
        throw Invalid_parameter_error(
            "the name \"" + kind.name +
            "\" of vertex values is reserved for a coordinate or a color; choose another name");
  }

  void write(std::ostream& out) const
  {
    write_header(out);
    const Number_writer number(out, m_is_binary);
    write_vertices(number);
    m_figure.for_each_shape(Shape::Kind::TRIANGLES,
                            [&](const Shape& shape, std::size_t first) { write_faces(number, shape, first); });
    m_figure.for_each_shape(Shape::Kind::LINE,
                            [&](const Shape& shape, std::size_t first) { write_edges(number, shape, first); });
  }

private:
  bool is_taken(const std::string& name) const
  {
    return name == "x" || name == "y" || name == "z" ||
           (m_figure.colors() != nullptr && (name == "red" || name == "green" || name == "blue"));
  }

  static bool is_tube(const Shape& shape)
  {
    return shape.kind == Shape::Kind::TRIANGLES && shape.curve != Shape::no_curve;
  }

  // Vectors have a property for each coordinate.
  static std::vector<std::string> property_names(const Value_kind& kind)
  {
    constexpr std::array<const char*, 3> axes = {"_x", "_y", "_z"};
    std::vector<std::string> result;
    for(std::size_t k = 0; k < kind.components; ++k)
      result.push_back(kind.name + (kind.components == axes.size() ? axes[k] : '_' + std::to_string(k)));
    return kind.components == 1 ? std::vector<std::string>{kind.name} : result;
  }

  // The values of all kinds are kept while they are written, since a line contains those of one vertex.
  void write_vertices(const Number_writer& number) const
  {
    const std::vector<Value_kind>& kinds = m_figure.value_kinds();
    std::vector<std::vector<double>> values(kinds.size());
    for(std::size_t i = 0; i < kinds.size(); ++i)
      m_figure.for_each_value(i, [&](double x) { values[i].push_back(x); });
    std::size_t vertex = 0;
    const bool has_colors = m_figure.colors() != nullptr;
    for(const Shape& shape : m_figure.shapes())
      shape.for_each_point([&](const Figure_point& p) {
        number(p[0], " ");
        number(p[1], " ");
        number(p[2], kinds.empty() && !has_colors ? "\n" : " ");
        for(std::size_t i = 0; i < kinds.size(); ++i)
          for(std::size_t k = 0; k < kinds[i].components; ++k)
            number(values[i][kinds[i].components * vertex + k],
                   has_colors || i + 1 < kinds.size() || k + 1 < kinds[i].components ? " " : "\n");
        if(has_colors)
          write_color(number, shape);
        ++vertex;
      });
  }

  static void write_color(const Number_writer& number, const Shape& shape)
  {
    const std::array<std::uint8_t, 3> color = material_of(shape).bytes();
    number(color[0], " ");
    number(color[1], " ");
    number(color[2], "\n");
  }

  void write_header(std::ostream& out) const
  {
    std::size_t edges = 0;
    m_figure.for_each_shape(Shape::Kind::LINE,
                            [&](const Shape& shape, std::size_t) { edges += shape.number_of_points - 1; });
    out << "ply\nformat " << (m_is_binary ? "binary_little_endian" : "ascii") << " 1.0\nelement vertex "
        << m_figure.number_of_points() << "\nproperty double x\nproperty double y\nproperty double z\n";
    for(const Value_kind& kind : m_figure.value_kinds())
      for(const std::string& name : property_names(kind))
        out << "property double " << name << '\n';
    const char* const colors =
        m_figure.colors() != nullptr ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "";
    out << colors << "element face " << m_figure.number_of_triangles() << "\nproperty list uchar int vertex_indices\n"
        << (m_has_tubes ? "property int curve\n" : "") << "element edge " << edges
        << "\nproperty int vertex1\nproperty int vertex2\nproperty int curve\n"
        << colors << "end_header\n";
  }

  void write_faces(const Number_writer& number, const Shape& shape, std::size_t first) const
  {
    shape.for_each_triangle([&](const Figure_triangle& t) {
      number(std::uint8_t(3), " ");
      number(static_cast<std::int32_t>(first + t[0]), " ");
      number(static_cast<std::int32_t>(first + t[1]), " ");
      number(static_cast<std::int32_t>(first + t[2]), m_has_tubes ? " " : "\n");
      if(m_has_tubes)
        number(static_cast<std::int32_t>(shape.curve), "\n");
    });
  }

  void write_edges(const Number_writer& number, const Shape& shape, std::size_t first) const
  {
    const bool has_colors = m_figure.colors() != nullptr;
    for(std::size_t i = 1; i < shape.number_of_points; ++i) {
      number(static_cast<std::int32_t>(first + i - 1), " ");
      number(static_cast<std::int32_t>(first + i), " ");
      number(static_cast<std::int32_t>(shape.curve), has_colors ? " " : "\n");
      if(has_colors)
        write_color(number, shape);
    }
  }

  const Figure& m_figure;
  bool m_is_binary, m_has_tubes;
};

} // namespace internal

namespace IO {

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Writes surfaces, curves and points in the PLY format, with elements `vertex`, `face` and `edge`.
 *
 * The property `curve` of an edge is the number of its curve. If the data contain tubes, faces also have the property
 * `curve`, whose value is -1 for faces of a surface. Values at vertices are written as properties of the vertices under
 * the given names. A vector has three properties, whose names end in `_x`, `_y` and `_z`, and an array has one property
 * for each of its entries. MeshLab colors a surface by the property `quality`. With `IO::Colors`, vertices and edges
 * have colors.
 *
 * \param destination a stream, or the name of a file, which is replaced if it exists
 * \param parts the data, as for `write_VTP()`
 *
 * \throws File_write_error as `write_VTP()` does, or if the data have more than 2147483647 points
 * \throws Invalid_coordinate_error as `write_VTP()` does
 * \throws Invalid_mesh_error as `write_VTP()` does
 * \throws Invalid_parameter_error as `write_VTP()` does, or if a set of values has the name of a coordinate or, with
 *         `IO::Colors`, of a color
 */
template <class Destination, class... Parts>
void write_PLY(Destination&& destination, const Parts&... parts)
{
  internal::write_parts<internal::Ply_writer>(destination, parts...);
}

} // namespace IO
} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_IO_PLY_H
