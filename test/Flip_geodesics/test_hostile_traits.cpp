// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE hostile_traits

#include "Curve_setting.h"
#include "Hostile_traits.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Shortener.h>
#include <CGAL/Flip_geodesics/Straightness_meter.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/straightened_path.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <stdexcept>
#include <vector>

/*
 * What holds whatever the traits say: no step makes a curve longer, what is not taken leaves no trace, words are right,
 * and everything ends.
 */
namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using FG::Curve_index;
using FG::Edge_index;
using FG::Halfedge_index;
using FG::Index;
using FG::Segment_index;
using FG::Vertex_index;
using FG::internal::descriptors;
using FG::internal::first_side;

namespace {

using Triangulation = FG::Intrinsic_triangulation<Surface, Hostile_traits>;
using Setting = Basic_curve_setting<Triangulation>;

// Flips in the log, not faces laid out afresh.
template <class T>
std::size_t logged_flips(const T& triangulation)
{
  std::size_t result = 0;
  for(std::size_t i = 0; i < triangulation.log_position(); ++i)
    result += triangulation.flip_record(i).hp != FG::null_index ? 1 : 0;
  return result;
}

// Follows a shortening: steps shorten, and the log holds the flips of the steps that were taken.
struct Watcher
{
  explicit Watcher(const Setting& setting)
    : length(setting.network.length(0_c))
    , flips_of_steps(logged_flips(setting.triangulation))
  {
  }

  template <class T>
  void on_flip(const T&, Halfedge_index)
  {
    ++flips_of_step;
  }

  template <class Network>
  void after_flip_out(const Network& network, Curve_index curve)
  {
    ++steps;
    const std::size_t flips_before = flips_of_steps;
    const double now = network.length(curve);
    has_grown = has_grown || now > length * (1 + 1e-12);
    length = now;
    flips_of_steps = logged_flips(network.triangulation());
    partial_steps += flips_before + flips_of_step > flips_of_steps ? 1 : 0;
  }

  bool go_further()
  {
    flips_of_step = 0;
    return steps < 100000;
  }

  double length;
  std::size_t flips_of_step = 0, flips_of_steps = 0, steps = 0;
  std::size_t partial_steps = 0; // of whose flips some were taken back
  bool has_grown = false;
};

// Pulls tight among lies. Returns the number of flips that were taken back.
std::size_t check_shortening(Setting& setting, Watcher& watcher)
{
  const double before = setting.network.length(0_c);
  const std::size_t flips_before = watcher.flips_of_steps;
  FG::Shortener<Setting::Network> shortener(setting.network);
  shortener.run(FG::Never_stop_predicate(), watcher);
  BOOST_TEST(!watcher.has_grown);
  BOOST_TEST(watcher.steps < 100000u);
  BOOST_TEST(setting.network.is_valid());
  BOOST_TEST(setting.triangulation.is_valid(1e-6));
  BOOST_TEST(setting.network.length(0_c) <= before * (1 + 1e-12));
  BOOST_TEST(std::abs(shortener.length() - setting.network.length(0_c)) <= 1e-12 * before);
  BOOST_TEST(std::abs(shortener.length(0_c) - setting.network.length(0_c)) <= 1e-12 * before);
  BOOST_TEST(logged_flips(setting.triangulation) == watcher.flips_of_steps); // the others have left no trace
  setting.network.for_each_segment(0_c, [&](Segment_index s) {
    BOOST_CHECK_NO_THROW(setting.triangulation.crossing_word(setting.network.halfedge(s)));
  });
  return shortener.number_of_flips() + flips_before - watcher.flips_of_steps;
}

std::size_t check_shortening(Setting& setting)
{
  Watcher watcher(setting);
  return check_shortening(setting, watcher);
}

} // namespace

