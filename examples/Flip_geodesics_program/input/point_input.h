// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_POINT_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_POINT_INPUT_H

#include "input/curve_input.h"

#include <CGAL/Flip_geodesics/curves_through_points.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// Files of points anywhere on the mesh: `v` is a vertex, `a,b,t` the point (1-t) a + t b of an edge, and `a,b,c,t,u`
// the point (1-t-u) a + t b + u c of a face, as in the polylines that the program writes.
namespace program {

[[noreturn]] inline void throw_no_point(std::string_view word, const std::string& name)
{
  throw Bad_input(name + ": '" + printable(word) +
                  "' is not a point; write a vertex, a,b,t or a,b,c,t,u without blanks");
}

inline std::vector<double> read_numbers(std::string_view word, const std::string& name)
{
  std::vector<double> numbers;
  for(std::size_t start = 0, end = 0; end < word.size(); start = end + 1) {
    end = (std::min)(word.find(',', start), word.size());
    numbers.push_back(0);
    if(parse_number(word.substr(start, end - start), numbers.back()) != nullptr)
      throw_no_point(word, name);
  }
  return numbers;
}

inline Vertex_index read_vertex(const Input_mesh& mesh, double number, const std::string& name)
{
  if(!(number >= -1e15 && number <= 1e15) || number != static_cast<double>(static_cast<long long>(number)))
    throw Bad_input(name + ": a point has a vertex that is no whole number; vertices are counted from 0");
  return mesh.vertex(static_cast<long long>(number), name);
}

/// The halfedge from a to b; one of the face with c if that is given.
inline Mesh::Halfedge_index halfedge_between(const Mesh& mesh, Vertex_index a, Vertex_index b, Vertex_index c)
{
  const Mesh::Halfedge_index h = mesh.halfedge(mesh_vertex(a), mesh_vertex(b));
  const bool is_of_face = h != Mesh::null_halfedge() &&
                          (!c.is_valid() || (!mesh.is_border(h) && mesh.target(mesh.next(h)) == mesh_vertex(c)));
  return is_of_face ? h : Mesh::null_halfedge();
}

inline CGAL::Flip_geodesics::Surface_location read_point(const Input_mesh& input_mesh, std::string_view word,
                                                         const std::string& name)
{
  const Mesh& mesh = input_mesh;
  const std::vector<double> n = read_numbers(word, name);
  if(n.size() != 1 && n.size() != 3 && n.size() != 5)
    throw_no_point(word, name);
  const Vertex_index a = read_vertex(input_mesh, n[0], name);
  if(n.size() == 1) {
    const Mesh::Halfedge_index h = mesh.halfedge(mesh_vertex(a));
    if(h == Mesh::null_halfedge())
      throw Bad_input(name + ": vertex " + std::to_string(a.idx()) + " is in no face; choose another one");
    return {index_of(mesh.opposite(h)), {{1, 0, 0}}};
  }
  const Vertex_index b = read_vertex(input_mesh, n[1], name);
  const Vertex_index c = n.size() == 5 ? read_vertex(input_mesh, n[2], name) : Vertex_index();
  const double t = n[n.size() == 5 ? 3 : 2], u = n.size() == 5 ? n[4] : 0;
  if(!(t >= 0 && u >= 0 && t + u <= 1))
    throw Bad_input(name + ": '" + printable(word) +
                    "' is outside; its coordinates must not be negative or sum to more than 1");
  if(const auto h = halfedge_between(mesh, a, b, c); h != Mesh::null_halfedge())
    return {index_of(h), {{1 - t - u, t, u}}};
  if(const auto h = halfedge_between(mesh, b, a, c); h != Mesh::null_halfedge())
    return {index_of(h), {{t, 1 - t - u, u}}};
  throw Bad_input(name + ": '" + printable(word) +
                  "' names vertices that are not those of an edge or face; correct them");
}

/// Lines of points. Those of splines are control points; `s` before them makes them those of a cubic B-spline, `o` of a
/// closed one, and nothing those of a Bezier curve.
inline std::vector<Curve_request> read_point_curves(const Input_mesh& mesh, const Input_text& input, bool are_splines)
{
  using CGAL::Flip_geodesics::Spline_kind;
  std::vector<Curve_request> curves;
  for_each_line(input, [&](Text_scanner& words) {
    const std::string name = words.place();
    Curve_request curve;
    curve.name = name;
    if(are_splines) {
      curve.spline = Spline_kind::BEZIER;
      curve.is_closed = words.take('o');
      if(curve.is_closed)
        curve.spline = Spline_kind::CLOSED_CUBIC_B_SPLINE;
      else if(words.take('s'))
        curve.spline = Spline_kind::CUBIC_B_SPLINE;
    }
    for(std::string_view word; !(word = words.next_word()).empty();)
      curve.points.push_back(read_point(mesh, word, name));
    if(curve.points.size() < (curve.is_closed ? 3u : 2u))
      words.fail("a curve needs two points, a closed one three; add points or remove the line");
    curves.push_back(curve);
  });
  check_not_empty(curves, input);
  return curves;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_POINT_INPUT_H
