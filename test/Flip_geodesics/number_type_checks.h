// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_NUMBER_TYPE_CHECKS_H
#define FLIP_GEODESICS_TEST_NUMBER_TYPE_CHECKS_H

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "lawson.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/certify.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

/* What holds for every number type in Exact_intrinsic_triangulation_traits, or for every exact one. */
namespace Flip_geodesics_test {

template <class NT>
using Exact_traits = CGAL::Flip_geodesics::Exact_intrinsic_triangulation_traits<NT>;

template <class NT>
using Exact_setting = Basic_curve_setting<CGAL::Flip_geodesics::Intrinsic_triangulation<Surface, Exact_traits<NT>>>;

using Certified_setting = Basic_curve_setting<CGAL::Flip_geodesics::Intrinsic_triangulation<
    Surface, CGAL::Flip_geodesics::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>>;

/// A plane mesh without ties, not even on its border.
inline Mesh_soup tieless_plane(int n, unsigned seed)
{
  Random_numbers random(seed);
  return mapped(flat_grid(n, n, Diagonal_rule::RANDOM), [&](const Coordinates& p) {
    const double dx = random.uniform(-0.2, 0.2), dy = random.uniform(-0.2, 0.2);
    return Coordinates{p[0] + dx, p[1] + dy, 0};
  });
}

/// A cube whose points, except for the corners, are moved within the sides and edges they are on: areas are rational.
/// Right angles between edges at different corners are the only ties left.
inline Mesh_soup jittered_cube(int n, unsigned seed)
{
  Random_numbers random(seed);
  return mapped(cube(n), [&, n](Coordinates p) {
    for(double& x : p)
      x += x > 0 && x < n ? random.uniform(-0.2, 0.2) : 0;
    return p;
  });
}

/// The same plane mesh in the plane x + y + z = 0, its coordinates multiples of 2^-20: areas are rational multiples of
/// the root of 3.
inline Mesh_soup oblique(const Mesh_soup& plane)
{
  return mapped(plane, [](const Coordinates& p) {
    const double u = std::round(p[0] * 0x1p20) * 0x1p-20, v = std::round(p[1] * 0x1p20) * 0x1p-20;
    return Coordinates{u, v - u, -v};
  });
}

// ---------------------------------------------------------------- the same curves

/// What came out, as integers.
struct Outcome
{
  std::vector<CGAL::Flip_geodesics::Shortening_status> statuses;
  std::vector<CGAL::Flip_geodesics::Halfedge_index> flips;
  std::vector<std::vector<int>> crossed; // per curve; an edge along input halfedge h is -1 - h

