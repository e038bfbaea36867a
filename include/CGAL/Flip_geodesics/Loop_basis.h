// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_LOOP_BASIS_H
#define CGAL_FLIP_GEODESICS_LOOP_BASIS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>
#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>
#include <CGAL/Flip_geodesics/internal/topology/Solid_loops.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The side of a face from its corner at a vertex on: of an inserted vertex, a corner that it is next to, the same in all
 * faces. `anchor` tells the vertex in the face. */
template <class Triangulation>
Input_halfedge_index corner_next_to(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index anchor)
{
  const bool is_at_other_end =
      vertex_kind(triangulation, v) == Location_kind::EDGE && triangulation.location(v).halfedge != anchor;
  return is_at_other_end ? triangulation.input().next(anchor) : anchor;
}

/* Does a vertex on an input halfedge, or at an end of it, count as its start? */
template <class Triangulation>
bool is_next_to_start(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index along, bool is_tail)
{
  return triangulation.is_inserted(v) ? triangulation.location(v).halfedge == along : is_tail;
}

/*
 * Writes input halfedges along which an edge of the triangulation can be moved, by its word, with its ends held.
 * Inserted vertices are moved to the corners that they are next to, so that edges put together remain so.
 *
 *      u ---- r        crossed: c from p to q. From u to p, and on along the tails of what is crossed.
 *       \    /.
 *     c  q--p
 */
