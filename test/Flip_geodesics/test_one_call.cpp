// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the one-call functions take and give: ends of each kind, outputs of each form in step with one another, metrics,
// visitors, meshes without points of their own, and results in property maps.

#define BOOST_TEST_MODULE one_call

#include "test_one_call/checked_curves.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(all_forms_of_a_path_are_in_step)
{
  for(const Surface& mesh : {bumpy_sphere_mesh(), torus_mesh()})
    for(const auto& [v, w] : random_pairs(mesh, 20)) {
      std::vector<Point> points;
      std::vector<Face_location> places;
      std::vector<Curve_point> curve;
      const auto in_space = FG::geodesic_path(mesh, v, w, std::back_inserter(points));
      const auto in_faces = FG::geodesic_path(mesh, v, w, std::back_inserter(places));
      const auto with_all = FG::geodesic_path(mesh, v, w, std::back_inserter(curve));
      check_same_points(points, curve);
      check_same_places(places, curve);
      check_curve_points(mesh, curve);
      BOOST_CHECK_EQUAL(points.front(), mesh.point(v));
      BOOST_CHECK_EQUAL(points.back(), mesh.point(w));
      double length = 0;
      for(std::size_t i = 0; i + 1 < points.size(); ++i)
        length += distance(points[i], points[i + 1]);
      BOOST_CHECK_CLOSE(in_space.length(), length, 1e-9);
      BOOST_CHECK_EQUAL(in_space.length(), in_space.report.curves.at(0).length);
      BOOST_CHECK_EQUAL(in_faces.length(), in_space.length());
      BOOST_CHECK_EQUAL(with_all.length(), in_space.length());
      BOOST_CHECK(with_all.status() == FG::Shortening_status::LOCALLY_SHORTEST);
    }
}

BOOST_AUTO_TEST_CASE(a_loop_and_curves_come_in_each_form)
{
  const Surface mesh = torus_mesh();
  std::vector<Vertex> ring;
  for(std::size_t i = 0; i < 24; ++i)
    ring.emplace_back(i);
  bool is_ring = true;
  for(std::size_t i = 0; i < ring.size(); ++i)
    is_ring = is_ring && mesh.halfedge(ring[i], ring[(i + 1) % ring.size()]) != Surface::null_halfedge();
  BOOST_REQUIRE(is_ring);
  std::vector<Curve_point> loop;
  std::vector<Point> points;
  FG::geodesic_loop(mesh, ring, std::back_inserter(loop),
                    CGAL::parameters::stop_predicate(FG::Iteration_stop_predicate(3)));
  FG::geodesic_loop(mesh, ring, std::back_inserter(points),
                    CGAL::parameters::stop_predicate(FG::Iteration_stop_predicate(3)));
  check_same_points(points, loop);
  check_curve_points(mesh, loop);
  BOOST_CHECK_EQUAL(loop.front().point, loop.back().point);

  std::vector<std::vector<Curve_point>> curves;
  std::vector<std::vector<Face_location>> places;
  std::vector<Vertex> closed = ring;
  closed.push_back(ring.front());
  const auto result = FG::geodesic_network(mesh, std::vector<std::vector<Vertex>>{closed, {ring[0], ring[1], ring[2]}},
                                           std::back_inserter(curves));
  FG::geodesic_network(mesh, std::vector<std::vector<Vertex>>{closed, {ring[0], ring[1], ring[2]}},
                       std::back_inserter(places));
  BOOST_REQUIRE_EQUAL(curves.size(), 2u);
  BOOST_REQUIRE_EQUAL(result.number_of_curves(), 2u);
  for(std::size_t i = 0; i < 2; ++i) {
    BOOST_CHECK_EQUAL(result.length(i), result.report.curves[i].length);
    BOOST_CHECK(result.status(i) == result.report.curves[i].status);
    BOOST_CHECK(result.verdict(i) == result.report.curves[i].verdict);
    check_same_places(places[i], curves[i]);
    if(!curves[i].empty())
      check_curve_points(mesh, curves[i]);
  }
}

