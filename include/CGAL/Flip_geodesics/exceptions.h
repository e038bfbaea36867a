// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXCEPTIONS_H
#define CGAL_FLIP_GEODESICS_EXCEPTIONS_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsErrors
 *
 * The base class of everything that this package throws about its input.
 *
 * It carries the indices of the offending elements, in the order in which the message names them: positions in
 * `vertices(mesh)` for meshes, positions in the input for curves.
 */
class Error : public std::runtime_error
{
public:
  /// Says what is wrong, and where.
  /// \param message what is wrong, to be had from `what()`
  /// \param elements the indices of the offending elements, in the order of the message
  explicit Error(const std::string& message, std::vector<std::size_t> elements = {})
    : std::runtime_error(message)
    , m_elements(std::move(elements))
  {
  }

  /// The indices of the offending elements.
  const std::vector<std::size_t>& elements() const { return m_elements; }

private:
  std::vector<std::size_t> m_elements;
};

/// \ingroup PkgFlipGeodesicsErrors
/// The connectivity is not that of an oriented triangulated surface: a face is not a triangle, an edge is in no face,
/// vertices or edges of a `Surface_mesh` have been removed but are still there, or there are more elements than indices.
/// Or sheets meet in a vertex only, where the class of a curve, or the angle of directions there, is asked for. Or the
/// surface bounds no solid, where handles and tunnels are asked for. `elements()` are the vertices of the face, eight at
/// most, or of the edge, or that vertex.
class Invalid_mesh_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// What removes a degeneracy of the input.
enum class Degeneracy_remedy {
  NONE,     ///< nothing in this package
  CONTRACT, ///< contracting degenerate edges (`Zero_length_edges::CONTRACT`), or lengthening them
  MOLLIFY   ///< lengthening degenerate edges (`Mollified_metric`); contracting them does not suffice
};

/// \ingroup PkgFlipGeodesicsErrors
/// A face has an edge of length zero, or lengths that violate the triangle inequality; or faces without area hang on
/// an edge of length zero, and no surface is left when it is contracted. `elements()` are its vertices. Or rounding
/// errors in faces almost without area lead a path astray; then `elements()` is empty.
class Degenerate_face_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements

  /// Constructs the error from a problem and what removes it; `what()` names both.
  /// \param problem the first part of the message
  /// \param elements the indices of the offending elements, in the order of the message
  /// \param remedy what removes the problem
  Degenerate_face_error(const std::string& problem, std::vector<std::size_t> elements, Degeneracy_remedy remedy)
    : Error(problem + advice(remedy), std::move(elements))
    , m_problem_size(problem.size())
    , m_remedy(remedy)
  {
  }

  /// Returns the message without advice, for callers that give their own.
  std::string problem() const { return std::string(what()).substr(0, m_problem_size); }

  /// Returns what removes the problem.
  Degeneracy_remedy remedy() const { return m_remedy; }

private:
  static const char* advice(Degeneracy_remedy remedy)
  {
    switch(remedy) {
    case Degeneracy_remedy::NONE:
      return "";
    case Degeneracy_remedy::CONTRACT:
      return "; contract such edges (Zero_length_edges) or lengthen them (Mollified_metric)";
    case Degeneracy_remedy::MOLLIFY:
      return "; lengthen them (Mollified_metric)";
    }
    return "";
  }

  std::size_t m_problem_size = std::string::npos; // all of the message
  Degeneracy_remedy m_remedy = Degeneracy_remedy::NONE;
};

/// \ingroup PkgFlipGeodesicsErrors
/// A coordinate or an edge length is NaN or infinite, or so large or small that it cannot be computed with: lengths must
/// lie between 1e-70 and 1e70. Or the offset of a source is negative, not finite, or far too large for the mesh.
class Invalid_coordinate_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A number that says what is wanted is none that can be had: a level that is not finite, a tolerance that is not
/// positive or lost in roundings, a radius that is negative, bounds of a refinement that none can reach, base points of
/// loops that are isolated or two in one component. Or a distance field is not a number somewhere, or keeps nothing of
/// the place that it is asked for. `elements()` is the position of the level, the face or the base point, if there is
/// one.
class Invalid_parameter_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A vertex index is not one of the mesh's.
class Vertex_out_of_range_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// No edge path joins the two vertices in `elements()`.
class Disconnected_endpoints_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A location of a point is no point of the surface: its face or halfedge is none of the mesh's, or its weights are
/// negative, not numbers, all zero, or do not sum to one where they should; `elements()` is the halfedge if there is
/// one.
class Invalid_location_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A point in space is farther from the surface than `parameters::greatest_point_distance()` allows; `elements()` is its
/// position among the points that are given.
class Distant_point_error : public Invalid_location_error
{
public:
  using Invalid_location_error::Invalid_location_error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A point cannot be inserted: the flips of a triangulation over rounded numbers were wrong around it, or the number
/// type of the traits cannot express it there; `elements()` is the input halfedge of its location.
class Insertion_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A curve is empty or not a chain of edges of the mesh. Or a curve of a network would be a point, since all its way
/// points are in one place. Or a curve is open, and a closed one is asked for.
class Invalid_curve_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Strands of the input curves cross at the vertex in `elements()`, whatever their order on shared edges; or a segment
/// of a polyline crosses the edge of a curve between the two vertices in `elements()`.
class Crossing_curves_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// An edge would have to be flipped or split that lies under a curve of a network, or of another network than the one
/// that is changed. Nothing is changed then.
class Occupied_triangulation_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// The search for an order of overlapping curves was given up; `elements()` are the vertices of a shared edge.
class Ambiguous_order_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A number type without square roots meets an area that is not rational in the unit of areas chosen for it;
/// `elements()` are the vertices of the face, if they are known.
class Inexact_root_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A linear system has no unique solution: a component of the surface has no given value, or the numbers of its faces
/// are beyond double.
class Singular_problem_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A surface that is to be flattened is no topological disk, or a conformal factor makes a face violate the triangle
/// inequality.
class Flattening_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A file is not in the format that is expected, or of another version, or was damaged; `elements()` has the number of
/// words before the damage, if it is known.
class File_format_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// A file cannot be written: there is no place for it or not enough, nothing is to be written, or its format has no
/// numbers for that many elements.
class File_write_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// What is loaded was saved for another mesh, or another metric; or landmarks were made for one.
class Input_mismatch_error : public Error
{
public:
  using Error::Error; ///< from a message and the elements
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_EXCEPTIONS_H
