// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE traits_archetype

#include "Curve_setting.h"
#include "Metric_archetype.h"
#include "Traits_archetype.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "lawson.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/extract.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <iostream>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using Archetype_triangulation = FG::Intrinsic_triangulation<Surface, Traits_archetype>;
using Archetype_setting = Basic_curve_setting<Archetype_triangulation>;

static_assert(!std::is_trivially_copyable<Traits_archetype::Halfedge_geometry>::value,
              "the archetype is to exercise geometry that owns something");
static_assert(!std::is_convertible<Traits_archetype::FT, double>::value &&
                  !std::is_convertible<double, Traits_archetype::FT>::value,
              "the archetype's numbers convert to nothing");

namespace {

struct Curve
{
  Halfedge_sequence halfedges, flips;
  std::vector<FG::Input_halfedge_index> crossed;
  std::string status;
  double length;
};

template <class Setting>
Curve pulled(Setting& setting)
{
  const FG::Shortening_report report = setting.pull();
  Curve result{setting.network.halfedges(0_c),
               setting.flips(),
               {},
               FG::to_string(report.curves[0].status),
               report.curves[0].length};
  for(FG::Halfedge_index h : result.halfedges)
    for(FG::Input_halfedge_index c : setting.triangulation.edge_sequence(h).crossed)
      result.crossed.push_back(c);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_same_words_come_out)
{
  const std::vector<Mesh_soup> soups = {bumpy_sphere(4, 0.3, 1), jittered_grid(8, 8, Diagonal_rule::RANDOM, 0.2, 2),
                                        shaken(torus(8, 6, 3, 1), 0.2, 3), shaken(genus_3_plate(2), 0.1, 4)};
  Random_numbers random(1);
  std::size_t curves = 0, flips = 0;
  for(const Mesh_soup& soup : soups) {
    Archetype_setting archetype(soup);
    Curve_setting usual(soup);
    for(int i = 0; i < 200 * scale; ++i) {
      const bool is_closed = i % 2 == 1;
      const Halfedge_sequence walk = random_walk(usual.triangulation, 20, is_closed, random);
      if(walk.empty())
        continue;
      archetype.network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
      usual.network.add_curve(walk, CGAL::parameters::is_closed(is_closed));
      if(usual.network.is_valid()) {
        const Curve a = pulled(archetype), b = pulled(usual);
        BOOST_TEST(a.status == b.status);
        BOOST_TEST((a.flips == b.flips));
        BOOST_TEST((a.halfedges == b.halfedges));
        BOOST_TEST((a.crossed == b.crossed));
        BOOST_TEST(std::abs(a.length - b.length) <= 1e-10 * b.length);
        BOOST_TEST(archetype.triangulation.is_valid());
        ++curves;
        flips += b.flips.size();
      }
      archetype.network.clear();
      usual.network.clear();
      archetype.triangulation.rollback();
      usual.triangulation.rollback();
    }
  }
  std::cout << curves << " curves, " << flips << " flips\n";
  BOOST_TEST(curves > 100u);
  BOOST_TEST(flips > 500u);
}

BOOST_AUTO_TEST_CASE(extraction_needs_no_more)
{
  const Mesh_soup soup = jittered_grid(8, 8, Diagonal_rule::RANDOM, 0.2, 5);
  Archetype_setting setting(soup);
  setting.add_path(0_v, 80_v);
  setting.pull();
  FG::Curve_extractor<Archetype_setting::Network> extractor(setting.network);
  std::vector<Surface::Point> points;
  extractor.points(0_c, std::back_inserter(points));
  BOOST_TEST(points.size() > 5u);
  for(const Surface::Point& p : points)
    BOOST_TEST(std::abs(p.x() - p.y()) < 1e-9); // the diagonal of the square
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(setting.triangulation, std::back_inserter(faces));
  BOOST_TEST(faces.size() == soup.triangles.size());
}

BOOST_AUTO_TEST_CASE(the_same_edges_are_delaunay)
{
  const Mesh_soup soup = jittered_grid(8, 8, Diagonal_rule::RANDOM, 0.2, 6);
  Archetype_setting archetype(soup);
  Curve_setting usual(soup);
  const int flips = flip_to_delaunay(usual.triangulation, 10000);
  BOOST_TEST(flips > 10);
  BOOST_TEST(flip_to_delaunay(archetype.triangulation, 10000) == flips);
  BOOST_TEST(are_all_edges_delaunay(archetype.triangulation));
}

template <template <class> class Metric, class Mesh>
void lengths_are_those_of_the_mesh(const Mesh& mesh)
{
  using Points = FG::Embedded_metric<Mesh, typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type>;
  const Metric<Points> metric(get(CGAL::vertex_point, mesh));
  const FG::Intrinsic_triangulation<Mesh, Traits_with_exact_faces, Metric<Points>> triangulation(mesh, metric);
  for(int i = 0; i < triangulation.number_of_halfedges(); ++i) {
    const FG::Halfedge_index h(i);
    const auto point = [&](FG::Vertex_index v) { return mesh.point(triangulation.input().vertex(v)); };
    const auto square = CGAL::squared_distance(point(triangulation.tail(h)), point(triangulation.head(h)));
    BOOST_TEST(triangulation.length(h) == std::sqrt(CGAL::to_double(square)), boost::test_tools::tolerance(1e-15));
  }
}

template <class Point>
CGAL::Surface_mesh<Point> corner_of_a_cube()
{
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  return mesh;
}

template <class Metric>
using Itself = Metric;
template <class Metric>
using With_squares = Metric_archetype<Metric_with_squares<Metric>>;

BOOST_AUTO_TEST_CASE(faces_of_exact_numbers_call_the_optional_overloads)
{
  lengths_are_those_of_the_mesh<Itself>(corner_of_a_cube<Traits_with_exact_faces::Point_3>());
  BOOST_TEST(Traits_with_exact_faces::faces_from_sides == 4);
  lengths_are_those_of_the_mesh<With_squares>(corner_of_a_cube<Surface::Point>());
  BOOST_TEST(Traits_with_exact_faces::faces_from_squares == 4);
}
