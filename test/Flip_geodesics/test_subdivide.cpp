// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Common subdivisions, curves inserted into the mesh, and meshes cut open along curves: connectivity by counting, areas
// and lengths against the two meshes that were laid over each other, data carried across against linear functions.

#define BOOST_TEST_MODULE subdivide

#include "test_subdivide/subdivisions.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(the_input_is_its_own_subdivision)
{
  for(const Mesh_soup& soup : various_meshes()) {
    Curve_setting s(soup);
    const Subdivision subdivision = FG::common_subdivision(s.triangulation, s.mesh);
    check_against_both(subdivision, s.mesh, s.triangulation);
    BOOST_CHECK_EQUAL(subdivision.mesh().number_of_vertices(), s.mesh.number_of_vertices());
  }
}

BOOST_AUTO_TEST_CASE(isolated_vertices_stay)
{
  Curve_setting s(with_isolated_vertices(tetrahedron(1), 2, 1));
  const Subdivision subdivision = FG::common_subdivision(s.triangulation, s.mesh);
  BOOST_CHECK_EQUAL(subdivision.mesh().number_of_vertices(), s.mesh.number_of_vertices());
  std::size_t isolated = 0;
  for(const auto v : subdivision.mesh().vertices())
    isolated += subdivision.mesh().is_isolated(v) ? 1 : 0;
  BOOST_CHECK_EQUAL(isolated, 3u);
}

BOOST_AUTO_TEST_CASE(common_subdivisions_with_random_delta_complexes)
{
  Random_numbers random(11);
  std::size_t crossings = 0;
  for(const Mesh_soup& soup : various_meshes())
    for(int attempts : {5, 50, 400}) {
      Curve_setting s(soup);
      flip_at_random(s.triangulation, attempts, random);
      const Subdivision subdivision = FG::common_subdivision(s.triangulation, s.mesh);
      check_against_both(subdivision, s.mesh, s.triangulation);
      crossings += subdivision.mesh().number_of_vertices() - s.mesh.number_of_vertices();
    }
  BOOST_CHECK_GT(crossings, 2000u);
}

BOOST_AUTO_TEST_CASE(quadrilaterals_are_divided_by_the_better_diagonal)
{
  using Point = Surface::Point;
  const auto quality = [](const Point& p, const Point& q, const Point& r) {
    return std::sqrt(CGAL::squared_area(p, q, r)) /
           (CGAL::squared_distance(p, q) + CGAL::squared_distance(q, r) + CGAL::squared_distance(r, p));
  };
  Random_numbers random(23);
  std::size_t quadrilaterals = 0;
  for(const Mesh_soup& soup : various_meshes()) {
    Curve_setting s(soup);
    flip_at_random(s.triangulation, 50, random);
    const Subdivision subdivision = FG::common_subdivision(s.triangulation, s.mesh);
    const Surface& mesh = subdivision.mesh();
    const auto is_diagonal = [&](Surface::Halfedge_index h) {
      return subdivision.input_halfedge(h) == FG::null_index && subdivision.intrinsic_halfedge(h) == FG::null_index;
    };
    for(const auto e : mesh.edges()) {
      const auto h = mesh.halfedge(e), t = mesh.opposite(h);
      if(!is_diagonal(h) || is_diagonal(mesh.next(h)) || is_diagonal(mesh.prev(h)) || is_diagonal(mesh.next(t)) ||
         is_diagonal(mesh.prev(t)))
        continue;
      const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                  &r = mesh.point(mesh.target(mesh.next(h))), &o = mesh.point(mesh.target(mesh.next(t)));
      const double other = std::min(quality(p, o, r), quality(q, r, o));
      BOOST_CHECK_GE(std::min(quality(p, q, r), quality(p, o, q)), other - 1e-9);
      ++quadrilaterals;
    }
  }
  BOOST_CHECK_GT(quadrilaterals, 30u);
}

