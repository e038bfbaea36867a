// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Models that have nothing but what the pages of the concepts say go through all that reads: certificates, measuring,
// extraction, subdivision, cutting, saving. The answers are those with the ordinary models, bit for bit.

#define BOOST_TEST_MODULE archetypes

#include "Curve_network_archetype.h"
#include "Curve_setting.h"
#include "Edge_path_graph_archetype.h"
#include "Metric_archetype.h"
#include "Plain_triangulation.h"
#include "Policy_archetypes.h"
#include "Traits_archetype.h"
#include "Triangulation_of_mesh_archetype.h"
#include "number_type_checks.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Curve_editor.h>
#include <CGAL/Flip_geodesics/Free_geodesic_spline.h>
#include <CGAL/Flip_geodesics/Geodesic_logarithm.h>
#include <CGAL/Flip_geodesics/Geodesic_mean.h>
#include <CGAL/Flip_geodesics/Geodesic_spline.h>
#include <CGAL/Flip_geodesics/Geodesic_tracer.h>
#include <CGAL/Flip_geodesics/Landmark_distances.h>
#include <CGAL/Flip_geodesics/Located_curve.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/Parallel_transport.h>
#include <CGAL/Flip_geodesics/Shortener.h>
#include <CGAL/Flip_geodesics/Straightness_meter.h>
#include <CGAL/Flip_geodesics/Tangent_spaces.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/draw_polylines.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/handle_and_tunnel_loops.h>
#include <CGAL/Flip_geodesics/logarithmic_map.h>
#include <CGAL/Flip_geodesics/make_shortest.h>
#include <CGAL/Flip_geodesics/network_io.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/shorten_cut_graph.h>
#include <CGAL/Flip_geodesics/shortest_loop.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/straightened_path.h>
#include <CGAL/Flip_geodesics/subdivide.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Gmpq.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

namespace {

using Traits = FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;
using Model = FG::Intrinsic_triangulation<Surface, Traits>;
using Archetype = Triangulation_of_mesh_archetype<
    FG::Intrinsic_triangulation<Surface, Traits, Metric_archetype<typename Model::Metric>>>;

// What is seen of a network, told in text, with all bits of its numbers.
class Record
{
public:
  Record() { m_out << std::hexfloat; }

  template <class Network>
  void certificate(const Network& network)
  {
    const FG::Network_certificate certificate = FG::certify(network);
    for(const FG::Curve_certificate& curve : certificate.curves)
      m_out << FG::to_string(curve.verdict) << ' ' << curve.segment << ' ' << static_cast<int>(curve.side) << '\n';
  }

  template <class Network>
  void straightness(const Network& network)
  {
    FG::Straightness_meter<Network> meter(network);
    for(FG::Curve_index c : descriptors<FG::Curve_index>(network.number_of_curves())) {
      const FG::Straightness straightness = meter(c);
      m_out << "straight " << straightness.largest_bend << ' ' << straightness.smallest_angle << '\n';
      network.for_each_segment(c, [&](FG::Segment_index s) {
        if(network.next(s) != FG::null_index)
          m_out << meter.angle({s, FG::Side::LEFT}) << ' ';
      });
    }
  }

  template <class Network>
  void extraction(const Network& network, const Surface& mesh)
  {
    FG::Curve_extractor<Network> extractor(network);
    for(FG::Curve_index c : descriptors<FG::Curve_index>(network.number_of_curves())) {
      std::vector<Surface::Point> points;
      extractor.points(c, std::back_inserter(points));
      for(const Surface::Point& p : points)
        m_out << p << '\n';
      std::vector<Surface::Halfedge_index> crossed;
      extractor.crossed_halfedges(c, std::back_inserter(crossed));
      for(Surface::Halfedge_index h : crossed)
        m_out << h << ' ';
      std::vector<std::pair<Surface::Face_index, std::array<double, 3>>> locations;
      extractor.face_locations(c, mesh, std::back_inserter(locations));
      for(const auto& [face, weights] : locations)
        m_out << face << ' ' << weights[0] << ' ' << weights[1] << '\n';
      network.for_each_segment(c, [&](FG::Segment_index s) { m_out << extractor.word(s).crossed.size() << ' '; });
    }
  }

