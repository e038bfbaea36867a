// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The meshes, and sums of results that are compared with recorded ones.

#ifndef FLIP_GEODESICS_TEST_RECORDED_RESULTS_COMPARISON_H
#define FLIP_GEODESICS_TEST_RECORDED_RESULTS_COMPARISON_H

#include "Curve_setting.h"
#include "Hostile_traits.h"
#include "Recorded_results.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;

using Plain = Curve_setting::Triangulation;
using Certified =
    FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>;
using Hostile = FG::Intrinsic_triangulation<Surface, Hostile_traits>;

struct Input
{
  std::string name;
  Mesh_soup soup;
};

inline Mesh_soup stretched(const Mesh_soup& soup, double x, double y, double z)
{
  return mapped(soup, [=](const Coordinates& p) { return Coordinates{p[0] * x, p[1] * y, p[2] * z}; });
}

// So rough that shortest paths cross faces of other triangulations several times.
inline Mesh_soup terrain(int n, double height)
{
  Random_numbers random(6);
  return grid(n, n, Diagonal_rule::RANDOM, [&](int, int) { return random.uniform(0, height); });
}

inline Mesh_soup two_pieces()
{
  return with_isolated_vertices(disjoint_union(octahedron(5), translated(shaken(octahedron(5), 0.2, 3), 20, 0, 0)), 1,
                                1);
}

// Ties, needles, borders, handles, vertices with small and large angles, several components.
inline const std::vector<Input>& inputs()
{
  static const std::vector<Input> result = [] {
    const std::vector<Input> all = {
        {"flat_grid", flat_grid(12, 10, Diagonal_rule::ALTERNATING)},
        {"jittered_grid", jittered_grid(14, 14, Diagonal_rule::RANDOM, 0.24, 5)},
        {"grid_with_hole", grid_with_hole(12, 14, 3, 8, 4, 11)},
        {"hills", grid(16, 16, Diagonal_rule::RANDOM, [](int i, int j) { return ((i * 7 + j * 13) % 5) * 0.4; })},
        {"terrain", terrain(12, 60)},
        {"needle_strip", needle_strip(20, 6, 1e-3)},
        {"box", box(3, 2, 1, 6)},
        {"tetrahedron", tetrahedron(8)},
        {"plate", genus_3_plate(2)},
        {"shaken_plate", shaken(genus_3_plate(3), 0.3, 4)},
        {"pointed_cone", cone_disk(9, 9, 2)},
        {"blunt_cone", cone_disk(12, 8, 5)},
        {"saddle", saddle_disk(12, 8, 9)},
        {"ruff", saddle_disk(16, 7, 14)},
        {"lantern", lantern(10, 40)},
        {"closed_cylinder", cylinder(24, 3, 1, 30, true)},
        {"torus", shaken(torus(26, 14, 3, 1), 0.05, 2)},
        {"bumpy_sphere", bumpy_sphere(8, 0.3, 1)},
        {"flattened_sphere", stretched(bumpy_sphere(7, 0.2, 2), 1, 1, 1e-4)},
        {"polyhedron", random_convex_polyhedron(150, 7)},
        {"needle_polyhedron", stretched(random_convex_polyhedron(120, 8), 1, 1e-3, 1)},
        {"two_pieces", two_pieces()}};
    std::vector<Input> chosen;
    for(std::size_t i = 0; i < all.size(); i += stride)
      chosen.push_back({all[i].name, with_rounded_coordinates(all[i].soup)});
    return chosen;
  }();
  return result;
}

template <class Triangulation>
struct Setting
{
  using Network = FG::Edge_path_network<Triangulation>;

  explicit Setting(const Input& input, const typename Triangulation::Traits& traits = typename Triangulation::Traits())
    : mesh(to_mesh<Surface>(input.soup))
    , triangulation(mesh, traits)
    , random(static_cast<unsigned>(input.soup.triangles.size()))
    , has_two_pieces(input.name == "two_pieces")
  {
  }

  FG::Vertex_index random_vertex()
  {
    FG::Vertex_index v;
    do
      v = FG::Vertex_index(random.below(triangulation.input().number_of_vertices()));
    while(triangulation.input().outgoing(v) == FG::null_index);
    return v;
  }

  // In a face, on an edge, at a vertex; of two pieces, in one of them.
  FG::Surface_location random_location(bool is_far)
  {
    const auto is_unwanted = [&](FG::Input_halfedge_index h) {
      return triangulation.input().is_border(h) ||
             (has_two_pieces &&
              is_far != (triangulation.input().tail(h).idx() > triangulation.input().number_of_vertices() / 2));
    };
    FG::Input_halfedge_index h;
    do
      h = FG::Input_halfedge_index(random.below(triangulation.input().number_of_halfedges()));
    while(is_unwanted(h));
    const int kind = random.below(6);
    return {h,
            {{random.uniform(0.1, 1), kind == 0 ? 0 : random.uniform(0.1, 1), kind < 3 ? 0 : random.uniform(0.1, 1)}}};
  }

