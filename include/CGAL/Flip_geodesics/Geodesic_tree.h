// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_TREE_H
#define CGAL_FLIP_GEODESICS_GEODESIC_TREE_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/flip_out_wedge.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/shortest/geodesic_tree_parts.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

enum Distance_parameter { distance_parameter };

template <class Tree>
void check_is_grown(const Tree& tree)
{
  if(tree.source() == null_index)
    throw Invalid_parameter_error("a tree is used before it has been grown; call grow() first");
}

} // namespace internal
} // namespace Flip_geodesics

namespace parameters {

/// \ingroup PkgFlipGeodesicsParameters
/// Sets the length up to which a `Geodesic_tree` contains paths.
inline auto max_distance(double distance)
{
  return Named_function_parameters<double, Flip_geodesics::internal::Distance_parameter>(distance);
}

} // namespace parameters

namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTree
/// Reports on the growth of a tree.
struct Geodesic_tree_report
{
  /// `LOCALLY_SHORTEST` if all paths are locally shortest; `STOPPED_BY_VISITOR` if `go_further()` of the visitor
  /// returned `false`; `PRECISION_LIMIT` if paths remain bent because predicates are inexact or coordinates were
  /// rounded to doubles. The status is `DEGENERATE_FACES` if paths remain bent despite exact predicates, because
  /// several vertices coincide once degenerate faces are contracted.
  Shortening_status status = Shortening_status::LOCALLY_SHORTEST;
  std::size_t flips = 0;     ///< the number of edge flips
  std::size_t flip_outs = 0; ///< the number of wedges flipped out \cgalCite{SC20,Algorithm 1}
  std::size_t reopened = 0;  ///< the number of times that the acceptance of a vertex was revoked
  /// The smallest angle that a path forms on either side at a vertex through which it leads, in radians, measured on
  /// the input. The value is infinite if no path leads through a vertex, and for traits whose `Has_drift` is
  /// `CGAL::Tag_false`, which require no measurement.
  double smallest_angle = std::numeric_limits<double>::infinity();
};

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Represents a tree of geodesics from a source to the vertices of a surface, up to an optional maximal length. All
 * paths consist of edges of the same intrinsic triangulation \cgalCite{SC20,section 6.5}.
 *
 * The tree is grown by Dijkstra's algorithm on the current triangulation. Before a vertex is accepted, `grow()` checks
 * whether the path to it is bent at the preceding vertex. The path is bent if its two edges at that vertex form an
 * angle smaller than \f$\pi\f$ on one side. In this case, the edges inside the wedge with the smaller angle are
 * flipped, which yields a shorter path, and the search continues. A vertex with a bent path is accepted only if
 * rounding errors or degenerate faces prevent flips from shortening the path. In contrast to \cgalCite{SC20}, the
 * acceptance of a vertex is revoked if a new edge gives a shorter path to it. The finished tree is therefore a shortest
 * path tree of the edge graph of the final triangulation.
 *
 * The paths do not cross. They are locally shortest if the status is `LOCALLY_SHORTEST`. Most of them are globally
 * shortest; `make_shortest()` replaces the others.
 *
 * A tree that has been grown satisfies an invariant, which `is_valid()` checks. The distance of a reached vertex, other
 * than the source, is the distance of its parent plus the length of the last edge of its path. No edge between reached
 * vertices gives a shorter path.
 *
 * \tparam Triangulation_ a model of `IntrinsicTriangulation`; networks in it must not have curves while the tree is
 *         grown
 */
template <class Triangulation_>
class Geodesic_tree
{
  static_assert(internal::has_edge_sequences<Triangulation_> || !Triangulation_::Traits::Has_drift::value,
                "traits with Has_drift == Tag_true require a model of IntrinsicTriangulationOfMesh, since results are "
                "measured on the input mesh");

public:
  using Triangulation = Triangulation_; ///< the type of the triangulation

