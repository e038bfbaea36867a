// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SCENE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SCENE_H

#include "program_mesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// What the files for viewers show of a computation: the curves, and how they were shortened. The mesh comes beside it.
namespace program {

/// A curve, and its legend.
struct Scene_curve
{
  std::size_t number = 0; ///< in the order of the results
  std::string name, status, certificate;
  double initial_length = 0, length = 0;
  std::size_t flips = 0;
  bool is_closed = false;
  bool is_of_tree = false; ///< an edge of a tree of geodesics
  std::size_t run = 0;     ///< curves with one number were shortened together
  std::vector<Point_3> points;
};

/// One step of a shortening. Edges are numbers of polylines of the record, different ones before and after a flip.
struct Recorded_step
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> flipped; ///< the edges that go, and those that come
  std::uint32_t curve = 0;                                      ///< the curve that changes, counted within the run
  std::uint32_t kept_in_front = 0, kept_at_end = 0;             ///< how many of its segments stay
  std::vector<std::uint32_t> inserted;                          ///< those between: 2 edge + (is it passed backwards?)
};

/// How the curves of a run were shortened: the edges that take part, and the steps from the input to the result.
struct Shortening_record
{
  static constexpr std::uint32_t none = 0xffffffff;

  /// An edge of the mesh that is flipped or split, or that a curve runs along.
  struct Input_edge
  {
    std::uint32_t edge; ///< `none` if it is not an edge at the start
    std::uint32_t vertices[2];
  };

  std::vector<std::vector<Point_3>> polylines;
  std::vector<Input_edge> input_edges;            ///< all other edges of the mesh are there all the time
  std::vector<std::uint32_t> edges;               ///< those that are there at the start, and go or carry a curve
  std::vector<std::vector<std::uint32_t>> curves; ///< at the start, as segments like `Recorded_step::inserted`
  std::vector<Recorded_step> steps;
  bool has_all_steps = true; ///< if not, the last steps are merged into one
};

/// The points of all polylines of a record.
inline std::size_t number_of_points(const Shortening_record& record)
{
  std::size_t count = 0;
  for(const std::vector<Point_3>& polyline : record.polylines)
    count += polyline.size();
  return count;
}

struct Scene
{
  std::string title;
  std::vector<Scene_curve> curves;
  std::vector<Shortening_record> records; ///< of each run if steps were recorded; without steps if it was not
};

/// The center of the box about a mesh, and half of its diagonal; not zero.
inline std::pair<Point_3, double> center_and_radius(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for(const auto v : mesh.vertices())
    box += mesh.point(v).bbox();
  const auto middle = [](double a, double b) { return a + (b - a) / 2; };
  const Point_3 center(middle(box.xmin(), box.xmax()), middle(box.ymin(), box.ymax()), middle(box.zmin(), box.zmax()));
  const double radius = std::hypot(box.xmax() - center.x(), box.ymax() - center.y(), box.zmax() - center.z());
  return {center, radius > 0 ? radius : 1};
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SCENE_H