BOOST_AUTO_TEST_CASE(ends_of_all_kinds_can_be_mixed)
{
  const Surface mesh = bumpy_sphere_mesh();
  const Vertex v(3);
  const Face f(40);
  const Face_location inside(f, {{0.25, 0.5, 0.25}});
  const Point above = point_at(mesh, inside) + Vector(CGAL::ORIGIN, point_at(mesh, inside)) * 1e-9;
  Curve_setting::Triangulation triangulation(mesh);
  const FG::Surface_location location = FG::surface_location(triangulation, mesh, inside);
  std::vector<Curve_point> to_face, to_location, to_space, back;
  const auto reference = FG::geodesic_path(mesh, v, inside, std::back_inserter(to_face));
  FG::geodesic_path(mesh, v, location, std::back_inserter(to_location));
  FG::geodesic_path(mesh, v, above, std::back_inserter(to_space), CGAL::parameters::default_values());
  FG::geodesic_path(mesh, above, v, std::back_inserter(back),
                    CGAL::parameters::stop_predicate(FG::Never_stop_predicate()));
  check_curve_points(mesh, to_face);
  check_curve_points(mesh, back);
  BOOST_CHECK_SMALL(distance(to_face.back().point, point_at(mesh, inside)), 1e-12);
  BOOST_REQUIRE_EQUAL(to_face.size(), to_location.size());
  BOOST_REQUIRE_EQUAL(to_face.size(), to_space.size());
  BOOST_REQUIRE_EQUAL(to_face.size(), back.size());
  for(std::size_t i = 0; i < to_face.size(); ++i) {
    BOOST_CHECK_EQUAL(to_face[i].point, to_location[i].point);
    BOOST_CHECK_SMALL(distance(to_face[i].point, to_space[i].point), 1e-7);
    BOOST_CHECK_SMALL(distance(to_face[i].point, back[back.size() - 1 - i].point), 1e-7);
  }
  double length = 0;
  for(std::size_t i = 0; i + 1 < to_face.size(); ++i)
    length += distance(to_face[i].point, to_face[i + 1].point);
  BOOST_CHECK_CLOSE(reference.length(), length, 1e-9);
}

BOOST_AUTO_TEST_CASE(ways_through_points_have_tangents_on_each_leg)
{
  const Surface mesh = torus_mesh();
  const std::vector<Face_location> stations = {
      {Face(3), {{0.2, 0.3, 0.5}}}, {Face(200), {{0.4, 0.3, 0.3}}}, {Face(400), {{0.1, 0.1, 0.8}}}};
  std::vector<Curve_point> curve;
  std::vector<Point> points;
  FG::geodesic_path_through(mesh, stations, std::back_inserter(curve));
  FG::geodesic_path_through(mesh, stations, std::back_inserter(points));
  check_same_points(points, curve);
  check_curve_points(mesh, curve);
  std::size_t met = 0;
  for(const Curve_point& p : curve)
    for(const Face_location& station : stations)
      if(distance(p.point, point_at(mesh, station)) < 1e-12)
        ++met;
  BOOST_CHECK_EQUAL(met, stations.size());
  std::vector<Curve_point> spline;
  FG::geodesic_spline(mesh, stations, FG::Spline_kind::BEZIER, std::back_inserter(spline));
  check_curve_points(mesh, spline);
}

BOOST_AUTO_TEST_CASE(ends_in_different_components_are_named_by_vertices_of_the_mesh)
{
  const Surface mesh = to_mesh<Surface>(disjoint_union(tetrahedron(), tetrahedron()));
  std::vector<Point> points;
  try {
    FG::geodesic_path(mesh, Vertex(0), Face_location(Face(6), {{0.2, 0.3, 0.5}}), std::back_inserter(points));
    BOOST_ERROR("no path connects them");
  } catch(const FG::Disconnected_endpoints_error& error) {
    BOOST_REQUIRE_EQUAL(error.elements().size(), 2u);
    BOOST_CHECK_EQUAL(error.elements()[0], 0u);
    BOOST_CHECK_LT(error.elements()[1], mesh.number_of_vertices());
    BOOST_CHECK_GE(error.elements()[1], mesh.number_of_vertices() / 2);
  }
}

