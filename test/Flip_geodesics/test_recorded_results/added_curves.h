// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Curves of all kinds that are added to a sum.

#ifndef FLIP_GEODESICS_TEST_RECORDED_RESULTS_ADDED_CURVES_H
#define FLIP_GEODESICS_TEST_RECORDED_RESULTS_ADDED_CURVES_H

#include "test_recorded_results/comparison.h"

namespace Flip_geodesics_test {

template <class Network>
void shorten_and_add(Network& network, Summary& summary)
{
  summary.add(FG::shorten(network));
  summary.add_curves(network);
}

struct Add_paths
{
  template <class Triangulation>
  void operator()(Setting<Triangulation>& s, Summary& summary, Result& extra) const
  {
    FG::Shortest_edge_path<Triangulation> search(s.triangulation,
                                                 CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
    std::size_t settled = 0, beforehand = 0;
    for(int i = 0; i < n; ++i) {
      typename Setting<Triangulation>::Network network(s.triangulation);
      const FG::Vertex_index v = s.random_vertex(), w = s.random_vertex();
      summary.attempt([&] {
        const auto path = search(v, w);
        settled += search.settled_vertices();
        summary.results.add_all(path);
        beforehand += FG::add_straightened_path(network, path);
        summary.add_curves(network);
        shorten_and_add(network, summary);
      });
      network.clear();
      s.triangulation.rollback();
    }
    extra.count("settled", settled);
    extra.count("beforehand", beforehand);
  }

  int n; // how many
};

// Shortest edge paths to all from one vertex share edges, and do not cross.
template <class Triangulation>
void add_star(Setting<Triangulation>& s, typename Setting<Triangulation>::Network& network, int n)
{
  FG::Shortest_edge_path<Triangulation> search(s.triangulation,
                                               CGAL::parameters::search_method(FG::Search_method::DIJKSTRA));
  const FG::Vertex_index v = s.random_vertex();
  for(int i = 0; i < n; ++i) {
    const auto path = search(v, s.random_vertex());
    if(!path.empty())
      network.add_curve(path);
  }
  FG::order_overlapping_curves(network);
}

struct Add_networks
{
  template <class Triangulation>
  void operator()(Setting<Triangulation>& s, Summary& summary, Result&) const
  {
    for(int i = 0; i < n; ++i) {
      typename Setting<Triangulation>::Network network(s.triangulation);
      summary.attempt([&] {
        add_star(s, network, 10);
        for(int j = 0; j < i; ++j)
          network.fix_nodes_at(s.random_vertex());
        shorten_and_add(network, summary);
        FG::Straightness_meter<typename Setting<Triangulation>::Network> meter(network);
        for(FG::Curve_index c : FG::internal::descriptors<FG::Curve_index>(network.number_of_curves()))
          summary.lengths.add(meter(c).smallest_angle);
        if(i % 2 == 1) {
          for(FG::Curve_index c : FG::internal::descriptors<FG::Curve_index>(network.number_of_curves()))
            network.free_nodes(c);
          shorten_and_add(network, summary);
        }
      });
      network.clear();
      s.triangulation.rollback();
    }
  }

