// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_INSERT_CURVES_INSERTIONS_H
#define FLIP_GEODESICS_TEST_INSERT_CURVES_INSERTIONS_H

#include "../generated_meshes.h"
#include "../mesh_soup.h"

#include <CGAL/Flip_geodesics/insert_curves.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

namespace Flip_geodesics_test {

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Inexact::Point_3>;
using Exact_mesh = CGAL::Surface_mesh<Exact::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Inexact>;

template <class M>
using Face_of = typename boost::graph_traits<M>::face_descriptor;
template <class M>
using Location_of = std::pair<Face_of<M>, std::array<double, 3>>;
template <class M>
using Polyline_of = std::vector<Location_of<M>>;

template <class M>
double length_of(typename boost::graph_traits<M>::halfedge_descriptor h, const M& mesh)
{
  const auto points = get(CGAL::vertex_point, mesh);
  return std::sqrt(CGAL::to_double(CGAL::squared_distance(get(points, source(h, mesh)), get(points, target(h, mesh)))));
}

template <class M>
std::array<typename boost::property_traits<typename boost::property_map<M, CGAL::vertex_point_t>::type>::value_type, 3>
corners_of(Face_of<M> f, const M& mesh)
{
  const auto points = get(CGAL::vertex_point, mesh);
  const auto h = halfedge(f, mesh);
  return {{get(points, source(h, mesh)), get(points, target(h, mesh)), get(points, target(next(h, mesh), mesh))}};
}

template <class M>
double area_of(Face_of<M> f, const M& mesh)
{
  const auto c = corners_of(f, mesh);
  return std::sqrt(CGAL::to_double(CGAL::squared_area(c[0], c[1], c[2])));
}

template <class M>
double area_of(const M& mesh)
{
  double result = 0;
  for(const auto f : faces(mesh))
    result += area_of(f, mesh);
  return result;
}

template <class M>
auto point_of(const Location_of<M>& at, const M& mesh)
{
  const auto c = corners_of(at.first, mesh);
  return c[0] + at.second[1] * (c[1] - c[0]) + at.second[2] * (c[2] - c[0]);
}

template <class M>
double length_of(const Polyline_of<M>& polyline, const M& mesh)
{
  double result = 0;
  for(std::size_t i = 1; i < polyline.size(); ++i)
    result += std::sqrt(
        CGAL::to_double(CGAL::squared_distance(point_of<M>(polyline[i - 1], mesh), point_of<M>(polyline[i], mesh))));
  return result;
}

template <class M>
long euler_characteristic(const M& mesh)
{
  return static_cast<long>(CGAL::make_range(vertices(mesh)).size()) -
         static_cast<long>(CGAL::make_range(edges(mesh)).size()) +
         static_cast<long>(CGAL::make_range(faces(mesh)).size());
}

/// Remembers which face each new one is a part of, and counts the calls.
template <class M>
struct Origin_visitor : FG::Default_curve_insertion_visitor<M>
{
  std::map<Face_of<M>, Face_of<M>> origin;
  Face_of<M> divided = boost::graph_traits<M>::null_face();
  std::size_t splits = 0, divisions = 0, open = 0;