  bool operator==(const Outcome& other) const
  {
    return statuses == other.statuses && flips == other.flips && crossed == other.crossed;
  }
};

template <class Setting>
Outcome outcome(Setting& setting)
{
  using CGAL::Flip_geodesics::Curve_index;
  Outcome result;
  const CGAL::Flip_geodesics::Shortening_report report = setting.pull();
  result.flips = setting.flips();
  for(Curve_index c(0); c.idx() < setting.network.number_of_curves(); ++c) {
    result.statuses.push_back(report.curves[c.idx()].status);
    result.crossed.emplace_back();
    setting.network.for_each_segment(c, [&](CGAL::Flip_geodesics::Segment_index s) {
      const auto word = setting.triangulation.edge_sequence(setting.network.halfedge(s));
      if(word.along.is_valid())
        result.crossed.back().push_back(-1 - word.along.idx());
      for(const auto h : word.crossed)
        result.crossed.back().push_back(h.idx());
    });
  }
  return result;
}

template <class Setting>
void take_back(Setting& setting)
{
  setting.network.clear();
  setting.triangulation.rollback();
}

/// Pulls random networks of one to three paths and loops, as long as they do not cross, with two settings.
/// \return the number of flips
template <class Setting, class Reference>
std::size_t check_same_curves(Setting& setting, Reference& reference, int rounds, unsigned seed)
{
  Random_numbers random(seed);
  std::size_t flips = 0;
  for(int round = 0; round < rounds; ++round) {
    for(int c = 0; c <= round % 3; ++c) {
      const bool is_closed = random.below(2) == 1;
      const Halfedge_sequence walk = random_walk(reference.triangulation, 16, is_closed, random);
      if(walk.empty())
        continue;
      reference.network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
      setting.network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
    }
    if(reference.network.is_valid()) {
      const Outcome expected = outcome(reference);
      BOOST_TEST((outcome(setting) == expected));
      BOOST_TEST(CGAL::Flip_geodesics::certify(setting.network).is_locally_shortest());
      flips += expected.flips.size();
    }
    take_back(setting);
    take_back(reference);
  }
  return flips;
}

template <class Traits>
void check_same_curves_as_certified(const Mesh_soup& soup, const Traits& traits, int rounds)
{
  Basic_curve_setting<CGAL::Flip_geodesics::Intrinsic_triangulation<Surface, Traits>> setting(soup, traits);
  Certified_setting reference(soup);
  BOOST_TEST(check_same_curves(setting, reference, rounds, 1) > static_cast<std::size_t>(rounds));
}

// ---------------------------------------------------------------- ties

template <class Setting>
void check_proven(Setting& setting, double length)
{
  const CGAL::Flip_geodesics::Shortening_report report = setting.pull();
  BOOST_TEST(report.is_complete());
  const auto certificate = CGAL::Flip_geodesics::certify(setting.network);
  for(std::size_t c = 0; c < report.curves.size(); ++c) {
    BOOST_TEST(to_string(certificate.curves[c].verdict()) == "PROVEN");
    BOOST_TEST(std::abs(report.curves[c].length - length) <= 1e-12 * length);
  }
  take_back(setting);
}

/// Paths on a grid are straight lines in one segment, of exactly the length of Pythagoras.
template <class NT>
void check_grid(int n)
{
  for(const Diagonal_rule rule : {Diagonal_rule::RISING, Diagonal_rule::ALTERNATING, Diagonal_rule::RANDOM}) {
    Exact_setting<NT> setting(flat_grid(n, n, rule));
    for(const auto& [i, j] : {std::pair<int, int>{n, n - 1}, {n - 1, n}, {n, 1}, {1, n}, {n - 2, n - 1}}) {
      setting.add(vertex_path_on_grid(n, {{0, 0}, {i, 0}, {i, j}}), false);
      setting.pull();
      const auto& halfedges = setting.network.halfedges(0_c);
      BOOST_TEST(halfedges.size() == 1u);
      BOOST_TEST((setting.triangulation.squared_length(halfedges.front()) == NT(i * i + j * j)));
      BOOST_TEST(CGAL::Flip_geodesics::certify(setting.network).is_locally_shortest());
      take_back(setting);
    }
  }
}

/// A network of two paths that share edges.
template <class NT>
void check_overlapping_paths(int n)
{
  Exact_setting<NT> setting(flat_grid(n, n, Diagonal_rule::ALTERNATING));
  for(const Vertex_sequence& path : overlapping_paths(n, n / 2))
    setting.add(path, false);
  CGAL::Flip_geodesics::order_overlapping_curves(setting.network);
  check_proven(setting, n);
}

/// Closed geodesics through the midst of faces and along edges, pulled tight from detours.
template <class Traits>
void check_tetrahedron_loop(const Traits& traits, int n)
{
  const Mesh_soup soup = tetrahedron(n);
  Basic_curve_setting<CGAL::Flip_geodesics::Intrinsic_triangulation<Surface, Traits>> setting(soup, traits);
  setting.add(with_detours(soup, tetrahedron_loop(n), true), true);
  check_proven(setting, 2 * n * std::sqrt(8));
}

template <class NT>
void check_genus_3_loops(int n)
{
  const Mesh_soup soup = genus_3_plate(n);
  Exact_setting<NT> setting(soup);
  for(const Vertex_sequence& loop : genus_3_loops(n)) {
    setting.add(with_detours(soup, loop, true), true);
    check_proven(setting, 4 * n);
  }
}

// ---------------------------------------------------------------- the numbers themselves

/// The products of the corners about each vertex, without their magnitudes: complex numbers with the radicand `d`.
template <class Triangulation>
class Vertex_turns
{
  using NT = typename Triangulation::FT;

public:
  Vertex_turns(const Triangulation& triangulation, const NT& radicand)
    : m_radicand(radicand)
    , m_turns(triangulation.number_of_vertices(), {NT(1), NT(0)})
  {
    for(CGAL::Flip_geodesics::Halfedge_index h(0); h.idx() < triangulation.number_of_halfedges(); ++h) {
      if(triangulation.is_border(h))
        continue;
      typename Triangulation::Turn corner;
      triangulation.extend_turn(corner, h);
      multiply(m_turns[triangulation.head(h).idx()], {corner.x, corner.y});
      m_quadrupled_area += corner.y;
      // The law of cosines: the corner's number has the norm 2 |in| |out|.
      const NT in = triangulation.squared_length(h), out = triangulation.squared_length(triangulation.next(h));
      m_is_consistent = m_is_consistent && norm(corner.x, corner.y) == NT(4 * NT(in * out));
    }
  }

