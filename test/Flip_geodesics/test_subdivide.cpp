// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Common subdivisions, curves inserted into the mesh, and meshes cut open along curves: connectivity by counting, areas
// and lengths against the two meshes that were laid over each other, data carried across against linear functions.

#include "Curve_setting.h"
#include "descriptors.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#define BOOST_TEST_MODULE subdivide
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Edge_index;
using FG::Halfedge_index;
using FG::Input_halfedge_index;
using FG::Vertex_index;
using FG::internal::as_input;
using FG::internal::descriptors;
using FG::internal::first_side;
using FG::internal::Indexed_by;
using namespace Flip_geodesics_test;

namespace {

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
bool has_manifold_vertices(const Surface& mesh)
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

double distance(const Surface& mesh, Surface::Halfedge_index h)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

// Two edges with the same ends are one edge in a file, and to whoever tells edges by their ends.
bool has_double_edges(const Surface& mesh)
{
  std::set<std::pair<Surface::Vertex_index, Surface::Vertex_index>> ends;
  for(auto h : mesh.halfedges())
    if(!ends.emplace(mesh.source(h), mesh.target(h)).second)
      return true;
  return false;
}

void check_mesh(const Subdivision& subdivision)
{
  const Surface& mesh = subdivision.mesh();
  BOOST_REQUIRE(mesh.is_valid(false));
  BOOST_CHECK(CGAL::is_valid_polygon_mesh(mesh));
  BOOST_CHECK(!has_double_edges(mesh));
  BOOST_CHECK(CGAL::is_triangle_mesh(mesh));
  BOOST_CHECK(has_manifold_vertices(mesh));
}

// Areas of input and intrinsic faces are those of their parts; chains of edges have the lengths of the whole ones.
void check_against_both(const Subdivision& subdivision, const Surface& input, const Triangulation& triangulation)
{
  check_mesh(subdivision);
  const Surface& mesh = subdivision.mesh();
  BOOST_CHECK_EQUAL(euler_characteristic(mesh), euler_characteristic(input));
  BOOST_CHECK_EQUAL(number_of_borders(mesh), number_of_borders(input));

  const std::size_t halfedges = static_cast<std::size_t>(triangulation.number_of_halfedges());
  Indexed_by<Input_halfedge_index, std::vector<double>> input_area(halfedges, 0);
  Indexed_by<Halfedge_index, std::vector<double>> intrinsic_area(halfedges, 0);
  for(auto f : mesh.faces()) {
    BOOST_CHECK_GT(subdivision.area(f), -1e-12);
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

std::vector<Mesh_soup> various_meshes()
{
  return {shaken(torus(8, 5, 3, 1), 0.05, 3),
          cube(3),
          genus_3_plate(),
          shaken(flat_grid(6, 6, Diagonal_rule::RANDOM), 0.1, 5),
          grid_with_hole(7, 7, 2, 5, 3, 4),
          tetrahedron(1),
          cone_disk(7, 2, 3)};
}

} // namespace

BOOST_AUTO_TEST_CASE(the_input_is_its_own_subdivision)
{
  for(const Mesh_soup& soup : various_meshes()) {
    Curve_setting s(soup);
    const Subdivision subdivision = FG::common_subdivision(s.triangulation, s.mesh);
    check_against_both(subdivision, s.mesh, s.triangulation);
    BOOST_CHECK_EQUAL(subdivision.mesh().number_of_vertices(), s.mesh.number_of_vertices());
  }
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

namespace {

// Inserts random points of faces and edges.
void insert_points(Curve_setting& s, int count, Random_numbers& random)
{
  for(int i = 0; i < count; ++i) {
    const Input_halfedge_index h(random.below(static_cast<int>(s.mesh.number_of_halfedges())));
    const double t = random.uniform(0.1, 0.9), u = i % 3 == 0 ? 0 : random.uniform(0.1, 0.9);
    if(!s.triangulation.input().is_border(h))
      s.network.insert(FG::Surface_location{h, {{3 * t, 3 * (1 - t), 3 * u}}});
  }
}

} // namespace

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

namespace {

// The last spoke counterclockwise, or any if there is no border.
Halfedge_index first_spoke(const Curve_setting& s, Vertex_index v)
{
  const Halfedge_index start = s.triangulation.outgoing(v);
  Halfedge_index first = start;
  for(Halfedge_index h = start; h != FG::null_index; h = s.triangulation.counterclockwise(h)) {
    first = h;
    if(s.triangulation.counterclockwise(h) == start)
      break;
  }
  return first;
}

// Euler's characteristic after a cut: every vertex of the cut's graph is multiplied by its degree, on the border by one
// more, and every edge is doubled.
int euler_characteristic_after_cut(Curve_setting& s)
{
  int result = euler_characteristic(s.mesh);
  Indexed_by<Vertex_index, std::vector<int>> degree(static_cast<std::size_t>(s.triangulation.number_of_vertices()), 0);
  for(Edge_index e : descriptors<Edge_index>(s.triangulation.number_of_edges())) {
    const Halfedge_index h = first_side(e);
    const bool is_border = s.triangulation.is_border(h) || s.triangulation.is_border(Triangulation::twin(h));
    if(!s.network.is_occupied(h) || is_border)
      continue;
    --result;
    ++degree[s.triangulation.tail(h)];
    ++degree[s.triangulation.head(h)];
  }
  for(Vertex_index v : descriptors<Vertex_index>(s.triangulation.number_of_vertices())) {
    const bool is_on_border = s.triangulation.counterclockwise(first_spoke(s, v)) == FG::null_index;
    result += (std::max)(degree[v] - (is_on_border ? 0 : 1), 0);
  }
  return result;
}

// The sides of faces along cuts and the border, in circles: told by the triangulation, not by the mesh.
int number_of_borders_after_cut(const Curve_setting& s)
{
  const Triangulation& t = s.triangulation;
  const auto is_wall = [&](Halfedge_index h) {
    return t.is_border(Triangulation::twin(h)) || s.network.is_occupied(h);
  };
  Indexed_by<Halfedge_index, std::vector<bool>> is_seen(static_cast<std::size_t>(t.number_of_halfedges()), false);
  int count = 0;
  for(Halfedge_index start : descriptors<Halfedge_index>(t.number_of_halfedges())) {
    if(t.is_border(start) || !is_wall(start) || is_seen[start])
      continue;
    ++count;
    for(Halfedge_index h = start; !is_seen[h];) {
      is_seen[h] = true;
      for(h = t.next(h); !is_wall(h);)
        h = t.next(Triangulation::twin(h));
    }
  }
  return count;
}

// Of faces that one can reach without a step over a cut.
int number_of_parts_after_cut(const Curve_setting& s)
{
  const Triangulation& t = s.triangulation;
  Indexed_by<Halfedge_index, std::vector<bool>> is_seen(static_cast<std::size_t>(t.number_of_halfedges()), false);
  int count = 0;
  for(Halfedge_index start : descriptors<Halfedge_index>(t.number_of_halfedges())) {
    std::vector<Halfedge_index> pending = {start};
    count += is_seen[start] || t.is_border(start) ? 0 : 1;
    while(!pending.empty()) {
      const Halfedge_index h = pending.back();
      pending.pop_back();
      if(is_seen[h] || t.is_border(h))
        continue;
      is_seen[h] = true;
      pending.push_back(t.next(h));
      if(!s.network.is_occupied(h))
        pending.push_back(Triangulation::twin(h));
    }
  }
  return count;
}

int number_of_parts(const Surface& mesh)
{
  std::vector<bool> is_seen(mesh.number_of_faces(), false);
  int count = 0;
  for(auto f : mesh.faces()) {
    std::vector<Surface::Face_index> pending = {f};
    count += is_seen[f] ? 0 : 1;
    while(!pending.empty()) {
      const Surface::Face_index g = pending.back();
      pending.pop_back();
      if(g == Surface::null_face() || is_seen[g])
        continue;
      is_seen[g] = true;
      for(auto h : CGAL::halfedges_around_face(mesh.halfedge(g), mesh))
        pending.push_back(mesh.face(mesh.opposite(h)));
    }
  }
  return count;
}

double total_area(const Subdivision& subdivision)
{
  double sum = 0;
  for(auto f : subdivision.mesh().faces())
    sum += subdivision.area(f);
  return sum;
}

double area_in_space(const Surface& mesh)
{
  double sum = 0;
  for(auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    sum += std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                        mesh.point(mesh.target(mesh.next(h)))));
  }
  return sum;
}

// The curves are chains of marked edges and nothing else is marked; faces that no curve crosses are as they were. So
// many edges have got a vertex in their middle.
void check_inserted(Curve_setting& s, std::size_t middles = 0)
{
  const Subdivision subdivision = FG::insert_curves(s.network, s.mesh);
  check_mesh(subdivision);
  const Surface& mesh = subdivision.mesh();
  BOOST_CHECK_EQUAL(euler_characteristic(mesh), euler_characteristic(s.mesh));
  BOOST_CHECK_EQUAL(number_of_borders(mesh), number_of_borders(s.mesh));
  BOOST_CHECK_CLOSE_FRACTION(total_area(subdivision), area_in_space(s.mesh), 1e-9);
  BOOST_CHECK_CLOSE_FRACTION(area_in_space(mesh), area_in_space(s.mesh), 1e-9);
  double marked = 0, occupied = 0;
  std::size_t crossings = 0;
  for(auto e : mesh.edges())
    if(get(subdivision.edge_is_constrained_map(), e))
      marked += distance(mesh, mesh.halfedge(e));
  // By the smallest halfedge of the face.
  Indexed_by<Input_halfedge_index, std::vector<bool>> is_split(s.mesh.number_of_halfedges(), false);
  for(Edge_index e : descriptors<Edge_index>(s.triangulation.number_of_edges())) {
    if(!s.network.is_occupied(first_side(e)))
      continue;
    occupied += s.triangulation.length(first_side(e));
    crossings += static_cast<std::size_t>((std::max)(s.triangulation.crossings(e), 0));
    for(auto h : subdivision.halfedges_along(first_side(e)))
      if(!mesh.is_border(h))
        is_split[subdivision.input_face(mesh.face(h))] = true;
  }
  BOOST_CHECK_SMALL(marked - occupied, 1e-9 * (1 + occupied));
  const bool has_inserted = s.triangulation.number_of_vertices() > static_cast<int>(s.mesh.number_of_vertices());
  if(!has_inserted)
    BOOST_CHECK_EQUAL(mesh.number_of_vertices(), s.mesh.number_of_vertices() + crossings + middles);
  Indexed_by<Input_halfedge_index, std::vector<int>> parts(s.mesh.number_of_halfedges(), 0);
  for(auto f : mesh.faces())
    ++parts[subdivision.input_face(f)];
  if(!has_inserted)
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(static_cast<FG::Index>(parts.size())))
      BOOST_CHECK(parts[h] <= 1 || is_split[h]);
}

Subdivision cut_open(Curve_setting& s)
{
  Subdivision subdivision = FG::cut_along_curves(s.network, s.mesh);
  check_mesh(subdivision);
  BOOST_CHECK_EQUAL(euler_characteristic(subdivision.mesh()), euler_characteristic_after_cut(s));
  BOOST_CHECK_EQUAL(number_of_borders(subdivision.mesh()), number_of_borders_after_cut(s));
  BOOST_CHECK_EQUAL(number_of_parts(subdivision.mesh()), number_of_parts_after_cut(s));
  double marked = 0, cut = 0;
  BOOST_CHECK_CLOSE_FRACTION(total_area(subdivision), area_in_space(s.mesh), 1e-9);
  BOOST_CHECK_CLOSE_FRACTION(area_in_space(subdivision.mesh()), area_in_space(s.mesh), 1e-9);
  for(auto e : subdivision.mesh().edges()) {
    const bool is_marked = get(subdivision.edge_is_constrained_map(), e);
    BOOST_CHECK(!is_marked || subdivision.mesh().is_border(e));
    marked += is_marked ? distance(subdivision.mesh(), subdivision.mesh().halfedge(e)) : 0;
  }
  // Chains from end to end on either side.
  for(Halfedge_index h : descriptors<Halfedge_index>(s.triangulation.number_of_halfedges())) {
    if(!s.network.is_occupied(h) || s.triangulation.is_border(h))
      continue;
    const auto along = subdivision.halfedges_along(h);
    BOOST_REQUIRE(!along.empty());
    double length = 0;
    for(std::size_t i = 0; i < along.size(); ++i) {
      length += distance(subdivision.mesh(), along[i]);
      BOOST_CHECK_EQUAL(subdivision.intrinsic_halfedge(along[i]), h);
      BOOST_CHECK(!subdivision.mesh().is_border(along[i]));
      BOOST_CHECK(i == 0 || subdivision.mesh().target(along[i - 1]) == subdivision.mesh().source(along[i]));
    }
    BOOST_CHECK_CLOSE_FRACTION(length, s.triangulation.length(h), 1e-9);
    cut += length;
  }
  BOOST_CHECK_SMALL(marked - cut, 1e-9 * (1 + cut));
  return subdivision;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_path_cuts_a_slit)
{
  Curve_setting s(sphere(6));
  s.add_path(0_v, Vertex_index(static_cast<int>(s.mesh.number_of_vertices()) - 1));
  s.pull();
  check_inserted(s);
  const Subdivision slit = cut_open(s);
  BOOST_CHECK_EQUAL(euler_characteristic(slit.mesh()), 1);
  BOOST_CHECK_EQUAL(number_of_borders(slit.mesh()), 1);
}

// With both ends inside, its two sides would share both ends: they get a vertex each in their middles.
BOOST_AUTO_TEST_CASE(a_slit_of_one_edge_opens)
{
  for(const Mesh_soup& soup : {sphere(4), tetrahedron(1), jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 4)}) {
    const Surface plain = to_mesh<Surface>(soup);
    int slits = 0;
    for(FG::Index i = 0; i < static_cast<FG::Index>(plain.number_of_edges()); i += 3) {
      const Halfedge_index first = first_side(Edge_index(i));
      Curve_setting s(soup);
      s.network.add_curve(Halfedge_sequence{first}, false);
      check_inserted(s);
      const Subdivision slit = cut_open(s);
      const auto is_at_border = [&](Vertex_index v) { return plain.is_border(s.triangulation.vertex(v)); };
      if(is_at_border(s.triangulation.tail(first)) || is_at_border(s.triangulation.head(first)))
        continue;
      ++slits;
      BOOST_CHECK_EQUAL(slit.mesh().number_of_vertices(), plain.number_of_vertices() + 2);
      BOOST_CHECK_EQUAL(slit.mesh().number_of_faces(), plain.number_of_faces() + 2);
      BOOST_CHECK_EQUAL(number_of_borders(slit.mesh()), number_of_borders(plain) + 1);
      for(Halfedge_index h : {first, Triangulation::twin(first)}) {
        const auto along = slit.halfedges_along(h);
        BOOST_REQUIRE_EQUAL(along.size(), 2u);
        const FG::Subdivision_vertex middle = slit.vertex_origin(slit.mesh().target(along[0]));
        BOOST_CHECK_EQUAL(middle.intrinsic_vertex, FG::null_index);
        BOOST_CHECK_EQUAL(middle.intrinsic_halfedge, first);
        BOOST_CHECK_EQUAL(middle.intrinsic_t, 0.5);
        BOOST_CHECK_EQUAL(middle.on_input.t, 0.5);
        BOOST_CHECK(!middle.on_input.is_inside_face());
      }
    }
    BOOST_CHECK_GT(slits, 0);
  }
}