BOOST_AUTO_TEST_CASE(splines_are_halved_a_number_of_times_that_makes_sense)
{
  const Surface mesh = torus_mesh();
  const std::vector<Vertex> controls = {Vertex(0), Vertex(30), Vertex(60)};
  std::vector<Point> points;
  for(int rounds : {-1, 31, std::numeric_limits<int>::max()})
    BOOST_CHECK_THROW(FG::geodesic_spline(mesh, controls, FG::Spline_kind::BEZIER, std::back_inserter(points),
                                          CGAL::parameters::number_of_iterations(rounds)),
                      FG::Invalid_parameter_error);
  BOOST_CHECK(points.empty());
  FG::geodesic_spline(mesh, controls, FG::Spline_kind::BEZIER, std::back_inserter(points),
                      CGAL::parameters::number_of_iterations(0));
  BOOST_CHECK_GE(points.size(), 2u);
}

BOOST_AUTO_TEST_CASE(outputs_need_not_be_assigned)
{
  const Surface mesh = torus_mesh();
  std::size_t count = 0;
  const auto counting = boost::make_function_output_iterator([&count](const Point&) { ++count; });
  std::vector<Point> points;
  FG::geodesic_path(mesh, Vertex(0), Vertex(150), counting);
  FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(points));
  BOOST_CHECK_EQUAL(count, points.size());
}

BOOST_AUTO_TEST_CASE(the_first_vertex_of_a_loop_may_be_repeated)
{
  const Surface mesh = torus_mesh();
  std::vector<Vertex> ring;
  for(std::size_t i = 0; i < 24; ++i)
    ring.emplace_back(i);
  std::vector<Point> points, of_repeated;
  FG::geodesic_loop(mesh, ring, std::back_inserter(points));
  ring.push_back(ring.front());
  FG::geodesic_loop(mesh, ring, std::back_inserter(of_repeated));
  BOOST_CHECK(!points.empty());
  BOOST_CHECK(points == of_repeated);
}

BOOST_AUTO_TEST_CASE(another_metric_decides_what_is_short)
{
  Surface mesh = torus_mesh();
  auto lengths = mesh.add_property_map<Surface::Edge_index, double>("e:length", 0).first;
  for(Surface::Edge_index e : mesh.edges())
    lengths[e] = 3 * distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  const FG::Edge_length_metric<Surface, Surface::Property_map<Surface::Edge_index, double>> tripled(mesh, lengths);
  for(const auto& [v, w] : random_pairs(mesh, 10)) {
    std::vector<Face_location> places, places_of_points;
    std::vector<FG::Curve_place<Surface>> curve;
    const auto result = FG::geodesic_path(mesh, v, w, std::back_inserter(places), CGAL::parameters::metric(tripled));
    FG::geodesic_path(mesh, v, w, std::back_inserter(curve), CGAL::parameters::metric(tripled));
    const auto of_points = FG::geodesic_path(mesh, v, w, std::back_inserter(places_of_points));
    BOOST_REQUIRE_EQUAL(places.size(), curve.size());
    for(std::size_t i = 0; i < places.size(); ++i)
      BOOST_CHECK(places[i] == curve[i].location);
    if(places.size() == places_of_points.size()) // else another of several geodesics was found
      BOOST_CHECK_CLOSE(result.length(), 3 * of_points.length(), 1e-9);
    else
      BOOST_CHECK_LT(std::abs(result.length() - 3 * of_points.length()), 0.3 * result.length());
  }
}

BOOST_AUTO_TEST_CASE(points_of_a_map_and_a_mesh_without_any)
{
  const Mesh_soup soup = bumpy_sphere(4, 0.3, 7);
  const Surface mesh = to_mesh<Surface>(soup);
  const Mesh_archetype plain(soup);
  const Archetype_point_map map = {&plain};
  const std::vector<Mesh_archetype::Vertex> all(vertices(plain).begin(), vertices(plain).end());
  std::vector<Point> points, of_map;
  std::vector<FG::Curve_point<Mesh_archetype, Point>> curve;
  const auto np = CGAL::parameters::vertex_point_map(map);
  const auto direct = FG::geodesic_path(mesh, Vertex(1), Vertex(30), std::back_inserter(points));
  const auto result = FG::geodesic_path(plain, all[1], all[30], std::back_inserter(of_map), np);
  FG::geodesic_path(plain, all[1], all[30], std::back_inserter(curve),
                    CGAL::parameters::stop_predicate(FG::Never_stop_predicate()), np);
  BOOST_CHECK_CLOSE(result.length(), direct.length(), 1e-9);
  BOOST_CHECK_EQUAL(of_map.size(), points.size());
  BOOST_CHECK_EQUAL(curve.size(), points.size());
}