  template <class Triangulation>
  void subdivision(const FG::Surface_subdivision<Triangulation, Surface>& subdivision)
  {
    for(Surface::Vertex_index v : subdivision.mesh().vertices())
      m_out << subdivision.mesh().point(v) << ' ' << subdivision.vertex_origin(v).intrinsic_vertex << '\n';
    for(Surface::Edge_index e : subdivision.mesh().edges())
      m_out << subdivision.mesh().vertex(e, 0) << ' ' << subdivision.mesh().vertex(e, 1) << ' '
            << get(subdivision.edge_is_constrained_map(), e) << '\n';
  }

  template <class Network>
  void network(const Network& network, const Surface& mesh)
  {
    certificate(network);
    straightness(network);
    extraction(network, mesh);
    edges(FG::edges_near_curves(network, 2));
    subdivision(FG::insert_curves(network, mesh));
    subdivision(FG::cut_along_curves(network, mesh));
    FG::write_network(m_out, network);
  }

  template <class Triangulation>
  void faces(const Triangulation& triangulation)
  {
    std::vector<FG::Intrinsic_face> faces;
    FG::intrinsic_faces(triangulation, std::back_inserter(faces));
    for(const FG::Intrinsic_face& face : faces)
      m_out << face.vertices[0] << ' ' << face.halfedges[0] << ' ' << face.lengths[0] << '\n';
    const FG::Tangent_spaces<Triangulation> spaces(triangulation, faces);
    for(const FG::Intrinsic_face& face : faces)
      m_out << std::lround(1e6 * spaces.corner(face.halfedges[1])) << '\n'; // where angles start is the model's choice
  }

  template <class Triangulation>
  void space(const Triangulation& triangulation, const Surface& mesh, const FG::Surface_point& p)
  {
    const auto [face, weights] = FG::face_location(triangulation, mesh, p);
    m_out << FG::point_in_space(triangulation, p) << ' ' << face << ' ' << weights[0] << ' ' << weights[1] << '\n';
  }

  template <class Triangulation>
  void triangulation(const Triangulation& triangulation, const Surface& mesh)
  {
    faces(triangulation);
    subdivision(FG::common_subdivision(triangulation, mesh));
    m_out << FG::is_delaunay(triangulation) << '\n';
    for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(triangulation.number_of_halfedges())) {
      location(FG::location_on_edge(triangulation, h, 0.3));
      std::vector<FG::Surface_point> points;
      FG::edge_surface_points(triangulation, h, std::back_inserter(points));
      for(const FG::Surface_point& p : points)
        space(triangulation, mesh, p);
      if(!triangulation.is_border(h))
        location(FG::location_in_face(triangulation, h, {{0.2, 0.3, 0.5}}));
    }
  }

  void report(const FG::Shortening_report& report)
  {
    m_out << report.flips << ' ' << report.is_complete();
    for(const FG::Curve_report& curve : report.curves)
      m_out << ' ' << curve.length << ' ' << FG::to_string(curve.status) << '\n';
  }

  void report(const FG::Refinement_report& report)
  {
    m_out << report.insertions << ' ' << report.splits << ' ' << report.flips << ' ' << report.smallest_angle << '\n';
  }

  void error(const std::exception& error) { m_out << error.what() << '\n'; }

  void report(const FG::Shortest_path_report& shortest)
  {
    m_out << shortest.length << ' ' << shortest.lower_bound << ' ' << shortest.windows << '\n';
    report(shortest.shortening);
  }

  void report(const FG::Shortest_tree_report& tree)
  {
    m_out << tree.vertices << ' ' << tree.longer_before << ' ' << tree.longer << ' ' << tree.flips << '\n';
  }

  template <class Tree>
  void tree(const Tree& tree)
  {
    for(FG::Vertex_index v : descriptors<FG::Vertex_index>(tree.triangulation().number_of_vertices()))
      m_out << tree.distance(v) << ' ' << tree.incoming(v).idx() << '\n';
  }

  void map(const FG::Logarithmic_map& map)
  {
    for(const FG::Polar_coordinates& p : map.vertices)
      m_out << p.radius << ' ' << p.angle << '\n';
  }

  void polyline(const std::vector<FG::Surface_location>& polyline)
  {
    for(const FG::Surface_location& at : polyline)
      location(at);
  }

  void edges(const std::vector<FG::Edge_index>& edges)
  {
    for(FG::Edge_index e : edges)
      m_out << e << ' ';
  }

  void halfedges(const std::vector<FG::Halfedge_index>& halfedges)
  {
    for(FG::Halfedge_index h : halfedges)
      m_out << h.idx() << ' ';
  }

