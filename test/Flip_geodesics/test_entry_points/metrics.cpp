// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Metrics that were made for another mesh are refused by all functions and constructors that take one.

#include "test_entry_points/entry_points.h"

using namespace Flip_geodesics_test;

namespace {

template <class Metric>
void check_other_mesh(const Surface& mesh, const Metric& metric)
{
  const auto np = CGAL::parameters::metric(metric);
  const auto is_clear = [](const FG::Input_mismatch_error& error) {
    return std::string(error.what()) ==
           "the metric was constructed for a mesh of 12 edges, but is used for a mesh of 48 edges";
  };
  std::vector<Face_location> out;
  std::vector<double> distances(mesh.number_of_vertices());
  const auto map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  using Other = FG::Intrinsic_triangulation<Surface, FG::Default_traits<Metric>, Metric>;
  BOOST_CHECK_EXCEPTION(FG::geodesic_path(mesh, vertex(0), vertex(9), std::back_inserter(out), np),
                        FG::Input_mismatch_error, is_clear);
  BOOST_CHECK_EXCEPTION(FG::shortest_path(mesh, vertex(0), vertex(9), std::back_inserter(out), np),
                        FG::Input_mismatch_error, is_clear);
  BOOST_CHECK_EXCEPTION(FG::geodesic_distances(mesh, vertex(0), map, np), FG::Input_mismatch_error, is_clear);
  BOOST_CHECK_EXCEPTION(FG::trace_geodesic(mesh, vertex(0), std::make_pair(mesh.halfedge(vertex(0)), 0.1), 1,
                                           std::back_inserter(out), np),
                        FG::Input_mismatch_error, is_clear);
  BOOST_CHECK_EXCEPTION(Other(mesh, metric), FG::Input_mismatch_error, is_clear);
  BOOST_CHECK_EXCEPTION(Other(mesh, metric, FG::Default_traits<Metric>(), FG::Zero_length_edges::CONTRACT),
                        FG::Input_mismatch_error, is_clear);
  BOOST_CHECK_EXCEPTION(FG::Mollified_metric<Metric>(mesh, metric), FG::Input_mismatch_error, is_clear);
}

} // namespace

BOOST_AUTO_TEST_CASE(metrics_of_another_mesh_are_refused)
{
  const Surface small = to_mesh<Surface>(octahedron(1)), large = to_mesh<Surface>(octahedron(2));
  BOOST_REQUIRE((small.number_of_edges() == 12 && large.number_of_edges() == 48));
  const Triangulation::Metric embedded(small.points());
  const boost::static_property_map<double, Surface::Vertex_index> weights(2);
  const boost::static_property_map<double, Surface::Edge_index> lengths(2);
  const FG::Weighted_metric weighted(small, embedded, weights);
  const FG::Edge_length_metric by_lengths(small, lengths);
  check_other_mesh(large, weighted);
  check_other_mesh(large, by_lengths);
  check_other_mesh(large, FG::Mollified_metric(small, embedded));
  check_other_mesh(large, FG::Mollified_metric(weighted));
  check_other_mesh(large, FG::Weighted_metric(small, by_lengths, weights));

  const Surface copy = small;
  Sink out;
  BOOST_CHECK_NO_THROW(
      FG::geodesic_path(copy, vertex(0), vertex(3), std::back_inserter(out), CGAL::parameters::metric(weighted)));
}
