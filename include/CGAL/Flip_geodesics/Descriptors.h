// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_DESCRIPTORS_H
#define CGAL_FLIP_GEODESICS_DESCRIPTORS_H

#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/iterator_facade.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsDescriptors
/// The integer type of the numbers that identify elements, and of counts of elements.
using Index = std::int32_t;

/// \ingroup PkgFlipGeodesicsDescriptors
/// The type of `null_index`.
struct Null_index
{
  /// Returns -1, a number that no element has.
  constexpr operator Index() const { return -1; }
};

/// \ingroup PkgFlipGeodesicsDescriptors
/// The null value: descriptors of every type can be constructed from it and compared with it.
inline constexpr Null_index null_index{};

/*!
 * \ingroup PkgFlipGeodesicsDescriptors
 *
 * Identifies one element of a mesh, a triangulation or a network by its number. Each kind of element has a descriptor
 * type of its own, so a halfedge cannot be passed by mistake instead of a vertex.
 *
 * Descriptors are ordered by their numbers, can be hashed, and are printed as a prefix, such as `v`, followed by the
 * number.
 *
 * \tparam Element the kind of element, one of the classes in `Element_kind`
 */
template <class Element>
class Descriptor
{
public:
  /// Constructs a null descriptor.
  constexpr Descriptor() = default;

  /// Constructs a null descriptor.
  constexpr Descriptor(Null_index) {}

  /// Constructs the descriptor of the element with a given number.
  explicit constexpr Descriptor(Index number)
    : m_number(number)
  {
  }

  /// Returns the number of the element, or -1 for a null descriptor.
  constexpr Index idx() const { return m_number; }

  /// Returns whether the descriptor is not null.
  constexpr bool is_valid() const { return m_number >= 0; }

  /// Returns the prefix that is printed before the number.
  static constexpr const char* letter() { return Element::letter; }

  /// Increments the number.
  Descriptor& operator++()
  {
    ++m_number;
    return *this;
  }

  /// \cond
  friend constexpr bool operator==(Descriptor a, Descriptor b) { return a.idx() == b.idx(); }
  friend constexpr bool operator!=(Descriptor a, Descriptor b) { return a.idx() != b.idx(); }
  friend constexpr bool operator<(Descriptor a, Descriptor b) { return a.idx() < b.idx(); }
  friend constexpr bool operator>(Descriptor a, Descriptor b) { return a.idx() > b.idx(); }
  friend constexpr bool operator<=(Descriptor a, Descriptor b) { return a.idx() <= b.idx(); }
  friend constexpr bool operator>=(Descriptor a, Descriptor b) { return a.idx() >= b.idx(); }
  friend std::size_t hash_value(Descriptor a) { return static_cast<std::size_t>(a.idx()); }
  friend std::ostream& operator<<(std::ostream& out, Descriptor a) { return out << letter() << a.idx(); }
  /// \endcond

private:
  Index m_number = -1;
};

/// \ingroup PkgFlipGeodesicsDescriptors
/// Lists the kinds of elements that a `Descriptor` can identify, each with the prefix that is printed before the
/// number.
struct Element_kind
{
  // clang-format off
  /// The kind of element that `Vertex_index` identifies.
  struct Vertex { static constexpr const char* letter = "v"; /**< the prefix */ };
  /// The kind of element that `Halfedge_index` identifies.
  struct Halfedge { static constexpr const char* letter = "h"; /**< the prefix */ };
  /// The kind of element that `Face_index` identifies.
  struct Face { static constexpr const char* letter = "f"; /**< the prefix */ };
  /// The kind of element that `Input_halfedge_index` identifies.
  struct Input_halfedge { static constexpr const char* letter = "input h"; /**< the prefix */ };
  /// The kind of element that `Segment_index` identifies.
  struct Segment { static constexpr const char* letter = "s"; /**< the prefix */ };
  /// The kind of element that `Curve_index` identifies.
  struct Curve { static constexpr const char* letter = "c"; /**< the prefix */ };
  /// The kind of element that `Vertex_copy_index` identifies.
  struct Vertex_copy { static constexpr const char* letter = "copy "; /**< the prefix */ };
  // clang-format on
};

/// \ingroup PkgFlipGeodesicsDescriptors
/// Identifies a vertex of a triangulation. Vertices of the input have the same numbers as in the input.
using Vertex_index = Descriptor<Element_kind::Vertex>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// Identifies a halfedge of a triangulation.
using Halfedge_index = Descriptor<Element_kind::Halfedge>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// Identifies a face of a triangulation by the number of its lowest-numbered halfedge. A flip replaces two faces by two
/// others, whose numbers can differ from those of the replaced faces.
using Face_index = Descriptor<Element_kind::Face>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// Identifies a halfedge of the input of a triangulation. Flips do not change the input.
using Input_halfedge_index = Descriptor<Element_kind::Input_halfedge>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// Identifies a segment of a curve of a network.
using Segment_index = Descriptor<Element_kind::Segment>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// Identifies a curve of a network.
using Curve_index = Descriptor<Element_kind::Curve>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// Identifies a vertex of a cut surface, that is, one of the copies of a vertex of a triangulation.
using Vertex_copy_index = Descriptor<Element_kind::Vertex_copy>;

