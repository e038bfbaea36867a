// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The logarithmic map of all places at once is that of each place, and asks for few faces.

#include "surfaces.h"

#include <CGAL/Flip_geodesics/internal/tangents/Logarithm_everywhere.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>
#include <CGAL/Flip_geodesics/texture_coordinates.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

using namespace tangents_test;

namespace {

using Everywhere = FG::internal::Logarithm_everywhere<Triangulation>;

// Vertices, points of edges, and points in faces, all over the mesh.
std::vector<FG::Surface_location> sources(const Triangulation& t)
{
  std::vector<FG::Surface_location> result;
  const auto n = t.input().number_of_halfedges();
  for(int k = 0; k < 3; ++k)
    for(const std::array<double, 3>& weights :
        {std::array<double, 3>{1, 0, 0}, std::array<double, 3>{0.43, 0.57, 0}, std::array<double, 3>{0.31, 0.48, 0.21}})
    {
      FG::Input_halfedge_index h((2 * static_cast<int>(result.size()) + 1) * (n / 20));
      while(t.input().is_border(h))
        h = t.input().next(h).idx() == 0 ? FG::Input_halfedge_index(0) : FG::internal::twin_index(h);
      result.push_back({h, weights});
    }
  return result;
}

// Where shortest paths arrive from two sides, either answer is right.
bool is_told(const FG::Polar_coordinates& p, const FG::Polar_coordinates& q, double total)
{
  return std::abs(std::polar(p.radius, 2 * pi / total * p.angle) - std::polar(q.radius, 2 * pi / total * q.angle)) <
         1e-11 * q.radius;
}

struct Counts
{
  std::size_t same = 0, other = 0;
};

void compare(const Triangulation& t, const Mesh& mesh, const FG::Surface_location& source, Counts& counts)
{
  const FG::Logarithmic_map<Triangulation> one(t, mesh, source);
  Everywhere all(t, one, source);
  const double total = one.is_on_border() ? 2 * pi : one.total_angle();
  for(FG::Vertex_index v : FG::internal::descriptors<FG::Vertex_index>(t.input().number_of_vertices())) {
    const FG::Polar_coordinates p = all(v), q = one(v);
    BOOST_TEST(std::abs(p.radius - q.radius) <= 1e-12 * q.radius);
    BOOST_TEST(std::isnan(p.angle) == std::isnan(q.angle));
    if(q.radius > 0)
      ++(is_told(p, q, total) ? counts.same : counts.other);
  }
  for(FG::Input_halfedge_index h : FG::internal::descriptors<FG::Input_halfedge_index>(t.input().number_of_halfedges()))
    if(!t.input().is_border(h)) {
      const std::array<double, 3> weights = {{0.375, 0.25, 0.375}};
      const auto arrival = all(h, weights);
      const FG::Polar_coordinates q = one(FG::Surface_location{h, weights});
      BOOST_TEST(std::abs(arrival.polar.radius - q.radius) <= 1e-12 * q.radius);
      if(!(q.radius > 0))
        continue;
      const double carried = one.transported(FG::Surface_location{h, weights}, q.angle).angle;
      const bool is_same =
          is_told(arrival.polar, q, total) && std::abs(std::remainder(carried - arrival.carried, 2 * pi)) < 1e-10;
      ++(is_same ? counts.same : counts.other);
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(all_places_are_told_as_one_is)
{
  for(const Mesh_soup& soup :
      {bumpy_sphere(6, 0.2, 5), jittered_grid(9, 9, Diagonal_rule::ALTERNATING, 0.2, 4), cylinder(9, 6, 1, 4),
       random_convex_polyhedron(60, 3), saddle_disk(12, 5, 4 * pi), torus(17, 9, 2, 1), cone_disk(11, 5, 5.1),
       mapped(flat_grid(8, 8, Diagonal_rule::RISING), [](const Coordinates& p) {
         return Coordinates{p[0], p[1], 0.3 * std::sin(3 * p[0]) * std::cos(2 * p[1])};
       })})
  {
    const Mesh mesh = to_mesh<Mesh>(soup);
    const Triangulation t(mesh);
    Counts counts;
    for(const FG::Surface_location& source : sources(t))
      compare(t, mesh, source, counts);
    BOOST_TEST_MESSAGE(counts.same << " " << counts.other);
    BOOST_TEST(counts.other * 50 <= counts.same);
  }
}

// With limits, and on surfaces that are not connected, there are places without a path.
BOOST_AUTO_TEST_CASE(places_out_of_reach_have_no_coordinates)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(9, 9, Diagonal_rule::RISING));
  const Triangulation t(mesh);
  const FG::Surface_location source = t.location(FG::Vertex_index(grid_vertex(9, 4, 4)));
  FG::Distance_field_limits limits;
  limits.radius = 2.1;
  const FG::Logarithmic_map<Triangulation> one(t, mesh, source, CGAL::parameters::search_limit(limits));
  Everywhere all(t, one, source);
  std::size_t far = 0;
  for(FG::Vertex_index v : FG::internal::descriptors<FG::Vertex_index>(t.input().number_of_vertices())) {
    BOOST_TEST(std::isinf(all(v).radius) == std::isinf(one(v).radius));
    far += std::isinf(all(v).radius) ? 1 : 0;
  }
  BOOST_TEST(far > 40u);
  for(FG::Input_halfedge_index h : FG::internal::descriptors<FG::Input_halfedge_index>(t.input().number_of_halfedges()))
    if(!t.input().is_border(h)) {
      const FG::Surface_location center = {h, {{0.375, 0.25, 0.375}}};
      const auto arrival = all(h, center.weights);
      BOOST_TEST(std::isinf(arrival.polar.radius) == std::isinf(one(center).radius));
      if(std::isinf(arrival.polar.radius))
        BOOST_TEST(arrival.carried == 0); // no direction is transported there
    }
}

namespace {

using Points = Mesh::Property_map<Mesh::Vertex_index, Point>;
using Embedded_metric = FG::Embedded_metric<Mesh, Points>;

// Counts how often it is asked for a face.
struct Counting_metric : Embedded_metric
{
  Counting_metric(const Points& points, std::size_t& asked)
    : Embedded_metric(points)
    , asked(&asked)
  {
  }

