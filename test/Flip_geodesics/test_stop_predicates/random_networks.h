// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Random networks, what holds of each after it was shortened, and a visitor that counts.

#ifndef FLIP_GEODESICS_TEST_STOP_PREDICATES_RANDOM_NETWORKS_H
#define FLIP_GEODESICS_TEST_STOP_PREDICATES_RANDOM_NETWORKS_H

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;
using FG::Curve_index;
using FG::Shortening_status;
using FG::Vertex_index;
using FG::internal::descriptors;

// Sums of lengths in another order.
constexpr double rounding = 1e-13;

using Setting_ptr = std::unique_ptr<Curve_setting>;

// Random networks: long paths, loops that contract, loops that do not, on a Delta-complex.
template <class Function>
void for_random_networks(int number, unsigned seed, const Function& function)
{
  const std::vector<Mesh_soup> soups = {shaken(torus(6, 5, 3, 1), 0.2, 1), bumpy_sphere(4, 0.3, 2), genus_3_plate(1),
                                        jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 3)};
  Random_numbers random(seed);
  for(const Mesh_soup& soup : soups) {
    Curve_setting setting(soup);
    for(int i = 0; i < number * scale; ++i) {
      flip_at_random(setting.triangulation, random.below(40), random);
      for(int k = 0; k < 6; ++k) {
        const Halfedge_sequence walk = random_walk(setting.triangulation, 12, random.below(2) == 0, random);
        if(walk.empty())
          continue;
        const bool is_closed = setting.triangulation.head(walk.back()) == setting.triangulation.tail(walk.front());
        setting.network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
        if(!setting.network.is_valid()) {
          setting.network.clear(); // the first few are as good
          continue;
        }
      }
      if(setting.network.number_of_curves() > 0)
        function(setting, random);
      setting.network.clear();
      setting.triangulation.rollback();
    }
  }
}

inline double total(const FG::Shortening_report& report, double FG::Curve_report::*value)
{
  double sum = 0;
  for(const FG::Curve_report& curve : report.curves)
    sum += curve.*value;
  return sum;
}

inline void check_consistency(const Curve_setting& setting, const FG::Shortening_report& report)
{
  BOOST_TEST(report.curves.size() == static_cast<std::size_t>(setting.network.number_of_curves()));
  bool is_complete = true;
  for(Curve_index c : descriptors<Curve_index>(setting.network.number_of_curves())) {
    const FG::Curve_report& curve = report.curves[c.idx()];
    BOOST_TEST(curve.initial_length == setting.network.initial_length(c));
    BOOST_TEST(curve.length == setting.network.length(c));
    BOOST_TEST(curve.length <= curve.initial_length * (1 + rounding));
    const bool is_contracted = curve.status == Shortening_status::CONTRACTED;
    BOOST_TEST(is_contracted == setting.network.is_contracted(c));
    BOOST_TEST((!is_contracted || (curve.length == 0 && std::isinf(curve.smallest_angle))));
    BOOST_TEST((curve.status != Shortening_status::LOCALLY_SHORTEST || curve.smallest_angle > pi - 1e-8));
    is_complete = is_complete && (is_contracted || curve.status == Shortening_status::LOCALLY_SHORTEST);
  }
  BOOST_TEST(report.is_complete() == is_complete);
  BOOST_TEST(setting.network.is_valid());
  BOOST_TEST(setting.triangulation.is_valid());
}

inline int count(const FG::Shortening_report& report, Shortening_status status)
{
  int result = 0;
  for(const FG::Curve_report& curve : report.curves)
    result += curve.status == status ? 1 : 0;
  return result;
}

inline void print(const char* title, const std::map<std::string, int>& statuses)
{
  std::cout << title << ':';
  for(const auto& [status, number] : statuses)
    std::cout << ' ' << status << ' ' << number;
  std::cout << '\n';
}

struct Counting_visitor : FG::Default_shortening_visitor
{
  template <class Triangulation>
  void on_flip(const Triangulation& triangulation, FG::Halfedge_index h)
  {
    ++flips;
    BOOST_TEST(triangulation.holds(triangulation.edge(h)) == 0);
  }

  template <class Network>
  void after_flip_out(const Network& network, Curve_index curve)
  {
    ++steps;
    BOOST_TEST(network.is_valid());
    BOOST_TEST(curve.idx() < network.number_of_curves());
  }

  bool go_further()
  {
    ++questions;
    return steps < limit;
  }

  std::size_t limit = static_cast<std::size_t>(-1), flips = 0, steps = 0, questions = 0;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_STOP_PREDICATES_RANDOM_NETWORKS_H
