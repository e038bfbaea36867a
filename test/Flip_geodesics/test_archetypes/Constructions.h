// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_ARCHETYPES_CONSTRUCTIONS_H
#define FLIP_GEODESICS_TEST_ARCHETYPES_CONSTRUCTIONS_H

#include "Curve_setting.h"
#include "Policy_archetypes.h"
#include "Record.h"

#include <CGAL/Flip_geodesics/Curve_editor.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/IO/network.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/geodesic_loops.h>
#include <CGAL/Flip_geodesics/geodesic_mean.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/straightened_path.h>
#include <CGAL/Flip_geodesics/subdivide.h>
#include <CGAL/Flip_geodesics/surface_points.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// What is made on a triangulation of any model.
namespace archetypes_test {

// What is said of the mesh's regions and texture.
template <class Key>
struct Number_map
{
  using key_type = Key;
  using value_type = int;
  using reference = int;
  using category = boost::readable_property_map_tag;

  int divisor;

  friend int get(const Number_map& map, Key key)
  {
    return static_cast<int>(static_cast<std::size_t>(key) / static_cast<std::size_t>(map.divisor));
  }
};

// Each of these starts from a triangulation of its own, and tells what came out.
template <class Triangulation>
class Constructions
{
  using Network = FG::Edge_path_network<Triangulation>;
  using Vertex = FG::Vertex_index;

public:
  explicit Constructions(const Surface& mesh)
    : m_mesh(mesh)
    , m_last(static_cast<FG::Index>(mesh.number_of_vertices()) - 1)
  {
    in_network(&Constructions::edges);
    in_network(&Constructions::regions);
    in_network(&Constructions::seams);
    in_network(&Constructions::cut);
    in_network(&Constructions::overlapping);
    in_network(&Constructions::shortest);
    in_network(&Constructions::straightened);
    in_network(&Constructions::through_points);
    in_network(&Constructions::drawn);
    in_network(&Constructions::spline);
    in_network(&Constructions::restored);
    Triangulation triangulation(m_mesh);
    searches(triangulation);
    free_curves(triangulation);
    trees(triangulation);
    Triangulation other(m_mesh);
    delaunay(other);
  }

  std::string text() const { return m_record.text(); }

  // How many of the networks could be pulled tight, since their curves do not cross?
  int pulled() const { return m_pulled; }

private:
  void in_network(void (Constructions::*construct)(Network&))
  {
    Triangulation triangulation(m_mesh);
    Network network(triangulation);
    (this->*construct)(network);
    if(!is_ordered(network))
      return;
    ++m_pulled;
    FG::Shortener<Network> shortener(network);
    Visitor_archetype visitor;
    shortener.run(Stop_predicate_archetype(3), visitor);
    BOOST_TEST(visitor.steps() <= 3);
    shortener.run(FG::Never_stop_predicate(), visitor);
    BOOST_TEST(static_cast<std::size_t>(visitor.steps()) == shortener.number_of_steps());
    m_record.report(shortener.report());
    m_record.ways(network);
    Refinement_visitor_archetype refinement_visitor;
    const FG::Refinement_report refined =
        FG::refine(network, {15, 0.8, 20}, CGAL::parameters::visitor(std::ref(refinement_visitor)));
    BOOST_TEST(static_cast<std::size_t>(refinement_visitor.insertions()) == refined.insertions + refined.splits);
    m_record.report(refined);
    m_record.ways(network);
  }

  bool is_ordered(Network& network)
  {
    if(network.is_valid())
      return true;
    try {
      FG::order_overlapping_curves(network);
      return true;
    } catch(const FG::Crossing_curves_error& error) {
      m_record.error(error);
      return false;
    }
  }

  void edges(Network& network) { FG::add_marked_edges(network, m_mesh, Number_map<Surface::Edge_index>{20}); }
  void regions(Network& network)
  {
    FG::add_region_boundaries(network, m_mesh, Number_map<Surface::Face_index>{7}, FG::Junctions::FREE);
  }
  void seams(Network& network) { FG::add_seams(network, m_mesh, Number_map<Surface::Halfedge_index>{60}); }

  void cut(Network& network)
  {
    FG::add_cut_graph(network);
    FG::shorten_cut_graph(network);
  }

  void overlapping(Network& network)
  {
    const Triangulation& triangulation = network.triangulation();
    FG::Shortest_edge_path<Triangulation> search(triangulation);
    for(Vertex v : {Vertex(0), Vertex(m_last.idx() / 3)})
      network.add_curve(search(v, m_last));
    const std::vector<Vertex> vertices = {triangulation.tail(FG::Halfedge_index(0)),
                                          triangulation.head(FG::Halfedge_index(0))};
    network.add_curve(FG::halfedges_through(triangulation, vertices));
  }

