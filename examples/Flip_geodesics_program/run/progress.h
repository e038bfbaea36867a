// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PROGRESS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PROGRESS_H

#include "messages.h"

#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <string>

namespace program {

class Stopwatch
{
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(); }

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/*!
 * What a run is doing and how far it has come: written by those who work, in several threads or one, and read by a
 * `Watcher`. A figure is as it was a moment ago, for flips and steps up to `portion` of each thread less.
 */
class Progress
{
public:
  static constexpr std::size_t portion = 64;

  /// Something else begins. \param name, steps a literal; the latter what `add_steps()` counts, null if it is not
  /// called
  /// \param expected how many of them there will be, 0 if unknown
  void enter(const char* name, const char* steps = nullptr, std::size_t expected = 0)
  {
    const std::lock_guard<std::mutex> lock(m_phase_mutex); // a line is about one phase
    m_steps.store(0, std::memory_order_relaxed);
    m_phase_start.store(m_stopwatch.seconds(), std::memory_order_relaxed);
    m_expected_steps.store(expected, std::memory_order_relaxed);
    m_name_of_steps.store(steps, std::memory_order_relaxed);
    m_phase.store(name, std::memory_order_relaxed);
  }

  void expect_curves(std::size_t count)
  {
    m_curves_start.store(m_stopwatch.seconds(), std::memory_order_relaxed);
    m_expected_curves.store(count, std::memory_order_relaxed);
  }
  void add_curves(std::size_t count) { m_curves.fetch_add(count, std::memory_order_relaxed); }
  void add_flips(std::size_t count) { m_flips.fetch_add(count, std::memory_order_relaxed); }
  /// Sets how many of the expected steps are done, by their share.
  void set_share(double share)
  {
    m_steps.store(static_cast<std::size_t>(share * static_cast<double>(m_expected_steps)), std::memory_order_relaxed);
  }
  void add_steps(std::size_t count) { m_steps.fetch_add(count, std::memory_order_relaxed); }

  /// A line for people, as `reading the mesh, 2 s` or `extracting curves, 131 of 500 curves, 94 413 flips, 4 s, 26 %,
  /// about 11 s left`.
  std::string line() const
  {
    const std::lock_guard<std::mutex> lock(m_phase_mutex);
    const auto figure = [](const std::atomic<std::size_t>& count) {
      return readable(count.load(std::memory_order_relaxed));
    };
    std::string text = m_phase.load(std::memory_order_relaxed);
    if(const char* const name = m_name_of_steps.load(std::memory_order_relaxed))
      text += ", " + figure(m_steps) + (m_expected_steps > 0 ? " of " + figure(m_expected_steps) : "") + ' ' + name;
    if(m_expected_curves.load(std::memory_order_relaxed) > 0)
      text += ", " + figure(m_curves) + " of " + figure(m_expected_curves) + " curves";
    if(m_flips.load(std::memory_order_relaxed) > 0)
      text += ", " + figure(m_flips) + " flips";
    return text + ", " + std::to_string(static_cast<long long>(m_stopwatch.seconds())) + " s" + remainder();
  }

private:
  // The share that is done and the time left if that goes on as before: of all curves, or of what began last.
  std::string remainder() const
  {
    const auto quotient = [](const std::atomic<std::size_t>& part, const std::atomic<std::size_t>& whole) {
      return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
    };
    const bool are_curves = m_expected_curves > 1;
    const double share = are_curves ? quotient(m_curves, m_expected_curves) : quotient(m_steps, m_expected_steps);
    if(!(share > 0 && share < 1))
      return "";
    const double passed = m_stopwatch.seconds() - (are_curves ? m_curves_start : m_phase_start);
    return ", " + std::to_string(std::lround(100 * share)) + " %, about " +
           std::to_string(std::lround(passed * (1 - share) / share)) + " s left";
  }

  Stopwatch m_stopwatch;
  mutable std::mutex m_phase_mutex;
  std::atomic<const char*> m_phase = "starting", m_name_of_steps = nullptr;
  std::atomic<std::size_t> m_steps = 0, m_expected_steps = 0, m_expected_curves = 0, m_curves = 0, m_flips = 0;
  std::atomic<double> m_phase_start = 0, m_curves_start = 0;
};

/// Passes flips and steps on to the progress, some at a time.
class Progress_visitor : public CGAL::Flip_geodesics::Default_shortening_visitor
{
public:
  explicit Progress_visitor(Progress& progress)
    : m_progress(progress)
  {
  }
  Progress_visitor(const Progress_visitor&) = delete;
  Progress_visitor& operator=(const Progress_visitor&) = delete;
  ~Progress_visitor()
  {
    m_progress.add_flips(m_flips);
    m_progress.add_steps(m_steps);
  }

  template <class Triangulation>
  void on_flip(const Triangulation&, CGAL::Flip_geodesics::Halfedge_index)
  {
    if(++m_flips == Progress::portion) {
      m_progress.add_flips(m_flips);
      m_flips = 0;
    }
  }

  /// Called before each step, which it counts.
  bool go_further()
  {
    if(++m_steps == Progress::portion) {
      m_progress.add_steps(m_steps);
      m_steps = 0;
    }
    return true;
  }

private:
  Progress& m_progress;
  std::size_t m_flips = 0, m_steps = 0;
};

/// Passes on the share of the expected steps that is done.
class Share_visitor : public CGAL::Flip_geodesics::Default_shortening_visitor
{
public:
  explicit Share_visitor(Progress& progress)
    : m_progress(progress)
  {
  }

  void on_progress(double share) { m_progress.set_share(share); }

private:
  Progress& m_progress;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRESS_H
