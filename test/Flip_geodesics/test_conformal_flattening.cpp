// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Flattening along cuts: developable surfaces come out with their lengths, curved ones with their angle sums.

#include "Double_triangulation.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "mesh_soup.h"

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Conformal_flattening.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

#endif

#define BOOST_TEST_MODULE conformal_flattening
#include <boost/test/unit_test.hpp>

#ifdef CGAL_EIGEN3_ENABLED

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = Double_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Flattening = FG::Conformal_flattening<Triangulation>;

// A copy of a vertex is neither a vertex nor a number.
template <class Element>
constexpr bool has_point = std::is_invocable_v<decltype(&Flattening::point), const Flattening&, Element>;
static_assert(has_point<FG::Vertex_copy_index> && !has_point<FG::Vertex_index> && !has_point<int>);

double flat_length(const Flattening& flattening, const Triangulation& triangulation, FG::Halfedge_index h)
{
  const auto& p = flattening.point(flattening.copy_at(h));
  const auto& q = flattening.point(flattening.copy_at(triangulation.next(h)));
  return std::hypot(q[0] - p[0], q[1] - p[1]);
}

// By how much an edge's length in the plane misses its scaled length, relative to it, at most; every face must keep its
// orientation.
double largest_length_error(const Flattening& flattening, const Triangulation& triangulation)
{
  double error = 0;
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(triangulation, std::back_inserter(faces));
  for(const FG::Intrinsic_face& face : faces) {
    FG::Vertex_copy_index copies[3];
    for(int i = 0; i < 3; ++i)
      copies[i] = flattening.copy_at(face.halfedges[i]);
    for(int i = 0; i < 3; ++i) {
      const double scale = std::exp((flattening.log_scale(copies[i]) + flattening.log_scale(copies[(i + 1) % 3])) / 2);
      const double expected = scale * face.lengths[i];
      error =
          std::max(error, std::abs(flat_length(flattening, triangulation, face.halfedges[i]) - expected) / expected);
    }
    const auto &p = flattening.point(copies[0]), &q = flattening.point(copies[1]), &r = flattening.point(copies[2]);
    BOOST_TEST((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0);
  }
  return error;
}

double largest_scale(const Flattening& flattening)
{
  double result = 0;
  for(FG::Index copy = 0; copy < flattening.number_of_copies(); ++copy)
    result = std::max(result, std::abs(flattening.log_scale(FG::Vertex_copy_index(copy))));
  return result;
}

FG::Curve_index add_path(Network& network, FG::Vertex_index s, FG::Vertex_index t)
{
  FG::Shortest_edge_path<Triangulation> search(network.triangulation());
  return network.add_curve(FG::shortest_halfedges_through(search, Vertex_sequence{s, t}));
}

} // namespace

BOOST_AUTO_TEST_CASE(a_cylinder_cut_from_border_to_border_rolls_out_to_a_strip)
{
  const int n = 12, m = 6;
  const Mesh mesh = to_mesh<Mesh>(cylinder(n, m, 1, 3));
  Triangulation triangulation(mesh);
  Network network(triangulation);
  add_path(network, 0_v, FG::Vertex_index(3 + n * m));
  FG::shorten(network);
  const Flattening flattening(network);
  BOOST_TEST(largest_scale(flattening) < 1e-12);
  BOOST_TEST(largest_length_error(flattening, triangulation) < 1e-11);
  BOOST_TEST(flattening.layout_error() < 1e-11);

  // On the common subdivision, isometric means that areas are kept.
  auto subdivision = FG::common_subdivision(triangulation, mesh);
  auto coordinates = subdivision.mesh().add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv", {}).first;
  flattening.carry_to(subdivision, coordinates);
  for(Mesh::Face_index f : subdivision.mesh().faces()) {
    const Mesh::Halfedge_index h = subdivision.mesh().halfedge(f), hn = subdivision.mesh().next(h);
    const double area = CGAL::area(coordinates[subdivision.mesh().prev(h)], coordinates[h], coordinates[hn]);
    BOOST_TEST(std::abs(area - subdivision.area(f)) < 1e-11);
  }

  // The two sides of the cut are parallel, one circumference apart.
  const FG::Halfedge_index h = network.halfedge(network.first_segment(0_c));
  const auto& left = flattening.point(flattening.copy_at(h));
  const auto& right = flattening.point(flattening.copy_at(triangulation.next(Triangulation::twin(h))));
  BOOST_TEST(std::abs(std::hypot(left[0] - right[0], left[1] - right[1]) - n * polygon_side(n, 1)) < 1e-11);
}

