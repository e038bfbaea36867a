// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Loops that bound inside of a solid, and outside: compared with linking numbers by Gauss's integral, of loops that are
// pushed off the surface by a little.

#include "test_loops/loop_setting.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/internal/topology/Linking_matrix.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace {

using Vector = std::array<double, 3>;

Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The solid angle of the quadrilateral of directions from one segment to another, as that of two triangles.
double solid_angle(const Vector& a, const Vector& b, const Vector& c)
{
  const double p = std::sqrt(dot(a, a)), q = std::sqrt(dot(b, b)), r = std::sqrt(dot(c, c));
  return 2 * std::atan2(dot(a, cross(b, c)), p * q * r + dot(a, b) * r + dot(a, c) * q + dot(b, c) * p);
}

int linking_number(const std::vector<Vector>& a, const std::vector<Vector>& b)
{
  double sum = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t k = 0; k < b.size(); ++k) {
      const Vector &p = a[i], &q = a[(i + 1) % a.size()], &r = b[k], &s = b[(k + 1) % b.size()];
      const Vector pr = difference(r, p), ps = difference(s, p), qr = difference(r, q), qs = difference(s, q);
      sum += solid_angle(pr, qr, qs) + solid_angle(pr, qs, ps);
    }
  const double number = sum / (4 * pi);
  BOOST_TEST(std::abs(number - std::round(number)) < 1e-6);
  return static_cast<int>(std::round(number));
}

// A chain pushed off a surface, along its normals.
std::vector<Vector> pushed(const Mesh_soup& soup, const Triangulation& triangulation, const Chain& chain, double by)
{
  std::vector<Vector> normals(soup.points.size(), Vector{0, 0, 0});
  for(const Corners& t : soup.triangles) {
    const Vector n =
        cross(difference(soup.points[t[1]], soup.points[t[0]]), difference(soup.points[t[2]], soup.points[t[0]]));
    for(auto corner : t)
      for(int k = 0; k < 3; ++k)
        normals[corner][k] += n[k] / std::sqrt(dot(n, n));
  }
  std::vector<Vector> result;
  for(FG::Halfedge_index h : chain) {
    const auto v = static_cast<std::size_t>(triangulation.tail(h).idx());
    const double scale = by / std::sqrt(dot(normals[v], normals[v]));
    const Coordinates& p = soup.points[v];
    result.push_back({p[0] + scale * normals[v][0], p[1] + scale * normals[v][1], p[2] + scale * normals[v][2]});
  }
  return result;
}

// Are the classes a basis? The determinant modulo a prime, of rows.
bool is_basis(std::vector<Class> rows)
{
  constexpr std::int64_t prime = 2147483647;
  const auto power = [](std::int64_t base, std::int64_t exponent) {
    std::int64_t result = 1;
    for(; exponent > 0; exponent /= 2, base = base * base % prime)
      result = exponent % 2 == 1 ? result * base % prime : result;
    return result;
  };
  for(Class& row : rows)
    for(std::int64_t& x : row)
      x = (x % prime + prime) % prime;
  std::int64_t determinant = 1;
  for(std::size_t i = 0; i < rows.size(); ++i) {
    std::size_t pivot = i;
    while(pivot < rows.size() && rows[pivot][i] == 0)
      ++pivot;
    if(pivot == rows.size())
      return false;
    std::swap(rows[i], rows[pivot]);
    determinant = determinant * rows[i][i] % prime;
    for(std::size_t j = i + 1; j < rows.size(); ++j) {
      const std::int64_t factor = rows[j][i] * power(rows[i][i], prime - 2) % prime;
      for(std::size_t k = i; k < rows.size(); ++k)
        rows[j][k] = (rows[j][k] + (prime - factor) * rows[i][k]) % prime;
    }
  }
  return determinant == 1 || determinant == prime - 1;
}

double length(const Setting& s, const Chain& chain) { return s.length(chain); }

