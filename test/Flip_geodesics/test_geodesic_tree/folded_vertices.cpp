// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Trees where degenerate faces fold vertices onto one point.

#include "flat_tori.h"
#include "trees.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/internal/shortest/geodesic_tree_parts.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace tree_test;

namespace {

using Plain = FG::Intrinsic_triangulation_traits<Length_metric::Kernel>;
using Certified = FG::Certified_intrinsic_triangulation_traits<Length_metric::Kernel>;

template <class Traits>
using Triangulation_by_lengths = FG::Intrinsic_triangulation<Surface, Traits, Length_metric>;

// Calls visit(triangulation) for small tori, as they are or contracted.
template <class Traits, class Visit>
void for_each_torus(FG::Zero_length_edges zero_length_edges, const Visit& visit)
{
  for(const std::vector<double>& choice : {std::vector<double>{1, 1 + 1e-7, 2}, std::vector<double>{1, 2, 3}})
    for(unsigned seed = 0; seed < 48; ++seed) {
      const auto mesh =
          to_mesh<Surface>(torus(3 + static_cast<int>(seed % 4), 3 + static_cast<int>(seed / 4 % 4), 3, 1));
      auto lengths = lengths_with_flat_faces(mesh, choice, seed);
      const Length_metric metric(mesh, Length_map(lengths));
      Triangulation_by_lengths<Traits> triangulation(mesh, metric, Traits(), zero_length_edges);
      visit(triangulation);
    }
}

template <class Triangulation>
bool has_finite_lengths(const Triangulation& triangulation)
{
  for(FG::Halfedge_index h : FG::internal::descriptors<FG::Halfedge_index>(triangulation.number_of_halfedges()))
    if(!std::isfinite(triangulation.length(h)))
      return false;
  return true;
}

// How many trees from the vertices of tori have which status; all are valid, now and once paths are replaced.
template <class Traits>
std::map<std::string, int> statuses(FG::Zero_length_edges zero_length_edges)
{
  std::map<std::string, int> result;
  for_each_torus<Traits>(zero_length_edges, [&](auto& triangulation) {
    for(Vertex_index source : {0_v, 2_v}) {
      if(triangulation.outgoing(source) == FG::null_index)
        continue; // is in the place of another one
      FG::Geodesic_tree<Triangulation_by_lengths<Traits>> tree(triangulation);
      ++result[FG::to_string(tree.grow(source).status)];
      BOOST_TEST(tree.is_valid());
      BOOST_TEST(tree.report().flip_outs < 1000u); // a joint is flipped out in vain once
      const FG::Distances_report report =
          FG::make_shortest(tree, CGAL::parameters::search_limit(FG::Window_limit(2000)));
      BOOST_TEST(tree.is_valid());
      BOOST_TEST((report.status == tree.report().status));
      BOOST_TEST(has_finite_lengths(triangulation));
      triangulation.rollback();
    }
  });
  return result;
}

} // namespace

// A wedge that leads past an edge between two vertices in one place cannot be flipped out. Its path stays as it is.
BOOST_AUTO_TEST_CASE(trees_among_folded_vertices)
{
  const auto certified = statuses<Certified>(FG::Zero_length_edges::REFUSE);
  BOOST_TEST(certified.size() == 2u);
  BOOST_TEST(certified.at("DEGENERATE_FACES") > 0);
  BOOST_TEST(certified.at("LOCALLY_SHORTEST") > 150);
  const auto rounded = statuses<Plain>(FG::Zero_length_edges::REFUSE);
  BOOST_TEST(rounded.size() == 2u);
  BOOST_TEST(rounded.at("PRECISION_LIMIT") > 0);
  BOOST_TEST(rounded.at("LOCALLY_SHORTEST") > 100);
}

BOOST_AUTO_TEST_CASE(trees_where_folded_vertices_are_contracted)
{
  BOOST_TEST(statuses<Certified>(FG::Zero_length_edges::CONTRACT).size() == 1u);
  BOOST_TEST(statuses<Plain>(FG::Zero_length_edges::CONTRACT).at("LOCALLY_SHORTEST") > 100);
}

// Joints where flips are of no use are known in either order, until their edges are replaced or a tree is grown anew.
BOOST_AUTO_TEST_CASE(hindered_joints_are_found_in_either_order_until_they_are_cleared)
{
  const Curve_setting setting(flat_grid(2, 2, Diagonal_rule::RISING));
  const Halfedge_index a(2), c(7), d(9);
  for(const bool is_reversed : {false, true}) {
    FG::internal::Hindered_joints joints;
    is_reversed ? joints.add(c, a) : joints.add(a, c);
    BOOST_TEST(joints.has(a, c));
    BOOST_TEST(joints.has(c, a));
    for(const Halfedge_index h : {a, c})
      BOOST_TEST((!joints.has(h, h) && !joints.has(h, d) && !joints.has(d, h)));
    joints.forget(setting.triangulation, d);
    BOOST_TEST(joints.has(a, c));
    joints.forget(setting.triangulation, is_reversed ? setting.triangulation.twin(a) : c);
    BOOST_TEST(!joints.has(a, c));
    joints.add(a, d);
    joints.clear();
    BOOST_TEST(!joints.has(a, d));
  }
}

// In doubles as well, a zero-length edge is not flipped, and the faces beside it are laid out as they are.
BOOST_AUTO_TEST_CASE(delaunay_among_folded_vertices)
{
  for_each_torus<Plain>(FG::Zero_length_edges::REFUSE, [](auto& triangulation) {
    for(Vertex_index source : {0_v, 2_v}) {
      FG::Geodesic_tree<Triangulation_by_lengths<Plain>>(triangulation).grow(source);
      const FG::Delaunay_report report =
          FG::flip_to_delaunay(triangulation, CGAL::parameters::number_of_iterations(5000));
      BOOST_TEST(report.flips < 5000u);
      BOOST_TEST(has_finite_lengths(triangulation));
    }
  });
}
