// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_FILE_NAME_H
#define CGAL_FLIP_GEODESICS_PROGRAM_FILE_NAME_H

#include <algorithm>
#include <cctype>
#include <string>

namespace program {

/// The name of standard input where a file is read, and of standard output where one is written.
constexpr const char* standard_stream = "-";

/// A text in lower case.
inline std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The extension of a file name in lower case, without the dot.
inline std::string extension(const std::string& file)
{
  const std::size_t dot = file.find_last_of("./\\");
  return dot == std::string::npos || file[dot] != '.' ? "" : lower_case(file.substr(dot + 1));
}

/// Is it the name of a file of polylines in space?
inline bool is_name_of_polylines(const std::string& file)
{
  const std::string ending = ".polylines.txt";
  return file.size() > ending.size() && file.compare(file.size() - ending.size(), ending.size(), ending) == 0;
}

/// The name of a format as users write it: an extension, with or without the dot.
inline std::string format_name(const std::string& text)
{
  const std::string name = lower_case(text.substr(text.find_first_not_of('.') == 1 ? 1 : 0));
  return name == "polylines.txt" ? "polylines" : name;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_FILE_NAME_H
