// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Faces without area that fold two vertices onto one place, with no edge between them.

#include "closed_forms.h"
#include "descriptors.h"
#include "test_contracted_surface/zero_edges.h"

#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace Flip_geodesics_test;

namespace {

bool is_between(const Coordinates& p, const Coordinates& q, const Coordinates& r)
{
  double dot = 0, cross = 0;
  for(int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    dot += (p[i] - q[i]) * (r[i] - q[i]);
    cross += std::abs((p[i] - q[i]) * (r[j] - q[j]) - (p[j] - q[j]) * (r[i] - q[i]));
  }
  return cross == 0 && dot < 0;
}

bool has_edge(const Mesh_soup& soup, int v, int w)
{
  return std::any_of(soup.triangles.begin(), soup.triangles.end(), [=](const Corners& t) {
    return std::count(t.begin(), t.end(), v) + std::count(t.begin(), t.end(), w) == 2;
  });
}

/* As `split_vertex()`, where v lies between c and d: the two degenerate faces share the edge from c to d. */
int fold_vertex(Mesh_soup& soup, int v, int c, int d)
{
  const int w = split_vertex(soup, v, c, d);
  soup.triangles.pop_back();
  soup.triangles.back() = {v, c, d};
  soup.triangles.push_back({c, w, d});
  return w;
}

/* Splits and folds vertices of a closed mesh at random, also those that were split and folded before. */
Mesh_soup fold_at_random(Mesh_soup soup, int count, unsigned seed)
{
  Random_numbers random(seed);
  while(count > 0) {
    const int v = random.below(static_cast<int>(soup.points.size()));
    std::vector<int> outgoing_halfedges;
    for(const auto& outgoing_halfedge : ring(soup, v))
      outgoing_halfedges.push_back(outgoing_halfedge.first);
    const int c = outgoing_halfedges[random.below(static_cast<int>(outgoing_halfedges.size()))];
    const int d = outgoing_halfedges[random.below(static_cast<int>(outgoing_halfedges.size()))];
    if(c == d || has_edge(soup, c, d))
      continue;
    if(is_between(soup.points[c], soup.points[v], soup.points[d]))
      fold_vertex(soup, v, c, d);
    else if(random.below(8) == 0)
      split_vertex(soup, v, c, d);
    else
      continue;
    --count;
  }
  return soup;
}

std::multiset<std::multiset<Coordinates>> faces_of(const Mesh_soup& soup)
{
  std::multiset<std::multiset<Coordinates>> result;
  for(const Corners& t : soup.triangles)
    result.insert({soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]});
  return result;
}

std::multiset<std::multiset<Coordinates>> faces_of(const Triangulation& triangulation)
{
  const auto& input = triangulation.input();
  const auto place = [&](FG::Input_halfedge_index h) {
    return Coordinates(triangulation.metric().place(input, input.tail(h)));
  };
  std::multiset<std::multiset<Coordinates>> result;
  for(FG::Input_halfedge_index h(0); h.idx() < input.number_of_halfedges(); ++h) {
    const FG::Input_halfedge_index hn = input.next(h), hp = input.next(hn);
    if(!input.is_border(h) && h < hn && h < hp)
      result.insert({place(h), place(hn), place(hp)});
  }
  return result;
}

// A grid whose columns stand at 0, 1, 2, 3, 4, 6, 7, 8, 9. The vertex (4, 4) is folded along its row, from 3 to 6.
struct Folded_grid
{
  static constexpr int n = 8;
  Mesh_soup soup = mapped(flat_grid(n, n, Diagonal_rule::RISING), [](const Coordinates& p) {
    return Coordinates{p[0] > 4 ? p[0] + 1 : p[0], p[1], p[2]};
  });
  int v = grid_vertex(n, 4, 4), c = grid_vertex(n, 5, 4), d = grid_vertex(n, 3, 4);
  int w = fold_vertex(soup, v, c, d);
};

// Where places on what is left of a mesh are in the row of folded vertices.
struct Row_of_places
{
  Mesh mesh;
  Triangulation left;

  explicit Row_of_places(const Mesh_soup& soup)
    : mesh(to_mesh<Mesh>(soup))
    , left(contracted(mesh))
  {
  }