// Of a surface with faces counterclockwise as seen from outside. The loops are found on a deformed surface, and compared
// with linking numbers on the given one.
FG::Handle_and_tunnel_loops check_solid(const Mesh_soup& soup, std::size_t genus, double push,
                                        const Mesh_soup& deformed)
{
  const Setting s(soup), other(deformed);
  const FG::Handle_and_tunnel_loops loops = FG::handle_and_tunnel_loops(other.triangulation);
  BOOST_TEST_REQUIRE(loops.handles.size() == genus);
  BOOST_TEST_REQUIRE(loops.tunnels.size() == genus);
  BOOST_TEST_REQUIRE(s.basis.number_of_loops() == static_cast<FG::Index>(2 * genus));
  std::vector<Class> classes;
  for(const auto* kind : {&loops.handles, &loops.tunnels})
    for(const Chain& chain : *kind) {
      classes.push_back(s.basis.homology_class(Setting::input_chain(chain)));
      BOOST_TEST((chain.front() != FG::internal::twin_index(chain.back()))); // nothing is passed out and back
    }
  BOOST_TEST(is_basis(classes));
  for(FG::Index i = 0; i < s.basis.number_of_loops(); ++i) {
    const std::vector<Vector> outside = pushed(soup, s.triangulation, s.basis.cycle(i), push);
    const std::vector<Vector> inside = pushed(soup, s.triangulation, s.basis.cycle(i), -push);
    for(const Chain& handle : loops.handles)
      BOOST_TEST(linking_number(pushed(soup, s.triangulation, handle, -push), outside) == 0);
    for(const Chain& tunnel : loops.tunnels)
      BOOST_TEST(linking_number(pushed(soup, s.triangulation, tunnel, push), inside) == 0);
  }
  return loops;
}

FG::Handle_and_tunnel_loops check_solid(const Mesh_soup& soup, std::size_t genus, double push)
{
  return check_solid(soup, genus, push, soup);
}

// A tube about a torus knot, which winds p times about the axis and q times around.
Mesh_soup knotted_tube(int n, int m, int p, int q, double radius)
{
  Mesh_soup soup = torus(n, m, 3, 1);
  const auto center = [=](double t) {
    return Vector{(2 + std::cos(q * t)) * std::cos(p * t), (2 + std::cos(q * t)) * std::sin(p * t), -std::sin(q * t)};
  };
  for(int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n;
    const Vector along = difference(center(t + 1e-5), center(t - 1e-5));
    const double flat = std::hypot(along[0], along[1]);
    const Vector u = {-along[1] / flat, along[0] / flat, 0};
    Vector v = cross(u, along);
    for(double& x : v)
      x /= std::sqrt(dot(along, along));
    for(int j = 0; j < m; ++j) {
      const double c = radius * std::cos(2 * pi * j / m), d = radius * std::sin(2 * pi * j / m);
      for(int k = 0; k < 3; ++k)
        soup.points[static_cast<std::size_t>(i + n * j)][k] = center(t)[k] + c * u[k] + d * v[k];
    }
  }
  return soup;
}

} // namespace

BOOST_AUTO_TEST_CASE(handle_and_tunnel_of_a_torus)
{
  const Mesh_soup soup = torus(12, 8, 3, 1);
  const FG::Handle_and_tunnel_loops loops = check_solid(soup, 1, 0.01);
  Setting s(soup);
  BOOST_TEST(std::abs(length(s, loops.handles[0]) - 16 * std::sin(pi / 8)) < 1e-12); // a meridian
  {
    Network network(s.triangulation);
    network.add_curve(loops.tunnels[0], CGAL::parameters::is_closed(true));
    FG::shorten(network);
    BOOST_TEST(std::abs(network.length(0_c) - 48 * std::sin(pi / 12)) < 1e-12); // the ring about the hole
  }
  // turned inside out
  Mesh_soup inverted = soup;
  for(Corners& t : inverted.triangles)
    std::swap(t[0], t[1]);
  const Setting other(inverted);
  const FG::Handle_and_tunnel_loops same = FG::handle_and_tunnel_loops(other.triangulation);
  BOOST_TEST_REQUIRE(same.handles.size() == 1u);
  BOOST_TEST(std::abs(length(other, same.handles[0]) - 16 * std::sin(pi / 8)) < 1e-12);
  // as long as wide: neither is told by its length
  check_solid(torus(30, 9, 1.2, 1), 1, 0.01);
}

