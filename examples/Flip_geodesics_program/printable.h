// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PRINTABLE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PRINTABLE_H

#include <boost/locale/utf.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace program {

/// Does a code point only steer a terminal, or change how text around it is shown?
inline bool is_control(boost::locale::utf::code_point c)
{
  const auto is_in = [c](boost::locale::utf::code_point first, boost::locale::utf::code_point last) {
    return c >= first && c <= last;
  };
  return c < 0x20 || is_in(0x7f, 0x9f) || is_in(0x200b, 0x200f) || is_in(0x2028, 0x202e) || is_in(0x2060, 0x206f) ||
         c == 0xfeff || is_in(0xfff0, 0xfffb) || is_in(0xe0000, 0xe0fff);
}

/// A text as UTF-8 on one line, with question marks for control characters and for bytes that are no UTF-8. It is not
/// longer than the text.
inline std::string without_controls(std::string_view text)
{
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::string result;
  for(const char *at = text.data(), *end = at + text.size(); at != end;) {
    const char* const start = at;
    const auto c = Utf8::decode(at, end);
    const bool is_valid = boost::locale::utf::is_valid_codepoint(c);
    if(!is_valid)
      at = start + 1;
    if(is_valid && !is_control(c))
      result.append(start, at);
    else
      result += '?';
  }
  return result;
}

/// What a user's bytes look like in a message: `without_controls()`, and cut in the middle to not much more than `most`
/// bytes.
inline std::string printable(std::string_view text, std::size_t most = 120)
{
  if(text.size() <= most)
    return without_controls(text);
  const auto is_inside_character = [&](std::size_t i) {
    return i > 0 && i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80;
  };
  const auto to_boundary = [&](std::size_t i) {
    for(int step = 0; step < 3 && is_inside_character(i); ++step)
      --i;
    return i;
  };
  const std::size_t end = to_boundary(most - most / 3), start = to_boundary(text.size() - most / 3);
  return without_controls(text.substr(0, end)) + "..." + without_controls(text.substr(start));
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PRINTABLE_H
