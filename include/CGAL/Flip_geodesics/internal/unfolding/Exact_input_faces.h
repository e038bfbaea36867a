// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_INPUT_FACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_INPUT_FACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>

#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Input faces in exact numbers, by a halfedge that has them on its left; computed once. */
class Exact_face_cache
{
public:
  template <class Triangulation>
  const Exact_face& operator()(const Triangulation& triangulation, Input_halfedge_index h)
  {
    const auto found = m_faces.find(h);
    if(found != m_faces.end())
      return found->second;
    check_triangle(triangulation.input(), h);
    return m_faces.emplace(h, triangulation.metric().exact_face(triangulation.input(), h)).first->second;
  }

  std::size_t size() const { return m_faces.size(); }

private:
  std::unordered_map<Input_halfedge_index, Exact_face> m_faces;
};

/* The input's faces in exact numbers: those that the triangulation keeps, or others, kept for as long as this lives. */
template <class Triangulation, class = void>
class Exact_input_faces
{
public:
  explicit Exact_input_faces(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  const Exact_face& operator()(Input_halfedge_index h) const { return m_faces(m_triangulation, h); }

private:
  const Triangulation& m_triangulation;
  mutable Exact_face_cache m_faces;
};

template <class Triangulation>
class Exact_input_faces<
    Triangulation, std::void_t<decltype(std::declval<const Triangulation&>().exact_input_face(Input_halfedge_index()))>>
{
public:
  explicit Exact_input_faces(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  const Exact_face& operator()(Input_halfedge_index h) const { return m_triangulation.exact_input_face(h); }

private:
  const Triangulation& m_triangulation;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_INPUT_FACES_H
