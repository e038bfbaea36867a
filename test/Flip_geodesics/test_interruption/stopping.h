// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_INTERRUPTION_STOPPING_H
#define FLIP_GEODESICS_TEST_INTERRUPTION_STOPPING_H

#include "Curve_setting.h"

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <limits>
#include <thread>

namespace {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using FG::Vertex_index;
using FG::internal::descriptors;

using Setting = Curve_setting;
using Triangulation = Setting::Triangulation;
using Mesh = Triangulation::Triangle_mesh;

// A search takes so many steps at most from one call of a visitor to the next.
constexpr std::size_t most_between_calls = 1024;

struct Stopping_visitor : CGAL::Flip_geodesics::Default_shortening_visitor
{
  std::size_t calls = 0, most = std::numeric_limits<std::size_t>::max();
  bool is_called_from_elsewhere = false;
  std::thread::id thread = std::this_thread::get_id();

  bool go_further()
  {
    is_called_from_elsewhere = is_called_from_elsewhere || std::this_thread::get_id() != thread;
    return ++calls <= most;
  }
};

// Calls `compute(visitor, is_stopped)` with a visitor that never stops, and with one for each of its calls that stops
// there: once it has, it is not called again. Returns how many calls there are.
template <class Compute>
std::size_t stop_at_each_call(const Compute& compute)
{
  Stopping_visitor patient;
  compute(patient, false);
  BOOST_TEST(!patient.is_called_from_elsewhere);
  for(std::size_t most = 0; most < patient.calls; ++most) {
    Stopping_visitor visitor;
    visitor.most = most;
    compute(visitor, true);
    BOOST_TEST(visitor.calls == most + 1);
    BOOST_TEST(!visitor.is_called_from_elsewhere);
  }
  return patient.calls;
}

} // namespace

#endif // FLIP_GEODESICS_TEST_INTERRUPTION_STOPPING_H
