// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The order of curves that overlap: cases by hand.

#define BOOST_TEST_MODULE overlapping_curves

#include "descriptors.h"
#include "overlapping_world.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

bool is_at(const Crossing_curves_error& error, const Vertex_sequence& vertices)
{
  return error.elements().size() == 1 &&
         std::count(vertices.begin(), vertices.end(), Vertex_index(static_cast<Index>(error.elements()[0]))) == 1;
}

void check_crossing(Overlapping_world& world, const Vertex_sequence& vertices)
{
  BOOST_CHECK_EXCEPTION(order_overlapping_curves(world.network), Crossing_curves_error,
                        [&](const Crossing_curves_error& error) { return is_at(error, vertices); });
}

template <class Element>
void check_equal(const std::vector<Element>& a, std::initializer_list<Element> b)
{
  BOOST_TEST(a == std::vector<Element>(b), boost::test_tools::per_element());
}

constexpr int width = 6;

/// The vertex (i, j) of a grid of 6 x 4 cells, whose neighbors are E, NE, N, W, SW and S.
Vertex_index at(int i, int j) { return Vertex_index(grid_vertex(width, i, j)); }

Mesh_soup plane() { return flat_grid(width, 4, Diagonal_rule::RISING); }

/// A path that comes to (2, 2) from `(2 + a, 2 + b)`, runs to (4, 2), and leaves it to `(4 + c, 2 + d)`.
Vertex_sequence run(int a, int b, int c, int d)
{
  return {at(2 + a, 2 + b), at(2, 2), at(3, 2), at(4, 2), at(4 + c, 2 + d)};
}

} // namespace

// ---------------------------------------------------------------- nothing to order

BOOST_AUTO_TEST_CASE(no_curve)
{
  Overlapping_world world(plane());
  world.order();
}

BOOST_AUTO_TEST_CASE(curves_apart)
{
  Overlapping_world world(plane());
  world.add({at(0, 1), at(1, 1), at(2, 1)});
  world.add({at(2, 3), at(1, 3), at(1, 2)});
  world.order();
}

BOOST_AUTO_TEST_CASE(curves_that_touch_at_a_vertex)
{
  Overlapping_world world(plane());
  world.add({at(1, 2), at(2, 2), at(2, 3)}); // W to N
  world.add({at(2, 1), at(2, 2), at(3, 2)}); // S to E
  world.order();
}

BOOST_AUTO_TEST_CASE(curves_that_cross_at_a_vertex)
{
  Overlapping_world world(plane());
  world.add({at(1, 2), at(2, 2), at(3, 2)});
  world.add({at(2, 1), at(2, 2), at(2, 3)});
  check_crossing(world, {at(2, 2)});
}

BOOST_AUTO_TEST_CASE(curves_may_cross_at_a_fixed_node)
{
  Overlapping_world world(plane());
  world.add({at(1, 2), at(2, 2), at(3, 2)});
  world.add({at(2, 1), at(2, 2), at(2, 3)});
  world.network.fix_nodes_at(at(2, 2));
  world.order();
}

BOOST_AUTO_TEST_CASE(a_curve_that_crosses_itself_at_a_vertex)
{
  Overlapping_world world(plane());
  world.add({at(1, 2), at(2, 2), at(3, 2), at(3, 3), at(2, 3), at(2, 2), at(2, 1)});
  check_crossing(world, {at(2, 2)});
}

// ---------------------------------------------------------------- runs

BOOST_AUTO_TEST_CASE(run_parting_on_the_same_side)
{
  Overlapping_world world(plane());
  world.add(run(0, -1, 0, -1)); // from S, to S
  world.add(run(0, 1, 0, 1));   // from N, to N
  world.order();
  check_equal(world.curves(at(2, 2), at(3, 2)), {1_c, 0_c});
  check_equal(world.curves(at(3, 2), at(4, 2)), {1_c, 0_c});
}

BOOST_AUTO_TEST_CASE(run_parting_on_the_same_side_in_opposite_directions)
{
  Overlapping_world world(plane());
  world.add(run(0, 1, 0, 1));
  world.add(reversed(run(0, -1, 0, -1)));
  world.order();
  check_equal(world.curves(at(2, 2), at(3, 2)), {0_c, 1_c});
  check_equal(world.curves(at(4, 2), at(3, 2)), {1_c, 0_c});
}

