// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Results are a function of the input alone: the results of the public functions on small meshes of all kinds are
// compared with recorded ones. Other tests check what is right; this one checks that nothing has changed, be it the
// paths, their order, or the work. There is one hash for each algorithm and mesh, and the comment of each algorithm
// states what it has that no other has. After an intended change, FLIP_GEODESICS_RECORD=1 in the environment writes the
// file anew.

#define BOOST_TEST_MODULE recorded_results

#include "test_recorded_results/added_curves.h"

using namespace Flip_geodesics_test;

// ---------------------------------------------------------------- paths

// Search, initial straightening and shortening of single paths, by certified predicates.
BOOST_AUTO_TEST_CASE(paths) { compare<Certified>("paths", Depends_on::INPUT, Add_paths{40}); }

// The same by predicates in double, which decide otherwise where angles are near pi.
BOOST_AUTO_TEST_CASE(plain_paths) { compare<Plain>("plain_paths", Depends_on::INPUT, Add_paths{20}); }

#ifndef _GLIBCXX_DEBUG // containers that check are larger, so that a limit of memory stops elsewhere
// Shortened from the edge path on, with landmarks, by runs that stop before the end.
BOOST_AUTO_TEST_CASE(stopped_paths) { compare<Certified>("stopped_paths", Depends_on::INPUT, Add_stopped_curves()); }
#endif

// Paths that cross themselves, turn back, and run along the border.
BOOST_AUTO_TEST_CASE(straightened_walks)
{
  compare<Certified>("straightened_walks", Depends_on::INPUT, [](Setting<Certified>& s, Summary& summary, Result&) {
    for(int i = 0; i < 60; ++i) {
      Setting<Certified>::Network network(s.triangulation);
      summary.attempt([&] {
        summary.flips += FG::add_straightened_path(network, random_walk(s.triangulation, 2 + i / 3, false, s.random));
        summary.add_curves(network);
        FG::order_overlapping_curves(network);
        shorten_and_add(network, summary);
      });
      network.clear();
      s.triangulation.rollback();
    }
  });
}

// Closed curves, with and without a fixed vertex, and their certificates.
BOOST_AUTO_TEST_CASE(loops)
{
  compare<Certified>("loops", Depends_on::INPUT, [](Setting<Certified>& s, Summary& summary, Result&) {
    FG::Shortest_edge_path<Certified> search(s.triangulation);
    for(int i = 0; i < 16; ++i) {
      Setting<Certified>::Network network(s.triangulation);
      const Vertex_sequence way = {s.random_vertex(), s.random_vertex(), s.random_vertex()};
      summary.attempt([&] {
        network.add_curve(FG::shortest_halfedges_through(search, way, CGAL::parameters::is_closed(true)),
                          CGAL::parameters::is_closed(true));
        FG::order_overlapping_curves(network);
        if(i % 2 == 1)
          network.fix_nodes_at(way[0]);
        shorten_and_add(network, summary);
        const FG::Network_certificate certificate = FG::certify(network);
        summary.results.add(static_cast<long long>(certificate.curves[0].verdict()));
        FG::Curve_extractor<Setting<Certified>::Network> extractor(network);
        summary.add(extractor.surface_points(0_c));
      });
      network.clear();
      s.triangulation.rollback();
    }
  });
}

// Curves that share edges, with fixed and with freed vertices.
BOOST_AUTO_TEST_CASE(networks) { compare<Certified>("networks", Depends_on::INPUT, Add_networks{8}); }

// The window search that confirms a path as the shortest one.
BOOST_AUTO_TEST_CASE(shortest_paths)
{
  compare<Certified>("shortest_paths", Depends_on::ARITHMETIC, Add_shortest_paths{20});
}

// ---------------------------------------------------------------- curves through points

// Points in faces and on edges: free legs, and curves through inserted vertices.
BOOST_AUTO_TEST_CASE(curves_through_points)
{
  compare<Certified>("curves_through_points", Depends_on::ARITHMETIC,
                     [](Setting<Certified>& s, Summary& summary, Result&) {
                       for(int i = 0; i < 10; ++i) {
                         const auto locations = s.random_locations(4);
                         summary.attempt([&] {
                           const FG::Free_legs legs = FG::geodesics_through(s.triangulation, locations);
                           summary.add(legs.legs);
                           summary.add(legs.report);
                           summary.results.add(static_cast<long long>(legs.report.curves[0].verdict));
                         });
                         Setting<Certified>::Network network(s.triangulation);
                         summary.attempt([&] {
                           if(i % 2 == 1)
                             FG::flip_to_delaunay(s.triangulation);
                           FG::add_curve_through(network, locations, CGAL::parameters::is_closed(i >= 5));
                           FG::order_overlapping_curves(network);
                           shorten_and_add(network, summary);
                           std::vector<std::pair<Surface::Face_index, std::array<double, 3>>> in_faces;
                           FG::Curve_extractor<Setting<Certified>::Network>(network).face_locations(
                               0_c, s.mesh, std::back_inserter(in_faces));
                           for(const auto& [face, weights] : in_faces) {
                             summary.results.add(static_cast<long long>(face));
                             for(double weight : weights)
                               summary.lengths.add(weight);
                           }
                           network.free_nodes(0_c);
                           shorten_and_add(network, summary);
                         });
                         network.clear();
                         s.triangulation.rollback();
                       }
                     });
}

