// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_REQUESTS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_REQUESTS_H

#include "program_mesh.h"

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

// What users request.
namespace program {

/// What no path may cross.
struct Obstacles
{
  std::set<Mesh::Face_index> faces;
  std::set<Mesh::Edge_index> walls; ///< edges along which paths may run

  bool are_none() const { return faces.empty() && walls.empty(); }
};

/// The factors of lengths, given for all faces or for all edges.
struct Weights
{
  std::string name; ///< of the file, for messages
  std::vector<double> of_faces, of_edges;
};

/// What changes the lengths of paths.
struct Path_conditions
{
  Obstacles obstacles;
  std::optional<Weights> weights;
  std::optional<double> mollify; ///< the margin of the triangle inequality, relative to the mean length of edges
};

using CGAL::Flip_geodesics::Vertex_index;

/// The halfedge from a to b; one of the face with c if that is given.
inline Mesh::Halfedge_index halfedge_between(const Mesh& mesh, Vertex_index a, Vertex_index b, Vertex_index c)
{
  const Mesh::Halfedge_index h = mesh.halfedge(mesh_vertex(a), mesh_vertex(b));
  const bool is_of_face = h != Mesh::null_halfedge() &&
                          (!c.is_valid() || (!mesh.is_border(h) && mesh.target(mesh.next(h)) == mesh_vertex(c)));
  return is_of_face ? h : Mesh::null_halfedge();
}

/// The point (1-t-u) a + t b + u c of an edge, or of a face if c is given, in a face. Nothing if the mesh does not have
/// such an edge or face.
inline std::optional<CGAL::Flip_geodesics::Surface_location> location_between(const Mesh& mesh, Vertex_index a,
                                                                              Vertex_index b, Vertex_index c, double t,
                                                                              double u)
{
  using Location = CGAL::Flip_geodesics::Surface_location;
  if(const auto h = halfedge_between(mesh, a, b, c); h != Mesh::null_halfedge() && !mesh.is_border(h))
    return Location{index_of(h), {{1 - t - u, t, u}}};
  if(const auto h = halfedge_between(mesh, b, a, c); h != Mesh::null_halfedge())
    return Location{index_of(h), {{t, 1 - t - u, u}}};
  return std::nullopt;
}

/// Are two locations one point: the same vertex, or the same weights of the same vertices, whichever faces they refer to?
/// \param input the numbered mesh, or the input of a triangulation
template <class Input>
bool are_in_one_place(const Input& input, CGAL::Flip_geodesics::Surface_location a,
                      CGAL::Flip_geodesics::Surface_location b)
{
  namespace FG = CGAL::Flip_geodesics;
  a = FG::internal::canonical_location(input, a);
  b = FG::internal::canonical_location(input, b);
  const bool is_vertex = kind(a) == FG::Location_kind::VERTEX && kind(b) == FG::Location_kind::VERTEX;
  return is_vertex ? input.tail(a.halfedge) == input.tail(b.halfedge)
                   : a.halfedge == b.halfedge && a.weights == b.weights;
}

/// The location of a point of a curve.
inline CGAL::Flip_geodesics::Surface_location location_of(const Mesh& mesh,
                                                          const CGAL::Flip_geodesics::Surface_point& p)
{
  if(p.is_vertex())
    return {index_of(mesh.opposite(mesh.halfedge(mesh_vertex(p.a)))), {{1, 0, 0}}};
  return location_between(mesh, p.a, p.b, p.c, p.t, p.u).value();
}

/// A curve to compute. Two vertices of a pair need not be neighbors; those of a curve given by its edges are.
struct Curve_request
{
  std::string name;                   ///< for messages: where it comes from
  std::vector<Vertex_index> vertices; ///< a closed curve does not repeat the first
  bool is_pair = false;
  bool is_closed = false;
  std::vector<CGAL::Flip_geodesics::Surface_location> points; ///< instead of vertices: points anywhere
  bool is_drawn = false;                                      ///< are the points those of a polyline?
  std::optional<CGAL::Flip_geodesics::Spline_kind> spline;    ///< of the points, if they are control points
};

/// Curves that are shortened together, with the vertices where they are fixed; or instead the source of a tree, or a
/// request for the cut graph of the surface.
struct Network_request
{
  std::vector<Curve_request> curves;
  std::vector<Vertex_index> fixed_vertices;
  std::optional<CGAL::Flip_geodesics::Surface_location> tree_source;
  bool is_cut_graph = false;

  bool has_no_given_curves() const { return tree_source.has_value() || is_cut_graph; }
};

/// A point of the surface, and what the user calls it.
struct Named_point
{
  CGAL::Flip_geodesics::Surface_location at;
  std::string name;
};

/// A straightest geodesic that is wanted.
struct Trace_request
{
  Named_point source;
  double angle; ///< of its direction at the source, as in `Polar_coordinates`, or from the halfedge of the source
  double length;
  bool is_reversed; ///< whether the angle is measured from the opposite of this halfedge
};

/// The cut graph of the surface.
inline Network_request cut_graph_request()
{
  Network_request request;
  request.is_cut_graph = true;
  return request;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_REQUESTS_H
