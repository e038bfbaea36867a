// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_EDGE_FOREST_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_EDGE_FOREST_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

[[noreturn]] inline void throw_meeting_umbrellas(Vertex_index v)
{
  throw_naming<Invalid_mesh_error>("several umbrellas of faces meet at vertex ", v,
                                   "; duplicate the vertex for each umbrella");
}

/*
 * Returns which vertices are on the border. Throws Invalid_mesh_error unless all faces are triangles, each edge belongs
 * to a face, and the border passes each vertex at most once: umbrellas that are connected at a vertex only do not form
 * a surface, and loops through it have no class.
 */
template <class Input_mesh>
Indexed_by<Vertex_index, std::vector<char>> check_surface(const Input_mesh& input)
{
  Indexed_by<Vertex_index, std::vector<char>> is_on_border(static_cast<std::size_t>(input.number_of_vertices()), 0);
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
    if(!input.is_border(h)) {
      check_triangle(input, h);
      continue;
    }
    check_has_face(input, h);
    const Vertex_index v = input.tail(h);
    if(is_on_border[v] != 0)
      throw_meeting_umbrellas(v);
    is_on_border[v] = 1;
  }
  return is_on_border;
}

/* Throws for the first vertex with a halfedge outside the umbrella of another one. */
template <class Input_mesh>
[[noreturn]] void throw_meeting_umbrellas(const Input_mesh& input)
{
  Indexed_by<Vertex_index, std::vector<Index>> others(static_cast<std::size_t>(input.number_of_vertices()), 0);
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges()))
    ++others[input.tail(h)];
  for(Vertex_index v : descriptors<Vertex_index>(input.number_of_vertices())) {
    Input_halfedge_index h = input.outgoing(v);
    for(bool is_first = true; h != null_index && (is_first || h != input.outgoing(v)); is_first = false) {
      --others[v];
      h = input.next(twin_index(h));
    }
    if(others[v] > 0)
      throw_meeting_umbrellas(v);
  }
  throw Invalid_mesh_error("several umbrellas of faces meet at a vertex");
}

/* Calls `use(border)` for each border, a chain of halfedges with the surface on the left, in the order of their
 * smallest edges. */
template <class Input_mesh, class Use>
void for_each_border(const Input_mesh& input, const Use& use)
{
  Indexed_by<Input_halfedge_index, std::vector<char>> is_used(static_cast<std::size_t>(input.number_of_halfedges()), 0);
  for(Input_halfedge_index first : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
    if(!input.is_border(first) || is_used[first] != 0)
      continue;
    std::vector<Halfedge_index> border;
    Input_halfedge_index h = first;
    do {
      border.push_back(as_intrinsic(twin_index(h)));
      is_used[h] = 1;
      h = input.previous(h);
    } while(h != first);
    use(border);
  }
}

/* The loop of an edge: the path to one end, over the edge, and back along the path to the other end. */
class Edge_loop
{
  using Halfedges = std::vector<Halfedge_index>;

public:
  /* `path(v)` must return the path to a vertex from the start of the loop. */
  template <class Input_mesh, class Path>
  Edge_loop(const Input_mesh& input, Input_halfedge_index h, const Path& path)
    : m_out(path(input.tail(h)))
    , m_back(path(input.tail(twin_index(h))))
  {
    m_out.push_back(as_intrinsic(h));
  }

  Halfedges whole() const { return closed(m_out.begin(), m_back.begin()); }

  /* Returns the loop without the common part of its two paths. */
  Halfedges cycle() const
  {
    const auto [first, last] = std::mismatch(m_out.begin(), m_out.end(), m_back.begin(), m_back.end());
    return closed(first, last);
  }

private:
  Halfedges closed(Halfedges::const_iterator first, Halfedges::const_iterator last) const
  {
    Halfedges result(first, m_out.end());
    std::transform(m_back.rbegin(), Halfedges::const_reverse_iterator(last), std::back_inserter(result),
                   [](Halfedge_index h) { return twin_index(h); });
    return result;
  }

