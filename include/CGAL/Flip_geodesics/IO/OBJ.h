// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_IO_OBJ_H
#define CGAL_FLIP_GEODESICS_IO_OBJ_H

#include <CGAL/Flip_geodesics/internal/io/Figure.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <ostream>
#include <vector>

namespace CGAL::Flip_geodesics {
namespace internal {

class Obj_writer
{
public:
  Obj_writer(const Figure& figure, const Number_format&)
    : m_figure(figure)
  {
    check_writable(figure);
  }

  void write(std::ostream& out) const
  {
    const bool has_materials = m_figure.colors() != nullptr && !m_figure.colors()->material_library().empty();
    if(has_materials)
      out << "mtllib " << m_figure.colors()->material_library() << '\n';
    m_figure.for_each_point([&](const Figure_point& p) { out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n'; });
    Texture_numbers numbers;
    for(const Shape& shape : m_figure.shapes())
      write_texture(out, shape, numbers);
    std::size_t first = 1;
    for(const Shape& shape : m_figure.shapes()) {
      out << "o " << shape.name() << '\n';
      if(has_materials)
        out << "usemtl " << material_of(shape).name << '\n';
      if(shape.for_each_texture)
        write_textured(out, shape, first, numbers);
      else
        write_elements(out, shape, first);
      first += shape.number_of_points;
    }
  }

private:
  // The numbers of texture coordinates in the file.
  using Texture_numbers = std::map<std::array<double, 2>, std::size_t>;

  // Writes a line for each pair of texture coordinates that has no number yet.
  static void write_texture(std::ostream& out, const Shape& shape, Texture_numbers& numbers)
  {
    if(shape.for_each_texture)
      shape.for_each_texture([&](const Texture_corners& corners) {
        if(is_textured(corners))
          for(const std::array<double, 2>& corner : corners)
            if(numbers.emplace(corner, numbers.size() + 1).second)
              out << "vt " << corner[0] << ' ' << corner[1] << '\n';
      });
  }

  static void write_textured(std::ostream& out, const Shape& shape, std::size_t first, const Texture_numbers& numbers)
  {
    std::vector<std::array<std::size_t, 3>> textures; // 0 without
    shape.for_each_texture([&](const Texture_corners& corners) {
      textures.push_back({});
      if(is_textured(corners))
        for(std::size_t i = 0; i < 3; ++i)
          textures.back()[i] = numbers.at(corners[i]);
    });
    std::size_t number = 0;
    shape.for_each_triangle([&](const Figure_triangle& t) {
      out << 'f';
      for(std::size_t i = 0; i < 3; ++i) {
        out << ' ' << t[i] + first;
        if(textures[number][i] != 0)
          out << '/' << textures[number][i];
      }
      out << '\n';
      ++number;
    });
  }

  static void write_elements(std::ostream& out, const Shape& shape, std::size_t first)
  {
    switch(shape.kind) {
    case Shape::Kind::TRIANGLES:
      shape.for_each_triangle([&](const Figure_triangle& t) {
        out << "f " << t[0] + first << ' ' << t[1] + first << ' ' << t[2] + first << '\n';
      });
      return;
    case Shape::Kind::LINE:
      out << 'l';
      for(std::size_t i = 0; i < shape.number_of_points; ++i)
        out << ' ' << first + i;
      out << '\n';
      return;
    case Shape::Kind::POINTS:
      for(std::size_t i = 0; i < shape.number_of_points; ++i)
        out << "p " << first + i << '\n';
      return;
    }
  }

  const Figure& m_figure;
};

} // namespace internal

namespace IO {

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Writes surfaces, curves and points in the OBJ format, as text.
 *
 * The file has an object `surface`, an object `curve_N` for each curve, and an object `points`. The vertices of all
 * objects come first, in the order of the data. A curve is written as one element `l`, or as one element `p` if it
 * consists of a single point. `CGAL::IO::read_OBJ()` does not support the element `l`, but reads surfaces, tubes and
 * points.
 *
 * With an `IO::Texture`, the corners of textured faces have texture coordinates, `vt`; corners with equal texture
 * coordinates share one line `vt`. If `IO::Colors` names a material library, objects have materials.
 *
 * \param destination a stream, or the name of a file, which is replaced if it exists
 * \param parts the data, as for `write_VTP()`; the named parameter `use_binary_mode` is ignored
 *
 * \throws File_write_error as `write_VTP()` does
 * \throws Invalid_coordinate_error as `write_VTP()` does
 * \throws Invalid_mesh_error as `write_VTP()` does
 */
template <class Destination, class... Parts>
void write_OBJ(Destination&& destination, const Parts&... parts)
{
  internal::write_parts<internal::Obj_writer>(destination, parts...);
}

/// \ingroup PkgFlipGeodesicsIO
/// Writes the material library to which an OBJ file with `Colors` refers.
/// \param out a stream
/// \throws File_write_error if the stream fails
inline void write_MTL(std::ostream& out)
{
  internal::write_plainly(out, std::numeric_limits<double>::digits10, [](std::ostream& plain) {
    for(const internal::Material& material : internal::materials) {
      const std::array<std::uint8_t, 3> color = material.bytes();
      plain << "newmtl " << material.name << "\nKd " << color[0] / 255. << ' ' << color[1] / 255. << ' '
            << color[2] / 255. << '\n';
    }
  });
}

} // namespace IO
} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_IO_OBJ_H
