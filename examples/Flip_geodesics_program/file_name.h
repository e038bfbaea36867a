// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_FILE_NAME_H
#define CGAL_FLIP_GEODESICS_PROGRAM_FILE_NAME_H

#include <algorithm>
#include <cctype>
#include <string>

namespace program {

/// The extension of a file name in lower case, without the dot.
inline std::string extension(const std::string& file)
{
  const std::size_t dot = file.find_last_of("./\\");
  std::string result = dot == std::string::npos || file[dot] != '.' ? "" : file.substr(dot + 1);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_FILE_NAME_H
