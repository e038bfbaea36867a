// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE networks_from_data

#include "Curve_setting.h"
#include "Topological_signature.h"
#include "descriptors.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/networks_from_data.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Curve_index;
using FG::Index;
using FG::Junctions;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

namespace {

using Setting = Curve_setting;
using Region_map = Surface::Property_map<Surface::Face_index, int>;

// Regions by the octant, or another function, of a face's first corner, which makes jagged boundaries.
template <class Function>
Region_map label(Surface& mesh, const Function& region)
{
  Region_map regions = mesh.add_property_map<Surface::Face_index, int>("f:region", 0).first;
  for(const auto f : mesh.faces())
    regions[f] = region(mesh.point(mesh.target(mesh.halfedge(f))));
  return regions;
}

int octant(const Surface::Point& p) { return (p.x() > 0.1 ? 1 : 0) + (p.y() > 0.1 ? 2 : 0) + (p.z() > 0.1 ? 4 : 0); }

std::size_t count_boundary_edges(const Surface& mesh, const Region_map& regions)
{
  std::size_t count = 0;
  for(const auto e : mesh.edges())
    count += !mesh.is_border(e) && regions[mesh.face(mesh.halfedge(e, 0))] != regions[mesh.face(mesh.halfedge(e, 1))];
  return count;
}

std::size_t count_segments(const Setting& setting)
{
  std::size_t count = 0;
  for(Curve_index c : descriptors<Curve_index>(setting.network.number_of_curves()))
    count += setting.network.halfedges(c).size();
  return count;
}

std::set<int> contracted(const Setting& setting)
{
  std::set<int> result;
  for(Curve_index c : descriptors<Curve_index>(setting.network.number_of_curves()))
    if(setting.network.is_contracted(c))
      result.insert(c.idx());
  return result;
}

// The topology of the patches is that of the beginning: no stop, and no curve, contracted ones aside, may change it.
template <class Stop>
FG::Shortening_report check_pull(Setting& setting, const Stop& stop)
{
  BOOST_TEST(setting.network.is_valid());
  const Curve_system before(setting.network);
  const auto report = setting.pull(stop);
  BOOST_TEST(setting.network.is_valid());
  BOOST_TEST(setting.triangulation.is_valid());
  const std::set<int> gone = contracted(setting);
  BOOST_TEST((Topological_signature(before, gone) == Topological_signature(Curve_system(setting.network), gone)));
  return report;
}

std::vector<Mesh_soup> meshes()
{
  return {sphere(8), bumpy_sphere(8, 0.3, 1), torus(24, 12, 2, 0.8),
          mapped(flat_grid(20, 20, Diagonal_rule::RANDOM), [](const Coordinates& p) {
            return Coordinates{p[0] - 10, p[1] - 9, 0.2 * p[0]};
          })};
}

} // namespace

BOOST_AUTO_TEST_CASE(boundaries_with_fixed_junctions)
{
  for(const Mesh_soup& soup : meshes()) {
    Setting setting(soup);
    const Region_map regions = label(setting.mesh, octant);
    const Index count = FG::add_region_boundaries(setting.network, setting.mesh, regions);
    BOOST_TEST(count == setting.network.number_of_curves());
    BOOST_TEST(count > 3);
    BOOST_TEST(count_segments(setting) == count_boundary_edges(setting.mesh, regions));
    const auto report = check_pull(setting, FG::Never_stop_predicate());
    BOOST_TEST(report.is_complete());
    for(const FG::Curve_report& curve : report.curves)
      BOOST_TEST(curve.length <= curve.initial_length * (1 + 1e-12));
  }
}

// Two strands on each edge, of which each has its region on the left.
BOOST_AUTO_TEST_CASE(boundaries_with_free_junctions)
{
  for(const Mesh_soup& soup : meshes()) {
    Setting setting(soup);
    const Region_map regions = label(setting.mesh, octant);
    FG::add_region_boundaries(setting.network, setting.mesh, regions, Junctions::FREE);
    BOOST_TEST(count_segments(setting) == 2 * count_boundary_edges(setting.mesh, regions));
    for(Curve_index c : descriptors<Curve_index>(setting.network.number_of_curves())) {
      std::set<int> on_left;
      for(FG::Halfedge_index h : setting.network.halfedges(c)) {
        on_left.insert(regions[setting.mesh.face(setting.triangulation.input_halfedge(h))]);
        const FG::Edge_index e = setting.triangulation.edge(h);
        const std::vector<FG::Segment_index> bundle = setting.network.bundle(e);
        BOOST_TEST(bundle.size() == 2u);
        BOOST_TEST(setting.network.halfedge(bundle.front()) == FG::internal::first_side(e));
      }
      BOOST_TEST(on_left.size() == 1u);
      const FG::Halfedge_index first = setting.network.halfedges(c).front();
      const auto start = setting.mesh.source(setting.triangulation.input_halfedge(first));
      BOOST_TEST(setting.network.is_closed(c) != setting.mesh.is_border(start));
    }
    check_pull(setting, FG::Curve_length_ratio_stop_predicate(0.9));
  }
}

