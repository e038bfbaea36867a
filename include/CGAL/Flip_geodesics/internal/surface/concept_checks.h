// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONCEPT_CHECKS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONCEPT_CHECKS_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <type_traits>
#include <utility>
#include <vector>

// Each member that a model of a concept lacks, or that has other parameters, meets a sentence that names it.

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class T, class Call>
constexpr bool allows(const Call&)
{
  return std::is_invocable<Call, T&>::value;
}

struct Segment_function
{
  void operator()(Segment_index) const {}
};

#define CGAL_FLIP_GEODESICS_HAS(T, concept_name, ...)                                                                  \
  static_assert(allows<T>([](auto& x) -> decltype(static_cast<void>(x.__VA_ARGS__)) {}),                               \
                "a model of " concept_name " lacks the member " #__VA_ARGS__ ", or has it with other parameters")

/* Ends the compilation if a class is not a model of CurveNetwork. */
template <class Network>
constexpr bool is_curve_network()
{
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", triangulation());
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", number_of_curves());
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", is_closed(Curve_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", is_contracted(Curve_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", length(Curve_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", initial_length(Curve_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", for_each_segment(Curve_index(), Segment_function()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", end_of_segment_ids());
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", halfedge(Segment_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", curve(Segment_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", next(Segment_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", is_head_fixed(Segment_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", is_occupied(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", bundle(Edge_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", ends(std::declval<Joint>()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", next_clockwise(Segment_end()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "CurveNetwork", is_turning_back(std::declval<Joint>()));
  return true;
}

/* The same for EdgePathGraph. */
template <class Network>
constexpr bool is_edge_path_graph()
{
  using Arc = std::vector<Halfedge_index>;
  using Joints = std::vector<Joint>;
  CGAL_FLIP_GEODESICS_HAS(const Network, "EdgePathGraph", is_alive(Segment_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "EdgePathGraph", wedge(std::declval<Joint>()).state);
  CGAL_FLIP_GEODESICS_HAS(const Network, "EdgePathGraph", wedge(std::declval<Joint>()).turn);
  CGAL_FLIP_GEODESICS_HAS(Network, "EdgePathGraph",
                          replace_joint(std::declval<Joint>(), Arc(), std::declval<Joints&>()));
  CGAL_FLIP_GEODESICS_HAS(Network, "EdgePathGraph", perturb_loop(Segment_index(), Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const Network, "EdgePathGraph", bundle_place(Segment_index()));
  CGAL_FLIP_GEODESICS_HAS(Network, "EdgePathGraph",
                          restore_loop(Curve_index(), std::declval<typename Network::Bundle_place>()));
  return is_curve_network<Network>();
}

/* The same for IntrinsicTriangulationWalker. */
template <class Walker, class Turn>
constexpr bool is_walker()
{
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", index());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", place());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", is_none());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", tail());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", twin());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", previous());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", clockwise());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", counterclockwise());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", length());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", prefetch_face());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", extend_turn_clockwise(std::declval<Turn&>()));
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", edge_place());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", is_held());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", hold());
  CGAL_FLIP_GEODESICS_HAS(const Walker, "IntrinsicTriangulationWalker", release());
  return true;
}

/* The same for IntrinsicTriangulation. */
template <class T>
constexpr bool is_intrinsic_triangulation()
{
  using Turn = typename T::Turn;
  using Walker = typename T::Walker;
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", number_of_vertices());
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", number_of_halfedges());
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", number_of_edges());
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", twin(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", edge(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", next(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", previous(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", tail(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", head(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", is_border(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", clockwise(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", counterclockwise(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", outgoing(Vertex_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", prefetch_face(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", traits());
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", length(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation",
                          extend_turn_clockwise(std::declval<Turn&>(), Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", is_straight(Turn(), Halfedge_index(), Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", is_locally_delaunay(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", is_flippable(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(T, "IntrinsicTriangulation", flip(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", log_position());
  CGAL_FLIP_GEODESICS_HAS(T, "IntrinsicTriangulation", rollback(typename T::Log_position()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", memory_of_records());
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", holds(Edge_index()));
  CGAL_FLIP_GEODESICS_HAS(T, "IntrinsicTriangulation", hold(Edge_index()));
  CGAL_FLIP_GEODESICS_HAS(T, "IntrinsicTriangulation", release(Edge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", number_of_holds());
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", number_of_edge_places());
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", walker(Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", walker(typename Walker::Place(), Halfedge_index()));
  CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulation", is_reflex_at_head(std::declval<const Walker&>()));
  return is_walker<Walker, Turn>();
}

#undef CGAL_FLIP_GEODESICS_HAS

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONCEPT_CHECKS_H
