// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Triangulations and subdivisions, and boundaries of regions.

#include "test_recorded_results/added_curves.h"

using namespace Flip_geodesics_test;

namespace {

void add(const FG::Refinement_report& report, Summary& summary, Result& extra)
{
  summary.results.add(static_cast<long long>(report.status));
  summary.flips += report.flips;
  summary.lengths.add(report.smallest_angle);
  summary.lengths.add(report.smallest_free_angle);
  extra.count("insertions", report.insertions);
  extra.count("splits", report.splits);
  extra.count("refused", report.refused);
  extra.count("exempt", report.exempt);
  extra.count("missed", report.missed);
  extra.count("given_up", report.given_up);
}

template <class Triangulation>
void add_places(const Triangulation& triangulation, Summary& summary)
{
  for(FG::Vertex_index v(triangulation.input().number_of_vertices()); v.idx() < triangulation.number_of_vertices(); ++v)
    summary.add(triangulation.location(v));
  for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(triangulation.number_of_edges())) {
    const FG::Halfedge_index h = FG::internal::first_side(e);
    summary.add(triangulation.edge_sequence(h));
    summary.lengths.add(triangulation.length(h));
  }
  summary.add_log(triangulation);
}

template <class Subdivision>
void add_subdivision(const Subdivision& subdivision, Summary& summary, Result& extra)
{
  const auto& mesh = subdivision.mesh();
  for(const auto v : mesh.vertices()) {
    const FG::Subdivision_vertex origin = subdivision.vertex_origin(v);
    summary.add(origin.on_input);
    summary.results.add(origin.intrinsic_vertex);
    summary.results.add(origin.intrinsic_halfedge);
    summary.lengths.add(origin.intrinsic_t);
  }
  for(const auto f : mesh.faces()) {
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      summary.results.add(static_cast<long long>(v));
    summary.results.add(subdivision.input_face(f));
    summary.results.add(subdivision.intrinsic_face(f));
    summary.lengths.add(subdivision.area(f));
    for(const auto& corner : subdivision.corners(f))
      for(double weight : corner)
        summary.lengths.add(weight);
  }
  for(const auto h : mesh.halfedges()) {
    summary.results.add(subdivision.input_halfedge(h));
    summary.results.add(subdivision.intrinsic_halfedge(h));
  }
  std::size_t constrained = 0;
  for(const auto e : mesh.edges())
    constrained += get(subdivision.edge_is_constrained_map(), e) ? 1 : 0;
  extra.count("vertices", mesh.number_of_vertices());
  extra.count("faces", mesh.number_of_faces());
  extra.count("constrained", constrained);
}

} // namespace

// ---------------------------------------------------------------- other triangulations

// Flips to Delaunay, and the common subdivision.
BOOST_AUTO_TEST_CASE(delaunay)
{
  compare<Certified>("delaunay", Depends_on::INPUT, [](Setting<Certified>& s, Summary& summary, Result& extra) {
    summary.flips += FG::flip_to_delaunay(s.triangulation).flips;
    add_places(s.triangulation, summary);
    for(int i = 0; i < 20; ++i) {
      const FG::Vertex_index v = s.random_vertex(), w = s.random_vertex();
      summary.results.add_all(FG::shortest_intrinsic_edge_path(s.triangulation, v, w));
    }
    add_subdivision(FG::common_subdivision(s.triangulation, s.mesh), summary, extra);
  });
}

// Insertion of circumcenters.
BOOST_AUTO_TEST_CASE(refinement)
{
  compare<Certified>("refinement", Depends_on::ARITHMETIC, [](Setting<Certified>& s, Summary& summary, Result& extra) {
    FG::Refinement_options options;
    options.maximum_insertions = 300;
    add(FG::refine(s.triangulation, options), summary, extra);
    add_places(s.triangulation, summary);
  });
}

// The same by predicates in double, with bounds on angles and lengths.
BOOST_AUTO_TEST_CASE(plain_refinement)
{
  compare<Plain>("plain_refinement", Depends_on::ARITHMETIC, [](Setting<Plain>& s, Summary& summary, Result& extra) {
    FG::Refinement_options options;
    options.maximum_insertions = 300;
    options.smallest_angle = 20;
    options.longest_edge = 0.8;
    add(FG::refine(s.triangulation, options), summary, extra);
    add_places(s.triangulation, summary);
  });
}

// Refinement and Delaunay flips that keep the edges of curves.
BOOST_AUTO_TEST_CASE(refinement_about_curves)
{
  compare<Certified>(
      "refinement_about_curves", Depends_on::ARITHMETIC, [](Setting<Certified>& s, Summary& summary, Result& extra) {
        Setting<Certified>::Network network(s.triangulation);
        add_star(s, network, 5);
        shorten_and_add(network, summary);
        const FG::Delaunay_report flipped = FG::flip_to_delaunay(s.triangulation, FG::edges_near_curves(network));
        extra.count("constrained", flipped.constrained);
        summary.flips += flipped.flips;
        FG::Refinement_options options;
        options.maximum_insertions = 300;
        add(FG::refine(network, options), summary, extra);
        add_places(s.triangulation, summary);
        summary.add_curves(network);
      });
}

// Curves as edges of a mesh, and cuts along them.
BOOST_AUTO_TEST_CASE(subdivision_along_curves)
{
  compare<Certified>("subdivision_along_curves", Depends_on::INPUT,
                     [](Setting<Certified>& s, Summary& summary, Result& extra) {
                       Setting<Certified>::Network network(s.triangulation);
                       add_star(s, network, 5);
                       shorten_and_add(network, summary);
                       summary.attempt([&] { add_subdivision(FG::insert_curves(network, s.mesh), summary, extra); });
                       summary.attempt([&] { add_subdivision(FG::cut_along_curves(network, s.mesh), summary, extra); });
                     });
}

// ---------------------------------------------------------------- curves from data

// Regions by bands of numbers of vertices, which are anything but smooth.
BOOST_AUTO_TEST_CASE(region_boundaries)
{
  compare<Certified>("region_boundaries", Depends_on::INPUT, [](Setting<Certified>& s, Summary& summary, Result&) {
    const auto regions = s.mesh.add_property_map<Surface::Face_index, int>("f:region", 0).first;
    const int most = s.triangulation.input().number_of_vertices() / 3 + 1;
    for(const auto f : s.mesh.faces())
      regions[f] = static_cast<int>(s.mesh.target(s.mesh.halfedge(f))) / most;
    for(FG::Junctions junctions : {FG::Junctions::FIXED, FG::Junctions::FREE}) {
      Setting<Certified>::Network network(s.triangulation);
      summary.attempt([&] {
        summary.results.add(FG::add_region_boundaries(network, s.mesh, regions, junctions));
        shorten_and_add(network, summary);
      });
      network.clear();
      s.triangulation.rollback();
    }
  });
}
