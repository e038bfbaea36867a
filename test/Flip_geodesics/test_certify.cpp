// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE certify

#include "test_certify/second_opinion.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE_TEMPLATE(paths_that_were_pulled_tight_are_proven, Setting, Settings)
{
  for(const Mesh_soup& soup : soups()) {
    Setting setting(soup);
    Random_numbers random(1);
    for(int i = 0; i < 20; ++i) {
      add_random_path(setting, random);
      setting.pull();
      BOOST_TEST((checked_certificate(setting).curves[0].verdict() == FG::Verdict::PROVEN));
      take_back(setting);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(loops_and_networks_that_were_pulled_tight_are_proven, Setting, Settings)
{
  int networks = 0, loops = 0;
  for(const Mesh_soup& soup : soups()) {
    Setting setting(soup);
    Random_numbers random(2);
    for(int i = 0; i < 10; ++i) {
      for(int k = 0; k < 3; ++k)
        add_random_path(setting, random);
      try {
        FG::order_overlapping_curves(setting.network);
        setting.pull();
        BOOST_TEST(checked_certificate(setting).is_locally_shortest());
        ++networks;
      } catch(const FG::Crossing_curves_error&) {
      }
      take_back(setting);

      const Halfedge_sequence loop = random_walk(setting.triangulation, 15, true, random);
      if(!loop.empty())
        setting.network.add_curve(loop, CGAL::parameters::is_closed(true));
      if(!loop.empty() && order_at_random(setting.network, loop, 5, random)) {
        setting.pull();
        BOOST_TEST(checked_certificate(setting).is_locally_shortest());
        ++loops;
      }
      take_back(setting);
    }
  }
  BOOST_TEST(networks > 30);
  BOOST_TEST(loops > 20);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(near_ties_are_told_from_ties, Setting, Settings)
{
  constexpr bool is_exact = !Setting::Triangulation::Traits::Has_drift::value;
  int bent = 0;
  for(const Mesh_soup& soup : soups_near_ties()) {
    Setting setting(soup);
    Random_numbers random(5);
    for(int i = 0; i < 40; ++i) {
      add_random_path(setting, random);
      setting.pull();
      bent += checked_certificate(setting).is_locally_shortest() ? 0 : 1;
      take_back(setting);
    }
  }
  BOOST_TEST(is_exact == (bent == 0));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(paths_as_they_were_found_are_judged_as_the_referee_judges, Setting, Settings)
{
  int bent = 0, straight = 0;
  for(const Mesh_soup& soup : soups()) {
    Setting setting(soup);
    Random_numbers random(3);
    for(int i = 0; i < 20; ++i) {
      add_random_path(setting, random);
      (checked_certificate(setting).is_locally_shortest() ? straight : bent) += 1;
      take_back(setting);
    }
  }
  BOOST_TEST(bent > 50);
  BOOST_TEST(straight > 10);
}

// However little is missing, a curve is proven after the last step and not before it.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_curve_one_step_from_the_end_is_bent, Setting, Settings)
{
  int stopped = 0;
  for(const Mesh_soup& soup : soups()) {
    Setting setting(soup);
    Random_numbers random(4);
    const int n = setting.triangulation.number_of_vertices();
    for(int i = 0; i < 10; ++i) {
      const FG::Vertex_index u(random.below(n)), v((u.idx() + 1 + random.below(n - 1)) % n);
      setting.add_path(u, v);
      const std::size_t steps = setting.pull().flip_outs;
      take_back(setting);
      if(steps == 0)
        continue;
      setting.add_path(u, v);
      setting.pull(FG::Iteration_stop_predicate(steps - 1));
      const FG::Network_certificate certificate = checked_certificate(setting);
      BOOST_TEST((certificate.curves[0].verdict() == FG::Verdict::BENT_JOINT));
      ++stopped;
      take_back(setting);
    }
  }
  BOOST_TEST(stopped > 50);
}

BOOST_AUTO_TEST_CASE(the_bent_joint_is_named)
{
  const int n = 4;
  Certified_setting setting(flat_grid(n, n, Diagonal_rule::RISING));
  setting.add(vertex_path_on_grid(n, {{0, 1}, {2, 1}, {2, 3}}), false);
  const FG::Network_certificate left = FG::certify(setting.network);
  BOOST_TEST((left.curves[0].verdict() == FG::Verdict::BENT_JOINT));
  BOOST_TEST((left.curves[0].side == FG::Side::LEFT));
  const auto head_of = [&](FG::Segment_index s) { return setting.triangulation.head(setting.network.halfedge(s)); };
  BOOST_TEST(head_of(left.curves[0].segment) == FG::Vertex_index(grid_vertex(n, 2, 1)));
  take_back(setting);

  setting.add(vertex_path_on_grid(n, {{0, 3}, {2, 3}, {2, 1}}), false);
  const FG::Network_certificate right = FG::certify(setting.network);
  BOOST_TEST((right.curves[0].side == FG::Side::RIGHT));
  BOOST_TEST(head_of(right.curves[0].segment) == FG::Vertex_index(grid_vertex(n, 2, 3)));
}

BOOST_AUTO_TEST_CASE(each_curve_has_a_verdict_of_its_own)
{
  const int n = 6;
  Certified_setting setting(flat_grid(n, n, Diagonal_rule::RISING));
  setting.add(vertex_path_on_grid(n, {{0, 1}, {6, 1}}), false);
  setting.add(vertex_path_on_grid(n, {{0, 2}, {3, 2}, {3, 5}}), false);
  setting.add(vertex_path_on_grid(n, {{5, 2}, {5, 5}}), false);
  const FG::Network_certificate certificate = FG::certify(setting.network);
  BOOST_TEST((certificate.curves[0].verdict() == FG::Verdict::PROVEN));
  BOOST_TEST((certificate.curves[1].verdict() == FG::Verdict::BENT_JOINT));
  BOOST_TEST((certificate.curves[2].verdict() == FG::Verdict::PROVEN));
  BOOST_TEST((certificate.verdict() == FG::Verdict::BENT_JOINT));
  BOOST_TEST(!certificate.is_locally_shortest());
}

// A curve is held back by another that ends inside its wedge: nothing is wrong with it.
BOOST_AUTO_TEST_CASE_TEMPLATE(what_blocks_a_joint_is_not_held_against_the_curve, Setting, Settings)
{
  const int n = 6;
  Setting setting(flat_grid(n, n, Diagonal_rule::FALLING));
  setting.add(vertex_path_on_grid(n, {{1, 3}, {3, 3}, {3, 5}}), false);
  BOOST_TEST(!FG::certify(setting.network).is_locally_shortest());
  setting.add({FG::Vertex_index(grid_vertex(n, 2, 4)), FG::Vertex_index(grid_vertex(n, 3, 3))}, false);
  const FG::Network_certificate certificate = checked_certificate(setting);
  BOOST_TEST((certificate.curves[0].verdict() == FG::Verdict::PROVEN));
  BOOST_TEST((certificate.curves[1].verdict() == FG::Verdict::PROVEN));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(fixed_nodes_may_be_bent, Setting, Settings)
{
  const int n = 6;
  Setting setting(flat_grid(n, n, Diagonal_rule::RISING));
  setting.add(vertex_path_on_grid(n, {{1, 3}, {3, 3}, {3, 5}}), false);
  BOOST_TEST(!FG::certify(setting.network).is_locally_shortest());
  setting.network.fix_nodes_at(FG::Vertex_index(grid_vertex(n, 3, 3)));
  BOOST_TEST(checked_certificate(setting).is_locally_shortest());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_curve_that_turns_back_is_bent, Setting, Settings)
{
  Setting setting(cube(3));
  setting.add({0_v, 1_v, 0_v, 1_v}, false);
  const FG::Network_certificate certificate = checked_certificate(setting);
  BOOST_TEST((certificate.curves[0].verdict() == FG::Verdict::BENT_JOINT));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_contracted_curve_is_proven, Setting, Settings)
{
  Setting setting(thirteen_vertex_cone_disk());
  setting.add(disk_ring(6, 1), true);
  BOOST_TEST(!FG::certify(setting.network).is_locally_shortest());
  setting.pull();
  BOOST_TEST(setting.network.is_contracted(0_c));
  BOOST_TEST((FG::certify(setting.network).curves[0].verdict() == FG::Verdict::PROVEN));
}

// The angles of these loops are pi, exactly: what one unit in the last place less would not allow.
BOOST_AUTO_TEST_CASE_TEMPLATE(angles_of_exactly_pi_are_proven, Setting, Settings)
{
  Setting hexagon(octahedron(6));
  hexagon.add(vertices_on_polyline(octahedron(6),
                                   {{3, -3, 0}, {3, 0, -3}, {0, 3, -3}, {-3, 3, 0}, {-3, 0, 3}, {0, -3, 3}}, true),
              true);
  BOOST_TEST((checked_certificate(hexagon).curves[0].verdict() == FG::Verdict::PROVEN));

  Setting setting(tetrahedron(6));
  setting.add(tetrahedron_loop(6), true);
  const FG::Network_certificate certificate = checked_certificate(setting);
  BOOST_TEST((certificate.curves[0].verdict() == FG::Verdict::PROVEN));
  BOOST_TEST(certificate.statistics.zeros_by_plane + certificate.statistics.zeros_by_roots > 0u);

  Setting plate(genus_3_plate(2));
  for(const Vertex_sequence& loop : genus_3_loops(2)) {
    plate.add(loop, true);
    BOOST_TEST((checked_certificate(plate).curves[0].verdict() == FG::Verdict::PROVEN));
    take_back(plate);
  }
}

// Lowering one vertex of a straight line by the smallest amount there is makes it bent on one side.
BOOST_AUTO_TEST_CASE_TEMPLATE(one_unit_in_the_last_place_is_seen, Setting, Settings)
{
  const int n = 6;
  Mesh_soup soup = flat_grid(n, n, Diagonal_rule::RISING);
  soup.points[grid_vertex(n, 3, 3)][1] = 3 - 0x1p-51;
  Setting setting(soup);
  setting.add(vertex_path_on_grid(n, {{2, 3}, {4, 3}}), false);
  const FG::Network_certificate certificate = checked_certificate(setting);
  BOOST_TEST((certificate.curves[0].verdict() == FG::Verdict::BENT_JOINT));
  BOOST_TEST((certificate.curves[0].side == FG::Side::LEFT));
}

// ---------------------------------------------------------------- what is certified when the shortening was long

// What a limit or a visitor has held back is taken up by the next run, on the same curve as well.
BOOST_AUTO_TEST_CASE(wedges_that_were_held_back_are_taken_up_again)
{
  struct Stopped_once : FG::Default_shortening_visitor
  {
    bool go_further() { return std::exchange(has_stopped, true); }
    bool has_stopped = false;
  };
  const int n = 12;
  for(bool has_limit : {true, false}) {
    Certified_setting setting(flat_grid(n, n, Diagonal_rule::RISING));
    // Two bumps: what is done about one says nothing of the other.
    setting.add(
        vertex_path_on_grid(n, {{1, 3}, {2, 3}, {2, 4}, {3, 4}, {3, 3}, {9, 3}, {9, 4}, {10, 4}, {10, 3}, {11, 3}}),
        false);
    FG::Shortener<Certified_setting::Network> shortener(setting.network);
    if(has_limit)
      BOOST_TEST(!shortener.run(FG::Curve_length_ratio_stop_predicate(1)));
    else
      for(int i = 0; i < 20; ++i)
        BOOST_TEST(!shortener.run(FG::Never_stop_predicate(), Stopped_once()));
    BOOST_TEST(!checked_certificate(setting).is_locally_shortest());
    BOOST_TEST(shortener.run());
    BOOST_TEST((checked_certificate(setting).curves[0].verdict() == FG::Verdict::PROVEN));
  }
}

// As long as a curve becomes shorter, it is not given up.
BOOST_AUTO_TEST_CASE(a_curve_of_more_than_ten_thousand_steps_is_straight)
{
  const int n = 170;
  Curve_setting setting(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.1, 1));
  setting.add(vertex_path_on_grid(n, {{1, 1}, {n - 1, 1}, {n - 1, n - 1}}), false);
  const FG::Shortening_report report = setting.pull();
  BOOST_TEST(report.flip_outs > 10000u);
  BOOST_TEST((report.curves[0].status == FG::Shortening_status::LOCALLY_SHORTEST));
  const auto p = setting.mesh.point(Surface::Vertex_index(grid_vertex(n, 1, 1))),
             q = setting.mesh.point(Surface::Vertex_index(grid_vertex(n, n - 1, n - 1)));
  BOOST_TEST(std::abs(report.curves[0].length - std::sqrt(CGAL::squared_distance(p, q))) < 1e-9);
}
