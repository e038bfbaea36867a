// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_IO_PLY_H
#define CGAL_FLIP_GEODESICS_IO_PLY_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/io/Figure.h>
#include <CGAL/Flip_geodesics/internal/io/figure_of_parts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>

namespace CGAL {
namespace Flip_geodesics {
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
      throw File_write_error("PLY has numbers for " + std::to_string(most) + " points, and there are " +
                             std::to_string(figure.number_of_points()));
    check_writable(figure);
  }

  void write(std::ostream& out) const
  {
    write_header(out);
    const Number_writer number(out, m_is_binary);
    m_figure.for_each_point([&](const Figure_point& p) {
      number(p[0], " ");
      number(p[1], " ");
      number(p[2], "\n");
    });
    m_figure.for_each_shape(Shape::Kind::TRIANGLES,
                            [&](const Shape& shape, std::size_t first) { write_faces(number, shape, first); });
    m_figure.for_each_shape(Shape::Kind::LINE,
                            [&](const Shape& shape, std::size_t first) { write_edges(number, shape, first); });
  }

private:
  static bool is_tube(const Shape& shape)
  {
    return shape.kind == Shape::Kind::TRIANGLES && shape.curve != Shape::no_curve;
  }

  void write_header(std::ostream& out) const
  {
    std::size_t edges = 0;
    m_figure.for_each_shape(Shape::Kind::LINE,
                            [&](const Shape& shape, std::size_t) { edges += shape.number_of_points - 1; });
    out << "ply\nformat " << (m_is_binary ? "binary_little_endian" : "ascii") << " 1.0\nelement vertex "
        << m_figure.number_of_points() << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
        << m_figure.number_of_triangles() << "\nproperty list uchar int vertex_indices\n"
        << (m_has_tubes ? "property int curve\n" : "") << "element edge " << edges
        << "\nproperty int vertex1\nproperty int vertex2\nproperty int curve\nend_header\n";
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

  static void write_edges(const Number_writer& number, const Shape& shape, std::size_t first)
  {
    for(std::size_t i = 1; i < shape.number_of_points; ++i) {
      number(static_cast<std::int32_t>(first + i - 1), " ");
      number(static_cast<std::int32_t>(first + i), " ");
      number(static_cast<std::int32_t>(shape.curve), "\n");
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
 * Writes surfaces, curves and points in the PLY format: elements `vertex`, `face` and `edge`, where edges have the
 * number of their curve as property `curve`. If there are tubes, so have faces, and those of a surface have -1.
 *
 * \param parts as for `write_VTP()`
 *
 * \throws File_write_error also if there are more than 2147483647 points, and as `write_VTP()`
 * \throws Invalid_coordinate_error, Invalid_mesh_error as `write_VTP()`
 */
template <class... Parts>
void write_PLY(std::ostream& out, const Parts&... parts)
{
  internal::write_parts<internal::Ply_writer>(out, parts...);
}

/// \ingroup PkgFlipGeodesicsIO
/// Writes a file in the PLY format. Another one of that name is replaced.
template <class... Parts>
void write_PLY(const std::string& file, const Parts&... parts)
{
  internal::write_parts<internal::Ply_writer>(file, parts...);
}

} // namespace IO
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_IO_PLY_H
