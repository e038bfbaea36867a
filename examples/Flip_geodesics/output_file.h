// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_OUTPUT_FILE_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_OUTPUT_FILE_H

#include "bad_input.h"
#include "printable.h"

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>

namespace program {

/*!
 * A file that is written with all digits of a double, and that complains if it cannot be.
 *
 * What is written goes to `NAME.part` first, which takes the place of the file in `close()`: a run that fails leaves the
 * results of an earlier one. What is no plain file, and anything in /dev, is written directly.
 */
class Output_file
{
public:
  /// An empty name means that nothing is to be written.
  explicit Output_file(const std::string& name)
    : m_name(name)
  {
    if(m_name.empty())
      return;
    std::error_code failure;
    const std::filesystem::file_status status = std::filesystem::status(m_name, failure); // of what a link leads to
    const bool exists = std::filesystem::exists(status);
    m_is_direct = m_name.rfind("/dev/", 0) == 0 || (exists && !std::filesystem::is_regular_file(status));
    m_place = exists && !m_is_direct ? std::filesystem::canonical(m_name, failure) : std::filesystem::path(m_name);
    const bool may_be_written = !exists || m_is_direct || std::ofstream(m_place, std::ios::app).is_open();
    m_out.open(m_is_direct ? m_name : part(), std::ios::binary);
    m_out.precision(std::numeric_limits<double>::max_digits10);
    if(!m_out || !may_be_written)
      throw Bad_input(printable(m_name) + ": cannot be written; choose another place");
  }
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;
  ~Output_file()
  {
    if(!is_wanted() || m_is_direct || m_is_finished)
      return;
    m_out.close();
    std::error_code ignored;
    std::filesystem::remove(part(), ignored);
  }

  bool is_wanted() const { return !m_name.empty(); }
  std::ostream& stream() { return m_out; }
  const std::string& name() const { return m_name; }

  void close()
  {
    if(!is_wanted() || m_is_finished)
      return;
    m_out.close();
    std::error_code failure;
    if(m_out && !m_is_direct)
      std::filesystem::rename(part(), m_place, failure);
    if(!m_out || failure)
      throw Bad_input(printable(m_name) + ": could not be written to its end; look for space on the disk");
    m_is_finished = true;
  }

private:
  std::string part() const { return m_place.string() + ".part"; }

  std::string m_name;
  std::filesystem::path m_place;
  std::ofstream m_out;
  bool m_is_direct = false, m_is_finished = false;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_OUTPUT_FILE_H
