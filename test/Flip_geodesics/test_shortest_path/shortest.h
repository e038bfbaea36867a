// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_SHORTEST_PATH_SHORTEST_H
#define FLIP_GEODESICS_TEST_SHORTEST_PATH_SHORTEST_H

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

// Shortest paths, each checked by itself.
namespace shortest_path_test {

namespace FG = CGAL::Flip_geodesics;
using FG::Edge_index;
using FG::Vertex_index;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

constexpr double tolerance = 1e-9;

using Setting = Curve_setting;
using Tree = FG::Geodesic_tree<Setting::Triangulation>;
using Distances = FG::internal::Indexed_by<Vertex_index, std::vector<double>>;

inline FG::Shortest_path_report shortest(Setting& setting, Vertex_index s, Vertex_index t,
                                         const FG::Window_limit& limit = FG::Window_limit())
{
  Setting::Search search(setting.triangulation);
  const auto report = FG::add_shortest_path(setting.network, search, s, t, CGAL::parameters::search_limit(limit));
  BOOST_TEST(setting.triangulation.is_valid());
  BOOST_TEST(setting.network.is_valid());
  BOOST_TEST(setting.triangulation.tail(setting.network.halfedges(0_c).front()) == s);
  BOOST_TEST(setting.triangulation.head(setting.network.halfedges(0_c).back()) == t);
  BOOST_TEST(std::abs(setting.network.length(0_c) - report.length) <= tolerance * report.length);
  BOOST_TEST(report.length <= report.first_length * (1 + tolerance));
  BOOST_TEST(FG::to_string(report.shortening.curves[0].status) == "LOCALLY_SHORTEST");
  setting.network.clear();
  setting.triangulation.rollback();
  return report;
}

// Paths and trees against the distance in closed form.
template <class Distance>
void check_against(const char* name, const Mesh_soup& soup, const Distance& distance)
{
  BOOST_TEST_CONTEXT(name)
  {
    Setting setting(soup);
    Random_numbers random(7);
    const int n = static_cast<int>(soup.points.size());
    int improved = 0;
    for(int i = 0; i < 60; ++i) {
      const int s = random.below(n), t = (s + 1 + random.below(n - 1)) % n;
      const auto report = shortest(setting, Vertex_index(s), Vertex_index(t));
      BOOST_TEST(report.is_confirmed(), s << " to " << t);
      BOOST_TEST(std::abs(report.length - distance(s, t)) <= tolerance * distance(s, t), s << " to " << t);
      BOOST_TEST(report.gap() <= tolerance * report.length);
      improved += report.length < report.first_length * (1 - tolerance) ? 1 : 0;
    }
    BOOST_TEST_MESSAGE(name << ": " << improved << " of 60 paths improved");

    for(Vertex_index source : {0_v, Vertex_index(n / 2), Vertex_index(n - 1)}) {
      Tree tree(setting.triangulation);
      tree.grow(source);
      const FG::Distances_report report = FG::make_shortest(tree);
      BOOST_TEST(report.is_confirmed());
      BOOST_TEST(report.longer == 0u);
      BOOST_TEST(report.largest_excess <= tolerance);
      BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
      BOOST_TEST(report.vertices == static_cast<std::size_t>(n - 1));
      BOOST_TEST(tree.is_valid(tolerance));
      BOOST_TEST(setting.triangulation.is_valid());
      for(Vertex_index v : descriptors<Vertex_index>(n)) {
        const double expected = distance(source.idx(), v.idx());
        BOOST_TEST(std::abs(tree.distance(v) - expected) <= tolerance * (1 + expected), source.idx()
                                                                                            << " to " << v.idx());
      }
      for(Vertex_index v : descriptors<Vertex_index>(n))
        if(v != source)
          setting.network.add_curve(tree.path(v));
      BOOST_TEST(setting.pull().flip_outs == 0u);
      setting.network.clear();
      setting.triangulation.rollback();
    }
  }
}

} // namespace shortest_path_test

#endif // FLIP_GEODESICS_TEST_SHORTEST_PATH_SHORTEST_H