  FG::Input_halfedge_index halfedge(int a, int b) const
  {
    return FG::Input_halfedge_index(static_cast<FG::Index>(mesh.halfedge(vertex(a), vertex(b))));
  }

  double x_of(const FG::Surface_location& place) const
  {
    const Point q = FG::point_in_space(left, FG::surface_point(left, FG::internal::location_on_surface(left, place)));
    BOOST_CHECK_EQUAL(q.y(), 4);
    return q.x();
  }

  // All over an edge between vertices of the row, and the face beside it, told from each of its halfedges.
  void check_beside(int a, int b) const
  {
    const FG::Input_halfedge_index h = halfedge(a, b);
    const double tail = mesh.point(vertex(a)).x(), head = mesh.point(vertex(b)).x(),
                 apex = mesh.point(mesh.target(mesh.next(mesh.halfedge(vertex(a), vertex(b))))).x();
    for(double t : {0.125, 0.25, 0.5, 0.75, 0.875}) {
      BOOST_CHECK_CLOSE_FRACTION(x_of({h, {{1 - t, t, 0}}}), (1 - t) * tail + t * head, 1e-15);
      std::array<double, 3> weights = {{0.75 * (1 - t), 0.75 * t, 0.25}};
      FG::Input_halfedge_index side = h;
      for(int turn = 0; turn < 3; ++turn) {
        BOOST_CHECK_CLOSE_FRACTION(x_of({side, weights}), 0.75 * ((1 - t) * tail + t * head) + 0.25 * apex, 1e-15);
        std::rotate(weights.begin(), weights.begin() + 1, weights.end());
        side = left.input().uncontracted().next(side);
      }
    }
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(folded_faces_are_gone)
{
  for(unsigned seed = 1; seed < 25; ++seed) {
    const Mesh_soup before = seed % 2 == 0 ? cube(3) : octahedron(4);
    const Mesh_soup soup = fold_at_random(before, 3 * static_cast<int>(seed), seed);
    const Mesh mesh = to_mesh<Mesh>(soup);
    const Triangulation left = contracted(mesh);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      BOOST_CHECK(left.input().is_contracted());
      BOOST_CHECK(!left.input().has_split_point());
      BOOST_CHECK(faces_of(left) == faces_of(before));
    }
  }
}

BOOST_AUTO_TEST_CASE(curves_over_folded_faces_are_proven)
{
  const int n = 4;
  int met = 0;
  for(unsigned seed = 0; seed < 10; ++seed) {
    const Mesh_soup soup = fold_at_random(cube(n), 60, seed);
    const Mesh mesh = to_mesh<Mesh>(soup);
    Random_numbers random(seed);
    for(int i = 0; i < 10; ++i) {
      const int last = static_cast<int>(soup.points.size()) - 1;
      const int s = random.below(last + 1), t = random.below(last + 1);
      if(soup.points[s] == soup.points[t])
        continue;
      std::vector<Point> points;
      const FG::Curve_report curve =
          FG::geodesic_path(mesh, vertex(s), vertex(t), std::back_inserter(points)).report.curves.front();
      BOOST_TEST_CONTEXT("seed " << seed << " from " << s << " to " << t)
      {
        BOOST_CHECK(curve.status == FG::Shortening_status::LOCALLY_SHORTEST);
        BOOST_CHECK(curve.verdict == FG::Verdict::PROVEN);
        BOOST_CHECK_CLOSE_FRACTION(length(points), curve.length, 1e-12);
        BOOST_CHECK_GT(curve.length, box_distance(n, n, n, soup.points[s], soup.points[t]) * (1 - 1e-12));
        met += curve.are_zero_edges_contracted ? 1 : 0;
      }
    }
  }
  BOOST_CHECK_GT(met, 5);
}

// The shortest path from v to w, at the same place, is no path through the folded faces.
BOOST_AUTO_TEST_CASE(folded_vertices_are_one_place)
{
  const Folded_grid grid;
  const Mesh mesh = to_mesh<Mesh>(grid.soup);
  std::vector<Point> points;
  const auto of = [&](int s, int t) {
    points.clear();
    return FG::geodesic_path(mesh, vertex(s), vertex(t), std::back_inserter(points)).report.curves.front();
  };
  const FG::Curve_report in_place = of(grid.v, grid.w);
  BOOST_CHECK(in_place.status == FG::Shortening_status::CONTRACTED);
  BOOST_CHECK(in_place.are_zero_edges_contracted);
  BOOST_CHECK_EQUAL(in_place.length, 0);
  const FG::Curve_report across = of(grid_vertex(grid.n, 4, 3), grid_vertex(grid.n, 4, 5));
  BOOST_CHECK(across.verdict == FG::Verdict::PROVEN);
  BOOST_CHECK_EQUAL(across.length, 2);
}

BOOST_AUTO_TEST_CASE(places_on_folded_faces_are_on_what_they_lead_along)
{
  const Folded_grid grid;
  const Row_of_places row(grid.soup);
  const Mesh& mesh = row.mesh;
  const Triangulation& left = row.left;
  row.check_beside(grid.c, grid.d);
  row.check_beside(grid.d, grid.c);
  const Vertex_sequence along = {FG::Vertex_index(grid.c), FG::Vertex_index(grid.d)};
  const std::vector<FG::Halfedge_index> chain = FG::internal::halfedges_on_surface(left, along, false);
  BOOST_REQUIRE_EQUAL(chain.size(), 2);
  BOOST_CHECK_EQUAL(left.tail(chain[0]), along[0]);
  BOOST_CHECK_EQUAL(left.head(chain[0]), left.index(vertex(grid.v)));
  BOOST_CHECK_EQUAL(left.head(chain[1]), along[1]);

  const FG::Surface_location on_fold = {row.halfedge(grid.c, grid.d), {{0.5, 0.5, 0}}},
                             below = {row.halfedge(grid_vertex(8, 4, 2), grid_vertex(8, 5, 2)), {{1, 0, 0}}};
  std::vector<Point> points;
  const FG::Curve_report curve =
      FG::geodesic_path_through(mesh, std::vector<FG::Surface_location>{on_fold, below}, std::back_inserter(points))
          .report.curves.front();
  BOOST_CHECK(curve.verdict == FG::Verdict::PROVEN);
  BOOST_CHECK_CLOSE_FRACTION(curve.length, std::hypot(0.5, 2), 1e-12);
}

// Without being asked for, nothing is contracted: then the status says what is in the way.
BOOST_AUTO_TEST_CASE(curves_that_are_bent_by_folded_faces_are_told)
{
  const Folded_grid grid;
  const Mesh mesh = to_mesh<Mesh>(grid.soup);
  Triangulation strict(mesh, Metric(mesh.points()));
  Network network(strict);
  const FG::Vertex_index v(grid.v), w(grid.w);
  strict.flip(FG::internal::halfedge_between(strict, FG::Vertex_index(grid.c), FG::Vertex_index(grid.d)));
  network.add_curve(FG::halfedges_through(strict, Vertex_sequence{v, w}));
  const FG::Shortening_report report = FG::shorten(network);
  BOOST_CHECK(report.curves[0].status == FG::Shortening_status::DEGENERATE_FACES);
  BOOST_CHECK(report.curves[0].verdict == FG::Verdict::BENT_SEGMENT);
  BOOST_CHECK(!report.is_complete());
  BOOST_CHECK(FG::internal::are_curves_folded(strict, report));
  BOOST_CHECK(!FG::internal::are_curves_folded(contracted(mesh), report));
  FG::Shortening_report straight = report;
  straight.curves[0].status = FG::Shortening_status::LOCALLY_SHORTEST;
  BOOST_CHECK(!FG::internal::are_curves_folded(strict, straight));
  straight.curves[0].status = FG::Shortening_status::PRECISION_LIMIT;
  BOOST_CHECK(FG::internal::are_curves_folded(strict, straight));
  const Mesh regular = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  BOOST_CHECK(!FG::internal::are_curves_folded(Triangulation(regular, Metric(regular.points())), straight));
}

// The folded vertices are met when a curve is finished: what was computed until then is not written.
BOOST_AUTO_TEST_CASE(results_are_written_once)
{
  const Folded_grid grid;
  const Mesh mesh = to_mesh<Mesh>(grid.soup);
  int repeated = 0;
  const auto check = [&](const FG::Shortening_report& report, const std::vector<Point>& points) {
    repeated += report.curves.front().are_zero_edges_contracted ? 1 : 0;
    BOOST_CHECK_SMALL(report.curves.front().length - length(points), 1e-12);
  };
  for(const Vertex through : mesh.vertices())
    for(const Vertex from : mesh.vertices_around_target(mesh.halfedge(through)))
      for(const Vertex to : mesh.vertices_around_target(mesh.halfedge(through))) {
        if(!(from < to))
          continue;
        const std::vector<Vertex> way = {from, through, to};
        std::vector<std::vector<Point>> curves;
        const auto report =
            FG::geodesic_network(mesh, std::vector<std::vector<Vertex>>{way}, std::back_inserter(curves), exactly)
                .report;
        BOOST_REQUIRE_EQUAL(curves.size(), 1);
        check(report, curves.front());
        std::vector<Point> points;
        check(FG::geodesic_path_through(mesh, way, std::back_inserter(points), exactly).report, points);
        points.clear();
        const auto np = CGAL::parameters::geom_traits(Traits()).number_of_iterations(1);
        check(FG::geodesic_spline(mesh, way, FG::Spline_kind::BEZIER, std::back_inserter(points), np).report, points);
      }
  BOOST_CHECK_GT(repeated, 0);
}

// Faces between which lies a needle, and faces that are folded on folded ones.
BOOST_AUTO_TEST_CASE(folded_faces_lie_about_others)
{
  Folded_grid grid;
  const int above = grid_vertex(grid.n, 5, 5);
  const int split = split_vertex(grid.soup, grid.c, grid.d, above);
  const Row_of_places split_row(grid.soup);
  BOOST_CHECK_EQUAL(split_row.left.index(vertex(grid.c)), split_row.left.index(vertex(split)));
  for(int c : {grid.c, split}) {
    split_row.check_beside(c, grid.d);
    split_row.check_beside(grid.d, c);
  }

  Folded_grid twice;
  const int e = grid_vertex(twice.n, 6, 4), f = fold_vertex(twice.soup, twice.c, e, twice.d);
  const Row_of_places row(twice.soup);
  BOOST_CHECK_EQUAL(row.left.index(vertex(twice.c)), row.left.index(vertex(f)));
  BOOST_CHECK_EQUAL(row.left.index(vertex(twice.v)), row.left.index(vertex(twice.w)));
  row.check_beside(e, twice.d);
  row.check_beside(twice.d, e);
  for(int c : {twice.c, f}) {
    row.check_beside(c, twice.d);
    row.check_beside(twice.d, c);
  }
}

// Faces that share a long side, the edge from 0 to 1, with their other vertices anywhere near it.
BOOST_AUTO_TEST_CASE(faces_on_one_edge_need_not_be_folded)
{
  struct Case
  {
    std::array<double, 2> second, third; // in the plane
    bool is_folded;
  };
  const double tiny = 0x1p-40;
  for(const Case& c :
      {Case{{{1, 0}}, {{1, 0}}, true}, Case{{{1, 0}}, {{std::nextafter(1, 2), 0}}, false},
       Case{{{1, 0}}, {{3, 0}}, false}, Case{{{1, 1e-9}}, {{1, 0}}, false}, Case{{{1, 0}}, {{1, -1e-9}}, false},
       Case{{{4 + tiny, 0}}, {{4 + tiny, 0}}, false}, Case{{{-tiny, 0}}, {{-tiny, 0}}, false}})
  {
    const Mesh mesh = to_mesh<Mesh>(Mesh_soup{
        {{0, 0, 0}, {4, 0, 0}, {c.second[0], c.second[1], 0}, {c.third[0], c.third[1], 0}, {2, -2, 0}, {2, 2, 0}},
        {{0, 1, 2}, {1, 0, 3}, {0, 2, 5}, {2, 1, 5}, {0, 4, 3}, {3, 4, 1}}});
    const Triangulation triangulation = contracted(mesh);
    const auto& left = triangulation.input();
    BOOST_CHECK_EQUAL(left.is_contracted(), c.is_folded);
    BOOST_CHECK_EQUAL(left.contracted_vertex(2_v) == left.contracted_vertex(3_v), c.is_folded);
  }
}

// By lengths, too: 2 and 3 are in one place on the edge from 0 to 1.
BOOST_AUTO_TEST_CASE(lengths_tell_what_is_folded)
{
  using Lengths = std::map<boost::graph_traits<Mesh>::edge_descriptor, double>;
  using Length_metric = FG::Edge_length_metric<Mesh, boost::const_associative_property_map<Lengths>>;
  for(double share : {1.0, 1.5, 2.0}) {
    const Mesh mesh = to_mesh<Mesh>(Mesh_soup{{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, -1, 0}, {2, -2, 0}, {2, 2, 0}},
                                              {{0, 1, 2}, {1, 0, 3}, {0, 2, 5}, {2, 1, 5}, {0, 4, 3}, {3, 4, 1}}});
    Lengths lengths;
    for(const auto e : edges(mesh)) {
      const int u = static_cast<int>(source(e, mesh)), v = static_cast<int>(target(e, mesh)), last = (std::max)(u, v);
      const double from_0 = last == 2 ? 1.5 : share;
      lengths[e] = last > 3 ? 3 : (last == 1 ? 4 : ((std::min)(u, v) == 0 ? from_0 : 4 - from_0));
    }
    const Length_metric metric(mesh, boost::const_associative_property_map<Lengths>(lengths));
    const FG::Numbered_mesh<Mesh> input(mesh);
    const auto left = FG::internal::contracted(input, FG::internal::Contracted_metric<Length_metric>{metric, input});
    BOOST_CHECK_EQUAL(left.is_contracted(), share == 1.5);
    BOOST_CHECK_EQUAL(left.contracted_vertex(2_v) == left.contracted_vertex(3_v), share == 1.5);
  }
}

