// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Over a kernel that constructs exactly, all points that are returned lie on the mesh exactly, on meshes that CGAL
// makes.

#include "test_kernels/exact_coordinates.h"

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/insert_curves.h>
#include <CGAL/Flip_geodesics/isolines.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost_mp.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
namespace PMP = CGAL::Polygon_mesh_processing;
using namespace Flip_geodesics_test;

namespace points_on_the_mesh {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

Vertex vertex(std::size_t v) { return Vertex(static_cast<Mesh::size_type>(v)); }

// A box of cubes, rotated and scaled by a fifth.
Mesh rotated_box(const Lattice_point& size, const std::array<int, 4>& quaternion, const Kernel::FT& shift)
{
  return mesh_of<Kernel>(lattice_box(size), [&](const Lattice_point& p) {
    const Point q = rotated<Kernel>(p, quaternion);
    const Kernel::FT center = Kernel::FT(1000) / 7, scale = Kernel::FT(1) / 5;
    return Point((q.x() - center) * scale + shift, (q.y() - center) * scale, (q.z() - center) * scale);
  });
}

// The union of a box and a rotated one, whose edges cross at points that are not doubles.
Mesh union_of_boxes()
{
  Mesh a = mesh_of<Kernel>(lattice_box({2, 2, 1}), in_odd_cells<Kernel>);
  Mesh b = rotated_box({1, 1, 1}, {1, 2, 3, 4}, Kernel::FT(1) / 15), result;
  BOOST_TEST(PMP::corefine_and_compute_union(a, b, result));
  result.collect_garbage();
  return result;
}

// What lies on the faces of a mesh, exactly.
class Exact_surface
{
public:
  explicit Exact_surface(const Mesh& mesh)
  {
    for(const auto f : mesh.faces()) {
      const auto h = mesh.halfedge(f);
      m_triangles.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                               mesh.point(mesh.target(mesh.next(h))));
    }
  }

  bool has_on(const Point& p) const
  {
    return std::any_of(m_triangles.begin(), m_triangles.end(), [&](const auto& t) { return t.has_on(p); });
  }

  // Are each two points in a row in one face?
  bool has_on(const std::vector<Point>& polyline) const
  {
    for(std::size_t i = 1; i < polyline.size(); ++i)
      if(std::none_of(m_triangles.begin(), m_triangles.end(),
                      [&](const auto& t) { return t.has_on(polyline[i - 1]) && t.has_on(polyline[i]); }))
        return false;
    return polyline.empty() || has_on(polyline.front());
  }

private:
  std::vector<Kernel::Triangle_3> m_triangles;
};

// Of all pairs of vertices with this step from one to the other.
template <class Function>
void for_each_pair(const Mesh& mesh, std::size_t step, const Function& function)
{
  const auto n = static_cast<std::size_t>(mesh.number_of_vertices());
  for(std::size_t i = 0; i < n; i += step) {
    const std::size_t k = (7 * i + 3) % n;
    if(i != k)
      function(vertex(i), vertex(k));
  }
}

FG::Geodesic_distance_field<Triangulation> field_of_first_vertex(const Triangulation& triangulation, const Mesh& mesh)
{
  FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
  field.add_source(FG::Vertex_index(0));
  field.compute();
  return field;
}

std::vector<FG::Isoline<Mesh>> isolines_of_first_vertex(const Mesh& mesh)
{
  const Triangulation triangulation(mesh);
  const auto field = field_of_first_vertex(triangulation, mesh);
  const double level = field.distance(FG::Vertex_index(static_cast<FG::Index>(mesh.number_of_vertices() - 1)));
  std::vector<FG::Isoline<Mesh>> result;
  FG::isolines(mesh, field, std::vector<double>{level / 3, level / 2}, std::back_inserter(result), level / 100);
  return result;
}

void check_surface(const Mesh& mesh)
{
  BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
  BOOST_TEST(CGAL::is_closed(mesh));
  BOOST_TEST(!PMP::does_self_intersect(mesh));
}

