// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SOUP_CHECKS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SOUP_CHECKS_H

#include "bad_input.h"
#include "input/soup.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// What has to hold of a soup of polygons so that it is an oriented manifold triangle mesh. Elements are counted from 0.
namespace program {

inline void check_points(const Soup& soup)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    const auto& p = soup.points[v];
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw Bad_input("vertex " + std::to_string(v) + " has a coordinate that is not a finite number; correct it");
  }
}

inline void check_face(const Soup& soup, std::size_t f)
{
  const std::vector<std::size_t>& face = soup.faces[f];
  const std::string name = "face " + std::to_string(f);
  if(face.size() != 3)
    throw Bad_input(name + " has " + std::to_string(face.size()) +
                    " vertices, but only triangles are accepted; triangulate the mesh");
  for(std::size_t v : face)
    if(v >= soup.points.size())
      throw Bad_input(name + " has a vertex that is not one of the " + std::to_string(soup.points.size()) +
                      " in the file; correct it");
  if(face[0] == face[1] || face[1] == face[2] || face[2] == face[0])
    throw Bad_input(name + " has vertex " + std::to_string(face[0] == face[1] ? face[0] : face[2]) +
                    " twice; remove the face");
}

/*
 * The sides of the faces: side 3f + i leads from corner i of face f to corner i + 1. Sorted by their two vertices, so
 * that the sides of an edge lie together.
 */
class Soup_sides
{
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  explicit Soup_sides(const Soup& soup)
    : m_soup(soup)
    , m_twins(3 * soup.faces.size(), none)
  {
    std::vector<Side> sides;
    sides.reserve(m_twins.size());
    for(std::size_t s = 0; s < m_twins.size(); ++s)
      sides.push_back({(std::min)(tail(s), head(s)), (std::max)(tail(s), head(s)), s});
    std::sort(sides.begin(), sides.end());
    for(std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      while(end < sides.size() && sides[end].is_on_edge_of(sides[begin]))
        ++end;
      pair_sides(sides, begin, end);
    }
  }

  std::size_t number_of_sides() const { return m_twins.size(); }
  std::size_t tail(std::size_t s) const { return m_soup.faces[s / 3][s % 3]; }
  std::size_t head(std::size_t s) const { return tail(next(s)); }
  std::size_t twin(std::size_t s) const { return m_twins[s]; }
  static std::size_t next(std::size_t s) { return s % 3 == 2 ? s - 2 : s + 1; }

private:
  struct Side
  {
    std::size_t low, high, side;

    bool is_on_edge_of(const Side& other) const { return low == other.low && high == other.high; }
    bool operator<(const Side& other) const
    {
      return low != other.low ? low < other.low : (high != other.high ? high < other.high : side < other.side);
    }
  };

  void pair_sides(const std::vector<Side>& sides, std::size_t begin, std::size_t end)
  {
    const std::string edge =
        "the edge between vertices " + std::to_string(sides[begin].low) + " and " + std::to_string(sides[begin].high);
    if(end - begin > 2)
      throw Bad_input(edge + " has " + std::to_string(end - begin) + " faces, among them " +
                      std::to_string(sides[begin].side / 3) + " and " + std::to_string(sides[begin + 2].side / 3) +
                      ", so the mesh is not a manifold; remove or separate faces");
    if(end - begin < 2)
      return;
    const std::size_t a = sides[begin].side, b = sides[begin + 1].side;
    if(tail(a) == tail(b))
      throw Bad_input(edge + " has faces " + std::to_string(a / 3) + " and " + std::to_string(b / 3) +
                      " of opposite orientation; orient the faces alike");
    m_twins[a] = b;
    m_twins[b] = a;
  }

  const Soup& m_soup;
  std::vector<std::size_t> m_twins;
};

// The faces at a vertex form one fan, or one disk.
inline void check_vertex_fans(const Soup& soup, const Soup_sides& sides)
{
  std::vector<char> is_seen(sides.number_of_sides(), 0), has_fan(soup.points.size(), 0);
  for(std::size_t start = 0; start < sides.number_of_sides(); ++start) {
    if(is_seen[start] != 0)
      continue;
    const std::size_t v = sides.tail(start);
    if(has_fan[v] != 0)
      throw Bad_input("vertex " + std::to_string(v) + " joins parts that share no edge of this vertex, one with face " +
                      std::to_string(start / 3) + ", so the mesh is not a manifold; duplicate the vertex");
    has_fan[v] = 1;
    std::size_t s = start;
    do { // clockwise
      is_seen[s] = 1;
      s = sides.twin(s) == Soup_sides::none ? Soup_sides::none : Soup_sides::next(sides.twin(s));
    } while(s != Soup_sides::none && s != start);
    for(s = start; s != Soup_sides::none && (s == start || is_seen[s] == 0);) { // counterclockwise
      is_seen[s] = 1;
      s = sides.twin(Soup_sides::next(Soup_sides::next(s)));
    }
  }
}

/// \throws Bad_input that names the first element that is wrong
inline void check_soup(const Soup& soup)
{
  if(soup.faces.empty())
    throw Bad_input("the file has no faces; use a triangle mesh");
  check_points(soup);
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
    check_face(soup, f);
  check_vertex_fans(soup, Soup_sides(soup));
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SOUP_CHECKS_H
