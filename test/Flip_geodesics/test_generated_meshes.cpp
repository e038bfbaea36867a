// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The generated meshes are what their documentation says: otherwise a test that compares with a closed form proves
// nothing.

#define BOOST_TEST_MODULE generated_meshes

#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "invalid_meshes.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#ifdef CGAL_USE_OPENMESH
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" // OpenMesh copies vectors that its constructor leaves open
#endif
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace Flip_geodesics_test;
namespace utf = boost::unit_test;
using CGAL::Flip_geodesics::Vertex_index;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// ---------------------------------------------------------------- what is expected of each mesh

struct Expected
{
  std::string name;
  Mesh_soup soup;
  int euler_characteristic; // without isolated vertices
  int border_cycles;
  int components;
  double area; // negative: unknown
};

Mesh_soup hilly_grid()
{
  return grid(5, 4, Diagonal_rule::ALTERNATING, [](int i, int j) { return i * j % 3; });
}

std::vector<Expected> closed_meshes()
{
  const double octahedron_area = 8 * std::sqrt(3.) / 4 * 2;
  const double prism_area = 7 * polygon_side(7, 2) * 3 + 2 * 7 * 2 * 2 * std::sin(2 * pi / 7) / 2;
  return {{"tetrahedron", tetrahedron(), 2, 0, 1, 8 * std::sqrt(3.)},
          {"tetrahedron(4)", tetrahedron(4), 2, 0, 1, 16 * 8 * std::sqrt(3.)},
          {"octahedron", octahedron(), 2, 0, 1, octahedron_area},
          {"octahedron(3)", octahedron(3), 2, 0, 1, 9 * octahedron_area},
          {"cube(1)", cube(1), 2, 0, 1, 6},
          {"cube(4)", cube(4), 2, 0, 1, 96},
          {"box", box(1, 2, 3, 3), 2, 0, 1, 22},
          {"genus_3_plate", genus_3_plate(), -4, 0, 1, 2 * (21 - 3) + 20 + 3 * 4},
          {"genus_3_plate(2)", genus_3_plate(2), -4, 0, 1, 4 * (2 * (21 - 3) + 20 + 3 * 4)},
          {"closed cylinder", cylinder(7, 3, 2, 3, true), 2, 0, 1, prism_area},
          {"torus", torus(5, 4, 3, 1), 0, 0, 1, -1},
          {"sphere", sphere(4), 2, 0, 1, -1},
          {"bumpy_sphere", bumpy_sphere(5, 0.1, 2), 2, 0, 1, -1},
          {"random_convex_polyhedron(4)", random_convex_polyhedron(4, 4), 2, 0, 1, -1},
          {"random_convex_polyhedron(100)", random_convex_polyhedron(100, 5), 2, 0, 1, -1},
          {"two cubes", disjoint_union(cube(2), translated(cube(1), 10, 0, 0)), 4, 0, 2, 30},
          {"isolated vertices", with_isolated_vertices(tetrahedron(2), 2, 3), 2, 0, 1, 32 * std::sqrt(3.)}};
}

std::vector<Expected> bordered_meshes()
{
  return {{"flat_grid rising", flat_grid(4, 3, Diagonal_rule::RISING), 1, 1, 1, 12},
          {"flat_grid falling", flat_grid(4, 3, Diagonal_rule::FALLING), 1, 1, 1, 12},
          {"flat_grid alternating", flat_grid(4, 3, Diagonal_rule::ALTERNATING), 1, 1, 1, 12},
          {"flat_grid random", flat_grid(9, 8, Diagonal_rule::RANDOM), 1, 1, 1, 72},
          {"grid", hilly_grid(), 1, 1, 1, -1},
          {"jittered_grid", jittered_grid(9, 8, Diagonal_rule::RANDOM, 0.24, 3), 1, 1, 1, 72},
          {"grid_with_hole", grid_with_hole(7, 6, 2, 5, 1, 4), 0, 2, 1, 42 - 9},
          {"needle_strip", needle_strip(8, 2, 1e-8), 1, 1, 1, 16e-8},
          {"single_triangle", single_triangle(), 1, 1, 1, 6},
          {"open cylinder", cylinder(7, 3, 2, 3), 0, 2, 1, 7 * polygon_side(7, 2) * 3},
          {"cylinder of three sides", cylinder(3, 1, 1, 1), 0, 2, 1, 3 * std::sqrt(3.)},
          {"cone", cone(8, 3, 1, 2), 1, 1, 1, -1},
          {"cone_disk", cone_disk(5, 4, 3), 1, 1, 1, 16 * 2.5 * std::sin(3. / 5)},
          {"thirteen_vertex_cone_disk", thirteen_vertex_cone_disk(), 1, 1, 1, 4 * 3 * std::sin(pi / 6)},
          {"saddle_disk", saddle_disk(6, 2, 3 * pi), 1, 1, 1, 4 * 3 * std::sin(pi / 2)}};
}