  /// Constructs a tree without a source in constant time. The triangulation must outlive the tree.
  explicit Geodesic_tree(Triangulation& triangulation)
    : m_triangulation(&triangulation)
    , m_labels(static_cast<std::size_t>(triangulation.number_of_vertices()))
  {
  }

  /*!
   * Grows the tree from a source and discards the previous tree. The triangulation may contain flipped edges.
   *
   * The result is deterministic: the nearest vertex is processed first, and ties are broken in favor of the smaller
   * index.
   *
   * \param source a vertex of the triangulation, as a `Vertex_index`, or a point of any type that `surface_location()`
   *        accepts; the function inserts such a point by `Intrinsic_triangulation::insert()`. If paths to other points
   *        are required, these points must be inserted before the call
   * \param np an optional sequence of named parameters among those listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{max_distance}
   *     \cgalParamDescription{the length of the longest path that is needed. A vertex within this distance is missed if
   *       the search reaches it only through neighbors beyond this distance. Choose a slightly larger value if all
   *       vertices within a given distance are required}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{infinity}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{visitor}
   *     \cgalParamDescription{a visitor whose `on_flip()` and `go_further()` are called}
   *     \cgalParamType{a model of `FlipOutVisitor`, which is copied unless it is passed by `std::ref()`}
   *     \cgalParamDefault{no visitor}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \return a report on the growth
   * \throws Vertex_out_of_range_error if `source` is a vertex that does not belong to the triangulation, or an isolated
   *         vertex that is not given as a `Vertex_index`
   * \throws Invalid_location_error if `source` is not a point of the surface
   * \throws Insertion_error as `Intrinsic_triangulation::insert()` does
   * \throws Invalid_parameter_error if `max_distance` is negative or not a number
   * \throws Degenerate_face_error as `shorten()` does
   * \throws Invalid_coordinate_error as `shorten()` does
   * \throws Invalid_mesh_error if the connectivity of a visited face is invalid
   * \throws Occupied_triangulation_error if a network in the triangulation has curves
   *
   * Complexity: in practice \cgalBigO{n \log n} time, where \f$n\f$ is the number of vertices within `max_distance`,
   * plus constant time per flip.
   */
  template <class Source = Surface_location, class... NamedParameters>
  Geodesic_tree_report grow(const Source& source, const NamedParameters&... np)
  {
    const auto& options = internal::options_of<internal::Distance_parameter, internal_np::visitor_t>(np...);
    internal::check_has_no_curves(*m_triangulation, "a tree cannot be grown");
    const double most = parameters::choose_parameter(parameters::get_parameter(options, internal::distance_parameter),
                                                     std::numeric_limits<double>::infinity());
    if(!(most >= 0))
      throw Invalid_parameter_error("max_distance is " + internal::written(most) +
                                    ", but must be a number that is not negative");
    start(vertex_at(source), most);
    auto visitor = internal::make_visitor(options);
    return run_to_the_end(visitor.get());
  }

  /// Returns the triangulation whose edges form the paths.
  Triangulation& triangulation() const { return *m_triangulation; }

  /// Returns the source of the tree, or `null_index` before `grow()`.
  Vertex_index source() const { return m_source; }

  /// Returns the report on the growth of the tree, including the growth in `replace_paths()`.
  const Geodesic_tree_report& report() const { return m_report; }

  /// Returns the value of `max_distance` that was passed to `grow()`, or infinity.
  double max_distance() const { return m_max_distance; }

  /// Returns whether the tree has a path to vertex `v`. \pre `v` existed when the tree was grown
  bool is_reached(Vertex_index v) const { return m_labels.is_settled(v); }

  /// Returns the length of the path to `v`, or infinity if `v` is not reached.
  double distance(Vertex_index v) const
  {
    return is_reached(v) ? m_labels.distance(v) : std::numeric_limits<double>::infinity();
  }

  /// Returns the last halfedge of the path to `v`; this halfedge points to `v`. The result is `null_index` if `v` is
  /// the source or is not reached.
  Halfedge_index incoming(Vertex_index v) const { return is_reached(v) ? m_labels.incoming(v) : null_index; }