// Those of CGAL, over coordinates rounded to double.
class Rounded_distances
{
  using Rounded_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Rounded_mesh = CGAL::Surface_mesh<Rounded_kernel::Point_3>;
  using Paths = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Rounded_kernel, Rounded_mesh>>;

public:
  explicit Rounded_distances(const Mesh& mesh)
  {
    for(const auto v : mesh.vertices()) {
      const Point& p = mesh.point(v);
      m_mesh.add_vertex({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    for(const auto f : mesh.faces()) {
      std::vector<Rounded_mesh::Vertex_index> corners;
      for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        corners.emplace_back(v.idx());
      m_mesh.add_face(corners);
    }
  }

  double operator()(Vertex s, Vertex t) const
  {
    Paths paths(m_mesh);
    paths.add_source_point(Rounded_mesh::Vertex_index(s.idx()));
    return paths.shortest_distance_to_source_points(Rounded_mesh::Vertex_index(t.idx())).first;
  }

private:
  Rounded_mesh m_mesh;
};

} // namespace

BOOST_AUTO_TEST_CASE(paths_on_a_union_of_boxes)
{
  const Mesh mesh = union_of_boxes();
  BOOST_TEST(mesh.number_of_vertices() > 18u);
  const Exact_surface surface(mesh);
  const Rounded_distances distance(mesh);
  std::size_t curves = 0;
  for_each_pair(mesh, 1, [&](Vertex s, Vertex t) {
    std::vector<Point> points, shortest_points;
    const auto path = FG::geodesic_path(mesh, s, t, std::back_inserter(points));
    BOOST_TEST((path.verdict() == FG::Verdict::PROVEN));
    const auto shortest = FG::shortest_path(mesh, s, t, std::back_inserter(shortest_points)).report;
    BOOST_TEST(shortest.is_confirmed());
    BOOST_TEST(shortest.length <= path.length() * (1 + 1e-12));
    BOOST_TEST(shortest.length == distance(s, t), boost::test_tools::tolerance(1e-11));
    BOOST_TEST(surface.has_on(points));
    BOOST_TEST(surface.has_on(shortest_points));
    BOOST_TEST((points.front() == mesh.point(s) && points.back() == mesh.point(t)));
    ++curves;
  });
  BOOST_TEST(curves > 10u);
}

BOOST_AUTO_TEST_CASE(curve_points_and_samples_lie_on_the_mesh)
{
  const Mesh mesh = union_of_boxes();
  const Exact_surface surface(mesh);
  std::size_t crossings = 0;
  for_each_pair(mesh, 2, [&](Vertex s, Vertex t) {
    std::vector<FG::Curve_point<Mesh, Point>> places;
    std::vector<Location> curve;
    FG::geodesic_path(mesh, s, t, std::back_inserter(places));
    FG::geodesic_path(mesh, s, t, std::back_inserter(curve));
    for(const auto& place : places) {
      BOOST_TEST(surface.has_on(place.point));
      if(place.halfedge == Mesh::null_halfedge())
        continue;
      ++crossings;
      BOOST_TEST(CGAL::collinear(mesh.point(mesh.source(place.halfedge)), place.point,
                                 mesh.point(mesh.target(place.halfedge))));
    }
    std::vector<FG::Curve_sample<Mesh, Point>> samples;
    FG::sample_curve(mesh, curve, 9, std::back_inserter(samples));
    for(const auto& sample : samples)
      BOOST_TEST(surface.has_on(sample.point));
  });
  BOOST_TEST(crossings > 10u);
}

BOOST_AUTO_TEST_CASE(traces_and_isolines_lie_on_the_mesh)
{
  const Mesh mesh = union_of_boxes();
  const Exact_surface surface(mesh);
  const auto zero = mesh.opposite(mesh.halfedge(vertex(3)));
  for(int i = 0; i < 12; ++i) {
    std::vector<Point> points;
    FG::trace_geodesic(mesh, vertex(3), std::pair(zero, 0.1 + 0.4 * i), 1.5, std::back_inserter(points));
    BOOST_TEST(points.size() > 2u);
    BOOST_TEST(surface.has_on(points));
  }
  const auto isolines = isolines_of_first_vertex(mesh);
  BOOST_TEST(isolines.size() >= 2u);
  for(const auto& isoline : isolines)
    BOOST_TEST(surface.has_on(isoline.points));
}

// Curves that cross each other inside faces, and closed ones.
BOOST_AUTO_TEST_CASE(a_mesh_with_curves_is_exact)
{
  const Mesh original = union_of_boxes();
  Mesh mesh = original;
  std::vector<std::vector<Location>> curves;
  for_each_pair(mesh, 3, [&](Vertex s, Vertex t) {
    curves.emplace_back();
    FG::geodesic_path(mesh, s, t, std::back_inserter(curves.back()));
  });
  for(const auto& isoline : isolines_of_first_vertex(mesh))
    curves.push_back(isoline.locations);
  const auto report = FG::insert_curves(mesh, curves);
  BOOST_TEST(report.new_vertices > 20u);
  mesh.collect_garbage();
  check_surface(mesh);
  const Exact_surface surface(original);
  for(const auto e : mesh.edges())
    BOOST_TEST(surface.has_on({mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))}));
  for(const bool is_union : {false, true}) {
    Mesh tool = rotated_box({1, 1, 1}, {5, 1, 0, 2}, Kernel::FT(1) / 2), first = mesh, result;
    BOOST_TEST((is_union ? PMP::corefine_and_compute_union(first, tool, result)
                         : PMP::corefine_and_compute_difference(first, tool, result)));
    result.collect_garbage();
    check_surface(result);
  }
}

