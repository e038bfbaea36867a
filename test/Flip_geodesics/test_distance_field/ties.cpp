// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Places that several sources are equally far from.

#include "test_distance_field/asked_surface.h"

using namespace Flip_geodesics_test;

// Where rounding decides, the source that is named is the one at which the path ends.
BOOST_AUTO_TEST_CASE(a_path_ends_at_the_source_that_is_named)
{
  std::mt19937 random(7);
  int ties = 0;
  const std::vector<Mesh_soup> symmetric = {cube(4), flat_grid(14, 14, Diagonal_rule::RANDOM), cylinder(12, 6, 1, 2),
                                            torus(20, 12, 2, 1), saddle_disk(6, 4, 3 * pi)};
  for(const Mesh_soup& soup : symmetric) {
    const Asked_surface s(soup);
    for(int round = 0; round < 40; ++round) {
      Field field(s.triangulation, s.mesh);
      std::vector<Field> alone;
      std::vector<Vertex_index> sources;
      for(int i = 0; i < 3; ++i) {
        const FG::Index v = static_cast<FG::Index>(random() % 10000) % s.triangulation.number_of_vertices();
        sources.push_back(Vertex_index(v));
        field.add_source(sources.back());
        alone.emplace_back(s.triangulation, s.mesh);
        alone.back().add_source(sources.back());
        alone.back().compute();
      }
      field.compute();
      for(int i = 0; i < s.triangulation.number_of_vertices() + 50; ++i) {
        const Location at = i < s.triangulation.number_of_vertices() ? s.vertex(i) : s.random_location(random);
        const auto answer = field.answer(at);
        const double next =
            (std::min)({alone[(answer.source + 1) % 3].distance(at), alone[(answer.source + 2) % 3].distance(at)});
        ties += next <= answer.distance * (1 + 1e-13) ? 1 : 0;
        std::vector<Point> path;
        field.path(at, std::back_inserter(path));
        BOOST_TEST(distance_in_space(path.back(), s.at(s.vertex(sources[answer.source].idx()))) == 0);
      }
    }
  }
  BOOST_TEST(ties > 1000);
}
