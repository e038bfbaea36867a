// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONCEPTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONCEPTS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

// Static assertions that name each member that a model of a concept lacks, or that has other parameters.

namespace CGAL::Flip_geodesics::internal {

/* Detects visitors with all members that are called for a network while its curves are shortened. */
template <class Visitor, class Network, class = void>
constexpr bool is_visitor = false;
template <class Visitor, class Network>
constexpr bool is_visitor<
    Visitor, Network,
    std::void_t<decltype(static_cast<bool>(std::declval<Visitor&>().go_further())),
                decltype(std::declval<Visitor&>().on_flip(std::declval<typename Network::Triangulation&>(),
                                                          Halfedge_index())),
                decltype(std::declval<Visitor&>().after_flip_out(std::declval<Network&>(), Curve_index()))>> = true;

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

#define CGAL_FLIP_GEODESICS_HAS_TYPE(T, concept_name, type)                                                            \
  static_assert(allows<T>([](auto& x) -> std::void_t<typename std::decay_t<decltype(x)>::type> {}),                    \
                "a model of " concept_name " lacks the type " #type)

/* Detects functors made by a member of the traits, by their parameters and what they return. */
template <class Traits, class Result, class... Arguments, class Make>
constexpr bool makes_functor(const Make&)
{
  if constexpr(std::is_invocable<Make, const Traits&>::value)
    return std::is_invocable_r<Result, const std::invoke_result_t<Make, const Traits&>&, Arguments...>::value;
  else
    return true; // the lack of the member is reported already
}

#define CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(Traits, type, member, ...)                                                   \
  CGAL_FLIP_GEODESICS_HAS_TYPE(Traits, "IntrinsicTriangulationTraits", type);                                          \
  CGAL_FLIP_GEODESICS_HAS(const Traits, "IntrinsicTriangulationTraits", member());                                     \
  static_assert(makes_functor<Traits, __VA_ARGS__>([](auto& x) -> decltype(x.member()) { return x.member(); }),        \
                "the functor of " #member "() has parameters other than those of IntrinsicTriangulationTraits, or "    \
                "a different return type")

/* Fails to compile if the functors of traits are not those of IntrinsicTriangulationTraits. */
template <class T>
constexpr bool makes_functors()
{
  using Point = typename T::Point_3;
  using Face = typename T::Face_geometry;
  using H = const typename T::Halfedge_geometry&;
  using Turn = typename T::Turn;
  using Vectors = std::array<std::array<double, 2>, 3>;
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Construct_face_3, construct_face_3_object, Face, const Point&, const Point&,
                                    const Point&);
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Construct_face_from_lengths, construct_face_from_lengths_object, Face, double,
                                    double, double);
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Construct_face_2, construct_face_2_object, Face, const Vectors&, double);
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Extend_turn, extend_turn_object, void, Turn&, H, H, H);
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Compare_turn_with_straight, compare_turn_with_straight_object,
                                    Uncertain<Comparison_result>, const Turn&);
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Turn_key, turn_key_object, double, const Turn&);
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Flip, flip_object, typename T::Flipped_geometry, H, H, H, H, H, H);
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Is_locally_delaunay, is_locally_delaunay_object, Uncertain<bool>, H, H, H, H, H,
                                    H);
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Is_inaccurate, is_inaccurate_object, bool, H);
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Compute_squared_length, compute_squared_length_object, typename T::FT, H);
  CGAL_FLIP_GEODESICS_MAKES_FUNCTOR(T, Compute_length, compute_length_object, double, H);
  if constexpr(!T::Has_drift::value)
    CGAL_FLIP_GEODESICS_HAS(const T, "IntrinsicTriangulationTraits whose Has_drift is Tag_false", sign_work_limit());
  return true;
}

template <class T, class = void>
constexpr bool has_types_of_traits = false;
template <class T>
constexpr bool has_types_of_traits<
    T, std::void_t<typename T::FT, typename T::Point_3, typename T::Halfedge_geometry, typename T::Face_geometry,
                   typename T::Turn, typename T::Flipped_geometry, typename T::Has_drift>> = true;