/// \ingroup PkgFlipGeodesicsDescriptors
/// Identifies an edge of a triangulation. The descriptor also stores one of the two halfedges of the edge. Comparisons
/// of descriptors ignore this halfedge. The `source()` of an edge is the tail of the stored halfedge, and the
/// `target()` is its head. The edges of `out_edges(v, triangulation)` therefore have the source `v`, and those of
/// `in_edges(v, triangulation)` have the target `v`.
class Edge_index
{
public:
  /// Constructs a null descriptor.
  constexpr Edge_index() = default;
  /// Constructs a null descriptor.
  constexpr Edge_index(Null_index) {}
  /// Constructs the descriptor of the edge with a given number, and stores the first halfedge of this edge.
  explicit constexpr Edge_index(Index number)
    : m_halfedge(2 * number)
  {
  }
  /// Constructs the descriptor of the edge of a halfedge, and stores this halfedge.
  explicit constexpr Edge_index(Halfedge_index h)
    : m_halfedge(h)
  {
  }

  /// Returns the number of the edge, or -1 for a null descriptor.
  constexpr Index idx() const { return m_halfedge.idx() >> 1; }
  /// Returns whether the descriptor is not null.
  constexpr bool is_valid() const { return m_halfedge.is_valid(); }
  /// Returns the stored halfedge.
  constexpr Halfedge_index halfedge() const { return m_halfedge; }

  /// Increments the number.
  Edge_index& operator++() { return *this = Edge_index(idx() + 1); }

  /// \cond
  friend constexpr bool operator==(Edge_index a, Edge_index b) { return a.idx() == b.idx(); }
  friend constexpr bool operator!=(Edge_index a, Edge_index b) { return a.idx() != b.idx(); }
  friend constexpr bool operator<(Edge_index a, Edge_index b) { return a.idx() < b.idx(); }
  friend constexpr bool operator>(Edge_index a, Edge_index b) { return a.idx() > b.idx(); }
  friend constexpr bool operator<=(Edge_index a, Edge_index b) { return a.idx() <= b.idx(); }
  friend constexpr bool operator>=(Edge_index a, Edge_index b) { return a.idx() >= b.idx(); }
  friend std::size_t hash_value(Edge_index a) { return static_cast<std::size_t>(a.idx()); }
  friend std::ostream& operator<<(std::ostream& out, Edge_index a) { return out << "e" << a.idx(); }
  /// \endcond

private:
  Halfedge_index m_halfedge;
};

namespace internal {

template <class Halfedge_element>
Descriptor<Halfedge_element> twin_index(Descriptor<Halfedge_element> h)
{
  return Descriptor<Halfedge_element>(h.idx() ^ 1);
}

inline Edge_index edge_of(Halfedge_index h) { return Edge_index(h); }
inline Halfedge_index first_side(Edge_index e) { return Halfedge_index(e.halfedge().idx() & ~1); }
template <class Halfedge_element>
bool are_of_one_edge(Descriptor<Halfedge_element> g, Descriptor<Halfedge_element> h)
{
  return (g.idx() >> 1) == (h.idx() >> 1);
}
template <class Halfedge_element>
bool is_first_side(Descriptor<Halfedge_element> h)
{
  return (h.idx() & 1) == 0;
}

/* Convert a halfedge whose edge has not been flipped to one of the input and back. */
inline Input_halfedge_index as_input(Halfedge_index h) { return Input_halfedge_index(h.idx()); }
inline Halfedge_index as_intrinsic(Input_halfedge_index h) { return Halfedge_index(h.idx()); }

template <class Key, class Array>
class Indexed_by : public Array
{
public:
  using Array::Array;
  Indexed_by() = default;

  decltype(auto) operator[](Key key) { return Array::operator[](static_cast<std::size_t>(key.idx())); }
  decltype(auto) operator[](Key key) const { return Array::operator[](static_cast<std::size_t>(key.idx())); }
};

template <class Key>
class Descriptor_iterator
  : public boost::iterator_facade<Descriptor_iterator<Key>, Key, std::random_access_iterator_tag, Key>
{
public:
  Descriptor_iterator() = default;
  explicit Descriptor_iterator(Index number)
    : m_number(number)
  {
  }

private:
  friend class boost::iterator_core_access;

  Key dereference() const { return Key(m_number); }
  bool equal(const Descriptor_iterator& other) const { return m_number == other.m_number; }
  void increment() { ++m_number; }
  void decrement() { --m_number; }
  void advance(std::ptrdiff_t n) { m_number += static_cast<Index>(n); }
  std::ptrdiff_t distance_to(const Descriptor_iterator& other) const { return other.m_number - m_number; }

  Index m_number = 0;
};

template <class Key>
Iterator_range<Descriptor_iterator<Key>> descriptors(Index end)
{
  return {Descriptor_iterator<Key>(0), Descriptor_iterator<Key>(end)};
}

} // namespace internal
} // namespace CGAL::Flip_geodesics

