// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Mistakes that are made with the interface, by their number; without any, MISTAKE=0, all of it compiles. They are
// compiled together, and an instance has its error once: no two mistakes may have the same instances.

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/geodesic_paths.h>
#include <CGAL/Flip_geodesics/insert_curves.h>
#include <CGAL/Flip_geodesics/isolines.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/polygon_soup_to_triangle_mesh.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

struct Visitor_of_flips
{
  template <class T>
  void on_flip(const T&, FG::Halfedge_index)
  {
  }
};

struct Map_without_get
{
  using key_type = Mesh::Vertex_index;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;
};

void use(const Mesh& mesh, const std::vector<Mesh::Vertex_index>& of_mesh,
         const std::vector<FG::Vertex_index>& vertices, const std::vector<FG::Halfedge_index>& halfedges,
         Mesh::Property_map<Mesh::Edge_index, double> lengths)
{
  std::vector<Kernel::Point_3> points;
  const auto out = std::back_inserter(points);
  const FG::Iteration_stop_predicate stop(3);
  const FG::Default_shortening_visitor visitor;
  std::vector<FG::Vertex_index> wrong_points;
  std::vector<std::vector<Kernel::Point_3>> several;
  std::map<Mesh::Vertex_index, double> distances;
  Triangulation triangulation(mesh);
  FG::Edge_path_network<Triangulation> network(triangulation);
  const FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
  const std::vector<double> levels = {1, 2};
  std::vector<FG::Isoline<Mesh>> isolines;
  const std::vector<std::pair<Mesh::Vertex_index, Mesh::Vertex_index>> pairs = {{of_mesh[0], of_mesh[1]}};
  std::vector<FG::Geodesic_path_result<Kernel::Point_3>> paths;
  Mesh changed = mesh;
  std::map<Mesh::Edge_index, bool> marks;
  const FG::Embedded_metric<Mesh, Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3>> embedded(mesh.points());

#if MISTAKE == 1
  FG::Intrinsic_triangulation<Mesh, Kernel> wrong(mesh);
#elif MISTAKE == 2
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::default_values(), FG::Never_stop_predicate());
#elif MISTAKE == 3
  FG::geodesic_loop(mesh, std::vector<Mesh::Halfedge_index>(), out);
#elif MISTAKE == 4
  network.add_curve(vertices);
#elif MISTAKE == 5
  FG::halfedges_through(triangulation, of_mesh);
#elif MISTAKE == 6
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, 1000L);
#elif MISTAKE == 7
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], std::back_inserter(wrong_points));
#elif MISTAKE == 8
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::visitor(std::cref(visitor)));
#elif MISTAKE == 9
  FG::geodesic_loop(mesh, std::vector<CGAL::Polyhedron_3<Kernel>::Vertex_handle>(), out);
#elif MISTAKE == 10
  FG::IO::write_VTP("mesh.vtp", of_mesh);
#elif MISTAKE == 11
  FG::geodesic_path(mesh, of_mesh[0], out, FG::Surface_location());
#elif MISTAKE == 12
  FG::geodesic_path(of_mesh[0], of_mesh[1], mesh, out);
#elif MISTAKE == 13
  FG::geodesic_distances(mesh, of_mesh[0], distances);
#elif MISTAKE == 14
  FG::geodesic_loop(mesh, of_mesh[0], out);
#elif MISTAKE == 15
  FG::geodesic_network(mesh, of_mesh, std::back_inserter(several));
#elif MISTAKE == 16
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::metric(lengths));
#elif MISTAKE == 17
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::visitor(Visitor_of_flips()));
#elif MISTAKE == 18
  FG::shortest_path(mesh, of_mesh[0], out, of_mesh[1]);
#elif MISTAKE == 19
  FG::geodesic_distances(mesh, boost::make_assoc_property_map(distances), of_mesh[0]);
#elif MISTAKE == 20
  FG::geodesic_spline(mesh, of_mesh, out, FG::Spline_kind::BEZIER);
#elif MISTAKE == 21
  FG::isolines(mesh, field, levels, 0.1, std::back_inserter(isolines));
#elif MISTAKE == 22
  FG::isolines(field, mesh, levels, std::back_inserter(isolines), 0.1);
#elif MISTAKE == 23
  FG::shortest_path(mesh, of_mesh[0], of_mesh[1], out, FG::Window_limit(1));
#elif MISTAKE == 24
  std::map<Mesh::Vertex_index, float> of_several;
  FG::geodesic_distances(mesh, of_mesh, of_several);
#elif MISTAKE == 25
  const FG::Geodesic_distance_field<Triangulation> of_temporary{Triangulation(mesh), mesh};
#elif MISTAKE == 26
  const FG::Geodesic_landmarks landmarks(triangulation, of_mesh);
#elif MISTAKE == 27
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::search_limit(FG::Window_limit(1)));
#elif MISTAKE == 28
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::visitor(visitor),
                    CGAL::parameters::visitor(visitor));
#elif MISTAKE == 29
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::stop_predicate(3));
#elif MISTAKE == 30
  FG::shortest_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::search_limit(1));
#elif MISTAKE == 31
  FG::geodesic_paths(mesh, pairs, std::back_inserter(paths),
                     CGAL::parameters::landmarks(FG::geodesic_landmarks(mesh, 3)));
#elif MISTAKE == 32
  FG::shorten(network, stop);
#elif MISTAKE == 33
  FG::flip_to_delaunay(triangulation, 1000);
#elif MISTAKE == 34
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::geom_traits(lengths));
#elif MISTAKE == 35
  FG::insert_curves(mesh, isolines);
#elif MISTAKE == 36
  FG::insert_curves(changed, levels);
