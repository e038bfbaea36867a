// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_MESH_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_MESH_FILE_H

#include "output/output_file.h"
#include "program_mesh.h"

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <limits>
#include <ostream>
#include <streambuf>
#include <string>

namespace program {

/// While it lives, nothing that CGAL's writers say reaches standard error.
class Silent_errors
{
public:
  Silent_errors()
    : m_buffer(std::cerr.rdbuf(nullptr))
  {
  }
  Silent_errors(const Silent_errors&) = delete;
  Silent_errors& operator=(const Silent_errors&) = delete;
  ~Silent_errors() { std::cerr.rdbuf(m_buffer); }

private:
  std::streambuf* m_buffer;
};

/// A mesh without curves, in one of the formats off, obj, ply, stl and vtp.
class Mesh_file
{
public:
  /// With an empty name, nothing is written.
  Mesh_file(const std::string& name, const std::string& format)
    : m_format(format)
    , m_file(name)
  {
  }

  bool is_wanted() const { return m_file.is_wanted(); }

  void write(const Mesh& mesh)
  {
    const Silent_errors silent; // what goes wrong is seen by the state of the file
    m_file.write([&](std::ostream& out) { write(out, mesh); });
  }

  /// Writes a mesh with its texture coordinates, in the format obj or glb.
  void write_textured(Mesh mesh)
  {
    namespace IO = CGAL::Flip_geodesics::IO;
    const IO::Texture texture(texture_of(mesh));
    m_file.write([&](std::ostream& out) {
      m_format == "glb" ? IO::write_GLB(out, mesh, texture) : IO::write_OBJ(out, mesh, texture);
    });
  }

  void close() { m_file.close(); }

private:
  void write(std::ostream& out, const Mesh& mesh) const
  {
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
      CGAL::Flip_geodesics::IO::write_VTP(out, mesh, CGAL::parameters::use_binary_mode(false));
  }

  std::string m_format;
  Output_file m_file;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_MESH_FILE_H