  // Of a closed surface; what else bounds no solid.
  template <class Triangulation>
  void solid(const Triangulation& triangulation)
  {
    const auto& input = triangulation.input();
    for(FG::Input_halfedge_index h : descriptors<FG::Input_halfedge_index>(input.number_of_halfedges()))
      if(input.is_border(h))
        return;
    const FG::Handle_and_tunnel_loops loops = FG::handle_and_tunnel_loops(triangulation);
    for(const auto* kind : {&loops.handles, &loops.tunnels})
      for(const std::vector<FG::Halfedge_index>& loop : *kind)
        halfedges(loop);
  }

  template <class Triangulation, class Network>
  void classes(const FG::Loop_basis<Triangulation>& basis, const Network& network)
  {
    for(FG::Curve_index c : descriptors<FG::Curve_index>(network.number_of_curves()))
      if(network.is_closed(c)) {
        for(std::int64_t i : basis.homology_class(network, c))
          m_out << i << ' ';
        m_out << basis.is_contractible(network, c) << '\n';
      }
  }

  // The ways of the curves of a network, and how it was flipped.
  template <class Network>
  void ways(const Network& network)
  {
    for(FG::Curve_index c : descriptors<FG::Curve_index>(network.number_of_curves())) {
      network.for_each_segment(c, [&](FG::Segment_index s) { m_out << network.halfedge(s).idx() << ' '; });
      m_out << network.length(c) << '\n';
    }
    m_out << network.triangulation().log_position() << '\n';
  }

  std::string text() const { return m_out.str(); }

private:
  void location(const FG::Surface_location& at)
  {
    m_out << at.halfedge << ' ' << at.weights[0] << ' ' << at.weights[1] << ' ' << at.weights[2] << '\n';
  }

  std::ostringstream m_out;
};

template <class Network>
using Itself = const Network&;

// What all that reads has to say of random curves, some of them not pulled tight, and some of points put in.
template <class Triangulation, template <class> class Window>
std::string reading(const Surface& mesh)
{
  Record record;
  Triangulation triangulation(mesh);
  FG::Edge_path_network<Triangulation> network(triangulation);
  const Window<FG::Edge_path_network<Triangulation>> window(network);
  Random_numbers random(1);
  for(int i = 0; i < 4; ++i) {
    const Halfedge_sequence walk = random_walk(triangulation, 12, i % 2 == 1, random);
    if(!walk.empty())
      network.add_curve(walk, i % 2 == 1);
    if(!network.is_valid())
      network.clear();
    record.network(window, mesh);
    if(i % 2 == 0)
      record.report(FG::shorten(network));
    record.network(window, mesh);
  }
  record.classes(FG::Loop_basis<Triangulation>(triangulation), window);
  record.triangulation(triangulation, mesh);
  network.insert({FG::Input_halfedge_index(0), {{1, 1, 1}}});
  record.network(window, mesh);
  record.report(FG::refine(network, {20, 0.8, 200}));
  record.network(window, mesh);
  record.triangulation(triangulation, mesh);
  return record.text();
}