#elif MISTAKE == 37
  FG::insert_curves(changed, isolines, CGAL::parameters::edge_is_constrained_map(marks));
#elif MISTAKE == 38
  FG::insert_curves(changed, isolines, CGAL::parameters::stop_predicate(stop));
#elif MISTAKE == 39
  FG::shortest_path(mesh, of_mesh[0], 1.5, out);
#elif MISTAKE == 40
  FG::geodesic_paths(mesh, of_mesh, std::back_inserter(paths));
#elif MISTAKE == 41
  network.add_curve(halfedges, true);
#elif MISTAKE == 42
  FG::Geodesic_distance_field<Triangulation> wrong(triangulation, mesh, FG::Distance_field_extent::VERTICES_ONLY);
#elif MISTAKE == 43
  FG::Geodesic_distance_field<Triangulation>(triangulation, mesh).compute(FG::Distance_field_limits());
#elif MISTAKE == 44
  FG::Shortest_edge_path<Triangulation> search(triangulation, FG::Search_method::DIJKSTRA);
#elif MISTAKE == 45
  FG::Geodesic_tree<Triangulation>(triangulation).grow(vertices[0], 0.5);
#elif MISTAKE == 46
  FG::Geodesic_tracer<Triangulation>(triangulation).trace(points[0], 0.5F, 1, out);
#elif MISTAKE == 47
  FG::IO::write_VTP(mesh, points);
#elif MISTAKE == 48
  const FG::Weighted_metric wrong(mesh, embedded, [](Mesh::Vertex_index) { return 1.; });
#elif MISTAKE == 49
  const FG::Weighted_metric wrong(mesh, embedded, changed.add_property_map<Mesh::Halfedge_index, double>("w").first);
#elif MISTAKE == 50
  const FG::Weighted_metric wrong(mesh, lengths, embedded);
#elif MISTAKE == 51
  const FG::Weighted_metric wrong(mesh, embedded, mesh.points());
#elif MISTAKE == 52
  const FG::Edge_length_metric wrong(mesh, changed.add_property_map<Mesh::Face_index, double>("l").first);
#elif MISTAKE == 53
  const FG::Mollified_metric wrong(mesh, lengths);
#elif MISTAKE == 54
  const FG::Embedded_metric<Mesh, Mesh::Property_map<Mesh::Edge_index, double>> wrong(lengths);
#elif MISTAKE == 55
  const FG::Edge_length_metric wrong(lengths, mesh);
#elif MISTAKE == 56
  const FG::Weighted_metric wrong(mesh, embedded, Map_without_get());
#elif MISTAKE == 57
  FG::polygon_soup_to_triangle_mesh(std::vector<std::array<double, 3>>(), std::vector<std::vector<int>>(), changed);
#else
  FG::insert_curves(changed, isolines,
                    CGAL::parameters::edge_is_constrained_map(boost::make_assoc_property_map(marks)));
  FG::insert_curves(changed, points, CGAL::parameters::snapping_tolerance(0));
  FG::insert_curves(changed, several);
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::stop_predicate(stop));
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::visitor(visitor),
                    CGAL::parameters::stop_predicate(stop));
  FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), CGAL::parameters::stop_predicate(stop).visitor(visitor));
  FG::geodesic_loop(mesh, of_mesh, out);
  FG::geodesic_network(mesh, std::vector<std::vector<Mesh::Vertex_index>>(), std::back_inserter(several));
  FG::geodesic_distances(mesh, of_mesh[0], boost::make_assoc_property_map(distances),
                         CGAL::parameters::metric(FG::Edge_length_metric(mesh, lengths)));
  FG::geodesic_path(mesh, of_mesh[0], of_mesh[1], out,
                    CGAL::parameters::metric(FG::Weighted_metric(mesh, embedded, lengths)));
  FG::shortest_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::search_limit(FG::Window_limit(1)));
  FG::shortest_path(mesh, of_mesh[0], points[0], out, CGAL::parameters::greatest_point_distance(1));
  FG::geodesic_spline(mesh, of_mesh, FG::Spline_kind::BEZIER, out);
  FG::shortest_path(mesh, of_mesh[0], of_mesh[1], out, CGAL::parameters::landmarks(FG::geodesic_landmarks(mesh, 3)));
  FG::geodesic_landmarks(mesh, of_mesh, CGAL::parameters::default_values());
  FG::geodesic_landmarks(mesh, CGAL::parameters::visitor(visitor));
  const FG::Geodesic_landmarks landmarks(triangulation, vertices);
  FG::isolines(mesh, field, levels, std::back_inserter(isolines), 0.1);
  network.add_curve(halfedges);
  FG::shorten(network, CGAL::parameters::stop_predicate(stop), CGAL::parameters::visitor(visitor));
  FG::flip_to_delaunay(triangulation, CGAL::parameters::number_of_iterations(1000));
  network.add_curve(FG::halfedges_through(triangulation, vertices));
  network.add_curve(halfedges, CGAL::parameters::is_closed(true));
  FG::Geodesic_distance_field<Triangulation>(triangulation, mesh,
                                             CGAL::parameters::extent(FG::Distance_field_extent::VERTICES_ONLY))
      .compute(CGAL::parameters::search_limit(FG::Distance_field_limits()).visitor(visitor));
  const FG::Shortest_edge_path<Triangulation> search(triangulation,
                                                     CGAL::parameters::search_method(FG::Search_method::DIJKSTRA));
  FG::Geodesic_tree<Triangulation>(triangulation).grow(vertices[0], CGAL::parameters::max_distance(0.5));
  FG::Geodesic_tracer<Triangulation>(triangulation)
      .trace(points[0], FG::Surface_direction(), 1, CGAL::Emptyset_iterator());
#endif
}
