// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polylines with several points in one face, on its edges and at its corners, against exact integer arithmetic.

#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace drawn_in_faces {

namespace FG = CGAL::Flip_geodesics;
using Flip_geodesics_test::Random_numbers;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Lattice_point = std::array<int, 2>;
using Lattice_polyline = std::vector<Lattice_point>;

inline int orientation(const Lattice_point& p, const Lattice_point& q, const Lattice_point& r)
{
  const int d = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  return (d > 0) - (d < 0);
}

inline bool is_on_segment(const Lattice_point& p, const Lattice_point& q, const Lattice_point& r)
{
  const int along = (r[0] - p[0]) * (r[0] - q[0]) + (r[1] - p[1]) * (r[1] - q[1]);
  return orientation(p, q, r) == 0 && along <= 0;
}

/* Whether two segments of a polyline cross between their ends, and whether any touch that are not neighbors. */
struct Contacts
{
  bool has_crossing = false, has_touch = false;

  Contacts(const Lattice_polyline& line, bool is_closed)
  {
    const std::size_t n = line.size(), segments = is_closed ? n : n - 1;
    for(std::size_t i = 0; i < segments; ++i) {
      const Lattice_point &a = line[i], &b = line[(i + 1) % n];
      for(std::size_t k = 0; k < n; ++k)
        has_touch = has_touch || (k != i && k != (i + 1) % n && is_on_segment(a, b, line[k]));
      for(std::size_t j = i + 1; j < segments; ++j) {
        const Lattice_point &c = line[j], &d = line[(j + 1) % n];
        has_crossing = has_crossing || (orientation(a, b, c) * orientation(a, b, d) < 0 &&
                                        orientation(c, d, a) * orientation(c, d, b) < 0);
      }
    }
  }
};

/* A square of two faces with `n` lattice points on a side: (0, 0), (n, 0), (n, n) and (0, 0), (n, n), (0, n). */
class Square
{
public:
  explicit Square(int n)
    : m_size(n)
  {
    const double x = n;
    const auto a = m_mesh.add_vertex(Point(0, 0, 0)), b = m_mesh.add_vertex(Point(x, 0, 0)),
               c = m_mesh.add_vertex(Point(x, x, 0)), d = m_mesh.add_vertex(Point(0, x, 0));
    m_mesh.add_face(a, b, c);
    m_mesh.add_face(a, c, d);
  }

  const Mesh& mesh() const { return m_mesh; }

  /* At random, each two in a row in one face, and in different places. */
  Lattice_polyline random_polyline(Random_numbers& random, std::size_t size, bool is_closed) const
  {
    for(;;) {
      Lattice_polyline line;
      while(line.size() < size) {
        const Lattice_point p = {random.below(m_size + 1), random.below(m_size + 1)};
        if(line.empty() || are_joined(line.back(), p))
          line.push_back(p);
      }
      if(!is_closed || are_joined(line.back(), line.front()))
        return line;
    }
  }

  std::vector<FG::Surface_location> locations(const Triangulation& triangulation, const Lattice_polyline& line) const
  {
    std::vector<FG::Surface_location> result;
    for(const Lattice_point& p : line)
      result.push_back(location(triangulation, p));
    return result;
  }

private:
  static bool are_joined(const Lattice_point& p, const Lattice_point& q)
  {
    const int side_of_p = orientation({0, 0}, {1, 1}, p), side_of_q = orientation({0, 0}, {1, 1}, q);
    return p != q && side_of_p * side_of_q >= 0;
  }

  FG::Surface_location location(const Triangulation& triangulation, const Lattice_point& p) const
  {
    const bool is_below = p[0] >= p[1];
    const auto h = m_mesh.halfedge(*std::next(m_mesh.faces().begin(), is_below ? 0 : 1));
    FG::Surface_location result = {triangulation.input().index(h), {}};
    auto corner = h;
    for(double& weight : result.weights) {
      const Point q = m_mesh.point(m_mesh.source(corner));
      if(q.x() == 0 && q.y() == 0)
        weight = m_size - (std::max)(p[0], p[1]);
      else if(q.x() > 0 && q.y() > 0)
        weight = (std::min)(p[0], p[1]);
      else
        weight = std::abs(p[0] - p[1]);
      corner = m_mesh.next(corner);
    }
    return result;
  }

  int m_size;
  Mesh m_mesh;
};

