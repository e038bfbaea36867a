// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_INPUT_TEXT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_INPUT_TEXT_H

#include "file_name.h"
#include "messages.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

// The files that the program reads are read whole; what is in them is looked at afterwards.
namespace program {

/// What a file is called in messages.
inline std::string name_of_input(const std::string& file)
{
  return file == standard_stream ? "standard input" : printable(file);
}

/// The bytes of a file. Copies share them.
class Input_text
{
public:
  /// \param format an extension that stands for the format; empty for that of the file's name
  Input_text(const std::string& file, std::string bytes, const std::string& format = "")
    : m_file(file)
    , m_name(name_of_input(file))
    , m_format(format.empty() ? extension(file) : format)
    , m_bytes(std::make_shared<const std::string>(std::move(bytes)))
  {
  }

  /// As the user has named it.
  const std::string& file() const { return m_file; }

  /// The name of the file for messages.
  const std::string& name() const { return m_name; }

  /// The format as a lower-case extension without the dot.
  const std::string& format() const { return m_format; }

  const std::string& bytes() const { return *m_bytes; }

  /// May a mesh have points that are not finite, with which somebody else deals?
  bool may_have_points_not_finite() const { return m_may_have_points_not_finite; }
  void allow_points_not_finite() { m_may_have_points_not_finite = true; }

private:
  std::string m_file, m_name, m_format;
  std::shared_ptr<const std::string> m_bytes;
  bool m_may_have_points_not_finite = false;
};

/// Reads a stream to its end. \param expected the number of bytes if it is known, and else 0 \throws Bad_input
inline std::string read_bytes(std::istream& in, const std::string& name, std::size_t expected)
{
  constexpr std::size_t block = std::size_t(1) << 16, most_from_pipe = std::size_t(1) << 30;
  std::string bytes;
  bytes.reserve(expected + 1);
  for(std::streamsize read = 1; read > 0;) {
    const std::size_t size = bytes.size();
    bytes.resize(size + block);
    read = in.read(&bytes[size], block).gcount();
    bytes.resize(size + static_cast<std::size_t>(read));
    if(expected == 0 && bytes.size() > most_from_pipe)
      throw Bad_input(name + ": the input exceeds 1 GiB, the limit for a pipe; use a file");
  }
  if(in.bad())
    throw Bad_input(name + ": the input cannot be read to its end; check the disk");
  return bytes;
}

/// Reads a file, or a pipe, from where it is named. \throws Bad_input
inline std::string read_file(const std::string& file, const std::string& name)
{
  std::error_code no_matter;
  const auto type = std::filesystem::status(file, no_matter).type();
  if(type == std::filesystem::file_type::directory)
    throw Bad_input(name + ": is a folder; specify a file");
  std::ifstream in(file, std::ios::binary);
  if(!in)
    throw Bad_input(name + ": cannot be opened; check the path and its permissions");
  const bool is_plain = type == std::filesystem::file_type::regular;
  return read_bytes(in, name, is_plain ? static_cast<std::size_t>(std::filesystem::file_size(file, no_matter)) : 0);
}

/// Reads a file, a pipe, or standard input if the name is `-`. \throws Bad_input also if it is empty or compressed
inline Input_text read_text(const std::string& file, const std::string& format = "")
{
  const std::string name = name_of_input(file);
  std::string bytes = file == standard_stream ? read_bytes(std::cin, name, 0) : read_file(file, name);
  if(bytes.empty())
    throw Bad_input(name + (file == standard_stream ? ": the input is empty; check the program that writes it"
                                                    : ": the file is empty; check the path"));
  constexpr const char* mark_of_gzip = "\x1f\x8b";
  if(bytes.compare(0, 2, mark_of_gzip) == 0)
    throw Bad_input(name + ": the input is compressed with gzip; decompress it first");
  return Input_text(file, std::move(bytes), format);
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_INPUT_TEXT_H
