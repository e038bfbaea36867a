// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Paths of several classes between points that are not vertices.

#include "closed_forms.h"
#include "generated_meshes.h"
#include "mesh_soup.h"

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/shortest_paths_by_class.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = Mesh::Face_index;
using Location = std::pair<Face, std::array<double, 3>>;

struct Found
{
  std::vector<std::vector<Point>> paths;
  FG::Paths_by_class_report<Mesh> report;
};

template <class Source, class Target>
Found found(const Mesh& mesh, const Source& source, const Target& target, std::size_t number)
{
  Found result;
  result.report = FG::shortest_paths_by_class(mesh, source, target, number, std::back_inserter(result.paths)).report;
  return result;
}

double length_of(const std::vector<Point>& points)
{
  double result = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    result += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
  return result;
}

// A face split at a point: the mesh, of which the point is the last vertex.
Mesh_soup with_vertex(Mesh_soup soup, std::size_t face, const std::array<double, 3>& weights)
{
  const Corners corners = soup.triangles[face];
  Coordinates point = {0, 0, 0};
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t k = 0; k < 3; ++k)
      point[k] += weights[i] * soup.points[static_cast<std::size_t>(corners[i])][k];
  const int v = static_cast<int>(soup.points.size());
  soup.points.push_back(point);
  soup.triangles[face] = {corners[0], corners[1], v};
  soup.triangles.push_back({corners[1], corners[2], v});
  soup.triangles.push_back({corners[2], corners[0], v});
  return soup;
}

// Weights in the order of a face's halfedges of those in the order of its corners.
Location location(const Mesh& mesh, const Mesh_soup& soup, std::size_t face, const std::array<double, 3>& weights)
{
  Location result = {Face(static_cast<Mesh::size_type>(face)), {{0, 0, 0}}};
  auto h = mesh.halfedge(result.first);
  for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
    for(std::size_t k = 0; k < 3; ++k)
      if(static_cast<int>(mesh.source(h)) == soup.triangles[face][k])
        result.second[i] = weights[k];
  return result;
}

} // namespace

// As on a mesh in which the points are vertices.
BOOST_AUTO_TEST_CASE(classes_between_points_are_those_of_a_mesh_with_these_vertices)
{
  const std::array<double, 3> v = {{0.25, 0.25, 0.5}}, w = {{0.5, 0.125, 0.375}};
  for(const Mesh_soup& soup : {cylinder(9, 4, 1.25, 3), torus(7, 5, 3, 1), grid_with_hole(6, 6, 2, 4, 2, 4)})
    for(const auto& [f, g] : std::vector<std::pair<std::size_t, std::size_t>>{{3, 20}, {5, 6}, {30, 11}}) {
      const Mesh mesh = to_mesh<Mesh>(soup);
      const Location s = location(mesh, soup, f, v), t = location(mesh, soup, g, w);
      const Found paths = found(mesh, s, t, 3);
      Mesh_soup split = with_vertex(soup, f, v);
      const int a = static_cast<int>(split.points.size()) - 1;
      split = with_vertex(split, g, w);
      const int b = static_cast<int>(split.points.size()) - 1;
      const Mesh refined = to_mesh<Mesh>(split);
      const Found expected = found(refined, Mesh::Vertex_index(static_cast<Mesh::size_type>(a)),
                                   Mesh::Vertex_index(static_cast<Mesh::size_type>(b)), 3);
      BOOST_TEST(paths.report.is_confirmed());
      BOOST_TEST_REQUIRE(paths.paths.size() == expected.paths.size());
      for(std::size_t i = 0; i < paths.paths.size(); ++i) {
        const double length = paths.report.paths[i].length;
        BOOST_TEST(std::abs(length - expected.report.paths[i].length) <= 1e-11 * length);
        BOOST_TEST(std::abs(length_of(paths.paths[i]) - length) <= 1e-11 * length);
        BOOST_TEST(paths.report.paths[i].shortening.curves.front().point_distances.size() == 2u);
        for(const auto h : paths.report.classes[i].edge_path)
          BOOST_TEST(mesh.is_valid(h));
      }
      std::vector<Point> shortest;
      BOOST_TEST(std::abs(FG::shortest_path(mesh, s, t, std::back_inserter(shortest)).length() -
                          paths.report.paths.front().length) <= 1e-11);
    }
}

// On the side of a cylinder, which is a prism, paths that wind around it are straight when it is unrolled.
BOOST_AUTO_TEST_CASE(loops_at_a_point_wind_around_a_cylinder)
{
  const int n = 9;
  const Mesh_soup soup = cylinder(n, 4, 1.25, 3);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Location at = location(mesh, soup, 10, {{0.25, 0.25, 0.5}});
  const Found loops = found(mesh, at, at, 3);
  BOOST_TEST(loops.report.is_confirmed());
  BOOST_TEST_REQUIRE(loops.paths.size() == 3u);
  BOOST_TEST(loops.report.paths[0].length == 0);
  for(std::size_t i = 1; i < 3; ++i) {
    BOOST_TEST(std::abs(loops.report.paths[i].length - n * polygon_side(n, 1.25)) <= 1e-11);
    BOOST_TEST((loops.paths[i].front() == loops.paths[i].back()));
  }
}

BOOST_AUTO_TEST_CASE(locations_at_vertices_have_the_classes_of_vertices)
{
  const Mesh_soup soup = torus(7, 5, 3, 1);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Location s = location(mesh, soup, 3, {{0, 1, 0}}), t = location(mesh, soup, 20, {{0, 0, 1}});
  const Mesh::Vertex_index v(static_cast<Mesh::size_type>(soup.triangles[3][1])),
      w(static_cast<Mesh::size_type>(soup.triangles[20][2]));
  const Found expected = found(mesh, v, w, 3), paths = found(mesh, s, t, 3), mixed = found(mesh, mesh.point(v), w, 3);
  BOOST_TEST((paths.paths == expected.paths));
  BOOST_TEST((mixed.paths == expected.paths));
  for(std::size_t i = 0; i < 3; ++i) {
    BOOST_TEST(paths.report.paths[i].lower_bound == expected.report.paths[i].lower_bound);
    BOOST_TEST((paths.report.classes[i].edge_path == expected.report.classes[i].edge_path));
  }
}

BOOST_AUTO_TEST_CASE(classes_between_bad_ends_are_refused)
{
  Mesh mesh = to_mesh<Mesh>(torus(7, 5, 3, 1));
  const Location good = {Face(0), {{0.25, 0.5, 0.25}}};
  BOOST_CHECK_THROW(found(mesh, good, Location(Mesh::null_face(), good.second), 2), FG::Invalid_location_error);
  const auto a = mesh.add_vertex(Point(9, 0, 0)), b = mesh.add_vertex(Point(10, 0, 0)),
             c = mesh.add_vertex(Point(9, 1, 0));
  const Location other = {mesh.add_face(a, b, c), {{0.25, 0.5, 0.25}}};
  BOOST_CHECK_THROW(found(mesh, good, other, 2), FG::Disconnected_endpoints_error);
  std::vector<std::vector<Point>> paths;
  BOOST_CHECK_THROW(FG::shortest_paths_by_class(mesh, good, Point(0, 0, 5), 2, std::back_inserter(paths),
                                                CGAL::parameters::greatest_point_distance(1)),
                    FG::Distant_point_error);
}
