// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_GLTF_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_GLTF_FILE_H

#include "output/json_text.h"
#include "scene.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace program {

/*!
 * Writes glTF 2.0 in its binary form: a node with the surface and one with a line strip per curve, below one node that
 * moves them to their place, since coordinates are floats relative to the center of the mesh.
 */
class Gltf_writer
{
public:
  Gltf_writer(const Mesh& mesh, const Scene& scene)
  {
    m_center = center_and_radius(mesh).first;
    add_surface(mesh);
    for(const Scene_curve& curve : scene.curves)
      if(curve.points.size() > 1)
        add_curve(curve);
  }

  void write(std::ostream& out) const
  {
    std::string json = header(), bytes = m_bytes;
    json.append((4 - json.size() % 4) % 4, ' ');
    bytes.append((4 - bytes.size() % 4) % 4, '\0');
    std::string chunks;
    const auto add = [&](const char* type, const std::string& chunk) {
      append_bytes(chunks, static_cast<std::uint32_t>(chunk.size()));
      chunks.append(type, 4);
      chunks += chunk;
    };
    add("JSON", json);
    add("BIN\0", bytes);
    std::string start = "glTF";
    append_bytes(start, std::uint32_t(2));
    append_bytes(start, static_cast<std::uint32_t>(chunks.size() + 12));
    out << start << chunks;
  }

private:
  void add_surface(const Mesh& mesh)
  {
    std::vector<Point_3> points;
    for(const auto v : mesh.vertices())
      points.push_back(mesh.point(v));
    std::vector<std::uint32_t> corners;
    for(const auto f : mesh.faces())
      for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        corners.push_back(static_cast<std::uint32_t>(v));
    constexpr int element_array = 34963, unsigned_int = 5125, triangles = 4;
    const std::size_t positions = add_points(points);
    add_view(to_bytes(corners), element_array);
    const std::size_t indices = add_accessor(unsigned_int, corners.size(), "SCALAR", "");
    m_materials.push_back(material("surface", {0.75, 0.76, 0.78}));
    add_node("surface", positions, ",\"indices\":" + std::to_string(indices), triangles);
  }

  void add_curve(const Scene_curve& curve)
  {
    constexpr int line_strip = 3;
    constexpr std::array<std::array<double, 3>, 4> colors = {
        {{0.72, 0.04, 0.04}, {0.02, 0.2, 0.6}, {0.0, 0.33, 0.1}, {0.55, 0.25, 0.0}}};
    const std::string name = "curve_" + std::to_string(curve.number);
    m_materials.push_back(material(name, colors[curve.number % colors.size()]));
    add_node(name, add_points(curve.points), "", line_strip);
  }

  std::size_t add_points(const std::vector<Point_3>& points)
  {
    std::vector<float> coordinates;
    std::array<float, 3> least, most;
    least.fill((std::numeric_limits<float>::max)());
    most.fill(std::numeric_limits<float>::lowest());
    for(const Point_3& p : points)
      for(int i = 0; i < 3; ++i) {
        coordinates.push_back(static_cast<float>(p[i] - m_center[i]));
        least[i] = (std::min)(least[i], coordinates.back());
        most[i] = (std::max)(most[i], coordinates.back());
      }
    constexpr int array = 34962, single = 5126;
    add_view(to_bytes(coordinates), array);
    return add_accessor(single, points.size(), "VEC3", ",\"min\":" + vector(least) + ",\"max\":" + vector(most));
  }

  template <class Number>
  static std::string vector(const std::array<Number, 3>& v)
  {
    return '[' + json_number(v[0]) + ',' + json_number(v[1]) + ',' + json_number(v[2]) + ']';
  }

  static std::string material(const std::string& name, const std::array<double, 3>& color)
  {
    return "{\"name\":" + json_string(name) + ",\"doubleSided\":true,\"pbrMetallicRoughness\":{\"baseColorFactor\":[" +
           json_number(color[0]) + ',' + json_number(color[1]) + ',' + json_number(color[2]) +
           ",1],\"metallicFactor\":0,\"roughnessFactor\":0.8}}";
  }

  void add_view(const std::string& bytes, int target)
  {
    m_views.push_back("{\"buffer\":0,\"byteOffset\":" + std::to_string(m_bytes.size()) + ",\"byteLength\":" +
                      std::to_string(bytes.size()) + ",\"target\":" + std::to_string(target) + '}');
    m_bytes += bytes;
  }

  // Of the view that was added last.
  std::size_t add_accessor(int component, std::size_t count, const std::string& type, const std::string& bounds)
  {
    m_accessors.push_back("{\"bufferView\":" + std::to_string(m_views.size() - 1) +
                          ",\"componentType\":" + std::to_string(component) + ",\"count\":" + std::to_string(count) +
                          ",\"type\":\"" + type + '"' + bounds + '}');
    return m_accessors.size() - 1;
  }

  // With the material that was added last.
  void add_node(const std::string& name, std::size_t positions, const std::string& indices, int mode)
  {
    m_meshes.push_back("{\"name\":" + json_string(name) + ",\"primitives\":[{\"attributes\":{\"POSITION\":" +
                       std::to_string(positions) + '}' + indices + ",\"mode\":" + std::to_string(mode) +
                       ",\"material\":" + std::to_string(m_materials.size() - 1) + "}]}");
    m_nodes.push_back("{\"name\":" + json_string(name) + ",\"mesh\":" + std::to_string(m_meshes.size() - 1) + '}');
  }

  static std::string list(const std::vector<std::string>& items)
  {
    std::string result = "[";
    for(const std::string& item : items)
      result += (result.size() > 1 ? "," : "") + item;
    return result + ']';
  }

  std::string header() const
  {
    std::vector<std::string> nodes = m_nodes, children;
    for(std::size_t i = 0; i < nodes.size(); ++i)
      children.push_back(std::to_string(i));
    nodes.push_back("{\"name\":\"all\",\"children\":" + list(children) +
                    ",\"translation\":" + vector(std::array<double, 3>{m_center[0], m_center[1], m_center[2]}) + '}');
    return "{\"asset\":{\"version\":\"2.0\",\"generator\":\"flip_geodesics\"},\"scene\":0,\"scenes\":[{\"nodes\":[" +
           std::to_string(nodes.size() - 1) + "]}],\"nodes\":" + list(nodes) + ",\"meshes\":" + list(m_meshes) +
           ",\"materials\":" + list(m_materials) + ",\"accessors\":" + list(m_accessors) +
           ",\"bufferViews\":" + list(m_views) + ",\"buffers\":[{\"byteLength\":" + std::to_string(m_bytes.size()) +
           "}]}";
  }

  Point_3 m_center;
  std::string m_bytes;
  std::vector<std::string> m_views, m_accessors, m_meshes, m_nodes, m_materials;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_GLTF_FILE_H