  /// Returns the halfedges of the path from the source to `v`. The result is empty if `v` is the source or is not
  /// reached.
  std::vector<Halfedge_index> path(Vertex_index v) const
  {
    std::vector<Halfedge_index> result;
    for(Halfedge_index h = incoming(v); h != null_index; h = incoming(m_triangulation->tail(h)))
      result.push_back(h);
    std::reverse(result.begin(), result.end());
    return result;
  }

  /// Detaches vertices from the tree and attaches them elsewhere. `replace_paths()` passes an object of this type to
  /// its function object.
  class Grafts
  {
  public:
    /// Detaches only `v`; vertices whose paths pass through `v` must be detached as well.
    void take_off(Vertex_index v)
    {
      m_tree.m_labels.forget(v);
      m_taken_off.push_back(v);
    }

    /// Attaches `v` by a halfedge. \pre `h` leads to `v` from a vertex in the tree, and `v` is not in the tree
    void hang(Vertex_index v, Halfedge_index h)
    {
      const Triangulation& t = m_tree.triangulation();
      CGAL_precondition(t.head(h) == v && !m_tree.is_reached(v) && m_tree.is_reached(t.tail(h)));
      m_tree.m_labels.settle(v, m_tree.distance(t.tail(h)) + t.length(h), h);
      ++m_tree.m_accepted;
    }

  private:
    friend Geodesic_tree;

    explicit Grafts(Geodesic_tree& tree)
      : m_tree(tree)
    {
    }

    Geodesic_tree& m_tree;
    std::vector<Vertex_index> m_taken_off;
  };

  /*!
   * Replaces paths of the tree by other paths. `make_shortest()` uses this function.
   *
   * After the replacement, the tree grows to the detached vertices that `function` did not reattach, and to vertices to
   * which new edges give shorter paths.
   *
   * \param function a function object, which is called with a `Grafts&`. During the call, it may flip edges that are
   *        not in the tree
   * \return the report on the growth of the tree so far, including the growth in `grow()`. Flips made by `function` are
   *         not counted
   * \pre `grow()` was not stopped
   * \throws Invalid_parameter_error if `grow()` has not been called
   *
   * Complexity: linear in the size of the mesh, plus the time of the growth.
   */
  template <class Function>
  Geodesic_tree_report replace_paths(Function function)
  {
    internal::check_is_grown(*this);
    Grafts grafts(*this);
    function(grafts);
    return regrow(grafts.m_taken_off);
  }

  /// Returns whether the tree satisfies its invariant, with a relative tolerance of 1e-10 for lengths.
  ///
  /// Complexity: linear in the size of the mesh.
  bool is_valid() const { return is_valid(internal::default_tree_tolerance); }

  /// Returns whether the tree satisfies its invariant, with a relative `tolerance` for lengths.
  ///
  /// Complexity: linear in the size of the mesh.
  bool is_valid(double tolerance) const
  {
    for(Halfedge_index h : internal::descriptors<Halfedge_index>(m_triangulation->number_of_halfedges())) {
      const Vertex_index u = m_triangulation->tail(h), v = m_triangulation->head(h);
      if(!is_reached(u) || !is_reached(v))
        continue;
      const double way = distance(u) + m_triangulation->length(h);
      if(way < distance(v) * (1 - tolerance) || (incoming(v) == h && way > distance(v) * (1 + tolerance)))
        return false;
    }
    for(Vertex_index v : internal::descriptors<Vertex_index>(m_triangulation->number_of_vertices()))
      if(is_reached(v) && v != m_source && (incoming(v) == null_index || m_triangulation->head(incoming(v)) != v))
        return false;
    return true;
  }

private:
  using Walker = typename Triangulation::Walker;
  using Straightness = internal::Tree_straightness<Geodesic_tree>;

  template <class Source>
  Vertex_index vertex_at(const Source& source)
  {
    if constexpr(std::is_convertible<const Source&, Vertex_index>::value) {
      internal::check_vertex(source, m_triangulation->number_of_vertices());
      return source;
    } else {
      return m_triangulation->insert(internal::located_place(*m_triangulation, source));
    }
  }