BOOST_AUTO_TEST_CASE(run_parting_on_opposite_sides)
{
  for(bool is_reversed : {false, true}) {
    Overlapping_world world(plane());
    world.add(run(0, 1, 0, -1));
    world.add(is_reversed ? reversed(run(0, -1, 0, 1)) : run(0, -1, 0, 1));
    check_crossing(world, {at(2, 2), at(3, 2), at(4, 2)});
  }
}

BOOST_AUTO_TEST_CASE(run_with_a_fixed_node_may_part_on_opposite_sides)
{
  Overlapping_world world(plane());
  world.add(run(0, 1, 0, -1));
  world.add(run(0, -1, 0, 1));
  world.network.fix_nodes_at(at(3, 2));
  world.order();
  check_equal(world.curves(at(2, 2), at(3, 2)), {0_c, 1_c});
  check_equal(world.curves(at(3, 2), at(4, 2)), {1_c, 0_c});
}

BOOST_AUTO_TEST_CASE(many_curves_in_one_run)
{
  Overlapping_world world(plane());
  world.add(run(0, -1, 0, -1));          // S S
  world.add(run(-1, 0, 1, 1));           // W NE
  world.add(run(-1, -1, 1, 0));          // SW E
  world.add(run(0, 1, 0, 1));            // N N
  world.add(reversed(run(-1, 0, 0, 1))); // W N
  world.order();
  check_equal(world.curves(at(2, 2), at(3, 2)), {3_c, 4_c, 1_c, 2_c, 0_c});
  check_equal(world.curves(at(3, 2), at(4, 2)), {3_c, 4_c, 1_c, 2_c, 0_c});
}

// ---------------------------------------------------------------- ends

BOOST_AUTO_TEST_CASE(common_end_vertices)
{
  Overlapping_world world(plane());
  world.add({at(1, 2), at(2, 2), at(3, 2)});
  world.add({at(2, 3), at(2, 2), at(3, 2)});
  world.add({at(3, 2), at(2, 2), at(2, 1)});
  world.order();
  check_equal(world.curves(at(2, 2), at(3, 2)), {1_c, 0_c, 2_c});
}

BOOST_AUTO_TEST_CASE(end_inside_a_run)
{
  Overlapping_world world(plane());
  world.add({at(1, 2), at(2, 2), at(3, 2), at(4, 2), at(5, 2)});
  world.add({at(2, 1), at(2, 2), at(3, 2), at(4, 2)});
  world.add({at(4, 2), at(3, 2), at(2, 2), at(2, 3)});
  check_crossing(world, {at(4, 2), at(3, 2), at(2, 2)}); // they end on different sides of the first

  Overlapping_world other(plane());
  other.add({at(1, 2), at(2, 2), at(3, 2), at(4, 2), at(5, 2)});
  other.add({at(2, 1), at(2, 2), at(3, 2), at(4, 2)});
  other.add({at(3, 2), at(2, 2), at(2, 3)});
  other.order();
  check_equal(other.curves(at(2, 2), at(3, 2)), {2_c, 0_c, 1_c});
  check_equal(other.curves(at(3, 2), at(4, 2)), {0_c, 1_c});
}

BOOST_AUTO_TEST_CASE(both_ends_inside_a_run)
{
  Overlapping_world world(plane());
  world.add({at(1, 2), at(2, 2), at(3, 2), at(4, 2), at(5, 2)});
  world.add({at(4, 2), at(3, 2), at(2, 2)});
  world.order();
  check_equal(world.curves(at(2, 2), at(3, 2)), {0_c, 1_c}); // the older is on the left
  check_equal(world.curves(at(3, 2), at(4, 2)), {0_c, 1_c});

  Overlapping_world held(plane()); // a third end on the left of the first
  held.add({at(1, 2), at(2, 2), at(3, 2), at(4, 2), at(5, 2)});
  held.add({at(4, 2), at(3, 2), at(2, 2)});
  held.add({at(4, 3), at(4, 2)});
  held.order();
  check_equal(held.curves(at(2, 2), at(3, 2)), {1_c, 0_c});
}