namespace std {

/// Allows descriptors as keys of unordered containers.
template <class Element>
struct hash<CGAL::Flip_geodesics::Descriptor<Element>>
{
  /// Returns the hash value of a descriptor, which is its number.
  size_t operator()(CGAL::Flip_geodesics::Descriptor<Element> d) const { return hash_value(d); }
};

/// Allows edge descriptors as keys of unordered containers.
template <>
struct hash<CGAL::Flip_geodesics::Edge_index>
{
  /// Returns the hash value of an edge, which is its number.
  size_t operator()(CGAL::Flip_geodesics::Edge_index e) const { return hash_value(e); }
};

} // namespace std

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * Describes the input edges that an intrinsic edge crosses, in order from the tail to the head of the intrinsic edge.
 * The edge sequence and the end points determine the intrinsic edge: it is the straight line between its end points
 * after the crossed faces are unfolded into the plane.
 *
 * Three cases are possible. If the intrinsic edge is an input edge or a part of one, `along` is the halfedge of this
 * input edge that has the direction of the intrinsic edge. If the intrinsic edge lies inside an input face, `face` is a
 * halfedge of this face; at least one end of the intrinsic edge is then an inserted vertex. In all other cases,
 * `crossed` contains one halfedge of each crossed input edge: the halfedge in the face that the intrinsic edge leaves
 * at this crossing. In each case, the other two of the members `along`, `face` and `crossed` are null or empty.
 */
struct Edge_sequence
{
  Input_halfedge_index along = null_index;   ///< the input halfedge along which the edge lies, if any
  std::vector<Input_halfedge_index> crossed; ///< the crossed input edges in order, if any
  Input_halfedge_index face = null_index;    ///< a halfedge of the face inside which the edge lies, if any
  Vertex_index tail = null_index;            ///< the vertex at which the edge starts
  Vertex_index head = null_index;            ///< the vertex at which the edge ends

  /// Reverses the edge sequence, and thus the direction of the edge.
  void reverse()
  {
    along = along == null_index ? null_index : internal::twin_index(along);
    std::swap(tail, head);
    std::reverse(crossed.begin(), crossed.end());
    for(Input_halfedge_index& h : crossed)
      h = internal::twin_index(h);
  }

  /// Returns the edge sequence of the edge in the opposite direction.
  Edge_sequence reversed() const
  {
    Edge_sequence result = *this;
    result.reverse();
    return result;
  }

  /// Returns a halfedge of the input face in which the edge starts. \pre the edge does not lie along an input edge
  Input_halfedge_index first_face() const { return crossed.empty() ? face : crossed.front(); }
  /// Returns a halfedge of the input face in which the edge ends. \pre the edge does not lie along an input edge
  Input_halfedge_index last_face() const { return crossed.empty() ? face : internal::twin_index(crossed.back()); }
};

/// \ingroup PkgFlipGeodesicsCurves
/// Specifies a side of a curve, as seen in the direction of the curve.
enum class Side { LEFT, RIGHT };

/// \ingroup PkgFlipGeodesicsCurves
/// Returns the opposite side.
inline Side opposite_side(Side side) { return side == Side::LEFT ? Side::RIGHT : Side::LEFT; }

/// \ingroup PkgFlipGeodesicsCurves
/// Identifies one side of the joint between a segment and the next segment of its curve.
struct Joint
{
  Segment_index incoming; ///< the segment that arrives at the node
  Side side;              ///< the side of the curve
};

/// \ingroup PkgFlipGeodesicsCurves
/// Identifies the end of a segment at a node by the segment and an outgoing halfedge. The halfedge distinguishes the
/// two ends of a segment that starts and ends at the same vertex.
struct Segment_end
{
  Halfedge_index halfedge = null_index; ///< the outgoing halfedge at the node; null for a null end
  Segment_index segment = null_index;   ///< the segment that starts or ends at the node, on the edge of `halfedge`

  /// Returns whether this is a null end, which does not identify the end of any segment.
  bool is_none() const { return halfedge == null_index; }
  /// Returns whether the two segment ends are equal.
  bool operator==(const Segment_end& other) const { return halfedge == other.halfedge && segment == other.segment; }
  /// Returns whether the two segment ends differ.
  bool operator!=(const Segment_end& other) const { return !(*this == other); }
};

/// \ingroup PkgFlipGeodesicsCurves
/// Describes the wedge on one side of a joint. The wedge extends clockwise from its first end to its second; see
/// `Edge_path_network::ends()`.
enum class Wedge_state {
  FREE,     ///< the wedge is empty, and its angle is below \f$\pi\f$: the curve can be shortened at the joint
  STRAIGHT, ///< the angle is at least \f$\pi\f$
  BLOCKED,  ///< another segment, or an edge held by another network, lies in the wedge,
            ///< at an angle below \f$\pi\f$ from the first end
  BORDER,   ///< the border of the surface lies in the wedge, at an angle below \f$\pi\f$ from the first end
  FIXED     ///< the node is fixed, and the wedge is not inspected
};

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_DESCRIPTORS_H
