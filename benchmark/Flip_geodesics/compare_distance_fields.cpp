// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The distances of all vertices from one, exactly, by three methods: the distance field, in which windows compete on
// edges, for vertices only and for being asked anywhere; the search of this package that keeps all windows that no
// vertex is nearer to; and the continuous Dijkstra method of Surface_mesh_shortest_path, where it is not left out. Writes
// a line per source, with a header:
//
//   mesh,triangles,source,field_s,field_windows,everywhere_s,question_s,search_s,search_windows,exact_s,difference
//
// Seconds are of processor time. `question_s` is for one distance inside a face; `difference` the largest one of the
// field to another method, as a part of the distance. With the word threads it measures by a clock instead, on a machine
// that does nothing else: the field of vertices only, by one thread and by all in turn, the least of five runs each:
//
//   mesh,triangles,source,one_thread_s,threads_s
//
// Usage: compare_distance_fields SOURCES EXACT MESH...   EXACT is 0 or 1, or threads

#include "benchmark_meshes.h"
#include "processor_time.h"

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_search.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

namespace {

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Field = FG::Geodesic_distance_field<Triangulation>;
using Search = FG::internal::Window_search<Triangulation>;
using Shortest_path = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

#ifdef CGAL_LINKED_WITH_TBB
using Threads = CGAL::Parallel_tag;
#else
using Threads = CGAL::Sequential_tag;
#endif

// By the clock.
template <class ConcurrencyTag>
double clock_seconds(const Triangulation& triangulation, const Mesh& mesh, FG::Vertex_index source)
{
  const auto start = std::chrono::steady_clock::now();
  Field field(triangulation, mesh, CGAL::parameters::extent(FG::Distance_field_extent::VERTICES_ONLY));
  field.add_source(source);
  field.compute<ConcurrencyTag>();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return seconds.count();
}

void compare_threads(const Mesh& mesh, const std::string& name, FG::Vertex_index source)
{
  const Triangulation triangulation(mesh);
  double one = std::numeric_limits<double>::infinity(), all = one;
  for(int i = 0; i < 5; ++i) {
    one = (std::min)(one, clock_seconds<CGAL::Sequential_tag>(triangulation, mesh, source));
    all = (std::min)(all, clock_seconds<Threads>(triangulation, mesh, source));
  }
  std::cout << name << ',' << mesh.number_of_faces() << ',' << source.idx() << ',' << one << ',' << all << std::endl;
}

double seconds_of_question(const Field& field, const Mesh& mesh)
{
  double sum = 0;
  const double s = seconds([&] {
    for(const auto f : mesh.faces())
      sum += field(f, {{0.2, 0.3, 0.5}}).distance;
  });
  return sum >= 0 ? s / static_cast<double>(mesh.number_of_faces()) : 0;
}

template <class Distance>
double largest_difference(const Field& field, const Triangulation& triangulation, const Distance& distance)
{
  double result = 0;
  for(FG::Vertex_index v(0); v.idx() < triangulation.number_of_vertices(); ++v)
    if(const double d = distance(v); d > 0 && d < std::numeric_limits<double>::infinity())
      result = (std::max)(result, std::abs(field.distance(v) - d) / d);
  return result;
}

void compare(const Mesh& mesh, const std::string& name, FG::Vertex_index source, bool is_exact)
{
  const Triangulation triangulation(mesh);
  FG::Distance_field_report report;
  const double field_s = seconds([&] {
    Field field(triangulation, mesh, CGAL::parameters::extent(FG::Distance_field_extent::VERTICES_ONLY));
    field.add_source(source);
    report = field.compute();
  });
  Field field(triangulation, mesh);
  const double everywhere_s = seconds([&] {
    field.add_source(source);
    field.compute();
  });
  FG::internal::Unfolded_faces<Triangulation> faces(triangulation);
  Search search(triangulation, faces, source);
  const double search_s = seconds([&] { search.run(std::numeric_limits<double>::infinity()); });
  double difference = largest_difference(field, triangulation, [&](FG::Vertex_index v) { return search.distance(v); });
  double exact_s = std::numeric_limits<double>::quiet_NaN();
  if(is_exact) {
    Shortest_path method(mesh);
    exact_s = seconds([&] {
      method.add_source_point(triangulation.input().vertex(source));
      method.build_sequence_tree();
    });
    difference = (std::max)(difference, largest_difference(field, triangulation, [&](FG::Vertex_index v) {
                              return method.shortest_distance_to_source_points(triangulation.input().vertex(v)).first;
                            }));
  }
  std::cout << name << ',' << mesh.number_of_faces() << ',' << source.idx() << ',' << field_s << ',' << report.windows
            << ',' << everywhere_s << ',' << seconds_of_question(field, mesh) << ',' << search_s << ','
            << search.number_of_windows() << ',' << exact_s << ',' << difference << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    if(argc < 4)
      throw std::runtime_error("usage: compare_distance_fields SOURCES EXACT MESH...");
    const bool is_of_threads = argv[2] == std::string("threads");
    std::cout << (is_of_threads ? "mesh,triangles,source,one_thread_s,threads_s\n"
                                : "mesh,triangles,source,field_s,field_windows,everywhere_s,question_s,search_s,"
                                  "search_windows,exact_s,difference\n");
    for(int i = 3; i < argc; ++i) {
      Mesh mesh;
      CGAL::copy_face_graph(benchmark_meshes::make_mesh(argv[i]), mesh);
      std::mt19937 random(1);
      const std::string name = benchmark_meshes::short_name(argv[i]);
      for(unsigned long k = std::stoul(argv[1]); k > 0; --k) {
        const FG::Vertex_index source(static_cast<FG::Index>(random() % mesh.number_of_vertices()));
        if(is_of_threads)
          compare_threads(mesh, name, source);
        else
          compare(mesh, name, source, argv[2] == std::string("1"));
      }
    }
  } catch(const std::exception& error) {
    std::cerr << "compare_distance_fields: " << error.what() << '\n';
    return 2;
  }
  return std::cout.flush() ? 0 : 1;
}