BOOST_AUTO_TEST_CASE(ends_on_both_sides_of_a_curve)
{
  Overlapping_world world(plane());
  world.add({at(3, 2), at(4, 2), at(5, 2)});
  world.add({at(4, 3), at(4, 2)});
  world.add({at(4, 1), at(4, 2)});
  check_crossing(world, {at(4, 2)});

  Overlapping_world fixed(plane());
  fixed.add({at(3, 2), at(4, 2), at(5, 2)});
  fixed.add({at(4, 3), at(4, 2)});
  fixed.add({at(4, 1), at(4, 2)});
  fixed.network.fix_nodes_at(at(4, 2));
  fixed.order();
}

// ---------------------------------------------------------------- copies

BOOST_AUTO_TEST_CASE(copies_lie_to_the_right)
{
  Overlapping_world world(plane());
  world.add(run(0, 1, 0, -1));
  world.add(reversed(run(0, 1, 0, -1)));
  world.add(run(0, 1, 0, -1));
  world.add(run(0, 1, 0, -1));
  world.order();
  for(auto [i, j] : {std::make_pair(2, 3), std::make_pair(3, 4)})
    check_equal(world.curves(at(i, 2), at(j, 2)), {0_c, 2_c, 3_c, 1_c});
}

BOOST_AUTO_TEST_CASE(copies_of_a_loop)
{
  Overlapping_world world(cylinder(6, 2, 1, 1));
  const Vertex_sequence ring = ring_path(6, 1, 1);
  world.add(ring, true);
  Vertex_sequence other = reversed(ring);
  std::rotate(other.begin(), other.begin() + 2, other.end());
  world.add(other, true);
  std::rotate(other.begin(), other.begin() + 1, other.end());
  world.add(reversed(other), true);
  world.order();
  for(int i = 0; i < 6; ++i)
    check_equal(world.curves(ring[i], ring[(i + 1) % 6]), {0_c, 2_c, 1_c});
}

BOOST_AUTO_TEST_CASE(copies_in_great_number)
{
  Overlapping_world world(plane());
  for(int i = 0; i < 300; ++i)
    world.add(i % 2 == 0 ? run(0, 1, 1, 0) : reversed(run(0, 1, 1, 0)));
  world.add(run(-1, 0, 1, 0));
  world.order();
  BOOST_TEST(world.curves(at(2, 2), at(3, 2)).back() == 300_c);
}

// ---------------------------------------------------------------- the border

BOOST_AUTO_TEST_CASE(run_along_the_border)
{
  Overlapping_world world(plane());
  world.add({at(1, 0), at(2, 0), at(3, 0), at(4, 0)});
  world.add({at(3, 1), at(3, 0), at(2, 0), at(2, 1)});
  world.add({at(2, 1), at(2, 0), at(3, 0), at(4, 0)});
  world.order();
  check_equal(world.curves(at(2, 0), at(3, 0)), {1_c, 2_c, 0_c});
  check_equal(world.curves(at(3, 0), at(4, 0)), {2_c, 0_c});
}

BOOST_AUTO_TEST_CASE(a_segment_between_an_end_and_the_border)
{
  Overlapping_world world(plane());
  world.add({at(1, 0), at(2, 0), at(3, 0)});
  world.add({at(2, 1), at(2, 0)});
  check_crossing(world, {at(2, 0)});

  Overlapping_world along(plane()); // which lies on the side of the border, since it ends
  along.add({at(1, 0), at(2, 0), at(3, 0), at(4, 0)});
  along.add({at(1, 0), at(2, 0), at(3, 0)});
  along.order();
  check_equal(along.curves(at(1, 0), at(2, 0)), {0_c, 1_c});
  along.network.clear();
  along.add({at(1, 0), at(2, 0), at(3, 0)});
  along.add({at(4, 0), at(3, 0), at(2, 0), at(1, 0)});
  along.order();
  check_equal(along.curves(at(1, 0), at(2, 0)), {1_c, 0_c});
}

