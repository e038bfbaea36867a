// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points that are inserted from a piece of their input face that is known.

#include "test_intrinsic_triangulation/snapshots.h"

#include <CGAL/Flip_geodesics/internal/triangulation/Point_insertion.h>
#include <CGAL/Flip_geodesics/reports.h>

using namespace Flip_geodesics_test;
using FG::internal::Internals;
using FG::internal::Known_piece;

namespace {

// The neighbors of a vertex, sorted.
std::vector<FG::Vertex_index> neighbors(const Triangulation& t, FG::Vertex_index v)
{
  std::vector<FG::Vertex_index> result;
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(t.number_of_halfedges()))
    if(t.tail(h) == v)
      result.push_back(t.head(h));
  std::sort(result.begin(), result.end());
  return result;
}

FG::Surface_location point_of_face(FG::Input_halfedge_index h, Random_numbers& random)
{
  const double u = random.uniform(0.01, 1), v = random.uniform(0.01, 1), w = random.uniform(0.01, 1);
  return {h, {{u / (u + v + w), v / (u + v + w), w / (u + v + w)}}};
}

} // namespace

// Whatever the piece, and however few letters may be looked at to find the point from a corner of its face, it lands
// where it lands without them.
BOOST_AUTO_TEST_CASE(points_found_from_any_piece)
{
  Random_numbers random(21);
  int from_corner = 0, from_piece = 0;
  const auto no_split = [](const auto&) {};
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    for(int k = 0; k < 40 * scale; ++k) {
      Triangulation t(mesh);
      flip_at_random(t, 10 + random.below(90), random);
      const FG::Input_halfedge_index h(random.below(t.input().number_of_halfedges()));
      if(t.input().is_border(h))
        continue;
      const FG::Surface_location point = point_of_face(h, random);
      FG::Decision_statistics statistics;
      const FG::internal::Located_point other =
          FG::internal::Point_locator<Triangulation>(t, statistics)(point_of_face(h, random));
      const auto start = t.log_position();
      const std::vector<FG::Vertex_index> expected = neighbors(t, t.insert(point));
      for(const std::size_t letters : {0u, 1u, 2u, 3u, 5u, 8u, 13u, 21u, 34u, 55u, 1000u}) {
        t.rollback(start);
        Known_piece piece = {other.halfedge, other.gap, letters};
        BOOST_TEST((neighbors(t, Internals<Triangulation>::insert(t, point, no_split, piece)) == expected));
        BOOST_TEST(piece.letters <= letters);
        from_corner += piece.letters > 0 ? 1 : 0;
        from_piece += letters > 0 && piece.letters == 0 ? 1 : 0;
      }
    }
  }
  std::cout << from_corner << " points found from a corner, " << from_piece << " from a piece\n";
  BOOST_TEST(from_corner > 100);
  BOOST_TEST(from_piece > 100);
}

// A point that is inserted again is the vertex that is there, however its piece is found; one on the edge from there to
// a corner of the face splits that edge.
BOOST_AUTO_TEST_CASE(points_at_vertices_and_on_edges)
{
  Random_numbers random(22);
  const auto no_split = [](const auto&) {};
  for(const Mesh_soup& soup : soups()) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    for(int k = 0; k < 20 * scale; ++k) {
      Triangulation t(mesh);
      const FG::Input_halfedge_index h(random.below(t.input().number_of_halfedges()));
      if(t.input().is_border(h))
        continue;
      const FG::Surface_location point = point_of_face(h, random);
      FG::Surface_location towards_corner = point;
      towards_corner.weights[0] += random.uniform(0.1, 2);
      const FG::Vertex_index p = t.insert(point);
      const auto start = t.log_position();
      for(const bool is_again : {false, true}) {
        t.rollback(start);
        const FG::Vertex_index q = t.insert(towards_corner);
        const std::vector<FG::Vertex_index> around = neighbors(t, q);
        BOOST_TEST(around.size() == 4u);
        BOOST_TEST(std::count(around.begin(), around.end(), p) == 1);
        BOOST_TEST(std::count(around.begin(), around.end(), t.input().tail(h)) == 1);
        if(is_again)
          flip_at_random(t, 40, random);
        BOOST_TEST(t.insert(point) == p);
        BOOST_TEST(t.insert(towards_corner) == q);
        FG::Decision_statistics statistics;
        const FG::internal::Located_point other =
            FG::internal::Point_locator<Triangulation>(t, statistics)(point_of_face(h, random));
        Known_piece piece = {other.halfedge, other.gap, 0};
        BOOST_TEST(Internals<Triangulation>::insert(t, point, no_split, piece) == p);
      }
    }
  }
}
