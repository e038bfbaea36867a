// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_WATCHER_H
#define CGAL_FLIP_GEODESICS_PROGRAM_WATCHER_H

#include "output/run_files.h"
#include "run/progress.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>

#if defined(__unix__) || defined(__APPLE__)
#define FLIP_GEODESICS_HAS_POSIX_SIGNALS
#include <fcntl.h>
#endif

namespace program {

/*!
 * Looks after a run from a thread of its own while it lives: prints on standard error, every two seconds, how far it
 * has come, nothing about a shorter run; and ends it when it is interrupted, without leaving a temporary file.
 *
 * Signals that were ignored when the program was started stay so. There may be one watcher at a time.
 */
class Watcher
{
public:
  /// \param is_quiet whether it prints nothing
  Watcher(const Progress& progress, bool is_quiet)
    : m_progress(progress)
    , m_is_quiet(is_quiet)
  {
    keep_standard_streams();
    end_at(SIGINT);
    end_at(SIGTERM);
#ifdef FLIP_GEODESICS_HAS_POSIX_SIGNALS
    end_at(SIGHUP);
    std::signal(SIGPIPE, SIG_IGN); // what cannot be written is an error of that file
    std::signal(SIGXFSZ, SIG_IGN);
#endif
    m_thread = std::thread([this] { watch(); });
  }
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;
  ~Watcher()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_over = true;
    }
    m_changed.notify_one();
    m_thread.join();
  }

private:
  // A handler may do little more than set it; the thread looks at it.
  static std::atomic<int>& signal_number()
  {
    static std::atomic<int> number = 0;
    return number;
  }

  static void end_at(int signal)
  {
    static_assert(std::atomic<int>::is_always_lock_free, "a signal handler must be able to store an int atomically");
    signal_number() = 0; // made before a handler can run
    if(std::signal(signal, [](int number) { signal_number() = number; }) == SIG_IGN)
      std::signal(signal, SIG_IGN);
  }

  // A result must not become standard output or error because they were closed.
  static void keep_standard_streams()
  {
#ifdef FLIP_GEODESICS_HAS_POSIX_SIGNALS
    for(int stream = 0; stream < 3; ++stream)
      if(fcntl(stream, F_GETFD) == -1 && open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY) == -1)
        return;
#endif
  }

  void watch()
  {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds period(2000), reaction(50);
    Clock::time_point next = Clock::now() + period;
    std::unique_lock<std::mutex> lock(m_mutex);
    while(!m_changed.wait_for(lock, reaction, [this] { return m_is_over; })) {
      if(signal_number() != 0)
        end_run(signal_number());
      if(m_is_quiet || Clock::now() < next)
        continue;
      next += period;
      print(m_progress.line());
    }
  }

  [[noreturn]] static void end_run(int signal)
  {
    Run_files::instance().remove_all_for_good();
    print("interrupted; unfinished files were removed");
    std::_Exit(128 + signal);
  }

  // Past std::cerr, which is another thread's to redirect.
  static void print(const std::string& text) { std::fputs(("flip_geodesics: " + text + '\n').c_str(), stderr); }

  const Progress& m_progress;
  bool m_is_quiet;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  bool m_is_over = false;
  std::thread m_thread;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_WATCHER_H
