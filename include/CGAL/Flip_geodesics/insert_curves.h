// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INSERT_CURVES_H
#define CGAL_FLIP_GEODESICS_INSERT_CURVES_H

/*!
 * \file insert_curves.h
 * \ingroup PkgFlipGeodesicsSubdivision
 * Inserts curves into a mesh in place. `Flip_geodesics.h` does not include this header, because this header includes
 * headers of the \cgal package 2D Triangulations, which is licensed under the GPL. A program that includes this header
 * is bound by the GPL.
 */

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Curve_insertion.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * Serves as the base class of visitors of `insert_curves()`; its members do nothing. Derive a visitor from this class,
 * and redefine the members that the visitor needs. The names, the parameters and the order of the calls of the members
 * are those of the corresponding members of `CGAL::Polygon_mesh_processing::Corefinement::Default_visitor`, except that
 * `before_edge_split()` and `after_edge_split()` are called once for each new vertex on an edge.
 *
 * \tparam TriangleMesh the mesh into which curves are inserted
 */
template <class TriangleMesh>
struct Default_curve_insertion_visitor
{
  /// The halfedge type of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< the face type of the mesh

  /// Called before the edge of a halfedge is split, once for each new vertex on this edge.
  void before_edge_split(halfedge_descriptor, TriangleMesh&) {}
  /// Called with the new halfedge, whose target is the new vertex, after the halfedge has been linked and the vertex
  /// has received its point.
  void edge_split(halfedge_descriptor, TriangleMesh&) {}
  /// Called after the edge has been split.
  void after_edge_split() {}
  /// Called before a face is divided. The descriptor of the face remains in use for one of the parts.
  void before_subface_creations(face_descriptor, TriangleMesh&) {}
  /// Called before a further part of the face is created.
  void before_subface_created(TriangleMesh&) {}
  /// Called with the new part, after its sides have been linked.
  void after_subface_created(face_descriptor, TriangleMesh&) {}
  /// Called when all parts of the face exist.
  void after_subface_creations(TriangleMesh&) {}
};

/// \ingroup PkgFlipGeodesicsSubdivision
/// Reports the changes made by `insert_curves()`.
struct Curve_insertion_report
{
  std::size_t new_vertices = 0;  ///< the number of new vertices
  std::size_t divided_faces = 0; ///< the number of divided faces
  std::size_t new_faces = 0;     ///< the number of new faces; a divided face remains as one of its parts, and its
                                 ///< other parts are new
  std::size_t regions = 0;       ///< the number of regions in the face patch map; 0 if no map is given
};

namespace internal {

/* Networks have their own `insert_curves()`. */
template <class T, class = void>
constexpr bool has_triangulation = false;
template <class T>
constexpr bool has_triangulation<T, std::void_t<typename T::Triangulation>> = true;

template <class T, class = void>
constexpr bool is_mutable_mesh = false;
template <class T>
constexpr bool
    is_mutable_mesh<T, std::void_t<decltype(add_edge(std::declval<T&>())), decltype(faces(std::declval<const T&>()))>> =
        !std::is_const<T>::value;

template <class NamedParameters>
constexpr bool can_mark_edges()
{
  if constexpr(is_given<NamedParameters, internal_np::edge_is_constrained_t>) {
    using Map = std::decay_t<Given<NamedParameters, internal_np::edge_is_constrained_t>>;
    return is_property_map<Map>() && !is_container_with_keys<Map>;
  } else {
    return true;
  }
}

/* Returns the given map of marked edges, or a temporary one. */
template <class TriangleMesh, class NamedParameters>
auto marked_edges(TriangleMesh& mesh, const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::edge_is_constrained_t>)
    return static_cast<void>(mesh), parameters::get_parameter(np, internal_np::edge_is_constrained);
  else
    return static_cast<void>(np), get(CGAL::dynamic_edge_property_t<bool>(), mesh);
}

template <class TriangleMesh, class NamedParameters>
auto insertion_visitor(const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
    return make_visitor(np);
  else
    return Visitor_holder<Default_curve_insertion_visitor<TriangleMesh>>{};
}

/* Returns the largest barycentric coordinate that counts as zero. */
template <class NamedParameters>
double snapping_tolerance_of(const NamedParameters& np)
{
  constexpr double largest = 1.0 / 3; // beyond that, all three coordinates of a point could be zero
  const double result = CGAL::to_double(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::snapping_tolerance), default_snap));
  if(!(result >= 0 && result < largest))
    throw Invalid_parameter_error("the snapping tolerance is " + internal::written(result) +
                                  ", but must be at least 0 and less than 1/3");
  return result;
}

