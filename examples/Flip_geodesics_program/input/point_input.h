// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_POINT_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_POINT_INPUT_H

#include "input/curve_input.h"
#include "input/input_mesh.h"
#include "messages.h"
#include "program_mesh.h"

#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/internal/surface/Nearest_face.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Polygon_mesh_processing/shape_predicates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Points anywhere on the mesh, in files and options: `v` is a vertex, `a,b,t` the point (1-t) a + t b of an edge, and
// `a,b,c,t,u` the point (1-t-u) a + t b + u c of a face, as in the polylines that the program writes. Three numbers of
// which the first two are not both written as whole numbers are a point in space, for the nearest point of the mesh.
// Vertices must be written as whole numbers, and three whole numbers are not accepted, since they may be coordinates.
// Polylines are lines of points, after `o` closed; or, in a file `.polylines.txt`, lines of points in space.
namespace program {

/// Finds the nearest points of a mesh among its non-degenerate faces, which have all edges except those between two
/// degenerate faces. Barycentric coordinates below 1e-12, or below the rounding errors of points on a mesh far from the
/// origin, count as zero.
class Surface_projector
{
public:
  /// \throws Bad_input if all faces are degenerate
  explicit Surface_projector(const Input_mesh& mesh)
    : m_mesh(mesh)
    , m_sides{&mesh.mesh(), first_face(mesh)}
    , m_nearest_face(mesh, m_sides)
  {
  }

  /// \param name where the point is, for a remark if it is not on the mesh
  CGAL::Flip_geodesics::Surface_location operator()(const Point_3& p, const std::string& name)
  {
    const auto found = m_nearest_face(CGAL::Flip_geodesics::internal::half_of(p));
    m_mesh.note_projection(2 * found.distance(), name);
    CGAL::Flip_geodesics::Surface_location result = {index_of(m_sides.side(found.face)), found.nearest.weights};
    const std::array<double, 3> least = least_weights(m_sides(found.face));
    for(std::size_t i = 0; i < 3; ++i)
      result.weights[i] = result.weights[i] < least[i] ? 0 : result.weights[i];
    return result;
  }

private:
  // The errors of the weights of a point on a side: those of coordinates, relative to the heights of the face.
  static std::array<double, 3> least_weights(const CGAL::Flip_geodesics::internal::Triangle_places& corners)
  {
    double largest = 0, longest = 0;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t k = 0; k < 3; ++k) {
        largest = std::max(largest, std::abs(corners[i][k]));
        longest = std::max(longest, std::abs(corners[i][k] - corners[(i + 1) % 3][k]));
      }
    const auto side = [&](std::size_t i) { // in units in which no product overflows or underflows
      const auto &p = corners[(i + 1) % 3], &q = corners[(i + 2) % 3];
      return Kernel::Vector_3((q[0] - p[0]) / longest, (q[1] - p[1]) / longest, (q[2] - p[2]) / longest);
    };
    const double area = std::sqrt(CGAL::cross_product(side(0), side(1)).squared_length());
    std::array<double, 3> result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = std::clamp(16 * std::numeric_limits<double>::epsilon() * (largest / longest) *
                                 (std::sqrt(side(i).squared_length()) / area),
                             1e-12, 1e-6);
    return result;
  }

  static bool is_degenerate(const Mesh& mesh, Mesh::Face_index f)
  {
    return CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(f, mesh);
  }

  static Mesh::Face_index first_face(const Mesh& mesh)
  {
    const auto found =
        std::find_if(mesh.faces_begin(), mesh.faces_end(), [&](Mesh::Face_index f) { return !is_degenerate(mesh, f); });
    if(found == mesh.faces_end())
      throw Bad_input(
          "all faces of the mesh are degenerate, so points cannot be projected onto them; correct the mesh");
    return *found;
  }

  // The corners of faces, with halved coordinates, whose differences are finite. Another face stands in for degenerate
  // ones.
  struct Sides
  {
    const Mesh* mesh;
    Mesh::Face_index stand_in;

    Mesh::Halfedge_index side(Mesh::Face_index f) const
    {
      return mesh->halfedge(is_degenerate(*mesh, f) ? stand_in : f);
    }
    CGAL::Flip_geodesics::internal::Triangle_places operator()(Mesh::Face_index f) const
    {
      const auto corner = [&](Mesh::Halfedge_index h) {
        return CGAL::Flip_geodesics::internal::half_of(mesh->point(mesh->source(h)));
      };
      const Mesh::Halfedge_index h = side(f);
      return {{corner(h), corner(mesh->next(h)), corner(mesh->prev(h))}};
    }
  };