inline double length(const Lattice_polyline& line, bool is_closed)
{
  double sum = 0;
  for(std::size_t i = 0; i + (is_closed ? 0 : 1) < line.size(); ++i) {
    const Lattice_point &p = line[i], &q = line[(i + 1) % line.size()];
    sum += std::hypot(p[0] - q[0], p[1] - q[1]);
  }
  return sum;
}

/* Is the curve the polyline? It has a vertex at each of its points, and others only on its segments. */
inline bool is_drawn(const Network& network, FG::Curve_index curve, const Lattice_polyline& line, bool is_closed)
{
  std::vector<Point> points;
  FG::Curve_extractor<Network>(network).points(curve, std::back_inserter(points));
  const auto is_at = [](const Point& p, const Lattice_point& q) {
    return std::hypot(p.x() - q[0], p.y() - q[1]) < 1e-9;
  };
  std::size_t next = 0;
  for(const Point& p : points)
    next += next < line.size() && is_at(p, line[next]) ? 1 : 0;
  return next == line.size() && std::abs(network.length(curve) - length(line, is_closed)) < 1e-9;
}

struct Counts
{
  int simple = 0, crossing = 0, touching = 0;
};

inline Counts check_random_polylines(int size_of_lattice, int number, unsigned seed)
{
  const Square square(size_of_lattice);
  Triangulation triangulation(square.mesh());
  Random_numbers random(seed);
  Counts counts;
  for(int i = 0; i < number; ++i) {
    const bool is_closed = i % 2 == 1;
    const Lattice_polyline line = square.random_polyline(random, 3 + static_cast<std::size_t>(i / 2 % 4), is_closed);
    const Contacts contacts(line, is_closed);
    bool is_refused = false;
    {
      Network network(triangulation);
      try {
        const FG::Curve_index curve =
            FG::draw_polyline(network, square.locations(triangulation, line), CGAL::parameters::is_closed(is_closed));
        BOOST_TEST(is_drawn(network, curve, line, is_closed));
        FG::order_overlapping_curves(network);
        FG::shorten(network);
        BOOST_TEST(is_drawn(network, curve, line, is_closed));
        BOOST_TEST(network.is_valid());
      } catch(const FG::Crossing_curves_error&) {
        is_refused = true;
      }
    }
    BOOST_TEST(triangulation.is_valid());
    triangulation.rollback();
    counts.crossing += contacts.has_crossing ? 1 : 0;
    counts.touching += !contacts.has_crossing && contacts.has_touch ? 1 : 0;
    counts.simple += !contacts.has_crossing && !contacts.has_touch ? 1 : 0;
    if(contacts.has_crossing || !contacts.has_touch) // segments that only touch may cross there
      BOOST_TEST(is_refused == contacts.has_crossing);
  }
  return counts;
}

BOOST_AUTO_TEST_CASE(polylines_with_points_in_one_face_are_drawn_as_they_are)
{
  const Counts fine = check_random_polylines(64, 2000, 1);
  BOOST_TEST(fine.simple > 500);
  BOOST_TEST(fine.crossing > 500);
  const Counts coarse = check_random_polylines(4, 2000, 2); // on edges, at corners, on each other
  BOOST_TEST(coarse.simple > 200);
  BOOST_TEST(coarse.crossing > 200);
  BOOST_TEST(coarse.touching > 200);
}

// A segment that crosses a curve drawn before it.
BOOST_AUTO_TEST_CASE(segments_that_cross_another_curve_are_refused)
{
  const Square square(8);
  Triangulation triangulation(square.mesh());
  Network network(triangulation);
  const auto draw = [&](const Lattice_polyline& line) {
    return FG::draw_polyline(network, square.locations(triangulation, line));
  };
  const FG::Curve_index first = draw({{2, 1}, {6, 1}});
  BOOST_CHECK_EXCEPTION(draw({{4, 0}, {4, 3}}), FG::Crossing_curves_error,
                        [&](const FG::Error& error) { return error.elements().size() == 2; });
  BOOST_TEST(network.number_of_curves() == 1);
  BOOST_TEST(network.is_valid());
  BOOST_TEST(is_drawn(network, first, {{2, 1}, {6, 1}}, false));
  const FG::Curve_index second = draw({{4, 2}, {4, 3}});
  FG::order_overlapping_curves(network);
  BOOST_TEST(is_drawn(network, second, {{4, 2}, {4, 3}}, false));
}

} // namespace drawn_in_faces
