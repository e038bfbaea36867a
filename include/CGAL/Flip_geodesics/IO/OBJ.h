// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_IO_OBJ_H
#define CGAL_FLIP_GEODESICS_IO_OBJ_H

#include <CGAL/Flip_geodesics/internal/io/Figure.h>
#include <CGAL/Flip_geodesics/internal/io/write_parts.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace Flip_geodesics {
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
    m_figure.for_each_point([&](const Figure_point& p) { out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n'; });
    std::size_t first = 1;
    for(const Shape& shape : m_figure.shapes()) {
      out << "o " << shape.name() << '\n';
      write_elements(out, shape, first);
      first += shape.number_of_points;
    }
  }

private:
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
 * Writes surfaces, curves and points in the OBJ format, as text: an object `surface`, an object `curve_N` for each
 * curve, with one element `l`, and an object `points`. All vertices come first, in the order of what is written. A
 * curve of one point is an element `p`. `CGAL::IO::read_OBJ()` does not know the element `l`: it reads surfaces, tubes
 * and points.
 *
 * \param parts as for `write_VTP()`; of the named parameters, `use_binary_mode` is not looked at
 *
 * \throws File_write_error, Invalid_coordinate_error, Invalid_mesh_error as `write_VTP()`
 */
template <class... Parts>
void write_OBJ(std::ostream& out, const Parts&... parts)
{
  internal::write_parts<internal::Obj_writer>(out, parts...);
}

/// \ingroup PkgFlipGeodesicsIO
/// Writes a file in the OBJ format. Another one of that name is replaced.
template <class... Parts>
void write_OBJ(const std::string& file, const Parts&... parts)
{
  internal::write_parts<internal::Obj_writer>(file, parts...);
}

} // namespace IO
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_IO_OBJ_H
