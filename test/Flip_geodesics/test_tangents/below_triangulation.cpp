// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What traces rays and carries tangent vectors asks nothing of a triangulation but its input and metric, and gives the
// same over a `Metric_surface`, which has nothing else.

#include "surfaces.h"

#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/geodesic_mean.h>
#include <CGAL/Flip_geodesics/internal/tangents/Logarithm_everywhere.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace tangents_test;

namespace {

void append(std::vector<double>& numbers, const FG::Surface_location& location)
{
  numbers.push_back(location.halfedge.idx());
  numbers.insert(numbers.end(), location.weights.begin(), location.weights.end());
}

// Numbers that depend on all that a ray from an inner point and one from a vertex meet.
template <class Surface>
std::vector<double> traced(const Surface& surface)
{
  std::vector<double> result;
  const FG::Geodesic_tracer<Surface> tracer(surface);
  for(const std::array<double, 3>& weights : {std::array<double, 3>{0.5, 0.25, 0.25}, std::array<double, 3>{1, 0, 0}}) {
    const FG::Input_halfedge_index h = surface.input().outgoing(FG::Vertex_index(3));
    const FG::Trace_report trace =
        tracer.trace({h, weights}, FG::Surface_direction{h, 0.3}, 2.5, CGAL::Emptyset_iterator());
    append(result, trace.location);
    result.insert(result.end(), {trace.length, trace.angle, static_cast<double>(trace.edges)});
  }
  return result;
}

// Numbers that depend on directions at a point, and on what becomes of them elsewhere.
template <class Surface>
std::vector<double> carried(const Surface& surface, const Mesh& mesh)
{
  std::vector<double> result;
  const FG::Vertex_index first(0), last(surface.number_of_vertices() - 1);
  const FG::Surface_location source = surface.location(first), target = surface.location(last);
  const FG::Logarithmic_map<Surface> logarithm(surface, mesh, source);
  FG::internal::Logarithm_everywhere<Surface> everywhere(surface, logarithm, source);
  for(const FG::Polar_coordinates& p : {logarithm(last), everywhere(last)})
    result.insert(result.end(), {p.radius, p.angle});
  append(result, logarithm.between(target, 0.5));
  result.push_back(logarithm.transported(target, 0.1).angle);
  std::vector<FG::Surface_location> path;
  for(const FG::Surface_point& p : logarithm.distance_field().surface_points(target))
    path.push_back(FG::internal::surface_location(surface, p));
  const FG::Located_curve<Surface> curve(surface, path);
  append(result, curve.location(0.4 * curve.length()));
  result.push_back(FG::Parallel_transport<Surface>(surface)(path, {path.front().halfedge, 0.2}).angle);
  FG::Surface_location mean = target;
  FG::Geodesic_mean<Surface>(surface, mesh, {source, target}, {1, 2})(mean);
  append(result, mean);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(tangents_ask_for_the_input_of_a_triangulation_alone)
{
  for(const Mesh_soup& soup : {bumpy_sphere(4, 0.3, 1), flat_grid(4, 4, Diagonal_rule::RISING)}) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    const auto surface = FG::internal::make_surface(mesh, CGAL::parameters::default_values());
    const Triangulation triangulation(mesh);
    BOOST_TEST(traced(surface) == traced(triangulation));
    BOOST_TEST(carried(surface, mesh) == carried(triangulation, mesh));
  }
}