  bool is_consistent() const { return m_is_consistent; }
  const NT& tripled_quadrupled_area() const { return m_quadrupled_area; }

  /// Are all angles the same, up to full turns?
  bool have_the_same_angles(const Vertex_turns& other) const
  {
    for(std::size_t v = 0; v < m_turns.size(); ++v) {
      const auto& [a, b] = m_turns[v];
      const auto& [c, d] = other.m_turns[v];
      if(NT(a * d) != NT(b * c) || !(NT(a * c) + m_radicand * NT(b * d) > NT(0)))
        return false;
    }
    return true;
  }

private:
  NT norm(const NT& x, const NT& y) const { return NT(x * x) + NT(m_radicand * NT(y * y)); }

  void multiply(std::pair<NT, NT>& turn, const std::pair<NT, NT>& corner) const
  {
    const NT x = NT(turn.first * corner.first) - NT(m_radicand * NT(turn.second * corner.second));
    turn.second = NT(turn.first * corner.second) + NT(turn.second * corner.first);
    turn.first = x;
  }

  NT m_radicand;
  NT m_quadrupled_area = NT(0);
  bool m_is_consistent = true;
  std::vector<std::pair<NT, NT>> m_turns;
};

template <class Triangulation>
bool have_equal_sides(const Triangulation& triangulation)
{
  const auto squared_length = triangulation.traits().compute_squared_length_object();
  namespace FG = CGAL::Flip_geodesics;
  for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(triangulation.number_of_edges())) {
    const FG::Halfedge_index h = FG::internal::first_side(e), t = Triangulation::twin(h);
    if(!triangulation.is_border(h) && !triangulation.is_border(t) &&
       squared_length(triangulation.geometry(h)) != squared_length(triangulation.geometry(t)))
      return false;
  }
  return true;
}