template <class K>
void check_crossing_inside_a_face()
{
  using Exact_mesh = CGAL::Surface_mesh<typename K::Point_3>;
  using Number = typename K::FT;
  using Weights = std::array<double, 3>;
  using Rounded_location = std::pair<typename Exact_mesh::Face_index, Weights>;
  using Exact_location = std::pair<typename Exact_mesh::Face_index, std::array<Number, 3>>;
  Exact_mesh mesh;
  const Number third = Number(1) / Number(3), seventh = Number(1) / Number(7);
  const auto a = mesh.add_vertex({third, Number(0), seventh}), b = mesh.add_vertex({Number(5), seventh, third}),
             c = mesh.add_vertex({Number(1), Number(4), Number(2) * seventh});
  const typename K::Point_3 centroid = CGAL::centroid(mesh.point(a), mesh.point(b), mesh.point(c));
  const auto f = mesh.add_face(a, b, c);
  const Weights ends[2][2] = {{{{0.7, 0.3, 0}}, {{0, 0.4, 0.6}}}, {{{0.2, 0.8, 0}}, {{0.9, 0, 0.1}}}};
  std::vector<std::vector<Rounded_location>> curves;
  for(const auto& [from, to] : ends)
    curves.push_back({{f, from}, {f, to}});
  const auto report = FG::insert_curves(mesh, curves);
  BOOST_TEST(report.new_vertices == 5u);
  // The crossing is the last vertex, and the only one inside.
  const typename Exact_mesh::Vertex_index crossing(static_cast<typename Exact_mesh::size_type>(7));
  BOOST_TEST(!mesh.is_border(crossing));
  std::size_t straight = 0; // pairs of ends
  for(const auto p : mesh.vertices())
    for(const auto q : mesh.vertices())
      if(p < q && p > c && q < crossing && CGAL::collinear(mesh.point(p), mesh.point(crossing), mesh.point(q)))
        ++straight;
  BOOST_TEST(straight == 2u);
  Exact_mesh with_centroid;
  const auto g =
      with_centroid.add_face(with_centroid.add_vertex(mesh.point(a)), with_centroid.add_vertex(mesh.point(b)),
                             with_centroid.add_vertex(mesh.point(c)));
  FG::insert_curves(with_centroid, std::vector<Exact_location>{{g, {{third, third, third}}}});
  BOOST_TEST((with_centroid.point(typename Exact_mesh::Vertex_index(3)) == centroid));
}

// Neither the crossing of two curves nor exact weights are rounded, whatever the exact number type.
BOOST_AUTO_TEST_CASE(points_inside_faces_are_exact_for_each_number_type)
{
  check_crossing_inside_a_face<CGAL::Exact_predicates_exact_constructions_kernel>();
  check_crossing_inside_a_face<CGAL::Simple_cartesian<CGAL::Gmpq>>();
  check_crossing_inside_a_face<CGAL::Simple_cartesian<boost::multiprecision::cpp_rational>>();
}

} // namespace points_on_the_mesh