  void start(Vertex_index source, double max_distance)
  {
    m_labels.start(static_cast<std::size_t>(m_triangulation->number_of_vertices())); // some may have been inserted
    m_measured = internal::Measured_legs();
    m_source = source;
    m_max_distance = max_distance;
    m_report = Geodesic_tree_report();
    m_hindered.clear();
    m_accepted = m_idle = m_lengthened = 0;
    m_labels.offer(source, 0, null_index);
  }

  template <class Visitor>
  void run(Visitor& visitor)
  {
    while(m_labels.has_offers()) {
      if(!visitor.go_further()) {
        m_report.status = Shortening_status::STOPPED_BY_VISITOR;
        return;
      }
      const Vertex_index v = m_labels.pop();
      if(v != null_index)
        accept_or_straighten(v, visitor);
    }
  }

  template <class Visitor>
  void accept_or_straighten(Vertex_index v, Visitor& visitor)
  {
    const Halfedge_index h = m_labels.incoming(v);
    if(h != null_index && m_triangulation->tail(h) != m_source) {
      const Halfedge_index back = Triangulation::twin(m_labels.incoming(m_triangulation->tail(h)));
      const Walker from = m_triangulation->walker(back), to = m_triangulation->walker(h);
      const double left = key(from, to), right = key(to, from);
      if((left < straight || right < straight) && !m_hindered.has(back, h) && has_patience())
        return left <= right ? flip_out(v, back, h, visitor) : flip_out(v, h, back, visitor);
    }
    if(m_labels.distance(v) > m_max_distance)
      return;
    m_labels.settle(v);
    ++m_accepted;
    internal::collect_outgoing_halfedges(*m_triangulation, v, m_outgoing_halfedges);
    for(const Walker& outgoing_halfedge : m_outgoing_halfedges)
      relax(outgoing_halfedge);
  }

  /*
   * If angles are pi up to rounding errors, a vertex could be passed between paths of equal length forever. Each wedge
   * flipped out without a flip makes some path shorter or moves it to one side, so a few rounds over all vertices
   * suffice; after many more, paths are accepted as they are. The same happens after as many wedges that were
   * considered narrow and whose arcs were not shorter, since other wedges may be flipped out for them back and forth.
   */
  bool has_patience()
  {
    constexpr std::size_t few = 10000, rounds = 16;
    if((std::max)(m_idle, m_lengthened) < few + rounds * m_accepted)
      return true;
    if(!Triangulation::Traits::Has_drift::value) // otherwise, accepted paths are measured
      m_report.status = Shortening_status::PRECISION_LIMIT;
    return false;
  }

  // Returns the key of the angle clockwise from a to c if it is below pi and contains no edge of the tree.
  double key(const Walker& a, const Walker& c) const
  {
    typename Triangulation::Turn turn; // contains an edge of the tree only if rounding errors hide that its path is
                                       // bent
    const auto is_in_tree = [this](const Walker& h) { return incoming(h.twin().tail()) == h.index(); };
    return internal::is_free_wedge(*m_triangulation, a, c, turn, is_in_tree)
               ? m_triangulation->traits().turn_key_object()(turn)
               : straight;
  }