/* Numbers the components of faces that marked edges separate, in the order of their first faces. */
template <class TriangleMesh, class IsMarkedMap, class FacePatchMap>
std::size_t label_regions(const TriangleMesh& mesh, IsMarkedMap is_marked, FacePatchMap patches)
{
  using Graph = boost::graph_traits<TriangleMesh>;
  using Face = typename Graph::face_descriptor;
  using Id = typename boost::property_traits<FacePatchMap>::value_type;
  auto is_known = get(CGAL::dynamic_face_property_t<bool>(), mesh);
  for(const Face f : faces(mesh))
    put(is_known, f, false);
  std::size_t result = 0;
  std::vector<Face> open;
  const auto add = [&](Face f) {
    if(f == Graph::null_face() || get(is_known, f))
      return;
    put(is_known, f, true);
    put(patches, f, static_cast<Id>(result));
    open.push_back(f);
  };
  for(const Face first : faces(mesh)) {
    if(get(is_known, first))
      continue;
    for(add(first); !open.empty();) {
      const Face f = open.back();
      open.pop_back();
      for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
        if(!get(is_marked, edge(h, mesh)))
          add(face(opposite(h, mesh), mesh));
    }
    ++result;
  }
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsSubdivision
 *
 * Inserts curves into a mesh as chains of edges, in place. The faces that curves cross, and the faces beside split
 * edges, are divided. The curves are not shortened. Optionally, the edges of the curves are marked, and each face is
 * labeled with its region. The regions are the components into which the marked edges divide the surface.
 *
 * A curve can be the output of a function of this package, or a polyline drawn by a user. A curve can be open or
 * closed; the last point of a closed curve must repeat the first. Curves are allowed to cross themselves and one
 * another, to lie on edges, to pass through vertices, and to overlap. Each crossing inside a face becomes a vertex.
 * Crossings are computed exactly, by a constrained Delaunay triangulation in the plane of each face.
 *
 * The vertices of the mesh, and the edges and faces that no curve divides, are kept with their points and properties.
 * One part of a divided face or split edge keeps the descriptor of this face or edge; the other parts are new.
 *
 * A new vertex on an edge lies on the segment between the ends of the edge, at a parameter that is rounded to `double`.
 * A new vertex in a face is an affine combination of the corners of the face. If the kernel has exact constructions,
 * these positions are computed exactly, and crossings lie exactly on both curves. With such a kernel, barycentric
 * coordinates of an exact number type are not rounded inside faces, and a part of a face is degenerate only if the face
 * itself is degenerate.
 *
 * Rounded coordinates cannot distinguish vertices that are too close to each other. Therefore a point is moved to an
 * edge if one of its barycentric coordinates is at most the snapping tolerance (\f$10^{-9}\f$ for points in space), and
 * to a vertex if two of them are. Furthermore, points are merged if they are *close* to each other. Let \f$l\f$ be the
 * length of an edge, let \f$m\f$ be the largest absolute value of a coordinate of its ends, and let \f$s\f$ be the
 * snapping tolerance given by the named parameter. Two points on the edge are close to each other if their distance is
 * at most \f$s l + 2^{-48} m\f$. In a nondegenerate face, the same bound applies, where \f$l\f$ is the length of the
 * longest side and \f$m\f$ is the largest absolute value of a coordinate of the corners. A point inside a face is moved
 * to a side if its distance from this side is at most this bound. Likewise, a segment is led through each vertex whose
 * distance from the segment is at most this bound. If \f$s\f$ is zero, however, the bound is zero: only coincident
 * points are merged, and faces of the result can be degenerate unless the kernel has exact constructions.
 *
 * The mesh is unchanged if an exception is thrown, unless memory runs out or the visitor throws the exception.
 *
 * \param mesh a model of `MutableFaceGraph`, `FaceListGraph` and `HalfedgeListGraph`, in which no two faces have the
 *        same three vertices. Faces need not be triangles except in the cases listed under `Invalid_mesh_error`
 * \param curves a range of curves, or a single one. A curve is a range of points, or has such a range as its member
 *        `locations`, like an `Isoline` or a `Voronoi_boundary`. A point is a vertex of the mesh, a
 *        `CGAL::Polygon_mesh_processing::Face_location`, a `Surface_location`, a `Surface_point`, a `Curve_point`, a
 *        `Curve_place`, a point in space, or a `std::variant` of several of these types. Any two consecutive points
 *        must lie in a common face; for other polylines, `complete_polyline()` computes the missing points. A point in
 *        space must lie on the surface up to \f$10^{-6}\f$ of the diagonal of the bounding box. It is searched for in
 *        the faces around the previous point and, if it is not found in these faces, in all faces. A curve that
 *        consists of a single point adds a vertex and no edge
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map in which the edges of curves are marked. Edges that are marked before the
 *       call remain marked; if such an edge is split, all its parts are marked}
 *     \cgalParamType{a model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as
 *       key and `bool` as value type}
 *     \cgalParamDefault{no map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{a property map that receives the number of the region of each face. Regions are numbered
 *       from 0 in the order of their first faces}
 *     \cgalParamType{a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as key
 *       and an integer as value type}
 *     \cgalParamDefault{no map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor that is called for each split edge and divided face}
 *     \cgalParamType{a class derived from `Default_curve_insertion_visitor`, which is copied unless it is passed by
 *       `std::ref()`}
 *     \cgalParamDefault{`Default_curve_insertion_visitor<TriangleMesh>`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{snapping_tolerance}
 *     \cgalParamDescription{the threshold up to which a barycentric coordinate counts as zero. For points in space,
 *       the threshold is always 10<sup>-9</sup>. The value also determines which points are merged, as described above}
 *     \cgalParamType{a number, at least 0 and below 1/3}
 *     \cgalParamDefault{10<sup>-12</sup>}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of the mesh}
 *     \cgalParamType{a model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as
 *       key and a point of a model of `Kernel` as value type}
 *     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the numbers of new vertices, divided faces, new faces and regions
 *
 * \exception Invalid_location_error if a point does not lie on the surface; if a given face is null; or if barycentric
 *            coordinates are NaN, are negative by more than the snapping tolerance, or do not sum to one within
 *            10<sup>-6</sup>. `elements()` returns the position of the curve in the range of curves, and the position
 *            of the point in the curve
 * \exception Vertex_out_of_range_error if a vertex does not belong to any face. The elements of the exception are the
 *            positions of the curve and of the vertex
 * \exception Invalid_curve_error if a curve has no points, or if two consecutive points do not lie in a common face.
 *            `elements()` returns the position of the curve and, if it has points, the position of the second of these
 *            points in the curve
 * \exception Invalid_mesh_error if a face that contains a point or a segment of a curve, or a face beside a split edge,
 *            is not a triangle. If a point or a segment lies on the boundary of several faces, at least one of these
 *            faces is checked. The exception is also thrown if a face in which a point in space is searched for is not
 *            a triangle, or if a point is given as a vertex, a `Surface_location` or a `Surface_point` and the mesh is
 *            a `Surface_mesh` that contains removed vertices or edges
 * \exception Invalid_coordinate_error if a corner of one of the faces that must be triangles has a coordinate that is
 *            not finite. In this case, `elements()` returns the position of the corner in the range of vertices
 * \exception Invalid_parameter_error if the snapping tolerance is out of range
 *
 * Complexity: \cgalBigO{n \log n} for \f$n\f$ points and crossings in total if each face contains few of them. The time
 * for a single face is at most quadratic in the number of points and crossings in this face. Labeling the regions takes
 * time linear in the size of the mesh. If points in space are not found in the faces around their previous points, the
 * search in all faces takes \cgalBigO{f \log f} time once for a mesh with \f$f\f$ faces, plus \cgalBigO{\log f} time
 * for each such point.
 *
 * \sa `cut_along_curves()`
 * \sa `Slit_mesh`
 */
template <class TriangleMesh, class CurveRange, class... NamedParameters>
std::enable_if_t<!internal::has_triangulation<TriangleMesh>, Curve_insertion_report> insert_curves(
    TriangleMesh& mesh, const CurveRange& curves, const NamedParameters&... np)
{
  static_assert(
      internal::is_mutable_mesh<TriangleMesh>,
      "the first argument of insert_curves() must be a mesh that can be changed, a model of MutableFaceGraph");
  constexpr bool are_curves = internal::is_insertable_curve<CurveRange, TriangleMesh> ||
                              internal::is_range_of_insertable_curves<CurveRange, TriangleMesh>;
  static_assert(are_curves, "the curves must be ranges of vertices, Face_locations or other points of the mesh");
  const auto& options =
      internal::options_of<internal_np::vertex_point_t, internal_np::edge_is_constrained_t, internal_np::face_patch_t,
                           internal_np::visitor_t, internal_np::snapping_tolerance_t>(np...);
  constexpr bool can_mark = internal::can_mark_edges<std::decay_t<decltype(options)>>();
  Curve_insertion_report report;
  if constexpr(internal::is_mutable_mesh<TriangleMesh> && are_curves && can_mark) { // avoids further error messages
    auto points = parameters::choose_parameter(parameters::get_parameter(options, internal_np::vertex_point),
                                               get_property_map(CGAL::vertex_point, mesh));
    const double snap = internal::snapping_tolerance_of(options);
    internal::Curve_insertion<TriangleMesh, decltype(points)> insertion(mesh, points, snap);
    internal::Curve_reader<TriangleMesh, decltype(points)>(mesh, points, snap, insertion).add_all(curves);
    insertion.arrange();
    const auto is_marked = internal::marked_edges(mesh, options);
    auto visitor = internal::insertion_visitor<TriangleMesh>(options);
    insertion.apply(is_marked, visitor.get());
    report.new_vertices = insertion.number_of_new_vertices();
    report.divided_faces = insertion.number_of_divided_faces();
    report.new_faces = insertion.number_of_new_faces();
    if constexpr(internal::is_given<std::decay_t<decltype(options)>, internal_np::face_patch_t>)
      report.regions =
          internal::label_regions(mesh, is_marked, parameters::get_parameter(options, internal_np::face_patch));
  }
  return report;
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_INSERT_CURVES_H
