// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Results are a function of the input alone: what the public functions give on small meshes of all kinds, compared with
// what they gave once. Other tests say what is right; this one says that nothing has changed, be it the paths, their
// order, or the work. Where a change is meant, FLIP_GEODESICS_RECORD=1 in the environment writes the file anew.

#define BOOST_TEST_MODULE recorded_results

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

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Plain = Curve_setting::Triangulation;
using Certified =
    FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>;
using Hostile = FG::Intrinsic_triangulation<Surface, Hostile_traits>;

// ---------------------------------------------------------------- meshes

struct Input
{
  std::string name;
  Mesh_soup soup;
};

// What the functions of a library of mathematics do not agree on is cut off.
Mesh_soup rounded(const Mesh_soup& soup)
{
  return mapped(soup, [](Coordinates p) {
    for(double& x : p)
      x = std::nearbyint(x * (1 << 24)) / (1 << 24);
    return p;
  });
}

Mesh_soup stretched(const Mesh_soup& soup, double x, double y, double z)
{
  return mapped(soup, [=](const Coordinates& p) { return Coordinates{p[0] * x, p[1] * y, p[2] * z}; });
}

// So rough that shortest paths cross faces of other triangulations several times.
Mesh_soup terrain(int n, double height)
{
  Random_numbers random(6);
  return grid(n, n, Diagonal_rule::RANDOM, [&](int, int) { return random.uniform(0, height); });
}

Mesh_soup two_pieces()
{
  return with_isolated_vertices(disjoint_union(octahedron(5), translated(shaken(octahedron(5), 0.2, 3), 20, 0, 0)), 1,
                                1);
}

// Ties, needles, borders, handles, vertices with small and large angles, several components.
const std::vector<Input>& inputs()
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
      chosen.push_back({all[i].name, rounded(all[i].soup)});
    return chosen;
  }();
  return result;
}

// ---------------------------------------------------------------- what is told of results

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

// Sums up results of a kind.
struct Summary
{
  Integer_hash words, flipped, statuses;
  Weighted_sum lengths;
  std::size_t flips = 0, steps = 0, errors = 0;

  template <class Network>
  void add_curves(const Network& network)
  {
    const auto& triangulation = network.triangulation();
    for(FG::Curve_index c : FG::internal::descriptors<FG::Curve_index>(network.number_of_curves())) {
      const auto halfedges = network.halfedges(c);
      words.add(static_cast<long long>(halfedges.size()));
      for(const auto h : halfedges) {
        words.add(h);
        add(triangulation.crossing_word(h));
        words.add_all(network.stack(Plain::edge(h)));
      }
      lengths.add(network.length(c));
    }
    add_log(triangulation);
  }

  void add(const FG::Crossing_word& word)
  {
    for(long long i : {word.along.idx(), word.face.idx(), word.tail.idx(), word.head.idx()})
      words.add(i);
    words.add_all(word.crossed);
  }

  template <class Triangulation>
  void add_log(const Triangulation& triangulation)
  {
    for(std::size_t i = 0; i < triangulation.log_position(); ++i)
      flipped.add(triangulation.flip_record(i).h);
  }

  void add(const FG::Shortening_report& report)
  {
    flips += report.flips;
    steps += report.flip_outs;
    for(const FG::Curve_report& curve : report.curves) {
      statuses.add(static_cast<long long>(curve.status));
      statuses.add(static_cast<long long>(curve.flips));
      lengths.add(curve.initial_length);
      lengths.add(curve.length);
      lengths.add(curve.smallest_angle);
    }
  }

  void add(const FG::Surface_location& location)
  {
    words.add(location.halfedge);
    const auto& w = location.weights;
    for(double weight : w) {
      words.add(weight != 0);
      lengths.add(weight / (w[0] + w[1] + w[2]));
    }
  }

  void add(const FG::Surface_point& p)
  {
    for(long long i : {p.a.idx(), p.b.idx(), p.c.idx(), p.halfedge.idx(), p.vertex.idx()})
      words.add(i);
    lengths.add(p.t);
    lengths.add(p.u);
  }

  template <class Element>
  void add(const std::vector<Element>& elements)
  {
    words.add(static_cast<long long>(elements.size()));
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
    all.add("words", words);
    all.add("flipped", flipped);
    all.add("statuses", statuses);
    all.count("flips", flips);
    all.count("steps", steps);
    all.count("errors", errors);
    all.add("lengths", lengths);
    return all;
  }
};

