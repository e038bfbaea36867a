// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_ARCHETYPES_RECORD_H
#define FLIP_GEODESICS_TEST_ARCHETYPES_RECORD_H

#include "Curve_setting.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/IO/network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/Operators.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/subdivide.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// What is seen of triangulations, networks and curves of any model.
namespace archetypes_test {

namespace FG = CGAL::Flip_geodesics;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

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
      m_out << FG::to_string(curve.verdict()) << ' ' << curve.segment << ' ' << static_cast<int>(curve.side) << '\n';
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
      network.for_each_segment(c,
                               [&](FG::Segment_index s) { m_out << extractor.edge_sequence(s).crossed.size() << ' '; });
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

  void report(const FG::Distances_report& tree)
  {
    m_out << tree.vertices << ' ' << tree.longer_before << ' ' << tree.longer << ' ' << tree.flips << '\n';
  }

  template <class Tree>
  void tree(const Tree& tree)
  {
    for(FG::Vertex_index v : descriptors<FG::Vertex_index>(tree.triangulation().number_of_vertices()))
      m_out << tree.distance(v) << ' ' << tree.incoming(v).idx() << '\n';
  }

  void map(const FG::Vertex_logarithmic_map& map)
  {
    for(const FG::Polar_coordinates& p : map)
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

} // namespace archetypes_test

#endif // FLIP_GEODESICS_TEST_ARCHETYPES_RECORD_H
