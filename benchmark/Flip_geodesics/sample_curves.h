// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_BENCHMARK_SAMPLE_CURVES_H
#define FLIP_GEODESICS_BENCHMARK_SAMPLE_CURVES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <vector>

/* Random curves to start from, and the meshes of a folder: what the measurements have in common. */
namespace sample {

using CGAL::Flip_geodesics::Halfedge_index;
using CGAL::Flip_geodesics::Input_halfedge_index;
using CGAL::Flip_geodesics::Vertex_index;

using Chain = std::vector<Halfedge_index>;

/// Curves that are pulled tight together.
struct Curves
{
  std::vector<Chain> chains;
  bool are_closed = false;
};

/// The files given, and all files in the folders given, that may be meshes; sorted.
inline std::vector<std::string> mesh_files(const std::vector<std::string>& paths)
{
  namespace fs = std::filesystem;
  std::vector<std::string> result;
  const auto is_mesh = [](const fs::path& p) {
    static const std::set<std::string> extensions = {".off", ".obj", ".ply", ".stl"};
    std::string extension = p.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extensions.count(extension) != 0;
  };
  for(const std::string& path : paths) {
    if(!fs::is_directory(path)) {
      result.push_back(path);
      continue;
    }
    for(const auto& entry : fs::recursive_directory_iterator(path))
      if(entry.is_regular_file() && is_mesh(entry.path()))
        result.push_back(entry.path().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Makes curves on the input mesh of a triangulation, the same ones for the same seed.
template <class Triangulation>
class Source
{
public:
  Source(const Triangulation& triangulation, unsigned seed)
    : m_triangulation(triangulation)
    , m_search(triangulation)
    , m_random(seed)
  {
    for(Vertex_index v(0); v.idx() < triangulation.number_of_vertices(); ++v)
      if(triangulation.input().outgoing(v).is_valid())
        m_vertices.push_back(v);
  }

  /// Is there anything to join?
  bool is_empty() const { return m_vertices.size() < 2; }

  /// Two different vertices that edges connect. \throws Disconnected_endpoints_error after 100 pairs that are not
  std::array<Vertex_index, 2> connected_pair()
  {
    for(int i = 0;; ++i) {
      const Vertex_index u = vertex(), v = vertex();
      if(u == v)
        continue;
      try {
        m_path = m_search(u, v);
        return {u, v};
      } catch(const CGAL::Flip_geodesics::Disconnected_endpoints_error&) {
        if(i >= 100)
          throw;
      }
    }
  }

  /// A shortest edge path between random vertices.
  Curves path()
  {
    connected_pair();
    return {{m_path}, false};
  }

  /// Several of them.
  Curves network(int size)
  {
    Curves result;
    for(int i = 0; i < size; ++i)
      result.chains.push_back(path().chains.front());
    return result;
  }

  /// A loop of shortest edge paths through three random vertices; empty if they are not connected.
  Curves round_trip()
  {
    const std::array<Vertex_index, 2> ends = connected_pair();
    const Vertex_index w = vertex();
    if(w == ends[0] || w == ends[1])
      return {};
    try {
      const std::array<Vertex_index, 3> stops = {ends[0], ends[1], w};
      return {{CGAL::Flip_geodesics::shortest_halfedges_through(m_search, stops, CGAL::parameters::is_closed(true))},
              true};
    } catch(const CGAL::Flip_geodesics::Disconnected_endpoints_error&) {
      return {};
    }
  }

  /// The boundary of a random disk of up to `size` faces; empty if there is no face to start from.
  Curves disk_boundary(int size)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index start(below(m_triangulation.number_of_halfedges()));
    if(input.is_border(start))
      return {};
    std::vector<Input_halfedge_index> loop = {start, input.next(start), input.next(input.next(start))};
    std::set<Vertex_index> passed;
    for(Input_halfedge_index h : loop)
      passed.insert(input.tail(h));
    for(int tries = 4 * size; tries > 0 && static_cast<int>(passed.size()) < size; --tries) {
      const std::size_t i = below(static_cast<int>(loop.size()));
      const Input_halfedge_index t = CGAL::Flip_geodesics::internal::twin_index(loop[i]);
      if(input.is_border(t) || passed.count(input.tail(input.next(input.next(t)))) != 0)
        continue;
      const Input_halfedge_index first = input.next(t), second = input.next(first);
      passed.insert(input.tail(second));
      loop[i] = first;
      loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, second);
    }
    Chain chain;
    for(Input_halfedge_index h : loop)
      chain.push_back(CGAL::Flip_geodesics::internal::as_intrinsic(h));
    return {{chain}, true};
  }

  int below(int bound) { return static_cast<int>(m_random() % static_cast<unsigned>(bound)); }

private:
  Vertex_index vertex() { return m_vertices[below(static_cast<int>(m_vertices.size()))]; }

  const Triangulation& m_triangulation;
  CGAL::Flip_geodesics::Shortest_edge_path<Triangulation> m_search;
  std::mt19937 m_random;
  std::vector<Vertex_index> m_vertices;
  Chain m_path;
};

/// Puts curves into an empty network; false, and none, if they cross.
template <class Network>
bool add(Network& network, const Curves& curves)
{
  for(const Chain& chain : curves.chains)
    network.add_curve(chain, CGAL::parameters::is_closed(curves.are_closed));
  if(curves.chains.size() == 1 && !curves.are_closed)
    return true;
  try {
    CGAL::Flip_geodesics::order_overlapping_curves(network);
    return true;
  } catch(const CGAL::Flip_geodesics::Error&) {
    network.clear();
    return false;
  }
}

} // namespace sample

#endif // FLIP_GEODESICS_BENCHMARK_SAMPLE_CURVES_H