std::vector<Expected> all_meshes()
{
  std::vector<Expected> all = closed_meshes(), more = bordered_meshes();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// ---------------------------------------------------------------- measuring soups

double angle(const Coordinates& apex, const Coordinates& p, const Coordinates& q)
{
  Coordinates cross;
  double dot = 0;
  for(int d = 0; d < 3; ++d) {
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    dot += (p[d] - apex[d]) * (q[d] - apex[d]);
    cross[d] = (p[e] - apex[e]) * (q[f] - apex[f]) - (p[f] - apex[f]) * (q[e] - apex[e]);
  }
  return std::atan2(distance(cross, {0, 0, 0}), dot);
}

std::vector<double> angle_sums(const Mesh_soup& soup)
{
  std::vector<double> sums(soup.points.size(), 0);
  for(const Corners& t : soup.triangles)
    for(int i = 0; i < 3; ++i)
      sums[t[i]] += angle(soup.points[t[i]], soup.points[t[(i + 1) % 3]], soup.points[t[(i + 2) % 3]]);
  return sums;
}

double area(const Mesh_soup& soup)
{
  double sum = 0;
  for(const Corners& t : soup.triangles) {
    const Coordinates &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    sum += distance(a, b) * distance(a, c) * std::sin(angle(a, b, c)) / 2;
  }
  return sum;
}

double volume(const Mesh_soup& soup)
{
  double sum = 0;
  for(const Corners& t : soup.triangles) {
    const Coordinates &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    for(int d = 0; d < 3; ++d)
      sum += a[d] * (b[(d + 1) % 3] * c[(d + 2) % 3] - b[(d + 2) % 3] * c[(d + 1) % 3]) / 6;
  }
  return sum;
}

// Components of the triangles joined by edges for which `is_passable(i, j)`.
template <class Predicate>
int number_of_components(const Mesh_soup& soup, const Predicate& is_passable)
{
  std::vector<int> parent(soup.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int t) {
    while(parent[t] != t)
      t = parent[t];
    return t;
  };
  std::map<std::pair<int, int>, int> face_of;
  int components = static_cast<int>(parent.size());
  for(int t = 0; t < static_cast<int>(parent.size()); ++t)
    for(int i = 0; i < 3; ++i) {
      const int u = soup.triangles[t][i], v = soup.triangles[t][(i + 1) % 3];
      face_of[{u, v}] = t;
      const auto neighbor = face_of.find({v, u});
      if(neighbor == face_of.end() || !is_passable(u, v) || root(t) == root(neighbor->second))
        continue;
      parent[root(t)] = root(neighbor->second);
      --components;
    }
  return components;
}

bool is_curve(const Mesh_soup& soup, const Vertex_sequence& curve, bool is_closed)
{
  const Surface_mesh mesh = to_mesh<Surface_mesh>(soup);
  return halfedges_along(mesh, curve, is_closed).size() == curve.size() - (is_closed ? 0 : 1);
}

const auto within = utf::tolerance(1e-9);

} // namespace

// ---------------------------------------------------------------- all meshes, in all mesh types

using Mesh_types = boost::mpl::list<Surface_mesh, CGAL::Polyhedron_3<Kernel>,
                                    CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>
