// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_JSON_TEXT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_JSON_TEXT_H

#include "decimal_numbers.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/endian/conversion.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

// Pieces of JSON, and arrays of numbers in bytes, as the formats for browsers want them.
namespace program {

/// A JSON string with its quotes. It may stand inside an HTML script element: `<` is escaped.
inline std::string json_string(const std::string& text)
{
  std::string result = "\"";
  for(unsigned char c : text) {
    if(c == '"' || c == '\\') {
      result += '\\';
      result += static_cast<char>(c);
    } else if(c < 0x20 || c == '<') {
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\u%04x", c);
      result += escaped;
    } else {
      result += static_cast<char>(c);
    }
  }
  return result + '"';
}

/// A JSON number with all digits, whatever the locale; `null` if it is none.
inline std::string json_number(double x) { return std::isfinite(x) ? decimal_text(x) : "null"; }

inline std::string json(const std::string& text) { return json_string(text); }
inline std::string json(const char* text) { return json_string(text); }
inline std::string json(double x) { return json_number(x); }
inline std::string json(bool value) { return value ? "true" : "false"; }
inline std::string json(std::size_t number) { return std::to_string(number); }

/// A JSON array. \param separator what stands between its items beside a comma, and in front of the first one
template <class Item>
std::string json(const std::vector<Item>& items, const char* separator = "")
{
  std::string text;
  for(const Item& item : items)
    text += (text.empty() ? "" : ",") + (separator + json(item));
  return '[' + text + ']';
}

/// Members of a JSON object, given by names and values.
template <class Value, class... Others>
std::string json_members(const char* name, const Value& value, const Others&... others)
{
  const std::string text = json_string(name) + ':' + json(value);
  if constexpr(sizeof...(Others) == 0)
    return text;
  else
    return text + ',' + json_members(others...);
}

/// Appends a number of four bytes, the lowest first.
template <class Number>
void append_bytes(std::string& bytes, Number x)
{
  static_assert(sizeof(Number) == 4, "the output formats store 32-bit numbers");
  std::uint32_t bits;
  std::memcpy(&bits, &x, 4);
  boost::endian::native_to_little_inplace(bits);
  char piece[4];
  std::memcpy(piece, &bits, 4);
  bytes.append(piece, 4);
}

/// The bytes of an array of `float` or `std::uint32_t`.
template <class Number>
std::string to_bytes(const std::vector<Number>& numbers)
{
  std::string bytes;
  bytes.reserve(4 * numbers.size());
  for(Number x : numbers)
    append_bytes(bytes, x);
  return bytes;
}

/// Bytes as a JSON string in base 64.
inline std::string json_base64(std::string bytes)
{
  using namespace boost::archive::iterators;
  using Encoder = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  bytes.append(missing, '\0');
  std::string text(Encoder(bytes.cbegin()), Encoder(bytes.cend()));
  text.replace(text.size() - missing, missing, missing, '=');
  return '"' + text + '"';
}

/// An array as a JSON string in base 64.
template <class Number>
std::string json_base64(const std::vector<Number>& numbers)
{
  return json_base64(to_bytes(numbers));
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_JSON_TEXT_H
