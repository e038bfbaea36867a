// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_VTP_FILE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_VTP_FILE_H

#include "scene.h"

#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace program {

/// Writes VTK's format for surfaces, as text: the lines of the curves and the faces, with the cell array `curve`.
class Vtp_writer
{
public:
  explicit Vtp_writer(const Mesh& mesh, std::vector<Scene_polyline> curves = {})
    : m_mesh(mesh)
    , m_curves(std::move(curves))
  {
    for(const Scene_polyline& curve : m_curves)
      m_number_of_points += curve.points.size();
  }

  void write(std::ostream& out) const
  {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        << "<PolyData>\n<Piece NumberOfPoints=\"" << m_mesh.number_of_vertices() + m_number_of_points
        << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << m_curves.size() << "\" NumberOfStrips=\"0\" NumberOfPolys=\""
        << m_mesh.number_of_faces() << "\">\n<Points>\n"
        << "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    const auto write_point = [&](const Point_3& p) { out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n'; };
    for(const auto v : m_mesh.vertices())
      write_point(m_mesh.point(v));
    for(const Scene_polyline& curve : m_curves)
      for(const Point_3& p : curve.points)
        write_point(p);
    out << "</DataArray>\n</Points>\n";
    write_curve_numbers(out);
    write_lines(out);
    write_faces(out);
    out << "</Piece>\n</PolyData>\n</VTKFile>\n";
  }

private:
  static void begin_array(std::ostream& out, const char* name)
  {
    out << "<DataArray type=\"Int64\" Name=\"" << name << "\" format=\"ascii\">\n";
  }

  // Cells are counted lines first; faces belong to curve -1.
  void write_curve_numbers(std::ostream& out) const
  {
    out << "<CellData Scalars=\"curve\">\n";
    begin_array(out, "curve");
    for(const Scene_polyline& curve : m_curves)
      out << curve.curve << '\n';
    for(std::size_t f = 0; f < m_mesh.number_of_faces(); ++f)
      out << "-1\n";
    out << "</DataArray>\n</CellData>\n";
  }

  void write_lines(std::ostream& out) const
  {
    out << "<Lines>\n";
    begin_array(out, "connectivity");
    for(std::size_t i = 0; i < m_number_of_points; ++i)
      out << m_mesh.number_of_vertices() + i << '\n';
    out << "</DataArray>\n";
    begin_array(out, "offsets");
    std::size_t end = 0;
    for(const Scene_polyline& curve : m_curves)
      out << (end += curve.points.size()) << '\n';
    out << "</DataArray>\n</Lines>\n";
  }

  void write_faces(std::ostream& out) const
  {
    out << "<Polys>\n";
    begin_array(out, "connectivity");
    for(const auto f : m_mesh.faces()) {
      for(const auto v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
        out << static_cast<std::size_t>(v) << ' ';
      out << '\n';
    }
    out << "</DataArray>\n";
    begin_array(out, "offsets");
    for(std::size_t f = 1; f <= m_mesh.number_of_faces(); ++f)
      out << 3 * f << '\n';
    out << "</DataArray>\n</Polys>\n";
  }

  const Mesh& m_mesh;
  std::vector<Scene_polyline> m_curves;
  std::size_t m_number_of_points = 0;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_VTP_FILE_H