BOOST_AUTO_TEST_CASE(a_cone_cut_to_its_apex_rolls_out_to_a_sector)
{
  const int n = 10, m = 5;
  const Mesh mesh = to_mesh<Mesh>(cone(n, m, 2, 3));
  Triangulation triangulation(mesh);
  Network network(triangulation);
  add_path(network, 0_v, FG::Vertex_index(disk_vertex(n, m, 4)));
  FG::shorten(network);
  const Flattening flattening(network);
  BOOST_TEST(largest_scale(flattening) < 1e-12);
  BOOST_TEST(largest_length_error(flattening, triangulation) < 1e-11);
}

BOOST_AUTO_TEST_CASE(curved_surfaces_are_flattened_conformally)
{
  // A star of four cuts, to corners of the octahedron that the sphere comes from.
  const int n = 10;
  const Mesh_soup soup = bumpy_sphere(n, 0.1, 4);
  const Mesh mesh = to_mesh<Mesh>(soup);
  Triangulation triangulation(mesh);
  Network network(triangulation);
  FG::Vertex_index top = 0_v;
  Vertex_sequence ends;
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    const Coordinates p = normalized(soup.points[v]);
    if(p[2] > 1 - 1e-9)
      top = FG::Vertex_index(static_cast<FG::Index>(v));
    if(std::abs(p[0]) > 1 - 1e-9 || std::abs(p[1]) > 1 - 1e-9)
      ends.emplace_back(static_cast<FG::Index>(v));
  }
  BOOST_TEST(ends.size() == 4u);
  for(FG::Vertex_index end : ends)
    add_path(network, top, end);
  const Flattening flattening(network);
  BOOST_TEST(flattening.angle_error() <= 1e-10);
  BOOST_TEST(flattening.iterations() > 0);
  BOOST_TEST(largest_scale(flattening) > 0.1);
  BOOST_TEST(largest_length_error(flattening, triangulation) < 1e-7);
  BOOST_TEST(flattening.layout_error() < 1e-7);
  // Both sides of the seam are as long as the curve was on the surface.
  network.for_each_segment(0_c, [&](FG::Segment_index s) {
    const FG::Halfedge_index h = network.halfedge(s);
    const double expected = triangulation.length(h);
    BOOST_TEST(std::abs(flat_length(flattening, triangulation, h) - expected) < 1e-7 * expected);
    const double on_other_side = flat_length(flattening, triangulation, Triangulation::twin(h));
    BOOST_TEST(std::abs(on_other_side - expected) < 1e-7 * expected);
  });
}

BOOST_AUTO_TEST_CASE(a_torus_is_flattened_along_two_loops)
{
  const int n = 14, m = 8;
  const Mesh mesh = to_mesh<Mesh>(torus(n, m, 3, 1));
  Triangulation triangulation(mesh);
  Network network(triangulation);
  Vertex_sequence along, around;
  for(int i = 0; i < n; ++i)
    along.emplace_back(i);
  for(int j = 0; j < m; ++j)
    around.emplace_back(n * j);
  network.add_curve(FG::halfedges_through(triangulation, along, CGAL::parameters::is_closed(true)),
                    CGAL::parameters::is_closed(true));
  BOOST_CHECK_THROW(Flattening{network}, FG::Flattening_error); // an annulus
  network.add_curve(FG::halfedges_through(triangulation, around, CGAL::parameters::is_closed(true)),
                    CGAL::parameters::is_closed(true));
  const Flattening flattening(network); // as drawn: crossing curves are no obstacle to cutting
  BOOST_TEST(largest_length_error(flattening, triangulation) < 1e-7);
  BOOST_TEST(flattening.layout_error() < 1e-7);
}

BOOST_AUTO_TEST_CASE(straightened_seams_are_refined_first)
{
  const int n = 24, m = 12;
  const Mesh mesh = to_mesh<Mesh>(torus(n, m, 3, 1));
  Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  Network network(triangulation);
  const Vertex_sequence along = {0_v, 8_v, 16_v}, around = {0_v, FG::Vertex_index(4 * n), FG::Vertex_index(8 * n)};
  for(const Vertex_sequence& way : {along, around})
    network.add_curve(FG::shortest_halfedges_through(search, way, CGAL::parameters::is_closed(true)),
                      CGAL::parameters::is_closed(true));
  network.fix_nodes_at(0_v);
  FG::order_overlapping_curves(network);
  FG::shorten(network);
  FG::Refinement_options options;
  options.smallest_angle = 20;
  BOOST_TEST(FG::refine(network, options).is_complete());
  const Flattening flattening(network);
  BOOST_TEST(flattening.angle_error() <= 1e-10);
  BOOST_TEST(flattening.layout_error() < 1e-11);
  BOOST_TEST(largest_length_error(flattening, triangulation) < 1e-9);
}

