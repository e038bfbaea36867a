// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_RECORDING_TRAITS_H
#define FLIP_GEODESICS_TEST_RECORDING_TRAITS_H

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <functional>
#include <optional>

/*
 * The certified traits, with every decision told to an observer. The traits keep what the filter says to themselves and
 * claim not to know, so that the triangulation turns to `Wedge_comparison`, which is specialised for these traits: it
 * takes the filter's answer where there is one, asks the library's own comparison where not, and tells the observer.
 */
namespace Flip_geodesics_test {

struct Decision
{
  CGAL::Flip_geodesics::Halfedge_index from, to; // the halfedges that bound the wedge, clockwise
  CGAL::Comparison_result result;
  bool is_filtered; // decided by the traits alone
};

struct Decision_observer
{
  std::function<void(const Decision&)> on_decision;
  std::optional<CGAL::Comparison_result> filtered; // what the traits have just said
};

template <class K>
class Recording_traits : public CGAL::Flip_geodesics::Certified_intrinsic_triangulation_traits<K>
{
  using Base = CGAL::Flip_geodesics::Certified_intrinsic_triangulation_traits<K>;

public:
  explicit Recording_traits(Decision_observer& observer)
    : m_observer(&observer)
  {
  }

  class Compare_turn_with_straight
  {
  public:
    explicit Compare_turn_with_straight(Decision_observer* observer)
      : m_observer(observer)
    {
    }

    CGAL::Uncertain<CGAL::Comparison_result> operator()(const typename Base::Turn& turn) const
    {
      const CGAL::Uncertain<CGAL::Comparison_result> result = typename Base::Compare_turn_with_straight()(turn);
      m_observer->filtered.reset();
      if(result.is_certain())
        m_observer->filtered = result.make_certain();
      return CGAL::Uncertain<CGAL::Comparison_result>::indeterminate();
    }

  private:
    Decision_observer* m_observer;
  };

  Compare_turn_with_straight compare_turn_with_straight_object() const
  {
    return Compare_turn_with_straight(m_observer);
  }
  Decision_observer& observer() const { return *m_observer; }

private:
  Decision_observer* m_observer;
};

/// A triangulation with recording traits as the library's own comparison is to see it.
template <class Triangulation>
class Plain_view
{
  using Vertex_index = CGAL::Flip_geodesics::Vertex_index;
  using Halfedge_index = CGAL::Flip_geodesics::Halfedge_index;
  using Input_halfedge_index = CGAL::Flip_geodesics::Input_halfedge_index;

public:
  using Metric = typename Triangulation::Metric;
  using Input_mesh = typename Triangulation::Input_mesh;
  using Traits = typename Triangulation::Traits;

  explicit Plain_view(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  static Halfedge_index twin(Halfedge_index h) { return Triangulation::twin(h); }
  static CGAL::Flip_geodesics::Edge_index edge(Halfedge_index h) { return Triangulation::edge(h); }
  const Input_mesh& input() const { return m_triangulation.input(); }
  const Metric& metric() const { return m_triangulation.metric(); }
  const Traits& traits() const { return m_triangulation.traits(); }
  int crossings(CGAL::Flip_geodesics::Edge_index e) const { return m_triangulation.crossings(e); }
  decltype(auto) edge_sequence(Halfedge_index h) const { return m_triangulation.edge_sequence(h); }
  Vertex_index tail(Halfedge_index h) const { return m_triangulation.tail(h); }
  bool is_inserted(Vertex_index v) const { return m_triangulation.is_inserted(v); }
  auto location(Vertex_index v) const { return m_triangulation.location(v); }
  Halfedge_index clockwise(Halfedge_index h) const { return m_triangulation.clockwise(h); }
  int input_edges_in_wedge(Halfedge_index from, Halfedge_index to) const
  {
    return m_triangulation.input_edges_in_wedge(from, to);
  }

private:
  friend struct CGAL::Flip_geodesics::internal::Internals<Plain_view>;

  const Triangulation& m_triangulation;
};

} // namespace Flip_geodesics_test

namespace CGAL::Flip_geodesics::internal {

template <class Triangulation>
struct Internals<Flip_geodesics_test::Plain_view<Triangulation>>
{
  using View = Flip_geodesics_test::Plain_view<Triangulation>;
  using Of_model = Internals<Triangulation>;

  static constexpr bool has_exact_faces = true;
  static constexpr bool has_precise_numbers = true;

  static decltype(auto) exact_face(const View& view, Input_halfedge_index h)
  {
    return Of_model::exact_face(view.m_triangulation, h);
  }
  static decltype(auto) precise_halfedge(const View& view, Input_halfedge_index h)
  {
    return Of_model::precise_halfedge(view.m_triangulation, h);
  }
  static decltype(auto) precise_edge(const View& view, Halfedge_index h)
  {
    return Of_model::precise_edge(view.m_triangulation, h);
  }
  static decltype(auto) flat_edges(const View& view) { return Of_model::flat_edges(view.m_triangulation); }
};

template <class TriangleMesh, class K, class Metric>
class Wedge_comparison<Intrinsic_triangulation<TriangleMesh, Flip_geodesics_test::Recording_traits<K>, Metric>>
{
  using Triangulation = Intrinsic_triangulation<TriangleMesh, Flip_geodesics_test::Recording_traits<K>, Metric>;
  using View = Flip_geodesics_test::Plain_view<Triangulation>;

public:
  Wedge_comparison(const Triangulation& triangulation, Decision_statistics& statistics, bool is_filtered = false)
    : m_triangulation(triangulation)
    , m_statistics(statistics)
    , m_is_filtered(is_filtered)
  {
  }

  Comparison_result operator()(Halfedge_index from, Halfedge_index to) const
  {
    Flip_geodesics_test::Decision_observer& observer = m_triangulation.traits().observer();
    // A certificate asks without the filter, of which something may be left that memory has answered.
    const std::optional<Comparison_result> filtered = m_is_filtered ? observer.filtered : std::nullopt;
    observer.filtered.reset();
    const Comparison_result result =
        filtered ? *filtered : Wedge_comparison<View>(View(m_triangulation), m_statistics, m_is_filtered)(from, to);
    if(observer.on_decision)
      observer.on_decision({from, to, result, filtered.has_value()});
    return result;
  }

private:
  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
  bool m_is_filtered;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // FLIP_GEODESICS_TEST_RECORDING_TRAITS_H
