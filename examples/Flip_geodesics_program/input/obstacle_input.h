// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLE_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLE_INPUT_H

#include "input/curve_input.h"
#include "input/requests.h"
#include "messages.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace program {

// The number of a face of the file.
inline std::size_t read_face(const Input_mesh& mesh, const Text_scanner& words, std::string_view item)
{
  const auto f =
      read_number<long long>(words, item, "write face numbers, counted from 0 and separated by blanks or commas");
  const std::size_t number_of_faces = mesh.number_of_faces_in_file();
  if(f < 0 || f >= static_cast<long long>(number_of_faces))
    words.fail("face " + std::to_string(f) + " does not exist; use 0 to " + std::to_string(number_of_faces - 1));
  return static_cast<std::size_t>(f);
}

/// A wall per line, as vertices each joined to the next by an edge; after `f`, faces as the file of the mesh numbers
/// them. \throws Bad_input
inline Obstacles read_obstacles(const Input_mesh& input_mesh, const Input_text& input)
{
  const Mesh& mesh = input_mesh;
  Obstacles result;
  std::vector<char> is_in_file(input_mesh.number_of_faces_in_file(), 0);
  bool are_none = true;
  for_each_line(input, [&](Text_scanner& words) {
    are_none = false;
    if(words.take('f')) {
      const std::vector<std::string_view> items = items_of_line(words);
      if(items.empty())
        words.fail("the line has no faces; write face numbers, counted from 0, after the `f`");
      for(const std::string_view item : items)
        is_in_file[read_face(input_mesh, words, item)] = 1;
      return;
    }
    const std::vector<Vertex_index> wall = read_chain(input_mesh, words, false).vertices;
    for(std::size_t i = 1; i < wall.size(); ++i)
      result.walls.insert(mesh.edge(mesh.halfedge(mesh_vertex(wall[i - 1]), mesh_vertex(wall[i]))));
  });
  if(are_none)
    throw Bad_input(
        input.name() +
        ": the file has no obstacles; write one obstacle per line: the vertices of a barrier, or `f` and face numbers");
  for(const auto f : mesh.faces())
    if(is_in_file[input_mesh.face_in_file(f)])
      result.faces.insert(f);
  return result;
}

// The factor of a length. \param is_weighted whether the element has a weight in a line before
inline double read_weight(const Text_scanner& words, std::string_view item, const std::string& element,
                          bool is_weighted)
{
  if(is_weighted)
    words.fail(element + " is given two weights; remove one of the lines");
  const auto weight = read_number<double>(words, item, "write the weight of " + element);
  if(!(weight > 0))
    words.fail("the weight of " + element + " is " + printable(item) + "; give a positive number");
  return weight;
}

/// A weight per line for each face of the file, or lines of a face and its weight; other faces have the weight 1.
/// \throws Bad_input
inline Weights read_face_weights(const Input_mesh& mesh, const Input_text& input)
{
  const std::size_t number_of_faces = mesh.number_of_faces_in_file();
  std::vector<double> in_file(number_of_faces, 1);
  std::vector<char> is_weighted(number_of_faces, 0);
  std::size_t number_of_weights = 0, number_of_items = 0;
  for_each_line(input, [&](Text_scanner& words) {
    const std::vector<std::string_view> items = items_of_line(words);
    if(number_of_weights == 0)
      number_of_items = items.size();
    if(items.size() != number_of_items || items.size() > 2)
      words.fail("the line has " + counted(items.size(), "item", "items") +
                 "; write either one weight in every line, or a face and its weight in every line");
    const std::size_t f = items.size() == 2 ? read_face(mesh, words, items.front()) : number_of_weights;
    const double weight =
        read_weight(words, items.back(), "face " + std::to_string(f), f < number_of_faces && is_weighted[f] != 0);
    if(f < number_of_faces) {
      in_file[f] = weight;
      is_weighted[f] = 1;
    }
    ++number_of_weights;
  });
  if(number_of_weights == 0 || (number_of_items == 1 && number_of_weights != number_of_faces))
    throw Bad_input(input.name() + ": the file has " + counted(number_of_weights, "weight", "weights") + " for " +
                    counted(number_of_faces, "face", "faces") + "; write one for each face, or lines `face weight`");
  Weights result = {input.name(), {}, {}};
  for(const Mesh::Face_index f : mesh.mesh().faces())
    result.of_faces.push_back(in_file[mesh.face_in_file(f)]);
  return result;
}

/// A line for each edge whose weight is not 1: its two vertices and its weight. \throws Bad_input
inline Weights read_edge_weights(const Input_mesh& input_mesh, const Input_text& input)
{
  const Mesh& mesh = input_mesh;
  Weights result = {input.name(), {}, std::vector<double>(mesh.number_of_edges(), 1)};
  std::vector<char> is_weighted(mesh.number_of_edges(), 0);
  bool are_none = true;
  for_each_line(input, [&](Text_scanner& words) {
    are_none = false;
    const std::vector<std::string_view> items = items_of_line(words);
    if(items.size() != 3)
      words.fail("the line has " + counted(items.size(), "item", "items") +
                 "; write two vertices and the weight of their edge");
    std::array<Vertex_index, 2> ends;
    for(std::size_t i = 0; i < 2; ++i)
      ends[i] =
          input_mesh.vertex(read_number<long long>(words, items[i], "write two vertices and a weight"), words.place());
    const std::string edge = std::to_string(ends[0].idx()) + " and " + std::to_string(ends[1].idx());
    const Mesh::Halfedge_index h = mesh.halfedge(mesh_vertex(ends[0]), mesh_vertex(ends[1]));
    if(h == Mesh::null_halfedge())
      words.fail("no edge connects vertices " + edge + "; correct the line");
    const Mesh::Edge_index e = mesh.edge(h);
    result.of_edges[e] = read_weight(words, items[2], "the edge between vertices " + edge, is_weighted[e] != 0);
    is_weighted[e] = 1;
  });
  if(are_none)
    throw Bad_input(input.name() +
                    ": the file has no weights; write two vertices and the weight of their edge per line");
  return result;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLE_INPUT_H
