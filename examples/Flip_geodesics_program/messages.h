// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_MESSAGES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_MESSAGES_H

#include <CGAL/Flip_geodesics/exceptions.h>

#include <boost/locale/utf.hpp>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

// Errors of the user, and how the program writes text, counts and times.
namespace program {

/// Input that the program cannot use; the message is one line with the position, the problem, and what to do.
class Bad_input : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Does a code point only steer a terminal, or change how text around it is shown?
inline bool is_control(boost::locale::utf::code_point c)
{
  const auto is_in = [c](boost::locale::utf::code_point first, boost::locale::utf::code_point last) {
    return c >= first && c <= last;
  };
  return c < 0x20 || is_in(0x7f, 0x9f) || is_in(0x200b, 0x200f) || is_in(0x2028, 0x202e) || is_in(0x2060, 0x206f) ||
         c == 0xfeff || is_in(0xfff0, 0xfffb) || is_in(0xe0000, 0xe0fff);
}

/// A text as UTF-8 on one line, with question marks for control characters and for bytes that are not UTF-8. It is not
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

/// A count, from 10 000 on with a space before each three digits.
inline std::string readable(std::size_t count)
{
  std::string text = std::to_string(count);
  if(text.size() > 4)
    for(std::size_t i = text.size() - 3; i > 0 && i < text.size(); i -= 3)
      text.insert(i, 1, ' ');
  return text;
}

/// A count and what is counted.
inline std::string counted(std::size_t count, const char* one, const char* many)
{
  return readable(count) + ' ' + (count == 1 ? one : many);
}

/// A time in seconds, as milliseconds if it is short, with three digits that count.
inline std::string readable_time(double seconds)
{
  const bool is_short = seconds < 1;
  const double value = is_short ? 1e3 * seconds : seconds;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f %s",
                value < 1     ? 3
                : value < 10  ? 2
                : value < 100 ? 1
                              : 0,
                value, is_short ? "ms" : "s");
  return text;
}

/// Returns the message of an error; of a degenerate edge with other advice than the library's, which names its classes,
/// and of ends in different components with advice on gaps.
inline std::string with_advice(const std::exception& error, const std::string& advice)
{
  namespace FG = CGAL::Flip_geodesics;
  if(dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "there is not enough memory";
  if(dynamic_cast<const FG::Disconnected_endpoints_error*>(&error) != nullptr)
    return std::string(error.what()) +
           "; the command `info` lists the components, and --repair with --weld TOLERANCE joins borders that nearly "
           "coincide";
  const auto* const degenerate = dynamic_cast<const FG::Degenerate_face_error*>(&error);
  if(degenerate == nullptr || degenerate->remedy() == FG::Degeneracy_remedy::NONE)
    return error.what();
  return degenerate->problem() + "; " + advice;
}

/// Returns the message of an error where neither contraction nor `--mollify` is available.
inline std::string with_advice_to_repair(const std::exception& error)
{
  return with_advice(error, "use --repair, which removes such edges");
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_MESSAGES_H