  const Input_mesh& m_mesh;
  Sides m_sides;
  CGAL::Flip_geodesics::internal::Nearest_face<Mesh, Sides> m_nearest_face;
};

[[noreturn]] inline void throw_no_point(std::string_view word, const std::string& name)
{
  throw Bad_input(
      name + ": '" + printable(word) +
      "' is not a point; write `v` for a vertex, `x,y,z` in space, `a,b,t` on an edge or `a,b,c,t,u` in a face, "
      "without blanks");
}

inline std::vector<double> read_numbers(std::string_view word, const std::string& name)
{
  std::vector<double> numbers;
  for(const std::string_view piece : pieces_of(word)) {
    numbers.push_back(0);
    if(parse_number(piece, numbers.back()) != nullptr)
      throw_no_point(word, name);
  }
  return numbers;
}

/// Returns whether numbers, with commas between them, are all written without a decimal point and an exponent.
inline bool are_whole(std::string_view numbers)
{
  return numbers.find_first_not_of("0123456789,+-") == std::string_view::npos;
}

/// What to write instead of three numbers that do not denote a point of an edge, for messages.
constexpr const char* advice_on_coordinates =
    "; for a point in space, write x or y with a decimal point, as in 3.0,4,5";

/// \param alternative what to write instead of the number of a vertex, for messages \throws Bad_input
inline Vertex_index read_vertex(const Input_mesh& mesh, std::string_view word, const std::string& name,
                                const std::string& alternative = "")
{
  long long number = 0;
  if(parse_number(word, number) != nullptr)
    throw Bad_input(
        name + ": '" + printable(word) +
        "' is not the number of a vertex; write a whole number, counted from 0, or a point in space without "
        "blanks, as in 3.0,4,5");
  return mesh.vertex(number, name, alternative);
}

/// Finds the points that words stand for.
class Point_reader
{
  using Surface_location = CGAL::Flip_geodesics::Surface_location;

public:
  explicit Point_reader(const Input_mesh& mesh)
    : m_input_mesh(mesh)
    , m_mesh(mesh)
  {
  }

  const Input_mesh& mesh() const { return m_input_mesh; }

  /// Whether the halfedge of the last location leads from b to a, since a face lists the vertices in the other order.
  bool is_reversed() const { return m_is_reversed; }

  /// \param name where the word is, for messages \throws Bad_input
  Surface_location operator()(std::string_view word, const std::string& name)
  {
    const std::vector<double> n = read_numbers(word, name);
    m_is_reversed = false;
    if(n.size() == 3 && !are_whole(word.substr(0, word.rfind(','))))
      return nearest_point({n[0], n[1], n[2]}, name);
    if(n.size() != 1 && n.size() != 3 && n.size() != 5)
      throw_no_point(word, name);
    return n.size() == 1 ? at_vertex(read_vertex(m_input_mesh, word, name), name) : in_face(n, word, name);
  }

  Surface_location nearest_point(const Point_3& p, const std::string& name)
  {
    if(!m_project)
      m_project.emplace(m_input_mesh);
    return (*m_project)(p, name);
  }

private:
  Surface_location at_vertex(Vertex_index v, const std::string& name) const
  {
    const Mesh::Halfedge_index h = m_mesh.halfedge(mesh_vertex(v));
    if(h == Mesh::null_halfedge())
      throw Bad_input(name + ": vertex " + std::to_string(v.idx()) + " does not belong to a face; choose another one");
    return {index_of(m_mesh.opposite(h)), {{1, 0, 0}}};
  }

  // Three whole numbers denote an end of an edge at best, for which the number of a vertex suffices.
  [[noreturn]] static void throw_ambiguous(const std::vector<std::string_view>& pieces, std::string_view word,
                                           const std::string& name, double t)
  {
    const auto piece = [&](std::size_t i) { return printable(pieces[i]); };
    throw Bad_input(name + ": '" + printable(word) + "' is ambiguous; write " + piece(0) + ".0," + piece(1) + ".0," +
                    piece(2) + " for a point in space" +
                    (t == 0 || t == 1 ? ", or " + piece(t == 0 ? 0 : 1) + " for the vertex" : ""));
  }

