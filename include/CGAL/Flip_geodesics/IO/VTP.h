// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_IO_VTP_H
#define CGAL_FLIP_GEODESICS_IO_VTP_H

#include <CGAL/Flip_geodesics/internal/io/Figure.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Flip_geodesics {
namespace internal {

/* In binary files, the numbers of all arrays follow the XML, each array preceded by its number of bytes. */
class Vtp_writer
{
public:
  Vtp_writer(const Figure& figure, const Number_format& format)
    : m_figure(figure)
    , m_is_binary(format.is_binary)
  {
    check_writable(figure);
    check_values(figure, m_is_binary);
    for(Shape::Kind kind : {Shape::Kind::POINTS, Shape::Kind::LINE, Shape::Kind::TRIANGLES})
      figure.for_each_shape(kind, [&](const Shape& shape, std::size_t) {
        m_cells[index(kind)] += number_of_cells(shape);
        m_corners[index(kind)] += number_of_corners(shape);
      });
    add_points();
    if(!figure.value_kinds().empty())
      add_values();
    add_curve_numbers();
    if(m_cells[index(Shape::Kind::POINTS)] > 0)
      add_cells("Verts", Shape::Kind::POINTS);
    add_cells("Lines", Shape::Kind::LINE);
    add_cells("Polys", Shape::Kind::TRIANGLES);
  }
  Vtp_writer(const Vtp_writer&) = delete; // arrays refer to their writer
  Vtp_writer& operator=(const Vtp_writer&) = delete;

  void write(std::ostream& out) const
  {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"" << (m_is_binary ? "1.0" : "0.1")
        << "\" byte_order=\"LittleEndian\"" << (m_is_binary ? " header_type=\"UInt64\"" : "")
        << ">\n<PolyData>\n<Piece NumberOfPoints=\"" << m_figure.number_of_points() << "\" NumberOfVerts=\""
        << m_cells[index(Shape::Kind::POINTS)] << "\" NumberOfLines=\"" << m_cells[index(Shape::Kind::LINE)]
        << "\" NumberOfStrips=\"0\" NumberOfPolys=\"" << m_cells[index(Shape::Kind::TRIANGLES)] << "\">\n";
    std::uint64_t offset = 0;
    for(const Group& group : m_groups) {
      out << '<' << group.name << group.attributes << ">\n";
      for(const Array& array : group.arrays)
        write_array(out, array, offset);
      out << "</" << group.name << ">\n";
    }
    out << "</Piece>\n</PolyData>\n";
    if(m_is_binary)
      write_appended(out);
    out << "</VTKFile>\n";
  }

private:
  struct Array
  {
    std::string attributes;
    std::uint64_t size; // in bytes
    std::function<void(const Number_writer&)> write;
  };

  struct Group
  {
    std::string name, attributes;
    std::vector<Array> arrays;
  };

  static constexpr std::uint64_t bytes_of_number = 8; // all but colors are Float64 or Int64

  static std::size_t index(Shape::Kind kind) { return static_cast<std::size_t>(kind); }

  static std::size_t number_of_cells(const Shape& shape)
  {
    switch(shape.kind) {
    case Shape::Kind::TRIANGLES:
      return shape.number_of_triangles;
    case Shape::Kind::LINE:
      return 1;
    case Shape::Kind::POINTS:
      break;
    }
    return shape.number_of_points;
  }

  static std::size_t number_of_corners(const Shape& shape)
  {
    return shape.kind == Shape::Kind::TRIANGLES ? 3 * shape.number_of_triangles : shape.number_of_points;
  }

  void add_points()
  {
    m_groups.push_back({"Points", "", {}});
    m_groups.back().arrays.push_back({"type=\"Float64\" NumberOfComponents=\"3\"",
                                      3 * bytes_of_number * m_figure.number_of_points(),
                                      [this](const Number_writer& number) {
                                        m_figure.for_each_point([&](const Figure_point& p) {
                                          number(p[0], " ");
                                          number(p[1], " ");
                                          number(p[2], "\n");
                                        });
                                      }});
  }

  // The first of these values defines the color.
  void add_values()
  {
    const std::vector<Value_kind>& kinds = m_figure.value_kinds();
    m_groups.push_back({"PointData", " Scalars=\"" + kinds.front().name + '"', {}});
    for(std::size_t i = 0; i < kinds.size(); ++i)
      m_groups.back().arrays.push_back(
          {"type=\"Float64\" Name=\"" + kinds[i].name + "\" NumberOfComponents=\"" +
               std::to_string(kinds[i].components) + '"',
           bytes_of_number * kinds[i].components * m_figure.number_of_points(),
           [this, i](const Number_writer& number) { m_figure.for_each_value(i, [&](double x) { number(x, "\n"); }); }});
  }

  // Cells are counted in this order of their kinds; cells that do not belong to a curve have the number -1.
  void add_curve_numbers()
  {
    m_groups.push_back({"CellData", " Scalars=\"curve\"", {}});
    const std::size_t cells = m_cells[0] + m_cells[1] + m_cells[2];
    m_groups.back().arrays.push_back(
        {"type=\"Int64\" Name=\"curve\"", bytes_of_number * cells, [this](const Number_writer& number) {
           for_each_cell([&](const Shape& shape) { number(shape.curve, "\n"); });
         }});
    if(m_figure.colors() == nullptr)
      return;
    m_groups.back().arrays.push_back(
        {"type=\"UInt8\" Name=\"color\" NumberOfComponents=\"3\"", 3 * cells, [this](const Number_writer& number) {
           for_each_cell([&](const Shape& shape) {
             for(const std::uint8_t component : material_of(shape).bytes())
               number(component, "\n");
           });
         }});
  }