template <class Triangulation>
void append_input_edges(const Triangulation& triangulation, const Crossing_word& word,
                        std::vector<Input_halfedge_index>& result)
{
  const auto& input = triangulation.input();
  if(word.along != null_index) {
    const bool from_start = is_next_to_start(triangulation, word.tail, word.along, true);
    const bool to_start = is_next_to_start(triangulation, word.head, word.along, false);
    if(from_start != to_start)
      result.push_back(from_start ? word.along : twin_index(word.along));
    return;
  }
  // Around the left face of `from`, to where `to` starts.
  const auto turn = [&](Input_halfedge_index from, Input_halfedge_index to) {
    if(input.next(from) == to)
      result.push_back(from);
    else if(input.next(to) == from)
      result.push_back(twin_index(to));
  };
  Input_halfedge_index corner = corner_next_to(triangulation, word.tail, tail_anchor(triangulation, word));
  for(Input_halfedge_index c : word.crossed) {
    turn(corner, c);
    corner = input.next(twin_index(c)); // starts where c does
  }
  turn(corner, corner_next_to(triangulation, word.head, head_anchor(triangulation, word)));
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * A basis of the closed curves of a surface, along edges of the input mesh, and the class of any closed curve in it.
 *
 * Each component of genus g with b borders has 2g loops if b = 0, and 2g + b - 1 otherwise. All loops of a component
 * pass one vertex, its base point. Of all loops through the base point along edges they are the shortest that generate:
 * a greedy choice is optimal [EW05], for the fundamental group and for homology alike. Another base point has another
 * basis. Lengths are those of the metric.
 *
 * The class reads the input alone, so that it stays valid whatever is flipped, and touches no triangulation.
 *
 * Construction takes \f$O(n \log n)\f$ time and linear memory.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`
 */
template <class Triangulation>
class Loop_basis
{
public:
  /// The coefficients of a class, one for each loop of the basis.
  using Homology_class = std::vector<std::int64_t>;

  /// A component of the surface.
  struct Component
  {
    Vertex_index base_point; ///< what its loops pass
    Index genus;             ///< the number of handles
    Index number_of_borders; ///< the number of its border loops
    Index first_loop;        ///< the first of its loops
    Index number_of_loops;   ///< how many loops it has, which are numbered in a row
  };

  /*!
   * Makes a basis with the first vertex of each component as base point.
   * \param triangulation over the surface; must outlive the basis
   * \throws Invalid_mesh_error if the mesh is no surface of triangles; vertices in which sheets meet are none
   * \throws Invalid_coordinate_error
   */
  explicit Loop_basis(const Triangulation& triangulation)
    : Loop_basis(triangulation, std::vector<Vertex_index>())
  {
  }

  /*!
   * Makes a basis.
   * \param triangulation as above
   * \param base_points vertices, at most one in each component; where there is none, the component's first is taken
   * \throws Vertex_out_of_range_error
   * \throws Invalid_parameter_error for two base points in one component, and for an isolated one
   */
  template <class VertexRange>
  Loop_basis(const Triangulation& triangulation, const VertexRange& base_points)
    : m_triangulation(&triangulation)
  {
    make(base_points, nullptr);
  }

  /*!
   * Makes a basis, and lets a visitor stop that.
   * \param triangulation, base_points as above
   * \param visitor a model of `FlipOutVisitor`, of which only `go_further()` is called, at regular intervals. If it
   *        returns `false`, then `is_complete()` returns `false`, and there are neither loops nor components
   * \throws as above
   */
  template <class VertexRange, class Visitor>
  Loop_basis(const Triangulation& triangulation, const VertexRange& base_points, Visitor&& visitor)
    : m_triangulation(&triangulation)
  {
    internal::Interruption interruption(visitor);
    if(!internal::result_unless_interrupted([&] { return make(base_points, &interruption), true; }))
      forget_all();
  }

  /// Returns whether this is a basis; it is not if a visitor stopped the construction. Then only the numbers of loops
  /// and components, zero, can be asked for.
  bool is_complete() const { return m_is_complete; }

  /// \name Loops
  /// @{

  /// The number of loops, of all components.
  Index number_of_loops() const { return static_cast<Index>(m_cotree.generators().size()); }

  /// The halfedges of a loop, from its base point back to it: for `Edge_path_network::add_curve()`, before any edge is
  /// flipped. The loops of one component, as open curves with fixed ends, do not cross each other.
  std::vector<Halfedge_index> loop(Index i) const
  {
    return m_forest.loop(m_triangulation->input(), generator(i).halfedge);
  }

  /// The same loop without what it goes out and back: a closed curve that passes no vertex twice.
  std::vector<Halfedge_index> cycle(Index i) const
  {
    return m_forest.cycle(m_triangulation->input(), generator(i).halfedge);
  }

  /// The length of `loop(i)`. The loops of a component are ordered by it.
  double length(Index i) const { return generator(i).length; }

  /// @}
  /// \name Components
  /// @{

  /// The components that have faces, in the order of the base points given, then of their first vertices.
  const std::vector<Component>& components() const { return m_components; }

  /// The position of a vertex's component in `components()`, -1 for an isolated vertex. \pre `v` is an input vertex
  Index component(Vertex_index v) const { return m_forest.component(v); }

  /// @}
  /// \name Classes of closed curves
  /// @{

  /*!
   * The homology class of a closed chain of halfedges of the input: how often it runs along each loop of the basis, up
   * to what bounds a part of the surface. Integers, exact. It does not change when a curve is pulled tight.
   *
   * \param halfedges a range of `Input_halfedge_index`, a closed chain; an empty one has class zero. That of a halfedge
   *        `h` of the mesh is `triangulation.input().index(h)`. A `Halfedge_index` is one of the intrinsic triangulation
   *        and does not convert; a curve of these is told as one of a network
   * \throws Invalid_curve_error if it is none
   *
   * Complexity: linear in the chain, times the genus and the number of borders at most.
   */
  template <class HalfedgeRange>
  Homology_class homology_class(const HalfedgeRange& halfedges) const
  {
    check_closed_chain(halfedges);
    Homology_class result(static_cast<std::size_t>(number_of_loops()), 0);
    for(Input_halfedge_index h : halfedges)
      m_words.for_each_letter(h, [&](internal::Letter letter) {
        result[static_cast<std::size_t>(letter / 2)] += letter % 2 == 0 ? 1 : -1;
      });
    return result;
  }

  /*!
   * The same of a curve of a network over this input, whatever was flipped and inserted; zero if it has contracted.
   * \throws Invalid_curve_error for a curve that does not end where it starts
   * \pre the network's triangulation has the same input
   */
  template <class Network>
  Homology_class homology_class(const Network& network, Curve_index curve) const
  {
    return homology_class(input_edges(network, curve));
  }

  /*!
   * Can the curve be contracted to a point on the surface? Decided in the fundamental group: by cancelling in the free
   * group where the component has a border, by counting on a torus, and by Dehn's algorithm on other closed surfaces.
   * Exact. A curve of class zero need not be contractible: one that separates two handles is not.
   *
   * Complexity: as `homology_class()`. Parameters and errors as there.
   */
  template <class HalfedgeRange>
  bool is_contractible(const HalfedgeRange& halfedges) const
  {
    check_closed_chain(halfedges);
    std::vector<internal::Letter> word;
    Index component = -1;
    for(Input_halfedge_index h : halfedges) {
      component = m_forest.component(m_triangulation->input().tail(h));
      m_words.for_each_letter(h, [&](internal::Letter letter) { word.push_back(letter); });
    }
    return component < 0 || m_groups[static_cast<std::size_t>(component)].is_neutral(std::move(word));
  }

  /// The same of a curve of a network, as above.
  template <class Network>
  bool is_contractible(const Network& network, Curve_index curve) const
  {
    return is_contractible(input_edges(network, curve));
  }

  /// @}

private:
  using Halfedges = std::vector<Halfedge_index>;

  static const auto& checked_input(const Triangulation& triangulation)
  {
    internal::check_surface(triangulation.input());
    return triangulation.input();
  }

  static auto weight(const Triangulation& triangulation)
  {
    return [&triangulation](Input_halfedge_index h) { return triangulation.metric().weight(triangulation.input(), h); };
  }

  template <class VertexRange>
  void make(const VertexRange& base_points, internal::Interruption* interruption)
  {
    static_assert(internal::is_range_of<VertexRange, Vertex_index>,
                  "the base points are not a range of vertices of the triangulation, Vertex_index");
    const auto& input = checked_input(*m_triangulation);
    const auto length = weight(*m_triangulation);
    m_forest = internal::Edge_forest(input, base_points, length, interruption);
    m_cotree = internal::Cotree(input, m_forest, internal::Borders::CLOSED_BY_ONE_FACE, length, interruption);
    m_words = internal::Generator_words(input, m_forest, m_cotree, interruption);
    describe_components();
  }

  void forget_all()
  {
    m_forest = internal::Edge_forest();
    m_cotree = internal::Cotree();
    m_words = internal::Generator_words();
    m_is_complete = false;
  }

  void describe_components()
  {
    const auto& input = m_triangulation->input();
    for(Vertex_index v : m_forest.roots())
      m_components.push_back({v, 0, 0, 0, 0});
    for(const internal::Cotree::Loop& loop : m_cotree.generators())
      ++m_components[static_cast<std::size_t>(loop.component)].number_of_loops;
    internal::for_each_border(input, [&](const Halfedges& border) {
      const Index c = m_forest.component(input.tail(internal::as_input(border.front())));
      ++m_components[static_cast<std::size_t>(c)].number_of_borders;
    });
    Index first_loop = 0;
    for(Component& c : m_components) {
      c.first_loop = first_loop;
      first_loop += c.number_of_loops;
      c.genus = (c.number_of_loops - (std::max)(0, c.number_of_borders - 1)) / 2;
      m_groups.emplace_back(m_words.relation(static_cast<Index>(m_groups.size())));
    }
  }

  const internal::Cotree::Loop& generator(Index i) const
  {
    CGAL_precondition(i >= 0 && i < number_of_loops());
    return m_cotree.generators()[static_cast<std::size_t>(i)];
  }

  template <class HalfedgeRange>
  void check_closed_chain(const HalfedgeRange& halfedges) const
  {
    static_assert(internal::is_range_of<HalfedgeRange, Input_halfedge_index>,
                  "the curve is not a range of halfedges of the input, Input_halfedge_index");
    const auto& input = m_triangulation->input();
    Vertex_index start = null_index, end = null_index;
    std::size_t position = 0;
    for(Input_halfedge_index h : halfedges) {
      if(!h.is_valid() || h.idx() >= input.number_of_halfedges())
        throw Invalid_curve_error("a curve has a halfedge that the mesh does not have", {position});
      if(end != null_index && input.tail(h) != end)
        throw Invalid_curve_error("a curve is not connected at position " + std::to_string(position), {position});
      start = start == null_index ? input.tail(h) : start;
      end = input.tail(internal::twin_index(h));
      ++position;
    }
    if(start != end)
      throw Invalid_curve_error("a curve that does not end where it starts has no class", {position});
  }

  template <class Network>
  std::vector<Input_halfedge_index> input_edges(const Network& network, Curve_index curve) const
  {
    const auto& triangulation = network.triangulation();
    CGAL_precondition_msg(triangulation.input().number_of_halfedges() == m_triangulation->input().number_of_halfedges(),
                          "the network lies over another mesh");
    std::vector<Input_halfedge_index> result;
    Vertex_index start = null_index, end = null_index;
    network.for_each_segment(curve, [&](Segment_index s) {
      const Crossing_word word = triangulation.crossing_word(network.halfedge(s));
      start = start == null_index ? word.tail : start;
      end = word.head;
      internal::append_input_edges(triangulation, word, result);
    });
    if(start != end)
      throw Invalid_curve_error("a curve that does not end where it starts has no class");
    return result;
  }

  const Triangulation* m_triangulation;
  internal::Edge_forest m_forest;
  internal::Cotree m_cotree;
  internal::Generator_words m_words;
  std::vector<Component> m_components;
  std::vector<internal::Surface_group> m_groups; // by component
  bool m_is_complete = true;
};

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Writes the borders of a surface, each as a closed chain of halfedges with the surface on the left, a
 * `std::vector<Halfedge_index>`: by their smallest edges, the first of which each begins with. Linear in the mesh.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`, whose edges are the input's
 * \throws Invalid_mesh_error as `Loop_basis`
 */
template <class Triangulation, class OutputIterator>
OutputIterator border_loops(const Triangulation& triangulation, OutputIterator out)
{
  internal::check_surface(triangulation.input());
  internal::for_each_border(triangulation.input(), [&](const std::vector<Halfedge_index>& border) { *out++ = border; });
  return out;
}

/// \ingroup PkgFlipGeodesicsLoops
/// What `handle_and_tunnel_loops()` finds. Each loop is a closed chain of halfedges, for
/// `Edge_path_network::add_curve()` as long as no edge is flipped.
struct Handle_and_tunnel_loops
{
  std::vector<std::vector<Halfedge_index>> handles; ///< loops that bound a surface inside of the solid
  std::vector<std::vector<Halfedge_index>> tunnels; ///< loops that bound a surface outside of it
};

namespace internal {

template <class Triangulation>
Handle_and_tunnel_loops handle_and_tunnel_loops(const Triangulation& triangulation, Interruption* interruption)
{
  static_assert(Has_points<typename Triangulation::Metric>::value,
                "handles and tunnels are those of a surface in space: the metric has no points");
  const Solid_loops<Triangulation> loops(triangulation, interruption);
  return {loops.inside(), loops.outside()};
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * A basis of the closed curves of a surface that bounds a solid, of handle loops and of tunnel loops [DFW13]. A handle
 * loop is the border of a surface inside of the solid, as the meridian of a torus is, and a tunnel loop that of a surface
 * outside of it. Each component of genus g has g loops of either kind, which are treated as if no other component were
 * there. All of them together are a basis of its homology, with integers.
 *
 * Which classes bound inside and outside is decided exactly, by linking numbers of loops that are pushed off the surface
 * and counted in a projection. Of the loops that a tree of shortest paths and an edge close, from a base point and from
 * places near each handle, the shortest are taken that bound, and that belong to a basis together with those taken
 * before. Where they are not enough, as on a tube that is knotted, others are put together of several loops of a
 * `Loop_basis`. These may pass edges more than once, and cross themselves.
 *
 * The places are those that the numbering of the mesh gives. The same mesh, numbered otherwise, can have other loops,
 * some percent shorter or longer.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`, whose metric has points. Its input is read
 * \param np named parameters: `visitor`, a model of `FlipOutVisitor`, of which only `go_further()` is called, at
 *        regular intervals. If it returns `false`, then the result has no loops
 * \pre the surface does not cross or touch itself. Where that is noticed, it is an error
 * \throws Invalid_mesh_error if the mesh is no closed surface of triangles, or is seen to cross itself
 * \throws Degenerate_face_error if faces without area are in the way
 * \throws Invalid_coordinate_error
 *
 * Complexity: \f$O(n \log n)\f$, and the cube of the genus times the size of the numbers. For loops of \f$m\f$ edges, up
 * to \f$m^2\f$ pairs that are near in the projection.
 */
template <class Triangulation, class... NamedParameters>
Handle_and_tunnel_loops handle_and_tunnel_loops(const Triangulation& triangulation, const NamedParameters&... np)
{
  return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...), [&](auto* interruption) {
    return internal::handle_and_tunnel_loops(triangulation, interruption);
  });
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_LOOP_BASIS_H