  Surface_location in_face(const std::vector<double>& n, std::string_view word, const std::string& name)
  {
    const std::vector<std::string_view> pieces = pieces_of(word);
    const bool is_on_edge = n.size() == 3;
    const std::string alternative = is_on_edge ? advice_on_coordinates : "";
    const double t = n[is_on_edge ? 2 : 3], u = is_on_edge ? 0 : n[4];
    if(is_on_edge && are_whole(word))
      throw_ambiguous(pieces, word, name, t);
    if(!(t >= 0 && u >= 0 && t + u <= 1))
      throw Bad_input(name + ": '" + printable(word) +
                      (is_on_edge ? "' is outside its edge; t must be at least 0 and at most 1"
                                  : "' is outside its face; t and u must be at least 0, and their sum at most 1") +
                      alternative);
    const auto vertex = [&](std::size_t i) { return read_vertex(m_input_mesh, pieces[i], name, alternative); };
    const Vertex_index a = vertex(0), b = vertex(1), c = is_on_edge ? Vertex_index() : vertex(2);
    const auto weight = [](double x) { return x < 1e-100 ? 0 : x; }; // the least positive one of a location
    if(const auto location = location_between(m_mesh, a, b, c, weight(t), weight(u))) {
      m_is_reversed = m_mesh.source(mesh_halfedge(location->halfedge)) != mesh_vertex(a);
      return *location;
    }
    throw Bad_input(name + ": '" + printable(word) +
                    "' names vertices that do not form an edge or face of the mesh; correct them" + alternative);
  }

  const Input_mesh& m_input_mesh;
  const Mesh& m_mesh;
  std::optional<Surface_projector> m_project;
  bool m_is_reversed = false;
};

/// A point, called as the user does.
inline Named_point read_named_point(Point_reader& read_point, const std::string& word, const std::string& name)
{
  const bool is_vertex = word.find(',') == std::string::npos;
  return {read_point(word, name),
          is_vertex ? "vertex " + decimal_text(read_numbers(word, name).front()) : "point " + printable(word)};
}

/// The points of words: one each, or all vertices of a list of whole numbers with commas between.
inline std::vector<Named_point> read_named_points(const Input_mesh& mesh, const std::vector<std::string>& words,
                                                  const std::string& name)
{
  Point_reader read_point(mesh);
  std::vector<Named_point> result;
  for(const std::string& word : words) {
    for(const std::string_view piece : are_whole(word) ? pieces_of(word) : std::vector<std::string_view>{word})
      result.push_back(read_named_point(read_point, std::string(piece), name));
  }
  return result;
}

/// The next point of a line, which a comma may separate from the one after it; empty at the end of the line.
inline std::string_view next_point(Text_scanner& words)
{
  std::string_view word = words.next_word();
  if(word.size() > 1 && word.back() == ',')
    word.remove_suffix(1);
  return word;
}

/// A path between two points: a pair if both are vertices.
inline Curve_request path_between(Point_reader& read_point, std::string_view s, std::string_view t,
                                  const std::string& name, const std::string& name_of_s, const std::string& name_of_t)
{
  long long a = 0, b = 0;
  const Input_mesh& mesh = read_point.mesh();
  if(parse_number(s, a) == nullptr && parse_number(t, b) == nullptr)
    return make_pair_request(mesh.vertex(a, name_of_s), mesh.vertex(b, name_of_t), name);
  Curve_request curve;
  curve.name = name;
  curve.points = {read_point(s, name_of_s), read_point(t, name_of_t)};
  return curve;
}

/// Lines `s t` of points, separated by blanks or a comma. Whether a path joins them is left to the computation, so that
/// a pair fails alone.
inline std::vector<Curve_request> read_pairs(const Input_mesh& mesh, const Input_text& input)
{
  Point_reader read_point(mesh);
  std::vector<Curve_request> pairs;
  for_each_line(input, [&](Text_scanner& words) {
    std::vector<std::string_view> ends;
    for(std::string_view word; !(word = next_point(words)).empty();)
      ends.push_back(word);
    if(ends.size() == 1) { // the comma in the middle separates two points of as many numbers
      std::size_t at = std::string_view::npos;
      for(auto left = std::count(ends[0].begin(), ends[0].end(), ',') / 2 + 1; left > 0; --left)
        at = ends[0].find(',', at + 1);
      if(at != std::string_view::npos && std::count(ends[0].begin(), ends[0].end(), ',') % 2 == 1)
        ends = {ends[0].substr(0, at), ends[0].substr(at + 1)};
    }
    const std::string name = words.place();
    if(ends.size() != 2)
      words.fail("a pair consists of two points, not " + std::to_string(ends.size()) + "; write `source target`");
    pairs.push_back(path_between(read_point, ends[0], ends[1], name, name, name));
  });
  check_not_empty(pairs, input);
  return pairs;
}

