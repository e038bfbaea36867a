// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NEAREST_FACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NEAREST_FACE_H

#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* The barycentric coordinates of a point of a triangle, and its distance from the origin. */
struct Nearest_weights
{
  std::array<double, 3> weights = {{1, 0, 0}};
  double distance = std::numeric_limits<double>::infinity();
};

using Triangle_places = std::array<Place_in_space, 3>;

inline double distance_of(const Triangle_places& corners, const std::array<double, 3>& weights)
{
  Place_in_space p = {{0, 0, 0}};
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t k = 0; k < 3; ++k)
      p[k] += weights[i] * corners[i][k];
  return std::sqrt(dot(p, p));
}

/* Returns the point of side i, from corner i to the next, that is nearest to the origin. */
inline std::array<double, 3> nearest_on_side(const Triangle_places& corners, std::size_t i)
{
  const std::size_t j = (i + 1) % 3;
  const Place_in_space d = difference(corners[j], corners[i]);
  const double squared_length = dot(d, d);
  const double t = squared_length > 0 ? -dot(corners[i], d) / squared_length : 0;
  std::array<double, 3> weights = {{0, 0, 0}};
  weights[j] = (std::min)((std::max)(t, 0.0), 1.0);
  weights[i] = 1 - weights[j];
  return weights;
}

/* Returns the foot of the perpendicular from the origin, by the areas that it cuts off; not finite for a degenerate
 * face. */
inline std::array<double, 3> foot_of_perpendicular(const Triangle_places& corners)
{
  const Place_in_space u = difference(corners[1], corners[0]), v = difference(corners[2], corners[0]);
  const Place_in_space normal = cross(u, v), &from = corners[0]; // to the origin it is minus that
  const double squared = dot(normal, normal);
  const double at_1 = dot(cross(v, from), normal) / squared, at_2 = dot(cross(from, u), normal) / squared;
  return {{1 - at_1 - at_2, at_1, at_2}};
}

/*
 * Returns the point of a triangle that is nearest to the origin: the foot of the perpendicular if that lies inside, or
 * a point of a side. The nearest of these is chosen, so that another one is taken in needles, where the first is
 * inaccurate. The triangle is scaled to avoid overflow and underflow of squares.
 */