  Halfedges m_out, m_back;
};

/*
 * Shortest paths along the edges of the input from one base point in each component to all its vertices: one tree per
 * component. `weight(h)` is the length of a halfedge. Of equally long paths, the first one found is kept.
 *
 * If `is_joined(h)`, the ends of an edge count as coincident: a path that reaches one immediately continues to the
 * other. A tree therefore contains as many of these edges as possible.
 */
class Edge_forest
{
public:
  /* An empty forest. */
  Edge_forest() = default;

  /* Grows a tree from each base point. Each other component has its root at the first vertex with a property, or else
   * at its first vertex. \throws Interrupted */
  template <class Input_mesh, class VertexRange, class Weight, class IsJoined, class IsPreferred>
  Edge_forest(const Input_mesh& input, const VertexRange& base_points, const Weight& weight, const IsJoined& is_joined,
              const IsPreferred& is_preferred, Interruption* interruption)
    : m_incoming(static_cast<std::size_t>(input.number_of_vertices()), null_index)
    , m_distance(static_cast<std::size_t>(input.number_of_vertices()), std::numeric_limits<double>::infinity())
    , m_component(static_cast<std::size_t>(input.number_of_vertices()), -1)
  {
    throw_if_interrupted_before_part(interruption);
    Search search(static_cast<std::size_t>(input.number_of_vertices()));
    Policy<Input_mesh, Weight, IsJoined> policy(*this, search, input, weight, is_joined, interruption);
    for(Vertex_index v : base_points) {
      check_base_point(input, v);
      grow(v, search, policy);
    }
    for(bool are_all_roots : {false, true})
      for(Vertex_index v : descriptors<Vertex_index>(input.number_of_vertices()))
        if(m_component[v] < 0 && input.outgoing(v) != null_index && (are_all_roots || is_preferred(v)))
          grow(v, search, policy);
    if(policy.number_of_steps() != static_cast<std::size_t>(input.number_of_halfedges()))
      throw_meeting_umbrellas(input);
  }

  /* Grows the trees without joined edges. */
  template <class Input_mesh, class VertexRange, class Weight>
  Edge_forest(const Input_mesh& input, const VertexRange& base_points, const Weight& weight,
              Interruption* interruption = nullptr)
    : Edge_forest(
          input, base_points, weight, [](Input_halfedge_index) { return false; }, [](Vertex_index) { return false; },
          interruption)
  {
  }

  /* Returns the base point of each component. */
  const std::vector<Vertex_index>& roots() const { return m_roots; }
  /* Returns the component of a vertex, -1 if it is isolated. */
  Index component(Vertex_index v) const { return m_component[v]; }
  /* Returns the length of the path to a vertex. */
  double distance(Vertex_index v) const { return m_distance[v]; }

  /* Returns whether an edge is on a path. */
  template <class Input_mesh>
  bool contains(const Input_mesh& input, Input_halfedge_index h) const
  {
    return m_incoming[input.tail(h)] == twin_index(h) || m_incoming[input.tail(twin_index(h))] == h;
  }

  /* Returns the path from the base point to a vertex. */
  template <class Input_mesh>
  std::vector<Halfedge_index> path(const Input_mesh& input, Vertex_index v) const
  {
    std::vector<Halfedge_index> result;
    for(Input_halfedge_index h = m_incoming[v]; h != null_index; h = m_incoming[input.tail(h)])
      result.push_back(as_intrinsic(h));
    std::reverse(result.begin(), result.end());
    return result;
  }

  /* Returns the loop of an edge, from the base point back to it. */
  template <class Input_mesh>
  Edge_loop loop(const Input_mesh& input, Input_halfedge_index h) const
  {
    return {input, h, [&](Vertex_index v) { return path(input, v); }};
  }

private:
  // Vertices with a negative key are removed immediately, the last one first.
  class Queue : public Vertex_queue
  {
  public:
    bool empty() const { return m_joined.empty() && Vertex_queue::empty(); }

