// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_MESH_RESULTS_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_MESH_RESULTS_H

#include "mesh_input.h"

#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// What becomes of the triangulation once its curves are finished: flips, refinement, and meshes with the curves.
namespace program {

struct Mesh_result_options
{
  bool is_delaunay = false;
  std::optional<double> refine; ///< the smallest angle, in degrees
  std::string subdivision, insertion, cut;

  bool is_any_wanted() const { return is_delaunay || refine || has_files(); }
  bool has_files() const { return !subdivision.empty() || !insertion.empty() || !cut.empty(); }
};

inline void check_mesh_results(const Mesh_result_options& options)
{
  if(options.refine && !(*options.refine >= 0 && *options.refine <= 30))
    throw Bad_input("--refine takes the smallest angle, in degrees, between 0 and 30");
  const std::vector<std::string> known = {"off", "obj", "ply", "stl", "vtp"};
  for(const std::string& name : {options.subdivision, options.insertion, options.cut})
    if(!name.empty() && std::find(known.begin(), known.end(), extension(name)) == known.end())
      throw Bad_input(name + ": the extension tells the format of the mesh; use .off, .obj, .ply, .stl or .vtp");
}

inline void write_mesh_result(const std::string& name, const Mesh& mesh)
{
  bool is_written = false;
  {
    const Captured_output captured;
    is_written = CGAL::IO::write_polygon_mesh(name, mesh, CGAL::parameters::stream_precision(17));
  }
  if(!is_written)
    throw Bad_input(name + ": cannot be written; choose another place");
}

/// Does what is wanted to the triangulation of a network whose curves are finished. Returns lines for people.
template <class Network>
std::string make_mesh_results(const Mesh_result_options& options, const Mesh& mesh, Network& network)
{
  namespace FG = CGAL::Flip_geodesics;
  std::ostringstream text;
  auto& triangulation = network.triangulation();
  if(options.is_delaunay) {
    const FG::Delaunay_report report = FG::flip_to_delaunay(triangulation);
    text << "delaunay " << report.flips << " flips, " << report.constrained << " edges held by curves\n";
  }
  if(options.refine) {
    FG::Refinement_options bounds;
    bounds.smallest_angle = *options.refine;
    const FG::Refinement_report report = FG::refine(network, bounds);
    text << "refined  " << report.insertions << " vertices inserted, " << report.splits
         << " edges split; smallest angle " << report.smallest_angle << " degrees, " << report.smallest_free_angle
         << " without " << report.exempt << " exempt faces; " << report.missed << " missed\n";
  }
  if(!options.subdivision.empty())
    write_mesh_result(options.subdivision, FG::common_subdivision(triangulation, mesh).mesh());
  if(!options.insertion.empty())
    write_mesh_result(options.insertion, FG::insert_curves(network, mesh).mesh());
  if(!options.cut.empty())
    write_mesh_result(options.cut, FG::cut_along_curves(network, mesh).mesh());
  return text.str();
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_MESH_RESULTS_H