BOOST_AUTO_TEST_CASE(handles_and_tunnels_of_plates)
{
  for(int genus = 1; genus <= 5; ++genus)
    check_solid(plate(genus), static_cast<std::size_t>(genus), 0.05);
  const Setting s(plate(5, 2)); // each of the shortest: around bars of four unit squares, and around holes
  const FG::Handle_and_tunnel_loops shortest = FG::handle_and_tunnel_loops(s.triangulation);
  for(const auto* kind : {&shortest.handles, &shortest.tunnels})
    for(const Chain& chain : *kind)
      BOOST_TEST(std::abs(length(s, chain) - 8) < 1e-12);
  check_solid(scaled(plate(2, 2), 1e-6), 2, 5e-8);
  check_solid(voxel_surface(5, 5, 5, [](int i, int j, int k) { return i % 2 + j % 2 + k % 2 <= 1; }), 28, 0.05);
  // a bar that was cut by the cube's faces, in other directions
  check_solid(mapped(plate(3),
                     [](const Coordinates& p) {
                       return Coordinates{0.6 * p[0] - 0.8 * p[2], p[1] + 0.1 * p[0], 0.8 * p[0] + 0.6 * p[2]};
                     }),
              3, 0.05);
}

// The hole of a solid is outside of it, and inside of a hollow one: then the loops change places.
BOOST_AUTO_TEST_CASE(handles_and_tunnels_far_away)
{
  const Mesh_soup soup = plate(4, 2);
  const Setting here(soup), there(translated(soup, 1e6, -1e6, 1e6));
  const FG::Handle_and_tunnel_loops a = FG::handle_and_tunnel_loops(here.triangulation);
  const FG::Handle_and_tunnel_loops b = FG::handle_and_tunnel_loops(there.triangulation);
  BOOST_TEST((a.handles == b.handles));
  BOOST_TEST((a.tunnels == b.tunnels));
}

// Rounding errors are larger than the thickness of a plate in a plane that is not parallel to an axis.
BOOST_AUTO_TEST_CASE(handles_and_tunnels_of_thin_plates)
{
  const Mesh_soup soup = plate(2);
  for(double size : {1., 0x1p-30, 0x1p20})
    for(double thickness : {0x1p-30, -0x1p-44}) {
      const Mesh_soup thin = mapped(soup, [&](const Coordinates& p) {
        return Coordinates{size * p[0], size * p[1], size * (p[0] + 3 * p[1] + thickness * p[2])};
      });
      check_solid(soup, 2, 0.05, thin);
    }
}

// Loops are projected along a direction to which many faces may be parallel; another direction is used in that case.
BOOST_AUTO_TEST_CASE(handles_and_tunnels_of_a_prism_seen_from_above)
{
  const auto slope = [](std::uint64_t k) {
    return static_cast<double>((1 << 15) + FG::internal::scrambled(k) % (1 << 20));
  };
  const Mesh_soup soup = plate(2);
  check_solid(soup, 2, 0.05, mapped(soup, [&](const Coordinates& p) {
                return Coordinates{0x1p20 * p[0] + slope(0) * p[2], 0x1p20 * p[1] + slope(1) * p[2], slope(2) * p[2]};
              }));
}

