// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Segments that touch vertices, run along edges, or pass degenerate faces.

#include "test_certify/second_opinion.h"

#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>

using namespace Flip_geodesics_test;

// A kite with two points on its long diagonal, which is doubled by degenerate faces. Lines run along crossed edges.
BOOST_AUTO_TEST_CASE_TEMPLATE(segments_along_faces_without_area_are_proven, Setting, Settings)
{
  Setting setting(Mesh_soup{{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, -2, 0}, {2, 2, 0}},
                            {{0, 4, 1}, {0, 1, 3}, {0, 3, 2}, {0, 2, 5}, {2, 3, 5}, {3, 1, 5}}});
  Random_numbers random(1);
  int walks = 0;
  for(int i = 0; i < 300; ++i) {
    const Halfedge_sequence walk = random_walk(setting.triangulation, 8, false, random);
    if(walk.empty())
      continue;
    setting.network.add_curve(walk);
    if(setting.network.is_valid()) {
      const auto p = setting.mesh.point(setting.triangulation.vertex(setting.triangulation.tail(walk.front()))),
                 q = setting.mesh.point(setting.triangulation.vertex(setting.triangulation.head(walk.back())));
      setting.pull();
      BOOST_TEST((FG::certify(setting.network).curves[0].verdict() == FG::Verdict::PROVEN));
      BOOST_TEST(std::abs(setting.network.length(0_c) - std::sqrt(CGAL::squared_distance(p, q))) < 1e-12);
      ++walks;
    }
    take_back(setting);
  }
  BOOST_TEST(walks > 40);
}

// Lengths can make a cone of the point on the line, over which the line would become shorter.
BOOST_AUTO_TEST_CASE(a_segment_that_touches_a_cone_is_bent)
{
  using Lengths = std::map<boost::graph_traits<Surface>::edge_descriptor, double>;
  using Metric = FG::Edge_length_metric<Surface, boost::const_associative_property_map<Lengths>>;
  using Triangulation =
      FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Metric::Kernel>, Metric>;
  for(double far_side : {1.4, 1.5}) {
    // 2 is on the line from 0 to 1, and sees 4, on the other side, at less or more than a right angle from both.
    const Surface mesh = to_mesh<Surface>(Mesh_soup{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, 1, 0}},
                                                    {{0, 3, 1}, {0, 1, 2}, {0, 2, 4}, {2, 1, 4}}});
    const Lengths lengths = edge_lengths(mesh, [=](int u, int v) {
      const std::pair<int, int> ends = std::minmax(u, v);
      if(ends == std::pair<int, int>(0, 1))
        return 2.0;
      return ends.first == 2 || ends.second == 2 ? 1.0 : far_side;
    });
    Triangulation triangulation(mesh, Metric(mesh, boost::make_assoc_property_map(lengths)));
    FG::Edge_path_network<Triangulation> network(triangulation);
    network.add_curve(FG::halfedges_through(triangulation, Vertex_sequence{0_v, 1_v}));
    const auto verdict = FG::certify(network).curves[0].verdict();
    BOOST_TEST((verdict == (far_side < std::sqrt(2.0) ? FG::Verdict::BENT_SEGMENT : FG::Verdict::PROVEN)));
  }
}

namespace {

// The ends of crossed edges that lie on the line of an edge of the triangulation.
template <class Triangulation>
FG::internal::Line_contacts contacts_of(const Triangulation& triangulation, FG::Halfedge_index h)
{
  FG::Decision_statistics statistics;
  FG::internal::Line_contacts contacts;
  FG::internal::Straight_strip<Triangulation>(triangulation, statistics)(triangulation.edge_sequence(h), nullptr,
                                                                         &contacts);
  return contacts;
}

} // namespace