// Edges are not flipped that could be, so that arcs are longer than what they replace.
BOOST_AUTO_TEST_CASE(steps_that_lengthen_leave_no_trace)
{
  for(const Mesh_soup& soup : {jittered_grid(7, 7, Diagonal_rule::RANDOM, 0.2, 1), bumpy_sphere(4, 0.3, 2)}) {
    std::size_t taken_back = 0;
    Random_numbers random(1);
    for(int period : {1, 2, 3, 4, 5, 7, 9})
      for(int i = 0; i < 20; ++i) {
        Lies lies;
        Liar liar(period, i);
        lies.is_quad_reflex = [&](bool is_reflex) { return is_reflex || liar(false); };
        Setting setting(soup, Hostile_traits(lies));
        const int n = setting.triangulation.number_of_vertices(), u = random.below(n);
        setting.add_path(Vertex_index(u), Vertex_index((u + 1 + random.below(n - 1)) % n));
        taken_back += check_shortening(setting);
      }
    BOOST_TEST(taken_back > 100u);
  }
}

// Loops shrink to one segment, which moves as one unit, or not at all.
BOOST_AUTO_TEST_CASE(loops_of_one_segment_that_lengthen_leave_no_trace)
{
  std::size_t taken_back = 0;
  for(int period : {1, 2, 3, 4, 5, 7})
    for(int first = 0; first < period; ++first)
      for(int mesh = 0; mesh < 4; ++mesh) {
        Lies lies;
        Liar liar(period, first);
        lies.is_quad_reflex = [&](bool is_reflex) { return is_reflex || liar(false); };
        Setting setting(mesh == 0
                            ? thirteen_vertex_cone_disk()
                            : (mesh == 1 ? cone_disk(5, 3, 2.5) : (mesh == 2 ? cone_disk(7, 4, 1) : cone(5, 4, 1, 3))),
                        Hostile_traits(lies));
        const int k = mesh == 0 ? 6 : (mesh == 2 ? 7 : 5);
        setting.add(disk_ring(k, mesh == 0 ? 1 : 2), true);
        taken_back += check_shortening(setting);
      }
  BOOST_TEST(taken_back > 10u);
}

// On crooked triangulations a loop of one segment moves by several steps: those that lengthen are taken back, the
// others stay; where the loop is longer after them, all are.
BOOST_AUTO_TEST_CASE(loops_of_one_segment_on_random_triangulations)
{
  std::size_t taken_back = 0, partial_steps = 0;
  for(const Mesh_soup& soup : {shaken(octahedron(1), 0.3, 2), shaken(torus(4, 3, 2, 1), 0.2, 3)})
    for(unsigned seed = 0; seed < 300; ++seed)
      for(bool is_wedge : {false, true})
        for(int period : {1000000000, 1, 2, 3}) {
          Lies lies;
          Liar liar(period, static_cast<int>(seed));
          bool is_lying = false;
          lies.is_quad_reflex = [&](bool truth) { return truth || (!is_wedge && is_lying && liar(false)); };
          lies.is_wedge_straight = [&](int corners, bool truth) {
            return truth && !(is_wedge && is_lying && corners > 1 && liar(false));
          };
          Setting setting(soup, Hostile_traits(lies));
          Random_numbers random(seed);
          flip_at_random(setting.triangulation, random.below(60), random);
          const Halfedge_sequence loop = random_loop_edge(setting.triangulation, random);
          if(loop.empty())
            continue;
          setting.network.add_curve(loop, true);
          Watcher watcher(setting);
          is_lying = true;
          taken_back += check_shortening(setting, watcher);
          partial_steps += watcher.partial_steps;
          if(period > 3) // nothing but the truth
            BOOST_TEST(setting.pull().is_complete());
        }
  BOOST_TEST(taken_back > 100u);
  BOOST_TEST(partial_steps > 0u);
}

