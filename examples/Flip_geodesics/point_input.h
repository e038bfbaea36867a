// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_POINT_INPUT_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_POINT_INPUT_H

#include "curve_input.h"

#include <CGAL/Flip_geodesics/curves_through_points.h>

#include <sstream>
#include <string>
#include <vector>

// Files of points anywhere on the mesh: `v` is a vertex, `a,b,t` the point (1-t) a + t b of an edge, and `a,b,c,t,u` the
// point (1-t-u) a + t b + u c of a face, as in the polylines that the program writes.
namespace program {

inline std::vector<double> read_numbers(const std::string& word, const std::string& name)
{
  std::vector<double> numbers;
  std::istringstream fields(word);
  for(std::string field; std::getline(fields, field, ',');) {
    std::istringstream number(field);
    double x = 0;
    if(!(number >> x) || !number.eof())
      throw Bad_input(name + ": '" + word + "' is not a point; write a vertex, a,b,t or a,b,c,t,u without blanks");
    numbers.push_back(x);
  }
  return numbers;
}

inline Index read_vertex(const Mesh& mesh, double number, const std::string& name)
{
  if(!(number >= -1e15 && number <= 1e15) || number != static_cast<double>(static_cast<long long>(number)))
    throw Bad_input(name + ": a point has a vertex that is no whole number; vertices are counted from 0");
  check_vertex(mesh, static_cast<long long>(number), name);
  return static_cast<Index>(number);
}

/// The halfedge from a to b; one of the face with c if that is given.
inline Mesh::Halfedge_index halfedge_between(const Mesh& mesh, Index a, Index b, Index c = -1)
{
  const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Vertex_index(a), Mesh::Vertex_index(b));
  const bool is_of_face = h != Mesh::null_halfedge() &&
                          (c < 0 || (!mesh.is_border(h) && mesh.target(mesh.next(h)) == Mesh::Vertex_index(c)));
  return is_of_face ? h : Mesh::null_halfedge();
}

inline CGAL::Flip_geodesics::Surface_location read_point(const Mesh& mesh, const std::string& word,
                                                         const std::string& name)
{
  const std::vector<double> n = read_numbers(word, name);
  if(n.size() != 1 && n.size() != 3 && n.size() != 5)
    throw Bad_input(name + ": '" + word + "' is not a point; write a vertex, a,b,t or a,b,c,t,u without blanks");
  const Index a = read_vertex(mesh, n[0], name);
  if(n.size() == 1) {
    const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Vertex_index(a));
    if(h == Mesh::null_halfedge())
      throw Bad_input(name + ": vertex " + std::to_string(a) + " is in no face; choose another one");
    return {static_cast<Index>(mesh.opposite(h)), {{1, 0, 0}}};
  }
  const Index b = read_vertex(mesh, n[1], name), c = n.size() == 5 ? read_vertex(mesh, n[2], name) : -1;
  const double t = n[n.size() == 5 ? 3 : 2], u = n.size() == 5 ? n[4] : 0;
  if(!(t >= 0 && u >= 0 && t + u <= 1))
    throw Bad_input(name + ": '" + word + "' is outside; its coordinates must not be negative or sum to more than 1");
  if(const auto h = halfedge_between(mesh, a, b, c); h != Mesh::null_halfedge())
    return {static_cast<Index>(h), {{1 - t - u, t, u}}};
  if(const auto h = halfedge_between(mesh, b, a, c); h != Mesh::null_halfedge())
    return {static_cast<Index>(h), {{t, 1 - t - u, u}}};
  throw Bad_input(name + ": '" + word + "' names vertices that are not those of an edge or face; correct them");
}

/// Lines of points. Those of splines are control points; `s` before them makes them those of a cubic B-spline, `o` of a
/// closed one, and nothing those of a Bezier curve.
inline std::vector<Curve_request> read_point_curves(const Mesh& mesh, const std::string& file, bool are_splines)
{
  using CGAL::Flip_geodesics::Spline_kind;
  std::vector<Curve_request> curves;
  for_each_line(file, [&](std::istringstream& words, const std::string& name) {
    Curve_request curve;
    curve.name = name;
    if(are_splines) {
      curve.spline = Spline_kind::BEZIER;
      const char mark = static_cast<char>(words.peek());
      if(mark == 's' || mark == 'o') {
        words.get();
        curve.spline = mark == 's' ? Spline_kind::CUBIC_B_SPLINE : Spline_kind::CLOSED_CUBIC_B_SPLINE;
        curve.is_closed = mark == 'o';
      }
    }
    for(std::string word; words >> word;)
      curve.points.push_back(read_point(mesh, word, name));
    if(curve.points.size() < (curve.is_closed ? 3u : 2u))
      throw Bad_input(name + ": a curve needs two points, a closed one three; add points or remove the line");
    curves.push_back(curve);
  });
  check_not_empty(curves, file);
  return curves;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_POINT_INPUT_H