BOOST_AUTO_TEST_CASE(handles_and_tunnels_of_knots)
{
  for(const auto& [p, q, radius] : {std::array<double, 3>{2, 3, 0.3}, {3, 2, 0.2}, {2, 5, 0.15}, {1, 4, 0.3}}) {
    const Mesh_soup soup = knotted_tube(120, 8, static_cast<int>(p), static_cast<int>(q), radius);
    Setting s(soup);
    const FG::Handle_and_tunnel_loops loops = check_solid(soup, 1, 0.003);
    BOOST_TEST(length(s, loops.handles[0]) < 2 * pi * radius * 1.5);
    for(const Chain& chain : {loops.handles[0], loops.tunnels[0]}) {
      Network network(s.triangulation);
      network.add_curve(chain, CGAL::parameters::is_closed(true));
      FG::order_overlapping_curves(network);
      const FG::Shortening_report report = FG::shorten(network);
      BOOST_TEST(report.is_complete());
      BOOST_TEST(!network.is_contracted(0_c));
      network.clear();
      s.triangulation.rollback();
    }
  }
}

// Each component by itself, though the rings are linked.
BOOST_AUTO_TEST_CASE(handles_and_tunnels_of_linked_rings)
{
  const Mesh_soup ring = torus(24, 12, 3, 1);
  const Mesh_soup other = mapped(ring, [](const Coordinates& p) { return Coordinates{p[0] + 3, -p[2], p[1]}; });
  const Setting s(disjoint_union(disjoint_union(ring, sphere(2)), other)), alone(ring);
  const FG::Handle_and_tunnel_loops loops = FG::handle_and_tunnel_loops(s.triangulation);
  const FG::Handle_and_tunnel_loops of_one = FG::handle_and_tunnel_loops(alone.triangulation);
  BOOST_TEST_REQUIRE(loops.handles.size() == 2u);
  BOOST_TEST_REQUIRE(loops.tunnels.size() == 2u);
  for(const auto* kind : {&loops.handles, &loops.tunnels}) {
    BOOST_TEST(s.basis.component(s.triangulation.tail((*kind)[0].front())) == 0);
    BOOST_TEST(s.basis.component(s.triangulation.tail((*kind)[1].front())) == 2);
  }
  for(std::size_t i = 0; i < 2; ++i) {
    BOOST_TEST(std::abs(length(s, loops.handles[i]) - length(alone, of_one.handles[0])) < 1e-12);
    BOOST_TEST(std::abs(length(s, loops.tunnels[i]) - length(alone, of_one.tunnels[0])) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(surfaces_that_bound_no_solid)
{
  const auto find = [](const Mesh_soup& soup) {
    const Surface mesh = to_mesh<Surface>(soup);
    const Triangulation triangulation(mesh);
    return FG::handle_and_tunnel_loops(triangulation);
  };
  BOOST_TEST(find(sphere(2)).handles.empty());
  BOOST_CHECK_THROW(find(punctured(plate(2), 1)), FG::Invalid_mesh_error);
  const Mesh_soup ring = torus(12, 8, 3, 1);
  BOOST_CHECK_THROW(find(scaled(ring, 0)), FG::Degenerate_face_error);
  const auto flattened = mapped(ring, [](const Coordinates& p) { return Coordinates{p[0], p[1], 0}; });
  BOOST_CHECK_THROW(find(flattened), FG::Error);
  // once around the axis, turned by half a turn about it: the surface crosses itself all along
  const auto twice = [](const Coordinates& p) {
    const double angle = 2 * std::atan2(p[1], p[0]), r = std::hypot(p[0], p[1]);
    return Coordinates{r * std::cos(angle), r * std::sin(angle), p[2] + 0.3 * std::sin(angle / 2)};
  };
  BOOST_CHECK_THROW(find(mapped(torus(40, 12, 3, 1), twice)), FG::Invalid_mesh_error);
  for(double x : {std::nan(""), std::numeric_limits<double>::infinity(), 1e80}) {
    Mesh_soup broken = ring;
    broken.points[7][1] = x;
    BOOST_CHECK_THROW(find(broken), FG::Invalid_coordinate_error);
  }
}

// Coordinates of very different sizes, which doubles do not decide.
BOOST_AUTO_TEST_CASE(determinants_of_places_are_exact)
{
  using FG::internal::Places_in_space;
  using FG::internal::Weighted_place;
  const std::vector<Vector> points = {{1, 1, 1},           {2, 1, 1},      {1, 2, 1},
                                      {1, 1, 1 + 0x1p-50}, {1e-200, 0, 0}, {1e15, 1, 1}};
  const Places_in_space places(static_cast<FG::Index>(points.size()),
                               [&](FG::Vertex_index v) { return points[static_cast<std::size_t>(v.idx())]; });
  const auto at = [](FG::Index i) { return Weighted_place::at_vertex(FG::Vertex_index(i)); };
  BOOST_TEST(places.side(at(0), at(1), at(2), {0, 0, 1}) == CGAL::POSITIVE);
  BOOST_TEST(places.side(at(0), at(1), at(2), {0, 0, -1}) == CGAL::NEGATIVE);
  BOOST_TEST(places.side(at(0), at(1), at(5), {0, 0, 1}) == CGAL::ZERO);
  BOOST_TEST(places.orientation({at(0), at(1), at(0), at(2), at(0), at(3)}) == CGAL::POSITIVE);
  BOOST_TEST(places.orientation({at(0), at(2), at(0), at(1), at(0), at(3)}) == CGAL::NEGATIVE);
  BOOST_TEST(places.orientation({at(0), at(1), at(0), at(2), at(1), at(2)}) == CGAL::ZERO);
  // from the first place
  BOOST_TEST(places.exact_volume({at(1), at(2), at(3)}).sign() == 1);
  BOOST_TEST(places.exact_volume({at(2), at(1), at(3)}).sign() == -1);
  BOOST_TEST(places.exact_volume({at(1), at(2), at(5)}).sign() == 0);
  const auto [volume, error] = places.volume({at(1), at(2), at(4)});
  BOOST_TEST(std::abs(volume + 1) <= error); // in units of the first two; the third lies below them
}

// Vectors that are part of a basis, and what completes them.
BOOST_AUTO_TEST_CASE(bases_of_integers)
{
  using Rows = FG::internal::Primitive_rows;
  Rows rows(3);
  BOOST_TEST(!rows.add({0, 0, 0}));
  BOOST_TEST(!rows.add({2, 4, -6}));
  BOOST_TEST(rows.add({6, 10, 15}));
  BOOST_TEST(!rows.add({12, 20, 30}));
  BOOST_TEST(!rows.add({8, 14, 21})); // twice (1, 2, 3) more than the first
  BOOST_TEST(rows.add({1, 2, 3}));
  BOOST_TEST(rows.size() == 2u);
  const auto rest = rows.completed_by({{0, 2, 0}, {0, 3, 0}, {6, 10, 15}, {1, 0, 0}, {0, 0, 5}, {0, 0, 7}});
  BOOST_TEST_REQUIRE(rest.size() == 1u);
  BOOST_TEST(is_basis({{6, 10, 15}, {1, 2, 3}, rest[0]}));
  Random_numbers random(4);
  for(int i = 0; i < 100; ++i) {
    // of a lattice that is part of a basis: combinations of the first four unit vectors, mixed
    std::vector<Rows::Row> generators;
    for(std::size_t k = 0; k < 4; ++k) {
      generators.emplace_back(6, 0);
      generators.back()[k] = 1;
      generators.back()[4] = random.below(7) - 3;
    }
    for(int k = 0; k < 30; ++k) {
      const std::size_t a = static_cast<std::size_t>(random.below(4)), b = (a + 1) % 4;
      for(std::size_t c = 0; c < 6; ++c)
        generators[a][c] += (k % 3 - 1) * generators[b][c];
    }
    Rows taken(6);
    std::vector<Class> all;
    for(int k = 0; k < 2; ++k)
      if(taken.add(generators[static_cast<std::size_t>(k)]))
        all.push_back(generators[static_cast<std::size_t>(k)]);
    for(const Rows::Row& row : taken.completed_by(generators))
      all.push_back(row);
    BOOST_TEST_REQUIRE(all.size() == 4u);
    all.push_back({0, 0, 0, 0, 1, 0});
    all.push_back({0, 0, 0, 0, 0, 1});
    BOOST_TEST(is_basis(all));
  }
}