// What asks for no mesh.
template <class Triangulation>
std::string without_mesh(const Surface& mesh)
{
  Record record;
  Triangulation triangulation(mesh);
  FG::Edge_path_network<Triangulation> network(triangulation);
  const Curve_network_archetype<FG::Edge_path_network<Triangulation>> window(network);
  Random_numbers random(2);
  for(int i = 0; i < 6; ++i) {
    const Halfedge_sequence walk = random_walk(triangulation, 12, i % 2 == 1, random);
    if(!walk.empty())
      network.add_curve(walk, i % 2 == 1);
    if(!network.is_valid())
      network.clear();
    record.report(FG::shorten(network));
    record.ways(network);
    record.edges(FG::edges_near_curves(window, 1));
  }
  record.faces(triangulation);
  network.clear();
  FG::flip_to_delaunay(triangulation);
  BOOST_TEST(FG::is_delaunay(triangulation));
  FG::Geodesic_tree<Triangulation> tree(triangulation);
  tree.grow(FG::Vertex_index(3));
  BOOST_TEST(tree.is_valid());
  record.tree(tree);
  record.faces(triangulation);
  return record.text();
}

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
    const FG::Refinement_report refined = FG::refine(network, {15, 0.8, 20}, refinement_visitor);
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
      network.add_curve(search(v, m_last), false);
    const std::vector<Vertex> vertices = {triangulation.tail(FG::Halfedge_index(0)),
                                          triangulation.head(FG::Halfedge_index(0))};
    network.add_curve(FG::halfedges_through(triangulation, vertices, false), false);
  }

  void shortest(Network& network)
  {
    FG::Shortest_edge_path<Triangulation> search(network.triangulation());
    Visitor_archetype visitor;
    m_record.report(FG::add_shortest_path(network, search, Vertex(0), m_last, FG::Window_limit(), visitor));
    BOOST_TEST(visitor.questions() > 0);
  }

  void straightened(Network& network)
  {
    FG::Shortest_edge_path<Triangulation> search(network.triangulation());
    FG::add_straightened_path(network, search(Vertex(0), m_last));
  }

  void through_points(Network& network) { FG::add_curve_through(network, points(network.triangulation())); }

  void drawn(Network& network)
  {
    FG::draw_polyline(network, FG::complete_polyline(network.triangulation(), points(network.triangulation())));
  }

  void spline(Network& network)
  {
    const FG::Curve_index curve = FG::add_curve_through(network, points(network.triangulation()));
    if(!is_ordered(network))
      return;
    FG::Geodesic_spline<Network> spline(network, curve);
    spline.refine();
    m_record.report(spline.finish());
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
    FG::Shortest_edge_path<Triangulation> search(triangulation, FG::Search_method::LOOK_BACK);
    const FG::Landmark_distances landmarks(search);
    FG::Shortest_edge_path<Triangulation> directed(triangulation, landmarks);
    for(const auto& path :
        {directed(Vertex(0), m_last), FG::shortest_intrinsic_edge_path(triangulation, Vertex(0), m_last)})
      m_record.halfedges(path);
    const auto polyline = FG::complete_polyline(triangulation, points(triangulation));
    m_record.halfedges(FG::halfedges_on_surface(triangulation, FG::snap_polyline(triangulation, polyline), false));
    m_record.polyline(FG::points_on_surface(triangulation, points(triangulation)));
    const std::vector<Vertex> ends = {FG::vertex_on_surface(triangulation, Vertex(1)), m_last};
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
    const FG::Free_legs legs = FG::geodesics_through(triangulation, points(triangulation), stop, visitor);
    BOOST_TEST(visitor.questions() > 0);
    for(const auto& leg : legs.legs)
      m_record.polyline(leg);
    m_record.report(legs.report);
    FG::Free_geodesic_spline<Triangulation> spline(triangulation, points(triangulation), FG::Spline_kind::BEZIER);
    spline.refine();
    for(const auto& piece : spline.finish())
      m_record.polyline(piece);
    const FG::Curve_editor<Triangulation> editor(triangulation, points(triangulation));
    for(const auto& leg : editor.legs())
      m_record.polyline(leg);
  }

  void trees(Triangulation& triangulation)
  {
    FG::Geodesic_tree<Triangulation> tree(triangulation);
    Visitor_archetype visitor;
    const FG::Geodesic_tree_report report = tree.grow(Vertex(0), std::numeric_limits<double>::infinity(), visitor);
    BOOST_TEST(static_cast<std::size_t>(visitor.flips()) == report.flips);
    m_record.tree(tree);
    m_record.report(FG::make_shortest(tree));
    m_record.tree(tree);
    const FG::Logarithmic_map map = FG::logarithmic_map(tree);
    m_record.map(map);
    std::map<Surface::Vertex_index, double> distances;
    std::map<Surface::Vertex_index, FG::Polar_coordinates> coordinates;
    FG::write_distances(tree, m_mesh, boost::make_assoc_property_map(distances));
    FG::write_polar_coordinates(map, tree, m_mesh, boost::make_assoc_property_map(coordinates));
    for(Surface::Vertex_index v : m_mesh.vertices())
      BOOST_TEST(distances[v] == coordinates[v].radius);
    FG::Geodesic_distance_field<Triangulation> field(triangulation, m_mesh);
    field.add_source(Vertex(0));
    field.compute();
    std::map<Surface::Vertex_index, std::size_t> sources;
    FG::write_nearest_sources(field, triangulation, m_mesh, boost::make_assoc_property_map(sources));
    std::map<Surface::Vertex_index, double> told;
    FG::write_distances(field, triangulation, m_mesh, boost::make_assoc_property_map(told));
    for(Surface::Vertex_index v : m_mesh.vertices()) {
      BOOST_TEST(std::abs(told[v] - distances[v]) <= 1e-9 * distances[v]);
      BOOST_TEST(sources[v] == 0u);
    }
    const FG::Geodesic_tracer<Triangulation> tracer(triangulation);
    for(const FG::Surface_location& p : points(triangulation)) {
      BOOST_TEST(field.surface_points(p).size() >= 2u);
      const FG::Trace trace = tracer.trace(p, p.halfedge, 0.5, FG::Trace_limits<>{1});
      BOOST_TEST(trace.length > 0);
      m_record.polyline({p, trace.location});
    }
    const std::vector<FG::Surface_location> places = points(triangulation);
    const FG::Geodesic_logarithm<Triangulation> logarithm(triangulation, m_mesh, places.front());
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
    const FG::Delaunay_report report =
        FG::flip_to_delaunay(triangulation, (std::numeric_limits<std::size_t>::max)(), visitor);
    BOOST_TEST(static_cast<std::size_t>(visitor.flips()) == report.flips);
    m_record.report(FG::refine(triangulation, {25, 0.5, 50}));
    m_record.triangulation(triangulation, m_mesh);
  }

  std::vector<FG::Surface_location> points(const Triangulation& triangulation) const
  {
    FG::Shortening_report hindered;
    hindered.curves.emplace_back().status = FG::Shortening_status::FLAT_FACES;
    BOOST_TEST(!FG::are_curves_folded(triangulation, hindered));
    const auto h = triangulation.input().halfedge(FG::Input_halfedge_index(0));
    return {
        FG::surface_location(triangulation, m_mesh, std::make_pair(face_of(h), std::array<double, 3>{{0.2, 0.3, 0.5}})),
        FG::surface_location(triangulation, m_mesh, Surface::Vertex_index(m_last.idx() / 2)),
        FG::location_on_edge(triangulation, FG::Halfedge_index(triangulation.number_of_halfedges() - 2), 0.25),
        FG::location_on_surface(triangulation, triangulation.location(Vertex(m_last.idx() / 5)))};
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

std::vector<Mesh_soup> soups()
{
  return {bumpy_sphere(3, 0.2, 1), jittered_grid(6, 5, Diagonal_rule::RANDOM, 0.2, 2), genus_3_plate(1)};
}

} // namespace

