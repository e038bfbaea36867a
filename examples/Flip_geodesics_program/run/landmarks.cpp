// SPDX-License-Identifier: LGPL-3.0-or-later

#include "messages.h"
#include "run/computations.h"
#include "run/machine.h" // uses threads under CGAL_LINKED_WITH_TBB

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/exceptions.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <utility>

namespace program {

namespace {

namespace FG = CGAL::Flip_geodesics;

template <class Triangulation>
FG::Geodesic_landmarks make_bounds(const Triangulation& triangulation, std::size_t number, int threads,
                                   Progress_visitor& visitor)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(threads > 1)
    return tbb::task_arena(threads).execute([&] {
      return FG::Geodesic_landmarks(triangulation, number, CGAL::Parallel_tag(),
                                    CGAL::parameters::visitor(std::ref(visitor)));
    });
#else
  static_cast<void>(threads);
#endif
  return FG::Geodesic_landmarks(triangulation, number, CGAL::Sequential_tag(),
                                CGAL::parameters::visitor(std::ref(visitor)));
}

} // namespace

template <class Metric>
Landmarks make_landmarks(std::size_t number, int threads, const Mesh& mesh, const Metric& metric, Progress& progress)
{
  progress.enter("computing landmarks", "steps");
  Progress_visitor visitor(progress);
  const Stopwatch stopwatch;
  try {
    const FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<Kernel>, Metric> triangulation(mesh,
                                                                                                              metric);
    FG::Geodesic_landmarks bounds = make_bounds(triangulation, number, usable_threads(threads), visitor);
    const std::string made = counted(bounds.number_of_landmarks(), "landmark", "landmarks");
    return Landmarks{std::move(bounds), made + ", computed in " + readable_time(stopwatch.seconds()) + '\n'};
  } catch(const FG::Degenerate_face_error& error) {
    throw Bad_input("--landmarks: " + with_advice(error, "omit --landmarks or use --mollify"));
  }
}

template Landmarks make_landmarks(std::size_t, int, const Mesh&, const Program_metric&, Progress&);
template Landmarks make_landmarks(std::size_t, int, const Mesh&, const Weighted_program_metric&, Progress&);

} // namespace program
