// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_CURVE_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_CURVE_INPUT_H

#include "input/input_mesh.h"
#include "input/input_text.h"
#include "input/requests.h"
#include "input/scanners.h"
#include "program_mesh.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

// Which curves the program is to compute: read from files or drawn at random, and checked before the first is computed.
namespace program {

inline void check_chain(const Mesh& mesh, const Curve_request& curve)
{
  const std::vector<Vertex_index>& v = curve.vertices;
  if(v.size() < 2)
    throw Bad_input(curve.name + ": a curve requires at least two vertices; add vertices or remove the line");
  for(std::size_t i = 0; i + (curve.is_closed ? 0 : 1) < v.size(); ++i) {
    const Vertex_index a = v[i], b = v[(i + 1) % v.size()];
    if(mesh.halfedge(mesh_vertex(a), mesh_vertex(b)) == Mesh::null_halfedge())
      throw Bad_input(curve.name + ": the curve is not connected: no edge connects vertices " +
                      std::to_string(a.idx()) + " and " + std::to_string(b.idx()) +
                      "; list every vertex along the curve");
  }
}

inline void check_not_empty(const std::vector<Curve_request>& curves, const Input_text& input)
{
  if(curves.empty())
    throw Bad_input(input.name() + ": the file contains no curves; write one per line");
}

inline void check_fixed_vertices(const Network_request& network, const Input_text& input)
{
  for(Vertex_index v : network.fixed_vertices) {
    const bool is_passed = std::any_of(network.curves.begin(), network.curves.end(), [&](const Curve_request& curve) {
      return std::find(curve.vertices.begin(), curve.vertices.end(), v) != curve.vertices.end();
    });
    if(!is_passed)
      throw Bad_input(input.name() + ": no curve passes through the fixed vertex " + std::to_string(v.idx()) +
                      "; remove or correct its number");
  }
}

// Calls `use(words)` for each line that is neither empty nor a comment.
template <class Function>
void for_each_line(const Input_text& input, Function use)
{
  Text_scanner words(input, '#');
  while(words.next_line_with_words())
    use(words);
}

// What is left of a line, between blanks or commas.
inline std::vector<std::string_view> items_of_line(Text_scanner& words)
{
  std::vector<std::string_view> items;
  for(std::string_view word; !(word = words.next_word()).empty();)
    for(const std::string_view piece : pieces_of(word.back() == ',' ? word.substr(0, word.size() - 1) : word))
      items.push_back(piece);
  return items;
}

/// The number that an item is. \param advice what to write instead
template <class Number>
Number read_number(const Text_scanner& words, std::string_view item, const std::string& advice)
{
  Number number = 0;
  if(const char* const error = parse_number(item, number))
    words.fail("'" + printable(item) + "' " + error + "; " + advice);
  return number;
}

inline std::vector<Vertex_index> read_vertices(const Input_mesh& mesh, Text_scanner& words)
{
  const std::string name = words.place();
  std::vector<Vertex_index> vertices;
  for(const std::string_view item : items_of_line(words))
    vertices.push_back(mesh.vertex(
        read_number<long long>(words, item, "write vertex numbers, counted from 0 and separated by blanks or commas"),
        name));
  return vertices;
}

inline Curve_request make_pair_request(Vertex_index s, Vertex_index t, const std::string& name)
{
  Curve_request pair;
  pair.name = name;
  pair.vertices = {s, t};
  pair.is_pair = true;
  return pair;
}

/// `count` pairs of different vertices of one component, the same ones for the same mesh and seed on any machine.
inline std::vector<Curve_request> random_pairs(const Mesh& mesh, std::size_t count, std::uint64_t seed)
{
  boost::disjoint_sets_with_storage<> components(mesh.number_of_vertices());
  for(const auto e : mesh.edges())
    components.union_set(std::size_t(mesh.vertex(e, 0)), std::size_t(mesh.vertex(e, 1)));
  const auto root = [&](Mesh::Vertex_index v) { return components.find_set(std::size_t(v)); };
  std::vector<std::vector<Mesh::Vertex_index>> members(mesh.number_of_vertices());
  std::vector<Mesh::Vertex_index> candidates; // faces make components of three vertices or more; others are isolated
  for(const auto v : mesh.vertices())
    members[root(v)].push_back(v);
  for(const auto v : mesh.vertices())
    if(members[root(v)].size() > 1)
      candidates.push_back(v);

  std::mt19937_64 random(seed);
  std::vector<Curve_request> pairs;
  while(pairs.size() < count) {
    const Mesh::Vertex_index s = candidates[random() % candidates.size()];
    const std::vector<Mesh::Vertex_index>& component = members[root(s)];
    const Mesh::Vertex_index t = component[random() % component.size()];
    if(s != t)
      pairs.push_back(make_pair_request(index_of(s), index_of(t), "random pair " + std::to_string(pairs.size())));
  }
  return pairs;
}

/// What is left of a line, vertices each joined to the next by an edge. A closed curve may repeat its first vertex at
/// the end.
inline Curve_request read_chain(const Input_mesh& mesh, Text_scanner& words, bool is_closed)
{
  Curve_request curve;
  curve.name = words.place();
  curve.is_closed = is_closed;
  curve.vertices = read_vertices(mesh, words);
  if(is_closed && curve.vertices.size() > 1 && curve.vertices.front() == curve.vertices.back())
    curve.vertices.pop_back();
  check_chain(mesh, curve);
  return curve;
}

/// Lines of vertices, each joined to the next by an edge.
inline std::vector<Curve_request> read_curves(const Input_mesh& mesh, const Input_text& input, bool are_closed)
{
  std::vector<Curve_request> curves;
  for_each_line(input, [&](Text_scanner& words) { curves.push_back(read_chain(mesh, words, are_closed)); });
  check_not_empty(curves, input);
  return curves;
}

/// Lines of vertices as in `read_curves()`; after `o` the curve is closed, after `!` the vertices are fixed.
inline Network_request read_network(const Input_mesh& mesh, const Input_text& input)
{
  Network_request network;
  for_each_line(input, [&](Text_scanner& words) {
    if(!words.take('!')) {
      const bool is_closed = words.take('o');
      network.curves.push_back(read_chain(mesh, words, is_closed));
      return;
    }
    const std::vector<Vertex_index> fixed = read_vertices(mesh, words);
    network.fixed_vertices.insert(network.fixed_vertices.end(), fixed.begin(), fixed.end());
  });
  check_not_empty(network.curves, input);
  check_fixed_vertices(network, input);
  return network;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_CURVE_INPUT_H
