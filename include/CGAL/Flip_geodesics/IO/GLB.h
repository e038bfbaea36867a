// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_IO_GLB_H
#define CGAL_FLIP_GEODESICS_IO_GLB_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/io/Figure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Flip_geodesics {
namespace internal {

/*
 * Writes a node for each shape, below a node that moves the shapes to their position, since coordinates are written as
 * floats relative to the center. Empty shapes are omitted, because glTF has no empty arrays. The bytes of a shape are
 * those of its points, followed by those of the corners of triangles; the points and the corners each have their own
 * view and accessor.
 */
class Glb_writer
{
public:
  Glb_writer(const Figure& figure, const Number_format&)
    : m_picture(figure.picture())
  {
    for(const Shape& shape : figure.shapes())
      if(shape.for_each_texture) {
        check_finite(shape); // with the original numbers of the vertices
        add(m_divided.emplace_back(divided_at_corners(shape)));
      } else
        add(shape);
    if(m_pieces.empty())
      throw File_write_error("there is nothing to write: no face, no point, and no curve that has a point");
    check_size(m_size);
    set_center();
    for(Piece& piece : m_pieces)
      set_bounds(piece);
    m_header = header();
    m_header.append((4 - m_header.size() % 4) % 4, ' ');
    check_size(file_size());
  }

  void write(std::ostream& out) const
  {
    constexpr std::uint32_t version = 2;
    out << "glTF";
    write_bytes(out, version);
    write_bytes(out, static_cast<std::uint32_t>(file_size()));
    write_bytes(out, static_cast<std::uint32_t>(m_header.size()));
    out << "JSON" << m_header;
    write_bytes(out, static_cast<std::uint32_t>(m_size));
    out.write("BIN\0", 4);
    for(const Piece& piece : m_pieces)
      write_arrays(out, *piece.shape);
  }

private:
  using Bounds = std::array<float, 3>;

  struct Piece
  {
    const Shape* shape;
    std::size_t view;     // the first of its views; accessors have the same numbers
    std::uint64_t offset; // of its bytes
    Bounds least, most;
  };

  static std::uint64_t point_bytes(const Shape& shape) { return std::uint64_t(12) * shape.number_of_points; }
  static std::uint64_t corner_bytes(const Shape& shape) { return std::uint64_t(12) * shape.number_of_triangles; }

  static std::uint64_t texture_bytes(const Shape& shape)
  {
    return shape.for_each_texture ? std::uint64_t(8) * shape.number_of_points : 0;
  }

  // Returns a shape with three separate points for each triangle, since texture coordinates belong to points in glTF.
  static Shape divided_at_corners(const Shape& shape)
  {
    Shape result = shape;
    result.number_of_points = 3 * shape.number_of_triangles;
    result.for_each_point = [&shape](const Sink<Figure_point>& sink) {
      std::vector<Figure_point> points;
      shape.for_each_point([&](const Figure_point& p) { points.push_back(p); });
      shape.for_each_triangle([&](const Figure_triangle& t) {
        for(std::size_t corner : t)
          sink(points[corner]);
      });
    };
    result.for_each_triangle = [count = shape.number_of_triangles](const Sink<Figure_triangle>& sink) {
      for(std::size_t i = 0; i < count; ++i)
        sink({3 * i, 3 * i + 1, 3 * i + 2});
    };
    return result;
  }

  static bool has_corners(const Shape& shape) { return shape.kind == Shape::Kind::TRIANGLES; }

  void add(const Shape& shape)
  {
    if(has_corners(shape) && shape.number_of_triangles == 0)
      return;
    m_pieces.push_back({&shape, m_number_of_views, m_size, {}, {}});
    m_number_of_views += (has_corners(shape) ? 2 : 1) + (shape.for_each_texture ? 1 : 0);
    m_size += point_bytes(shape) + corner_bytes(shape) + texture_bytes(shape);
  }

  // Includes the headers of the file and of both chunks, and their contents.
  std::uint64_t file_size() const { return 12 + 8 + m_header.size() + 8 + m_size; }

  // The indices of points then have 32 bits as well.
  static void check_size(std::uint64_t size)
  {
    if(size > (std::numeric_limits<std::uint32_t>::max)())
      throw File_write_error("a GLB file is limited to 4294967295 bytes, but this one would have " +
                             std::to_string(size));
  }

  // Sets the center of the bounding box of the surfaces, or of all shapes if there are no surfaces.
  void set_center()
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Figure_point least = {infinity, infinity, infinity}, most = {-infinity, -infinity, -infinity};
    const auto is_surface = [](const Piece& piece) {
      return piece.shape->kind == Shape::Kind::TRIANGLES && piece.shape->curve == Shape::no_curve;
    };
    const bool has_surface = std::any_of(m_pieces.begin(), m_pieces.end(), is_surface);
    for(const Piece& piece : m_pieces) {
      check_finite(*piece.shape);
      if(is_surface(piece) == has_surface)
        piece.shape->for_each_point([&](const Figure_point& p) { extend(least, most, p); });
    }
    for(int i = 0; i < 3; ++i)
      m_center[i] = least[i] + (most[i] - least[i]) / 2;
  }

