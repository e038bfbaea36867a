// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is decided and proven refers to exact coordinates, if the kernel has such.

#include "test_kernels/exact_coordinates.h"

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/certify_curve.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost_mp.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using FG::Shortening_status;
using FG::Verdict;

namespace {

using Lazy_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Boost_kernel = CGAL::Simple_cartesian<boost::multiprecision::cpp_rational>;
using Lazy_cartesian = CGAL::Simple_cartesian<CGAL::Lazy_exact_nt<CGAL::Gmpq>>;
using Double_kernel = CGAL::Simple_cartesian<double>;

// Each diagonal against those of the cells leads through vertices, and is straight.
template <class Kernel>
void check_diagonals()
{
  constexpr int cells = 8;
  const auto mesh = mesh_of<Kernel>(lattice_grid(cells), in_odd_cells<Kernel>);
  using Vertex = typename std::decay_t<decltype(mesh)>::Vertex_index;
  const auto vertex = [](int i, int j) { return Vertex(static_cast<typename Vertex::size_type>(i + j * (cells + 1))); };
  for(int i = 1; i <= cells; ++i) {
    std::vector<typename Kernel::Point_3> points;
    const auto path = FG::geodesic_path(mesh, vertex(i, 0), vertex(0, i), std::back_inserter(points));
    BOOST_TEST((path.verdict() == Verdict::PROVEN));
    BOOST_TEST((path.report.curves.front().status == Shortening_status::LOCALLY_SHORTEST));
    BOOST_TEST(path.length() == i * std::hypot(1 / 3., 1 / 7.), boost::test_tools::tolerance(1e-14));
    const auto shortest = FG::shortest_path(mesh, vertex(i, 0), vertex(0, i), std::back_inserter(points)).report;
    BOOST_TEST((shortest.verdict == FG::Verdict::WITHIN_ROUNDING));
    std::vector<Vertex> corner;
    for(int k = 0; k <= i; ++k)
      corner.push_back(vertex(i - k, 0));
    BOOST_TEST((FG::certify_curve(mesh, corner).verdict() == Verdict::PROVEN));
    corner.push_back(vertex(0, 1));
    BOOST_TEST((FG::certify_curve(mesh, corner).verdict() == Verdict::BENT_JOINT));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(straight_diagonals_of_odd_cells)
{
  check_diagonals<Lazy_kernel>();
  check_diagonals<Rational_kernel>();
  check_diagonals<Boost_kernel>();
  check_diagonals<Lazy_cartesian>();
}

namespace {

// A vertex beside the line between two others, by less than doubles show: 1 + 10^-21.
template <class Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> nearly_straight(const typename Kernel::FT& height)
{
  using FT = typename Kernel::FT;
  CGAL::Surface_mesh<typename Kernel::Point_3> mesh;
  const auto add = [&](const FT& x, const FT& y) { return mesh.add_vertex(typename Kernel::Point_3(x, y, FT(0))); };
  const auto a = add(-1, 1), v = add(0, height), b = add(1, 1), above = add(0, 2), below = add(0, 0);
  mesh.add_face(a, below, v);
  mesh.add_face(below, b, v);
  mesh.add_face(v, b, above);
  mesh.add_face(a, v, above);
  return mesh;
}

template <class Kernel>
void check_nearly_straight(const typename Kernel::FT& height, bool is_straight)
{
  const auto mesh = nearly_straight<Kernel>(height);
  const auto v = mesh.vertices();
  const std::vector<typename std::decay_t<decltype(mesh)>::Vertex_index> line(v.begin(), std::next(v.begin(), 3));
  const Verdict verdict = FG::certify_curve(mesh, line).verdict();
  BOOST_TEST((verdict == (is_straight ? Verdict::PROVEN : Verdict::BENT_JOINT)));
  FG::Intrinsic_triangulation<std::decay_t<decltype(mesh)>> triangulation(mesh);
  FG::Edge_path_network<decltype(triangulation)> network(triangulation);
  network.add_curve(
      FG::halfedges_through(triangulation, std::vector{FG::Vertex_index(0), FG::Vertex_index(1), FG::Vertex_index(2)}));
  const FG::Curve_report report = FG::shorten(network).curves.front();
  BOOST_TEST((report.verdict == Verdict::PROVEN));
  BOOST_TEST(report.flips == (is_straight ? 0u : 1u));
}

} // namespace

BOOST_AUTO_TEST_CASE(a_bend_that_doubles_do_not_show)
{
  const CGAL::Gmpq little = CGAL::Gmpq(1) / CGAL::Gmpq(1e21);
  BOOST_TEST(CGAL::to_double(1 + little) == 1);
  check_nearly_straight<Rational_kernel>(1 + little, false);
  check_nearly_straight<Rational_kernel>(1 - little, false);
  check_nearly_straight<Rational_kernel>(1, true);
  check_nearly_straight<Lazy_kernel>(1 + Lazy_kernel::FT(1) / Lazy_kernel::FT(1e21), false);
  check_nearly_straight<Lazy_kernel>(Lazy_kernel::FT(1) / Lazy_kernel::FT(3) * Lazy_kernel::FT(3), true);
  check_nearly_straight<Boost_kernel>(Boost_kernel::FT(1 + Boost_kernel::FT(1) / Boost_kernel::FT(1e21)), false);
  check_nearly_straight<Double_kernel>(CGAL::to_double(1 + little), true);
}

// Neither a short edge nor a thin face is degenerate, and edges are of length zero only if they are.
BOOST_AUTO_TEST_CASE(short_edges_are_not_contracted)
{
  using FT = Rational_kernel::FT;
  for(const bool is_zero : {false, true}) {
    auto mesh = mesh_of<Rational_kernel>(lattice_grid(4), in_odd_cells<Rational_kernel>);
    using Vertex = decltype(mesh)::Vertex_index;
    const auto p = mesh.point(Vertex(7));
    mesh.point(Vertex(6)) = {p.x() - (is_zero ? FT(0) : FT(1) / FT(1e30)), p.y(), p.z()};
    std::vector<Rational_kernel::Point_3> points;
    const auto path = FG::geodesic_path(mesh, Vertex(5), Vertex(9), std::back_inserter(points));
    BOOST_TEST((path.verdict() == Verdict::PROVEN));
    BOOST_TEST(path.length() == 4 / 3., boost::test_tools::tolerance(1e-14));
    using Triangulation = FG::Intrinsic_triangulation<decltype(mesh)>;
    const Triangulation contracted(mesh, Triangulation::Metric(get(CGAL::vertex_point, std::as_const(mesh))),
                                   Triangulation::Traits(), FG::Zero_length_edges::CONTRACT);
    BOOST_TEST(contracted.input().is_contracted() == is_zero);
  }
}

namespace {

// Paths along edges that go straight on, more or less, at each vertex, with some turns.
template <class Mesh>
std::vector<std::vector<typename Mesh::Vertex_index>> random_edge_paths(const Mesh& mesh, std::size_t number)
{
  std::mt19937 random(17);
  std::vector<std::vector<typename Mesh::Vertex_index>> result(number);
  for(auto& path : result) {
    auto h = *std::next(mesh.halfedges().begin(), static_cast<std::ptrdiff_t>(random() % mesh.number_of_halfedges()));
    path = {mesh.source(h), mesh.target(h)};
    for(std::size_t steps = 1 + random() % 3; steps > 0; --steps) {
      std::vector<typename Mesh::Halfedge_index> onward;
      for(auto g = mesh.opposite(h);;) {
        g = mesh.opposite(mesh.prev(g));
        if(g == mesh.opposite(h))
          break;
        onward.push_back(g);
      }
      h = onward[onward.size() / 2 - (random() % 3 == 0 ? 1 : 0)];
      path.push_back(mesh.target(h));
    }
  }
  return result;
}

// The sign of pi less the angle from edge vb clockwise to edge va, by the product of the corners' complex numbers in
// expressions with roots. The number of half turns is counted from one corner to the next.
template <class Mesh>
class Angle_by_expressions
{
  using Number = CORE::Expr;
  using Halfedge = typename Mesh::Halfedge_index;

public:
  explicit Angle_by_expressions(const Mesh& mesh)
    : m_mesh(mesh)
  {
  }

  // From halfedge g counterclockwise to h, both of which start at one vertex: is the angle less than pi?
  bool is_below_pi(Halfedge g, Halfedge h) const
  {
    Number x = 1, y = 0;
    for(; g != h; g = m_mesh.opposite(m_mesh.prev(g))) {
      const auto [u, v] = corner(g);
      const Number product = x * u - y * v;
      y = x * v + y * u;
      x = product;
      if(CGAL::sign(y) != CGAL::POSITIVE && !(CGAL::sign(y) == CGAL::ZERO && CGAL::sign(x) == CGAL::POSITIVE))
        return false;
    }
    return true;
  }

private:
  std::array<Number, 3> vector(Halfedge h) const
  {
    const auto &p = m_mesh.point(m_mesh.source(h)), &q = m_mesh.point(m_mesh.target(h));
    return {number(q.x() - p.x()), number(q.y() - p.y()), number(q.z() - p.z())};
  }

  static Number number(const CGAL::Gmpq& x) { return Number(CORE::BigRat(x.mpq())); }

  std::pair<Number, Number> corner(Halfedge h) const
  {
    const auto u = vector(h), v = vector(m_mesh.opposite(m_mesh.prev(h)));
    const Number a = u[1] * v[2] - u[2] * v[1], b = u[2] * v[0] - u[0] * v[2], c = u[0] * v[1] - u[1] * v[0];
    return {u[0] * v[0] + u[1] * v[1] + u[2] * v[2], CGAL::sqrt(a * a + b * b + c * c)};
  }

  const Mesh& m_mesh;
};

// Is a path along edges of a closed mesh bent at a vertex?
template <class Mesh>
bool is_bent(const Mesh& mesh, const std::vector<typename Mesh::Vertex_index>& path)
{
  const Angle_by_expressions<Mesh> angle(mesh);
  for(std::size_t i = 1; i + 1 < path.size(); ++i) {
    const auto back = mesh.halfedge(path[i], path[i - 1]), on = mesh.halfedge(path[i], path[i + 1]);
    if(angle.is_below_pi(back, on) || angle.is_below_pi(on, back))
      return true;
  }
  return false;
}

const std::vector<std::array<int, 4>> quaternions = {{1, 1, 1, 0}, {1, 2, 3, 4}, {5, 1, 0, 2}};

} // namespace

// On a box, and with a vertex moved by less than doubles show: the verdict of each path is that of expressions with
// roots, and that of the integer box if no vertex is moved.
BOOST_AUTO_TEST_CASE(verdicts_on_rotated_boxes)
{
  const Lattice_surface box = lattice_box({4, 3, 2});
  const auto unrotated =
      mesh_of<Double_kernel>(box, [](const Lattice_point& p) { return Double_kernel::Point_3(p[0], p[1], p[2]); });
  const auto paths = random_edge_paths(unrotated, 60);
  std::size_t straight = 0, changed = 0;
  for(const auto& q : quaternions) {
    auto mesh = mesh_of<Rational_kernel>(box, [&](const Lattice_point& p) { return rotated<Rational_kernel>(p, q); });
    const auto lazy = mesh_of<Lazy_kernel>(box, [&](const Lattice_point& p) { return rotated<Lazy_kernel>(p, q); });
    for(const auto& path : paths) {
      const auto verdict = FG::certify_curve(unrotated, path).verdict();
      BOOST_TEST((FG::certify_curve(mesh, path).verdict() == verdict));
      BOOST_TEST((FG::certify_curve(lazy, path).verdict() == verdict));
      BOOST_TEST((verdict == Verdict::BENT_JOINT) == is_bent(mesh, path));
      straight += verdict == Verdict::PROVEN ? 1 : 0;
    }
    for(const auto v : mesh.vertices()) {
      const auto p = mesh.point(v);
      if(v.idx() % 3 == 0)
        mesh.point(v) = {p.x() + CGAL::Gmpq(1) / CGAL::Gmpq(1e25), p.y(), p.z() - CGAL::Gmpq(3) / CGAL::Gmpq(1e25)};
    }
    for(const auto& path : paths) {
      const auto verdict = FG::certify_curve(mesh, path).verdict();
      BOOST_TEST((verdict == (is_bent(mesh, path) ? Verdict::BENT_JOINT : Verdict::PROVEN)));
      changed += verdict != FG::certify_curve(unrotated, path).verdict() ? 1 : 0;
    }
  }
  BOOST_TEST(straight > 10u);
  BOOST_TEST(changed > 10u);
}

// The same lengths, verdicts and numbers of crossed edges as those of the integer box.
BOOST_AUTO_TEST_CASE(paths_on_rotated_boxes)
{
  const Lattice_surface box = lattice_box({4, 3, 2});
  const auto unrotated =
      mesh_of<Double_kernel>(box, [](const Lattice_point& p) { return Double_kernel::Point_3(p[0], p[1], p[2]); });
  using Vertex = decltype(unrotated)::Vertex_index;
  for(const auto& q : quaternions) {
    const auto mesh = mesh_of<Lazy_kernel>(box, [&](const Lattice_point& p) { return rotated<Lazy_kernel>(p, q); });
    for(std::size_t i = 0, n = box.points.size(); i < n; i += 3) {
      const Vertex s(static_cast<Vertex::size_type>(i)), t(static_cast<Vertex::size_type>((i * 7 + n / 2) % n));
      if(s == t)
        continue;
      std::vector<Double_kernel::Point_3> points;
      std::vector<Lazy_kernel::Point_3> lazy_points;
      using Lazy_vertex = std::decay_t<decltype(mesh)>::Vertex_index;
      const auto expected = FG::shortest_path(unrotated, s, t, std::back_inserter(points)).report;
      const auto found =
          FG::shortest_path(mesh, Lazy_vertex(s.idx()), Lazy_vertex(t.idx()), std::back_inserter(lazy_points)).report;
      BOOST_TEST((found.verdict == expected.verdict));
      BOOST_TEST(found.length == expected.length, boost::test_tools::tolerance(1e-13));
      const auto path =
          FG::geodesic_path(mesh, Lazy_vertex(s.idx()), Lazy_vertex(t.idx()), std::back_inserter(lazy_points));
      BOOST_TEST((path.verdict() == Verdict::PROVEN));
    }
  }
}

// Numbers of hundreds of digits.
BOOST_AUTO_TEST_CASE(coordinates_of_many_digits)
{
  using FT = Boost_kernel::FT;
  FT power = 1;
  for(int i = 0; i < 40; ++i)
    power *= FT(1000000007);
  const FT factor = power / (power + FT(1));
  const auto mesh = mesh_of<Boost_kernel>(lattice_grid(6), [&](const Lattice_point& p) {
    return Boost_kernel::Point_3(FT(p[0] * factor), FT(p[1] * factor), FT(p[2] * factor / 3));
  });
  using Vertex = std::decay_t<decltype(mesh)>::Vertex_index;
  std::vector<Boost_kernel::Point_3> points;
  const auto path = FG::geodesic_path(mesh, Vertex(6), Vertex(42), std::back_inserter(points));
  BOOST_TEST((path.verdict() == Verdict::PROVEN));
  BOOST_TEST(path.length() == 6 * std::sqrt(2.), boost::test_tools::tolerance(1e-14));
}

// A kernel as geom_traits() means the default.
BOOST_AUTO_TEST_CASE(a_kernel_as_traits)
{
  const auto mesh = mesh_of<Lazy_kernel>(lattice_grid(4), in_odd_cells<Lazy_kernel>);
  using Mesh = std::decay_t<decltype(mesh)>;
  using Vertex = Mesh::Vertex_index;
  namespace params = CGAL::parameters;
  std::vector<Lazy_kernel::Point_3> points;
  const auto out = std::back_inserter(points);
  const auto np = params::geom_traits(Lazy_kernel());
  BOOST_TEST((FG::geodesic_path(mesh, Vertex(4), Vertex(20), out, np).verdict() == Verdict::PROVEN));
  BOOST_TEST((FG::shortest_path(mesh, Vertex(4), Vertex(20), out, np).report.verdict == FG::Verdict::WITHIN_ROUNDING));
  const std::vector<Vertex> diagonal = {Vertex(4), Vertex(3)};
  BOOST_TEST((FG::certify_curve(mesh, diagonal, np).verdict() == Verdict::PROVEN));
  std::map<Vertex, double> distances;
  BOOST_TEST(FG::geodesic_distances(mesh, Vertex(0), boost::make_assoc_property_map(distances), np).is_confirmed());
}