  void shortest(Network& network)
  {
    FG::Shortest_edge_path<Triangulation> search(network.triangulation());
    Visitor_archetype visitor;
    m_record.report(
        FG::add_shortest_path(network, search, Vertex(0), m_last, CGAL::parameters::visitor(std::ref(visitor))));
    BOOST_TEST(visitor.questions() > 0);
  }

  void straightened(Network& network)
  {
    FG::Shortest_edge_path<Triangulation> search(network.triangulation());
    FG::add_straightened_path(network, search(Vertex(0), m_last));
  }

  void through_points(Network& network)
  {
    add_unless_crossing([&] { FG::add_curve_through(network, points(network.triangulation())); });
  }

  void drawn(Network& network)
  {
    add_unless_crossing([&] {
      FG::draw_polyline(network, FG::complete_polyline(network.triangulation(), points(network.triangulation())));
    });
  }

  // Adds a curve through points, which crosses itself on some of the meshes.
  template <class Add>
  void add_unless_crossing(const Add& add)
  {
    try {
      add();
    } catch(const FG::Crossing_curves_error&) {
    }
  }

  void spline(Network& network)
  {
    Triangulation& triangulation = network.triangulation();
    FG::Geodesic_spline<Triangulation> spline(triangulation, points(triangulation), FG::Spline_kind::BEZIER);
    spline.refine();
    const auto pieces = spline.finish();
    for(const auto& piece : pieces)
      m_record.polyline(piece);
    m_record.report(spline.report());
    add_unless_crossing([&] { FG::add_curve_along(network, pieces); });
  }

  void restored(Network& network)
  {
    Triangulation triangulation(m_mesh);
    Network saved(triangulation);
    edges(saved);
    FG::shorten(saved);
    saved.insert(points(triangulation).front());
    std::stringstream file;
    FG::write_network(file, saved);
    FG::read_network(file, network);
  }

