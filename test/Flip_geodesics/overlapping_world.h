// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_OVERLAPPING_WORLD_H
#define FLIP_GEODESICS_TEST_OVERLAPPING_WORLD_H

#include "Double_triangulation.h"
#include "generated_curves.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <vector>

namespace Flip_geodesics_test {

using CGAL::Flip_geodesics::Curve_index;
using CGAL::Flip_geodesics::Halfedge_index;
using CGAL::Flip_geodesics::Index;
using CGAL::Flip_geodesics::Segment_index;
using CGAL::Flip_geodesics::Vertex_index;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = Double_triangulation<Mesh>;
using Network = CGAL::Flip_geodesics::Edge_path_network<Triangulation>;
using Curve_list = std::vector<Curve_index>;
using Segment_list = std::vector<Segment_index>;

/// A mesh with curves, whose order on common edges is then looked for.
struct Overlapping_world
{
  explicit Overlapping_world(const Mesh_soup& soup)
    : mesh(to_mesh<Mesh>(soup))
    , triangulation(mesh)
    , network(triangulation)
  {
  }

  Curve_index add(const Vertex_sequence& vertices, bool is_closed = false)
  {
    return network.add_curve(
        CGAL::Flip_geodesics::halfedges_through(triangulation, vertices, CGAL::parameters::is_closed(is_closed)),
        CGAL::parameters::is_closed(is_closed));
  }

  void order()
  {
    CGAL::Flip_geodesics::order_overlapping_curves(network);
    BOOST_TEST(network.is_valid());
  }

  /// The segments on the edge from v to w, from left to right as seen that way.
  Segment_list bundle(Vertex_index v, Vertex_index w) const
  {
    const Halfedge_index h = CGAL::Flip_geodesics::internal::halfedge_between(triangulation, v, w);
    Segment_list result = network.bundle(Triangulation::edge(h));
    if(!CGAL::Flip_geodesics::internal::is_first_side(h))
      std::reverse(result.begin(), result.end());
    return result;
  }

  /// The curves of these segments.
  Curve_list curves(Vertex_index v, Vertex_index w) const
  {
    Curve_list result;
    for(Segment_index s : bundle(v, w))
      result.push_back(network.curve(s));
    return result;
  }

  Mesh mesh;
  Triangulation triangulation;
  Network network;
};

/// `turns` times around ring `k` of a cylinder of n columns, from column 0 on.
inline Vertex_sequence ring_path(int n, int k, int turns, int more = 0)
{
  Vertex_sequence result;
  for(int i = 0; i < turns * n + more; ++i)
    result.emplace_back(i % n + n * k);
  return result;
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_OVERLAPPING_WORLD_H
