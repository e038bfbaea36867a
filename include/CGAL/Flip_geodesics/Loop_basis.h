// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_LOOP_BASIS_H
#define CGAL_FLIP_GEODESICS_LOOP_BASIS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
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

namespace CGAL::Flip_geodesics {
namespace internal {

/*
 * Returns the side of a face that starts at a vertex of the face, given by its `anchor` in the face. For an inserted
 * vertex, the side starts at a corner next to the vertex, which is the same corner in all faces.
 */
template <class Triangulation>
Input_halfedge_index corner_next_to(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index anchor)
{
  const bool is_at_other_end =
      vertex_kind(triangulation, v) == Location_kind::EDGE && triangulation.location(v).halfedge != anchor;
  return is_at_other_end ? triangulation.input().next(anchor) : anchor;
}

/* Returns whether a vertex on an input halfedge, or at an end of it, counts as the start of the halfedge. */
template <class Triangulation>
bool is_next_to_start(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index along, bool is_tail)
{
  return triangulation.is_inserted(v) ? triangulation.location(v).halfedge == along : is_tail;
}

/*
 * Appends a path of input halfedges into which an edge of the triangulation, given by its edge sequence, can be
 * deformed with its ends fixed. Inserted vertices are moved to the corners next to them, so that concatenated edges
 * remain connected.
 *
 *      u ---- r        crossed: c from p to q. From u to p, and on along the tails of the crossed halfedges.
 *       \    /.
 *     c  q--p
 */
template <class Triangulation>
void append_input_edges(const Triangulation& triangulation, const Edge_sequence& word,
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
  // Around the left face of `from`, to the start of `to`.
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
 * Computes a basis of the first homology group of a surface, and the coefficients of the homology class of any closed
 * curve with respect to this basis. The basis consists of loops along edges of the input mesh.
 *
 * Each component of genus \f$g\f$ with \f$b\f$ borders has \f$2g\f$ loops if \f$b = 0\f$, and \f$2g + b - 1\f$
 * otherwise. All loops of a component pass through its base point. Their total length is the smallest among all sets of
 * edge loops through the base point that generate the fundamental group, and also among those that generate the
 * homology group \cgalCite{EW05}. Lengths are those of the metric.
 *
 * Only the input of the triangulation is used, so flips do not affect the basis. For \f$n\f$ edges, the construction
 * takes \cgalBigO{n \log n} time and \cgalBigO{n} memory.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`
 */
template <class Triangulation>
class Loop_basis
{
public:
  /// The coefficients of a homology class, one for each loop of the basis.
  using Homology_class = std::vector<std::int64_t>;

  /// Describes a component of the surface.
  struct Component
  {
    Vertex_index base_point; ///< the vertex through which all loops of the component pass
    Index genus;             ///< the number of handles
    Index number_of_borders; ///< the number of borders of the component
    Index first_loop;        ///< the index of the first loop of the component
    Index number_of_loops;   ///< the number of loops of the component, which are numbered consecutively
  };

  /*!
   * Constructs a basis with the first vertex of each component as base point.
   * \param triangulation a triangulation of the surface, which must outlive the basis
   * \throws Invalid_mesh_error if the mesh is not a triangulated surface, or several umbrellas meet at a vertex
   * \throws Invalid_coordinate_error if a coordinate or an edge length is not finite or out of range
   */
  explicit Loop_basis(const Triangulation& triangulation)
    : Loop_basis(triangulation, std::vector<Vertex_index>())
  {
  }

  /*!
   * Constructs a basis with given base points.
   * \param triangulation a triangulation of the surface, which must outlive the basis
   * \param base_points a range of `Vertex_index`, at most one for each component; in a component without a base point,
   *        the first vertex is chosen
   * \param np an optional sequence of named parameters among those listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{visitor}
   *     \cgalParamDescription{a visitor whose `go_further()` is called at regular intervals. If it returns `false`,
   *       `is_complete()` returns `false`, and the basis has neither loops nor components}
   *     \cgalParamType{a model of `FlipOutVisitor`, of which only `go_further()` is called}
   *     \cgalParamDefault{no visitor}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws Invalid_mesh_error if the mesh is not a triangulated surface, or several umbrellas meet at a vertex
   * \throws Invalid_coordinate_error if a coordinate or an edge length is not finite or out of range
   * \throws Vertex_out_of_range_error if a base point is not a vertex of the input
   * \throws Invalid_parameter_error if two base points lie in one component, or a base point is isolated
   */
  template <class VertexRange, class... NamedParameters>
  Loop_basis(const Triangulation& triangulation, const VertexRange& base_points, const NamedParameters&... np)
    : m_triangulation(&triangulation)
  {
    const bool is_whole =
        internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...),
                                        [&](auto* interruption) { return make(base_points, interruption), true; });
    if(!is_whole)
      forget_all();
  }

  /// Returns whether the construction was completed. If a visitor stopped the construction, there are no loops and no
  /// components, and the functions that take a loop, a vertex or a curve throw `Invalid_parameter_error`.
  bool is_complete() const { return m_is_complete; }

  /// \name Loops
  /// @{

  /// Returns the total number of loops of all components.
  Index number_of_loops() const { return static_cast<Index>(m_cotree.generators().size()); }

  /// Returns the halfedges of a loop, from the base point back to the base point. They can be passed to
  /// `Edge_path_network::add_curve()` before any edge is flipped. The loops of one component, as open curves with fixed
  /// ends, do not cross each other.
  std::vector<Halfedge_index> loop(Index i) const
  {
    return m_forest.loop(m_triangulation->input(), generator(i).halfedge).whole();
  }

  /// Returns the simple cycle obtained from a loop by removing the path that the loop traverses in both directions. The
  /// cycle passes through no vertex twice, and need not contain the base point.
  std::vector<Halfedge_index> cycle(Index i) const
  {
    return m_forest.loop(m_triangulation->input(), generator(i).halfedge).cycle();
  }

  /// Returns the length of `loop(i)`. The loops of a component are sorted by increasing length.
  double length(Index i) const { return generator(i).length; }

  /// @}
  /// \name Components
  /// @{

  /// Returns the components that have faces: first those of the given base points, in the order of these points, and
  /// then the others, in the order of their first vertices.
  const std::vector<Component>& components() const { return m_components; }

  /// Returns the position of the component of a vertex in `components()`, or -1 for an isolated vertex. \pre `v` is an
  /// input vertex
  Index component(Vertex_index v) const { return check_complete(), m_forest.component(v); }

  /// @}
  /// \name Classes of closed curves
  /// @{

  /*!
   * Returns the homology class of a closed chain of input halfedges, that is, its exact integer coefficients with
   * respect to the basis. The difference between the chain and the combination of loops with these coefficients is the
   * boundary of a set of faces, counted with multiplicities. Shortening a curve does not change its class.
   *
   * \param halfedges a range of `Input_halfedge_index` that forms a closed chain; an empty chain has class zero. The
   *        index of a halfedge `h` of the mesh is `triangulation.input().index(h)`. A `Halfedge_index` is not accepted,
   *        since it refers to the intrinsic triangulation; a curve of such halfedges must be passed as a curve of a
   *        network
   * \throws Invalid_curve_error if the chain is not closed
   *
   * Complexity: \cgalBigO{k (1 + g + b)} for \f$k\f$ halfedges in a component of genus \f$g\f$ with \f$b\f$ borders,
   * plus time linear in the number of loops of all components.
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
   * Returns the homology class of a closed curve of a network, whose triangulation can contain flipped edges and
   * inserted vertices. The class is zero if the curve has contracted.
   * \throws Invalid_curve_error if the curve does not end where it starts
   * \pre the triangulation of the network has the same input as this basis
   */
  template <class Network>
  Homology_class homology_class(const Network& network, Curve_index curve) const
  {
    return homology_class(input_edges(network, curve));
  }

  /*!
   * Returns whether a closed chain of input halfedges can be contracted to a point on the surface.
   *
   * The problem is solved exactly in the fundamental group: by reduction in the free group if the component has a
   * border, by exponent sums on a torus, and by Dehn's algorithm \cgalCite{LS77} on closed surfaces of higher genus. A
   * curve of homology class zero need not be contractible: for example, a curve that separates two handles is not
   * contractible, although its class is zero.
   *
   * \param halfedges a range of `Input_halfedge_index` that forms a closed chain, as for `homology_class()`
   * \throws Invalid_curve_error if the chain is not closed
   *
   * Complexity: that of `homology_class()`.
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

  /// Returns whether a closed curve of a network can be contracted to a point on the surface. The preconditions and
  /// exceptions are those of `homology_class()` for a curve of a network.
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
                  "the base points must be a range of vertices of the triangulation (Vertex_index)");
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

  void check_complete() const
  {
    if(!m_is_complete)
      throw Invalid_parameter_error("a loop basis is queried, but its construction was stopped by a visitor");
  }

  const internal::Cotree::Loop& generator(Index i) const
  {
    check_complete();
    CGAL_precondition(i >= 0 && i < number_of_loops());
    return m_cotree.generators()[static_cast<std::size_t>(i)];
  }

  template <class HalfedgeRange>
  void check_closed_chain(const HalfedgeRange& halfedges) const
  {
    static_assert(internal::is_range_of<HalfedgeRange, Input_halfedge_index>,
                  "the curve must be a range of halfedges of the input (Input_halfedge_index)");
    check_complete();
    const auto& input = m_triangulation->input();
    Vertex_index start = null_index, end = null_index;
    std::size_t position = 0;
    for(Input_halfedge_index h : halfedges) {
      if(!h.is_valid() || h.idx() >= input.number_of_halfedges())
        internal::throw_naming<Invalid_curve_error>("the halfedge at position ", internal::Element{position},
                                                    " of a curve does not belong to the mesh");
      if(end != null_index && input.tail(h) != end)
        internal::throw_naming<Invalid_curve_error>("the halfedge at position ", internal::Element{position},
                                                    " of a curve does not start where the previous one ends");
      start = start == null_index ? input.tail(h) : start;
      end = input.tail(internal::twin_index(h));
      ++position;
    }
    if(start != end)
      throw Invalid_curve_error("a curve that does not end where it starts has no homology class; pass a closed curve",
                                {position});
  }

  template <class Network>
  std::vector<Input_halfedge_index> input_edges(const Network& network, Curve_index curve) const
  {
    const auto& triangulation = network.triangulation();
    CGAL_precondition_msg(triangulation.input().number_of_halfedges() == m_triangulation->input().number_of_halfedges(),
                          "the network and the loop basis belong to different meshes");
    std::vector<Input_halfedge_index> result;
    Vertex_index start = null_index, end = null_index;
    network.for_each_segment(curve, [&](Segment_index s) {
      const Edge_sequence word = triangulation.edge_sequence(network.halfedge(s));
      start = start == null_index ? word.tail : start;
      end = word.head;
      internal::append_input_edges(triangulation, word, result);
    });
    if(start != end)
      internal::throw_naming<Invalid_curve_error>(
          "curve ", curve, " does not end where it starts, so it has no homology class; pass a closed curve");
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
 * Writes each border of a surface as a closed chain of halfedges with the surface on the left. Each chain begins with
 * its edge of smallest index, and the chains are sorted by these edges.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`, whose edges are those of the input
 * \param out an output iterator that receives one `std::vector<Halfedge_index>` per border
 * \return the past-the-end output iterator
 * \throws Invalid_mesh_error if a face is not a triangle, an edge belongs to no face, or a border passes through a
 *         vertex twice
 *
 * Complexity: linear in the size of the mesh.
 */
template <class Triangulation, class OutputIterator>
OutputIterator border_loops(const Triangulation& triangulation, OutputIterator out)
{
  internal::check_surface(triangulation.input());
  internal::for_each_border(triangulation.input(), [&](const std::vector<Halfedge_index>& border) { *out++ = border; });
  return out;
}

/// \ingroup PkgFlipGeodesicsLoops
/// Contains the result of `handle_and_tunnel_loops()`. Each loop is a closed chain of halfedges, which can be passed to
/// `Edge_path_network::add_curve()` before any edge is flipped.
struct Handle_and_tunnel_loops
{
  std::vector<std::vector<Halfedge_index>> handles; ///< loops that bound a surface inside the solid
  std::vector<std::vector<Halfedge_index>> tunnels; ///< loops that bound a surface outside the solid
};

namespace internal {

template <class Triangulation>
Handle_and_tunnel_loops handle_and_tunnel_loops(const Triangulation& triangulation, Interruption* interruption)
{
  static_assert(Has_points<typename Triangulation::Metric>::value,
                "handle and tunnel loops require a surface in space: the metric has no points");
  const Solid_loops<Triangulation> loops(triangulation, interruption);
  return {loops.inside(), loops.outside()};
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Computes a homology basis of handle loops and tunnel loops for a surface that bounds a solid \cgalCite{DFW13}.
 *
 * A handle loop, such as the meridian of a torus, bounds a surface inside the solid; a tunnel loop bounds a surface
 * outside the solid. Each component is treated as if it were the only one, and a component of genus \f$g\f$ has \f$g\f$
 * loops of each kind. All loops together form a basis of the first homology group with integer coefficients.
 *
 * The function decides exactly, for coordinates rounded to double, which homology classes bound a surface inside or
 * outside the solid. The decisions are based on linking numbers of loops that are pushed off the surface; these numbers
 * are computed by counting crossings in a projection.
 *
 * The loops are chosen from candidates. Each candidate consists of an edge and two paths to its ends in a shortest path
 * tree, whose root is a base point or a vertex near a handle. The candidates that bound a surface inside or outside the
 * solid are considered in order of increasing length. A candidate is chosen if it can be extended, together with the
 * loops chosen so far, to a homology basis. If the candidates do not suffice, as on a knotted tube, several loops of a
 * `Loop_basis` are combined. The combined loops can traverse edges more than once and cross themselves.
 *
 * The choice of the vertices near handles depends on the numbering of the mesh. A different numbering of the same mesh
 * can therefore lead to different loops, whose lengths can differ by a few percent.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`, whose metric has points; only its input is read
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is called at regular intervals. If it returns `false`, the
 *       result has no loops}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the loops of both kinds
 * \pre the surface does not cross or touch itself; if a violation is detected, an exception is thrown
 * \throws Invalid_mesh_error if the mesh is not a closed triangulated surface, or if it is found to cross itself
 * \throws Degenerate_face_error if degenerate faces prevent the computation
 * \throws Invalid_coordinate_error if a coordinate or an edge length is not finite or out of range
 *
 * Complexity: \cgalBigO{n \log n + g^3 d + p} for a mesh of \f$n\f$ edges and of genus \f$g\f$. Here, \f$d\f$ is the
 * largest number of digits of the integers that occur, and \f$p\f$ is the number of pairs of loop edges that are close
 * to each other in the projection. For loops of \f$m\f$ edges in total, \f$p\f$ is at most \f$m^2\f$.
 */
template <class Triangulation, class... NamedParameters>
Handle_and_tunnel_loops handle_and_tunnel_loops(const Triangulation& triangulation, const NamedParameters&... np)
{
  return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...), [&](auto* interruption) {
    return internal::handle_and_tunnel_loops(triangulation, interruption);
  });
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_LOOP_BASIS_H
