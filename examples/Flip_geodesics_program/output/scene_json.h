// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SCENE_JSON_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SCENE_JSON_H

#include "output/json_text.h"
#include "scene.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

namespace program {

/*!
 * Writes the JSON that pages read: the mesh, and what was computed on it.
 *
 * Arrays are of 32-bit numbers, floats for points and unsigned integers for all else, and become text by a function
 * that the constructor is given. Points are relative to the center of the mesh, in units of its radius.
 */
class Scene_json
{
public:
  using Numbers = std::vector<std::uint32_t>; ///< floats by their bits
  using Text_of_array = std::string (*)(const Numbers&);

  explicit Scene_json(const Mesh& mesh, Text_of_array text_of_array = json_base64<std::uint32_t>)
    : m_mesh(mesh)
    , m_text_of_array(text_of_array)
  {
    std::tie(m_center, m_radius) = center_and_radius(mesh);
  }

  /// An object with all that is in a scene.
  void write(std::ostream& out, const Scene& scene) const
  {
    out << "{\"title\":" << json_string(scene.title) << ',';
    write_mesh(out);
    out << ",\n";
    write_curves(out, scene);
    out << '}';
  }

  /// Members of an object: the curves and the runs.
  void write_curves(std::ostream& out, const Scene& scene) const
  {
    out << "\"curves\":[";
    std::vector<std::vector<Point_3>> points;
    for(const Scene_curve& curve : scene.curves) {
      out << (points.empty() ? "\n" : ",\n");
      write_curve(out, curve);
      points.push_back(curve.points);
    }
    out << "],\n";
    write_polylines(out, "curve", points);
    out << ",\n\"runs\":[";
    for(std::size_t i = 0; i < scene.records.size(); ++i) {
      out << (i == 0 ? "\n" : ",\n");
      write_record(out, scene.records[i]);
    }
    out << ']';
  }

  /// Members of an object: the mesh, and where it is.
  void write_mesh(std::ostream& out) const
  {
    out << json_members("radius", m_radius, "center", std::vector<double>{m_center.x(), m_center.y(), m_center.z()})
        << ",\n";
    Numbers positions;
    for(const auto v : m_mesh.vertices())
      append(positions, m_mesh.point(v));
    Numbers corners;
    for(const auto f : m_mesh.faces())
      for(const auto v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
        corners.push_back(static_cast<std::uint32_t>(v));
    out << "\"vertices\":" << m_mesh.number_of_vertices() << ",\"triangles\":" << m_mesh.number_of_faces()
        << ",\n\"positions\":" << m_text_of_array(positions) << ",\n\"corners\":" << m_text_of_array(corners);
  }

private:
  static void write_curve(std::ostream& out, const Scene_curve& curve)
  {
    out << '{'
        << json_members("number", curve.number, "name", curve.name, "status", curve.status, "certificate",
                        curve.certificate, "initialLength", curve.initial_length, "length", curve.length, "flips",
                        curve.flips, "closed", curve.is_closed, "tree", curve.is_of_tree, "run", curve.run)
        << '}';
  }

  // All points in a row, and where each polyline starts.
  void write_polylines(std::ostream& out, const std::string& name, const std::vector<std::vector<Point_3>>& lines) const
  {
    Numbers points, starts = {0};
    for(const std::vector<Point_3>& line : lines) {
      for(const Point_3& p : line)
        append(points, p);
      starts.push_back(static_cast<std::uint32_t>(points.size() / 3));
    }
    out << '"' << name << "Points\":" << m_text_of_array(points) << ",\n\"" << name
        << "Starts\":" << m_text_of_array(starts);
  }

  // Lists have their length in front: the segments of each curve; of each step the flips, the curve, how many segments
  // it keeps in front and at the end, and the new ones between.
  void write_record(std::ostream& out, const Shortening_record& record) const
  {
    Numbers inputs, curves, steps;
    for(const Shortening_record::Input_edge& input : record.input_edges)
      inputs.insert(inputs.end(), {input.edge, input.vertices[0], input.vertices[1]});
    for(const std::vector<std::uint32_t>& curve : record.curves)
      append_list(curves, curve);
    for(const Recorded_step& step : record.steps) {
      steps.push_back(static_cast<std::uint32_t>(step.flipped.size()));
      for(const auto& [before, after] : step.flipped)
        steps.insert(steps.end(), {before, after});
      steps.insert(steps.end(), {step.curve, step.kept_in_front, step.kept_at_end});
      append_list(steps, step.inserted);
    }
    out << '{';
    write_polylines(out, "edge", record.polylines);
    out << ",\n\"inputEdges\":" << m_text_of_array(inputs) << ",\"edges\":" << m_text_of_array(record.edges)
        << ",\n\"curves\":" << m_text_of_array(curves) << ",\n\"steps\":" << m_text_of_array(steps) << ","
        << json_members("hasAllSteps", record.has_all_steps) << '}';
  }

  static void append_list(Numbers& numbers, const Numbers& list)
  {
    numbers.push_back(static_cast<std::uint32_t>(list.size()));
    numbers.insert(numbers.end(), list.begin(), list.end());
  }

  void append(Numbers& coordinates, const Point_3& p) const
  {
    for(int i = 0; i < 3; ++i) {
      const float x = static_cast<float>((p[i] - m_center[i]) / m_radius);
      coordinates.emplace_back();
      std::memcpy(&coordinates.back(), &x, sizeof x);
    }
  }

  const Mesh& m_mesh;
  Text_of_array m_text_of_array;
  Point_3 m_center;
  double m_radius = 1;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SCENE_JSON_H