#ifdef CGAL_USE_OPENMESH
                                    ,
                                    OpenMesh::PolyMesh_ArrayKernelT<>
#endif
                                    >;

template <class Mesh>
int number_of_border_cycles(const Mesh& mesh)
{
  std::set<typename boost::graph_traits<Mesh>::halfedge_descriptor> seen;
  int cycles = 0;
  for(auto h : halfedges(mesh)) {
    if(!CGAL::is_border(h, mesh) || !seen.insert(h).second)
      continue;
    ++cycles;
    for(auto g = next(h, mesh); g != h; g = next(g, mesh))
      seen.insert(g);
  }
  return cycles;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(meshes_have_the_expected_topology, Mesh, Mesh_types)
{
  for(const Expected& expected : all_meshes()) {
    BOOST_TEST_CONTEXT(expected.name)
    {
      const Mesh mesh = to_mesh<Mesh>(expected.soup);
      const int used_vertices = static_cast<int>(without_isolated_vertices(expected.soup).points.size());
      const bool has_isolated_vertices = num_vertices(mesh) != static_cast<std::size_t>(used_vertices);
      BOOST_TEST((has_isolated_vertices || CGAL::is_valid_polygon_mesh(mesh))); // which they are not allowed in
      BOOST_TEST(CGAL::is_triangle_mesh(mesh));
      BOOST_TEST(CGAL::is_closed(mesh) == (expected.border_cycles == 0));
      const int edges = static_cast<int>(num_edges(mesh)), faces = static_cast<int>(num_faces(mesh));
      BOOST_TEST(used_vertices - edges + faces == expected.euler_characteristic);
      BOOST_TEST(number_of_border_cycles(mesh) == expected.border_cycles);
      BOOST_TEST(number_of_components(expected.soup, [](int, int) { return true; }) == expected.components);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(vertices_keep_their_indices, Mesh, Mesh_types)
{
  const Mesh_soup soup = with_isolated_vertices(bumpy_sphere(2, 0.1, 6), 1, 1);
  const Mesh mesh = to_mesh<Mesh>(soup);
  BOOST_TEST(num_vertices(mesh) == soup.points.size());
  std::size_t i = 0;
  for(auto v : vertices(mesh)) {
    const auto& p = get(CGAL::vertex_point, mesh, v);
    for(int d = 0; d < 3; ++d)
      BOOST_TEST(static_cast<float>(p[d]) == static_cast<float>(soup.points[i][d])); // OpenMesh has floats
    ++i;
  }
}

BOOST_AUTO_TEST_CASE(polyhedra_with_ids_are_numbered)
{
  using Mesh = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  const Mesh mesh = to_mesh<Mesh>(cube(2));
  std::size_t v = 0, h = 0, f = 0;
  for(auto vertex : vertices(mesh))
    BOOST_TEST(vertex->id() == v++);
  for(auto halfedge : halfedges(mesh))
    BOOST_TEST(halfedge->id() == h++);
  for(auto face : faces(mesh))
    BOOST_TEST(face->id() == f++);
}

BOOST_AUTO_TEST_CASE(areas, *within)
{
  for(const Expected& expected : all_meshes()) {
    if(expected.area >= 0)
      BOOST_TEST_CONTEXT(expected.name) BOOST_TEST(area(expected.soup) == expected.area);
  }
}

BOOST_AUTO_TEST_CASE(no_face_is_degenerate)
{
  for(const Expected& expected : all_meshes())
    for(const Corners& t : expected.soup.triangles)
      BOOST_TEST_CONTEXT(expected.name)
  BOOST_TEST(angle(expected.soup.points[t[0]], expected.soup.points[t[1]], expected.soup.points[t[2]]) > 1e-9);
}

BOOST_AUTO_TEST_CASE(closed_meshes_are_oriented_outward)
{
  for(const Expected& expected : closed_meshes())
    BOOST_TEST_CONTEXT(expected.name) BOOST_TEST(volume(expected.soup) > 0);
}

BOOST_AUTO_TEST_CASE(closed_meshes_satisfy_gauss_bonnet, *within)
{
  for(const Expected& expected : closed_meshes()) {
    const std::vector<double> sums = angle_sums(without_isolated_vertices(expected.soup));
    const double curvature =
        std::accumulate(sums.begin(), sums.end(), 100.0, [](double c, double s) { return c + 2 * pi - s; });
    BOOST_TEST_CONTEXT(expected.name) BOOST_TEST(curvature == 100 + 2 * pi * expected.euler_characteristic);
  }
}

// ---------------------------------------------------------------- angles

namespace {

// The angle is `special` at the first `count` vertices and `others` at the rest.
void check_angles(const Mesh_soup& soup, std::size_t count, double special, double others)
{
  const std::vector<double> sums = angle_sums(soup);
  for(std::size_t v = 0; v < sums.size(); ++v)
    BOOST_TEST(sums[v] == (v < count ? special : others));
}

} // namespace

BOOST_AUTO_TEST_CASE(angles_of_polyhedra, *within)
{
  check_angles(tetrahedron(), 4, pi, pi);
  check_angles(tetrahedron(4), 4, pi, 2 * pi);
  check_angles(octahedron(3), 6, 4 * pi / 3, 2 * pi);
  const std::vector<double> sums = angle_sums(box(1, 2, 3, 3));
  BOOST_TEST(std::count_if(sums.begin(), sums.end(), [](double s) { return std::abs(s - 1.5 * pi) < 1e-12; }) == 8);
  BOOST_TEST(std::count_if(sums.begin(), sums.end(), [](double s) { return std::abs(s - 2 * pi) < 1e-12; }) ==
             static_cast<std::ptrdiff_t>(sums.size() - 8));
}

BOOST_AUTO_TEST_CASE(angles_at_apexes, *within)
{
  BOOST_TEST(angle_sums(cone(8, 3, 1, 2))[0] == cone_angle(8, 1, 2));
  BOOST_TEST(angle_sums(cone_disk(5, 4, 3))[0] == 3);
  BOOST_TEST(angle_sums(thirteen_vertex_cone_disk())[0] == pi);
  for(double total : {2 * pi, 7.0, 3 * pi})
    BOOST_TEST(angle_sums(saddle_disk(4, 3, total))[0] == total);
  BOOST_TEST(thirteen_vertex_cone_disk().points.size() == 13);
  for(int r = 1; r <= 4; ++r)
    for(const Mesh_soup& soup : {cone_disk(6, 4, 3), saddle_disk(6, 4, 8)})
      for(Vertex_index v : disk_ring(6, r))
        BOOST_TEST(distance(soup.points[v.idx()], soup.points[0]) == r);
}

BOOST_AUTO_TEST_CASE(interior_vertices_of_developable_meshes_are_flat, *within)
{
  const auto roof = grid(6, 3, Diagonal_rule::RANDOM, [](int i, int) { return i * i % 5; });
  for(const Mesh_soup& soup : {roof, jittered_grid(6, 3, Diagonal_rule::RANDOM, 0.2, 7)})
    for(int i = 1; i < 6; ++i)
      for(int j = 1; j < 3; ++j)
        BOOST_TEST(angle_sums(soup)[grid_vertex(6, i, j)] == 2 * pi);
  const std::vector<double> sums = angle_sums(cylinder(5, 3, 2, 1));
  for(int v = 0; v < 20; ++v)
    BOOST_TEST(sums[v] == (v < 5 || v >= 15 ? pi : 2 * pi));
}

BOOST_AUTO_TEST_CASE(parts_of_a_tetrahedron_are_coplanar_exactly)
{
  const Mesh_soup soup = tetrahedron(7);
  for(const Coordinates& p : soup.points) {
    BOOST_TEST(p[0] == std::round(p[0]));
    const std::array<double, 4> planes = {p[0] + p[1] + p[2], p[0] - p[1] - p[2], p[1] - p[0] - p[2],
                                          p[2] - p[0] - p[1]};
    BOOST_TEST(std::count(planes.begin(), planes.end(), -7) >= 1);
  }
}

// All other vertices lie strictly below each face.
BOOST_AUTO_TEST_CASE(random_polyhedra_are_strictly_convex)
{
  const Mesh_soup soup = random_convex_polyhedron(60, 8);
  BOOST_TEST(soup.triangles.size() == 2 * soup.points.size() - 4);
  for(const Corners& t : soup.triangles)
    for(std::size_t v = 0; v < soup.points.size(); ++v) {
      const bool is_corner = std::count(t.begin(), t.end(), static_cast<int>(v)) > 0;
      BOOST_TEST((is_corner || !internal::sees(soup, soup.points[v], t)));
    }
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_mesh)
{
  BOOST_TEST((bumpy_sphere(3, 0.1, 1).points == bumpy_sphere(3, 0.1, 1).points));
  BOOST_TEST((bumpy_sphere(3, 0.1, 1).points != bumpy_sphere(3, 0.1, 2).points));
  BOOST_TEST(Random_numbers(5489).below(1 << 30) ==
             static_cast<int>(3499211612u % (1u << 30))); // the standard's engine
}

// ---------------------------------------------------------------- curves

BOOST_AUTO_TEST_CASE(loops_follow_edges)
{
  for(int k = 0; k <= 3; ++k)
    BOOST_TEST(is_curve(cylinder(7, 3, 1, 1), cylinder_ring(7, k), true));
  for(int r = 1; r <= 2; ++r)
    BOOST_TEST(is_curve(thirteen_vertex_cone_disk(), disk_ring(6, r), true));
  BOOST_TEST(is_curve(saddle_disk(6, 2, 8), disk_arc(6, 2, 4, 4), false));
  for(int n : {2, 4, 6})
    BOOST_TEST(is_curve(tetrahedron(n), tetrahedron_loop(n), true));
  for(int n : {1, 2, 3})
    for(const Vertex_sequence& loop : genus_3_loops(n))
      BOOST_TEST(is_curve(genus_3_plate(n), loop, true));
  const Vertex_index opposite(index_of(cube(2), {2, 2, 2}));
  BOOST_CHECK_THROW(is_curve(cube(2), {0_v, opposite}, false), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(lengths_of_loops, *within)
{
  BOOST_TEST(length(tetrahedron(4), tetrahedron_loop(4), true) == 2 * 4 * std::sqrt(8.));
  for(const Vertex_sequence& loop : genus_3_loops(3))
    BOOST_TEST(length(genus_3_plate(3), loop, true) == 12);
  BOOST_TEST(length(cylinder(7, 3, 2, 1), cylinder_ring(7, 1), true) == 7 * polygon_side(7, 2));
}

// Cutting along three disjoint loops of a basis leaves a connected surface; so they are independent in homology.
BOOST_AUTO_TEST_CASE(loops_of_the_plate_are_a_homology_basis)
{
  const Mesh_soup soup = genus_3_plate(2);
  const std::vector<Vertex_sequence> loops = genus_3_loops(2);
  for(int first : {0, 3}) {
    std::set<std::pair<int, int>> cut;
    for(int k = first; k < first + 3; ++k)
      for(std::size_t i = 0; i < loops[k].size(); ++i)
        cut.insert(std::minmax({loops[k][i].idx(), loops[k][(i + 1) % loops[k].size()].idx()}));
    BOOST_TEST(cut.size() == 24);
    BOOST_TEST(number_of_components(soup, [&](int u, int v) { return cut.count(std::minmax({u, v})) == 0; }) == 1);
  }
  for(int k = 0; k < 3; ++k)
    for(int l = 3; l < 6; ++l) {
      const std::set<Vertex_index> vertices(loops[k].begin(), loops[k].end());
      const auto is_common = [&](Vertex_index v) { return vertices.count(v) > 0; };
      BOOST_TEST(std::count_if(loops[l].begin(), loops[l].end(), is_common) == (l == k + 3 ? 1 : 0));
    }
}

BOOST_AUTO_TEST_CASE(torus_loops_close_after_their_turns)
{
  const int n = 5, m = 4;
  const Mesh_soup soup = torus(n, m, 3, 1);
  for(const auto& [p, q] :
      std::vector<std::pair<int, int>>{{1, 0}, {0, 1}, {0, -1}, {-1, 0}, {1, 1}, {2, 3}, {-3, 2}, {5, -4}})
  {
    const Vertex_sequence loop = torus_loop(n, m, p, q);
    BOOST_TEST(is_curve(soup, loop, true));
    int x = 0, y = 0; // steps, unwound
    for(std::size_t k = 0; k < loop.size(); ++k) {
      const int u = loop[k].idx(), v = loop[(k + 1) % loop.size()].idx();
      x += (v % n - u % n + n + 1) % n - 1;
      y += (v / n - u / n + m + 1) % m - 1;
    }
    BOOST_TEST(x == p * n);
    BOOST_TEST(y == q * m);
  }
}

BOOST_AUTO_TEST_CASE(helices_climb_the_cylinder)
{
  for(int steps : {0, 3, 7, 16}) {
    const Vertex_sequence helix = cylinder_helix(7, 3, 2, steps);
    BOOST_TEST(is_curve(cylinder(7, 3, 1, 1), helix, false));
    BOOST_TEST(helix.size() == static_cast<std::size_t>(1 + 3 + steps));
    BOOST_TEST(helix.front() == 2_v);
    BOOST_TEST(helix.back() == Vertex_index((2 + steps) % 7 + 21));
  }
}

BOOST_AUTO_TEST_CASE(curves_on_grids_follow_edges)
{
  const Mesh_soup soup = flat_grid(6, 4, Diagonal_rule::ALTERNATING);
  for(const auto& paths : {overlapping_paths(6, 2), overlapping_crossing_paths(6, 2), crossing_paths(6, 4, 3, 2)})
    for(const Vertex_sequence& path : paths) {
      BOOST_TEST(is_curve(soup, path, false));
      BOOST_TEST(is_curve(soup, out_and_back(path), false));
      BOOST_TEST(is_curve(soup, walked_repeatedly(path, 3), false));
      BOOST_TEST(is_curve(soup, with_detours(soup, path, false), false));
    }
  BOOST_TEST((out_and_back({1_v, 2_v, 3_v}) == Vertex_sequence{1_v, 2_v, 3_v, 2_v, 1_v}));
  BOOST_TEST((walked_repeatedly({1_v, 2_v}, 2) == Vertex_sequence{1_v, 2_v, 1_v, 2_v, 1_v, 2_v}));
  BOOST_TEST((reversed({1_v, 2_v, 3_v}) == Vertex_sequence{3_v, 2_v, 1_v}));
  BOOST_TEST((vertex_path_on_grid(6, {{1, 1}, {1, 3}, {0, 3}}) == Vertex_sequence{8_v, 15_v, 22_v, 21_v}));
}

BOOST_AUTO_TEST_CASE(detours_make_loops_longer)
{
  const Mesh_soup soup = tetrahedron(4);
  const Vertex_sequence loop = tetrahedron_loop(4), longer = with_detours(soup, loop, true, 2);
  BOOST_TEST(is_curve(soup, longer, true));
  BOOST_TEST(longer.size() == loop.size() + (loop.size() + 1) / 2);
  BOOST_TEST(length(soup, longer, true) > length(soup, loop, true));
}

BOOST_AUTO_TEST_CASE(points_are_found_by_their_coordinates)
{
  const Mesh_soup soup = grid_with_hole(7, 6, 2, 5, 1, 4);
  BOOST_TEST(index_of(soup, {3, 2, 0}) == -1);
  BOOST_TEST((soup.points[index_of(soup, {5, 4, 0})] == Coordinates{5, 4, 0}));
}

// ---------------------------------------------------------------- metrics

BOOST_AUTO_TEST_CASE_TEMPLATE(random_metrics_satisfy_the_triangle_inequality, Mesh, Mesh_types)
{
  const Mesh mesh = to_mesh<Mesh>(sphere(4));
  for(int levels : {0, 3}) {
    const auto lengths = edge_lengths(mesh, Random_metric{9, levels});
    BOOST_TEST(lengths.size() == num_edges(mesh));
    for(auto f : faces(mesh)) {
      const auto h = halfedge(f, mesh);
      std::array<double, 3> sides = {lengths.at(edge(h, mesh)), lengths.at(edge(next(h, mesh), mesh)),
                                     lengths.at(edge(prev(h, mesh), mesh))};
      std::sort(sides.begin(), sides.end());
      BOOST_TEST(sides[0] >= 1);
      BOOST_TEST(sides[0] + sides[1] > sides[2]);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_metric_depends_on_end_points_only)
{
  const Random_metric metric = {10, 0};
  BOOST_TEST(metric(3, 4) == metric(4, 3));
  BOOST_TEST(metric(3, 4) != metric(3, 5));
  BOOST_TEST(metric(3, 4) != (Random_metric{11, 0}(3, 4)));
  BOOST_TEST(Impossible_metric()(1, 0) == 3);
  BOOST_TEST(Impossible_metric()(0, 2) + Impossible_metric()(1, 2) < 3);
}

BOOST_AUTO_TEST_CASE(the_flat_torus_is_flat, *within)
{
  const Flat_torus_metric metric = {5, 4, 10, 6};
  std::vector<double> sums(20, 0);
  for(const Corners& t : torus(5, 4, 3, 1).triangles)
    for(int i = 0; i < 3; ++i) {
      const double a = metric(t[i], t[(i + 1) % 3]), b = metric(t[i], t[(i + 2) % 3]);
      const double c = metric(t[(i + 1) % 3], t[(i + 2) % 3]);
      sums[t[i]] += std::acos((a * a + b * b - c * c) / (2 * a * b));
    }
  for(double sum : sums)
    BOOST_TEST(sum == 2 * pi);
  BOOST_TEST(metric(0, 4) == 2);    // along the side a, around the end
  BOOST_TEST(metric(15, 0) == 1.5); // along the side b
  BOOST_TEST(metric(0, 6) == 2.5);
}

// ---------------------------------------------------------------- invalid inputs

BOOST_AUTO_TEST_CASE(soups_that_are_no_manifolds_are_not_built)
{
  BOOST_CHECK_THROW(to_mesh<Surface_mesh>(with_non_manifold_edge()), std::exception);
  BOOST_CHECK_THROW(to_mesh<Surface_mesh>(with_non_manifold_vertex()), std::exception);
  BOOST_CHECK_THROW(to_mesh<Surface_mesh>(with_inconsistent_orientation()), std::exception);
  BOOST_CHECK_THROW(to_mesh<Surface_mesh>(moebius_band()), std::exception);
}

BOOST_AUTO_TEST_CASE(soups_with_bad_points_are_built)
{
  for(const Mesh_soup& soup : {with_zero_length_edge(), with_zero_area_face(), with_nan_coordinate(),
                               with_infinite_coordinate(), with_huge_coordinate()})
    BOOST_TEST(CGAL::is_valid_polygon_mesh(to_mesh<Surface_mesh>(soup)));
  BOOST_TEST(area(Mesh_soup{with_zero_area_face().points, {{0, 2, 3}}}) == 0);
}

BOOST_AUTO_TEST_CASE(files_have_names_of_their_own)
{
  std::set<std::string> names;
  std::set<Defect> defects;
  for(const Invalid_file& file : invalid_files()) {
    BOOST_TEST(names.insert(file.name).second);
    defects.insert(file.defect);
  }
  BOOST_TEST(defects.size() == 7);
}

BOOST_AUTO_TEST_CASE(off_files_keep_all_digits)
{
  const Mesh_soup soup = bumpy_sphere(2, 0.2, 12);
  std::istringstream in(to_off(soup));
  std::string header;
  std::size_t points = 0, triangles = 0, zero = 1;
  in >> header >> points >> triangles >> zero;
  BOOST_TEST(header == "OFF");
  BOOST_TEST(triangles == soup.triangles.size());
  BOOST_TEST(points == soup.points.size());
  for(const Coordinates& p : soup.points)
    for(double expected : p) {
      double x = 0;
      in >> x;
      BOOST_TEST(x == expected);
    }
}
