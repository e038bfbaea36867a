// SPDX-License-Identifier: LGPL-3.0-or-later
//
// An intrinsic triangulation as a graph of BGL's and CGAL's: their generic algorithms on it, before and after flips.

#include "Curve_setting.h"
#include "Double_triangulation.h"
#include "descriptors.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/graph_traits.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_concepts.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/graph/prim_minimum_spanning_tree.hpp>

#define BOOST_TEST_MODULE graph
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <sstream>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
namespace PMP = CGAL::Polygon_mesh_processing;
using namespace Flip_geodesics_test;

namespace {

using Triangulation = Double_triangulation<Surface>;
using Network = FG::Edge_path_network<Triangulation>;
using Graph = boost::graph_traits<Triangulation>;

// Flips edges at a vertex as long as one of them can be flipped: at a sharp cone until a loop is all around it.
void bare(Triangulation& t, FG::Vertex_index v)
{
  for(int i = 0; i < 100; ++i) {
    const auto outgoing_halfedges = FG::internal::outgoing_halfedges(t, v);
    const auto found = std::find_if(outgoing_halfedges.begin(), outgoing_halfedges.end(),
                                    [&](FG::Halfedge_index h) { return !t.is_border(h) && t.is_flippable(h); });
    if(found == outgoing_halfedges.end())
      return;
    t.flip(*found);
  }
}

// Flips edges at random; with few vertices loops and double edges appear soon.
void flip_at_random(Triangulation& t, int flips, unsigned seed)
{
  Random_numbers random(seed);
  const bool was_flipped = flips > 0;
  for(int i = 0; i < 100 * flips && flips > 0; ++i) {
    const FG::Halfedge_index h(random.below(t.number_of_halfedges()));
    if(!t.is_border(h) && t.is_flippable(h)) {
      t.flip(h);
      --flips;
    }
  }
  if(was_flipped)
    bare(t, 0_v);
}

bool has_loop(const Triangulation& t)
{
  const auto all = edges(t);
  return std::any_of(all.begin(), all.end(), [&](auto e) { return source(e, t) == target(e, t); });
}

bool has_parallel_edges(const Triangulation& t)
{
  std::set<std::pair<FG::Vertex_index, FG::Vertex_index>> seen;
  const auto all = edges(t);
  return std::any_of(all.begin(), all.end(),
                     [&](auto e) { return !seen.insert(std::minmax(source(e, t), target(e, t))).second; });
}

struct Named_soup
{
  const char* name;
  Mesh_soup soup;
  int flips;
};

// Closed and with borders, in one piece and in two, with isolated vertices, few vertices and many flips.
std::vector<Named_soup> soups()
{
  return {{"tetrahedron", tetrahedron(), 0},
          {"flipped tetrahedron", tetrahedron(), 40},
          {"triangle", single_triangle(), 0},
          {"sphere", bumpy_sphere(4, 0.3, 1), 300},
          {"torus", torus(8, 6, 3, 1), 500},
          {"grid", jittered_grid(6, 5, Diagonal_rule::RANDOM, 0.2, 2), 60},
          {"annulus", grid_with_hole(7, 7, 2, 4, 2, 4), 80},
          {"cylinder", cylinder(5, 3, 1, 2), 60},
          {"plate of genus 3", genus_3_plate(1), 300},
          {"cone", cone_disk(6, 2, 1), 500},
          {"two pieces",
           with_isolated_vertices(disjoint_union(torus(5, 4, 3, 1), flat_grid(3, 3, Diagonal_rule::RISING)), 1, 2),
           200}};
}

// Dijkstra's algorithm over the triangulation's own members.
std::vector<double> plain_distances(const Triangulation& t, FG::Vertex_index from)
{
  std::vector<double> distance(static_cast<std::size_t>(t.number_of_vertices()),
                               std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, FG::Vertex_index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  distance[static_cast<std::size_t>(from.idx())] = 0;
  queue.push({0, from});
  while(!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if(d > distance[static_cast<std::size_t>(v.idx())])
      continue;
    for(FG::Halfedge_index h : FG::internal::outgoing_halfedges(t, v)) {
      const double length = t.length((std::min)(h, t.twin(h))); // the other side may be rounded otherwise
      double& there = distance[static_cast<std::size_t>(t.head(h).idx())];
      if(d + length < there) {
        there = d + length;
        queue.push({there, t.head(h)});
      }
    }
  }
  return distance;
}

template <class Function, class... Others>
constexpr bool takes_none = (... && !std::is_invocable_v<Function, Others>);

template <class Value>
auto vertex_map(const Triangulation& t, std::vector<Value>& values)
{
  values.resize(num_vertices(t));
  return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, t));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_concepts_are_modeled)
{
  BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Triangulation>));
  BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<Triangulation>));
  BOOST_CONCEPT_ASSERT((boost::BidirectionalGraphConcept<Triangulation>));
  BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<Triangulation>));
  BOOST_CONCEPT_ASSERT((CGAL::concepts::HalfedgeListGraph<Triangulation>));
  BOOST_CONCEPT_ASSERT((CGAL::concepts::FaceListGraph<Triangulation>));
  BOOST_CONCEPT_ASSERT(
      (boost::ReadablePropertyMapConcept<decltype(get(boost::edge_weight, std::declval<Triangulation&>())),
                                         Graph::edge_descriptor>));
  BOOST_TEST(Graph::null_vertex() == FG::Vertex_index());
  BOOST_TEST(!Graph::null_face().is_valid());
}