  // Makes room for a shorter path to v, which arrives along a or c. The path along the outer arc is shorter, but its
  // vertices may not be accepted yet; v waits for them.
  template <class Visitor>
  void flip_out(Vertex_index v, Halfedge_index a, Halfedge_index c, Visitor& visitor)
  {
    const double old_distance = m_labels.distance(v);
    const double old_length = m_triangulation->length(a) + m_triangulation->length(c);
    m_orphans = {v};
    m_flipped.clear();
    ++m_idle;
    const auto flip = [&](Halfedge_index outgoing_halfedge) {
      const Vertex_index w = m_triangulation->head(outgoing_halfedge);
      if(m_labels.is_offered(w) && m_labels.incoming(w) == outgoing_halfedge)
        m_orphans.push_back(w);
      m_flipped.push_back(outgoing_halfedge);
      m_hindered.forget(*m_triangulation, outgoing_halfedge);
      m_triangulation->flip(outgoing_halfedge);
      ++m_report.flips;
      m_idle = 0;
      visitor.on_flip(*m_triangulation, outgoing_halfedge);
    };
    constexpr std::size_t any = (std::numeric_limits<std::size_t>::max)(); // the remaining edges are offered, too
    const double new_length = internal::flip_out_wedge(*m_triangulation, a, c, m_arc, flip, any);
    ++m_report.flip_outs;
    const bool is_in_vain =
        new_length - old_length > internal::visible_lengthening * old_distance &&
        internal::can_be_folded(*m_triangulation, m_arc, internal::length_sum_rounding * old_distance);
    if(is_in_vain)
      m_hindered.add(a, c);
    m_lengthened += is_in_vain || (Triangulation::Traits::Has_drift::value && new_length >= old_length) ? 1 : 0;
    adopt_orphans(is_in_vain ? Edge_index(null_index) : Triangulation::edge(m_labels.incoming(v)));
    prefer_arc(v, old_distance);
    for(Halfedge_index h : m_flipped) {
      const Walker flipped = m_triangulation->walker(h);
      relax(flipped);
      relax(flipped.twin());
    }
  }

  // Offers the path to v along the arc, which is shorter, even if rounding errors make others seem so.
  void prefer_arc(Vertex_index v, double old_distance)
  {
    const bool is_at_end = m_triangulation->head(m_arc.back()) == v;
    const Halfedge_index last = is_at_end ? m_arc.back() : Triangulation::twin(m_arc.front());
    const Vertex_index u = m_triangulation->tail(last);
    if(!is_reached(u) || u == v)
      return;
    const double distance = m_labels.distance(u) + m_triangulation->length(last);
    if(distance <= old_distance * (1 + internal::length_sum_rounding))
      m_labels.offer(v, distance, last);
  }

  void adopt_orphans(Edge_index edge)
  {
    for(Vertex_index v : m_orphans)
      m_labels.forget(v);
    for(Vertex_index v : m_orphans) {
      internal::collect_outgoing_halfedges(*m_triangulation, v, m_outgoing_halfedges);
      double least = infinity;
      Halfedge_index best = null_index;
      for(const Walker& outgoing_halfedge : m_outgoing_halfedges) {
        const Walker h = outgoing_halfedge.twin();
        const Vertex_index u = h.tail();
        if(!is_reached(u) || u == v || m_labels.distance(u) >= least ||
           Triangulation::edge(outgoing_halfedge.index()) == edge)
          continue;
        const double distance = m_labels.distance(u) + h.length();
        best = distance < least ? h.index() : best;
        least = (std::min)(distance, least);
      }
      if(best != null_index)
        m_labels.offer(v, least, best);
    }
  }

  // Relaxes h, which leads from an accepted vertex.
  void relax(const Walker& h)
  {
    const double distance = useful_way(h);
    if(distance == infinity)
      return;
    const Vertex_index u = h.tail(), v = h.twin().tail();
    if(is_reached(v)) {
      reopen(v);
      if(!is_reached(u)) // its path passed v
        return;
    }
    if(m_labels.is_unknown(v) || distance < m_labels.distance(v))
      m_labels.offer(v, distance, h.index());
  }

  // Returns the length of the path along h if it leads from an accepted vertex and is shorter than the current one.
  double useful_way(const Walker& h) const
  {
    const Vertex_index u = h.tail(), v = h.twin().tail();
    if(!is_reached(u) || u == v || v == m_source)
      return infinity;
    const double start = m_labels.distance(u);
    const double needed = m_labels.is_unknown(v)
                              ? infinity
                              : m_labels.distance(v) * (is_reached(v) ? 1 - internal::length_sum_rounding : 1);
    if(start >= needed) // without a square root: true in one of the two directions along any edge
      return infinity;
    const double distance = start + h.length();
    return distance < needed ? distance : infinity;
  }