// From the vertex of a face's middle to a corner, and between two such vertices.
BOOST_AUTO_TEST_CASE(a_slit_of_one_edge_inside_a_face_opens)
{
  Curve_setting s(flat_grid(5, 5, Diagonal_rule::RISING));
  const Vertex_index corner(grid_vertex(5, 2, 2));
  const Input_halfedge_index h = as_input(s.triangulation.outgoing(corner));
  const Vertex_index x = s.triangulation.insert(FG::Surface_location{h, {{1, 1, 1}}});
  const Vertex_index y = s.triangulation.insert(FG::Surface_location{h, {{1, 1, 4}}});
  for(const Vertex_index to : {y, corner}) {
    Halfedge_index g = s.triangulation.outgoing(x);
    for(int i = 0; i < 10 && s.triangulation.head(g) != to; ++i)
      g = s.triangulation.clockwise(g);
    BOOST_REQUIRE_EQUAL(s.triangulation.head(g), to);
    s.network.add_curve(Halfedge_sequence{g}, false);
    check_inserted(s);
    const Subdivision slit = cut_open(s);
    BOOST_CHECK_EQUAL(number_of_borders(slit.mesh()), 2);
    s.network.clear();
  }
}

BOOST_AUTO_TEST_CASE(cuts_that_meet_and_cuts_that_do_not)
{
  const int n = 6;
  const auto v = [](int i, int j) { return Vertex_index(grid_vertex(n, i, j)); };
  const std::vector<std::vector<Vertex_sequence>> worlds = {
      {{v(2, 2), v(3, 2)}, {v(2, 4), v(3, 4)}}, // two slits of one edge
      {{v(2, 2), v(3, 2)}, {v(3, 2), v(3, 3)}}, // that share a vertex
      {{v(2, 2), v(3, 2)}, {v(3, 3), v(3, 2)}, {v(4, 2), v(3, 2)}},
      {{v(2, 2), v(3, 2), v(4, 2)}},                              // of two edges
      {{v(2, 2), v(3, 2), v(3, 3), v(2, 3), v(2, 2)}},            // closed
      {{v(2, 2), v(3, 2), v(3, 3), v(2, 2)}, {v(3, 3), v(4, 3)}}, // with a tail
      {{v(0, 2), v(1, 2)}},                                       // from the border
      {{v(0, 2), v(1, 2)}, {v(1, 2), v(1, 1)}},                   // and on
      {{v(0, 2), v(1, 2), v(1, 1), v(1, 0)}},                     // from border to border
      {{v(0, 0), v(1, 1), v(2, 2), v(3, 3), v(4, 4), v(5, 5), v(6, 6)}, {v(0, 3), v(1, 3), v(2, 3), v(3, 3)}},
      {{v(0, 1), v(0, 2), v(0, 3)}},            // along the border
      {{v(0, 1), v(0, 2), v(1, 2)}},            // and off it
      {{v(1, 1), v(0, 0)}},                     // to a corner
      {{v(0, 5), v(1, 5), v(1, 6)}},            // a corner off
      {{v(2, 2), v(3, 2)}, {v(2, 2), v(3, 2)}}, // twice
      {{v(2, 2), v(3, 2)}, {v(3, 2), v(2, 2)}},
      {}};
  for(const std::vector<Vertex_sequence>& world : worlds) {
    Curve_setting s(flat_grid(n, n, Diagonal_rule::RISING));
    for(const Vertex_sequence& curve : world)
      s.add(curve, false);
    check_inserted(s);
    cut_open(s);
  }
  Curve_setting corner(flat_grid(1, 1, Diagonal_rule::RISING)); // an edge inside with both ends on the border
  corner.add({Vertex_index(grid_vertex(1, 0, 0)), Vertex_index(grid_vertex(1, 1, 1))}, false);
  check_inserted(corner);
  BOOST_CHECK_EQUAL(number_of_parts(cut_open(corner).mesh()), 2);
}