  void before_edge_split(typename boost::graph_traits<M>::halfedge_descriptor, M&) { ++open; }
  void edge_split(typename boost::graph_traits<M>::halfedge_descriptor, M&) { ++splits; }
  void after_edge_split() { --open; }
  void before_subface_creations(Face_of<M> f, M&)
  {
    divided = f;
    ++open;
    ++divisions;
  }
  void after_subface_created(Face_of<M> f, M&) { origin[f] = divided; }
  void after_subface_creations(M&) { --open; }
};

template <class M>
struct Inserted
{
  FG::Curve_insertion_report report;
  double marked_length = 0;
  std::size_t marked_edges = 0, marked_ends = 0; ///< vertices with an odd number of marked edges
};

/// The number of components between marked edges, by merging labels until nothing changes.
template <class M, class IsMarked>
std::size_t number_of_components(const M& mesh, const IsMarked& is_marked)
{
  std::map<Face_of<M>, std::size_t> label;
  for(const auto f : faces(mesh))
    label.insert({f, label.size()});
  for(bool is_changed = true; is_changed;) {
    is_changed = false;
    for(const auto e : edges(mesh)) {
      const auto f = face(halfedge(e, mesh), mesh), g = face(opposite(halfedge(e, mesh), mesh), mesh);
      if(CGAL::is_border(e, mesh) || get(is_marked, e) || label[f] == label[g])
        continue;
      label[f] = label[g] = (std::min)(label[f], label[g]);
      is_changed = true;
    }
  }
  std::set<std::size_t> labels;
  for(const auto& [f, l] : label)
    labels.insert(l);
  return labels.size();
}

/// Regions are what marked edges separate, and their numbers are used up.
template <class M, class IsMarked, class Region>
void check_regions(const M& mesh, const IsMarked& is_marked, const Region& region, std::size_t count)
{
  std::set<std::size_t> used;
  for(const auto f : faces(mesh))
    used.insert(get(region, f));
  BOOST_TEST(used.size() == count);
  BOOST_TEST((used.empty() || *used.rbegin() + 1 == count));
  BOOST_TEST(number_of_components(mesh, is_marked) == count);
  for(const auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    if(!get(is_marked, e) && !CGAL::is_border(e, mesh))
      BOOST_TEST(get(region, face(h, mesh)) == get(region, face(opposite(h, mesh), mesh)));
  }
}

/// Inserts curves and checks what holds for all of them. \return the report and the marked edges
template <class M, class Curves>
Inserted<M> inserted(M& mesh, const Curves& curves)
{
  const auto points = get(CGAL::vertex_point, mesh);
  const double area = area_of(mesh);
  const long euler = euler_characteristic(mesh);
  const bool is_closed = CGAL::is_closed(mesh);
  const std::size_t number_of_vertices = CGAL::make_range(vertices(mesh)).size();
  const std::size_t number_of_faces = CGAL::make_range(faces(mesh)).size();
  std::map<Face_of<M>, double> areas;
  for(const auto f : faces(mesh))
    areas[f] = area_of(f, mesh);
  using Point = std::decay_t<decltype(get(points, *vertices(mesh).begin()))>;
  std::vector<std::pair<typename boost::graph_traits<M>::vertex_descriptor, Point>> old_points;
  for(const auto v : vertices(mesh))
    old_points.push_back({v, get(points, v)});

  Inserted<M> result;
  auto is_marked = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  auto region = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  for(const auto e : edges(mesh))
    put(is_marked, e, false);
  Origin_visitor<M> visitor;
  result.report = FG::insert_curves(
      mesh, curves,
      CGAL::parameters::edge_is_constrained_map(is_marked).face_patch_map(region).visitor(std::ref(visitor)));

  BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
  BOOST_TEST(CGAL::is_triangle_mesh(mesh));
  BOOST_TEST(CGAL::is_closed(mesh) == is_closed);
  BOOST_TEST(euler_characteristic(mesh) == euler);
  BOOST_TEST(std::abs(area_of(mesh) - area) <= 1e-11 * area);
  BOOST_TEST(CGAL::make_range(vertices(mesh)).size() == number_of_vertices + result.report.new_vertices);
  BOOST_TEST(CGAL::make_range(faces(mesh)).size() == number_of_faces + result.report.new_faces);
  BOOST_TEST(visitor.open == 0u);
  BOOST_TEST(visitor.divisions == result.report.divided_faces);
  BOOST_TEST(visitor.origin.size() == result.report.new_faces);
  for(const auto& [v, p] : old_points)
    BOOST_TEST((get(points, v) == p));
  std::map<Face_of<M>, double> parts;
  for(const auto f : faces(mesh)) {
    const auto origin = visitor.origin.find(f);
    parts[origin == visitor.origin.end() ? f : origin->second] += area_of(f, mesh);
    const auto c = corners_of(f, mesh);
    BOOST_TEST(!CGAL::collinear(c[0], c[1], c[2]));
  }
  for(const auto& [f, a] : areas)
    BOOST_TEST(std::abs(parts[f] - a) <= 1e-11 * area);
  check_regions(mesh, is_marked, region, result.report.regions);

  std::map<typename boost::graph_traits<M>::vertex_descriptor, int> degree;
  for(const auto e : edges(mesh))
    if(get(is_marked, e)) {
      ++result.marked_edges;
      result.marked_length += length_of(halfedge(e, mesh), mesh);
      ++degree[source(halfedge(e, mesh), mesh)];
      ++degree[target(halfedge(e, mesh), mesh)];
    }
  for(const auto& [v, d] : degree)
    result.marked_ends += static_cast<std::size_t>(d % 2);
  return result;
}

/// A polyline as a user draws it: points inside faces, on edges and at vertices, from face to face.
template <class M>
Polyline_of<M> drawn_polyline(const M& mesh, std::size_t size, Random_numbers& random)
{
  const auto all = CGAL::make_range(faces(mesh));
  auto first = all.begin();
  std::advance(first, random.below(static_cast<int>(all.size())));
  Face_of<M> f = *first;
  Polyline_of<M> result;
  while(result.size() < size) {
    for(int inside = random.below(3); inside > 0; --inside) {
      const double a = random.uniform(0.01, 1), b = random.uniform(0.01, 1), c = random.uniform(0.01, 1);
      result.push_back({f, {{a / (a + b + c), b / (a + b + c), c / (a + b + c)}}});
    }
    auto h = halfedge(f, mesh);
    const int side = random.below(3);
    for(int i = 0; i < side; ++i)
      h = next(h, mesh);
    std::array<double, 3> weights = {{0, 0, 0}};
    weights[static_cast<std::size_t>(side)] = random.below(4) == 0 ? 0.0 : random.uniform(0, 1);
    weights[static_cast<std::size_t>((side + 1) % 3)] = 1 - weights[static_cast<std::size_t>(side)];
    result.push_back({f, weights});
    if(face(opposite(h, mesh), mesh) != boost::graph_traits<M>::null_face())
      f = face(opposite(h, mesh), mesh);
  }
  return result;
}

/// Meshes with all sorts of borders, curvatures and shapes of faces.
inline std::vector<Mesh_soup> meshes_for_insertion()
{
  return {torus(12, 8, 3, 1),
          box(3, 2, 4, 1),
          sphere(3),
          jittered_grid(6, 5, Diagonal_rule::ALTERNATING, 0.2, 3),
          grid_with_hole(6, 6, 2, 4, 2, 4),
          cylinder(7, 3, 1, 2),
          tetrahedron(1),
          single_triangle(),
          needle_strip(6, 2, 1000),
          genus_3_plate(1)};
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_INSERT_CURVES_INSERTIONS_H
