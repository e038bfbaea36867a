// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SCRATCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SCRATCH_H

#include <cstddef>
#include <memory>
#include <memory_resource>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A monotonic buffer of the standard library. */
template <class T>
class Scratch
{
public:
  T* allocate(std::size_t size) { return static_cast<T*>(m_memory->allocate(size * sizeof(T), alignof(T))); }
  void release() { m_memory->release(); }

private:
  std::unique_ptr<std::pmr::monotonic_buffer_resource> m_memory{new std::pmr::monotonic_buffer_resource(1 << 14)};
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SCRATCH_H