// Slits of two edges and those that start on the border open by themselves: they get no vertices in their middles.
BOOST_AUTO_TEST_CASE(slits_that_open_by_themselves)
{
  const int n = 6;
  const auto v = [](int i, int j) { return Vertex_index(grid_vertex(n, i, j)); };
  for(const Vertex_sequence& slit : std::vector<Vertex_sequence>{{v(2, 2), v(3, 2), v(4, 2)},
                                                                 {v(2, 2), v(2, 3), v(2, 4)},
                                                                 {v(2, 2), v(3, 3), v(4, 4)},
                                                                 {v(2, 2), v(3, 2), v(3, 3)},
                                                                 {v(3, 2), v(2, 2), v(2, 3)},
                                                                 {v(2, 2), v(3, 3), v(3, 2)},
                                                                 {v(0, 2), v(1, 2)},
                                                                 {v(6, 2), v(5, 2)},
                                                                 {v(2, 0), v(2, 1)},
                                                                 {v(2, 6), v(2, 5)}})
  {
    Curve_setting s(flat_grid(n, n, Diagonal_rule::RISING));
    s.add(slit, false);
    BOOST_CHECK_EQUAL(cut_open(s).mesh().number_of_vertices(), s.mesh.number_of_vertices() + 1);
  }
}