  void searches(Triangulation& triangulation)
  {
    FG::Shortest_edge_path<Triangulation> search(triangulation,
                                                 CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
    const FG::Landmark_distances landmarks(search);
    FG::Shortest_edge_path<Triangulation> directed(triangulation, CGAL::parameters::landmarks(landmarks));
    for(const auto& path :
        {directed(Vertex(0), m_last), FG::shortest_intrinsic_edge_path(triangulation, Vertex(0), m_last)})
      m_record.halfedges(path);
    const FG::Geodesic_landmarks bounds(triangulation, 2);
    bounds.check_input(triangulation);
    BOOST_TEST(bounds.distance_lower_bound(Vertex(0), m_last) >= 0);
    const FG::Geodesic_landmarks of_given(triangulation, {m_last, Vertex(0)});
    BOOST_TEST(of_given.distance_lower_bound(Vertex(0), m_last) > 0);
    const auto polyline = FG::complete_polyline(triangulation, points(triangulation));
    m_record.halfedges(
        FG::internal::halfedges_on_surface(triangulation, FG::snap_polyline(triangulation, polyline), false));
    m_record.polyline(FG::internal::points_on_surface(triangulation, points(triangulation)));
    const std::vector<Vertex> ends = {FG::internal::vertex_on_surface(triangulation, Vertex(1)), m_last};
    m_record.halfedges(FG::shortest_halfedges_through(search, ends));
    m_record.space(triangulation, m_mesh, FG::surface_point(triangulation, points(triangulation).front()));
    const FG::Loop_basis<Triangulation> basis(triangulation);
    for(FG::Index i = 0; i < basis.number_of_loops(); ++i)
      m_record.halfedges(basis.loop(i));
    m_record.halfedges(FG::shortest_loop(triangulation));
    m_record.solid(triangulation);
    m_record.halfedges(FG::shortest_loop(triangulation, Vertex(1), FG::Loop_kind::NOT_BOUNDING));
    std::vector<std::vector<FG::Halfedge_index>> borders;
    FG::border_loops(triangulation, std::back_inserter(borders));
    for(const auto& border : borders)
      m_record.halfedges(border);
  }

  void free_curves(Triangulation& triangulation)
  {
    Visitor_archetype visitor;
    const Stop_predicate_archetype stop(1000);
    const FG::Free_legs legs =
        FG::geodesics_through(triangulation, points(triangulation), CGAL::parameters::stop_predicate(stop),
                              CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(visitor.questions() > 0);
    for(const auto& leg : legs.legs)
      m_record.polyline(leg);
    m_record.report(legs.report);
    const FG::Curve_editor<Triangulation> editor(triangulation, points(triangulation));
    for(const auto& leg : editor.legs())
      m_record.polyline(leg);
  }

  void trees(Triangulation& triangulation)
  {
    FG::Geodesic_tree<Triangulation> tree(triangulation);
    Visitor_archetype visitor;
    const FG::Geodesic_tree_report report = tree.grow(Vertex(0), CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(static_cast<std::size_t>(visitor.flips()) == report.flips);
    m_record.tree(tree);
    m_record.report(FG::make_shortest(tree));
    m_record.tree(tree);
    const FG::Vertex_logarithmic_map map = FG::logarithmic_map(tree);
    m_record.map(map);
    std::map<Surface::Vertex_index, double> distances;
    std::map<Surface::Vertex_index, FG::Polar_coordinates> coordinates;
    FG::put_distances(tree, m_mesh, boost::make_assoc_property_map(distances));
    FG::put_logarithmic_map(map, tree, m_mesh, boost::make_assoc_property_map(coordinates));
    for(Surface::Vertex_index v : m_mesh.vertices())
      BOOST_TEST(distances[v] == coordinates[v].radius);
    FG::Geodesic_distance_field<Triangulation> field(triangulation, m_mesh);
    field.add_source(Vertex(0));
    field.compute();
    std::map<Surface::Vertex_index, std::size_t> sources;
    FG::put_nearest_sources(field, triangulation, m_mesh, boost::make_assoc_property_map(sources));
    std::map<Surface::Vertex_index, double> told;
    FG::put_distances(field, triangulation, m_mesh, boost::make_assoc_property_map(told));
    for(Surface::Vertex_index v : m_mesh.vertices()) {
      BOOST_TEST(std::abs(told[v] - distances[v]) <= 1e-9 * distances[v]);
      BOOST_TEST(sources[v] == 0u);
    }
    const FG::Geodesic_tracer<Triangulation> tracer(triangulation);
    for(const FG::Surface_location& p : points(triangulation)) {
      BOOST_TEST(field.surface_points(p).size() >= 2u);
      const FG::Trace_report trace =
          tracer.trace(p, FG::Surface_direction{p.halfedge, 0.5}, 1, CGAL::Emptyset_iterator());
      BOOST_TEST(trace.length > 0);
      m_record.polyline({p, trace.location});
    }
    const std::vector<FG::Surface_location> places = points(triangulation);
    const FG::Logarithmic_map<Triangulation> logarithm(triangulation, m_mesh, places.front());
    BOOST_TEST(std::abs(logarithm(places.back()).radius - logarithm.distance_field().distance(places.back())) < 1e-12);
    const FG::Surface_direction carried = FG::Parallel_transport<Triangulation>(triangulation)(
        std::vector<FG::Surface_location>{places.front()}, {places.front().halfedge, 0.5});
    BOOST_TEST(std::abs(carried.angle - 0.5) < 1e-15);
    const FG::Surface_location middle = logarithm.between(places.back(), 0.5);
    const std::vector<FG::Surface_location> one_place = {middle};
    BOOST_TEST(FG::Located_curve<Triangulation>(triangulation, one_place).length() == 0);
    BOOST_TEST(FG::angle_between(triangulation, places.front(), carried, carried) == 0);
    FG::Surface_location mean = middle;
    const FG::Geodesic_mean<Triangulation> find_mean(triangulation, m_mesh, one_place, {1});
    BOOST_TEST((find_mean(mean).status == FG::Mean_status::CONVERGED));
  }

  void delaunay(Triangulation& triangulation)
  {
    m_record.triangulation(triangulation, m_mesh);
    Visitor_archetype visitor;
    const FG::Delaunay_report report = FG::flip_to_delaunay(
        triangulation, CGAL::parameters::number_of_iterations((std::numeric_limits<std::size_t>::max)()),
        CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(static_cast<std::size_t>(visitor.flips()) == report.flips);
    m_record.report(FG::refine(triangulation, {25, 0.5, 50}));
    m_record.triangulation(triangulation, m_mesh);
  }

  std::vector<FG::Surface_location> points(const Triangulation& triangulation) const
  {
    FG::Shortening_report hindered;
    hindered.curves.emplace_back().status = FG::Shortening_status::DEGENERATE_FACES;
    BOOST_TEST(!FG::internal::are_curves_folded(triangulation, hindered));
    BOOST_TEST((FG::internal::report_of_point(triangulation).verdict == FG::Verdict::PROVEN));
    const auto h = triangulation.input().halfedge(FG::Input_halfedge_index(0));
    return {
        FG::surface_location(triangulation, m_mesh, std::make_pair(face_of(h), std::array<double, 3>{{0.2, 0.3, 0.5}})),
        FG::surface_location(triangulation, m_mesh, Surface::Vertex_index(m_last.idx() / 2)),
        FG::location_on_edge(triangulation, FG::Halfedge_index(triangulation.number_of_halfedges() - 2), 0.25),
        FG::internal::location_on_surface(triangulation, triangulation.location(Vertex(m_last.idx() / 5)))};
  }

  Surface::Face_index face_of(Surface::Halfedge_index h) const
  {
    return m_mesh.face(m_mesh.is_border(h) ? m_mesh.opposite(h) : h);
  }

  const Surface& m_mesh;
  Vertex m_last;
  Record m_record;
  int m_pulled = 0;
};

} // namespace archetypes_test

#endif // FLIP_GEODESICS_TEST_ARCHETYPES_CONSTRUCTIONS_H
