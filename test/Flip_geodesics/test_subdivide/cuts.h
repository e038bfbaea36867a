// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Meshes cut open along curves, against what the triangulation says.

#ifndef FLIP_GEODESICS_TEST_SUBDIVIDE_CUTS_H
#define FLIP_GEODESICS_TEST_SUBDIVIDE_CUTS_H

#include "test_subdivide/subdivisions.h"

namespace Flip_geodesics_test {

// The last spoke counterclockwise, or any if there is no border.
inline Halfedge_index first_outgoing_halfedge(const Curve_setting& s, Vertex_index v)
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
inline int euler_characteristic_after_cut(Curve_setting& s)
{
  int result = euler_characteristic(s.mesh);
  Indexed_by<Vertex_index, std::vector<int>> degree(static_cast<std::size_t>(s.triangulation.number_of_vertices()), 0);
  for(Edge_index e : descriptors<Edge_index>(s.triangulation.number_of_edges())) {
    const Halfedge_index h = FG::internal::first_side(e);
    const bool is_border = s.triangulation.is_border(h) || s.triangulation.is_border(Triangulation::twin(h));
    if(!s.network.is_occupied(h) || is_border)
      continue;
    --result;
    ++degree[s.triangulation.tail(h)];
    ++degree[s.triangulation.head(h)];
  }
  for(Vertex_index v : descriptors<Vertex_index>(s.triangulation.number_of_vertices())) {
    const bool is_on_border = s.triangulation.counterclockwise(first_outgoing_halfedge(s, v)) == FG::null_index;
    result += (std::max)(degree[v] - (is_on_border ? 0 : 1), 0);
  }
  return result;
}

// The sides of faces along cuts and the border, in circles: told by the triangulation, not by the mesh.
inline int number_of_borders_after_cut(const Curve_setting& s)
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
inline int number_of_parts_after_cut(const Curve_setting& s)
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

inline int number_of_parts(const Surface& mesh)
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

inline double total_area(const Subdivision& subdivision)
{
  double sum = 0;
  for(auto f : subdivision.mesh().faces())
    sum += subdivision.area(f);
  return sum;
}

inline double area_in_space(const Surface& mesh)
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
inline void check_inserted(Curve_setting& s, std::size_t middles = 0)
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
    if(!s.network.is_occupied(FG::internal::first_side(e)))
      continue;
    occupied += s.triangulation.length(FG::internal::first_side(e));
    crossings += static_cast<std::size_t>((std::max)(s.triangulation.crossings(e), 0));
    for(auto h : subdivision.halfedges_along(FG::internal::first_side(e)))
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

inline Subdivision cut_open(Curve_setting& s)
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

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_SUBDIVIDE_CUTS_H