    void push(double key, Vertex_index v)
    {
      if(key < 0)
        m_joined.push_back(v);
      else
        Vertex_queue::push(key, v);
    }

    Vertex_index pop()
    {
      if(m_joined.empty())
        return Vertex_queue::pop();
      const Vertex_index result = m_joined.back();
      m_joined.pop_back();
      return result;
    }

  private:
    std::vector<Vertex_index> m_joined;
  };

  using Search = Label_setting_search<Search_labels<Input_halfedge_index>, Queue>;

  // Writes labels into the forest when they are settled.
  template <class Input_mesh, class Weight, class IsJoined>
  class Policy : public Input_edge_policy<Input_mesh, Weight>
  {
    using Base = Input_edge_policy<Input_mesh, Weight>;
    using Origin = typename Base::Origin;

  public:
    struct Step
    {
      double distance;
      bool is_joined; // with the vertex from which it starts
    };

    Policy(Edge_forest& forest, const Search& search, const Input_mesh& input, const Weight& weight,
           const IsJoined& is_joined, Interruption* interruption)
      : Base(input, weight, interruption)
      , m_forest(forest)
      , m_search(search)
      , m_is_joined(is_joined)
    {
    }

    /* Returns the number of halfedges that start at settled vertices, in all searches. */
    std::size_t number_of_steps() const { return m_number_of_steps; }

    /* \throws Interrupted */
    bool settle(Vertex_index v)
    {
      m_forest.m_component[v] = static_cast<Index>(m_forest.m_roots.size()) - 1;
      m_forest.m_distance[v] = m_search[v].distance;
      m_forest.m_incoming[v] = m_search[v].incoming();
      return Base::settle(v);
    }

    template <class Function>
    void for_each_halfedge(const Origin& origin, const Function& function)
    {
      Base::for_each_halfedge(origin, [&](Input_halfedge_index h) {
        ++m_number_of_steps;
        function(h);
      });
    }

    Step step(const Origin& origin, Input_halfedge_index h, Vertex_index w) const
    {
      if(m_is_joined(h))
        return {origin.distance, true};
      return {Base::step(origin, h, w).distance, false};
    }

    /* Also checks the length of an edge with two known ends. */
    void meet(const Origin& origin, Input_halfedge_index h, Vertex_index w) const { this->length(origin, h, w); }

    template <class Label>
    bool is_better(const Step& step, const Label& label) const
    {
      return step.is_joined || Base::is_better(step, label);
    }

    double key(Vertex_index, const Step& step) const { return step.is_joined ? -1 : step.distance; }

  private:
    Edge_forest& m_forest;
    const Search& m_search;
    const IsJoined& m_is_joined;
    std::size_t m_number_of_steps = 0;
  };

  template <class Input_mesh>
  void check_base_point(const Input_mesh& input, Vertex_index v) const
  {
    check_vertex(v, input.number_of_vertices());
    if(input.outgoing(v) == null_index)
      throw_naming<Invalid_parameter_error>("vertex ", v, " is isolated and cannot be a base point");
    if(m_component[v] >= 0)
      throw_naming<Invalid_parameter_error>("vertex ", v, " is in a component that already has a base point");
  }

  template <class SearchPolicy>
  void grow(Vertex_index root, Search& search, SearchPolicy& policy)
  {
    m_roots.push_back(root);
    search.add_source(root);
    search.run(policy);
  }

  Indexed_by<Vertex_index, std::vector<Input_halfedge_index>> m_incoming;
  Indexed_by<Vertex_index, std::vector<double>> m_distance;
  Indexed_by<Vertex_index, std::vector<Index>> m_component;
  std::vector<Vertex_index> m_roots;
};

