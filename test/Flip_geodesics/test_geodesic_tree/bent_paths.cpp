// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Paths that are no geodesics: what is measured of a tree of edges as they are.

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/internal/shortest/geodesic_tree_parts.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

// A tree with one path, along the edges between vertices in a row.
struct Tree_of_one_path
{
  using Triangulation = Curve_setting::Triangulation;

  Tree_of_one_path(Triangulation& t, const std::vector<FG::Vertex_index>& path)
    : m_triangulation(t)
    , m_source(path.front())
    , m_incoming(static_cast<std::size_t>(t.number_of_vertices()))
  {
    for(FG::Halfedge_index h : FG::internal::descriptors<FG::Halfedge_index>(t.number_of_halfedges()))
      for(std::size_t i = 0; i + 1 < path.size(); ++i)
        if(t.tail(h) == path[i] && t.head(h) == path[i + 1])
          m_incoming[path[i + 1]] = h;
  }

  Triangulation& triangulation() const { return m_triangulation; }
  FG::Vertex_index source() const { return m_source; }
  FG::Halfedge_index incoming(FG::Vertex_index v) const { return m_incoming[v]; }

private:
  Triangulation& m_triangulation;
  FG::Vertex_index m_source;
  FG::internal::Indexed_by<FG::Vertex_index, std::vector<FG::Halfedge_index>> m_incoming;
};

} // namespace

BOOST_AUTO_TEST_CASE(paths_are_bent_where_their_angles_are_below_pi)
{
  using Straightness = FG::internal::Tree_straightness<Tree_of_one_path>;
  Curve_setting setting(flat_grid(4, 4, Diagonal_rule::RISING));
  const auto at = [](int i, int j) { return FG::Vertex_index(grid_vertex(4, i, j)); };
  struct Case
  {
    std::vector<FG::Vertex_index> path;
    double angle;
    std::vector<FG::Vertex_index> bent; // the ends of the edges after the bends
  };
  const double infinity = std::numeric_limits<double>::infinity();
  for(const Case& c : {Case{{at(1, 1), at(2, 1)}, infinity, {}}, Case{{at(1, 1), at(2, 1), at(3, 1)}, pi, {}},
                       Case{{at(1, 1), at(2, 1), at(3, 1), at(3, 2)}, pi / 2, {at(3, 2)}},
                       Case{{at(1, 0), at(2, 0), at(3, 1), at(3, 0)}, pi / 4, {at(3, 1), at(3, 0)}},
                       Case{{at(0, 1), at(1, 2), at(2, 2), at(3, 3)}, 3 * pi / 4, {at(2, 2), at(3, 3)}}})
  {
    const Tree_of_one_path tree(setting.triangulation, c.path);
    FG::internal::Measured_legs measured(static_cast<std::size_t>(setting.triangulation.number_of_vertices()));
    std::vector<FG::Vertex_index> bent;
    const double angle = Straightness(tree, measured)(std::back_inserter(bent));
    BOOST_TEST((angle == c.angle || std::abs(angle - c.angle) < 1e-15));
    std::vector<FG::Vertex_index> expected = c.bent;
    std::sort(expected.begin(), expected.end());
    std::sort(bent.begin(), bent.end());
    BOOST_TEST((bent == expected));
  }
}

// Whichever side of the path the smaller angle is on.
BOOST_AUTO_TEST_CASE(paths_are_bent_at_inserted_vertices)
{
  const Mesh_soup soup = flat_grid(2, 2, Diagonal_rule::RISING);
  Curve_setting setting(soup);
  auto& t = setting.triangulation;
  FG::Input_halfedge_index h(0);
  while(t.input().is_border(h))
    ++h;
  std::vector<FG::Vertex_index> corners;
  Coordinates middle = {0, 0, 0};
  for(int i = 0; i < 3; ++i, h = t.input().next(h)) {
    corners.push_back(t.input().tail(h));
    for(int k = 0; k < 3; ++k)
      middle[k] += soup.points[corners.back().idx()][k] / 3;
  }
  const auto direction = [&](FG::Vertex_index v) {
    const Coordinates& p = soup.points[v.idx()];
    return std::atan2(p[1] - middle[1], p[0] - middle[0]);
  };
  const FG::Vertex_index inserted = t.insert({h, {{1, 1, 1}}});
  for(FG::Vertex_index from : corners)
    for(FG::Vertex_index to : corners) {
      if(from == to)
        continue;
      const Tree_of_one_path tree(t, {from, inserted, to});
      FG::internal::Measured_legs measured(static_cast<std::size_t>(t.number_of_vertices()));
      std::vector<FG::Vertex_index> bent;
      const double angle = FG::internal::Tree_straightness<Tree_of_one_path>(tree, measured)(std::back_inserter(bent));
      BOOST_TEST(std::abs(angle - std::abs(std::remainder(direction(to) - direction(from), 2 * pi))) < 1e-12);
      BOOST_TEST((bent == std::vector<FG::Vertex_index>{to}));
    }
}
