// SPDX-License-Identifier: LGPL-3.0-or-later

#include "checked_curves.h"

using namespace Flip_geodesics_test;
using FG::Verdict;

BOOST_AUTO_TEST_CASE(results_are_proven_without_being_asked)
{
  for(const Mesh_soup& soup : {bumpy_sphere(6, 0.3, 7), cube(4), torus(24, 14, 2, 1)}) {
    const Surface mesh = to_mesh<Surface>(soup);
    for(const auto& [source, target] : random_pairs(mesh, 10)) {
      std::vector<Point> points;
      const auto path = FG::geodesic_path(mesh, source, target, std::back_inserter(points));
      BOOST_CHECK(path.status() == FG::Shortening_status::LOCALLY_SHORTEST);
      BOOST_CHECK(path.verdict() == Verdict::PROVEN);
      const auto shortest = FG::shortest_path(mesh, source, target, std::back_inserter(points));
      BOOST_CHECK(shortest.report.shortening.curves[0].verdict == Verdict::PROVEN);
      BOOST_CHECK(shortest.report.verdict == FG::Verdict::WITHIN_ROUNDING);
    }
  }
}

namespace {

// Traits with a state.
struct Counting_traits : FG::Intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>
{
  std::size_t* count = nullptr; // of the lengths that are asked for

  auto compute_length_object() const
  {
    if(count != nullptr)
      ++*count;
    return FG::Intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>::compute_length_object();
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(traits_are_used_as_they_are_given)
{
  const Surface mesh = torus_mesh();
  std::vector<Point> points;
  std::size_t count = 0;
  Counting_traits traits;
  traits.count = &count;
  FG::geodesic_path(mesh, Vertex(0), Vertex(100), std::back_inserter(points), CGAL::parameters::geom_traits(traits));
  BOOST_CHECK_GT(count, 0u);
}

BOOST_AUTO_TEST_CASE(what_rounds_or_is_not_finished_is_not_proven)
{
  const Surface mesh = torus_mesh();
  std::vector<Point> points;
  const auto rounded = FG::geodesic_path(
      mesh, Vertex(0), Vertex(100), std::back_inserter(points),
      CGAL::parameters::geom_traits(FG::Intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>()));
  BOOST_CHECK(rounded.status() == FG::Shortening_status::LOCALLY_SHORTEST);
  BOOST_CHECK(rounded.verdict() == Verdict::UNDECIDED);
  BOOST_CHECK(!FG::is_confirmed(rounded.verdict()));

  std::vector<Vertex> ring;
  for(std::size_t i = 72; i < 96; ++i)
    ring.emplace_back(i); // beside the shortest ring
  const auto stopped = FG::geodesic_loop(mesh, ring, std::back_inserter(points),
                                         CGAL::parameters::stop_predicate(FG::Iteration_stop_predicate(1)));
  BOOST_CHECK(stopped.status() == FG::Shortening_status::ITERATION_LIMIT);
  BOOST_CHECK(stopped.verdict() == Verdict::BENT_JOINT);

  const Surface sphere = bumpy_sphere_mesh();
  const Halfedge h = *sphere.halfedges().begin();
  const std::vector<Vertex> around_face = {sphere.source(h), sphere.target(h), sphere.target(sphere.next(h))};
  const auto contracted = FG::geodesic_loop(sphere, around_face, std::back_inserter(points));
  BOOST_CHECK(contracted.status() == FG::Shortening_status::CONTRACTED);
  BOOST_CHECK(contracted.verdict() == Verdict::PROVEN);
}

// Legs that are pulled straight each by itself have one verdict together.
BOOST_AUTO_TEST_CASE(ways_and_splines_have_a_verdict)
{
  const Surface mesh = torus_mesh();
  const std::vector<Face_location> stations = {
      {Face(3), {{0.25, 0.25, 0.5}}}, {Face(200), {{0.25, 0.5, 0.25}}}, {Face(400), {{0.125, 0.125, 0.75}}}};
  std::vector<Point> points;
  BOOST_CHECK(FG::geodesic_path_through(mesh, stations, std::back_inserter(points)).verdict() == Verdict::PROVEN);
  std::vector<Curve_point> spline;
  BOOST_CHECK(FG::geodesic_spline(mesh, stations, FG::Spline_kind::BEZIER, std::back_inserter(spline)).verdict() ==
              Verdict::PROVEN);
}

BOOST_AUTO_TEST_CASE(a_report_sums_up_its_curves)
{
  using Status = FG::Shortening_status;
  const auto curve = [](Status status, double length, Verdict verdict) {
    FG::Curve_report result;
    result.status = status;
    result.length = length;
    result.verdict = verdict;
    return result;
  };
  FG::Shortening_report report;
  BOOST_CHECK(report.status() == Status::LOCALLY_SHORTEST);
  BOOST_CHECK(report.verdict() == Verdict::UNDECIDED);
  BOOST_CHECK_EQUAL(report.length(), 0);
  report.curves = {curve(Status::CONTRACTED, 0, Verdict::PROVEN)};
  BOOST_CHECK(report.status() == Status::CONTRACTED);
  BOOST_CHECK(report.verdict() == Verdict::PROVEN);
  report.curves.push_back(curve(Status::LOCALLY_SHORTEST, 2, Verdict::PROBABLE));
  BOOST_CHECK(report.status() == Status::LOCALLY_SHORTEST);
  BOOST_CHECK(report.verdict() == Verdict::PROBABLE);
  report.curves.push_back(curve(Status::LENGTH_LIMIT, 3, Verdict::BENT_JOINT));
  report.curves.push_back(curve(Status::ANGLE_LIMIT, 4, Verdict::UNDECIDED));
  BOOST_CHECK(report.status() == Status::LENGTH_LIMIT);
  BOOST_CHECK(report.verdict() == Verdict::BENT_JOINT);
  BOOST_CHECK_EQUAL(report.length(), 9);
  const Surface mesh = torus_mesh();
  std::vector<std::vector<Point>> curves;
  const auto result =
      FG::geodesic_network(mesh, std::vector<std::vector<Vertex>>{{Vertex(0), Vertex(1)}}, std::back_inserter(curves));
  BOOST_CHECK_EQUAL(result.length(), result.length(0));
  BOOST_CHECK(result.status() == result.status(0));
  BOOST_CHECK(result.verdict() == result.verdict(0));
}