BOOST_AUTO_TEST_CASE(short_loops_are_cut)
{
  // A loop about the apex of a cone, pulled to one segment, and one that contracts.
  Curve_setting cone(cone_disk(6, 3, 2));
  Vertex_sequence rim = disk_ring(6, 2);
  rim.push_back(rim.front());
  cone.add(rim, false); // fixed at one vertex
  cone.pull();
  check_inserted(cone);
  BOOST_CHECK_EQUAL(number_of_parts(cut_open(cone).mesh()), 2);
  cone.network.clear();
  cone.triangulation.rollback();
  rim.pop_back();
  cone.add(rim, true);
  cone.pull();
  BOOST_CHECK_EQUAL(number_of_parts(cut_open(cone).mesh()), 1);

  // On two triangles back to back, flips make loops that cross one edge only.
  Mesh_soup pillow;
  pillow.points = {{0, 0, 0}, {1, 0, 0}, {0.4, 1, 0}};
  pillow.triangles = {{0, 1, 2}, {0, 2, 1}};
  for(Edge_index e : descriptors<Edge_index>(3)) {
    const Halfedge_index h = first_side(e);
    Curve_setting s(pillow);
    if(!s.triangulation.is_flippable(h))
      continue;
    s.triangulation.flip(h);
    BOOST_CHECK_EQUAL(s.triangulation.tail(h), s.triangulation.head(h));
    s.network.add_curve(Halfedge_sequence{h}, true);
    check_inserted(s, 2);
    BOOST_CHECK_EQUAL(number_of_parts(cut_open(s).mesh()), 2);
  }
}