BOOST_AUTO_TEST_CASE(common_subdivisions_with_inserted_points)
{
  Random_numbers random(17);
  for(const Mesh_soup& soup : various_meshes())
    for(int round = 0; round < 3; ++round) {
      Curve_setting s(soup);
      insert_points(s, 10, random);
      flip_at_random(s.triangulation, 40 * round, random);
      insert_points(s, 20, random);
      check_against_both(FG::common_subdivision(s.triangulation, s.mesh), s.mesh, s.triangulation);
    }
}

BOOST_AUTO_TEST_CASE(data_is_carried_across)
{
  Random_numbers random(3);
  Curve_setting flat(jittered_grid(7, 6, Diagonal_rule::RANDOM, 0.2, 4));
  insert_points(flat, 20, random);
  flip_at_random(flat.triangulation, 300, random);
  const Subdivision subdivision = FG::common_subdivision(flat.triangulation, flat.mesh);
  const Surface& mesh = subdivision.mesh();

  // A function that is linear in the plane is linear in every face of every triangulation of it.
  const auto linear = [](const Surface::Point& p) { return 1 + 2 * p.x() - 3 * p.y(); };
  Input_values at_input(flat.mesh.number_of_vertices()), result(mesh.number_of_vertices());
  for(auto v : flat.mesh.vertices())
    at_input[v] = linear(flat.mesh.point(v));
  Input_values at_intrinsic = at_input;
  const auto on_mesh = boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, mesh));
  subdivision.interpolate_from_input(
      boost::make_iterator_property_map(at_input.begin(), get(boost::vertex_index, flat.mesh)), on_mesh);
  for(auto v : mesh.vertices())
    BOOST_CHECK_SMALL(result[v] - linear(mesh.point(v)), 1e-12);
  for(auto v : mesh.vertices()) // at inserted vertices as well
    if(subdivision.vertex_origin(v).intrinsic_vertex.idx() >= static_cast<int>(at_input.size()))
      at_intrinsic.push_back(result[v]);
  std::fill(result.begin(), result.end(), 0);
  subdivision.interpolate_from_intrinsic(
      boost::make_iterator_property_map(at_intrinsic.begin(), Number_map<Vertex_index>()), on_mesh);
  for(auto v : mesh.vertices())
    BOOST_CHECK_SMALL(result[v] - linear(mesh.point(v)), 1e-12);
  Input_values back(at_intrinsic.size(), 0);
  subdivision.restrict_to_intrinsic(on_mesh,
                                    boost::make_iterator_property_map(back.begin(), Number_map<Vertex_index>()));
  BOOST_CHECK(back == at_intrinsic);

  // The integral of a face function is kept on the way from the input to the subdivision and to the intrinsic faces.
  Input_values of_input(flat.mesh.number_of_faces()), of_mesh(mesh.number_of_faces());
  Input_values of_intrinsic(flat.triangulation.number_of_halfedges(), 0), of_input_again(of_input.size(), 0);
  for(double& value : of_input)
    value = random.uniform(0, 1);
  const auto face_map = boost::make_iterator_property_map(of_mesh.begin(), get(boost::face_index, mesh));
  const auto intrinsic_map = boost::make_iterator_property_map(of_intrinsic.begin(), Number_map<Halfedge_index>());
  subdivision.spread_from_input(boost::make_iterator_property_map(of_input.begin(), get(boost::face_index, flat.mesh)),
                                face_map);
  double integral = 0, after = 0;
  for(auto f : mesh.faces())
    integral += of_mesh[f] * subdivision.area(f);
  subdivision.average_to_input(
      face_map, boost::make_iterator_property_map(of_input_again.begin(), get(boost::face_index, flat.mesh)));
  for(std::size_t f = 0; f < of_input.size(); ++f)
    BOOST_CHECK_CLOSE_FRACTION(of_input[f], of_input_again[f], 1e-12);
  subdivision.average_to_intrinsic(face_map, intrinsic_map);
  subdivision.spread_from_intrinsic(intrinsic_map, face_map);
  for(auto f : mesh.faces())
    after += of_mesh[f] * subdivision.area(f);
  BOOST_CHECK_GT(integral, 1);
  BOOST_CHECK_CLOSE_FRACTION(integral, after, 1e-12);
}