// With a limit for each curve all survive, and none is shorter than it says.
BOOST_AUTO_TEST_CASE(stopped_at_nine_tenths)
{
  for(const Mesh_soup& soup : meshes())
    for(Junctions junctions : {Junctions::FIXED, Junctions::FREE}) {
      Setting setting(soup);
      const Region_map regions = label(setting.mesh, octant);
      FG::add_region_boundaries(setting.network, setting.mesh, regions, junctions);
      const auto report = check_pull(setting, FG::Curve_length_ratio_stop_predicate(0.9));
      BOOST_TEST(contracted(setting).empty());
      for(const FG::Curve_report& curve : report.curves)
        BOOST_TEST(curve.length >= 0.9 * curve.initial_length * (1 - 1e-12));
    }
}

// Left to run, free junctions let go: on a sphere, which is convex, every region's curve contracts.
BOOST_AUTO_TEST_CASE(free_junctions_move)
{
  Setting setting(sphere(6));
  const Region_map regions = label(setting.mesh, octant);
  const Index count = FG::add_region_boundaries(setting.network, setting.mesh, regions, Junctions::FREE);
  BOOST_TEST(count == 8);
  check_pull(setting, FG::Never_stop_predicate());
  BOOST_TEST(contracted(setting).size() == 8u);
}

BOOST_AUTO_TEST_CASE(one_region_and_one_per_face)
{
  Setting setting(sphere(3));
  const Region_map one = label(setting.mesh, [](const Surface::Point&) { return 7; });
  BOOST_TEST(FG::add_region_boundaries(setting.network, setting.mesh, one) == 0);
  BOOST_TEST(FG::add_region_boundaries(setting.network, setting.mesh, one, Junctions::FREE) == 0);

  Region_map each = setting.mesh.add_property_map<Surface::Face_index, int>("f:each", 0).first;
  for(const auto f : setting.mesh.faces())
    each[f] = static_cast<int>(f);
  BOOST_TEST(FG::add_region_boundaries(setting.network, setting.mesh, each) ==
             static_cast<Index>(setting.mesh.number_of_edges()));
  setting.network.clear();
  BOOST_TEST(FG::add_region_boundaries(setting.network, setting.mesh, each, Junctions::FREE) ==
             static_cast<Index>(setting.mesh.number_of_faces()));
  check_pull(setting, FG::Never_stop_predicate());
}

// A torus unrolled into a square has two seams, that meet in one vertex: one curve around it each way.
BOOST_AUTO_TEST_CASE(seams_of_an_unrolled_torus)
{
  constexpr int n = 12, m = 8;
  Setting setting(torus(n, m, 2, 0.8));
  using Texture = std::array<double, 2>;
  auto texture = setting.mesh.add_property_map<Surface::Halfedge_index, Texture>("h:texture", Texture{{0, 0}}).first;
  const auto angles = [&](Surface::Vertex_index v) {
    const auto& p = setting.mesh.point(v);
    const double radius = std::hypot(p.x(), p.y());
    return Texture{{std::atan2(p.y(), p.x()), std::atan2(p.z(), radius - 2)}};
  };
  for(const auto h : setting.mesh.halfedges()) {
    Texture t = angles(setting.mesh.target(h));
    const auto hn = setting.mesh.next(h), hp = setting.mesh.next(hn);
    for(int i = 0; i < 2; ++i) { // the whole turn that is nearest to the rest of the face
      const double least = (std::min)({t[i], angles(setting.mesh.target(hn))[i], angles(setting.mesh.target(hp))[i]});
      t[i] = std::round((t[i] - least > pi ? t[i] - 2 * pi : t[i]) * 1e6);
    }
    texture[h] = t;
  }
  const Index count = FG::add_seams(setting.network, setting.mesh, texture);
  BOOST_TEST(count == 2);
  BOOST_TEST(count_segments(setting) == static_cast<std::size_t>(n + m));
  BOOST_TEST(!setting.network.is_closed(0_c));
  BOOST_TEST(!setting.network.is_closed(1_c));
  BOOST_TEST(check_pull(setting, FG::Never_stop_predicate()).is_complete());
}

BOOST_AUTO_TEST_CASE(no_seams_without_jumps)
{
  Setting setting(flat_grid(4, 4, Diagonal_rule::RISING));
  auto texture = setting.mesh.add_property_map<Surface::Halfedge_index, int>("h:texture", 0).first;
  for(const auto h : setting.mesh.halfedges())
    texture[h] = static_cast<int>(setting.mesh.target(h));
  BOOST_TEST(FG::add_seams(setting.network, setting.mesh, texture) == 0);
}

