// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Shortening with traits that lie: it ends, and leaves valid curves.

#ifndef FLIP_GEODESICS_TEST_HOSTILE_TRAITS_CHECKED_SHORTENING_H
#define FLIP_GEODESICS_TEST_HOSTILE_TRAITS_CHECKED_SHORTENING_H

#include "Curve_setting.h"
#include "Hostile_traits.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/straightened_path.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <stdexcept>
#include <vector>

/*
 * What holds whatever the traits say: no step makes a curve longer, what is not taken leaves no trace, words are right,
 * and everything ends.
 */

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;
using FG::Curve_index;
using FG::Edge_index;
using FG::Halfedge_index;
using FG::Index;
using FG::Segment_index;
using FG::Vertex_index;
using FG::internal::descriptors;
using FG::internal::first_side;

using Triangulation = FG::Intrinsic_triangulation<Surface, Hostile_traits>;
using Setting = Basic_curve_setting<Triangulation>;

// Flips in the log, not faces laid out afresh.
template <class T>
std::size_t logged_flips(const T& triangulation)
{
  std::size_t result = 0;
  for(std::size_t i = 0; i < triangulation.log_position(); ++i)
    result += triangulation.flip_record(i).hp != FG::null_index ? 1 : 0;
  return result;
}

// Follows a shortening: steps shorten, and the log holds the flips of the steps that were taken.
struct Watcher
{
  explicit Watcher(const Setting& setting)
    : length(setting.network.length(0_c))
    , flips_of_steps(logged_flips(setting.triangulation))
  {
  }

  template <class T>
  void on_flip(const T&, Halfedge_index)
  {
    ++flips_of_step;
  }

  template <class Network>
  void after_flip_out(const Network& network, Curve_index curve)
  {
    ++steps;
    const std::size_t flips_before = flips_of_steps;
    const double now = network.length(curve);
    has_grown = has_grown || now > length * (1 + 1e-12);
    length = now;
    flips_of_steps = logged_flips(network.triangulation());
    partial_steps += flips_before + flips_of_step > flips_of_steps ? 1 : 0;
  }

  bool go_further()
  {
    flips_of_step = 0;
    return steps < 100000;
  }

  double length;
  std::size_t flips_of_step = 0, flips_of_steps = 0, steps = 0;
  std::size_t partial_steps = 0; // of whose flips some were taken back
  bool has_grown = false;
};

// Pulls tight among lies. Returns the number of flips that were taken back.
inline std::size_t check_shortening(Setting& setting, Watcher& watcher)
{
  const double before = setting.network.length(0_c);
  const std::size_t flips_before = watcher.flips_of_steps;
  FG::Shortener<Setting::Network> shortener(setting.network);
  shortener.run(FG::Never_stop_predicate(), watcher);
  BOOST_TEST(!watcher.has_grown);
  BOOST_TEST(watcher.steps < 100000u);
  BOOST_TEST(setting.network.is_valid());
  BOOST_TEST(setting.triangulation.is_valid(1e-6));
  BOOST_TEST(setting.network.length(0_c) <= before * (1 + 1e-12));
  BOOST_TEST(std::abs(shortener.length() - setting.network.length(0_c)) <= 1e-12 * before);
  BOOST_TEST(std::abs(shortener.length(0_c) - setting.network.length(0_c)) <= 1e-12 * before);
  BOOST_TEST(logged_flips(setting.triangulation) == watcher.flips_of_steps); // the others have left no trace
  setting.network.for_each_segment(0_c, [&](Segment_index s) {
    BOOST_CHECK_NO_THROW(setting.triangulation.edge_sequence(setting.network.halfedge(s)));
  });
  return shortener.number_of_flips() + flips_before - watcher.flips_of_steps;
}

inline std::size_t check_shortening(Setting& setting)
{
  Watcher watcher(setting);
  return check_shortening(setting, watcher);
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_HOSTILE_TRAITS_CHECKED_SHORTENING_H
