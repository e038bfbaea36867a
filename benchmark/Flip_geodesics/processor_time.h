// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_BENCHMARK_PROCESSOR_TIME_H
#define FLIP_GEODESICS_BENCHMARK_PROCESSOR_TIME_H

#include <ctime>

/// The seconds that this thread has computed, without those in which the processor was given to others: on a busy
/// machine, a clock on the wall makes long runs longer but leaves short ones as they are.
inline double processor_seconds()
{
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// How long a call takes.
template <class Function>
double seconds(const Function& function)
{
  const double start = processor_seconds();
  function();
  return processor_seconds() - start;
}

#endif // FLIP_GEODESICS_BENCHMARK_PROCESSOR_TIME_H