// Without lies, such a loop is left when it has no wedge any more on the side that it came from.
BOOST_AUTO_TEST_CASE(loops_of_one_segment_are_shortened_on_the_other_side_to_the_end)
{
  std::size_t moved = 0;
  for(unsigned seed = 0; seed < 400; ++seed) {
    Setting setting(seed % 2 == 0 ? shaken(torus(4, 3, 2, 1), 0.2, 3) : shaken(torus(3, 3, 2, 1), 0.1, 3));
    Random_numbers random(seed);
    flip_at_random(setting.triangulation, random.below(300), random);
    const Halfedge_sequence loop = random_loop_edge(setting.triangulation, random);
    if(loop.empty())
      continue;
    setting.network.add_curve(loop, true);
    const auto is_free = [&](Segment_index s, FG::Side side) {
      return setting.network.wedge({s, side}).state == FG::Wedge_state::FREE;
    };
    const Segment_index only = setting.network.first_segment(0_c);
    if(is_free(only, FG::Side::LEFT) == is_free(only, FG::Side::RIGHT))
      continue;
    const FG::Side other = is_free(only, FG::Side::LEFT) ? FG::Side::RIGHT : FG::Side::LEFT;
    moved += setting.pull(FG::Iteration_stop_predicate(1)).flip_outs;
    setting.network.for_each_segment(
        0_c, [&](Segment_index s) { BOOST_TEST((setting.network.next(s) == s || !is_free(s, other))); });
  }
  BOOST_TEST(moved > 50u);
}

// A loop of one segment that is straight is called bent: its unit does not shorten, and is taken back.
BOOST_AUTO_TEST_CASE(a_straight_loop_of_one_segment_stays)
{
  for(bool is_honest : {true, false})
    for(int n : {3, 4, 5}) {
      Lies lies;
      bool is_lying = false;
      lies.is_wedge_straight = [&](int corners, bool is_straight) { return is_straight && !(is_lying && corners > 1); };
      Setting setting(cylinder(n, 4, 1, 3), Hostile_traits(lies));
      setting.add(cylinder_ring(n, 2), true);
      setting.pull();
      const std::vector<Halfedge_index> before = setting.network.halfedges(0_c);
      const std::size_t log = setting.triangulation.log_position();
      const double length = setting.network.length(0_c);
      is_lying = !is_honest;
      check_shortening(setting);
      BOOST_TEST(std::abs(setting.network.length(0_c) - length) <= 1e-9 * length);
      if(is_honest) {
        BOOST_TEST(setting.network.halfedges(0_c) == before, boost::test_tools::per_element());
        BOOST_TEST(setting.triangulation.log_position() == log);
      }
    }
}

// Joints that are called straight are bent as the input says: looked at again, and never reported as straight.
BOOST_AUTO_TEST_CASE(joints_called_straight_are_looked_at_again_or_told)
{
  int told = 0, mended = 0;
  for(int lies_told : {1, 2, 5, 20, 1000000})
    for(int i = 0; i < 10; ++i) {
      Lies lies;
      int lies_left = lies_told;
      lies.is_wedge_straight = [&](int, bool is_straight) { return is_straight || lies_left-- > 0; };
      Setting setting(jittered_grid(7, 7, Diagonal_rule::RANDOM, 0.2, 1), Hostile_traits(lies));
      setting.add_path(Vertex_index(i), Vertex_index(63 - i));
      const FG::Shortening_report report = FG::shorten(setting.network);
      const FG::Curve_report& curve = report.curves[0];
      const bool is_straight = FG::Straightness_meter<Setting::Network>(setting.network)(0_c).is_locally_shortest();
      BOOST_TEST((curve.status ==
                  (is_straight ? FG::Shortening_status::LOCALLY_SHORTEST : FG::Shortening_status::PRECISION_LIMIT)));
      (is_straight ? mended : told) += 1;
      if(lies_told < 5)
        BOOST_TEST(is_straight);
    }
  BOOST_TEST(told > 5);
  BOOST_TEST(mended > 5);
}

// A visitor that throws in the middle of a unit: the loop is whole, and not longer.
BOOST_AUTO_TEST_CASE(an_exception_leaves_loops_valid)
{
  struct Thrower
  {
    void on_flip(const Triangulation&, Halfedge_index)
    {
      if(--left == 0)
        throw std::runtime_error("enough");
    }
    void after_flip_out(const Setting::Network& network, Curve_index curve) { length = network.length(curve); }
    bool go_further() { return true; }

    int left;
    double length;
  };
  int thrown = 0;
  for(int flips = 1; flips < 60; ++flips) {
    Setting setting(cone_disk(7, 4, 1));
    setting.add(disk_ring(7, 3), true);
    Thrower thrower = {flips, setting.network.length(0_c)};
    try {
      FG::shorten(setting.network, FG::Never_stop_predicate(), thrower);
    } catch(const std::runtime_error&) {
      ++thrown;
      BOOST_TEST(setting.network.is_valid());
      BOOST_TEST(setting.triangulation.is_valid());
      BOOST_TEST(std::abs(setting.network.length(0_c) - thrower.length) <= 1e-12 * thrower.length);
    }
  }
  BOOST_TEST(thrown > 20);
}

