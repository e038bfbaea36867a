// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NUMBERED_SURFACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NUMBERED_SURFACE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>

namespace CGAL::Flip_geodesics::internal {

/* The indices of a surface that is numbered already and is its own mesh, as base of its `Indexed_mesh`. */
template <class Surface>
class Numbered_surface : public Possibly_contracted<Indexed_mesh<Surface>>
{
public:
  using vertex_descriptor = Vertex_index;
  using halfedge_descriptor = Input_halfedge_index;

  explicit Numbered_surface(const Surface& surface)
    : m_surface(&surface)
  {
  }

  const Surface& surface() const { return *m_surface; }
  const Surface& mesh() const { return *m_surface; }

  Index number_of_vertices() const { return m_surface->number_of_vertices(); }
  Index number_of_halfedges() const { return m_surface->number_of_halfedges(); }
  Index number_of_faces() const { return m_surface->number_of_faces(); }
  Vertex_index vertex(Vertex_index v) const { return v; }
  Input_halfedge_index halfedge(Input_halfedge_index h) const { return h; }
  Vertex_index index(Vertex_index v) const { return v; }
  Input_halfedge_index index(Input_halfedge_index h) const { return h; }
  Input_halfedge_index next(Input_halfedge_index h) const { return m_surface->next(h); }
  Input_halfedge_index previous(Input_halfedge_index h) const { return m_surface->previous(h); }
  bool is_triangle(Input_halfedge_index h) const { return next(next(h)) == previous(h); }
  Vertex_index tail(Input_halfedge_index h) const { return m_surface->tail(h); }
  bool is_border(Input_halfedge_index h) const { return m_surface->is_border(h); }
  Input_halfedge_index outgoing(Vertex_index v) const { return m_surface->outgoing(v); }

private:
  const Surface* m_surface;
};

/* What the library uses of the metric of such a surface: its public members. */
template <class Metric>
struct Internals_of_members
{
  static constexpr bool has_exact_faces = true;
  static constexpr bool has_usable_faces = true;

  template <class... Arguments>
  static Exact_face exact_face(const Metric& metric, const Arguments&... arguments)
  {
    return metric.exact_face(arguments...);
  }
  template <class... Arguments>
  static bool sine_in_plane(const Metric& metric, Arguments&... arguments)
  {
    return metric.sine_in_plane(arguments...);
  }
  template <class... Arguments>
  static auto vector(const Metric& metric, const Arguments&... arguments)
  {
    return metric.vector(arguments...);
  }
  template <class... Arguments>
  static bool is_usable_face(const Metric& metric, const Arguments&... arguments)
  {
    return metric.is_usable_face(arguments...);
  }
};

/* A face of such a surface, by one of its halfedges. */
struct Numbered_face
{
  Input_halfedge_index halfedge;

  friend bool operator==(Numbered_face a, Numbered_face b) { return a.halfedge == b.halfedge; }
  friend bool operator!=(Numbered_face a, Numbered_face b) { return !(a == b); }
};

template <class Surface>
Input_halfedge_index halfedge(Numbered_face f, const Surface&)
{
  return f.halfedge;
}

/* The graph traits of such a surface. */
struct Numbered_surface_traits
{
  using vertex_descriptor = Vertex_index;
  using halfedge_descriptor = Input_halfedge_index;
  using face_descriptor = Numbered_face;

  static halfedge_descriptor null_halfedge() { return halfedge_descriptor(); }
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NUMBERED_SURFACE_H