/* Fails to compile if a class is not a model of IntrinsicTriangulationTraits. */
template <class T>
constexpr bool are_triangulation_traits()
{
  static_assert(is_triangulation_traits<T>,
                "the traits are not a model of IntrinsicTriangulationTraits: for a kernel K, use "
                "Intrinsic_triangulation_traits<K> or Certified_intrinsic_triangulation_traits<K>");
  if constexpr(has_types_of_traits<T>) {
    return makes_functors<T>();
  } else if constexpr(is_triangulation_traits<T>) {
    CGAL_FLIP_GEODESICS_HAS_TYPE(T, "IntrinsicTriangulationTraits", FT);
    CGAL_FLIP_GEODESICS_HAS_TYPE(T, "IntrinsicTriangulationTraits", Point_3);
    CGAL_FLIP_GEODESICS_HAS_TYPE(T, "IntrinsicTriangulationTraits", Face_geometry);
    CGAL_FLIP_GEODESICS_HAS_TYPE(T, "IntrinsicTriangulationTraits", Turn);
    CGAL_FLIP_GEODESICS_HAS_TYPE(T, "IntrinsicTriangulationTraits", Flipped_geometry);
    CGAL_FLIP_GEODESICS_HAS_TYPE(T, "IntrinsicTriangulationTraits", Has_drift);
  }
  return true;
}

/* Fails to compile if a class is not a model of IntrinsicMetric, whose faces are made with given traits unless it has
 * exact squared lengths. */
template <class Metric, class Traits, bool HAS_SQUARED_LENGTHS>
constexpr bool is_intrinsic_metric()
{
  CGAL_FLIP_GEODESICS_HAS_TYPE(Metric, "IntrinsicMetric", Mesh);
  CGAL_FLIP_GEODESICS_HAS_TYPE(Metric, "IntrinsicMetric", Kernel);
  CGAL_FLIP_GEODESICS_HAS_TYPE(Metric, "IntrinsicMetric", Place);
  using Mesh = const typename Metric::Mesh&;
  using Place = const typename Metric::Place&;
  using H = Input_halfedge_index;
  CGAL_FLIP_GEODESICS_HAS(const Metric, "IntrinsicMetric", length(std::declval<Mesh>(), H()));
  CGAL_FLIP_GEODESICS_HAS(const Metric, "IntrinsicMetric", weight(std::declval<Mesh>(), H()));
  CGAL_FLIP_GEODESICS_HAS(const Metric, "IntrinsicMetric",
                          weight(std::declval<Mesh>(), H(), std::declval<Place>(), std::declval<Place>()));
  CGAL_FLIP_GEODESICS_HAS(const Metric, "IntrinsicMetric", place(std::declval<Mesh>(), Vertex_index()));
  CGAL_FLIP_GEODESICS_HAS(const Metric, "IntrinsicMetric",
                          distance_lower_bound(std::declval<Place>(), std::declval<Place>()));
  if constexpr(!HAS_SQUARED_LENGTHS)
    CGAL_FLIP_GEODESICS_HAS(const Metric, "IntrinsicMetric",
                            face_geometry(std::declval<Mesh>(), H(), std::declval<const Traits&>()));
  return true;
}

/* Fails to compile if a class is not a model of CurveNetwork. */
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

/* Fails to compile if a class is not a model of EdgePathGraph. */
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

/* Fails to compile if a class is not a model of IntrinsicTriangulationWalker. */
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

/* Fails to compile if a class is not a model of IntrinsicTriangulation. */
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

#undef CGAL_FLIP_GEODESICS_MAKES_FUNCTOR
#undef CGAL_FLIP_GEODESICS_HAS_TYPE
#undef CGAL_FLIP_GEODESICS_HAS

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONCEPTS_H