// Steps that change nothing that doubles see, round and round a torus: given up after some time.
BOOST_AUTO_TEST_CASE(steps_without_progress_end)
{
  Lies lies;
  lies.is_quad_reflex = [](bool) { return true; }; // no flips
  lies.is_wedge_straight = [](int corners, bool) { return corners > 2; };
  lies.length = [](double) { return 1.0; };
  const int n = 9, m = 6;
  Setting setting(torus(n, m, 3, 1), Hostile_traits(lies));
  setting.add(torus_loop(n, m, 1, 1), true);
  Watcher watcher(setting);
  const FG::Shortening_report report = FG::shorten(setting.network, FG::Never_stop_predicate(), watcher);
  BOOST_TEST(!watcher.has_grown);
  BOOST_TEST(watcher.steps > 10000u);
  BOOST_TEST(watcher.steps < 100000u);
  BOOST_TEST((report.curves[0].status == FG::Shortening_status::PRECISION_LIMIT));
  BOOST_TEST(setting.network.is_valid());
}

// Legs that cannot be inserted: the path itself is the curve, and nothing is flipped.
BOOST_AUTO_TEST_CASE(a_straightened_path_that_cannot_be_inserted_leaves_no_trace)
{
  int inserted = 0, given_up = 0;
  for(int period : {1, 2, 3, 5, 8, 13, 1000})
    for(int kind = 0; kind < 2; ++kind)
      for(int i = 0; i < 10; ++i) {
        Lies lies;
        Liar liar(period, i);
        bool is_lying = false;
        if(kind == 0)
          lies.is_quad_reflex = [&](bool is_reflex) { return is_reflex || liar(false); };
        else
          lies.length = [&](double length) { return is_lying && liar(false) ? 3 * length : length; };
        Setting setting(jittered_grid(7, 7, Diagonal_rule::RANDOM, 0.2, 1), Hostile_traits(lies));
        FG::Shortest_edge_path<Triangulation> search(setting.triangulation);
        const std::vector<Halfedge_index> path = search(Vertex_index(i), Vertex_index(63 - i));
        double length = 0;
        for(Halfedge_index h : path)
          length += setting.triangulation.length(h);
        is_lying = true;
        FG::add_straightened_path(setting.network, path);
        is_lying = false;
        BOOST_TEST(setting.network.is_valid());
        BOOST_TEST(setting.network.length(0_c) <= length * (1 + 1e-12));
        BOOST_TEST(std::abs(setting.network.initial_length(0_c) - length) <= (kind == 0 ? 1e-12 : 3) * length);
        std::set<Vertex_index> passed;
        setting.network.for_each_segment(0_c, [&](Segment_index s) {
          BOOST_TEST(passed.insert(setting.triangulation.tail(setting.network.halfedge(s))).second);
        });
        if(setting.network.halfedges(0_c) == path) {
          BOOST_TEST(setting.triangulation.log_position() == 0u);
          ++given_up;
        } else
          ++inserted;
      }
  BOOST_TEST(inserted > 10);
  BOOST_TEST(given_up > 10);
}

namespace {

// One lie for each bad face.
struct Liars_start : FG::Default_shortening_visitor
{
  bool go_further()
  {
    *lies_left = 1;
    return true;
  }

  int* lies_left = nullptr;
};

} // namespace

