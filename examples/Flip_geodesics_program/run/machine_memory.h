// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_MACHINE_MEMORY_H
#define CGAL_FLIP_GEODESICS_PROGRAM_MACHINE_MEMORY_H

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace program {

/// The memory of the machine, in bytes; that of a large one if it cannot be queried.
inline double memory_of_machine()
{
#ifdef _SC_PHYS_PAGES
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if(pages > 0 && size > 0)
    return static_cast<double>(pages) * static_cast<double>(size);
#endif
  return 0x1p36;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_MACHINE_MEMORY_H