  int n; // how many
};

using Stop = std::function<FG::Stop_decision(const FG::Shortening_step&)>;

// Some never stop, some hold up a curve that others then come close to.
inline const std::vector<Stop>& stops()
{
  static const std::vector<Stop> result = {
      FG::Never_stop_predicate(),
      FG::Length_ratio_stop_predicate(0.97),
      FG::Curve_length_ratio_stop_predicate(0.95),
      FG::Angle_stop_predicate(2.5),
      FG::Iteration_stop_predicate(4),
      FG::Memory_stop_predicate(6000),
      [](const FG::Shortening_step& step) {
        return step.curve.idx() % 2 == 1 ? FG::Stop_decision::CURVE_LENGTH_LIMIT : FG::Stop_decision::CONTINUE;
      },
      [](const FG::Shortening_step& step) {
        const auto curve = static_cast<std::size_t>(step.curve.idx());
        return (3 * curve + step.steps) % 4 == 0 ? FG::Stop_decision::CURVE_LENGTH_LIMIT : FG::Stop_decision::CONTINUE;
      }};
  return result;
}

// Several runs, each with another predicate.
struct Add_stopped_curves
{
  template <class Triangulation>
  void operator()(Setting<Triangulation>& s, Summary& summary, Result& extra) const
  {
    using Network = typename Setting<Triangulation>::Network;
    FG::Shortest_edge_path<Triangulation> measure(s.triangulation,
                                                  CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
    const FG::Landmark_distances landmarks(measure);
    FG::Shortest_edge_path<Triangulation> search(s.triangulation, CGAL::parameters::landmarks(landmarks));
    std::size_t settled = 0;
    for(std::size_t i = 0; i < 2 * stops().size(); ++i) {
      Network network(s.triangulation);
      const FG::Vertex_index v = s.random_vertex();
      summary.attempt([&] {
        for(std::size_t j = 0; j < 2 + i % 3; ++j) {
          const FG::Vertex_index w = s.random_vertex();
          summary.lengths.add(landmarks.distance_lower_bound(v, w));
          if(const auto path = search(v, w); !path.empty())
            network.add_curve(path);
          settled += search.settled_vertices();
        }
        FG::order_overlapping_curves(network);
        if(i % 4 == 3)
          network.fix_nodes_at(s.random_vertex());
        FG::Shortener<Network> shortener(network);
        for(std::size_t round = 0; round < 4; ++round) {
          shortener.run(stops()[(i + (i / 4 + 1) * round) % stops().size()]);
          summary.add(shortener.report());
        }
        summary.add_curves(network);
      });
      network.clear();
      s.triangulation.rollback();
    }
    extra.count("settled", settled);
  }
};

struct Add_shortest_paths
{
  template <class Triangulation>
  void operator()(Setting<Triangulation>& s, Summary& summary, Result& extra) const
  {
    FG::Shortest_edge_path<Triangulation> search(s.triangulation);
    std::size_t windows = 0, confirmed = 0;
    for(int i = 0; i < n; ++i) {
      typename Setting<Triangulation>::Network network(s.triangulation);
      const FG::Vertex_index v = s.random_vertex(), w = s.random_vertex();
      summary.attempt([&] {
        const auto report = FG::add_shortest_path(
            network, search, v, w,
            CGAL::parameters::search_limit(i % 10 == 5 ? FG::Window_limit(100) : FG::Window_limit()));
        BOOST_TEST(report.gap() >= 0);
        windows += report.windows;
        confirmed += report.is_confirmed() ? 1 : 0;
        summary.add(report.shortening);
        for(double length : {report.first_length, report.length, report.lower_bound})
          summary.lengths.add(length);
        summary.add_curves(network);
      });
      network.clear();
      s.triangulation.rollback();
    }
    extra.count("windows", windows);
    extra.count("confirmed", confirmed);
  }

  int n; // how many
};

template <class Triangulation>
void add_tree(const FG::Geodesic_tree<Triangulation>& tree, Summary& summary)
{
  const auto& triangulation = tree.triangulation();
  for(FG::Vertex_index v : FG::internal::descriptors<FG::Vertex_index>(triangulation.number_of_vertices())) {
    summary.results.add(tree.incoming(v));
    if(tree.is_reached(v))
      summary.lengths.add(tree.distance(v));
    if(tree.incoming(v) != FG::null_index)
      summary.add(triangulation.edge_sequence(tree.incoming(v)));
  }
  for(const FG::Polar_coordinates& p : FG::logarithmic_map(tree))
    summary.lengths.add(p.angle + 1);
  summary.add_log(triangulation);
}

struct Add_trees
{
  template <class Triangulation>
  void operator()(Setting<Triangulation>& s, Summary& summary, Result& extra) const
  {
    std::size_t reopened = 0, windows = 0, longer = 0, vertices = 0, mended = 0, confirmed = 0;
    FG::Geodesic_tree<Triangulation> tree(s.triangulation);
    for(int i = 0; i < n; ++i) {
      const FG::Geodesic_tree_report report =
          i == 1 ? tree.grow(s.random_vertex(), CGAL::parameters::max_distance(2.5)) : tree.grow(s.random_vertex());
      summary.results.add(static_cast<long long>(report.status));
      summary.flips += report.flips;
      summary.steps += report.flip_outs;
      summary.lengths.add(report.smallest_angle);
      reopened += report.reopened;
      add_tree(tree, summary);
      const FG::Distances_report shortest = FG::make_shortest(tree);
      summary.results.add(static_cast<long long>(shortest.status));
      windows += shortest.windows;
      vertices += shortest.vertices;
      longer += shortest.longer_before + shortest.longer;
      mended += shortest.flips;
      confirmed += shortest.is_confirmed() ? 1 : 0;
      summary.lengths.add(1 + shortest.largest_excess_before);
      add_tree(tree, summary);
      if(i == 0)
        s.triangulation.rollback();
    }
    extra.count("reopened", reopened);
    extra.count("windows", windows);
    extra.count("vertices", vertices);
    extra.count("longer", longer);
    extra.count("mended", mended);
    extra.count("confirmed", confirmed);
  }

  int n; // how many
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_RECORDED_RESULTS_ADDED_CURVES_H