BOOST_AUTO_TEST_CASE(visitors_are_copied_unless_they_are_referred_to)
{
  const Surface mesh = torus_mesh();
  std::vector<Point> points;
  Counting_visitor visitor;
  std::size_t shared = 0;
  visitor.shared = &shared;
  const auto copied =
      FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(points), CGAL::parameters::visitor(visitor));
  BOOST_CHECK_GT(copied.report.flips, 0u);
  BOOST_CHECK_EQUAL(visitor.flips, 0u);
  BOOST_CHECK_EQUAL(shared, copied.report.flips);
  const auto referred = FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(points),
                                          CGAL::parameters::visitor(std::ref(visitor)));
  BOOST_CHECK_EQUAL(visitor.flips, referred.report.flips);
  BOOST_CHECK_EQUAL(referred.report.flips, copied.report.flips);
}

// A visitor that is counted each time it is copied.
struct Copied_visitor : FG::Default_shortening_visitor
{
  explicit Copied_visitor(int& copies)
    : copies(&copies)
  {
  }
  Copied_visitor(const Copied_visitor& other)
    : FG::Default_shortening_visitor(other)
    , copies(other.copies)
  {
    ++*copies;
  }
  Copied_visitor& operator=(const Copied_visitor&) = delete;

  int* copies;
};

BOOST_AUTO_TEST_CASE(a_visitor_is_copied_once)
{
  const Surface mesh = torus_mesh();
  std::vector<Point> points;
  int copies = 0;
  const auto np = CGAL::parameters::visitor(Copied_visitor(copies));
  copies = 0;
  FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(points), np);
  BOOST_CHECK_EQUAL(copies, 1);
}

BOOST_AUTO_TEST_CASE(named_parameters_in_any_order)
{
  namespace params = CGAL::parameters;
  using Traits = FG::Certified_intrinsic_triangulation_traits<CGAL::Kernel_traits<Point>::Kernel>;
  const Surface mesh = torus_mesh();
  const auto metric = params::metric(FG::Embedded_metric<Surface, Surface::Property_map<Vertex, Point>>(mesh.points()));
  const FG::Iteration_stop_predicate three(3);
  const auto stop = params::stop_predicate(three);
  std::size_t flips = 0;
  const auto compute = [&](const auto&... np) {
    std::vector<Point> points;
    const auto result = FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(points), np...);
    BOOST_CHECK_EQUAL(result.report.flip_outs, 3u);
    flips = result.report.flips;
    BOOST_CHECK(result.status() == FG::Shortening_status::ITERATION_LIMIT);
    return points;
  };
  const std::vector<Point> expected = compute(stop);
  BOOST_CHECK(compute(params::stop_predicate(std::cref(three))) == expected);
  Counting_visitor counting;
  const auto visitor = params::visitor(std::ref(counting));
  const auto traits = params::geom_traits(Traits());
  BOOST_CHECK(compute(metric, stop, visitor, traits) == expected);
  BOOST_CHECK(compute(traits, visitor, stop, metric) == expected);
  BOOST_CHECK(compute(visitor, metric, traits, params::default_values(), stop) == expected);
  BOOST_CHECK(compute(params::stop_predicate(three).visitor(std::ref(counting)), metric) == expected);
  BOOST_CHECK(compute(metric, params::visitor(std::ref(counting)).geom_traits(Traits()), stop) == expected);
  BOOST_CHECK_EQUAL(counting.flips, 5 * flips);
}

