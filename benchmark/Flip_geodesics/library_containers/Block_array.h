// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_BLOCK_ARRAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_BLOCK_ARRAY_H

#include <boost/container/deque.hpp>
#include <boost/container/options.hpp>

#include <cstddef>
#include <utility>

namespace CGAL::Flip_geodesics::internal {

/* A deque of Boost with blocks of the same size. */
template <class T>
class Block_array
{
  using Options = typename boost::container::deque_options<boost::container::block_size<512u>>::type;

public:
  std::size_t size() const { return m_records.size(); }
  bool empty() const { return m_records.empty(); }
  T& operator[](std::size_t i) { return m_records[i]; }
  const T& operator[](std::size_t i) const { return m_records[i]; }
  T& back() { return m_records.back(); }
  const T& back() const { return m_records.back(); }
  void push_back(T&& record) { m_records.push_back(std::move(record)); }
  void pop_back() { m_records.pop_back(); }
  void resize(std::size_t size, const T& record) { m_records.resize(size, record); }
  std::size_t memory() const { return size() * sizeof(T); }

private:
  boost::container::deque<T, void, Options> m_records;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_BLOCK_ARRAY_H
