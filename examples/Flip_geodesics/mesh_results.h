// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_MESH_RESULTS_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_MESH_RESULTS_H

#include "mesh_input.h"
#include "output_file.h"
#include "vtp_file.h"

#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// What becomes of the triangulation once its curves are finished: flips, refinement, and meshes with the curves.
namespace program {

struct Mesh_result_options
{
  bool is_delaunay = false;
  std::optional<double> refine; ///< the smallest angle, in degrees
  std::optional<double> longest_edge;
  std::optional<long long> most_vertices; ///< that are inserted
  std::string subdivision, insertion, cut;

  bool is_any_wanted() const { return is_delaunay || refine || has_files(); }
  bool has_files() const { return !subdivision.empty() || !insertion.empty() || !cut.empty(); }
};

inline void check_mesh_results(const Mesh_result_options& options)
{
  if(options.refine && !(*options.refine >= 0 && *options.refine <= 30))
    throw Bad_input("--refine takes the smallest angle, in degrees, between 0 and 30");
  if((options.longest_edge || options.most_vertices) && !options.refine)
    throw Bad_input("--longest-edge and --most-vertices belong to --refine; give an angle, 0 for any");
  if(options.longest_edge && !(*options.longest_edge > 0))
    throw Bad_input("--longest-edge must be greater than 0");
  if(options.most_vertices && *options.most_vertices < 0)
    throw Bad_input("--most-vertices must not be negative");
  const std::vector<std::string> known = {"off", "obj", "ply", "stl", "vtp"};
  for(const std::string& name : {options.subdivision, options.insertion, options.cut})
    if(!name.empty() && std::find(known.begin(), known.end(), extension(name)) == known.end())
      throw Bad_input(name + ": the extension tells the format of the mesh; use .off, .obj, .ply, .stl or .vtp");
}

/// Flips and refines the triangulation of a network whose curves are finished. Returns lines for people.
template <class Network>
std::string improve_triangulation(const Mesh_result_options& options, Network& network)
{
  namespace FG = CGAL::Flip_geodesics;
  std::ostringstream text;
  if(options.is_delaunay) {
    const FG::Delaunay_report report = FG::flip_to_delaunay(network.triangulation());
    text << "delaunay " << report.flips << " flips, " << report.constrained << " edges held by curves\n";
  }
  if(options.refine) {
    FG::Refinement_options bounds;
    bounds.smallest_angle = *options.refine;
    bounds.longest_edge = options.longest_edge.value_or(bounds.longest_edge);
    if(options.most_vertices)
      bounds.maximum_insertions = static_cast<std::size_t>(*options.most_vertices);
    const FG::Refinement_report report = FG::refine(network, bounds);
    text << "refined  " << report.insertions << " vertices inserted, " << report.splits
         << " edges split; smallest angle " << report.smallest_angle << " degrees, " << report.smallest_free_angle
         << " without " << report.exempt << " exempt faces; " << report.missed << " missed\n";
  }
  return text.str();
}

/// A mesh without curves; the format follows from the extension, as `check_mesh_results()` knows them.
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

/// The meshes that have the edges of a triangulation, or its curves.
class Mesh_files
{
public:
  explicit Mesh_files(const Mesh_result_options& options)
    : m_subdivision(options.subdivision)
    , m_insertion(options.insertion)
    , m_cut(options.cut)
  {
  }

  template <class Network>
  void write(const Mesh& mesh, const Network& network)
  {
    namespace FG = CGAL::Flip_geodesics;
    if(m_subdivision.is_wanted())
      m_subdivision.write(FG::common_subdivision(network.triangulation(), mesh).mesh());
    if(m_insertion.is_wanted())
      m_insertion.write(FG::insert_curves(network, mesh).mesh());
    if(m_cut.is_wanted())
      m_cut.write(FG::cut_along_curves(network, mesh).mesh());
  }

  void close()
  {
    m_subdivision.close();
    m_insertion.close();
    m_cut.close();
  }

private:
  Mesh_file m_subdivision, m_insertion, m_cut;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_MESH_RESULTS_H
