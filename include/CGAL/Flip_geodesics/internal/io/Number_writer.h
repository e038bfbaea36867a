// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_IO_NUMBER_WRITER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_IO_NUMBER_WRITER_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Writes the bytes of a number, the lowest first, whatever the order of the machine is. */
template <class Number>
void write_bytes(std::ostream& out, Number x)
{
  static_assert(std::is_integral<Number>::value || std::numeric_limits<Number>::is_iec559, "files have IEEE numbers");
  using Wide = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  using Bits = std::conditional_t<sizeof(Number) == 1, std::uint8_t, Wide>;
  static_assert(sizeof(Bits) == sizeof(Number), "numbers have 8, 32 or 64 bits");
  Bits bits;
  std::memcpy(&bits, &x, sizeof bits);
  char bytes[sizeof bits];
  for(std::size_t i = 0; i < sizeof bits; ++i)
    bytes[i] = static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
  out.write(bytes, sizeof bytes);
}

/* Writes numbers as text, each with what comes after it, or as bytes. */
class Number_writer
{
public:
  Number_writer(std::ostream& out, bool is_binary)
    : m_out(&out)
    , m_is_binary(is_binary)
  {
  }

  template <class Number>
  void operator()(Number x, const char* after) const
  {
    if(m_is_binary)
      write_bytes(*m_out, x);
    else
      *m_out << +x << after; // plus, since a number of one byte is no character
  }

private:
  std::ostream* m_out;
  bool m_is_binary;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_IO_NUMBER_WRITER_H