// What has nothing but what the pages of stop predicates and visitors ask for, not even a copy, is enough.
BOOST_AUTO_TEST_CASE(least_policies_are_enough)
{
  const Surface mesh = torus_mesh();
  const Stop_predicate_archetype few(2), many(1000000);
  const std::vector<std::vector<Vertex>> curves = {{Vertex(0), Vertex(1), Vertex(25), Vertex(49), Vertex(50)},
                                                   {Vertex(80), Vertex(81), Vertex(105), Vertex(106), Vertex(130)}};
  const std::vector<Face_location> stations = {
      {Face(3), {{0.2, 0.3, 0.5}}}, {Face(200), {{0.4, 0.3, 0.3}}}, {Face(400), {{0.1, 0.1, 0.8}}}};
  std::vector<Vertex> ring;
  for(std::size_t i = 72; i < 96; ++i)
    ring.emplace_back(i); // beside the shortest ring

  // Calls `compute(output, stop, np)`, which shortens `runs` times, with both predicates, and compares with `expected`.
  const auto check = [&](const auto& expected, long runs, const auto& compute) {
    for(const Stop_predicate_archetype* stop : {&few, &many}) {
      auto result = expected;
      result.clear();
      Visitor_archetype visitor;
      const FG::Shortening_report report = compute(std::back_inserter(result), CGAL::parameters::stop_predicate(*stop),
                                                   CGAL::parameters::visitor(std::ref(visitor)));
      BOOST_CHECK_GT(visitor.questions(), 0);
      BOOST_CHECK_LE(report.flips, static_cast<std::size_t>(visitor.flips()));
      BOOST_CHECK_EQUAL(report.is_complete(), stop == &many);
      if(stop == &many)
        BOOST_CHECK(result == expected);
      else
        BOOST_CHECK_LE(visitor.steps(), 2 * runs);
    }
  };

  Counting_visitor counting; // so that nothing is straightened first
  std::vector<Point> path, loop, way;
  std::vector<std::vector<Point>> tight;
  FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(path),
                    CGAL::parameters::visitor(std::ref(counting)));
  check(path, 1, [&](auto out, const auto& stop, const auto& np) {
    return FG::geodesic_path(mesh, Vertex(0), Vertex(150), out, stop, np).report;
  });
  FG::geodesic_loop(mesh, ring, std::back_inserter(loop));
  check(loop, 1, [&](auto out, const auto& stop, const auto& np) {
    return FG::geodesic_loop(mesh, ring, out, stop, np).report;
  });
  FG::geodesic_network(mesh, curves, std::back_inserter(tight));
  check(tight, 1, [&](auto out, const auto& stop, const auto& np) {
    return FG::geodesic_network(mesh, curves, out, stop, np).report;
  });
  FG::geodesic_path_through(mesh, stations, std::back_inserter(way));
  check(way, 2, [&](auto out, const auto& stop, const auto& np) {
    return FG::geodesic_path_through(mesh, stations, out, stop, np).report;
  });

  const std::vector<std::pair<Vertex, Vertex>> pairs = {{Vertex(0), Vertex(150)}, {Vertex(7), Vertex(200)}};
  for(const Stop_predicate_archetype* stop : {&few, &many}) {
    std::vector<FG::Geodesic_path_result<Point>> paths;
    Visitor_archetype visitor;
    FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), CGAL::parameters::stop_predicate(*stop),
                       CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_REQUIRE_EQUAL(paths.size(), 2u);
    BOOST_CHECK_GT(visitor.questions(), 0);
    BOOST_CHECK_EQUAL(paths[0].points == path, stop == &many);
    BOOST_CHECK(!paths[1].points.empty());
  }

  Visitor_archetype visitor;
  const auto shortest = FG::shortest_path(mesh, Vertex(0), Vertex(150), CGAL::Emptyset_iterator(),
                                          CGAL::parameters::visitor(std::ref(visitor)));
  BOOST_CHECK(shortest.report.is_confirmed());
  BOOST_CHECK_GT(visitor.questions(), 0);

  Curve_setting setting(torus(24, 14, 2, 1));
  setting.add_path(setting.triangulation.index(Vertex(0)), setting.triangulation.index(Vertex(150)));
  Visitor_archetype of_network;
  const FG::Shortening_report begun = FG::shorten(setting.network, CGAL::parameters::stop_predicate(few),
                                                  CGAL::parameters::visitor(std::ref(of_network)));
  BOOST_CHECK(begun.curves.front().status == FG::Shortening_status::ITERATION_LIMIT);
  BOOST_CHECK_EQUAL(of_network.steps(), 2);
  const FG::Shortening_report finished = FG::shorten(setting.network, CGAL::parameters::stop_predicate(many),
                                                     CGAL::parameters::visitor(std::ref(of_network)));
  BOOST_CHECK(finished.is_complete());
}