  template <class Vector>
  static void extend(Vector& least, Vector& most, const Vector& p)
  {
    for(int i = 0; i < 3; ++i) {
      least[i] = (std::min)(least[i], p[i]);
      most[i] = (std::max)(most[i], p[i]);
    }
  }

  Bounds relative(const Figure_point& p) const
  {
    return {static_cast<float>(p[0] - m_center[0]), static_cast<float>(p[1] - m_center[1]),
            static_cast<float>(p[2] - m_center[2])};
  }

  void set_bounds(Piece& piece) const
  {
    piece.least.fill((std::numeric_limits<float>::max)());
    piece.most.fill(std::numeric_limits<float>::lowest());
    std::size_t i = 0;
    piece.shape->for_each_point([&](const Figure_point& p) {
      for(int k = 0; k < 3; ++k)
        if(!(std::abs(p[k] - m_center[k]) <= (std::numeric_limits<float>::max)()))
          throw_unusable_point(*piece.shape, i, " is too far from the center for the single precision of GLB");
      extend(piece.least, piece.most, relative(p));
      ++i;
    });
  }

  void write_arrays(std::ostream& out, const Shape& shape) const
  {
    shape.for_each_point([&](const Figure_point& p) {
      for(float x : relative(p))
        write_bytes(out, x);
    });
    if(has_corners(shape))
      shape.for_each_triangle([&](const Figure_triangle& t) {
        for(std::size_t corner : t)
          write_bytes(out, static_cast<std::uint32_t>(corner));
      });
    if(shape.for_each_texture)
      shape.for_each_texture([&](const Texture_corners& corners) {
        for(const auto& [u, v] : corners) { // the second texture coordinate of glTF points downwards
          write_bytes(out, is_textured(corners) ? static_cast<float>(u) : -1.0F);
          write_bytes(out, is_textured(corners) ? static_cast<float>(1 - v) : -1.0F);
        }
      });
  }

