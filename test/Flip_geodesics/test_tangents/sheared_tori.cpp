// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The logarithmic map where shortest paths cross edges many times: on flat tori of long thin faces, whose edges are not
// shortest paths. The torus is a parallelogram of n by m cells with sides (1, 0) and (shear, 1), unrolled into the
// plane.

#include "Curve_setting.h"
#include "generated_curves.h"
#include "surfaces.h"

#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

using namespace tangents_test;

namespace {

using Complex = std::complex<double>;
using Flip_geodesics_test::Length_map;
using Flip_geodesics_test::Length_metric;
using Length_triangulation = Flip_geodesics_test::Length_triangulation;

class Sheared_torus
{
public:
  Sheared_torus(int n, int m, double shear)
    : m_n(n)
    , m_m(m)
    , m_shear(shear)
    , mesh(to_mesh<Mesh>(torus(n, m, 3, 1)))
    , lengths(edge_lengths(mesh, [&](int v, int w) { return std::abs(edge(v, w)); }))
    , metric(mesh, Length_map(lengths))
  {
  }

  Complex place(int v) const { return {v % m_n + m_shear * (v / m_n), static_cast<double>(v / m_n)}; }

  // The vector nearest to 0 that leads to the place of a vector, too.
  Complex shortest(const Complex& vector) const
  {
    Complex best = std::numeric_limits<double>::infinity();
    for(int q = -3; q <= 3; ++q) {
      const Complex moved = vector + Complex(q * m_m * m_shear, q * m_m);
      const Complex nearest = moved - std::round(moved.real() / m_n) * m_n;
      best = std::abs(nearest) < std::abs(best) ? nearest : best;
    }
    return best;
  }

  // That of an edge: from (i, j) to (i + 1, j), (i, j + 1) or (i + 1, j + 1), or backward.
  Complex edge(int v, int w) const
  {
    int i = (w % m_n - v % m_n + m_n) % m_n, j = (w / m_n - v / m_n + m_m) % m_m;
    i -= i > 1 ? m_n : 0;
    j -= j > 1 ? m_m : 0;
    return {i + m_shear * j, static_cast<double>(j)};
  }

private:
  int m_n, m_m;
  double m_shear;

public:
  Mesh mesh;
  std::map<Mesh::Edge_index, double> lengths;
  Length_metric metric;
};

// Checks the map of the first vertex; returns how many points a path has at most.
std::size_t check_map(const Sheared_torus& torus)
{
  std::vector<FG::Polar_coordinates> map;
  const auto result = FG::logarithmic_map(torus.mesh, Mesh::Vertex_index(0), torus.mesh.vertices(),
                                          std::back_inserter(map), CGAL::parameters::metric(torus.metric));
  const Complex axis = torus.edge(0, static_cast<int>(target(result.halfedge(), torus.mesh)));
  const Length_triangulation triangulation(torus.mesh, torus.metric);
  const FG::Logarithmic_map<Length_triangulation> logarithm(triangulation, torus.mesh,
                                                            triangulation.location(FG::Vertex_index(0)));
  std::size_t most_points = 0;
  for(int v = 1; v < static_cast<int>(map.size()); ++v) {
    const FG::Surface_location location = triangulation.location(FG::Vertex_index(v));
    const double expected = std::abs(torus.shortest(torus.place(v)));
    const FG::Polar_coordinates p = map[static_cast<std::size_t>(v)], q = logarithm(location);
    for(const double radius : {p.radius, q.radius, 2 * logarithm(logarithm.between(location, 0.5)).radius})
      BOOST_TEST(std::abs(radius - expected) < 1e-9);
    for(const FG::Polar_coordinates& polar : {p, q}) {
      const Complex vector = std::polar(polar.radius, polar.angle) * axis / std::abs(axis);
      BOOST_TEST(std::abs(torus.shortest(vector - torus.place(v))) < 1e-9);
    }
    most_points = (std::max)(most_points, logarithm.distance_field().surface_points(location).size());
  }
  return most_points;
}

} // namespace

BOOST_AUTO_TEST_SUITE(sheared_tori)

BOOST_AUTO_TEST_CASE(paths_cross_edges_many_times)
{
  for(double shear : {0.5, 7.5, 21.5, 30.5, 38.0})
    for(int n : {3, 4})
      for(int m : {3, 5}) {
        const Sheared_torus torus(n, m, shear);
        const std::size_t most_points = check_map(torus);
        BOOST_TEST((shear < 30 || most_points > torus.mesh.number_of_edges()));
      }
}

BOOST_AUTO_TEST_SUITE_END()
