// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_IO_FIGURE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_IO_FIGURE_H

#include <CGAL/Flip_geodesics/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

using Figure_point = std::array<double, 3>;
using Figure_triangle = std::array<std::size_t, 3>;
using Texture_corners = std::array<std::array<double, 2>, 3>;

/* Takes one element after the other. */
template <class T>
using Sink = std::function<void(const T&)>;

/*
 * One piece of what a file shows: a surface, a curve as a line or a tube, or loose points. Its elements are handed out
 * in their order as often as is asked for, and not copied. Corners of triangles are positions among its points.
 */
struct Shape
{
  enum class Kind { TRIANGLES, LINE, POINTS };
  static constexpr std::int64_t no_curve = -1;

  Kind kind = Kind::POINTS;
  std::int64_t curve = no_curve; // its number, if it is one
  std::size_t number_of_points = 0, number_of_triangles = 0;
  std::function<void(const Sink<Figure_point>&)> for_each_point;
  std::function<void(const Sink<Figure_triangle>&)> for_each_triangle; // of TRIANGLES only
  std::function<void(const Sink<Texture_corners>&)> for_each_texture;  // where the corners lie in a picture, if they do

  std::string name() const
  {
    if(curve != no_curve)
      return "curve_" + std::to_string(curve);
    return kind == Kind::TRIANGLES ? "surface" : "points";
  }
};

/* All pieces of what a file shows, and the order of all their points. */
class Figure
{
public:
  /* Pieces without points are left out. */
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

  /* Calls `f(shape, first)` for all of a kind, where the first point of the shape is number `first` of all. */
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

  /* The name of the file with the picture on surfaces; empty if there is none. */
  const std::string& picture() const { return m_picture; }
  void set_picture(const std::string& name) { m_picture = name; }

private:
  std::vector<Shape> m_shapes;
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

/* Has a triangle a place in the picture? */
inline bool is_textured(const Texture_corners& corners)
{
  return std::all_of(corners.begin(), corners.end(),
                     [](const auto& t) { return std::isfinite(t[0]) && std::isfinite(t[1]); });
}

/* What text and numbers of 64 bits can hold: something, and all of it finite. */
inline void check_writable(const Figure& figure)
{
  if(figure.shapes().empty())
    throw File_write_error("there is nothing to write: no vertex, no curve with a point, and no point");
  std::for_each(figure.shapes().begin(), figure.shapes().end(), check_finite);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_IO_FIGURE_H
