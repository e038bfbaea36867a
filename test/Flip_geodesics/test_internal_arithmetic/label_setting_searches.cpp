// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The search along edges that all searches share, on random graphs with many equally long paths, against distances by
// the algorithm of Bellman and Ford.

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
namespace FGI = CGAL::Flip_geodesics::internal;
using FG::Index;
using FG::Input_halfedge_index;
using FG::Vertex_index;
using Search = FGI::Label_setting_search<FGI::Search_labels<Input_halfedge_index>>;
using Distances = std::vector<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Arc
{
  Index tail, head;
  double length;
};

// Some parallel arcs, some loops, some vertices that are not reached.
struct Graph
{
  explicit Graph(unsigned seed)
  {
    std::mt19937 random(seed);
    for(int i = 0; i < 150; ++i)
      arcs.push_back({static_cast<Index>(random() % number_of_vertices),
                      static_cast<Index>(random() % number_of_vertices), static_cast<double>(random() % 4)});
  }

  Distances distances(Index source) const
  {
    Distances result(number_of_vertices, infinity);
    result[static_cast<std::size_t>(source)] = 0;
    for(std::size_t round = 0; round < number_of_vertices; ++round)
      for(const Arc& a : arcs) {
        double& to = result[static_cast<std::size_t>(a.head)];
        to = (std::min)(to, result[static_cast<std::size_t>(a.tail)] + a.length);
      }
    return result;
  }

  Graph reversed() const
  {
    Graph result(*this);
    for(Arc& a : result.arcs)
      std::swap(a.tail, a.head);
    return result;
  }

  static constexpr std::size_t number_of_vertices = 60;
  std::vector<Arc> arcs;
};

// Notes what the search does.
struct Noting_policy : FGI::Search_policy
{
  struct Origin
  {
    Index vertex;
    double distance;
  };
  struct Step
  {
    double distance;
  };

  explicit Noting_policy(const Graph& g)
    : graph(g)
  {
  }

  template <class Queue>
  bool is_finished(Queue& queue) const
  {
    return queue.priority() > most;
  }
  bool settle(Vertex_index v)
  {
    settled.push_back(v.idx());
    return v.idx() != last;
  }
  template <class Label>
  Origin origin(Vertex_index v, const Label& label)
  {
    distances.push_back(label.distance);
    return {v.idx(), label.distance};
  }
  template <class Function>
  void for_each_halfedge(const Origin& origin, const Function& function)
  {
    for(std::size_t i = 0; i < graph.arcs.size(); ++i)
      if(graph.arcs[i].tail == origin.vertex) {
        ++arcs;
        function(Input_halfedge_index(static_cast<Index>(i)));
      }
  }
  const Arc& arc(Input_halfedge_index h) const { return graph.arcs[static_cast<std::size_t>(h.idx())]; }
  Vertex_index head(Input_halfedge_index h) const { return Vertex_index(arc(h).head); }
  Step step(const Origin& origin, Input_halfedge_index h, Vertex_index)
  {
    ++steps;
    return {origin.distance + arc(h).length};
  }
  void meet(const Origin&, Input_halfedge_index, Vertex_index) { ++meetings; }
  void reach(const Origin&, Input_halfedge_index, Vertex_index, bool is_first) { reached += is_first ? 1 : 0; }
  double key(Vertex_index v, const Step& step) const
  {
    return step.distance + (bounds.empty() ? 0 : bounds[static_cast<std::size_t>(v.idx())]);
  }

  const Graph& graph;
  double most = (std::numeric_limits<double>::max)();
  Index last = -1;  // the search ends when it is settled
  Distances bounds; // of the remaining distances; none for Dijkstra's algorithm
  std::vector<Index> settled;
  Distances distances; // of the vertices settled that are left
  std::size_t arcs = 0, steps = 0, meetings = 0, reached = 1;
};

} // namespace

BOOST_AUTO_TEST_CASE(a_search_settles_vertices_by_distance_and_number)
{
  Search search(Graph::number_of_vertices);
  for(unsigned seed = 0; seed < 50; ++seed) {
    const Graph graph(seed);
    const Distances expected = graph.distances(0);
    search.clear();
    search.add_source(Vertex_index(0));
    Noting_policy policy(graph);
    BOOST_TEST(search.run(policy));
    const auto number = static_cast<std::size_t>(
        std::count_if(expected.begin(), expected.end(), [](double distance) { return distance < infinity; }));
    BOOST_TEST(policy.settled.size() == number);
    BOOST_TEST(search.number_of_settled() == number);
    BOOST_TEST(policy.reached == number);
    BOOST_TEST(policy.steps + policy.meetings == policy.arcs);
    BOOST_TEST(std::is_sorted(policy.distances.begin(), policy.distances.end()));
    for(std::size_t v = 0; v < expected.size(); ++v) {
      const Vertex_index vertex(static_cast<Index>(v));
      BOOST_TEST(search.labels().is_settled(search[vertex]) == (expected[v] < infinity));
      if(expected[v] == infinity)
        continue;
      BOOST_TEST(search[vertex].distance == expected[v]);
      double length = 0;
      for(Input_halfedge_index h : search.path<Input_halfedge_index>(
              vertex, [&](Input_halfedge_index g) { return Vertex_index(policy.arc(g).tail); }))
        length += policy.arc(h).length;
      BOOST_TEST(length == expected[v]);
    }
  }
}

// Arcs of length zero aside, which lead to vertices that were not in the queue before.
BOOST_AUTO_TEST_CASE(of_equal_keys_the_smallest_vertex_comes_first)
{
  for(unsigned seed = 0; seed < 20; ++seed) {
    Graph graph(seed);
    for(Arc& a : graph.arcs)
      ++a.length;
    Search search(Graph::number_of_vertices);
    search.add_source(Vertex_index(0));
    Noting_policy policy(graph);
    search.run(policy);
    std::vector<std::pair<double, Index>> order;
    for(std::size_t i = 0; i < policy.settled.size(); ++i)
      order.emplace_back(policy.distances[i], policy.settled[i]);
    BOOST_TEST(std::is_sorted(order.begin(), order.end()));
  }
}

BOOST_AUTO_TEST_CASE(a_policy_ends_and_directs_a_search)
{
  for(unsigned seed = 0; seed < 50; ++seed) {
    const Graph graph(seed);
    const Distances expected = graph.distances(0);
    std::size_t target = 0;
    for(std::size_t v = 0; v < expected.size(); ++v)
      if(expected[v] < infinity && expected[v] > expected[target])
        target = v;
    std::vector<std::size_t> visited;
    for(bool is_directed : {false, true}) {
      Search search(Graph::number_of_vertices);
      Noting_policy policy(graph);
      policy.last = static_cast<Index>(target);
      if(is_directed)
        policy.bounds = graph.reversed().distances(static_cast<Index>(target));
      search.add_source(Vertex_index(0));
      BOOST_TEST(!search.run(policy));
      BOOST_TEST(policy.settled.back() == policy.last);
      BOOST_TEST(search[Vertex_index(policy.last)].distance == expected[target]);
      visited.push_back(policy.settled.size());
    }
    BOOST_TEST(visited[1] <= visited[0]);

    Search search(Graph::number_of_vertices);
    Noting_policy policy(graph);
    policy.most = 2;
    search.add_source(Vertex_index(0));
    BOOST_TEST(search.run(policy));
    BOOST_TEST(policy.settled.size() == static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(),
                                                                               [](double d) { return d <= 2; })));
  }
}
