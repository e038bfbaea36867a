// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_RUN_FILES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_RUN_FILES_H

#include "decimal_numbers.h"
#include "file_name.h"
#include "messages.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <system_error>

namespace program {

/// Where what is written to a name ends up: behind symbolic links, also if there is nothing yet.
inline std::filesystem::path destination(std::filesystem::path name)
{
  std::error_code failure;
  for(int links = 0; links < 40 && std::filesystem::is_symlink(name, failure); ++links) {
    const std::filesystem::path target = std::filesystem::read_symlink(name, failure);
    if(failure)
      break;
    name = target.is_absolute() ? target : name.parent_path() / target;
  }
  const std::filesystem::path place = std::filesystem::weakly_canonical(std::filesystem::absolute(name), failure);
  return failure ? name : place;
}

/// The number of the open file that the name of a result stands for: 1, standard output, for `-` and `/dev/stdout`.
/// Nothing if the name is that of a file.
inline std::optional<int> open_file(const std::string& name)
{
  if(name == standard_stream || name == "/dev/stdout")
    return 1;
  if(name == "/dev/stderr")
    return 2;
  for(const std::string folder : {"/dev/fd/", "/proc/self/fd/"})
    if(int number = 0; name.rfind(folder, 0) == 0 && parse_number(name.substr(folder.size()), number) == nullptr)
      return number;
  return std::nullopt;
}

inline bool is_standard_output(const std::string& name) { return open_file(name) == 1; }

/// What a result is called in messages.
inline std::string name_of_result(const std::string& name)
{
  return is_standard_output(name) ? "standard output" : printable(name);
}

/// Returns why the last write to a file has failed, and what to do. \pre no other call has set `errno` since
inline const char* reason_of_failed_write()
{
  return errno == EPIPE ? "could not be written completely; the receiving program has terminated"
                        : "could not be written completely; check the free space on the disk";
}

/// Do two names stand for one file, whether it exists or not?
inline bool is_same_file(const std::string& a, const std::string& b)
{
  if(open_file(a) || open_file(b))
    return open_file(a) == open_file(b);
  std::error_code failure;
  if(std::filesystem::exists(a, failure) && std::filesystem::exists(b, failure))
    return std::filesystem::equivalent(a, b, failure);
  return destination(a) == destination(b);
}

inline bool is_plain_file(const std::string& name)
{
  std::error_code failure;
  return std::filesystem::is_regular_file(name, failure);
}

/// Returns whether something exists that is not a plain file, such as a pipe or a device.
inline bool is_special_file(const std::string& name)
{
  std::error_code failure;
  return std::filesystem::exists(name, failure) && !is_plain_file(name);
}

/*!
 * The files that this run has not completed, so that whoever ends it early removes them, and whether one could not be.
 * For several threads.
 */
class Run_files
{
public:
  static Run_files& instance()
  {
    static Run_files files;
    return files;
  }

  /// Creates an empty file that nobody else has, in the folder of `place`. Returns an empty path if that fails.
  std::filesystem::path create_beside(const std::filesystem::path& place)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    for(int attempts = 0; attempts < 100; ++attempts) {
      char ending[40];
      std::snprintf(ending, sizeof ending, ".%08x%08x.part", m_random(), m_random());
      constexpr std::size_t longest = 200; // together less than file systems allow
      const std::filesystem::path part = place.parent_path() / (place.filename().string().substr(0, longest) + ending);
      if(std::FILE* const file = std::fopen(part.string().c_str(), "wbx")) { // x: fails if it exists
        std::fclose(file);
        m_parts.insert(part);
        return part;
      }
    }
    return {};
  }

  /// Puts a file that is complete in its place.
  bool complete(const std::filesystem::path& part, const std::filesystem::path& place)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    std::error_code failure;
    std::filesystem::rename(part, place, failure);
    if(!failure)
      m_parts.erase(part);
    return !failure;
  }

  void remove(const std::filesystem::path& part)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    m_parts.erase(part);
  }

  /// Removes all of them before the process ends: none is created or completed after that.
  void remove_all_for_good()
  {
    m_mutex.lock();
    std::error_code ignored;
    for(const std::filesystem::path& part : m_parts)
      std::filesystem::remove(part, ignored);
  }

  void note_failure()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_has_failed = true;
  }

  /// Is there a file that could not be written to its end?
  bool has_failed() const
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_has_failed;
  }

private:
  Run_files() = default;

  mutable std::mutex m_mutex;
  std::random_device m_random;
  std::set<std::filesystem::path> m_parts;
  bool m_has_failed = false;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_RUN_FILES_H