/*
 * Searches for loops along edges through a vertex, the root. A shortest loop of a kind consists of a shortest path, an
 * edge and a shortest path back [EH04]. Both ends of the edge are nearer than half of its length,
 * so that a search ends at half of the best length found. The class of a path is stored at its end; the classes of the
 * two paths and of the edge determine that of the loop.
 */
template <class Triangulation, class PathClass>
class Loop_search
{
  using Input_mesh = std::decay_t<decltype(std::declval<Triangulation>().input())>;

public:
  /* \param interruption null if searches cannot be interrupted */
  Loop_search(const Triangulation& triangulation, Interruption* interruption)
    : m_triangulation(triangulation)
    , m_interruption(interruption)
    , m_search(number_of_vertices())
    , m_classes(number_of_vertices())
  {
  }

  /*
   * The policy of a search, from which those for loops of some kind are derived. These provide the class of a path that
   * continues over a halfedge, `extended(path, h)`, and `meet()`, which examines the loop closed by an edge.
   */
  template <class Derived>
  class Policy : public Input_edge_policy<Input_mesh, Metric_weight<Triangulation>>
  {
    using Base = Input_edge_policy<Input_mesh, Metric_weight<Triangulation>>;

  public:
    explicit Policy(Loop_search& search)
      : Base(search.input(), Metric_weight<Triangulation>{search.m_triangulation}, search.m_interruption)
      , m_loops(search)
    {
    }

    /* \throws Interrupted */
    void reach(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w, bool)
    {
      m_loops.m_classes[w] = class_over(origin, h);
    }

  protected:
    PathClass class_over(const typename Base::Origin& origin, Input_halfedge_index h) const
    {
      return static_cast<const Derived&>(*this).extended(m_loops.m_classes[origin.vertex], h);
    }

    const PathClass& class_of_path(Vertex_index v) const { return m_loops.m_classes[v]; }

    /* Returns the length of the loop closed by a halfedge to a settled vertex. */
    double length_of_loop(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w) const
    {
      return this->step(origin, h, w).distance + m_loops.m_search[w].distance;
    }

  private:
    Loop_search& m_loops;
  };

  /* Searches from a vertex, whose path has a given class. \throws Interrupted, Invalid_coordinate_error */
  template <class SearchPolicy>
  void run(Vertex_index root, const PathClass& of_root, SearchPolicy& policy)
  {
    m_search.clear();
    m_search.add_source(root);
    m_classes[root] = of_root;
    m_search.run(policy);
  }

  /* Returns the loop of an edge by the paths of the last search. */
  Edge_loop loop(Input_halfedge_index h) const
  {
    const auto tail = [this](Input_halfedge_index g) { return input().tail(g); };
    return {input(), h, [&](Vertex_index v) { return m_search.template path<Halfedge_index>(v, tail); }};
  }

private:
  const Input_mesh& input() const { return m_triangulation.input(); }
  std::size_t number_of_vertices() const { return static_cast<std::size_t>(input().number_of_vertices()); }

  const Triangulation& m_triangulation;
  Interruption* m_interruption;
  Label_setting_search<Search_labels<Input_halfedge_index>> m_search;
  Indexed_by<Vertex_index, std::vector<PathClass>> m_classes; // of the paths to reached vertices
};

/* Sets of indices, initially singletons. */
using Disjoint_sets = boost::disjoint_sets_with_storage<>;

inline bool are_united(Disjoint_sets& sets, Index a, Index b)
{
  return sets.find_set(static_cast<std::size_t>(a)) == sets.find_set(static_cast<std::size_t>(b));
}