/// Flips keep areas and the angles at vertices, exactly; four flips of an edge, and the log, take them back.
/// \param radicand the radicand in whose root areas are counted
template <class Traits>
void check_flips(const Mesh_soup& soup, const Traits& traits, const typename Traits::FT& radicand, int attempts)
{
  using Triangulation = CGAL::Flip_geodesics::Intrinsic_triangulation<Surface, Traits>;
  const Surface mesh = to_mesh<Surface>(soup);
  Triangulation triangulation(mesh, traits);
  const Vertex_turns<Triangulation> before(triangulation, radicand);
  BOOST_TEST(before.is_consistent());
  Random_numbers random(1);
  BOOST_TEST(flip_at_random(triangulation, attempts, random) > attempts / 4);
  BOOST_TEST(have_equal_sides(triangulation));
  const Vertex_turns<Triangulation> after(triangulation, radicand);
  BOOST_TEST(after.is_consistent());
  BOOST_TEST((after.tripled_quadrupled_area() == before.tripled_quadrupled_area()));
  BOOST_TEST(after.have_the_same_angles(before));

  for(CGAL::Flip_geodesics::Halfedge_index h(0); h.idx() < triangulation.number_of_halfedges(); ++h) {
    if(!triangulation.is_flippable(h))
      continue;
    const auto length = triangulation.squared_length(h);
    for(int i = 0; i < 4; ++i)
      triangulation.flip(h);
    BOOST_TEST((triangulation.squared_length(h) == length));
  }
  triangulation.rollback();
  const Vertex_turns<Triangulation> again(triangulation, radicand);
  BOOST_TEST(again.is_consistent());
  BOOST_TEST(again.have_the_same_angles(before));
}

// ---------------------------------------------------------------- Delaunay

/// The same edges are Delaunay as by the certified traits, and flips end.
template <class Traits>
void check_delaunay(const Mesh_soup& soup, const Traits& traits, int attempts)
{
  const Surface mesh = to_mesh<Surface>(soup);
  CGAL::Flip_geodesics::Intrinsic_triangulation<Surface, Traits> triangulation(mesh, traits);
  typename Certified_setting::Triangulation reference(mesh);
  const auto check = [&] {
    for(CGAL::Flip_geodesics::Halfedge_index h(0); h.idx() < triangulation.number_of_halfedges(); ++h)
      BOOST_TEST(triangulation.is_locally_delaunay(h) == reference.is_locally_delaunay(h));
  };
  check();
  Random_numbers random(1), same_random(1);
  flip_at_random(triangulation, attempts, random);
  flip_at_random(reference, attempts, same_random);
  check();
  const int flips = flip_to_delaunay(reference, 100000);
  BOOST_TEST(flips > 0);
  BOOST_TEST(flip_to_delaunay(triangulation, 100000) == flips);
  BOOST_TEST(are_all_edges_delaunay(triangulation));
}

// ---------------------------------------------------------------- lengths instead of points

/// A grid of right triangles with the sides 3, 4, 5, given by these lengths.
template <class NT>
void check_right_triangles(int n)
{
  using Triangulation = CGAL::Flip_geodesics::Intrinsic_triangulation<Surface, Exact_traits<NT>, Length_metric>;
  const Surface mesh = to_mesh<Surface>(flat_grid(n, n, Diagonal_rule::ALTERNATING));
  std::map<boost::graph_traits<Surface>::edge_descriptor, double> lengths;
  for(const auto e : edges(mesh)) {
    const auto d = mesh.point(target(e, mesh)) - mesh.point(source(e, mesh));
    lengths[e] = d.x() == 0 ? 4 : (d.y() == 0 ? 3 : 5);
  }
  Triangulation triangulation(mesh, Length_metric(mesh, Length_map(lengths)));
  CGAL::Flip_geodesics::Edge_path_network<Triangulation> network(triangulation);
  const Vertex_sequence path = vertex_path_on_grid(n, {{0, 0}, {n, 0}, {n, n - 1}});
  network.add_curve(CGAL::Flip_geodesics::halfedges_through(triangulation, path));
  CGAL::Flip_geodesics::shorten(network);
  BOOST_TEST(network.halfedges(0_c).size() == 1u);
  const int x = 3 * n, y = 4 * (n - 1);
  BOOST_TEST((triangulation.squared_length(network.halfedges(0_c).front()) == NT(x * x + y * y)));
  BOOST_TEST(CGAL::Flip_geodesics::certify(network).is_locally_shortest());
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_NUMBER_TYPE_CHECKS_H
