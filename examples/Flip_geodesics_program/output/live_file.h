// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_LIVE_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_LIVE_FILE_H

#include "live_template.h"
#include "output/json_text.h"
#include "output/output_file.h"
#include "program_mesh.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <ostream>
#include <sstream>
#include <string>
#include <string_view>

namespace program {

/*!
 * Writes one page for a browser that computes curves on a mesh: its engine, the program as WebAssembly, is in the page.
 *
 * The page is a fixed one (folder page/), in which a JSON object with the bytes of a mesh file takes the place of a
 * mark.
 */
class Live_file
{
public:
  /// With an empty name, nothing is written.
  explicit Live_file(const std::string& name)
    : m_file(name)
  {
  }

  /// \param title what the mesh is called
  void write(const Mesh& mesh, const std::string& title)
  {
    if(!m_file.is_wanted())
      return;
    for(std::string_view piece : live_template) {
      if(piece == "@SCENE@")
        write_mesh(m_file.stream(), mesh, title);
      else
        m_file.stream() << piece;
    }
    m_file.close();
  }

private:
  static void write_mesh(std::ostream& out, const Mesh& mesh, const std::string& title)
  {
    std::ostringstream bytes;
    CGAL::IO::set_binary_mode(bytes); // all bits of the points
    CGAL::IO::write_PLY(bytes, mesh);
    out << "{\"name\":" << json_string(title) << ",\"format\":\"ply\",\"mesh\":" << json_base64(bytes.str()) << '}';
  }

  Output_file m_file;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_LIVE_FILE_H
