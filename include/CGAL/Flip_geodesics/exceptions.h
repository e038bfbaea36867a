// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXCEPTIONS_H
#define CGAL_FLIP_GEODESICS_EXCEPTIONS_H

#include <cstddef>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

namespace internal {

/* Returns a number as it is written in messages, with six significant digits. */
inline std::string written(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/* Returns the name of an enumerator, given the names of all of them in their order. */
template <class Enumeration, std::size_t N>
const char* name_of(Enumeration value, const char* const (&names)[N])
{
  const auto i = static_cast<std::size_t>(value);
  return i < N ? names[i] : "";
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsErrors
 *
 * Is the base class of all exceptions that this package defines.
 *
 * An error stores numbers that identify its cause, usually the indices of the offending elements; each class of errors
 * states which. The index of an element of a mesh is its position in a range such as `vertices(mesh)`, and the index of
 * a point of a curve is its position in the curve.
 */
class Error : public std::runtime_error
{
public:
  /// Constructs the error from a message and elements.
  /// \param message the message, returned by `what()`
  /// \param elements the indices of the offending elements, in the order in which the message names them
  explicit Error(const std::string& message, std::vector<std::size_t> elements = {})
    : std::runtime_error(message)
    , m_elements(std::move(elements))
  {
  }

  /// Returns the indices of the offending elements.
  const std::vector<std::size_t>& elements() const { return m_elements; }

private:
  std::vector<std::size_t> m_elements;
};

namespace internal {

/* An element of an error, by its number. */
struct Element
{
  std::size_t number;
  std::size_t idx() const { return number; }
};

template <class T, class = void>
constexpr bool is_element = false;
template <class T>
constexpr bool is_element<T, std::void_t<decltype(std::declval<const T&>().idx())>> = true;

/* Throws an error whose message consists of the given parts. Descriptors and elements among the parts are written as
 * numbers and become the elements of the error; other numbers are only written. */
template <class Exception, class... Parts>
[[noreturn]] void throw_naming(const Parts&... parts)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  std::vector<std::size_t> elements;
  const auto add = [&](const auto& part) {
    if constexpr(is_element<std::decay_t<decltype(part)>>) {
      text << part.idx();
      elements.push_back(static_cast<std::size_t>(part.idx()));
    } else if constexpr(std::is_floating_point<std::decay_t<decltype(part)>>::value) {
      text << written(part);
    } else {
      text << part;
    }
  };
  (add(parts), ...);
  throw Exception(text.str(), std::move(elements));
}

} // namespace internal

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if the input cannot be used as an oriented triangulated surface.
///
/// The reason is one of the following:
/// - A face is not a triangle, an edge does not belong to any face, or a halfedge has no next halfedge.
/// - A `Surface_mesh` contains removed vertices or edges.
/// - There are more elements than 32-bit indices can number.
/// - A polygon soup cannot be repaired, for example because no triangle remains.
///
/// The exception is also thrown if several umbrellas meet at a vertex although a function requires a single one, and if
/// handle and tunnel loops are requested of a surface that does not bound a solid.
///
/// `elements()` returns at most eight vertices of the face if the problem lies at a face, the vertices of the edge or
/// halfedge if it lies at one of these, and the vertex if several umbrellas meet at a vertex.
class Invalid_mesh_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Specifies the remedy for a degeneracy of the input.
enum class Degeneracy_remedy {
  NONE,     ///< there is no remedy in this package
  CONTRACT, ///< contracting degenerate edges (`Zero_length_edges::CONTRACT`), or lengthening them
  MOLLIFY   ///< lengthening degenerate edges (`Mollified_metric`); contracting them does not suffice
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if degenerate faces prevent a computation, for example if a face has a degenerate edge or lengths that
/// violate the triangle inequality, if a direction is given in a degenerate face, or if degenerate edges cannot be
/// contracted. It is also thrown if, after degenerate edges have been contracted, no surface remains at a vertex, or
/// the remaining surface does not connect the ends of a curve.
///
/// The exception is also thrown if a curve is possibly bent at vertices that coincide because of degenerate faces, or
/// if rounding errors make it impossible to follow a path through almost degenerate faces.
///
/// `elements()` returns vertices, or a halfedge, at which the problem lies. It is empty if rounding errors or
/// coincident vertices cause the exception.
class Degenerate_face_error : public Error
{
public:
  /// Constructs the error from a message and the elements.
  using Error::Error;

  /// Constructs the error from a problem and its remedy, both of which become parts of the message.
  /// \param problem the first part of the message
  /// \param elements the indices of the offending elements, in the order in which the message names them
  /// \param remedy the measure that removes the problem
  Degenerate_face_error(const std::string& problem, std::vector<std::size_t> elements, Degeneracy_remedy remedy)
    : Error(problem + advice(remedy), std::move(elements))
    , m_problem_size(problem.size())
    , m_remedy(remedy)
  {
  }

  /// Returns the message without the remedy, for callers that suggest a remedy of their own.
  std::string problem() const { return std::string(what()).substr(0, m_problem_size); }

  /// Returns the remedy of the problem.
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
      return "; lengthen such edges (Mollified_metric)";
    }
    return "";
  }

  std::size_t m_problem_size = std::string::npos; // the whole message
  Degeneracy_remedy m_remedy = Degeneracy_remedy::NONE;
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if a coordinate is not finite, or if an edge length is neither zero nor a number between 1e-70 and 1e70.
/// It is also thrown if the offset of a source is negative or not finite, or if the offset is so large compared with
/// the sides of a face at the source that adding it would cause large rounding errors. In a Dirichlet problem, it is
/// thrown if a given value or density is not finite. `elements()` returns the vertex, the vertices of the edge or face,
/// or the number of the source.
class Invalid_coordinate_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if the value of a parameter is invalid: for example a level that is not finite, a tolerance that is not
/// positive or is smaller than rounding errors, a negative radius, refinement options that are out of range, an
/// isolated base point of loops, or two base points in one component. It is also thrown if a distance field returns NaN
/// or is queried at a location for which it stores no data, and if a result is requested before it has been computed.
///
/// If a level, one of the points whose mean is computed, an element of the mesh or a base point is the cause,
/// `elements()` returns its position in the given range or its index.
class Invalid_parameter_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if a vertex does not belong to the mesh, or if a vertex is isolated although a vertex of a face is
/// required. `elements()` returns the index of the vertex or its position among the given vertices, unless neither is
/// known.
class Vertex_out_of_range_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if no path connects two vertices or points. `elements()` returns the vertices or, for points, a vertex
/// near each of them. When a mean is computed, the exception is thrown if no path connects the start of the search with
/// one of the given points. In this case, `elements()` returns the position of this point.
class Disconnected_endpoints_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if a location is not a point of the surface. This is the case, for example, if its face or halfedge does
/// not belong to the mesh, if a weight is neither 0 nor in [1e-100, 1e100], if all weights are zero, or if the weights
/// must sum to one but do not.
///
/// `elements()` returns the position of the location among several given ones, or the halfedge of the location, if this
/// position or halfedge is known.
class Invalid_location_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if a point in space is farther from the surface than `parameters::greatest_point_distance()` allows;
/// `elements()` returns the position of this point among the given points.
class Distant_point_error : public Invalid_location_error
{
public:
  using Invalid_location_error::Invalid_location_error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if a point cannot be inserted. The reason can be that rounding errors have caused incorrect flips around
/// the point, that the point is too close to a vertex to be distinguished from it, or that the number type of the
/// traits cannot represent the point. `elements()` returns a halfedge of the input face or edge at which this happened.
class Insertion_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if a curve is invalid, for example because it has too few points, is or would be a single point, is not a
/// chain of edges of the mesh, has two consecutive points without a common face, is open although a closed curve is
/// required, or does not start at a required point. `elements()` returns positions in the curve, the number of the
/// curve, or vertices of the curve, if one of these identifies the problem.
class Invalid_curve_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if input curves cross in every order of their overlapping segments, or if the nodes of a curve cannot be
/// freed, for example because curves would cross. In both cases, `elements()` returns a vertex at which curves cross,
/// or one of several vertices that together make an order without crossings impossible.
///
/// The exception is also thrown if, when a polyline or curve is added, one of its segments crosses another of its
/// segments or another curve. In this case, `elements()` returns the two end points of a crossed edge.
class Crossing_curves_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if an edge would have to be flipped or split although a curve lies on it. If a network splits the edge,
/// only curves of other networks cause the exception. The edge remains unchanged. If
/// `Intrinsic_triangulation::insert()` throws the exception, `elements()` returns the halfedge of the location.
///
/// Functions that require a triangulation without curves also throw the exception.
class Occupied_triangulation_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if the search for an order of overlapping curves is aborted; `elements()` returns the two vertices of an
/// edge that the curves share.
class Ambiguous_order_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if the number type has no square roots and the area of a face is not a rational multiple of the square
/// root of the radicand, or if a mesh has no radicand. `elements()` returns the vertices of a face, if they are known.
class Inexact_root_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if a linear system cannot be solved. If its solution is not unique because no value is given in a
/// component of the surface, `elements()` returns a vertex of this component. The other possible cause is that the
/// matrix cannot be factorized in double precision because faces are too thin.
class Singular_problem_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if a surface to be flattened is not a topological disk. It is also thrown if no conformal factors are
/// found that satisfy the triangle inequality in each face, lie in the required range, and make the surface flat within
/// the tolerance. `elements()` returns the vertex to which the surface should be cut, or a vertex of a face whose
/// scaled lengths violate the triangle inequality, if such a vertex is known.
class Flattening_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if a saved network does not have the expected format or a known version, is damaged, or was written with
/// traits that compute differently. `elements()` returns the number of words before the damage, or the position of the
/// log entry that cannot be replayed, if this number is known.
class File_format_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if a file cannot be created, the disk is full, there is nothing to write, or the data cannot be
/// represented in the format.
class File_write_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

/// \ingroup PkgFlipGeodesicsErrors
/// Is thrown if loaded data, landmarks or a metric belong to a mesh or metric other than the one with which they are
/// used.
class Input_mismatch_error : public Error
{
public:
  using Error::Error; ///< constructs an error from a message and the elements
};

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_EXCEPTIONS_H
