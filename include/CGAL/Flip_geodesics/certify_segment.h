// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CERTIFY_SEGMENT_H
#define CGAL_FLIP_GEODESICS_CERTIFY_SEGMENT_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/geodesic_curves.h>
#include <CGAL/Flip_geodesics/internal/base/mistakes.h>
#include <CGAL/Flip_geodesics/internal/input/check_triangle.h>
#include <CGAL/Flip_geodesics/internal/input/check_vertex.h>
#include <CGAL/Flip_geodesics/internal/one_call/Curve_types.h>
#include <CGAL/Flip_geodesics/internal/strips/Straight_strip.h>
#include <CGAL/Flip_geodesics/internal/strips/Strip.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsFunctions
/// The verdict on a segment that is given by its ends and the edges that it crosses.
struct Segment_certificate
{
  Certificate_verdict verdict = Certificate_verdict::PROVEN; ///< `PROVEN`, `PROBABLE` or `BENT_SEGMENT`
  /// If it is bent, an angle in radians, rounded: by that an end of a crossed edge lies on the wrong side of the line
  /// through both ends in the unfolded faces, seen from the nearer of these ends; the largest. It is at most pi / 2, and
  /// small as well for an end that lies behind: a small one does not say that the segment is nearly straight. It is zero
  /// where the line touches an inner vertex whose angles add up to less than 2 pi, and means nothing where both ends
  /// unfold to one place.
  double bend = 0;
  std::size_t most_bent = 0; ///< the number of the crossed edge with that angle, from 0
  /// Where a straight segment crosses each edge, from 0 at the source of its halfedge to 1 at the target; rounded, by
  /// the length of the segment over that of the edge times a unit in the last place. None if it is bent.
  std::vector<double> places;
  Decision_statistics statistics; ///< how the comparisons were decided

  /// Is the segment straight, `PROVEN` or `PROBABLE`?
  bool is_straight() const { return verdict != Certificate_verdict::BENT_SEGMENT; }
};

namespace internal {

/* Makes a word of the crossed edges, whatever sides of them are given, and refuses what does not lead on. */
template <class Triangulation>
class Word_of_edges
{
  using Halfedge = typename boost::graph_traits<typename Triangulation::Triangle_mesh>::halfedge_descriptor;

public:
  Word_of_edges(const Triangulation& triangulation, Vertex_index source, Vertex_index target)
    : m_input(triangulation.input())
  {
    m_word.tail = source;
    m_word.head = target;
  }

  void cross(Halfedge given)
  {
    Input_halfedge_index h = given == Halfedge() ? Input_halfedge_index() : m_input.index(given);
    if(!h.is_valid() || h.idx() >= m_input.number_of_halfedges())
      refuse("is none of the mesh's");
    if(m_input.is_border(h) || m_input.is_border(twin_index(h)))
      refuse("is on the border");
    const bool is_as_given = leads_on_through(h);
    h = is_as_given ? h : twin_index(h);
    if(!is_as_given && !leads_on_through(h))
      refuse(m_word.crossed.empty() ? "is not opposite to the source" : "is not in the face behind the one before");
    m_word.crossed.push_back(h);
    m_is_as_given.push_back(is_as_given);
  }

  /* With the edge between the ends where nothing is crossed. */
  const Crossing_word& finish()
  {
    if(m_word.crossed.empty())
      m_word.along = edge_between_ends();
    else if(apex(twin_index(m_word.crossed.back())) != m_word.head)
      throw Invalid_curve_error("the target is not opposite to the last crossed edge", {element(m_word.head)});
    return m_word;
  }

  bool is_as_given(std::size_t i) const { return m_is_as_given[i]; }

private:
  template <class Descriptor>
  static std::size_t element(Descriptor d)
  {
    return static_cast<std::size_t>(d.idx());
  }

  Vertex_index apex(Input_halfedge_index h) const { return m_input.tail(m_input.next(m_input.next(h))); }

  bool leads_on_through(Input_halfedge_index h) const
  {
    if(m_word.crossed.empty())
      return apex(h) == m_word.tail;
    const Input_halfedge_index entered = twin_index(m_word.crossed.back());
    return h == m_input.next(entered) || h == m_input.next(m_input.next(entered));
  }

  Input_halfedge_index edge_between_ends() const
  {
    const Input_halfedge_index first = m_input.outgoing(m_word.tail);
    Input_halfedge_index h = first;
    do {
      if(m_input.tail(twin_index(h)) == m_word.head)
        return h;
      h = m_input.next(twin_index(h)); // along the border, too
    } while(h != first);
    throw Invalid_curve_error("no edge is crossed, and none joins the ends",
                              {element(m_word.tail), element(m_word.head)});
  }