  Geodesic_tree_report regrow(const std::vector<Vertex_index>& taken_off)
  {
    Default_shortening_visitor visitor;
    for(Vertex_index v : taken_off)
      for(Halfedge_index outgoing_halfedge : internal::outgoing_halfedges(*m_triangulation, v))
        relax_forward(Triangulation::twin(outgoing_halfedge));
    for(Halfedge_index h : internal::descriptors<Halfedge_index>(
            m_triangulation->number_of_halfedges())) // new edges can be shorter paths to other vertices
      relax(m_triangulation->walker(h));
    return run_to_the_end(visitor);
  }

  // Undoes the acceptance of v and of all vertices whose paths pass it, and searches for other paths to them.
  void reopen(Vertex_index v)
  {
    std::vector<Vertex_index> subtree = {v};
    m_labels.forget(v);
    for(std::size_t i = 0; i < subtree.size(); ++i)
      for(Halfedge_index outgoing_halfedge : internal::outgoing_halfedges(*m_triangulation, subtree[i])) {
        const Vertex_index w = m_triangulation->head(outgoing_halfedge);
        if(m_labels.is_unknown(w) || m_labels.incoming(w) != outgoing_halfedge)
          continue;
        m_report.reopened += is_reached(w) ? 1 : 0;
        m_labels.forget(w);
        subtree.push_back(w);
      }
    ++m_report.reopened;
    for(Vertex_index w : subtree)
      for(Halfedge_index outgoing_halfedge : internal::outgoing_halfedges(*m_triangulation, w))
        relax_forward(Triangulation::twin(outgoing_halfedge));
  }

  void relax_forward(Halfedge_index h)
  {
    const Vertex_index v = m_triangulation->head(h);
    if(!is_reached(v))
      relax(m_triangulation->walker(h));
  }

  template <class Visitor>
  Geodesic_tree_report run_to_the_end(Visitor& visitor)
  {
    run(visitor);
    if constexpr(Triangulation::Traits::Has_drift::value)
      measure(visitor);
    else if(m_report.status != Shortening_status::STOPPED_BY_VISITOR && m_hindered.are_in(*this))
      m_report.status = internal::status_of_hindered(*m_triangulation);
    else if(m_report.status == Shortening_status::DEGENERATE_FACES)
      m_report.status = Shortening_status::LOCALLY_SHORTEST;
    return m_report;
  }

  /*
   * Measures the finished paths from the input. If drift has hidden bends, the faces there are recomputed from the
   * input and the search continues.
   */
  template <class Visitor>
  void measure(Visitor& visitor)
  {
    constexpr int most_rounds = 50;
    m_measured.resize(static_cast<std::size_t>(m_triangulation->number_of_vertices()));
    Straightness straightness(*this, m_measured);
    for(int round = 0;; ++round) {
      std::vector<Vertex_index> bent;
      m_report.smallest_angle = straightness(std::back_inserter(bent));
      if(bent.empty() || m_report.status != Shortening_status::LOCALLY_SHORTEST)
        return;
      bool has_refreshed = false;
      if(round < most_rounds)
        for(Vertex_index v : bent)
          has_refreshed = is_reached(v) && refresh(v, straightness) ? true : has_refreshed;
      if(!has_refreshed) {
        m_report.status = Shortening_status::PRECISION_LIMIT;
        return;
      }
      run(visitor);
    }
  }