// ---------------------------------------------------------------- to and fro

BOOST_AUTO_TEST_CASE(to_and_fro)
{
  Overlapping_world world(plane());
  world.add({at(2, 2), at(3, 2), at(2, 2)});
  world.order();
  check_equal(world.bundle(at(2, 2), at(3, 2)), {1_s, 2_s});
}

BOOST_AUTO_TEST_CASE(to_and_fro_and_on)
{
  Overlapping_world world(plane());
  world.add({at(2, 2), at(3, 2), at(2, 2), at(2, 3)});
  world.order();
  check_equal(world.bundle(at(2, 2), at(3, 2)), {1_s, 2_s});

  Overlapping_world held(plane()); // an end at the node, on the left of the curve where it turns from E to N
  held.add({at(2, 2), at(3, 2), at(2, 2), at(2, 3)});
  held.add({at(3, 3), at(2, 2)}); // NE
  held.order();
  check_equal(held.bundle(at(2, 2), at(3, 2)), {1_s, 2_s});

  Overlapping_world other(plane()); // and on the right
  other.add({at(2, 2), at(3, 2), at(2, 2), at(2, 3)});
  other.add({at(1, 2), at(2, 2)});
  other.order();
  check_equal(other.bundle(at(2, 2), at(3, 2)), {2_s, 1_s});
}

BOOST_AUTO_TEST_CASE(turning_back_beside_a_segment)
{
  Overlapping_world world(plane());
  world.add(run(0, 1, 0, 1));
  world.add({at(2, 1), at(2, 2), at(3, 2), at(2, 2), at(1, 2)}); // S, E and back, W: both strands below
  world.order();
  check_equal(world.curves(at(2, 2), at(3, 2)), {0_c, 1_c, 1_c});

  Overlapping_world crossing(plane());
  crossing.add(run(-1, 0, 0, 1));
  crossing.add({at(2, 1), at(2, 2), at(3, 2), at(2, 2), at(2, 3)});
  check_crossing(crossing, {at(2, 2), at(3, 2)});
}

BOOST_AUTO_TEST_CASE(zigzag_on_one_edge)
{
  for(int n : {3, 10, 101}) {
    Overlapping_world world(plane());
    Vertex_sequence path;
    for(int i = 0; i <= n; ++i)
      path.push_back(at(2 + i % 2, 2));
    world.add(path);
    world.add(path, false);
    world.order();
  }
}

BOOST_AUTO_TEST_CASE(closed_out_and_back)
{
  Overlapping_world world(plane());
  world.add({at(2, 2), at(3, 2), at(4, 2), at(3, 2)}, true);
  world.add({at(3, 2), at(2, 2)}, true);
  world.add({at(2, 2), at(3, 2)}, false);
  world.order();
}

// ---------------------------------------------------------------- around and around

BOOST_AUTO_TEST_CASE(loops_covered_several_times)
{
  for(int turns = 2; turns < 12; ++turns) {
    Overlapping_world world(cylinder(5, 2, 1, 1));
    world.add(ring_path(5, 1, turns), true);
    check_crossing(world, ring_path(5, 1, 1));
  }
}

BOOST_AUTO_TEST_CASE(spirals)
{
  for(int turns = 1; turns < 12; ++turns) {
    Overlapping_world world(cylinder(5, 2, 1, 1));
    Vertex_sequence path = ring_path(5, 1, turns, 1);
    path.insert(path.begin(), 0_v); // from below ...
    path.push_back(10_v);           // ... upwards
    world.add(path);
    world.order();
    const Segment_list bundle = world.bundle(5_v, 6_v);
    BOOST_TEST(bundle.size() == std::size_t(turns));
    BOOST_TEST(std::is_sorted(bundle.rbegin(), bundle.rend())); // counterclockwise: up is left
  }
}

