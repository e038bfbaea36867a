// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_CERTIFIED_TRAITS_JUDGED_MESHES_H
#define FLIP_GEODESICS_TEST_CERTIFIED_TRAITS_JUDGED_MESHES_H

#include "Curve_setting.h"
#include "Recording_traits.h"
#include "Referee.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "lawson.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

// Meshes with ties, near them and without, and a referee over what is decided on them.
namespace judged_test {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

#ifdef FLIP_GEODESICS_LONG_TESTS
constexpr int scale = 30;
#else
constexpr int scale = 1;
#endif

using Kernel = CGAL::Simple_cartesian<double>;
using Certified_traits = FG::Certified_intrinsic_triangulation_traits<Kernel>;
using Recording = Recording_traits<Kernel>;
using Point_metric = FG::Embedded_metric<Surface, boost::property_map<Surface, CGAL::vertex_point_t>::const_type>;
using Lengths = std::map<boost::graph_traits<Surface>::edge_descriptor, double>;

inline Mesh_soup turned(const Mesh_soup& soup)
{
  return mapped(soup, [](const Coordinates& p) {
    return Coordinates{0.36 * p[0] + 0.48 * p[1] - 0.8 * p[2], -0.8 * p[0] + 0.6 * p[1],
                       0.48 * p[0] + 0.64 * p[1] + 0.6 * p[2]};
  });
}

// Points on a line but for rounding: faces that are all but segments, with angles near 0 and near pi.
inline Mesh_soup squeezed(const Mesh_soup& soup, double factor)
{
  return mapped(soup, [=](const Coordinates& p) { return Coordinates{p[0], p[1] * factor, p[2] * factor}; });
}

struct Named_soup
{
  std::string name;
  Mesh_soup soup;
};

inline std::vector<Named_soup> soups_full_of_ties()
{
  return {{"rising grid", flat_grid(8, 8, Diagonal_rule::RISING)},
          {"alternating grid", flat_grid(8, 8, Diagonal_rule::ALTERNATING)},
          {"random grid", flat_grid(8, 8, Diagonal_rule::RANDOM)},
          {"grid with a hole", grid_with_hole(9, 9, 3, 6, 2, 5)},
          {"cube", cube(5)},
          {"box", box(3, 5, 7, 4)},
          {"tetrahedron", tetrahedron(6)},
          {"octahedron", octahedron(6)},
          {"plate", genus_3_plate(2)},
          {"needles", needle_strip(10, 6, 0x1p30)}};
}

inline std::vector<Named_soup> soups_near_ties()
{
  return {{"turned cube", turned(cube(5))},
          {"turned tetrahedron", turned(tetrahedron(5))},
          {"turned octahedron", turned(octahedron(5))},
          {"turned needles", turned(needle_strip(10, 6, 1e6))},
          {"cylinder", cylinder(12, 5, 1, 3)},
          {"cone disk", cone_disk(6, 4, 2)},
          {"saddle disk", saddle_disk(6, 4, 8)},
          {"shaken grid", shaken(flat_grid(8, 8, Diagonal_rule::RANDOM), 1e-15, 1)},
          {"squeezed grid", shaken(squeezed(flat_grid(6, 6, Diagonal_rule::RANDOM), 1e-15), 1e-16, 2)},
          {"turned squeezed grid", turned(squeezed(jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 3), 1e-14))}};
}

inline std::vector<Named_soup> generic_soups()
{
  return {{"jittered grid", jittered_grid(8, 8, Diagonal_rule::RANDOM, 0.2, 4)},
          {"sphere", bumpy_sphere(5, 0.3, 5)},
          {"torus", torus(14, 9, 3, 1)},
          {"far away", translated(bumpy_sphere(4, 0.3, 6), 1e6, 1e6, 1e6)},
          {"tiny", scaled(bumpy_sphere(4, 0.3, 7), 1e-60)},
          {"huge", scaled(bumpy_sphere(4, 0.3, 8), 1e60)},
          {"jittered needles", squeezed(jittered_grid(8, 8, Diagonal_rule::RANDOM, 0.2, 9), 1e-8)},
          {"polyhedron", random_convex_polyhedron(60, 10)}};
}

// What the referee says of every decision that a triangulation takes.
template <class Triangulation, class Shape>
class Judge
{
public:
  Judge(const Triangulation& triangulation, const Shape& shape)
    : m_triangulation(triangulation)
    , m_referee(triangulation, shape)
  {
  }