// Flips of edges that must not be flipped, while points are inserted: the words tell, and the insertion is undone.
BOOST_AUTO_TEST_CASE(insertions_with_wrong_flips_are_taken_back)
{
  for(bool is_open : {false, true}) {
    std::size_t refused = 0;
    for(bool has_curve : {false, true})
      for(int k = 0; k < 24; k += stride) {
        Lies lies;
        const int periods[] = {2, 3, 5, 8, 13, 30};
        Liar liar(periods[k / 4], k % 4);
        int lies_left = 0;
        const Triangulation* lied_to = nullptr;
        lies.is_locally_delaunay = [&](bool truth) {
          const bool is_time =
              lied_to != nullptr && lied_to->is_inserted(Vertex_index(lied_to->number_of_vertices() - 1));
          return truth && !(is_time && lies_left > 0 && liar(false) && lies_left-- > 0);
        };
        Setting setting(is_open ? jittered_grid(5, 5, Diagonal_rule::RANDOM, 0.2, 1) : bumpy_sphere(4, 0.3, 2),
                        Hostile_traits(lies));
        if(has_curve)
          setting.add_path(0_v, is_open ? 17_v : 37_v);
        setting.pull();
        FG::flip_to_delaunay(setting.triangulation);
        lied_to = &setting.triangulation;
        const double length = has_curve ? setting.network.length(0_c) : 0;
        FG::Refinement_options options;
        options.smallest_angle = 28;
        options.longest_edge = 0.25;
        options.maximum_insertions = 300;
        Liars_start start;
        start.lies_left = &lies_left;
        const FG::Refinement_report report = FG::refine(setting.network, options, start);
        refused += report.refused;
        BOOST_TEST(report.insertions + report.splits <= 300u);
        BOOST_TEST(report.insertions + report.splits + setting.mesh.number_of_vertices() ==
                   std::size_t(setting.triangulation.number_of_vertices()));
        if(has_curve)
          BOOST_TEST(std::abs(setting.network.length(0_c) - length) < 1e-9 * length);
        BOOST_TEST(setting.network.is_valid());
        for(Edge_index e : descriptors<Edge_index>(setting.triangulation.number_of_edges()))
          BOOST_CHECK_NO_THROW(setting.triangulation.crossing_word(first_side(e)));
      }
    BOOST_TEST(refused > 10u);
  }
}

namespace {

// Truth until so many questions were asked.
struct Late_start : FG::Default_shortening_visitor
{
  bool go_further()
  {
    *is_lying = --questions_left < 0;
    return true;
  }

  bool* is_lying = nullptr;
  Index questions_left = 0;
};

} // namespace

// Lies one after another: flips that do not lead to the vertex end, and are taken back.
BOOST_AUTO_TEST_CASE(refinement_among_wrong_flips_ends)
{
  std::size_t refused = 0;
  for(const Mesh_soup& soup : {jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 1),
                               flat_grid(5, 5, Diagonal_rule::RISING), bumpy_sphere(4, 0.3, 2)})
    for(int period : {1, 2, 3, 5, 7, 13, 30})
      for(bool has_curve : {false, true}) {
        Lies lies;
        Liar liar(period);
        bool is_lying = false;
        lies.is_locally_delaunay = [&](bool truth) { return is_lying ? liar(truth) : truth; };
        Setting setting(soup, Hostile_traits(lies));
        if(has_curve)
          setting.add_path(0_v, 35_v); // along the diagonals of the second, with circumcentres on it
        setting.pull();
        FG::flip_to_delaunay(setting.triangulation);
        const Index vertices = setting.triangulation.number_of_vertices();
        Late_start start;
        start.is_lying = &is_lying;
        start.questions_left = setting.triangulation.number_of_edges(); // those of the edges, before the faces
        FG::Refinement_options options;
        options.longest_edge = 0.5;
        options.maximum_insertions = 200;
        const FG::Refinement_report report = FG::refine(setting.network, options, start);
        is_lying = false;
        refused += report.refused;
        BOOST_TEST(report.insertions + report.splits ==
                   std::size_t(setting.triangulation.number_of_vertices() - vertices));
        BOOST_TEST(setting.network.is_valid());
        for(Edge_index e : descriptors<Edge_index>(setting.triangulation.number_of_edges()))
          BOOST_CHECK_NO_THROW(setting.triangulation.crossing_word(first_side(e)));
      }
  BOOST_TEST(refused > 10u);
}

