// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_PROGRESS_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_PROGRESS_H

#include <CGAL/Flip_geodesics/Shortening_visitor.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <mutex>

namespace program {

class Stopwatch
{
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(); }

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// Tells on standard error, every two seconds, how far a run has come; nothing about a shorter run. For several
/// threads.
class Progress
{
public:
  Progress(std::size_t number_of_curves, bool is_quiet)
    : m_number_of_curves(number_of_curves)
    , m_is_quiet(is_quiet)
  {
  }

  void add_flips(std::size_t count)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_flips += count;
    report_now_and_then();
  }

  void add_curves(std::size_t count)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_curves += count;
    report_now_and_then();
  }

private:
  void report_now_and_then()
  {
    constexpr double period = 2;
    const double now = m_stopwatch.seconds();
    if(m_is_quiet || now < m_last + period)
      return;
    m_last = now;
    char line[160];
    std::snprintf(line, sizeof line, "flip_geodesics: %zu of %zu curves, %.1f million flips, %.0f s\n", m_curves,
                  m_number_of_curves, static_cast<double>(m_flips) * 1e-6, now);
    std::cerr << line;
  }

  std::mutex m_mutex;
  Stopwatch m_stopwatch;
  double m_last = 0;
  std::size_t m_curves = 0, m_flips = 0;
  std::size_t m_number_of_curves;
  bool m_is_quiet;
};

/// Passes flips on to the progress, a few thousand at a time.
class Progress_visitor : public CGAL::Flip_geodesics::Default_shortening_visitor
{
public:
  explicit Progress_visitor(Progress& progress)
    : m_progress(progress)
  {
  }
  Progress_visitor(const Progress_visitor&) = delete;
  Progress_visitor& operator=(const Progress_visitor&) = delete;
  ~Progress_visitor() { m_progress.add_flips(m_flips); }

  template <class Triangulation>
  void on_flip(const Triangulation&, CGAL::Flip_geodesics::Index)
  {
    constexpr std::size_t portion = 4096;
    if(++m_flips < portion)
      return;
    m_progress.add_flips(m_flips);
    m_flips = 0;
  }

private:
  Progress& m_progress;
  std::size_t m_flips = 0;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_PROGRESS_H