// Polylines that are drawn face by face.
BOOST_AUTO_TEST_CASE(polylines)
{
  compare<Certified>("polylines", Depends_on::ARITHMETIC, [](Setting<Certified>& s, Summary& summary, Result&) {
    for(int i = 0; i < 8; ++i) {
      const bool is_closed = i % 2 == 1;
      std::vector<FG::Surface_location> polyline;
      summary.attempt([&] {
        polyline =
            FG::complete_polyline(s.triangulation, s.random_locations(4), CGAL::parameters::is_closed(is_closed));
        summary.add(polyline);
        const auto snapped = FG::snap_polyline(s.triangulation, polyline, CGAL::parameters::is_closed(is_closed));
        summary.results.add_all(snapped);
      });
      Setting<Certified>::Network network(s.triangulation);
      summary.attempt([&] {
        FG::draw_polyline(network, polyline, CGAL::parameters::is_closed(is_closed));
        FG::order_overlapping_curves(network);
        summary.add_curves(network);
        shorten_and_add(network, summary);
        network.free_nodes(0_c);
        shorten_and_add(network, summary);
      });
      network.clear();
      s.triangulation.rollback();
    }
  });
}

// Splines, which are not part of a triangulation while they are refined.
BOOST_AUTO_TEST_CASE(free_splines)
{
  compare<Certified>("free_splines", Depends_on::ARITHMETIC, [](Setting<Certified>& s, Summary& summary, Result&) {
    for(auto kind : {FG::Spline_kind::BEZIER, FG::Spline_kind::CUBIC_B_SPLINE, FG::Spline_kind::CLOSED_CUBIC_B_SPLINE})
    {
      const auto points = s.random_locations(4);
      summary.attempt([&] {
        FG::Geodesic_spline<Certified> spline(s.triangulation, points, kind);
        summary.results.add(spline.refine(0.02, 2));
        summary.lengths.add(spline.polygon_length());
        summary.add(spline.finish());
        summary.add(spline.report());
        summary.results.add(static_cast<long long>(spline.report().curves[0].verdict));
      });
    }
  });
}

// The same drawn into a network.
BOOST_AUTO_TEST_CASE(drawn_splines)
{
  compare<Certified>("drawn_splines", Depends_on::ARITHMETIC, [](Setting<Certified>& s, Summary& summary, Result&) {
    for(auto kind : {FG::Spline_kind::BEZIER, FG::Spline_kind::CUBIC_B_SPLINE, FG::Spline_kind::CLOSED_CUBIC_B_SPLINE})
    {
      const auto points = s.random_locations(4);
      Setting<Certified>::Network network(s.triangulation);
      summary.attempt([&] {
        FG::Geodesic_spline<Certified> spline(s.triangulation, points, kind);
        spline.refine(0.02, 2);
        FG::add_curve_along(network, spline.finish(),
                            CGAL::parameters::is_closed(kind == FG::Spline_kind::CLOSED_CUBIC_B_SPLINE));
        FG::order_overlapping_curves(network);
        summary.add_curves(network);
        shorten_and_add(network, summary);
      });
      network.clear();
      s.triangulation.rollback();
    }
  });
}

// ---------------------------------------------------------------- trees

// Geodesic trees, and what makes their paths shortest.
BOOST_AUTO_TEST_CASE(trees) { compare<Certified>("trees", Depends_on::ARITHMETIC, Add_trees{3}); }

// The same by predicates in double.
BOOST_AUTO_TEST_CASE(plain_trees) { compare<Plain>("plain_trees", Depends_on::ARITHMETIC, Add_trees{3}); }

// After vertices were inserted, of which the search for shortest paths knows nothing.
BOOST_AUTO_TEST_CASE(trees_of_refined_meshes)
{
  compare<Certified>("trees_of_refined_meshes", Depends_on::ARITHMETIC,
                     [](Setting<Certified>& s, Summary& summary, Result& extra) {
                       FG::Refinement_options options;
                       options.maximum_insertions = 60;
                       FG::refine(s.triangulation, options);
                       Add_trees{3}(s, summary, extra);
                     });
}

// ---------------------------------------------------------------- among lies

// What happens after a wrong answer of a predicate: rollbacks, limits and refusals, in each algorithm that has its own.
BOOST_AUTO_TEST_CASE(hostile_paths) { compare_among_lies("hostile_paths", Add_paths{8}); }

#ifndef _GLIBCXX_DEBUG // as for stopped_paths
BOOST_AUTO_TEST_CASE(hostile_stopped_paths) { compare_among_lies("hostile_stopped_paths", Add_stopped_curves()); }
#endif

BOOST_AUTO_TEST_CASE(hostile_shortest_paths) { compare_among_lies("hostile_shortest_paths", Add_shortest_paths{6}); }

BOOST_AUTO_TEST_CASE(hostile_networks) { compare_among_lies("hostile_networks", Add_networks{2}); }

BOOST_AUTO_TEST_CASE(hostile_trees) { compare_among_lies("hostile_trees", Add_trees{2}); }
