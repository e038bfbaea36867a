// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_ADVICE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_ADVICE_H

#include <string>

namespace program {

/// What the library says of an edge of length zero, with other advice than the library's, which names its classes.
inline std::string with_advice(const std::string& text, const std::string& advice)
{
  for(const char* const mark : {"; contract such edges (", "; lengthen them ("})
    if(const std::size_t end = text.find(mark); end != std::string::npos)
      return text.substr(0, end) + "; " + advice;
  return text;
}

/// Where neither contraction nor `--mollify` is to be had.
inline std::string with_advice_to_repair(const std::string& text)
{
  return with_advice(text, "give --repair, which drops such edges");
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_ADVICE_H
