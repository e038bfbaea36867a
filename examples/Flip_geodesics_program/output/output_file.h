// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_OUTPUT_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_OUTPUT_FILE_H

#include "messages.h"
#include "output/run_files.h"

#include <CGAL/Flip_geodesics/exceptions.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>

namespace program {

/*!
 * A file that is written with all digits of a double, and that complains if it cannot be.
 *
 * What is written goes to a file of its own beside it first, which takes its place, with its permissions, in `close()`:
 * a run that fails leaves the results of an earlier one, and two runs do not mix theirs. What is not a plain file is
 * written directly, and so is a file that is open already, as standard output is: behind what it holds.
 */
class Output_file
{
public:
  /// With an empty name, nothing is written. \throws Bad_input if it cannot be begun
  explicit Output_file(const std::string& name)
    : m_name(name)
  {
    if(m_name.empty())
      return;
    std::error_code failure;
    const std::filesystem::file_status status = std::filesystem::status(m_name, failure); // of what a link leads to
    const bool exists = std::filesystem::exists(status);
    m_is_direct = open_file(m_name).has_value() || (exists && !std::filesystem::is_regular_file(status));
    m_place = m_is_direct ? std::filesystem::path(m_name) : destination(m_name);
    const bool may_be_written = !exists || m_is_direct || std::ofstream(m_place, std::ios::app).is_open();
    if(may_be_written && !m_is_direct)
      m_part = Run_files::instance().create_beside(m_place);
    if(exists && !m_part.empty())
      std::filesystem::permissions(m_part, status.permissions(), failure);
    open();
    m_out.precision(std::numeric_limits<double>::max_digits10);
    if(!m_out || !may_be_written) {
      abandon();
      throw Bad_input(printable(m_name) + ": " + obstacle());
    }
    m_is_open = true;
  }
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;
  ~Output_file() { abandon(); }

  bool is_wanted() const { return !m_name.empty(); }
  std::ostream& stream() { return m_out; }
  const std::string& name() const { return m_name; }

  /// Calls `write(stream())`, and reports an error of the library, which cannot do so itself.
  template <class Write>
  void write(const Write& write)
  {
    if(!is_wanted())
      return;
    try {
      write(m_out);
    } catch(const CGAL::Flip_geodesics::Error& error) {
      if(m_out)
        fail(error.what());
      else
        check();
    }
  }

  /// Looks whether all could be written so far. If not, reports it once and ignores further output.
  void check()
  {
    if(m_is_open && !m_out)
      fail(reason_of_failed_write());
  }

  /// Completes the file, or reports that this is not possible.
  void close()
  {
    if(!m_is_open)
      return;
    if(!finish() || (!m_is_direct && !Run_files::instance().complete(m_part, m_place)))
      return fail(reason_of_failed_write());
    m_is_open = false;
    m_part.clear();
  }

private:
  // Standard streams are those of the program: another description of an open file has a position of its own, and
  // would overwrite what the program prints.
  void open()
  {
    const std::optional<int> number = open_file(m_name);
    if(number == 1)
      m_out.rdbuf(std::cout.rdbuf());
    else if(number == 2)
      m_out.rdbuf(std::cerr.rdbuf());
    else if(m_buffer.open(m_is_direct ? m_place : m_part,
                          std::ios::out | std::ios::binary | (m_is_direct ? std::ios::app : std::ios::trunc)))
      m_out.rdbuf(&m_buffer);
  }

  // Writes what is left. Returns whether all could be written.
  bool finish()
  {
    m_out.flush();
    return (!m_buffer.is_open() || m_buffer.close() != nullptr) && m_out;
  }

  // What stands in the way of a file, and what to do.
  std::string obstacle() const
  {
    std::error_code failure;
    const std::filesystem::path folder = m_place.parent_path();
    if(std::filesystem::is_directory(m_place, failure))
      return "is a folder; specify a file";
    if(!folder.empty() && !std::filesystem::exists(folder, failure))
      return "the folder " + printable(folder.string()) + " does not exist; create it, or choose another path";
    return "cannot be written; choose another path";
  }

  void fail(const std::string& reason)
  {
    abandon();
    Run_files::instance().note_failure();
    std::cerr << "flip_geodesics: " + name_of_result(m_name) + ": " + reason + '\n';
  }

  // Leaves what was there before.
  void abandon()
  {
    m_is_open = false;
    if(m_part.empty())
      return;
    m_buffer.close();
    m_out.setstate(std::ios::badbit);
    Run_files::instance().remove(m_part);
    m_part.clear();
  }

  std::string m_name;
  std::filesystem::path m_place, m_part; // the latter empty if there is none
  std::filebuf m_buffer;
  std::ostream m_out{nullptr}; // to the buffer or to a standard stream
  bool m_is_direct = false, m_is_open = false;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_OUTPUT_FILE_H
