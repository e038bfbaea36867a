// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_DESCRIPTORS_H
#define CGAL_FLIP_GEODESICS_DESCRIPTORS_H

#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/iterator_facade.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsDescriptors
/// What elements are numbered by.
using Index = std::int32_t;

/// \ingroup PkgFlipGeodesicsDescriptors
/// The type of `null_index`.
struct Null_index
{
  /// The number that no element has.
  constexpr operator Index() const { return -1; }
};

/// \ingroup PkgFlipGeodesicsDescriptors
/// No element: every descriptor can be compared with it and made from it.
inline constexpr Null_index null_index{};

namespace internal {

/* The order and the printed form of the descriptors derived from it. */
template <class Derived>
struct Descriptor_operators
{
  friend constexpr bool operator==(Derived a, Derived b) { return a.idx() == b.idx(); }
  friend constexpr bool operator!=(Derived a, Derived b) { return a.idx() != b.idx(); }
  friend constexpr bool operator<(Derived a, Derived b) { return a.idx() < b.idx(); }
  friend constexpr bool operator>(Derived a, Derived b) { return a.idx() > b.idx(); }
  friend constexpr bool operator<=(Derived a, Derived b) { return a.idx() <= b.idx(); }
  friend constexpr bool operator>=(Derived a, Derived b) { return a.idx() >= b.idx(); }

  /* For Boost's hash tables; std::hash is below. */
  friend std::size_t hash_value(Derived a) { return static_cast<std::size_t>(a.idx()); }

  friend std::ostream& operator<<(std::ostream& out, Derived a) { return out << Derived::letter() << a.idx(); }
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsDescriptors
 *
 * Names one element of a triangulation or of a network: a number in a type of its own, so that a halfedge cannot be
 * given where a vertex is asked for.
 *
 * Descriptors are ordered by their numbers, can be hashed, and are printed as a letter and the number.
 *
 * \tparam Element what kind of element
 */
template <class Element>
class Descriptor : public internal::Descriptor_operators<Descriptor<Element>>
{
public:
  /// Names no element.
  constexpr Descriptor() = default;

  /// Names no element.
  constexpr Descriptor(Null_index) {}

  /// Names the element with a number.
  explicit constexpr Descriptor(Index number)
    : m_number(number)
  {
  }

  /// The number of the element, -1 if there is none.
  constexpr Index idx() const { return m_number; }

  /// Does it name an element?
  constexpr bool is_valid() const { return m_number >= 0; }

  /// What stands before the number when it is printed.
  static constexpr const char* letter() { return Element::letter; }

  /// Goes on to the next number.
  Descriptor& operator++()
  {
    ++m_number;
    return *this;
  }

private:
  Index m_number = -1;
};

namespace internal {

struct Vertex_element
{
  static constexpr const char* letter = "v";
};

struct Halfedge_element
{
  static constexpr const char* letter = "h";
};

struct Face_element
{
  static constexpr const char* letter = "f";
};

struct Input_halfedge_element
{
  static constexpr const char* letter = "input h";
};

struct Segment_element
{
  static constexpr const char* letter = "s";
};

struct Curve_element
{
  static constexpr const char* letter = "c";
};

struct Vertex_copy_element
{
  static constexpr const char* letter = "copy ";
};

} // namespace internal

/// \ingroup PkgFlipGeodesicsDescriptors
/// A vertex of a triangulation; the input's have the same numbers as in the input.
using Vertex_index = Descriptor<internal::Vertex_element>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// A halfedge of a triangulation.
using Halfedge_index = Descriptor<internal::Halfedge_element>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// A face of a triangulation, by the smallest number of its halfedges. A flip takes away two faces and makes two.
using Face_index = Descriptor<internal::Face_element>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// A halfedge of the input of a triangulation, which flips do not change.
using Input_halfedge_index = Descriptor<internal::Input_halfedge_element>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// A segment of a curve of a network.
using Segment_index = Descriptor<internal::Segment_element>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// A curve of a network.
using Curve_index = Descriptor<internal::Curve_element>;
/// \ingroup PkgFlipGeodesicsDescriptors
/// A vertex of a surface that is cut open: one of the copies of a vertex of a triangulation.
using Vertex_copy_index = Descriptor<internal::Vertex_copy_element>;

/// \ingroup PkgFlipGeodesicsDescriptors
/// An edge of a triangulation. It knows from which halfedge it was made, and is the same edge whichever it was: so
/// `source()` and `target()` of an edge that a traversal hands out are where the traversal is and where it leads.
class Edge_index : public internal::Descriptor_operators<Edge_index>
{
public:
  /// Names no edge.
  constexpr Edge_index() = default;
  /// Names no edge.
  constexpr Edge_index(Null_index) {}
  /// Names the edge with a number, from its first halfedge.
  explicit constexpr Edge_index(Index number)
    : m_halfedge(2 * number)
  {
  }
  /// Names the edge of a halfedge.
  explicit constexpr Edge_index(Halfedge_index h)
    : m_halfedge(h)
  {
  }

  /// The number of the edge, -1 if there is none.
  constexpr Index idx() const { return m_halfedge.idx() >> 1; }
  /// Does it name an edge?
  constexpr bool is_valid() const { return m_halfedge.is_valid(); }
  /// The halfedge that it was made from.
  constexpr Halfedge_index halfedge() const { return m_halfedge; }

  /// Goes on to the next number.
  Edge_index& operator++() { return *this = Edge_index(idx() + 1); }

  /// What stands before the number when it is printed.
  static constexpr const char* letter() { return "e"; }

private:
  Halfedge_index m_halfedge;
};

namespace internal {

/* The other side of the edge. */
template <class Halfedge_element>
Descriptor<Halfedge_element> twin_index(Descriptor<Halfedge_element> h)
{
  return Descriptor<Halfedge_element>(h.idx() ^ 1);
}

/* The edge of a halfedge, and its two sides. */
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

/* A halfedge whose edge was not flipped yet is one of the input's. */
inline Input_halfedge_index as_input(Halfedge_index h) { return Input_halfedge_index(h.idx()); }
inline Halfedge_index as_intrinsic(Input_halfedge_index h) { return Halfedge_index(h.idx()); }

/* An array whose subscripts are descriptors. */
template <class Key, class Array>
class Indexed_by : public Array
{
public:
  using Array::Array;
  Indexed_by() = default;

  decltype(auto) operator[](Key key) { return Array::operator[](static_cast<std::size_t>(key.idx())); }
  decltype(auto) operator[](Key key) const { return Array::operator[](static_cast<std::size_t>(key.idx())); }
};

/* Counts descriptors. */
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

/* The descriptors with the numbers below `end`. */
template <class Key>
Iterator_range<Descriptor_iterator<Key>> descriptors(Index end)
{
  return {Descriptor_iterator<Key>(0), Descriptor_iterator<Key>(end)};
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

namespace std {

/// Makes descriptors keys of unordered containers.
template <class Element>
struct hash<CGAL::Flip_geodesics::Descriptor<Element>>
{
  /// The number of the descriptor.
  size_t operator()(CGAL::Flip_geodesics::Descriptor<Element> d) const { return hash_value(d); }
};

/// Makes edges keys of unordered containers.
template <>
struct hash<CGAL::Flip_geodesics::Edge_index>
{
  /// The number of the edge.
  size_t operator()(CGAL::Flip_geodesics::Edge_index e) const { return hash_value(e); }
};

} // namespace std

#endif // CGAL_FLIP_GEODESICS_DESCRIPTORS_H