// A visitor that throws: the points that were inserted are gone.
BOOST_AUTO_TEST_CASE(an_exception_between_points_leaves_the_triangulation_as_it_was)
{
  struct Thrower : FG::Default_shortening_visitor
  {
    bool go_further() { throw std::runtime_error("enough"); }
  };
  const Setting setting(jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 2));
  Triangulation triangulation(setting.mesh);
  const auto h = triangulation.input().index(halfedge(Surface::Face_index(3), setting.mesh));
  const auto g = triangulation.input().index(halfedge(Surface::Face_index(60), setting.mesh));
  const std::vector<FG::Surface_location> ends = {{h, {{0.25, 0.25, 0.5}}}, {g, {{0.5, 0.25, 0.25}}}};
  BOOST_CHECK_THROW(FG::geodesics_through(triangulation, ends, FG::Never_stop_predicate(), Thrower()),
                    std::runtime_error);
  BOOST_TEST(triangulation.log_position() == 0u);
  BOOST_TEST(triangulation.number_of_vertices() == Index(setting.mesh.number_of_vertices()));
  FG::geodesics_through(triangulation, ends);
  BOOST_TEST(triangulation.log_position() == 0u);
  BOOST_TEST(triangulation.number_of_vertices() == Index(setting.mesh.number_of_vertices()));
}

// Wedges that are called narrow are flipped out for longer arcs, and back: the tree comes to an end, and tells of bent
// paths.
BOOST_AUTO_TEST_CASE(trees_among_lies_end)
{
  int told = 0;
  for(int period : {3, 5, 8})
    for(bool is_straight : {false, true}) {
      Lies lies;
      Liar liar(period);
      lies.is_wedge_straight = [&](int corners, bool truth) {
        return is_straight ? truth || liar(false) : truth && !(corners > 1 && liar(false));
      };
      Setting setting(torus(13, 7, 3, 1), Hostile_traits(lies));
      FG::Geodesic_tree<Triangulation> tree(setting.triangulation);
      const FG::Geodesic_tree_report report = tree.grow(0_v);
      BOOST_TEST(setting.triangulation.is_valid(1e-6));
      for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices())) {
        double length = 0;
        for(Halfedge_index h : tree.path(v))
          length += setting.triangulation.length(h);
        BOOST_TEST(tree.is_reached(v));
        BOOST_TEST(std::abs(tree.distance(v) - length) <= 1e-9);
      }
      const bool is_bent = report.smallest_angle < FG::Straightness::straight_angle();
      told += report.status == FG::Shortening_status::PRECISION_LIMIT ? 1 : 0;
      BOOST_TEST((is_bent ? report.status == FG::Shortening_status::PRECISION_LIMIT : true));
    }
  BOOST_TEST(told > 0);
}

// Vectors of about 100 bits that are derived from flip to flip, as those of the words, which are unfolded.
BOOST_AUTO_TEST_CASE(vectors_derived_over_wrong_flips_are_those_of_the_words)
{
  int compared = 0;
  for(unsigned seed = 1; seed <= 30; ++seed) {
    Random_numbers random(seed);
    Setting setting(shaken(seed % 2 == 0 ? octahedron(2) : flat_grid(4, 4, Diagonal_rule::RANDOM), 0.1, seed));
    const Triangulation& t = setting.triangulation;
    for(int i = 0; i < 60; ++i) {
      const Halfedge_index h(random.below(t.number_of_halfedges())), twin = t.twin(h);
      if(t.is_border(h) || t.is_border(twin) || t.next(h) == twin || t.next(twin) == h || t.crossings(t.edge(h)) > 100)
        continue;
      setting.triangulation.flip(h); // of any quad
    }
    for(Halfedge_index h : descriptors<Halfedge_index>(t.number_of_halfedges())) {
      const FG::internal::Precise_edge derived = t.precise_edge(h); // before its word is asked for, and then unfolded
      const FG::Crossing_word word = t.crossing_word(h);
      if(word.crossed.empty())
        continue;
      const FG::internal::Precise_edge unfolded = FG::internal::Precise_strip<Triangulation>(t, word, false).edge();
      if(!derived.has_bound() || !unfolded.has_bound())
        continue;
      ++compared;
      BOOST_TEST(derived.tail_reference == unfolded.tail_reference);
      BOOST_TEST(derived.head_reference == unfolded.head_reference);
      const double error = FG::internal::length(derived.end + -unfolded.end);
      BOOST_TEST(error <= (derived.end_error + unfolded.end_error) * unfolded.length);
    }
  }
  BOOST_TEST(compared > 1000);
}

