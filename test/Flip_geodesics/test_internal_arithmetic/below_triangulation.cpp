// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What unfolds rows of faces asks for a mesh, its metric and points on it, and for no triangulation: it gives the same
// over a `Metric_surface`, which has nothing else.

#include "generated_meshes.h"
#include "test_internal_arithmetic/numbers.h"

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Edge_sequences_of_places.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Input_faces.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

using namespace Flip_geodesics_test;

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Surface_of_mesh = FI::Surface_by_name<Mesh, CGAL::parameters::Default_named_parameters>;

/* The words that cross two edges in a row, the second one on the right. */
template <class Input_mesh>
std::vector<FG::Edge_sequence> words_across(const Input_mesh& input)
{
  std::vector<FG::Edge_sequence> result;
  for(FG::Input_halfedge_index h : FI::descriptors<FG::Input_halfedge_index>(input.number_of_halfedges())) {
    const FG::Input_halfedge_index t = FI::twin_index(h);
    if(input.is_border(h) || input.is_border(t) || input.is_border(FI::twin_index(input.next(t))))
      continue;
    FG::Edge_sequence word;
    word.crossed = {h, input.next(t)};
    word.tail = input.tail(input.next(input.next(h)));
    const FG::Input_halfedge_index last = FI::twin_index(input.next(t));
    word.head = input.tail(input.next(input.next(last)));
    result.push_back(word);
  }
  return result;
}

/* Numbers that depend on all that is computed from the words. */
template <class Places>
std::vector<double> unfolded(const Places& places)
{
  std::vector<double> result;
  FG::Decision_statistics statistics;
  const FI::Straight_strip<Places> is_straight(places, statistics);
  FI::Sleeve<Places> sleeve(places, FI::Refused_faces::UNUSABLE);
  for(const FG::Edge_sequence& word : words_across(places.input())) {
    const FI::Strip<Places> strip(places, word);
    const FI::Portal_turn turn = FI::largest_turn(places, strip);
    result.insert(result.end(), {strip.length(), strip.bend(), strip.crossing(1), turn.angle,
                                 FI::tail_angle(strip).angle, is_straight(word) ? 1.0 : 0.0});
    result.push_back(FI::unfolded_edge(places, word).length);
    const FI::Unfolding_chains<Places> unfolding(places);
    result.push_back(FI::Exact_sign(statistics)({unfolding.portal(word, 0, true), unfolding.head(word, true)}));
    FG::Edge_sequence along;
    along.along = strip.reference();
    along.tail = word.tail;
    along.head = places.input().tail(FI::twin_index(along.along));
    const FI::Wedge_edge_sequences wedge = {word, along, 0};
    result.push_back(FI::wedge_rotation(places, wedge).angle.value);
    result.push_back(FI::umbrella_of(places, along.along).total());
    sleeve.edges().assign(word.crossed.begin(), word.crossed.end());
    sleeve.unfold(word.tail, word.head);
    result.push_back(static_cast<double>(sleeve.portals().size()));
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(strips_ask_for_the_input_of_a_triangulation_alone)
{
  for(const Mesh_soup& soup : {bumpy_sphere(4, 0.3, 1), flat_grid(4, 4, Diagonal_rule::RISING)}) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    const Surface_of_mesh surface = FI::make_surface(mesh, CGAL::parameters::default_values());
    const FI::Places_on_input<Surface_of_mesh> places(surface);
    const FG::Intrinsic_triangulation<Mesh> triangulation(mesh);
    const std::vector<double> result = unfolded(places);
    BOOST_TEST(!result.empty());
    BOOST_TEST(result == unfolded(triangulation));
  }
}

// In a plane they are known; only the ratio of the weights matters.
BOOST_AUTO_TEST_CASE(distances_of_points_from_edges_are_those_in_the_plane)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const FG::Intrinsic_triangulation<Mesh> triangulation(mesh);
  FG::Decision_statistics statistics;
  const FI::Point_side<FG::Intrinsic_triangulation<Mesh>> side(triangulation, statistics);
  const auto& input = triangulation.input();
  const auto place = [&](FG::Vertex_index v) {
    const auto& p = mesh.point(input.vertex(v));
    return std::complex<double>(p.x(), p.y());
  };
  for(const FG::Edge_sequence& word : words_across(input))
    for(std::size_t gap = 0; gap <= word.crossed.size(); ++gap) {
      const FG::Input_halfedge_index h = FI::face_of_gap(word, gap), hn = input.next(h);
      const FG::Surface_location point = {h, {{3, 1, 4}}}, same = {h, {{6, 2, 8}}};
      const std::complex<double> along = place(word.head) - place(word.tail),
                                 p = (3.0 * place(input.tail(h)) + place(input.tail(hn)) +
                                      4.0 * place(input.tail(input.next(hn)))) /
                                     8.0;
      const double expected = std::imag(std::conj(along) * (p - place(word.tail))) / std::abs(along);
      BOOST_TEST(std::abs(side.distance(word, gap, point) - expected) < 1e-13);
      BOOST_TEST(side.distance(word, gap, same) == side.distance(word, gap, point));
    }
}