/* Unites the sets of two indices; returns whether they were distinct. */
inline bool unite(Disjoint_sets& sets, Index a, Index b)
{
  if(are_united(sets, a, b))
    return false;
  sets.union_set(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  return true;
}

/* The treatment of the borders of the surface. */
enum class Borders {
  CLOSED_BY_ONE_FACE, // one additional face is bounded by all borders of a component: for classifying loops
  LEFT_OPEN           // edges of the border are not crossed: for cutting the surface open
};

/*
 * A spanning tree of the faces of each component, over edges not on the paths of a forest, which leaves the shortest
 * loops [EW05]. The loop of an edge is the path to one end, the edge, and the path back from the
 * other end. The edges that are neither in the forest nor crossed by the cotree are the *generators*, and their loops
 * form a shortest basis.
 *
 *        v        w          path - v - w - path back is the loop of edge vw
 *         \_____ /
 *         /     \.
 *        root of the forest
 */
class Cotree
{
public:
  /* An empty cotree. */
  Cotree() = default;

  /* \throws Interrupted */
  template <class Input_mesh, class Weight>
  Cotree(const Input_mesh& input, const Edge_forest& forest, Borders borders, const Weight& weight,
         Interruption* interruption = nullptr)
    : m_is_crossed(static_cast<std::size_t>(input.number_of_halfedges() / 2), 0)
    , m_face(static_cast<std::size_t>(input.number_of_halfedges()), -1)
  {
    throw_if_interrupted_before_part(interruption);
    number_faces(input, forest);
    std::vector<Loop> loops;
    for(Index e = 0; e < input.number_of_halfedges() / 2; ++e) {
      throw_if_interrupted(interruption);
      const Input_halfedge_index h(2 * e), t = twin_index(h);
      const Vertex_index v = input.tail(h), w = input.tail(t);
      if(!forest.contains(input, h))
        loops.push_back({forest.component(v), forest.distance(v) + forest.distance(w) + weight(h), h});
    }
    throw_if_interrupted_before_part(interruption);
    span(input, borders, std::move(loops), interruption);
  }

  /* An edge whose loop belongs to the basis. */
  struct Loop
  {
    Index component;
    double length;
    Input_halfedge_index halfedge; // the first halfedge of the edge

    friend bool operator<(const Loop& a, const Loop& b)
    {
      return std::tie(a.component, a.length, a.halfedge) < std::tie(b.component, b.length, b.halfedge);
    }
  };

  /* Returns the loops of the basis, by component, and in order of length. */
  const std::vector<Loop>& generators() const { return m_generators; }
  /* Returns whether the cotree crosses the edge of a halfedge. */
  bool is_crossed(Input_halfedge_index h) const { return m_is_crossed[static_cast<std::size_t>(h.idx() / 2)] != 0; }

private:
  template <class Input_mesh>
  void number_faces(const Input_mesh& input, const Edge_forest& forest)
  {
    m_number_of_faces = static_cast<Index>(forest.roots().size()); // the outer faces
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
      if(input.is_border(h))
        m_face[h] = forest.component(input.tail(h));
      else if(m_face[h] < 0)
        m_face[h] = m_face[input.next(h)] = m_face[input.previous(h)] = m_number_of_faces++;
    }
  }

  // The longest loops come first: their edges are crossed whenever possible.
  template <class Input_mesh>
  void span(const Input_mesh& input, Borders borders, std::vector<Loop> loops, Interruption* interruption)
  {
    std::sort(loops.begin(), loops.end());
    Disjoint_sets sets(static_cast<std::size_t>(m_number_of_faces));
    for(std::size_t i = loops.size(); i-- > 0;) {
      throw_if_interrupted(interruption);
      const Input_halfedge_index h = loops[i].halfedge, t = twin_index(h);
      const bool is_closed = borders == Borders::LEFT_OPEN && (input.is_border(h) || input.is_border(t));
      if(!is_closed && unite(sets, m_face[h], m_face[t]))
        m_is_crossed[static_cast<std::size_t>(h.idx() / 2)] = 1;
      else
        m_generators.push_back(loops[i]);
    }
    std::reverse(m_generators.begin(), m_generators.end());
  }

  std::vector<char> m_is_crossed;                              // by edge
  Indexed_by<Input_halfedge_index, std::vector<Index>> m_face; // on the left of a halfedge
  Index m_number_of_faces = 0;
  std::vector<Loop> m_generators;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_EDGE_FOREST_H