BOOST_AUTO_TEST_CASE(loops_cut_a_torus_into_a_cylinder_and_a_square)
{
  const int n = 12, m = 8;
  Curve_setting s(shaken(torus(n, m, 3, 1), 0.02, 1));
  Vertex_sequence around, along;
  for(int j = 0; j <= m; ++j)
    around.emplace_back(n * (j % m));
  for(int i = 0; i <= n; ++i)
    along.emplace_back(i % n);
  s.add(around, false);
  s.pull();
  check_inserted(s);
  const Subdivision cylinder = cut_open(s);
  BOOST_CHECK_EQUAL(euler_characteristic(cylinder.mesh()), 0);
  BOOST_CHECK_EQUAL(number_of_borders(cylinder.mesh()), 2);

  s.network.clear();
  s.triangulation.rollback();
  s.add(around, false);
  s.add(along, false);
  s.pull();
  check_inserted(s);
  const Subdivision square = cut_open(s);
  BOOST_CHECK_EQUAL(euler_characteristic(square.mesh()), 1);
  BOOST_CHECK_EQUAL(number_of_borders(square.mesh()), 1);
}

BOOST_AUTO_TEST_CASE(a_path_from_border_to_border_separates)
{
  const int n = 9;
  Curve_setting s(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 9));
  s.add_path(Vertex_index(grid_vertex(n, 0, 2)), Vertex_index(grid_vertex(n, n, 7)));
  s.pull();
  check_inserted(s);
  const Subdivision halves = cut_open(s);
  BOOST_CHECK_EQUAL(euler_characteristic(halves.mesh()), 2);
  BOOST_CHECK_EQUAL(number_of_borders(halves.mesh()), 2);
}