// The line from 0 to 1 touches 2, an end of the only edge that it crosses, at a right angle to that edge. The angle on
// the other side is pi, or a unit in the last place more or less, or there is the border.
BOOST_AUTO_TEST_CASE(a_vertex_touched_at_the_end_of_a_portal_has_a_full_angle_or_is_told)
{
  using Lengths = std::map<boost::graph_traits<Surface>::edge_descriptor, double>;
  using Metric = FG::Edge_length_metric<Surface, boost::const_associative_property_map<Lengths>>;
  using Triangulation =
      FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Metric::Kernel>, Metric>;
  for(bool has_border : {true, false})
    for(double far_side : {4.5, std::nextafter(5.0, 4.0), 5.0, std::nextafter(5.0, 6.0), 5.5})
      for(bool is_reversed : {false, true}) {
        Mesh_soup soup = {{{-3, 0, 0}, {3, 0, 0}, {0, 0, 0}, {0, -4, 0}}, {{0, 3, 2}, {2, 3, 1}}};
        if(!has_border) {
          soup.points.push_back({0, 4, 0});
          soup.triangles.insert(soup.triangles.end(), {{0, 2, 4}, {2, 1, 4}});
        }
        const Surface mesh = to_mesh<Surface>(soup);
        const Lengths lengths = edge_lengths(mesh, [=](int u, int v) {
          if(u == 2 || v == 2)
            return u + v == 2 || u + v == 3 ? 3.0 : 4.0;
          return (std::max)(u, v) == 4 ? far_side : 5.0;
        });
        Triangulation triangulation(mesh, Metric(mesh, boost::make_assoc_property_map(lengths)));
        const FG::Halfedge_index h = FG::internal::halfedge_between(triangulation, 2_v, 3_v);
        triangulation.flip(h);
        FG::Edge_path_network<Triangulation> network(triangulation);
        network.add_curve(Halfedge_sequence{is_reversed ? Triangulation::twin(h) : h});
        const FG::internal::Line_contacts contacts = contacts_of(triangulation, h);
        BOOST_TEST((!contacts.have_edge && contacts.ends.size() == 1));
        const auto verdict = FG::certify(network).curves[0].verdict();
        BOOST_TEST((verdict == (has_border || far_side >= 5 ? FG::Verdict::PROVEN : FG::Verdict::BENT_SEGMENT)));
      }
}

// The line from 2 to 1 runs along the edge from 0 to 3, which it crosses between two degenerate faces, and touches 3,
// whose angle on the other side is less or more than pi.
BOOST_AUTO_TEST_CASE(a_segment_along_an_edge_that_it_crosses)
{
  using Lengths = std::map<boost::graph_traits<Surface>::edge_descriptor, double>;
  using Metric = FG::Edge_length_metric<Surface, boost::const_associative_property_map<Lengths>>;
  using Triangulation =
      FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Metric::Kernel>, Metric>;
  for(double far_side : {3.0, 3.2}) {
    const Surface mesh =
        to_mesh<Surface>(Mesh_soup{{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, -2, 0}, {2, 2, 0}},
                                   {{0, 4, 1}, {0, 1, 3}, {0, 3, 2}, {0, 2, 5}, {2, 3, 5}, {3, 1, 5}}});
    const Lengths lengths = edge_lengths(mesh, [=](int u, int v) {
      const double x[] = {0, 4, 1, 3};
      const std::pair<int, int> ends = std::minmax(u, v);
      if(ends.second < 4)
        return std::abs(x[u] - x[v]);
      if(ends.second == 4 || ends.first == 0)
        return 3.0;
      return ends.first == 1 ? far_side : 2.5;
    });
    Triangulation triangulation(mesh, Metric(mesh, boost::make_assoc_property_map(lengths)));
    const FG::Halfedge_index h = FG::internal::halfedge_between(triangulation, 0_v, 3_v);
    triangulation.flip(h);
    for(FG::Halfedge_index side : {h, Triangulation::twin(h)}) {
      FG::Edge_path_network<Triangulation> network(triangulation);
      network.add_curve(Halfedge_sequence{side});
      const FG::internal::Line_contacts contacts = contacts_of(triangulation, side);
      BOOST_TEST((contacts.have_edge && contacts.ends.size() == 2));
      BOOST_TEST((FG::certify(network).curves[0].verdict() ==
                  (far_side > 3.1 ? FG::Verdict::PROVEN : FG::Verdict::BENT_SEGMENT)));
      network.clear();
    }
  }
}

// ---------------------------------------------------------------- faces on one line

namespace {

struct Edge_with_length
{
  int u, v;
  double length;
};

// Faces of which only the lengths of the edges are known.
class Surface_of_lengths
{
  using Lengths = std::map<boost::graph_traits<Surface>::edge_descriptor, double>;
  using Metric = FG::Edge_length_metric<Surface, boost::const_associative_property_map<Lengths>>;
  using Triangulation =
      FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Metric::Kernel>, Metric>;

public:
  Surface_of_lengths(const std::vector<Corners>& triangles, const std::vector<Edge_with_length>& edges)
  {
    int last = 0;
    for(const Corners& t : triangles)
      last = (std::max)({last, t[0], t[1], t[2]});
    m_mesh = to_mesh<Surface>({std::vector<Coordinates>(static_cast<std::size_t>(last) + 1), triangles});
    m_lengths = edge_lengths(m_mesh, [&](int u, int v) {
      for(const Edge_with_length& e : edges)
        if((e.u == u && e.v == v) || (e.u == v && e.v == u))
          return e.length;
      return 1.0;
    });
  }