BOOST_AUTO_TEST_CASE(outgoing_halfedges_start_at_the_first_halfedge_or_the_border)
{
  const Setting setting(flat_grid(3, 3, Diagonal_rule::RISING));
  const auto& triangulation = setting.triangulation;
  for(FG::Vertex_index v : descriptors<FG::Vertex_index>(triangulation.number_of_vertices())) {
    const std::vector<FG::Halfedge_index> outgoing_halfedges = FG::internal::outgoing_halfedges(triangulation, v);
    BOOST_REQUIRE(!outgoing_halfedges.empty());
    const bool is_at_border = triangulation.counterclockwise(outgoing_halfedges.front()) == FG::null_index;
    BOOST_TEST((is_at_border || outgoing_halfedges.front() == triangulation.outgoing(v)));
    for(std::size_t i = 0; i + 1 < outgoing_halfedges.size(); ++i)
      BOOST_TEST(triangulation.clockwise(outgoing_halfedges[i]) == outgoing_halfedges[i + 1]);
    BOOST_TEST(triangulation.clockwise(outgoing_halfedges.back()) ==
               (is_at_border ? FG::null_index : outgoing_halfedges.front()));
  }
}

// Two rectangles back to back, with the same diagonal twice once one of them is flipped.
BOOST_AUTO_TEST_CASE(of_equally_long_edges_the_first_is_taken)
{
  for(bool is_first_flipped : {false, true}) {
    Mesh_soup pillow = {{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    if(is_first_flipped)
      std::rotate(pillow.triangles.begin(), pillow.triangles.begin() + 2, pillow.triangles.end());
    Setting setting(pillow);
    auto& triangulation = setting.triangulation;
    triangulation.flip(FG::internal::halfedge_between(triangulation, 1_v, 3_v));
    std::vector<FG::Halfedge_index> diagonals;
    for(FG::Halfedge_index h : FG::internal::outgoing_halfedges(triangulation, 0_v))
      if(triangulation.head(h) == 2_v)
        diagonals.push_back(h);
    BOOST_REQUIRE(diagonals.size() == 2u);
    BOOST_REQUIRE(triangulation.length(diagonals[0]) == triangulation.length(diagonals[1]));
    BOOST_TEST(FG::internal::halfedge_between(triangulation, 0_v, 2_v) == (std::min)(diagonals[0], diagonals[1]));
  }
}

// A vertex where one marked edge ends is an end; one that two pass is none.
BOOST_AUTO_TEST_CASE(marked_edges_that_end_inside)
{
  Setting setting(flat_grid(4, 4, Diagonal_rule::RISING));
  auto is_marked = setting.mesh.add_property_map<Surface::Edge_index, bool>("e:marked", false).first;
  for(int i : {1, 2}) {
    const auto h = setting.mesh.halfedge(Surface::Vertex_index(static_cast<unsigned>(grid_vertex(4, i, 2))),
                                         Surface::Vertex_index(static_cast<unsigned>(grid_vertex(4, i + 1, 2))));
    BOOST_REQUIRE((h != Surface::null_halfedge()));
    is_marked[setting.mesh.edge(h)] = true;
  }
  BOOST_TEST(FG::add_marked_edges(setting.network, setting.mesh, is_marked) == 1);
  BOOST_TEST(setting.network.halfedges(0_c).size() == 2u);
  BOOST_TEST(!setting.network.is_closed(0_c));
}

// The map of a program's own ends it at each of its calls; so does a length, among the curves that are added.
BOOST_AUTO_TEST_CASE(what_throws_leaves_an_empty_network)
{
  struct Interruption
  {
  };
  bool is_done = false;
  int after_a_curve = 0;
  for(int calls = 0; !is_done; ++calls) {
    Setting setting(bumpy_sphere(2, 0.1, 3));
    const Region_map regions = label(setting.mesh, octant);
    int left = calls;
    const auto region = [&](Surface::Face_index f) {
      if(left-- == 0) {
        after_a_curve += setting.network.number_of_curves() > 0 ? 1 : 0;
        throw Interruption();
      }
      return regions[f];
    };
    try {
      FG::add_region_boundaries(setting.network, setting.mesh,
                                boost::make_function_property_map<Surface::Face_index, int>(region), Junctions::FREE);
      is_done = true;
    } catch(const Interruption&) {
      BOOST_TEST_REQUIRE(setting.network.number_of_curves() == 0);
    }
  }
  BOOST_TEST(after_a_curve > 10);

  Setting setting(flat_grid(4, 4, Diagonal_rule::RISING));
  auto is_marked = setting.mesh.add_property_map<Surface::Edge_index, bool>("e:marked", false).first;
  for(const auto e : setting.mesh.edges())
    is_marked[e] = true;
  setting.mesh.point(Surface::Vertex_index(24)) = {1, 1, std::numeric_limits<double>::quiet_NaN()};
  BOOST_CHECK_THROW(FG::add_marked_edges(setting.network, setting.mesh, is_marked), FG::Invalid_coordinate_error);
  BOOST_TEST(setting.network.number_of_curves() == 0);
}