BOOST_AUTO_TEST_CASE(stacked_curves_are_cut_once)
{
  const Mesh_soup soup = grid_with_hole(12, 12, 4, 8, 4, 8); // paths round the hole's corner run along one another
  const auto vertex = [&](double x, double y) { return Vertex_index(index_of(soup, {x, y, 0})); };
  Curve_setting s(soup);
  s.add_path_through({vertex(0, 6), vertex(6, 12)});
  s.add_path_through({vertex(0, 6), vertex(6, 12)});
  s.add_path_through({vertex(0, 7), vertex(0, 9)}); // along the border
  s.add_path_through({vertex(5, 2), vertex(8, 2)});
  s.add_path_through({vertex(5, 2), vertex(8, 2)});
  FG::order_overlapping_curves(s.network);
  s.pull();
  std::size_t highest = 0;
  for(Edge_index e : descriptors<Edge_index>(s.triangulation.number_of_edges()))
    highest = (std::max)(highest, s.network.stack(e).size());
  BOOST_CHECK_EQUAL(highest, 2u);
  check_inserted(s);
  cut_open(s);
}

BOOST_AUTO_TEST_CASE(many_curves_on_meshes_with_ties_and_without)
{
  Random_numbers random(23);
  int networks = 0;
  for(const Mesh_soup& soup : {cube(4), genus_3_plate(2), shaken(torus(14, 9, 3, 1), 0.03, 2), tetrahedron(4),
                               grid_with_hole(9, 9, 3, 5, 3, 6)})
    for(int round = 0; round < 4; ++round) {
      Curve_setting s(soup);
      const Vertex_index source(random.below(static_cast<int>(s.mesh.number_of_vertices())));
      for(int i = 0; i < 8; ++i) {
        const Vertex_index target(random.below(static_cast<int>(s.mesh.number_of_vertices())));
        if(target != source)
          s.add_path(source, target);
      }
      try {
        FG::order_overlapping_curves(s.network);
      } catch(const FG::Crossing_curves_error&) { // one passes the end of another on the wrong side
        continue;
      }
      ++networks;
      s.pull();
      check_inserted(s);
      cut_open(s);
    }
  BOOST_CHECK_GE(networks, 10);
}

