// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What computes distances asks nothing of a triangulation but its input and metric, and gives the same over a
// `Metric_surface`, which has nothing else.

#include "test_distance_field/asked_surface.h"

#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/isolines.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

using namespace Flip_geodesics_test;

namespace {

using Input_alone = FG::internal::Surface_by_name<Mesh, CGAL::parameters::Default_named_parameters>;

/* Numbers that depend on all that is computed from two vertices. */
template <class Triangulation>
std::vector<double> distances_over(const Triangulation& triangulation, const Mesh& mesh)
{
  const Vertex_index source(0), other(triangulation.number_of_vertices() - 1);
  std::vector<double> result;
  FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
  field.add_source(source);
  field.add_source(Location{triangulation.input().outgoing(other), {{1, 0, 0}}}, 0.01);
  field.compute();
  for(Vertex_index v : descriptors<Vertex_index>(triangulation.number_of_vertices()))
    result.push_back(field.distance(v));
  const double level = *std::max_element(result.begin(), result.end()) / 2;
  std::vector<FG::Isoline<Mesh>> isolines;
  FG::isolines(mesh, field, std::vector<double>{level}, std::back_inserter(isolines), 0.01 * level);
  for(const auto& isoline : isolines)
    result.push_back(static_cast<double>(isoline.points.size()));
  return result;
}

template <class Triangulation>
std::vector<double> paths_over(const Triangulation& triangulation)
{
  const Vertex_index source(0), target(triangulation.number_of_vertices() / 2);
  std::vector<double> result;
  FG::Shortest_edge_path<Triangulation> search(triangulation,
                                               CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
  for(FG::Halfedge_index h : search(source, target))
    result.push_back(h.idx());
  const FG::Landmark_distances landmarks(search);
  result.push_back(landmarks.distance_lower_bound(source, target));
  const FG::Geodesic_landmarks geodesic_landmarks(triangulation);
  result.push_back(static_cast<double>(geodesic_landmarks.number_of_landmarks()));
  FG::internal::Unfolded_faces<Triangulation> faces(triangulation);
  FG::internal::Cone_sweep<Triangulation> sweep(triangulation, faces, target, {triangulation, source, nullptr});
  sweep.run(infinity);
  FG::internal::Window_search<Triangulation> windows(triangulation, faces, source, &sweep);
  windows.run(infinity);
  result.push_back(windows.distance(target));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(distances_ask_for_the_input_of_a_triangulation_alone)
{
  for(const auto& [name, soup] : meshes()) {
    const Asked_surface s(soup);
    const Input_alone surface = FG::internal::make_surface(s.mesh, CGAL::parameters::default_values());
    BOOST_TEST(distances_over(surface, s.mesh) == distances_over(s.triangulation, s.mesh), name);
    BOOST_TEST(paths_over(surface) == paths_over(s.triangulation), name);
  }
}