  [[noreturn]] void refuse(const std::string& what) const
  {
    throw Invalid_curve_error("crossed edge " + std::to_string(m_word.crossed.size()) + " of the segment " + what,
                              {m_word.crossed.size()});
  }

  const typename Triangulation::Input_mesh& m_input;
  Crossing_word m_word;
  std::vector<bool> m_is_as_given;
};

/* Tells where the straight line crosses the edges, and if it does not, by what angle it misses them. */
template <class Triangulation>
void measure_segment(const Triangulation& triangulation, const Crossing_word& word,
                     const Word_of_edges<Triangulation>& edges, Segment_certificate& certificate)
{
  const Strip<Triangulation> strip(triangulation, word);
  for(std::size_t i = 0; i < strip.gates().size(); ++i) {
    if(certificate.is_straight()) {
      const double place = strip.crossing(i);
      certificate.places.push_back(edges.is_as_given(i) ? place : 1 - place);
    } else if(const double bend = strip.bend(strip.gates()[i]); bend > certificate.bend) {
      certificate.bend = bend;
      certificate.most_bent = i;
    }
  }
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Proves that a segment that was made elsewhere is straight: the line from one vertex to another across some edges. The
 * edges and ends determine the line, so places on the edges are not asked for; they are told. A path that passes
 * vertices is a chain of such segments; the angles at these vertices are not looked at.
 *
 * \param mesh a triangle mesh
 * \param source, target the ends, different vertices
 * \param crossed a range of the mesh's halfedges, of the crossed edges from `source` to `target`, either side of each;
 *        none if the segment is the edge between its ends
 * \param np named parameters: `vertex_point_map` or `with_metric()`, as for `geodesic_path()`
 * \throws Invalid_curve_error if an edge is no edge of the mesh, is on the border, or is no other edge of the face behind
 *         the one before; or if the first is not opposite to `source`. The element is its number in `crossed`
 * \throws Invalid_curve_error if the last edge is not opposite to `target`, if none is crossed and no edge joins the
 *         ends, or if these are equal. The elements are vertices
 * \throws Vertex_out_of_range_error also for a vertex that no face has
 * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
 *
 * Complexity: linear in the crossed edges, where doubles suffice; meshes other than `Surface_mesh` are indexed first,
 * \f$O(n \log n)\f$.
 */
template <class TriangleMesh, class HalfedgeRange, class NamedParameters = parameters::Default_named_parameters>
Segment_certificate certify_segment(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                    Mesh_vertex<TriangleMesh> target, const HalfedgeRange& crossed,
                                    const NamedParameters& np = parameters::default_values())
{
  using Triangulation = typename internal::Curve_types<TriangleMesh, NamedParameters>::Triangulation;
  static_assert(internal::is_range_of<HalfedgeRange, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>,
                "what is crossed is no range of halfedges of the mesh");
  const Triangulation triangulation = internal::make_triangulation(mesh, np);
  const Vertex_index tail = triangulation.index(source), head = triangulation.index(target);
  for(Vertex_index v : {tail, head}) {
    internal::check_vertex(v, triangulation.input().number_of_vertices());
    if(triangulation.input().outgoing(v) == null_index)
      throw Vertex_out_of_range_error("a segment ends at vertex " + std::to_string(v.idx()) + ", which no face has",
                                      {static_cast<std::size_t>(v.idx())});
  }
  if(tail == head)
    throw Invalid_curve_error("the ends of a segment are one vertex", {static_cast<std::size_t>(tail.idx())});
  internal::Word_of_edges<Triangulation> edges(triangulation, tail, head);
  for(const auto& h : crossed)
    edges.cross(h);
  const Crossing_word& word = edges.finish();
  Segment_certificate result;
  for(Input_halfedge_index h : word.crossed)
    for(Input_halfedge_index side : {h, internal::twin_index(h)})
      internal::check_triangle(triangulation.input(), side);
  if(!internal::Straight_strip<Triangulation>(triangulation, result.statistics)(word))
    result.verdict = Certificate_verdict::BENT_SEGMENT;
  else if(result.statistics.unproven_zeros > 0)
    result.verdict = Certificate_verdict::PROBABLE;
  internal::measure_segment(triangulation, word, edges, result);
  return result;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CERTIFY_SEGMENT_H