BOOST_AUTO_TEST_CASE(curves_between_inserted_points)
{
  Random_numbers random(41);
  std::size_t dropped = 0;
  for(const Mesh_soup& soup :
      {cube(3), shaken(torus(9, 6, 3, 1), 0.05, 3), jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 2)})
    for(int round = 0; round < 6; ++round) {
      Curve_setting s(soup);
      insert_points(s, 12, random);
      const int first = static_cast<int>(s.mesh.number_of_vertices()),
                count = s.triangulation.number_of_vertices() - first;
      // A walk of edges from one inserted point that bends at others; then a straight one.
      s.network.add_curve(random_walk(s.triangulation, 5, false, random), false);
      check_inserted(s);
      cut_open(s);
      s.network.clear();
      const Vertex_index start(first + random.below(count));
      const auto spokes = spokes_at_tail(s.triangulation, s.triangulation.outgoing(start));
      s.network.add_curve(Halfedge_sequence{spokes.front()}, false);
      s.pull();
      check_inserted(s);
      const Subdivision slit = cut_open(s);
      dropped += static_cast<std::size_t>(s.triangulation.number_of_vertices()) + 1 > slit.mesh().number_of_vertices();
      insert_points(s, 30, random); // curves are split where a point lies on them
      check_inserted(s);
      cut_open(s);
    }
  BOOST_CHECK_GT(dropped, 0u); // inserted points that no curve needs are not in the mesh
}

BOOST_AUTO_TEST_CASE(stacks_of_unfinished_curves_on_delta_complexes)
{
  Random_numbers random(31);
  for(int round = 0; round < 20; ++round) {
    Curve_setting s(shaken(tetrahedron(2), 0.05, 7));
    flip_at_random(s.triangulation, 60, random);
    s.network.add_curve(random_walk(s.triangulation, 6, false, random), false);
    check_inserted(s);
    cut_open(s);
  }
}