BOOST_AUTO_TEST_CASE(a_spiral_with_free_ends)
{
  for(int turns = 2; turns < 12; ++turns) {
    Overlapping_world world(cylinder(5, 2, 1, 1));
    world.add(ring_path(5, 1, turns, 3)); // both ends at one vertex would be on different sides of the strands between
    world.order();
    const Segment_list bundle = world.bundle(5_v, 6_v);
    BOOST_TEST((std::is_sorted(bundle.begin(), bundle.end()) || std::is_sorted(bundle.rbegin(), bundle.rend())));
  }
}

BOOST_AUTO_TEST_CASE(a_path_that_leaves_a_cycle_where_it_came_from)
{
  Overlapping_world world(cylinder(5, 2, 1, 1));
  Vertex_sequence path = ring_path(5, 1, 2);
  path.insert(path.begin(), 0_v);
  path.push_back(4_v);
  world.add(path);
  check_crossing(world, ring_path(5, 1, 1));
}

BOOST_AUTO_TEST_CASE(torus_loops)
{
  for(int p = 0; p <= 5; ++p)
    for(int q = 0; q <= 5; ++q) {
      Overlapping_world world(torus(7, 6, 2, 1));
      const int divisor = std::gcd(p, q);
      if(divisor == 0)
        continue;
      Vertex_sequence loop;
      for(int i = 0; i < divisor; ++i) {
        const Vertex_sequence once = torus_loop(7, 6, p / divisor, q / divisor);
        loop.insert(loop.end(), once.begin(), once.end());
      }
      world.add(loop, true);
      if(divisor == 1)
        world.order();
      else
        BOOST_CHECK_THROW(order_overlapping_curves(world.network), Crossing_curves_error);
    }
}

BOOST_AUTO_TEST_CASE(a_search_that_is_given_up)
{
  Overlapping_world world(cylinder(5, 2, 1, 1));
  world.add(ring_path(5, 1, 3), true);
  const CGAL::Flip_geodesics::internal::Bundle_pairs<Network> pairs(world.network);
  CGAL::Flip_geodesics::internal::Crossing_equations<Network> equations(pairs);
  CGAL::Flip_geodesics::internal::Bundle_order_search<Network> search(equations, 0);
  BOOST_CHECK_EXCEPTION(search.run().raise(), Ambiguous_order_error, [&](const Ambiguous_order_error& error) {
    return error.elements().size() == 2 && error.elements()[0] / 5 == 1 && error.elements()[1] / 5 == 1;
  });
}

// ---------------------------------------------------------------- size

// 900 000 pairs in half a second; to sort strands by walks along them would take as long as the walks, 3000 steps, each
// time.
BOOST_AUTO_TEST_CASE(a_long_spiral)
{
  Overlapping_world world(cylinder(5, 2, 1, 1));
  Vertex_sequence path = ring_path(5, 1, 600, 1);
  path.insert(path.begin(), 0_v);
  path.push_back(10_v);
  world.add(path);
  order_overlapping_curves(world.network);
  const Segment_list bundle = world.bundle(5_v, 6_v);
  BOOST_TEST(std::is_sorted(bundle.rbegin(), bundle.rend()));
}

// Paths along a line that turn back here and there, and each end at other vertices: one above the other they do not
// cross. With defaults along each strand, not reversed where its curve has turned back, 60 paths took 2248 retries.
BOOST_AUTO_TEST_CASE(a_long_trunk)
{
  for(int n : {10, 30, 60}) {
    std::mt19937 engine(1);
    Overlapping_world world(flat_grid(2 * n, 4, Diagonal_rule::RISING));
    std::vector<int> ends;
    for(int i = 0; i < 2 * n; ++i) {
      ends.push_back(i);
      std::swap(ends.back(), ends[engine() % ends.size()]);
    }
    for(int c = 0; c < n; ++c) {
      const int step = ends[2 * c] < ends[2 * c + 1] ? 1 : -1;
      Vertex_sequence path = {Vertex_index(grid_vertex(2 * n, ends[2 * c], 2))};
      while(path.back() != Vertex_index(grid_vertex(2 * n, ends[2 * c + 1], 2))) {
        path.emplace_back(path.back().idx() + step);
        if(engine() % 8 == 0)
          path.insert(path.end(), {Vertex_index(path.back().idx() - step), path.back()});
      }
      world.add(path);
    }
    world.order();
  }
}