inline Nearest_weights nearest_weights(Triangle_places corners)
{
  double scale = 0;
  for(const Place_in_space& p : corners)
    scale = (std::max)({scale, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  if(scale == 0)
    return {{{1, 0, 0}}, 0};
  for(Place_in_space& p : corners)
    for(double& x : p)
      x /= scale;
  Nearest_weights result;
  const auto consider = [&](const std::array<double, 3>& weights) {
    const double distance = scale * distance_of(corners, weights);
    if(distance < result.distance) {
      result.distance = distance;
      result.weights = weights;
    }
  };
  for(std::size_t i = 0; i < 3; ++i)
    consider(nearest_on_side(corners, i));
  const std::array<double, 3> foot = foot_of_perpendicular(corners);
  if(*std::min_element(foot.begin(), foot.end()) > 0) // never degenerate
    consider(foot);
  return result;
}

/* Returns a triangle relative to a point. */
inline Triangle_places seen_from(const Place_in_space& p, Triangle_places corners)
{
  for(Place_in_space& corner : corners)
    corner = difference(corner, p);
  return corners;
}

/*
 * Finds the face of a mesh that is nearest to a point in space, the first one of several that are equally near.
 *
 * The first searches look at all faces. After these, a tree of bounding boxes is built, in O(n log n), which returns
 * bitwise the same: a box is skipped only if no computed distance from its triangles can be smaller.
 *
 * Corners(face) returns the corners of a face as a Triangle_places, and checks the face.
 */
template <class TriangleMesh, class Corners>
class Nearest_face
{
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;

public:
  struct Result
  {
    Face face = boost::graph_traits<TriangleMesh>::null_face();
    Nearest_weights nearest;

    double distance() const { return nearest.distance; }
  };

  Nearest_face(const TriangleMesh& mesh, const Corners& corners)
    : m_faces(faces(mesh).first, faces(mesh).second)
    , m_corners(corners)
  {
  }

  /* Returns a null face if the mesh has none. \pre the coordinates are finite */
  Result operator()(const Place_in_space& p)
  {
    Found found;
    if(m_searches < searches_without_tree) {
      ++m_searches;
      for(std::size_t i = 0; i < m_faces.size(); ++i)
        look_at(i, p, found);
    } else {
      if(m_nodes.empty() && !m_faces.empty())
        build();
      if(!m_nodes.empty())
        search(0, p, found);
    }
    return found.face == none ? Result{} : Result{m_faces[found.face], found.nearest};
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  static constexpr std::size_t most_in_leaf = 4;          // fewer faces cost memory, more of them time
  static constexpr std::size_t searches_without_tree = 4; // building it costs as much as four to five

  struct Found
  {
    std::size_t face = none;
    Nearest_weights nearest;
  };

  struct Box : Bounding_box
  {
    // At most the distance that is computed for a triangle inside, by the error bound of `nearest_face_error`.
    double distance_from(const Place_in_space& p) const
    {
      double farthest = 0, squares = 0;
      for(std::size_t k = 0; k < 3; ++k)
        farthest = (std::max)({farthest, std::abs(low[k] - p[k]), std::abs(high[k] - p[k])});
      if(farthest == 0)
        return 0;
      for(std::size_t k = 0; k < 3; ++k) {
        const double outside = (std::max)({low[k] - p[k], p[k] - high[k], 0.0}) / farthest; // avoids overflow
        squares += outside * outside;
      }
      return farthest * (std::sqrt(squares) - nearest_face_error);
    }
  };

  // Of the faces m_order[first, last). The first child follows the node; a leaf has no second one.
  struct Node
  {
    Box box;
    std::size_t first, last, second_child;
  };

  void look_at(std::size_t i, const Place_in_space& p, Found& found) const
  {
    const Nearest_weights here = nearest_weights(seen_from(p, m_corners(m_faces[i])));
    if(here.distance < found.nearest.distance || (here.distance == found.nearest.distance && i < found.face))
      found = {i, here};
  }

  void build()
  {
    std::vector<Box> boxes(m_faces.size());
    for(std::size_t i = 0; i < m_faces.size(); ++i) {
      m_order.push_back(i);
      for(const Place_in_space& corner : m_corners(m_faces[i]))
        boxes[i].add(corner);
    }
    add_node(0, m_order.size(), boxes);
  }

  // Halves the faces along the longest side of their box, by the middles of their own boxes.
  void add_node(std::size_t first, std::size_t last, const std::vector<Box>& boxes)
  {
    const std::size_t node = m_nodes.size();
    m_nodes.push_back({{}, first, last, none});
    Box& box = m_nodes.back().box;
    for(std::size_t k = first; k < last; ++k) {
      box.add(boxes[m_order[k]].low);
      box.add(boxes[m_order[k]].high);
    }
    if(last - first <= most_in_leaf)
      return;
    const Place_in_space sides = difference(box.high, box.low);
    const std::size_t k = std::max_element(sides.begin(), sides.end()) - sides.begin();
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(m_order.begin() + first, m_order.begin() + middle, m_order.begin() + last,
                     [&](std::size_t i, std::size_t j) {
                       return boxes[i].low[k] / 2 + boxes[i].high[k] / 2 < boxes[j].low[k] / 2 + boxes[j].high[k] / 2;
                     });
    add_node(first, middle, boxes);
    m_nodes[node].second_child = m_nodes.size();
    add_node(middle, last, boxes);
  }

  // Boxes that are as near as the best face are entered, since they may contain one that comes before it.
  void search(std::size_t i, const Place_in_space& p, Found& found) const
  {
    const Node& node = m_nodes[i];
    if(node.second_child == none) {
      for(std::size_t k = node.first; k < node.last; ++k)
        look_at(m_order[k], p, found);
      return;
    }
    std::array<std::pair<double, std::size_t>, 2> children;
    children[0] = {m_nodes[i + 1].box.distance_from(p), i + 1};
    children[1] = {m_nodes[node.second_child].box.distance_from(p), node.second_child};
    if(children[1].first < children[0].first)
      std::swap(children[0], children[1]);
    for(const auto& [distance, child] : children)
      if(distance <= found.nearest.distance)
        search(child, p, found);
  }

  std::vector<Face> m_faces;
  Corners m_corners;
  std::size_t m_searches = 0;
  std::vector<std::size_t> m_order;
  std::vector<Node> m_nodes; // in preorder; empty before the tree is built
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NEAREST_FACE_H