  std::vector<FG::Surface_location> random_locations(int n)
  {
    const bool is_far = random.below(2) == 0;
    std::vector<FG::Surface_location> result;
    for(int i = 0; i < n; ++i)
      result.push_back(random_location(is_far));
    return result;
  }

  Surface mesh;
  Triangulation triangulation;
  Random_numbers random;
  bool has_two_pieces;
};

// Sums up results of a kind: one hash of all paths, flips and statuses, and numbers that show what has changed.
struct Summary
{
  Integer_hash results;
  Weighted_sum lengths;
  std::size_t flips = 0, steps = 0, errors = 0;

  template <class Network>
  void add_curves(const Network& network)
  {
    const auto& triangulation = network.triangulation();
    for(FG::Curve_index c : FG::internal::descriptors<FG::Curve_index>(network.number_of_curves())) {
      const auto halfedges = network.halfedges(c);
      results.add(static_cast<long long>(halfedges.size()));
      for(const auto h : halfedges) {
        results.add(h);
        add(triangulation.edge_sequence(h));
        results.add_all(network.bundle(Plain::edge(h)));
      }
      lengths.add(network.length(c));
    }
    add_log(triangulation);
  }

  void add(const FG::Edge_sequence& word)
  {
    for(long long i : {word.along.idx(), word.face.idx(), word.tail.idx(), word.head.idx()})
      results.add(i);
    results.add_all(word.crossed);
  }

  template <class Triangulation>
  void add_log(const Triangulation& triangulation)
  {
    for(std::size_t i = 0; i < triangulation.log_position(); ++i)
      results.add(triangulation.flip_record(i).h);
  }

  void add(const FG::Shortening_report& report)
  {
    flips += report.flips;
    steps += report.flip_outs;
    for(const FG::Curve_report& curve : report.curves) {
      results.add(static_cast<long long>(curve.status));
      results.add(static_cast<long long>(curve.flips));
      lengths.add(curve.initial_length);
      lengths.add(curve.length);
      lengths.add(curve.smallest_angle);
    }
  }

  void add(const FG::Surface_location& location)
  {
    results.add(location.halfedge);
    const auto& w = location.weights;
    for(double weight : w) {
      results.add(weight != 0);
      lengths.add(weight / (w[0] + w[1] + w[2]));
    }
  }

  void add(const FG::Surface_point& p)
  {
    for(long long i : {p.a.idx(), p.b.idx(), p.c.idx(), p.halfedge.idx(), p.vertex.idx()})
      results.add(i);
    lengths.add(p.t);
    lengths.add(p.u);
  }

  template <class Element>
  void add(const std::vector<Element>& elements)
  {
    results.add(static_cast<long long>(elements.size()));
    for(const Element& element : elements)
      add(element);
  }

  // Refusals are results, too.
  template <class Function>
  void attempt(const Function& function)
  {
    try {
      function();
    } catch(const std::exception&) {
      ++errors;
    }
  }

  Result result() const
  {
    Result all;
    all.add("results", results);
    all.count("flips", flips);
    all.count("steps", steps);
    all.count("errors", errors);
    all.add("lengths", lengths);
    return all;
  }
};

// Calls `function(setting, summary, extra)` for each mesh, and compares what it adds.
template <class Triangulation, class Function>
void compare(const std::string& name, Depends_on depends_on, const Function& function)
{
  Recorded_results recorded(FLIP_GEODESICS_RECORDED_RESULTS, name, depends_on);
  for(const Input& input : inputs()) {
    Setting<Triangulation> setting(input);
    Summary summary;
    Result extra;
    summary.attempt([&] { function(setting, summary, extra); });
    Result result = summary.result();
    result.append(extra);
    recorded.compare(input.name, result);
  }
  recorded.finish();
}

// For some meshes, with traits that are wrong as no rounding is: one hash of the results with each error of the traits.
template <class Function>
void compare_among_lies(const std::string& name, const Function& function)
{
  Recorded_results recorded(FLIP_GEODESICS_RECORDED_RESULTS, name, Depends_on::ARITHMETIC);
  for(const Input& input : inputs()) {
    if(input.soup.triangles.size() > 300)
      continue;
    Summary summary;
    for(int period : {3, 8}) {
      Liar liar(period);
      std::map<std::string, Lies> all;
      all["stiff"].is_quad_reflex = [&](bool truth) { return truth || liar(false); };
      all["straight"].is_wedge_straight = [&](int, bool truth) { return truth || liar(false); };
      all["bent"].is_wedge_straight = [&](int corners, bool truth) { return truth && !(corners > 1 && liar(false)); };
      if(name == "hostile_trees")
        all.erase("stiff"); // trees rely on arcs being free of edges: an assertion says so
      for(const auto& lie : all) {
        Setting<Hostile> setting(input, Hostile_traits(lie.second));
        Result extra;
        summary.attempt([&] { function(setting, summary, extra); });
        summary.results.add_text(extra.text());
      }
    }
    recorded.compare(input.name, summary.result());
  }
  recorded.finish();
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_RECORDED_RESULTS_COMPARISON_H
