// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLE_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLE_INPUT_H

#include "input/curve_input.h"
#include "input/obstacles.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace program {

// The numbers of faces that are left in a line are marked.
inline void read_faces(Text_scanner& words, std::vector<char>& is_marked)
{
  if(!words.has_word())
    words.fail("the line has no faces; write 0-based numbers of faces behind the `f`");
  for(std::string_view word; !(word = words.next_word()).empty();) {
    long long f = 0;
    if(const char* const error = parse_number(word, f))
      words.fail("'" + printable(word) + "' " + error + "; write 0-based numbers of faces between blanks");
    if(f < 0 || f >= static_cast<long long>(is_marked.size()))
      words.fail("face " + std::to_string(f) + " does not exist; use 0 to " + std::to_string(is_marked.size() - 1));
    is_marked[static_cast<std::size_t>(f)] = 1;
  }
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
      read_faces(words, is_in_file);
      return;
    }
    Curve_request wall;
    wall.name = words.place();
    wall.vertices = read_vertices(input_mesh, words);
    check_chain(mesh, wall);
    for(std::size_t i = 1; i < wall.vertices.size(); ++i)
      result.walls.insert(mesh.edge(mesh.halfedge(mesh_vertex(wall.vertices[i - 1]), mesh_vertex(wall.vertices[i]))));
  });
  if(are_none)
    throw Bad_input(input.name() + ": the file has no obstacles; write a wall of vertices, or `f` and faces, per line");
  for(const auto f : mesh.faces())
    if(is_in_file[input_mesh.face_in_file(f)])
      result.faces.insert(f);
  return result;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLE_INPUT_H
