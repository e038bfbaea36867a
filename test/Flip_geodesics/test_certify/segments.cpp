// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Segments that are given by their ends and the edges that they cross.

#include "test_certify/second_opinion.h"

#include <CGAL/Flip_geodesics/certify_segment.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace Flip_geodesics_test;

namespace {

using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;

Halfedge spoke(const Surface& mesh, int rim) { return mesh.halfedge(Vertex(0), Vertex(static_cast<unsigned>(rim))); }

// Vertex 0 in the middle, and six about it at distance 1.
Mesh_soup hexagon()
{
  Mesh_soup soup = {{{0, 0, 0}}, {}};
  for(int i = 0; i < 6; ++i) {
    soup.points.push_back({std::cos(i * pi / 3), std::sin(i * pi / 3), 0});
    soup.triangles.push_back({0, i + 1, (i + 1) % 6 + 1});
  }
  return soup;
}

template <class Error>
void check_refused(const Surface& mesh, int source, int target, const std::vector<Halfedge>& crossed,
                   const std::vector<std::size_t>& elements)
{
  BOOST_CHECK_EXCEPTION(
      FG::certify_segment(mesh, Vertex(static_cast<unsigned>(source)), Vertex(static_cast<unsigned>(target)), crossed),
      Error, [&](const Error& error) { return error.elements() == elements; });
}

} // namespace

// Told by the mesh's halfedges, by either side, and in both directions.
BOOST_AUTO_TEST_CASE(segments_of_geodesics_are_straight)
{
  std::size_t crossings = 0, edges = 0;
  for(const Mesh_soup& soup : {jittered_grid(14, 14, Diagonal_rule::RANDOM, 0.24, 5), bumpy_sphere(8, 0.3, 1), cube(6)})
  {
    Certified_setting setting(soup);
    Random_numbers random(3);
    for(int i = 0; i < 20; ++i) {
      const FG::Vertex_index from(random.below(setting.triangulation.input().number_of_vertices() - 1));
      setting.add_path(
          from, FG::Vertex_index(from.idx() + 1 +
                                 random.below(setting.triangulation.input().number_of_vertices() - from.idx() - 1)));
      setting.pull();
      for(const auto h : setting.network.halfedges(FG::Curve_index(0))) {
        const FG::Crossing_word word = setting.triangulation.crossing_word(h);
        const auto& input = setting.triangulation.input();
        std::vector<Halfedge> crossed;
        for(const auto c : word.crossed)
          crossed.push_back(input.halfedge(random.below(2) == 0 ? c : FG::internal::twin_index(c)));
        const Vertex source(static_cast<unsigned>(word.tail.idx())), target(static_cast<unsigned>(word.head.idx()));
        const auto certificate = FG::certify_segment(setting.mesh, source, target, crossed);
        BOOST_TEST((certificate.verdict == FG::Certificate_verdict::PROVEN));
        BOOST_TEST(certificate.bend == 0);
        std::reverse(crossed.begin(), crossed.end());
        const auto reversed = FG::certify_segment(setting.mesh, target, source, crossed);
        BOOST_TEST(reversed.is_straight());
        BOOST_TEST_REQUIRE(certificate.places.size() == crossed.size());
        for(std::size_t k = 0; k < crossed.size(); ++k)
          BOOST_TEST(std::abs(certificate.places[k] - reversed.places[crossed.size() - 1 - k]) < 1e-9);
        crossings += crossed.size();
        edges += crossed.empty() ? 1 : 0;
      }
      setting.network.clear();
      setting.triangulation.rollback();
    }
  }
  BOOST_TEST(crossings > 100u);
  BOOST_TEST(edges > 0u);
}

// Six triangles about vertex 0: the chord over one rim vertex is straight, that round the other side is not.
BOOST_AUTO_TEST_CASE(the_bend_of_a_segment_is_told)
{
  const auto mesh = to_mesh<Surface>(hexagon());
  const auto chord = FG::certify_segment(mesh, Vertex(1), Vertex(3), std::vector<Halfedge>{spoke(mesh, 2)});
  BOOST_TEST(chord.is_straight());
  BOOST_TEST(chord.places.size() == 1u);
  BOOST_TEST(std::abs(chord.places[0] - 0.5) < 1e-12); // hexagons have it so
  const std::vector<Halfedge> round = {mesh.opposite(spoke(mesh, 2)), spoke(mesh, 3), spoke(mesh, 4)};
  const auto bent = FG::certify_segment(mesh, Vertex(1), Vertex(5), round);
  BOOST_TEST((bent.verdict == FG::Certificate_verdict::BENT_SEGMENT));
  BOOST_TEST(bent.places.empty());
  BOOST_TEST(std::abs(bent.bend - pi / 6) < 1e-12); // the centre is half a radius off the chord
  BOOST_TEST(bent.most_bent < 3u);
}

BOOST_AUTO_TEST_CASE(what_is_no_segment_is_refused)
{
  const auto mesh = to_mesh<Surface>(hexagon());
  const Halfedge rim = mesh.halfedge(Vertex(2), Vertex(3));
  check_refused<FG::Invalid_curve_error>(mesh, 1, 3, {rim}, {0});                            // on the border
  check_refused<FG::Invalid_curve_error>(mesh, 1, 3, {spoke(mesh, 3)}, {0});                 // not opposite
  check_refused<FG::Invalid_curve_error>(mesh, 1, 3, {spoke(mesh, 2), spoke(mesh, 4)}, {1}); // a face is left out
  check_refused<FG::Invalid_curve_error>(mesh, 1, 5, {spoke(mesh, 2), Halfedge()}, {1});     // null
  check_refused<FG::Invalid_curve_error>(mesh, 1, 3, {spoke(mesh, 2), Halfedge(1000)}, {1}); // none of the mesh's
  check_refused<FG::Invalid_curve_error>(mesh, 1, 5, {spoke(mesh, 2), spoke(mesh, 3)}, {5}); // ends elsewhere
  check_refused<FG::Invalid_curve_error>(mesh, 1, 4, {}, {1, 4});                            // no edge
  check_refused<FG::Invalid_curve_error>(mesh, 2, 2, {}, {2});                               // a point
  check_refused<FG::Vertex_out_of_range_error>(mesh, 1, 1000, {spoke(mesh, 2)}, {});
  BOOST_TEST(FG::certify_segment(mesh, Vertex(1), Vertex(2), std::vector<Halfedge>()).is_straight());
}