  void operator()(const Decision& decision)
  {
    ++decisions;
    filtered += decision.is_filtered ? 1 : 0;
    for(FG::Halfedge_index h : {decision.from, decision.to})
      bent_edges += m_referee.is_straight(m_triangulation.edge_sequence(h)) ? 0 : 1;
    try {
      const int comparison = m_referee.compare_wedge(decision.from, decision.to);
      ties += comparison == 0 ? 1 : 0;
      disagreements += comparison == decision.result ? 0 : 1;
    } catch(const No_order&) {
      ++undecided;
    }
  }

  std::size_t decisions = 0, filtered = 0, ties = 0, disagreements = 0, bent_edges = 0, undecided = 0;

private:
  const Triangulation& m_triangulation;
  Referee<Triangulation, Shape> m_referee;
};

template <class Triangulation>
void pull(Triangulation& triangulation, FG::Edge_path_network<Triangulation>& network)
{
  FG::shorten(network);
  network.clear();
  triangulation.rollback();
}

// Paths, networks of paths, loops, and random flips with loops among the flipped edges.
template <class Triangulation>
void work(Triangulation& triangulation, Random_numbers& random)
{
  FG::Edge_path_network<Triangulation> network(triangulation);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  const int n = triangulation.number_of_vertices();
  const auto path = [&] {
    const int u = random.below(n);
    return search(FG::Vertex_index(u), FG::Vertex_index((u + 1 + random.below(n - 1)) % n));
  };
  for(int i = 0; i < 4; ++i) {
    network.add_curve(path());
    pull(triangulation, network);
  }
  for(int i = 0; i < 3; ++i)
    network.add_curve(path());
  try {
    FG::order_overlapping_curves(network);
    pull(triangulation, network);
  } catch(const FG::Crossing_curves_error&) {
    network.clear();
  }
  for(int i = 0; i < 3; ++i) {
    if(i > 0)
      flip_at_random(triangulation, 50, random);
    const Halfedge_sequence loop = random_walk(triangulation, 12, true, random);
    if(loop.empty())
      continue;
    network.add_curve(loop, CGAL::parameters::is_closed(true));
    if(order_at_random(network, loop, 5, random))
      pull(triangulation, network);
    network.clear();
  }
  triangulation.rollback();
}

struct Totals
{
  std::size_t decisions = 0, filtered = 0, ties = 0;
};

template <class Triangulation, class Shape>
void judge_work(const std::string& name, Triangulation& triangulation, const Shape& shape, int rounds,
                Decision_observer& observer, Totals& totals)
{
  Judge<Triangulation, Shape> judge(triangulation, shape);
  observer.on_decision = std::ref(judge);
  Random_numbers random(1);
  for(int i = 0; i < rounds * scale; ++i)
    work(triangulation, random);
  observer.on_decision = nullptr;
  std::cout << name << ": " << judge.decisions << " decisions, " << judge.filtered << " by the filter, " << judge.ties
            << " ties\n";
  BOOST_TEST_CONTEXT(name)
  {
    BOOST_TEST(judge.decisions > 100u);
    BOOST_TEST(judge.disagreements == 0u);
    BOOST_TEST(judge.bent_edges == 0u);
    BOOST_TEST(judge.undecided == 0u);
    BOOST_TEST(triangulation.decision_statistics().unproven_zeros == 0u);
  }
  totals.decisions += judge.decisions;
  totals.filtered += judge.filtered;
  totals.ties += judge.ties;
}

inline Totals judge_soups(const std::vector<Named_soup>& soups, int rounds)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Recording>;
  Totals totals;
  for(const Named_soup& named : soups) {
    Decision_observer observer;
    Surface mesh = to_mesh<Surface>(named.soup);
    Triangulation triangulation(mesh, Recording(observer));
    judge_work(named.name, triangulation, Shape_of_points<Surface>(mesh), rounds, observer, totals);
  }
  return totals;
}

template <class LengthFunction>
void judge_lengths(const std::string& name, const Mesh_soup& soup, const LengthFunction& length, int rounds,
                   Totals& totals)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Recording, Length_metric>;
  Decision_observer observer;
  Surface mesh = to_mesh<Surface>(soup);
  Lengths lengths = edge_lengths(mesh, length);
  const Length_map map(lengths);
  Triangulation triangulation(mesh, Length_metric(mesh, map), Recording(observer));
  judge_work(name, triangulation, Shape_of_lengths<Surface, Length_map>(mesh, map), rounds, observer, totals);
}

} // namespace judged_test

#endif // FLIP_GEODESICS_TEST_CERTIFIED_TRAITS_JUDGED_MESHES_H
