// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_GEODESIC_TREE_TREES_H
#define FLIP_GEODESICS_TEST_GEODESIC_TREE_TREES_H

#include "Curve_setting.h"
#include "Double_triangulation.h"
#include "closed_forms.h"
#include "descriptors.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <vector>

// Trees, and what must hold of any.
namespace tree_test {

namespace FG = CGAL::Flip_geodesics;
using FG::Halfedge_index;
using FG::Index;
using FG::Vertex_index;
using FG::internal::twin_index;
using namespace Flip_geodesics_test;

using Certified_setting = Basic_curve_setting<
    FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>>;

constexpr double tolerance = 1e-10;

inline bool is_close(double a, double b, double scale = 1) { return std::abs(a - b) <= tolerance * scale; }

template <class Setting>
struct Tree_setting : Setting
{
  using Tree = FG::Geodesic_tree<typename Setting::Triangulation>;

  explicit Tree_setting(const Mesh_soup& soup)
    : Setting(soup)
    , tree(this->triangulation)
  {
  }

  Index size() const { return this->triangulation.number_of_vertices(); }
  auto vertices() const { return FG::internal::descriptors<Vertex_index>(size()); }

  Tree tree;
};

using Double_tree_setting = Tree_setting<Curve_setting>;

// What must hold of any tree: the invariant, a locally shortest path to every vertex, and no crossing among them, which
// putting them all into one network shows.
template <class Setting>
void check_tree(Setting& setting, const FG::Geodesic_tree_report& report)
{
  BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
  BOOST_TEST(report.smallest_angle >= FG::Straightness::straight_angle());
  BOOST_TEST(setting.tree.is_valid());
  BOOST_TEST(setting.triangulation.is_valid());
  for(Vertex_index v : setting.vertices()) {
    const std::vector<Halfedge_index> path = setting.tree.path(v);
    if(path.empty())
      continue;
    BOOST_TEST(setting.triangulation.tail(path.front()) == setting.tree.source());
    BOOST_TEST(setting.triangulation.head(path.back()) == v);
    const FG::Curve_index curve = setting.network.add_curve(path);
    BOOST_TEST(is_close(setting.network.length(curve), setting.tree.distance(v), setting.tree.distance(v)));
  }
  const auto pulled = setting.pull();
  BOOST_TEST(pulled.flip_outs == 0u);
  BOOST_TEST(pulled.is_complete());
  setting.network.clear();
}

// The angle from the ray of direction 0 to a point of the plane, in [0, 2 pi).
inline double plane_angle(double x, double y)
{
  const double angle = std::atan2(y, x);
  return angle < 0 ? angle + 2 * pi : angle;
}

// Angles that differ by a full turn are the same.
inline bool is_same_angle(double a, double b, double total)
{
  const double difference = std::remainder(a - b, total);
  return std::abs(difference) <= 1e-9;
}

// The edge from one vertex to another, before it is flipped.
inline FG::Input_halfedge_index direction(const Double_tree_setting& setting, Vertex_index from, Vertex_index to)
{
  return FG::internal::as_input(FG::halfedges_through(setting.triangulation, Vertex_sequence{from, to}).front());
}

struct Impatient : FG::Default_shortening_visitor
{
  int steps = 0, flips = 0;
  template <class Triangulation>
  void on_flip(const Triangulation&, Halfedge_index)
  {
    ++flips;
  }
  bool go_further() { return ++steps <= 100; }
};

} // namespace tree_test

#endif // FLIP_GEODESICS_TEST_GEODESIC_TREE_TREES_H
