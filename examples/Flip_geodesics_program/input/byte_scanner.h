// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_BYTE_SCANNER_H
#define CGAL_FLIP_GEODESICS_PROGRAM_BYTE_SCANNER_H

#include "input/text_scanner.h"

#include <boost/endian/conversion.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace program {

/// Goes through the binary part of a file and keeps the position for messages.
class Byte_scanner
{
public:
  Byte_scanner(const Input_text& input, std::size_t position, boost::endian::order order)
    : m_input(input)
    , m_at(position)
    , m_order(order)
  {
  }

  bool is_at_end() const { return bytes_left() == 0; }
  std::size_t bytes_left() const { return m_input.bytes().size() - m_at; }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw Bad_input(m_input.name() + " byte " + std::to_string(m_at) + ": " + what);
  }
  [[noreturn]] void fail(const Element& element, const std::string& what) const
  {
    fail(element.kind + (' ' + std::to_string(element.index)) + ' ' + what);
  }

  void skip(std::size_t bytes, const Element& element)
  {
    if(bytes > bytes_left())
      fail(element, "is cut off; complete it");
    m_at += bytes;
  }

  /// The next number of an element. \throws Bad_input
  template <class T>
  T get(const Element& element)
  {
    using Bits =
        std::conditional_t<sizeof(T) == 8, std::uint64_t,
                           std::conditional_t<sizeof(T) == 4, std::uint32_t,
                                              std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;
    const std::size_t start = m_at;
    skip(sizeof(T), element);
    Bits bits = 0;
    std::memcpy(&bits, &m_input.bytes()[start], sizeof bits);
    boost::endian::conditional_reverse_inplace(bits, m_order, boost::endian::order::native);
    T value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  /// The next coordinate. \throws Bad_input if it is not finite, and has to be
  template <class T>
  double coordinate(const Element& element)
  {
    const T value = get<T>(element);
    if(!std::isfinite(value) && !m_input.may_have_points_not_finite())
      fail(element, "has a coordinate that is not a finite number; correct it");
    return static_cast<double>(value);
  }

private:
  const Input_text& m_input;
  std::size_t m_at;
  boost::endian::order m_order;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_BYTE_SCANNER_H
