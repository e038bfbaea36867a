// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PAGE_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PAGE_FILE_H

#include "output/json_text.h"
#include "output/output_file.h"

#include <cstddef>
#include <cstdint>
#include <new>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>
#include <zlib.h>

// Pages for a browser, and the arrays in them.
namespace program {

/*
 * Each number less the one three before, which is the same coordinate of the point before, or the same corner of the
 * face before; then all lowest bytes, all second ones, and so on. That makes what deflate finds: long runs of few
 * values. Arithmetic is modulo 2^32.
 */
inline std::string differences_by_bytes(const std::vector<std::uint32_t>& numbers)
{
  const std::size_t count = numbers.size();
  std::string bytes(4 * count, '\0');
  for(std::size_t i = 0; i < count; ++i) {
    const std::uint32_t difference = numbers[i] - (i < 3 ? 0 : numbers[i - 3]);
    for(std::size_t k = 0; k < 4; ++k)
      bytes[k * count + i] = static_cast<char>(difference >> (8 * k) & 0xff);
  }
  return bytes;
}

/// Bytes in the format of zlib [RFC 1950].
inline std::string deflated(const std::string& bytes)
{
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  const int status = compress(reinterpret_cast<Bytef*>(&result[0]), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                              static_cast<uLong>(bytes.size()));
  if(status != Z_OK)
    throw std::bad_alloc(); // the only possible reason
  result.resize(size);
  return result;
}

/// An array as a JSON object `{"packed": text}`, the text being base 64 of what is deflated; short ones as plain base
/// 64.
inline std::string json_packed(const std::vector<std::uint32_t>& numbers)
{
  constexpr std::size_t shortest = 64;
  if(numbers.size() < shortest)
    return json_base64(numbers);
  return "{\"packed\":" + json_base64(deflated(differences_by_bytes(numbers))) + '}';
}

/*!
 * Writes one page for a browser, with everything in it: no other file and no network is needed. The page is a fixed one
 * (folder page/), in which a JSON object takes the place of a mark.
 *
 * \param page the pieces of the page \param write_object writes the object to a stream
 */
template <class Page, class Write>
void write_page(Output_file& file, const Page& page, const Write& write_object)
{
  file.write([&](std::ostream& out) {
    for(std::string_view piece : page) {
      if(piece == "@SCENE@")
        write_object(out);
      else
        out << piece;
    }
  });
  file.close();
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PAGE_FILE_H
