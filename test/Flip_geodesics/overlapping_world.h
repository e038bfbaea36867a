// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_OVERLAPPING_WORLD_H
#define FLIP_GEODESICS_TEST_OVERLAPPING_WORLD_H

#include "generated_curves.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/network_builders.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <vector>

namespace Flip_geodesics_test {

using CGAL::Flip_geodesics::Index;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = CGAL::Flip_geodesics::Intrinsic_triangulation<Mesh>;
using Network = CGAL::Flip_geodesics::Edge_path_network<Triangulation>;
using Indices = std::vector<Index>;

/// A mesh with curves, whose order on common edges is then looked for.
struct Overlapping_world
{
  explicit Overlapping_world(const Mesh_soup& soup)
    : mesh(to_mesh<Mesh>(soup))
    , triangulation(mesh)
    , network(triangulation)
  {
  }

  Index add(const Indices& vertices, bool is_closed = false)
  {
    return network.add_curve(CGAL::Flip_geodesics::halfedges_through(triangulation, vertices, is_closed), is_closed);
  }

  void order()
  {
    CGAL::Flip_geodesics::order_overlapping_curves(network);
    BOOST_TEST(network.is_valid());
  }

  /// The segments on the edge from v to w, from left to right as seen that way.
  Indices stack(Index v, Index w) const
  {
    const Index h = CGAL::Flip_geodesics::internal::halfedge_between(triangulation, v, w);
    Indices result = network.stack(Triangulation::edge(h));
    if((h & 1) != 0)
      std::reverse(result.begin(), result.end());
    return result;
  }

  /// The curves of these segments.
  Indices curves(Index v, Index w) const
  {
    Indices result = stack(v, w);
    for(Index& s : result)
      s = network.curve(s);
    return result;
  }

  Mesh mesh;
  Triangulation triangulation;
  Network network;
};

/// `turns` times around ring `k` of a cylinder of n columns, from column 0 on.
inline Indices ring_path(int n, int k, int turns, int more = 0)
{
  Indices result;
  for(int i = 0; i < turns * n + more; ++i)
    result.push_back(i % n + n * k);
  return result;
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_OVERLAPPING_WORLD_H
