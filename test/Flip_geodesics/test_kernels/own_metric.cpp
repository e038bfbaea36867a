// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A metric of one's own with exact squared lengths, written from the concept's page alone.

#include "test_kernels/exact_coordinates.h"

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/certify_curve.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace own_metric {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;
using Rational = boost::multiprecision::cpp_rational;

// The numbers x^2 / 3 + x y / 2 + 3 y^2 / 7 of the vectors between lattice points: the same inner product everywhere.
Rational square_of(int x, int y) { return Rational(x * x) / 3 + Rational(x * y) / 2 + Rational(3 * y * y) / 7; }

class Sheared_metric
{
public:
  using Mesh = FG::Numbered_mesh<own_metric::Mesh>;
  using Kernel = CGAL::Simple_cartesian<double>;

  struct Place
  {
  };

  explicit Sheared_metric(std::vector<Lattice_point> points)
    : m_points(std::move(points))
  {
  }

  double length(const Mesh& mesh, FG::Input_halfedge_index h) const
  {
    return std::sqrt(squared_length(mesh, h).convert_to<double>());
  }
  double weight(const Mesh& mesh, FG::Input_halfedge_index h) const { return length(mesh, h); }
  double weight(const Mesh& mesh, FG::Input_halfedge_index h, Place, Place) const { return length(mesh, h); }
  Place place(const Mesh&, FG::Vertex_index) const { return Place(); }
  double distance_lower_bound(Place, Place) const { return 0; }

  Rational squared_length(const Mesh& mesh, FG::Input_halfedge_index h) const
  {
    const Lattice_point &p = at(mesh.tail(h)), &q = at(mesh.tail(Mesh::twin(h)));
    return square_of(q[0] - p[0], q[1] - p[1]);
  }

private:
  const Lattice_point& at(FG::Vertex_index v) const { return m_points[static_cast<std::size_t>(v.idx())]; }

  std::vector<Lattice_point> m_points;
};

// No class but those of the package has faces in its numbers.
struct Metric_with_another_exact_face
{
  using Mesh = FG::Numbered_mesh<own_metric::Mesh>;
  using Kernel = CGAL::Simple_cartesian<double>;
  int exact_face(const Mesh&, FG::Input_halfedge_index) const { return 0; }
};

} // namespace

// Each diagonal against those of the cells leads through vertices, and is straight.
BOOST_AUTO_TEST_CASE(a_metric_with_exact_squared_lengths_is_certified)
{
  using Traits = FG::Default_traits<Sheared_metric>;
  static_assert(std::is_same_v<Traits, FG::Certified_intrinsic_triangulation_traits<Kernel>>);
  constexpr int cells = 7;
  const Lattice_surface grid = lattice_grid(cells);
  const Mesh mesh = mesh_of<Kernel>(grid, [](const Lattice_point& p) { return Kernel::Point_3(p[0], p[1], 0); });
  const auto np = CGAL::parameters::metric(Sheared_metric(grid.points));
  const auto vertex = [](int i, int j) { return Vertex(static_cast<Mesh::size_type>(i + j * (cells + 1))); };
  for(int i = 1; i <= cells; ++i) {
    std::vector<Location> locations;
    const auto path = FG::geodesic_path(mesh, vertex(i, 0), vertex(0, i), std::back_inserter(locations), np);
    BOOST_TEST((path.verdict() == FG::Verdict::PROVEN));
    const double length = i * std::sqrt(square_of(-1, 1).convert_to<double>());
    BOOST_TEST(path.length() == length, boost::test_tools::tolerance(1e-14));
    const auto shortest = FG::shortest_path(mesh, vertex(i, 0), vertex(0, i), std::back_inserter(locations), np).report;
    BOOST_TEST(shortest.is_confirmed());
    BOOST_TEST(shortest.length == length, boost::test_tools::tolerance(1e-13));
    std::vector<Vertex> corner;
    for(int k = 0; k <= i; ++k)
      corner.push_back(vertex(i - k, 0));
    BOOST_TEST((FG::certify_curve(mesh, corner, np).verdict() == FG::Verdict::PROVEN));
    corner.push_back(vertex(0, 1));
    BOOST_TEST((FG::certify_curve(mesh, corner, np).verdict() == FG::Verdict::BENT_JOINT));
  }
}

BOOST_AUTO_TEST_CASE(members_that_are_not_documented_are_not_looked_for)
{
  static_assert(
      std::is_same_v<FG::Default_traits<Metric_with_another_exact_face>, FG::Intrinsic_triangulation_traits<Kernel>>);
  BOOST_TEST(true);
}

// A face with sides of length 0, 1 and 1 + 10^-30 is none, although doubles do not show it.
BOOST_AUTO_TEST_CASE(needles_are_compared_exactly)
{
  for(const bool is_isosceles : {true, false}) {
    Mesh mesh;
    const auto a = mesh.add_vertex(), b = mesh.add_vertex(), c = mesh.add_vertex(), d = mesh.add_vertex();
    mesh.add_face(a, b, c);
    mesh.add_face(b, a, d);
    const auto lengths = mesh.add_property_map<Mesh::Edge_index, Rational>("e:length", 1).first;
    lengths[mesh.edge(mesh.halfedge(a, b))] = 0;
    if(!is_isosceles)
      lengths[mesh.edge(mesh.halfedge(b, c))] +=
          Rational(1) / Rational(boost::multiprecision::pow(boost::multiprecision::cpp_int(10), 30));
    using Metric = FG::Edge_length_metric<Mesh, decltype(lengths)>;
    using Triangulation = FG::Intrinsic_triangulation<Mesh, FG::Default_traits<Metric>, Metric>;
    const Metric metric(mesh, lengths);
    const auto construct = [&] {
      return Triangulation(mesh, metric, Triangulation::Traits(), FG::Zero_length_edges::CONTRACT).number_of_vertices();
    };
    if(is_isosceles)
      BOOST_TEST(construct() > 0);
    else
      BOOST_CHECK_THROW(construct(), FG::Degenerate_face_error);
  }
}

} // namespace own_metric
