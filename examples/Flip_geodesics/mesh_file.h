// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_MESH_FILE_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_MESH_FILE_H

#include "mesh_input.h"
#include "output_file.h"
#include "program_options.h"
#include "vtp_file.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace program {

/// A mesh without curves; the format follows from the extension, one of .off, .obj, .ply, .stl and .vtp.
class Mesh_file
{
public:
  /// An empty name means that nothing is to be written.
  explicit Mesh_file(const std::string& name)
    : m_format(extension(name))
    , m_file(name)
  {
  }

  bool is_wanted() const { return m_file.is_wanted(); }

  void write(const Mesh& mesh)
  {
    const Captured_output captured;
    std::ostream& out = m_file.stream();
    const auto digits = CGAL::parameters::stream_precision(std::numeric_limits<double>::max_digits10);
    if(m_format == "off")
      CGAL::IO::write_OFF(out, mesh, digits);
    else if(m_format == "obj")
      CGAL::IO::write_OBJ(out, mesh, digits);
    else if(m_format == "ply")
      CGAL::IO::write_PLY(out, mesh, digits);
    else if(m_format == "stl")
      CGAL::IO::write_STL(out, mesh, digits);
    else
      Vtp_writer(mesh).write(out);
  }

  void close() { m_file.close(); }

private:
  std::string m_format;
  Output_file m_file;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_MESH_FILE_H
