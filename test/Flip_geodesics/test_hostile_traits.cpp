// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE hostile_traits

#include "test_hostile_traits/checked_shortening.h"

#include <CGAL/Flip_geodesics/geodesic_distances.h>

using namespace Flip_geodesics_test;

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
          setting.network.add_curve(loop, CGAL::parameters::is_closed(true));
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
    setting.network.add_curve(loop, CGAL::parameters::is_closed(true));
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
      FG::shorten(setting.network, CGAL::parameters::visitor(std::ref(thrower)));
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
  const FG::Shortening_report report = FG::shorten(setting.network, CGAL::parameters::visitor(std::ref(watcher)));
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

      // Of paths that stay as they are, the same is told.
      BOOST_TEST(
          (FG::make_shortest(tree, CGAL::parameters::search_limit(FG::Window_limit(1))).status == report.status));
    }
  BOOST_TEST(told > 0);
}