  template <class Traits>
  auto face_geometry(const Embedded_metric::Mesh& mesh, FG::Input_halfedge_index h, const Traits& traits) const
  {
    ++*asked;
    return Embedded_metric::face_geometry(mesh, h, traits);
  }

  std::size_t* asked;
};

// For a picture on all of a sphere, by face.
double faces_asked_for(int n)
{
  using Map = Mesh::Property_map<Mesh::Halfedge_index, std::array<double, 2>>;
  Mesh mesh = to_mesh<Mesh>(bumpy_sphere(n, 0.02, 7));
  const Map map = mesh.add_property_map<Mesh::Halfedge_index, std::array<double, 2>>("h:texture").first;
  const std::pair<Mesh::Face_index, std::array<double, 3>> middle = {Mesh::Face_index(20), {{0.5, 0.25, 0.25}}};
  std::size_t asked = 0;
  const Counting_metric metric(mesh.points(), asked);
  const FG::Texture_report report = FG::texture_coordinates(mesh, middle, {mesh.halfedge(middle.first), 0}, 100, map,
                                                            CGAL::parameters::metric(metric));
  BOOST_TEST(report.faces == mesh.number_of_faces());
  return static_cast<double>(asked) / static_cast<double>(mesh.number_of_faces());
}

} // namespace

// It was one walk along a path for each vertex, and two for each face that the map tears.
BOOST_AUTO_TEST_CASE(a_picture_does_not_walk_along_paths)
{
  for(int n : {6, 12, 24}) {
    const double asked = faces_asked_for(n);
    BOOST_TEST_MESSAGE(n << ": " << asked);
    BOOST_TEST(asked < 30);
  }
}