BOOST_AUTO_TEST_CASE(what_is_read_is_the_same)
{
  for(const Mesh_soup& soup : soups()) {
    const Surface mesh = to_mesh<Surface>(soup);
    const std::string expected = reading<Model, Itself>(mesh);
    BOOST_TEST(expected.size() > 10000u);
    BOOST_TEST((reading<Archetype, Curve_network_archetype>(mesh) == expected));
    BOOST_TEST((reading<Model, Edge_path_graph_archetype>(mesh) == expected));
  }
}

BOOST_AUTO_TEST_CASE(what_is_made_is_the_same)
{
  for(const Mesh_soup& soup : soups()) {
    const Surface mesh = to_mesh<Surface>(soup);
    const Constructions<Model> expected(mesh);
    BOOST_TEST(expected.text().size() > 10000u);
    BOOST_TEST(expected.pulled() >= 9);
    BOOST_TEST((Constructions<Archetype>(mesh).text() == expected.text()));
  }
}

BOOST_AUTO_TEST_CASE(no_mesh_is_needed)
{
  using Traits = Exact_traits<CGAL::Gmpq>;
  for(const Mesh_soup& soup : {tieless_plane(6, 1), genus_3_plate(1), cube(3)}) {
    const Surface mesh = to_mesh<Surface>(soup);
    const std::string expected = without_mesh<FG::Intrinsic_triangulation<Surface, Traits>>(mesh);
    BOOST_TEST(expected.size() > 5000u);
    BOOST_TEST((without_mesh<Plain_triangulation<Traits>>(mesh) == expected));
  }
}

// Traits that compute otherwise, with drift: what comes out is as valid, and measured.
BOOST_AUTO_TEST_CASE(least_traits_are_enough)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface, Traits_archetype>;
  for(const Mesh_soup& soup : soups()) {
    const Surface mesh = to_mesh<Surface>(soup);
    const Constructions<Triangulation> constructions(mesh);
    BOOST_TEST(constructions.pulled() >= 9);
    BOOST_TEST((reading<Triangulation, Itself>(mesh)).size() > 10000u);
  }
}