  template <class Function>
  void for_each_cell(const Function& function) const
  {
    for(Shape::Kind kind : {Shape::Kind::POINTS, Shape::Kind::LINE, Shape::Kind::TRIANGLES})
      m_figure.for_each_shape(kind, [&](const Shape& shape, std::size_t) {
        for(std::size_t i = 0; i < number_of_cells(shape); ++i)
          function(shape);
      });
  }

  // Adds the corners of all cells of a kind, and the end of each cell.
  void add_cells(const char* name, Shape::Kind kind)
  {
    m_groups.push_back({name, "", {}});
    m_groups.back().arrays.push_back({"type=\"Int64\" Name=\"connectivity\"", bytes_of_number * m_corners[index(kind)],
                                      [this, kind](const Number_writer& number) {
                                        m_figure.for_each_shape(kind, [&](const Shape& shape, std::size_t first) {
                                          write_corners(number, shape, static_cast<std::int64_t>(first));
                                        });
                                      }});
    m_groups.back().arrays.push_back({"type=\"Int64\" Name=\"offsets\"", bytes_of_number * m_cells[index(kind)],
                                      [this, kind](const Number_writer& number) {
                                        std::int64_t end = 0;
                                        m_figure.for_each_shape(kind, [&](const Shape& shape, std::size_t) {
                                          const std::size_t cells = number_of_cells(shape);
                                          const auto corners = static_cast<std::int64_t>(
                                              cells == 0 ? 0 : number_of_corners(shape) / cells);
                                          for(std::size_t i = 0; i < cells; ++i)
                                            number(end += corners, "\n");
                                        });
                                      }});
  }

  static void write_corners(const Number_writer& number, const Shape& shape, std::int64_t first)
  {
    if(shape.kind == Shape::Kind::TRIANGLES)
      shape.for_each_triangle([&](const Figure_triangle& t) {
        number(first + static_cast<std::int64_t>(t[0]), " ");
        number(first + static_cast<std::int64_t>(t[1]), " ");
        number(first + static_cast<std::int64_t>(t[2]), " \n");
      });
    else
      for(std::size_t i = 0; i < shape.number_of_points; ++i)
        number(first + static_cast<std::int64_t>(i), "\n");
  }

  void write_array(std::ostream& out, const Array& array, std::uint64_t& offset) const
  {
    out << "<DataArray " << array.attributes;
    if(m_is_binary) {
      out << " format=\"appended\" offset=\"" << offset << "\"/>\n";
      offset += sizeof offset + array.size;
      return;
    }
    out << " format=\"ascii\">\n";
    array.write(Number_writer(out, false));
    out << "</DataArray>\n";
  }

  void write_appended(std::ostream& out) const
  {
    out << "<AppendedData encoding=\"raw\">\n_";
    for(const Group& group : m_groups)
      for(const Array& array : group.arrays) {
        write_bytes(out, array.size);
        array.write(Number_writer(out, true));
      }
    out << "\n</AppendedData>\n";
  }

  const Figure& m_figure;
  bool m_is_binary;
  std::size_t m_cells[3] = {0, 0, 0}, m_corners[3] = {0, 0, 0}; // by kind
  std::vector<Group> m_groups;
};

} // namespace internal

namespace IO {

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Writes surfaces, curves and points in the PolyData format of VTK (`.vtp`), which ParaView reads.
 *
 * Cells have an array `curve`, which contains the number of the curve to which a cell belongs, or -1 for cells of
 * surfaces and of separate points. Points have an array for each `Vertex_values`.
 *
 * If an exception is thrown because of the data, nothing is written. The data are not copied. However, memory is
 * required for tubes, and for the numbers of the vertices of a mesh other than a `Surface_mesh`.
 *
 * \param destination a stream, or the name of a file, which is replaced if it exists. On systems that distinguish
 *        binary mode from text mode, a stream must be opened in binary mode. The locale and the format settings of the
 *        stream have no effect
 * \param parts the data, one or several of:
 *        - a triangle mesh, a model of `FaceListGraph`;
 *        - a range of points, with `x()`, `y()` and `z()`;
 *        - a range of polylines, which are ranges of points. Curves are numbered from 0 across all ranges of the call;
 *          curves without points are omitted, but receive a number. A curve of one point is written as a point;
 *        - `Tubes`, to draw curves as tubes;
 *        - `Vertex_values`, values at the vertices of the mesh;
 *        - `Colors`, to color the surface and the curves;
 *        - and at the end, an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of the mesh}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the vertices of the mesh as keys and points as values}
 *     \cgalParamDefault{the vertex point property of the mesh, which need not exist if a map is given}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{use_binary_mode}
 *     \cgalParamDescription{whether numbers are written as little-endian bytes or as text}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{stream_precision}
 *     \cgalParamDescription{the number of digits of numbers written as text}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{17, which suffices to restore every `double` exactly}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws File_write_error if the data are empty; if the stream has failed or fails, which its state also indicates; or
 *         if `Vertex_values` are written as text and contain a value that is not finite. Their values at points of
 *         curves and at separate points are NaN and thus never finite
 * \throws Invalid_coordinate_error if a coordinate is not finite; `elements()` returns the number of the vertex or of
 *         the point, preceded by the number of the curve if the point belongs to a curve
 * \throws Invalid_mesh_error if a face is not a triangle, or a `Surface_mesh` contains removed vertices or edges
 * \throws Invalid_parameter_error if two sets of values at vertices have the same name, or if the name of such a set
 *         is empty or contains characters other than letters, digits and underscores
 *
 * Complexity: linear in the size of the data.
 */
template <class Destination, class... Parts>
void write_VTP(Destination&& destination, const Parts&... parts)
{
  internal::write_parts<internal::Vtp_writer>(destination, parts...);
}

} // namespace IO
} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_IO_VTP_H
