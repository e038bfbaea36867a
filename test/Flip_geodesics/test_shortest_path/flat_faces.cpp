// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Shortest paths over degenerate faces, in which straight rays get lost.

#include "Curve_setting.h"
#include "flat_tori.h"

#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using Locations = std::vector<std::pair<Surface::Face_index, std::array<double, 3>>>;

// How many of all distances of vertices violate symmetry or the triangle inequality, as shortest ones do not.
int violations(const std::vector<std::vector<double>>& distance)
{
  const std::size_t n = distance.size();
  int result = 0;
  for(std::size_t a = 0; a < n; ++a)
    for(std::size_t b = 0; b < n; ++b) {
      double least = distance[b][a];
      for(std::size_t c = 0; c < n; ++c)
        least = (std::min)(least, distance[a][c] + distance[c][b]);
      result += distance[a][b] > least + 1e-9 ? 1 : 0;
    }
  return result;
}

} // namespace

// Of the tori, the first has faces that fold vertices onto one place, and the second has only others without area.
BOOST_AUTO_TEST_CASE(paths_over_flat_faces_are_as_short_as_others)
{
  for(unsigned seed : {1u, 7u}) {
    const auto mesh = to_mesh<Surface>(torus(4, 4, 3, 1));
    auto lengths = lengths_with_flat_faces(mesh, {1, 2, 3}, seed);
    const Length_metric metric(mesh, Length_map(lengths));
    const std::size_t n = mesh.number_of_vertices();
    std::vector<std::vector<double>> distance(n, std::vector<double>(n, 0));
    int contracted = 0, unconfirmed = 0;
    for(Surface::Vertex_index a : mesh.vertices())
      for(Surface::Vertex_index b : mesh.vertices()) {
        if(a == b)
          continue;
        Locations path;
        const auto result =
            FG::shortest_path(mesh, a, b, std::back_inserter(path),
                              CGAL::parameters::search_limit(FG::Window_limit(500)), CGAL::parameters::metric(metric));
        distance[a][b] = result.length();
        BOOST_TEST(result.length() <= result.report.first_length * (1 + 1e-10));
        BOOST_TEST(result.length() >= result.report.lower_bound * (1 - 1e-10));
        contracted += result.report.shortening.curves.front().are_zero_edges_contracted ? 1 : 0;
        unconfirmed += result.report.is_confirmed() ? 0 : 1;
      }
    BOOST_TEST(violations(distance) == 0);
    BOOST_TEST((contracted > 0) == (seed == 1));
    BOOST_TEST(unconfirmed > 0);
  }
}

// Trees whose paths pass through vertices in one place are grown again where these are contracted.
BOOST_AUTO_TEST_CASE(logarithmic_maps_of_folded_vertices)
{
  int contracted = 0, bent = 0;
  for(unsigned seed = 0; seed < 12; ++seed) {
    const auto mesh = to_mesh<Surface>(torus(4, 4, 3, 1));
    auto lengths = lengths_with_flat_faces(mesh, {1, 2, 3}, seed);
    const Length_metric metric(mesh, Length_map(lengths));
    for(const Surface::Vertex_index source : mesh.vertices()) {
      std::map<Surface::Vertex_index, FG::Polar_coordinates> coordinates;
      const FG::Distances_report report =
          FG::logarithmic_map(mesh, source, boost::make_assoc_property_map(coordinates),
                              CGAL::parameters::search_limit(FG::Window_limit(500)), CGAL::parameters::metric(metric));
      bent += report.status != FG::Shortening_status::LOCALLY_SHORTEST ? 1 : 0;
      contracted += report.vertices < 15 ? 1 : 0;
    }
  }
  BOOST_TEST(contracted > 0);
  BOOST_TEST(bent <= 4); // on a surface that would fall apart, or where other flat faces are in the way
}

// A sheet of two by two cells, both of its sides, whose rows are closer than lengths are told apart: vertices of one
// column are on each other's way, as far as lengths say.
BOOST_AUTO_TEST_CASE(ways_do_not_come_round)
{
  for(double height : {1e-12, 1e-13, 1e-15, 1e-17}) {
    Mesh_soup soup;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        soup.points.push_back({double(i), j * height, 0});
    soup.points.push_back({1, height, 0}); // the middle of the other side
    soup.triangles = {{0, 3, 4}, {0, 4, 1}, {1, 4, 2}, {4, 5, 2}, {3, 6, 4}, {6, 7, 4}, {4, 7, 8}, {4, 8, 5},
                      {0, 9, 3}, {0, 1, 9}, {1, 2, 9}, {9, 2, 5}, {3, 9, 6}, {6, 9, 7}, {9, 8, 7}, {9, 5, 8}};
    const auto mesh = to_mesh<Surface>(soup);
    for(Surface::Vertex_index a : mesh.vertices())
      for(Surface::Vertex_index b : mesh.vertices()) {
        if(a == b)
          continue;
        std::vector<Surface::Point> path;
        const auto result = FG::shortest_path(mesh, a, b, std::back_inserter(path),
                                              CGAL::parameters::search_limit(FG::Window_limit(1000)));
        const double direct = std::abs(mesh.point(a).x() - mesh.point(b).x());
        BOOST_TEST(result.length() >= direct * (1 - 1e-15));
        BOOST_TEST(result.length() <= direct + 4 * height);
      }
  }
}

// With a zero-length edge on one line nothing is left that joins the others, but for a face beside that has an area.
BOOST_AUTO_TEST_CASE(distances_to_what_is_lost_are_not_confirmed)
{
  Surface mesh;
  std::array<Surface::Vertex_index, 4> v;
  for(std::size_t i = 0; i < 4; ++i)
    v[i] = mesh.add_vertex(Surface::Point(i == 0 || i == 3 ? 0 : 1, i == 3 ? 1 : 0, 0));
  mesh.add_face(v[0], v[1], v[2]);
  std::map<Surface::Vertex_index, double> distances;
  const auto report = FG::geodesic_distances(mesh, v[0], boost::make_assoc_property_map(distances));
  BOOST_TEST(!report.is_confirmed());
  BOOST_TEST(distances[v[1]] == std::numeric_limits<double>::infinity());
  mesh.add_face(v[0], v[3], v[1]);
  const auto joined = FG::geodesic_distances(mesh, v[0], boost::make_assoc_property_map(distances));
  BOOST_TEST(joined.is_confirmed());
  BOOST_TEST(distances[v[1]] == 1);
  BOOST_TEST(distances[v[2]] == 1);
}
