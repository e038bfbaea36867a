// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_INPUT_TEXT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_INPUT_TEXT_H

#include "bad_input.h"
#include "printable.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

// The files that the program reads are read whole; what is in them is looked at afterwards.
namespace program {

class Input_text
{
public:
  Input_text(const std::string& file, std::string bytes)
    : m_file(file)
    , m_name(printable(file))
    , m_bytes(std::move(bytes))
  {
  }

  /// As the user has named it.
  const std::string& file() const { return m_file; }

  /// The name of the file for messages.
  const std::string& name() const { return m_name; }

  const std::string& bytes() const { return m_bytes; }

  /// May a mesh have points that are not finite, with which somebody else deals?
  bool may_have_points_not_finite() const { return m_may_have_points_not_finite; }
  void allow_points_not_finite() { m_may_have_points_not_finite = true; }

private:
  std::string m_file, m_name, m_bytes;
  bool m_may_have_points_not_finite = false;
};

/// Reads a file, or what comes out of a pipe. \throws Bad_input also if it is empty
inline Input_text read_text(const std::string& file)
{
  constexpr std::size_t block = std::size_t(1) << 16, most_from_pipe = std::size_t(1) << 30;
  const std::string name = printable(file);
  std::string bytes;
  std::error_code no_matter;
  const auto type = std::filesystem::status(file, no_matter).type();
  std::ifstream in(file, std::ios::binary);
  if(type == std::filesystem::file_type::directory)
    throw Bad_input(name + ": is a folder; name a file in it");
  if(!in)
    throw Bad_input(name + ": cannot be opened; check the path and its permissions");
  if(type == std::filesystem::file_type::regular)
    bytes.reserve(static_cast<std::size_t>(std::filesystem::file_size(file, no_matter)) + 1);
  for(std::streamsize read = 1; read > 0;) {
    const std::size_t size = bytes.size();
    bytes.resize(size + block);
    read = in.read(&bytes[size], block).gcount();
    bytes.resize(size + static_cast<std::size_t>(read));
    if(type != std::filesystem::file_type::regular && bytes.size() > most_from_pipe)
      throw Bad_input(name + ": there is no end to it; give a file");
  }
  if(in.bad())
    throw Bad_input(name + ": cannot be read to its end; check the disk");
  if(bytes.empty())
    throw Bad_input(name + ": the file is empty; check the path");
  return Input_text(file, std::move(bytes));
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_INPUT_TEXT_H
