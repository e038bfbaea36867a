// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Common subdivisions, and what holds for each of them.

#ifndef FLIP_GEODESICS_TEST_SUBDIVIDE_SUBDIVISIONS_H
#define FLIP_GEODESICS_TEST_SUBDIVIDE_SUBDIVISIONS_H

#include "Curve_setting.h"
#include "descriptors.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;
using FG::Edge_index;
using FG::Halfedge_index;
using FG::Input_halfedge_index;
using FG::Vertex_index;
using FG::internal::as_input;
using FG::internal::descriptors;
using FG::internal::first_side;
using FG::internal::Indexed_by;

using Triangulation = Curve_setting::Triangulation;
using Subdivision = FG::Surface_subdivision<Triangulation, Surface>;
using Input_values = std::vector<double>;

// The numbers of vertices or halfedges, as places in an array.
template <class Descriptor>
struct Number_map
{
  using key_type = Descriptor;
  using value_type = FG::Index;
  using reference = FG::Index;
  using category = boost::readable_property_map_tag;

  friend FG::Index get(Number_map, Descriptor d) { return d.idx(); }
};

template <class Mesh>
int euler_characteristic(const Mesh& mesh)
{
  return static_cast<int>(mesh.number_of_vertices()) - static_cast<int>(mesh.number_of_edges()) +
         static_cast<int>(mesh.number_of_faces());
}

template <class Mesh>
int number_of_borders(const Mesh& mesh)
{
  std::vector<bool> is_seen(mesh.number_of_halfedges(), false);
  int count = 0;
  for(auto h : mesh.halfedges()) {
    if(!mesh.is_border(h) || is_seen[h])
      continue;
    ++count;
    for(auto g : CGAL::halfedges_around_face(h, mesh))
      is_seen[g] = true;
  }
  return count;
}

// Each vertex but isolated ones has one fan, and a halfedge on the border if it has any.
inline bool has_manifold_vertices(const Surface& mesh)
{
  std::size_t reached = 0;
  for(auto v : mesh.vertices()) {
    const auto h = mesh.halfedge(v);
    if(h == Surface::null_halfedge())
      continue;
    int border = 0;
    for(auto g : CGAL::halfedges_around_target(h, mesh)) {
      ++reached;
      border += mesh.is_border(g) ? 1 : 0;
    }
    if(border > 1 || (border == 1) != mesh.is_border(h))
      return false;
  }
  return reached == mesh.number_of_halfedges();
}

inline double distance(const Surface& mesh, Surface::Halfedge_index h)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

// Two edges with the same ends are one edge in a file, and to whoever tells edges by their ends.
inline bool has_double_edges(const Surface& mesh)
{
  std::set<std::pair<Surface::Vertex_index, Surface::Vertex_index>> ends;
  for(auto h : mesh.halfedges())
    if(!ends.emplace(mesh.source(h), mesh.target(h)).second)
      return true;
  return false;
}

inline void check_mesh(const Subdivision& subdivision)
{
  const Surface& mesh = subdivision.mesh();
  BOOST_REQUIRE(mesh.is_valid(false));
  BOOST_CHECK(CGAL::is_valid_polygon_mesh(mesh));
  BOOST_CHECK(!has_double_edges(mesh));
  BOOST_CHECK(CGAL::is_triangle_mesh(mesh));
  BOOST_CHECK(has_manifold_vertices(mesh));
}

// Areas of input and intrinsic faces are those of their parts; chains of edges have the lengths of the whole ones.
inline void check_against_both(const Subdivision& subdivision, const Surface& input, const Triangulation& triangulation)
{
  check_mesh(subdivision);
  const Surface& mesh = subdivision.mesh();
  BOOST_CHECK_EQUAL(euler_characteristic(mesh), euler_characteristic(input));
  BOOST_CHECK_EQUAL(number_of_borders(mesh), number_of_borders(input));

  const std::size_t halfedges = static_cast<std::size_t>(triangulation.number_of_halfedges());
  Indexed_by<Input_halfedge_index, std::vector<double>> input_area(halfedges, 0);
  Indexed_by<Halfedge_index, std::vector<double>> intrinsic_area(halfedges, 0);
  for(auto f : mesh.faces()) {
    BOOST_CHECK_GE(subdivision.area(f), 0);
    input_area[subdivision.input_face(f)] += subdivision.area(f);
    intrinsic_area[subdivision.intrinsic_face(f)] += subdivision.area(f);
  }
  std::vector<FG::Intrinsic_face> faces;
  Triangulation untouched(input);
  FG::intrinsic_faces(untouched, std::back_inserter(faces));
  const auto area = [](const FG::Intrinsic_face& f) {
    const double a = f.lengths[0], b = f.lengths[1], c = f.lengths[2];
    return std::sqrt((std::max)((a + b + c) * (b + c - a) * (c + a - b) * (a + b - c), 0.0)) / 4;
  };
  for(const FG::Intrinsic_face& f : faces)
    BOOST_CHECK_SMALL(area(f) - input_area[as_input(f.halfedges[0])], 1e-6 * f.lengths[0]);
  faces.clear();
  FG::intrinsic_faces(triangulation, std::back_inserter(faces));
  for(const FG::Intrinsic_face& f : faces)
    BOOST_CHECK_SMALL(area(f) - intrinsic_area[f.halfedges[0]], 1e-6 * f.lengths[0]);

  std::vector<double> input_length(input.number_of_halfedges(), 0);
  for(auto h : mesh.halfedges())
    if(subdivision.input_halfedge(h) != FG::null_index)
      input_length[subdivision.input_halfedge(h).idx()] += distance(mesh, h);
  for(auto h : input.halfedges())
    BOOST_CHECK_CLOSE_FRACTION(input_length[h], distance(input, h), 1e-10);
  for(Halfedge_index h : descriptors<Halfedge_index>(triangulation.number_of_halfedges())) {
    double length = 0;
    Surface::Vertex_index reached(static_cast<unsigned>(triangulation.tail(h).idx()));
    for(auto along : subdivision.halfedges_along(h)) {
      BOOST_CHECK_EQUAL(mesh.source(along), reached);
      BOOST_CHECK_EQUAL(subdivision.intrinsic_halfedge(along), h);
      reached = mesh.target(along);
      length += distance(mesh, along);
    }
    BOOST_CHECK_EQUAL(reached, Surface::Vertex_index(static_cast<unsigned>(triangulation.head(h).idx())));
    BOOST_CHECK_CLOSE_FRACTION(length, triangulation.length(h), 1e-9);
  }
}

inline std::vector<Mesh_soup> various_meshes()
{
  return {shaken(torus(8, 5, 3, 1), 0.05, 3),
          cube(3),
          genus_3_plate(),
          shaken(flat_grid(6, 6, Diagonal_rule::RANDOM), 0.1, 5),
          grid_with_hole(7, 7, 2, 5, 3, 4),
          tetrahedron(1),
          cone_disk(7, 2, 3)};
}

// Inserts random points of faces and edges.
inline void insert_points(Curve_setting& s, int count, Random_numbers& random)
{
  for(int i = 0; i < count; ++i) {
    const Input_halfedge_index h(random.below(static_cast<int>(s.mesh.number_of_halfedges())));
    const double t = random.uniform(0.1, 0.9), u = i % 3 == 0 ? 0 : random.uniform(0.1, 0.9);
    if(!s.triangulation.input().is_border(h))
      s.network.insert(FG::Surface_location{h, {{3 * t, 3 * (1 - t), 3 * u}}});
  }
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_SUBDIVIDE_SUBDIVISIONS_H