// By lengths, two faces of a tetrahedron fold 2 and 3 onto one place. The edge between these, of length 1, is a loop.
// The other faces are equilateral. Over the middle of the loop the path from 0 to 1 is as long as two of their heights.
BOOST_AUTO_TEST_CASE(an_edge_between_vertices_in_one_place_is_a_loop)
{
  using Lengths = std::map<boost::graph_traits<Mesh>::edge_descriptor, double>;
  using Map = boost::const_associative_property_map<Lengths>;
  const Mesh mesh = to_mesh<Mesh>(
      Mesh_soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  Lengths lengths;
  for(const auto e : edges(mesh))
    lengths[e] = (std::max)(source(e, mesh), target(e, mesh)) == vertex(1) ? 2 : 1;
  const FG::Edge_length_metric<Mesh, Map> metric(mesh, Map(lengths));
  const auto path_between = [&](int s, int t) {
    std::vector<FG::Curve_place<Mesh>> places;
    return FG::shortest_path(mesh, vertex(s), vertex(t), std::back_inserter(places), CGAL::parameters::metric(metric))
        .report;
  };
  const FG::Shortest_path_report across = path_between(0, 1), in_place = path_between(2, 3);
  BOOST_CHECK_SMALL(across.length - std::sqrt(3.0), 1e-14);
  BOOST_CHECK(across.is_confirmed());
  BOOST_CHECK_EQUAL(in_place.length, 0);
  BOOST_CHECK(in_place.status() == FG::Shortening_status::CONTRACTED);
  BOOST_CHECK(in_place.shortening.curves.front().are_zero_edges_contracted);
}

// The segment from 6 to 7 has 13 in its middle, but the faces between lead there only past its end, 7.
BOOST_AUTO_TEST_CASE(vertices_beyond_a_tip_are_not_touched)
{
  Mesh_soup soup = flat_grid(5, 5, Diagonal_rule::FALLING);
  soup.points[12] = {2, 3, 0};
  soup.points[7] = {1.5, 2.5, 0};
  const Mesh mesh = to_mesh<Mesh>(soup);
  std::vector<Point> points;
  const FG::Curve_report curve =
      FG::geodesic_path(mesh, vertex(6), vertex(7), std::back_inserter(points)).report.curves.front();
  BOOST_CHECK(curve.verdict == FG::Verdict::PROVEN);
  BOOST_CHECK_EQUAL(curve.length, std::hypot(1.5, 1.5));
}