  FG::Verdict verdict_on_edge(FG::Vertex_index u, FG::Vertex_index v) const
  {
    Triangulation triangulation = triangulated();
    return verdict(triangulation, FG::internal::halfedge_between(triangulation, u, v));
  }

  // Of what becomes of an edge when it is flipped, whether it could be or not; in both directions.
  FG::Verdict verdict_on_flipped_edge(FG::Vertex_index u, FG::Vertex_index v) const
  {
    Triangulation triangulation = triangulated();
    const FG::Halfedge_index h = FG::internal::halfedge_between(triangulation, u, v);
    triangulation.flip(h);
    const auto result = verdict(triangulation, h);
    BOOST_TEST((verdict(triangulation, Triangulation::twin(h)) == result));
    return result;
  }

  // Of the part of an edge from a point of it to its end.
  FG::Verdict verdict_on_part(FG::Vertex_index u, FG::Vertex_index v, double at_tail) const
  {
    Triangulation triangulation = triangulated();
    const FG::Halfedge_index h = FG::internal::halfedge_between(triangulation, u, v);
    const FG::Vertex_index x = triangulation.insert({FG::internal::as_input(h), {{at_tail, 1 - at_tail, 0}}});
    return verdict(triangulation, FG::internal::halfedge_between(triangulation, x, v));
  }

private:
  Triangulation triangulated() const
  {
    return Triangulation(m_mesh, Metric(m_mesh, boost::make_assoc_property_map(m_lengths)));
  }

  static FG::Verdict verdict(Triangulation& triangulation, FG::Halfedge_index h)
  {
    FG::Edge_path_network<Triangulation> network(triangulation);
    network.add_curve(Halfedge_sequence{h});
    const auto result = FG::certify(network).curves[0].verdict();
    network.clear();
    return result;
  }

  Surface m_mesh;
  Lengths m_lengths;
};

} // namespace

// The faces beside the edge from 0 to 1 lie on its line. A point of them where the angles sum up to less than a full
// one, the tip of a cone, counts where it lies on the edge, and not beyond its ends.
BOOST_AUTO_TEST_CASE(cones_on_the_line_count_between_the_ends)
{
  const auto bent = FG::Verdict::BENT_SEGMENT, proven = FG::Verdict::PROVEN;
  const std::vector<Corners> one_face = {{0, 1, 2}, {2, 1, 3}, {0, 2, 3}};
  const auto with_cone_at = [&](double x) {
    const double to_1 = std::abs(4 - x);
    return Surface_of_lengths(one_face, {{0, 1, 4}, {0, 2, x}, {1, 2, to_1}, {2, 3, 1}, {0, 3, x}, {1, 3, to_1}});
  };
  BOOST_TEST((with_cone_at(2).verdict_on_edge(0_v, 1_v) == bent));
  BOOST_TEST((with_cone_at(5).verdict_on_edge(0_v, 1_v) == proven));
  const double close = 0x1p-32;
  const Surface_of_lengths near_the_head(
      one_face, {{0, 1, 4}, {0, 2, 4 - close}, {1, 2, close}, {2, 3, close}, {0, 3, 4 - close}, {1, 3, close}});
  BOOST_TEST((near_the_head.verdict_on_edge(0_v, 1_v) == bent));
  BOOST_TEST((near_the_head.verdict_on_edge(1_v, 0_v) == bent));
  // Seen from a point of the edge, on either side of the tip.
  BOOST_TEST((with_cone_at(2).verdict_on_part(0_v, 1_v, 0.75) == bent));
  BOOST_TEST((with_cone_at(2).verdict_on_part(0_v, 1_v, 0.25) == proven));
  BOOST_TEST((with_cone_at(1).verdict_on_part(0_v, 1_v, 0.5) == proven));
}

// Beyond the head, at 5 and 6, faces turn back to a tip at 3, which is not on the edge: it is reached over 5 only.
BOOST_AUTO_TEST_CASE(faces_on_the_line_are_followed_between_the_ends)
{
  const std::vector<Corners> triangles = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {2, 4, 5}};
  const std::vector<Edge_with_length> edges = {{0, 1, 4}, {1, 2, 1}, {0, 2, 5}, {1, 3, 2}, {2, 3, 1},
                                               {2, 4, 2}, {3, 4, 3}, {4, 5, 1}, {2, 5, 2}, {3, 5, 3}};
  BOOST_TEST((Surface_of_lengths(triangles, edges).verdict_on_edge(0_v, 1_v) == FG::Verdict::PROVEN));
}