  // Returns three numbers as a JSON list.
  template <class Vector>
  static std::string three(const Vector& v)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(std::numeric_limits<double>::max_digits10);
    text << double(v[0]) << ',' << double(v[1]) << ',' << double(v[2]);
    return text.str();
  }

  // Returns a JSON list of `item(piece)` for each piece.
  template <class Item>
  std::string list(const Item& item, const std::string& last = "") const
  {
    std::string result;
    for(const Piece& piece : m_pieces)
      result += (result.empty() ? "" : ",") + item(piece);
    return '[' + result + last + ']';
  }

  std::size_t number(const Piece& piece) const { return static_cast<std::size_t>(&piece - m_pieces.data()); }

  static std::string name(const Piece& piece) { return "{\"name\":\"" + piece.shape->name() + '"'; }

  std::string material(const Piece& piece) const
  {
    const bool has_picture = piece.shape->for_each_texture && !m_picture.empty();
    const Figure_point white = {1, 1, 1};
    return name(piece) + ",\"doubleSided\":true,\"pbrMetallicRoughness\":{" +
           (has_picture ? "\"baseColorTexture\":{\"index\":0}," : "") + "\"baseColorFactor\":[" +
           three(has_picture ? white : material_of(*piece.shape).color) +
           ",1],\"metallicFactor\":0,\"roughnessFactor\":0.8}}";
  }

  static std::string view(std::uint64_t offset, std::uint64_t length, const char* target)
  {
    return "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) + ",\"byteLength\":" + std::to_string(length) +
           ",\"target\":" + target + '}';
  }

  static std::string views(const Piece& piece)
  {
    const std::uint64_t end = piece.offset + point_bytes(*piece.shape);
    const std::string points = view(piece.offset, point_bytes(*piece.shape), "34962"); // an array of vertices
    if(!has_corners(*piece.shape))
      return points;
    const std::string corners = points + ',' + view(end, corner_bytes(*piece.shape), "34963"); // of indices
    if(!piece.shape->for_each_texture)
      return corners;
    return corners + ',' + view(end + corner_bytes(*piece.shape), texture_bytes(*piece.shape), "34962");
  }

  static std::string accessors(const Piece& piece)
  {
    const Shape& shape = *piece.shape;
    const std::string points = "{\"bufferView\":" + std::to_string(piece.view) +
                               ",\"componentType\":5126,\"count\":" + std::to_string(shape.number_of_points) +
                               ",\"type\":\"VEC3\",\"min\":[" + three(piece.least) + "],\"max\":[" + three(piece.most) +
                               "]}"; // 5126: floats
    if(!has_corners(*piece.shape))
      return points;
    const std::string corners = points + ",{\"bufferView\":" + std::to_string(piece.view + 1) +
                                ",\"componentType\":5125,\"count\":" + std::to_string(3 * shape.number_of_triangles) +
                                ",\"type\":\"SCALAR\"}"; // 5125: unsigned integers
    if(!shape.for_each_texture)
      return corners;
    return corners + ",{\"bufferView\":" + std::to_string(piece.view + 2) +
           ",\"componentType\":5126,\"count\":" + std::to_string(shape.number_of_points) + ",\"type\":\"VEC2\"}";
  }

  static const char* mode(const Shape& shape)
  {
    switch(shape.kind) {
    case Shape::Kind::TRIANGLES:
      return "4";
    case Shape::Kind::LINE:
      return "3"; // a strip
    case Shape::Kind::POINTS:
      break;
    }
    return "0";
  }

  std::string mesh(const Piece& piece) const
  {
    const std::string indices =
        has_corners(*piece.shape) ? ",\"indices\":" + std::to_string(piece.view + 1) : std::string();
    const std::string texture =
        piece.shape->for_each_texture ? ",\"TEXCOORD_0\":" + std::to_string(piece.view + 2) : std::string();
    return name(piece) + ",\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(piece.view) + texture +
           '}' + indices + ",\"mode\":" + mode(*piece.shape) + ",\"material\":" + std::to_string(number(piece)) + "}]}";
  }

  // The image is a file in the same directory; its border pixels are repeated outside the image.
  std::string textures() const
  {
    if(m_picture.empty())
      return {};
    std::string name;
    for(char c : m_picture) {
      if(c == '"' || c == '\\')
        name += '\\';
      if(static_cast<unsigned char>(c) < 0x20)
        throw File_write_error("the name of an image contains a control character");
      name += c;
    }
    return ",\"images\":[{\"uri\":\"" + name +
           "\"}],\"samplers\":[{\"wrapS\":33071,\"wrapT\":33071}],\"textures\":[{\"source\":0,\"sampler\":0}]";
  }

  std::string header() const
  {
    const auto node = [&](const Piece& piece) {
      return name(piece) + ",\"mesh\":" + std::to_string(number(piece)) + '}';
    };
    const std::string children = list([&](const Piece& piece) { return std::to_string(number(piece)); });
    const std::string root =
        ",{\"name\":\"all\",\"children\":" + children + ",\"translation\":[" + three(m_center) + "]}";
    return "{\"asset\":{\"version\":\"2.0\",\"generator\":\"flip_geodesics\"},\"scene\":0,\"scenes\":[{\"nodes\":[" +
           std::to_string(m_pieces.size()) + "]}],\"nodes\":" + list(node, root) +
           ",\"meshes\":" + list([&](const Piece& piece) { return mesh(piece); }) +
           ",\"materials\":" + list([&](const Piece& piece) { return material(piece); }) + textures() +
           ",\"accessors\":" + list(accessors) + ",\"bufferViews\":" + list(views) +
           ",\"buffers\":[{\"byteLength\":" + std::to_string(m_size) + "}]}";
  }

  std::deque<Shape> m_divided; // those with a texture
  std::string m_picture;
  std::vector<Piece> m_pieces;
  std::size_t m_number_of_views = 0;
  std::uint64_t m_size = 0; // of all arrays together
  Figure_point m_center = {0, 0, 0};
  std::string m_header;
};

} // namespace internal

namespace IO {

/*!
 * \ingroup PkgFlipGeodesicsIO
 *
 * Writes surfaces, curves and points in the binary glTF 2.0 format, which browsers and animation programs support.
 *
 * The file has a node `surface`, a node `curve_N` for each curve, and a node `points`. Coordinates are floats relative
 * to the center of the bounding box of the surface, or of all data if there is no surface. With an `IO::Texture`, each
 * face has three separate vertices, which have the attribute `TEXCOORD_0`.
 *
 * \param destination a binary stream, or the name of a file, which is replaced if it exists
 * \param parts the data, as for `write_VTP()`; the named parameters `use_binary_mode` and `stream_precision` are
 *        ignored. A mesh without faces is omitted
 *
 * \throws File_write_error as `write_VTP()` does, if the file would have 4294967296 bytes or more, or if the name of an
 *         image contains a control character
 * \throws Invalid_coordinate_error as `write_VTP()` does, or if a point is farther from the center than floats can
 *         represent
 * \throws Invalid_mesh_error as `write_VTP()` does
 */
template <class Destination, class... Parts>
void write_GLB(Destination&& destination, const Parts&... parts)
{
  internal::write_parts<internal::Glb_writer>(destination, parts...);
}

} // namespace IO
} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_IO_GLB_H