BOOST_AUTO_TEST_CASE(the_graph_is_valid_after_flips)
{
  bool was_loop_seen = false, were_parallel_edges_seen = false;
  for(const Named_soup& s : soups()) {
    BOOST_TEST_CONTEXT(s.name)
    {
      const Surface mesh = to_mesh<Surface>(s.soup);
      Triangulation t(mesh);
      flip_at_random(t, s.flips, 1);
      was_loop_seen = was_loop_seen || has_loop(t);
      were_parallel_edges_seen = were_parallel_edges_seen || has_parallel_edges(t);
      BOOST_TEST(num_vertices(t) == num_vertices(mesh));
      BOOST_TEST(num_halfedges(t) == num_halfedges(mesh));
      BOOST_TEST(num_edges(t) == num_edges(mesh));
      BOOST_TEST(num_faces(t) == num_faces(mesh));
      BOOST_TEST(CGAL::is_triangle_mesh(t));
      BOOST_TEST(CGAL::is_closed(t) == CGAL::is_closed(mesh));
      // CGAL calls graphs with isolated vertices or loops invalid.
      BOOST_TEST(CGAL::is_valid_halfedge_graph(t) == (CGAL::is_valid_halfedge_graph(mesh) && !has_loop(t)));
      BOOST_TEST(CGAL::is_valid_face_graph(t) == (CGAL::is_valid_face_graph(mesh) && !has_loop(t)));
    }
  }
  BOOST_TEST(was_loop_seen);
  BOOST_TEST(were_parallel_edges_seen);
}

