// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_READABLE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_READABLE_H

#include <cstddef>
#include <cstdio>
#include <string>

namespace program {

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

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_READABLE_H
