// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PAGE_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PAGE_FILE_H

#include "output/output_file.h"

#include <string>
#include <string_view>

namespace program {

/*!
 * Writes one page for a browser, with everything in it: no other file and no network is needed. The page is a fixed one
 * (folder page/), in which a JSON object takes the place of a mark.
 */
class Page_file
{
public:
  /// With an empty name, nothing is written.
  explicit Page_file(const std::string& name)
    : m_file(name)
  {
  }

  bool is_wanted() const { return m_file.is_wanted(); }

  /// \param page the pieces of the page \param write_object writes the object to a stream
  template <class Page, class Write>
  void write(const Page& page, const Write& write_object)
  {
    if(!is_wanted())
      return;
    for(std::string_view piece : page) {
      if(piece == "@SCENE@")
        write_object(m_file.stream());
      else
        m_file.stream() << piece;
    }
    m_file.close();
  }

private:
  Output_file m_file;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PAGE_FILE_H
