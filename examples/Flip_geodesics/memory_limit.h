// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_MEMORY_LIMIT_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_MEMORY_LIMIT_H

#include <cstddef>
#include <fstream>

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#define FLIP_GEODESICS_HAS_MEMORY_LIMIT
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace program {

/*
 * While it lives, the process gets so much memory more and then std::bad_alloc. CGAL's readers make room for as many
 * elements as a file announces: a broken file of 100 bytes could otherwise bring a machine to a standstill.
 *
 * Does nothing but on Linux, nor under the address sanitizer, which reserves terabytes.
 */
class Memory_limit
{
public:
#ifdef FLIP_GEODESICS_HAS_MEMORY_LIMIT
  explicit Memory_limit(std::size_t additional_bytes)
  {
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    getrlimit(RLIMIT_AS, &m_before);
    rlimit limited = m_before;
    const rlim_t wanted = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + additional_bytes;
    if(pages > 0 && wanted < m_before.rlim_cur)
      limited.rlim_cur = wanted;
    setrlimit(RLIMIT_AS, &limited);
  }
  ~Memory_limit() { setrlimit(RLIMIT_AS, &m_before); }
#else
  explicit Memory_limit(std::size_t) {}
#endif
  Memory_limit(const Memory_limit&) = delete;
  Memory_limit& operator=(const Memory_limit&) = delete;

#ifdef FLIP_GEODESICS_HAS_MEMORY_LIMIT
private:
  rlimit m_before;
#endif
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_MEMORY_LIMIT_H
