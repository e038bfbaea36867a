// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_FILES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_FILES_H

#include "file_name.h"
#include "output/gltf_file.h"
#include "output/output_file.h"
#include "output/vtp_file.h"
#include "scene.h"

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

// The surface and the curves in one file for a viewer: first the surface's vertices, then the curves' points.
namespace program {

/// The curves as polylines in space, in the order of the results; those without points are left out.
class Viewer_file
{
public:
  /// The format follows from the extension, see `write()`. An empty name means that nothing is to be written.
  explicit Viewer_file(const std::string& name)
    : m_format(check_format(name))
    , m_file(name)
  {
  }

  bool is_wanted() const { return m_file.is_wanted(); }

  void write(const Mesh& mesh, const Scene& scene)
  {
    if(!is_wanted())
      return;
    for(const Scene_curve& curve : scene.curves)
      if(!curve.points.empty())
        add(curve);
    if(m_format == "obj")
      write_obj(mesh);
    else if(m_format == "ply")
      write_ply(mesh);
    else if(m_format == "vtp")
      Vtp_writer(mesh, m_curves).write(out());
    else if(m_format == "glb")
      Gltf_writer(mesh, scene).write(out());
    else
      write_polylines();
    m_file.close();
  }

private:
  static std::string check_format(const std::string& name)
  {
    const std::string polylines = ".polylines.txt";
    if(name.size() > polylines.size() && name.compare(name.size() - polylines.size(), polylines.size(), polylines) == 0)
      return "polylines";
    const std::vector<std::string> known = {"obj", "ply", "vtp", "glb"};
    if(!name.empty() && std::find(known.begin(), known.end(), extension(name)) == known.end())
      throw Bad_input(printable(name) + ": the extension of --mesh tells the format; use .obj, .ply, .vtp, .glb or "
                             ".polylines.txt");
    return extension(name);
  }

  void add(const Scene_curve& curve)
  {
    m_curves.push_back({curve.number, curve.points});
    m_number_of_points += curve.points.size();
  }

  std::ostream& out() { return m_file.stream(); }

  void write_points(const Mesh& mesh, const char* prefix)
  {
    const auto write = [&](const Point_3& p) { out() << prefix << p.x() << ' ' << p.y() << ' ' << p.z() << '\n'; };
    for(const auto v : mesh.vertices())
      write(mesh.point(v));
    for(const Scene_polyline& curve : m_curves)
      std::for_each(curve.points.begin(), curve.points.end(), write);
  }

  // One line per face, with `prefix` in front of it and `first` the number of the first vertex.
  void write_faces(const Mesh& mesh, const char* prefix, std::size_t first)
  {
    for(const auto f : mesh.faces()) {
      out() << prefix;
      for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        out() << ' ' << v + first;
      out() << '\n';
    }
  }

  void write_obj(const Mesh& mesh)
  {
    write_points(mesh, "v ");
    out() << "o surface\n";
    write_faces(mesh, "f", 1);
    std::size_t next = mesh.number_of_vertices() + 1;
    for(const Scene_polyline& curve : m_curves) {
      out() << "o curve_" << curve.curve << "\nl";
      for(std::size_t i = 0; i < curve.points.size(); ++i)
        out() << ' ' << next++;
      out() << '\n';
    }
  }

  void write_ply(const Mesh& mesh)
  {
    out() << "ply\nformat ascii 1.0\nelement vertex " << mesh.number_of_vertices() + m_number_of_points
          << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.number_of_faces()
          << "\nproperty list uchar int vertex_indices\nelement edge " << m_number_of_points - m_curves.size()
          << "\nproperty int vertex1\nproperty int vertex2\nproperty int curve\nend_header\n";
    write_points(mesh, "");
    write_faces(mesh, "3", 0);
    std::size_t next = mesh.number_of_vertices();
    for(const Scene_polyline& curve : m_curves) {
      for(std::size_t i = 0; i + 1 < curve.points.size(); ++i)
        out() << next + i << ' ' << next + i + 1 << ' ' << curve.curve << '\n';
      next += curve.points.size();
    }
  }

  // The polylines alone, as CGAL's demo reads them: a line each, the number of points and the points.
  void write_polylines()
  {
    for(const Scene_polyline& curve : m_curves) {
      out() << curve.points.size();
      for(const Point_3& p : curve.points)
        out() << ' ' << p.x() << ' ' << p.y() << ' ' << p.z();
      out() << '\n';
    }
  }

  std::string m_format;
  Output_file m_file;
  std::vector<Scene_polyline> m_curves;
  std::size_t m_number_of_points = 0;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_VIEWER_FILES_H