namespace {

// The edge i->j of a quadrilateral that is bent inwards at k, by so much: it passes outside of the mesh.
struct Bent_inwards
{
  explicit Bent_inwards(double height)
    : mesh(to_mesh<Surface>(Mesh_soup{{{0, 0, 0}, {1, height, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 3}, {1, 2, 3}}}))
    , triangulation(mesh, Hostile_traits(lies()))
  {
    const Halfedge_index h = FG::internal::halfedge_between(triangulation, 1_v, 3_v);
    BOOST_REQUIRE(triangulation.is_flippable(h));
    triangulation.flip(h);
  }

  static const Lies& lies()
  {
    static const Lies convex = {[](bool) { return false; }, {}, {}, {}};
    return convex;
  }

  Surface mesh;
  Triangulation triangulation;
};

} // namespace

// Flips that were wrong by as little as rounding explains do not stand in the way of points on edges; others do.
BOOST_AUTO_TEST_CASE(points_on_edges_that_were_flipped_wrongly)
{
  for(double height : {1e-9, 1e-7, 1e-3, 0.1}) {
    Bent_inwards bent(height);
    const Halfedge_index along = FG::internal::halfedge_between(bent.triangulation, 0_v, 1_v);
    const Halfedge_index flipped = FG::internal::halfedge_between(bent.triangulation, 0_v, 2_v);
    // On the wrong side of the corner.
    const FG::Surface_location point = {FG::internal::as_input(along), {{1, 1, 1e-9}}};
    const auto split = [&] { return bent.triangulation.split_edge(flipped, point, 0, [](const auto&) {}); };
    const auto before = bent.triangulation.log_position();
    if(height < 1e-6) {
      BOOST_TEST(split() == 4_v);
      continue;
    }
    BOOST_CHECK_THROW(split(), FG::Insertion_error);
    BOOST_TEST(bent.triangulation.log_position() == before);
    BOOST_TEST(bent.triangulation.number_of_vertices() == 4);
  }
}

// Points among many wrong flips are inserted, or refused with nothing changed.
BOOST_AUTO_TEST_CASE(points_among_wrong_flips)
{
  int inserted = 0, refused = 0;
  for(int period : {1, 2, 4, 8})
    for(unsigned seed = 1; seed <= 20; ++seed) {
      Lies lies;
      Liar liar(period);
      lies.is_quad_reflex = [&](bool is_reflex) { return is_reflex && !liar(false); };
      Random_numbers random(seed);
      const Surface mesh = to_mesh<Surface>(jittered_grid(4, 4, Diagonal_rule::RANDOM, 0.24, seed));
      Triangulation triangulation(mesh, Hostile_traits(lies));
      for(int i = 0; i < 60; ++i) {
        const Halfedge_index h(random.below(triangulation.number_of_halfedges()));
        if(triangulation.is_flippable(h))
          triangulation.flip(h);
      }
      for(int i = 0; i < 30; ++i) {
        const FG::Input_halfedge_index h(random.below(triangulation.input().number_of_halfedges()));
        if(triangulation.input().is_border(h))
          continue;
        const auto before = triangulation.log_position();
        const Index vertices = triangulation.number_of_vertices();
        try {
          triangulation.insert({h, {{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)}}});
          ++inserted;
        } catch(const FG::Insertion_error&) {
          ++refused;
          BOOST_TEST(triangulation.log_position() == before);
          BOOST_TEST(triangulation.number_of_vertices() == vertices);
        }
      }
    }
  BOOST_TEST(inserted > 100);
  BOOST_TEST(refused > 30);
}