// Calls `function(setting, summary, extra)`, and compares what it adds.
template <class Triangulation, class Function>
void compare_one(Recorded_results& recorded, const std::string& name, Setting<Triangulation>& setting,
                 const Function& function)
{
  Summary summary;
  Result extra;
  summary.attempt([&] { function(setting, summary, extra); });
  Result result = summary.result();
  result.append(extra);
  recorded.compare(name, result);
}

// For each mesh.
template <class Triangulation, class Function>
void compare(const std::string& name, Depends_on depends_on, const Function& function)
{
  Recorded_results recorded(FLIP_GEODESICS_RECORDED_RESULTS, name, depends_on);
  for(const Input& input : inputs()) {
    Setting<Triangulation> setting(input);
    compare_one(recorded, input.name, setting, function);
  }
  recorded.finish();
}

// For some meshes, with traits that are wrong as no rounding is.
template <class Function>
void compare_among_lies(const std::string& name, const Function& function)
{
  Recorded_results recorded(FLIP_GEODESICS_RECORDED_RESULTS, name, Depends_on::ARITHMETIC);
  for(const Input& input : inputs()) {
    if(input.soup.triangles.size() > 300)
      continue;
    for(int period : {3, 8}) {
      Liar liar(period);
      std::map<std::string, Lies> all;
      all["stiff"].is_quad_reflex = [&](bool truth) { return truth || liar(false); };
      all["straight"].is_wedge_straight = [&](int, bool truth) { return truth || liar(false); };
      all["bent"].is_wedge_straight = [&](int corners, bool truth) { return truth && !(corners > 1 && liar(false)); };
      if(name == "hostile_trees")
        all.erase("stiff"); // trees rely on arcs being free of edges: an assertion says so
      for(const auto& [lie, lies] : all) {
        Setting<Hostile> setting(input, Hostile_traits(lies));
        compare_one(recorded, input.name + "_" + lie + "_" + std::to_string(period), setting, function);
      }
    }
  }
  recorded.finish();
}

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
    FG::Shortest_edge_path<Triangulation> search(s.triangulation, FG::Search_method::LOOK_BACK);
    std::size_t settled = 0, beforehand = 0;
    for(int i = 0; i < n; ++i) {
      typename Setting<Triangulation>::Network network(s.triangulation);
      const FG::Vertex_index v = s.random_vertex(), w = s.random_vertex();
      summary.attempt([&] {
        const auto path = search(v, w);
        settled += search.settled_vertices();
        summary.words.add_all(path);
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
  FG::Shortest_edge_path<Triangulation> search(s.triangulation, FG::Search_method::DIJKSTRA);
  const FG::Vertex_index v = s.random_vertex();
  for(int i = 0; i < n; ++i) {
    const auto path = search(v, s.random_vertex());
    if(!path.empty())
      network.add_curve(path, false);
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
const std::vector<Stop>& stops()
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
    FG::Shortest_edge_path<Triangulation> measure(s.triangulation, FG::Search_method::LOOK_BACK);
    const FG::Landmark_distances landmarks(measure);
    FG::Shortest_edge_path<Triangulation> search(s.triangulation, landmarks);
    std::size_t settled = 0;
    for(std::size_t i = 0; i < 2 * stops().size(); ++i) {
      Network network(s.triangulation);
      const FG::Vertex_index v = s.random_vertex();
      summary.attempt([&] {
        for(std::size_t j = 0; j < 2 + i % 3; ++j) {
          const FG::Vertex_index w = s.random_vertex();
          summary.lengths.add(landmarks.distance_lower_bound(v, w));
          if(const auto path = search(v, w); !path.empty())
            network.add_curve(path, false);
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
        const auto report =
            FG::add_shortest_path(network, search, v, w, i % 10 == 5 ? FG::Window_limit(100) : FG::Window_limit());
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
    summary.words.add(tree.incoming(v));
    if(tree.is_reached(v))
      summary.lengths.add(tree.distance(v));
    if(tree.incoming(v) != FG::null_index)
      summary.add(triangulation.crossing_word(tree.incoming(v)));
  }
  for(const FG::Polar_coordinates& p : FG::logarithmic_map(tree).vertices)
    summary.lengths.add(p.angle + 1);
  summary.add_log(triangulation);
}

struct Add_trees
{
  template <class Triangulation>
  void operator()(Setting<Triangulation>& s, Summary& summary, Result& extra) const
  {
    std::size_t reopened = 0, windows = 0, longer = 0, vertices = 0, mended = 0, confirmed = 0;
    Weighted_sum excess;
    FG::Geodesic_tree<Triangulation> tree(s.triangulation);
    for(int i = 0; i < n; ++i) {
      const FG::Geodesic_tree_report report = i == 1 ? tree.grow(s.random_vertex(), 2.5) : tree.grow(s.random_vertex());
      summary.statuses.add(static_cast<long long>(report.status));
      summary.flips += report.flips;
      summary.steps += report.flip_outs;
      summary.lengths.add(report.smallest_angle);
      reopened += report.reopened;
      add_tree(tree, summary);
      const FG::Shortest_tree_report shortest = FG::make_shortest(tree);
      summary.statuses.add(static_cast<long long>(shortest.status));
      windows += shortest.windows;
      vertices += shortest.vertices;
      longer += shortest.longer_before + shortest.longer;
      mended += shortest.flips;
      confirmed += shortest.is_confirmed ? 1 : 0;
      excess.add(1 + shortest.largest_excess_before);
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
    extra.add("excess", excess);
  }

  int n; // how many
};

void add(const FG::Refinement_report& report, Summary& summary, Result& extra)
{
  summary.statuses.add(static_cast<long long>(report.status));
  summary.flips += report.flips;
  summary.lengths.add(report.smallest_angle);
  summary.lengths.add(report.smallest_free_angle);
  extra.count("insertions", report.insertions);
  extra.count("splits", report.splits);
  extra.count("refused", report.refused);
  extra.count("exempt", report.exempt);
  extra.count("missed", report.missed);
  extra.count("given_up", report.given_up);
}

template <class Triangulation>
void add_places(const Triangulation& triangulation, Summary& summary)
{
  for(FG::Vertex_index v(triangulation.input().number_of_vertices()); v.idx() < triangulation.number_of_vertices(); ++v)
    summary.add(triangulation.location(v));
  for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(triangulation.number_of_edges())) {
    const FG::Halfedge_index h = FG::internal::first_side(e);
    summary.add(triangulation.crossing_word(h));
    summary.lengths.add(triangulation.length(h));
  }
  summary.add_log(triangulation);
}

template <class Subdivision>
void add_subdivision(const Subdivision& subdivision, Summary& summary, Result& extra)
{
  const auto& mesh = subdivision.mesh();
  for(const auto v : mesh.vertices()) {
    const FG::Subdivision_vertex origin = subdivision.vertex_origin(v);
    summary.add(origin.on_input);
    summary.words.add(origin.intrinsic_vertex);
    summary.words.add(origin.intrinsic_halfedge);
    summary.lengths.add(origin.intrinsic_t);
  }
  for(const auto f : mesh.faces()) {
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      summary.words.add(static_cast<long long>(v));
    summary.words.add(subdivision.input_face(f));
    summary.words.add(subdivision.intrinsic_face(f));
    summary.lengths.add(subdivision.area(f));
    for(const auto& corner : subdivision.corners(f))
      for(double weight : corner)
        summary.lengths.add(weight);
  }
  for(const auto h : mesh.halfedges()) {
    summary.words.add(subdivision.input_halfedge(h));
    summary.words.add(subdivision.intrinsic_halfedge(h));
  }
  std::size_t constrained = 0;
  for(const auto e : mesh.edges())
    constrained += get(subdivision.edge_is_constrained_map(), e) ? 1 : 0;
  extra.count("vertices", mesh.number_of_vertices());
  extra.count("faces", mesh.number_of_faces());
  extra.count("constrained", constrained);
}

} // namespace

// ---------------------------------------------------------------- paths

BOOST_AUTO_TEST_CASE(paths) { compare<Certified>("paths", Depends_on::INPUT, Add_paths{40}); }

BOOST_AUTO_TEST_CASE(plain_paths) { compare<Plain>("plain_paths", Depends_on::INPUT, Add_paths{20}); }

// Pulled tight from the path of edges on, with landmarks, for a while.
BOOST_AUTO_TEST_CASE(stopped_paths) { compare<Certified>("stopped_paths", Depends_on::INPUT, Add_stopped_curves()); }

BOOST_AUTO_TEST_CASE(plain_stopped_paths)
{
  compare<Plain>("plain_stopped_paths", Depends_on::INPUT, Add_stopped_curves());
}

// Paths that cross themselves, turn back, and run along the border.
BOOST_AUTO_TEST_CASE(straightened_walks)
{
  compare<Certified>("straightened_walks", Depends_on::INPUT, [](Setting<Certified>& s, Summary& summary, Result&) {
    for(int i = 0; i < 60; ++i) {
      Setting<Certified>::Network network(s.triangulation);
      summary.attempt([&] {
        summary.flips += FG::add_straightened_path(network, random_walk(s.triangulation, 2 + i / 3, false, s.random));
        summary.add_curves(network);
        FG::order_overlapping_curves(network);
        shorten_and_add(network, summary);
      });
      network.clear();
      s.triangulation.rollback();
    }
  });
}

BOOST_AUTO_TEST_CASE(loops)
{
  compare<Certified>("loops", Depends_on::INPUT, [](Setting<Certified>& s, Summary& summary, Result&) {
    FG::Shortest_edge_path<Certified> search(s.triangulation);
    for(int i = 0; i < 16; ++i) {
      Setting<Certified>::Network network(s.triangulation);
      const Vertex_sequence way = {s.random_vertex(), s.random_vertex(), s.random_vertex()};
      summary.attempt([&] {
        network.add_curve(FG::shortest_halfedges_through(search, way, true), true);
        FG::order_overlapping_curves(network);
        if(i % 2 == 1)
          network.fix_nodes_at(way[0]);
        shorten_and_add(network, summary);
        const FG::Network_certificate certificate = FG::certify(network);
        summary.statuses.add(static_cast<long long>(certificate.curves[0].verdict));
        FG::Curve_extractor<Setting<Certified>::Network> extractor(network);
        summary.add(extractor.surface_points(0_c));
      });
      network.clear();
      s.triangulation.rollback();
    }
  });
}

BOOST_AUTO_TEST_CASE(networks) { compare<Certified>("networks", Depends_on::INPUT, Add_networks{8}); }

BOOST_AUTO_TEST_CASE(plain_networks) { compare<Plain>("plain_networks", Depends_on::INPUT, Add_networks{8}); }

BOOST_AUTO_TEST_CASE(shortest_paths)
{
  compare<Certified>("shortest_paths", Depends_on::ARITHMETIC, Add_shortest_paths{20});
}

// ---------------------------------------------------------------- curves through points

BOOST_AUTO_TEST_CASE(curves_through_points)
{
  compare<Certified>("curves_through_points", Depends_on::ARITHMETIC,
                     [](Setting<Certified>& s, Summary& summary, Result&) {
                       for(int i = 0; i < 10; ++i) {
                         const auto locations = s.random_locations(4);
                         summary.attempt([&] {
                           const FG::Free_legs legs = FG::geodesics_through(s.triangulation, locations);
                           summary.add(legs.legs);
                           summary.add(legs.report);
                           summary.statuses.add(static_cast<long long>(legs.certificate.verdict));
                         });
                         Setting<Certified>::Network network(s.triangulation);
                         summary.attempt([&] {
                           if(i % 2 == 1)
                             FG::flip_to_delaunay(s.triangulation);
                           FG::add_curve_through(network, locations, i >= 5);
                           FG::order_overlapping_curves(network);
                           shorten_and_add(network, summary);
                           std::vector<std::pair<Surface::Face_index, std::array<double, 3>>> in_faces;
                           FG::Curve_extractor<Setting<Certified>::Network>(network).face_locations(
                               0_c, s.mesh, std::back_inserter(in_faces));
                           for(const auto& [face, weights] : in_faces) {
                             summary.words.add(static_cast<long long>(face));
                             for(double weight : weights)
                               summary.lengths.add(weight);
                           }
                           network.free_nodes(0_c);
                           shorten_and_add(network, summary);
                         });
                         network.clear();
                         s.triangulation.rollback();
                       }
                     });
}

BOOST_AUTO_TEST_CASE(polylines)
{
  compare<Certified>("polylines", Depends_on::ARITHMETIC, [](Setting<Certified>& s, Summary& summary, Result&) {
    for(int i = 0; i < 8; ++i) {
      const bool is_closed = i % 2 == 1;
      std::vector<FG::Surface_location> polyline;
      summary.attempt([&] {
        polyline = FG::complete_polyline(s.triangulation, s.random_locations(4), is_closed);
        summary.add(polyline);
        const auto snapped = FG::snap_polyline(s.triangulation, polyline, is_closed);
        summary.words.add_all(snapped);
      });
      Setting<Certified>::Network network(s.triangulation);
      summary.attempt([&] {
        FG::draw_polyline(network, polyline, is_closed);
        FG::order_overlapping_curves(network);
        summary.add_curves(network);
        shorten_and_add(network, summary);
        network.free_nodes(0_c);
        shorten_and_add(network, summary);
      });
      network.clear();
      s.triangulation.rollback();
    }
  });
}

BOOST_AUTO_TEST_CASE(splines)
{
  compare<Certified>("splines", Depends_on::ARITHMETIC, [](Setting<Certified>& s, Summary& summary, Result& extra) {
    std::size_t pieces = 0;
    for(int i = 0; i < 2; ++i) {
      const auto points = s.random_locations(4);
      Setting<Certified>::Network network(s.triangulation);
      summary.attempt([&] {
        const FG::Curve_index curve = FG::add_curve_through(network, points);
        FG::order_overlapping_curves(network);
        auto spline = i == 0 ? FG::Geodesic_spline<Setting<Certified>::Network>(network, curve)
                             : FG::Geodesic_spline<Setting<Certified>::Network>::cubic_b_spline(network, curve);
        summary.words.add(spline.refine(0.01, 3));
        summary.words.add_all(spline.vertices_on_curve());
        pieces += spline.number_of_pieces();
        summary.add(spline.finish());
        summary.add_curves(network);
      });
      network.clear();
      s.triangulation.rollback();
    }
    extra.count("pieces", pieces);
  });
}

BOOST_AUTO_TEST_CASE(free_splines)
{
  compare<Certified>("free_splines", Depends_on::ARITHMETIC, [](Setting<Certified>& s, Summary& summary, Result&) {
    for(auto kind : {FG::Spline_kind::BEZIER, FG::Spline_kind::CUBIC_B_SPLINE, FG::Spline_kind::CLOSED_CUBIC_B_SPLINE})
    {
      const auto points = s.random_locations(4);
      summary.attempt([&] {
        FG::Free_geodesic_spline<Certified> spline(s.triangulation, points, kind);
        summary.words.add(spline.refine(0.02, 2));
        summary.lengths.add(spline.length());
        summary.add(spline.finish());
        summary.add(spline.report());
        summary.statuses.add(static_cast<long long>(spline.certificate().verdict));
      });
    }
  });
}

// ---------------------------------------------------------------- trees

BOOST_AUTO_TEST_CASE(trees) { compare<Certified>("trees", Depends_on::ARITHMETIC, Add_trees{3}); }

BOOST_AUTO_TEST_CASE(plain_trees) { compare<Plain>("plain_trees", Depends_on::ARITHMETIC, Add_trees{3}); }

// After vertices were inserted, of which the search for shortest paths knows nothing.
BOOST_AUTO_TEST_CASE(trees_of_refined_meshes)
{
  compare<Certified>("trees_of_refined_meshes", Depends_on::ARITHMETIC,
                     [](Setting<Certified>& s, Summary& summary, Result& extra) {
                       FG::Refinement_options options;
                       options.maximum_insertions = 60;
                       FG::refine(s.triangulation, options);
                       Add_trees{3}(s, summary, extra);
                     });
}

// ---------------------------------------------------------------- among lies

BOOST_AUTO_TEST_CASE(hostile_paths) { compare_among_lies("hostile_paths", Add_paths{8}); }

#ifndef _GLIBCXX_DEBUG // containers that check are larger, so that a limit of memory stops elsewhere
BOOST_AUTO_TEST_CASE(hostile_stopped_paths)
{
  compare_among_lies("hostile_stopped_paths", Add_stopped_curves());
}
#endif

BOOST_AUTO_TEST_CASE(hostile_shortest_paths)
{
  compare_among_lies("hostile_shortest_paths", Add_shortest_paths{6});
}

BOOST_AUTO_TEST_CASE(hostile_networks) { compare_among_lies("hostile_networks", Add_networks{2}); }

BOOST_AUTO_TEST_CASE(hostile_trees) { compare_among_lies("hostile_trees", Add_trees{2}); }

// ---------------------------------------------------------------- other triangulations

BOOST_AUTO_TEST_CASE(delaunay)
{
  compare<Certified>("delaunay", Depends_on::INPUT, [](Setting<Certified>& s, Summary& summary, Result& extra) {
    summary.flips += FG::flip_to_delaunay(s.triangulation).flips;
    add_places(s.triangulation, summary);
    for(int i = 0; i < 20; ++i) {
      const FG::Vertex_index v = s.random_vertex(), w = s.random_vertex();
      summary.words.add_all(FG::shortest_intrinsic_edge_path(s.triangulation, v, w));
    }
    add_subdivision(FG::common_subdivision(s.triangulation, s.mesh), summary, extra);
  });
}

BOOST_AUTO_TEST_CASE(refinement)
{
  compare<Certified>("refinement", Depends_on::ARITHMETIC, [](Setting<Certified>& s, Summary& summary, Result& extra) {
    FG::Refinement_options options;
    options.maximum_insertions = 300;
    add(FG::refine(s.triangulation, options), summary, extra);
    add_places(s.triangulation, summary);
  });
}

BOOST_AUTO_TEST_CASE(plain_refinement)
{
  compare<Plain>("plain_refinement", Depends_on::ARITHMETIC, [](Setting<Plain>& s, Summary& summary, Result& extra) {
    FG::Refinement_options options;
    options.maximum_insertions = 300;
    options.smallest_angle = 20;
    options.longest_edge = 0.8;
    add(FG::refine(s.triangulation, options), summary, extra);
    add_places(s.triangulation, summary);
  });
}

BOOST_AUTO_TEST_CASE(refinement_about_curves)
{
  compare<Certified>(
      "refinement_about_curves", Depends_on::ARITHMETIC, [](Setting<Certified>& s, Summary& summary, Result& extra) {
        Setting<Certified>::Network network(s.triangulation);
        add_star(s, network, 5);
        shorten_and_add(network, summary);
        const FG::Delaunay_report flipped = FG::flip_to_delaunay(s.triangulation, FG::edges_near_curves(network));
        extra.count("constrained", flipped.constrained);
        summary.flips += flipped.flips;
        FG::Refinement_options options;
        options.maximum_insertions = 300;
        add(FG::refine(network, options), summary, extra);
        add_places(s.triangulation, summary);
        summary.add_curves(network);
      });
}

BOOST_AUTO_TEST_CASE(subdivision_along_curves)
{
  compare<Certified>("subdivision_along_curves", Depends_on::INPUT,
                     [](Setting<Certified>& s, Summary& summary, Result& extra) {
                       Setting<Certified>::Network network(s.triangulation);
                       add_star(s, network, 5);
                       shorten_and_add(network, summary);
                       summary.attempt([&] { add_subdivision(FG::insert_curves(network, s.mesh), summary, extra); });
                       summary.attempt([&] { add_subdivision(FG::cut_along_curves(network, s.mesh), summary, extra); });
                     });
}

// ---------------------------------------------------------------- curves from data

// Regions by bands of numbers of vertices, which are anything but smooth.
BOOST_AUTO_TEST_CASE(region_boundaries)
{
  compare<Certified>("region_boundaries", Depends_on::INPUT, [](Setting<Certified>& s, Summary& summary, Result&) {
    const auto regions = s.mesh.add_property_map<Surface::Face_index, int>("f:region", 0).first;
    const int most = s.triangulation.input().number_of_vertices() / 3 + 1;
    for(const auto f : s.mesh.faces())
      regions[f] = static_cast<int>(s.mesh.target(s.mesh.halfedge(f))) / most;
    for(FG::Junctions junctions : {FG::Junctions::FIXED, FG::Junctions::FREE}) {
      Setting<Certified>::Network network(s.triangulation);
      summary.attempt([&] {
        summary.words.add(FG::add_region_boundaries(network, s.mesh, regions, junctions));
        shorten_and_add(network, summary);
      });
      network.clear();
      s.triangulation.rollback();
    }
  });
}