  bool refresh(Vertex_index v, Straightness& straightness)
  {
    if(!straightness.refresh(v))
      return false;
    reopen(v);
    return true;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double straight = 3; // above all keys, which round to 2 close to pi

  Triangulation* m_triangulation;
  internal::Tree_labels m_labels;
  Vertex_index m_source = null_index;
  std::size_t m_accepted = 0;   // the number of acceptances of vertices
  std::size_t m_idle = 0;       // wedges flipped out since the last flip
  std::size_t m_lengthened = 0; // wedges flipped out for arcs that are not shorter
  double m_max_distance = std::numeric_limits<double>::infinity();
  Geodesic_tree_report m_report;
  internal::Measured_legs m_measured; // of the paths, if they have been measured
  internal::Hindered_joints m_hindered;
  std::vector<Halfedge_index> m_arc, m_flipped;
  std::vector<Vertex_index> m_orphans;
  std::vector<Walker> m_outgoing_halfedges;
};

/// \ingroup PkgFlipGeodesicsTree
/// Stores the polar coordinates of all vertices under the logarithmic map of a source vertex, and the total angle at
/// the source.
class Vertex_logarithmic_map
{
public:
  /// Constructs a map without coordinates, given the number of vertices, the sum of the face angles around the source,
  /// and whether the source lies on the border.
  Vertex_logarithmic_map(Index number_of_vertices, double total_angle, bool is_on_border)
    : m_coordinates(static_cast<std::size_t>(number_of_vertices))
    , m_total_angle(total_angle)
    , m_is_on_border(is_on_border)
  {
  }

  /// Returns the sum of the face angles around the source, in radians.
  double total_angle() const { return m_total_angle; }
  bool is_on_border() const { return m_is_on_border; } ///< returns whether the source lies on the border

  Polar_coordinates& operator[](Vertex_index v) { return m_coordinates[v]; } ///< returns the coordinates of a vertex
  const Polar_coordinates& operator[](Vertex_index v) const
  {
    return m_coordinates[v];
  }                                                    ///< returns the coordinates of a vertex
  auto begin() const { return m_coordinates.begin(); } ///< returns an iterator to the coordinates of the first vertex
  auto end() const { return m_coordinates.end(); }     ///< returns the past-the-end iterator