BOOST_AUTO_TEST_CASE(what_is_no_disk_is_refused)
{
  const Mesh closed = to_mesh<Mesh>(sphere(3));
  Triangulation sphere_triangulation(closed);
  Network nothing(sphere_triangulation);
  BOOST_CHECK_THROW(Flattening{nothing}, FG::Flattening_error);

  const Mesh two =
      to_mesh<Mesh>(disjoint_union(flat_grid(2, 2, Diagonal_rule::RISING), flat_grid(2, 2, Diagonal_rule::RISING)));
  Triangulation two_triangulation(two);
  Network no_curves(two_triangulation);
  BOOST_CHECK_THROW(Flattening{no_curves}, FG::Flattening_error);

  Mesh without_faces;
  for(int i = 0; i < 2; ++i, without_faces.add_vertex(Point(0, 0, 0))) {
    Triangulation triangulation(without_faces);
    Network network(triangulation);
    const auto is_told = [](const std::exception& e) { return e.what() == std::string("the surface has no faces"); };
    BOOST_CHECK_EXCEPTION(Flattening{network}, FG::Flattening_error, is_told);
    BOOST_CHECK_EXCEPTION(FG::refine_and_flatten(network), FG::Flattening_error, is_told);
  }

  const Mesh disk = to_mesh<Mesh>(jittered_grid(5, 5, Diagonal_rule::RISING, 0.2, 1));
  Triangulation disk_triangulation(disk);
  Network uncut(disk_triangulation);
  const Flattening flattening(uncut);
  BOOST_TEST(largest_length_error(flattening, disk_triangulation) < 1e-11);
}