// Adds the points of what is left of a line.
inline void read_points(Point_reader& read_point, Text_scanner& words, Curve_request& curve)
{
  for(std::string_view word; !(word = next_point(words)).empty();)
    curve.points.push_back(read_point(word, words.place()));
}

// The curves of the lines of a file. \param read reads the line of a curve that has a name
template <class Read>
std::vector<Curve_request> read_lines(const Input_text& input, const Read& read)
{
  std::vector<Curve_request> curves;
  for_each_line(input, [&](Text_scanner& words) {
    Curve_request curve;
    curve.name = words.place();
    read(words, curve);
    if(curve.points.size() < (curve.is_closed ? 3u : 2u))
      words.fail(std::string("a curve requires at least two points, and a closed curve at least three") +
                 (curve.is_drawn ? ", where consecutive points that coincide count as one" : "") +
                 "; add points or remove the line");
    curves.push_back(curve);
  });
  check_not_empty(curves, input);
  return curves;
}

/// Lines of points. Those of splines are control points; `s` before them makes them those of a cubic B-spline, `o` of a
/// closed one, and nothing those of a Bezier curve.
inline std::vector<Curve_request> read_point_curves(const Input_mesh& mesh, const Input_text& input, bool are_splines)
{
  using CGAL::Flip_geodesics::Spline_kind;
  Point_reader read_point(mesh);
  return read_lines(input, [&](Text_scanner& words, Curve_request& curve) {
    if(are_splines) {
      curve.is_closed = words.take('o');
      curve.spline = curve.is_closed   ? Spline_kind::CLOSED_CUBIC_B_SPLINE
                     : words.take('s') ? Spline_kind::CUBIC_B_SPLINE
                                       : Spline_kind::BEZIER;
    }
    read_points(read_point, words, curve);
  });
}

// A line of a file `.polylines.txt`: the number of points, and their coordinates. It is closed if the first point is
// repeated at the end.
inline void read_polyline_in_space(Point_reader& read_point, Text_scanner& words, Curve_request& curve)
{
  long long count = 0;
  if(parse_number(words.next_word(), count) != nullptr || count < 0)
    words.fail("the line does not start with the number of points of the polyline; add this number");
  std::vector<Point_3> points;
  while(static_cast<long long>(points.size()) < count) {
    const Element element = {"point", points.size()};
    std::array<double, 3> x;
    for(double& coordinate : x)
      coordinate = words.number<double>(words.next_word(), element);
    points.emplace_back(x[0], x[1], x[2]);
  }
  if(words.has_word())
    words.fail(
        "there is text after the last point; a line consists of the number of points and the coordinates of each");
  curve.is_closed = count > 3 && points.front() == points.back();
  if(curve.is_closed)
    points.pop_back();
  for(const Point_3& p : points)
    curve.points.push_back(read_point.nearest_point(p, words.place()));
}

// Merges consecutive coincident points, such as those of curves through coincident vertices.
inline void merge_coincident_points(const Mesh& mesh, Curve_request& curve)
{
  std::vector<CGAL::Flip_geodesics::Surface_location>& points = curve.points;
  const CGAL::Flip_geodesics::Numbered_mesh<Mesh> numbered(mesh);
  const auto are_same = [&](const auto& a, const auto& b) { return are_in_one_place(numbered, a, b); };
  points.erase(std::unique(points.begin(), points.end(), are_same), points.end());
  while(curve.is_closed && points.size() > 1 && are_same(points.front(), points.back()))
    points.pop_back();
}

inline std::vector<Curve_request> read_drawn_curves(const Input_mesh& mesh, const Input_text& input)
{
  const bool is_in_space = is_name_of_polylines(input.file());
  Point_reader read_point(mesh);
  return read_lines(input, [&](Text_scanner& words, Curve_request& curve) {
    curve.is_drawn = true;
    if(is_in_space) {
      read_polyline_in_space(read_point, words, curve);
    } else {
      curve.is_closed = words.take('o');
      read_points(read_point, words, curve);
    }
    merge_coincident_points(mesh, curve);
  });
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_POINT_INPUT_H