  /*!
   * Returns the coordinates of vertex `v` in the plane, with the source at the origin. The angles around an interior
   * source are scaled to a sum of \f$2\pi\f$; those around a source on the border are not scaled. If no path to `v`
   * is known, the coordinates are NaN.
   */
  std::array<double, 2> in_plane(Vertex_index v) const
  {
    const Polar_coordinates& p = m_coordinates[v];
    if(p.radius == 0)
      return {0, 0};
    const double stretch = m_is_on_border ? 1 : boost::math::constants::two_pi<double>() / m_total_angle;
    return {p.radius * std::cos(stretch * p.angle), p.radius * std::sin(stretch * p.angle)};
  }

private:
  internal::Indexed_by<Vertex_index, std::vector<Polar_coordinates>> m_coordinates;
  double m_total_angle;
  bool m_is_on_border;
};

namespace internal {

/*
 * Calls function(v, direction) for the heads of the first edges of the paths of a tree, with directions at the source.
 * The directions are measured together as far as possible; those in other umbrellas are not.
 */
template <class Tree, class Directions, class Function>
void measure_first_edges(const Tree& tree, const Directions& directions, const Function& function)
{
  const auto& triangulation = tree.triangulation();
  const Vertex_index source = tree.source();
  if(triangulation.outgoing(source) == null_index)
    return;
  Measured_legs measured(static_cast<std::size_t>(triangulation.number_of_vertices()));
  const std::vector<Halfedge_index> around =
      triangulation.is_inserted(source)
          ? outgoing_halfedges(triangulation, source)
          : outgoing_halfedges_beside(triangulation, triangulation.input().outgoing(source));
  Tree_straightness<Tree> straightness(tree, measured);
  for(const Fan_leg& leg : straightness.legs(around, Edge_end()))
    function(leg.head, leg.is_found ? directions.of_input(leg.reference()) + leg.start.direction.angle
                                    : directions(leg.start.halfedge));
}

template <class Triangulation, class Visitor>
Vertex_logarithmic_map logarithmic_map_of_tree(const Geodesic_tree<Triangulation>& tree, Input_halfedge_index zero,
                                               Visitor& visitor)
{
  const Triangulation& triangulation = tree.triangulation();
  check_is_grown(tree);
  const bool is_zero_told = zero != null_index && !triangulation.is_inserted(tree.source());
  if(is_zero_told && (!zero.is_valid() || zero.idx() >= triangulation.input().number_of_halfedges()))
    throw Invalid_location_error("the halfedge of angle zero does not belong to the mesh");
  if(is_zero_told && triangulation.input().tail(zero) != tree.source())
    throw Invalid_location_error("the halfedge of angle zero, " + std::to_string(zero.idx()) +
                                     ", does not start at vertex " + std::to_string(tree.source().idx()) +
                                     ", the source of the tree",
                                 {static_cast<std::size_t>(zero.idx())});
  const Vertex_directions<Triangulation> directions(triangulation, tree.source());
  Vertex_logarithmic_map map(triangulation.number_of_vertices(), directions.total(), directions.has_border());
  map[tree.source()].radius = 0;
  const double start = is_zero_told && !map.is_on_border() ? directions.of_input(zero) : 0;

  const auto set_angle = [&](Vertex_index v, double direction) {
    const double angle = direction - start;
    map[v].angle = angle + (!map.is_on_border() && angle < 0 ? map.total_angle() : 0);
  };
  measure_first_edges(tree, directions, set_angle);

  std::vector<Vertex_index> way; // from a vertex back to one whose angle is known
  for(Vertex_index v : descriptors<Vertex_index>(triangulation.number_of_vertices())) {
    if(v.idx() % 1024 == 0)
      report_progress(visitor, static_cast<std::size_t>(v.idx()),
                      static_cast<std::size_t>(triangulation.number_of_vertices()));
    if(!tree.is_reached(v) || v == tree.source())
      continue;
    map[v].radius = tree.distance(v);
    way.clear();
    for(Vertex_index w = v; w != tree.source() && std::isnan(map[w].angle); w = triangulation.tail(tree.incoming(w)))
      way.push_back(w);
    for(std::size_t i = way.size(); i-- > 0;) {
      const Halfedge_index h = tree.incoming(way[i]);
      if(triangulation.tail(h) == tree.source())
        set_angle(way[i], directions(h));
      else
        map[way[i]].angle = map[triangulation.tail(h)].angle;
    }
  }
  return map;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Computes the logarithmic map of the source of a tree \cgalCite{SC20,section 6.5}, that is, the length and the initial
 * direction of the path to each vertex.
 *
 * The directions are angles on the surface in radians, counterclockwise from an input halfedge, in
 * \f$[0, \mathtt{total\_angle})\f$. They are measured on the input, so errors do not accumulate with the flips. All
 * vertices whose paths lead through the same vertex, for example a saddle vertex at which the paths bend, have the same
 * angle.
 *
 * The map is discontinuous across the cut locus, the set of points that several shortest paths reach. The map can also
 * be discontinuous at paths of the tree that are not shortest; `make_shortest()` replaces these paths.
 *
 * \param tree a tree that has been grown
 * \param zero the input halfedge whose direction is 0; it must start at the source. By default, and always for an
 *        inserted source, it is the halfedge of the `location()` of the source. For a source on the border, the
 *        parameter has no effect, and angles in \f$[0, \mathtt{total\_angle}]\f$ are measured from the border
 * \return the polar coordinates of all vertices
 * \throws Invalid_location_error if `zero` is not a halfedge of the mesh or does not start at the source
 * \throws Invalid_parameter_error if `grow()` has not been called
 * \throws Invalid_mesh_error if several umbrellas meet at the source, so that directions cannot be compared
 *
 * Complexity: linear in the number of vertices plus the number of input edges that the tree edges at the source cross.
 */
template <class Triangulation>
Vertex_logarithmic_map logarithmic_map(const Geodesic_tree<Triangulation>& tree, Input_halfedge_index zero = null_index)
{
  Default_shortening_visitor visitor;
  return internal::logarithmic_map_of_tree(tree, zero, visitor);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_TREE_H
