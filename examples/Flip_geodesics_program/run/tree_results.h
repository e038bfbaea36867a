// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_TREE_RESULTS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_TREE_RESULTS_H

#include "program_mesh.h"
#include "readable.h"

#include <CGAL/Flip_geodesics/geodesic_distances.h>

#include <cstddef>
#include <sstream>
#include <string>

namespace program {

/// Where the paths of a tree lead, in lines for people.
template <class Tree>
std::string describe_tree(const Tree& tree, std::size_t flips)
{
  Vertex_index farthest = tree.source();
  std::size_t number_of_paths = 0;
  for(Vertex_index v(0); v.idx() < tree.triangulation().input().number_of_vertices(); ++v) {
    if(v == tree.source() || !tree.is_reached(v))
      continue;
    ++number_of_paths;
    if(tree.distance(v) > tree.distance(farthest))
      farthest = v;
  }
  std::ostringstream out;
  const bool is_inserted = tree.triangulation().is_inserted(tree.source());
  out << "paths    " << readable(number_of_paths) << " from "
      << (is_inserted ? "the source" : "vertex " + std::to_string(tree.source().idx())) << ", the longest to vertex "
      << farthest.idx() << ", " << tree.distance(farthest) << " long\nflips    " << readable(flips) << '\n';
  return out.str();
}

/// What was done to make the paths of a tree shortest, in a line for people.
inline std::string describe_shortest_paths(const CGAL::Flip_geodesics::Distances_report& report)
{
  if(!report.is_confirmed())
    return "shortest not confirmed: the search for shorter paths was aborted or encountered degenerate faces\n";
  std::ostringstream out;
  out << "shortest " << readable(report.vertices - report.longer) << " of them, confirmed; "
      << readable(report.longer_before) << " were longer at first, by up to " << 100 * report.largest_excess_before
      << " %\n";
  return out.str();
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_TREE_RESULTS_H