// Past the head, at 4, faces turn back to a tip at that place, or close before it: it is reached over the head only. A
// tip between the ends is reached, also by a face that goes on past the head.
BOOST_AUTO_TEST_CASE(faces_on_the_line_are_left_at_the_head)
{
  const Surface_of_lengths in_place({{0, 1, 2}, {2, 1, 3}, {3, 1, 4}, {3, 4, 5}, {5, 4, 6}, {3, 5, 6}}, {{0, 1, 4},
                                                                                                         {1, 2, 1},
                                                                                                         {0, 2, 5},
                                                                                                         {1, 3, 2},
                                                                                                         {2, 3, 1},
                                                                                                         {1, 4, 1},
                                                                                                         {3, 4, 3},
                                                                                                         {4, 5, 1},
                                                                                                         {3, 5, 2},
                                                                                                         {5, 6, 1},
                                                                                                         {4, 6, 1},
                                                                                                         {3, 6, 2}});
  BOOST_TEST((in_place.verdict_on_edge(0_v, 1_v) == FG::Verdict::PROVEN));
  for(double tip : {3.5, 4.5}) {
    const Surface_of_lengths surface(
        {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {0, 3, 4}},
        {{0, 1, 4}, {1, 2, 1}, {0, 2, 5}, {0, 3, tip}, {2, 3, 5 - tip}, {3, 4, 0.5}, {0, 4, tip}, {2, 4, 5 - tip}});
    BOOST_TEST((surface.verdict_on_edge(0_v, 1_v) == (tip < 4 ? FG::Verdict::BENT_SEGMENT : FG::Verdict::PROVEN)));
  }
}

// A fan of many faces about 0, with far ends beyond the head, and then one with a tip on the edge.
BOOST_AUTO_TEST_CASE(many_faces_on_the_line_are_followed_to_the_last)
{
  for(int n : {3, 80}) {
    std::vector<Corners> triangles = {{0, 1, 2}};
    std::vector<Edge_with_length> edges = {{0, 1, 4}, {0, 2, 5}, {1, 2, 1}};
    for(int i = 2; i < n; ++i) {
      triangles.push_back({0, i, i + 1});
      edges.push_back({0, i + 1, i + 4.0});
      edges.push_back({i, i + 1, 1});
    }
    const int tip = n + 1, beside = n + 2;
    triangles.insert(triangles.end(), {{0, n, tip}, {tip, n, beside}, {0, tip, beside}});
    edges.insert(edges.end(), {{0, tip, 2}, {n, tip, n + 1.0}, {tip, beside, 1}, {0, beside, 2}, {n, beside, n + 1.0}});
    const auto verdict = Surface_of_lengths(triangles, edges).verdict_on_edge(0_v, 1_v);
    BOOST_TEST((verdict == FG::Verdict::BENT_SEGMENT));
  }
}

// Where the face has an area, by a unit in the last place, its tip is not on the edge.
BOOST_AUTO_TEST_CASE(faces_with_little_area_are_told_from_those_without)
{
  const double close = 0x1p-44, rest = 1 - close;
  for(double other : {rest, rest + 0x1p-53}) {
    const Surface_of_lengths surface({{0, 1, 2}, {2, 1, 3}, {0, 2, 3}},
                                     {{0, 1, 1}, {0, 2, close}, {1, 2, other}, {0, 3, 1}});
    BOOST_TEST((surface.verdict_on_edge(0_v, 1_v) == (other > rest ? FG::Verdict::PROVEN : FG::Verdict::BENT_SEGMENT)));
  }
}

// From 0 to 1 through the edge from 2 to 3, on one line: straight if that edge lies between, not beyond an end.
BOOST_AUTO_TEST_CASE(edges_crossed_on_the_line_lie_between_the_ends)
{
  const std::vector<Corners> triangles = {{0, 2, 3}, {3, 2, 1}};
  const auto verdict = [&](double from, double to) {
    return Surface_of_lengths(triangles, {{0, 2, std::abs(from)},
                                          {0, 3, std::abs(to)},
                                          {2, 3, to - from},
                                          {1, 2, std::abs(4 - from)},
                                          {1, 3, std::abs(4 - to)}})
        .verdict_on_flipped_edge(2_v, 3_v);
  };
  BOOST_TEST((verdict(1, 3) == FG::Verdict::PROVEN));
  BOOST_TEST((verdict(-1, 5) == FG::Verdict::PROVEN));
  BOOST_TEST((verdict(5, 6) == FG::Verdict::BENT_SEGMENT));
  BOOST_TEST((verdict(-2, -1) == FG::Verdict::BENT_SEGMENT));
}
