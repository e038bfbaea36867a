// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_INPUT_TEXT_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_INPUT_TEXT_H

#include "bad_input.h"
#include "printable.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

// The files that the program reads are read whole; what is in them is looked at afterwards.
namespace program {

struct Input_text
{
  std::string file;  ///< as the user has named it
  std::string bytes; ///< what is in it

  /// The name of the file for messages.
  std::string name() const { return printable(file); }
};

/// Reads a file, or what comes out of a pipe. \throws Bad_input also if it is empty
inline Input_text read_text(const std::string& file)
{
  constexpr std::size_t block = std::size_t(1) << 16, most_from_pipe = std::size_t(1) << 30;
  Input_text text = {file, {}};
  std::error_code no_matter;
  const auto type = std::filesystem::status(file, no_matter).type();
  std::ifstream in(file, std::ios::binary);
  if(!in || type == std::filesystem::file_type::directory)
    throw Bad_input(text.name() + ": cannot be opened; check the path and its permissions");
  if(type == std::filesystem::file_type::regular)
    text.bytes.reserve(static_cast<std::size_t>(std::filesystem::file_size(file, no_matter)) + 1);
  for(std::streamsize read = 1; read > 0;) {
    const std::size_t size = text.bytes.size();
    text.bytes.resize(size + block);
    read = in.read(&text.bytes[size], block).gcount();
    text.bytes.resize(size + static_cast<std::size_t>(read));
    if(type != std::filesystem::file_type::regular && text.bytes.size() > most_from_pipe)
      throw Bad_input(text.name() + ": there is no end to it; give a file");
  }
  if(in.bad())
    throw Bad_input(text.name() + ": cannot be read to its end; check the disk");
  if(text.bytes.empty())
    throw Bad_input(text.name() + ": the file is empty; check the path");
  return text;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_INPUT_TEXT_H