// Whole Newton steps would violate triangle inequalities on the way.
BOOST_AUTO_TEST_CASE(steep_cones_are_flattened_by_shorter_steps)
{
  for(const Mesh_soup& soup : {cone(8, 4, 1, 4), cone(8, 4, 1, 8), cone(5, 3, 1, 4), cone(5, 3, 1, 8)}) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation triangulation(mesh);
    Network uncut(triangulation);
    const Flattening flattening(uncut);
    BOOST_TEST(flattening.angle_error() <= 1e-10);
    BOOST_TEST(flattening.layout_error() < 1e-7);
    BOOST_TEST(largest_length_error(flattening, triangulation) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(the_largest_face_lies_at_the_origin)
{
  const Mesh mesh = to_mesh<Mesh>(cone(8, 4, 1, 4));
  Triangulation triangulation(mesh);
  Network uncut(triangulation);
  const Flattening flattening(uncut);
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(triangulation, std::back_inserter(faces));
  const auto corner = [&](const FG::Intrinsic_face& face, int i) {
    return flattening.point(flattening.copy_at(face.halfedges[i]));
  };
  const auto area = [&](const FG::Intrinsic_face& face) {
    const auto p = corner(face, 0), q = corner(face, 1), r = corner(face, 2);
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  double largest = 0, at_origin = 0;
  for(const FG::Intrinsic_face& face : faces) {
    largest = std::max(largest, area(face));
    if(corner(face, 0)[0] == 0 && corner(face, 0)[1] == 0 && corner(face, 1)[1] == 0)
      at_origin = std::max(at_origin, area(face));
  }
  BOOST_TEST(at_origin >= largest * (1 - 1e-9));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_flattened_is_told)
{
  const auto names = [](const std::string& words) {
    return [words](const FG::Flattening_error& e) { return std::string(e.what()).find(words) != std::string::npos; };
  };
  // A disk and a torus have the Euler characteristic of a disk.
  const Mesh two = to_mesh<Mesh>(disjoint_union(flat_grid(2, 2, Diagonal_rule::RISING), torus(6, 5, 3, 1)));
  Triangulation two_triangulation(two);
  Network two_uncut(two_triangulation);
  BOOST_CHECK_EXCEPTION(Flattening{two_uncut}, FG::Flattening_error, names("not connected"));

  // Nothing is inserted before this is found.
  BOOST_CHECK_EXCEPTION(FG::refine_and_flatten(two_uncut), FG::Flattening_error, names("not connected"));
  BOOST_TEST(two_triangulation.number_of_vertices() == static_cast<FG::Index>(two.number_of_vertices()));

  const Mesh spike = to_mesh<Mesh>(cone(3, 2, 1, 4));
  Triangulation spike_triangulation(spike);
  Network spike_uncut(spike_triangulation);
  BOOST_CHECK_EXCEPTION(Flattening{spike_uncut}, FG::Flattening_error, names("triangle inequality"));

  const Mesh hill = to_mesh<Mesh>(cone(8, 4, 1, 2));
  Triangulation hill_triangulation(hill);
  Network hill_uncut(hill_triangulation);
  BOOST_CHECK_EXCEPTION((Flattening{hill_uncut, 1e-30}), FG::Flattening_error, names("differ from 2 pi"));
}

// The cut graph passes a vertex that is collinear with its ends up to rounding errors.
BOOST_AUTO_TEST_CASE(a_cut_graph_that_touches_a_vertex_is_flattened)
{
  const Mesh mesh = to_mesh<Mesh>(torus(24, 12, 3, 1));
  FG::Intrinsic_triangulation<Mesh> triangulation(mesh);
  FG::Edge_path_network<FG::Intrinsic_triangulation<Mesh>> network(triangulation);
  FG::add_cut_graph(network);
  FG::shorten_cut_graph(network);
  const auto flattening = FG::refine_and_flatten(network);
  BOOST_TEST(flattening.angle_error() <= 1e-10);
  BOOST_TEST(flattening.layout_error() < 1e-9);

  // Curves along several edges of a straight line, with a hole in each face.
  const Mesh_soup coarse = torus(3, 3, 1, 0.4);
  for(std::size_t f = 0; f < coarse.triangles.size(); ++f) {
    Mesh_soup soup = coarse;
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(f));
    const Mesh with_hole = to_mesh<Mesh>(soup);
    FG::Intrinsic_triangulation<Mesh> t(with_hole);
    FG::Edge_path_network<FG::Intrinsic_triangulation<Mesh>> cuts(t);
    FG::add_cut_graph(cuts);
    FG::shorten_cut_graph(cuts);
    BOOST_CHECK_NO_THROW(FG::refine_and_flatten(cuts));
  }
}

BOOST_AUTO_TEST_CASE(edges_are_split_until_scale_factors_exist)
{
  for(const Mesh_soup& soup : {cone(3, 2, 1, 4), cone(3, 1, 1, 2), cone(4, 1, 1, 2)}) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation triangulation(mesh);
    Network uncut(triangulation);
    const Flattening flattening = FG::refine_and_flatten(uncut);
    BOOST_TEST(flattening.angle_error() <= 1e-10);
    BOOST_TEST(flattening.layout_error() < 1e-7);
    BOOST_TEST(largest_length_error(flattening, triangulation) < 1e-7);
  }
}

// Scale factors at the tip would be far below the precision of coordinates.
BOOST_AUTO_TEST_CASE(a_long_spike_must_be_cut)
{
  const Mesh_soup soup = cone(8, 4, 1, 60);
  const Mesh mesh = to_mesh<Mesh>(soup);
  Triangulation triangulation(mesh);
  Network uncut(triangulation);
  std::size_t tip = 0;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    tip = soup.points[v][2] > soup.points[tip][2] ? v : tip;
  BOOST_CHECK_EXCEPTION(FG::refine_and_flatten(uncut), FG::Flattening_error,
                        [tip](const FG::Flattening_error& e) { return e.elements() == std::vector<std::size_t>{tip}; });

  // With a cut from the border to the tip.
  Triangulation again(mesh);
  Network network(again);
  add_path(network, FG::Vertex_index(static_cast<FG::Index>(tip)), FG::Vertex_index(disk_vertex(8, 4, 4)));
  BOOST_TEST(FG::refine_and_flatten(network).angle_error() <= 1e-10);

  // The faces at the tip of a shorter one have corners on the border, to which no cut helps.
  const Mesh steep = to_mesh<Mesh>(cone(9, 1, 1, 10));
  Triangulation of_steep(steep);
  Network no_cut(of_steep);
  BOOST_CHECK_EXCEPTION(FG::refine_and_flatten(no_cut), FG::Flattening_error,
                        [](const FG::Flattening_error& e) { return e.elements() == std::vector<std::size_t>{0}; });
}

#else

BOOST_AUTO_TEST_CASE(conformal_flattening_needs_eigen)
{
  BOOST_TEST_MESSAGE("SKIPPED: Eigen is not installed");
  BOOST_TEST(!Flip_geodesics_test::sphere(2).points.empty());
}

#endif // CGAL_EIGEN3_ENABLED
