// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Isolines and Voronoi boundaries are stopped at each call of a visitor in turn. Nothing is written then.

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "test_interruption/stopping.h"

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/isolines.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using Setting = Curve_setting;
using Triangulation = Setting::Triangulation;
using Mesh = Triangulation::Triangle_mesh;
using Field = FG::Geodesic_distance_field<Triangulation>;

// Counts how often it is evaluated.
struct Counting_field
{
  const Field& field;
  std::size_t& calls;

  template <class Face, class Weights>
  auto operator()(Face f, const Weights& weights) const
  {
    ++calls;
    return field(f, weights);
  }
};

// `compute(field, out, np)` writes curves of a field.
template <class Curve, class Compute>
void stop_curves(const Compute& compute)
{
  const Setting setting(bumpy_sphere(6, 0.2, 3));
  Field field(setting.triangulation, setting.mesh);
  field.add_source(3_v);
  field.add_source(40_v);
  field.compute();
  std::size_t all_evaluations = 0;
  std::vector<Curve> expected;
  compute(setting.mesh, Counting_field{field, all_evaluations}, expected, CGAL::parameters::default_values());
  BOOST_TEST(!expected.empty());
  BOOST_TEST(all_evaluations > 4 * most_between_calls);
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    std::size_t evaluations = 0;
    std::vector<Curve> curves;
    compute(setting.mesh, Counting_field{field, evaluations}, curves, CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(curves.size() == (is_stopped ? 0 : expected.size()));
    for(std::size_t i = 0; i < curves.size(); ++i)
      BOOST_TEST((curves[i].points == expected[i].points));
    BOOST_TEST(evaluations <= (is_stopped ? most_between_calls * visitor.calls : all_evaluations));
  });
  BOOST_TEST(calls > all_evaluations / most_between_calls);
}

} // namespace

BOOST_AUTO_TEST_CASE(isolines)
{
  stop_curves<FG::Isoline<Mesh>>([](const Mesh& mesh, const Counting_field& field, auto& curves, const auto& np) {
    FG::isolines(mesh, field, std::vector<double>{0.2, 0.4, 0.6}, std::back_inserter(curves), 0.01, np);
  });
}

BOOST_AUTO_TEST_CASE(voronoi_boundaries)
{
  stop_curves<FG::Voronoi_boundary<Mesh>>(
      [](const Mesh& mesh, const Counting_field& field, auto& curves, const auto& np) {
        FG::voronoi_boundaries(mesh, field, std::back_inserter(curves), 0.01, np);
      });
}