// The functions of the concepts against each other and against the triangulation's members, on all elements.
BOOST_AUTO_TEST_CASE(elements_are_linked)
{
  for(const Named_soup& s : soups()) {
    BOOST_TEST_CONTEXT(s.name)
    {
      const Surface mesh = to_mesh<Surface>(s.soup);
      Triangulation t(mesh);
      flip_at_random(t, s.flips, 2);
      std::unordered_set<FG::Face_index> all_faces;
      for(FG::Face_index f : faces(t)) {
        BOOST_TEST(all_faces.insert(f).second);
        BOOST_TEST(face(halfedge(f, t), t) == f);
        BOOST_TEST(degree(f, t) == 3u);
        for(FG::Halfedge_index h : CGAL::halfedges_around_face(halfedge(f, t), t))
          BOOST_TEST(face(h, t) == f);
      }
      for(FG::Halfedge_index h : halfedges(t)) {
        BOOST_TEST(opposite(opposite(h, t), t) == h);
        BOOST_TEST(prev(next(h, t), t) == h);
        BOOST_TEST(next(prev(h, t), t) == h);
        BOOST_TEST(target(h, t) == source(next(h, t), t));
        BOOST_TEST(CGAL::is_border(h, t) == t.is_border(h));
        BOOST_TEST((face(h, t) == Graph::null_face() || all_faces.count(face(h, t)) == 1));
        BOOST_TEST((face(next(h, t), t) == face(h, t)));
        BOOST_TEST(edge(h, t) == edge(opposite(h, t), t));
        BOOST_TEST(source(edge(h, t), t) == source(h, t)); // an edge knows where it was come from
        BOOST_TEST(halfedge(edge(h, t), t) == h);
        const auto [g, exists] = halfedge(source(h, t), target(h, t), t);
        BOOST_TEST(exists);
        BOOST_TEST((source(g, t) == source(h, t) && target(g, t) == target(h, t) && g <= h));
      }
      for(FG::Vertex_index v : vertices(t)) {
        std::multiset<FG::Halfedge_index> outgoing, wanted;
        for(FG::Edge_index e : CGAL::make_range(out_edges(v, t))) {
          BOOST_TEST(source(e, t) == v);
          outgoing.insert(halfedge(e, t));
        }
        for(FG::Edge_index e : CGAL::make_range(in_edges(v, t)))
          BOOST_TEST(target(e, t) == v);
        const auto outgoing_halfedges = FG::internal::outgoing_halfedges(t, v);
        wanted.insert(outgoing_halfedges.begin(), outgoing_halfedges.end());
        BOOST_TEST((outgoing == wanted));
        BOOST_TEST(degree(v, t) == wanted.size());
        BOOST_TEST(out_degree(v, t) == wanted.size());
        BOOST_TEST((halfedge(v, t) == Graph::null_halfedge()) == wanted.empty());
        if(!wanted.empty())
          BOOST_TEST(target(halfedge(v, t), t) == v);
        for(FG::Vertex_index u : {0_v, 1_v, 2_v}) {
          const auto [h, is_linked] = halfedge(u, v, t);
          const bool is_neighbor =
              std::any_of(outgoing_halfedges.begin(), outgoing_halfedges.end(), [&](auto g) { return t.head(g) == u; });
          BOOST_TEST(is_linked == is_neighbor);
          BOOST_TEST((edge(u, v, t) == std::make_pair(FG::Edge_index(h), is_neighbor)));
        }
        const auto neighbors = adjacent_vertices(v, t);
        BOOST_TEST(static_cast<std::size_t>(std::distance(neighbors.begin(), neighbors.end())) == wanted.size());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(shortest_paths_of_dijkstra)
{
  for(const Named_soup& s : soups()) {
    BOOST_TEST_CONTEXT(s.name)
    {
      const Surface mesh = to_mesh<Surface>(s.soup);
      Triangulation t(mesh);
      flip_at_random(t, s.flips, 3);
      std::vector<double> distances;
      boost::dijkstra_shortest_paths(
          t, 2_v, boost::distance_map(vertex_map(t, distances)).distance_inf(std::numeric_limits<double>::infinity()));
      const std::vector<double> wanted = plain_distances(t, 2_v);
      BOOST_TEST(distances == wanted, boost::test_tools::per_element());
    }
  }
}

// A geodesic is a chain of edges, so Dijkstra's algorithm on the graph finds nothing longer, and here nothing shorter.
BOOST_AUTO_TEST_CASE(geodesics_are_edges_of_the_graph)
{
  Basic_curve_setting<Triangulation> s(jittered_grid(8, 8, Diagonal_rule::RANDOM, 0.2, 5));
  s.add_path(0_v, 80_v);
  s.pull();
  std::vector<double> distances;
  std::vector<FG::Vertex_index> parents;
  boost::dijkstra_shortest_paths(s.triangulation, 0_v,
                                 boost::distance_map(vertex_map(s.triangulation, distances))
                                     .predecessor_map(vertex_map(s.triangulation, parents)));
  BOOST_TEST(std::abs(distances[80] - std::hypot(8.0, 8.0)) < 1e-12);
  std::set<FG::Vertex_index> on_curve = {0_v};
  for(FG::Halfedge_index h : s.network.halfedges(0_c))
    on_curve.insert(s.triangulation.head(h));
  for(FG::Vertex_index v = 80_v; v != 0_v; v = parents[static_cast<std::size_t>(v.idx())])
    BOOST_TEST(on_curve.count(v) == 1u);
}

BOOST_AUTO_TEST_CASE(components)
{
  for(const Named_soup& s : soups()) {
    BOOST_TEST_CONTEXT(s.name)
    {
      const Surface mesh = to_mesh<Surface>(s.soup);
      Triangulation t(mesh);
      flip_at_random(t, s.flips, 4);
      std::vector<int> of_vertices, of_mesh(num_vertices(mesh));
      const int count = boost::connected_components(t, vertex_map(t, of_vertices));
      const int wanted = boost::connected_components(
          mesh, boost::make_iterator_property_map(of_mesh.begin(), get(boost::vertex_index, mesh)));
      BOOST_TEST(count == wanted);
      BOOST_TEST(of_vertices == of_mesh, boost::test_tools::per_element());

      auto of_faces = get(CGAL::dynamic_face_property_t<std::size_t>(), t);
      std::map<FG::Face_index, std::size_t> component_of;
      const std::size_t pieces = PMP::connected_components(t, boost::make_assoc_property_map(component_of));
      std::set<int> with_faces;
      for(FG::Face_index f : faces(t)) {
        with_faces.insert(of_vertices[static_cast<std::size_t>(target(halfedge(f, t), t).idx())]);
        put(of_faces, f, component_of[f]);
        BOOST_TEST(get(of_faces, f) == component_of[f]);
      }
      BOOST_TEST(pieces == with_faces.size());
    }
  }
}

BOOST_AUTO_TEST_CASE(borders)
{
  for(const Named_soup& s : soups()) {
    BOOST_TEST_CONTEXT(s.name)
    {
      const Surface mesh = to_mesh<Surface>(s.soup);
      Triangulation t(mesh);
      flip_at_random(t, s.flips, 5);
      std::vector<FG::Halfedge_index> cycles, border;
      std::vector<Surface::Halfedge_index> cycles_of_mesh;
      PMP::extract_boundary_cycles(t, std::back_inserter(cycles));
      PMP::extract_boundary_cycles(mesh, std::back_inserter(cycles_of_mesh));
      BOOST_TEST(cycles.size() == cycles_of_mesh.size());
      PMP::border_halfedges(t, std::back_inserter(border));
      std::size_t length = 0;
      for(FG::Halfedge_index cycle : cycles)
        for(FG::Halfedge_index h : CGAL::halfedges_around_face(cycle, t)) {
          BOOST_TEST(t.is_border(h));
          ++length;
        }
      BOOST_TEST(border.size() == length);
    }
  }
}

BOOST_AUTO_TEST_CASE(spanning_trees_have_one_length)
{
  const Surface mesh = to_mesh<Surface>(torus(8, 6, 3, 1));
  Triangulation t(mesh);
  flip_at_random(t, 200, 6);
  const auto weight = get(boost::edge_weight, t);
  std::vector<FG::Edge_index> tree;
  boost::kruskal_minimum_spanning_tree(t, std::back_inserter(tree));
  BOOST_TEST(tree.size() == num_vertices(t) - 1);
  double kruskal = 0, prim = 0;
  for(FG::Edge_index e : tree)
    kruskal += get(weight, e);
  std::vector<FG::Vertex_index> parents;
  std::vector<double> keys;
  boost::prim_minimum_spanning_tree(t, vertex_map(t, parents),
                                    boost::root_vertex(0_v).distance_map(vertex_map(t, keys)));
  for(FG::Vertex_index v : vertices(t))
    if(v != 0_v)
      prim += keys[static_cast<std::size_t>(v.idx())];
  BOOST_TEST(std::abs(kruskal - prim) < 1e-9 * kruskal);
}

BOOST_AUTO_TEST_CASE(breadth_first_search_counts_edges)
{
  const Surface mesh = to_mesh<Surface>(torus(8, 6, 3, 1));
  const Triangulation t(mesh); // as the mesh is: the same numbers of edges
  std::vector<int> in_graph, in_mesh(num_vertices(mesh), 0);
  boost::breadth_first_search(
      t, 0_v,
      boost::visitor(boost::make_bfs_visitor(boost::record_distances(vertex_map(t, in_graph), boost::on_tree_edge()))));
  const auto map = boost::make_iterator_property_map(in_mesh.begin(), get(boost::vertex_index, mesh));
  boost::breadth_first_search(
      mesh, Surface::Vertex_index(0),
      boost::visitor(boost::make_bfs_visitor(boost::record_distances(map, boost::on_tree_edge()))));
  BOOST_TEST(in_graph == in_mesh, boost::test_tools::per_element());
}

// A triangulation without loops and double edges is a mesh like any other, with its inserted points.
BOOST_AUTO_TEST_CASE(a_triangulation_is_copied_to_a_mesh)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(4, 4, Diagonal_rule::RISING));
  Triangulation t(mesh);
  const FG::Vertex_index inside = t.insert({t.input().outgoing(6_v), {{0.5, 0.25, 0.25}}});
  FG::flip_to_delaunay(t);
  BOOST_TEST(!has_parallel_edges(t));
  Surface copy;
  std::map<FG::Vertex_index, Surface::Vertex_index> vertex_of;
  std::map<FG::Halfedge_index, Surface::Halfedge_index> halfedge_of;
  CGAL::copy_face_graph(t, copy,
                        CGAL::parameters::vertex_to_vertex_output_iterator(std::inserter(vertex_of, vertex_of.end()))
                            .halfedge_to_halfedge_output_iterator(std::inserter(halfedge_of, halfedge_of.end())));
  BOOST_TEST(CGAL::is_valid_polygon_mesh(copy));
  BOOST_TEST(num_vertices(copy) == num_vertices(mesh) + 1);
  BOOST_TEST(num_faces(copy) == num_faces(t));
  BOOST_TEST(vertex_of.count(inside) == 1u);
  for(FG::Halfedge_index h : halfedges(t)) {
    const Surface::Halfedge_index g = halfedge_of.at(h);
    BOOST_TEST(vertex_of.at(target(h, t)) == target(g, copy));
    const double length = std::sqrt(CGAL::squared_distance(copy.point(source(g, copy)), copy.point(target(g, copy))));
    BOOST_TEST(std::abs(length - get(boost::edge_weight, t, edge(h, t))) < 1e-12); // the grid is flat
  }
}

BOOST_AUTO_TEST_CASE(faces_are_numbered_on_request)
{
  const Surface mesh = to_mesh<Surface>(torus(5, 4, 3, 1));
  Triangulation t(mesh);
  for(int round = 0; round < 2; ++round) {
    const auto number = get(boost::face_index, t);
    FG::Index expected = 0;
    for(FG::Face_index f : faces(t))
      BOOST_TEST(get(number, f) == expected++);
    BOOST_TEST(static_cast<std::size_t>(expected) == num_faces(t));
    flip_at_random(t, 30, 7);
  }
}

BOOST_AUTO_TEST_CASE(the_first_halfedge_can_be_one_of_the_border)
{
  Surface mesh = to_mesh<Surface>(tetrahedron());
  CGAL::Euler::remove_face(*mesh.halfedges().begin(), mesh);
  mesh.collect_garbage();
  const Triangulation t(mesh);
  BOOST_TEST_REQUIRE(t.is_border(FG::Halfedge_index(0)));
  std::size_t count = 0;
  for(const auto f : faces(t)) {
    BOOST_TEST(!t.is_border(halfedge(f, t)));
    ++count;
  }
  BOOST_TEST(count == 3u);
}

BOOST_AUTO_TEST_CASE(what_a_flip_does_to_descriptors)
{
  const Surface mesh = to_mesh<Surface>(octahedron(2));
  Triangulation t(mesh);
  const FG::Halfedge_index h = 12_h;
  BOOST_REQUIRE(t.is_flippable(h));
  const auto list = [&] {
    const auto all = faces(t);
    return std::set<FG::Face_index>(all.begin(), all.end());
  };
  const FG::Face_index left = face(h, t), right = face(opposite(h, t), t);
  std::set<FG::Face_index> before = list();
  t.flip(h);
  std::set<FG::Face_index> after = list();
  BOOST_TEST(after.size() == before.size());
  for(std::set<FG::Face_index>* kept : {&before, &after}) {
    kept->erase(left);
    kept->erase(right);
    kept->erase(face(h, t));
    kept->erase(face(opposite(h, t), t));
  }
  BOOST_TEST((before == after));
}

BOOST_AUTO_TEST_CASE(descriptors_are_values)
{
  std::ostringstream out;
  out << 3_v << ' ' << 4_h << ' ' << 5_e << ' ' << 6_s << ' ' << 7_c << ' ' << FG::Face_index(8);
  BOOST_TEST(out.str() == "v3 h4 e5 s6 c7 f8");
  BOOST_TEST((3_v < 4_v && 4_v > 3_v && 3_v <= 3_v && 3_v >= 3_v && 3_v != 4_v));
  BOOST_TEST((!(3_v < 3_v) && !(3_v > 3_v) && !(4_v <= 3_v) && !(3_v >= 4_v)));
  const auto seven = FG::internal::descriptors<FG::Edge_index>(7);
  BOOST_TEST(seven.begin()[3] == 3_e);
  BOOST_TEST(*std::prev(seven.end()) == 6_e);
  BOOST_TEST((seven.end() - seven.begin() == 7));
  FG::Edge_index edge(9_h);
  BOOST_TEST(++edge == 5_e);
  BOOST_TEST(FG::Edge_index().idx() == -1);
  std::unordered_map<FG::Edge_index, int> numbers = {{FG::Edge_index(4_h), 1}};
  BOOST_TEST(numbers.count(FG::Edge_index(5_h)) == 1u); // from its other side
  BOOST_TEST(numbers.count(2_e) == 1u);
  BOOST_TEST(!FG::Segment_index().is_valid());
  BOOST_TEST((FG::Vertex_index() == FG::null_index));
  static_assert(!std::is_convertible_v<int, FG::Vertex_index> && !std::is_convertible_v<FG::Vertex_index, int>);
  static_assert(!std::is_constructible_v<FG::Vertex_index, FG::Halfedge_index>);
  static_assert(!std::is_constructible_v<FG::Halfedge_index, FG::Input_halfedge_index>);
  static_assert(std::is_trivially_copyable_v<FG::Halfedge_index> && sizeof(FG::Edge_index) == sizeof(FG::Index));
}

// What takes one kind of descriptor takes no other, no number, and no descriptor of the mesh.
BOOST_AUTO_TEST_CASE(descriptors_are_not_taken_for_one_another)
{
  const auto tail = [](auto h) -> decltype(std::declval<const Triangulation&>().tail(h)) { return {}; };
  const auto outgoing = [](auto v) -> decltype(std::declval<const Triangulation&>().outgoing(v)) { return {}; };
  const auto holds = [](auto e) -> decltype(std::declval<const Triangulation&>().holds(e)) { return {}; };
  const auto on_input = [](auto h) -> decltype(std::declval<const Triangulation&>().input().tail(h)) { return {}; };
  const auto length = [](auto c) -> decltype(std::declval<const Network&>().length(c)) { return {}; };
  const auto halfedge = [](auto s) -> decltype(std::declval<const Network&>().halfedge(s)) { return {}; };
  const auto search = [](auto v) -> decltype(std::declval<FG::Shortest_edge_path<Triangulation>&>()(v, v)) {
    return {};
  };
  const auto index = [](auto v) -> decltype(std::declval<const Triangulation&>().index(v)) { return {}; };
  using V = FG::Vertex_index;
  using H = FG::Halfedge_index;
  using E = FG::Edge_index;
  using I = FG::Input_halfedge_index;
  using S = FG::Segment_index;
  using C = FG::Curve_index;
  static_assert(std::is_invocable_v<decltype(tail), H> &&
                takes_none<decltype(tail), V, E, I, S, C, int, Surface::Halfedge_index>);
  static_assert(std::is_invocable_v<decltype(outgoing), V> &&
                takes_none<decltype(outgoing), H, E, I, S, C, int, Surface::Vertex_index>);
  static_assert(std::is_invocable_v<decltype(holds), E> &&
                takes_none<decltype(holds), V, H, I, S, C, int, Surface::Edge_index>);
  static_assert(std::is_invocable_v<decltype(on_input), I> && takes_none<decltype(on_input), V, H, E, S, C, int>);
  static_assert(std::is_invocable_v<decltype(length), C> && takes_none<decltype(length), V, H, E, I, S, int>);
  static_assert(std::is_invocable_v<decltype(halfedge), S> && takes_none<decltype(halfedge), V, H, E, I, C, int>);
  static_assert(std::is_invocable_v<decltype(search), V> &&
                takes_none<decltype(search), H, E, I, S, C, int, Surface::Vertex_index>);
  static_assert(std::is_invocable_v<decltype(index), Surface::Vertex_index> &&
                takes_none<decltype(index), V, H, E, int>);
  BOOST_TEST(sizeof(V) == sizeof(int)); // they cost nothing
}