BOOST_AUTO_TEST_CASE(crossings_closer_than_rounding_do_no_harm)
{
  // Geodesics through one point of a fine grid's lines, from a mesh that is scaled by 2^-40 across.
  for(double squeeze : {0x1p-20, 0x1p-40}) {
    const int n = 10;
    const Mesh_soup soup = mapped(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 3), [&](const Coordinates& p) {
      return Coordinates{p[0], p[1] * squeeze, 0};
    });
    Curve_setting s(soup);
    for(int i : {1, 4, 9})
      s.add_path(Vertex_index(grid_vertex(n, 0, 0)), Vertex_index(grid_vertex(n, n, i)));
    FG::order_overlapping_curves(s.network);
    s.pull();
    check_inserted(s);
    cut_open(s);
    check_mesh(FG::common_subdivision(s.triangulation, s.mesh));
  }
}

namespace {

// A bundle of edges from bottom to top that are hardly any distance apart, and points on its left and on its right, on
// lines across it that are no further apart. First come the ends of the bundle's edges, then those of the lines.
Mesh_soup bundle_of_edges(int columns, int lines)
{
  constexpr double gap = 1e-15;
  Mesh_soup soup;
  for(int i = 0; i < columns; ++i)
    soup.points.insert(soup.points.end(), {{i * gap, 0, 0}, {(i * 7 % columns == 0 ? i + 0.3 : i + 0.1) * gap, 1, 0}});
  for(int j = 0; j < lines; ++j)
    soup.points.insert(soup.points.end(), {{-1, 0.3 + j * gap, 0}, {1, 0.7 + j * gap, 0}});
  const int last = 2 * columns - 2, top = 2 * (columns + lines - 1);
  for(int i = 0; i < last; i += 2)
    soup.triangles.insert(soup.triangles.end(), {{i, i + 2, i + 1}, {i + 2, i + 3, i + 1}});
  for(int left = 2 * columns; left < top; left += 2)
    soup.triangles.insert(soup.triangles.end(), {{left, 0, left + 2}, {left + 1, left + 3, last}});
  soup.triangles.insert(soup.triangles.end(), {{top, 0, 1}, {last, top + 1, last + 1}});
  return soup;
}

} // namespace

// Rounding exchanges crossings that are so close together; their order is that of the words all the same.
BOOST_AUTO_TEST_CASE(positions_of_crossings_are_in_order)
{
  std::size_t compared = 0;
  for(int columns : {3, 10}) {
    constexpr int lines = 8;
    Curve_setting s(bundle_of_edges(columns, lines));
    for(int left = 2 * columns; left < 2 * (columns + lines); left += 2)
      s.add_path(Vertex_index(left), Vertex_index(left + 1));
    FG::order_overlapping_curves(s.network);
    s.pull();
    const FG::internal::Overlay<Triangulation> overlay(s.triangulation);
    const FG::internal::Overlay_layout<Triangulation> layout(overlay);
    for(Edge_index e : descriptors<Edge_index>(s.triangulation.number_of_edges()))
      for(FG::Index i = 0; i + 1 < overlay.crossings(e); ++i, ++compared)
        BOOST_CHECK_LE(layout.on_intrinsic(overlay.crossing_vertex(e, i)),
                       layout.on_intrinsic(overlay.crossing_vertex(e, i + 1)));
    for(FG::Index h = 0; h < overlay.number_of_halfedges(); ++h) {
      const Input_halfedge_index c = overlay.input_halfedge(h);
      if(c == FG::null_index || !FG::internal::is_first_side(c) || overlay.is_crossing(overlay.origin(h)))
        continue;
      double reached = 0;
      for(FG::Index arc = h; overlay.is_crossing(overlay.target(arc)); arc = overlay.next_arc(arc), ++compared) {
        const FG::Index v = overlay.target(arc);
        const double t = overlay.crossed_halfedge(v) == c ? layout.on_input(v) : 1 - layout.on_input(v);
        BOOST_CHECK_GE(t, reached - 0x1p-53); // told from either end
        reached = t;
      }
    }
  }
  BOOST_CHECK_GT(compared, 500u);
}
