// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_INTEGER_HASH_H
#define FLIP_GEODESICS_TEST_INTEGER_HASH_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <cstdint>
#include <cstdio>
#include <string>

namespace Flip_geodesics_test {

/// A hash of integers that is the same everywhere: FNV-1a, byte by byte.
class Integer_hash
{
public:
  void add(long long value)
  {
    for(int i = 0; i < 8; ++i)
      m_value = (m_value ^ ((static_cast<std::uint64_t>(value) >> (8 * i)) & 255)) * 1099511628211u;
  }

  template <class Element>
  void add(CGAL::Flip_geodesics::Descriptor<Element> d)
  {
    add(d.idx());
  }

  template <class Range>
  void add_all(const Range& values)
  {
    add(static_cast<long long>(values.size()));
    for(const auto& value : values)
      add(value);
  }

  void add_text(const std::string& text)
  {
    for(char c : text)
      add(static_cast<long long>(c));
  }

  std::string text() const
  {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(m_value));
    return digits;
  }

private:
  std::uint64_t m_value = 14695981039346656037u;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_INTEGER_HASH_H
