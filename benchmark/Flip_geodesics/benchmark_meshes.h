// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_BENCHMARK_MESHES_H
#define FLIP_GEODESICS_BENCHMARK_MESHES_H

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

/* The meshes of the measurements: files, and surfaces made here in any size. */
namespace benchmark_meshes {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

/// A grid of `n * m` cells on the unit square, lifted and closed up by `place(u, v)`.
template <class Place>
Mesh grid_mesh(std::uint32_t n, std::uint32_t m, bool is_closed_u, bool is_closed_v, const Place& place)
{
  Mesh mesh;
  const std::uint32_t columns = is_closed_u ? n : n + 1, rows = is_closed_v ? m : m + 1;
  mesh.reserve(columns * rows, 3 * n * m + n + m, 2 * n * m);
  for(std::uint32_t j = 0; j < rows; ++j)
    for(std::uint32_t i = 0; i < columns; ++i)
      mesh.add_vertex(place(static_cast<double>(i) / n, static_cast<double>(j) / m));
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
    return Mesh::Vertex_index(i % columns + columns * (j % rows));
  };
  for(std::uint32_t j = 0; j < m; ++j)
    for(std::uint32_t i = 0; i < n; ++i) {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

/// A torus with gentle bumps, of about the given number of triangles: smooth.
inline Mesh torus(double triangles)
{
  constexpr double two_pi = boost::math::constants::two_pi<double>();
  const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles)));
  return grid_mesh(n, n / 2, true, true, [](double u, double v) {
    u *= two_pi;
    v *= two_pi;
    const double tube = 0.4 * (1 + 0.25 * std::cos(5 * u) * std::sin(3 * v)), radius = 1 + tube * std::cos(v);
    return Point(radius * std::cos(u), radius * std::sin(u), tube * std::sin(v));
  });
}

/// A terrain whose points are moved at random by a third of a cell in each direction: rough, irregular.
inline Mesh terrain(double triangles)
{
  const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 2)));
  std::mt19937 random(1);
  const auto noise = [&] { return (static_cast<double>(random()) / 4294967296.0 - 0.5) * 2 / 3 / n; };
  return grid_mesh(n, n, false, false, [&](double u, double v) {
    const double x = u + noise(), y = v + noise();
    return Point(x, y, 0.15 * std::sin(9 * x) * std::cos(7 * y) + noise());
  });
}

/// A flat square grid, on which straight edge paths abound.
inline Mesh flat_grid(double triangles)
{
  const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 2)));
  return grid_mesh(n, n, false, false, [](double u, double v) { return Point(u, v, 0); });
}

/// The same mesh with its vertices, and so its faces, numbered along a Hilbert curve.
inline Mesh in_hilbert_order(const Mesh& mesh)
{
  std::vector<Mesh::Vertex_index> order(mesh.vertices().begin(), mesh.vertices().end());
  using Points = Mesh::Property_map<Mesh::Vertex_index, Point>;
  CGAL::hilbert_sort(order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_3<Kernel, Points>(mesh.points()));
  Mesh result;
  result.reserve(mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces());
  std::vector<Mesh::Vertex_index> renumbered(order.size());
  for(const Mesh::Vertex_index v : order)
    renumbered[v] = result.add_vertex(mesh.point(v));
  std::vector<std::array<Mesh::Vertex_index, 3>> triangles;
  for(const Mesh::Face_index f : mesh.faces()) {
    triangles.emplace_back();
    auto corner = triangles.back().begin();
    for(const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      *corner++ = renumbered[v];
  }
  std::sort(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) {
    return *std::min_element(a.begin(), a.end()) < *std::min_element(b.begin(), b.end());
  });
  for(const auto& t : triangles)
    result.add_face(t[0], t[1], t[2]);
  return result;
}

/*!
 * A mesh by name: `torus:N`, `terrain:N`, `grid:N` of about N triangles, or a file; followed by `+K` it is subdivided
 * K times by Loop's scheme, and by `~`, numbered along a Hilbert curve.
 * \throws std::runtime_error
 */
inline Mesh make_mesh(const std::string& name)
{
  if(!name.empty() && name.back() == '~')
    return in_hilbert_order(make_mesh(name.substr(0, name.size() - 1)));
  const std::size_t plus = name.rfind('+');
  const bool is_subdivided =
      plus != std::string::npos && name.find_first_not_of("0123456789", plus + 1) == std::string::npos;
  const std::string base = is_subdivided ? name.substr(0, plus) : name;
  const std::size_t colon = base.find(':');
  const std::string kind = colon == std::string::npos ? "" : base.substr(0, colon);
  Mesh mesh;
  if(kind == "torus")
    mesh = torus(std::stod(base.substr(colon + 1)));
  else if(kind == "terrain")
    mesh = terrain(std::stod(base.substr(colon + 1)));
  else if(kind == "grid")
    mesh = flat_grid(std::stod(base.substr(colon + 1)));
  else if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(base, mesh) || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error(base + ": cannot be read as a triangle mesh");
  if(is_subdivided)
    CGAL::Subdivision_method_3::Loop_subdivision(
        mesh, CGAL::parameters::number_of_iterations(std::stoul(name.substr(plus + 1))));
  if(mesh.has_garbage())
    mesh.collect_garbage();
  return mesh;
}

/// The name without folders and extension, for tables.
inline std::string short_name(const std::string& name)
{
  const std::size_t slash = name.rfind('/');
  std::string result = slash == std::string::npos ? name : name.substr(slash + 1);
  const std::size_t dot = result.rfind('.'), end = result.find_first_of("+~", dot == std::string::npos ? 0 : dot);
  if(dot != std::string::npos && result.find(':') == std::string::npos)
    result.erase(dot, (end == std::string::npos ? result.size() : end) - dot);
  return result;
}

} // namespace benchmark_meshes

#endif // FLIP_GEODESICS_BENCHMARK_MESHES_H
